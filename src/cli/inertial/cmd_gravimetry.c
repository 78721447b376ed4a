// SPDX-License-Identifier: GPL-3.0-or-later
// orrery gravimetry: the gravity disturbance back from readings and trajectory.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "inertial/gravimetry/gravimetry.h"
#include "inertial/readings/imu_file.h"
#include "ingest/telemetry/telemetry.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

static orr_status write_csv(const char *path, const orr_gravimetry_result *r, const orr_gravimetry *t,
                            orr_diag *diag)
{
    orr_outfile f;
    orr_status s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    fprintf(f.stream, "t_s,recovered_mgal,true_mgal,recovered_filtered_mgal,true_filtered_mgal,eotvos_mgal,"
                      "vertical_mps2\n");
    for (size_t k = 0; k < r->n; k++)
        fprintf(f.stream, "%.6f,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", r->t_s[k], r->recovered_mgal[k],
                r->true_mgal[k], r->recovered_filtered_mgal[k], r->true_filtered_mgal[k],
                0.5 * (t->eotvos_mgal[r->first + k] + t->eotvos_mgal[r->first + k + 1]),
                0.5 * (t->vertical_mps2[r->first + k] + t->vertical_mps2[r->first + k + 1]));
    return orr_outfile_commit(&f, diag);
}

// A receiver's track as times after `t0` and places; the arrays are to be freed.
static orr_status read_track(const orr_cli *c, orr_time t0, orr_gravimetry_track *out, orr_warnings *warnings,
                             orr_diag *diag)
{
    orr_telemetry log;
    const char *path = orr_cli_text(c, "track", NULL);
    orr_status s = orr_telemetry_read(path, orr_cli_text(c, "columns", NULL), c->leap, &log, warnings, diag);
    if (s != ORR_OK) return s;
    double *t_s = malloc((log.n_position + 1) * sizeof *t_s);
    orr_vec3 *r_m = malloc((log.n_position + 1) * sizeof *r_m);
    out->t_s = t_s;
    out->r_m = r_m;
    if (t_s == NULL || r_m == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a track");
    else if (!log.absolute)
        s = orr_diag_at(diag, ORR_E_NODATA, path, 0, 0,
                        "its times are no instants (a column t[gps] or week and tow)");
    for (size_t k = 0; s == ORR_OK && k < log.n_position; k++) {
        t_s[k] = orr_time_diff_s(log.t0, t0) + log.position_t_s[k];
        r_m[k] = orr_earth_to_ecef(log.position[k]);
        if (k > 0 && !(t_s[k] > t_s[k - 1]))
            s = orr_diag_at(diag, ORR_E_FORMAT, path, log.position_line[k], 0,
                            "its time is not after that of the place before");
    }
    out->n = log.n_position;
    orr_telemetry_free(&log);
    return s;
}

// RIGHT,FORWARD,UP in metres.
static bool parse_arm(const char *text, orr_vec3 *out)
{
    double v[3];
    if (orr_cli_numbers(text, v, 3) != 3) return false;
    *out = (orr_vec3){v[0], v[1], v[2]};
    return fabs(v[0]) <= 1000 && fabs(v[1]) <= 1000 && fabs(v[2]) <= 1000;
}

static orr_gravity_filter filter_of(const orr_cli *c)
{
    orr_gravity_filter f = {.kind = ORR_GRAVITY_GAUSSIAN, .model_mgal = 20, .place_m = 0.02};
    double usual_s = 10;
    if (orr_cli_says(c, "filter-kind", "fir")) f.kind = ORR_GRAVITY_FIR, usual_s = 100;
    if (orr_cli_says(c, "filter-kind", "kalman")) f.kind = ORR_GRAVITY_KALMAN, usual_s = 60;
    f.length_s = (double)orr_cli_duration_ns(c, "filter", (int64_t)(usual_s * ORR_NS_PER_S)) * 1e-9;
    f.model_mgal = orr_cli_real(c, "model", f.model_mgal);
    f.place_m = orr_cli_real(c, "height-sigma", f.place_m);
    return f;
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_imu_file f;
    const bool measured = orr_cli_says(c, "of", "measured");
    int status = ORR_EXIT_OK;
    const char *path = orr_cli_text(c, "csv", NULL);
    const bool csv_only = path != NULL && strcmp(path, "-") == 0, json = orr_cli_says(c, "format", "json");
    if (csv_only && json)
        return orr_cli_usage(c, "only one of --csv - and --format json can go to standard output");
    orr_gravimetry_result r;
    orr_status s = orr_imu_read(c->operand[0], orr_cli_text(c, "gravity-folder", NULL), &f, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (f.gravimetry.n == 0) {
        orr_imu_file_free(&f);
        return orr_cli_failf(c, "%s holds no true gravity to compare with", c->operand[0]);
    }
    const orr_gravity_filter filter = filter_of(c);
    if (measured && f.imu.measured_dtheta_rad == NULL) {
        orr_imu_file_free(&f);
        return orr_cli_failf(c, "%s has no readings with errors ('orrery imu --errors' makes them)",
                             c->operand[0]);
    }
    if (measured) orr_imu_swap_measured(&f.imu);
    orr_gravimetry_track track = {.n = 0};
    const bool tracked = orr_cli_given(c, "track");
    if (!parse_arm(orr_cli_text(c, "arm", "0,0,0"), &track.arm_m)) {
        orr_imu_file_free(&f);
        return orr_cli_usage(c, "--arm \"%s\" is no RIGHT,FORWARD,UP in metres", orr_cli_text(c, "arm", ""));
    }
    if (tracked) {
        orr_warnings warnings = {0};
        s = read_track(c, f.imu.t0, &track, &warnings, &diag);
        orr_cli_warnings(c, &warnings);
        orr_warnings_free(&warnings);
    }
    r = (orr_gravimetry_result){.n = 0};
    if (s == ORR_OK)
        s = orr_gravimetry_recover(&f.imu, &f.gravimetry, tracked ? &track : NULL, &filter, &r, &diag);
    free((void *)(uintptr_t)track.t_s);
    free((void *)(uintptr_t)track.r_m);
    if (s == ORR_OK) {
        if (path != NULL) s = write_csv(path, &r, &f.gravimetry, &diag);
        double low = r.true_mgal[0], high = low;
        for (size_t k = 0; k < r.n; k++) {
            low = r.true_mgal[k] < low ? r.true_mgal[k] : low;
            high = r.true_mgal[k] > high ? r.true_mgal[k] : high;
        }
        if (s == ORR_OK && json) {
            json_t *j = json_pack(
                "{s:o, s:o, s:{s:o, s:o}, s:{s:o, s:o, s:o, s:o, s:o}, s:o}", "duration_s",
                orr_json_number(r.t_s[r.n - 1] - r.t_s[0]), "filter_s", orr_json_number(filter.length_s),
                "true", "min_mgal", orr_json_number(low), "max_mgal", orr_json_number(high), "difference",
                "raw_rms_mgal", orr_json_number(r.raw_rms_mgal), "filtered_rms_mgal",
                orr_json_number(r.filtered_rms_mgal), "filtered_max_mgal",
                orr_json_number(r.filtered_max_mgal), "edge_s", orr_json_number(r.edge_s), "edge_rms_mgal",
                orr_json_number(r.edge_rms_mgal), "values", orr_json_count(r.n));
            status = orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
        } else if (s == ORR_OK && !csv_only) {
            printf("true disturbance      %.3f to %.3f mGal\n", low, high);
            printf("recovered, unfiltered %.3g mGal r.m.s. off\n", r.raw_rms_mgal);
            printf("after %s %g s   %.3g mGal r.m.s. off, %.3g mGal at most\n",
                   orr_cli_text(c, "filter-kind", "Gaussian"), filter.length_s, r.filtered_rms_mgal,
                   r.filtered_max_mgal);
            printf("its ends, %g s each   %.3g mGal r.m.s. off\n", r.edge_s, r.edge_rms_mgal);
        }
        orr_gravimetry_result_free(&r);
    }
    orr_imu_file_free(&f);
    return s == ORR_OK ? status : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "filter",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Standard deviation of the Gaussian (10 s by default), period that the FIR passes half of (100 "
             "s), or "
             "correlation time of gravity in the smoother's model (60 s)."},
    {.name = "filter-kind",
     .kind = ORR_OPT_CHOICE,
     .value = "gaussian|fir|kalman",
     .fallback = "gaussian",
     .help = "Gaussian (default), finite impulse response, or Kalman smoother with a model of gravity."},
    {.name = "model",
     .kind = ORR_OPT_REAL,
     .value = "MGAL",
     .applies = "filter-kind=kalman",
     .min = 1e-3,
     .max = 1e4,
     .help = "Standard deviation of gravity along the line in the model. Default 20 mGal."},
    {.name = "height-sigma",
     .kind = ORR_OPT_REAL,
     .value = "M",
     .applies = "filter-kind=kalman",
     .min = 1e-6,
     .max = 100,
     .help = "Standard deviation of heights a sample. Default 0.02 m."},
    {.name = "of",
     .kind = ORR_OPT_CHOICE,
     .value = "ideal|measured",
     .fallback = "ideal",
     .help = "Ideal readings (default), or those with the errors of sensors."},
    {.name = "track",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Places of a receiver's antenna (a table as of `orrery track`) in place of the true motion; "
             "attitude then comes "
             "from the readings alone."},
    {.name = "columns",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .applies = "track",
     .help = "Columns of the track, e.g. \"t[gps],x,y,z\"."},
    {.name = "arm",
     .kind = ORR_OPT_TEXT,
     .value = "R,F,U",
     .applies = "track",
     .help = "The antenna from the unit: right, forward, up, m; none by default."},
    {.writes = true,
     .name = "csv",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The series; - for standard output, instead of the table."},
    {.name = "gravity-folder",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Where a gravity model's files are now."},
    ORR_OPTION_REPORT,
};

const orr_command orr_cmd_gravimetry = {
    .name = "gravimetry",
    .group = "Inertial",
    .summary = "recover the gravity disturbance from readings and trajectory",
    .operands = "IMU",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Takes the known motion (Eotvoes term and vertical acceleration included) and normal gravity "
             "off the measured force; what "
             "is left is the gravity disturbance. It is compared with the true one after a Gaussian filter "
             "on both.",
    .example = "orrery imu samples/survey.yaml -o imu.nc\norrery gravimetry imu.nc --csv gravity.csv\n"
               "orrery gravimetry flight/imu-0.nc --track rtk.csv --arm 0.2,1.5,1.1 --filter 27",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

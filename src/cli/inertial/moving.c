// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/inertial/moving.h"

#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "src/make/readings.h"

// The scenario that the options --telemetry and --columns stand for.
static int scenario_of_logs(orr_cli *c, orr_scenario *out)
{
    const char *file[ORR_TRAJECTORY_MAX_LOGS] = {0}, *columns[ORR_TRAJECTORY_MAX_LOGS] = {0};
    orr_diag diag = {0};
    size_t n = orr_cli_count(c, "telemetry"), n_columns = orr_cli_count(c, "columns");
    if (n_columns > n) return orr_cli_usage(c, "%zu lists of columns for %zu logs", n_columns, n);
    for (size_t k = 0; k < n && k < ORR_TRAJECTORY_MAX_LOGS; k++) {
        file[k] = orr_cli_text_at(c, "telemetry", k);
        if (k < n_columns) columns[k] = orr_cli_text_at(c, "columns", k);
    }
    return orr_scenario_of_telemetry(file, columns, n, c->leap, out, &diag) == ORR_OK
               ? ORR_EXIT_OK
               : orr_cli_fail(c, &diag);
}

// Options of a log alone, and whether one of them was given.
static const char *log_option(const orr_cli *c)
{
    static const char *const names[] = {"columns", "degree", "per-knot", "attitude-per-knot", "report"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
        if (orr_cli_given(c, names[k])) return names[k];
    return NULL;
}

orr_imu_axes orr_cli_axes(const orr_cli *c)
{
    return strcmp(orr_cli_text(c, "axes", "rfu"), "frd") == 0 ? ORR_AXES_FRD : ORR_AXES_RFU;
}

static int apply_options(orr_cli *c, orr_scenario_trajectory *m)
{
    const char *of_log = log_option(c);
    if (of_log != NULL && m->kind != ORR_MOTION_TELEMETRY)
        return orr_cli_usage(c, "--%s belongs to a log, and the scenario's trajectory is none", of_log);
    if (orr_cli_given(c, "start")) m->has_start = true;
    m->start = orr_cli_time(c, "start", m->start);
    m->duration_ns = orr_cli_duration_ns(c, "duration", m->duration_ns);
    if (orr_cli_given(c, "degree"))
        m->fit.degree = *orr_cli_text(c, "degree", "3") == '5' ? ORR_FIT_QUINTIC : ORR_FIT_CUBIC;
    m->fit.position_per_knot = orr_cli_real(c, "per-knot", m->fit.position_per_knot);
    m->fit.attitude_per_knot = orr_cli_real(c, "attitude-per-knot", m->fit.attitude_per_knot);
    const char *to = orr_cli_text(c, "transfer", NULL);
    if (to == NULL) return ORR_EXIT_OK;
    double v[3] = {0, 0, 0};
    char *end = NULL;
    const char *p = to;
    int k = 0;
    for (; k < 3; k++) {
        v[k] = strtod(p, &end);
        if (end == p) break;
        p = end;
        if (*p != ',') {
            k++;
            break;
        }
        p++;
    }
    if (k < 2 || *p != '\0' || !(v[0] >= -90.0 && v[0] <= 90.0) || !(v[1] >= -360.0 && v[1] <= 360.0) ||
        !(v[2] >= -360.0 && v[2] <= 360.0))
        return orr_cli_usage(c, "--transfer '%s' is not LATITUDE,LONGITUDE[,AZIMUTH] in degrees", to);
    m->has_transfer = true;
    bool literal = strcmp(orr_cli_text(c, "transfer-attitude", "level"), "literal") == 0;
    m->transfer =
        (orr_scenario_transfer){v[0], v[1], v[2], literal ? ORR_TRANSFER_LITERAL : ORR_TRANSFER_LEVEL};
    return ORR_EXIT_OK;
}

static void say_clocks(orr_cli *c, const orr_moving *v)
{
    char zero[ORR_TIME_TEXT];
    if (v->tie.n == 0) return;
    orr_cli_say(c,
                "clocks: 0 s of the log's own is %s GPS, drift %.3g ppm, scatter %.3g s (%zu rows tell "
                "both); places have GPS time",
                orr_time_format(orr_time_add_s(v->tie_zero, v->tie.offset_s), ORR_SCALE_GPS, 6, NULL, zero),
                1e6 * v->tie.drift, v->tie.scatter_s, v->tie.n);
}

static void say_fit(orr_cli *c, const orr_fit_report *r)
{
    orr_cli_say(c,
                "places: %zu of %zu rows used (every %.3g s, knots every %.3g s), residual %.3f m r.m.s., "
                "%.3f m at most",
                r->positions_used, r->positions, r->position_interval_s, r->position_knot_s,
                r->residuals.position_rms_m, r->residuals.position_max_m);
    if (r->attitude_from_motion)
        orr_cli_say(c, "angles: none recorded; heading, pitch and roll follow from the motion");
    else
        orr_cli_say(c,
                    "angles: %zu of %zu rows used (every %.3g s, knots every %.3g s), residual %.3f deg "
                    "r.m.s., %.3f deg at most; "
                    "%zu wraps",
                    r->attitudes_used, r->attitudes, r->attitude_interval_s, r->attitude_knot_s,
                    r->residuals.attitude_rms_rad * ORR_DEG_PER_RAD,
                    r->residuals.attitude_max_rad * ORR_DEG_PER_RAD, r->wraps);
    for (int half = 0; half < 2; half++)
        for (int f = 0; f < ORR_FAULTS; f++)
            if (r->count[half][f] > 0)
                orr_cli_say(c, "left out: %zu rows of %s: %s", r->count[half][f],
                            half == 0 ? "places" : "angles", orr_fault_name((orr_fault)f));
    for (size_t k = 0; k < r->n_gaps && k < 10; k++)
        orr_cli_say(c, "gap of %s from %.3f s to %.3f s", r->gap[k].attitude ? "angles" : "places",
                    r->gap[k].from_s, r->gap[k].to_s);
    if (r->n_gaps > 10) orr_cli_say(c, "and %zu more gaps", r->n_gaps - 10);
    orr_cli_say(c, "trajectory: %.3f s to %.3f s of the log's clock", r->from_s, r->to_s);
}

static int write_report(orr_cli *c, const orr_fit_report *r, orr_diag *diag)
{
    const char *path = orr_cli_text(c, "report", NULL);
    if (path == NULL) return ORR_EXIT_OK;
    orr_outfile f;
    if (orr_outfile_open(path, &f, diag) != ORR_OK) return orr_cli_fail(c, diag);
    fprintf(f.stream, "line,t_s,of,fault\n");
    for (size_t k = 0; k < r->n_excluded; k++)
        fprintf(f.stream, "%lld,%.6f,%s,%s\n", (long long)r->excluded[k].row, r->excluded[k].t_s,
                r->excluded[k].attitude ? "angles" : "place", orr_fault_name(r->excluded[k].fault));
    return orr_outfile_commit(&f, diag) == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, diag);
}

int orr_cli_moving_open(orr_cli *c, orr_scenario *scenario, orr_inputs *inputs, orr_moving *moving)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    bool log = orr_cli_given(c, "telemetry");
    memset(moving, 0, sizeof *moving);
    memset(scenario, 0, sizeof *scenario);
    if (log == (c->n_operands == 1))
        return orr_cli_usage(c, log ? "a scenario or --telemetry, not both"
                                    : "name a scenario, or a log with --telemetry");
    orr_status s = ORR_OK;
    int status = ORR_EXIT_OK;
    if (log)
        status = scenario_of_logs(c, scenario);
    else if (orr_inputs_scenario(inputs, c->operand[0], c->leap, scenario, &diag) != ORR_OK)
        status = orr_cli_fail(c, &diag);
    if (status != ORR_EXIT_OK) return status;
    if (orr_cli_tree_check(c, orr_scenario_schema(), scenario, &diag) != ORR_OK)
        status = orr_cli_fail(c, &diag);
    if (status == ORR_EXIT_OK) status = apply_options(c, &scenario->motion.trajectory);
    if (status == ORR_EXIT_OK) {
        s = orr_moving_open(&scenario->motion, orr_moving_fallback_start(), c->leap, &warnings, moving,
                            &diag);
        orr_cli_warnings(c, &warnings);
        if (s != ORR_OK) status = orr_cli_fail(c, &diag);
    }
    if (status == ORR_EXIT_OK && moving->from_telemetry) {
        say_clocks(c, moving);
        say_fit(c, &moving->report);
        status = write_report(c, &moving->report, &diag);
        if (status != ORR_EXIT_OK) orr_moving_free(moving);
    }
    orr_warnings_free(&warnings);
    if (status != ORR_EXIT_OK) orr_scenario_free(scenario);
    return status;
}

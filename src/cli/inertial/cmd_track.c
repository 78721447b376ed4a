// SPDX-License-Identifier: GPL-3.0-or-later
// orrery track: the motion itself, as a table.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/outfile.h"
#include "src/cli/frame/options.h"
#include "src/cli/inertial/moving.h"

typedef struct track {
    const orr_trajectory *way;
    double rate_hz;
    bool frd;
    FILE *out;
} track;

// Milliseconds where they are all of it; a rounded time would move the body along its way.
static int decimals_of(const track *x)
{
    const double step_ms = 1000.0 / x->rate_hz, begin_ms = 1000.0 * x->way->begin_s;
    return fabs(step_ms - nearbyint(step_ms)) < 1e-9 * step_ms && fabs(begin_ms - nearbyint(begin_ms)) < 1e-6
               ? 3
               : 9;
}

static void put_csv(const track *x, double t, const orr_motion *m)
{
    char t_gps[ORR_TIME_TEXT];
    const orr_geodetic g = orr_earth_from_ecef(m->r_m);
    const orr_angles a = orr_motion_angles(m);
    orr_vec3 u = orr_motion_velocity_enu(m);
    if (x->frd) u = orr_axes_swapped(u); // North, East, Down
    fprintf(x->out, "%.*f,%.10f,%.10f,%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%s\n", decimals_of(x), t,
            g.lat_rad * ORR_DEG_PER_RAD, g.lon_rad * ORR_DEG_PER_RAD, g.height_m,
            orr_heading_shown_deg(a.heading_rad, 6), a.pitch_rad * ORR_DEG_PER_RAD,
            a.roll_rad * ORR_DEG_PER_RAD, u.x, u.y, u.z, orr_time_text(orr_time_add_s(x->way->t0, t), t_gps));
}

// gps-sdr-sim's user motion, -u: seconds and the place in the Earth's axes.
static void put_ecef(const track *x, double t, const orr_motion *m)
{
    fprintf(x->out, "%.1f,%.4f,%.4f,%.4f\n", t - x->way->begin_s, m->r_m.x, m->r_m.y, m->r_m.z);
}

// The same, -x: latitude, longitude, height.
static void put_llh(const track *x, double t, const orr_motion *m)
{
    const orr_geodetic g = orr_earth_from_ecef(m->r_m);
    fprintf(x->out, "%.1f,%.10f,%.10f,%.4f\n", t - x->way->begin_s, g.lat_rad * ORR_DEG_PER_RAD,
            g.lon_rad * ORR_DEG_PER_RAD, g.height_m);
}

// What a script pushes into Skydel (pushEcefNed, docs/inertial.md): milliseconds, place, yaw, pitch and roll against North,
// East, Down.
static void put_skydel(const track *x, double t, const orr_motion *m)
{
    const orr_angles a = orr_motion_angles(m);
    fprintf(x->out, "%.*f,%.4f,%.4f,%.4f,%.9f,%.9f,%.9f\n", decimals_of(x) - 3, (t - x->way->begin_s) * 1e3,
            m->r_m.x, m->r_m.y, m->r_m.z, a.heading_rad, a.pitch_rad, a.roll_rad);
}

static const struct {
    const char *name;
    double rate_hz; // by default; of gps-sdr-sim the only one that it reads
    void (*put)(const track *x, double t, const orr_motion *m);
} formats[] = {{"csv", 1, put_csv},
               {"gps-sdr-sim", 10, put_ecef},
               {"gps-sdr-sim-llh", 10, put_llh},
               {"skydel", 10, put_skydel}};

static void write_track(const track *x, size_t format)
{
    const double n = floor((x->way->end_s - x->way->begin_s) * x->rate_hz + 1e-6);
    if (formats[format].put == put_csv)
        fprintf(x->out, "t_s,lat_deg,lon_deg,height_m,heading_deg,pitch_deg,roll_deg,%s,t_gps\n",
                x->frd ? "v_north_mps,v_east_mps,v_down_mps" : "v_east_mps,v_north_mps,v_up_mps");
    if (formats[format].put == put_skydel)
        fputs("Time (ms),X (m),Y (m),Z (m),Yaw (rad),Pitch (rad),Roll (rad)\n", x->out);
    for (double k = 0; k <= n; k++) {
        orr_motion m;
        const double t = x->way->begin_s + k / x->rate_hz;
        x->way->evaluate(x->way->self, t, &m);
        formats[format].put(x, t, &m);
    }
}

static int run(orr_cli *c)
{
    orr_scenario sc;
    orr_moving v;
    size_t format = 0;
    while (!orr_cli_says(c, "format", formats[format].name)) format++;
    const double rate_hz = orr_cli_real(c, "rate", formats[format].rate_hz);
    if (strncmp(formats[format].name, "gps-sdr-sim", 11) == 0 && rate_hz != 10)
        return orr_cli_usage(c, "gps-sdr-sim reads ten places a second: leave --rate out");
    int status = orr_cli_moving_open(c, &sc, NULL, &v);
    if (status != ORR_EXIT_OK) return status;
    orr_diag diag = {0};
    orr_outfile f;
    const size_t unit = (size_t)orr_cli_int(c, "unit", 0);
    orr_status s = ORR_OK;
    if (unit >= v.n_units) {
        status = orr_cli_usage(c, "there is no unit %zu; the scenario has 0 to %zu", unit, v.n_units - 1);
    } else if ((s = orr_outfile_open(orr_cli_text(c, "output", "-"), &f, &diag)) == ORR_OK) {
        const track x = {orr_moving_unit(&v, unit), rate_hz, orr_cli_axes(c) == ORR_AXES_FRD, f.stream};
        write_track(&x, format);
        s = orr_outfile_commit(&f, &diag);
    }
    orr_moving_free(&v);
    orr_scenario_free(&sc);
    return s == ORR_OK ? status : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    ORR_OPTION_OUTPUT,
    ORR_OPTION_FORMAT_AS(
        "csv|gps-sdr-sim|gps-sdr-sim-llh|skydel", "csv",
        .help = "As csv (default); for other simulators: gps-sdr-sim, user motion for its -u, or "
                "-llh for its -x; skydel, rows that a script pushes (docs/inertial.md)."),
    ORR_CLI_MOVING_OPTIONS,
    {.name = "rate",
     .kind = ORR_OPT_REAL,
     .value = "HZ",
     .min = 0.001,
     .max = 1000,
     .help = "Rows a second; 1 by default, of the forms for simulators 10."},
    {.name = "unit",
     .kind = ORR_OPT_INT,
     .value = "K",
     .min = 0,
     .max = 15,
     .help = "Which unit of the scenario. Default 0."},
    ORR_CLI_AXES_OPTION,
};

const orr_command orr_cmd_track = {
    .name = "track",
    .group = "Inertial",
    .summary = "print the motion of a flight plan or log",
    .operands = "[SCENARIO]",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Place, attitude and velocity along a trajectory; with --transfer after it was carried "
             "elsewhere, over a pole for "
             "instance. What it prints can be read back with --telemetry.",
    .example = "orrery track samples/survey.yaml -o fig3.csv\norrery track samples/survey.yaml --transfer "
               "90,0 -o fig4.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

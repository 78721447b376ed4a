// SPDX-License-Identifier: GPL-3.0-or-later
// orrery track: the motion itself, as a table.
#include <math.h>
#include <stdio.h>

#include "core/outfile.h"
#include "src/cli/frame/options.h"
#include "src/cli/inertial/moving.h"

static int run(orr_cli *c)
{
    orr_scenario sc;
    orr_moving v;
    int status = orr_cli_moving_open(c, &sc, NULL, &v);
    if (status != ORR_EXIT_OK) return status;
    orr_diag diag = {0};
    orr_outfile f;
    size_t unit = (size_t)orr_cli_int(c, "unit", 0);
    orr_status s = ORR_OK;
    if (unit >= v.n_units) {
        status = orr_cli_usage(c, "there is no unit %zu; the scenario has 0 to %zu", unit, v.n_units - 1);
    } else if ((s = orr_outfile_open(orr_cli_text(c, "output", "-"), &f, &diag)) == ORR_OK) {
        const orr_trajectory *tr = orr_moving_unit(&v, unit);
        double rate = orr_cli_real(c, "rate", 1.0), n = floor((tr->end_s - tr->begin_s) * rate + 1e-6);
        char t_gps[ORR_TIME_TEXT];
        // Milliseconds where they are all of it; a rounded time would move the body along its way.
        int decimals = fabs(1000.0 / rate - nearbyint(1000.0 / rate)) < 1e-9 * 1000.0 / rate &&
                               fabs(1000.0 * tr->begin_s - nearbyint(1000.0 * tr->begin_s)) < 1e-6
                           ? 3
                           : 9;
        const bool frd = orr_cli_axes(c) == ORR_AXES_FRD;
        fprintf(f.stream, "t_s,lat_deg,lon_deg,height_m,heading_deg,pitch_deg,roll_deg,%s,t_gps\n",
                frd ? "v_north_mps,v_east_mps,v_down_mps" : "v_east_mps,v_north_mps,v_up_mps");
        for (double k = 0; k <= n; k++) {
            orr_motion m;
            double t = tr->begin_s + k / rate;
            tr->evaluate(tr->self, t, &m);
            orr_geodetic g = orr_earth_from_ecef(m.r_m);
            orr_angles a = orr_motion_angles(&m);
            orr_vec3 u = orr_motion_velocity_enu(&m);
            if (frd) u = orr_axes_swapped(u); // North, East, Down
            fprintf(f.stream, "%.*f,%.10f,%.10f,%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%s\n", decimals, t,
                    g.lat_rad * ORR_DEG_PER_RAD, g.lon_rad * ORR_DEG_PER_RAD, g.height_m,
                    orr_heading_shown_deg(a.heading_rad, 6), a.pitch_rad * ORR_DEG_PER_RAD,
                    a.roll_rad * ORR_DEG_PER_RAD, u.x, u.y, u.z,
                    orr_time_text(orr_time_add_s(tr->t0, t), t_gps));
        }
        s = orr_outfile_commit(&f, &diag);
    }
    orr_moving_free(&v);
    orr_scenario_free(&sc);
    return s == ORR_OK ? status : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    ORR_OPTION_OUTPUT,
    ORR_CLI_MOVING_OPTIONS,
    {.name = "rate",
     .kind = ORR_OPT_REAL,
     .value = "HZ",
     .min = 0.001,
     .max = 1000,
     .help = "Rows a second. Default 1."},
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

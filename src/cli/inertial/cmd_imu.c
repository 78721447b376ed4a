// SPDX-License-Identifier: GPL-3.0-or-later
// orrery imu: ideal inertial readings of a scenario's flight or of a log.
#include <string.h>
#include <strings.h>

#include "core/outfile.h"
#include "src/cli/frame/options.h"
#include "src/cli/inertial/moving.h"
#include "src/make/measured.h"
#include "src/make/readings.h"

static void mode_options(const orr_cli *c, orr_readings_plan *p)
{
    orr_imu_mode *m = &p->mode;
    m->approach = (int)orr_cli_int(c, "approach", m->approach);
    const char *frame = orr_cli_text(c, "frame", orr_nav_frame_name(m->frame));
    m->frame = *frame == 'i' ? ORR_FRAME_INERTIAL : *frame == 'g' ? ORR_FRAME_GEOGRAPHIC : ORR_FRAME_BODY;
    m->project_mid = *orr_cli_text(c, "project", m->project_mid ? "mid" : "start") == 'm';
    m->closed_loop = *orr_cli_text(c, "loop", m->closed_loop ? "closed" : "open") == 'c';
    bool riemann =
        *orr_cli_text(c, "quadrature", m->quadrature == ORR_QUADRATURE_RIEMANN ? "riemann" : "gauss") == 'r';
    m->quadrature = riemann ? ORR_QUADRATURE_RIEMANN : ORR_QUADRATURE_GAUSS;
    if (orr_cli_given(c, "quadrature") || orr_cli_given(c, "rate"))
        m->order = orr_moving_order(p->moving, m->quadrature, p->rate_hz);
    m->order = (int)orr_cli_int(c, "order", m->order);
}

static bool is_csv(const char *path)
{
    size_t n = strlen(path);
    return strcmp(path, "-") == 0 || (n > 4 && strcasecmp(path + n - 4, ".csv") == 0);
}

static orr_status write_csv(const char *path, const orr_imu *imu, orr_imu_axes axes, orr_diag *diag)
{
    orr_outfile f;
    orr_status s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    s = orr_imu_write_csv(f.stream, imu, axes, diag);
    return orr_outfile_end(&f, s, diag);
}

static int generate(orr_cli *c, const orr_scenario *sc, orr_inputs *inputs, const orr_moving *v)
{
    orr_diag diag = {0};
    const char *path = orr_cli_text(c, "output", "imu.nc");
    if (is_csv(path) && orr_cli_given(c, "truth-rate"))
        return orr_cli_usage(c, "--truth-rate is of NetCDF files; CSV has the truth beside every reading");
    orr_readings_plan p = orr_readings_plan_of(v);
    p.unit = (size_t)orr_cli_int(c, "unit", 0);
    if (p.unit >= v->n_units)
        return orr_cli_usage(c, "there is no unit %zu; the scenario has 0 to %zu", p.unit, v->n_units - 1);
    p.rate_hz = orr_cli_real(c, "rate", p.rate_hz);
    p.truth_rate_hz = orr_cli_real(c, "truth-rate", 0);
    p.instantaneous = orr_cli_given(c, "instantaneous");
    p.axes = orr_cli_axes(c);
    mode_options(c, &p);
    int refused = orr_cli_settle(c, "approach", p.mode.approach == 1 ? "1" : "2");
    if (refused != ORR_EXIT_OK) return refused;
    if (p.mode.approach == 1 && p.axes != ORR_AXES_RFU)
        return orr_cli_usage(
            c, "--axes frd does not apply with --approach 1: such readings are replayed to the bit in "
               "the axes they were made in");
    orr_readings r = {0};
    orr_sensor_errors file = {0};
    orr_imu_errors errors;
    const char *of = orr_cli_text(c, "errors", sc->motion.imu.errors);
    orr_status s = ORR_OK;
    if (of != NULL) {
        s = orr_errors_open(inputs, of, &file, &errors, &diag);
        errors.seed = (uint64_t)orr_cli_int(c, "error-seed", s == ORR_OK ? file.seed : 0) + p.unit;
        p.errors = &errors;
        p.errors_title = file.title != NULL ? file.title : of;
    }
    if (s == ORR_OK) s = orr_readings_make(&p, &r, &diag);
    if (s == ORR_OK)
        s = is_csv(path) ? write_csv(path, &r.imu, p.axes, &diag)
                         : orr_readings_save(&r, &p, sc, inputs, path, c->call, &diag);
    char mode[160], from[ORR_TIME_TEXT];
    if (s == ORR_OK)
        orr_cli_say(c, "%s: %zu readings at %g Hz from %s GPS, %s", path, r.imu.n, r.imu.rate_hz,
                    orr_time_text(orr_time_add_s(r.imu.t0, r.imu.begin_s), from),
                    orr_imu_mode_text(&r.imu.mode, mode, sizeof mode));
    for (int k = 0; k < 2 && s == ORR_OK; k++)
        if (r.cut.saturated[k] > 0)
            orr_cli_say(c, "%s at their limit in %zu of %zu readings", k == 0 ? "gyros" : "accelerometers",
                        r.cut.saturated[k], r.imu.n);
    orr_readings_free(&r);
    orr_sensor_errors_free(&file);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static int run(orr_cli *c)
{
    orr_scenario sc;
    orr_inputs inputs = {0};
    orr_moving v;
    int status = orr_cli_moving_open(c, &sc, &inputs, &v);
    if (status == ORR_EXIT_OK) {
        status = generate(c, &sc, &inputs, &v);
        orr_moving_free(&v);
        orr_scenario_free(&sc);
    }
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {
    ORR_OPTION_OUTPUT_AS(.fallback = "imu.nc",
                         .help = "NetCDF-4, or CSV where the name ends in .csv or is -. Default imu.nc."),
    ORR_CLI_MOVING_OPTIONS,
    {.name = "rate",
     .kind = ORR_OPT_REAL,
     .value = "HZ",
     .min = 0.01,
     .max = 100000,
     .help = "Of the readings. Default: the scenario's, 100."},
    {.name = "approach",
     .kind = ORR_OPT_INT,
     .value = "1|2",
     .min = 1,
     .max = 2,
     .help = "How readings are made. 2: integrals of the true rate and force, physical. 1: what one step of "
             "a navigator needs; such "
             "readings suit that "
             "navigator alone. Default 2."},
    {.name = "frame",
     .applies = "approach=1",
     .kind = ORR_OPT_CHOICE,
     .value = "inertial|geographic|body",
     .help = "Frame of the navigator. Default inertial."},
    {.name = "project",
     .applies = "approach=1",
     .kind = ORR_OPT_CHOICE,
     .value = "mid|start",
     .help = "Matrices of the middle of the step, or of its begin t_j. Default mid."},
    {.name = "loop",
     .applies = "approach=1",
     .kind = ORR_OPT_CHOICE,
     .value = "closed|open",
     .help = "The generator carries the navigator's state, or the truth's. Default closed."},
    {.name = "quadrature",
     .applies = "approach=2",
     .kind = ORR_OPT_CHOICE,
     .value = "gauss|riemann",
     .help = "Quadrature of each step. Default gauss."},
    {.name = "order",
     .applies = "approach=2",
     .kind = ORR_OPT_INT,
     .value = "M",
     .min = 1,
     .max = 1000,
     .help = "Nodes (1 to 5) or rectangles a step. Default 2 nodes from 50 Hz on, 3 below and "
             "for logs; 100 rectangles."},
    {.name = "unit",
     .kind = ORR_OPT_INT,
     .value = "K",
     .min = 0,
     .max = 15,
     .help = "Which unit of the scenario. Default 0, the trajectory's own point."},
    {.name = "instantaneous",
     .kind = ORR_OPT_FLAG,
     .help = "Rate and specific force at each sample edge as well."},
    ORR_CLI_AXES_OPTION,
    {.name = "errors",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Errors of the sensors (YAML, as in samples/sensors/): what they measure is written beside the "
             "ideal readings. Default: imu.errors of the scenario."},
    {.name = "error-seed",
     .applies = "errors",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 0,
     .max = 9e15,
     .help = "Seed of everything random in them, to which the number of the unit is added. Default: that of "
             "the file."},
    {.name = "truth-rate",
     .kind = ORR_OPT_REAL,
     .value = "HZ",
     .min = 0.001,
     .max = 100000,
     .help =
         "Of the truth in a NetCDF file. Default 20 Hz with approach 2, every sample with approach 1; CSV "
         "has every sample."},
};

const orr_command orr_cmd_imu = {
    .name = "imu",
    .group = "Inertial",
    .summary = "make ideal inertial readings of a flight",
    .operands = "[SCENARIO]",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Gyro and accelerometer increments with the true motion beside them, from the trajectory of a "
             "scenario or from "
             "recorded telemetry. Axes are right, forward, up; a unit at rest reads +g upward.\n\n"
             "The file says how its readings were made: those of approach 1 suit one navigator and are no "
             "physical readings.",
    .example = "orrery imu samples/survey.yaml -o imu.nc\n"
               "orrery imu --telemetry flight.csv --rate 200 -o imu.nc\n"
               "orrery imu --telemetry GPS.txt --columns "
               "\"-,fix[>=3],tow[ms],week,-,-,lat,lon,-,alt,-,-,-,t[ms]\" \\\n"
               "           --telemetry ATT.txt --columns \"-,t[ms],roll,pitch,heading,-,-\" -o imu.nc",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

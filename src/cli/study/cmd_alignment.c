// SPDX-License-Identifier: GPL-3.0-or-later
// orrery alignment: what alignment makes of sensors with errors.
#include <math.h>
#include <stdlib.h>

#include "inertial/sense/sensors.h"
#include "inertial/study/self_alignment.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/alignment.h"
#include "src/cli/study/study.h"
#include "src/config/study_alignment.h"

#define ARCSEC_PER_RAD (ORR_DEG_PER_RAD * 3600.0)

enum {
    SEED,
    HEADING,
    PITCH,
    ROLL,
    CLOSED_HEADING,
    CLOSED_PITCH,
    CLOSED_ROLL,
    GYRO_EAST,
    ACCEL_EAST,
    ACCEL_NORTH,
    COLUMNS
};
static const orr_study_column columns[COLUMNS] = {
    {"seed", NULL, "of the errors", NULL},
    {"heading_error_arcsec", "arcsec", "found less true", NULL},
    {"pitch_error_arcsec", "arcsec", "found less true", NULL},
    {"roll_error_arcsec", "arcsec", "found less true", NULL},
    {"heading_closed_arcsec", "arcsec", "closed form: -dw_E / (u cos lat) + tan(lat) df_E / g", NULL},
    {"pitch_closed_arcsec", "arcsec", "closed form: df / g forward", NULL},
    {"roll_closed_arcsec", "arcsec", "closed form: -df / g to the right", NULL},
    {"gyro_east_degph", "deg/h", "mean error of the rate towards East", NULL},
    {"accel_east_ug", "ug", "mean error of the force towards East", NULL},
    {"accel_north_ug", "ug", "mean error of the force towards North", NULL},
};

static void put_row(double *row, uint64_t seed, const orr_self_alignment *a)
{
    const double ug = 1e-6 * 9.80665;
    const double v[COLUMNS] = {(double)seed,
                               a->error.heading_rad * ARCSEC_PER_RAD,
                               a->error.pitch_rad * ARCSEC_PER_RAD,
                               a->error.roll_rad * ARCSEC_PER_RAD,
                               a->closed_form.heading_rad * ARCSEC_PER_RAD,
                               a->closed_form.pitch_rad * ARCSEC_PER_RAD,
                               a->closed_form.roll_rad * ARCSEC_PER_RAD,
                               a->gyro_error_radps.x * ARCSEC_PER_RAD,
                               a->accel_error_mps2.x / ug,
                               a->accel_error_mps2.y / ug};
    for (int k = 0; k < COLUMNS; k++) row[k] = v[k];
}

// One alignment a seed, on the same ideal readings.
static orr_status align(const orr_cli *c, const orr_study_alignment *study, const orr_study_motion *motion,
                        orr_imu_errors *errors, double *table, orr_diag *diag)
{
    const orr_moving *v = &motion->moving;
    const double window_s = (double)study->self.window_ns * 1e-9;
    const orr_imu_request want = {.begin_s = v->trajectory.begin_s,
                                  .duration_s = window_s,
                                  .rate_hz = v->rate_hz,
                                  .mode = v->mode,
                                  .gravity = v->gravity};
    orr_imu imu = {0};
    orr_status s = orr_imu_generate(&v->trajectory, &want, &imu, diag);
    for (int64_t k = 0; k < study->seeds && s == ORR_OK; k++) {
        errors->seed = (uint64_t)(study->head.seed + k);
        orr_self_alignment a;
        s = orr_imu_add_errors(errors, &imu, NULL, diag);
        if (s == ORR_OK)
            s = orr_self_align(
                &imu, study->self.method == ORR_SELF_WORD_AVERAGE ? ORR_SELF_AVERAGE : ORR_SELF_INERTIAL, 0,
                imu.n, v->gravity, &a, diag);
        if (s == ORR_OK) put_row(&table[k * COLUMNS], errors->seed, &a);
        orr_cli_progress(c, "alignments", (size_t)k + 1, (size_t)study->seeds);
    }
    orr_imu_free(&imu);
    return s;
}

static double rms(const double *table, size_t n, int column)
{
    double sum = 0.0;
    for (size_t k = 0; k < n; k++)
        sum += table[k * COLUMNS + (size_t)column] * table[k * COLUMNS + (size_t)column];
    return sqrt(sum / (double)n);
}
static double rms_difference(const double *table, size_t n, int a, int b)
{
    double sum = 0.0;
    for (size_t k = 0; k < n; k++) {
        const double d = table[k * COLUMNS + (size_t)a] - table[k * COLUMNS + (size_t)b];
        sum += d * d;
    }
    return sqrt(sum / (double)n);
}

static int report(const orr_cli *c, const double *table, size_t n)
{
    static const char *const name[] = {"heading", "pitch", "roll"};
    if (orr_cli_says(c, "format", "json")) {
        json_t *j = json_object();
        for (int k = 0; k < 3; k++)
            json_object_set_new(
                j, name[k],
                json_pack("{s:o, s:o, s:o}", "rms_arcsec", orr_json_number(rms(table, n, HEADING + k)),
                          "closed_form_rms_arcsec", orr_json_number(rms(table, n, CLOSED_HEADING + k)),
                          "difference_rms_arcsec",
                          orr_json_number(rms_difference(table, n, HEADING + k, CLOSED_HEADING + k))));
        return orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    }
    if (orr_study_to_stdout(c)) return ORR_EXIT_OK;
    printf("%zu alignments     error r.m.s.  closed form  difference, arcsec\n", n);
    for (int k = 0; k < 3; k++)
        printf("%-16s %14.4g %12.4g %11.3g\n", name[k], rms(table, n, HEADING + k),
               rms(table, n, CLOSED_HEADING + k), rms_difference(table, n, HEADING + k, CLOSED_HEADING + k));
    return ORR_EXIT_OK;
}

static orr_status draw(const orr_cli *c, const char *title, const double *table, size_t n, orr_diag *diag)
{
    double *xy = malloc(2 * n * sizeof *xy);
    if (xy == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu points", n);
    for (size_t k = 0; k < n; k++) {
        xy[k] = table[k * COLUMNS + CLOSED_HEADING];
        xy[n + k] = table[k * COLUMNS + HEADING];
    }
    const orr_plot_line line[] = {{.label = "alignments", .x = xy, .y = xy + n, .n = n, .marks = true},
                                  {.label = "closed form", .x = xy, .y = xy, .n = n, .dash = 1, .colour = 1}};
    const orr_plot plot = {.title = title,
                           .x_label = "heading error by the closed form, arcsec",
                           .y_label = "heading error, arcsec",
                           .line = line,
                           .n = 2};
    const orr_status s = orr_study_plot(c, &plot, diag);
    free(xy);
    return s;
}

static int make(orr_cli *c, const orr_study_alignment *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    orr_study_motion motion = {0};
    orr_sensor_errors file = {0};
    orr_imu_errors errors;
    const char *title = study->head.title != NULL ? study->head.title : "Self-alignment";
    const size_t n = (size_t)study->seeds;
    double *table = calloc(n, COLUMNS * sizeof *table);
    orr_status s = table != NULL ? ORR_OK : orr_diag_set(&diag, ORR_E_MEMORY, "no memory for %zu seeds", n);
    if (s == ORR_OK) s = orr_study_motion_open(inputs, study->scenario, 0, &motion, &diag);
    if (s == ORR_OK) s = orr_errors_open(inputs, study->errors, &file, &errors, &diag);
    if (s == ORR_OK) s = align(c, study, &motion, &errors, table, &diag);
    const orr_study_table out = {"alignment", columns, COLUMNS, n, table};
    if (s == ORR_OK) s = orr_study_write(c, title, inputs, &out, 1, &diag);
    if (s == ORR_OK) s = draw(c, title, table, n, &diag);
    const int status = s == ORR_OK ? report(c, table, n) : orr_cli_fail(c, &diag);
    free(table);
    orr_sensor_errors_free(&file);
    orr_study_motion_free(&motion);
    return status;
}

static int run(orr_cli *c)
{
    orr_study_alignment study;
    orr_inputs inputs = {0};
    bool go;
    int status = orr_cli_study_open(c, &orr_study_alignment_schema, &study, &inputs, &go);
    if (!go) return status;
    status = study.kind == ORR_ALIGNMENT_TRANSFER ? orr_cli_transfer(c, &study, &inputs)
                                                  : make(c, &study, &inputs);
    orr_schema_free(&orr_study_alignment_schema, &study);
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {ORR_STUDY_OPTIONS};

const orr_command orr_cmd_alignment = {
    .name = "alignment",
    .group = "Inertial studies",
    .summary = "alignment of inertial units whose sensors have errors",
    .operands = "STUDY.yaml",
    .min_operands = 0,
    .max_operands = 1,
    .about =
        "Transfer alignment of a second unit by the first one's velocity on a moving base, with errors of "
        "both and a bending "
        "arm, by a Kalman filter: what is left against what the filter says, over many draws. Heading is "
        "seen in manoeuvres "
        "alone.\n\nSelf-alignment at rest by gravity and the Earth's rate, over many draws of sensor errors, "
        "compared with its "
        "closed forms: heading by dw_E / (u cos lat), tilts by df / g.",
    .example = "orrery alignment samples/studies/self-alignment.yaml --plot alignment.svg -o alignment.csv\n"
               "orrery alignment samples/studies/transfer-alignment.yaml --plot transfer.svg -o transfer.nc",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

// SPDX-License-Identifier: GPL-3.0-or-later
// orrery calibration: a unit on a turntable, its readings with their truth, and what least squares make of them.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "inertial/nav/null_test.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/study.h"
#include "src/make/calibration.h"

typedef struct work {
    const orr_study_calibration *study;
    orr_calibration_job job;
    orr_imu *imu; // [cycles]
    size_t n;     // readings of all
    orr_calibration_result seen, found;
    double want[ORR_CALIBRATION_MOST];
    double nees;      // mean over seeds
    double null_m[3]; // exact, mounting of first order, forces by the stand's rate alone
    double null_s;
    bool estimated;
} work;

static orr_status make_readings(work *w, orr_diag *diag)
{
    const size_t n = w->job.n_cycles;
    w->imu = calloc(n, sizeof *w->imu);
    if (w->imu == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu cycles", n);
    orr_status s = ORR_OK;
    for (size_t k = 0; k < n && s == ORR_OK; k++) {
        s = orr_stand_readings(&w->job.stand, &w->job.cycle[k], w->job.inner_m, 0, w->study->rate_hz,
                               &w->imu[k], diag);
        if (s == ORR_OK) w->n += w->imu[k].n;
    }
    return s;
}

// Errors of one draw on all cycles; the sensors are switched on once, so that constants are the same and noises go on.
static orr_status measure(work *w, uint64_t seed, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t k = 0; k < w->job.n_cycles && s == ORR_OK; k++) {
        orr_imu_errors e = w->job.errors;
        e.seed = seed * ORR_CALIBRATION_MOST_CYCLES + k;
        s = orr_imu_add_errors(&e, &w->imu[k], NULL, diag);
    }
    return s;
}

static orr_status null_tests(work *w, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (int k = 0; k < 3 && s == ORR_OK && w->study->null_test; k++) {
        orr_stand stand = w->job.stand;
        stand.setup.literal_mounting = k == 1;
        stand.setup.literal_forces = k == 2;
        const orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE,
                                   .samples = ORR_NAVIGATOR_MAX_SAMPLES,
                                   .gravity = stand.setup.gravity};
        orr_imu imu;
        orr_null_report r;
        s = orr_stand_readings(&stand, &w->job.cycle[0], NULL, 0, w->study->rate_hz, &imu, diag);
        if (s != ORR_OK) return s;
        s = orr_null_test(&imu, &nav, NULL, NULL, &r, diag);
        w->null_m[k] = r.max_3d_m;
        w->null_s = r.duration_s;
        orr_imu_free(&imu);
    }
    return s;
}

// Many draws of noise by a linear step each.
static orr_status draws(const orr_cli *c, work *w, orr_diag *diag)
{
    const orr_calibration_plan *p = &w->job.plan;
    orr_imu_errors noisy = w->job.errors;
    const size_t seeds = (size_t)w->study->seeds, n = orr_calibration_parameters(p);
    if (seeds == 0) return ORR_OK;
    for (int i = 0; i < 3; i++) w->job.errors.gyro.white[i] = w->job.errors.accel.white[i] = 0;
    orr_calibration_data clean = {0}, data = {0};
    orr_calibration_linear l = {0};
    orr_status s = measure(w, 0, diag);
    if (s == ORR_OK) s = orr_calibration_sum(p, w->imu, true, &clean, diag);
    if (s == ORR_OK) s = orr_calibration_linearise(p, &clean, w->want, &l, diag);
    w->job.errors = noisy;
    for (size_t k = 0; k < seeds && s == ORR_OK; k++) {
        double value[ORR_CALIBRATION_MOST], one;
        s = measure(w, (uint64_t)w->study->head.seed + 1 + k, diag);
        if (s == ORR_OK) s = orr_calibration_sum(p, w->imu, true, &data, diag);
        if (s != ORR_OK) break;
        orr_calibration_linear_step(p, &l, &data, value);
        s = orr_calibration_nees(&l.at, value, w->want, n, &one, diag);
        w->nees += one / (double)seeds;
        orr_calibration_data_free(&data);
        orr_cli_progress(c, "draws", k + 1, seeds);
    }
    orr_calibration_linear_free(&l);
    orr_calibration_data_free(&clean);
    return s;
}

static orr_status calibrate(const orr_cli *c, work *w, orr_diag *diag)
{
    const orr_calibration_plan *p = &w->job.plan;
    orr_calibration_true_values(p, &w->job.truth, w->want);
    orr_status s = orr_calibration_observe(p, w->want, &w->seen, diag);
    if (s != ORR_OK || !w->study->estimate || w->seen.unseen > 0) return s;
    if (w->job.has_errors) s = draws(c, w, diag);
    if (s == ORR_OK && w->job.has_errors) s = measure(w, (uint64_t)w->study->head.seed, diag);
    orr_calibration_data data = {0};
    if (s == ORR_OK) s = orr_calibration_sum(p, w->imu, w->job.has_errors, &data, diag);
    if (s == ORR_OK) s = orr_calibration_solve(p, &data, NULL, 15, &w->found, diag);
    orr_calibration_data_free(&data);
    w->estimated = s == ORR_OK;
    return s;
}

// --- What comes out ---

// Units of reports, by the SI unit of a parameter and whether it is a scale factor.
static double shown_unit(const char *unit, const char **name)
{
    static const struct {
        const char *si, *name;
        double scale;
    } u[] = {{"m/s2", "ug", 1e6 / 9.80665},
             {"rad/s", "deg/h", ORR_DEG_PER_RAD * 3600},
             {"1", "ppm", 1e6},
             {"rad", "arcsec", ORR_DEG_PER_RAD * 3600},
             {"m", "mm", 1e3}};
    for (size_t k = 0; k < sizeof u / sizeof u[0]; k++)
        if (strcmp(unit, u[k].si) == 0) {
            *name = u[k].name;
            return u[k].scale;
        }
    *name = unit;
    return 1;
}

static void print_parameters(const work *w)
{
    const orr_calibration_plan *p = &w->job.plan;
    printf("%-28s %-6s %12s %12s %11s %11s  %s\n", "", "", "injected", "found", "error", "sigma",
           "most correlated with");
    for (size_t k = 0; k < w->seen.sensors; k++) {
        const char *unit, *name, *partner;
        const char *what = orr_calibration_name(p, k, &unit);
        const double scale = shown_unit(unit, &name), want = w->want[k] * scale;
        if (!w->seen.seen[k]) {
            printf("%-28s %-6s %12.6g   the plan cannot see it\n", what, name, want);
            continue;
        }
        printf("%-28s %-6s %12.6g ", what, name, want);
        if (w->estimated)
            printf("%12.6g %11.3g ", w->found.value[k] * scale, (w->found.value[k] - w->want[k]) * scale);
        else
            printf("%12s %11s ", "", "");
        partner = orr_calibration_name(p, w->seen.partner[k], NULL);
        printf("%11.3g  %.2f %s\n", w->seen.sigma[k] * scale, w->seen.correlation[k],
               partner != NULL ? partner : "the mounting");
    }
}

static void print_summary(const work *w)
{
    const orr_calibration_job *j = &w->job;
    printf("%zu readings in %zu cycles; condition %.4g, %zu combinations of unknowns not seen\n", w->n,
           j->n_cycles, w->seen.condition, w->seen.unseen);
    if (w->estimated)
        printf("%zu unknowns from blocks of %g s in %d steps, residuals %.3g of their sigma\n", w->found.n,
               j->plan.block_s, w->found.iterations, w->found.residual_rms);
    if (j->more)
        printf("the sensors have errors beyond constants and white noise: sigmas do not know of them\n");
    if (w->estimated && w->study->seeds > 0 && j->has_errors) {
        const double n = (double)w->seen.sensors, wide = 2.576 * sqrt(2 * n / (double)w->study->seeds);
        printf("normalised squared error of %zu parameters, mean of %lld draws: %.2f (99 %% of such means: "
               "%.2f to %.2f)\n",
               w->seen.sensors, (long long)w->study->seeds, w->nees, n - wide, n + wide);
    }
    if (w->study->null_test)
        printf("null test of the first cycle, %g s: %.3g m; with the mounting of first order (22) %.3g m, "
               "with forces by the "
               "stand's rate alone (27) %.3g m\n",
               w->null_s, w->null_m[0], w->null_m[1], w->null_m[2]);
}

static int report_json(const orr_cli *c, const work *w)
{
    json_t *list = json_array();
    for (size_t k = 0; k < w->seen.sensors; k++) {
        const char *unit;
        const char *name = orr_calibration_name(&w->job.plan, k, &unit);
        json_array_append_new(
            list, json_pack("{s:s, s:s, s:b, s:o, s:o, s:o, s:o}", "name", name, "unit", unit, "seen",
                            w->seen.seen[k], "injected", orr_json_number(w->want[k]), "found",
                            orr_json_number(w->estimated ? w->found.value[k] : ORR_NAN), "sigma",
                            orr_json_number(w->seen.seen[k] ? w->seen.sigma[k] : ORR_NAN), "correlation",
                            orr_json_number(w->seen.correlation[k])));
    }
    json_t *out = json_pack(
        "{s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "readings", orr_json_count(w->n), "condition",
        orr_json_number(w->seen.condition), "unseen", orr_json_count(w->seen.unseen), "parameters", list,
        "residual_rms", orr_json_number(w->estimated ? w->found.residual_rms : ORR_NAN), "nees",
        orr_json_number(w->estimated && w->study->seeds > 0 ? w->nees : ORR_NAN), "null_test_m",
        json_pack("[o, o, o]", orr_json_number(w->null_m[0]), orr_json_number(w->null_m[1]),
                  orr_json_number(w->null_m[2])));
    return orr_json_print(c, out, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
}

enum { CYCLE, TIME, ANGLE, Q, IDEAL = Q + 4, MEASURED = IDEAL + 6, READING_COLUMNS = MEASURED + 6 };
static const orr_study_column reading_column[READING_COLUMNS] = {
    {"cycle", NULL, "from 1", NULL},
    {"t_s", "s", "end of the reading, since the begin of the cycle", NULL},
    {"stand_deg", "deg", "angle of the stand then", NULL},
    {"q_w", NULL, "true attitude then: the unit from East, North, Up", NULL},
    {"q_x", NULL, NULL, NULL},
    {"q_y", NULL, NULL, NULL},
    {"q_z", NULL, NULL, NULL},
    {"dtheta_x_rad", "rad", "ideal increment of the gyro", NULL},
    {"dtheta_y_rad", "rad", NULL, NULL},
    {"dtheta_z_rad", "rad", NULL, NULL},
    {"dv_x_mps", "m/s", "ideal increment of the accelerometer, at its own place", NULL},
    {"dv_y_mps", "m/s", NULL, NULL},
    {"dv_z_mps", "m/s", NULL, NULL},
    {"measured_dtheta_x_rad", "rad", "with errors", NULL},
    {"measured_dtheta_y_rad", "rad", NULL, NULL},
    {"measured_dtheta_z_rad", "rad", NULL, NULL},
    {"measured_dv_x_mps", "m/s", "with errors", NULL},
    {"measured_dv_y_mps", "m/s", NULL, NULL},
    {"measured_dv_z_mps", "m/s", NULL, NULL},
};

static void put_vector(double *to, orr_vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

static void fill_readings(const work *w, size_t columns, double *value)
{
    const orr_mat3 E = orr_mat3_transpose(&w->job.stand.A_xe);
    const orr_quat q_ex = orr_quat_from_mat3(&E); // ecef from enu
    for (size_t k = 0; k < w->job.n_cycles; k++) {
        const orr_imu *m = &w->imu[k];
        for (size_t j = 0; j < m->n; j++, value += columns) {
            double angle, rate, change;
            const double t = orr_imu_edge_s(m, j + 1);
            orr_stand_turn(&w->job.cycle[k].profile, t, &angle, &rate, &change);
            const orr_quat q = orr_quat_mul(q_ex, m->q_be[j + 1]);
            value[CYCLE] = (double)(k + 1);
            value[TIME] = t;
            value[ANGLE] = (w->job.cycle[k].start_rad + angle) * ORR_DEG_PER_RAD;
            value[Q] = q.w;
            put_vector(&value[Q + 1], (orr_vec3){q.x, q.y, q.z});
            put_vector(&value[IDEAL], m->dtheta_rad[j]);
            put_vector(&value[IDEAL + 3], m->dv_mps[j]);
            if (columns == IDEAL + 6) continue;
            put_vector(&value[MEASURED], m->measured_dtheta_rad[j]);
            put_vector(&value[MEASURED + 3], m->measured_dv_mps[j]);
        }
    }
}

static orr_status write_tables(const orr_cli *c, const char *title, const work *w, const orr_inputs *inputs,
                               orr_diag *diag)
{
    if (!orr_cli_given(c, "output")) return ORR_OK;
    const size_t columns = w->job.has_errors ? READING_COLUMNS : MEASURED, n = w->seen.sensors;
    const char *name[31] = {NULL};
    double parameter[30][5], *value = malloc((w->n + 1) * columns * sizeof *value);
    if (value == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu readings", w->n);
    fill_readings(w, columns, value);
    for (size_t k = 0; k < n; k++) {
        name[k] = orr_calibration_name(&w->job.plan, k, NULL);
        const double row[5] = {(double)k, w->want[k], w->estimated ? w->found.value[k] : ORR_NAN,
                               w->seen.sigma[k], w->seen.correlation[k]};
        memcpy(parameter[k], row, sizeof row);
    }
    char word[30][40];
    const char *words[31] = {NULL};
    for (size_t k = 0; k < n; k++) { // flag_meanings are divided by blanks
        snprintf(word[k], sizeof word[k], "%s", name[k]);
        for (char *at = word[k]; *at != '\0'; at++)
            if (*at == ' ' || *at == ',') *at = '_';
        words[k] = word[k];
    }
    const orr_study_column of_parameter[] = {
        {"name", NULL, "parameter, in SI units", words},
        {"injected", NULL, "in the accelerometers' own axes", NULL},
        {"found", NULL, "by least squares", NULL},
        {"sigma", NULL, "by the noise; not finite where the plan cannot see it", NULL},
        {"correlation", NULL, "with the unknown it is correlated with most", NULL},
    };
    const orr_study_table table[] = {{"reading", reading_column, columns, w->n, value},
                                     {"parameter", of_parameter, 5, n, &parameter[0][0]}};
    const orr_status s = orr_study_write(c, title, inputs, table, 2, diag);
    free(value);
    return s;
}

static orr_status draw(const orr_cli *c, const char *title, const work *w, orr_diag *diag)
{
    double x[30], sigma[30], error[30];
    const size_t n = w->seen.sensors;
    for (size_t k = 0; k < n; k++) {
        x[k] = (double)(k + 1);
        sigma[k] = w->seen.sigma[k] / orr_calibration_size(k);
        error[k] = w->estimated ? fabs(w->found.value[k] - w->want[k]) / orr_calibration_size(k) : ORR_NAN;
    }
    const orr_plot_line line[] = {
        {.label = "standard deviation", .x = x, .y = sigma, .n = n, .marks = true, .dash = 1},
        {.label = "size of the error", .x = x, .y = error, .n = n, .marks = true, .colour = 1}};
    const orr_plot plot = {.title = title,
                           .x_label =
                               "parameter, in the order of the report: 1-9 accelerometers, 10-21 gyros, arms",
                           .y_label = "in units of 1 mg, 1 %, 10 mrad, 2 deg/h, 10 cm",
                           .log_y = true,
                           .line = line,
                           .n = w->estimated ? 2 : 1};
    return orr_study_plot(c, &plot, diag);
}

static int finish(const orr_cli *c, const work *w)
{
    if (orr_cli_says(c, "format", "json")) {
        const int status = report_json(c, w);
        if (status != ORR_EXIT_OK) return status;
    } else if (!orr_study_to_stdout(c)) {
        print_parameters(w);
        print_summary(w);
    }
    if (!w->study->estimate || w->estimated) return ORR_EXIT_OK;
    for (size_t k = 0; k < w->seen.sensors; k++)
        if (!w->seen.seen[k])
            return orr_cli_failf(
                c,
                "the plan is singular: it cannot see the %s, and cannot be calibrated by ('estimate: "
                "false' compares plans)",
                orr_calibration_name(&w->job.plan, k, NULL));
    return orr_cli_failf(c, "the plan is singular: it cannot see how the unit is mounted");
}

static int make(orr_cli *c, const orr_study_calibration *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    work *w = calloc(1, sizeof *w);
    if (w == NULL) return orr_cli_failf(c, "no memory");
    w->study = study;
    const char *title = study->head.title != NULL ? study->head.title : "Calibration on a turntable";
    orr_status s = orr_calibration_open(study, inputs, &w->job, &diag);
    if (s == ORR_OK) s = make_readings(w, &diag);
    if (s == ORR_OK && w->job.has_errors) s = measure(w, (uint64_t)study->head.seed, &diag);
    if (s == ORR_OK) s = null_tests(w, &diag);
    if (s == ORR_OK) s = calibrate(c, w, &diag);
    if (s == ORR_OK) s = write_tables(c, title, w, inputs, &diag);
    if (s == ORR_OK) s = draw(c, title, w, &diag);
    const int status = s == ORR_OK ? finish(c, w) : orr_cli_fail(c, &diag);
    for (size_t k = 0; w->imu != NULL && k < w->job.n_cycles; k++) orr_imu_free(&w->imu[k]);
    free(w->imu);
    orr_calibration_result_free(&w->seen);
    orr_calibration_result_free(&w->found);
    orr_calibration_job_free(&w->job);
    free(w);
    return status;
}

static int run(orr_cli *c)
{
    orr_study_calibration study;
    orr_inputs inputs = {0};
    bool go;
    int status = orr_cli_study_open(c, &orr_study_calibration_schema, &study, &inputs, &go);
    if (!go) return status;
    status = make(c, &study, &inputs);
    orr_schema_free(&orr_study_calibration_schema, &study);
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {ORR_STUDY_OPTIONS};

const orr_command orr_cmd_calibration = {
    .name = "calibration",
    .group = "Inertial studies",
    .summary = "calibration of a unit on a turntable: readings with truth, and a check",
    .operands = "STUDY.yaml",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Readings of a unit on a stand with one axis, in cycles of turning, with mounting errors, "
             "offsets and arms of the "
             "accelerometers (Bogdanov 2015, section 4), ideal and with errors of sensors beside each other: "
             "a data set for "
             "any calibration. Which of 21 parameters (27 with arms) the plan shows and how well is told, "
             "and least squares "
             "recover them as a check.",
    .example = "orrery calibration samples/studies/calibration.yaml -o calibration.nc --plot calibration.svg",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

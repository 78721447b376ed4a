// SPDX-License-Identifier: GPL-3.0-or-later
// orrery error-equations: linear error equations against the navigator's own errors.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/sense/sensors.h"
#include "inertial/study/error_modes.h"
#include "inertial/study/error_study.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/study.h"
#include "src/config/study_error_equations.h"

_Static_assert((int)ORR_ERROR_WORD_DYNAMIC == (int)ORR_ERROR_DYNAMIC &&
                   (int)ORR_ERROR_WORD_RUNGE_KUTTA == (int)ORR_ERROR_RUNGE_KUTTA,
               "the words of the file are in the order of the library");

#define ARCSEC_PER_RAD (ORR_DEG_PER_RAD * 3600.0)
enum { MANOEUVRES = 16, SIZES = 32, WORDS = 4 };

// --- Tables ---

enum {
    M_MANOEUVRE,
    M_MODEL,
    M_METHOD,
    M_STEP,
    M_SIZE,
    M_POSITION,
    M_VELOCITY,
    M_ATTITUDE,
    M_P,
    M_V,
    M_A,
    M_COLUMNS
};
static const char *const model_words[] = {"phi", "psi", "dynamic", NULL};
static const char *const method_words[] = {"euler", "midpoint", "runge-kutta", NULL};

enum { V = 3 }; // components of a vector
enum {
    S_T,
    S_POSITION,
    S_RELATIVE = S_POSITION + V,
    S_ABSOLUTE = S_RELATIVE + V,
    S_ATTITUDE = S_ABSOLUTE + V,
    S_VERTICAL = S_ATTITUDE + V,
    S_HEADING = S_VERTICAL + 2,
    S_DYNAMIC_POSITION,
    S_KINEMATIC_POSITION = S_DYNAMIC_POSITION + V,
    S_DYNAMIC_VELOCITY = S_KINEMATIC_POSITION + V,
    S_KINEMATIC_VELOCITY = S_DYNAMIC_VELOCITY + V,
    S_LINEAR_POSITION = S_KINEMATIC_VELOCITY + V, // of the three models, deviation from their own differences
    S_LINEAR_VELOCITY = S_LINEAR_POSITION + V,
    S_LINEAR_ATTITUDE = S_LINEAR_VELOCITY + V,
    S_COLUMNS = S_LINEAR_ATTITUDE + V
};
#define EACH(name, unit, help)                                                                               \
    {"phi_" name, unit, help ", phi", NULL}, {"psi_" name, unit, help ", psi", NULL},                        \
    {                                                                                                        \
        "dynamic_" name, unit, help ", dynamic", NULL                                                        \
    }
static const orr_study_column series_columns[S_COLUMNS] = {
    {"t_s", "s", "after the begin", NULL},
    ORR_STUDY_COLUMNS_ENU("position_m", "m", "navigated less true position"),
    ORR_STUDY_COLUMNS_ENU("relative_velocity_mps", "m/s",
                          "error of the velocity relative to the Earth, as a vector"),
    ORR_STUDY_COLUMNS_ENU("absolute_velocity_mps", "m/s", "error of the absolute velocity, as a vector"),
    ORR_STUDY_COLUMNS_ENU("attitude_arcsec", "arcsec",
                          "error of the body's attitude against the geographic axes, phi"),
    {"vertical_arcsec_east", "arcsec", "error of the vertical, turn about East", NULL},
    {"vertical_arcsec_north", "arcsec", "error of the vertical, turn about North", NULL},
    {"heading_arcsec", "arcsec", "error of the heading, clockwise", NULL},
    ORR_STUDY_COLUMNS_ENU("dynamic_position_m", "m", "dynamic part of the position error"),
    ORR_STUDY_COLUMNS_ENU("kinematic_position_m", "m", "kinematic part of the position error"),
    ORR_STUDY_COLUMNS_ENU("dynamic_velocity_mps", "m/s", "dynamic part of the absolute velocity error"),
    ORR_STUDY_COLUMNS_ENU("kinematic_velocity_mps", "m/s", "kinematic part of the absolute velocity error"),
    EACH("position_deviation_m", "m", "equations less direct difference, in their own quantities"),
    EACH("velocity_deviation_mps", "m/s", "equations less direct difference, in their own quantities"),
    EACH("attitude_deviation_arcsec", "arcsec", "equations less direct difference, in their own quantities"),
};

// --- The study ---

typedef struct work {
    const orr_cli *c;
    const orr_study_errors *study;
    const char *name[MANOEUVRES + 1];
    double *map; // [rows][M_COLUMNS]
    size_t rows;
    double *series; // [n_series][S_COLUMNS] of the first manoeuvre, size 1
    size_t n_series;
    orr_error_modes modes[2]; // of the first manoeuvre's begin as if at rest: held, free
    double duration_s[MANOEUVRES];
} work;

// All differences and solutions of one manoeuvre.
typedef struct results {
    size_t n;
    orr_error_state *direct[SIZES][ORR_ERROR_MODELS], *linear;
} results;

static bool results_make(results *r, size_t sizes, size_t n)
{
    memset(r, 0, sizeof *r);
    r->n = n;
    r->linear = calloc(n, sizeof *r->linear);
    bool fine = r->linear != NULL;
    for (size_t i = 0; i < sizes; i++)
        for (int m = 0; m < ORR_ERROR_MODELS; m++) {
            r->direct[i][m] = calloc(n, sizeof **r->direct[i]);
            fine = fine && r->direct[i][m] != NULL;
        }
    return fine;
}

static void results_free(results *r)
{
    for (size_t i = 0; i < SIZES; i++)
        for (int m = 0; m < ORR_ERROR_MODELS; m++) free(r->direct[i][m]);
    free(r->linear);
}

static orr_vec3 vector_of(const orr_real_list *l, double unit)
{
    return l->n == 0 ? orr_vec3_make(0, 0, 0)
                     : orr_vec3_make(l->item[0] * unit, l->item[1] * unit, l->item[2] * unit);
}

// Readings a step, or 0 where they are no whole number or do not divide the comparisons.
static size_t readings_of(double step_s, double rate_hz, size_t every)
{
    const double n = step_s * rate_hz, whole = nearbyint(n);
    if (whole < 1.0 || fabs(n - whole) > 1e-6 * n || whole > (double)every || every % (size_t)whole != 0)
        return 0;
    return (size_t)whole;
}

static void put3(double *to, orr_vec3 v, double unit)
{
    to[0] = v.x * unit;
    to[1] = v.y * unit;
    to[2] = v.z * unit;
}

// What the direct difference consists of, at size 1.
static void fill_series(work *w, const orr_error_flight *f, const results *r, size_t size)
{
    for (size_t k = 0; k < r->n; k++) {
        double *row = &w->series[k * S_COLUMNS];
        orr_error_point p;
        const double t = (double)(k * f->every) / f->imu->rate_hz;
        orr_error_point_at(f->tr, f->gravity, fmin(f->imu->begin_s + t, f->tr->end_s), true, &p);
        const orr_error_state *phi = &r->direct[size][ORR_ERROR_PHI][k],
                              *psi = &r->direct[size][ORR_ERROR_PSI][k],
                              *own = &r->direct[size][ORR_ERROR_DYNAMIC][k];
        const orr_vec3 absolute = orr_vec3_add(psi->velocity, orr_vec3_cross(p.earth, psi->position));
        const orr_vec3 turn = orr_error_turn_of_axes(&p, phi->position);
        row[S_T] = t;
        put3(&row[S_POSITION], psi->position, 1);
        put3(&row[S_RELATIVE], psi->velocity, 1);
        put3(&row[S_ABSOLUTE], absolute, 1);
        put3(&row[S_ATTITUDE], phi->attitude, ARCSEC_PER_RAD);
        row[S_VERTICAL] = turn.x * ARCSEC_PER_RAD;
        row[S_VERTICAL + 1] = turn.y * ARCSEC_PER_RAD;
        row[S_HEADING] = -phi->attitude.z * ARCSEC_PER_RAD;
        put3(&row[S_DYNAMIC_POSITION], own->position, 1);
        put3(&row[S_KINEMATIC_POSITION], orr_vec3_sub(psi->position, own->position), 1);
        put3(&row[S_DYNAMIC_VELOCITY], own->velocity, 1);
        put3(&row[S_KINEMATIC_VELOCITY], orr_vec3_sub(absolute, own->velocity), 1);
    }
}

static void fill_deviations(work *w, const orr_error_flight *f, const results *r, size_t size, double factor,
                            orr_error_model m, orr_error_model of)
{
    for (size_t k = 0; k < r->n; k++) {
        double *row = &w->series[k * S_COLUMNS];
        orr_error_point p;
        orr_error_point_at(f->tr, f->gravity,
                           fmin(f->imu->begin_s + (double)(k * f->every) / f->imu->rate_hz, f->tr->end_s),
                           true, &p);
        const orr_error_state *x = &r->linear[k], *d = &r->direct[size][of][k];
        row[S_LINEAR_POSITION + (int)m] = orr_vec3_norm(
            orr_vec3_sub(orr_vec3_scale(factor, orr_error_metres(m, &p, x)), orr_error_metres(of, &p, d)));
        row[S_LINEAR_VELOCITY + (int)m] =
            orr_vec3_norm(orr_vec3_sub(orr_vec3_scale(factor, x->velocity), d->velocity));
        row[S_LINEAR_ATTITUDE + (int)m] =
            orr_vec3_norm(orr_vec3_sub(orr_vec3_scale(factor, x->attitude), d->attitude)) * ARCSEC_PER_RAD;
    }
}

static bool wants(const orr_study_errors *s, int model)
{
    for (size_t k = 0; k < s->models.n; k++)
        if (s->models.item[k] == model) return true;
    return s->models.n == 0;
}

// One solution against the differences of all sizes.
static void put_rows(work *w, const orr_error_flight *f, const results *r, size_t manoeuvre, int model,
                     int method, double step_s)
{
    const orr_study_errors *study = w->study;
    const orr_error_model of =
        study->quantities == ORR_ERROR_QUANTITIES_OWN ? (orr_error_model)model : ORR_ERROR_PHI;
    for (size_t i = 0; i < study->sizes.n; i++) {
        orr_error_hold h;
        orr_error_compare(f, (orr_error_model)model, r->linear, study->sizes.item[i], of, r->direct[i][of],
                          &h);
        const double v[M_COLUMNS] = {(double)manoeuvre,    model,        method,       step_s,
                                     study->sizes.item[i], h.position_s, h.velocity_s, h.attitude_s,
                                     h.position,           h.velocity,   h.attitude};
        memcpy(&w->map[w->rows++ * M_COLUMNS], v, sizeof v);
    }
}

static orr_status solve_all(work *w, const orr_error_flight *f, results *r, size_t manoeuvre, orr_diag *diag)
{
    const orr_study_errors *study = w->study;
    orr_status s = ORR_OK;
    for (int model = 0; model < ORR_ERROR_MODELS; model++)
        for (size_t q = 0; q < study->methods.n && wants(study, model); q++)
            for (size_t k = 0; k < study->steps_s.n && s == ORR_OK; k++) {
                const size_t step = readings_of(study->steps_s.item[k], f->imu->rate_hz, f->every);
                if (step == 0)
                    return orr_diag_set(
                        diag, ORR_E_ARG,
                        "steps: %g s is no whole number of readings at %g Hz that divides the %g s of "
                        "`compare`",
                        study->steps_s.item[k], f->imu->rate_hz, (double)f->every / f->imu->rate_hz);
                s = orr_error_solve(f, (orr_error_model)model, (orr_error_method)study->methods.item[q], step,
                                    r->linear, diag);
                if (s != ORR_OK) return s;
                put_rows(w, f, r, manoeuvre, model, study->methods.item[q], study->steps_s.item[k]);
                if (manoeuvre == 0 && q == 0 && k == 0)
                    fill_deviations(w, f, r, 0, study->sizes.item[0], (orr_error_model)model,
                                    study->quantities == ORR_ERROR_QUANTITIES_OWN ? (orr_error_model)model
                                                                                  : ORR_ERROR_PHI);
            }
    return s;
}

static orr_status fly(work *w, const orr_moving *v, const orr_imu_errors *errors, size_t manoeuvre,
                      orr_diag *diag)
{
    const orr_study_errors *study = w->study;
    const orr_trajectory *tr = &v->trajectory;
    const orr_imu_request want = {.begin_s = tr->begin_s,
                                  .duration_s = tr->end_s - tr->begin_s,
                                  .rate_hz = study->rate_hz,
                                  .mode = {.approach = 2, .order = ORR_IMU_MAX_ORDER},
                                  .gravity = v->gravity};
    orr_imu imu = {0};
    orr_status s = orr_imu_generate(tr, &want, &imu, diag);
    if (s == ORR_OK) s = orr_imu_add_errors(errors, &imu, NULL, diag);
    const orr_error_flight f = {
        .tr = tr,
        .gravity = v->gravity,
        .imu = &imu,
        .position_m = vector_of(&study->initial.position_m, 1),
        .velocity_mps = vector_of(&study->initial.velocity_mps, 1),
        .attitude_rad = vector_of(&study->initial.attitude_arcsec, 1 / ARCSEC_PER_RAD),
        .hold_vertical = study->vertical == ORR_ERROR_VERTICAL_HELD,
        .round = study->gradient == ORR_ERROR_GRADIENT_ROUND,
        .every = (size_t)nearbyint((double)study->compare_ns * 1e-9 * study->rate_hz)};
    results r = {0};
    if (s == ORR_OK && (f.every == 0 || f.every > imu.n))
        s = orr_diag_set(diag, ORR_E_ARG,
                         "compare: %g s is less than a reading, or more than the flight of %g s",
                         (double)study->compare_ns * 1e-9, tr->end_s - tr->begin_s);
    if (s == ORR_OK && !results_make(&r, study->sizes.n, orr_error_comparisons(&f)))
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu comparisons", orr_error_comparisons(&f));
    for (size_t i = 0; i < study->sizes.n && s == ORR_OK; i++) {
        s = orr_error_differ(&f, study->sizes.item[i], r.direct[i], diag);
        orr_cli_progress(w->c, "navigators", i + 1, study->sizes.n);
    }
    w->duration_s[manoeuvre] = tr->end_s - tr->begin_s;
    if (s == ORR_OK && manoeuvre == 0) {
        w->n_series = r.n;
        w->series = calloc(r.n, S_COLUMNS * sizeof *w->series);
        s = w->series != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows", r.n);
        if (s == ORR_OK) fill_series(w, &f, &r, 0);
    }
    if (s == ORR_OK) s = solve_all(w, &f, &r, manoeuvre, diag);
    results_free(&r);
    orr_imu_free(&imu);
    return s;
}

// Modes of the place where the first manoeuvre begins, for a body at rest there.
static orr_status find_modes(work *w, const orr_moving *v, orr_diag *diag)
{
    orr_error_point p;
    orr_error_point_at(&v->trajectory, v->gravity, v->trajectory.begin_s,
                       w->study->gradient == ORR_ERROR_GRADIENT_ROUND, &p);
    p.v = p.transport = orr_vec3_make(0, 0, 0);
    p.f = orr_vec3_scale(-1.0, p.gravity);
    orr_status s = orr_error_modes_at(&p, true, &w->modes[0], diag);
    return s == ORR_OK ? orr_error_modes_at(&p, false, &w->modes[1], diag) : s;
}

static orr_status fly_all(work *w, orr_inputs *inputs, const orr_imu_errors *errors, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t k = 0; k < w->study->manoeuvres.n && s == ORR_OK; k++) {
        const orr_study_manoeuvre *q = &w->study->manoeuvres.item[k];
        orr_study_motion motion;
        s = orr_study_motion_open(inputs, q->scenario, q->duration_ns, &motion, diag);
        if (s == ORR_OK && k == 0) s = find_modes(w, &motion.moving, diag);
        if (s == ORR_OK) s = fly(w, &motion.moving, errors, k, diag);
        orr_study_motion_free(&motion);
    }
    return s;
}

// --- Report ---

static void print_period(const char *name, double seconds, double unit, const char *of)
{
    if (isfinite(seconds)) printf("%-10s %.4g %s\n", name, seconds / unit, of);
}

static void print_text(const work *w)
{
    print_period("Schuler", w->modes[0].schuler_s, 60, "min");
    print_period("Foucault", w->modes[0].foucault_s, 3600, "h");
    print_period("Earth", w->modes[0].earth_s, 3600, "h");
    print_period("vertical", w->modes[1].growth_s, 1, "s to grow by e, where it is free");
    printf("\nseconds until the deviation exceeds a tenth of the greatest norm so far (>: never)\n"
           "%-12s %-8s %-12s %8s %8s %10s %10s %10s\n",
           "manoeuvre", "model", "method", "step, s", "size", "position", "velocity", "attitude");
    for (size_t k = 0; k < w->rows; k++) {
        const double *r = &w->map[k * M_COLUMNS];
        printf("%-12s %-8s %-12s %8g %8g", w->name[(size_t)r[M_MANOEUVRE]], model_words[(size_t)r[M_MODEL]],
               method_words[(size_t)r[M_METHOD]], r[M_STEP], r[M_SIZE]);
        for (int i = M_POSITION; i <= M_ATTITUDE; i++) {
            const bool never =
                r[i] > w->duration_s[(size_t)r[M_MANOEUVRE]] - (double)w->study->compare_ns * 1e-9;
            printf(" %c%9.6g", never ? '>' : ' ', r[i]);
        }
        putchar('\n');
    }
}

static int print_json(const work *w)
{
    json_t *rows = json_array();
    for (size_t k = 0; k < w->rows; k++) {
        const double *r = &w->map[k * M_COLUMNS];
        json_array_append_new(
            rows, json_pack("{s:s, s:s, s:s, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f}", "manoeuvre",
                            w->name[(size_t)r[M_MANOEUVRE]], "model", model_words[(size_t)r[M_MODEL]],
                            "method", method_words[(size_t)r[M_METHOD]], "step_s", r[M_STEP], "size",
                            r[M_SIZE], "position_holds_s", r[M_POSITION], "velocity_holds_s", r[M_VELOCITY],
                            "attitude_holds_s", r[M_ATTITUDE], "position_deviation", r[M_P],
                            "velocity_deviation", r[M_V], "attitude_deviation", r[M_A]));
    }
    json_t *periods =
        json_pack("{s:o, s:o, s:o, s:o}", "schuler_s", orr_json_number(w->modes[0].schuler_s), "foucault_s",
                  orr_json_number(w->modes[0].foucault_s), "earth_s", orr_json_number(w->modes[0].earth_s),
                  "vertical_growth_s", orr_json_number(w->modes[1].growth_s));
    return orr_json_print(w->c, json_pack("{s:o, s:o}", "periods", periods, "map", rows),
                          JSON_INDENT(2) | JSON_REAL_PRECISION(9));
}

// Position's time over size, a line each manoeuvre and model, at the first method and step.
static orr_status draw(const work *w, const char *title, orr_diag *diag)
{
    enum { LINES = MANOEUVRES * ORR_ERROR_MODELS };
    const size_t sizes = w->study->sizes.n, each = w->study->methods.n * w->study->steps_s.n * sizes;
    orr_plot_line line[LINES];
    char label[LINES][48];
    double *x = calloc(w->rows, 2 * sizeof *x);
    size_t n = 0;
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu points", w->rows);
    for (size_t begin = 0; begin < w->rows && n < LINES; begin += each, n++) {
        const double *r = &w->map[begin * M_COLUMNS];
        for (size_t i = 0; i < sizes; i++) {
            x[2 * begin + i] = r[i * M_COLUMNS + M_SIZE];
            x[2 * begin + sizes + i] = r[i * M_COLUMNS + M_POSITION];
        }
        snprintf(label[n], sizeof label[n], "%s, %s", w->name[(size_t)r[M_MANOEUVRE]],
                 model_words[(size_t)r[M_MODEL]]);
        line[n] = (orr_plot_line){.label = label[n],
                                  .x = &x[2 * begin],
                                  .y = &x[2 * begin + sizes],
                                  .n = sizes,
                                  .colour = (int)r[M_MANOEUVRE],
                                  .dash = r[M_MODEL] > 0,
                                  .marks = r[M_MODEL] > 1};
    }
    const orr_plot plot = {.title = title,
                           .x_label = "size of the errors",
                           .y_label = "position holds, s",
                           .log_x = true,
                           .log_y = true,
                           .line = line,
                           .n = n};
    const orr_status s = orr_study_plot(w->c, &plot, diag);
    free(x);
    return s;
}

// The file's name without folder and ending, for a manoeuvre without one.
static const char *name_of(const orr_study_manoeuvre *q)
{
    const char *slash = strrchr(q->scenario, '/');
    return q->name != NULL ? q->name : slash != NULL ? slash + 1 : q->scenario;
}

static int make(orr_cli *c, const orr_study_errors *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    orr_sensor_errors file = {0};
    orr_imu_errors errors;
    work w = {.c = c, .study = study};
    const char *title = study->head.title != NULL ? study->head.title : "Error equations";
    const size_t most =
        study->manoeuvres.n * ORR_ERROR_MODELS * study->methods.n * study->steps_s.n * study->sizes.n;
    for (size_t k = 0; k < study->manoeuvres.n; k++) w.name[k] = name_of(&study->manoeuvres.item[k]);
    w.map = calloc(most, M_COLUMNS * sizeof *w.map);
    orr_status s = w.map != NULL ? ORR_OK : orr_diag_set(&diag, ORR_E_MEMORY, "no memory for %zu rows", most);
    if (s == ORR_OK) s = orr_errors_open(inputs, study->errors, &file, &errors, &diag);
    errors.seed = (uint64_t)study->head.seed;
    if (s == ORR_OK) s = fly_all(&w, inputs, &errors, &diag);
    const orr_study_column map_columns[M_COLUMNS] = {
        {"manoeuvre", NULL, "trajectory", w.name},
        {"model", NULL, "formulation", model_words},
        {"method", NULL, "of integration", method_words},
        {"step_s", "s", "of integration", NULL},
        {"size", NULL, "factor of all errors", NULL},
        {"position_holds_s", "s", "until the deviation exceeds a tenth of the greatest norm so far", NULL},
        {"velocity_holds_s", "s", "likewise", NULL},
        {"attitude_holds_s", "s", "likewise", NULL},
        {"position_deviation", NULL, "greatest deviation over the greatest norm", NULL},
        {"velocity_deviation", NULL, "likewise", NULL},
        {"attitude_deviation", NULL, "likewise", NULL},
    };
    const orr_study_table table[2] = {{"map", map_columns, M_COLUMNS, w.rows, w.map},
                                      {"series", series_columns, S_COLUMNS, w.n_series, w.series}};
    if (s == ORR_OK) s = orr_study_write(c, title, inputs, table, 2, &diag);
    if (s == ORR_OK) s = orr_study_write_series(c, &table[1], &diag);
    if (s == ORR_OK) s = draw(&w, title, &diag);
    int status = ORR_EXIT_OK;
    if (s != ORR_OK)
        status = orr_cli_fail(c, &diag);
    else if (orr_cli_says(c, "format", "json"))
        status = print_json(&w);
    else if (!orr_study_to_stdout(c))
        print_text(&w);
    free(w.map);
    free(w.series);
    orr_sensor_errors_free(&file);
    return status;
}

static int run(orr_cli *c)
{
    orr_study_errors study;
    orr_inputs inputs = {0};
    bool go;
    int status = orr_cli_study_open(c, &orr_study_errors_schema, &study, &inputs, &go);
    if (!go) return status;
    status = make(c, &study, &inputs);
    orr_schema_free(&orr_study_errors_schema, &study);
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {
    ORR_STUDY_OPTIONS,
    ORR_OPTION_SERIES(.help = "The first manoeuvre over time, at the first size, method and step (CSV): "
                              "errors in full, dynamic and "
                              "kinematic parts, absolute and relative velocity, attitude, vertical and "
                              "heading, and how far "
                              "the equations are off."),
};

const orr_command orr_cmd_error_equations = {
    .name = "error-equations",
    .group = "Inertial studies",
    .summary = "linear error equations against the navigator's own errors",
    .operands = "STUDY.yaml",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Solves error equations in three formulations (phi, psi, and the dynamic and kinematic parts of "
             "the source) along "
             "true trajectories, and compares them with the direct difference between the truth and a "
             "navigator on readings with "
             "errors, each in the quantities that it propagates. The map says how long each stands for the "
             "difference, over size "
             "of the errors, step, method and manoeuvre.\n\n"
             "Periods of Schuler, Foucault and the Earth are told from the eigenvalues at the begin of the "
             "first manoeuvre.",
    .example = "orrery error-equations samples/studies/error-equations.yaml --plot map.svg -o map.csv --csv "
               "series.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

// SPDX-License-Identifier: GPL-3.0-or-later
// orrery aiding: what stands beside inertial units, with errors and truth.
#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/nan.h"
#include "inertial/study/auxiliary.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/study.h"
#include "src/config/study_aiding.h"
#include "src/make/products.h"

enum { V = 3, C = 6 };
enum {
    A_T,
    A_HEIGHT,
    A_TRUE_HEIGHT,
    A_PRESSURE,
    A_FIELD,
    A_TRUE_FIELD = A_FIELD + V,
    A_SPEED = A_TRUE_FIELD + V,
    A_TRUE_SPEED,
    A_DISTANCE,
    A_HEADING,
    A_HEADING_SIGMA,
    A_TRUE_HEADING,
    A_PITCH,
    A_TRUE_PITCH,
    A_SATELLITES,
    A_POSITION,
    A_VELOCITY = A_POSITION + V,
    A_POSITION_ERROR = A_VELOCITY + V,
    A_VELOCITY_ERROR = A_POSITION_ERROR + V,
    A_POSITION_COVARIANCE = A_VELOCITY_ERROR + V,
    A_VELOCITY_COVARIANCE = A_POSITION_COVARIANCE + C,
    COLUMNS = A_VELOCITY_COVARIANCE + C
};
#define THREE(a, b, c, unit, help)                                                                           \
    {a, unit, help, NULL}, {b, unit, help, NULL}, { c, unit, help, NULL }
#define SIX(name, unit, help)                                                                                \
    {name "_ee", unit, help ", East East", NULL}, {name "_nn", unit, help ", North North", NULL},            \
        {name "_uu", unit, help ", up up", NULL}, {name "_en", unit, help ", East North", NULL},             \
        {name "_eu", unit, help ", East up", NULL},                                                          \
    {                                                                                                        \
        name "_nu", unit, help ", North up", NULL                                                            \
    }
static const orr_study_column all[COLUMNS] = {
    {"t_s", "s", "after the trajectory's begin", NULL},
    {"baro_height_m", "m", "above the ellipsoid, by pressure", NULL},
    {"true_height_m", "m", "above the ellipsoid", NULL},
    {"baro_pressure_hpa", "hPa", "that the standard atmosphere has at baro_height_m", NULL},
    THREE("mag_x_nt", "mag_y_nt", "mag_z_nt", "nT", "field, body axes: right, forward, up"),
    THREE("true_mag_x_nt", "true_mag_y_nt", "true_mag_z_nt", "nT", "field of the Earth, body axes"),
    {"odo_speed_mps", "m/s", "forward", NULL},
    {"true_speed_mps", "m/s", "forward, of the wheel", NULL},
    {"odo_distance_m", "m", "sum of pulses", NULL},
    {"ant_heading_deg", "deg", "of the baseline, clockwise from North", NULL},
    {"ant_heading_sigma_deg", "deg", "standard deviation", NULL},
    {"true_ant_heading_deg", "deg", "of the baseline", NULL},
    {"ant_pitch_deg", "deg", "of the baseline", NULL},
    {"true_ant_pitch_deg", "deg", "of the baseline", NULL},
    {"gnss_satellites", NULL, "that are seen", NULL},
    THREE("gnss_x_m", "gnss_y_m", "gnss_z_m", "m", "position of the antenna, ecef"),
    THREE("gnss_vx_mps", "gnss_vy_mps", "gnss_vz_mps", "m/s", "velocity of the antenna, ecef"),
    THREE("gnss_error_east_m", "gnss_error_north_m", "gnss_error_up_m", "m", "error of the position"),
    THREE("gnss_error_east_mps", "gnss_error_north_mps", "gnss_error_up_mps", "m/s", "error of the velocity"),
    SIX("gnss_cov_m2", "m2", "covariance of the position"),
    SIX("gnss_cov_m2ps2", "m2/s2", "covariance of the velocity"),
};

// Columns of each sensor; time is always there.
typedef struct sensor {
    size_t from, to;
} sensor;
static const sensor sensors[] = {{A_HEIGHT, A_FIELD},
                                 {A_FIELD, A_SPEED},
                                 {A_SPEED, A_HEADING},
                                 {A_HEADING, A_SATELLITES},
                                 {A_SATELLITES, COLUMNS}};
enum { SENSORS = sizeof sensors / sizeof sensors[0] };

typedef struct rows {
    double *value; // [n][COLUMNS]
    size_t n;
} rows;

static void put3(double *to, orr_vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}
static void put6(double *to, const orr_mat3 *m)
{
    const double v[C] = {m->m[0][0], m->m[1][1], m->m[2][2], m->m[0][1], m->m[0][2], m->m[1][2]};
    for (int i = 0; i < C; i++) to[i] = v[i];
}

typedef struct row {
    double v[COLUMNS];
} row;

static orr_status put_sample(void *user, const orr_aux_sample *s)
{
    rows *t = user;
    row *list = (row *)(void *)t->value;
    if (!ORR_ARRAY_GROW(list, t->n)) return ORR_E_MEMORY;
    t->value = (double *)list;
    double *r = list[t->n++].v;
    r[A_T] = s->t_s;
    r[A_HEIGHT] = s->height_m;
    r[A_TRUE_HEIGHT] = s->true_height_m;
    r[A_PRESSURE] = s->pressure_hpa;
    put3(&r[A_FIELD], s->field_nt);
    put3(&r[A_TRUE_FIELD], s->true_field_nt);
    r[A_SPEED] = s->speed_mps;
    r[A_TRUE_SPEED] = s->true_speed_mps;
    r[A_DISTANCE] = s->distance_m;
    r[A_HEADING] = s->heading_rad * ORR_DEG_PER_RAD;
    r[A_HEADING_SIGMA] = s->heading_sigma_rad * ORR_DEG_PER_RAD;
    r[A_TRUE_HEADING] = s->true_heading_rad * ORR_DEG_PER_RAD;
    r[A_PITCH] = s->pitch_rad * ORR_DEG_PER_RAD;
    r[A_TRUE_PITCH] = s->true_pitch_rad * ORR_DEG_PER_RAD;
    r[A_SATELLITES] = (double)s->satellites;
    put3(&r[A_POSITION], s->position_m);
    put3(&r[A_VELOCITY], s->velocity_mps);
    put3(&r[A_POSITION_ERROR], s->position_error_m);
    put3(&r[A_VELOCITY_ERROR], s->velocity_error_mps);
    put6(&r[A_POSITION_COVARIANCE], &s->position_covariance);
    put6(&r[A_VELOCITY_COVARIANCE], &s->velocity_covariance);
    return ORR_OK;
}

// --- From the file to the library, in SI ---

static orr_aux_error error_of(const orr_aiding_error *e, double unit)
{
    return (orr_aux_error){e->bias * unit, e->bias_sigma * unit, e->sigma * unit, e->time_s, e->white * unit};
}
static orr_vec3 three(const orr_real_list *l, orr_vec3 otherwise)
{
    return l->n == 0 ? otherwise : orr_vec3_make(l->item[0], l->item[1], l->item[2]);
}
static orr_mat3 soft_of(const orr_real_list *l)
{
    orr_mat3 m = {{{0}}};
    for (size_t i = 0; i < 3 && l->n > 0; i++)
        for (size_t k = 0; k < 3; k++)
            if (l->n == 9 || i == k) m.m[i][k] = 1e-6 * l->item[l->n == 9 ? 3 * i + k : l->n == 3 ? i : 0];
    return m;
}

// Satellites of a product; numbers are their places in its list.
static size_t product_sky(void *user, orr_time t, orr_vec3 *r_m, int *number)
{
    const orr_ephemeris *e = user;
    const orr_sat *list;
    const size_t n = orr_ephemeris_satellites(e, &list);
    size_t found = 0;
    for (size_t k = 0; k < n && k < ORR_AUX_SATELLITES; k++) {
        orr_sat_state s;
        if (orr_ephemeris_eval(e, list[k], t, &s) != ORR_OK) continue;
        r_m[found] = s.pos_m;
        number[found++] = (int)k;
    }
    return found;
}

typedef struct parts {
    orr_aux_barometer barometer;
    orr_aux_magnetometer magnetometer;
    orr_aux_odometer odometer;
    orr_aux_antennas antennas;
    orr_aux_receiver receiver;
    orr_magnetic *model;
    orr_ephemeris *orbit;
} parts;

static orr_status open_parts(const orr_study_aiding *s, orr_inputs *inputs, parts *p, orr_diag *diag)
{
    const orr_vec3 none = {0, 0, 0};
    orr_status status = ORR_OK;
    if (s->magnetometer.model != NULL)
        status = orr_magnetic_open(s->magnetometer.model, s->magnetometer.folder, &p->model, diag);
    if (status == ORR_OK && s->receiver.orbit != NULL) {
        status = orr_product_load(s->receiver.orbit, &p->orbit, diag);
        if (status == ORR_OK) status = orr_inputs_note(inputs, s->receiver.orbit, diag);
    }
    p->barometer = (orr_aux_barometer){error_of(&s->barometer.error, 1), s->barometer.scale_ppm * 1e-6,
                                       s->barometer.lag_s};
    p->magnetometer =
        (orr_aux_magnetometer){p->model, three(&s->magnetometer.hard_nt, none),
                               soft_of(&s->magnetometer.soft_ppm), error_of(&s->magnetometer.error, 1)};
    p->odometer = (orr_aux_odometer){three(&s->odometer.arm_m, none), s->odometer.scale_ppm * 1e-6,
                                     s->odometer.quantum_m, error_of(&s->odometer.error, 1)};
    p->antennas =
        (orr_aux_antennas){three(&s->antennas.baseline_m, orr_vec3_make(0, 1, 0)), s->antennas.across_m,
                           s->antennas.up_m, error_of(&s->antennas.error, ORR_RAD_PER_DEG)};
    p->receiver = (orr_aux_receiver){three(&s->receiver.arm_m, none),
                                     s->receiver.mask_deg * ORR_RAD_PER_DEG,
                                     s->receiver.range_m,
                                     s->receiver.rate_mps,
                                     s->receiver.sigma_m,
                                     s->receiver.time_s};
    return status;
}

static orr_status observe(const orr_study_aiding *s, const orr_study_motion *motion, const parts *p,
                          rows *out, orr_diag *diag)
{
    const orr_moving *v = &motion->moving;
    if ((size_t)s->unit >= v->n_units)
        return orr_diag_set(diag, ORR_E_ARG, "unit: there is no unit %lld; the scenario has 0 to %zu",
                            (long long)s->unit, v->n_units - 1);
    const orr_trajectory *tr = orr_moving_unit(v, (size_t)s->unit);
    const orr_aux_plan plan = {.tr = tr,
                               .begin_s = tr->begin_s,
                               .duration_s = tr->end_s - tr->begin_s,
                               .rate_hz = s->rate_hz,
                               .seed = (uint64_t)s->head.seed,
                               .barometer = s->has_barometer ? &p->barometer : NULL,
                               .magnetometer = s->has_magnetometer ? &p->magnetometer : NULL,
                               .odometer = s->has_odometer ? &p->odometer : NULL,
                               .antennas = s->has_antennas ? &p->antennas : NULL,
                               .receiver = s->has_receiver ? &p->receiver : NULL,
                               .sky = p->orbit != NULL ? product_sky : orr_aux_nominal_sky,
                               .sky_user = p->orbit};
    const orr_status status = orr_auxiliary(&plan, put_sample, out, diag);
    return status != ORR_E_MEMORY ? status : orr_diag_set(diag, status, "no memory for %zu samples", out->n);
}

// --- Report ---

static double spread(const rows *t, int column, int truth, double turn)
{
    double sum = 0.0;
    size_t n = 0;
    for (size_t k = 0; k < t->n; k++) {
        const double *r = &t->value[k * COLUMNS];
        const double d = truth < 0 ? r[column] : r[column] - r[truth], e = turn > 0 ? remainder(d, turn) : d;
        if (!isfinite(e)) continue;
        sum += e * e;
        n++;
    }
    return n > 0 ? sqrt(sum / (double)n) : ORR_NAN;
}

static const struct {
    const char *name, *unit;
    int column, truth;
    double turn;
} told[] = {{"barometric height", "m", A_HEIGHT, A_TRUE_HEIGHT, 0},
            {"field, right", "nT", A_FIELD, A_TRUE_FIELD, 0},
            {"field, forward", "nT", A_FIELD + 1, A_TRUE_FIELD + 1, 0},
            {"field, up", "nT", A_FIELD + 2, A_TRUE_FIELD + 2, 0},
            {"odometer", "m/s", A_SPEED, A_TRUE_SPEED, 0},
            {"two-antenna heading", "deg", A_HEADING, A_TRUE_HEADING, 360},
            {"position, East", "m", A_POSITION_ERROR, -1, 0},
            {"position, North", "m", A_POSITION_ERROR + 1, -1, 0},
            {"position, up", "m", A_POSITION_ERROR + 2, -1, 0},
            {"velocity, East", "m/s", A_VELOCITY_ERROR, -1, 0},
            {"velocity, North", "m/s", A_VELOCITY_ERROR + 1, -1, 0},
            {"velocity, up", "m/s", A_VELOCITY_ERROR + 2, -1, 0}};

static int report(const orr_cli *c, const rows *t)
{
    const bool json = orr_cli_says(c, "format", "json");
    if (!json && orr_study_to_stdout(c)) return ORR_EXIT_OK;
    json_t *j = json_object();
    if (!json) printf("%zu samples; errors r.m.s.\n", t->n);
    for (size_t k = 0; k < sizeof told / sizeof told[0]; k++) {
        const double rms = spread(t, told[k].column, told[k].truth, told[k].turn);
        if (!isfinite(rms)) continue;
        if (json)
            json_object_set_new(j, told[k].name,
                                json_pack("{s:o, s:s}", "rms", orr_json_number(rms), "unit", told[k].unit));
        else
            printf("%-20s %.4g %s\n", told[k].name, rms, told[k].unit);
    }
    if (json) return orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    json_decref(j);
    return ORR_EXIT_OK;
}

// Columns of the sensors that are there, packed.
static orr_status write(const orr_cli *c, const orr_study_aiding *s, const char *title,
                        const orr_inputs *inputs, const rows *t, orr_diag *diag)
{
    const bool has[SENSORS] = {s->has_barometer, s->has_magnetometer, s->has_odometer, s->has_antennas,
                               s->has_receiver};
    orr_study_column column[COLUMNS] = {all[A_T]};
    size_t index[COLUMNS] = {A_T}, n = 1;
    for (size_t k = 0; k < SENSORS; k++)
        for (size_t i = sensors[k].from; has[k] && i < sensors[k].to; i++) {
            column[n] = all[i];
            index[n++] = i;
        }
    double *v = malloc((t->n + 1) * n * sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu samples", t->n);
    for (size_t k = 0; k < t->n; k++)
        for (size_t i = 0; i < n; i++) v[k * n + i] = t->value[k * COLUMNS + index[i]];
    const orr_study_table table = {"sample", column, n, t->n, v};
    const orr_status status = orr_study_write(c, title, inputs, &table, 1, diag);
    free(v);
    return status;
}

// Errors over their own r.m.s., side by side.
static orr_status draw(const orr_cli *c, const char *title, const rows *t, orr_diag *diag)
{
    enum { LINES = sizeof told / sizeof told[0] };
    orr_plot_line line[LINES];
    double *x = malloc((1 + LINES) * (t->n + 1) * sizeof *x);
    size_t n = 0;
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu points", t->n);
    for (size_t k = 0; k < t->n; k++) x[k] = t->value[k * COLUMNS + A_T];
    for (size_t i = 0; i < LINES; i++) {
        const double rms = spread(t, told[i].column, told[i].truth, told[i].turn);
        if (!(rms > 0.0)) continue;
        double *y = x + (1 + n) * t->n;
        for (size_t k = 0; k < t->n; k++) {
            const double *r = &t->value[k * COLUMNS];
            const double d = told[i].truth < 0 ? r[told[i].column] : r[told[i].column] - r[told[i].truth];
            y[k] = (told[i].turn > 0 ? remainder(d, told[i].turn) : d) / rms + 8.0 * (double)n;
        }
        line[n] = (orr_plot_line){.label = told[i].name, .x = x, .y = y, .n = t->n, .colour = (int)n};
        n++;
    }
    const orr_plot plot = {.title = title,
                           .x_label = "t, s",
                           .y_label = "errors over their r.m.s., each 8 higher",
                           .line = line,
                           .n = n};
    const orr_status s = orr_study_plot(c, &plot, diag);
    free(x);
    return s;
}

static int make(orr_cli *c, const orr_study_aiding *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    orr_study_motion motion = {0};
    parts p = {0};
    rows t = {0};
    const char *title = study->head.title != NULL ? study->head.title : "Auxiliary outputs";
    orr_status s = orr_study_motion_open(inputs, study->scenario, study->duration_ns, &motion, &diag);
    if (s == ORR_OK) s = open_parts(study, inputs, &p, &diag);
    if (s == ORR_OK) s = observe(study, &motion, &p, &t, &diag);
    if (s == ORR_OK) s = write(c, study, title, inputs, &t, &diag);
    if (s == ORR_OK) s = draw(c, title, &t, &diag);
    const int status = s == ORR_OK ? report(c, &t) : orr_cli_fail(c, &diag);
    free(t.value);
    orr_magnetic_free(p.model);
    orr_ephemeris_free(p.orbit);
    orr_study_motion_free(&motion);
    return status;
}

static int run(orr_cli *c)
{
    orr_study_aiding study;
    orr_inputs inputs = {0};
    bool go;
    int status = orr_cli_study_open(c, &orr_study_aiding_schema, &study, &inputs, &go);
    if (!go) return status;
    status = make(c, &study, &inputs);
    orr_schema_free(&orr_study_aiding_schema, &study);
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {ORR_STUDY_OPTIONS};

const orr_command orr_cmd_aiding = {
    .name = "aiding",
    .group = "Inertial studies",
    .summary = "barometer, magnetometer, odometer, antennas and receiver on a trajectory",
    .operands = "STUDY.yaml",
    .min_operands = 0,
    .max_operands = 1,
    .about = "What stands beside inertial units, each with bias and noise and with its truth: height by "
             "pressure, the Earth's field, speed "
             "and way of a wheel, heading of two antennas, and a satellite receiver's position and velocity "
             "with the covariance of "
             "its geometry.",
    .example = "orrery aiding samples/studies/aiding.yaml -o aiding.csv --plot aiding.svg",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer alignment: many draws of both units' errors on one flight, the first of them as a data set.
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/sense/sensors.h"
#include "inertial/study/flexure.h"
#include "inertial/study/transfer_alignment.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/alignment.h"

#define ARCMIN_PER_RAD (ORR_DEG_PER_RAD * 60.0)
#define SEEN 0.5 // of the heading's standard deviation at the start is what counts as seen

enum { V = 3 };
enum {
    D_SEED,
    D_NEES,
    D_ATTITUDE,
    D_VELOCITY = D_ATTITUDE + V,
    D_WHITENESS = D_VELOCITY + V,
    D_RESIDUAL = D_WHITENESS + V,
    D_COLUMNS = D_RESIDUAL + V
};
#define XYZ(name, unit, help)                                                                                \
    {name "_x", unit, help ", right", NULL}, {name "_y", unit, help ", forward", NULL},                      \
    {                                                                                                        \
        name "_z", unit, help ", up", NULL                                                                   \
    }
static const orr_study_column draw_columns[D_COLUMNS] = {
    {"seed", NULL, "of the draw", NULL},
    {"nees", NULL, "normalised squared error of attitude and velocity at the end, chi-square of 6", NULL},
    ORR_STUDY_COLUMNS_ENU("attitude_arcmin", "arcmin", "error left, turn about"),
    ORR_STUDY_COLUMNS_ENU("velocity_mps", "m/s", "error left"),
    XYZ("correlation", NULL, "of the residuals over one interval, first unit's axes"),
    XYZ("residual_rms", NULL, "of the residuals in their standard deviations, first unit's axes"),
};

enum {
    T_T,
    T_ATTITUDE,
    T_ATTITUDE_SIGMA = T_ATTITUDE + V,
    T_VELOCITY = T_ATTITUDE_SIGMA + V,
    T_VELOCITY_SIGMA = T_VELOCITY + V,
    T_RESIDUAL = T_VELOCITY_SIGMA + V,
    T_COLUMNS = T_RESIDUAL + V
};
static const orr_study_column track_columns[T_COLUMNS] = {
    {"t_s", "s", "after the trajectory's begin", NULL},
    ORR_STUDY_COLUMNS_ENU("attitude_arcmin", "arcmin", "error, turn about"),
    ORR_STUDY_COLUMNS_ENU("attitude_sigma_arcmin", "arcmin", "its standard deviation by the filter"),
    ORR_STUDY_COLUMNS_ENU("velocity_mps", "m/s", "error"),
    ORR_STUDY_COLUMNS_ENU("velocity_sigma_mps", "m/s", "its standard deviation by the filter"),
    XYZ("residual", NULL, "of the measurement, in its standard deviations, first unit's axes"),
};

enum {
    U_T,
    U_DTHETA,
    U_DV = U_DTHETA + V,
    U_ANGLES = U_DV + V,
    U_PLACE = U_ANGLES + V,
    U_SPEED = U_PLACE + V,
    U_COLUMNS = U_SPEED + V
};
static const orr_study_column unit_columns[U_COLUMNS] = {
    {"t_s", "s", "end of the reading's step", NULL},
    XYZ("measured_dtheta_rad", "rad", "increment"),
    XYZ("measured_dv_mps", "m/s", "increment"),
    {"heading_deg", "deg", "truth at t_s", NULL},
    {"pitch_deg", "deg", "truth at t_s", NULL},
    {"roll_deg", "deg", "truth at t_s", NULL},
    {"lat_deg", "deg", "truth at t_s", NULL},
    {"lon_deg", "deg", "truth at t_s", NULL},
    {"height_m", "m", "truth at t_s", NULL},
    ORR_STUDY_COLUMNS_ENU("velocity_mps", "m/s", "truth at t_s"),
};

typedef struct work {
    const orr_study_alignment *study;
    orr_transfer_plan plan;
    orr_trajectory flexed;
    orr_imu imu[2];
    orr_imu_errors errors[2];
    orr_sensor_errors file[2];
    double *draws, *track, *unit[2];
    size_t n_track, at;
    double heading_seen; // standard deviation at the end over that at the start
} work;

static void put3(double *to, orr_vec3 v, double unit)
{
    to[0] = v.x * unit;
    to[1] = v.y * unit;
    to[2] = v.z * unit;
}

static orr_vec3 three(const orr_real_list *l, double unit, orr_vec3 otherwise)
{
    return orr_vec3_scale(unit, l->n == 0 ? otherwise : orr_vec3_make(l->item[0], l->item[1], l->item[2]));
}

static void put_point(void *user, const orr_transfer_point *p)
{
    work *w = user;
    if (w->at >= w->n_track) return;
    double *row = &w->track[w->at++ * T_COLUMNS];
    row[T_T] = p->t_s;
    put3(&row[T_ATTITUDE], p->attitude_rad, ARCMIN_PER_RAD);
    put3(&row[T_ATTITUDE_SIGMA], p->attitude_sigma_rad, ARCMIN_PER_RAD);
    put3(&row[T_VELOCITY], p->velocity_mps, 1.0);
    put3(&row[T_VELOCITY_SIGMA], p->velocity_sigma_mps, 1.0);
    put3(&row[T_RESIDUAL], p->residual, 1.0);
}

static void put_unit(const orr_imu *m, double *table)
{
    for (size_t j = 0; j < m->n; j++) {
        double *row = &table[j * U_COLUMNS];
        const orr_motion truth = {.r_m = m->r_m[j + 1], .v_mps = m->v_mps[j + 1], .q_be = m->q_be[j + 1]};
        const orr_angles a = orr_motion_angles(&truth);
        const orr_geodetic g = orr_earth_from_ecef(truth.r_m);
        row[U_T] = orr_imu_edge_s(m, j + 1);
        put3(&row[U_DTHETA], m->measured_dtheta_rad[j], 1.0);
        put3(&row[U_DV], m->measured_dv_mps[j], 1.0);
        put3(&row[U_ANGLES], orr_vec3_make(a.heading_rad, a.pitch_rad, a.roll_rad), ORR_DEG_PER_RAD);
        put3(&row[U_PLACE],
             orr_vec3_make(g.lat_rad * ORR_DEG_PER_RAD, g.lon_rad * ORR_DEG_PER_RAD, g.height_m), 1.0);
        put3(&row[U_SPEED], orr_motion_velocity_enu(&truth), 1.0);
    }
}

// Ideal readings of both units; a bending arm bends in another way each time.
static orr_status read_units(work *w, const orr_moving *v, int64_t draw, orr_diag *diag)
{
    const orr_study_transfer *t = &w->study->transfer;
    orr_transfer_plan *p = &w->plan;
    const orr_flexure bends = {t->flexure.sigma_arcmin / ARCMIN_PER_RAD, t->flexure.rate_radps,
                               (uint64_t)(w->study->head.seed + draw)};
    const bool bent = bends.sigma_rad > 0.0;
    if (draw > 0 && !bent) return ORR_OK;
    orr_status s = ORR_OK;
    if (bent) {
        orr_trajectory_free(&w->flexed);
        s = orr_trajectory_flexed(&v->trajectory, &p->mounting, &bends, &w->flexed, diag);
        p->second_tr = &w->flexed;
        p->flexure_mps = orr_flexure_velocity_mps(&bends, p->mounting.arm_m);
    }
    for (int k = 0; k < 2 && s == ORR_OK; k++) {
        const orr_trajectory *tr = k == 0 ? p->first_tr : p->second_tr;
        const orr_imu_request want = {.begin_s = tr->begin_s,
                                      .duration_s = tr->end_s - tr->begin_s,
                                      .rate_hz = v->rate_hz,
                                      .mode = {.approach = 2, .order = 3},
                                      .gravity = v->gravity};
        if (draw > 0 && k == 0) continue;
        orr_imu_free(&w->imu[k]);
        s = orr_imu_generate(tr, &want, &w->imu[k], diag);
    }
    return s;
}

// The flight's two trajectories and ideal readings, and what the filter is told.
static orr_status prepare(work *w, const orr_study_motion *motion, orr_diag *diag)
{
    const orr_study_transfer *t = &w->study->transfer;
    const orr_moving *v = &motion->moving;
    if ((size_t)t->unit >= v->n_units)
        return orr_diag_set(diag, ORR_E_ARG,
                            "transfer.unit: there is no unit %lld; the scenario has units 0 to %zu",
                            (long long)t->unit, v->n_units - 1);
    const orr_scenario_unit *u = &motion->scenario.motion.units.item[t->unit - 1];
    orr_transfer_plan *p = &w->plan;
    p->mounting = (orr_mounting){
        {u->right_m, u->forward_m, u->up_m},
        orr_body_from_enu((orr_angles){u->heading_deg * ORR_RAD_PER_DEG, u->pitch_deg * ORR_RAD_PER_DEG,
                                       u->roll_deg * ORR_RAD_PER_DEG})};
    p->first_tr = &v->trajectory;
    p->second_tr = orr_moving_unit(v, (size_t)t->unit);
    p->gravity = v->gravity;
    p->interval = (size_t)nearbyint((double)t->interval_ns * 1e-9 * v->rate_hz);
    p->velocity_noise_mps = t->velocity_noise_mps;
    p->start_velocity_mps = t->start_velocity_mps;
    p->mounting_sigma_rad = three(&t->mounting_deg, ORR_RAD_PER_DEG, orr_vec3_make(0.3, 0.3, 1.0));
    p->first_attitude_rad =
        three(&t->first_attitude_arcsec, ORR_RAD_PER_DEG / 3600.0, orr_vec3_make(0, 0, 0));
    p->gyro = orr_transfer_noise_of(&w->errors[0].gyro, &w->errors[1].gyro);
    p->accel = orr_transfer_noise_of(&w->errors[0].accel, &w->errors[1].accel);
    p->first = &w->imu[0];
    p->second = &w->imu[1];
    return read_units(w, v, 0, diag);
}

static orr_status make_room(work *w, orr_diag *diag)
{
    const size_t n = w->imu[0].n;
    w->n_track = w->plan.interval > 0 ? n / w->plan.interval + 1 : 1;
    w->draws = calloc((size_t)w->study->seeds, D_COLUMNS * sizeof *w->draws);
    w->track = calloc(w->n_track, T_COLUMNS * sizeof *w->track);
    for (int k = 0; k < 2; k++) w->unit[k] = calloc(n, U_COLUMNS * sizeof *w->unit[k]);
    if (w->draws != NULL && w->track != NULL && w->unit[0] != NULL && w->unit[1] != NULL) return ORR_OK;
    return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu readings of two units", n);
}

static orr_status align(const orr_cli *c, work *w, const orr_moving *v, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (int64_t k = 0; k < w->study->seeds && s == ORR_OK; k++) {
        const uint64_t seed = (uint64_t)(w->study->head.seed + k);
        if (k > 0) s = read_units(w, v, k, diag);
        for (int u = 0; u < 2 && s == ORR_OK; u++) {
            w->errors[u].seed = 2 * seed + (uint64_t)u;
            s = orr_imu_add_errors(&w->errors[u], &w->imu[u], NULL, diag);
            if (s == ORR_OK && k == 0) put_unit(&w->imu[u], w->unit[u]);
        }
        orr_transfer_result r;
        w->plan.seed = seed;
        if (s == ORR_OK) s = orr_transfer_align(&w->plan, k == 0 ? put_point : NULL, w, &r, diag);
        if (s != ORR_OK) return s;
        double *row = &w->draws[k * D_COLUMNS];
        row[D_SEED] = (double)seed;
        row[D_NEES] = r.nees;
        put3(&row[D_ATTITUDE], r.last.attitude_rad, ARCMIN_PER_RAD);
        put3(&row[D_VELOCITY], r.last.velocity_mps, 1.0);
        memcpy(&row[D_WHITENESS], r.whiteness, sizeof r.whiteness);
        memcpy(&row[D_RESIDUAL], r.residual_rms, sizeof r.residual_rms);
        w->heading_seen = r.first.attitude_sigma_rad.z > 0
                              ? r.last.attitude_sigma_rad.z / r.first.attitude_sigma_rad.z
                              : 1.0;
        orr_cli_progress(c, "alignments", (size_t)k + 1, (size_t)w->study->seeds);
    }
    return s;
}

static double mean_of(const work *w, int column, int n, bool squared)
{
    double sum = 0.0;
    for (int64_t k = 0; k < w->study->seeds; k++)
        for (int i = 0; i < n; i++) {
            const double v = w->draws[k * D_COLUMNS + column + i];
            sum += squared ? v * v : v;
        }
    return sum / (double)(w->study->seeds * n);
}

// What the filter does not know of the second unit's sensors.
static const char *unknown_of(const orr_imu_errors *e)
{
    const orr_triad_errors *const triad[2] = {&e->gyro, &e->accel};
    for (int k = 0; k < 2; k++) {
        const orr_triad_errors *t = triad[k];
        double sum = t->scale_sigma + t->cross_sigma + t->quantum;
        for (int i = 0; i < 3; i++)
            sum += fabs(t->bias[i]) + fabs(t->scale[i]) + fabs(t->asymmetry[i]) + fabs(t->quadratic[i]) +
                   t->walk[i] + fabs(t->ramp[i]) + fabs(t->by_force[i][i]);
        if (sum > 0.0 || t->n_processes > 1) return k == 0 ? "gyros" : "accelerometers";
    }
    return NULL;
}

static int report(const orr_cli *c, const work *w)
{
    const double n = (double)w->study->seeds, dof = 6.0 * n, nees = mean_of(w, D_NEES, 1, false);
    const double low = gsl_cdf_chisq_Pinv(0.005, dof) / n, high = gsl_cdf_chisq_Qinv(0.005, dof) / n;
    const double white = mean_of(w, D_WHITENESS, V, false), size = sqrt(mean_of(w, D_RESIDUAL, V, true));
    const double heading = sqrt(mean_of(w, D_ATTITUDE + 2, 1, true)),
                 tilt = sqrt(mean_of(w, D_ATTITUDE, 2, true));
    const double one = 1.0 / sqrt(3.0 * n * (double)(w->n_track - 1));
    if (orr_cli_says(c, "format", "json")) {
        json_t *j = json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:b}", "nees",
                              orr_json_number(nees), "nees_low", orr_json_number(low), "nees_high",
                              orr_json_number(high), "residual_rms", orr_json_number(size),
                              "residual_correlation", orr_json_number(white), "residual_correlation_sigma",
                              orr_json_number(one), "tilt_rms_arcmin", orr_json_number(tilt),
                              "heading_rms_arcmin", orr_json_number(heading), "heading_sigma_left",
                              orr_json_number(w->heading_seen), "heading_observed", w->heading_seen < SEEN);
        return orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    }
    const char *unknown = unknown_of(&w->errors[1]);
    if (unknown != NULL)
        orr_cli_say(c,
                    "the second unit's %s have errors that the filter does not know (scale, mounting, "
                    "constants, walks): expect a larger "
                    "normalised squared error",
                    unknown);
    if (orr_study_to_stdout(c)) return ORR_EXIT_OK;
    printf("%lld alignments by %zu measurements each\n", (long long)w->study->seeds, w->n_track - 1);
    printf("left at the end     tilt %.3g arcmin, heading %.3g arcmin r.m.s.\n", tilt, heading);
    printf("normalised square   %.2f of 6; 99 %% of filters that know themselves: %.2f to %.2f\n", nees, low,
           high);
    printf("residuals           %.4f of their standard deviation; correlation %+.4f, of white ones %.4f\n",
           size, white, one);
    if (w->heading_seen < SEEN)
        printf("heading             its standard deviation falls to %.2g of that at the start\n",
               w->heading_seen);
    else
        printf("heading             NOT OBSERVED: %.0f %% of its standard deviation at the start are left. "
               "Velocity shows the "
               "heading in horizontal acceleration alone: turn, or change speed\n",
               100.0 * w->heading_seen);
    return ORR_EXIT_OK;
}

static orr_status draw(const orr_cli *c, const work *w, const char *title, orr_diag *diag)
{
    enum { LINES = 4 };
    double *x = calloc(w->n_track, (1 + LINES) * sizeof *x);
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu points", w->n_track);
    static const struct {
        const char *label;
        int column;
    } of[LINES] = {{"heading error", T_ATTITUDE + 2},
                   {"heading sigma", T_ATTITUDE_SIGMA + 2},
                   {"tilt error, East", T_ATTITUDE},
                   {"tilt sigma, East", T_ATTITUDE_SIGMA}};
    orr_plot_line line[LINES];
    for (size_t k = 0; k < w->n_track; k++) {
        x[k] = w->track[k * T_COLUMNS + T_T];
        for (size_t i = 0; i < LINES; i++)
            x[(1 + i) * w->n_track + k] = fabs(w->track[k * T_COLUMNS + (size_t)of[i].column]);
    }
    for (size_t i = 0; i < LINES; i++)
        line[i] = (orr_plot_line){.label = of[i].label,
                                  .x = x,
                                  .y = x + (1 + i) * w->n_track,
                                  .n = w->n_track,
                                  .colour = (int)i / 2,
                                  .dash = i % 2};
    const orr_plot plot = {
        .title = title, .x_label = "t, s", .y_label = "arcmin", .log_y = true, .line = line, .n = LINES};
    const orr_status s = orr_study_plot(c, &plot, diag);
    free(x);
    return s;
}

int orr_cli_transfer(orr_cli *c, const orr_study_alignment *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    orr_study_motion motion = {0};
    work w = {.study = study};
    const char *title = study->head.title != NULL ? study->head.title : "Transfer alignment";
    orr_status s = orr_study_motion_open(inputs, study->scenario, study->duration_ns, &motion, &diag);
    if (s == ORR_OK)
        s = orr_errors_open(inputs, study->transfer.first_errors, &w.file[0], &w.errors[0], &diag);
    if (s == ORR_OK) s = orr_errors_open(inputs, study->errors, &w.file[1], &w.errors[1], &diag);
    if (s == ORR_OK) s = prepare(&w, &motion, &diag);
    if (s == ORR_OK) s = make_room(&w, &diag);
    if (s == ORR_OK) s = align(c, &w, &motion.moving, &diag);
    const orr_study_table table[] = {{"alignment", draw_columns, D_COLUMNS, (size_t)study->seeds, w.draws},
                                     {"track", track_columns, T_COLUMNS, w.at, w.track},
                                     {"first", unit_columns, U_COLUMNS, w.imu[0].n, w.unit[0]},
                                     {"second", unit_columns, U_COLUMNS, w.imu[1].n, w.unit[1]}};
    if (s == ORR_OK) s = orr_study_write(c, title, inputs, table, 4, &diag);
    if (s == ORR_OK) s = draw(c, &w, title, &diag);
    const int status = s == ORR_OK ? report(c, &w) : orr_cli_fail(c, &diag);
    for (int k = 0; k < 2; k++) {
        orr_imu_free(&w.imu[k]);
        orr_sensor_errors_free(&w.file[k]);
        free(w.unit[k]);
    }
    free(w.draws);
    free(w.track);
    orr_trajectory_free(&w.flexed);
    orr_study_motion_free(&motion);
    return status;
}

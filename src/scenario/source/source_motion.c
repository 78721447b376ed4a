// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/source/source_motion.h"

#include <stdio.h>
#include <stdlib.h>

#include "inertial/gravimetry/gravimetry.h"
#include "inertial/sense/sensors.h"
#include "src/make/error_series.h"

// A trajectory's ends are whole nanoseconds only when rounded: an instant counts as inside when it is
// nearer than one.
static const double END_S = 1e-9;

struct orr_source_motion {
    orr_moving moving;
    bool measured; // readings have errors
    orr_error_series errors[ORR_MOTION_MAX_UNITS];
    struct {
        char name[64];
        orr_vec3 arm_m;
        orr_angles turn;
    } unit[ORR_MOTION_MAX_UNITS];
};

static void keep_mounting(const orr_scenario_unit *u, orr_source_motion *m, size_t k)
{
    const double deg = ORR_RAD_PER_DEG;
    snprintf(m->unit[k].name, sizeof m->unit[k].name, "%s", u->name != NULL ? u->name : "");
    m->unit[k].arm_m = (orr_vec3){u->right_m, u->forward_m, u->up_m};
    m->unit[k].turn = (orr_angles){u->heading_deg * deg, u->pitch_deg * deg, u->roll_deg * deg};
}

// Errors of all units, where the scenario serves readings with such.
static orr_status open_errors(const orr_scenario_imu *imu, orr_source_motion *m, orr_diag *diag)
{
    if (imu->errors == NULL || imu->served == ORR_IMU_SERVE_IDEAL) return ORR_OK;
    orr_sensor_errors file;
    orr_imu_errors errors;
    orr_status s = orr_errors_open(&m->moving.inputs, imu->errors, &file, &errors, diag);
    for (size_t k = 0; k < m->moving.n_units && s == ORR_OK; k++)
        s = orr_error_series_make(&m->moving, k, &errors, &m->errors[k], diag);
    orr_sensor_errors_free(&file);
    m->measured = s == ORR_OK;
    return s;
}

orr_status orr_source_motion_open(const orr_scenario *s, orr_time fallback_start, orr_warnings *warnings,
                                  orr_source_motion **out, orr_diag *diag)
{
    *out = NULL;
    if (s->motion.trajectory.kind == ORR_MOTION_NONE) return ORR_OK;
    orr_source_motion *m = calloc(1, sizeof *m);
    if (m == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_status status = orr_moving_open(&s->motion, fallback_start, s->leap, warnings, &m->moving, diag);
    if (status != ORR_OK) {
        free(m);
        return status;
    }
    status = open_errors(&s->motion.imu, m, diag);
    if (status != ORR_OK) {
        orr_source_motion_close(m);
        return status;
    }
    for (size_t k = 1; k < m->moving.n_units; k++) keep_mounting(&s->motion.units.item[k - 1], m, k);
    *out = m;
    return ORR_OK;
}

void orr_source_motion_close(orr_source_motion *m)
{
    if (m == NULL) return;
    for (size_t k = 0; k < ORR_MOTION_MAX_UNITS; k++) orr_error_series_free(&m->errors[k]);
    orr_moving_free(&m->moving);
    free(m);
}

bool orr_source_motion_span(const orr_source_motion *m, orr_span *out)
{
    if (m == NULL) return false;
    const orr_trajectory *tr = &m->moving.trajectory;
    out->from = orr_time_add_s(tr->t0, tr->begin_s);
    out->to = orr_time_add_s(tr->t0, tr->end_s);
    return true;
}

const orr_moving *orr_source_motion_moving(const orr_source_motion *m)
{
    return m != NULL ? &m->moving : NULL;
}

size_t orr_source_motion_units(const orr_source_motion *m) { return m != NULL ? m->moving.n_units : 0; }

bool orr_source_motion_unit(const orr_source_motion *m, size_t unit, orr_unit *out)
{
    if (unit >= orr_source_motion_units(m)) return false;
    *out = (orr_unit){m->unit[unit].name, m->unit[unit].arm_m, m->unit[unit].turn};
    return true;
}

double orr_source_motion_rate_hz(const orr_source_motion *m) { return m != NULL ? m->moving.rate_hz : 0.0; }

bool orr_source_motion_physical(const orr_source_motion *m)
{
    return m != NULL && m->moving.mode.approach == 2;
}

// Motion of a trajectory at t; false outside its span.
static bool motion_at(const orr_trajectory *tr, orr_time t, orr_motion *out)
{
    double t_s = orr_time_diff_s(t, tr->t0);
    if (!(t_s >= tr->begin_s - END_S && t_s <= tr->end_s + END_S)) return false;
    tr->evaluate(tr->self, t_s, out);
    return true;
}

orr_answer orr_source_motion_at(const orr_source_motion *m, size_t unit, orr_time t, orr_motion *out)
{
    if (unit >= orr_source_motion_units(m)) return ORR_ANSWER_NOT_SERVED;
    return motion_at(orr_moving_unit(&m->moving, unit), t, out) ? ORR_ANSWER_OK : ORR_ANSWER_OUTSIDE_SPAN;
}

orr_answer orr_source_motion_place(const orr_source_motion *m, size_t unit, orr_time t, orr_vec3 *out)
{
    orr_motion motion;
    const orr_answer answer = orr_source_motion_at(m, unit, t, &motion);
    if (answer == ORR_ANSWER_OK) *out = motion.r_m;
    return answer;
}

bool orr_source_motion_measured(const orr_source_motion *m) { return m != NULL && m->measured; }

orr_answer orr_source_motion_imu_begin(const orr_source_motion *m, size_t unit, orr_time t0, orr_time t1,
                                       orr_sensors_sum *sum)
{
    if (unit >= orr_source_motion_units(m) || !orr_source_motion_physical(m)) return ORR_ANSWER_NOT_SERVED;
    const orr_trajectory *tr = orr_moving_unit(&m->moving, unit);
    double from_s = orr_time_diff_s(t0, tr->t0), to_s = orr_time_diff_s(t1, tr->t0);
    if (!(from_s >= tr->begin_s - END_S && to_s <= tr->end_s + END_S)) return ORR_ANSWER_OUTSIDE_SPAN;
    *sum = orr_sensors_sum_begin(tr, from_s, to_s);
    return ORR_ANSWER_OK;
}

bool orr_source_motion_imu_add(const orr_source_motion *m, size_t unit, orr_sensors_sum *sum, long pieces)
{
    const bool done = orr_sensors_sum_add(orr_moving_unit(&m->moving, unit), m->moving.gravity,
                                          m->moving.mode.quadrature, m->moving.mode.order, sum, pieces);
    if (done && m->measured)
        orr_error_series_add(&m->errors[unit], sum->from_s, sum->to_s, &sum->dtheta_rad, &sum->dv_mps);
    return done;
}

orr_answer orr_source_motion_truth(const orr_source_motion *m, size_t unit, orr_time t, orr_truth *out)
{
    if (unit >= orr_source_motion_units(m)) return ORR_ANSWER_NOT_SERVED;
    const orr_trajectory *tr = orr_moving_unit(&m->moving, unit);
    if (!motion_at(tr, t, &out->motion)) return ORR_ANSWER_OUTSIDE_SPAN;
    out->angles = orr_motion_angles(&out->motion);
    orr_sensors_instant(tr, m->moving.gravity, orr_time_diff_s(t, tr->t0), &out->rate_radps,
                        &out->force_mps2);
    orr_gravity_terms(m->moving.gravity, &out->motion, &out->disturbance_mgal, &out->eotvos_mgal,
                      &out->vertical_mps2);
    return ORR_ANSWER_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/moving.h"

#include <string.h>

#include "inertial/motion/polar.h"
#include "src/make/moving_private.h"

static const double DEG = ORR_RAD_PER_DEG;

static orr_status mount_units(const orr_scenario_units *units, orr_moving *out, orr_diag *diag)
{
    out->n_units = 1;
    for (size_t k = 0; k < units->n; k++) {
        const orr_scenario_unit *u = &units->item[k];
        orr_mounting mounting = {
            {u->right_m, u->forward_m, u->up_m},
            orr_body_from_enu((orr_angles){u->heading_deg * DEG, u->pitch_deg * DEG, u->roll_deg * DEG})};
        orr_status s = orr_trajectory_mounted(&out->trajectory, &mounting, &out->unit[k + 1], diag);
        if (s != ORR_OK) return s;
        out->n_units = k + 2;
    }
    return ORR_OK;
}

static orr_status transfer(const orr_scenario_transfer *q, orr_trajectory *tr, orr_mat3 *C_out,
                           orr_diag *diag)
{
    orr_vec3 to = orr_earth_to_ecef((orr_geodetic){q->lat_deg * DEG, q->lon_deg * DEG, 0.0});
    if (q->lat_deg > 90.0 - 1e-9 || q->lat_deg < -90.0 + 1e-9) to.x = to.y = 0.0; // the pole itself
    orr_mat3 C = orr_polar_rotation(orr_trajectory_middle(tr), to, q->azimuth_deg * DEG);
    orr_trajectory moved;
    *C_out = C;
    orr_polar_attitude attitude = q->attitude == ORR_TRANSFER_LITERAL ? ORR_POLAR_LITERAL : ORR_POLAR_LEVEL;
    orr_status s = orr_polar_transfer(tr, &C, attitude, 0.0, &moved, diag);
    if (s != ORR_OK) return s;
    orr_trajectory_free(tr);
    *tr = moved;
    return ORR_OK;
}

orr_time orr_moving_fallback_start(void) { return orr_time_from_week(2300, 0); }

static orr_nav_frame nav_frame(int word)
{
    switch ((orr_imu_frame_word)word) {
    case ORR_IMU_GEOGRAPHIC:
        return ORR_FRAME_GEOGRAPHIC;
    case ORR_IMU_BODY:
        return ORR_FRAME_BODY;
    case ORR_IMU_INERTIAL:
        break;
    }
    return ORR_FRAME_INERTIAL;
}

static void set_mode(const orr_scenario_imu *i, orr_moving *out)
{
    out->rate_hz = i->rate_hz;
    out->mode = (orr_imu_mode){.approach = i->approach == ORR_IMU_MATCHED ? 1 : 2,
                               .frame = nav_frame(i->frame),
                               .project_mid = i->projection == ORR_IMU_MID,
                               .closed_loop = i->loop == ORR_IMU_CLOSED,
                               .quadrature = i->quadrature == ORR_IMU_RIEMANN ? ORR_QUADRATURE_RIEMANN
                                                                              : ORR_QUADRATURE_GAUSS,
                               .order = (int)i->order};
    if (out->mode.order == 0) out->mode.order = orr_moving_order(out, out->mode.quadrature, i->rate_hz);
}

orr_status orr_moving_open(const orr_scenario_motion *m, orr_time fallback_start, const orr_leap_table *leap,
                           orr_warnings *warnings, orr_moving *out, orr_diag *diag)
{
    *out = (orr_moving){.inputs.leap = leap};
    const orr_scenario_trajectory *t = &m->trajectory;
    orr_time start = t->has_start ? t->start : fallback_start;
    orr_status s = ORR_OK;
    switch ((orr_motion_kind)t->kind) {
    case ORR_MOTION_SURVEY:
    case ORR_MOTION_WAYPOINTS:
    case ORR_MOTION_PHASES:
        s = moving_make_plan(t, start, warnings, &out->trajectory, diag);
        break;
    case ORR_MOTION_TELEMETRY:
        s = moving_make_telemetry(t, fallback_start, warnings, out, diag);
        break;
    case ORR_MOTION_ANALYTIC:
        s = moving_make_analytic(t, start, &out->trajectory, diag);
        break;
    case ORR_MOTION_ORBIT:
        s = moving_make_orbit(t, start, out, diag);
        break;
    case ORR_MOTION_NONE:
        return orr_diag_set(diag, ORR_E_NODATA, "the scenario has no trajectory (trajectory.kind)");
    }
    orr_mat3 C;
    if (s == ORR_OK && t->has_transfer) s = transfer(&t->transfer, &out->trajectory, &C, diag);
    if (s == ORR_OK) s = moving_make_gravity(&m->gravity, t->has_transfer ? &C : NULL, out, diag);
    if (s == ORR_OK) s = mount_units(&m->units, out, diag);
    set_mode(&m->imu, out);
    if (s != ORR_OK) orr_moving_free(out);
    return s;
}

int orr_moving_order(const orr_moving *v, orr_quadrature quadrature, double rate_hz)
{
    if (quadrature == ORR_QUADRATURE_RIEMANN) return 100;
    return v->from_telemetry || rate_hz < 50.0 ? 3 : 2;
}

void orr_moving_free(orr_moving *v)
{
    for (size_t k = 1; k < v->n_units; k++) orr_trajectory_free(&v->unit[k]);
    orr_trajectory_free(&v->trajectory);
    orr_gravity_free(v->gravity);
    orr_gravity_model_free(v->model);
    orr_fit_report_free(&v->report);
    orr_inputs_free(&v->inputs);
    memset(v, 0, sizeof *v);
}

const orr_trajectory *orr_moving_unit(const orr_moving *v, size_t k)
{
    return k == 0 ? &v->trajectory : &v->unit[k];
}

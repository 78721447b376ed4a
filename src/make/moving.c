// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/moving.h"

#include <stdlib.h>
#include <string.h>

#include "inertial/motion/analytic.h"
#include "inertial/motion/flight_plan.h"
#include "inertial/motion/polar.h"
#include "ingest/tables/gravity_file.h"
#include "ingest/telemetry/telemetry.h"

static const double DEG = ORR_RAD_PER_DEG;

static orr_spectrum spectrum(const orr_scenario_spectrum *s, double unit)
{
    return (orr_spectrum){s->rms * unit, s->low_hz, s->high_hz, s->slope};
}

static orr_status make_plan(const orr_scenario_motion *m, orr_time start, orr_trajectory *out, orr_diag *diag)
{
    orr_flight_plan p = {.survey = {.start = {m->lat_deg * DEG, m->lon_deg * DEG, m->height_m},
                                    .azimuth_rad = m->azimuth_deg * DEG,
                                    .length_m = m->length_m,
                                    .spacing_m = m->spacing_m,
                                    .lines = (int)m->lines,
                                    .to_left = m->side == 1,
                                    .tie_lines = (int)m->tie_lines,
                                    .tie_spacing_m = m->tie_spacing_m},
                         .speed_mps = m->speed_mps,
                         .bank_rad = m->bank_deg * DEG,
                         .turn_radius_m = m->turn_radius_m,
                         .climb_limit_mps = m->climb_mps,
                         .lead_m = m->lead_m,
                         .smoothing_s = m->smoothing_s,
                         .pitch_rad = m->pitch_deg * DEG,
                         .wind_mps = spectrum(&m->turbulence, 1.0),
                         .heading_rad = spectrum(&m->heading, DEG),
                         .pitch_osc_rad = spectrum(&m->pitch, DEG),
                         .roll_rad = spectrum(&m->roll, DEG),
                         .seed = (uint64_t)m->seed,
                         .duration_s = (double)m->duration_ns * 1e-9,
                         .knot_step_s = m->knots_s};
    orr_waypoint *w = NULL;
    if (m->kind == ORR_MOTION_WAYPOINTS) {
        if (m->waypoints.n == 0) return orr_diag_set(diag, ORR_E_FORMAT, "trajectory.waypoints is empty");
        w = malloc(m->waypoints.n * sizeof *w);
        if (w == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t k = 0; k < m->waypoints.n; k++) {
            const orr_scenario_waypoint *q = &m->waypoints.item[k];
            w[k] = (orr_waypoint){{q->lat_deg * DEG, q->lon_deg * DEG, q->height_m}, q->speed_mps};
        }
        p.n_waypoints = m->waypoints.n;
        p.waypoint = w;
    }
    orr_status s = orr_trajectory_flight_plan(start, &p, out, NULL, diag);
    free(w);
    return s;
}

static orr_status make_analytic(const orr_scenario_motion *m, orr_time start, orr_trajectory *out,
                                orr_diag *diag)
{
    if (m->duration_ns <= 0)
        return orr_diag_set(diag, ORR_E_FORMAT, "an analytic trajectory needs trajectory.duration");
    orr_analytic_plan p = {
        .origin = {m->lat_deg * DEG, m->lon_deg * DEG, m->height_m},
        .attitude = {m->body_heading_deg * DEG, m->body_pitch_deg * DEG, m->body_roll_deg * DEG},
        .follow_course = m->follow_course,
        .n_terms = m->terms.n};
    if (m->terms.n > ORR_ANALYTIC_MAX_TERMS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu motions are summed; the limit is %d", m->terms.n,
                            ORR_ANALYTIC_MAX_TERMS);
    for (size_t k = 0; k < m->terms.n; k++) {
        const orr_scenario_term *q = &m->terms.item[k];
        p.term[k] =
            (orr_analytic_term){.kind = (orr_analytic_kind)q->kind,
                                .velocity_mps = {q->east, q->north, q->up},
                                .radius_m = q->radius_m,
                                .period_s = q->period_s,
                                .azimuth_rad = q->azimuth_deg * DEG,
                                .counter_clockwise = q->counter_clockwise,
                                .along_m = q->along_m,
                                .across_m = q->across_m,
                                .amplitude_m = {q->east, q->north, q->up},
                                .amplitude = {q->heading_deg * DEG, q->pitch_deg * DEG, q->roll_deg * DEG},
                                .phase_rad = q->phase_deg * DEG};
    }
    return orr_trajectory_analytic(start, 0.0, (double)m->duration_ns * 1e-9, &p, out, diag);
}

// --- Telemetry: one log with everything, or places in one and angles in another, on the same clock ---

typedef struct joined {
    orr_telemetry log[2];
    size_t n;
    orr_telemetry_log view;
    double *shifted_s; // times of the angles on the places' clock
} joined;

static orr_status join(joined *j, orr_time *zero, bool *absolute, orr_diag *diag)
{
    orr_telemetry *p = NULL, *a = NULL;
    for (size_t k = 0; k < j->n; k++) {
        if (j->log[k].n_position > 0 && p == NULL) p = &j->log[k];
        if (j->log[k].n_attitude > 0 && (a == NULL || j->log[k].n_position == 0)) a = &j->log[k];
    }
    if (p == NULL)
        return orr_diag_set(diag, ORR_E_NODATA, "the telemetry has angles, but no place in any file");
    *absolute = p->absolute || (a != NULL && a->absolute);
    *zero = p->absolute ? p->t0 : a != NULL && a->absolute ? a->t0 : 0;
    double shift = p->absolute && a != NULL && a != p && a->absolute ? orr_time_diff_s(a->t0, p->t0) : 0.0;
    j->view = (orr_telemetry_log){.n_position = p->n_position,
                                  .position_t_s = p->position_t_s,
                                  .position = p->position,
                                  .position_row = p->position_line};
    if (a == NULL) return ORR_OK;
    j->shifted_s = malloc(a->n_attitude * sizeof *j->shifted_s);
    if (j->shifted_s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < a->n_attitude; k++) j->shifted_s[k] = a->attitude_t_s[k] + shift;
    j->view.n_attitude = a->n_attitude;
    j->view.attitude_t_s = j->shifted_s;
    j->view.heading_rad = a->heading_rad;
    j->view.pitch_rad = a->pitch_rad;
    j->view.roll_rad = a->roll_rad;
    j->view.attitude_row = a->attitude_line;
    return ORR_OK;
}

static orr_status make_telemetry(const orr_scenario_motion *m, orr_time fallback, orr_warnings *warnings,
                                 orr_moving *out, orr_diag *diag)
{
    joined j;
    memset(&j, 0, sizeof j);
    if (m->logs.n < 1 || m->logs.n > 2)
        return orr_diag_set(diag, ORR_E_ARG,
                            "telemetry comes in one file or two (places and angles), not in %zu", m->logs.n);
    orr_status s = ORR_OK;
    for (size_t k = 0; k < m->logs.n && s == ORR_OK; k++) {
        s = orr_telemetry_read(m->logs.item[k].file, m->logs.item[k].columns, &j.log[k], warnings, diag);
        j.n = k + 1;
    }
    orr_time zero = 0;
    bool absolute = false;
    if (s == ORR_OK) s = join(&j, &zero, &absolute, diag);
    if (s == ORR_OK) {
        orr_fit_options o = orr_fit_options_default();
        o.degree = m->degree == 1 ? 5 : 3;
        o.position_per_knot = m->position_per_knot;
        o.attitude_per_knot = m->attitude_per_knot;
        if (m->max_gap_ns > 0) o.max_gap_s = (double)m->max_gap_ns * 1e-9;
        s = orr_trajectory_from_telemetry(zero, &j.view, &o, &out->trajectory, &out->report, diag);
        out->from_telemetry = s == ORR_OK;
    }
    if (s == ORR_OK) {
        // A wished start moves the whole flight there; without one a relative clock begins where the scenario
        // does.
        if (m->start != 0)
            out->trajectory.t0 = m->start;
        else if (!absolute)
            out->trajectory.t0 = fallback;
        double wish_s = (double)m->duration_ns * 1e-9;
        if (wish_s > 0.0 && wish_s < out->trajectory.end_s) out->trajectory.end_s = wish_s;
    }
    for (size_t k = 0; k < j.n; k++) orr_telemetry_free(&j.log[k]);
    free(j.shifted_s);
    return s;
}

static void transfer_profile(const orr_mat3 *C, orr_gravity_parts *p);

static orr_status make_gravity(const orr_scenario_motion *m, const orr_mat3 *C, orr_moving *out,
                               orr_diag *diag)
{
    orr_gravity_parts p = {0};
    orr_gravity_file file;
    memset(&file, 0, sizeof file);
    orr_point_mass *mass = NULL;
    orr_status s = ORR_OK;
    if (m->model != NULL) {
        s = orr_gravity_model_open(m->model, m->model_folder, &out->model, diag);
        p.model = out->model;
    }
    p.profile_lat_rad = m->profile_lat_deg * DEG;
    p.profile_lon_rad = m->profile_lon_deg * DEG;
    p.profile_azimuth_rad = m->profile_azimuth_deg * DEG;
    if (m->profile_distance_m.n != m->profile_mgal.n)
        s = orr_diag_set(diag, ORR_E_FORMAT, "gravity.profile has %zu distances and %zu values",
                         m->profile_distance_m.n, m->profile_mgal.n);
    if (C != NULL) transfer_profile(C, &p);
    p.n_profile = m->profile_distance_m.n;
    p.profile_distance_m = m->profile_distance_m.item;
    p.profile_mgal = m->profile_mgal.item;
    if (s == ORR_OK && m->gravity_file != NULL) {
        s = orr_gravity_file_read(m->gravity_file, &file, diag);
        if (s == ORR_OK && file.n_profile > 0) {
            p.n_profile = file.n_profile;
            p.profile_distance_m = file.distance_m;
            p.profile_mgal = file.mgal;
        } else if (s == ORR_OK) {
            p.n_lat = file.n_lat;
            p.n_lon = file.n_lon;
            p.map_lat_rad = file.lat_rad;
            p.map_lon_rad = file.lon_rad;
            p.map_mgal = file.mgal;
        }
    }
    if (s == ORR_OK && m->masses.n > 0) {
        mass = malloc(m->masses.n * sizeof *mass);
        if (mass == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t k = 0; k < m->masses.n && mass != NULL; k++) {
            const orr_scenario_mass *q = &m->masses.item[k];
            mass[k].r_m = orr_earth_to_ecef((orr_geodetic){q->lat_deg * DEG, q->lon_deg * DEG, q->height_m});
            mass[k].gm_m3ps2 = q->gm_m3ps2;
        }
        p.n_masses = m->masses.n;
        p.mass = mass;
    }
    if (s == ORR_OK && (p.model != NULL || p.n_profile + p.n_lat + p.n_masses > 0))
        s = orr_gravity_make(&p, &out->gravity, diag);
    if (s == ORR_OK) s = orr_gravity_covers(out->gravity, &out->trajectory, diag);
    orr_gravity_file_free(&file);
    free(mass);
    return s;
}

static orr_status mount_units(const orr_scenario_motion *m, orr_moving *out, orr_diag *diag)
{
    out->n_units = 1;
    if (m->units.n + 1 > ORR_MOTION_MAX_UNITS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu units; the limit is %d", m->units.n + 1,
                            ORR_MOTION_MAX_UNITS);
    for (size_t k = 0; k < m->units.n; k++) {
        const orr_scenario_unit *u = &m->units.item[k];
        orr_mounting mounting = {
            {u->right_m, u->forward_m, u->up_m},
            orr_body_from_enu((orr_angles){u->heading_deg * DEG, u->pitch_deg * DEG, u->roll_deg * DEG})};
        orr_status s = orr_trajectory_mounted(&out->trajectory, &mounting, &out->unit[k + 1], diag);
        if (s != ORR_OK) return s;
        out->n_units = k + 2;
    }
    return ORR_OK;
}

// A gravity profile goes with the flight: its begin and direction turn as places do.
static void transfer_profile(const orr_mat3 *C, orr_gravity_parts *p)
{
    double lat, lon, azimuth, length;
    orr_earth_geodesic_direct(p->profile_lat_rad, p->profile_lon_rad, p->profile_azimuth_rad, 1e4, &lat, &lon,
                              &azimuth);
    orr_vec3 a = orr_earth_to_ecef((orr_geodetic){p->profile_lat_rad, p->profile_lon_rad, 0.0});
    orr_vec3 b = orr_earth_to_ecef((orr_geodetic){lat, lon, 0.0});
    orr_geodetic from = orr_earth_from_ecef(orr_mat3_apply_t(C, a)),
                 to = orr_earth_from_ecef(orr_mat3_apply_t(C, b));
    p->profile_lat_rad = from.lat_rad;
    p->profile_lon_rad = from.lon_rad;
    orr_earth_geodesic_inverse(from.lat_rad, from.lon_rad, to.lat_rad, to.lon_rad, &length,
                               &p->profile_azimuth_rad, &azimuth);
}

static orr_status transfer(const orr_scenario_motion *m, orr_trajectory *tr, orr_mat3 *C_out, orr_diag *diag)
{
    orr_vec3 to = orr_earth_to_ecef((orr_geodetic){m->to_lat_deg * DEG, m->to_lon_deg * DEG, 0.0});
    if (m->to_lat_deg > 90.0 - 1e-9 || m->to_lat_deg < -90.0 + 1e-9) to.x = to.y = 0.0; // the pole itself
    orr_mat3 C = orr_polar_rotation(orr_trajectory_middle(tr), to, m->to_azimuth_deg * DEG);
    orr_trajectory moved;
    *C_out = C;
    orr_status s = orr_polar_transfer(tr, &C, 0.0, &moved, diag);
    if (s != ORR_OK) return s;
    orr_trajectory_free(tr);
    *tr = moved;
    return ORR_OK;
}

orr_time orr_moving_fallback_start(void) { return orr_time_from_week(2300, 0); }

orr_status orr_moving_open(const orr_scenario_motion *m, orr_time fallback_start, orr_warnings *warnings,
                           orr_moving *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_time start = m->start != 0 ? m->start : fallback_start;
    orr_status s;
    switch ((orr_motion_kind)m->kind) {
    case ORR_MOTION_SURVEY:
    case ORR_MOTION_WAYPOINTS:
        s = make_plan(m, start, &out->trajectory, diag);
        break;
    case ORR_MOTION_TELEMETRY:
        s = make_telemetry(m, fallback_start, warnings, out, diag);
        break;
    case ORR_MOTION_ANALYTIC:
        s = make_analytic(m, start, &out->trajectory, diag);
        break;
    default:
        return orr_diag_set(diag, ORR_E_NODATA, "the scenario has no trajectory (trajectory.kind)");
    }
    orr_mat3 C;
    if (s == ORR_OK && m->transfer) s = transfer(m, &out->trajectory, &C, diag);
    if (s == ORR_OK) s = make_gravity(m, m->transfer ? &C : NULL, out, diag);
    if (s == ORR_OK) s = mount_units(m, out, diag);
    out->rate_hz = m->rate_hz;
    out->mode = (orr_imu_mode){.approach = m->approach + 1,
                               .frame = (orr_nav_frame)m->frame,
                               .project_mid = m->projection == 0,
                               .closed_loop = m->loop == 0,
                               .quadrature = (orr_quadrature)m->quadrature,
                               .order = m->order > 0 ? (int)m->order : 0};
    if (out->mode.order == 0) out->mode.order = orr_moving_order(out, out->mode.quadrature, m->rate_hz);
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
    memset(v, 0, sizeof *v);
}

const orr_trajectory *orr_moving_unit(const orr_moving *v, size_t k)
{
    return k == 0 ? &v->trajectory : &v->unit[k];
}

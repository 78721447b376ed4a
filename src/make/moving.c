// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/moving.h"

#include <stdlib.h>
#include <string.h>

#include "inertial/motion/analytic.h"
#include "inertial/motion/drape.h"
#include "inertial/motion/flight_plan.h"
#include "inertial/motion/polar.h"
#include "ingest/tables/gravity_file.h"

static const double DEG = ORR_RAD_PER_DEG;

static orr_spectrum spectrum(const orr_scenario_spectrum *s, double unit)
{
    return (orr_spectrum){s->rms * unit, s->low_hz, s->high_hz, s->slope};
}

_Static_assert(ORR_TRAJECTORY_MAX_WAYPOINTS == ORR_PLAN_MAX_WAYPOINTS &&
                   ORR_TRAJECTORY_MAX_PHASES == ORR_PLAN_MAX_PHASES &&
                   ORR_TRAJECTORY_MAX_TERMS == ORR_ANALYTIC_MAX_TERMS,
               "the table's limits are those of the makers");

static orr_survey survey_of(const orr_scenario_survey *v, orr_geodetic start)
{
    return (orr_survey){.start = start,
                        .azimuth_rad = v->azimuth_deg * DEG,
                        .length_m = v->length_m,
                        .spacing_m = v->spacing_m,
                        .lines = (int)v->lines,
                        .to_left = v->side == ORR_SURVEY_LEFT,
                        .tie_lines = (int)v->tie_lines,
                        .tie_spacing_m = v->tie_spacing_m};
}

static orr_phase_kind phase_kind(int word)
{
    switch ((orr_phase_word)word) {
    case ORR_PHASE_WORD_STRAIGHT:
        return ORR_PHASE_STRAIGHT;
    case ORR_PHASE_WORD_TAXI:
        return ORR_PHASE_TAXI;
    case ORR_PHASE_WORD_TURN:
        return ORR_PHASE_TURN;
    case ORR_PHASE_WORD_TAKEOFF:
        return ORR_PHASE_TAKEOFF;
    case ORR_PHASE_WORD_CLIMB:
        return ORR_PHASE_CLIMB;
    case ORR_PHASE_WORD_TO:
        return ORR_PHASE_TO;
    case ORR_PHASE_WORD_SURVEY:
        return ORR_PHASE_SURVEY;
    case ORR_PHASE_WORD_LANDING:
        return ORR_PHASE_LANDING;
    case ORR_PHASE_WORD_REST:
        break;
    }
    return ORR_PHASE_REST;
}

static orr_phase phase_of(const orr_scenario_phase *q)
{
    return (orr_phase){.kind = phase_kind(q->kind),
                       .duration_s = (double)q->duration_ns * 1e-9,
                       .length_m = q->length_m,
                       .speed_mps = q->speed_mps,
                       .stop = q->stop,
                       .angle_rad = q->angle_deg * DEG,
                       .radius_m = q->radius_m,
                       .height_m = q->height_m,
                       .rate_mps = q->rate_mps,
                       .at = {q->lat_deg * DEG, q->lon_deg * DEG, 0.0},
                       .azimuth_rad = q->azimuth_deg * DEG,
                       .survey = survey_of(&q->survey, (orr_geodetic){0, 0, 0})};
}

// Lays the flight over the terrain's waves.
static orr_status drape(const orr_scenario_trajectory *m, orr_geodetic origin, orr_trajectory *tr,
                        orr_diag *diag)
{
    orr_drape_wave wave[ORR_DRAPE_MAX_WAVES];
    for (size_t k = 0; k < m->drape.n; k++) {
        const orr_scenario_wave *w = &m->drape.item[k];
        wave[k] = (orr_drape_wave){w->amplitude_m, w->wavelength_m, w->azimuth_deg * DEG, w->phase_deg * DEG};
    }
    orr_trajectory laid;
    const orr_status s = orr_trajectory_drape(tr, origin, wave, m->drape.n, m->knots_s, &laid, NULL, diag);
    if (s != ORR_OK) return s;
    orr_trajectory_free(tr);
    *tr = laid;
    return ORR_OK;
}

static orr_status make_plan(const orr_scenario_trajectory *m, orr_time start, orr_warnings *warnings,
                            orr_trajectory *out, orr_diag *diag)
{
    const orr_geodetic start_at = {m->lat_deg * DEG, m->lon_deg * DEG, m->height_m};
    orr_flight_plan p = {.start = start_at,
                         .course_rad = m->azimuth_deg * DEG,
                         .survey = survey_of(&m->survey, start_at),
                         .speed_mps = m->speed_mps,
                         .bank_rad = m->bank_deg * DEG,
                         .turn_radius_m = m->turn_radius_m,
                         .climb_limit_mps = m->climb_mps,
                         .acceleration_mps2 = m->acceleration_mps2,
                         .lead_m = m->lead_m,
                         .smoothing_s = m->smoothing_s,
                         .pitch_rad = m->pitch_deg * DEG,
                         .wind_mps = spectrum(&m->turbulence, 1.0),
                         .heading_rad = spectrum(&m->oscillation.heading, DEG),
                         .pitch_osc_rad = spectrum(&m->oscillation.pitch, DEG),
                         .roll_rad = spectrum(&m->oscillation.roll, DEG),
                         .seed = (uint64_t)m->seed,
                         .duration_s = (double)m->duration_ns * 1e-9,
                         .knot_step_s = m->knots_s};
    orr_waypoint *w = NULL;
    orr_phase *phase = NULL;
    if (m->kind == ORR_MOTION_PHASES) {
        phase = malloc(m->phases.n * sizeof *phase);
        if (phase == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t k = 0; k < m->phases.n; k++) phase[k] = phase_of(&m->phases.item[k]);
        p.n_phases = m->phases.n;
        p.phase = phase;
    }
    if (m->kind == ORR_MOTION_WAYPOINTS) {
        w = malloc(m->waypoints.n * sizeof *w);
        if (w == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t k = 0; k < m->waypoints.n; k++) {
            const orr_scenario_waypoint *q = &m->waypoints.item[k];
            w[k] = (orr_waypoint){{q->lat_deg * DEG, q->lon_deg * DEG, q->height_m}, q->speed_mps};
        }
        p.n_waypoints = m->waypoints.n;
        p.waypoint = w;
    }
    orr_flight_summary plan;
    orr_status s = orr_trajectory_flight_plan(start, &p, out, &plan, diag);
    if (s == ORR_OK && m->drape.n > 0) s = drape(m, start_at, out, diag);
    free(w);
    free(phase);
    if (s == ORR_OK && p.duration_s > plan.duration_s + 1e-6)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "a duration of %.3f s is wanted, and the plan is flown in %.3f s: the rest goes straight on",
            p.duration_s, plan.duration_s);
    return s;
}

// Config's words are in an order of their own.
static orr_analytic_kind term_kind(int word)
{
    switch ((orr_term_kind)word) {
    case ORR_TERM_CIRCLE:
        return ORR_ANALYTIC_CIRCLE;
    case ORR_TERM_EIGHT:
        return ORR_ANALYTIC_EIGHT;
    case ORR_TERM_SINE:
        return ORR_ANALYTIC_SINE;
    case ORR_TERM_STRAIGHT:
        break;
    }
    return ORR_ANALYTIC_STRAIGHT;
}

static orr_status make_analytic(const orr_scenario_trajectory *m, orr_time start, orr_trajectory *out,
                                orr_diag *diag)
{
    if (m->duration_ns <= 0)
        return orr_diag_set(diag, ORR_E_FORMAT, "an analytic trajectory needs trajectory.duration");
    orr_analytic_plan p = {
        .origin = {m->lat_deg * DEG, m->lon_deg * DEG, m->height_m},
        .attitude = {m->body.heading_deg * DEG, m->body.pitch_deg * DEG, m->body.roll_deg * DEG},
        .follow_course = m->body.follow_course,
        .n_terms = m->terms.n};
    for (size_t k = 0; k < m->terms.n; k++) {
        const orr_scenario_term *q = &m->terms.item[k];
        p.term[k] =
            (orr_analytic_term){.kind = term_kind(q->kind),
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
    orr_telemetry *places, *angles; // of log[]; angles may be NULL, or the places' own log
    orr_telemetry_log view;
    orr_time zero;
    double *place_s, *angle_s; // times after zero
    const orr_leap_table *leap;
} joined;

static void joined_free(joined *j)
{
    for (size_t k = 0; k < j->n; k++) orr_telemetry_free(&j->log[k]);
    free(j->place_s);
    free(j->angle_s);
}

// Instant of the clock's zero where no date goes with it: midnight UTC of the date, or begin of the week, that `day`
// has in GPS time.
static orr_time assumed_zero(double period_s, orr_time day, const orr_leap_table *leap)
{
    int32_t number;
    if (period_s == 604800.0) {
        int64_t ns;
        orr_time_week(day, &number, &ns);
        return orr_time_from_week(number, 0);
    }
    double fraction;
    orr_time_mjd(day, ORR_SCALE_GPS, NULL, &number, &fraction);
    return orr_time_from_mjd(number, 0.0, ORR_SCALE_UTC, leap);
}

// Times of one log on the clock of the other: n times t_s to out_s.
static void bring(const orr_telemetry *log, const orr_telemetry *other, const joined *j, const double *t_s,
                  size_t n, double *out_s)
{
    bool tied =
        !log->absolute && other != NULL && other->tie.n > 0; // the other tells GPS time beside this clock
    double shift = log->absolute ? orr_time_diff_s(log->t0, j->zero)
                   : log->period_s > 0.0
                       ? orr_time_diff_s(assumed_zero(log->period_s, j->zero, j->leap), j->zero)
                       : 0.0;
    for (size_t k = 0; k < n; k++) out_s[k] = tied ? orr_clock_tied_s(&other->tie, t_s[k]) : t_s[k] + shift;
}

static orr_status join(joined *j, orr_time fallback, orr_diag *diag)
{
    for (size_t k = 0; k < j->n; k++) {
        if (j->log[k].n_position > 0 && j->places == NULL) j->places = &j->log[k];
        if (j->log[k].n_attitude > 0 && (j->angles == NULL || j->log[k].n_position == 0))
            j->angles = &j->log[k];
    }
    orr_telemetry *p = j->places, *a = j->angles;
    if (p == NULL)
        return orr_diag_set(diag, ORR_E_NODATA, "the telemetry has angles, but no place in any file");
    const orr_telemetry *dated = p->absolute || a == NULL || !a->absolute ? p : a;
    j->zero = dated->absolute         ? dated->t0
              : dated->period_s > 0.0 ? assumed_zero(dated->period_s, fallback, j->leap)
                                      : 0;
    j->place_s = malloc(p->n_position * sizeof *j->place_s);
    j->angle_s = malloc((a != NULL ? a->n_attitude + 1 : 1) * sizeof *j->angle_s);
    if (j->place_s == NULL || j->angle_s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    bring(p, a != p ? a : NULL, j, p->position_t_s, p->n_position, j->place_s);
    j->view = (orr_telemetry_log){.n_position = p->n_position,
                                  .position_t_s = j->place_s,
                                  .position = p->position,
                                  .position_row = p->position_line};
    if (a == NULL) return ORR_OK;
    bring(a, a != p ? p : NULL, j, a->attitude_t_s, a->n_attitude, j->angle_s);
    j->view.n_attitude = a->n_attitude;
    j->view.attitude_t_s = j->angle_s;
    j->view.heading_rad = a->heading_rad;
    j->view.pitch_rad = a->pitch_rad;
    j->view.roll_rad = a->roll_rad;
    j->view.attitude_row = a->attitude_line;
    return ORR_OK;
}

// The begin of a motion through a log: what the scenario wishes, what the log tells, or an assumption that is told.
static void date_log(const orr_scenario_trajectory *m, const joined *j, orr_time fallback,
                     orr_warnings *warnings, orr_moving *out)
{
    bool absolute = j->places->absolute || (j->angles != NULL && j->angles->absolute);
    char text[ORR_TIME_TEXT];
    if (m->has_start) {
        out->trajectory.t0 = m->start; // moves the whole flight there
    } else if (!absolute && j->places->period_s > 0.0) {
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "the log tells no date: its times of %s are assumed to be those of %.10s%s (--start or "
            "trajectory.start tells another)",
            j->places->period_s == 604800.0 ? "week" : "day",
            j->places->period_s == 604800.0 ? orr_time_format(j->zero, ORR_SCALE_GPS, 0, NULL, text)
                                            : orr_time_format(j->zero, ORR_SCALE_UTC, 0, j->leap, text),
            j->places->period_s == 604800.0 ? " and after" : " UTC");
    } else if (!absolute) {
        out->trajectory.t0 = fallback;
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "the log tells no date: its begin is assumed to be %s GPS (--start or trajectory.start tells "
            "another)",
            orr_time_text(fallback, text));
    }
    double wish_s = (double)m->duration_ns * 1e-9;
    if (wish_s > out->trajectory.end_s + 1e-6)
        orr_warnings_add(warnings, NULL, 0, 0, "a duration of %.3f s is wanted, and the log holds %.3f s",
                         wish_s, out->trajectory.end_s);
    if (wish_s > 0.0 && wish_s < out->trajectory.end_s) out->trajectory.end_s = wish_s;
}

// Warnings from..to of a log handed on, and what was counted without being kept.
static void hand_on(const orr_warnings *from, size_t begin, size_t end, orr_warnings *to)
{
    for (size_t k = begin; k < end && k < from->kept; k++)
        orr_warnings_add(to, from->item[k].file, from->item[k].line, from->item[k].column, "%s",
                         from->item[k].text);
}

static orr_status make_telemetry(const orr_scenario_trajectory *m, orr_time fallback, orr_warnings *warnings,
                                 orr_moving *out, orr_diag *diag)
{
    joined j;
    orr_warnings of_log[ORR_TRAJECTORY_MAX_LOGS] = {{0}}; // sentences on whole logs go before those on rows
    memset(&j, 0, sizeof j);
    j.leap = out->inputs.leap;
    orr_status s = ORR_OK;
    for (size_t k = 0; k < m->logs.n && s == ORR_OK; k++) {
        const char *path = m->logs.item[k].file;
        orr_bytes raw;
        s = orr_inputs_read_raw(&out->inputs, path, 0, &raw, diag);
        if (s == ORR_OK)
            s = orr_telemetry_read_bytes(path, raw.text, raw.n, m->logs.item[k].columns, out->inputs.leap,
                                         &j.log[k], &of_log[k], diag);
        orr_bytes_free(&raw);
        hand_on(&of_log[k], 0, j.log[k].notes, warnings);
        j.n = k + 1;
    }
    if (s == ORR_OK) s = join(&j, fallback, diag);
    if (s == ORR_OK) {
        orr_fit_options o = orr_fit_options_default();
        o.degree = m->fit.degree == ORR_FIT_QUINTIC ? 5 : 3;
        o.position_per_knot = m->fit.position_per_knot;
        o.attitude_per_knot = m->fit.attitude_per_knot;
        o.max_gap_s = (double)m->fit.max_gap_ns * 1e-9;
        s = orr_trajectory_from_telemetry(j.zero, &j.view, &o, &out->trajectory, &out->report, diag);
        out->from_telemetry = s == ORR_OK;
    }
    if (s == ORR_OK) {
        date_log(m, &j, fallback, warnings, out);
        for (size_t k = 0; k < j.n && out->tie.n == 0; k++) {
            out->tie = j.log[k].tie;
            out->tie_zero = j.log[k].t0;
        }
    }
    for (size_t k = 0; k < j.n; k++) {
        hand_on(&of_log[k], j.log[k].notes, SIZE_MAX, warnings);
        if (warnings != NULL) warnings->count += of_log[k].count - of_log[k].kept;
        orr_warnings_free(&of_log[k]);
    }
    joined_free(&j);
    return s;
}

// --- Gravity: what a made disturbance is under home, it is under a transferred flight ---

// A profile in the scenario, or the place of one in a file.
static void add_profile(const orr_scenario_profile *q, orr_gravity_parts *p)
{
    p->profile_lat_rad = q->lat_deg * DEG;
    p->profile_lon_rad = q->lon_deg * DEG;
    p->profile_azimuth_rad = q->azimuth_deg * DEG;
    p->n_profile = q->distance_m.n;
    p->profile_distance_m = q->distance_m.item;
    p->profile_mgal = q->mgal.item;
}

static orr_status add_file(const orr_scenario_gravity *g, const orr_gravity_file *file, orr_gravity_parts *p,
                           orr_diag *diag)
{
    if (file->n_profile > 0) {
        if (!g->has_profile)
            return orr_diag_at(diag, ORR_E_FORMAT, g->file, 0, 0,
                               "is a profile: gravity.profile has to tell its lat, lon and azimuth");
        if (p->n_profile > 0)
            return orr_diag_at(diag, ORR_E_FORMAT, g->file, 0, 0,
                               "is a profile, and gravity.profile has distances of its own: one of them is "
                               "possible");
        p->n_profile = file->n_profile;
        p->profile_distance_m = file->distance_m;
        p->profile_mgal = file->mgal;
        return ORR_OK;
    }
    if (g->has_profile && p->n_profile == 0)
        return orr_diag_at(diag, ORR_E_FORMAT, g->file, 0, 0,
                           "is a map: gravity.profile has no effect without distance and mgal");
    p->n_lat = file->n_lat;
    p->n_lon = file->n_lon;
    p->map_lat_rad = file->lat_rad;
    p->map_lon_rad = file->lon_rad;
    p->map_mgal = file->mgal;
    return ORR_OK;
}

static orr_status make_masses(const orr_scenario_gravity *g, const orr_mat3 *C, orr_point_mass **out,
                              orr_diag *diag)
{
    *out = NULL;
    if (g->masses.n == 0) return ORR_OK;
    orr_point_mass *mass = malloc(g->masses.n * sizeof *mass);
    if (mass == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < g->masses.n; k++) {
        const orr_scenario_mass *q = &g->masses.item[k];
        orr_geodetic at = {q->lat_deg * DEG, q->lon_deg * DEG, q->height_m};
        orr_vec3 r_m = orr_earth_to_ecef(at);
        mass[k] = (orr_point_mass){C != NULL ? orr_polar_place(C, r_m) : r_m, q->gm_m3ps2};
    }
    *out = mass;
    return ORR_OK;
}

static orr_status make_gravity(const orr_scenario_gravity *g, const orr_mat3 *C, orr_moving *out,
                               orr_diag *diag)
{
    orr_gravity_parts p = {0};
    orr_gravity_file file;
    memset(&file, 0, sizeof file);
    orr_point_mass *mass = NULL;
    orr_status s = ORR_OK;
    if (g->model != NULL) {
        s = orr_gravity_model_open(g->model, g->folder, &out->model, diag);
        p.model = out->model;
    }
    if (g->has_profile) add_profile(&g->profile, &p);
    if (s == ORR_OK && g->file != NULL) {
        orr_bytes raw;
        s = orr_inputs_read_raw(&out->inputs, g->file, 0, &raw, diag);
        if (s == ORR_OK) s = orr_gravity_file_parse(g->file, raw.text, raw.n, &file, diag);
        orr_bytes_free(&raw);
        if (s == ORR_OK) s = add_file(g, &file, &p, diag);
    }
    if (s == ORR_OK) s = make_masses(g, C, &mass, diag);
    p.n_masses = g->masses.n;
    p.mass = mass;
    p.carried = C != NULL;
    if (C != NULL) p.carried_by = *C;
    if (s == ORR_OK && (p.model != NULL || p.n_profile + p.n_lat + p.n_masses > 0))
        s = orr_gravity_make(&p, &out->gravity, diag);
    if (s == ORR_OK) s = orr_gravity_covers(out->gravity, &out->trajectory, diag);
    orr_gravity_file_free(&file);
    free(mass);
    return s;
}

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
        s = make_plan(t, start, warnings, &out->trajectory, diag);
        break;
    case ORR_MOTION_TELEMETRY:
        s = make_telemetry(t, fallback_start, warnings, out, diag);
        break;
    case ORR_MOTION_ANALYTIC:
        s = make_analytic(t, start, &out->trajectory, diag);
        break;
    case ORR_MOTION_NONE:
        return orr_diag_set(diag, ORR_E_NODATA, "the scenario has no trajectory (trajectory.kind)");
    }
    orr_mat3 C;
    if (s == ORR_OK && t->has_transfer) s = transfer(&t->transfer, &out->trajectory, &C, diag);
    if (s == ORR_OK) s = make_gravity(&m->gravity, t->has_transfer ? &C : NULL, out, diag);
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Trajectories that the scenario describes: flights by plans, and analytic ones.
#include <stdlib.h>

#include "inertial/motion/analytic.h"
#include "inertial/motion/drape.h"
#include "inertial/motion/flight_plan.h"
#include "src/make/moving_private.h"

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

orr_status moving_make_plan(const orr_scenario_trajectory *m, orr_time start, orr_warnings *warnings,
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

orr_status moving_make_analytic(const orr_scenario_trajectory *m, orr_time start, orr_trajectory *out,
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

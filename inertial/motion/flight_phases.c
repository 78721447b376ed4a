// SPDX-License-Identifier: GPL-3.0-or-later
// A flight as a sequence of phases. They are pieces of one path, which is smoothed as a whole: the joints are as
// smooth as everything else.
#include <math.h>

#include "inertial/motion/flight_builder.h"

#define G_MPS2 9.80665
#define TAXI_MPS 8.0 // where nothing tells a speed

const char *orr_phase_name(orr_phase_kind kind)
{
    static const char *const name[] = {"rest",  "straight", "taxi",   "turn",   "takeoff",
                                       "climb", "to",       "survey", "landing"};
    return name[kind];
}

static bool on_ground(orr_phase_kind kind)
{
    return kind == ORR_PHASE_REST || kind == ORR_PHASE_TAXI || kind == ORR_PHASE_TAKEOFF;
}

// Straight and level for a length, or a time: to the speed, on at it, and to rest again where it stops.
static orr_status straight(flight_builder *b, const orr_phase *p, double speed_mps, orr_diag *diag)
{
    const double most = b->plan->acceleration_mps2;
    double reach_m = flight_speed_up_m(b, speed_mps),
           brake_m = p->stop ? 0.5 * speed_mps * speed_mps / most : 0.0;
    double even_m = p->length_m - reach_m - brake_m;
    if (p->duration_s > 0.0)
        even_m = speed_mps *
                 (p->duration_s - fabs(speed_mps - b->speed_mps) / most - (p->stop ? speed_mps / most : 0.0));
    if (even_m < -1e-6)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "from %.1f m/s to %.1f m/s%s takes %.0f m at %.2f m/s^2, which are %.0f m more than there are; "
            "lengthen it, change the speed less or allow more acceleration",
            b->speed_mps, speed_mps, p->stop ? " and to rest again" : "", reach_m + brake_m, most, -even_m);
    orr_status s = flight_go(b, reach_m, 0.0, 0, b->up_m, speed_mps, diag);
    if (s == ORR_OK) s = flight_go(b, even_m, 0.0, 0, b->up_m, speed_mps, diag);
    return s == ORR_OK ? flight_go(b, brake_m, 0.0, 0, b->up_m, 0.0, diag) : s;
}

static orr_status turn(flight_builder *b, const orr_phase *p, orr_diag *diag)
{
    double radius_m = p->radius_m;
    orr_status s = ORR_OK;
    if (!(b->speed_mps > 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "it begins at rest, and a body at rest does not turn");
    if (!(radius_m > 0.0)) s = flight_turn_radius(b->plan, b->speed_mps, &radius_m, diag);
    double bank = atan(b->speed_mps * b->speed_mps / (G_MPS2 * radius_m));
    if (s == ORR_OK && b->airborne && bank > b->plan->bank_rad + 1e-9)
        return orr_diag_set(
            diag, ORR_E_ARG, "%.0f m of radius at %.1f m/s need %.1f deg of bank; %.1f deg are allowed",
            radius_m, b->speed_mps, bank * ORR_DEG_PER_RAD, b->plan->bank_rad * ORR_DEG_PER_RAD);
    return s == ORR_OK ? flight_go(b, radius_m * fabs(p->angle_rad), radius_m, p->angle_rad > 0.0 ? 1 : -1,
                                   b->up_m, b->speed_mps, diag)
                       : s;
}

// Straight on to a height, at a vertical speed.
static orr_status climb(flight_builder *b, double height_m, double rate_mps, orr_diag *diag)
{
    double to_up_m = height_m - b->path->map.height_m;
    if (!(b->speed_mps > 0.0) || !b->airborne)
        return orr_diag_set(diag, ORR_E_ARG, "the body is on the ground: it has to take off first");
    return flight_go(b, fabs(to_up_m - b->up_m) / rate_mps * b->speed_mps, 0.0, 0, to_up_m, b->speed_mps,
                     diag);
}

static orr_status landing(flight_builder *b, const orr_phase *p, double rate_mps, orr_diag *diag)
{
    orr_status s = b->airborne ? ORR_OK : orr_diag_set(diag, ORR_E_ARG, "the body is on the ground already");
    if (s == ORR_OK) s = flight_speed_up(b, p->speed_mps > 0.0 ? p->speed_mps : b->speed_mps, HUGE_VAL, diag);
    if (s == ORR_OK) s = climb(b, p->height_m, rate_mps, diag);
    b->airborne = false;
    return s == ORR_OK ? flight_speed_up(b, 0.0, HUGE_VAL, diag) : s;
}

static orr_status fly(flight_builder *b, const orr_phase *p, orr_diag *diag)
{
    const orr_flight_plan *plan = b->plan;
    double rate_mps = p->rate_mps > 0.0 ? p->rate_mps : plan->climb_limit_mps, radius_m;
    double speed_mps = p->speed_mps > 0.0 ? p->speed_mps : b->speed_mps;
    orr_status s = ORR_OK;
    if ((p->kind == ORR_PHASE_TO || p->kind == ORR_PHASE_SURVEY) && !b->airborne)
        return orr_diag_set(diag, ORR_E_ARG, "the body is on the ground: it has to take off first");
    switch (p->kind) {
    case ORR_PHASE_REST:
        if (b->speed_mps > 0.0)
            return orr_diag_set(diag, ORR_E_ARG,
                                "it begins at %.1f m/s; a landing, or a taxi with speed 0, ends at rest",
                                b->speed_mps);
        return flight_rest(b, p->duration_s, diag);
    case ORR_PHASE_TAXI:
        if (b->airborne) return orr_diag_set(diag, ORR_E_ARG, "the body is in the air: it has to land first");
        return straight(b, p, speed_mps > 0.0 ? speed_mps : TAXI_MPS, diag);
    case ORR_PHASE_STRAIGHT:
        if (!(speed_mps > 0.0)) return orr_diag_set(diag, ORR_E_ARG, "it begins at rest and names no speed");
        return straight(b, p, speed_mps, diag);
    case ORR_PHASE_TURN:
        return turn(b, p, diag);
    case ORR_PHASE_TAKEOFF:
        if (b->airborne) return orr_diag_set(diag, ORR_E_ARG, "the body is in the air already");
        s = flight_speed_up(b, p->speed_mps > 0.0 ? p->speed_mps : plan->speed_mps, HUGE_VAL, diag);
        b->airborne = true;
        return s;
    case ORR_PHASE_CLIMB:
        return climb(b, p->height_m, rate_mps, diag);
    case ORR_PHASE_TO:
        s = flight_turn_radius(plan, b->speed_mps, &radius_m, diag);
        return s == ORR_OK ? flight_to(b, flight_pose(&b->path->map, p->at, p->azimuth_rad), radius_m, diag)
                           : s;
    case ORR_PHASE_SURVEY:
        return flight_lines(b, &p->survey, flight_pose(&b->path->map, p->at, p->survey.azimuth_rad), diag);
    case ORR_PHASE_LANDING:
        return landing(b, p, rate_mps, diag);
    }
    return ORR_OK;
}

orr_status flight_phases(flight_builder *b, orr_diag *diag)
{
    const orr_flight_plan *plan = b->plan;
    if (plan->n_phases > ORR_PLAN_MAX_PHASES)
        return orr_diag_set(diag, ORR_E_ARG, "%zu phases; a flight has at most %d", plan->n_phases,
                            ORR_PLAN_MAX_PHASES);
    b->pose = (orr_pose){0.0, 0.0, plan->course_rad};
    b->airborne = !on_ground(plan->phase[0].kind);
    b->speed_mps = b->airborne ? plan->speed_mps : 0.0;
    for (size_t k = 0; k < plan->n_phases; k++) {
        orr_diag why = {0};
        orr_status s = fly(b, &plan->phase[k], &why);
        if (s != ORR_OK)
            return orr_diag_set(diag, s, "phase %zu (%s): %s", k + 1, orr_phase_name(plan->phase[k].kind),
                                why.text);
    }
    if (b->path->n == 0) return orr_diag_set(diag, ORR_E_ARG, "the phases last no time");
    return ORR_OK;
}

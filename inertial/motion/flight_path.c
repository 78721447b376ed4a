// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/flight_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"

#define G_MPS2 9.80665

typedef struct builder {
    orr_flight_path *path;
    double speed_mps, up_m;
} builder;

static orr_status append(builder *b, const orr_path_piece *piece, double to_up_m, orr_diag *diag)
{
    if (!(piece->length_m > 0.0)) return ORR_OK;
    orr_flight_path *p = b->path;
    if (!ORR_ARRAY_GROW(p->piece, p->n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a flight plan of more than %zu pieces", p->n);
    orr_flight_piece *q = &p->piece[p->n++];
    q->path = *piece;
    q->from_s = p->duration_s;
    q->to_s = p->duration_s += piece->length_m / b->speed_mps;
    q->speed_mps = b->speed_mps;
    q->from_up_m = b->up_m;
    q->to_up_m = b->up_m = to_up_m;
    p->length_m += piece->length_m;
    return ORR_OK;
}

static orr_status turn_radius(const orr_flight_plan *plan, double speed_mps, double *radius_m, orr_diag *diag)
{
    double tightest = speed_mps * speed_mps / (G_MPS2 * tan(plan->bank_rad));
    *radius_m = plan->turn_radius_m > 0.0 ? plan->turn_radius_m : tightest;
    if (plan->turn_radius_m > 0.0 && plan->turn_radius_m < tightest)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a turn of %.0f m radius is too tight for %.1f m/s: it needs %.1f deg of bank "
                            "and %.1f deg are allowed; "
                            "take at least %.0f m",
                            plan->turn_radius_m, speed_mps,
                            ORR_DEG_PER_RAD * atan(speed_mps * speed_mps / (G_MPS2 * plan->turn_radius_m)),
                            ORR_DEG_PER_RAD * plan->bank_rad, ceil(tightest));
    return ORR_OK;
}

static orr_path_piece straight(orr_pose from, double length_m)
{
    return (orr_path_piece){.from = from, .length_m = length_m, .radius_m = 0.0, .turn = 0};
}

// --- Survey ---

static orr_pose shifted(orr_pose p, double ahead_m, double right_m)
{
    double s = sin(p.course_rad), c = cos(p.course_rad);
    p.east_m += ahead_m * s + right_m * c;
    p.north_m += ahead_m * c - right_m * s;
    return p;
}

static orr_pose reversed(orr_pose p)
{
    p.course_rad += ORR_PI;
    return p;
}

static orr_status fly_line(builder *b, orr_pose begin, double length_m, double lead_m, double radius_m,
                           orr_diag *diag)
{
    orr_pose from = shifted(begin, -lead_m, 0.0);
    orr_flight_path *p = b->path;
    orr_status s = ORR_OK;
    if (p->n > 0) {
        const orr_path_piece *last = &p->piece[p->n - 1].path;
        orr_path_piece piece[3];
        orr_dubins(orr_path_at(last, last->length_m), from, radius_m, piece);
        for (int i = 0; i < 3 && s == ORR_OK; i++) s = append(b, &piece[i], b->up_m, diag);
    }
    orr_path_piece line = straight(from, length_m + 2.0 * lead_m);
    return s == ORR_OK ? append(b, &line, b->up_m, diag) : s;
}

static orr_status survey_path(const orr_flight_plan *plan, builder *b, orr_diag *diag)
{
    const orr_survey *v = &plan->survey;
    if (v->lines < 1 || v->lines > ORR_PLAN_MAX_LINES || v->tie_lines < 0 ||
        v->tie_lines > ORR_PLAN_MAX_LINES)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a survey of %d lines and %d tie lines; 1 to %d and 0 to %d are possible",
                            v->lines, v->tie_lines, ORR_PLAN_MAX_LINES, ORR_PLAN_MAX_LINES);
    if (!(v->length_m > 0.0) || (v->lines > 1 && !(v->spacing_m > 0.0)) ||
        (v->tie_lines > 0 && !(v->tie_spacing_m > 0.0)))
        return orr_diag_set(diag, ORR_E_ARG,
                            "survey lines need a positive length, and spacings where there are several");
    double side = v->to_left ? -1.0 : 1.0, lead = plan->lead_m, radius;
    orr_status s = turn_radius(plan, b->speed_mps, &radius, diag);
    b->path->radius_m = radius;
    orr_pose first = {0.0, 0.0, v->azimuth_rad};
    for (int k = 0; k < v->lines && s == ORR_OK; k++) {
        orr_pose begin = shifted(first, 0.0, side * v->spacing_m * k);
        if (k % 2 == 1) begin = reversed(shifted(begin, v->length_m, 0.0));
        s = fly_line(b, begin, v->length_m, lead, radius, diag);
    }
    double width = v->spacing_m * (v->lines - 1);
    for (int k = 0; k < v->tie_lines && s == ORR_OK; k++) {
        // Ties go from the last line's side back and forth across all lines.
        orr_pose begin = shifted(first, v->tie_spacing_m * (k + 1), side * width);
        begin.course_rad -= side * 0.5 * ORR_PI;
        if (k % 2 == 1) begin = reversed(shifted(begin, width, 0.0));
        s = fly_line(b, begin, width, lead, radius, diag);
    }
    return s;
}

// --- Waypoints: straight legs, joined by arcs that begin before the waypoint and end behind it ---

static orr_status waypoint_path(const orr_flight_plan *plan, builder *b, orr_diag *diag)
{
    size_t n = plan->n_waypoints;
    if (n < 2 || n > ORR_PLAN_MAX_WAYPOINTS)
        return orr_diag_set(diag, ORR_E_ARG, "%zu waypoints; a flight has 2 to %d", n,
                            ORR_PLAN_MAX_WAYPOINTS);
    orr_vec3 here = orr_local_map_from_ecef(&b->path->map, orr_earth_to_ecef(plan->waypoint[0].at));
    double cut = 0.0, course = 0.0;
    for (size_t k = 0; k + 1 < n; k++) {
        if (plan->waypoint[k].speed_mps > 0.0) b->speed_mps = plan->waypoint[k].speed_mps;
        orr_vec3 next = orr_local_map_from_ecef(&b->path->map, orr_earth_to_ecef(plan->waypoint[k + 1].at));
        double leg = hypot(next.x - here.x, next.y - here.y);
        course = atan2(next.x - here.x, next.y - here.y);
        if (!(leg > 1.0))
            return orr_diag_set(diag, ORR_E_ARG, "waypoints %zu and %zu are at the same place", k + 1, k + 2);
        double turn = 0.0, radius = 0.0, cut_next = 0.0;
        if (k + 2 < n) {
            orr_vec3 after =
                orr_local_map_from_ecef(&b->path->map, orr_earth_to_ecef(plan->waypoint[k + 2].at));
            turn = remainder(atan2(after.x - next.x, after.y - next.y) - course, 2.0 * ORR_PI);
            orr_status s = turn_radius(plan, b->speed_mps, &radius, diag);
            if (s != ORR_OK) return s;
            b->path->radius_m = radius;
            cut_next = radius * tan(0.5 * fabs(turn));
        }
        if (!(cut + cut_next <= leg))
            return orr_diag_set(diag, ORR_E_ARG,
                                "the leg from waypoint %zu to %zu is %.0f m long, but its turns of %.0f m "
                                "radius at %.1f m/s need %.0f m; "
                                "fly slower, bank more or move the waypoints apart",
                                k + 1, k + 2, leg, radius, b->speed_mps, cut + cut_next);
        double line = leg - cut - cut_next, rise = next.z - b->up_m;
        double rate = line > 0.0 ? rise / line * b->speed_mps : rise == 0.0 ? 0.0 : HUGE_VAL;
        if (fabs(rate) > plan->climb_limit_mps)
            return orr_diag_set(diag, ORR_E_ARG,
                                "from waypoint %zu to %zu the height changes by %.0f m, which takes %.1f m/s "
                                "of climb; %.1f m/s are allowed",
                                k + 1, k + 2, rise, fabs(rate), plan->climb_limit_mps);
        orr_pose from = {here.x + cut * sin(course), here.y + cut * cos(course), course};
        orr_path_piece piece = straight(from, line);
        orr_status s = append(b, &piece, next.z, diag);
        if (s == ORR_OK && turn != 0.0) {
            orr_path_piece arc = {.from = orr_path_at(&piece, line),
                                  .length_m = radius * fabs(turn),
                                  .radius_m = radius,
                                  .turn = turn > 0.0 ? 1 : -1};
            s = append(b, &arc, next.z, diag);
        }
        if (s != ORR_OK) return s;
        here = next;
        cut = cut_next;
    }
    return ORR_OK;
}

orr_status orr_flight_path_make(const orr_flight_plan *plan, orr_flight_path *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_geodetic origin = plan->survey.start;
    if (plan->n_waypoints > 0) {
        // The middle of the waypoints, so that a plan across a pole or the date line is in the middle of its
        // map.
        orr_vec3 sum = {0, 0, 0};
        for (size_t k = 0; k < plan->n_waypoints; k++) {
            orr_geodetic g = plan->waypoint[k].at;
            if (!(fabs(g.lat_rad) <= 0.5 * ORR_PI) || !isfinite(g.lon_rad) || !(fabs(g.height_m) < 1e6))
                return orr_diag_set(diag, ORR_E_ARG,
                                    "waypoint %zu (latitude %.4f deg, height %.0f m) is not near the Earth",
                                    k + 1, g.lat_rad * ORR_DEG_PER_RAD, g.height_m);
            sum = orr_vec3_add(sum, orr_earth_to_ecef(g));
        }
        origin = orr_earth_from_ecef(orr_vec3_scale(1.0 / (double)plan->n_waypoints, sum));
        origin.height_m = plan->waypoint[0].at.height_m;
    }
    if (!(fabs(origin.lat_rad) <= 0.5 * ORR_PI) || !isfinite(origin.lon_rad) ||
        !(fabs(origin.height_m) < 1e6))
        return orr_diag_set(diag, ORR_E_ARG,
                            "the survey's start (latitude %.4f deg, height %.0f m) is not near the Earth",
                            origin.lat_rad * ORR_DEG_PER_RAD, origin.height_m);
    if (!(plan->speed_mps > 0.0 && plan->speed_mps < 3000.0))
        return orr_diag_set(diag, ORR_E_ARG, "a speed of %g m/s; it has to be above 0 and below 3000",
                            plan->speed_mps);
    if (!(plan->bank_rad > 0.0 && plan->bank_rad <= 80.0 * ORR_RAD_PER_DEG))
        return orr_diag_set(diag, ORR_E_ARG, "a bank of %.1f deg; it has to be above 0 and at most 80",
                            plan->bank_rad * ORR_DEG_PER_RAD);
    out->map = orr_local_map_make(origin);
    builder b = {.path = out, .speed_mps = plan->speed_mps};
    orr_status s = plan->n_waypoints > 0 ? waypoint_path(plan, &b, diag) : survey_path(plan, &b, diag);
    for (size_t k = 0; k < out->n && s == ORR_OK; k++) {
        orr_pose p = orr_path_at(&out->piece[k].path, out->piece[k].path.length_m);
        if (hypot(p.east_m, p.north_m) > ORR_LOCAL_MAP_REACH_M)
            s = orr_diag_set(diag, ORR_E_ARG,
                             "the plan reaches %.0f km from its middle; %.0f km is the limit, divide it",
                             hypot(p.east_m, p.north_m) / 1e3, ORR_LOCAL_MAP_REACH_M / 1e3);
    }
    if (s != ORR_OK) orr_flight_path_free(out);
    return s;
}

void orr_flight_path_free(orr_flight_path *p)
{
    free(p->piece);
    memset(p, 0, sizeof *p);
}

orr_vec3 orr_flight_path_at(const orr_flight_path *p, double t_s, size_t *hint)
{
    size_t k = *hint < p->n ? *hint : 0;
    while (k > 0 && t_s < p->piece[k].from_s) k--;
    while (k + 1 < p->n && t_s >= p->piece[k].to_s) k++;
    *hint = k;
    const orr_flight_piece *q = &p->piece[k];
    double along = (t_s - q->from_s) * q->speed_mps, L = q->path.length_m;
    double share = (t_s - q->from_s) / (q->to_s - q->from_s);
    orr_path_piece path = q->path;
    if (along < 0.0) {
        path.turn = 0;
        share = 0.0;
    } else if (along > L) {
        path.from = orr_path_at(&q->path, L);
        path.turn = 0;
        along -= L;
        share = 1.0;
    }
    orr_pose at = orr_path_at(&path, along);
    return orr_vec3_make(at.east_m, at.north_m, q->from_up_m + share * (q->to_up_m - q->from_up_m));
}

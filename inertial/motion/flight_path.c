// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/flight_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/flight_builder.h"

// --- Waypoints: straight legs, joined by arcs that begin before the waypoint and end behind it ---

static orr_status waypoint_path(const orr_flight_plan *plan, flight_builder *b, orr_diag *diag)
{
    size_t n = plan->n_waypoints;
    if (n < 2 || n > ORR_PLAN_MAX_WAYPOINTS)
        return orr_diag_set(diag, ORR_E_ARG, "%zu waypoints; a flight has 2 to %d", n,
                            ORR_PLAN_MAX_WAYPOINTS);
    orr_vec3 here = orr_local_map_from_ecef(&b->path->map, orr_earth_to_ecef(plan->waypoint[0].at));
    double cut = 0.0, course = 0.0;
    for (size_t k = 0; k + 1 < n; k++) {
        double speed = plan->waypoint[k].speed_mps > 0.0 ? plan->waypoint[k].speed_mps : b->speed_mps;
        if (k == 0) b->speed_mps = speed;
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
            orr_status s = flight_turn_radius(plan, speed, &radius, diag);
            if (s != ORR_OK) return s;
            b->path->radius_m = radius;
            cut_next = radius * tan(0.5 * fabs(turn));
        }
        if (!(cut + cut_next <= leg))
            return orr_diag_set(diag, ORR_E_ARG,
                                "the leg from waypoint %zu to %zu is %.0f m long, but its turns of %.0f m "
                                "radius at %.1f m/s need %.0f m; "
                                "fly slower, bank more or move the waypoints apart",
                                k + 1, k + 2, leg, radius, speed, cut + cut_next);
        double line = leg - cut - cut_next, rise = next.z - b->up_m;
        double fastest = fmax(speed, b->speed_mps);
        double rate = line > 0.0 ? rise / line * fastest : rise == 0.0 ? 0.0 : HUGE_VAL;
        if (fabs(rate) > plan->climb_limit_mps)
            return orr_diag_set(diag, ORR_E_ARG,
                                "from waypoint %zu to %zu the height changes by %.0f m, which takes %.1f m/s "
                                "of climb; %.1f m/s are allowed",
                                k + 1, k + 2, rise, fabs(rate), plan->climb_limit_mps);
        double change = flight_speed_up_m(b, speed);
        if (change > line)
            return orr_diag_set(
                diag, ORR_E_ARG,
                "behind waypoint %zu the speed changes from %.1f to %.1f m/s, which takes %.0f m at "
                "%.2f m/s^2; the straight part of the leg has %.0f m: allow more acceleration, change "
                "the speed less or move the waypoints apart",
                k + 1, b->speed_mps, speed, change, plan->acceleration_mps2, line);
        b->pose = (orr_pose){here.x + cut * sin(course), here.y + cut * cos(course), course};
        double middle = line > 0.0 ? b->up_m + rise * change / line : b->up_m;
        orr_status s = flight_go(b, change, 0.0, 0, middle, speed, diag);
        if (s == ORR_OK) s = flight_go(b, line - change, 0.0, 0, next.z, speed, diag);
        if (s == ORR_OK)
            s = flight_go(b, radius * fabs(turn), radius, turn > 0.0 ? 1 : -1, next.z, speed, diag);
        if (s != ORR_OK) return s;
        here = next;
        cut = cut_next;
    }
    return ORR_OK;
}

orr_status orr_flight_path_make(const orr_flight_plan *plan, orr_flight_path *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_geodetic origin = plan->n_phases > 0 ? plan->start : plan->survey.start;
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
                            "the start (latitude %.4f deg, height %.0f m) is not near the Earth",
                            origin.lat_rad * ORR_DEG_PER_RAD, origin.height_m);
    if (!(plan->speed_mps > 0.0 && plan->speed_mps < 3000.0))
        return orr_diag_set(diag, ORR_E_ARG, "a speed of %g m/s; it has to be above 0 and below 3000",
                            plan->speed_mps);
    if (!(plan->bank_rad > 0.0 && plan->bank_rad <= 80.0 * ORR_RAD_PER_DEG))
        return orr_diag_set(diag, ORR_E_ARG, "a bank of %.1f deg; it has to be above 0 and at most 80",
                            plan->bank_rad * ORR_DEG_PER_RAD);
    if (!(plan->acceleration_mps2 > 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "an acceleration of %g m/s^2; it has to be above 0",
                            plan->acceleration_mps2);
    out->map = orr_local_map_make(origin);
    flight_builder b = {.plan = plan, .path = out, .speed_mps = plan->speed_mps, .airborne = true};
    orr_pose first = {0.0, 0.0, plan->survey.azimuth_rad};
    orr_status s = plan->n_phases > 0      ? flight_phases(&b, diag)
                   : plan->n_waypoints > 0 ? waypoint_path(plan, &b, diag)
                                           : flight_lines(&b, &plan->survey, first, diag);
    if (plan->n_waypoints > 0) out->lines = plan->n_waypoints - 1;
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
    double t = t_s - q->from_s, T = q->to_s - q->from_s, L = q->path.length_m;
    orr_path_piece path = q->path;
    double along = q->from_mps * t + 0.5 * (q->to_mps - q->from_mps) / T * t * t;
    // Beyond the ends straight on, climbing as before: smoothing then leaves the ends where they are.
    double share = L > 0.0 ? along / L : 0.0;
    if (t < 0.0) {
        path.turn = 0;
        along = q->from_mps * t;
        share = L > 0.0 ? along / L : 0.0;
    } else if (t > T) {
        path.from = orr_path_at(&q->path, L);
        path.turn = 0;
        along = q->to_mps * (t - T);
        share = L > 0.0 && !p->level_off ? 1.0 + along / L : 1.0;
    }
    orr_pose at = orr_path_at(&path, along);
    return orr_vec3_make(at.east_m, at.north_m, q->from_up_m + share * (q->to_up_m - q->from_up_m));
}

double orr_flight_path_course(const orr_flight_path *p, double t_s, size_t k)
{
    const orr_flight_piece *q = &p->piece[k];
    double T = q->to_s - q->from_s, t = fmin(fmax(t_s - q->from_s, 0.0), T);
    return orr_path_at(&q->path, q->from_mps * t + 0.5 * (q->to_mps - q->from_mps) / T * t * t).course_rad;
}

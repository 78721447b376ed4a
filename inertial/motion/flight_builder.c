// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/flight_builder.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"

#define G_MPS2 9.80665

static orr_status append(flight_builder *b, const orr_flight_piece *piece, orr_diag *diag)
{
    orr_flight_path *p = b->path;
    if (!ORR_ARRAY_GROW(p->piece, p->n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a flight plan of more than %zu pieces", p->n);
    p->piece[p->n++] = *piece;
    p->duration_s = piece->to_s;
    p->length_m += piece->path.length_m;
    p->has_ground = p->has_ground || !piece->airborne;
    b->speed_mps = piece->to_mps;
    b->up_m = piece->to_up_m;
    b->pose = orr_path_at(&piece->path, piece->path.length_m);
    return ORR_OK;
}

orr_status flight_go(flight_builder *b, double length_m, double radius_m, int turn, double to_up_m,
                     double to_speed_mps, orr_diag *diag)
{
    if (!(length_m > 0.0)) return ORR_OK;
    double begin_s = b->path->duration_s;
    orr_flight_piece q = {.path = {.from = b->pose, .length_m = length_m, .radius_m = radius_m, .turn = turn},
                          .from_s = begin_s,
                          .to_s = begin_s + 2.0 * length_m / (b->speed_mps + to_speed_mps),
                          .from_mps = b->speed_mps,
                          .to_mps = to_speed_mps,
                          .from_up_m = b->up_m,
                          .to_up_m = to_up_m,
                          .airborne = b->airborne};
    return append(b, &q, diag);
}

orr_status flight_rest(flight_builder *b, double duration_s, orr_diag *diag)
{
    if (!(duration_s > 0.0)) return ORR_OK;
    double begin_s = b->path->duration_s;
    orr_flight_piece q = {.path = {.from = b->pose},
                          .from_s = begin_s,
                          .to_s = begin_s + duration_s,
                          .from_up_m = b->up_m,
                          .to_up_m = b->up_m,
                          .airborne = b->airborne};
    return append(b, &q, diag);
}

double flight_speed_up_m(const flight_builder *b, double to_speed_mps)
{
    return fabs(to_speed_mps * to_speed_mps - b->speed_mps * b->speed_mps) /
           (2.0 * b->plan->acceleration_mps2);
}

orr_status flight_speed_up(flight_builder *b, double to_speed_mps, double most_m, orr_diag *diag)
{
    double need_m = flight_speed_up_m(b, to_speed_mps);
    if (need_m > most_m)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "from %.1f to %.1f m/s takes %.0f m at %.2f m/s^2, and there are %.0f m of straight way; "
            "allow more acceleration, change the speed less or lengthen the way",
            b->speed_mps, to_speed_mps, need_m, b->plan->acceleration_mps2, most_m);
    return flight_go(b, need_m, 0.0, 0, b->up_m, to_speed_mps, diag);
}

orr_status flight_turn_radius(const orr_flight_plan *plan, double speed_mps, double *radius_m, orr_diag *diag)
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

orr_status flight_to(flight_builder *b, orr_pose to, double radius_m, orr_diag *diag)
{
    orr_path_piece piece[3];
    orr_status s = ORR_OK;
    orr_dubins(b->pose, to, radius_m, piece);
    for (int i = 0; i < 3 && s == ORR_OK; i++)
        s = flight_go(b, piece[i].length_m, radius_m, piece[i].turn, b->up_m, b->speed_mps, diag);
    b->pose = to; // to the bit
    return s;
}

orr_pose flight_pose(const orr_local_map *map, orr_geodetic at, double azimuth_rad)
{
    orr_geodetic ahead = at;
    double azimuth;
    orr_earth_geodesic_direct(at.lat_rad, at.lon_rad, azimuth_rad, 100.0, &ahead.lat_rad, &ahead.lon_rad,
                              &azimuth);
    orr_vec3 p = orr_local_map_from_ecef(map, orr_earth_to_ecef(at)),
             q = orr_local_map_from_ecef(map, orr_earth_to_ecef(ahead));
    return (orr_pose){p.x, p.y, atan2(q.x - p.x, q.y - p.y)};
}

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

static orr_status fly_line(flight_builder *b, orr_pose begin, double length_m, double radius_m,
                           orr_diag *diag)
{
    const double lead_m = b->plan->lead_m;
    orr_pose from = shifted(begin, -lead_m, 0.0);
    orr_status s = ORR_OK;
    if (b->path->n > 0)
        s = flight_to(b, from, radius_m, diag);
    else
        b->pose = from;
    return s == ORR_OK ? flight_go(b, length_m + 2.0 * lead_m, 0.0, 0, b->up_m, b->speed_mps, diag) : s;
}

orr_status flight_lines(flight_builder *b, const orr_survey *v, orr_pose first, orr_diag *diag)
{
    if (v->lines < 1 || v->lines > ORR_PLAN_MAX_LINES || v->tie_lines < 0 ||
        v->tie_lines > ORR_PLAN_MAX_LINES)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a survey of %d lines and %d tie lines; 1 to %d and 0 to %d are possible",
                            v->lines, v->tie_lines, ORR_PLAN_MAX_LINES, ORR_PLAN_MAX_LINES);
    if (!(v->length_m > 0.0) || (v->lines > 1 && !(v->spacing_m > 0.0)) ||
        (v->tie_lines > 0 && !(v->tie_spacing_m > 0.0)))
        return orr_diag_set(diag, ORR_E_ARG,
                            "survey lines need a positive length, and spacings where there are several");
    double side = v->to_left ? -1.0 : 1.0, radius;
    orr_status s = flight_turn_radius(b->plan, b->speed_mps, &radius, diag);
    b->path->radius_m = radius;
    b->path->lines += (size_t)(v->lines + v->tie_lines);
    for (int k = 0; k < v->lines && s == ORR_OK; k++) {
        orr_pose begin = shifted(first, 0.0, side * v->spacing_m * k);
        if (k % 2 == 1) begin = reversed(shifted(begin, v->length_m, 0.0));
        s = fly_line(b, begin, v->length_m, radius, diag);
    }
    double width = v->spacing_m * (v->lines - 1);
    for (int k = 0; k < v->tie_lines && s == ORR_OK; k++) {
        // Ties go from the last line's side back and forth across all lines.
        orr_pose begin = shifted(first, v->tie_spacing_m * (k + 1), side * width);
        begin.course_rad -= side * 0.5 * ORR_PI;
        if (k % 2 == 1) begin = reversed(shifted(begin, width, 0.0));
        s = fly_line(b, begin, width, radius, diag);
    }
    return s;
}

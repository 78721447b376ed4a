// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/seen.h"

#include <math.h>

#include "core/angle.h"
#include "core/limb.h"

// Elevation below which nothing is seen at an azimuth.
static double horizon_rad(const orr_scenario_mask *mask, double az_rad)
{
    const size_t n = mask->horizon.n;
    double el = mask->elevation_deg;
    if (n > 0) {
        const orr_scenario_obstacle *o = mask->horizon.item;
        const double az = az_rad * ORR_DEG_PER_RAD;
        size_t k = 0;
        while (k < n && o[k].azimuth_deg <= az) k++;
        const orr_scenario_obstacle *a = &o[(k + n - 1) % n], *b = &o[k % n];
        double span = b->azimuth_deg - a->azimuth_deg, in = az - a->azimuth_deg;
        if (k == 0 || k == n) {
            span += 360;
            if (in < 0) in += 360;
        }
        const double part = span > 0 ? in / span : 0;
        el = fmax(el, a->elevation_deg + part * (b->elevation_deg - a->elevation_deg));
    }
    return el * ORR_RAD_PER_DEG;
}

// Whether the Earth stands before a satellite; from space its air as well.
static bool behind_the_earth(orr_vec3 r_m, orr_vec3 sat_m, double el_rad)
{
    return el_rad < 0 && orr_limb_hides(r_m, sat_m, orr_limb_in_space(r_m) ? ORR_SPACE_HEIGHT_M : 0);
}

seen_direction seen_at(const orr_channels *c, size_t antenna, const orr_antenna_state *at, orr_vec3 sat_m)
{
    const orr_scenario_mask *mask = &c->mask;
    const orr_vec3 d = orr_vec3_sub(sat_m, at->r_m), own = orr_mat3_apply(&at->enu, d);
    seen_direction out;
    const double az = orr_atan2(own.x, own.y);
    out.az_rad = az < 0 ? az + 2 * ORR_PI : az;
    out.el_rad = orr_atan2(own.z, sqrt(own.x * own.x + own.y * own.y));
    out.seen = out.el_rad >= horizon_rad(mask, out.az_rad) && !behind_the_earth(at->r_m, sat_m, out.el_rad) &&
               !orr_terrain_hides(c->terrain, antenna, out.az_rad, out.el_rad) &&
               !orr_obstacles_wall(c->obstacles, at, orr_vec3_unit(d));
    if (!out.seen || !mask->has_body || c->antenna[antenna].motion == NULL) return out;
    const orr_vec3 body = orr_mat3_apply(&at->axes, orr_vec3_unit(d));
    out.seen = asin(fmin(fmax(body.z, -1), 1)) >= mask->body_deg * ORR_RAD_PER_DEG;
    return out;
}

bool orr_channels_sees(const orr_channels *c, size_t antenna, const orr_antenna_state *at, orr_vec3 sat_m)
{
    return seen_at(c, antenna, at, sat_m).seen;
}

// Whether a satellite, at the middle of a cell, is above an elevation so much lower than the mask that within half a cell it
// cannot come up: seen from the ground or from a low orbit no satellite turns by more than 1.2e-3 rad/s.
static bool may_rise(const orr_vec3 *sat_m, const orr_antenna_state *at, double least_sine)
{
    const orr_vec3 d = orr_vec3_sub(*sat_m, at->r_m);
    const orr_vec3 up = {at->enu.m[2][0], at->enu.m[2][1], at->enu.m[2][2]};
    return orr_vec3_dot(d, up) >= least_sine * orr_vec3_norm(d);
}

void seen_candidates(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                     const orr_antenna_state *at)
{
    static const double MARGIN_RAD = 0.015;
    channel_antenna_work *w = &work->antenna[antenna];
    const orr_time from = lattice_cell(t);
    if (w->candidates_of == from) return;
    const double least = sin(fmax(c->mask.elevation_deg * ORR_RAD_PER_DEG - MARGIN_RAD, -ORR_PI / 2));
    const size_t n =
        orr_ephemeris_eval_all(channels_ephemeris(c), from + LATTICE_NS / 2, work->state, c->n_sats);
    w->n_candidates = 0;
    for (size_t k = 0, j = 0; k < c->n_sats;
         k++) { // both lists ascend; a satellite without an arc in the middle may have one
        const channel_satellite *sat = &c->satellite[k];
        while (j < n && work->state[j].sat < sat->sat) j++;
        const bool known = j < n && work->state[j].sat == sat->sat;
        if (sat->n_sent > 0 && (!known || may_rise(&work->state[j].pos_m, at, least)))
            w->candidate[w->n_candidates++] = (uint16_t)k;
    }
    w->candidates_of = from;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/obstacle.h"

#include <math.h>
#include <stdlib.h>

// A line on the ground, in axes of East, North and Up at its begin: flat, which over a kilometre is right to 8 cm.
typedef struct ground_line {
    orr_vec3 r_m; // its begin, on the ellipsoid, ecef
    orr_mat3 enu;
    double east_m, north_m; // its end
} ground_line;

typedef struct wall {
    ground_line line;
    double bottom_m, top_m;
} wall;

typedef struct tunnel {
    bool by_time;
    orr_interval during;
    ground_line line;
    double width_m;
} tunnel;

struct orr_obstacles {
    size_t n_walls, n_tunnels;
    wall *wall;
    tunnel *tunnel;
};

static ground_line line_of(const double *from, const double *to)
{
    const orr_geodetic a = {from[0] * ORR_RAD_PER_DEG, from[1] * ORR_RAD_PER_DEG, 0},
                       b = {to[0] * ORR_RAD_PER_DEG, to[1] * ORR_RAD_PER_DEG, 0};
    ground_line l = {.r_m = orr_earth_to_ecef(a), .enu = orr_earth_enu_from_ecef(a.lat_rad, a.lon_rad)};
    const orr_vec3 end = orr_mat3_apply(&l.enu, orr_vec3_sub(orr_earth_to_ecef(b), l.r_m));
    l.east_m = end.x;
    l.north_m = end.y;
    return l;
}

orr_status orr_obstacles_open(const orr_scenario *s, orr_obstacles **out, orr_diag *diag)
{
    const orr_scenario_obstacles *x = &s->obstacles;
    *out = NULL;
    if (x->walls.n + x->tunnels.n == 0) return ORR_OK;
    orr_obstacles *o = calloc(1, sizeof *o);
    if (o != NULL) {
        o->wall = calloc(x->walls.n + 1, sizeof *o->wall);
        o->tunnel = calloc(x->tunnels.n + 1, sizeof *o->tunnel);
    }
    if (o == NULL || o->wall == NULL || o->tunnel == NULL) {
        orr_obstacles_close(o);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    for (; o->n_walls < x->walls.n; o->n_walls++) {
        const orr_scenario_wall *w = &x->walls.item[o->n_walls];
        o->wall[o->n_walls] = (wall){line_of(w->from.item, w->to.item), w->bottom_m, w->top_m};
    }
    for (; o->n_tunnels < x->tunnels.n; o->n_tunnels++) {
        const orr_scenario_tunnel *t = &x->tunnels.item[o->n_tunnels];
        tunnel *k = &o->tunnel[o->n_tunnels];
        *k = (tunnel){.by_time = t->has_during, .during = t->during, .width_m = t->width_m};
        if (!k->by_time) k->line = line_of(t->from.item, t->to.item);
    }
    *out = o;
    return ORR_OK;
}

void orr_obstacles_close(orr_obstacles *o)
{
    if (o == NULL) return;
    free(o->wall);
    free(o->tunnel);
    free(o);
}

static bool inside(const tunnel *t, orr_vec3 r_m)
{
    const ground_line *l = &t->line;
    const orr_vec3 x = orr_mat3_apply(&l->enu, orr_vec3_sub(r_m, l->r_m));
    const double length2 = l->east_m * l->east_m + l->north_m * l->north_m,
                 along = (x.x * l->east_m + x.y * l->north_m) / length2,
                 across_m = (x.x * l->north_m - x.y * l->east_m) / sqrt(length2);
    return along >= 0 && along <= 1 && fabs(across_m) <= t->width_m / 2;
}

bool orr_obstacles_tunnel(const orr_obstacles *o, const orr_antenna_state *at, orr_time as_of)
{
    for (size_t k = 0; o != NULL && k < o->n_tunnels; k++) {
        const tunnel *t = &o->tunnel[k];
        if (t->by_time ? orr_interval_holds(t->during, as_of) : inside(t, at->r_m)) return true;
    }
    return false;
}

// Where a + s u meets the wall's vertical plane, s > 0, between its ends, foot and top.
static bool hides(const wall *w, orr_vec3 r_m, orr_vec3 u)
{
    const ground_line *l = &w->line;
    const orr_vec3 a = orr_mat3_apply(&l->enu, orr_vec3_sub(r_m, l->r_m)), d = orr_mat3_apply(&l->enu, u);
    const double facing = d.x * l->north_m - d.y * l->east_m;
    if (!(fabs(facing) > 0)) return false; // along the wall
    const double s = -(a.x * l->north_m - a.y * l->east_m) / facing;
    const double east = a.x + s * d.x, north = a.y + s * d.y, up = a.z + s * d.z;
    const double part =
        (east * l->east_m + north * l->north_m) / (l->east_m * l->east_m + l->north_m * l->north_m);
    return s > 0 && part >= 0 && part <= 1 && up >= w->bottom_m && up <= w->top_m;
}

bool orr_obstacles_wall(const orr_obstacles *o, const orr_antenna_state *at, orr_vec3 u)
{
    for (size_t k = 0; o != NULL && k < o->n_walls; k++)
        if (hides(&o->wall[k], at->r_m, u)) return true;
    return false;
}

bool orr_obstacles_change(const orr_obstacles *o, orr_time after, orr_time until)
{
    for (size_t k = 0; o != NULL && k < o->n_tunnels; k++) {
        const tunnel *t = &o->tunnel[k];
        if (t->by_time && orr_interval_turns(t->during, after, until)) return true;
    }
    return false;
}

bool orr_obstacles_allow(const orr_obstacles *o, orr_time from, orr_time to, int64_t length_ns)
{
    for (size_t k = 0; o != NULL && k < o->n_tunnels; k++) {
        const tunnel *t = &o->tunnel[k];
        if (t->by_time && !orr_interval_fits(t->during, (orr_interval){from, to}, length_ns)) return false;
    }
    return true;
}

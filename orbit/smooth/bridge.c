// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/bridge.h"

#include <stdlib.h>

#include "core/astro.h"
#include "orbit/broadcast/broadcast.h"

#define MIN_COMMON 8
#define STRANGER_M 50e3
#define CORRELATED_S 43200.0 // an upload's error lasts about so long

// Rows: radial, along, cross in ecef, of the inertial motion.
static orr_mat3 local_axes(orr_vec3 r, orr_vec3 v_ecef)
{
    orr_vec3 v = orr_velocity_inertial(r, v_ecef);
    orr_vec3 u = orr_vec3_unit(r), w = orr_vec3_unit(orr_vec3_cross(r, v)), t = orr_vec3_cross(w, u);
    return (orr_mat3){{{u.x, u.y, u.z}, {t.x, t.y, t.z}, {w.x, w.y, w.z}}};
}

// Navigation files hold records of one satellite under another's name: a record has to pass within STRANGER_M
// of the precise node nearest to its own toe (a broadcast orbit is good for kilometres over hours).
static bool own_record(const orr_nav_eph *eph, const orr_node_list *list)
{
    const orr_node *nearest = NULL;
    for (size_t i = 0; i < list->n_nodes; i++)
        if (!list->node[i].bridge &&
            (nearest == NULL || llabs(list->node[i].t - eph->toe) < llabs(nearest->t - eph->toe)))
            nearest = &list->node[i];
    orr_broadcast_state s;
    return nearest != NULL && orr_broadcast_eval(eph, nearest->t, &s) == ORR_OK &&
           orr_vec3_norm(orr_vec3_sub(s.pos_m, nearest->ecef_m)) < STRANGER_M;
}

static bool broadcast_at(const orr_nav *nav, const orr_node_list *list, orr_time t, orr_vec3 *r,
                         orr_mat3 *axes)
{
    const orr_sat sat = list->sat;
    orr_broadcast_choice choice = orr_broadcast_choice_default();
    orr_broadcast_state s;
    const orr_nav_eph *eph = orr_broadcast_select(nav, sat, t, &choice);
    if (eph == NULL || !own_record(eph, list) || orr_broadcast_eval(eph, t, &s) != ORR_OK) return false;
    if (orr_sat_system(sat) == 'R') s.pos_m = orr_broadcast_pz90_to_itrf(s.pos_m, t);
    *r = s.pos_m;
    *axes = local_axes(s.pos_m, s.vel_mps);
    return true;
}

// Mean offset (radial, along, cross) of broadcast from precise, and RMS per axis about it.
static bool calibrate(const orr_nav *nav, const orr_node_list *list, orr_vec3 *offset, double *sigma)
{
    orr_vec3 sum = {0, 0, 0};
    double squares = 0, n = 0;
    for (size_t i = 0; i < list->n_nodes; i++) {
        orr_vec3 r;
        orr_mat3 axes;
        if (list->node[i].predicted || !broadcast_at(nav, list, list->node[i].t, &r, &axes)) continue;
        orr_vec3 d = orr_mat3_apply(&axes, orr_vec3_sub(r, list->node[i].ecef_m));
        sum = orr_vec3_add(sum, d);
        squares += orr_vec3_dot(d, d);
        n++;
    }
    if (n < MIN_COMMON) return false;
    *offset = orr_vec3_scale(1 / n, sum);
    *sigma = sqrt((squares / n - orr_vec3_dot(*offset, *offset)) / 3);
    return *sigma > 0;
}

// No record is worth anything a day after the last one's toe.
static orr_time last_record(const orr_nav *nav, orr_sat sat)
{
    orr_time last = INT64_MIN;
    for (size_t i = 0; i < nav->n_eph; i++)
        if (nav->eph[i].sat == sat && nav->eph[i].toe > last) last = nav->eph[i].toe;
    return last == INT64_MIN ? last : last + ORR_S_PER_DAY * ORR_NS_PER_S;
}

static orr_time earlier(orr_time a, orr_time b, orr_time least)
{
    orr_time x = a < b ? a : b;
    return x > least ? x : least;
}

static int by_time(const void *a, const void *b)
{
    const orr_node *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    return (int)x->rank - (int)y->rank;
}

orr_status orr_bridge_nodes(const orr_nav *nav, orr_time origin, double step_s, orr_time extend_to,
                            orr_node_list *list)
{
    orr_vec3 offset = {0, 0, 0};
    double sigma = 0;
    const int64_t step = (int64_t)llround(step_s * 1e9);
    if (step <= 0) return ORR_OK; // nodes of one instant alone
    if (list->n_nodes == 0 || !calibrate(nav, list, &offset, &sigma)) return ORR_OK;
    const size_t precise = list->n_nodes;
    const double correlated = fmax(1.0, CORRELATED_S / step_s);
    orr_time end = list->node[precise - 1].t;
    if (extend_to != ORR_TIME_NONE && extend_to > end)
        end = earlier(extend_to, last_record(nav, list->sat), end);
    size_t room = precise + (size_t)((end - list->node[0].t) / step) + 2;
    orr_node *node = realloc(list->node, room * sizeof *node);
    if (node == NULL) return ORR_E_MEMORY;
    list->node = node;
    for (size_t i = 0; i < precise; i++) {
        orr_time next = i + 1 < precise ? node[i + 1].t : end;
        bool last = i + 1 == precise;
        if (!last && next - node[i].t <= 2 * step) continue;
        for (orr_time t = node[i].t + step; last ? t <= next : t < next; t += step) {
            orr_vec3 r;
            orr_mat3 axes;
            if (list->n_nodes == room || !broadcast_at(nav, list, t, &r, &axes)) continue;
            node[list->n_nodes++] = (orr_node){.t = t,
                                               .t_s = orr_time_diff_s(t, origin),
                                               .ecef_m = orr_vec3_sub(r, orr_mat3_apply_t(&axes, offset)),
                                               .sigma_m = sigma * sqrt(correlated),
                                               .predicted = true,
                                               .bridge = true};
        }
    }
    qsort(node, list->n_nodes, sizeof *node, by_time);
    return ORR_OK;
}

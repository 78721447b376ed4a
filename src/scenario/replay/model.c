// SPDX-License-Identifier: GPL-3.0-or-later
// Observations less channels, epoch by epoch, and the receiver's clock as the codes tell it.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/robust.h"
#include "iono/field/pierce.h"
#include "src/scenario/replay/replay_private.h"

// Tracks as they are walked along.
typedef struct walk {
    replay_maker *m;
    orr_channel_work *work;
    orr_channel *list;
    int32_t (*track)[ORR_MAX_SIGNALS]; // [n_sats]
    size_t *at;                        // [n_tracks] node at the epoch, or the one after it
    double *difference;                // [channels]
} walk;

static void walk_close(walk *w)
{
    orr_channel_work_close(w->work);
    free(w->list);
    free(w->track);
    free(w->at);
    free(w->difference);
}

static orr_status walk_open(replay_maker *m, walk *w, orr_diag *diag)
{
    const orr_replay *r = m->r;
    *w = (walk){.m = m};
    const orr_status s = orr_channel_work_open(m->c, &w->work, diag);
    if (s != ORR_OK) return s;
    w->list = calloc(orr_channels_max(m->c), sizeof *w->list);
    w->track = malloc(r->n_sats * sizeof *w->track);
    w->at = calloc(r->n_tracks, sizeof *w->at);
    w->difference = calloc(orr_channels_max(m->c), sizeof *w->difference);
    if (w->list == NULL || w->track == NULL || w->at == NULL || w->difference == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    memset(w->track, 0xff, r->n_sats * sizeof *w->track);
    for (size_t k = 0; k < r->n_tracks; k++) w->track[r->track[k].sat][r->track[k].signal] = (int32_t)k;
    return ORR_OK;
}

// The node that a channel belongs to; NULL where the record has none at this epoch.
static orr_replay_node *node_of(const walk *w, const orr_channel *x, size_t epoch, size_t *sat)
{
    const orr_replay *r = w->m->r;
    while (*sat < r->n_sats && r->sat[*sat].sat < x->sat) ++*sat; // channels come by satellite
    if (*sat == r->n_sats || r->sat[*sat].sat != x->sat) return NULL;
    const int32_t k = w->track[*sat][x->signal];
    if (k < 0) return NULL;
    const orr_replay_track *t = &r->track[k];
    return w->at[k] < t->n && t->node[w->at[k]].epoch == epoch ? &t->node[w->at[k]] : NULL;
}

// Direction to a satellite in its own axes, which keep nominal yaw (METHOD: z to the Earth, y along the Sun's side).
static void look_from(const replay_maker *m, const orr_channel *x, orr_time t, orr_replay_sight *g)
{
    orr_sat_state at;
    if (orr_ephemeris_eval(orr_source_orbit_ephemeris(m->orbits), x->sat, t, &at) != ORR_OK) return;
    const orr_vec3 u = orr_vec3_unit(orr_vec3_sub(at.pos_m, m->site_m)),
                   z = orr_vec3_scale(-1, orr_vec3_unit(at.pos_m)),
                   sun = orr_vec3_unit(orr_vec3_sub(orr_sun_track_at(&m->sun, t), at.pos_m)),
                   y = orr_vec3_unit(orr_vec3_cross(z, sun));
    g->body[0] = (float)orr_vec3_dot(u, orr_vec3_cross(y, z));
    g->body[1] = (float)orr_vec3_dot(u, y);
    g->body[2] = (float)orr_vec3_dot(u, z);
}

static void take(const replay_maker *m, const orr_channel *x, orr_replay_node *n, size_t sat)
{
    orr_replay *r = m->r;
    const double cycle_m = ORR_LIGHT_MPS / x->carrier_hz;
    n->modelled = true;
    n->code_m = n->code - x->code_m;
    n->carrier_m = (n->carrier - (double)x->carrier_cycles - x->carrier_fraction) * cycle_m;
    orr_replay_sight *g = &r->sat[sat].sight[n->sight];
    if (r->sat[sat].estimated) look_from(m, x, r->t[n->epoch], g);
    g->az_rad = (float)x->az_rad;
    g->el_rad = (float)x->el_rad;
    g->base_tecu =
        x->term_m[ORR_TERM_IONOSPHERE] / orr_iono_delay_m(1, x->carrier_hz, ORR_MEASURES_CODE) - g->more_tecu;
}

// One epoch with the clock as it is; what the codes say of it, s.
static double epoch(walk *w, size_t e, double clock_s)
{
    orr_replay *r = w->m->r;
    size_t n, sat = 0, known = 0;
    r->t[e] = orr_time_add_s(r->tag[e], -clock_s);
    if (orr_channels_at(w->m->c, 0, w->work, r->t[e], UINT64_MAX, w->list, &n) != ORR_ANSWER_OK) n = 0;
    for (size_t k = 0; k < n; k++) {
        orr_replay_node *x = node_of(w, &w->list[k], e, &sat);
        if (x == NULL) continue;
        take(w->m, &w->list[k], x, sat);
        if (!isnan(x->code_m) && w->list[k].el_rad > 5 * ORR_RAD_PER_DEG) w->difference[known++] = x->code_m;
    }
    return known > 0 ? orr_median(w->difference, known) / ORR_LIGHT_MPS : clock_s;
}

static void unmodelled(orr_replay *r)
{
    for (size_t k = 0; k < r->n_tracks; k++)
        for (size_t j = 0; j < r->track[k].n; j++) {
            r->track[k].node[j].modelled = false;
            r->track[k].node[j].code_m = r->track[k].node[j].carrier_m = (double)NAN;
        }
}

orr_status replay_model(replay_maker *m, size_t every, bool settle, orr_diag *diag)
{
    walk w;
    orr_replay *r = m->r;
    orr_status s = walk_open(m, &w, diag);
    unmodelled(r);
    double last_s = 0;
    for (size_t e = 0; s == ORR_OK && e < r->n_epochs; e += every) {
        if (m->cancel != NULL && *m->cancel) s = orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        for (size_t k = 0; k < r->n_tracks; k++)
            while (w.at[k] < r->track[k].n && r->track[k].node[w.at[k]].epoch < e) w.at[k]++;
        double clock_s = settle ? last_s : r->clock_s[e];
        // A satellite moves by 1 km/s along the line of sight: 10 ns of the clock are 0.01 mm.
        for (int round = 0; s == ORR_OK && round < 6; round++) {
            const double was_s = clock_s;
            clock_s = epoch(&w, e, clock_s);
            if (!settle || fabs(clock_s - was_s) < 1e-8) break;
        }
        if (settle) r->clock_s[e] = last_s = clock_s;
    }
    walk_close(&w);
    return s;
}

// How much all carriers changed from the epoch before, m: the median; NAN where none goes on.
static double carriers_rose_m(const orr_replay *r, size_t e, size_t *at, double *list)
{
    size_t n = 0;
    for (size_t k = 0; k < r->n_tracks; k++) {
        const orr_replay_track *x = &r->track[k];
        while (at[k] < x->n && x->node[at[k]].epoch < e) at[k]++;
        const size_t j = at[k];
        if (j == 0 || j == x->n || x->node[j].epoch != e || x->node[j - 1].epoch + 1 != e) continue;
        const double rise = x->node[j].carrier_m - x->node[j - 1].carrier_m;
        if (!isnan(rise)) list[n++] = rise;
    }
    return n > 0 ? orr_median(list, n) : (double)NAN;
}

orr_status replay_clock_steps(replay_maker *m, orr_diag *diag)
{
    orr_replay *r = m->r;
    size_t *at = calloc(r->n_tracks, sizeof *at);
    double *list = calloc(r->n_tracks, sizeof *list);
    const double step_m = ORR_LIGHT_MPS * 1e-3;
    double held_s = 0;
    m->report->n_clock_steps = 0;
    for (size_t e = 1; at != NULL && list != NULL && e < r->n_epochs; e++) {
        const double rise_m = ORR_LIGHT_MPS * (r->clock_s[e] - r->clock_s[e - 1]),
                     carriers_m = carriers_rose_m(r, e, at, list);
        r->steps[e] = fabs(rise_m) > step_m / 2;
        m->report->n_clock_steps += r->steps[e];
        // Carriers that go on where ranges step lack the step from then on.
        if (r->steps[e] && !isnan(carriers_m)) held_s += 1e-3 * round((rise_m - carriers_m) / step_m);
        r->held_s[e] = held_s;
    }
    const bool ok = at != NULL && list != NULL;
    free(at);
    free(list);
    return ok ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

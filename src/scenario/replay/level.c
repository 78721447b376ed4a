// SPDX-License-Identifier: GPL-3.0-or-later
// The station's phases as `orrery iono` has them: which pair of carriers tells the content, where arcs break, and the fused content
// along them.
#include <math.h>
#include <stdlib.h>

#include "core/nan.h"
#include "iono/phase/signals.h"
#include "src/make/station.h"
#include "src/scenario/replay/replay_private.h"

static bool position_of(void *user, orr_sat sat, orr_time t, orr_vec3 *pos_m)
{
    orr_sat_state x;
    if (orr_ephemeris_eval(user, sat, t, &x) != ORR_OK) return false;
    *pos_m = x.pos_m;
    return true;
}

static int track_of(const orr_replay *r, orr_sat sat, const char *code)
{
    const int signal = orr_record_signal(orr_sat_system(sat), code + 1, r->version);
    const orr_replay_track *x = signal >= 0 ? orr_replay_track_of(r, sat, (size_t)signal) : NULL;
    return x != NULL ? (int)(x - r->track) : -1;
}

// Sights of a satellite's pair: the nodes of both tracks.
static void find_nodes(const orr_replay *r, orr_replay_sat *x)
{
    for (int i = 0; i < 2; i++) {
        const orr_replay_track *track = &r->track[x->pair[i]];
        for (size_t k = 0; k < track->n; k++)
            if (!isnan(track->node[k].carrier)) x->sight[track->node[k].sight].at[i] = (int32_t)k;
    }
}

// Arcs of a satellite and its fused contents.
static void take_sat(replay_maker *m, const orr_station *st, size_t which)
{
    const orr_phase_sat *p = &st->phase.sat[which];
    orr_replay *r = m->r;
    orr_replay_sat *x = NULL;
    for (size_t k = 0; k < r->n_sats; k++)
        if (r->sat[k].sat == p->sat) x = &r->sat[k];
    if (x == NULL) return;
    const int pair[2] = {track_of(r, p->sat, p->phase[0]), track_of(r, p->sat, p->phase[1])};
    if (pair[0] < 0 || pair[1] < 0) return;
    x->pair[0] = pair[0];
    x->pair[1] = pair[1];
    find_nodes(r, x);
    double *fused = m->fused_tecu[x - r->sat];
    size_t slip = 0, j = 0;
    uint32_t arc = (uint32_t)m->n_arcs++;
    for (size_t k = 0; k < x->n; k++) {
        orr_replay_sight *g = &x->sight[k];
        while (j < p->n && p->t[j] < r->tag[g->epoch]) j++;
        for (; slip < p->arcs.n_slips && p->t[p->arcs.slip[slip].at] <= r->tag[g->epoch]; slip++) {
            const orr_slip *s = &p->arcs.slip[slip];
            if (s->verdict == ORR_SLIP_BREAK || s->verdict == ORR_SLIP_REPAIRED)
                arc = (uint32_t)m->n_arcs++;
            else if (s->verdict == ORR_SLIP_OUTLIER && p->t[s->at] == r->tag[g->epoch])
                g->rejected = 1;
        }
        g->arc = arc;
        if (j < p->n && p->t[j] == r->tag[g->epoch] && p->arcs.arc_of[j] >= 0) fused[k] = p->gf_tecu[j];
    }
}

// Contents of levelled arcs: phases less the arcs' biases.
static void take_levels(replay_maker *m, const orr_station *st)
{
    const orr_fusion *f = &st->fusion;
    for (size_t k = 0; k < m->r->n_sats; k++) {
        const orr_replay_sat *x = &m->r->sat[k];
        size_t which = 0;
        while (which < st->phase.n_sats && st->phase.sat[which].sat != x->sat) which++;
        for (size_t i = 0, j = 0; i < x->n; i++) {
            double *fused = &m->fused_tecu[k][i];
            if (isnan(*fused)) continue;
            const orr_phase_sat *p = &st->phase.sat[which];
            while (p->t[j] < m->r->tag[x->sight[i].epoch]) j++;
            double bias = ORR_NAN;
            for (size_t a = 0; a < f->n_arcs; a++)
                if (f->arc[a].sat_index == which && (int)f->arc[a].arc == p->arcs.arc_of[j])
                    bias = f->arc[a].bias_tecu;
            *fused -= bias;
        }
    }
}

static orr_status fuse(replay_maker *m, orr_station *st, orr_diag *diag)
{
    const orr_status s = orr_station_fuse(st, m->warnings, diag);
    if (s == ORR_E_NODATA) { // no arc is long enough: the field alone has the level
        for (size_t k = 0; k < m->r->n_sats; k++)
            for (size_t i = 0; i < m->r->sat[k].n; i++) m->fused_tecu[k][i] = ORR_NAN;
        orr_warnings_add(m->warnings, m->s->replay.observations, 0, 0,
                         "no arc is long enough to be levelled; the content's level is the field's own");
        return ORR_OK;
    }
    if (s == ORR_OK) take_levels(m, st);
    return s;
}

orr_status replay_level(replay_maker *m, orr_diag *diag)
{
    const orr_scenario *s = m->s;
    orr_station_plan plan = orr_station_plan_default();
    plan.observations = s->replay.observations;
    plan.field = s->iono.field;
    plan.position = position_of;
    plan.user = (void *)orr_source_orbit_ephemeris(m->orbits);
    plan.sinex = s->replay.sinex;
    plan.code = s->replay.station;
    plan.antex = s->navdata.antex != NULL ? s->navdata.antex : s->channel.antex;
    const char *bias = s->navdata.bias != NULL ? s->navdata.bias : s->channel.bias;
    plan.biases = &bias;
    plan.n_biases = bias != NULL ? 1 : 0;
    plan.tec = orr_source_iono_options(s);
    plan.phase.leap = s->leap;
    plan.phase.from = m->r->tag[0];
    plan.phase.to = m->r->tag[m->r->n_epochs - 1];
    plan.phase.mask_rad = 0;
    plan.phase.arcs.min_span_s = 0;
    plan.phase.arcs.min_samples = 3;
    orr_station st;
    orr_status status = orr_station_open(&plan, &st, NULL, diag);
    if (status == ORR_OK) {
        m->prior_m = m->site_m = st.phase.site.pos_m;
        for (size_t k = 0; k < st.phase.n_sats; k++) take_sat(m, &st, k);
        status = fuse(m, &st, diag);
    }
    orr_station_free(&st);
    return status;
}

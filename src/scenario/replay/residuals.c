// SPDX-License-Identifier: GPL-3.0-or-later
// Contents along arcs, code delays, ambiguities, and what is left of each track.
#include <math.h>
#include <stdlib.h>

#include "core/constants.h"
#include "core/robust.h"
#include "ingest/rinex/rinex_obs.h"
#include "iono/field/pierce.h"
#include "orbit/spacecraft/signal_delay.h"
#include "src/scenario/replay/replay_private.h"

// A carrier that steps by more than so many cycles between two epochs has slipped.
#define STEP_CYCLES 0.4

// --- Contents ---

// The pair's geometry-free residual at a sight as content, TECU; NAN where it has not both carriers, or is an outlier.
static double shape_tecu(const replay_maker *m, const orr_replay_sat *x, const orr_replay_sight *g)
{
    if (g->at[0] < 0 || g->at[1] < 0 || (g->rejected & 1) != 0) return (double)NAN;
    const orr_replay_track *a = &m->r->track[x->pair[0]], *b = &m->r->track[x->pair[1]];
    const double per_tecu = orr_iono_delay_m(1, replay_carrier_hz(m->r, b), ORR_MEASURES_CODE) -
                            orr_iono_delay_m(1, replay_carrier_hz(m->r, a), ORR_MEASURES_CODE);
    return (a->node[g->at[0]].carrier_m - b->node[g->at[1]].carrier_m) / per_tecu;
}

// Sights from `from` on that belong to one arc.
static size_t arc_end(const orr_replay_sat *x, size_t from)
{
    size_t k = from;
    while (k < x->n && x->sight[k].arc == x->sight[from].arc) k++;
    return k;
}

// Contents of an arc: its shape, and as level the mean of what the fused session has more than the field; false where no sight of
// it was fused.
static bool level_arc(replay_maker *m, size_t sat, size_t from, size_t to, double *level_tecu)
{
    orr_replay_sat *x = &m->r->sat[sat];
    double sum = 0, shape = 0;
    size_t n = 0, shapes = 0;
    for (size_t k = from; k < to; k++) {
        const double own = shape_tecu(m, x, &x->sight[k]), fused = m->fused_tecu[sat][k];
        if (isnan(own)) continue;
        shape += own;
        shapes++;
        if (isnan(fused)) continue;
        sum += fused - x->sight[k].base_tecu - own;
        n++;
    }
    if (shapes == 0) return false;
    const double offset = n > 0 ? sum / (double)n : *level_tecu - shape / (double)shapes;
    for (size_t k = from; k < to; k++) x->sight[k].more_tecu = shape_tecu(m, x, &x->sight[k]) + offset;
    *level_tecu = shape / (double)shapes + offset;
    return true;
}

// One carrier's residual at a sight with the clock off; NAN where it was not recorded.
static double alone_m(const replay_maker *m, const orr_replay_sat *x, const orr_replay_sight *g, int which)
{
    const orr_replay *r = m->r;
    if (g->at[which] < 0) return (double)NAN;
    return r->track[x->pair[which]].node[g->at[which]].carrier_m -
           ORR_LIGHT_MPS * (r->clock_s[g->epoch] - r->held_s[g->epoch]);
}

// Where a receiver lost one of two carriers the other one goes on telling the content, against the clock of all satellites: from a
// neighbour in the arc that has a content on to sight k.
static void go_on(const replay_maker *m, orr_replay_sat *x, size_t from, size_t k)
{
    orr_replay_sight *g = &x->sight[k];
    const orr_replay_sight *near = &x->sight[from];
    if (near->arc != g->arc || isnan(near->more_tecu) || (g->rejected & 1) != 0) return;
    const bool gap = k > from ? g->begins : near->begins;
    for (int i = 0; i < 2 && isnan(g->more_tecu); i++) {
        const double rise_m = alone_m(m, x, g, i) - alone_m(m, x, near, i),
                     hz = replay_carrier_hz(m->r, &m->r->track[x->pair[i]]);
        if (isnan(rise_m)) continue;
        // A carrier that steps has slipped, and tells nothing of the content's rise.
        const bool slipped = gap || fabs(rise_m) > STEP_CYCLES * ORR_LIGHT_MPS / hz;
        g->more_tecu = near->more_tecu - (slipped ? 0 : rise_m / orr_iono_delay_m(1, hz, ORR_MEASURES_CODE));
    }
}

static void carry_contents(const replay_maker *m, orr_replay_sat *x)
{
    for (size_t k = 1; k < x->n; k++)
        if (isnan(x->sight[k].more_tecu)) go_on(m, x, k - 1, k);
    for (size_t k = x->n; k-- > 1;)
        if (isnan(x->sight[k - 1].more_tecu)) go_on(m, x, k, k - 1);
}

// Sights without a content have that of a neighbour.
static void fill_contents(orr_replay_sat *x)
{
    size_t last = x->n;
    for (size_t k = 0; k < x->n; k++) {
        if (!isnan(x->sight[k].more_tecu)) {
            for (size_t j = last == x->n ? 0 : k; j < k; j++) x->sight[j].more_tecu = x->sight[k].more_tecu;
            last = k;
        } else if (last < x->n)
            x->sight[k].more_tecu = x->sight[last].more_tecu;
    }
    for (size_t k = 0; last == x->n && k < x->n; k++) x->sight[k].more_tecu = 0;
}

void replay_contents(replay_maker *m)
{
    for (size_t s = 0; s < m->r->n_sats; s++) {
        orr_replay_sat *x = &m->r->sat[s];
        if (x->pair[0] < 0) continue;
        double level_tecu = 0;
        for (size_t from = 0, to; from < x->n; from = to) {
            to = arc_end(x, from);
            for (size_t k = from; k < to; k++) x->sight[k].more_tecu = (double)NAN;
            (void)level_arc(m, s, from, to, &level_tecu);
        }
        carry_contents(m, x);
        fill_contents(x);
    }
}

// --- Code delays ---

// Whether a track's satellite has a delay of its own to be found: GLONASS' by its frequency, others' where no file tells it.
static bool own_delay(const replay_maker *m, const orr_replay_track *x)
{
    const orr_sat sat = m->r->sat[x->sat].sat;
    double delay_s;
    return orr_sat_system(sat) == 'R' || !m->tables->has_bias ||
           orr_signal_delay_of(&m->tables->bias, sat, &orr_signals(&(size_t){0})[x->signal], m->r->tag[0],
                               &delay_s) != ORR_OK;
}

// Adds a track's residual codes to a list.
static size_t list_codes(const orr_replay_track *x, double *list, size_t n)
{
    for (size_t k = 0; k < x->n; k++)
        if (!isnan(x->node[k].code_m)) list[n++] = x->node[k].code_m;
    return n;
}

static orr_status find_delays(replay_maker *m, orr_diag *diag)
{
    orr_replay *r = m->r;
    size_t most = 0, n;
    for (size_t k = 0; k < r->n_tracks; k++) most += r->track[k].n;
    double *list = malloc((most + 1) * sizeof *list);
    if (list == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < r->n_tracks; k++) {
        orr_replay_track *x = &r->track[k];
        x->delay_m = 0;
        if (own_delay(m, x) && (n = list_codes(x, list, 0)) > 0) x->delay_m = orr_median(list, n);
    }
    for (size_t s = 0; s < ORR_MAX_SIGNALS; s++) {
        n = 0;
        for (size_t k = 0; k < r->n_tracks; k++)
            if (r->track[k].signal == s && !own_delay(m, &r->track[k])) n = list_codes(&r->track[k], list, n);
        const double common = n > 0 ? orr_median(list, n) : 0;
        for (size_t k = 0; k < r->n_tracks; k++)
            if (r->track[k].signal == s && !own_delay(m, &r->track[k])) r->track[k].delay_m = common;
    }
    free(list);
    return ORR_OK;
}

// --- Carriers ---

// Arcs of a track: those of its satellite's pair, and where its own carrier was lost or steps.
static void find_arcs(const replay_maker *m, orr_replay_track *x)
{
    const orr_replay_sat *sat = &m->r->sat[x->sat];
    const double cycle_m = ORR_LIGHT_MPS / replay_carrier_hz(m->r, x);
    const bool paired =
        sat->pair[0] >= 0 && (x == &m->r->track[sat->pair[0]] || x == &m->r->track[sat->pair[1]]);
    size_t before = x->n; // the last node with a carrier
    uint32_t arc = 0;
    bool lost = false;
    for (size_t k = 0; k < x->n; k++) {
        orr_replay_node *n = &x->node[k];
        lost = lost || (!paired && ((n->lli[1] & ORR_OBS_LLI_SLIP) != 0 || n->begins));
        if (before < x->n && sat->pair[0] >= 0 &&
            sat->sight[n->sight].arc != sat->sight[x->node[k - 1].sight].arc)
            lost = true;
        if (!isnan(n->carrier_m)) {
            if (before < x->n &&
                (lost || fabs(n->carrier_m - x->node[before].carrier_m) > STEP_CYCLES * cycle_m))
                arc++;
            lost = false;
            before = k;
        }
        n->arc = arc;
    }
    x->n_arcs = x->n > 0 ? arc + 1 : 0;
}

// Means of the arcs; what they leave.
static orr_status fix_arcs(const replay_maker *m, orr_replay_track *x, orr_diag *diag)
{
    const double cycle_m = ORR_LIGHT_MPS / replay_carrier_hz(m->r, x);
    const orr_replay_sight *sight = m->r->sat[x->sat].sight;
    x->arc = calloc(x->n_arcs + 1, sizeof *x->arc);
    if (x->arc == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t from = 0, to; from < x->n; from = to) {
        double sum[2] = {0, 0};
        size_t n[2] = {0, 0};
        for (to = from; to < x->n && x->node[to].arc == x->node[from].arc; to++) {
            const int outlier = sight[x->node[to].sight].rejected & 1;
            if (isnan(x->node[to].carrier_m)) continue;
            sum[outlier] += x->node[to].carrier_m;
            n[outlier]++;
        }
        const int from_outliers = n[0] == 0; // where there is nothing else
        const double mean = n[from_outliers] > 0 ? sum[from_outliers] / (double)n[from_outliers] : 0;
        orr_replay_arc *a = &x->arc[x->node[from].arc];
        a->start = llround(mean / cycle_m);
        a->bias_m = mean - (double)a->start * cycle_m;
        for (size_t k = from; k < to; k++) x->node[k].carrier_m -= mean;
    }
    return ORR_OK;
}

// Values that were not recorded: what the one before, or else the next one of the arc has.
static void fill_track(orr_replay_track *x)
{
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < x->n; i++) {
            const size_t k = pass == 0 ? i : x->n - 1 - i;
            orr_replay_node *n = &x->node[k];
            const bool first = pass == 0 ? k == 0 : k + 1 == x->n;
            const orr_replay_node *from = first ? NULL : pass == 0 ? n - 1 : n + 1;
            if (isnan(n->code_m) && from != NULL) n->code_m = from->code_m;
            if (isnan(n->carrier_m) && from != NULL && from->arc == n->arc) n->carrier_m = from->carrier_m;
        }
    for (size_t k = 0; k < x->n; k++) {
        if (isnan(x->node[k].code_m)) x->node[k].code_m = 0;
        if (isnan(x->node[k].carrier_m)) x->node[k].carrier_m = 0;
    }
}

orr_status replay_residuals(replay_maker *m, orr_diag *diag)
{
    orr_replay *r = m->r;
    orr_status s = ORR_OK;
    size_t lost = 0;
    for (size_t k = 0; k < r->n_tracks; k++)
        for (size_t j = 0; j < r->track[k].n; j++) {
            orr_replay_node *n = &r->track[k].node[j];
            if (!n->modelled) {
                n->code = n->carrier = (double)NAN;
                lost++;
            }
            const double clock_m =
                ORR_LIGHT_MPS * r->clock_s[n->epoch] + r->sat[r->track[k].sat].sight[n->sight].clock_m;
            n->code_m -= clock_m;
            n->carrier_m -= clock_m - ORR_LIGHT_MPS * r->held_s[n->epoch];
        }
    if (lost > 0)
        orr_warnings_add(
            m->warnings, m->s->replay.observations, 0, 0,
            "%zu observations are not replayed: the orbits have no position or clock of their satellites "
            "then, or they come from below the horizon",
            lost);
    s = find_delays(m, diag);
    for (size_t k = 0; s == ORR_OK && k < r->n_tracks; k++) {
        orr_replay_track *x = &r->track[k];
        for (size_t j = 0; j < x->n; j++) x->node[j].code_m -= x->delay_m;
        find_arcs(m, x);
        s = fix_arcs(m, x, diag);
        if (s == ORR_OK) fill_track(x);
    }
    return s;
}

// --- Statistics ---

static void add_to(orr_replay_rms *a, const orr_replay_track *x, double cycle_m)
{
    for (size_t k = 0; k < x->n; k++) {
        const orr_replay_node *n = &x->node[k];
        if (!isnan(n->code)) {
            a->n_code++;
            a->code_m += n->code_m * n->code_m;
            a->code_max_m = fmax(a->code_max_m, fabs(n->code_m));
        }
        if (isnan(n->carrier)) continue;
        a->n_carrier++;
        a->n_slips += (n->lli[1] & ORR_OBS_LLI_SLIP) != 0;
        a->carrier_m += n->carrier_m * n->carrier_m;
        a->carrier_cycles += n->carrier_m * n->carrier_m / (cycle_m * cycle_m);
        a->carrier_max_m = fmax(a->carrier_max_m, fabs(n->carrier_m));
    }
    if (a->n_carrier > 0) a->n_arcs += x->n_arcs;
}

static orr_replay_rms roots(orr_replay_rms a)
{
    a.code_m = sqrt(a.code_m / (double)a.n_code);
    a.carrier_m = sqrt(a.carrier_m / (double)a.n_carrier);
    a.carrier_cycles = sqrt(a.carrier_cycles / (double)a.n_carrier);
    return a;
}

orr_replay_rms orr_replay_rms_of(const orr_replay *r, const orr_replay_track *x)
{
    orr_replay_rms a = {0};
    add_to(&a, x, ORR_LIGHT_MPS / replay_carrier_hz(r, x));
    return roots(a);
}

orr_replay_rms orr_replay_rms_all(const orr_replay *r)
{
    orr_replay_rms a = {0};
    for (size_t k = 0; k < r->n_tracks; k++)
        add_to(&a, &r->track[k], ORR_LIGHT_MPS / replay_carrier_hz(r, &r->track[k]));
    return roots(a);
}

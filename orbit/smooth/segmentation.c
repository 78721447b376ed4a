// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/segmentation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/smooth/segmentation_private.h"

// In units of what is usual for the satellite: a node this far from the orbit through all others is wrong; one
// that is less far is looked at, because an outlier among few nodes makes the others look bad.
#define WRONG 10.0
// Of nodes two hours apart a day has thirteen, and the orbit through all but the first one tells where that was to some
// centimetres. Good ones are up to 5 times as far off as is usual; 6 are once in 10^7 by chance (F of 3 and 18), at an end as
// elsewhere.
#define WRONG_VERY_SPARSE 6.0
#define WRONG_PLAIN 100.0    // the pole is wrong: at an hour's nodes, the last one of a good day reaches 40
#define FLOOR_M 0.10         // near shadow good nodes are off by up to half of it
#define CARRIED_ON_S 10900.0 // to rejected nodes at an end
// How much worse an orbit is known beyond its last node than it claims, if nodes are dense.
#define ONE_SIDED 1.5
// An end node that is so far off and yet not wrong: once in 1500 good ones by chance. Nothing beside it tells which is right.
#define DOUBTFUL 3.0
#define DOUBTFUL_M 0.03
#define LEAST_NODES 6       // of a stretch, to tell what is usual
#define LEAST_PUSH_MPS 1e-3 // smaller steps are those of a centre's model, twice or four times a day
// Between sparse nodes f0's walk as it is for dense ones is far larger than what orbits do, and errors hide in it.
#define SPARSE_S 1900.0
#define VERY_SPARSE_S 5400.0
#define QUIET_SPARSE 0.03
#define QUIET_VERY_SPARSE 0.01
#define JUMP_M 5.0 // files further apart at their joint each keep their own orbit
#define JUMP_TOLD_M 0.1
#define JUMP_MPS 0.01

void orr_segmentation_free(orr_segmentation *s)
{
    free(s->arc);
    free(s->verdict);
    *s = (orr_segmentation){0};
}

static double cost(const segment_trial *x, const segment_work *w, double scale2)
{
    return x->chi2 / scale2 + 3 * w->unit2 * x->penalty;
}

// Steps of the velocity that no push is as small as are the model's, and no reason to begin anew.
static void forget_small_steps(const segment_work *w, size_t a, size_t b)
{
    for (size_t g = a + 1; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        if (!w->verdict[at->first].begins_anew) continue;
        const double v_mps =
            ORR_ANEW_V_MPS * ORR_ANEW_V_MPS * orr_vec3_norm((orr_vec3){at->u[3], at->u[4], at->u[5]});
        if (v_mps < LEAST_PUSH_MPS) w->verdict[at->first].begins_anew = false;
    }
}

// The verdicts on groups [a, b), no two of which a flag sets apart; foreign nodes are rejected before.
static orr_status judge(segment_work *w, size_t a, size_t b, orr_verdict *verdict)
{
    segment_trial alone = {.verdict = calloc(w->n_nodes + 1, sizeof(orr_verdict))},
                  pushed = {.verdict = calloc(w->n_nodes + 1, sizeof(orr_verdict))};
    orr_status s = ORR_E_MEMORY;
    if (alone.verdict == NULL || pushed.verdict == NULL) goto done;
    memcpy(alone.verdict, verdict, w->n_nodes * sizeof *verdict);
    memcpy(pushed.verdict, verdict, w->n_nodes * sizeof *verdict);
    w->verdict = alone.verdict;
    s = segment_explore(w, a, b, false, &alone);
    const segment_trial *best = &alone;
    if (s == ORR_OK && (!alone.good || alone.wrong > 1)) {
        // What comes before a push may begin anywhere, as what comes after it does: the reference is the longer one's orbit.
        const orr_track_context *own = w->c;
        orr_track_context anywhere = *own;
        anywhere.noise.start_r_m = fmax(own->noise.start_r_m, ORR_ANEW_R_M);
        anywhere.noise.start_v_mps = fmax(own->noise.start_v_mps, ORR_ANEW_V_MPS);
        w->c = &anywhere;
        w->verdict = pushed.verdict;
        s = segment_explore(w, a, b, true, &pushed);
        w->c = own;
        forget_small_steps(w, a, b);
        const double scale2 = fmin(alone.scale2, pushed.scale2);
        const bool better = cost(&pushed, w, scale2) < cost(&alone, w, scale2);
        if (s == ORR_OK && pushed.pushes > 0 && pushed.good >= alone.good &&
            (better || pushed.good > alone.good))
            best = &pushed;
    }
    w->verdict = best->verdict;
    if (s == ORR_OK) s = segment_fit(w, a, b, NULL);
    // What is no orbit about a reference may be one by itself: the caller tries that.
    if (s == ORR_OK && segment_look_at(w, a, b).noise) {
        segment_mark(w, a, b, true);
        if (w->c->noise.nx == ORR_NX) s = ORR_E_NUMERIC;
    }
    if (s == ORR_OK)
        for (size_t g = a; g < b; g++) {
            const orr_instant *at = segment_instant(w, g);
            memcpy(&verdict[at->first], &best->verdict[at->first], at->n * sizeof *verdict);
        }
done:
    free(alone.verdict);
    free(pushed.verdict);
    w->verdict = verdict;
    return s;
}

// Groups of instants with usable nodes.
static size_t make_groups(const orr_node *list, const orr_track *t, segment_group *out)
{
    size_t n = 0;
    uint16_t file = 0;
    for (size_t k = 0; k < t->n; k++) {
        bool usable = false, flagged = false;
        uint16_t source = file;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++) {
            if (list[i].superseded) continue;
            usable = true;
            flagged = flagged || list[i].manoeuvre;
            if (!list[i].bridge) source = list[i].source;
        }
        if (!usable) continue;
        out[n] = (segment_group){k, flagged, n > 0 && source != file};
        n++;
        file = source;
    }
    return n;
}

// Where another file begins: how far its orbit is from the one before, and whether that is another orbit.
static void tell_joints(const segment_work *w, size_t a, size_t b)
{
    const double scale2 = segment_look_at(w, a, b).scale2;
    bool asked = false; // the filter has admitted joints of rich orbits
    for (size_t g = a + 1; g < b; g++)
        asked = asked || (w->g[g].joint && !w->verdict[segment_instant(w, g)->first].begins_anew &&
                          !segment_instant(w, g)->step);
    if (asked && segment_fit(w, a, b, w->fresh) != ORR_OK) return;
    for (size_t g = a + 1; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        orr_fresh_start f = w->fresh[w->g[g].instant];
        if (!w->g[g].joint || w->verdict[at->first].begins_anew) continue;
        if (at->step) { // the filter has admitted it: what it was is its variance times u
            const double r = ORR_FILE_STEP_R_M * ORR_FILE_STEP_R_M,
                         v = ORR_FILE_STEP_V_MPS * ORR_FILE_STEP_V_MPS;
            f.r_m = orr_vec3_scale(r, (orr_vec3){at->u[0], at->u[1], at->u[2]});
            f.v_mps = orr_vec3_scale(v, (orr_vec3){at->u[3], at->u[4], at->u[5]});
        } else if (!f.told || f.gain < 3 * w->unit2 * scale2) {
            continue;
        }
        const double r_m = orr_vec3_norm(f.r_m);
        if (r_m > JUMP_TOLD_M) w->verdict[at->first].jump_m = r_m;
        if (r_m > JUMP_M || orr_vec3_norm(f.v_mps) > JUMP_MPS) w->verdict[at->first].begins_anew = true;
    }
}

// First and last used nodes of sparse ones that are off the orbit through all others, and not far enough to be wrong. Errors
// come together: beside a rejected node any distance is in doubt.
static void doubt_ends(const segment_work *w, size_t a, size_t b)
{
    const double scale2 = segment_look_at(w, a, b).scale2;
    size_t end[2] = {a, b - 1};
    while (end[0] < end[1] && segment_rejected(w, end[0])) end[0]++;
    while (end[0] < end[1] && segment_rejected(w, end[1])) end[1]--;
    if (end[0] == end[1]) return;
    for (int k = 0; k < 2; k++) {
        const orr_instant *at = segment_instant(w, end[k]);
        const bool beside = k == 0 ? segment_rejected(w, end[0] + 1) || end[0] > a
                                   : segment_rejected(w, end[1] - 1) || end[1] + 1 < b;
        const double usual2 = beside ? 0 : DOUBTFUL * DOUBTFUL * scale2;
        for (size_t i = at->first; i < at->first + at->n; i++) {
            if (!segment_counts(w, i) || w->verdict[i].rejected) continue;
            const orr_left_out d = orr_leave_node_out(w->c, at, &w->list[i], true);
            if (d.d2 > usual2 && d.length_m > DOUBTFUL_M) w->verdict[i].doubt_m = d.length_m;
        }
    }
}

// At the ends of the whole, where nothing else is, the orbit is carried on to where rejected nodes are.
static void add_arcs(const segment_work *w, size_t a, size_t b, size_t n_groups, orr_segmentation *out)
{
    for (size_t g = a; g < b;) {
        size_t end = g + 1, good = 0;
        while (end < b && !w->verdict[segment_instant(w, end)->first].begins_anew) end++;
        size_t first = g, last = end - 1;
        while (first < last && segment_rejected(w, first)) first++;
        while (last > first && segment_rejected(w, last)) last--;
        for (size_t k = first; k <= last; k++) good += !segment_rejected(w, k);
        if (a == 0 && g == 0 && segment_instant(w, first)->t_s - segment_instant(w, 0)->t_s < CARRIED_ON_S)
            first = 0;
        if (end == n_groups &&
            segment_instant(w, end - 1)->t_s - segment_instant(w, last)->t_s < CARRIED_ON_S)
            last = end - 1;
        if (good >= 2) out->arc[out->n_arcs++] = (orr_arc_range){w->g[first].instant, w->g[last].instant};
        for (size_t k = g; k < end; k++) w->verdict[segment_instant(w, k)->first].begins_anew = false;
        g = end;
    }
}

orr_status orr_segment_track(const orr_track_context *c, const orr_node *list, size_t n, double node_step_s,
                             orr_track *t, orr_segmentation *out)
{
    *out = (orr_segmentation){0};
    const bool rich = c->noise.nx == ORR_NX;
    // Without a reference the pole is not known, and nodes sparser than two hours disagree by that much more than by errors.
    const bool told = rich || node_step_s <= 7200, quiet = rich && node_step_s > SPARSE_S,
               very_sparse = quiet && node_step_s > VERY_SPARSE_S;
    const double wrong = very_sparse ? WRONG_VERY_SPARSE : rich ? WRONG : WRONG_PLAIN;
    orr_track_context own = *c;
    if (quiet) own.noise.factor.q *= very_sparse ? QUIET_VERY_SPARSE : QUIET_SPARSE;
    segment_group *g = malloc((t->n + 1) * sizeof *g);
    segment_fitted last = {.verdict = calloc(n + 1, sizeof *last.verdict)};
    segment_work w = {.c = &own,
                      .list = list,
                      .n_nodes = n,
                      .t = t,
                      .g = g,
                      .wrong2 = wrong * wrong,
                      .unit2 = rich ? WRONG * WRONG : WRONG_PLAIN * WRONG_PLAIN,
                      .one_sided2 = very_sparse ? 1 : ONE_SIDED * ONE_SIDED,
                      .floor_m = FLOOR_M,
                      .fitted = &last};
    out->verdict = calloc(n + 1, sizeof *out->verdict);
    out->arc = malloc((n + 1) * sizeof *out->arc);
    w.room = malloc((n + 1) * sizeof *w.room);
    w.fresh = calloc(t->n + 1, sizeof *w.fresh);
    orr_status s = ORR_E_MEMORY;
    if (g == NULL || last.verdict == NULL || out->verdict == NULL || out->arc == NULL || w.room == NULL ||
        w.fresh == NULL)
        goto done;
    for (size_t i = 0; i < n; i++) out->verdict[i].rejected = list[i].foreign;
    const size_t n_groups = make_groups(list, t, g);
    s = n_groups > 0 ? ORR_OK : ORR_E_NODATA;
    w.verdict = out->verdict;
    for (size_t a = 0, b; a < n_groups && s == ORR_OK; a = b) {
        b = a + 1;
        while (b < n_groups && !g[b].manoeuvre) b++;
        if (c->options->detect && b - a >= LEAST_NODES && told) {
            s = judge(&w, a, b, out->verdict);
            if (s == ORR_OK) s = segment_fit(&w, a, b, NULL);
            if (s == ORR_OK) tell_joints(&w, a, b);
            if (s == ORR_OK && quiet) doubt_ends(&w, a, b);
        }
        if (s == ORR_OK) add_arcs(&w, a, b, n_groups, out);
    }
    if (s == ORR_OK && !quiet && out->n_arcs == 1 && segment_is_fitted(&w, &out->arc[0])) goto done;
    for (size_t a = 0; a < out->n_arcs && s == ORR_OK; a++) {
        orr_filter_range(c, list, out->verdict, t, out->arc[a].first, out->arc[a].last);
        s = orr_smooth_range(c, out->verdict, t, out->arc[a].first, out->arc[a].last, NULL);
    }
done:
    free(last.verdict);
    free(g);
    free(w.room);
    free(w.fresh);
    if (s != ORR_OK) orr_segmentation_free(out);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/segmentation.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/smooth/leave_out.h"
#include "orbit/smooth/nodes.h"

// In units of what is usual for the satellite: a node this far from the orbit through all others is wrong; one
// that is less far is looked at, because an outlier among few nodes makes the others look bad.
#define WRONG 10.0
// Of nodes two hours apart a day has thirteen, and the orbit through all but the first one tells where that was to some
// centimetres. Good ones are up to 5 times as far off as is usual; 6 are once in 10^7 by chance (F of 3 and 18), at an end as
// elsewhere.
#define WRONG_VERY_SPARSE 6.0
#define WRONG_PLAIN 100.0 // the pole is wrong: at an hour's nodes, the last one of a good day reaches 40
#define FLOOR_M 0.10      // near shadow good nodes are off by up to half of it
#define SUSPICIOUS 5.0
// Among few nodes even a gross error is of the size of what it makes of the others: there a smaller one is looked at, and
// a scale that is not that of published positions.
#define CARRIED_ON_S 10900.0
#define FEW 60
#define SUSPICIOUS_FEW 3.0
#define USUAL_M 1e-3
// What a wrong node and a push have to take away from the sum of squares, in units of a node that is just wrong:
// a push explains what two wrong nodes would if the orbits before and after it meet, and three if they do not.
#define PUSH_COST 1.7
#define JUMP_COST 2.6
// How much worse an orbit is known beyond its last node than it claims, if nodes are dense.
#define ONE_SIDED 1.5
// An end node that is so far off and yet not wrong: once in 1500 good ones by chance. Nothing beside it tells which is right.
#define DOUBTFUL 3.0
#define DOUBTFUL_M 0.03
#define LEAST_NODES 6 // of a stretch, to tell what is usual
#define MOST_WRONG 4  // one node in so many, of many and of few
#define MOST_WRONG_FEW 3
#define MOST_PUSHES 6       // of a stretch
#define LEAST_PUSH_MPS 1e-3 // smaller steps are those of a centre's model, twice or four times a day
// Between sparse nodes f0's walk as it is for dense ones is far larger than what orbits do, and errors hide in it.
#define SPARSE_S 1900.0
#define VERY_SPARSE_S 5400.0
#define QUIET_SPARSE 0.03
#define QUIET_VERY_SPARSE 0.01
#define GROSS 2.0 // times the square of what is just wrong: errors that neighbours may share are looked for
#define BLOCK 0.1 // of the sum of squares must be left by two or three neighbours for them to be preferred
#define BLOCK_M 0.03 // by which a good node beside them must be off for them to be looked for
#define FAR 10.0     // times what nodes are usually off the reference orbit
#define FAR_M 0.10
#define MAX_SCALE_M 1.0 // a coordinate: what is noisier than that is no orbit that one could judge nodes by
#define JUMP_M 5.0      // files further apart at their joint each keep their own orbit
#define JUMP_TOLD_M 0.1
#define JUMP_MPS 0.01
#define MEET_PART 0.05 // of the way that a push moves a satellite over a node step: how well its orbits meet
#define MEET_M 0.02

typedef struct group { // the usable nodes of one instant
    size_t instant;
    bool manoeuvre; // flagged
    bool joint;     // another file begins
} group;

typedef struct trial { // a hypothesis: which nodes are wrong, where the satellite was pushed
    orr_verdict *verdict;
    size_t wrong, pushes;
    double scale2, chi2, penalty; // penalty in units of a wrong node
    bool good;                    // all is explained
} trial;

typedef struct fitted { // what the track's states are those of
    size_t a, b;        // groups; a == b: of nothing
    uint8_t *verdict;   // of each node
} fitted;

typedef struct work {
    const orr_track_context *c; // with noise as it is reckoned with here
    const orr_node *list;
    size_t n_nodes;
    orr_track *t;
    orr_verdict *verdict; // of the trial at hand
    const group *g;
    double *room;
    double wrong2, one_sided2, floor_m;
    double unit2; // of costs: what a wrong node counts beside a push
    fitted *fitted;
    orr_fresh_start *fresh; // of the track's instants, as find_push asked for them last
} work;

void orr_segmentation_free(orr_segmentation *s)
{
    free(s->arc);
    free(s->verdict);
    *s = (orr_segmentation){0};
}

static bool counts(const work *w, size_t i) { return orr_node_counts(&w->list[i]) && !w->list[i].foreign; }

static orr_instant *instant_of(const work *w, size_t g) { return &w->t->at[w->g[g].instant]; }

static bool group_rejected(const work *w, size_t g)
{
    const orr_instant *at = instant_of(w, g);
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (!w->list[i].superseded && !w->verdict[i].rejected) return false;
    return true;
}

// Takes the verdicts on groups [a, b) down; whether they are what the track was fitted with last.
static bool note_verdicts(const work *w, size_t a, size_t b)
{
    fitted *f = w->fitted;
    bool same = f->a == a && f->b == b;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++) {
            const uint8_t now = (uint8_t)(2 * w->verdict[i].begins_anew + w->verdict[i].rejected);
            same = same && f->verdict[i] == now;
            f->verdict[i] = now;
        }
    }
    f->a = a;
    f->b = b;
    return same;
}

// Whether the track's states are those of an arc with its verdicts.
static bool is_fitted(const work *w, const orr_arc_range *arc)
{
    const size_t a = w->fitted->a, b = w->fitted->b;
    return a < b && w->g[a].instant == arc->first && w->g[b - 1].instant == arc->last &&
           note_verdicts(w, a, b);
}

// Filter and smoother with the verdicts as they are; nothing is done twice, unless what could begin anew is asked for
// (fresh).
static orr_status fit_with(const work *w, size_t a, size_t b, orr_fresh_start *fresh)
{
    const size_t first = w->g[a].instant, last = w->g[b - 1].instant;
    if (note_verdicts(w, a, b) && fresh == NULL) return ORR_OK;
    orr_filter_range(w->c, w->list, w->verdict, w->t, first, last);
    const orr_status s = orr_smooth_range(w->c, w->verdict, w->t, first, last, fresh);
    if (s != ORR_OK) w->fitted->b = w->fitted->a;
    return s;
}

static orr_status fit(const work *w, size_t a, size_t b) { return fit_with(w, a, b, NULL); }

typedef struct look {
    double scale2; // robust: of the used nodes
    size_t used, worst,
        group; // the worst of the used ones that are far enough to be wrong (SIZE_MAX: none), and its group
    orr_left_out of_worst;
    size_t steepest; // group of the one that stands out most, however near
    orr_left_out of_steepest;
    bool noise; // the scale is larger than that of any orbit
} look;

// Nodes of groups [a, b) against the orbit through all others. 0.789 is the median of chi^2(3)/3.
static look look_at(const work *w, size_t a, size_t b)
{
    look l = {.worst = SIZE_MAX};
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++) {
            if (!counts(w, i) || w->verdict[i].rejected) continue;
            const orr_left_out d = orr_leave_node_out(w->c, at, &w->list[i], true);
            w->room[l.used++] = d.d2;
            if (d.d2 > l.of_steepest.d2) {
                l.steepest = g;
                l.of_steepest = d;
            }
            if (d.length_m > w->floor_m && d.d2 > l.of_worst.d2) {
                l.worst = i;
                l.group = g;
                l.of_worst = d;
            }
        }
    }
    const double most = MAX_SCALE_M / w->list[instant_of(w, a)->first].sigma_m;
    l.scale2 = l.used > 0 ? orr_upper_median(w->room, l.used) / 0.789 : 0;
    l.noise = l.scale2 > most * most;
    l.scale2 = fmin(l.scale2, most * most);
    return l;
}

static double sum_of_squares(const work *w, size_t a, size_t b)
{
    double sum = 0;
    for (size_t g = a; g < b; g++) sum += instant_of(w, g)->d2;
    return sum;
}

// Whether the orbits before and after a change of the state meet at some instant within the step before it.
static bool meets(const orr_fresh_start *f, double step_s)
{
    const double v = orr_vec3_norm(f->v_mps), way = v * step_s;
    if (!(v > 0)) return false;
    double ago = orr_vec3_dot(f->r_m, f->v_mps) / (v * v);
    ago = fmin(fmax(ago, 0), step_s);
    const double apart = orr_vec3_norm(orr_vec3_axpy(-ago, f->v_mps, f->r_m));
    return apart < fmax(MEET_PART * way, MEET_M);
}

typedef struct best_push {
    size_t g; // 0: none
    double gain, cost;
} best_push;

static best_push find_push(const work *w, size_t a, size_t b, double scale2)
{
    best_push best = {0};
    size_t before = a;
    if (fit_with(w, a, b, w->fresh) != ORR_OK) return best;
    for (size_t g = a + 1; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
        const orr_fresh_start *f = &w->fresh[w->g[g].instant];
        if (group_rejected(w, g)) continue;
        const double step_s = at->t_s - instant_of(w, before)->t_s;
        before = g;
        if (w->verdict[at->first].begins_anew || !f->told) continue;
        const double cost = 3 * w->unit2 * (meets(f, step_s) ? PUSH_COST : JUMP_COST);
        if (f->gain - cost * scale2 > best.gain - best.cost * scale2 || best.g == 0)
            best = (best_push){g, f->gain, cost};
    }
    return best;
}

// Rejected nodes that agree with the orbit of the others are used again, the nearest first.
static orr_status take_back(const work *w, size_t a, size_t b, trial *x)
{
    while (x->wrong > 0) {
        const look l = look_at(w, a, b);
        size_t begin = a, end = b;
        while (begin < end && group_rejected(w, begin)) begin++;
        while (end > begin && group_rejected(w, end - 1)) end--;
        size_t nearest = SIZE_MAX;
        double least = HUGE_VAL;
        for (size_t g = a; g < b; g++) {
            const orr_instant *at = instant_of(w, g);
            for (size_t i = at->first; i < at->first + at->n; i++) {
                if (!counts(w, i) || !w->verdict[i].rejected) continue;
                const orr_left_out d = orr_leave_node_out(w->c, at, &w->list[i], false);
                const double wrong2 = w->wrong2 * (g < begin || g >= end ? w->one_sided2 : 1);
                const bool near = d.d2 < wrong2 * l.scale2 || d.length_m < w->floor_m;
                if (near && d.d2 < least) {
                    nearest = i;
                    least = d.d2;
                }
            }
        }
        if (nearest == SIZE_MAX) return ORR_OK;
        w->verdict[nearest].rejected = false;
        x->wrong--;
        const orr_status s = fit(w, a, b);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

// Among few nodes neighbours that are off alike spread their error over the good ones beside them, none of which is then far.
static bool hides_block(const look *l)
{
    return l->used <= FEW && l->of_steepest.d2 > SUSPICIOUS_FEW * SUSPICIOUS_FEW * l->scale2 &&
           l->of_steepest.length_m > BLOCK_M;
}

static bool suspicious(const work *w, const look *l)
{
    if (l->worst == SIZE_MAX) return hides_block(l);
    const double sigma_m = w->list[l->worst].sigma_m;
    if (l->used > FEW) return l->of_worst.d2 > SUSPICIOUS * SUSPICIOUS * l->scale2;
    return l->of_worst.d2 > SUSPICIOUS_FEW * SUSPICIOUS_FEW * l->scale2 ||
           l->scale2 * sigma_m * sigma_m > USUAL_M * USUAL_M;
}

// Two or three neighbours that are off alike hold one another, and the good nodes beside them would be blamed. The
// reference orbit, where there is one, gives way to nobody: nodes that are far from it are set aside to begin with.
static void begin_with_reference(const work *w, size_t a, size_t b, size_t most, trial *x)
{
    size_t n = 0;
    if (w->c->reference == NULL) return;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
        if (!w->c->reference->fitted[at->window]) return;
        for (size_t i = at->first; i < at->first + at->n; i++)
            if (counts(w, i)) w->room[n++] = orr_vec3_norm(orr_track_measured(w->c, at, &w->list[i]));
    }
    if (n == 0) return;
    const double far_m = fmax(FAR * orr_upper_median(w->room, n), FAR_M);
    for (int mark = 0; mark < 2; mark++) {
        for (size_t g = a; g < b; g++) {
            const orr_instant *at = instant_of(w, g);
            for (size_t i = at->first; i < at->first + at->n; i++) {
                if (!counts(w, i) || orr_vec3_norm(orr_track_measured(w->c, at, &w->list[i])) < far_m)
                    continue;
                if (mark) w->verdict[i].rejected = true;
                x->wrong++;
            }
        }
        if (mark == 0 && x->wrong > most) mark = 2;
        if (mark != 1) x->wrong = 0;
    }
}

static void mark(const work *w, size_t from, size_t to, bool rejected)
{
    for (size_t g = from; g < to; g++) {
        const orr_instant *at = instant_of(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++)
            if (counts(w, i)) w->verdict[i].rejected = rejected;
    }
}

static size_t count_wrong(const work *w, size_t a, size_t b)
{
    size_t n = 0;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++) n += counts(w, i) && w->verdict[i].rejected;
    }
    return n;
}

typedef struct block { // groups [from, from + length)
    size_t from, length;
    double least; // sum of squares that it has to leave less than
} block;

// Two or three neighbours about group g that explain more than what went before.
static orr_status find_block(const work *w, size_t a, size_t b, size_t g, block *best)
{
    orr_status s = ORR_OK;
    for (size_t n = 2; n <= 3; n++)
        for (size_t first = g > a + n ? g - n : a; first <= g + 1 && first + n <= b && s == ORR_OK; first++) {
            if (count_wrong(w, first, first + n) > 0) continue;
            mark(w, first, first + n, true);
            s = fit(w, a, b);
            const double chi2 = s == ORR_OK ? sum_of_squares(w, a, b) : HUGE_VAL;
            if (s == ORR_E_NUMERIC) s = ORR_OK;
            mark(w, first, first + n, false);
            if (chi2 < best->least) *best = (block){first, n, BLOCK * chi2};
        }
    return s;
}

// Sets aside the worst node, or two or three neighbours about it, or about the node that stands out most, if that explains far
// more: nodes that are off alike hold one another, and the good one beside them looks worst.
static orr_status set_aside(const work *w, size_t a, size_t b, const look *l)
{
    const bool single = l->worst != SIZE_MAX;
    if (single) w->verdict[l->worst].rejected = true;
    // Nodes without which nothing tells the orbit are not to be set aside.
    orr_status s = fit(w, a, b);
    block best = {.least = s == ORR_OK ? BLOCK * sum_of_squares(w, a, b) : HUGE_VAL};
    if (s == ORR_E_NUMERIC) s = ORR_OK;
    if (single) w->verdict[l->worst].rejected = false;
    if (s == ORR_OK && single) s = find_block(w, a, b, l->group, &best);
    if (s == ORR_OK && !(single && l->steepest == l->group)) s = find_block(w, a, b, l->steepest, &best);
    if (best.length > 0)
        mark(w, best.from, best.from + best.length, true);
    else if (single)
        w->verdict[l->worst].rejected = true;
    return s;
}

// Explains what the nodes of groups [a, b) disagree in, one thing after the other: by wrong nodes alone, or by pushes too.
static orr_status explore(const work *w, size_t a, size_t b, bool may_push, trial *x)
{
    const size_t most = (b - a) / ((b - a) > FEW ? MOST_WRONG : MOST_WRONG_FEW);
    if (!may_push) begin_with_reference(w, a, b, most, x);
    orr_status s = fit(w, a, b);
    look l = look_at(w, a, b);
    while (s == ORR_OK && suspicious(w, &l)) {
        const best_push p =
            may_push && x->pushes < MOST_PUSHES ? find_push(w, a, b, l.scale2) : (best_push){0};
        if (p.g > 0 && p.gain - p.cost * l.scale2 > 3 * l.of_worst.d2 - 3 * w->unit2 * l.scale2 &&
            p.gain > p.cost * l.scale2) {
            w->verdict[instant_of(w, p.g)->first].begins_anew = true;
            x->pushes++;
            x->penalty += p.cost / (3 * w->unit2);
        } else {
            const size_t before = count_wrong(w, a, b);
            if (before >= most) break;
            if (l.used <= FEW || l.of_worst.d2 > GROSS * w->wrong2 * l.scale2)
                s = set_aside(w, a, b, &l);
            else
                w->verdict[l.worst].rejected = true;
            if (s == ORR_OK && count_wrong(w, a, b) == before) break;
        }
        if (s == ORR_OK) s = fit(w, a, b);
        l = look_at(w, a, b);
    }
    x->wrong = count_wrong(w, a, b);
    if (s == ORR_OK) s = take_back(w, a, b, x);
    l = look_at(w, a, b);
    x->scale2 = l.scale2;
    x->chi2 = sum_of_squares(w, a, b);
    x->penalty += (double)x->wrong;
    x->good = l.worst == SIZE_MAX || l.of_worst.d2 < w->wrong2 * l.scale2;
    return s;
}

static double cost(const trial *x, const work *w, double scale2)
{
    return x->chi2 / scale2 + 3 * w->unit2 * x->penalty;
}

// Steps of the velocity that no push is as small as are the model's, and no reason to begin anew.
static void forget_small_steps(const work *w, size_t a, size_t b)
{
    for (size_t g = a + 1; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
        if (!w->verdict[at->first].begins_anew) continue;
        const double v_mps =
            ORR_ANEW_V_MPS * ORR_ANEW_V_MPS * orr_vec3_norm((orr_vec3){at->u[3], at->u[4], at->u[5]});
        if (v_mps < LEAST_PUSH_MPS) w->verdict[at->first].begins_anew = false;
    }
}

// The verdicts on groups [a, b), no two of which a flag sets apart; foreign nodes are rejected before.
static orr_status judge(work *w, size_t a, size_t b, orr_verdict *verdict)
{
    trial alone = {.verdict = calloc(w->n_nodes + 1, sizeof(orr_verdict))},
          pushed = {.verdict = calloc(w->n_nodes + 1, sizeof(orr_verdict))};
    orr_status s = ORR_E_MEMORY;
    if (alone.verdict == NULL || pushed.verdict == NULL) goto done;
    memcpy(alone.verdict, verdict, w->n_nodes * sizeof *verdict);
    memcpy(pushed.verdict, verdict, w->n_nodes * sizeof *verdict);
    w->verdict = alone.verdict;
    s = explore(w, a, b, false, &alone);
    const trial *best = &alone;
    if (s == ORR_OK && (!alone.good || alone.wrong > 1)) {
        w->verdict = pushed.verdict;
        s = explore(w, a, b, true, &pushed);
        forget_small_steps(w, a, b);
        const double scale2 = fmin(alone.scale2, pushed.scale2);
        const bool better = cost(&pushed, w, scale2) < cost(&alone, w, scale2);
        if (s == ORR_OK && pushed.pushes > 0 && pushed.good >= alone.good &&
            (better || pushed.good > alone.good))
            best = &pushed;
    }
    w->verdict = best->verdict;
    if (s == ORR_OK) s = fit(w, a, b);
    // What is no orbit about a reference may be one by itself: the caller tries that.
    if (s == ORR_OK && look_at(w, a, b).noise) {
        mark(w, a, b, true);
        if (w->c->noise.nx == ORR_NX) s = ORR_E_NUMERIC;
    }
    if (s == ORR_OK)
        for (size_t g = a; g < b; g++) {
            const orr_instant *at = instant_of(w, g);
            memcpy(&verdict[at->first], &best->verdict[at->first], at->n * sizeof *verdict);
        }
done:
    free(alone.verdict);
    free(pushed.verdict);
    w->verdict = verdict;
    return s;
}

// Groups of instants with usable nodes.
static size_t make_groups(const orr_node *list, const orr_track *t, group *out)
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
        out[n] = (group){k, flagged, n > 0 && source != file};
        n++;
        file = source;
    }
    return n;
}

// Where another file begins: how far its orbit is from the one before, and whether that is another orbit.
static void tell_joints(const work *w, size_t a, size_t b)
{
    const double scale2 = look_at(w, a, b).scale2;
    bool asked = false; // the filter has admitted joints of rich orbits
    for (size_t g = a + 1; g < b; g++)
        asked = asked || (w->g[g].joint && !w->verdict[instant_of(w, g)->first].begins_anew &&
                          !instant_of(w, g)->step);
    if (asked && fit_with(w, a, b, w->fresh) != ORR_OK) return;
    for (size_t g = a + 1; g < b; g++) {
        const orr_instant *at = instant_of(w, g);
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
static void doubt_ends(const work *w, size_t a, size_t b)
{
    const double scale2 = look_at(w, a, b).scale2;
    size_t end[2] = {a, b - 1};
    while (end[0] < end[1] && group_rejected(w, end[0])) end[0]++;
    while (end[0] < end[1] && group_rejected(w, end[1])) end[1]--;
    if (end[0] == end[1]) return;
    for (int k = 0; k < 2; k++) {
        const orr_instant *at = instant_of(w, end[k]);
        const bool beside = k == 0 ? group_rejected(w, end[0] + 1) || end[0] > a
                                   : group_rejected(w, end[1] - 1) || end[1] + 1 < b;
        const double usual2 = beside ? 0 : DOUBTFUL * DOUBTFUL * scale2;
        for (size_t i = at->first; i < at->first + at->n; i++) {
            if (!counts(w, i) || w->verdict[i].rejected) continue;
            const orr_left_out d = orr_leave_node_out(w->c, at, &w->list[i], true);
            if (d.d2 > usual2 && d.length_m > DOUBTFUL_M) w->verdict[i].doubt_m = d.length_m;
        }
    }
}

// At the ends of the whole, where nothing else is, the orbit is carried on to where rejected nodes are.
static void add_arcs(const work *w, size_t a, size_t b, size_t n_groups, orr_segmentation *out)
{
    for (size_t g = a; g < b;) {
        size_t end = g + 1, good = 0;
        while (end < b && !w->verdict[instant_of(w, end)->first].begins_anew) end++;
        size_t first = g, last = end - 1;
        while (first < last && group_rejected(w, first)) first++;
        while (last > first && group_rejected(w, last)) last--;
        for (size_t k = first; k <= last; k++) good += !group_rejected(w, k);
        if (a == 0 && g == 0 && instant_of(w, first)->t_s - instant_of(w, 0)->t_s < CARRIED_ON_S) first = 0;
        if (end == n_groups && instant_of(w, end - 1)->t_s - instant_of(w, last)->t_s < CARRIED_ON_S)
            last = end - 1;
        if (good >= 2) out->arc[out->n_arcs++] = (orr_arc_range){w->g[first].instant, w->g[last].instant};
        for (size_t k = g; k < end; k++) w->verdict[instant_of(w, k)->first].begins_anew = false;
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
    group *g = malloc((t->n + 1) * sizeof *g);
    fitted last = {.verdict = calloc(n + 1, sizeof *last.verdict)};
    work w = {.c = &own,
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
            if (s == ORR_OK) s = fit(&w, a, b);
            if (s == ORR_OK) tell_joints(&w, a, b);
            if (s == ORR_OK && quiet) doubt_ends(&w, a, b);
        }
        if (s == ORR_OK) add_arcs(&w, a, b, n_groups, out);
    }
    if (s == ORR_OK && !quiet && out->n_arcs == 1 && is_fitted(&w, &out->arc[0])) goto done;
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

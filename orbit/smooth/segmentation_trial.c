// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>

#include "core/robust.h"
#include "orbit/smooth/segmentation_private.h"

#define SUSPICIOUS 5.0
// Among few nodes even a gross error is of the size of what it makes of the others: there a smaller one is looked at, and
// a scale that is not that of published positions.
#define FEW 60
#define SUSPICIOUS_FEW 3.0
#define USUAL_M 1e-3
// What a wrong node and a push have to take away from the sum of squares, in units of a node that is just wrong:
// a push explains what two wrong nodes would if the orbits before and after it meet, and three if they do not.
#define PUSH_COST 1.7
#define JUMP_COST 2.6
#define MOST_WRONG 4 // one node in so many, of many and of few
#define MOST_WRONG_FEW 3
#define MOST_PUSHES 6 // of a stretch
#define GROSS 2.0 // times the square of what is just wrong: errors that neighbours may share are looked for
#define BLOCK 0.1 // of the sum of squares must be left by two or three neighbours for them to be preferred
#define BLOCK_M 0.03 // by which a good node beside them must be off for them to be looked for
#define FAR 10.0     // times what nodes are usually off the reference orbit
#define FAR_M 0.10
#define MAX_SCALE_M 1.0 // a coordinate: what is noisier than that is no orbit that one could judge nodes by
#define MEET_PART 0.05  // of the way that a push moves a satellite over a node step: how well its orbits meet
#define MEET_M 0.02

bool segment_rejected(const segment_work *w, size_t g)
{
    const orr_instant *at = segment_instant(w, g);
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (!w->list[i].superseded && !w->verdict[i].rejected) return false;
    return true;
}

// Takes the verdicts on groups [a, b) down; whether they are what the track was fitted with last.
static bool note_verdicts(const segment_work *w, size_t a, size_t b)
{
    segment_fitted *f = w->fitted;
    bool same = f->a == a && f->b == b;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
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
bool segment_is_fitted(const segment_work *w, const orr_arc_range *arc)
{
    const size_t a = w->fitted->a, b = w->fitted->b;
    return a < b && w->g[a].instant == arc->first && w->g[b - 1].instant == arc->last &&
           note_verdicts(w, a, b);
}

// Filter and smoother with the verdicts as they are; nothing is done twice, unless what could begin anew is asked for
// (fresh).
orr_status segment_fit(const segment_work *w, size_t a, size_t b, orr_fresh_start *fresh)
{
    const size_t first = w->g[a].instant, last = w->g[b - 1].instant;
    if (note_verdicts(w, a, b) && fresh == NULL) return ORR_OK;
    orr_filter_range(w->c, w->list, w->verdict, w->t, first, last);
    const orr_status s = orr_smooth_range(w->c, w->verdict, w->t, first, last, fresh);
    if (s != ORR_OK) w->fitted->b = w->fitted->a;
    return s;
}

// Nodes of groups [a, b) against the orbit through all others. 0.789 is the median of chi^2(3)/3.
segment_look segment_look_at(const segment_work *w, size_t a, size_t b)
{
    segment_look l = {.worst = SIZE_MAX};
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++) {
            if (!segment_counts(w, i) || w->verdict[i].rejected) continue;
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
    const double most = MAX_SCALE_M / w->list[segment_instant(w, a)->first].sigma_m;
    l.scale2 = l.used > 0 ? orr_upper_median(w->room, l.used) / 0.789 : 0;
    l.noise = l.scale2 > most * most;
    l.scale2 = fmin(l.scale2, most * most);
    return l;
}

static double sum_of_squares(const segment_work *w, size_t a, size_t b)
{
    double sum = 0;
    for (size_t g = a; g < b; g++) sum += segment_instant(w, g)->d2;
    return sum;
}

// The same without what the first two nodes of an orbit are off where it was begun: that is no noise of theirs.
static double squares_beyond_starts(const segment_work *w, size_t a, size_t b)
{
    double sum = 0;
    int open = 2;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        if (w->verdict[at->first].begins_anew) open = 2;
        if (segment_rejected(w, g)) continue;
        if (open > 0)
            open--;
        else
            sum += at->d2;
    }
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

static best_push find_push(const segment_work *w, size_t a, size_t b, double scale2)
{
    best_push best = {0};
    size_t before = a;
    if (segment_fit(w, a, b, w->fresh) != ORR_OK) return best;
    for (size_t g = a + 1; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        const orr_fresh_start *f = &w->fresh[w->g[g].instant];
        if (segment_rejected(w, g)) continue;
        const double step_s = at->t_s - segment_instant(w, before)->t_s;
        before = g;
        if (w->verdict[at->first].begins_anew || !f->told) continue;
        const double cost = 3 * w->unit2 * (meets(f, step_s) ? PUSH_COST : JUMP_COST);
        if (f->gain - cost * scale2 > best.gain - best.cost * scale2 || best.g == 0)
            best = (best_push){g, f->gain, cost};
    }
    return best;
}

// Rejected nodes that agree with the orbit of the others are used again, the nearest first.
static orr_status take_back(const segment_work *w, size_t a, size_t b, segment_trial *x)
{
    while (x->wrong > 0) {
        const segment_look l = segment_look_at(w, a, b);
        size_t begin = a, end = b;
        while (begin < end && segment_rejected(w, begin)) begin++;
        while (end > begin && segment_rejected(w, end - 1)) end--;
        size_t nearest = SIZE_MAX;
        double least = HUGE_VAL;
        for (size_t g = a; g < b; g++) {
            const orr_instant *at = segment_instant(w, g);
            for (size_t i = at->first; i < at->first + at->n; i++) {
                if (!segment_counts(w, i) || !w->verdict[i].rejected) continue;
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
        const orr_status s = segment_fit(w, a, b, NULL);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

// Among few nodes neighbours that are off alike spread their error over the good ones beside them, none of which is then far.
static bool hides_block(const segment_look *l)
{
    return l->used <= FEW && l->of_steepest.d2 > SUSPICIOUS_FEW * SUSPICIOUS_FEW * l->scale2 &&
           l->of_steepest.length_m > BLOCK_M;
}

static bool suspicious(const segment_work *w, const segment_look *l)
{
    if (l->worst == SIZE_MAX) return hides_block(l);
    const double sigma_m = w->list[l->worst].sigma_m;
    if (l->used > FEW) return l->of_worst.d2 > SUSPICIOUS * SUSPICIOUS * l->scale2;
    return l->of_worst.d2 > SUSPICIOUS_FEW * SUSPICIOUS_FEW * l->scale2 ||
           l->scale2 * sigma_m * sigma_m > USUAL_M * USUAL_M;
}

// Two or three neighbours that are off alike hold one another, and the good nodes beside them would be blamed. The
// reference orbit, where there is one, gives way to nobody: nodes that are far from it are set aside to begin with.
static void begin_with_reference(const segment_work *w, size_t a, size_t b, size_t most, segment_trial *x)
{
    size_t n = 0;
    if (w->c->reference == NULL) return;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        if (!w->c->reference->fitted[at->window]) return;
        for (size_t i = at->first; i < at->first + at->n; i++)
            if (segment_counts(w, i)) w->room[n++] = orr_vec3_norm(orr_track_measured(w->c, at, &w->list[i]));
    }
    if (n == 0) return;
    const double far_m = fmax(FAR * orr_upper_median(w->room, n), FAR_M);
    for (int mark = 0; mark < 2; mark++) {
        for (size_t g = a; g < b; g++) {
            const orr_instant *at = segment_instant(w, g);
            for (size_t i = at->first; i < at->first + at->n; i++) {
                if (!segment_counts(w, i) || orr_vec3_norm(orr_track_measured(w->c, at, &w->list[i])) < far_m)
                    continue;
                if (mark) w->verdict[i].rejected = true;
                x->wrong++;
            }
        }
        if (mark == 0 && x->wrong > most) mark = 2;
        if (mark != 1) x->wrong = 0;
    }
}

void segment_mark(const segment_work *w, size_t from, size_t to, bool rejected)
{
    for (size_t g = from; g < to; g++) {
        const orr_instant *at = segment_instant(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++)
            if (segment_counts(w, i)) w->verdict[i].rejected = rejected;
    }
}

static size_t count_wrong(const segment_work *w, size_t a, size_t b)
{
    size_t n = 0;
    for (size_t g = a; g < b; g++) {
        const orr_instant *at = segment_instant(w, g);
        for (size_t i = at->first; i < at->first + at->n; i++)
            n += segment_counts(w, i) && w->verdict[i].rejected;
    }
    return n;
}

typedef struct block { // groups [from, from + length)
    size_t from, length;
    double least; // sum of squares that it has to leave less than
} block;

// Two or three neighbours about group g that explain more than what went before.
static orr_status find_block(const segment_work *w, size_t a, size_t b, size_t g, block *best)
{
    orr_status s = ORR_OK;
    for (size_t n = 2; n <= 3; n++)
        for (size_t first = g > a + n ? g - n : a; first <= g + 1 && first + n <= b && s == ORR_OK; first++) {
            if (count_wrong(w, first, first + n) > 0) continue;
            segment_mark(w, first, first + n, true);
            s = segment_fit(w, a, b, NULL);
            const double chi2 = s == ORR_OK ? sum_of_squares(w, a, b) : HUGE_VAL;
            if (s == ORR_E_NUMERIC) s = ORR_OK;
            segment_mark(w, first, first + n, false);
            if (chi2 < best->least) *best = (block){first, n, BLOCK * chi2};
        }
    return s;
}

// Sets aside the worst node, or two or three neighbours about it, or about the node that stands out most, if that explains far
// more: nodes that are off alike hold one another, and the good one beside them looks worst.
static orr_status set_aside(const segment_work *w, size_t a, size_t b, const segment_look *l)
{
    const bool single = l->worst != SIZE_MAX;
    if (single) w->verdict[l->worst].rejected = true;
    // Nodes without which nothing tells the orbit are not to be set aside.
    orr_status s = segment_fit(w, a, b, NULL);
    block best = {.least = s == ORR_OK ? BLOCK * sum_of_squares(w, a, b) : HUGE_VAL};
    if (s == ORR_E_NUMERIC) s = ORR_OK;
    if (single) w->verdict[l->worst].rejected = false;
    if (s == ORR_OK && single) s = find_block(w, a, b, l->group, &best);
    if (s == ORR_OK && !(single && l->steepest == l->group)) s = find_block(w, a, b, l->steepest, &best);
    if (best.length > 0)
        segment_mark(w, best.from, best.from + best.length, true);
    else if (single)
        w->verdict[l->worst].rejected = true;
    return s;
}

// Explains what the nodes of groups [a, b) disagree in, one thing after the other: by wrong nodes alone, or by pushes too.
orr_status segment_explore(const segment_work *w, size_t a, size_t b, bool may_push, segment_trial *x)
{
    const size_t most = (b - a) / ((b - a) > FEW ? MOST_WRONG : MOST_WRONG_FEW);
    if (!may_push) begin_with_reference(w, a, b, most, x);
    orr_status s = segment_fit(w, a, b, NULL);
    segment_look l = segment_look_at(w, a, b);
    while (s == ORR_OK && suspicious(w, &l)) {
        const best_push p =
            may_push && x->pushes < MOST_PUSHES ? find_push(w, a, b, l.scale2) : (best_push){0};
        if (p.g > 0 && p.gain - p.cost * l.scale2 > 3 * l.of_worst.d2 - 3 * w->unit2 * l.scale2 &&
            p.gain > p.cost * l.scale2) {
            w->verdict[segment_instant(w, p.g)->first].begins_anew = true;
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
        if (s == ORR_OK) s = segment_fit(w, a, b, NULL);
        l = segment_look_at(w, a, b);
    }
    x->wrong = count_wrong(w, a, b);
    if (s == ORR_OK) s = take_back(w, a, b, x);
    l = segment_look_at(w, a, b);
    x->scale2 = l.scale2;
    x->chi2 = squares_beyond_starts(w, a, b);
    x->penalty += (double)x->wrong;
    x->good = l.worst == SIZE_MAX || l.of_worst.d2 < w->wrong2 * l.scale2;
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Slow terms as cubics between nodes of a lattice. A node is the antenna's own place, so that neighbouring cells meet in value and
// rate. The middle of every cell is computed too: where cubic and terms differ there by more than a share of what is allowed, in
// value or in rate, the cell of this satellite is halved, down to 0.6 s. So smooth terms keep long cells, and about a corner (a
// turn of a satellite, a node of an ionosphere's map, of an antenna's table) they are short; the corner itself is rounded. Where
// there is no channel at one end (an arc's end, a satellite that rises), the terms are computed at each instant.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "src/scenario/channel/slow.h"

#include "core/hermite.h"

// A node's rates are differences over this time on both sides. Terms of 50 m with second derivatives of 1e-3 m/s^2 lose 1e-9 m.
static const int64_t SIDE_NS = ORR_NS_PER_S / 1000;
// Farther from its cubic an antenna on a body may not be: a troposphere's slope is taken along, its bend is 2e-7 /m.
static const double STRAY_M = 2;
// What a fixed antenna's terms may be off at a cell's middle; of a moving one a tenth of channel.error_m.
static const double OFF_M = 1e-7;

typedef struct slow_node {
    bool ok;
    uint32_t flags;
    orr_vec3 r_m, v_mps; // of the antenna
    double v[SLOW_MOST], r[SLOW_MOST];
    orr_vec3 per_m[SLOW_SLOPES]; // as slow_values
} slow_node;

// Satellites have their cells at different seconds, so that not all of them need nodes at one instant: whoever asks ten times a second
// waits for a few satellites now and then, and not for all of them every hundredth time.
static int64_t offset_ns(uint16_t place)
{
    return (int64_t)(place % SLOW_GROUPS) * (LATTICE_NS / SLOW_GROUPS);
}

// Nodes that are kept: of the lattice's whole cells two, by turns, and one of each halving.
enum { HALVINGS = 5, KEPT = 2 + HALVINGS };
_Static_assert(LATTICE_LEAST_NS << (HALVINGS - 1) == LATTICE_NS, "the shortest cell's middle is kept too");

typedef struct slow_cell {
    orr_time from, to; // [from, to)
    bool curves;       // else they are computed for each instant, last for `asked`
    orr_time asked;
    bool ok;
    uint32_t flags;
    double c[4][SLOW_MOST];
    orr_vec3 path[4];               // the antenna
    orr_vec3 per_m[SLOW_SLOPES][2]; // as slow_values: at the begin, and its change by second
    orr_time kept[KEPT];            // instants of nodes that were computed: the next cells need them again
    slow_node node[KEPT];
} slow_cell;

slow_cell *slow_cells_open(size_t n)
{
    slow_cell *cell = calloc(n, sizeof *cell);
    if (cell != NULL) slow_cells_forget(cell, n);
    return cell;
}

void slow_cells_forget(slow_cell *cell, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        cell[k].from = cell[k].to = 0;
        cell[k].curves = false;
        cell[k].asked = ORR_TIME_NONE;
        for (int j = 0; j < KEPT; j++) cell[k].kept[j] = ORR_TIME_NONE;
    }
}

slow_node *slow_nodes_open(size_t n) { return calloc(n, sizeof(slow_node)); }

static void pair_to_node(const slow_values *a, const slow_values *b, double between_s, slow_node *out)
{
    out->ok = true;
    out->flags = a->flags;
    for (size_t i = 0; i < SLOW_MOST; i++) {
        out->v[i] = a->v[i] + (b->v[i] - a->v[i]) / 2;
        out->r[i] = (b->v[i] - a->v[i]) / between_s;
    }
    memcpy(out->per_m, a->per_m, sizeof out->per_m);
}

static orr_antenna_state carried(const orr_antenna *a, const orr_antenna_state *at, double s)
{
    return a->motion == NULL ? *at : orr_antenna_carried(at, s);
}

// At an end of the time in which there are values: value there, rate from one side.
static void one_sided(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                      const orr_antenna_state *at, uint16_t place, slow_node *out)
{
    slow_values here, there;
    slow_at(c, antenna, work, t, at, c->antenna[antenna].motion != NULL, &place, 1, &here);
    if (!here.ok) return;
    out->ok = true;
    out->flags = here.flags;
    memcpy(out->per_m, here.per_m, sizeof out->per_m);
    for (size_t i = 0; i < SLOW_MOST; i++) {
        out->v[i] = here.v[i];
        out->r[i] = 0;
    }
    for (int side = -1; side <= 1; side += 2) {
        const double s = side * (double)SIDE_NS / 1e9;
        const orr_antenna_state near = carried(&c->antenna[antenna], at, s);
        slow_at(c, antenna, work, orr_time_add(t, side * SIDE_NS), &near, false, &place, 1, &there);
        if (!there.ok) continue;
        for (size_t i = 0; i < SLOW_MOST; i++) out->r[i] = (there.v[i] - here.v[i]) / s;
        return;
    }
}

// Nodes of satellites at t; a function of (scenario, t, at).
static void make_nodes(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                       const orr_antenna_state *at, const uint16_t *place, size_t n, slow_node *out)
{
    const double s = (double)SIDE_NS / 1e9;
    const bool moving = c->antenna[antenna].motion != NULL;
    const orr_antenna_state before = carried(&c->antenna[antenna], at, -s),
                            after = carried(&c->antenna[antenna], at, s);
    for (size_t first = 0; first < n; first += SLOW_BATCH) {
        const size_t m = n - first < SLOW_BATCH ? n - first : SLOW_BATCH;
        slow_at(c, antenna, work, orr_time_add(t, -SIDE_NS), &before, moving, &place[first], m,
                work->values[0]);
        slow_at(c, antenna, work, orr_time_add(t, SIDE_NS), &after, false, &place[first], m, work->values[1]);
        for (size_t k = 0; k < m; k++) {
            slow_node *node = &out[first + k];
            const slow_values *a = &work->values[0][k], *b = &work->values[1][k];
            node->ok = false;
            node->r_m = at->r_m;
            node->v_mps = at->v_mps;
            if (a->ok && b->ok)
                pair_to_node(a, b, 2 * s, node);
            else if (a->ok || b->ok)
                one_sided(c, antenna, work, t, at, place[first + k], node);
        }
    }
}

// Where a node so long after a satellite's offset is kept.
static int keeping_place(orr_time t)
{
    int64_t step = LATTICE_NS;
    if (t % step == 0) return (int)(t / step & 1);
    int halving = 0;
    while (halving < HALVINGS - 1 && t % (step /= 2) != 0) halving++;
    return 2 + halving;
}

// Nodes at t of the antenna's own place, of satellites of one group, kept or made; none are ok where it is not there.
static void nodes_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                     const uint16_t *place, size_t n, slow_node *out)
{
    slow_cell *cell = work->antenna[antenna].slow;
    const int keep = keeping_place(t - offset_ns(place[0]));
    orr_antenna_state at;
    size_t missing = 0;
    for (size_t k = 0; k < n; k++)
        if (cell[place[k]].kept[keep] != t) work->missing[missing++] = place[k];
    if (missing > 0 && orr_antenna_at(&c->antenna[antenna], t, &at) == ORR_ANSWER_OK)
        make_nodes(c, antenna, work, t, &at, work->missing, missing, work->node[3]);
    else
        for (size_t k = 0; k < missing; k++) work->node[3][k].ok = false;
    for (size_t k = 0; k < missing; k++) {
        cell[work->missing[k]].kept[keep] = t;
        cell[work->missing[k]].node[keep] = work->node[3][k];
    }
    for (size_t k = 0; k < n; k++) out[k] = cell[place[k]].node[keep];
}

static orr_vec3 path_at(const orr_vec3 c[4], double s)
{
    return orr_vec3_axpy(s, orr_vec3_axpy(s, orr_vec3_axpy(s, c[3], c[2]), c[1]), c[0]);
}

static orr_vec3 path_rate(const orr_vec3 c[4], double s)
{
    return orr_vec3_axpy(s, orr_vec3_axpy(s, orr_vec3_scale(3, c[3]), orr_vec3_scale(2, c[2])), c[1]);
}

static void make_path(orr_vec3 r0, orr_vec3 v0, orr_vec3 r1, orr_vec3 v1, double T, orr_vec3 c[4])
{
    const double from[3] = {r0.x, r0.y, r0.z}, rise[3] = {r1.x - r0.x, r1.y - r0.y, r1.z - r0.z},
                 v[3] = {v0.x, v0.y, v0.z}, w[3] = {v1.x, v1.y, v1.z};
    double x[3][4];
    for (int k = 0; k < 3; k++) orr_hermite_cubic(from[k], rise[k], v[k], w[k], T, x[k]);
    for (int j = 0; j < 4; j++) c[j] = (orr_vec3){x[0][j], x[1][j], x[2][j]};
}

static void make_curves(const slow_node *a, const slow_node *b, double T, slow_cell *cell)
{
    for (size_t i = 0; i < SLOW_MOST; i++) {
        double c[4];
        orr_hermite_cubic(a->v[i], b->v[i] - a->v[i], a->r[i], b->r[i], T, c);
        for (int j = 0; j < 4; j++) cell->c[j][i] = c[j];
    }
    make_path(a->r_m, a->v_mps, b->r_m, b->v_mps, T, cell->path);
    for (int k = 0; k < SLOW_SLOPES; k++) {
        cell->per_m[k][0] = a->per_m[k];
        cell->per_m[k][1] = orr_vec3_scale(1 / T, orr_vec3_sub(b->per_m[k], a->per_m[k]));
    }
    cell->flags = a->flags;
    cell->ok = true;
}

static void evaluate(const slow_cell *cell, size_t n, double s, orr_vec3 r_m, orr_vec3 v_mps, bool moving,
                     slow_now *out)
{
    const double *restrict c0 = cell->c[0], *restrict c1 = cell->c[1], *restrict c2 = cell->c[2],
                           *restrict c3 = cell->c[3];
    double *restrict v = out->v, *restrict r = out->r;
    for (size_t i = 0; i < n; i++) {
        v[i] = c0[i] + s * (c1[i] + s * (c2[i] + s * c3[i]));
        r[i] = c1[i] + s * (2 * c2[i] + s * (3 * c3[i]));
    }
    out->ok = cell->ok;
    out->flags = cell->flags;
    if (!moving) return;
    const orr_vec3 off = orr_vec3_sub(r_m, path_at(cell->path, s)),
                   off_rate = orr_vec3_sub(v_mps, path_rate(cell->path, s));
    for (int k = 0; k < SLOW_SLOPES; k++) {
        const orr_vec3 g = orr_vec3_axpy(s, cell->per_m[k][1], cell->per_m[k][0]);
        v[SLOW_HYDROSTATIC + k] += orr_vec3_dot(g, off);
        r[SLOW_HYDROSTATIC + k] += orr_vec3_dot(g, off_rate) + orr_vec3_dot(cell->per_m[k][1], off);
    }
}

// Metres, for which a value of 1 stands.
static double metres_of(size_t i)
{
    switch (i) {
    case SLOW_FLIGHT:
        return 0.1; // an estimate, to 1e-6 s
    case SLOW_CONTENT:
    case SLOW_DISTURBANCE:
        return ORR_IONO_K_M3_PER_S2 / (1.2e9 * 1.2e9);
    case SLOW_CONTENT_FIELD:
        return ORR_IONO_SECOND_M4_PER_S3_T / (1.2e9 * 1.2e9 * 1.2e9);
    case SLOW_S4:
    case SLOW_SIGMA_PHI:
        return 1e-5; // of an index
    case SLOW_APPROACH:
        return 100; // of delays
    case SLOW_TURNS:
        return 0.25;
    default:
        return i >= SLOW_SHARED && (i - SLOW_SHARED) % SLOW_OF == SLOW_POWER ? 1e-4 : 1; // 1e-3 dB
    }
}

// Whether the curves hold the middle, value and rate (whose error is that of a value a sixth of the cell long).
static bool holds(const orr_channels *c, size_t antenna, const slow_cell *cell, size_t n,
                  const slow_node *middle, double T)
{
    slow_now x = {.ok = false};
    const bool moving = c->antenna[antenna].motion != NULL;
    const double allowed = moving ? c->options.error_m / 10 : OFF_M;
    evaluate(cell, n, T / 2, middle->r_m, middle->v_mps, moving, &x);
    for (size_t i = 0; i < n; i++) {
        const double m = metres_of(i);
        if (!(fabs(x.v[i] - middle->v[i]) * m <= allowed) ||
            !(fabs(x.r[i] - middle->r[i]) * m * T / 6 <= allowed))
            return false;
    }
    return true;
}

// The stretch of a lattice, shifted by an offset, about t in which a moving antenna stays near the cubic through its ends.
static orr_span leaf_of(const orr_antenna *a, orr_time t, int64_t offset)
{
    static const double PARTS[] = {0.21, 0.5, 0.72};
    const orr_time from = lattice_cell(t - offset) + offset;
    orr_span leaf = {from, from + LATTICE_NS};
    if (a->motion == NULL) return leaf;
    for (;;) {
        orr_antenna_state x0, x1, x;
        const int64_t length = leaf.to - leaf.from;
        const double T = (double)length / 1e9;
        bool near = orr_antenna_at(a, leaf.from, &x0) == ORR_ANSWER_OK &&
                    orr_antenna_at(a, leaf.to, &x1) == ORR_ANSWER_OK;
        orr_vec3 path[4];
        if (near) make_path(x0.r_m, x0.v_mps, x1.r_m, x1.v_mps, T, path);
        for (size_t k = 0; near && k < sizeof PARTS / sizeof *PARTS; k++) {
            const int64_t dt = (int64_t)(PARTS[k] * (double)length);
            near = orr_antenna_at(a, leaf.from + dt, &x) == ORR_ANSWER_OK &&
                   orr_vec3_norm(orr_vec3_sub(x.r_m, path_at(path, (double)dt / 1e9))) <= STRAY_M;
        }
        if (near || length <= LATTICE_LEAST_NS) return leaf;
        const orr_time middle = leaf.from + length / 2;
        if (t < middle)
            leaf.to = middle;
        else
            leaf.from = middle;
    }
}

// Cells of satellites todo[0..n) of one group, which hold t: of one length at first, each halved until it holds.
static void make_cells(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t, size_t n)
{
    channel_antenna_work *w = &work->antenna[antenna];
    uint16_t *todo = work->todo;
    slow_node *a = work->node[0], *b = work->node[1], *m = work->node[2];
    orr_span *leaf = &w->leaf[todo[0] % SLOW_GROUPS];
    if (t < leaf->from || t >= leaf->to) *leaf = leaf_of(&c->antenna[antenna], t, offset_ns(todo[0]));
    orr_span s = *leaf;
    nodes_at(c, antenna, work, s.from, todo, n, a);
    nodes_at(c, antenna, work, s.to, todo, n, b);
    while (n > 0) {
        const int64_t length = s.to - s.from;
        const orr_time middle = s.from + length / 2;
        const bool left = t < middle, last = length <= LATTICE_LEAST_NS;
        const double T = (double)length / 1e9;
        size_t again = 0;
        nodes_at(c, antenna, work, middle, todo, n, m);
        for (size_t k = 0; k < n; k++) {
            slow_cell *cell = &w->slow[todo[k]];
            const bool there = a[k].ok && b[k].ok && m[k].ok;
            if (there) make_curves(&a[k], &b[k], T, cell);
            if (last ||
                (there && holds(c, antenna, cell, slow_count(c->satellite[todo[k]].n_sent), &m[k], T))) {
                cell->from = s.from;
                cell->to = s.to;
                cell->curves = there;
                cell->asked = ORR_TIME_NONE;
                continue;
            }
            todo[again] = todo[k];
            a[again] = left ? a[k] : m[k];
            b[again++] = left ? m[k] : b[k];
        }
        n = again;
        if (left)
            s.to = middle;
        else
            s.from = middle;
    }
}

// The terms themselves, at t, for cells without curves.
static void ask(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                const orr_antenna_state *at, size_t n)
{
    slow_node *node = work->node[0];
    make_nodes(c, antenna, work, t, at, work->todo, n, node);
    for (size_t k = 0; k < n; k++) {
        slow_cell *cell = &work->antenna[antenna].slow[work->todo[k]];
        cell->asked = t;
        cell->ok = node[k].ok;
        if (!cell->ok) continue;
        make_curves(&node[k], &node[k], 1, cell);
        for (size_t i = 0; i < SLOW_MOST; i++) cell->c[2][i] = cell->c[3][i] = 0;
    }
}

void slow_prepare(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                  const orr_antenna_state *at, const uint16_t *place, size_t n)
{
    channel_antenna_work *w = &work->antenna[antenna];
    size_t stale = 0, m = 0;
    for (size_t k = 0; k < n; k++) {
        const slow_cell *cell = &w->slow[place[k]];
        if (t < cell->from || t >= cell->to) work->stale[stale++] = place[k];
    }
    for (int group = 0; stale > 0 && group < SLOW_GROUPS; group++) {
        m = 0;
        for (size_t k = 0; k < stale; k++)
            if (work->stale[k] % SLOW_GROUPS == group) work->todo[m++] = work->stale[k];
        if (m > 0) make_cells(c, antenna, work, t, m);
    }
    m = 0;
    for (size_t k = 0; k < n; k++) {
        const slow_cell *cell = &w->slow[place[k]];
        if (!cell->curves && cell->asked != t) work->todo[m++] = place[k];
    }
    if (m > 0) ask(c, antenna, work, t, at, m);
}

void slow_of_satellite(const orr_channels *c, size_t antenna, const orr_channel_work *work, orr_time t,
                       const orr_antenna_state *at, uint16_t place, slow_now *out)
{
    const slow_cell *cell = &work->antenna[antenna].slow[place];
    const size_t n = slow_count(c->satellite[place].n_sent);
    if (cell->curves)
        evaluate(cell, n, orr_time_diff_s(t, cell->from), at->r_m, at->v_mps,
                 c->antenna[antenna].motion != NULL, out);
    else
        evaluate(cell, n, 0, at->r_m, at->v_mps, false, out);
}

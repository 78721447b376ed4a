// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/track.h"

#include <stdlib.h>
#include <string.h>

#include "orbit/smooth/file_noise.h"

#define KEPT_STEPS 2500 // of a grid: four days of 150 s, 2.3 MB
#define STOP_S 900.0    // between instants without nodes, at most
#define WIDE_GAP_S 10800.0
#define OPEN_END 100.0
#define OPEN_END_OF_REFERENCE 100.0 // three hours of 2010-182 are 3.6 sigma off without, 0.9 with it
#define SAME_INSTANT_S 1e-6         // SP3 writes epochs to 1e-8 s; filter steps are a hundred seconds

void orr_track_free(orr_track *t)
{
    free(t->at);
    free(t->grid);
    free(t->steps.step);
    *t = (orr_track){0};
}

// Samples per segment: six where the count allows, else the nearest number that divides it.
static size_t choose_segment(size_t intervals)
{
    static const size_t liked[] = {ORR_SAMPLES_PER_SEGMENT, 5, 4, 8, 7, 3, 2};
    for (size_t i = 0; i < sizeof liked / sizeof liked[0]; i++)
        if (intervals % liked[i] == 0) return liked[i];
    return 0;
}

// Number of sample intervals over a span: the step divides node_step_s when the span is a multiple of it, so
// that nodes fall on samples; else the least number whose step is a whole number of nanoseconds, as the
// product wants it. A span of whole milliseconds has one at most a quarter above the least (2^a 5^b, a and b
// up to 6).
static size_t choose_intervals(int64_t span_ns, double node_step_s, double grid_s, size_t *per_segment)
{
    const double span_s = (double)span_ns * 1e-9;
    double steps = node_step_s > 0 ? span_s / node_step_s : 0;
    if (steps >= 1 && fabs(steps - round(steps)) * node_step_s < SAME_INSTANT_S) {
        size_t n = (size_t)round(steps) * (size_t)ceil(node_step_s / grid_s - 1e-9);
        *per_segment = choose_segment(n);
        if (*per_segment > 0 && span_ns % (int64_t)n == 0) return n;
    }
    size_t least = (size_t)fmax(ceil(span_s / grid_s - 1e-9), 2);
    for (size_t n = least; n <= 4 * least; n++) {
        *per_segment = choose_segment(n);
        if (*per_segment > 0 && span_ns % (int64_t)n == 0) return n;
    }
    *per_segment = ORR_SAMPLES_PER_SEGMENT;
    double segments = ceil(span_s / (grid_s * ORR_SAMPLES_PER_SEGMENT) - 1e-9);
    return (size_t)(segments > 1 ? segments : 1) * ORR_SAMPLES_PER_SEGMENT;
}

// Without Earth-orientation data the secular pole is off by 0.1-0.2": positions seem to swing by metres once
// a day, an acceleration of 1e-7 m/s^2 that f0 follows from node to node but that nothing tells inside a gap.
// Measured on 2024-035 with gaps of 1 to 8 h, errors grow faster than the random walk by the square of the
// gap's length beyond three hours; with the true pole they do not. Beyond the last node nothing holds the
// orbit on the far side: there errors are five to fifteen times the random walk's from the first half hour on
// (2009-091, 2010-182; with an ERP file, on 2008-279, they are not).
static void widen_gaps(const orr_track_context *c, const orr_node *list, orr_track *t)
{
    size_t from = 0;
    for (size_t k = 0; k < t->n; k++) t->at[k].noise = 1;
    for (size_t k = 1; k < t->n; k++) {
        bool precise = false;
        for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++)
            precise = precise || (!list[i].bridge && !list[i].superseded);
        if (!precise && k + 1 < t->n) continue;
        if (c->eop_known) { // beyond the last node the reference is what errs: pressure that is not ECOM's
            for (size_t j = from; j < k && !precise && c->noise.nx == ORR_NX; j++)
                t->at[j].noise = OPEN_END_OF_REFERENCE;
            from = k;
            continue;
        }
        const double times = (t->at[k].t_s - t->at[from].t_s) / WIDE_GAP_S;
        const double noise = fmax(times * times * times * times, precise ? 1 : OPEN_END);
        for (size_t j = from; j < k; j++) t->at[j].noise = noise;
        from = k;
    }
}

// Instants without nodes, as far apart as STOP_S at most, in the step from grid point g0 to g1.
static void fill(orr_track *t, size_t g0, size_t g1)
{
    const double span = t->grid[g1].t_s - t->grid[g0].t_s;
    const size_t parts = (size_t)fmax(ceil(span / STOP_S - 1e-6), 1);
    size_t last = g0;
    for (size_t k = 1; k < parts; k++) {
        const double want = t->grid[g0].t_s + span * (double)k / (double)parts;
        size_t g = last + 1;
        while (g + 1 < g1 && fabs(t->grid[g + 1].t_s - want) < fabs(t->grid[g].t_s - want)) g++;
        if (g >= g1) break;
        t->at[t->n++] = (orr_instant){.t_s = t->grid[g].t_s, .grid = g};
        last = g;
    }
}

size_t orr_track_window(const orr_track_context *c, double t_s)
{
    size_t w = 0;
    if (c->reference != NULL)
        while (w + 1 < c->reference->n_windows && t_s >= c->reference->border_s[w + 1] - SAME_INSTANT_S) w++;
    return w;
}

static bool usable(const orr_node *n) { return !n->superseded && !n->bridge; }

// Whether from node i on the file is another than that of the node before, at the same instant or a later
// one.
static bool other_file(const orr_node *list, size_t i)
{
    size_t k = i;
    if (!usable(&list[i])) return false;
    while (k > 0 && !usable(&list[k - 1])) k--;
    return k > 0 && list[k - 1].source != list[i].source && list[i].rank > list[k - 1].rank;
}

// The instants of one point of the grid: one, or two where a file ends and the next one begins.
static void stop(const orr_track_context *c, const orr_node *list, size_t first, size_t n, size_t g,
                 orr_track *t)
{
    const double t_s = t->grid[g].t_s;
    size_t split = first;
    while (split < first + n && !other_file(list, split)) split++;
    const bool step = c->noise.nx == ORR_NX && split < first + n;
    if (step && split > first) {
        t->at[t->n++] = (orr_instant){.t_s = t_s, .grid = g, .first = first, .n = split - first};
        n -= split - first;
        first = split;
    }
    t->at[t->n++] = (orr_instant){.t_s = t_s, .grid = g, .first = first, .n = n, .step = step};
}

// Instants at noon, and what is known of the file that the nodes about each instant are of.
static void know_files(const orr_track_context *c, const orr_node *list, orr_track *t)
{
    const int64_t day_ns = ORR_S_PER_DAY * ORR_NS_PER_S;
    const orr_file_noise *file = NULL;
    for (size_t k = 0; k < t->n; k++) {
        orr_instant *at = &t->at[k];
        const orr_time now = orr_sky_origin(c->sky) + orr_track_ns(at->t_s);
        const bool second = k > 0 && at->grid == t->at[k - 1].grid; // two files meet
        at->noon = k > 0 && !second && now - orr_floor_div(now, day_ns) * day_ns == day_ns / 2;
        for (size_t i = at->first; i < at->first + at->n && c->file != NULL; i++)
            if (usable(&list[i])) file = &c->file[list[i].source];
        at->pulse = at->noon && file != NULL && file->noon_step;
        at->shadow = file != NULL ? file->shadow_factor - 1 : 0;
    }
}

orr_status orr_track_init(const orr_track_context *c, double from_s, double to_s, double node_step_s,
                          const orr_node *list, size_t n, orr_track *out)
{
    *out = (orr_track){0};
    const int64_t span_ns = orr_track_ns(to_s) - orr_track_ns(from_s);
    size_t intervals = choose_intervals(span_ns, node_step_s, c->options->grid_s, &out->samples_per_segment);
    out->n_samples = intervals + 1;
    out->step_s = (double)span_ns / (double)intervals * 1e-9;
    size_t i = 0, k = 0, inside = 0;
    while (i < n && list[i].t_s < from_s - SAME_INSTANT_S) i++;
    for (size_t j = i; j < n && list[j].t_s <= to_s + SAME_INSTANT_S; j++) inside++;
    out->grid = malloc((out->n_samples + inside) * sizeof *out->grid);
    const size_t stops = 2 * inside + 4 + (size_t)((to_s - from_s) / (STOP_S / 2));
    out->at = malloc(stops * sizeof *out->at);
    if (out->at == NULL || out->grid == NULL) {
        orr_track_free(out);
        return ORR_E_MEMORY;
    }
    size_t last_stop = 0;
    while (k < out->n_samples || (i < n && list[i].t_s <= to_s + SAME_INSTANT_S)) {
        double sample_s = k < out->n_samples ? from_s + out->step_s * (double)k : HUGE_VAL;
        double node_s = i < n && list[i].t_s <= to_s + SAME_INSTANT_S ? list[i].t_s : HUGE_VAL;
        const size_t g = out->n_grid++;
        orr_grid_point *at = &out->grid[g];
        *at = (orr_grid_point){.t_s = sample_s < node_s ? sample_s : node_s};
        if (fabs(sample_s - node_s) < SAME_INSTANT_S) at->t_s = node_s;
        if (sample_s <= at->t_s + SAME_INSTANT_S) {
            at->sample = true;
            k++;
        }
        const size_t first = i;
        while (i < n && list[i].t_s <= at->t_s + SAME_INSTANT_S) i++;
        const bool end = k == out->n_samples && !(i < n && list[i].t_s <= to_s + SAME_INSTANT_S);
        if (i == first && g > 0 && !end) continue;
        if (g > 0) fill(out, last_stop, g);
        stop(c, list, first, i - first, g, out);
        last_stop = g;
    }
    for (size_t j = 0; j < out->n; j++) {
        out->at[j].window = orr_track_window(c, out->at[j].t_s);
        out->at[j].renew = j > 0 && out->at[j].window != out->at[j - 1].window;
    }
    if (c->noise.nx == ORR_NX) know_files(c, list, out);
    widen_gaps(c, list, out);
    return ORR_OK;
}

orr_mat3 orr_track_axes(const orr_track_context *c, double t_s, orr_vec3 r, orr_vec3 v)
{
    switch (c->options->f0_axes) {
    case ORR_F0_INERTIAL:
        return orr_mat3_identity();
    case ORR_F0_ECEF: {
        orr_sky_point p;
        orr_sky_force_point(c->sky, t_s, &p);
        return orr_mat3_transpose(&p.R);
    }
    case ORR_F0_RTN:
        break;
    }
    return orr_orbit_axes(r, v);
}

void orr_track_use_window(const orr_track_context *c, size_t window, const double *change)
{
    for (int i = 0; i < ORR_ECOM_TERMS && c->reference != NULL; i++)
        c->force->ecom_nmps2[i] = c->reference->ecom_nmps2[window][i] + (change != NULL ? change[i] : 0);
}

// Partial derivatives of a stretch without a kink in the sunlight, from (r, v) to (r1, v1).
static void linearise(const orr_track_context *c, const orr_orbit_step *s, orr_mat3 *middle,
                      double F[6][ORR_NX])
{
    orr_vec3 rm, vm;
    orr_orbit_step_middle(s, &rm, &vm);
    const orr_mat3 B[3] = {orr_track_axes(c, s->t_s, s->r0_m, s->v0_mps),
                           orr_track_axes(c, s->t_s + s->h_s / 2, rm, vm),
                           orr_track_axes(c, s->t_s + s->h_s, s->r1_m, s->v1_mps)};
    orr_variational_step(c->force, c->sky, s, B, F);
    *middle = B[1];
}

// F after G: both of whose lower rows are those of the unit matrix.
static void append(double F[6][ORR_NX], double G[6][ORR_NX])
{
    double product[6][ORR_NX];
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < ORR_NX; k++) product[i][k] = k < 6 ? 0 : G[i][k];
        for (int j = 0; j < 6; j++)
            for (int k = 0; k < ORR_NX; k++) product[i][k] += G[i][j] * F[j][k];
    }
    memcpy(F, product, sizeof product);
}

// The step of h that departs from grid point a: (r, v) moves to its end, past the borders of the shadow one by one.
static orr_status step_on(const orr_track_context *c, const orr_grid_point *a, double h, orr_vec3 *r,
                          orr_vec3 *v, orr_grid_step *out)
{
    double border[ORR_INTEGRATE_BORDERS + 1], from = 0;
    size_t n =
        c->noise.nx == ORR_NX ? orr_integrate_borders(c->integrator, a->t_s, h, a->r_m, a->v_mps, border) : 0;
    border[n++] = h;
    for (size_t k = 0; k < n; from = border[k++]) {
        orr_orbit_step s = {.t_s = a->t_s + from, .h_s = border[k] - from, .r0_m = *r, .v0_mps = *v};
        const orr_status status = orr_integrate(c->integrator, s.t_s, s.h_s, r, v);
        if (status != ORR_OK) return status;
        s.r1_m = *r, s.v1_mps = *v;
        double F[6][ORR_NX];
        orr_mat3 middle;
        linearise(c, &s, &middle, k == 0 ? out->F : F);
        if (k > 0) append(out->F, F);
        if (s.t_s <= a->t_s + h / 2) out->axes = middle;
    }
    return ORR_OK;
}

static const orr_reference *reference_at(const orr_instant *at, const orr_reference *reference)
{
    for (size_t i = at->first; i < at->first + at->n; i++)
        if (reference[i].valid) return &reference[i];
    return NULL;
}

#define SHADOW_MARGIN_S 900.0 // after a satellite leaves the shadow, and before

// Whether the satellite is near the Earth's shadow on the step from g on, by a circle through where it is.
static bool near_shadow(const orr_track_context *c, const orr_grid_point *g)
{
    orr_sky_point p;
    orr_sky_force_point(c->sky, g->t_s, &p);
    const double rate = orr_vec3_norm(g->v_mps) / orr_vec3_norm(g->r_m);
    for (int k = -1; k <= 1; k++) {
        const double turn = k * SHADOW_MARGIN_S * rate;
        const orr_vec3 r = orr_vec3_axpy(sin(turn) / rate, g->v_mps, orr_vec3_scale(cos(turn), g->r_m));
        if (orr_force_sunlight_fast(r, p.sun_m) < 0.5) return true;
    }
    return false;
}

typedef struct orbit_piece { // between two instants h_s apart, u from 0 to 1
    double h_s;
    orr_vec3 r0, v0, a0, r1, v1, a1, even, odd;
} orbit_piece;

// Position and velocity on the polynomial of degree seven: Hermite's quintic through both ends and
// (u (1 - u))^3 (even + odd (u - 1/2)). a (may be NULL): the second derivative of the quintic alone, times h^2.
static void piece_at(const orbit_piece *p, double u, orr_vec3 *r, orr_vec3 *v, orr_vec3 *a)
{
    const double h = p->h_s, u2 = u * u, u3 = u2 * u, q = 1 - u;
    const double s1 = u3 * (10 + u * (-15 + 6 * u)), ds1 = 30 * u2 * q * q, dds1 = 60 * u * q * (1 - 2 * u);
    const double g0 = u - u3 * (6 + u * (-8 + 3 * u)), dg0 = 1 - u2 * (18 + u * (-32 + 15 * u)),
                 ddg0 = -u * (36 + u * (-96 + 60 * u));
    const double g1 = -u3 * (4 + u * (-7 + 3 * u)), dg1 = -u2 * (12 + u * (-28 + 15 * u)),
                 ddg1 = -u * (24 + u * (-84 + 60 * u));
    const double c0 = 0.5 * u2 * q * q * q, dc0 = 0.5 * u * q * q * (2 - 5 * u),
                 ddc0 = q * (1 - 8 * u + 10 * u2);
    const double c1 = 0.5 * u3 * q * q, dc1 = 0.5 * u2 * q * (3 - 5 * u), ddc1 = u * (3 - 12 * u + 10 * u2);
    const double w = u * q, dw = 1 - 2 * u, s = u - 0.5, b = w * w * w, db = 3 * w * w * dw;
    const orr_vec3 way = orr_vec3_sub(p->r1, p->r0);
    if (a != NULL) {
        *a = orr_vec3_scale(dds1, way);
        *a = orr_vec3_axpy(h * ddg0, p->v0, orr_vec3_axpy(h * ddg1, p->v1, *a));
        *a = orr_vec3_axpy(h * h * ddc0, p->a0, orr_vec3_axpy(h * h * ddc1, p->a1, *a));
    }
    *r = orr_vec3_axpy(s1, way, p->r0);
    *r = orr_vec3_axpy(h * g0, p->v0, orr_vec3_axpy(h * g1, p->v1, *r));
    *r = orr_vec3_axpy(h * h * c0, p->a0, orr_vec3_axpy(h * h * c1, p->a1, *r));
    *r = orr_vec3_axpy(b, p->even, orr_vec3_axpy(b * s, p->odd, *r));
    *v = orr_vec3_scale(ds1, way);
    *v = orr_vec3_axpy(h * dg0, p->v0, orr_vec3_axpy(h * dg1, p->v1, *v));
    *v = orr_vec3_axpy(h * h * dc0, p->a0, orr_vec3_axpy(h * h * dc1, p->a1, *v));
    *v = orr_vec3_axpy(db, p->even, orr_vec3_axpy(db * s + b, p->odd, *v));
    *v = orr_vec3_scale(1 / h, *v);
}

static orr_vec3 acceleration(const orr_track_context *c, double t_s, orr_vec3 r, orr_vec3 v)
{
    orr_sky_point p;
    orr_sky_force_point(c->sky, t_s, &p);
    return orr_force_of_state(c->force, &p, r, v);
}

// The piece through both ends that has the force's acceleration at one and two thirds of the way as well, for which the
// quintic is near enough (3 mm over 900 s of a GNSS satellite, which leaves 5 um).
static void make_piece(const orr_track_context *c, double t_s, orbit_piece *p)
{
    p->a0 = acceleration(c, t_s, p->r0, p->v0);
    p->a1 = acceleration(c, t_s + p->h_s, p->r1, p->v1);
    p->even = p->odd = (orr_vec3){0, 0, 0};
    orr_vec3 e[2];
    for (int i = 0; i < 2; i++) {
        const double u = (i + 1) / 3.0;
        orr_vec3 r, v, quintic;
        piece_at(p, u, &r, &v, &quintic);
        const orr_vec3 a = acceleration(c, t_s + u * p->h_s, r, v);
        e[i] = orr_vec3_sub(orr_vec3_scale(p->h_s * p->h_s, a), quintic);
    }
    p->even = orr_vec3_scale(-27.0 / 8, orr_vec3_add(e[0], e[1]));
    p->odd = orr_vec3_scale(81.0 / 20, orr_vec3_sub(e[0], e[1]));
}

// Whether the way from (r, v) on over h_s may be integrated in one step, with a piece to fill it: no kink in the sunlight,
// no more than this of a revolution.
#define PIECE_ANGLE 0.145
static bool smooth_way(const orr_track_context *c, double t_s, double h_s, orr_vec3 r, orr_vec3 v)
{
    double border[ORR_INTEGRATE_BORDERS];
    return h_s * orr_vec3_norm(v) < PIECE_ANGLE * orr_vec3_norm(r) &&
           orr_integrate_borders(c->integrator, t_s, h_s, r, v, border) == 0;
}

// From instant k to the next one: the grid's states and steps; and the transition (NULL: not again).
static orr_status go_on(const orr_track_context *c, orr_track *t, size_t k, orr_vec3 *r, orr_vec3 *v,
                        orr_transition *next)
{
    const orr_instant *at = &t->at[k];
    orr_grid_step *step = t->steps.step + (at->grid - t->steps.first);
    const size_t last = t->at[k + 1].grid;
    const double way_s = t->grid[last].t_s - at->t_s;
    const bool whole = last > at->grid + 1 && smooth_way(c, at->t_s, way_s, *r, *v);
    orbit_piece piece = {.h_s = way_s, .r0 = *r, .v0 = *v};
    orr_integrator_set(c->integrator, c->force, whole ? way_s * (1 + 1e-9) : ORR_INTEGRATE_MAX_STEP_S);
    if (whole) {
        const orr_status s = orr_integrate(c->integrator, at->t_s, way_s, r, v);
        if (s != ORR_OK) return s;
        piece.r1 = *r, piece.v1 = *v;
        make_piece(c, at->t_s, &piece);
        *r = piece.r0, *v = piece.v0;
    }
    if (next != NULL) orr_transition_start(next);
    for (size_t g = at->grid; g < last; g++, step++) {
        orr_grid_point *a = &t->grid[g];
        const double h = t->grid[g + 1].t_s - a->t_s;
        a->r_m = *r, a->v_mps = *v;
        if (whole) {
            if (g + 1 == last)
                *r = piece.r1, *v = piece.v1;
            else
                piece_at(&piece, (t->grid[g + 1].t_s - at->t_s) / way_s, r, v, NULL);
            const orr_orbit_step s = {a->t_s, h, a->r_m, a->v_mps, *r, *v};
            linearise(c, &s, &step->axes, step->F);
        } else {
            const orr_status s = step_on(c, a, h, r, v, step);
            if (s != ORR_OK) return s;
        }
        if (next == NULL) continue;
        a->near_shadow = c->noise.nx == ORR_NX && near_shadow(c, a);
        orr_transition_append(next, step->F, &step->axes, h, at->noise * c->noise.qf_m2ps5, c->noise.qv_m2ps3,
                              a->near_shadow);
    }
    return ORR_OK;
}

// Room for the steps: of all the grid, or of one interval of a long one.
static orr_status room_for_steps(orr_track *t)
{
    size_t most = t->n_grid;
    if (t->steps.step != NULL) return ORR_OK;
    t->steps.all = most <= KEPT_STEPS;
    if (!t->steps.all) most = orr_track_longest(t, 0, t->n - 1);
    t->steps.step = malloc((most + 1) * sizeof *t->steps.step);
    return t->steps.step != NULL ? ORR_OK : ORR_E_MEMORY;
}

size_t orr_track_longest(const orr_track *t, size_t first, size_t last)
{
    size_t most = 1;
    for (size_t k = first; k < last; k++)
        if (t->at[k + 1].grid - t->at[k].grid > most) most = t->at[k + 1].grid - t->at[k].grid;
    return most;
}

static orr_status go_on_and_keep(const orr_track_context *c, orr_track *t, size_t k, orr_vec3 *r, orr_vec3 *v)
{
    orr_transition next;
    if (!t->steps.all) t->steps.first = t->at[k].grid;
    const orr_status s = go_on(c, t, k, r, v, &next);
    if (s == ORR_OK) orr_transition_keep(&next, &t->at[k].next);
    t->steps.n = t->at[k + 1].grid - t->steps.first;
    return s;
}

orr_status orr_track_step(const orr_track_context *c, orr_track *t, size_t g, const orr_grid_step **out)
{
    orr_status s = ORR_OK;
    if (g < t->steps.first || g >= t->steps.first + t->steps.n) {
        size_t k = 0, end = t->n - 1; // at[k].grid <= g < at[end].grid
        while (end - k > 1) {
            const size_t middle = k + (end - k) / 2;
            if (t->at[middle].grid <= g)
                k = middle;
            else
                end = middle;
        }
        orr_vec3 r = t->at[k].r_m, v = t->at[k].v_mps;
        orr_track_use_window(c, t->at[k].window, NULL);
        t->steps.first = t->at[k].grid;
        s = go_on(c, t, k, &r, &v, NULL);
        t->steps.n = t->at[k + 1].grid - t->steps.first;
        orr_integrator_set(c->integrator, c->force, ORR_INTEGRATE_MAX_STEP_S);
    }
    *out = &t->steps.step[g - t->steps.first];
    return s;
}

orr_status orr_track_linearise(const orr_track_context *c, const orr_reference *reference, orr_track *t)
{
    size_t k0 = 0;
    while (k0 < t->n && reference_at(&t->at[k0], reference) == NULL) k0++;
    if (k0 == t->n) return ORR_E_NODATA;
    const orr_status ready = room_for_steps(t);
    if (ready != ORR_OK) return ready;
    const orr_reference *start = reference_at(&t->at[k0], reference);
    orr_vec3 r = start->r_m, v = start->v_mps;
    orr_track_use_window(c, t->at[k0].window, NULL);
    orr_integrator_set(c->integrator, c->force, ORR_INTEGRATE_MAX_STEP_S);
    orr_status s = orr_integrate(c->integrator, t->at[k0].t_s, t->at[0].t_s - t->at[k0].t_s, &r, &v);
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < t->n; k++) {
        orr_instant *at = &t->at[k];
        const orr_reference *restart = reference_at(at, reference);
        memset(at->shift, 0, sizeof at->shift);
        if (restart != NULL && k > 0) {
            orr_vec3 dr = orr_vec3_sub(r, restart->r_m), dv = orr_vec3_sub(v, restart->v_mps);
            memcpy(at->shift, (double[6]){dr.x, dr.y, dr.z, dv.x, dv.y, dv.z}, 6 * sizeof at->shift[0]);
            r = restart->r_m, v = restart->v_mps;
        }
        if (at->renew)
            for (int i = 0; i < ORR_ECOM_TERMS; i++)
                at->shift[ORR_PARTIAL_ECOM + i] = c->reference->ecom_nmps2[t->at[k - 1].window][i] -
                                                  c->reference->ecom_nmps2[at->window][i];
        at->r_m = r, at->v_mps = v;
        t->grid[at->grid].r_m = r, t->grid[at->grid].v_mps = v;
        if (k + 1 == t->n) break;
        orr_track_use_window(c, at->window, NULL);
        s = go_on_and_keep(c, t, k, &r, &v);
        if (s != ORR_OK) return s;
    }
    orr_integrator_set(c->integrator, c->force, ORR_INTEGRATE_MAX_STEP_S);
    return ORR_OK;
}

orr_vec3 orr_track_measured(const orr_track_context *c, const orr_instant *at, const orr_node *n)
{
    orr_sky_point p;
    orr_sky_force_point(c->sky, n->t_s, &p);
    const orr_vec3 r = orr_vec3_axpy(-n->late_s, at->v_mps, orr_mat3_apply_t(&p.R, n->ecef_m));
    return orr_vec3_sub(r, at->r_m);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/reference_fit.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "core/parallel.h"
#include "core/robust.h"
#include "orbit/dynamics/reference_arc.h"

#define MAX_PASSES 8
#define LEAST_NODES 6
#define LEAST_SPAN_S 7200.0
#define LEAST_SATELLITES 4
// What the rotation is known to be before: corrections of the secular pole, their rates, the length of day
// and its change.
#define POLE_MAS 300.0
#define POLE_RATE_MASPD 4.0
#define LOD_MS 2.0
#define LOD_RATE_MSPD 0.03
#define UT1_MS 1e-6         // not visible: it stays
#define NO_BEND_MASPD2 1e-6 // of a forecast: the pole goes straight on
// Where an update is so small the last one is exact when it is added to a linear state: of a state, of the
// rotation.
#define SETTLED_M 0.05
#define SETTLED_MAS 0.02
#define SETTLED_MS 0.002
#define FIT_M 1.0         // an orbit further off its nodes than this is none
#define FIT_REJECTED 0.25 // nor one that so many of its nodes disagree with
#define TELLING 20.0      // times the usual residual: what is worse does not decide when the fit has settled
#define BAND ORR_KNOT_LOCAL

typedef struct share { // of one arc in the normal equations of the rotation
    bool alive;
    double g[ORR_KNOT_LOCAL][ORR_KNOT_LOCAL], h[ORR_KNOT_LOCAL]; // reduced, before the satellite's weight
    double by_knots[ORR_ARC_STATE][ORR_KNOT_LOCAL], x[ORR_ARC_STATE]; // N^-1 C, N^-1 r
    double vv; // squared residuals after the arc's own solution, in units of ORR_ARC_SIGMA_M
    size_t n;  // nodes used
    double rms_m, moved_m;
} share;

typedef struct work {
    const orr_reference_problem *p;
    orr_gravity_field earth;
    orr_sky *sky;
    orr_rotation_knots knots;
    orr_eop_series series;
    share *share;
    size_t most_nodes;
    bool first;
    orr_status *status; // per arc
    double *band;       // [unknowns][diagonals]: the rotation's normal equations (core/linalg.h)
    double *right;
    double *sort;
} work;

static size_t unknowns(const work *w) { return ORR_KNOT_VALUES * w->knots.n; }
// Of the band, the main one among them.
static size_t diagonals(const work *w) { return unknowns(w) < BAND ? unknowns(w) : BAND; }

// --- one pass over the arcs, by threads ---

// The satellite's unknowns are eliminated: N^-1 C and N^-1 r, and what is left for the rotation.
static bool reduce(const orr_arc_equations *e, share *s)
{
    double N[ORR_ARC_STATE][ORR_ARC_STATE], b[ORR_ARC_STATE][ORR_KNOT_LOCAL + 1];
    for (int i = 0; i < ORR_ARC_STATE; i++) {
        memcpy(N[i], e->N[i], sizeof N[i]);
        memcpy(b[i], &e->N[i][ORR_ARC_STATE], ORR_KNOT_LOCAL * sizeof b[i][0]);
        b[i][ORR_KNOT_LOCAL] = e->r[i];
    }
    if (orr_symmetric_solve(&N[0][0], ORR_ARC_STATE, ORR_ARC_STATE, &b[0][0], ORR_KNOT_LOCAL + 1) != ORR_OK)
        return false;
    s->vv = e->ll;
    s->n = e->n;
    for (int i = 0; i < ORR_ARC_STATE; i++) {
        memcpy(s->by_knots[i], b[i], sizeof s->by_knots[i]);
        s->x[i] = b[i][ORR_KNOT_LOCAL];
        s->vv -= s->x[i] * e->r[i];
    }
    for (int a = 0; a < ORR_KNOT_LOCAL; a++) {
        s->h[a] = e->r[ORR_ARC_STATE + a];
        for (int i = 0; i < ORR_ARC_STATE; i++) s->h[a] -= e->N[ORR_ARC_STATE + a][i] * s->x[i];
        for (int c = 0; c < ORR_KNOT_LOCAL; c++) {
            s->g[a][c] = e->N[ORR_ARC_STATE + a][ORR_ARC_STATE + c];
            for (int i = 0; i < ORR_ARC_STATE; i++)
                s->g[a][c] -= e->N[ORR_ARC_STATE + a][i] * s->by_knots[i][c];
        }
    }
    return true;
}

typedef struct pool {
    work *w;
    atomic_size_t next;
} pool;

static void *worker(void *arg)
{
    pool *q = arg;
    work *w = q->w;
    orr_arc_room room;
    const orr_status ready = orr_arc_room_init(w->sky, &w->knots, &w->earth, w->most_nodes, &room, NULL);
    room.now_s = w->p->border_s[1];
    room.forget_s = w->p->forecast ? w->p->forget_s : 0;
    for (size_t i; (i = atomic_fetch_add(&q->next, 1)) < w->p->n_arcs;) {
        orr_reference_arc *arc = &w->p->arc[i];
        share *s = &w->share[i];
        w->status[i] = ready;
        if (w->p->cancel != NULL && *w->p->cancel) w->status[i] = ORR_E_INTERRUPTED;
        if (w->status[i] != ORR_OK) continue;
        if (w->first) {
            s->alive = arc->n >= LEAST_NODES &&
                       arc->node[arc->n - 1].t_s - arc->node[0].t_s >= LEAST_SPAN_S &&
                       orr_arc_start(&room, arc);
        }
        orr_arc_equations e;
        if (s->alive) s->alive = orr_arc_equations_make(&room, arc, &e) == ORR_OK && reduce(&e, s);
    }
    if (ready == ORR_OK) orr_arc_room_free(&room);
    return NULL;
}

static orr_status pass_over_arcs(work *w)
{
    pool q = {.w = w};
    orr_parallel_run(w->p->jobs, worker, &q);
    for (size_t i = 0; i < w->p->n_arcs; i++)
        if (w->status[i] != ORR_OK) return w->status[i];
    return ORR_OK;
}

// --- the rotation's equations ---

// prior: squares of ECOM's distance from what was known before, in units of its sigma; they are in s->vv.
static double rms_of(const share *s, const double *change, double prior)
{
    // Squared residuals after the change of the rotation: v'v = v0'v0 - 2 h'g + g'G g.
    double vv = s->vv - prior;
    for (int a = 0; a < ORR_KNOT_LOCAL && change != NULL; a++) {
        vv -= 2 * change[a] * s->h[a];
        for (int c = 0; c < ORR_KNOT_LOCAL; c++) vv += change[a] * s->g[a][c] * change[c];
    }
    const double freedom = 3.0 * (double)s->n - ORR_ARC_STATE;
    return ORR_ARC_SIGMA_M * sqrt(3 * fmax(vv, 0) / fmax(freedom, 1));
}

static double median_rms(const work *w)
{
    size_t n = 0;
    for (size_t i = 0; i < w->p->n_arcs; i++)
        if (w->share[i].alive) w->sort[n++] = w->share[i].rms_m;
    if (n == 0) return 0;
    return orr_upper_median(w->sort, n);
}

static void add(work *w, size_t i, size_t j, double value)
{
    if (j <= i && i - j < diagonals(w)) w->band[j * diagonals(w) + (i - j)] += value;
}

// Prior on sum of c[k] times the value of kind j at knots first + k being nought (in what it is now plus the
// change).
static void add_prior(work *w, size_t first, const double *c, size_t n, int j, double sigma)
{
    const double p = 1 / (sigma * sigma);
    double now = 0;
    for (size_t a = 0; a < n; a++) now += c[a] * w->knots.value[first + a][j];
    for (size_t a = 0; a < n; a++) {
        const size_t i = ORR_KNOT_VALUES * (first + a) + (size_t)j;
        w->right[i] -= p * c[a] * now;
        for (size_t b = 0; b < n; b++) add(w, i, ORR_KNOT_VALUES * (first + b) + (size_t)j, p * c[a] * c[b]);
    }
}

// Of value, rate and the rate's change.
static void add_polynomial_priors(work *w)
{
    static const double sigma[3][ORR_KNOT_VALUES] = {{POLE_MAS, POLE_MAS, UT1_MS},
                                                     {POLE_RATE_MASPD, POLE_RATE_MASPD, LOD_MS},
                                                     {NO_BEND_MASPD2, NO_BEND_MASPD2, LOD_RATE_MSPD}};
    const double one = 1;
    for (size_t k = 0; k < 3; k++)
        for (int j = 0; j < ORR_KNOT_VALUES; j++) add_prior(w, k, &one, 1, j, sigma[k][j]);
}

static void add_priors(work *w)
{
    if (w->knots.polynomial) {
        add_polynomial_priors(w);
        return;
    }
    const double one = 1, *t = w->knots.t_s;
    add_prior(w, 0, &one, 1, 2, UT1_MS);
    for (size_t k = 0; k < w->knots.n; k++) {
        add_prior(w, k, &one, 1, 0, POLE_MAS);
        add_prior(w, k, &one, 1, 1, POLE_MAS);
        if (k + 1 == w->knots.n) break;
        const double h = (t[k + 1] - t[k]) / ORR_S_PER_DAY, rate[2] = {-1 / h, 1 / h};
        add_prior(w, k, rate, 2, 0, POLE_RATE_MASPD);
        add_prior(w, k, rate, 2, 1, POLE_RATE_MASPD);
        add_prior(w, k, rate, 2, 2, LOD_MS);
        if (k + 2 == w->knots.n) continue;
        const double h1 = (t[k + 2] - t[k + 1]) / ORR_S_PER_DAY, m = (h + h1) / 2;
        const double bend[3] = {1 / h / m, -(1 / h + 1 / h1) / m, 1 / h1 / m};
        add_prior(w, k, bend, 3, 2, LOD_RATE_MSPD);
    }
}

// Unknown of the whole that local unknown a of window `window` is; false if there is no such knot.
static bool global_index(const work *w, size_t window, int a, size_t *index)
{
    const size_t knot = window + (size_t)(a / ORR_KNOT_VALUES);
    if (knot < 1 || knot - 1 >= w->knots.n) return false;
    *index = ORR_KNOT_VALUES * (knot - 1) + (size_t)(a % ORR_KNOT_VALUES);
    return true;
}

static void assemble(work *w)
{
    const double middle = median_rms(w);
    memset(w->band, 0, unknowns(w) * diagonals(w) * sizeof *w->band);
    memset(w->right, 0, unknowns(w) * sizeof *w->right);
    for (size_t n = 0; n < w->p->n_arcs; n++) {
        const share *s = &w->share[n];
        if (!s->alive) continue;
        const double off = fmax(fmax(s->rms_m, middle), 1e-5) / (ORR_ARC_SIGMA_M * sqrt(3.0)),
                     weight = 1 / (off * off);
        for (int a = 0; a < ORR_KNOT_LOCAL; a++) {
            size_t i, j;
            if (!global_index(w, w->p->arc[n].window, a, &i)) continue;
            w->right[i] += weight * s->h[a];
            for (int c = 0; c <= a; c++)
                if (global_index(w, w->p->arc[n].window, c, &j)) add(w, i, j, weight * s->g[a][c]);
        }
    }
    add_priors(w);
}

static void local_change(const work *w, size_t window, const double *change, double local[ORR_KNOT_LOCAL])
{
    for (int a = 0; a < ORR_KNOT_LOCAL; a++) {
        size_t i;
        local[a] = change != NULL && global_index(w, window, a, &i) ? change[i] : 0;
    }
}

// The arcs' own unknowns after a change of the rotation (NULL: none).
static void update_arcs(work *w, const double *change)
{
    for (size_t n = 0; n < w->p->n_arcs; n++) {
        orr_reference_arc *arc = &w->p->arc[n];
        share *s = &w->share[n];
        double local[ORR_KNOT_LOCAL], x[ORR_ARC_STATE];
        if (!s->alive) continue;
        local_change(w, arc->window, change, local);
        for (int i = 0; i < ORR_ARC_STATE; i++) {
            x[i] = s->x[i];
            for (int a = 0; a < ORR_KNOT_LOCAL; a++) x[i] -= s->by_knots[i][a] * local[a];
        }
        const double age = arc->node[arc->n - 1].t_s - arc->node[0].t_s;
        const double *sigma = orr_ecom_sigma_nmps2(arc->r_m, arc->v_mps); // as its equations had it
        arc->r_m = orr_vec3_add(arc->r_m, (orr_vec3){x[0], x[1], x[2]});
        arc->v_mps = orr_vec3_add(arc->v_mps, (orr_vec3){x[3], x[4], x[5]});
        double prior = 0;
        for (int i = 0; i < ORR_ECOM_TERMS; i++) {
            arc->ecom_nmps2[i] += x[6 + i];
            const double off = arc->ecom_nmps2[i] - (i == 0 ? ORR_ECOM_D0_NMPS2 : 0);
            prior += off * off / (sigma[i] * sigma[i]);
        }
        s->rms_m = rms_of(s, local, prior);
        s->moved_m = fmax(orr_vec3_norm((orr_vec3){x[0], x[1], x[2]}),
                          age * orr_vec3_norm((orr_vec3){x[3], x[4], x[5]}));
        arc->rms_m = s->rms_m;
    }
}

// --- passes ---

static size_t satellites(const work *w)
{
    size_t n = 0;
    for (size_t i = 0; i < w->p->n_arcs; i++) {
        bool seen = false;
        for (size_t k = i; k-- > 0 && w->p->arc[k].sat == w->p->arc[i].sat;) seen = seen || w->share[k].alive;
        n += w->share[i].alive && !seen;
    }
    return n;
}

static bool settled(const work *w, const double *change)
{
    const double middle = median_rms(w);
    for (size_t i = 0; i < w->p->n_arcs; i++) {
        const share *s = &w->share[i];
        if (s->alive && s->rms_m < fmax(TELLING * middle, ORR_ARC_SIGMA_M) && s->moved_m > SETTLED_M)
            return false;
    }
    for (size_t i = 0; i < unknowns(w) && change != NULL; i++)
        if (fabs(change[i]) > (i % ORR_KNOT_VALUES == 2 ? SETTLED_MS : SETTLED_MAS)) return false;
    return true;
}

static void turn_sky(work *w)
{
    orr_knot_series(&w->knots, w->p->eop, w->p->leap, &w->series);
    orr_sky_turn(w->sky, &w->series);
}

// Where the rotation is told: in the middle of the span, or where a forecast begins.
static double told_at(const work *w)
{
    return w->knots.polynomial ? w->knots.t_s[1] : 0.5 * w->knots.t_s[w->knots.n - 1];
}

// Formal sigmas there.
static void tell_sigma(work *w, orr_reference_fit *out, double *x)
{
    const double t_s = told_at(w);
    const size_t window = orr_knot_window(&w->knots, t_s), n = unknowns(w);
    double weight[ORR_KNOT_REACH];
    orr_knot_weights(&w->knots, window, t_s, weight);
    double variance[2] = {0};
    for (int kind = 0; kind < 2; kind++) {
        memset(x, 0, n * sizeof *x);
        for (int k = 0; k < ORR_KNOT_REACH; k++) {
            size_t i;
            if (global_index(w, window, ORR_KNOT_VALUES * k + kind, &i)) x[i] = weight[k];
        }
        double *right = w->right; // done with
        memcpy(right, x, n * sizeof *x);
        orr_band_factored(w->band, n, diagonals(w) - 1, x);
        for (size_t i = 0; i < n; i++) variance[kind] += right[i] * x[i];
    }
    out->pole_sigma_rad = sqrt(fmax(variance[0], variance[1])) * ORR_RAD_PER_DEG / 3.6e6;
    const double h = (w->knots.t_s[window + 1] - w->knots.t_s[window]) / ORR_S_PER_DAY;
    memset(x, 0, n * sizeof *x);
    if (w->knots.polynomial) {
        const size_t rate = ORR_KNOT_VALUES + 2;
        x[rate] = 1;
        orr_band_factored(w->band, n, diagonals(w) - 1, x);
        out->lod_sigma_s = 1e-3 * sqrt(fmax(x[rate], 0));
        return;
    }
    const size_t a = ORR_KNOT_VALUES * window + 2, b = a + ORR_KNOT_VALUES;
    x[a] = -1 / h;
    x[b] = 1 / h;
    orr_band_factored(w->band, n, diagonals(w) - 1, x);
    out->lod_sigma_s = 1e-3 * sqrt(fmax((x[b] - x[a]) / h, 0));
}

static void tell_correction(const work *w, orr_reference_fit *out)
{
    double value[ORR_KNOT_VALUES], per_day[ORR_KNOT_VALUES];
    orr_knot_value(&w->knots, told_at(w), value, per_day);
    out->xp_rad = value[0] * ORR_RAD_PER_DEG / 3.6e6;
    out->yp_rad = value[1] * ORR_RAD_PER_DEG / 3.6e6;
    out->lod_s = -1e-3 * per_day[2];
}

static orr_status iterate(work *w, orr_reference_fit *out, double *change)
{
    bool estimate = true;
    for (out->passes = 1;; out->passes++) {
        turn_sky(w);
        orr_status s = pass_over_arcs(w);
        if (s != ORR_OK) return s;
        w->first = false;
        const double *by = NULL;
        if (estimate) {
            out->estimated = satellites(w) >= (w->p->forecast ? 1 : LEAST_SATELLITES);
            for (size_t i = 0; i < w->p->n_arcs; i++) w->share[i].rms_m = rms_of(&w->share[i], NULL, 0);
            assemble(w);
            if (out->estimated && orr_band_factor(w->band, unknowns(w), diagonals(w) - 1) == ORR_OK) {
                memcpy(change, w->right, unknowns(w) * sizeof *change);
                orr_band_factored(w->band, unknowns(w), diagonals(w) - 1, change);
                for (size_t i = 0; i < unknowns(w); i++)
                    w->knots.value[i / ORR_KNOT_VALUES][i % ORR_KNOT_VALUES] += change[i];
                by = change;
            }
        }
        update_arcs(w, by);
        const bool last = out->passes >= MAX_PASSES;
        if (!settled(w, by) && !last) continue;
        if (estimate && out->estimated) {
            tell_correction(w, out);
            tell_sigma(w, out, change);
        }
        if (!estimate || !w->p->hold || last) break;
        estimate = false; // once more with the rotation as it was given
        memset(w->knots.value, 0, w->knots.n * sizeof *w->knots.value);
    }
    return ORR_OK;
}

static void judge(work *w, orr_reference_fit *out)
{
    out->rms_m = median_rms(w);
    for (size_t i = 0; i < w->p->n_arcs; i++) {
        orr_reference_arc *arc = &w->p->arc[i];
        const double limit = FIT_REJECTED * (double)arc->n;
        arc->fitted = w->share[i].alive && arc->rms_m < FIT_M && (double)arc->rejected <= limit &&
                      isfinite(arc->rms_m + orr_vec3_norm(arc->r_m) + orr_vec3_norm(arc->v_mps));
        out->fitted += arc->fitted;
    }
}

static orr_status check(const orr_reference_problem *p, orr_diag *diag)
{
    bool good = p->n_windows >= 1 && p->jobs >= 1 && p->gravity_degree >= 2;
    for (size_t k = 0; k < p->n_windows && good; k++) good = p->border_s[k + 1] > p->border_s[k];
    for (size_t i = 0; i < p->n_arcs && good; i++) good = p->arc[i].window < p->n_windows;
    if (p->forecast) good = good && p->n_windows == 2 && p->forget_s > 0;
    for (size_t i = 0; i < p->n_arcs && good && p->forecast; i++) good = p->arc[i].window == 1;
    return good ? ORR_OK : orr_diag_set(diag, ORR_E_ARG, "windows of a reference fit must ascend");
}

orr_status orr_reference_fit_run(const orr_reference_problem *problem, orr_reference_fit *out, orr_diag *diag)
{
    *out = (orr_reference_fit){0};
    orr_status s = check(problem, diag);
    if (s != ORR_OK) return s;
    work w = {.p = problem,
              .first = true,
              .knots = {.origin = problem->from,
                        .n = problem->n_windows + 1,
                        .t_s = problem->border_s,
                        .polynomial = problem->forecast}};
    for (size_t i = 0; i < problem->n_arcs; i++) {
        if (problem->arc[i].n > w.most_nodes) w.most_nodes = problem->arc[i].n;
        problem->arc[i].fitted = false;
    }
    const size_t n = unknowns(&w), length = orr_knot_series_length(&w.knots);
    w.knots.value = calloc(w.knots.n, sizeof *w.knots.value);
    w.series.mjd_utc = malloc(length * sizeof *w.series.mjd_utc);
    w.series.value = calloc(length, sizeof *w.series.value);
    w.share = calloc(problem->n_arcs + 1, sizeof *w.share);
    w.status = calloc(problem->n_arcs + 1, sizeof *w.status);
    w.sort = malloc((problem->n_arcs + 1) * sizeof *w.sort);
    w.band = malloc(n * diagonals(&w) * sizeof *w.band);
    w.right = malloc(n * sizeof *w.right);
    double *change = malloc(n * sizeof *change);
    if (w.knots.value == NULL || w.series.mjd_utc == NULL || w.series.value == NULL || w.share == NULL ||
        w.status == NULL || w.sort == NULL || w.band == NULL || w.right == NULL || change == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory for a fit of %zu orbits", problem->n_arcs);
    if (s == ORR_OK) s = orr_gravity_field_init(&w.earth, problem->gravity_degree, false, diag);
    if (s == ORR_OK) s = orr_sky_init_precise(problem->from, problem->to, &w.sky, diag);
    if (s == ORR_OK) {
        s = iterate(&w, out, change);
        if (s != ORR_OK) orr_diag_set(diag, s, "reference fit: %s", orr_status_name(s));
    }
    if (s == ORR_OK) {
        turn_sky(&w);
        judge(&w, out);
        out->sky = w.sky;
        out->rotation = w.series;
        w.sky = NULL;
        w.series = (orr_eop_series){0};
    }
    orr_sky_free(w.sky);
    free(w.series.mjd_utc);
    free(w.series.value);
    free(w.knots.value);
    free(w.share);
    free(w.status);
    free(w.sort);
    free(w.band);
    free(w.right);
    free(change);
    return s;
}

void orr_reference_fit_free(orr_reference_fit *f)
{
    orr_sky_free(f->sky);
    free(f->rotation.mjd_utc);
    free(f->rotation.value);
    *f = (orr_reference_fit){0};
}

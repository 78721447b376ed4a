// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/replay.h"

#include <math.h>
#include <stdlib.h>

#include "core/hermite.h"
#include "core/nan.h"

void orr_replay_free(orr_replay *r)
{
    if (r == NULL) return;
    for (size_t k = 0; k < r->n_sats; k++) free(r->sat[k].sight);
    for (size_t k = 0; k < r->n_tracks; k++) {
        free(r->track[k].node);
        free(r->track[k].arc);
    }
    free(r->sat);
    free(r->track);
    free(r->tag);
    free(r->t);
    free(r->clock_s);
    free(r->held_s);
    free(r->flag);
    free(r->steps);
    free(r->dry.node);
    free(r->zenith.node);
    free(r->north.node);
    free(r->east.node);
    free(r->change);
    free(r);
}

const orr_replay_sat *orr_replay_sat_of(const orr_replay *r, orr_sat sat)
{
    for (size_t k = 0; r != NULL && k < r->n_sats; k++)
        if (r->sat[k].sat == sat) return &r->sat[k];
    return NULL;
}

const orr_replay_track *orr_replay_track_of(const orr_replay *r, orr_sat sat, size_t signal)
{
    for (size_t k = 0; r != NULL && k < r->n_tracks; k++)
        if (r->track[k].signal == signal && r->sat[r->track[k].sat].sat == sat) return &r->track[k];
    return NULL;
}

const orr_replay_node *orr_replay_node_of(const orr_replay_track *x, size_t epoch)
{
    size_t low = 0, high = x->n;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (x->node[middle].epoch < epoch)
            low = middle + 1;
        else
            high = middle;
    }
    return low < x->n && x->node[low].epoch == epoch ? &x->node[low] : NULL;
}

// --- Cubics through values at instants ---

// What a curve goes through: n values at instants, and before which of them it breaks.
typedef struct curve {
    const void *of;
    size_t n;
    orr_time (*when)(const void *of, size_t k);
    double (*value)(const void *of, size_t k);
    bool (*breaks)(const void *of, size_t k); // at k it does not join k - 1
} curve;

// The last value at or before t; n where all come later.
static size_t last_before(const curve *c, orr_time t)
{
    size_t low = 0, high = c->n;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (c->when(c->of, middle) <= t)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? low - 1 : c->n;
}

// Slope at k: through its neighbours, or the one that it has.
static double slope_at(const curve *c, size_t k)
{
    const size_t a = k > 0 && !c->breaks(c->of, k) ? k - 1 : k,
                 b = k + 1 < c->n && !c->breaks(c->of, k + 1) ? k + 1 : k;
    if (a == b) return 0;
    return (c->value(c->of, b) - c->value(c->of, a)) / orr_time_diff_s(c->when(c->of, b), c->when(c->of, a));
}

// Value and rate at t on the piece that begins with value k.
static double piece_at(const curve *c, size_t k, orr_time t, double *rate)
{
    const double v = c->value(c->of, k);
    *rate = 0;
    if (k + 1 >= c->n || c->breaks(c->of, k + 1)) return v;
    double p[4];
    const orr_time t0 = c->when(c->of, k);
    orr_hermite_cubic(v, c->value(c->of, k + 1) - v, slope_at(c, k), slope_at(c, k + 1),
                      orr_time_diff_s(c->when(c->of, k + 1), t0), p);
    const double s = orr_time_diff_s(t, t0);
    *rate = orr_cubic_rate(p, s);
    return orr_cubic_at(p, s);
}

// --- Tracks ---

typedef struct track_curve {
    const orr_replay *r;
    const orr_replay_track *x;
} track_curve;

static orr_time node_when(const void *of, size_t k)
{
    const track_curve *c = of;
    return c->r->t[c->x->node[k].epoch];
}
static double node_code(const void *of, size_t k) { return ((const track_curve *)of)->x->node[k].code_m; }
static double node_carrier(const void *of, size_t k)
{
    return ((const track_curve *)of)->x->node[k].carrier_m;
}
static bool code_breaks(const void *of, size_t k) { return ((const track_curve *)of)->x->node[k].begins; }
static bool carrier_breaks(const void *of, size_t k)
{
    const orr_replay_node *n = &((const track_curve *)of)->x->node[k];
    return n->begins || n->arc != n[-1].arc;
}

static bool is_new(const orr_replay_track *x, size_t k)
{
    return k == 0 || x->node[k].begins || x->node[k].arc != x->node[k - 1].arc;
}

bool orr_replay_at(const orr_replay *r, const orr_replay_track *x, orr_time t, orr_time as_of,
                   orr_replay_now *out)
{
    const track_curve of = {r, x};
    curve c = {&of, x->n, node_when, node_code, code_breaks};
    const size_t k = last_before(&c, as_of);
    if (k == x->n) return false;
    const orr_replay_node *n = &x->node[k];
    const bool ends = k + 1 == x->n || n[1].begins;
    if (ends && as_of > r->t[n->epoch]) return false;
    const bool has_arc = n->arc < x->n_arcs;
    *out = (orr_replay_now){.bias_m = has_arc ? x->arc[n->arc].bias_m : 0,
                            .start = has_arc ? x->arc[n->arc].start : 0,
                            .cn0_dbhz = (double)n->cn0_dbhz};
    if (!ends && !isnan(n[1].cn0_dbhz) && !isnan(n->cn0_dbhz))
        out->cn0_dbhz += (double)(n[1].cn0_dbhz - n->cn0_dbhz) * orr_time_diff_s(t, r->t[n->epoch]) /
                         orr_time_diff_s(r->t[n[1].epoch], r->t[n->epoch]);
    if (!r->ready) return true;
    out->code_m = piece_at(&c, k, t, &out->code_mps);
    c.value = node_carrier;
    c.breaks = carrier_breaks;
    out->carrier_m = piece_at(&c, k, t, &out->carrier_mps);
    return true;
}

// --- Content, satellite clock ---

typedef struct content_curve {
    const orr_replay *r;
    const orr_replay_sat *x;
} content_curve;

static orr_time sight_when(const void *of, size_t k)
{
    const content_curve *c = of;
    return c->r->t[c->x->sight[k].epoch];
}
static double sight_value(const void *of, size_t k)
{
    return ((const content_curve *)of)->x->sight[k].more_tecu;
}
static double sight_clock(const void *of, size_t k)
{
    return ((const content_curve *)of)->x->sight[k].clock_m;
}
static bool sight_breaks(const void *of, size_t k) { return ((const content_curve *)of)->x->sight[k].begins; }

void orr_replay_ray_at(const orr_replay *r, const orr_replay_sat *x, orr_time t, orr_time as_of,
                       orr_replay_ray *out)
{
    const content_curve of = {r, x};
    curve c = {&of, x->n, sight_when, sight_value, sight_breaks};
    *out = (orr_replay_ray){.tecu = 0};
    if (x->n == 0) return;
    const size_t k = last_before(&c, as_of);
    if (k == x->n) {
        out->tecu = x->sight[0].more_tecu;
        return;
    }
    out->tecu = piece_at(&c, k, t, &out->tecu_ps);
    c.value = sight_clock;
    out->clock_m = piece_at(&c, k, t, &out->clock_mps);
}

// --- Zenith delay, clock ---

void orr_replay_curve_weights(const orr_replay_curve *x, orr_time t, size_t *first, double w[4])
{
    const size_t n = x->n;
    const int64_t last = (int64_t)n - 2;
    int64_t k = orr_floor_div(t - x->from, x->step_ns);
    k = k < 0 ? 0 : k > last ? last : k;
    const double s = orr_time_diff_s(t, x->from + k * x->step_ns) / ((double)x->step_ns * 1e-9),
                 u = fmin(fmax(s, 0), 1);
    // Cubic through nodes 0 and 1 of -1 to 2; at an end the slope is that of the piece.
    double c[4] = {0, 1 - 3 * u * u + 2 * u * u * u, 3 * u * u - 2 * u * u * u, 0};
    const double h0 = u * (1 - u) * (1 - u), h1 = u * u * (u - 1);
    if (k > 0) {
        c[0] -= h0 / 2;
        c[2] += h0 / 2;
    } else {
        c[1] -= h0;
        c[2] += h0;
    }
    if (k < last) {
        c[1] -= h1 / 2;
        c[3] += h1 / 2;
    } else {
        c[1] -= h1;
        c[2] += h1;
    }
    *first = (size_t)(k > 0 ? k - 1 : 0);
    for (int j = 0; j < 4; j++) w[j] = 0;
    for (int j = 0; j < 4; j++) {
        const int64_t at = k - 1 + j;
        if (at >= 0 && at < (int64_t)n) w[at - (int64_t)*first] += c[j];
    }
}

double orr_replay_curve_at(const orr_replay_curve *x, orr_time t)
{
    size_t first;
    double w[4], sum = 0;
    if (x->n < 2) return 0;
    orr_replay_curve_weights(x, t, &first, w);
    for (size_t j = 0; j < 4 && first + j < x->n; j++) sum += w[j] * x->node[first + j];
    return sum;
}

static orr_time tag_when(const void *of, size_t k) { return ((const orr_replay *)of)->tag[k]; }
static double tag_value(const void *of, size_t k) { return ((const orr_replay *)of)->clock_s[k]; }
static bool tag_breaks(const void *of, size_t k) { return ((const orr_replay *)of)->steps[k]; }

double orr_replay_clock_s(const orr_replay *r, orr_time tag, double *rate, double *held)
{
    const curve c = {r, r->n_epochs, tag_when, tag_value, tag_breaks};
    *rate = *held = 0;
    if (r->n_epochs == 0) return 0;
    const size_t k = last_before(&c, tag);
    if (k == r->n_epochs) return r->clock_s[0];
    *held = r->held_s[k];
    return piece_at(&c, k, tag, rate);
}

// --- Blocks ---

bool orr_replay_change(const orr_replay *r, orr_time after, orr_time until)
{
    size_t low = 0, high = r->n_changes;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (r->change[middle] <= after)
            low = middle + 1;
        else
            high = middle;
    }
    return low < r->n_changes && r->change[low] <= until;
}

bool orr_replay_allow(const orr_replay *r, int64_t length_ns, double error_m)
{
    const double T = (double)length_ns * 1e-9;
    return r->bend_mps2 * T * T / 64 <=
           error_m; // a corner of the second derivative inside a block bends its cubic by so much
}

// Greatest second derivative of a curve at the ends of its pieces.
static double bend_of(const curve *c)
{
    double most = 0;
    for (size_t k = 1; k < c->n; k++) {
        if (c->breaks(c->of, k)) continue;
        double p[4];
        const double T = orr_time_diff_s(c->when(c->of, k), c->when(c->of, k - 1));
        orr_hermite_cubic(0, c->value(c->of, k) - c->value(c->of, k - 1), slope_at(c, k - 1), slope_at(c, k),
                          T, p);
        most = fmax(most, fmax(fabs(2 * p[2]), fabs(2 * p[2] + 6 * p[3] * T)));
    }
    return most;
}

orr_status orr_replay_seal(orr_replay *r, bool residuals, orr_diag *diag)
{
    size_t n = 0;
    for (size_t k = 0; k < r->n_tracks; k++) {
        const orr_replay_track *x = &r->track[k];
        for (size_t j = 0; j < x->n; j++) n += (size_t)is_new(x, j) * 2;
    }
    r->change = calloc(n + 1, sizeof *r->change);
    if (r->change == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    r->bend_mps2 = 0;
    for (size_t k = 0; k < r->n_tracks; k++) {
        const orr_replay_track *x = &r->track[k];
        for (size_t j = 0; j < x->n; j++) {
            if (is_new(x, j)) r->change[r->n_changes++] = r->t[x->node[j].epoch];
            if (j + 1 == x->n || x->node[j + 1].begins)
                r->change[r->n_changes++] = r->t[x->node[j].epoch] + 1; // it is there at its last instant
        }
        const track_curve of = {r, x};
        curve c = {&of, x->n, node_when, node_carrier, carrier_breaks};
        r->bend_mps2 = fmax(r->bend_mps2, 2 * bend_of(&c));
        c.value = node_code;
        c.breaks = code_breaks;
        r->bend_mps2 = fmax(r->bend_mps2, 2 * bend_of(&c) / 100);
    }
    qsort(r->change, r->n_changes, sizeof *r->change, orr_time_order);
    if (!residuals) r->bend_mps2 = 0;
    r->ready = residuals;
    return ORR_OK;
}

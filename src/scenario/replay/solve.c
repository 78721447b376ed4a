// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate: ionosphere-free combinations of each satellite's pair, by least squares. Unknown are the position, zenith delays,
// code delays of systems, an ambiguity an arc, and a clock an epoch, which is eliminated as the epoch is added.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/earth.h"
#include "core/linalg.h"
#include "core/robust.h"
#include "src/scenario/replay/replay_private.h"
#include "src/scenario/troposphere/troposphere.h"

#define PHASE_M                                                                                              \
    0.01 // sigma of an ionosphere-free phase at the zenith: 3 mm of each carrier and the models' own errors
#define CODE_M 1.0         // of a code
#define ZENITH_M 0.3       // of a zenith delay against the model's
#define ZENITH_HOUR_M 0.01 // of what it changes by in an hour
#define DRY_M 0.03         // of the hydrostatic delay: 13 hPa; low satellites tell it from the wet one
#define DRY_HOUR_M 0.003
#define GRADIENT_M 0.002 // of a gradient
#define GRADIENT_HOUR_M 0.0004
#define KNOWN_M 0.01   // of SINEX coordinates
#define HEADER_M 100.0 // of a header's
#define GROUP_M 1e3    // of code delays of systems against the first
#define ACROSS_M 0.3   // of a phase centre across the satellite's axis
#define CORRELATED_S                                                                                         \
    1200.0 // the models' errors are alike for so long: epochs of it count as one against what is known before
#define THIN_S 30.0 // least and most between epochs of the normal equations
#define MOST_THIN_S 300.0
#define SHORT_S 5400.0 // a record in which epochs MOST_THIN_S apart would be too few
#define OUTLIER 5.0    // sigmas of the residuals' own scatter
enum { ROW = 28, ROUNDS = 6, LEAST_SIGHTS = 5, MOST_ARCS = 4000 };

// One observation: value = clock + sum of coefficient times unknown.
typedef struct row {
    size_t n, at[ROW];
    double coefficient[ROW], value, weight;
    orr_replay_sight *sight;
    bool phase;
} row;

typedef struct solver {
    replay_maker *m;
    int64_t thin_ns; // epochs on its multiples enter the normal equations; 0: by `every`
    size_t every;
    bool codes; // alone
    size_t zenith, north, dry, offset, group, arc,
        n; // where unknowns of a kind begin, and how many there are
    int32_t group_of[ORR_SAT_SLOTS];
    int32_t *offset_at;      // [n_sats] first of three unknowns; -1: none
    double alike;            // epochs that count as one
    int32_t *arc_at;         // [m->n_arcs] unknown; -1: none
    double *near_m;          // [m->n_arcs] taken off the phases, so that unknowns are small
    double *N, *x, *touched; // normal equations, right side and solution, coefficients of an epoch's clock
    bool *is_touched;
    size_t *cursor; // [n_sats]
    row *rows;      // of an epoch
    orr_mat3 enu;
    orr_geodetic place;
} solver;

static void solver_close(solver *w)
{
    free(w->arc_at);
    free(w->offset_at);
    free(w->near_m);
    free(w->N);
    free(w->x);
    free(w->touched);
    free(w->is_touched);
    free(w->cursor);
    free(w->rows);
}

double replay_carrier_hz(const orr_replay *r, const orr_replay_track *x)
{
    const orr_sat sat = r->sat[x->sat].sat;
    return orr_signal_carrier_hz(&orr_signals(&(size_t){0})[x->signal],
                                 orr_sat_system(sat) == 'R' ? r->glonass_channel[orr_sat_number(sat) % 100]
                                                            : 0);
}

void replay_free_of_ionosphere(const replay_maker *m, const orr_replay_sat *x, double a[2])
{
    const double f1 = replay_carrier_hz(m->r, &m->r->track[x->pair[0]]),
                 f2 = replay_carrier_hz(m->r, &m->r->track[x->pair[1]]);
    a[0] = f1 * f1 / (f1 * f1 - f2 * f2);
    a[1] = f2 * f2 / (f1 * f1 - f2 * f2);
}

// GPS 0.7 to 1.6 m, GLONASS 1.8 to 2.5, Galileo 0.6 to 1, BeiDou 1 to 3.5, QZSS 2.7 to 4: the IGS' ANTEX files.
double replay_usual_offset_m(char system)
{
    return system == 'R' ? 2.3 : system == 'E' ? 0.85 : system == 'C' ? 2 : system == 'J' ? 3.2 : 1.3;
}

static double offset_sigma_m(char system) { return system == 'E' ? 0.3 : system == 'C' ? 1.2 : 0.6; }

// Both nodes of a sight's pair; false where it has not both.
bool replay_pair_of(const orr_replay *r, const orr_replay_sat *x, const orr_replay_sight *g,
                    const orr_replay_node *out[2])
{
    if (x->pair[0] < 0 || g->at[0] < 0 || g->at[1] < 0) return false;
    for (int i = 0; i < 2; i++) out[i] = &r->track[x->pair[i]].node[g->at[i]];
    return !isnan(out[0]->carrier_m) && !isnan(out[1]->carrier_m);
}

static double phase_of(const replay_maker *m, const orr_replay_sat *x, const orr_replay_node *const n[2])
{
    double a[2];
    replay_free_of_ionosphere(m, x, a);
    return a[0] * n[0]->carrier_m - a[1] * n[1]->carrier_m + ORR_LIGHT_MPS * m->r->held_s[n[0]->epoch];
}

static void put(row *r, size_t at, double coefficient)
{
    r->at[r->n] = at;
    r->coefficient[r->n++] = coefficient;
}

// What the nodes of a curve do, times a factor.
static void put_curve(size_t base, const orr_replay_curve *c, orr_time t, double factor, row *r)
{
    size_t first;
    double weight[4];
    orr_replay_curve_weights(c, t, &first, weight);
    for (size_t k = 0; k < 4 && first + k < c->n; k++)
        if (weight[k] != 0) put(r, base + first + k, factor * weight[k]);
}

// What position and troposphere do to a ray.
static void put_geometry(const solver *w, const orr_troposphere_site *site, size_t sat,
                         const orr_replay_sight *g, orr_time t, row *r)
{
    const double az = (double)g->az_rad, el = (double)g->el_rad;
    const orr_vec3 own = {sin(az) * cos(el), cos(az) * cos(el), sin(el)}, u = orr_mat3_apply_t(&w->enu, own);
    put(r, 0, -u.x);
    put(r, 1, -u.y);
    put(r, 2, -u.z);
    if (w->codes) return;
    for (size_t i = 0; i < 3 && w->offset_at[sat] >= 0; i++)
        put(r, (size_t)w->offset_at[sat] + i, (double)g->body[i]);
    const orr_replay *r0 = w->m->r;
    if (r0->zenith.n < 2) return;
    const orr_gradients unit = {.north_wet_m = 1};
    put_curve(w->zenith, &r0->zenith, t, orr_troposphere_slant(site, az, el).wet_m, r);
    orr_troposphere_site hydrostatic = *site;
    hydrostatic.zenith = (orr_zenith_delay){1, 0};
    put_curve(w->dry, &r0->dry, t, orr_troposphere_slant(&hydrostatic, az, el).hydrostatic_m, r);
    const double tilt = orr_gradients_slant(&unit, 0, fmax(el, 0.05)).wet_m;
    put_curve(w->north, &r0->north, t, tilt * cos(az), r);
    put_curve(w->north + r0->north.n, &r0->east, t, tilt * sin(az), r);
}

double replay_variance_m2(const orr_replay_sight *g)
{
    const double sine = fmax(sin((double)g->el_rad), 0.05);
    return PHASE_M * PHASE_M / (sine * sine);
}

// Whether an epoch enters the normal equations.
static bool enters(const solver *w, size_t e)
{
    const orr_replay *r = w->m->r;
    if (w->codes) return e % w->every == 0;
    const int64_t interval_ns = (int64_t)(r->interval_s * 1e9);
    return orr_floor_mod(r->tag[e] + interval_ns / 2, w->thin_ns) < interval_ns;
}

// Variance of an ionosphere-free phase, m^2: the ray's, and that of the satellite's clock between its nodes.
static double variance_of(const orr_replay_sat *x, const orr_replay_sight *g)
{
    return replay_variance_m2(g) + x->walk_m2ps * (double)g->bridge_s;
}

// Observations of an epoch.
static size_t rows_of(const solver *w, size_t e)
{
    const replay_maker *m = w->m;
    const orr_replay *r = m->r;
    size_t n = 0;
    orr_troposphere_site site = orr_channels_troposphere(m->c, 0, w->place, r->t[e]);
    site.zenith = (orr_zenith_delay){0, 1};
    site.has_gradients = false;
    for (size_t k = 0; k < r->n_sats; k++) {
        const orr_replay_sat *x = &r->sat[k];
        size_t *c = &w->cursor[k];
        while (*c < x->n && x->sight[*c].epoch < e) ++*c;
        if (*c == x->n || x->sight[*c].epoch != e) continue;
        orr_replay_sight *g = &x->sight[*c];
        const orr_replay_node *node[2];
        if (!replay_pair_of(r, x, g, node)) continue;
        double a[2];
        replay_free_of_ionosphere(m, x, a);
        const double sine = fmax(sin((double)g->el_rad), 0.05);
        const int32_t arc = w->codes ? -1 : w->arc_at[g->arc];
        row *out = &w->rows[n];
        if (arc >= 0 && (g->rejected & 1) == 0) {
            *out = (row){.value = phase_of(m, x, node) - w->near_m[g->arc],
                         .weight = 1 / variance_of(x, g),
                         .sight = g,
                         .phase = true};
            put_geometry(w, &site, k, g, r->t[e], out);
            put(out, (size_t)arc, 1);
            out = &w->rows[++n];
        }
        if ((g->rejected & 2) != 0 || isnan(node[0]->code_m) || isnan(node[1]->code_m)) continue;
        *out = (row){.value = a[0] * node[0]->code_m - a[1] * node[1]->code_m,
                     .weight = sine * sine / (9 * CODE_M * CODE_M),
                     .sight = g};
        put_geometry(w, &site, k, g, r->t[e], out);
        put(out, w->group + (size_t)w->group_of[orr_sat_slot(x->sat)], 1);
        n++;
    }
    return n;
}

static void add(solver *w, size_t i, size_t j, double v)
{
    w->N[(i > j ? i : j) * w->n + (i > j ? j : i)] += v;
}

// A pseudo-observation: sum of coefficients times unknowns is `value` within sigma.
static void hold(solver *w, size_t n, const size_t *at, const double *coefficient, double value, double sigma)
{
    const double weight = w->alike / (sigma * sigma);
    for (size_t i = 0; i < n; i++) {
        w->x[at[i]] += weight * coefficient[i] * value;
        for (size_t j = 0; j <= i; j++) add(w, at[i], at[j], weight * coefficient[i] * coefficient[j]);
    }
}

// The observations of an epoch, its clock eliminated.
static void add_epoch(solver *w, size_t n)
{
    double weight = 0, value = 0;
    size_t list[ROW * 64], n_list = 0;
    for (size_t k = 0; k < n; k++) {
        const row *r = &w->rows[k];
        weight += r->weight;
        value += r->weight * r->value;
        for (size_t i = 0; i < r->n; i++) {
            const size_t at = r->at[i];
            if (!w->is_touched[at]) {
                if (n_list == sizeof list / sizeof *list) continue;
                w->is_touched[at] = true;
                list[n_list++] = at;
            }
            w->touched[at] += r->weight * r->coefficient[i];
            w->x[at] += r->weight * r->coefficient[i] * r->value;
            for (size_t j = 0; j <= i; j++)
                add(w, at, r->at[j], r->weight * r->coefficient[i] * r->coefficient[j]);
        }
    }
    for (size_t i = 0; weight > 0 && i < n_list; i++) {
        w->x[list[i]] -= w->touched[list[i]] * value / weight;
        for (size_t j = 0; j <= i; j++)
            add(w, list[i], list[j], -w->touched[list[i]] * w->touched[list[j]] / weight);
    }
    for (size_t i = 0; i < n_list; i++) {
        w->touched[list[i]] = 0;
        w->is_touched[list[i]] = false;
    }
}

// A curve is near zero, and a random walk from node to node.
static void hold_curve(solver *w, size_t base, const orr_replay_curve *c, double sigma, double hour_sigma)
{
    const double one = 1, difference[2] = {-1, 1}, hours = (double)c->step_ns / 3600e9;
    for (size_t k = 0; k < c->n; k++) {
        const size_t at[2] = {base + k, base + k + 1};
        hold(w, 1, at, &one, -c->node[k], sigma);
        if (k + 1 < c->n) hold(w, 2, at, difference, c->node[k] - c->node[k + 1], hour_sigma * sqrt(hours));
    }
}

static void add_priors(solver *w)
{
    const replay_maker *m = w->m;
    const orr_replay *r = m->r;
    const double position_m = !m->s->replay.estimate_position ? 1e-6
                              : w->codes                      ? 1e6
                              : m->known_site                 ? KNOWN_M
                                                              : HEADER_M;
    const double one = 1;
    const orr_vec3 away = orr_vec3_sub(m->prior_m, m->site_m);
    for (size_t k = 0; k < 3; k++)
        hold(w, 1, &k, &one, !w->codes ? (k == 0 ? away.x : k == 1 ? away.y : away.z) : 0, position_m);
    if (!w->codes) {
        hold_curve(w, w->zenith, &r->zenith, ZENITH_M, ZENITH_HOUR_M);
        hold_curve(w, w->dry, &r->dry, DRY_M, DRY_HOUR_M);
        hold_curve(w, w->north, &r->north, GRADIENT_M, GRADIENT_HOUR_M);
        hold_curve(w, w->north + r->north.n, &r->east, GRADIENT_M, GRADIENT_HOUR_M);
    }
    for (size_t s = 0; s < r->n_sats; s++) {
        const orr_replay_sat *x = &r->sat[s];
        if (w->offset_at[s] < 0) continue;
        const char system = orr_sat_system(x->sat);
        const double away_m[3] = {-x->offset_m.x, -x->offset_m.y,
                                  replay_usual_offset_m(system) - x->offset_m.z};
        for (size_t i = 0; i < 3; i++) {
            const size_t at = (size_t)w->offset_at[s] + i;
            hold(w, 1, &at, &one, away_m[i], i < 2 ? ACROSS_M : offset_sigma_m(system));
        }
    }
    for (size_t k = w->group; k < w->arc; k++) hold(w, 1, &k, &one, 0, k == w->group ? 1e-3 : GROUP_M);
    for (size_t k = w->arc; k < w->n; k++) hold(w, 1, &k, &one, 0, 1e3);
}

// Which arcs are unknowns: those of enough sights.
static void choose_arcs(solver *w)
{
    const replay_maker *m = w->m;
    const orr_replay *r = m->r;
    uint32_t *count = calloc(m->n_arcs + 1, sizeof *count);
    for (size_t k = 0; k < m->n_arcs; k++) w->arc_at[k] = -1;
    for (size_t k = 0; count != NULL && !w->codes && k < r->n_sats; k++) {
        const orr_replay_sat *x = &r->sat[k];
        for (size_t j = 0; j < x->n; j++) {
            const orr_replay_sight *g = &x->sight[j];
            const orr_replay_node *node[2];
            if (!enters(w, g->epoch) || (g->rejected & 1) != 0 || !replay_pair_of(r, x, g, node)) continue;
            if (count[g->arc]++ == 0)
                w->near_m[g->arc] = phase_of(m, x, node) - ORR_LIGHT_MPS * r->clock_s[g->epoch];
        }
    }
    for (size_t k = 0; count != NULL && k < m->n_arcs && w->n < w->arc + MOST_ARCS; k++)
        if (count[k] >= LEAST_SIGHTS) w->arc_at[k] = (int32_t)w->n++;
    free(count);
}

// On the multiples of what clocks' nodes are apart they are the product's own; of a short record every epoch counts.
static int64_t thin_ns_of(const replay_maker *m)
{
    const orr_replay *r = m->r;
    const bool is_short = orr_time_diff_s(r->tag[r->n_epochs - 1], r->tag[0]) < SHORT_S;
    const double s = is_short ? THIN_S : fmin(fmax(m->clock_step_s, THIN_S), MOST_THIN_S);
    return (int64_t)(fmax(s, r->interval_s) * 1e9 + 0.5);
}

static orr_status solver_open(replay_maker *m, size_t every, bool codes, solver *w, orr_diag *diag)
{
    const orr_replay *r = m->r;
    *w = (solver){.m = m, .every = every, .codes = codes, .zenith = 3};
    w->place = orr_earth_from_ecef(m->site_m);
    w->enu = orr_earth_enu_from_ecef(w->place.lat_rad, w->place.lon_rad);
    w->north = w->zenith + (codes ? 0 : r->zenith.n);
    w->dry = w->north + (codes ? 0 : r->north.n + r->east.n);
    w->offset = w->dry + (codes ? 0 : r->dry.n);
    w->thin_ns = thin_ns_of(m);
    w->alike = fmax(1, CORRELATED_S / fmax((double)w->thin_ns * 1e-9, r->interval_s));
    w->group = w->offset;
    w->offset_at = malloc((r->n_sats + 1) * sizeof *w->offset_at);
    if (w->offset_at == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < r->n_sats; k++) {
        w->offset_at[k] = !codes && r->sat[k].estimated ? (int32_t)w->group : -1;
        if (w->offset_at[k] >= 0) w->group += 3;
    }
    memset(w->group_of, 0xff, sizeof w->group_of);
    size_t groups = 0;
    int32_t of_system[ORR_N_SYSTEMS];
    memset(of_system, 0xff, sizeof of_system);
    for (size_t k = 0; k < r->n_sats; k++) {
        const orr_sat sat = r->sat[k].sat;
        int32_t *system = &of_system[orr_sat_system_index(sat)];
        if (r->sat[k].pair[0] < 0) continue;
        if (*system < 0 || orr_sat_system(sat) == 'R') *system = (int32_t)groups++;
        w->group_of[orr_sat_slot(sat)] = *system;
    }
    w->arc = w->n = w->group + groups;
    w->arc_at = malloc((m->n_arcs + 1) * sizeof *w->arc_at);
    w->near_m = calloc(m->n_arcs + 1, sizeof *w->near_m);
    if (w->arc_at == NULL || w->near_m == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    choose_arcs(w);
    w->N = calloc(w->n * w->n, sizeof *w->N);
    w->x = calloc(w->n, sizeof *w->x);
    w->touched = calloc(w->n, sizeof *w->touched);
    w->is_touched = calloc(w->n, sizeof *w->is_touched);
    w->cursor = calloc(r->n_sats, sizeof *w->cursor);
    w->rows = calloc(2 * r->n_sats + 1, sizeof *w->rows);
    return w->N != NULL && w->x != NULL && w->touched != NULL && w->is_touched != NULL && w->cursor != NULL &&
                   w->rows != NULL
               ? ORR_OK
               : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static double left_of(const solver *w, const row *r)
{
    double v = r->value;
    for (size_t i = 0; i < r->n; i++) v -= r->coefficient[i] * w->x[r->at[i]];
    return v;
}

// Residuals of a kind with their sights.
typedef struct left_one {
    double value; // by its sigma
    orr_replay_sight *sight;
} left_one;
typedef struct left {
    size_t n;
    left_one *one;
} left;

// Clocks of all epochs, and what is left.
static orr_status look_back(solver *w, left out[2], orr_diag *diag)
{
    orr_replay *r = w->m->r;
    size_t most = 0;
    for (size_t k = 0; k < r->n_sats; k++) most += r->sat[k].n;
    for (int i = 0; i < 2; i++) {
        out[i].n = 0;
        out[i].one = malloc((most + 1) * sizeof *out[i].one);
        if (out[i].one == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    memset(w->cursor, 0, r->n_sats * sizeof *w->cursor);
    for (size_t e = 0; e < r->n_epochs; e++) {
        const size_t n = rows_of(w, e);
        double weight = 0, clock_m = 0;
        for (size_t k = 0; k < n; k++) {
            weight += w->rows[k].weight;
            clock_m += w->rows[k].weight * left_of(w, &w->rows[k]);
        }
        if (weight == 0) continue;
        clock_m /= weight;
        r->clock_s[e] = clock_m / ORR_LIGHT_MPS;
        for (size_t k = 0; k < n; k++) {
            left *to = &out[w->rows[k].phase ? 0 : 1];
            to->one[to->n++] =
                (left_one){(left_of(w, &w->rows[k]) - clock_m) * sqrt(w->rows[k].weight), w->rows[k].sight};
        }
    }
    return ORR_OK;
}

static void free_left(left x[2])
{
    for (int i = 0; i < 2; i++) free(x[i].one);
}

// Marks outliers; how many there are more.
static size_t reject(left *x, uint8_t bit)
{
    size_t found = 0;
    double *size = malloc((x->n + 1) * sizeof *size);
    if (size == NULL || x->n == 0) {
        free(size);
        return 0;
    }
    for (size_t k = 0; k < x->n; k++) size[k] = fabs(x->one[k].value);
    const double most = OUTLIER * ORR_SIGMA_PER_MAD * orr_median(size, x->n);
    for (size_t k = 0; k < x->n; k++)
        if (fabs(x->one[k].value) > most && most > 0) {
            x->one[k].sight->rejected |= bit;
            found++;
        }
    free(size);
    return found;
}

// How clocks walk between their nodes, by the scatter of what is left farther from nodes: its median, and once outliers are gone
// its RMS.
static void find_walks(replay_maker *m, const left *x, bool cleaned)
{
    double *size = malloc((x->n + 1) * sizeof *size);
    for (size_t k = 0; size != NULL && k < m->r->n_sats; k++) {
        orr_replay_sat *sat = &m->r->sat[k];
        double bridge = 0, ray = 0, square = 0;
        size_t n = 0;
        for (size_t i = 0; i < x->n; i++) {
            const orr_replay_sight *g = x->one[i].sight;
            if (g < sat->sight || g >= sat->sight + sat->n || (double)g->bridge_s < m->clock_step_s / 8 ||
                g->bridge_s <= 0 || (double)g->el_rad < 15 * ORR_RAD_PER_DEG)
                continue;
            const double sine = sin((double)g->el_rad);
            size[n++] = fabs(x->one[i].value) * sqrt(variance_of(sat, g));
            square += size[n - 1] * size[n - 1];
            bridge += (double)g->bridge_s;
            ray += PHASE_M * PHASE_M / (sine * sine);
        }
        if (n < 20) continue;
        const double robust = ORR_SIGMA_PER_MAD * orr_median(size, n),
                     scatter = cleaned ? fmax(robust, sqrt(square / (double)n)) : robust;
        sat->walk_m2ps = fmax(0, (scatter * scatter - ray / (double)n) / (bridge / (double)n));
    }
    free(size);
}

static double rms_of(const left *x, double sigma)
{
    double sum = 0;
    for (size_t k = 0; k < x->n; k++) {
        const double sine = fmax(sin((double)x->one[k].sight->el_rad), 0.05),
                     v = x->one[k].value * sigma / sine;
        sum += v * v;
    }
    return x->n > 0 ? sqrt(sum / (double)x->n) : (double)NAN;
}

static orr_status normal(solver *w, orr_diag *diag)
{
    const orr_replay *r = w->m->r;
    size_t used = 0;
    for (size_t e = 0; e < r->n_epochs; e++) {
        const size_t n = enters(w, e) ? rows_of(w, e) : 0;
        used += n;
        if (n > 0) add_epoch(w, n);
    }
    if (used < 4)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "%s: fewer than four satellites were observed on two carriers that the orbits have",
            w->m->s->replay.observations);
    add_priors(w);
    orr_status s = orr_cholesky_factor(w->N, w->n, 1e-15);
    if (s == ORR_OK) s = orr_cholesky_solve(w->N, w->n, w->x);
    return s == ORR_OK ? s
                       : orr_diag_set(diag, s, "%s: the observations do not determine the receiver's clock",
                                      w->m->s->replay.observations);
}

// What is estimated into the maker.
static void keep(const solver *w, const left l[2], orr_vec3 *shift_m)
{
    replay_maker *m = w->m;
    orr_replay_report *report = m->report;
    *shift_m = (orr_vec3){w->x[0], w->x[1], w->x[2]};
    if (w->codes) return;
    orr_replay *r = m->r;
    for (size_t k = 0; k < r->zenith.n; k++) r->zenith.node[k] += w->x[w->zenith + k];
    for (size_t k = 0; k < r->dry.n; k++) r->dry.node[k] += w->x[w->dry + k];
    for (size_t k = 0; k < r->north.n; k++) {
        r->north.node[k] += w->x[w->north + k];
        r->east.node[k] += w->x[w->north + r->north.n + k];
    }
    for (size_t k = 0; k < m->r->n_sats; k++) {
        const int32_t at = w->offset_at[k];
        if (at >= 0)
            m->r->sat[k].offset_m =
                orr_vec3_add(m->r->sat[k].offset_m, (orr_vec3){w->x[at], w->x[at + 1], w->x[at + 2]});
    }
    report->n_arcs = w->n - w->arc;
    report->n_used = l[0].n;
    report->phase_rms_m = rms_of(&l[0], PHASE_M);
    report->code_rms_m = rms_of(&l[1], 3 * CODE_M);
    // Sigmas: the inverse's first columns, by the residuals' own size.
    double size = 0, var[3];
    orr_mat3 cov;
    for (size_t k = 0; k < l[0].n; k++) size += l[0].one[k].value * l[0].one[k].value / (double)l[0].n;
    for (size_t k = 0; k < 3; k++) {
        double *column = calloc(w->n, sizeof *column);
        if (column == NULL) return;
        column[k] = 1;
        (void)orr_cholesky_solve(w->N, w->n, column);
        for (size_t j = 0; j < 3; j++) cov.m[j][k] = column[j] * size * w->alike;
        free(column);
    }
    const orr_mat3 back = orr_mat3_transpose(&w->enu), half = orr_mat3_mul(&cov, &back),
                   enu = orr_mat3_mul(&w->enu, &half);
    for (int k = 0; k < 3; k++) var[k] = sqrt(fmax(enu.m[k][k], 0));
    report->sigma_enu_m = (orr_vec3){var[0], var[1], var[2]};
}

orr_status replay_solve(replay_maker *m, size_t every, bool codes, orr_vec3 *shift_m, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (int round = 0; s == ORR_OK && round < ROUNDS; round++) {
        solver w;
        left l[2] = {{0}, {0}};
        size_t found = 0;
        s = solver_open(m, every, codes, &w, diag);
        if (s == ORR_OK) s = normal(&w, diag);
        if (s == ORR_OK) s = look_back(&w, l, diag);
        if (s == ORR_OK) {
            if (!codes) find_walks(m, &l[0], round > 1);
            if (round > 0 || codes) found = reject(&l[0], 1) + reject(&l[1], 2);
            const bool last = (found == 0 && (round > 1 || codes)) || round == ROUNDS - 1;
            if (last) keep(&w, l, shift_m);
            if (last) round = ROUNDS;
        }
        m->report->n_rejected += found;
        free_left(l);
        solver_close(&w);
    }
    return s;
}

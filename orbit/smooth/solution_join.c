// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/solution_join.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/astro.h"
#include "orbit/smooth/smooth_satellite.h"

#define SHORTEST_S 1800.0 // a stretch to go over in

static int64_t step_of(const orr_orbit_arc *a) { return (int64_t)nearbyint(a->step_s * 1e9); }
static orr_time end_of(const orr_orbit_arc *a) { return a->t0 + (int64_t)(a->n - 1) * step_of(a); }

// Segments of `wished` samples, or of fewer where they would not fill n samples.
static size_t samples_per_segment(size_t n, size_t wished)
{
    size_t k = wished;
    while ((n - 1) % k != 0) k--;
    return k;
}

// Appends samples [first, end) of an arc as an arc of its own.
static bool append_arc(orr_orbit_sat *s, const orr_orbit_arc *from, size_t first, size_t end)
{
    if (end < first + 2) return true; // no stretch
    orr_orbit_arc a = *from;
    a.t0 += (int64_t)first * step_of(from);
    a.n = end - first;
    a.samples_per_segment = samples_per_segment(a.n, from->samples_per_segment);
    a.sample = malloc(a.n * sizeof *a.sample);
    if (a.sample == NULL) return false;
    memcpy(a.sample, from->sample + first, a.n * sizeof *a.sample);
    s->arc[s->n_arcs++] = a; // room for all was made before
    return true;
}

// Appends what an arc has before `t`, or from it on. A sample at `t` belongs to both.
static bool append_before(orr_orbit_sat *s, const orr_orbit_arc *a, orr_time t)
{
    if (t < a->t0) return true;
    const int64_t k = (t - a->t0) / step_of(a) + 1;
    return append_arc(s, a, 0, k < (int64_t)a->n ? (size_t)k : a->n);
}

static bool append_after(orr_orbit_sat *s, const orr_orbit_arc *a, orr_time t)
{
    if (t > end_of(a)) return true;
    const int64_t k = t <= a->t0 ? 0 : (t - a->t0 + step_of(a) - 1) / step_of(a);
    return append_arc(s, a, (size_t)k, a->n);
}

static orr_vec3 mix(orr_vec3 a, orr_vec3 b, double w)
{
    return orr_vec3_add(a, orr_vec3_scale(w, orr_vec3_sub(b, a)));
}

static float mix_sigma(float a, float b, double w)
{
    return (float)hypot((1 - w) * (double)a, w * (double)b);
}

// a + w (b - a) with its derivatives, at the fraction s of a stretch of length_s.
static orr_orbit_sample blend(const orr_orbit_sample *a, const orr_orbit_sample *b, double s, double length_s)
{
    const double w = s * s * s * (10 + s * (6 * s - 15)), dw = 30 * s * s * (1 - s) * (1 - s) / length_s,
                 ddw = 60 * s * (1 - s) * (1 - 2 * s) / (length_s * length_s);
    const orr_vec3 dr = orr_vec3_sub(b->pos_m, a->pos_m), dv = orr_vec3_sub(b->vel_mps, a->vel_mps);
    orr_orbit_sample m = w < 0.5 ? *a : *b;
    m.pos_m = mix(a->pos_m, b->pos_m, w);
    m.vel_mps = orr_vec3_add(mix(a->vel_mps, b->vel_mps, w), orr_vec3_scale(dw, dr));
    m.acc_mps2 = orr_vec3_add(mix(a->acc_mps2, b->acc_mps2, w),
                              orr_vec3_add(orr_vec3_scale(2 * dw, dv), orr_vec3_scale(ddw, dr)));
    m.sigma_m = mix_sigma(a->sigma_m, b->sigma_m, w);
    m.sigma_mps = mix_sigma(a->sigma_mps, b->sigma_mps, w);
    for (int k = 0; k < 3; k++) m.sigma_rtn_m[k] = mix_sigma(a->sigma_rtn_m[k], b->sigma_rtn_m[k], w);
    return m;
}

// Where two arcs can go over from one to the other: false where they have no common lattice, or too little in common.
static bool common_stretch(const orr_orbit_arc *a, const orr_orbit_arc *b, orr_time from, orr_time to,
                           orr_time *begin, orr_time *end)
{
    const int64_t step = step_of(a);
    if (step != step_of(b) || orr_floor_mod(b->t0 - a->t0, step) != 0) return false;
    *begin = from;
    if (*begin < a->t0) *begin = a->t0;
    if (*begin < b->t0) *begin = b->t0;
    *end = to;
    if (*end > end_of(a)) *end = end_of(a);
    if (*end > end_of(b)) *end = end_of(b);
    return orr_time_diff_s(*end, *begin) >= SHORTEST_S;
}

// One arc of two: a to `begin`, b from `end`.
static bool append_joined(orr_orbit_sat *s, const orr_orbit_arc *a, const orr_orbit_arc *b, orr_time begin,
                          orr_time end)
{
    const int64_t step = step_of(a);
    orr_orbit_arc m = *a;
    const int64_t shift = (b->t0 - a->t0) / step; // of b's samples along a's
    m.n = (size_t)((end_of(b) - a->t0) / step + 1);
    m.samples_per_segment = samples_per_segment(m.n, a->samples_per_segment);
    m.sample = malloc(m.n * sizeof *m.sample);
    if (m.sample == NULL) return false;
    for (size_t i = 0; i < m.n; i++) {
        const orr_time t = m.t0 + (int64_t)i * step;
        m.sample[i] = t <= begin ? a->sample[i]
                      : t >= end ? b->sample[(int64_t)i - shift]
                                 : blend(&a->sample[i], &b->sample[(int64_t)i - shift],
                                         orr_time_diff_s(t, begin) / orr_time_diff_s(end, begin),
                                         orr_time_diff_s(end, begin));
    }
    s->arc[s->n_arcs++] = m;
    return true;
}

static const orr_orbit_arc *arc_at(const orr_orbit_sat *s, orr_time t)
{
    for (size_t i = 0; s != NULL && i < s->n_arcs; i++)
        if (s->arc[i].t0 <= t && t <= end_of(&s->arc[i])) return &s->arc[i];
    return NULL;
}

static bool join_arcs(const orr_orbit_sat *a, const orr_orbit_sat *b, orr_time middle, int64_t half_ns,
                      orr_orbit_sat *out)
{
    const orr_orbit_arc *x = arc_at(a, middle), *y = arc_at(b, middle);
    orr_time begin = middle, end = middle;
    const size_t n_a = a != NULL ? a->n_arcs : 0, n_b = b != NULL ? b->n_arcs : 0;
    out->arc = malloc((n_a + n_b + 1) * sizeof *out->arc);
    if (out->arc == NULL) return false;
    const bool over =
        x != NULL && y != NULL && common_stretch(x, y, middle - half_ns, middle + half_ns, &begin, &end);
    bool good = true;
    for (size_t i = 0; good && i < n_a && !(over && &a->arc[i] == x); i++)
        good = append_before(out, &a->arc[i], middle);
    if (good && over) good = append_joined(out, x, y, begin, end);
    for (size_t i = over ? (size_t)(y - b->arc) + 1 : 0; good && i < n_b; i++)
        good = append_after(out, &b->arc[i], middle);
    return good;
}

// The elements of x with their time before `middle`, then those of y from it on. AT tells the member that is the time.
#define JOIN_LISTS(x, y, list, count, AT)                                                                    \
    do {                                                                                                     \
        const size_t n_x = (x) != NULL ? (x)->count : 0, n_y = (y) != NULL ? (y)->count : 0;                 \
        out->list = malloc((n_x + n_y + 1) * sizeof *out->list);                                             \
        if (out->list == NULL) return false;                                                                 \
        for (size_t i = 0; i < n_x; i++)                                                                     \
            if ((x)->list[i].AT < middle) out->list[out->count++] = (x)->list[i];                            \
        for (size_t i = 0; i < n_y; i++)                                                                     \
            if ((y)->list[i].AT >= middle) out->list[out->count++] = (y)->list[i];                           \
    } while (0)

static bool join_satellite(const orr_orbit_sat *a, const orr_orbit_sat *b, orr_time middle, int64_t half_ns,
                           const uint16_t *source_of_b, orr_orbit_sat *out)
{
    const orr_orbit_sat *some = a != NULL ? a : b;
    *out = (orr_orbit_sat){
        .sat = some->sat, .node_noise_m = some->node_noise_m, .clock_noise = some->clock_noise};
    if (!join_arcs(a, b, middle, half_ns, out)) return false;
    JOIN_LISTS(a, b, clock, n_clocks, t);
    JOIN_LISTS(a, b, node, n_nodes, t);
    for (size_t i = 0; i < out->n_nodes; i++)
        if (out->node[i].t >= middle) out->node[i].source = source_of_b[out->node[i].source];
    JOIN_LISTS(a, b, event, n_events, t0);
    return true;
}

static bool join_satellites(const orr_orbit_solution *a, const orr_orbit_solution *b, orr_time middle,
                            int64_t half_ns, const uint16_t *source_of_b, orr_orbit_solution *out)
{
    out->sat = calloc(a->n_sats + b->n_sats + 1, sizeof *out->sat);
    if (out->sat == NULL) return false;
    for (size_t i = 0, k = 0; i < a->n_sats || k < b->n_sats;) {
        const orr_orbit_sat *x = i < a->n_sats ? &a->sat[i] : NULL, *y = k < b->n_sats ? &b->sat[k] : NULL;
        if (x != NULL && y != NULL && x->sat != y->sat) {
            if (x->sat < y->sat)
                y = NULL;
            else
                x = NULL;
        }
        i += x != NULL;
        k += y != NULL;
        if (!join_satellite(x, y, middle, half_ns, source_of_b, &out->sat[out->n_sats++])) return false;
    }
    return true;
}

// Sources of both, each once; *of_b is where b's stand.
static bool join_sources(const orr_orbit_solution *a, const orr_orbit_solution *b, uint16_t **of_b,
                         orr_orbit_solution *out)
{
    out->source = malloc((a->n_sources + b->n_sources + 1) * sizeof *out->source);
    *of_b = malloc((b->n_sources + 1) * sizeof **of_b);
    if (out->source == NULL || *of_b == NULL) return false;
    if (a->n_sources > 0) memcpy(out->source, a->source, a->n_sources * sizeof *a->source);
    out->n_sources = a->n_sources;
    for (size_t i = 0; i < b->n_sources; i++) {
        size_t k = 0;
        while (k < out->n_sources && strcmp(out->source[k].sha256, b->source[i].sha256) != 0) k++;
        if (k == out->n_sources) out->source[out->n_sources++] = b->source[i];
        (*of_b)[i] = (uint16_t)k;
    }
    return true;
}

static bool join_clock_events(const orr_clock_events *a, const orr_clock_events *b, orr_time middle,
                              orr_clock_events *out)
{
    out->item = malloc((a->n + b->n + 1) * sizeof *out->item);
    if (out->item == NULL) return false;
    for (size_t i = 0; i < a->n; i++)
        if (a->item[i].t0 < middle) out->item[out->n++] = a->item[i];
    for (size_t i = 0; i < b->n; i++)
        if (b->item[i].t0 >= middle) out->item[out->n++] = b->item[i];
    return true;
}

static bool join_rotation(const orr_earth_rotation *a, const orr_earth_rotation *b, orr_time middle,
                          orr_earth_rotation *out)
{
    *out = *a;
    out->series = (orr_eop_series){0};
    if (a->series.n == 0 || b->series.n == 0) return orr_eop_series_copy(&a->series, &out->series) == ORR_OK;
    int32_t day;
    double fraction;
    orr_time_mjd(middle, ORR_SCALE_UTC, NULL, &day, &fraction);
    const double mjd = day + fraction, shift = orr_eop_at(&a->series, middle, NULL, NULL).ut1_utc_s -
                                               orr_eop_at(&b->series, middle, NULL, NULL).ut1_utc_s;
    out->series.mjd_utc = malloc((a->series.n + b->series.n) * sizeof *out->series.mjd_utc);
    out->series.value = malloc((a->series.n + b->series.n) * sizeof *out->series.value);
    if (out->series.mjd_utc == NULL || out->series.value == NULL) return false;
    for (size_t i = 0; i < a->series.n && a->series.mjd_utc[i] < mjd; i++) {
        out->series.mjd_utc[out->series.n] = a->series.mjd_utc[i];
        out->series.value[out->series.n++] = a->series.value[i];
    }
    for (size_t i = 0; i < b->series.n; i++) {
        if (b->series.mjd_utc[i] < mjd) continue;
        out->series.mjd_utc[out->series.n] = b->series.mjd_utc[i];
        out->series.value[out->series.n] = b->series.value[i];
        out->series.value[out->series.n++].ut1_utc_s += shift;
    }
    return true;
}

orr_status orr_orbit_solution_join(const orr_orbit_solution *a, const orr_orbit_solution *b, orr_time middle,
                                   double half_s, orr_orbit_solution *out, orr_diag *diag)
{
    uint16_t *source_of_b = NULL;
    *out = (orr_orbit_solution){.node_step_s = fmax(a->node_step_s, b->node_step_s),
                                .clock_max_gap_s = fmax(a->clock_max_gap_s, b->clock_max_gap_s),
                                .from = a->from,
                                .to = b->to};
    memcpy(out->options, a->options, sizeof out->options);
    memcpy(out->frame, a->frame, sizeof out->frame);
    const bool good = join_sources(a, b, &source_of_b, out) &&
                      join_satellites(a, b, middle, (int64_t)(half_s * 1e9), source_of_b, out) &&
                      join_clock_events(&a->clock_events, &b->clock_events, middle, &out->clock_events) &&
                      join_rotation(&a->rotation, &b->rotation, middle, &out->rotation);
    free(source_of_b);
    return good ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory to join two solutions");
}

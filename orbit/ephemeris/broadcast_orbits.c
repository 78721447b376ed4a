// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/ephemeris/broadcast_orbits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/nan.h"
#include "orbit/broadcast/broadcast.h"

#define SAMPLE_S 60
#define SAMPLE_NS (INT64_C(1000000000) * SAMPLE_S)
#define PER_SEGMENT 15 // a quarter of an hour; the product takes less where an orbit needs it
#define CLOCK_S 300
#define CLOCK_NS (INT64_C(1000000000) * CLOCK_S)
#define UNKNOWN_SIGMA_M 3.0
#define GEO_SIGMA_M 1e-3           // exact by decree; files write sigmas as powers, which cannot be 0
#define GEOSTATIONARY_M 42164170.0 // radius on which a sidereal day is a revolution

// Records of one satellite, one for every time of ephemeris, ascending.
typedef struct track {
    orr_sat sat;
    size_t n;
    const orr_nav_eph **record;
} track;

// How far from its time of ephemeris a record is believed: what its system means it for, and as much again where orbits are
// smooth enough; beyond a quarter of an hour SBAS' parabola is off by metres.
static double reach_s(orr_sat sat)
{
    switch (orr_sat_system(sat)) {
    case 'C':
        return 5400;
    case 'R':
        return 1080;
    case 'S':
        return 900;
    default:
        return 7200;
    }
}

static bool joined(const track *k, size_t i)
{
    return orr_time_diff_s(k->record[i + 1]->toe, k->record[i]->toe) <= 2 * reach_s(k->sat);
}

// The state by one record, as the product has it: the clock without periodic relativity.
static bool state_by(const orr_nav_eph *e, orr_time t, orr_broadcast_state *out)
{
    if (orr_broadcast_eval(e, t, out) != ORR_OK) return false;
    if (e->kind == ORR_NAV_GLONASS) out->pos_m = orr_broadcast_pz90_to_itrf(out->pos_m, t);
    if (e->kind != ORR_NAV_KEPLER) out->clock_s -= orr_periodic_relativity_s(out->pos_m, out->vel_mps);
    return isfinite(orr_vec3_norm(out->pos_m) + orr_vec3_norm(out->vel_mps) + orr_vec3_norm(out->acc_mps2) +
                    out->clock_s);
}

// a + w (b - a) with its two derivatives in time, for a weight w with rates w1 and w2.
static void blend(const orr_broadcast_state *b, double w, double w1, double w2, orr_broadcast_state *a)
{
    const orr_vec3 r = orr_vec3_sub(b->pos_m, a->pos_m), v = orr_vec3_sub(b->vel_mps, a->vel_mps),
                   q = orr_vec3_sub(b->acc_mps2, a->acc_mps2);
    a->acc_mps2 = orr_vec3_axpy(w2, r, orr_vec3_axpy(2 * w1, v, orr_vec3_axpy(w, q, a->acc_mps2)));
    a->vel_mps = orr_vec3_axpy(w1, r, orr_vec3_axpy(w, v, a->vel_mps));
    a->pos_m = orr_vec3_axpy(w, r, a->pos_m);
    a->clock_s += w * (b->clock_s - a->clock_s);
}

// The orbit at t of a stretch of records, of which *at is the last at or before t (it moves on).
static bool state_at(const track *k, size_t first, size_t last, orr_time t, size_t *at,
                     orr_broadcast_state *out)
{
    while (*at < last && k->record[*at + 1]->toe <= t) ++*at;
    if (!state_by(k->record[*at], t, out)) return false;
    if (*at == last || (*at == first && t <= k->record[first]->toe)) return true;
    const double h = orr_time_diff_s(k->record[*at + 1]->toe, k->record[*at]->toe),
                 u = orr_time_diff_s(t, k->record[*at]->toe) / h;
    orr_broadcast_state next;
    if (!state_by(k->record[*at + 1], t, &next)) return false;
    // The quintic that goes from 0 to 1 with no slope and no bend at either end.
    const double w = u * u * u * (10 + u * (6 * u - 15)), v = u * (1 - u);
    blend(&next, w, 30 * v * v / h, 60 * v * (1 - 2 * u) / (h * h), out);
    return true;
}

static orr_orbit_sample sample_of(const orr_broadcast_state *s, double sigma_m)
{
    const float axis = (float)(sigma_m / sqrt(3));
    return (orr_orbit_sample){.pos_m = s->pos_m,
                              .vel_mps = s->vel_mps,
                              .acc_mps2 = s->acc_mps2,
                              .sigma_m = (float)sigma_m,
                              .sigma_rtn_m = {axis, axis, axis},
                              .sigma_mps = (float)ORR_NAN};
}

// Whole segments from the first of a lattice of GPS time at or after `from` on.
static orr_status arc_init(orr_time from, orr_time to, orr_orbit_arc *a, orr_diag *diag)
{
    const int64_t step = SAMPLE_NS;
    const orr_time t0 = -orr_floor_div(-from, step) * step;
    const int64_t segments = to > t0 ? (to - t0) / (step * PER_SEGMENT) : 0;
    *a = (orr_orbit_arc){.t0 = t0, .step_s = SAMPLE_S, .samples_per_segment = PER_SEGMENT};
    if (segments == 0) return ORR_OK;
    a->n = (size_t)segments * PER_SEGMENT + 1;
    a->sample = calloc(a->n, sizeof *a->sample);
    return a->sample != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for an orbit of records");
}

static orr_status add_arc(orr_orbit_sat *s, const orr_orbit_arc *a, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(s->arc, s->n_arcs)) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for arcs");
    s->arc[s->n_arcs++] = *a;
    return ORR_OK;
}

static orr_status add_clock(orr_orbit_sat *s, orr_time t, double clock_s, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(s->clock, s->n_clocks))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for clocks");
    s->clock[s->n_clocks++] = (orr_clock_node){.t = t, .clock_s = clock_s};
    return ORR_OK;
}

// Clocks at the arc's samples that lie on their own lattice, and at its ends.
static bool has_clock(const orr_orbit_arc *a, size_t i, orr_time t)
{
    return i == 0 || i + 1 == a->n || t % CLOCK_NS == 0;
}

// Records first..last, each joined to the next, as an arc within [from, to].
static orr_status stretch(const track *k, size_t first, size_t last, orr_time from, orr_time to,
                          orr_orbit_sat *s, orr_diag *diag)
{
    const double reach = reach_s(k->sat);
    const orr_time begin = orr_time_add_s(k->record[first]->toe, -reach),
                   end = orr_time_add_s(k->record[last]->toe, reach);
    orr_orbit_arc a;
    orr_status status = arc_init(begin > from ? begin : from, end < to ? end : to, &a, diag);
    if (status != ORR_OK || a.n == 0) return status;
    size_t at = first, good = 0;
    for (; good < a.n; good++) {
        const orr_time t = orr_time_add_s(a.t0, (double)good * SAMPLE_S);
        orr_broadcast_state b;
        if (!state_at(k, first, last, t, &at, &b)) break;
        const double told = k->record[at]->accuracy_m;
        a.sample[good] = sample_of(&b, told > 0 && told < 1e4 ? told : UNKNOWN_SIGMA_M);
        if (has_clock(&a, good, t)) status = add_clock(s, t, b.clock_s, diag);
        if (status != ORR_OK) break;
    }
    a.n = good > 0 ? (good - 1) / PER_SEGMENT * PER_SEGMENT + 1 : 0; // elements that are no orbit end it
    if (status == ORR_OK && a.n > 1) return add_arc(s, &a, diag);
    free(a.sample);
    return status;
}

static orr_status of_records(const track *k, orr_time from, orr_time to, orr_orbit_sat *s, orr_diag *diag)
{
    orr_status status = ORR_OK;
    for (size_t first = 0; status == ORR_OK && first < k->n;) {
        size_t last = first;
        while (last + 1 < k->n && joined(k, last)) last++;
        status = stretch(k, first, last, from, to, s, diag);
        first = last + 1;
    }
    return status;
}

static orr_status of_longitude(const orr_geostationary *g, orr_time from, orr_time to, orr_orbit_sat *s,
                               orr_diag *diag)
{
    orr_orbit_arc a;
    orr_status status = arc_init(from, to, &a, diag);
    if (status != ORR_OK || a.n == 0) return status;
    const orr_broadcast_state b = {
        .pos_m = {GEOSTATIONARY_M * cos(g->lon_rad), GEOSTATIONARY_M * sin(g->lon_rad), 0}};
    for (size_t i = 0; i < a.n && status == ORR_OK; i++) {
        const orr_time t = orr_time_add_s(a.t0, (double)i * SAMPLE_S);
        a.sample[i] = sample_of(&b, GEO_SIGMA_M);
        if (has_clock(&a, i, t)) status = add_clock(s, t, 0, diag);
    }
    if (status == ORR_OK) return add_arc(s, &a, diag);
    free(a.sample);
    return status;
}

// The records of a satellite by which its orbit goes: of each time of ephemeris the one sent last.
static orr_status track_of(const orr_nav *nav, orr_sat sat, track *k, orr_diag *diag)
{
    orr_broadcast_choice choice = orr_broadcast_choice_default();
    choice.healthy = orr_sat_system(sat) != 'S'; // whose bits forbid a use, not the orbit
    size_t first = 0, count = 0;
    orr_nav_of_sat(nav, sat, &first, &count);
    *k = (track){.sat = sat, .record = calloc(count + 1, sizeof(const orr_nav_eph *))};
    if (k->record == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for records");
    for (size_t i = first; i < first + count; i++) {
        const orr_nav_eph *e = orr_broadcast_select(nav, sat, nav->eph[i].toe, &choice);
        if (e == NULL || e->toe != nav->eph[i].toe) continue;
        if (k->n == 0 || e->toe > k->record[k->n - 1]->toe) k->record[k->n++] = e;
    }
    return ORR_OK;
}

static const orr_geostationary *find_geo(const orr_geostationary *geo, size_t n, orr_sat sat)
{
    for (size_t i = 0; i < n; i++)
        if (geo[i].sat == sat) return &geo[i];
    return NULL;
}

static int by_sat(const void *a, const void *b)
{
    const orr_sat x = ((const orr_orbit_sat *)a)->sat, y = ((const orr_orbit_sat *)b)->sat;
    return (x > y) - (x < y);
}

static void sat_free(orr_orbit_sat *s)
{
    for (size_t i = 0; i < s->n_arcs; i++) free(s->arc[i].sample);
    free(s->arc);
    free(s->clock);
}

// Keeps a satellite that has an arc.
static orr_status keep(orr_orbit_solution *o, orr_orbit_sat *s, bool told, orr_warnings *warnings,
                       orr_diag *diag)
{
    char name[ORR_SAT_TEXT];
    if (s->n_arcs == 0) {
        if (told)
            orr_warnings_add(
                warnings, NULL, 0, 0,
                "%s: its broadcast records do not reach into the span of the orbits; it is not served",
                orr_sat_text(s->sat, name));
        sat_free(s);
        return ORR_OK;
    }
    if (!ORR_ARRAY_GROW(o->sat, o->n_sats)) {
        sat_free(s);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for satellites");
    }
    o->sat[o->n_sats++] = *s;
    return ORR_OK;
}

orr_status orr_broadcast_orbits(const orr_nav *nav, const orr_sat_set *except, const orr_geostationary *geo,
                                size_t n_geo, orr_time from, orr_time to, orr_ephemeris **out,
                                orr_warnings *warnings, orr_diag *diag)
{
    *out = NULL;
    const bool open = from == ORR_TIME_NONE;
    const orr_time first = open ? -ORR_TIME_FAR : from, last = open ? ORR_TIME_FAR : to;
    if (open && nav == NULL)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "longitudes of geostationary satellites tell no span of time");
    orr_orbit_solution o = {.node_step_s = CLOCK_S, .clock_max_gap_s = 2 * CLOCK_S, .frame = "WGS84"};
    snprintf(o.options, sizeof o.options, "broadcast records, blended from one to the next");
    const orr_clock_noise unknown = {ORR_NAN, ORR_NAN, ORR_NAN};
    orr_status s = ORR_OK;
    for (size_t i = 0; nav != NULL && s == ORR_OK && i < nav->n_eph; i++) {
        const orr_sat sat = nav->eph[i].sat;
        if ((i > 0 && sat == nav->eph[i - 1].sat) || (except != NULL && orr_sat_set_has(except, sat)) ||
            find_geo(geo, n_geo, sat) != NULL)
            continue;
        track k;
        orr_orbit_sat x = {.sat = sat, .clock_noise = unknown};
        s = track_of(nav, sat, &k, diag);
        if (s == ORR_OK) s = of_records(&k, first, last, &x, diag);
        free(k.record);
        if (s == ORR_OK)
            s = keep(&o, &x, true, warnings, diag);
        else
            sat_free(&x);
    }
    // Those that stand still are there as long as the others are.
    orr_time begin = open ? ORR_TIME_NONE : from, end = to;
    for (size_t i = 0; open && i < o.n_sats; i++) {
        const orr_orbit_arc *a = o.sat[i].arc, *z = &a[o.sat[i].n_arcs - 1];
        const orr_time stop = orr_time_add_s(z->t0, (double)(z->n - 1) * z->step_s);
        if (begin == ORR_TIME_NONE || a->t0 < begin) begin = a->t0;
        if (i == 0 || stop > end) end = stop;
    }
    for (size_t i = 0; i < n_geo && s == ORR_OK; i++) {
        char name[ORR_SAT_TEXT];
        orr_orbit_sat x = {.sat = geo[i].sat, .clock_noise = unknown};
        if (find_geo(geo, i, geo[i].sat) != NULL)
            s = orr_diag_set(diag, ORR_E_ARG, "%s has two longitudes", orr_sat_text(geo[i].sat, name));
        else if (begin == ORR_TIME_NONE)
            s = orr_diag_set(diag, ORR_E_NODATA, "no record tells a span of time");
        else
            s = of_longitude(&geo[i], begin, end, &x, diag);
        if (s == ORR_OK)
            s = keep(&o, &x, false, warnings, diag);
        else
            sat_free(&x);
    }
    if (o.n_sats > 1) qsort(o.sat, o.n_sats, sizeof *o.sat, by_sat);
    o.from = begin;
    o.to = end;
    if (s == ORR_OK && o.n_sats > 0) s = orr_ephemeris_build(&o, out, diag);
    orr_orbit_solution_free(&o);
    return s;
}

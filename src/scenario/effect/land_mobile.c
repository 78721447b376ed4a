// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/land_mobile.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/constants.h"
#include "core/rng.h"

enum { WAVES = 16, MOST_STRETCHES = 5000000 };
#define GRID_NS (20 * ORR_NS_PER_S / 1000)

// A stretch in one state, until the next begins.
typedef struct stretch {
    orr_time from;
    bool shadow;
    double shadow_db;
} stretch;

typedef struct track {
    const orr_scenario_land_mobile *row; // NULL: none
    uint64_t stream;
    double beat[WAVES],
        phase_rad[WAVES]; // of the waves that come from all around: cosine of the direction, and their phase
    size_t n;
    stretch *stretch;
} track;

struct orr_land_mobile {
    size_t n_rows, n_sats;
    orr_scenario_land_mobile *row;
    track *track; // [n_sats]
};

static void draw_waves(track *t)
{
    for (int j = 0; j < WAVES; j++) {
        uint32_t u[4];
        orr_rng_u32((uint64_t)t->row->seed, t->stream, (uint64_t)j, u);
        t->beat[j] = cos(2 * ORR_PI * (j + u[0] * 0x1p-32) / WAVES);
        t->phase_rad[j] = 2 * ORR_PI * (u[1] * 0x1p-32);
    }
}

// Alternating stretches of exponential length, at whole steps of the grid.
static orr_status make_track(track *t, orr_span span, size_t *spare)
{
    const orr_scenario_land_mobile *o = t->row;
    const uint64_t seed = (uint64_t)o->seed;
    bool shadow = orr_rng_uniform(seed, t->stream, 0) < o->bad_m / (o->good_m + o->bad_m);
    orr_time from = span.from - orr_floor_mod(span.from, GRID_NS);
    for (uint64_t k = 1; from <= span.to; k++) {
        if (*spare == 0) return ORR_E_LIMIT;
        if (!ORR_ARRAY_GROW(t->stretch, t->n)) return ORR_E_MEMORY;
        --*spare;
        t->stretch[t->n++] = (stretch){
            from, shadow, o->shadow_db + o->shadow_sigma_db * orr_rng_normal(seed, t->stream, 2 * k)};
        const double mean_s = (shadow ? o->bad_m : o->good_m) / o->speed_mps,
                     length_s = -log(1 - orr_rng_uniform(seed, t->stream, 2 * k + 1)) * mean_s;
        const int64_t steps = (int64_t)nearbyint(fmin(length_s, 1e8) * 1e9 / (double)GRID_NS);
        from += (steps > 0 ? steps : 1) * GRID_NS;
        shadow = !shadow;
    }
    return ORR_OK;
}

static orr_status make_all(const orr_scenario *s, const orr_sat *sat, size_t n, orr_span span,
                           orr_land_mobile *x)
{
    size_t spare = MOST_STRETCHES;
    x->row = calloc(s->land_mobile.n, sizeof *x->row);
    x->track = calloc(n + 1, sizeof *x->track);
    if (x->row == NULL || x->track == NULL) return ORR_E_MEMORY;
    x->n_sats = n;
    for (; x->n_rows < s->land_mobile.n; x->n_rows++) x->row[x->n_rows] = s->land_mobile.item[x->n_rows];
    for (size_t k = 0; k < n; k++)
        for (size_t j = 0; x->track[k].row == NULL && j < x->n_rows; j++) {
            if (x->row[j].has_sats && !orr_sat_set_has(&x->row[j].sats, sat[k])) continue;
            x->track[k].row = &x->row[j];
            x->track[k].stream = ((uint64_t)j << 32) | sat[k];
            draw_waves(&x->track[k]);
            const orr_status status = make_track(&x->track[k], span, &spare);
            if (status != ORR_OK) return status;
        }
    return ORR_OK;
}

orr_status orr_land_mobile_open(const orr_scenario *s, const orr_sat *sat, size_t n, orr_span span,
                                orr_land_mobile **out, orr_diag *diag)
{
    *out = NULL;
    if (s->land_mobile.n == 0) return ORR_OK;
    orr_land_mobile *x = calloc(1, sizeof *x);
    const orr_status status = x != NULL ? make_all(s, sat, n, span, x) : ORR_E_MEMORY;
    if (status == ORR_OK) {
        *out = x;
        return ORR_OK;
    }
    orr_land_mobile_close(x);
    if (status == ORR_E_LIMIT)
        return orr_marks_blame(
            &s->marks, status, "land_mobile",
            "more than five million changes of state: give it longer stretches, fewer satellites "
            "or a shorter time",
            diag);
    return orr_diag_set(diag, status, "out of memory");
}

void orr_land_mobile_close(orr_land_mobile *x)
{
    if (x == NULL) return;
    for (size_t k = 0; x->track != NULL && k < x->n_sats; k++) free(x->track[k].stretch);
    free(x->track);
    free(x->row);
    free(x);
}

// Place of the stretch that holds t; those before the first are in it.
static size_t find(const track *k, orr_time t)
{
    size_t low = 0, high = k->n;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        *(k->stretch[middle].from <= t ? &low : &high) = middle;
    }
    return low;
}

orr_land_mobile_now orr_land_mobile_at(const orr_land_mobile *x, size_t place, orr_time t, orr_time as_of,
                                       double carrier_hz)
{
    const track *k = &x->track[place];
    orr_land_mobile_now out = {.shadow = false};
    if (k->row == NULL) return out;
    const stretch *now = &k->stretch[find(k, as_of)];
    const double s = (double)t * 1e-9,
                 beat_radps = 2 * ORR_PI * k->row->speed_mps * carrier_hz / ORR_LIGHT_MPS;
    double re = 0, im = 0, re_rate = 0, im_rate = 0;
    for (int j = 0; j < WAVES; j++) {
        const double w = beat_radps * k->beat[j], angle = fmod(w * s, 2 * ORR_PI) + k->phase_rad[j],
                     c = cos(angle), z = sin(angle);
        re += c;
        im += z;
        re_rate -= w * z;
        im_rate += w * c;
    }
    out.shadow = now->shadow;
    const double db = now->shadow ? now->shadow_db : -k->row->rice_db, a = pow(10, db / 20) / sqrt(WAVES);
    re = (now->shadow ? 0 : 1) + a * re;
    im *= a;
    const double power = fmax(re * re + im * im, 1e-12);
    out.power_db = 10 * log10(power);
    out.phase_cycles = atan2(im, re) / (2 * ORR_PI);
    out.phase_rate_hz = a * (re * im_rate - im * re_rate) / power / (2 * ORR_PI);
    return out;
}

bool orr_land_mobile_change(const orr_land_mobile *x, orr_time after, orr_time until)
{
    for (size_t k = 0; x != NULL && k < x->n_sats; k++)
        if (x->track[k].row != NULL && find(&x->track[k], after) != find(&x->track[k], until)) return true;
    return false;
}

int64_t orr_land_mobile_block_ns(const orr_land_mobile *x)
{
    if (x == NULL) return INT64_MAX;
    double fastest_mps = 0;
    for (size_t k = 0; k < x->n_rows; k++) fastest_mps = fmax(fastest_mps, x->row[k].speed_mps);
    const double wave_m = 0.19, part_s = wave_m / fastest_mps / 20; // a twentieth of a beat of L1
    return (int64_t)(fmin(fmax(part_s, 0.001), 0.02) * 1e9);
}

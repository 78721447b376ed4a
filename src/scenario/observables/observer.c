// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/observables/observer.h"

#include <math.h>
#include <stdlib.h>

#include "core/rng.h"
#include "src/scenario/observables/composite.h"

struct orr_observer {
    const orr_channels *c;
    size_t antenna;
    bool noise;
    uint64_t seed;
    const orr_signal *signal;
    orr_channel_work *work;
    orr_channel *channel;             // of one epoch
    orr_observation *item, *previous; // of this epoch and of the one before
    size_t n, n_previous;
};

// Standard deviations of thermal noise: code in metres, phase in cycles.
static void noise_of(const orr_signal *s, double spacing, double cn0_dbhz, double *code_m,
                     double *phase_cycles)
{
    const double cn0 = pow(10, cn0_dbhz / 10), chip_m = ORR_LIGHT_MPS / s->chips_per_s;
    const double delay_hz = 1, phase_hz = 15, integration_s = 0.02;
    *code_m = chip_m * sqrt(delay_hz * spacing / (2 * cn0) * (1 + 2 / ((2 - spacing) * integration_s * cn0)));
    *phase_cycles = sqrt(phase_hz / cn0 * (1 + 1 / (2 * integration_s * cn0))) / (2 * ORR_PI);
}

// The receiver's oscillator at an epoch.
typedef struct oscillator {
    double error_s, rate, held_s; // held: what carriers do not follow
} oscillator;

static orr_observation measure(const orr_observer *o, const orr_channel *x, const orr_composite *m,
                               orr_time t, const oscillator *clock)
{
    const orr_signal *s = &o->signal[x->signal];
    orr_observation y = {.sat = x->sat,
                         .signal = x->signal,
                         .cn0_dbhz = x->power_dbw + m->power_db - ORR_N0_DBWHZ,
                         .carrier_hz = x->carrier_hz,
                         .az_rad = x->az_rad,
                         .el_rad = x->el_rad};
    double code = 0, phase = 0;
    if (o->noise) {
        const uint64_t stream = ((uint64_t)o->antenna << 32) | ((uint64_t)x->sat << 8) | x->signal;
        noise_of(s, orr_channels_spacing(o->c, x->signal), y.cn0_dbhz, &y.code_sigma_m,
                 &y.phase_sigma_cycles);
        code = y.code_sigma_m * orr_rng_normal(o->seed, stream, 2 * (uint64_t)t);
        phase = y.phase_sigma_cycles * orr_rng_normal(o->seed, stream, 2 * (uint64_t)t + 1);
    }
    y.code_m = x->code_m + ORR_LIGHT_MPS * clock->error_s + m->code_m + code;
    y.phase_cycles = (double)x->carrier_cycles + (x->carrier_fraction + m->phase_cycles + phase) +
                     (clock->error_s - clock->held_s) * x->carrier_hz;
    y.doppler_hz = -x->carrier_rate_hz - clock->rate * x->carrier_hz;
    return y;
}

// The same signal at the epoch before, NULL where it was not there; both lists ascend, *from is where the search goes on.
static const orr_observation *before(const orr_observer *o, const orr_observation *y, size_t *from)
{
    for (; *from < o->n_previous; (*from)++) {
        const orr_observation *p = &o->previous[*from];
        if (p->sat == y->sat && p->signal == y->signal) return p;
        if (p->sat > y->sat || (p->sat == y->sat && p->signal > y->signal)) return NULL;
    }
    return NULL;
}

orr_status orr_observer_at(orr_observer *o, orr_time t, orr_observed *out, orr_diag *diag)
{
    size_t n, from = 0;
    char text[ORR_TIME_TEXT];
    oscillator clock;
    orr_observation *swap = o->previous;
    o->previous = o->item, o->item = swap;
    o->n_previous = o->n, o->n = 0;
    clock.error_s = orr_channels_oscillator(o->c, o->antenna, t, &clock.rate);
    clock.held_s = orr_channels_held_s(o->c, t);
    // What the receiver's clock calls t is earlier by its error; within half a nanosecond ranges change by 4e-7 m.
    const orr_answer answer = orr_channels_at(o->c, o->antenna, o->work, orr_time_add_s(t, -clock.error_s),
                                              UINT64_MAX, o->channel, &n);
    if (answer != ORR_ANSWER_OK)
        return orr_diag_set(diag, ORR_E_RANGE,
                            "the channels do not reach to %s, an epoch of the observations",
                            orr_time_text(t, text));
    for (size_t k = 0; k < n;) {
        const orr_channel *x = &o->channel[k];
        orr_composite multipath;
        if (x->echo >= ORR_CHANNEL_SPOOFED) break; // false ones come last, and are not what the loops follow
        k = orr_composite_of(o->c, o->channel, n, k, &multipath);
        orr_observation y = measure(o, x, &multipath, t, &clock);
        const orr_observation *p = before(o, &y, &from);
        y.begins = p == NULL;
        y.since = p == NULL ? t : p->since;
        o->item[o->n++] = y;
    }
    *out = (orr_observed){.t = t, .n = o->n, .item = o->item, .clock_s = clock.error_s};
    return ORR_OK;
}

orr_status orr_observer_open(const orr_channels *c, size_t antenna, bool noise, uint64_t seed,
                             orr_observer **out, orr_diag *diag)
{
    size_t n;
    if (antenna >= orr_channels_antennas(c))
        return orr_diag_set(diag, ORR_E_ARG, "there is no antenna %zu", antenna);
    orr_observer *o = calloc(1, sizeof *o);
    if (o == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    o->c = c, o->antenna = antenna, o->noise = noise, o->seed = seed;
    o->signal = orr_signals(&n);
    const size_t max = orr_channels_max(c);
    const orr_status s = orr_channel_work_open(c, &o->work, diag);
    if (s == ORR_OK) {
        o->channel = calloc(max, sizeof *o->channel);
        o->item = calloc(max, sizeof *o->item);
        o->previous = calloc(max, sizeof *o->previous);
    }
    if (s == ORR_OK && o->channel != NULL && o->item != NULL && o->previous != NULL) {
        *out = o;
        return ORR_OK;
    }
    orr_observer_close(o);
    return s != ORR_OK ? s : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

void orr_observer_close(orr_observer *o)
{
    if (o == NULL) return;
    orr_channel_work_close(o->work);
    free(o->channel);
    free(o->item);
    free(o->previous);
    free(o);
}

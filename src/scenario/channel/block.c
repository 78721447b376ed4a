// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/block.h"

#include <math.h>
#include <string.h>

#include "core/hermite.h"
#include "src/scenario/channel/effects.h"

static void join(const orr_channel *from, const orr_channel *to, double T, orr_block *out)
{
    out->at = *from;
    orr_hermite_cubic(from->code_m, to->code_m - from->code_m, from->code_rate_mps, to->code_rate_mps, T,
                      out->code);
    double rise =
        (double)(to->carrier_cycles - from->carrier_cycles) + (to->carrier_fraction - from->carrier_fraction);
    // Where the sum of scattered rays passes behind zero, its angle begins anew: the phase goes on, its integer is another.
    rise -= nearbyint(rise - (from->carrier_rate_hz + to->carrier_rate_hz) / 2 * T);
    orr_hermite_cubic(from->carrier_fraction, rise, from->carrier_rate_hz, to->carrier_rate_hz, T,
                      out->carrier);
    out->carrier_cycles = from->carrier_cycles;
}

// Length of t's blocks; kept, because deciding costs milliseconds.
static void length_at(const orr_channels *c, size_t antenna, orr_time t, orr_blocks *out)
{
    const orr_time cell = orr_block_cell(t), first = orr_block_cell(c->span.from);
    const size_t k = (size_t)((cell - first) / ORR_BLOCK_CELL_NS);
    channel_cell *kept = &c->cell[antenna * c->n_cells + k];
    if (atomic_load_explicit(&kept->decided, memory_order_acquire) == 0) {
        double error_m;
        int64_t length_ns;
        orr_block_length_of(c, antenna, cell, &length_ns, &error_m);
        atomic_store_explicit(&kept->length_ns, length_ns, memory_order_relaxed);
        atomic_store_explicit(&kept->error_m, error_m, memory_order_relaxed);
        atomic_store_explicit(&kept->decided, 1, memory_order_release);
    }
    out->length_ns = atomic_load_explicit(&kept->length_ns, memory_order_relaxed);
    out->error_m = atomic_load_explicit(&kept->error_m, memory_order_relaxed);
    out->t0 = t - orr_floor_mod(t, out->length_ns);
}

// Channels at the begin of a block: what was the end of the one before, or computed.
static void begin_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                     const orr_antenna_state *at, uint64_t signals)
{
    channel_antenna_work *w = &work->antenna[antenna];
    if (w->end.t != t || w->end.signals != signals || effects_change(c, w->end.as_of, t)) {
        channels_receive(c, antenna, work, t, t, at, signals, NULL, &w->begin);
        return;
    }
    const channel_list was = w->begin;
    w->begin = w->end;
    w->end = was;
}

// The order of lists: by satellite, signal and echo; behind the sky those of each spoofer.
static bool comes_before(const orr_channel *a, const orr_channel *b)
{
    const int of = a->echo / ORR_CHANNEL_SPOOFED, or_of = b->echo / ORR_CHANNEL_SPOOFED;
    if (of != or_of) return of < or_of;
    if (a->sat != b->sat) return a->sat < b->sat;
    return a->signal != b->signal ? a->signal < b->signal : a->echo < b->echo;
}

void blocks_between(const orr_channels *c, size_t antenna, orr_channel_work *work, const blocks_ends *e,
                    uint64_t signals, orr_block *block, size_t *n)
{
    channel_list *begin = &work->antenna[antenna].begin, *end = &work->antenna[antenna].end;
    *n = 0;
    begin_at(c, antenna, work, e->t0, &e->at0, signals);
    memset(work->also, 0, c->n_sats * sizeof *work->also);
    for (size_t k = 0; k < begin->n; k++) work->also[begin->place[k]] = begin->seen[k];
    channels_receive(c, antenna, work, e->t1, e->t0, &e->at1, signals, work->also, end);
    const double T = orr_time_diff_s(e->t1, e->t0);
    for (size_t k = 0, j = 0; k < begin->n; k++) { // both lists ascend, the second may lack some
        const orr_channel *from = &begin->channel[k];
        while (j < end->n && comes_before(&end->channel[j], from)) j++;
        if (j == end->n || !begin->seen[k]) continue;
        if (!comes_before(from, &end->channel[j])) join(from, &end->channel[j], T, &block[(*n)++]);
    }
}

orr_answer orr_blocks_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                         uint64_t signals, orr_blocks *out, orr_block *block, size_t *n)
{
    *n = 0;
    *out = (orr_blocks){.t0 = t};
    if (antenna >= orr_channels_antennas(c)) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(c->span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    length_at(c, antenna, t, out);
    blocks_ends e = {.t0 = out->t0, .t1 = orr_time_add(out->t0, out->length_ns)};
    if (!orr_span_holds(c->span, e.t0) || !orr_span_holds(c->span, e.t1)) return ORR_ANSWER_OUTSIDE_SPAN;
    orr_answer answer = orr_antenna_at(&c->antenna[antenna], e.t0, &e.at0);
    if (answer == ORR_ANSWER_OK) answer = orr_antenna_at(&c->antenna[antenna], e.t1, &e.at1);
    if (answer == ORR_ANSWER_OK) blocks_between(c, antenna, work, &e, signals, block, n);
    return answer;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/block.h"

#include <math.h>
#include <string.h>

#include "src/scenario/channel/channels_private.h"

enum { MOST_SATS = 999 };

// Cubic Hermite over T seconds from its ends: v0 + r0 s + ...; `rise` is the change of value.
static void hermite(double v0, double rise, double r0, double r1, double T, double c[4])
{
    const double slope = rise / T;
    c[0] = v0;
    c[1] = r0;
    c[2] = (3 * slope - 2 * r0 - r1) / T;
    c[3] = (r0 + r1 - 2 * slope) / (T * T);
}

double orr_block_code_m(const orr_block *b, double s)
{
    const double *c = b->code;
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

void orr_block_carrier(const orr_block *b, double s, int64_t *cycles, double *fraction)
{
    const double *c = b->carrier, x = c[0] + s * (c[1] + s * (c[2] + s * c[3])), whole = floor(x);
    *cycles = b->carrier_cycles + (int64_t)whole;
    *fraction = x - whole;
}

static void join(const orr_channel *from, const orr_channel *to, double T, orr_block *out)
{
    out->at = *from;
    hermite(from->code_m, to->code_m - from->code_m, from->code_rate_mps, to->code_rate_mps, T, out->code);
    const double rise =
        (double)(to->carrier_cycles - from->carrier_cycles) + (to->carrier_fraction - from->carrier_fraction);
    hermite(from->carrier_fraction, rise, from->carrier_rate_hz, to->carrier_rate_hz, T, out->carrier);
    out->carrier_cycles = from->carrier_cycles;
}

static size_t place_of(const orr_channels *c, orr_sat sat)
{
    size_t low = 0, high = c->n_sats; // satellites ascend
    while (low < high) {
        const size_t mid = low + (high - low) / 2;
        if (c->satellite[mid].sat < sat)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
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

orr_answer orr_blocks_at(const orr_channels *c, size_t antenna, orr_time t, uint64_t signals,
                         orr_channel *work, orr_blocks *out, orr_block *block, size_t *n)
{
    bool want[MOST_SATS] = {false};
    size_t n_from = 0, n_to = 0;
    *n = 0;
    *out = (orr_blocks){.t0 = t};
    if (antenna >= orr_channels_antennas(c)) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(c->span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    length_at(c, antenna, t, out);
    orr_answer answer = channels_evaluate(c, antenna, out->t0, signals, NULL, work, &n_from);
    if (answer != ORR_ANSWER_OK) return answer;
    for (size_t k = 0; k < n_from; k++) {
        block[k].at = work[k];
        want[place_of(c, work[k].sat)] = true;
    }
    answer = channels_evaluate(c, antenna, orr_time_add(out->t0, out->length_ns), signals, want, work, &n_to);
    if (answer != ORR_ANSWER_OK) return answer;
    const double T = (double)out->length_ns / 1e9;
    for (size_t k = 0, j = 0; k < n_from; k++) { // both lists ascend, the second may lack some
        const orr_channel from = block[k].at;
        while (j < n_to &&
               (work[j].sat < from.sat || (work[j].sat == from.sat && work[j].signal < from.signal)))
            j++;
        if (j == n_to || work[j].sat != from.sat || work[j].signal != from.signal) continue;
        join(&from, &work[j], T, &block[(*n)++]);
    }
    return ORR_ANSWER_OK;
}

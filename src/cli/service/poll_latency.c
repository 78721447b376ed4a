// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_latency.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

#include "core/outfile.h"

#define LEAST_NS 1000.0
#define BINS_OF_AN_OCTAVE 8.0

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * ORR_NS_PER_S + t.tv_nsec;
}

void poll_latency_begin(poll_latency *l) { l->begun_ns = now_ns(); }

void poll_latency_end(poll_latency *l)
{
    const int64_t took = now_ns() - l->begun_ns;
    const double at = BINS_OF_AN_OCTAVE * log2(fmax((double)took, LEAST_NS) / LEAST_NS);
    l->bin[at < POLL_LATENCY_BINS ? (size_t)at : POLL_LATENCY_BINS - 1]++;
    l->n++;
    if (took > l->most_ns) l->most_ns = took;
}

// The middle of a bin by ratio, microseconds.
static double middle_us(size_t k) { return LEAST_NS * 1e-3 * exp2(((double)k + 0.5) / BINS_OF_AN_OCTAVE); }

// The bin below whose end a share of all lies.
static size_t bin_of_share(const poll_latency *l, double share)
{
    uint64_t below = 0;
    size_t k = 0;
    while (k + 1 < POLL_LATENCY_BINS && (double)(below += l->bin[k]) < share * (double)l->n) k++;
    return k;
}

orr_status poll_latency_write(const orr_cli *c, const poll_latency *l, orr_diag *diag)
{
    if (l->path == NULL || l->n == 0) return ORR_OK;
    orr_outfile out;
    orr_status s = orr_outfile_open(l->path, &out, diag);
    if (s != ORR_OK) return s;
    fputs("latency_us,count,share\n", out.stream);
    size_t last = POLL_LATENCY_BINS - 1, first = 0;
    while (first < last && l->bin[first] == 0) first++;
    while (last > first && l->bin[last] == 0) last--;
    for (size_t k = first; k <= last; k++)
        fprintf(out.stream, "%.4g,%llu,%.6g\n", middle_us(k), (unsigned long long)l->bin[k],
                (double)l->bin[k] / (double)l->n);
    s = orr_outfile_commit(&out, diag);
    if (s == ORR_OK)
        orr_cli_say(
            c, "%s: %llu answers, half of them within %.3g us, 99 %% within %.3g us, the last after %.3g us",
            l->path, (unsigned long long)l->n, middle_us(bin_of_share(l, 0.5)),
            middle_us(bin_of_share(l, 0.99)), (double)l->most_ns * 1e-3);
    return s;
}

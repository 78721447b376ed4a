// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/phase/clock_steps.h"

#include <math.h>
#include <stdlib.h>

#include "core/constants.h"

#define MILLISECOND_M (ORR_LIGHT_MPS * 1e-3)
#define NEAR_M 100.0

// What the satellites of an epoch say of it.
typedef struct vote {
    long k;            // milliseconds that most of them name so far
    size_t for_k, all; // how many more name it than another; how many compare two neighbouring epochs
} vote;

// Index of t among the epochs from `from` on; n where it is none of them.
static size_t index_of(const orr_time *epoch, size_t n, size_t from, orr_time t)
{
    while (from < n && epoch[from] < t) from++;
    return from < n && epoch[from] == t ? from : n;
}

// Milliseconds by which range minus phase has moved from sample i - 1 to i; LONG_MIN where it is no whole number.
static bool moved(const orr_clock_series *s, size_t i, long *k)
{
    const double *a = s->value[i - 1], *b = s->value[i];
    double range = b[2] - a[2];
    if (isnan(range)) range = b[3] - a[3];
    double d = range - s->wave_m * (b[0] - a[0]);
    if (!(fabs(d) < 1e4 * MILLISECOND_M)) return false;
    *k = lround(d / MILLISECOND_M);
    return fabs(d - (double)*k * MILLISECOND_M) < NEAR_M;
}

static void count(const orr_clock_series *s, const orr_time *epoch, size_t n, vote *votes)
{
    for (size_t i = 1, e = 0; i < s->n; i++) {
        long k;
        size_t before = index_of(epoch, n, e, s->t[i - 1]);
        if (before >= n) continue;
        e = before;
        if (before + 1 >= n || epoch[before + 1] != s->t[i] || !moved(s, i, &k)) continue;
        vote *v = &votes[before + 1];
        v->all++;
        // Majority by pairing off (Boyer and Moore): a k that most name is the one that is left.
        if (v->for_k == 0) {
            v->k = k;
            v->for_k = 1;
        } else
            v->for_k += v->k == k ? 1 : (size_t)-1;
    }
}

static void take_out(const orr_clock_series *s, const orr_time *epoch, size_t n, const vote *votes)
{
    long sum = 0;
    size_t e = 0;
    for (size_t i = 0; i < s->n; i++) {
        for (; e < n && epoch[e] <= s->t[i]; e++) sum += votes[e].k;
        for (int r = 2; r < 4; r++) s->value[i][r] -= (double)sum * MILLISECOND_M;
    }
}

orr_status orr_clock_steps_undo(const orr_clock_series *sat, size_t n_sats, const orr_time *epoch, size_t n,
                                size_t *steps, orr_diag *diag)
{
    *steps = 0;
    vote *votes = calloc(n + 1, sizeof *votes);
    if (votes == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory to look for steps of the receiver's clock");
    for (size_t s = 0; s < n_sats; s++) count(&sat[s], epoch, n, votes);
    // A majority: more than half name it. One satellite alone could be a fault of its own.
    for (size_t e = 0; e < n; e++) {
        if (votes[e].all < 2 || votes[e].for_k * 2 < votes[e].all) votes[e].k = 0;
        *steps += votes[e].k != 0;
    }
    if (*steps > 0)
        for (size_t s = 0; s < n_sats; s++) take_out(&sat[s], epoch, n, votes);
    free(votes);
    return ORR_OK;
}

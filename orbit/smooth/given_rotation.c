// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/given_rotation.h"

#include <math.h>
#include <stdio.h>

#define SERIES_GAP_DAYS 3.0 // as orr_eop_at has it
#define FAR_DAYS 30.0

static orr_time time_of(const orr_eop_series *eop, size_t i)
{
    const double day = floor(eop->mjd_utc[i]);
    return orr_time_from_mjd((int32_t)day, eop->mjd_utc[i] - day, ORR_SCALE_UTC, NULL);
}

// Days from t to the nearest entry.
static double apart(const orr_eop_series *eop, orr_time t)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < eop->n; i++)
        least = fmin(least, fabs(orr_time_diff_s(t, time_of(eop, i))) / ORR_S_PER_DAY);
    return least;
}

orr_given_rotation orr_given_rotation_of(const orr_eop_series *eop, orr_time from, orr_time to, char *text,
                                         size_t n)
{
    const orr_time first = time_of(eop, 0), last = time_of(eop, eop->n - 1);
    orr_time gap[2] = {0, 0}; // the longest that the span meets
    double longest = SERIES_GAP_DAYS + 1e-6;
    for (size_t i = 0; i + 1 < eop->n; i++) {
        const orr_time a = time_of(eop, i), b = time_of(eop, i + 1);
        if (!(eop->mjd_utc[i + 1] - eop->mjd_utc[i] > longest) || a >= to || b <= from) continue;
        longest = eop->mjd_utc[i + 1] - eop->mjd_utc[i];
        gap[0] = a, gap[1] = b;
    }
    const bool in_gap = gap[1] > gap[0];
    char t[4][ORR_TIME_TEXT];
    snprintf(text, n, "the Earth rotation given %s %s to %s, and the positions are of %s to %s",
             in_gap ? "has no values from" : "is of", orr_time_text(in_gap ? gap[0] : first, t[0]),
             orr_time_text(in_gap ? gap[1] : last, t[1]), orr_time_text(from, t[2]), orr_time_text(to, t[3]));
    if (!in_gap && first <= from && to <= last) return ORR_GIVEN_COVERS;
    return fmax(apart(eop, from), apart(eop, to)) > FAR_DAYS ? ORR_GIVEN_SAYS_NOTHING : ORR_GIVEN_CARRIED_ON;
}

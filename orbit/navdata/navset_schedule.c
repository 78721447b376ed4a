// SPDX-License-Identifier: GPL-3.0-or-later
// When sets of immediate data change.
#include <stdlib.h>

#include "core/time.h"
#include "orbit/navdata/navset_private.h"

#define LNAV_STEP_S 7200    // a new set every two hours, as GPS does (IS-GPS-200N 20.3.4.4)
#define GLONASS_STEP_S 1800 // P1 = 01: tb changes every 30 minutes (GLONASS ICD 5.1, 4.4)

// Issue of the n-th two-hour slot since 1980: IODC = IODE, 0 to 239, as a fit interval of four hours demands
// (IS-GPS-200N table 20-XII). IODC's upper two bits stay 0, though the message may count with them: receivers
// that compare all ten bits with IODE keep no set in which they differ (gnss-sdr 0.0.17). No value returns
// within 20 days; 20.3.3.3.1.5 and 20.3.4.4 ask for 7 days of IODC and 6 hours of IODE.
static int32_t issue_of(int64_t n) { return (int32_t)(n % 240); }

orr_status navset_schedule_gps(orr_time from, orr_time to, double window_s, navset_schedule *out)
{
    const int64_t step = LNAV_STEP_S * ORR_NS_PER_S, half = (int64_t)(window_s / 2) * ORR_NS_PER_S;
    int64_t first = orr_floor_div(from + half, step), last = orr_floor_div(to + half, step);
    *out = (navset_schedule){.slot = calloc((size_t)(last - first + 1), sizeof *out->slot)};
    if (out->slot == NULL) return ORR_E_MEMORY;
    for (int64_t n = first; n <= last; n++) {
        orr_time toe = n * step;
        out->slot[out->n++] = (navset_slot){.from = toe - half,
                                            .to = toe - half + step,
                                            .reference = toe,
                                            .window_from = toe - half,
                                            .window_to = toe + half,
                                            .iodc = issue_of(n)};
    }
    return ORR_OK;
}

// Begin of the k-th half hour of a UTC day (k = 48 is the next day's first).
static orr_time half_hour(int32_t mjd, int k, const orr_leap_table *leap)
{
    return orr_time_from_mjd(mjd + k / 48, (k % 48) / 48.0, ORR_SCALE_UTC, leap);
}

orr_status navset_schedule_glonass(orr_time from, orr_time to, const orr_leap_table *leap,
                                   navset_schedule *out)
{
    int32_t first, last;
    double fraction;
    orr_time_mjd(from, ORR_SCALE_UTC, leap, &first, &fraction);
    orr_time_mjd(to, ORR_SCALE_UTC, leap, &last, &fraction);
    *out = (navset_schedule){.slot = calloc((size_t)(last - first + 1) * 48, sizeof *out->slot)};
    if (out->slot == NULL) return ORR_E_MEMORY;
    const int64_t half = GLONASS_STEP_S / 2 * ORR_NS_PER_S;
    for (int32_t mjd = first; mjd <= last; mjd++)
        for (int k = 0; k < 48; k++) {
            navset_slot slot = {
                .from = half_hour(mjd, k, leap), .to = half_hour(mjd, k + 1, leap), .iodc = ORR_NAV_NO_IOD};
            slot.reference = slot.from + half;
            slot.window_from = slot.reference - half;
            slot.window_to = slot.reference + half;
            if (slot.to > from && slot.from <= to) out->slot[out->n++] = slot;
        }
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// When sets of immediate data change, and what each of them describes.
#include <stdlib.h>

#include "core/time.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/navdata/system_week.h"

#define GLONASS_STEP_S 1800 // P1 = 01: tb changes every 30 minutes (GLONASS ICD 5.1, 4.4)

// toe = phase_s + n step_s of the system's time, on the air from toe - lead_s for step_s, describing toe +- half_s.
typedef struct rhythm {
    char system; // '*': any
    uint8_t message;
    int step_s, phase_s, lead_s, half_s;
} rhythm;

// GPS: a new set every two hours, with toe in the middle of its curve fit (IS-GPS-200N 20.3.4.4, 30.3.4.4: CNAV 3 h).
// Galileo: a receiver expects toe to be past or near; sets change hourly here (on the air from every ten minutes to three hours).
// BeiDou and QZSS: every hour. NavIC: every two. SBAS: every four minutes, of the six that a receiver may use them (DO-229E table A-25),
// with t0 on a multiple of 16 s.
static const rhythm rhythms[] = {
    {'G', ORR_NAV_LNAV, 7200, 0, 3600, 3600},    {'G', ORR_NAV_CNAV, 7200, 5400, 5400, 5400},
    {'G', ORR_NAV_CNV2, 7200, 5400, 5400, 5400}, {'J', ORR_NAV_LNAV, 3600, 0, 1800, 3600},
    {'J', ORR_NAV_CNAV, 3600, 0, 1800, 3600},    {'J', ORR_NAV_CNV2, 3600, 0, 1800, 3600},
    {'E', ORR_NAV_INAV, 3600, 1800, 1800, 3600}, {'E', ORR_NAV_FNAV, 3600, 1800, 1800, 3600},
    {'C', ORR_NAV_D1, 3600, 0, 1800, 3600},      {'C', ORR_NAV_D2, 3600, 0, 1800, 3600},
    {'C', ORR_NAV_CNV1, 3600, 0, 1800, 3600},    {'C', ORR_NAV_CNV2, 3600, 0, 1800, 3600},
    {'C', ORR_NAV_CNV3, 3600, 0, 1800, 3600},    {'I', ORR_NAV_LNAV, 7200, 0, 3600, 3600},
    {'S', ORR_NAV_SBAS, 240, 0, 120, 150},
};

static orr_status even_slots(const rhythm *r, int64_t behind, orr_time from, orr_time to,
                             navset_schedule *out)
{
    const int64_t step = r->step_s * ORR_NS_PER_S, half = r->half_s * ORR_NS_PER_S;
    const int64_t begin = behind + (r->phase_s - r->lead_s) * ORR_NS_PER_S; // of slot 0
    const int64_t first = orr_floor_div(from - begin, step), last = orr_floor_div(to - begin, step);
    *out = (navset_schedule){.slot = calloc((size_t)(last - first + 1), sizeof *out->slot)};
    if (out->slot == NULL) return ORR_E_MEMORY;
    for (int64_t n = first; n <= last; n++) {
        const orr_time toe = n * step + behind + r->phase_s * ORR_NS_PER_S;
        out->slot[out->n++] = (navset_slot){.from = begin + n * step,
                                            .to = begin + (n + 1) * step,
                                            .reference = toe,
                                            .window_from = toe - half,
                                            .window_to = toe + half,
                                            .number = n};
    }
    return ORR_OK;
}

// Begin of the k-th half hour of a UTC day (k = 48 is the next day's first).
static orr_time half_hour(int32_t mjd, int k, const orr_leap_table *leap)
{
    return orr_time_from_mjd(mjd + k / 48, (k % 48) / 48.0, ORR_SCALE_UTC, leap);
}

static orr_status half_hours(orr_time from, orr_time to, const orr_leap_table *leap, navset_schedule *out)
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
            navset_slot slot = {.from = half_hour(mjd, k, leap), .to = half_hour(mjd, k + 1, leap)};
            slot.reference = slot.from + half;
            slot.window_from = slot.reference - half;
            slot.window_to = slot.reference + half;
            if (slot.to > from && slot.from <= to) out->slot[out->n++] = slot;
        }
    return ORR_OK;
}

orr_status navset_schedule_of(orr_sat sat, orr_nav_message message, orr_time from, orr_time to,
                              const orr_navset_options *o, bool brief, navset_schedule *out)
{
    const char system = orr_sat_system(sat);
    if (system == 'R') return half_hours(from, to, o->leap, out);
    for (size_t k = 0; k < sizeof rhythms / sizeof *rhythms; k++) {
        rhythm r = rhythms[k];
        if (r.system != system || r.message != message) continue;
        if (o->window_s > 7200 && (system == 'E' || (system == 'G' && message == ORR_NAV_LNAV))) {
            r.half_s = (int)(o->window_s / 2);
            if (system == 'G') r.lead_s = r.half_s;
        }
        if (brief) r.half_s = r.step_s / 2;
        return even_slots(&r, system == 'C' ? ORR_BDT_BEHIND_GPS_NS : 0, from, to, out);
    }
    *out = (navset_schedule){0};
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The Sun in ecef at any instant of a span, from a table: the attitude of satellites needs it at every epoch.
#ifndef ORR_SCENARIO_CHANNEL_SUN_TRACK_H
#define ORR_SCENARIO_CHANNEL_SUN_TRACK_H

#include "core/astro.h"
#include "core/status.h"
#include "core/time.h"
#include "core/vec.h"

typedef struct orr_sun_track {
    orr_time from;
    size_t n;
    orr_vec3 *sun_m; // every hour, in axes that turn back with the mean Earth from `from` on
} orr_sun_track;

// Tables orr_attitude_sun over a span.
// Given:
//   from, to  the span
//   eop       Earth's rotation of the product; NULL: the secular pole
// Returned:
//   out       the table; free with orr_sun_track_free
//   diag      ORR_E_MEMORY
orr_status orr_sun_track_open(orr_time from, orr_time to, const orr_eop_series *eop, orr_sun_track *out,
                              orr_diag *diag);
void orr_sun_track_free(orr_sun_track *s); // leaves *s empty
// The Sun at t, ecef, m: within 1e-7 of its distance of orr_attitude_sun.
orr_vec3 orr_sun_track_at(const orr_sun_track *s, orr_time t);

#endif

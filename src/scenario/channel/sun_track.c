// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/sun_track.h"

#include <math.h>
#include <stdlib.h>

#include "orbit/spacecraft/attitude.h"

static const int64_t STEP_NS = 3600 * ORR_NS_PER_S;

// Turns with the mean Earth from s->from to t.
static orr_mat3 earth_turn(const orr_sun_track *s, orr_time t)
{
    return orr_mat3_rot3(ORR_EARTH_RATE_RADPS * orr_time_diff_s(t, s->from));
}

orr_status orr_sun_track_open(orr_time from, orr_time to, const orr_eop_series *eop, orr_sun_track *out,
                              orr_diag *diag)
{
    *out = (orr_sun_track){.from = from, .n = (size_t)((to - from) / STEP_NS) + 2};
    out->sun_m = calloc(out->n, sizeof *out->sun_m);
    if (out->sun_m == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < out->n; k++) {
        const orr_time t = orr_time_add(from, (int64_t)k * STEP_NS);
        const orr_mat3 R = earth_turn(out, t);
        out->sun_m[k] = orr_mat3_apply_t(&R, orr_attitude_sun(t, eop));
    }
    return ORR_OK;
}

void orr_sun_track_free(orr_sun_track *s)
{
    free(s->sun_m);
    *s = (orr_sun_track){.from = 0};
}

orr_vec3 orr_sun_track_at(const orr_sun_track *s, orr_time t)
{
    const int64_t dt = t > s->from ? t - s->from : 0;
    size_t k = (size_t)(dt / STEP_NS);
    if (k > s->n - 2) k = s->n - 2;
    const double part = (double)(dt - (int64_t)k * STEP_NS) / (double)STEP_NS;
    const orr_vec3 a = s->sun_m[k], b = s->sun_m[k + 1];
    const orr_mat3 R = earth_turn(s, t);
    return orr_mat3_apply(&R, orr_vec3_axpy(part, orr_vec3_sub(b, a), a));
}

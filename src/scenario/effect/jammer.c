// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/jammer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/angle.h"
#include "core/constants.h"
#include "src/scenario/effect/mover.h"

typedef struct transmitter {
    char waveform[ORR_JAMMER_WAVEFORM + 1];
    bool has_from, has_to;
    orr_time from, to;
    double carrier_hz, power_dbw;
    orr_mover place;
} transmitter;

struct orr_jammers {
    size_t n;
    transmitter item[ORR_MAX_JAMMERS];
};

orr_status orr_jammers_open(const orr_scenario *s, orr_jammers **out, orr_diag *diag)
{
    *out = NULL;
    if (s->jammers.n == 0) return ORR_OK;
    orr_jammers *j = calloc(1, sizeof *j);
    if (j == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (; j->n < s->jammers.n; j->n++) {
        const orr_scenario_jammer *x = &s->jammers.item[j->n];
        transmitter *k = &j->item[j->n];
        *k = (transmitter){.has_from = x->has_from,
                           .has_to = x->has_to,
                           .from = x->from,
                           .to = x->to,
                           .carrier_hz = x->carrier_hz,
                           .power_dbw = x->power_dbw,
                           .place = orr_mover_of(&x->position, &x->velocity_mps, x->has_from ? x->from : 0)};
        snprintf(k->waveform, sizeof k->waveform, "%s", x->waveform);
    }
    *out = j;
    return ORR_OK;
}

void orr_jammers_close(orr_jammers *j) { free(j); }

size_t orr_jammers_at(const orr_jammers *j, const orr_antenna_state *at, orr_time t,
                      orr_jammer out[ORR_MAX_JAMMERS])
{
    size_t n = 0;
    for (size_t k = 0; j != NULL && k < j->n; k++) {
        const transmitter *x = &j->item[k];
        if ((x->has_from && t < x->from) || (x->has_to && t >= x->to)) continue;
        const orr_vec3 d = orr_vec3_sub(orr_mover_at(&x->place, t), at->r_m),
                       own = orr_mat3_apply(&at->enu, d);
        const double range = fmax(orr_vec3_norm(d), 1), // nearer than a metre it is no point
            rate = orr_vec3_dot(d, orr_vec3_sub(x->place.v_mps, at->v_mps)) / range,
                     az = orr_atan2(own.x, own.y);
        out[n++] = (orr_jammer){.number = (uint16_t)k,
                                .waveform = x->waveform,
                                .az_rad = az < 0 ? az + 2 * ORR_PI : az,
                                .el_rad = orr_atan2(own.z, sqrt(own.x * own.x + own.y * own.y)),
                                .range_m = range,
                                .range_rate_mps = rate,
                                .carrier_hz = x->carrier_hz,
                                .doppler_hz = -rate * x->carrier_hz / ORR_LIGHT_MPS,
                                .power_dbw = x->power_dbw -
                                             20 * log10(4 * ORR_PI * range * x->carrier_hz / ORR_LIGHT_MPS)};
    }
    return n;
}

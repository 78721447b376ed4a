// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/observables/composite.h"

#include <math.h>

#include "src/scenario/observables/correlator.h"

size_t orr_composite_of(const orr_channels *c, const orr_channel *channel, size_t n, size_t k,
                        orr_composite *out)
{
    const orr_channel *x = &channel[k];
    const orr_signal *s = &orr_signals(&(size_t){0})[x->signal];
    orr_correlator_ray ray[1 + ORR_MAX_ECHOES] = {{.amplitude = 1}};
    size_t next = k + 1, rays = 1;
    double gain;
    for (; next < n && channel[next].echo > 0 && channel[next].echo < ORR_CHANNEL_SPOOFED; next++) {
        const orr_channel *y = &channel[next];
        ray[rays++] = (orr_correlator_ray){.amplitude = pow(10, (y->power_dbw - x->power_dbw) / 20),
                                           .delay_m = y->code_m - x->code_m,
                                           .phase_cycles = (double)(y->carrier_cycles - x->carrier_cycles) +
                                                           (y->carrier_fraction - x->carrier_fraction)};
    }
    orr_correlator(s, orr_channels_spacing(c, x->signal), ray, rays, &out->code_m, &out->phase_cycles, &gain);
    out->power_db = 20 * log10(gain);
    return next;
}

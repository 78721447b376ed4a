// SPDX-License-Identifier: GPL-3.0-or-later
// A GPS almanac evaluated as a receiver does (IS-GPS-200N 20.3.3.5.2.1).
#ifndef ORR_TESTS_ALMANAC_RECEIVER_H
#define ORR_TESTS_ALMANAC_RECEIVER_H

#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/kepler_model.h"

// Position (ecef, m) and clock (s) at t of an almanac whose toa is an instant; either may be NULL.
static inline orr_status almanac_receive(const orr_almanac *a, orr_time toa, orr_time t, orr_vec3 *pos,
                                         double *clock_s)
{
    const double tk = orr_time_diff_s(t, toa);
    if (!(a->sqrt_a_sqrtm > 2500 && a->sqrt_a_sqrtm < 3e4) || !(a->e >= 0 && a->e < 0.9))
        return ORR_E_NUMERIC;
    const orr_nav_kepler k = {.sqrt_a_sqrtm = a->sqrt_a_sqrtm,
                              .e = a->e,
                              .i0_rad = 0.30 * ORR_PI + a->i_offset_rad,
                              .omega_dot_radps = a->omega_dot_radps,
                              .omega0_rad = a->omega0_rad,
                              .omega_rad = a->omega_rad,
                              .m0_rad = a->m0_rad,
                              .toe_sow_s = a->toa_s};
    const orr_kepler_axes axes = orr_kepler_axes_of(orr_sat_make('G', 1), ORR_NAV_LNAV);
    if (pos != NULL) *pos = orr_kepler_position(&axes, &k, tk, NULL);
    if (clock_s != NULL) *clock_s = a->af0_s + a->af1_sps * tk;
    return ORR_OK;
}

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/astro.h"
#include "orbit/broadcast.h"
#include "orbit/navfit.h"

#define P2(n) (1.0 / (double)(UINT64_C(1) << (n)))

orr_status orr_navfit_clock(const orr_ephemeris *e, orr_sat sat, orr_time t0, orr_time from, orr_time to,
                            orr_nav_eph *eph, double *rms_s, orr_diag *diag)
{
    const bool is_glonass = eph->kind == ORR_NAV_GLONASS;
    const int points = 24;
    double x[25], y[25], sx = 0, sy = 0, sxx = 0, sxy = 0, sum = 0;
    int n = 0;
    for (int k = 0; k <= points; k++) {
        orr_time t = orr_time_add_s(from, orr_time_diff_s(to, from) * k / points);
        double dt = orr_time_diff_s(t, t0);
        orr_sat_state s;
        if (orr_ephemeris_eval(e, sat, t, &s) != ORR_OK || !(s.flags & ORR_EPH_CLOCK_VALID)) continue;
        double clock = s.clock_s;
        if (is_glonass) {
            orr_vec3 v =
                orr_vec3_add(s.vel_mps, orr_vec3_cross((orr_vec3){0, 0, ORR_EARTH_RATE_RADPS}, s.pos_m));
            clock -= 2 * orr_vec3_dot(s.pos_m, v) / (ORR_SPEED_OF_LIGHT * ORR_SPEED_OF_LIGHT);
        }
        x[n] = dt, y[n] = clock, n++;
        sx += dt, sy += clock, sxx += dt * dt, sxy += dt * clock;
    }
    if (n < 2)
        return orr_diag_set(diag, ORR_E_NODATA, "the product has no clock of the satellite in the window");
    double den = n * sxx - sx * sx, slope = (n * sxy - sx * sy) / den, value = (sy - slope * sx) / n;
    double af0_lsb = is_glonass ? P2(30) : P2(31), af1_lsb = is_glonass ? P2(40) : P2(43);
    eph->af1_sps = round(slope / af1_lsb) * af1_lsb;
    value = (sy - eph->af1_sps * sx) / n;
    eph->af0_s = round(value / af0_lsb) * af0_lsb;
    eph->af2_sps2 = 0;
    for (int k = 0; k < n; k++) {
        double d = y[k] - eph->af0_s - eph->af1_sps * x[k];
        sum += d * d;
    }
    if (rms_s != NULL) *rms_s = sqrt(sum / n);
    return ORR_OK;
}

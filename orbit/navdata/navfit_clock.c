// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/astro.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/navdata/geo_fields.h"
#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/navfit_private.h"

orr_status orr_navfit_clock_line(const orr_ephemeris *e, orr_sat sat, orr_time t0, orr_time from, orr_time to,
                                 bool relativity, orr_navfit_line *line, orr_diag *diag)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    line->n = 0;
    for (int k = 0; k < ORR_NAVFIT_CLOCKS; k++) {
        orr_time t = orr_time_add_s(from, orr_time_diff_s(to, from) * k / (ORR_NAVFIT_CLOCKS - 1));
        orr_sat_state s;
        if (orr_ephemeris_eval(e, sat, t, &s) != ORR_OK || !(s.flags & ORR_EPH_CLOCK_VALID)) continue;
        line->dt_s[line->n] = orr_time_diff_s(t, t0);
        line->value[line->n] = s.clock_s;
        if (relativity)
            line->value[line->n] +=
                orr_periodic_relativity_s(s.pos_m, orr_velocity_inertial(s.pos_m, s.vel_mps));
        sx += line->dt_s[line->n], sy += line->value[line->n];
        line->n++;
    }
    if (line->n < 2)
        return orr_diag_set(diag, ORR_E_NODATA, "the product has no clock of the satellite in the window");
    line->mean_dt_s = sx / line->n, line->mean = sy / line->n;
    for (int k = 0; k < line->n; k++) {
        double x = line->dt_s[k] - line->mean_dt_s;
        sxx += x * x, sxy += x * (line->value[k] - line->mean);
    }
    line->slope = sxy / sxx;
    return ORR_OK;
}

double orr_navfit_line_rms(const orr_navfit_line *line, double value, double slope)
{
    double sum = 0;
    for (int k = 0; k < line->n; k++) {
        double d = line->value[k] - value - slope * line->dt_s[k];
        sum += d * d;
    }
    return sqrt(sum / line->n);
}

orr_status orr_navfit_clock(const orr_ephemeris *e, orr_sat sat, orr_time t0, orr_time from, orr_time to,
                            double shift_s, orr_nav_eph *eph, double *rms_s, orr_diag *diag)
{
    static const orr_navfit_field glonass[2] = {ORR_MAGNITUDE("-tau_n", P2(30), 22),
                                                ORR_MAGNITUDE("gamma_n", P2(40), 11)};
    const orr_kepler_lattice *lattice = orr_kepler_lattice_of(sat, eph->message);
    const orr_navfit_field *field = lattice != NULL                ? lattice->clock
                                    : eph->message == ORR_NAV_SBAS ? orr_geo_clock
                                                                   : glonass;
    orr_navfit_line line;
    orr_status s = orr_navfit_clock_line(e, sat, t0, from, to, lattice == NULL, &line, diag);
    if (s != ORR_OK) return s;
    eph->af1_sps = orr_navfit_clamped(&field[1], line.slope); // a reset within the window asks for any rate
    const double value = line.mean + shift_s - eph->af1_sps * line.mean_dt_s;
    s = orr_navfit_to_field(&field[0], orr_navfit_whole(&field[0], value), &eph->af0_s, diag);
    if (s != ORR_OK) return s;
    eph->af2_sps2 = 0;
    if (rms_s != NULL) *rms_s = orr_navfit_line_rms(&line, eph->af0_s - shift_s, eph->af1_sps);
    return ORR_OK;
}

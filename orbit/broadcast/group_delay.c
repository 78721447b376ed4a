// SPDX-License-Identifier: GPL-3.0-or-later
// Group delays of broadcast messages, signal by signal.
#include <string.h>

#include "orbit/broadcast/broadcast.h"

static double squared_ratio(double a, double b) { return a * a / (b * b); }

#define L1_HZ 1575.42e6
#define L2_HZ 1227.60e6
#define L5_HZ 1176.45e6
#define E5B_HZ 1207.14e6

// GPS and QZSS, LNAV: the clock is that of L1/L2 P(Y) without ionosphere; L1: TGD, L2: gamma TGD
// (IS-GPS-200N 20.3.3.3.3.2). CNAV: TGD - ISC per signal (30.3.3.3.1.1).
static double gps_delay(const orr_nav_eph *e, const char *signal)
{
    const orr_nav_delays *d = &e->delay;
    if (e->message == ORR_NAV_LNAV) {
        if (signal[0] == '1') return d->tgd_s;
        if (signal[0] == '2') return squared_ratio(L1_HZ, L2_HZ) * d->tgd_s;
        return (double)NAN;
    }
    double isc = (double)NAN;
    if (!strcmp(signal, "1C")) isc = d->isc_l1ca_s;
    if (!strcmp(signal, "1S") || !strcmp(signal, "1X") || !strcmp(signal, "1D")) isc = d->isc_l1cd_s;
    if (!strcmp(signal, "1L") || !strcmp(signal, "1P")) isc = d->isc_l1cp_s;
    if (!strcmp(signal, "1W")) isc = 0;
    if (signal[0] == '2' && strchr("SLX", signal[1]) != NULL) isc = d->isc_l2c_s;
    if (!strcmp(signal, "5I")) isc = d->isc_l5i5_s;
    if (!strcmp(signal, "5Q") || !strcmp(signal, "5X")) isc = d->isc_l5q5_s;
    return d->tgd_s - isc;
}

// Galileo: F/NAV's clock is that of E1/E5a, I/NAV's that of E1/E5b (OS SIS ICD 5.1.5).
static double galileo_delay(const orr_nav_eph *e, const char *signal)
{
    const bool fnav = e->message == ORR_NAV_FNAV;
    const double bgd = fnav ? e->delay.bgd_e5a_e1_s : e->delay.bgd_e5b_e1_s;
    if (signal[0] == '1') return bgd;
    if (fnav && signal[0] == '5') return squared_ratio(L1_HZ, L5_HZ) * bgd;
    if (!fnav && signal[0] == '7') return squared_ratio(L1_HZ, E5B_HZ) * bgd;
    return (double)NAN;
}

// BeiDou D1/D2: the clock is that of B3I (BDS-SIS-ICD-B1I 5.2.4.10); B1C and B2a: pilot TGD, data plus ISC.
static double beidou_delay(const orr_nav_eph *e, const char *signal)
{
    const orr_nav_delays *d = &e->delay;
    if (e->message == ORR_NAV_D1 || e->message == ORR_NAV_D2) {
        if (signal[0] == '2') return d->tgd_s; // B1I is band 2 in RINEX 3
        if (signal[0] == '7') return d->tgd2_s;
        if (signal[0] == '6') return 0;
        return (double)NAN;
    }
    if (!strcmp(signal, "1P")) return d->tgd_b1cp_s;
    if (!strcmp(signal, "1D")) return d->tgd_b1cp_s + d->isc_b1cd_s;
    if (!strcmp(signal, "5P")) return d->tgd_b2ap_s;
    if (!strcmp(signal, "5D")) return d->tgd_b2ap_s + d->isc_b2ad_s;
    if (e->message == ORR_NAV_CNV3 && signal[0] == '7') return d->tgd_s;
    return (double)NAN;
}

orr_status orr_broadcast_group_delay(const orr_nav_eph *e, const char *signal, double *delay_s)
{
    double delay = (double)NAN;
    if (signal == NULL || strlen(signal) != 2) return ORR_E_ARG;
    switch (orr_sat_system(e->sat)) {
    case 'G':
    case 'J':
        delay = gps_delay(e, signal);
        break;
    case 'E':
        delay = galileo_delay(e, signal);
        break;
    case 'C':
        delay = beidou_delay(e, signal);
        break;
    case 'I': // the clock is that of L5/S; single frequency: TGD on S (gamma = 1), (f_S/f_L5)^2 on L5
              // (ICD 6.2.1.5)
        if (signal[0] == '9') delay = e->delay.tgd_s;
        if (signal[0] == '5') delay = squared_ratio(2492.028e6, L5_HZ) * e->delay.tgd_s;
        break;
    case 'R': // the clock is that of L1; L2 lags by delta tau (ICD 4.4)
        if (signal[0] == '1') delay = 0;
        if (signal[0] == '2') delay = e->glonass.delta_tau_s;
        break;
    default:
        break;
    }
    if (!isfinite(delay)) return ORR_E_NODATA;
    *delay_s = delay;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Group delays of broadcast messages, signal by signal.
#include <string.h>

#include "core/constants.h"
#include "orbit/broadcast/broadcast.h"

static double squared_ratio(double a, double b) { return a * a / (b * b); }

#define L2_HZ 1227.60e6
#define L5_HZ 1176.45e6
#define E5B_HZ 1207.14e6

// Attributes of the signals that a system has in a band (RINEX 4.02, tables 12-18): "1P" of GPS is P(Y), "1L" its L1C.
static bool is_signal(char system, const char *signal)
{
    static const struct {
        char system, band;
        const char *attributes;
    } table[] = {
        {'G', '1', "CSLXPWYMN"}, {'G', '2', "CDSLXPWYMN"}, {'G', '5', "IQX"},   {'R', '1', "CP"},
        {'R', '2', "CP"},        {'R', '3', "IQX"},        {'R', '4', "ABX"},   {'R', '6', "ABX"},
        {'E', '1', "ABCXZ"},     {'E', '5', "IQX"},        {'E', '6', "ABCXZ"}, {'E', '7', "IQX"},
        {'E', '8', "IQX"},       {'C', '1', "DPXSLZ"},     {'C', '2', "IQX"},   {'C', '5', "DPX"},
        {'C', '6', "IQXDPZ"},    {'C', '7', "IQXDPZ"},     {'C', '8', "DPX"},   {'J', '1', "CESLXZB"},
        {'J', '2', "SLX"},       {'J', '5', "IQXDPZ"},     {'J', '6', "SLXEZ"}, {'I', '1', "DPX"},
        {'I', '5', "ABCX"},      {'I', '9', "ABCX"},       {'S', '1', "C"},     {'S', '5', "IQX"}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (table[i].system == system && table[i].band == signal[0])
            return strchr(table[i].attributes, signal[1]) != NULL;
    return false;
}

static bool one_of(const char *signal, char band, const char *attributes)
{
    return signal[0] == band && strchr(attributes, signal[1]) != NULL;
}

// GPS: the clock is that of L1/L2 P(Y) without ionosphere, so L1 P(Y) lags by TGD and L2 P(Y) by gamma TGD
// (IS-GPS-200N 20.3.3.3.3.2); LNAV says the same of L1 C/A, and nothing of the others. CNAV: TGD - ISC for each signal
// (30.3.3.3.1.1; L1C: IS-GPS-800J 3.5.3.9). QZSS: the pair is L1 C/A and L2C (IS-QZSS-PNT 5.8).
static double gps_delay(const orr_nav_eph *e, char system, const char *signal)
{
    const orr_nav_delays *d = &e->delay;
    const double gamma = squared_ratio(ORR_L1_HZ, L2_HZ);
    if (system == 'G' && one_of(signal, '1', "PWY")) return d->tgd_s;
    if (system == 'G' && one_of(signal, '2', "PWYD")) return gamma * d->tgd_s;
    if (e->message == ORR_NAV_LNAV) {
        if (one_of(signal, '1', "C")) return d->tgd_s;
        if (system == 'J' && one_of(signal, '2', "SLX")) return gamma * d->tgd_s;
        return (double)NAN;
    }
    double isc = (double)NAN;
    if (one_of(signal, '1', "C")) isc = d->isc_l1ca_s;
    if (one_of(signal, '1', "S")) isc = d->isc_l1cd_s;
    if (one_of(signal, '1', "L")) isc = d->isc_l1cp_s;
    if (one_of(signal, '1', "X")) isc = d->isc_l1cp_s; // three quarters of L1C's power are the pilot's
    if (one_of(signal, '2', "SLX")) isc = d->isc_l2c_s;
    if (one_of(signal, '5', "I")) isc = d->isc_l5i5_s;
    if (one_of(signal, '5', "QX")) isc = d->isc_l5q5_s;
    return d->tgd_s - isc;
}

// Galileo: F/NAV's clock is that of E1/E5a, I/NAV's that of E1/E5b; E5a lags by (gamma - 1) BGD(E1, E5a) behind E1
// (OS SIS ICD 2.1, 5.1.5), which I/NAV tells too.
static double galileo_delay(const orr_nav_eph *e, const char *signal)
{
    const double e5a = e->delay.bgd_e5a_e1_s, e5b = e->delay.bgd_e5b_e1_s;
    const double e1 = e->message == ORR_NAV_FNAV ? e5a : e5b;
    if (signal[0] == '1') return e1;
    if (signal[0] == '5') return e1 + (squared_ratio(ORR_L1_HZ, L5_HZ) - 1) * e5a;
    if (signal[0] == '7') return e1 + (squared_ratio(ORR_L1_HZ, E5B_HZ) - 1) * e5b;
    return (double)NAN;
}

// BeiDou: the clock is that of B3I (BDS-SIS-ICD-B1I 3.0, 5.2.4.10; B1C 1.0, 7.6); B1C and B2a: TGD of the pilot, that of
// the data plus ISC; B2b: TGD of the data.
static double beidou_delay(const orr_nav_eph *e, const char *signal)
{
    const orr_nav_delays *d = &e->delay;
    if (one_of(signal, '6', "IQX")) return 0;
    if (e->message == ORR_NAV_D1 || e->message == ORR_NAV_D2) {
        if (signal[0] == '2') return d->tgd_s; // B1I is band 2 in RINEX 3
        if (one_of(signal, '7', "IQX")) return d->tgd2_s;
        return (double)NAN;
    }
    if (one_of(signal, '1', "P")) return d->tgd_b1cp_s;
    if (one_of(signal, '1', "D")) return d->tgd_b1cp_s + d->isc_b1cd_s;
    if (one_of(signal, '5', "P")) return d->tgd_b2ap_s;
    if (one_of(signal, '5', "D")) return d->tgd_b2ap_s + d->isc_b2ad_s;
    if (e->message == ORR_NAV_CNV3 && one_of(signal, '7', "D")) return d->tgd_s;
    return (double)NAN;
}

orr_status orr_broadcast_group_delay(const orr_nav_eph *e, const char *signal, double *delay_s)
{
    double delay = (double)NAN;
    const char system = orr_sat_system(e->sat);
    if (signal == NULL || strlen(signal) != 2) return ORR_E_ARG;
    if (!is_signal(system, signal)) return ORR_E_NODATA;
    switch (system) {
    case 'G':
    case 'J':
        delay = gps_delay(e, system, signal);
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

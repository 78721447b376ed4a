// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/spacecraft/signal_delay.h"

#include <string.h>

typedef struct signal_pair {
    char system;
    const char *obs1, *obs2;
    double f1_hz, f2_hz; // GLONASS: any channel's, the ratio is 9/7 for all
} signal_pair;

// In each system the first pair that a file knows is taken. Centres changed theirs: BeiDou's clocks were of
// B1I/B2I before BeiDou-3, Galileo's are of pilot or of combined tracking, whatever the stations do.
static const signal_pair pairs[] = {
    {'G', "C1W", "C2W", 1575.42e6, 1227.60e6},  {'R', "C1P", "C2P", 1602.0e6, 1246.0e6},
    {'E', "C1C", "C5Q", 1575.42e6, 1176.45e6},  {'E', "C1X", "C5X", 1575.42e6, 1176.45e6},
    {'C', "C2I", "C6I", 1561.098e6, 1268.52e6}, {'C', "C2I", "C7I", 1561.098e6, 1207.14e6},
    {'J', "C1C", "C2L", 1575.42e6, 1227.60e6},  {'J', "C1C", "C2X", 1575.42e6, 1227.60e6},
    {'J', "C1X", "C2X", 1575.42e6, 1227.60e6},
};

static double gamma_of(const signal_pair *p) { return p->f1_hz * p->f1_hz / (p->f2_hz * p->f2_hz); }

// Of the system's first pair.
static double usual_gamma(char system)
{
    size_t i = 0;
    while (pairs[i].system != system) i++; // callers ask for systems of the table alone
    return gamma_of(&pairs[i]);
}

static orr_time held_to_span(const orr_bias_set *x, orr_time t)
{
    const orr_time day = ORR_S_PER_DAY * ORR_NS_PER_S;
    if (x->from != ORR_TIME_NONE && t < x->from && x->from - t <= day) return x->from;
    if (x->until != ORR_TIME_NONE && t >= x->until && t - x->until <= day) return x->until - 1;
    return t;
}

// Delay of the pair's first signal: b1 - (gamma b1 - b2) / (gamma - 1) = (b1 - b2) / (1 - gamma).
static const signal_pair *find_pair(const orr_bias_set *x, orr_sat sat, orr_time t, double *delay1_s)
{
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        const signal_pair *p = &pairs[i];
        double difference;
        if (p->system != orr_sat_system(sat) ||
            orr_bias_dsb(x, sat, p->obs1, p->obs2, t, &difference) != ORR_OK)
            continue;
        *delay1_s = difference / (1 - gamma_of(p));
        return p;
    }
    return NULL;
}

orr_status orr_signal_delay_osb(const orr_bias_set *bias, orr_sat sat, const char *signal, orr_time t,
                                double *delay_s)
{
    double first, difference;
    if (signal == NULL || strlen(signal) != 2) return ORR_E_ARG;
    const char obs[4] = {'C', signal[0], signal[1], '\0'};
    t = held_to_span(bias, t);
    const signal_pair *p = find_pair(bias, sat, t, &first);
    if (p == NULL || orr_bias_dsb(bias, sat, obs, p->obs1, t, &difference) != ORR_OK) return ORR_E_NODATA;
    *delay_s = first + difference;
    return ORR_OK;
}

// RINEX attributes under which a file may have a signal: files name either the components together (X) or one of them.
static const char *attributes(const orr_signal *s)
{
    return s->observation[1] == 'X' ? "XQLPCISD" : &s->observation[1];
}

orr_status orr_signal_delay_of(const orr_bias_set *bias, orr_sat sat, const orr_signal *s, orr_time t,
                               double *delay_s)
{
    char code[3] = {s->observation[0], s->observation[1], '\0'};
    for (const char *attribute = attributes(s); *attribute != '\0'; attribute++) {
        code[1] = *attribute;
        if (orr_signal_delay_osb(bias, sat, code, t, delay_s) == ORR_OK) return ORR_OK;
    }
    return ORR_E_NODATA;
}

orr_status orr_signal_phase_of(const orr_bias_set *bias, orr_sat sat, const orr_signal *s, orr_time t,
                               double *delay_s)
{
    double first, absolute, phase;
    char obs[4] = {'L', s->observation[0], s->observation[1], '\0'};
    t = held_to_span(bias, t);
    const signal_pair *p = find_pair(bias, sat, t, &first);
    if (p == NULL || orr_bias_osb(bias, sat, p->obs1, t, &absolute) != ORR_OK) return ORR_E_NODATA;
    for (const char *attribute = attributes(s); *attribute != '\0'; attribute++) {
        obs[2] = *attribute;
        if (orr_bias_osb(bias, sat, obs, t, &phase) != ORR_OK) continue;
        *delay_s = phase - (absolute - first); // the pair's combination is taken away, as from codes
        return ORR_OK;
    }
    return ORR_E_NODATA;
}

orr_status orr_signal_tgd(const orr_bias_set *bias, orr_sat sat, orr_time t, double *tgd_s)
{
    const char system = orr_sat_system(sat);
    double tgd;
    if ((system != 'G' && system != 'J') || find_pair(bias, sat, held_to_span(bias, t), &tgd) == NULL)
        return ORR_E_NODATA;
    *tgd_s = tgd;
    return ORR_OK;
}

orr_status orr_signal_glonass(const orr_bias_set *bias, orr_sat sat, orr_time t, double *l1_clock_shift_s,
                              double *delta_tau_s)
{
    static const char *const signals[2][2] = {{"1C", "2C"}, {"1P", "2P"}};
    if (orr_sat_system(sat) != 'R') return ORR_E_NODATA;
    for (int k = 0; k < 2; k++) {
        double l1, l2;
        if (orr_signal_delay_osb(bias, sat, signals[k][0], t, &l1) != ORR_OK ||
            orr_signal_delay_osb(bias, sat, signals[k][1], t, &l2) != ORR_OK)
            continue;
        *l1_clock_shift_s = -l1;
        *delta_tau_s = l2 - l1;
        return ORR_OK;
    }
    return ORR_E_NODATA;
}

orr_status orr_signal_broadcast_to_product(const orr_nav_eph *eph, double *shift_s)
{
    const orr_nav_delays *d = &eph->delay;
    double shift = (double)NAN;
    switch (orr_sat_system(eph->sat)) {
    case 'G':
    case 'J':
        shift = 0;
        break;
    case 'E': // E1 lags by BGD(E5b) behind I/NAV's clock, by BGD(E5a) behind the product's
        shift = eph->message == ORR_NAV_FNAV ? 0 : d->bgd_e5a_e1_s - d->bgd_e5b_e1_s;
        break;
    case 'C': // B3I lags by nothing behind the message's clock, by -gamma/(gamma - 1) TGD1 behind B1I/B3I
        if (eph->message == ORR_NAV_D1 || eph->message == ORR_NAV_D2) {
            const double g = usual_gamma('C');
            shift = -g / (g - 1) * d->tgd_s;
        }
        break;
    case 'R': // L1 lags by nothing behind the message's clock, by delta tau / (gamma - 1) behind L1/L2
        shift = eph->glonass.delta_tau_s / (usual_gamma('R') - 1);
        break;
    default:
        break;
    }
    if (!isfinite(shift)) return ORR_E_NODATA;
    *shift_s = shift;
    return ORR_OK;
}

orr_status orr_signal_delay_broadcast(const orr_nav_eph *eph, const char *signal, double *delay_s)
{
    double delay, shift;
    const orr_status s = orr_broadcast_group_delay(eph, signal, &delay);
    if (s != ORR_OK) return s;
    if (orr_signal_broadcast_to_product(eph, &shift) != ORR_OK) return ORR_E_NODATA;
    *delay_s = delay + shift;
    return ORR_OK;
}

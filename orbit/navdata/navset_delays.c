// SPDX-License-Identifier: GPL-3.0-or-later
// Group delays as messages send them, and the clock that they are counted from: each message's clock is that of signals of its
// own, which the product's need not be of.
#include "orbit/navdata/navset_private.h"
#include "orbit/spacecraft/signal_delay.h"

// Fields could hold one value more, at their negative ends, which CNAV uses for "not known".
static const orr_navfit_field lnav_tgd = ORR_MAGNITUDE("TGD", P2(31), 8),
                              bgd = ORR_MAGNITUDE("BGD", P2(32), 10),
                              d1_tgd = ORR_MAGNITUDE("TGD", 1e-10, 10),
                              cnav = ORR_MAGNITUDE("ISC", P2(35), 13),
                              bcnav = ORR_MAGNITUDE("TGD", P2(34), 12),
                              delta_tau = ORR_MAGNITUDE("delta tau_n", P2(30), 5);

typedef struct asking {
    const orr_bias_set *bias;
    orr_sat sat;
    orr_time t;
    bool known; // whether the biases told all that was asked for
} asking;

// Delay of a signal against the product's clock; zero where the biases do not tell, as channels take it.
static double delay_of(asking *a, const char *name)
{
    double d;
    const orr_signal *s = orr_signal_find(orr_sat_system(a->sat), name);
    if (s != NULL && orr_signal_delay_of(a->bias, a->sat, s, a->t, &d) == ORR_OK) return d;
    a->known = false;
    return 0;
}

// Delay of what two signals are without ionosphere.
static double pair_delay(double d1, double f1_hz, double d2, double f2_hz)
{
    const double gamma = f1_hz * f1_hz / (f2_hz * f2_hz);
    return (gamma * d1 - d2) / (gamma - 1);
}

// A delay on its field; zero where it does not fit.
static void put(asking *a, const orr_navfit_field *f, double delay_s, double *out)
{
    if (orr_navfit_to_field(f, orr_navfit_whole(f, delay_s), out, NULL) == ORR_OK) return;
    *out = 0;
    a->known = false;
}

static double galileo(asking *a, orr_nav_eph *eph)
{
    const double f1 = 1575.42e6, f5 = 1176.45e6, f7 = 1207.14e6;
    const double e1 = delay_of(a, "E1"), e5a = delay_of(a, "E5a"), of_5a = pair_delay(e1, f1, e5a, f5);
    const bool known = a->known;
    const double e5b = delay_of(a, "E5b"), of_5b = pair_delay(e1, f1, e5b, f7);
    put(a, &bgd, e1 - of_5b, &eph->delay.bgd_e5b_e1_s);
    if (eph->message == ORR_NAV_FNAV) a->known = known; // F/NAV does not send it
    put(a, &bgd, e1 - of_5a, &eph->delay.bgd_e5a_e1_s);
    return eph->message == ORR_NAV_INAV ? -of_5b : -of_5a;
}

// The clock of D1, D2 and B-CNAV is that of B3I; one delay of B1C and B2a stands for pilot and data.
static double beidou(asking *a, orr_nav_eph *eph)
{
    orr_nav_delays *d = &eph->delay;
    const double b3 = delay_of(a, "B3I");
    if (eph->message == ORR_NAV_D1 || eph->message == ORR_NAV_D2) {
        double b2; // of BeiDou-2 alone
        if (orr_signal_delay_osb(a->bias, a->sat, "7I", a->t, &b2) != ORR_OK) b2 = 0;
        put(a, &d1_tgd, delay_of(a, "B1I") - b3, &d->tgd_s);
        put(a, &d1_tgd, b2 - b3, &d->tgd2_s);
        return -b3;
    }
    d->isc_b1cd_s = d->isc_b2ad_s = 0;
    if (eph->message == ORR_NAV_CNV3) {
        put(a, &bcnav, delay_of(a, "B2b") - b3, &d->tgd_s);
        return -b3;
    }
    put(a, &bcnav, delay_of(a, "B1C") - b3, &d->tgd_b1cp_s);
    put(a, &bcnav, delay_of(a, "B2a") - b3, &d->tgd_b2ap_s);
    return -b3;
}

// GPS: the clock is that of L1P and L2P, as the product's; QZSS: of L1 C/A and L2C.
static double gps(asking *a, orr_nav_eph *eph)
{
    orr_nav_delays *d = &eph->delay;
    double tgd = 0;
    if (orr_signal_tgd(a->bias, a->sat, a->t, &tgd) != ORR_OK) a->known = false;
    if (eph->message == ORR_NAV_LNAV) {
        put(a, &lnav_tgd, tgd, &d->tgd_s);
        return 0;
    }
    put(a, &cnav, tgd, &d->tgd_s);
    put(a, &cnav, tgd - delay_of(a, "L1CA"), &d->isc_l1ca_s);
    put(a, &cnav, tgd - delay_of(a, "L2C"), &d->isc_l2c_s);
    put(a, &cnav, tgd - delay_of(a, "L5"), &d->isc_l5i5_s);
    put(a, &cnav, tgd - delay_of(a, "L1C"), &d->isc_l1cp_s);
    d->isc_l5q5_s = d->isc_l5i5_s, d->isc_l1cd_s = d->isc_l1cp_s;
    return 0;
}

static double glonass(asking *a, orr_nav_eph *eph)
{
    double tau, shift;
    if (orr_signal_glonass(a->bias, a->sat, a->t, &shift, &tau) != ORR_OK) {
        a->known = false;
        return 0;
    }
    put(a, &delta_tau, tau, &eph->glonass.delta_tau_s);
    return shift;
}

double navset_delays(const orr_bias_set *bias, orr_navset_item *item)
{
    orr_nav_eph *eph = &item->eph;
    asking a = {.bias = bias, .sat = eph->sat, .t = eph->toe, .known = true};
    double shift = 0;
    if (eph->message == ORR_NAV_FDMA) eph->glonass.delta_tau_s = 0;
    if (bias == NULL) {
        eph->delay = (orr_nav_delays){0};
        return 0;
    }
    switch (orr_sat_system(eph->sat)) {
    case 'R':
        shift = glonass(&a, eph);
        break;
    case 'E':
        shift = galileo(&a, eph);
        break;
    case 'C':
        shift = beidou(&a, eph);
        break;
    case 'S': // one signal, whose clock it is
        eph->delay = (orr_nav_delays){0};
        break;
    case 'I': // no centre's biases connect L5 with S
        eph->delay.tgd_s = 0;
        a.known = false;
        break;
    default:
        shift = gps(&a, eph);
        break;
    }
    if (!a.known) item->notes |= ORR_NAVSET_NO_DELAY;
    return shift;
}

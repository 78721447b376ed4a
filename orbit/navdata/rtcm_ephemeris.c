// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/rtcm_ephemeris.h"

#include <math.h>

#include "orbit/navdata/glonass_bits.h"
#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/page.h"
#include "orbit/navdata/system_week.h"

#define GALILEO_WEEK_0 1024 // of GPS

static const orr_navfit_field tgd = ORR_SIGNED("TGD", P2(31), 8), bgd = ORR_SIGNED("BGD", P2(32), 10),
                              beidou_tgd = ORR_SIGNED("TGD", 1e-10, 10);

int orr_rtcm_number(orr_sat sat, orr_nav_message message)
{
    switch (message) {
    case ORR_NAV_LNAV:
        switch (orr_sat_system(sat)) {
        case 'G':
            return 1019;
        case 'J':
            return 1044;
        default:
            return 1041;
        }
    case ORR_NAV_FDMA:
        return 1020;
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        return 1042;
    case ORR_NAV_FNAV:
        return 1045;
    case ORR_NAV_INAV:
        return 1046;
    default:
        return 0;
    }
}

// Elements in the order of the messages but for IDOT and what GPS and BeiDou do not share with NavIC.
static const uint8_t first[] = {ORR_KEPLER_CRS, ORR_KEPLER_DELTA_N, ORR_KEPLER_LAMBDA, ORR_KEPLER_CUC,
                                ORR_KEPLER_EX,  ORR_KEPLER_CUS,     ORR_KEPLER_SQRT_A},
                     last[] = {ORR_KEPLER_CIC, ORR_KEPLER_OMEGA0, ORR_KEPLER_CIS,      ORR_KEPLER_I0,
                               ORR_KEPLER_CRC, ORR_KEPLER_EY,     ORR_KEPLER_OMEGA_DOT},
                     idot[] = {ORR_KEPLER_IDOT};

static double or_zero(double v) { return isfinite(v) ? v : 0; }
static uint64_t issue(int32_t v) { return v >= 0 ? (uint64_t)v : 0; }

typedef struct writer {
    const orr_nav_eph *e;
    const orr_kepler_lattice *l;
    orr_page *p;
    int32_t week; // of the system, that of toe
} writer;

static void put_toc(const writer *w)
{
    const double s = (double)(orr_nav_seconds_of_week(w->e->sat, w->e->toc, NULL) / ORR_NS_PER_S);
    orr_page_value(w->p, &w->l->toc, s);
}

static void put_clock(const writer *w, int from, int to)
{
    const double value[3] = {w->e->af0_s, w->e->af1_sps, w->e->af2_sps2};
    for (int k = from; k != to; k += from < to ? 1 : -1) orr_page_value(w->p, &w->l->clock[k], value[k]);
}

// Crs to sqrt(A), toe, Cic to OMEGADOT.
static void put_orbit(const writer *w)
{
    orr_kepler_put(w->p, w->e, first, sizeof first);
    orr_page_value(w->p, &w->l->toe, w->e->kepler.toe_sow_s);
    orr_kepler_put(w->p, w->e, last, sizeof last);
}

static void put_idot(const writer *w) { orr_kepler_put(w->p, w->e, idot, sizeof idot); }

static void gps(const writer *w)
{
    const orr_nav_eph *e = w->e;
    orr_page_put(w->p, 6, (uint64_t)orr_sat_number(e->sat));
    orr_page_put(w->p, 10, (uint64_t)w->week);
    orr_page_put(w->p, 4, (uint64_t)orr_nav_ura_index(e->accuracy_m));
    orr_page_put(w->p, 2, e->data_sources);
    put_idot(w);
    orr_page_put(w->p, 8, issue(e->iode));
    put_toc(w);
    put_clock(w, 2, -1);
    orr_page_put(w->p, 10, issue(e->iodc));
    put_orbit(w);
    orr_page_value(w->p, &tgd, or_zero(e->delay.tgd_s));
    orr_page_put(w->p, 6, e->health);
    orr_page_put(w->p, 1, e->l2p_flag > 0);
    orr_page_put(w->p, 1, e->fit_interval_h > 4);
}

static void qzss(const writer *w)
{
    const orr_nav_eph *e = w->e;
    orr_page_put(w->p, 4, (uint64_t)orr_sat_number(e->sat));
    put_toc(w);
    put_clock(w, 2, -1);
    orr_page_put(w->p, 8, issue(e->iode));
    put_orbit(w);
    put_idot(w);
    orr_page_put(w->p, 2, e->data_sources);
    orr_page_put(w->p, 10, (uint64_t)w->week);
    orr_page_put(w->p, 4, (uint64_t)orr_nav_ura_index(e->accuracy_m));
    orr_page_put(w->p, 6, e->health);
    orr_page_value(w->p, &tgd, or_zero(e->delay.tgd_s));
    orr_page_put(w->p, 10, issue(e->iodc));
    orr_page_put(w->p, 1, e->fit_interval_h > 2);
}

static void beidou(const writer *w)
{
    const orr_nav_eph *e = w->e;
    orr_page_put(w->p, 6, (uint64_t)orr_sat_number(e->sat));
    orr_page_put(w->p, 13, (uint64_t)w->week);
    orr_page_put(w->p, 4, (uint64_t)orr_nav_ura_index(e->accuracy_m));
    put_idot(w);
    orr_page_put(w->p, 5, issue(e->iode));
    put_toc(w);
    put_clock(w, 2, -1);
    orr_page_put(w->p, 5, issue(e->iodc));
    put_orbit(w);
    orr_page_value(w->p, &beidou_tgd, or_zero(e->delay.tgd_s));
    orr_page_value(w->p, &beidou_tgd, or_zero(e->delay.tgd2_s));
    orr_page_put(w->p, 1, e->health != 0);
}

// Health as RINEX writes it: data validity and two bits of status of E1-B (bits 0-2), E5a (3-5), E5b (6-8).
static void galileo(const writer *w)
{
    const orr_nav_eph *e = w->e;
    const uint32_t h = e->health;
    orr_page_put(w->p, 6, (uint64_t)orr_sat_number(e->sat));
    orr_page_put(w->p, 12, (uint64_t)(w->week - GALILEO_WEEK_0));
    orr_page_put(w->p, 10, issue(e->iode));
    orr_page_put(w->p, 8, (uint64_t)orr_nav_sisa_index(e->accuracy_m));
    put_idot(w);
    put_toc(w);
    put_clock(w, 2, -1);
    put_orbit(w);
    orr_page_value(w->p, &bgd, or_zero(e->delay.bgd_e5a_e1_s));
    if (e->message == ORR_NAV_FNAV) {
        orr_page_put(w->p, 2, h >> 4 & 3u);
        orr_page_put(w->p, 1, h >> 3 & 1u);
        orr_page_zeros(w->p, 7);
        return;
    }
    orr_page_value(w->p, &bgd, or_zero(e->delay.bgd_e5b_e1_s));
    orr_page_put(w->p, 2, h >> 7 & 3u);
    orr_page_put(w->p, 1, h >> 6 & 1u);
    orr_page_put(w->p, 2, h >> 1 & 3u);
    orr_page_put(w->p, 1, h & 1u);
    orr_page_zeros(w->p, 2);
}

static void navic(const writer *w)
{
    static const uint8_t delta_n[] = {ORR_KEPLER_DELTA_N}, m0[] = {ORR_KEPLER_LAMBDA},
                         harmonics[] = {ORR_KEPLER_CUC, ORR_KEPLER_CUS, ORR_KEPLER_CIC, ORR_KEPLER_CIS,
                                        ORR_KEPLER_CRC, ORR_KEPLER_CRS, ORR_KEPLER_IDOT},
                         rest[] = {ORR_KEPLER_EX, ORR_KEPLER_SQRT_A,    ORR_KEPLER_OMEGA0,
                                   ORR_KEPLER_EY, ORR_KEPLER_OMEGA_DOT, ORR_KEPLER_I0};
    const orr_nav_eph *e = w->e;
    orr_page_put(w->p, 6, (uint64_t)orr_sat_number(e->sat));
    orr_page_put(w->p, 10, (uint64_t)w->week);
    put_clock(w, 0, 3);
    orr_page_put(w->p, 4, (uint64_t)orr_nav_ura_index(e->accuracy_m));
    put_toc(w);
    orr_page_value(w->p, &tgd, or_zero(e->delay.tgd_s));
    orr_kepler_put(w->p, e, delta_n, sizeof delta_n);
    orr_page_put(w->p, 8, issue(e->iode));
    orr_page_zeros(w->p, 10);
    orr_page_put(w->p, 2, e->health != 0 ? 3 : 0);
    orr_kepler_put(w->p, e, harmonics, sizeof harmonics);
    orr_kepler_put(w->p, e, m0, sizeof m0);
    orr_page_value(w->p, &w->l->toe, e->kepler.toe_sow_s);
    orr_kepler_put(w->p, e, rest, sizeof rest);
    orr_page_zeros(w->p, 4);
}

// Bits high, high - 1, ... of a string, as the ICD numbers them (85 is the first).
static void copy_string(orr_page *p, const orr_glonass_string *s, int high, int n)
{
    for (int k = 85 - high; k < 85 - high + n; k++)
        orr_page_put(p, 1, (uint64_t)s->data[k / 8] >> (7 - k % 8) & 1u);
}

// Message 1020 is strings 1 to 5 in another order.
static orr_status glonass(const orr_nav_eph *e, const orr_leap_table *leap, orr_page *p, orr_diag *diag)
{
    const int64_t frame = 30 * ORR_NS_PER_S,
                  sent = e->transmission != ORR_TIME_NONE ? e->transmission : e->toe;
    const orr_time day = orr_glonass_day(sent, leap), t_k = day + orr_floor_div(sent - day, frame) * frame;
    orr_glonass_immediate im;
    orr_glonass_string s[6];
    orr_glonass_immediate_of(e, t_k, leap, &im);
    orr_status status = ORR_OK;
    for (int k = 1; k <= 4 && status == ORR_OK; k++)
        status = orr_glonass_encode_immediate(e, &im, k, &s[k], diag);
    const orr_glonass_time time = {.t_k = t_k, .almanac_day = day, .l_n = im.l_n, .leap = leap};
    if (status == ORR_OK) status = orr_glonass_encode_time(&time, &s[5], diag);
    if (status != ORR_OK) return status;
    orr_page_put(p, 6, (uint64_t)orr_sat_number(e->sat));
    orr_page_put(p, 5, (uint64_t)(e->glonass.freq_channel + 7));
    orr_page_zeros(p, 2);         // almanac health: not available
    copy_string(p, &s[1], 78, 2); // P1
    copy_string(p, &s[1], 76, 12);
    copy_string(p, &s[2], 80, 1); // the highest bit of B_n
    copy_string(p, &s[2], 77, 1); // P2
    copy_string(p, &s[2], 76, 7); // t_b
    for (int k = 1; k <= 3; k++) {
        copy_string(p, &s[k], 64, 24);
        copy_string(p, &s[k], 35, 27);
        copy_string(p, &s[k], 40, 5);
    }
    copy_string(p, &s[3], 80, 12); // P3, gamma_n
    copy_string(p, &s[3], 67, 3);  // P, l_n
    copy_string(p, &s[4], 80, 32); // tau_n, delta tau_n, E_n
    copy_string(p, &s[4], 34, 5);  // P4, F_T
    copy_string(p, &s[4], 26, 11); // N_T
    copy_string(p, &s[4], 10, 2);  // M
    orr_page_put(p, 1, 1);         // what follows is there
    copy_string(p, &s[5], 80, 43); // N_A, tau_c
    copy_string(p, &s[5], 36, 5);  // N_4
    copy_string(p, &s[5], 31, 23); // tau_GPS, l_n
    orr_page_zeros(p, 7);
    return ORR_OK;
}

orr_status orr_rtcm_ephemeris(const orr_nav_eph *eph, const orr_leap_table *leap, orr_rtcm_frame *frame,
                              orr_diag *diag)
{
    char name[ORR_SAT_TEXT];
    orr_page p;
    const int number = orr_rtcm_number(eph->sat, (orr_nav_message)eph->message);
    if (number == 0)
        return orr_diag_set(diag, ORR_E_ARG, "%s: RTCM 3 has no message for %s", orr_sat_text(eph->sat, name),
                            orr_nav_message_name((orr_nav_message)eph->message));
    writer w = {.e = eph, .l = orr_kepler_lattice_of(eph->sat, eph->message), .p = &p};
    orr_nav_seconds_of_week(eph->sat, eph->toe, &w.week);
    orr_page_begin(&p, diag);
    orr_page_put(&p, 12, (uint64_t)number);
    orr_status s = ORR_OK;
    switch (number) {
    case 1019:
        gps(&w);
        break;
    case 1020:
        s = glonass(eph, leap, &p, diag);
        break;
    case 1041:
        navic(&w);
        break;
    case 1042:
        beidou(&w);
        break;
    case 1044:
        qzss(&w);
        break;
    default:
        galileo(&w);
        break;
    }
    if (s == ORR_OK) s = p.status;
    if (s != ORR_OK) return s;
    orr_rtcm_begin(frame);
    for (size_t k = 0; k < p.n; k++) orr_rtcm_put(frame, 1, p.bit[k]);
    (void)orr_rtcm_end(frame); // five hundred bits are never too many
    return ORR_OK;
}

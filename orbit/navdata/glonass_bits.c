// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/glonass_bits.h"

#define BITS 85
#define CHECK_BITS 8

// A string while it is being filled: one entry a bit, numbered 85..1 as the ICD numbers them.
typedef struct draft {
    uint8_t bit[BITS + 1];
    orr_diag *diag;
    orr_status status;
} draft;

static void put(draft *d, int highest, int n, uint32_t value)
{
    for (int k = 0; k < n; k++) d->bit[highest - k] = (uint8_t)(value >> (n - 1 - k) & 1u);
}

static void refuse(draft *d, const char *name, double value, int n)
{
    if (d->status == ORR_OK)
        d->status = orr_diag_set(d->diag, ORR_E_RANGE, "%s = %.10g does not fit its %d bits", name, value, n);
}

static uint32_t magnitude(draft *d, const char *name, double value, double lsb, int n)
{
    double whole = round(value / lsb);
    if (whole >= 0 && whole < ldexp(1.0, n)) return (uint32_t)whole;
    refuse(d, name, value, n);
    return 0;
}

static void put_unsigned(draft *d, int highest, int n, const char *name, double value, double lsb)
{
    put(d, highest, n, magnitude(d, name, value, lsb, n));
}

// The sign is the highest bit, 1 for less than zero; zero is sent as +0.
static void put_signed(draft *d, int highest, int n, const char *name, double value, double lsb)
{
    uint32_t size = magnitude(d, name, fabs(value), lsb, n - 1);
    put(d, highest, 1, value < 0 && size > 0);
    put(d, highest - 1, n - 1, size);
}

// An angle in semicircles. Half a turn itself cannot be sent: the field's last value stands for it, within an
// LSB.
static void put_angle(draft *d, int highest, int n, const char *name, double rad, double lsb)
{
    double a = remainder(rad, 2 * ORR_PI);
    if (fabs(a) > ORR_PI - lsb) a = copysign(ORR_PI - lsb, a);
    put_signed(d, highest, n, name, a, lsb);
}

// The checksums of table 4.13. C_1..C_7 are those of a Hamming code whose positions 1, 2, 4 .. 64 hold the
// check bits 1..7 and whose other positions, from 3 on, hold bits 9 to 85: a set bit adds its position's
// binary digits. C_sigma is the parity of all 85 bits.
static unsigned checksums(const uint8_t bit[BITS + 1])
{
    unsigned sum = 0, parity = bit[CHECK_BITS], position = 2;
    for (unsigned k = 1; k < CHECK_BITS; k++) {
        sum ^= bit[k] ? 1u << (k - 1) : 0;
        parity ^= bit[k];
    }
    for (int k = CHECK_BITS + 1; k <= BITS; k++) {
        do position++;
        while ((position & (position - 1)) == 0);
        sum ^= bit[k] ? position : 0;
        parity ^= bit[k];
    }
    return parity << 7 | sum;
}

static orr_status seal(draft *d, int string, orr_glonass_string *out)
{
    if (d->status != ORR_OK) return d->status;
    put(d, 84, 4, (uint32_t)string);
    put(d, CHECK_BITS, CHECK_BITS, 0);
    put(d, CHECK_BITS - 1, CHECK_BITS - 1, checksums(d->bit) & 0x7f);
    d->bit[CHECK_BITS] = (uint8_t)(checksums(d->bit) >> 7);
    *out = (orr_glonass_string){0};
    for (int k = 0; k < BITS; k++) out->data[k / 8] |= (uint8_t)(d->bit[BITS - k] << (7 - k % 8));
    return ORR_OK;
}

// RINEX 3.05, table A10, status flags: M in bits 7-8, P4 6, P3 5, P2 4, P1 2-3, P 0-1. All zero is a blank
// field. Its health flags are left alone: writers number their bits from either end.
void orr_glonass_immediate_of(const orr_nav_eph *eph, orr_time t_k, const orr_leap_table *leap,
                              orr_glonass_immediate *out)
{
    static const int interval_min[4] = {0, 30, 45, 60};
    const orr_nav_glonass *g = &eph->glonass;
    int frame = orr_glonass_frame(t_k, leap);
    *out = (orr_glonass_immediate){.t_k = t_k,
                                   .leap = leap,
                                   .p1_min = 30,
                                   .p3 = frame >= 1 && frame <= 4,
                                   .m = 1,
                                   .l_n = eph->health != 0,
                                   .f_t = g->ura >= 0 && g->ura <= 15 ? (int)g->ura : 15,
                                   .e_n_days = g->age_days >= 0 && g->age_days <= 31 ? (int)g->age_days : 31};
    if (!g->has_flags || g->status_flags == 0) return;
    out->m = (int)(g->status_flags >> 7 & 3u);
    out->p4 = g->status_flags >> 6 & 1u;
    out->p1_min = interval_min[g->status_flags >> 2 & 3u];
    out->p = (int)(g->status_flags & 3u);
}

static void put_axis(draft *d, const char *const name[3], double pos_m, double vel_mps, double acc_mps2)
{
    put_signed(d, 64, 24, name[1], vel_mps, 1e3 * ldexp(1, -20));
    put_signed(d, 40, 5, name[2], acc_mps2, 1e3 * ldexp(1, -30));
    put_signed(d, 35, 27, name[0], pos_m, 1e3 * ldexp(1, -11));
}

static orr_status fill_1(draft *d, const orr_nav_eph *e, const orr_glonass_immediate *im)
{
    static const char *const name[3] = {"x_n", "x_n'", "x_n''"};
    orr_civil c;
    orr_glonass_clock(im->t_k, im->leap, &c);
    if (orr_glonass_frame(im->t_k, im->leap) == 0)
        return orr_diag_set(d->diag, ORR_E_ARG, "t_k: a frame begins at second 0 or 30 of UTC");
    if (im->p1_min != 0 && im->p1_min != 30 && im->p1_min != 45 && im->p1_min != 60)
        return orr_diag_set(d->diag, ORR_E_RANGE, "P1 = %d min is none of 0, 30, 45 and 60", im->p1_min);
    put(d, 78, 2, im->p1_min == 0 ? 0 : (uint32_t)im->p1_min / 15 - 1);
    put(d, 76, 5, (uint32_t)c.hour);
    put(d, 71, 6, (uint32_t)c.minute);
    put(d, 65, 1, c.second == 30);
    put_axis(d, name, e->glonass.pos_m.x, e->glonass.vel_mps.x, e->glonass.acc_mps2.x);
    return ORR_OK;
}

static orr_status fill_2(draft *d, const orr_nav_eph *e, const orr_glonass_immediate *im)
{
    static const char *const name[3] = {"y_n", "y_n'", "y_n''"};
    orr_civil c;
    orr_glonass_clock(e->toe, im->leap, &c);
    uint32_t t_b = (uint32_t)(c.hour * 60 + c.minute) / 15;
    if (c.ns != 0 || c.second != 0 || c.minute % 15 != 0 || t_b == 0)
        return orr_diag_set(d->diag, ORR_E_RANGE, "t_b is sent as 15, 30 .. 1425 min of the day in Moscow");
    if (fabs(orr_time_diff_s(e->toe, im->t_k)) > ORR_S_PER_DAY / 2.0)
        return orr_diag_set(d->diag, ORR_E_RANGE, "t_b is more than half a day from t_k");
    put(d, 80, 3, e->health == 0 ? 0 : 4);
    put(d, 77, 1, t_b & 1u);
    put(d, 76, 7, t_b);
    put_axis(d, name, e->glonass.pos_m.y, e->glonass.vel_mps.y, e->glonass.acc_mps2.y);
    return ORR_OK;
}

static void fill_3(draft *d, const orr_nav_eph *e, const orr_glonass_immediate *im)
{
    static const char *const name[3] = {"z_n", "z_n'", "z_n''"};
    put(d, 80, 1, im->p3);
    put_signed(d, 79, 11, "gamma_n", e->af1_sps, ldexp(1, -40));
    put_unsigned(d, 67, 2, "P", im->p, 1);
    put(d, 65, 1, im->l_n);
    put_axis(d, name, e->glonass.pos_m.z, e->glonass.vel_mps.z, e->glonass.acc_mps2.z);
}

static orr_status fill_4(draft *d, const orr_nav_eph *e, const orr_glonass_immediate *im)
{
    int n4 = 0, nt = 0;
    orr_status s = orr_glonass_calendar(im->t_k, im->leap, &n4, &nt, d->diag);
    if (s != ORR_OK) return s;
    double delta_tau_s = isnan(e->glonass.delta_tau_s) ? 0 : e->glonass.delta_tau_s;
    put_signed(d, 80, 22, "tau_n", -e->af0_s, ldexp(1, -30));
    put_signed(d, 58, 5, "delta tau_n", delta_tau_s, ldexp(1, -30));
    put_unsigned(d, 53, 5, "E_n", im->e_n_days, 1);
    put(d, 34, 1, im->p4);
    put_unsigned(d, 33, 4, "F_T", im->f_t, 1);
    put_unsigned(d, 26, 11, "N_T", nt, 1);
    put_unsigned(d, 15, 5, "n", orr_sat_number(e->sat), 1);
    put_unsigned(d, 10, 2, "M", im->m, 1);
    return ORR_OK;
}

orr_status orr_glonass_encode_immediate(const orr_nav_eph *eph, const orr_glonass_immediate *im, int string,
                                        orr_glonass_string *out, orr_diag *diag)
{
    draft d = {.diag = diag};
    orr_status s = ORR_OK;
    if (eph->kind != ORR_NAV_GLONASS)
        return orr_diag_set(diag, ORR_E_ARG, "GLONASS strings carry a state, not Kepler elements");
    switch (string) {
    case 1:
        s = fill_1(&d, eph, im);
        break;
    case 2:
        s = fill_2(&d, eph, im);
        break;
    case 3:
        fill_3(&d, eph, im);
        break;
    case 4:
        s = fill_4(&d, eph, im);
        break;
    default:
        return orr_diag_set(diag, ORR_E_ARG, "string %d holds no immediate data", string);
    }
    return s != ORR_OK ? s : seal(&d, string, out);
}

orr_status orr_glonass_encode_time(const orr_glonass_time *time, orr_glonass_string *out, orr_diag *diag)
{
    draft d = {.diag = diag};
    int n4 = 0, na = 0, other = 0;
    orr_status s = orr_glonass_calendar(time->almanac_day, time->leap, &other, &na, diag);
    if (s == ORR_OK) s = orr_glonass_calendar(time->t_k, time->leap, &n4, &other, diag);
    if (s != ORR_OK) return s;
    put_unsigned(&d, 80, 11, "N_A", na, 1);
    put_signed(&d, 69, 32, "tau_c", time->tau_c_s, ldexp(1, -31));
    put_unsigned(&d, 36, 5, "N_4", n4, 1);
    put_signed(&d, 31, 22, "tau_GPS", time->tau_gps_s, ldexp(1, -30));
    put(&d, 9, 1, time->l_n);
    return seal(&d, 5, out);
}

static void fill_even(draft *d, const orr_glonass_almanac *a)
{
    put(d, 80, 1, a->operational);
    put_unsigned(d, 79, 2, "M_n", a->type, 1);
    put_unsigned(d, 77, 5, "n", a->number, 1);
    put_signed(d, 72, 10, "tau_n", a->tau_s, ORR_GLONASS_ALM_TAU_LSB_S);
    put_angle(d, 62, 21, "lambda_n", a->lambda_rad, ORR_GLONASS_ALM_ANGLE_LSB_RAD);
    put_signed(d, 41, 18, "delta i_n", a->delta_i_rad, ORR_GLONASS_ALM_ANGLE_LSB_RAD);
    put_unsigned(d, 23, 15, "epsilon_n", a->e, ORR_GLONASS_ALM_E_LSB);
}

static void fill_odd(draft *d, const orr_glonass_almanac *a) // channels below zero are 32 more (table 4.10)
{
    put_angle(d, 80, 16, "omega_n", a->omega_rad, ORR_GLONASS_ALM_OMEGA_LSB_RAD);
    put_unsigned(d, 64, 21, "t_lambda_n", a->t_lambda_s, ORR_GLONASS_ALM_T_LAMBDA_LSB_S);
    put_signed(d, 43, 22, "delta T_n", a->delta_t_s, ORR_GLONASS_ALM_DELTA_T_LSB_S);
    put_signed(d, 21, 7, "delta T_n'", a->delta_t_rate, ORR_GLONASS_ALM_RATE_LSB);
    if (a->channel < -7 || a->channel > 24) refuse(d, "H_n", a->channel, 5);
    put(d, 14, 5, (uint32_t)(a->channel + 32) % 32);
}

orr_status orr_glonass_encode_almanac(const orr_glonass_almanac *almanac, int string, bool l_n,
                                      orr_glonass_string *out, orr_diag *diag)
{
    draft d = {.diag = diag};
    if (string < 6 || string > 15) return orr_diag_set(diag, ORR_E_ARG, "string %d holds no almanac", string);
    if (almanac != NULL && (almanac->number < 1 || almanac->number > 24))
        return orr_diag_set(diag, ORR_E_ARG, "GLONASS almanacs are of slots 1 to 24");
    if (almanac != NULL && string % 2 == 0) fill_even(&d, almanac);
    if (almanac != NULL && string % 2 == 1) fill_odd(&d, almanac);
    if (string % 2 == 1) put(&d, 9, 1, l_n);
    return seal(&d, string, out);
}

orr_status orr_glonass_encode_utc(const orr_glonass_utc *utc, int string, bool l_n, orr_glonass_string *out,
                                  orr_diag *diag)
{
    draft d = {.diag = diag};
    if (string != 14 && string != 15)
        return orr_diag_set(diag, ORR_E_ARG, "UT1 is in strings 14 and 15 of the fifth frame");
    if (string == 15) {
        put(&d, 9, 1, l_n);
        return seal(&d, string, out);
    }
    if (utc->kp < -1 || utc->kp > 1)
        return orr_diag_set(diag, ORR_E_RANGE, "KP = %d is none of -1, 0, 1", utc->kp);
    put_signed(&d, 80, 11, "B1", utc->b1_s, ldexp(1, -10));
    put_signed(&d, 69, 10, "B2", utc->b2_s_per_day, ldexp(1, -16));
    put(&d, 59, 2, utc->kp < 0 ? 3 : (uint32_t)utc->kp);
    return seal(&d, string, out);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/lnav_bits.h"

#include <string.h>

#define SEMICIRCLE ORR_PI
#define PREAMBLE 0x8b

// A subframe while it is being filled: one entry a bit, numbered 1..300 as the figures of 20.3.3 number them.
typedef struct draft {
    uint8_t bit[301];
    orr_diag *diag;
    orr_status status;
} draft;

static void put(draft *d, int first, int n, uint32_t value)
{
    for (int k = 0; k < n; k++) d->bit[first + k] = (uint8_t)((value >> (n - 1 - k)) & 1u);
}

// A field divided over two places, most significant part first.
static void put_split(draft *d, int first1, int n1, int first2, int n2, uint32_t value)
{
    put(d, first1, n1, value >> n2);
    put(d, first2, n2, value & ((UINT32_C(1) << n2) - 1));
}

// value / lsb as an integer of n bits; the first failure is kept.
static uint32_t quantised(draft *d, const char *name, double value, double lsb, int n, bool is_signed)
{
    double whole = round(value / lsb), top = ldexp(1.0, is_signed ? n - 1 : n);
    if (!(whole < top && whole >= (is_signed ? -top : 0))) {
        if (d->status == ORR_OK)
            d->status =
                orr_diag_set(d->diag, ORR_E_RANGE, "%s = %.10g does not fit its %d bits", name, value, n);
        return 0;
    }
    return n == 32 ? (uint32_t)(int64_t)whole : (uint32_t)(int64_t)whole & ((UINT32_C(1) << n) - 1);
}

static double angle(double rad) { return remainder(rad, 2 * SEMICIRCLE); } // [-pi, pi]

// An angle of 32 or 24 bits; +pi and -pi are the same place, and only the latter can be sent.
static uint32_t semicircles(draft *d, const char *name, double rad, int power, int n)
{
    double lsb = SEMICIRCLE * ldexp(1.0, -power), a = angle(rad);
    if (round(a / lsb) >= ldexp(1.0, n - 1)) a -= 2 * SEMICIRCLE;
    return quantised(d, name, a, lsb, n, true);
}

// The six parity equations of table 20-XIV, as masks over d1..d24 (d1 the highest of 24 bits), and whether
// D29* or D30* is added.
static uint32_t parity_of(uint32_t data, bool d29, bool d30)
{
    static const struct {
        uint8_t member[16];
        bool from29;
    } equation[6] = {
        {{1, 2, 3, 5, 6, 10, 11, 12, 13, 14, 17, 18, 20, 23}, true},
        {{2, 3, 4, 6, 7, 11, 12, 13, 14, 15, 18, 19, 21, 24}, false},
        {{1, 3, 4, 5, 7, 8, 12, 13, 14, 15, 16, 19, 20, 22}, true},
        {{2, 4, 5, 6, 8, 9, 13, 14, 15, 16, 17, 20, 21, 23}, false},
        {{1, 3, 5, 6, 7, 9, 10, 14, 15, 16, 17, 18, 21, 22, 24}, false},
        {{3, 5, 6, 8, 9, 10, 11, 13, 15, 19, 22, 23, 24}, true},
    };
    uint32_t word = d30 ? ~data & 0xffffffu : data & 0xffffffu;
    uint32_t parity = 0;
    for (int e = 0; e < 6; e++) {
        uint32_t sum = equation[e].from29 ? d29 : d30;
        for (int k = 0; k < 16 && equation[e].member[k] != 0; k++)
            sum ^= data >> (24 - equation[e].member[k]) & 1u;
        parity = parity << 1 | (sum & 1u);
    }
    return word << 6 | parity;
}

// Words 2 and 10 end in 00: their bits 23 and 24 are solved for (20.3.3.2). Two bits, four trials.
static uint32_t word_ending_in_zeros(uint32_t data, bool d29, bool d30)
{
    for (uint32_t t = 0; t < 4; t++) {
        uint32_t w = parity_of((data & ~UINT32_C(3)) | t, d29, d30);
        if ((w & 3u) == 0) return w;
    }
    return parity_of(data, d29, d30); // not reached: D29 and D30 depend on d23 and d24 independently
}

// TLM and HOW in, parity over all.
static orr_status seal(draft *d, int number, const orr_lnav_how *how, orr_lnav_subframe *out)
{
    if (d->status != ORR_OK) return d->status;
    if (how->tow_count > 100799)
        return orr_diag_set(d->diag, ORR_E_RANGE, "TOW count %u is beyond the week's 100800 epochs",
                            (unsigned)how->tow_count);
    put(d, 1, 8, PREAMBLE);
    put(d, 9, 14, how->tlm_message & 0x3fff);
    put(d, 31, 17, how->tow_count);
    put(d, 48, 1, how->alert);
    put(d, 49, 1, how->anti_spoof);
    put(d, 50, 3, (uint32_t)number);
    bool d29 = false, d30 = false;
    for (int w = 0; w < 10; w++) {
        uint32_t data = 0;
        for (int k = 1; k <= 24; k++) data = data << 1 | d->bit[30 * w + k];
        out->word[w] = w == 1 || w == 9 ? word_ending_in_zeros(data, d29, d30) : parity_of(data, d29, d30);
        d29 = out->word[w] >> 1 & 1u;
        d30 = out->word[w] & 1u;
    }
    return ORR_OK;
}

static void fill_clock(draft *d, const orr_nav_eph *e, const orr_lnav_how *how) // figure 20-1, subframe 1
{
    int32_t week;
    int64_t toc_ns;
    orr_time_week(e->toc, &week, &toc_ns);
    uint32_t iodc = e->iodc >= 0 ? (uint32_t)e->iodc & 0x3ff : 0;
    double tgd = isfinite(e->delay.tgd_s) ? e->delay.tgd_s : 0;
    put(d, 61, 10, (uint32_t)how->week & 0x3ff); // the current one (20.3.3.3.1.1), whatever toe's is
    put(d, 71, 2, e->data_sources & 3u ? e->data_sources & 3u : 1u); // P code on L2 unless told
    put(d, 73, 4, (uint32_t)orr_nav_ura_index(e->accuracy_m));
    put(d, 77, 6, e->health & 0x3f);
    put_split(d, 83, 2, 211, 8, iodc);
    put(d, 91, 1, e->l2p_flag > 0);
    put(d, 197, 8, quantised(d, "TGD", tgd, ldexp(1, -31), 8, true));
    put(d, 219, 16, quantised(d, "toc", (double)toc_ns * 1e-9, 16, 16, false));
    put(d, 241, 8, quantised(d, "af2", e->af2_sps2, ldexp(1, -55), 8, true));
    put(d, 249, 16, quantised(d, "af1", e->af1_sps, ldexp(1, -43), 16, true));
    put(d, 271, 22, quantised(d, "af0", e->af0_s, ldexp(1, -31), 22, true));
}

static void fill_orbit_1(draft *d, const orr_nav_eph *e) // subframe 2
{
    const orr_nav_kepler *k = &e->kepler;
    put(d, 61, 8, e->iode >= 0 ? (uint32_t)e->iode & 0xff : 0);
    put(d, 69, 16, quantised(d, "Crs", k->crs_m, ldexp(1, -5), 16, true));
    put(d, 91, 16, quantised(d, "delta n", k->delta_n_radps, SEMICIRCLE * ldexp(1, -43), 16, true));
    put_split(d, 107, 8, 121, 24, semicircles(d, "M0", k->m0_rad, 31, 32));
    put(d, 151, 16, quantised(d, "Cuc", k->cuc_rad, ldexp(1, -29), 16, true));
    put_split(d, 167, 8, 181, 24, quantised(d, "e", k->e, ldexp(1, -33), 32, false));
    put(d, 211, 16, quantised(d, "Cus", k->cus_rad, ldexp(1, -29), 16, true));
    put_split(d, 227, 8, 241, 24, quantised(d, "sqrt(A)", k->sqrt_a_sqrtm, ldexp(1, -19), 32, false));
    put(d, 271, 16, quantised(d, "toe", k->toe_sow_s, 16, 16, false));
    put(d, 287, 1, e->fit_interval_h > (orr_sat_system(e->sat) == 'J' ? 2 : 4));
    put(d, 288, 5, 0x1f); // AODO 31: no navigation message correction table
}

static void fill_orbit_2(draft *d, const orr_nav_eph *e) // subframe 3
{
    const orr_nav_kepler *k = &e->kepler;
    put(d, 61, 16, quantised(d, "Cic", k->cic_rad, ldexp(1, -29), 16, true));
    put_split(d, 77, 8, 91, 24, semicircles(d, "OMEGA0", k->omega0_rad, 31, 32));
    put(d, 121, 16, quantised(d, "Cis", k->cis_rad, ldexp(1, -29), 16, true));
    put_split(d, 137, 8, 151, 24, semicircles(d, "i0", k->i0_rad, 31, 32));
    put(d, 181, 16, quantised(d, "Crc", k->crc_m, ldexp(1, -5), 16, true));
    put_split(d, 197, 8, 211, 24, semicircles(d, "omega", k->omega_rad, 31, 32));
    put(d, 241, 24, quantised(d, "OMEGADOT", k->omega_dot_radps, SEMICIRCLE * ldexp(1, -43), 24, true));
    put(d, 271, 8, e->iode >= 0 ? (uint32_t)e->iode & 0xff : 0);
    put(d, 279, 14, quantised(d, "IDOT", k->idot_radps, SEMICIRCLE * ldexp(1, -43), 14, true));
}

orr_status orr_lnav_encode_ephemeris(const orr_nav_eph *eph, int number, const orr_lnav_how *how,
                                     orr_lnav_subframe *out, orr_diag *diag)
{
    draft d = {.diag = diag};
    if (eph->kind != ORR_NAV_KEPLER) return orr_diag_set(diag, ORR_E_ARG, "LNAV carries Kepler elements");
    switch (number) {
    case 1:
        fill_clock(&d, eph, how);
        break;
    case 2:
        fill_orbit_1(&d, eph);
        break;
    case 3:
        fill_orbit_2(&d, eph);
        break;
    default:
        return orr_diag_set(diag, ORR_E_ARG, "subframe %d holds no ephemeris", number);
    }
    return seal(&d, number, how, out);
}

static void put_page(draft *d, uint32_t sv_id, const orr_lnav_how *how)
{
    put(d, 61, 2, how->qzss ? 3 : 1); // data ID of the present structure
    put(d, 63, 6, sv_id);
}

orr_status orr_lnav_encode_page18(const double alpha[4], const double beta[4], const orr_nav_utc *utc,
                                  const orr_lnav_how *how, orr_lnav_subframe *out, orr_diag *diag)
{
    static const int alpha_power[4] = {-30, -27, -24, -24}, beta_power[4] = {11, 14, 16, 16};
    static const int place[8] = {69, 77, 91, 99, 107, 121, 129, 137};
    static const char *const name[8] = {"alpha0", "alpha1", "alpha2", "alpha3",
                                        "beta0",  "beta1",  "beta2",  "beta3"};
    draft d = {.diag = diag};
    int32_t week;
    int64_t ns;
    orr_time_week(utc->reference, &week, &ns);
    put_page(&d, 56, how);
    for (int k = 0; k < 4; k++) {
        put(&d, place[k], 8, quantised(&d, name[k], alpha[k], ldexp(1, alpha_power[k]), 8, true));
        put(&d, place[4 + k], 8, quantised(&d, name[4 + k], beta[k], ldexp(1, beta_power[k]), 8, true));
    }
    put(&d, 151, 24, quantised(&d, "A1", utc->a1_sps, ldexp(1, -50), 24, true));
    put_split(&d, 181, 24, 211, 8, quantised(&d, "A0", utc->a0_s, ldexp(1, -30), 32, true));
    put(&d, 219, 8, quantised(&d, "tot", (double)(ns / ORR_NS_PER_S), 4096, 8, false));
    put(&d, 227, 8, (uint32_t)week & 0xff);
    put(&d, 241, 8, quantised(&d, "leap seconds", utc->leap_s, 1, 8, true));
    put(&d, 249, 8, (uint32_t)utc->week_lsf & 0xff);
    put(&d, 257, 8, quantised(&d, "day of the leap second", utc->day, 1, 8, false));
    put(&d, 271, 8, quantised(&d, "future leap seconds", utc->leap_future_s, 1, 8, true));
    return seal(&d, 4, how, out);
}

orr_status orr_lnav_encode_almanac(const orr_almanac *a, const orr_lnav_how *how, int *subframe, int *page,
                                   orr_lnav_subframe *out, orr_diag *diag)
{
    static const int page4[8] = {2, 3, 4, 5, 7, 8, 9, 10};
    draft d = {.diag = diag};
    if (a->number < 1 || a->number > (how->qzss ? 10 : 32))
        return orr_diag_set(diag, ORR_E_ARG, "LNAV almanacs are of satellites 1 to 32, of QZSS 1 to 10");
    const orr_almanac_lattice *l = orr_almanac_lattice_of(orr_sat_make(how->qzss ? 'J' : 'G', a->number));
    const double e_reference = orr_almanac_field(l, ORR_ALMANAC_E)->base;
    *subframe = a->number <= 24 ? 5 : 4;
    *page = a->number <= 24 ? a->number : page4[a->number - 25];
    put_page(&d, (uint32_t)a->number, how);
    put(&d, 69, 16, quantised(&d, "e", a->e - e_reference, ldexp(1, -21), 16, false));
    put(&d, 91, 8, quantised(&d, "toa", a->toa_s, 4096, 8, false));
    put(&d, 99, 16, quantised(&d, "delta i", a->i_offset_rad, SEMICIRCLE * ldexp(1, -19), 16, true));
    put(&d, 121, 16, quantised(&d, "OMEGADOT", a->omega_dot_radps, SEMICIRCLE * ldexp(1, -38), 16, true));
    put(&d, 137, 8, a->health & 0xff);
    put(&d, 151, 24, quantised(&d, "sqrt(A)", a->sqrt_a_sqrtm, ldexp(1, -11), 24, false));
    put(&d, 181, 24, semicircles(&d, "OMEGA0", a->omega0_rad, 23, 24));
    put(&d, 211, 24, semicircles(&d, "omega", a->omega_rad, 23, 24));
    put(&d, 241, 24, semicircles(&d, "M0", a->m0_rad, 23, 24));
    uint32_t af0 = quantised(&d, "af0", a->af0_s, ldexp(1, -20), 11, true);
    put(&d, 271, 8, af0 >> 3);
    put(&d, 279, 11, quantised(&d, "af1", a->af1_sps, ldexp(1, -38), 11, true));
    put(&d, 290, 3, af0 & 7);
    return seal(&d, *subframe, how, out);
}

orr_status orr_lnav_encode_spare(int subframe, uint32_t sv_id, const orr_lnav_how *how,
                                 orr_lnav_subframe *out, orr_diag *diag)
{
    draft d = {.diag = diag};
    if (subframe != 4 && subframe != 5)
        return orr_diag_set(diag, ORR_E_ARG, "subframe %d has no pages", subframe);
    for (int k = 69; k <= 300; k++) d.bit[k] = (uint8_t)(k % 2);
    put_page(&d, sv_id, how);
    return seal(&d, subframe, how, out);
}

orr_status orr_lnav_encode_page25(int number, uint32_t toa_s, int32_t week, const uint8_t config[32],
                                  const uint8_t health[32], const orr_lnav_how *how, orr_lnav_subframe *out,
                                  orr_diag *diag)
{
    draft d = {.diag = diag};
    if (number == 5) { // health of 1-24: four a word, words 4 to 9
        put_page(&d, 51, how);
        put(&d, 69, 8, quantised(&d, "toa", toa_s, 4096, 8, false));
        put(&d, 77, 8, (uint32_t)week & 0xff);
        for (int k = 0; k < 24; k++) put(&d, 91 + 30 * (k / 4) + 6 * (k % 4), 6, health[k] & 0x3f);
        return seal(&d, 5, how, out);
    }
    if (number != 4) return orr_diag_set(diag, ORR_E_ARG, "page 25 is of subframe 4 or 5");
    put_page(&d, 63, how);
    int bit = 69; // A-S flag and configuration of 32 satellites, four bits each: 4 in word 3, 6 in words 4-7,
                  // 4 in word 8
    for (int k = 0; k < 32; k++) {
        put(&d, bit, 4, config[k]);
        bit += 4;
        if ((bit - 1) % 30 >= 24) bit += 30 - (bit - 1) % 30;
    }
    // Health of 25 after the last configuration in word 8, then 26-29 in word 9 and 30-32 in word 10.
    put(&d, 229, 6, health[24] & 0x3f);
    for (int k = 0; k < 4; k++) put(&d, 241 + 6 * k, 6, health[25 + k] & 0x3f);
    for (int k = 0; k < 3; k++) put(&d, 271 + 6 * k, 6, health[29 + k] & 0x3f);
    return seal(&d, 4, how, out);
}

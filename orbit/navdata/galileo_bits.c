// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/galileo_bits.h"

#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/modern_blocks.h"
#include "orbit/navdata/reed_solomon.h"

#define GST_WEEK_0 1024 // GPS week
#define OUT_OF_SERVICE 1u

static const orr_navfit_field ai0 = ORR_UNSIGNED("ai0", P2(2), 11), ai1 = ORR_SIGNED("ai1", P2(8), 11),
                              ai2 = ORR_SIGNED("ai2", P2(15), 14), bgd = ORR_SIGNED("BGD", P2(32), 10),
                              a0 = ORR_SIGNED("A0", P2(30), 32), a1 = ORR_SIGNED("A1", P2(50), 24);

static void put_time(const orr_galileo_page *g, orr_page *p)
{
    int32_t week;
    int64_t ns;
    orr_time_week(g->t, &week, &ns);
    orr_page_put(p, 12, (uint64_t)(week - GST_WEEK_0));
    orr_page_put(p, 20, (uint64_t)(ns / ORR_NS_PER_S));
}

static void put_tow(const orr_galileo_page *g, orr_page *p)
{
    int32_t week;
    int64_t ns;
    orr_time_week(g->t, &week, &ns);
    orr_page_put(p, 20, (uint64_t)(ns / ORR_NS_PER_S));
}

static void put_element(const orr_galileo_page *g, size_t element, orr_page *p)
{
    const orr_nav_kepler *k = &g->eph->kepler;
    const double value[] = {k->sqrt_a_sqrtm, k->e,          k->omega_rad,       k->m0_rad,
                            k->i0_rad,       k->omega0_rad, k->omega_dot_radps, k->delta_n_radps,
                            k->idot_radps,   k->crc_m,      k->crs_m,           k->cuc_rad,
                            k->cus_rad,      k->cic_rad,    k->cis_rad};
    const orr_kepler_lattice *l = orr_kepler_lattice_of(g->eph->sat, g->eph->message);
    orr_page_value(p, &l->element[element], value[element]);
}

static void put_toe(const orr_galileo_page *g, orr_page *p)
{
    orr_page_value(p, &orr_kepler_lattice_of(g->eph->sat, g->eph->message)->toe, g->eph->kepler.toe_sow_s);
}

static void put_iodnav(const orr_galileo_page *g, orr_page *p)
{
    orr_page_put(p, 10, (uint64_t)g->eph->iode & 0x3ff);
}

static void put_sisa(const orr_galileo_page *g, orr_page *p)
{
    orr_page_put(p, 8, (uint64_t)orr_nav_sisa_index(g->eph->accuracy_m));
}

static void put_ionosphere(const orr_galileo_page *g, orr_page *p)
{
    orr_page_value(p, &ai0, g->ai[0]);
    orr_page_value(p, &ai1, g->ai[1]);
    orr_page_value(p, &ai2, g->ai[2]);
    orr_page_zeros(p, 5); // no ionospheric disturbance in any region
}

static uint64_t status_of(const orr_nav_eph *eph) { return eph->health != 0 ? OUT_OF_SERVICE : 0; }

// t0t, WN0t, WN_LSF, DN, delta t_LSF behind A0, A1 and delta t_LS.
static void put_utc(const orr_galileo_page *g, orr_page *p)
{
    const orr_nav_utc *u = &g->utc;
    int32_t week;
    int64_t ns;
    orr_time_week(u->reference, &week, &ns);
    orr_page_value(p, &a0, u->a0_s);
    orr_page_value(p, &a1, u->a1_sps);
    orr_page_put(p, 8, (uint64_t)u->leap_s);
    orr_page_put(p, 8, (uint64_t)(ns / (3600 * ORR_NS_PER_S)));
    orr_page_put(p, 8, (uint64_t)(week - GST_WEEK_0));
    orr_page_put(p, 8, (uint64_t)(u->week_lsf - GST_WEEK_0));
    orr_page_put(p, 3, (uint64_t)u->day);
    orr_page_put(p, 8, (uint64_t)u->leap_future_s);
}

// GST less GPS time: zero. t0G and WN0G are those of UTC.
static void put_ggto_time(const orr_galileo_page *g, orr_page *p)
{
    int32_t week;
    int64_t ns;
    orr_time_week(g->utc.reference, &week, &ns);
    orr_page_put(p, 8, (uint64_t)(ns / (3600 * ORR_NS_PER_S)));
}

static void put_ggto_week(const orr_galileo_page *g, orr_page *p)
{
    int32_t week;
    int64_t ns;
    orr_time_week(g->utc.reference, &week, &ns);
    orr_page_put(p, 6, (uint64_t)(week - GST_WEEK_0));
}

// IODa, and with `dated` WNa and t0a.
static void put_almanac_head(const orr_galileo_page *g, bool dated, orr_page *p)
{
    orr_page_put(p, 4, (uint64_t)g->iod_a);
    if (!dated) return;
    orr_page_put(p, 2, (uint64_t)(g->almanac_week - GST_WEEK_0));
    orr_page_put(p, 10, g->toa_s / 600);
}

// A parameter of the k-th satellite; zeros where there is none.
static void put_almanac(const orr_galileo_page *g, int k, orr_almanac_part part, orr_page *p)
{
    const orr_almanac *a = g->almanac[k];
    const orr_navfit_field *f = orr_almanac_field(orr_almanac_lattice_of(orr_sat_make('E', 1)), part);
    if (a == NULL) {
        orr_page_zeros(p, f->bits);
        return;
    }
    double value[ORR_ALMANAC_PARTS];
    orr_almanac_values(a, value);
    orr_page_value(p, f, value[part]);
}

static void put_almanac_sat(const orr_galileo_page *g, int k, orr_page *p)
{
    orr_page_put(p, 6, g->almanac[k] != NULL ? (uint64_t)g->almanac[k]->number : 0);
}

static void put_almanac_parts(const orr_galileo_page *g, int k, const orr_almanac_part *part, size_t n,
                              orr_page *p)
{
    for (size_t i = 0; i < n; i++) put_almanac(g, k, part[i], p);
}

static void put_almanac_health(const orr_galileo_page *g, int k, int fields, orr_page *p)
{
    for (int i = 0; i < fields; i++)
        orr_page_put(p, 2, g->almanac[k] != NULL && g->almanac[k]->health != 0 ? OUT_OF_SERVICE : 0);
}

// The order in which almanacs are sent, behind the satellite's number.
static const orr_almanac_part order[] = {ORR_ALMANAC_SQRT_A,  ORR_ALMANAC_E,      ORR_ALMANAC_OMEGA,
                                         ORR_ALMANAC_DELTA_I, ORR_ALMANAC_OMEGA0, ORR_ALMANAC_OMEGA_DOT,
                                         ORR_ALMANAC_M0,      ORR_ALMANAC_AF0,    ORR_ALMANAC_AF1};

// --- I/NAV ---

// Word 16 (5.1.11): osculating elements at t0r, one second after the begin of the sub-frame's half minute.
static void put_reduced(const orr_galileo_page *g, orr_page *p)
{
    static const orr_navfit_field field_a = {"delta A_red", 256, 5, ORR_FIELD_SIGNED, 29600000.0},
                                  field_ex = ORR_SIGNED("e_x", P2(22), 13),
                                  field_ey = ORR_SIGNED("e_y", P2(22), 13),
                                  field_i = {"delta i_0", SEMICIRCLE * P2(22), 17, ORR_FIELD_SIGNED,
                                             56 * ORR_RAD_PER_DEG},
                                  field_node = ORR_ANGLE("OMEGA_0 red", 22, 23),
                                  field_lambda = ORR_ANGLE("lambda_0 red", 22, 23),
                                  field_af0 = ORR_SIGNED("af0 red", P2(26), 22),
                                  field_af1 = ORR_SIGNED("af1 red", P2(35), 6);
    int32_t week;
    int64_t ns;
    orr_time_week(g->t, &week, &ns);
    const int64_t half_minute = 30 * ORR_NS_PER_S, into = ns % half_minute - ORR_NS_PER_S;
    const double t0r_s = (double)((ns - ns % half_minute) / ORR_NS_PER_S + 1);
    orr_broadcast_state s;
    orr_kepler el;
    double gm, rate;
    orr_broadcast_constants('E', &gm, &rate);
    orr_status status = orr_broadcast_eval(g->eph, g->t - into, &s);
    const orr_vec3 v = orr_vec3_add(s.vel_mps, orr_vec3_make(-rate * s.pos_m.y, rate * s.pos_m.x, 0));
    if (status == ORR_OK) status = orr_kepler_from_state(s.pos_m, v, gm, &el);
    if (status != ORR_OK) {
        p->status = status;
        return;
    }
    orr_page_value(p, &field_a, orr_navfit_clamped(&field_a, el.a_m)); // E14 and E18 are 1600 km lower
    orr_page_value(p, &field_ex, orr_navfit_clamped(&field_ex, el.e * cos(el.argp_rad)));
    orr_page_value(p, &field_ey, orr_navfit_clamped(&field_ey, el.e * sin(el.argp_rad)));
    orr_page_value(p, &field_i, orr_navfit_clamped(&field_i, el.i_rad));
    orr_page_value(p, &field_node, el.raan_rad + rate * t0r_s);
    orr_page_value(p, &field_lambda, el.argp_rad + el.m_rad);
    orr_page_value(p, &field_af0, s.clock_s);
    orr_page_value(p, &field_af1, orr_navfit_clamped(&field_af1, s.clock_rate_sps));
}

static void put_elements(const orr_galileo_page *g, const uint8_t *element, size_t n, orr_page *p)
{
    for (size_t k = 0; k < n; k++) put_element(g, element[k], p);
}

static void word_1(const orr_galileo_page *g, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_LAMBDA, ORR_KEPLER_EX, ORR_KEPLER_SQRT_A};
    put_iodnav(g, p);
    put_toe(g, p);
    put_elements(g, list, 3, p);
    orr_page_zeros(p, 2);
}

static void word_2(const orr_galileo_page *g, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_OMEGA0, ORR_KEPLER_I0, ORR_KEPLER_EY, ORR_KEPLER_IDOT};
    put_iodnav(g, p);
    put_elements(g, list, 4, p);
    orr_page_zeros(p, 2);
}

static void word_3(const orr_galileo_page *g, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_OMEGA_DOT, ORR_KEPLER_DELTA_N, ORR_KEPLER_CUC,
                                   ORR_KEPLER_CUS,       ORR_KEPLER_CRC,     ORR_KEPLER_CRS};
    put_iodnav(g, p);
    put_elements(g, list, 6, p);
    put_sisa(g, p);
}

static void word_4(const orr_galileo_page *g, orr_page *p)
{
    put_iodnav(g, p);
    orr_page_put(p, 6, (uint64_t)orr_sat_number(g->eph->sat));
    put_element(g, ORR_KEPLER_CIC, p);
    put_element(g, ORR_KEPLER_CIS, p);
    orr_modern_clock(g->eph, p);
    orr_page_zeros(p, 2);
}

static void word_5(const orr_galileo_page *g, orr_page *p)
{
    put_ionosphere(g, p);
    orr_page_value(p, &bgd, g->eph->delay.bgd_e5a_e1_s);
    orr_page_value(p, &bgd, g->eph->delay.bgd_e5b_e1_s);
    orr_page_put(p, 2, status_of(g->eph)); // E5b
    orr_page_put(p, 2, status_of(g->eph)); // E1-B
    orr_page_zeros(p, 2);                  // data are valid
    put_time(g, p);
    orr_page_zeros(p, 23);
}

static void word_6(const orr_galileo_page *g, orr_page *p)
{
    put_utc(g, p);
    put_tow(g, p);
    orr_page_zeros(p, 3);
}

static void word_7(const orr_galileo_page *g, orr_page *p)
{
    put_almanac_head(g, true, p);
    put_almanac_sat(g, 0, p);
    put_almanac_parts(g, 0, order, 7, p);
    orr_page_zeros(p, 6);
}

static void word_8(const orr_galileo_page *g, orr_page *p)
{
    put_almanac_head(g, false, p);
    put_almanac_parts(g, 0, order + 7, 2, p);
    put_almanac_health(g, 0, 2, p);
    put_almanac_sat(g, 1, p);
    put_almanac_parts(g, 1, order, 6, p);
    orr_page_zeros(p, 1);
}

static void word_9(const orr_galileo_page *g, orr_page *p)
{
    put_almanac_head(g, true, p);
    put_almanac_parts(g, 1, order + 6, 3, p);
    put_almanac_health(g, 1, 2, p);
    put_almanac_sat(g, 2, p);
    put_almanac_parts(g, 2, order, 4, p);
}

static void word_10(const orr_galileo_page *g, orr_page *p)
{
    put_almanac_head(g, false, p);
    put_almanac_parts(g, 2, order + 4, 5, p);
    put_almanac_health(g, 2, 2, p);
    orr_page_zeros(p, 16 + 12); // A0G, A1G
    put_ggto_time(g, p);
    put_ggto_week(g, p);
}

// Words 17 to 20 (5.1.12): Reed-Solomon parity of words 1 to 4, in each 15 octets: one octet, two bits of IODnav, the other
// fourteen octets. The information is all of word 1 and what follows IODnav in words 2 to 4.
enum { RS_INFORMATION = 58 };
static void put_reed_solomon(const orr_galileo_page *g, int type, orr_page *p)
{
    orr_page word, all;
    uint8_t information[RS_INFORMATION], parity[ORR_REED_SOLOMON_PARITY];
    orr_page_begin(&all, NULL);
    for (int w = 1; w <= 4; w++) {
        orr_inav_word(g, w, &word);
        if (word.status != ORR_OK) {
            p->status = word.status;
            return;
        }
        if (w ==
            1) { // the two lowest bits of IODnav, which words 17 to 20 have too, change places with the others
            orr_page_copy(&all, &word, 0, 6);
            orr_page_copy(&all, &word, 14, 2);
            orr_page_copy(&all, &word, 6, 8);
        }
        orr_page_copy(&all, &word, 16, 112);
    }
    orr_page_pack(&all, information);
    orr_reed_solomon(information, RS_INFORMATION, parity);
    const uint8_t *own = parity + (type - 17) * 15;
    orr_page_put(p, 8, own[0]);
    orr_page_put(p, 2, (uint64_t)g->eph->iode & 3);
    for (int k = 1; k < 15; k++) orr_page_put(p, 8, own[k]);
}

void orr_inav_word(const orr_galileo_page *g, int type, orr_page *p)
{
    static void (*const fill[])(const orr_galileo_page *, orr_page *) = {
        NULL, word_1, word_2, word_3, word_4, word_5, word_6, word_7, word_8, word_9, word_10};
    orr_page_begin(p, p->diag);
    orr_page_put(p, 6, (uint64_t)type);
    if (type >= 1 && type <= 10) {
        fill[type](g, p);
    } else if (type == 16) {
        put_reduced(g, p);
    } else if (type >= 17 && type <= 20) {
        put_reed_solomon(g, type, p);
    } else { // the time and nothing else
        orr_page_put(p, 2, 2);
        orr_page_zeros(p, 88);
        put_time(g, p);
    }
}

void orr_inav_page(const orr_page *word, int ssp, orr_page *page)
{
    static const uint8_t pattern[] = {0, 0x04, 0x2b, 0x2f};
    orr_page protected_bits;
    orr_page_begin(&protected_bits, NULL);
    orr_page_put(&protected_bits, 2, 0); // even, nominal
    orr_page_copy(&protected_bits, word, 0, 112);
    orr_page_put(&protected_bits, 2, 2); // odd, nominal
    orr_page_copy(&protected_bits, word, 112, 16);
    orr_page_zeros(&protected_bits, 64); // OSNMA, search and rescue, spare
    orr_page_crc24q(&protected_bits, 0);
    orr_page_begin(page, NULL);
    orr_page_copy(page, &protected_bits, 0, 114);
    orr_page_zeros(page, 6);
    orr_page_copy(page, &protected_bits, 114, 106);
    orr_page_put(page, 8, pattern[ssp]);
    orr_page_zeros(page, 6);
}

// Bits from `from` on, as many as `n`, coded and interleaved in columns of eight, behind a pattern of synchronisation.
static void symbols_of(const orr_page *page, size_t from, size_t n, int sync_bits, uint64_t sync,
                       orr_page *symbols)
{
    unsigned state = 0;
    orr_page part;
    orr_page_begin(&part, NULL);
    orr_page_copy(&part, page, from, n);
    orr_page_put(symbols, sync_bits, sync);
    orr_page_convolve(symbols, &part, 0, true, &state);
    orr_page_interleave(symbols, 8, n / 4);
}

void orr_inav_symbols(const orr_page *page, orr_page *symbols)
{
    orr_page_begin(symbols, NULL);
    symbols_of(page, 0, 120, 10, 0x160, symbols); // 0101100000
    symbols_of(page, 120, 120, 10, 0x160, symbols);
}

// --- F/NAV ---

static void page_1(const orr_galileo_page *g, orr_page *p)
{
    orr_page_put(p, 6, (uint64_t)orr_sat_number(g->eph->sat));
    put_iodnav(g, p);
    orr_modern_clock(g->eph, p);
    put_sisa(g, p);
    put_ionosphere(g, p);
    orr_page_value(p, &bgd, g->eph->delay.bgd_e5a_e1_s);
    orr_page_put(p, 2, status_of(g->eph));
    put_time(g, p);
    orr_page_zeros(p, 1 + 26); // data are valid; spare
}

static void page_2(const orr_galileo_page *g, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_LAMBDA, ORR_KEPLER_OMEGA_DOT, ORR_KEPLER_EX,
                                   ORR_KEPLER_SQRT_A, ORR_KEPLER_OMEGA0,    ORR_KEPLER_IDOT};
    put_iodnav(g, p);
    put_elements(g, list, 6, p);
    put_time(g, p);
}

static void page_3(const orr_galileo_page *g, orr_page *p)
{
    static const uint8_t list[] = {ORR_KEPLER_I0,  ORR_KEPLER_EY,  ORR_KEPLER_DELTA_N, ORR_KEPLER_CUC,
                                   ORR_KEPLER_CUS, ORR_KEPLER_CRC, ORR_KEPLER_CRS};
    put_iodnav(g, p);
    put_elements(g, list, 7, p);
    put_toe(g, p);
    put_time(g, p);
    orr_page_zeros(p, 8);
}

static void page_4(const orr_galileo_page *g, orr_page *p)
{
    put_iodnav(g, p);
    put_element(g, ORR_KEPLER_CIC, p);
    put_element(g, ORR_KEPLER_CIS, p);
    put_utc(g, p);
    put_ggto_time(g, p);
    orr_page_zeros(p, 16 + 12); // A0G, A1G
    put_ggto_week(g, p);
    put_tow(g, p);
    orr_page_zeros(p, 5);
}

// Pages 5 and 6 have two almanacs and a half between them; the node of the second is divided over both.
static void page_5(const orr_galileo_page *g, orr_page *p)
{
    orr_page node;
    put_almanac_head(g, true, p);
    put_almanac_sat(g, 0, p);
    put_almanac_parts(g, 0, order, 9, p);
    put_almanac_health(g, 0, 1, p);
    put_almanac_sat(g, 1, p);
    put_almanac_parts(g, 1, order, 4, p);
    orr_page_begin(&node, NULL);
    put_almanac(g, 1, ORR_ALMANAC_OMEGA0, &node);
    orr_page_copy(p, &node, 0, 4);
}

static void page_6(const orr_galileo_page *g, orr_page *p)
{
    orr_page node;
    put_almanac_head(g, false, p);
    orr_page_begin(&node, NULL);
    put_almanac(g, 1, ORR_ALMANAC_OMEGA0, &node);
    orr_page_copy(p, &node, 4, 12);
    put_almanac_parts(g, 1, order + 5, 4, p);
    put_almanac_health(g, 1, 1, p);
    put_almanac_sat(g, 2, p);
    put_almanac_parts(g, 2, order, 9, p);
    put_almanac_health(g, 2, 1, p);
    orr_page_zeros(p, 3);
}

void orr_fnav_page(const orr_galileo_page *g, int type, orr_page *p)
{
    static void (*const fill[])(const orr_galileo_page *, orr_page *) = {NULL,   page_1, page_2, page_3,
                                                                         page_4, page_5, page_6};
    orr_page_begin(p, p->diag);
    orr_page_put(p, 6, (uint64_t)type);
    fill[type](g, p);
    orr_page_crc24q(p, 0);
    orr_page_zeros(p, 6);
}

void orr_fnav_symbols(const orr_page *page, orr_page *symbols)
{
    orr_page_begin(symbols, NULL);
    symbols_of(page, 0, 244, 12, 0xb70, symbols); // 101101110000
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Group delays against the clock's pair of signals: what must hold whatever the biases are.
#include "testing.h"

#include "orbit/spacecraft/signal_delay.h"

typedef struct line {
    const char *sat, *obs1, *obs2;
    double ns;
} line;

#define MAX_LINES 16

static orr_time noon;

static void make(const line *l, size_t n, orr_bias *b, orr_bias_set *x)
{
    assert_int_equal(orr_time_parse("2024-02-04T12:00", NULL, &noon, NULL), ORR_OK);
    *x = (orr_bias_set){.n = n,
                        .bias = b,
                        .from = noon - 43200 * ORR_NS_PER_S,
                        .until = noon + 43199 * ORR_NS_PER_S}; // as GRG writes a day's end
    for (size_t i = 0; i < n; i++) {
        b[i] = (orr_bias){.kind = l[i].obs2 == NULL ? ORR_BIAS_OSB : ORR_BIAS_DSB,
                          .sat = orr_sat_parse(l[i].sat),
                          .from = x->from,
                          .until = x->until,
                          .value_s = l[i].ns * 1e-9,
                          .slope_sps = (double)NAN};
        snprintf(b[i].obs1, sizeof b[i].obs1, "%s", l[i].obs1);
        snprintf(b[i].obs2, sizeof b[i].obs2, "%s", l[i].obs2 == NULL ? "" : l[i].obs2);
    }
}

static double delay(const orr_bias_set *x, const char *sat, const char *signal)
{
    double d = (double)NAN;
    assert_int_equal(orr_signal_delay_osb(x, orr_sat_parse(sat), signal, noon, &d), ORR_OK);
    return d;
}

// The pair's own ionosphere-free combination has no delay; differences of delays are those of the biases.
static void the_clocks_pair_has_no_delay(void **state)
{
    (void)state;
    static const struct {
        const char *sat, *obs1, *obs2, *other;
        double f1, f2;
    } k[] = {
        {"G05", "C1W", "C2W", "C1C", 1575.42, 1227.60},  {"R03", "C1P", "C2P", "C1C", 1605.375, 1248.625},
        {"E11", "C1C", "C5Q", "C7Q", 1575.42, 1176.45},  {"E12", "C1X", "C5X", "C7X", 1575.42, 1176.45},
        {"C30", "C2I", "C6I", "C5P", 1561.098, 1268.52}, {"C02", "C2I", "C7I", "C6Q", 1561.098, 1207.14},
        {"J02", "C1C", "C2L", "C5Q", 1575.42, 1227.60}};
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        const line l[] = {{k[i].sat, k[i].obs1, NULL, -7.25},
                          {k[i].sat, k[i].obs2, NULL, 11.5},
                          {k[i].sat, k[i].other, NULL, 3}};
        orr_bias b[MAX_LINES];
        orr_bias_set x;
        make(l, 3, b, &x);
        double d1 = delay(&x, k[i].sat, k[i].obs1 + 1), d2 = delay(&x, k[i].sat, k[i].obs2 + 1);
        double other = delay(&x, k[i].sat, k[i].other + 1), f1 = k[i].f1 * k[i].f1, f2 = k[i].f2 * k[i].f2;
        ASSERT_NEAR((f1 * d1 - f2 * d2) / (f1 - f2), 0, 1e-17);
        ASSERT_NEAR(d2 - d1, 18.75e-9, 1e-18);
        ASSERT_NEAR(other - d1, 10.25e-9, 1e-18);
    }
}

// Adding one number to all biases of a satellite is another clock, not another delay; a file of differences
// says the same as one of absolute biases.
static void the_datum_and_the_kind_of_file_do_not_matter(void **state)
{
    (void)state;
    const line absolute[] = {{"G05", "C1W", NULL, 4}, {"G05", "C2W", NULL, 6}, {"G05", "C1C", NULL, 5}};
    const line shifted[] = {{"G05", "C1W", NULL, 104}, {"G05", "C2W", NULL, 106}, {"G05", "C1C", NULL, 105}};
    const line differences[] = {{"G05", "C1C", "C1W", 1}, {"G05", "C1W", "C2W", -2}};
    orr_bias b[3][MAX_LINES];
    orr_bias_set x[3];
    make(absolute, 3, b[0], &x[0]);
    make(shifted, 3, b[1], &x[1]);
    make(differences, 2, b[2], &x[2]);
    for (int i = 0; i < 3; i++) {
        double tgd = (double)NAN;
        assert_int_equal(orr_signal_tgd(&x[i], orr_sat_parse("G05"), noon, &tgd), ORR_OK);
        ASSERT_NEAR(tgd, -2e-9 / (1 - (77.0 * 77) / (60.0 * 60)), 1e-17); // (b1 - b2) / (1 - gamma)
        ASSERT_NEAR(delay(&x[i], "G05", "1W"), tgd, 1e-18);
        ASSERT_NEAR(delay(&x[i], "G05", "2W"), tgd * (77.0 * 77) / (60.0 * 60), 1e-17);
        ASSERT_NEAR(delay(&x[i], "G05", "1C"), tgd + 1e-9, 1e-17);
    }
}

static void glonass_is_told_by_its_open_signals_where_they_are_known(void **state)
{
    (void)state;
    const line l[] = {{"R03", "C1P", NULL, 1}, {"R03", "C2P", NULL, 4}, {"R03", "C1C", NULL, 2},
                      {"R03", "C2C", NULL, 6}, {"R04", "C1P", NULL, 1}, {"R04", "C2P", NULL, 4}};
    orr_bias b[MAX_LINES];
    orr_bias_set x;
    make(l, 6, b, &x);
    const double g = 81.0 / 49, clock = (g * 1e-9 - 4e-9) / (g - 1); // of the P signals
    double shift, tau;
    assert_int_equal(orr_signal_glonass(&x, orr_sat_parse("R03"), noon, &shift, &tau), ORR_OK);
    ASSERT_NEAR(tau, 4e-9, 1e-18);
    ASSERT_NEAR(shift, clock - 2e-9, 1e-17);
    assert_int_equal(orr_signal_glonass(&x, orr_sat_parse("R04"), noon, &shift, &tau), ORR_OK);
    ASSERT_NEAR(tau, 3e-9, 1e-18);
    ASSERT_NEAR(shift, clock - 1e-9, 1e-17);
    assert_int_equal(orr_signal_glonass(&x, orr_sat_parse("G05"), noon, &shift, &tau), ORR_E_NODATA);
}

static void what_is_not_known_is_not_zero(void **state)
{
    (void)state;
    const line l[] = {{"G05", "C1W", NULL, 1}, {"G05", "C2W", NULL, 4}, {"G06", "C1C", NULL, 4}};
    orr_bias b[MAX_LINES];
    orr_bias_set x;
    make(l, 3, b, &x);
    double d = 77;
    assert_int_equal(orr_signal_delay_osb(&x, orr_sat_parse("G05"), "5Q", noon, &d), ORR_E_NODATA);
    assert_int_equal(orr_signal_delay_osb(&x, orr_sat_parse("G06"), "1C", noon, &d), ORR_E_NODATA);
    assert_int_equal(orr_signal_delay_osb(&x, orr_sat_parse("S20"), "1C", noon, &d), ORR_E_NODATA);
    assert_int_equal(orr_signal_delay_osb(&x, orr_sat_parse("G05"), "C1W", noon, &d), ORR_E_ARG);
    assert_int_equal(orr_signal_tgd(&x, orr_sat_parse("G06"), noon, &d), ORR_E_NODATA);
    assert_int_equal(orr_signal_tgd(&x, orr_sat_parse("E06"), noon, &d), ORR_E_NODATA);
    // A day's file serves the day's end and the hours around it, not another week.
    const orr_time hour = 3600 * ORR_NS_PER_S;
    assert_int_equal(orr_signal_tgd(&x, orr_sat_parse("G05"), noon + 12 * hour, &d), ORR_OK);
    assert_int_equal(orr_signal_tgd(&x, orr_sat_parse("G05"), noon - 14 * hour, &d), ORR_OK);
    assert_int_equal(orr_signal_tgd(&x, orr_sat_parse("G05"), noon + 37 * hour, &d), ORR_E_NODATA);
}

// What a receiver of the product's pair sees must not depend on which signals a message's clock is of.
static void broadcast_clocks_are_brought_to_the_products(void **state)
{
    (void)state;
    const double g5 = (154.0 * 154) / (115.0 * 115), b1 = 1561.098 * 1561.098, b3 = 1268.52 * 1268.52;
    orr_nav_eph e = {.sat = orr_sat_parse("E11"), .message = ORR_NAV_INAV};
    double d, shift;
    e.delay = (orr_nav_delays){.bgd_e5a_e1_s = 3e-9, .bgd_e5b_e1_s = 4e-9};
    assert_int_equal(orr_signal_delay_broadcast(&e, "1C", &d), ORR_OK);
    ASSERT_NEAR(d, 3e-9, 1e-18); // E1's delay against E1/E5a is BGD(E5a), whoever says it
    e.message = ORR_NAV_FNAV;
    assert_int_equal(orr_signal_delay_broadcast(&e, "5Q", &d), ORR_OK);
    ASSERT_NEAR(d, 3e-9 * g5, 1e-17);

    e = (orr_nav_eph){.sat = orr_sat_parse("C30"), .message = ORR_NAV_D1, .delay = {.tgd_s = 5e-9}};
    double b1i, b3i;
    assert_int_equal(orr_signal_delay_broadcast(&e, "2I", &b1i), ORR_OK);
    assert_int_equal(orr_signal_delay_broadcast(&e, "6I", &b3i), ORR_OK);
    ASSERT_NEAR(b1i - b3i, 5e-9, 1e-18);
    ASSERT_NEAR((b1 * b1i - b3 * b3i) / (b1 - b3), 0, 1e-17);

    e = (orr_nav_eph){.sat = orr_sat_parse("R03"), .message = ORR_NAV_FDMA};
    e.glonass.delta_tau_s = -6e-9;
    double l1, l2;
    assert_int_equal(orr_signal_delay_broadcast(&e, "1C", &l1), ORR_OK);
    assert_int_equal(orr_signal_delay_broadcast(&e, "2C", &l2), ORR_OK);
    ASSERT_NEAR(l2 - l1, -6e-9, 1e-18);
    ASSERT_NEAR((81 * l1 - 49 * l2) / 32, 0, 1e-17);
    e.glonass.delta_tau_s = (double)NAN; // RINEX before 3.05
    assert_int_equal(orr_signal_broadcast_to_product(&e, &shift), ORR_E_NODATA);
    assert_int_equal(orr_signal_delay_broadcast(&e, "1C", &d), ORR_E_NODATA);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_clocks_pair_has_no_delay),
        cmocka_unit_test(the_datum_and_the_kind_of_file_do_not_matter),
        cmocka_unit_test(glonass_is_told_by_its_open_signals_where_they_are_known),
        cmocka_unit_test(what_is_not_known_is_not_zero),
        cmocka_unit_test(broadcast_clocks_are_brought_to_the_products),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Scintillation returns its S4, tau0 and sigma_phi; waves and fronts their speed, length and gradient; where and when they are.
#include <complex.h>

#include "block_at.h"
#include "core/constants.h"
#include "src/scenario/effect/disturbance.h"
#include "src/scenario/effect/scintillation.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: 5}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"
static const double L1_HZ = 1575.42e6, L5_HZ = 1176.45e6;

static void parse(const char *rest, orr_scenario *s)
{
    char text[2000];
    orr_diag diag = {0};
    snprintf(text, sizeof text, "orbit: {product: " MADE_PRODUCT "}\n" SKY "%s", rest);
    ASSERT_OK(orr_scenario_parse("test", text, strlen(text), NULL, NULL, s, &diag), diag);
}

enum { N = 12000, STEP_MS = 20 }; // 240 s at 50 Hz, as receivers do

static double complex z[N];

// z of a satellite with these indices.
static void sample(double s4, double tau0_s, double carrier_hz, int seed)
{
    orr_scenario s;
    orr_scintillation *x;
    orr_diag diag = {0};
    char text[200];
    snprintf(text, sizeof text, "scintillation: [{s4: %g, tau0: %g, seed: %d}]\n", s4, tau0_s, seed);
    parse(text, &s);
    ASSERT_OK(orr_scintillation_open(&s, &x, &diag), diag);
    orr_scintillation_cell cell = {.made = false};
    for (int k = 0; k < N; k++) {
        orr_scintillation_effect e;
        orr_scintillation_of(x, orr_sat_parse("G05"), 0, at(0) + (int64_t)k * STEP_MS * 1000000 + 7000000,
                             (orr_scintillation_now){s4, 0}, carrier_hz, &cell, &e);
        z[k] = pow(10, e.power_db / 20) * cexp(2 * ORR_PI * e.phase_cycles * (double complex)I);
    }
    orr_scintillation_close(x);
    orr_scenario_free(&s);
}

static double s4_of(void)
{
    double mean = 0, square = 0;
    for (int k = 0; k < N; k++) {
        const double power = creal(z[k] * conj(z[k]));
        mean += power / N;
        square += power * power / N;
    }
    return sqrt(square / (mean * mean) - 1);
}

// Lag at which the correlation of what is scattered falls to 1/e.
static double tau0_of(void)
{
    double complex mean = 0;
    double whole = 0;
    for (int k = 0; k < N; k++) mean += z[k] / N;
    for (int k = 0; k < N; k++) whole += creal((z[k] - mean) * conj(z[k] - mean)) / N;
    double before = 1;
    for (int lag = 1; lag < N / 2; lag++) {
        double now = 0;
        for (int k = 0; k + lag < N; k++) now += creal((z[k] - mean) * conj(z[k + lag] - mean)) / (N - lag);
        now /= whole;
        if (now < exp(-1)) return (lag - (exp(-1) - now) / (before - now)) * STEP_MS / 1e3;
        before = now;
    }
    return (double)NAN;
}

static void scintillation_returns_its_indices(void **state)
{
    (void)state;
    static const double s4[] = {0.2, 0.5, 0.8, 1}, tau0_s[] = {0.5, 0.2, 1, 0.5};
    for (size_t i = 0; i < 4; i++) {
        sample(s4[i], tau0_s[i], L1_HZ, 3);
        ASSERT_NEAR(s4_of() / s4[i], 1, 0.1);
        ASSERT_NEAR(tau0_of() / tau0_s[i], 1, 0.1);
    }
    sample(0.4, 0.5, L5_HZ, 9);
    ASSERT_NEAR(s4_of() / (0.4 * pow(L1_HZ / L5_HZ, 1.5)), 1, 0.1);
    double mean = 0; // power on average is that without it
    for (int k = 0; k < N; k++) mean += creal(z[k] * conj(z[k])) / N;
    ASSERT_NEAR(mean, 1, 0.05);
}

// Mean spectral density of n samples between two of their Fourier frequencies; every second sample is enough.
static double density(const double *x, int n, int from, int to)
{
    double sum = 0, window = 0;
    for (int i = 0; i < n; i += 2) window += pow(sin(ORR_PI * i / n), 4);
    for (int k = from; k < to; k++) {
        double complex term = 0;
        for (int i = 0; i < n; i += 2) {
            const double w = sin(ORR_PI * i / n);
            term += x[i] * w * w * cexp(-2 * ORR_PI * k * i / n * (double complex)I);
        }
        sum += creal(term * conj(term)) / window / (to - from);
    }
    return sum;
}

static void the_refractive_phase_has_its_sigma_and_slope(void **state)
{
    (void)state;
    static double phase[N];
    orr_scenario s;
    orr_scintillation *x;
    orr_diag diag = {0};
    parse("scintillation: [{sigma_phi: 0.6, slope: 2.5}]\n", &s);
    ASSERT_OK(orr_scintillation_open(&s, &x, &diag), diag);
    orr_scintillation_cell cell = {.made = false};
    double mean = 0, square = 0;
    for (int k = 0; k < N; k++) {
        orr_scintillation_effect e, later;
        const orr_time t = at(0) + (int64_t)k * STEP_MS * 1000000 + 3000000;
        orr_scintillation_of(x, orr_sat_parse("G05"), 0, t, (orr_scintillation_now){0, 0.6}, L5_HZ, &cell,
                             &e);
        orr_scintillation_of(x, orr_sat_parse("G05"), 0, t + 1000, (orr_scintillation_now){0, 0.6}, L5_HZ,
                             &cell, &later);
        ASSERT_NEAR((later.phase_cycles - e.phase_cycles) / 1e-6, e.phase_rate_hz,
                    1e-4 + 1e-4 * fabs(e.phase_rate_hz));
        assert_true(e.power_db == 0);
        phase[k] = 2 * ORR_PI * e.phase_cycles;
        mean += phase[k] / N;
        square += phase[k] * phase[k] / N;
    }
    ASSERT_NEAR(sqrt(square - mean * mean) / (0.6 * L1_HZ / L5_HZ), 1, 0.1);
    // Spectral densities about 0.45 and 4.5 Hz, by Hann's window over 240 and ten times 24 s: 10^p.
    const double low = density(phase, N, 72, 144);
    double high = 0;
    for (int part = 0; part < 10; part++) high += density(&phase[part * N / 10], N / 10, 72, 144) / 10;
    ASSERT_NEAR(log10(low / high), 2.5, 0.15); // seven waves in either
    orr_scintillation_close(x);
    orr_scenario_free(&s);
}

// Whatever was asked before, to the last bit: by steps that skip nodes, within seconds and over them, and backwards.
static void scintillation_forgets_what_was_asked(void **state)
{
    (void)state;
    static orr_scintillation_cell kept, fresh;
    static const int64_t steps_ms[] = {1, 20, 30, 100, 730, 1000, 61003, -7, -1500};
    orr_scenario s;
    orr_scintillation *x;
    orr_diag diag = {0};
    parse("scintillation: [{s4: 0.7, tau0: 0.5, sigma_phi: 0.3}]\n", &s);
    ASSERT_OK(orr_scintillation_open(&s, &x, &diag), diag);
    const orr_scintillation_now indices = {0.7, 0.3};
    orr_time t = at(0) + 123456;
    memset(&kept, 0, sizeof kept);
    for (size_t i = 0; i < sizeof steps_ms / sizeof *steps_ms; i++)
        for (int k = 0; k < 60; k++, t += steps_ms[i] * 1000000) {
            orr_scintillation_effect a, b;
            memset(&fresh, 0, sizeof fresh);
            orr_scintillation_of(x, orr_sat_parse("G05"), 0, t, indices, L1_HZ, &kept, &a);
            orr_scintillation_of(x, orr_sat_parse("G05"), 0, t, indices, L1_HZ, &fresh, &b);
            assert_memory_equal(&a, &b, sizeof a);
        }
    orr_scintillation_close(x);
    orr_scenario_free(&s);
}

// At whole seconds phasors begin anew: those that were turned by tenths and nodes meet them.
static void scintillation_goes_on_over_seconds(void **state)
{
    (void)state;
    static orr_scintillation_cell there, back;
    orr_scenario s;
    orr_scintillation *x;
    orr_diag diag = {0};
    parse("scintillation: [{s4: 0.7, tau0: 0.2, sigma_phi: 0.3}]\n", &s);
    ASSERT_OK(orr_scintillation_open(&s, &x, &diag), diag);
    for (int k = 1; k < 100; k++) {
        orr_scintillation_effect e;
        const orr_time second = at(k);
        memset(&there, 0, sizeof there);
        memset(&back, 0, sizeof back);
        // Cells that end at the second and at the node before it: phasors are those of the end.
        orr_scintillation_of(x, orr_sat_parse("G05"), 0, second - 1, (orr_scintillation_now){0.7, 0.3}, L1_HZ,
                             &there, &e);
        orr_scintillation_of(x, orr_sat_parse("G05"), 0, second - 20000001, (orr_scintillation_now){0.7, 0.3},
                             L1_HZ, &back, &e);
        for (int i = 0; i < ORR_SCINTILLATION_WAVES; i++) {
            const double complex z_before = back.waves.re[i] + back.waves.im[i] * (double complex)I,
                                 turn = back.waves.node_turn_re[i] +
                                        back.waves.node_turn_im[i] * (double complex)I,
                                 z_then = there.waves.re[i] + there.waves.im[i] * (double complex)I;
            assert_true(there.waves.second == orr_floor_div(second, 1000000000) && there.waves.tenth == 0 &&
                        there.waves.node == 0);
            ASSERT_NEAR(cabs(z_before * turn - z_then), 0, 1e-13);
        }
    }
    orr_scintillation_close(x);
    orr_scenario_free(&s);
}

static orr_pierce zenith(double lat_deg, double lon_deg)
{
    return (orr_pierce){
        .el_rad = ORR_PI / 2, .lat_rad = lat_deg * ORR_RAD_PER_DEG, .lon_rad = lon_deg * ORR_RAD_PER_DEG};
}

static void it_is_where_and_when_it_was_told(void **state)
{
    (void)state;
    orr_scenario s;
    orr_scintillation *x;
    orr_diag diag = {0};
    parse("scintillation:\n  - {sats: G05, s4: 0.5, latitude: [-20, 20], local_time: [20, 2]}\n"
          "  - {sats: G, s4: 0.3, longitude: [170, -170]}\n",
          &s);
    ASSERT_OK(orr_scintillation_open(&s, &x, &diag), diag);
    const orr_sat g05 = orr_sat_parse("G05"), g06 = orr_sat_parse("G06"), e01 = orr_sat_parse("E01");
    orr_pierce p = zenith(0, 0);
    ASSERT_NEAR(orr_scintillation_at(x, g05, at(22 * 3600), &p).s4, 0.5, 1e-15);
    ASSERT_NEAR(orr_scintillation_at(x, g05, at(1 * 3600), &p).s4, 0.5, 1e-15);
    assert_true(orr_scintillation_at(x, g05, at(12 * 3600), &p).s4 == 0);
    p = zenith(0, 60); // four hours later there
    ASSERT_NEAR(orr_scintillation_at(x, g05, at(18 * 3600), &p).s4, 0.5, 1e-15);
    assert_true(orr_scintillation_at(x, g05, at(23 * 3600), &p).s4 == 0);
    p = zenith(20.25, 0);
    ASSERT_NEAR(orr_scintillation_at(x, g05, at(22 * 3600), &p).s4, 0.25, 1e-12);
    p = zenith(21, 0);
    assert_true(orr_scintillation_at(x, g05, at(22 * 3600), &p).s4 == 0);
    p = zenith(60, 179);
    ASSERT_NEAR(orr_scintillation_at(x, g06, at(0), &p).s4, 0.3, 1e-15);
    p = zenith(60, 160);
    assert_true(orr_scintillation_at(x, g06, at(0), &p).s4 == 0);
    assert_true(orr_scintillation_at(x, e01, at(0), &p).s4 == 0);
    orr_scintillation_close(x);
    orr_scenario_free(&s);
}

static void waves_and_fronts_move_as_told(void **state)
{
    (void)state;
    orr_scenario s;
    orr_disturbance *d;
    orr_diag diag = {0};
    parse("disturbance: {waves: [{amplitude: 2, length: 200, speed: 150, azimuth: 90, position: [45, 10], "
          "time: "
          "2024-02-04T00:00:00}]}\n",
          &s);
    ASSERT_OK(orr_disturbance_open(&s, &d, &diag), diag);
    const double degree_m = ORR_SHELL_RADIUS_M * ORR_RAD_PER_DEG * cos(45 * ORR_RAD_PER_DEG);
    orr_pierce p = zenith(45, 10), east = zenith(45, 10 + 100e3 / degree_m), north = zenith(46, 10);
    const double period_s = 200e3 / 150;
    ASSERT_NEAR(orr_disturbance_tecu(d, at(0), &p), 2, 1e-9);
    ASSERT_NEAR(orr_disturbance_tecu(d, at(period_s / 2), &p), -2, 1e-9);
    ASSERT_NEAR(orr_disturbance_tecu(d, at(0), &east), -2, 1e-9);
    ASSERT_NEAR(orr_disturbance_tecu(d, at(period_s / 2), &east), 2,
                1e-9); // half a wave on, half a period later
    ASSERT_NEAR(orr_disturbance_tecu(d, at(0), &north), 2, 1e-9);
    p.el_rad = 20 * ORR_RAD_PER_DEG;
    const orr_mapping m = orr_mapping_published(ORR_MAPPING_THIN_SHELL);
    ASSERT_NEAR(orr_disturbance_tecu(d, at(0), &p), 2 * orr_mapping_factor(&m, p.el_rad), 1e-9);
    orr_disturbance_close(d);
    orr_scenario_free(&s);
    parse(
        "disturbance: {fronts: [{gradient: 400, width: 25, speed: 100, azimuth: 0, position: [45, 10], time: "
        "2024-02-04T00:00:00}]}\n",
        &s);
    ASSERT_OK(orr_disturbance_open(&s, &d, &diag), diag);
    const double l1_m = ORR_IONO_K_M3_PER_S2 / (L1_HZ * L1_HZ);
    p = zenith(45, 10);
    assert_true(orr_disturbance_tecu(d, at(-20), &p) == 0); // 2 km before it comes
    ASSERT_NEAR(orr_disturbance_tecu(d, at(100), &p) * l1_m, 0.4 * 10, 1e-9);
    ASSERT_NEAR((orr_disturbance_tecu(d, at(151), &p) - orr_disturbance_tecu(d, at(150), &p)) * l1_m, 0.04,
                1e-9);
    ASSERT_NEAR(orr_disturbance_tecu(d, at(400), &p) * l1_m, 10, 1e-9); // 25 km of 400 mm/km
    orr_disturbance_close(d);
    orr_scenario_free(&s);
}

static void channels_have_both(void **state)
{
    (void)state;
    open_with(SKY "scintillation: [{sats: G01, s4: 0.7, tau0: 0.5, from: 2024-02-04T01:00:30}]\n"
                  "disturbance: {fronts: [{gradient: 300, width: 200, speed: 0, azimuth: 180, position: [80, "
                  "17], time: "
                  "2024-02-04T00:00:00}]}\n");
    orr_channel x[ROOM];
    const orr_time t = at(3700);
    const size_t n = all_at(t, 0, x);
    size_t front = 0;
    assert_true(n > 0);
    for (size_t k = 0; k < n; k++) {
        const double d = x[k].term_m[ORR_TERM_DISTURBANCE], s = x[k].term_m[ORR_TERM_SCINTILLATION];
        assert_true((s != 0) == (x[k].sat == orr_sat_parse("G01")));
        front += d != 0;
    }
    assert_true(front == 0); // nothing is behind a front 3000 km North that goes South and stands
    const orr_channel g = one_at(at(3620.1), "G01", "L1CA");
    assert_true(one_at(at(3600), "G01", "L1CA").term_m[ORR_TERM_SCINTILLATION] == 0);
    ASSERT_NEAR(g.rate_mps[ORR_TERM_SCINTILLATION],
                (one_at(at(3620.1001), "G01", "L1CA").term_m[ORR_TERM_SCINTILLATION] -
                 one_at(at(3620.0999), "G01", "L1CA").term_m[ORR_TERM_SCINTILLATION]) /
                    0.0002,
                1e-3 + 0.01 * fabs(g.rate_mps[ORR_TERM_SCINTILLATION]));
    // Blocks are short enough for it, and long before it.
    static orr_block block[ROOM];
    orr_blocks b;
    size_t m;
    const orr_channels *c = orr_engine_channels(engine);
    assert_int_equal(orr_blocks_at(c, 0, work, at(3700.004), UINT64_MAX, &b, block, &m), ORR_ANSWER_OK);
    assert_int_equal(b.length_ns, 10000000);
    const orr_channel middle = one_at(at(3700.004), "G01", "L1CA");
    for (size_t k = 0; k < m; k++)
        if (block[k].at.sat == middle.sat && block[k].at.signal == middle.signal) {
            const double there = (double)(block[k].carrier_cycles - middle.carrier_cycles) +
                                 block_cubic(block[k].carrier, 0.004) - middle.carrier_fraction;
            ASSERT_NEAR(there, 0, 1e-3);                                      // cycles
            ASSERT_NEAR(block_code_m(&block[k], 0.004), middle.code_m, 3e-8); // the code does not scintillate
        }
    assert_int_equal(orr_blocks_at(c, 0, work, at(3500), UINT64_MAX, &b, block, &m), ORR_ANSWER_OK);
    assert_int_equal(b.length_ns, ORR_NS_PER_S);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(SKY "scintillation: [{s4: 1.2}]\n", "s4");
    refused_with(SKY "scintillation: [{tau0: 0.5}]\n", "has no effect without s4 or sigma_phi");
    refused_with(SKY "scintillation: [{s4: 0.5, from: 2024-02-04T02:00:00, to: 2024-02-04T01:00:00}]\n",
                 "it ends before it begins");
    refused_with(SKY "scintillation: [{s4: 0.5, latitude: [20, -20]}]\n", "from south to north");
    refused_with(
        SKY "disturbance: {waves: [{amplitude: 1, length: 100, speed: 100, azimuth: 0, position: [95, 0], "
            "time: 2024-02-04T00:00:00}]}\n",
        "latitude 95 is no place");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scintillation_returns_its_indices),
        cmocka_unit_test(the_refractive_phase_has_its_sigma_and_slope),
        cmocka_unit_test(scintillation_forgets_what_was_asked),
        cmocka_unit_test(scintillation_goes_on_over_seconds),
        cmocka_unit_test(it_is_where_and_when_it_was_told),
        cmocka_unit_test(waves_and_fronts_move_as_told),
        cmocka_unit_test_teardown(channels_have_both, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}

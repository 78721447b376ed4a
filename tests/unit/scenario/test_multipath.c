// SPDX-License-Identifier: GPL-3.0-or-later
// Echoes: Fresnel's limits, the ground's interference against its height, the correlator's error envelope in closed form, reflectors by
// geometry; echoes as channels of their own.
#include <complex.h>

#include "block_at.h"
#include "core/constants.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/effect/reflection.h"
#include "src/scenario/observables/composite.h"
#include "src/scenario/observables/correlator.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"

static void fresnel_has_its_limits(void **state)
{
    (void)state;
    double complex level, upright, slope;
    const double root = sqrt(15), normal = (root - 1) / (root + 1);
    orr_fresnel(15, 1, &level, &upright); // head on both are the same but for the sign convention
    ASSERT_NEAR(cabs(level + normal), 0, 1e-12);
    ASSERT_NEAR(cabs(upright - normal), 0, 1e-12);
    orr_fresnel(orr_medium(15, 0.005, 1575.42e6), 1e-6, &level, &upright);
    ASSERT_NEAR(cabs(level + 1), 0, 1e-5);
    ASSERT_NEAR(cabs(upright + 1), 0, 1e-4);
    orr_fresnel(15, cos(atan(root)), &level, &upright); // Brewster's angle
    ASSERT_NEAR(cabs(upright), 0, 1e-12);
    orr_fresnel(orr_medium(1, 5.8e7, 1575.42e6), 0.5, &level, &upright); // copper turns the hand round
    ASSERT_NEAR(cabs((level + upright) / 2), 0, 1e-3);
    ASSERT_NEAR(cabs((level - upright) / 2 + 1), 0, 1e-3);
    ASSERT_NEAR(creal(orr_medium(70, 5, 1575.42e6)), 70, 0); // sea water: 60 lambda sigma = 57
    ASSERT_NEAR(cimag(orr_medium(70, 5, 1575.42e6)), -57.09, 0.01);
    // An antenna that takes its own hand alone loses what comes back as the other.
    static const orr_scenario_gain hand[] = {{-90, 0, -100}, {90, 0, -100}};
    ASSERT_NEAR(cabs(orr_reflected(orr_medium(1, 5.8e7, 1575.42e6), 0.5, hand, 2, 30, -30, &slope)), 0, 1e-3);
    static const orr_scenario_gain tilted[] = {{-90, -20, -20}, {0, -10, -10}, {90, 10, -20}};
    ASSERT_NEAR(orr_pattern_db(tilted, 3, 45, true), 0, 1e-12);
    ASSERT_NEAR(orr_pattern_db(tilted, 3, -45, false), -15, 1e-12);
}

static void a_reflection_has_its_slope(void **state)
{
    (void)state;
    static const orr_scenario_gain pattern[] = {{-90, -20, -15}, {0, -5, -15}, {90, 5, -12}};
    static const double media[][2] = {{15, 0.005}, {70, 5}, {3, 0}, {1, 5.8e7}};
    const double step = 1e-5;
    for (size_t k = 0; k < sizeof media / sizeof *media; k++)
        for (size_t n = 0; n <= 3; n += 3)
            for (double s = 0.02; s < 1; s += 0.07) {
                const double complex medium = orr_medium(media[k][0], media[k][1], 1575.42e6);
                double complex slope, unused;
                (void)orr_reflected(medium, s, pattern, n, 30, -30, &slope);
                const double complex before = orr_reflected(medium, s - step, pattern, n, 30, -30, &unused),
                                     after = orr_reflected(medium, s + step, pattern, n, 30, -30, &unused);
                ASSERT_NEAR(cabs((after - before) / (2 * step) - slope), 0, 2e-6 * (1 + cabs(slope)));
                if (n > 0) continue;
                // Without a pattern it is closed: log of -level is -2 asinh(s/sqrt(medium - 1)).
                const double complex level = orr_reflected(medium, s, pattern, n, 30, -30, &unused);
                ASSERT_NEAR(cabs(level + cexp(-2 * casinh(s / csqrt(medium - 1)))), 0, 1e-12);
            }
}

// van Nee 1993; Braasch 2017: of a triangle and an echo of amplitude a, delay D, at spacing d, all in chips.
static double envelope(double a, double D, double d)
{
    const double s = fabs(a), sign = a < 0 ? -1 : 1;
    if (D < (1 + a) * d / 2) return sign * s * D / (1 + a);
    return sign * s * d / 2; // until 1 - (1 - a) d/2
}

static void the_envelope_is_the_closed_form(void **state)
{
    (void)state;
    const orr_signal *s = orr_signal_find('G', "L1CA");
    const double chip_m = ORR_LIGHT_MPS / s->chips_per_s;
    static const double spacings[] = {1, 0.5, 0.1};
    for (size_t i = 0; i < 3; i++)
        for (double D = 0.01; D < 1.6; D += 0.01)
            for (int out = 0; out < 2; out++) {
                const double d = spacings[i], a = 0.5;
                const orr_correlator_ray ray[2] = {{1, 0, 0}, {a, D * chip_m, out * 0.5}};
                double code_m, phase, gain;
                orr_correlator(s, d, ray, 2, &code_m, &phase, &gain);
                const double signed_a = out == 1 ? -a : a;
                if (D < 1 - (1 - signed_a) * d / 2 - 0.005)
                    ASSERT_NEAR(code_m, envelope(signed_a, D, d) * chip_m, 1e-6);
                if (D > 1 + d / 2 + 0.005) ASSERT_NEAR(code_m, 0, 1e-6);
            }
    // The phase of a short echo in quadrature is atan of its amplitude: later, and so the phase range is longer.
    const orr_correlator_ray ray[2] = {{1, 0, 0}, {0.3, 1, 0.25}};
    double code_m, phase, gain;
    orr_correlator(s, 0.5, ray, 2, &code_m, &phase, &gain);
    ASSERT_NEAR(phase, atan(0.3) / (2 * ORR_PI), 1e-3); // 1 m of 293 m of a chip
    ASSERT_NEAR(gain, sqrt(1 + 0.3 * 0.3), 1e-2);
    orr_correlator(s, 0.5, ray, 1, &code_m, &phase, &gain);
    assert_true(code_m == 0 && phase == 0 && gain == 1);
}

static void subcarriers_have_their_peaks(void **state)
{
    (void)state;
    const orr_signal *e1 = orr_signal_find('E', "E1"), *l5 = orr_signal_find('G', "L5");
    ASSERT_NEAR(orr_correlation(e1, 0), 1, 1e-12);
    ASSERT_NEAR(orr_correlation(e1, 0.5), 10.0 / 11 * -0.5 + 1.0 / 11 * 0.5, 1e-12);
    ASSERT_NEAR(orr_correlation(e1, 1), 0, 1e-12);
    ASSERT_NEAR(orr_correlation(e1, -0.25), orr_correlation(e1, 0.25), 1e-15);
    ASSERT_NEAR(orr_correlation(l5, 0.25), 0.75, 1e-12);
    // Where the echo meets the side of its peak E1 errs by a third of what C/A does.
    const orr_signal *ca = orr_signal_find('G', "L1CA");
    double of_ca, of_e1, phase, gain;
    const orr_correlator_ray ray[2] = {{1, 0, 0}, {0.3, 200, 0}};
    orr_correlator(ca, 0.1, ray, 2, &of_ca, &phase, &gain);
    orr_correlator(e1, 0.1, ray, 2, &of_e1, &phase, &gain);
    ASSERT_NEAR(of_ca, 0.3 * 0.05 * 293.05, 0.01);
    ASSERT_NEAR(of_e1, 0, of_ca / 2);
}

// G01 at t: its L1 C/A, its echo, and what they make together.
typedef struct pair {
    orr_channel direct, echo;
    orr_composite both;
    bool there;
} pair;

static pair pair_at(orr_time t)
{
    static orr_channel x[ROOM];
    const size_t n = all_at(t, 0, x);
    const orr_signal *all = orr_signals(&(size_t){0});
    pair out = {.there = false};
    for (size_t k = 0; k + 1 < n; k++) {
        if (x[k].sat != orr_sat_parse("G01") || x[k].echo > 0 || strcmp(all[x[k].signal].name, "L1CA") != 0)
            continue;
        out.there = x[k + 1].echo > 0;
        out.direct = x[k];
        out.echo = x[k + 1];
        const size_t next = orr_composite_of(orr_engine_channels(engine), x, n, k, &out.both);
        assert_int_equal(next, k + 1 + (out.there ? 1 : 0));
    }
    return out;
}

static double cycles_behind(const pair *p)
{
    return (double)(p->echo.carrier_cycles - p->direct.carrier_cycles) + p->echo.carrier_fraction -
           p->direct.carrier_fraction;
}

static void the_ground_interferes_by_its_height(void **state)
{
    (void)state;
    static const double heights[] = {1.5, 3, 10};
    for (size_t i = 0; i < 3; i++) {
        char text[400];
        snprintf(text, sizeof text, SKY "multipath: {ground: {height: %g}}\n", heights[i]);
        open_with(text);
        const double wave_m = ORR_LIGHT_MPS / 1575.42e6;
        double last = 0, first = 0, a = 0, b = 0, before = 0;
        int minima = 0;
        for (int k = 0; k < 3600; k++) { // minima of the composite's power against the sine of elevation
            const pair p = pair_at(at(3600 + k));
            const double s = sin(p.direct.el_rad);
            if (!p.there) {
                before = 0;
                continue;
            }
            ASSERT_NEAR(p.echo.term_m[ORR_TERM_ECHO], 2 * heights[i] * s,
                        1e-3); // the light's direction is 1e-5 rad off
            ASSERT_NEAR(p.echo.code_m - p.direct.code_m, p.echo.term_m[ORR_TERM_ECHO], 2e-8);
            if (before != 0 && b < a && b < p.both.power_db) {
                if (minima++ == 0) first = before;
                last = before;
            }
            a = before != 0 ? b : 0;
            b = p.both.power_db;
            before = s;
        }
        assert_true(minima >= 2);
        // The ground's coefficient turns by little; minima are found to one second of a slow rise.
        ASSERT_NEAR(fabs(last - first) / (minima - 1) / (wave_m / (2 * heights[i])), 1, 0.03);
        tear_down(NULL);
    }
}

static void rates_of_echoes_are_derivatives(void **state)
{
    (void)state;
    open_with(SKY "multipath:\n  ground: {height: 4}\n");
    const pair a = pair_at(at(3999.9)), p = pair_at(at(4000)), b = pair_at(at(4000.1));
    assert_true(p.there);
    ASSERT_NEAR(p.echo.rate_mps[ORR_TERM_ECHO],
                (b.echo.term_m[ORR_TERM_ECHO] - a.echo.term_m[ORR_TERM_ECHO]) / 0.2, 1e-7);
    ASSERT_NEAR(p.echo.rate_mps[ORR_TERM_ECHO_PHASE],
                (b.echo.term_m[ORR_TERM_ECHO_PHASE] - a.echo.term_m[ORR_TERM_ECHO_PHASE]) / 0.2, 1e-8);
    const double wave_m = ORR_LIGHT_MPS / p.echo.carrier_hz;
    ASSERT_NEAR(cycles_behind(&p),
                (p.echo.term_m[ORR_TERM_ECHO] + p.echo.term_m[ORR_TERM_ECHO_PHASE]) / wave_m, 1e-6);
    // Blocks hold them, each echo its own.
    static orr_block block[ROOM];
    orr_blocks blocks;
    size_t n, echoes = 0;
    assert_int_equal(
        orr_blocks_at(orr_engine_channels(engine), 0, work, at(4000.3), UINT64_MAX, &blocks, block, &n),
        ORR_ANSWER_OK);
    const pair then = pair_at(at(4000.3));
    for (size_t k = 0; k < n; k++) {
        if (block[k].at.sat != p.echo.sat || block[k].at.signal != p.echo.signal) continue;
        const double code = block_code_m(&block[k], 0.3);
        ASSERT_NEAR(code, block[k].at.echo > 0 ? then.echo.code_m : then.direct.code_m, 3e-8);
        echoes += block[k].at.echo > 0;
    }
    assert_int_equal(echoes, 1);
}

static void reflectors_are_as_told(void **state)
{
    (void)state;
    open_with(SKY
              "multipath:\n  reflectors:\n"
              "  - {sats: G01, from: 2024-02-04T01:00:00.5, to: 2024-02-04T01:10:00, delay: 30, doppler: -2, "
              "phase: 90, power: -6}\n"
              "  - {sats: E, from: 2024-02-04T01:00:00, position: [52.001, 17, 150], velocity: [20, 0, 0], "
              "power: -10}\n");
    assert_false(pair_at(at(3600.499)).there);
    const pair p = pair_at(at(3600.5)), q = pair_at(at(3700.5));
    assert_true(p.there && q.there);
    const double wave_m = ORR_LIGHT_MPS / 1575.42e6;
    ASSERT_NEAR(p.echo.term_m[ORR_TERM_ECHO], 30, 1e-12);
    ASSERT_NEAR(q.echo.term_m[ORR_TERM_ECHO], 30 + 200 * wave_m, 1e-9);
    ASSERT_NEAR(p.echo.carrier_rate_hz - p.direct.carrier_rate_hz, 2, 1e-9); // its Doppler is lower by 2 Hz
    ASSERT_NEAR(p.echo.power_dbw - p.direct.power_dbw, -6, 1e-12);
    ASSERT_NEAR(cycles_behind(&p), 30 / wave_m + 0.25, 1e-6);
    assert_false(pair_at(at(4200)).there);
    // In space: the triangle of satellite, reflector and antenna, the satellite far away.
    static orr_channel x[ROOM];
    const orr_vec3 r = orr_channels_antenna(orr_engine_channels(engine), 0)->fixed.r_m;
    const orr_time t = at(3660);
    const size_t n = all_at(t, 0, x);
    size_t seen = 0;
    for (size_t k = 0; k < n; k++) {
        if (x[k].echo != 2) continue;
        orr_sat_state s;
        assert_int_equal(orr_ephemeris_eval(orr_engine_ephemeris(engine), x[k].sat, t - 80000000, &s),
                         ORR_OK);
        const orr_geodetic place = {52.001 * ORR_RAD_PER_DEG, 17 * ORR_RAD_PER_DEG, 150};
        const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
        const orr_vec3 at_p =
            orr_vec3_add(orr_earth_to_ecef(place), orr_mat3_apply_t(&enu, (orr_vec3){1200, 0, 0}));
        const double way = orr_vec3_norm(orr_vec3_sub(s.pos_m, at_p)) + orr_vec3_norm(orr_vec3_sub(at_p, r)) -
                           orr_vec3_norm(orr_vec3_sub(s.pos_m, r));
        // Plane waves: d^2/(2 rho) = 0.03 m; 2 ms of light time: 0.4 m/s... of 1e-4 rad/s on 1200 m.
        ASSERT_NEAR(x[k].term_m[ORR_TERM_ECHO], way, 0.06);
        seen++;
    }
    assert_true(seen > 0);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(SKY "multipath: {ground: {permittivity: 4}}\n", "multipath.ground: needs a height");
    refused_with(SKY "multipath: {ground: {height: 2, level: 100}}\n",
                 "multipath.ground.height: cannot stand beside multipath.ground.level");
    refused_with(SKY "multipath: {reflectors: [{power: -3}]}\n", "needs a delay, or a position");
    refused_with(SKY "multipath: {reflectors: [{delay: 3, doppler: 1, power: -3}]}\n", "needs `from`");
    refused_with(SKY
                 "multipath: {reflectors: [{delay: 3, doppler: 1, power: -3, from: 2024-02-04T01:00:00}]}\n",
                 "multipath.reflectors[0].doppler: the echo would overtake its signal");
    refused_with(SKY "multipath: {reflectors: [{delay: 3, power: -3, from: 2024-02-05T01:00:00}]}\n",
                 "multipath.reflectors[0].from: it is not there in the time of the channels");
    refused_with(SKY
                 "multipath: {ground: {height: 1}, reflectors: [{delay: 1, power: 0}, {delay: 1, power: 0}, "
                 "{delay: 1, power: 0}, {delay: 1, power: 0}, {delay: 1, power: 0}]}\n",
                 "at most 5 echoes");
    refused_with(SKY "multipath: {pattern: [{elevation: 1}]}\n", "has no effect without");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fresnel_has_its_limits),
        cmocka_unit_test(a_reflection_has_its_slope),
        cmocka_unit_test(the_envelope_is_the_closed_form),
        cmocka_unit_test(subcarriers_have_their_peaks),
        cmocka_unit_test_teardown(the_ground_interferes_by_its_height, tear_down),
        cmocka_unit_test_teardown(rates_of_echoes_are_derivatives, tear_down),
        cmocka_unit_test_teardown(reflectors_are_as_told, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}

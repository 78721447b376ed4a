// SPDX-License-Identifier: GPL-3.0-or-later
// Channels: terms by closed forms, limits and symmetries; their sum, rates and joints; blocks against direct evaluation.
#include "src/scenario/channel/channel.h"

#include "core/constants.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/channel/light.h"
#include "src/scenario/channel/power.h"
#include "src/scenario/channel/slow.h"
#include "src/scenario/engine/engine.h"
#include "testing.h"

#include "block_at.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define EVERYTHING                                                                                           \
    "signals: [G, R, E]\ntroposphere: {model: saastamoinen}\nmask: {elevation: -10}\n"                       \
    "antennas:\n  - {name: BASE, position: [52, 17, 124]}\n"

static void the_range_is_that_of_inertial_space(void **state)
{
    (void)state;
    open_with(
        "signals: [G, R, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n");
    const orr_ephemeris *e = orr_engine_ephemeris(engine);
    const orr_vec3 r = orr_channels_antenna(orr_engine_channels(engine), 0)->fixed.r_m;
    const double w = ORR_EARTH_RATE_RADPS, c = ORR_LIGHT_MPS;
    orr_channel x[ROOM];
    const orr_time t = at(7000.123);
    const size_t n = all_at(t, 0, x);
    assert_true(n > 5);
    for (size_t k = 0; k < n; k++) {
        // Both points in axes that coincide with ecef at reception; the light's way by bisection.
        double low = 0.01, high = 0.3;
        for (int step = 0; step < 80; step++) {
            const double tau = (low + high) / 2, ns = nearbyint(tau * 1e9);
            orr_sat_state s;
            assert_int_equal(orr_ephemeris_eval(e, x[k].sat, t - (int64_t)ns, &s), ORR_OK);
            const orr_vec3 p = orr_vec3_axpy(ns * 1e-9 - tau, s.vel_mps, s.pos_m);
            const double a = -w * tau; // where the satellite was, turned back with the Earth
            const orr_vec3 q = {cos(a) * p.x - sin(a) * p.y, sin(a) * p.x + cos(a) * p.y, p.z};
            if (orr_vec3_norm(orr_vec3_sub(q, r)) > c * tau)
                low = tau;
            else
                high = tau;
        }
        // 1e-16 s of the bisection, 4e-9 m of doubles, and the product's own rounding.
        ASSERT_NEAR(x[k].term_m[ORR_TERM_DISTANCE] + x[k].term_m[ORR_TERM_SAGNAC], c * low, 3e-8);
    }
}

static void shapiro_is_of_two_centimetres(void **state)
{
    (void)state;
    // At the zenith ln((r_S + r_A + rho)/(r_S + r_A - rho)) = ln(r_S / r_A).
    const orr_vec3 a = {6.378e6, 0, 0}, s = {26.56e6, 0, 0};
    const double zenith = 2 * ORR_WGS84_GM / (ORR_LIGHT_MPS * ORR_LIGHT_MPS) * log(26.56 / 6.378);
    ASSERT_NEAR(orr_light_shapiro_m(a, s, 20.182e6), zenith, 1e-12);
    ASSERT_NEAR(zenith, 0.0127, 1e-4);
    const orr_vec3 low = {0, 26.56e6, 0};
    assert_true(orr_light_shapiro_m(a, low, hypot(6.378e6, 26.56e6)) > zenith);
}

static void terms_sum_to_code_and_carrier(void **state)
{
    (void)state;
    open_with(EVERYTHING);
    orr_channel x[ROOM];
    const size_t n = all_at(at(5000), 0, x);
    assert_true(n > 10);
    for (size_t k = 0; k < n; k++) {
        double code = 0, carrier = 0;
        for (int i = 0; i < ORR_N_TERMS; i++) {
            code += orr_term_rows[i].code * x[k].term_m[i];
            carrier += orr_term_rows[i].carrier * x[k].term_m[i];
        }
        ASSERT_NEAR(x[k].code_m, code, 8e-9);
        // Carrier in cycles: after its integer, a multiple of the wavelength is the sum.
        const long double cycles = (long double)x[k].carrier_cycles + (long double)x[k].carrier_fraction;
        const long double whole = cycles - (long double)carrier * (long double)x[k].carrier_hz / 299792458.0L;
        assert_true(fabsl(whole - roundl(whole)) < 5e-8L); // 4e-9 m of the sum, 0.19 m a cycle
        assert_true(whole > -0.5L && whole < 8191.5L);
        assert_true(x[k].carrier_fraction >= 0 && x[k].carrier_fraction < 1);
        // The satellite's clock at emission is t - code / c.
        const double flight_ns = (double)(at(5000) - x[k].transmit_ns) - x[k].transmit_fraction_ns;
        ASSERT_NEAR(flight_ns * 1e-9 * ORR_LIGHT_MPS, x[k].code_m, 1e-8);
    }
}

// The rate of every term is the change of the term.
static void rates_are_derivatives(void **state)
{
    (void)state;
    open_with(
        EVERYTHING
        "  - {name: BODY, right: 1, forward: 2, up: 3}\n"
        "trajectory:\n  kind: analytic\n  start: 2024-02-04T01:00:00\n  duration: 600\n  lat: 52\n  lon: 17\n"
        "  height: 500\n  body: {pitch: 2, follow_course: yes}\n  motions:\n    - {kind: circle, radius: "
        "900, period: 60}\n");
    const double h = 0.05;
    for (size_t antenna = 0; antenna < 2; antenna++) {
        orr_channel a[ROOM], b[ROOM], c[ROOM];
        const orr_time mid = at(3700);
        const size_t n = all_at(mid, antenna, b);
        assert_int_equal(all_at(mid - 50000000, antenna, a), n);
        assert_int_equal(all_at(mid + 50000000, antenna, c), n);
        for (size_t k = 0; k < n; k++)
            for (int i = 0; i < ORR_N_TERMS; i++) {
                const double rate = (c[k].term_m[i] - a[k].term_m[i]) / (2 * h);
                // Rounding is 7e-9 m in 0.1 s. A circle of 900 m in 60 s has a third derivative of 1 m/s^3: h^2/6 of it is 4e-4.
                ASSERT_NEAR(b[k].rate_mps[i], rate, antenna == 0 ? 2e-7 : 5e-4);
            }
    }
}

// --- Slow terms on their lattice ---
#define FLIES                                                                                                \
    "  - {name: BODY, right: 1, forward: 2, up: 3}\n"                                                        \
    "trajectory:\n  kind: analytic\n  start: 2024-02-04T01:00:00\n  duration: 600\n  lat: 52\n  lon: 17\n"   \
    "  height: 500\n  motions:\n    - {kind: straight, east: 60}\n    - {kind: sine, up: 6.9, period: "      \
    "3.333}\n    - {kind: circle, radius: 900, period: 60}\n"

// Every term that is read from a curve, against the term itself.
static void curves_are_the_terms(void **state)
{
    (void)state;
    open_with("ionosphere: {field: " MADE_IONOSPHERE "}\nchannel: {shapiro: yes}\n"
              "signals: [G, R, E]\ntroposphere: {model: saastamoinen}\nmask: {elevation: 2}\n"
              "antennas:\n  - {name: BASE, position: [52, 17, 124]}\n" FLIES);
    const orr_channels *c = orr_engine_channels(engine);
    size_t compared = 0;
    for (size_t antenna = 0; antenna < 2; antenna++)
        for (int k = 0; k < 150; k++) {
            orr_channel x[ROOM];
            orr_antenna_state a;
            const orr_time t = at(3610 + 3.7 * k + 0.0137 * (k % 7));
            const size_t n = all_at(t, antenna, x);
            assert_int_equal(orr_antenna_at(orr_channels_antenna(c, antenna), t, &a), ORR_ANSWER_OK);
            for (size_t i = 0; i < n; i++) {
                if (i > 0 && x[i].sat == x[i - 1].sat) continue;
                uint16_t place = 0;
                slow_values v;
                while (c->satellite[place].sat != x[i].sat) place++;
                slow_at(c, antenna, work, t, &a, false, &place, 1, &v);
                assert_true(v.ok);
                const double allowed =
                    antenna == 0 ? 1.5e-7 : 1.5e-6; // slow_cell.c; beside the middle 3/2 of it
                ASSERT_NEAR(x[i].term_m[ORR_TERM_SHAPIRO], v.v[SLOW_SHAPIRO], allowed);
                ASSERT_NEAR(x[i].term_m[ORR_TERM_TROPOSPHERE_HYDROSTATIC], v.v[SLOW_HYDROSTATIC], allowed);
                ASSERT_NEAR(x[i].term_m[ORR_TERM_TROPOSPHERE_WET], v.v[SLOW_WET], allowed);
                ASSERT_NEAR(x[i].term_m[ORR_TERM_IONOSPHERE],
                            orr_iono_delay_m(v.v[SLOW_CONTENT], x[i].carrier_hz, ORR_MEASURES_CODE), allowed);
                if (antenna == 0)
                    ASSERT_NEAR(x[i].term_m[ORR_TERM_WIND_UP] * x[i].carrier_hz / ORR_LIGHT_MPS,
                                v.v[SLOW_TURNS], 4 * allowed);
                compared++;
            }
        }
    assert_true(compared > 500);
}

static void order_changes_no_byte(void **state)
{
    (void)state;
    open_with(EVERYTHING FLIES);
    enum { N = 60 };
    static orr_channel forward[N][ROOM], y[ROOM];
    size_t n[N];
    const orr_channels *c = orr_engine_channels(engine);
    // 1.7 s apart, past several cells of the lattice.
    for (int k = 0; k < N; k++) n[k] = all_at(at(3650 + 1.7 * k), 1, forward[k]);
    for (int k = N - 1; k >= 0; k -= 7) { // backwards, elsewhere, and in a workspace that knows nothing
        orr_channel_work *fresh;
        size_t m;
        assert_int_equal(orr_channel_work_open(c, &fresh, NULL), ORR_OK);
        for (int pass = 0; pass < 2; pass++) {
            assert_int_equal(
                orr_channels_at(c, 1, pass == 0 ? work : fresh, at(3650 + 1.7 * k), UINT64_MAX, y, &m),
                ORR_ANSWER_OK);
            assert_int_equal(m, n[k]);
            for (size_t i = 0; i < m; i++) {
                assert_memory_equal(y[i].term_m, forward[k][i].term_m, sizeof y[i].term_m);
                assert_memory_equal(y[i].rate_mps, forward[k][i].rate_mps, sizeof y[i].rate_mps);
                assert_true(y[i].carrier_cycles == forward[k][i].carrier_cycles &&
                            y[i].carrier_fraction == forward[k][i].carrier_fraction &&
                            y[i].code_m == forward[k][i].code_m &&
                            y[i].power_dbw == forward[k][i].power_dbw &&
                            y[i].az_rad == forward[k][i].az_rad && y[i].flags == forward[k][i].flags);
            }
        }
        orr_channel_work_close(fresh);
        all_at(at(1000 + 200 * k), 0, y);
    }
}

static void doppler_is_positive_while_approaching(void **state)
{
    (void)state;
    open_with(EVERYTHING);
    orr_channel x[ROOM];
    const size_t n = all_at(at(5000), 0, x);
    int approaching = 0;
    for (size_t k = 0; k < n; k++) {
        const double doppler_hz = -x[k].carrier_rate_hz;
        ASSERT_NEAR(doppler_hz, -x[k].code_rate_mps * x[k].carrier_hz / ORR_LIGHT_MPS, 0.2);
        approaching += doppler_hz > 0;
    }
    assert_true(approaching > 0 && approaching < (int)n);
}

// --- Wind-up ---
static void wind_up_goes_on(void **state)
{
    (void)state;
    open_with(EVERYTHING);
    orr_channel x[ROOM];
    double last[256] = {0};
    bool has[256] = {false};
    for (double t_s = 600; t_s < 20000; t_s += 30) {
        const size_t n = all_at(at(t_s), 0, x);
        for (size_t k = 0; k < n; k++) {
            const orr_signal *s = &orr_signals(&(size_t){0})[x[k].signal];
            if (strcmp(s->observation, "1C") != 0) continue;
            const double turns = x[k].term_m[ORR_TERM_WIND_UP] * x[k].carrier_hz / ORR_LIGHT_MPS;
            const int id = (orr_sat_system_index(x[k].sat) * 32 + orr_sat_number(x[k].sat)) & 255;
            if (has[id]) assert_true(fabs(turns - last[id]) < 0.45);
            last[id] = turns;
            has[id] = true;
        }
    }
}

// A body that turns once to the right under the same satellites winds each carrier by one cycle.
static void a_full_turn_of_the_body_is_a_cycle(void **state)
{
    (void)state;
    open_with(
        "signals: [\"G:L1CA\"]\nmask: {elevation: 20}\nantennas: [{name: BODY}]\n"
        "trajectory:\n  kind: analytic\n  start: 2024-02-04T01:00:00\n  duration: 600\n  lat: 52\n  lon: 17\n"
        "  height: 500\n  body: {follow_course: yes}\n  motions:\n    - {kind: circle, radius: 30, period: "
        "60}\n");
    orr_channel x[ROOM], y[ROOM];
    const orr_span span = orr_channels_span(orr_engine_channels(engine));
    const orr_time t = span.from + 60 * ORR_NS_PER_S;
    const size_t n = all_at(t, 0, x);
    assert_true(n > 0);
    double least = 1, most = 0;
    for (int step = 1; step <= 60; step++) {
        assert_int_equal(all_at(t + step * ORR_NS_PER_S, 0, y), n);
        for (size_t k = 0; k < n; k++) {
            const double cycle = ORR_LIGHT_MPS / x[k].carrier_hz;
            const double turned = (y[k].term_m[ORR_TERM_WIND_UP] - x[k].term_m[ORR_TERM_WIND_UP]) / cycle;
            if (step == 60) { // what is left of one is the satellite's own minute
                least = fmin(least, fabs(turned));
                most = fmax(most, fabs(turned));
            }
        }
    }
    assert_true(least > 0.98 && most < 1.02);
}

// --- Blocks ---
typedef struct worst {
    double error_m, code_joint_m, carrier_joint_m, rate_joint_mps;
    size_t blocks, over;
} worst;

// Blocks one after the other against direct evaluation at 40 instants each.
static worst try_blocks(size_t antenna, orr_time t, int n_blocks, double error_m)
{
    const orr_channels *c = orr_engine_channels(engine);
    static orr_block now[ROOM], before[ROOM];
    static orr_channel direct[ROOM];
    worst w = {0};
    size_t n_before = 0;
    orr_blocks b = {0}, last = {0};
    for (int i = 0; i < n_blocks; i++) {
        size_t n, m;
        assert_int_equal(orr_blocks_at(c, antenna, work, t, UINT64_MAX, &b, now, &n), ORR_ANSWER_OK);
        assert_int_equal(orr_floor_mod(b.t0, b.length_ns), 0);
        assert_true(b.t0 <= t && t < b.t0 + b.length_ns);
        for (size_t k = 0; k < n && i > 0 && b.t0 == last.t0 + last.length_ns && n == n_before; k++) {
            const double T = (double)last.length_ns / 1e9, *q = before[k].code, *f = before[k].carrier;
            int64_t cycles;
            double fraction;
            block_carrier(&before[k], T, &cycles, &fraction);
            const double joint = (double)(cycles - now[k].carrier_cycles) + (fraction - now[k].carrier[0]);
            w.code_joint_m = fmax(w.code_joint_m, fabs(block_code_m(&before[k], T) - now[k].code[0]));
            w.carrier_joint_m = fmax(w.carrier_joint_m, fabs(joint) * ORR_LIGHT_MPS / now[k].at.carrier_hz);
            w.rate_joint_mps =
                fmax(w.rate_joint_mps, fabs(q[1] + T * (2 * q[2] + T * 3 * q[3]) - now[k].code[1]));
            w.rate_joint_mps =
                fmax(w.rate_joint_mps, fabs(f[1] + T * (2 * f[2] + T * 3 * f[3]) - now[k].carrier[1]) * 0.25);
        }
        double here = 0;
        for (int j = 0; j < 40; j++) {
            const int64_t dt = b.length_ns * j / 40;
            assert_int_equal(orr_channels_at(c, antenna, work, b.t0 + dt, UINT64_MAX, direct, &m),
                             ORR_ANSWER_OK);
            for (size_t k = 0; k < n && m == n; k++)
                here = fmax(here, fabs(block_code_m(&now[k], (double)dt / 1e9) - direct[k].code_m));
        }
        w.error_m = fmax(w.error_m, here);
        w.over += here > error_m;
        w.blocks++;
        memcpy(before, now, sizeof now);
        n_before = n;
        last = b;
        t = b.t0 + b.length_ns;
    }
    return w;
}

static void blocks_hold_the_motion(void **state)
{
    (void)state;
    // docs: six motions and flights; motions with the length that the design found for them.
    static const struct {
        const char *motions;
        double least_ms, most_ms;
    } cases[] = {
        {"    - {kind: sine, up: 1, east: 0.5, period: 5}\n", 50, 100}, // survey aircraft, 0.2 Hz
        {"    - {kind: sine, up: 6.9, period: 3.333}\n", 20, 100},      // drape flight: 2.5 g at 0.3 Hz
        {"    - {kind: sine, up: 0.0001, period: 0.02}\n", 5, 10},      // airframe, 50 Hz
        {"    - {kind: sine, up: 0.001, period: 0.05}\n", 5, 20},       // rotor, 20 Hz
        {"    - {kind: sine, up: 0.001, period: 0.025}\n", 2, 10},      // 40 Hz, whose quarters are nodes too
        {"    - {kind: circle, radius: 900, period: 60}\n", 50, 100},   // a turn at 94 m/s
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[1500];
        snprintf(text, sizeof text,
                 "signals: [\"G:L1CA\"]\nmask: {elevation: 15}\nantennas: [{name: BODY}]\n"
                 "trajectory:\n  kind: analytic\n  start: 2024-02-04T01:00:00\n  duration: 60\n  lat: 52\n  "
                 "lon: 17\n"
                 "  height: 500\n  motions:\n    - {kind: straight, east: 60}\n%s",
                 cases[k].motions);
        open_with(text);
        const orr_time from = orr_channels_span(orr_engine_channels(engine)).from + 20 * ORR_NS_PER_S;
        const worst w = try_blocks(0, from, 60, 1e-5);
        size_t n;
        static orr_block block[ROOM];
        orr_blocks b;
        orr_blocks_at(orr_engine_channels(engine), 0, work, from, UINT64_MAX, &b, block, &n);
        assert_true(n > 0);
        assert_in_range((uint64_t)(b.length_ns / 1000000), (uint64_t)cases[k].least_ms,
                        (uint64_t)cases[k].most_ms);
        assert_true(w.error_m < 1.2e-5);
        assert_int_equal(w.over, 0);
        assert_true(w.code_joint_m <= 4e-9 && w.carrier_joint_m <= 1e-9 && w.rate_joint_mps <= 1e-6);
        tear_down(NULL);
    }
}

static void fixed_antennas_have_long_blocks(void **state)
{
    (void)state;
    open_with(EVERYTHING);
    const worst w = try_blocks(0, at(4000.3), 30, 1e-5);
    assert_true(w.error_m < 2e-8); // 5e-8 m/s^4 / 384, and rounding of 8e-9
    assert_true(w.code_joint_m <= 4e-9 && w.carrier_joint_m <= 1e-9 && w.rate_joint_mps <= 1e-6);
}

static void blocks_do_not_remember(void **state)
{
    (void)state;
    static orr_block a[ROOM], b[ROOM];
    orr_blocks x, y;
    size_t n, m;
    open_with(EVERYTHING);
    orr_blocks_at(orr_engine_channels(engine), 0, work, at(9000), UINT64_MAX, &x, a, &n);
    tear_down(NULL);
    open_with(EVERYTHING);
    for (double t = 1000; t < 20000; t += 1111)
        orr_blocks_at(orr_engine_channels(engine), 0, work, at(t), UINT64_MAX, &y, b, &m);
    orr_blocks_at(orr_engine_channels(engine), 0, work, at(9000.7), UINT64_MAX, &y, b, &m);
    assert_int_equal(n, m);
    for (size_t k = 0; k < n; k++) {
        assert_memory_equal(a[k].code, b[k].code, sizeof a[k].code);
        assert_memory_equal(a[k].carrier, b[k].carrier, sizeof a[k].carrier);
        assert_int_equal(a[k].carrier_cycles, b[k].carrier_cycles);
    }
}

// --- Second order of the ionosphere ---
// The dipole of IGRF-13 in 2024, T, at a place, ecef: minus the gradient of its potential a^3 (m . r) / r^3, by differences.
static orr_vec3 dipole_t(orr_vec3 r)
{
    const double a = 6371.2e3, years = 4.095, h = 10;
    const orr_vec3 m = {-1450.9 + 7.4 * years, 4652.5 - 25.9 * years, -29404.8 + 5.7 * years};
    double b[3];
    for (int k = 0; k < 3; k++) {
        double v[2];
        for (int side = 0; side < 2; side++) {
            const double s = side == 0 ? -h : h;
            const orr_vec3 x = {r.x + (k == 0 ? s : 0), r.y + (k == 1 ? s : 0), r.z + (k == 2 ? s : 0)};
            v[side] = a * a * a * orr_vec3_dot(m, x) / pow(orr_vec3_norm(x), 3);
        }
        b[k] = -(v[1] - v[0]) / (2 * h) * 1e-9;
    }
    return (orr_vec3){b[0], b[1], b[2]};
}

// In the North the field points down, along the signals: codes are late, carriers early by half of it; in the South the other way
// round. Centimetres, with 1/f^3, and what the content at the shell and the field there make of it.
static void the_second_order_is_the_magnetic_fields(void **state)
{
    (void)state;
    open_with("signals: [\"G:L1CA\", \"G:L2C\", \"G:L5\"]\nmask: {elevation: 5}\nionosphere: "
              "{field: " MADE_IONOSPHERE "}\n"
              "channel: {second_order: yes}\nantennas:\n  - {name: NORTH, position: [55, 20, 100]}\n"
              "  - {name: SOUTH, position: [-50, 20, 100]}\n");
    const double shell_m = 6821e3;
    double greatest = 0;
    for (size_t antenna = 0; antenna < 2; antenna++) {
        orr_channel x[ROOM];
        size_t high = 0;
        const orr_vec3 r = orr_channels_antenna(orr_engine_channels(engine), antenna)->fixed.r_m;
        for (double t_s = 1000; t_s < 21000; t_s += 4000) {
            const size_t n = all_at(at(t_s), antenna, x);
            for (size_t k = 0; k < n; k++) {
                const double second = x[k].term_m[ORR_TERM_IONOSPHERE_SECOND], f = x[k].carrier_hz;
                orr_sat_state s;
                assert_int_equal(orr_ephemeris_eval(orr_engine_ephemeris(engine), x[k].sat, at(t_s), &s),
                                 ORR_OK);
                const orr_vec3 u = orr_vec3_unit(orr_vec3_sub(s.pos_m, r));
                const double along = orr_vec3_dot(u, r);
                const double way = -along + sqrt(along * along + shell_m * shell_m - orr_vec3_dot(r, r));
                const double field = -orr_vec3_dot(u, dipole_t(orr_vec3_axpy(way, u, r)));
                const double electrons = x[k].term_m[ORR_TERM_IONOSPHERE] * f * f / 40.3;
                ASSERT_NEAR(second, 2 * 1.1284e12 * electrons * field / (f * f * f),
                            1e-5 * fabs(second) + 1e-9);
                greatest = fmax(greatest, fabs(second));
                if (x[k].el_rad > 50 * ORR_RAD_PER_DEG) {
                    assert_true(antenna == 0 ? second > 1e-5 : second < -1e-5);
                    high++;
                }
                if (k > 0 && x[k].sat == x[k - 1].sat) {
                    const double q = x[k - 1].carrier_hz / f;
                    ASSERT_NEAR(second, q * q * q * x[k - 1].term_m[ORR_TERM_IONOSPHERE_SECOND], 1e-12);
                }
                ASSERT_NEAR(orr_term_rows[ORR_TERM_IONOSPHERE_SECOND].carrier,
                            -orr_term_rows[ORR_TERM_IONOSPHERE_SECOND].code / 2, 0);
            }
        }
        assert_true(high > 0);
    }
    print_message("second order: %.1f mm at most\n", 1e3 * greatest);
    assert_true(greatest > 1e-3 && greatest < 0.1);
    tear_down(NULL);
    open_with("signals: [\"G:L5\"]\nionosphere: {field: " MADE_IONOSPHERE
              "}\nantennas: [{name: A, position: [55, 20, 100]}]\n");
    orr_channel x[ROOM];
    const size_t n = all_at(at(5000), 0, x);
    for (size_t k = 0; k < n; k++)
        ASSERT_NEAR(x[k].term_m[ORR_TERM_IONOSPHERE_SECOND], 0, 0); // by default there is none
}

// --- Power ---
static void power_is_the_documents_at_five_degrees(void **state)
{
    (void)state;
    const orr_signal *s = orr_signal_find('G', "L1CA");
    const double r = ORR_EARTH_MEAN_RADIUS_M, a = 26.56e6;
    const orr_scenario_lobes none = {0};
    static const double db[][2] = {{5, 0}, {40, 2}, {90, 0.5}};
    for (int k = 0; k < 3; k++) {
        const double el = db[k][0] * ORR_RAD_PER_DEG, nadir = asin(r * cos(el) / a),
                     turn = ORR_PI / 2 - el - nadir;
        const orr_vec3 antenna = {r, 0, 0}, sat = {a * cos(turn), a * sin(turn), 0};
        ASSERT_NEAR(orr_power_received_dbw(s, sat, antenna, el, &none), s->power_dbw + db[k][1], 1e-9);
    }
    // Beyond the limb, at the limb's range: by the table, linear from the limb on, or by 3 dB a degree.
    orr_scenario_lobe lobe[] = {{10, 7}, {20, -12}, {30, -14}};
    const orr_scenario_lobes lobes = {3, lobe};
    const double limb_deg = asin(r / a) * ORR_DEG_PER_RAD;
    const orr_vec3 high = {a, 0, 0};
    for (double nadir = limb_deg + 0.01; nadir < 60; nadir += 1.7) {
        const double x = nadir * ORR_RAD_PER_DEG, at = 3e7;
        const orr_vec3 far = {a - at * cos(x), at * sin(x), 0},
                       edge = {a - at * cos(limb_deg * ORR_RAD_PER_DEG), at * sin(limb_deg * ORR_RAD_PER_DEG),
                               0};
        const double less =
            orr_power_gain_db(high, far, -1, &lobes) - orr_power_gain_db(high, edge, -1, &lobes);
        const double want = nadir < 20   ? -12 * (nadir - limb_deg) / (20 - limb_deg)
                            : nadir < 30 ? -12 - (nadir - 20) / 5
                                         : -14;
        ASSERT_NEAR(less, want,
                    1e-5); // at the limb an elevation is the arc cosine of 1, to the root of a rounding
        ASSERT_NEAR(orr_power_gain_db(high, far, -1, &none) - orr_power_gain_db(high, edge, -1, &none),
                    -fmin(3 * (nadir - limb_deg), 20), 1e-5);
    }
    // Twice the range, 6.02 dB; and the atmosphere at the zenith.
    ASSERT_NEAR(orr_power_space_loss_db(2e7, 1.5e9) - orr_power_space_loss_db(1e7, 1.5e9), 20 * log10(2),
                1e-9);
    ASSERT_NEAR(orr_power_atmosphere_db(ORR_PI / 2), 0.035, 1e-12);
}

// What a block sends, and how strong: L1C of Block III alone, L5 from IIF on, 1.5 dB more of L2C from III on; what no file names a
// block of is as the signal's own row.
static void blocks_send_their_signals(void **state)
{
    (void)state;
    static const struct {
        char system;
        const char *name, *block;
        double dbw; // 0: not sent
    } want[] = {{'G', "L1CA", "BLOCK IIR-A", -158.5},
                {'G', "L1C", "BLOCK IIF", 0},
                {'G', "L1C", "BLOCK IIIA", -157},
                {'G', "L2C", "BLOCK IIA", 0},
                {'G', "L2C", "GPS-IIR-M", -160},
                {'G', "L2C", "BLOCK IIIA", -158.5},
                {'G', "L2C", "BLOCK IIR-B", 0},
                {'G', "L5", "BLOCK IIR-M", 0},
                {'G', "L5", "GPS-IIF", -154.9},
                {'G', "L5", "GPS-IIIA", -154},
                {'G', "L5", "", -154.9},
                {'G', "L2P", "BLOCK IIA", -164.5},
                {'G', "L2P", "BLOCK IIF", -161.5},
                {'C', "B1C", "BEIDOU-2I", 0},
                {'C', "B1C", "BEIDOU-3I", -161},
                {'C', "B1C", "BEIDOU-3M-CAST", -159},
                {'R', "L2OF", "GLONASS-M", -167},
                {'R', "L2OF", "GLONASS-K1", -161},
                {'R', "L3OC", "GLONASS-K1", -158},
                {'R', "L3OC", "GLONASS-M", -158},
                {'R', "L3OC", "GLONASS", 0},
                {'J', "L5", "QZSS", -154.9},
                {'J', "L5", "QZSS-2I", -154},
                {'E', "E1", "GALILEO-2", -157.25}};
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        double dbw = 0;
        const bool sends =
            orr_signal_of_block(orr_signal_find(want[k].system, want[k].name), want[k].block, &dbw);
        assert_true(sends == (want[k].dbw < 0));
        if (sends) ASSERT_NEAR(dbw, want[k].dbw, 0);
    }
    double dbw;
    assert_true(orr_signal_of_block(orr_signal_find('G', "L5"), NULL, &dbw));
}

// --- The scenario ---
static void satellites_and_masks(void **state)
{
    (void)state;
    orr_channel x[ROOM];
    open_with("signals: [G]\nsatellites: {exclude: G02, unhealthy: G03, power: [{sats: G01, db: -3}]}\n"
              "mask: {elevation: -10}\nantennas: [{name: A, position: [52, 17, 124]}]\n");
    const size_t n = all_at(at(5000), 0, x);
    for (size_t k = 0; k < n; k++) {
        assert_int_equal(orr_sat_system(x[k].sat), 'G');
        assert_int_not_equal(orr_sat_number(x[k].sat), 2);
        assert_int_equal((x[k].flags & ORR_CHANNEL_UNHEALTHY) != 0, orr_sat_number(x[k].sat) == 3);
    }
    tear_down(NULL);
    open_with("signals: [G, R, E]\nmask: {elevation: 0, horizon: [{azimuth: 0, elevation: 0}, {azimuth: 180, "
              "elevation: 80}]}\n"
              "antennas: [{name: A, position: [52, 17, 124]}]\n");
    for (double t = 1000; t < 20000; t += 2000) {
        const size_t m = all_at(at(t), 0, x);
        for (size_t k = 0; k < m; k++) {
            const double az = x[k].az_rad * ORR_DEG_PER_RAD, el = x[k].el_rad * ORR_DEG_PER_RAD;
            const double least = (az < 180 ? az : 360 - az) / 180 * 80;
            assert_true(el >= least - 1e-9);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(the_range_is_that_of_inertial_space, tear_down),
        cmocka_unit_test(shapiro_is_of_two_centimetres),
        cmocka_unit_test_teardown(terms_sum_to_code_and_carrier, tear_down),
        cmocka_unit_test_teardown(rates_are_derivatives, tear_down),
        cmocka_unit_test_teardown(curves_are_the_terms, tear_down),
        cmocka_unit_test_teardown(order_changes_no_byte, tear_down),
        cmocka_unit_test_teardown(doppler_is_positive_while_approaching, tear_down),
        cmocka_unit_test_teardown(the_second_order_is_the_magnetic_fields, tear_down),
        cmocka_unit_test_teardown(wind_up_goes_on, tear_down),
        cmocka_unit_test_teardown(a_full_turn_of_the_body_is_a_cycle, tear_down),
        cmocka_unit_test_teardown(blocks_hold_the_motion, tear_down),
        cmocka_unit_test_teardown(fixed_antennas_have_long_blocks, tear_down),
        cmocka_unit_test_teardown(blocks_do_not_remember, tear_down),
        cmocka_unit_test(power_is_the_documents_at_five_degrees),
        cmocka_unit_test(blocks_send_their_signals),
        cmocka_unit_test_teardown(satellites_and_masks, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Channels of real orbits, clocks, maps, antennas and biases: nothing steps in a day, and blocks hold flights. By default a few
// minutes of each; the whole day and longer flights with ORRERY_WHOLE_DAY set.
#include "src/make/orbit.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/engine/engine.h"
#include "testing.h"

#include "block_at.h"

#define PRODUCT ORR_BINARY_DIR "/real_channels.nc"
#define SATS "G01-G09,G13,G17,G22,G24,R01-R05,R09"
enum { ROOM = 300 };
#define STEP_NS (ORR_NS_PER_S / 40)

static char maps[512], antex[512], bias[512];
static bool have;
static orr_engine *engine;
static orr_channel_work *work;

static bool whole(void) { return getenv("ORRERY_WHOLE_DAY") != NULL; }

static int set_up(void **state)
{
    (void)state;
    static char sp3[3][512];
    static const char *const names[] = {"2024-035/COD0OPSFIN_20240340000_01D_05M_ORB.SP3.gz",
                                        "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz",
                                        "2024-035/COD0OPSFIN_20240360000_01D_05M_ORB.SP3.gz"};
    const char *paths[3];
    orr_sat_set sats;
    orr_diag diag = {0};
    have = orr_test_data("2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz", maps, sizeof maps) &&
           orr_test_data("antex/igs20-small.atx.gz", antex, sizeof antex) &&
           orr_test_data("2024-035/COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz", bias, sizeof bias);
    for (int k = 0; k < 3; k++) {
        have = have && orr_test_data(names[k], sp3[k], sizeof sp3[k]);
        paths[k] = sp3[k];
    }
    if (!have) return 0;
    ASSERT_OK(orr_sat_set_parse(SATS, &sats, &diag), diag);
    orr_orbit_plan plan = orr_orbit_plan_default();
    // The day and the one after, so that a joint of files lies at its end; all three for the whole.
    plan.sp3 = whole() ? paths : &paths[1];
    plan.n_sp3 = whole() ? 3 : 2;
    plan.smoother.sats = &sats;
    orr_orbit_made made;
    ASSERT_OK(orr_orbit_make(&plan, NULL, NULL, &made, NULL, &diag), diag);
    ASSERT_OK(orr_ephemeris_save(made.ephemeris, PRODUCT, "made for a test", &diag), diag);
    orr_orbit_made_free(&made);
    return 0;
}

static void open_with(const char *rest)
{
    char text[6000];
    orr_scenario s;
    orr_diag diag = {0};
    snprintf(text, sizeof text,
             "orbit: {product: " PRODUCT "}\nnavdata: {window: none}\nionosphere: {field: %s}\n"
             "channel: {antex: %s, bias: %s}\ntroposphere: {model: saastamoinen}\nmask: {elevation: 5}\n%s",
             maps, antex, bias, rest);
    ASSERT_OK(orr_scenario_parse("test", text, strlen(text), NULL, NULL, &s, &diag), diag);
    ASSERT_OK(orr_engine_open(&s, NULL, NULL, NULL, &engine, &diag), diag);
    orr_scenario_free(&s);
    ASSERT_OK(orr_channel_work_open(orr_engine_channels(engine), &work, &diag), diag);
}

static int tear_down(void **state)
{
    (void)state;
    orr_channel_work_close(work);
    work = NULL;
    orr_engine_close(engine);
    engine = NULL;
    return 0;
}

static size_t all_at(orr_time t, orr_channel *out)
{
    size_t n;
    assert_true(orr_channels_max(orr_engine_channels(engine)) <= ROOM);
    assert_int_equal(orr_channels_at(orr_engine_channels(engine), 0, work, t, UINT64_MAX, out, &n),
                     ORR_ANSWER_OK);
    return n;
}

// --- Nothing steps ---
typedef struct steps {
    double code_m, carrier_m; // the greatest
    size_t tried, over;       // over 5e-8 m
} steps;

// What value and rate of three instants contradict each other by: a step, or nothing. Simpson's rule errs by h^5 / 2880 of the fifth
// derivative, 1e-20 m of an orbit, and by h^2 / 40 of a second derivative's jump: where maps of the ionosphere meet, their corner of
// up to 2e-4 m/s is rounded within 0.6 s, and that is 1e-8 m of 25 ms.
static double step_of(double rise, double r0, double rm, double r1, double h)
{
    return fabs(rise - h / 6 * (r0 + 4 * rm + r1));
}

// All channels through a stretch, an interval after the other.
static void walk(orr_time from, orr_time to, int64_t h_ns, steps *s)
{
    static orr_channel x[3][ROOM];
    const double h = (double)h_ns / 1e9;
    size_t n[3];
    n[2] = all_at(from, x[2]);
    for (orr_time t = from; t + h_ns <= to; t += h_ns) {
        memcpy(x[0], x[2], n[2] * sizeof x[0][0]);
        n[0] = n[2];
        n[1] = all_at(t + h_ns / 2, x[1]);
        n[2] = all_at(t + h_ns, x[2]);
        size_t at[3] = {0};
        for (; at[0] < n[0]; at[0]++) {
            const orr_channel *a = &x[0][at[0]];
            bool there = true;
            for (int k = 1; k < 3; k++) {
                while (at[k] < n[k] && (x[k][at[k]].sat < a->sat ||
                                        (x[k][at[k]].sat == a->sat && x[k][at[k]].signal < a->signal)))
                    at[k]++;
                there = there && at[k] < n[k] && x[k][at[k]].sat == a->sat && x[k][at[k]].signal == a->signal;
            }
            if (!there) continue;
            const orr_channel *m = &x[1][at[1]], *b = &x[2][at[2]];
            const double wave = ORR_LIGHT_MPS / a->carrier_hz;
            const double code =
                step_of(b->code_m - a->code_m, a->code_rate_mps, m->code_rate_mps, b->code_rate_mps, h);
            const double carrier =
                wave * step_of((double)(b->carrier_cycles - a->carrier_cycles) +
                                   (b->carrier_fraction - a->carrier_fraction),
                               a->carrier_rate_hz, m->carrier_rate_hz, b->carrier_rate_hz, h);
            s->code_m = fmax(s->code_m, code);
            s->carrier_m = fmax(s->carrier_m, carrier);
            s->tried++;
            if (code > 5e-8 || carrier > 5e-8) {
                if (s->over++ < 10)
                    print_message("%u signal %u at %.3f s: %.3g, %.3g m\n", a->sat, a->signal,
                                  (double)(t % (86400 * ORR_NS_PER_S)) / 1e9, code, carrier);
            }
        }
    }
}

#define ANTENNA "antennas: [{name: A, position: [52, 17, 150], type: \"AERAT1675_120   SPKE\"}]\n"

static void nothing_steps_in_a_day(void **state)
{
    (void)state;
    if (!have) SKIP_NO_DATA("2024-035");
    open_with("signals: [\"G:L1CA\", \"G:L2P\", \"R:L1OF\"]\n" ANTENNA);
    const orr_span span = orr_channels_span(orr_engine_channels(engine));
    steps s = {0};
    if (whole()) {
        walk(span.from, span.to, STEP_NS, &s);
    } else { // about both ends, an hour of the maps, noon
        static const double at_s[] = {1, 3570, 43170, 70000, 86330};
        for (size_t k = 0; k < sizeof at_s / sizeof *at_s; k++) {
            const orr_time from = orr_time_add_s(span.from, at_s[k]);
            walk(from, from + 60 * ORR_NS_PER_S < span.to ? from + 60 * ORR_NS_PER_S : span.to, STEP_NS, &s);
        }
    }
    print_message("%zu intervals of channels: code steps by %.3g m at most, carrier by %.3g m\n", s.tried,
                  s.code_m, s.carrier_m);
    assert_true(s.tried > 10000);
    assert_int_equal(s.over, 0);
}

// --- Blocks hold motions and flights ---
typedef struct worst {
    double error_m;
    size_t blocks, over;
} worst;

// Blocks spread over a stretch, all channels of each at 40 instants.
static worst try_blocks(orr_time from, orr_time to, size_t n_blocks)
{
    const orr_channels *c = orr_engine_channels(engine);
    static orr_block block[ROOM];
    static orr_channel direct[ROOM];
    worst w = {0};
    for (size_t i = 0; i < n_blocks; i++) {
        size_t n;
        orr_blocks b;
        const orr_time t = from + (orr_time)((double)(to - from) * (double)i / (double)n_blocks);
        assert_int_equal(orr_blocks_at(c, 0, work, t, UINT64_MAX, &b, block, &n), ORR_ANSWER_OK);
        double here = 0;
        for (int j = 1; j < 40; j++) {
            const int64_t dt = b.length_ns * j / 40;
            const double s = (double)dt / 1e9;
            const size_t m = all_at(b.t0 + dt, direct);
            for (size_t k = 0, q = 0; k < n; k++) {
                while (q < m && (direct[q].sat < block[k].at.sat ||
                                 (direct[q].sat == block[k].at.sat && direct[q].signal < block[k].at.signal)))
                    q++;
                if (q == m || direct[q].sat != block[k].at.sat || direct[q].signal != block[k].at.signal)
                    continue;
                int64_t cycles;
                double fraction;
                block_carrier(&block[k], s, &cycles, &fraction);
                const double off =
                    (double)(cycles - direct[q].carrier_cycles) + (fraction - direct[q].carrier_fraction);
                here = fmax(here, fabs(block_code_m(&block[k], s) - direct[q].code_m));
                here = fmax(here, fabs(off) * ORR_LIGHT_MPS / direct[q].carrier_hz);
            }
        }
        w.error_m = fmax(w.error_m, here);
        w.over += here > 1e-5;
        w.blocks++;
    }
    return w;
}

#define MOTION(text)                                                                                         \
    "trajectory:\n  kind: analytic\n  start: 2024-02-04T10:00:00\n  duration: 120\n  lat: 52\n  lon: 17\n"   \
    "  height: 500\n  motions:\n    - {kind: straight, east: 60}\n" text

static void blocks_hold_motions_and_flights(void **state)
{
    (void)state;
    if (!have) SKIP_NO_DATA("2024-035");
    static const struct {
        const char *name, *text; // every third without ORRERY_WHOLE_DAY; the unit test has the motions too
    } cases[] = {
        {"0.2 Hz, 1 m", MOTION("    - {kind: sine, up: 1, east: 0.5, period: 5}\n")},
        {"0.3 Hz, 2.5 g", MOTION("    - {kind: sine, up: 6.9, period: 3.333}\n")},
        {"turn of 900 m", MOTION("    - {kind: circle, radius: 900, period: 60}\n")},
        {"50 Hz, 0.1 mm", MOTION("    - {kind: sine, up: 0.0001, period: 0.02}\n")},
        {"20 Hz, 1 mm", MOTION("    - {kind: sine, up: 0.001, period: 0.05}\n")},
        {"40 Hz, 1 mm", MOTION("    - {kind: sine, up: 0.001, period: 0.025}\n")},
        {"survey flight",
         "trajectory: {kind: survey, start: 2024-02-04T10:00:00, duration: 900, lat: 56, lon: 40, "
         "height: 1500, turbulence: {rms: 0.5}, oscillation: {roll: {rms: 0.8}}}\n"},
        {"drape flight",
         "trajectory: {kind: survey, start: 2024-02-04T10:00:00, duration: 900, lat: 46, lon: 8, "
         "height: 2500, speed: 90, turbulence: {rms: 4, low: 0.02, high: 0.3}, oscillation: "
         "{roll: {rms: 5}, pitch: {rms: 3}}}\n"},
        {"a flight's log",
         "trajectory: {kind: telemetry, telemetry: [{file: " ORR_SOURCE_DIR
         "/samples/telemetry.csv, columns: \"t,lat,lon,height,heading,pitch,roll,-,-,-\"}], start: "
         "2024-02-04T10:00:00}\n"},
    };
    size_t blocks = 0, over = 0;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k += whole() ? 1 : 3) {
        char text[3000];
        snprintf(
            text, sizeof text,
            "signals: [\"G:L1CA\", \"G:L2P\"]\nantennas: [{name: A, right: 0.2, forward: 1.5, up: 1.1, type: "
            "\"AERAT1675_120   SPKE\"}]\n%s",
            cases[k].text);
        open_with(text);
        const orr_span span = orr_channels_antenna_span(orr_engine_channels(engine), 0);
        const worst w =
            try_blocks(span.from + 15 * ORR_NS_PER_S, span.to - 15 * ORR_NS_PER_S, whole() ? 4000 : 60);
        print_message("%s: %zu blocks, worst %.3g m, %zu over\n", cases[k].name, w.blocks, w.error_m, w.over);
        assert_true(w.error_m < 1.2e-5);
        blocks += w.blocks;
        over += w.over;
        tear_down(NULL);
    }
    assert_true((double)over <= 1e-3 * (double)blocks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(nothing_steps_in_a_day, tear_down),
        cmocka_unit_test_teardown(blocks_hold_motions_and_flights, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}

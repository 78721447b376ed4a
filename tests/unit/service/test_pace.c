// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario's clock against wall and generator on simulated clocks: drift, holes, steps, suspends, PPS0.
#include "src/service/live/pace.h"

#include "core/rng.h"
#include "testing.h"

static const int64_t S = ORR_NS_PER_S, MS = 1000000, NONE = ORR_TIME_NONE;
static const int64_t UNIX_2024 = INT64_C(1707048900) * ORR_NS_PER_S; // 2024-02-04T12:15:00Z

// A host whose clocks are numbers, and a generator whose clock drifts against it.
typedef struct world {
    orr_host h;
    double drift;
    int64_t radio_ns; // the generator's elapsed time
} world;

static void pass(world *w, int64_t ns)
{
    w->h.mono_ns += ns;
    w->h.boot_ns += ns;
    w->h.real_ns += ns;
    w->h.tai_ns += ns;
    w->radio_ns += ns + (int64_t)llround((double)ns * w->drift);
}

static world begin(double drift)
{
    return (world){.h = {77 * S, 77 * S, UNIX_2024, UNIX_2024 + 37 * S}, .drift = drift, .radio_ns = 5 * S};
}

static uint16_t control(orr_pace *p, const world *w, uint8_t action, uint8_t reference, orr_time t,
                        orr_time at, int64_t delay)
{
    const orr_msg_control m = {.action = action, .reference = reference, .t = t, .at = at, .delay = delay};
    orr_server_refusal why;
    return orr_pace_control(p, &w->h, &m, &why);
}

static uint16_t tell(orr_pace *p, const world *w, int64_t late_ns)
{
    const orr_msg_radio_time m = {w->radio_ns, w->h.mono_ns + late_ns, ORR_MSG_STAMP_CLOCK_MONOTONIC};
    orr_server_refusal why;
    return orr_pace_radio(p, &w->h, &m, &why);
}

static orr_time now(const orr_pace *p, const world *w) { return orr_clock_at(&p->clock, w->h.mono_ns); }

static void the_wall(void **state)
{
    (void)state;
    world w = begin(0);
    orr_pace p;
    orr_pace_init(&p, 1000 * S, NULL);
    // 2024-02-04T12:15:00Z is 12:15:18 of the GPS scale
    const orr_time wall = 1391084118 * S;
    assert_int_equal(orr_pace_wall(&p, &w.h), wall);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_START, 0, NONE, wall - 1, 0),
                     ORR_MSG_ERROR_CODE_BAD_REQUEST);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_START, 0, NONE, wall + 10 * S, 0), 0);
    orr_msg_time t;
    orr_pace_time(&p, &w.h, &t);
    assert_true(t.state == ORR_MSG_CLOCK_STATE_WAITING && t.t == 990 * S);
    pass(&w, 10 * S + 250 * MS);
    orr_pace_time(&p, &w.h, &t);
    assert_true(t.state == ORR_MSG_CLOCK_STATE_RUNNING && t.t == 1000 * S + 250 * MS);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_START, 0, NONE, NONE, 0),
                     ORR_MSG_ERROR_CODE_BAD_REQUEST);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_PAUSE, 0, NONE, NONE, 0), 0);
    pass(&w, 100 * S);
    assert_int_equal(now(&p, &w), 1000 * S + 250 * MS);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_START, 0, NONE, NONE, 20 * MS), 0);
    pass(&w, 20 * MS);
    assert_int_equal(now(&p, &w), 1000 * S + 250 * MS);
    pass(&w, S);
    assert_int_equal(now(&p, &w), 1001 * S + 250 * MS);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_STOP, 0, NONE, NONE, 0), 0);
    assert_int_equal(now(&p, &w), 1000 * S);
}

// Suspended for a minute: the wall went on, and so did the scenario. Set by an hour: a scenario under way keeps its pace, a start at
// an instant of the wall keeps its instant.
static void suspend_and_set(void **state)
{
    (void)state;
    world w = begin(0);
    orr_pace p;
    orr_pace_init(&p, 1000 * S, NULL);
    orr_pace_host(&p, &w.h);
    const orr_time at = orr_pace_wall(&p, &w.h) + 7200 * S;
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_START, 0, NONE, at, 0), 0);
    pass(&w, S);
    w.h.real_ns += 3600 * S;
    orr_pace_host(&p, &w.h);
    assert_int_equal(now(&p, &w), 1000 * S - 3599 * S);
    pass(&w, 3600 * S);
    orr_pace_host(&p, &w.h);
    assert_int_equal(now(&p, &w), 1001 * S);
    w.h.real_ns -= 1800 * S;
    orr_pace_host(&p, &w.h);
    assert_int_equal(now(&p, &w), 1001 * S);
    w.h.boot_ns += 60 * S;
    w.h.real_ns += 60 * S;
    w.h.tai_ns += 60 * S;
    orr_pace_host(&p, &w.h);
    assert_int_equal(now(&p, &w), 1061 * S);
    assert_true(p.sets == 2 && p.suspends == 1);
}

// ARM, WAIT_PPS, START at PPS0 + 100 ms against a generator 50 ppm fast, told 100 times a second with 20 us of jitter: the scenario has
// the generator's time, to a few microseconds once the loop has settled; 3 s without a word cost no more than its rate's error.
static void a_generator_that_drifts(void **state)
{
    (void)state;
    world w = begin(50e-6);
    orr_pace p;
    orr_pace_init(&p, 0, NULL);
    assert_int_equal(
        control(&p, &w, ORR_MSG_CONTROL_ACTION_ARM, ORR_MSG_CLOCK_REFERENCE_RADIO, NONE, NONE, 0),
        ORR_MSG_ERROR_CODE_BAD_REQUEST); // not known yet
    assert_int_equal(tell(&p, &w, 0), 0);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_WAIT_PPS, 0, 2000 * S, NONE, 0),
                     ORR_MSG_ERROR_CODE_BAD_REQUEST);
    assert_int_equal(
        control(&p, &w, ORR_MSG_CONTROL_ACTION_ARM, ORR_MSG_CLOCK_REFERENCE_RADIO, NONE, NONE, 0), 0);
    pass(&w, 300 * MS);
    assert_int_equal(tell(&p, &w, 0), 0);
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_WAIT_PPS, 0, 2000 * S, NONE, 0), 0);
    assert_int_equal(p.pps0_ns, 6 * S); // 5.3 s have elapsed: the next whole second
    assert_int_equal(control(&p, &w, ORR_MSG_CONTROL_ACTION_START, 0, NONE, NONE, 100 * MS), 0);
    double worst_ns = 0;
    for (uint64_t k = 0; k < 6000; k++) { // a minute
        pass(&w, 10 * MS);
        const int64_t jitter = (int64_t)(orr_rng_u64(1, k, 0) % 40001) - 20000;
        assert_int_equal(tell(&p, &w, jitter), 0);
        const orr_time truth = 2000 * S + (w.radio_ns - 6 * S);
        if (k > 2000) worst_ns = fmax(worst_ns, fabs((double)(now(&p, &w) - truth)));
    }
    // Uniform jitter of 20 us has 11.5 us RMS; 2 s of samples leave 11.5 / sqrt(200) < 1 us, and six times that is not met.
    assert_true(worst_ns < 5000);
    ASSERT_NEAR(p.radio.rate, 50e-6, 0.5e-6);
    orr_msg_pace told;
    orr_pace_told(&p, &w.h, now(&p, &w) + 20 * MS, &told);
    ASSERT_NEAR(told.wander_ns, 20000 / sqrt(3), 2500);
    ASSERT_NEAR((double)told.until_air, 20e6 / (1 + 50e-6), 2);
    pass(&w, 3 * S);
    const orr_time truth = 2000 * S + (w.radio_ns - 6 * S);
    assert_true(llabs(now(&p, &w) - truth) < 5000 + 1500); // 0.5 ppm in 3 s
    assert_int_equal(tell(&p, &w, 0), 0);
    assert_int_equal(p.steps, 0);
}

// The generator's clock is put 3 s on: one sample is not believed, two are; then the scenario has its time.
static void a_generator_that_steps(void **state)
{
    (void)state;
    world w = begin(0);
    orr_pace p;
    orr_pace_init(&p, 0, NULL);
    for (int k = 0; k < 50; k++, pass(&w, 10 * MS)) assert_int_equal(tell(&p, &w, 0), 0);
    assert_int_equal(
        control(&p, &w, ORR_MSG_CONTROL_ACTION_START, ORR_MSG_CLOCK_REFERENCE_RADIO, NONE, NONE, 0), 0);
    const int64_t first = w.radio_ns;
    w.radio_ns += 3 * S;
    assert_int_equal(tell(&p, &w, 0), 0);
    assert_true(now(&p, &w) == 0 && p.steps == 0);
    pass(&w, 10 * MS);
    assert_int_equal(tell(&p, &w, 0), 0);
    assert_true(p.steps == 1 && now(&p, &w) == w.radio_ns - first);
    // The host sleeps for 10 s; the generator does not.
    orr_pace_host(&p, &w.h);
    w.h.boot_ns += 10 * S, w.h.real_ns += 10 * S, w.h.tai_ns += 10 * S, w.radio_ns += 10 * S;
    orr_pace_host(&p, &w.h);
    assert_int_equal(now(&p, &w), w.radio_ns - first);
    assert_int_equal(tell(&p, &w, 0), 0);
    assert_int_equal(p.steps, 1);
}

static void stamps(void **state)
{
    (void)state;
    world w = begin(0);
    orr_pace p;
    orr_server_refusal why;
    orr_pace_init(&p, 0, NULL);
    const orr_msg_radio_time good[] = {{5 * S, 0, ORR_MSG_STAMP_CLOCK_ARRIVAL},
                                       {5 * S, w.h.mono_ns, ORR_MSG_STAMP_CLOCK_MONOTONIC},
                                       {5 * S, w.h.tai_ns, ORR_MSG_STAMP_CLOCK_TAI},
                                       {5 * S, w.h.real_ns, ORR_MSG_STAMP_CLOCK_REALTIME}};
    for (int k = 0; k < 4; k++) {
        assert_int_equal(orr_pace_radio(&p, &w.h, &good[k], &why), 0);
        assert_int_equal(p.radio.host_ns, w.h.mono_ns);
    }
    const orr_msg_radio_time bad[] = {{-1, 0, 0},
                                      {INT64_MAX, 0, 0},
                                      {5 * S, 0, ORR_MSG_STAMP_CLOCK_TAI},
                                      {5 * S, 0, 9},
                                      {5 * S, w.h.mono_ns + 2 * S, ORR_MSG_STAMP_CLOCK_MONOTONIC},
                                      {5 * S, w.h.mono_ns - 1, ORR_MSG_STAMP_CLOCK_MONOTONIC},
                                      {5 * S, INT64_MIN, ORR_MSG_STAMP_CLOCK_REALTIME}};
    for (int k = 0; k < 7; k++)
        assert_int_equal(orr_pace_radio(&p, &w.h, &bad[k], &why), ORR_MSG_ERROR_CODE_BAD_REQUEST);
}

// What TIME tells, against tables: week 2300 began 2024-02-04; N4 = 8 from 2024 on, 4 February is day 35.
static void what_time_it_is(void **state)
{
    (void)state;
    const world w = begin(0);
    orr_pace p;
    orr_msg_time m;
    orr_pace_init(&p, 1391084118 * S + 5, NULL); // 2024-02-04T12:15:00 UTC
    orr_pace_time(&p, &w.h, &m);
    assert_true(m.week == 2300 && m.tow == (12 * 3600 + 15 * 60 + 18) * S + 5);
    assert_true(m.leap.gps_utc_s == 18 && m.leap.next == ORR_TIME_NONE && m.utc_mjd == 60344);
    assert_true(m.n4 == 8 && m.nt == 35 && m.utc_su == (15 * 3600 + 15 * 60) * S + 5);
    orr_pace_init(&p, 1167264000 * S, NULL); // 2016-12-31T23:59:43 UTC
    orr_pace_time(&p, &w.h, &m);
    assert_true(m.leap.gps_utc_s == 17 && m.leap.next_gps_utc_s == 18 && m.leap.next == 1167264018 * S);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_wall),
        cmocka_unit_test(suspend_and_set),
        cmocka_unit_test(a_generator_that_drifts),
        cmocka_unit_test(a_generator_that_steps),
        cmocka_unit_test(stamps),
        cmocka_unit_test(what_time_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Live motion: joints keep value, rate and acceleration; what was made is not contradicted; how far predictions are from the truth,
// against closed forms; and that a recording gives the same motion.
#include "src/service/live/course.h"

#include "core/earth.h"
#include "core/rng.h"
#include "testing.h"

static const int64_t MS = 1000000;
static const orr_time T0 = 1391040900 * ORR_NS_PER_S;

// A body that pulls 2.5 g with a jerk of 100 m/s3: acceleration A sin(w t) along x, at 100 m/s, turning.
static const double A = 24.5, W = 100 / 24.5;

static orr_course_sample truth(orr_time t, int order, int angular_order)
{
    const double s = orr_time_diff_s(t, T0);
    const orr_vec3 place = orr_earth_to_ecef((orr_geodetic){0.97, 0.69, 1500});
    const orr_vec3 g = {0.1 * s, 0.02 * s, 0.3 * s};
    orr_course_sample x = {
        .t = t, .order = order, .angular_order = angular_order, .q = orr_quat_from_rotvec(g)};
    x.x[0] = orr_vec3_add(place, (orr_vec3){-A / W / W * sin(W * s), 100 * s, 0});
    if (order >= 1) x.x[1] = (orr_vec3){-A / W * cos(W * s), 100, 0};
    if (order >= 2) x.x[2] = (orr_vec3){A * sin(W * s), 0, 0};
    if (order >= 3) x.x[3] = (orr_vec3){A * W * cos(W * s), 0, 0};
    if (angular_order >= 2) x.w[0] = (orr_vec3){0.1, 0.02, 0.3};
    return x;
}

static orr_course *course(double join_s)
{
    orr_course *k = malloc(sizeof *k);
    orr_course_init(k, join_s);
    return k;
}

static orr_course_state block_of(orr_course *k, orr_time t0, orr_time t1, int64_t *age, orr_motion *begin,
                                 orr_motion *end)
{
    bool antenna;
    const orr_course_state s = orr_course_block(k, t0, t1, age);
    if (s != ORR_COURSE_NONE)
        assert_true(orr_course_at(k, t0, false, begin, &antenna) &&
                    orr_course_at(k, t1, true, end, &antenna));
    return s;
}

static orr_course_state block(orr_course *k, orr_time t0, orr_time t1, orr_motion *begin, orr_motion *end)
{
    int64_t age;
    return block_of(k, t0, t1, &age, begin, end);
}

static double apart(orr_vec3 a, orr_vec3 b) { return orr_vec3_norm(orr_vec3_sub(a, b)); }

static double turned(orr_quat a, orr_quat b)
{
    const orr_quat d = orr_quat_mul((orr_quat){a.w, -a.x, -a.y, -a.z}, b);
    return 2 * sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

// Samples every 10 ms that come 50 ms late: errors are those of Taylor's remainder.
static void predictions(void **state)
{
    (void)state;
    const double snap = A * W * W, t = 0.05;
    // Of order 2 the jerk comes from accelerations 20 ms apart: it is 10 ms old.
    const double remainder_m[] = {0, A / 2 * t * t, snap * (t * t * t * t / 24 + 0.01 * t * t * t / 6),
                                  snap * t * t * t * t / 24};
    for (int order = 1; order <= 3; order++) {
        orr_course *k = course(0);
        double worst = 0;
        for (int n = 0; n < 2000; n++) {
            const orr_time t0 = T0 + n * 5 * MS;
            orr_motion a, b;
            if (n % 2 == 0) {
                const orr_course_sample s = truth(t0 - 50 * MS, order, 1);
                orr_course_add(k, &s);
            }
            assert_true(block(k, t0, t0 + 5 * MS, &a, &b) != ORR_COURSE_NONE);
            if (n > 20 && n % 2 == 0)
                worst = fmax(worst, apart(a.r_m, truth(t0, order, 1).x[0])); // exactly 50 ms old
        }
        assert_true(worst <= remainder_m[order] * 1.03 && worst > remainder_m[order] * 0.85);
        free(k);
    }
}

// The bar: 100 Hz with acceleration, 2 % lost and up to 30 ms late: blocks join in value, rate and acceleration, nothing jumps,
// and what is served is within millimetres of the truth.
static void joints(void **state)
{
    (void)state;
    orr_course *k = course(0.065);
    orr_motion a, b, last = {.r_m = {0, 0, 0}};
    double value = 0, rate = 0, acceleration = 0, attitude = 0, off = 0, oldest = 0;
    int64_t age = 0;
    int next = 0, joined = 0;
    for (int n = 0; n < 20000; n++) { // 100 s of blocks of 5 ms
        const orr_time t = T0 + n * 5 * MS;
        for (; T0 + next * 10 * MS + (int64_t)(orr_rng_u64(1, (uint64_t)next, 0) % 30) * MS <= t; next++) {
            const orr_course_sample s = truth(T0 + next * 10 * MS, 2, 2);
            if (next == 0 || orr_rng_u64(2, (uint64_t)next, 0) % 50 != 0) orr_course_add(k, &s);
        }
        const orr_course_state s = block_of(k, t, t + 5 * MS, &age, &a, &b);
        if (s == ORR_COURSE_NONE) continue;
        joined += s == ORR_COURSE_JOINING;
        if (n > 0 && last.r_m.x != 0) {
            value = fmax(value, apart(a.r_m, last.r_m));
            rate = fmax(rate, apart(a.v_mps, last.v_mps));
            acceleration = fmax(acceleration, apart(a.a_mps2, last.a_mps2));
            attitude = fmax(attitude, turned(a.q_be, last.q_be));
        }
        oldest = fmax(oldest, (double)age / 1e6);
        const double m = apart(a.r_m, truth(t, 0, 1).x[0]);
        if (n > 200) off = fmax(off, m);
        last = b;
    }
    assert_true(joined > 1000);
    assert_true(value < 4e-9); // the last bit of 6e6 m is 9e-10
    assert_true(rate < 1e-9);
    assert_true(acceleration < 1e-9);
    assert_true(attitude < 1e-12);
    assert_true(oldest <= 50 && off < 2.0e-3 && off > 1e-4);
    free(k);
}

// Velocity and rates are the derivatives of what they belong to, in a join as elsewhere.
static void derivatives(void **state)
{
    (void)state;
    orr_course *k = course(0.065);
    bool antenna;
    orr_motion m[3], begin, end;
    orr_course_sample s = truth(T0, 2, 2);
    orr_course_add(k, &s);
    block(k, T0, T0 + 100 * MS, &begin, &end);
    s = truth(T0 + 100 * MS, 2, 2);
    s.x[0].z += 0.5;
    s.q = orr_quat_mul(s.q, orr_quat_from_rotvec((orr_vec3){0.01, -0.02, 0.005}));
    orr_course_add(k, &s);
    assert_int_equal(block(k, T0 + 100 * MS, T0 + 200 * MS, &begin, &end), ORR_COURSE_JOINING);
    for (int n = 3; n < 90; n += 7) {
        for (int j = 0; j < 3; j++)
            assert_true(orr_course_at(k, T0 + (100 + n) * MS + (j - 1) * MS / 10, false, &m[j], &antenna));
        const double h = 1e-4;
        const orr_vec3 v = orr_vec3_scale(0.5 / h, orr_vec3_sub(m[2].r_m, m[0].r_m)),
                       acc = orr_vec3_scale(0.5 / h, orr_vec3_sub(m[2].v_mps, m[0].v_mps));
        assert_true(apart(v, m[1].v_mps) < 1e-3 && apart(acc, m[1].a_mps2) < 2e-2);
        const orr_quat q0 = {m[0].q_be.w, -m[0].q_be.x, -m[0].q_be.y, -m[0].q_be.z},
                       d = orr_quat_mul(q0, m[2].q_be);
        const double sign = d.w < 0 ? -1 : 1;
        const orr_vec3 w = {sign * d.x / h, sign * d.y / h, sign * d.z / h};
        // Rates of the join are added to the body's as they are: of turns g and w that is right to g w / 2.
        assert_true(apart(w, m[1].w_radps) < 0.03 * 0.35);
    }
    free(k);
}

// Of each sample it is known in the end whether a block rests on it, and at any time how many are still open.
static void every_sample_is_accounted_for(void **state)
{
    (void)state;
    static const int64_t every_ms[] = {1, 7, 40}; // samples; blocks have 5 ms
    for (size_t r = 0; r < sizeof every_ms / sizeof every_ms[0]; r++) {
        for (int64_t old_ms = -30; old_ms <= 30; old_ms += 30) { // ahead of the blocks, with them, behind
            orr_course *k = course(0.065);
            orr_motion a, b;
            uint64_t added = 0;
            for (int64_t ms = 0; ms < 4000; ms++) {
                if (ms % every_ms[r] == 0) {
                    const orr_course_sample s = truth(T0 + (ms - old_ms) * MS, 2, 2);
                    orr_course_add(k, &s);
                    added++;
                }
                if (ms % 5 != 0) continue;
                block(k, T0 + ms * MS, T0 + (ms + 5) * MS, &a, &b);
                const uint64_t open = added - k->used - k->overtaken;
                assert_true(k->used + k->overtaken <= added &&
                            open <= 2 + (old_ms < 0 ? 35 / (uint64_t)every_ms[r] : 0));
            }
            assert_true(k->used > 90);
            assert_true(every_ms[r] == 1 ? k->overtaken > 1000 : every_ms[r] == 7 || k->overtaken == 0);
            free(k);
        }
    }
}

static void states(void **state)
{
    (void)state;
    orr_course *k = course(0.065);
    orr_motion a, b, c;
    assert_int_equal(block(k, T0 - 5 * MS, T0, &a, &b), ORR_COURSE_NONE);
    for (int n = 0; n < 100; n++) { // all at once: a second ahead
        const orr_course_sample s = truth(T0 + n * 10 * MS, 2, 2);
        orr_course_add(k, &s);
    }
    assert_int_equal(orr_course_waiting(k), 100);
    assert_int_equal(block(k, T0, T0 + 5 * MS, &a, &b), ORR_COURSE_SYNCHRONOUS);
    orr_course_state seen = block(k, T0 + 5 * MS, T0 + 10 * MS, &a, &b);
    assert_true(seen == ORR_COURSE_INTERPOLATED || seen == ORR_COURSE_JOINING);
    double worst = 0;
    for (int n = 2; n < 198; n++) {
        block(k, T0 + n * 5 * MS, T0 + (n + 1) * 5 * MS, &a, &b);
        worst = fmax(worst, apart(a.r_m, truth(T0 + n * 5 * MS, 0, 1).x[0]));
    }
    // Between samples 10 ms apart a quintic errs by T^6/46080 x(6): a micrometre is never met.
    assert_true(worst < 1e-6);
    seen = block(k, T0 + 1200 * MS, T0 + 1205 * MS, &a, &b);
    assert_true(seen == ORR_COURSE_EXTRAPOLATED || seen == ORR_COURSE_JOINING);
    assert_int_equal(block(k, T0 + 1300 * MS, T0 + 1305 * MS, &a, &b), ORR_COURSE_EXTRAPOLATED);
    // Asked again by another stream: the same.
    const orr_course_state again = block(k, T0 + 1200 * MS, T0 + 1205 * MS, &c, &b);
    assert_true(again == seen);
    orr_course_sample far = truth(T0 + 1310 * MS, 2, 2);
    far.x[0].z += 5000;
    far.snap = true;
    orr_course_add(k, &far);
    assert_int_equal(block(k, T0 + 1310 * MS, T0 + 1315 * MS, &a, &b), ORR_COURSE_SNAPPED);
    assert_true(apart(a.r_m, far.x[0]) < 1e-9);
    assert_int_equal(block(k, T0 + 1315 * MS, T0 + 1320 * MS, &a, &b), ORR_COURSE_EXTRAPOLATED);
    free(k);
}

// Samples with what had been made when each came: all at once, before any block, they give the same motion to the bit.
static void a_recording(void **state)
{
    (void)state;
    enum { BLOCKS = 400 };
    static orr_motion first[BLOCKS], second[BLOCKS];
    static orr_course_sample log[BLOCKS];
    size_t n_log = 0;
    orr_motion end;
    orr_course *k = course(0.065), *again = course(0.065);
    for (int n = 0; n < BLOCKS; n++) {
        const orr_time t = T0 + n * 5 * MS;
        if (n % 2 == 0 && n % 34 != 6) {
            const orr_course_sample s = truth(t - (int64_t)(orr_rng_u64(5, (uint64_t)n, 0) % 9) * MS, 2, 2);
            orr_course_add(k, &s);
            log[n_log] = s;
            log[n_log++].from = k->made;
        }
        block(k, t, t + 5 * MS, &first[n], &end);
    }
    for (size_t i = 0; i < n_log; i++) {
        orr_course_add(again, &log[i]);
        again->sample[(again->first + again->n - 1) % ORR_COURSE_SAMPLES].from = log[i].from;
    }
    for (int n = 0; n < BLOCKS; n++) block(again, T0 + n * 5 * MS, T0 + (n + 1) * 5 * MS, &second[n], &end);
    assert_memory_equal(first, second, sizeof first);
    free(k);
    free(again);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(predictions), cmocka_unit_test(joints),
        cmocka_unit_test(derivatives), cmocka_unit_test(every_sample_is_accounted_for),
        cmocka_unit_test(states),      cmocka_unit_test(a_recording),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The product against closed-form orbits: how well segments represent them, how they join, what is said of
// gaps, clocks and flags.
#include "testing.h"

#include "orbit/ephemeris/ephemeris_private.h"
#include "orbit/ephemeris/ephemeris_slice.h"
#include "unit/orbit/made_orbit.h"

static orr_ephemeris *build(const orr_orbit_solution *s)
{
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(s, &e, &diag), diag);
    return e;
}

static orr_time at(double t_s) { return orr_time_add_s(made_midnight, t_s); }

// What the product promises: 0.1 mm and 1e-6 m/s everywhere, asked between samples too. The acceleration's
// bound is what an error of 0.1 mm of a degree-8 term in 15 min would make.
static void test_represents(void **state)
{
    (void)state;
    static const struct {
        double segment_s;
        size_t per_segment;
    } shape[] = {{900, 6}, {1800, 12}, {3600, 12}, {300, 4}, {60, 1}};
    for (size_t c = 0; c < sizeof shape / sizeof shape[0]; c++) {
        orr_orbit_solution s = made_solution(12, 4, shape[c].segment_s, shape[c].per_segment);
        orr_ephemeris *e = build(&s);
        double worst[3] = {0};
        for (size_t k = 0; k < 12; k++) {
            made_satellite m = made_satellite_at(k);
            for (double t = 0; t <= 4 * 3600; t += 7.3) {
                orr_sat_state st;
                orr_vec3 r, v, a;
                assert_int_equal(orr_ephemeris_eval(e, m.sat, at(t), &st), ORR_OK);
                made_state(&m, t, &r, &v, &a);
                worst[0] = fmax(worst[0], orr_vec3_norm(orr_vec3_sub(st.pos_m, r)));
                worst[1] = fmax(worst[1], orr_vec3_norm(orr_vec3_sub(st.vel_mps, v)));
                worst[2] = fmax(worst[2], orr_vec3_norm(orr_vec3_sub(st.acc_mps2, a)));
            }
        }
        ASSERT_NEAR(worst[0], 0, 1e-4);
        ASSERT_NEAR(worst[1], 0, 1e-6);
        ASSERT_NEAR(worst[2], 0, 1e-7);
        double pos, vel; // what it says of itself is no more than what is seen between samples, and not zero
        orr_ephemeris_representation(e, &pos, &vel);
        assert_true(pos > 0 && pos <= 1e-4 && vel > 0 && vel <= 1e-6);
        orr_ephemeris_free(e);
        made_solution_free(&s);
    }
}

// A step of 1e-7 m/s^2, the size of radiation pressure, as at an abrupt edge of shadow, in the middle of a
// segment.
static void test_shadow_edge(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(1, 1, 900, 6);
    orr_orbit_arc *a = &s.sat[0].arc[0];
    const double edge = 1350.0 + 37.0, step = 1e-7;
    for (size_t i = 0; i < a->n; i++) {
        double t = (double)i * a->step_s - edge;
        if (t <= 0) continue;
        a->sample[i].pos_m.x += 0.5 * step * t * t;
        a->sample[i].vel_mps.x += step * t;
        a->sample[i].acc_mps2.x += step;
    }
    orr_ephemeris *e = build(&s);
    made_satellite m = made_satellite_at(0);
    for (double t = 900; t <= 1800; t += 1) {
        orr_sat_state st;
        orr_vec3 r, v, acc;
        double u = fmax(0, t - edge);
        assert_int_equal(orr_ephemeris_eval(e, m.sat, at(t), &st), ORR_OK);
        made_state(&m, t, &r, &v, &acc);
        r.x += 0.5 * step * u * u;
        v.x += step * u;
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(st.pos_m, r)), 0, 1e-4);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(st.vel_mps, v)), 0, 1.5e-6);
    }
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

// An orbit that no polynomial of the segment can follow gets shorter segments, still C2 and through its
// samples; one that is no number is refused by name.
static void test_rough_orbits(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(2, 1, 900, 6);
    orr_orbit_arc *a = &s.sat[1].arc[0];
    a->sample[9].pos_m.y += 0.01;
    a->sample[14].vel_mps.x += 0.001;
    orr_ephemeris *e = build(&s);
    assert_int_equal(orr_ephemeris_shortened(e), 1);
    for (size_t i = 0; i < a->n; i++) {
        orr_sat_state st;
        assert_int_equal(orr_ephemeris_eval(e, s.sat[1].sat, at(150.0 * (double)i), &st), ORR_OK);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(st.pos_m, a->sample[i].pos_m)), 0, 1e-4);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(st.vel_mps, a->sample[i].vel_mps)), 0, 1e-6);
    }
    orr_ephemeris_free(e);
    orr_diag diag = {0};
    e = NULL;
    a->sample[9].pos_m.y = (double)NAN;
    assert_int_equal(orr_ephemeris_build(&s, &e, &diag), ORR_E_NUMERIC);
    assert_null(e);
    assert_non_null(strstr(diag.text, "2024-02-04T00:22:30"));
    made_solution_free(&s);
}

static void test_refuses_wrong_solutions(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    orr_orbit_solution s = made_solution(2, 1, 900, 6);
    s.sat[0].arc[0].n--;
    assert_int_equal(orr_ephemeris_build(&s, &e, &diag), ORR_E_ARG);
    s.sat[0].arc[0].n++;
    s.sat[0].arc[0].step_s = 100.0 / 3.0;
    assert_int_equal(orr_ephemeris_build(&s, &e, &diag), ORR_E_ARG);
    s.sat[0].arc[0].step_s = 150;
    s.sat[1].sat = s.sat[0].sat;
    assert_int_equal(orr_ephemeris_build(&s, &e, &diag), ORR_E_ARG);
    s.n_sats = 0;
    assert_int_equal(orr_ephemeris_build(&s, &e, &diag), ORR_E_NODATA);
    s.n_sats = 2;
    made_solution_free(&s);
}

// Neighbouring segments meet in position, velocity and acceleration: one nanosecond before the joint, moved
// on by its own derivatives, is the joint. 1e-7 m is the rounding of 2.6e7 m summed over a few terms, ten
// times over.
static void test_joints(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(6, 6, 900, 6);
    orr_ephemeris *e = build(&s);
    for (size_t k = 0; k < 6; k++) {
        orr_sat sat = s.sat[k].sat;
        for (int i = 1; i < 24; i++) {
            orr_time t = at(900.0 * i);
            orr_sat_state a, b;
            assert_int_equal(orr_ephemeris_eval(e, sat, t - 1, &a), ORR_OK);
            assert_int_equal(orr_ephemeris_eval(e, sat, t, &b), ORR_OK);
            a.pos_m = orr_vec3_axpy(1e-9, a.vel_mps, a.pos_m);
            a.vel_mps = orr_vec3_axpy(1e-9, a.acc_mps2, a.vel_mps);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a.pos_m, b.pos_m)), 0, 1e-7);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a.vel_mps, b.vel_mps)), 0, 1e-9);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a.acc_mps2, b.acc_mps2)), 0, 1e-10);
        }
    }
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static void test_one_and_all_agree(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(30, 3, 900, 6);
    s.sat[7].arc[0].t0 += INT64_C(120) * ORR_NS_PER_S; // its segments are not aligned with the others'
    s.sat[9].n_arcs = 0;
    orr_ephemeris *e = build(&s);
    orr_sat_state all[30], one;
    for (double t = 0; t <= 3 * 3600; t += 61.7) {
        memset(all, 0x5a, sizeof all);
        size_t n = orr_ephemeris_eval_all(e, at(t), all, 30);
        assert_int_equal(n, t < 120 ? 28 : 29);
        for (size_t i = 0; i < n; i++) {
            if (i > 0) assert_true(all[i].sat > all[i - 1].sat);
            memset(&one, 0x5a, sizeof one);
            assert_int_equal(orr_ephemeris_eval(e, all[i].sat, at(t), &one), ORR_OK);
            assert_memory_equal(&one, &all[i], sizeof one);
        }
    }
    assert_int_equal(orr_ephemeris_eval_all(e, at(1000), all, 5), 5);
    orr_ephemeris_free(e);
    s.sat[9].n_arcs = 1;
    made_solution_free(&s);
}

// Instants that follow one another and instants anywhere, satellites of other segments, without an arc, without clocks: side by
// side they have the bits that they have one by one.
static void test_side_by_side(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(30, 3, 900, 6);
    s.sat[7].arc[0].t0 += INT64_C(120) * ORR_NS_PER_S;
    s.sat[9].n_arcs = 0;
    s.sat[11].arc[0].n -= 6; // ends a segment earlier
    s.sat[12].n_clocks /= 2;
    orr_ephemeris *e = build(&s);
    orr_ephemeris_slice *slice;
    orr_diag diag = {0};
    ASSERT_OK(orr_ephemeris_slice_open(e, &slice, &diag), diag);
    const orr_sat *sat;
    const size_t n = orr_ephemeris_satellites(e, &sat);
    orr_sat_state all[30], one;
    for (int wide = 0; wide < (eph_machine_is_wide() ? 2 : 1); wide++) {
        e->wide = wide == 1;
        for (int k = 0; k < 3000; k++) {
            const int64_t follows = (int64_t)k * 3700000001,
                          anywhere = (int64_t)(k * 7919 % 3000) * 3600000000;
            const orr_time t = at(0) + (k < 2000 ? follows : anywhere);
            memset(all, 0x5a, sizeof all);
            const bool *has = orr_ephemeris_slice_eval(slice, t, all);
            for (size_t i = 0; i < n; i++) {
                memset(&one, 0x5a, sizeof one);
                assert_int_equal(orr_ephemeris_eval(e, sat[i], t, &one) == ORR_OK, has[i]);
                assert_memory_equal(&one, &all[i], sizeof one);
            }
        }
    }
    orr_ephemeris_slice_close(slice);
    orr_ephemeris_free(e);
    s.sat[9].n_arcs = 1;
    made_solution_free(&s);
}

// Machines with wide vectors and without them give the same bits.
static void test_width_does_not_matter(void **state)
{
    (void)state;
    if (!eph_machine_is_wide()) skip();
    orr_orbit_solution s = made_solution(20, 2, 900, 6);
    orr_ephemeris *e = build(&s);
    orr_sat_state wide[20], plain[20];
    memset(wide, 0, sizeof wide);
    memset(plain, 0, sizeof plain);
    for (double t = 0; t <= 7200; t += 13.7) {
        e->wide = true;
        assert_int_equal(orr_ephemeris_eval_all(e, at(t), wide, 20), 20);
        e->wide = false;
        assert_int_equal(orr_ephemeris_eval_all(e, at(t), plain, 20), 20);
        assert_memory_equal(wide, plain, sizeof wide);
        assert_int_equal(orr_ephemeris_eval(e, plain[3].sat, at(t), &plain[3]), ORR_OK);
        assert_memory_equal(&wide[3], &plain[3], sizeof wide[3]);
    }
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

// Outside its arcs there is never a number.
static void test_says_where_nothing_is(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(3, 4, 900, 6);
    // The second satellite's arc is cut in two with half an hour between: 0-1 h, 1.5-4 h.
    orr_orbit_sat *g = &s.sat[1];
    orr_orbit_arc whole = g->arc[0];
    g->arc = realloc(g->arc, 2 * sizeof *g->arc);
    g->arc[0] = g->arc[1] = whole;
    g->arc[0].n = 25;
    g->arc[1].t0 = at(5400);
    g->arc[1].sample = whole.sample + 36;
    g->arc[1].n = whole.n - 36;
    g->n_arcs = 2;
    orr_ephemeris *e = build(&s);
    orr_sat_state st, before;
    memset(&st, 0x77, sizeof st);
    before = st;
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(-0.1), &st), ORR_E_RANGE);
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(4 * 3600 + 0.1), &st), ORR_E_RANGE);
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(3600.000000001), &st), ORR_E_NODATA);
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(5399.9), &st), ORR_E_NODATA);
    assert_int_equal(orr_ephemeris_eval(e, orr_sat_make('C', 5), at(100), &st), ORR_E_NODATA);
    assert_int_equal(orr_ephemeris_eval(e, ORR_SAT_NONE, at(100), &st), ORR_E_NODATA);
    assert_int_equal(orr_ephemeris_eval(e, (orr_sat)0xffff, at(100), &st), ORR_E_NODATA);
    assert_memory_equal(&st, &before, sizeof st);
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(3600), &st), ORR_OK); // an arc's ends belong to it
    assert_true(st.valid_from == at(0) && st.valid_to == at(3600));
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(5400), &st), ORR_OK);
    assert_true(st.valid_from == at(5400) && st.valid_to == at(14400));
    orr_sat_state all[3];
    assert_int_equal(orr_ephemeris_eval_all(e, at(4000), all, 3), 2);
    assert_int_equal(orr_ephemeris_eval_all(e, at(-1), all, 3), 0);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    assert_true(from == at(0) && to == at(14400));
    orr_ephemeris_free(e);
    g->n_arcs = 1;
    g->arc[0] = whole;
    made_solution_free(&s);
}

static bool clock_of(const orr_ephemeris *e, orr_sat sat, double t, orr_sat_state *st)
{
    assert_int_equal(orr_ephemeris_eval(e, sat, at(t), st), ORR_OK);
    bool valid = (st->flags & ORR_EPH_CLOCK_VALID) != 0;
    assert_true(valid == !isnan(st->clock_s) && valid == !isnan(st->clock_rate_sps));
    return valid;
}

static void test_clocks(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(2, 4, 900, 6);
    orr_orbit_sat *g = &s.sat[0];
    made_satellite m = made_satellite_at(0);
    orr_clock_node *c = g->clock;
    // Nodes at 0, 300, ... Taken out: 3300-5100 s (a gap of 2100 s > 900), 7500 s (600 s: bridged). The node
    // at 9000 s has an event; the one at 10800 s is predicted. The last two stand 1000 s behind the one
    // before and alone.
    size_t n = 0;
    for (size_t i = 0; i < g->n_clocks; i++) {
        int t = (int)i * 300;
        if ((t >= 3300 && t <= 5100) || t == 7500 || t > 12000) continue;
        c[n] = c[i];
        c[n].clock_s = made_clock(&m, t);
        if (t == 9000) c[n].flags = ORR_EPH_CLOCK_EVENT;
        if (t == 10800) c[n].flags = ORR_EPH_PREDICTED;
        n++;
    }
    c[n++] = (orr_clock_node){.t = at(13000), .clock_s = 1e-6};
    g->n_clocks = n;
    orr_ephemeris *e = build(&s);
    orr_sat_state st;
    for (double t = 0; t <= 3000; t += 11.1) {
        assert_true(clock_of(e, g->sat, t, &st));
        ASSERT_NEAR(st.clock_s, made_clock(&m, t),
                    1e-18); // 1e-4 s times 2^-52, and the same again for the rate
        ASSERT_NEAR(st.clock_rate_sps, 2e-11, 1e-19);
    }
    assert_true(clock_of(e, g->sat, 3000, &st)); // last node before the gap
    assert_true(st.clock_s == made_clock(&m, 3000));
    assert_false(clock_of(e, g->sat, 3000.000001, &st));
    assert_false(clock_of(e, g->sat, 5399, &st));
    assert_true(clock_of(e, g->sat, 5400, &st));
    assert_true(clock_of(e, g->sat, 7600, &st));
    ASSERT_NEAR(st.clock_s, made_clock(&m, 7600), 1e-18);
    assert_int_equal(st.flags & ORR_EPH_CLOCK_EVENT, 0);
    // The clock jumped somewhere in (8700, 9000].
    assert_true(clock_of(e, g->sat, 8700, &st));
    assert_false(clock_of(e, g->sat, 8700.5, &st));
    assert_false(clock_of(e, g->sat, 8999.9, &st));
    assert_true(clock_of(e, g->sat, 9000, &st));
    assert_int_equal(st.flags & ORR_EPH_CLOCK_EVENT, ORR_EPH_CLOCK_EVENT);
    assert_true(clock_of(e, g->sat, 10700, &st));
    assert_int_equal(st.flags & ORR_EPH_PREDICTED, ORR_EPH_PREDICTED);
    assert_false(clock_of(e, g->sat, 12500, &st));
    assert_false(clock_of(e, g->sat, 13000, &st)); // alone: it has no rate
    assert_false(clock_of(e, g->sat, 13500, &st));
    orr_ephemeris_free(e);

    // Two files join at 3600 s with clocks 1 us apart: up to there the earlier one's, from there on the later
    // one's.
    orr_orbit_sat *r = &s.sat[1];
    made_satellite m2 = made_satellite_at(1);
    r->clock = realloc(r->clock, (r->n_clocks + 1) * sizeof *r->clock);
    memmove(&r->clock[13], &r->clock[12], (r->n_clocks - 12) * sizeof *r->clock);
    r->n_clocks++;
    for (size_t i = 13; i < r->n_clocks; i++) r->clock[i].clock_s += 1e-6;
    e = build(&s);
    assert_true(clock_of(e, r->sat, 3599.999, &st));
    ASSERT_NEAR(st.clock_s, made_clock(&m2, 3599.999), 1e-18);
    assert_true(clock_of(e, r->sat, 3600, &st));
    ASSERT_NEAR(st.clock_s, made_clock(&m2, 3600) + 1e-6, 1e-18);
    assert_true(clock_of(e, r->sat, 3700, &st));
    ASSERT_NEAR(st.clock_s, made_clock(&m2, 3700) + 1e-6, 1e-18);
    ASSERT_NEAR(st.clock_rate_sps, 2e-11, 1e-18);
    orr_ephemeris_free(e);
    r->n_clocks = 14; // nothing behind the joint but its second node: the first one's stretch ends there
    e = build(&s);
    assert_true(clock_of(e, r->sat, 3600, &st));
    ASSERT_NEAR(st.clock_s, made_clock(&m2, 3600), 1e-18);
    assert_false(clock_of(e, r->sat, 3600.1, &st));
    orr_ephemeris_free(e);

    g->n_clocks = 0; // no clock at all
    e = build(&s);
    assert_false(clock_of(e, g->sat, 100, &st));
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static uint32_t flags_of(const orr_ephemeris *e, orr_sat sat, double t)
{
    orr_sat_state st;
    assert_int_equal(orr_ephemeris_eval(e, sat, at(t), &st), ORR_OK);
    return st.flags & ~(uint32_t)ORR_EPH_CLOCK_VALID;
}

static void test_flags_and_sigma(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(2, 4, 900, 6);
    orr_orbit_sat *g = &s.sat[0];
    g->arc[0].sample[50].flags = ORR_EPH_PREDICTED; // 7500 to 7650 s
    g->arc[0].sample[54].flags = ORR_EPH_PREDICTED; // 8100 to 8250 s: the first of a segment
    for (size_t i = 72; i < g->arc[0].n; i++) g->arc[0].sample[i].flags = ORR_EPH_GAP;
    orr_ephemeris *e = build(&s);
    assert_int_equal(flags_of(e, g->sat, 999.9), 0);
    assert_int_equal(flags_of(e, g->sat, 1000), ORR_EPH_ECLIPSE);
    assert_int_equal(flags_of(e, g->sat, 2500), ORR_EPH_ECLIPSE);
    assert_int_equal(flags_of(e, g->sat, 4000), ORR_EPH_ECLIPSE);
    assert_int_equal(flags_of(e, g->sat, 4000.1), 0);
    assert_int_equal(flags_of(e, g->sat, 5000), ORR_EPH_MANOEUVRE);
    assert_int_equal(flags_of(e, g->sat, 5901), 0);
    assert_int_equal(flags_of(e, g->sat, 7499.999), 0);
    assert_int_equal(flags_of(e, g->sat, 7500), ORR_EPH_PREDICTED);
    assert_int_equal(flags_of(e, g->sat, 7649.999), ORR_EPH_PREDICTED);
    assert_int_equal(flags_of(e, g->sat, 7650), 0);
    assert_int_equal(flags_of(e, g->sat, 8100), ORR_EPH_PREDICTED);
    assert_int_equal(flags_of(e, g->sat, 8250), 0);
    assert_int_equal(flags_of(e, g->sat, 10799.9), 0);
    assert_int_equal(flags_of(e, g->sat, 10800), ORR_EPH_GAP);
    assert_int_equal(flags_of(e, g->sat, 14400), ORR_EPH_GAP);
    orr_sat_state st;
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(1225), &st), ORR_OK); // half past sample 8
    const double last_bit = 1.0 / 4096; // sigmas are kept to 12 bits: off by half of the last, at most
    ASSERT_NEAR((double)st.sigma_m, 0.01 + 0.0001 * (1225.0 / 150.0), last_bit * 0.011);
    assert_int_equal(orr_ephemeris_eval(e, g->sat, at(14400), &st), ORR_OK);
    ASSERT_NEAR((double)st.sigma_m, 0.01 + 0.0001 * 96, last_bit * 0.02);
    for (int k = 0; k < 3; k++)
        ASSERT_NEAR((double)st.sigma_rtn_m[k], 0.1 * (k + 1) * (double)st.sigma_m,
                    2 * last_bit * 0.1 * (k + 1) * 0.02);
    ASSERT_NEAR((double)st.sigma_mps, 1e-4 * (double)st.sigma_m, 2 * last_bit * 1e-4 * 0.02);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

// Events that overlap, touch joints, cover many segments or lie partly outside, against the plain reading of
// them.
static void test_event_flags(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(1, 4, 900, 6);
    orr_orbit_sat *g = &s.sat[0];
    static const struct {
        orr_event_kind kind;
        double t0, t1;
        uint32_t flag;
    } event[] = {{ORR_EVENT_GAP, -500, 100, ORR_EPH_GAP},
                 {ORR_EVENT_MANOEUVRE, 900, 1800, ORR_EPH_MANOEUVRE},
                 {ORR_EVENT_PENUMBRA, 950, 9000, ORR_EPH_ECLIPSE},
                 {ORR_EVENT_UMBRA, 1000, 1100, ORR_EPH_ECLIPSE},
                 {ORR_EVENT_OUTLIER, 1200, 1200, 0},
                 {ORR_EVENT_DAY_JUMP, 1250, 1250, 0},
                 {ORR_EVENT_GAP, 2700, 5400, ORR_EPH_GAP},
                 {ORR_EVENT_MANOEUVRE, 3000, 3000, ORR_EPH_MANOEUVRE},
                 {ORR_EVENT_GAP, 5399.999999999, 13500, ORR_EPH_GAP},
                 {ORR_EVENT_MANOEUVRE, 13500, 20000, ORR_EPH_MANOEUVRE}};
    enum { N = sizeof event / sizeof event[0] };
    g->event = realloc(g->event, sizeof(orr_orbit_event[N]));
    g->n_events = N;
    for (size_t i = 0; i < N; i++)
        g->event[i] = (orr_orbit_event){.kind = event[i].kind, .t0 = at(event[i].t0), .t1 = at(event[i].t1)};
    orr_ephemeris *e = build(&s);
    for (double t = 0; t <= 14400; t += 12.5) {
        for (int side = -1; side <= 1; side++) { // also a nanosecond beside
            orr_time when = at(t) + side;
            uint32_t want = 0;
            for (size_t i = 0; i < N; i++)
                if (when >= g->event[i].t0 && when <= g->event[i].t1) want |= event[i].flag;
            if (when < at(0) || when > at(14400)) continue;
            assert_int_equal(flags_of(e, g->sat, t + side * 1e-9), want);
        }
    }
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static void test_reports(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(3, 2, 900, 6);
    orr_ephemeris *e = build(&s);
    const orr_sat *sats;
    const orr_orbit_node *nodes;
    const orr_orbit_event *events;
    const orr_clock_node *clocks;
    const orr_orbit_source *sources;
    assert_int_equal(orr_ephemeris_satellites(e, &sats), 3);
    for (size_t i = 0; i < 3; i++) assert_int_equal(sats[i], s.sat[i].sat);
    assert_int_equal(orr_ephemeris_nodes(e, sats[1], &nodes), 9);
    assert_memory_equal(nodes, s.sat[1].node, 9 * sizeof *nodes);
    assert_int_equal(orr_ephemeris_events(e, sats[2], &events), 4);
    assert_memory_equal(events, s.sat[2].event, 4 * sizeof *events);
    assert_int_equal(orr_ephemeris_clocks(e, sats[0], &clocks), 25);
    assert_memory_equal(clocks, s.sat[0].clock, 25 * sizeof *clocks);
    assert_int_equal(orr_ephemeris_clocks(e, orr_sat_make('J', 1), &clocks), 0);
    assert_int_equal(orr_ephemeris_sources(e, &sources), 1);
    assert_string_equal(sources[0].name, "made.sp3");
    assert_string_equal(orr_ephemeris_options(e), "made for a test");
    assert_string_equal(orr_ephemeris_frame(e), "IGS20");
    assert_true(orr_ephemeris_node_step_s(e) == 900);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_represents),
        cmocka_unit_test(test_shadow_edge),
        cmocka_unit_test(test_rough_orbits),
        cmocka_unit_test(test_refuses_wrong_solutions),
        cmocka_unit_test(test_joints),
        cmocka_unit_test(test_one_and_all_agree),
        cmocka_unit_test(test_side_by_side),
        cmocka_unit_test(test_width_does_not_matter),
        cmocka_unit_test(test_says_where_nothing_is),
        cmocka_unit_test(test_clocks),
        cmocka_unit_test(test_flags_and_sigma),
        cmocka_unit_test(test_event_flags),
        cmocka_unit_test(test_reports),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

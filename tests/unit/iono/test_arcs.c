// SPDX-License-Identifier: GPL-3.0-or-later
// Made passes of known TEC with slips put in: every slip is found at its place, none is invented, what is
// called repaired is right.
#include "core/nan.h"
#include "core/rng.h"
#include "iono/field/pierce.h"
#include "iono/phase/arcs.h"
#include "iono/phase/signals.h"
#include "testing.h"

enum { N = 600 }; // 5 h of 30 s

typedef struct pass {
    double t[N], truth[N], gf[N], mw[N];
    uint8_t lost[N];
    orr_arc_series s;
} pass;

// A pass over a station: mapped diurnal content with a travelling disturbance, phase noise of 2 mm (0.02
// TECU) growing to the horizon, wide lane noise of 0.12 cycles growing likewise and a slow walk.
static void make(pass *p, uint64_t seed, double f1, double f2)
{
    double k = orr_tecu_per_metre(f1, f2), slow = 0;
    orr_mapping map = orr_mapping_published(ORR_MAPPING_MSLM);
    memset(p, 0, sizeof *p);
    for (int i = 0; i < N; i++) {
        double x = (i - N / 2.0) / (N / 2.0), el = (8 + 72 * (1 - x * x)) * 0.0174532925;
        p->t[i] = 30.0 * i;
        double vertical =
            25 + 20 * sin(i * 30 / 86400.0 * 6.2832 + (double)seed) + 0.8 * sin(i * 30 / 1500.0);
        p->truth[i] = orr_mapping_factor(&map, el) * vertical;
        p->gf[i] = p->truth[i] + 0.012 / sin(el) * orr_rng_normal(seed, 1, (uint64_t)i);
        slow = 0.97 * slow + 0.04 * orr_rng_normal(seed, 2, (uint64_t)i);
        p->mw[i] = 1234 + slow + fmin(0.4, 0.12 / sin(el)) * orr_rng_normal(seed, 3, (uint64_t)i);
    }
    p->s = (orr_arc_series){N, p->t, p->gf, p->mw, p->lost, k * ORR_LIGHT_MPS / f1, k * ORR_LIGHT_MPS / f2};
}

static void slip(pass *p, int at, int n1, int n2)
{
    for (int i = at; i < N; i++) {
        p->gf[i] += p->s.gf1_tecu * n1 - p->s.gf2_tecu * n2;
        p->mw[i] += n1 - n2;
    }
}

static const orr_slip *slip_at(const orr_arcs *a, size_t at)
{
    for (size_t i = 0; i < a->n_slips; i++)
        if (a->slip[i].at == at) return &a->slip[i];
    fail_msg("no slip at %zu", at);
    return NULL;
}

// The repaired phase is the truth and one constant an arc: to the noise, and never off by a cycle.
static void check_shape(const pass *p, const orr_arcs *a)
{
    for (size_t arc = 0; arc < a->n_arcs; arc++) {
        double mean = 0, n = 0;
        for (int i = 0; i < N; i++)
            if (a->arc_of[i] == (int)arc) {
                mean += p->gf[i] - a->fix_tecu[i] - p->truth[i];
                n++;
            }
        mean /= n;
        for (int i = 0; i < N; i++)
            if (a->arc_of[i] == (int)arc)
                ASSERT_NEAR(p->gf[i] - a->fix_tecu[i] - p->truth[i], mean,
                            0.42); // 5 sigma at the horizon; a cycle is 0.5
    }
}

static const double PAIRS[][2] = {
    {1575.42e6, 1227.60e6}, {1575.42e6, 1176.45e6}, {1602e6, 1246e6}, {1561.098e6, 1268.52e6}};

static void test_none_invented(void **state)
{
    (void)state;
    static pass p;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        orr_arcs a;
        orr_diag d = {0};
        make(&p, seed, PAIRS[seed % 4][0], PAIRS[seed % 4][1]);
        ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
        assert_int_equal(a.n_slips, 0);
        assert_int_equal(a.n_arcs, 1);
        assert_int_equal(a.arc[0].n, N);
        orr_arcs_free(&a);
    }
}

// Slips of all kinds, the awkward ones first: equal cycles on both (no wide lane), 9-7 (next to nothing in
// the geometry-free phase), 77-60 (nothing at all).
static void test_every_slip_found(void **state)
{
    (void)state;
    static const int awkward[][2] = {{1, 1}, {-1, -1}, {2, 2}, {9, 7},  {77, 60}, {1, 0},
                                     {0, 1}, {0, -1},  {5, 4}, {-3, 2}, {100, -4}};
    static pass p;
    unsigned repaired = 0, broken = 0;
    for (uint64_t seed = 1; seed <= 120; seed++) {
        make(&p, seed, PAIRS[0][0], PAIRS[0][1]);
        size_t where[4], expected = 0;
        int cycles[4][2];
        for (int k = 0; k < 4; k++) {
            where[k] = (size_t)(80 + 120 * k) + (size_t)(60 * orr_rng_uniform(seed, 9, (uint64_t)k));
            if (k == 0)
                memcpy(cycles[k], awkward[seed % 11], sizeof cycles[k]);
            else
                for (int j = 0; j < 2; j++)
                    cycles[k][j] = (int)(40 * orr_rng_uniform(seed, 10, (uint64_t)(2 * k + j))) - 20;
            slip(&p, (int)where[k], cycles[k][0], cycles[k][1]);
        }
        orr_arcs a;
        orr_diag d = {0};
        ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
        for (int k = 0; k < 4; k++) {
            if (cycles[k][0] == 0 && cycles[k][1] == 0) continue;
            expected++;
            const orr_slip *s = slip_at(&a, where[k]);
            if (s->verdict == ORR_SLIP_REPAIRED) {
                repaired++;
                double want = p.s.gf1_tecu * cycles[k][0] - p.s.gf2_tecu * cycles[k][1];
                ASSERT_NEAR(p.s.gf1_tecu * s->n1 - p.s.gf2_tecu * s->n2, want, 0.06);
            } else {
                assert_int_equal(s->verdict, ORR_SLIP_BREAK);
                broken++;
            }
        }
        assert_int_equal(a.n_slips, expected);
        check_shape(&p, &a);
        orr_arcs_free(&a);
    }
    print_message("%u repaired, %u broken\n", repaired, broken);
    assert_true(repaired > 9 * broken); // steps of whole cycles are known as such, save where noise is large
}

// A slip that leaves one or two samples at an end of the pass: found all the same, whatever its size from 1.5 TECU (three cycles) up, by
// the phases alone (the wide lane of so few samples says little) and in its presence.
static void test_slips_at_the_ends(void **state)
{
    (void)state;
    static const size_t where[] = {1, 2, N - 2, N - 1};
    static pass p;
    size_t missed = 0, made = 0;
    double worst = 0;
    for (uint64_t seed = 1; seed <= 200; seed++)
        for (int k = 0; k < 4; k++)
            for (int codes = 0; codes < 2; codes++) {
                make(&p, seed, PAIRS[seed % 4][0], PAIRS[seed % 4][1]);
                int n1 = (int)(40 * orr_rng_uniform(seed, 20, (uint64_t)k)) - 20,
                    n2 = (int)(40 * orr_rng_uniform(seed, 21, (uint64_t)k)) - 20;
                double size = fabs(p.s.gf1_tecu * n1 - p.s.gf2_tecu * n2);
                if (size < 1.5) continue;
                slip(&p, (int)where[k], n1, n2);
                if (!codes)
                    for (int i = 0; i < N; i++) p.mw[i] = ORR_NAN;
                orr_arcs a;
                orr_diag d = {0};
                ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
                // What matters is that the samples beyond do not belong to the arc as they are.
                size_t end = k < 2 ? 0 : N - 1;
                int middle = a.arc_of[N / 2];
                double off = fabs(p.gf[end] - a.fix_tecu[end] - p.truth[end] -
                                  (p.gf[N / 2] - a.fix_tecu[N / 2] - p.truth[N / 2]));
                made++;
                if (a.arc_of[end] == middle && off > 0.45) {
                    missed++;
                    worst = fmax(worst, size);
                    if (missed < 10)
                        print_message("missed: seed %d at %zu, %.2f TECU (%d, %d) codes %d\n", (int)seed,
                                      where[k], size, n1, n2, codes);
                }
                orr_arcs_free(&a);
            }
    print_message("%zu of %zu slips at the ends missed, the largest %.2f TECU\n", missed, made, worst);
    assert_int_equal(missed, 0);
}

// The same measurements backward in time have the same slips.
static void test_backward(void **state)
{
    (void)state;
    static pass p, q;
    make(&p, 5, PAIRS[0][0], PAIRS[0][1]);
    slip(&p, 150, 3, 1);
    slip(&p, 157, -1, 4); // seven samples later
    slip(&p, 400, 1, 1);
    q = p;
    for (int i = 0; i < N; i++) {
        q.gf[i] = p.gf[N - 1 - i];
        q.mw[i] = p.mw[N - 1 - i];
    }
    q.s.gf_tecu = q.gf;
    q.s.mw_cyc = q.mw;
    q.s.t_s = q.t;
    q.s.lost = q.lost;
    orr_arcs a, b;
    orr_diag d = {0};
    ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
    ASSERT_OK(orr_arcs_find(&q.s, NULL, &b, &d), d);
    assert_int_equal(a.n_slips, 3);
    assert_int_equal(b.n_slips, 3);
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(a.slip[i].at, N - b.slip[2 - i].at);
        assert_int_equal(a.slip[i].n1, -b.slip[2 - i].n1);
        assert_int_equal(a.slip[i].n2, -b.slip[2 - i].n2);
    }
    orr_arcs_free(&a);
    orr_arcs_free(&b);
}

static void test_gaps_flags_outliers(void **state)
{
    (void)state;
    static pass p;
    orr_arcs a;
    orr_diag d = {0};
    make(&p, 3, PAIRS[0][0], PAIRS[0][1]);
    for (int i = 100; i < 102; i++) p.gf[i] = ORR_NAN; // 90 s without a slip: goes on
    for (int i = 200; i < 230; i++) p.gf[i] = ORR_NAN; // 15 min: a new arc
    p.gf[350] += 3;                                    // one wild phase
    p.lost[420] = 1;                                   // a flag and no jump
    p.lost[470] = 1;                                   // a flag and a jump
    slip(&p, 470, 7, 5);
    ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
    assert_int_equal(a.n_arcs, 2);
    assert_int_equal(slip_at(&a, 102)->verdict, ORR_SLIP_NONE);
    assert_int_equal(slip_at(&a, 102)->causes & ORR_SLIP_GAP, ORR_SLIP_GAP);
    assert_int_equal(slip_at(&a, 230)->verdict, ORR_SLIP_BREAK);
    assert_int_equal(slip_at(&a, 350)->verdict, ORR_SLIP_OUTLIER);
    assert_int_equal(a.arc_of[350], -1);
    assert_int_equal(slip_at(&a, 420)->verdict, ORR_SLIP_NONE);
    assert_int_equal(slip_at(&a, 470)->verdict, ORR_SLIP_REPAIRED);
    assert_int_equal(slip_at(&a, 470)->n1, 7);
    assert_int_equal(slip_at(&a, 470)->n2, 5);
    assert_int_equal(a.n_slips, 5);
    check_shape(&p, &a);
    char text[40];
    assert_string_equal(orr_slip_cause_text(slip_at(&a, 470)->causes & (ORR_SLIP_LLI | ORR_SLIP_GAP), text),
                        "lli");
    orr_arcs_free(&a);
    // A jump of half a cycle is no whole number: the arc breaks and nothing is "repaired".
    make(&p, 4, PAIRS[0][0], PAIRS[0][1]);
    for (int i = 300; i < N; i++) {
        p.gf[i] += 10.5 * p.s.gf1_tecu;
        p.mw[i] += 10.5;
    }
    ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
    assert_int_equal(a.n_slips, 1);
    assert_int_equal(a.slip[0].at, 300);
    assert_int_equal(a.slip[0].verdict, ORR_SLIP_BREAK);
    assert_int_equal(a.n_arcs, 2);
    orr_arcs_free(&a);
}

// Without any code there is no wide lane: jumps are still found, only not repaired; and odd series are no
// trouble.
static void test_phase_alone_and_edges(void **state)
{
    (void)state;
    static pass p;
    orr_arcs a;
    orr_diag d = {0};
    make(&p, 6, PAIRS[0][0], PAIRS[0][1]);
    for (int i = 300; i < N; i++) p.gf[i] += p.s.gf1_tecu; // 1.8 TECU
    for (int i = 0; i < N; i++) p.mw[i] = ORR_NAN;
    ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
    assert_int_equal(a.n_slips, 1);
    assert_int_equal(a.slip[0].at, 300);
    assert_int_equal(a.n_arcs, 2);
    orr_arcs_free(&a);
    for (size_t n = 0; n < 8; n++) {
        p.s.n = n;
        ASSERT_OK(orr_arcs_find(&p.s, NULL, &a, &d), d);
        assert_int_equal(a.n_arcs, 0);
        assert_int_equal(a.n_dropped, n);
        orr_arcs_free(&a);
    }
    p.s.n = 5;
    p.t[3] = p.t[2];
    assert_int_equal(orr_arcs_find(&p.s, NULL, &a, &d), ORR_E_ARG);
}

static void test_step_after_fit(void **state)
{
    (void)state;
    static double t[N], r[N];
    size_t at;
    double v;
    for (int seed = 0; seed < 20; seed++) {
        for (int i = 0; i < N; i++) {
            t[i] = 30 * i;
            r[i] = 1.5 * sin(t[i] / 900) + 0.05 * orr_rng_normal(77, (uint64_t)seed, (uint64_t)i);
        }
        assert_false(orr_arc_step(t, r, N, NULL, &at, &v));
        for (int i = 333; i < N; i++) r[i] -= 2;
        assert_true(orr_arc_step(t, r, N, NULL, &at, &v));
        assert_int_equal(at, 333);
        ASSERT_NEAR(v, -2, 0.6); // a line does not follow the wave
    }
    assert_false(orr_arc_step(t, r, 30, NULL, &at, &v));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_none_invented),       cmocka_unit_test(test_every_slip_found),
        cmocka_unit_test(test_slips_at_the_ends),   cmocka_unit_test(test_backward),
        cmocka_unit_test(test_gaps_flags_outliers), cmocka_unit_test(test_phase_alone_and_edges),
        cmocka_unit_test(test_step_after_fit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions joined and cut: what is the same stays the same, what differs goes over with its derivatives, breaks stay breaks.
#include "testing.h"

#include "orbit/smooth/solution_cut.h"
#include "orbit/smooth/solution_join.h"
#include "unit/orbit/made_orbit.h"

#define MIDDLE_S (6 * 3600.0)
#define HALF_S (3 * 3600.0)

static orr_time at(double t_s) { return orr_time_add_s(made_midnight, t_s); }

// The earlier half and the later half of a day of solutions, each three hours beyond the middle.
static void two(size_t n_sats, orr_orbit_solution *a, orr_orbit_solution *b)
{
    *a = made_solution(n_sats, 12, 900, 4);
    *b = made_solution(n_sats, 12, 900, 4);
    orr_orbit_solution_cut(a, at(0), at(9 * 3600));
    orr_orbit_solution_cut(b, at(3 * 3600), at(12 * 3600));
    memset(b->source[0].sha256, 'b', 64);
}

// A solution cut in two and joined is the solution, but for the rounding of a + w (b - a) where a = b.
static void the_same_gives_the_same(void **state)
{
    (void)state;
    orr_orbit_solution whole = made_solution(6, 12, 900, 4), a, b, j;
    orr_diag d = {0};
    two(6, &a, &b);
    ASSERT_OK(orr_orbit_solution_join(&a, &b, at(MIDDLE_S), HALF_S, &j, &d), d);
    assert_int_equal(j.n_sats, 6);
    assert_int_equal(j.n_sources, 2);
    for (size_t i = 0; i < 6; i++) {
        const orr_orbit_sat *s = &j.sat[i], *w = &whole.sat[i];
        assert_int_equal(s->n_arcs, 1);
        assert_true(s->arc[0].t0 == w->arc[0].t0);
        assert_int_equal(s->arc[0].n, w->arc[0].n);
        assert_int_equal(s->arc[0].samples_per_segment, 4);
        for (size_t k = 0; k < s->arc[0].n; k++) {
            const orr_orbit_sample *p = &s->arc[0].sample[k], *q = &w->arc[0].sample[k];
            assert_true(orr_vec3_norm(orr_vec3_sub(p->pos_m, q->pos_m)) == 0); // b - a is nought
            assert_true(orr_vec3_norm(orr_vec3_sub(p->vel_mps, q->vel_mps)) == 0);
            assert_true(orr_vec3_norm(orr_vec3_sub(p->acc_mps2, q->acc_mps2)) == 0);
        }
        assert_int_equal(s->n_clocks, w->n_clocks);
        assert_int_equal(s->n_nodes, w->n_nodes);
        assert_int_equal(s->n_events, w->n_events);
        for (size_t k = 0; k < s->n_nodes; k++)
            assert_int_equal(s->node[k].source, s->node[k].t < at(MIDDLE_S) ? 0 : 1);
    }
    made_solution_free(&whole);
    made_solution_free(&a);
    made_solution_free(&b);
    orr_orbit_solution_free(&j);
}

// Of a constant offset between them the velocity is its weight's slope: integrated over the stretch it is the offset, and the
// acceleration to the velocity. Trapezoids of 1/96 of the stretch err by some (1/96)^2 of what they integrate: 3e-6 m of 0.03 m,
// 2e-9 m/s of 2.6e-6 m/s.
static void an_offset_goes_over_with_its_derivatives(void **state)
{
    (void)state;
    orr_orbit_solution a, b, j;
    orr_diag d = {0};
    two(1, &a, &b);
    const double offset = 0.03;
    for (size_t k = 0; k < b.sat[0].arc[0].n; k++) b.sat[0].arc[0].sample[k].pos_m.x += offset;
    ASSERT_OK(orr_orbit_solution_join(&a, &b, at(MIDDLE_S), HALF_S, &j, &d), d);
    const made_satellite m = made_satellite_at(0);
    const orr_orbit_arc *arc = &j.sat[0].arc[0];
    double moved = 0, gained = 0;
    for (size_t k = 0; k < arc->n; k++) {
        orr_vec3 r, v, acc;
        const double t = (double)k * arc->step_s;
        made_state(&m, t, &r, &v, &acc);
        const double dx = arc->sample[k].pos_m.x - r.x, dv = arc->sample[k].vel_mps.x - v.x;
        ASSERT_NEAR(dx, t <= MIDDLE_S - HALF_S ? 0 : t >= MIDDLE_S + HALF_S ? offset : moved, 3e-6);
        ASSERT_NEAR(dv, gained, 2e-9);
        if (k + 1 == arc->n) break;
        orr_vec3 r1, v1, a1;
        made_state(&m, t + arc->step_s, &r1, &v1, &a1);
        moved += 0.5 * arc->step_s * (dv + arc->sample[k + 1].vel_mps.x - v1.x);
        gained +=
            0.5 * arc->step_s * (arc->sample[k].acc_mps2.x - acc.x + arc->sample[k + 1].acc_mps2.x - a1.x);
    }
    ASSERT_NEAR(moved, offset, 3e-6);
    made_solution_free(&a);
    made_solution_free(&b);
    orr_orbit_solution_free(&j);
}

// A satellite with a break at 5 h in both goes over behind it; one that only the later has begins at the middle.
static void breaks_and_newcomers(void **state)
{
    (void)state;
    orr_orbit_solution a, b, j;
    orr_diag d = {0};
    two(3, &a, &b);
    orr_orbit_solution *both[2] = {&a, &b};
    for (int k = 0; k < 2; k++) { // its arc is cut in two at 5 h
        orr_orbit_sat *s = &both[k]->sat[1];
        const size_t at_sample =
            (size_t)((5 * 3600.0 - orr_time_diff_s(s->arc[0].t0, made_midnight)) / s->arc[0].step_s);
        orr_orbit_arc *arc = calloc(2, sizeof *arc);
        arc[0] = arc[1] = s->arc[0];
        arc[0].n = at_sample + 1;
        arc[1].n = s->arc[0].n - at_sample;
        arc[1].t0 = at(5 * 3600);
        arc[1].sample = malloc(arc[1].n * sizeof *arc[1].sample);
        memcpy(arc[1].sample, arc[0].sample + at_sample, arc[1].n * sizeof *arc[1].sample);
        free(s->arc);
        s->arc = arc;
        s->n_arcs = 2;
    }
    orr_orbit_solution_cut(&a, at(0), at(9 * 3600));
    a.n_sats = 2; // the third is not in the earlier
    ASSERT_OK(orr_orbit_solution_join(&a, &b, at(MIDDLE_S), HALF_S, &j, &d), d);
    a.n_sats = 3;
    assert_int_equal(j.n_sats, 3);
    assert_int_equal(j.sat[1].n_arcs, 2);
    assert_true(j.sat[1].arc[1].t0 == at(5 * 3600));
    assert_true(j.sat[2].arc[0].t0 == at(MIDDLE_S));
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(&j, &e, &d), d); // and it is a solution that a product can be made of
    orr_sat_state s;
    for (double t = 60; t < 12 * 3600; t += 977) {
        assert_int_equal(orr_ephemeris_eval(e, j.sat[0].sat, at(t), &s), ORR_OK);
        assert_int_equal(orr_ephemeris_eval(e, j.sat[1].sat, at(t), &s), ORR_OK);
        assert_int_equal(orr_ephemeris_eval(e, j.sat[2].sat, at(t), &s),
                         t < MIDDLE_S ? ORR_E_NODATA : ORR_OK);
    }
    orr_ephemeris_free(e);
    made_solution_free(&a);
    made_solution_free(&b);
    orr_orbit_solution_free(&j);
}

// A cut keeps whole segments that reach into the span, and clocks about it, to the bit.
static void a_cut_keeps_what_it_keeps(void **state)
{
    (void)state;
    orr_orbit_solution whole = made_solution(2, 12, 900, 4), s = made_solution(2, 12, 900, 4);
    orr_orbit_solution_cut(&s, at(3600 + 450), at(2 * 3600));
    const orr_orbit_arc *a = &s.sat[0].arc[0], *w = &whole.sat[0].arc[0];
    assert_true(a->t0 == at(3600));
    assert_int_equal(a->n, 4 * 4 + 1);
    assert_memory_equal(a->sample, w->sample + 16, a->n * sizeof *a->sample);
    assert_true(s.sat[0].clock[0].t == at(3900) && s.sat[0].clock[s.sat[0].n_clocks - 1].t == at(7200));
    for (size_t k = 0; k < s.sat[0].n_nodes; k++)
        assert_true(s.sat[0].node[k].t >= at(4050) && s.sat[0].node[k].t <= at(7200));
    orr_orbit_solution_cut(&s, at(20 * 3600), at(21 * 3600)); // nothing is there
    assert_int_equal(s.n_sats, 0);
    made_solution_free(&whole);
    orr_orbit_solution_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_gives_the_same),
        cmocka_unit_test(an_offset_goes_over_with_its_derivatives),
        cmocka_unit_test(breaks_and_newcomers),
        cmocka_unit_test(a_cut_keeps_what_it_keeps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison with truth: planted differences come back as numbers, in the place where they belong.
#include "testing.h"

#include "orbit/judge/compare.h"
#include "unit/orbit/made_orbit.h"

enum { HOURS = 12, STEP = 300, EPOCHS = HOURS * 3600 / STEP + 1, NODE = 900 };
enum { GAP_FROM = 5 * 3600, GAP_TO = 6 * 3600 }; // last node before and first node behind the gap

static const orr_compare_options plain = {0}, derived = {.derive_velocity = true},
                                 all = {.with_inputs = true};

// A truth of the made satellites 0..n-1 with nothing planted yet.
static orr_sp3 made_truth(size_t n)
{
    orr_sp3 s = {.version = 'd', .n_sats = n, .n_epochs = EPOCHS};
    s.sat = calloc(n, sizeof *s.sat);
    s.epoch = calloc(EPOCHS, sizeof *s.epoch);
    s.record = calloc(n * EPOCHS, sizeof *s.record);
    for (size_t i = 0; i < EPOCHS; i++) {
        s.epoch[i] = made_midnight + (int64_t)i * STEP * ORR_NS_PER_S;
        for (size_t k = 0; k < n; k++) {
            made_satellite m = made_satellite_at(k);
            orr_sp3_record *r = &s.record[i * n + k];
            orr_vec3 p, v, a;
            made_state(&m, (double)(i * STEP), &p, &v, &a);
            s.sat[k] = m.sat;
            *r = (orr_sp3_record){.pos_m = {p.x, p.y, p.z},
                                  .vel_mps = {(double)NAN, (double)NAN, (double)NAN}};
        }
    }
    return s;
}

static void truth_free(orr_sp3 *s)
{
    free(s->sat);
    free(s->epoch);
    free(s->record);
}

// Three satellites (G01, R01, E01) with nodes every 900 s; those of E01 are missing between GAP_FROM and
// GAP_TO.
static orr_ephemeris *made_product(orr_orbit_solution *s)
{
    *s = made_solution(3, HOURS, NODE, 6);
    for (size_t i = 0; i < 3; i++) {
        orr_orbit_sat *sat = &s->sat[i];
        if (orr_sat_system(sat->sat) != 'E') continue;
        size_t n = 0;
        for (size_t k = 0; k < sat->n_nodes; k++) {
            int64_t t = (sat->node[k].t - made_midnight) / ORR_NS_PER_S;
            if (t <= GAP_FROM || t >= GAP_TO) sat->node[n++] = sat->node[k];
        }
        sat->n_nodes = n;
    }
    for (size_t i = 0; i < 3; i++) // all nodes used: made_solution rejects every fifth
        for (size_t k = 0; k < s->sat[i].n_nodes; k++) s->sat[i].node[k].used = 1;
    orr_ephemeris *e = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_ephemeris_build(s, &e, &diag), diag);
    return e;
}

static const orr_compare_stats *stats_of(const orr_comparison *x, char system, orr_compare_place place)
{
    for (size_t i = 0; i < x->n_systems; i++)
        if (x->system[i].system == system) return &x->system[i].place[place];
    fail_msg("no system %c in the comparison", system);
    return NULL;
}

static void test_places_and_numbers(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s;
    orr_ephemeris *e = made_product(&s);
    orr_sp3 truth = made_truth(3);
    orr_time worst = 0;
    for (size_t i = 0; i < EPOCHS; i++) {
        double t = (double)(i * STEP);
        orr_sp3_record *g = &truth.record[i * 3], *r = g + 1, *gal = g + 2;
        g->pos_m[0] -= 0.002; // product minus truth: +2 mm in x everywhere
        r->pos_m[1] += t <= 2700 ? 0.010 : 0.001;
        if (t > GAP_FROM && t < GAP_TO) gal->pos_m[2] += 0.005;
        if (i == 73) { // one larger one, at 6:05
            gal->pos_m[2] += 0.050;
            worst = truth.epoch[i];
        }
    }
    orr_comparison x;
    ASSERT_OK(orr_compare(e, &truth, 1, &plain, &x, &diag), diag);
    // Of 145 epochs 49 are nodes (every third). Inner: 2:00 to 10:00 is 97 epochs, of which 33 are nodes.
    // Edge: up to 0:45 and from 11:15, 10 epochs each, 4 of them nodes.
    const orr_compare_stats *in = stats_of(&x, 'G', ORR_COMPARE_INNER),
                            *edge = stats_of(&x, 'G', ORR_COMPARE_EDGE);
    assert_int_equal(in->n, 97 - 33);
    assert_int_equal(edge->n, 2 * (10 - 4));
    assert_int_equal(stats_of(&x, 'G', ORR_COMPARE_GAP)->n, 0);
    assert_true(isnan(stats_of(&x, 'G', ORR_COMPARE_GAP)->rms_m));
    assert_int_equal(in->satellites, 1);
    ASSERT_NEAR(in->rms_m, 0.002, 1e-6);
    ASSERT_NEAR(in->p95_m, 0.002, 1e-6);
    ASSERT_NEAR(in->max_m, 0.002, 1e-6);
    ASSERT_NEAR(in->mean_m.x, 0.002, 1e-6);
    ASSERT_NEAR(in->mean_m.y, 0, 1e-6);
    // sigma of the made orbit grows from 1 cm on; the truth is rounded to a millimetre
    assert_true(in->sigma_rms_m > 0.01 && in->sigma_rms_m < 0.1);
    ASSERT_NEAR(in->truth_rms_m, 0.5e-3, 1e-9);
    ASSERT_NEAR(in->error_over_sigma, in->rms_m / hypot(in->sigma_rms_m, 0.5e-3), 1e-12);
    ASSERT_NEAR(in->vel_sigma_rms_mps, 1e-4 * in->sigma_rms_m, 1e-8);
    for (size_t i = 0; i < x.n_systems; i++)
        for (int p = 0; p < ORR_COMPARE_PLACES; p++)
            assert_int_equal(x.system[i].light[ORR_COMPARE_SUNLIT][p].n +
                                 x.system[i].light[ORR_COMPARE_ECLIPSING][p].n,
                             x.system[i].place[p].n);
    // GLONASS: 6 of the 12 edge samples are 10 mm, 6 are 1 mm off; the 95th percentile by nearest rank is the
    // 12th.
    edge = stats_of(&x, 'R', ORR_COMPARE_EDGE);
    assert_int_equal(edge->n, 12);
    ASSERT_NEAR(edge->rms_m, sqrt((100.0 + 1.0) / 2) * 1e-3, 1e-6);
    ASSERT_NEAR(edge->p95_m, 0.010, 1e-6);
    ASSERT_NEAR(edge->mean_m.y, -0.0055, 1e-6);
    ASSERT_NEAR(stats_of(&x, 'R', ORR_COMPARE_INNER)->rms_m, 0.001, 1e-6);
    // Galileo: the 11 epochs strictly inside the gap are compared, the three that are nodes elsewhere
    // included, since they were no nodes here; they are not inner.
    const orr_compare_stats *gap = stats_of(&x, 'E', ORR_COMPARE_GAP);
    assert_int_equal(gap->n, 11);
    ASSERT_NEAR(gap->rms_m, 0.005, 1e-6);
    in = stats_of(&x, 'E', ORR_COMPARE_INNER);
    assert_int_equal(in->n, 64 - 8);
    ASSERT_NEAR(in->max_m, 0.050, 1e-6);
    ASSERT_NEAR(in->p95_m, 0, 1e-6);
    // Left out: 49 + 49 + 46 nodes.
    assert_int_equal(x.inputs, 144);
    assert_int_equal(x.no_orbit, 0);
    assert_int_equal(x.between, 3 * (145 - 97 - 20 - (49 - 33 - 8)));
    assert_int_equal(x.n_sats, 3);
    assert_true(orr_sat_system(x.sat[0].sat) == 'E' && x.sat[0].worst == worst);
    assert_true(x.sat[0].rms_m >= x.sat[1].rms_m && x.sat[1].rms_m >= x.sat[2].rms_m);
    orr_comparison_free(&x);
    truth_free(&truth);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

// Derived where the truth has no V records, else those.
static void test_velocities(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s;
    orr_ephemeris *e = made_product(&s);
    orr_sp3 truth = made_truth(3);
    orr_comparison x;
    ASSERT_OK(orr_compare(e, &truth, 1, &plain, &x, &diag), diag);
    const orr_compare_stats *g = stats_of(&x, 'G', ORR_COMPARE_INNER);
    assert_true(x.vel_derived);
    assert_int_equal(g->n_vel, g->n);
    ASSERT_NEAR(g->vel_rms_mps, 0, 1e-7); // exact positions: what the filter itself errs
    orr_comparison_free(&x);
    for (size_t i = 0; i < EPOCHS; i++) {
        made_satellite m = made_satellite_at(0);
        orr_vec3 p, v, a;
        made_state(&m, (double)(i * STEP), &p, &v, &a);
        double *vel = truth.record[i * 3].vel_mps;
        vel[0] = v.x - 3e-5, vel[1] = v.y + 4e-5, vel[2] = v.z;
    }
    ASSERT_OK(orr_compare(e, &truth, 1, &plain, &x, &diag), diag);
    ASSERT_NEAR(stats_of(&x, 'G', ORR_COMPARE_INNER)->vel_rms_mps, 5e-5, 1e-7);
    ASSERT_NEAR(stats_of(&x, 'R', ORR_COMPARE_INNER)->vel_rms_mps, 0, 1e-7);
    orr_comparison_free(&x);
    ASSERT_OK(orr_compare(e, &truth, 1, &derived, &x, &diag), diag); // the records are not looked at
    ASSERT_NEAR(stats_of(&x, 'G', ORR_COMPARE_INNER)->vel_rms_mps, 0, 1e-7);
    orr_comparison_free(&x);
    truth_free(&truth);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static void test_nothing_to_compare(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s;
    orr_ephemeris *e = made_product(&s);
    orr_sp3 truth = made_truth(3);
    orr_comparison x;
    // Other days: the product has no orbit there.
    for (size_t i = 0; i < EPOCHS; i++) truth.epoch[i] += INT64_C(7) * ORR_S_PER_DAY * ORR_NS_PER_S;
    assert_int_equal(orr_compare(e, &truth, 1, &plain, &x, &diag), ORR_E_NODATA);
    assert_non_null(strstr(diag.text, "435"));
    // Nothing but what went in.
    for (size_t i = 0; i < EPOCHS; i++) truth.epoch[i] -= INT64_C(7) * ORR_S_PER_DAY * ORR_NS_PER_S;
    for (size_t i = 0; i < EPOCHS; i++)
        for (size_t k = 0; k < 3 && i % 3 != 0; k++) truth.record[i * 3 + k].pos_m[1] = (double)NAN;
    for (size_t i = 0; i < EPOCHS; i++) truth.record[i * 3 + 2].pos_m[0] = (double)NAN;
    assert_int_equal(orr_compare(e, &truth, 1, &plain, &x, &diag), ORR_E_NODATA);
    // It is there when it is asked for, in the same places.
    ASSERT_OK(orr_compare(e, &truth, 1, &all, &x, &diag), diag);
    assert_true(x.inputs > 80);
    size_t n = x.between;
    for (size_t i = 0; i < x.n_systems; i++)
        for (int p = 0; p < ORR_COMPARE_PLACES; p++) n += x.system[i].place[p].n;
    assert_int_equal(n, x.inputs);
    orr_comparison_free(&x);
    truth.n_epochs = 0;
    assert_int_equal(orr_compare(e, &truth, 1, &plain, &x, &diag), ORR_E_NODATA);
    truth_free(&truth);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_places_and_numbers),
        cmocka_unit_test(test_velocities),
        cmocka_unit_test(test_nothing_to_compare),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

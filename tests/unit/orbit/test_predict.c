// SPDX-License-Identifier: GPL-3.0-or-later
// A satellite carried on: the path is the orbit that its nodes came from, it leaves the smoothed arc without a kink, and
// its sigma grows as it is said to.
#include "testing.h"

#include "orbit/predict/predict_path.h"
#include "orbit/predict/predict_sigma.h"

#define NODES 97
#define STEP_S 900.0
#define SAMPLE_S 150.0
#define SPAN_S (86400.0 * 1.25)

typedef struct made { // one satellite over a day, and its truth for six hours more
    orr_sky *sky;
    orr_gravity_field earth;
    orr_reference_node node[NODES];
    uint16_t source[NODES];
    orr_reference_arc fit;
    orr_predict_room room;
} made;

static orr_vec3 truth_at(made *m, double t_s, orr_vec3 *v_ecef)
{
    orr_vec3 r = m->fit.r_m, v = m->fit.v_mps, r_ecef, dummy;
    orr_sky_point p;
    assert_int_equal(orr_integrate(m->room.integrator, 0, t_s, &r, &v), ORR_OK);
    orr_sky_at(m->sky, t_s, &p);
    orr_sky_to_ecef(&p, r, v, &r_ecef, v_ecef != NULL ? v_ecef : &dummy);
    return r_ecef;
}

static void make(made *m)
{
    orr_diag d = {0};
    orr_time from;
    *m = (made){0};
    ASSERT_OK(orr_time_parse("2024-02-04", NULL, &from, &d), d);
    ASSERT_OK(orr_sky_init_precise(from, orr_time_add_s(from, SPAN_S), &m->sky, &d), d);
    double mjd[2] = {60343, 60347};
    orr_eop value[2] = {{.xp_rad = 1e-7, .yp_rad = 1.5e-6}, {.xp_rad = 1.1e-7, .yp_rad = 1.51e-6}};
    orr_sky_turn(m->sky, &(orr_eop_series){2, mjd, value});
    ASSERT_OK(orr_gravity_field_init(&m->earth, 8, false, &d), d);
    ASSERT_OK(orr_predict_room_init(m->sky, &m->earth, &m->room, &d), d);
    const double ecom[ORR_ECOM_TERMS] = {-98, 0.4, -0.6, 0.3, -1.1, 0.8, 0.2, -0.3, 0.1};
    m->fit = (orr_reference_arc){.window = 1,
                                 .n = NODES,
                                 .node = m->node,
                                 .fitted = true,
                                 .r_m = {2.0e7, 1.6e7, 5e6},
                                 .v_mps = {-1.7e3, 1.0e3, 3.3e3}};
    memcpy(m->fit.ecom_nmps2, ecom, sizeof ecom);
    memcpy(m->room.force.ecom_nmps2, ecom, sizeof ecom);
    for (int i = 0; i < NODES; i++)
        m->node[i] = (orr_reference_node){STEP_S * i, truth_at(m, STEP_S * i, NULL)};
}

static void unmake(made *m)
{
    orr_predict_room_free(&m->room);
    orr_sky_free(m->sky);
}

// A smoothed arc of two samples up to the last node, `off` from the truth at its end.
static orr_orbit_arc arc_of(made *m, orr_vec3 off)
{
    const double end_s = STEP_S * (NODES - 1);
    orr_orbit_arc a = {.t0 = orr_time_add_s(orr_sky_origin(m->sky), end_s - SAMPLE_S),
                       .step_s = SAMPLE_S,
                       .n = 2,
                       .samples_per_segment = 1,
                       .sample = calloc(2, sizeof *a.sample)};
    assert_non_null(a.sample);
    for (int i = 0; i < 2; i++) {
        a.sample[i].pos_m = truth_at(m, end_s - SAMPLE_S * (1 - i), &a.sample[i].vel_mps);
        a.sample[i].sigma_m = 0.001f;
    }
    a.sample[1].pos_m = orr_vec3_add(a.sample[1].pos_m, off);
    return a;
}

// Nodes without noise leave the filter on the orbit, but for what its priors pull: micrometres. What is integrated in
// steps of 150 s and at one go agrees to 0.1 mm over six hours.
static void the_path_is_the_orbit(void **state)
{
    (void)state;
    made m;
    make(&m);
    orr_predict_start start;
    assert_int_equal(orr_predict_filter(&m.room, &m.fit, m.source, &start), ORR_OK);
    ASSERT_NEAR(start.t_s, 86400, 1e-9);
    for (int i = 0; i < 3; i++) ASSERT_NEAR(start.x[i], 0, 1e-4);
    assert_true(isnan(start.joint_m)); // one file
    orr_orbit_arc a = arc_of(&m, (orr_vec3){0, 0, 0});
    assert_int_equal(orr_predict_extend(&m.room, &m.fit, &start, 86400 + 21600, &a), ORR_OK);
    assert_int_equal(a.n, 2 + 144);
    double worst_mm = 0, worst_mps = 0;
    for (size_t i = 2; i < a.n; i++) {
        orr_vec3 v;
        const orr_vec3 r = truth_at(&m, 86400 + SAMPLE_S * (double)(i - 1), &v);
        worst_mm = fmax(worst_mm, 1e3 * orr_vec3_norm(orr_vec3_sub(r, a.sample[i].pos_m)));
        worst_mps = fmax(worst_mps, orr_vec3_norm(orr_vec3_sub(v, a.sample[i].vel_mps)));
        assert_true((a.sample[i].flags & ORR_EPH_PREDICTED) != 0);
    }
    print_message("off the orbit by %.4f mm and %.1e m/s at most\n", worst_mm, worst_mps);
    ASSERT_NEAR(worst_mm, 0, 0.5);
    ASSERT_NEAR(worst_mps, 0, 1e-7);
    assert_true((a.sample[0].flags & ORR_EPH_PREDICTED) == 0 && (a.sample[1].flags & ORR_EPH_PREDICTED) != 0);
    free(a.sample);
    unmake(&m);
}

// An arc that ends 2 cm beside it is left smoothly: velocities are the derivatives of the positions and accelerations
// those of the velocities (Simpson's rule over two steps: exact to 1e-9 for what changes within half an hour), and after
// two hours nothing of the 2 cm is left.
static void it_leaves_the_arc_without_a_kink(void **state)
{
    (void)state;
    made m;
    make(&m);
    orr_predict_start start;
    assert_int_equal(orr_predict_filter(&m.room, &m.fit, m.source, &start), ORR_OK);
    const orr_vec3 off = {0.012, -0.009, 0.013};
    orr_orbit_arc a = arc_of(&m, off), straight = arc_of(&m, (orr_vec3){0, 0, 0});
    assert_int_equal(orr_predict_extend(&m.room, &m.fit, &start, 86400 + 10800, &a), ORR_OK);
    assert_int_equal(orr_predict_extend(&m.room, &m.fit, &start, 86400 + 10800, &straight), ORR_OK);
    // The difference of the two paths, whose derivatives are small enough to be told from rounding.
    for (size_t i = 1; i + 2 < a.n; i++) {
        orr_vec3 d[3], v[3], acc[3];
        for (size_t k = 0; k < 3; k++) {
            d[k] = orr_vec3_sub(a.sample[i + k].pos_m, straight.sample[i + k].pos_m);
            v[k] = orr_vec3_sub(a.sample[i + k].vel_mps, straight.sample[i + k].vel_mps);
            acc[k] = orr_vec3_sub(a.sample[i + k].acc_mps2, straight.sample[i + k].acc_mps2);
        }
        const orr_vec3 by_v = orr_vec3_scale(SAMPLE_S / 3, orr_vec3_add(orr_vec3_axpy(4, v[1], v[0]), v[2]));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_vec3_sub(d[2], d[0]), by_v)), 0, 2e-6);
        if (i == 1) continue; // the arc's last sample has the acceleration of the smoother
        const orr_vec3 by_a =
            orr_vec3_scale(SAMPLE_S / 3, orr_vec3_add(orr_vec3_axpy(4, acc[1], acc[0]), acc[2]));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_vec3_sub(v[2], v[0]), by_a)), 0, 2e-8);
    }
    const orr_vec3 first = orr_vec3_sub(a.sample[2].pos_m, straight.sample[2].pos_m);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(first, off)), 0, 5e-4);
    for (size_t i = 1 + 48; i < a.n; i++)
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a.sample[i].pos_m, straight.sample[i].pos_m)), 0, 1e-6);
    free(a.sample);
    free(straight.sample);
    unmake(&m);
}

// Two files whose orbits are 3 cm apart: told, and the path goes on from the later.
static void a_step_between_files_is_told(void **state)
{
    (void)state;
    made m;
    make(&m);
    orr_predict_start start;
    for (int i = 0; i < 80; i++) m.node[i].ecef_m.x += 0.03;
    for (int i = 80; i < NODES; i++) m.source[i] = 1;
    assert_int_equal(orr_predict_filter(&m.room, &m.fit, m.source, &start), ORR_OK);
    ASSERT_NEAR(start.joint_m, 0.03, 0.006);
    ASSERT_NEAR(orr_vec3_norm((orr_vec3){start.x[0], start.x[1], start.x[2]}), 0, 0.008);
    unmake(&m);
}

static void sigma_grows(void **state)
{
    (void)state;
    const orr_predict_known usual = {.sat = orr_sat_make('G', 5),
                                     .r_m = {2.0e7, 1.6e7, 5e6},
                                     .v_mps = {-1.7e3, 1.0e3, 3.3e3},
                                     .history_s = 2 * 86400.0,
                                     .rms_ratio = 1,
                                     .joint_m = 0.02};
    const orr_predict_growth g = orr_predict_growth_of(&usual);
    assert_true(orr_predict_sigma(&g, 0) == 0);
    double before = 0;
    for (double t = 60; t < 7 * 86400.0; t += 60) {
        const double now = orr_predict_sigma(&g, t);
        assert_true(now > before);
        assert_true(now - before < 3e-3); // without a jump
        before = now;
    }
    // The joint at once; all that is known to be worse makes it larger, at every age.
    ASSERT_NEAR(orr_predict_sigma(&g, 1200), 0.024, 0.003);
    orr_predict_known worse[5] = {usual, usual, usual, usual, usual};
    worse[0].eclipses = true;
    worse[1].history_s = 43200;
    worse[2].rms_ratio = 3;
    worse[3].sat = orr_sat_make('R', 5);
    worse[4].r_m = orr_vec3_scale(1.6, usual.r_m); // geosynchronous
    for (int k = 0; k < 5; k++) {
        const orr_predict_growth w = orr_predict_growth_of(&worse[k]);
        for (double t = 3600; t < 3 * 86400.0; t *= 2)
            assert_true(orr_predict_sigma(&w, t) > orr_predict_sigma(&g, t));
    }
    // What is not known does no harm.
    orr_predict_known unknown = usual;
    unknown.rms_ratio = unknown.joint_m = (double)NAN;
    unknown.history_s = 0;
    const orr_predict_growth u = orr_predict_growth_of(&unknown);
    assert_true(isfinite(orr_predict_sigma(&u, 86400)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_path_is_the_orbit),
        cmocka_unit_test(it_leaves_the_arc_without_a_kink),
        cmocka_unit_test(a_step_between_files_is_told),
        cmocka_unit_test(sigma_grows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

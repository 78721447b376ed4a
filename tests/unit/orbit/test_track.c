// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of an arc that begins or ends where two orbits meet, at a whole millisecond: its step is a whole
// number of nanoseconds, or the product refuses it, however long after the product's begin that is.
#include "testing.h"

#include "core/rng.h"
#include "orbit/smooth/smoother.h"
#include "orbit/smooth/track.h"

static void steps_are_whole_nanoseconds(void **state)
{
    (void)state;
    const orr_smoother_options o = orr_smoother_defaults();
    const orr_track_context c = {.options = &o, .eop_known = true};
    static const double begin_s[] = {0, 86400, 604800, 3.2e7, 3.1e8};
    for (size_t k = 0; k < sizeof begin_s / sizeof begin_s[0]; k++)
        for (uint64_t n = 0; n < 300; n++) {
            // Millisecond of the push, and the arc from a node before to there or from there to a node after.
            const double push_s =
                begin_s[k] + floor(4e7 * orr_rng_uniform(1, k, n)) / 1000 + 2 * (double)o.grid_s;
            const double node_s = begin_s[k] + 900 * floor(100 * orr_rng_uniform(2, k, n));
            orr_track t;
            assert_int_equal(orr_track_init(&c, fmin(push_s, node_s), fmax(push_s, node_s), 900, NULL, 0, &t),
                             ORR_OK);
            const double ns = t.step_s * 1e9;
            ASSERT_NEAR(ns, nearbyint(ns), 1e-3); // what orr_ephemeris_build asks for
            assert_true(t.step_s <= o.grid_s * (1 + 1e-9));
            assert_int_equal(t.n_grid, t.n_samples);
            // The arc's last sample is where the next arc begins.
            assert_int_equal(orr_track_ns(fmin(push_s, node_s)) + llround(ns) * (int64_t)(t.n_samples - 1),
                             orr_track_ns(fmax(push_s, node_s)));
            assert_int_equal(orr_track_ns(push_s) % 1000000, 0);
            ASSERT_NEAR(t.at[t.n - 1].t_s, fmax(push_s, node_s), 1e-7);
            orr_track_free(&t);
        }
}

// Between nodes a quarter of an hour apart the trajectory is integrated at one go and filled by a polynomial: its states
// are those of short steps, and its partial derivatives lead from one to the next.
static void states_between_nodes_are_those_of_short_steps(void **state)
{
    (void)state;
    enum { NODES = 49 };
    const orr_smoother_options o = orr_smoother_defaults();
    orr_force force = {.sun_moon = true, .precise = true, .ecom_nmps2 = {-100, 1, -1, 3}};
    orr_diag d = {0};
    orr_sky *sky = NULL;
    orr_integrator *it = NULL;
    const orr_time from = 1391040000 * ORR_NS_PER_S;
    ASSERT_OK(orr_gravity_field_init(&force.earth, 8, false, &d), d);
    ASSERT_OK(orr_sky_init(from, from + 43200 * ORR_NS_PER_S, ORR_SKY_GCRS, NULL, NULL, &sky, NULL, &d), d);
    ASSERT_OK(orr_integrator_init(&force, sky, &it, &d), d);
    const orr_track_context c = {.options = &o,
                                 .sky = sky,
                                 .force = &force,
                                 .integrator = it,
                                 .eop_known = true,
                                 .noise = {.nx = ORR_NX, .qf_m2ps5 = o.qf_m2ps5}};
    orr_sky_point p;
    orr_sky_at(sky, 0, &p);
    for (int eclipsing = 0; eclipsing < 2; eclipsing++) {
        // The Sun 5 deg above the plane: in the plane ECOM's axes turn over at noon and midnight.
        const orr_vec3 sun = orr_vec3_unit(p.sun_m),
                       side = orr_vec3_unit(orr_vec3_cross(sun, (orr_vec3){0, 0, 1})),
                       across = orr_vec3_unit(orr_vec3_cross(sun, side)),
                       normal = eclipsing ? orr_vec3_unit(orr_vec3_axpy(0.0875, sun, across)) : sun;
        const double radius = 2.55e7;
        orr_node node[NODES];
        orr_reference reference[NODES] = {{0}};
        for (int i = 0; i < NODES; i++) node[i] = (orr_node){.t_s = 900.0 * i, .superseded = i > 0};
        orr_vec3 r = orr_vec3_scale(radius, side),
                 v = orr_vec3_scale(sqrt(ORR_EGM96_GM / radius), orr_vec3_cross(normal, side));
        reference[0] = (orr_reference){.valid = true, .r_m = r, .v_mps = v};
        orr_track t;
        assert_int_equal(orr_track_init(&c, 0, 43200, 900, node, NODES, &t), ORR_OK);
        assert_int_equal(orr_track_linearise(&c, reference, &t), ORR_OK);
        double worst_r = 0, worst_v = 0;
        for (size_t g = 0; g + 1 < t.n_grid; g++) {
            worst_r = fmax(worst_r, orr_vec3_norm(orr_vec3_sub(t.grid[g].r_m, r)));
            worst_v = fmax(worst_v, orr_vec3_norm(orr_vec3_sub(t.grid[g].v_mps, v)));
            const double h = t.grid[g + 1].t_s - t.grid[g].t_s;
            for (int i = 0; i < 10; i++)
                ASSERT_OK(orr_integrate(it, t.grid[g].t_s + h * i / 10, h / 10, &r, &v), (orr_diag){0});
        }
        print_message("%s: %.2e m, %.2e m/s from short steps\n", eclipsing ? "through the shadow" : "sunlit",
                      worst_r, worst_v);
        // The stepper's drift along the orbit in half a day, as in unit.orbit.integrate; the polynomial adds 5 um.
        ASSERT_NEAR(worst_r, 0, 1e-4);
        ASSERT_NEAR(worst_v, 0, 1e-7);
        orr_track_free(&t);
    }
    orr_integrator_free(it);
    orr_sky_free(sky);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(steps_are_whole_nanoseconds),
                                       cmocka_unit_test(states_between_nodes_are_those_of_short_steps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(steps_are_whole_nanoseconds)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

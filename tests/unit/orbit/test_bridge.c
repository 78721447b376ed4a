// SPDX-License-Identifier: GPL-3.0-or-later
// Hours without nodes, filled from a broadcast record: where the new nodes stand, what they are worth, and
// nodes of one instant alone, between which there is nothing to fill.
#include "testing.h"

#include <stdlib.h>

#include "orbit/broadcast/broadcast.h"
#include "orbit/smooth/bridge.h"

static const orr_time noon = 1391083200 * ORR_NS_PER_S;

static orr_nav_eph record(void)
{
    orr_nav_eph e = {.sat = orr_sat_parse("G05"),
                     .kind = ORR_NAV_KEPLER,
                     .message = ORR_NAV_LNAV,
                     .toe = noon,
                     .toc = noon,
                     .transmission = ORR_TIME_NONE,
                     .fit_interval_h = 4};
    e.kepler = (orr_nav_kepler){.sqrt_a_sqrtm = 5153.7, .e = 0.005, .i0_rad = 0.96, .toe_sow_s = 43200};
    return e;
}

// Nodes `step_s` apart without those in the middle, each a metre off the record to this side or that.
static void make(const orr_nav_eph *e, double step_s, orr_node_list *l)
{
    enum { N = 16 };
    *l = (orr_node_list){.sat = e->sat, .node = calloc(N, sizeof *l->node)};
    assert_non_null(l->node);
    for (int k = 0; k < N; k++) {
        orr_broadcast_state s;
        const double t_s = step_s * (k < N / 2 ? k - N : k - N / 2 + 4);
        const orr_time t = orr_time_add_s(noon, t_s);
        assert_int_equal(orr_broadcast_eval(e, t, &s), ORR_OK);
        s.pos_m.x += k % 2 == 0 ? 1 : -1;
        l->node[l->n_nodes++] = (orr_node){.t = t, .t_s = t_s, .ecef_m = s.pos_m, .sigma_m = 0.025};
    }
}

static void a_gap_is_filled_from_the_record(void **state)
{
    (void)state;
    orr_nav_eph e = record();
    const orr_nav nav = {.n_eph = 1, .eph = &e};
    orr_node_list l;
    make(&e, 300, &l);
    assert_int_equal(orr_bridge_nodes(&nav, noon, 300, ORR_TIME_NONE, &l), ORR_OK);
    assert_int_equal(l.n_nodes, 16 + 12); // between -9 and +4 steps
    for (size_t k = 0; k < l.n_nodes; k++) {
        orr_broadcast_state s;
        if (k > 0) assert_int_equal(l.node[k].t - l.node[k - 1].t, 300 * ORR_NS_PER_S);
        if (!l.node[k].bridge) continue;
        assert_int_equal(orr_broadcast_eval(&e, l.node[k].t, &s), ORR_OK);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.pos_m, l.node[k].ecef_m)), 0,
                    0.5); // the sides nearly cancel
        // A metre in one of three axes, one error for the 144 nodes of twelve hours.
        ASSERT_NEAR(l.node[k].sigma_m, 12 / sqrt(3), 0.7);
        assert_true(l.node[k].predicted);
    }
    free(l.node);
}

static void nodes_of_one_instant_have_no_gap(void **state)
{
    (void)state;
    orr_nav_eph e = record();
    const orr_nav nav = {.n_eph = 1, .eph = &e};
    orr_node_list l;
    make(&e, 0, &l);
    assert_int_equal(orr_bridge_nodes(&nav, noon, 0, noon + 7200 * ORR_NS_PER_S, &l), ORR_OK);
    assert_int_equal(l.n_nodes, 16);
    free(l.node);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_gap_is_filled_from_the_record),
                                       cmocka_unit_test(nodes_of_one_instant_have_no_gap)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

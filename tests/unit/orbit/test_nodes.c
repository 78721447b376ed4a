// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes gathered from files that overlap: which of them count, whatever the order of the files, and what is told.
#include "testing.h"

#include "made_sp3.h"
#include "orbit/smooth/nodes.h"

static made_sky sky;
static made_truth gps;

static int make_truth(void **state)
{
    (void)state;
    made_sky_init(&sky, "2024-03-10", 2.6);
    made_orbit(&sky, orr_sat_make('G', 7), 2.656e7, 0.01, 0.96, 0.3, 1.0, 2e-8, -1, 0, &gps);
    return 0;
}
static int drop_truth(void **state)
{
    (void)state;
    made_sky_free(&sky);
    return 0;
}

// Quarter-hour nodes from hour a on, for two days, the second of them predicted and off by the file's own `off_m`.
static orr_sp3 ultra(size_t a, double off_m)
{
    const made_truth *const all[] = {&gps};
    orr_sp3 f;
    made_sp3(&sky, all, 1, a * 12, a * 12 + 576, 3, &f);
    for (size_t e = 97; e < f.n_epochs; e++) {
        f.record[e].flags |= ORR_SP3_ORBIT_PREDICTED;
        f.record[e].pos_m[0] += off_m;
    }
    return f;
}

static bool told(const orr_warnings *w, const char *what)
{
    for (size_t i = 0; i < w->kept; i++)
        if (strstr(w->item[i].text, what) != NULL) return true;
    return false;
}

static void free_files(orr_sp3 *f, size_t n)
{
    for (size_t i = 0; i < n; i++) made_sp3_free(&f[i]);
}

static void the_newer_prediction_counts_in_any_order(void **state)
{
    (void)state;
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const char *const name[3] = {"u00", "u06", "u12"};
    orr_sp3 f[3] = {ultra(0, 3), ultra(6, 2), ultra(12, 1)};
    for (int p = 0; p < 6; p++) {
        orr_smoother_input in[3] = {0};
        for (int k = 0; k < 3; k++) {
            in[k].sp3 = &f[order[p][k]];
            snprintf(in[k].name, sizeof in[k].name, "%s", name[order[p][k]]);
        }
        const orr_smoother_options o = orr_smoother_defaults();
        orr_node_table t;
        orr_warnings w = {0};
        orr_diag d = {0};
        ASSERT_OK(orr_nodes_collect(in, 3, &o, &t, &w, &d), d);
        size_t counted = 0, predicted = 0;
        for (size_t i = 0; i < t.list[0].n_nodes; i++) {
            const orr_node *n = &t.list[0].node[i];
            if (!orr_node_counts(n)) continue;
            counted++;
            predicted += n->predicted;
            // Observed until noon of the second day; what is predicted is the newest file's, off by 1 m.
            assert_int_equal(n->predicted, n->t_s > 36 * 3600);
            if (n->predicted) assert_string_equal(in[n->source].name, "u12");
        }
        assert_int_equal(counted, 3 * 97 + 96);
        assert_int_equal(predicted, 96);
        assert_true(told(&w, "u12: 96 of 193") ||
                    told(&w, "96 of 193 positions are the centre's predictions"));
        assert_true(told(&w, "overlap"));
        orr_nodes_free(&t);
        orr_warnings_free(&w);
    }
    free_files(f, 3);
}

static void frames_that_differ_are_told(void **state)
{
    (void)state;
    orr_sp3 f[2] = {ultra(0, 0), ultra(12, 0)};
    for (int same = 0; same < 2; same++) {
        snprintf(f[0].coordinates, sizeof f[0].coordinates, "IGS14");
        snprintf(f[1].coordinates, sizeof f[1].coordinates, same ? "IGS14" : "IGS20");
        const orr_smoother_input in[2] = {{.sp3 = &f[0], .name = "a"}, {.sp3 = &f[1], .name = "b"}};
        const orr_smoother_options o = orr_smoother_defaults();
        orr_node_table t;
        orr_warnings w = {0};
        orr_diag d = {0};
        ASSERT_OK(orr_nodes_collect(in, 2, &o, &t, &w, &d), d);
        assert_int_equal(told(&w, "IGS20"), !same);
        orr_nodes_free(&t);
        orr_warnings_free(&w);
    }
    free_files(f, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_newer_prediction_counts_in_any_order),
                                       cmocka_unit_test(frames_that_differ_are_told)};
    return cmocka_run_group_tests(tests, make_truth, drop_truth);
}

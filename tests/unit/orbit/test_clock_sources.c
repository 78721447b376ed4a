// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks of several files made one, and judged: order, precedence, alignment, what belongs to a satellite and what
// to the reference clock.
#include "testing.h"

#include "core/rng.h"
#include "orbit/clock/clock_between.h"
#include "orbit/clock/clock_judge.h"
#include "orbit/clock/clock_sources.h"

#define STEP 300
#define GAP 1350.0
enum { SATS = 6 };

static double between_s2(const orr_clock_noise *n, double length_s, double part)
{
    double variance_s2;
    orr_clock_between_s2(n, &length_s, &part, &variance_s2);
    return variance_s2;
}

static orr_time at(int64_t s) { return INT64_C(1390000000) * ORR_NS_PER_S + s * ORR_NS_PER_S; }

// What the clock of satellite i truly is.
static double truth(size_t i, int64_t s) { return 1e-5 * (double)(i + 1) + 1e-11 * (double)i * (double)s; }

// A file from a to b (s), predicted from `until` on; its clocks are off by `offset`, predicted ones by 7 ns more.
static orr_clock_source made(const char *name, int64_t a, int64_t b, int64_t until, int step, double offset)
{
    orr_clock_source f = {
        .name = name, .first = at(a), .observed = at(until < b ? until : b), .step_s = step};
    f.table.list = calloc(SATS, sizeof *f.table.list);
    f.table.n = SATS;
    for (size_t i = 0; i < SATS; i++) {
        orr_clock_list *l = &f.table.list[i];
        l->sat = orr_sat_make('G', (int)i + 1);
        l->node = calloc((size_t)((b - a) / step + 1), sizeof *l->node);
        for (int64_t s = a; s <= b; s += step)
            l->node[l->n++] = (orr_clock_node){.t = at(s),
                                               .clock_s = truth(i, s) + offset + (s > until ? 7e-9 : 0),
                                               .flags = s > until ? ORR_EPH_PREDICTED : 0};
    }
    return f;
}

static orr_clock_table join(orr_clock_source *f, size_t n, orr_warnings *w)
{
    orr_clock_table out;
    assert_int_equal(orr_clock_sources_join(f, n, GAP, &out, w), ORR_OK);
    assert_int_equal(out.n, SATS);
    return out;
}

static void free_sources(orr_clock_source *f, size_t n)
{
    for (size_t i = 0; i < n; i++) orr_clock_table_free(&f[i].table);
}

static void assert_same(const orr_clock_table *a, const orr_clock_table *b)
{
    assert_int_equal(a->n, b->n);
    for (size_t i = 0; i < a->n; i++) {
        assert_int_equal(a->list[i].n, b->list[i].n);
        assert_memory_equal(a->list[i].node, b->list[i].node, a->list[i].n * sizeof *a->list[i].node);
    }
}

// Days that meet keep both values at midnight; nothing is shifted, whatever the centre's scale does.
static void days_that_meet_keep_both_values(void **state)
{
    (void)state;
    orr_clock_source f[2] = {made("b", 86400, 172800, 172800, 900, 408e-9),
                             made("a", 0, 86400, 86400, 900, 0)};
    orr_warnings w = {0};
    orr_clock_table t = join(f, 2, &w);
    assert_int_equal(w.count, 0);
    for (size_t i = 0; i < SATS; i++) {
        const orr_clock_list *l = &t.list[i];
        assert_int_equal(l->n, 2 * 97);
        assert_int_equal(l->node[96].t, l->node[97].t);
        assert_int_equal(l->node[97].source, 1);
        ASSERT_NEAR(l->node[97].clock_s - l->node[96].clock_s, 408e-9, 1e-15);
    }
    orr_clock_table_free(&t);
    free_sources(f, 2);
}

// Two files of different centres, steps and scales over the same hours: one gives all, the other only what lies
// before and after, aligned. No second difference shows either.
static void one_file_gives_a_stretch(void **state)
{
    (void)state;
    for (int swap = 0; swap < 2; swap++) {
        orr_clock_source f[2] = {made("a", 0, 43200, 43200, 900, 0),
                                 made("b", 21600, 64800, 64800, 300, 2.84e-9)};
        if (swap) {
            orr_clock_source x = f[0];
            f[0] = f[1], f[1] = x;
        }
        orr_warnings w = {0};
        orr_clock_table t = join(f, 2, &w);
        assert_int_equal(w.count, 1); // told
        assert_non_null(strstr(w.item[0].text, "2.840 ns"));
        for (size_t i = 0; i < SATS; i++) {
            const orr_clock_list *l = &t.list[i];
            assert_int_equal(l->n, 24 + 1 + 145); // 00:00 to 06:00 of a (06:00 twice), the rest of b
            for (size_t k = 0; k < l->n; k++) {
                const double s = orr_time_diff_s(l->node[k].t, at(0));
                ASSERT_NEAR(l->node[k].clock_s, truth(i, (int64_t)s) + 2.84e-9, 1e-15);
            }
        }
        orr_clock_table_free(&t);
        free_sources(f, 2);
        orr_warnings_free(&w);
    }
}

// Ultra-rapids six and twelve hours apart: what was observed holds, then the newest prediction.
static void the_newer_prediction_holds(void **state)
{
    (void)state;
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    orr_clock_table first = {0};
    for (int p = 0; p < 6; p++) {
        const orr_clock_source all[3] = {made("u00", 0, 172800, 86400, 900, 0),
                                         made("u06", 21600, 194400, 108000, 900, 0),
                                         made("u12", 43200, 216000, 129600, 900, 0)};
        orr_clock_source f[3];
        for (int k = 0; k < 3; k++) f[k] = all[order[p][k]];
        orr_clock_table t = join(f, 3, NULL);
        for (size_t i = 0; i < SATS; i++)
            for (size_t k = 0; k < t.list[i].n; k++) {
                const orr_clock_node *c = &t.list[i].node[k];
                const bool late = c->t > at(129600);
                assert_int_equal((c->flags & ORR_EPH_PREDICTED) != 0, late);
                if (k > 0) assert_true(c->t >= c[-1].t && orr_time_diff_s(c->t, c[-1].t) <= 900);
            }
        assert_int_equal(t.list[0].node[t.list[0].n - 1].t, at(216000));
        if (p == 0)
            first = t;
        else {
            assert_same(&first, &t);
            orr_clock_table_free(&t);
        }
        free_sources(f, 3);
    }
    orr_clock_table_free(&first);
}

// Clocks of 30 s of another centre in the place of those of 15 min: aligned to these, which fill an hour's hole.
static void better_clocks_take_the_place(void **state)
{
    (void)state;
    orr_clock_source sp3 = made("sp3", 0, 43200, 43200, 900, 0),
                     clk = made("clk", 0, 43200, 43200, 30, -5e-6);
    for (size_t i = 0; i < SATS; i++) { // 03:00 to 04:00 away
        orr_clock_list *l = &clk.table.list[i];
        size_t n = 0;
        for (size_t k = 0; k < l->n; k++)
            if (l->node[k].t <= at(10800) || l->node[k].t >= at(14400)) l->node[n++] = l->node[k];
        l->n = n;
    }
    orr_warnings w = {0};
    orr_clock_table base = join(&sp3, 1, NULL);
    assert_int_equal(orr_clock_table_replace("clk", GAP, &clk.table, &base, &w), ORR_OK);
    assert_int_equal(w.count, 1);
    for (size_t i = 0; i < SATS; i++) {
        const orr_clock_list *l = &base.list[i];
        assert_int_equal(l->n, 1441 - 119 + 2 + 3); // 03:00 and 04:00 twice
        for (size_t k = 0; k < l->n; k++)
            ASSERT_NEAR(l->node[k].clock_s, truth(i, (int64_t)orr_time_diff_s(l->node[k].t, at(0))), 1e-15);
    }
    orr_clock_table_free(&base);
    free_sources(&sp3, 1);
    free_sources(&clk, 1);
    orr_warnings_free(&w);
}

static double noise(size_t i, int64_t k) { return 1e-10 * orr_rng_normal(7, i, (uint64_t)k); }

// A day of noisy clocks whose reference does what `reference` says.
static orr_clock_table noisy(double (*reference)(int64_t k))
{
    orr_clock_source f = made("x", 0, 86400, 86400, STEP, 0);
    for (size_t i = 0; i < SATS; i++)
        for (size_t k = 0; k < f.table.list[i].n; k++)
            f.table.list[i].node[k].clock_s +=
                noise(i, (int64_t)k) + (reference != NULL ? reference((int64_t)k) : 0);
    return f.table;
}

static double ramp(int64_t k) { return k < 100 ? 0 : k < 200 ? -62e-9 * (double)(k - 100) : -6.2e-6; }
static double step(int64_t k) { return k < 150 ? 0 : 60e-9; }

// All satellites' ramp of eight hours and step of 60 ns are one event each; no node goes, no satellite jumps.
static void the_reference_is_told_once(void **state)
{
    (void)state;
    double (*const what[])(int64_t) = {ramp, step};
    const double size[] = {-6.2e-6, 60e-9};
    const int64_t t0[] = {100, 149}, t1[] = {200, 150};
    for (int r = 0; r < 2; r++)
        for (int remove = 0; remove < 2; remove++) {
            orr_clock_table t = noisy(what[r]), before = noisy(what[r]);
            orr_clock_events e;
            assert_int_equal(orr_clock_judge(GAP, true, remove, &t, &e), ORR_OK);
            assert_int_equal(e.n, 1);
            assert_int_equal(e.item[0].kind, ORR_CLOCK_EVENT_REFERENCE);
            assert_string_equal(e.item[0].systems, "G");
            assert_int_equal(e.item[0].t0, at(t0[r] * STEP));
            assert_int_equal(e.item[0].t1, at(t1[r] * STEP));
            ASSERT_NEAR(e.item[0].value_s, size[r], 2e-9);
            if (!remove) assert_same(&t, &before);
            for (size_t i = 0; i < SATS && remove; i++)
                for (size_t k = 0; k < t.list[i].n; k++)
                    ASSERT_NEAR(t.list[i].node[k].clock_s - noise(i, (int64_t)k) -
                                    truth(i, STEP * (int64_t)k),
                                size[r],
                                2e-9); // as it is after the last step
            orr_clock_table_free(&t);
            orr_clock_table_free(&before);
            free(e.item);
        }
}

// One satellite whose files meet in the middle of a ramp has two nodes there; the ramp stays one event, and all noise
// small.
static void a_joint_of_one_satellite_hides_nothing(void **state)
{
    (void)state;
    orr_clock_table t = noisy(ramp);
    orr_clock_list *l = &t.list[3];
    l->node = realloc(l->node, (l->n + 1) * sizeof *l->node);
    memmove(&l->node[151], &l->node[150], (l->n - 150) * sizeof *l->node);
    l->n++;
    l->node[151].source = 1;
    orr_clock_noise noise_of[SATS];
    assert_int_equal(orr_clock_between_noise(&t, GAP, noise_of), ORR_OK);
    for (size_t i = 0; i < SATS; i++)
        assert_true(between_s2(&noise_of[i], STEP, 0.5) < 3e-10 * 3e-10); // of 0.1 ns a node
    orr_clock_events e;
    assert_int_equal(orr_clock_judge(GAP, true, false, &t, &e), ORR_OK);
    assert_int_equal(e.n, 1);
    ASSERT_NEAR(e.item[0].value_s, -6.2e-6, 2e-9);
    orr_clock_table_free(&t);
    free(e.item);
}

// Of one satellite: a lone error of 50 to 95 ns is left out, a step of so much is a jump, a corner is let be.
static void lone_errors_corners_and_steps_are_told_apart(void **state)
{
    (void)state;
    for (int ns = 50; ns <= 95; ns += 5)
        for (int kind = 0; kind < 3; kind++)
            for (size_t where = 3; where < 280; where += 23) {
                orr_clock_table t = noisy(NULL);
                orr_clock_list *l = &t.list[2];
                const double size = (where % 2 ? 1e-9 : -1e-9) * ns;
                for (size_t k = where; k < l->n; k++)
                    l->node[k].clock_s += kind == 0   ? (k == where ? size : 0)
                                          : kind == 1 ? size
                                                      : size * (double)(k - where);
                orr_clock_events e;
                assert_int_equal(orr_clock_judge(GAP, true, false, &t, &e), ORR_OK);
                const bool shows =
                    kind == 0 || ns > 62; // a jump is seen as half of itself, the limit is 30 ns
                assert_int_equal(l->n, kind == 0 ? 288 : 289);
                if (kind == 2) assert_int_equal(e.n, 0);
                if (kind < 2 && shows) {
                    assert_int_equal(e.n, 1);
                    assert_int_equal(e.item[0].kind,
                                     kind == 0 ? ORR_CLOCK_EVENT_WRONG : ORR_CLOCK_EVENT_JUMP);
                    assert_int_equal(e.item[0].sat, l->sat);
                    assert_int_equal(e.item[0].t1, at(STEP * (int64_t)where));
                    ASSERT_NEAR(e.item[0].value_s, size, 2e-9);
                }
                orr_clock_table_free(&t);
                free(e.item);
            }
}

// Between nodes: through both, of one rate at a node from either side, and never further from the line than the
// corner that is rounded.
static void between_nodes_the_clock_is_smooth(void **state)
{
    (void)state;
    const orr_clock_interval
        a = {.length_s = 900, .clock_s = 1e-6, .rate_sps = 2e-12, .bend_last_sps = 5e-13},
        b = {.length_s = 900, .clock_s = 1e-6 + 1.8e-9, .rate_sps = 3e-12, .bend_first_sps = -5e-13};
    double x, r, y, q;
    orr_clock_interval_at(&a, &(double){1}, &x, &r);
    orr_clock_interval_at(&b, &(double){0}, &y, &q);
    ASSERT_NEAR(x, y, 1e-20);
    ASSERT_NEAR(r, q, 1e-24);
    ASSERT_NEAR(r, 2.5e-12, 1e-24);
    for (double p = 0; p < 1; p += 1.0 / 64) {
        const double h = 1e-5;
        orr_clock_interval_at(&a, &(double){p}, &x, &r);
        orr_clock_interval_at(&a, &(double){p + h}, &y, &q);
        ASSERT_NEAR((y - x) / (900 * h), 0.5 * (r + q), 1e-16); // the rate is the derivative, without steps
        ASSERT_NEAR(x, a.clock_s + a.rate_sps * 900 * p, 5e-13 * 225 * 4 / 27 + 1e-20);
    }
}

// Made clocks of each kind of noise, thinned to every third node: the sigma between the nodes is what the clock left
// out is off, from both sides.
static void sigma_is_what_nodes_left_out_are_off(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        orr_clock_source f = made("x", 0, 4 * 86400, 4 * 86400, STEP, 0);
        orr_clock_table thin = {.n = SATS, .list = calloc(SATS, sizeof *thin.list)};
        for (size_t i = 0; i < SATS; i++) {
            orr_clock_list *l = &f.table.list[i], *m = &thin.list[i];
            *m = (orr_clock_list){.sat = l->sat, .node = calloc(l->n, sizeof *m->node)};
            double walk = 0, rate = 0, white = orr_rng_normal(10, i, 0);
            for (size_t k = 0; k < l->n; k++) {
                const double z = orr_rng_normal(11 + (uint64_t)kind, i, k);
                if (kind == 1) walk += 2e-11 * z;
                if (kind == 2) walk += 300 * (rate += 1e-14 * z);
                white = 0.25 * white + sqrt(1 - 0.25 * 0.25) * z; // of minutes: a quarter is left after 300 s
                l->node[k].clock_s += kind == 0 ? 1e-10 * white : walk;
                if (k % 3 == 0) m->node[m->n++] = l->node[k];
            }
        }
        orr_clock_noise noise[SATS];
        assert_int_equal(orr_clock_between_noise(&thin, GAP, noise), ORR_OK);
        for (size_t i = 0; i < SATS; i++) // not by rounding either: a product with negative noise is refused
            assert_true(noise[i].white_s2 >= 0 && noise[i].wfm_s2ps >= 0 && noise[i].rwfm_s2ps3 >= 0);
        double sum = 0;
        size_t n = 0;
        for (size_t i = 0; i < SATS; i++)
            for (size_t k = 0; k + 3 < f.table.list[i].n; k += 3)
                for (size_t j = 1; j < 3; j++) {
                    const orr_clock_node *c = &f.table.list[i].node[k];
                    const double p = (double)j / 3, line = c[0].clock_s + p * (c[3].clock_s - c[0].clock_s);
                    sum += (c[j].clock_s - line) * (c[j].clock_s - line) / between_s2(&noise[i], 900, p);
                    n++;
                }
        print_message("kind %d: error/sigma %.2f\n", kind, sqrt(sum / (double)n));
        assert_true(sqrt(sum / (double)n) > 0.85 && sqrt(sum / (double)n) < 1.2);
        orr_clock_table_free(&thin);
        free_sources(&f, 1);
    }
    ASSERT_NEAR(between_s2(&(orr_clock_noise){1, 1, 1}, 900, 0), 0, 0); // a node is what it is
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(days_that_meet_keep_both_values),
                                       cmocka_unit_test(one_file_gives_a_stretch),
                                       cmocka_unit_test(the_newer_prediction_holds),
                                       cmocka_unit_test(better_clocks_take_the_place),
                                       cmocka_unit_test(the_reference_is_told_once),
                                       cmocka_unit_test(a_joint_of_one_satellite_hides_nothing),
                                       cmocka_unit_test(lone_errors_corners_and_steps_are_told_apart),
                                       cmocka_unit_test(between_nodes_the_clock_is_smooth),
                                       cmocka_unit_test(sigma_is_what_nodes_left_out_are_off)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

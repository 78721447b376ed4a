// SPDX-License-Identifier: GPL-3.0-or-later
// Real days with errors put into their nodes, at random in size, direction and place: what is found, what good nodes
// are rejected with it, and how far orbits move, those of the satellites beside it too. ORRERY_TRIALS=N repeats each
// line of the table N times with other errors.
#include "testing.h"

#include <stdlib.h>

#include "real_orbit.h"

typedef enum place { FIRST, LAST, INNER, FIRST_TWO, LAST_TWO, NEIGHBOURS, PLACES } place;
static const char *const place_name[PLACES] = {"first",     "last",     "inner",
                                               "first two", "last two", "two neighbours"};

static uint64_t state_of_rng;
static double uniform(void) // splitmix64
{
    uint64_t z = state_of_rng += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static orr_vec3 direction(void)
{
    for (;;) {
        const orr_vec3 v = {2 * uniform() - 1, 2 * uniform() - 1, 2 * uniform() - 1};
        const double n = orr_vec3_norm(v);
        if (n > 0.1 && n < 1) return orr_vec3_scale(1 / n, v);
    }
}

typedef struct fault { // of one satellite
    size_t n;
    orr_time t[2];
} fault;

typedef struct outcome {
    size_t faults, found, extra, pushes; // nodes; extra: good ones rejected
    double moved_m, others_m; // of orbits against those of the clean file: with errors, and without
} outcome;

static void smooth(real_files *f, const orr_smoother_options *o, orr_orbit_solution *s)
{
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(f->input, f->n, o, NULL, NULL, s, NULL, NULL, &d), d);
}

static const orr_orbit_sat *find(const orr_orbit_solution *s, orr_sat sat)
{
    for (size_t i = 0; i < s->n_sats; i++)
        if (s->sat[i].sat == sat) return &s->sat[i];
    return NULL;
}

static double distance(const orr_orbit_sat *a, const orr_orbit_sat *b)
{
    double largest = 0;
    for (size_t k = 0; k < a->n_arcs; k++)
        for (size_t m = 0; m < a->arc[k].n; m++)
            for (size_t j = 0; j < b->n_arcs; j++) {
                const orr_orbit_arc *p = &a->arc[k], *q = &b->arc[j];
                const double x = orr_time_diff_s(orr_time_add_s(p->t0, p->step_s * (double)m), q->t0) /
                                 q->step_s,
                             r = round(x);
                if (r < 0 || r >= (double)q->n || fabs(x - r) > 1e-9) continue;
                const orr_vec3 d = orr_vec3_sub(p->sample[m].pos_m, q->sample[(size_t)r].pos_m);
                largest = fmax(largest, orr_vec3_norm(d));
            }
    return largest;
}

// Epochs of a satellite that are nodes.
static size_t nodes_of(const orr_sp3 *s, size_t sat, double step_s, size_t *epoch)
{
    size_t n = 0;
    for (size_t e = 0; e < s->n_epochs; e++) {
        const double x = orr_time_diff_s(s->epoch[e], s->epoch[0]) / step_s;
        if (fabs(x - round(x)) < 1e-9 && isfinite(s->record[e * s->n_sats + sat].pos_m[0])) epoch[n++] = e;
    }
    return n;
}

// Errors of one size in a quarter of the satellites; half of those of two nodes are alike.
static void spoil(orr_sp3 *s, double step_s, place where, double size_m, fault *out)
{
    size_t *epoch = malloc(s->n_epochs * sizeof *epoch);
    assert_non_null(epoch);
    for (size_t k = 0; k < s->n_sats; k++) {
        const size_t n = nodes_of(s, k, step_s, epoch);
        out[k] = (fault){0};
        if (uniform() > 0.25 || n < 8) continue;
        const bool alike = uniform() < 0.5;
        const size_t first = where == FIRST || where == FIRST_TWO ? 0
                             : where == LAST                      ? n - 1
                             : where == LAST_TWO                  ? n - 2
                                                                  : 2 + (size_t)(uniform() * (double)(n - 5));
        orr_vec3 d = orr_vec3_scale(size_m, direction());
        out[k].n = where >= FIRST_TWO ? 2 : 1;
        for (size_t i = 0; i < out[k].n; i++) {
            double *p = s->record[epoch[first + i] * s->n_sats + k].pos_m;
            out[k].t[i] = s->epoch[epoch[first + i]];
            p[0] += d.x, p[1] += d.y, p[2] += d.z;
            if (!alike) d = orr_vec3_scale(size_m, direction());
        }
    }
    free(epoch);
}

static size_t count_pushes(const orr_orbit_sat *q)
{
    size_t n = 0;
    for (size_t i = 0; i < q->n_events; i++) n += q->event[i].kind == ORR_EVENT_MANOEUVRE;
    return n;
}

static void judge(const orr_sp3 *f, const fault *x, const orr_orbit_solution *clean,
                  const orr_orbit_solution *s, outcome *o)
{
    for (size_t k = 0; k < f->n_sats; k++) {
        const orr_orbit_sat *c = find(clean, f->sat[k]), *q = find(s, f->sat[k]);
        if (c == NULL) continue;
        assert_non_null(q); // no satellite is lost by them
        for (size_t i = 0; i < q->n_nodes; i++) {
            bool bad = false;
            for (size_t j = 0; j < x[k].n; j++) bad = bad || x[k].t[j] == q->node[i].t;
            o->faults += bad;
            o->found += bad && !q->node[i].used;
            o->extra += !bad && !q->node[i].used && c->node[i].used;
        }
        o->pushes += count_pushes(q) - count_pushes(c);
        double *largest = x[k].n > 0 ? &o->moved_m : &o->others_m;
        *largest = fmax(*largest, distance(q, c));
    }
}

static outcome trial(real_files *f, const orr_smoother_options *o, const orr_orbit_solution *clean,
                     place where, double size_m)
{
    orr_sp3 *s = &f->sp3[0];
    const size_t bytes = s->n_epochs * s->n_sats * sizeof *s->record;
    orr_sp3_record *kept = malloc(bytes);
    fault *x = calloc(s->n_sats, sizeof *x);
    outcome all = {0};
    assert_true(kept != NULL && x != NULL);
    memcpy(kept, s->record, bytes);
    const int trials = getenv("ORRERY_TRIALS") != NULL ? atoi(getenv("ORRERY_TRIALS")) : 1;
    for (int n = 0; n < trials; n++) {
        orr_orbit_solution q;
        spoil(s, o->node_step_s, where, size_m, x);
        smooth(f, o, &q);
        judge(s, x, clean, &q, &all);
        orr_orbit_solution_free(&q);
        memcpy(s->record, kept, bytes);
    }
    free(kept);
    free(x);
    print_message(
        "%6.0f s  %-14s %7.2f m: %3zu of %3zu found, %zu good ones rejected, %zu pushes, orbits moved by "
        "%.4f m, others by %.4f m\n",
        o->node_step_s, place_name[where], size_m, all.found, all.faults, all.extra, all.pushes, all.moved_m,
        all.others_m);
    return all;
}

static const char *const day[] = {"2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"};

// Errors of these sizes are found wherever they are, no good node is rejected with them, and satellites beside them do
// not feel it: the rotation that all are fitted with holds.
static void errors_are_found_wherever_they_are(void **state)
{
    (void)state;
    static const struct {
        double step_s, size_m, moved_m;
    } line[] = {{900, 1, 0.05}, {3600, 10, 0.2}, {7200, 1000, 0.5}};
    real_files f;
    orr_sat_set few;
    orr_diag d = {0};
    if (!real_open(day, 1, &f)) SKIP_NO_DATA(day[0]);
    ASSERT_OK(orr_sat_set_parse("G01-G08,R01-R05,E01-E05", &few, &d), d);
    state_of_rng = 20240204;
    for (size_t i = 0; i < sizeof line / sizeof line[0]; i++) {
        orr_smoother_options o = orr_smoother_defaults();
        orr_orbit_solution clean;
        o.node_step_s = line[i].step_s;
        if (getenv("ORRERY_TRIALS") == NULL) o.sats = &few;
        smooth(&f, &o, &clean);
        for (int where = 0; where < PLACES; where++) {
            const outcome x = trial(&f, &o, &clean, (place)where, line[i].size_m);
            assert_true(x.faults > 0);
            assert_int_equal(x.found, x.faults);
            assert_int_equal(x.extra + x.pushes, 0);
            ASSERT_NEAR(x.moved_m, 0, line[i].moved_m);
            ASSERT_NEAR(x.others_m, 0, 0.01);
        }
        orr_orbit_solution_free(&clean);
    }
    real_close(&f);
}

// Two neighbours of 13 that are a kilometre off, alike and not: the good node beside them looks worst, and without the wrong
// ones it is what holds the orbit. No satellite is lost by it.
static void two_of_thirteen_do_not_hide_the_others(void **state)
{
    (void)state;
    static const struct {
        const char *sat;
        int hour;
        orr_vec3 off_m[2];
    } bad[] = {{"G02", 18, {{855.560, 431.972, 285.338}, {855.560, 431.972, 285.338}}},
               {"G03", 14, {{-569.935, -474.941, 670.526}, {332.436, 498.887, -800.374}}},
               {"E25", 18, {{645.768, -748.162, 152.434}, {645.768, -748.162, 152.434}}}};
    real_files f;
    orr_sat_set few;
    orr_diag d = {0};
    if (!real_open(day, 1, &f)) SKIP_NO_DATA(day[0]);
    ASSERT_OK(orr_sat_set_parse("G01-G08,R01-R04,E01-E03,E25", &few, &d), d);
    orr_smoother_options o = orr_smoother_defaults();
    orr_orbit_solution s;
    orr_sp3 *p = &f.sp3[0];
    o.node_step_s = 7200;
    o.sats = &few;
    for (size_t i = 0; i < 3; i++) {
        const orr_sat sat = orr_sat_parse(bad[i].sat);
        for (size_t k = 0; k < p->n_sats; k++)
            for (int j = 0; j < 2 && p->sat[k] == sat; j++) {
                double *r = p->record[(size_t)(12 * bad[i].hour + 24 * j) * p->n_sats + k].pos_m;
                r[0] += bad[i].off_m[j].x, r[1] += bad[i].off_m[j].y, r[2] += bad[i].off_m[j].z;
            }
    }
    smooth(&f, &o, &s);
    for (size_t i = 0; i < s.n_sats; i++) {
        size_t rejected = 0;
        char name[ORR_SAT_TEXT];
        orr_sat_text(s.sat[i].sat, name);
        for (size_t k = 0; k < s.sat[i].n_nodes; k++) rejected += !s.sat[i].node[k].used;
        assert_int_equal(
            rejected,
            strcmp(name, "G02") == 0 || strcmp(name, "G03") == 0 || strcmp(name, "E25") == 0 ? 2 : 0);
    }
    assert_int_equal(s.n_sats, 8 + 4 + 3); // there was no E01
    orr_orbit_solution_free(&s);
    real_close(&f);
}

// The table of docs/orbit.md: what is found at which size; only with ORRERY_TRIALS, because it takes minutes.
static void sizes_that_are_found(void **state)
{
    (void)state;
    const double step_s[] = {900, 1800, 3600, 7200}, size_m[] = {0.2, 1, 10};
    const place where[] = {INNER, FIRST, FIRST_TWO};
    real_files f;
    if (getenv("ORRERY_TRIALS") == NULL) return;
    if (!real_open(day, 1, &f)) SKIP_NO_DATA(day[0]);
    state_of_rng = 35;
    for (int i = 0; i < 4; i++) {
        orr_smoother_options o = orr_smoother_defaults();
        orr_orbit_solution clean;
        o.node_step_s = step_s[i];
        smooth(&f, &o, &clean);
        for (int k = 0; k < 3; k++)
            for (int m = 0; m < 3; m++) assert_true(trial(&f, &o, &clean, where[k], size_m[m]).faults > 0);
        orr_orbit_solution_free(&clean);
    }
    real_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(errors_are_found_wherever_they_are),
                                       cmocka_unit_test(two_of_thirteen_do_not_hide_the_others),
                                       cmocka_unit_test(sizes_that_are_found)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

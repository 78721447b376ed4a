// SPDX-License-Identifier: GPL-3.0-or-later
// A low orbit: Stella, 800 km high, every three minutes for four days. The field beyond what GNSS orbits feel, drag, and
// a random walk whose size the nodes tell. Every second node is left out and judges.
#include "testing.h"

#include "orbit/ephemeris/ephemeris.h"
#include "real_orbit.h"

static const char *const stella[] = {"odd/sp3/nsgf.orb.stella.v00.sp3.gz"};

static double rms_of_left_out(const orr_ephemeris *e, const orr_sp3 *f, double step_s, size_t *n)
{
    double sum = 0;
    *n = 0;
    for (size_t k = 0; k < f->n_epochs; k++) {
        const double x = orr_time_diff_s(f->epoch[k], f->epoch[0]) / step_s;
        orr_sat_state s;
        if (fabs(x - round(x)) < 1e-9 || orr_ephemeris_eval(e, f->sat[0], f->epoch[k], &s) != ORR_OK)
            continue;
        const double *p = f->record[k * f->n_sats].pos_m;
        const orr_vec3 d = orr_vec3_sub(s.pos_m, (orr_vec3){p[0], p[1], p[2]});
        sum += orr_vec3_dot(d, d);
        ++*n;
    }
    return sqrt(sum / (double)*n);
}

static void smooth(const real_files *f, double step_s, orr_smoother_report *report, orr_ephemeris **e)
{
    orr_smoother_options o = orr_smoother_defaults();
    orr_orbit_solution s;
    orr_diag d = {0};
    o.node_step_s = step_s;
    ASSERT_OK(orr_smoother_run(f->input, 1, &o, NULL, NULL, &s, report, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, e, &d), d);
    orr_orbit_solution_free(&s);
}

static void nodes_are_met_and_so_are_those_left_out(void **state)
{
    (void)state;
    // 0.56 and 0.65 m with a field of degree 8 and the random walk of GNSS orbits
    const double step_s[] = {180, 360}, bar_m[] = {0.02, 0.05};
    real_files f;
    if (!real_open(stella, 1, &f)) SKIP_NO_DATA(stella[0]);
    for (int k = 0; k < 2; k++) {
        orr_smoother_report r;
        orr_ephemeris *e = NULL;
        size_t n = 0;
        smooth(&f, step_s[k], &r, &e);
        assert_int_equal(r.nodes_rejected + r.manoeuvres, 0);
        print_message("nodes every %.0f s: met to %.4f m", step_s[k], r.residual_rms_m);
        ASSERT_NEAR(r.residual_rms_m, 0, bar_m[k]);
        const double rms_m = k > 0 ? rms_of_left_out(e, &f.sp3[0], step_s[k], &n) : 0;
        if (k > 0) {
            print_message("; %zu left out, to %.4f m", n, rms_m);
            assert_true(n > 800);
            ASSERT_NEAR(rms_m, 0, bar_m[k]);
        }
        print_message("\n");
        orr_ephemeris_free(e);
    }
    real_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nodes_are_met_and_so_are_those_left_out)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

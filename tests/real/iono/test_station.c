// SPDX-License-Identifier: GPL-3.0-or-later
// A mid-latitude station at solar maximum, all day: both methods of fusion against the model, against codes that they did
// not use, and against arcs that they did not see.
#include "station_day.h"

static void show(const orr_fusion *f, const orr_phase_tec *p)
{
    size_t slips = 0, repaired = 0, steps = 0;
    for (size_t s = 0; s < p->n_sats; s++)
        for (size_t k = 0; k < p->sat[s].arcs.n_slips; k++) {
            slips++;
            repaired += p->sat[s].arcs.slip[k].verdict == ORR_SLIP_REPAIRED;
            steps += (p->sat[s].arcs.slip[k].causes & ORR_SLIP_STEP) != 0;
        }
    print_message("%s: %zu satellites, %zu arcs (%zu slips, %zu repaired, %zu steps), %zu samples: RMS %.3f TECU, against the "
                  "model %.3f; Galileo codes %s: std %.3f TECU over %zu arcs; unit sigma %.3f, inflation %.1f\n",
                  orr_fusion_method_name(f->method), p->n_sats, f->n_arcs, slips, repaired, steps, f->n_samples,
                  f->residual_tecu, f->model_residual_tecu, f->galileo_withheld ? "withheld" : "used", f->galileo_std_tecu,
                  f->galileo_n, f->unit_sigma, f->inflation);
    for (size_t b = 0; b < f->n_band; b++)
        if (f->band[b].n > 0)
            print_message("  %2.0f-%2.0f deg %6zu samples RMS %.3f TECU\n", f->band[b].from_deg, f->band[b].to_deg, f->band[b].n,
                          f->band[b].rms_tecu);
    for (size_t g = 0; g < f->n_groups; g++)
        print_message("  receiver %c %s-%s: %.2f +- %.2f TECU\n", f->group[g].system, f->group[g].range[0], f->group[g].range[1],
                      f->group[g].receiver_tecu, f->group[g].sigma_tecu);
}

static void test_thesis(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    orr_fusion_options o = orr_fusion_default_options();
    o.method = ORR_FUSION_THESIS;
    orr_fusion f;
    orr_diag d = {0};
    ASSERT_OK(orr_fuse(&day->phase, day->field, &day->biases, 1, &o, &f, &d), d);
    show(&f, &day->phase);
    assert_true(f.residual_tecu <= 2.2);
    orr_fusion_free(&f, &day->phase);
}

static void test_joint(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    orr_fusion_options o = orr_fusion_default_options();
    orr_diag d = {0};
    orr_fusion f;
    ASSERT_OK(orr_fuse(&day->phase, day->field, &day->biases, 1, &o, &f, &d), d);
    show(&f, &day->phase);
    assert_true(f.residual_tecu <= 1.0);
    assert_true(f.galileo_withheld && f.galileo_n > 20);
    assert_true(f.galileo_std_tecu <= 1.5);
    orr_fusion_free(&f, &day->phase);
}

static void test_leave_one_out(void **state)
{
    station_day *day = *state;
    if (day == NULL) SKIP_NO_DATA(DAY_OBS);
    orr_leave_out l;
    orr_diag d = {0};
    ASSERT_OK(orr_fusion_leave_one_out(&day->phase, day->field, &day->biases, 1, NULL, 3600, &l, &d), d);
    print_message("leave one arc out, %zu arcs: corrected %.3f TECU, plain field %.3f TECU\n", l.n_arcs, l.corrected_tecu,
                  l.plain_tecu);
    for (int b = 0; b < ORR_FUSION_BANDS; b++)
        if (l.band[b].n > 0)
            print_message("  %2.0f-%2.0f deg %6zu samples: corrected %.3f, plain %.3f\n", l.band[b].from_deg, l.band[b].to_deg,
                          l.band[b].n, l.band[b].corrected_tecu, l.band[b].plain_tecu);
    assert_true(l.corrected_tecu < l.plain_tecu);
}

static int setup(void **state)
{
    static station_day day;
    *state = station_day_read(&day) ? &day : NULL;
    return 0;
}

static int teardown(void **state)
{
    if (*state != NULL) station_day_free(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_thesis), cmocka_unit_test(test_joint),
                                       cmocka_unit_test(test_leave_one_out)};
    return cmocka_run_group_tests(tests, setup, teardown);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Fig. 10 of Bogdanov 2015: two receivers 3.7 km apart see the same curve. No orbit is needed: centred
// geometry-free phases of the same satellite and arc, epochs within 0.1 s (their clocks drift by
// milliseconds).
#include "iono/phase/phase_tec.h"
#include "read_file.h"
#include "testing.h"

#define A "2005-092-pair/07590920.05o.gz"
#define B "2005-092-pair/30400920.05o.gz"

static void test_pair(void **state)
{
    (void)state;
    char a[512], b[512];
    if (!orr_test_data(A, a, sizeof a) || !orr_test_data(B, b, sizeof b)) SKIP_NO_DATA(A);
    orr_phase_tec p, q;
    orr_diag d = {0};
    ASSERT_OK(read_phases(a, NULL, &p, &d), d);
    ASSERT_OK(read_phases(b, NULL, &q, &d), d);
    orr_curves c;
    ASSERT_OK(orr_phase_compare(&p, &q, 0.1, 20, &c, &d), d);
    double swing = 0;
    for (size_t i = 0; i < c.n_curves; i++) {
        char text[ORR_SAT_TEXT];
        double low = 1e9, high = -1e9;
        for (size_t k = c.curve[i].first; k < c.curve[i].first + c.curve[i].n; k++) {
            low = fmin(low, c.point[k].a_tecu);
            high = fmax(high, c.point[k].a_tecu);
        }
        swing = fmax(swing, high - low);
        print_message("%s %3zu epochs, swing %5.2f TECU, RMS difference %.4f TECU\n",
                      orr_sat_text(c.curve[i].sat, text), c.curve[i].n, high - low, c.curve[i].rms_tecu);
    }
    print_message("baseline %.0f m, %zu curves, pooled RMS %.4f TECU\n", c.baseline_m, c.n_curves,
                  c.rms_tecu);
    assert_true(c.n_curves >= 6);
    assert_true(c.n_points >= 500);
    assert_true(swing > 1); // there is something to agree on
    assert_true(c.rms_tecu <= 0.08);
    ASSERT_NEAR(c.baseline_m, 3500, 400); // headers know the places to some hundred metres
    orr_curves_free(&c);
    assert_int_equal(orr_phase_compare(&p, &q, 0.1, 5000, &c, &d), ORR_E_NODATA);
    assert_non_null(strstr(d.text, "common arc"));
    orr_phase_tec_free(&p);
    orr_phase_tec_free(&q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pair)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

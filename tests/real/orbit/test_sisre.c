// SPDX-License-Identifier: GPL-3.0-or-later
// Broadcast against precise orbits on published files: values every study of them finds, per system.
#include "testing.h"

#include "orbit/sisre.h"

typedef struct judged {
    orr_sisre_sum sum[ORR_N_SYSTEMS];
} judged;

static bool judge(const char *nav_name, const char *sp3_name, const char *antex_name, double max_age_s,
                  judged *out)
{
    char nav_path[512], sp3_path[512], antex_path[512];
    if (!orr_test_data(nav_name, nav_path, sizeof nav_path) ||
        !orr_test_data(sp3_name, sp3_path, sizeof sp3_path))
        return false;
    orr_nav nav;
    orr_sp3 sp3;
    orr_antex antex;
    orr_diag d = {0};
    orr_sisre_options o = {.choice = orr_broadcast_choice_default()};
    o.choice.max_age_s = max_age_s;
    ASSERT_OK(orr_nav_read(nav_path, NULL, &nav, NULL, &d), d);
    ASSERT_OK(orr_sp3_read(sp3_path, NULL, &sp3, NULL, &d), d);
    if (antex_name != NULL && orr_test_data(antex_name, antex_path, sizeof antex_path)) {
        ASSERT_OK(orr_antex_read(antex_path, NULL, &antex, NULL, &d), d);
        o.antex = &antex;
    }
    orr_sisre_sample *s = NULL;
    size_t n = 0;
    ASSERT_OK(orr_sisre_run(&nav, &sp3, &o, &s, &n, out->sum, &d), d);
    free(s);
    orr_nav_free(&nav);
    orr_sp3_free(&sp3);
    if (o.antex != NULL) orr_antex_free(&antex);
    return true;
}

#define G 0
#define R 1
#define E 2
#define C 3

// GPS in 2010: about a metre radially, 1.5 m along, clocks of the older blocks at a metre (Montenbruck et al.
// 2015 give 0.7 m SISRE for 2013-14; the decade before was about 1 m).
static void gps_of_2010(void **state)
{
    (void)state;
    judged j;
    if (!judge("2010-182/brdc1820.10n.gz", "2010-182/igs15904.sp3.gz", "antex/igs05.atx.gz", 0, &j))
        SKIP_NO_DATA("2010-182");
    assert_true(j.sum[G].n_sats >= 30 && j.sum[G].n > 2800);
    assert_true(j.sum[G].antex);
    assert_true(j.sum[G].orbit_3d_m > 1.0 && j.sum[G].orbit_3d_m < 2.5);
    assert_true(j.sum[G].sisre_m < 1.5);
    // Each satellite's antenna is known, and accounting for it must bring the ranging error down.
    judged without;
    assert_true(judge("2010-182/brdc1820.10n.gz", "2010-182/igs15904.sp3.gz", NULL, 0, &without));
    assert_true(without.sum[G].sisre_m > 1.1 * j.sum[G].sisre_m);
}

static void glonass_of_2009(void **state)
{
    (void)state;
    judged j;
    if (!judge("2009-091-glonass/brdc0910.09g.gz", "2009-091-glonass/esa15253.sp3.gz", "antex/igs05.atx.gz",
               0, &j))
        SKIP_NO_DATA("2009-091-glonass");
    assert_true(j.sum[R].n_sats >= 18 && j.sum[R].n > 1600);
    assert_true(j.sum[R].radial_m < 1.0); // the frame and the antenna (2.4 m along the radius) are handled
    assert_true(j.sum[R].orbit_3d_m < 8);
}

static void four_systems_of_2020(void **state)
{
    (void)state;
    judged j;
    if (!judge("2020-177/ESBC00DNK_R_20201770000_01D_MN.rnx.gz", "2020-177/Sta21114.sp3.gz", NULL, 3600, &j))
        SKIP_NO_DATA("2020-177");
    assert_true(j.sum[G].orbit_3d_m < 2.2);
    assert_true(j.sum[E].orbit_3d_m < 1.5 && j.sum[E].clock_m < 0.3); // the antenna, 0.8 m, is still in it
    assert_true(j.sum[R].orbit_3d_m < 5);
    assert_true(j.sum[C].radial_m < 2);
}

static void gps_of_2024(void **state)
{
    (void)state;
    judged j;
    if (!judge("2024-035/BRDC00CNE_R_20240350000_01D_GN.rnx.gz",
               "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz", NULL, 0, &j))
        SKIP_NO_DATA("2024-035");
    assert_true(j.sum[G].n_sats >= 30);
    assert_true(j.sum[G].along_m < 1.5 && j.sum[G].cross_m < 1.0 && j.sum[G].clock_m < 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gps_of_2010),
        cmocka_unit_test(glonass_of_2009),
        cmocka_unit_test(four_systems_of_2020),
        cmocka_unit_test(gps_of_2024),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver of one frequency is left with when it corrects by coefficients fitted to the simulated ionosphere: at places and
// hours other than those of the fit.
#include "testing.h"

#include "iono/broadcast/bdgim.h"
#include "iono/broadcast/klobuchar.h"
#include "iono/field/tec_files.h"
#include "src/make/broadcast_iono.h"

static const char maps[] = "2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz";

static orr_time when(const char *text)
{
    orr_time t;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &d), d);
    return t;
}

static double model_tecu(const orr_nav_iono *r, const orr_nequick *tables, orr_time t, double lat, double lon)
{
    orr_klobuchar k;
    const orr_geodetic low = {lat, lon, 0}, high = {lat, lon, 20.2e6};
    memcpy(k.alpha, r->coefficient, sizeof k.alpha);
    memcpy(k.beta, r->coefficient + 4, sizeof k.beta);
    const double l1 = 1575.42e6, b1 = 1561.098e6;
    if (r->kind == ORR_NAV_NEQUICK_G)
        return orr_nequick_slant_tecu(tables, r->coefficient, t, NULL, low, high);
    if (r->kind == ORR_NAV_BDGIM) return orr_bdgim_vertical_tecu(r->coefficient, t, lat, lon);
    return r->system == 'G' ? orr_klobuchar_vertical_m(&k, t, lat, lon) * l1 * l1 / 40.3e16
                            : orr_klobuchar_beidou_vertical_m(&k, t, lat, lon) * b1 * b1 / 40.3e16;
}

static void half_of_the_delay_is_left(void **state)
{
    (void)state;
    char path[512], folder[512];
    if (!orr_test_data(maps, path, sizeof path) ||
        !orr_test_data("nequick/modip.asc.gz", folder, sizeof folder))
        SKIP_NO_DATA(maps);
    *strrchr(folder, '/') = '\0';
    orr_tec_field *field;
    orr_nequick *tables;
    orr_nav_iono record[ORR_BROADCAST_IONO_MODELS];
    size_t n;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_open(path, NULL, &field, NULL, &d), d);
    ASSERT_OK(orr_nequick_load(folder, &tables, &d), d);
    const orr_time from = when("2024-02-04T00:00:00"), to = when("2024-02-05T00:00:00");
    ASSERT_OK(orr_broadcast_iono_fit(field, from, to, tables, NULL, record, &n, &d), d);
    assert_int_equal(n, 4);
    static orr_tec_instant at;
    double sum[4] = {0}, all = 0;
    for (int h = 1; h < 24; h += 4) {
        const orr_time t = from + (h * 3600 + 1800) * ORR_NS_PER_S;
        ASSERT_OK(orr_tec_field_at(field, t, &at, &d), d);
        for (int i = -66; i <= 66; i += 11)
            for (int j = -170; j < 180; j += 35) {
                const double lat = i * ORR_RAD_PER_DEG, lon = j * ORR_RAD_PER_DEG;
                orr_tec_value v;
                ASSERT_OK(orr_tec_vertical(
                              &at, orr_vec3_make(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)), &v, &d),
                          d);
                all += cos(lat) * v.vtec_tecu * v.vtec_tecu;
                for (size_t k = 0; k < n; k++) {
                    const double left = v.vtec_tecu - model_tecu(&record[k], tables, t, lat, lon);
                    sum[k] += cos(lat) * left * left;
                }
            }
    }
    static const char *const name[] = {"Klobuchar of GPS", "Klobuchar of BeiDou", "BDGIM", "NeQuick-G"};
    for (size_t k = 0; k < n; k++) {
        print_message("%-20s leaves %.0f %% of the vertical delay (RMS)\n", name[k],
                      100 * sqrt(sum[k] / all));
        assert_true(sqrt(sum[k] / all) < 0.5);
    }
    orr_nequick_free(tables);
    orr_tec_field_free(field);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(half_of_the_delay_is_left)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

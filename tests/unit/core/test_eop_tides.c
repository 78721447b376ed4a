// SPDX-License-Identifier: GPL-3.0-or-later
// Tides of the Earth's rotation against the tables of the IERS Conventions themselves, read and summed again.
#include "testing.h"

#include <math.h>
#include <stdlib.h>

#include "core/eop_tides.h"

#define TURN (2 * 3.14159265358979323846)

// Arguments by the polynomials of the conventions (5.43), degrees, good to an arcsecond over some decades;
// GMST by its linear part.
static void arguments(double mjd_tt, double mjd_ut, double a[6])
{
    const double T = (mjd_tt - 51544.5) / 36525, days = mjd_ut - 51544.5;
    a[0] = fmod(280.46061837 + 360.98564736629 * days, 360) + 0.000387933 * T * T + 180;
    a[1] = 134.96340251 + 477198.8675605 * T + 0.0088553 * T * T;
    a[2] = 357.52910918 + 35999.0502911 * T - 0.0001537 * T * T;
    a[3] = 93.27209062 + 483202.0174577 * T - 0.0035420 * T * T;
    a[4] = 297.85019547 + 445267.1114469 * T - 0.0017696 * T * T;
    a[5] = 125.04455501 - 1934.1362891 * T + 0.0020756 * T * T;
    for (int i = 0; i < 6; i++) a[i] *= TURN / 360;
}

static FILE *table(const char *name)
{
    char path[512];
    return orr_test_data(name, path, sizeof path) ? fopen(path, "r") : NULL;
}

// The numbers at the end of a line that has a Doodson number; how many there are.
static int numbers(const char *line, double out[16])
{
    const char *p = line;
    int n = 0;
    while (*p != '\0' && !(*p == ' ' && (p[1] == '1' || p[1] == '2' || p[1] == '-' || p[1] == ' ')))
        p++; // the name
    while (n < 16) {
        char *end;
        out[n] = strtod(p, &end);
        if (end == p) break;
        p = end;
        n++;
    }
    return n;
}

static void ocean_tides_are_the_tables_sum(void **state)
{
    (void)state;
    static const char *const instant[] = {"2008-10-05T03:00", "2024-02-04T17:20", "2026-07-01"};
    for (int k = 0; k < 3; k++) {
        orr_time t;
        orr_diag d = {0};
        ASSERT_OK(orr_time_parse(instant[k], NULL, &t, &d), d);
        int32_t day;
        double f, tt, a[6], x = 0, y = 0, ut1 = 0;
        orr_time_mjd(t, ORR_SCALE_TT, NULL, &day, &f);
        tt = day + f;
        orr_time_mjd(t, ORR_SCALE_UTC, NULL, &day, &f);
        arguments(tt, day + f, a);
        int rows[2] = {0};
        for (int which = 0; which < 2; which++) {
            FILE *in = table(which ? "iers2010/tab8.3ab.txt" : "iers2010/tab8.2ab.txt");
            if (in == NULL) SKIP_NO_DATA("iers2010");
            for (char line[512]; fgets(line, sizeof line, in) != NULL;) {
                double v[16], angle = 0;
                if (strstr(line, ".") == NULL || numbers(line, v) < (which ? 10 : 12)) continue;
                for (int i = 0; i < 6; i++) angle += v[i] * a[i];
                rows[which]++;
                if (which) {
                    ut1 += v[8] * sin(angle) + v[9] * cos(angle);
                } else {
                    x += v[8] * sin(angle) + v[9] * cos(angle);
                    y += v[10] * sin(angle) + v[11] * cos(angle);
                }
            }
            fclose(in);
        }
        assert_int_equal(rows[0], 71);
        assert_int_equal(rows[1], 71);
        const orr_eop_tides mine = orr_eop_tides_subdaily(t);
        const double uas = TURN / 1296000 * 1e-6; // arguments differ by some 1e-5 of a turn
        ASSERT_NEAR(mine.xp_rad / uas, x, 0.05);
        ASSERT_NEAR(mine.yp_rad / uas, y, 0.05);
        ASSERT_NEAR(mine.ut1_s * 1e6, ut1, 0.01);
    }
}

static void zonal_tides_are_the_tables_sum(void **state)
{
    (void)state;
    for (int k = 0; k < 5; k++) {
        FILE *in = table("iers2010/tab8.1-below-35d.txt");
        if (in == NULL) SKIP_NO_DATA("iers2010");
        orr_time t;
        orr_diag d = {0};
        ASSERT_OK(orr_time_parse("2024-02-04", NULL, &t, &d), d);
        t = orr_time_add_s(t, 3.3 * 86400 * k);
        int32_t day;
        double f, a[6], sum = 0;
        int rows = 0;
        orr_time_mjd(t, ORR_SCALE_TT, NULL, &day, &f);
        arguments(day + f, 0, a);
        for (char line[512]; fgets(line, sizeof line, in) != NULL;) {
            int m[5];
            double s, c, angle = 0;
            if (sscanf(line, "%d %d %d %d %d %lf %lf", &m[0], &m[1], &m[2], &m[3], &m[4], &s, &c) != 7)
                continue;
            for (int i = 0; i < 5; i++) angle += m[i] * a[1 + i];
            sum += s * sin(angle) + c * cos(angle);
            rows++;
        }
        fclose(in);
        assert_int_equal(rows, 41);
        ASSERT_NEAR(1e6 * orr_eop_tides_zonal_ut1(t), 1e6 * sum, 0.05); // of up to 2500 us
    }
}

// Without the tables: the ocean moves the pole by a milliarcsecond at most and UT1 by 0.1 ms, and over a
// fortnight both come back to nothing; the zonal tides are 0.8 ms a fortnight and a month.
static void sizes_are_those_of_tides(void **state)
{
    (void)state;
    orr_time t;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse("2024-02-04", NULL, &t, &d), d);
    double x2 = 0, mean = 0, z2 = 0, most = 0;
    const int n = 24 * 27;
    for (int i = 0; i < n; i++) {
        const orr_time at = orr_time_add_s(t, 3600.0 * i);
        const orr_eop_tides o = orr_eop_tides_subdaily(at);
        const double x = o.xp_rad * 1296000e6 / TURN, z = orr_eop_tides_zonal_ut1(at) * 1e3;
        most = fmax(most, fabs(x));
        x2 += x * x / n;
        mean += x / n;
        z2 += z * z / n;
    }
    ASSERT_NEAR(most, 800, 300);
    ASSERT_NEAR(sqrt(x2), 290, 90); // M2 of 330, K1, O1 and N2, S2 of 60 to 170 in each of two halves
    ASSERT_NEAR(mean, 0, 10);
    ASSERT_NEAR(sqrt(z2), 0.84, 0.25); // sqrt((0.84^2 + 0.78^2 + 0.32^2 ...) / 2)
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ocean_tides_are_the_tables_sum),
        cmocka_unit_test(zonal_tides_are_the_tables_sum),
        cmocka_unit_test(sizes_are_those_of_tides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

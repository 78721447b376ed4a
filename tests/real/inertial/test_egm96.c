// SPDX-License-Identifier: GPL-3.0-or-later
// EGM96 to degree 21 as the room's gravity, against a synthesis written here from the definition, and against
// what is published of the Earth's figure.
#include "testing.h"

#include <unistd.h>

#include "core/rng.h"
#include "gravity_model.h"
#include "inertial/gravity/gravity.h"
#include "ingest/input/input.h"

#define FILE_NAME "gravity/egm96-21x21.txt"
#define DEG ORR_RAD_PER_DEG

static test_model egm96;
static orr_gravity_model *model;
static orr_gravity *gravity;

static bool load(void)
{
    char path[500], folder[] = "egm96-XXXXXX";
    if (model != NULL) return true;
    if (!orr_test_data(FILE_NAME, path, sizeof path) && !orr_test_data(FILE_NAME ".gz", path, sizeof path))
        return false;
    egm96 = (test_model){.gm_m3ps2 = 3986004.415e8, .radius_m = 6378136.3}; // Lemoine et al. 1998
    orr_input *in;
    orr_diag diag = {0};
    orr_view line;
    ASSERT_OK(orr_input_open(path, NULL, &in, &diag), diag);
    while (orr_input_line(in, &line)) {
        double v[4];
        for (int k = 0; k < 4; k++) {
            orr_view word;
            assert_true(orr_view_word(&line, &word));
            assert_int_equal(orr_view_real(word, &v[k]), ORR_FIELD_OK);
        }
        int n = (int)v[0], m = (int)v[1];
        assert_true(n <= TEST_MODEL_MAX_DEGREE && m <= n);
        if (n > egm96.degree) egm96.degree = n;
        egm96.c[n][m] = v[2];
        egm96.s[n][m] = v[3];
    }
    orr_input_close(in);
    assert_int_equal(egm96.degree, 21);
    assert_non_null(mkdtemp(folder));
    test_model_write(folder, "egm96", &egm96);
    ASSERT_OK(orr_gravity_model_open("egm96", folder, &model, &diag), diag);
    test_model_remove(folder, "egm96");
    rmdir(folder);
    orr_gravity_parts p = {.model = model};
    ASSERT_OK(orr_gravity_make(&p, &gravity, &diag), diag);
    return true;
}

// The potential by its definition: GM/r (1 + sum (a/r)^n P_nm(sin phi) (C cos m lambda + S sin m lambda)),
// fully normalised functions by the recurrence in degree (Holmes and Featherstone 2002, eq. 11).
static double potential(orr_vec3 r_m)
{
    double r = orr_vec3_norm(r_m), t = r_m.z / r, u = hypot(r_m.x, r_m.y) / r, l = atan2(r_m.y, r_m.x),
           sum = 1, sectorial = 1;
    for (int m = 0; m <= egm96.degree; m++) {
        if (m > 0) sectorial *= u * (m == 1 ? sqrt(3) : sqrt((2.0 * m + 1) / (2.0 * m)));
        double before = 0, p = sectorial;
        for (int n = m; n <= egm96.degree; n++) {
            if (n >= 2)
                sum += pow(egm96.radius_m / r, n) * p *
                       (egm96.c[n][m] * cos(m * l) + egm96.s[n][m] * sin(m * l));
            double k = n + 1, d = (k - m) * (k + m), a = sqrt((2 * k - 1) * (2 * k + 1) / d),
                   b = n > m ? sqrt((2 * k + 1) * (k + m - 1) * (k - m - 1) / (d * (2 * k - 3))) : 0,
                   next = a * t * p - b * before;
            before = p;
            p = next;
        }
    }
    return egm96.gm_m3ps2 / r * sum;
}

static orr_vec3 place(uint64_t k)
{
    return orr_earth_to_ecef((orr_geodetic){asin(2 * orr_rng_uniform(5, 0, k) - 1),
                                            (2 * orr_rng_uniform(5, 1, k) - 1) * ORR_PI,
                                            1e6 * pow(orr_rng_uniform(5, 2, k), 3)});
}

static void gravitation_is_the_gradient_of_the_definition(void **state)
{
    (void)state;
    if (!load()) SKIP_NO_DATA(FILE_NAME);
    const double h = 2000;
    for (uint64_t k = 0; k < 300; k++) {
        orr_vec3 r = place(k), g = orr_gravity_gravitation(gravity, r);
        const double got[3] = {g.x, g.y, g.z};
        for (int i = 0; i < 3; i++) {
            double v[5];
            for (int j = -2; j <= 2; j++)
                v[j + 2] = potential(
                    orr_vec3_make(r.x + (i == 0) * j * h, r.y + (i == 1) * j * h, r.z + (i == 2) * j * h));
            // Rounding: 6e7 m2/s2 to 1e-15 of itself over h: 3e-11; five points leave h^4 / 30 of the fifth
            // derivative: 5! g / r^4 of the central term and (21/r)^4 of 1e-4 m/s2: 1e-13.
            ASSERT_NEAR((8 * (v[3] - v[1]) - (v[4] - v[0])) / (12 * h), got[i], 1e-10);
        }
    }
}

// The disturbing potential from the room's face alone: its radial derivative, gathered from far away inwards;
// as a height of the geoid by Bruns' formula.
static double geoid_m(double lat_deg, double lon_deg)
{
    orr_vec3 r = orr_earth_to_ecef((orr_geodetic){lat_deg * DEG, lon_deg * DEG, 0}), e = orr_vec3_unit(r);
    const int n = 400; // Simpson in s = 1/r, where the derivative is s^2 times a polynomial of degree 21
    double s0 = 1 / orr_vec3_norm(r), sum = 0;
    for (int k = 1; k <= n; k++) {
        double s = s0 * k / n;
        orr_vec3 at = orr_vec3_scale(1 / s, e),
                 d = orr_vec3_sub(orr_gravity_gravitation(gravity, at), orr_earth_normal_gravitation(at));
        sum += (k == n ? 1 : k % 2 == 1 ? 4 : 2) * orr_vec3_dot(d, e) / (s * s);
    }
    const double u2 = ORR_EARTH_RATE_RADPS * ORR_EARTH_RATE_RADPS;
    const orr_vec3 normal = orr_vec3_add(orr_earth_normal_gravitation(r), (orr_vec3){u2 * r.x, u2 * r.y, 0});
    return -sum * s0 / n / 3 / orr_vec3_norm(normal);
}

// The geoid's deepest and highest places (Lemoine et al. 1998, NASA/TP-1998-206861: -106.99 m South of
// India, 85.39 m over New Guinea), but for degrees above 21, which Kaula's rule gives 3 m r.m.s.
static void the_geoid_has_its_low_and_its_high(void **state)
{
    (void)state;
    if (!load()) SKIP_NO_DATA(FILE_NAME);
    double low = 0, high = 0, low_lat = 0, low_lon = 0, high_lat = 0, high_lon = 0;
    for (int lat = -88; lat <= 88; lat += 4)
        for (int lon = -180; lon < 180; lon += 4) {
            double n = geoid_m(lat, lon);
            if (n < low) {
                low = n;
                low_lat = lat;
                low_lon = lon;
            }
            if (n > high) {
                high = n;
                high_lat = lat;
                high_lon = lon;
            }
        }
    print_message("geoid to degree 21: %.1f m at %.0f, %.0f; %.1f m at %.0f, %.0f\n", low, low_lat, low_lon,
                  high, high_lat, high_lon);
    ASSERT_NEAR(low, -106.99, 8);
    ASSERT_NEAR(low_lat, 4.7, 4);
    ASSERT_NEAR(low_lon, 78.8, 4);
    ASSERT_NEAR(high, 85.39, 10);
    ASSERT_NEAR(high_lat, -8.4, 8); // a broad high
    ASSERT_NEAR(high_lon, 147, 8);
}

// The disturbance is the radial derivative of the disturbing potential, degree by degree (n + 1) / r of it;
// its mean over the sphere is that of the difference of GM.
static void disturbances_are_of_the_earths_size(void **state)
{
    (void)state;
    if (!load()) SKIP_NO_DATA(FILE_NAME);
    double sum = 0, sum2 = 0, expected2 = 0;
    const int n = 4000;
    for (int k = 0; k < n; k++) { // evenly over the sphere (Fibonacci lattice)
        double z = 1 - (2.0 * k + 1) / n, l = ORR_PI * (3 - sqrt(5)) * k, w = sqrt(1 - z * z), r = 6.38e6;
        orr_vec3 at = {r * w * cos(l), r * w * sin(l), r * z};
        double d = orr_gravity_disturbance_mgal(gravity, at);
        sum += d / n;
        sum2 += d * d / n;
    }
    // Parseval: the mean square of the series without its normal part, whose zonals are subtracted
    for (int d = 2; d <= egm96.degree; d++)
        for (int m = 0; m <= d; m++) {
            double normal =
                       m == 0 && d % 2 == 0
                           ? -test_zonal(d / 2, ORR_WGS84_E2, 0.484166774985e-3 * sqrt(5)) / sqrt(2.0 * d + 1)
                           : 0,
                   f = 1e5 * egm96.gm_m3ps2 / (6.38e6 * 6.38e6) * (d + 1) * pow(egm96.radius_m / 6.38e6, d);
            expected2 += f * f * (pow(egm96.c[d][m] - normal, 2) + pow(egm96.s[d][m], 2));
        }
    print_message("gravity disturbance to degree 21: %.2f mGal r.m.s., mean %.4f\n", sqrt(sum2), sum);
    ASSERT_NEAR(sum, 1e5 * (egm96.gm_m3ps2 - ORR_WGS84_GM) / (6.38e6 * 6.38e6), 0.02);
    ASSERT_NEAR(sqrt(sum2), sqrt(expected2),
                0.01 * sqrt(expected2)); // along the ellipsoid's normal, not the radius
}

static int leave(void **state)
{
    (void)state;
    orr_gravity_free(gravity);
    orr_gravity_model_free(model);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gravitation_is_the_gradient_of_the_definition),
        cmocka_unit_test(the_geoid_has_its_low_and_its_high),
        cmocka_unit_test(disturbances_are_of_the_earths_size),
    };
    return cmocka_run_group_tests(tests, NULL, leave);
}

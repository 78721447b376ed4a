// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <unistd.h>

#include "core/earth.h"
#include "core/rng.h"
#include "gravity_model.h"

#define DEG ORR_RAD_PER_DEG

static double dms(double d, double m, double s)
{
    return (d < 0 ? -1 : 1) * (fabs(d) + m / 60 + s / 3600) * DEG;
}

static orr_geodetic random_place(uint64_t k)
{
    return (orr_geodetic){asin(2 * orr_rng_uniform(7, 0, k) - 1), (2 * orr_rng_uniform(7, 1, k) - 1) * ORR_PI,
                          -10000 + 4e7 * orr_rng_uniform(7, 2, k) * orr_rng_uniform(7, 3, k)};
}

static void geodetic_there_and_back(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 10000; k++) {
        orr_geodetic g = random_place(k), back = orr_earth_from_ecef(orr_earth_to_ecef(g));
        ASSERT_NEAR(back.lat_rad, g.lat_rad, 2e-15);
        ASSERT_NEAR(cos(g.lat_rad) * (back.lon_rad - g.lon_rad), 0, 2e-15);
        ASSERT_NEAR(back.height_m, g.height_m,
                    3e-8); // four units in the last place of 4.6e7 m: three coordinates are rounded
    }
    // poles, equator, date line
    orr_vec3 p = orr_earth_to_ecef((orr_geodetic){ORR_PI / 2, 0, 0});
    ASSERT_NEAR(p.z, 6356752.314245179, 1e-8); // NIMA TR8350.2, table 3.3: semi-minor axis 6356752.3142 m
    ASSERT_NEAR(hypot(p.x, p.y), 0, 1e-9);
    p = orr_earth_to_ecef((orr_geodetic){0, ORR_PI, 100});
    ASSERT_NEAR(p.x, -6378237, 1e-8);
    orr_geodetic g = orr_earth_from_ecef((orr_vec3){-7e6, -0.0, 0});
    ASSERT_NEAR(g.lon_rad, ORR_PI, 0); // (-pi, pi]
    g = orr_earth_from_ecef((orr_vec3){0, 0, -6356752.314245179 - 5});
    ASSERT_NEAR(g.lat_rad, -ORR_PI / 2, 0);
    ASSERT_NEAR(g.height_m, 5, 1e-8);
}

// The commands of the same library, as an oracle of our use of it (units, order, sign). They are separate
// programs.
static FILE *run(const char *command, const char *input)
{
    char path[] = "oracle-XXXXXX", line[256];
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    FILE *f = fdopen(fd, "wb");
    assert_non_null(f);
    fputs(input, f);
    fclose(f);
    snprintf(line, sizeof line, "%s < %s", command, path);
    FILE *p = popen(line, "r");
    assert_non_null(p);
    FILE *kept = tmpfile();
    assert_non_null(kept);
    for (int c; (c = getc(p)) != EOF;) putc(c, kept);
    int rc = pclose(p);
    remove(path);
    if (rc != 0) {
        fclose(kept);
        return NULL;
    }
    rewind(kept);
    return kept;
}

static bool have(const char *program)
{
    char line[128];
    snprintf(line, sizeof line, "command -v %s >/dev/null", program);
    return system(line) == 0;
}

static void geocentric_as_cartconvert(void **state)
{
    (void)state;
    if (!have("CartConvert")) {
        print_message("skipped: CartConvert (Debian package geographiclib-tools) is not here\n");
        skip();
    }
    enum { N = 200 };
    char *input = malloc(N * 100), *p = input;
    assert_non_null(input);
    for (uint64_t k = 0; k < N; k++) {
        orr_geodetic g = random_place(k);
        p += sprintf(p, "%.15f %.15f %.9f\n", g.lat_rad / DEG, g.lon_rad / DEG, g.height_m);
    }
    FILE *f = run("CartConvert -p 9", input);
    assert_non_null(f);
    for (uint64_t k = 0; k < N; k++) {
        double x, y, z;
        assert_int_equal(fscanf(f, "%lf %lf %lf", &x, &y, &z), 3);
        orr_vec3 r = orr_earth_to_ecef(random_place(k));
        ASSERT_NEAR(r.x, x, 5e-8);
        ASSERT_NEAR(r.y, y, 5e-8);
        ASSERT_NEAR(r.z, z, 5e-8);
    }
    fclose(f);
    free(input);
}

// GeoConvert writes UTM, whose conformal scale and axes are another way to the same place: along the central
// meridian of a zone the northing is 0.9996 times our meridian arc.
static void meridian_arc_as_geoconvert(void **state)
{
    (void)state;
    if (!have("GeoConvert")) {
        print_message("skipped: GeoConvert (Debian package geographiclib-tools) is not here\n");
        skip();
    }
    FILE *f = run("GeoConvert -u -p 6 -z 31", "0.000001 3\n10 3\n45.5 3\n60.25 3\n83 3\n");
    assert_non_null(f);
    const double lat[] = {0.000001, 10, 45.5, 60.25, 83};
    for (int i = 0; i < 5; i++) {
        char zone[16];
        double easting, northing, end_lat, end_lon, az2;
        assert_int_equal(fscanf(f, "%15s %lf %lf", zone, &easting, &northing), 3);
        const double dist = northing / 0.9996; // UTM's scale on its central meridian
        orr_earth_geodesic_direct(0, 3 * DEG, 0, dist, &end_lat, &end_lon, &az2);
        ASSERT_NEAR(easting, 500000, 1e-6);
        ASSERT_NEAR(end_lat * ORR_WGS84_A_M, lat[i] * DEG * ORR_WGS84_A_M, 2e-6);
        ASSERT_NEAR(end_lon, 3 * DEG, 1e-15);
        ASSERT_NEAR(az2, 0, 1e-12);
        // and the arc is the integral of the meridian radius (Simpson, 2000 panels)
        double sum = 0;
        for (int k = 0; k <= 2000; k++) {
            double m, n;
            orr_earth_radii(lat[i] * DEG * k / 2000, &m, &n);
            sum += m * (k == 0 || k == 2000 ? 1 : k % 2 != 0 ? 4 : 2);
        }
        ASSERT_NEAR(sum * lat[i] * DEG / 6000, dist, 1e-6);
    }
    fclose(f);
}

static void radii_at_published_places(void **state)
{
    (void)state;
    double m, n;
    orr_earth_radii(0, &m, &n);
    ASSERT_NEAR(n, 6378137.0, 0);
    ASSERT_NEAR(m, 6335439.3272, 1e-4);
    orr_earth_radii(ORR_PI / 2, &m, &n);
    ASSERT_NEAR(m, 6399593.6258, 1e-4); // NIMA TR8350.2, table 3.3: polar radius of curvature
    ASSERT_NEAR(m, n, 1e-8);
}

static void axes_at_a_place(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200; k++) {
        orr_geodetic g = random_place(k);
        orr_mat3 a = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad), t = orr_mat3_transpose(&a),
                 e = orr_mat3_mul(&a, &t);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) ASSERT_NEAR(e.m[i][j], i == j, 1e-15);
        // moving up by 1 km is 1 km along Up; a step North is along North
        orr_vec3 here = orr_earth_to_ecef(g),
                 up = orr_earth_to_ecef((orr_geodetic){g.lat_rad, g.lon_rad, g.height_m + 1000});
        orr_vec3 d = orr_mat3_apply(&a, orr_vec3_sub(up, here));
        ASSERT_NEAR(d.z, 1000, 2e-8);
        ASSERT_NEAR(hypot(d.x, d.y), 0, 3e-8);
        double m, n;
        orr_earth_radii(g.lat_rad, &m, &n);
        orr_vec3 north = orr_earth_to_ecef((orr_geodetic){g.lat_rad + 1e-7, g.lon_rad, g.height_m});
        d = orr_mat3_apply(&a, orr_vec3_sub(north, here));
        ASSERT_NEAR(d.y / ((m + g.height_m) * 1e-7), 1, 1e-6);
        ASSERT_NEAR(d.x, 0, 2e-8);
    }
}

static void up_is_the_normal(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 10000; k++) {
        orr_geodetic g = random_place(k); // 10 km below ground to 40000 km above
        if (k % 2 == 0) g.height_m *= 1e-3;
        orr_vec3 up = orr_earth_up(orr_earth_to_ecef(g));
        double c = cos(g.lat_rad);
        ASSERT_NEAR(up.x, c * cos(g.lon_rad), 1e-14);
        ASSERT_NEAR(up.y, c * sin(g.lon_rad), 1e-14);
        ASSERT_NEAR(up.z, sin(g.lat_rad), 1e-14);
    }
    for (int south = -1; south <= 1; south += 2) {
        orr_vec3 up = orr_earth_up((orr_vec3){0, -0.0, south * 6.4e6});
        ASSERT_NEAR(up.z, south, 0);
        ASSERT_NEAR(hypot(up.x, up.y), 0, 0);
        up = orr_earth_up((orr_vec3){1e-9, 0, south * 6.4e6});
        ASSERT_NEAR(up.z, south, 0);
    }
}

static void look_angles(void **state)
{
    (void)state;
    orr_geodetic g = {50 * DEG, 30 * DEG, 200};
    orr_vec3 site = orr_earth_to_ecef(g);
    orr_mat3 a = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    for (int az_deg = 0; az_deg < 360; az_deg += 15) {
        for (int el_deg = -75; el_deg <= 75; el_deg += 15) {
            double ce = cos(el_deg * DEG);
            orr_vec3 enu = {ce * sin(az_deg * DEG), ce * cos(az_deg * DEG), sin(el_deg * DEG)};
            orr_vec3 target = orr_vec3_axpy(2e7, orr_mat3_apply_t(&a, enu), site);
            double az, el, range;
            orr_earth_look(site, target, &az, &el, &range);
            assert_true(az >= 0 && az < 2 * ORR_PI);
            ASSERT_NEAR(remainder(az - az_deg * DEG, 2 * ORR_PI), 0, 1e-14);
            ASSERT_NEAR(el, el_deg * DEG, 1e-14);
            ASSERT_NEAR(range, 2e7, 1e-7);
        }
    }
}

static orr_vec3 gravity(orr_vec3 r)
{
    orr_vec3 g = orr_earth_normal_gravitation(r);
    const double u2 = 7.292115e-5 * 7.292115e-5;
    return (orr_vec3){g.x + u2 * r.x, g.y + u2 * r.y, g.z};
}

static void normal_gravity_at_its_published_values(void **state)
{
    (void)state;
    // NIMA TR8350.2, table 3.4: 9.7803253359 at the equator, 9.8321849378 at the poles
    ASSERT_NEAR(orr_vec3_norm(gravity(orr_earth_to_ecef((orr_geodetic){0}))), 9.7803253359, 5e-11);
    for (int pole = -1; pole <= 1; pole += 2)
        ASSERT_NEAR(orr_vec3_norm(gravity(orr_earth_to_ecef((orr_geodetic){pole * ORR_PI / 2, 0, 0}))),
                    9.8321849378, 1e-10);
    // Somigliana's closed form with its published constant k
    for (int lat = 0; lat <= 90; lat += 5) {
        double s2 = pow(sin(lat * DEG), 2);
        double somigliana = 9.7803253359 * (1 + 0.00193185265241 * s2) / sqrt(1 - ORR_WGS84_E2 * s2);
        // the vector on the ellipsoid: that strength, straight down
        orr_vec3 g = gravity(orr_earth_to_ecef((orr_geodetic){lat * DEG, 0.7, 0}));
        orr_mat3 a = orr_earth_enu_from_ecef(lat * DEG, 0.7);
        orr_vec3 enu = orr_mat3_apply(&a, g);
        ASSERT_NEAR(enu.z, -somigliana, 2e-10);
        ASSERT_NEAR(hypot(enu.x, enu.y), 0, 1e-13);
    }
    // far away a point mass with J2
    const double r = 2.66e7,
                 j2 = 1.082629821e-3; // of the ellipsoid, Moritz 2000 gives 108263e-8 for GRS80's sister
    orr_vec3 g = orr_earth_normal_gravitation((orr_vec3){r, 0, 0});
    double expected = -ORR_WGS84_GM / (r * r) * (1 + 1.5 * j2 * pow(ORR_WGS84_A_M / r, 2));
    ASSERT_NEAR(g.x / expected, 1, 2e-8); // J4 and the digits of J2
}

// A field has no curl and, outside the masses, no divergence.
static void normal_gravitation_is_a_potential_field(void **state)
{
    (void)state;
    const double h = 50;
    for (uint64_t k = 0; k < 50; k++) {
        orr_geodetic place = random_place(k);
        place.height_m = fabs(place.height_m) + 1000;
        orr_vec3 r = orr_earth_to_ecef(place);
        double j[3][3];
        for (int i = 0; i < 3; i++) {
            orr_vec3 step = {i == 0 ? h : 0, i == 1 ? h : 0, i == 2 ? h : 0};
            orr_vec3 d =
                orr_vec3_scale(0.5 / h, orr_vec3_sub(orr_earth_normal_gravitation(orr_vec3_add(r, step)),
                                                     orr_earth_normal_gravitation(orr_vec3_sub(r, step))));
            j[0][i] = d.x;
            j[1][i] = d.y;
            j[2][i] = d.z;
        }
        // gradients are 3e-6 1/s2; 1e-14 m/s2 of rounding over 100 m, and h^2 terms of 3e-6 (h/r)^2
        ASSERT_NEAR(j[0][0] + j[1][1] + j[2][2], 0, 1e-14);
        ASSERT_NEAR(j[0][1] - j[1][0], 0, 1e-14);
        ASSERT_NEAR(j[0][2] - j[2][0], 0, 1e-14);
        ASSERT_NEAR(j[1][2] - j[2][1], 0, 1e-14);
    }
}

static void geodesic_of_the_textbook(void **state)
{
    (void)state;
    // Geoscience Australia's worked line, Flinders Peak to Buninyong, on GRS80: its flattening differs by
    // 1e-11 of WGS 84's
    double lat, lon, az2;
    orr_earth_geodesic_direct(dms(-37, 57, 3.72030), dms(144, 25, 29.52440), dms(306, 52, 5.37), 54972.271,
                              &lat, &lon, &az2);
    ASSERT_NEAR(lat, dms(-37, 39, 10.15610), 2e-10); // the millimetre of the length, 5e-3" of the azimuth
    ASSERT_NEAR(lon, dms(143, 55, 35.38390), 2e-10);
    ASSERT_NEAR(remainder(az2 + ORR_PI - dms(127, 10, 25.07), 2 * ORR_PI), 0, 3e-8);
    // there and back, and a whole meridian round
    for (uint64_t k = 0; k < 1000; k++) {
        const orr_geodetic a = random_place(k);
        const double az = 2 * ORR_PI * orr_rng_uniform(8, 0, k), dist = 2e7 * orr_rng_uniform(8, 1, k);
        double back_lat, back_lon, back_az;
        orr_earth_geodesic_direct(a.lat_rad, a.lon_rad, az, dist, &lat, &lon, &az2);
        orr_earth_geodesic_direct(lat, lon, az2, -dist, &back_lat, &back_lon, &back_az);
        const orr_vec3 p = orr_earth_to_ecef((orr_geodetic){back_lat, back_lon, 0}),
                       q = orr_earth_to_ecef((orr_geodetic){a.lat_rad, a.lon_rad, 0});
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(p, q)), 0, 1e-7);
    }
    orr_earth_geodesic_direct(0.3, 1.1, 0, 4 * 10001965.7293127, &lat, &lon, &az2);
    ASSERT_NEAR(lat, 0.3, 1e-13); // the quadrant's own digits: 4e-7 m of 6.4e6 m
    ASSERT_NEAR(lon, 1.1, 1e-13);
}

// A model in GeographicLib's file format ("Magnetic models" of its documentation) whose only terms are IGRF-13's dipole and
// its rates: axes, units and years are those of the built-in closed form.
static void write_dipole_model(const char *dir)
{
    FILE *f = test_model_file(dir, "dipole", ".wmm");
    fputs(
        "WMMF-1\nName dipole\nPublisher test\nReleaseDate 2020-01-01\nRadius 6371200\nType linear\nEpoch "
        "2020\n"
        "DeltaEpoch 5\nMinTime 2020\nMaxTime 2025\nMinHeight -1000\nMaxHeight 850000\nNormalization schmidt\n"
        "ID ORRTESTM\n",
        f);
    fclose(f);
    f = test_model_file(dir, "dipole", ".wmm.cof");
    fwrite("ORRTESTM", 1, 8, f);
    const double g10[2] = {-29404.8, 5.7}, g11[2] = {-1450.9, 7.4}, h11[2] = {4652.5, -25.9};
    for (int k = 0; k < 2; k++) { // field, rates
        const int32_t size[2] = {1, 1};
        const double c[4] = {0, g10[k], g11[k], h11[k]}; // cosines of orders 0 and 1, sine of order 1
        fwrite(size, sizeof size, 1, f);
        fwrite(c, sizeof c, 1, f);
    }
    fclose(f);
}

static void magnetic_model_of_a_dipole(void **state)
{
    (void)state;
    char dir[] = "/tmp/orrery-magnetic-XXXXXX", path[64];
    assert_non_null(mkdtemp(dir));
    write_dipole_model(dir);
    orr_magnetic *m;
    orr_diag d = {0};
    ASSERT_OK(orr_magnetic_open("dipole", dir, &m, &d), d);
    for (uint64_t k = 0; k < 200; k++) {
        orr_geodetic place = random_place(k);
        place.height_m = 8e5 * orr_rng_uniform(9, 0, k);
        const double year = 2020 + 5 * orr_rng_uniform(9, 1, k);
        const orr_vec3 got = orr_magnetic_field_nt(m, year, place),
                       want = orr_magnetic_field_nt(NULL, year, place);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(got, want)), 0, 1e-9); // rounding of 6e4 nT
    }
    orr_magnetic_free(m);
    assert_int_equal(orr_magnetic_open("absent", dir, &m, &d), ORR_E_IO);
    assert_null(m);
    assert_non_null(strstr(d.text, "absent"));
    for (int k = 0; k < 2; k++) {
        snprintf(path, sizeof path, "%s/dipole.wmm%s", dir, k == 0 ? "" : ".cof");
        assert_int_equal(unlink(path), 0);
    }
    assert_int_equal(rmdir(dir), 0);
}

static void gravity_model_of_one_coefficient(void **state)
{
    (void)state;
    char dir[] = "gravity-XXXXXX", path[64];
    assert_non_null(mkdtemp(dir));
    const double c20 = -4.84165371736e-4, gm = 3.986004415e14, a = 6378136.3, j2 = -c20 * sqrt(5);
    test_model made = {.degree = 4, .gm_m3ps2 = gm, .radius_m = a};
    made.c[2][0] = c20;
    test_model_write(dir, "good", &made);
    orr_gravity_model *m;
    orr_diag d = {0};
    ASSERT_OK(orr_gravity_model_open("good", dir, &m, &d), d);
    for (uint64_t k = 0; k < 100; k++) {
        orr_geodetic g = random_place(k);
        orr_vec3 r = orr_earth_to_ecef((orr_geodetic){g.lat_rad, g.lon_rad, fabs(g.height_m)});
        double n = orr_vec3_norm(r), q = 1.5 * j2 * a * a / (n * n), z2 = 5 * r.z * r.z / (n * n),
               f = -gm / (n * n * n);
        orr_vec3 got = orr_gravity_model_gravitation(m, r);
        ASSERT_NEAR(got.x, f * r.x * (1 + q * (1 - z2)), 1e-13);
        ASSERT_NEAR(got.y, f * r.y * (1 + q * (1 - z2)), 1e-13);
        ASSERT_NEAR(got.z, f * r.z * (1 + q * (3 - z2)), 1e-13);
    }
    orr_gravity_model_free(m);
    orr_gravity_model_free(NULL);

    // refused with a sentence, no exception past the wall
    d = (orr_diag){0};
    assert_int_equal(orr_gravity_model_open("absent", dir, &m, &d), ORR_E_IO);
    assert_null(m);
    assert_non_null(strstr(d.text, "absent"));
    // without a folder it is looked for where GeographicLib keeps its own, and the sentence says so
    d = (orr_diag){0};
    assert_int_equal(orr_gravity_model_open("absent", NULL, &m, &d), ORR_E_IO);
    assert_non_null(strstr(d.text, "absent"));
    assert_null(strstr(d.text, "null"));
    test_model_write(dir, "bad", &made);
    FILE *f = test_model_file(dir, "bad", ".egm");
    fputs("this is no model\n", f);
    fclose(f);
    d = (orr_diag){0};
    assert_int_equal(orr_gravity_model_open("bad", dir, &m, &d), ORR_E_IO);
    assert_true(d.text[0] != '\0');
    snprintf(path, sizeof path, "%s/good.egm.cof", dir);
    assert_int_equal(truncate(path, 50), 0);
    d = (orr_diag){0};
    assert_int_equal(orr_gravity_model_open("good", dir, &m, &d), ORR_E_IO);
    assert_true(d.text[0] != '\0');
    test_model_remove(dir, "good");
    test_model_remove(dir, "bad");
    rmdir(dir);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(geodetic_there_and_back),
        cmocka_unit_test(geocentric_as_cartconvert),
        cmocka_unit_test(meridian_arc_as_geoconvert),
        cmocka_unit_test(radii_at_published_places),
        cmocka_unit_test(axes_at_a_place),
        cmocka_unit_test(up_is_the_normal),
        cmocka_unit_test(look_angles),
        cmocka_unit_test(normal_gravity_at_its_published_values),
        cmocka_unit_test(normal_gravitation_is_a_potential_field),
        cmocka_unit_test(geodesic_of_the_textbook),
        cmocka_unit_test(magnetic_model_of_a_dipole),
        cmocka_unit_test(gravity_model_of_one_coefficient),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

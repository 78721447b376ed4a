// SPDX-License-Identifier: GPL-3.0-or-later
// Turbulence of water vapour: its structure function in space, in time and between directions, rates, and terms of channels.
#include "src/scenario/troposphere/turbulence.h"

#include "core/constants.h"
#include "core/earth.h"
#include "testing.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: 3}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"

enum { FIELDS = 150, PLACES = 6 };
static const orr_scenario_turbulence average = {
    .strength = 2.4e-7, .height_m = 2000, .speed_mps = 8, .azimuth_deg = 90, .seed = 1};

// A field of a seed about a place on the Equator, where East is y and North is z.
static orr_turbulence *field_of(int64_t seed)
{
    static const orr_mat3 enu = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    orr_scenario_turbulence s = average;
    orr_turbulence *f;
    orr_diag diag = {0};
    s.seed = seed;
    ASSERT_OK(orr_turbulence_open(&s, (orr_vec3){6378e3, 0, 0}, &enu, &f, &diag), diag);
    return f;
}

static double slant_m(const orr_turbulence *f, double east_m, double north_m, double az_deg, double el_deg,
                      double t_s)
{
    double rate;
    const double az = az_deg * ORR_RAD_PER_DEG, el = el_deg * ORR_RAD_PER_DEG;
    const double lower_m = (east_m * east_m + north_m * north_m) / (2 * 6371e3); // on a round Earth
    const orr_turbulence_ray ray = {.r_m = {6378e3 - lower_m, east_m, north_m},
                                    .u = {sin(az) * cos(el), cos(az) * cos(el), sin(el)}};
    return orr_turbulence_slant_m(f, &ray, (orr_time)(t_s * 1e9), &rate);
}

// Mean squares of differences over fields and places, against what the layer has (Treuhaft and Lanyi): with the distance between
// antennas; with time, in which the wind goes as far; and between directions, which meet the field apart.
static void structure_functions_return(void **state)
{
    (void)state;
    static const double distance_m[] = {200, 1000, 5000, 20000};
    static const double el_deg = 30;
    const double slant =
        1 / (sin(el_deg * ORR_RAD_PER_DEG) * sin(el_deg * ORR_RAD_PER_DEG) + 0.03 * 0.03); // squared
    double between[4] = {0}, later[4] = {0}, aside[3] = {0};
    static const double turned_deg[] = {20, 60, 180};
    for (int64_t seed = 1; seed <= FIELDS; seed++) {
        orr_turbulence *f = field_of(seed);
        for (int p = 0; p < PLACES; p++) {
            const double e = 70e3 * p, n = -40e3 * p, t = 1e9 + 900 * p, az = 60.0 * p,
                         here = slant_m(f, e, n, az, el_deg, t);
            for (int k = 0; k < 4; k++) {
                const double a = az * ORR_RAD_PER_DEG;
                const double moved = slant_m(f, e + distance_m[k] * sin(a), n + distance_m[k] * cos(a), az,
                                             el_deg, t) -
                                     here,
                             waited = slant_m(f, e, n, az, el_deg, t + distance_m[k] / 8) - here;
                between[k] += moved * moved / (FIELDS * PLACES);
                later[k] += waited * waited / (FIELDS * PLACES);
            }
            for (int k = 0; k < 3; k++) {
                const double other = slant_m(f, e, n, az + turned_deg[k], el_deg, t) - here;
                aside[k] += other * other / (FIELDS * PLACES);
            }
        }
        orr_turbulence_close(f);
    }
    for (int k = 0; k < 4; k++) {
        const double law = slant * orr_turbulence_structure_m2(&average, distance_m[k]);
        ASSERT_NEAR(sqrt(between[k] / law), 1, 0.1);
        ASSERT_NEAR(sqrt(later[k] / law), 1, 0.1);
    }
    for (int k = 0; k < 3; k++) { // rays meet the field 1000 m up
        const double radius_m = 1000 * cos(el_deg * ORR_RAD_PER_DEG) * sqrt(slant);
        const double apart_m = 2 * radius_m * sin(turned_deg[k] / 2 * ORR_RAD_PER_DEG);
        ASSERT_NEAR(sqrt(aside[k] / (slant * orr_turbulence_structure_m2(&average, apart_m))), 1, 0.1);
    }
    // Kolmogorov's slopes: r^(5/3) within the layer, r^(2/3) far beyond its thickness.
    const double d1 = orr_turbulence_structure_m2(&average, 10),
                 d2 = orr_turbulence_structure_m2(&average, 20),
                 d3 = orr_turbulence_structure_m2(&average, 4e5),
                 d4 = orr_turbulence_structure_m2(&average, 8e5);
    ASSERT_NEAR(log2(d2 / d1), 5.0 / 3, 0.08);
    ASSERT_NEAR(log2(d4 / d3), 2.0 / 3, 0.03);
}

// Half the layer up there is 0.35 of it, above the layer none.
static void it_ends_with_its_layer(void **state)
{
    (void)state;
    orr_turbulence *f = field_of(2);
    orr_turbulence_ray ray = {.r_m = {6378e3, 0, 0}, .u = {0, 0, 1}};
    double rate;
    const double ground = orr_turbulence_slant_m(f, &ray, 0, &rate);
    ray.r_m.x += 1000;
    ASSERT_NEAR(orr_turbulence_slant_m(f, &ray, 0, &rate) / ground, sqrt(0.125), 1e-9);
    ray.r_m.x += 1500;
    ASSERT_NEAR(orr_turbulence_slant_m(f, &ray, 0, &rate), 0, 0);
    ASSERT_NEAR(rate, 0, 0);
    orr_turbulence_close(f);
}

static void its_rate_is_its_slope(void **state)
{
    (void)state;
    orr_turbulence *f = field_of(3);
    for (int k = 0; k < 60; k++) {
        const double el = (2 + 1.4 * k) * ORR_RAD_PER_DEG, az = 0.7 * k, turn = 1e-4, dt = 0.01;
        double rate, unused, value[2];
        orr_turbulence_ray ray = {.r_m = {6378e3, 100.0 * k, -50.0 * k}, .v_mps = {1, 30, -20}};
        ray.u = (orr_vec3){sin(az) * cos(el), cos(az) * cos(el), sin(el)};
        ray.u_rate_ps = (orr_vec3){turn * (cos(az) * cos(el) - sin(az) * sin(el)),
                                   turn * (-sin(az) * cos(el) - cos(az) * sin(el)), turn * cos(el)};
        const orr_time t = (orr_time)(1e18 + 1e9 * 100 * k);
        (void)orr_turbulence_slant_m(f, &ray, t, &rate);
        for (int side = 0; side < 2; side++) {
            orr_turbulence_ray x = ray;
            const double s = side == 0 ? -dt : dt;
            x.r_m = orr_vec3_axpy(s, ray.v_mps, ray.r_m);
            x.u = orr_vec3_unit(orr_vec3_axpy(s, ray.u_rate_ps, ray.u));
            value[side] = orr_turbulence_slant_m(f, &x, t + (int64_t)(s * 1e9), &unused);
        }
        ASSERT_NEAR(rate, (value[1] - value[0]) / (2 * dt), 1e-6 + 1e-3 * fabs(rate));
    }
    orr_turbulence_close(f);
}

// Channels have centimetres of it at most, in code and carrier, with its rate; another seed is another sky.
static void channels_have_its_term(void **state)
{
    (void)state;
    static orr_channel calm[ROOM], moved[ROOM], later[ROOM], other[ROOM];
    open_with(SKY "troposphere: {model: saastamoinen}\n");
    const size_t n = all_at(at(5000), 0, calm);
    tear_down(NULL);
    open_with(SKY "troposphere: {model: saastamoinen, turbulence: {seed: 5}}\n");
    assert_true(n > 5 && all_at(at(5000.01), 0, later) == n && all_at(at(5000), 0, moved) == n);
    tear_down(NULL);
    open_with(SKY "troposphere: {model: saastamoinen, turbulence: {seed: 6}}\n");
    assert_int_equal(all_at(at(5000), 0, other), n);
    double most = 0;
    for (size_t k = 0; k < n; k++) {
        const double d = moved[k].term_m[ORR_TERM_TURBULENCE];
        assert_true(calm[k].term_m[ORR_TERM_TURBULENCE] == 0 && d != other[k].term_m[ORR_TERM_TURBULENCE]);
        ASSERT_NEAR(moved[k].code_m - calm[k].code_m, d, 1e-6); // the satellite moves on meanwhile
        ASSERT_NEAR(moved[k].term_m[ORR_TERM_TROPOSPHERE_WET], calm[k].term_m[ORR_TERM_TROPOSPHERE_WET], 0);
        ASSERT_NEAR((later[k].term_m[ORR_TERM_TURBULENCE] - d) / 0.01, moved[k].rate_mps[ORR_TERM_TURBULENCE],
                    1e-5);
        most = fmax(most, fabs(d) * sin(calm[k].el_rad));
    }
    assert_in_range((int)(1e4 * most), 10, 1000); // a millimetre to ten centimetres
    refused_with(SKY "troposphere: {model: none, turbulence: {seed: 5}}\n", "turbulence");
    refused_with(SKY "troposphere: {turbulence: {speed: 90}}\n", "speed");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(structure_functions_return),
        cmocka_unit_test(it_ends_with_its_layer),
        cmocka_unit_test(its_rate_is_its_slope),
        cmocka_unit_test_teardown(channels_have_its_term, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A low orbit in a field finer than the built-in one, with drag: a gravity model in GeographicLib's format in the place of
// the built-in field, and what the smoother makes of nodes with and without it.
#include "testing.h"

#include <unistd.h>

#include "core/rng.h"
#include "gravity_model.h"
#include "made_sp3.h"
#include "orbit/smooth/smoother.h"

#define FINE 60
#define DAYS 0.25

static char folder[] = "low-orbit-XXXXXX";
static orr_gravity_model *coarse, *fine; // EGM96 to degree 21, and so on by Kaula's rule
static made_sky sky;
static made_truth truth;

static double norm(int n, int m)
{
    double ratio = 1;
    for (int k = n - m + 1; k <= n + m; k++) ratio /= k;
    return sqrt((m == 0 ? 1 : 2) * (2.0 * n + 1) * ratio);
}

static orr_gravity_model *open_model(const test_model *made, int degree)
{
    orr_gravity_model *m = NULL;
    orr_diag d = {0};
    test_model_write(folder, "made", made);
    ASSERT_OK(orr_gravity_model_open_to("made", folder, degree, &m, &d), d);
    test_model_remove(folder, "made");
    return m;
}

static orr_gravity_field field(int degree, const orr_gravity_model *model)
{
    orr_gravity_field f;
    orr_diag d = {0};
    ASSERT_OK(orr_gravity_field_init(&f, degree, false, &d), d);
    f.model = model;
    return f;
}

// Drag of a satellite 450 km high: twice as much over the day side.
static void add_drag(const orr_sky_point *p, orr_vec3 r, double dt, orr_vec3 *v)
{
    const double day = orr_vec3_dot(r, p->sun_m) / (orr_vec3_norm(r) * orr_vec3_norm(p->sun_m));
    *v = orr_vec3_axpy(-3e-7 * (1.5 + 0.5 * day) * dt, orr_vec3_unit(*v), *v);
}

static void fly(void)
{
    orr_integrator *it = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_integrator_init(&sky.force, sky.sky, &it, &d), d);
    const double a = 6.83e6, incl = 1.53, speed = sqrt(ORR_EGM96_GM / a);
    orr_vec3 r = {a, 0, 0}, v = {0, speed * cos(incl), speed * sin(incl)};
    truth.sat = orr_sat_make('L', 1);
    truth.n = sky.n;
    for (size_t i = 0; i < sky.n; i++) {
        orr_sky_point p;
        orr_sky_at(sky.sky, MADE_STEP_S * (double)i, &p);
        orr_sky_to_ecef(&p, r, v, &truth.r[i], &truth.v[i]);
        for (int k = 0; k < 10 && i + 1 < sky.n; k++) { // drag as kicks
            add_drag(&p, r, MADE_STEP_S / 20, &v);
            ASSERT_OK(orr_integrate(it, MADE_STEP_S * ((double)i + k / 10.0), MADE_STEP_S / 10, &r, &v), d);
            add_drag(&p, r, MADE_STEP_S / 20, &v);
        }
    }
    orr_integrator_free(it);
}

static int make(void **state)
{
    (void)state;
    static test_model made;
    if (mkdtemp(folder) == NULL) return -1;
    const orr_gravity_field egm96 = field(21, NULL);
    made = (test_model){.degree = FINE, .gm_m3ps2 = ORR_EGM96_GM, .radius_m = ORR_EGM96_RADIUS_M};
    uint64_t draw = 0;
    for (int n = 2; n <= FINE; n++)
        for (int m = 0; m <= n; m++) {
            const double kaula = 1e-5 / (n * n);
            made.c[n][m] = n > 21 ? kaula * orr_rng_normal(5, 0, draw++) : egm96.c[n][m] / norm(n, m);
            made.s[n][m] = n > 21  ? (m > 0 ? kaula * orr_rng_normal(5, 0, draw++) : 0)
                           : m > 0 ? egm96.s[n][m] / norm(n, m)
                                   : 0;
        }
    fine = open_model(&made, FINE);
    coarse = open_model(&made, 21);
    made_sky_init(&sky, "2024-02-04", DAYS);
    sky.force.earth = field(21, fine);
    fly();
    return 0;
}

static int drop(void **state)
{
    (void)state;
    orr_gravity_model_free(fine);
    orr_gravity_model_free(coarse);
    made_sky_free(&sky);
    return rmdir(folder);
}

static void a_model_of_the_same_field_is_the_built_in_one(void **state)
{
    (void)state;
    assert_int_equal(orr_gravity_model_degree(coarse), 21);
    const orr_gravity_field own = field(21, NULL), other = field(21, coarse), bare = field(0, coarse);
    assert_int_equal(orr_gravity_field_degree(&other), 21);
    assert_int_equal(orr_gravity_field_degree(&bare), 0);
    const double tide[5] = {1e-8, 2e-9, -1e-9, 3e-9, 1e-9};
    for (uint64_t k = 0; k < 500; k++) {
        const double z = 2 * orr_rng_uniform(3, 0, k) - 1, l = 2 * ORR_PI * orr_rng_uniform(3, 1, k),
                     far = 6.6e6 + 1e7 * orr_rng_uniform(3, 2, k), w = sqrt(1 - z * z);
        const orr_vec3 r = {far * w * cos(l), far * w * sin(l), far * z};
        // 9 m/s2 in doubles
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_gravity_field_gravitation(&own, r),
                                               orr_gravity_field_gravitation(&other, r))),
                    0, 2e-14);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_gravity_field_with_tide(&own, tide, r),
                                               orr_gravity_field_with_tide(&other, tide, r))),
                    0, 2e-14);
    }
}

static double left_out_mm(const orr_gravity_model *model)
{
    const made_truth *all[] = {&truth};
    orr_sp3 f;
    orr_orbit_solution s;
    orr_smoother_report report;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    double rms = 0, max = 0;
    made_sp3(&sky, all, 1, 0, sky.n - 1, 2, &f); // every second position
    o.low_gravity = model;
    const orr_smoother_input in = {.sp3 = &f, .name = "made.sp3"};
    ASSERT_OK(orr_smoother_run(&in, 1, &o, NULL, NULL, &s, &report, NULL, &d), d);
    assert_int_equal(report.nodes_rejected + report.manoeuvres, 0);
    assert_true(made_compare(&sky, &truth, &s, 0, 86400 * DAYS, &rms, &max) > 60);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    return 1e3 * rms;
}

// Nodes of ten minutes, a tenth of a revolution: what the field lacks no random walk makes up for, drag it does.
static void drag_is_followed_and_the_field_has_to_be_there(void **state)
{
    (void)state;
    const double with = left_out_mm(fine), built_in = left_out_mm(NULL);
    print_message("positions every 300 s, of which every second is a node: %.1f mm RMS with the field of "
                  "degree %d, %.0f mm "
                  "with the built-in one\n",
                  with, FINE, built_in);
    ASSERT_NEAR(with, 0, 2); // of which 0.5 are the rounding
    assert_true(built_in > 20 * with);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_model_of_the_same_field_is_the_built_in_one),
        cmocka_unit_test(drag_is_followed_and_the_field_has_to_be_there),
    };
    return cmocka_run_group_tests(tests, make, drop);
}

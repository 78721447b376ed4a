// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/rng.h"
#include "core/vec.h"

static orr_vec3 random_unit(uint64_t k)
{
    return orr_vec3_unit(
        (orr_vec3){orr_rng_normal(1, 0, k), orr_rng_normal(1, 1, k), orr_rng_normal(1, 2, k)});
}

static double distance(const orr_mat3 *a, const orr_mat3 *b)
{
    double max = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) max = fmax(max, fabs(a->m[i][j] - b->m[i][j]));
    return max;
}

static double from_orthogonal(const orr_mat3 *a)
{
    orr_mat3 t = orr_mat3_transpose(a), p = orr_mat3_mul(a, &t), e = orr_mat3_identity();
    return distance(&p, &e);
}

static double determinant(const orr_mat3 *a)
{
    orr_vec3 r[3];
    for (int i = 0; i < 3; i++) r[i] = (orr_vec3){a->m[i][0], a->m[i][1], a->m[i][2]};
    return orr_vec3_dot(r[0], orr_vec3_cross(r[1], r[2]));
}

// Angles from tiny to pi, where inversions are delicate.
static const double ANGLES[] = {0,    1e-300, 1e-160, 1e-20,    1e-12,     1e-9, 1e-8,
                                1e-6, 1e-4,   0.0316, 0.0317,   0.1,       1,    2,
                                3,    3.1,    3.1415, 3.141592, 3.14159265};
#define N_ANGLES (sizeof ANGLES / sizeof ANGLES[0])

static void elementary_rotations_are_passive(void **state)
{
    (void)state;
    const double q = ORR_PI / 2;
    // turning the axes about 3 by 90 degrees, the old axis 1 is seen along minus the new axis 2
    orr_mat3 r3 = orr_mat3_rot3(q), r1 = orr_mat3_rot1(q), r2 = orr_mat3_rot2(q);
    orr_vec3 v = orr_mat3_apply(&r3, (orr_vec3){1, 0, 0});
    ASSERT_NEAR(v.y, -1, 1e-15);
    v = orr_mat3_apply(&r1, (orr_vec3){0, 1, 0});
    ASSERT_NEAR(v.z, -1, 1e-15);
    v = orr_mat3_apply(&r2, (orr_vec3){0, 0, 1});
    ASSERT_NEAR(v.x, -1, 1e-15);
    const double a = 0.7;
    orr_mat3 e1 = orr_mat3_rot1(a), e2 = orr_mat3_rot2(a), e3 = orr_mat3_rot3(a);
    orr_mat3 g1 = orr_mat3_from_rotvec((orr_vec3){a, 0, 0}), g2 = orr_mat3_from_rotvec((orr_vec3){0, a, 0}),
             g3 = orr_mat3_from_rotvec((orr_vec3){0, 0, a});
    ASSERT_NEAR(distance(&e1, &g1), 0, 1e-15);
    ASSERT_NEAR(distance(&e2, &g2), 0, 1e-15);
    ASSERT_NEAR(distance(&e3, &g3), 0, 1e-15);
}

static void hat_is_minus_the_cross_product(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 50; k++) {
        orr_vec3 w = random_unit(k), v = random_unit(k + 100), c = orr_vec3_cross(w, v);
        orr_mat3 h = orr_mat3_hat(w);
        orr_vec3 d = orr_vec3_add(orr_mat3_apply(&h, v), c);
        ASSERT_NEAR(orr_vec3_norm(d), 0, 1e-15);
    }
}

static void rotation_vectors_there_and_back(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200; k++) {
        orr_vec3 axis = random_unit(k);
        for (size_t i = 0; i < N_ANGLES; i++) {
            orr_vec3 g = orr_vec3_scale(ANGLES[i], axis);
            orr_mat3 a = orr_mat3_from_rotvec(g);
            ASSERT_NEAR(from_orthogonal(&a), 0, 2e-15);
            ASSERT_NEAR(determinant(&a), 1, 2e-15);
            orr_vec3 back = orr_rotvec_from_mat3(&a);
            // relative where the vector is small, the matrix's rounding where it is not
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(back, g)), 0, 4e-15 * fmax(ANGLES[i], 1e-300));
        }
    }
}

static void rotation_by_pi_has_one_of_its_two_vectors(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200; k++) {
        orr_vec3 g = orr_vec3_scale(ORR_PI, k < 3 ? (orr_vec3){k == 0, k == 1, k == 2} : random_unit(k));
        orr_mat3 a = orr_mat3_from_rotvec(g);
        orr_vec3 back = orr_rotvec_from_mat3(&a);
        ASSERT_NEAR(orr_vec3_norm(back), ORR_PI, 1e-14);
        ASSERT_NEAR(fabs(orr_vec3_dot(back, g)), ORR_PI * ORR_PI, 1e-13);
        // beyond pi the shorter way round is returned
        orr_mat3 beyond = orr_mat3_from_rotvec(orr_vec3_scale(1.2, g));
        back = orr_rotvec_from_mat3(&beyond);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_add(back, orr_vec3_scale(0.8, g))), 0, 1e-14);
    }
}

// dA/dt = hat(w) A: a step by w dt after another is a step by their sum about one axis, and its derivative is
// hat(w) A.
static void rotation_vector_solves_its_equation(void **state)
{
    (void)state;
    orr_vec3 w = {0.3, -0.5, 0.8};
    const double h = 1e-5, t = 1.7;
    orr_mat3 before = orr_mat3_from_rotvec(orr_vec3_scale(t - h, w)),
             at = orr_mat3_from_rotvec(orr_vec3_scale(t, w)),
             after = orr_mat3_from_rotvec(orr_vec3_scale(t + h, w)), hat = orr_mat3_hat(w);
    orr_mat3 minus = orr_mat3_scale(-1, &before), difference = orr_mat3_add(&after, &minus);
    difference = orr_mat3_scale(0.5 / h, &difference);
    orr_mat3 expected = orr_mat3_mul(&hat, &at);
    ASSERT_NEAR(distance(&difference, &expected), 0,
                1e-10); // h^2/6 of the third derivative, and rounding / h
    orr_mat3 step = orr_mat3_from_rotvec(orr_vec3_scale(h, w)), product = orr_mat3_mul(&step, &at);
    ASSERT_NEAR(distance(&product, &after), 0, 1e-15);
}

static void an_inverse_solves_its_equation(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200; k++) {
        // A rotation, stretched by 1, 2, 5 along its axes, and rotated again: condition 5, rounding some 1e-15.
        orr_mat3 a = orr_mat3_from_rotvec(orr_vec3_scale(2.1, random_unit(k)));
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) a.m[i][j] *= i == 0 ? 1 : i == 1 ? 2 : 5;
        orr_mat3 turn = orr_mat3_from_rotvec(orr_vec3_scale(1.3, random_unit(k + 500)));
        a = orr_mat3_mul(&turn, &a);
        orr_mat3 inverse = orr_mat3_inverse(&a), one = orr_mat3_mul(&inverse, &a), unit = orr_mat3_identity();
        ASSERT_NEAR(distance(&one, &unit), 0, 2e-14);
        orr_vec3 x = random_unit(k + 900), back = orr_mat3_solve(&a, orr_mat3_apply(&a, x));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(back, x)), 0, 1e-14);
    }
    const orr_mat3 singular = {{{1, 2, 3}, {2, 4, 6}, {0, 1, 0}}};
    orr_mat3 none = orr_mat3_inverse(&singular);
    assert_true(isfinite(none.m[0][0]) == 0);
    assert_true(isfinite(orr_mat3_solve(&singular, (orr_vec3){1, 1, 1}).x) == 0);
}

static void quaternions_are_the_same_rotations(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200; k++) {
        for (size_t i = 0; i < N_ANGLES; i++) {
            orr_vec3 g = orr_vec3_scale(ANGLES[i], random_unit(k));
            orr_mat3 a = orr_mat3_from_rotvec(g);
            orr_quat q = orr_quat_from_rotvec(g), p = orr_quat_from_mat3(&a);
            orr_mat3 from_q = orr_mat3_from_quat(q), from_p = orr_mat3_from_quat(p);
            ASSERT_NEAR(distance(&a, &from_q), 0, 1e-15);
            ASSERT_NEAR(distance(&a, &from_p), 0, 1e-15);
            ASSERT_NEAR(fabs(orr_quat_dot(p, q)), 1, 1e-15);
            assert_true(p.w >= 0);
            orr_mat3 from_minus = orr_mat3_from_quat(orr_quat_neg(q));
            ASSERT_NEAR(distance(&a, &from_minus), 0, 1e-15);
        }
    }
}

static void products_follow_the_way_of_the_frames(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200; k++) {
        orr_quat q_ba = orr_quat_from_rotvec(orr_vec3_scale(2.5, random_unit(k)));
        orr_quat q_cb = orr_quat_from_rotvec(orr_vec3_scale(1.5, random_unit(k + 1000)));
        orr_mat3 ba = orr_mat3_from_quat(q_ba), cb = orr_mat3_from_quat(q_cb), ca = orr_mat3_mul(&cb, &ba);
        orr_mat3 from_product = orr_mat3_from_quat(orr_quat_mul(q_ba, q_cb));
        ASSERT_NEAR(distance(&ca, &from_product), 0, 2e-15);
        orr_vec3 v = random_unit(k + 2000), direct = orr_mat3_apply(&ca, v);
        orr_vec3 back = orr_mat3_apply_t(&ca, direct);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(back, v)), 0, 2e-15);
        // A v = q* v q
        orr_quat c = {q_ba.w, -q_ba.x, -q_ba.y, -q_ba.z};
        orr_quat r = orr_quat_mul(orr_quat_mul(c, (orr_quat){0, v.x, v.y, v.z}), q_ba);
        orr_vec3 w = orr_mat3_apply(&ba, v);
        ASSERT_NEAR(fabs(r.x - w.x) + fabs(r.y - w.y) + fabs(r.z - w.z) + fabs(r.w), 0, 2e-15);
    }
    orr_quat zero = orr_quat_unit((orr_quat){0, 0, 0, 0});
    assert_true(zero.w == 1);
    assert_true(orr_vec3_norm(orr_vec3_unit((orr_vec3){0, 0, 0})) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elementary_rotations_are_passive),
        cmocka_unit_test(hat_is_minus_the_cross_product),
        cmocka_unit_test(rotation_vectors_there_and_back),
        cmocka_unit_test(rotation_by_pi_has_one_of_its_two_vectors),
        cmocka_unit_test(rotation_vector_solves_its_equation),
        cmocka_unit_test(an_inverse_solves_its_equation),
        cmocka_unit_test(quaternions_are_the_same_rotations),
        cmocka_unit_test(products_follow_the_way_of_the_frames),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

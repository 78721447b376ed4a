// SPDX-License-Identifier: GPL-3.0-or-later
// Three-vectors, 3x3 matrices, quaternions: plain values, the small operations inline. Matrices are row-major
// m[row][col] and act on columns, z = A x. A matrix named A_ba (or R_itrs_gcrs) maps components in the older
// frame a into the newer frame b (passive), as the source's do.
#ifndef ORR_CORE_VEC_H
#define ORR_CORE_VEC_H

#include <math.h>

#include "core/constants.h"

typedef struct orr_vec3 {
    double x, y, z;
} orr_vec3;
typedef struct orr_mat3 {
    double m[3][3];
} orr_mat3;
typedef struct orr_quat { // Hamilton convention, unit norm for rotations
    double w, x, y, z;
} orr_quat;

// (x, y, z)
static inline orr_vec3 orr_vec3_make(double x, double y, double z)
{
    orr_vec3 v = {x, y, z};
    return v;
}
// a + b
static inline orr_vec3 orr_vec3_add(orr_vec3 a, orr_vec3 b)
{
    return (orr_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}
// a - b
static inline orr_vec3 orr_vec3_sub(orr_vec3 a, orr_vec3 b)
{
    return (orr_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}
// k a
static inline orr_vec3 orr_vec3_scale(double k, orr_vec3 a) { return (orr_vec3){k * a.x, k * a.y, k * a.z}; }
// a + k b
static inline orr_vec3 orr_vec3_axpy(double k, orr_vec3 b, orr_vec3 a)
{
    return (orr_vec3){a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
}
// The scalar product of a and b.
static inline double orr_vec3_dot(orr_vec3 a, orr_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
// The vector product a x b.
static inline orr_vec3 orr_vec3_cross(orr_vec3 a, orr_vec3 b)
{
    return (orr_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// |a|
static inline double orr_vec3_norm(orr_vec3 a) { return sqrt(orr_vec3_dot(a, a)); }
// Unit vector along a; a itself where its length is zero.
static inline orr_vec3 orr_vec3_unit(orr_vec3 a)
{
    double n = orr_vec3_norm(a);
    return n > 0 ? orr_vec3_scale(1.0 / n, a) : a;
}

// The unit matrix.
static inline orr_mat3 orr_mat3_identity(void)
{
    orr_mat3 e = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    return e;
}
// a v
static inline orr_vec3 orr_mat3_apply(const orr_mat3 *a, orr_vec3 v)
{
    return (orr_vec3){a->m[0][0] * v.x + a->m[0][1] * v.y + a->m[0][2] * v.z,
                      a->m[1][0] * v.x + a->m[1][1] * v.y + a->m[1][2] * v.z,
                      a->m[2][0] * v.x + a->m[2][1] * v.y + a->m[2][2] * v.z};
}
// transpose(a) v
static inline orr_vec3 orr_mat3_apply_t(const orr_mat3 *a, orr_vec3 v)
{
    return (orr_vec3){a->m[0][0] * v.x + a->m[1][0] * v.y + a->m[2][0] * v.z,
                      a->m[0][1] * v.x + a->m[1][1] * v.y + a->m[2][1] * v.z,
                      a->m[0][2] * v.x + a->m[1][2] * v.y + a->m[2][2] * v.z};
}
// a b
static inline orr_mat3 orr_mat3_mul(const orr_mat3 *a, const orr_mat3 *b)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c.m[i][j] = a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] + a->m[i][2] * b->m[2][j];
    return c;
}
// transpose(a)
static inline orr_mat3 orr_mat3_transpose(const orr_mat3 *a)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) c.m[i][j] = a->m[j][i];
    return c;
}
// a + b
static inline orr_mat3 orr_mat3_add(const orr_mat3 *a, const orr_mat3 *b)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) c.m[i][j] = a->m[i][j] + b->m[i][j];
    return c;
}
// k a
static inline orr_mat3 orr_mat3_scale(double k, const orr_mat3 *a)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) c.m[i][j] = k * a->m[i][j];
    return c;
}
// The source's hat: hat(w) = [0 w3 -w2; -w3 0 w1; w2 -w1 0] = -[w x], so that dA/dt = hat(w) A (Bogdanov
// 2015, eq. (1)).
static inline orr_mat3 orr_mat3_hat(orr_vec3 w)
{
    return (orr_mat3){{{0, w.z, -w.y}, {-w.z, 0, w.x}, {w.y, -w.x, 0}}};
}
// The inverse of a, by cofactors; not finite where a is singular.
orr_mat3 orr_mat3_inverse(const orr_mat3 *a);
// x of a x = v by Cramer's rule; not finite where a is singular.
orr_vec3 orr_mat3_solve(const orr_mat3 *a, orr_vec3 v);
// The passive rotation about axis 1 by an angle in radians, as ERFA's eraRx: [1 0 0; 0 c s; 0 -s c] with c = cos a,
// s = sin a.
orr_mat3 orr_mat3_rot1(double a_rad);
// About axis 2, as eraRy: [c 0 -s; 0 1 0; s 0 c].
orr_mat3 orr_mat3_rot2(double a_rad);
// About axis 3, as eraRz: [c s 0; -s c 0; 0 0 1].
orr_mat3 orr_mat3_rot3(double a_rad);
// C1(g) = E + sin|g|/|g| hat(g) + (1 - cos|g|)/|g|^2 hat(g)^2, the exact step of dA/dt = hat(w) A for g = w
// dt (Bogdanov 2015, eq. (2)); a series for small |g|.
orr_mat3 orr_mat3_from_rotvec(orr_vec3 g);
// The rotation vector g with |g| <= pi whose orr_mat3_from_rotvec is a; good near 0 and near pi too.
orr_vec3 orr_rotvec_from_mat3(const orr_mat3 *a);

// Quaternions of passive rotations: A_ba = orr_mat3_from_quat(q_ba), of which q and -q are the same. q must
// be of unit length.
orr_mat3 orr_mat3_from_quat(orr_quat q);
// One of the two unit quaternions of the rotation a.
orr_quat orr_quat_from_mat3(const orr_mat3 *a);
// Hamilton's product a b. Of passive rotations it reads from the first to the last: with A_ba of q_ba and
// A_cb of q_cb, orr_quat_mul(q_ba, q_cb) is the quaternion of A_ca = A_cb A_ba.
orr_quat orr_quat_mul(orr_quat a, orr_quat b);
// q / |q|.
orr_quat orr_quat_unit(orr_quat q);
// The scalar product of the four components.
double orr_quat_dot(orr_quat a, orr_quat b);
// -q, the same rotation.
orr_quat orr_quat_neg(orr_quat q);
// The quaternion of orr_mat3_from_rotvec(g).
orr_quat orr_quat_from_rotvec(orr_vec3 g);

#endif

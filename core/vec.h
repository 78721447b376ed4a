// SPDX-License-Identifier: GPL-3.0-or-later
// Three-vectors, 3x3 matrices, quaternions: plain values, the small operations inline. Matrices are row-major
// m[row][col] and act on columns, z = A x. A matrix named A_ba (or R_itrs_gcrs) maps components in the older
// frame a into the newer frame b (passive), as the source's do.
#ifndef ORR_CORE_VEC_H
#define ORR_CORE_VEC_H

#include <math.h>

typedef struct orr_vec3 {
    double x, y, z;
} orr_vec3;
typedef struct orr_mat3 {
    double m[3][3];
} orr_mat3;
typedef struct orr_quat { // Hamilton convention, unit norm for rotations
    double w, x, y, z;
} orr_quat;

#define ORR_PI 3.14159265358979323846
#define ORR_RAD_PER_DEG (ORR_PI / 180.0)
#define ORR_DEG_PER_RAD (180.0 / ORR_PI)

static inline orr_vec3 orr_vec3_make(double x, double y, double z) { return (orr_vec3){x, y, z}; }
static inline orr_vec3 orr_vec3_add(orr_vec3 a, orr_vec3 b)
{
    return (orr_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline orr_vec3 orr_vec3_sub(orr_vec3 a, orr_vec3 b)
{
    return (orr_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline orr_vec3 orr_vec3_scale(double k, orr_vec3 a) { return (orr_vec3){k * a.x, k * a.y, k * a.z}; }
// a + k b
static inline orr_vec3 orr_vec3_axpy(double k, orr_vec3 b, orr_vec3 a)
{
    return (orr_vec3){a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
}
static inline double orr_vec3_dot(orr_vec3 a, orr_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline orr_vec3 orr_vec3_cross(orr_vec3 a, orr_vec3 b)
{
    return (orr_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double orr_vec3_norm(orr_vec3 a) { return sqrt(orr_vec3_dot(a, a)); }
// Unit vector along a; a itself where its length is zero.
static inline orr_vec3 orr_vec3_unit(orr_vec3 a)
{
    double n = orr_vec3_norm(a);
    return n > 0 ? orr_vec3_scale(1.0 / n, a) : a;
}

static inline orr_mat3 orr_mat3_identity(void) { return (orr_mat3){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
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
static inline orr_mat3 orr_mat3_mul(const orr_mat3 *a, const orr_mat3 *b)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c.m[i][j] = a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] + a->m[i][2] * b->m[2][j];
    return c;
}
static inline orr_mat3 orr_mat3_transpose(const orr_mat3 *a)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) c.m[i][j] = a->m[j][i];
    return c;
}
static inline orr_mat3 orr_mat3_add(const orr_mat3 *a, const orr_mat3 *b)
{
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) c.m[i][j] = a->m[i][j] + b->m[i][j];
    return c;
}
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
// Passive rotations about axis 1, 2, 3 by angle (rad), as ERFA's eraRx/eraRy/eraRz: R3(a) = [c s 0; -s c 0; 0
// 0 1].
orr_mat3 orr_mat3_rot1(double a_rad);
orr_mat3 orr_mat3_rot2(double a_rad);
orr_mat3 orr_mat3_rot3(double a_rad);
// C1(g) = E + sin|g|/|g| hat(g) + (1-cos|g|)/|g|^2 hat(g)^2, the exact step of dA/dt = hat(w) A for g = w dt
// (Bogdanov 2015, eq. (2)); series for small |g|.
orr_mat3 orr_mat3_from_rotvec(orr_vec3 g);
// The g of the above with |g| <= pi; robust near 0 and near pi.
orr_vec3 orr_rotvec_from_mat3(const orr_mat3 *a);

// Quaternion of the same passive matrix: A = orr_mat3_from_quat(q). Product order is the matrices':
// mat(q_cb (x) q_ba) ... orr_quat_mul(q_ba, q_cb) gives A_cb A_ba = A_ca (stated and tested in the unit
// test).
orr_quat orr_quat_from_mat3(const orr_mat3 *a);
orr_mat3 orr_mat3_from_quat(orr_quat q);
orr_quat orr_quat_mul(orr_quat a, orr_quat b); // Hamilton product
orr_quat orr_quat_unit(orr_quat q);
double orr_quat_dot(orr_quat a, orr_quat b);
orr_quat orr_quat_neg(orr_quat q);
orr_quat orr_quat_from_rotvec(orr_vec3 g); // of orr_mat3_from_rotvec(g)

#endif

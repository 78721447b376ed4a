// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vec.h"

orr_mat3 orr_mat3_rot1(double a_rad)
{
    double c = cos(a_rad), s = sin(a_rad);
    return (orr_mat3){{{1, 0, 0}, {0, c, s}, {0, -s, c}}};
}

orr_mat3 orr_mat3_rot2(double a_rad)
{
    double c = cos(a_rad), s = sin(a_rad);
    return (orr_mat3){{{c, 0, -s}, {0, 1, 0}, {s, 0, c}}};
}

orr_mat3 orr_mat3_rot3(double a_rad)
{
    double c = cos(a_rad), s = sin(a_rad);
    return (orr_mat3){{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
}

orr_mat3 orr_mat3_inverse(const orr_mat3 *a)
{
    const double(*m)[3] = a->m;
    orr_mat3 c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int k = (i + 1) % 3, l = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
            c.m[j][i] = m[k][p] * m[l][q] - m[k][q] * m[l][p];
        }
    double det = m[0][0] * c.m[0][0] + m[0][1] * c.m[1][0] + m[0][2] * c.m[2][0];
    return orr_mat3_scale(1.0 / det, &c);
}

orr_vec3 orr_mat3_solve(const orr_mat3 *a, orr_vec3 v)
{
    orr_vec3 x = {a->m[0][0], a->m[1][0], a->m[2][0]}, y = {a->m[0][1], a->m[1][1], a->m[2][1]},
             z = {a->m[0][2], a->m[1][2], a->m[2][2]};
    orr_vec3 yz = orr_vec3_cross(y, z);
    double det = orr_vec3_dot(x, yz);
    return orr_vec3_make(orr_vec3_dot(v, yz) / det, orr_vec3_dot(x, orr_vec3_cross(v, z)) / det,
                         orr_vec3_dot(x, orr_vec3_cross(y, v)) / det);
}

// sin(x)/x. The series is used below |x| = 0.03, where its first omitted term x^8/9! is under 2e-18.
static double sinc(double x)
{
    double q = x * x;
    if (q > 1e-3) return sin(x) / x;
    return 1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0));
}

orr_mat3 orr_mat3_from_rotvec(orr_vec3 g)
{
    double n = orr_vec3_norm(g), half = sinc(0.5 * n);
    double s = sinc(n), c = 0.5 * half * half; // (1 - cos n)/n^2 without the cancellation
    // hat(g)^2 = g g' - |g|^2 E
    double d = 1.0 - c * n * n;
    return (orr_mat3){{{d + c * g.x * g.x, c * g.x * g.y + s * g.z, c * g.x * g.z - s * g.y},
                       {c * g.y * g.x - s * g.z, d + c * g.y * g.y, c * g.y * g.z + s * g.x},
                       {c * g.z * g.x + s * g.y, c * g.z * g.y - s * g.x, d + c * g.z * g.z}}};
}

// Shepperd's choice of the largest component keeps every division well away from zero, near pi too.
orr_quat orr_quat_from_mat3(const orr_mat3 *a)
{
    const double(*m)[3] = a->m;
    double t = m[0][0] + m[1][1] + m[2][2];
    orr_quat q;
    if (t >= m[0][0] && t >= m[1][1] && t >= m[2][2]) {
        q = (orr_quat){1.0 + t, m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]};
    } else if (m[0][0] >= m[1][1] && m[0][0] >= m[2][2]) {
        q = (orr_quat){m[1][2] - m[2][1], 1.0 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0],
                       m[0][2] + m[2][0]};
    } else if (m[1][1] >= m[2][2]) {
        q = (orr_quat){m[2][0] - m[0][2], m[0][1] + m[1][0], 1.0 + m[1][1] - m[0][0] - m[2][2],
                       m[1][2] + m[2][1]};
    } else {
        q = (orr_quat){m[0][1] - m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1],
                       1.0 + m[2][2] - m[0][0] - m[1][1]};
    }
    q = orr_quat_unit(q);
    return q.w < 0 ? orr_quat_neg(q) : q;
}

orr_mat3 orr_mat3_from_quat(orr_quat q)
{
    double w = q.w, x = q.x, y = q.y, z = q.z;
    return (orr_mat3){{{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
                       {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
                       {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}};
}

orr_vec3 orr_rotvec_from_mat3(const orr_mat3 *a)
{
    orr_quat q = orr_quat_from_mat3(a); // w >= 0, hence an angle of at most pi
    orr_vec3 v = {q.x, q.y, q.z};
    double n = orr_vec3_norm(v);
    // 2 atan(n/w)/n -> 2/w as n -> 0; at 1e-9 the next term is below the rounding
    double k = n > 1e-9 ? 2.0 * atan2(n, q.w) / n : 2.0 / q.w;
    return orr_vec3_scale(k, v);
}

orr_quat orr_quat_mul(orr_quat a, orr_quat b)
{
    return (orr_quat){
        a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

orr_quat orr_quat_unit(orr_quat q)
{
    double n = sqrt(orr_quat_dot(q, q));
    if (!(n > 0)) return (orr_quat){1, 0, 0, 0};
    return (orr_quat){q.w / n, q.x / n, q.y / n, q.z / n};
}

double orr_quat_dot(orr_quat a, orr_quat b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }
orr_quat orr_quat_neg(orr_quat q) { return (orr_quat){-q.w, -q.x, -q.y, -q.z}; }

orr_quat orr_quat_from_rotvec(orr_vec3 g)
{
    double half = 0.5 * orr_vec3_norm(g), k = 0.5 * sinc(half);
    return (orr_quat){cos(half), k * g.x, k * g.y, k * g.z};
}

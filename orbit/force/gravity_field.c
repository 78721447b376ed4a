// SPDX-License-Identifier: GPL-3.0-or-later
// Gravitation of the Earth in spherical harmonics, by Cunningham's recursions in Cartesian coordinates
// (Montenbruck & Gill, Satellite Orbits, 3.2.4), and the coefficients of EGM96 to degree and order 12.
#include "orbit/force/gravity_field.h"

#include <math.h>

// Fully normalised, tide-free (Lemoine et al. 1998, NASA/TP-1998-206861).
static const struct {
    int n, m;
    double c, s;
} egm96[] = {
    // clang-format off
    {2, 0, -0.484165371736e-03, 0.000000000000e+00},
    {2, 1, -0.186987635955e-09, 0.119528012031e-08},
    {2, 2, 0.243914352398e-05, -0.140016683654e-05},
    {3, 0, 0.957254173792e-06, 0.000000000000e+00},
    {3, 1, 0.202998882184e-05, 0.248513158716e-06},
    {3, 2, 0.904627768605e-06, -0.619025944205e-06},
    {3, 3, 0.721072657057e-06, 0.141435626958e-05},
    {4, 0, 0.539873863789e-06, 0.000000000000e+00},
    {4, 1, -0.536321616971e-06, -0.473440265853e-06},
    {4, 2, 0.350694105785e-06, 0.662671572540e-06},
    {4, 3, 0.990771803829e-06, -0.200928369177e-06},
    {4, 4, -0.188560802735e-06, 0.308853169333e-06},
    {5, 0, 0.685323475630e-07, 0.000000000000e+00},
    {5, 1, -0.621012128528e-07, -0.944226127525e-07},
    {5, 2, 0.652438297612e-06, -0.323349612668e-06},
    {5, 3, -0.451955406071e-06, -0.214847190624e-06},
    {5, 4, -0.295301647654e-06, 0.496658876769e-07},
    {5, 5, 0.174971983203e-06, -0.669384278219e-06},
    {6, 0, -0.149957994714e-06, 0.000000000000e+00},
    {6, 1, -0.760879384947e-07, 0.262890545501e-07},
    {6, 2, 0.481732442832e-07, -0.373728201347e-06},
    {6, 3, 0.571730990516e-07, 0.902694517163e-08},
    {6, 4, -0.862142660109e-07, -0.471408154267e-06},
    {6, 5, -0.267133325490e-06, -0.536488432483e-06},
    {6, 6, 0.967616121092e-08, -0.237192006935e-06},
    {7, 0, 0.909789371450e-07, 0.000000000000e+00},
    {7, 1, 0.279872910488e-06, 0.954336911867e-07},
    {7, 2, 0.329743816488e-06, 0.930667596042e-07},
    {7, 3, 0.250398657706e-06, -0.217198608738e-06},
    {7, 4, -0.275114355257e-06, -0.123800392323e-06},
    {7, 5, 0.193765507243e-08, 0.177377719872e-07},
    {7, 6, -0.358856860645e-06, 0.151789817739e-06},
    {7, 7, 0.109185148045e-08, 0.244415707993e-07},
    {8, 0, 0.496711667324e-07, 0.000000000000e+00},
    {8, 1, 0.233422047893e-07, 0.590060493411e-07},
    {8, 2, 0.802978722615e-07, 0.654175425859e-07},
    {8, 3, -0.191877757009e-07, -0.863454445021e-07},
    {8, 4, -0.244600105471e-06, 0.700233016934e-07},
    {8, 5, -0.255352403037e-07, 0.891462164788e-07},
    {8, 6, -0.657361610961e-07, 0.309238461807e-06},
    {8, 7, 0.672811580072e-07, 0.747440473633e-07},
    {8, 8, -0.124092493016e-06, 0.120533165603e-06},
    {9, 0, 0.276714300853e-07, 0.000000000000e+00},
    {9, 1, 0.143387502749e-06, 0.216834947618e-07},
    {9, 2, 0.222288318564e-07, -0.322196647116e-07},
    {9, 3, -0.160811502143e-06, -0.742287409462e-07},
    {9, 4, -0.900179225336e-08, 0.194666779475e-07},
    {9, 5, -0.166165092924e-07, -0.541113191483e-07},
    {9, 6, 0.626941938248e-07, 0.222903525945e-06},
    {9, 7, -0.118366323475e-06, -0.965152667886e-07},
    {9, 8, 0.188436022794e-06, -0.308566220421e-08},
    {9, 9, -0.477475386132e-07, 0.966412847714e-07},
    {10, 0, 0.526222488569e-07, 0.000000000000e+00},
    {10, 1, 0.835115775652e-07, -0.131314331796e-06},
    {10, 2, -0.942413882081e-07, -0.515791657390e-07},
    {10, 3, -0.689895048176e-08, -0.153768828694e-06},
    {10, 4, -0.840764549716e-07, -0.792806255331e-07},
    {10, 5, -0.493395938185e-07, -0.505370221897e-07},
    {10, 6, -0.375885236598e-07, -0.795667053872e-07},
    {10, 7, 0.811460540925e-08, -0.336629641314e-08},
    {10, 8, 0.404927981694e-07, -0.918705975922e-07},
    {10, 9, 0.125491334939e-06, -0.376516222392e-07},
    {10, 10, 0.100538634409e-06, -0.240148449520e-07},
    {11, 0, -0.509613707522e-07, 0.000000000000e+00},
    {11, 1, 0.151687209933e-07, -0.268604146166e-07},
    {11, 2, 0.186309749878e-07, -0.990693862047e-07},
    {11, 3, -0.309871239854e-07, -0.148131804260e-06},
    {11, 4, -0.389580205051e-07, -0.636666511980e-07},
    {11, 5, 0.377848029452e-07, 0.494736238169e-07},
    {11, 6, -0.118676592395e-08, 0.344769584593e-07},
    {11, 7, 0.411565188074e-08, -0.898252808977e-07},
    {11, 8, -0.598410841300e-08, 0.243989612237e-07},
    {11, 9, -0.314231072723e-07, 0.417731829829e-07},
    {11, 10, -0.521882681927e-07, -0.183364561788e-07},
    {11, 11, 0.460344448746e-07, -0.696662308185e-07},
    {12, 0, 0.377252636558e-07, 0.000000000000e+00},
    {12, 1, -0.540654977836e-07, -0.435675748979e-07},
    {12, 2, 0.142979642253e-07, 0.320975937619e-07},
    {12, 3, 0.393995876403e-07, 0.244264863505e-07},
    {12, 4, -0.686908127934e-07, 0.415081109011e-08},
    {12, 5, 0.309411128730e-07, 0.782536279033e-08},
    {12, 6, 0.341523275208e-08, 0.391765484449e-07},
    {12, 7, -0.186909958587e-07, 0.356131849382e-07},
    {12, 8, -0.253769398865e-07, 0.169361024629e-07},
    {12, 9, 0.422880630662e-07, 0.252692598301e-07},
    {12, 10, -0.617619654902e-08, 0.308375794212e-07},
    {12, 11, 0.112502994122e-07, -0.637946501558e-08},
    {12, 12, -0.249532607390e-08, -0.111780601900e-07},
    // clang-format on
};

// Normalised to plain: N = sqrt((2 - d0m)(2n + 1)(n - m)!/(n + m)!).
static double normalisation(int n, int m)
{
    double ratio = 1.0;
    for (int k = n - m + 1; k <= n + m; k++) ratio /= (double)k;
    return sqrt((m == 0 ? 1.0 : 2.0) * (2.0 * n + 1.0) * ratio);
}

orr_status orr_gravity_field_init(orr_gravity_field *f, int degree, bool zonal_only, orr_diag *diag)
{
    if (degree < 0 || degree > ORR_GRAVITY_MAX_DEGREE)
        return orr_diag_set(diag, ORR_E_ARG, "gravity degree %d is not in 0..%d", degree,
                            ORR_GRAVITY_MAX_DEGREE);
    *f = (orr_gravity_field){.degree = degree, .order = zonal_only ? 0 : degree};
    f->c[0][0] = 1.0;
    for (int n = 2; n <= degree + 1; n++)
        for (int m = 0; m <= n - 2; m++) {
            f->first[n][m] = (2.0 * n - 1) / (n - m);
            f->second[n][m] = (n + m - 1.0) / (n - m);
        }
    for (size_t i = 0; i < sizeof egm96 / sizeof egm96[0]; i++) {
        int n = egm96[i].n, m = egm96[i].m;
        if (n > degree || m > f->order) continue;
        double scale = normalisation(n, m);
        f->c[n][m] = egm96[i].c * scale;
        f->s[n][m] = egm96[i].s * scale;
    }
    return ORR_OK;
}

#define ROW (ORR_GRAVITY_MAX_DEGREE + 2)

// Cunningham's V and W one degree and order further than the field; row n holds m = 0..n. Row by row, so that a compiler
// may put neighbouring orders into vectors.
static void solid_harmonics(const orr_gravity_field *f, orr_vec3 r, double v[ROW][ROW], double w[ROW][ROW])
{
    const double re = ORR_EGM96_RADIUS_M, r2 = orr_vec3_dot(r, r);
    const double x0 = re * r.x / r2, y0 = re * r.y / r2, z0 = re * r.z / r2, rho = re * re / r2;
    const int top = f->degree + 1, last = f->order + 1;
    v[0][0] = re / sqrt(r2);
    w[0][0] = 0.0;
    for (int n = 1; n <= top; n++) {
        const double odd = 2 * n - 1;
        const int inner = n - 2 < last ? n - 2 : last;
        for (int m = 0; m <= inner; m++) {
            const double a = f->first[n][m] * z0, b = f->second[n][m] * rho;
            v[n][m] = a * v[n - 1][m] - b * v[n - 2][m];
            w[n][m] = a * w[n - 1][m] - b * w[n - 2][m];
        }
        if (n - 1 <= last) {
            v[n][n - 1] = odd * z0 * v[n - 1][n - 1];
            w[n][n - 1] = odd * z0 * w[n - 1][n - 1];
        }
        if (n <= last) {
            v[n][n] = odd * (x0 * v[n - 1][n - 1] - y0 * w[n - 1][n - 1]);
            w[n][n] = odd * (x0 * w[n - 1][n - 1] + y0 * v[n - 1][n - 1]);
        }
    }
}

// Adds what coefficients c, s of degree n and orders 0..order give, by order: x, y and z of sum[m].
static void add_degree(int n, int order, const double *c, const double *s, double v[ROW][ROW],
                       double w[ROW][ROW], double sum[3][ROW])
{
    const double *vn = v[n + 1], *wn = w[n + 1];
    sum[0][0] -= c[0] * vn[1];
    sum[1][0] -= c[0] * wn[1];
    sum[2][0] -= (n + 1) * c[0] * vn[0];
    for (int m = 1; m <= order; m++) {
        const double z = n - m + 1, k = z * (z + 1);
        sum[0][m] += 0.5 * (-c[m] * vn[m + 1] - s[m] * wn[m + 1] + k * (c[m] * vn[m - 1] + s[m] * wn[m - 1]));
        sum[1][m] +=
            0.5 * (-c[m] * wn[m + 1] + s[m] * vn[m + 1] + k * (-c[m] * wn[m - 1] + s[m] * vn[m - 1]));
        sum[2][m] += z * (-c[m] * vn[m] - s[m] * wn[m]);
    }
}

// tide: changes of C20, C21, S21, C22, S22, or NULL.
static orr_vec3 gravitation(const orr_gravity_field *f, const double *tide, orr_vec3 r)
{
    double r2 = orr_vec3_dot(r, r), v[ROW][ROW], w[ROW][ROW], sum[3][ROW] = {{0}};
    if (f->degree < 2) return orr_vec3_scale(-ORR_EGM96_GM / (r2 * sqrt(r2)), r);
    solid_harmonics(f, r, v, w);
    if (tide != NULL) {
        const double c[3] = {tide[0], tide[1], tide[3]}, s[3] = {0, tide[2], tide[4]};
        add_degree(2, f->order < 2 ? f->order : 2, c, s, v, w, sum);
    }
    for (int n = f->degree; n >= 0; n--) // small terms first
        if (n != 1) add_degree(n, n < f->order ? n : f->order, f->c[n], f->s[n], v, w, sum);
    orr_vec3 a = {0, 0, 0};
    for (int m = f->order; m >= 0; m--) a = orr_vec3_add(a, orr_vec3_make(sum[0][m], sum[1][m], sum[2][m]));
    return orr_vec3_scale(ORR_EGM96_GM / (ORR_EGM96_RADIUS_M * ORR_EGM96_RADIUS_M), a);
}

orr_vec3 orr_gravity_field_gravitation(const orr_gravity_field *f, orr_vec3 r)
{
    return gravitation(f, NULL, r);
}

orr_vec3 orr_gravity_field_with_tide(const orr_gravity_field *f, const double tide[5], orr_vec3 r)
{
    return gravitation(f, tide, r);
}

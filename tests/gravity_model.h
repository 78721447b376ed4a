// SPDX-License-Identifier: GPL-3.0-or-later
// Makes gravity models in GeographicLib's file format (its documentation, "Gravity models") from coefficients
// that a test computes or reads.
#ifndef ORR_TESTS_GRAVITY_MODEL_H
#define ORR_TESTS_GRAVITY_MODEL_H

#include "testing.h"

#define TEST_MODEL_MAX_DEGREE 64

// Fully normalised coefficients of degree n and order m <= n; that of degree 0 is 1 and not among them.
typedef struct test_model {
    int degree;
    double gm_m3ps2, radius_m;
    double c[TEST_MODEL_MAX_DEGREE + 1][TEST_MODEL_MAX_DEGREE + 1],
        s[TEST_MODEL_MAX_DEGREE + 1][TEST_MODEL_MAX_DEGREE + 1];
} test_model;

static inline FILE *test_model_file(const char *dir, const char *name, const char *end)
{
    char path[400];
    snprintf(path, sizeof path, "%s/%s%s", dir, name, end);
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    return f;
}

// <dir>/<name>.egm and .egm.cof; the reference ellipsoid of the metadata is WGS 84 and does not matter to the
// series.
static inline void test_model_write(const char *dir, const char *name, const test_model *m)
{
    FILE *f = test_model_file(dir, name, ".egm");
    fprintf(f,
            "EGMF-1\nName orrtest\nPublisher test\nReleaseDate 2024-01-01\nDataVersion 1\nModelRadius %.17g\n"
            "ModelMass %.17g\nAngularVelocity 7.292115e-5\nReferenceRadius 6378137\n"
            "ReferenceMass 3.986004418e14\nFlattening 1/298.257223563\nHeightOffset 0\n"
            "CorrectionMultiplier 1\nNormalization full\nID ORRTEST1\n",
            m->radius_m, m->gm_m3ps2);
    fclose(f);
    f = test_model_file(dir, name, ".egm.cof");
    fwrite("ORRTEST1", 1, 8, f);
    int32_t size[2] = {m->degree, m->degree}, none[2] = {-1, -1};
    fwrite(size, sizeof size, 1, f);
    // columns by order; cosines then sines (those of order 0 are left out)
    for (int o = 0; o <= m->degree; o++)
        for (int n = o; n <= m->degree; n++) {
            double c = n == 0 ? 0.0 : m->c[n][o];
            fwrite(&c, sizeof c, 1, f);
        }
    for (int o = 1; o <= m->degree; o++)
        for (int n = o; n <= m->degree; n++) fwrite(&m->s[n][o], sizeof(double), 1, f);
    fwrite(none, sizeof none, 1, f);
    fclose(f);
}

static inline void test_model_remove(const char *dir, const char *name)
{
    char path[400];
    snprintf(path, sizeof path, "%s/%s.egm", dir, name);
    remove(path);
    snprintf(path, sizeof path, "%s/%s.egm.cof", dir, name);
    remove(path);
}

// The field of an ellipsoid of revolution that is level under its own pull and turning: zonals alone, from
// J2 and e^2 (Heiskanen and Moritz 1967, eq. 2-92: J_2n = (-1)^(n+1) 3 e^2n / ((2n+1)(2n+3)) (1 - n + 5 n
// J2/e^2)).
static inline double test_zonal(int n, double e2, double j2)
{
    return (n % 2 == 0 ? -1.0 : 1.0) * 3.0 * pow(e2, n) / ((2.0 * n + 1.0) * (2.0 * n + 3.0)) *
           (1.0 - n + 5.0 * n * j2 / e2);
}

static inline void test_model_zonals(test_model *m, double gm_m3ps2, double a_m, double e2, double j2,
                                     int degree)
{
    *m = (test_model){.degree = degree, .gm_m3ps2 = gm_m3ps2, .radius_m = a_m};
    for (int n = 1; 2 * n <= degree; n++) m->c[2 * n][0] = -test_zonal(n, e2, j2) / sqrt(4.0 * n + 1.0);
}

#endif

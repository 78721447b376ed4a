// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <math.h>

static orr_status status_of(int gsl) { return gsl == GSL_SUCCESS ? ORR_OK : ORR_E_NUMERIC; }

orr_status orr_cholesky_factor(double *a, size_t n, double least_pivot)
{
    if (n == 0) return ORR_OK;
    double top = 0;
    for (size_t i = 0; i < n; i++) {
        if (!(a[i * n + i] > 0)) return ORR_E_NUMERIC; // not a number among them: GSL would go on with it
        top = fmax(top, a[i * n + i]);
    }
    gsl_matrix_view m = gsl_matrix_view_array(a, n, n);
    if (gsl_linalg_cholesky_decomp1(&m.matrix) != GSL_SUCCESS) return ORR_E_NUMERIC;
    for (size_t i = 0; i < n; i++)
        if (!(a[i * n + i] * a[i * n + i] > least_pivot * top)) return ORR_E_NUMERIC;
    return ORR_OK;
}

orr_status orr_cholesky_solve(const double *l, size_t n, double *x)
{
    if (n == 0) return ORR_OK;
    gsl_matrix_const_view m = gsl_matrix_const_view_array(l, n, n);
    gsl_vector_view v = gsl_vector_view_array(x, n);
    return status_of(gsl_linalg_cholesky_svx(&m.matrix, &v.vector));
}

orr_status orr_cholesky_solve_lower(const double *l, size_t n, double *x)
{
    if (n == 0) return ORR_OK;
    gsl_matrix_const_view m = gsl_matrix_const_view_array(l, n, n);
    gsl_vector_view v = gsl_vector_view_array(x, n);
    return status_of(gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, &m.matrix, &v.vector));
}

orr_status orr_cholesky_invert(double *l, size_t n)
{
    if (n == 0) return ORR_OK;
    gsl_matrix_view m = gsl_matrix_view_array(l, n, n);
    return status_of(gsl_linalg_cholesky_invert(&m.matrix));
}

orr_status orr_symmetric_solve(double *a, size_t stride, size_t n, double *b, size_t columns)
{
    double scale[ORR_SYMMETRIC_MOST];
    if (n > ORR_SYMMETRIC_MOST) return ORR_E_ARG;
    if (n == 0 || columns == 0) return ORR_OK;
    for (size_t i = 0; i < n; i++) {
        if (!(a[i * stride + i] > 0)) return ORR_E_NUMERIC;
        scale[i] = 1 / sqrt(a[i * stride + i]);
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j <= i; j++) a[i * stride + j] *= scale[i] * scale[j];
        for (size_t c = 0; c < columns; c++) b[i * columns + c] *= scale[i];
    }
    gsl_matrix_view m = gsl_matrix_view_array_with_tda(a, n, n, stride);
    gsl_matrix_view x = gsl_matrix_view_array(b, n, columns);
    if (gsl_linalg_cholesky_decomp1(&m.matrix) != GSL_SUCCESS) return ORR_E_NUMERIC;
    for (size_t i = 0; i < n; i++)
        if (!(a[i * stride + i] * a[i * stride + i] > 1e-14)) return ORR_E_NUMERIC;
    gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1, &m.matrix, &x.matrix);
    gsl_blas_dtrsm(CblasLeft, CblasLower, CblasTrans, CblasNonUnit, 1, &m.matrix, &x.matrix);
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < columns; c++) b[i * columns + c] *= scale[i];
    return ORR_OK;
}

orr_status orr_band_factor(double *a, size_t n, size_t band)
{
    if (n == 0) return ORR_OK;
    gsl_matrix_view m = gsl_matrix_view_array(a, n, band + 1);
    if (gsl_linalg_cholesky_band_decomp(&m.matrix) != GSL_SUCCESS) return ORR_E_NUMERIC;
    for (size_t i = 0; i < n; i++)
        if (!(a[i * (band + 1)] > 0)) return ORR_E_NUMERIC;
    return ORR_OK;
}

orr_status orr_band_factored(const double *factor, size_t n, size_t band, double *x)
{
    if (n == 0) return ORR_OK;
    gsl_matrix_const_view m = gsl_matrix_const_view_array(factor, n, band + 1);
    gsl_vector_view v = gsl_vector_view_array(x, n);
    return status_of(gsl_linalg_cholesky_band_svx(&m.matrix, &v.vector));
}

orr_status orr_band_solve(double *a, size_t n, size_t band, double *x, size_t columns)
{
    if (n == 0 || columns == 0) return ORR_OK;
    const orr_status s = orr_band_factor(a, n, band);
    if (s != ORR_OK) return s;
    gsl_matrix_view m = gsl_matrix_view_array(a, n, band + 1), v = gsl_matrix_view_array(x, n, columns);
    return status_of(gsl_linalg_cholesky_band_svxm(&m.matrix, &v.matrix));
}

orr_status orr_least_squares(double *a, size_t rows, size_t n, double *b, double *tau, double *x)
{
    gsl_matrix_view m = gsl_matrix_view_array(a, rows, n);
    gsl_vector_view t = gsl_vector_view_array(tau, n), y = gsl_vector_view_array(b, rows);
    if (gsl_linalg_QR_decomp(&m.matrix, &t.vector) != GSL_SUCCESS ||
        gsl_linalg_QR_QTvec(&m.matrix, &t.vector, &y.vector) != GSL_SUCCESS)
        return ORR_E_NUMERIC;
    for (size_t i = n; i-- > 0 && x != NULL;) {
        x[i] = b[i];
        for (size_t j = i + 1; j < n; j++) x[i] -= a[i * n + j] * x[j];
        x[i] /= a[i * n + i];
        if (!isfinite(x[i])) return ORR_E_NUMERIC;
    }
    return ORR_OK;
}

orr_status orr_singular_values(double *a, size_t rows, size_t n, double *s, double *v)
{
    for (size_t k = 0; k < rows * n; k++)
        if (!isfinite(a[k])) return ORR_E_NUMERIC; // GSL would go on for ever
    gsl_matrix_view m = gsl_matrix_view_array(a, rows, n), w = gsl_matrix_view_array(v, n, n);
    gsl_vector_view d = gsl_vector_view_array(s, n);
    return status_of(gsl_linalg_SV_decomp_jacobi(&m.matrix, &w.matrix, &d.vector));
}

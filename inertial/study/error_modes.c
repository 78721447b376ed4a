// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/error_modes.h"

#include <gsl/gsl_eigen.h>
#include <math.h>
#include <string.h>

#include "core/nan.h"

enum { N = ORR_ERROR_STATES, HEIGHT = 2, CLIMB = 5 };

static void flatten(const orr_error_state *x, double v[N])
{
    const orr_vec3 part[3] = {x->position, x->velocity, x->attitude};
    for (int i = 0; i < 3; i++) {
        v[3 * i] = part[i].x;
        v[3 * i + 1] = part[i].y;
        v[3 * i + 2] = part[i].z;
    }
}

static orr_error_state unfold(const double v[N])
{
    return (orr_error_state){{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
}

// The matrix of phi's equations, column by column: they are linear. Units are such that its elements are of one size.
static size_t matrix(const orr_error_point *p, bool hold, double a[N * N])
{
    const double R = p->normal_m, unit[N] = {1, 1, R, R, R, R, 1, 1, 1};
    const orr_vec3 none = {0, 0, 0};
    size_t index[N], n = 0;
    for (size_t k = 0; k < N; k++)
        if (!hold || (k != HEIGHT && k != CLIMB)) index[n++] = k;
    for (size_t k = 0; k < n; k++) {
        double v[N] = {0}, d[N];
        v[index[k]] = unit[index[k]];
        const orr_error_state x = unfold(v), rate = orr_error_rate(ORR_ERROR_PHI, p, &x, none, none);
        flatten(&rate, d);
        for (size_t i = 0; i < n; i++) a[i * n + k] = d[index[i]] / unit[index[i]];
    }
    return n;
}

static orr_status eigenvalues(double *a, size_t n, orr_error_modes *out, orr_diag *diag)
{
    gsl_eigen_nonsymm_workspace *w = gsl_eigen_nonsymm_alloc(n);
    gsl_vector_complex *e = gsl_vector_complex_alloc(n);
    orr_status s = ORR_OK;
    if (w == NULL || e == NULL) {
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu eigenvalues", n);
    } else {
        gsl_matrix_view m = gsl_matrix_view_array(a, n, n);
        gsl_eigen_nonsymm_params(0, 1, w);
        if (gsl_eigen_nonsymm(&m.matrix, e, w) != 0)
            s = orr_diag_set(diag, ORR_E_NUMERIC, "no eigenvalues of the error equations were found");
    }
    for (size_t k = 0; k < n && s == ORR_OK; k++) {
        const gsl_complex z = gsl_vector_complex_get(e, k);
        size_t at = k;
        for (; at > 0 && out->imag[at - 1] < GSL_IMAG(z); at--) {
            out->real[at] = out->real[at - 1];
            out->imag[at] = out->imag[at - 1];
        }
        out->real[at] = GSL_REAL(z);
        out->imag[at] = GSL_IMAG(z);
    }
    if (w != NULL) gsl_eigen_nonsymm_free(w);
    if (e != NULL) gsl_vector_complex_free(e);
    return s;
}

orr_status orr_error_modes_at(const orr_error_point *p, bool hold_vertical, orr_error_modes *out,
                              orr_diag *diag)
{
    double a[N * N];
    memset(out, 0, sizeof *out);
    out->n = matrix(p, hold_vertical, a);
    const orr_status s = eigenvalues(a, out->n, out, diag);
    if (s != ORR_OK) return s;
    const double fast = out->imag[0], slow = out->imag[1], day = out->imag[2];
    if (!(day > 0.0))
        return orr_diag_set(diag, ORR_E_NUMERIC, "the error equations have no three pairs that swing here");
    out->schuler_s = 4.0 * ORR_PI / (fast + slow);
    out->foucault_s = fast - slow > 1e-9 * fast ? 4.0 * ORR_PI / (fast - slow) : ORR_NAN;
    out->earth_s = 2.0 * ORR_PI / day;
    double growth = 0.0;
    for (size_t k = 0; k < out->n; k++) growth = fmax(growth, out->real[k]);
    out->growth_s = hold_vertical ? ORR_NAN : 1.0 / growth;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/minimise.h"

#include <gsl/gsl_multimin.h>
#include <math.h>

typedef struct called {
    orr_function_of_many f;
    void *user;
} called;

static double call(const gsl_vector *x, void *user)
{
    const called *c = user;
    double v[ORR_MINIMISE_MOST];
    for (size_t i = 0; i < x->size; i++) v[i] = gsl_vector_get(x, i);
    double y = c->f(v, c->user);
    return isnan(y) ? (double)INFINITY : y;
}

orr_status orr_minimise(orr_function_of_many f, void *user, size_t n, double *x, const double *step,
                        double tolerance, int most, double *value)
{
    if (n < 1 || n > ORR_MINIMISE_MOST) return ORR_E_ARG;
    called c = {f, user};
    gsl_multimin_function g = {call, n, &c};
    gsl_multimin_fminimizer *m = gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n);
    gsl_vector *at = gsl_vector_alloc(n), *size = gsl_vector_alloc(n);
    orr_status s = m != NULL && at != NULL && size != NULL ? ORR_OK : ORR_E_MEMORY;
    if (s == ORR_OK) {
        for (size_t i = 0; i < n; i++) {
            gsl_vector_set(at, i, x[i]);
            gsl_vector_set(size, i, step[i]);
        }
        int failed = gsl_multimin_fminimizer_set(m, &g, at, size);
        for (int k = 0; failed == 0 && k < most && gsl_multimin_fminimizer_size(m) > tolerance; k++)
            failed = gsl_multimin_fminimizer_iterate(m);
        for (size_t i = 0; i < n; i++) x[i] = gsl_vector_get(m->x, i);
        if (value != NULL) *value = m->fval;
    }
    if (m != NULL) gsl_multimin_fminimizer_free(m);
    if (at != NULL) gsl_vector_free(at);
    if (size != NULL) gsl_vector_free(size);
    return s;
}

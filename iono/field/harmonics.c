// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/field/harmonics.h"

#include <math.h>
#include <stdlib.h>

orr_status orr_harm_basis_init(int degree, orr_harm_basis *out, orr_diag *diag)
{
    *out = (orr_harm_basis){0};
    if (degree < 0 || degree > ORR_HARM_MAX_DEGREE)
        return orr_diag_set(diag, ORR_E_ARG, "spherical harmonics of degree %d: 0 to %d are possible", degree,
                            ORR_HARM_MAX_DEGREE);
    size_t rows = (size_t)degree + 1, stride = (rows + 3) / 4 * 4;
    double *all = calloc(2 * rows * stride + stride, sizeof *all);
    if (all == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for spherical harmonics");
    *out = (orr_harm_basis){
        degree, stride, 2 * rows * stride, rows * rows, all, all + rows * stride, all + 2 * rows * stride};
    for (int m = 1; m <= degree; m++) out->sectoral[m] = m == 1 ? sqrt(3.0) : sqrt((2.0 * m + 1) / (2.0 * m));
    for (int k = 1; k <= degree; k++)
        for (int m = 0; m + k <= degree; m++) {
            double n = m + k, order = m;
            size_t at = (size_t)k * stride + (size_t)m;
            out->alpha[at] = sqrt((2 * n - 1) * (2 * n + 1) / ((n - order) * (n + order)));
            if (k >= 2)
                out->beta[at] = sqrt((2 * n + 1) * (n + order - 1) * (n - order - 1) /
                                     ((2 * n - 3) * (n - order) * (n + order)));
        }
    return ORR_OK;
}

void orr_harm_basis_free(orr_harm_basis *b)
{
    free(b->alpha);
    *b = (orr_harm_basis){0};
}

// Row 0: P(m,m) for all orders, zero beyond the degree.
static void sectorals(const orr_harm_basis *b, double cos_lat, double *p)
{
    p[0] = 1;
    for (int m = 1; m <= b->degree; m++) p[m] = b->sectoral[m] * cos_lat * p[m - 1];
    for (size_t m = (size_t)b->degree + 1; m < b->stride; m++) p[m] = 0;
}

// How many orders row k has, rounded up so that loops have no remainder; the surplus meets zero coefficients.
static size_t row_width(const orr_harm_basis *b, int k) { return ((size_t)(b->degree - k) + 4) / 4 * 4; }

// One step of the recurrence for all orders of row k, from rows k - 1 (cur) and k - 2 (old, which is
// overwritten), and what the row adds to the sums. Plain loops over arrays that do not overlap: the compiler
// makes vectors of them.
static void add_row(size_t width, double x, const double *restrict alpha, const double *restrict beta,
                    const double *restrict c, const double *restrict s, const double *restrict cur,
                    double *restrict old, double *restrict ca, double *restrict sa)
{
    for (size_t m = 0; m < width; m++) {
        double p = alpha[m] * x * cur[m] - beta[m] * old[m];
        old[m] = p;
        ca[m] += c[m] * p;
        sa[m] += s[m] * p;
    }
}

double orr_harm_eval(const orr_harm_basis *b, const double *coef, double sin_lat, double cos_lat,
                     double sin_lon, double cos_lon)
{
    double even[ORR_HARM_MAX_ROW], odd[ORR_HARM_MAX_ROW], ca[ORR_HARM_MAX_ROW], sa[ORR_HARM_MAX_ROW];
    size_t stride = b->stride;
    sectorals(b, cos_lat, even);
    for (size_t m = 0; m < stride; m++) {
        odd[m] = 0;
        ca[m] = coef[m] * even[m];
        sa[m] = coef[stride + m] * even[m];
    }
    for (int k = 1; k <= b->degree; k++) {
        const double *alpha = b->alpha + (size_t)k * stride, *beta = b->beta + (size_t)k * stride;
        const double *c = coef + 2 * (size_t)k * stride;
        if (k % 2 == 1)
            add_row(row_width(b, k), sin_lat, alpha, beta, c, c + stride, even, odd, ca, sa);
        else
            add_row(row_width(b, k), sin_lat, alpha, beta, c, c + stride, odd, even, ca, sa);
    }
    // sum_m (ca cos m s + sa sin m s) by Clenshaw: one multiplication an order, no table of cosines.
    double twice = 2 * cos_lon, c1 = 0, c2 = 0, s1 = 0, s2 = 0;
    for (int m = b->degree; m >= 1; m--) {
        double c0 = ca[m] + twice * c1 - c2, s0 = sa[m] + twice * s1 - s2;
        c2 = c1;
        c1 = c0;
        s2 = s1;
        s1 = s0;
    }
    return ca[0] + cos_lon * c1 - c2 + sin_lon * s1;
}

void orr_harm_row(const orr_harm_basis *b, double sin_lat, double cos_lat, double sin_lon, double cos_lon,
                  double *row)
{
    double p0[ORR_HARM_MAX_ROW], p1[ORR_HARM_MAX_ROW], cm[ORR_HARM_MAX_ROW], sm[ORR_HARM_MAX_ROW];
    double *cur = p0, *old = p1;
    sectorals(b, cos_lat, cur);
    cm[0] = 1;
    sm[0] = 0;
    for (int m = 1; m <= b->degree; m++) {
        cm[m] = cm[m - 1] * cos_lon - sm[m - 1] * sin_lon;
        sm[m] = sm[m - 1] * cos_lon + cm[m - 1] * sin_lon;
    }
    for (size_t m = 0; m < b->stride; m++) old[m] = 0;
    for (int k = 0; k <= b->degree; k++) {
        if (k > 0) {
            for (int m = 0; m + k <= b->degree; m++) {
                size_t at = (size_t)k * b->stride + (size_t)m;
                old[m] = b->alpha[at] * sin_lat * cur[m] - b->beta[at] * old[m];
            }
            double *swap = cur;
            cur = old;
            old = swap;
        }
        for (int m = 0; m + k <= b->degree; m++) {
            size_t n = (size_t)(m + k), at = n * n + (m == 0 ? 0 : 2 * (size_t)m - 1);
            row[at] = cur[m] * cm[m];
            if (m > 0) row[at + 1] = cur[m] * sm[m];
        }
    }
}

void orr_harm_unpack(const orr_harm_basis *b, const double *listed, double *coef)
{
    for (size_t i = 0; i < b->size; i++) coef[i] = 0;
    for (int n = 0; n <= b->degree; n++)
        for (int m = 0; m <= n; m++) {
            size_t at = (size_t)n * (size_t)n + (m == 0 ? 0 : 2 * (size_t)m - 1);
            coef[orr_harm_slot(b, n, m)] = listed[at];
            if (m > 0) coef[orr_harm_slot(b, n, -m)] = listed[at + 1];
        }
}

void orr_harm_pack(const orr_harm_basis *b, const double *coef, double *listed)
{
    for (int n = 0; n <= b->degree; n++)
        for (int m = 0; m <= n; m++) {
            size_t at = (size_t)n * (size_t)n + (m == 0 ? 0 : 2 * (size_t)m - 1);
            listed[at] = coef[orr_harm_slot(b, n, m)];
            if (m > 0) listed[at + 1] = coef[orr_harm_slot(b, n, -m)];
        }
}

void orr_harm_turn(const orr_harm_basis *b, double turn_rad, const double *in, double *out)
{
    for (int m = 0; m <= b->degree; m++) {
        double c = cos(m * turn_rad), s = sin(m * turn_rad);
        for (int k = 0; m + k <= b->degree; k++) {
            size_t ai = 2 * (size_t)k * b->stride + (size_t)m, bi = ai + b->stride;
            double a0 = in[ai], b0 = in[bi];
            out[ai] = a0 * c + b0 * s;
            out[bi] = m == 0 ? 0 : b0 * c - a0 * s;
        }
    }
    if (in != out) // the padding stays zero
        for (int k = 0; k <= b->degree; k++)
            for (size_t m = (size_t)(b->degree - k) + 1; m < b->stride; m++)
                out[2 * (size_t)k * b->stride + m] = out[(2 * (size_t)k + 1) * b->stride + m] = 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/field.h"

const orr_navfit_field orr_nav_klobuchar_fields[8] = {
    ORR_SIGNED("alpha0", P2(30), 8), ORR_SIGNED("alpha1", P2(27), 8), ORR_SIGNED("alpha2", P2(24), 8),
    ORR_SIGNED("alpha3", P2(24), 8), ORR_SIGNED("beta0", 0x1p11, 8),  ORR_SIGNED("beta1", 0x1p14, 8),
    ORR_SIGNED("beta2", 0x1p16, 8),  ORR_SIGNED("beta3", 0x1p16, 8)};

static double top_of(const orr_navfit_field *f)
{
    return ldexp(1.0, f->kind == ORR_FIELD_UNSIGNED ? f->bits : f->bits - 1);
}

static double least_of(const orr_navfit_field *f)
{
    return f->kind == ORR_FIELD_UNSIGNED ? 0 : f->kind == ORR_FIELD_MAGNITUDE ? 1 - top_of(f) : -top_of(f);
}

orr_status orr_navfit_to_field(const orr_navfit_field *f, double whole, double *value, orr_diag *diag)
{
    const double top = top_of(f);
    if (f->kind == ORR_FIELD_ANGLE) whole -= 2 * top * floor(whole / (2 * top) + 0.5);
    if (!(whole < top && whole >= least_of(f)))
        return orr_diag_set(diag, ORR_E_RANGE, "%s = %.10g does not fit its %d bits", f->name,
                            f->base + whole * f->lsb, f->bits);
    *value = f->base + orr_navfit_lsbs(whole, f->lsb);
    return ORR_OK;
}

double orr_navfit_clamped(const orr_navfit_field *f, double value)
{
    const double whole = fmax(least_of(f), fmin(top_of(f) - 1, orr_navfit_whole(f, value)));
    return f->base + orr_navfit_lsbs(whole, f->lsb);
}

int orr_nav_ura_index(double accuracy_m)
{
    static const double bound[] = {2.4, 3.4, 4.85, 6.85, 9.65, 13.65, 24,  48,
                                   96,  192, 384,  768,  1536, 3072,  6144};
    int k = 0;
    while (k < 15 && !(accuracy_m <= bound[k])) k++; // NAN is not known
    return k;
}

int orr_nav_sisa_index(double m)
{
    static const struct {
        double from_m, step_m;
        int first, last;
    } part[] = {{0, 0.01, 0, 49}, {0.5, 0.02, 50, 74}, {1, 0.04, 75, 99}, {2, 0.16, 100, 125}};
    for (size_t k = 0; k < 4 && isfinite(m); k++) {
        const int i = part[k].first + (int)ceil(fmax(m - part[k].from_m, 0) / part[k].step_m - 1e-9);
        if (i <= part[k].last) return i;
    }
    return 255;
}

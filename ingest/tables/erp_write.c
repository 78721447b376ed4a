// SPDX-License-Identifier: GPL-3.0-or-later
// Writer of Earth rotation files, version 2 (IGSMAIL-1943, 1998), columns in the order of the IGS' own.
#include <math.h>

#include "core/outfile.h"
#include "core/vec.h"
#include "ingest/tables/erp.h"

#define UAS_PER_RAD (ORR_DEG_PER_RAD * 3.6e9)

// A whole number of units; what is not known is 0, as the format has it.
static long units(double value, double per_unit) { return isnan(value) ? 0 : lround(value * per_unit); }

static void write_line(FILE *f, double mjd_utc, const orr_eop *e, const orr_erp_detail *d)
{
    const double per_day = UAS_PER_RAD * ORR_S_PER_DAY;
    fprintf(f, "%8.2f %8ld %8ld %9ld %6ld %5ld %5ld %7ld %6ld %3d %3d %3d %6ld %6ld %5ld %5ld\n", mjd_utc,
            units(e->xp_rad, UAS_PER_RAD), units(e->yp_rad, UAS_PER_RAD), units(e->ut1_utc_s, 1e7),
            units(e->lod_s, 1e7), units(d->xp_sdev_rad, UAS_PER_RAD), units(d->yp_sdev_rad, UAS_PER_RAD),
            units(d->ut1_sdev_s, 1e7), units(d->lod_sdev_s, 1e7), d->n_receivers > 0 ? d->n_receivers : 0,
            d->n_fixed > 0 ? d->n_fixed : 0, d->n_satellites > 0 ? d->n_satellites : 0,
            units(d->xp_rate_radps, per_day), units(d->yp_rate_radps, per_day),
            units(d->xp_rate_sdev_radps, per_day), units(d->yp_rate_sdev_radps, per_day));
}

orr_status orr_erp_print(const orr_erp *x, const char *const *remark, size_t n_remarks, FILE *stream,
                         orr_diag *diag)
{
    for (size_t i = 0; i < x->series.n; i++)
        if (fabs(x->series.mjd_utc[i] * 100 - nearbyint(x->series.mjd_utc[i] * 100)) > 1e-6)
            return orr_diag_set(diag, ORR_E_ARG, "MJD %.6f is no hundredth of a day, which the format has",
                                x->series.mjd_utc[i]);
    fprintf(stream, "version 2\n%s\n", x->title[0] != '\0' ? x->title : "Earth rotation parameters");
    for (size_t i = 0; i < n_remarks; i++) fprintf(stream, "  %s\n", remark[i]);
    fputs("     MJD    Xpole    Ypole   UT1-UTC    LOD  Xsig  Ysig   UTsig LODsig  Nr  Nf  Nt    Xrt    Yrt "
          "Xrtsig Yrtsig\n"
          "           E-6\"     E-6\"      E-7s  E-7s/d E-6\"  E-6\"    E-7s E-7s/d             E-6\"/d "
          "E-6\"/d "
          "E-6\"/d E-6\"/d\n",
          stream);
    for (size_t i = 0; i < x->series.n; i++)
        write_line(stream, x->series.mjd_utc[i], &x->series.value[i], &x->detail[i]);
    return ferror(stream) == 0 ? ORR_OK : orr_diag_set(diag, ORR_E_IO, "the file cannot be written");
}

orr_status orr_erp_write(const orr_erp *x, const char *const *remark, size_t n_remarks, const char *path,
                         orr_diag *diag)
{
    orr_outfile f = {0};
    orr_status s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    s = orr_erp_print(x, remark, n_remarks, f.stream, diag);
    return orr_outfile_end(&f, s, diag);
}

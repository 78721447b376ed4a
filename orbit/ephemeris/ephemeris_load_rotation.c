// SPDX-License-Identifier: GPL-3.0-or-later
// The Earth's rotation of a product's file.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris_load_private.h"

// Of the Earth's rotation: years 1755 to 2237, ten times the pole's circle, more than the leap seconds of a century.
#define EPH_MOST_MJD 138000.0
#define EPH_MOST_POLE_RAD 5e-5
#define EPH_MOST_UT1_S 1e3

static orr_status read_rotation_text(const eph_file *f, orr_earth_rotation *r)
{
    char source[32] = "";
    orr_status s = orr_nc_get_att_text(&f->r, NULL, "earth_rotation_source", source, sizeof source, f->diag);
    if (s == ORR_E_NODATA) return ORR_OK; // of an earlier program
    for (int k = ORR_ROTATION_SECULAR; k <= ORR_ROTATION_ESTIMATED && s == ORR_OK; k++)
        if (strcmp(source, orr_rotation_source_name((orr_rotation_source)k)) == 0)
            r->source = (orr_rotation_source)k;
    if (s != ORR_OK || r->source != ORR_ROTATION_ESTIMATED) return s;
    double pole = 0;
    s = orr_nc_get_att_double(&f->r, NULL, "earth_rotation_pole_sigma_arcsec", &pole, f->diag);
    if (s == ORR_OK)
        s = orr_nc_get_att_double(&f->r, NULL, "earth_rotation_lod_sigma_s", &r->lod_sigma_s, f->diag);
    r->pole_sigma_rad = pole * ORR_RAD_PER_DEG / 3600;
    if (s == ORR_E_NODATA || (s == ORR_OK && !(pole >= 0 && r->lod_sigma_s >= 0)))
        s = eph_wrong(f, "the sigma of the Earth's rotation is missing or no number");
    return s;
}

orr_status eph_load_rotation(const eph_file *f, orr_earth_rotation *r)
{
    size_t n = 0;
    double *x = NULL, *y = NULL, *ut1 = NULL;
    orr_status s = read_rotation_text(f, r);
    if (s != ORR_OK || !orr_nc_has_var(&f->r, "earth_rotation_mjd")) return s;
    s = orr_nc_get_dim(&f->r, "earth_rotation", f->max_bytes / 8, &n, f->diag);
    if (s == ORR_OK)
        s = eph_read_column(f, "earth_rotation_mjd", ORR_NC_DOUBLE, n, (void **)&r->series.mjd_utc);
    if (s == ORR_OK) s = eph_read_column(f, "pole_x", ORR_NC_DOUBLE, n, (void **)&x);
    if (s == ORR_OK) s = eph_read_column(f, "pole_y", ORR_NC_DOUBLE, n, (void **)&y);
    if (s == ORR_OK) s = eph_read_column(f, "ut1_minus_utc", ORR_NC_DOUBLE, n, (void **)&ut1);
    if (s == ORR_OK && (r->series.value = calloc(n + 1, sizeof *r->series.value)) == NULL)
        s = orr_diag_set(f->diag, ORR_E_MEMORY, "no memory for the Earth's rotation");
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        const double mjd = r->series.mjd_utc[i];
        r->series.value[i] = (orr_eop){.xp_rad = x[i], .yp_rad = y[i], .ut1_utc_s = ut1[i]};
        if (!(fabs(mjd) < EPH_MOST_MJD) || !(fabs(x[i]) < EPH_MOST_POLE_RAD) ||
            !(fabs(y[i]) < EPH_MOST_POLE_RAD) || !(fabs(ut1[i]) < EPH_MOST_UT1_S) ||
            (i > 0 && !(mjd > r->series.mjd_utc[i - 1])))
            s = eph_wrong(f, "the Earth's rotation is impossible, or its times do not ascend");
    }
    if (s == ORR_OK) r->series.n = n;
    free(x);
    free(y);
    free(ut1);
    return s;
}

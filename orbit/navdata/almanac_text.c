// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/almanac_text.h"

#include <math.h>
#include <stdio.h>

#include "core/constants.h"
#include "core/outfile.h"
#include "orbit/navdata/navset_private.h"

#define GPS_SATELLITES 32
#define QZSS_SATELLITES 10
#define QZSS_PRN 192

// "0.1234567890E-001": a mantissa below one and an exponent of three digits, as Fortran wrote it.
static const char *fortran(double v, int digits, char text[32])
{
    int exponent = 0;
    const double scale = pow(10, digits);
    if (fabs(v) > 0) exponent = (int)floor(log10(fabs(v))) + 1;
    double mantissa = v / pow(10, exponent);
    if (fabs(round(mantissa * scale)) >= scale) mantissa /= 10, exponent++;
    snprintf(text, 32, "%*.*fE%+04d", digits + 3, digits, mantissa, exponent);
    return text;
}

static double within_half_turn(double rad) { return remainder(rad, 2 * ORR_PI); }

static void put_yuma(FILE *f, const navset_almanacs *of, const orr_almanac *a, int prn, double inclination)
{
    char text[32];
    const int week = of->week % 1024;
    fprintf(f, "******** Week %4d almanac for PRN-%02d ********\n", week, prn);
    fprintf(f, "ID:                         %02d\n", prn);
    fprintf(f, "Health:                     %03u\n", a->health);
    fprintf(f, "Eccentricity:              %s\n", fortran(a->e, 10, text));
    fprintf(f, "Time of Applicability(s):  %.4f\n", a->toa_s);
    fprintf(f, "Orbital Inclination(rad):  %13.10f\n", inclination);
    fprintf(f, "Rate of Right Ascen(r/s):  %s\n", fortran(a->omega_dot_radps, 10, text));
    fprintf(f, "SQRT(A)  (m 1/2):           %11.6f\n", a->sqrt_a_sqrtm);
    fprintf(f, "Right Ascen at Week(rad):  %s\n", fortran(within_half_turn(a->omega0_rad), 10, text));
    fprintf(f, "Argument of Perigee(rad):  %13.9f\n", within_half_turn(a->omega_rad));
    fprintf(f, "Mean Anom(rad):            %s\n", fortran(within_half_turn(a->m0_rad), 10, text));
    fprintf(f, "Af0(s):                    %s\n", fortran(a->af0_s, 10, text));
    fprintf(f, "Af1(s/s):                  %s\n", fortran(a->af1_sps, 10, text));
    fprintf(f, "week:                       %4d\n\n", week);
}

// Angles in semicircles, the inclination as what it is above 0.30.
static void put_sem(FILE *f, const orr_almanac *a, uint8_t configuration)
{
    const double sc = 1 / ORR_PI;
    fprintf(f, "%d\n0\n0\n", a->number); // PRN, SVN, average URA
    fprintf(f, "%21.14E %21.14E %21.14E\n", a->e, a->i_offset_rad * sc, a->omega_dot_radps * sc);
    fprintf(f, "%21.14E %21.14E %21.14E\n", a->sqrt_a_sqrtm, within_half_turn(a->omega0_rad) * sc,
            within_half_turn(a->omega_rad) * sc);
    fprintf(f, "%21.14E %21.14E %21.14E\n", within_half_turn(a->m0_rad) * sc, a->af0_s, a->af1_sps);
    fprintf(f, "%u\n%u\n\n", a->health & 0x3fu, configuration & 7u);
}

static size_t count(const navset_almanacs *of, int satellites)
{
    size_t n = 0;
    for (int k = 1; k <= satellites; k++) n += of->has[k];
    return n;
}

static void write_yuma(FILE *f, const navset_day *day)
{
    for (int k = 1; k <= GPS_SATELLITES; k++)
        if (day->gps.has[k])
            put_yuma(f, &day->gps, &day->gps.sat[k], k,
                     orr_almanac_inclination(orr_sat_make('G', k), &day->gps.sat[k]));
    for (int k = 1; k <= QZSS_SATELLITES; k++)
        if (day->qzss.has[k])
            put_yuma(f, &day->qzss, &day->qzss.sat[k], QZSS_PRN + k,
                     orr_almanac_inclination(orr_sat_make('J', k), &day->qzss.sat[k]));
}

static void write_sem(FILE *f, const navset_day *day, size_t n)
{
    fprintf(f, "%2zu  CURRENT.ALM\n%4d %6u\n\n", n, day->gps.week % 1024, day->gps.toa_s);
    for (int k = 1; k <= GPS_SATELLITES; k++)
        if (day->gps.has[k]) put_sem(f, &day->gps.sat[k], day->gps_configuration[k - 1]);
}

orr_status orr_almanac_write(const orr_navset *set, orr_almanac_format format, orr_time t, const char *path,
                             size_t *n, orr_diag *diag)
{
    const navset_day *day = navset_day_at(set, t);
    const size_t gps = count(&day->gps, GPS_SATELLITES),
                 all = gps + (format == ORR_ALMANAC_YUMA ? count(&day->qzss, QZSS_SATELLITES) : 0);
    if (all == 0)
        return orr_diag_set(diag, ORR_E_NODATA, "no satellite of %s has an almanac on that day",
                            format == ORR_ALMANAC_YUMA ? "GPS or QZSS" : "GPS");
    orr_outfile out;
    const orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    if (format == ORR_ALMANAC_YUMA)
        write_yuma(out.stream, day);
    else
        write_sem(out.stream, day, gps);
    if (n != NULL) *n = all;
    return orr_outfile_commit(&out, diag);
}

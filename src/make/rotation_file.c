// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/rotation_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/nan.h"
#include "ingest/tables/erp.h"

#define STEP_DAYS 0.5
// UT1 of an estimate starts from the leap seconds, which tell it so well.
#define UT1_BY_LEAP_SECONDS_S 0.4

static double mjd_utc(orr_time t, const orr_leap_table *leap)
{
    int32_t day;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_UTC, leap, &day, &fraction);
    return day + fraction;
}

static orr_erp_detail detail_of(const orr_earth_rotation *r, const orr_eop *e, size_t n_sats)
{
    const bool estimated = r->source == ORR_ROTATION_ESTIMATED;
    return (orr_erp_detail){.xp_sdev_rad = estimated ? r->pole_sigma_rad : ORR_NAN,
                            .yp_sdev_rad = estimated ? r->pole_sigma_rad : ORR_NAN,
                            .ut1_sdev_s = estimated ? UT1_BY_LEAP_SECONDS_S : ORR_NAN,
                            .lod_sdev_s = estimated ? r->lod_sigma_s : ORR_NAN,
                            .xp_rate_radps = e->xp_rate_radps,
                            .yp_rate_radps = e->yp_rate_radps,
                            .xp_rate_sdev_radps = ORR_NAN,
                            .yp_rate_sdev_radps = ORR_NAN,
                            .dpsi_rad = ORR_NAN,
                            .deps_rad = ORR_NAN,
                            .n_receivers = -1,
                            .n_fixed = -1,
                            .n_satellites = (int)n_sats};
}

orr_status orr_rotation_file_write(const orr_ephemeris *e, const orr_leap_table *leap, const char *path,
                                   orr_diag *diag)
{
    static const char *const remark[] = {
        "Pole, its rates and LOD are estimated together with the orbits; the sigmas are formal.",
        "UT1-UTC: its rate is estimated, its value starts from the leap seconds.",
        "Zonal tides are in UT1 and LOD; daily and half-daily tides of the ocean (IERS 2010) are not.",
    };
    const orr_earth_rotation *r = orr_ephemeris_rotation(e);
    if (r->source == ORR_ROTATION_SECULAR || r->series.n < 2)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "the orbits tell no Earth rotation (four satellites over two hours are the least), and "
            "the secular pole is no measurement to write to %s",
            path);
    orr_time from, to;
    const orr_sat *sat;
    orr_ephemeris_span(e, &from, &to);
    const double first = floor(mjd_utc(from, leap) / STEP_DAYS) * STEP_DAYS;
    const size_t n = (size_t)ceil((mjd_utc(to, leap) - first) / STEP_DAYS) + 1;
    orr_erp erp = {.version = 2};
    snprintf(erp.title, sizeof erp.title, "Orrery: Earth rotation, %s",
             r->source == ORR_ROTATION_ESTIMATED ? "estimated from orbits" : "as it was given");
    erp.series.mjd_utc = malloc(n * sizeof *erp.series.mjd_utc);
    erp.series.value = malloc(n * sizeof *erp.series.value);
    erp.detail = malloc(n * sizeof *erp.detail);
    orr_status s = ORR_OK;
    if (erp.series.mjd_utc == NULL || erp.series.value == NULL || erp.detail == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu lines of Earth rotation", n);
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        const double mjd = first + STEP_DAYS * (double)i, day = floor(mjd);
        const orr_time t = orr_time_from_mjd((int32_t)day, mjd - day, ORR_SCALE_UTC, leap);
        erp.series.mjd_utc[i] = mjd;
        erp.series.value[i] = orr_eop_at(&r->series, t, leap, NULL);
        erp.detail[i] = detail_of(r, &erp.series.value[i], orr_ephemeris_satellites(e, &sat));
        erp.series.n = i + 1;
    }
    if (s == ORR_OK)
        s = orr_erp_write(&erp, remark,
                          r->source == ORR_ROTATION_ESTIMATED ? sizeof remark / sizeof *remark : 0, path,
                          diag);
    orr_erp_free(&erp);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/earth_rotation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEP_S 10800.0
#define SAME_S 1e-6

// UT1 by a run's table less that by the built-in one.
static double turned_s(orr_time t, const orr_leap_table *leap)
{
    return orr_eop_node(NULL, t, leap).ut1_utc_s - orr_eop_node(NULL, t, NULL).ut1_utc_s;
}

orr_status orr_earth_rotation_secular(orr_time from, orr_time to, const orr_leap_table *leap,
                                      orr_earth_rotation *out)
{
    *out = (orr_earth_rotation){.source = ORR_ROTATION_SECULAR};
    if (fabs(turned_s(from, leap)) < SAME_S && fabs(turned_s(to, leap)) < SAME_S) return ORR_OK;
    const size_t n = (size_t)ceil(orr_time_diff_s(to, from) / STEP_S) + 2;
    out->series.mjd_utc = malloc(n * sizeof *out->series.mjd_utc);
    out->series.value = malloc(n * sizeof *out->series.value);
    if (out->series.mjd_utc == NULL || out->series.value == NULL) {
        orr_earth_rotation_free(out);
        return ORR_E_MEMORY;
    }
    for (out->series.n = 0; out->series.n < n; out->series.n++) {
        const orr_time t = orr_time_add_s(from, STEP_S * (double)out->series.n);
        int32_t day;
        double fraction;
        orr_time_mjd(t, ORR_SCALE_UTC, NULL, &day, &fraction);
        out->series.mjd_utc[out->series.n] = day + fraction;
        out->series.value[out->series.n] = orr_eop_node(NULL, t, leap);
    }
    return ORR_OK;
}

orr_status orr_eop_series_copy(const orr_eop_series *from, orr_eop_series *to)
{
    *to = (orr_eop_series){0};
    if (from->n == 0) return ORR_OK;
    to->mjd_utc = malloc(from->n * sizeof *to->mjd_utc);
    to->value = malloc(from->n * sizeof *to->value);
    if (to->mjd_utc == NULL || to->value == NULL) {
        free(to->mjd_utc);
        free(to->value);
        *to = (orr_eop_series){0};
        return ORR_E_MEMORY;
    }
    memcpy(to->mjd_utc, from->mjd_utc, from->n * sizeof *to->mjd_utc);
    memcpy(to->value, from->value, from->n * sizeof *to->value);
    to->n = from->n;
    return ORR_OK;
}

void orr_earth_rotation_free(orr_earth_rotation *r)
{
    free(r->series.mjd_utc);
    free(r->series.value);
    *r = (orr_earth_rotation){0};
}

const char *orr_rotation_source_name(orr_rotation_source source)
{
    switch (source) {
    case ORR_ROTATION_GIVEN:
        return "given";
    case ORR_ROTATION_ESTIMATED:
        return "estimated";
    case ORR_ROTATION_SECULAR:
        break;
    }
    return "secular pole";
}

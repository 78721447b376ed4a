// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/earth_rotation.h"

#include <stdlib.h>
#include <string.h>

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

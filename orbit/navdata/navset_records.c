// SPDX-License-Identifier: GPL-3.0-or-later
// The sets as the records of a navigation file.
#include <stdlib.h>
#include <string.h>

#include "orbit/navdata/navset_private.h"

bool orr_navset_klobuchar(const orr_navset *set, double alpha[4], double beta[4])
{
    memcpy(alpha, set->alpha, sizeof set->alpha);
    memcpy(beta, set->beta, sizeof set->beta);
    return set->has_klobuchar;
}

static char system_of(const orr_navset *set)
{
    char system = '\0';
    for (size_t i = 0; i < set->n_sats; i++) {
        char letter = orr_sat_system(set->sat[i]);
        if (system == '\0') system = letter;
        if (system != letter) return 'M';
    }
    return system;
}

orr_status orr_navset_records(const orr_navset *set, orr_nav *out, orr_diag *diag)
{
    size_t n = 0;
    for (size_t i = 0; i < set->n_sats; i++)
        for (size_t k = 0; k < set->sets[i].n; k++) n += set->sets[i].series[k].n;
    *out = (orr_nav){.version = 3.05,
                     .system = system_of(set),
                     .leap = set->leap,
                     .has_leap = true,
                     .leap_s = orr_leap_tai_minus_utc(set->from, set->leap) - 19,
                     .leap_scale = ORR_SCALE_GPS};
    out->eph = calloc(n + 1, sizeof *out->eph);
    out->iono = calloc(1, sizeof *out->iono);
    if (out->eph == NULL || out->iono == NULL) {
        orr_nav_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu records", n);
    }
    for (size_t i = 0; i < set->n_sats; i++)
        for (size_t k = 0; k < set->sets[i].n; k++) {
            const navset_series *x = &set->sets[i].series[k];
            for (size_t j = 0; j < x->n; j++) out->eph[out->n_eph++] = x->item[j].eph;
        }
    if (!set->has_klobuchar) return ORR_OK;
    orr_nav_iono *iono = &out->iono[out->n_iono++];
    *iono = (orr_nav_iono){.kind = ORR_NAV_KLOBUCHAR,
                           .system = 'G',
                           .time_mark = ' ',
                           .t = ORR_TIME_NONE,
                           .iod = ORR_NAV_NO_IOD};
    memcpy(iono->coefficient, set->alpha, sizeof set->alpha);
    memcpy(iono->coefficient + 4, set->beta, sizeof set->beta);
    return ORR_OK;
}

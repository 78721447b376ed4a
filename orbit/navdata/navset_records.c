// SPDX-License-Identifier: GPL-3.0-or-later
// The sets as the records of a navigation file.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/navdata/navset_private.h"

enum { OFFSETS = 11 };

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

static bool has_system(const orr_navset *set, char system)
{
    for (size_t i = 0; i < set->n_sats; i++)
        if (orr_sat_system(set->sat[i]) == system) return true;
    return false;
}

// The offsets that messages send, to UTC and to GPS time (GGTO, BGTO and their like): all systems' time is the product's less whole
// seconds, and UTC without a fraction.
static void add_offsets(const orr_navset *set, const orr_nav_utc *utc, orr_nav *out)
{
    static const struct {
        char system;
        const char *code;
    } offset[] = {{'G', "GPUT"}, {'R', "GLUT"}, {'E', "GAUT"}, {'C', "BDUT"}, {'J', "QZUT"}, {'I', "IRUT"},
                  {'R', "GLGP"}, {'E', "GAGP"}, {'C', "BDGP"}, {'J', "QZGP"}, {'I', "IRGP"}};
    _Static_assert(sizeof offset / sizeof *offset == OFFSETS, "room for all");
    for (size_t k = 0; k < OFFSETS; k++) {
        if (!has_system(set, offset[k].system)) continue;
        orr_nav_sto *s = &out->sto[out->n_sto++];
        *s = (orr_nav_sto){.t_ref = utc->reference, .transmission = ORR_TIME_NONE};
        snprintf(s->code, sizeof s->code, "%s", offset[k].code);
    }
}

static void add_iono(orr_nav *out, uint8_t kind, char system, const double *first, size_t n,
                     const double *second)
{
    bool any = false;
    for (size_t k = 0; k < n; k++) any = any || fabs(first[k]) > 0;
    if (!any) return; // zeros are sent, which say nothing
    orr_nav_iono *iono = &out->iono[out->n_iono++];
    *iono = (orr_nav_iono){
        .kind = kind, .system = system, .time_mark = ' ', .t = ORR_TIME_NONE, .iod = ORR_NAV_NO_IOD};
    memcpy(iono->coefficient, first, n * sizeof *first);
    if (second != NULL) memcpy(iono->coefficient + n, second, n * sizeof *second);
}

// The Earth's rotation of every day, as the messages of a system that has them send it (CNAV-2, B-CNAV).
static void add_eop(const orr_navset *set, char system, orr_nav *out)
{
    for (size_t i = 0; i < set->n_sats; i++) {
        if (orr_sat_system(set->sat[i]) != system) continue;
        for (size_t k = 0; k < set->n_days; k++) {
            const orr_modern_rotation *r = &set->day[k].rotation;
            out->eop[out->n_eop++] = (orr_nav_eop){.sat = set->sat[i],
                                                   .message = ORR_NAV_CNVX,
                                                   .t_ref = r->reference,
                                                   .transmission = r->reference,
                                                   .xp_rad = r->xp_rad,
                                                   .xp_rate_radps = r->xp_rate_radps,
                                                   .yp_rad = r->yp_rad,
                                                   .yp_rate_radps = r->yp_rate_radps,
                                                   .dut1_s = r->ut1_utc_s,
                                                   .dut1_rate_sps = r->ut1_rate_spd / ORR_S_PER_DAY};
        }
        return;
    }
}

orr_status orr_navset_records(const orr_navset *set, orr_nav *out, orr_diag *diag)
{
    size_t n = 0;
    for (size_t i = 0; i < set->n_sats; i++)
        for (size_t k = 0; k < set->sets[i].n; k++) n += set->sets[i].series[k].n;
    const orr_nav_utc utc = orr_nav_utc_at(set->from, set->day[0].gps.toa, set->leap);
    *out = (orr_nav){.version = 3.05,
                     .system = system_of(set),
                     .leap = set->leap,
                     .has_leap = true,
                     .leap_s = utc.leap_s,
                     .leap_future_s = utc.leap_future_s,
                     .leap_week = utc.week_lsf,
                     .leap_day = utc.day,
                     .leap_scale = ORR_SCALE_GPS};
    out->eph = calloc(n + 1, sizeof *out->eph);
    out->iono = calloc(4, sizeof *out->iono);
    out->sto = calloc(OFFSETS, sizeof *out->sto);
    out->eop = calloc(3 * set->n_days + 1, sizeof *out->eop);
    if (out->eph == NULL || out->iono == NULL || out->sto == NULL || out->eop == NULL) {
        orr_nav_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu records", n);
    }
    for (size_t i = 0; i < set->n_sats; i++)
        for (size_t k = 0; k < set->sets[i].n; k++) {
            const navset_series *x = &set->sets[i].series[k];
            for (size_t j = 0; j < x->n; j++) out->eph[out->n_eph++] = x->item[j].eph;
        }
    add_offsets(set, &utc, out);
    for (const char *system = "GCJ"; *system != '\0'; system++) add_eop(set, *system, out);
    add_iono(out, ORR_NAV_KLOBUCHAR, 'G', set->alpha, 4, set->beta);
    add_iono(out, ORR_NAV_NEQUICK_G, 'E', set->nequick, 3, NULL);
    add_iono(out, ORR_NAV_KLOBUCHAR, 'C', set->beidou_alpha, 4, set->beidou_beta);
    add_iono(out, ORR_NAV_BDGIM, 'C', set->bdgim, 9, NULL);
    return ORR_OK;
}

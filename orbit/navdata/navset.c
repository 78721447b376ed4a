// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/navset.h"

#include <stdlib.h>
#include <string.h>

#include "core/parallel.h"
#include "orbit/navdata/bcnav_bits.h"
#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/navdata/system_week.h"

#define MOST_WEEKS 1024 // of ten bits: a longer set would send one week for another

orr_navset_options orr_navset_defaults(void) { return (orr_navset_options){.window_s = 7200, .jobs = 1}; }

typedef struct work {
    const orr_ephemeris *e;
    const orr_navset_options *o;
    size_t n;
    navset_satellite *sat;
} work;

static void fit_one(void *user, size_t i)
{
    work *w = user;
    navset_fit_satellite(w->e, w->o, &w->sat[i]);
}

// BeiDou-3's satellites in medium and inclined orbits (C19 to C58) send B1C, B2a and B2b with B-CNAV.
static bool sends_bcnav(orr_sat sat) { return orr_sat_number(sat) >= 19 && !orr_nav_beidou_geo(sat); }

// The messages of a satellite that are wanted; numbers that a message cannot name have none.
static uint32_t wanted(const orr_navset_options *o, orr_sat sat)
{
    const char system = orr_sat_system(sat);
    if (o->sats != NULL && !orr_sat_set_has(o->sats, sat)) return 0;
    if (((system == 'G' || system == 'J') && orr_sat_number(sat) > 32) ||
        (system == 'E' && orr_sat_number(sat) > 36) || (system == 'I' && orr_sat_number(sat) > 14))
        return 0;
    uint32_t messages = orr_nav_streams_of(system);
    if (system == 'C') messages &= ~(UINT32_C(1) << (orr_nav_beidou_geo(sat) ? ORR_NAV_D1 : ORR_NAV_D2));
    if (system == 'C' && !sends_bcnav(sat))
        messages &=
            ~(UINT32_C(1) << ORR_NAV_CNV1 | UINT32_C(1) << ORR_NAV_CNV2 | UINT32_C(1) << ORR_NAV_CNV3);
    return o->messages != 0 ? messages & o->messages : messages;
}

static void begin_series(navset_satellite *s, orr_sat sat, uint32_t messages)
{
    size_t n;
    const orr_nav_stream *stream = orr_nav_streams(&n);
    s->sat = sat;
    for (size_t k = 0; k < n && s->n < NAVSET_SERIES; k++) {
        const uint32_t bit = UINT32_C(1) << stream[k].message;
        if (stream[k].system != orr_sat_system(sat) || (messages & bit) == 0) continue;
        s->series[s->n++].message = stream[k].message;
        messages &= ~bit;
    }
}

static void say_what_is_missing(const navset_satellite *s, orr_warnings *warnings)
{
    char name[ORR_SAT_TEXT];
    orr_sat_text(s->sat, name);
    for (size_t k = 0; k < s->n; k++) {
        const navset_series *x = &s->series[k];
        const char *message = s->n > 1 ? orr_nav_message_name(x->message) : "", *of = s->n > 1 ? " " : "";
        if (x->no_clock > 0)
            orr_warnings_add(warnings, NULL, 0, 0,
                             "%s: the product has no clock for %zu of its%s%s sets; they are left out", name,
                             x->no_clock, of, message);
        if (x->not_fitted > 0)
            orr_warnings_add(warnings, NULL, 0, 0, "%s: %zu of its%s%s sets are left out: %s", name,
                             x->not_fitted, of, message, x->why);
    }
}

static size_t count_sets(const navset_satellite *s)
{
    size_t n = 0;
    for (size_t k = 0; k < s->n; k++) n += s->series[k].n;
    return n;
}

static void free_series(navset_satellite *s)
{
    for (size_t k = 0; k < s->n; k++) free(s->series[k].item);
}

// Moves satellites that have sets into the result; the others' memory is freed.
static orr_status collect(work *w, orr_navset *set, orr_warnings *warnings, orr_diag *diag)
{
    orr_status s = ORR_OK;
    set->sat = calloc(w->n + 1, sizeof *set->sat);
    set->sets = calloc(w->n + 1, sizeof *set->sets);
    if (set->sat == NULL || set->sets == NULL) s = ORR_E_MEMORY;
    for (size_t i = 0; i < w->n; i++) {
        if (s == ORR_OK) s = w->sat[i].status;
        if (s == ORR_OK) say_what_is_missing(&w->sat[i], warnings);
        if (s == ORR_OK && count_sets(&w->sat[i]) > 0) {
            set->sat[set->n_sats] = w->sat[i].sat;
            set->sets[set->n_sats++] = w->sat[i];
        } else
            free_series(&w->sat[i]);
    }
    if (s == ORR_OK && set->n_sats == 0)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "no satellite of the product that sends one of the messages has an orbit and a "
                            "clock to fit");
    return s;
}

static orr_status fit_all(work *w)
{
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(w->e, &list);
    w->sat = calloc(n + 1, sizeof *w->sat);
    if (w->sat == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const uint32_t messages = wanted(w->o, list[i]);
        if (messages != 0) begin_series(&w->sat[w->n++], list[i], messages);
    }
    orr_parallel_each(w->n, w->o->jobs, fit_one, w);
    return ORR_OK;
}

// GPS' own coefficients, the first that page 18 can send, from a header or a record.
static void take_klobuchar(orr_navset *set, const orr_nav *nav, orr_warnings *warnings)
{
    orr_diag why = {0};
    for (size_t i = 0; nav != NULL && i < nav->n_iono && !set->has_klobuchar; i++) {
        const orr_nav_iono *k = &nav->iono[i];
        const orr_nav_utc utc = {0};
        const orr_lnav_how how = {0};
        orr_lnav_subframe page;
        if (k->kind != ORR_NAV_KLOBUCHAR || k->system != 'G') continue;
        if (orr_lnav_encode_page18(k->coefficient, k->coefficient + 4, &utc, &how, &page,
                                   why.text[0] == '\0' ? &why : NULL) != ORR_OK)
            continue;
        memcpy(set->alpha, k->coefficient, sizeof set->alpha);
        memcpy(set->beta, k->coefficient + 4, sizeof set->beta);
        set->has_klobuchar = true;
    }
    if (why.text[0] != '\0')
        orr_warnings_add(warnings, NULL, 0, 0, "Klobuchar's coefficients cannot be sent as they are: %s; %s",
                         why.text, set->has_klobuchar ? "those of another record are" : "zeros are");
}

static bool holds(const double *value, const orr_navfit_field *field, size_t n)
{
    double sent;
    for (size_t k = 0; k < n; k++)
        if (orr_navfit_to_field(&field[k], orr_navfit_whole(&field[k], value[k]), &sent, NULL) != ORR_OK)
            return false;
    return true;
}

// Galileo's three coefficients, BeiDou's eight and BDGIM's nine, the first that their messages can send.
static void take_others(orr_navset *set, const orr_nav *nav)
{
    static const orr_navfit_field ai[3] = {ORR_UNSIGNED("ai0", P2(2), 11), ORR_SIGNED("ai1", P2(8), 11),
                                           ORR_SIGNED("ai2", P2(15), 14)};
    bool galileo = false, beidou = false, bdgim = false;
    for (size_t i = 0; nav != NULL && i < nav->n_iono; i++) {
        const orr_nav_iono *k = &nav->iono[i];
        if (!galileo && k->kind == ORR_NAV_NEQUICK_G && holds(k->coefficient, ai, 3)) {
            memcpy(set->nequick, k->coefficient, sizeof set->nequick);
            galileo = true;
        }
        if (!beidou && k->kind == ORR_NAV_KLOBUCHAR && k->system == 'C' &&
            holds(k->coefficient, orr_nav_klobuchar_fields, 8)) {
            memcpy(set->beidou_alpha, k->coefficient, sizeof set->beidou_alpha);
            memcpy(set->beidou_beta, k->coefficient + 4, sizeof set->beidou_beta);
            beidou = true;
        }
        if (!bdgim && k->kind == ORR_NAV_BDGIM && holds(k->coefficient, orr_bcnav_bdgim, 9)) {
            memcpy(set->bdgim, k->coefficient, sizeof set->bdgim);
            bdgim = true;
        }
    }
}

orr_status orr_navset_build(const orr_ephemeris *e, const orr_navset_options *o, orr_navset **out,
                            orr_warnings *warnings, orr_diag *diag)
{
    if (o->window_s != 7200 && o->window_s != 14400)
        return orr_diag_set(diag, ORR_E_ARG, "a window of %g s is not 2 or 4 hours", o->window_s);
    orr_time begin, end;
    orr_ephemeris_span(e, &begin, &end);
    if (orr_time_diff_s(end, begin) > MOST_WEEKS * (double)ORR_S_PER_WEEK)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "a product of %.0f weeks is longer than the %d that LNAV counts",
                            orr_time_diff_s(end, begin) / ORR_S_PER_WEEK, MOST_WEEKS);
    work w = {.e = e, .o = o};
    orr_navset *set = calloc(1, sizeof *set);
    orr_status s = set == NULL ? ORR_E_MEMORY : fit_all(&w);
    if (s == ORR_OK) {
        set->leap = o->leap != NULL ? o->leap : orr_leap_builtin();
        orr_ephemeris_span(e, &set->from, &set->to);
        take_klobuchar(set, o->nav, warnings);
        take_others(set, o->nav);
        s = collect(&w, set, warnings, diag);
        if (s == ORR_OK) s = navset_fit_days(e, o, set);
    }
    free(w.sat);
    if (s == ORR_OK)
        *out = set;
    else
        orr_navset_free(set);
    if (s == ORR_E_MEMORY) return orr_diag_set(diag, s, "out of memory for broadcast data");
    if (s == ORR_E_INTERRUPTED) return orr_diag_set(diag, s, "stopped");
    return s;
}

void orr_navset_free(orr_navset *set)
{
    if (set == NULL) return;
    for (size_t i = 0; i < set->n_sats; i++) free_series(&set->sets[i]);
    free(set->day);
    free(set->sets);
    free(set->sat);
    free(set);
}

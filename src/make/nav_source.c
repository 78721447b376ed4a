// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/nav_source.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "core/parallel.h"

enum { MAX_FILES = 400 };

// What the files say, and what the navset is shown of it: all ephemerides and ionospheres, those of
// ionosphere.field where the others have no GPS Klobuchar.
typedef struct files {
    orr_antex antex;
    orr_bias_set bias;
    orr_nav named, field;
    bool any;
    orr_nav shown; // borrows from the two
} files;

static void files_free(files *f)
{
    orr_nav_free(&f->named);
    orr_nav_free(&f->field);
    orr_bias_free(&f->bias);
    orr_antex_free(&f->antex);
}

static bool has_klobuchar(const orr_nav *nav)
{
    for (size_t i = 0; i < nav->n_iono; i++)
        if (nav->iono[i].kind == ORR_NAV_KLOBUCHAR && nav->iono[i].system == 'G') return true;
    return false;
}

// The navigation files of navdata.nav, and that of ionosphere.field if it is one.
static orr_status read_navs(const orr_scenario *s, files *f, orr_warnings *warnings, orr_diag *diag)
{
    const orr_text_list *list = &s->navdata.nav;
    if (list->n > MAX_FILES)
        return orr_diag_set(diag, ORR_E_LIMIT, "navdata.nav names %zu files, at most %d are read", list->n,
                            MAX_FILES);
    orr_status status =
        orr_nav_read_files((const char *const *)list->item, list->n, &f->named, warnings, diag);
    bool has_field = false;
    if (status == ORR_OK && s->iono.field != NULL) {
        orr_diag other = {0};
        status = orr_nav_read(s->iono.field, NULL, &f->field, NULL, &other);
        has_field = status == ORR_OK;
        if (status == ORR_E_KIND) status = ORR_OK; // maps or coefficients
        if (status != ORR_OK && diag != NULL) *diag = other;
    }
    if (status != ORR_OK) return status;
    // Ephemerides (GLONASS' channels) of the files that are named for it, or else of the ionosphere's;
    // likewise GPS' Klobuchar.
    f->any = list->n > 0 || has_field;
    f->shown = list->n > 0 ? f->named : f->field;
    if (has_field && !has_klobuchar(&f->shown)) {
        f->shown.iono = f->field.iono;
        f->shown.n_iono = f->field.n_iono;
    }
    return ORR_OK;
}

static orr_status read_all(const orr_scenario *s, files *f, orr_navset_options *o, orr_warnings *warnings,
                           orr_diag *diag)
{
    const orr_scenario_navdata *n = &s->navdata;
    orr_status status = ORR_OK;
    if (n->antex != NULL) {
        status = orr_antex_read(n->antex, NULL, &f->antex, warnings, diag);
        o->antex = &f->antex;
    }
    if (status == ORR_OK && n->bias != NULL) {
        status = orr_bias_read(n->bias, NULL, &f->bias, warnings, diag);
        o->bias = &f->bias;
    }
    if (status == ORR_OK) status = read_navs(s, f, warnings, diag);
    if (f->any) o->nav = &f->shown;
    return status;
}

// What the fit has to say of satellites, marked as being of the broadcast data: their orbits are served.
static orr_status build(const orr_ephemeris *e, const orr_navset_options *o, orr_navset **out,
                        orr_warnings *warnings, orr_diag *diag)
{
    orr_warnings own = {0};
    orr_status status = orr_navset_build(e, o, out, &own, diag);
    for (size_t i = 0; i < own.kept; i++)
        orr_warnings_add(warnings, NULL, 0, 0, "broadcast data: %s", own.item[i].text);
    if (warnings != NULL) warnings->count += own.count - own.kept;
    orr_warnings_free(&own);
    return status;
}

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

orr_status orr_nav_source_build(const orr_scenario *s, const orr_ephemeris *e, const orr_log *log,
                                const volatile int *cancel, orr_warnings *warnings, orr_navset **out,
                                char why[ORR_NAV_SOURCE_WHY], orr_diag *diag)
{
    *out = NULL;
    snprintf(why, ORR_NAV_SOURCE_WHY, "the scenario wants no broadcast data (navdata.window: none)");
    if (s->navdata.window == ORR_NAVDATA_NONE) return ORR_OK;
    files f = {0};
    orr_navset_options o = orr_navset_defaults();
    o.window_s = s->navdata.window == ORR_NAVDATA_4H ? 14400 : 7200;
    o.zero_clocks = s->navdata.zero_clocks;
    o.jobs = orr_parallel_cores();
    o.cancel = cancel;
    double begin_s = now_s();
    orr_diag inner = {0};
    orr_status status = read_all(s, &f, &o, warnings, &inner);
    if (status == ORR_OK) {
        status = build(e, &o, out, warnings, &inner);
        if (status == ORR_E_NODATA) { // no fault of the scenario: the rest of it is served
            snprintf(why, ORR_NAV_SOURCE_WHY, "%s", inner.text);
            ORR_LOG(log, ORR_LOG_INFO, "no broadcast data: %s", why);
            status = ORR_OK;
        }
    }
    files_free(&f);
    if (status != ORR_OK && diag != NULL) *diag = inner;
    if (*out != NULL) {
        const orr_sat *list;
        ORR_LOG(log, ORR_LOG_INFO, "fitted broadcast data of %zu satellites in %.1f s",
                orr_navset_satellites(*out, &list), now_s() - begin_s);
    }
    return status;
}

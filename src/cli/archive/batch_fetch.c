// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/archive/batch_fetch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/fetch/fetch.h"
#include "src/archive/record.h"
#include "src/archive/store.h"

static bool cancelled(void *user) { return orr_cli_interrupted(user); }

static void progress(void *user, const orr_fetch_progress *p)
{
    char what[160];
    snprintf(what, sizeof what, "fetching, %.1f MB %.60s", (double)p->bytes * 1e-6, p->name);
    orr_cli_progress(user, what, p->done, p->total);
}

// What is wanted of one day: its orbits, and what goes beside them of days that are made. Returns how many items.
static size_t ask_day(const orr_cli *c, const orr_archive_wants *wants, int32_t mjd, bool made,
                      orr_fetch_item *item)
{
    size_t n = 0;
    item[n++].wanted = (orr_wanted){.product = ORR_PRODUCT_SP3, .mjd = mjd, .tier = ORR_TIER_FINAL};
    if (made && wants->maps != NULL)
        item[n++].wanted = (orr_wanted){.product = ORR_PRODUCT_IONEX, .mjd = mjd, .tier = ORR_TIER_FINAL};
    for (size_t k = 0; k < n; k++)
        snprintf(item[k].wanted.centre, sizeof item[k].wanted.centre, "%s", orr_cli_text(c, "centre", ""));
    for (size_t k = 0; made && k < wants->n_stations; k++, n++) {
        item[n].wanted = (orr_wanted){.product = ORR_PRODUCT_OBS, .mjd = mjd, .tier = ORR_TIER_FINAL};
        snprintf(item[n].wanted.station, sizeof item[n].wanted.station, "%.9s", wants->station[k]);
    }
    return n;
}

static orr_status fetch(orr_cli *c, const orr_archives *a, orr_fetch_item *item, size_t n, orr_diag *diag)
{
    char cache[900];
    if (!orr_fetch_default_cache(cache, sizeof cache))
        return orr_diag_set(diag, ORR_E_IO, "there is no home folder to keep the cache in: set ORRERY_CACHE");
    orr_fetch_options o = orr_fetch_default_options(cache);
    o.offline = orr_cli_given(c, "offline");
    o.log = c->log;
    o.cancelled = cancelled;
    o.progress = progress;
    o.user = c;
    orr_cli_hold(c);
    const orr_status s = orr_fetch(a, &o, item, n, diag);
    orr_cli_progress(c, "", 1, 1);
    orr_cli_release(c);
    return s == ORR_E_NODATA ? ORR_OK : s; // told below, and by the days that lack it
}

// Table of archives: $ORRERY_ARCHIVES, or the built-in one.
static orr_status read_archives(orr_archives **out, orr_diag *diag)
{
    const char *table = getenv("ORRERY_ARCHIVES");
    return orr_archives_read(table != NULL && *table != '\0' ? table : NULL, out, diag);
}

static void tell_missing(const orr_cli *c, const orr_fetch_item *item)
{
    char day[ORR_ARCHIVE_DAY_TEXT];
    orr_cli_say(c, "%s: no %s: %s", orr_archive_day_text(item->wanted.mjd, day),
                orr_product_name(item->wanted.product), item->reason);
}

int batch_fetch_ultra(orr_cli *c, int32_t mjd)
{
    orr_diag diag = {0};
    orr_archives *a = NULL;
    orr_fetch_item *item = calloc(2, sizeof *item);
    orr_status s = item != NULL ? ORR_OK : orr_diag_set(&diag, ORR_E_MEMORY, "out of memory");
    for (int k = 0; s == ORR_OK && k < 2; k++) {
        orr_wanted *w = &item[k].wanted;
        *w = (orr_wanted){.product = ORR_PRODUCT_SP3, .mjd = mjd - 1 + k, .tier = ORR_TIER_ULTRA};
        snprintf(w->centre, sizeof w->centre, "%s", orr_cli_text(c, "centre", ""));
    }
    if (s == ORR_OK) s = read_archives(&a, &diag);
    if (s == ORR_OK) s = fetch(c, a, item, 2, &diag);
    for (int k = 0; s == ORR_OK && k < 2; k++)
        if (item[k].status != ORR_OK) tell_missing(c, &item[k]);
    orr_archives_free(a);
    free(item);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

int batch_fetch(orr_cli *c, const orr_archive_wants *wants, int32_t first, int32_t last, orr_archive_index *x)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_archives *a = NULL;
    const size_t most = (size_t)(last - first + 3) * (2 + ORR_ARCHIVE_MAX_STATIONS);
    orr_fetch_item *item = calloc(most, sizeof *item);
    const char **path = calloc(most, sizeof *path);
    size_t n = 0, n_paths = 0;
    orr_status s = item != NULL && path != NULL ? ORR_OK : orr_diag_set(&diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK) s = read_archives(&a, &diag);
    for (int32_t mjd = first - 1; s == ORR_OK && mjd <= last + 1; mjd++)
        n += ask_day(c, wants, mjd, mjd >= first && mjd <= last, item + n);
    if (s == ORR_OK) s = fetch(c, a, item, n, &diag);
    for (size_t k = 0; s == ORR_OK && k < n; k++) {
        if (item[k].status == ORR_OK)
            path[n_paths++] = item[k].path;
        else
            tell_missing(c, &item[k]);
    }
    if (s == ORR_OK) s = orr_archive_index_of(path, n_paths, wants, c->leap, x, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    orr_archives_free(a);
    free(item);
    free(path);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

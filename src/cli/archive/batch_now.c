// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/archive/batch_now.h"

#include <stdlib.h>
#include <unistd.h>

#include "core/monotonic.h"
#include "core/parallel.h"
#include "ingest/fetch/fetch.h"
#include "src/archive/day_now.h"
#include "src/archive/store.h"
#include "src/cli/archive/batch_fetch.h"

#define BEYOND_NS (INT64_C(6) * 3600 * ORR_NS_PER_S) // how soon the next day is wanted too

static int find_files(orr_cli *c, orr_time present, orr_newest *newest)
{
    char cache[ORR_NEWEST_PATH / 2];
    orr_diag diag = {0};
    const char *folder = orr_cli_text(c, "inputs", NULL);
    if (folder == NULL && !orr_fetch_default_cache(cache, sizeof cache))
        return orr_cli_failf(c, "there is no home folder with the cache: set ORRERY_CACHE");
    if (orr_cli_given(c, "fetch")) {
        const int fetched = batch_fetch_ultra(c, orr_archive_day_of(present));
        if (fetched != ORR_EXIT_OK) return fetched;
    }
    if (orr_newest_find(folder != NULL ? folder : cache, present, newest, &diag) != ORR_OK)
        return orr_cli_fail(c, &diag);
    return ORR_EXIT_OK;
}

// One day: there already, made, or told why not.
static int make_day(orr_cli *c, const orr_archive_settings *settings, const orr_newest *newest, int32_t mjd,
                    orr_archive_record *r)
{
    char day[ORR_ARCHIVE_DAY_TEXT], until[ORR_TIME_TEXT], why[900];
    orr_diag diag = {0};
    const double begin_s = orr_monotonic_s();
    orr_archive_day_text(mjd, day);
    orr_status s = orr_archive_now_plan(newest, mjd, r, &diag);
    if (s == ORR_OK && !orr_cli_given(c, "again") && orr_archive_day_is_fresh(settings, r)) {
        orr_cli_say(c, "%s: is there", day);
        return ORR_EXIT_OK;
    }
    if (s == ORR_OK)
        s = orr_archive_now_make(settings, newest, (int)orr_cli_int(c, "jobs", orr_parallel_cores()), r,
                                 &diag);
    if (s != ORR_OK)
        return orr_cli_failf(c, "%s: not made: %s", day, orr_diag_format(&diag, why, sizeof why));
    orr_cli_say(c, "%s: made, observed until %s, in %.1f s", day, orr_time_text(r->observed_until, until),
                orr_monotonic_s() - begin_s);
    return ORR_EXIT_OK;
}

int batch_now(orr_cli *c)
{
    const orr_archive_settings settings = {.archive = orr_cli_text(c, "archive", NULL),
                                           .leap = c->leap,
                                           .extras = {.navdata = orr_cli_given(c, "navdata")}};
    const orr_time present = orr_cli_given(c, "present") ? orr_cli_time(c, "present", 0) : orr_present();
    orr_newest *newest = malloc(sizeof *newest);
    orr_archive_record *r = malloc(sizeof *r);
    orr_diag diag = {0};
    int lock = -1;
    int status = newest != NULL && r != NULL ? ORR_EXIT_OK : orr_cli_failf(c, "no memory for a record");
    if (status == ORR_EXIT_OK) status = find_files(c, present, newest);
    if (status == ORR_EXIT_OK) {
        orr_status s = orr_archive_open(settings.archive, &diag);
        if (s == ORR_OK) s = orr_archive_lock(settings.archive, &lock, &diag);
        if (s == ORR_OK) s = orr_archive_strays(settings.archive, true, NULL, NULL, &diag);
        if (s != ORR_OK) status = orr_cli_fail(c, &diag);
    }
    const int32_t last = orr_archive_day_of(present + BEYOND_NS);
    for (int32_t mjd = orr_archive_day_of(present); status == ORR_EXIT_OK && mjd <= last; mjd++)
        status = make_day(c, &settings, newest, mjd, r);
    if (lock >= 0) close(lock);
    free(r);
    free(newest);
    return status;
}

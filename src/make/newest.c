// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/newest.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>

#include "ingest/sp3/sp3.h"

#define MJD_OF_1970 40587
#define DAYS_BACK 3
#define LEAST_BEFORE_NS (12 * 3600 * ORR_NS_PER_S) // of the second file's end before the first one's
#define MOST_BEFORE_NS (36 * 3600 * ORR_NS_PER_S)
#define WANTED_BEFORE_NS (ORR_S_PER_DAY * ORR_NS_PER_S)
#define CENTRE 3 // letters of a name that tell who made it

typedef struct candidate {
    char path[ORR_NEWEST_PATH], name[256];
    orr_time end; // of what is observed
} candidate;

// End of the observed part of an ultra-rapid file; ORR_TIME_NONE for other files, and for those that no reader takes.
static orr_time observed_end(const char *path)
{
    orr_sp3 f;
    orr_time end = ORR_TIME_NONE;
    bool predicted = false;
    if (orr_sp3_read(path, NULL, &f, NULL, NULL) != ORR_OK) return end;
    for (size_t e = 0; e < f.n_epochs; e++)
        for (size_t k = 0; k < f.n_sats; k++) {
            const orr_sp3_record *r = &f.record[e * f.n_sats + k];
            if (r->pos_m[0] != r->pos_m[0]) continue; // no position
            if ((r->flags & ORR_SP3_ORBIT_PREDICTED) != 0)
                predicted = true;
            else
                end = f.epoch[e];
        }
    orr_sp3_free(&f);
    return predicted ? end : ORR_TIME_NONE;
}

static bool looks_like_sp3(const char *name)
{
    for (; *name != '\0'; name++)
        if (strncasecmp(name, "sp3", 3) == 0) return true;
    return false;
}

typedef void (*visitor)(const candidate *c, void *user);

static void visit_folder(const char *cache, int32_t mjd, visitor visit, void *user)
{
    char folder[ORR_NEWEST_PATH - 260];
    int year, month, day;
    orr_date_from_mjd(mjd, &year, &month, &day);
    const int n =
        snprintf(folder, sizeof folder, "%s/%04d/%03d", cache, year, orr_day_of_year(year, month, day));
    if (n < 0 || (size_t)n >= sizeof folder) return;
    DIR *d = opendir(folder);
    if (d == NULL) return;
    for (struct dirent *entry; (entry = readdir(d)) != NULL;) {
        candidate c;
        if (!looks_like_sp3(entry->d_name) || strstr(entry->d_name, ".part") != NULL) continue;
        snprintf(c.name, sizeof c.name, "%s", entry->d_name);
        snprintf(c.path, sizeof c.path, "%s/%s", folder, entry->d_name);
        c.end = observed_end(c.path);
        if (c.end != ORR_TIME_NONE) visit(&c, user);
    }
    closedir(d);
}

static void visit_days(const char *cache, orr_time present, visitor visit, void *user)
{
    int32_t today;
    double fraction;
    orr_time_mjd(present, ORR_SCALE_GPS, NULL, &today, &fraction);
    for (int32_t day = today - DAYS_BACK; day <= today; day++) visit_folder(cache, day, visit, user);
}

typedef struct search {
    orr_time present;
    candidate newest, before;
} search;

// Names decide between files that end together, so that the order of a folder does not.
static bool later(const candidate *a, const candidate *b)
{
    if (b->end == ORR_TIME_NONE || a->end != b->end) return b->end == ORR_TIME_NONE || a->end > b->end;
    return strcmp(a->name, b->name) < 0;
}

static void keep_newest(const candidate *c, void *user)
{
    search *s = user;
    if (c->end <= s->present && later(c, &s->newest)) s->newest = *c;
}

static void keep_before(const candidate *c, void *user)
{
    search *s = user;
    const int64_t by = s->newest.end - c->end;
    if (strncmp(c->name, s->newest.name, CENTRE) != 0 || by < LEAST_BEFORE_NS || by > MOST_BEFORE_NS) return;
    const int64_t off = llabs(by - WANTED_BEFORE_NS),
                  old = llabs(s->newest.end - s->before.end - WANTED_BEFORE_NS);
    if (s->before.end == ORR_TIME_NONE || off < old || (off == old && strcmp(c->name, s->before.name) < 0))
        s->before = *c;
}

orr_time orr_present(void)
{
    struct timespec t;
    clock_gettime(CLOCK_REALTIME, &t);
    const int32_t day = (int32_t)(t.tv_sec / ORR_S_PER_DAY);
    const double fraction = (double)(t.tv_sec % ORR_S_PER_DAY) / ORR_S_PER_DAY;
    return orr_time_from_mjd(MJD_OF_1970 + day, fraction, ORR_SCALE_UTC, NULL);
}

orr_status orr_newest_find(const char *cache, orr_time present, orr_newest *out, orr_diag *diag)
{
    search s = {.present = present, .newest = {.end = ORR_TIME_NONE}, .before = {.end = ORR_TIME_NONE}};
    *out = (orr_newest){0};
    visit_days(cache, present, keep_newest, &s);
    if (s.newest.end == ORR_TIME_NONE) {
        char when[ORR_TIME_TEXT];
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "no ultra-rapid orbits of the %d days up to %s in %s: name SP3 files, or fetch some "
            "(orrery fetch --tier ultra --products sp3 DATE)",
            DAYS_BACK, orr_time_text(present, when), cache);
    }
    visit_days(cache, present, keep_before, &s);
    if (s.before.end != ORR_TIME_NONE) memcpy(out->path[out->n++], s.before.path, sizeof s.before.path);
    memcpy(out->path[out->n++], s.newest.path, sizeof s.newest.path);
    return ORR_OK;
}

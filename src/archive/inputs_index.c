// SPDX-License-Identifier: GPL-3.0-or-later
#define _XOPEN_SOURCE 700
#include "src/archive/inputs_index.h"

#include <errno.h>
#include <fnmatch.h>
#include <fts.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "core/array.h"
#include "core/path.h"
#include "ingest/input/input.h"
#include "ingest/input/sniff.h"
#include "ingest/rinex/rinex_obs.h"
#include "iono/field/tec_files.h"
#include "src/archive/store.h"

#define LONGEST_S (30 * 3600.0)

// Begin and length of an SP3 file by its first two lines: "#cP2024  2  4  0  0  0.00000000      96 ...", "## week seconds step ...".
static bool span_of(orr_view head, const orr_leap_table *leap, orr_time *from, double *length_s)
{
    char text[4096];
    const size_t n = head.n < sizeof text - 1 ? head.n : sizeof text - 1;
    memcpy(text, head.p, n);
    text[n] = '\0';
    orr_civil c = {0};
    double second, week_s, step_s;
    int epochs, week;
    const char *second_line = strstr(text, "\n##");
    const size_t at = n > 2 && (text[2] == 'P' || text[2] == 'V' || text[2] == ' ') ? 3 : 2;
    if (second_line == NULL || n < 60) return false;
    if (sscanf(text + at, "%d %d %d %d %d %lf %d", &c.year, &c.month, &c.day, &c.hour, &c.minute, &second,
               &epochs) != 7)
        return false;
    if (sscanf(second_line + 3, "%d %lf %lf", &week, &week_s, &step_s) != 3) return false;
    if (!(second >= 0 && second < 60) || !(step_s > 0) || epochs < 1) return false;
    c.second = (int)second;
    *length_s = step_s * (epochs - 1);
    return orr_time_from_civil(&c, ORR_SCALE_GPS, leap, from) == ORR_OK;
}

static orr_status append(orr_archive_input **list, size_t *n, const char *path, orr_time from, size_t station)
{
    if (!ORR_ARRAY_GROW(*list, *n)) return ORR_E_MEMORY;
    orr_archive_input *item = &(*list)[*n];
    *item = (orr_archive_input){.mjd = orr_archive_day_of(from), .path = strdup(path), .station = station};
    if (item->path == NULL) return ORR_E_MEMORY;
    ++*n;
    return ORR_OK;
}

// The day of a file of maps is that of its middle: those of a day have both midnights, and UT ends some seconds later.
static orr_status look_at_map(const char *path, const orr_leap_table *leap, orr_archive_index *x,
                              orr_warnings *warnings)
{
    orr_tec_field *field = NULL;
    orr_diag why = {0};
    orr_time from, to;
    orr_tec_options mine = orr_tec_default_options();
    mine.leap = leap;
    mine.spatial = ORR_TEC_BILINEAR; // no refit: only its instants are wanted here
    if (orr_tec_field_open(path, &mine, &field, NULL, &why) != ORR_OK) {
        orr_warnings_add(warnings, path, 0, 0, "is left out: %.300s", why.text);
        return ORR_OK;
    }
    orr_tec_field_span(field, &from, &to);
    orr_tec_field_free(field);
    return append(&x->map, &x->n_maps, path, from + (to - from) / 2, 0);
}

// Observations of a wanted station, by the marker's name or, without one, the file's.
static orr_status look_at_obs(const char *path, const orr_leap_table *leap, const orr_archive_wants *wants,
                              orr_archive_index *x, orr_warnings *warnings)
{
    orr_rinex_obs_limits limits = orr_rinex_obs_default_limits();
    orr_rinex_obs *r = NULL;
    orr_diag why = {0};
    limits.leap = leap;
    if (orr_rinex_obs_open(path, &limits, NULL, &r, &why) != ORR_OK) {
        orr_warnings_add(warnings, path, 0, 0, "is left out: %.300s", why.text);
        return ORR_OK;
    }
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(r);
    const char *name = h->marker_name[0] != '\0' ? h->marker_name : orr_base_name(path);
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < wants->n_stations; k++)
        if (strncasecmp(name, wants->station[k], strlen(wants->station[k])) == 0 && h->first != ORR_TIME_NONE)
            s = append(&x->obs, &x->n_obs, path, h->first, k);
    orr_rinex_obs_close(r);
    return s;
}

// Adds a file if it is an SP3 file of one day, or what else is wanted.
static orr_status look_at(const char *path, const char *name, const orr_archive_wants *wants,
                          const orr_leap_table *leap, orr_archive_index *x, orr_warnings *warnings)
{
    orr_input *in;
    orr_diag why = {0};
    if (orr_input_open(path, NULL, &in, &why) != ORR_OK) {
        if (why.status == ORR_E_IO) orr_warnings_add(warnings, path, 0, 0, "%s", why.text);
        x->n_other++;
        return ORR_OK;
    }
    const orr_view head = orr_input_head(in);
    orr_time from = 0;
    double length_s = 0;
    const orr_kind kind = orr_sniff(head).kind;
    const char *base = orr_base_name(path);
    if ((kind == ORR_KIND_IONEX || kind == ORR_KIND_ION) && wants != NULL && wants->maps != NULL &&
        fnmatch(wants->maps, base, 0) == 0) {
        orr_input_close(in);
        return look_at_map(path, leap, x, warnings);
    }
    if ((kind == ORR_KIND_RINEX_OBS || kind == ORR_KIND_CRINEX) && wants != NULL && wants->n_stations > 0) {
        orr_input_close(in);
        return look_at_obs(path, leap, wants, x, warnings);
    }
    const bool sp3 = kind == ORR_KIND_SP3 && (name == NULL || fnmatch(name, base, 0) == 0);
    const bool dated = sp3 && span_of(head, leap, &from, &length_s);
    if (sp3 && !dated)
        orr_warnings_add(warnings, path, 1, 0, "is left out: its first lines do not say which day it is of");
    orr_input_close(in);
    if (!dated || length_s > LONGEST_S) {
        x->n_other++;
        return ORR_OK;
    }
    return append(&x->item, &x->n, path, from, 0);
}

static int by_day(const void *a, const void *b)
{
    const orr_archive_input *x = a, *y = b;
    if (x->mjd != y->mjd) return x->mjd < y->mjd ? -1 : 1;
    return strcmp(x->path, y->path);
}

static void sort_all(orr_archive_index *x)
{
    if (x->n > 0) qsort(x->item, x->n, sizeof *x->item, by_day);
    if (x->n_maps > 0) qsort(x->map, x->n_maps, sizeof *x->map, by_day);
    if (x->n_obs > 0) qsort(x->obs, x->n_obs, sizeof *x->obs, by_day);
}

orr_status orr_archive_index_make(const char *folder, const char *name, const orr_archive_wants *wants,
                                  const orr_leap_table *leap, orr_archive_index *out, orr_warnings *warnings,
                                  orr_diag *diag)
{
    *out = (orr_archive_index){0};
    struct stat st;
    if (stat(folder, &st) != 0)
        return orr_diag_at(diag, ORR_E_IO, folder, 0, 0, "cannot be read: %s", strerror(errno));
    if (!S_ISDIR(st.st_mode)) return orr_diag_at(diag, ORR_E_IO, folder, 0, 0, "is no folder");
    char *root = strdup(folder), *list[2] = {root, NULL};
    FTS *tree = root != NULL ? fts_open(list, FTS_LOGICAL | FTS_NOCHDIR, NULL) : NULL;
    if (tree == NULL) {
        free(root);
        return orr_diag_at(diag, ORR_E_IO, folder, 0, 0, "cannot be read: %s", strerror(errno));
    }
    orr_status s = ORR_OK;
    for (FTSENT *e; s == ORR_OK && (e = fts_read(tree)) != NULL;) {
        if (e->fts_info == FTS_DNR)
            orr_warnings_add(warnings, e->fts_path, 0, 0, "cannot be read: %s", strerror(e->fts_errno));
        if (e->fts_info == FTS_F) s = look_at(e->fts_path, name, wants, leap, out, warnings);
    }
    fts_close(tree);
    free(root);
    if (s != ORR_OK) return orr_diag_set(diag, s, "no memory for the list of files in %s", folder);
    sort_all(out);
    return ORR_OK;
}

orr_status orr_archive_index_of(const char *const *path, size_t n, const orr_archive_wants *wants,
                                const orr_leap_table *leap, orr_archive_index *out, orr_warnings *warnings,
                                orr_diag *diag)
{
    *out = (orr_archive_index){0};
    for (size_t i = 0; i < n; i++) {
        const orr_status s = look_at(path[i], NULL, wants, leap, out, warnings);
        if (s != ORR_OK) return orr_diag_set(diag, s, "no memory for a list of files");
    }
    sort_all(out);
    return ORR_OK;
}

orr_status orr_archive_index_add_erp(orr_archive_index *x, const char *path, orr_diag *diag)
{
    if (x->n_erp == ORR_ARCHIVE_MAX_ERP)
        return orr_diag_set(diag, ORR_E_LIMIT, "at most %d files of Earth rotation parameters are used",
                            ORR_ARCHIVE_MAX_ERP);
    char *copy = strdup(path);
    if (copy == NULL || !ORR_ARRAY_GROW(x->erp, x->n_erp)) {
        free(copy);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the name of %s", path);
    }
    orr_archive_input *item = &x->erp[x->n_erp++];
    *item = (orr_archive_input){.path = copy};
    return orr_sha256_file(path, item->sha256, diag);
}

static void free_list(orr_archive_input *list, size_t n)
{
    for (size_t i = 0; i < n; i++) free(list[i].path);
    free(list);
}

void orr_archive_index_free(orr_archive_index *x)
{
    free_list(x->erp, x->n_erp);
    free_list(x->item, x->n);
    free_list(x->map, x->n_maps);
    free_list(x->obs, x->n_obs);
    *x = (orr_archive_index){0};
}

// The first of a list that is of a day or later.
static size_t first_from(const orr_archive_input *list, size_t n, int32_t mjd)
{
    size_t low = 0, high = n;
    while (low < high) {
        const size_t mid = low + (high - low) / 2;
        if (list[mid].mjd < mjd)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

// The only one of a day. Given: the list, the day, what its files are and which option chooses among them.
static orr_status find_only(const orr_archive_input *list, size_t n, int32_t mjd, const char *what,
                            const char *choose, const orr_archive_input **input, orr_diag *diag)
{
    char day[ORR_ARCHIVE_DAY_TEXT];
    const size_t k = first_from(list, n, mjd);
    *input = NULL;
    if (k == n || list[k].mjd != mjd)
        return orr_diag_set(diag, ORR_E_NODATA, "there is no %s file of %s", what,
                            orr_archive_day_text(mjd, day));
    if (k + 1 < n && list[k + 1].mjd == mjd)
        return orr_diag_set(diag, ORR_E_ARG,
                            "several %s files are of %s: %.100s and %.100s; choose by %s, e.g. %s 'COD*'",
                            what, orr_archive_day_text(mjd, day), orr_base_name(list[k].path),
                            orr_base_name(list[k + 1].path), choose, choose);
    *input = &list[k];
    return ORR_OK;
}

orr_status orr_archive_index_find(const orr_archive_index *x, int32_t mjd, const orr_archive_input **input,
                                  orr_diag *diag)
{
    return find_only(x->item, x->n, mjd, "SP3", "--name", input, diag);
}

orr_status orr_archive_index_find_map(const orr_archive_index *x, int32_t mjd, const orr_archive_input **map,
                                      orr_diag *diag)
{
    return find_only(x->map, x->n_maps, mjd, "TEC", "--tec", map, diag);
}

const orr_archive_input *orr_archive_index_find_obs(const orr_archive_index *x, int32_t mjd, size_t station)
{
    for (size_t k = first_from(x->obs, x->n_obs, mjd); k < x->n_obs && x->obs[k].mjd == mjd; k++)
        if (x->obs[k].station == station) return &x->obs[k];
    return NULL;
}

static orr_status hash_list(orr_archive_input *list, size_t n, int32_t first, int32_t last, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t i = first_from(list, n, first); i < n && s == ORR_OK && list[i].mjd <= last; i++)
        if (list[i].sha256[0] == '\0') s = orr_sha256_file(list[i].path, list[i].sha256, diag);
    return s;
}

orr_status orr_archive_index_hash(orr_archive_index *x, int32_t first, int32_t last, orr_diag *diag)
{
    orr_status s = hash_list(x->item, x->n, first, last, diag);
    if (s == ORR_OK) s = hash_list(x->map, x->n_maps, first, last, diag);
    if (s == ORR_OK) s = hash_list(x->obs, x->n_obs, first, last, diag);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#define _XOPEN_SOURCE 700
#include "src/archive/inputs_index.h"

#include <errno.h>
#include <fnmatch.h>
#include <fts.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/array.h"
#include "core/path.h"
#include "ingest/input/input.h"
#include "ingest/input/sniff.h"
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

// Adds a file if it is an SP3 file of one day.
static orr_status look_at(const char *path, const orr_leap_table *leap, orr_archive_index *x,
                          orr_warnings *warnings)
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
    const bool sp3 = orr_sniff(head).kind == ORR_KIND_SP3;
    const bool dated = sp3 && span_of(head, leap, &from, &length_s);
    if (sp3 && !dated)
        orr_warnings_add(warnings, path, 1, 0, "is left out: its first lines do not say which day it is of");
    orr_input_close(in);
    if (!dated || length_s > LONGEST_S) {
        x->n_other++;
        return ORR_OK;
    }
    if (!ORR_ARRAY_GROW(x->item, x->n)) return ORR_E_MEMORY;
    orr_archive_input *item = &x->item[x->n];
    *item = (orr_archive_input){.mjd = orr_archive_day_of(from), .path = strdup(path)};
    if (item->path == NULL) return ORR_E_MEMORY;
    x->n++;
    return ORR_OK;
}

static int by_day(const void *a, const void *b)
{
    const orr_archive_input *x = a, *y = b;
    if (x->mjd != y->mjd) return x->mjd < y->mjd ? -1 : 1;
    return strcmp(x->path, y->path);
}

orr_status orr_archive_index_make(const char *folder, const char *name, const orr_leap_table *leap,
                                  orr_archive_index *out, orr_warnings *warnings, orr_diag *diag)
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
        if (e->fts_info == FTS_F && (name == NULL || fnmatch(name, e->fts_name, 0) == 0))
            s = look_at(e->fts_path, leap, out, warnings);
    }
    fts_close(tree);
    free(root);
    if (s != ORR_OK) return orr_diag_set(diag, s, "no memory for the list of files in %s", folder);
    if (out->n > 0) qsort(out->item, out->n, sizeof *out->item, by_day);
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

void orr_archive_index_free(orr_archive_index *x)
{
    for (size_t i = 0; i < x->n_erp; i++) free(x->erp[i].path);
    free(x->erp);
    for (size_t i = 0; i < x->n; i++) free(x->item[i].path);
    free(x->item);
    *x = (orr_archive_index){0};
}

orr_status orr_archive_index_find(const orr_archive_index *x, int32_t mjd, const orr_archive_input **input,
                                  orr_diag *diag)
{
    char day[ORR_ARCHIVE_DAY_TEXT];
    *input = NULL;
    size_t low = 0, high = x->n;
    while (low < high) {
        const size_t mid = low + (high - low) / 2;
        if (x->item[mid].mjd < mjd)
            low = mid + 1;
        else
            high = mid;
    }
    if (low == x->n || x->item[low].mjd != mjd)
        return orr_diag_set(diag, ORR_E_NODATA, "there is no SP3 file of %s", orr_archive_day_text(mjd, day));
    if (low + 1 < x->n && x->item[low + 1].mjd == mjd)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "several SP3 files are of %s: %.100s and %.100s; choose by --name, e.g. --name 'COD*'",
            orr_archive_day_text(mjd, day), orr_base_name(x->item[low].path),
            orr_base_name(x->item[low + 1].path));
    *input = &x->item[low];
    return ORR_OK;
}

orr_status orr_archive_index_hash(orr_archive_index *x, int32_t first, int32_t last, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t i = 0; i < x->n && s == ORR_OK; i++)
        if (x->item[i].mjd >= first && x->item[i].mjd <= last && x->item[i].sha256[0] == '\0')
            s = orr_sha256_file(x->item[i].path, x->item[i].sha256, diag);
    return s;
}

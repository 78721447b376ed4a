// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/day.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/path.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/solution_cut.h"
#include "orbit/smooth/solution_join.h"
#include "src/archive/store.h"
#include "src/make/orbit.h"

#define ORBIT "orbit.nc"
#define WINDOW_H 15                                 // that is smoothed to either side of a midnight
#define OVER_S (3 * 3600.0)                         // before and after noon: a window's edges have no weight
#define FAR_NS (INT64_C(20) * 86400 * ORR_NS_PER_S) // beyond any file of a neighbouring day
#define WINDOW_NS (INT64_C(3600) * WINDOW_H * ORR_NS_PER_S)

static void take_input(orr_archive_record *r, const char *path, const char *sha256)
{
    orr_archive_take_file(&r->input[r->n_inputs++], path, sha256);
}

// The files of a day and of those beside it, where they are; the day's own must be.
static orr_status files_of(const orr_archive_index *index, int32_t mjd, const orr_archive_input *file[3],
                           orr_diag *diag)
{
    orr_status s = orr_archive_index_find(index, mjd, &file[1], diag);
    for (int k = -1; k <= 1 && s == ORR_OK; k += 2) {
        orr_diag why = {0};
        s = orr_archive_index_find(index, mjd + k, &file[k + 1], &why);
        if (s == ORR_E_NODATA)
            s = ORR_OK;
        else if (s != ORR_OK && diag != NULL)
            *diag = why;
    }
    return s;
}

orr_status orr_archive_day_plan(const orr_archive_settings *settings, const orr_archive_index *index,
                                int32_t mjd, orr_archive_record *r, orr_diag *diag)
{
    const orr_archive_input *file[3];
    *r = (orr_archive_record){.mjd = mjd, .observed_until = ORR_TIME_NONE};
    snprintf(r->program, sizeof r->program, "orrery %s", ORR_VERSION);
    snprintf(r->options, sizeof r->options,
             "about each midnight %d h to either side, over within %g h of noon", WINDOW_H, OVER_S / 3600);
    orr_status s = files_of(index, mjd, file, diag);
    if (s != ORR_OK) return s;
    r->before = file[0] != NULL;
    r->after = file[2] != NULL;
    for (int k = 0; k < 3; k++)
        if (file[k] != NULL) take_input(r, file[k]->path, file[k]->sha256);
    for (size_t i = 0; i < index->n_erp; i++) take_input(r, index->erp[i].path, index->erp[i].sha256);
    orr_archive_extras_plan(&settings->extras, index, r);
    orr_archive_key(r->program, r->options, r->input, r->n_inputs, r->key);
    return ORR_OK;
}

// Whether a product has the size that its record tells: what was cut short is made anew without reading all of it.
static bool is_whole(const char *folder, const orr_archive_file *product)
{
    char path[ORR_ARCHIVE_PATH];
    struct stat st;
    snprintf(path, sizeof path, "%.900s/%s", folder, product->name);
    return stat(path, &st) == 0 && (int64_t)st.st_size == product->bytes;
}

bool orr_archive_day_is_fresh(const orr_archive_settings *settings, const orr_archive_record *planned)
{
    char folder[ORR_ARCHIVE_PATH];
    orr_archive_record *there = malloc(sizeof *there);
    orr_archive_path(settings->archive, planned->mjd, NULL, folder);
    bool fresh = there != NULL && orr_archive_record_read(folder, there, NULL) == ORR_OK;
    const bool better =
        fresh && orr_archive_is_predicted(planned) && !orr_archive_is_predicted(there); // it is observed
    fresh = fresh && (better || strcmp(there->key, planned->key) == 0);
    for (size_t k = 0; fresh && k < there->n_products; k++) fresh = is_whole(folder, &there->product[k]);
    free(there);
    return fresh;
}

void orr_archive_note_warnings(orr_archive_record *r, const orr_warnings *w)
{
    for (size_t i = 0; i < w->kept && r->n_notes < ORR_ARCHIVE_MAX_NOTES; i++)
        snprintf(r->note[r->n_notes++], sizeof r->note[0], "%.80s%s%.160s", orr_base_name(w->item[i].file),
                 w->item[i].file[0] != '\0' ? ": " : "", w->item[i].text);
}

void orr_archive_midnight_free(orr_archive_midnight *m)
{
    orr_orbit_solution_free(&m->solution);
    orr_warnings_free(&m->warnings);
    *m = (orr_archive_midnight){0};
}

// Smooths the hours about the midnight that day mjd begins with, of one or two files.
static orr_status smooth_midnight(const orr_archive_settings *settings, const orr_archive_index *index,
                                  const char *const *sp3, size_t n_sp3, int32_t mjd, orr_orbit_solution *out,
                                  orr_warnings *warnings, orr_diag *diag)
{
    const orr_time midnight = orr_archive_day_begin(mjd);
    const orr_interval outside[2] = {{midnight - FAR_NS, midnight - WINDOW_NS},
                                     {midnight + WINDOW_NS + 1, midnight + FAR_NS}};
    const char *erp[ORR_ARCHIVE_MAX_ERP];
    orr_orbit_plan plan = orr_orbit_plan_default();
    orr_orbit_made made = {0};
    plan.sp3 = sp3;
    plan.n_sp3 = n_sp3;
    for (size_t i = 0; i < index->n_erp; i++) erp[i] = index->erp[i].path;
    plan.erp = erp;
    plan.n_erp = index->n_erp;
    plan.leap = settings->leap;
    plan.smoother.jobs = 1;
    plan.smoother.exclude = outside;
    plan.smoother.n_exclude = 2;
    const orr_status s = orr_orbit_solve(&plan, NULL, NULL, &made, warnings, diag);
    *out = made.solution;
    made.solution = (orr_orbit_solution){0};
    orr_orbit_made_free(&made);
    return s;
}

// The solution about a day's begin or end: together with the neighbour there, or without it where it cannot be used; it is
// `there` for the next day if the neighbour is in it.
//   Given:    settings    of the batch
//             index       input files
//             own, other  files of the day and of its neighbour; other may be NULL
//             mjd         the day that begins with the midnight
//   Returned: out         the solution; free with orr_archive_midnight_free
//             diag        why there is none
static orr_status about_midnight(const orr_archive_settings *settings, const orr_archive_index *index,
                                 const orr_archive_input *own, const orr_archive_input *other, int32_t mjd,
                                 orr_archive_midnight *out, orr_diag *diag)
{
    orr_diag why = {0};
    *out = (orr_archive_midnight){.mjd = mjd};
    if (other != NULL) { // in the order of days, so that both days read the same
        const bool first = other->mjd < own->mjd;
        const char *sp3[2] = {first ? other->path : own->path, first ? own->path : other->path};
        out->there =
            smooth_midnight(settings, index, sp3, 2, mjd, &out->solution, &out->warnings, &why) == ORR_OK;
        if (out->there) return ORR_OK;
        orr_archive_midnight_free(out);
        out->mjd = mjd;
        orr_warnings_add(&out->warnings, other->path, 0, 0, "is left aside: %.200s", why.text);
    }
    const char *alone[1] = {own->path};
    return smooth_midnight(settings, index, alone, 1, mjd, &out->solution, &out->warnings, diag);
}

// The day's solution: from that about its begin to that about its end.
static orr_status solve_day(const orr_archive_settings *settings, const orr_archive_index *index,
                            orr_archive_midnight *last, orr_archive_record *r, orr_orbit_solution *out,
                            orr_diag *diag)
{
    const orr_archive_input *file[3];
    const orr_time begin = orr_archive_day_begin(r->mjd), end = orr_archive_day_begin(r->mjd + 1);
    orr_archive_midnight before = {0}, after = {0};
    orr_status s = files_of(index, r->mjd, file, diag);
    if (s == ORR_OK && last->there && last->mjd == r->mjd) {
        before = *last;
        *last = (orr_archive_midnight){0};
    } else if (s == ORR_OK)
        s = about_midnight(settings, index, file[1], file[0], r->mjd, &before, diag);
    if (s == ORR_OK) s = about_midnight(settings, index, file[1], file[2], r->mjd + 1, &after, diag);
    if (s == ORR_OK)
        s = orr_orbit_solution_join(&before.solution, &after.solution, begin + (end - begin) / 2, OVER_S, out,
                                    diag);
    if (s == ORR_OK) orr_orbit_solution_cut(out, begin, end);
    r->before = before.there;
    r->after = after.there;
    orr_archive_note_warnings(r, &before.warnings);
    orr_archive_note_warnings(r, &after.warnings);
    orr_archive_midnight_free(&before);
    orr_archive_midnight_free(last);
    if (s == ORR_OK && after.there)
        *last = after;
    else
        orr_archive_midnight_free(&after);
    return s;
}

orr_status orr_archive_day_put(const orr_archive_settings *settings, const orr_archive_index *index,
                               const orr_orbit_solution *solution, orr_archive_record *r, orr_diag *diag)
{
    char staging[ORR_ARCHIVE_PATH] = "", path[ORR_ARCHIVE_PATH], call[64], day[ORR_ARCHIVE_DAY_TEXT];
    orr_ephemeris *product = NULL;
    orr_status s = orr_ephemeris_build(solution, &product, diag);
    if (s == ORR_OK) s = orr_archive_stage(settings->archive, r->mjd, staging, diag);
    if (s == ORR_OK) {
        snprintf(path, sizeof path, "%.900s/" ORBIT, staging);
        snprintf(call, sizeof call, "orrery batch, day %s", orr_archive_day_text(r->mjd, day));
        s = orr_ephemeris_save(product, path, call, diag);
    }
    if (s == ORR_OK) {
        orr_archive_judge(solution, r);
        s = orr_archive_note_product(r, staging, ORBIT, diag);
    }
    if (s == ORR_OK) s = orr_archive_extras_make(&settings->extras, index, settings->leap, staging, r, diag);
    if (s == ORR_OK) s = orr_archive_record_write(r, staging, diag);
    if (s == ORR_OK) s = orr_archive_commit(settings->archive, r->mjd, staging, diag);
    if (s != ORR_OK && staging[0] != '\0') orr_archive_remove(staging);
    orr_ephemeris_free(product);
    return s;
}

orr_status orr_archive_day_make(const orr_archive_settings *settings, const orr_archive_index *index,
                                orr_archive_midnight *last, orr_archive_record *r, orr_diag *diag)
{
    orr_orbit_solution solution = {0};
    orr_status s = solve_day(settings, index, last, r, &solution, diag);
    if (s == ORR_OK) s = orr_archive_day_put(settings, index, &solution, r, diag);
    orr_orbit_solution_free(&solution);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/day_now.h"

#include <stdio.h>

#include "orbit/smooth/solution_cut.h"
#include "src/archive/store.h"
#include "src/make/orbit.h"

orr_status orr_archive_now_plan(const orr_newest *newest, int32_t mjd, orr_archive_record *r, orr_diag *diag)
{
    orr_status s = ORR_OK;
    // Until when it is observed is known when it is made; that it is predicted, now.
    *r = (orr_archive_record){.mjd = mjd, .observed_until = orr_archive_day_begin(mjd)};
    snprintf(r->program, sizeof r->program, "orrery %s", ORR_VERSION);
    snprintf(r->options, sizeof r->options, "predicted from the newest ultra-rapid orbits");
    for (size_t i = 0; s == ORR_OK && i < newest->n; i++) {
        char sha256[ORR_SHA256_HEX];
        s = orr_sha256_file(newest->path[i], sha256, diag);
        if (s == ORR_OK) orr_archive_take_file(&r->input[r->n_inputs++], newest->path[i], sha256);
    }
    orr_archive_key(r->program, r->options, r->input, r->n_inputs, r->key);
    return s;
}

orr_status orr_archive_now_make(const orr_archive_settings *settings, const orr_newest *newest, int jobs,
                                orr_archive_record *r, orr_diag *diag)
{
    const orr_time begin = orr_archive_day_begin(r->mjd), end = orr_archive_day_begin(r->mjd + 1);
    const orr_archive_index nothing = {0};
    const char *sp3[2] = {newest->path[0], newest->path[1]};
    char day[ORR_ARCHIVE_DAY_TEXT];
    orr_orbit_plan plan = orr_orbit_plan_default();
    orr_orbit_made made = {0};
    orr_warnings warnings = {0};
    plan.sp3 = sp3;
    plan.n_sp3 = newest->n;
    plan.leap = settings->leap;
    plan.predict = true;
    plan.predict_after = end;
    plan.smoother.jobs = jobs;
    orr_status s = orr_orbit_solve(&plan, NULL, NULL, &made, &warnings, diag);
    if (s == ORR_OK) {
        orr_orbit_solution_cut(&made.solution, begin, end);
        if (made.solution.n_sats == 0)
            s = orr_diag_set(diag, ORR_E_NODATA, "no satellite of the ultra-rapid orbits reaches into %s",
                             orr_archive_day_text(r->mjd, day));
    }
    if (s == ORR_OK) {
        r->observed_until = made.prediction.from;
        orr_archive_note_warnings(r, &warnings);
        s = orr_archive_day_put(settings, &nothing, &made.solution, r, diag);
    }
    orr_warnings_free(&warnings);
    orr_orbit_made_free(&made);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/extras.h"

#include <stdio.h>
#include <string.h>

#include "core/path.h"
#include "src/archive/store.h"
#include "src/make/navset.h"
#include "src/make/station.h"

#define MAP "field.ION"
#define BROADCAST "broadcast.rnx"

static void add_words(orr_archive_record *r, const char *words)
{
    const size_t n = strlen(r->options);
    snprintf(r->options + n, sizeof r->options - n, "%.200s", words);
}

static void note(orr_archive_record *r, const char *what, const orr_diag *why)
{
    if (r->n_notes < ORR_ARCHIVE_MAX_NOTES)
        snprintf(r->note[r->n_notes++], sizeof r->note[0], "%.40s: not made: %.200s", what, why->text);
}

static void take_file(orr_archive_record *r, const orr_archive_input *in)
{
    if (r->n_inputs < ORR_ARCHIVE_MAX_INPUTS)
        orr_archive_take_file(&r->input[r->n_inputs++], in->path, in->sha256);
}

void orr_archive_extras_plan(const orr_archive_extras *x, const orr_archive_index *index,
                             orr_archive_record *r)
{
    const orr_archive_input *map = NULL;
    char text[64];
    if (x->navdata) add_words(r, ", broadcast data");
    if (x->wants.maps != NULL) add_words(r, ", TEC field");
    if (x->wants.maps != NULL && orr_archive_index_find_map(index, r->mjd, &map, NULL) == ORR_OK)
        take_file(r, map);
    for (size_t k = 0; k < x->wants.n_stations && k < ORR_ARCHIVE_MAX_STATIONS; k++) {
        const orr_archive_input *obs = orr_archive_index_find_obs(index, r->mjd, k);
        snprintf(text, sizeof text, "%s%.8s", k == 0 ? ", sessions of " : " ", x->wants.station[k]);
        add_words(r, text);
        if (obs != NULL) take_file(r, obs);
    }
}

// The day's own orbit and TEC field, which all its extras are made from: opened once.
typedef struct day_files {
    orr_station_plan plan; // that they were opened by; without a station
    orr_station_shared shared;
    orr_status status; // why there is no field
    orr_diag why;
} day_files;

static void open_beside(const orr_archive_extras *x, const orr_archive_index *index,
                        const orr_leap_table *leap, const char *orbit, int32_t mjd, day_files *out)
{
    const orr_archive_input *map = NULL;
    *out = (day_files){.plan = orr_station_plan_default()};
    out->plan.tec.leap = leap;
    out->plan.orbit = orbit;
    if (x->wants.maps != NULL) out->status = orr_archive_index_find_map(index, mjd, &map, &out->why);
    if (map != NULL) {
        out->plan.field = map->path;
        out->status = orr_station_share(&out->plan, &out->shared, NULL, &out->why);
        if (out->status == ORR_OK) return;
        orr_station_shared_free(&out->shared); // a field that cannot be used spoils the broadcast data not
        out->plan.field = NULL;
    }
    orr_diag *why = out->status == ORR_OK ? &out->why : NULL;
    const orr_status opened = orr_station_share(&out->plan, &out->shared, NULL, why);
    if (out->status == ORR_OK) out->status = opened;
}

static orr_status make_broadcast(const orr_ephemeris *e, int32_t mjd, const char *path, orr_diag *diag)
{
    orr_navset_plan plan = orr_navset_plan_default();
    orr_navset *set = NULL;
    orr_nav nav;
    orr_civil c;
    plan.options.jobs = 1;
    orr_status s = orr_navset_make(e, &plan, &set, NULL, NULL, diag);
    if (s != ORR_OK) return s;
    s = orr_navset_records(set, &nav, diag);
    orr_navset_free(set);
    if (s != ORR_OK) return s;
    // The date is the day's, so that the same day makes the same bytes.
    orr_time_to_civil(orr_archive_day_begin(mjd), ORR_SCALE_GPS, NULL, &c);
    snprintf(nav.program, sizeof nav.program, "orrery %s", ORR_VERSION);
    snprintf(nav.date, sizeof nav.date, "%04d%02d%02d 000000 GPS", c.year, c.month, c.day);
    s = orr_nav_write(&nav, path, NULL, diag);
    orr_nav_free(&nav);
    return s;
}

static orr_status make_map(const orr_tec_field *field, const char *path, orr_diag *diag)
{
    orr_ion models;
    orr_status s = orr_tec_field_to_ion(field, &models, diag);
    if (s != ORR_OK) return s;
    s = orr_ion_write(&models, path, diag);
    orr_ion_free(&models);
    return s;
}

// A station's session, by the day's own orbit and field.
//   Given:    beside  them
//             name    of the station
//             obs     its observations
//             path    where to
//   Returned: out     how good it is
//             diag    why there is none
static orr_status make_session(const day_files *beside, const char *name, const char *obs, const char *path,
                               orr_archive_station *out, orr_diag *diag)
{
    orr_station_plan plan = beside->plan;
    orr_station st;
    char call[64];
    plan.observations = obs;
    plan.shared = &beside->shared;
    orr_status s = orr_station_open(&plan, &st, NULL, diag);
    if (s == ORR_OK) s = orr_station_fuse(&st, NULL, diag);
    if (s == ORR_OK) {
        *out = (orr_archive_station){.arcs = st.fusion.n_arcs,
                                     .dstec_tecu = st.fusion.left.corrected_dstec_tecu};
        snprintf(out->name, sizeof out->name, "%.7s", name);
        s = orr_station_session(&st, diag);
    }
    snprintf(call, sizeof call, "orrery batch, station %.8s", name);
    if (s == ORR_OK) {
        out->samples = st.session.n_samples;
        s = orr_station_save(&st, path, call, diag);
    }
    orr_station_free(&st);
    return s;
}

static orr_status make_sessions(const orr_archive_extras *x, const orr_archive_index *index,
                                const day_files *beside, const char *folder, orr_archive_record *r,
                                orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH], name[32];
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < x->wants.n_stations && k < ORR_ARCHIVE_MAX_STATIONS; k++) {
        const orr_archive_input *obs = orr_archive_index_find_obs(index, r->mjd, k);
        orr_archive_station told;
        orr_diag why = beside->why;
        orr_status made = beside->status;
        snprintf(name, sizeof name, "session-%.8s.nc", x->wants.station[k]);
        snprintf(path, sizeof path, "%.900s/%s", folder, name);
        if (made == ORR_OK && obs == NULL)
            made = orr_diag_set(&why, ORR_E_NODATA, "there are no observations of the day");
        if (made == ORR_OK) made = make_session(beside, x->wants.station[k], obs->path, path, &told, &why);
        if (made != ORR_OK) {
            note(r, name, &why);
            continue;
        }
        r->station[r->n_stations++] = told;
        s = orr_archive_note_product(r, folder, name, diag);
    }
    return s;
}

// Puts a product into the record, or the reason why there is none into its notes.
//   Given:    r       the record
//             folder  the day's
//             name    of the product
//             made    how its making ended
//             why     the sentence where it failed
//   Returned: diag    ORR_E_IO
static orr_status take_product(orr_archive_record *r, const char *folder, const char *name, orr_status made,
                               const orr_diag *why, orr_diag *diag)
{
    if (made == ORR_OK) return orr_archive_note_product(r, folder, name, diag);
    note(r, name, why);
    return ORR_OK;
}

orr_status orr_archive_extras_make(const orr_archive_extras *x, const orr_archive_index *index,
                                   const orr_leap_table *leap, const char *folder, orr_archive_record *r,
                                   orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH], orbit[ORR_ARCHIVE_PATH];
    orr_status s = ORR_OK;
    day_files beside;
    if (!x->navdata && x->wants.maps == NULL) return ORR_OK;
    snprintf(orbit, sizeof orbit, "%.900s/orbit.nc", folder);
    open_beside(x, index, leap, orbit, r->mjd, &beside);
    if (x->navdata) {
        orr_diag why = beside.why;
        snprintf(path, sizeof path, "%.900s/" BROADCAST, folder);
        orr_status made = beside.shared.positions != NULL ? ORR_OK : beside.status;
        if (made == ORR_OK)
            made = make_broadcast(orr_positions_product(beside.shared.positions), r->mjd, path, &why);
        s = take_product(r, folder, BROADCAST, made, &why, diag);
    }
    if (s == ORR_OK && x->wants.maps != NULL) {
        orr_diag why = beside.why;
        orr_status made = beside.status;
        snprintf(path, sizeof path, "%.900s/" MAP, folder);
        if (made == ORR_OK) made = make_map(beside.shared.field, path, &why);
        s = take_product(r, folder, MAP, made, &why, diag);
    }
    if (s == ORR_OK) s = make_sessions(x, index, &beside, folder, r, diag);
    orr_station_shared_free(&beside.shared);
    return s;
}

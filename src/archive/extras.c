// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/extras.h"

#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "core/path.h"
#include "orbit/ephemeris/ephemeris.h"
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

static orr_status make_map(const char *from, const orr_leap_table *leap, const char *path, orr_diag *diag)
{
    orr_tec_options options = orr_tec_default_options();
    orr_tec_field *field = NULL;
    orr_ion models;
    options.leap = leap;
    orr_status s = orr_tec_field_open(from, &options, &field, NULL, diag);
    if (s != ORR_OK) return s;
    s = orr_tec_field_to_ion(field, &models, diag);
    orr_tec_field_free(field);
    if (s != ORR_OK) return s;
    s = orr_ion_write(&models, path, diag);
    orr_ion_free(&models);
    return s;
}

// A station's session, by the day's own orbit and field.
//   Given:    obs, map, orbit  files
//             name             of the station
//             leap             leap seconds
//             path             where to
//   Returned: out              how good it is
//             diag             why there is none
static orr_status make_session(const char *obs, const char *map, const char *orbit, const char *name,
                               const orr_leap_table *leap, const char *path, orr_archive_station *out,
                               orr_diag *diag)
{
    orr_station_plan plan = orr_station_plan_default();
    orr_station st;
    char call[64];
    plan.observations = obs;
    plan.field = map;
    plan.orbit = orbit;
    plan.tec.leap = leap;
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
                                const orr_leap_table *leap, const char *folder, orr_archive_record *r,
                                orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH], orbit[ORR_ARCHIVE_PATH], name[32];
    const orr_archive_input *map = NULL;
    orr_diag why = {0};
    orr_status s = ORR_OK;
    snprintf(orbit, sizeof orbit, "%.900s/orbit.nc", folder);
    const bool mapped = orr_archive_index_find_map(index, r->mjd, &map, &why) == ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < x->wants.n_stations && k < ORR_ARCHIVE_MAX_STATIONS; k++) {
        const orr_archive_input *obs = orr_archive_index_find_obs(index, r->mjd, k);
        orr_archive_station told;
        snprintf(name, sizeof name, "session-%.8s.nc", x->wants.station[k]);
        snprintf(path, sizeof path, "%.900s/%s", folder, name);
        if (obs == NULL) orr_diag_set(&why, ORR_E_NODATA, "there are no observations of the day");
        if (!mapped || obs == NULL ||
            make_session(obs->path, map->path, orbit, x->wants.station[k], leap, path, &told, &why) !=
                ORR_OK) {
            note(r, name, &why);
            continue;
        }
        r->station[r->n_stations++] = told;
        s = orr_archive_note_product(r, folder, name, diag);
    }
    return s;
}

orr_status orr_archive_extras_make(const orr_archive_extras *x, const orr_archive_index *index,
                                   const orr_leap_table *leap, const char *folder, orr_archive_record *r,
                                   orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH], orbit[ORR_ARCHIVE_PATH];
    orr_status s = ORR_OK;
    orr_diag why = {0};
    if (x->navdata) {
        orr_ephemeris *e = NULL;
        snprintf(orbit, sizeof orbit, "%.900s/orbit.nc", folder);
        snprintf(path, sizeof path, "%.900s/" BROADCAST, folder);
        orr_status made = orr_ephemeris_load(orbit, &e, &why);
        if (made == ORR_OK) made = make_broadcast(e, r->mjd, path, &why);
        orr_ephemeris_free(e);
        if (made == ORR_OK)
            s = orr_archive_note_product(r, folder, BROADCAST, diag);
        else
            note(r, BROADCAST, &why);
    }
    if (s == ORR_OK && x->wants.maps != NULL) {
        const orr_archive_input *map = NULL;
        snprintf(path, sizeof path, "%.900s/" MAP, folder);
        orr_status made = orr_archive_index_find_map(index, r->mjd, &map, &why);
        if (made == ORR_OK) made = make_map(map->path, leap, path, &why);
        if (made == ORR_OK)
            s = orr_archive_note_product(r, folder, MAP, diag);
        else
            note(r, MAP, &why);
    }
    return s == ORR_OK ? make_sessions(x, index, leap, folder, r, diag) : s;
}

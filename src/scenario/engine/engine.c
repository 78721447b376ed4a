// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/engine/engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/earth.h"
#include "core/path.h"

struct orr_engine {
    char title[128];
    const orr_leap_table *leap;
    orr_source_orbit *orbits; // NULL: none; the same of all sources
    orr_source_tables tables;
    orr_source_navdata *navdata;
    orr_source_iono *iono;
    orr_source_motion *motion;
    orr_channels *channels;
    orr_replay *replay; // NULL: none
    orr_replay_report report;
    orr_receiver_kind receiver;
    orr_vec3 place_m;     // of ORR_RECEIVER_PLACE
    size_t receiver_unit; // of ORR_RECEIVER_UNIT
};

static orr_status make_engine(const char *title, orr_engine **out, orr_diag *diag)
{
    *out = calloc(1, sizeof **out);
    if (*out == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    snprintf((*out)->title, sizeof(*out)->title, "%s", title);
    return ORR_OK;
}

static const char *title_of(const orr_scenario *s)
{
    if (s->title != NULL) return s->title;
    if (s->orbit.product != NULL) return orr_base_name(s->orbit.product);
    if (s->orbit.sp3.n > 0) return orr_base_name(s->orbit.sp3.item[0]);
    return s->orbit.nav.n > 0 ? orr_base_name(s->orbit.nav.item[0]) : "";
}

static void choose_receiver(const orr_scenario *s, orr_engine *e)
{
    orr_vec3 station_m;
    if (s->receiver.position.n == 3) {
        const double *p = s->receiver.position.item;
        e->receiver = ORR_RECEIVER_PLACE;
        e->place_m = orr_earth_to_ecef((orr_geodetic){p[0] * ORR_RAD_PER_DEG, p[1] * ORR_RAD_PER_DEG, p[2]});
    } else if (e->motion != NULL) {
        e->receiver = ORR_RECEIVER_UNIT;
        e->receiver_unit = (size_t)s->receiver.unit;
    } else if (orr_source_iono_station(e->iono, &station_m)) {
        e->receiver = ORR_RECEIVER_STATION;
    }
}

orr_status orr_engine_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_engine **out, orr_diag *diag)
{
    orr_status status = make_engine(title_of(s), out, diag);
    if (status != ORR_OK) return status;
    orr_engine *e = *out;
    e->leap = s->leap != NULL ? s->leap : orr_leap_builtin();
    orr_span span = {.from = orr_moving_fallback_start()};
    status = orr_source_orbit_open(s, log, cancel, warnings, &e->orbits, diag);
    if (status == ORR_OK && e->orbits != NULL) status = orr_source_tables_open(s, warnings, &e->tables, diag);
    if (status == ORR_OK)
        status = orr_source_navdata_open(s, e->orbits, &e->tables, log, cancel, warnings, &e->navdata, diag);
    if (status == ORR_OK) status = orr_source_iono_open(s, e->orbits, warnings, &e->iono, diag);
    (void)orr_source_orbit_span(e->orbits, &span);
    if (status == ORR_OK) status = orr_source_motion_open(s, span.from, warnings, &e->motion, diag);
    if (status == ORR_OK && e->orbits == NULL && e->motion == NULL)
        status = orr_diag_set(
            diag, ORR_E_NODATA,
            "the scenario has neither satellites (orbit.product, orbit.sp3, orbit.nav) nor a trajectory");
    if (status == ORR_OK && s->has_replay)
        status = orr_replay_make(s, e->orbits, e->iono, &e->tables, log, cancel, warnings, &e->replay,
                                 &e->channels, &e->report, diag);
    else if (status == ORR_OK)
        status = orr_channels_open(s, e->orbits, e->iono, e->motion, &e->tables, NULL, cancel, warnings,
                                   &e->channels, diag);
    if (status == ORR_OK) {
        choose_receiver(s, e);
    } else {
        orr_marks_locate(&s->marks, diag);
        orr_engine_close(e);
        *out = NULL;
    }
    return status;
}

void orr_engine_close(orr_engine *e)
{
    if (e == NULL) return;
    orr_channels_close(e->channels);
    orr_replay_free(e->replay);
    orr_source_motion_close(e->motion);
    orr_source_iono_close(e->iono);
    orr_source_navdata_close(e->navdata);
    orr_source_tables_close(&e->tables);
    orr_source_orbit_close(e->orbits);
    free(e);
}

const char *orr_engine_title(const orr_engine *e) { return e->title; }
const orr_leap_table *orr_engine_leap(const orr_engine *e) { return e->leap; }

const char *orr_engine_frame(const orr_engine *e)
{
    return e->orbits != NULL ? orr_ephemeris_frame(orr_source_orbit_ephemeris(e->orbits)) : "WGS84";
}

bool orr_engine_part_span(const orr_engine *e, orr_engine_part part, orr_span *out)
{
    switch (part) {
    case ORR_PART_ORBITS:
        return orr_source_orbit_span(e->orbits, out);
    case ORR_PART_NAVDATA:
        return orr_source_navdata_span(e->navdata, out);
    case ORR_PART_IONOSPHERE:
        return orr_source_iono_span(e->iono, out);
    case ORR_PART_MOTION:
        return orr_source_motion_span(e->motion, out);
    case ORR_PART_CHANNELS:
        if (e->channels != NULL) *out = orr_channels_span(e->channels);
        return e->channels != NULL;
    }
    return false;
}

void orr_engine_span(const orr_engine *e, orr_time *from, orr_time *to)
{
    orr_span span = {0};
    if (!orr_source_orbit_span(e->orbits, &span)) (void)orr_source_motion_span(e->motion, &span);
    *from = span.from;
    *to = span.to;
}

size_t orr_engine_satellites(const orr_engine *e, const orr_sat **list)
{
    return orr_source_orbit_satellites(e->orbits, list);
}

orr_answer orr_engine_states(const orr_engine *e, orr_ephemeris_slice *slice, orr_time t, const orr_sat *sats,
                             size_t n, orr_sat_state *state, orr_answer *answer)
{
    return orr_source_orbit_states(e->orbits, slice, t, sats, n, state, answer);
}

orr_answer orr_engine_axes(const orr_engine *e, orr_time t, orr_elements_frame frame,
                           orr_elements_method method, orr_elements_axes *out)
{
    return orr_source_orbit_axes(e->orbits, t, frame, method, out);
}

orr_answer orr_engine_elements(const orr_engine *e, const orr_elements_axes *axes, const orr_sat *sats,
                               size_t n, orr_kepler *out, uint32_t *flags, orr_answer *answer)
{
    return orr_source_orbit_elements(e->orbits, axes, sats, n, out, flags, answer);
}

const char *orr_engine_no_navdata(const orr_engine *e)
{
    if (e->navdata == NULL && e->orbits != NULL) return "no broadcast data were made";
    return orr_source_navdata_none(e->navdata);
}

bool orr_engine_navdata_phase_centres(const orr_engine *e)
{
    return orr_source_navdata_phase_centres(e->navdata);
}

size_t orr_engine_navdata_streams(const orr_engine *e, orr_sat sat, uint32_t messages,
                                  const orr_nav_stream *list[ORR_NAVSET_STREAMS])
{
    return orr_source_navdata_streams(e->navdata, sat, messages, list);
}

orr_answer orr_engine_navdata(const orr_engine *e, orr_time t, orr_sat sat, const orr_nav_stream *stream,
                              bool coded, const orr_navset_item **set, orr_navframe *frame)
{
    return orr_source_navdata_evaluate(e->navdata, t, sat, stream, coded, set, frame);
}

bool orr_engine_has_ionosphere(const orr_engine *e) { return e->iono != NULL; }
const orr_channels *orr_engine_channels(const orr_engine *e) { return e->channels; }
const orr_replay *orr_engine_replay(const orr_engine *e, const orr_replay_report **report)
{
    if (report != NULL) *report = &e->report;
    return e->replay;
}
const orr_ephemeris *orr_engine_ephemeris(const orr_engine *e)
{
    return orr_source_orbit_ephemeris(e->orbits);
}
const orr_navset *orr_engine_navset(const orr_engine *e) { return orr_source_navdata_set(e->navdata); }
const orr_source_navdata *orr_engine_source_navdata(const orr_engine *e) { return e->navdata; }
const orr_moving *orr_engine_moving(const orr_engine *e) { return orr_source_motion_moving(e->motion); }

orr_receiver_kind orr_engine_receiver_kind(const orr_engine *e, size_t *unit)
{
    if (unit != NULL && e->receiver == ORR_RECEIVER_UNIT) *unit = e->receiver_unit;
    return e->receiver;
}

orr_answer orr_engine_receiver(const orr_engine *e, orr_time t, orr_vec3 *receiver_m)
{
    switch (e->receiver) {
    case ORR_RECEIVER_PLACE:
        *receiver_m = e->place_m;
        return ORR_ANSWER_OK;
    case ORR_RECEIVER_UNIT:
        return orr_source_motion_place(e->motion, e->receiver_unit, t, receiver_m);
    case ORR_RECEIVER_STATION:
        return orr_source_iono_station(e->iono, receiver_m) ? ORR_ANSWER_OK : ORR_ANSWER_NOT_SERVED;
    case ORR_RECEIVER_NONE:
        break;
    }
    return ORR_ANSWER_NOT_SERVED;
}

orr_answer orr_engine_delays(const orr_engine *e, orr_time t, orr_vec3 receiver_m, const orr_sat *sats,
                             size_t n, orr_realisation *delay, orr_answer *answer)
{
    return orr_source_iono_evaluate(e->iono, t, receiver_m, sats, n, delay, answer);
}

size_t orr_engine_units(const orr_engine *e) { return orr_source_motion_units(e->motion); }

bool orr_engine_unit(const orr_engine *e, size_t unit, orr_unit *out)
{
    return orr_source_motion_unit(e->motion, unit, out);
}

double orr_engine_imu_rate(const orr_engine *e) { return orr_source_motion_rate_hz(e->motion); }
bool orr_engine_imu_physical(const orr_engine *e) { return orr_source_motion_physical(e->motion); }
bool orr_engine_imu_measured(const orr_engine *e) { return orr_source_motion_measured(e->motion); }

orr_answer orr_engine_imu_begin(const orr_engine *e, size_t unit, orr_time t0, orr_time t1,
                                orr_sensors_sum *sum)
{
    return orr_source_motion_imu_begin(e->motion, unit, t0, t1, sum);
}

bool orr_engine_imu_add(const orr_engine *e, size_t unit, orr_sensors_sum *sum, long pieces)
{
    return orr_source_motion_imu_add(e->motion, unit, sum, pieces);
}

orr_answer orr_engine_truth(const orr_engine *e, size_t unit, orr_time t, orr_truth *out)
{
    return orr_source_motion_truth(e->motion, unit, t, out);
}

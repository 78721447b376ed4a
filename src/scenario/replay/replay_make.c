// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/replay/replay_make.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/earth.h"
#include "ingest/rinex/rinex_obs.h"
#include "src/scenario/replay/replay_private.h"
#include "src/scenario/troposphere/troposphere.h"

#define ZENITH_STEP_NS (3600 * ORR_NS_PER_S)
#define GRADIENT_STEP_NS (6 * 3600 * ORR_NS_PER_S)
static const int64_t MARGIN_NS = 3 * ORR_NS_PER_S / 10; // light on its way, and a clock's error
#define SETTLED_M 0.002                                 // of the position

// Orbits and ionosphere, less the flight of light and a clock's error.
static orr_span span_of(const replay_maker *m)
{
    orr_span span, i;
    (void)orr_source_orbit_span(m->orbits, &span);
    if (orr_source_iono_span(m->iono, &i)) {
        if (i.from > span.from) span.from = i.from;
        if (i.to < span.to) span.to = i.to;
    }
    span.from = orr_time_add(span.from, MARGIN_NS);
    span.to = orr_time_add(span.to, -MARGIN_NS);
    const orr_scenario_replay *o = &m->s->replay;
    if (o->has_from && o->from > span.from) span.from = o->from;
    if (o->has_to && o->to < span.to) span.to = o->to;
    return span;
}

static uint64_t signals_of(const orr_scenario *s)
{
    uint64_t set = 0;
    for (size_t k = 0; k < s->signals.n; k++) (void)orr_signal_parse(s->signals.item[k], &set, NULL);
    return s->signals.n > 0 ? set : UINT64_MAX;
}

// --- The scenario of the station alone ---

typedef struct station_view {
    orr_scenario s;
    orr_scenario_antenna antenna;
    double place[3];
    char name[64], type[24];
    char *signal[ORR_MAX_SIGNALS], text[ORR_MAX_SIGNALS][16];
} station_view;

// The marker as a name of files.
static void name_of(const orr_replay *r, char *out, size_t size)
{
    snprintf(out, size, "%.59s", r->marker[0] != '\0' ? r->marker : "station");
    for (char *c = out; *c != '\0'; c++)
        if (!isalnum((unsigned char)*c) && *c != '-' && *c != '_') *c = '_';
}

static void choose_antenna(const replay_maker *m, station_view *v)
{
    bool radome_ignored;
    const orr_replay *r = m->r;
    v->antenna.name = v->name;
    snprintf(v->type, sizeof v->type, "%.20s", r->antenna_type);
    if (v->type[0] != '\0' && m->tables->has_antex &&
        orr_antex_find_receiver(&m->tables->antex, v->type, &radome_ignored) != NULL)
        v->antenna.type = v->type;
}

static void view_of(const replay_maker *m, station_view *v)
{
    *v = (station_view){.s = *m->s};
    name_of(m->r, v->name, sizeof v->name);
    choose_antenna(m, v);
    const orr_geodetic place = orr_earth_from_ecef(m->site_m);
    v->place[0] = place.lat_rad * ORR_DEG_PER_RAD;
    v->place[1] = place.lon_rad * ORR_DEG_PER_RAD;
    v->place[2] = place.height_m;
    v->antenna.position = (orr_real_list){.n = 3, .item = v->place};
    v->s.antennas.n = 1;
    v->s.antennas.item = &v->antenna;
    v->s.receiver.position.n = 0;
    size_t n;
    const orr_signal *all = orr_signals(&n);
    v->s.signals.n = 0; // what was recorded
    v->s.signals.item = v->signal;
    for (size_t k = 0; k < n; k++) {
        if (m->r->code[k][0] == '\0') continue;
        snprintf(v->text[k], sizeof v->text[k], "%c:%s", all[k].system, all[k].name);
        v->signal[v->s.signals.n++] = v->text[k];
    }
    v->s.has_troposphere = true;
    v->s.troposphere = m->view_troposphere;
    v->s.site.solid_tide = v->s.site.pole_tide = true;
    v->s.mask = (orr_scenario_mask){.elevation_deg = -10}; // the record says who was seen
}

orr_status replay_channels(replay_maker *m, orr_diag *diag)
{
    station_view v;
    orr_channels_close(m->c);
    m->c = NULL;
    view_of(m, &v);
    return orr_channels_open(&v.s, m->orbits, m->iono, NULL, m->tables, m->r, m->cancel, NULL, &m->c, diag);
}

static void warn_of_antenna(const replay_maker *m)
{
    bool radome_ignored = false;
    const char *type = m->r->antenna_type;
    if (m->tables->has_antex && orr_antex_find_receiver(&m->tables->antex, type, &radome_ignored) == NULL)
        orr_warnings_add(
            m->warnings, m->s->replay.observations, 0, 0,
            "ANTEX has no antenna '%s': its phase centres are taken as its reference point, and what they "
            "are off goes into position, content and residuals",
            type);
    else if (radome_ignored)
        orr_warnings_add(m->warnings, m->s->replay.observations, 0, 0,
                         "ANTEX has '%s' without this radome only", type);
}

// --- Steps ---

// Which satellites' antennas have to be estimated, and roughly where their phase centres are.
static void find_unknown_antennas(replay_maker *m)
{
    char list[600] = "", text[ORR_SAT_TEXT];
    for (size_t k = 0; k < m->r->n_sats; k++) {
        orr_replay_sat *x = &m->r->sat[k];
        x->estimated =
            x->pair[0] >= 0 &&
            (!m->tables->has_antex || orr_antex_find_sat(&m->tables->antex, x->sat, m->r->tag[0]) == NULL);
        if (!x->estimated) continue;
        x->offset_m = (orr_vec3){0, 0, replay_usual_offset_m(orr_sat_system(x->sat))};
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, " %s", orr_sat_text(x->sat, text));
    }
    if (list[0] != '\0')
        orr_warnings_add(
            m->warnings, m->s->replay.observations, 0, 0,
            "ANTEX (channel.antex) does not know the antennas of these satellites at that time; where their "
            "phase centres are is estimated:%s",
            list);
}

static orr_status open_curve(const orr_replay *r, int64_t step_ns, orr_replay_curve *out, orr_diag *diag)
{
    const orr_time first = r->tag[0], last = r->tag[r->n_epochs - 1];
    *out = (orr_replay_curve){.from = first - orr_floor_mod(first, step_ns), .step_ns = step_ns};
    out->n = (size_t)((last - out->from) / step_ns) + 2;
    out->node = calloc(out->n, sizeof *out->node);
    return out->node != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static orr_status open_curves(replay_maker *m, orr_diag *diag)
{
    orr_replay *r = m->r;
    if (m->view_troposphere.model == ORR_TROPOSPHERE_NONE) return ORR_OK;
    orr_status s = open_curve(r, ZENITH_STEP_NS, &r->zenith, diag);
    if (s == ORR_OK) s = open_curve(r, GRADIENT_STEP_NS, &r->dry, diag);
    if (s == ORR_OK) s = open_curve(r, GRADIENT_STEP_NS, &r->north, diag);
    if (s == ORR_OK) s = open_curve(r, GRADIENT_STEP_NS, &r->east, diag);
    return s;
}

static orr_status move(replay_maker *m, orr_vec3 shift_m, orr_diag *diag)
{
    m->site_m = orr_vec3_add(m->site_m, shift_m);
    return replay_channels(m, diag);
}

// A position good to metres, by codes of some epochs.
static orr_status first_position(replay_maker *m, orr_diag *diag)
{
    const size_t every = m->r->n_epochs / 30 + 1;
    orr_status s = ORR_OK;
    for (int round = 0; s == ORR_OK && round < 6; round++) {
        orr_vec3 shift_m = {0, 0, 0};
        s = replay_model(m, every, true, diag);
        if (s == ORR_OK) s = replay_solve(m, every, true, &shift_m, diag);
        if (s != ORR_OK || orr_vec3_norm(shift_m) < 5) break;
        s = move(m, shift_m, diag);
    }
    for (size_t k = 0; k < m->r->n_sats; k++)
        for (size_t j = 0; j < m->r->sat[k].n; j++) m->r->sat[k].sight[j].rejected &= 1;
    return s;
}

static orr_status estimate(replay_maker *m, orr_diag *diag)
{
    orr_status s = ORR_OK;
    if (!m->known_site && m->s->replay.estimate_position) s = first_position(m, diag);
    if (s == ORR_OK) s = replay_model(m, 1, true, diag);
    if (s == ORR_OK) s = replay_clock_steps(m, diag);
    if (s == ORR_OK) s = replay_bridges(m, diag);
    for (int round = 0; s == ORR_OK && round < 4; round++) {
        orr_vec3 shift_m = {0, 0, 0};
        s = replay_solve(m, 1, false, &shift_m, diag);
        if (s == ORR_OK) s = move(m, shift_m, diag); // also for the zenith delays
        if (s == ORR_OK && orr_vec3_norm(shift_m) < SETTLED_M) break;
        if (s == ORR_OK) s = replay_model(m, 1, false, diag);
    }
    if (s == ORR_OK) s = replay_model(m, 1, false, diag); // with the last zenith delays
    if (s == ORR_OK) replay_contents(m);
    if (s == ORR_OK) s = replay_model(m, 1, false, diag);
    return s;
}

static void tell(replay_maker *m)
{
    const orr_replay *r = m->r;
    orr_replay_report *out = m->report;
    const orr_geodetic place = orr_earth_from_ecef(m->site_m);
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    out->position_from = m->known_site ? "SINEX" : "header";
    out->prior_m = m->prior_m;
    out->site_m = m->site_m;
    out->shift_enu_m = orr_mat3_apply(&enu, orr_vec3_sub(m->site_m, m->prior_m));
    out->clock_least_s = out->zenith_least_m = (double)INFINITY;
    out->clock_most_s = out->zenith_most_m = -(double)INFINITY;
    out->zenith_wet_m = 0;
    for (size_t e = 0; e < r->n_epochs; e++) {
        const double wet_m = orr_channels_troposphere(m->c, 0, place, r->t[e]).zenith.wet_m;
        out->clock_least_s = fmin(out->clock_least_s, r->clock_s[e]);
        out->clock_most_s = fmax(out->clock_most_s, r->clock_s[e]);
        out->zenith_least_m = fmin(out->zenith_least_m, wet_m);
        out->zenith_most_m = fmax(out->zenith_most_m, wet_m);
        out->zenith_wet_m += wet_m / (double)r->n_epochs;
    }
}

static orr_status open_fused(replay_maker *m, orr_diag *diag)
{
    const orr_replay *r = m->r;
    m->fused_tecu = calloc(r->n_sats, sizeof *m->fused_tecu);
    for (size_t k = 0; m->fused_tecu != NULL && k < r->n_sats; k++) {
        m->fused_tecu[k] = malloc((r->sat[k].n + 1) * sizeof **m->fused_tecu);
        if (m->fused_tecu[k] == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        for (size_t j = 0; j < r->sat[k].n; j++) m->fused_tecu[k][j] = (double)NAN;
    }
    return m->fused_tecu != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static void close_fused(replay_maker *m)
{
    for (size_t k = 0; m->fused_tecu != NULL && k < m->r->n_sats; k++) free(m->fused_tecu[k]);
    free(m->fused_tecu);
}

static orr_status make(replay_maker *m, orr_diag *diag)
{
    orr_status s = open_fused(m, diag);
    if (s == ORR_OK) s = replay_level(m, diag);
    if (s == ORR_OK) s = open_curves(m, diag);
    if (s == ORR_OK)
        s = orr_sun_track_open(m->r->tag[0], m->r->tag[m->r->n_epochs - 1],
                               orr_ephemeris_eop(orr_source_orbit_ephemeris(m->orbits)), &m->sun, diag);
    if (s == ORR_OK) find_unknown_antennas(m);
    if (s == ORR_OK) s = replay_channels(m, diag);
    if (s == ORR_OK) warn_of_antenna(m);
    if (s == ORR_OK) s = estimate(m, diag);
    if (s == ORR_OK) s = replay_clocks(m, diag);
    if (s == ORR_OK) s = replay_residuals(m, diag);
    if (s == ORR_OK) tell(m);
    if (s == ORR_OK) s = orr_replay_seal(m->r, m->s->replay.residuals, diag);
    return s;
}

orr_status orr_replay_make(const orr_scenario *s, const orr_source_orbit *orbits, const orr_source_iono *iono,
                           const orr_source_tables *tables, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_replay **out, orr_channels **channels,
                           orr_replay_report *report, orr_diag *diag)
{
    replay_maker m = {.s = s,
                      .orbits = orbits,
                      .iono = iono,
                      .tables = tables,
                      .log = log,
                      .cancel = cancel,
                      .warnings = warnings,
                      .known_site = s->replay.sinex != NULL,
                      .report = report};
    *out = NULL;
    *channels = NULL;
    *report = (orr_replay_report){.position_from = ""};
    m.view_troposphere = s->has_troposphere
                             ? s->troposphere
                             : (orr_scenario_troposphere){.model = ORR_TROPOSPHERE_SAASTAMOINEN,
                                                          .mapping = ORR_TROPO_MAPPING_GMF,
                                                          .humidity = 0.5};
    orr_status status = orr_record_read(s->replay.observations, orbits, span_of(&m), signals_of(s), s->leap,
                                        warnings, &m.r, diag);
    if (status != ORR_OK) return status;
    status = make(&m, diag);
    close_fused(&m);
    orr_sun_track_free(&m.sun);
    if (status != ORR_OK) {
        orr_channels_close(m.c);
        orr_replay_free(m.r);
        return status;
    }
    *out = m.r;
    *channels = m.c;
    return ORR_OK;
}

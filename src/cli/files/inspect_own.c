// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/files/inspect_own.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "inertial/readings/imu_file.h"
#include "iono/fusion/session.h"
#include "orbit/ephemeris/ephemeris.h"
#include "src/cli/orbit/orbit_events.h"

// Events of the clocks, by their kinds, where there are any.
static void tell_clock_events(const orr_ephemeris *e, orr_inspection *r)
{
    static const struct {
        orr_clock_event_kind kind;
        const char *word;
    } kinds[] = {{ORR_CLOCK_EVENT_WRONG, "wrong values"},
                 {ORR_CLOCK_EVENT_JUMP, "jumps"},
                 {ORR_CLOCK_EVENT_FLAG, "flagged stretches"},
                 {ORR_CLOCK_EVENT_REFERENCE, "steps or ramps of the reference"}};
    const orr_clock_event *event;
    const size_t n = orr_ephemeris_clock_events(e, &event);
    bool first = true;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        size_t some = 0;
        for (size_t i = 0; i < n; i++) some += event[i].kind == kinds[k].kind;
        if (some == 0) continue;
        orr_inspect_fact_add(r, first ? "clock events" : "", "%s: %zu", kinds[k].word, some);
        first = false;
    }
}

static orr_status inspect_orbits(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_ephemeris *e = NULL;
    orr_status st = orr_ephemeris_load(path, &e, diag);
    if (st != ORR_OK) return st;
    const orr_sat *sat;
    const orr_orbit_node *node;
    const orr_orbit_event *event;
    const orr_orbit_source *source;
    size_t n_sats = orr_ephemeris_satellites(e, &sat), nodes = 0;
    orbit_event_counts events = {0};
    orr_ephemeris_span(e, &r->from, &r->to);
    r->interval_s = orr_ephemeris_node_step_s(e);
    for (size_t i = 0; i < n_sats; i++) {
        orr_inspect_sat_add(r, sat[i]);
        nodes += orr_ephemeris_nodes(e, sat[i], &node);
        size_t n_events = orr_ephemeris_events(e, sat[i], &event);
        orbit_events_count(event, n_events, &events);
    }
    r->records = (int64_t)nodes;
    double pos_m, vel_mps;
    char text[256];
    orr_ephemeris_representation(e, &pos_m, &vel_mps);
    orr_inspect_fact_add(r, "product", "satellite orbits, for `orrery states`, `compare` and `serve`");
    orr_inspect_fact_add(r, "nodes", "every %g s", r->interval_s);
    orr_inspect_fact_add(r, "frame", "%s", orr_ephemeris_frame(e));
    orr_inspect_fact_add(r, "events", "%s", orbit_events_summary(&events, text, sizeof text));
    tell_clock_events(e, r);
    orr_inspect_fact_add(r, "segments", "within %.2g mm and %.2g m/s of what was integrated", pos_m * 1e3,
                         vel_mps);
    orr_inspect_fact_add(r, "options", "%s", orr_ephemeris_options(e));
    size_t n_sources = orr_ephemeris_sources(e, &source);
    for (size_t i = 0; i < n_sources; i++)
        orr_inspect_fact_add(r, i == 0 ? "made from" : "", "%s", source[i].name);
    orr_ephemeris_free(e);
    return ORR_OK;
}

// The samples' instants, each once.
static orr_status session_epochs(const orr_session *s, orr_inspection *r, orr_diag *diag)
{
    orr_time *t = malloc((s->n_samples + 1) * sizeof *t);
    if (t == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    size_t n = 0;
    for (size_t i = 0; i < s->n_samples; i++) t[i] = s->sample[i].t;
    qsort(t, s->n_samples, sizeof *t, orr_time_order);
    for (size_t i = 0; i < s->n_samples; i++)
        if (n == 0 || t[i] != t[n - 1]) t[n++] = t[i];
    orr_inspect_epochs(r, t, n);
    free(t);
    return ORR_OK;
}

static orr_status inspect_session(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_session s;
    orr_status st = orr_session_load(path, NULL, &s, diag);
    if (st != ORR_OK) return st;
    st = session_epochs(&s, r, diag);
    r->from = s.from;
    r->to = s.to;
    for (size_t a = 0; a < s.n_arcs; a++) orr_inspect_sat_add(r, s.arc[a].sat);
    orr_geodetic at = orr_earth_from_ecef(s.site.pos_m);
    orr_time from, to;
    char begin[ORR_TIME_TEXT], end[ORR_TIME_TEXT];
    orr_tec_field_span(s.field, &from, &to);
    orr_inspect_fact_add(r, "product", "ionospheric session, for `orrery serve` (ionosphere.session)");
    orr_inspect_fact_add(r, "station", "%s at %.6f, %.6f deg, %.1f m", s.station,
                         at.lat_rad * ORR_DEG_PER_RAD, at.lon_rad * ORR_DEG_PER_RAD, at.height_m);
    orr_inspect_fact_add(r, "arcs", "%zu with %zu samples, levelled by the method '%s'", s.n_arcs,
                         s.n_samples, s.method);
    orr_inspect_fact_add(r, "correction", s.correction.n > 0 ? "of the field, %zu knots every %g s" : "none",
                         s.correction.n, s.correction.knot_s);
    orr_inspect_fact_add(r, "small scale", "%.3g TECU, fading over %.3g km and %.3g min", s.small.sigma_tecu,
                         s.small.length_m / 1e3, s.small.time_s / 60.0);
    orr_inspect_fact_add(r, "field", "%s of %s, %s to %s", orr_tec_field_kind(s.field),
                         orr_tec_field_source(s.field), orr_time_text(from, begin), orr_time_text(to, end));
    orr_session_free(&s);
    return st;
}

static orr_status inspect_readings(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_imu_summary s;
    orr_status st = orr_imu_summarise(path, &s, diag);
    if (st != ORR_OK) return st;
    char mode[160];
    r->from = orr_time_add_s(s.t0, s.begin_s);
    r->to = orr_time_add_s(s.t0, s.begin_s + (double)s.n / s.rate_hz);
    r->records = (int64_t)s.n;
    r->interval_s = 1.0 / s.rate_hz;
    orr_inspect_fact_add(r, "product", "inertial readings, for `orrery nulltest` and `gravimetry`");
    if (s.title[0] != '\0') orr_inspect_fact_add(r, "title", "%s", s.title);
    orr_inspect_fact_add(r, "readings", "at %g Hz%s", s.rate_hz,
                         s.instantaneous ? ", instantaneous ones too" : "");
    orr_inspect_fact_add(r, "mode", "%s", orr_imu_mode_text(&s.mode, mode, sizeof mode));
    orr_inspect_fact_add(r, "truth", "%zu instants, every %g s", s.n / s.truth_every + 1,
                         (double)s.truth_every / s.rate_hz);
    orr_inspect_fact_add(r, "gravity", "%s%s", s.gravity, s.n_gravimetry > 0 ? "; its truth beside" : "");
    return ORR_OK;
}

// The files name their kind in one attribute each, orbits by their variables.
static bool says(const orr_nc_reader *r, const char *attribute, const char *value)
{
    char text[64];
    return orr_nc_get_att_text(r, NULL, attribute, text, sizeof text, NULL) == ORR_OK &&
           strcmp(text, value) == 0;
}

// Names of the inputs, a line each in the file's attribute.
static void add_inputs(orr_inspection *r, char *names)
{
    int n = 0;
    for (char *save = NULL, *name = strtok_r(names, "\n", &save); name != NULL;
         name = strtok_r(NULL, "\n", &save))
        orr_inspect_fact_add(r, n++ == 0 ? "made from" : "", "%s", name);
}

orr_status orr_inspect_own(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_nc_reader file;
    orr_status s = orr_nc_open(path, &file, diag);
    if (s != ORR_OK) return s;
    char inputs[2048];
    bool session = says(&file, "product", "iono-session"), readings = says(&file, "format", ORR_IMU_FORMAT);
    if (orr_nc_get_att_text(&file, NULL, "input_files", inputs, sizeof inputs, NULL) != ORR_OK)
        inputs[0] = '\0';
    orr_nc_close(&file);
    if (session || readings) {
        s = session ? inspect_session(path, r, diag) : inspect_readings(path, r, diag);
        if (s == ORR_OK) add_inputs(r, inputs);
        return s;
    }
    s = inspect_orbits(path, r, diag);
    return s != ORR_E_KIND
               ? s
               : orr_diag_at(
                     diag, s, path, 0, 0,
                     "is a NetCDF file, but neither orbits, nor a session, nor inertial readings that "
                     "Orrery made");
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Orbit products with anything in their variables, dimensions and attributes: loaded, evaluated at their ends
// and inside, listed, turned into elements and, where they are short, into broadcast data.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fuzz/nc_mock.h"
#include "orbit/elements/elements.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/navdata/navframe.h"
#include "orbit/smooth/smoother.h"
#include "unit/orbit/made_orbit.h"
#include "unit/orbit/made_sp3.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

#define KINDS 3
#define SATS 3          // GPS, GLONASS, Galileo
#define FILE_BYTES 4096 // of the file that the loader takes the most that it may hold from
#define SHORT_S 36e3    // broadcast data are made of a product no longer than that
#define DAY_S 108e3     // and, of one input in eight, of one as long as almanacs need
#define MAX_STATES 64

static char path[256];
static void remove_file(void) { unlink(path); }

static void make_file(void)
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/fuzz_product-XXXXXX", folder != NULL ? folder : "/tmp");
    int f = mkstemp(path);
    if (f < 0 || ftruncate(f, FILE_BYTES) != 0) abort();
    close(f);
    atexit(remove_file);
}

// Moves the last third of the first satellite's arc an hour on: two arcs and a gap.
static void part(orr_orbit_sat *s)
{
    const orr_orbit_arc whole = s->arc[0];
    const size_t cut = (whole.n - 1) / whole.samples_per_segment * 2 / 3 * whole.samples_per_segment;
    orr_orbit_arc *two = calloc(2, sizeof *two);
    orr_orbit_sample *tail = calloc(whole.n - cut, sizeof *tail);
    if (two == NULL || tail == NULL) abort();
    memcpy(tail, whole.sample + cut, (whole.n - cut) * sizeof *tail);
    two[0] = two[1] = whole;
    two[0].n = cut + 1;
    two[1].n = whole.n - cut;
    two[1].t0 = orr_time_add_s(whole.t0, (double)cut * whole.step_s + 3600);
    two[1].sample = tail;
    free(s->arc);
    s->arc = two;
    s->n_arcs = 2;
}

// Four hours in two arcs, without what a product may lack.
static orr_orbit_solution bare(void)
{
    orr_orbit_solution s = made_solution(SATS, 4, 900, 6);
    part(&s.sat[0]);
    for (size_t i = 0; i < SATS; i++) s.sat[i].n_nodes = s.sat[i].n_events = 0;
    s.sat[1].n_clocks = 0;
    s.n_sources = 0;
    return s;
}

// By the project's forces, so that all kinds of broadcast data can be fitted, and smoothed.
static orr_orbit_solution smoothed(double hours)
{
    static made_truth truth[SATS];
    const made_truth *all[SATS];
    made_sky sky;
    orr_sp3 f;
    orr_orbit_solution s;
    orr_diag diag = {0};
    made_sky_init(&sky, "2024-02-04T00:00:00", hours / 24);
    for (int k = 0; k < SATS; k++) {
        static const double a_m[SATS] = {2.656e7, 2.551e7, 2.96e7}, i_rad[SATS] = {0.96, 1.13, 0.97};
        made_orbit(&sky, orr_sat_make("GRE"[k], k + 1), a_m[k], k == 1 ? 0.001 : 0.01, i_rad[k], 0.9 * k,
                   0.4 + 1.7 * k, 2e-8, k == 0 ? 5000 : -1, 0.5, &truth[k]);
        all[k] = &truth[k];
    }
    made_sp3(&sky, all, SATS, 0, (size_t)(hours * 12), 3, &f);
    const orr_smoother_input in = {.sp3 = &f, .name = "made.sp3"};
    const orr_smoother_options o = orr_smoother_defaults();
    if (orr_smoother_run(&in, 1, &o, NULL, NULL, &s, NULL, NULL, &diag) != ORR_OK) abort();
    made_sp3_free(&f);
    made_sky_free(&sky);
    return s;
}

// Five hours; four of the bare one; a day and two hours, for almanacs.
static void make(unsigned kind)
{
    orr_orbit_solution s = kind == 1 ? bare() : smoothed(kind == 0 ? 5 : 26);
    orr_ephemeris *e;
    orr_diag diag = {0};
    orr_clock_event events[2] = {
        {ORR_CLOCK_EVENT_JUMP, s.sat[0].sat, s.from, orr_time_add_s(s.from, 900), 1e-6, ""},
        {ORR_CLOCK_EVENT_REFERENCE, ORR_SAT_NONE, orr_time_add_s(s.from, 1800), orr_time_add_s(s.from, 3600),
         -3e-7, "GRE"}};
    free(s.clock_events.item);
    s.clock_events = (orr_clock_events){2, events};
    if (orr_ephemeris_build(&s, &e, &diag) != ORR_OK || orr_ephemeris_save(e, path, "made", &diag) != ORR_OK)
        abort();
    nc_mock_keep(kind);
    orr_ephemeris_free(e);
    nc_mock_edit(kind, NULL, 0);
    if (orr_ephemeris_load(path, &e, &diag) != ORR_OK) abort(); // or nothing would be tried below
    orr_ephemeris_free(e);
    s.clock_events = (orr_clock_events){0};
    if (kind == 1)
        made_solution_free(&s);
    else
        orr_orbit_solution_free(&s);
}

static bool finite3(orr_vec3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

static void check_state(const orr_sat_state *s, orr_time t)
{
    const bool has_clock = (s->flags & ORR_EPH_CLOCK_VALID) != 0;
    if (!finite3(s->pos_m) || !finite3(s->vel_mps) || !finite3(s->acc_mps2)) abort();
    if (!(s->sigma_m >= 0) || isinf(s->sigma_m) || s->valid_from > t || s->valid_to < t) abort();
    if (s->clock_sigma_s < 0 || isinf(s->clock_sigma_s) || (!has_clock && !isnan(s->clock_sigma_s))) abort();
    if (has_clock ? !isfinite(s->clock_s) || !isfinite(s->clock_rate_sps) : !isnan(s->clock_s)) abort();
}

// All satellites share the axes of an instant: those of the mean method cost a hundred rotations of the Earth.
static void elements(const orr_ephemeris *e, const orr_sat *list, size_t n, orr_time t)
{
    for (int method = ORR_ELEMENTS_STATE; method <= ORR_ELEMENTS_MEAN; method++) {
        const orr_elements_options o = {.frame = (orr_elements_frame)(method % 3),
                                        .method = (orr_elements_method)method};
        orr_elements_axes axes;
        orr_elements_axes_at(t, &o, &axes);
        for (size_t i = 0; i < n; i++) {
            orr_kepler k;
            if (orr_elements_of(e, list[i], &axes, &k) != ORR_OK) continue;
            if (!isfinite(k.a_m + k.e + k.i_rad + k.raan_rad + k.argp_rad + k.m_rad + k.u_rad)) abort();
            if (!(k.e >= 0 && k.e < 1 && k.a_m > 0)) abort();
        }
    }
}

// One satellite and all of them at once are the same.
static void ask(const orr_ephemeris *e, orr_time t)
{
    static orr_sat_state all[MAX_STATES];
    const orr_sat *list;
    const size_t n_sats = orr_ephemeris_satellites(e, &list),
                 n = orr_ephemeris_eval_all(e, t, all, MAX_STATES);
    size_t found = 0;
    for (size_t i = 0; i < n_sats && i < MAX_STATES; i++) {
        orr_sat_state s;
        const orr_status status = orr_ephemeris_eval(e, list[i], t, &s);
        if (status != ORR_OK) {
            if (status != ORR_E_RANGE && status != ORR_E_NODATA) abort();
            continue;
        }
        check_state(&s, t);
        if (found >= n || all[found].sat != list[i] ||
            memcmp(&all[found].pos_m, &s.pos_m, sizeof s.pos_m) != 0)
            abort();
        found++;
    }
    if (n_sats <= MAX_STATES && found != n) abort();
}

// Where the product says something of a satellite: its nodes' and events' times are asked for too.
static void list_satellite(const orr_ephemeris *e, orr_sat sat)
{
    enum { FEW = 4 };
    const orr_orbit_node *node;
    const orr_orbit_event *event;
    const orr_clock_node *clock;
    size_t n = orr_ephemeris_nodes(e, sat, &node);
    for (size_t i = 0; i < n; i++)
        if (i > 0 && node[i].t < node[i - 1].t) abort();
    n = orr_ephemeris_events(e, sat, &event);
    for (size_t i = 0; i < n; i++) {
        if (event[i].t0 > event[i].t1) abort();
        if (i < FEW) ask(e, event[i].t0), ask(e, event[i].t1);
    }
    n = orr_ephemeris_clocks(e, sat, &clock);
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(clock[i].clock_s) || (i > 0 && clock[i].t < clock[i - 1].t)) abort();
        if (i < FEW || i + FEW > n) ask(e, clock[i].t);
    }
}

static void broadcast(const orr_ephemeris *e, orr_time from, orr_time to, unsigned choice)
{
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set;
    orr_nav nav;
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    o.zero_clocks = choice % 2 == 1;
    o.window_s = choice / 2 % 2 == 1 ? 14400 : 7200;
    const orr_status status = orr_navset_build(e, &o, &set, &warnings, &diag);
    orr_warnings_free(&warnings);
    if (status != ORR_OK) {
        if (diag.text[0] == '\0') abort();
        return;
    }
    const orr_sat *list;
    const size_t n = orr_navset_satellites(set, &list);
    for (size_t i = 0; i < n; i++) {
        const orr_nav_stream *stream[ORR_NAVSET_STREAMS];
        const size_t m = orr_navset_streams(set, list[i], stream);
        if (m == 0) abort();
        for (size_t j = 0; j < m; j++) {
            static orr_navframe frame;
            const orr_navset_item *item;
            const orr_nav_message message = (orr_nav_message)stream[j]->message;
            const size_t sets = orr_navset_items(set, list[i], message, &item);
            for (size_t k = 0; k < sets; k++) {
                if (item[k].from >= item[k].to || (k > 0 && item[k].from < item[k - 1].from)) abort();
                if (!isfinite(item[k].report.rms_m) || !isfinite(item[k].eph.af0_s)) abort();
            }
            (void)orr_navset_at(set, list[i], message, from + (to - from) / 2);
            (void)orr_navframe_at(set, list[i], stream[j], from + (to - from) / 2, j % 2 != 0, &frame, NULL);
        }
    }
    if (orr_navset_records(set, &nav, &diag) != ORR_OK) abort();
    orr_nav_free(&nav);
    orr_navset_free(set);
}

static void look(const orr_ephemeris *e, unsigned choice)
{
    const orr_sat *list;
    const orr_orbit_source *source;
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    if (from >= to || to - 1 < from) abort();
    const orr_time middle = from + (to - from) / 2;
    const size_t n = orr_ephemeris_satellites(e, &list);
    const orr_time at[] = {from - 1, from, from + 1, middle,
                           to - 1,   to,   to + 1,   made_midnight + INT64_C(1801000000007)};
    for (size_t k = 0; k < sizeof at / sizeof at[0]; k++) ask(e, at[k]);
    for (size_t i = 0; i < n && i < SATS; i++) {
        list_satellite(e, list[i]);
    }
    elements(e, list, n < SATS ? n : SATS, from);
    elements(e, list, n < SATS ? n : SATS, middle);
    elements(e, list, n < SATS ? n : SATS, to);
    for (size_t i = orr_ephemeris_sources(e, &source); i-- > 0;)
        if (strnlen(source[i].name, sizeof source[i].name) == sizeof source[i].name) abort();
    const double length_s = orr_time_diff_s(to, from);
    if (length_s <= SHORT_S || (length_s <= DAY_S && choice % 8 == 7)) broadcast(e, from, to, choice / 8);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1) return 0;
    static bool made;
    if (!made) make_file();
    for (unsigned kind = 0; !made && kind < KINDS; kind++) make(kind);
    made = true;
    nc_mock_edit(data[0] % KINDS, data + 1, n - 1);
    orr_ephemeris *e;
    orr_diag diag = {0};
    if (orr_ephemeris_load(path, &e, &diag) != ORR_OK) {
        if (diag.text[0] == '\0' || e != NULL) abort(); // a refusal says why and holds nothing
        return 0;
    }
    look(e, data[0] / KINDS);
    orr_ephemeris_free(e);
    return 0;
}

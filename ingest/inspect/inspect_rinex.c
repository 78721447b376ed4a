// SPDX-License-Identifier: GPL-3.0-or-later
// What RINEX files are told of: navigation, observation, Hatanaka-compressed observation.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/inspect/inspect.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/rinex/rinex_obs.h"

// ---- navigation ----

static void nav_messages(const orr_nav *nav, orr_inspection *r)
{
    size_t count[ORR_N_SYSTEMS][ORR_NAV_N_MESSAGES] = {{0}};
    size_t unhealthy = 0;
    for (size_t i = 0; i < nav->n_eph; i++) {
        const orr_nav_eph *e = &nav->eph[i];
        count[orr_sat_system_index(e->sat)][e->message]++;
        unhealthy += !orr_nav_eph_usable(e);
    }
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++) {
        char line[256] = "";
        size_t at = 0;
        for (int m = 0; m < ORR_NAV_N_MESSAGES; m++) {
            if (count[s][m] == 0) continue;
            int n = snprintf(line + at, sizeof line - at, "%s%zu %s", at > 0 ? ", " : "", count[s][m],
                             orr_nav_message_name((orr_nav_message)m));
            if (n > 0 && at + (size_t)n < sizeof line) at += (size_t)n;
        }
        if (at > 0) orr_inspect_fact_add(r, orr_system_name(ORR_SYSTEMS[s]), "%s", line);
    }
    if (unhealthy > 0)
        orr_inspect_fact_add(r, "not usable", "%zu ephemerides by their health word", unhealthy);
}

static void nav_extras(const orr_nav *nav, orr_inspection *r)
{
    static const char *const kinds[] = {"", "Klobuchar", "NeQuick-G", "BDGIM", "NeQuick-N", "GLONASS CDMA"};
    size_t n_kind[6] = {0};
    for (size_t i = 0; i < nav->n_iono; i++) n_kind[nav->iono[i].kind]++;
    char line[256] = "";
    size_t at = 0;
    for (size_t k = 1; k < 6; k++) {
        if (n_kind[k] == 0) continue;
        int n = snprintf(line + at, sizeof line - at, "%s%zu %s", at > 0 ? ", " : "", n_kind[k], kinds[k]);
        if (n > 0 && at + (size_t)n < sizeof line) at += (size_t)n;
    }
    if (at > 0) orr_inspect_fact_add(r, "ionosphere", "%s", line);
    if (nav->n_sto > 0) orr_inspect_fact_add(r, "time offsets", "%zu", nav->n_sto);
    if (nav->n_eop > 0) orr_inspect_fact_add(r, "Earth orientation", "%zu", nav->n_eop);
    if (nav->has_leap)
        orr_inspect_fact_add(r, "leap seconds", "%d (%s)", nav->leap_s, orr_scale_name(nav->leap_scale));
    if (nav->n_skipped > 0)
        orr_inspect_fact_add(r, "left out", "%zu damaged or unknown records", nav->n_skipped);
}

orr_status orr_inspect_rinex_nav(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_nav nav;
    orr_nav_limits limits = orr_nav_default_limits();
    limits.leap = r->leap;
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_nav_parse(path, text.text, text.n, &limits, &nav, &r->warnings, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    snprintf(r->version, sizeof r->version, "%.2f", nav.version);
    r->records = (int64_t)nav.n_eph;
    r->satellites = 0;
    for (size_t i = 0; i < nav.n_eph; i++) {
        const orr_nav_eph *e = &nav.eph[i];
        orr_inspect_sat_add(r, e->sat);
        if (r->from == ORR_TIME_NONE || e->toc < r->from) r->from = e->toc;
        if (r->to == ORR_TIME_NONE || e->toc > r->to) r->to = e->toc;
    }
    if (nav.program[0] != '\0')
        orr_inspect_fact_add(r, "made by", "%s %s %s", nav.program, nav.run_by, nav.date);
    nav_messages(&nav, r);
    nav_extras(&nav, r);
    orr_nav_free(&nav);
    return ORR_OK;
}

// ---- observations ----

#define STEPS_LOOKED_AT ((size_t)100000) // the interval is found among so many first epochs

typedef struct obs_tally {
    orr_time *first; // the first epochs
    size_t n_first;
    orr_time last;
    uint64_t epochs, gaps_later, sats, values, events, power_failures, slips, half_cycles;
    bool has_clock;
} obs_tally;

static void count_epoch(const orr_rinex_obs_header *h, const orr_rinex_obs_epoch *e, obs_tally *t,
                        orr_inspection *r)
{
    if (e->flag > ORR_OBS_POWER_FAILURE) {
        t->events++;
        return;
    }
    t->power_failures += e->flag == ORR_OBS_POWER_FAILURE;
    t->has_clock = t->has_clock || !isnan(e->clock_offset_s);
    if (t->n_first < STEPS_LOOKED_AT) {
        t->first[t->n_first++] = e->t;
        if (t->n_first == STEPS_LOOKED_AT) orr_inspect_epochs(r, t->first, t->n_first);
    } else {
        t->gaps_later += orr_time_diff_s(e->t, t->last) > 1.5 * r->interval_s;
    }
    t->last = e->t;
    t->epochs++;
    t->sats += e->n_sats;
    for (size_t i = 0; i < e->n_sats; i++) {
        orr_inspect_sat_add(r, e->sat[i]);
        size_t n = h->codes[orr_sat_system_index(e->sat[i])].n;
        for (size_t j = 0; j < n; j++) {
            size_t k = i * e->stride + j;
            t->values += isnan(e->value[k]) ? 0 : 1;
            t->slips += (e->lli[k] & ORR_OBS_LLI_SLIP) != 0;
            t->half_cycles += (e->lli[k] & ORR_OBS_LLI_HALF_CYCLE) != 0;
        }
    }
}

static void obs_header_facts(const orr_rinex_obs_header *h, orr_inspection *r)
{
    if (h->hatanaka)
        orr_inspect_fact_add(r, "compressed", "Hatanaka %.1f of RINEX %.2f", h->crinex_version, h->version);
    if (h->marker_name[0] != '\0')
        orr_inspect_fact_add(r, "marker", "%s %s", h->marker_name, h->marker_number);
    if (h->receiver_type[0] != '\0')
        orr_inspect_fact_add(r, "receiver", "%s, version %s", h->receiver_type, h->receiver_version);
    if (h->antenna_type[0] != '\0') orr_inspect_fact_add(r, "antenna", "%s", h->antenna_type);
    if (h->has_position)
        orr_inspect_fact_add(r, "position", "%.4f %.4f %.4f m (ecef)", h->position_m.x, h->position_m.y,
                             h->position_m.z);
}

static void obs_code_facts(const orr_rinex_obs_header *h, orr_inspection *r)
{
    size_t unknown = 0;
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++) {
        const orr_obs_codes *c = &h->codes[s];
        if (c->n == 0 || strchr(r->systems, ORR_SYSTEMS[s]) == NULL) continue;
        char line[sizeof((orr_inspect_fact *)0)->text] = "";
        size_t at = 0;
        for (size_t j = 0; j < c->n && at + 8 < sizeof line; j++) {
            const bool odd = h->version >= 3 && !orr_obs_code_is_known(ORR_SYSTEMS[s], c->code[j]);
            at += (size_t)snprintf(line + at, sizeof line - at, "%s%s%s", j > 0 ? " " : "",
                                   c->code[j][0] != '\0' ? c->code[j] : c->original[j], odd ? "?" : "");
            unknown += odd;
        }
        orr_inspect_fact_add(r, orr_system_name(ORR_SYSTEMS[s]), "%s", line);
    }
    if (unknown > 0)
        orr_inspect_fact_add(r, "unknown", "%zu codes marked ? are none that RINEX has for their system",
                             unknown);
}

static void obs_tally_facts(const obs_tally *t, uint64_t skipped, orr_inspection *r)
{
    if (t->epochs > 0)
        orr_inspect_fact_add(r, "observations", "%llu values, %.1f satellites an epoch",
                             (unsigned long long)t->values, (double)t->sats / (double)t->epochs);
    if (t->slips + t->half_cycles > 0)
        orr_inspect_fact_add(r, "flags", "%llu losses of lock, %llu half cycles",
                             (unsigned long long)t->slips, (unsigned long long)t->half_cycles);
    if (t->power_failures > 0)
        orr_inspect_fact_add(r, "power failures", "%llu", (unsigned long long)t->power_failures);
    if (t->events > 0) orr_inspect_fact_add(r, "events", "%llu", (unsigned long long)t->events);
    if (t->has_clock) orr_inspect_fact_add(r, "receiver clock", "offsets given");
    if (skipped > 0) orr_inspect_fact_add(r, "left out", "%llu damaged epochs", (unsigned long long)skipped);
}

orr_status orr_inspect_rinex_obs(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_rinex_obs *reader = NULL;
    orr_rinex_obs_limits limits = orr_rinex_obs_default_limits();
    limits.leap = r->leap;
    orr_status s = r->raw != NULL ? orr_rinex_obs_open_memory(path, r->raw->text, r->raw->n, &limits,
                                                              &r->warnings, &reader, diag)
                                  : orr_rinex_obs_open(path, &limits, &r->warnings, &reader, diag);
    if (s != ORR_OK) return s;
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(reader);
    obs_tally t = {.first = malloc(STEPS_LOOKED_AT * sizeof *t.first), .last = ORR_TIME_NONE};
    if (t.first == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    snprintf(r->version, sizeof r->version, "%.2f", h->version);
    r->satellites = 0;
    const orr_rinex_obs_epoch *e = NULL;
    while (s == ORR_OK && (s = orr_rinex_obs_next(reader, &e, diag)) == ORR_OK && e != NULL)
        count_epoch(h, e, &t, r);
    if (s == ORR_OK) {
        if (t.n_first < STEPS_LOOKED_AT) orr_inspect_epochs(r, t.first, t.n_first);
        r->epochs = (int64_t)t.epochs;
        r->gaps += (int64_t)t.gaps_later;
        if (t.epochs > 0) r->to = t.last;
        if (h->declared_sats > 0 && h->declared_sats != r->satellites)
            orr_inspect_fact_add(r, "disagreement", "the header tells of %d satellites (# OF SATELLITES)",
                                 h->declared_sats);
        obs_header_facts(h, r);
        obs_code_facts(h, r);
        obs_tally_facts(&t, orr_rinex_obs_skipped(reader), r);
    }
    free(t.first);
    orr_rinex_obs_close(reader);
    return s;
}

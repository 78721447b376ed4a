// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "src/scenario/orbit_source.h"

struct orr_engine {
    orr_ephemeris *eph;
    char title[128];
    orr_time from, to;
    const orr_sat *sat; // borrowed from eph
    size_t n_sats;
};

orr_status orr_engine_from_ephemeris(orr_ephemeris *eph, const char *title, orr_engine **out, orr_diag *diag)
{
    orr_engine *e = calloc(1, sizeof *e);
    if (e == NULL) {
        orr_ephemeris_free(eph);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    e->eph = eph;
    snprintf(e->title, sizeof e->title, "%s", title);
    orr_ephemeris_span(eph, &e->from, &e->to);
    e->n_sats = orr_ephemeris_satellites(eph, &e->sat);
    *out = e;
    return ORR_OK;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

orr_status orr_engine_open_product(const char *path, orr_engine **out, orr_diag *diag)
{
    orr_ephemeris *eph;
    orr_status s = orr_ephemeris_load(path, &eph, diag);
    return s == ORR_OK ? orr_engine_from_ephemeris(eph, base_name(path), out, diag) : s;
}

orr_status orr_engine_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_engine **out, orr_diag *diag)
{
    orr_ephemeris *eph;
    const char *title = s->title;
    orr_status status;
    if (s->orbit.product != NULL) {
        status = orr_ephemeris_load(s->orbit.product, &eph, diag);
        if (title == NULL) title = base_name(s->orbit.product);
    } else {
        status = orr_orbit_source_smooth(&s->orbit, log, cancel, warnings, &eph, diag);
        if (title == NULL) title = base_name(s->orbit.sp3.item[0]);
    }
    return status == ORR_OK ? orr_engine_from_ephemeris(eph, title, out, diag) : status;
}

void orr_engine_close(orr_engine *e)
{
    if (e == NULL) return;
    orr_ephemeris_free(e->eph);
    free(e);
}

const char *orr_engine_title(const orr_engine *e) { return e->title; }
const char *orr_engine_frame(const orr_engine *e) { return orr_ephemeris_frame(e->eph); }
void orr_engine_span(const orr_engine *e, orr_time *from, orr_time *to)
{
    *from = e->from;
    *to = e->to;
}
size_t orr_engine_satellites(const orr_engine *e, const orr_sat **list)
{
    *list = e->sat;
    return e->n_sats;
}

// Those that have an arc come without gaps from the front; each moves back to its satellite's place.
static void spread(const orr_engine *e, size_t found, orr_sat_state *state, orr_answer *answer)
{
    for (size_t i = e->n_sats; i-- > 0;) {
        if (found > 0 && state[found - 1].sat == e->sat[i]) {
            found--;
            if (found != i) state[i] = state[found];
            answer[i] = ORR_ANSWER_OK;
        } else {
            state[i].sat = e->sat[i];
            answer[i] = ORR_ANSWER_NO_ARC;
        }
    }
}

static bool is_served(const orr_engine *e, orr_sat sat)
{
    size_t low = 0, high = e->n_sats;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (e->sat[mid] < sat)
            low = mid + 1;
        else
            high = mid;
    }
    return low < e->n_sats && e->sat[low] == sat;
}

orr_answer orr_engine_states(const orr_engine *e, orr_time t, const orr_sat *sats, size_t n,
                             orr_sat_state *state, orr_answer *answer)
{
    if (t < e->from || t > e->to) return ORR_ANSWER_OUTSIDE_SPAN;
    if (sats == NULL) {
        spread(e, orr_ephemeris_eval_all(e->eph, t, state, n), state, answer);
        return ORR_ANSWER_OK;
    }
    for (size_t i = 0; i < n; i++) {
        state[i].sat = sats[i];
        if (orr_ephemeris_eval(e->eph, sats[i], t, &state[i]) == ORR_OK)
            answer[i] = ORR_ANSWER_OK;
        else
            answer[i] = is_served(e, sats[i]) ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NOT_SERVED;
    }
    return ORR_ANSWER_OK;
}

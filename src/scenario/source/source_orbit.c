// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/source/source_orbit.h"

#include <stdio.h>
#include <stdlib.h>

#include "orbit/ephemeris/broadcast_orbits.h"
#include "src/make/inputs.h"
#include "src/make/orbit.h"
#include "src/make/products.h"

struct orr_source_orbit {
    orr_ephemeris *eph;
    orr_span span;
    const orr_sat *sat; // borrowed from eph
    size_t n_sats;
};

orr_status orr_source_orbit_of_ephemeris(orr_ephemeris *eph, orr_source_orbit **out, orr_diag *diag)
{
    orr_source_orbit *o = calloc(1, sizeof *o);
    *out = o;
    if (o == NULL) {
        orr_ephemeris_free(eph);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    o->eph = eph;
    orr_ephemeris_span(eph, &o->span.from, &o->span.to);
    o->n_sats = orr_ephemeris_satellites(eph, &o->sat);
    return ORR_OK;
}

// What the records of navigation files and longitudes tell of satellites that *e does not have; NULL: of all.
static orr_status others(const orr_scenario *s, const orr_nav *nav, const orr_ephemeris *e,
                         orr_ephemeris **out, orr_warnings *warnings, orr_diag *diag)
{
    const size_t n = s->orbit.geo.n;
    orr_sat_set has = {0};
    const orr_sat *list;
    orr_time from = ORR_TIME_NONE, to = ORR_TIME_NONE;
    if (e != NULL) orr_ephemeris_span(e, &from, &to);
    for (size_t i = 0, k = e != NULL ? orr_ephemeris_satellites(e, &list) : 0; i < k; i++)
        orr_sat_set_add(&has, list[i]);
    orr_geostationary *geo = calloc(n + 1, sizeof *geo);
    if (geo == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_status status = ORR_OK;
    for (size_t i = 0; i < n && status == ORR_OK; i++) {
        const orr_scenario_geo *g = &s->orbit.geo.item[i];
        geo[i] = (orr_geostationary){orr_sat_parse(g->sat), g->longitude_deg * ORR_RAD_PER_DEG};
        if (orr_sat_set_has(&has, geo[i].sat)) {
            char path[40];
            snprintf(path, sizeof path, "orbit.geo[%zu].sat", i);
            status = orr_marks_blame(&s->marks, ORR_E_ARG, path,
                                     "the orbits have it already: leave it out of geo", diag);
        }
    }
    if (status == ORR_OK) status = orr_broadcast_orbits(nav, &has, geo, n, from, to, out, warnings, diag);
    free(geo);
    return status;
}

static orr_status complete(const orr_scenario *s, const orr_log *log, orr_ephemeris **e,
                           orr_warnings *warnings, orr_diag *diag)
{
    orr_inputs inputs = {.leap = s->leap};
    orr_nav nav = {0};
    orr_ephemeris *more = NULL, *both = NULL;
    const orr_sat *list;
    orr_status status = orr_inputs_read_navs(&inputs, (const char *const *)s->orbit.nav.item, s->orbit.nav.n,
                                             &nav, warnings, diag);
    if (status == ORR_OK) status = others(s, s->orbit.nav.n > 0 ? &nav : NULL, *e, &more, warnings, diag);
    if (status == ORR_OK && more == NULL && *e == NULL)
        status = orr_marks_blame(&s->marks, ORR_E_NODATA, "orbit.nav", "no record tells an orbit", diag);
    if (status == ORR_OK && more != NULL) {
        ORR_LOG(log, ORR_LOG_INFO, "orbits of %zu satellites from broadcast records and longitudes",
                orr_ephemeris_satellites(more, &list));
        if (*e != NULL) status = orr_ephemeris_join(*e, more, &both, diag);
    }
    if (status == ORR_OK && both != NULL) {
        orr_ephemeris_free(*e);
        *e = both;
    } else if (status == ORR_OK && *e == NULL) {
        *e = more;
        more = NULL;
    }
    orr_ephemeris_free(more);
    orr_nav_free(&nav);
    orr_inputs_free(&inputs);
    return status;
}

orr_status orr_source_orbit_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                                 orr_warnings *warnings, orr_source_orbit **out, orr_diag *diag)
{
    *out = NULL;
    orr_orbit_made made = {0};
    orr_status status = ORR_OK;
    if (s->orbit.product != NULL) {
        status = orr_product_load(s->orbit.product, &made.ephemeris, diag);
    } else if (s->orbit.sp3.n > 0) {
        const orr_orbit_plan plan = orr_orbit_plan_of(s);
        status = orr_orbit_make(&plan, log, cancel, &made, warnings, diag);
    } else if (s->orbit.nav.n == 0)
        return ORR_OK;
    if (status == ORR_OK && (s->orbit.nav.n > 0 || s->orbit.geo.n > 0))
        status = complete(s, log, &made.ephemeris, warnings, diag);
    if (status == ORR_OK) {
        status = orr_source_orbit_of_ephemeris(made.ephemeris, out, diag);
        made.ephemeris = NULL; // taken over
    }
    orr_orbit_made_free(&made);
    return status;
}

void orr_source_orbit_close(orr_source_orbit *o)
{
    if (o == NULL) return;
    orr_ephemeris_free(o->eph);
    free(o);
}

bool orr_source_orbit_span(const orr_source_orbit *o, orr_span *out)
{
    if (o != NULL) *out = o->span;
    return o != NULL;
}

const orr_ephemeris *orr_source_orbit_ephemeris(const orr_source_orbit *o)
{
    return o != NULL ? o->eph : NULL;
}

size_t orr_source_orbit_satellites(const orr_source_orbit *o, const orr_sat **list)
{
    *list = o != NULL ? o->sat : NULL;
    return o != NULL ? o->n_sats : 0;
}

bool orr_source_orbit_has(const orr_source_orbit *o, orr_sat sat)
{
    size_t low = 0, high = o != NULL ? o->n_sats : 0, n = high;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (o->sat[mid] < sat)
            low = mid + 1;
        else
            high = mid;
    }
    return low < n && o->sat[low] == sat;
}

// Why a satellite of whom there is no state has none.
static orr_answer absent(const orr_source_orbit *o, orr_sat sat)
{
    return orr_source_orbit_has(o, sat) ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NOT_SERVED;
}

// All of them, as fast as a constellation side by side is.
static void all_states(const orr_source_orbit *o, orr_ephemeris_slice *slice, orr_time t,
                       orr_sat_state *state, orr_answer *answer)
{
    const bool *has = orr_ephemeris_slice_eval(slice, t, state);
    for (size_t i = 0; i < o->n_sats; i++) {
        state[i].sat = o->sat[i];
        answer[i] = has[i] ? ORR_ANSWER_OK : ORR_ANSWER_NO_ARC;
    }
}

orr_answer orr_source_orbit_states(const orr_source_orbit *o, orr_ephemeris_slice *slice, orr_time t,
                                   const orr_sat *sats, size_t n, orr_sat_state *state, orr_answer *answer)
{
    if (o == NULL) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(o->span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    if (sats == NULL && slice != NULL) {
        all_states(o, slice, t, state, answer);
        return ORR_ANSWER_OK;
    }
    if (sats == NULL) sats = o->sat;
    for (size_t i = 0; i < n; i++) {
        state[i].sat = sats[i];
        answer[i] =
            orr_ephemeris_eval(o->eph, sats[i], t, &state[i]) == ORR_OK ? ORR_ANSWER_OK : absent(o, sats[i]);
    }
    return ORR_ANSWER_OK;
}

orr_answer orr_source_orbit_axes(const orr_source_orbit *o, orr_time t, orr_elements_frame frame,
                                 orr_elements_method method, orr_elements_axes *out)
{
    if (o == NULL) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(o->span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    const orr_elements_options options = {.frame = frame, .method = method, .eop = orr_ephemeris_eop(o->eph)};
    orr_elements_axes_at(t, &options, out);
    return ORR_ANSWER_OK;
}

orr_answer orr_source_orbit_elements(const orr_source_orbit *o, const orr_elements_axes *axes,
                                     const orr_sat *sats, size_t n, orr_kepler *out, uint32_t *flags,
                                     orr_answer *answer)
{
    if (o == NULL) return ORR_ANSWER_NOT_SERVED;
    const orr_time t = axes->t;
    if (sats == NULL) sats = o->sat;
    for (size_t i = 0; i < n; i++) {
        orr_sat_state state;
        if (orr_ephemeris_eval(o->eph, sats[i], t, &state) != ORR_OK)
            answer[i] = absent(o, sats[i]);
        else if (orr_elements_of(o->eph, sats[i], axes, &out[i]) != ORR_OK)
            answer[i] = ORR_ANSWER_NO_VALUE;
        else {
            answer[i] = ORR_ANSWER_OK;
            flags[i] = state.flags;
        }
    }
    return ORR_ANSWER_OK;
}

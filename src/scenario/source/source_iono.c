// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/source/source_iono.h"

#include <stdlib.h>

#include "core/earth.h"
#include "core/limb.h"
#include "core/nan.h"

_Static_assert((int)ORR_IONO_MAPS_BILINEAR == ORR_TEC_BILINEAR &&
                   (int)ORR_IONO_MAPS_HARMONICS == ORR_TEC_HARMONIC &&
                   (int)ORR_IONO_MAPS_AUTO == ORR_TEC_SPATIAL_DEFAULT &&
                   (int)ORR_IONO_BETWEEN_NEAREST == ORR_TEC_NEAREST &&
                   (int)ORR_IONO_BETWEEN_LINEAR == ORR_TEC_LINEAR &&
                   (int)ORR_IONO_BETWEEN_ROTATED == ORR_TEC_ROTATED &&
                   (int)ORR_IONO_BETWEEN_AUTO == ORR_TEC_TEMPORAL_DEFAULT,
               "words of a scenario and ways of a field");
_Static_assert((int)ORR_IONO_MODEL_AUTO == ORR_TEC_AUTO && (int)ORR_IONO_MODEL_GPS == ORR_TEC_GPS &&
                   (int)ORR_IONO_MODEL_QZSS == ORR_TEC_QZSS && (int)ORR_IONO_MODEL_NAVIC == ORR_TEC_NAVIC &&
                   (int)ORR_IONO_MODEL_BEIDOU == ORR_TEC_BEIDOU &&
                   (int)ORR_IONO_MODEL_BDGIM == ORR_TEC_BDGIM &&
                   (int)ORR_IONO_MODEL_NEQUICK == ORR_TEC_NEQUICK &&
                   (int)ORR_IONO_MAPPING_NONE == ORR_MAPPING_NONE &&
                   (int)ORR_IONO_MAPPING_THIN_SHELL == ORR_MAPPING_THIN_SHELL &&
                   (int)ORR_IONO_MAPPING_MSLM == ORR_MAPPING_MSLM,
               "words of a scenario, broadcast models and mapping functions");

struct orr_source_iono {
    const orr_source_orbit *orbits;
    bool has_session;
    orr_session session;
    orr_tec_field *field;
    orr_transfer_options transfer;
};

orr_tec_options orr_source_iono_options(const orr_scenario *s)
{
    const orr_scenario_iono *o = &s->iono;
    orr_tec_options options = orr_tec_default_options();
    options.spatial = (orr_tec_spatial)o->maps;
    options.temporal = (orr_tec_temporal)o->between;
    options.rotation = o->rotation;
    options.algorithm = (orr_tec_algorithm)o->model;
    options.nequick = o->nequick;
    options.mapping = (orr_mapping_kind)o->mapping;
    options.leap = s->leap;
    return options;
}

orr_status orr_source_iono_open(const orr_scenario *s, const orr_source_orbit *orbits, orr_warnings *warnings,
                                orr_source_iono **out, orr_diag *diag)
{
    const orr_scenario_iono *o = &s->iono;
    *out = NULL;
    if (o->field == NULL && o->session == NULL) return ORR_OK;
    orr_source_iono *i = calloc(1, sizeof *i);
    if (i == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    i->orbits = orbits;
    i->transfer = (orr_transfer_options){.seed = (uint64_t)o->seed, .noise = o->noise};
    orr_status status;
    if (o->session != NULL) {
        status = orr_session_load(o->session, s->leap, &i->session, diag);
        i->has_session = status == ORR_OK;
    } else {
        const orr_tec_options options = orr_source_iono_options(s);
        status = orr_tec_field_open(o->field, &options, &i->field, warnings, diag);
    }
    if (status != ORR_OK) {
        orr_source_iono_close(i);
        return status;
    }
    *out = i;
    return ORR_OK;
}

void orr_source_iono_close(orr_source_iono *i)
{
    if (i == NULL) return;
    orr_session_free(&i->session);
    orr_tec_field_free(i->field);
    free(i);
}

bool orr_source_iono_span(const orr_source_iono *i, orr_span *out)
{
    if (i == NULL) return false;
    orr_tec_field_span(i->has_session ? i->session.field : i->field, &out->from, &out->to);
    return true;
}

bool orr_source_iono_station(const orr_source_iono *i, orr_vec3 *out)
{
    if (i == NULL) return false;
    if (i->has_session) *out = i->session.site.pos_m;
    return i->has_session;
}

static orr_status realise(const orr_source_iono *i, orr_time t, orr_vec3 site_m, const orr_sat *sat,
                          const orr_vec3 *sat_m, size_t n, orr_realisation *out, size_t *n_out)
{
    return i->has_session
               ? orr_session_realise(&i->session, t, site_m, sat, sat_m, n, &i->transfer, out, n_out, NULL)
               : orr_field_realise(i->field, t, site_m, sat, sat_m, n, out, n_out, NULL);
}

// Where a satellite stands for the receiver; its azimuth and elevation go into *delay.
static orr_answer look(const orr_source_orbit *orbits, orr_time t, orr_vec3 receiver_m, orr_sat sat,
                       orr_vec3 *sat_m, orr_realisation *delay)
{
    orr_sat_state state;
    orr_answer answer = ORR_ANSWER_OK;
    *delay = (orr_realisation){.sat = sat};
    orr_source_orbit_states(orbits, NULL, t, &sat, 1, &state, &answer);
    if (answer != ORR_ANSWER_OK) return answer;
    double az, el, range;
    orr_earth_look(receiver_m, state.pos_m, &az, &el, &range);
    if (orr_limb_in_space(receiver_m) ? orr_limb_hides(receiver_m, state.pos_m, ORR_SPACE_HEIGHT_M)
                                      : !(el >= 0))
        return ORR_ANSWER_BELOW_HORIZON;
    delay->pierce.az_rad = az;
    delay->pierce.el_rad = el;
    *sat_m = state.pos_m;
    return ORR_ANSWER_OK;
}

orr_answer orr_source_iono_evaluate(const orr_source_iono *i, orr_time t, orr_vec3 receiver_m,
                                    const orr_sat *sats, size_t n, orr_realisation *delay, orr_answer *answer)
{
    orr_sat sat[ORR_SESSION_MAX_SATS] = {0};
    orr_vec3 pos[ORR_SESSION_MAX_SATS] = {{0}};
    size_t place[ORR_SESSION_MAX_SATS], known = 0, got = 0;
    orr_span span;
    if (i == NULL || !orr_source_orbit_span(i->orbits, &span)) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(span, t) || n > ORR_SESSION_MAX_SATS) return ORR_ANSWER_OUTSIDE_SPAN;
    if (sats == NULL) orr_source_orbit_satellites(i->orbits, &sats);
    for (size_t k = 0; k < n; k++) {
        answer[k] = look(i->orbits, t, receiver_m, sats[k], &pos[known], &delay[k]);
        if (answer[k] != ORR_ANSWER_OK) continue;
        answer[k] = ORR_ANSWER_NO_VALUE; // until there is one
        sat[known] = sats[k];
        place[known++] = k;
    }
    // Results come in the order asked, those without a value left out. Whether the ionosphere covers t does
    // not depend on who is seen.
    orr_realisation found[ORR_SESSION_MAX_SATS];
    if (realise(i, t, receiver_m, sat, pos, known, found, &got) != ORR_OK) return ORR_ANSWER_OUTSIDE_SPAN;
    for (size_t k = 0, g = 0; k < known && g < got; k++)
        if (sat[k] == found[g].sat) {
            delay[place[k]] = found[g++];
            answer[place[k]] = ORR_ANSWER_OK;
        }
    return ORR_ANSWER_OK;
}

orr_answer orr_source_iono_contents(const orr_source_iono *i, orr_time t, orr_vec3 receiver_m,
                                    const orr_sat *sat, const orr_vec3 *sat_m, size_t n, double *stec_tecu)
{
    orr_realisation found[ORR_SESSION_MAX_SATS];
    size_t got = 0;
    if (n > ORR_SESSION_MAX_SATS || realise(i, t, receiver_m, sat, sat_m, n, found, &got) != ORR_OK)
        return ORR_ANSWER_OUTSIDE_SPAN;
    for (size_t k = 0, g = 0; k < n; k++)
        stec_tecu[k] = g < got && found[g].sat == sat[k] ? found[g++].stec_tecu : ORR_NAN;
    return ORR_ANSWER_OK;
}

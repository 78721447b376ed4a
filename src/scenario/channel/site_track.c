// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/site_track.h"

static const int64_t STEP_NS = 60 * ORR_NS_PER_S;

orr_status orr_site_track_open(const orr_scenario_site *o, const orr_eop_series *eop,
                               const orr_ocean_loading *ocean, orr_vec3 r_m, const orr_mat3 *enu,
                               const orr_sun_track *sun, orr_span span, size_t *spare, orr_site_track *out)
{
    *out = (orr_site_track){.moves = o->solid_tide || o->pole_tide || ocean != NULL};
    // Rates of slow terms look beyond both ends.
    const orr_time from = orr_time_add(span.from, -ORR_NS_PER_S), to = orr_time_add(span.to, ORR_NS_PER_S);
    for (size_t k = 0; out->moves && k < SITE_AXES; k++) {
        const orr_status s = orr_series_open(from, to, STEP_NS, spare, &out->axis[k]);
        if (s != ORR_OK) return s;
    }
    for (size_t i = 0; i < out->axis[0].n; i++) {
        const orr_time t = orr_time_add(out->axis[0].from, ((int64_t)i - 1) * STEP_NS);
        const orr_site_moved m = orr_site_at(o, eop, ocean, r_m, enu, orr_sun_track_at(sun, t), t);
        const orr_vec3 v[] = {m.solid_m, m.pole_m, m.ocean_m};
        for (size_t k = 0; k < 3; k++) {
            out->axis[3 * k].node[i] = v[k].x;
            out->axis[3 * k + 1].node[i] = v[k].y;
            out->axis[3 * k + 2].node[i] = v[k].z;
        }
    }
    return ORR_OK;
}

void orr_site_track_free(orr_site_track *s)
{
    for (size_t k = 0; k < SITE_AXES; k++) orr_series_free(&s->axis[k]);
}

static orr_vec3 vector_at(const orr_series *axis, orr_time t)
{
    double rate;
    return (orr_vec3){orr_series_at(&axis[0], t, &rate), orr_series_at(&axis[1], t, &rate),
                      orr_series_at(&axis[2], t, &rate)};
}

orr_site_moved orr_site_track_at(const orr_site_track *s, orr_time t)
{
    if (!s->moves) return (orr_site_moved){{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    return (orr_site_moved){vector_at(s->axis, t), vector_at(s->axis + 3, t), vector_at(s->axis + 6, t)};
}

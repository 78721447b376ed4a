// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/spoofed.h"

#include <math.h>
#include <stdlib.h>

#include "core/angle.h"
#include "src/scenario/effect/mover.h"

typedef struct spoofer {
    bool has_sats;
    orr_sat_set sats;
    orr_interval sends;
    orr_mover transmitter;
    double delay_m, power_db;
} spoofer;

struct spoofed {
    orr_channels sky; // borrows from the scenario's channels; its antennas are the places told, one a spoofer
    spoofer item[ORR_MAX_SPOOFERS];
};

// The scenario's channels without what surrounds its antennas.
static orr_channels bare(const orr_channels *c, size_t n)
{
    orr_channels sky = *c;
    sky.n_antennas = n;
    sky.faults = NULL;
    sky.echoes = NULL;
    sky.obstacles = NULL;
    sky.jammers = NULL;
    sky.land_mobile = NULL;
    sky.scintillation = NULL;
    sky.spoofed = NULL;
    sky.site = (orr_scenario_site){.solid_tide = false};
    sky.mask = (orr_scenario_mask){.elevation_deg = c->mask.elevation_deg};
    for (size_t k = 0; k < ORR_MAX_ANTENNAS; k++) sky.windup[k] = (orr_windup){.n_headings = 0};
    return sky;
}

static orr_antenna antenna_at(const orr_real_list *place)
{
    const orr_mover m = orr_mover_of(place, &(orr_real_list){.n = 0}, 0);
    orr_antenna a = {.unit = 0};
    a.fixed.r_m = m.r_m;
    const orr_geodetic told = orr_earth_from_ecef(m.r_m);
    a.fixed.enu = a.fixed.axes = orr_earth_enu_from_ecef(told.lat_rad, told.lon_rad);
    return a;
}

orr_status spoofed_open(const orr_scenario *s, orr_channels *c, const volatile int *cancel, orr_diag *diag)
{
    const size_t n = s->spoofers.n;
    if (n == 0) return ORR_OK;
    struct spoofed *x = calloc(1, sizeof *x);
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    x->sky = bare(c, n);
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < n; k++) {
        const orr_scenario_spoofer *o = &s->spoofers.item[k];
        x->sky.antenna[k] = antenna_at(&o->pretends);
        x->item[k] = (spoofer){
            .has_sats = o->has_sats,
            .sats = o->sats,
            .sends = {o->has_from ? o->from : c->span.from, o->has_to ? o->to : c->span.to + 1},
            .transmitter = orr_mover_of(&o->position, &o->velocity_mps, o->has_from ? o->from : c->span.from),
            .delay_m = ORR_LIGHT_MPS * o->delay_s,
            .power_db = o->power_db};
        if (c->options.windup)
            status = orr_windup_open(c->orbits, &x->sky.antenna[k], c->antex, c->span, &c->sun, cancel,
                                     &x->sky.windup[k], diag);
    }
    if (status != ORR_OK) {
        spoofed_close(x);
        return status;
    }
    c->spoofed = x;
    c->max_channels += n * x->sky.max_channels;
    return ORR_OK;
}

void spoofed_close(struct spoofed *x)
{
    if (x == NULL) return;
    for (size_t k = 0; k < ORR_MAX_SPOOFERS; k++) orr_windup_free(&x->sky.windup[k]);
    free(x);
}

orr_status spoofed_work_open(const orr_channels *c, orr_channel_work **out, orr_diag *diag)
{
    *out = NULL;
    return c->spoofed != NULL ? orr_channel_work_open(&c->spoofed->sky, out, diag) : ORR_OK;
}

// A channel of the place told, as it arrives from the transmitter.
static void send(const spoofer *x, const orr_antenna_state *at, orr_time t, channel_list *list, size_t k)
{
    const orr_vec3 d = orr_vec3_sub(orr_mover_at(&x->transmitter, t), at->r_m),
                   own = orr_mat3_apply(&at->enu, d);
    const double range = orr_vec3_norm(d), az = orr_atan2(own.x, own.y),
                 rate =
                     range > 0 ? orr_vec3_dot(d, orr_vec3_sub(x->transmitter.v_mps, at->v_mps)) / range : 0;
    orr_channel *out = &list->channel[k];
    out->term_m[ORR_TERM_SPOOFER] = range + x->delay_m;
    out->rate_mps[ORR_TERM_SPOOFER] = rate;
    out->az_rad = az < 0 ? az + 2 * ORR_PI : az;
    out->el_rad = orr_atan2(own.z, sqrt(own.x * own.x + own.y * own.y));
    out->power_dbw += x->power_db;
    channels_sum(t, list->start[k], out);
}

void spoofed_add(const orr_channels *c, orr_channel_work *work, const orr_antenna_state *at, uint64_t signals,
                 const bool *also, channel_list *list)
{
    struct spoofed *x = c->spoofed;
    for (size_t k = 0; x != NULL && k < x->sky.n_antennas; k++) {
        if (!orr_interval_holds(x->item[k].sends, list->as_of)) continue;
        channel_list *told = &work->spoofed->antenna[k].begin;
        channels_evaluate(&x->sky, k, work->spoofed, list->t, list->as_of, &x->sky.antenna[k].fixed, signals,
                          also, told);
        for (size_t j = 0; j < told->n; j++) {
            if (x->item[k].has_sats && !orr_sat_set_has(&x->item[k].sats, told->channel[j].sat)) continue;
            list->channel[list->n] = told->channel[j];
            list->channel[list->n].echo = (uint16_t)(ORR_CHANNEL_SPOOFED * (k + 1));
            list->place[list->n] = told->place[j];
            list->seen[list->n] = told->seen[j];
            list->start[list->n] = told->start[j];
            send(&x->item[k], at, list->t, list, list->n++);
        }
    }
}

bool spoofed_change(const orr_channels *c, orr_time after, orr_time until)
{
    const struct spoofed *x = c->spoofed;
    for (size_t k = 0; x != NULL && k < x->sky.n_antennas; k++) {
        const orr_interval i = x->item[k].sends;
        if ((after < i.from && i.from <= until) || (after < i.to && i.to <= until)) return true;
    }
    return false;
}

bool spoofed_allow(const orr_channels *c, orr_time from, orr_time to, int64_t length_ns)
{
    const struct spoofed *x = c->spoofed;
    for (size_t k = 0; x != NULL && k < x->sky.n_antennas; k++) {
        const orr_interval i = x->item[k].sends;
        if ((from <= i.from && i.from < to && i.from > c->span.from && i.from % length_ns != 0) ||
            (from <= i.to && i.to < to && i.to <= c->span.to && i.to % length_ns != 0))
            return false;
    }
    return true;
}

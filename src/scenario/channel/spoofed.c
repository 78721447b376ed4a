// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/spoofed.h"

#include <stdlib.h>

// The scenario's channels without what surrounds its antennas.
static orr_channels bare(const orr_channels *c, size_t n)
{
    orr_channels sky = *c;
    sky.n_antennas = n;
    sky.faults = NULL;
    sky.echoes = NULL;
    sky.obstacles = NULL;
    sky.terrain = NULL;
    sky.jammers = NULL;
    sky.land_mobile = NULL;
    sky.scintillation = NULL;
    sky.spoofed = NULL;
    sky.mask = (orr_scenario_mask){.elevation_deg = c->mask.elevation_deg};
    for (size_t k = 0; k < ORR_MAX_ANTENNAS; k++) {
        sky.windup[k] = (orr_windup){.n_headings = 0};
        sky.ground[k] = (orr_site_track){.moves = false};
    }
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
        const orr_geodetic pretended = orr_earth_from_ecef(x->sky.antenna[k].fixed.r_m);
        status = orr_troposphere_covers(c->troposphere, "that a spoofer pretends", &pretended, diag);
        if (status == ORR_OK && c->options.windup)
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

bool spoofed_change(const orr_channels *c, orr_time after, orr_time until)
{
    const struct spoofed *x = c->spoofed;
    for (size_t k = 0; x != NULL && k < x->sky.n_antennas; k++)
        if (orr_interval_turns(x->item[k].sends, after, until)) return true;
    return false;
}

bool spoofed_allow(const orr_channels *c, orr_time from, orr_time to, int64_t length_ns)
{
    const struct spoofed *x = c->spoofed;
    // At the scenario's own begin and end no block has to begin.
    const orr_interval begins = {from > c->span.from ? from : c->span.from + 1, to},
                       ends = {from, to <= c->span.to ? to : c->span.to + 1};
    for (size_t k = 0; x != NULL && k < x->sky.n_antennas; k++)
        if (!orr_instant_fits(x->item[k].sends.from, begins, length_ns) ||
            !orr_instant_fits(x->item[k].sends.to, ends, length_ns))
            return false;
    return true;
}

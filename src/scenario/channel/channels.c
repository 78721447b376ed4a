// SPDX-License-Identifier: GPL-3.0-or-later
// What prepared channels say of themselves.
#include "src/scenario/channel/channels_private.h"

size_t orr_channels_antennas(const orr_channels *c) { return c != NULL ? c->n_antennas : 0; }

const orr_antenna *orr_channels_antenna(const orr_channels *c, size_t antenna)
{
    return antenna < orr_channels_antennas(c) ? &c->antenna[antenna] : NULL;
}

uint64_t orr_channels_signals(const orr_channels *c) { return c != NULL ? c->signals : 0; }
orr_span orr_channels_span(const orr_channels *c) { return c->span; }
orr_span orr_channels_antenna_span(const orr_channels *c, size_t antenna)
{
    orr_span span = c->span, moved;
    if (c->antenna[antenna].motion != NULL && orr_source_motion_span(c->antenna[antenna].motion, &moved)) {
        if (moved.from > span.from) span.from = moved.from;
        if (moved.to < span.to) span.to = moved.to;
    }
    return span;
}

size_t orr_channels_max(const orr_channels *c) { return c != NULL ? c->max_channels : 0; }

size_t orr_channels_jammers(const orr_channels *c, const orr_antenna_state *at, orr_time t,
                            orr_jammer out[ORR_MAX_JAMMERS])
{
    return orr_jammers_at(c->jammers, at, t, out);
}

double orr_channels_oscillator(const orr_channels *c, size_t antenna, orr_time t, double *rate)
{
    double held_s;
    *rate = 0;
    if (c->replay != NULL) return orr_replay_clock_s(c->replay, t, rate, &held_s);
    return c->oscillator[antenna].n > 0 ? orr_series_at(&c->oscillator[antenna], t, rate) : 0;
}

double orr_channels_held_s(const orr_channels *c, orr_time t)
{
    double rate, held_s = 0;
    if (c->replay != NULL) (void)orr_replay_clock_s(c->replay, t, &rate, &held_s);
    return held_s;
}

orr_troposphere_site orr_channels_troposphere(const orr_channels *c, size_t antenna, orr_geodetic place,
                                              orr_time t)
{
    if (c->troposphere == NULL) return (orr_troposphere_site){.model = ORR_TROPOSPHERE_NONE};
    orr_troposphere_site out = orr_troposphere_at(c->troposphere, antenna, place, t);
    const orr_replay *r = c->replay;
    if (r == NULL) return out;
    out.zenith.hydrostatic_m += orr_replay_curve_at(&r->dry, t);
    out.zenith.wet_m += orr_replay_curve_at(&r->zenith, t);
    if (!out.has_gradients) out.gradients = (orr_gradients){0, 0, 0, 0};
    out.has_gradients = true;
    out.gradients.north_wet_m += orr_replay_curve_at(&r->north, t);
    out.gradients.east_wet_m += orr_replay_curve_at(&r->east, t);
    return out;
}

double orr_channels_spacing(const orr_channels *c, size_t signal)
{
    if (c->spacing_chips > 0) return c->spacing_chips;
    return orr_signals(&(size_t){0})[signal].chips_per_s > 5e6 ? 0.1 : 0.5;
}

bool orr_channels_fault(const orr_channels *c, size_t k, orr_channel_fault *out)
{
    orr_fault_time x;
    if (c == NULL || !orr_faults_time(c->faults, k, &x)) return false;
    *out = (orr_channel_fault){c->satellite[x.place].sat, x.number, x.from, x.to};
    return true;
}

bool orr_channels_frequency_channel(const orr_channels *c, orr_sat sat, int *channel)
{
    if (orr_sat_system(sat) != 'R') return false;
    for (size_t k = 0; k < c->n_sats; k++)
        if (c->satellite[k].sat == sat && c->satellite[k].sends)
            return *channel = c->satellite[k].frequency_channel, true;
    return false;
}

void channels_vehicle(const orr_channels *c, orr_sat sat, const char **svn, const char **block)
{
    *svn = *block = "";
    const orr_antex_antenna *a = c->antex != NULL ? orr_antex_find_sat(c->antex, sat, c->span.from) : NULL;
    if (a != NULL) {
        *svn = a->svn;
        *block = a->type;
        return;
    }
    const char *listed = orr_satellite_metadata_svn(&c->metadata, sat, c->span.from);
    if (listed == NULL) return;
    *svn = listed;
    const orr_metadata_line *id =
        orr_satellite_metadata_at(&c->metadata, ORR_METADATA_IDENTIFIER, listed, c->span.from);
    if (id != NULL) *block = id->block;
}

bool orr_channels_transmitter(const orr_channels *c, size_t k, orr_transmitter *out)
{
    for (size_t i = 0; i < c->n_sats; i++) {
        const channel_satellite *x = &c->satellite[i];
        if (!x->sends || k-- > 0) continue;
        *out = (orr_transmitter){.sat = x->sat,
                                 .frequency_channel = x->frequency_channel,
                                 .unhealthy = (x->flags & ORR_CHANNEL_UNHEALTHY) != 0};
        channels_vehicle(c, x->sat, &out->svn, &out->block);
        return true;
    }
    return false;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Channels prepared: satellites and antennas looked up, turns counted.
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/rng.h"
#include "ingest/rinex/rinex_obs.h"
#include "orbit/force/orbit_class.h"
#include "orbit/navdata/glonass_channel.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/channel/channels_private.h"
#include "src/scenario/channel/spoofed.h"

// Light is on its way for 0.15 s at most, and rates are taken from so far on both sides.
static const int64_t MARGIN_NS = ORR_NS_PER_S / 5;

// What a satellite transmits in all, W; 0 where no file tells it.
static double transmits_w(const orr_channels *c, orr_sat sat)
{
    const char *svn = orr_satellite_metadata_svn(&c->metadata, sat, c->span.from);
    const orr_metadata_line *x =
        svn != NULL ? orr_satellite_metadata_at(&c->metadata, ORR_METADATA_POWER, svn, c->span.from) : NULL;
    return x != NULL ? x->value : 0;
}

// Mean of what the satellites that send and are of the same system and block transmit, W.
static double mean_of_block_w(const orr_channels *c, orr_sat sat)
{
    const char *svn, *block, *other;
    double sum = 0;
    size_t n = 0;
    channels_vehicle(c, sat, &svn, &block);
    for (size_t k = 0; k < c->n_sats; k++) {
        const channel_satellite *x = &c->satellite[k];
        if (!x->sends || orr_sat_system(x->sat) != orr_sat_system(sat)) continue;
        channels_vehicle(c, x->sat, &svn, &other);
        const double w = strcmp(block, other) == 0 ? transmits_w(c, x->sat) : 0;
        sum += w;
        n += w > 0;
    }
    return sum / (double)n;
}

// The signals' nominal powers are those of a block's mean satellite: the others have more or less by what they transmit. Where
// no file names blocks all satellites of a system are one.
static void share_powers(orr_channels *c, orr_warnings *warnings)
{
    for (const char *system = ORR_SYSTEMS; *system != '\0' && c->metadata.n > 0; system++) {
        size_t told = 0, silent = 0;
        for (size_t k = 0; k < c->n_sats; k++) {
            channel_satellite *x = &c->satellite[k];
            if (orr_sat_system(x->sat) != *system || !x->sends) continue;
            const double own_w = transmits_w(c, x->sat);
            *(own_w > 0 ? &told : &silent) += 1;
            if (own_w > 0) x->power_db += 10 * log10(own_w / mean_of_block_w(c, x->sat));
        }
        if (told > 0 && silent > 0)
            orr_warnings_add(
                warnings, NULL, 0, 0,
                "satellites.metadata tells no transmit power of %zu satellites of %c: theirs is nominal",
                silent, *system);
    }
}

// The channel of a satellite whose navigation files tell none.
static bool listed_channel(const orr_channels *c, orr_sat sat, int *channel)
{
    const char *svn = orr_satellite_metadata_svn(&c->metadata, sat, c->span.from);
    const orr_metadata_line *x =
        svn != NULL ? orr_satellite_metadata_at(&c->metadata, ORR_METADATA_CHANNEL, svn, c->span.from) : NULL;
    if (x == NULL || !(fabs(x->value) <= 13)) return false;
    *channel = (int)x->value;
    return true;
}

// Of the scenario's begin, and kept: a carrier does not step when a file's next day begins.
static double phase_bias_m(const orr_channels *c, orr_sat sat, const orr_signal *s)
{
    double delay_s;
    if (c->bias == NULL || orr_signal_phase_of(c->bias, sat, s, c->span.from, &delay_s) != ORR_OK) return 0;
    return ORR_LIGHT_MPS * delay_s;
}

// The channel that the header of a recorded day tells.
static bool recorded_channel(const orr_replay *r, channel_satellite *x)
{
    const int slot = orr_sat_number(x->sat);
    if (r == NULL || r->glonass_channel[slot % 100] == ORR_OBS_NO_CHANNEL) return false;
    x->frequency_channel = r->glonass_channel[slot % 100];
    return true;
}

// Whether a satellite sends a signal: what its block has, or what a recorded day has of it.
static bool sends(const orr_channels *c, const channel_satellite *x, const orr_signal *s, size_t j,
                  const char *block, channel_sent *out)
{
    double power_dbw;
    if ((c->signals >> j & 1) == 0 || s->system != orr_sat_system(x->sat)) return false;
    const orr_replay_track *track = orr_replay_track_of(c->replay, x->sat, j);
    const bool usual = orr_signal_of_block(s, block, &power_dbw);
    if (c->replay != NULL ? track == NULL : !usual) return false;
    *out = (channel_sent){.signal = (uint16_t)j,
                          .carrier_hz = orr_signal_carrier_hz(s, x->frequency_channel),
                          .phase_bias_m = phase_bias_m(c, x->sat, s),
                          .power_dbw = usual ? power_dbw : s->power_dbw,
                          .start = c->replay != NULL ? 0 : (int64_t)(orr_rng_u64(0, x->sat, j) & 8191),
                          .track = track};
    return true;
}

// Tables of the scenario, which may go: horizon and side lobes.
static orr_status keep_tables(const orr_scenario *s, orr_channels *c, orr_diag *diag)
{
    const size_t n = s->mask.horizon.n, m = s->channel.side_lobes.n;
    c->mask = s->mask;
    c->mask.horizon.item = n > 0 ? malloc(n * sizeof *c->mask.horizon.item) : NULL;
    c->options.side_lobes.item = m > 0 ? malloc(m * sizeof *c->options.side_lobes.item) : NULL;
    if ((n > 0 && c->mask.horizon.item == NULL) || (m > 0 && c->options.side_lobes.item == NULL))
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (n > 0) memcpy(c->mask.horizon.item, s->mask.horizon.item, n * sizeof *c->mask.horizon.item);
    if (m > 0)
        memcpy(c->options.side_lobes.item, s->channel.side_lobes.item,
               m * sizeof *c->options.side_lobes.item);
    return ORR_OK;
}

static bool is_orbit_normal(const orr_ephemeris *e, orr_sat sat)
{
    const orr_orbit_node *node;
    orr_sat_state x;
    const char system = orr_sat_system(sat);
    if (system != 'C' && system != 'J') return false;
    const size_t n = orr_ephemeris_nodes(e, sat, &node);
    for (size_t k = 0; k < n; k++)
        if (orr_ephemeris_eval(e, sat, node[k].t, &x) == ORR_OK)
            return orr_orbit_class_of(x.pos_m, orr_velocity_inertial(x.pos_m, x.vel_mps)) == ORR_ORBIT_GEO;
    return false;
}

static orr_status list_satellites(const orr_scenario *s, const orr_nav *nav, orr_channels *c, orr_diag *diag)
{
    const orr_sat *list;
    const orr_scenario_satellites *o = &s->satellites;
    const orr_ephemeris *e = orr_source_orbit_ephemeris(c->orbits);
    c->n_sats = orr_source_orbit_satellites(c->orbits, &list);
    c->satellite = calloc(c->n_sats + 1, sizeof *c->satellite);
    if (c->satellite == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    size_t n_signals;
    const orr_signal *signal = orr_signals(&n_signals);
    for (size_t k = 0; k < c->n_sats; k++) {
        channel_satellite *x = &c->satellite[k];
        bool nominal = false;
        x->sat = list[k];
        x->sends = (!o->has_use || orr_sat_set_has(&o->use, x->sat)) && !orr_sat_set_has(&o->exclude, x->sat);
        if (orr_sat_set_has(&o->unhealthy, x->sat)) x->flags |= ORR_CHANNEL_UNHEALTHY;
        for (size_t j = 0; j < o->power.n; j++)
            if (orr_sat_set_has(&o->power.item[j].sats, x->sat)) x->power_db += o->power.item[j].db;
        x->orbit_normal = is_orbit_normal(e, x->sat);
        x->law =
            orr_attitude_law_of(c->antex != NULL ? orr_antex_find_sat(c->antex, x->sat, c->span.from) : NULL);
        if (orr_sat_system(x->sat) == 'R') {
            const bool known =
                recorded_channel(c->replay, x) ||
                orr_glonass_channel(nav, x->sat, c->span.from, &x->frequency_channel, &nominal);
            if ((!known || nominal) && listed_channel(c, x->sat, &x->frequency_channel))
                nominal = false;
            else if (!known)
                x->sends = false; // nobody knows its carriers
        }
        if (nominal) x->flags |= ORR_CHANNEL_NOMINAL_FREQUENCY;
        const char *svn, *block;
        channels_vehicle(c, x->sat, &svn, &block);
        x->record = orr_replay_sat_of(c->replay, x->sat);
        for (size_t j = 0; x->sends && j < n_signals; j++) {
            assert(x->n_sent < CHANNEL_MAX_SENT);
            if (sends(c, x, &signal[j], j, block, &x->sent[x->n_sent])) x->n_sent++;
        }
        c->max_channels += x->n_sent * (1 + orr_echoes_max(c->echoes));
    }
    if (c->max_channels == 0)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "signals: none of the scenario's satellites sends one of them");
    return ORR_OK;
}

// Signals by text; a scenario was checked when it was read.
static orr_status parse_signals(const orr_scenario *s, orr_channels *c, orr_diag *diag)
{
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < s->signals.n; k++)
        status = orr_signal_parse(s->signals.item[k], &c->signals, diag);
    return status;
}

static orr_status under_troposphere(orr_channels *c, size_t k, orr_diag *diag)
{
    const orr_antenna *a = &c->antenna[k];
    const orr_geodetic place = orr_earth_from_ecef(a->fixed.r_m);
    return orr_troposphere_stand(c->troposphere, k, a->name, a->motion == NULL ? &place : NULL, diag);
}

static orr_status open_antennas(const orr_scenario *s, const orr_source_motion *motion, orr_channels *c,
                                const volatile int *cancel, orr_warnings *warnings, orr_diag *diag)
{
    orr_vec3 station;
    const orr_vec3 *last_resort = orr_source_iono_station(c->iono, &station) ? &station : NULL;
    orr_status status = ORR_OK;
    const size_t n = s->antennas.n > 0 ? s->antennas.n : 1;
    for (size_t k = 0; status == ORR_OK && k < n; k++) {
        status = orr_antenna_open(s, k, motion, last_resort, c->antex, &c->antenna[k], warnings, diag);
        if (status == ORR_OK && c->options.windup)
            status = orr_windup_open(c->orbits, &c->antenna[k], c->antex, c->span, &c->sun, cancel,
                                     &c->windup[k], diag);
        if (status == ORR_OK) c->n_antennas = k + 1;
        if (status == ORR_OK) status = under_troposphere(c, k, diag);
    }
    return status;
}

static bool names_any(const orr_sat_set *set)
{
    uint64_t any = 0;
    for (int k = 0; k < ORR_N_SYSTEMS; k++) any |= set->bit[k][0] | set->bit[k][1];
    return any != 0;
}

// Satellites that a key of `satellites` names, where the orbits have none of them: it has no effect then.
static void warn_of_unknown(const char *key, const orr_sat_set *set, const orr_source_orbit *orbits,
                            orr_warnings *warnings)
{
    const orr_sat *list;
    const size_t n = orr_source_orbit_satellites(orbits, &list);
    for (size_t k = 0; k < n; k++)
        if (orr_sat_set_has(set, list[k])) return;
    if (names_any(set))
        orr_warnings_add(warnings, "", 0, 0, "satellites.%s: the orbits have none of these satellites", key);
}

static void warn_of_satellites(const orr_scenario_satellites *o, const orr_source_orbit *orbits,
                               orr_warnings *warnings)
{
    warn_of_unknown("use", &o->use, orbits, warnings);
    warn_of_unknown("exclude", &o->exclude, orbits, warnings);
    warn_of_unknown("unhealthy", &o->unhealthy, orbits, warnings);
    for (size_t k = 0; k < o->power.n; k++)
        warn_of_unknown("power", &o->power.item[k].sats, orbits, warnings);
}

// A recorded day, with a second beyond its epochs: its clock may be off by so much. False without one.
static bool record_span(const orr_replay *r, orr_span *out)
{
    if (r == NULL || r->n_epochs == 0) return false;
    *out = (orr_span){orr_time_add(r->tag[0], -ORR_NS_PER_S),
                      orr_time_add(r->tag[r->n_epochs - 1], ORR_NS_PER_S)};
    return true;
}

// What the scenario's parts cover, when they have no time in common.
static orr_status nothing_common(const orr_channels *c, const orr_source_motion *motion, orr_diag *diag)
{
    char text[400] = "";
    orr_span span;
    const char *const names[] = {"orbits", "ionosphere", "trajectory", "troposphere", "record"};
    for (int k = 0; k < 5; k++) {
        char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
        if (!(k == 0   ? orr_source_orbit_span(c->orbits, &span)
              : k == 1 ? orr_source_iono_span(c->iono, &span)
              : k == 2 ? orr_source_motion_span(motion, &span)
              : k == 3 ? orr_troposphere_span(c->troposphere, &span)
                       : record_span(c->replay, &span)))
            continue;
        const size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%s%s %s to %s", used > 0 ? ", " : "", names[k],
                 orr_time_text(span.from, from), orr_time_text(span.to, to));
    }
    return orr_diag_set(diag, ORR_E_NODATA, "signals: the scenario's parts have no time in common: %s", text);
}

static orr_status open_faults(const orr_scenario *s, orr_channels *c, orr_diag *diag)
{
    orr_fault_satellite *list = calloc(c->n_sats + 1, sizeof *list);
    if (list == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < c->n_sats; k++)
        list[k] = (orr_fault_satellite){c->satellite[k].sat, c->satellite[k].n_sent > 0};
    const orr_status status = orr_faults_open(s, list, c->n_sats, c->span, &c->faults, diag);
    free(list);
    return status;
}

// The product's instants of a satellite's clock.
static orr_status pin(const orr_channels *c, channel_satellite *x)
{
    const orr_clock_node *list;
    const size_t n = orr_ephemeris_clocks(channels_ephemeris(c), x->sat, &list);
    orr_time *node = calloc(n + 1, sizeof *node);
    if (node == NULL) return ORR_E_MEMORY;
    for (size_t k = 0; k < n; k++) node[k] = list[k].t;
    orr_clock_noise_pin(&x->clock_noise, node, n);
    free(node);
    return ORR_OK;
}

static orr_status open_clocks(const orr_scenario *s, orr_channels *c, orr_diag *diag)
{
    const orr_scenario_clocks *o = &s->clocks;
    const orr_time from = c->span.from - ORR_NS_PER_S; // light is on its way
    size_t spare = ORR_SERIES_NODES;
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < c->n_sats; k++) {
        channel_satellite *x = &c->satellite[k];
        for (size_t j = 0; x->n_sent > 0 && status == ORR_OK && x->clock_noise.n == 0 && j < o->satellites.n;
             j++)
            if (orr_sat_set_has(&o->satellites.item[j].sats, x->sat)) {
                status = orr_clock_noise_make(&o->satellites.item[j], x->sat, from, c->span.to, &spare,
                                              &x->clock_noise);
                if (status == ORR_OK) status = pin(c, x);
            }
    }
    for (size_t k = 0; status == ORR_OK && o->has_receiver && k < c->n_antennas; k++)
        status = orr_clock_noise_make(&o->receiver, ((uint64_t)1 << 32) + k, from, c->span.to, &spare,
                                      &c->oscillator[k]);
    if (status == ORR_E_LIMIT)
        return orr_marks_blame(&s->marks, status, "clocks",
                               "noise of so many clocks over so long a time is more than 20 million seconds: "
                               "give it fewer satellites, or the orbits a shorter time",
                               diag);
    return status == ORR_OK ? ORR_OK : orr_diag_set(diag, status, "out of memory");
}

static orr_status open_ground_of(const orr_scenario *s, orr_channels *c, size_t k, size_t *spare,
                                 orr_diag *diag)
{
    const orr_antenna_state *at = &c->antenna[k].fixed;
    orr_ocean_loading *ocean = NULL;
    orr_status status = ORR_OK;
    if (s->site.ocean_loading != NULL) {
        orr_blq blq;
        status = orr_blq_read(s->site.ocean_loading, c->antenna[k].name, &blq, diag);
        if (status != ORR_OK) return status;
        ocean = malloc(sizeof *ocean);
        if (ocean == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        status = orr_ocean_loading_of(&blq, ocean, diag);
    }
    if (status == ORR_OK) {
        status = orr_site_track_open(&s->site, orr_ephemeris_eop(channels_ephemeris(c)), ocean, at->r_m,
                                     &at->enu, &c->sun, c->span, spare, &c->ground[k]);
        if (status == ORR_E_LIMIT)
            (void)orr_diag_set(diag, status,
                               "site: so many antennas over so long a time: give the orbits a shorter time");
        else if (status != ORR_OK)
            (void)orr_diag_set(diag, status, "out of memory");
    }
    free(ocean);
    return status;
}

static orr_status open_ground(const orr_scenario *s, orr_channels *c, orr_diag *diag)
{
    orr_status status = ORR_OK;
    size_t spare = ORR_SERIES_NODES;
    for (size_t k = 0; status == ORR_OK && k < c->n_antennas; k++)
        if (c->antenna[k].motion == NULL) status = open_ground_of(s, c, k, &spare, diag);
    return status;
}

// Its field's origin is where the first antenna is, or is at the begin.
static orr_status open_turbulence(const orr_scenario *s, orr_channels *c, orr_diag *diag)
{
    orr_antenna_state at;
    if (!s->has_troposphere || !s->troposphere.has_turbulence) return ORR_OK;
    if (orr_antenna_at(&c->antenna[0], c->span.from, &at) != ORR_ANSWER_OK)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "troposphere.turbulence: the first antenna is nowhere at the begin");
    return orr_turbulence_open(&s->troposphere.turbulence, at.r_m, &at.enu, &c->turbulence, diag);
}

static orr_status prepare(const orr_scenario *s, const orr_source_motion *motion, const orr_nav *nav,
                          orr_channels *c, const volatile int *cancel, orr_warnings *warnings, orr_diag *diag)
{
    orr_status status = parse_signals(s, c, diag);
    if (status == ORR_OK) status = keep_tables(s, c, diag);
    if (status == ORR_OK && s->satellites.metadata != NULL)
        status = orr_satellite_metadata_read(s->satellites.metadata, NULL, &c->metadata, warnings, diag);
    if (status == ORR_OK) status = orr_echoes_open(s, c->span, &c->echoes, diag);
    if (status == ORR_OK) status = orr_obstacles_open(s, &c->obstacles, diag);
    if (status == ORR_OK) status = orr_jammers_open(s, &c->jammers, diag);
    if (status == ORR_OK) status = orr_disturbance_open(s, &c->disturbance, diag);
    if (status == ORR_OK) status = orr_scintillation_open(s, &c->scintillation, diag);
    if (status == ORR_OK) status = list_satellites(s, nav, c, diag);
    if (status == ORR_OK) status = open_faults(s, c, diag);
    const orr_sat *list;
    const size_t n_list = orr_source_orbit_satellites(c->orbits, &list);
    if (status == ORR_OK) status = orr_land_mobile_open(s, list, n_list, c->span, &c->land_mobile, diag);
    if (status == ORR_OK) share_powers(c, warnings);
    if (status == ORR_OK)
        status = orr_sun_track_open(c->span.from, c->span.to,
                                    orr_ephemeris_eop(orr_source_orbit_ephemeris(c->orbits)), &c->sun, diag);
    if (status == ORR_OK && s->channel.second_order && s->channel.magnetic != NULL)
        status = orr_magnetic_open(s->channel.magnetic, NULL, &c->magnetic, diag);
    int32_t mjd;
    double fraction;
    orr_time_mjd(c->span.from, ORR_SCALE_GPS, NULL, &mjd, &fraction);
    c->begin_days = mjd - 51544 + fraction;
    if (status == ORR_OK) status = open_antennas(s, motion, c, cancel, warnings, diag);
    if (status == ORR_OK)
        status = orr_terrain_open(s, c->antenna, c->n_antennas, &c->terrain, warnings, diag);
    if (status == ORR_OK) status = open_ground(s, c, diag);
    if (status == ORR_OK) status = open_turbulence(s, c, diag);
    if (status == ORR_OK) status = open_clocks(s, c, diag);
    if (status == ORR_OK) status = spoofed_open(s, c, cancel, diag);
    if (status != ORR_OK) return status;
    c->n_cells = (size_t)((c->span.to - orr_block_cell(c->span.from)) / ORR_BLOCK_CELL_NS) + 1;
    c->cell = calloc(c->n_antennas * c->n_cells, sizeof *c->cell);
    return c->cell != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

// Whether no antenna stands on the ground.
static bool only_moving(const orr_scenario *s)
{
    for (size_t k = 0; k < s->antennas.n; k++)
        if (s->antennas.item[k].position.n > 0) return false;
    return s->antennas.n > 0 || s->receiver.position.n == 0;
}

// What all parts cover; motion: NULL where an antenna stands.
static void find_span(orr_channels *c, const orr_source_motion *motion)
{
    (void)orr_source_orbit_span(c->orbits, &c->span);
    c->span.from = orr_time_add(c->span.from, MARGIN_NS);
    for (int k = 0; k < 4; k++) {
        orr_span i;
        if (!(k == 0   ? orr_source_iono_span(c->iono, &i)
              : k == 1 ? orr_troposphere_span(c->troposphere, &i)
              : k == 2 ? orr_source_motion_span(motion, &i)
                       : record_span(c->replay, &i)))
            continue;
        if (i.from > c->span.from) c->span.from = i.from;
        if (i.to < c->span.to) c->span.to = i.to;
    }
}

orr_status orr_channels_open(const orr_scenario *s, const orr_source_orbit *orbits,
                             const orr_source_iono *iono, const orr_source_motion *motion,
                             const orr_source_tables *tables, const orr_replay *replay,
                             const volatile int *cancel, orr_warnings *warnings, orr_channels **out,
                             orr_diag *diag)
{
    *out = NULL;
    if (s->signals.n == 0) return ORR_OK;
    orr_channels *c = calloc(1, sizeof *c);
    if (c == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    c->orbits = orbits;
    c->iono = iono;
    c->replay = replay;
    c->antex = tables->has_antex ? &tables->antex : NULL;
    c->bias = tables->has_bias ? &tables->bias : NULL;
    c->options = s->channel;
    c->spacing_chips = s->multipath.spacing_chips;
    c->options.antex = c->options.bias = c->options.magnetic = NULL; // of the scenario, which may go
    c->options.side_lobes.item = NULL;                               // until keep_tables
    orr_status status =
        s->has_troposphere ? orr_troposphere_open(&s->troposphere, s->leap, &c->troposphere, diag) : ORR_OK;
    find_span(c, only_moving(s) ? motion : NULL);
    if (status == ORR_OK)
        status = c->span.from < c->span.to ? prepare(s, motion, &tables->nav, c, cancel, warnings, diag)
                                           : nothing_common(c, motion, diag);
    if (status == ORR_OK) warn_of_satellites(&s->satellites, orbits, warnings);
    if (status != ORR_OK)
        orr_channels_close(c);
    else
        *out = c;
    return status;
}

void orr_channels_close(orr_channels *c)
{
    if (c == NULL) return;
    for (size_t k = 0; k < ORR_MAX_ANTENNAS; k++) {
        orr_windup_free(&c->windup[k]);
        orr_series_free(&c->oscillator[k]);
        orr_site_track_free(&c->ground[k]);
    }
    for (size_t k = 0; c->satellite != NULL && k < c->n_sats; k++)
        orr_series_free(&c->satellite[k].clock_noise);
    orr_faults_close(c->faults);
    orr_echoes_close(c->echoes);
    orr_troposphere_close(c->troposphere);
    orr_turbulence_close(c->turbulence);
    orr_obstacles_close(c->obstacles);
    orr_terrain_close(c->terrain);
    orr_jammers_close(c->jammers);
    spoofed_close(c->spoofed);
    orr_land_mobile_close(c->land_mobile);
    orr_disturbance_close(c->disturbance);
    orr_scintillation_close(c->scintillation);
    orr_sun_track_free(&c->sun);
    orr_magnetic_free(c->magnetic);
    free(c->cell);
    free(c->satellite);
    free(c->mask.horizon.item);
    free(c->options.side_lobes.item);
    orr_satellite_metadata_free(&c->metadata);
    free(c);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_channels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "src/service/answers/answers_private.h"

_Static_assert(ORR_CHANNEL_UNHEALTHY == ORR_MSG_CHANNEL_FLAGS_UNHEALTHY &&
                   ORR_CHANNEL_ECLIPSE == ORR_MSG_CHANNEL_FLAGS_ECLIPSE &&
                   ORR_CHANNEL_FAST_TURN == ORR_MSG_CHANNEL_FLAGS_FAST_TURN &&
                   ORR_CHANNEL_NO_ANTENNA == ORR_MSG_CHANNEL_FLAGS_NO_ANTENNA &&
                   ORR_CHANNEL_NO_DELAY == ORR_MSG_CHANNEL_FLAGS_NO_DELAY &&
                   ORR_CHANNEL_ZERO_CLOCK == ORR_MSG_CHANNEL_FLAGS_ZERO_CLOCK &&
                   ORR_CHANNEL_NOMINAL_FREQUENCY == ORR_MSG_CHANNEL_FLAGS_NOMINAL_CHANNEL &&
                   ORR_CHANNEL_FAULT == ORR_MSG_CHANNEL_FLAGS_FAULT,
               "the channels' flags are the wire's");
_Static_assert(ORR_MAX_JAMMERS <= ORR_MSG_MAX_JAMMERS, "all jammers are in CHANNELS");
_Static_assert(ORR_MAX_ANTENNAS <= ORR_MSG_MAX_ANTENNAS, "all antennas are in CAPS");

orr_status orr_answers_channels_open(const orr_channels *c, orr_answers_channels_room *out, orr_diag *diag)
{
    const size_t n = orr_channels_max(c);
    *out = (orr_answers_channels_room){.work = NULL};
    if (c == NULL) return ORR_OK;
    if (n > ORR_MSG_MAX_CHANNELS)
        return orr_diag_set(diag, ORR_E_LIMIT, "an antenna can have %zu channels, a message lists at most %u",
                            n, ORR_MSG_MAX_CHANNELS);
    const orr_status s = orr_channel_work_open(c, &out->work, diag);
    if (s != ORR_OK) return s;
    out->block = calloc(n, sizeof *out->block);
    out->channel = calloc(n, sizeof *out->channel);
    out->terms = calloc(n, sizeof *out->terms);
    if (out->block != NULL && out->channel != NULL && out->terms != NULL) return ORR_OK;
    orr_answers_channels_close(out);
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

void orr_answers_channels_close(orr_answers_channels_room *room)
{
    orr_ahead_close(room->ahead);
    orr_channel_work_close(room->work);
    orr_live_channels_close(room->live);
    free(room->block);
    free(room->channel);
    free(room->terms);
    *room = (orr_answers_channels_room){.work = NULL};
}

static void list_antennas(const orr_channels *c, orr_answers_channels_room *room, orr_msg_caps *caps)
{
    for (size_t k = 0; k < orr_channels_antennas(c); k++) {
        const orr_antenna *a = orr_channels_antenna(c, k);
        orr_msg_antenna *m = &room->antenna[k];
        *m = (orr_msg_antenna){
            .antenna = (uint16_t)k, .name = orr_wire_text(a->name), .kind = orr_wire_text(a->type)};
        const orr_vec3 none = {ORR_NAN, ORR_NAN, ORR_NAN};
        orr_answers_put(m->pos_m, a->motion == NULL ? a->fixed.r_m : none);
    }
    caps->antennas.count = (uint16_t)orr_channels_antennas(c);
    caps->antennas.item = room->antenna;
}

static void list_signals(const orr_channels *c, orr_answers_channels_room *room, orr_msg_caps *caps)
{
    size_t n;
    uint16_t listed = 0;
    const orr_signal *s = orr_signals(&n);
    for (size_t k = 0; k < n; k++)
        if ((orr_channels_signals(c) >> k & 1) != 0)
            room->signal[listed++] = (orr_msg_signal){.signal = (uint16_t)k,
                                                      .system = (uint8_t)s[k].system,
                                                      .name = orr_wire_text(s[k].name),
                                                      .observation = orr_wire_text(s[k].observation),
                                                      .modulation = orr_wire_text(s[k].modulation),
                                                      .components = orr_wire_text(s[k].components),
                                                      .carrier_hz = s[k].carrier_hz,
                                                      .channel_hz = s[k].channel_hz,
                                                      .chips_per_s = s[k].chips_per_s,
                                                      .chips = (uint64_t)s[k].chips};
    caps->signals.count = listed;
    caps->signals.item = room->signal;
}

static void list_transmitters(const orr_channels *c, orr_answers_channels_room *room, orr_msg_caps *caps)
{
    uint16_t n = 0;
    orr_transmitter t;
    for (size_t k = 0; n < ORR_MSG_MAX_SATELLITES && orr_channels_transmitter(c, k, &t); k++)
        room->transmitter[n++] = (orr_msg_transmitter){.sat = orr_answers_sat_id(t.sat),
                                                       .frequency_channel = (int8_t)t.frequency_channel,
                                                       .unhealthy = t.unhealthy,
                                                       .svn = orr_wire_text(t.svn),
                                                       .block = orr_wire_text(t.block)};
    caps->transmitters.count = n;
    caps->transmitters.item = room->transmitter;
}

void orr_answers_channels_caps(const orr_channels *c, orr_answers_channels_room *room, orr_msg_caps *caps)
{
    if (c == NULL) return;
    list_antennas(c, room, caps);
    list_signals(c, room, caps);
    list_transmitters(c, room, caps);
}

// Signals that are wanted, as bits; those that the scenario does not send are the request's fault.
static uint64_t wanted(const orr_channels *c, const orr_msg_poll_channels *poll, bool *known)
{
    uint64_t set = 0;
    *known = true;
    if (poll->signals.count == 0) return orr_channels_signals(c);
    orr_wire_iter it = {0};
    uint16_t k;
    while (orr_msg_u16_next(&poll->signals, &it, &k)) {
        if (k >= 64 || (orr_channels_signals(c) >> k & 1) == 0)
            *known = false;
        else
            set |= UINT64_C(1) << k;
    }
    return set;
}

uint16_t orr_answers_begin_channels(void *user, const orr_msg_poll_channels *poll, orr_server_refusal *why)
{
    const orr_answers *a = user;
    const orr_channels *c = orr_engine_channels(a->engine);
    bool known;
    uint16_t code = orr_answers_check_epochs("POLL_CHANNELS", &poll->epochs, why);
    if (code != 0) return code;
    if (c == NULL)
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED,
                                  "POLL_CHANNELS: this scenario sends no signals (signals)");
    if (poll->antenna >= orr_channels_antennas(c)) {
        snprintf(why->sentence, sizeof why->sentence,
                 "POLL_CHANNELS: there is no antenna %u, the scenario has 0 to %zu", (unsigned)poll->antenna,
                 orr_channels_antennas(c) - 1);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    if (poll->terms > 1)
        return orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                  "POLL_CHANNELS: terms is neither 0 nor 1");
    (void)wanted(c, poll, &known);
    return known ? 0
                 : orr_answers_refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST,
                                      "POLL_CHANNELS: a signal that is not among those of CAPS");
}

static void fill(const orr_block *b, orr_msg_sat_channel *m)
{
    const orr_channel *x = &b->at;
    *m = (orr_msg_sat_channel){.sat = orr_answers_sat_id(x->sat),
                               .signal = x->signal,
                               .flags = x->flags,
                               .az_rad = x->az_rad,
                               .el_rad = x->el_rad,
                               .carrier_hz = x->carrier_hz,
                               .carrier_cycles = b->carrier_cycles,
                               .transmit = x->transmit_ns,
                               .transmit_fraction_ns = x->transmit_fraction_ns,
                               .power_dbw = (float)x->power_dbw,
                               .echo = x->echo};
    memcpy(m->code, b->code, sizeof m->code);
    memcpy(m->carrier, b->carrier, sizeof m->carrier);
}

static void fill_terms(const orr_channel *x, orr_msg_channel_terms *m)
{
    const double *t = x->term_m;
    *m = (orr_msg_channel_terms){.distance_m = t[ORR_TERM_DISTANCE],
                                 .sagnac_m = t[ORR_TERM_SAGNAC],
                                 .shapiro_m = t[ORR_TERM_SHAPIRO],
                                 .satellite_clock_m = t[ORR_TERM_SATELLITE_CLOCK],
                                 .clock_noise_m = t[ORR_TERM_CLOCK_NOISE],
                                 .relativity_m = t[ORR_TERM_RELATIVITY],
                                 .group_delay_m = t[ORR_TERM_GROUP_DELAY],
                                 .satellite_antenna_m = t[ORR_TERM_SATELLITE_ANTENNA],
                                 .receiver_antenna_m = t[ORR_TERM_RECEIVER_ANTENNA],
                                 .solid_tide_m = t[ORR_TERM_SOLID_TIDE],
                                 .pole_tide_m = t[ORR_TERM_POLE_TIDE],
                                 .ocean_loading_m = t[ORR_TERM_OCEAN_LOADING],
                                 .troposphere_hydrostatic_m = t[ORR_TERM_TROPOSPHERE_HYDROSTATIC],
                                 .troposphere_wet_m = t[ORR_TERM_TROPOSPHERE_WET],
                                 .turbulence_m = t[ORR_TERM_TURBULENCE],
                                 .ionosphere_m = t[ORR_TERM_IONOSPHERE],
                                 .emission_m = t[ORR_TERM_EMISSION],
                                 .emission_ionosphere_m = t[ORR_TERM_EMISSION_IONOSPHERE],
                                 .wind_up_m = t[ORR_TERM_WIND_UP],
                                 .ionosphere_second_m = t[ORR_TERM_IONOSPHERE_SECOND],
                                 .phase_bias_m = t[ORR_TERM_PHASE_BIAS],
                                 .receiver_delay_m = t[ORR_TERM_RECEIVER_DELAY],
                                 .residual_code_m = t[ORR_TERM_RESIDUAL_CODE],
                                 .residual_carrier_m = t[ORR_TERM_RESIDUAL_CARRIER],
                                 .disturbance_m = t[ORR_TERM_DISTURBANCE],
                                 .scintillation_m = t[ORR_TERM_SCINTILLATION],
                                 .land_mobile_m = t[ORR_TERM_LAND_MOBILE],
                                 .echo_m = t[ORR_TERM_ECHO],
                                 .echo_phase_m = t[ORR_TERM_ECHO_PHASE],
                                 .spoofer_m = t[ORR_TERM_SPOOFER],
                                 .fault_range_m = t[ORR_TERM_FAULT_RANGE],
                                 .fault_noise_m = t[ORR_TERM_FAULT_NOISE],
                                 .fault_clock_m = t[ORR_TERM_FAULT_CLOCK],
                                 .fault_divergence_m = t[ORR_TERM_FAULT_DIVERGENCE],
                                 .fault_orbit_m = t[ORR_TERM_FAULT_ORBIT]};
}

static size_t fill_jammers(const orr_channels *c, const orr_antenna_state *at, orr_time t,
                           orr_msg_jammer out[ORR_MAX_JAMMERS])
{
    orr_jammer list[ORR_MAX_JAMMERS];
    const size_t n = orr_channels_jammers(c, at, t, list);
    for (size_t k = 0; k < n; k++)
        out[k] = (orr_msg_jammer){.number = list[k].number,
                                  .waveform = orr_wire_text(list[k].waveform),
                                  .az_rad = list[k].az_rad,
                                  .el_rad = list[k].el_rad,
                                  .range_m = list[k].range_m,
                                  .range_rate_mps = list[k].range_rate_mps,
                                  .carrier_hz = list[k].carrier_hz,
                                  .doppler_hz = list[k].doppler_hz,
                                  .power_dbw = (float)list[k].power_dbw};
    return n;
}

orr_status orr_answers_channels_ride(const orr_channels *c, orr_vehicle *vehicle,
                                     orr_answers_channels_room *room, orr_diag *diag)
{
    bool rides = false;
    for (size_t k = 0; k < orr_channels_antennas(c); k++)
        rides = rides || orr_channels_antenna(c, k)->motion != NULL;
    if (!rides)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "live motion needs an antenna that rides on the scenario's body (trajectory, signals)");
    room->vehicle = vehicle;
    return orr_live_channels_open(c, &room->live, diag);
}

void orr_answers_channels_expect(const orr_channels *c, orr_answers_channels_room *room,
                                 const orr_msg_poll_channels *poll)
{
    bool known;
    if (room->ahead != NULL && poll->antenna < orr_channels_antennas(c))
        orr_ahead_expect(room->ahead, poll->antenna, poll->epochs.t, wanted(c, poll, &known));
}

// What one frame is filled from.
typedef struct blocks_there {
    orr_blocks blocks;
    orr_antenna_state at;
    const orr_block *block;
    size_t n;
} blocks_there;

// The block along live motion; false where there is none of this antenna yet.
static bool live_blocks(orr_answers_channels_room *room, size_t antenna, uint64_t signals,
                        orr_msg_channels *m, blocks_there *out)
{
    orr_vehicle_block b;
    if (room->live == NULL || !orr_live_channels_rides(room->live, antenna)) return false;
    const int64_t length_ns = orr_vehicle_length_ns(room->vehicle);
    const orr_time t0 = m->epoch.t - orr_floor_mod(m->epoch.t, length_ns);
    if (!orr_vehicle_block_at(room->vehicle, t0, t0 + length_ns, &b)) return false;
    const orr_live_motion motion = {.t0 = t0,
                                    .t1 = t0 + length_ns,
                                    .begin = b.begin,
                                    .end = b.end,
                                    .arm = !b.antenna,
                                    .breaks = b.state == ORR_MSG_MOTION_STATE_SNAPPED};
    m->epoch.answer =
        (uint8_t)orr_live_blocks(room->live, antenna, &motion, signals, &out->at, room->block, &out->n);
    out->blocks = (orr_blocks){.t0 = t0, .length_ns = length_ns};
    out->block = room->block;
    m->motion = b.state;
    m->motion_age = b.age_ns;
    return true;
}

// The block of the scenario's own motion.
static void own_blocks(const orr_channels *c, orr_answers_channels_room *room, size_t antenna,
                       uint64_t signals, orr_msg_channels *m, blocks_there *out)
{
    out->block = room->block;
    orr_answer answer =
        room->ahead != NULL
            ? orr_ahead_blocks(room->ahead, antenna, m->epoch.t, signals, &out->blocks, &out->block, &out->n)
            : orr_blocks_at(c, antenna, room->work, m->epoch.t, signals, &out->blocks, room->block, &out->n);
    if (answer == ORR_ANSWER_OK)
        answer = orr_antenna_at(orr_channels_antenna(c, antenna), out->blocks.t0, &out->at);
    m->epoch.answer = (uint8_t)answer;
}

uint16_t orr_answers_channels(void *user, const orr_msg_poll_channels *poll, orr_server_part *part,
                              orr_wire_writer *w, orr_server_refusal *why)
{
    (void)why;
    orr_answers *a = user;
    orr_answers_channels_room *room = &a->channels;
    const orr_channels *c = orr_engine_channels(a->engine);
    orr_msg_channels m = {.epoch = orr_answers_epoch(&poll->epochs, part->index), .antenna = poll->antenna};
    bool known;
    blocks_there x = {.n = 0};
    const uint64_t signals = wanted(c, poll, &known);
    if (!live_blocks(room, poll->antenna, signals, &m, &x))
        own_blocks(c, room, poll->antenna, signals, &m, &x);
    if (m.epoch.answer != ORR_MSG_ANSWER_OK) {
        const orr_vec3 none = {ORR_NAN, ORR_NAN, ORR_NAN};
        m.block = ORR_TIME_NONE;
        m.error_m = ORR_NAN;
        orr_answers_put(m.pos_m, none);
        orr_answers_put(m.vel_mps, none);
    } else {
        m.block = x.blocks.t0;
        m.length = x.blocks.length_ns;
        m.error_m = x.blocks.error_m;
        orr_answers_put(m.pos_m, x.at.r_m);
        orr_answers_put(m.vel_mps, x.at.v_mps);
        for (size_t k = 0; k < x.n; k++) {
            fill(&x.block[k], &room->channel[k]);
            if (poll->terms != 0) fill_terms(&x.block[k].at, &room->terms[k]);
        }
        m.channels.count = (uint16_t)x.n;
        m.channels.item = room->channel;
        m.jammers.count = (uint16_t)fill_jammers(c, &x.at, x.blocks.t0, room->jammer);
        m.jammers.item = room->jammer;
        m.terms.count = poll->terms != 0 ? (uint16_t)x.n : 0;
        m.terms.item = room->terms;
    }
    orr_msg_channels_encode(&m, w);
    return 0;
}

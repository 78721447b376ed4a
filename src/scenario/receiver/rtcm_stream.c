// SPDX-License-Identifier: GPL-3.0-or-later
// A base station's RTCM 3: every 10 s what it is, every 30 s and where they change the ephemerides of what it observes, and at every
// epoch the observations. 1005, 1006 and 1033 come from antennas that stand alone.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/constants.h"
#include "orbit/navdata/rtcm_ephemeris.h"
#include "src/scenario/receiver/msm.h"
#include "src/scenario/receiver/port_private.h"
#include "src/scenario/receiver/rtcm_station.h"

#define STATION_NS (10 * ORR_NS_PER_S)
#define EPHEMERIS_NS (30 * ORR_NS_PER_S)
#define NEAR_M 1000 // phases stay as near to their codes; DF401 and DF406 reach 171 m farther

static void send(const orr_rtcm_frame *f, orr_port_bytes *out) { orr_port_bytes_add(out, f->data, f->n); }

static void send_station(const orr_port *p, orr_port_bytes *out)
{
    char systems[ORR_N_SYSTEMS + 1] = "";
    size_t n_systems = 0;
    const uint64_t sent = orr_channels_signals(p->plan.channels);
    for (const char *x = ORR_SYSTEMS; *x != '\0'; x++)
        if ((orr_signals_of(*x) & sent) != 0) systems[n_systems++] = *x;
    uint64_t l1of = 0, l2of = 0;
    (void)orr_signal_parse("R:L1OF", &l1of, NULL); // they are in the table
    (void)orr_signal_parse("R:L2OF", &l2of, NULL);
    const orr_antenna *a = p->antenna;
    const orr_rtcm_station s = {.number = p->plan.station,
                                .position_m = a->fixed.r_m,
                                .antenna = a->type[0] != '\0' ? a->type : "NONE",
                                .receiver = "ORRERY SIMULATED",
                                .version = ORR_VERSION,
                                .systems = systems,
                                .l1of = (sent & l1of) != 0,
                                .l2of = (sent & l2of) != 0};
    orr_rtcm_frame f;
    for (int height = 0; a->motion == NULL && height < 2; height++) {
        orr_rtcm_place(&s, height, &f);
        send(&f, out);
    }
    orr_rtcm_equipment(&s, &f);
    send(&f, out);
    if (!s.l1of && !s.l2of) return;
    orr_rtcm_glonass_biases(&s, &f);
    send(&f, out);
}

// The sets of a satellite that are on the air; all of them, or those that were not at the epoch before.
static orr_status send_ephemerides(const orr_port *p, orr_sat sat, orr_time t, bool all, orr_port_bytes *out,
                                   orr_diag *diag)
{
    const orr_nav_stream *list[ORR_NAVSET_STREAMS];
    const size_t n = orr_navset_streams(p->navset, sat, list);
    uint32_t sent = 0; // messages: one may have several streams
    for (size_t k = 0; k < n; k++) {
        const orr_nav_message m = (orr_nav_message)list[k]->message;
        if (orr_rtcm_number(sat, m) == 0 || (sent >> m & 1u) != 0) continue;
        sent |= UINT32_C(1) << m;
        const orr_navset_item *item = orr_navset_at(p->navset, sat, m, t);
        if (item == NULL || (!all && item->from <= p->before)) continue;
        orr_rtcm_frame f;
        const orr_status s = orr_rtcm_ephemeris(&item->eph, p->plan.leap, &f, diag);
        if (s != ORR_OK) return s;
        send(&f, out);
    }
    return ORR_OK;
}

// How the phase of a signal was shifted at the epoch before; NULL where its arc begins.
static const port_track *track_before(const orr_port *p, const orr_observation *y, size_t *from)
{
    for (; !y->begins && *from < p->n_previous; (*from)++)
        if (p->previous[*from].sat == y->sat && p->previous[*from].signal == y->signal)
            return &p->previous[*from];
    return NULL;
}

// The observation as a cell, its phase range brought near to the code by whole cycles where it is not.
static orr_msm_cell cell_of(orr_port *p, const orr_observation *y, orr_time t, size_t *from)
{
    const double wave_m = ORR_LIGHT_MPS / y->carrier_hz, apart_m = y->phase_cycles * wave_m - y->code_m;
    const port_track *before = track_before(p, y, from);
    port_track *x = &p->track[p->n_tracks++];
    *x = before != NULL ? *before : (port_track){.sat = y->sat, .signal = y->signal, .since = y->since};
    if (fabs(apart_m - x->cycles * wave_m) > NEAR_M) {
        x->cycles = round(apart_m / wave_m);
        x->since = t;
    }
    int channel = 0;
    (void)orr_channels_frequency_channel(p->plan.channels, y->sat, &channel);
    return (orr_msm_cell){.sat = y->sat,
                          .satellite = (uint8_t)orr_msm_satellite(y->sat),
                          .signal = (uint8_t)orr_msm_signal(&p->signal[y->signal]),
                          .channel = (int8_t)channel,
                          .code_m = y->code_m,
                          .phase_m = (y->phase_cycles - x->cycles) * wave_m,
                          .rate_mps = -y->doppler_hz * wave_m,
                          .cn0_dbhz = y->cn0_dbhz,
                          .lock_ms = (t - x->since) / 1000000};
}

// Cells of a satellite are by signal's number in the message.
static void insert(orr_msm_cell *cell, size_t *n, orr_msm_cell x)
{
    size_t k = (*n)++;
    for (; k > 0 && cell[k - 1].sat == x.sat && cell[k - 1].signal > x.signal; k--) cell[k] = cell[k - 1];
    cell[k] = x;
}

static void send_observations(orr_port *p, const orr_observed *o, orr_port_bytes *out)
{
    orr_msm_cell *cell = p->cell;
    size_t n = 0, from = 0;
    port_track *swap = p->previous;
    p->previous = p->track, p->track = swap;
    p->n_previous = p->n_tracks, p->n_tracks = 0;
    for (size_t k = 0; k < o->n; k++) {
        const orr_msm_cell x = cell_of(p, &o->item[k], o->t, &from);
        if (x.satellite > 0 && x.signal > 0) insert(cell, &n, x);
    }
    for (size_t k = 0; k < n;) {
        const char system = orr_sat_system(cell[k].sat);
        size_t end = k;
        while (end < n && orr_sat_system(cell[end].sat) == system) end++;
        while (k < end) {
            const orr_msm_head h = {.msm = p->plan.msm,
                                    .station = p->plan.station,
                                    .epoch = orr_msm_epoch(system, o->t, p->plan.leap),
                                    .more = end < n};
            orr_rtcm_frame f;
            k += orr_msm_encode(&h, cell + k, end - k, &f);
            send(&f, out);
        }
    }
}

// Ephemerides of all satellites of an epoch; all of them, or those that are new.
static orr_status send_all_ephemerides(const orr_port *p, const orr_observed *o, bool all,
                                       orr_port_bytes *out, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t k = 0; p->navset != NULL && s == ORR_OK && k < o->n; k++)
        if (k == 0 || o->item[k].sat != o->item[k - 1].sat)
            s = send_ephemerides(p, o->item[k].sat, o->t, all, out, diag);
    return s;
}

orr_status port_rtcm_greeting(const orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    send_station(p, out);
    return send_all_ephemerides(p, o, true, out, diag);
}

orr_status port_rtcm(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    if (port_due(p, o->t, STATION_NS)) send_station(p, out);
    const orr_status s = send_all_ephemerides(p, o, port_due(p, o->t, EPHEMERIS_NS), out, diag);
    if (s == ORR_OK) send_observations(p, o, out);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What the formats of a port share.
#ifndef ORR_SCENARIO_RECEIVER_PORT_PRIVATE_H
#define ORR_SCENARIO_RECEIVER_PORT_PRIVATE_H

#include "src/scenario/receiver/port.h"

// A phase that was shifted by whole cycles, so that it stays near its code.
typedef struct port_track {
    orr_sat sat;
    uint16_t signal;
    orr_time since; // begin of the arc, or last shift
    double cycles;
} port_track;

// The frame of a stream that was looked at last: most epochs lie in the one of the epoch before.
typedef struct port_frame {
    const orr_nav_stream *stream;
    orr_navframe frame;
} port_frame;

struct orr_port {
    orr_port_plan plan;
    const orr_navset *navset; // of the plan's data; NULL: none
    const orr_signal *signal;
    const orr_antenna *antenna;
    orr_time before; // the epoch before; ORR_TIME_NONE: none
    port_track *track, *previous;
    size_t n_tracks, n_previous;
    void *cell; // [orr_channels_max] of one epoch
    port_frame *frame;
    size_t n_frames;
};

// Whether something that is repeated every so often is due at t: at the first epoch, and where a multiple has passed since the
// last.
static inline bool port_due(const orr_port *p, orr_time t, int64_t every_ns)
{
    return p->before == ORR_TIME_NONE || orr_floor_div(t, every_ns) != orr_floor_div(p->before, every_ns);
}

// Appends an epoch as RTCM.
orr_status port_rtcm(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);
// Appends station messages and all ephemerides of an epoch's satellites.
orr_status port_rtcm_greeting(const orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);
// Appends an epoch as UBX.
orr_status port_ubx(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);
// Appends the subframes that have been received whole since the epoch before, as UBX-RXM-SFRBX.
orr_status port_ubx_subframes(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);
// Appends an epoch as NMEA.
orr_status port_nmea(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);

// Appends a UBX message: head, payload, checksum.
// Given:
//   type     class and number
//   payload  [n]
// Returned:
//   out      the message behind what there was
void port_ubx_message(const uint8_t type[2], const uint8_t *payload, size_t n, orr_port_bytes *out);
// UBX's number of a system (gnssId); -1 where it has none.
int port_ubx_system(char system);
// UBX's number of a satellite (svId).
int port_ubx_satellite(orr_sat sat);
// UBX's number of a signal (sigId) whose observations are told; -1 where it has none.
int port_ubx_signal(const orr_signal *s, orr_sat sat);
// Whether a satellite is one of BeiDou's geostationary ones, which send D2.
bool port_ubx_sends_d2(orr_sat sat);
// UBX's number of a GLONASS channel (freqId); 0 for others.
int port_ubx_channel(const orr_port *p, orr_sat sat);

#endif

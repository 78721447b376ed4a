// SPDX-License-Identifier: GPL-3.0-or-later
// A receiver's port: the bytes that it puts out at each epoch of its observations, as RTCM 3, UBX or NMEA. The same epochs give the
// same bytes, in a file or live.
#ifndef ORR_SCENARIO_RECEIVER_PORT_H
#define ORR_SCENARIO_RECEIVER_PORT_H

#include "src/scenario/observables/observer.h"
#include "src/scenario/receiver/bytes.h"
#include "src/scenario/source/source_navdata.h"

typedef enum orr_port_format {
    ORR_PORT_RTCM, // 1005, 1006, 1033, 1230, ephemerides, MSM4 or MSM7
    ORR_PORT_UBX,  // NAV-PVT, RXM-RAWX, RXM-SFRBX
    ORR_PORT_NMEA, // GGA, RMC, GSA, GSV, GST, ZDA
} orr_port_format;

typedef struct orr_port_plan {
    orr_port_format format;
    const orr_channels *channels; // borrowed
    size_t antenna;
    const orr_source_navdata *navdata; // broadcast data, borrowed; NULL: none are sent
    const orr_leap_table *leap;        // borrowed; NULL: built-in
    int msm;                           // 4 or 7
    unsigned station;                  // number of the base station, 0 to 4095
} orr_port_plan;

typedef struct orr_port orr_port;

// Opens a port. ORR_E_MEMORY.
orr_status orr_port_open(const orr_port_plan *plan, orr_port **out, orr_diag *diag);
void orr_port_close(orr_port *p); // NULL is allowed
// Appends what is put out at an epoch, later than the one before. ORR_E_MEMORY, ORR_E_RANGE (broadcast data that do not fit their
// message; an antenna outside of its motion).
orr_status orr_port_epoch(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);
// Appends what a base station tells now and then, for one who comes between: RTCM's station messages and the ephemerides of what was
// observed; nothing of other formats. Errors as of orr_port_epoch.
// Given:
//   p     the port
//   o     its last epoch
// Returned:
//   out   the messages behind what is there
//   diag  why it failed
orr_status orr_port_greeting(const orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag);
// Whether epochs at such instants can be told by the format: RTCM counts whole milliseconds.
bool orr_port_takes(orr_port_format format, orr_time from, int64_t step_ns);
// Signals of the antenna that the format cannot tell, bits as orr_channels_signals.
uint64_t orr_port_left_out(orr_port_format format, const orr_channels *c);

#endif

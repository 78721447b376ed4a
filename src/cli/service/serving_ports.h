// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `orrery serve` that put out what antennas' receivers do: --rtcm, --ubx, --nmea, --ntrip.
#ifndef ORR_CLI_SERVICE_SERVING_PORTS_H
#define ORR_CLI_SERVICE_SERVING_PORTS_H

#include "src/cli/service/serving.h"

// Opens the ports that are asked for, v->ports; none without such options.
// Errors: ORR_E_ARG (no such antenna, an address or a mountpoint that is none), those of orr_port_server_open, ORR_E_IO and ORR_E_FORMAT of the login's file.
orr_status serving_ports(serving *v, orr_diag *diag);
// Appends where they are to the line that tells that the service is ready.
// Given:
//   v        with its ports
//   text     [size] the line
//   at       its length
// Returns the new length.
size_t serving_ports_say(const serving *v, char *text, size_t size, size_t at);

#endif

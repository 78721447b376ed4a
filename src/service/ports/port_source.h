// SPDX-License-Identifier: GPL-3.0-or-later
// One receiver's port that follows the scenario's clock: which epochs are due, their bytes, and its line of a caster's source table.
#ifndef ORR_SERVICE_PORTS_PORT_SOURCE_H
#define ORR_SERVICE_PORTS_PORT_SOURCE_H

#include "src/service/ports/port_server.h"

typedef struct port_feed {
    orr_port_source source;
    orr_observer *observer;
    orr_port *port;
    orr_time seen;         // last reading of the clock; ORR_TIME_NONE: none
    orr_time next;         // next epoch
    orr_observed observed; // the last; n 0: none
    bool ended;            // no more epochs: beyond the scenario, or a failure
} port_feed;

// Prepares it. ORR_E_ARG where the format cannot tell the epochs, ORR_E_MEMORY.
orr_status port_feed_open(port_feed *f, const orr_port_source *source, orr_diag *diag);
void port_feed_close(port_feed *f);
// Makes the next epoch that is due.
// Given:
//   f        the feed
//   now      the scenario's instant
//   running  whether its clock goes
// Returned:
//   out      its bytes, behind what is there
//   diag     why it failed
// Returns whether one was made; false with f->ended where none will come, the sentence in diag (empty: the scenario's end).
bool port_feed_turn(port_feed *f, orr_time now, bool running, orr_port_bytes *out, orr_diag *diag);
// A caster's source table with the feed's line. The text ends with ENDSOURCETABLE.
// Given:
//   f       the feed
//   login   whether a login is wanted
// Returned:
//   text    [size] the table
// Returns its length.
size_t port_feed_table(const port_feed *f, bool login, char *text, size_t size);

#endif

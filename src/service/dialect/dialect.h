// SPDX-License-Identifier: GPL-3.0-or-later
// Laboratories' own ways of telling a body's motion in datagrams, each a file and a row of one table: bytes in, a sample of MOTION out.
#ifndef ORR_SERVICE_DIALECT_DIALECT_H
#define ORR_SERVICE_DIALECT_DIALECT_H

#include <stdbool.h>
#include <stddef.h>

#include "core/time.h"
#include "inertial/motion/motion.h"
#include "proto/gen/messages.h"

enum { ORR_DIALECT_DATAGRAM = 2048, ORR_DIALECT_REPLY = 256 };

// What a dialect knows beside the datagram, and what it keeps between two of them; zero-initialise.
typedef struct orr_dialect_state {
    orr_time begin; // where the scenario began: what elapsed times count from
    orr_time now;   // the scenario's instant
    bool greeted;
    double travelled_m;
    orr_msg_motion last; // order 0 and t 0 before the first
} orr_dialect_state;

typedef enum orr_dialect_result {
    ORR_DIALECT_NOTHING, // understood, and no motion
    ORR_DIALECT_SAMPLE,
    ORR_DIALECT_WRONG, // not of this dialect
} orr_dialect_result;

typedef struct orr_dialect {
    const char *name, *words; // of an option, and what it is
    // Given: s, data, n. Returned: the sample in *m; a reply of *n_reply bytes (at most ORR_DIALECT_REPLY).
    orr_dialect_result (*take)(orr_dialect_state *s, const uint8_t *data, size_t n, orr_msg_motion *m,
                               uint8_t *reply, size_t *n_reply);
} orr_dialect;

extern const orr_dialect orr_dialect_frames, orr_dialect_skydel, orr_dialect_lines, orr_dialect_nmea;
// By name; NULL: there is none.
const orr_dialect *orr_dialect_of(const char *name);
#define ORR_DIALECTS "orrery|skydel|lines|nmea"

// Attitude and rates of a body whose angles are polynomials of time, into a sample whose position is set.
// Given:
//   angle  yaw, pitch, roll against North, East, Down, and derivatives: rad, rad/s, ... [order][3]
//   order  how many derivatives there are, 0 to 3
// Returned:
//   m      attitude, rates, angular_order. The turn of North and East under a moving body (10^-5 rad/s) is left out.
void orr_dialect_turn(double angle[4][3], int order, orr_msg_motion *m);

#endif

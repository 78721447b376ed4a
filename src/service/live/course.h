// SPDX-License-Identifier: GPL-3.0-or-later
// The motion that is served while samples of the true one come late, early or not at all. Beyond the last sample it is a polynomial of
// the highest order that was sent; when the next comes it goes over to what is known then by a quintic that keeps value, rate and
// acceleration. What has been made is never contradicted: a sample changes nothing before the end of the last block. A function of the
// samples and of how far blocks had been made when each came, so that a recording of these gives the same motion again.
#ifndef ORR_SERVICE_LIVE_COURSE_H
#define ORR_SERVICE_LIVE_COURSE_H

#include <stdbool.h>

#include "core/time.h"
#include "inertial/motion/motion.h"

enum { ORR_COURSE_SAMPLES = 1024, ORR_COURSE_PIECES = 256 };

// A sample of motion. What its orders leave out is zero.
typedef struct orr_course_sample {
    orr_time t;
    orr_time from; // no block before this instant rests on it: the end of what had been made when it came
    int order;     // 0 to 3: what x holds
    int angular_order;
    bool antenna; // of the antennas' point: lever arms are left out
    bool snap;
    bool used;
    orr_vec3 x[4]; // position and derivatives, ecef
    orr_quat q;    // body from ecef
    orr_vec3 w[3]; // rate of the body against ecef and derivatives, body axes
} orr_course_sample;

typedef enum orr_course_state { // as the wire's motion_state
    ORR_COURSE_NONE,
    ORR_COURSE_SYNCHRONOUS,
    ORR_COURSE_INTERPOLATED,
    ORR_COURSE_EXTRAPOLATED,
    ORR_COURSE_JOINING,
    ORR_COURSE_SNAPPED,
} orr_course_state;

// What is served from an instant on: the last sample's polynomial, and two differences that fade.
typedef struct orr_course_piece {
    orr_time from;
    orr_course_sample b;
    orr_time since[2];   // where the differences begin: the sample before, and `from`
    double fade_s[2];    // how long they take; 0: none
    orr_vec3 x[2][3];    // value, rate, acceleration
    orr_vec3 turn[2][3]; // likewise of a rotation vector
    bool snapped;
} orr_course_piece;

typedef struct orr_course {
    double join_s;
    orr_time made; // end of the last block; ORR_TIME_NONE: none
    size_t n, first;
    orr_course_sample sample[ORR_COURSE_SAMPLES]; // ring, by tag
    size_t settled;           // samples from the first on of which it is known whether a block rests on them
    uint64_t used, overtaken; // samples that did, and did not
    size_t n_pieces;
    orr_course_piece piece[ORR_COURSE_PIECES]; // ring; the last is at (n_pieces - 1) % ORR_COURSE_PIECES
} orr_course;

// Without samples.
void orr_course_init(orr_course *k, double join_s);
// One more, whose tag is later than that of the last. The oldest makes room.
void orr_course_add(orr_course *k, const orr_course_sample *s);
// A block is made: fixes what is served until its end.
// Given:
//   k        the course
//   t0, t1   begin and end of the block
// Returned:
//   age_ns   t0 less the tag of the sample that it rests on
// Returns its state; ORR_COURSE_NONE without samples.
orr_course_state orr_course_block(orr_course *k, orr_time t0, orr_time t1, int64_t *age_ns);
// The motion at an instant of a block that was made. False where nothing is known of it any more.
// Given:
//   k        the course
//   t        the instant
//   end      what was served until there, not what begins there: they are the same but where it jumps
// Returned:
//   out      the motion
//   antenna  whether it is that of the antennas' point
bool orr_course_at(const orr_course *k, orr_time t, bool end, orr_motion *out, bool *antenna);
// Samples with tags behind what has been made.
size_t orr_course_waiting(const orr_course *k);

#endif

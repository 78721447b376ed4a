// SPDX-License-Identifier: GPL-3.0-or-later
// Times that are not quite those of a file's epochs: where a centre's program counted time in days of a double, whose last bit
// is 0.63 us of MJD, all positions of an epoch are those of another instant, up to 2 mm along their orbits. No force does that:
// what all satellites of a file show alike at one epoch and not at the next is the epoch's.
#ifndef ORR_ORBIT_DYNAMICS_EPOCH_TIME_H
#define ORR_ORBIT_DYNAMICS_EPOCH_TIME_H

#include "core/time.h"

// What one satellite tells of an epoch.
typedef struct orr_time_reading {
    orr_time t;
    uint16_t source, sat; // indices of the file and of the satellite
    double late_s; // the position is that of so much later: its distance along a smooth orbit over the speed
} orr_time_reading;

// What all of them tell.
typedef struct orr_epoch_time {
    orr_time t;
    uint16_t source;
    double late_s; // the quick part of it: what is slow is the orbits'
} orr_epoch_time;

typedef struct orr_epoch_times {
    size_t n; // ascending in source, then in t; of files whose epochs are off
    orr_epoch_time *item;
} orr_epoch_times;

// Finds the epochs' times of each file from the second differences of what each satellite tells, in which nothing is left of
// an orbit's slow errors: medians over the satellites (eight at least), beside what is known before (0 to 0.25 us). They count
// where the squares of these medians are 2.5 times what the satellites' scatter makes of chance.
//   Given:    reading, n  of all files; sorted on return
//   Returned: out         free with orr_epoch_times_free; empty where no epoch is off
//   Notes:    epochs further apart than an hour tell nothing: orbits have errors of their own over two steps.
// Errors: ORR_E_MEMORY.
orr_status orr_epoch_times_find(orr_time_reading *reading, size_t n, orr_epoch_times *out);
// Seconds that an epoch of a file is late; 0 where it is not in the list.
double orr_epoch_late_s(const orr_epoch_times *times, uint16_t source, orr_time t);
// How far the epochs of one file are off.
typedef struct orr_epoch_spread {
    size_t epochs;        // of which that is so; 0: none
    double rms_s, most_s; // of these
} orr_epoch_spread;
// That of a file, by its index.
orr_epoch_spread orr_epoch_times_spread(const orr_epoch_times *times, uint16_t source);
// Frees the list; a zeroed one is allowed.
void orr_epoch_times_free(orr_epoch_times *times);

#endif

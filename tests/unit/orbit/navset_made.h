// SPDX-License-Identifier: GPL-3.0-or-later
// Products to be turned into navigation messages: three GPS, three GLONASS satellites and one of Galileo, with what may be wrong
// with them. Of tests alone: a failure ends the test.
#ifndef UNIT_ORBIT_NAVSET_MADE_H
#define UNIT_ORBIT_NAVSET_MADE_H

#include "orbit/navdata/navset.h"

enum { N_GPS = 3, N_GLONASS = 3, N_SATS = 7 }; // and a Galileo satellite

typedef struct spoil {
    double push_s;  // a burn of G01 so long after the begin; negative for none
    bool no_clock;  // of G01
    double fast_s;  // by so much the clocks of G01 and R01 are fast,
    double reset_s; // from so long after the begin on
    double after_s; // of G02 nothing is known before, and of G03 nothing after
    double apart_m; // two files, which meet in the middle; of G02 and R02 they are so far apart
} spoil;

extern const spoil nothing;

// An instant in GPS time, or in the scale that the text names.
orr_time when(const char *text);
// A product of so many hours from `from` on: orbits integrated with the project's forces. To be freed.
orr_ephemeris *product(const char *from, double hours, spoil x);
// The sets of a product. To be freed.
orr_navset *build(const orr_ephemeris *e, const orr_navset_options *o);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// A product's passages through the Earth's shadow, whole: from penumbra over umbra to penumbra.
#ifndef ORR_ORBIT_SPACECRAFT_ECLIPSES_H
#define ORR_ORBIT_SPACECRAFT_ECLIPSES_H

#include "orbit/ephemeris/ephemeris.h"

// The Earth's conical shadow without atmosphere, boundaries to 0.1 s. An instant is ORR_TIME_NONE where it
// does not lie inside the satellite's arcs; those of the umbra also where there is none. The Moon's shadow is
// not looked for.
typedef struct orr_eclipse {
    orr_sat sat;
    orr_time penumbra_from, umbra_from, umbra_to, penumbra_to;
    orr_time from, to; // as far as the arcs reach: always known
    bool umbra;        // whether it is seen to go that deep
    bool umbra_known;  // false where that may have been before the arc, or comes after it
} orr_eclipse;

// Those of one satellite, ascending, into out[0..max); how many there are, which may be more than max.
size_t orr_eclipses_of(const orr_ephemeris *e, orr_sat sat, orr_eclipse *out, size_t max);

#endif

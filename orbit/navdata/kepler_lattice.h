// SPDX-License-Identifier: GPL-3.0-or-later
// The fields in which navigation messages send Kepler elements and clocks, message by message: what fits end on and
// encoders write. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_KEPLER_LATTICE_H
#define ORR_ORBIT_NAVDATA_KEPLER_LATTICE_H

#include "core/sat.h"
#include "orbit/navdata/field.h"
#include "orbit/navdata/kepler_model.h"
#include "orbit/navdata/page.h"

typedef struct orr_kepler_lattice {
    size_t n;     // parameters: 15, or 17 with the rates of a and delta n
    bool sends_a; // the first is a (as a difference from a reference), not its root
    orr_navfit_field element
        [ORR_KEPLER_N]; // in the order of ORR_KEPLER_...; e, omega and M0 in the places of EX, EY, LAMBDA
    orr_navfit_field clock[3]; // af0, af1, af2
    orr_navfit_field toe, toc; // seconds of the system's own week
} orr_kepler_lattice;

// A record's elements as the lattice sends them: in its order, with a or its root in the first place.
void orr_kepler_lattice_values(const orr_kepler_lattice *l, const orr_nav_kepler *k,
                               double value[ORR_KEPLER_N]);
// The lattice of a message of a satellite (BeiDou's reference of a is another for MEO); NULL for what sends no elements.
const orr_kepler_lattice *orr_kepler_lattice_of(orr_sat sat, uint8_t message);

// Whether a BeiDou satellite is geostationary or inclined geosynchronous, by the system's table of satellites.
bool orr_kepler_is_high(orr_sat sat);
// Appends n elements of a record, list[i] being of ORR_KEPLER_..., to a page by their fields.
void orr_kepler_put(orr_page *p, const orr_nav_eph *e, const uint8_t *list, size_t n);

#endif

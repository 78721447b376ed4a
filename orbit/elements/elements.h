// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements of the product's satellites as functions of time (Bogdanov 2015, section 6, Figs 8-9).
#ifndef ORR_ORBIT_ELEMENTS_ELEMENTS_H
#define ORR_ORBIT_ELEMENTS_ELEMENTS_H

#include "orbit/ephemeris/ephemeris.h"
#include "orbit/force/kepler.h"
#include "orbit/force/sky.h"

typedef enum orr_elements_frame {
    ORR_ELEMENTS_DATE,  // true equator and equinox of date: what inclination over the Earth means
    ORR_ELEMENTS_J2000, // GCRS
    ORR_ELEMENTS_ECEF,  // axes of ecef, frozen at the instant: longitude of the node over the ground
} orr_elements_frame;

typedef enum orr_elements_method {
    ORR_ELEMENTS_STATE,           // osculating, from (r, v) of the product
    ORR_ELEMENTS_THREE_POSITIONS, // the source's method, see orr_kepler_from_positions for its limits
    ORR_ELEMENTS_MEAN,            // osculating averaged over one revolution centred on the instant
} orr_elements_method;

typedef struct orr_elements_options {
    orr_elements_frame frame;
    orr_elements_method method;
    double spacing_s;          // of the three positions; 0: 300 s
    const orr_eop_series *eop; // NULL: IERS' secular pole
    // Products before and after the one that is asked: a method that needs instants beyond an arc's end takes them from there,
    // where the two meet (to a millimetre and a micrometre a second). NULL: none.
    const orr_ephemeris *before, *after;
} orr_elements_options;

// The Earth's rotation about an instant as a method needs it: the same for every satellite, and the dearer
// part of an answer (12 us for STATE, 36 for THREE_POSITIONS, 200 for MEAN; a satellite takes 0.5, 1 and
// 50 us). Made once, then read by any number of satellites. Contents are elements.c's business.
#define ORR_ELEMENTS_DEGREE 16
typedef struct orr_elements_axes {
    orr_time t;
    orr_elements_options o; // the series of o.eop is borrowed
    orr_mat3 R[3], dR;      // GCRS to ITRS: at t (the middle one) and at t -+ spacing; derivative at t
    orr_mat3 wanted;        // GCRS to the axes of the elements at t
    double series[12][ORR_ELEMENTS_DEGREE + 1]; // of MEAN: rotation and its rate over a revolution
} orr_elements_axes;
// Makes the axes at t; o's series must outlive them.
void orr_elements_axes_at(orr_time t, const orr_elements_options *o, orr_elements_axes *out);

// Elements of a satellite at the axes' instant. Besides the statuses of orr_ephemeris_eval: ORR_E_NODATA also
// where the method needs instants outside the arc and what meets it (three positions: t +- spacing; mean: half a revolution to
// each side), ORR_E_NUMERIC where three positions reach over more than half a revolution.
orr_status orr_elements_of(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *axes,
                           orr_kepler *out);

// State of a satellite at an instant within the arc that holds the axes' instant, or in what meets that arc.
// Given:
//   e, sat  product and satellite
//   axes    with the products before and after among their options
//   t       the instant
// Returned:
//   out     state, ecef
// Errors: those of orr_ephemeris_eval; ORR_E_NODATA beyond the arc and what meets it.
orr_status orr_elements_state_near(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *axes,
                                   orr_time t, orr_sat_state *out);
// Elements in the axes' own of elements in ecef axes that stand still as they are at the axes' instant. ORR_E_NUMERIC where they are no ellipse.
orr_status orr_elements_from_frozen(const orr_elements_axes *axes, const orr_kepler *frozen, orr_kepler *out);

#endif

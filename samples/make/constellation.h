// SPDX-License-Identifier: GPL-3.0-or-later
// The made constellation: which satellites there are, how they are built, where they start and what happens
// to them. Orbits are of the kind their systems fly (interface documents of GPS, GLONASS and Galileo); no
// satellite stands for a real one of the same number.
#ifndef ORR_SAMPLES_CONSTELLATION_H
#define ORR_SAMPLES_CONSTELLATION_H

#include "core/sat.h"
#include "core/time.h"
#include "core/vec.h"

#define ORR_SAMPLE_DAYS 3
#define ORR_SAMPLE_MAX_SATS 96

// A box with a wing: what sunlight presses on. Areas m^2, reflectivities specular (rho) and diffuse (delta).
typedef struct orr_sample_body {
    double mass_kg, wing_m2, x_m2, z_m2;
    double wing_rho, wing_delta, box_rho, box_delta;
    double y_bias_mps2;
} orr_sample_body;

typedef struct orr_sample_sat {
    orr_sat sat;
    double a_m, e, i_rad, raan_rad, argp_rad, m_rad; // osculating, GCRS axes, at the first day's 00:00
    orr_sample_body body;
    double clock_s, drift_sps; // at the first day's 00:00
    double white_fm;           // deviation of frequency over 1 s (Allan)
} orr_sample_sat;

// First instant: 2025-03-20T00:00:00 GPS (the equinox, so that some planes are in their eclipse season).
orr_time orr_sample_start(void);
// Fills sat[ORR_SAMPLE_MAX_SATS]; how many there are. In the order of tables.
size_t orr_sample_constellation(orr_sample_sat *sat);

// What happens. A burn is an impulse in ecef-independent axes: along the velocity, in inertial axes.
typedef enum orr_sample_event_kind {
    ORR_SAMPLE_BURN,    // dv_mps along the velocity at `from`
    ORR_SAMPLE_GAP,     // no positions in [from, to]
    ORR_SAMPLE_NOCLOCK, // no clock in [from, to]
    ORR_SAMPLE_RESET,   // the clock jumps by jump_s at `from`
} orr_sample_event_kind;
typedef struct orr_sample_event {
    orr_sample_event_kind kind;
    orr_sat sat;
    orr_time from, to;
    double value; // m/s or s
} orr_sample_event;
#define ORR_SAMPLE_MAX_EVENTS 16
size_t orr_sample_events(orr_sample_event *event);

#endif

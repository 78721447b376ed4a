// SPDX-License-Identifier: GPL-3.0-or-later
// Scintillation: amplitude and phase of rays that irregularities scatter, and the refractive phase beside it. A pure function of
// scenario and time.
#ifndef ORR_SCENARIO_EFFECT_SCINTILLATION_H
#define ORR_SCENARIO_EFFECT_SCINTILLATION_H

#include "iono/field/pierce.h"
#include "src/config/scenario.h"

typedef struct orr_scintillation orr_scintillation;
// Prepares the section; *out NULL without it. ORR_E_MEMORY. Free with orr_scintillation_close.
orr_status orr_scintillation_open(const orr_scenario *s, orr_scintillation **out, orr_diag *diag);
void orr_scintillation_close(orr_scintillation *x); // NULL is allowed

// Indices of a ray at 1575.42 MHz; they change slowly.
typedef struct orr_scintillation_now {
    double s4, sigma_phi_rad;
} orr_scintillation_now;
// Those of a satellite's ray whose pierce point is p, faded out at the borders of its row; zero where no row names it.
orr_scintillation_now orr_scintillation_at(const orr_scintillation *x, orr_sat sat, orr_time t,
                                           const orr_pierce *p);

enum { ORR_SCINTILLATION_WAVES = 176 };
// The sinusoids whose sums the processes are, and their phasors at a node of the lattice of time.
typedef struct orr_scintillation_waves {
    bool made;
    int64_t second; // of the node; of its tenths those before it, and the nodes since
    double second_turn_re[ORR_SCINTILLATION_WAVES],
        second_turn_im[ORR_SCINTILLATION_WAVES];                                   // what a second turns,
    double second_re[ORR_SCINTILLATION_WAVES], second_im[ORR_SCINTILLATION_WAVES]; // phasors at the second,
    int tenth, node;
    double w_radps[ORR_SCINTILLATION_WAVES], amplitude[ORR_SCINTILLATION_WAVES];
    uint64_t per_s[ORR_SCINTILLATION_WAVES],
        at_zero[ORR_SCINTILLATION_WAVES]; // cycles a second and at time zero, 2^-64, whole ones left out
    double tenth_turn_re[ORR_SCINTILLATION_WAVES],
        tenth_turn_im[ORR_SCINTILLATION_WAVES]; // what a tenth turns,
    double node_turn_re[ORR_SCINTILLATION_WAVES], node_turn_im[ORR_SCINTILLATION_WAVES]; // and a node
    double tenth_re[ORR_SCINTILLATION_WAVES], tenth_im[ORR_SCINTILLATION_WAVES]; // phasors at the tenth,
    double re[ORR_SCINTILLATION_WAVES], im[ORR_SCINTILLATION_WAVES];             // and at the node
} orr_scintillation_waves;

// The processes of a satellite at an antenna, of variance 1, between two nodes of a lattice of time; kept by the caller, all zero at
// first.
typedef struct orr_scintillation_cell {
    bool made;
    orr_time from, to;
    double re[4], im[4], phase[4]; // cubics of the seconds since `from`
    double end[3], end_rate[3];    // where the next one begins
    orr_scintillation_waves waves;
} orr_scintillation_cell;

// What scattering does to a carrier.
typedef struct orr_scintillation_effect {
    double power_db, phase_cycles,
        phase_rate_hz; // phase: by which the carrier is advanced, within half a cycle of the diffractive part
} orr_scintillation_effect;

// Given:
//   x           scintillation
//   sat         satellite
//   antenna     whose ray
//   t           instant
//   indices     orr_scintillation_at
//   carrier_hz  of the signal
//   cell        what was found before, of this satellite and antenna
// Returned:
//   cell        likewise
//   out         amplitude and phase
// Notes: z = zbar + xi, E|z|^2 = 1, xi complex Gaussian with correlation exp(-b t/tau0) (cos b t/tau0 + sin b t/tau0), b = 1.2396,
// and |zbar|^2 by K = sqrt(m^2 - m)/(m - sqrt(m^2 - m)), m = 1/S4^2 (Humphreys et al. 2009, eqs. 6 to 10). xi is a sum of sinusoids
// whose frequencies part that spectrum evenly; the refractive phase one with frequencies evenly by their logarithm.
void orr_scintillation_of(const orr_scintillation *x, orr_sat sat, size_t antenna, orr_time t,
                          orr_scintillation_now indices, double carrier_hz, orr_scintillation_cell *cell,
                          orr_scintillation_effect *out);

// Longest block that follows it where it may be in from <= t < to, ns: a fiftieth of tau0; INT64_MAX where it is not.
int64_t orr_scintillation_block_ns(const orr_scintillation *x, orr_time from, orr_time to);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// One epoch of everything: what a scenario is made of, prepared once, then asked at any instant. Asking is a
// pure function of (engine, question): no allocation, no lock, no I/O; many may ask at once.
#ifndef ORR_SCENARIO_ENGINE_H
#define ORR_SCENARIO_ENGINE_H

#include "core/log.h"
#include "iono/fusion/session.h"
#include "orbit/elements/elements.h"
#include "orbit/navdata/navframe.h"
#include "src/config/scenario.h"
#include "src/make/moving.h"

// Whether there are numbers, and if not, why not. The wire's `answer` has the same values.
typedef enum orr_answer {
    ORR_ANSWER_OK = 0,
    ORR_ANSWER_OUTSIDE_SPAN = 1,  // the instant is outside the span
    ORR_ANSWER_NO_ARC = 2,        // the satellite has no valid arc at the instant
    ORR_ANSWER_NOT_SERVED = 3,    // the satellite is not in the product
    ORR_ANSWER_BELOW_HORIZON = 4, // the receiver does not see the satellite
    ORR_ANSWER_NO_VALUE = 5, // a hole in the ionosphere's maps; an arc too short for the method; a value that
                             // does not fit its field
} orr_answer;

typedef struct orr_engine orr_engine;

// Prepares a scenario: loads the product, or reads and smooths the SP3 files, and fits broadcast data to them
// (seconds; `cancel`, which may be NULL, ends that with ORR_E_INTERRUPTED). Errors: those of the readers,
// with their file and line. Free with orr_engine_close.
orr_status orr_engine_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_engine **out, orr_diag *diag);
// Of an ephemeris alone, which it takes over: states and elements.
orr_status orr_engine_from_ephemeris(orr_ephemeris *e, const char *title, orr_engine **out, orr_diag *diag);
void orr_engine_close(orr_engine *e);

const char *orr_engine_title(const orr_engine *e);
const char *orr_engine_frame(const orr_engine *e);                       // of positions, e.g. "IGS20"
void orr_engine_span(const orr_engine *e, orr_time *from, orr_time *to); // both inclusive
size_t orr_engine_satellites(const orr_engine *e, const orr_sat **list); // ascending

// States of n satellites at t into state[0..n) and answer[0..n); sats NULL: of all (n = their number, in
// their order). ORR_ANSWER_OK, or ORR_ANSWER_OUTSIDE_SPAN (then nothing is written). Where answer[i] is not
// OK only state[i].sat is set.
orr_answer orr_engine_states(const orr_engine *e, orr_time t, const orr_sat *sats, size_t n,
                             orr_sat_state *state, orr_answer *answer);

// Kepler elements of n satellites at t into out[0..n), their states' flags into flags[0..n), and
// answer[0..n); sats NULL: of all. ORR_ANSWER_OK, or ORR_ANSWER_OUTSIDE_SPAN (then nothing is written). Where
// answer[i] is not OK (NO_VALUE: the method needs instants outside the arc) out[i] and flags[i] are not set.
orr_answer orr_engine_elements(const orr_engine *e, orr_time t, orr_elements_frame frame,
                               orr_elements_method method, const orr_sat *sats, size_t n, orr_kepler *out,
                               uint32_t *flags, orr_answer *answer);

// NULL where the engine has broadcast data, else a sentence that tells why it has none.
const char *orr_engine_no_navdata(const orr_engine *e);
// What satellites send at t: their sets on the air into set[0..n) (borrowed), the frames of their messages
// that hold t into frame[0..n), and answer[0..n); sats NULL: of all. ORR_ANSWER_OK, or
// ORR_ANSWER_OUTSIDE_SPAN (then nothing is written). Where answer[i] is not OK set[i] is NULL and frame[i]
// not set: NOT_SERVED for systems without such data and satellites that could not be fitted, NO_ARC where the
// satellite sends nothing then.
orr_answer orr_engine_navdata(const orr_engine *e, orr_time t, const orr_sat *sats, size_t n,
                              const orr_navset_item **set, orr_navframe *frame, orr_answer *answer);

// Whether the scenario has an ionosphere; and where its own receiver (ecef) is at t: receiver.position; else
// the point of a unit of the trajectory, to the bit that of orr_engine_truth; else the session's station.
// ORR_ANSWER_OK, ORR_ANSWER_OUTSIDE_SPAN of the trajectory, or ORR_ANSWER_NOT_SERVED where there is none of
// them; without OK nothing is written.
bool orr_engine_has_ionosphere(const orr_engine *e);
orr_answer orr_engine_receiver(const orr_engine *e, orr_time t, orr_vec3 *receiver_m);
// Ionospheric delays from a receiver to n satellites at t into delay[0..n) and answer[0..n), n <=
// ORR_SESSION_MAX_SATS; sats NULL: of all. ORR_ANSWER_OK, or ORR_ANSWER_OUTSIDE_SPAN where orbits or
// ionosphere do not cover t (then nothing is written). Where answer[i] is not OK only delay[i].sat is set,
// and az and el of the pierce point for NO_VALUE.
orr_answer orr_engine_delays(const orr_engine *e, orr_time t, orr_vec3 receiver_m, const orr_sat *sats,
                             size_t n, orr_realisation *delay, orr_answer *answer);

// Inertial units of the scenario's trajectory: 0 without one, else 1 (its own point) and those named.
size_t orr_engine_units(const orr_engine *e);
// The scenario's rate of readings (Hz), and whether they are physical (approach 2): only such exist over any
// interval.
double orr_engine_imu_rate(const orr_engine *e);
bool orr_engine_imu_physical(const orr_engine *e);
// Increments of unit k < orr_engine_units over [t0, t1], t0 < t1: ORR_ANSWER_OK, or ORR_ANSWER_OUTSIDE_SPAN
// of the trajectory.
orr_answer orr_engine_imu(const orr_engine *e, size_t unit, orr_time t0, orr_time t1, orr_vec3 *dtheta_rad,
                          orr_vec3 *dv_mps);

// True motion and gravity terms of a unit.
typedef struct orr_truth {
    orr_motion motion;
    orr_angles angles;
    orr_vec3 rate_radps, force_mps2; // absolute rate and specific force, body axes
    double disturbance_mgal, eotvos_mgal, vertical_mps2;
} orr_truth;
orr_answer orr_engine_truth(const orr_engine *e, size_t unit, orr_time t, orr_truth *out);

#endif

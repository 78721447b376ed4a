// SPDX-License-Identifier: GPL-3.0-or-later
// One epoch of everything: what a scenario is made of, prepared once, then asked at any instant. Asking is a
// pure function of (engine, question): no allocation, no lock, no I/O; many may ask at once.
#ifndef ORR_SCENARIO_ENGINE_ENGINE_H
#define ORR_SCENARIO_ENGINE_ENGINE_H

#include "src/scenario/channel/channel.h"
#include "src/scenario/replay/replay_make.h"
#include "src/scenario/source/source_iono.h"
#include "src/scenario/source/source_motion.h"
#include "src/scenario/source/source_navdata.h"
#include "src/scenario/source/source_orbit.h"

typedef struct orr_engine orr_engine;

// Prepares a scenario: loads the product, or reads and smooths the SP3 files, and fits broadcast data to them
// (seconds). A scenario may have satellites, a trajectory, or both.
// Given:
//   s         the scenario; its table of leap seconds has to outlive the engine
//   log       progress; may be NULL
//   cancel    ends the preparation with ORR_E_INTERRUPTED once it is not 0; may be NULL
// Returned:
//   warnings  of readers and makers; may be NULL
//   out       the engine; free with orr_engine_close
//   diag      why it failed, with file and line; may be NULL
// Errors: those of the readers and makers; ORR_E_NODATA (neither satellites nor a trajectory).
orr_status orr_engine_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_engine **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_engine_close(orr_engine *e);

// The scenario's title, or the name of what it is made of; "" where there is none.
const char *orr_engine_title(const orr_engine *e);
// Of positions: the orbits', e.g. "IGS20"; without satellites "WGS84", which places of a trajectory refer to.
const char *orr_engine_frame(const orr_engine *e);
// The run's table of leap seconds; never NULL.
const orr_leap_table *orr_engine_leap(const orr_engine *e);
// The parts that an engine may have, each with the time that it covers.
typedef enum orr_engine_part {
    ORR_PART_ORBITS,     // states, elements
    ORR_PART_NAVDATA,    // broadcast data
    ORR_PART_IONOSPHERE, // of its field; delays need the orbits as well
    ORR_PART_MOTION,     // truth and readings
    ORR_PART_CHANNELS,   // what antennas receive
} orr_engine_part;
// False, and nothing written, where the engine has no such part.
bool orr_engine_part_span(const orr_engine *e, orr_engine_part part, orr_span *out);
// Of the orbits, or of the trajectory where there are no satellites; both ends belong to it.
void orr_engine_span(const orr_engine *e, orr_time *from, orr_time *to);
// Ascending; none where the scenario has a trajectory alone.
size_t orr_engine_satellites(const orr_engine *e, const orr_sat **list);

// States of satellites at an instant.
// Given:
//   e       the engine
//   slice   room for all of them at once, of orr_engine_ephemeris; NULL: one by one, the same bits
//   t       the instant
//   sats    [n] which; NULL: all, in the order of orr_engine_satellites
//   n       how many; with NULL their number
// Returned:
//   state   [n] position, velocity, clock; where answer[i] is not OK only state[i].sat is set
//   answer  [n] of each satellite
// Returns ORR_ANSWER_OK, ORR_ANSWER_OUTSIDE_SPAN, or ORR_ANSWER_NOT_SERVED of an engine without satellites; then
// nothing is written.
orr_answer orr_engine_states(const orr_engine *e, orr_ephemeris_slice *slice, orr_time t, const orr_sat *sats,
                             size_t n, orr_sat_state *state, orr_answer *answer);

// The axes of elements at an instant, for any number of satellites (those of MEAN take 0.4 ms).
// Given:
//   e       the engine
//   t       the instant
//   frame   the axes
//   method  how elements are made
// Returned:
//   out     the axes; written with ORR_ANSWER_OK alone
// Returns an answer as orr_engine_states does.
orr_answer orr_engine_axes(const orr_engine *e, orr_time t, orr_elements_frame frame,
                           orr_elements_method method, orr_elements_axes *out);
// Kepler elements of satellites at the axes' instant.
// Given:
//   e       the engine
//   axes    by orr_engine_axes
//   sats    [n] which; NULL: all
//   n       how many
// Returned:
//   out     [n] elements
//   flags   [n] flags of the states
//   answer  [n] of each satellite. Where it is not OK (NO_VALUE: the method needs instants outside the arc) out[i]
//           and flags[i] are not set
// Returns ORR_ANSWER_OK or ORR_ANSWER_NOT_SERVED.
orr_answer orr_engine_elements(const orr_engine *e, const orr_elements_axes *axes, const orr_sat *sats,
                               size_t n, orr_kepler *out, uint32_t *flags, orr_answer *answer);

// NULL where the engine has broadcast data, else a sentence that tells why it has none.
const char *orr_engine_no_navdata(const orr_engine *e);
// Whether they describe the antennas' phase centres (navdata.antex); else the centres of mass, as states do.
bool orr_engine_navdata_phase_centres(const orr_engine *e);
// The streams of a satellite (its messages, signal by signal) that are asked for.
// Given:
//   e         the engine
//   sat       satellite
//   messages  bits 1 << orr_nav_message; 0: its first alone
// Returned:
//   list      the streams; their number is returned, 0 where the satellite sends none of them
size_t orr_engine_navdata_streams(const orr_engine *e, orr_sat sat, uint32_t messages,
                                  const orr_nav_stream *list[ORR_NAVSET_STREAMS]);
// What a satellite sends at an instant.
// Given:
//   e       the engine
//   t       the instant
//   sat     satellite
//   stream  one of orr_engine_navdata_streams; NULL: it has none
//   coded   symbols as they are modulated, not bits
// Returned:
//   set     the set on the air, borrowed; NULL unless the answer is OK
//   frame   the frame of its message that holds t; not set unless the answer is OK
// Returns OUTSIDE_SPAN, NOT_SERVED for satellites without such data or that could not be fitted, NO_ARC where the satellite
// sends nothing then, NO_VALUE where a value does not fit its field.
orr_answer orr_engine_navdata(const orr_engine *e, orr_time t, orr_sat sat, const orr_nav_stream *stream,
                              bool coded, const orr_navset_item **set, orr_navframe *frame);

// Whether the scenario has an ionosphere.
bool orr_engine_has_ionosphere(const orr_engine *e);

// The channels of the scenario's antennas; NULL where no signals are sent.
const orr_channels *orr_engine_channels(const orr_engine *e);
// The recorded day that the channels reproduce; NULL where there is none. *report (may be NULL) is what was estimated of it.
const orr_replay *orr_engine_replay(const orr_engine *e, const orr_replay_report **report);
// The sources themselves, for who writes files of the whole scenario; NULL where there is none.
const orr_ephemeris *orr_engine_ephemeris(const orr_engine *e);
// The broadcast data likewise.
const orr_navset *orr_engine_navset(const orr_engine *e);
// The source of what satellites send, wrong bits included, likewise.
const orr_source_navdata *orr_engine_source_navdata(const orr_engine *e);
// The prepared motion likewise.
const orr_moving *orr_engine_moving(const orr_engine *e);

// The scenario's own receiver: receiver.position; else the point of a unit of the trajectory, to the bit that
// of orr_engine_truth; else the station of ionosphere.session.
typedef enum orr_receiver_kind {
    ORR_RECEIVER_NONE,
    ORR_RECEIVER_PLACE,
    ORR_RECEIVER_UNIT,
    ORR_RECEIVER_STATION
} orr_receiver_kind;
// *unit (may be NULL) is set for ORR_RECEIVER_UNIT.
orr_receiver_kind orr_engine_receiver_kind(const orr_engine *e, size_t *unit);
// Where it is at t (ecef): ORR_ANSWER_OK, ORR_ANSWER_OUTSIDE_SPAN of the trajectory, or ORR_ANSWER_NOT_SERVED
// where there is none; without OK nothing is written.
orr_answer orr_engine_receiver(const orr_engine *e, orr_time t, orr_vec3 *receiver_m);
// Ionospheric delays from a receiver to satellites.
// Given:
//   e           the engine
//   t           the instant
//   receiver_m  place of the receiver (ecef)
//   sats        [n] which; NULL: all
//   n           at most ORR_SESSION_MAX_SATS
// Returned:
//   delay       [n] delays. Where answer[i] is not OK only delay[i].sat is set, and az and el of the pierce point for
//               NO_VALUE
//   answer      [n] of each satellite
// Returns ORR_ANSWER_OK, ORR_ANSWER_OUTSIDE_SPAN where orbits or ionosphere do not cover t, or ORR_ANSWER_NOT_SERVED
// without orbits or ionosphere.
orr_answer orr_engine_delays(const orr_engine *e, orr_time t, orr_vec3 receiver_m, const orr_sat *sats,
                             size_t n, orr_realisation *delay, orr_answer *answer);

// Inertial units of the scenario's trajectory: 0 without one, else 1 (its own point) and those named.
size_t orr_engine_units(const orr_engine *e);
// How unit k is mounted; false where there is no such unit.
bool orr_engine_unit(const orr_engine *e, size_t unit, orr_unit *out);
// The scenario's rate of readings, Hz; 0 without a trajectory.
double orr_engine_imu_rate(const orr_engine *e);
// Whether readings are physical (approach 2): only such exist over any interval.
bool orr_engine_imu_physical(const orr_engine *e);
// Whether they have the errors of the scenario's sensors (imu.errors).
bool orr_engine_imu_measured(const orr_engine *e);
// Begins increments of a unit over an interval, which orr_engine_imu_add finishes.
// Given:
//   e     the engine
//   unit  which, below orr_engine_units
//   t0    begin of the interval
//   t1    its end, behind t0
// Returned:
//   sum   the increments so far: nothing. Set with ORR_ANSWER_OK alone
// Returns ORR_ANSWER_OK, ORR_ANSWER_OUTSIDE_SPAN of the trajectory, or ORR_ANSWER_NOT_SERVED: no such unit, or readings
// that are not physical.
orr_answer orr_engine_imu_begin(const orr_engine *e, size_t unit, orr_time t0, orr_time t1,
                                orr_sensors_sum *sum);
// Adds at most so many pieces to the increments (orr_sensors_sum); true when they are finished.
bool orr_engine_imu_add(const orr_engine *e, size_t unit, orr_sensors_sum *sum, long pieces);
// True motion and gravity of a unit at an instant: ORR_ANSWER_OK, ORR_ANSWER_OUTSIDE_SPAN, or ORR_ANSWER_NOT_SERVED
// where there is no such unit; without OK nothing is written.
orr_answer orr_engine_truth(const orr_engine *e, size_t unit, orr_time t, orr_truth *out);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The broadcast data of a whole orbit product: for every satellite and message the fitted sets, when each of them is
// transmitted, with which issue number and health; almanacs; and what the systems send beside. Built once, then asked at any
// instant as a pure function.
#ifndef ORR_ORBIT_NAVDATA_NAVSET_H
#define ORR_ORBIT_NAVDATA_NAVSET_H

#include "ingest/rinex/rinex_nav.h"
#include "ingest/tables/antex.h"
#include "ingest/tables/bias.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/navdata/nav_stream.h"
#include "orbit/navdata/navfit.h"

// What a satellite sends wrong from <= t < to, on purpose.
typedef enum orr_navset_fault_kind {
    ORR_NAVSET_FAULT_UNHEALTHY, // its sets mark it as not to be used
    ORR_NAVSET_FAULT_ORBIT,     // its sets tell of a displaced orbit
    ORR_NAVSET_FAULT_STALE,     // the set on the air at the begin is sent throughout
} orr_navset_fault_kind;
typedef struct orr_navset_fault {
    orr_navset_fault_kind kind;
    orr_sat_set sats;
    orr_time from, to;
    orr_vec3 displaced_m; // radial, along-track, cross-track
} orr_navset_fault;

typedef struct orr_navset_options {
    double window_s;         // LNAV of GPS, I/NAV and F/NAV: 7200 or 14400
    uint32_t messages;       // bits 1 << orr_nav_message; 0: all that orr_nav_streams tells
    const orr_sat_set *sats; // NULL: all that send one of them
    const orr_sat_set
        *unhealthy;         // satellites whose sets are sent as unhealthy, whatever they are like; NULL: none
    const orr_antex *antex; // antennas' phase centres; NULL: the centre of mass, as STATES gives it
    const orr_bias_set *bias; // group delays and GLONASS' L1 clocks; NULL: all zero
    const orr_nav *nav;       // GLONASS channels, Klobuchar; NULL: channels of the nominal plan, no Klobuchar
    const orr_leap_table
        *leap; // that UTC and GLONASS' calendar go by; has to outlive the set; NULL: built-in
    const orr_navset_fault *fault; // [n_faults]
    size_t n_faults;
    bool zero_clocks;           // satellites without a clock get one of zero; otherwise they are left out
    int jobs;                   // threads
    const volatile int *cancel; // may be NULL
} orr_navset_options;
orr_navset_options orr_navset_defaults(void); // 2 h, all satellites, nothing else, one thread

enum {                              // orr_navset_item.notes
    ORR_NAVSET_MANOEUVRE = 1u << 0, // a manoeuvre within the window, or files that do not meet: unhealthy
    ORR_NAVSET_SHIFTED =
        1u << 1, // the orbit begins or ends within the window: fitted to the nearest full one
    ORR_NAVSET_NO_CLOCK = 1u << 2,   // the product has no clock: zero is sent
    ORR_NAVSET_NO_ANTENNA = 1u << 3, // ANTEX was given, but knows no antenna: centre of mass
    ORR_NAVSET_NO_DELAY = 1u << 4,   // biases were given, but not this satellite's: TGD or delta tau of zero
    ORR_NAVSET_NOMINAL_CHANNEL = 1u << 5, // GLONASS: the channel is the nominal one of the slot
    ORR_NAVSET_CLOCK_JUMP = 1u << 6, // the clock jumps, or is off a line by more than 10 ns RMS: unhealthy
    ORR_NAVSET_FAULTY = 1u << 7,     // a fault of the options changes it, or how long it is sent
};

// One set of immediate data.
typedef struct orr_navset_item {
    orr_nav_eph eph;   // on the message's lattice
    orr_time from, to; // transmitted at from <= t < to
    orr_navfit_report report;
    double clock_rms_s; // NAN without clock
    uint32_t notes;
} orr_navset_item;

typedef struct orr_navset orr_navset;

// Fits the broadcast data of a whole orbit product.
// Given:
//   e         orbit product; not needed afterwards
//   o         options
// Returned:
//   out       the broadcast data; free with orr_navset_free
//   warnings  satellites and windows that were left out, and why; may be NULL
//   diag      why it failed; may be NULL
// Errors: ORR_E_ARG (window), ORR_E_NODATA (nothing could be fitted), ORR_E_LIMIT (a product longer than the 1024 weeks that
// LNAV counts), ORR_E_INTERRUPTED, ORR_E_MEMORY.
// Notes: when sets of which message are transmitted, and which window each of them describes, stands in
// navset_schedule.c. Satellites with e above 0.1 (E14, E18) get windows as long as a set is on the air.
orr_status orr_navset_build(const orr_ephemeris *e, const orr_navset_options *o, orr_navset **out,
                            orr_warnings *warnings, orr_diag *diag);
// Frees a set; NULL is none.
void orr_navset_free(orr_navset *set);

size_t orr_navset_satellites(const orr_navset *set, const orr_sat **list); // ascending
#define ORR_NAVSET_STREAMS 8                                               // of one satellite, at most
// The streams of a satellite that there are sets for, in the order of orr_nav_streams; the first is its legacy message.
size_t orr_navset_streams(const orr_navset *set, orr_sat sat, const orr_nav_stream *list[ORR_NAVSET_STREAMS]);
// The sets of a satellite's message, ascending in from. ORR_NAV_NONE: of its first.
size_t orr_navset_items(const orr_navset *set, orr_sat sat, orr_nav_message message,
                        const orr_navset_item **list);
// The set of it on the air at t; NULL if there is none.
const orr_navset_item *orr_navset_at(const orr_navset *set, orr_sat sat, orr_nav_message message, orr_time t);
// By how much position (m, 3-D) and clock (s, with periodic relativity) step where a receiver goes over from one set of a
// satellite to the next, at next->from: the sets' own errors, for served ranges do not step. False, and nothing returned, where one
// is unhealthy or the other does not follow at once.
bool orr_navset_step(const orr_navset_item *last, const orr_navset_item *next, double *step_m,
                     double *clock_step_s);

// All sets as a navigation file that orr_nav_write can write: satellite by satellite, with the ionosphere's coefficients, UTC
// and the leap seconds. program, run_by and date are the caller's to fill. Free with orr_nav_free.
orr_status orr_navset_records(const orr_navset *set, orr_nav *out, orr_diag *diag);

#endif

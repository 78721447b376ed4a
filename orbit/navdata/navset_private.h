// SPDX-License-Identifier: GPL-3.0-or-later
// The broadcast set among its parts. Private to the orbit room.
#ifndef ORR_ORBIT_NAVDATA_NAVSET_PRIVATE_H
#define ORR_ORBIT_NAVDATA_NAVSET_PRIVATE_H

#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/glonass_bits.h"
#include "orbit/navdata/glonass_channel.h"
#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/modern_blocks.h"
#include "orbit/navdata/navset.h"

// When a set is transmitted, what it refers to, and which stretch of the orbit it is to describe.
typedef struct navset_slot {
    orr_time from, to;  // on the air at from <= t < to
    orr_time reference; // toe, tb
    orr_time window_from, window_to;
    int64_t number;       // of the slot since 1980
    bool faulty;          // by a fault: its times, or
    bool unhealthy;       // that,
    orr_vec3 displaced_m; // or this
} navset_slot;

typedef struct navset_schedule {
    size_t n;
    navset_slot *slot; // ascending
} navset_schedule;

// The slots of a satellite's message that touch [from, to]; with `brief` windows as long as a set is on the air. Free the slots
// with free().
orr_status navset_schedule_of(orr_sat sat, orr_nav_message message, orr_time from, orr_time to,
                              const orr_navset_options *o, bool brief, navset_schedule *out);

// Applies the faults of a satellite: slots are cut where sets change, drawn on where an old one stays. A changed slot has an issue
// number of its own, so that receivers take it. ORR_E_MEMORY.
orr_status navset_fault_slots(orr_sat sat, const orr_navset_options *o, navset_schedule *schedule);

// The sets of one message.
typedef struct navset_series {
    uint8_t message;
    size_t n;
    orr_navset_item *item;
    size_t no_clock, not_fitted; // slots left out
    char why[160];               // the last slot that was not fitted
} navset_series;

// What became of one satellite.
#define NAVSET_SERIES 6
typedef struct navset_satellite {
    orr_sat sat;
    size_t n;
    navset_series series[NAVSET_SERIES]; // with sets or without
    orr_status status;
} navset_satellite;

// Fits every slot of every message in which the satellite has an orbit.
void navset_fit_satellite(const orr_ephemeris *e, const orr_navset_options *o, navset_satellite *out);

// Group delays of a set from biases, on its message's lattice, into item->eph and its notes.
// Given:
//   bias     biases; NULL: all delays are zero
//   item     sat, message and toe are there
// Returned: what has to be added to the product's clock for the message's, s.
double navset_delays(const orr_bias_set *bias, orr_navset_item *item);

// Almanacs of one system on one day of GPS time.
typedef struct navset_almanacs {
    bool fitted; // or borrowed from another day
    orr_time toa;
    uint32_t toa_s; // of the system's own week, and that
    int32_t week;
    bool has[64];
    orr_almanac sat[64];
    uint8_t health[64]; // of the sets that are sent on that day: 0 good, 1 out, 2 not there
} navset_almanacs;
enum { NAVSET_GOOD, NAVSET_OUT, NAVSET_NOT_THERE };

// Almanacs of one day of GPS time: what is sent on it.
typedef struct navset_day {
    orr_time from, to, noon;
    orr_modern_rotation rotation;
    navset_almanacs gps, galileo, beidou, qzss, navic;
    uint8_t gps_configuration[32];
    bool fitted_glonass;  // or borrowed
    orr_time glonass_day; // any instant of the almanac's day in Moscow
    bool has_glonass[24];
    orr_glonass_almanac glonass[24];
} navset_day;

// Fits the almanacs of every day of the product.
orr_status navset_fit_days(const orr_ephemeris *e, const orr_navset_options *o, orr_navset *set);
const navset_day *navset_day_at(const orr_navset *set, orr_time t); // the nearest

struct orr_navset {
    size_t n_sats;
    orr_sat *sat;           // those with sets, ascending
    navset_satellite *sets; // in that order
    const orr_leap_table *leap;
    orr_time from, to;
    size_t n_days;
    navset_day *day;
    bool has_klobuchar;
    double alpha[4], beta[4];
    double beidou_alpha[4], beidou_beta[4]; // of BeiDou's own Klobuchar model; zeros: not known
    double nequick[3];                      // a_i0..2 of NeQuick-G; zeros: not known
    double bdgim[9];                        // alpha_1..9 of BDGIM, TECU; zeros: not known
};

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The broadcast set among its parts. Private to the orbit room.
#ifndef ORR_ORBIT_NAVDATA_NAVSET_PRIVATE_H
#define ORR_ORBIT_NAVDATA_NAVSET_PRIVATE_H

#include "orbit/navdata/glonass_bits.h"
#include "orbit/navdata/glonass_channel.h"
#include "orbit/navdata/lnav_bits.h"
#include "orbit/navdata/navset.h"

// When a set is transmitted, what it refers to, and which stretch of the orbit it is to describe.
typedef struct navset_slot {
    orr_time from, to;  // on the air at from <= t < to
    orr_time reference; // toe, tb
    orr_time window_from, window_to;
    int32_t iodc; // ORR_NAV_NO_IOD for GLONASS
} navset_slot;

typedef struct navset_schedule {
    size_t n;
    navset_slot *slot; // ascending
} navset_schedule;

// The slots that touch [from, to]. Free the slots with free().
orr_status navset_schedule_gps(orr_time from, orr_time to, double window_s, navset_schedule *out);
orr_status navset_schedule_glonass(orr_time from, orr_time to, const orr_leap_table *leap,
                                   navset_schedule *out);

// What became of one satellite.
typedef struct navset_satellite {
    orr_sat sat;
    size_t n;
    orr_navset_item *item;
    size_t no_clock, not_fitted; // slots left out
    orr_status status;
    char why[160]; // the last slot that was not fitted
} navset_satellite;

// Fits every slot in which the satellite has an orbit.
void navset_fit_satellite(const orr_ephemeris *e, const orr_navset_options *o,
                          const navset_schedule *schedule, navset_satellite *out);

// Almanacs of one day of GPS time: what is sent on it.
typedef struct navset_day {
    orr_time from, to, noon;
    bool fitted_lnav, fitted_glonass; // or borrowed from another day
    uint32_t toa_s;                   // LNAV: seconds of the week, a multiple of 4096
    int32_t week;                     // of toa
    orr_time glonass_day;             // any instant of the almanac's day in Moscow
    bool has_lnav[32], has_glonass[24];
    uint8_t lnav_health[32]; // six bits; 63 for what is not there
    orr_lnav_almanac lnav[32];
    orr_glonass_almanac glonass[24];
} navset_day;

// Fits the almanacs of every day of the product.
orr_status navset_fit_days(const orr_ephemeris *e, const orr_navset_options *o, orr_navset *set);
const navset_day *navset_day_at(const orr_navset *set, orr_time t); // the nearest

struct orr_navset {
    size_t n_sats;
    orr_sat *sat;           // those with sets, ascending
    navset_satellite *sets; // in that order
    orr_time from, to;
    const orr_leap_table *leap;
    size_t n_days;
    navset_day *day;
    bool has_klobuchar;
    double alpha[4], beta[4];
};

#endif

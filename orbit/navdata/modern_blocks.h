// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of fields that CNAV, CNAV-2 and B-CNAV1, 2 and 3 share: the two halves of the elements, clock, UTC, the Earth's
// rotation, midi and reduced almanacs (IS-GPS-200N 30.3.3, IS-GPS-800J 3.5, BDS-SIS-ICD-B1C 1.0, 6.2.3 and 7). D2, NavIC and
// Galileo have some of them too. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_MODERN_BLOCKS_H
#define ORR_ORBIT_NAVDATA_MODERN_BLOCKS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/nav_utc.h"
#include "orbit/navdata/page.h"

// The Earth's rotation about a reference time: values there and their rates.
typedef struct orr_modern_rotation {
    orr_time reference;
    double xp_rad, yp_rad, xp_rate_radps, yp_rate_radps;
    double ut1_utc_s, ut1_rate_spd; // seconds a day
} orr_modern_rotation;

// Almanacs that one message tells: their common reference, and whose.
#define ORR_MODERN_REDUCED 7
typedef struct orr_modern_almanacs {
    uint32_t toa_s; // of the system's week, and that
    int32_t week;
    const orr_almanac *midi;                        // NULL: none
    const orr_almanac *reduced[ORR_MODERN_REDUCED]; // likewise
} orr_modern_almanacs;

// Appends A or its difference, A dot, delta n0, its rate, M0, e and omega: message 10's, ephemeris I without toe and type.
void orr_modern_elements_1(const orr_nav_eph *e, orr_page *p);
// Appends OMEGA0, i0, OMEGADOT, IDOT, Cis, Cic, Crs, Crc, Cus, Cuc: message 11's, ephemeris II.
void orr_modern_elements_2(const orr_nav_eph *e, orr_page *p);
// Appends toe.
void orr_modern_toe(const orr_nav_eph *e, orr_page *p);
// Appends af0, af1 and af2.
void orr_modern_polynomial(const orr_nav_eph *e, orr_page *p);
// Appends toc and then af0, af1 and af2.
void orr_modern_clock(const orr_nav_eph *e, orr_page *p);
// Appends the time of prediction (as of 300 s).
void orr_modern_top(const orr_nav_eph *e, orr_page *p);
// Appends A0, A1, A2, leap seconds, reference and the leap second to come, in the weeks and days of the satellite's system
// (NavIC's weeks have ten bits: IRNSS SIS ICD 1.1, table 21).
void orr_modern_utc(const orr_nav_utc *u, orr_sat sat, orr_page *p);
// Appends A0, A1 and A2 of an offset to another system: all zero.
void orr_modern_no_offset(orr_page *p);
// Appends pole and UT1 less UTC: so BeiDou's documents have it, and so GPS' satellites sent it in March 2023 (-0.019 s), though
// IS-GPS-800J speaks of GPS time.
void orr_modern_pole_and_ut1(const orr_modern_rotation *r, orr_sat sat, orr_page *p);
// How a message counts satellites: in six bits, in eight, in six with the type of the orbit.
typedef enum orr_modern_form { ORR_MODERN_CNAV, ORR_MODERN_CNAV2, ORR_MODERN_BCNAV } orr_modern_form;
// Appends a midi almanac with the week and toa it is of; zeros, as for no satellite, where there is none or one that does not fit.
void orr_modern_midi(const orr_modern_almanacs *a, orr_modern_form form, orr_page *p);
// Appends the week and toa of the first n reduced almanacs, and those, likewise.
void orr_modern_reduced(const orr_modern_almanacs *a, size_t n, orr_modern_form form, orr_page *p);
// Appends that week and toa.
void orr_modern_reference(const orr_modern_almanacs *a, orr_page *p);
// Appends one reduced almanac; zeros where it is NULL or does not fit.
void orr_modern_reduced_one(const orr_almanac *a, orr_modern_form form, orr_page *p);
// 1 geostationary, 2 inclined geosynchronous, 3 medium orbit: BeiDou's SatType.
int orr_modern_orbit_type(orr_sat sat);

#endif

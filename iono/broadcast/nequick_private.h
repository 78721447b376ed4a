// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of NeQuick-G among themselves: tables, a profile over a point. Private to this inner room.
#ifndef ORR_IONO_BROADCAST_NEQUICK_PRIVATE_H
#define ORR_IONO_BROADCAST_NEQUICK_PRIVATE_H

#include "iono/broadcast/nequick.h"

#define NEQ_MODIP 39 // rows and columns
#define NEQ_F2_ROWS 76
#define NEQ_F2_TERMS 13
#define NEQ_M3_ROWS 49
#define NEQ_M3_TERMS 9

typedef struct neq_month {
    double f2[2][NEQ_F2_ROWS][NEQ_F2_TERMS]; // [activity][spatial term][diurnal term]
    double m3[2][NEQ_M3_ROWS][NEQ_M3_TERMS];
} neq_month;

struct orr_nequick {
    neq_month month[12];
    double modip_deg[NEQ_MODIP][NEQ_MODIP]; // [latitude][longitude]
};

// What holds for all points of a ray: the instant, the effective ionisation level, the tables at both.
typedef struct neq_epoch {
    const orr_nequick *tables;
    int month; // 1-12
    double ut_h, az, azr;
    double sin_sun, cos_sun; // of the Sun's declination
    double f2[NEQ_F2_ROWS], m3[NEQ_M3_ROWS];
} neq_epoch;

// The density over a point as three Epstein layers and the top side.
typedef struct neq_profile {
    double nm_f2, hm_f2, hm_f1;                      // 1e11 / m^3, km
    double b2_bottom, b1_top, b1_bottom, be_top, h0; // km
    double amplitude[3];                             // F2, F1, E
} neq_profile;

// (2)-(16): the modified dip latitude of a place, degrees.
double neq_modip_deg(const orr_nequick *n, double lat_deg, double lon_deg);
// (17), (18): the effective ionisation level of a receiver at that modip, sfu.
double neq_ionisation(const double ai[3], double modip_deg);
// What follows from the instant (month 1-12, hours of UT) and the ionisation level.
void neq_epoch_init(const orr_nequick *n, int month, double ut_h, double az, neq_epoch *out);
// The profile over a place.
void neq_profile_at(const neq_epoch *e, double lat_deg, double lon_deg, neq_profile *out);
// The density at a height in km, 1e11 / m^3.
double neq_density(const neq_profile *p, double height_km);

#endif

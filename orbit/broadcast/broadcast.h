// SPDX-License-Identifier: GPL-3.0-or-later
// Broadcast ephemerides as a receiver computes them: Kepler models of GPS, Galileo, BeiDou, QZSS and NavIC,
// GLONASS by Runge-Kutta, SBAS; clocks, relativity, group delays; and the choice among the records of a
// navigation file.
//
// What comes out is the antenna's phase centre in the system's own frame: WGS 84, GTRF, BDCS agree with ITRF
// to centimetres; PZ-90 is brought to ITRF by orr_broadcast_pz90_to_itrf.
#ifndef ORR_ORBIT_BROADCAST_BROADCAST_H
#define ORR_ORBIT_BROADCAST_BROADCAST_H

#include "ingest/rinex/rinex_nav.h"

// Periodic relativity of a satellite's clock, -2 r.v/c^2 (IS-GPS-200N 20.3.3.3.3.1); r.v is the same in ecef
// and in inertial axes.
static inline double orr_periodic_relativity_s(orr_vec3 r_m, orr_vec3 v_mps)
{
    return -2 * orr_vec3_dot(r_m, v_mps) / (ORR_LIGHT_MPS * ORR_LIGHT_MPS);
}

typedef struct orr_broadcast_state {
    orr_vec3 pos_m, vel_mps, acc_mps2; // ecef; the two latter are derivatives of the first
    double clock_s, clock_rate_sps;    // polynomial of the message alone
    double relativity_s; // periodic term -2 r.v/c^2, to be added to clock_s; 0 for GLONASS and SBAS, whose
                         // clock parameters hold it
} orr_broadcast_state;

// The constants that a system's own document prescribes: its gravitational parameter (m^3/s^2) and the Earth's rate
// (rad/s). A receiver must use these and no better ones.
void orr_broadcast_constants(char system, double *gm, double *earth_rate_radps);

// State by one record at t (GPS scale, satellite time). GLONASS and SBAS are integrated or extrapolated over
// |t - toe|. ORR_E_RANGE further than a day from toe (no message means that), ORR_E_NUMERIC for elements that
// are no orbit. Sources: IS-GPS-200N table 20-IV and 30-II, Galileo OS SIS ICD 2.1 5.1.1,
// BDS-SIS-ICD-B1I 3.0 5.2.4.12, IS-QZSS-PNT-005, IRNSS SIS ICD 1.1, GLONASS ICD 5.1 A.3.1.2, RTCA DO-229
// A.4.4.11.
orr_status orr_broadcast_eval(const orr_nav_eph *eph, orr_time t, orr_broadcast_state *out);

// Positions by a GLONASS record at n instants, tk_s[] ascending seconds after toe, in one sweep to either
// side instead of from tb every time. The steps differ, and with them the truncation of Runge-Kutta 4:
// orr_broadcast_eval gives the same within 1.5 mm over half an hour, 3 mm over 70 min.
orr_status orr_broadcast_glonass_track(const orr_nav_glonass *g, const double *tk_s, size_t n,
                                       orr_vec3 *pos_m);

typedef struct orr_broadcast_choice {
    double max_age_s; // |t - toe|; 0: by system (GPS, QZSS 2 h or half the fit interval, Galileo from half an
                      // hour before toe to 4 h after, BeiDou 1 h + 3 min, NavIC 2 h, GLONASS 15 min + 3 min,
                      // SBAS 6 min)
    bool healthy;     // records whose health word forbids use are passed over
    bool causal; // only records transmitted by t, as a receiver has them; unknown transmission counts as toe
                 // - 2 h (GLONASS and SBAS: toe)
    uint32_t
        messages; // to insist on, as orr_nav_messages_parse gives them, in the systems that have one of them;
    // elsewhere the legacy one (LNAV, I/NAV, D1/D2, FDMA), and for a satellite of which nav has no
    // legacy record at all the first it has of F/NAV, CNAV, CNV2 (BeiDou CNV1, CNV2, CNV3), L1NV
    int32_t iode; // issue to insist on; ORR_NAV_NO_IOD: any
} orr_broadcast_choice;
orr_broadcast_choice orr_broadcast_choice_default(void); // by age, healthy, not causal, any issue

// The record to use at t: the one with the nearest toe among those that the choice allows, the later
// transmitted where toes are equal. NULL if there is none. Borrowed from nav.
const orr_nav_eph *orr_broadcast_select(const orr_nav *nav, orr_sat sat, orr_time t,
                                        const orr_broadcast_choice *choice);

// PZ-90 coordinates broadcast at t to ITRF: PZ-90.11 (from 2014-01-15 on) agrees to a centimetre and is left
// as it is; PZ-90.02 (from 2007-09-20) is moved by (-0.36, 0.08, 0.18) m; before that PZ-90 is turned and
// moved as the GLONASS ICD 5.1 (2008) gives it against PZ-90.02: (-1.07, -0.03, 0.02) m, -0.13" about axis 3,
// -0.22e-6 in scale.
orr_vec3 orr_broadcast_pz90_to_itrf(orr_vec3 r_m, orr_time t);

// Group delay of a signal against the clock of the message, seconds, to be subtracted from the satellite's
// clock for a user of that signal alone. `signal` is a RINEX 3 code without the leading letter ("1C", "2W",
// "5Q", "7I"...). ORR_E_NODATA where the message says nothing about it, or the system has no such signal.
orr_status orr_broadcast_group_delay(const orr_nav_eph *eph, const char *signal, double *delay_s);

#endif

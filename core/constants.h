// SPDX-License-Identifier: GPL-3.0-or-later
// Physical constants, each once and with its source, SI units. A model that has to use the value of its own
// interface document, because the satellites and every receiver do, has that value under the document's
// name.
#ifndef ORR_CORE_CONSTANTS_H
#define ORR_CORE_CONSTANTS_H

#define ORR_PI 3.14159265358979323846
#define ORR_RAD_PER_DEG (ORR_PI / 180.0)
#define ORR_DEG_PER_RAD (180.0 / ORR_PI)

// --- Light, Sun and Moon ---
#define ORR_LIGHT_MPS 299792458.0     // exact, the definition of the metre
#define ORR_AU_M 1.495978707e11       // IAU 2012 resolution B2
#define ORR_SUN_RADIUS_M 6.957e8      // IAU 2015 resolution B3
#define ORR_SUN_GM 1.32712440018e20   // m^3/s^2, in TDB; DE405 (Standish 1998)
#define ORR_MOON_GM 4.9028003e12      // m^3/s^2; the mass ratio of IERS 2010 times WGS 84's GM, to 2e-8
#define ORR_SHADOW_RADIUS_M 6378136.6 // equatorial radius of the Earth, IERS Conventions 2010, table 1.1

// --- The Earth ---
// Nominal mean angular velocity, rad/s: WGS 84 (NGA.STND.0036 1.0.0, table 3.1), BDCS, and PZ-90 (GLONASS
// ICD 5.1, table 3.2).
#define ORR_EARTH_RATE_RADPS 7.292115e-5
// The sphere that heights of thin shells of the ionosphere count from (IONEX 1.1, BASE RADIUS).
#define ORR_EARTH_MEAN_RADIUS_M 6371000.0
// WGS 84 (NGA.STND.0036 1.0.0, table 3.1).
#define ORR_WGS84_A_M 6378137.0
#define ORR_WGS84_F (1.0 / 298.257223563)
#define ORR_WGS84_E2 (ORR_WGS84_F * (2.0 - ORR_WGS84_F))
#define ORR_WGS84_GM 3.986004418e14
// EGM96 (Lemoine and others 1998): the scale of its coefficients, and the GM of all that is integrated or
// osculates in this program.
#define ORR_EGM96_GM 3.986004415e14
#define ORR_EGM96_RADIUS_M 6378136.3

// --- Carriers ---
// L1 of GPS and QZSS, E1 of Galileo, B1C of BeiDou-3 (IS-GPS-200N 3.3.1.1): what delays and indices of the ionosphere are told for.
#define ORR_L1_HZ 1575.42e6

// --- Broadcast models ---
// IS-GPS-200N table 20-IV; QZSS and NavIC say the same (IS-QZSS-PNT-005, IRNSS SIS ICD 1.1).
#define ORR_GPS_GM 3.986005e14
#define ORR_GPS_EARTH_RATE_RADPS 7.2921151467e-5
// J2 rounded, for the secular and short-period terms of elements that are fitted to the GPS model; with WGS
// 84's radius.
#define ORR_GPS_J2 1.0826e-3
// Galileo OS SIS ICD 2.1, 5.1.1.
#define ORR_GALILEO_GM ORR_WGS84_GM
#define ORR_GALILEO_EARTH_RATE_RADPS ORR_GPS_EARTH_RATE_RADPS
// BDS-SIS-ICD-B1I 3.0, 5.2.4.12.
#define ORR_BEIDOU_GM ORR_WGS84_GM
#define ORR_BEIDOU_EARTH_RATE_RADPS ORR_EARTH_RATE_RADPS
// PZ-90 of GLONASS ICD L1/L2 5.1, table 3.2 and A.3; the almanac's C20 has one digit more than the J2 of
// A.3.1.2.
#define ORR_GLONASS_GM ORR_WGS84_GM
#define ORR_GLONASS_EARTH_RATE_RADPS ORR_EARTH_RATE_RADPS
#define ORR_GLONASS_RADIUS_M 6378136.0
#define ORR_GLONASS_J2 1.0826257e-3
#define ORR_GLONASS_ALMANAC_C20 (-1082.62575e-6)

#endif

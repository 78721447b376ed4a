// SPDX-License-Identifier: GPL-3.0-or-later
// Zenith delays of the neutral atmosphere at a place, by the models that receivers assume, and the mapping functions that
// bring them to a satellite's elevation. Delays are metres of excess path, the same for code and carrier.
#ifndef ORR_SCENARIO_TROPOSPHERE_ATMOSPHERE_H
#define ORR_SCENARIO_TROPOSPHERE_ATMOSPHERE_H

#include "core/earth.h"
#include "core/time.h"
#include "ingest/troposphere/gpt3.h"

// Pressure, temperature and water vapour at a height above sea level.
typedef struct orr_weather {
    double pressure_hpa, temperature_k, vapour_hpa;
} orr_weather;

typedef struct orr_zenith_delay {
    double hydrostatic_m, wet_m;
} orr_zenith_delay;

// The standard atmosphere (ICAO 1976; constants as RTKLIB has them) at a height above sea level, m, with a relative humidity of 0 to
// 1 at the ground: its troposphere to 11 km, and above that its lower stratosphere, of one temperature, however high.
orr_weather orr_weather_standard(double height_m, double humidity);

// Saastamoinen (1972) at latitude and height with Davis et al. (1985)'s gravity correction: hydrostatic
// 0.0022768 p / (1 - 0.00266 cos 2 lat - 0.00028 h[km]), wet 0.002277 (1255 / T + 0.05) e.
orr_zenith_delay orr_zenith_saastamoinen(orr_weather w, double lat_rad, double height_m);
// RTCA DO-229E, A.4.2.4: mean and seasonal values by latitude, height above sea level in metres, at an instant.
orr_zenith_delay orr_zenith_do229(double lat_rad, double height_m, orr_time t);
// STANAG 4294, issue 1: an exponential atmosphere of three layers above refractivity 324.8 at sea level; all of the delay is told
// as hydrostatic.
orr_zenith_delay orr_zenith_stanag4294(double height_m);

// The wet delay at a place, m.
// Given:
//   vapour_hpa  pressure of water vapour
//   mean_k      mean temperature weighted with it
//   decrease    its decrease factor, lambda
// Reference: Askne and Nordius 1987, Radio Sci. 22:379, with the constants of TU Wien's asknewet
double orr_wet_askne_nordius_m(double vapour_hpa, double mean_k, double decrease);

// Horizontal gradients of the delay, m.
typedef struct orr_gradients {
    double north_hydrostatic_m, east_hydrostatic_m, north_wet_m, east_wet_m;
} orr_gradients;
// What gradients add to a slant delay: m(el) (north cos az + east sin az), m = 1 / (sin el tan el + C), C 0.0031 hydrostatic and
// 0.0007 wet (Chen and Herring 1997, J. Geophys. Res. 102(B9):20489).
orr_zenith_delay orr_gradients_slant(const orr_gradients *g, double az_rad, double el_rad);

// GPT3 at a place.
typedef struct orr_gpt3_values {
    orr_weather weather;
    double mean_k, decrease; // as orr_wet_askne_nordius_m
    double a_hydrostatic, a_wet;
    orr_gradients gradients;
} orr_gpt3_values;
// Given:
//   grid     of it
//   place    geodetic, the height above the ellipsoid
//   t        instant
// Returned:
//   out      each value of the four points around, at the place's height, linear between them
//   (value)  false: the grid does not cover the place
// Notes: on the caps beyond the last parallel the values hold along each meridian; TU Wien's routine takes the nearest point.
// Reference: Landskron and Boehm 2018, J. Geod. 92:349; TU Wien's gpt3_5
bool orr_gpt3_at(const orr_gpt3 *grid, orr_geodetic place, orr_time t, orr_gpt3_values *out);

// 1 / sin(el).
double orr_mapping_cosecant(double el_rad);
// Black and Eisner (1984), as DO-229E A.4.2.4 has it, with its factor below 4 deg.
double orr_mapping_black_eisner(double el_rad);
// Chao (1972), as STANAG 4294 has it: 1 / (sin el + 0.00143 / (tan el + 0.0455)).
double orr_mapping_chao(double el_rad);
// A mapping at a place and an instant: Marini's continued fraction of sin(el), 1 at the zenith, and Niell's correction for the
// height above sea level.
typedef struct orr_mapping_fractions {
    double a, b, c;
    double height_km; // 0: without the correction
} orr_mapping_fractions;
// Factor at an elevation.
double orr_mapping_fraction(const orr_mapping_fractions *m, double el_rad);
// Niell (1996), J. Geophys. Res. 101(B2):3227.
//   Given:    lat_rad      geodetic latitude
//             height_m     height above sea level
//             t            instant: the hydrostatic one has a season
//   Returned: hydrostatic  of the hydrostatic zenith delay
//             wet          of the wet one
void orr_mapping_niell_at(double lat_rad, double height_m, orr_time t, orr_mapping_fractions *hydrostatic,
                          orr_mapping_fractions *wet);
// The Global Mapping Function: Boehm, Niell, Tregoning and Schuh (2006), Geophys. Res. Lett. 33, L07304, as the IERS Conventions
// (2010, 9.2) recommend it: harmonics of degree 9 of the place, with a season.
//   Given:    place        latitude, longitude and height above sea level
//             t            instant: both have a season
//   Returned: hydrostatic  of the hydrostatic zenith delay
//             wet          of the wet one
void orr_mapping_gmf_at(orr_geodetic place, orr_time t, orr_mapping_fractions *hydrostatic,
                        orr_mapping_fractions *wet);
// VMF3: Landskron and Boehm (2018), J. Geod. 92:349: b and c by harmonics of degree 12 of the place with a season.
// Given:
//   place        latitude, longitude and, of coefficients for sea level, the height above the ellipsoid that the hydrostatic one is
//                corrected to (Niell 1996); 0 for coefficients that a station's file gives for its own height
//   t            instant
//   a_hydrostatic, a_wet
// Returned:
//   hydrostatic  of the hydrostatic zenith delay
//   wet          of the wet one
void orr_mapping_vmf3_at(orr_geodetic place, orr_time t, double a_hydrostatic, double a_wet,
                         orr_mapping_fractions *hydrostatic, orr_mapping_fractions *wet);

#endif

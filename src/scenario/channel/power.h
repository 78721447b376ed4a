// SPDX-License-Identifier: GPL-3.0-or-later
// Received power of a signal: nominal radiated power by direction, less free space loss and the atmosphere's.
#ifndef ORR_SCENARIO_CHANNEL_POWER_H
#define ORR_SCENARIO_CHANNEL_POWER_H

#include "core/signal.h"
#include "core/vec.h"
#include "src/config/section_channel.h"

// Power received by an antenna of 0 dBi, dBW.
// Given:
//   s        signal; its least received power at 5 deg of elevation is kept for a receiver on the ground
//   sat_m    satellite, ecef
//   r_m      antenna, ecef
//   el_rad   elevation of the satellite
//   lobes    of the satellite's antenna beyond the Earth's limb; none: it falls by 3 dB a degree, to 20 dB less
// Notes: the satellite's antenna is shaped so that a receiver on a sphere of 6371 km sees what IS-GPS-200N, figure 6-1 draws:
// 2 dB more at 40 deg than at 5, 0.5 dB more at the zenith; from these three the radiated power by the angle from nadir follows.
double orr_power_received_dbw(const orr_signal *s, orr_vec3 sat_m, orr_vec3 r_m, double el_rad,
                              const orr_scenario_lobes *lobes);
// The same above the least power, dB: it is the geometry's alone, because the loss in space of the actual range stands against that
// of a nominal one of the same carrier.
double orr_power_gain_db(orr_vec3 sat_m, orr_vec3 r_m, double el_rad, const orr_scenario_lobes *lobes);

// Free space loss over a range, dB: 20 lg(4 pi r f / c).
double orr_power_space_loss_db(double range_m, double carrier_hz);
// Absorption by the atmosphere at an elevation, dB: 0.035 dB at the zenith (ITU-R P.676), longer ways as the thickness of a
// layer of 6 km on the sphere.
double orr_power_atmosphere_db(double el_rad);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/ocean_loading.h"

#include <math.h>

#include "core/constants.h"

// A constituent: multiples of the mean Sun's hour angle from midnight, of the longitudes of Moon, Sun and lunar perigee, and degrees.
typedef struct tide {
    int hour, moon, sun, perigee, deg;
} tide;
static const tide tides[ORR_BLQ_TIDES] = {
    {2, -2, 2, 0, 0}, {2, 0, 0, 0, 0},    {2, -3, 2, 1, 0},   {2, 0, 2, 0, 0},
    {1, 0, 1, 0, 90}, {1, -2, 1, 0, -90}, {1, 0, -1, 0, -90}, {1, -3, 1, 1, -90},
    {0, 2, 0, 0, 0},  {0, 1, 0, -1, 0},   {0, 0, 2, 0, 0},
};

// Factor and angle [deg] by which the Moon's node changes a constituent.
static void nodal(int k, double node_rad, double *f, double *u_deg)
{
    const double c = cos(node_rad), s = sin(node_rad);
    *f = 1;
    *u_deg = 0;
    switch (k) {
    case 0: // M2, N2
    case 2:
        *f = 1 - 0.037 * c;
        *u_deg = -2.1 * s;
        break;
    case 3: // K2
        *f = 1.024 + 0.286 * c + 0.008 * cos(2 * node_rad);
        *u_deg = -17.7 * s + 0.7 * sin(2 * node_rad);
        break;
    case 4: // K1
        *f = 1.006 + 0.115 * c - 0.009 * cos(2 * node_rad);
        *u_deg = -8.9 * s + 0.7 * sin(2 * node_rad);
        break;
    case 5: // O1, Q1
    case 7:
        *f = 1.009 + 0.187 * c - 0.015 * cos(2 * node_rad);
        *u_deg = 10.8 * s - 1.3 * sin(2 * node_rad);
        break;
    case 8: // Mf
        *f = 1.043 + 0.414 * c;
        *u_deg = -23.7 * s + 2.7 * sin(2 * node_rad);
        break;
    case 9: // Mm
        *f = 1 - 0.130 * c;
        break;
    default: // those of the Sun
        break;
    }
}

orr_vec3 orr_ocean_loading_m(const orr_blq *blq, orr_time t)
{
    int32_t mjd;
    double day;
    orr_time_mjd(t, ORR_SCALE_UTC, NULL, &mjd, &day);
    const double T = (mjd - 51544.5 + day) / 36525; // a minute of TT - UTC is 0.01 degree of the Moon
    const double hour = 360 * day, moon = 218.31664563 + 481267.88194 * T,
                 sun = 280.46645 + 36000.7697489 * T, perigee = 83.35324312 + 4069.01363525 * T,
                 node_rad = (125.04452 - 1934.136261 * T) * ORR_RAD_PER_DEG;
    double moved_m[3] = {0, 0, 0};
    for (int k = 0; k < ORR_BLQ_TIDES; k++) {
        const tide *x = &tides[k];
        double f, u_deg;
        nodal(k, node_rad, &f, &u_deg);
        const double deg =
            fmod(x->hour * hour + x->moon * moon + x->sun * sun + x->perigee * perigee + x->deg + u_deg, 360);
        for (int i = 0; i < 3; i++)
            moved_m[i] += f * blq->amplitude_m[i][k] * cos((deg - blq->lag_deg[i][k]) * ORR_RAD_PER_DEG);
    }
    return (orr_vec3){-moved_m[1], -moved_m[2], moved_m[0]};
}

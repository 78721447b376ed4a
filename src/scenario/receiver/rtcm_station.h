// SPDX-License-Identifier: GPL-3.0-or-later
// What RTCM 3 tells of a base station: 1005 and 1006 (its place), 1033 (its equipment), 1230 (GLONASS biases).
#ifndef ORR_SCENARIO_RECEIVER_RTCM_STATION_H
#define ORR_SCENARIO_RECEIVER_RTCM_STATION_H

#include "core/vec.h"
#include "orbit/navdata/rtcm_frame.h"

typedef struct orr_rtcm_station {
    unsigned number;     // DF003, 0 to 4095
    orr_vec3 position_m; // of the antenna's reference point, ecef
    const char *antenna, *receiver, *version;
    const char *systems; // letters of those that it observes
    bool l1of, l2of;     // which of GLONASS' FDMA signals
} orr_rtcm_station;

// 1005, or 1006 with an antenna height of zero: the antenna's reference point itself is the station's.
void orr_rtcm_place(const orr_rtcm_station *s, bool height, orr_rtcm_frame *frame);
// 1033.
void orr_rtcm_equipment(const orr_rtcm_station *s, orr_rtcm_frame *frame);
// 1230: codes and phases are aligned, biases of the observed signals are zero.
void orr_rtcm_glonass_biases(const orr_rtcm_station *s, orr_rtcm_frame *frame);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Section `ionosphere`: where the delays come from.
#ifndef ORR_CONFIG_SECTION_IONOSPHERE_H
#define ORR_CONFIG_SECTION_IONOSPHERE_H

#include "src/config/schema.h"

// How maps are kept, and taken between their epochs. In the order of orr_tec_spatial and orr_tec_temporal (iono), which
// this room does not know.
#define ORR_IONO_MAPS(X)                                                                                     \
    X(ORR_IONO_MAPS_HARMONICS, "harmonics",                                                                  \
      "refitted to spherical harmonics in the solar-geomagnetic frame")                                      \
    X(ORR_IONO_MAPS_BILINEAR, "bilinear", "as they are")                                                     \
    X(ORR_IONO_MAPS_AUTO, "auto", "harmonics; maps of a region as they are")
typedef enum orr_iono_maps_word { ORR_IONO_MAPS(ORR_CHOICE_VALUE) } orr_iono_maps_word;
#define ORR_IONO_BETWEEN(X)                                                                                  \
    X(ORR_IONO_BETWEEN_NEAREST, "nearest", "the nearest map")                                                \
    X(ORR_IONO_BETWEEN_LINEAR, "linear", "linear at one place on the Earth")                                 \
    X(ORR_IONO_BETWEEN_ROTATED, "rotated", "linear between maps turned with the Sun")                        \
    X(ORR_IONO_BETWEEN_AUTO, "auto", "rotated; linear for maps of a region")
typedef enum orr_iono_between_word { ORR_IONO_BETWEEN(ORR_CHOICE_VALUE) } orr_iono_between_word;

typedef struct orr_scenario_iono {
    char *field;       // IONEX maps, Bernese coefficients, or a navigation file (Klobuchar)
    int maps, between; // of the field's maps
    double rotation;   // of ROTATED: the part of the Sun's motion that maps follow
    char *session;     // or a session made by 'orrery iono'
    bool noise;
    int64_t seed; // of the noise where the session's station saw nothing
} orr_scenario_iono;

extern const orr_schema orr_section_ionosphere;

#endif

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

// In the order of orr_tec_algorithm and orr_mapping_kind.
#define ORR_IONO_MODELS(X)                                                                                   \
    X(ORR_IONO_MODEL_AUTO, "auto", "the first that the file has of these, in this order")                    \
    X(ORR_IONO_MODEL_GPS, "gps", "Klobuchar, GPS's coefficients")                                            \
    X(ORR_IONO_MODEL_QZSS, "qzss", "Klobuchar, QZSS's")                                                      \
    X(ORR_IONO_MODEL_NAVIC, "navic", "Klobuchar, NavIC's")                                                   \
    X(ORR_IONO_MODEL_BEIDOU, "beidou", "BeiDou's eight coefficients, in its own formula")                    \
    X(ORR_IONO_MODEL_BDGIM, "bdgim", "BeiDou's nine coefficients (BDGIM)")                                   \
    X(ORR_IONO_MODEL_NEQUICK, "nequick", "NeQuick-G, Galileo's three coefficients")
typedef enum orr_iono_model_word { ORR_IONO_MODELS(ORR_CHOICE_VALUE) } orr_iono_model_word;
#define ORR_IONO_MAPPINGS(X)                                                                                 \
    X(ORR_IONO_MAPPING_NONE, "none", "slant content is vertical content")                                    \
    X(ORR_IONO_MAPPING_THIN_SHELL, "thin-shell", "1 / cos z' at the shell")                                  \
    X(ORR_IONO_MAPPING_MSLM, "mslm", "CODE's modified single layer")
typedef enum orr_iono_mapping_word { ORR_IONO_MAPPINGS(ORR_CHOICE_VALUE) } orr_iono_mapping_word;

typedef struct orr_scenario_iono {
    char *field;       // IONEX maps, Bernese coefficients, or a navigation file (a broadcast model)
    int maps, between; // of the field's maps
    double rotation;   // of ROTATED: the part of the Sun's motion that maps follow
    int model;         // of a navigation file
    char *nequick;     // folder of NeQuick-G's tables
    int mapping;       // slant from vertical
    char *session;     // or a session made by 'orrery iono'
    bool noise;
    int64_t seed; // of the noise where the session's station saw nothing
} orr_scenario_iono;

extern const orr_schema orr_section_ionosphere;

#endif

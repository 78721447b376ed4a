// SPDX-License-Identifier: GPL-3.0-or-later
// Section `ionosphere`: where the delays come from.
#ifndef ORR_CONFIG_SECTION_IONOSPHERE_H
#define ORR_CONFIG_SECTION_IONOSPHERE_H

#include "src/config/schema.h"

typedef struct orr_scenario_iono {
    char *field;   // IONEX maps, Bernese coefficients, or a navigation file (Klobuchar)
    char *session; // or a session made by 'orrery iono'
    bool noise;
    int64_t seed; // of the noise where the session's station saw nothing
} orr_scenario_iono;

extern const orr_schema orr_section_ionosphere;

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Section `navdata`: what satellites say of themselves.
#ifndef ORR_CONFIG_SECTION_NAVDATA_H
#define ORR_CONFIG_SECTION_NAVDATA_H

#include "src/config/schema.h"

#define ORR_NAVDATA_WINDOWS(X)                                                                               \
    X(ORR_NAVDATA_2H, "2h", "two hours, the closer fit")                                                     \
    X(ORR_NAVDATA_4H, "4h", "four hours")                                                                    \
    X(ORR_NAVDATA_NONE, "none", "no broadcast data; the service starts sooner")

typedef enum orr_navdata_window { ORR_NAVDATA_WINDOWS(ORR_CHOICE_VALUE) } orr_navdata_window;

typedef struct orr_scenario_navdata {
    int window; // orr_navdata_window
    char *antex, *bias;
    orr_text_list nav;
    bool zero_clocks;
} orr_scenario_navdata;

extern const orr_schema orr_section_navdata;

#endif

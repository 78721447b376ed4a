// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_land_mobile.h"

#include "src/config/rows_private.h"

static const orr_key rows[] = {
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .offset = offsetof(orr_scenario_land_mobile, sats),
     .given = offsetof(orr_scenario_land_mobile, has_sats),
     .help = "satellites, each with states of its own; default: all. The first of the list that names one is "
             "its"},
    NEEDED_REAL_ROW(orr_scenario_land_mobile, "speed", speed_mps, 0.1, 50, "m/s", NULL,
                    "at which the antenna goes through it; waves beat at up to speed over wavelength"),
    NEEDED_REAL_ROW(orr_scenario_land_mobile, "good", good_m, 1, 1e5, "m", NULL,
                    "mean length of a stretch in view"),
    NEEDED_REAL_ROW(orr_scenario_land_mobile, "bad", bad_m, 1, 1e5, "m", NULL, "and of one in shadow"),
    REAL_ROW(orr_scenario_land_mobile, "rice", rice_db, 0, 40, "dB", "10", NULL,
             "in view: power of the direct ray over that of the scattered ones"),
    REAL_ROW(orr_scenario_land_mobile, "shadow", shadow_db, -40, 0, "dB", "-10", NULL,
             "in shadow: mean of the scattered rays' power in dB, against the direct ray's"),
    REAL_ROW(orr_scenario_land_mobile, "shadow_sigma", shadow_sigma_db, 0, 15, "dB", "3", NULL,
             "its standard deviation, from stretch to stretch"),
    INT_ROW(orr_scenario_land_mobile, "seed", seed, 0, 9e15, "1", NULL, "seed"),
};
const orr_schema orr_section_land_mobile = ORR_SCHEMA(rows, orr_scenario_land_mobile);

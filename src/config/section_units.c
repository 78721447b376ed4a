// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_units.h"

#include "src/config/rows_private.h"

#define UNIT_REAL(n, m, lo, hi, u, h) REAL_ROW(orr_scenario_unit, n, m, lo, hi, u, "0", NULL, h)

static const orr_key rows[] = {
    TEXT_ROW(orr_scenario_unit, "name", name, NULL, "what the unit is called"),
    UNIT_REAL("right", right_m, -1000, 1000, "m", "lever arm from unit 0, to the right"),
    UNIT_REAL("forward", forward_m, -1000, 1000, "m", "lever arm, forward"),
    UNIT_REAL("up", up_m, -1000, 1000, "m", "lever arm, up"),
    UNIT_REAL("heading", heading_deg, -360, 360, "deg", "turn of its axes against unit 0's"),
    UNIT_REAL("pitch", pitch_deg, -90, 90, "deg", "pitch against unit 0"),
    UNIT_REAL("roll", roll_deg, -180, 180, "deg", "roll against unit 0"),
};

const orr_schema orr_section_unit = ORR_SCHEMA(rows, orr_scenario_unit);

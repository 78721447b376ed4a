// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_receiver.h"

#include <math.h>

#include "src/config/rows_private.h"
#include "src/config/section_units.h"

static const orr_condition no_unit[] = {{.key = "unit", .absent = true}, {0}};
static const orr_condition of_trajectory[] = {{.key = "../trajectory"}, {0}};

static const orr_key rows[] = {
    {.name = "position",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_receiver, position),
     .min = -500000,
     .max = 500000,
     .least = 3,
     .most = 3,
     .only = no_unit,
     .help = "receiver used when a request names none: latitude and longitude in degrees (geodetic), height "
             "in metres. Default: the trajectory's point at each epoch, or else the station of "
             "ionosphere.session"},
    {.name = "unit",
     .kind = ORR_KEY_INT,
     .offset = offsetof(orr_scenario_receiver, unit),
     .min = 0,
     .max = ORR_MOTION_MAX_UNITS - 1,
     .fallback = "0",
     .only = of_trajectory,
     .help = "the inertial unit at whose point that receiver's antenna is; 0 is the trajectory's own"},
};

static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_real_list *p = &((const orr_scenario_receiver *)map)->position;
    if (p->n == 0 || (fabs(p->item[0]) <= 90 && fabs(p->item[1]) <= 360)) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "latitude %g, longitude %g is no place", p->item[0], p->item[1]);
    return "position";
}

const orr_schema orr_section_receiver = {
    .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_scenario_receiver), .check = check};

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_navdata.h"

#include "src/config/rows_private.h"

static const orr_condition fitted[] = {{.key = "window", .words = "2h|4h"}, {0}};

static const orr_choice windows[] = {ORR_NAVDATA_WINDOWS(ORR_CHOICE_WORD){0}};

static const orr_key rows[] = {
    CHOICE_ROW(orr_scenario_navdata, "window", window, windows, "2h", NULL,
               "how much of the orbit one fitted GPS set describes"),
    FILE_ROW(orr_scenario_navdata, "antex", antex, fitted,
             "ANTEX file: broadcast data describe the antennas' phase centres; without it the centres of "
             "mass, as STATES does"),
    FILE_ROW(orr_scenario_navdata, "bias", bias, fitted,
             "Bias-SINEX or DCB file: group delays; without it they are sent as zero"),
    FILES_ROW(orr_scenario_navdata, "nav", nav, fitted,
              "RINEX navigation files to take GLONASS' frequency channels and Klobuchar's coefficients "
              "from; without them the nominal channels, and the coefficients of ionosphere.field if it has "
              "them or can be fitted to it"),
    BOOL_ROW(orr_scenario_navdata, "zero_clocks", zero_clocks, "no", fitted,
             "send a clock of zero for satellites whose clock the orbits do not know; they are left out "
             "otherwise"),
};

const orr_schema orr_section_navdata = ORR_SCHEMA(rows, orr_scenario_navdata);

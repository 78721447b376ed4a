// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/nav_stream.h"

static const orr_nav_stream streams[] = {
    {'G', ORR_NAV_LNAV, "L1CA"},  {'G', ORR_NAV_CNAV, "L2C"},       {'G', ORR_NAV_CNAV, "L5"},
    {'G', ORR_NAV_CNV2, "L1C"},   {'R', ORR_NAV_FDMA, "L1OF L2OF"}, {'E', ORR_NAV_INAV, "E1"},
    {'E', ORR_NAV_INAV, "E5b"},   {'E', ORR_NAV_FNAV, "E5a"},       {'C', ORR_NAV_D1, "B1I B3I"},
    {'C', ORR_NAV_D2, "B1I B3I"}, {'C', ORR_NAV_CNV1, "B1C"},       {'C', ORR_NAV_CNV2, "B2a"},
    {'C', ORR_NAV_CNV3, "B2b"},   {'J', ORR_NAV_LNAV, "L1CA"},      {'J', ORR_NAV_CNAV, "L2C"},
    {'J', ORR_NAV_CNAV, "L5"},    {'J', ORR_NAV_CNV2, "L1C"},       {'I', ORR_NAV_LNAV, "L5 S"},
    {'S', ORR_NAV_SBAS, "L1CA"},
};

const orr_nav_stream *orr_nav_streams(size_t *n)
{
    *n = sizeof streams / sizeof *streams;
    return streams;
}

uint32_t orr_nav_streams_of(char system)
{
    uint32_t bits = 0;
    for (size_t k = 0; k < sizeof streams / sizeof *streams; k++)
        if (streams[k].system == system) bits |= UINT32_C(1) << streams[k].message;
    return bits;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Observation codes that there are: bands and attributes of each system (RINEX 3.02 to 4.02, tables of observation codes).
#include <string.h>

#include "ingest/rinex/rinex_obs.h"

// Attributes of a band. BeiDou's band 1 has 3.02's names of B1 too.
static const struct {
    char system, band;
    const char *attributes;
} signals[] = {
    {'G', '1', "CSLXPWYMNR"}, {'G', '2', "CDSLXPWYMNR"}, {'G', '5', "IQX"},    {'R', '1', "CP"},
    {'R', '4', "ABX"},        {'R', '2', "CP"},          {'R', '6', "ABX"},    {'R', '3', "IQX"},
    {'E', '1', "ABCXZ"},      {'E', '5', "IQX"},         {'E', '7', "IQX"},    {'E', '8', "IQX"},
    {'E', '6', "ABCXZ"},      {'S', '1', "C"},           {'S', '5', "IQX"},    {'J', '1', "CESLXZB"},
    {'J', '2', "SLX"},        {'J', '5', "IQXDPZ"},      {'J', '6', "SLXEZ"},  {'C', '2', "IQX"},
    {'C', '1', "DPXANSLZIQ"}, {'C', '5', "DPX"},         {'C', '7', "IQXDPZ"}, {'C', '8', "DPX"},
    {'C', '6', "IQXADPZ"},    {'I', '5', "ABCX"},        {'I', '9', "ABCX"},   {'I', '1', "DPX"},
};

bool orr_obs_code_is_known(char system, const char *code)
{
    if (strchr("CLDS", code[0]) == NULL)
        return code[0] == 'X' || code[0] == 'I'; // channel numbers, ionospheric delays
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++)
        if (signals[i].system == system && signals[i].band == code[1])
            return code[2] == '\0' || code[2] == ' ' || strchr(signals[i].attributes, code[2]) != NULL;
    return false;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/gps_configuration.h"

#include <string.h>

enum { LEGACY = 1, IIR_M, IIF, III, IIIF };

static uint8_t of_block(const char *type)
{
    static const struct {
        const char *type;
        uint8_t code;
    } block[] = {{"BLOCK IIIF", IIIF}, {"BLOCK III", III}, {"BLOCK IIF", IIF}, {"BLOCK IIR-M", IIR_M}};
    for (size_t k = 0; k < sizeof block / sizeof *block; k++)
        if (strncmp(type, block[k].type, strlen(block[k].type)) == 0) return block[k].code;
    return LEGACY;
}

// Launches of satellites after Block IIR by their PRN, as the International GNSS Service's ANTEX files date them.
static uint8_t of_launches(int prn, orr_time t)
{
    static const struct {
        int prn, year, month, day;
        uint8_t code;
    } launch[] = {{17, 2005, 9, 26, 2},  {31, 2006, 9, 25, 2}, {12, 2006, 11, 17, 2}, {15, 2007, 10, 17, 2},
                  {29, 2007, 12, 20, 2}, {7, 2008, 3, 15, 2},  {1, 2009, 3, 24, 2},   {5, 2009, 8, 17, 2},
                  {25, 2010, 5, 28, 3},  {1, 2011, 7, 16, 3},  {24, 2012, 10, 4, 3},  {27, 2013, 5, 15, 3},
                  {30, 2014, 2, 21, 3},  {6, 2014, 5, 17, 3},  {9, 2014, 8, 2, 3},    {3, 2014, 10, 29, 3},
                  {26, 2015, 3, 25, 3},  {8, 2015, 7, 15, 3},  {10, 2015, 10, 31, 3}, {32, 2016, 2, 5, 3},
                  {4, 2018, 12, 23, 4},  {18, 2019, 8, 22, 4}, {23, 2020, 6, 30, 4},  {14, 2020, 11, 5, 4},
                  {11, 2021, 6, 17, 4},  {28, 2023, 1, 18, 4}, {1, 2024, 12, 17, 4},  {21, 2025, 5, 30, 4}};
    uint8_t code = LEGACY;
    for (size_t k = 0; k < sizeof launch / sizeof *launch; k++) {
        const int32_t mjd = orr_mjd_from_date(launch[k].year, launch[k].month, launch[k].day);
        if (launch[k].prn == prn && t >= orr_time_from_mjd(mjd, 0, ORR_SCALE_GPS, NULL))
            code = launch[k].code;
    }
    return code;
}

uint8_t orr_gps_configuration(const orr_antex *antex, orr_sat sat, orr_time t)
{
    const orr_antex_antenna *a = antex != NULL ? orr_antex_find_sat(antex, sat, t) : NULL;
    if (orr_sat_system(sat) != 'G' || orr_sat_number(sat) > 32) return 0;
    return a != NULL ? of_block(a->type) : of_launches(orr_sat_number(sat), t);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// GLONASS frequency channels.
#include "orbit/navdata/glonass_channel.h"

// The plan of the constellation's 24 slots: antipodal satellites share a channel (glonass-iac.ru,
// "Constellation status"; unchanged since 2010 but for a few satellites in trial). The files of 2020-177
// agree slot by slot.
static const int nominal_plan[24] = {1,  -4, 5, 6,  1, -4, 5, 6, -2, -7, 0, -1,
                                     -2, -7, 0, -1, 4, -3, 3, 2, 4,  -3, 3, 2};

bool orr_glonass_channel(const orr_nav *nav, orr_sat sat, orr_time t, int *channel, bool *nominal)
{
    *nominal = false;
    if (nav != NULL) {
        size_t first, n, best = 0;
        orr_nav_of_sat(nav, sat, &first, &n);
        for (size_t i = 1; i < n; i++) {
            int64_t d = nav->eph[first + i].toe - t, least = nav->eph[first + best].toe - t;
            if ((d < 0 ? -d : d) < (least < 0 ? -least : least)) best = i;
        }
        if (n > 0) return *channel = nav->eph[first + best].glonass.freq_channel, true;
    }
    int slot = orr_sat_number(sat);
    if (slot > 24) return false;
    *nominal = true;
    *channel = nominal_plan[slot - 1];
    return true;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/frames.h"

#include <string.h>

// The realisation: the last two digits of the first number in a name, 20 of "IGS20_2247" and of "ITRF2020"; -1: none.
static int realisation(const char *name)
{
    name += strcspn(name, "0123456789");
    const size_t n = strspn(name, "0123456789");
    if (n < 2) return -1;
    return (name[n - 2] - '0') * 10 + (name[n - 1] - '0');
}

bool orr_frames_differ(const char *a, const char *b)
{
    const int x = realisation(a), y = realisation(b);
    return x >= 0 && y >= 0 && x != y;
}

void orr_frames_check_antex(const orr_antex *antex, const char *path, const char *orbit_frame,
                            orr_warnings *warnings)
{
    for (size_t i = 0; i < antex->n_antennas; i++) {
        const orr_antex_antenna *a = &antex->antenna[i];
        if (a->sat == ORR_SAT_NONE || a->sinex_code[0] == '\0') continue;
        if (orr_frames_differ(a->sinex_code, orbit_frame))
            orr_warnings_add(
                warnings, path, 0, 0,
                "the antennas are of %s, the orbits of %s: their phase centres differ by centimetres",
                a->sinex_code, orbit_frame);
        return; // a file is of one frame
    }
}

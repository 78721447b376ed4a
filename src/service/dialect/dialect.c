// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/dialect/dialect.h"

#include <string.h>

const orr_dialect *orr_dialect_of(const char *name)
{
    static const orr_dialect *const all[] = {&orr_dialect_frames, &orr_dialect_skydel, &orr_dialect_lines,
                                             &orr_dialect_nmea};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
        if (strcmp(all[k]->name, name) == 0) return all[k];
    return NULL;
}

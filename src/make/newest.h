// SPDX-License-Identifier: GPL-3.0-or-later
// Ultra-rapid orbits of the fetch cache: those that a prediction up to the present starts from.
#ifndef ORR_MAKE_NEWEST_H
#define ORR_MAKE_NEWEST_H

#include "core/status.h"
#include "core/time.h"

#define ORR_NEWEST_PATH 1200

// The files to go on from: the one whose observed part ends last but not after the present, and the same centre's of about
// a day before, if it is there.
typedef struct orr_newest {
    size_t n;
    char path[2][ORR_NEWEST_PATH];
} orr_newest;

// The present instant, by the system's clock.
orr_time orr_present(void);
// Looks through a cache folder (CACHE/yyyy/ddd, ingest/fetch/fetch.h) of the present's day and three before it for SP3
// files of which a part is observed and a part predicted. Errors: ORR_E_NODATA where there is none.
orr_status orr_newest_find(const char *cache, orr_time present, orr_newest *out, orr_diag *diag);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that lies in a file without a name: for arrays larger than what a process should hold, of which a small part is in
// use at a time. The system reads and writes the file as its pages are touched and let go of.
#ifndef ORR_CORE_BACKING_H
#define ORR_CORE_BACKING_H

#include <stddef.h>

#include "core/status.h"

typedef struct orr_backing orr_backing;

// A file in `folder` that has no name there. ORR_E_IO where none can be made, ORR_E_MEMORY. To be freed with
// orr_backing_free.
orr_status orr_backing_open(const char *folder, orr_backing **out, orr_diag *diag);
// Zeroed memory of `bytes`, at the bounds of pages, that lasts as long as the backing; NULL and errno where there is none. To be called
// by one thread at a time.
void *orr_backing_take(orr_backing *b, size_t bytes);
// Lets go of the pages that are in memory; what they hold stays. NULL is allowed.
void orr_backing_rest(const orr_backing *b);
// Ends the memory and the file; NULL is allowed.
void orr_backing_free(orr_backing *b);

#endif

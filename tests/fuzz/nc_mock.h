// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for core/ncread.c and core/ncwrite.c (its objects take the place of the room's): what is written
// stays in memory, a fuzzer's bytes edit it, and loaders read the result. So our loaders meet any dimensions,
// values and attributes, thousands of times a second, without the NetCDF library, whose own robustness is not
// in question here (core/ncseal.h).
#ifndef ORR_TESTS_NC_MOCK_H
#define ORR_TESTS_NC_MOCK_H

#include <stddef.h>
#include <stdint.h>

// What was written last is kept as file k < NC_MOCK_FILES, for edits to begin from.
#define NC_MOCK_FILES 4
void nc_mock_keep(unsigned k);
// File k again, with edits, 12 bytes each: what to do, to which entry, where in it (2), a value (8, of
// which the doing takes what it needs). Every 12 bytes are an edit; a rest is left.
void nc_mock_edit(unsigned k, const uint8_t *data, size_t n);

#endif

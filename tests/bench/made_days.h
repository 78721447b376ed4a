// SPDX-License-Identifier: GPL-3.0-or-later
// Made days of 80 satellites as SP3 files of 15-minute positions and clocks, and the program run on them.
#ifndef ORR_TESTS_BENCH_MADE_DAYS_H
#define ORR_TESTS_BENCH_MADE_DAYS_H

#include <sys/types.h>

#include "src/make/made_days.h"

#define MADE_FIRST "2024-02-04" // the first day

// Writes `days` consecutive days of all satellites into a folder; their paths into path[days].
void made_days(const char *folder, size_t days, char (*path)[ORR_MADE_PATH]);
// Starts the program with arguments, NULL at their end; what it says goes nowhere. Its process.
pid_t made_start(const char *const *argv);
// Ends the program with a sentence where something is not good.
void made_must(bool good, const char *what);

#endif

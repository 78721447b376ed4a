// SPDX-License-Identifier: GPL-3.0-or-later
// Made days of 80 satellites as SP3 files of 15-minute positions and clocks: integrated, in planes and heights of GPS, GLONASS and Galileo.
#ifndef ORR_TESTS_BENCH_MADE_DAYS_H
#define ORR_TESTS_BENCH_MADE_DAYS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "core/sat.h"

#define MADE_PATH 96
#define MADE_SATS 80
#define MADE_FIRST "2024-02-04" // the first day

// Writes `days` consecutive days of the satellites of `only` (NULL: all) into a folder; their paths into path[days].
void made_days(const char *folder, size_t days, const orr_sat_set *only, char (*path)[MADE_PATH]);
// Starts the program with arguments, NULL at their end; what it says goes nowhere. Its process.
pid_t made_start(const char *const *argv);
// Ends the program with a sentence where something is not good.
void made_must(bool good, const char *what);

#endif

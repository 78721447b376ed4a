// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of the program's own objects that can be made to fail: the linker hands them to wrap.c, which counts them and lets one of them fail
// as the system would. Which one is told in memory that processes share.
#ifndef ORR_TESTS_FAULTS_WRAP_H
#define ORR_TESTS_FAULTS_WRAP_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct faults {
    atomic_llong calls; // counted so far
    atomic_llong fail;  // the number, from 1, of the call that fails; 0: none
    atomic_int hits;    // how many have failed
    char name[32];      // of the one that failed, and where it was called from
    uintptr_t from;
} faults;

// Memory that children share, or, where a file is named, whoever maps that; zeroed at first. Ends the program where there is none.
faults *faults_share(const char *file);

#endif

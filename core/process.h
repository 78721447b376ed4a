// SPDX-License-Identifier: GPL-3.0-or-later
// Whether somebody may still come back to what carries a process's number.
#ifndef ORR_CORE_PROCESS_H
#define ORR_CORE_PROCESS_H

#include <stdbool.h>

// False where this machine has no process of the number, or one that has ended and only waits to be taken note of by its
// parent (a zombie: it holds no file and no lock any more).
bool orr_process_lives(long pid);

#endif

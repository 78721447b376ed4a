// SPDX-License-Identifier: GPL-3.0-or-later
// Several threads at one worker: each takes tasks by an atomic counter of the caller's, so results do not
// depend on how many there are.
#ifndef ORR_CORE_PARALLEL_H
#define ORR_CORE_PARALLEL_H

#include <stddef.h>

// Processors that are there, 1 to 256: how many threads are worth their while.
int orr_parallel_cores(void);

// Runs independent tasks on several threads, and returns when all are done.
//   Given:    n       number of tasks
//             jobs    most threads, the caller's own among them; 1 to 256
//             task    called as task(user, i) once for each i = 0 .. n - 1, in no order
//             user    handed to each
//   Notes:    if no thread can be started the caller's does all.
void orr_parallel_each(size_t n, int jobs, void (*task)(void *user, size_t i), void *user);
// The same, one level lower: `worker(user)` on up to `jobs` threads; for workers that keep something of their
// own.
void orr_parallel_run(int jobs, void *(*worker)(void *user), void *user);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// What a service answers from: a scenario, its engine, and who may come in. It is made as a whole, so that one with a fault is told before
// anything is exchanged for it.
#ifndef ORR_CLI_SERVICE_WORLD_H
#define ORR_CLI_SERVICE_WORLD_H

#include <pthread.h>
#include <stdatomic.h>

#include "src/cli/frame/cli.h"
#include "src/scenario/engine/engine.h"
#include "src/service/net/access.h"

typedef struct serving_world {
    orr_scenario scenario;
    orr_access *access;
    orr_engine *engine;
    uint64_t mark; // which files, of which size and time, it was made of
} serving_world;

// The scenario, read, and the rules of who may come in; no engine yet. Frees nothing of an earlier one.
//   Given:    c      the command line, which overrules the scenario
//             path   of a scenario or an orbit product
//   Returned: w      close it with serving_world_close, after an error too
//             diag   the fault
orr_status serving_world_read(const orr_cli *c, const char *path, serving_world *w, orr_diag *diag);
// Its engine; seconds, where orbits have to be smoothed.
//   Given:    log       what it tells meanwhile
//             cancel    as of orr_engine_open
//   Returned: warnings  freed by the caller
//             w, diag   as above
orr_status serving_world_make(serving_world *w, const orr_log *log, const volatile int *cancel,
                              orr_warnings *warnings, orr_diag *diag);
// Frees it and leaves none.
void serving_world_close(serving_world *w);

// A world made by a thread beside a service that runs (SIGHUP).
typedef struct serving_remake {
    const orr_cli *c;
    const orr_log *log;
    char path[4200];
    uint64_t mark;       // of what is served; a world of the same files is not made
    bool running;        // the thread is to be joined
    atomic_bool ended;   // it has ended
    bool same;           // afterwards: nothing has changed
    orr_status status;   // afterwards: how it went, and
    orr_diag diag;       // why not
    serving_world world; // afterwards, where it went well: for the caller to take
    volatile int cancel;
    pthread_t thread;
} serving_remake;

// Begins it; c, log, path and mark are set. ORR_E_MEMORY: there is no thread.
orr_status serving_remake_begin(serving_remake *r, orr_diag *diag);
// Whether it has ended by now: then it is joined, and the rest of it can be read.
bool serving_remake_ended(serving_remake *r);
// Ends it whatever it has come to.
void serving_remake_cancel(serving_remake *r);

#endif

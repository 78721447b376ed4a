// SPDX-License-Identifier: GPL-3.0-or-later
// One scenario prepared and served: what `orrery serve` does once, and again for each scenario that a client loads.
#ifndef ORR_CLI_SERVICE_SERVING_H
#define ORR_CLI_SERVICE_SERVING_H

#include <stdatomic.h>

#include "src/cli/frame/cli.h"
#include "src/cli/service/serve_log.h"
#include "src/cli/service/supervisor.h"
#include "src/cli/service/world.h"
#include "src/service/answers/answers.h"
#include "src/service/dialect/motion_port.h"
#include "src/service/http/live_page.h"
#include "src/service/http/metrics.h"
#include "src/service/live/motion_log.h"
#include "src/service/ports/port_server.h"
#include "src/service/serve/service.h"
#include "src/service/text/text_server.h"

// A service being made, and what it talks through: c->log until it runs, then one that waits for nobody.
typedef struct serving {
    orr_cli *c;
    char path[4200];     // of the scenario
    serving_world world; // what it answers from,
    serving_world past;  // and what was answered from before, until this is served
    serving_remake remake;
    bool again;       // SIGHUP came once more meanwhile
    const char **url; // of --listen
    orr_service *service;
    orr_metrics metrics;
    orr_answers *answers, *maker; // of requests and of streams: each thread has a room of its own
    orr_streams *streams;
    orr_vehicle *vehicle; // NULL: no motion is taken
    orr_motion_log *log_out, *log_in;
    orr_answers *reader; // of the text twin's thread
    orr_text_server *text;
    orr_port_server *ports; // of antennas' receivers
    orr_answers *shown;     // of the live page's thread
    orr_live_page *page;
    orr_http_server *http;
    orr_journal *journal;
    orr_motion_port *port;
    orr_serve_log talk;
    orr_supervisor supervisor;
    orr_log log;
    size_t n_kept;
    char kept[16][ORR_URL_TEXT]; // of a scenario that has been loaded: where the one before was served
    orr_time from;               // where its clock begins; ORR_TIME_NONE: at its first instant
    orr_time begun;              // and where that of the service began
    orr_clock clock;             // that of the scenario before, which goes on; stopped: it does not
    bool stopping;               // told to end
    atomic_bool loading;         // the service ends for another scenario: `next`, or that of remake.world
    char next[128];
} serving;

// One scenario, from its preparation to the end of its service.
//   Given:    v              with c, talk, supervisor, log, journal and path set; world, where it has been made
//   Returned: asked_wrongly  true: the failure is a usage error
//             diag           why it failed; of OK, `v->loading` says whether another scenario is to follow
orr_status serving_run(serving *v, bool *asked_wrongly, orr_diag *diag);
// The scenario that the service has ended for; where it cannot be served the one before again, from the memory that it was served from.
orr_status serving_next(serving *v, orr_diag *diag);
// Writes a line of the log for an orr_log whose user is a serving.
void serving_write_log(void *user, orr_log_level level, const char *line);

#endif

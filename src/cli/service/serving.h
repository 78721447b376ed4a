// SPDX-License-Identifier: GPL-3.0-or-later
// One scenario prepared and served: what `orrery serve` does once, and again for each scenario that a client loads.
#ifndef ORR_CLI_SERVICE_SERVING_H
#define ORR_CLI_SERVICE_SERVING_H

#include <stdatomic.h>

#include "src/cli/frame/cli.h"
#include "src/cli/service/serve_log.h"
#include "src/cli/service/supervisor.h"
#include "src/service/answers/answers.h"
#include "src/service/dialect/motion_port.h"
#include "src/service/http/live_page.h"
#include "src/service/http/metrics.h"
#include "src/service/live/motion_log.h"
#include "src/service/serve/service.h"
#include "src/service/text/text_server.h"

// A service being made, and what it talks through: c->log until it runs, then one that waits for nobody.
typedef struct serving {
    orr_cli *c;
    orr_scenario scenario;
    const char **url; // of --listen
    orr_access *access;
    orr_service *service;
    orr_metrics metrics;
    orr_engine *engine;
    orr_answers *answers, *maker; // of requests and of streams: each thread has a room of its own
    orr_streams *streams;
    orr_vehicle *vehicle; // NULL: no motion is taken
    orr_motion_log *log_out, *log_in;
    orr_answers *reader; // of the text twin's thread
    orr_text_server *text;
    orr_answers *shown; // of the live page's thread
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
    atomic_bool loading;         // `next` is set: the service ends for it
    char next[128];
} serving;

// One scenario, from its preparation to the end of its service.
//   Given:    v              with c, talk, supervisor, log and journal set
//             path           of a scenario or an orbit product
//   Returned: asked_wrongly  true: the failure is a usage error
//             diag           why it failed; of OK, `v->loading` says whether another scenario is to follow
orr_status serving_run(serving *v, const char *path, bool *asked_wrongly, orr_diag *diag);
// A scenario's file in the folder of --scenarios, put into path[size].
const char *serving_path_of(const serving *v, const char *name, char *path, size_t size);
// Writes a line of the log for an orr_log whose user is a serving.
void serving_write_log(void *user, orr_log_level level, const char *line);

#endif

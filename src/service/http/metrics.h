// SPDX-License-Identifier: GPL-3.0-or-later
// What monitors ask: /metrics in Prometheus' text form, version 0.0.4, and /healthz.
#ifndef ORR_SERVICE_HTTP_METRICS_H
#define ORR_SERVICE_HTTP_METRICS_H

#include "src/service/http/http_server.h"
#include "src/service/live/streams.h"
#include "src/service/serve/service.h"

enum { ORR_METRICS_ROUTES = 2 };

// Where the numbers come from; borrowed.
typedef struct orr_metrics {
    const orr_service *service;
    orr_streams *streams; // NULL: none
    const char *version;
} orr_metrics;

// The two routes, whose user is *m.
void orr_metrics_routes(const orr_metrics *m, orr_http_route route[ORR_METRICS_ROUTES]);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/http/metrics.h"

#include <inttypes.h>
#include <string.h>
#include <unistd.h>

#include "core/monotonic.h"

static const double SILENT_S = 5; // a loop that has not come round for so long hangs

// One metric: what it is, its kind, its value.
static void put(FILE *out, const char *name, const char *kind, const char *help, double value)
{
    fprintf(out, "# HELP orrery_%s %s\n# TYPE orrery_%s %s\norrery_%s %.17g\n", name, help, name, kind, name,
            value);
}

// Bytes of memory that are the process's at present; -1 where that is not told.
static double resident_bytes(void)
{
    long all, resident = -1;
    FILE *f = fopen("/proc/self/statm", "r");
    if (f == NULL) return -1;
    if (fscanf(f, "%ld %ld", &all, &resident) != 2) resident = -1;
    fclose(f);
    return resident < 0 ? -1 : (double)resident * (double)sysconf(_SC_PAGESIZE);
}

static int answer_metrics(void *user, orr_http_ask *ask, FILE *out)
{
    (void)ask;
    const orr_metrics *m = user;
    const orr_service_counts c = orr_service_count(m->service);
    fprintf(out,
            "# HELP orrery_build_info What runs.\n# TYPE orrery_build_info gauge\n"
            "orrery_build_info{version=\"%s\"} 1\n",
            m->version);
    put(out, "uptime_seconds", "gauge", "Since the service listens.", c.uptime_s);
    put(out, "clients", "gauge", "Clients that are connected.", (double)c.clients);
    put(out, "clients_total", "counter", "Clients that have come in.", (double)c.came);
    put(out, "clients_refused_total", "counter",
        "Clients that were sent away, for want of room or of permission.", (double)c.refused);
    put(out, "requests_total", "counter", "Requests that were answered or refused.", (double)c.requests);
    put(out, "requests_refused_total", "counter", "Requests that were answered by ERROR.",
        (double)c.refusals);
    put(out, "clients_held_total", "counter", "How often a client had to wait for its rate.", (double)c.held);
    const double bytes = resident_bytes();
    if (bytes >= 0) put(out, "resident_bytes", "gauge", "Memory of the process.", bytes);
    if (m->streams != NULL) {
        orr_msg_time t;
        orr_streams_time(m->streams, &t);
        put(out, "scenario_time_seconds", "gauge", "The scenario's instant, seconds of GPS time.",
            (double)t.t * 1e-9);
        put(out, "scenario_clock_state", "gauge", "As TIME tells it (docs/protocol.md, clock_state).",
            t.state);
    }
    return 200;
}

static int answer_health(void *user, orr_http_ask *ask, FILE *out)
{
    (void)ask;
    const orr_metrics *m = user;
    const double silent_s = orr_service_count(m->service).silent_s;
    if (silent_s < SILENT_S) {
        fputs("ok\n", out);
        return 200;
    }
    fprintf(out, "the service's loop has not come round for %.0f s\n", silent_s);
    return 503;
}

void orr_metrics_routes(const orr_metrics *m, orr_http_route route[ORR_METRICS_ROUTES])
{
    void *user = (void *)(uintptr_t)m; // read alone
    route[0] = (orr_http_route){.path = "/metrics",
                                .type = "text/plain; version=0.0.4; charset=utf-8",
                                .answer = answer_metrics,
                                .user = user};
    route[1] = (orr_http_route){
        .path = "/healthz", .type = "text/plain; charset=utf-8", .answer = answer_health, .user = user};
}

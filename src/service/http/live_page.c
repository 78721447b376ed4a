// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/http/live_page.h"

#include <stdlib.h>
#include <string.h>

#include "proto/fields.h"
#include "src/service/text/json_line.h"
#include "src/service/text/json_value.h"
#include "src/service/text/message_text.h"

extern const char orr_live_page_html[]; // live_page.html, by cmake/OrrEmbed.cmake
extern const size_t orr_live_page_html_n;

enum { HTTP_OK = 200, HTTP_FAILED = 500 };
static const double EVERY_S = 0.5;

static int page_html(void *user, orr_http_ask *ask, FILE *out)
{
    (void)user, (void)ask;
    fwrite(orr_live_page_html, 1, orr_live_page_html_n, out);
    return HTTP_OK;
}

static int page_caps(void *user, orr_http_ask *ask, FILE *out)
{
    (void)ask;
    const orr_live_page *p = user;
    orr_msg_caps caps;
    orr_wire_writer w = {p->asked.room, 0, ORR_MSG_LARGEST, ORR_WIRE_OK};
    orr_server_caps(p->asked.server, 0, &w);
    if (orr_msg_caps_decode(w.data, (uint32_t)w.size, &caps) != ORR_WIRE_OK) return HTTP_FAILED;
    (void)orr_message_json(orr_message_of(ORR_MSG_TYPE_CAPS)->record, &caps, out);
    return HTTP_OK;
}

static int page_ask(void *user, orr_http_ask *ask, FILE *out)
{
    const orr_live_page *p = user;
    orr_json_line(&p->asked, ask->query, out);
    return HTTP_OK;
}

// --- Events ---

static void put_event(FILE *out, const char *name, json_t *data)
{
    fprintf(out, "event: %s\ndata: ", name);
    json_dumpf(data, out, JSON_COMPACT | JSON_REAL_PRECISION(17));
    fputs("\n\n", out);
    json_decref(data);
}

// The answer to a request as an event; nothing where it is refused.
static void put_answer(const orr_live_page *p, const char *name, uint16_t type, const orr_msg_any *request,
                       FILE *out)
{
    orr_server_refusal why;
    const orr_message_info *info;
    orr_msg_any m;
    if (orr_ask(&p->asked, type, request, 0, &info, &m, &why) != 0) return;
    fprintf(out, "event: %s\ndata: ", name);
    (void)orr_message_json(info->record, &m, out); // a line, with its end
    putc('\n', out);
}

static json_t *seconds_of(int64_t ns)
{
    return ns != ORR_TIME_NONE ? json_real((double)ns / 1e9) : json_null();
}

static json_t *json_of_stream(const orr_stream_look *x)
{
    const orr_message_info *info = orr_message_of(x->request);
    json_t *j = json_object();
    json_object_set_new(j, "request", orr_json_text(info != NULL ? info->name : "?"));
    json_object_set_new(j, "pacing", orr_json_text(orr_msg_pacing_name(x->pacing)));
    json_object_set_new(j, "lead_s", seconds_of(x->lead_ns));
    json_object_set_new(j, "made", orr_json_time(x->made));
    json_object_set_new(j, "blocks", json_integer((json_int_t)x->blocks));
    json_object_set_new(j, "gaps", json_integer((json_int_t)x->gaps));
    json_object_set_new(j, "credit", json_real((double)x->credit));
    json_object_set_new(j, "waiting", orr_json_count(x->waiting));
    json_object_set_new(j, "margin_s", seconds_of(x->margin_ns));
    json_object_set_new(j, "least_s", seconds_of(x->least_ns));
    return j;
}

static void put_clients(orr_live_page *p, FILE *out)
{
    const size_t all = orr_service_clients(p->service, p->client, ORR_CLIENTS_LOOKED);
    json_t *j = json_object(), *list = json_array();
    for (size_t k = 0; k < all && k < ORR_CLIENTS_LOOKED; k++) {
        const orr_client_look *c = &p->client[k];
        json_t *one = json_object(), *streams = json_array();
        json_object_set_new(one, "peer", orr_json_text(c->peer));
        json_object_set_new(one, "name", orr_json_text(c->name));
        json_object_set_new(one, "requests", json_integer((json_int_t)c->requests));
        json_object_set_new(one, "quiet_s", seconds_of(c->quiet_ns));
        for (size_t i = 0; i < c->n_streams && i < ORR_CLIENT_STREAMS; i++)
            json_array_append_new(streams, json_of_stream(&c->stream[i]));
        json_object_set_new(one, "n_streams", orr_json_count(c->n_streams));
        json_object_set_new(one, "streams", streams);
        json_array_append_new(list, one);
    }
    json_object_set_new(j, "n", orr_json_count(all));
    json_object_set_new(j, "clients", list);
    put_event(out, "clients", j);
}

static void put_lines(const orr_live_page *p, orr_http_ask *ask, FILE *out)
{
    static const char *const level[] = {"error", "warning", "info", "debug"};
    orr_journal_line line;
    while (orr_journal_next(p->journal, ask->seen, &line)) {
        ask->seen = line.number;
        json_t *j = json_object();
        json_object_set_new(j, "number", json_integer((json_int_t)line.number));
        json_object_set_new(j, "unix_s", json_integer(line.unix_s));
        json_object_set_new(j, "level", orr_json_text(level[line.level]));
        json_object_set_new(j, "text", orr_json_text(line.text));
        put_event(out, "line", j);
    }
}

// The number that a query of the form a=1&b=2 gives a name; 0 without.
static uint16_t number_of(const char *query, const char *name)
{
    const size_t n = strlen(name);
    for (const char *at = query; at != NULL; at = strchr(at, '&')) {
        if (*at == '&') at++;
        if (strncmp(at, name, n) == 0 && at[n] == '=') return (uint16_t)strtoul(at + n + 1, NULL, 10);
    }
    return 0;
}

static int page_events(void *user, orr_http_ask *ask, FILE *out)
{
    orr_live_page *p = user;
    const orr_msg_any nothing = {.get_time = {0}};
    orr_msg_time now;
    orr_streams_time(p->asked.streams, &now);
    const orr_msg_epochs epochs = {now.t, 0, 1};
    const orr_msg_any channels = {
        .poll_channels = {.epochs = epochs, .antenna = number_of(ask->query, "antenna"), .terms = 1}};
    const orr_msg_any truth = {.poll_truth = {epochs, number_of(ask->query, "unit")}};
    put_answer(p, "time", ORR_MSG_TYPE_GET_TIME, &nothing, out);
    put_answer(p, "motion", ORR_MSG_TYPE_GET_MOTION_STATS, &nothing, out);
    put_answer(p, "channels", ORR_MSG_TYPE_POLL_CHANNELS, &channels, out);
    put_answer(p, "truth", ORR_MSG_TYPE_POLL_TRUTH, &truth, out);
    put_clients(p, out);
    put_lines(p, ask, out);
    return HTTP_OK;
}

orr_status orr_live_page_open(const orr_server *server, orr_streams *streams, const orr_leap_table *leap,
                              orr_service *service, orr_journal *journal, orr_live_page **page,
                              orr_http_route *route)
{
    orr_live_page *p = calloc(1, sizeof *p);
    if (p != NULL)
        *p = (orr_live_page){.asked = {.server = server,
                                       .streams = streams,
                                       .leap = leap,
                                       .may = ORR_MAY_READ,
                                       .most_epochs = ORR_LIVE_PAGE_EPOCHS,
                                       .room = malloc(ORR_MSG_LARGEST)},
                             .service = service,
                             .journal = journal};
    if (p == NULL || p->asked.room == NULL) {
        orr_live_page_close(p);
        return ORR_E_MEMORY;
    }
    const orr_http_route mine[ORR_LIVE_PAGE_ROUTES] = {
        {"/", "text/html; charset=utf-8", 0, page_html, p},
        {"/caps", "application/json", 0, page_caps, p},
        {"/ask", "application/x-ndjson", 0, page_ask, p},
        {"/events", "text/event-stream", EVERY_S, page_events, p},
    };
    memcpy(route, mine, sizeof mine);
    *page = p;
    return ORR_OK;
}

void orr_live_page_close(orr_live_page *page)
{
    if (page == NULL) return;
    free(page->asked.room);
    free(page);
}

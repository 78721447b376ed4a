// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/monotonic.h"
#include "src/cli/service/serving.h"
#include "src/cli/service/serving_ports.h"
#include "src/service/net/url.h"

// A scenario's file in the folder of --scenarios, put into path[size].
static const char *path_of(const serving *v, const char *name, char *path, size_t size)
{
    snprintf(path, size, "%.4000s/%.100s.yaml", orr_cli_text(v->c, "scenarios", "."), name);
    return path;
}

// Where the scenario's clock begins: --from, else the first instant that is served.
static orr_time begin_of(const serving *v)
{
    orr_time first, last;
    orr_engine_span(v->world.engine, &first, &last);
    if (v->n_kept > 0) return v->from != ORR_TIME_NONE ? v->from : first;
    return orr_cli_time(v->c, "from", first);
}

// The scenario's clock goes: at an instant of the wall, or at once.
static orr_status start_clock(const serving *v, orr_time at, orr_diag *diag)
{
    const orr_msg_control m = {.action = ORR_MSG_CONTROL_ACTION_START, .t = ORR_TIME_NONE, .at = at};
    orr_msg_time told;
    orr_server_refusal why;
    if (orr_streams_control(v->streams, &m, &told, &why) == 0) return ORR_OK;
    return orr_diag_set(diag, ORR_E_ARG, "--start: %s", why.sentence);
}

// One that was loaded stands until it is started.
static bool starts_at_once(const serving *v)
{
    return v->n_kept == 0 && strcmp(orr_cli_text(v->c, "start", "now"), "now") == 0;
}

// What is told once the service can be reached; scripts wait for this line, so --quiet does not silence it.
static void say_ready(void *user)
{
    serving *v = user;
    serving_world_close(&v->past);
    if (starts_at_once(v)) (void)start_clock(v, ORR_TIME_NONE, NULL); // it stands, so it can
    char text[8192], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    const orr_sat *sats;
    orr_time t0, t1;
    orr_engine_span(v->world.engine, &t0, &t1);
    size_t at = (size_t)snprintf(text, sizeof text, ORR_ID("R01") "ready on");
    const char *url;
    for (size_t i = 0; (url = orr_service_url(v->service, i)) != NULL && at + strlen(url) + 200 < sizeof text;
         i++)
        at += (size_t)snprintf(text + at, sizeof text - at, " %s", url);
    if (v->port != NULL)
        at += (size_t)snprintf(text + at, sizeof text - at, " with motion by UDP on %s",
                               orr_motion_port_where(v->port));
    if (v->text != NULL)
        at +=
            (size_t)snprintf(text + at, sizeof text - at, " and as text on %s", orr_text_server_url(v->text));
    if (v->http != NULL)
        at += (size_t)snprintf(text + at, sizeof text - at, " with the live page at %s",
                               orr_http_server_url(v->http));
    at = serving_ports_say(v, text, sizeof text - 200, at);
    size_t n = orr_engine_satellites(v->world.engine, &sats), units = orr_engine_units(v->world.engine);
    if (n > 0)
        at += (size_t)snprintf(text + at, sizeof text - at, " (%zu satellites, ", n);
    else
        at += (size_t)snprintf(text + at, sizeof text - at, " (%zu inertial unit%s, ", units,
                               units == 1 ? "" : "s");
    snprintf(text + at, sizeof text - at, "%s to %s)", orr_time_text(t0, from), orr_time_text(t1, to));
    orr_serve_log_say(&v->talk, text);
    (void)orr_supervisor_say("READY=1");
}

// A scenario is exchanged with all that is connected to it: not while a recording of its motion is written or read, which would begin anew.
static bool may_remake(const serving *v)
{
    return !orr_cli_given(v->c, "motion-log") && !orr_cli_given(v->c, "motion-replay");
}

static void remake(serving *v)
{
    orr_diag diag = {0};
    v->remake.c = v->c;
    v->remake.log = &v->log;
    v->remake.mark = v->world.mark;
    snprintf(v->remake.path, sizeof v->remake.path, "%s", v->path);
    if (serving_remake_begin(&v->remake, &diag) == ORR_OK) return;
    ORR_LOG(&v->log, ORR_LOG_ERROR, ORR_ID("R11") "SIGHUP: %s; the scenario before is served on", diag.text);
    (void)orr_supervisor_say("READY=1");
}

// SIGHUP: who may come in is read again, all of it or nothing; then the scenario, beside the service.
static void reload(void *user)
{
    serving *v = user;
    char told[1024];
    orr_diag diag = {0};
    if (v->stopping) return;
    snprintf(told, sizeof told, "RELOADING=1\nMONOTONIC_USEC=%lld", (long long)(orr_monotonic_ns() / 1000));
    (void)orr_supervisor_say(told);
    if (orr_access_reload(v->world.access, &diag) == ORR_OK) {
        ORR_LOG(&v->log, ORR_LOG_INFO, ORR_ID("R05") "SIGHUP: the access file has been read again");
        orr_service_readmit(v->service);
        v->again = v->remake.running;
        if (v->again) return;
        if (may_remake(v)) {
            remake(v);
            return;
        }
        ORR_LOG(&v->log, ORR_LOG_WARN,
                ORR_ID("R12") "SIGHUP: the scenario is not read again while motion is recorded or replayed");
    } else {
        ORR_LOG(&v->log, ORR_LOG_ERROR, ORR_ID("R06") "SIGHUP: %s; what was there before still holds",
                orr_diag_format(&diag, told, sizeof told));
    }
    (void)orr_supervisor_say("READY=1");
}

// The scenario that was read again has come to something: it is exchanged as a whole, or what was there before holds.
static void take_remade(serving *v)
{
    char told[1024];
    if (v->again) {
        v->again = false;
        if (v->remake.status == ORR_OK) serving_world_close(&v->remake.world);
        remake(v);
        return;
    }
    if (v->remake.status == ORR_OK && !v->remake.same && !atomic_exchange(&v->loading, true)) {
        ORR_LOG(&v->log, ORR_LOG_INFO,
                ORR_ID("R10") "SIGHUP: the scenario has been read again, and is served from now on");
        orr_service_stop(v->service);
        return;
    }
    if (v->remake.status != ORR_OK)
        ORR_LOG(&v->log, ORR_LOG_ERROR, ORR_ID("R11") "SIGHUP: %s; the scenario before is served on",
                orr_diag_format(&v->remake.diag, told, sizeof told));
    serving_world_close(&v->remake.world);
    (void)orr_supervisor_say("READY=1");
}

static void beat(void *user, int64_t now_ns)
{
    serving *v = user;
    orr_supervisor_alive(&v->supervisor, now_ns);
    if (!v->stopping && serving_remake_ended(&v->remake)) take_remade(v);
}

static void say_stopping(void *user)
{
    serving *v = user;
    v->stopping = true;
    if (!atomic_load(&v->loading)) (void)orr_supervisor_say("STOPPING=1");
}

// The addresses are taken before anything that lasts: one in use is told at once.
static orr_status listen_on(serving *v, orr_diag *diag)
{
    const orr_text_list *listen = &v->world.scenario.serve.listen;
    orr_service_options options = orr_service_defaults();
    const size_t n = v->n_kept > 0 ? v->n_kept : orr_cli_count(v->c, "listen");
    v->url = calloc(n > 0 ? n : 1, sizeof *v->url);
    if (v->url == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t i = 0; i < n; i++)
        v->url[i] = v->n_kept > 0 ? v->kept[i] : orr_cli_text_at(v->c, "listen", i);
    options.url = n > 0 ? v->url : (const char *const *)listen->item;
    options.n_urls = n > 0 ? n : listen->n;
    options.user = v;
    options.hangup = reload;
    options.beat = beat;
    options.stopping = say_stopping;
    orr_handed_socket handed[ORR_SUPERVISOR_SOCKETS];
    orr_service_socket sockets[ORR_SUPERVISOR_SOCKETS];
    // --listen overrules them. The service closes its own; a scenario that is loaded later is served on the same.
    options.n_sockets = orr_cli_count(v->c, "listen") == 0 ? orr_supervisor_sockets(handed) : 0;
    for (size_t i = 0; i < options.n_sockets; i++)
        sockets[i] = (orr_service_socket){fcntl(handed[i].fd, F_DUPFD_CLOEXEC, 0), handed[i].tls};
    options.socket = sockets;
    options.access = v->world.access;
    const orr_access_limits limits = orr_access_limits_of(v->world.access);
    options.max_clients = (int)orr_cli_int(v->c, "max-clients", limits.clients);
    options.idle_s = limits.idle_s;
    options.first_s = limits.first_s;
    const char *pages = orr_cli_text(v->c, "http", NULL);
    orr_status s = ORR_OK;
    if (pages != NULL) s = orr_http_server_listen(pages, &v->http, diag);
    const char *motion = orr_cli_text(v->c, "motion-udp", NULL);
    if (s == ORR_OK && motion != NULL)
        s = orr_motion_port_listen(motion, orr_dialect_of(orr_cli_text(v->c, "dialect", "orrery")), &v->port,
                                   diag);
    if (s != ORR_OK) return s;
    return orr_service_open(&options, NULL, &v->log, &v->service, diag);
}

// The body that antennas ride on: its motion from clients, or from a recording.
static orr_status open_vehicle(serving *v, orr_diag *diag)
{
    const char *out = orr_cli_text(v->c, "motion-log", NULL), *in = orr_cli_text(v->c, "motion-replay", NULL);
    orr_vehicle_options live = {.join_s = orr_cli_real(v->c, "join", 65) / 1000,
                                .length_ns = orr_cli_int(v->c, "motion-block", 5) * 1000000};
    orr_status s = ORR_OK;
    if (out != NULL) s = orr_motion_log_create(out, &v->log_out, diag);
    if (s == ORR_OK && in != NULL) s = orr_motion_log_open(in, &v->log_in, diag);
    if (out != NULL) live.record = orr_motion_log_write, live.record_user = v->log_out;
    if (in != NULL) live.replay = orr_motion_log_read, live.replay_user = v->log_in;
    if (s == ORR_OK) s = orr_vehicle_open(&live, &v->vehicle, diag);
    return s == ORR_OK ? orr_answers_ride(v->maker, v->vehicle, diag) : s;
}

// CONTROL LOAD: a name of the folder of scenarios, never a path. The service ends, and begins anew with it.
static uint16_t load_other(void *user, const char *name, orr_time t, orr_server_refusal *why)
{
    serving *v = user;
    static const char good[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
    char path[4200];
    if (strspn(name, good) != strlen(name)) {
        snprintf(why->sentence, sizeof why->sentence,
                 "CONTROL: the name of a scenario has letters, digits, _ and - alone");
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    (void)path_of(v, name, path, sizeof path);
    if (access(path, R_OK) != 0) {
        snprintf(why->sentence, sizeof why->sentence, "CONTROL: there is no scenario '%.64s'", name);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    if (atomic_exchange(&v->loading, true)) {
        snprintf(why->sentence, sizeof why->sentence, "CONTROL: another scenario is being loaded");
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    snprintf(v->next, sizeof v->next, "%.64s", name);
    v->from = t;
    orr_service_stop(v->service);
    return 0;
}

// Streams, made by a thread of their own, and the scenario's clock.
static orr_status open_streams(serving *v, orr_diag *diag)
{
    orr_status s = orr_answers_open(v->world.engine, &v->maker, diag);
    if (s == ORR_OK) s = orr_answers_look_ahead(v->maker, diag);
    if (s == ORR_OK && (orr_cli_given(v->c, "motion") || orr_cli_given(v->c, "motion-replay")))
        s = open_vehicle(v, diag);
    if (s != ORR_OK) return s;
    const orr_streams_options o = {.maker = orr_answers_server(v->maker),
                                   .expect = orr_answers_expect,
                                   .load = orr_cli_given(v->c, "scenarios") ? load_other : NULL,
                                   .load_user = v,
                                   .wake = orr_service_wake,
                                   .wake_user = v->service,
                                   .begin = begin_of(v),
                                   .clock = v->clock,
                                   .leap = v->c->leap,
                                   .vehicle = v->vehicle,
                                   .priority = (int)orr_cli_int(v->c, "priority", 0),
                                   .processor = (int)orr_cli_int(v->c, "processor", -1),
                                   .lock_memory = orr_cli_given(v->c, "lock-memory")};
    s = orr_streams_open(&o, &v->streams, diag);
    if (s != ORR_OK) return s;
    orr_service_stream(v->service, v->streams);
    const char *when = orr_cli_text(v->c, "start", "now");
    orr_time at;
    if (starts_at_once(v) || v->n_kept > 0 || strcmp(when, "command") == 0) return ORR_OK;
    s = orr_time_parse(when, v->c->leap, &at, diag);
    return s == ORR_OK ? start_clock(v, at, diag) : s;
}

// The text twin, by a thread and answers of its own.
static orr_status open_text(serving *v, orr_diag *diag)
{
    const char *url = orr_cli_text(v->c, "text", NULL);
    if (url == NULL) return ORR_OK;
    const orr_status s = orr_answers_open(v->world.engine, &v->reader, diag);
    if (s != ORR_OK) return s;
    const orr_asked asked = {.server = orr_answers_server(v->reader),
                             .streams = v->streams,
                             .leap = v->c->leap,
                             .may = ORR_MAY_ALL,
                             .log = &v->log};
    return orr_text_server_open(url, &asked, v->world.access, &v->text, diag);
}

// The live page, by a thread and answers of its own.
static orr_status open_page(serving *v, orr_diag *diag)
{
    orr_http_route route[ORR_LIVE_PAGE_ROUTES + ORR_METRICS_ROUTES];
    if (v->http == NULL) return ORR_OK;
    orr_status s = orr_answers_open(v->world.engine, &v->shown, diag);
    if (s == ORR_OK)
        s = orr_live_page_open(orr_answers_server(v->shown), v->streams, v->c->leap, v->service, v->journal,
                               &v->page, route);
    v->metrics = (orr_metrics){v->service, v->streams, ORR_VERSION};
    orr_metrics_routes(&v->metrics, route + ORR_LIVE_PAGE_ROUTES);
    return s == ORR_OK ? orr_http_server_start(v->http, route, sizeof route / sizeof route[0], diag) : s;
}

// What the service says goes to stderr, and to the page where there is one.
void serving_write_log(void *user, orr_log_level level, const char *line)
{
    serving *v = user;
    orr_serve_log_write(&v->talk, level, line);
    if (v->journal != NULL) orr_journal_write(v->journal, level, line);
}

static orr_status make_engine(serving *v, orr_diag *diag)
{
    const size_t files = v->world.scenario.orbit.sp3.n;
    if (files > 0) orr_cli_say(v->c, "smoothing %zu file%s", files, files == 1 ? "" : "s");
    orr_warnings warnings = {0};
    const orr_status s = serving_world_make(&v->world, v->c->log, NULL, &warnings, diag);
    orr_cli_warnings(v->c, &warnings);
    orr_warnings_free(&warnings);
    return s;
}

static orr_status prepare(serving *v, orr_diag *diag)
{
    const bool made = v->world.engine != NULL;
    orr_status s = made ? ORR_OK : serving_world_read(v->c, v->path, &v->world, diag);
    if (s == ORR_OK) s = listen_on(v, diag);
    if (s == ORR_OK && !made) s = make_engine(v, diag);
    if (s == ORR_OK) s = orr_answers_open(v->world.engine, &v->answers, diag);
    if (s == ORR_OK) orr_service_provide(v->service, orr_answers_server(v->answers));
    if (s == ORR_OK) s = open_streams(v, diag);
    if (s == ORR_OK) s = open_text(v, diag);
    if (s == ORR_OK) s = open_page(v, diag);
    if (s == ORR_OK) s = serving_ports(v, diag);
    if (s == ORR_OK && v->port != NULL)
        s = orr_motion_port_start(v->port, v->streams, orr_service_datagrams(v->service), diag);
    return s;
}

// Where it is served, for a scenario that is loaded after this one.
static void keep_urls(serving *v)
{
    const char *url;
    if (v->service == NULL) return;
    v->n_kept = 0;
    while (v->n_kept < 16 && (url = orr_service_url(v->service, v->n_kept)) != NULL)
        snprintf(v->kept[v->n_kept++], sizeof v->kept[0], "%s", url);
}

orr_status serving_run(serving *v, bool *asked_wrongly, orr_diag *diag)
{
    v->stopping = v->again = false;
    orr_status s = prepare(v, diag);
    *asked_wrongly = s == ORR_E_ARG && v->service == NULL && v->url != NULL; // --listen, or serve.listen
    if (s == ORR_OK) s = orr_service_run(v->service, say_ready, v, diag);
    if (v->service != NULL && orr_service_signalled(v->service)) atomic_store(&v->loading, false);
    serving_remake_cancel(&v->remake);
    keep_urls(v);
    orr_motion_port_close(v->port);
    orr_text_server_close(v->text);
    orr_port_server_close(v->ports);
    orr_answers_close(v->reader);
    orr_http_server_close(v->http);
    orr_live_page_close(v->page);
    orr_answers_close(v->shown);
    if (v->streams != NULL) {
        v->clock = orr_streams_clock(v->streams);
        v->begun = orr_streams_begin(v->streams);
    }
    orr_streams_halt(v->streams);
    orr_service_close(v->service);
    orr_streams_close(v->streams);
    orr_answers_close(v->maker);
    orr_vehicle_close(v->vehicle);
    if (s == ORR_OK && v->log_in != NULL && orr_motion_log_fault(v->log_in) != NULL)
        s = orr_diag_at(diag, ORR_E_FORMAT, orr_cli_text(v->c, "motion-replay", ""), 0, 0, "%s",
                        orr_motion_log_fault(v->log_in));
    (void)orr_motion_log_close(v->log_in, NULL);
    const orr_status written = orr_motion_log_close(v->log_out, s == ORR_OK ? diag : NULL);
    if (s == ORR_OK) s = written;
    orr_answers_close(v->answers);
    free(v->url);
    v->port = NULL, v->text = NULL, v->ports = NULL, v->reader = NULL, v->http = NULL, v->page = NULL;
    v->shown = NULL;
    v->streams = NULL, v->service = NULL, v->maker = NULL, v->vehicle = NULL;
    v->log_in = v->log_out = NULL, v->answers = NULL, v->url = NULL;
    return s;
}

// The clock of a scenario that was read again goes on, if the new one has its instant.
static void keep_clock(serving *v)
{
    orr_time first, last;
    orr_engine_span(v->world.engine, &first, &last);
    const orr_time now = orr_clock_at(&v->clock, orr_monotonic_ns());
    const bool within = v->clock.state != ORR_CLOCK_STOPPED && now >= first && now <= last;
    if (!within) v->clock = (orr_clock){0};
    v->from = within || (v->begun >= first && v->begun <= last) ? v->begun : ORR_TIME_NONE;
}

orr_status serving_next(serving *v, orr_diag *diag)
{
    char before[sizeof v->path];
    bool asked_wrongly;
    const orr_time begun = v->begun;
    const orr_clock clock = v->remake.world.engine != NULL ? v->clock : (orr_clock){0};
    memcpy(before, v->path, sizeof before);
    v->past = v->world;
    v->world = v->remake.world;
    v->remake.world = (serving_world){0};
    if (v->world.engine != NULL) {
        keep_clock(v);
    } else {
        v->clock = (orr_clock){0};
        (void)path_of(v, v->next, v->path, sizeof v->path);
    }
    orr_status s = serving_run(v, &asked_wrongly, diag);
    if (s == ORR_OK || v->past.engine == NULL) return s;
    char told[1024];
    ORR_LOG(&v->log, ORR_LOG_WARN, "%s; going back to %s", orr_diag_format(diag, told, sizeof told), before);
    serving_world_close(&v->world);
    v->world = v->past;
    v->past = (serving_world){0};
    v->from = begun;
    v->clock = clock;
    memcpy(v->path, before, sizeof before);
    return serving_run(v, &asked_wrongly, diag);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll: the command-line client of a service.
#include <stdio.h>
#include <time.h>

#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/service/message_show.h"
#include "src/cli/service/poll_ask.h"
#include "src/cli/service/poll_latency.h"
#include "src/cli/service/poll_pages.h"
#include "src/service/net/dial.h"
#include "src/service/text/message_text.h"

typedef struct poll_job {
    orr_cli *c;
    orr_dial *d;
    orr_time t;
    int64_t step_ns, count; // count < 0: until interrupted
    orr_msg_sat_id id[ORR_MSG_MAX_SATELLITES];
    uint16_t n_ids; // 0: all
    orr_poll_request request;
    orr_show_format format;
    bool headed;
    char frame[65];   // of CAPS, for the table's head
    uint64_t numbers; // satellites (or epochs) that had what was asked for
    bool outside;     // an epoch was outside the span
    bool no_memory;   // to show an answer
    poll_latency latency;
} poll_job;

// --- Asking ---

static void *member(void *m, const orr_record *r, const char *name)
{
    const orr_field *f = orr_record_field(r, name);
    return f != NULL ? (char *)m + f->offset : NULL;
}

static orr_wire_status send_request(poll_job *p, orr_time t, uint32_t count)
{
    const orr_message_info *info = p->request.info;
    orr_msg_epochs *epochs = member(&p->request.m, info->record, "epochs");
    orr_msg_sat_id_list *satellites = member(&p->request.m, info->record, "satellites");
    *epochs = (orr_msg_epochs){t, p->step_ns, count};
    if (satellites != NULL) *satellites = (orr_msg_sat_id_list){.count = p->n_ids, .item = p->id};
    orr_wire_writer w;
    size_t start;
    orr_client_begin(&p->d->client, info->type, &w, &start);
    info->encode(&p->request.m, &w);
    orr_client_expect(&p->d->client, count);
    return orr_client_send(&p->d->client, &w, start);
}

static orr_wire_status take_answer(poll_job *p)
{
    const orr_message_info *info = orr_message_of(p->request.info->answer);
    orr_frame f;
    orr_msg_any m;
    orr_wire_status ws = orr_client_answer(&p->d->client, info->type, &f);
    if (ws == ORR_WIRE_OK) ws = info->decode(f.payload, f.size, &m);
    const orr_msg_epoch *epoch = member(&m, info->record, "epoch");
    if (ws == ORR_WIRE_OK) ws = orr_client_epoch(&p->d->client, epoch->index, epoch->count);
    if (ws != ORR_WIRE_OK) return ws;
    if (p->latency.path != NULL) poll_latency_end(&p->latency); // before it is printed
    p->outside = p->outside || epoch->answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
    p->numbers += orr_message_numbers(info->record, &m);
    if (p->request.pages)
        orr_poll_pages(&m.navdata, &p->headed);
    else
        p->no_memory = !orr_message_show(info, &m, p->format, p->frame, &p->headed);
    return ORR_WIRE_OK;
}

static orr_status ask(poll_job *p, orr_time t, uint32_t count, orr_diag *diag)
{
    if (p->latency.path != NULL) poll_latency_begin(&p->latency);
    orr_wire_status ws = send_request(p, t, count);
    for (uint32_t k = 0; k < count && ws == ORR_WIRE_OK && !p->no_memory; k++) ws = take_answer(p);
    if (p->no_memory) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    return ws == ORR_WIRE_OK ? ORR_OK : orr_dial_status(p->d, ws, p->request.info->name, diag);
}

// As many epochs a request as the server allows.
static orr_status ask_all(poll_job *p, uint32_t most, orr_diag *diag)
{
    orr_time t = p->t;
    for (int64_t left = p->count; left > 0;) {
        uint32_t n = left > (int64_t)most ? most : (uint32_t)left;
        orr_status s = ask(p, t, n, diag);
        if (s != ORR_OK) return s;
        left -= n;
        t += p->step_ns * (int64_t)n;
    }
    return ORR_OK;
}

// One epoch a step of the clock on the wall, as a signal generator does. Late polls are not dropped.
static orr_status ask_in_real_time(poll_job *p, orr_diag *diag)
{
    struct timespec next;
    clock_gettime(CLOCK_MONOTONIC, &next);
    for (int64_t k = 0; p->count < 0 || k < p->count; k++) {
        orr_status s = ask(p, p->t + k * p->step_ns, 1, diag);
        if (s != ORR_OK) return s;
        if (p->outside && p->count < 0) return ORR_OK;
        fflush(stdout);
        int64_t ns = next.tv_nsec + p->step_ns % ORR_NS_PER_S;
        next.tv_sec += (time_t)(p->step_ns / ORR_NS_PER_S + ns / ORR_NS_PER_S);
        next.tv_nsec = (long)(ns % ORR_NS_PER_S);
        if (p->count < 0 || k + 1 < p->count) clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, NULL);
    }
    return ORR_OK;
}

// A user's list as the wire's: of a whole system those served; satellites named one by one as they are, so
// that the server says of each what it lacks.
static int choose_sats(poll_job *p, const orr_msg_caps *caps)
{
    const orr_sat_set *set = orr_cli_sats(p->c, "sat");
    if (set == NULL) return ORR_EXIT_OK;
    for (const char *system = ORR_SYSTEMS; *system != '\0'; system++) {
        int asked = 0;
        for (int n = 1; n <= 99; n++) asked += orr_sat_set_has(set, orr_sat_make(*system, n));
        if (asked == 99) {
            orr_msg_sat_id id;
            orr_wire_iter it = {0};
            while (orr_msg_sat_id_next(&caps->satellites, &it, &id))
                if (id.system == (uint8_t)*system && p->n_ids < ORR_MSG_MAX_SATELLITES)
                    p->id[p->n_ids++] = id;
            continue;
        }
        for (int n = 1; n <= 99 && p->n_ids < ORR_MSG_MAX_SATELLITES; n++)
            if (orr_sat_set_has(set, orr_sat_make(*system, n)))
                p->id[p->n_ids++] = (orr_msg_sat_id){(uint8_t)*system, (uint8_t)n};
    }
    return p->n_ids > 0 ? ORR_EXIT_OK : orr_cli_failf(p->c, "%s serves none of these satellites", p->d->url);
}

static int poll_service(poll_job *p)
{
    orr_cli *c = p->c;
    orr_diag diag = {0};
    orr_msg_caps caps;
    orr_wire_status ws = orr_client_open(&p->d->client, "orrery poll", ORR_VERSION, &caps);
    if (ws != ORR_WIRE_OK) {
        (void)orr_dial_status(p->d, ws, "HELLO", &diag);
        return orr_cli_fail(c, &diag);
    }
    orr_wire_text_copy(caps.frame, p->frame, sizeof p->frame);
    p->t = orr_cli_time(c, "at", caps.span.first);
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    orr_time_text(caps.span.first, from);
    orr_time_text(caps.span.last, to);
    uint32_t most = caps.max_epochs > 0 ? caps.max_epochs : 1;
    int status = choose_sats(p, &caps); // the caps are the buffer's until the next request
    if (status != ORR_EXIT_OK) return status;
    orr_status s = orr_cli_given(c, "realtime") ? ask_in_real_time(p, &diag) : ask_all(p, most, &diag);
    if (s == ORR_OK) s = poll_latency_write(c, &p->latency, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (p->numbers > 0) return ORR_EXIT_OK;
    bool moving =
        p->request.info->type == ORR_MSG_TYPE_POLL_IMU || p->request.info->type == ORR_MSG_TYPE_POLL_TRUTH;
    if (moving) return orr_cli_failf(c, "the trajectory does not reach there");
    if (p->outside && p->request.info->type == ORR_MSG_TYPE_POLL_DELAYS)
        return orr_cli_failf(
            c,
            "nothing there: %s serves orbits of %s to %s, and delays where its ionosphere and "
            "the scenario's receiver are there too",
            p->d->url, from, to);
    if (p->outside) return orr_cli_failf(c, "nothing there: %s serves %s to %s", p->d->url, from, to);
    if (p->request.info->type == ORR_MSG_TYPE_POLL_EVENTS) return ORR_EXIT_OK; // nothing happens
    return orr_cli_failf(c, "no satellite has %s there", p->request.what);
}

static int run(orr_cli *c)
{
    bool realtime = orr_cli_given(c, "realtime"), imu = orr_cli_given(c, "imu"),
         events = orr_cli_given(c, "events");
    poll_job p = {.c = c,
                  .step_ns = orr_cli_duration_ns(c, "step",
                                                 imu      ? 0
                                                 : events ? 3600 * ORR_NS_PER_S
                                                          : ORR_NS_PER_S),
                  .count = orr_cli_int(c, "count", realtime ? -1 : 1),
                  .latency = {.path = orr_cli_text(c, "latency", NULL)},
                  .format = orr_cli_says(c, "format", "json")  ? ORR_AS_JSON
                            : orr_cli_says(c, "format", "csv") ? ORR_AS_CSV
                                                               : ORR_AS_TABLE};
    if (p.count > 1 && !orr_cli_given(c, "step") && !imu && !events)
        return orr_cli_usage(c, "--count %lld needs a --step", (long long)p.count);
    int asked = orr_poll_ask(c, &p.request);
    if (asked != ORR_EXIT_OK) return asked;
    orr_diag diag = {0};
    orr_status s =
        orr_dial_open(c->operand[0], orr_cli_text(c, "identity", NULL),
                      (double)orr_cli_duration_ns(c, "timeout", 10 * ORR_NS_PER_S) * 1e-9, &p.d, &diag);
    if (s == ORR_E_ARG) return orr_cli_usage(c, "%s", diag.text);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    int status = poll_service(&p);
    orr_dial_close(p.d);
    return status;
}

static const orr_option options[] = {
    ORR_OPTION_IDENTITY(),
    ORR_OPTION_AT(
            .help =
                "First epoch, GPS time unless marked otherwise; the begin of the served span by default."),
    ORR_OPTION_STEP(.help = "Time from one epoch to the next; 1 s by default, with --imu the scenario's "
                            "interval, with --events an hour."),
    {.name = "count",
     .letter = 'n',
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 1e9,
     .help = "Number of epochs; 1 by default, with --realtime until interrupted or past the span."},
    ORR_OPTION_SATS_AS(.applies = "!imu,!truth",
                       .help = "Satellites, e.g. G05,R,E01-E09; all that are served by default."),
    ORR_POLL_OPTIONS,
    {.name = "realtime",
     .kind = ORR_OPT_FLAG,
     .help = "Ask for one epoch a step of real time, as a signal generator does."},
    {.name = "latency",
     .applies = "realtime",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .writes = true,
     .help = "Write how long answers took, from sending the request until its answer was read, as a "
             "histogram (CSV) "
             "with eight bins an octave; where --count or the span ends."},
    {.name = "timeout",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Give up when the server is silent for so long; 10 s by default."},
    ORR_OPTION_FORMAT_AS(
        "table|csv|json", "table",
        .help = "A table (default); CSV, a row for each satellite, blank where there is no number; or a JSON "
                "object an epoch and line. The latter two have the protocol's names of fields."),
};

const orr_command orr_cmd_poll = {
    .name = "poll",
    .group = "Service",
    .summary = "ask a service for satellite states and more",
    .operands = "URL",
    .min_operands = 1,
    .max_operands = 1,
    .about =
        "Prints position and velocity in the terrestrial frame of the orbits, clock offset (periodic "
        "relativity not "
        "included) and 1-sigma of the position. Where a satellite has no valid arc, or the time is "
        "outside the served "
        "span, it says so instead of a number; exit status 1 if there was no number at all.\n\n"
        "With --delays: azimuth, elevation, pierce point, slant electron content and the delay of a "
        "code on each carrier "
        "(a carrier phase is early by as much), and what it came from. Without --receiver it is the "
        "scenario's own; of a scenario with a trajectory, where the trajectory is at each epoch, so that "
        "satellites and inertial readings (--imu) are of one flight.\n\n"
        "With --elements: Kepler elements; as CSV in the columns of `orrery elements`, and what was "
        "answered.\n\n"
        "With --navdata: what satellites broadcast, fitted to the orbits that are served "
        "(as `orrery navfit` does): the sets, whole as CSV and JSON, or with --pages the bits as CSV. "
        "Asked "
        "every 30 s it is all that they send.",
    .example = "orrery poll tcp://127.0.0.1:15754 --at 2024-02-04T12:00:00 --sat G05,E\n"
               "orrery poll unix:/tmp/orrery.sock --step 0.1 --count 100 --format json\n"
               "orrery poll tcp://127.0.0.1:15754 --step 0.1 --realtime --sat G\n"
               "orrery poll tcp://127.0.0.1:15754 --step 0.01 --count 1000 --realtime --latency latency.csv\n"
               "orrery poll tcp://127.0.0.1:15754 --delays --receiver 52.28,17.07,124 --carrier 1575.42 "
               "--carrier 1176.45\n"
               "orrery poll tcp://127.0.0.1:15754 --elements --method mean --step 3600 --count 12 --sat G05\n"
               "orrery poll tcp://127.0.0.1:15754 --navdata --pages --step 30 --count 25 --sat G05,R07",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

// SPDX-License-Identifier: GPL-3.0-or-later
// orrery record: a stream of a service into a log, frame by frame as it comes.
#include <stdio.h>
#include <string.h>

#include "core/outfile.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/service/poll_ask.h"
#include "src/cli/service/record_log.h"
#include "src/service/net/dial_port.h"

enum { CREDIT = 256, TAIL_MS = 100 };

typedef struct record_job {
    orr_cli *c;
    orr_dial *d;
    orr_dial_port *port; // of datagrams; NULL: frames of the connection
    FILE *out;
    uint64_t blocks, left_out;
    uint32_t spent; // blocks that have had credit and are not renewed
    bool failed;    // to write
} record_job;

static void keep(record_job *j, const uint8_t *data, size_t n)
{
    if (fwrite(data, 1, n, j->out) != n) j->failed = true;
}

// SUBSCRIBE, as it is sent and into the log.
static orr_wire_status subscribe(record_job *j, const orr_poll_request *r)
{
    static uint8_t payload[16384];
    orr_msg_any request = r->m;
    orr_msg_epochs *epochs =
        (orr_msg_epochs *)(void *)((char *)&request + orr_record_field(r->info->record, "epochs")->offset);
    const bool blocks = r->info->type == ORR_MSG_TYPE_POLL_CHANNELS;
    *epochs = (orr_msg_epochs){orr_cli_time(j->c, "from", ORR_TIME_NONE),
                               orr_cli_duration_ns(j->c, "step", blocks ? 0 : ORR_NS_PER_S),
                               (uint32_t)orr_cli_int(j->c, "count", 0)};
    orr_wire_writer w = {payload, 0, sizeof payload, ORR_WIRE_OK};
    r->info->encode(&request, &w);
    const orr_msg_subscribe m = {
        .request = r->info->type,
        .pacing = orr_cli_given(j->c, "free") ? ORR_MSG_PACING_FREE : ORR_MSG_PACING_CLOCK,
        .delivery = j->port != NULL ? ORR_MSG_DELIVERY_DATAGRAMS : ORR_MSG_DELIVERY_FRAMES,
        .port = j->port != NULL ? orr_dial_port_number(j->port) : 0,
        .credit = CREDIT,
        .lead = orr_cli_duration_ns(j->c, "lead", 0),
        .poll = {payload, (uint16_t)w.size}};
    orr_wire_writer frame;
    size_t start;
    orr_frame f;
    orr_client_begin(&j->d->client, ORR_MSG_TYPE_SUBSCRIBE, &frame, &start);
    orr_msg_subscribe_encode(&m, &frame);
    const orr_wire_status s = orr_client_send(&j->d->client, &frame, start);
    if (s != ORR_WIRE_OK) return s;
    keep(j, frame.data, frame.size);
    orr_msg_subscribed told;
    orr_wire_status answered = orr_client_answer(&j->d->client, ORR_MSG_TYPE_SUBSCRIBED, &f);
    if (answered == ORR_WIRE_OK) answered = orr_msg_subscribed_decode(f.payload, f.size, &told);
    if (answered == ORR_WIRE_OK && j->port != NULL) orr_dial_port_take_up(j->port, told.channel);
    return answered;
}

// One frame of the stream into the log.
static void take(record_job *j, const orr_frame *f)
{
    orr_msg_gap g;
    keep(j, f->payload - ORR_FRAME_HEADER, f->size + ORR_FRAME_OVERHEAD);
    if (f->type == ORR_MSG_TYPE_GAP && orr_msg_gap_decode(f->payload, f->size, &g) == ORR_WIRE_OK)
        j->left_out += g.blocks;
    if (f->type != ORR_MSG_TYPE_GAP && f->type != ORR_MSG_TYPE_STREAM_END) j->blocks++;
}

// Lets as many blocks more come as have been made, those that were lost on their way among them.
static orr_wire_status renew(record_job *j, uint32_t stream)
{
    if (2 * j->spent < CREDIT) return ORR_WIRE_OK;
    const orr_msg_credit more = {stream, j->spent};
    j->spent = 0;
    return orr_client_credit(&j->d->client, &more);
}

// Frames until the stream ends.
static orr_wire_status listen_to(record_job *j, uint32_t stream)
{
    orr_frame f;
    for (;;) {
        orr_wire_status s = orr_client_next(&j->d->client, &f);
        if (s == ORR_WIRE_OK && f.sequence != stream) continue;
        if (s != ORR_WIRE_OK) return s;
        take(j, &f);
        if (f.type == ORR_MSG_TYPE_STREAM_END) return ORR_WIRE_OK;
        j->spent += f.type != ORR_MSG_TYPE_GAP;
        s = renew(j, stream);
        if (s != ORR_WIRE_OK) return s;
    }
}

// The same of datagrams. Notices are taken from the connection, where none is lost; behind the last of them what is on its way has a moment.
static orr_wire_status listen_for(record_job *j, uint32_t stream, int timeout_ms)
{
    orr_frame f = {0};
    uint8_t end[ORR_FRAME_OVERHEAD + 256];
    size_t n_end = 0;
    const orr_datagram_window *w = &orr_dial_port_reader(j->port)->window;
    for (uint64_t paid = 0;;) {
        orr_wire_status s;
        const orr_dial_port_what what = orr_dial_port_next(j->port, n_end > 0 ? TAIL_MS : timeout_ms, &f, &s);
        const bool notice = f.type == ORR_MSG_TYPE_GAP || f.type == ORR_MSG_TYPE_STREAM_END;
        switch (what) {
        case ORR_DIAL_PORT_FAILED:
            return s;
        case ORR_DIAL_PORT_NOTHING:
            if (n_end == 0) return ORR_WIRE_CLOSED;
            keep(j, end, n_end);
            return ORR_WIRE_OK;
        case ORR_DIAL_PORT_DATAGRAM:
            if (!notice) take(j, &f);
            j->spent += (uint32_t)(w->greatest - paid);
            paid = w->greatest;
            break;
        case ORR_DIAL_PORT_CONNECTION:
            if (f.sequence != stream) break;
            if (f.type == ORR_MSG_TYPE_GAP) take(j, &f);
            if (f.type != ORR_MSG_TYPE_STREAM_END || f.size > sizeof end - ORR_FRAME_OVERHEAD) break;
            n_end = f.size + ORR_FRAME_OVERHEAD;
            memcpy(end, f.payload - ORR_FRAME_HEADER, n_end);
            break;
        }
        s = n_end == 0 ? renew(j, stream) : ORR_WIRE_OK;
        if (s != ORR_WIRE_OK) return s;
    }
}

static orr_status record(record_job *j, const orr_poll_request *r, orr_diag *diag)
{
    orr_msg_caps caps;
    keep(j, (const uint8_t *)ORR_RECORD_MAGIC, 8);
    orr_wire_status s = orr_client_open(&j->d->client, "orrery record", ORR_VERSION, &caps);
    if (s == ORR_WIRE_OK && orr_cli_given(j->c, "datagrams")) {
        const orr_status opened = orr_dial_port_open(j->d, &j->port, diag);
        if (opened != ORR_OK) return opened;
    }
    if (s == ORR_WIRE_OK) s = subscribe(j, r);
    const uint32_t stream = j->d->client.awaited;
    const int timeout_ms = (int)(orr_cli_duration_ns(j->c, "timeout", 30 * ORR_NS_PER_S) / 1000000);
    if (s == ORR_WIRE_OK) s = j->port != NULL ? listen_for(j, stream, timeout_ms) : listen_to(j, stream);
    return s == ORR_WIRE_OK ? ORR_OK : orr_dial_status(j->d, s, "SUBSCRIBE", diag);
}

static int run(orr_cli *c)
{
    record_job j = {.c = c};
    orr_poll_request r = {.pages = false};
    orr_diag diag = {0};
    orr_outfile out = {.stream = NULL};
    const int asked = orr_poll_ask(c, &r);
    if (asked != ORR_EXIT_OK) return asked;
    if (!orr_cli_given(c, "count")) return orr_cli_usage(c, "--count is wanted: how many blocks to record");
    orr_status s =
        orr_dial_open(c->operand[0], orr_cli_text(c, "identity", NULL),
                      (double)orr_cli_duration_ns(c, "timeout", 30 * ORR_NS_PER_S) * 1e-9, &j.d, &diag);
    if (s == ORR_E_ARG) return orr_cli_usage(c, "%s", diag.text);
    if (s == ORR_OK) s = orr_outfile_open(orr_cli_text(c, "output", "orrery.log"), &out, &diag);
    if (s != ORR_OK) {
        orr_dial_close(j.d);
        return orr_cli_fail(c, &diag);
    }
    j.out = out.stream;
    s = record(&j, &r, &diag);
    if (s == ORR_OK && j.failed) s = orr_diag_set(&diag, ORR_E_IO, "the log could not be written");
    s = orr_outfile_end(&out, s, &diag);
    const uint64_t greatest = j.port != NULL ? orr_dial_port_reader(j.port)->window.greatest : 0;
    const uint64_t lost = greatest > 0 ? greatest - orr_dial_port_reader(j.port)->window.taken : 0;
    orr_dial_port_close(j.port);
    orr_dial_close(j.d);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    orr_cli_say(c, "%llu blocks, %llu left out, %llu lost on their way", (unsigned long long)j.blocks,
                (unsigned long long)j.left_out, (unsigned long long)lost);
    return ORR_EXIT_OK;
}

static const orr_option options[] = {
    ORR_OPTION_IDENTITY(),
    {.name = "output",
     .letter = 'o',
     .kind = ORR_OPT_TEXT,
     .value = "LOG",
     .writes = true,
     .help = "Where to write it; orrery.log by default."},
    {.name = "from",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "First instant; by default the next one of the scenario's clock, with --free the first that is "
             "served."},
    ORR_OPTION_STEP(.help =
                        "Time from one block to the next; 1 s by default, with --channels every block once."),
    {.name = "count",
     .letter = 'n',
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 4e9,
     .help = "How many blocks."},
    {.name = "lead",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "How long before its instant on the scenario's clock a block is made; 0 by default."},
    {.name = "free", .kind = ORR_OPT_FLAG, .applies = "!lead", .help = "As fast as the blocks are taken."},
    {.name = "datagrams",
     .kind = ORR_OPT_FLAG,
     .help = "As UDP datagrams beside the connection, sealed where that has TLS; those that are lost are "
             "counted."},
    ORR_POLL_OPTIONS,
    {.name = "timeout",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Give up when the server is silent for so long; 30 s by default."},
};

const orr_command orr_cmd_record = {
    .name = "record",
    .group = "Service",
    .summary = "write a stream of a service into a log",
    .operands = "URL",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Subscribes to channels, states, broadcast data, readings or truth, and writes the frames as "
             "they come. "
             "`orrery replay` shows them, gives them out again bit for bit, or compares them with what a "
             "service answers.",
    .example = "orrery record tcp://127.0.0.1:15754 -o flight.log --channels --count 6000 --lead 0.02",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

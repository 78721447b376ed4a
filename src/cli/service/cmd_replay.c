// SPDX-License-Identifier: GPL-3.0-or-later
// orrery replay: what orrery record has written, shown, given out again bit for bit, or compared with a service.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proto/fields.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/service/message_show.h"
#include "src/cli/service/record_log.h"
#include "src/service/net/dial.h"

typedef struct replay_job {
    orr_cli *c;
    const char *path;
    uint8_t *data;
    size_t n, at;
    orr_frame frame;               // the present one
    orr_msg_subscribe asked;       // its poll borrows data
    orr_dial *d;                   // of --check; NULL: none
    uint64_t blocks, unlike, live; // live: of live motion, which polls do not have
    orr_show_format format;
    bool headed, raw;
} replay_job;

static orr_status read_file(replay_job *j, orr_diag *diag)
{
    FILE *f = fopen(j->path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, j->path, 0, 0, "cannot be opened: %s", strerror(errno));
    size_t got;
    do {
        uint8_t *grown = realloc(j->data, j->n + (1 << 20));
        if (grown == NULL) {
            fclose(f);
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        }
        j->data = grown;
        got = fread(j->data + j->n, 1, 1 << 20, f);
        j->n += got;
    } while (got > 0);
    const bool bad = ferror(f) != 0;
    fclose(f);
    if (bad) return orr_diag_at(diag, ORR_E_IO, j->path, 0, 0, "cannot be read");
    if (j->n < 8 || memcmp(j->data, ORR_RECORD_MAGIC, 8) != 0)
        return orr_diag_at(diag, ORR_E_KIND, j->path, 0, 0, "is no log of orrery record");
    j->at = 8;
    return ORR_OK;
}

// The next frame; false at the end.
static orr_status next(replay_job *j, bool *there, orr_diag *diag)
{
    size_t used;
    *there = j->at < j->n;
    if (!*there) return ORR_OK;
    const orr_wire_status s =
        orr_frame_parse(j->data + j->at, j->n - j->at, ORR_MSG_MAX_PAYLOAD, &j->frame, &used);
    if (s != ORR_WIRE_OK)
        return orr_diag_at(diag, ORR_E_FORMAT, j->path, 0, 0, "is damaged at byte %zu: %s", j->at,
                           s == ORR_WIRE_MORE ? "it ends within a frame" : orr_wire_status_text(s));
    j->at += used;
    return ORR_OK;
}

// Whether a service answers the block's question with the same bytes.
static orr_status compare(replay_job *j, orr_diag *diag)
{
    orr_wire_writer w;
    size_t start;
    orr_frame f;
    uint8_t epochs[20];
    const orr_message_info *info = orr_message_of(j->asked.request);
    orr_wire_store_i64(epochs, orr_wire_load_i64(j->frame.payload));
    memcpy(epochs + 8, j->asked.poll.data + 8, 8);
    orr_wire_store_u32(epochs + 16, 1);
    orr_client_begin(&j->d->client, info->type, &w, &start);
    orr_wire_put_raw(&w, epochs, sizeof epochs);
    orr_wire_put_raw(&w, j->asked.poll.data + sizeof epochs, j->asked.poll.size - sizeof epochs);
    orr_wire_status s = orr_client_send(&j->d->client, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(&j->d->client, info->answer, &f);
    if (s != ORR_WIRE_OK) return orr_dial_status(j->d, s, info->name, diag);
    j->unlike += f.size != j->frame.size || memcmp(f.payload, j->frame.payload, f.size) != 0;
    return ORR_OK;
}

static orr_status take_block(replay_job *j, orr_diag *diag)
{
    const orr_message_info *info = orr_message_of(j->frame.type);
    orr_msg_any m;
    if (info == NULL || info->decode(j->frame.payload, j->frame.size, &m) != ORR_WIRE_OK)
        return orr_diag_at(diag, ORR_E_FORMAT, j->path, 0, 0,
                           "has a frame that is no message, before byte %zu", j->at);
    const bool block = j->frame.type == orr_message_of(j->asked.request)->answer;
    const bool live =
        block && j->frame.type == ORR_MSG_TYPE_CHANNELS && m.channels.motion != ORR_MSG_MOTION_STATE_SCENARIO;
    j->blocks += block;
    j->live += live;
    if (j->raw)
        fwrite(j->frame.payload - ORR_FRAME_HEADER, 1, j->frame.size + ORR_FRAME_OVERHEAD, stdout);
    else if (j->d != NULL)
        return block && !live ? compare(j, diag) : ORR_OK;
    else if (block && !orr_message_show(info, &m, j->format, "", &j->headed))
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    return ORR_OK;
}

static orr_status replay(replay_job *j, orr_diag *diag)
{
    bool there;
    orr_status s = read_file(j, diag);
    if (s == ORR_OK) s = next(j, &there, diag);
    if (s != ORR_OK) return s;
    if (!there || j->frame.type != ORR_MSG_TYPE_SUBSCRIBE ||
        orr_msg_subscribe_decode(j->frame.payload, j->frame.size, &j->asked) != ORR_WIRE_OK ||
        orr_message_of(j->asked.request) == NULL || j->asked.poll.size < 20)
        return orr_diag_at(diag, ORR_E_FORMAT, j->path, 0, 0, "does not begin with what was asked for");
    while ((s = next(j, &there, diag)) == ORR_OK && there && (s = take_block(j, diag)) == ORR_OK) continue;
    return s;
}

static int run(orr_cli *c)
{
    replay_job j = {.c = c,
                    .path = c->operand[0],
                    .raw = orr_cli_given(c, "raw"),
                    .format = orr_cli_says(c, "format", "json")  ? ORR_AS_JSON
                              : orr_cli_says(c, "format", "csv") ? ORR_AS_CSV
                                                                 : ORR_AS_TABLE};
    orr_diag diag = {0};
    orr_status s = ORR_OK;
    const char *url = orr_cli_text(c, "check", NULL);
    if (url != NULL) s = orr_dial_open(url, orr_cli_text(c, "identity", NULL), 30, &j.d, &diag);
    if (s == ORR_OK) s = replay(&j, &diag);
    orr_dial_close(j.d);
    free(j.data);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    if (url == NULL) return ORR_EXIT_OK;
    printf("%llu blocks, %llu unlike what %s answers\n", (unsigned long long)j.blocks,
           (unsigned long long)j.unlike, url);
    if (j.live > 0)
        printf("%llu of live motion were not compared: polls know the scenario's alone%s\n",
               (unsigned long long)j.live, j.live == j.blocks ? "; none is left" : "");
    return j.unlike == 0 && (j.live == 0 || j.live < j.blocks) ? ORR_EXIT_OK : ORR_EXIT_FAILED;
}

static const orr_option options[] = {
    ORR_OPTION_IDENTITY(.applies = "check", ),
    ORR_OPTION_FORMAT_AS("table|csv|json", "table",
                         .help = "How blocks are shown, as of `orrery poll`; a table by default."),
    {.name = "raw",
     .kind = ORR_OPT_FLAG,
     .applies = "!check",
     .help = "The frames of the stream on stdout, bit for bit as they came."},
    {.name = "check",
     .kind = ORR_OPT_TEXT,
     .value = "URL",
     .help = "Ask a service for each block and compare it bit for bit; exit status 1 where one is unlike. "
             "Blocks of live motion are counted and left out; where all are, the status is 1 too."},
};

const orr_command orr_cmd_replay = {
    .name = "replay",
    .group = "Service",
    .summary = "show, give out again or check what `orrery record` has written",
    .operands = "LOG",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Blocks of live motion are made again by `orrery serve --motion-replay`; those of the "
             "scenario's own motion by any poll.",
    .example = "orrery replay flight.log --format csv\n"
               "orrery replay flight.log --check tcp://127.0.0.1:15754",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

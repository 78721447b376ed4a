// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/motion_log.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proto/frame.h"

static const char MAGIC[8] = "ORRYMOT1";
enum { MOST = 1024 }; // bytes of a frame of a sample, with room for later versions

struct orr_motion_log {
    FILE *file;
    char path[300];
    uint32_t sequence;
    bool failed;
    const char *fault;
};

static orr_status open_file(const char *path, const char *mode, orr_motion_log **out, orr_diag *diag)
{
    orr_motion_log *log = calloc(1, sizeof *log);
    if (log == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    snprintf(log->path, sizeof log->path, "%s", path);
    log->file = fopen(path, mode);
    if (log->file == NULL) {
        free(log);
        return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    }
    *out = log;
    return ORR_OK;
}

orr_status orr_motion_log_create(const char *path, orr_motion_log **out, orr_diag *diag)
{
    const orr_status s = open_file(path, "wb", out, diag);
    if (s == ORR_OK) (*out)->failed = fwrite(MAGIC, 1, sizeof MAGIC, (*out)->file) != sizeof MAGIC;
    return s;
}

orr_status orr_motion_log_open(const char *path, orr_motion_log **out, orr_diag *diag)
{
    char head[sizeof MAGIC];
    const orr_status s = open_file(path, "rb", out, diag);
    if (s != ORR_OK) return s;
    if (fread(head, 1, sizeof head, (*out)->file) == sizeof head && memcmp(head, MAGIC, sizeof head) == 0)
        return ORR_OK;
    (void)orr_motion_log_close(*out, NULL);
    *out = NULL;
    return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "is no log of motion (orrery serve --motion-log)");
}

orr_status orr_motion_log_close(orr_motion_log *log, orr_diag *diag)
{
    if (log == NULL) return ORR_OK;
    const bool failed = fclose(log->file) != 0 || log->failed;
    const orr_status s =
        failed ? orr_diag_at(diag, ORR_E_IO, log->path, 0, 0, "could not be written") : ORR_OK;
    free(log);
    return s;
}

void orr_motion_log_write(void *user, const orr_msg_motion *m, orr_time from)
{
    orr_motion_log *log = user;
    uint8_t data[8 + MOST];
    orr_wire_store_i64(data, from);
    orr_wire_writer w = {data, 8, sizeof data, ORR_WIRE_OK};
    size_t start;
    orr_frame_begin(&w, ORR_MSG_TYPE_MOTION, ++log->sequence, &start);
    orr_msg_motion_encode(m, &w);
    orr_frame_end(&w, start);
    if (fwrite(data, 1, w.size, log->file) != w.size) log->failed = true;
}

bool orr_motion_log_read(void *user, orr_msg_motion *m, orr_time *from)
{
    orr_motion_log *log = user;
    uint8_t data[8 + MOST];
    orr_frame f;
    size_t used;
    const size_t head = 8 + ORR_FRAME_HEADER, n = fread(data, 1, head, log->file);
    if (n == 0) return false;
    log->fault = "ends within a sample";
    if (n < head) return false;
    const size_t rest = orr_wire_load_u32(data + 8 + 12) + (size_t)4;
    log->fault = "is damaged";
    if (rest > MOST - ORR_FRAME_HEADER || fread(data + head, 1, rest, log->file) != rest ||
        orr_frame_parse(data + 8, ORR_FRAME_HEADER + rest, MOST, &f, &used) != ORR_WIRE_OK ||
        f.type != ORR_MSG_TYPE_MOTION || orr_msg_motion_decode(f.payload, f.size, m) != ORR_WIRE_OK)
        return false;
    log->fault = NULL;
    *from = orr_wire_load_i64(data);
    return true;
}

const char *orr_motion_log_fault(const orr_motion_log *log) { return log->fault; }

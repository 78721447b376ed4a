// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/input/stage.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const size_t MAX_HINT = (size_t)256 << 20;

orr_status orr_stage_read(orr_stage *s, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag)
{
    size_t ahead = s->ahead_to - s->ahead_from;
    if (ahead > 0) {
        if (ahead > capacity) ahead = capacity;
        memcpy(buf, s->ahead + s->ahead_from, ahead);
        s->ahead_from += ahead;
        s->total += ahead;
        *got = ahead;
        return ORR_OK;
    }
    orr_status st = s->read(s, buf, capacity, got, diag);
    if (st == ORR_OK) s->total += *got;
    return st;
}

orr_status orr_stage_peek(orr_stage *s, const uint8_t **bytes, size_t *n, orr_diag *diag)
{
    while (s->ahead_to < sizeof s->ahead) {
        size_t got = 0;
        orr_status st = s->read(s, s->ahead + s->ahead_to, sizeof s->ahead - s->ahead_to, &got, diag);
        if (st != ORR_OK) return st;
        if (got == 0) break;
        s->ahead_to += got;
    }
    *bytes = s->ahead;
    *n = s->ahead_to;
    return ORR_OK;
}

typedef struct file_stage {
    orr_stage stage;
    int fd;
} file_stage;

static orr_status file_read(orr_stage *self, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag)
{
    file_stage *f = (file_stage *)self;
    ssize_t n;
    do n = read(f->fd, buf, capacity);
    while (n < 0 && errno == EINTR);
    if (n < 0) return orr_diag_at(diag, ORR_E_IO, self->name, 0, 0, "cannot read: %s", strerror(errno));
    *got = (size_t)n;
    return ORR_OK;
}

static void file_close(orr_stage *self)
{
    close(((file_stage *)self)->fd);
    free(self);
}

orr_status orr_stage_file(const char *path, orr_stage **out, size_t *size, orr_diag *diag)
{
    *size = 0;
    const bool standard = strcmp(path, "-") == 0;
    int fd = standard ? dup(STDIN_FILENO) : open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot open: %s", strerror(errno));
    struct stat st;
    if (fstat(fd, &st) == 0) {
        if (S_ISDIR(st.st_mode)) {
            close(fd);
            return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "this is a folder, not a file");
        }
        if (S_ISREG(st.st_mode)) *size = st.st_size < (off_t)MAX_HINT ? (size_t)st.st_size : MAX_HINT;
    }
    file_stage *f = calloc(1, sizeof *f);
    if (f == NULL) {
        close(fd);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    f->stage = (orr_stage){.read = file_read, .close = file_close, .name = path};
    f->fd = fd;
    *out = &f->stage;
    return ORR_OK;
}

typedef struct memory_stage {
    orr_stage stage;
    const uint8_t *at, *end;
} memory_stage;

static orr_status memory_read(orr_stage *self, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag)
{
    (void)diag;
    memory_stage *m = (memory_stage *)self;
    size_t n = (size_t)(m->end - m->at);
    if (n > capacity) n = capacity;
    if (n > 0) memcpy(buf, m->at, n);
    m->at += n;
    *got = n;
    return ORR_OK;
}

static void memory_close(orr_stage *self) { free(self); }

orr_status orr_stage_memory(const char *name, const void *data, size_t n, orr_stage **out, orr_diag *diag)
{
    memory_stage *m = calloc(1, sizeof *m);
    if (m == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    m->stage = (orr_stage){.read = memory_read, .close = memory_close, .name = name};
    m->at = data;
    m->end = n > 0 ? m->at + n : m->at;
    *out = &m->stage;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#define _DEFAULT_SOURCE // madvise
#include "core/backing.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/array.h"

typedef struct piece {
    void *at;
    size_t bytes;
} piece;

struct orr_backing {
    int file;
    off_t length;
    piece *piece;
    size_t n;
};

orr_status orr_backing_open(const char *folder, orr_backing **out, orr_diag *diag)
{
    char name[4096];
    *out = NULL;
    const int n = snprintf(name, sizeof name, "%s/.orrery-XXXXXX", folder);
    if (n < 0 || (size_t)n >= sizeof name)
        return orr_diag_set(diag, ORR_E_IO, "%.200s: the name of the folder is too long", folder);
    orr_backing *b = calloc(1, sizeof *b);
    if (b == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a temporary file");
    b->file = mkstemp(name);
    if (b->file < 0) {
        free(b);
        return orr_diag_set(diag, ORR_E_IO, "%s: no temporary file can be made there: %s", folder,
                            strerror(errno));
    }
    (void)unlink(name);
    *out = b;
    return ORR_OK;
}

void *orr_backing_take(orr_backing *b, size_t bytes)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), whole = (bytes / page + 1) * page;
    if (!ORR_ARRAY_GROW(b->piece, b->n)) return NULL;
    // The room is asked for now: a full disk is told here, not by a signal when a page is written.
    const int no_room = posix_fallocate(b->file, b->length, (off_t)whole);
    if (no_room != 0) {
        errno = no_room;
        return NULL;
    }
    void *at = mmap(NULL, whole, PROT_READ | PROT_WRITE, MAP_SHARED, b->file, b->length);
    if (at == MAP_FAILED) return NULL;
    b->piece[b->n++] = (piece){at, whole};
    b->length += (off_t)whole;
    return at;
}

void orr_backing_rest(const orr_backing *b)
{
    for (size_t i = 0; b != NULL && i < b->n; i++)
        (void)madvise(b->piece[i].at, b->piece[i].bytes, MADV_DONTNEED); // of a shared file: nothing is lost
}

void orr_backing_free(orr_backing *b)
{
    if (b == NULL) return;
    for (size_t i = 0; i < b->n; i++) (void)munmap(b->piece[i].at, b->piece[i].bytes);
    (void)close(b->file);
    free(b->piece);
    free(b);
}

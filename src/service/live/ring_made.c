// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // memfd_create, seals
#include "src/service/live/ring_made.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/futex.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

static orr_status open_ring(orr_ring_made *out, uint32_t slots, uint32_t stride, int seals, orr_diag *diag)
{
    const size_t size = orr_ring_size(slots, stride);
    *out = (orr_ring_made){.fd = memfd_create("orrery-ring", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
    if (out->fd < 0) return orr_diag_set(diag, ORR_E_IO, "no shared memory: %s", strerror(errno));
    void *memory = MAP_FAILED;
    if (ftruncate(out->fd, (off_t)size) == 0)
        memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED, out->fd, 0);
    // From here on its size stays: nobody can take pages from under who has it mapped.
    if (memory == MAP_FAILED ||
        fcntl(out->fd, F_ADD_SEALS, seals | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) {
        const int error = errno;
        if (memory != MAP_FAILED) munmap(memory, size);
        close(out->fd);
        *out = (orr_ring_made){.fd = -1};
        return orr_diag_set(diag, ORR_E_IO, "no shared memory: %s", strerror(error));
    }
    orr_ring_make(&out->ring, memory, slots, stride);
    return ORR_OK;
}

// Nobody maps it to write any more.
orr_status orr_ring_made_open(orr_ring_made *out, orr_diag *diag)
{
    return open_ring(out, ORR_RING_SLOTS, ORR_RING_STRIDE, F_SEAL_FUTURE_WRITE, diag);
}

orr_status orr_ring_made_theirs(orr_ring_made *out, uint32_t slots, uint32_t stride, orr_diag *diag)
{
    return open_ring(out, slots, stride, 0, diag);
}

bool orr_ring_made_write(orr_ring_made *r, uint16_t type, const uint8_t *data, size_t size)
{
    if (!orr_ring_write(&r->ring, type, data, size)) return false;
    (void)syscall(SYS_futex, r->ring.memory + ORR_RING_COUNT_AT, FUTEX_WAKE, INT_MAX, NULL, NULL, 0);
    return true;
}

void orr_ring_made_close(orr_ring_made *r)
{
    if (r->ring.memory != NULL) munmap(r->ring.memory, orr_ring_size(r->ring.slots, r->ring.stride));
    if (r->ring.memory != NULL) close(r->fd);
    *r = (orr_ring_made){.fd = -1};
}

typedef struct ring_way {
    orr_way way;
    orr_ring_made made;
} ring_way;

static bool put(orr_way *w, uint16_t type, const uint8_t *data, size_t size)
{
    return orr_ring_made_write(&((ring_way *)w)->made, type, data, size);
}

static void close_way(orr_way *w)
{
    orr_ring_made_close(&((ring_way *)w)->made);
    free(w);
}

orr_status orr_ring_way_open(orr_way **out, orr_diag *diag)
{
    ring_way *w = malloc(sizeof *w);
    if (w == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    const orr_status s = orr_ring_made_open(&w->made, diag);
    if (s != ORR_OK) {
        free(w);
        return s;
    }
    w->way = (orr_way){.fd = w->made.fd, .put = put, .close = close_way};
    *out = &w->way;
    return ORR_OK;
}

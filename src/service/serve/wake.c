// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // which processors there are for us
#include "src/service/serve/wake.h"

#include <sched.h>
#include <stdint.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "core/monotonic.h"

enum { WATCH_NS = 100000, MOST_VAIN = 6 };

bool orr_wake_open(orr_wake *w)
{
    cpu_set_t ours;
    w->fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    atomic_store(&w->rung, false);
    atomic_store(&w->watched, false);
    w->alone = sched_getaffinity(0, sizeof ours, &ours) != 0 || CPU_COUNT(&ours) < 2;
    w->vain = w->pause = 0;
    return w->fd >= 0;
}

void orr_wake_close(orr_wake *w)
{
    if (w->fd >= 0) close(w->fd);
    w->fd = -1;
}

// Each side writes its own flag before it reads the other's, in one order for all: either the loop sees the ring, or the ringer sees
// that nobody looks and writes to the eventfd.
void orr_wake_ring(orr_wake *w)
{
    atomic_store(&w->rung, true);
    if (atomic_load(&w->watched)) return;
    const uint64_t once = 1;
    // It fails only where 2^64 - 1 wakes have not been looked at: one more says nothing new.
    const ssize_t n = write(w->fd, &once, sizeof once);
    (void)n;
}

bool orr_wake_take(orr_wake *w)
{
    uint64_t times;
    const ssize_t n = read(w->fd, &times, sizeof times);
    (void)n; // nothing was written where the loop was looking
    return atomic_exchange(&w->rung, false);
}

bool orr_wake_watch(orr_wake *w)
{
    if (w->alone || w->pause > 0) {
        if (w->pause > 0) w->pause--;
        return false;
    }
    atomic_store(&w->watched, true);
    const int64_t until_ns = orr_monotonic_ns() + WATCH_NS;
    while (!atomic_load_explicit(&w->rung, memory_order_relaxed) && orr_monotonic_ns() < until_ns) continue;
    atomic_store(&w->watched, false);
    const bool rung = atomic_exchange(&w->rung, false);
    w->vain = rung ? 0 : w->vain < MOST_VAIN ? w->vain + 1 : MOST_VAIN;
    w->pause = rung ? 0 : 1u << (w->vain - 1);
    return rung;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/loop.h"

#include <errno.h>
#include <stdint.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <unistd.h>

static void on_stop(evutil_socket_t fd, short what, void *user)
{
    (void)what;
    const orr_loop *l = user;
    uint64_t times;
    if (read(fd, &times, sizeof times) < 0 && errno == EAGAIN) return;
    if (l->stopped != NULL)
        l->stopped(l->user);
    else
        event_base_loopbreak(l->base);
}

orr_status orr_loop_open(orr_loop *l, void (*stopped)(void *user), void *user, orr_diag *diag)
{
    l->opened = true;
    l->stopped = stopped;
    l->user = user;
    l->stop_fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (l->stop_fd < 0) return orr_diag_set(diag, ORR_E_IO, "no eventfd: %s", strerror(errno));
    l->base = event_base_new();
    if (l->base != NULL) l->on_stop = event_new(l->base, l->stop_fd, EV_READ | EV_PERSIST, on_stop, l);
    if (l->on_stop == NULL || event_add(l->on_stop, NULL) != 0)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    return ORR_OK;
}

static void *run(void *user)
{
    const orr_loop *l = user;
    // Of this thread alone, as Linux has it; where it is refused the thread serves as it is.
    if (l->nice != 0) (void)setpriority(PRIO_PROCESS, 0, l->nice);
    event_base_dispatch(l->base);
    return NULL;
}

orr_status orr_loop_start(orr_loop *l, const char *what, orr_diag *diag)
{
    const int wrong = pthread_create(&l->thread, NULL, run, l);
    if (wrong != 0) return orr_diag_set(diag, ORR_E_IO, "no thread for %s: %s", what, strerror(wrong));
    l->has_thread = true;
    return ORR_OK;
}

void orr_loop_stop(const orr_loop *l)
{
    const uint64_t once = 1;
    // It fails only where 2^64 - 1 stops have not been looked at: one more says nothing new.
    const ssize_t n = write(l->stop_fd, &once, sizeof once);
    (void)n;
}

void orr_loop_halt(orr_loop *l)
{
    if (!l->has_thread) return;
    orr_loop_stop(l);
    pthread_join(l->thread, NULL);
    l->has_thread = false;
}

void orr_loop_close(orr_loop *l)
{
    orr_loop_halt(l);
    if (l->on_stop != NULL) event_free(l->on_stop);
    if (l->base != NULL) event_base_free(l->base);
    if (l->opened && l->stop_fd >= 0) close(l->stop_fd);
    *l = (orr_loop){0};
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

#define MAX_JOBS 256

int orr_parallel_cores(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > MAX_JOBS ? MAX_JOBS : (int)n;
}

void orr_parallel_run(int jobs, void *(*worker)(void *user), void *user)
{
    pthread_t thread[MAX_JOBS];
    int started = 0;
    if (jobs > MAX_JOBS) jobs = MAX_JOBS;
    while (started < jobs - 1 && pthread_create(&thread[started], NULL, worker, user) == 0) started++;
    worker(user); // this thread works too, and alone if no other could be started
    for (int i = 0; i < started; i++) pthread_join(thread[i], NULL);
}

typedef struct queue {
    atomic_size_t next;
    size_t n;
    void (*task)(void *user, size_t i);
    void *user;
} queue;

static void *take(void *arg)
{
    queue *q = arg;
    for (size_t i; (i = atomic_fetch_add(&q->next, 1)) < q->n;) q->task(q->user, i);
    return NULL;
}

void orr_parallel_each(size_t n, int jobs, void (*task)(void *user, size_t i), void *user)
{
    queue q = {.n = n, .task = task, .user = user};
    orr_parallel_run(jobs, take, &q);
}

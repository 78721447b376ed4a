// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks on threads: each is done once, however many threads there are.
#include "testing.h"

#include <stdatomic.h>

#include "core/parallel.h"

enum { N = 1000 };

static void mark(void *user, size_t i)
{
    atomic_int *done = user;
    atomic_fetch_add(&done[i], 1);
}

static void every_task_is_done_once(void **state)
{
    (void)state;
    static const int jobs[] = {-1, 0, 1, 2, 7, 1000};
    for (size_t k = 0; k < sizeof jobs / sizeof jobs[0]; k++) {
        atomic_int done[N + 1] = {0};
        orr_parallel_each(N, jobs[k], mark, done);
        for (size_t i = 0; i < N; i++) assert_int_equal(done[i], 1);
        assert_int_equal(done[N], 0);
        orr_parallel_each(0, jobs[k], mark, &done[N]);
        assert_int_equal(done[N], 0);
    }
}

static void the_machine_has_processors(void **state)
{
    (void)state;
    assert_in_range(orr_parallel_cores(), 1, 256);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_task_is_done_once),
                                       cmocka_unit_test(the_machine_has_processors)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// No ring is lost between a loop that sleeps, one that looks, and one that just stopped looking.
#include "testing.h"

#include <poll.h>
#include <pthread.h>

#include "src/service/serve/wake.h"

enum { RINGS = 20000, PATIENCE_MS = 10000 };

typedef struct pair {
    orr_wake wake;
    atomic_int seen; // rings that the loop has seen
} pair;

static void *ring(void *user)
{
    pair *p = user;
    for (int k = 0; k < RINGS; k++) {
        for (int spin = 0; spin < k % 997; spin++) atomic_load(&p->seen); // now sooner, now later
        orr_wake_ring(&p->wake);
        while (atomic_load(&p->seen) <= k) continue;
    }
    return NULL;
}

static void no_ring_is_lost(void **state)
{
    (void)state;
    pair p = {.seen = 0};
    pthread_t thread;
    assert_true(orr_wake_open(&p.wake));
    assert_int_equal(pthread_create(&thread, NULL, ring, &p), 0);
    int by_looking = 0;
    for (int k = 0; k < RINGS; k++) {
        bool rung = k % 3 != 0 && orr_wake_watch(&p.wake);
        by_looking += rung;
        while (!rung) { // as the loop does: asleep until the eventfd tells
            struct pollfd f = {.fd = p.wake.fd, .events = POLLIN};
            if (poll(&f, 1, PATIENCE_MS) != 1) fail_msg("ring %d was lost", k);
            rung = orr_wake_take(&p.wake);
        }
        atomic_fetch_add(&p.seen, 1);
    }
    assert_int_equal(pthread_join(thread, NULL), 0);
    assert_false(orr_wake_take(&p.wake)); // nothing is told twice
    print_message("%d of %d rings were found by looking\n", by_looking,
                  RINGS); // as the machine's load has it
    orr_wake_close(&p.wake);
}

// Looks in vain become rare, and one that finds something makes them as frequent as before.
static void looks_in_vain_become_rare(void **state)
{
    (void)state;
    orr_wake w;
    assert_true(orr_wake_open(&w));
    w.alone = false;
    static const unsigned left_out[] = {1, 2, 4, 8, 16, 32, 32};
    for (size_t k = 0; k < sizeof left_out / sizeof left_out[0]; k++) {
        assert_false(orr_wake_watch(&w));
        assert_int_equal(w.pause, left_out[k]);
        while (w.pause > 0) assert_false(orr_wake_watch(&w));
    }
    orr_wake_ring(&w);
    assert_true(orr_wake_watch(&w));
    assert_false(orr_wake_watch(&w));
    assert_int_equal(w.pause, 1);
    orr_wake_close(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_ring_is_lost),
                                       cmocka_unit_test(looks_in_vain_become_rare)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Fairness counted in units of work, on a clock that only work moves.
#include "src/service/serve/turns.h"

#include "core/rng.h"
#include "testing.h"

enum { HEAVY = 200, QUANTUM = 100 };

// 200 clients that always want more, and one whose requests cost little: it waits for one turn of another at
// most, and they share the rest evenly.
static void one_that_asks_little_waits_for_one_turn(void **state)
{
    (void)state;
    orr_turns q;
    orr_turns_member heavy[HEAVY], light;
    orr_turns_init(&q, QUANTUM);
    for (int k = 0; k < HEAVY; k++) {
        assert_true(orr_turns_join(&q, &heavy[k]));
        orr_turns_wait(&q, &heavy[k]);
    }
    assert_true(orr_turns_join(&q, &light));
    int turns[HEAVY] = {0}, longest = 0, polls = 0, waiting = 0;
    for (int step = 0; step < 40 * HEAVY; step++) {
        if (step >= HEAVY && step % 7 == 0) orr_turns_wait(&q, &light);
        orr_turns_member *m = orr_turns_next(&q);
        if (m == &light) {
            orr_turns_charge(m, 2);
            polls++;
            waiting = 0;
            continue;
        }
        if (light.place > 0 && ++waiting > longest) longest = waiting;
        turns[m - heavy]++;
        orr_turns_charge(m, QUANTUM);
        orr_turns_wait(&q, m);
    }
    assert_true(polls >= 39 * HEAVY / 7 && longest <= 1);
    for (int k = 1; k < HEAVY; k++) assert_true(abs(turns[k] - turns[0]) <= 1);
    orr_turns_free(&q);
}

// Who has slept long, or comes anew, gets no more than its credit before the others have their turn again.
static void nobody_saves_up(void **state)
{
    (void)state;
    orr_turns q;
    orr_turns_member busy, sleeper, newcomer;
    orr_turns_init(&q, QUANTUM);
    assert_true(orr_turns_join(&q, &busy) && orr_turns_join(&q, &sleeper));
    for (int k = 0; k < 1000; k++) {
        orr_turns_wait(&q, &busy);
        assert_ptr_equal(orr_turns_next(&q), &busy);
        orr_turns_charge(&busy, QUANTUM);
    }
    assert_true(orr_turns_join(&q, &newcomer));
    int of_busy = 0;
    orr_turns_wait(&q, &busy);
    for (int k = 0; k < 30; k++) {
        orr_turns_wait(&q, &sleeper);
        orr_turns_wait(&q, &newcomer);
        orr_turns_member *m = orr_turns_next(&q);
        of_busy += m == &busy;
        orr_turns_charge(m, QUANTUM);
        orr_turns_wait(&q, m);
    }
    assert_true(of_busy >= 9);
    orr_turns_free(&q);
}

// Against a search of all, with members that come and go.
static void the_least_used_comes_first(void **state)
{
    (void)state;
    enum { N = 150 };
    orr_turns q;
    orr_turns_member m[N];
    orr_turns_init(&q, INT64_MAX / 4);
    for (int k = 0; k < N; k++) assert_true(orr_turns_join(&q, &m[k]));
    for (uint64_t step = 0; step < 20000; step++) {
        orr_turns_member *one = &m[orr_rng_u64(1, 0, step) % N];
        if (step % 5 == 4) {
            orr_turns_leave(&q, one);
            assert_true(orr_turns_join(&q, one));
        } else if (step % 5 < 3)
            orr_turns_wait(&q, one);
        else {
            const orr_turns_member *least = NULL;
            for (int k = 0; k < N; k++)
                if (m[k].place > 0 && (least == NULL || m[k].used < least->used ||
                                       (m[k].used == least->used && m[k].number < least->number)))
                    least = &m[k];
            orr_turns_member *next = orr_turns_next(&q);
            assert_ptr_equal(next, least);
            if (next != NULL) orr_turns_charge(next, (int64_t)(orr_rng_u64(2, 0, step) % 50));
        }
    }
    orr_turns_free(&q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_that_asks_little_waits_for_one_turn),
        cmocka_unit_test(nobody_saves_up),
        cmocka_unit_test(the_least_used_comes_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

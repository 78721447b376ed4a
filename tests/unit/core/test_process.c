// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/process.h"

// A process lives until it is dead, whether its parent has taken note of that or not.
static void lives_until_it_is_dead(void **state)
{
    (void)state;
    assert_true(orr_process_lives((long)getpid()));
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        for (;;) pause();
    assert_true(orr_process_lives((long)child));
    kill(child, SIGKILL);
    siginfo_t told;
    assert_int_equal(waitid(P_PID, (id_t)child, &told, WEXITED | WNOWAIT), 0); // dead, and nobody took note
    assert_false(orr_process_lives((long)child));
    assert_int_equal(waitpid(child, NULL, 0), child);
    assert_false(orr_process_lives((long)child));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lives_until_it_is_dead)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// As much of cmocka's face as tests/unit/proto needs, over libc alone, for processors that Debian has no cmocka for. The first failure ends
// the program with status 1.
#ifndef ORR_TESTS_PORTABLE_CMOCKA_H
#define ORR_TESTS_PORTABLE_CMOCKA_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct CMUnitTest {
    const char *name;
    void (*run)(void **state);
};

#define cmocka_unit_test(f)                                                                                  \
    {                                                                                                        \
#f, f                                                                                                \
    }
#define fail_msg(...)                                                                                        \
    (fprintf(stderr, "%s:%d: ", __FILE__, __LINE__), fprintf(stderr, __VA_ARGS__), fputc('\n', stderr),      \
     exit(1))
#define assert_true(x) ((x) ? (void)0 : (void)fail_msg("not so: %s", #x))
#define assert_false(x) assert_true(!(x))
#define assert_null(x) assert_true((x) == NULL)
#define assert_non_null(x) assert_true((x) != NULL)
#define assert_ptr_equal(a, b) assert_true((const void *)(a) == (const void *)(b))
#define assert_int_equal(a, b) assert_true((uint64_t)(a) == (uint64_t)(b))
#define assert_int_not_equal(a, b) assert_true((uint64_t)(a) != (uint64_t)(b))
#define assert_memory_equal(a, b, n) assert_true(memcmp((a), (b), (n)) == 0)
#define assert_string_equal(a, b) assert_true(strcmp((a), (b)) == 0)
#define print_message printf
#define skip() exit(77)

static inline int _cmocka_run_group_tests(const char *group, const struct CMUnitTest *test, size_t n,
                                          void *setup, void *teardown)
{
    void *state = NULL;
    (void)setup;
    (void)teardown;
    for (size_t i = 0; i < n; i++) test[i].run(&state);
    printf("%s: %zu tests\n", group, n);
    return 0;
}

#endif

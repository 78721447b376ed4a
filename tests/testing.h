// SPDX-License-Identifier: GPL-3.0-or-later
// What every test program starts from: cmocka in its required order, and the few checks cmocka lacks.
#ifndef ORR_TESTS_TESTING_H
#define ORR_TESTS_TESTING_H

// clang-format off
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
// clang-format on

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

// GSL's default error handler aborts. The program switches it off in main, and so does every test program.
#undef cmocka_run_group_tests
#define cmocka_run_group_tests(group, setup, teardown)                                                       \
    ((void)gsl_set_error_handler_off(),                                                                      \
     _cmocka_run_group_tests(#group, group, sizeof(group) / sizeof((group)[0]), setup, teardown))

// |a - b| <= tol, with the numbers shown when it is not; NAN never passes.
#define ASSERT_NEAR(a, b, tol)                                                                               \
    do {                                                                                                     \
        double a_ = (double)(a), b_ = (double)(b), tol_ = (double)(tol);                                     \
        if (!(fabs(a_ - b_) <= tol_))                                                                        \
            fail_msg("%s = %.17g, %s = %.17g, apart by %.3g > %.3g", #a, a_, #b, b_, fabs(a_ - b_), tol_);   \
    } while (0)

// status expression must be ORR_OK; shows the diagnostic otherwise.
#define ASSERT_OK(expr, diag)                                                                                \
    do {                                                                                                     \
        orr_status s_ = (expr);                                                                              \
        if (s_ != ORR_OK) fail_msg("%s: %s (%s)", #expr, orr_status_name(s_), (diag).text);                  \
    } while (0)

// Path below ORRERY_DATA into buf; false where the data are absent (the test then calls SKIP_NO_DATA()).
static inline bool orr_test_data(const char *name, char *buf, size_t n)
{
    const char *root = getenv("ORRERY_DATA");
    if (root == NULL || *root == '\0') root = ORR_SOURCE_DIR "/../shared/data";
    snprintf(buf, n, "%s/%s", root, name);
    FILE *f = fopen(buf, "rb");
    if (f == NULL) return false;
    fclose(f);
    return true;
}
#define SKIP_NO_DATA(name)                                                                                   \
    do {                                                                                                     \
        print_message("skipped: %s is not here (set ORRERY_DATA)\n", (name));                                \
        skip();                                                                                              \
    } while (0)

#endif

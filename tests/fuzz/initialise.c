// SPDX-License-Identifier: GPL-3.0-or-later
// What every fuzz target does first, as main of the program does: GSL's handler of errors, which aborts, is off.
#include <gsl/gsl_errno.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    (void)gsl_set_error_handler_off();
    return 0;
}

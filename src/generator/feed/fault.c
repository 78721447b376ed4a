// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/feed/fault.h"

#include <stdarg.h>
#include <stdio.h>

bool orr_gen_fail(orr_gen_fault *fault, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(fault->text, sizeof fault->text, format, args);
    va_end(args);
    return false;
}

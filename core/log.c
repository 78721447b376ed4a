// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void orr_log_write(const orr_log *log, orr_log_level level, const char *fmt, ...)
{
    if (log == NULL || log->write == NULL) return;
    char line[1024];
    va_list args;
    va_start(args, fmt);
    int len = vsnprintf(line, sizeof line, fmt, args);
    va_end(args);
    if (len < 0) return;
    if ((size_t)len >= sizeof line) memcpy(line + sizeof line - 4, "...", 4);
    log->write(log->user, level, line);
}

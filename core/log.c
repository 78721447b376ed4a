// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool orr_log_rate_allows(orr_log_rate *r, int64_t now_ns, uint64_t *held)
{
    int64_t earliest = now_ns - r->burst * r->every_ns;
    if (r->spent_ns < earliest || !r->begun) r->spent_ns = earliest;
    r->begun = true;
    *held = r->held;
    if (r->spent_ns + r->every_ns > now_ns) {
        r->held++;
        return false;
    }
    r->spent_ns += r->every_ns;
    r->held = 0;
    return true;
}

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

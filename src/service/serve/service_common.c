// SPDX-License-Identifier: GPL-3.0-or-later
// What service.c and connection.c both need and neither owns: the clock, and a log line that a client has caused.
#include <stdarg.h>
#include <stdio.h>

#include "core/monotonic.h"
#include "src/service/serve/service_private.h"

int64_t orr_service_clock_ns(const orr_service *s)
{
    if (s->options.clock_ns != NULL) return s->options.clock_ns(s->options.clock_user);
    return orr_monotonic_ns();
}

void orr_service_tell(orr_service *s, const char *fmt, ...)
{
    uint64_t held;
    if (s->log == NULL || s->log->level < ORR_LOG_WARN) return;
    if (!orr_log_rate_allows(&s->rate, orr_service_clock_ns(s), &held)) return;
    char line[600];
    va_list args;
    va_start(args, fmt);
    vsnprintf(line, sizeof line, fmt, args);
    va_end(args);
    if (held > 0)
        orr_log_write(s->log, ORR_LOG_WARN, ORR_ID("R07") "%llu more lines about clients were left out",
                      (unsigned long long)held);
    orr_log_write(s->log, ORR_LOG_WARN, "%s", line);
}

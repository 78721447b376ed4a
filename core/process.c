// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>

bool orr_process_lives(long pid)
{
    char path[64], text[512] = "";
    if (kill((pid_t)pid, 0) != 0 && errno == ESRCH) return false;
    snprintf(path, sizeof path, "/proc/%ld/stat",
             pid); // "PID (NAME) STATE ...", where NAME may hold anything
    FILE *f = fopen(path, "r");
    if (f == NULL) return true; // no such folder here: the number alone tells
    const size_t n = fread(text, 1, sizeof text - 1, f);
    fclose(f);
    text[n] = '\0';
    const char *name_end = strrchr(text, ')');
    return name_end == NULL || strncmp(name_end, ") Z", 3) != 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files.
#ifndef ORR_CORE_PATH_H
#define ORR_CORE_PATH_H

#include <stdio.h>
#include <string.h>

// The name behind the last '/', borrowed from `path`.
static inline const char *orr_base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

// The folder that `path` is in, "." where it names none; cut where it does not fit into `n` bytes.
static inline const char *orr_folder_name(const char *path, char *out, size_t n)
{
    const size_t length = (size_t)(orr_base_name(path) - path);
    snprintf(out, n, "%.*s", length > 0 ? (int)length : 1, length > 0 ? path : ".");
    return out;
}

#endif

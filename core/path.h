// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files.
#ifndef ORR_CORE_PATH_H
#define ORR_CORE_PATH_H

#include <string.h>

// The name behind the last '/', borrowed from `path`.
static inline const char *orr_base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

#endif

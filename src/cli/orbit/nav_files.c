// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/nav_files.h"

#include <stdlib.h>

orr_status orr_cli_read_navs(const orr_cli *c, const char *option, orr_nav *out, orr_warnings *warnings,
                             orr_diag *diag)
{
    const size_t n = orr_cli_count(c, option);
    const char **path = calloc(n + 1, sizeof *path);
    if (path == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", n);
    for (size_t i = 0; i < n; i++) path[i] = orr_cli_text_at(c, option, i);
    orr_status s = orr_nav_read_files(path, n, out, warnings, diag);
    free(path);
    return s;
}

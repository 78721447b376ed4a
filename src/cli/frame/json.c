// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/frame/json.h"

#include <stdio.h>

bool orr_json_put(json_t *j, size_t flags)
{
    bool done = j != NULL && json_dumpf(j, stdout, flags) == 0;
    if (done) putchar('\n');
    json_decref(j);
    return done;
}

int orr_json_print(const orr_cli *c, json_t *j, size_t flags)
{
    return orr_json_put(j, flags) ? ORR_EXIT_OK : orr_cli_failf(c, "the report could not be printed");
}

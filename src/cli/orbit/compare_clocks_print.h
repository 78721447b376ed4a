// SPDX-License-Identifier: GPL-3.0-or-later
// The clocks' part of what `orrery compare` prints.
#ifndef ORR_CLI_COMPARE_CLOCKS_PRINT_H
#define ORR_CLI_COMPARE_CLOCKS_PRINT_H

#include "orbit/judge/compare_clocks.h"
#include "src/cli/frame/json.h"

// A table on standard output; nothing where no clock could be compared.
void compare_clocks_print(const orr_clock_comparison *x);
// The same as an object: systems, satellites, left_out.
json_t *compare_clocks_json(const orr_clock_comparison *x);

#endif

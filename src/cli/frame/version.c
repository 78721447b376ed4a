// SPDX-License-Identifier: GPL-3.0-or-later
// What the program is and what it was built from.
#include "src/cli/frame/frame.h"
#include <orr_built_from.h> // made by the build
#include <orr_libraries.h>

void orr_cli_version(FILE *f, bool verbose)
{
    fputs("orrery " ORR_VERSION "\n", f);
    if (!verbose) return;
    fputs("built from " ORR_BUILT_FROM "\ncompiler " ORR_COMPILER "\nlibraries " ORR_LIBRARIES "\n", f);
}

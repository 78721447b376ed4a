// SPDX-License-Identifier: GPL-3.0-or-later
// The navigation files of a repeated option.
#ifndef ORR_CLI_ORBIT_NAV_FILES_H
#define ORR_CLI_ORBIT_NAV_FILES_H

#include "ingest/rinex/rinex_nav.h"
#include "src/cli/frame/cli.h"

// All files that the option names, as one (orr_nav_read_files). Free with orr_nav_free.
orr_status orr_cli_read_navs(const orr_cli *c, const char *option, orr_nav *out, orr_warnings *warnings,
                             orr_diag *diag);

#endif

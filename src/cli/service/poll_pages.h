// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll --navdata --pages: subframes and strings, a row each, in the columns of `orrery navfit --bits`.
#ifndef ORR_CLI_SERVICE_POLL_PAGES_H
#define ORR_CLI_SERVICE_POLL_PAGES_H

#include "proto/gen/messages.h"

// The pages of an answer on stdout; *headed: whether the names of columns have been printed.
void orr_poll_pages(const orr_msg_navdata *m, bool *headed);

#endif

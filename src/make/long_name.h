// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files as the IGS has had them since GPS week 2238: "ORR0OPSFIN_20250800000_01D_15M_ORB.SP3".
#ifndef ORR_MAKE_LONG_NAME_H
#define ORR_MAKE_LONG_NAME_H

#include <stddef.h>

#include "core/status.h"
#include "core/time.h"

// The path of a file of ours within a folder.
// Given:
//   folder    the folder
//   campaign  three letters: OPS, or TST for what is no analysis
//   begin     first instant of the file, GPS time
//   length_ns span of the file
//   step_ns   from one epoch to the next
//   kind      content and suffix: "ORB.SP3"
//   n         bytes of out
// Returned:
//   out       the path
//   diag      ORR_E_LIMIT where it is longer than that; may be NULL
// Notes: lengths are two digits and a unit (days, hours, minutes, seconds; Z and C are 1 and 100 a second); what is no whole
// number of any is 00U.
// Reference: Guidelines for Long Product Filenames in the IGS, version 2.0.
orr_status orr_long_name(const char *folder, const char *campaign, orr_time begin, int64_t length_ns,
                         int64_t step_ns, const char *kind, size_t n, char *out, orr_diag *diag);

#endif

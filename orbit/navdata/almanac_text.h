// SPDX-License-Identifier: GPL-3.0-or-later
// Almanacs as text files: YUMA and SEM, as the US Coast Guard Navigation Center publishes those of GPS.
#ifndef ORR_ORBIT_NAVDATA_ALMANAC_TEXT_H
#define ORR_ORBIT_NAVDATA_ALMANAC_TEXT_H

#include "orbit/navdata/navset.h"

typedef enum orr_almanac_format { ORR_ALMANAC_YUMA, ORR_ALMANAC_SEM } orr_almanac_format;

// Writes the almanacs that are sent on a day: YUMA of GPS and QZSS (by PRN, 193 and on), SEM of GPS. Atomic; "-" is stdout.
// Given:
//   set     broadcast data
//   format  which kind of file
//   t       any instant of the day
//   path    where to
// Returned:
//   n       how many satellites; may be NULL
//   diag    why it failed; may be NULL
// Errors: ORR_E_NODATA where no satellite has an almanac, ORR_E_IO.
// Notes: the week is modulo 1024, as in both formats; SEM's average URA is index 0, its SVN, which no product tells, 0.
// Reference: ICD-GPS-240C 3.3 and appendix I.
orr_status orr_almanac_write(const orr_navset *set, orr_almanac_format format, orr_time t, const char *path,
                             size_t *n, orr_diag *diag);

#endif

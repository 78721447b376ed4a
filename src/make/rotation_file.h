// SPDX-License-Identifier: GPL-3.0-or-later
// The Earth's rotation of an orbit product as a file of Earth rotation parameters.
#ifndef ORR_MAKE_ROTATION_FILE_H
#define ORR_MAKE_ROTATION_FILE_H

#include "orbit/ephemeris/ephemeris.h"

// Writes it every twelve hours of UTC (leap: the run's table; NULL: built-in), so that the file covers the product's span: version 2, pole, UT1 - UTC, length of day,
// rates, and the formal sigmas of what was estimated. Errors: ORR_E_NODATA where the product has the secular pole
// alone, ORR_E_MEMORY, ORR_E_IO.
orr_status orr_rotation_file_write(const orr_ephemeris *e, const orr_leap_table *leap, const char *path,
                                   orr_diag *diag);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements as text, for the commands that print them: one set of words and columns.
#ifndef ORR_CLI_ORBIT_ELEMENTS_ROWS_H
#define ORR_CLI_ORBIT_ELEMENTS_ROWS_H

#include <stdio.h>

#include "orbit/elements/elements.h"

#define ORR_ELEMENTS_FRAMES "date|j2000|ecef" // of a CHOICE option, and what they are
#define ORR_ELEMENTS_METHODS "state|three-positions|mean"
// The frame that one of ORR_ELEMENTS_FRAMES names.
orr_elements_frame orr_elements_frame_of(const char *word);
// The method that one of ORR_ELEMENTS_METHODS names.
orr_elements_method orr_elements_method_of(const char *word);

// An angle in degrees, from 0 to what ten decimals still show as less than 360.
double orr_elements_degrees(double angle_rad);

// The names of columns, without the end of the line.
void orr_elements_csv_head(FILE *f);
// One row, without its end.
void orr_elements_csv_row(FILE *f, orr_time t, const char *sat, const orr_kepler *k);

#endif

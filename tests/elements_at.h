// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of one satellite at one instant, its axes made for it alone.
#ifndef ORR_TESTS_ELEMENTS_AT_H
#define ORR_TESTS_ELEMENTS_AT_H

#include "orbit/elements/elements.h"

static inline orr_status elements_at(const orr_ephemeris *e, orr_sat sat, orr_time t,
                                     const orr_elements_options *o, orr_kepler *out)
{
    orr_elements_axes axes;
    orr_elements_axes_at(t, o, &axes);
    return orr_elements_of(e, sat, &axes, out);
}

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// What is not known. C's own NAN is a float, whose silent widening clang warns of.
#ifndef ORR_CORE_NAN_H
#define ORR_CORE_NAN_H

#include <math.h>

#define ORR_NAN ((double)NAN)

#endif

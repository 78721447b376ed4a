// SPDX-License-Identifier: GPL-3.0-or-later
// A product made satellite by satellite, as the smoother ends with each, so that never more than a few are in memory: what
// is done with lies in a file without a name beside the output. The product of them is as orr_ephemeris_build makes it.
#ifndef ORR_ORBIT_EPHEMERIS_EPHEMERIS_PARTS_H
#define ORR_ORBIT_EPHEMERIS_EPHEMERIS_PARTS_H

#include "orbit/ephemeris/ephemeris.h"

typedef struct orr_ephemeris_parts orr_ephemeris_parts;

// None yet; the file is in `folder`. ORR_E_IO, ORR_E_MEMORY. Free with orr_ephemeris_parts_free.
orr_status orr_ephemeris_parts_begin(const char *folder, orr_ephemeris_parts **out, orr_diag *diag);
// Fits a satellite and puts it aside, in the place of what was given of it before; one without arcs is none. Threads may call
// it at once. Errors as of orr_ephemeris_build; after the first one all later calls fail likewise.
orr_status orr_ephemeris_parts_add(orr_ephemeris_parts *p, const orr_orbit_sat *sat);
// Why orr_ephemeris_parts_add failed, if it did; else *diag stays as it is.
void orr_ephemeris_parts_error(const orr_ephemeris_parts *p, orr_diag *diag);
// All that were given as one product.
// Given:
//   p     the parts
//   s     the solution they were of; its satellites are not looked at
// Returned:
//   out   the product: evaluated and saved as any other, its arrays are read from the file as they are used
//   diag  why there is none, that of orr_ephemeris_parts_add included
// Errors: as of orr_ephemeris_build.
orr_status orr_ephemeris_parts_join(orr_ephemeris_parts *p, const orr_orbit_solution *s, orr_ephemeris **out,
                                    orr_diag *diag);
// Frees what is left; NULL is allowed. The product stays.
void orr_ephemeris_parts_free(orr_ephemeris_parts *p);

#endif

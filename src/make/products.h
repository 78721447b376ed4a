// SPDX-License-Identifier: GPL-3.0-or-later
// Several orbit products as one, for commands that print from a week as from a day.
#ifndef ORR_MAKE_PRODUCTS_H
#define ORR_MAKE_PRODUCTS_H

#include "orbit/ephemeris/ephemeris.h"

typedef struct orr_products {
    size_t n, n_sats;
    orr_ephemeris **item; // ascending by begin
    orr_sat *sat;         // of all, ascending
    orr_time from, to;    // from the first begin to the last end
} orr_products;

// Loads n > 0 products, named in any order. Warnings: products in different frames, hours that no product covers.
// Errors: those of orr_ephemeris_load; ORR_E_MEMORY. Free with orr_products_free whatever it returned.
orr_status orr_products_open(const char *const *path, size_t n, orr_products *out, orr_warnings *warnings,
                             orr_diag *diag);
// Frees all of it; it is empty then.
void orr_products_free(orr_products *p);
// The product that an instant belongs to: of two that meet there the earlier. NULL where none covers it.
const orr_ephemeris *orr_products_at(const orr_products *p, orr_time t);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Several orbit products as one, for commands that print from a week as from a day.
#ifndef ORR_MAKE_PRODUCTS_H
#define ORR_MAKE_PRODUCTS_H

#include "ingest/input/sniff.h"
#include "orbit/ephemeris/ephemeris.h"

typedef struct orr_products {
    size_t n, n_sats;
    const orr_ephemeris **item; // ascending by begin
    orr_ephemeris **own;        // those that are freed with it; NULL: none
    orr_sat *sat;               // of all, ascending
    orr_time from, to;          // from the first begin to the last end
} orr_products;

// Loads one product (orr_ephemeris_load); of a file of another kind it says which, and what makes a product of it.
orr_status orr_product_load(const char *path, orr_ephemeris **out, orr_diag *diag);
// What kind of file it is, by its first lines; ORR_KIND_UNKNOWN where it cannot be read.
orr_kind orr_product_kind(const char *path);

// Loads products.
// Given:
//   path      [n] files, in any order
//   n         how many, at least one
// Returned:
//   out       the products; free with orr_products_free whatever this returned
//   warnings  products in different frames, hours that no product covers; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of orr_ephemeris_load; ORR_E_MEMORY.
orr_status orr_products_open(const char *const *path, size_t n, orr_products *out, orr_warnings *warnings,
                             orr_diag *diag);
// One product that is there already, which is borrowed. ORR_E_MEMORY.
orr_status orr_products_of(const orr_ephemeris *e, orr_products *out, orr_diag *diag);
// Frees all of it; it is empty then.
void orr_products_free(orr_products *p);
// The product that an instant belongs to: of two that meet there the earlier. NULL where none covers it.
const orr_ephemeris *orr_products_at(const orr_products *p, orr_time t);

#endif

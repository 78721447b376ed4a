// SPDX-License-Identifier: GPL-3.0-or-later
// What IGS products are called, of both eras, and which mirrors keep them: facts that change, so they are
// data (ingest/fetch/archives.txt, built in; a user's copy replaces it) and not code.
#ifndef ORR_INGEST_FETCH_ARCHIVES_H
#define ORR_INGEST_FETCH_ARCHIVES_H

#include "core/status.h"
#include "core/time.h"
#include "ingest/input/sniff.h"

typedef enum orr_product {
    ORR_PRODUCT_SP3,
    ORR_PRODUCT_NAV,
    ORR_PRODUCT_IONEX,
    ORR_PRODUCT_ION,
    ORR_PRODUCT_ERP,
    ORR_PRODUCT_CLK,
    ORR_PRODUCT_BIAS,
    ORR_PRODUCT_SINEX,
    ORR_PRODUCT_OBS,
    ORR_PRODUCT_ANTEX, // of the frame of the day's orbits
    ORR_PRODUCT_N
} orr_product;
typedef enum orr_tier { // best first: fallback goes down
    ORR_TIER_FINAL,
    ORR_TIER_RAPID,
    ORR_TIER_ULTRA,
    ORR_TIER_PREDICTED,
    ORR_TIER_NONE, // broadcast and observations have none
} orr_tier;

const char *orr_product_name(orr_product p);                          // "sp3"
bool orr_product_parse(const char *name, size_t n, orr_product *out); // false: no product has that name
bool orr_product_holds(orr_product p, orr_kind kind); // whether a file of that kind is one of this product
const char *orr_tier_name(orr_tier t);                // "final"
bool orr_tier_parse(const char *name, size_t n, orr_tier *out); // false: no tier has that name

typedef struct orr_archives orr_archives;
// Reads a table of archives; `path` NULL: the built-in one. Errors: ORR_E_IO, ORR_E_FORMAT with file:line, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_archives_read(const char *path, orr_archives **out, orr_diag *diag);
// Reads such a table from memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes
//   Returned: out         the table, to be freed with orr_archives_free; NULL on failure
//             diag        ORR_E_FORMAT with file:line, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_archives_parse(const char *name, const char *text, size_t n, orr_archives **out,
                              orr_diag *diag);
void orr_archives_free(orr_archives *a);     // NULL is allowed
const char *orr_archives_builtin(size_t *n); // its text

// One place where a file of a product for a day may be.
typedef struct orr_candidate {
    orr_tier tier;
    char centre[8]; // "-" where it has none
    char name[128]; // of the file
    char mirror[32];
    int mirror_index; // equal for candidates of one mirror line
    char url[512];
    bool login;
    int32_t folder_mjd; // the day the file is kept under (a week's Sunday for weekly files)
} orr_candidate;

// What is asked for. centre empty: any, in the table's order. station: four or nine characters, for obs
// alone.
typedef struct orr_wanted {
    orr_product product;
    int32_t mjd; // the (GPS) day
    char centre[8];
    orr_tier tier; // best that is wanted
    char station[10];
} orr_wanted;

// All places where a product may be, best first: tiers from w->tier down, names in the table's order, mirrors in
// the table's order.
//   Given:    a           the table
//             w           what is wanted
//   Returned: out, n      the n candidates, to be freed with free()
//             diag        ORR_E_NODATA if the table knows no name for it (and what it knows), ORR_E_MEMORY
orr_status orr_archives_candidates(const orr_archives *a, const orr_wanted *w, orr_candidate **out, size_t *n,
                                   orr_diag *diag);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// ARCHIVE/catalogue.sqlite. Everything in it can be had again from the days: whatever is wrong with the file, it is left
// aside or made anew.
#ifndef ORR_ARCHIVE_CATALOGUE_CACHE_H
#define ORR_ARCHIVE_CATALOGUE_CACHE_H

#include "src/archive/catalogue.h"

#define ORR_CATALOGUE_FILE "catalogue.sqlite"

typedef struct orr_catalogue_cache orr_catalogue_cache;
// NULL, with a warning, where no file can be had (a read-only archive): the functions below then do nothing.
orr_catalogue_cache *orr_catalogue_cache_open(const char *archive, orr_warnings *warnings);
// Keeps what was added. NULL is allowed.
void orr_catalogue_cache_close(orr_catalogue_cache *c, orr_warnings *warnings);

// The joint of two products, by their SHA-256.
//   Given:    c           the cache; NULL: nothing is known
//             a, b        hashes of the products of a day and the next
//   Returned: out         the joint, where it is known
//             (value)     whether it is
bool orr_catalogue_cache_joint(orr_catalogue_cache *c, const char *a, const char *b,
                               orr_catalogue_joint *out);
// Keeps a joint.
//   Given:    c           the cache; NULL: nothing happens
//             a, b        hashes of the products of a day and the next
//             joint       how they meet
void orr_catalogue_cache_keep(orr_catalogue_cache *c, const char *a, const char *b,
                              const orr_catalogue_joint *joint);
// Replaces the table of days.
void orr_catalogue_cache_days(orr_catalogue_cache *c, const orr_catalogue *days);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Files of studies: each study has a root table of its own, and all begin with the same head. The commands of
// src/cli/study read them.
#ifndef ORR_CONFIG_STUDY_H
#define ORR_CONFIG_STUDY_H

#include "src/config/schema.h"

// Head of every study's file: the first member of its struct.
typedef struct orr_study_head {
    char *title;
    int64_t seed;
} orr_study_head;
// Rows of the head; T is the struct, whose member `head` it is (src/config/rows_private.h).
#define ORR_STUDY_HEAD(T)                                                                                    \
    TEXT_ROW(T, "title", head.title, NULL, "what is studied"),                                               \
        INT_ROW(T, "seed", head.seed, 0, 9e15, "1", NULL, "of everything random")

// Reads and checks a study's file.
//   Given:    schema        the root table of this study
//             name          of the file, for sentences; files that it names are relative to its folder
//             text, n       its bytes
//             leap          table of leap seconds, for times; NULL: built-in
//   Returned: base          schema->size bytes; free with orr_schema_free
//   Notes:    ORR_E_FORMAT and ORR_E_KIND with line, column and path, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_study_parse(const orr_schema *schema, const char *name, const char *text, size_t n,
                           const orr_leap_table *leap, void *base, orr_diag *diag);

#endif

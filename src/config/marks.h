// SPDX-License-Identifier: GPL-3.0-or-later
// Where in a scenario's file each key stands, for what turns out to be wrong after it was read: errors of the engine name
// file, line and key as those of reading do.
#ifndef ORR_CONFIG_MARKS_H
#define ORR_CONFIG_MARKS_H

#include "src/config/yaml.h"

typedef struct orr_mark {
    char *path;   // "antennas[1].type"
    char *text;   // the value where it is a text; NULL
    int64_t line; // of the value, from 1
    int column;   // from 1
} orr_mark;

typedef struct orr_marks {
    char file[256];
    size_t n;
    orr_mark *item; // in the order of the file
} orr_marks;

// The marks of a tree. ORR_E_MEMORY. Free with orr_marks_free.
orr_status orr_marks_of(const orr_yaml *y, orr_marks *out, orr_diag *diag);
// Frees them; zeroed marks may be freed.
void orr_marks_free(orr_marks *m);

// Blames a key: "FILE:LINE:COLUMN: path: sentence". Of a key that the file does not have the map that it would stand in is
// named; without a file the sentence alone with the path.
//   Given:    m             the marks
//             status        class of the failure
//             path          of the key
//             sentence      what is wrong
//   Returned: (value)       status
//             diag          may be NULL
orr_status orr_marks_blame(const orr_marks *m, orr_status status, const char *path, const char *sentence,
                           orr_diag *diag);
// Brings a failure without a line to the file's: one that tells of a file as a whole to the key that names that file, one whose
// sentence begins with a key ("mask.elevation: ...") to that key, if there is one.
void orr_marks_locate(const orr_marks *m, orr_diag *diag);

#endif

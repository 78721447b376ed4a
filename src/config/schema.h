// SPDX-License-Identifier: GPL-3.0-or-later
// One table says what a scenario file may contain: where each value stands in the file and in memory, its
// kind, unit, default and help. Reading, refusing unknown keys, freeing and `orrery serve --help-scenario`
// all follow from it.
#ifndef ORR_CONFIG_SCHEMA_H
#define ORR_CONFIG_SCHEMA_H

#include "core/interval.h"
#include "core/sat.h"
#include "core/time.h"
#include "src/config/yaml.h"

// What a value is, and the member that holds it. A list of them is a struct { size_t n; T *item; }.
typedef enum orr_key_kind {
    ORR_KEY_TEXT,     // char *
    ORR_KEY_FILE,     // char *, relative to the scenario's folder in the file, joined with it in memory
    ORR_KEY_BOOL,     // bool: true, false, yes, no
    ORR_KEY_INT,      // int64_t within [min, max]
    ORR_KEY_REAL,     // double, finite, within [min, max]
    ORR_KEY_CHOICE,   // int: index into `choices`, words divided by '|'
    ORR_KEY_TIME,     // orr_time, as on the command line
    ORR_KEY_DURATION, // int64_t ns, as on the command line ("900", "15min")
    ORR_KEY_INTERVAL, // orr_interval: "FROM/TO"
    ORR_KEY_SATS,     // orr_sat_set: "G,R,E01-E09"
    ORR_KEY_RECORDS,  // list alone: maps that follow the table `record`
} orr_key_kind;

typedef struct orr_schema orr_schema;

typedef struct orr_key {
    const char *path; // "orbit.nodes": sections divided by dots
    orr_key_kind kind;
    bool list;            // a list of such values; one value alone is a list of one
    bool required;        // in its map, if that map is there
    size_t offset;        // of the member in the struct
    double min, max;      // of INT and REAL; both 0: no bounds
    const char *unit;     // "s", "m", "deg"; NULL
    const char *fallback; // as it would stand in the file; NULL: zero, or none
    const char *choices;
    const orr_schema *record;
    const char *help; // one sentence, without the default
} orr_key;

struct orr_schema {
    const orr_key *key;
    size_t n;
    size_t size; // of the struct that offsets refer to
};

typedef struct orr_text_list {
    size_t n;
    char **item;
} orr_text_list;
typedef struct orr_interval_list {
    size_t n;
    orr_interval *item;
} orr_interval_list;
typedef struct orr_real_list {
    size_t n;
    double *item;
} orr_real_list;

#define ORR_SCHEMA_MAX_LIST 100000

// Reads the tree into *base (size bytes, zeroed by this), defaults first. `folder` is joined to FILE values
// that are relative (NULL: as they stand). Errors: ORR_E_FORMAT with line, column and path (an unknown key
// with the nearest known one), ORR_E_LIMIT, ORR_E_MEMORY; *base then holds nothing. Free with
// orr_schema_free.
orr_status orr_schema_read(const orr_schema *schema, const orr_yaml *y, const char *folder, void *base,
                           orr_diag *diag);
void orr_schema_free(const orr_schema *schema, void *base);

// "file", "list of files", "whole number", ...: a kind in words, for help.
const char *orr_schema_kind_words(const orr_key *key);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that say what a YAML file may contain: where each value stands in the file and in memory, its kind,
// unit, default, help, and the conditions under which it has an effect. Reading, refusing what is unknown or
// without effect, freeing and the help for people all follow from them. A table describes one map; maps
// within maps and lists of maps have tables of their own, so that a section can serve several files (the
// scenario, a study).
#ifndef ORR_CONFIG_SCHEMA_H
#define ORR_CONFIG_SCHEMA_H

#include <stdio.h>

#include "core/interval.h"
#include "core/sat.h"
#include "core/time.h"
#include "src/config/yaml.h"

// What a value is, and the member that holds it. A list of them is a struct { size_t n; T *item; }.
typedef enum orr_key_kind {
    ORR_KEY_TEXT,     // char *
    ORR_KEY_FILE,     // char *, relative to the file's folder in the file, joined with it in memory
    ORR_KEY_BOOL,     // bool: true, false, yes, no
    ORR_KEY_INT,      // int64_t within [min, max]
    ORR_KEY_REAL,     // double, finite, within [min, max]
    ORR_KEY_CHOICE,   // int: the value of one of `choice`
    ORR_KEY_TIME,     // orr_time, as on the command line
    ORR_KEY_DURATION, // int64_t ns, as on the command line ("900", "15min")
    ORR_KEY_INTERVAL, // orr_interval: "FROM/TO"
    ORR_KEY_SATS,     // orr_sat_set: "G,R,E01-E09"
    ORR_KEY_MAP,      // the struct of the table `map`, in place
} orr_key_kind;

// A word of a CHOICE, the value that it stands for, and what it means. An enum and its words are one list:
//   #define COLOURS(X) X(COLOUR_RED, "red", "...") X(COLOUR_BLUE, "blue", "...")
//   typedef enum colour { COLOURS(ORR_CHOICE_VALUE) } colour;
//   static const orr_choice colours[] = {COLOURS(ORR_CHOICE_WORD){0}};
typedef struct orr_choice {
    const char *word; // NULL ends the list
    int value;
    const char *help;
} orr_choice;
#define ORR_CHOICE_VALUE(value, word, help) value,
#define ORR_CHOICE_WORD(value, word, help) {word, value, help},

// What must hold for a key to have an effect. `key` is a path from the key's own map ("kind",
// "survey.lines"; "../trajectory" is beside the map that holds this one); '|' divides keys of which one is
// enough. They must be given in the file, or with `words` have one of these words (given or by default).
typedef struct orr_condition {
    const char *key;   // NULL: none
    const char *words; // of a CHOICE or BOOL, divided by '|'; NULL: the key must be given
    bool absent;       // the key must not be given
    int64_t least;     // of an INT: it must be at least this, given or by default; 0: no such condition
    const char *why;   // added to the sentence that refuses; may be NULL
} orr_condition;

typedef struct orr_schema orr_schema;

typedef struct orr_key {
    const char *name; // as it stands in its map
    orr_key_kind kind;
    bool list;            // a list of such values; one value alone is a list of one
    bool required;        // in its map, if that map is there and the conditions hold
    size_t offset;        // of the member in the struct
    size_t given;         // of a bool in the struct that tells whether the file has the key; 0: none
    double min, max;      // of INT and REAL; both 0: no bounds
    size_t least, most;   // members of a list; most 0: ORR_SCHEMA_MAX_LIST
    const char *unit;     // "s", "m", "deg"; NULL
    const char *fallback; // as it would stand in the file; NULL: zero, or none
    const orr_choice *choice;
    const orr_schema *map;
    const orr_condition *only; // all must hold; ends with {0}; NULL: always
    const char *help;          // one sentence, without default and conditions
} orr_key;

enum { ORR_SCHEMA_WHY = 200 };

struct orr_schema {
    const orr_key *key;
    size_t n;
    size_t size; // of the struct that offsets refer to
    // What one key means for another and the conditions cannot say: NULL where all is well, else the name of
    // the key to blame ("" for the map itself) and a sentence in why. NULL: nothing to check.
    const char *(*check)(const void *map, char why[ORR_SCHEMA_WHY]);
    const char *hint; // of a whole file: where all keys are told; NULL
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

// Reads a tree into a struct by its table, defaults first.
// Given:
//   schema  table of the root map
//   y       the tree
//   folder  joined to FILE values that are relative; NULL: they stay as they are
//   leap    table of leap seconds, for times; NULL: built-in
// Returned:
//   base    schema->size bytes, zeroed first; nothing to free after an error. Free with orr_schema_free
//   diag    why it failed; may be NULL
// Errors: ORR_E_FORMAT with line, column and path (an unknown key with the nearest known one, a key without
// effect with the reason), ORR_E_KIND for a file that is no map, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_schema_read(const orr_schema *schema, const orr_yaml *y, const char *folder,
                           const orr_leap_table *leap, void *base, orr_diag *diag);
// Shows every file that a tree names, until one is refused.
// Given:
//   schema  table of the root map
//   base    what orr_schema_read filled
//   see     told each path; false ends it
//   user    handed to see
// Returns whether none was refused.
bool orr_schema_files(const orr_schema *schema, const void *base, bool (*see)(void *user, const char *path),
                      void *user);
// Frees what orr_schema_read allocated below `base`, and zeroes it.
void orr_schema_free(const orr_schema *schema, void *base);

// "file", "list of files", "whole number", ...: a kind in words.
const char *orr_schema_kind_words(const orr_key *key);

// All keys for people: what each is, with unit, bounds, default and when it has an effect.
void orr_schema_describe(const orr_schema *schema, FILE *to);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Whether keys of a file have an effect, by the conditions of their tables.
#ifndef ORR_CONFIG_CONDITIONS_H
#define ORR_CONFIG_CONDITIONS_H

#include "src/config/schema.h"

// A map of the file with its table, and the map that holds it.
typedef struct orr_map_scope orr_map_scope;
struct orr_map_scope {
    const orr_schema *schema;
    const orr_yaml_node *map;
    const orr_map_scope *up; // NULL at the top
    const char *path;        // of the map in the file: "trajectory", "units[1]"; "" at the top
};

const orr_yaml_node *orr_map_member(const orr_yaml_node *map, const char *key); // NULL where it is not there
const orr_key *orr_schema_find(const orr_schema *schema, const char *key, size_t n); // NULL: unknown

// Whether a member has anything in it: "key:" with nothing behind it, and an empty map, are not given.
bool orr_node_given(const orr_yaml_node *node);

// The first condition of `key` that does not hold in `scope`, NULL where all hold.
const orr_condition *orr_condition_broken(const orr_map_scope *scope, const orr_key *key);
// The sentence for it: "has no effect without ...".
void orr_condition_sentence(const orr_map_scope *scope, const orr_condition *c, char *out, size_t n);
// The condition in words, for help: "only with kind survey or waypoints".
void orr_condition_words(const orr_condition *c, char *out, size_t n);

#endif

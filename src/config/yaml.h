// SPDX-License-Identifier: GPL-3.0-or-later
// A YAML text as a tree that remembers where everything stands, so that a refused value can name its line and
// column. libfyaml scans; what is not needed (aliases, tags, several documents) is refused
// here, and so is whatever could make a small text large.
#ifndef ORR_CONFIG_YAML_H
#define ORR_CONFIG_YAML_H

#include "core/status.h"

enum {
    ORR_YAML_MAX_BYTES = 4 << 20,
    ORR_YAML_MAX_NODES = 100000,
    ORR_YAML_MAX_DEPTH = 24,
    ORR_YAML_MAX_KEYS = 1000, // of one map
};

typedef enum orr_yaml_kind { ORR_YAML_TEXT, ORR_YAML_MAP, ORR_YAML_LIST } orr_yaml_kind;

typedef struct orr_yaml_node orr_yaml_node;
struct orr_yaml_node {
    orr_yaml_kind kind;
    bool quoted; // of a text: it stood in quotes, or was a block
    bool tagged;
    char *text;   // of a text: NUL-terminated, without NUL inside
    char *key;    // of a member of a map; NULL otherwise
    int64_t line; // of the value, from 1
    int column;   // from 1, in characters
    int64_t key_line;
    int key_column;
    size_t n;                    // members
    orr_yaml_node *first, *next; // first member; next member of the parent
    orr_yaml_node *last, *parent, *made_before;
};

typedef struct orr_yaml {
    char name[256];      // of the file, for messages
    orr_yaml_node *root; // NULL for an empty text
    orr_yaml_node *made; // all nodes, newest first
    size_t n_nodes;
} orr_yaml;

// "map", "list", "text".
const char *orr_yaml_kind_name(orr_yaml_kind k);
// Errors: ORR_E_IO, ORR_E_LIMIT, ORR_E_FORMAT (with line and column), ORR_E_MEMORY. Free with orr_yaml_free.
orr_status orr_yaml_read(const char *path, orr_yaml *out, orr_diag *diag);
// The same from memory.
// Given:
//   name  of the file, for messages
//   text  [n] its bytes
//   n     how many
// Returned:
//   out   the tree; free with orr_yaml_free
//   diag  why it failed, with line and column; may be NULL
// Errors: as of orr_yaml_read, without ORR_E_IO.
orr_status orr_yaml_parse(const char *name, const char *text, size_t n, orr_yaml *out, orr_diag *diag);
// The folder of a file as its path has it, which paths within the file are relative to: "" where the path has none. To be freed with
// free(); NULL: out of memory.
char *orr_yaml_folder(const char *path);
// Frees the tree.
void orr_yaml_free(orr_yaml *y);

#endif

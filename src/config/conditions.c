// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/conditions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS = 160 };

const orr_yaml_node *orr_map_member(const orr_yaml_node *map, const char *key)
{
    if (map->kind != ORR_YAML_MAP) return NULL;
    for (const orr_yaml_node *m = map->first; m != NULL; m = m->next)
        if (strcmp(m->key, key) == 0) return m;
    return NULL;
}

const orr_key *orr_schema_find(const orr_schema *schema, const char *key, size_t n)
{
    for (size_t i = 0; i < schema->n; i++)
        if (strlen(schema->key[i].name) == n && memcmp(schema->key[i].name, key, n) == 0)
            return &schema->key[i];
    return NULL;
}

bool orr_node_given(const orr_yaml_node *node)
{
    if (node == NULL) return false;
    return node->kind == ORR_YAML_TEXT ? node->quoted || node->text[0] != '\0' : node->n > 0;
}

// What a path leads to: the key of a table and its node in the file, which is NULL where it is not there.
typedef struct target {
    const orr_key *key;
    const orr_yaml_node *node;
    const orr_map_scope *scope; // that the path starts from after climbing
    const char *path;           // from there
    size_t n;
} target;

static target follow(const orr_map_scope *scope, const char *path, size_t n)
{
    while (n > 3 && strncmp(path, "../", 3) == 0 && scope->up != NULL) {
        scope = scope->up;
        path += 3;
        n -= 3;
    }
    target t = {.scope = scope, .path = path, .n = n};
    const orr_schema *schema = scope->schema;
    const orr_yaml_node *map = scope->map;
    for (size_t at = 0; schema != NULL; at++) {
        size_t m = 0;
        while (at + m < n && path[at + m] != '.') m++;
        t.key = orr_schema_find(schema, path + at, m);
        if (t.key == NULL) break;
        t.node = map != NULL ? orr_map_member(map, t.key->name) : NULL;
        at += m;
        if (at >= n) break;
        schema = t.key->map;
        map = t.node;
    }
    return t;
}

// The next of the parts that '|' divides; NULL behind the last.
static const char *part(const char *list, size_t *n)
{
    if (list == NULL || *list == '\0') return NULL;
    *n = strcspn(list, "|");
    return list;
}
static const char *behind(const char *list, size_t n) { return list[n] == '|' ? list + n + 1 : NULL; }

static bool is_yes(const char *text)
{
    return strcmp(text, "yes") == 0 || strcmp(text, "true") == 0 || strcmp(text, "on") == 0;
}

// What a CHOICE or BOOL says, given or by default, as a word of its table; NULL where it says nothing.
static const char *word_of(const target *t)
{
    if (t->key == NULL) return NULL;
    const char *text = t->key->fallback;
    if (orr_node_given(t->node)) text = t->node->kind == ORR_YAML_TEXT ? t->node->text : NULL;
    if (text == NULL || t->key->kind != ORR_KEY_BOOL) return text;
    return is_yes(text) ? "yes" : "no";
}

static bool among(const char *word, const char *words)
{
    size_t n;
    for (const char *p = words; word != NULL && (p = part(p, &n)) != NULL; p = behind(p, n))
        if (strlen(word) == n && memcmp(word, p, n) == 0) return true;
    return false;
}

// What an INT says, given or by default; 0 where it says nothing.
static int64_t number_of(const target *t)
{
    if (t->key == NULL) return 0;
    const char *text = t->key->fallback;
    if (orr_node_given(t->node)) text = t->node->kind == ORR_YAML_TEXT ? t->node->text : NULL;
    return text != NULL ? strtoll(text, NULL, 10) : 0;
}

static bool holds(const orr_map_scope *scope, const orr_condition *c)
{
    size_t n;
    for (const char *p = c->key; (p = part(p, &n)) != NULL; p = behind(p, n)) {
        target t = follow(scope, p, n);
        bool yes = c->words != NULL ? among(word_of(&t), c->words)
                   : c->least != 0  ? number_of(&t) >= c->least
                                    : orr_node_given(t.node);
        if (yes) return !c->absent;
    }
    return c->absent;
}

const orr_condition *orr_condition_broken(const orr_map_scope *scope, const orr_key *key)
{
    for (const orr_condition *c = key->only; c != NULL && c->key != NULL; c++)
        if (!holds(scope, c)) return c;
    return NULL;
}

// "a, b or c" of the parts that '|' divides, each behind `prefix`.
static void enumerate(const char *list, const char *prefix, char *out, size_t size)
{
    size_t n, at = 0;
    out[0] = '\0';
    for (const char *p = list, *next; (p = part(p, &n)) != NULL && at + n < size; p = next) {
        next = behind(p, n);
        const char *glue = at == 0 ? "" : next == NULL ? " or " : ", ";
        at += (size_t)snprintf(out + at, size - at, "%s%s%.*s", glue, prefix, (int)n, p);
    }
}

void orr_condition_sentence(const orr_map_scope *scope, const orr_condition *c, char *out, size_t size)
{
    size_t n = strcspn(c->key, "|");
    const char *first = c->key, *why = c->why != NULL ? c->why : "";
    target t = follow(scope, first, n);
    char prefix[WORDS] = "", keys[2 * WORDS], words[WORDS];
    if (t.scope->path[0] != '\0') snprintf(prefix, sizeof prefix, "%.150s.", t.scope->path);
    const char *list = first;
    while (strncmp(list, "../", 3) == 0) list += 3;
    enumerate(list, prefix, keys, sizeof keys);
    const char *colon = *why != '\0' ? ": " : "";
    if (c->words != NULL) {
        const char *now = word_of(&t);
        enumerate(c->words, "", words, sizeof words);
        if (now != NULL)
            snprintf(out, size, "has no effect with %s %.60s; it belongs to %s %s%s%s", keys, now, keys,
                     words, colon, why);
        else
            snprintf(out, size, "has no effect without %s %s%s%s", keys, words, colon, why);
    } else if (c->least != 0) {
        snprintf(out, size, "has no effect with %s %lld; it needs %lld or more%s%s", keys,
                 (long long)number_of(&t), (long long)c->least, colon, why);
    } else if (c->absent) {
        snprintf(out, size, "cannot stand beside %s%s%s", keys, colon, why);
    } else {
        snprintf(out, size, "has no effect without %s%s%s", keys, colon, why);
    }
}

void orr_condition_words(const orr_condition *c, char *out, size_t size)
{
    char keys[WORDS], words[WORDS];
    const char *list = c->key;
    while (strncmp(list, "../", 3) == 0) list += 3;
    enumerate(list, "", keys, sizeof keys);
    if (c->words != NULL) {
        enumerate(c->words, "", words, sizeof words);
        snprintf(out, size, "only with %s %s", keys, words);
    } else if (c->least != 0) {
        snprintf(out, size, "only with %s of %lld or more", keys, (long long)c->least);
    } else {
        snprintf(out, size, "%s %s", c->absent ? "not with" : "only with", keys);
    }
}

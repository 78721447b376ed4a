// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/schema.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/suggest.h"
#include "src/config/conditions.h"

enum { PATH_MAX_CHARS = 200 };

typedef struct reader {
    const char *name;   // of the file
    const char *folder; // that FILE values are relative to
    const orr_leap_table *leap;
    orr_diag *diag;
} reader;

typedef struct any_list { // every list member begins so
    size_t n;
    void *item;
} any_list;

static size_t kind_size(const orr_key *k)
{
    switch (k->kind) {
    case ORR_KEY_TEXT:
    case ORR_KEY_FILE:
        return sizeof(char *);
    case ORR_KEY_BOOL:
        return sizeof(bool);
    case ORR_KEY_INT:
    case ORR_KEY_DURATION:
        return sizeof(int64_t);
    case ORR_KEY_REAL:
        return sizeof(double);
    case ORR_KEY_CHOICE:
        return sizeof(int);
    case ORR_KEY_TIME:
        return sizeof(orr_time);
    case ORR_KEY_INTERVAL:
        return sizeof(orr_interval);
    case ORR_KEY_SATS:
        return sizeof(orr_sat_set);
    case ORR_KEY_MAP:
        return k->map->size;
    }
    return 0;
}

const char *orr_schema_kind_words(const orr_key *k)
{
    switch (k->kind) {
    case ORR_KEY_TEXT:
        return k->list ? "list of texts" : "text";
    case ORR_KEY_FILE:
        return k->list ? "list of files" : "file";
    case ORR_KEY_BOOL:
        return "yes or no";
    case ORR_KEY_INT:
        return k->list ? "list of whole numbers" : "whole number";
    case ORR_KEY_REAL:
        return k->list ? "list of numbers" : "number";
    case ORR_KEY_CHOICE:
        return k->list ? "list of" : "one of";
    case ORR_KEY_TIME:
        return k->list ? "list of times" : "time";
    case ORR_KEY_DURATION:
        return "length of time";
    case ORR_KEY_INTERVAL:
        return k->list ? "list of FROM/TO" : "FROM/TO";
    case ORR_KEY_SATS:
        return "satellites";
    case ORR_KEY_MAP:
        return k->list ? "list of maps" : "map";
    }
    return "?";
}

static orr_status refuse(const reader *r, const orr_yaml_node *node, const char *path, const char *what)
{
    return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, node->line, node->column, "%s: %s", path, what);
}

static orr_status out_of_memory(const reader *r)
{
    return orr_diag_set(r->diag, ORR_E_MEMORY, "out of memory");
}

static orr_status join_path(const reader *r, const char *text, char **out)
{
    bool absolute = text[0] == '/' || r->folder == NULL || r->folder[0] == '\0';
    size_t n = (absolute ? 0 : strlen(r->folder) + 1) + strlen(text) + 1;
    char *made = malloc(n);
    if (made == NULL) return out_of_memory(r);
    made[0] = '\0';
    if (!absolute) {
        strcat(made, r->folder);
        strcat(made, "/");
    }
    strcat(made, text);
    *out = made;
    return ORR_OK;
}

static orr_status read_number(const reader *r, const orr_key *k, const orr_yaml_node *node, const char *path,
                              void *to)
{
    char *end, sentence[160];
    errno = 0;
    bool whole = k->kind == ORR_KEY_INT;
    double v = strtod(node->text, &end);
    long long i = 0;
    if (whole) {
        errno = 0;
        i = strtoll(node->text, &end, 10);
        v = (double)i;
    }
    if (end == node->text || *end != '\0' || errno == ERANGE || !isfinite(v)) {
        snprintf(sentence, sizeof sentence, "'%.60s' is no %s", node->text,
                 whole ? "whole number" : "number");
        return refuse(r, node, path, sentence);
    }
    bool bounded = k->min != 0 || k->max != 0;
    if (bounded && !(v >= k->min && v <= k->max)) {
        snprintf(sentence, sizeof sentence, "%.60s is outside %.16g to %.16g%s%s", node->text, k->min, k->max,
                 k->unit != NULL ? " " : "", k->unit != NULL ? k->unit : "");
        return refuse(r, node, path, sentence);
    }
    if (whole)
        *(int64_t *)to = i;
    else
        *(double *)to = v;
    return ORR_OK;
}

static orr_status read_bool(const reader *r, const orr_yaml_node *node, const char *path, bool *to)
{
    static const char *const yes[] = {"true", "yes", "on"}, *const no[] = {"false", "no", "off"};
    for (size_t i = 0; i < 3; i++) {
        if (strcmp(node->text, yes[i]) == 0) return *to = true, ORR_OK;
        if (strcmp(node->text, no[i]) == 0) return *to = false, ORR_OK;
    }
    char sentence[120];
    snprintf(sentence, sizeof sentence, "'%.60s' is neither yes nor no", node->text);
    return refuse(r, node, path, sentence);
}

static orr_status read_choice(const reader *r, const orr_key *k, const orr_yaml_node *node, const char *path,
                              int *to)
{
    char sentence[300];
    int at = snprintf(sentence, sizeof sentence, "'%.60s' is none of", node->text);
    for (const orr_choice *c = k->choice; c->word != NULL; c++) {
        if (strcmp(c->word, node->text) == 0) return *to = c->value, ORR_OK;
        if (at < (int)sizeof sentence)
            at += snprintf(sentence + at, sizeof sentence - (size_t)at, "%s %s", c == k->choice ? "" : ",",
                           c->word);
    }
    return refuse(r, node, path, sentence);
}

static orr_status read_interval(const char *text, const orr_leap_table *leap, orr_interval *to, orr_diag *d)
{
    const char *slash = strchr(text, '/');
    char from[64];
    if (slash == NULL || (size_t)(slash - text) >= sizeof from)
        return orr_diag_set(d, ORR_E_ARG, "'%.80s' is no interval FROM/TO", text);
    memcpy(from, text, (size_t)(slash - text));
    from[slash - text] = '\0';
    orr_status s = orr_time_parse(from, leap, &to->from, d);
    if (s == ORR_OK) s = orr_time_parse(slash + 1, leap, &to->to, d);
    if (s == ORR_OK && to->to < to->from)
        s = orr_diag_set(d, ORR_E_ARG, "'%.80s' ends before it begins", text);
    return s;
}

static orr_status read_map(const reader *r, const orr_schema *schema, const orr_yaml_node *map,
                           const orr_map_scope *up, const char *path, char *base);

// One value into *to; `scope` is the map that it stands in.
static orr_status read_value(const reader *r, const orr_key *k, const orr_yaml_node *node,
                             const orr_map_scope *scope, const char *path, void *to)
{
    if (k->kind == ORR_KEY_MAP) {
        if (node->kind != ORR_YAML_MAP) return refuse(r, node, path, "a map with keys is wanted here");
        return read_map(r, k->map, node, scope, path, to);
    }
    if (node->kind != ORR_YAML_TEXT) {
        char sentence[120];
        snprintf(sentence, sizeof sentence, "a %s is wanted here, not a %s", orr_schema_kind_words(k),
                 orr_yaml_kind_name(node->kind));
        return refuse(r, node, path, sentence);
    }
    if (node->text[0] == '\0' && !node->quoted) return refuse(r, node, path, "has no value");
    orr_diag inner = {0};
    orr_status s = ORR_OK;
    switch (k->kind) {
    case ORR_KEY_TEXT:
        *(char **)to = strdup(node->text);
        return *(char **)to == NULL ? out_of_memory(r) : ORR_OK;
    case ORR_KEY_FILE:
        return join_path(r, node->text, to);
    case ORR_KEY_BOOL:
        return read_bool(r, node, path, to);
    case ORR_KEY_INT:
    case ORR_KEY_REAL:
        return read_number(r, k, node, path, to);
    case ORR_KEY_CHOICE:
        return read_choice(r, k, node, path, to);
    case ORR_KEY_TIME:
        s = orr_time_parse(node->text, r->leap, to, &inner);
        break;
    case ORR_KEY_DURATION:
        s = orr_duration_parse(node->text, to, &inner);
        if (s == ORR_OK && *(int64_t *)to <= 0)
            s = orr_diag_set(&inner, ORR_E_ARG, "'%.60s' is no positive length of time", node->text);
        break;
    case ORR_KEY_INTERVAL:
        s = read_interval(node->text, r->leap, to, &inner);
        break;
    case ORR_KEY_SATS:
        s = orr_sat_set_parse(node->text, to, &inner);
        break;
    case ORR_KEY_MAP:
        break;
    }
    return s == ORR_OK ? ORR_OK : refuse(r, node, path, inner.text);
}

static orr_status check_count(const reader *r, const orr_key *k, const orr_yaml_node *node, const char *path,
                              size_t n)
{
    size_t most = k->most > 0 ? k->most : ORR_SCHEMA_MAX_LIST;
    if (n >= k->least && n <= most) return ORR_OK;
    char sentence[120];
    if (k->least == most)
        snprintf(sentence, sizeof sentence, "%zu members, where %zu are wanted", n, most);
    else
        snprintf(sentence, sizeof sentence, "%zu members, where %zu to %zu are possible", n, k->least, most);
    return refuse(r, node, path, sentence);
}

static orr_status set_defaults(const orr_schema *schema, const reader *r, char *base);

static orr_status read_list(const reader *r, const orr_key *k, const orr_yaml_node *node,
                            const orr_map_scope *scope, const char *path, any_list *to)
{
    size_t n = node->kind == ORR_YAML_LIST ? node->n : 1, size = kind_size(k);
    if (node->kind == ORR_YAML_TEXT && !orr_node_given(node)) return refuse(r, node, path, "has no value");
    orr_status counted = check_count(r, k, node, path, n);
    if (counted != ORR_OK || n == 0) return counted;
    to->item = calloc(n, size);
    if (to->item == NULL) return out_of_memory(r);
    const orr_yaml_node *member = node->kind == ORR_YAML_LIST ? node->first : node;
    for (; to->n < n; member = node->kind == ORR_YAML_LIST ? member->next : NULL) {
        char at[PATH_MAX_CHARS + 24];
        snprintf(at, sizeof at, "%s[%zu]", path, to->n);
        char *item = (char *)to->item + to->n * size;
        to->n++; // counted first: a half-read record is freed with the list
        orr_status s = k->kind == ORR_KEY_MAP ? set_defaults(k->map, r, item) : ORR_OK;
        if (s == ORR_OK) s = read_value(r, k, member, scope, node->kind == ORR_YAML_LIST ? at : path, item);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

static orr_status set_default(const orr_key *k, const reader *r, void *member)
{
    if (k->kind == ORR_KEY_MAP && !k->list) return set_defaults(k->map, r, member);
    if (k->fallback == NULL) return ORR_OK;
    orr_yaml_node text = {.kind = ORR_YAML_TEXT, .text = (char *)(uintptr_t)k->fallback};
    reader plain = {"(default)", NULL, NULL, r->diag};
    return k->list ? read_list(&plain, k, &text, NULL, k->name, member)
                   : read_value(&plain, k, &text, NULL, k->name, member);
}

static orr_status set_defaults(const orr_schema *schema, const reader *r, char *base)
{
    orr_status s = ORR_OK;
    for (size_t i = 0; s == ORR_OK && i < schema->n; i++)
        s = set_default(&schema->key[i], r, base + schema->key[i].offset);
    return s;
}

static bool see_value(const orr_key *k, const void *value, bool (*see)(void *, const char *), void *user)
{
    if (k->kind == ORR_KEY_MAP) return orr_schema_files(k->map, value, see, user);
    const char *path = k->kind == ORR_KEY_FILE ? *(char *const *)value : NULL;
    return path == NULL || see(user, path);
}

bool orr_schema_files(const orr_schema *schema, const void *base, bool (*see)(void *user, const char *path),
                      void *user)
{
    for (size_t i = 0; i < schema->n; i++) {
        const orr_key *k = &schema->key[i];
        const void *member = (const char *)base + k->offset;
        const any_list *list = member;
        if (!k->list && !see_value(k, member, see, user)) return false;
        for (size_t j = 0; k->list && j < list->n; j++)
            if (!see_value(k, (const char *)list->item + j * kind_size(k), see, user)) return false;
    }
    return true;
}

static void free_value(const orr_key *k, void *value)
{
    if (k->kind == ORR_KEY_TEXT || k->kind == ORR_KEY_FILE) {
        free(*(char **)value);
        *(char **)value = NULL;
    } else if (k->kind == ORR_KEY_MAP) {
        orr_schema_free(k->map, value);
    }
}

static void free_member(const orr_key *k, void *member)
{
    if (!k->list) {
        free_value(k, member);
        return;
    }
    any_list *list = member;
    for (size_t i = 0; i < list->n; i++) free_value(k, (char *)list->item + i * kind_size(k));
    free(list->item);
    list->item = NULL;
    list->n = 0;
}

void orr_schema_free(const orr_schema *schema, void *base)
{
    for (size_t i = 0; i < schema->n; i++) free_member(&schema->key[i], (char *)base + schema->key[i].offset);
}

// "trajectory.survey": the path of a member of the scope's map.
static void path_of(const orr_map_scope *scope, const char *key, char out[PATH_MAX_CHARS])
{
    const char *dot = scope->path[0] != '\0' ? "." : "";
    snprintf(out, PATH_MAX_CHARS, "%.120s%s%.60s", scope->path, dot, key);
}

static orr_status unknown_key(const reader *r, const orr_map_scope *scope, const orr_yaml_node *node)
{
    enum { MOST = 64 };
    const char *candidate[MOST];
    size_t n = scope->schema->n < MOST ? scope->schema->n : MOST;
    for (size_t i = 0; i < n; i++) candidate[i] = scope->schema->key[i].name;
    const char *near = orr_suggest_nearest(node->key, candidate, n);
    char path[PATH_MAX_CHARS], other[PATH_MAX_CHARS];
    path_of(scope, node->key, path);
    const orr_map_scope *top = scope;
    while (top->up != NULL) top = top->up;
    const char *hint = top->schema->hint;
    if (near == NULL)
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, node->key_line, node->key_column,
                           "unknown key '%s'%s%s%s", path, hint != NULL ? " (" : "", hint != NULL ? hint : "",
                           hint != NULL ? ")" : "");
    path_of(scope, near, other);
    return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, node->key_line, node->key_column,
                       "unknown key '%s'; did you mean '%s'?", path, other);
}

static orr_status refuse_key(const reader *r, const orr_map_scope *scope, const orr_yaml_node *node,
                             const char *what)
{
    char path[PATH_MAX_CHARS];
    path_of(scope, node->key, path);
    return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, node->key_line, node->key_column, "%s: %s", path,
                       what);
}

// Keys that must be there: those without conditions, or those whose conditions hold.
static orr_status check_required(const reader *r, const orr_map_scope *scope, bool conditional)
{
    for (size_t i = 0; i < scope->schema->n; i++) {
        const orr_key *k = &scope->schema->key[i];
        if (!k->required || (k->only != NULL) != conditional) continue;
        if (orr_condition_broken(scope, k) != NULL) continue;
        const orr_yaml_node *there = orr_map_member(scope->map, k->name);
        if (there != NULL && (k->kind != ORR_KEY_MAP || orr_node_given(there))) continue;
        char path[PATH_MAX_CHARS];
        path_of(scope, k->name, path);
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, scope->map->line, scope->map->column,
                           "'%s' is missing here", path);
    }
    return ORR_OK;
}

static orr_status read_member(const reader *r, const orr_map_scope *scope, const orr_key *k,
                              const orr_yaml_node *m, char *base)
{
    char path[PATH_MAX_CHARS];
    path_of(scope, k->name, path);
    if (k->kind == ORR_KEY_MAP && !k->list && !orr_node_given(m) && m->kind == ORR_YAML_TEXT)
        return ORR_OK; // "serve:" with nothing behind it
    if (k->given != 0) *(bool *)(void *)(base + k->given) = true;
    if (k->kind != ORR_KEY_MAP || k->list) free_member(k, base + k->offset); // the default
    return k->list ? read_list(r, k, m, scope, path, (any_list *)(void *)(base + k->offset))
                   : read_value(r, k, m, scope, path, base + k->offset);
}

// The words that conditions ask for are read first, so that a misspelt one is blamed before what depends on
// it.
static orr_status read_members(const reader *r, const orr_map_scope *scope, bool words, char *base)
{
    orr_status s = ORR_OK;
    for (const orr_yaml_node *m = scope->map->first; s == ORR_OK && m != NULL; m = m->next) {
        const orr_key *k = orr_schema_find(scope->schema, m->key, strlen(m->key));
        if (k == NULL) return unknown_key(r, scope, m);
        bool word = (k->kind == ORR_KEY_CHOICE || k->kind == ORR_KEY_BOOL) && k->only == NULL;
        if (word == words) s = read_member(r, scope, k, m, base);
    }
    return s;
}

static orr_status check_effects(const reader *r, const orr_map_scope *scope)
{
    for (const orr_yaml_node *m = scope->map->first; m != NULL; m = m->next) {
        const orr_key *k = orr_schema_find(scope->schema, m->key, strlen(m->key));
        const orr_condition *broken = orr_condition_broken(scope, k);
        if (broken == NULL) continue;
        char sentence[400];
        orr_condition_sentence(scope, broken, sentence, sizeof sentence);
        return refuse_key(r, scope, m, sentence);
    }
    return ORR_OK;
}

static orr_status read_map(const reader *r, const orr_schema *schema, const orr_yaml_node *map,
                           const orr_map_scope *up, const char *path, char *base)
{
    const orr_map_scope scope = {schema, map, up, path};
    orr_status s = read_members(r, &scope, true, base);
    if (s == ORR_OK) s = check_required(r, &scope, false);
    if (s == ORR_OK) s = check_effects(r, &scope);
    if (s == ORR_OK) s = read_members(r, &scope, false, base);
    if (s == ORR_OK) s = check_required(r, &scope, true);
    if (s != ORR_OK || schema->check == NULL) return s;
    char why[ORR_SCHEMA_WHY] = "";
    const char *key = schema->check(base, why);
    if (key == NULL) return ORR_OK;
    const orr_yaml_node *blamed = orr_map_member(map, key);
    if (blamed != NULL) return refuse_key(r, &scope, blamed, why);
    return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, map->line, map->column, "%s%s%s", path,
                       path[0] != '\0' ? ": " : "", why);
}

orr_status orr_schema_read(const orr_schema *schema, const orr_yaml *y, const char *folder,
                           const orr_leap_table *leap, void *base, orr_diag *diag)
{
    memset(base, 0, schema->size);
    reader r = {y->name, folder, leap, diag};
    orr_yaml_node empty = {.kind = ORR_YAML_MAP, .line = 1, .column = 1};
    const orr_yaml_node *root = y->root != NULL ? y->root : &empty;
    orr_status s = set_defaults(schema, &r, base);
    if (s == ORR_OK && root->kind == ORR_YAML_MAP)
        s = read_map(&r, schema, root, NULL, "", base);
    else if (s == ORR_OK)
        s = orr_diag_at(diag, ORR_E_KIND, y->name, root->line, root->column,
                        "a map of keys and values is wanted, this is a %s", orr_yaml_kind_name(root->kind));
    if (s != ORR_OK) orr_schema_free(schema, base);
    return s;
}

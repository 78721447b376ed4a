// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/schema.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/suggest.h"

enum { PATH_MAX_CHARS = 200 };

typedef struct reader {
    const char *name;   // of the file
    const char *folder; // that FILE values are relative to
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
    case ORR_KEY_RECORDS:
        return k->record->size;
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
        return "one of";
    case ORR_KEY_TIME:
        return k->list ? "list of times" : "time";
    case ORR_KEY_DURATION:
        return "length of time";
    case ORR_KEY_INTERVAL:
        return k->list ? "list of FROM/TO" : "FROM/TO";
    case ORR_KEY_SATS:
        return "satellites";
    case ORR_KEY_RECORDS:
        return "list of maps";
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
        snprintf(sentence, sizeof sentence, "%.60s is outside %g to %g%s%s", node->text, k->min, k->max,
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
    size_t len = strlen(node->text);
    int index = 0;
    for (const char *p = k->choices; *p != '\0'; index++) {
        size_t n = strcspn(p, "|");
        if (n == len && strncmp(p, node->text, n) == 0) return *to = index, ORR_OK;
        p += n + (p[n] == '|');
    }
    char sentence[200];
    snprintf(sentence, sizeof sentence, "'%.60s' is none of %s", node->text, k->choices);
    return refuse(r, node, path, sentence);
}

static orr_status read_interval(const char *text, orr_interval *to, orr_diag *d)
{
    const char *slash = strchr(text, '/');
    char from[64];
    if (slash == NULL || (size_t)(slash - text) >= sizeof from)
        return orr_diag_set(d, ORR_E_ARG, "'%.80s' is no interval FROM/TO", text);
    memcpy(from, text, (size_t)(slash - text));
    from[slash - text] = '\0';
    orr_status s = orr_time_parse(from, NULL, &to->from, d);
    if (s == ORR_OK) s = orr_time_parse(slash + 1, NULL, &to->to, d);
    if (s == ORR_OK && to->to < to->from)
        s = orr_diag_set(d, ORR_E_ARG, "'%.80s' ends before it begins", text);
    return s;
}

static orr_status read_record(const reader *r, const orr_schema *schema, const orr_yaml_node *map,
                              const char *prefix, void *base);

// One value into *to.
static orr_status read_value(const reader *r, const orr_key *k, const orr_yaml_node *node, const char *path,
                             void *to)
{
    if (k->kind == ORR_KEY_RECORDS) {
        if (node->kind != ORR_YAML_MAP) return refuse(r, node, path, "a map is wanted here");
        return read_record(r, k->record, node, path, to);
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
        s = orr_time_parse(node->text, NULL, to, &inner);
        break;
    case ORR_KEY_DURATION:
        s = orr_duration_parse(node->text, to, &inner);
        break;
    case ORR_KEY_INTERVAL:
        s = read_interval(node->text, to, &inner);
        break;
    case ORR_KEY_SATS:
        s = orr_sat_set_parse(node->text, to, &inner);
        break;
    case ORR_KEY_RECORDS:
        break;
    }
    return s == ORR_OK ? ORR_OK : refuse(r, node, path, inner.text);
}

static orr_status read_list(const reader *r, const orr_key *k, const orr_yaml_node *node, const char *path,
                            any_list *to)
{
    size_t n = node->kind == ORR_YAML_LIST ? node->n : 1, size = kind_size(k);
    if (n > ORR_SCHEMA_MAX_LIST) return refuse(r, node, path, "the list is too long");
    if (n == 0) return ORR_OK;
    to->item = calloc(n, size);
    if (to->item == NULL) return out_of_memory(r);
    const orr_yaml_node *member = node->kind == ORR_YAML_LIST ? node->first : node;
    for (; to->n < n; member = node->kind == ORR_YAML_LIST ? member->next : NULL) {
        char at[PATH_MAX_CHARS + 24];
        snprintf(at, sizeof at, "%s[%zu]", path, to->n);
        char *item = (char *)to->item + to->n * size;
        to->n++; // counted first: a half-read record is freed with the list
        orr_status s = read_value(r, k, member, n == 1 && node->kind != ORR_YAML_LIST ? path : at, item);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

static orr_status set_default(const orr_key *k, const reader *r, void *member)
{
    if (k->fallback == NULL) return ORR_OK;
    orr_yaml_node text = {.kind = ORR_YAML_TEXT, .text = (char *)(uintptr_t)k->fallback};
    reader plain = {"(default)", NULL, r->diag};
    return k->list ? read_list(&plain, k, &text, k->path, member)
                   : read_value(&plain, k, &text, k->path, member);
}

static void free_value(const orr_key *k, void *value)
{
    if (k->kind == ORR_KEY_TEXT || k->kind == ORR_KEY_FILE) {
        free(*(char **)value);
        *(char **)value = NULL;
    } else if (k->kind == ORR_KEY_RECORDS) {
        orr_schema_free(k->record, value);
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

// The key of the table that stands at `section` (with its final dot) and `word`; *inside: there are keys
// below it.
static const orr_key *find_key(const orr_schema *schema, const char *section, const char *word, bool *inside)
{
    size_t n = strlen(section), m = strlen(word);
    *inside = false;
    for (size_t i = 0; i < schema->n; i++) {
        const char *path = schema->key[i].path;
        if (strncmp(path, section, n) != 0 || strncmp(path + n, word, m) != 0) continue;
        if (path[n + m] == '\0') return &schema->key[i];
        if (path[n + m] == '.') *inside = true;
    }
    return NULL;
}

static orr_status unknown_key(const reader *r, const orr_schema *schema, const char *section,
                              const char *prefix, const orr_yaml_node *node)
{
    enum { MOST = 64, WORD = 48 };
    char word[MOST][WORD];
    const char *candidate[MOST];
    size_t n = 0, len = strlen(section);
    for (size_t i = 0; i < schema->n && n < MOST; i++) {
        const char *path = schema->key[i].path;
        if (strncmp(path, section, len) != 0) continue;
        size_t m = strcspn(path + len, ".");
        if (m >= WORD) continue;
        memcpy(word[n], path + len, m);
        word[n][m] = '\0';
        candidate[n] = word[n];
        n++;
    }
    const char *near = orr_suggest_nearest(node->key, candidate, n);
    char key[PATH_MAX_CHARS];
    snprintf(key, sizeof key, "%s%.60s", prefix, node->key);
    if (near != NULL)
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, node->key_line, node->key_column,
                           "unknown key '%s'; did you mean '%s%s'?", key, prefix, near);
    return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, node->key_line, node->key_column,
                       "unknown key '%s' (orrery serve --help-scenario lists all)", key);
}

static bool among(const orr_yaml_node *map, const char *key)
{
    for (const orr_yaml_node *m = map->first; m != NULL; m = m->next)
        if (strcmp(m->key, key) == 0) return true;
    return false;
}

// Keys right below `section` that must be there.
static orr_status check_required(const reader *r, const orr_schema *schema, const orr_yaml_node *map,
                                 const char *section)
{
    size_t n = strlen(section);
    for (size_t i = 0; i < schema->n; i++) {
        const orr_key *k = &schema->key[i];
        if (!k->required || strncmp(k->path, section, n) != 0 || strchr(k->path + n, '.') != NULL) continue;
        if (among(map, k->path + n)) continue;
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->name, map->line, map->column, "'%s' is missing here",
                           k->path);
    }
    return ORR_OK;
}

// `section` is the path within the table, `shown` the path within the file.
static orr_status read_map(const reader *r, const orr_schema *schema, const orr_yaml_node *map,
                           const char *section, const char *shown, char *base)
{
    for (const orr_yaml_node *m = map->first; m != NULL; m = m->next) {
        bool inside;
        const orr_key *k = find_key(schema, section, m->key, &inside);
        char path[PATH_MAX_CHARS], below[PATH_MAX_CHARS];
        if (k == NULL && !inside) return unknown_key(r, schema, section, shown, m);
        snprintf(path, sizeof path, "%s%s", shown, m->key);
        orr_status s;
        if (k != NULL) {
            free_member(k, base + k->offset); // the default
            if (k->list)
                s = read_list(r, k, m, path, (any_list *)(void *)(base + k->offset));
            else
                s = read_value(r, k, m, path, base + k->offset);
        } else if (m->kind == ORR_YAML_MAP) {
            char in_table[PATH_MAX_CHARS];
            snprintf(in_table, sizeof in_table, "%s%s.", section, m->key);
            snprintf(below, sizeof below, "%.*s.", (int)sizeof below - 2, path);
            s = read_map(r, schema, m, in_table, below, base);
        } else if (m->kind == ORR_YAML_TEXT && m->text[0] == '\0' && !m->quoted) {
            s = ORR_OK; // a section with nothing in it
        } else {
            s = refuse(r, m, path, "a map with keys is wanted here");
        }
        if (s != ORR_OK) return s;
    }
    return check_required(r, schema, map, section);
}

static orr_status read_record(const reader *r, const orr_schema *schema, const orr_yaml_node *map,
                              const char *prefix, void *base)
{
    for (size_t i = 0; i < schema->n; i++) {
        orr_status s = set_default(&schema->key[i], r, (char *)base + schema->key[i].offset);
        if (s != ORR_OK) return s;
    }
    char shown[PATH_MAX_CHARS] = "";
    if (prefix[0] != '\0') snprintf(shown, sizeof shown, "%.*s.", (int)sizeof shown - 2, prefix);
    return read_map(r, schema, map, "", shown, base);
}

orr_status orr_schema_read(const orr_schema *schema, const orr_yaml *y, const char *folder, void *base,
                           orr_diag *diag)
{
    memset(base, 0, schema->size);
    reader r = {y->name, folder, diag};
    orr_yaml_node empty = {.kind = ORR_YAML_MAP, .line = 1, .column = 1};
    const orr_yaml_node *root = y->root != NULL ? y->root : &empty;
    orr_status s;
    if (root->kind == ORR_YAML_MAP)
        s = read_record(&r, schema, root, "", base);
    else
        s = orr_diag_at(diag, ORR_E_KIND, y->name, root->line, root->column,
                        "a scenario is a map of keys and values, this is a %s",
                        orr_yaml_kind_name(root->kind));
    if (s != ORR_OK) orr_schema_free(schema, base);
    return s;
}

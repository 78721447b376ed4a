// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/yaml.h"

#include <errno.h>
#include <libfyaml.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *orr_yaml_kind_name(orr_yaml_kind k)
{
    return k == ORR_YAML_MAP ? "map" : k == ORR_YAML_LIST ? "list" : "text";
}

// What building needs while events come in.
typedef struct builder {
    orr_yaml *y;
    orr_yaml_node *open; // map or list that the next node goes into; NULL at the top
    int depth;
    char *key; // read, its value not yet
    int64_t key_line;
    int key_column;
    bool done; // the document has ended
    orr_diag *diag;
} builder;

static orr_status refuse(const builder *b, orr_status s, const struct fy_mark *mark, const char *what)
{
    return orr_diag_at(b->diag, s, b->y->name, mark != NULL ? mark->line + 1 : 0,
                       mark != NULL ? mark->column + 1 : 0, "%s", what);
}

static char *copy_text(struct fy_token *token, bool *has_nul)
{
    size_t n = 0;
    const char *text = token != NULL ? fy_token_get_text(token, &n) : "";
    if (text == NULL) n = 0;
    char *copy = malloc(n + 1);
    if (copy == NULL) return NULL;
    if (n > 0) memcpy(copy, text, n);
    copy[n] = '\0';
    *has_nul = memchr(copy, '\0', n) != NULL;
    return copy;
}

static orr_status add_node(builder *b, orr_yaml_kind kind, const struct fy_mark *mark, orr_yaml_node **out)
{
    if (b->y->n_nodes >= ORR_YAML_MAX_NODES)
        return refuse(b, ORR_E_LIMIT, mark, "too many values for one file");
    orr_yaml_node *node = calloc(1, sizeof *node);
    if (node == NULL) return refuse(b, ORR_E_MEMORY, mark, "out of memory");
    node->made_before = b->y->made;
    b->y->made = node;
    b->y->n_nodes++;
    node->kind = kind;
    node->line = mark != NULL ? mark->line + 1 : b->key_line; // "key:" with nothing behind it has no mark
    node->column = mark != NULL ? mark->column + 1 : b->key_column;
    node->key = b->key;
    node->key_line = b->key_line;
    node->key_column = b->key_column;
    b->key = NULL;
    node->parent = b->open;
    if (b->open == NULL) {
        b->y->root = node;
    } else {
        if (b->open->last != NULL)
            b->open->last->next = node;
        else
            b->open->first = node;
        b->open->last = node;
        b->open->n++;
    }
    *out = node;
    return ORR_OK;
}

static bool wants_key(const builder *b)
{
    return b->open != NULL && b->open->kind == ORR_YAML_MAP && b->key == NULL;
}

static orr_status take_key(builder *b, struct fy_event *e, const struct fy_mark *mark)
{
    bool has_nul;
    char *key = copy_text(e->scalar.value, &has_nul);
    if (key == NULL) return refuse(b, ORR_E_MEMORY, mark, "out of memory");
    b->key = key; // freed with the builder if we fail
    b->key_line = mark != NULL ? mark->line + 1 : 0;
    b->key_column = mark != NULL ? mark->column + 1 : 0;
    if (has_nul) return refuse(b, ORR_E_FORMAT, mark, "a key with a NUL character");
    if (b->open->n >= ORR_YAML_MAX_KEYS) return refuse(b, ORR_E_LIMIT, mark, "too many keys in one map");
    for (const orr_yaml_node *m = b->open->first; m != NULL; m = m->next)
        if (strcmp(m->key, key) == 0)
            return orr_diag_at(b->diag, ORR_E_FORMAT, b->y->name, b->key_line, b->key_column,
                               "key '%.60s' stands here a second time; the first is in line %lld", key,
                               (long long)m->key_line);
    return ORR_OK;
}

static orr_status take_scalar(builder *b, struct fy_event *e, const struct fy_mark *mark)
{
    if (e->scalar.tag != NULL) return refuse(b, ORR_E_FORMAT, mark, "tags (!...) are not understood");
    if (wants_key(b)) return take_key(b, e, mark);
    orr_yaml_node *node = NULL;
    orr_status s = add_node(b, ORR_YAML_TEXT, mark, &node);
    if (s != ORR_OK) return s;
    bool has_nul;
    node->text = copy_text(e->scalar.value, &has_nul);
    if (node->text == NULL) return refuse(b, ORR_E_MEMORY, mark, "out of memory");
    if (has_nul) return refuse(b, ORR_E_FORMAT, mark, "a text with a NUL character");
    enum fy_scalar_style style =
        e->scalar.value != NULL ? fy_token_scalar_style(e->scalar.value) : FYSS_PLAIN;
    node->quoted = style != FYSS_PLAIN;
    // The mark stands behind the quote; a person looks for the quote.
    if ((style == FYSS_SINGLE_QUOTED || style == FYSS_DOUBLE_QUOTED) && node->column > 1) node->column--;
    return ORR_OK;
}

static orr_status open_node(builder *b, orr_yaml_kind kind, bool tagged, const struct fy_mark *mark)
{
    if (tagged) return refuse(b, ORR_E_FORMAT, mark, "tags (!...) are not understood");
    if (wants_key(b)) return refuse(b, ORR_E_FORMAT, mark, "a key must be a plain word");
    if (++b->depth > ORR_YAML_MAX_DEPTH) return refuse(b, ORR_E_LIMIT, mark, "nested too deeply");
    orr_yaml_node *node = NULL;
    orr_status s = add_node(b, kind, mark, &node);
    if (s == ORR_OK) b->open = node;
    return s;
}

static orr_status take_event(builder *b, struct fy_event *e)
{
    const struct fy_mark *mark = fy_event_start_mark(e);
    switch (e->type) {
    case FYET_DOCUMENT_START:
        if (b->done) return refuse(b, ORR_E_FORMAT, mark, "a second document ('---'); the file is one");
        return ORR_OK;
    case FYET_DOCUMENT_END:
        b->done = true;
        return ORR_OK;
    case FYET_MAPPING_START:
        return open_node(b, ORR_YAML_MAP, e->mapping_start.tag != NULL, mark);
    case FYET_SEQUENCE_START:
        return open_node(b, ORR_YAML_LIST, e->sequence_start.tag != NULL, mark);
    case FYET_MAPPING_END:
    case FYET_SEQUENCE_END:
        b->depth--;
        b->open = b->open != NULL ? b->open->parent : NULL;
        return ORR_OK;
    case FYET_SCALAR:
        return take_scalar(b, e, mark);
    case FYET_ALIAS:
        return refuse(b, ORR_E_FORMAT, mark, "aliases (*name) are not understood: write the value out");
    default:
        return ORR_OK;
    }
}

// The first complaint of libfyaml as ours.
static orr_status complain(builder *b, struct fy_diag *fyd)
{
    void *prev = NULL;
    struct fy_diag_error *e = fyd != NULL ? fy_diag_errors_iterate(fyd, &prev) : NULL;
    if (e == NULL || e->msg == NULL) return orr_diag_at(b->diag, ORR_E_FORMAT, b->y->name, 0, 0, "not YAML");
    size_t n = strcspn(e->msg, "\n");
    return orr_diag_at(b->diag, ORR_E_FORMAT, b->y->name, e->line > 0 ? e->line : 0,
                       e->column > 0 ? e->column : 0, "not YAML: %.*s", n > 200 ? 200 : (int)n, e->msg);
}

static orr_status parse_events(builder *b, const char *text, size_t n, struct fy_diag *fyd)
{
    struct fy_parse_cfg cfg = {.flags = FYPCF_QUIET | FYPCF_COLLECT_DIAG | FYPCF_DISABLE_MMAP_OPT,
                               .diag = fyd};
    struct fy_parser *parser = fy_parser_create(&cfg);
    if (parser == NULL) return orr_diag_set(b->diag, ORR_E_MEMORY, "out of memory");
    orr_status s = ORR_OK;
    if (fy_parser_set_string(parser, text, n) != 0) s = orr_diag_set(b->diag, ORR_E_MEMORY, "out of memory");
    while (s == ORR_OK) {
        struct fy_event *e = fy_parser_parse(parser);
        if (e == NULL) {
            if (fy_parser_get_stream_error(parser)) s = complain(b, fyd);
            break;
        }
        s = take_event(b, e);
        fy_parser_event_free(parser, e);
    }
    fy_parser_destroy(parser);
    return s;
}

// Bytes of the UTF-8 character at p (RFC 3629: no overlong forms, no surrogates, at most U+10FFFF); 0 if it
// is none.
static size_t utf8_length(const unsigned char *p, size_t n)
{
    if (p[0] < 0x80) return 1;
    size_t len = p[0] >= 0xf0 ? 4 : p[0] >= 0xe0 ? 3 : 2;
    if (p[0] < 0xc2 || p[0] > 0xf4 || len > n) return 0;
    for (size_t i = 1; i < len; i++)
        if ((p[i] & 0xc0) != 0x80) return 0;
    if ((p[0] == 0xe0 && p[1] < 0xa0) || (p[0] == 0xed && p[1] > 0x9f)) return 0;
    if ((p[0] == 0xf0 && p[1] < 0x90) || (p[0] == 0xf4 && p[1] > 0x8f)) return 0;
    return len;
}

// What libfyaml's scanner should not have to be the judge of: binary files, broken UTF-8 (it can wait for
// ever for the end of a line that holds some), directives.
static orr_status check_bytes(const orr_yaml *y, const char *text, size_t n, orr_diag *diag)
{
    if (n > ORR_YAML_MAX_BYTES)
        return orr_diag_at(diag, ORR_E_LIMIT, y->name, 0, 0, "more than %d MiB of YAML",
                           ORR_YAML_MAX_BYTES >> 20);
    int64_t line = 1;
    const unsigned char *p = (const unsigned char *)text;
    for (size_t i = 0, start = 0, len; i < n; i += len) {
        int column = (int)(i - start) + 1;
        len = utf8_length(p + i, n - i);
        if (len == 0)
            return orr_diag_at(diag, ORR_E_FORMAT, y->name, line, column, "byte 0x%02x is no UTF-8 text",
                               p[i]);
        if (p[i] == '%' && i == start)
            return orr_diag_at(diag, ORR_E_FORMAT, y->name, line, column,
                               "directives (%%...) are not understood");
        if (p[i] == '\n') {
            line++;
            start = i + 1;
        } else if ((p[i] < ' ' && p[i] != '\t' && p[i] != '\r') || p[i] == 0x7f) {
            return orr_diag_at(diag, ORR_E_FORMAT, y->name, line, column,
                               "a control character (byte 0x%02x): this is no text", p[i]);
        }
    }
    return ORR_OK;
}

orr_status orr_yaml_parse(const char *name, const char *text, size_t n, orr_yaml *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    snprintf(out->name, sizeof out->name, "%s", name);
    orr_status s = check_bytes(out, text, n, diag);
    if (s != ORR_OK) return s;
    struct fy_diag_cfg cfg;
    fy_diag_cfg_default(&cfg);
    cfg.fp = NULL;
    cfg.level = FYET_ERROR;
    struct fy_diag *fyd = fy_diag_create(&cfg);
    if (fyd == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    fy_diag_set_collect_errors(fyd, true);
    builder b = {.y = out, .diag = diag};
    s = parse_events(&b, text, n, fyd);
    free(b.key);
    fy_diag_destroy(fyd);
    if (s != ORR_OK) orr_yaml_free(out);
    return s;
}

orr_status orr_yaml_read(const char *path, orr_yaml *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    char *text = malloc(ORR_YAML_MAX_BYTES + 1);
    orr_status s = text == NULL ? orr_diag_set(diag, ORR_E_MEMORY, "out of memory") : ORR_OK;
    if (s == ORR_OK) {
        size_t n = fread(text, 1, ORR_YAML_MAX_BYTES + 1, f);
        if (ferror(f))
            s = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read: %s", strerror(errno));
        else
            s = orr_yaml_parse(path, text, n, out, diag);
    }
    free(text);
    fclose(f);
    return s;
}

char *orr_yaml_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return strndup(path, slash == NULL ? 0 : slash == path ? 1 : (size_t)(slash - path));
}

void orr_yaml_free(orr_yaml *y)
{
    while (y->made != NULL) {
        orr_yaml_node *node = y->made;
        y->made = node->made_before;
        free(node->text);
        free(node->key);
        free(node);
    }
    y->root = NULL;
    y->n_nodes = 0;
}

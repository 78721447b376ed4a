// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/marks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"

enum { PATH_CHARS = 200 };

static orr_status add(orr_marks *m, const char *path, const orr_yaml_node *node)
{
    if (!ORR_ARRAY_GROW(m->item, m->n)) return ORR_E_MEMORY;
    orr_mark *mark = &m->item[m->n++];
    *mark = (orr_mark){.path = strdup(path), .line = node->line, .column = node->column};
    if (node->kind == ORR_YAML_TEXT && node->text != NULL) mark->text = strdup(node->text);
    return mark->path != NULL && (node->text == NULL || node->kind != ORR_YAML_TEXT || mark->text != NULL)
               ? ORR_OK
               : ORR_E_MEMORY;
}

// Members of a map by their keys; of lists the maps and the texts (files), by their place. Depth is bounded by the reader.
static orr_status walk(orr_marks *m, const char *path, const orr_yaml_node *node)
{
    orr_status s = ORR_OK;
    size_t k = 0;
    for (const orr_yaml_node *c = node->kind != ORR_YAML_TEXT ? node->first : NULL; c != NULL && s == ORR_OK;
         c = c->next, k++) {
        char at[PATH_CHARS];
        if (node->kind == ORR_YAML_MAP)
            snprintf(at, sizeof at, "%.120s%s%.60s", path, path[0] != '\0' ? "." : "",
                     c->key != NULL ? c->key : "");
        else
            snprintf(at, sizeof at, "%.160s[%zu]", path, k);
        s = add(m, at, c);
        if (s == ORR_OK) s = walk(m, at, c);
    }
    return s;
}

orr_status orr_marks_of(const orr_yaml *y, orr_marks *out, orr_diag *diag)
{
    *out = (orr_marks){.n = 0};
    snprintf(out->file, sizeof out->file, "%s", y->name);
    const orr_status s = y->root != NULL ? walk(out, "", y->root) : ORR_OK;
    if (s == ORR_OK) return s;
    orr_marks_free(out);
    return orr_diag_set(diag, s, "out of memory");
}

void orr_marks_free(orr_marks *m)
{
    for (size_t i = 0; i < m->n; i++) {
        free(m->item[i].path);
        free(m->item[i].text);
    }
    free(m->item);
    *m = (orr_marks){.n = 0};
}

static const orr_mark *find(const orr_marks *m, const char *path)
{
    for (size_t i = 0; i < m->n; i++)
        if (strcmp(m->item[i].path, path) == 0) return &m->item[i];
    return NULL;
}

orr_status orr_marks_blame(const orr_marks *m, orr_status status, const char *path, const char *sentence,
                           orr_diag *diag)
{
    char at[PATH_CHARS];
    snprintf(at, sizeof at, "%s", path);
    const orr_mark *mark = find(m, at);
    while (mark == NULL && at[0] != '\0') {
        char *end = strrchr(at, '.'), *open = strrchr(at, '[');
        if (open != NULL && (end == NULL || open > end)) end = open;
        *(end != NULL ? end : at) = '\0';
        mark = find(m, at);
    }
    if (mark == NULL) return orr_diag_set(diag, status, "%s: %s", path, sentence);
    return orr_diag_at(diag, status, m->file, mark->line, mark->column, "%s: %s", path, sentence);
}

// Whether a value names the file: as it stands, or as the end of the path that it was joined to.
static bool names(const char *text, const char *file)
{
    const size_t n = strlen(text), all = strlen(file);
    if (n == 0 || n > all || strcmp(file + all - n, text) != 0) return false;
    return n == all || file[all - n - 1] == '/';
}

// "key.path" of "key.path: sentence"; false where the sentence does not begin so.
static bool begins_with_key(const char *text, char path[PATH_CHARS])
{
    const size_t n = strcspn(text, ": ");
    if (n == 0 || n >= PATH_CHARS || text[n] != ':' || text[n + 1] != ' ') return false;
    snprintf(path, PATH_CHARS, "%.*s", (int)n, text);
    return true;
}

void orr_marks_locate(const orr_marks *m, orr_diag *diag)
{
    char path[PATH_CHARS];
    if (diag == NULL || diag->line > 0) return;
    if (diag->file[0] == '\0' && begins_with_key(diag->text, path)) {
        const orr_diag was = *diag;
        orr_marks_blame(m, was.status, path, was.text + strlen(path) + 2, diag);
    }
    if (diag->file[0] == '\0' || diag->line > 0) return;
    for (size_t i = 0; i < m->n; i++) {
        const orr_mark *mark = &m->item[i];
        if (mark->text == NULL || !names(mark->text, diag->file)) continue;
        const orr_diag was = *diag;
        orr_diag_at(diag, was.status, m->file, mark->line, mark->column, "%s: %s: %s", mark->path, was.file,
                    was.text);
        return;
    }
}

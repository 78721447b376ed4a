// SPDX-License-Identifier: GPL-3.0-or-later
// A schema as a page for people.
#include <stdio.h>
#include <string.h>

#include "src/config/conditions.h"

enum { WIDTH = 110, STEP = 2 };

// Words of a text in lines of at most WIDTH characters, indented.
static void wrap(const char *text, int indent, FILE *to)
{
    int at = 0;
    for (const char *p = text; *p != '\0';) {
        int n = (int)strcspn(p, " ");
        if (at > 0 && at + 1 + n > WIDTH) {
            fputc('\n', to);
            at = 0;
        }
        at += at == 0 ? fprintf(to, "%*s%.*s", indent, "", n, p) : fprintf(to, " %.*s", n, p);
        p += n + (p[n] == ' ');
    }
    fputc('\n', to);
}

static void describe_head(const orr_key *k, int indent, FILE *to)
{
    fprintf(to, "%*s%s: %s", indent, "", k->name, orr_schema_kind_words(k));
    for (const orr_choice *c = k->choice; c != NULL && c->word != NULL; c++)
        fprintf(to, "%s %s", c == k->choice ? "" : ",", c->word);
    if (k->unit != NULL) fprintf(to, ", in %s", k->unit);
    if (k->min != 0 || k->max != 0) fprintf(to, ", %.16g to %.16g", k->min, k->max);
    if (k->list && k->least == k->most && k->most > 0)
        fprintf(to, ", %zu of them", k->most);
    else if (k->list && k->most > 0)
        fprintf(to, ", %zu to %zu of them", k->least > 0 ? k->least : 1, k->most);
    if (k->fallback != NULL) fprintf(to, ", default %s", k->fallback);
    if (k->required) fputs(", required", to);
    for (const orr_condition *c = k->only; c != NULL && c->key != NULL; c++) {
        char words[400];
        orr_condition_words(c, words, sizeof words);
        fprintf(to, "; %s", words);
    }
    fputc('\n', to);
}

static void describe(const orr_schema *schema, int indent, FILE *to)
{
    for (size_t i = 0; i < schema->n; i++) {
        const orr_key *k = &schema->key[i];
        if (indent == 0 && i > 0) fputc('\n', to);
        describe_head(k, indent, to);
        wrap(k->help, indent + 2 * STEP, to);
        for (const orr_choice *c = k->choice; c != NULL && c->word != NULL; c++) {
            char line[400];
            snprintf(line, sizeof line, "%s: %s", c->word, c->help);
            wrap(line, indent + 3 * STEP, to);
        }
        if (k->map != NULL) describe(k->map, indent + STEP, to);
    }
}

void orr_schema_describe(const orr_schema *schema, FILE *to) { describe(schema, 0, to); }

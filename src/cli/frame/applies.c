// SPDX-License-Identifier: GPL-3.0-or-later
// Where options apply: the conditions of the table (orr_option.applies), checked and put into words.
#include <string.h>

#include "src/cli/frame/frame.h"

enum { NAME = 48 };

// One condition: name, and for "name=a|b" the words, else NULL.
typedef struct condition {
    bool negated;
    char name[NAME];   // "el|az" where there is no value
    const char *words; // behind '='
    size_t n_words;    // their length
} condition;

// Reads the condition at *at and moves it behind; false at the end.
static bool next_condition(const char **at, condition *out)
{
    const char *p = *at;
    if (*p == '\0') return false;
    const size_t len = strcspn(p, ",");
    *at = p + len + (p[len] == ',');
    out->negated = *p == '!';
    const char *end = p + len;
    p += out->negated;
    const char *equals = memchr(p, '=', (size_t)(end - p));
    const size_t n = (size_t)((equals != NULL ? equals : end) - p);
    snprintf(out->name, sizeof out->name, "%.*s", (int)n, p);
    out->words = equals != NULL ? equals + 1 : NULL;
    out->n_words = equals != NULL ? (size_t)(end - equals - 1) : 0;
    return true;
}

// Whether `word` is among those that '|' divides.
static bool among(const char *list, size_t n, const char *word)
{
    const size_t len = strlen(word);
    for (const char *p = list; p < list + n;) {
        const size_t one = strcspn(p, "|,");
        if (one == len && memcmp(p, word, len) == 0) return true;
        p += one + 1;
    }
    return false;
}

static bool any_given(const orr_cli *c, const char *names)
{
    char name[NAME];
    for (const char *p = names; *p != '\0';) {
        const size_t one = strcspn(p, "|");
        snprintf(name, sizeof name, "%.*s", (int)one, p);
        if (orr_cli_given(c, name)) return true;
        p += one + (p[one] == '|');
    }
    return false;
}

static const char *fallback_of(const orr_cli *c, const char *name)
{
    for (size_t i = 0; i < c->command->n_options; i++)
        if (strcmp(c->command->option[i].name, name) == 0) return c->command->option[i].fallback;
    return NULL;
}

// "--el or --az", "--method mean or state".
static void put_words(const char *names, const char *words, size_t n_words, char *out, size_t n)
{
    size_t at = 0;
    if (words != NULL) at = (size_t)snprintf(out, n, "--%s ", names);
    const char *p = words != NULL ? words : names,
               *end = words != NULL ? words + n_words : names + strlen(names);
    while (p < end && at < n) {
        const int one = (int)strcspn(p, "|,");
        at += (size_t)snprintf(out + at, n - at, "%s%.*s%s", words != NULL ? "" : "--", one, p,
                               p + one < end ? " or " : "");
        p += one + 1;
    }
}

void orr_cli_applies_words(const char *applies, char *out, size_t n)
{
    condition k;
    size_t at = 0;
    bool negated = false; // of the condition before
    out[0] = '\0';
    for (const char *p = applies; next_condition(&p, &k) && at < n; negated = k.negated) {
        char words[160];
        put_words(k.name, k.words, k.n_words, words, sizeof words);
        const char *lead = negated && k.negated ? "" : k.negated ? "not with " : "only with ";
        at += (size_t)snprintf(out + at, n - at, "%s%s%s", at > 0 ? ", " : "", lead, words);
    }
}

// Whether condition k of option o holds; `name` and `value`: what is known besides (NULL: nothing).
static bool holds(const orr_cli *c, const condition *k, const char *name, const char *value)
{
    if (k->words == NULL) return any_given(c, k->name) != k->negated;
    const char *is = orr_cli_text(c, k->name, fallback_of(c, k->name));
    if (is == NULL && name != NULL && strcmp(name, k->name) == 0) is = value;
    return is == NULL || among(k->words, k->n_words, is) != k->negated;
}

static int check(const orr_cli *c, const char *name, const char *value)
{
    for (size_t i = 0; i < c->command->n_options; i++) {
        const orr_option *o = &c->command->option[i];
        if (o->applies == NULL || !orr_cli_given(c, o->name)) continue;
        condition k;
        for (const char *p = o->applies; next_condition(&p, &k);) {
            if (holds(c, &k, name, value)) continue;
            char words[160];
            put_words(k.name, k.words, k.n_words, words, sizeof words);
            if (k.negated) return orr_cli_usage(c, "--%s does not apply with %s", o->name, words);
            if (value != NULL)
                return orr_cli_usage(c, "--%s applies only with %s; the input has %s", o->name, words, value);
            return orr_cli_usage(c, "--%s applies only with %s", o->name, words);
        }
    }
    return ORR_EXIT_OK;
}

int orr_cli_applies_check(const orr_cli *c) { return check(c, NULL, NULL); }
int orr_cli_settle(const orr_cli *c, const char *name, const char *value) { return check(c, name, value); }

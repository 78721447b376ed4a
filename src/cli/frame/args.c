// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line against a command's table of options.
#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/suggest.h"
#include "src/cli/frame/frame.h"

typedef struct value {
    const orr_option *option;
    const char *text;
    union {
        int64_t integer; // INT, and nanoseconds of DURATION
        double real;
        orr_time time[2]; // TIME, INTERVAL
        orr_sat_set sats;
        orr_geodetic place;
    } as;
} value;

struct orr_cli_values {
    size_t n;
    value list[]; // as many as there were words, at most
};

const orr_option orr_cli_common_options[ORR_CLI_COMMON_OPTIONS] = {
    {.name = "help", .letter = 'h', .kind = ORR_OPT_FLAG, .help = "Show this help."},
    {.name = "quiet",
     .letter = 'q',
     .kind = ORR_OPT_FLAG,
     .help = "Print nothing but warnings and errors on standard error."},
    {.name = "verbose", .letter = 'v', .kind = ORR_OPT_FLAG, .help = "Print what is being done."},
    {.name = "leap-seconds",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The IERS' leap-seconds.list to convert UTC by, instead of that of ORRERY_LEAP_SECONDS, else of "
             "the system "
             "if it is newer than the built-in one."},
    {.name = "force",
     .kind = ORR_OPT_FLAG,
     .help = "Replace an output file that is read-only, or that Orrery did not write."},
};

size_t orr_cli_n_common(const orr_command *cmd)
{
    bool writes = false;
    for (size_t i = 0; i < cmd->n_options; i++) writes |= cmd->option[i].writes || cmd->option[i].fills;
    return writes ? ORR_CLI_COMMON_OPTIONS : ORR_CLI_COMMON_OPTIONS - 1;
}

// The i-th option of the command: its own first, then the common ones; NULL behind the last.
static const orr_option *option_at(const orr_command *cmd, size_t i)
{
    if (i < cmd->n_options) return &cmd->option[i];
    i -= cmd->n_options;
    return i < orr_cli_n_common(cmd) ? &orr_cli_common_options[i] : NULL;
}

static const orr_option *by_name(const orr_command *cmd, const char *name, size_t len)
{
    const orr_option *o;
    for (size_t i = 0; (o = option_at(cmd, i)) != NULL; i++)
        if (strlen(o->name) == len && memcmp(o->name, name, len) == 0) return o;
    return NULL;
}

static const orr_option *by_letter(const orr_command *cmd, char letter)
{
    const orr_option *o;
    for (size_t i = 0; (o = option_at(cmd, i)) != NULL; i++)
        if (o->letter == letter) return o;
    return NULL;
}

static void unknown_option(const orr_cli *c, const char *name, size_t len)
{
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)(len < 60 ? len : 60), name);
    const char *candidate[64];
    size_t n = 0;
    const orr_option *o;
    while (n < 64 && (o = option_at(c->command, n)) != NULL) candidate[n++] = o->name;
    const char *near = orr_suggest_nearest(word, candidate, n);
    if (near != NULL)
        orr_cli_usage(c, "there is no option --%s; did you mean --%s?", word, near);
    else
        orr_cli_usage(c, "there is no option --%s", word);
}

static bool read_number(const orr_cli *c, const orr_option *o, const char *text, value *v)
{
    char *end = NULL;
    bool whole = o->kind == ORR_OPT_INT;
    errno = 0;
    double x = 0;
    if (whole) {
        v->as.integer = strtoll(text, &end, 10);
        x = (double)v->as.integer;
    } else {
        x = v->as.real = strtod(text, &end);
    }
    if (end == text || *end != '\0' || errno == ERANGE || !isfinite(x)) {
        orr_cli_usage(c, "--%s wants a %s, not '%s'", o->name, whole ? "whole number" : "number", text);
        return false;
    }
    if ((o->min != 0 || o->max != 0) && (x < o->min || x > o->max)) {
        orr_cli_usage(c, "--%s must lie between %.15g and %.15g; %s does not", o->name, o->min, o->max, text);
        return false;
    }
    return true;
}

static bool read_choice(const orr_cli *c, const orr_option *o, const char *text)
{
    size_t len = strlen(text);
    for (const char *p = o->value; p != NULL; p = strchr(p, '|') == NULL ? NULL : strchr(p, '|') + 1)
        if (len > 0 && strcspn(p, "|") == len && memcmp(p, text, len) == 0) return true;
    orr_cli_usage(c, "--%s is one of %s, not '%s'", o->name, o->value, text);
    return false;
}

// A time as the command line has it; a warning where it is UTC for which the leap seconds are not certain.
static orr_status read_time(const orr_cli *c, const char *text, orr_time *t, orr_diag *diag)
{
    const orr_status s = orr_time_parse(text, c->leap, t, diag);
    const size_t n = strlen(text);
    const bool utc = n > 0 && (text[n - 1] == 'Z' || text[n - 1] == 'z' || strstr(text, "UTC") != NULL ||
                               strstr(text, "GLO") != NULL);
    if (s == ORR_OK && utc) {
        orr_warnings w = {0};
        orr_leap_warn(*t, c->leap, NULL, &w);
        orr_cli_warnings(c, &w);
        orr_warnings_free(&w);
    }
    return s;
}

static bool read_interval(const orr_cli *c, const char *text, orr_time t[2], orr_diag *diag)
{
    const char *slash = strchr(text, '/');
    char from[ORR_TIME_TEXT * 2];
    if (slash == NULL || (size_t)(slash - text) >= sizeof from) {
        orr_diag_set(diag, ORR_E_ARG, "'%s' is no interval FROM/TO", text);
        return false;
    }
    memcpy(from, text, (size_t)(slash - text));
    from[slash - text] = '\0';
    if (read_time(c, from, &t[0], diag) != ORR_OK || read_time(c, slash + 1, &t[1], diag) != ORR_OK)
        return false;
    if (t[1] < t[0]) {
        orr_diag_set(diag, ORR_E_ARG, "the interval %s ends before it begins", text);
        return false;
    }
    return true;
}

int orr_cli_numbers(const char *text, double *v, int most)
{
    for (int n = 0; n < most; n++) {
        char *end;
        v[n] = strtod(text, &end);
        if (end == text || !isfinite(v[n])) return 0;
        if (*end == '\0') return n + 1;
        if (*end != ',') return 0;
        text = end + 1;
    }
    return 0;
}

static bool read_place(const char *text, orr_geodetic *out, orr_diag *diag)
{
    static const char ecef[] = "ecef:";
    double v[3] = {0, 0, 0};
    if (strncmp(text, ecef, sizeof ecef - 1) == 0) {
        const bool good = orr_cli_numbers(text + sizeof ecef - 1, v, 3) == 3;
        const orr_vec3 r = {v[0], v[1], v[2]};
        const double radius_m = orr_vec3_norm(r);
        if (!good)
            orr_diag_set(diag, ORR_E_ARG, "'%s' is not ecef:X,Y,Z in metres", text);
        else if (radius_m < 6.3e6 || radius_m > 7e6)
            orr_diag_set(diag, ORR_E_ARG, "'%s' is %.0f km from the Earth's centre, not on the Earth", text,
                         radius_m / 1e3);
        else
            *out = orr_earth_from_ecef(r);
        return good && radius_m >= 6.3e6 && radius_m <= 7e6;
    }
    const int n = orr_cli_numbers(text, v, 3);
    if (n < 2) {
        orr_diag_set(diag, ORR_E_ARG,
                     "'%s' is neither LAT,LON[,H] in degrees and metres nor ecef:X,Y,Z in metres", text);
        return false;
    }
    if (fabs(v[0]) > 90 || fabs(v[1]) > 360 || v[2] < -1000 || v[2] > 400000) {
        orr_diag_set(
            diag, ORR_E_ARG,
            "'%s': a latitude lies between -90 and 90 degrees, a longitude between -360 and 360, a height "
            "between -1000 and 400000 m",
            text);
        return false;
    }
    *out = (orr_geodetic){v[0] * ORR_RAD_PER_DEG, v[1] * ORR_RAD_PER_DEG, v[2]};
    return true;
}

// Reads text as the option's kind; prints the sentence and returns false if it cannot be.
static bool read_value(const orr_cli *c, const orr_option *o, const char *text, value *v)
{
    orr_diag diag = {0};
    bool ok = true;
    switch (o->kind) {
    case ORR_OPT_FLAG:
    case ORR_OPT_TEXT:
        return true;
    case ORR_OPT_INT:
    case ORR_OPT_REAL:
        return read_number(c, o, text, v);
    case ORR_OPT_CHOICE:
        return read_choice(c, o, text);
    case ORR_OPT_TIME:
        ok = read_time(c, text, &v->as.time[0], &diag) == ORR_OK;
        break;
    case ORR_OPT_INTERVAL:
        ok = read_interval(c, text, v->as.time, &diag);
        break;
    case ORR_OPT_PLACE:
        ok = read_place(text, &v->as.place, &diag);
        break;
    case ORR_OPT_SATS:
        ok = orr_sat_set_parse(text, &v->as.sats, &diag) == ORR_OK;
        break;
    case ORR_OPT_DURATION:
        ok = orr_duration_parse(text, &v->as.integer, &diag) == ORR_OK;
        if (ok && v->as.integer <= 0) {
            ok = false;
            orr_diag_set(&diag, ORR_E_ARG, "it must be positive");
        }
        break;
    }
    if (!ok) orr_cli_usage(c, "--%s: %s", o->name, diag.text);
    return ok;
}

static bool take(orr_cli *c, const orr_option *o, const char *text)
{
    struct orr_cli_values *vs = c->values;
    if (!o->repeated && o->kind != ORR_OPT_FLAG && orr_cli_given(c, o->name)) {
        orr_cli_usage(c, "--%s was given twice", o->name);
        return false;
    }
    value *v = &vs->list[vs->n];
    *v = (value){.option = o, .text = text};
    if (!read_value(c, o, text, v)) return false;
    vs->n++;
    return true;
}

// One word that starts with a dash. *i moves on if the value is the next word.
static bool take_option(orr_cli *c, int n_words, char **words, int *i)
{
    const char *word = words[*i], *text = NULL;
    const orr_option *o;
    if (word[1] == '-') {
        size_t len = strcspn(word + 2, "=");
        o = by_name(c->command, word + 2, len);
        if (o == NULL) {
            unknown_option(c, word + 2, len);
            return false;
        }
        if (word[2 + len] == '=') text = word + 2 + len + 1;
        if (text != NULL && o->kind == ORR_OPT_FLAG) {
            orr_cli_usage(c, "--%s takes no value", o->name);
            return false;
        }
    } else {
        o = by_letter(c->command, word[1]);
        if (o == NULL || (o->kind == ORR_OPT_FLAG && word[2] != '\0')) {
            orr_cli_usage(c, "there is no option %s", word);
            return false;
        }
        if (word[2] != '\0') text = word + 2;
    }
    if (o->kind == ORR_OPT_FLAG) return take(c, o, "");
    if (text == NULL) {
        // "--from --to T" is a forgotten value; "--lat -12" is a value.
        if (*i + 1 >= n_words || strncmp(words[*i + 1], "--", 2) == 0) {
            orr_cli_usage(c, "--%s needs a value (%s)", o->name, o->value);
            return false;
        }
        text = words[++*i];
    }
    return take(c, o, text);
}

static bool all_there(const orr_cli *c)
{
    const orr_command *cmd = c->command;
    for (size_t i = 0; i < cmd->n_options; i++) {
        if (cmd->option[i].required && !orr_cli_given(c, cmd->option[i].name)) {
            orr_cli_usage(c, "--%s %s is needed", cmd->option[i].name, cmd->option[i].value);
            return false;
        }
    }
    if (c->n_operands < cmd->min_operands) {
        orr_cli_usage(c, "%s is needed", cmd->operands);
        return false;
    }
    if (cmd->max_operands >= 0 && c->n_operands > cmd->max_operands) {
        orr_cli_usage(c, "'%s' is one word too many", c->operand[cmd->max_operands]);
        return false;
    }
    return true;
}

orr_cli_parse_result orr_cli_args_parse(orr_cli *c, int n_words, char **words)
{
    c->n_operands = 0;
    c->operand = words;
    c->values = calloc(1, sizeof *c->values + (size_t)(n_words + 1) * sizeof(value));
    if (c->values == NULL) {
        orr_cli_failf(c, "out of memory");
        return ORR_CLI_FAILED;
    }
    bool options = true;
    for (int i = 0; i < n_words; i++) {
        char *word = words[i];
        if (options && strcmp(word, "--") == 0) {
            options = false;
        } else if (options && word[0] == '-' && word[1] != '\0') {
            if (!take_option(c, n_words, words, &i)) return ORR_CLI_WRONG;
            if (orr_cli_given(c, "help")) return ORR_CLI_HELP;
        } else {
            words[c->n_operands++] = word;
        }
    }
    return all_there(c) ? ORR_CLI_RUN : ORR_CLI_WRONG;
}

void orr_cli_args_free(orr_cli *c)
{
    free(c->values);
    c->values = NULL;
}

// The i-th value of an option; i = SIZE_MAX is the last one. NULL where there is none.
static const value *find(const orr_cli *c, const char *name, size_t i)
{
    const value *last = NULL;
    size_t seen = 0;
    assert(by_name(c->command, name, strlen(name)) != NULL && "the command has no such option");
    for (size_t k = 0; k < c->values->n; k++) {
        if (strcmp(c->values->list[k].option->name, name) != 0) continue;
        last = &c->values->list[k];
        if (seen++ == i) return last;
    }
    return i == SIZE_MAX ? last : NULL;
}

bool orr_cli_given(const orr_cli *c, const char *name) { return find(c, name, 0) != NULL; }

size_t orr_cli_count(const orr_cli *c, const char *name)
{
    size_t n = 0;
    while (find(c, name, n) != NULL) n++;
    return n;
}

const char *orr_cli_text(const orr_cli *c, const char *name, const char *otherwise)
{
    const value *v = find(c, name, SIZE_MAX);
    return v != NULL ? v->text : otherwise;
}

bool orr_cli_says(const orr_cli *c, const char *name, const char *word)
{
    const char *is = orr_cli_text(c, name, by_name(c->command, name, strlen(name))->fallback);
    return is != NULL && strcmp(is, word) == 0;
}

const char *orr_cli_text_at(const orr_cli *c, const char *name, size_t i)
{
    const value *v = find(c, name, i);
    return v != NULL ? v->text : NULL;
}

const char **orr_cli_texts(const orr_cli *c, const char *name, size_t *n)
{
    *n = orr_cli_count(c, name);
    const char **list = calloc(*n + 1, sizeof *list);
    for (size_t i = 0; list != NULL && i < *n; i++) list[i] = orr_cli_text_at(c, name, i);
    return list;
}

int64_t orr_cli_int(const orr_cli *c, const char *name, int64_t otherwise)
{
    const value *v = find(c, name, SIZE_MAX);
    return v != NULL ? v->as.integer : otherwise;
}

double orr_cli_real(const orr_cli *c, const char *name, double otherwise)
{
    const value *v = find(c, name, SIZE_MAX);
    return v != NULL ? v->as.real : otherwise;
}

double orr_cli_real_at(const orr_cli *c, const char *name, size_t i)
{
    const value *v = find(c, name, i);
    assert(v != NULL && v->option->kind == ORR_OPT_REAL);
    return v->as.real;
}

orr_time orr_cli_time(const orr_cli *c, const char *name, orr_time otherwise)
{
    const value *v = find(c, name, SIZE_MAX);
    return v != NULL ? v->as.time[0] : otherwise;
}

bool orr_cli_place(const orr_cli *c, const char *name, orr_geodetic *out)
{
    const value *v = find(c, name, SIZE_MAX);
    if (v != NULL) *out = v->as.place;
    return v != NULL;
}

bool orr_cli_backward(const orr_cli *c)
{
    return orr_cli_given(c, "from") && orr_cli_given(c, "to") &&
           orr_cli_time(c, "to", 0) < orr_cli_time(c, "from", 0);
}

int64_t orr_cli_duration_ns(const orr_cli *c, const char *name, int64_t otherwise_ns)
{
    return orr_cli_int(c, name, otherwise_ns);
}

void orr_cli_interval_at(const orr_cli *c, const char *name, size_t i, orr_time *from, orr_time *to)
{
    const value *v = find(c, name, i);
    assert(v != NULL && v->option->kind == ORR_OPT_INTERVAL);
    *from = v->as.time[0];
    *to = v->as.time[1];
}

const orr_sat_set *orr_cli_sats(const orr_cli *c, const char *name)
{
    const value *v = find(c, name, SIZE_MAX);
    return v != NULL ? &v->as.sats : NULL;
}

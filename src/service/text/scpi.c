// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/scpi.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { // of the standard event register
    ESR_OPERATION_COMPLETE = 1,
    ESR_QUERY = 4,
    ESR_DEVICE = 8,
    ESR_EXECUTION = 16,
    ESR_COMMAND = 32,
    STB_ERRORS = 4,
    STB_QUESTIONABLE = 8,
    STB_EVENT = 32,
    STB_SERVICE = 64,
    STB_OPERATION = 128,
};

static const struct {
    int number;
    const char *words;
} sentences[] = {
    {0, "No error"},
    {ORR_SCPI_SYNTAX, "Syntax error"},
    {ORR_SCPI_NOT_ALLOWED, "Parameter not allowed"},
    {ORR_SCPI_MISSING, "Missing parameter"},
    {ORR_SCPI_HEADER, "Undefined header"},
    {ORR_SCPI_EXECUTION, "Execution error"},
    {ORR_SCPI_PROTECTED, "Command protected"},
    {ORR_SCPI_CONFLICT, "Settings conflict"},
    {ORR_SCPI_RANGE, "Data out of range"},
    {ORR_SCPI_ILLEGAL, "Illegal parameter value"},
    {ORR_SCPI_OVERFLOW, "Queue overflow"},
    {ORR_SCPI_OVERRUN, "Input buffer overrun"},
};

static const char *words_of(int number)
{
    for (size_t k = 0; k < sizeof sentences / sizeof sentences[0]; k++)
        if (sentences[k].number == number) return sentences[k].words;
    return "Error";
}

void orr_scpi_fail(orr_scpi *s, int number, const char *detail)
{
    if (number <= -400)
        s->esr |= ESR_QUERY;
    else if (number <= -300)
        s->esr |= ESR_DEVICE;
    else if (number <= -200)
        s->esr |= ESR_EXECUTION;
    else
        s->esr |= ESR_COMMAND;
    if (s->n_errors == ORR_SCPI_QUEUE) {
        s->error[ORR_SCPI_QUEUE - 1].number = ORR_SCPI_OVERFLOW;
        s->error[ORR_SCPI_QUEUE - 1].detail[0] = '\0';
        return;
    }
    s->error[s->n_errors].number = number;
    snprintf(s->error[s->n_errors++].detail, ORR_SCPI_SENTENCE, "%s", detail);
}

void orr_scpi_condition(orr_scpi_register *r, uint16_t condition)
{
    r->event |= (uint16_t)(condition & ~r->condition);
    r->condition = condition;
}

// --- Headers ---

// One mnemonic of a pattern against one of a header; both are moved behind it.
static bool match_word(const char **pattern, const char **header)
{
    const char *p = *pattern, *h = *header;
    size_t n_short = 0, n_long = 0, n = 0;
    while (isupper((unsigned char)p[n_short]) || p[n_short] == '*' || isdigit((unsigned char)p[n_short]))
        n_short++;
    n_long = n_short;
    while (islower((unsigned char)p[n_long])) n_long++;
    while (isalnum((unsigned char)h[n]) || h[n] == '*') n++;
    *pattern += n_long;
    *header += n;
    if (p[n_long] == '#') {
        (*pattern)++;
        while (n > 0 && isdigit((unsigned char)h[n - 1])) n--;
    }
    return (n == n_short || n == n_long) && strncasecmp(p, h, n) == 0;
}

static bool match_from(const char *p, const char *h)
{
    for (;;) {
        if (*p == '[') { // optional: with it, or without
            const char *close = strchr(p, ']');
            char with[128];
            if (close == NULL || strlen(p) >= sizeof with) return false;
            snprintf(with, sizeof with, "%.*s%s", (int)(close - p - 1), p + 1, close + 1);
            return match_from(with, h) || match_from(close + 1, h);
        }
        if (*p == ':' && *h == ':') {
            p++;
            h++;
        }
        if (*p == '?' || *p == '\0') return strcmp(p, h) == 0;
        if (!match_word(&p, &h)) return false;
        if (*p == ':' && *h != ':') return false;
    }
}

bool orr_scpi_matches(const char *pattern, const char *header)
{
    if (*header == ':') header++;
    if (*pattern == '[' && pattern[1] != ':') { // "[SOURce#:]BB": the first word is optional
        const char *close = strchr(pattern, ']');
        char with[128];
        if (close == NULL || strlen(pattern) >= sizeof with) return false;
        snprintf(with, sizeof with, "%.*s%s", (int)(close - pattern - 1), pattern + 1, close + 1);
        return match_from(with, header) || match_from(close + 1, header);
    }
    return match_from(pattern, header);
}

// --- Common commands and status ---

static int put_number(FILE *out, unsigned value)
{
    fprintf(out, "%u", value);
    return 0;
}

static int take_number(const char *text, unsigned most, unsigned *out)
{
    char *end;
    const unsigned long v = strtoul(text, &end, 0);
    if (end == text || *end != '\0') return ORR_SCPI_ILLEGAL;
    if (v > most || text[0] == '-') return ORR_SCPI_RANGE;
    *out = (unsigned)v;
    return 0;
}

static unsigned status_byte(const orr_scpi *s)
{
    unsigned b = 0;
    if (s->n_errors > 0) b |= STB_ERRORS;
    if ((s->questionable.event & s->questionable.enable) != 0) b |= STB_QUESTIONABLE;
    if ((s->esr & s->ese) != 0) b |= STB_EVENT;
    if ((s->operation.event & s->operation.enable) != 0) b |= STB_OPERATION;
    if ((b & s->sre) != 0) b |= STB_SERVICE;
    return b;
}

static int cls(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n, (void)out;
    s->n_errors = 0;
    s->esr = 0;
    s->operation.event = s->questionable.event = 0;
    return 0;
}

static int set_byte(uint8_t *to, const char *text)
{
    unsigned v;
    const int wrong = take_number(text, 255, &v);
    if (wrong == 0) *to = (uint8_t)v;
    return wrong;
}

static int set_ese(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return set_byte(&s->ese, p[0]);
}
static int get_ese(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    return put_number(out, s->ese);
}
static int get_esr(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    const unsigned was = s->esr;
    s->esr = 0;
    return put_number(out, was);
}
static int set_sre(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return set_byte(&s->sre, p[0]);
}
static int get_sre(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    return put_number(out, s->sre & ~(unsigned)STB_SERVICE);
}
static int get_stb(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    return put_number(out, status_byte(s));
}
static int idn(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    fputs(s->identity, out);
    return 0;
}
static int set_opc(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n, (void)out;
    s->esr |= ESR_OPERATION_COMPLETE; // commands are done one after the other: all before it are
    return 0;
}
static int get_one(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)s, (void)p, (void)n;
    return put_number(out, 1);
}
static int get_zero(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)s, (void)p, (void)n;
    return put_number(out, 0);
}
static int nothing(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)s, (void)p, (void)n, (void)out;
    return 0;
}

static int next_error(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    if (s->n_errors == 0) {
        fprintf(out, "0,\"%s\"", words_of(0));
        return 0;
    }
    fprintf(out, "%d,\"%s", s->error[0].number, words_of(s->error[0].number));
    if (s->error[0].detail[0] != '\0') fputc(';', out);
    for (const char *c = s->error[0].detail; *c != '\0'; c++) { // a quote within is doubled
        if (*c == '"') fputc('"', out);
        fputc(*c >= ' ' && *c <= '~' ? *c : '?', out);
    }
    fputc('"', out);
    s->n_errors--;
    memmove(&s->error[0], &s->error[1], s->n_errors * sizeof s->error[0]);
    return 0;
}
static int count_errors(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    return put_number(out, (unsigned)s->n_errors);
}
static int version(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)s, (void)p, (void)n;
    fputs("1999.0", out);
    return 0;
}
static int preset(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n, (void)out;
    s->operation.enable = s->questionable.enable = 0;
    return 0;
}

static int get_event(orr_scpi_register *r, FILE *out)
{
    const unsigned was = r->event;
    r->event = 0;
    return put_number(out, was);
}
static int set_enable(orr_scpi_register *r, const char *text)
{
    unsigned v;
    const int wrong = take_number(text, 65535, &v);
    if (wrong == 0) r->enable = (uint16_t)(v & 0x7fff);
    return wrong;
}

#define REGISTER(name)                                                                                       \
    static int name##_event(orr_scpi *s, char *const *p, size_t n, FILE *out)                                \
    {                                                                                                        \
        (void)p, (void)n;                                                                                    \
        return get_event(&s->name, out);                                                                     \
    }                                                                                                        \
    static int name##_condition(orr_scpi *s, char *const *p, size_t n, FILE *out)                            \
    {                                                                                                        \
        (void)p, (void)n;                                                                                    \
        return put_number(out, s->name.condition);                                                           \
    }                                                                                                        \
    static int name##_enable(orr_scpi *s, char *const *p, size_t n, FILE *out)                               \
    {                                                                                                        \
        (void)n, (void)out;                                                                                  \
        return set_enable(&s->name, p[0]);                                                                   \
    }                                                                                                        \
    static int name##_enabled(orr_scpi *s, char *const *p, size_t n, FILE *out)                              \
    {                                                                                                        \
        (void)p, (void)n;                                                                                    \
        return put_number(out, s->name.enable);                                                              \
    }
REGISTER(operation)
REGISTER(questionable)
#undef REGISTER

static const orr_scpi_command common[] = {
    {"*CLS", 0, 0, cls, false},
    {"*ESE", 1, 1, set_ese, false},
    {"*ESE?", 0, 0, get_ese, false},
    {"*ESR?", 0, 0, get_esr, false},
    {"*IDN?", 0, 0, idn, false},
    {"*OPC", 0, 0, set_opc, false},
    {"*OPC?", 0, 0, get_one, false},
    {"*SRE", 1, 1, set_sre, false},
    {"*SRE?", 0, 0, get_sre, false},
    {"*STB?", 0, 0, get_stb, false},
    {"*TST?", 0, 0, get_zero, false},
    {"*WAI", 0, 0, nothing, false},
    {"SYSTem:ERRor[:NEXT]?", 0, 0, next_error, false},
    {"SYSTem:ERRor:COUNt?", 0, 0, count_errors, false},
    {"SYSTem:VERSion?", 0, 0, version, false},
    {"STATus:PRESet", 0, 0, preset, false},
    {"STATus:OPERation[:EVENt]?", 0, 0, operation_event, false},
    {"STATus:OPERation:CONDition?", 0, 0, operation_condition, false},
    {"STATus:OPERation:ENABle", 1, 1, operation_enable, false},
    {"STATus:OPERation:ENABle?", 0, 0, operation_enabled, false},
    {"STATus:QUEStionable[:EVENt]?", 0, 0, questionable_event, false},
    {"STATus:QUEStionable:CONDition?", 0, 0, questionable_condition, false},
    {"STATus:QUEStionable:ENABle", 1, 1, questionable_enable, false},
    {"STATus:QUEStionable:ENABle?", 0, 0, questionable_enabled, false},
};

// --- Lines ---

static const orr_scpi_command *find(const orr_scpi *s, const char *header)
{
    for (size_t k = 0; k < sizeof common / sizeof common[0]; k++)
        if (orr_scpi_matches(common[k].header, header)) return &common[k];
    for (size_t t = 0; t < ORR_SCPI_TABLES; t++)
        for (size_t k = 0; k < s->table[t].n; k++)
            if (orr_scpi_matches(s->table[t].command[k].header, header)) return &s->table[t].command[k];
    return NULL;
}

// As it came, from the root, or behind the path of the command before it in the line.
static const orr_scpi_command *look_up(orr_scpi *s, const char *header)
{
    char whole[192];
    const orr_scpi_command *c = NULL;
    if (strlen(header) > 100) return NULL;
    if (header[0] != ':' && header[0] != '*' && s->path[0] != '\0') {
        snprintf(whole, sizeof whole, "%s:%s", s->path, header);
        c = find(s, whole);
    }
    if (c == NULL) {
        snprintf(whole, sizeof whole, "%s", header);
        c = find(s, whole);
    }
    char *last = strrchr(whole, ':');
    if (c != NULL && header[0] != '*')
        snprintf(s->path, sizeof s->path, "%.*s", last != NULL ? (int)(last - whole) : 0, whole);
    return c;
}

static char *trim(char *text)
{
    while (isspace((unsigned char)*text)) text++;
    size_t n = strlen(text);
    while (n > 0 && isspace((unsigned char)text[n - 1])) text[--n] = '\0';
    return text;
}

// The next piece before `divider` outside of quotes; *rest is moved behind it, NULL behind the last.
static char *cut(char **rest, char divider)
{
    char *begin = *rest, quote = '\0';
    for (char *c = begin; *c != '\0'; c++) {
        if (quote != '\0' ? *c == quote : *c == '"' || *c == '\'')
            quote = quote != '\0' ? '\0' : *c;
        else if (quote == '\0' && *c == divider) {
            *c = '\0';
            *rest = c + 1;
            return begin;
        }
    }
    *rest = NULL;
    return begin;
}

static char *unquote(char *text)
{
    const size_t n = strlen(text);
    if (n >= 2 && (text[0] == '"' || text[0] == '\'') && text[n - 1] == text[0]) {
        text[n - 1] = '\0';
        return text + 1;
    }
    return text;
}

static int run_one(orr_scpi *s, char *text, FILE *out)
{
    char *parameter[ORR_SCPI_PARAMETERS];
    size_t n = 0;
    char *arguments = text;
    while (*arguments != '\0' && !isspace((unsigned char)*arguments)) arguments++;
    if (*arguments != '\0') *arguments++ = '\0';
    arguments = trim(arguments);
    snprintf(s->detail, sizeof s->detail, "%.100s", text);
    const orr_scpi_command *c = look_up(s, text);
    if (c == NULL) return ORR_SCPI_HEADER;
    for (char *rest = *arguments != '\0' ? arguments : NULL; rest != NULL;) {
        char *piece = unquote(trim(cut(&rest, ',')));
        if (n == c->most || n == ORR_SCPI_PARAMETERS) return ORR_SCPI_NOT_ALLOWED;
        parameter[n++] = piece;
    }
    if (n < c->least) return ORR_SCPI_MISSING;
    if (c->controls && s->read_only) return ORR_SCPI_PROTECTED;
    s->detail[0] = '\0';
    return c->run(s, parameter, n, out);
}

void orr_scpi_line(orr_scpi *s, char *line, FILE *out)
{
    bool answered = false;
    s->path[0] = '\0';
    for (char *rest = line; rest != NULL;) {
        char *one = trim(cut(&rest, ';'));
        if (*one == '\0') continue;
        char *answer = NULL;
        size_t size = 0;
        FILE *memory = open_memstream(&answer, &size);
        if (memory == NULL) {
            orr_scpi_fail(s, ORR_SCPI_EXECUTION, "out of memory");
            continue;
        }
        const int wrong = run_one(s, one, memory);
        fclose(memory);
        if (wrong != 0)
            orr_scpi_fail(s, wrong, s->detail);
        else if (size > 0)
            fprintf(out, "%s%s", answered ? ";" : "", answer);
        answered = answered || (wrong == 0 && size > 0);
        free(answer);
    }
    if (answered) fputc('\n', out);
}

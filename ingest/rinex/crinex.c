// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/rinex/crinex.h"

#include <stdlib.h>
#include <string.h>

#include "ingest/rinex/rinex_labels.h"

#define MAX_ORDER 9
#define EPOCH_TEXT (41 + 3 * 999)
#define MAX_EVENT_LINES 9999
// F14.3 holds 13 digits; differences of order 9 of such numbers stay far below this, and sums below int64.
#define MAX_NUMBER INT64_C(100000000000000000)
#define N_KEYS (32 * 100)

// A difference sequence: d[0] is the last value, d[k] its k-th difference. level is how many differences are
// known.
typedef struct arc {
    int8_t order; // -1: none
    int8_t level;
    int64_t d[MAX_ORDER + 1];
} arc;

typedef struct sat_state {
    uint64_t epoch; // when it was seen last
    size_t n_codes;
    arc *arcs;
    char *flags; // 2 n_codes
} sat_state;

struct orr_crinex {
    orr_input *in;
    bool v3;
    const orr_crinex_counts *counts;
    orr_warnings *warnings;
    bool synced; // an initialised epoch came and nothing was lost since
    uint64_t count, skipped;
    char text[EPOCH_TEXT + 1];
    size_t n_text;
    arc clock;
    sat_state *state[N_KEYS];
    orr_crinex_epoch epoch;
    int64_t *value;
    char *flags;
    size_t cells; // allocated
    char *event_text;
    size_t event_bytes;
};

static void warn(orr_crinex *c, const char *what)
{
    orr_warnings_add(c->warnings, orr_input_name(c->in), orr_input_line_number(c->in), 0, "%s", what);
}

bool orr_crinex_is_first_line(orr_view line, double *version)
{
    double v = 0;
    if (!orr_view_equals(orr_rinex_label(line), "CRINEX VERS   / TYPE")) return false;
    if (orr_field_real(line, 1, 20, &v) != ORR_FIELD_OK) v = 0;
    if (version != NULL) *version = v;
    return true;
}

bool orr_crinex_note_types(orr_crinex_counts *counts, orr_view line)
{
    orr_view label = orr_rinex_label(line);
    int n = 0;
    if (orr_view_equals(label, "# / TYPES OF OBSERV")) {
        orr_field f = orr_field_int_in(line, 1, 6, 1, ORR_CRINEX_MAX_CODES, &n);
        if (f == ORR_FIELD_OK) counts->n[' '] = (size_t)n;
        return f != ORR_FIELD_BAD;
    }
    if (orr_view_equals(label, "SYS / # / OBS TYPES")) {
        char system = orr_view_char(line, 1);
        if (system == ' ') return true; // continuation
        orr_field f = orr_field_int_in(line, 4, 3, 1, ORR_CRINEX_MAX_CODES, &n);
        if (f != ORR_FIELD_OK || (unsigned char)system > 127) return false;
        counts->n[(unsigned char)system] = (size_t)n;
    }
    return true;
}

orr_status orr_crinex_open(orr_input *in, double version, const orr_crinex_counts *counts,
                           orr_warnings *warnings, orr_crinex **out, orr_diag *diag)
{
    *out = NULL;
    if (!(version >= 1 && version < 2) && !(version >= 3 && version < 4))
        return orr_diag_at(diag, ORR_E_UNSUPPORTED, orr_input_name(in), 1, 1,
                           "Compact RINEX version %.1f is not read (1.0 and 3.0 are)", version);
    orr_crinex *c = calloc(1, sizeof *c);
    if (c == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    c->in = in;
    c->v3 = version >= 3;
    c->counts = counts;
    c->warnings = warnings;
    c->clock.order = -1;
    *out = c;
    return ORR_OK;
}

void orr_crinex_close(orr_crinex *c)
{
    if (c == NULL) return;
    for (size_t i = 0; i < N_KEYS; i++) {
        if (c->state[i] == NULL) continue;
        free(c->state[i]->arcs);
        free(c->state[i]->flags);
        free(c->state[i]);
    }
    free(c->epoch.sat);
    free(c->epoch.n_codes);
    free(c->epoch.event_line);
    free(c->value);
    free(c->flags);
    free(c->event_text);
    free(c);
}

uint64_t orr_crinex_skipped(const orr_crinex *c) { return c->skipped; }

// "-12345", at most 18 digits, ending at a blank or the end; NULL if it is none.
static const char *parse_integer(const char *p, const char *end, int64_t *out)
{
    bool minus = p < end && *p == '-';
    if (minus) p++;
    const char *first = p;
    int64_t v = 0;
    for (; p < end; p++) {
        unsigned d = (unsigned)(unsigned char)*p - '0';
        if (d > 9) break;
        if (p - first == 18) return NULL;
        v = v * 10 + (int64_t)d;
    }
    if (p == first || v > MAX_NUMBER) return NULL;
    *out = minus ? -v : v;
    return p;
}

// One number of a sequence: "3&value" starts one, a plain number is its next difference. NULL if the text is
// bad.
static const char *decode_number(arc *a, const char *p, const char *end)
{
    if (end - p >= 2 && p[1] == '&') {
        if (p[0] < '0' || p[0] > '0' + MAX_ORDER) return NULL;
        int64_t v = 0;
        const char *q = parse_integer(p + 2, end, &v);
        if (q == NULL) return NULL;
        a->order = (int8_t)(p[0] - '0');
        a->level = 0;
        a->d[0] = v;
        return q;
    }
    int64_t v = 0;
    const char *q = parse_integer(p, end, &v);
    if (q == NULL || a->order < 0) return NULL;
    if (a->level < a->order) a->level++;
    a->d[a->level] = v;
    for (int k = a->level; k > 0; k--) {
        a->d[k - 1] += a->d[k];
        if (a->d[k - 1] > MAX_NUMBER || a->d[k - 1] < -MAX_NUMBER) return NULL;
    }
    return q;
}

// Character difference: blank keeps, '&' blanks, anything else replaces.
static void apply_text(char *text, const char *diff, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (diff[i] == ' ') continue;
        text[i] = diff[i] == '&' ? ' ' : diff[i];
    }
}

static bool is_init(const orr_crinex *c, orr_view line)
{
    return line.n > 0 && line.p[0] == (c->v3 ? '>' : '&');
}

// The epoch line into c->text; false if it cannot be one.
static bool take_epoch_text(orr_crinex *c, orr_view line)
{
    if (line.n > EPOCH_TEXT) return false;
    if (is_init(c, line)) {
        memcpy(c->text, line.p, line.n);
        if (!c->v3) c->text[0] = ' ';
        c->n_text = line.n;
        for (size_t i = 0; i < N_KEYS; i++) // nothing of before counts any more
            if (c->state[i] != NULL) c->state[i]->epoch = 0;
        c->clock.order = -1;
        c->synced = true;
        return true;
    }
    if (c->n_text < line.n) {
        memset(c->text + c->n_text, ' ', line.n - c->n_text);
        c->n_text = line.n;
    }
    apply_text(c->text, line.p, line.n);
    return true;
}

static orr_status read_event(orr_crinex *c, size_t n_lines, orr_diag *diag)
{
    orr_crinex_epoch *e = &c->epoch;
    e->is_event = true;
    e->n_sats = 0;
    e->n_event_lines = 0;
    if (e->event_line == NULL) {
        e->event_line = calloc(MAX_EVENT_LINES, sizeof *e->event_line);
        if (e->event_line == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    size_t used = 0;
    for (size_t i = 0; i < n_lines; i++) {
        orr_view line;
        if (!orr_input_line(c->in, &line)) {
            if (orr_input_status(c->in, NULL) == ORR_OK) warn(c, "the file ends within an event record");
            break;
        }
        if (used + line.n > c->event_bytes) {
            size_t want = (used + line.n) * 2;
            char *grown = realloc(c->event_text, want);
            if (grown == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
            c->event_text = grown;
            c->event_bytes = want;
        }
        if (line.n > 0) memcpy(c->event_text + used, line.p, line.n);
        e->event_line[i] = (orr_view){NULL, line.n};
        used += line.n;
        e->n_event_lines++;
    }
    const char *p = c->event_text != NULL ? c->event_text : "";
    for (size_t i = 0; i < e->n_event_lines; i++) {
        e->event_line[i].p = p;
        p += e->event_line[i].n;
    }
    return orr_input_status(c->in, diag);
}

static int key_of(const char s[3])
{
    int ten = s[1] == ' ' ? 0 : s[1] - '0', one = s[2] - '0';
    if (ten < 0 || ten > 9 || one < 0 || one > 9) return -1;
    if (s[0] != ' ' && (s[0] < 'A' || s[0] > 'Z')) return -1;
    return (s[0] & 31) * 100 + ten * 10 + one;
}

// The satellite's sequences: those of the epoch before, or fresh ones. NULL without memory.
static sat_state *state_of(orr_crinex *c, int key, size_t n_codes)
{
    sat_state *s = c->state[key];
    if (s == NULL) {
        s = calloc(1, sizeof *s);
        if (s == NULL) return NULL;
        c->state[key] = s;
    }
    if (s->n_codes != n_codes) {
        arc *a = realloc(s->arcs, n_codes * sizeof *a);
        if (a != NULL) s->arcs = a;
        char *f = realloc(s->flags, 2 * n_codes);
        if (f != NULL) s->flags = f;
        if (a == NULL || f == NULL) return NULL;
        s->n_codes = n_codes;
        s->epoch = 0;
    }
    if (s->epoch == 0 || s->epoch + 1 != c->count) {
        for (size_t j = 0; j < n_codes; j++) s->arcs[j].order = -1;
        memset(s->flags, ' ', 2 * n_codes);
    }
    s->epoch = c->count;
    return s;
}

// One satellite's line into the arrays; false where it is damaged. In version 1.0 a missing observation has no flags,
// and flags that come back later are differences to blanks; in 3.0 the flags go on by themselves.
static bool decode_sat_line(sat_state *s, orr_view line, bool v3, int64_t *value, char *flags)
{
    const char *p = line.p, *end = line.p + line.n;
    for (size_t j = 0; j < s->n_codes; j++) {
        arc *a = &s->arcs[j];
        if (p >= end || *p == ' ') {
            a->order = -1;
            value[j] = ORR_CRINEX_MISSING;
            if (p < end) p++;
            continue;
        }
        p = decode_number(a, p, end);
        if (p == NULL || (p < end && *p != ' ')) return false;
        if (p < end) p++;
        value[j] = a->d[0];
    }
    size_t rest = p < end ? (size_t)(end - p) : 0;
    while (rest > 0 && (p[rest - 1] == ' ' || p[rest - 1] == '\t')) rest--;
    if (rest > 2 * s->n_codes) return false;
    apply_text(s->flags, p, rest);
    for (size_t j = 0; !v3 && j < s->n_codes; j++)
        if (value[j] == ORR_CRINEX_MISSING) memset(s->flags + 2 * j, ' ', 2);
    memcpy(flags, s->flags, 2 * s->n_codes);
    return true;
}

static bool grow(orr_crinex *c, size_t n_sats, size_t stride)
{
    orr_crinex_epoch *e = &c->epoch;
    if (e->sat == NULL) {
        e->sat = calloc(ORR_CRINEX_MAX_SATS, sizeof *e->sat);
        e->n_codes = calloc(ORR_CRINEX_MAX_SATS, sizeof *e->n_codes);
        if (e->sat == NULL || e->n_codes == NULL) return false;
    }
    if (n_sats * stride > c->cells) {
        size_t want = n_sats * stride + 4 * stride;
        int64_t *v = realloc(c->value, want * sizeof *v);
        if (v != NULL) c->value = v;
        char *f = realloc(c->flags, 2 * want);
        if (f != NULL) c->flags = f;
        if (v == NULL || f == NULL) return false;
        c->cells = want;
    }
    e->value = c->value;
    e->flags = c->flags;
    e->stride = stride;
    return true;
}

static void decode_clock(orr_crinex *c, orr_view line)
{
    line = orr_view_trim(line);
    c->epoch.has_clock = false;
    if (line.n == 0) {
        c->clock.order = -1;
        return;
    }
    const char *end = line.p + line.n;
    if (decode_number(&c->clock, line.p, end) != end) {
        c->clock.order = -1;
        warn(c, "the receiver clock offset cannot be decoded (no initialisation before it): left out");
        return;
    }
    c->epoch.has_clock = true;
    c->epoch.clock = c->clock.d[0];
}

enum outcome { GOOD, DAMAGED, AT_END, NO_MEMORY };

static enum outcome decode_observations(orr_crinex *c, size_t n_sats)
{
    orr_crinex_epoch *e = &c->epoch;
    size_t list_at = c->v3 ? 41 : 32, stride = 1;
    for (size_t i = 0; i < 128; i++)
        if (c->counts->n[i] > stride) stride = c->counts->n[i];
    if (n_sats > ORR_CRINEX_MAX_SATS)
        return warn(c, "an epoch with more satellites than the limit of 512"), DAMAGED;
    if (!grow(c, n_sats, stride)) return NO_MEMORY;
    e->is_event = false;
    e->n_sats = n_sats;
    e->n_event_lines = 0;
    orr_view line;
    if (!orr_input_line(c->in, &line)) return AT_END;
    decode_clock(c, line);
    for (size_t i = 0; i < n_sats; i++) {
        char id[3] = {' ', ' ', ' '};
        size_t at = list_at + 3 * i;
        for (size_t k = 0; k < 3; k++)
            if (at + k < c->n_text) id[k] = c->text[at + k];
        int key = key_of(id);
        if (key < 0) return warn(c, "the satellite list of an epoch is damaged"), DAMAGED;
        size_t n_codes = c->counts->n[c->v3 ? (unsigned char)id[0] : ' '];
        if (n_codes == 0)
            return warn(c, "a satellite of a system whose observation types the header lacks"), DAMAGED;
        if (c->state[key] != NULL && c->state[key]->epoch == c->count)
            return warn(c, "a satellite is listed twice in an epoch"), DAMAGED;
        sat_state *s = state_of(c, key, n_codes);
        if (s == NULL) return NO_MEMORY;
        if (!orr_input_line(c->in, &line)) return AT_END;
        if (!decode_sat_line(s, line, c->v3, c->value + i * stride, c->flags + 2 * i * stride))
            return warn(c, "a satellite's line cannot be decoded"), DAMAGED;
        memcpy(e->sat[i], id, 3);
        e->sat[i][3] = '\0';
        e->n_codes[i] = n_codes;
    }
    return GOOD;
}

// How many lines follow an event's epoch line. Cycle slip records (flag 6) count satellites, not lines.
static size_t event_lines(const orr_crinex *c, int flag, size_t n)
{
    if (flag != 6 || c->v3) return n;
    size_t per_sat = (c->counts->n[' '] + 4) / 5, lists = n > 12 ? (n - 1) / 12 : 0;
    return n * per_sat + lists;
}

orr_status orr_crinex_next(orr_crinex *c, const orr_crinex_epoch **epoch, orr_diag *diag)
{
    *epoch = NULL;
    orr_view line;
    while (orr_input_line(c->in, &line)) {
        bool init = is_init(c, line);
        if (!init && !c->synced) continue;              // looking for a place to start again
        if (!init && orr_view_is_blank(line)) continue; // no two epochs are the same: stray lines
        c->count++;
        c->epoch.line = orr_input_line_number(c->in);
        int flag = 0, n = 0;
        bool good = take_epoch_text(c, line);
        orr_view text = {c->text, c->n_text};
        if (good) {
            orr_field f = orr_field_int_in(text, c->v3 ? 32 : 29, 1, 0, 6, &flag);
            good = f == ORR_FIELD_OK || f == ORR_FIELD_BLANK;
            f = orr_field_int_in(text, c->v3 ? 33 : 30, 3, 0, 999, &n);
            good = good && (f == ORR_FIELD_OK || (f == ORR_FIELD_BLANK && flag > 1));
        }
        c->epoch.text = text;
        c->epoch.flag = flag;
        if (!good) {
            warn(c, "an epoch line that cannot be decoded: skipping to the next initialised epoch");
            c->synced = false;
            c->skipped++;
            continue;
        }
        if (flag > 1) {
            orr_status s = read_event(c, event_lines(c, flag, (size_t)n), diag);
            if (s == ORR_OK) *epoch = &c->epoch;
            return s;
        }
        switch (decode_observations(c, (size_t)n)) {
        case GOOD:
            *epoch = &c->epoch;
            return ORR_OK;
        case DAMAGED: // the reason was told
            warn(c, "the epoch is left out: skipping to the next initialised epoch");
            c->synced = false;
            c->skipped++;
            break;
        case AT_END:
            if (orr_input_status(c->in, NULL) == ORR_OK) {
                warn(c, "the file ends within an epoch");
                c->skipped++;
            }
            return orr_input_status(c->in, diag);
        case NO_MEMORY:
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        }
    }
    return orr_input_status(c->in, diag);
}

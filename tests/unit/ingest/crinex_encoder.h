// SPDX-License-Identifier: GPL-3.0-or-later
// A plain Hatanaka encoder, the tests' own: RINEX 2 or 3 observation text in, Compact RINEX 1.0 or 3.0 out.
// It knows nothing of the decoder. Sequences restart as the text demands and, for the tests, every `reinit`
// epochs.
#ifndef ORR_TESTS_CRINEX_ENCODER_H
#define ORR_TESTS_CRINEX_ENCODER_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ENC_CODES 40
#define ENC_SATS 64

typedef struct enc_arc {
    int n; // numbers seen, 0: none
    int64_t d[10];
} enc_arc;

typedef struct enc_sat {
    char id[4];
    enc_arc arc[ENC_CODES];
    char flags[2 * ENC_CODES + 1];
} enc_sat;

typedef struct enc {
    const char *in;
    char *out;
    size_t n, capacity;
    int v3, order, reinit, since;
    int codes_v2, codes[128];
    int n_sats;
    enc_sat sat[ENC_SATS], old[ENC_SATS];
    int n_old;
    char epoch[1024];
    enc_arc clock;
} enc;

static inline void enc_put(enc *e, const char *s, size_t n)
{
    while (e->n + n + 1 > e->capacity) e->out = realloc(e->out, e->capacity = 2 * e->capacity + n + 64);
    memcpy(e->out + e->n, s, n);
    e->n += n;
}

// Puts a line without its trailing blanks.
static inline void enc_line(enc *e, const char *s)
{
    size_t n = strlen(s);
    while (n > 0 && s[n - 1] == ' ') n--;
    enc_put(e, s, n);
    enc_put(e, "\n", 1);
}

static inline int enc_get(enc *e, char *line, size_t size)
{
    if (*e->in == '\0') return 0;
    size_t n = strcspn(e->in, "\n");
    snprintf(line, size, "%.*s", (int)n, e->in);
    e->in += n + (e->in[n] == '\n');
    return 1;
}

static inline void enc_pad(char *line, size_t n)
{
    size_t have = strlen(line);
    if (have < n) memset(line + have, ' ', n - have), line[n] = '\0';
}

// Character difference of b to a, both padded to the same length by the caller's buffers.
static inline void enc_diff(const char *a, const char *b, char *out)
{
    size_t na = strlen(a), nb = strlen(b), n = na > nb ? na : nb;
    for (size_t i = 0; i < n; i++) {
        char x = i < na ? a[i] : ' ', y = i < nb ? b[i] : ' ';
        out[i] = x == y ? ' ' : y == ' ' ? '&' : y;
    }
    out[n] = '\0';
}

static inline void enc_number(enc *e, enc_arc *a, int64_t v)
{
    char text[64];
    if (a->n == 0) {
        snprintf(text, sizeof text, "%d&%lld", e->order, (long long)v);
        a->d[0] = v;
    } else {
        int level = a->n < e->order ? a->n : e->order;
        int64_t old = a->d[0], step = v;
        a->d[0] = v;
        for (int k = 1; k <= level; k++) { // a new k-th difference from the new and old (k-1)-th
            int64_t fresh = step - old;
            old = a->d[k];
            a->d[k] = fresh;
            step = fresh;
        }
        snprintf(text, sizeof text, "%lld", (long long)step);
    }
    a->n++;
    enc_put(e, text, strlen(text));
}

static inline void enc_note_types(enc *e, const char *line)
{
    if (strlen(line) < 61) return;
    if (strncmp(line + 60, "# / TYPES OF OBSERV", 19) == 0 && line[5] != ' ') e->codes_v2 = atoi(line);
    if (strncmp(line + 60, "SYS / # / OBS TYPES", 19) == 0 && line[0] != ' ')
        e->codes[(unsigned char)line[0]] = atoi(line + 1);
}

// A decimal field of fixed point as an integer of its last digit; 0 if blank.
static inline int enc_fixed(const char *field, int width, int64_t *out)
{
    int64_t v = 0;
    int minus = 0, digits = 0;
    for (int i = 0; i < width && field[i] != '\0'; i++) {
        if (field[i] == '-') minus = 1;
        if (field[i] < '0' || field[i] > '9') continue;
        v = v * 10 + (field[i] - '0');
        digits++;
    }
    *out = minus ? -v : v;
    return digits > 0;
}

static inline void enc_satellite(enc *e, enc_sat *s, int n_codes, const char *fields)
{
    char flags[2 * ENC_CODES + 1] = "", diff[2 * ENC_CODES + 1];
    for (int j = 0; j < n_codes; j++) {
        int64_t v = 0;
        if (enc_fixed(fields + 16 * j, 14, &v))
            enc_number(e, &s->arc[j], v);
        else
            s->arc[j].n = 0;
        enc_put(e, " ", 1);
        flags[2 * j] = fields[16 * j + 14];
        flags[2 * j + 1] = fields[16 * j + 15];
    }
    flags[2 * n_codes] = '\0';
    enc_diff(s->flags, flags, diff);
    size_t n = strlen(diff);
    while (n > 0 && diff[n - 1] == ' ') n--;
    enc_put(e, diff, n);
    while (e->n > 0 && e->out[e->n - 1] == ' ') e->n--;
    enc_put(e, "\n", 1);
    memcpy(s->flags, flags, sizeof flags);
}

static inline void enc_epoch(enc *e, const char *first)
{
    char line[2048], text[1024], list[1024] = "", diff[1024], clock[32];
    snprintf(line, sizeof line, "%s", first);
    enc_pad(line, 80);
    int n = atoi((snprintf(diff, 4, "%.3s", line + (e->v3 ? 32 : 29)), diff)),
        flag = line[e->v3 ? 31 : 28] - '0';
    if (flag > 1) {
        char c = line[0];
        line[0] = e->v3 ? '>' : '&';
        enc_line(e, line);
        (void)c;
        for (int i = 0; i < n && enc_get(e, line, sizeof line); i++) {
            enc_line(e, line);
            enc_note_types(e, line);
        }
        e->since = 0;
        return;
    }
    snprintf(clock, sizeof clock, "%.*s", e->v3 ? 15 : 12, line + (e->v3 ? 41 : 68));
    snprintf(text, sizeof text, "%.*s", e->v3 ? 35 : 32, line);
    char(*fields)[16 * ENC_CODES + 1] = calloc((size_t)n + 1, sizeof *fields);
    memcpy(e->old, e->sat, sizeof e->old);
    e->n_old = e->since == 0 ? 0 : e->n_sats;
    e->n_sats = n;
    for (int i = 0; !e->v3 && i < n; i++) {
        if (i > 0 && i % 12 == 0) enc_get(e, line, sizeof line), enc_pad(line, 80);
        snprintf(list + 3 * i, 4, "%.3s", line + 32 + 3 * (i % 12));
    }
    for (int i = 0; i < n; i++) {
        int n_codes = e->codes_v2;
        if (e->v3) {
            enc_get(e, line, sizeof line);
            snprintf(list + 3 * i, 4, "%.3s", line);
            n_codes = e->codes[(unsigned char)line[0]];
            enc_pad(line, (size_t)(3 + 16 * n_codes));
            snprintf(fields[i], sizeof fields[i], "%.*s", 16 * n_codes, line + 3);
        } else {
            for (int j = 0; j < n_codes; j += 5) {
                enc_get(e, line, sizeof line);
                enc_pad(line, 80);
                snprintf(fields[i] + 16 * j, 81, "%.80s", line);
            }
        }
    }
    if (e->v3) enc_pad(text, 41);
    strcat(text, list);
    if (e->since == 0) {
        snprintf(diff, sizeof diff, "%s", text);
        diff[0] = e->v3 ? '>' : '&';
        e->clock.n = 0;
    } else {
        enc_diff(e->epoch, text, diff);
    }
    enc_line(e, diff);
    memcpy(e->epoch, text, sizeof e->epoch);
    int64_t c = 0;
    if (enc_fixed(clock, 15, &c))
        enc_number(e, &e->clock, c);
    else
        e->clock.n = 0;
    enc_put(e, "\n", 1);
    for (int i = 0; i < n; i++) {
        enc_sat *s = &e->sat[i];
        memset(s, 0, sizeof *s);
        memset(s->flags, ' ', sizeof s->flags - 1);
        for (int k = 0; k < e->n_old; k++)
            if (strncmp(e->old[k].id, list + 3 * i, 3) == 0) *s = e->old[k];
        snprintf(s->id, sizeof s->id, "%.3s", list + 3 * i);
        enc_satellite(e, s, e->v3 ? e->codes[(unsigned char)list[3 * i]] : e->codes_v2, fields[i]);
    }
    free(fields);
    e->since++;
    if (e->reinit > 0 && e->since >= e->reinit) e->since = 0;
}

// Compact RINEX of `rinex`, NUL-terminated; free it.
static inline char *crinex_encode(const char *rinex, int v3, int order, int reinit)
{
    enc *e = calloc(1, sizeof *e);
    char line[4096], text[128];
    e->in = rinex;
    e->v3 = v3;
    e->order = order;
    e->reinit = reinit;
    snprintf(text, sizeof text, "%-20s%-40s%s", v3 ? "3.0" : "1.0", "COMPACT RINEX FORMAT",
             "CRINEX VERS   / TYPE");
    enc_line(e, text);
    snprintf(text, sizeof text, "%-60s%s", "the tests' encoder", "CRINEX PROG / DATE");
    enc_line(e, text);
    for (int header = 1; enc_get(e, line, sizeof line);) {
        if (!header) {
            enc_epoch(e, line);
            continue;
        }
        enc_line(e, line);
        enc_note_types(e, line);
        if (strlen(line) > 60 && strncmp(line + 60, "END OF HEADER", 13) == 0) header = 0;
    }
    enc_put(e, "", 0);
    char *out = e->out;
    out[e->n] = '\0';
    free(e);
    return out;
}

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/rinex/clk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/rinex/clk_private.h"

static void free_series(orr_clk_series *s, size_t n)
{
    for (size_t i = 0; s != NULL && i < n; i++) free(s[i].record);
    free(s);
}

void orr_clk_free(orr_clk *x)
{
    if (x == NULL) return;
    free_series(x->sat, x->n_sats);
    free_series(x->receiver, x->n_receivers);
    free(x->epoch);
    *x = (orr_clk){0};
}

// Labels stand in columns 61-80 up to version 3.03 and in 66-85 from 3.04; producers of either mix them up.
static bool label_is(orr_view line, const char *name)
{
    return orr_records_label_is(orr_records_label(line), name) ||
           orr_records_label_is(orr_view_trim(orr_view_cols(line, 66, 20)), name);
}

// Labels whose lines are not needed here.
static bool is_other_label(orr_view line)
{
    static const char *const known[] = {"COMMENT",
                                        "SYS / # / OBS TYPES",
                                        "# / TYPES OF DATA",
                                        "STATION NAME / NUM",
                                        "STATION CLK REF",
                                        "# OF CLK REF",
                                        "# OF SOLN STA / TRF",
                                        "SOLN STA NAME / NUM",
                                        "# OF SOLN SATS",
                                        "PRN LIST",
                                        "SYS / DCBS APPLIED",
                                        "SYS / PCVS APPLIED",
                                        "LEAP SECONDS GNSS",
                                        "RINEX VERSION / TYPE"};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (label_is(line, known[i])) return true;
    return false;
}

static orr_status first_line(clk_reader *r, orr_view line)
{
    orr_clk *x = r->out;
    orr_view rest = line, word;
    if (!label_is(line, "RINEX VERSION / TYPE"))
        return orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 61,
                                "not a RINEX clock file: the first line has no label RINEX VERSION / TYPE");
    if (!orr_view_word(&rest, &word) || orr_view_real(word, &x->version) != ORR_FIELD_OK)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "the RINEX version is no number");
    if (!orr_view_word(&rest, &word) || word.p[0] != 'C' || word.p - line.p >= 40)
        return orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 21,
                                "not a RINEX clock file: the file type is not C");
    if (!(x->version >= 1.99 && x->version < 4.0))
        return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 1,
                                "RINEX clock version %.2f is not known (2.00 to 3.04 are)", x->version);
    static const double known[] = {2.00, 2.01, 3.00, 3.01, 3.02, 3.04};
    size_t i = 0;
    while (i < sizeof known / sizeof known[0] && fabs(known[i] - x->version) > 0.005) i++;
    if (i == sizeof known / sizeof known[0])
        orr_cursor_warn(&r->c, r->warnings, 1,
                        "there is no such version of RINEX clock files; read as the last before it");
    orr_view system = orr_view_trim(orr_view_cols(line, 41, 20));
    x->system = system.n > 0 && orr_records_label_is(orr_records_label(line), "RINEX VERSION / TYPE")
                    ? system.p[0]
                    : ' ';
    if (x->system == ' ' && x->version >= 3.035) { // 3.04 moves it to column 43
        system = orr_view_trim(orr_view_cols(line, 41, 24));
        if (system.n > 0) x->system = system.p[0];
    }
    return ORR_OK;
}

static orr_status header_line(clk_reader *r, orr_view line)
{
    orr_clk *x = r->out;
    orr_view text = orr_view_cols(line, 1, 60);
    int64_t k;
    if (label_is(line, "PGM / RUN BY / DATE")) {
        orr_records_program_line(line, x->program, x->run_by, x->date);
    } else if (label_is(line, "TIME SYSTEM ID")) {
        orr_view word = orr_view_trim(text);
        if (orr_scale_parse(word.p, word.n, &x->scale) != ORR_OK)
            return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 4, "time system \"%.*s\" is not known",
                                    (int)(word.n < 20 ? word.n : 20), word.p);
    } else if (label_is(line, "LEAP SECONDS")) {
        orr_view rest = text, word;
        if (orr_view_word(&rest, &word) && orr_view_int(word, &k) == ORR_FIELD_OK && k >= 0 && k < 1000)
            x->leap_seconds = (int)k;
        else
            orr_cursor_warn(&r->c, r->warnings, 1, "the number of leap seconds is no number");
    } else if (label_is(line, "ANALYSIS CENTER")) {
        orr_view_copy(orr_view_trim(text), x->agency, sizeof x->agency);
    } else if (label_is(line, "ANALYSIS CLK REF")) {
        orr_view rest = text, word;
        if (orr_view_word(&rest, &word)) orr_view_copy(word, x->reference, sizeof x->reference);
    } else if (!orr_view_is_blank(line) && !is_other_label(line)) {
        orr_cursor_warn(&r->c, r->warnings, 61, "the header label is not known: the line is ignored");
    }
    return ORR_OK;
}

static orr_status read_header(clk_reader *r)
{
    orr_view line;
    bool first = true;
    while (orr_cursor_next(&r->c, &line)) {
        if (first && orr_view_is_blank(line)) continue;
        orr_status s = first ? first_line(r, line) : ORR_OK;
        if (s == ORR_OK && !first) {
            if (label_is(line, "END OF HEADER")) return ORR_OK;
            s = header_line(r, line);
        }
        if (s != ORR_OK) return s;
        first = false;
    }
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    return orr_cursor_error(&r->c, r->diag, first ? ORR_E_KIND : ORR_E_FORMAT, 0,
                            first ? "the file is empty"
                                  : "the file ends inside the header (no END OF HEADER)");
}

static int by_time(const void *a, const void *b)
{
    const orr_clk_record *x = a, *y = b;
    return (x->t > y->t) - (x->t < y->t);
}

static int by_sat(const void *a, const void *b)
{
    const orr_clk_series *x = a, *y = b;
    return (x->sat > y->sat) - (x->sat < y->sat);
}

// Merge sort that keeps the file's order among equals: of two records at one instant the first stays.
static bool stable_sort(orr_clk_record *rec, size_t n)
{
    orr_clk_record *tmp = malloc(n * sizeof *tmp);
    if (tmp == NULL) return false;
    for (size_t width = 1; width < n; width *= 2) {
        for (size_t lo = 0; lo < n; lo += 2 * width) {
            size_t mid = lo + width < n ? lo + width : n, hi = lo + 2 * width < n ? lo + 2 * width : n;
            for (size_t a = lo, b = mid, k = lo; k < hi; k++)
                tmp[k] = a < mid && (b >= hi || by_time(&rec[a], &rec[b]) <= 0) ? rec[a++] : rec[b++];
        }
        memcpy(rec, tmp, n * sizeof *rec);
    }
    free(tmp);
    return true;
}

static orr_status put_in_order(clk_reader *r, orr_clk_series *s)
{
    bool sorted = true;
    for (size_t i = 1; i < s->n; i++) sorted &= s->record[i].t >= s->record[i - 1].t;
    if (!sorted) {
        orr_warnings_add(r->warnings, r->c.name, 0, 0,
                         "records of %s are not in the order of time; they were sorted", s->name);
        if (!stable_sort(s->record, s->n))
            return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory to sort %zu records", s->n);
    }
    size_t kept = 0, doubles = 0;
    for (size_t i = 0; i < s->n; i++) {
        if (kept > 0 && s->record[kept - 1].t == s->record[i].t)
            doubles++;
        else
            s->record[kept++] = s->record[i];
    }
    s->n = kept;
    if (doubles > 0)
        orr_warnings_add(r->warnings, r->c.name, 0, 0,
                         "%s has %zu records at instants it already has; the first are kept", s->name,
                         doubles);
    return ORR_OK;
}

static orr_status hand_over(clk_reader *r, clk_list *list, orr_clk_series **out, size_t *n)
{
    if (list->n == 0) return ORR_OK;
    *out = malloc(list->n * sizeof **out);
    if (*out == NULL)
        return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for %zu clocks", list->n);
    *n = list->n;
    for (size_t i = 0; i < list->n; i++) (*out)[i] = list->item[i].s;
    list->n = 0; // theirs no more
    orr_status s = ORR_OK;
    for (size_t i = 0; i < *n && s == ORR_OK; i++) s = put_in_order(r, &(*out)[i]);
    return s;
}

static void span(orr_clk *x, const orr_clk_series *s, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (s[i].n == 0) continue;
        if (x->from == ORR_TIME_NONE || s[i].record[0].t < x->from) x->from = s[i].record[0].t;
        if (x->to == ORR_TIME_NONE || s[i].record[s[i].n - 1].t > x->to) x->to = s[i].record[s[i].n - 1].t;
    }
}

static orr_status count_epochs(clk_reader *r)
{
    orr_clk *x = r->out;
    clk_epochs *e = r->sat_epochs.n > 0 ? &r->sat_epochs : &r->receiver_epochs;
    if (e->n == 0) return ORR_OK;
    qsort(e->t, e->n, sizeof *e->t, orr_time_order);
    size_t n = 0;
    for (size_t i = 0; i < e->n; i++)
        if (n == 0 || e->t[n - 1] != e->t[i]) e->t[n++] = e->t[i];
    x->n_epochs = n;
    int64_t *scratch = malloc(n * sizeof *scratch);
    if (scratch == NULL)
        return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for %zu epochs", n);
    x->interval_s = orr_records_usual_step_s(e->t, n, scratch);
    free(scratch);
    x->epoch = e->t;
    e->t = NULL;
    return ORR_OK;
}

static orr_status finish(clk_reader *r)
{
    orr_clk *x = r->out;
    orr_status s = hand_over(r, &r->sats, &x->sat, &x->n_sats);
    if (s == ORR_OK) s = hand_over(r, &r->receivers, &x->receiver, &x->n_receivers);
    if (s != ORR_OK) return s;
    if (x->n_sats > 0) qsort(x->sat, x->n_sats, sizeof *x->sat, by_sat);
    span(x, x->sat, x->n_sats);
    span(x, x->receiver, x->n_receivers);
    if (x->n_sats == 0 && x->n_receivers == 0 && x->n_other == 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the file has no clock record");
    return count_epochs(r);
}

static void free_list(clk_list *list)
{
    for (size_t i = 0; i < list->n; i++) free(list->item[i].s.record);
    free(list->item);
}

orr_status orr_clk_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                         orr_clk *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_clk){.scale = ORR_SCALE_GPS,
                     .leap_seconds = -1,
                     .from = ORR_TIME_NONE,
                     .to = ORR_TIME_NONE,
                     .interval_s = ORR_NAN};
    clk_reader r = {.out = out, .warnings = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    out->leap = r.limits.leap;
    orr_cursor_init(&r.c, name, text, n);
    orr_status s = read_header(&r);
    if (s == ORR_OK) s = clk_read_records(&r);
    if (s == ORR_OK) s = finish(&r);
    if (s == ORR_OK && (out->scale == ORR_SCALE_UTC || out->scale == ORR_SCALE_GLO))
        orr_leap_warn(out->to, r.limits.leap, name, warnings);
    free_list(&r.sats);
    free_list(&r.receivers);
    free(r.sat_epochs.t);
    free(r.receiver_epochs.t);
    if (s != ORR_OK) orr_clk_free(out);
    return s;
}

const orr_clk_series *orr_clk_find(const orr_clk *x, orr_sat sat)
{
    orr_clk_series key = {.sat = sat};
    return x->n_sats == 0 ? NULL : bsearch(&key, x->sat, x->n_sats, sizeof *x->sat, by_sat);
}

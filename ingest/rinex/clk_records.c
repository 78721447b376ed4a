// SPDX-License-Identifier: GPL-3.0-or-later
// The records of a RINEX clock file: type, name, date, number of values, values (two on the first line, four
// on the next).
#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/rinex/clk_private.h"

static orr_status bad(clk_reader *r, orr_view line, orr_view at, const char *what)
{
    int column = at.p != NULL ? (int)(at.p - line.p) + 1 : 1;
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, column, "%s", what);
}

// Year to second are the six words before *rest. The same text as in the record before means the same
// instant.
static orr_status read_epoch(clk_reader *r, orr_view line, orr_view *rest, orr_time *t)
{
    orr_view word = {0}, first = {0};
    for (int i = 0; i < 6; i++) {
        if (!orr_view_word(rest, &word)) return bad(r, line, word, "the line ends inside its date");
        if (i == 0) first = word;
    }
    size_t n = (size_t)(word.p + word.n - first.p);
    if (n == r->last_epoch_n && n > 0 && memcmp(first.p, r->last_epoch, n) == 0) {
        *t = r->last_time;
        return ORR_OK;
    }
    if (!orr_records_civil((orr_view){first.p, n}, r->out->scale, r->limits.leap, t))
        return bad(r, line, first, "no date");
    r->last_epoch_n = n <= sizeof r->last_epoch ? n : 0;
    memcpy(r->last_epoch, first.p, r->last_epoch_n);
    r->last_time = *t;
    return ORR_OK;
}

// A file cut inside its last number still reads as a number, a wrong one: E19.12 always ends with its
// exponent.
static bool whole_number(orr_view v)
{
    return v.n >= 4 &&
           (v.p[v.n - 4] == 'E' || v.p[v.n - 4] == 'D' || v.p[v.n - 4] == 'e' || v.p[v.n - 4] == 'd');
}

static orr_status read_values(clk_reader *r, orr_view *line, orr_view *rest, double v[6])
{
    orr_view word = {0};
    int64_t n;
    if (!orr_view_word(rest, &word) || orr_view_int(word, &n) != ORR_FIELD_OK || n < 1 || n > 6)
        return bad(r, *line, word, "the number of values is not 1 to 6");
    for (int k = 0; k < n; k++) {
        if (k == 2) {
            const orr_cursor here = r->c;
            if (!orr_cursor_next(&r->c, line)) {
                orr_status s = orr_cursor_status(&r->c, r->diag);
                return s != ORR_OK ? s
                                   : bad(r, *line, (orr_view){0},
                                         "the file ends before the values of its last record");
            }
            if (line->n > 0 && line->p[0] >= 'A' && line->p[0] <= 'Z') { // the next record: theirs is missing
                r->c = here;
                return bad(r, *line, (orr_view){0}, "the second line of the record is missing");
            }
            *rest = *line;
        }
        if (!orr_view_word(rest, &word)) return bad(r, *line, *rest, "the line ends before its values");
        if (orr_view_real(word, &v[k]) != ORR_FIELD_OK) return bad(r, *line, word, "a value is no number");
        if (r->c.unterminated && !whole_number(word))
            return bad(r, *line, word, "the file ends inside a number: it is cut short");
    }
    return ORR_OK;
}

static orr_status find(clk_reader *r, clk_list *list, orr_sat sat, orr_view name, clk_build **out)
{
    for (size_t k = 0; k < list->n; k++) {
        size_t i = list->guess + k < list->n ? list->guess + k : list->guess + k - list->n;
        clk_build *b = &list->item[i];
        if (sat != ORR_SAT_NONE ? b->s.sat == sat : orr_view_equals(name, b->s.name)) {
            list->guess = i + 1 < list->n ? i + 1 : 0;
            *out = b;
            return ORR_OK;
        }
    }
    orr_status s = orr_records_grow(&list->item, list->n, sizeof *list->item,
                                    r->limits.max_records < 100000 ? r->limits.max_records : 100000, "clocks",
                                    &r->c, r->diag);
    if (s != ORR_OK) return s;
    clk_build *b = &list->item[list->n++];
    *b = (clk_build){.s.sat = sat};
    orr_view_copy(name, b->s.name, sizeof b->s.name);
    list->guess = 0;
    *out = b;
    return ORR_OK;
}

static orr_status note_epoch(clk_reader *r, clk_epochs *e, orr_time t)
{
    if (e->n > 0 && e->t[e->n - 1] == t) return ORR_OK;
    orr_status s =
        orr_records_grow(&e->t, e->n, sizeof *e->t, r->limits.max_records, "epochs", &r->c, r->diag);
    if (s == ORR_OK) e->t[e->n++] = t;
    return s;
}

static orr_status read_record(clk_reader *r, orr_view line, bool satellite)
{
    orr_view rest = orr_view_cols(line, 3, (int)ORR_LINE_MAX), name;
    orr_sat sat = ORR_SAT_NONE;
    if (!orr_view_word(&rest, &name) || name.n > 9)
        return bad(r, line, rest, "a record without the name of its clock");
    if (satellite) {
        char text[12];
        sat =
            name.n == 3 ? orr_sat_parse3(name.p, 'G') : orr_sat_parse(orr_view_copy(name, text, sizeof text));
        if (sat == ORR_SAT_NONE) return bad(r, line, name, "a satellite clock of no known satellite");
    }
    double v[6] = {ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN};
    orr_time t = 0;
    orr_status s = read_epoch(r, line, &rest, &t);
    if (s == ORR_OK) s = read_values(r, &line, &rest, v);
    clk_build *b = NULL;
    if (s == ORR_OK) s = find(r, satellite ? &r->sats : &r->receivers, sat, name, &b);
    if (s == ORR_OK && r->records++ >= r->limits.max_records)
        s = orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "more than %zu records", r->limits.max_records);
    if (s == ORR_OK)
        s = orr_records_grow(&b->s.record, b->s.n, sizeof *b->s.record, r->limits.max_records, "records",
                             &r->c, r->diag);
    if (s == ORR_OK) s = note_epoch(r, satellite ? &r->sat_epochs : &r->receiver_epochs, t);
    if (s == ORR_OK) b->s.record[b->s.n++] = (orr_clk_record){t, v[0], v[1], v[2], v[3]};
    return s;
}

// One line and what it takes with it. ORR_E_FORMAT: it is no record, for the reason in *why.
static orr_status read_line(clk_reader *r, orr_view line)
{
    char a = orr_view_char(line, 1), b = orr_view_char(line, 2);
    bool spaced = orr_view_char(line, 3) == ' ';
    if (a == 'A' && (b == 'S' || b == 'R') && spaced) return read_record(r, line, b == 'S');
    if (!spaced || !((a == 'C' && b == 'R') || (a == 'D' && b == 'R') || (a == 'M' && b == 'S')))
        return bad(r, line, line, "a line that starts with none of AS, AR, CR, DR, MS");
    orr_view rest = orr_view_cols(line, 3, (int)ORR_LINE_MAX), name;
    double v[6];
    orr_time t;
    if (!orr_view_word(&rest, &name)) return bad(r, line, rest, "a record without the name of its clock");
    orr_status s = read_epoch(r, line, &rest, &t);
    if (s == ORR_OK) s = read_values(r, &line, &rest, v); // for the lines that it takes
    r->out->n_other += s == ORR_OK;
    return s;
}

orr_status clk_read_records(clk_reader *r)
{
    orr_view line;
    orr_diag *const diag = r->diag;
    while (orr_cursor_next(&r->c, &line)) {
        if (orr_view_is_blank(line)) continue;
        orr_diag why = {0};
        r->diag = &why;
        orr_status s = read_line(r, line);
        r->diag = diag;
        r->tally.good += s == ORR_OK;
        if (s == ORR_E_FORMAT && !r->c.unterminated) { // a file that is cut is refused
            orr_records_leave_out(&r->tally, &r->c, why.column, why.text, r->warnings);
        } else if (s != ORR_OK) {
            if (diag != NULL) *diag = why;
            return s;
        }
    }
    orr_status s = orr_cursor_status(&r->c, diag);
    return s == ORR_OK ? orr_records_verdict(&r->tally, diag) : s;
}

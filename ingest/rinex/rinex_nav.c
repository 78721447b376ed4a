// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/rinex/rinex_nav.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/input/input.h"
#include "ingest/input/sniff.h"
#include "ingest/rinex/rinex_nav_private.h"

orr_nav_limits orr_nav_default_limits(void)
{
    return (orr_nav_limits){(size_t)2 << 30, 1000000, 100000, NULL};
}

void orr_nav_free(orr_nav *nav)
{
    for (size_t i = 0; i < nav->n_comments; i++) free(nav->comment[i]);
    free(nav->comment);
    free(nav->eph);
    free(nav->iono);
    free(nav->sto);
    free(nav->eop);
    *nav = (orr_nav){0};
}

typedef struct reader {
    orr_cursor c;
    orr_nav *nav;
    orr_nav_limits limits;
    orr_warnings *w;
    orr_diag *diag;
    bool v2, v4;
    char system; // of RINEX 2 records
    bool have;   // a line was read ahead
    nav_fault first_fault;
    orr_view ahead;
} reader;

static bool next_line(reader *r, orr_view *line)
{
    if (r->have) {
        *line = r->ahead;
        r->have = false;
        return true;
    }
    return orr_cursor_next(&r->c, line);
}

// Klobuchar's alpha without beta, or the reverse, is of no use.
static void drop_half_sets(reader *r)
{
    orr_nav *nav = r->nav;
    size_t kept = 0;
    for (size_t i = 0; i < nav->n_iono; i++) {
        const orr_nav_iono *k = &nav->iono[i];
        if (k->kind == ORR_NAV_KLOBUCHAR && (isnan(k->coefficient[0]) || isnan(k->coefficient[4]))) {
            orr_warnings_add(r->w, r->c.name, k->line, 0,
                             "ionosphere parameters of %s with only one of alpha and beta: left out",
                             orr_system_name(k->system));
            continue;
        }
        nav->iono[kept++] = *k;
    }
    nav->n_iono = kept;
}

static orr_status read_header(reader *r)
{
    orr_view line;
    orr_nav *nav = r->nav;
    if (!orr_cursor_next(&r->c, &line))
        return orr_diag_at(r->diag, ORR_E_KIND, r->c.name, 1, 0, "the file is empty");
    orr_rinex_first first;
    orr_status s = orr_rinex_first_line(r->c.name, line, &first, r->diag);
    if (s != ORR_OK) return s;
    nav->version = first.version;
    orr_rinex_check_version(r->c.name, first.version, r->w);
    bool wide = false;
    r->v2 = first.version < 3;
    r->v4 = first.version >= 4;
    bool nav_type = first.type == 'N' || (r->v2 && (first.type == 'G' || first.type == 'H'));
    if (!nav_type)
        return orr_diag_at(r->diag, ORR_E_KIND, r->c.name, 1, 21,
                           "a RINEX file of type '%c', not a navigation file", first.type);
    r->system = first.type == 'G' ? 'R' : first.type == 'H' ? 'S' : 'G';
    bool known = first.system != ' ' && (first.system == 'M' || strchr(ORR_SYSTEMS, first.system) != NULL);
    nav->system = r->v2 ? r->system : known ? first.system : 'M';
    if (!r->v2 && !known)
        orr_warnings_add(r->w, r->c.name, 1, 41, "the satellite system is missing: taken for a mixed file");
    while (orr_cursor_next(&r->c, &line)) {
        if ((size_t)r->c.line > r->limits.max_header_lines)
            return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "a header of more than %zu lines",
                                    r->limits.max_header_lines);
        if (orr_view_equals(orr_rinex_label(line), "END OF HEADER")) {
            drop_half_sets(r);
            return ORR_OK;
        }
        orr_rinex_check_width(r->c.name, r->c.line, line, &wide, r->w);
        s = orr_nav_header_line(nav, line, r->c.name, r->c.line, r->w, r->diag);
        if (s != ORR_OK) return s;
    }
    s = orr_cursor_status(&r->c, r->diag);
    return s != ORR_OK ? s
                       : orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the header has no END OF HEADER");
}

// Does a record start here? Continuation lines are indented.
static bool starts_record(const reader *r, orr_view line)
{
    if (r->v4) return line.n > 0 && line.p[0] == '>';
    if (r->v2) return !orr_view_is_blank(orr_view_cols(line, 1, 2));
    return orr_view_char(line, 1) != ' ';
}

// The lines of the next record; false at the end.
static bool next_record(reader *r, nav_lines *rec)
{
    *rec = (nav_lines){.leap = r->limits.leap};
    orr_view line;
    bool started = false;
    while (next_line(r, &line)) {
        bool starts = starts_record(r, line);
        if (started && starts) {
            r->ahead = line;
            r->have = true;
            return true;
        }
        if (!started) {
            if (orr_view_is_blank(line)) continue;
            started = true;
            if (r->v4 && starts) {
                rec->tag = (nav_line){line, r->c.line};
                continue;
            }
        }
        // Empty lines behind a record are no part of it; a blank one within is (all its fields are spare).
        if (line.n == 0) continue;
        if (rec->n < NAV_MAX_LINES) rec->line[rec->n] = (nav_line){line, r->c.line};
        rec->n++;
        rec->cut = r->c.unterminated;
    }
    return started;
}

static orr_status skip(reader *r, const nav_lines *rec, const nav_fault *f, const char *what)
{
    if (r->nav->n_skipped++ == 0) r->first_fault = *f;
    (void)rec;
    orr_warnings_add(r->w, r->c.name, f->line, f->column, "%s: the %s is left out", f->text, what);
    return ORR_OK;
}

static orr_status keep_eph(reader *r, const nav_lines *rec, orr_nav_message message)
{
    orr_nav_eph e;
    nav_fault f = {0};
    if (rec->n == 0 || rec->n > NAV_MAX_LINES)
        orr_nav_fault(&f, rec->tag.text.p != NULL ? rec->tag.number : rec->line[0].number, 0,
                      "a record of %zu lines", rec->n);
    else if (orr_nav_take_eph(rec, r->v2, r->system, message, &e, &f)) {
        if (f.line != 0)
            orr_warnings_add(r->w, r->c.name, f.line, f.column, "%s", f.text); // it can be lived with
        return orr_nav_append(&r->nav->eph, &r->nav->n_eph, sizeof e, &e, r->diag);
    }
    return skip(r, rec, &f, "ephemeris");
}

static orr_status take_v4(reader *r, const nav_lines *rec)
{
    nav_fault f = {0};
    if (rec->tag.text.p == NULL) {
        orr_nav_fault(&f, rec->line[0].number, 1, "lines before the first record");
        return skip(r, rec, &f, "text");
    }
    orr_view kind = orr_view_trim(orr_view_cols(rec->tag.text, 3, 3));
    if (rec->n == 0 || rec->n > NAV_MAX_LINES) {
        orr_nav_fault(&f, rec->tag.number, 0, "a record of %zu lines", rec->n);
        return skip(r, rec, &f, "record");
    }
    if (orr_view_equals(kind, "EPH")) {
        orr_view name = orr_view_trim(orr_view_cols(rec->tag.text, 11, 4)),
                 sat = orr_view_cols(rec->tag.text, 7, 3);
        orr_nav_message m = orr_nav_message_parse(name);
        if (m == ORR_NAV_NONE || m == ORR_NAV_L1OC || m == ORR_NAV_L3OC || m >= ORR_NAV_IFNV) {
            orr_nav_fault(&f, rec->tag.number, 11, "ephemerides of message \"%.*s\" are not read",
                          (int)name.n, name.p);
            return skip(r, rec, &f, "ephemeris");
        }
        orr_view first = orr_view_cols(rec->line[0].text, 1, 3);
        if (first.n != 3 || sat.n != 3 || memcmp(first.p, sat.p, 3) != 0) {
            orr_nav_fault(&f, rec->line[0].number, 1, "another satellite than the record's first line says");
            return skip(r, rec, &f, "ephemeris");
        }
        return keep_eph(r, rec, m);
    }
    orr_nav *nav = r->nav;
    if (orr_view_equals(kind, "ION")) {
        orr_nav_iono x;
        if (orr_nav_take_iono(rec, &x, &f))
            return orr_nav_append(&nav->iono, &nav->n_iono, sizeof x, &x, r->diag);
        return skip(r, rec, &f, "ionosphere record");
    }
    if (orr_view_equals(kind, "STO")) {
        orr_nav_sto x;
        if (orr_nav_take_sto(rec, &x, &f))
            return orr_nav_append(&nav->sto, &nav->n_sto, sizeof x, &x, r->diag);
        return skip(r, rec, &f, "time offset");
    }
    if (orr_view_equals(kind, "EOP")) {
        orr_nav_eop x;
        if (orr_nav_take_eop(rec, &x, &f))
            return orr_nav_append(&nav->eop, &nav->n_eop, sizeof x, &x, r->diag);
        return skip(r, rec, &f, "Earth orientation record");
    }
    orr_nav_fault(&f, rec->tag.number, 3, "a record of kind \"%.*s\" is not known", (int)kind.n, kind.p);
    return skip(r, rec, &f, "record");
}

static int compare_time(orr_time a, orr_time b) { return a < b ? -1 : a > b; }

static int compare_eph(const void *va, const void *vb)
{
    const orr_nav_eph *a = va, *b = vb;
    if (a->sat != b->sat) return a->sat < b->sat ? -1 : 1;
    int c = compare_time(a->toe, b->toe);
    if (c == 0) c = compare_time(a->toc, b->toc);
    if (c == 0) c = compare_time(a->transmission, b->transmission);
    if (c == 0) c = (int)a->message - (int)b->message;
    return c != 0 ? c : compare_time(a->line, b->line);
}

// A file of damage alone is refused; one that is but a header is told of.
static orr_status nothing_read(const reader *r)
{
    const nav_fault *f = &r->first_fault;
    if (r->nav->n_skipped > 0)
        return orr_diag_at(r->diag, ORR_E_FORMAT, r->c.name, f->line, f->column,
                           "none of the %zu records can be read; the first: %s", r->nav->n_skipped, f->text);
    orr_warnings_add(r->w, r->c.name, r->c.line, 0, "the file has no records");
    return ORR_OK;
}

// GLONASS is dated in UTC.
static void warn_of_leaps(const orr_nav *nav, const orr_leap_table *leap, const char *name, orr_warnings *w)
{
    orr_time last = ORR_TIME_NONE;
    for (size_t i = 0; i < nav->n_eph; i++)
        if (nav->eph[i].kind == ORR_NAV_GLONASS && nav->eph[i].toc > last) last = nav->eph[i].toc;
    orr_leap_warn(last, leap, name, w);
}

orr_status orr_nav_parse(const char *name, const char *text, size_t n, const orr_nav_limits *limits,
                         orr_nav *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_nav){0};
    reader r = {.nav = out, .w = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_nav_default_limits();
    out->leap = r.limits.leap;
    if (n > r.limits.max_bytes)
        return orr_diag_at(diag, ORR_E_LIMIT, name, 0, 0, "more than %zu bytes of text", r.limits.max_bytes);
    orr_cursor_init(&r.c, name, text, n);
    orr_status s = read_header(&r);
    nav_lines rec;
    while (s == ORR_OK && next_record(&r, &rec)) {
        s = r.v4 ? take_v4(&r, &rec) : keep_eph(&r, &rec, ORR_NAV_NONE);
        if (s == ORR_OK && out->n_eph + out->n_iono + out->n_sto + out->n_eop > r.limits.max_records)
            s = orr_cursor_error(&r.c, diag, ORR_E_LIMIT, 0, "more than %zu records", r.limits.max_records);
    }
    if (s == ORR_OK) s = orr_cursor_status(&r.c, diag);
    if (s == ORR_OK && out->n_eph + out->n_iono + out->n_sto + out->n_eop == 0) s = nothing_read(&r);
    if (s != ORR_OK) {
        orr_nav_free(out);
        return s;
    }
    if (out->n_eph > 1) qsort(out->eph, out->n_eph, sizeof *out->eph, compare_eph);
    orr_nav_tell_conflicts(out->eph, out->n_eph, name, warnings);
    warn_of_leaps(out, r.limits.leap, name, warnings);
    return ORR_OK;
}

orr_status orr_nav_read(const char *path, const orr_nav_limits *limits, orr_nav *out, orr_warnings *warnings,
                        orr_diag *diag)
{
    *out = (orr_nav){0};
    orr_input_limits l = orr_input_default_limits();
    if (limits != NULL) l.max_bytes = limits->max_bytes;
    orr_bytes b = {0};
    l.kinds = ORR_KIND_BIT(ORR_KIND_RINEX_NAV);
    orr_status s = orr_input_read_all(path, &l, &b, diag);
    if (s == ORR_OK) s = orr_nav_parse(path, b.text, b.n, limits, out, warnings, diag);
    orr_bytes_free(&b);
    return s;
}

void orr_nav_of_sat(const orr_nav *nav, orr_sat sat, size_t *first, size_t *count)
{
    size_t lo = 0, hi = nav->n_eph;
    while (lo < hi) {
        size_t mid = lo + (hi - lo) / 2;
        if (nav->eph[mid].sat < sat)
            lo = mid + 1;
        else
            hi = mid;
    }
    size_t end = lo;
    while (end < nav->n_eph && nav->eph[end].sat == sat) end++;
    *first = lo;
    *count = end - lo;
}

bool orr_nav_eph_usable(const orr_nav_eph *e)
{
    uint32_t h = e->health;
    if (h == 0xffffffffu) return false;
    switch (orr_sat_system(e->sat)) {
    case 'E': // E5b: bits 6-8, E5a: 3-5, E1-B: 0-2, each data validity and two of health status
        return (h & (e->message == ORR_NAV_FNAV ? 0x38u : 0x1c7u)) == 0;
    case 'J':
        return e->message == ORR_NAV_LNAV ? (h & ~1u) == 0 : h == 0;
    default:
        return h == 0;
    }
}

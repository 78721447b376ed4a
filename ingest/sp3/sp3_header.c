// SPDX-License-Identifier: GPL-3.0-or-later
// Lines 1 to the first epoch line of an SP3 file (Hilla 2016, tables of header lines; SP3-a and b: Spofford
// and Remondi 1994, Gurtner and Rothacher 1998). Lines are known by their first two characters, not by their
// number.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "ingest/input/sniff.h"
#include "ingest/sp3/sp3_private.h"

static orr_status bad(sp3_parser *p, int column, const char *what)
{
    return orr_cursor_error(&p->c, p->diag, ORR_E_FORMAT, column, "%s", what);
}

// Seconds "59.99999999" as whole seconds and ns, from their digits, so that nothing rounds up into the next
// minute.
static bool read_seconds(orr_view line, int shift, orr_civil *out)
{
    double s = 0;
    if (orr_field_real(line, 21 + shift, 11, &s) != ORR_FIELD_OK || !(s >= 0) || s >= 61) return false;
    out->second = (int)s;
    double ns = (s - out->second) * 1e9; // exact to 1e-5 ns: s has 53 bits and is below 61
    out->ns = (int32_t)floor(ns + 0.5);
    if (out->ns == 1000000000) { // finer than ns: not in this format
        out->second++;
        out->ns = 0;
    }
    return true;
}

bool sp3_read_civil(orr_view line, int shift, bool day0, orr_civil *out, int *column)
{
    static const struct {
        int col, width, lo, hi;
    } field[5] = {{4, 4, 1, 9999}, {9, 2, 1, 12}, {12, 2, 1, 31}, {15, 2, 0, 24}, {18, 2, 0, 60}};
    int v[5];
    // A character lost or gained shifts the rest; two-digit fields would then be read by halves.
    static const int between[] = {8, 11, 14, 17, 20};
    for (int i = 0; i < 5; i++)
        if (orr_view_char(line, between[i] + shift) != ' ') {
            *column = between[i] + shift;
            return false;
        }
    for (int i = 0; i < 5; i++) {
        int lo = day0 && i == 2 ? 0 : field[i].lo;
        if (orr_field_int_in(line, field[i].col + shift, field[i].width, lo, field[i].hi, &v[i]) !=
            ORR_FIELD_OK) {
            *column = field[i].col + shift;
            return false;
        }
    }
    *out = (orr_civil){.year = v[0], .month = v[1], .day = v[2], .hour = v[3], .minute = v[4]};
    *column = 21 + shift;
    return read_seconds(line, shift, out);
}

static void copy_trimmed(orr_view line, int col, int width, char *to, size_t n)
{
    orr_view_copy(orr_view_trim(orr_view_cols(line, col, width)), to, n);
}

// "#dP2024  2  4  0  0  0.00000000     289 d+D   IGS20 FIT AIUB"
static orr_status read_line_1(sp3_parser *p, orr_view line)
{
    orr_sp3 *o = p->out;
    char mode = orr_view_char(line, 3);
    bool unversioned = orr_sp3_is_unversioned(line);
    if (line.n < 3 || line.p[0] != '#' ||
        (!unversioned && (line.p[1] < 'a' || line.p[1] > 'z' || (mode != 'P' && mode != 'V')))) {
        orr_sniffed s = orr_sniff((orr_view){line.p, (size_t)(p->c.end - line.p)});
        return orr_cursor_error(&p->c, p->diag, ORR_E_KIND, 1,
                                "not an SP3 file: it does not begin with #aP to #dV (this is %s)",
                                orr_kind_name(s.kind));
    }
    if (unversioned)
        orr_cursor_warn(&p->c, p->warnings, 2, "the first line has no version letter; taken as version a");
    else if (line.p[1] > 'd')
        return orr_cursor_error(&p->c, p->diag, ORR_E_UNSUPPORTED, 2,
                                "SP3 version '%c' is not known (a to d are)", line.p[1]);
    o->version = unversioned ? 'a' : line.p[1];
    o->has_velocity = p->header_says_velocity = mode == 'V';
    int column = 0;
    if (sp3_read_civil(line, 0, false, &p->start, &column))
        p->header_start_line = p->c.line;
    else
        orr_cursor_warn(&p->c, p->warnings, column,
                        "the header's start time cannot be read; the epochs say it");
    if (orr_field_int(line, 33, 7, &p->header_epochs) != ORR_FIELD_OK || p->header_epochs < 0) {
        p->header_epochs = -1;
        orr_cursor_warn(&p->c, p->warnings, 33, "the header's number of epochs cannot be read");
    }
    copy_trimmed(line, 41, 5, o->data_used, sizeof o->data_used);
    copy_trimmed(line, 47, 5, o->coordinates, sizeof o->coordinates);
    copy_trimmed(line, 53, 3, o->orbit_type, sizeof o->orbit_type);
    copy_trimmed(line, 57, 4, o->agency, sizeof o->agency);
    return ORR_OK;
}

// "## 2300      0.00000000   300.00000000 60344 0.0000000000000"
static orr_status read_line_2(sp3_parser *p, orr_view line)
{
    double interval = 0;
    p->header_week_line = p->c.line;
    if (orr_field_real(line, 4, 4, &p->header_week) != ORR_FIELD_OK ||
        orr_field_real(line, 9, 15, &p->header_sow) != ORR_FIELD_OK)
        p->header_week = p->header_sow = ORR_NAN;
    if (orr_field_real(line, 25, 14, &interval) == ORR_FIELD_OK && interval >= 0 && interval <= 1e6)
        p->out->interval_s = interval;
    else
        orr_cursor_warn(&p->c, p->warnings, 25, "the header's epoch interval cannot be read");
    return ORR_OK;
}

bool sp3_is_sat_like(const char three[3])
{
    char letter = (char)(three[0] | 0x20);
    return letter >= 'a' && letter <= 'z' && three[1] >= '0' && three[1] <= '9' && three[2] >= '0' &&
           three[2] <= '9';
}

// The lists end at column 60; something behind it belongs to another line whose beginning was lost.
static void check_list_end(sp3_parser *p, orr_view line)
{
    if (!orr_view_is_blank(orr_view_cols(line, 61, 1 << 20)))
        orr_cursor_warn(&p->c, p->warnings, 61,
                        "this list ends at column 60; what stands behind it is not read");
}

static bool is_filler(orr_view id)
{
    for (size_t i = 0; i < id.n; i++)
        if (id.p[i] != ' ' && id.p[i] != '0' && id.p[i] != '\t') return false;
    return true;
}

// "+   80   G01G02...": the number of satellites (first such line alone), then seventeen satellites a line.
static orr_status read_satellites(sp3_parser *p, orr_view line)
{
    if (p->header_sats_line == 0) {
        p->header_sats_line = p->c.line;
        if (orr_field_int(line, 3, 4, &p->header_sats) != ORR_FIELD_OK || p->header_sats < 0) {
            p->header_sats = -1;
            orr_cursor_warn(&p->c, p->warnings, 3, "the header's number of satellites cannot be read");
        }
    }
    check_list_end(p, line);
    for (int i = 0; i < 17; i++) {
        int col = 10 + 3 * i;
        orr_view id = orr_view_cols(line, col, 3);
        if (is_filler(id)) continue;
        char three[3] = {orr_view_char(line, col), orr_view_char(line, col + 1),
                         orr_view_char(line, col + 2)};
        orr_sat sat = orr_sat_parse3(three, 'G');
        bool unknown = sat == ORR_SAT_NONE && sp3_is_sat_like(three);
        if (unknown)
            orr_cursor_warn(&p->c, p->warnings, col, "%.3s is of a system that is not known; left out",
                            three);
        if (sat == ORR_SAT_NONE && !unknown) {
            char text[4];
            return orr_cursor_error(&p->c, p->diag, ORR_E_FORMAT, col,
                                    "'%s' in the list of satellites is none",
                                    orr_view_copy(id, text, sizeof text));
        }
        if (three[0] == ' ' && p->out->version >= 'c') sp3_fault_note(p, SP3_BLANK_SYSTEM);
        orr_status st = ORR_OK;
        size_t known = p->out->n_sats;
        int index = unknown ? -1 : sp3_sat_index(p, sat, &st);
        if (index < 0 && !unknown) return st;
        if (p->out->n_sats == known && !unknown)
            orr_cursor_warn(&p->c, p->warnings, col, "%.3s is twice in the list of satellites", id.p);
        if (p->n_listed >= 65536)
            return orr_cursor_error(&p->c, p->diag, ORR_E_LIMIT, col, "the list of satellites does not end");
        if (!ORR_ARRAY_GROW(p->listed, p->n_listed))
            return orr_diag_set(p->diag, ORR_E_MEMORY, "out of memory");
        p->listed[p->n_listed++] = (int16_t)index;
    }
    return ORR_OK;
}

// "++         7  6  5": an accuracy exponent for each place of the list of satellites.
static orr_status read_accuracies(sp3_parser *p, orr_view line)
{
    check_list_end(p, line);
    for (int i = 0; i < 17; i++, p->n_accuracies++) {
        int exponent = 0, col = 10 + 3 * i;
        orr_field f = orr_field_int_in(line, col, 3, 0, 255, &exponent);
        if (f == ORR_FIELD_OK && orr_view_char(line, col + 2) == ' ') f = ORR_FIELD_BAD; // shifted
        if (f == ORR_FIELD_BAD)
            orr_cursor_warn(&p->c, p->warnings, col, "this accuracy cannot be read; taken as unknown");
        if (f != ORR_FIELD_OK || exponent == 0) continue;
        if (p->n_accuracies < p->n_listed) {
            int16_t sat = p->listed[p->n_accuracies];
            if (sat >= 0) p->out->accuracy_exp[sat] = (uint8_t)exponent;
        } else {
            orr_cursor_warn(&p->c, p->warnings, col,
                            "an accuracy for satellite %zu of the list, which has only %zu: left out",
                            p->n_accuracies + 1, p->n_listed);
        }
    }
    return ORR_OK;
}

// "%c M  cc GPS ccc ...": file type and time system, on the first such line.
static orr_status read_types(sp3_parser *p, orr_view line)
{
    if (p->has_time_system) return ORR_OK;
    p->has_time_system = true;
    orr_sp3 *o = p->out;
    copy_trimmed(line, 4, 2, o->file_type, sizeof o->file_type);
    orr_view name = orr_view_trim(orr_view_cols(line, 10, 3));
    bool unset = name.n == 0 || orr_view_equals(name, "ccc");
    if (!unset && orr_scale_parse(name.p, name.n, &o->scale) == ORR_OK) return ORR_OK;
    if (unset) { // version a has no such field; it is GPS time by definition
        if (o->version != 'a')
            orr_cursor_warn(&p->c, p->warnings, 10, "the header names no time system; taken as GPS time");
        return ORR_OK;
    }
    char text[4];
    return orr_cursor_error(&p->c, p->diag, ORR_E_FORMAT, 10,
                            "time system '%s' is not known (GPS, GLO, GAL, BDT, TAI, UTC, IRN, QZS are)",
                            orr_view_copy(name, text, sizeof text));
}

// "%f  1.2500000  1.025000000  ...": the bases of the records' exponents, on the first such line.
static orr_status read_bases(sp3_parser *p, orr_view line)
{
    if (p->has_bases) return ORR_OK;
    p->has_bases = true;
    orr_sp3 *o = p->out;
    double base = 0;
    if (orr_field_real(line, 4, 10, &base) == ORR_FIELD_OK && base >= 0)
        o->pos_vel_base = base;
    else
        orr_cursor_warn(&p->c, p->warnings, 4,
                        "the base of the positions' standard deviations cannot be read");
    if (orr_field_real(line, 15, 12, &base) == ORR_FIELD_OK && base >= 0)
        o->clock_base = base;
    else
        orr_cursor_warn(&p->c, p->warnings, 15, "the base of the clocks' standard deviations cannot be read");
    for (int n = 0; n < 100; n++) p->pos_sdev[n] = o->pos_vel_base > 0 ? (float)pow(o->pos_vel_base, n) : NAN;
    for (int n = 0; n < 1000; n++) p->clock_sdev[n] = o->clock_base > 0 ? (float)pow(o->clock_base, n) : NAN;
    p->pos_sdev[99] = p->clock_sdev[999] = INFINITY;
    return ORR_OK;
}

static orr_status read_comment(sp3_parser *p, orr_view line, size_t marker)
{
    orr_sp3 *o = p->out;
    orr_view text = orr_view_rtrim((orr_view){line.p + marker, line.n - marker});
    if (text.n > 0 && *text.p == ' ') text = (orr_view){text.p + 1, text.n - 1};
    if (o->n_comments >= p->limits.max_comments)
        return orr_cursor_error(&p->c, p->diag, ORR_E_LIMIT, 0, "more than %zu comment lines",
                                p->limits.max_comments);
    if (!ORR_ARRAY_GROW(o->comment, o->n_comments))
        return orr_diag_set(p->diag, ORR_E_MEMORY, "out of memory");
    size_t columns = 0;
    for (size_t i = 0; i < line.n; i++) columns += ((unsigned char)line.p[i] & 0xc0) != 0x80; // UTF-8 goes on
    if (columns > 80)
        orr_cursor_warn(&p->c, p->warnings, 81, "a comment goes on beyond column 80; read all the same");
    for (size_t i = 0; i < text.n; i++)
        if ((unsigned char)text.p[i] < 0x20 && text.p[i] != '\t') {
            orr_cursor_warn(&p->c, p->warnings, (int)(text.p + i - line.p) + 1,
                            "control characters in a comment (shown as '?')");
            break;
        }
    o->comment[o->n_comments] = orr_view_dup(text);
    if (o->comment[o->n_comments] == NULL) return orr_diag_set(p->diag, ORR_E_MEMORY, "out of memory");
    o->n_comments++;
    return ORR_OK;
}

orr_status sp3_read_comment(sp3_parser *p, orr_view line) { return read_comment(p, line, 2); }

static orr_status read_header_line(sp3_parser *p, orr_view line)
{
    if (orr_view_starts(line, "##")) return read_line_2(p, line);
    if (orr_view_starts(line, "++")) return read_accuracies(p, line);
    if (orr_view_starts(line, "+ ")) return read_satellites(p, line);
    if (orr_view_starts(line, "%c")) return read_types(p, line);
    if (orr_view_starts(line, "%f")) return read_bases(p, line);
    if (orr_view_starts(line, "%i")) return ORR_OK; // no meaning is defined for its numbers
    if (orr_view_starts(line, "/*")) return read_comment(p, line, 2);
    if (orr_view_starts(line, "%/*")) return read_comment(p, line, 3); // as laser-ranging centres write them
    if (orr_view_is_blank(line)) {
        sp3_fault_note(p, SP3_JUNK);
        return ORR_OK;
    }
    if (line.p[0] == '#') return bad(p, 1, "a second first line: two files in one? Give them separately");
    char text[12];
    return orr_cursor_error(
        &p->c, p->diag, ORR_E_FORMAT, 1,
        "'%s' begins no line of an SP3 header; what it should say is not known, so the file "
        "cannot be trusted",
        orr_view_copy(orr_view_cols(line, 1, 3), text, sizeof text));
}

static orr_status first_line(sp3_parser *p)
{
    orr_view line;
    for (bool first = true; orr_cursor_next(&p->c, &line); first = false) {
        if (first && orr_view_starts(line, "\xef\xbb\xbf")) line = (orr_view){line.p + 3, line.n - 3};
        if (!orr_view_is_blank(line)) return read_line_1(p, line);
        sp3_fault_note(p, SP3_JUNK);
    }
    orr_status st = orr_cursor_status(&p->c, p->diag);
    return st != ORR_OK ? st : orr_diag_at(p->diag, ORR_E_KIND, p->c.name, 0, 0, "the file is empty");
}

orr_status sp3_parse_header(sp3_parser *p, orr_view *first_epoch_line)
{
    orr_sp3 *o = p->out;
    o->scale = ORR_SCALE_GPS;
    orr_status st = first_line(p);
    orr_view line = {NULL, 0};
    bool found = false;
    while (st == ORR_OK && !found) {
        if (!orr_cursor_next(&p->c, &line)) {
            st = orr_cursor_status(&p->c, p->diag);
            return st != ORR_OK ? st : bad(p, 0, "the file ends in its header: there is no epoch");
        }
        if (orr_view_starts(line, "EOF")) return bad(p, 1, "the file ends in its header: there is no epoch");
        found = line.n > 1 && line.p[0] == '*' && (line.p[1] == ' ' || line.p[1] == '\t');
        if (!found) st = read_header_line(p, line);
    }
    if (st != ORR_OK) return st;
    *first_epoch_line = line;
    if (p->header_week_line == 0)
        orr_cursor_warn(&p->c, p->warnings, 0, "the header has no line ## (week and interval)");
    if (p->header_sats_line == 0)
        orr_cursor_warn(&p->c, p->warnings, 0, "the header lists no satellites; the records say them");
    if (!p->has_time_system && o->version != 'a')
        orr_cursor_warn(&p->c, p->warnings, 0, "the header has no line %%c (time system); taken as GPS time");
    if (!p->has_bases) {
        for (int n = 0; n < 100; n++) p->pos_sdev[n] = ORR_NAN;
        for (int n = 0; n < 1000; n++) p->clock_sdev[n] = ORR_NAN;
        p->pos_sdev[99] = p->clock_sdev[999] = INFINITY;
    }
    if (p->header_start_line != 0 &&
        orr_time_from_civil(&p->start, o->scale, p->limits.leap, &p->header_start) != ORR_OK) {
        p->header_start = ORR_TIME_NONE;
        orr_warnings_add(p->warnings, p->c.name, p->header_start_line, 4,
                         "the header's start time is no date; the epochs say it");
    }
    return ORR_OK;
}

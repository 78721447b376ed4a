// SPDX-License-Identifier: GPL-3.0-or-later
// One antenna of an ANTEX file: who it is, its grid, and a block for each frequency.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/tables/antex_private.h"

#define ANTEX_MAX_FREQUENCIES 64
#define MM 1e-3

static orr_status next_line(antex_reader *r, orr_view *line, orr_diag *why)
{
    if (orr_cursor_next(&r->c, line)) return ORR_OK;
    r->ended = true;
    orr_status s = orr_cursor_status(&r->c, why);
    if (s != ORR_OK) return s;
    return orr_cursor_error(&r->c, why, ORR_E_FORMAT, 0, "the file ends inside an antenna: it is cut short");
}

static orr_status bad(antex_reader *r, orr_diag *why, int column, const char *what)
{
    return orr_cursor_error(&r->c, why, ORR_E_FORMAT, column, "%s", what);
}

static orr_status read_type(antex_reader *r, orr_antex_antenna *a, orr_view line, orr_diag *why)
{
    orr_view_copy(orr_view_rtrim(orr_view_cols(line, 1, 20)), a->type, sizeof a->type);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 21, 20)), a->serial, sizeof a->serial);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 41, 10)), a->svn, sizeof a->svn);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 51, 10)), a->cospar, sizeof a->cospar);
    if (a->type[0] == '\0') return bad(r, why, 1, "an antenna without a type");
    // Satellites carry their PRN as serial number and a satellite code ("G063", "R701") behind it.
    if (a->svn[0] != '\0') {
        a->sat = orr_sat_parse(a->serial);
        if (a->sat == ORR_SAT_NONE) return bad(r, why, 21, "a satellite antenna of no known satellite");
    }
    return ORR_OK;
}

static orr_status read_grid(antex_reader *r, orr_antex_antenna *a, orr_view line, orr_diag *why)
{
    double *v[3] = {&a->zen1_deg, &a->zen2_deg, &a->dzen_deg};
    for (int i = 0; i < 3; i++)
        if (orr_field_real(line, 3 + 6 * i, 6, v[i]) != ORR_FIELD_OK)
            return bad(r, why, 3 + 6 * i, "ZEN1 / ZEN2 / DZEN: a number is missing or malformed");
    double steps = a->dzen_deg > 0 ? (a->zen2_deg - a->zen1_deg) / a->dzen_deg : -1;
    if (a->zen1_deg == a->zen2_deg) steps = 0;
    if (!(steps >= 0 && steps <= 1800) || fabs(steps - round(steps)) > 0.02 || fabs(a->zen1_deg) > 180 ||
        fabs(a->zen2_deg) > 180)
        return bad(r, why, 3, "ZEN1 / ZEN2 / DZEN is no grid");
    a->n_zeniths = (size_t)round(steps) + 1;
    return ORR_OK;
}

static orr_status read_dazi(antex_reader *r, orr_antex_antenna *a, orr_view line, orr_diag *why)
{
    if (orr_field_real(line, 3, 6, &a->dazi_deg) != ORR_FIELD_OK) return bad(r, why, 3, "DAZI is no number");
    if (a->dazi_deg == 0) return ORR_OK;
    double steps = 360.0 / a->dazi_deg;
    if (!(steps >= 1 && steps <= 3600) || fabs(steps - round(steps)) > 1e-6)
        return bad(r, why, 3, "DAZI does not divide the circle");
    a->n_azimuths = (size_t)round(steps) + 1;
    return ORR_OK;
}

// One row of a pattern: its name (NOAZI or the azimuth) in columns 1-8, values F8.2 in millimetres behind it.
static orr_status read_row(antex_reader *r, const orr_antex_antenna *a, orr_view line, double *row,
                           orr_diag *why)
{
    for (size_t k = 0; k < a->n_zeniths; k++) {
        int column = 9 + 8 * (int)k;
        double v;
        orr_field got = orr_field_real(line, column, 8, &v);
        if (got == ORR_FIELD_BLANK)
            return orr_cursor_error(&r->c, why, ORR_E_FORMAT, column,
                                    "only %zu of the %zu values of a pattern", k, a->n_zeniths);
        if (got != ORR_FIELD_OK) return bad(r, why, column, "a value of a pattern is no number");
        if (fabs(v) > 1e6) return bad(r, why, column, "a phase-centre variation of more than a kilometre");
        row[k] = v * MM;
    }
    size_t behind = 8 + 8 * a->n_zeniths;
    if (line.n > behind && !orr_view_is_blank((orr_view){line.p + behind, line.n - behind}))
        return orr_cursor_error(&r->c, why, ORR_E_FORMAT, (int)behind + 1,
                                "more than the %zu values of a pattern", a->n_zeniths);
    return ORR_OK;
}

static orr_status read_pattern(antex_reader *r, const orr_antex_antenna *a, orr_antex_frequency *f,
                               orr_diag *why)
{
    size_t n = (1 + a->n_azimuths) * a->n_zeniths; // at most 3602 x 1801
    if (n > r->limits.max_values || r->values > r->limits.max_values - n)
        return orr_cursor_error(&r->c, why, ORR_E_LIMIT, 0, "more than %zu values of patterns",
                                r->limits.max_values);
    // Every value takes a byte at least, so a short file cannot ask for much.
    if (n > (size_t)(r->c.end - r->c.at))
        return bad(r, why, 0, "the file ends before this antenna's pattern can");
    r->values += n;
    f->pattern_m = malloc(n * sizeof *f->pattern_m);
    if (f->pattern_m == NULL) return orr_cursor_error(&r->c, why, ORR_E_MEMORY, 0, "no memory for a pattern");
    for (size_t i = 0; i <= a->n_azimuths; i++) {
        orr_view line;
        orr_status s;
        do s = next_line(r, &line, why);
        while (s == ORR_OK && orr_records_label_is(orr_records_label(line), "COMMENT"));
        if (s != ORR_OK) return s;
        orr_view name = orr_view_trim(orr_view_cols(line, 1, 8));
        double az;
        if (i == 0 ? !orr_view_equals(name, "NOAZI")
                   : orr_view_real(name, &az) != ORR_FIELD_OK ||
                         fabs(az - (double)(i - 1) * a->dazi_deg) > 0.051)
            return orr_cursor_error(&r->c, why, ORR_E_FORMAT, 1,
                                    "expected row %zu of %zu of the pattern (%s)", i + 1, a->n_azimuths + 1,
                                    i == 0 ? "NOAZI" : "its azimuth");
        s = read_row(r, a, line, f->pattern_m + i * a->n_zeniths, why);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

static orr_status read_offset(antex_reader *r, orr_view line, double out[3], orr_diag *why)
{
    for (int i = 0; i < 3; i++) {
        double v;
        if (orr_field_real(line, 1 + 10 * i, 10, &v) != ORR_FIELD_OK)
            return bad(r, why, 1 + 10 * i, "NORTH / EAST / UP: a number is missing or malformed");
        out[i] = v * MM;
    }
    return ORR_OK;
}

// START OF FREQUENCY to END OF FREQUENCY.
static orr_status read_frequency(antex_reader *r, orr_antex_antenna *a, orr_view first, orr_diag *why)
{
    if (a->n_zeniths == 0) return bad(r, why, 61, "a frequency before ZEN1 / ZEN2 / DZEN");
    if (a->n_frequencies == ANTEX_MAX_FREQUENCIES)
        return orr_cursor_error(&r->c, why, ORR_E_FORMAT, 0, "more than %d frequencies",
                                ANTEX_MAX_FREQUENCIES);
    orr_antex_frequency *list = realloc(a->frequency, (a->n_frequencies + 1) * sizeof *list);
    if (list == NULL) return orr_cursor_error(&r->c, why, ORR_E_MEMORY, 0, "no memory for a frequency");
    a->frequency = list;
    orr_antex_frequency *f = &list[a->n_frequencies++];
    *f = (orr_antex_frequency){.offset_rms_m = {ORR_NAN, ORR_NAN, ORR_NAN}};
    orr_view_copy(orr_view_trim(orr_view_cols(first, 4, 3)), f->code, sizeof f->code);
    if (f->code[0] == '\0') return bad(r, why, 4, "a frequency without a code");
    for (size_t i = 0; i + 1 < a->n_frequencies; i++)
        if (strcmp(a->frequency[i].code, f->code) == 0) return bad(r, why, 4, "a frequency stands twice");
    for (;;) {
        orr_view line;
        orr_status s = next_line(r, &line, why);
        if (s != ORR_OK) return s;
        orr_view label = orr_records_label(line);
        if (orr_records_label_is(label, "NORTH / EAST / UP")) {
            if (f->pattern_m != NULL) return bad(r, why, 61, "a second NORTH / EAST / UP in one frequency");
            s = read_offset(r, line, f->offset_m, why);
            if (s == ORR_OK) s = read_pattern(r, a, f, why);
            if (s != ORR_OK) return s;
        } else if (orr_records_label_is(label, "END OF FREQUENCY")) {
            return f->pattern_m != NULL ? ORR_OK : bad(r, why, 61, "a frequency without NORTH / EAST / UP");
        } else if (!orr_records_label_is(label, "COMMENT")) {
            r->at_end_of_antenna = orr_records_label_is(label, "END OF ANTENNA");
            return bad(r, why, 61, "a line that does not belong into a frequency");
        }
    }
}

// START OF FREQ RMS to END OF FREQ RMS: the uncertainty of the offset is kept, the pattern's is not.
static orr_status read_rms(antex_reader *r, orr_antex_antenna *a, orr_view first, orr_diag *why)
{
    char code[4];
    orr_view_copy(orr_view_trim(orr_view_cols(first, 4, 3)), code, sizeof code);
    orr_antex_frequency *f = NULL;
    for (size_t i = 0; i < a->n_frequencies; i++)
        if (strcmp(a->frequency[i].code, code) == 0) f = &a->frequency[i];
    for (;;) {
        orr_view line;
        orr_status s = next_line(r, &line, why);
        if (s != ORR_OK) return s;
        orr_view label = orr_records_label(line);
        double ignored[3];
        if (orr_records_label_is(label, "NORTH / EAST / UP"))
            s = read_offset(r, line, f != NULL ? f->offset_rms_m : ignored, why);
        else if (orr_records_label_is(label, "END OF FREQ RMS"))
            return ORR_OK;
        else if ((r->at_end_of_antenna = orr_records_label_is(label, "END OF ANTENNA")))
            s = bad(r, why, 61, "a START OF FREQ RMS without its end");
        if (s != ORR_OK) return s;
    }
}

static orr_status read_validity(antex_reader *r, orr_view line, orr_time *out, orr_diag *why)
{
    return orr_records_civil(orr_view_cols(line, 1, 43), ORR_SCALE_GPS, NULL, out)
               ? ORR_OK
               : bad(r, why, 1, "the end of a validity is no date");
}

static orr_status check(antex_reader *r, const orr_antex_antenna *a, int declared, orr_diag *why)
{
    r->at_end_of_antenna = true;
    if (a->type[0] == '\0') return bad(r, why, 61, "an antenna without TYPE / SERIAL NO");
    if (a->n_frequencies == 0) return bad(r, why, 61, "an antenna without frequencies");
    if (declared >= 0 && (size_t)declared != a->n_frequencies) // what is there can be used all the same
        orr_cursor_warn(&r->c, r->warnings, 61, "the antenna %s names %d frequencies and has %zu", a->type,
                        declared, a->n_frequencies);
    if (a->valid_from != ORR_TIME_NONE && a->valid_until != ORR_TIME_NONE && a->valid_until < a->valid_from)
        return bad(r, why, 61, "the antenna's validity ends before it starts");
    return ORR_OK;
}

orr_status antex_read_antenna(antex_reader *r, orr_antex_antenna *a, orr_diag *why)
{
    *a = (orr_antex_antenna){.valid_from = ORR_TIME_NONE, .valid_until = ORR_TIME_NONE};
    r->at_end_of_antenna = r->ended = false;
    int declared = -1;
    orr_status s = ORR_OK;
    while (s == ORR_OK) {
        orr_view line;
        s = next_line(r, &line, why);
        if (s != ORR_OK) return s;
        orr_view label = orr_records_label(line);
        if (orr_records_label_is(label, "COMMENT") || orr_view_is_blank(line) ||
            orr_records_label_is(label, "METH / BY / # / DATE"))
            continue;
        if (orr_records_label_is(label, "TYPE / SERIAL NO")) {
            s = read_type(r, a, line, why);
        } else if (orr_records_label_is(label, "DAZI")) {
            s = a->n_frequencies > 0 ? bad(r, why, 61, "DAZI behind a frequency")
                                     : read_dazi(r, a, line, why);
        } else if (orr_records_label_is(label, "ZEN1 / ZEN2 / DZEN")) {
            s = a->n_frequencies > 0 ? bad(r, why, 61, "ZEN1 / ZEN2 / DZEN behind a frequency")
                                     : read_grid(r, a, line, why);
        } else if (orr_records_label_is(label, "# OF FREQUENCIES")) {
            if (orr_field_int_in(line, 1, 6, 1, ANTEX_MAX_FREQUENCIES, &declared) != ORR_FIELD_OK)
                s = bad(r, why, 1, "the number of frequencies is no number");
        } else if (orr_records_label_is(label, "VALID FROM")) {
            s = read_validity(r, line, &a->valid_from, why);
        } else if (orr_records_label_is(label, "VALID UNTIL")) {
            s = read_validity(r, line, &a->valid_until, why);
        } else if (orr_records_label_is(label, "SINEX CODE")) {
            orr_view_copy(orr_view_trim(orr_view_cols(line, 1, 10)), a->sinex_code, sizeof a->sinex_code);
        } else if (orr_records_label_is(label, "START OF FREQUENCY")) {
            s = read_frequency(r, a, line, why);
        } else if (orr_records_label_is(label, "START OF FREQ RMS")) {
            s = read_rms(r, a, line, why);
        } else if (orr_records_label_is(label, "END OF ANTENNA")) {
            return check(r, a, declared, why);
        } else if (orr_records_label_is(label, "START OF ANTENNA")) {
            // A lost END OF ANTENNA: there is no telling which lines belong to which.
            return bad(r, why, 61, "an antenna starts inside another one");
        } else {
            char shown[24];
            return orr_cursor_error(&r->c, why, ORR_E_FORMAT, 61, "\"%s\" is no label of an antenna",
                                    orr_view_copy(label, shown, sizeof shown));
        }
    }
    return s;
}

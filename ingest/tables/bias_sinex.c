// SPDX-License-Identifier: GPL-3.0-or-later
// Bias-SINEX 1.00: fixed columns. " OSB  G063 G01           C1C       2024:035:00000 2024:036:00000
// ns   9.5198 0.0001"
#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/tables/bias_private.h"

static orr_status header(bias_reader *r, orr_view line)
{
    orr_bias_set *x = r->out;
    strcpy(x->format, "BIAS-SINEX");
    if (orr_field_real(line, 7, 4, &x->version) != ORR_FIELD_OK)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 7, "the Bias-SINEX version is no number");
    if (!(x->version >= 0.0 && x->version < 2.0))
        return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 7,
                                "Bias-SINEX version %.2f is not known (1.00 is)", x->version);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 12, 3)), x->agency, sizeof x->agency);
    // "%=BIA 1.00 COD 2024:040:29169 IGS 2024:035:00000 2024:036:00000 A 00014361"; 0.01 had years of two
    // digits.
    orr_view rest = orr_view_cols(line, 6, (int)ORR_LINE_MAX), word[9];
    int n = 0;
    while (n < 9 && orr_view_word(&rest, &word[n])) n++;
    if (n < 7 || !orr_records_sinex_time(word[4], ORR_SCALE_GPS, NULL, &x->from) ||
        !orr_records_sinex_time(word[5], ORR_SCALE_GPS, NULL, &x->until))
        orr_cursor_warn(&r->c, r->warnings, 1, "the first line does not tell the span of the data");
    x->absolute = n >= 7 && word[6].p[0] == 'A';
    return ORR_OK;
}

static void description(bias_reader *r, orr_view line)
{
    orr_view rest = line, key, value;
    if (!orr_view_word(&rest, &key) || !orr_view_word(&rest, &value)) return;
    if (orr_view_equals(key, "BIAS_MODE")) {
        r->out->absolute = orr_view_equals(value, "ABSOLUTE");
    } else if (orr_view_equals(key, "TIME_SYSTEM")) {
        static const struct {
            const char *word;
            orr_scale scale;
        } known[] = {{"G", ORR_SCALE_GPS}, {"R", ORR_SCALE_GLO}, {"E", ORR_SCALE_GAL}, {"C", ORR_SCALE_BDT},
                     {"J", ORR_SCALE_QZS}, {"I", ORR_SCALE_IRN}, {"T", ORR_SCALE_TAI}, {"U", ORR_SCALE_UTC}};
        bool found = false;
        for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
            if (orr_view_equals(value, known[i].word)) r->out->scale = known[i].scale, found = true;
        if (!found && orr_scale_parse(value.p, value.n, &r->out->scale) != ORR_OK)
            orr_cursor_warn(&r->c, r->warnings, 1, "TIME_SYSTEM is not known; GPS is taken");
    }
}

// Some centres write the standard deviation in twelve characters, columns 93-104, and what follows a column further
// right: behind the value the numbers are then read as words. 0, or the column of what is no such number.
static int wide_numbers(orr_view line, double factor, double *const to[3])
{
    orr_view rest = orr_view_cols(line, 93, (int)ORR_LINE_MAX), word;
    for (int i = 0; orr_view_word(&rest, &word); i++) {
        int column = (int)(word.p - line.p) + 1;
        double v;
        // The first fills its twelve columns; the others begin at 106 and 128, or in front of that by their sign.
        bool placed = i == 0 ? column == 93 && word.n == 12
                             : i < 3 && column >= (i == 1 ? 106 : 128) && column <= (i == 1 ? 127 : 139);
        if (!placed || orr_view_real(word, &v) != ORR_FIELD_OK) return column;
        *to[i] = v * factor;
    }
    return 0;
}

static orr_status solution(bias_reader *r, orr_view line)
{
    static const struct {
        const char *word;
        orr_bias_kind kind;
    } kinds[] = {{"OSB", ORR_BIAS_OSB}, {"DSB", ORR_BIAS_DSB}, {"DCB", ORR_BIAS_DSB}, {"ISB", ORR_BIAS_ISB}};
    orr_bias b = {.sdev_s = ORR_NAN, .slope_sps = ORR_NAN, .slope_sdev_sps = ORR_NAN};
    orr_view word = orr_view_trim(orr_view_cols(line, 2, 4));
    bool known = false;
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (orr_view_equals(word, kinds[i].word)) b.kind = kinds[i].kind, known = true;
    if (!known) return bias_leave_out(r, 2, "a bias that is none of OSB, DSB, ISB");

    orr_view_copy(orr_view_trim(orr_view_cols(line, 7, 4)), b.svn, sizeof b.svn);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 16, 9)), b.station, sizeof b.station);
    orr_view prn = orr_view_trim(orr_view_cols(line, 12, 3));
    if (prn.n == 3) {
        b.sat = orr_sat_parse3(prn.p, 0);
        if (b.sat == ORR_SAT_NONE) return bias_leave_out(r, 12, "a bias of no known satellite");
        b.system = orr_sat_system(b.sat);
    } else if (prn.n == 1) { // a station's bias of a whole system
        b.system = prn.p[0];
    } else if (prn.n == 0 && b.svn[0] != '\0') {
        b.system = b.svn[0];
    }
    if (b.sat == ORR_SAT_NONE &&
        (b.station[0] == '\0' || b.system == '\0' || strchr(ORR_SYSTEMS, b.system) == NULL))
        return bias_leave_out(r, 12, "a bias of neither a satellite nor a station");

    orr_view obs[2] = {orr_view_trim(orr_view_cols(line, 26, 4)), orr_view_trim(orr_view_cols(line, 31, 4))};
    for (int i = 0; i < 2; i++)
        if (obs[i].n > 3 || (obs[i].n == 0) != (i == 1 && b.kind == ORR_BIAS_OSB))
            return bias_leave_out(r, 26 + 5 * i, "an observable is missing, too long or one too many");
    orr_view_copy(obs[0], b.obs1, sizeof b.obs1);
    orr_view_copy(obs[1], b.obs2, sizeof b.obs2);

    if (!orr_records_sinex_time(orr_view_cols(line, 36, 14), r->out->scale, r->limits.leap, &b.from) ||
        !orr_records_sinex_time(orr_view_cols(line, 51, 14), r->out->scale, r->limits.leap, &b.until))
        return bias_leave_out(r, 36, "the validity of a bias is no pair of dates");
    if (b.from != ORR_TIME_NONE && b.until != ORR_TIME_NONE && b.until < b.from)
        return bias_leave_out(r, 51, "the validity of a bias ends before it starts");

    orr_view unit = orr_view_trim(orr_view_cols(line, 66, 4));
    double factor = 1e-9;
    if (orr_view_equals(unit, "cyc"))
        b.in_cycles = true, factor = 1;
    else if (!orr_view_equals(unit, "ns"))
        return bias_leave_out(r, 66, "the unit of a bias is neither ns nor cyc");
    // A number that reaches over its columns would read as another number.
    static const int between[] = {35, 50, 65, 70, 92, 104, 126, 138};
    const bool wide = orr_view_char(line, 104) != ' ';
    for (size_t i = 0; i < (wide ? 5 : sizeof between / sizeof between[0]); i++)
        if (orr_view_char(line, between[i]) != ' ')
            return bias_leave_out(r, between[i], "fields are not in their columns");
    double v;
    if (orr_field_real(line, 71, 21, &v) != ORR_FIELD_OK)
        return bias_leave_out(r, 71, "the value of a bias is no number");
    b.value_s = v * factor;
    double *more[3] = {&b.sdev_s, &b.slope_sps, &b.slope_sdev_sps};
    if (wide) {
        int bad = wide_numbers(line, factor, more);
        return bad != 0 ? bias_leave_out(r, bad, "fields are not in their columns") : bias_add(r, &b);
    }
    static const int column[3] = {93, 105, 127}, width[3] = {11, 21, 11};
    for (int i = 0; i < 3; i++) {
        orr_field got = orr_field_real(line, column[i], width[i], &v);
        if (got == ORR_FIELD_BAD)
            return bias_leave_out(r, column[i], "a number behind the value of a bias is malformed");
        if (got == ORR_FIELD_OK) *more[i] = v * factor;
    }
    return bias_add(r, &b);
}

orr_status bias_read_sinex(bias_reader *r, orr_view first)
{
    enum { OTHER, DESCRIPTION, SOLUTION } block = OTHER;
    bool ended = false;
    orr_view line;
    orr_status s = header(r, first);
    while (s == ORR_OK && !ended && orr_cursor_next(&r->c, &line)) {
        switch (orr_view_char(line, 1)) {
        case '+':
            block = orr_view_starts(line, "+BIAS/DESCRIPTION") ? DESCRIPTION
                    : orr_view_starts(line, "+BIAS/SOLUTION")  ? SOLUTION
                                                               : OTHER;
            break;
        case '-':
            block = OTHER;
            break;
        case '%':
            ended = orr_view_starts(line, "%=END");
            break;
        case '*':
            break;
        default:
            if (orr_view_is_blank(line)) break;
            if (block == DESCRIPTION) description(r, line);
            if (block == SOLUTION) s = solution(r, line);
        }
    }
    if (s == ORR_OK) s = orr_cursor_status(&r->c, r->diag);
    if (s == ORR_OK && block == SOLUTION)
        s = orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                             "the file ends inside BIAS/SOLUTION: it is cut short");
    if (s == ORR_OK && !ended) orr_cursor_warn(&r->c, r->warnings, 0, "the file ends without %%=ENDBIA");
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The epochs and records of an SP3 file. One pass; a number in its usual place (F14.6) is read by its digits,
// so that a value is rounded once: km with six decimals are whole millimetres, microseconds are whole
// picoseconds.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/digits.h"
#include "core/nan.h"
#include "ingest/sp3/sp3_private.h"

#define EVERY_BYTE(b) (UINT64_C(0x0101010101010101) * (b))

// Reads F14.6 as written: blanks, perhaps a minus, digits, a point in the eighth place, six digits. *v is in
// units of 1e-6. Of the loaded characters a minus is 0x1d.
static inline bool read_f14_6(const char *s, int64_t *v)
{
    if (s[7] != '.') return false;
    uint64_t whole = orr_digits_load(s), part = orr_digits_load(s + 6) >> 16 << 16;
    // All bits of the bytes before the first digit, at most seven. No branch: the lengths of numbers are
    // random.
    uint64_t digit = (~whole & EVERY_BYTE(0x10)) | UINT64_C(0x10) << 56;
    uint64_t before = ((digit & (~digit + 1)) >> 4) - 1;
    uint64_t odd =
        (whole ^ EVERY_BYTE(0x10)) & before; // what is no blank there: a minus, as its last character
    bool minus = odd != 0, sound = odd == (((before >> 8) + 1) & before) * (minus ? 0x0d : 0);
    whole = (whole & ~before) << 8; // seven digits behind an empty byte; the point falls out
    int64_t m = (int64_t)orr_digits_value(whole) * 1000000 + orr_digits_value(part);
    *v = minus ? -m : m;
    return sound && orr_digits_all(whole) && orr_digits_all(part);
}

// A field of four: number * 10^power. ORR_FIELD_BLANK leaves *out alone. *free is set where it stands
// elsewhere.
static inline orr_field read_value(orr_view line, int col, double per_unit, int power, double *out,
                                   bool *free)
{
    int64_t v;
    if (line.n >= (size_t)col + 13 && read_f14_6(line.p + col - 1, &v)) {
        *out = (double)v / per_unit; // both exact, one rounding
        return ORR_FIELD_OK;
    }
    *free = true;
    orr_view field = orr_view_cols(line, col, 14);
    for (size_t i = 0; i < field.n; i++)
        if ((field.p[i] | 0x20) >= 'a') return ORR_FIELD_BAD; // an F field has no exponent
    return orr_view_real_e(field, power, out);
}

// Whether all these columns are blank.
static bool all_blank(orr_view line, const int *column, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (orr_view_char(line, column[i]) != ' ') return false;
    return true;
}

static void report_bad(sp3_parser *p, int column, const char *what)
{
    if (p->n_bad++ == 0) orr_diag_at(&p->first_bad, ORR_E_FORMAT, p->c.name, p->c.line, column, "%s", what);
    orr_cursor_warn(&p->c, p->warnings, column, "%s; left out", what);
}

// Exponents in columns 62-69 (three of two digits) and 71-73.
static void read_exponents(sp3_parser *p, orr_view line, float *xyz, float xyz_unit, float *clock,
                           float clock_unit)
{
    static const int between[] = {61, 64, 67, 70, 74, 77, 78};
    if (!all_blank(line, between, sizeof between / sizeof *between)) sp3_fault_note(p, SP3_BETWEEN);
    for (int i = 0; i < 4; i++) {
        int col = 62 + 3 * i, width = i < 3 ? 2 : 3, n = 0;
        switch (orr_field_int_in(line, col, width, -99, i < 3 ? 99 : 999, &n)) {
        case ORR_FIELD_BLANK:
            continue;
        case ORR_FIELD_BAD:
            sp3_fault_note(p, SP3_ODD_SDEV);
            continue;
        case ORR_FIELD_OK:
            break;
        }
        // Integers end in the last column of their field; a blank there is a digit that was lost.
        if (orr_view_char(line, col + width - 1) == ' ') sp3_fault_note(p, SP3_BETWEEN);
        double base = i < 3 ? p->out->pos_vel_base : p->out->clock_base;
        if (!(base > 0)) sp3_fault_note(p, SP3_NO_BASE);
        float value = n < 0   ? base > 0 ? (float)pow(base, n) : NAN
                      : i < 3 ? p->pos_sdev[n]
                              : p->clock_sdev[n];
        if (i < 3)
            xyz[i] = value * xyz_unit;
        else
            *clock = value * clock_unit;
    }
}

static uint8_t read_flags(sp3_parser *p, orr_view line)
{
    static const struct {
        int col;
        char letter;
        uint8_t flag;
    } flags[] = {{75, 'E', ORR_SP3_CLOCK_EVENT},
                 {76, 'P', ORR_SP3_CLOCK_PREDICTED},
                 {79, 'M', ORR_SP3_MANOEUVRE},
                 {80, 'P', ORR_SP3_ORBIT_PREDICTED}};
    uint8_t set = 0;
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++) {
        char c = orr_view_char(line, flags[i].col);
        if (c == flags[i].letter)
            set |= flags[i].flag;
        else if (c != ' ')
            sp3_fault_note(p, SP3_ODD_FLAG);
    }
    return set;
}

// The satellite of a record; -1 where the line is left out (*st ORR_OK) or reading ends (*st not ORR_OK).
static int record_sat(sp3_parser *p, orr_view line, orr_status *st)
{
    *st = ORR_OK;
    char three[3] = {orr_view_char(line, 2), orr_view_char(line, 3), orr_view_char(line, 4)};
    orr_sat sat = orr_sat_parse3(three, 'G');
    if (sat == ORR_SAT_NONE && sp3_is_sat_like(three)) {
        sp3_fault_note(p, SP3_UNKNOWN_SAT);
        return -1;
    }
    if (sat == ORR_SAT_NONE) {
        report_bad(p, 2, "the satellite of this record cannot be read");
        return -1;
    }
    if (three[0] == ' ' && p->out->version >= 'c') sp3_fault_note(p, SP3_BLANK_SYSTEM);
    size_t known = p->out->n_sats;
    int index = sp3_sat_index(p, sat, st);
    if (index >= 0 && p->out->n_sats > known && p->header_sats_line != 0) sp3_fault_note(p, SP3_UNLISTED);
    return index;
}

// The three components and the clock; false where the line was reported and is to be left out.
static bool read_four(sp3_parser *p, orr_view line, double per_unit, int power, double per_clock,
                      int clock_power, double xyz[3], double *clock)
{
    bool free = false, free_clock = false;
    for (int i = 0; i < 3; i++) {
        orr_field f = read_value(line, 5 + 14 * i, per_unit, power, &xyz[i], &free);
        if (f != ORR_FIELD_OK) {
            report_bad(p, 5 + 14 * i,
                       f == ORR_FIELD_BLANK ? "a coordinate is missing" : "a coordinate cannot be read");
            return false;
        }
    }
    if (xyz[0] == 0 && xyz[1] == 0 && xyz[2] == 0) {
        xyz[0] = xyz[1] = xyz[2] = ORR_NAN;
        free = false; // a missing position is missing however many noughts it has
    }
    orr_field f = read_value(line, 47, per_clock, clock_power, clock, &free_clock);
    // Numbers above the word for "none" would be clocks of a second and more: not of any satellite.
    if (f == ORR_FIELD_BAD || (f == ORR_FIELD_OK && fabs(*clock) * per_clock >= 1e12)) {
        report_bad(p, 47, "the clock cannot be read");
        return false;
    }
    // "999999." is allowed, and no clock at all; any other number elsewhere than the file's own columns means
    // that a character was lost or gained, and with it perhaps a digit.
    free = free || (free_clock && f == ORR_FIELD_OK && fabs(*clock) * per_clock < 999999e6);
    if (!p->has_style) {
        p->has_style = true;
        p->in_columns = !free;
    }
    if (free && p->in_columns) {
        report_bad(p, 5, "numbers are not in their columns (a character lost or gained?)");
        return false;
    }
    if (free) sp3_fault_note(p, SP3_FREE);
    // Six nines before the point mean "none", whatever stands behind it; and a satellite that is not there at
    // all is zeros throughout in files of version a.
    if (fabs(*clock) * per_clock >= 999999e6 || (isnan(xyz[0]) && *clock == 0)) *clock = ORR_NAN;
    return true;
}

static orr_status read_position(sp3_parser *p, orr_view line)
{
    orr_status st;
    p->last_sat = -1;
    int sat = record_sat(p, line, &st);
    if (sat < 0) return st;
    orr_sp3_record *r = &p->row[sat];
    if ((r->flags & SP3_SEEN_P) != 0) {
        sp3_fault_note(p, SP3_DUPLICATE);
        return ORR_OK;
    }
    double pos[3] = {0}, clock = ORR_NAN;
    if (!read_four(p, line, 1e3, 3, 1e12, -6, pos, &clock)) return ORR_OK;
    double r2 = pos[0] * pos[0] + pos[1] * pos[1] + pos[2] * pos[2];
    if (r2 < 6.3e6 * 6.3e6 || r2 > 1e9 * 1e9) sp3_fault_note(p, SP3_IMPLAUSIBLE);
    memcpy(r->pos_m, pos, sizeof pos);
    r->clock_s = clock;
    r->flags |= SP3_SEEN_P;
    if (line.n > 60) {
        read_exponents(p, line, r->pos_sdev_m, 1e-3f, &r->clock_sdev_s, 1e-12f);
        r->flags |= read_flags(p, line);
        if (line.n > 80 && !orr_view_is_blank(orr_view_cols(line, 81, 1 << 20))) sp3_fault_note(p, SP3_TAIL);
    }
    p->n_good++;
    p->last_sat = sat;
    p->last_is_velocity = false;
    return ORR_OK;
}

static orr_status read_velocity(sp3_parser *p, orr_view line)
{
    orr_status st;
    p->last_sat = -1;
    int sat = record_sat(p, line, &st);
    if (sat < 0) return st;
    orr_sp3_record *r = &p->row[sat];
    if ((r->flags & SP3_SEEN_V) != 0) {
        sp3_fault_note(p, SP3_DUPLICATE);
        return ORR_OK;
    }
    // dm/s with six decimals; 1e-4 us/s with six decimals.
    double vel[3] = {0}, rate = ORR_NAN;
    if (!read_four(p, line, 1e7, -1, 1e16, -10, vel, &rate)) return ORR_OK;
    memcpy(r->vel_mps, vel, sizeof vel);
    r->clock_rate_sps = rate;
    r->flags |= SP3_SEEN_V;
    if (line.n > 60) read_exponents(p, line, r->vel_sdev_mps, 1e-7f, &r->clock_rate_sdev_sps, 1e-16f);
    p->out->has_velocity = p->seen_velocity = true;
    p->n_good++;
    p->last_sat = sat;
    p->last_is_velocity = true;
    return ORR_OK;
}

// EP and EV: four standard deviations (9999, 9999999: too large) and six correlations in units of 1e-7.
static orr_status read_correlations(sp3_parser *p, orr_view line)
{
    bool velocity = line.p[1] == 'V';
    if (p->last_sat < 0 || p->last_is_velocity != velocity) {
        sp3_fault_note(p, SP3_STRAY_EP);
        return ORR_OK;
    }
    orr_sp3 *o = p->out;
    if (o->correlation == NULL) {
        orr_status st = sp3_add_correlations(p);
        if (st != ORR_OK) return st;
    }
    orr_sp3_record *r = &p->row[p->last_sat];
    orr_sp3_correlation *c = &o->correlation[(size_t)(p->row - o->record) + (size_t)p->last_sat];
    static const int sdev_col[4] = {5, 10, 15, 20}, corr_col[6] = {28, 37, 46, 55, 64, 73};
    float sdev[4], *corr = velocity ? c->v : c->p;
    static const int between[] = {3, 4, 9, 14, 19, 27, 36, 45, 54, 63, 72};
    if (!all_blank(line, between, sizeof between / sizeof *between)) sp3_fault_note(p, SP3_BETWEEN);
    for (int i = 0; i < 4; i++) {
        int n = 0, most = i < 3 ? 9999 : 9999999;
        orr_field f = orr_field_int_in(line, sdev_col[i], i < 3 ? 4 : 7, 0, most, &n);
        if (f == ORR_FIELD_BAD) sp3_fault_note(p, SP3_ODD_SDEV);
        sdev[i] = f != ORR_FIELD_OK ? NAN : n == most ? INFINITY : (float)n;
    }
    for (int i = 0; i < 6; i++) {
        int n = 0;
        orr_field f = orr_field_int_in(line, corr_col[i], 8, -10000000, 10000000, &n);
        if (f == ORR_FIELD_BAD) sp3_fault_note(p, SP3_ODD_SDEV);
        if (f == ORR_FIELD_OK) corr[i] = (float)(n * 1e-7);
    }
    // What EP tells is finer than the exponents of P; what it leaves blank it does not take away.
    float *to = velocity ? r->vel_sdev_mps : r->pos_sdev_m;
    for (int i = 0; i < 3; i++)
        if (!isnan(sdev[i])) to[i] = (float)((double)sdev[i] / (velocity ? 1e7 : 1e3));
    if (!isnan(sdev[3])) {
        if (velocity)
            r->clock_rate_sdev_sps = (float)((double)sdev[3] / 1e16);
        else
            r->clock_sdev_s = (float)((double)sdev[3] / 1e12);
    }
    return ORR_OK;
}

// What an epoch line says, with its fields so many columns further right than the format has them.
typedef struct epoch_date {
    orr_time t;
    int column; // to blame where it says nothing
    bool minute60, day0;
} epoch_date;

static bool read_date(const sp3_parser *p, orr_view line, int shift, epoch_date *d)
{
    const orr_sp3 *o = p->out;
    orr_civil civil;
    if (!sp3_read_civil(line, shift, true, &civil, &d->column)) return false;
    d->column = 4 + shift;
    d->day0 = civil.day == 0;
    d->minute60 = civil.minute == 60;
    if (d->day0) civil.day = 1;
    if (d->minute60) { // a centre that counts up minutes: 16:60 can only mean 17:00
        civil.minute = 0;
        civil.hour++;
    }
    if (orr_time_from_civil(&civil, o->scale, p->limits.leap, &d->t) != ORR_OK) return false;
    if (!d->day0) return true;
    // The day before the first of a month, where that goes on from the epoch before.
    d->t -= ORR_S_PER_DAY * ORR_NS_PER_S;
    d->column = 12 + shift;
    if (o->n_epochs == 0) return false;
    double step_s = orr_time_diff_s(d->t, o->epoch[o->n_epochs - 1]);
    return step_s > 0 && step_s <= ORR_S_PER_DAY;
}

// A line whose fields stand a column off is read in a file whose first epoch line stands so, and where it is the epoch
// that is due.
static bool find_date(sp3_parser *p, orr_view line, epoch_date *d)
{
    const orr_sp3 *o = p->out;
    if (read_date(p, line, p->epoch_shift, d)) {
        if (p->epoch_shift != 0) sp3_fault_note(p, SP3_SHIFTED);
        return true;
    }
    for (int shift = -1; shift <= 1; shift++) {
        epoch_date other = {0};
        if (!read_date(p, line, shift, &other)) continue;
        bool first = o->n_epochs == 0 && p->n_bad == 0;
        if (!first && (o->n_epochs == 0 || o->interval_s <= 0 ||
                       orr_time_diff_s(other.t, o->epoch[o->n_epochs - 1]) != o->interval_s))
            continue;
        if (first) p->epoch_shift = shift;
        sp3_fault_note(p, SP3_SHIFTED);
        *d = other;
        return true;
    }
    return false;
}

static orr_status read_epoch(sp3_parser *p, orr_view line)
{
    epoch_date d = {0};
    p->last_sat = -1;
    if (find_date(p, line, &d)) {
        if (d.minute60) sp3_fault_note(p, SP3_MINUTE_60);
        if (d.day0) sp3_fault_note(p, SP3_DAY_0);
        return sp3_add_epoch(p, d.t);
    }
    report_bad(p, d.column, "this epoch is no date and time; its records cannot be placed");
    p->row = NULL;
    return ORR_OK;
}

// A line that begins like none of the format.
static orr_status read_other(sp3_parser *p, orr_view line)
{
    if (orr_view_starts(line, "/*")) return sp3_read_comment(p, line);
    if (line.n > 2 && line.p[0] == '#' && line.p[1] >= 'a' && line.p[1] <= 'z')
        return orr_cursor_error(&p->c, p->diag, ORR_E_FORMAT, 1,
                                "a second header: two files in one? Give them separately");
    bool says_something = false;
    for (size_t i = 0; i < line.n; i++) {
        unsigned char ch = (unsigned char)line.p[i];
        says_something = says_something || (ch >= '0' && ch <= '9') ||
                         ((ch | 0x20) >= 'a' && (ch | 0x20) <= 'z') || ch >= 0x80;
    }
    if (!says_something) {
        sp3_fault_note(p, SP3_JUNK);
        return ORR_OK;
    }
    // This may have been the next epoch line: what follows up to the next one has no certain time.
    report_bad(p, 1,
               "this line begins like none of an SP3 file; it and the records up to the next epoch cannot be "
               "placed");
    p->row = NULL;
    p->last_sat = -1;
    return ORR_OK;
}

static orr_status read_after_end(sp3_parser *p)
{
    orr_view line;
    size_t n = 0;
    while (orr_cursor_next(&p->c, &line)) {
        if (orr_view_is_blank(line) || (line.n == 1 && line.p[0] == 0x1a))
            continue; // DOS ends a text with ^Z
        if (line.n > 2 && line.p[0] == '#' && line.p[1] >= 'a' && line.p[1] <= 'd')
            return orr_cursor_error(&p->c, p->diag, ORR_E_FORMAT, 1,
                                    "a second header after EOF: two files in one? Give them separately");
        if (n++ == 0) orr_cursor_warn(&p->c, p->warnings, 1, "there is text after EOF, which is not read");
    }
    return ORR_OK;
}

orr_status sp3_parse_body(sp3_parser *p, orr_view line)
{
    orr_status st = read_epoch(p, line);
    while (st == ORR_OK && orr_cursor_next(&p->c, &line)) {
        char first = line.n > 1 ? line.p[0] : ' ', second = line.n > 1 ? line.p[1] : ' ';
        if (line.n >= 3 && memcmp(line.p, "EOF", 3) == 0) {
            p->ended = true;
            return read_after_end(p);
        }
        if (p->c.unterminated && !orr_view_is_blank(line) && line.p[0] != 0x1a) {
            orr_cursor_warn(&p->c, p->warnings, 0,
                            "the file ends inside this line; it may be cut, so the line is left out");
            return ORR_OK;
        }
        bool record = first == 'P' || first == 'V' || (first == 'E' && (second == 'P' || second == 'V'));
        if (record && p->row == NULL)
            sp3_fault_note(p, SP3_STRAY_RECORD);
        else if (first == 'P')
            st = read_position(p, line);
        else if (first == 'V')
            st = read_velocity(p, line);
        else if (record)
            st = read_correlations(p, line);
        else if (first == '*' && (second == ' ' || second == '\t'))
            st = read_epoch(p, line);
        else
            st = read_other(p, line);
    }
    return st;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Writes SP3 a to d (layout: Hilla 2016; versions a and b end at column 60 unless there is more to say).
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "ingest/sp3/sp3.h"

typedef struct writer {
    const orr_sp3 *sp3;
    FILE *f;
    orr_diag *diag;
    double log_pos_base, log_clock_base; // NAN where the base gives no powers
} writer;

enum { IDS_A_LINE = 17, SHORT_COMMENT = 57, LONG_COMMENT = 77 };

static orr_status refuse(const writer *w, const char *what)
{
    return orr_diag_set(w->diag, ORR_E_ARG, "%s", what);
}

static const char *sat_id(const writer *w, orr_sat sat, char buf[ORR_SAT_TEXT])
{
    if (w->sp3->version != 'a') return orr_sat_text(sat, buf);
    snprintf(buf, ORR_SAT_TEXT, "%3d", orr_sat_number(sat));
    return buf;
}

static orr_status check(const writer *w)
{
    const orr_sp3 *o = w->sp3;
    if (o->version < 'a' || o->version > 'd') return refuse(w, "SP3 versions are a, b, c and d");
    if (o->n_sats == 0 || o->n_epochs == 0) return refuse(w, "an SP3 file needs a satellite and an epoch");
    if (o->version < 'd' && o->n_sats > 85)
        return refuse(w, "SP3 versions before d hold at most 85 satellites");
    if (o->n_sats > 999 || o->n_epochs > 9999999)
        return refuse(w, "more satellites or epochs than SP3 can number");
    if (o->version == 'a' && o->scale != ORR_SCALE_GPS) return refuse(w, "SP3-a is in GPS time always");
    if (o->scale == ORR_SCALE_TT) return refuse(w, "SP3 has no word for Terrestrial Time");
    if (o->version < 'c' && o->correlation != NULL) return refuse(w, "EP and EV records need SP3-c or d");
    for (size_t s = 0; s < o->n_sats; s++) {
        if (o->sat[s] == ORR_SAT_NONE) return refuse(w, "a satellite without a name");
        if (o->version == 'a' && orr_sat_system(o->sat[s]) != 'G')
            return refuse(w, "SP3-a holds GPS satellites alone");
    }
    for (size_t e = 0; e < o->n_epochs; e++) {
        if (e > 0 && o->epoch[e] <= o->epoch[e - 1]) return refuse(w, "epochs must ascend");
        if (o->epoch[e] % 10 != 0) return refuse(w, "SP3 writes epochs to 10 ns; one is finer");
    }
    size_t longest = o->version == 'd' ? LONG_COMMENT : SHORT_COMMENT;
    if (o->version < 'd' && o->n_comments > 4)
        return refuse(w, "SP3 versions before d hold four comment lines");
    for (size_t i = 0; i < o->n_comments; i++) {
        if (strlen(o->comment[i]) > longest)
            return orr_diag_set(w->diag, ORR_E_ARG,
                                "comment %zu is longer than %zu characters, SP3-%c's most", i + 1, longest,
                                o->version);
        if (strpbrk(o->comment[i], "\r\n") != NULL) return refuse(w, "a comment has a line end inside");
    }
    return ORR_OK;
}

// The smallest step between epochs, which the header wants even where nobody told one.
static double interval_of(const orr_sp3 *o)
{
    if (o->interval_s > 0) return o->interval_s;
    int64_t step = 0;
    for (size_t i = 1; i < o->n_epochs; i++)
        if (step == 0 || o->epoch[i] - o->epoch[i - 1] < step) step = o->epoch[i] - o->epoch[i - 1];
    return (double)step / 1e9;
}

static double seconds_of(const orr_civil *c) { return c->second + c->ns / 1e9; }

static orr_status write_start(const writer *w)
{
    const orr_sp3 *o = w->sp3;
    orr_civil c;
    orr_time_to_civil(o->epoch[0], o->scale, o->leap, &c);
    fprintf(w->f, "#%c%c%4d %2d %2d %2d %2d %11.8f %7zu %5.5s %5.5s %3.3s %4.4s\n", o->version,
            o->has_velocity ? 'V' : 'P', c.year, c.month, c.day, c.hour, c.minute, seconds_of(&c),
            o->n_epochs, o->data_used, o->coordinates, o->orbit_type, o->agency);
    // Week, seconds and MJD are of the same label, read as if it were GPS time.
    int32_t mjd = orr_mjd_from_date(c.year, c.month, c.day), days = mjd - orr_mjd_from_date(1980, 1, 6);
    double of_day = c.hour * 3600.0 + c.minute * 60.0 + seconds_of(&c);
    if (days < 0 || days / 7 > 9999) return refuse(w, "the first epoch has no GPS week of four digits");
    fprintf(w->f, "## %4d %15.8f %14.8f %5d %15.13f\n", days / 7, days % 7 * 86400.0 + of_day, interval_of(o),
            mjd, of_day / 86400);
    return ORR_OK;
}

static void write_lists(const writer *w)
{
    const orr_sp3 *o = w->sp3;
    size_t lines = (o->n_sats + IDS_A_LINE - 1) / IDS_A_LINE;
    if (lines < 5) lines = 5;
    char id[ORR_SAT_TEXT];
    for (size_t l = 0, s = 0; l < lines; l++) {
        if (l == 0)
            fprintf(w->f, "+  %3zu   ", o->n_sats);
        else
            fputs("+        ", w->f);
        for (int i = 0; i < IDS_A_LINE; i++, s++)
            fputs(s < o->n_sats ? sat_id(w, o->sat[s], id) : "  0", w->f);
        fputc('\n', w->f);
    }
    for (size_t l = 0, s = 0; l < lines; l++) {
        fputs("++       ", w->f);
        for (int i = 0; i < IDS_A_LINE; i++, s++)
            fprintf(w->f, "%3d", s < o->n_sats ? o->accuracy_exp[s] : 0);
        fputc('\n', w->f);
    }
}

static void write_types(const writer *w)
{
    const orr_sp3 *o = w->sp3;
    char type[4] = "cc";
    if (o->file_type[0] != '\0') {
        snprintf(type, sizeof type, "%.2s", o->file_type);
    } else if (o->version > 'a') {
        type[0] = orr_sat_system(o->sat[0]);
        type[1] = '\0';
        for (size_t s = 1; s < o->n_sats; s++)
            if (orr_sat_system(o->sat[s]) != type[0]) type[0] = 'M';
    }
    const char *rest = "ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc";
    fprintf(w->f, "%%c %-2s cc %.3s %s\n", type, o->version == 'a' ? "ccc" : orr_scale_name(o->scale), rest);
    fprintf(w->f, "%%c cc cc ccc %s\n", rest);
    fprintf(w->f, "%%f %10.7f %12.9f  0.00000000000  0.000000000000000\n", o->pos_vel_base, o->clock_base);
    fputs("%f  0.0000000  0.000000000  0.00000000000  0.000000000000000\n", w->f);
    for (int i = 0; i < 2; i++) fputs("%i    0    0    0    0      0      0      0      0         0\n", w->f);
    for (size_t i = 0; i < o->n_comments || i < 4; i++) {
        const char *text = i < o->n_comments ? o->comment[i] : "";
        fprintf(w->f, "/*%s%s\n", text[0] != '\0' ? " " : "", text);
    }
}

// The exponent of the power nearest to a standard deviation; false where there is none. *exact: it is that
// power.
static bool nearest_power(double sdev, double unit, double log_base, int most, int *n, bool *exact)
{
    if (!(sdev > 0) || isinf(sdev) || isnan(log_base)) return false;
    double e = log(sdev / unit) / log_base;
    if (!(e > -9.5)) e = -9;
    *n = e >= most ? most : (int)lround(e);
    *exact = *n < most && fabs(exp(*n * log_base) * unit / sdev - 1) < 1e-5;
    return true;
}

// Columns 61-73 into text; *exact is cleared where a value is not the power that was written for it.
static orr_status exponents(const writer *w, const float xyz[3], double unit, float clock, double clock_unit,
                            char text[16], bool *exact)
{
    memset(text, ' ', 13);
    text[13] = '\0';
    for (int i = 0; i < 4; i++) {
        double sdev = i < 3 ? (double)xyz[i] : (double)clock;
        int n = i < 3 ? 99 : 999, width = i < 3 ? 2 : 3;
        bool is_power = true;
        if (isnan(sdev)) continue;
        if (!isinf(sdev) && !nearest_power(sdev, i < 3 ? unit : clock_unit,
                                           i < 3 ? w->log_pos_base : w->log_clock_base, n, &n, &is_power))
            return refuse(
                w, "standard deviations are written as powers of the header's bases, which must be above 1");
        *exact = *exact && is_power;
        char digits[16];
        snprintf(digits, sizeof digits, "%*d", width, n);
        memcpy(text + 1 + 3 * i, digits, (size_t)width);
    }
    return ORR_OK;
}

static orr_status write_numbers(const writer *w, char kind, orr_sat sat, const double xyz[3], double unit,
                                double clock, double clock_unit)
{
    char id[ORR_SAT_TEXT];
    fprintf(w->f, "%c%s", kind, sat_id(w, sat, id));
    bool missing = isnan(xyz[0]) || isnan(xyz[1]) || isnan(xyz[2]);
    for (int i = 0; i < 3; i++) {
        // Whole units of the last decimal, so that what is printed is what is read.
        double v = missing ? 0 : rint(xyz[i] / unit);
        if (!(fabs(v) < 1e12)) return refuse(w, "a coordinate is wider than SP3's column");
        fprintf(w->f, "%14.6f", v / 1e6);
    }
    double v = isnan(clock) ? 999999999999.0 : rint(clock / clock_unit);
    if (!isnan(clock) && !(fabs(v) < 999999e6)) return refuse(w, "a clock is wider than SP3's column");
    fprintf(w->f, "%14.6f", v / 1e6);
    return ORR_OK;
}

static void write_integer_or_blank(FILE *f, double v, int width, int64_t most)
{
    if (isnan(v))
        fprintf(f, " %*s", width, "");
    else
        fprintf(f, " %*" PRId64, width, v >= (double)most ? most : (int64_t)llround(v));
}

// EP or EV.
static void write_correlations(const writer *w, char kind, const float sdev[3], double unit, float clock_sdev,
                               double clock_unit, const float corr[6])
{
    fprintf(w->f, "E%c ", kind);
    for (int i = 0; i < 3; i++) write_integer_or_blank(w->f, (double)sdev[i] / unit, 4, 9999);
    write_integer_or_blank(w->f, (double)clock_sdev / clock_unit, 7, 9999999);
    for (int i = 0; i < 6; i++) write_integer_or_blank(w->f, (double)corr[i] * 1e7, 8, 99999999);
    fputc('\n', w->f);
}

static bool any_number(const float v[6])
{
    for (int i = 0; i < 6; i++)
        if (!isnan(v[i])) return true;
    return false;
}

static void put_flags(FILE *f, char columns[24], uint8_t flags)
{
    memcpy(columns + 13, "       ", 8);
    if ((flags & ORR_SP3_CLOCK_EVENT) != 0) columns[14] = 'E';
    if ((flags & ORR_SP3_CLOCK_PREDICTED) != 0) columns[15] = 'P';
    if ((flags & ORR_SP3_MANOEUVRE) != 0) columns[18] = 'M';
    if ((flags & ORR_SP3_ORBIT_PREDICTED) != 0) columns[19] = 'P';
    size_t n = 20;
    while (n > 0 && columns[n - 1] == ' ') n--;
    fprintf(f, "%.*s\n", (int)n, columns);
}

static orr_status write_record(const writer *w, size_t cell, orr_sat sat)
{
    const orr_sp3 *o = w->sp3;
    const orr_sp3_record *r = &o->record[cell];
    const orr_sp3_correlation *c = o->correlation != NULL ? &o->correlation[cell] : NULL;
    char columns[24];
    bool exact = true;
    orr_status st = write_numbers(w, 'P', sat, r->pos_m, 1e-3, r->clock_s, 1e-12);
    if (st == ORR_OK) st = exponents(w, r->pos_sdev_m, 1e-3, r->clock_sdev_s, 1e-12, columns, &exact);
    if (st != ORR_OK) return st;
    put_flags(w->f, columns, r->flags);
    if (c != NULL && (!exact || any_number(c->p)))
        write_correlations(w, 'P', r->pos_sdev_m, 1e-3, r->clock_sdev_s, 1e-12, c->p);
    if (!o->has_velocity) return ORR_OK;
    exact = true;
    st = write_numbers(w, 'V', sat, r->vel_mps, 1e-7, r->clock_rate_sps, 1e-16);
    if (st == ORR_OK)
        st = exponents(w, r->vel_sdev_mps, 1e-7, r->clock_rate_sdev_sps, 1e-16, columns, &exact);
    if (st != ORR_OK) return st;
    put_flags(w->f, columns, 0);
    if (c != NULL && (!exact || any_number(c->v)))
        write_correlations(w, 'V', r->vel_sdev_mps, 1e-7, r->clock_rate_sdev_sps, 1e-16, c->v);
    return ORR_OK;
}

static orr_status write_all(const writer *w)
{
    const orr_sp3 *o = w->sp3;
    orr_status st = write_start(w);
    if (st != ORR_OK) return st;
    write_lists(w);
    write_types(w);
    for (size_t e = 0; e < o->n_epochs; e++) {
        orr_civil c;
        orr_time_to_civil(o->epoch[e], o->scale, o->leap, &c);
        fprintf(w->f, "*  %4d %2d %2d %2d %2d %11.8f\n", c.year, c.month, c.day, c.hour, c.minute,
                seconds_of(&c));
        for (size_t s = 0; s < o->n_sats; s++) {
            st = write_record(w, e * o->n_sats + s, o->sat[s]);
            if (st != ORR_OK) return st;
        }
    }
    fputs("EOF\n", w->f);
    return ORR_OK;
}

orr_status orr_sp3_print(const orr_sp3 *sp3, FILE *stream, orr_diag *diag)
{
    writer w = {.sp3 = sp3,
                .f = stream,
                .diag = diag,
                .log_pos_base = sp3->pos_vel_base > 1 ? log(sp3->pos_vel_base) : ORR_NAN,
                .log_clock_base = sp3->clock_base > 1 ? log(sp3->clock_base) : ORR_NAN};
    orr_status st = check(&w);
    return st == ORR_OK ? write_all(&w) : st;
}

orr_status orr_sp3_write(const orr_sp3 *sp3, const char *path, orr_diag *diag)
{
    orr_outfile f = {0};
    orr_status st = orr_outfile_open(path, &f, diag);
    if (st != ORR_OK) return st;
    st = orr_sp3_print(sp3, f.stream, diag);
    return orr_outfile_end(&f, st, diag);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// SINEX 2.02: fixed columns. Blocks that are not asked for are passed over line by line.
#include "ingest/tables/sinex.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"

#define S_PER_YEAR (365.25 * 86400.0)

typedef struct sinex_reader {
    orr_cursor c;
    orr_sinex *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    size_t last_estimate;
    orr_records_tally tally;
} sinex_reader;

void orr_sinex_free(orr_sinex *x)
{
    if (x == NULL) return;
    free(x->site);
    free(x->eccentricity);
    free(x->estimate);
    *x = (orr_sinex){0};
}

static orr_status bad(sinex_reader *r, int column, const char *what)
{
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, column, "%s", what);
}

static orr_status header(sinex_reader *r, orr_view line)
{
    orr_sinex *x = r->out;
    if (!orr_view_starts(line, "%=SNX"))
        return orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 1,
                                "not a SINEX file: the first line does not start with %%=SNX");
    if (orr_field_real(line, 7, 4, &x->version) != ORR_FIELD_OK)
        return bad(r, 7, "the SINEX version is no number");
    if (!(x->version >= 0.5 && x->version < 3.0))
        return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 7,
                                "SINEX version %.2f is not known (1.00 to 2.02 are)", x->version);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 12, 3)), x->agency, sizeof x->agency);
    // "%=SNX 2.02 IGN 24:053:83755 IGN 24:035:00000 24:036:00000 C  1484 2 S E"
    orr_view rest = orr_view_cols(line, 6, (int)ORR_LINE_MAX), word[6];
    int n = 0;
    while (n < 6 && orr_view_word(&rest, &word[n])) n++;
    if (n < 6 || !orr_records_sinex_time(word[4], ORR_SCALE_UTC, r->limits.leap, &x->from) ||
        !orr_records_sinex_time(word[5], ORR_SCALE_UTC, r->limits.leap, &x->until))
        orr_cursor_warn(&r->c, r->warnings, 33, "the first line does not tell the span of the data");
    return ORR_OK;
}

// Degrees, minutes, seconds: "199 31 23.7", "-19  1  5.9", also "-0 30 0.0" (the sign is the degrees').
static bool angle(orr_view v, double *deg)
{
    orr_view word;
    double f[3];
    bool negative = false;
    for (int i = 0; i < 3; i++) {
        if (!orr_view_word(&v, &word) || orr_view_real(word, &f[i]) != ORR_FIELD_OK) return false;
        if (i == 0) negative = word.p[0] == '-';
    }
    *deg = fabs(f[0]) + f[1] / 60 + f[2] / 3600;
    if (negative) *deg = -*deg;
    return true;
}

static void copy(orr_view line, int column, int width, char *out, size_t n)
{
    orr_view_copy(orr_view_trim(orr_view_cols(line, column, width)), out, n);
}

static orr_status site(sinex_reader *r, orr_view line)
{
    orr_sinex *x = r->out;
    orr_sinex_site s = {.lon_deg = ORR_NAN, .lat_deg = ORR_NAN, .height_m = ORR_NAN};
    copy(line, 2, 4, s.code, sizeof s.code);
    copy(line, 7, 2, s.point, sizeof s.point);
    copy(line, 10, 9, s.domes, sizeof s.domes);
    copy(line, 22, 22, s.description, sizeof s.description);
    if (s.code[0] == '\0') return bad(r, 2, "a site without a code");
    if (!angle(orr_view_cols(line, 45, 11), &s.lon_deg) || !angle(orr_view_cols(line, 57, 11), &s.lat_deg) ||
        orr_field_real(line, 69, 7, &s.height_m) == ORR_FIELD_BAD) {
        s.lon_deg = s.lat_deg = s.height_m = ORR_NAN;
        orr_cursor_warn(&r->c, r->warnings, 45, "the approximate place of %s is malformed", s.code);
    }
    orr_status st =
        orr_records_grow(&x->site, x->n_sites, sizeof s, r->limits.max_records, "sites", &r->c, r->diag);
    if (st == ORR_OK) x->site[x->n_sites++] = s;
    return st;
}

static orr_status eccentricity(sinex_reader *r, orr_view line)
{
    orr_sinex *x = r->out;
    orr_sinex_eccentricity e = {0};
    copy(line, 2, 4, e.code, sizeof e.code);
    copy(line, 7, 2, e.point, sizeof e.point);
    if (!orr_records_sinex_time(orr_view_cols(line, 17, 12), ORR_SCALE_UTC, r->limits.leap, &e.from) ||
        !orr_records_sinex_time(orr_view_cols(line, 30, 12), ORR_SCALE_UTC, r->limits.leap, &e.until))
        return bad(r, 17, "the validity of an eccentricity is no pair of dates");
    orr_view system = orr_view_trim(orr_view_cols(line, 43, 3));
    e.local = orr_view_equals(system, "UNE");
    if (!e.local && !orr_view_equals(system, "XYZ"))
        return bad(r, 43, "an eccentricity in neither UNE nor XYZ");
    for (int i = 0; i < 3; i++)
        if (orr_field_real(line, 47 + 9 * i, 8, &e.offset_m[i]) != ORR_FIELD_OK)
            return bad(r, 47 + 9 * i, "an eccentricity is missing or malformed");
    orr_status s = orr_records_grow(&x->eccentricity, x->n_eccentricities, sizeof e, r->limits.max_records,
                                    "eccentricities", &r->c, r->diag);
    if (s == ORR_OK) x->eccentricity[x->n_eccentricities++] = e;
    return s;
}

static bool same_estimate(const orr_sinex_estimate *a, const orr_sinex_estimate *b)
{
    return strcmp(a->code, b->code) == 0 && strcmp(a->point, b->point) == 0 &&
           strcmp(a->solution, b->solution) == 0 && a->epoch == b->epoch;
}

// The estimate that a line belongs to. Its parameters follow each other, so the last one is looked at first.
static orr_status estimate_of(sinex_reader *r, const orr_sinex_estimate *key, orr_sinex_estimate **out)
{
    orr_sinex *x = r->out;
    if (r->last_estimate < x->n_estimates && same_estimate(&x->estimate[r->last_estimate], key)) {
        *out = &x->estimate[r->last_estimate];
        return ORR_OK;
    }
    // Velocities may stand in a block behind all positions; a bounded look back keeps huge files linear.
    size_t from = x->n_estimates > 4096 ? x->n_estimates - 4096 : 0;
    for (size_t i = x->n_estimates; i-- > from;) {
        if (!same_estimate(&x->estimate[i], key)) continue;
        r->last_estimate = i;
        *out = &x->estimate[i];
        return ORR_OK;
    }
    orr_status s = orr_records_grow(&x->estimate, x->n_estimates, sizeof *key, r->limits.max_records,
                                    "coordinates", &r->c, r->diag);
    if (s != ORR_OK) return s;
    r->last_estimate = x->n_estimates;
    *out = &x->estimate[x->n_estimates++];
    **out = *key;
    for (int i = 0; i < 3; i++)
        (*out)->pos_m[i] = (*out)->pos_sdev_m[i] = (*out)->vel_mps[i] = (*out)->vel_sdev_mps[i] = ORR_NAN;
    return ORR_OK;
}

static orr_status estimate(sinex_reader *r, orr_view line)
{
    orr_view type = orr_view_trim(orr_view_cols(line, 8, 6));
    bool position = type.n == 4 && memcmp(type.p, "STA", 3) == 0,
         velocity = type.n == 4 && memcmp(type.p, "VEL", 3) == 0;
    if (!position && !velocity) return ORR_OK; // other parameters: Earth rotation, troposphere ...
    int axis = type.p[3] - 'X';
    if (axis < 0 || axis > 2) return bad(r, 8, "a coordinate that is none of X, Y, Z");
    orr_sinex_estimate key = {0}, *e;
    copy(line, 15, 4, key.code, sizeof key.code);
    copy(line, 20, 2, key.point, sizeof key.point);
    copy(line, 23, 4, key.solution, sizeof key.solution);
    if (key.code[0] == '\0') return bad(r, 15, "a coordinate without a site");
    if (!orr_records_sinex_time(orr_view_cols(line, 28, 12), ORR_SCALE_UTC, r->limits.leap, &key.epoch) ||
        key.epoch == ORR_TIME_NONE)
        return bad(r, 28, "the epoch of a coordinate is no date");
    orr_view unit = orr_view_trim(orr_view_cols(line, 41, 4));
    if (!orr_view_equals(unit, position ? "m" : "m/y"))
        return bad(r, 41, "a coordinate not in m, or a velocity not in m/y");
    double value, sdev = ORR_NAN;
    if (orr_field_real(line, 48, 21, &value) != ORR_FIELD_OK)
        return bad(r, 48, "the value of a coordinate is missing or malformed");
    if (orr_field_real(line, 70, 11, &sdev) == ORR_FIELD_BAD)
        return bad(r, 70, "the uncertainty of a coordinate is malformed");
    orr_status s = estimate_of(r, &key, &e);
    if (s != ORR_OK) return s;
    double *v = position ? &e->pos_m[axis] : &e->vel_mps[axis];
    if (!isnan(*v)) return bad(r, 8, "a coordinate stands twice");
    *v = position ? value : value / S_PER_YEAR;
    *(position ? &e->pos_sdev_m[axis] : &e->vel_sdev_mps[axis]) = position ? sdev : sdev / S_PER_YEAR;
    return ORR_OK;
}

static orr_status check(sinex_reader *r)
{
    orr_sinex *x = r->out;
    size_t kept = 0;
    for (size_t i = 0; i < x->n_estimates; i++) {
        const orr_sinex_estimate *e = &x->estimate[i];
        if (isnan(e->pos_m[0]) || isnan(e->pos_m[1]) || isnan(e->pos_m[2]))
            orr_warnings_add(r->warnings, r->c.name, 0, 0, "%s has not all three coordinates; it is left out",
                             e->code);
        else
            x->estimate[kept++] = *e;
    }
    x->n_estimates = kept;
    if (kept == 0 && x->n_sites == 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_NODATA, 0,
                                "the file has neither sites nor station coordinates");
    return ORR_OK;
}

// One line of a block; what cannot be read is told and left out.
static orr_status data_line(sinex_reader *r, orr_status (*read)(sinex_reader *r, orr_view line),
                            orr_view line)
{
    orr_diag *const diag = r->diag;
    orr_diag why = {0};
    r->diag = &why;
    orr_status s = read(r, line);
    r->diag = diag;
    r->tally.good += s == ORR_OK;
    if (s == ORR_E_FORMAT) {
        orr_records_leave_out(&r->tally, &r->c, why.column, why.text, r->warnings);
        return ORR_OK;
    }
    if (s != ORR_OK && diag != NULL) *diag = why;
    return s;
}

orr_status orr_sinex_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                           orr_sinex *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_sinex){.from = ORR_TIME_NONE, .until = ORR_TIME_NONE};
    sinex_reader r = {.out = out, .warnings = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    orr_cursor_init(&r.c, name, text, n);
    enum { OTHER, SITE, ECCENTRICITY, ESTIMATE } block = OTHER;
    bool inside = false, ended = false, first = true;
    orr_view line;
    orr_status s = ORR_OK;
    while (s == ORR_OK && !ended && orr_cursor_next(&r.c, &line)) {
        char c = orr_view_char(line, 1);
        if (first) {
            if (orr_view_is_blank(line)) continue;
            s = header(&r, line);
            first = false;
        } else if (c == '+') {
            inside = true;
            orr_view title = orr_view_rtrim(line);
            block = orr_view_equals(title, "+SITE/ID")             ? SITE
                    : orr_view_equals(title, "+SITE/ECCENTRICITY") ? ECCENTRICITY
                    : orr_view_equals(title, "+SOLUTION/ESTIMATE") ? ESTIMATE
                                                                   : OTHER;
        } else if (c == '-') {
            inside = false;
            block = OTHER;
        } else if (c == '%') {
            ended = orr_view_starts(line, "%ENDSNX") || orr_view_starts(line, "%=ENDSNX");
        } else if (c != '*' && !orr_view_is_blank(line)) {
            if (block == SITE) s = data_line(&r, site, line);
            if (block == ECCENTRICITY) s = data_line(&r, eccentricity, line);
            if (block == ESTIMATE) s = data_line(&r, estimate, line);
        }
    }
    if (s == ORR_OK) s = orr_cursor_status(&r.c, diag);
    if (s == ORR_OK && first) s = orr_cursor_error(&r.c, diag, ORR_E_KIND, 0, "the file is empty");
    if (s == ORR_OK && (inside || (!ended && out->n_estimates == 0)))
        s = orr_cursor_error(&r.c, diag, ORR_E_FORMAT, 0,
                             "the file ends inside a block or before its coordinates: it is cut short");
    if (s == ORR_OK && !ended) orr_cursor_warn(&r.c, warnings, 0, "the file ends without %%ENDSNX");
    if (s == ORR_OK) s = orr_records_verdict(&r.tally, diag);
    if (s == ORR_OK) s = check(&r);
    if (s == ORR_OK) orr_leap_warn(out->until, r.limits.leap, name, warnings);
    if (s != ORR_OK) orr_sinex_free(out);
    return s;
}

// The first four characters, blind to case: "BOR1" is "BOR100POL".
static bool same_station(const char *a, const char *b)
{
    for (int i = 0; i < 4; i++) {
        if (toupper((unsigned char)a[i]) != toupper((unsigned char)b[i])) return false;
        if (a[i] == '\0') return i > 0;
    }
    return true;
}

orr_status orr_sinex_position(const orr_sinex *x, const char *code, orr_time t, double pos_m[3])
{
    const orr_sinex_estimate *best = NULL;
    double distance = HUGE_VAL;
    for (size_t i = 0; i < x->n_estimates; i++) {
        const orr_sinex_estimate *e = &x->estimate[i];
        double d = fabs(orr_time_diff_s(t, e->epoch));
        if (!same_station(e->code, code) || d >= distance) continue;
        best = e;
        distance = d;
    }
    if (best == NULL) return ORR_E_NODATA;
    double dt = orr_time_diff_s(t, best->epoch);
    for (int i = 0; i < 3; i++)
        pos_m[i] = best->pos_m[i] + (isnan(best->vel_mps[i]) ? 0.0 : best->vel_mps[i] * dt);
    return ORR_OK;
}

const orr_sinex_eccentricity *orr_sinex_find_eccentricity(const orr_sinex *x, const char *code, orr_time t)
{
    for (size_t i = 0; i < x->n_eccentricities; i++) {
        const orr_sinex_eccentricity *e = &x->eccentricity[i];
        if (same_station(e->code, code) && (e->from == ORR_TIME_NONE || t >= e->from) &&
            (e->until == ORR_TIME_NONE || t <= e->until))
            return e;
    }
    return NULL;
}

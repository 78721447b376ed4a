// SPDX-License-Identifier: GPL-3.0-or-later
// What navigation files hold besides ephemerides: ionosphere, system time offsets, Earth orientation (records
// of RINEX 4) and the header lines of RINEX 2 and 3 that say the same.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_nav_private.h"

#define RAD_PER_ARCSEC (ORR_PI / 648000.0)

// "> ION G12 LNAV": the satellite may be a system letter alone.
static char take_tag(const nav_lines *r, orr_sat *sat, uint8_t *message)
{
    orr_view tag = r->tag.text, id = orr_view_cols(tag, 7, 3);
    *sat = id.n == 3 ? orr_sat_parse3(id.p, 0) : ORR_SAT_NONE;
    *message = (uint8_t)orr_nav_message_parse(orr_view_cols(tag, 11, 4));
    return orr_view_char(tag, 7);
}

static bool enough_lines(const nav_lines *r, size_t want, nav_fault *f)
{
    if (r->n >= want && r->n <= NAV_MAX_LINES) return true;
    return orr_nav_fault(f, r->tag.number, 0, "a record of %zu lines instead of %zu", r->n, want);
}

bool orr_nav_take_iono(const nav_lines *r, orr_nav_iono *out, nav_fault *f)
{
    *out = (orr_nav_iono){.time_mark = ' ', .iod = ORR_NAV_NO_IOD, .line = r->tag.number};
    for (size_t i = 0; i < 24; i++) out->coefficient[i] = ORR_NAN;
    for (size_t i = 0; i < 4; i++) out->region_deg[i] = ORR_NAN;
    out->system = take_tag(r, &out->sat, &out->message);
    if (out->message == ORR_NAV_NONE)
        return orr_nav_fault(f, r->tag.number, 11, "a message type that is not known");
    bool l1nv = out->message == ORR_NAV_L1NV,
         neqn = l1nv && orr_view_contains(orr_view_cols(r->tag.text, 16, 4), "NEQN");
    bool bdgim = out->system == 'C' && out->message == ORR_NAV_CNVX;
    out->kind = out->system == 'E'   ? ORR_NAV_NEQUICK_G
                : bdgim              ? ORR_NAV_BDGIM
                : neqn               ? ORR_NAV_NEQUICK_N
                : out->system == 'R' ? ORR_NAV_GLONASS_CDMA
                                     : ORR_NAV_KLOBUCHAR;
    static const size_t lines[] = {0, 3, 2, 3, 7, 1};
    if (!enough_lines(r, l1nv && !neqn ? 4 : lines[out->kind], f)) return false;
    double v[3 + NAV_MAX_FIELDS];
    for (size_t i = 0; i < sizeof v / sizeof v[0]; i++) v[i] = ORR_NAN;
    if (!orr_nav_epoch(r, 0, false, orr_nav_scale_of(out->system), &out->t, f)) return false;
    for (int k = 0; k < 3; k++)
        if (!orr_nav_field(r, 0, 24 + 19 * k, &v[k], f)) return false;
    for (size_t i = 1; i < r->n; i++)
        for (int k = 0; k < 4; k++)
            if (!orr_nav_field(r, i, 5 + 19 * k, &v[3 + 4 * (i - 1) + (size_t)k], f)) return false;
    static const size_t counts[] = {0, 8, 3, 9, 24, 3};
    size_t from = l1nv ? 3 : 0, n = counts[out->kind];
    for (size_t i = 0; i < n; i++) {
        out->coefficient[i] = v[from + i];
        if (isnan(v[from + i]))
            return orr_nav_fault(f, r->line[0].number, 0, "an ionosphere coefficient is missing");
    }
    double flags = out->kind == ORR_NAV_KLOBUCHAR && !l1nv ? v[8] : out->kind == ORR_NAV_NEQUICK_G ? v[3] : 0;
    out->flags = flags >= 0 && flags < 65536 ? (uint32_t)lround(flags) : 0;
    if (l1nv) {
        out->iod = fabs(v[0]) < 65536 ? (int32_t)lround(v[0]) : ORR_NAV_NO_IOD;
        if (!neqn)
            for (size_t i = 0; i < 4; i++) out->region_deg[i] = v[11 + i];
    }
    return true;
}

static orr_time transmitted(double sow_s, char system, orr_time near)
{
    return fabs(sow_s) < 2 * 604800.0 ? orr_nav_of_week(sow_s, system, near) : ORR_TIME_NONE;
}

bool orr_nav_take_sto(const nav_lines *r, orr_nav_sto *out, nav_fault *f)
{
    *out = (orr_nav_sto){.line = r->tag.number};
    char system = take_tag(r, &out->sat, &out->message);
    if (!enough_lines(r, 2, f)) return false;
    if (!orr_nav_epoch(r, 0, false, orr_nav_scale_of(system), &out->t_ref, f)) return false;
    orr_view line = r->line[0].text;
    orr_view_copy(orr_view_trim(orr_view_cols(line, 25, 18)), out->code, sizeof out->code);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 44, 18)), out->sbas_id, sizeof out->sbas_id);
    orr_view_copy(orr_view_trim(orr_view_cols(line, 63, 18)), out->utc_id, sizeof out->utc_id);
    if (strlen(out->code) != 4)
        return orr_nav_fault(f, r->line[0].number, 25, "the time offset has no four-letter code");
    double v[4];
    for (int k = 0; k < 4; k++)
        if (!orr_nav_field(r, 1, 5 + 19 * k, &v[k], f)) return false;
    if (isnan(v[1])) return orr_nav_fault(f, r->line[1].number, 24, "the time offset is missing");
    out->transmission = transmitted(v[0], system, out->t_ref);
    out->a0_s = v[1];
    out->a1_sps = isnan(v[2]) ? 0 : v[2];
    out->a2_sps2 = isnan(v[3]) ? 0 : v[3];
    return true;
}

bool orr_nav_take_eop(const nav_lines *r, orr_nav_eop *out, nav_fault *f)
{
    *out = (orr_nav_eop){.line = r->tag.number};
    char system = take_tag(r, &out->sat, &out->message);
    if (!enough_lines(r, 3, f)) return false;
    if (!orr_nav_epoch(r, 0, false, orr_nav_scale_of(system), &out->t_ref, f)) return false;
    double v[9], sow = 0;
    for (size_t i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            double *x = &v[3 * i + (size_t)k];
            if (!orr_nav_field(r, i, 24 + 19 * k, x, f)) return false;
            if (isnan(*x) && k > 0) *x = 0;
            if (isnan(*x))
                return orr_nav_fault(f, r->line[i].number, 24, "an Earth orientation value is missing");
        }
    if (!orr_nav_field(r, 2, 5, &sow, f)) return false;
    out->transmission = transmitted(sow, system, out->t_ref);
    const double day = ORR_S_PER_DAY;
    out->xp_rad = v[0] * RAD_PER_ARCSEC;
    out->xp_rate_radps = v[1] * RAD_PER_ARCSEC / day;
    out->xp_accel_radps2 = v[2] * RAD_PER_ARCSEC / (day * day);
    out->yp_rad = v[3] * RAD_PER_ARCSEC;
    out->yp_rate_radps = v[4] * RAD_PER_ARCSEC / day;
    out->yp_accel_radps2 = v[5] * RAD_PER_ARCSEC / (day * day);
    out->dut1_s = v[6];
    out->dut1_rate_sps = v[7] / day;
    out->dut1_accel_sps2 = v[8] / (day * day);
    return true;
}

// ---- header lines of RINEX 2 and 3 ----

typedef struct header_context {
    orr_nav *nav;
    orr_view line;
    const char *name;
    int64_t number;
    orr_warnings *w;
    orr_diag *diag;
} header_context;

static orr_status leave_out(const header_context *c, int column, const char *what)
{
    orr_warnings_add(c->w, c->name, c->number, column, "%s: the header line is left out", what);
    return ORR_OK;
}

// Four D12.4 from a column; false if one is no number.
static bool four(const header_context *c, int column, double out[4])
{
    for (int i = 0; i < 4; i++) {
        out[i] = 0; // blank trailing parameters are zero
        if (orr_field_real(c->line, column + 12 * i, 12, &out[i]) == ORR_FIELD_BAD) return false;
    }
    return true;
}

// alpha (part 0) and beta (part 4) of one Klobuchar set come on two lines.
static orr_status klobuchar(const header_context *c, char system, size_t part, const double v[4], char mark,
                            orr_sat sat)
{
    orr_nav *nav = c->nav;
    orr_nav_iono *set = NULL;
    // The other half of the same mark and satellite; else the last one that leaves open what this line tells, or the
    // reverse: some receivers write them on one of the two lines alone.
    for (int loose = 0; loose < 2 && set == NULL; loose++)
        for (size_t i = 0; i < nav->n_iono; i++) {
            orr_nav_iono *k = &nav->iono[i];
            bool same_mark = k->time_mark == mark || (loose && (k->time_mark == ' ' || mark == ' '));
            bool same_sat = k->sat == sat || (loose && (k->sat == ORR_SAT_NONE || sat == ORR_SAT_NONE));
            if (k->kind != ORR_NAV_KLOBUCHAR || k->system != system || !isnan(k->coefficient[part])) continue;
            if (same_mark && same_sat && (loose || set == NULL)) set = k;
        }
    if (set != NULL && set->sat == ORR_SAT_NONE) set->sat = sat;
    if (set != NULL && set->time_mark == ' ') set->time_mark = mark;
    if (set == NULL) {
        orr_nav_iono fresh = {.kind = ORR_NAV_KLOBUCHAR,
                              .system = system,
                              .time_mark = mark,
                              .sat = sat,
                              .t = ORR_TIME_NONE,
                              .iod = ORR_NAV_NO_IOD,
                              .line = c->number};
        for (size_t i = 0; i < 24; i++) fresh.coefficient[i] = ORR_NAN;
        for (size_t i = 0; i < 4; i++) fresh.region_deg[i] = ORR_NAN;
        orr_status s = orr_nav_append(&nav->iono, &nav->n_iono, sizeof fresh, &fresh, c->diag);
        if (s != ORR_OK) return s;
        set = &nav->iono[nav->n_iono - 1];
    }
    memcpy(&set->coefficient[part], v, 4 * sizeof *v);
    return ORR_OK;
}

static orr_status ionospheric_corr(const header_context *c)
{
    double v[4];
    orr_view kind = orr_view_trim(orr_view_cols(c->line, 1, 4));
    if (!four(c, 6, v)) return leave_out(c, 6, "an ionosphere parameter is not a number");
    char mark = orr_view_char(c->line, 55);
    if (mark < 'A' || mark > 'X') mark = ' ';
    if (orr_view_equals(kind, "GAL")) {
        orr_nav_iono g = {.kind = ORR_NAV_NEQUICK_G,
                          .system = 'E',
                          .time_mark = mark,
                          .t = ORR_TIME_NONE,
                          .iod = ORR_NAV_NO_IOD,
                          .line = c->number};
        for (size_t i = 0; i < 24; i++) g.coefficient[i] = i < 3 ? v[i] : ORR_NAN;
        for (size_t i = 0; i < 4; i++) g.region_deg[i] = ORR_NAN;
        return orr_nav_append(&c->nav->iono, &c->nav->n_iono, sizeof g, &g, c->diag);
    }
    static const struct {
        const char *name;
        char system;
    } sets[] = {{"GPS", 'G'}, {"BDS", 'C'}, {"QZS", 'J'}, {"IRN", 'I'}};
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++) {
        if (kind.n != 4 || memcmp(kind.p, sets[i].name, 3) != 0 || (kind.p[3] != 'A' && kind.p[3] != 'B'))
            continue;
        int number = 0;
        orr_sat sat = orr_field_int_in(c->line, 57, 2, 1, 99, &number) == ORR_FIELD_OK
                          ? orr_sat_make(sets[i].system, number)
                          : ORR_SAT_NONE;
        return klobuchar(c, sets[i].system, kind.p[3] == 'A' ? 0 : 4, v, mark, sat);
    }
    return leave_out(c, 1, "a kind of ionosphere parameters that is not known");
}

static orr_time of_week(int64_t week, int64_t sow_s, char system)
{
    if (week <= 0 || week > 9999 || sow_s < 0 || sow_s > 604800) return ORR_TIME_NONE;
    int64_t shift = system == 'C' ? 14 : 0;
    if (system == 'C') week += 1356;
    return orr_time_add(orr_time_from_week((int32_t)week, sow_s * ORR_NS_PER_S), shift * ORR_NS_PER_S);
}

static orr_status add_sto(const header_context *c, const char *code, double a0, double a1, orr_time t)
{
    orr_nav_sto s = {.a0_s = a0, .a1_sps = a1, .t_ref = t, .transmission = ORR_TIME_NONE, .line = c->number};
    memcpy(s.code, code, 4);
    return orr_nav_append(&c->nav->sto, &c->nav->n_sto, sizeof s, &s, c->diag);
}

static orr_status time_system_corr(const header_context *c)
{
    static const char *const utc[] = {"",          "UTC(NIST)",       "UTC(USNO)", "UTC(SU)",
                                      "UTC(BIPM)", "UTC(Europe Lab)", "UTC(CRL)"};
    orr_view code = orr_view_cols(c->line, 1, 4);
    double a0 = 0, a1 = 0;
    int64_t sow = 0, week = 0;
    if (code.n < 4 || orr_view_trim(code).n != 4)
        return leave_out(c, 1, "the time correction has no four-letter code");
    if (orr_field_real(c->line, 6, 17, &a0) != ORR_FIELD_OK ||
        orr_field_real(c->line, 23, 16, &a1) == ORR_FIELD_BAD ||
        orr_field_int(c->line, 39, 7, &sow) == ORR_FIELD_BAD ||
        orr_field_int(c->line, 46, 5, &week) == ORR_FIELD_BAD)
        return leave_out(c, 6, "a time correction that is not readable");
    orr_status s = add_sto(c, code.p, a0, a1, of_week(week, sow, code.p[0] == 'B' ? 'C' : 'G'));
    if (s != ORR_OK) return s;
    orr_nav_sto *sto = &c->nav->sto[c->nav->n_sto - 1];
    orr_view_copy(orr_view_trim(orr_view_cols(c->line, 52, 5)), sto->sbas_id, sizeof sto->sbas_id);
    int id = 0;
    if (orr_field_int_in(c->line, 58, 2, 1, 6, &id) == ORR_FIELD_OK)
        memcpy(sto->utc_id, utc[id], strlen(utc[id]) + 1);
    return ORR_OK;
}

static orr_status delta_utc(const header_context *c, const char *code)
{
    double a0 = 0, a1 = 0;
    int64_t sow = 0, week = 0;
    if (orr_field_real(c->line, 4, 19, &a0) == ORR_FIELD_BAD ||
        orr_field_real(c->line, 23, 19, &a1) == ORR_FIELD_BAD ||
        orr_field_int(c->line, 42, 9, &sow) == ORR_FIELD_BAD ||
        orr_field_int(c->line, 51, 9, &week) == ORR_FIELD_BAD)
        return leave_out(c, 4, "a UTC correction that is not readable");
    return add_sto(c, code, a0, a1, of_week(week, sow, 'G'));
}

static orr_status corr_to_system_time(const header_context *c)
{
    orr_rinex_date d = {0};
    double tau = 0;
    orr_time t = ORR_TIME_NONE;
    if (orr_field_int_in(c->line, 1, 6, 0, 9999, &d.year) != ORR_FIELD_OK ||
        orr_field_int_in(c->line, 7, 6, 1, 12, &d.month) != ORR_FIELD_OK ||
        orr_field_int_in(c->line, 13, 6, 1, 31, &d.day) != ORR_FIELD_OK ||
        orr_field_real(c->line, 19, 42, &tau) != ORR_FIELD_OK ||
        orr_rinex_time(&d, ORR_SCALE_UTC, c->nav->leap, &t) != ORR_OK)
        return leave_out(c, 1, "a correction to system time that is not readable");
    return add_sto(c, "GLUT", tau, 0, t);
}

static orr_status leap_seconds(const header_context *c)
{
    orr_nav *nav = c->nav;
    if (orr_field_int_in(c->line, 1, 6, -99, 999, &nav->leap_s) != ORR_FIELD_OK)
        return leave_out(c, 1, "the leap seconds are not a number");
    nav->has_leap = true;
    orr_field_int_in(c->line, 7, 6, -99, 999, &nav->leap_future_s);
    orr_field_int_in(c->line, 13, 6, 0, 9999, &nav->leap_week);
    orr_field_int_in(c->line, 19, 6, 0, 9, &nav->leap_day);
    orr_view scale = orr_view_trim(orr_view_cols(c->line, 25, 3));
    nav->leap_scale =
        orr_view_equals(scale, "BDS") || orr_view_equals(scale, "BDT") ? ORR_SCALE_BDT : ORR_SCALE_GPS;
    return ORR_OK;
}

static orr_status comment(const header_context *c)
{
    char *text = orr_view_dup(orr_view_rtrim(orr_view_cols(c->line, 1, 60)));
    if (text == NULL) return orr_diag_set(c->diag, ORR_E_MEMORY, "out of memory");
    orr_status s = orr_nav_append(&c->nav->comment, &c->nav->n_comments, sizeof text, &text, c->diag);
    if (s != ORR_OK) free(text);
    return s;
}

static orr_status v2_ion(const header_context *c, size_t part)
{
    double v[4];
    if (!four(c, 3, v)) return leave_out(c, 3, "an ionosphere parameter is not a number");
    return klobuchar(c, 'G', part, v, ' ', ORR_SAT_NONE);
}

orr_status orr_nav_header_line(orr_nav *nav, orr_view line, const char *name, int64_t number, orr_warnings *w,
                               orr_diag *diag)
{
    header_context c = {nav, line, name, number, w, diag};
    orr_view label = orr_rinex_label(line);
    if (orr_view_equals(label, "COMMENT")) return comment(&c);
    if (orr_view_equals(label, "ION ALPHA")) return v2_ion(&c, 0);
    if (orr_view_equals(label, "ION BETA")) return v2_ion(&c, 4);
    if (orr_view_equals(label, "IONOSPHERIC CORR")) return ionospheric_corr(&c);
    if (orr_view_equals(label, "TIME SYSTEM CORR")) return time_system_corr(&c);
    if (orr_view_equals(label, "DELTA-UTC: A0,A1,T,W")) return delta_utc(&c, "GPUT");
    if (orr_view_equals(label, "D-UTC A0,A1,T,W,S,U")) return delta_utc(&c, "SBUT");
    if (orr_view_equals(label, "CORR TO SYSTEM TIME")) return corr_to_system_time(&c);
    if (orr_view_equals(label, "LEAP SECONDS")) return leap_seconds(&c);
    if (orr_view_equals(label, "PGM / RUN BY / DATE")) {
        orr_view_copy(orr_view_trim(orr_view_cols(line, 1, 20)), nav->program, sizeof nav->program);
        orr_view_copy(orr_view_trim(orr_view_cols(line, 21, 20)), nav->run_by, sizeof nav->run_by);
        orr_view_copy(orr_view_trim(orr_view_cols(line, 41, 20)), nav->date, sizeof nav->date);
        return ORR_OK;
    }
    static const char *const ignored[] = {"DOI",         "LICENSE OF USE",      "STATION INFORMATION",
                                          "MERGED FILE", "REC # / TYPE / VERS", "ANT # / TYPE",
                                          "MARKER NAME", "MARKER NUMBER"};
    for (size_t i = 0; i < sizeof ignored / sizeof ignored[0]; i++)
        if (orr_view_equals(label, ignored[i])) return ORR_OK;
    if (!orr_view_is_blank(line))
        orr_warnings_add(w, name, number, 61, "the header label \"%.*s\" is not known: the line is ignored",
                         (int)label.n, label.p);
    return ORR_OK;
}

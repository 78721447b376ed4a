// SPDX-License-Identifier: GPL-3.0-or-later
// CODE's code biases before Bias-SINEX: a title with the kind and the period, then
// "G01                          -1.582       0.009" for satellites and "G     ABPO 33302M001   ..." for
// receivers.
#include <math.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/tables/bias_private.h"

// RINEX 3 code of a RINEX 2 one; C2 of GPS names no one signal and stays.
static void modern(const char *old, char system, char out[4])
{
    static const struct {
        const char *old, *gps, *glonass;
    } table[] = {{"P1", "C1W", "C1P"}, {"P2", "C2W", "C2P"}, {"C1", "C1C", "C1C"}, {"C2", "C2", "C2C"}};
    strcpy(out, old);
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (strcmp(old, table[i].old) == 0) strcpy(out, system == 'R' ? table[i].glonass : table[i].gps);
}

static const char *find(orr_view v, const char *what)
{
    size_t n = strlen(what);
    for (size_t i = 0; i + n <= v.n; i++)
        if (memcmp(v.p + i, what, n) == 0) return v.p + i + n;
    return NULL;
}

// Numbers that follow a word of the title, whatever stands between them.
static int numbers_after(orr_view title, const char *word, int *out, int most)
{
    const char *p = find(title, word), *end = title.p + title.n;
    int n = 0;
    while (p != NULL && p < end && n < most) {
        while (p < end && (*p < '0' || *p > '9')) p++;
        if (p == end) break;
        int v = 0;
        while (p < end && *p >= '0' && *p <= '9' && v < 100000) v = v * 10 + (*p++ - '0');
        out[n++] = v;
    }
    return n;
}

static int full_year(int y) { return y >= 100 ? y : y < 80 ? 2000 + y : 1900 + y; }

static orr_time day_start(int32_t mjd) { return orr_time_from_mjd(mjd, 0.0, ORR_SCALE_GPS, NULL); }

// "MONTHLY ... YEAR-MONTH 08-10", "MONTHLY ... YEAR 2012, MONTH 01", "30-DAY ... ENDING DAY 035, 2024",
// "ENDING D274, 2004". CODE's own running titles have lost the year ("YEAR 2"): such a file has no validity,
// which is said.
static void period(bias_reader *r, orr_view title)
{
    int v[2];
    bool known = false;
    if (numbers_after(title, "YEAR-MONTH", v, 2) == 2 || numbers_after(title, "YEAR ", v, 2) == 2) {
        int year = full_year(v[0]), month = v[1];
        if (find(title, "MONTH") != NULL && month >= 1 && month <= 12 && year >= 1980 && year < 2200) {
            r->out->from = day_start(orr_mjd_from_date(year, month, 1));
            r->out->until = day_start(month == 12 ? orr_mjd_from_date(year + 1, 1, 1)
                                                  : orr_mjd_from_date(year, month + 1, 1));
            known = true;
        }
    }
    if (!known && numbers_after(title, "ENDING D", v, 2) == 2) {
        int year = v[1] >= 1980 ? v[1] : 0;
        if (year != 0 && year < 2200 && v[0] >= 1 && v[0] <= 366) {
            int32_t last = orr_mjd_from_date(year, 1, 1) + v[0] - 1;
            r->out->from = day_start(last - 29);
            r->out->until = day_start(last + 1);
            known = true;
        }
    }
    if (!known)
        orr_cursor_warn(&r->c, r->warnings, 1,
                        "the title does not tell a period; the biases are taken as always valid");
}

// The pair of a block: "DIFFERENTIAL (P1-P2) CODE BIASES FOR SATELLITES AND RECEIVERS:". False for other
// blocks, such as (LC) or (INTER-FREQ).
static bool pair_of(orr_view line, char obs1[3], char obs2[3])
{
    const char *p = find(line, "DIFFERENTIAL (");
    if (p == NULL || line.p + line.n - p < 6 || p[2] != '-' || p[5] != ')') return false;
    for (int i = 0; i < 5; i += 3)
        if ((p[i] != 'P' && p[i] != 'C') || p[i + 1] < '1' || p[i + 1] > '9') return false;
    memcpy(obs1, p, 2);
    memcpy(obs2, p + 3, 2);
    obs1[2] = obs2[2] = '\0';
    return true;
}

static orr_status row(bias_reader *r, orr_view line, const char *obs1, const char *obs2)
{
    orr_bias b = {.kind = ORR_BIAS_DSB,
                  .from = r->out->from,
                  .until = r->out->until,
                  .sdev_s = ORR_NAN,
                  .slope_sps = ORR_NAN,
                  .slope_sdev_sps = ORR_NAN};
    orr_view prn = orr_view_trim(orr_view_cols(line, 1, 3));
    orr_view_copy(orr_view_trim(orr_view_cols(line, 7, 16)), b.station, sizeof b.station);
    if (prn.n == 1) {
        b.system = prn.p[0];
    } else if (prn.n >= 2) {
        char text[4];
        b.sat = orr_sat_parse(orr_view_copy(prn, text, sizeof text));
        b.system = orr_sat_system(b.sat);
    }
    if (b.sat == ORR_SAT_NONE &&
        (b.station[0] == '\0' || b.system == '\0' || strchr(ORR_SYSTEMS, b.system) == NULL))
        return bias_leave_out(r, 1, "a bias of neither a satellite nor a station");
    if (r->c.unterminated && line.n < 47) // a value at the very end of a file may be half of one
        return bias_leave_out(r, (int)line.n, "the file ends inside a line");
    double v;
    if (orr_field_real(line, 27, 9, &v) != ORR_FIELD_OK)
        return bias_leave_out(r, 27, "the value of a bias is no number");
    b.value_s = v * 1e-9;
    orr_field got = orr_field_real(line, 39, 9, &v);
    if (got == ORR_FIELD_BAD) return bias_leave_out(r, 39, "the RMS of a bias is malformed");
    if (got == ORR_FIELD_OK) b.sdev_s = v * 1e-9;
    orr_view rest = orr_view_cols(line, 48, 64), from = {0},
             until = {0}; // some files give every line its own period
    if (!orr_view_is_blank(rest)) {
        from = orr_view_cols(line, 48, 21);
        until = orr_view_cols(line, 69, 64);
        if (!orr_records_civil(from, ORR_SCALE_GPS, NULL, &b.from) ||
            !orr_records_civil(until, ORR_SCALE_GPS, NULL, &b.until))
            return bias_leave_out(r, 48, "the period of a bias is no pair of dates");
    }
    modern(obs1, b.system, b.obs1);
    modern(obs2, b.system, b.obs2);
    return bias_add(r, &b);
}

orr_status bias_read_dcb(bias_reader *r, orr_view title)
{
    char obs1[3] = "", obs2[3] = "";
    orr_bias_set *x = r->out;
    strcpy(x->format, "CODE DCB");
    if (orr_view_starts(orr_view_trim(title), "CODE")) strcpy(x->agency, "COD");
    bool any_block = false, known = false, period_read = false;
    orr_view line = title;
    do {
        orr_status s = ORR_OK;
        if (find(line, "DIFFERENTIAL (") != NULL) {
            if (!period_read) period(r, title);
            any_block = period_read = true;
            known = pair_of(line, obs1, obs2);
            if (!known)
                orr_cursor_warn(&r->c, r->warnings, 1,
                                "a block that differences no two codes (P1-P2, P1-C1, P2-C2) is passed over");
        } else if (known && !orr_view_is_blank(line) && !orr_view_starts(line, "PRN /") &&
                   !orr_view_starts(line, "***") && !orr_view_starts(line, "---")) {
            s = row(r, line, obs1, obs2);
        }
        if (s != ORR_OK) return s;
        if (!any_block && r->c.line > 20) break;
    } while (orr_cursor_next(&r->c, &line));
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s == ORR_OK && !any_block)
        s = orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 0,
                             "not a bias file: neither %%=BIA nor a line DIFFERENTIAL (P1-P2) CODE BIASES");
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of navigation records: numbers, dates, seconds of week, names of messages, and what is wrong with them;
// and the lists that records are appended to.
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "core/array.h"
#include "core/decimal.h"
#include "core/digits.h"
#include "core/nan.h"
#include "ingest/rinex/rinex_nav_private.h"

#define WEEK_NS (INT64_C(604800) * ORR_NS_PER_S)

bool orr_nav_fault(nav_fault *f, int64_t line, int column, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    f->line = line;
    f->column = column;
    vsnprintf(f->text, sizeof f->text, fmt, ap);
    va_end(ap);
    return false;
}

static bool has_exponent(orr_view v, int digits)
{
    v = orr_view_rtrim(v);
    for (size_t i = 0; i < v.n; i++) {
        char c = v.p[i];
        if (c != 'e' && c != 'E' && c != 'd' && c != 'D') continue;
        size_t rest = v.n - i - 1;
        if (rest > 0 && (v.p[i + 1] == '+' || v.p[i + 1] == '-')) rest--;
        return rest >= (size_t)digits;
    }
    return false;
}

// D19.12 as nearly all files have it: sign, digit, point, twelve digits, letter, sign, two digits. False: not
// so.
static bool read_d19_12(const char *p, double *out)
{
    char letter = (char)(p[15] | 0x20);
    if (p[2] != '.' || (letter != 'd' && letter != 'e') || (p[16] != '-' && p[16] != '+')) return false;
    bool minus = p[0] == '-' || p[1] == '-';
    uint64_t high = orr_digits_load(p + 3), low = orr_digits_load(p + 7) >> 32 << 32;
    unsigned lead = (unsigned)(unsigned char)p[1] - '0', e1 = (unsigned)(unsigned char)p[17] - '0',
             e2 = (unsigned)(unsigned char)p[18] - '0';
    if (p[1] == ' ' || (p[1] == '-' && p[0] == ' ')) lead = 0; // ".123D+01": no digit before the point
    if ((p[0] != ' ' && p[0] != '-') || (p[0] == '-' && p[1] == ' ') || lead > 9 || e1 > 9 || e2 > 9)
        return false;
    if (!orr_digits_all(high) || !orr_digits_all(low)) return false;
    uint64_t m =
        lead * UINT64_C(1000000000000) + orr_digits_value(high) * UINT64_C(10000) + orr_digits_value(low);
    int e = (int)(10 * e1 + e2);
    double x = m == 0 ? 0 : orr_decimal_scale(m, (p[16] == '-' ? -e : e) - 12);
    *out = minus ? -x : x;
    return true;
}

bool orr_nav_field(const nav_lines *r, size_t line, int column, double *out, nav_fault *f)
{
    *out = ORR_NAN;
    const nav_line *l = &r->line[line];
    if (l->text.n >= (size_t)column + 18 && read_d19_12(l->text.p + column - 1, out)) return true;
    orr_view v = orr_view_cols(l->text, column, 19);
    orr_field got = orr_view_real(v, out);
    if (got == ORR_FIELD_BLANK) return true;
    if (got == ORR_FIELD_BAD) return orr_nav_fault(f, l->number, column, "a field that is not a number");
    // A number that the end of the line cuts could be anything: "2.4526" was perhaps "2.4526E+03".
    bool last = r->cut && line + 1 == r->n;
    if (v.n < 19 && *out != 0 && !has_exponent(v, last ? 2 : 1))
        return orr_nav_fault(f, l->number, column, "a field that is cut off");
    return true;
}

orr_scale orr_nav_scale_of(char system)
{
    switch (system) {
    case 'R':
        return ORR_SCALE_GLO;
    case 'C':
        return ORR_SCALE_BDT;
    case 'E':
        return ORR_SCALE_GAL;
    case 'J':
        return ORR_SCALE_QZS;
    case 'I':
        return ORR_SCALE_IRN;
    default:
        return ORR_SCALE_GPS;
    }
}

bool orr_nav_epoch(const nav_lines *r, size_t line, bool v2, orr_scale scale, orr_time *t, nav_fault *f)
{
    static const int col2[5] = {4, 7, 10, 13, 16}, col3[5] = {5, 10, 13, 16, 19};
    const nav_line *l = &r->line[line];
    orr_rinex_date d = {0};
    int *field[5] = {&d.year, &d.month, &d.day, &d.hour, &d.minute};
    bool good = orr_rinex_seconds(l->text, v2 ? 18 : 22, v2 ? 5 : 2, &d.second_ps);
    for (int i = 0; i < 5; i++) {
        int width = i == 0 && !v2 ? 4 : 2;
        good = good &&
               orr_field_int_in(l->text, v2 ? col2[i] : col3[i], width, 0, 9999, field[i]) == ORR_FIELD_OK;
    }
    if (!good || orr_rinex_time(&d, scale, r->leap, t) != ORR_OK)
        return orr_nav_fault(f, l->number, v2 ? 4 : 5, "a date that is not readable");
    return true;
}

// Nanoseconds since a week of the system began.
int64_t orr_nav_ns_of_week(orr_time t, char system)
{
    int64_t ns = (t - (system == 'C' ? ORR_BDT_BEHIND_GPS_NS : 0)) % WEEK_NS;
    return ns < 0 ? ns + WEEK_NS : ns;
}

orr_time orr_nav_of_week(double sow_s, char system, orr_time near)
{
    int64_t d = (int64_t)llround(sow_s * 1e9) - orr_nav_ns_of_week(near, system);
    d %= WEEK_NS;
    if (d > WEEK_NS / 2) d -= WEEK_NS;
    if (d < -WEEK_NS / 2) d += WEEK_NS;
    return near + d;
}

static const char *const message_names[ORR_NAV_N_MESSAGES] = {
    "",   "LNAV", "CNAV", "CNV1", "CNV2", "CNV3", "INAV", "FNAV", "D1",
    "D2", "FDMA", "SBAS", "L1NV", "IFNV", "D1D2", "CNVX", "L1OC", "L3OC",
};

const char *orr_nav_message_name(orr_nav_message m)
{
    return (unsigned)m < ORR_NAV_N_MESSAGES ? message_names[m] : "?";
}

orr_nav_message orr_nav_message_parse(orr_view name)
{
    name = orr_view_trim(name);
    for (int i = 1; i < ORR_NAV_N_MESSAGES; i++)
        if (orr_view_equals(name, message_names[i])) return (orr_nav_message)i;
    return ORR_NAV_NONE;
}

uint32_t orr_nav_messages_of(char system)
{
#define BIT(message) (UINT32_C(1) << (message))
    switch (system) {
    case 'G':
    case 'J':
        return BIT(ORR_NAV_LNAV) | BIT(ORR_NAV_CNAV) | BIT(ORR_NAV_CNV2);
    case 'R':
        return BIT(ORR_NAV_FDMA);
    case 'E':
        return BIT(ORR_NAV_INAV) | BIT(ORR_NAV_FNAV);
    case 'C':
        return BIT(ORR_NAV_D1) | BIT(ORR_NAV_D2) | BIT(ORR_NAV_CNV1) | BIT(ORR_NAV_CNV2) | BIT(ORR_NAV_CNV3);
    case 'I':
        return BIT(ORR_NAV_LNAV) | BIT(ORR_NAV_L1NV);
    case 'S':
        return BIT(ORR_NAV_SBAS);
    default:
        return 0;
    }
}

// The message among those of `all` that n characters name, as RINEX 4 or as its own document; ORR_NAV_NONE.
static orr_nav_message message_called(const char *name, size_t n, uint32_t all)
{
    static const struct {
        const char *name;
        orr_nav_message message;
    } others[] = {{"CNAV2", ORR_NAV_CNV2},
                  {"BCNAV1", ORR_NAV_CNV1},
                  {"BCNAV2", ORR_NAV_CNV2},
                  {"BCNAV3", ORR_NAV_CNV3}};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (strlen(others[k].name) == n && strncasecmp(name, others[k].name, n) == 0)
            return others[k].message;
    int m = ORR_NAV_N_MESSAGES - 1;
    while (m > 0 && ((all & BIT(m)) == 0 || strlen(message_names[m]) != n ||
                     strncasecmp(name, message_names[m], n) != 0))
        m--;
    return (orr_nav_message)m;
}

orr_status orr_nav_messages_parse(const char *text, uint32_t *out, orr_diag *diag)
{
    uint32_t all = 0, got = 0;
    for (const char *s = ORR_SYSTEMS; *s != '\0'; s++) all |= orr_nav_messages_of(*s);
    for (const char *p = text;;) {
        const size_t n = strcspn(p, ",");
        const orr_nav_message m = message_called(p, n, all);
        if (m == ORR_NAV_NONE)
            return orr_diag_set(
                diag, ORR_E_ARG,
                "\"%.*s\" is no message with ephemerides (LNAV, CNAV, CNV1, CNV2, CNV3, INAV, FNAV, D1, "
                "D2, FDMA, SBAS, L1NV)",
                (int)(n < 20 ? n : 20), p);
        got |= BIT(m);
        if (p[n] == '\0') break;
        p += n + 1;
    }
#undef BIT
    *out = got;
    return ORR_OK;
}

orr_status orr_nav_append(void *array, size_t *n, size_t size, const void *element, orr_diag *diag)
{
    if (!orr_array_grow(array, *n, size)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    char *items = NULL;
    memcpy(&items, array, sizeof items); // *array is a pointer to objects of any type
    memcpy(items + *n * size, element, size);
    (*n)++;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/input/sniff.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include "core/time.h"

static const struct {
    const char *token, *name;
} kinds[ORR_KIND_N] = {
    [ORR_KIND_UNKNOWN] = {"unknown", "text of an unknown kind"},
    [ORR_KIND_EMPTY] = {"empty", "an empty file"},
    [ORR_KIND_BINARY] = {"binary", "binary data of an unknown kind"},
    [ORR_KIND_WEB_PAGE] = {"web-page", "a web page"},
    [ORR_KIND_SP3] = {"sp3", "SP3 orbits"},
    [ORR_KIND_RINEX_NAV] = {"rinex-nav", "RINEX navigation data"},
    [ORR_KIND_RINEX_OBS] = {"rinex-obs", "RINEX observations"},
    [ORR_KIND_RINEX_MET] = {"rinex-met", "RINEX meteorological data"},
    [ORR_KIND_RINEX_CLK] = {"rinex-clk", "RINEX clocks"},
    [ORR_KIND_CRINEX] = {"crinex", "Compact RINEX (Hatanaka) observations"},
    [ORR_KIND_IONEX] = {"ionex", "IONEX ionosphere maps"},
    [ORR_KIND_ION] = {"ion", "Bernese ionosphere coefficients"},
    [ORR_KIND_ERP] = {"erp", "Earth rotation parameters"},
    [ORR_KIND_SINEX] = {"sinex", "SINEX station coordinates"},
    [ORR_KIND_BIAS_SINEX] = {"bias-sinex", "Bias-SINEX code and phase biases"},
    [ORR_KIND_TROPO_SINEX] = {"tropo-sinex", "SINEX troposphere delays"},
    [ORR_KIND_DCB] = {"dcb", "differential code biases"},
    [ORR_KIND_ANTEX] = {"antex", "ANTEX antenna phase centres"},
    [ORR_KIND_GPT3] = {"gpt3", "GPT3 grid of weather and mapping coefficients"},
    [ORR_KIND_VMF3_GRID] = {"vmf3-grid", "VMF3 coefficients and delays on a grid"},
    [ORR_KIND_VMF3_SITE] = {"vmf3-site", "VMF3 coefficients and delays of stations"},
    [ORR_KIND_ESRI_GRID] = {"esri-grid", "ESRI ASCII grid of heights"},
    [ORR_KIND_NMEA] = {"nmea", "NMEA 0183 sentences"},
    [ORR_KIND_TABLE] = {"table", "a table of numbers"},
    [ORR_KIND_NETCDF] = {"netcdf", "NetCDF data"},
    [ORR_KIND_LEAPS] = {"leap-seconds", "a list of leap seconds"},
    [ORR_KIND_ZIP] = {"zip", "a zip archive"},
};

orr_status orr_sniff_expect(const char *name, orr_view head, uint64_t wanted, orr_diag *diag)
{
    const orr_kind kind = orr_sniff(head).kind;
    if ((wanted & ORR_KIND_BIT(kind)) != 0) return ORR_OK;
    return orr_diag_at(diag, ORR_E_KIND, name, 0, 0, "is not what is wanted here: its first lines are of %s",
                       kind == ORR_KIND_UNKNOWN ? "no format that is known" : orr_kind_name(kind));
}

const char *orr_kind_name(orr_kind k) { return k < ORR_KIND_N ? kinds[k].name : kinds[0].name; }
const char *orr_kind_token(orr_kind k) { return k < ORR_KIND_N ? kinds[k].token : kinds[0].token; }

static bool starts_nocase(orr_view v, const char *s)
{
    size_t n = strlen(s);
    return v.n >= n && strncasecmp(v.p, s, n) == 0;
}

static bool contains_nocase(orr_view v, const char *s)
{
    size_t n = strlen(s);
    for (size_t i = 0; i + n <= v.n; i++)
        if (strncasecmp(v.p + i, s, n) == 0) return true;
    return false;
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Texts of the IGS are ASCII with perhaps some UTF-8; a NUL or a crowd of control characters is something
// else.
static bool is_binary(orr_view head)
{
    size_t odd = 0;
    for (size_t i = 0; i < head.n; i++) {
        unsigned char c = (unsigned char)head.p[i];
        if (c < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != 0x1a) odd++;
    }
    return odd * 100 > head.n;
}

// RINEX and its kin tell their kind in the label (columns 61-80) and the type letter (column 21) of line 1.
static bool sniff_rinex(orr_view line, orr_sniffed *s)
{
    orr_view version = orr_view_trim(orr_view_cols(line, 1, 20));
    orr_view label = orr_view_trim(orr_view_cols(line, 61, 40));
    orr_view type = orr_view_cols(line, 21, 20);
    static const struct {
        const char *label;
        orr_kind kind;
    } by_label[] = {{"CRINEX VERS", ORR_KIND_CRINEX},
                    {"IONEX VERSION", ORR_KIND_IONEX},
                    {"ANTEX VERSION", ORR_KIND_ANTEX}};
    static const struct {
        const char *word;
        orr_kind kind;
    } by_word[] = {{"OBSERVATION DATA", ORR_KIND_RINEX_OBS}, {"NAVIGATION DATA", ORR_KIND_RINEX_NAV},
                   {"NAV DATA", ORR_KIND_RINEX_NAV},         {"IONOSPHERE MAPS", ORR_KIND_IONEX},
                   {"COMPACT RINEX", ORR_KIND_CRINEX},       {"METEOROLOGICAL DATA", ORR_KIND_RINEX_MET}};
    s->kind = ORR_KIND_UNKNOWN;
    for (size_t i = 0; i < sizeof by_label / sizeof *by_label; i++)
        if (starts_nocase(label, by_label[i].label)) s->kind = by_label[i].kind;
    bool rinex = starts_nocase(label, "RINEX VERSION");
    // RINEX 3.04 clock files moved their columns by five: type in 22, label in 66.
    orr_view moved = orr_view_trim(orr_view_cols(line, 66, 40));
    if (starts_nocase(moved, "RINEX VERSION")) {
        rinex = true;
        if (orr_view_is_blank(orr_view_cols(line, 21, 1))) type = orr_view_cols(line, 22, 20);
    }
    if (rinex) {
        switch (orr_view_char(type, 1)) {
        case 'O':
        case 'o':
            s->kind = ORR_KIND_RINEX_OBS;
            break;
        case 'M':
        case 'm':
            s->kind = ORR_KIND_RINEX_MET;
            break;
        case 'C':
        case 'c':
            s->kind = ORR_KIND_RINEX_CLK;
            break;
        // RINEX 2 gave other systems letters of their own; H is GEO, L was Galileo.
        case 'N':
        case 'n':
        case 'G':
        case 'g':
        case 'H':
        case 'h':
        case 'L':
        case 'l':
        case 'E':
        case 'e':
        case 'J':
        case 'j':
            s->kind = ORR_KIND_RINEX_NAV;
            break;
        default:
            break;
        }
    }
    // Without the label a version and the words of the type still say what was meant; the reader will
    // complain.
    if (s->kind == ORR_KIND_UNKNOWN && !rinex && version.n > 0 && is_digit(*version.p))
        for (size_t i = 0; i < sizeof by_word / sizeof *by_word && s->kind == ORR_KIND_UNKNOWN; i++)
            if (contains_nocase(orr_view_cols(line, 21, 40), by_word[i].word)) s->kind = by_word[i].kind;
    if (s->kind == ORR_KIND_UNKNOWN) return false;
    orr_view_copy(version, s->version, sizeof s->version);
    return true;
}

// Formats that say what they are somewhere in their first lines. Each line is looked at once.
static bool sniff_words(orr_view line, orr_sniffed *s)
{
    orr_view t = orr_view_trim(line);
    static const struct {
        const char *start, *also;
        orr_kind kind;
    } words[] = {
        {"MJD", "UT1", ORR_KIND_ERP},
        {"EOP", "C04",
         ORR_KIND_ERP}, // the IERS' C04; its lines of text begin so in 08 and 14, with '#' in 20
        {"# EOP", "C04", ORR_KIND_ERP},
        {"MODEL NUMBER / STATION NAME", "", ORR_KIND_ION},
        {"MAXIMUM DEGREE OF SPHERICAL HARMONICS", "", ORR_KIND_ION},
        {"DIFFERENTIAL (", "CODE BIASES", ORR_KIND_DCB},
        {"#$", "", ORR_KIND_LEAPS},
        {"%", "p:a0", ORR_KIND_GPT3}, // GPT2's too, which its reader refuses by name
        {"! Data_types:", "VMF3", ORR_KIND_VMF3_GRID},
        {"! Data_types:", "V3GR", ORR_KIND_VMF3_GRID},
        {"ncols ", "", ORR_KIND_ESRI_GRID},
        {"ncols\t", "", ORR_KIND_ESRI_GRID},
        {"#@", "", ORR_KIND_LEAPS},
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (starts_nocase(t, words[i].start) && contains_nocase(t, words[i].also)) {
            s->kind = words[i].kind;
            return true;
        }
    if (t.n >= 9 && starts_nocase(t, "version ") && is_digit(t.p[t.n - 1])) {
        s->kind = ORR_KIND_ERP;
        orr_view_copy(orr_view_trim(orr_view_cols(t, 8, 8)), s->version, sizeof s->version);
        return true;
    }
    return false;
}

// "$GPGGA,": a dollar, five capitals or digits, a comma; a stamp of the recorder may stand before it, if a checksum
// ends the line.
static bool is_nmea(orr_view line)
{
    orr_view t = orr_view_trim(line);
    const char *dollar = t.n > 3 && t.p[t.n - 3] == '*' ? memchr(t.p, '$', t.n) : NULL;
    if (dollar != NULL) t = (orr_view){dollar, t.n - (size_t)(dollar - t.p)};
    if (t.n < 7 || t.p[0] != '$' || t.p[6] != ',') return false;
    for (int i = 1; i < 6; i++)
        if (!(t.p[i] >= 'A' && t.p[i] <= 'Z') && !is_digit(t.p[i])) return false;
    return true;
}

// Columns of numbers, divided by comma, semicolon or blanks.
static bool is_numbers(orr_view line)
{
    size_t n = 0;
    for (size_t i = 0; i < line.n; i++) {
        char c = line.p[i];
        bool part = is_digit(c) || strchr("+-.,;eEdD \t:TZ/", c) != NULL;
        if (!part || c == '\0') return false;
        if (is_digit(c) &&
            (i == 0 || strchr(",; \t", line.p[i - 1]) != NULL || strchr("+-.", line.p[i - 1]) != NULL))
            n++;
    }
    return n >= 2;
}

// A line of the IERS' finals ("73 1 2 41684.00 I  0.120733 ...": a date, its MJD, a letter) or of C04 without its text
// (year, month, day, perhaps the hour, MJD): the two ways of saying the day agree.
static bool is_iers_rotation(orr_view line)
{
    int y = 0, m = 0, d = 0;
    double mjd = 0;
    char flag = orr_view_char(line, 17);
    if ((flag == 'I' || flag == 'P') && orr_field_int_in(line, 1, 2, 0, 99, &y) == ORR_FIELD_OK &&
        orr_field_int_in(line, 3, 2, 1, 12, &m) == ORR_FIELD_OK &&
        orr_field_int_in(line, 5, 2, 1, 31, &d) == ORR_FIELD_OK &&
        orr_field_real(line, 8, 8, &mjd) == ORR_FIELD_OK)
        return floor(mjd) == orr_mjd_from_date(y + (y < 73 ? 2000 : 1900), m, d);
    orr_view rest = line, word;
    double v[8];
    for (int i = 0; i < 8; i++)
        if (!orr_view_word(&rest, &word) || orr_view_real(word, &v[i]) != ORR_FIELD_OK) return false;
    if (!(v[0] >= 1846 && v[0] < 2200 && v[1] >= 1 && v[1] <= 12 && v[2] >= 1 && v[2] <= 31)) return false;
    mjd = orr_mjd_from_date((int)v[0], (int)v[1], (int)v[2]);
    return floor(v[3]) == mjd || floor(v[4]) == mjd;
}

bool orr_sp3_is_unversioned(orr_view line)
{
    char mode = orr_view_char(line, 3);
    int number;
    return orr_view_starts(line, "# ") && (mode == ' ' || mode == 'P' || mode == 'V') &&
           orr_field_int_in(line, 4, 4, 1980, 2099, &number) == ORR_FIELD_OK &&
           orr_field_int_in(line, 9, 2, 1, 12, &number) == ORR_FIELD_OK &&
           orr_field_int_in(line, 12, 2, 1, 31, &number) == ORR_FIELD_OK &&
           orr_field_int_in(line, 15, 2, 0, 23, &number) == ORR_FIELD_OK &&
           orr_field_int_in(line, 33, 7, 1, 9999999, &number) == ORR_FIELD_OK;
}

// "BOR1 60344.25 0.00121 0.00044 2.29 0.08 ...": a station, its instant, a of both mapping functions, both zenith delays.
static bool is_vmf3_site(orr_view line)
{
    static const double least[] = {40000, 5e-4, -1e-4, 0.5, -0.1}, most[] = {90000, 2e-3, 2e-3, 3, 1};
    orr_view word;
    double v;
    if (!orr_view_word(&line, &word) || orr_view_real(word, &v) == ORR_FIELD_OK) return false;
    for (int k = 0; k < 5; k++)
        if (!orr_view_word(&line, &word) || orr_view_real(word, &v) != ORR_FIELD_OK ||
            !(v >= least[k] && v <= most[k]))
            return false;
    return true;
}

// The label of RINEX outside its columns: no table of numbers, whatever its lines look like. Its reader says what is wrong.
static orr_kind displaced_rinex(orr_view line)
{
    char text[200];
    orr_view_copy(line, text, sizeof text);
    if (strstr(text, "RINEX VERSION / TYPE") == NULL) return ORR_KIND_UNKNOWN;
    return strstr(text, "OBS") != NULL ? ORR_KIND_RINEX_OBS : ORR_KIND_RINEX_NAV;
}

static bool sniff_first_line(orr_view line, orr_sniffed *s)
{
    if (line.n >= 3 && line.p[0] == '#' && line.p[1] >= 'a' && line.p[1] <= 'z' &&
        (line.p[2] == 'P' || line.p[2] == 'V')) {
        s->kind = ORR_KIND_SP3;
        s->version[0] = line.p[1];
        return true;
    }
    if (orr_sp3_is_unversioned(line)) {
        s->kind = ORR_KIND_SP3;
        s->version[0] = 'a';
        return true;
    }
    static const struct {
        const char *start;
        orr_kind kind;
    } sinex[] = {{"%=SNX", ORR_KIND_SINEX}, {"%=BIA", ORR_KIND_BIAS_SINEX}, {"%=TRO", ORR_KIND_TROPO_SINEX}};
    for (size_t i = 0; i < sizeof sinex / sizeof *sinex; i++)
        if (orr_view_starts(line, sinex[i].start)) {
            s->kind = sinex[i].kind;
            orr_view_copy(orr_view_trim(orr_view_cols(line, 6, 6)), s->version, sizeof s->version);
            return true;
        }
    if (is_iers_rotation(line)) {
        s->kind = ORR_KIND_ERP;
        return true;
    }
    return sniff_rinex(line, s);
}

orr_sniffed orr_sniff(orr_view head)
{
    orr_sniffed s = {.kind = ORR_KIND_UNKNOWN};
    if (head.n == 0) {
        s.kind = ORR_KIND_EMPTY;
        return s;
    }
    if ((head.n >= 4 && memcmp(head.p, "CDF", 3) == 0 && head.p[3] > 0 && head.p[3] <= 5) ||
        (head.n >= 8 && memcmp(head.p, "\x89HDF\r\n\x1a\n", 8) == 0)) {
        s.kind = ORR_KIND_NETCDF;
        return s;
    }
    if (is_binary(head)) {
        s.kind = ORR_KIND_BINARY;
        return s;
    }
    orr_cursor c;
    orr_view line;
    orr_cursor_init(&c, "", head.p, head.n);
    int lines = 0, numbers = 0, nmea = 0;
    bool first = true;
    while (lines < 60 && orr_cursor_next(&c, &line)) {
        if (first && line.n >= 3 && memcmp(line.p, "\xef\xbb\xbf", 3) == 0) line.p += 3, line.n -= 3;
        if (orr_view_is_blank(line)) continue;
        if (first) {
            if (sniff_first_line(line, &s)) return s;
            orr_view t = orr_view_trim(line);
            if (starts_nocase(t, "<!doctype") || starts_nocase(t, "<html")) {
                s.kind = ORR_KIND_WEB_PAGE;
                return s;
            }
        }
        if (first && s.kind == ORR_KIND_UNKNOWN) s.kind = displaced_rinex(line);
        if (s.kind != ORR_KIND_UNKNOWN) return s;
        first = false;
        if (sniff_words(line, &s)) return s;
        if (is_vmf3_site(line)) {
            s.kind = ORR_KIND_VMF3_SITE;
            return s;
        }
        if (is_nmea(line)) nmea++;
        if (is_numbers(line)) numbers++;
        lines++;
    }
    if (nmea * 2 > lines)
        s.kind = ORR_KIND_NMEA;
    else if (numbers * 2 > lines)
        s.kind = ORR_KIND_TABLE;
    return s;
}

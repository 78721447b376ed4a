// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/fetch/archives.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/array.h"
#include "ingest/input/text_records.h"

#define MAX_LINES 10000

enum { TABLE_MAX_BYTES = 4 << 20 }; // a table has hundreds of lines

typedef struct name_rule {
    orr_product product;
    orr_tier tier;
    char centre[8];
    int32_t from_mjd, until_mjd;
    char template[112];
    int shift_h;
    bool week_start, name_start;
} name_rule;

typedef struct mirror_rule {
    char name[32];
    unsigned products; // bits
    char folder[256];
    char centres[64]; // ",COD,IGS,"; empty: all
    char tiers[64];
    bool login;
} mirror_rule;

struct orr_archives {
    size_t n_names, n_mirrors, n_stations;
    name_rule *name;
    mirror_rule *mirror;
    char (*station)[10];
};

static const struct {
    const char *name;
    orr_kind kind[2];
} products[ORR_PRODUCT_N] = {
    [ORR_PRODUCT_SP3] = {"sp3", {ORR_KIND_SP3, ORR_KIND_SP3}},
    [ORR_PRODUCT_NAV] = {"nav", {ORR_KIND_RINEX_NAV, ORR_KIND_RINEX_NAV}},
    [ORR_PRODUCT_IONEX] = {"ionex", {ORR_KIND_IONEX, ORR_KIND_IONEX}},
    [ORR_PRODUCT_ION] = {"ion", {ORR_KIND_ION, ORR_KIND_ION}},
    [ORR_PRODUCT_ERP] = {"erp", {ORR_KIND_ERP, ORR_KIND_ERP}},
    [ORR_PRODUCT_CLK] = {"clk", {ORR_KIND_RINEX_CLK, ORR_KIND_RINEX_CLK}},
    [ORR_PRODUCT_BIAS] = {"bias", {ORR_KIND_BIAS_SINEX, ORR_KIND_DCB}},
    [ORR_PRODUCT_SINEX] = {"sinex", {ORR_KIND_SINEX, ORR_KIND_SINEX}},
    [ORR_PRODUCT_ANTEX] = {"antex", {ORR_KIND_ANTEX, ORR_KIND_ANTEX}},
    [ORR_PRODUCT_OBS] = {"obs", {ORR_KIND_RINEX_OBS, ORR_KIND_CRINEX}},
};
static const char *const tiers[] = {"final", "rapid", "ultra", "predicted", "-"};

const char *orr_product_name(orr_product p) { return products[p].name; }
const char *orr_tier_name(orr_tier t) { return tiers[t]; }
bool orr_product_holds(orr_product p, orr_kind kind)
{
    return products[p].kind[0] == kind || products[p].kind[1] == kind;
}

static bool same(const char *name, const char *text, size_t n)
{
    return strlen(name) == n && memcmp(name, text, n) == 0;
}

bool orr_product_parse(const char *name, size_t n, orr_product *out)
{
    for (int i = 0; i < ORR_PRODUCT_N; i++)
        if (same(products[i].name, name, n)) return *out = (orr_product)i, true;
    return false;
}

bool orr_tier_parse(const char *name, size_t n, orr_tier *out)
{
    for (int i = 0; i <= ORR_TIER_NONE; i++)
        if (same(tiers[i], name, n)) return *out = (orr_tier)i, true;
    return false;
}

// ---- the table's text ----

typedef struct table_reader {
    orr_cursor c;
    orr_diag *diag;
    orr_archives *a;
} table_reader;

static orr_status bad(table_reader *r, const char *what)
{
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "%s", what);
}

static bool copy_word(orr_view w, char *out, size_t n)
{
    if (w.n >= n) return false;
    orr_view_copy(w, out, n);
    return true;
}

// "2022-11-27" or "-".
static bool day(orr_view w, int32_t open, int32_t *mjd)
{
    orr_view part[3];
    int64_t v[3];
    if (orr_view_equals(w, "-")) return *mjd = open, true;
    for (int i = 0; i < 3; i++)
        if (!orr_view_split(&w, '-', &part[i]) || orr_view_int(part[i], &v[i]) != ORR_FIELD_OK) return false;
    orr_civil c = {.year = (int)v[0], .month = (int)v[1], .day = (int)v[2]};
    orr_time t;
    if (v[0] < 1980 || v[0] > 2200 || v[1] < 1 || v[1] > 12 || v[2] < 1 || v[2] > 31 ||
        orr_time_from_civil(&c, ORR_SCALE_GPS, NULL, &t) != ORR_OK)
        return false;
    *mjd = orr_mjd_from_date(c.year, c.month, c.day);
    return true;
}

static const char *const known_fields[] = {"week", "dow", "yyyy", "yy",   "doy",      "mm",
                                           "dd",   "hh",  "ssss", "SSSS", "SSSSSSSSS"};

static bool template_is_sound(const char *t)
{
    for (const char *p = t; *p != '\0'; p++) {
        if (*p == '}') return false;
        if (*p != '{') continue;
        const char *end = strchr(p, '}');
        if (end == NULL) return false;
        bool known = false;
        for (size_t i = 0; i < sizeof known_fields / sizeof known_fields[0]; i++)
            known |= same(known_fields[i], p + 1, (size_t)(end - p - 1));
        if (!known) return false;
        p = end;
    }
    return true;
}

static orr_status read_name(table_reader *r, orr_view rest)
{
    orr_view w[6];
    name_rule n = {0};
    for (int i = 0; i < 6; i++)
        if (!orr_view_word(&rest, &w[i]))
            return bad(r, "expected: name PRODUCT CENTRE TIER FROM UNTIL TEMPLATE");
    if (!orr_product_parse(w[0].p, w[0].n, &n.product)) return bad(r, "the product is not known");
    if (!copy_word(w[1], n.centre, sizeof n.centre)) return bad(r, "the centre's name is too long");
    if (!orr_tier_parse(w[2].p, w[2].n, &n.tier))
        return bad(r, "the tier is none of final, rapid, ultra, predicted, -");
    if (!day(w[3], INT32_MIN, &n.from_mjd) || !day(w[4], INT32_MAX, &n.until_mjd))
        return bad(r, "a date is malformed");
    if (!copy_word(w[5], n.template, sizeof n.template)) return bad(r, "the template is too long");
    if (!template_is_sound(n.template) || strchr(n.template, '/') != NULL)
        return bad(r, "the template has an unknown {field}, a brace too many or a slash");
    orr_view option;
    while (orr_view_word(&rest, &option)) {
        int64_t h;
        if (orr_view_equals(option, "start=week"))
            n.week_start = true;
        else if (orr_view_equals(option, "start=name") && n.from_mjd != INT32_MIN)
            n.name_start = true;
        else if (orr_view_starts(option, "shift=") &&
                 orr_view_int((orr_view){option.p + 6, option.n - 6}, &h) == ORR_FIELD_OK && h >= -240 &&
                 h <= 240)
            n.shift_h = (int)h;
        else
            return bad(r, "expected start=week, start=name (where FROM is a day) or shift=HOURS");
    }
    orr_status s = orr_records_grow(&r->a->name, r->a->n_names, sizeof n, MAX_LINES, "names", &r->c, r->diag);
    if (s == ORR_OK) r->a->name[r->a->n_names++] = n;
    return s;
}

static orr_status read_mirror(table_reader *r, orr_view rest)
{
    orr_view w[3], option;
    mirror_rule m = {0};
    for (int i = 0; i < 3; i++)
        if (!orr_view_word(&rest, &w[i])) return bad(r, "expected: mirror NAME PRODUCTS FOLDER");
    if (!copy_word(w[0], m.name, sizeof m.name)) return bad(r, "the mirror's name is too long");
    if (orr_view_equals(w[1], "*")) {
        m.products = ~0U;
    } else {
        orr_view list = w[1], word;
        while (orr_view_split(&list, ',', &word)) {
            orr_product p;
            if (!orr_product_parse(word.p, word.n, &p)) return bad(r, "a product of the mirror is not known");
            m.products |= 1U << p;
        }
    }
    if (!copy_word(w[2], m.folder, sizeof m.folder) || strstr(m.folder, "://") == NULL)
        return bad(r, "the mirror's folder is no URL, or too long");
    if (!template_is_sound(m.folder))
        return bad(r, "the mirror's folder has an unknown {field} or a brace too many");
    while (orr_view_word(&rest, &option)) {
        bool centres = orr_view_starts(option, "centres="), tier = orr_view_starts(option, "tiers=");
        size_t skip = centres ? 8 : 6;
        if (orr_view_equals(option, "login")) {
            m.login = true;
        } else if ((centres || tier) && option.n - skip + 3 <= sizeof m.centres) {
            char *out = centres ? m.centres : m.tiers;
            snprintf(out, sizeof m.centres, ",%.*s,", (int)(option.n - skip), option.p + skip);
        } else {
            return bad(r, "expected centres=..., tiers=... or login");
        }
    }
    orr_status s =
        orr_records_grow(&r->a->mirror, r->a->n_mirrors, sizeof m, MAX_LINES, "mirrors", &r->c, r->diag);
    if (s == ORR_OK) r->a->mirror[r->a->n_mirrors++] = m;
    return s;
}

static orr_status read_station(table_reader *r, orr_view rest)
{
    orr_view w;
    bool sound = orr_view_word(&rest, &w) && w.n == 9;
    for (size_t i = 0; sound && i < w.n; i++) sound = isalnum((unsigned char)w.p[i]) != 0;
    if (!sound) return bad(r, "expected: station and nine letters or digits");
    orr_status s = orr_records_grow(&r->a->station, r->a->n_stations, sizeof *r->a->station, MAX_LINES,
                                    "stations", &r->c, r->diag);
    if (s == ORR_OK) orr_view_copy(w, r->a->station[r->a->n_stations++], sizeof *r->a->station);
    return s;
}

orr_status orr_archives_parse(const char *name, const char *text, size_t n, orr_archives **out,
                              orr_diag *diag)
{
    *out = NULL;
    table_reader r = {.diag = diag, .a = calloc(1, sizeof *r.a)};
    if (r.a == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the table of archives");
    orr_cursor_init(&r.c, name, text, n);
    orr_view line, word;
    orr_status s = ORR_OK;
    while (s == ORR_OK && orr_cursor_next(&r.c, &line)) {
        if (!orr_view_word(&line, &word) || word.p[0] == '#') continue;
        if (orr_view_equals(word, "name"))
            s = read_name(&r, line);
        else if (orr_view_equals(word, "mirror"))
            s = read_mirror(&r, line);
        else if (orr_view_equals(word, "station"))
            s = read_station(&r, line);
        else
            s = bad(&r, "a line starts with name, mirror, station or #");
    }
    if (s == ORR_OK) s = orr_cursor_status(&r.c, diag);
    if (s == ORR_OK && (r.a->n_names == 0 || r.a->n_mirrors == 0))
        s = orr_cursor_error(&r.c, diag, ORR_E_FORMAT, 0, "the table has no name or no mirror");
    if (s != ORR_OK) {
        orr_archives_free(r.a);
        return s;
    }
    *out = r.a;
    return ORR_OK;
}

orr_status orr_archives_read(const char *path, orr_archives **out, orr_diag *diag)
{
    if (path == NULL) {
        size_t n;
        const char *text = orr_archives_builtin(&n);
        return orr_archives_parse("built-in table of archives", text, n, out, diag);
    }
    orr_bytes b;
    struct stat st;
    if (stat(path, &st) == 0 && S_ISREG(st.st_mode) && st.st_size > TABLE_MAX_BYTES)
        return orr_diag_at(diag, ORR_E_LIMIT, path, 0, 0,
                           "has %lld bytes; a table of archives has %d at most", (long long)st.st_size,
                           TABLE_MAX_BYTES);
    orr_status s = orr_records_load(path, NULL, 0, &b, diag);
    if (s != ORR_OK) return s;
    s = orr_archives_parse(path, b.text, b.n, out, diag);
    orr_bytes_free(&b);
    return s;
}

void orr_archives_free(orr_archives *a)
{
    if (a == NULL) return;
    free(a->name);
    free(a->mirror);
    free(a->station);
    free(a);
}

// ---- names ----

typedef struct fields {
    int32_t mjd;
    int hour;
    const char *station4, *station9; // NULL: not known
} fields;

static bool expand(const char *template, const fields *f, char *out, size_t n)
{
    int year, month, day_of_month;
    orr_date_from_mjd(f->mjd, &year, &month, &day_of_month);
    int32_t days = f->mjd - orr_mjd_from_date(1980, 1, 6); // GPS days
    size_t at = 0;
    for (const char *p = template; *p != '\0'; p++) {
        char text[16] = {*p, '\0'};
        if (*p == '{') {
            const char *end = strchr(p, '}'); // checked when the table was read
            size_t len = (size_t)(end - p - 1);
            const char *word = p + 1;
            if (same("week", word, len))
                snprintf(text, sizeof text, "%04d", days / 7);
            else if (same("dow", word, len))
                snprintf(text, sizeof text, "%d", days % 7);
            else if (same("yyyy", word, len))
                snprintf(text, sizeof text, "%04d", year);
            else if (same("yy", word, len))
                snprintf(text, sizeof text, "%02d", year % 100);
            else if (same("doy", word, len))
                snprintf(text, sizeof text, "%03d", orr_day_of_year(year, month, day_of_month));
            else if (same("mm", word, len))
                snprintf(text, sizeof text, "%02d", month);
            else if (same("dd", word, len))
                snprintf(text, sizeof text, "%02d", day_of_month);
            else if (same("hh", word, len))
                snprintf(text, sizeof text, "%02d", f->hour);
            else if (len == 9) {
                if (f->station9 == NULL) return false;
                snprintf(text, sizeof text, "%s", f->station9);
            } else {
                if (f->station4 == NULL) return false;
                snprintf(text, sizeof text, "%.4s", f->station4);
                for (char *c = text; *c != '\0'; c++)
                    *c = (char)(word[0] == 's' ? tolower((unsigned char)*c) : toupper((unsigned char)*c));
            }
            p = end;
        }
        size_t len = strlen(text);
        if (at + len >= n) return false;
        memcpy(out + at, text, len + 1);
        at += len;
    }
    return at > 0;
}

static bool listed(const char *list, const char *word)
{
    char key[24];
    if (list[0] == '\0') return true;
    snprintf(key, sizeof key, ",%s,", word);
    return strstr(list, key) != NULL;
}

typedef struct candidates {
    size_t n;
    orr_candidate *item;
} candidates;

static orr_status add(const orr_archives *a, const name_rule *rule, const fields *f, candidates *out,
                      orr_diag *diag)
{
    orr_candidate c = {.tier = rule->tier, .folder_mjd = f->mjd};
    snprintf(c.centre, sizeof c.centre, "%s", rule->centre);
    if (!expand(rule->template, f, c.name, sizeof c.name))
        return ORR_OK; // the station's long name is not known
    for (size_t i = 0; i < a->n_mirrors; i++) {
        const mirror_rule *m = &a->mirror[i];
        char folder[384];
        if ((m->products & 1U << rule->product) == 0 || !listed(m->tiers, orr_tier_name(rule->tier)) ||
            !listed(m->centres, rule->centre) || !expand(m->folder, f, folder, sizeof folder))
            continue;
        int n = snprintf(c.url, sizeof c.url, "%s%s%s", folder, folder[strlen(folder) - 1] == '/' ? "" : "/",
                         c.name);
        if (n < 0 || (size_t)n >= sizeof c.url) continue;
        snprintf(c.mirror, sizeof c.mirror, "%s", m->name);
        c.mirror_index = (int)i;
        c.login = m->login;
        if (!ORR_ARRAY_GROW(out->item, out->n))
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for more than %zu places of a file", out->n);
        out->item[out->n++] = c;
    }
    return ORR_OK;
}

orr_status orr_archives_candidates(const orr_archives *a, const orr_wanted *w, orr_candidate **out, size_t *n,
                                   orr_diag *diag)
{
    candidates found = {0};
    fields f = {0};
    char station9[10] = "";
    if (w->station[0] != '\0') {
        f.station4 = w->station;
        if (strlen(w->station) == 9) f.station9 = w->station;
        for (size_t i = 0; f.station9 == NULL && i < a->n_stations; i++) {
            bool match = true;
            for (int k = 0; k < 4 && match; k++)
                match = toupper((unsigned char)w->station[k]) == toupper((unsigned char)a->station[i][k]);
            if (match) f.station9 = a->station[i];
        }
        if (f.station9 != NULL) {
            snprintf(station9, sizeof station9, "%s", f.station9);
            for (char *c = station9; *c != '\0'; c++) *c = (char)toupper((unsigned char)*c);
            f.station9 = station9;
        }
    }
    orr_status s = ORR_OK;
    for (int tier = (int)w->tier; s == ORR_OK && tier <= ORR_TIER_NONE; tier++) {
        for (size_t i = 0; s == ORR_OK && i < a->n_names; i++) {
            const name_rule *rule = &a->name[i];
            if (rule->product != w->product || (int)rule->tier != tier || w->mjd < rule->from_mjd ||
                w->mjd > rule->until_mjd)
                continue;
            if (w->centre[0] != '\0' && strcmp(rule->centre, "-") != 0 &&
                strcmp(rule->centre, w->centre) != 0)
                continue;
            int hours = rule->shift_h, days = 0;
            while (hours < 0) hours += 24, days--;
            f.mjd = w->mjd + days + hours / 24;
            f.hour = hours % 24;
            if (rule->week_start) f.mjd -= (f.mjd - orr_mjd_from_date(1980, 1, 6)) % 7;
            if (rule->name_start) f.mjd = rule->from_mjd;
            s = add(a, rule, &f, &found, diag);
        }
    }
    if (s == ORR_OK && found.n == 0)
        s = orr_diag_set(diag, ORR_E_NODATA, "no name or mirror is known for %s%s%s of that day%s%s",
                         orr_product_name(w->product), w->station[0] != '\0' ? ":" : "", w->station,
                         w->centre[0] != '\0' ? " and centre " : "", w->centre);
    if (s != ORR_OK) {
        free(found.item);
        return s;
    }
    *out = found.item;
    *n = found.n;
    return ORR_OK;
}

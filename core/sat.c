// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sat.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

static int system_index(char system)
{
    const char *p = system != '\0' ? strchr(ORR_SYSTEMS, system) : NULL;
    return p != NULL ? (int)(p - ORR_SYSTEMS) : -1;
}

static char upper(char c) { return (char)toupper((unsigned char)c); }
static bool digit(char c) { return c >= '0' && c <= '9'; }

orr_sat orr_sat_make(char system, int number)
{
    int index = system_index(system);
    if (index < 0 || number < 1 || number > 99) return ORR_SAT_NONE;
    return (orr_sat)((index + 1) << 8 | number);
}

char orr_sat_system(orr_sat s)
{
    int index = orr_sat_system_index(s);
    return index >= 0 && index < ORR_N_SYSTEMS ? ORR_SYSTEMS[index] : '?';
}

const char *orr_system_name(char system)
{
    static const char *const names[ORR_N_SYSTEMS] = {"GPS",  "GLONASS", "Galileo", "BeiDou",
                                                     "QZSS", "NavIC",   "SBAS",    "LEO"};
    int index = system_index(system);
    return index >= 0 ? names[index] : "?";
}

orr_sat orr_sat_parse3(const char s[3], char blank_system)
{
    char system = s[0] == ' ' ? blank_system : s[0];
    int tens = s[1] == ' ' ? 0 : digit(s[1]) ? s[1] - '0' : -1;
    if (tens < 0 || !digit(s[2])) return ORR_SAT_NONE;
    return orr_sat_make(system, 10 * tens + (s[2] - '0'));
}

// Number of one or two digits at *p, moved on; 0 if there is none or a third digit follows.
static int take_number(const char **p)
{
    int n = 0, digits = 0;
    while (digit(**p)) {
        if (++digits > 2) return 0;
        n = 10 * n + (*(*p)++ - '0');
    }
    return n;
}

orr_sat orr_sat_parse(const char *text)
{
    if (text[0] == '\0') return ORR_SAT_NONE;
    const char *p = text + 1;
    int number = take_number(&p);
    return *p == '\0' ? orr_sat_make(upper(text[0]), number) : ORR_SAT_NONE;
}

char *orr_sat_text(orr_sat s, char buf[ORR_SAT_TEXT])
{
    if (s == ORR_SAT_NONE || orr_sat_system(s) == '?')
        memcpy(buf, "---", 4);
    else
        snprintf(buf, ORR_SAT_TEXT, "%c%02d", orr_sat_system(s), orr_sat_number(s));
    return buf;
}

void orr_sat_set_add(orr_sat_set *set, orr_sat s)
{
    int index = orr_sat_system_index(s), n = orr_sat_number(s);
    if (index >= 0 && index < ORR_N_SYSTEMS && n < 128) set->bit[index][n / 64] |= UINT64_C(1) << (n % 64);
}

bool orr_sat_set_has(const orr_sat_set *set, orr_sat s)
{
    int index = orr_sat_system_index(s), n = orr_sat_number(s);
    return index >= 0 && index < ORR_N_SYSTEMS && n < 128 && (set->bit[index][n / 64] >> (n % 64) & 1) != 0;
}

static void add_range(orr_sat_set *set, char system, int from, int to)
{
    for (int n = from; n <= to; n++) orr_sat_set_add(set, orr_sat_make(system, n));
}

// One item of the list, [p, end): "all", "G", "G05", "G01-G09" or "G01-09".
static bool add_item(const char *p, const char *end, orr_sat_set *set)
{
    char item[16];
    size_t len = (size_t)(end - p);
    if (len == 0 || len >= sizeof item) return false;
    for (size_t i = 0; i < len; i++) item[i] = upper(p[i]);
    item[len] = '\0';
    if (strcmp(item, "ALL") == 0) {
        for (int i = 0; i < ORR_N_SYSTEMS; i++) add_range(set, ORR_SYSTEMS[i], 1, 99);
        return true;
    }
    char system = item[0];
    if (system_index(system) < 0) return false;
    const char *q = item + 1;
    if (*q == '\0') {
        add_range(set, system, 1, 99);
        return true;
    }
    int from = take_number(&q), to = from;
    if (*q == '-') {
        q++;
        if (*q == system) q++;
        to = take_number(&q);
    }
    if (*q != '\0' || from < 1 || to < from) return false;
    add_range(set, system, from, to);
    return true;
}

orr_status orr_sat_set_parse(const char *text, orr_sat_set *out, orr_diag *diag)
{
    orr_sat_set set = {0};
    for (const char *p = text;;) {
        while (*p == ' ') p++;
        const char *comma = strchr(p, ',');
        const char *end = comma != NULL ? comma : p + strlen(p);
        const char *stop = end;
        while (stop > p && stop[-1] == ' ') stop--;
        if (!add_item(p, stop, &set))
            return orr_diag_set(
                diag, ORR_E_ARG,
                "\"%.*s\" in the satellite list \"%.80s\" is neither a satellite (G05), nor a range "
                "(E01-E09), nor a system (one of %s), nor \"all\"",
                (int)(stop - p > 20 ? 20 : stop - p), p, text, ORR_SYSTEMS);
        if (comma == NULL) break;
        p = comma + 1;
    }
    *out = set;
    return ORR_OK;
}

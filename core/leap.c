// SPDX-License-Identifier: GPL-3.0-or-later
// The leap second table: built in, or read from the IERS file.
#include "core/leap.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// IERS Bulletin C; TAI - UTC of the leap-seconds.list that IERS serves.
static const orr_leap_entry BUILTIN[] = {
    {41317, 10}, // 1972-01-01
    {41499, 11}, // 1972-07-01
    {41683, 12}, // 1973-01-01
    {42048, 13}, // 1974-01-01
    {42413, 14}, // 1975-01-01
    {42778, 15}, // 1976-01-01
    {43144, 16}, // 1977-01-01
    {43509, 17}, // 1978-01-01
    {43874, 18}, // 1979-01-01
    {44239, 19}, // 1980-01-01
    {44786, 20}, // 1981-07-01
    {45151, 21}, // 1982-07-01
    {45516, 22}, // 1983-07-01
    {46247, 23}, // 1985-07-01
    {47161, 24}, // 1988-01-01
    {47892, 25}, // 1990-01-01
    {48257, 26}, // 1991-01-01
    {48804, 27}, // 1992-07-01
    {49169, 28}, // 1993-07-01
    {49534, 29}, // 1994-07-01
    {50083, 30}, // 1996-01-01
    {50630, 31}, // 1997-07-01
    {51179, 32}, // 1999-01-01
    {53736, 33}, // 2006-01-01
    {54832, 34}, // 2009-01-01
    {56109, 35}, // 2012-07-01
    {57204, 36}, // 2015-07-01
    {57754, 37}, // 2017-01-01
};

static const orr_leap_table TABLE = {
    .n = sizeof BUILTIN / sizeof BUILTIN[0],
    .entry = BUILTIN,
    .expires_mjd = 61402, // 2026-12-28
};

const orr_leap_table *orr_leap_builtin(void) { return &TABLE; }

#define MAX_ENTRIES 1000
#define NTP_EPOCH_MJD 15020 // 1900-01-01

static orr_status add_entry(orr_leap_table *t, orr_leap_entry *entry, const char *path, int64_t line,
                            long long ntp_s, long long tai_utc, orr_diag *diag)
{
    if (t->n == MAX_ENTRIES)
        return orr_diag_at(diag, ORR_E_LIMIT, path, line, 1, "more than %d leap seconds", MAX_ENTRIES);
    if (ntp_s < 0 || ntp_s % ORR_S_PER_DAY != 0 || ntp_s / ORR_S_PER_DAY > 200000)
        return orr_diag_at(diag, ORR_E_FORMAT, path, line, 1, "%lld NTP seconds is no start of a day", ntp_s);
    orr_leap_entry e = {(int32_t)(NTP_EPOCH_MJD + ntp_s / ORR_S_PER_DAY), (int32_t)tai_utc};
    if (tai_utc < 0 || tai_utc > 1000)
        return orr_diag_at(diag, ORR_E_FORMAT, path, line, 1, "TAI - UTC of %lld s is not credible", tai_utc);
    if (t->n > 0) {
        const orr_leap_entry *last = &entry[t->n - 1];
        int step = e.tai_minus_utc_s - last->tai_minus_utc_s;
        if (e.mjd <= last->mjd || (step != 1 && step != -1))
            return orr_diag_at(
                diag, ORR_E_FORMAT, path, line, 1,
                "each line must be later than the one before and change TAI - UTC by one second");
    }
    entry[t->n++] = e;
    return ORR_OK;
}

// One line "NTP-seconds  TAI-UTC  # comment", or "#@ NTP-seconds", the expiry; other '#' lines are talk.
static orr_status read_line(orr_leap_table *t, orr_leap_entry *entry, const char *path, int64_t line,
                            const char *s, orr_diag *diag)
{
    long long ntp_s, tai_utc;
    char rest;
    s += strspn(s, " \t\r\n");
    if (s[0] == '#' && s[1] == '@') {
        if (sscanf(s + 2, "%lld %c", &ntp_s, &rest) != 1 || ntp_s < 0 || ntp_s / ORR_S_PER_DAY > 200000)
            return orr_diag_at(diag, ORR_E_FORMAT, path, line, 3,
                               "no NTP seconds of the expiry after \"#@\"");
        t->expires_mjd = (int32_t)(NTP_EPOCH_MJD + ntp_s / ORR_S_PER_DAY);
        return ORR_OK;
    }
    if (s[0] == '#' || s[0] == '\0') return ORR_OK;
    int n = sscanf(s, "%lld %lld %c", &ntp_s, &tai_utc, &rest);
    if (n < 2 || (n == 3 && rest != '#'))
        return orr_diag_at(diag, ORR_E_FORMAT, path, line, 1, "expected \"NTP-seconds TAI-UTC # comment\"");
    return add_entry(t, entry, path, line, ntp_s, tai_utc, diag);
}

orr_status orr_leap_read(const char *path, orr_leap_table *out, orr_diag *diag)
{
    *out = (orr_leap_table){0};
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    orr_leap_entry *entry = calloc(MAX_ENTRIES, sizeof *entry);
    orr_status status =
        entry == NULL ? orr_diag_set(diag, ORR_E_MEMORY, "no memory for a leap table") : ORR_OK;
    orr_leap_table t = {0};
    char text[512];
    for (int64_t line = 1; status == ORR_OK && fgets(text, sizeof text, f) != NULL; line++) {
        if (strchr(text, '\n') == NULL && strlen(text) + 1 == sizeof text)
            status = orr_diag_at(diag, ORR_E_KIND, path, line, 1,
                                 "a line of more than 510 bytes: no leap-seconds.list");
        else
            status = read_line(&t, entry, path, line, text, diag);
    }
    if (status == ORR_OK && ferror(f))
        status = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read: %s", strerror(errno));
    fclose(f);
    if (status == ORR_OK && t.n == 0)
        status = orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "holds no leap second: no leap-seconds.list");
    if (status == ORR_OK && t.expires_mjd == 0)
        status = orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "has no \"#@\" line that says when it expires");
    if (status != ORR_OK) {
        free(entry);
        return status;
    }
    t.entry = entry;
    *out = t;
    return ORR_OK;
}

orr_status orr_leap_choose(const char *path, orr_leap_table *out, orr_diag *diag)
{
    static const char *const system[] = {"/usr/share/zoneinfo/leap-seconds.list",
                                         "/usr/share/zoneinfo/posix/leap-seconds.list"};
    if (path != NULL) return orr_leap_read(path, out, diag);
    for (size_t i = 0; i < sizeof system / sizeof *system; i++) {
        if (orr_leap_read(system[i], out, NULL) != ORR_OK) continue;
        if (out->expires_mjd > TABLE.expires_mjd) return ORR_OK;
        orr_leap_free(out);
    }
    *out = TABLE;
    return ORR_OK;
}

void orr_leap_free(orr_leap_table *t)
{
    if (t == NULL) return;
    if (t->entry != BUILTIN) free((void *)t->entry); // the cast ends the const of our own allocation
    *t = (orr_leap_table){0};
}

int64_t orr_leap_entry_start(const orr_leap_table *leap, size_t i)
{
    return (int64_t)leap->entry[i].mjd * ORR_S_PER_DAY + leap->entry[i].tai_minus_utc_s;
}

size_t orr_leap_index_tai(const orr_leap_table *leap, int64_t tai_s)
{
    size_t i = leap->n - 1; // the last entry is the usual answer
    while (i > 0 && tai_s < orr_leap_entry_start(leap, i)) i--;
    return i;
}

int orr_leap_of_day(const orr_leap_table *leap, int32_t mjd)
{
    size_t i = leap->n - 1;
    while (i > 0 && mjd < leap->entry[i].mjd) i--;
    return leap->entry[i].tai_minus_utc_s;
}

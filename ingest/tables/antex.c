// SPDX-License-Identifier: GPL-3.0-or-later
// ANTEX reader: header and the walk over antennas. One antenna's lines are read in antex_antenna.c; one that
// makes no sense is reported and left out.
#include "ingest/tables/antex.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/input/sniff.h"
#include "ingest/input/text_records.h"
#include "ingest/tables/antex_private.h"

static void free_antenna(orr_antex_antenna *a)
{
    for (size_t i = 0; i < a->n_frequencies; i++) free(a->frequency[i].pattern_m);
    free(a->frequency);
    *a = (orr_antex_antenna){0};
}

void orr_antex_free(orr_antex *x)
{
    if (x == NULL) return;
    for (size_t i = 0; i < x->n_antennas; i++) free_antenna(&x->antenna[i]);
    free(x->antenna);
    *x = (orr_antex){0};
}

static orr_status read_header(antex_reader *r)
{
    orr_antex *x = r->out;
    orr_view line;
    bool first = true;
    while (orr_cursor_next(&r->c, &line)) {
        if (first && orr_view_is_blank(line)) continue;
        orr_view label = orr_records_label(line);
        if (first) {
            if (!orr_records_label_is(label, "ANTEX VERSION / SYST"))
                return orr_cursor_error(
                    &r->c, r->diag, ORR_E_KIND, 61,
                    "not an ANTEX file: the first line has no label ANTEX VERSION / SYST");
            if (orr_field_real(line, 1, 8, &x->version) != ORR_FIELD_OK)
                return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "the ANTEX version is no number");
            if (!(x->version > 1.25 && x->version < 2.0))
                return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 1,
                                        "ANTEX version %.1f is not known (1.3 and 1.4 are)", x->version);
            x->system = orr_view_char(line, 21);
            if (x->system == ' ') x->system = 'G';
            x->pcv_type = 'A';
            first = false;
        } else if (orr_records_label_is(label, "PCV TYPE / REFANT")) {
            x->pcv_type = orr_view_char(line, 1);
            if (x->pcv_type != 'A' && x->pcv_type != 'R')
                return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                        "values are neither absolute (A) nor relative (R)");
            orr_view_copy(orr_view_trim(orr_view_cols(line, 21, 20)), x->reference, sizeof x->reference);
        } else if (orr_records_label_is(label, "END OF HEADER")) {
            return ORR_OK;
        } else if (orr_records_label_is(label, "START OF ANTENNA")) {
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 61,
                                    "an antenna starts before END OF HEADER");
        } else if (!orr_records_label_is(label, "COMMENT") && !orr_view_is_blank(line)) {
            char shown[24];
            orr_cursor_warn(&r->c, r->warnings, 61,
                            "header label \"%s\" is not known; the line is passed over",
                            orr_view_copy(label, shown, sizeof shown));
        }
    }
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    return orr_cursor_error(&r->c, r->diag, first ? ORR_E_KIND : ORR_E_FORMAT, 0,
                            first ? "the file is empty"
                                  : "the file ends inside the header (no END OF HEADER)");
}

// Reads one antenna; a complaint about its lines becomes a warning and the walk goes on behind its END OF
// ANTENNA.
static orr_status one_antenna(antex_reader *r)
{
    orr_antex *x = r->out;
    orr_status s = orr_records_grow(&x->antenna, x->n_antennas, sizeof *x->antenna, r->limits.max_records,
                                    "antennas", &r->c, r->diag);
    if (s != ORR_OK) return s;
    int64_t start = r->c.line;
    orr_antex_antenna a = {0};
    orr_diag why = {0};
    size_t values = r->values;
    s = antex_read_antenna(r, &a, &why);
    if (s == ORR_OK) {
        x->n_satellites += a.sat != ORR_SAT_NONE;
        x->antenna[x->n_antennas++] = a;
        return ORR_OK;
    }
    char name[64];
    snprintf(name, sizeof name, "%s %s", a.type, a.serial);
    free_antenna(&a);
    r->values = values;
    if (s != ORR_E_FORMAT || r->ended) { // limits, memory, the end of the file: not this antenna's own fault
        if (r->diag != NULL) *r->diag = why;
        return s;
    }
    r->left_out++;
    if (r->first_reason.text[0] == '\0') r->first_reason = why;
    orr_warnings_add(r->warnings, r->c.name, why.line, why.column, "%s; antenna %s of line %lld is left out",
                     why.text, name, (long long)start);
    if (r->at_end_of_antenna) return ORR_OK;
    orr_view line;
    while (orr_cursor_next(&r->c, &line))
        if (orr_records_label_is(orr_records_label(line), "END OF ANTENNA")) return ORR_OK;
    s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                            "the file ends inside the antenna of line %lld: it is cut short",
                            (long long)start);
}

static orr_status read_antennas(antex_reader *r)
{
    orr_view line;
    while (orr_cursor_next(&r->c, &line)) {
        orr_view label = orr_records_label(line);
        orr_status s = ORR_OK;
        if (orr_view_is_blank(line) || orr_records_label_is(label, "COMMENT")) continue;
        if (orr_records_label_is(label, "START OF ANTENNA"))
            s = one_antenna(r);
        else
            s = orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 61, "expected START OF ANTENNA");
        if (s != ORR_OK) return s;
    }
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK || r->out->n_antennas > 0) return s;
    if (r->left_out > 0) { // nothing is left: the first complaint is the verdict
        if (r->diag != NULL) *r->diag = r->first_reason;
        return ORR_E_FORMAT;
    }
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the file has no antenna");
}

orr_status orr_antex_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                           orr_antex *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_antex){0};
    antex_reader r = {.out = out, .warnings = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    orr_cursor_init(&r.c, name, text, n);
    orr_status s = read_header(&r);
    if (s == ORR_OK) s = read_antennas(&r);
    if (s != ORR_OK) orr_antex_free(out);
    return s;
}

orr_status orr_antex_read(const char *path, const orr_read_limits *limits, orr_antex *out,
                          orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_antex){0};
    orr_bytes b;
    orr_status s = orr_records_load(path, limits, ORR_KIND_BIT(ORR_KIND_ANTEX), &b, diag);
    if (s != ORR_OK) return s;
    s = orr_antex_parse(path, b.text, b.n, limits, out, warnings, diag);
    orr_bytes_free(&b);
    return s;
}

const orr_antex_antenna *orr_antex_find_sat(const orr_antex *x, orr_sat sat, orr_time t)
{
    for (size_t i = 0; i < x->n_antennas; i++) {
        const orr_antex_antenna *a = &x->antenna[i];
        if (sat == ORR_SAT_NONE || a->sat != sat) continue;
        if (a->valid_from != ORR_TIME_NONE && t < a->valid_from) continue;
        if (a->valid_until != ORR_TIME_NONE && t > a->valid_until) continue;
        return a;
    }
    return NULL;
}

// Type (16 characters) and radome (columns 17-20, NONE when blank).
static bool type_matches(const char *in_file, const char *asked, bool any_radome)
{
    char a[21], b[21];
    snprintf(a, sizeof a, "%-20.20s", in_file);
    snprintf(b, sizeof b, "%-20.20s", asked);
    if (memcmp(b + 16, "    ", 4) == 0) memcpy(b + 16, "NONE", 4);
    if (memcmp(a + 16, "    ", 4) == 0) memcpy(a + 16, "NONE", 4);
    if (any_radome) memcpy(b + 16, "NONE", 4);
    return memcmp(a, b, 20) == 0;
}

const orr_antex_antenna *orr_antex_find_receiver(const orr_antex *x, const char *type, bool *radome_ignored)
{
    for (int any = 0; any < 2; any++) {
        for (size_t i = 0; i < x->n_antennas; i++) {
            const orr_antex_antenna *a = &x->antenna[i];
            if (a->sat != ORR_SAT_NONE || !type_matches(a->type, type, any != 0)) continue;
            if (radome_ignored != NULL) *radome_ignored = any != 0;
            return a;
        }
    }
    return NULL;
}

const orr_antex_frequency *orr_antex_find_frequency(const orr_antex_antenna *a, const char *code)
{
    for (size_t i = 0; i < a->n_frequencies; i++)
        if (strcmp(a->frequency[i].code, code) == 0) return &a->frequency[i];
    return NULL;
}

double orr_antex_variation_m(const orr_antex_antenna *a, const orr_antex_frequency *f, double az_deg,
                             double zen_deg)
{
    if (a->n_zeniths == 0) return 0.0;
    double z = a->n_zeniths > 1 ? (zen_deg - a->zen1_deg) / a->dzen_deg : 0.0;
    if (!(z > 0)) z = 0;
    if (z > (double)(a->n_zeniths - 1)) z = (double)(a->n_zeniths - 1);
    size_t iz = (size_t)z;
    if (iz + 1 >= a->n_zeniths && iz > 0) iz--;
    double fz = z - (double)iz;
    size_t jz = a->n_zeniths > 1 ? iz + 1 : iz;
    const double *low = f->pattern_m, *high = f->pattern_m;
    double fa = 0;
    if (a->n_azimuths > 1 && isfinite(az_deg)) {
        double az = fmod(az_deg, 360.0);
        if (az < 0) az += 360.0;
        double p = az / a->dazi_deg;
        size_t ia = (size_t)p;
        if (ia > a->n_azimuths - 2) ia = a->n_azimuths - 2;
        fa = p - (double)ia;
        low = f->pattern_m + (1 + ia) * a->n_zeniths;
        high = low + a->n_zeniths;
    }
    double at_low = low[iz] + fz * (low[jz] - low[iz]), at_high = high[iz] + fz * (high[jz] - high[iz]);
    return at_low + fa * (at_high - at_low);
}

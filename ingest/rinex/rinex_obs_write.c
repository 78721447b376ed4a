// SPDX-License-Identifier: GPL-3.0-or-later
// Observation files of RINEX 3.05 (tables A2 and A3) and 4.02 (the same tables).
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "ingest/rinex/rinex_obs_private.h"

struct orr_rinex_obs_writer {
    orr_outfile out;
    double version;
    orr_scale scale;
    const orr_leap_table *leap;
    size_t n_codes[ORR_N_SYSTEMS];
    bool failed;
    char line[3 + 16 * ORR_OBS_MAX_CODES + 2];
};

static void put_header(orr_rinex_obs_writer *w, const char *label, const char *fmt, ...) ORR_PRINTF(3, 4);
static void put_header(orr_rinex_obs_writer *w, const char *label, const char *fmt, ...)
{
    char text[128];
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    if (fprintf(w->out.stream, "%-60.60s%-20.20s\n", text, label) < 0) w->failed = true;
}

static void put_types(orr_rinex_obs_writer *w, char system, const orr_obs_codes *c)
{
    for (size_t i = 0; i < c->n; i += 13) {
        char text[64];
        size_t at = (size_t)(i == 0 ? snprintf(text, sizeof text, "%c  %3zu", system, c->n)
                                    : snprintf(text, sizeof text, "      "));
        for (size_t j = i; j < c->n && j < i + 13; j++)
            at += (size_t)snprintf(text + at, sizeof text - at, " %-3.3s", c->code[j]);
        put_header(w, "SYS / # / OBS TYPES", "%s", text);
    }
}

static void put_phase_shifts(orr_rinex_obs_writer *w, char system, const orr_obs_codes *c)
{
    bool any = false;
    for (size_t j = 0; j < c->n; j++) {
        if (c->code[j][0] != 'L' || isnan(c->phase_shift_cyc[j])) continue;
        put_header(w, "SYS / PHASE SHIFT", "%c %-3.3s %8.5f", system, c->code[j], c->phase_shift_cyc[j]);
        any = true;
    }
    if (!any) put_header(w, "SYS / PHASE SHIFT", "%c", system); // not known
}

static void put_glonass(orr_rinex_obs_writer *w, const orr_rinex_obs_header *h)
{
    int slot[100], n = 0;
    for (int i = 1; i < 100; i++)
        if (h->glonass_channel[i] != ORR_OBS_NO_CHANNEL) slot[n++] = i;
    for (int i = 0; i == 0 || i < n; i += 8) {
        char text[64];
        size_t at =
            (size_t)(i == 0 ? snprintf(text, sizeof text, "%3d ", n) : snprintf(text, sizeof text, "    "));
        for (int j = i; j < n && j < i + 8; j++)
            at += (size_t)snprintf(text + at, sizeof text - at, "R%02d %2d ", slot[j],
                                   h->glonass_channel[slot[j]]);
        put_header(w, "GLONASS SLOT / FRQ #", "%s", text);
    }
    if (w->version >= 4) return;
    char text[64] = "";
    size_t at = 0;
    for (int i = 0; i < 4 && h->has_glonass_bias; i++) {
        const char *code = h->glonass_bias[i].code;
        if (code[0] == '\0')
            at += (size_t)snprintf(text + at, sizeof text - at, "%13s", "");
        else if (isnan(h->glonass_bias[i].bias_m))
            at += (size_t)snprintf(text + at, sizeof text - at, " %-3.3s%9s", code, "");
        else
            at += (size_t)snprintf(text + at, sizeof text - at, " %-3.3s %8.3f", code,
                                   h->glonass_bias[i].bias_m);
    }
    put_header(w, "GLONASS COD/PHS/BIS", "%s", text);
}

static orr_civil civil_100ns(orr_time t, orr_scale scale, const orr_leap_table *leap)
{
    orr_civil c;
    orr_time r = (t >= 0 ? t + 50 : t - 49) / 100 * 100; // seven decimals is what the format has
    orr_time_to_civil(r, scale, leap, &c);
    return c;
}

static void put_time(orr_rinex_obs_writer *w, const char *label, orr_time t)
{
    if (t == ORR_TIME_NONE) return;
    orr_civil c = civil_100ns(t, w->scale, w->leap);
    put_header(w, label, "%6d%6d%6d%6d%6d%5d.%07d     %-3.3s", c.year, c.month, c.day, c.hour, c.minute,
               c.second, (int)(c.ns / 100), orr_scale_name(w->scale));
}

static void put_whole_header(orr_rinex_obs_writer *w, const orr_rinex_obs_header *h)
{
    char systems[] = "X: Mixed";
    systems[0] = h->system;
    put_header(w, "RINEX VERSION / TYPE", "%9.2f%11s%-20s%-20s", w->version, "", "OBSERVATION DATA",
               h->system == 'M' ? systems : (systems[1] = '\0', systems));
    put_header(w, "PGM / RUN BY / DATE", "%-20.20s%-20.20s%-20.20s", h->program, h->run_by, h->date);
    put_header(w, "MARKER NAME", "%s", h->marker_name);
    if (h->marker_number[0] != '\0') put_header(w, "MARKER NUMBER", "%s", h->marker_number);
    if (h->marker_type[0] != '\0') put_header(w, "MARKER TYPE", "%s", h->marker_type);
    put_header(w, "OBSERVER / AGENCY", "%-20.20s%-40.40s", h->observer, h->agency);
    put_header(w, "REC # / TYPE / VERS", "%-20.20s%-20.20s%-20.20s", h->receiver_number, h->receiver_type,
               h->receiver_version);
    put_header(w, "ANT # / TYPE", "%-20.20s%-20.20s", h->antenna_number, h->antenna_type);
    if (h->has_position)
        put_header(w, "APPROX POSITION XYZ", "%14.4f%14.4f%14.4f", h->position_m.x, h->position_m.y,
                   h->position_m.z);
    if (!isnan(h->antenna_h_m))
        put_header(w, "ANTENNA: DELTA H/E/N", "%14.4f%14.4f%14.4f", h->antenna_h_m, h->antenna_e_m,
                   h->antenna_n_m);
    if (!isnan(h->antenna_xyz_m.x))
        put_header(w, "ANTENNA: DELTA X/Y/Z", "%14.4f%14.4f%14.4f", h->antenna_xyz_m.x, h->antenna_xyz_m.y,
                   h->antenna_xyz_m.z);
    if (!isnan(h->centre_of_mass_m.x))
        put_header(w, "CENTER OF MASS: XYZ", "%14.4f%14.4f%14.4f", h->centre_of_mass_m.x,
                   h->centre_of_mass_m.y, h->centre_of_mass_m.z);
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++) put_types(w, ORR_SYSTEMS[s], &h->codes[s]);
    if (h->signal_unit[0] != '\0') put_header(w, "SIGNAL STRENGTH UNIT", "%s", h->signal_unit);
    if (!isnan(h->interval_s)) put_header(w, "INTERVAL", "%10.3f", h->interval_s);
    put_time(w, "TIME OF FIRST OBS", h->first);
    put_time(w, "TIME OF LAST OBS", h->last);
    if (h->clock_applied) put_header(w, "RCV CLOCK OFFS APPL", "%6d", 1);
    for (size_t s = 0; w->version < 4 && s < ORR_N_SYSTEMS; s++)
        if (h->codes[s].n > 0) put_phase_shifts(w, ORR_SYSTEMS[s], &h->codes[s]);
    if (h->codes[1].n > 0) put_glonass(w, h);
    if (h->has_leap) put_header(w, "LEAP SECONDS", "%6d", h->leap_s);
    put_header(w, "END OF HEADER", "%s", "");
}

static orr_status check_header(const orr_rinex_obs_header *h, orr_diag *diag)
{
    size_t n = 0;
    if (h->first == ORR_TIME_NONE)
        return orr_diag_set(diag, ORR_E_ARG, "an observation file needs the time of its first epoch");
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++) {
        const orr_obs_codes *c = &h->codes[s];
        n += c->n;
        for (size_t j = 0; j < c->n; j++)
            if (strlen(c->code[j]) != 3)
                return orr_diag_set(diag, ORR_E_ARG, "observation type %s of %s has no RINEX 3 code",
                                    c->original[j], orr_system_name(ORR_SYSTEMS[s]));
    }
    return n > 0 ? ORR_OK : orr_diag_set(diag, ORR_E_ARG, "an observation file needs observation types");
}

orr_status orr_rinex_obs_create(const char *path, double version, const orr_rinex_obs_header *h,
                                orr_rinex_obs_writer **out, orr_diag *diag)
{
    *out = NULL;
    orr_status s = check_header(h, diag);
    if (s == ORR_OK && version != 3.05 && version != 4.02)
        s = orr_diag_set(diag, ORR_E_ARG, "RINEX %.2f is not written, 3.05 and 4.02 are", version);
    if (s != ORR_OK) return s;
    orr_rinex_obs_writer *w = calloc(1, sizeof *w);
    if (w == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    s = orr_outfile_open(path, &w->out, diag);
    if (s != ORR_OK) {
        free(w);
        return s;
    }
    w->version = version;
    w->scale = h->scale;
    w->leap = h->leap;
    for (size_t i = 0; i < ORR_N_SYSTEMS; i++) w->n_codes[i] = h->codes[i].n;
    put_whole_header(w, h);
    *out = w;
    return ORR_OK;
}

// F14.3; false where it does not fit.
static bool put_f14_3(char *out, double v)
{
    memset(out, ' ', 14);
    if (isnan(v)) return true;
    if (!(v < 9999999999.9995 && v > -999999999.9995)) return false;
    int64_t m = (int64_t)llround(v * 1000);
    uint64_t u = (uint64_t)(m < 0 ? -m : m);
    int i = 14;
    for (int k = 0; k < 4 || u > 0; k++) {
        out[--i] = (char)('0' + u % 10);
        u /= 10;
        if (k == 2) out[--i] = '.';
    }
    if (m < 0) out[--i] = '-';
    return true;
}

static orr_status put_satellite(orr_rinex_obs_writer *w, const orr_rinex_obs_epoch *e, size_t i,
                                orr_diag *diag)
{
    char id[ORR_SAT_TEXT];
    int system = orr_sat_system_index(e->sat[i]);
    size_t n = system >= 0 ? w->n_codes[system] : 0;
    if (n == 0 || n > e->stride)
        return orr_diag_set(diag, ORR_E_ARG, "satellite %s is of a system without observation types",
                            orr_sat_text(e->sat[i], id));
    memcpy(w->line, orr_sat_text(e->sat[i], id), 3);
    size_t at = 3;
    for (size_t j = 0; j < n; j++, at += 16) {
        size_t k = i * e->stride + j;
        if (!put_f14_3(w->line + at, e->value[k]))
            return orr_diag_set(diag, ORR_E_RANGE, "an observation of %s (%g) does not fit into F14.3",
                                orr_sat_text(e->sat[i], id), e->value[k]);
        uint8_t lli = e->lli != NULL ? e->lli[k] : 0, ssi = e->ssi != NULL ? e->ssi[k] : 0;
        w->line[at + 14] = lli > 0 && lli < 10 ? (char)('0' + lli) : ' ';
        w->line[at + 15] = ssi > 0 && ssi < 10 ? (char)('0' + ssi) : ' ';
    }
    while (at > 3 && w->line[at - 1] == ' ') at--;
    w->line[at++] = '\n';
    if (fwrite(w->line, 1, at, w->out.stream) != at) w->failed = true;
    return ORR_OK;
}

orr_status orr_rinex_obs_write(orr_rinex_obs_writer *w, const orr_rinex_obs_epoch *e, orr_diag *diag)
{
    bool event = e->flag >= ORR_OBS_START_MOVING && e->flag <= ORR_OBS_EXTERNAL;
    size_t n = event ? e->n_event_lines : e->n_sats;
    if (e->flag < 0 || e->flag > 6 || n > 999)
        return orr_diag_set(diag, ORR_E_ARG, "an epoch of flag %d with %zu records cannot be written",
                            e->flag, n);
    char head[80];
    if (e->t == ORR_TIME_NONE) {
        if (!event) return orr_diag_set(diag, ORR_E_ARG, "an epoch of observations needs a time");
        snprintf(head, sizeof head, ">%30s%d%3zu", "", e->flag, n);
    } else {
        orr_civil c = civil_100ns(e->t, w->scale, w->leap);
        int at = snprintf(head, sizeof head, "> %04d %02d %02d %02d %02d%3d.%07d  %d%3zu", c.year, c.month,
                          c.day, c.hour, c.minute, c.second, (int)(c.ns / 100), e->flag, n);
        if (!event && !isnan(e->clock_offset_s) && at > 0 && fabs(e->clock_offset_s) < 10)
            snprintf(head + at, sizeof head - (size_t)at, "%6s%15.12f", "", e->clock_offset_s);
    }
    if (fprintf(w->out.stream, "%s\n", head) < 0) w->failed = true;
    for (size_t i = 0; i < n; i++) {
        if (event) {
            if (fprintf(w->out.stream, "%s\n", e->event_line[i]) < 0) w->failed = true;
            continue;
        }
        orr_status s = put_satellite(w, e, i, diag);
        if (s != ORR_OK) return s;
    }
    return w->failed ? orr_diag_set(diag, ORR_E_IO, "%s: the output could not be written", w->out.path)
                     : ORR_OK;
}

orr_status orr_rinex_obs_commit(orr_rinex_obs_writer *w, orr_diag *diag)
{
    orr_status s = ORR_OK;
    if (w->failed) s = orr_diag_set(diag, ORR_E_IO, "%s: the output could not be written", w->out.path);
    s = orr_outfile_end(&w->out, s, diag);
    free(w);
    return s;
}

void orr_rinex_obs_abort(orr_rinex_obs_writer *w)
{
    if (w == NULL) return;
    orr_outfile_abort(&w->out);
    free(w);
}

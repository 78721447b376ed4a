// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files: RINEX 3.05 (tables A5-A18) and 4.02.
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "ingest/rinex/rinex_nav_private.h"

static void put_header(FILE *f, const char *label, const char *fmt, ...) ORR_PRINTF(3, 4);
static void put_header(FILE *f, const char *label, const char *fmt, ...)
{
    char text[128];
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    fprintf(f, "%-60.60s%-20.20s\n", text, label);
}

// Header parameters are written all; of RINEX 4's records the first of each system stands for the file.
static bool iono_wanted(const orr_nav *nav, size_t i)
{
    const orr_nav_iono *k = &nav->iono[i];
    if (k->kind != ORR_NAV_KLOBUCHAR && k->kind != ORR_NAV_NEQUICK_G) return false;
    if (k->message == ORR_NAV_NONE) return true;
    if (k->message != ORR_NAV_LNAV && k->message != ORR_NAV_D1D2 && k->message != ORR_NAV_IFNV) return false;
    for (size_t j = 0; j < i; j++)
        if (nav->iono[j].kind == k->kind && nav->iono[j].system == k->system) return false;
    return true;
}

static void put_iono(FILE *f, const orr_nav_iono *k)
{
    static const char letters[] = "GCJI";
    static const char *const names[] = {"GPS", "BDS", "QZS", "IRN"};
    const double *v = k->coefficient;
    if (k->kind == ORR_NAV_NEQUICK_G) {
        put_header(f, "IONOSPHERIC CORR", "GAL  %12.4E%12.4E%12.4E%12.4E", v[0], v[1], v[2], 0.0);
        return;
    }
    const char *at = strchr(letters, k->system);
    if (at == NULL || k->system == '\0') return;
    char sat[4] = "";
    if (k->sat != ORR_SAT_NONE) snprintf(sat, sizeof sat, "%02d", orr_sat_number(k->sat));
    for (int part = 0; part < 2; part++, v += 4)
        put_header(f, "IONOSPHERIC CORR", "%s%c %12.4E%12.4E%12.4E%12.4E %c %s", names[at - letters],
                   "AB"[part], v[0], v[1], v[2], v[3], k -> time_mark, sat);
}

static void put_sto(FILE *f, const orr_nav *nav, size_t i)
{
    const orr_nav_sto *s = &nav->sto[i];
    for (size_t j = 0; j < i && s->message != ORR_NAV_NONE; j++)
        if (strcmp(nav->sto[j].code, s->code) == 0) return; // one of each stands for the file
    int32_t week = 0;
    int64_t ns = 0;
    bool beidou = s->code[0] == 'B';
    if (s->t_ref != ORR_TIME_NONE) {
        orr_time_week(s->t_ref - (beidou ? ORR_BDT_BEHIND_GPS_NS : 0), &week, &ns);
        if (beidou) week -= ORR_BDT_WEEK_0;
    }
    static const char *const utc[] = {"UTC(NIST)", "UTC(USNO)",       "UTC(SU)",
                                      "UTC(BIPM)", "UTC(Europe Lab)", "UTC(CRL)"};
    char id[12] = "";
    for (int k = 0; k < 6; k++)
        if (strcmp(s->utc_id, utc[k]) == 0) snprintf(id, sizeof id, "%2d", k + 1);
    put_header(f, "TIME SYSTEM CORR", "%-4.4s %17.10E%16.9E %6lld %4d %-5.5s %s", s->code, s->a0_s, s->a1_sps,
               (long long)(ns / ORR_NS_PER_S), (int)week, s->sbas_id, id);
}

// What is to come, or came last, stays blank where it is not known.
static void put_leap(FILE *f, const orr_nav *nav)
{
    char event[40] = "";
    if (nav->leap_week > 0)
        snprintf(event, sizeof event, "%6d%6d%6d", nav->leap_future_s, nav->leap_week, nav->leap_day);
    put_header(f, "LEAP SECONDS", "%6d%-18s%3s", nav->leap_s, event,
               nav->leap_scale == ORR_SCALE_BDT ? "BDS" : "GPS");
}

static bool in_version_4(const orr_nav *nav) { return nav->version >= 4; }

static void put_whole_header(FILE *f, const orr_nav *nav)
{
    char system[] = "M: Mixed";
    if (nav->system != 'M') {
        system[0] = nav->system;
        system[1] = '\0';
    }
    put_header(f, "RINEX VERSION / TYPE", "%9.2f%11s%-20s%-20s", in_version_4(nav) ? 4.02 : 3.05, "",
               "N: GNSS NAV DATA", system);
    put_header(f, "PGM / RUN BY / DATE", "%-20.20s%-20.20s%-20.20s", nav->program, nav->run_by, nav->date);
    for (size_t i = 0; i < nav->n_comments; i++) put_header(f, "COMMENT", "%s", nav->comment[i]);
    for (size_t i = 0; i < nav->n_iono && !in_version_4(nav); i++)
        if (iono_wanted(nav, i)) put_iono(f, &nav->iono[i]);
    for (size_t i = 0; i < nav->n_sto && !in_version_4(nav); i++) put_sto(f, nav, i);
    if (nav->has_leap) put_leap(f, nav);
    put_header(f, "END OF HEADER", "%s", "");
}

orr_status orr_nav_write(const orr_nav *nav, const char *path, size_t *n_left_out, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    size_t left = 0;
    put_whole_header(out.stream, nav);
    if (in_version_4(nav)) left = orr_nav_put_records4(out.stream, nav);
    for (size_t i = 0; i < nav->n_eph && !in_version_4(nav); i++) {
        if (orr_nav_in_version_3(nav->eph[i].message))
            orr_nav_put_eph(out.stream, nav->leap, &nav->eph[i]);
        else
            left++;
    }
    if (n_left_out != NULL) *n_left_out = left;
    return orr_outfile_commit(&out, diag);
}

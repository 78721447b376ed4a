// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/make/sp3_print.h"

#include <stdarg.h>
#include <stdio.h>

#include <zlib.h>

#include "core/outfile.h"

typedef struct printer {
    gzFile z;
    bool bad;
} printer;

static void line(printer *p, const char *fmt, ...) ORR_PRINTF(2, 3);
static void line(printer *p, const char *fmt, ...)
{
    char text[128];
    va_list args;
    va_start(args, fmt);
    int n = vsnprintf(text, sizeof text - 1, fmt, args);
    va_end(args);
    if (n < 0 || n >= (int)sizeof text - 1) {
        p->bad = true;
        return;
    }
    text[n] = '\n';
    if (gzwrite(p->z, text, (unsigned)n + 1) != n + 1) p->bad = true;
}

static const char *const COMMENTS[] = {
    "MADE DATA, NO MEASUREMENT. Orbits integrated by samples/make of Orrery from",
    "invented elements; no satellite stands for the real one of its number.",
    "Forces: EGM96 16x16, Sun, Moon, solid tide k2, Schwarzschild, box-and-wing",
    "radiation pressure with y-bias and conical shadow. Centre of mass.",
    "Earth rotation: IERS secular pole, UT1-UTC = 0, LOD = 0, IAU 2006/2000B.",
    "Clocks: white frequency noise and drift; without the periodic relativity.",
};

static void print_satellites(printer *p, const orr_sample_truth *t)
{
    size_t n = orr_sample_truth_count(t), lines = n <= 85 ? 5 : (n + 16) / 17;
    for (size_t i = 0; i < lines; i++) {
        char list[64], *q = list;
        for (size_t k = 17 * i; k < 17 * (i + 1); k++) {
            char text[ORR_SAT_TEXT] = "  0";
            if (k < n) orr_sat_text(orr_sample_truth_sat(t, k)->sat, text);
            q += sprintf(q, "%3.3s", text);
        }
        if (i == 0)
            line(p, "+  %3zu   %s", n, list);
        else
            line(p, "+        %s", list);
    }
    for (size_t i = 0; i < lines; i++) {
        char list[64], *q = list;
        for (size_t k = 17 * i; k < 17 * (i + 1); k++) q += sprintf(q, "%3d", 0); // accuracy unknown
        line(p, "++       %s", list);
    }
}

static void print_header(printer *p, const orr_sample_truth *t, orr_time from, int interval_s, int n,
                         const char *what)
{
    orr_civil c;
    int32_t week, mjd;
    int64_t ns;
    double fraction;
    orr_time_to_civil(from, ORR_SCALE_GPS, NULL, &c);
    orr_time_week(from, &week, &ns);
    orr_time_mjd(from, ORR_SCALE_GPS, NULL, &mjd, &fraction);
    line(p, "#dP%4d %2d %2d %2d %2d %11.8f %7d  MADE IGS20 FIT  ORR", c.year, c.month, c.day, c.hour,
         c.minute, c.second * 1.0, n);
    line(p, "## %4d %15.8f %14.8f %5d %15.13f", week, (double)ns * 1e-9, interval_s * 1.0, mjd, fraction);
    print_satellites(p, t);
    line(p, "%%c M  cc GPS ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc");
    line(p, "%%c cc cc ccc ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc");
    line(p, "%%f  1.2500000  1.025000000  0.00000000000  0.000000000000000");
    line(p, "%%f  0.0000000  0.000000000  0.00000000000  0.000000000000000");
    line(p, "%%i    0    0    0    0      0      0      0      0         0");
    line(p, "%%i    0    0    0    0      0      0      0      0         0");
    line(p, "/* %s", what);
    for (size_t i = 0; i < sizeof COMMENTS / sizeof COMMENTS[0]; i++) line(p, "/* %s", COMMENTS[i]);
}

// Whether an event of the kind falls between this epoch and the one before: SP3 flags the epoch after it.
static bool since_last_epoch(orr_sample_event_kind kind, orr_sat sat, orr_time at, int interval_s)
{
    orr_sample_event event[ORR_SAMPLE_MAX_EVENTS];
    size_t n = orr_sample_events(event);
    for (size_t i = 0; i < n; i++)
        if (event[i].kind == kind && event[i].sat == sat && event[i].from <= at &&
            event[i].from > at - interval_s * ORR_NS_PER_S)
            return true;
    return false;
}

static orr_status print_epoch(printer *p, const orr_sample_truth *t, orr_time at, int interval_s)
{
    orr_civil c;
    orr_time_to_civil(at, ORR_SCALE_GPS, NULL, &c);
    line(p, "*  %4d %2d %2d %2d %2d %11.8f", c.year, c.month, c.day, c.hour, c.minute, c.second * 1.0);
    for (size_t k = 0; k < orr_sample_truth_count(t); k++) {
        orr_sat sat = orr_sample_truth_sat(t, k)->sat;
        char text[ORR_SAT_TEXT];
        orr_vec3 r;
        double clock;
        orr_status s = orr_sample_truth_at(t, k, at, &r, NULL, &clock);
        if (s != ORR_OK) return s;
        if (!orr_sample_has_position(sat, at)) {
            line(p, "P%s%14.6f%14.6f%14.6f%14.6f", orr_sat_text(sat, text), 0.0, 0.0, 0.0, 999999.999999);
            continue;
        }
        if (!orr_sample_has_clock(sat, at)) clock = 0.999999999999;
        bool burnt = since_last_epoch(ORR_SAMPLE_BURN, sat, at, interval_s);
        bool reset = since_last_epoch(ORR_SAMPLE_RESET, sat, at, interval_s);
        char flags[24] = "";
        if (burnt || reset)
            snprintf(flags, sizeof flags, "%14s%c%3s%s", "", reset ? 'E' : ' ', "", burnt ? "M" : "");
        line(p, "P%s%14.6f%14.6f%14.6f%14.6f%s", orr_sat_text(sat, text), r.x * 1e-3, r.y * 1e-3, r.z * 1e-3,
             clock * 1e6, flags);
    }
    return ORR_OK;
}

orr_status orr_sample_sp3_print(const orr_sample_truth *t, orr_time from, int interval_s, int n,
                                const char *what, const char *path, orr_diag *diag)
{
    orr_outfile f;
    orr_status s = orr_outfile_reserve(path, &f, diag);
    if (s != ORR_OK) return s;
    printer p = {gzopen(f.temp, "wb9"), false};
    if (p.z == NULL) {
        orr_outfile_abort(&f);
        return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened for writing");
    }
    print_header(&p, t, from, interval_s, n, what);
    for (int i = 0; s == ORR_OK && i < n; i++)
        s = print_epoch(&p, t, from + (orr_time)i * interval_s * ORR_NS_PER_S, interval_s);
    line(&p, "EOF");
    if (gzclose(p.z) != Z_OK) p.bad = true;
    if (s == ORR_OK && p.bad) s = ORR_E_IO;
    if (s != ORR_OK) orr_diag_at(diag, s, path, 0, 0, "cannot be written");
    return orr_outfile_end(&f, s, diag);
}

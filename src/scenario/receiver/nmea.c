// SPDX-License-Identifier: GPL-3.0-or-later
// NMEA 0183, version 4.11: GGA, RMC, GST and ZDA of the true position, GSA and GSV of the satellites that are observed. Heights are above the
// ellipsoid, with a geoid separation of zero.
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "core/constants.h"
#include "src/scenario/receiver/fix.h"
#include "src/scenario/receiver/port_private.h"

#define KNOT_MPS (1852.0 / 3600)
#define ROOM 128
#define USED 12 // satellites of one GSA
#define SEEN 4  // of one GSV

// Systems with their talker, their number in GSA, and what is added to a satellite's number.
static const struct {
    char system, talker[3];
    int number, offset;
} rows[] = {{'G', "GP", 1, 0}, {'R', "GL", 2, 64}, {'E', "GA", 3, 0}, {'C', "GB", 4, 0},
            {'J', "GQ", 5, 0}, {'I', "GI", 6, 0},  {'S', "GP", 1, 13}}; // S20 is PRN 120, NMEA's 33

// Appends a sentence: $ and checksum are added to what the format says.
__attribute__((format(printf, 2, 3))) static void say(orr_port_bytes *out, const char *format, ...)
{
    char text[ROOM + 8];
    va_list args;
    va_start(args, format);
    int n = vsnprintf(text, ROOM, format, args);
    va_end(args);
    unsigned sum = 0;
    for (int k = 0; k < n; k++) sum ^= (unsigned char)text[k];
    orr_port_bytes_add(out, "$", 1);
    n += snprintf(text + n, 8, "*%02X\r\n", sum & 0xffu);
    orr_port_bytes_add(out, text, (size_t)n);
}

// "5216.8000000,N": degrees and minutes of an angle, ten-millionths of a minute.
static void angle(double rad, int degrees, const char *sides, char *text)
{
    const int64_t unit = 600000000, all = llround(fabs(rad) * ORR_DEG_PER_RAD * (double)unit);
    snprintf(text, ROOM / 4, "%0*d%010.7f,%c", degrees, (int)(all / unit), (double)(all % unit) / 1e7,
             sides[rad < 0]);
}

// The talker of what all systems share: GN where there are several.
static const char *talker(const orr_observed *o)
{
    const char *one = NULL;
    for (size_t k = 0; k < o->n; k++)
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
            if (rows[i].system == orr_sat_system(o->item[k].sat)) {
                if (one != NULL && one != rows[i].talker && rows[i].number != 1) return "GN";
                if (one == NULL) one = rows[i].talker;
            }
    return one != NULL ? one : "GP";
}

// The satellites of a row, each with its first signal; their number.
static size_t of_row(const orr_observed *o, size_t row, const orr_observation *list[64])
{
    size_t n = 0;
    for (size_t k = 0; k < o->n && n < 64; k++)
        if (orr_sat_system(o->item[k].sat) == rows[row].system &&
            (k == 0 || o->item[k].sat != o->item[k - 1].sat))
            list[n++] = &o->item[k];
    return n;
}

static int number_of(const orr_observation *y, size_t row)
{
    return orr_sat_number(y->sat) + rows[row].offset;
}

static void say_used(const orr_observed *o, const orr_fix *f, orr_port_bytes *out)
{
    const orr_observation *list[64];
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++) {
        const size_t n = of_row(o, row, list);
        for (size_t k = 0; k < n; k += USED) {
            char sats[ROOM / 2];
            int at = 0;
            for (size_t j = k; j < k + USED; j++)
                at += j < n ? snprintf(sats + at, sizeof sats - (size_t)at, "%02d,", number_of(list[j], row))
                            : snprintf(sats + at, sizeof sats - (size_t)at, ",");
            say(out, "%sGSA,A,%d,%s%.2f,%.2f,%.2f,%d", talker(o), f->valid ? 3 : 1, sats, f->pdop, f->hdop,
                f->vdop, rows[row].number);
        }
    }
}

static void say_seen(const orr_observed *o, orr_port_bytes *out)
{
    const orr_observation *list[64];
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++) {
        const size_t n = of_row(o, row, list), sentences = (n + SEEN - 1) / SEEN;
        for (size_t k = 0; k < sentences; k++) {
            char sats[ROOM] = "";
            int at = 0;
            for (size_t j = SEEN * k; j < n && j < SEEN * (k + 1); j++)
                at += snprintf(sats + at, sizeof sats - (size_t)at, ",%02d,%02.0f,%03.0f,%02.0f",
                               number_of(list[j], row), fmax(list[j]->el_rad * ORR_DEG_PER_RAD, 0),
                               fmod(round(list[j]->az_rad * ORR_DEG_PER_RAD) + 360, 360),
                               fmin(fmax(list[j]->cn0_dbhz, 0), 99));
            say(out, "%sGSV,%zu,%zu,%02zu%s,0", rows[row].talker, sentences, k + 1, n, sats);
        }
    }
}

orr_status port_nmea(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    orr_fix f;
    orr_civil c;
    const orr_status s = orr_fix_of(p->antenna, o, &f, diag);
    if (s != ORR_OK) return s;
    // To the hundredth of a second, before the calendar: 59.996 s is the next minute.
    const orr_time t = orr_floor_div(o->t + 5000000, 10000000) * 10000000;
    orr_time_to_civil(t, ORR_SCALE_UTC, p->plan.leap, &c);
    char lat[ROOM / 4], lon[ROOM / 4], when[ROOM / 4];
    angle(f.g.lat_rad, 2, "NS", lat);
    angle(f.g.lon_rad, 3, "EW", lon);
    snprintf(when, sizeof when, "%02d%02d%02d.%02d", c.hour, c.minute, c.second, (int)(c.ns / 10000000));
    const char *from = talker(o);
    if (p->before == ORR_TIME_NONE) say(out, "%sTXT,01,01,02,ORRERY " ORR_VERSION, from);
    if (f.valid) {
        say(out, "%sGGA,%s,%s,%s,1,%02zu,%.2f,%.4f,M,0.0,M,,", from, when, lat, lon,
            f.n_sats < 99 ? f.n_sats : 99, f.hdop, f.g.height_m);
        say(out, "%sRMC,%s,A,%s,%s,%.3f,%.3f,%02d%02d%02d,,,A,V", from, when, lat, lon,
            f.speed_mps / KNOT_MPS, f.course_rad * ORR_DEG_PER_RAD, c.day, c.month, c.year % 100);
        say(out, "%sGST,%s,%.3f,,,,%.3f,%.3f,%.3f", from, when, f.range_sigma_m, f.sigma_m[1], f.sigma_m[0],
            f.sigma_m[2]);
    } else {
        say(out, "%sGGA,%s,,,,,0,%02zu,99.99,,M,,M,,", from, when, f.n_sats);
        say(out, "%sRMC,%s,V,,,,,,,%02d%02d%02d,,,N,V", from, when, c.day, c.month, c.year % 100);
    }
    say(out, "%sZDA,%s,%02d,%02d,%04d,00,00", from, when, c.day, c.month, c.year);
    say_used(o, &f, out);
    say_seen(o, out);
    return ORR_OK;
}

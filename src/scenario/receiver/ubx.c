// SPDX-License-Identifier: GPL-3.0-or-later
// u-blox's UBX: NAV-PVT with the true position and RXM-RAWX with the observations (UBX-18010854, ZED-F9P interface description;
// UBX-23002975 for L5, B1C and B2a). Signals that a receiver tracks by one component are told as their pilot where there is one.
#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "src/scenario/receiver/fix.h"
#include "src/scenario/receiver/port_private.h"

#define HEAD 16     // bytes of RAWX ahead of the measurements
#define MEASURED 32 // of one
#define MOST 255    // of one message
#define MOST_LOCK_MS 64500

// A whole number of n bytes, the lowest first.
static void put(uint8_t *at, size_t n, int64_t value)
{
    for (size_t k = 0; k < n; k++) at[k] = (uint8_t)((uint64_t)value >> 8 * k);
}

static void put_double(uint8_t *at, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(at, 8, (int64_t)bits);
}

static void put_float(uint8_t *at, double value)
{
    const float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    put(at, 4, bits);
}

// The index of a standard deviation: the least n for which unit 2^n is not less.
static int spread(double sigma, double unit)
{
    int n = 0;
    while (n < 15 && unit * (double)(1 << n) < sigma) n++;
    return n;
}

static void put_measurement(const orr_port *p, const orr_observation *y, orr_time t, uint8_t *at)
{
    const orr_signal *s = &p->signal[y->signal];
    const int64_t lock_ms = (t - y->since) / 1000000;
    // u-blox's phases of D2 signals stand half a cycle off from all others.
    put_double(at, y->code_m);
    put_double(at + 8, y->phase_cycles - (port_ubx_sends_d2(y->sat) ? 0.5 : 0));
    put_float(at + 16, y->doppler_hz);
    at[20] = (uint8_t)port_ubx_system(s->system);
    at[21] = (uint8_t)port_ubx_satellite(y->sat);
    at[22] = (uint8_t)port_ubx_signal(s, y->sat);
    at[23] = (uint8_t)port_ubx_channel(p, y->sat);
    put(at + 24, 2, lock_ms < MOST_LOCK_MS ? lock_ms : MOST_LOCK_MS);
    at[26] = (uint8_t)fmin(fmax(round(y->cn0_dbhz), 0), 255);
    at[27] = (uint8_t)spread(y->code_sigma_m, 0.01);
    at[28] = (uint8_t)spread(y->phase_sigma_cycles, 0.004);
    at[29] = 0;    // Doppler: 0.002 Hz
    at[30] = 0x07; // code and phase are valid, whole cycles
}

static int leap_seconds(const orr_port *p, orr_time t)
{
    return orr_leap_tai_minus_utc(t, p->plan.leap) - ORR_TAI_MINUS_GPS_S;
}

static void raw(const orr_port *p, const orr_observed *o, orr_port_bytes *out)
{
    static const uint8_t type[2] = {0x02, 0x15};
    uint8_t data[HEAD + MOST * MEASURED] = {0};
    int32_t week;
    int64_t ns;
    size_t n = 0;
    for (size_t k = 0; k < o->n && n < MOST; k++)
        if (port_ubx_signal(&p->signal[o->item[k].signal], o->item[k].sat) >= 0)
            put_measurement(p, &o->item[k], o->t, data + HEAD + MEASURED * n++);
    orr_time_week(o->t, &week, &ns);
    put_double(data, (double)ns / 1e9);
    put(data + 8, 2, week);
    data[10] = (uint8_t)leap_seconds(p, o->t);
    data[11] = (uint8_t)n;
    data[12] = 1; // leap seconds are known
    data[13] = 1; // version
    port_ubx_message(type, data, HEAD + MEASURED * n, out);
}

static orr_status solution(const orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    static const uint8_t type[2] = {0x01, 0x07};
    uint8_t d[92] = {0};
    orr_fix f;
    orr_civil c;
    int32_t week;
    int64_t ns;
    const orr_status s = orr_fix_of(p->antenna, o, &f, diag);
    if (s != ORR_OK) return s;
    orr_time_week(o->t, &week, &ns);
    orr_time_to_civil(o->t, ORR_SCALE_UTC, p->plan.leap, &c);
    put(d, 4, ns / 1000000);
    put(d + 4, 2, c.year);
    const int field[5] = {c.month, c.day, c.hour, c.minute, c.second};
    for (size_t k = 0; k < 5; k++) d[6 + k] = (uint8_t)field[k];
    d[11] = 0x07; // date and time are valid and resolved
    put(d + 16, 4, c.ns);
    d[20] = f.valid ? 3 : 0;
    d[21] = f.valid;
    d[23] = (uint8_t)(f.n_sats < 255 ? f.n_sats : 255);
    put(d + 24, 4, llround(f.g.lon_rad * ORR_DEG_PER_RAD * 1e7));
    put(d + 28, 4, llround(f.g.lat_rad * ORR_DEG_PER_RAD * 1e7));
    put(d + 32, 4, llround(f.g.height_m * 1e3));
    put(d + 36, 4, llround(f.g.height_m * 1e3)); // no geoid: that of the ellipsoid
    put(d + 40, 4, llround(hypot(f.sigma_m[0], f.sigma_m[1]) * 1e3));
    put(d + 44, 4, llround(f.sigma_m[2] * 1e3));
    put(d + 48, 4, llround(f.v_mps.y * 1e3));
    put(d + 52, 4, llround(f.v_mps.x * 1e3));
    put(d + 56, 4, llround(-f.v_mps.z * 1e3));
    put(d + 60, 4, llround(f.speed_mps * 1e3));
    put(d + 64, 4, llround(f.course_rad * ORR_DEG_PER_RAD * 1e5));
    put(d + 76, 2, llround(f.pdop * 100));
    port_ubx_message(type, d, sizeof d, out);
    return ORR_OK;
}

orr_status port_ubx(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    static const uint8_t notice[2] = {0x04, 0x02}; // INF-NOTICE
    static const char maker[] = "ORRERY " ORR_VERSION;
    if (p->before == ORR_TIME_NONE) port_ubx_message(notice, (const uint8_t *)maker, strlen(maker), out);
    orr_status s = solution(p, o, out, diag);
    if (s == ORR_OK) raw(p, o, out);
    return s == ORR_OK && p->navset != NULL ? port_ubx_subframes(p, o, out, diag) : s;
}

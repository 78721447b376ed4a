// SPDX-License-Identifier: GPL-3.0-or-later
// Rohde & Schwarz' commands of hardware in the loop. HILPosition:MODE:A takes the elapsed time in seconds, place, velocity, acceleration and
// jerk in ECEF, then yaw, pitch and roll in rad with up to three derivatives; MODE:B latitude, longitude [deg] and height with velocity,
// acceleration and jerk along North, East and Down. What is left out at the end is not told.
#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "core/earth.h"
#include "src/service/dialect/dialect.h"
#include "src/service/text/scpi_dialects.h"

static int put_seconds(FILE *out, int64_t ns)
{
    fprintf(out, "%.9f", (double)ns / 1e9);
    return 0;
}

static bool stats_of(orr_scpi *s, orr_msg_motion_stats *m)
{
    const orr_asked *a = orr_text_asked(s);
    return a->streams != NULL && orr_streams_motion_stats(a->streams, false, m);
}

// How much earlier than its instant a block is made at the moment: what a stream's lead leaves.
static int latency(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    orr_msg_motion_stats m;
    return stats_of(s, &m) ? put_seconds(out, m.lateness.last) : ORR_SCPI_EXECUTION;
}

// Last, least, greatest, median and 99th percentile of the lateness, then how many samples were received, used, late, early, dropped, and
// how many blocks extrapolated, joined, snapped.
static int statistics(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    orr_msg_motion_stats m;
    if (!stats_of(s, &m)) return ORR_SCPI_EXECUTION;
    const int64_t times[] = {m.lateness.last, m.lateness.min, m.lateness.max, m.lateness.p50, m.lateness.p99};
    const uint64_t counts[] = {m.received, m.used,         m.late,   m.early,
                               m.dropped,  m.extrapolated, m.joined, m.snapped};
    for (size_t k = 0; k < 5; k++) fprintf(out, "%s%.9f", k > 0 ? "," : "", (double)times[k] / 1e9);
    for (size_t k = 0; k < 8; k++) fprintf(out, ",%llu", (unsigned long long)counts[k]);
    return 0;
}

static int hardware_time(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)p, (void)n;
    orr_msg_time now;
    const orr_asked *a = orr_text_asked(s);
    if (a->streams == NULL) return ORR_SCPI_EXECUTION;
    orr_streams_time(a->streams, &now);
    return put_seconds(out, orr_time_sub_ns(now.t, orr_streams_begin(a->streams)));
}

enum { MOST = 1 + 12 + 12 };

static int take(orr_scpi *s, char *const *p, size_t n, double v[MOST], orr_msg_motion *m)
{
    const orr_asked *a = orr_text_asked(s);
    memset(v, 0, MOST * sizeof v[0]);
    *m = (orr_msg_motion){.order = 0};
    if (a->streams == NULL) return ORR_SCPI_EXECUTION;
    if (n % 3 != 1) return ORR_SCPI_MISSING;
    const int wrong = orr_scpi_numbers(p, n, v);
    if (wrong != 0) return wrong;
    if (fabs(v[0]) > 1e9) return ORR_SCPI_RANGE;
    m->t = orr_time_add(orr_streams_begin(a->streams), llround(v[0] * 1e9));
    m->order = (uint8_t)((n - 1) / 3 < 4 ? (n - 1) / 3 - 1 : 3);
    return 0;
}

static void take_angles(const double *v, size_t n, orr_msg_motion *m)
{
    double angle[4][3] = {{0}};
    if (n <= 13) return;
    memcpy(angle, v + 13, (n - 13) * sizeof v[0]);
    orr_dialect_turn(angle, (int)((n - 13) / 3) - 1, m);
}

static int mode_a(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    double v[MOST];
    orr_msg_motion m;
    const int wrong = take(s, p, n, v, &m);
    if (wrong != 0) return wrong;
    double *const place[] = {m.pos_m, m.vel_mps, m.acc_mps2, m.jerk_mps3};
    for (int k = 0; k < 4; k++) memcpy(place[k], v + 1 + 3 * k, 3 * sizeof v[0]);
    take_angles(v, n, &m);
    return orr_scpi_motion(s, &m);
}

static int mode_b(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)out;
    double v[MOST];
    orr_msg_motion m;
    const int wrong = take(s, p, n, v, &m);
    if (wrong != 0) return wrong;
    const orr_geodetic g = {v[1] * ORR_RAD_PER_DEG, v[2] * ORR_RAD_PER_DEG, v[3]};
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    const orr_vec3 r = orr_earth_to_ecef(g);
    const double at[3] = {r.x, r.y, r.z};
    double *const place[] = {m.vel_mps, m.acc_mps2, m.jerk_mps3};
    memcpy(m.pos_m, at, sizeof at);
    for (int k = 0; k < 3;
         k++) { // North, East, Down of the place; that these turn under a moving body is left out
        const double *ned = v + 4 + 3 * k;
        const orr_vec3 e = orr_mat3_apply_t(&enu, (orr_vec3){ned[1], ned[0], -ned[2]});
        const double ecef[3] = {e.x, e.y, e.z};
        memcpy(place[k], ecef, sizeof ecef);
    }
    take_angles(v, n, &m);
    return orr_scpi_motion(s, &m);
}

const orr_scpi_command orr_scpi_rs[] = {
    {"[SOURce#:]BB:GNSS:RECeiver[:V#]:HIL:SLATency?", 0, 0, latency, false},
    {"[SOURce#:]BB:GNSS:RT:RECeiver[:V#]:HILPosition:LATency?", 0, 0, latency, false},
    {"[SOURce#:]BB:GNSS:RT:RECeiver[:V#]:HILPosition:LATency:STATistics?", 0, 0, statistics, false},
    {"[SOURce#:]BB:GNSS:RT:RECeiver[:V#]:HILPosition:MODE:A", 4, MOST, mode_a, true},
    {"[SOURce#:]BB:GNSS:RT:RECeiver[:V#]:HILPosition:MODE:B", 4, MOST, mode_b, true},
    {"[SOURce#:]BB:GNSS:RT:HWTime?", 0, 0, hardware_time, false},
};
const size_t orr_scpi_n_rs = sizeof orr_scpi_rs / sizeof orr_scpi_rs[0];

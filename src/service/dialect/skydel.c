// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams of Skydel's hardware in the loop, by their published layout: little-endian; one byte of what it is (1 hello, 2 bye, 3 vehicle
// information, 5 ECEF, 6 ECEF and attitude, 7 and 8 the same with dynamics), of 7 and 8 one byte of how many derivatives (0 velocity, 1
// acceleration, 2 jerk); milliseconds since the begin as a double; position, attitude (yaw, pitch, roll in rad against North, East, Down),
// derivatives in turn as doubles; length of a name as 32 bits, and the name: another vehicle's, which is passed over.
#include <math.h>
#include <string.h>

#include "core/earth.h"
#include "proto/wire.h"
#include "src/service/dialect/dialect.h"

enum { HELLO = 1, BYE = 2, VEHICLE = 3, ECEF = 5, ECEF_NED = 6, ECEF_DYNAMICS = 7, ECEF_NED_DYNAMICS = 8 };

static void take_three(orr_wire_reader *r, double to[3])
{
    for (int k = 0; k < 3; k++) {
        const uint8_t *p = orr_wire_take(r, 8);
        to[k] = p != NULL ? orr_wire_load_f64(p) : 0;
    }
}

// What Skydel tells a client that has greeted: where its vehicle is.
static size_t tell(orr_dialect_state *s, const orr_msg_motion *m, double ms, const double angle[3],
                   uint8_t *reply)
{
    const orr_geodetic place = orr_earth_from_ecef((orr_vec3){m->pos_m[0], m->pos_m[1], m->pos_m[2]});
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    const orr_vec3 v = orr_mat3_apply(&enu, (orr_vec3){m->vel_mps[0], m->vel_mps[1], m->vel_mps[2]});
    const double heading = atan2(v.x, v.y);
    const double told[] = {m->pos_m[0], m->pos_m[1],      m->pos_m[2], angle[0],      angle[1],
                           angle[2],    orr_vec3_norm(v), heading,     s->travelled_m};
    reply[0] = VEHICLE;
    orr_wire_store_u64(reply + 1, ms > 0 ? (uint64_t)ms : 0);
    for (int k = 0; k < 9; k++) orr_wire_store_f64(reply + 9 + 8 * k, told[k]);
    return 9 + 8 * 9;
}

static orr_dialect_result take_motion(orr_dialect_state *s, orr_wire_reader *r, uint8_t what,
                                      orr_msg_motion *m, double *ms, double angle[4][3])
{
    int order = 0;
    const bool turns = what == ECEF_NED || what == ECEF_NED_DYNAMICS;
    double *const place[] = {m->pos_m, m->vel_mps, m->acc_mps2, m->jerk_mps3};
    if (what == ECEF_DYNAMICS || what == ECEF_NED_DYNAMICS) {
        const uint8_t *p = orr_wire_take(r, 1);
        if (p == NULL || *p > 2) return ORR_DIALECT_WRONG;
        order = *p + 1;
    }
    const uint8_t *time = orr_wire_take(r, 8);
    *ms = time != NULL ? orr_wire_load_f64(time) : (double)NAN;
    for (int k = 0; k <= order; k++) {
        take_three(r, place[k]);
        if (turns) take_three(r, angle[k]);
    }
    const uint8_t *name = orr_wire_take(r, 4);
    if (name == NULL || orr_wire_load_u32(name) != r->size - r->at || !(fabs(*ms) < 1e12))
        return ORR_DIALECT_WRONG;
    if (orr_wire_load_u32(name) > 0) return ORR_DIALECT_NOTHING; // of another vehicle
    m->order = (uint8_t)order;
    m->t = orr_time_add(s->begin, llround(*ms * 1e6));
    if (turns) orr_dialect_turn(angle, order, m);
    return ORR_DIALECT_SAMPLE;
}

static orr_dialect_result take(orr_dialect_state *s, const uint8_t *data, size_t n, orr_msg_motion *m,
                               uint8_t *reply, size_t *n_reply)
{
    orr_wire_reader r = {data, n, 0, ORR_WIRE_OK};
    double ms, angle[4][3] = {{0}};
    *n_reply = 0;
    *m = (orr_msg_motion){.order = 0};
    const uint8_t *what = orr_wire_take(&r, 1);
    if (what == NULL || (*what <= BYE && n != 1)) return ORR_DIALECT_WRONG;
    switch (*what) {
    case HELLO:
    case BYE:
        s->greeted = *what == HELLO;
        return ORR_DIALECT_NOTHING;
    case VEHICLE:
        return ORR_DIALECT_NOTHING;
    case ECEF:
    case ECEF_NED:
    case ECEF_DYNAMICS:
    case ECEF_NED_DYNAMICS:
        break;
    default:
        return ORR_DIALECT_WRONG;
    }
    const orr_dialect_result result = take_motion(s, &r, *what, m, &ms, angle);
    if (result != ORR_DIALECT_SAMPLE) return result;
    if (s->last.t != 0)
        s->travelled_m += hypot(hypot(m->pos_m[0] - s->last.pos_m[0], m->pos_m[1] - s->last.pos_m[1]),
                                m->pos_m[2] - s->last.pos_m[2]);
    s->last = *m;
    if (s->greeted) *n_reply = tell(s, m, ms, angle[0], reply);
    return ORR_DIALECT_SAMPLE;
}

const orr_dialect orr_dialect_skydel = {
    .name = "skydel", .words = "Skydel's hardware-in-the-loop datagrams", .take = take};

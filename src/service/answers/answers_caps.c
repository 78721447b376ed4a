// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_caps.h"

#include "core/nan.h"
#include "src/service/answers/answers_private.h"
#include "src/service/live/pace.h"

_Static_assert((int)ORR_RECEIVER_NONE == ORR_MSG_RECEIVER_SOURCE_NONE &&
                   (int)ORR_RECEIVER_PLACE == ORR_MSG_RECEIVER_SOURCE_POSITION &&
                   (int)ORR_RECEIVER_UNIT == ORR_MSG_RECEIVER_SOURCE_TRAJECTORY &&
                   (int)ORR_RECEIVER_STATION == ORR_MSG_RECEIVER_SOURCE_STATION,
               "the engine's kinds of receiver are the wire's");

// The receiver of a POLL_DELAYS that names none.
static void fill_receiver(const orr_engine *e, orr_time t, orr_msg_caps *caps)
{
    orr_vec3 place = {ORR_NAN, ORR_NAN, ORR_NAN};
    size_t unit = 0;
    caps->receiver_source = (uint8_t)orr_engine_receiver_kind(e, &unit);
    caps->receiver_unit = (uint16_t)unit;
    if (caps->receiver_source != ORR_MSG_RECEIVER_SOURCE_TRAJECTORY)
        (void)orr_engine_receiver(e, t, &place); // writes nothing where there is none
    caps->receiver_m[0] = place.x;
    caps->receiver_m[1] = place.y;
    caps->receiver_m[2] = place.z;
}

static void fill_units(orr_answers *a, orr_msg_caps *caps)
{
    uint16_t n = 0;
    for (orr_unit u; n < ORR_MSG_MAX_UNITS && orr_engine_unit(a->engine, n, &u); n++)
        a->unit[n] = (orr_msg_inertial_unit){.unit = n,
                                             .name = orr_wire_text(u.name),
                                             .lever_m = {u.arm_m.x, u.arm_m.y, u.arm_m.z},
                                             .heading_rad = u.turn.heading_rad,
                                             .pitch_rad = u.turn.pitch_rad,
                                             .roll_rad = u.turn.roll_rad};
    caps->units.count = n;
    caps->units.item = a->unit;
}

void orr_answers_caps(void *user, orr_msg_caps *caps)
{
    orr_answers *a = user;
    const orr_engine *e = a->engine;
    orr_engine_span(e, &caps->span.first, &caps->span.last);
    caps->name = orr_wire_text("orrery");
    caps->version = orr_wire_text(ORR_VERSION);
    caps->title = orr_wire_text(orr_engine_title(e));
    caps->frame = orr_wire_text(orr_engine_frame(e));
    caps->leap = orr_pace_leap(caps->span.first, orr_engine_leap(e));
    if (orr_engine_no_navdata(e) == NULL)
        caps->navdata_point = orr_engine_navdata_phase_centres(e) ? ORR_MSG_ORBIT_POINT_PHASE_CENTRE
                                                                  : ORR_MSG_ORBIT_POINT_CENTRE_OF_MASS;
    fill_receiver(e, caps->span.first, caps);
    orr_msg_span span;
    bool imu = orr_answers_served(a, ORR_MSG_TYPE_POLL_IMU, &span);
    caps->imu_rate_hz = imu ? orr_engine_imu_rate(e) : ORR_NAN;
    fill_units(a, caps);
    orr_answers_channels_caps(orr_engine_channels(e), &a->channels, caps);
    caps->satellites.count = a->n_ids;
    caps->satellites.item = a->id;
}

static bool span_of(const orr_engine *e, orr_engine_part part, orr_msg_span *out)
{
    orr_span s;
    if (!orr_engine_part_span(e, part, &s)) return false;
    *out = (orr_msg_span){s.from, s.to};
    return true;
}

static void meet(orr_msg_span with, orr_msg_span *span)
{
    if (with.first > span->first) span->first = with.first;
    if (with.last < span->last) span->last = with.last;
}

// Delays need orbits and the ionosphere, and the trajectory where the receiver that is used by default flies.
static bool delays_span(const orr_engine *e, orr_msg_span *span)
{
    orr_msg_span other;
    if (!span_of(e, ORR_PART_ORBITS, span) || !span_of(e, ORR_PART_IONOSPHERE, &other)) return false;
    meet(other, span);
    if (orr_engine_receiver_kind(e, NULL) == ORR_RECEIVER_UNIT && span_of(e, ORR_PART_MOTION, &other))
        meet(other, span);
    if (span->first > span->last) *span = (orr_msg_span){ORR_TIME_NONE, ORR_TIME_NONE};
    return true;
}

bool orr_answers_served(void *user, uint16_t request, orr_msg_span *span)
{
    const orr_answers *a = user;
    switch (request) {
    case ORR_MSG_TYPE_POLL:
    case ORR_MSG_TYPE_POLL_ELEMENTS:
        return span_of(a->engine, ORR_PART_ORBITS, span);
    case ORR_MSG_TYPE_POLL_NAVDATA:
        return span_of(a->engine, ORR_PART_NAVDATA, span);
    case ORR_MSG_TYPE_POLL_DELAYS:
        return delays_span(a->engine, span);
    case ORR_MSG_TYPE_POLL_CHANNELS:
        return span_of(a->engine, ORR_PART_CHANNELS, span);
    case ORR_MSG_TYPE_POLL_IMU:
        return span_of(a->engine, ORR_PART_MOTION, span) && orr_engine_imu_physical(a->engine);
    case ORR_MSG_TYPE_POLL_TRUTH:
        return span_of(a->engine, ORR_PART_MOTION, span);
    case ORR_MSG_TYPE_POLL_EVENTS:
        orr_engine_span(a->engine, &span->first, &span->last);
        return true;
    default:
        return false;
    }
}

// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
#include "proto/client.h"

orr_wire_status orr_client_hello(orr_client *c, const orr_msg_hello *request, orr_msg_caps *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_HELLO, &w, &start);
    orr_msg_hello_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_CAPS, &f);
    return s == ORR_WIRE_OK ? orr_msg_caps_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_ping(orr_client *c, const orr_msg_ping *request, orr_msg_pong *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_PING, &w, &start);
    orr_msg_ping_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_PONG, &f);
    return s == ORR_WIRE_OK ? orr_msg_pong_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_poll(orr_client *c, const orr_msg_poll *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL, &w, &start);
    orr_msg_poll_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_poll_elements(orr_client *c, const orr_msg_poll_elements *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_ELEMENTS, &w, &start);
    orr_msg_poll_elements_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_poll_navdata(orr_client *c, const orr_msg_poll_navdata *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_NAVDATA, &w, &start);
    orr_msg_poll_navdata_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_poll_delays(orr_client *c, const orr_msg_poll_delays *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_DELAYS, &w, &start);
    orr_msg_poll_delays_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_poll_channels(orr_client *c, const orr_msg_poll_channels *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_CHANNELS, &w, &start);
    orr_msg_poll_channels_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_poll_imu(orr_client *c, const orr_msg_poll_imu *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_IMU, &w, &start);
    orr_msg_poll_imu_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_poll_truth(orr_client *c, const orr_msg_poll_truth *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_TRUTH, &w, &start);
    orr_msg_poll_truth_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_subscribe(orr_client *c, const orr_msg_subscribe *request, orr_msg_subscribed *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_SUBSCRIBE, &w, &start);
    orr_msg_subscribe_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_SUBSCRIBED, &f);
    return s == ORR_WIRE_OK ? orr_msg_subscribed_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_unsubscribe(orr_client *c, const orr_msg_unsubscribe *request)
{
    orr_wire_writer w;
    size_t start;
    uint32_t awaited = c->awaited;
    orr_client_begin(c, ORR_MSG_TYPE_UNSUBSCRIBE, &w, &start);
    orr_msg_unsubscribe_encode(request, &w);
    c->awaited = awaited;
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_credit(orr_client *c, const orr_msg_credit *request)
{
    orr_wire_writer w;
    size_t start;
    uint32_t awaited = c->awaited;
    orr_client_begin(c, ORR_MSG_TYPE_CREDIT, &w, &start);
    orr_msg_credit_encode(request, &w);
    c->awaited = awaited;
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_control(orr_client *c, const orr_msg_control *request, orr_msg_time *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_CONTROL, &w, &start);
    orr_msg_control_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_TIME, &f);
    return s == ORR_WIRE_OK ? orr_msg_time_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_get_time(orr_client *c, const orr_msg_get_time *request, orr_msg_time *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_GET_TIME, &w, &start);
    orr_msg_get_time_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_TIME, &f);
    return s == ORR_WIRE_OK ? orr_msg_time_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_radio_time(orr_client *c, const orr_msg_radio_time *request, orr_msg_pace *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_RADIO_TIME, &w, &start);
    orr_msg_radio_time_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_PACE, &f);
    return s == ORR_WIRE_OK ? orr_msg_pace_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_motion(orr_client *c, const orr_msg_motion *request)
{
    orr_wire_writer w;
    size_t start;
    uint32_t awaited = c->awaited;
    orr_client_begin(c, ORR_MSG_TYPE_MOTION, &w, &start);
    orr_msg_motion_encode(request, &w);
    c->awaited = awaited;
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_get_motion_stats(orr_client *c, const orr_msg_get_motion_stats *request, orr_msg_motion_stats *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_GET_MOTION_STATS, &w, &start);
    orr_msg_get_motion_stats_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_MOTION_STATS, &f);
    return s == ORR_WIRE_OK ? orr_msg_motion_stats_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_poll_events(orr_client *c, const orr_msg_poll_events *request)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_POLL_EVENTS, &w, &start);
    orr_msg_poll_events_encode(request, &w);
    orr_client_expect(c, request->epochs.count);
    return orr_client_send(c, &w, start);
}

orr_wire_status orr_client_open_datagrams(orr_client *c, const orr_msg_open_datagrams *request, orr_msg_datagrams *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_OPEN_DATAGRAMS, &w, &start);
    orr_msg_open_datagrams_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_DATAGRAMS, &f);
    return s == ORR_WIRE_OK ? orr_msg_datagrams_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_open_motion_ring(orr_client *c, const orr_msg_open_motion_ring *request, orr_msg_motion_ring *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_OPEN_MOTION_RING, &w, &start);
    orr_msg_open_motion_ring_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_MOTION_RING, &f);
    return s == ORR_WIRE_OK ? orr_msg_motion_ring_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_get_modes(orr_client *c, const orr_msg_get_modes *request, orr_msg_modes *answer)
{
    orr_wire_writer w;
    size_t start;
    orr_client_begin(c, ORR_MSG_TYPE_GET_MODES, &w, &start);
    orr_msg_get_modes_encode(request, &w);
    orr_frame f;
    orr_wire_status s = orr_client_send(c, &w, start);
    if (s == ORR_WIRE_OK) s = orr_client_answer(c, ORR_MSG_TYPE_MODES, &f);
    return s == ORR_WIRE_OK ? orr_msg_modes_decode(f.payload, f.size, answer) : s;
}

orr_wire_status orr_client_states(orr_client *c, orr_msg_states *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_STATES, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_states_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_elements(orr_client *c, orr_msg_elements *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_ELEMENTS, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_elements_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_navdata(orr_client *c, orr_msg_navdata *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_NAVDATA, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_navdata_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_delays(orr_client *c, orr_msg_delays *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_DELAYS, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_delays_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_channels(orr_client *c, orr_msg_channels *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_CHANNELS, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_channels_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_imu(orr_client *c, orr_msg_imu *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_IMU, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_imu_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_truth(orr_client *c, orr_msg_truth *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_TRUTH, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_truth_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

orr_wire_status orr_client_events(orr_client *c, orr_msg_events *answer)
{
    orr_frame f;
    orr_wire_status s = orr_client_answer(c, ORR_MSG_TYPE_EVENTS, &f);
    if (s == ORR_WIRE_OK) s = orr_msg_events_decode(f.payload, f.size, answer);
    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->epoch.index, answer->epoch.count) : s;
}

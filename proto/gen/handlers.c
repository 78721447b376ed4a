// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
#include "proto/server.h"

uint16_t orr_msg_request_type(size_t i)
{
    static const uint16_t types[] = {
        ORR_MSG_TYPE_POLL,
        ORR_MSG_TYPE_POLL_ELEMENTS,
        ORR_MSG_TYPE_POLL_NAVDATA,
        ORR_MSG_TYPE_POLL_DELAYS,
        ORR_MSG_TYPE_POLL_CHANNELS,
        ORR_MSG_TYPE_POLL_IMU,
        ORR_MSG_TYPE_POLL_TRUTH,
        ORR_MSG_TYPE_POLL_EVENTS,
    };
    return i < sizeof types / sizeof types[0] ? types[i] : 0;
}

uint16_t orr_msg_handled(const orr_msg_handlers *h, uint16_t type)
{
    switch (type) {
    case ORR_MSG_TYPE_POLL: return h->poll != NULL ? ORR_MSG_TYPE_STATES : 0;
    case ORR_MSG_TYPE_POLL_ELEMENTS: return h->poll_elements != NULL ? ORR_MSG_TYPE_ELEMENTS : 0;
    case ORR_MSG_TYPE_POLL_NAVDATA: return h->poll_navdata != NULL ? ORR_MSG_TYPE_NAVDATA : 0;
    case ORR_MSG_TYPE_POLL_DELAYS: return h->poll_delays != NULL ? ORR_MSG_TYPE_DELAYS : 0;
    case ORR_MSG_TYPE_POLL_CHANNELS: return h->poll_channels != NULL ? ORR_MSG_TYPE_CHANNELS : 0;
    case ORR_MSG_TYPE_POLL_IMU: return h->poll_imu != NULL ? ORR_MSG_TYPE_IMU : 0;
    case ORR_MSG_TYPE_POLL_TRUTH: return h->poll_truth != NULL ? ORR_MSG_TYPE_TRUTH : 0;
    case ORR_MSG_TYPE_POLL_EVENTS: return h->poll_events != NULL ? ORR_MSG_TYPE_EVENTS : 0;
    default: return 0;
    }
}

orr_wire_status orr_msg_request_decode(uint16_t type, const uint8_t *payload, size_t size, orr_msg_any *request)
{
    switch (type) {
    case ORR_MSG_TYPE_POLL: return orr_msg_poll_decode(payload, size, &request->poll);
    case ORR_MSG_TYPE_POLL_ELEMENTS: return orr_msg_poll_elements_decode(payload, size, &request->poll_elements);
    case ORR_MSG_TYPE_POLL_NAVDATA: return orr_msg_poll_navdata_decode(payload, size, &request->poll_navdata);
    case ORR_MSG_TYPE_POLL_DELAYS: return orr_msg_poll_delays_decode(payload, size, &request->poll_delays);
    case ORR_MSG_TYPE_POLL_CHANNELS: return orr_msg_poll_channels_decode(payload, size, &request->poll_channels);
    case ORR_MSG_TYPE_POLL_IMU: return orr_msg_poll_imu_decode(payload, size, &request->poll_imu);
    case ORR_MSG_TYPE_POLL_TRUTH: return orr_msg_poll_truth_decode(payload, size, &request->poll_truth);
    case ORR_MSG_TYPE_POLL_EVENTS: return orr_msg_poll_events_decode(payload, size, &request->poll_events);
    default: return ORR_WIRE_UNEXPECTED;
    }
}

uint32_t orr_msg_request_frames(uint16_t type, const orr_msg_any *request)
{
    (void)request;
    switch (type) {
    case ORR_MSG_TYPE_POLL: return request->poll.epochs.count;
    case ORR_MSG_TYPE_POLL_ELEMENTS: return request->poll_elements.epochs.count;
    case ORR_MSG_TYPE_POLL_NAVDATA: return request->poll_navdata.epochs.count;
    case ORR_MSG_TYPE_POLL_DELAYS: return request->poll_delays.epochs.count;
    case ORR_MSG_TYPE_POLL_CHANNELS: return request->poll_channels.epochs.count;
    case ORR_MSG_TYPE_POLL_IMU: return request->poll_imu.epochs.count;
    case ORR_MSG_TYPE_POLL_TRUTH: return request->poll_truth.epochs.count;
    case ORR_MSG_TYPE_POLL_EVENTS: return request->poll_events.epochs.count;
    default: return 1;
    }
}

uint16_t orr_msg_begin(const orr_msg_handlers *h, void *user, uint16_t type, const orr_msg_any *request, orr_server_refusal *why)
{
    switch (type) {
    case ORR_MSG_TYPE_POLL: return h->begin_poll != NULL ? h->begin_poll(user, &request->poll, why) : 0;
    case ORR_MSG_TYPE_POLL_ELEMENTS: return h->begin_poll_elements != NULL ? h->begin_poll_elements(user, &request->poll_elements, why) : 0;
    case ORR_MSG_TYPE_POLL_NAVDATA: return h->begin_poll_navdata != NULL ? h->begin_poll_navdata(user, &request->poll_navdata, why) : 0;
    case ORR_MSG_TYPE_POLL_DELAYS: return h->begin_poll_delays != NULL ? h->begin_poll_delays(user, &request->poll_delays, why) : 0;
    case ORR_MSG_TYPE_POLL_CHANNELS: return h->begin_poll_channels != NULL ? h->begin_poll_channels(user, &request->poll_channels, why) : 0;
    case ORR_MSG_TYPE_POLL_IMU: return h->begin_poll_imu != NULL ? h->begin_poll_imu(user, &request->poll_imu, why) : 0;
    case ORR_MSG_TYPE_POLL_TRUTH: return h->begin_poll_truth != NULL ? h->begin_poll_truth(user, &request->poll_truth, why) : 0;
    case ORR_MSG_TYPE_POLL_EVENTS: return h->begin_poll_events != NULL ? h->begin_poll_events(user, &request->poll_events, why) : 0;
    default: return ORR_MSG_ERROR_CODE_INTERNAL;
    }
}

uint16_t orr_msg_answer(const orr_msg_handlers *h, void *user, uint16_t type, const orr_msg_any *request, orr_server_part *part,
                        orr_wire_writer *w, orr_server_refusal *why)
{
    switch (type) {
    case ORR_MSG_TYPE_POLL: return h->poll(user, &request->poll, part, w, why);
    case ORR_MSG_TYPE_POLL_ELEMENTS: return h->poll_elements(user, &request->poll_elements, part, w, why);
    case ORR_MSG_TYPE_POLL_NAVDATA: return h->poll_navdata(user, &request->poll_navdata, part, w, why);
    case ORR_MSG_TYPE_POLL_DELAYS: return h->poll_delays(user, &request->poll_delays, part, w, why);
    case ORR_MSG_TYPE_POLL_CHANNELS: return h->poll_channels(user, &request->poll_channels, part, w, why);
    case ORR_MSG_TYPE_POLL_IMU: return h->poll_imu(user, &request->poll_imu, part, w, why);
    case ORR_MSG_TYPE_POLL_TRUTH: return h->poll_truth(user, &request->poll_truth, part, w, why);
    case ORR_MSG_TYPE_POLL_EVENTS: return h->poll_events(user, &request->poll_events, part, w, why);
    default: return ORR_MSG_ERROR_CODE_INTERNAL;
    }
}

bool orr_msg_is_lane(uint16_t type)
{
    switch (type) {
    case ORR_MSG_TYPE_SUBSCRIBE:
    case ORR_MSG_TYPE_UNSUBSCRIBE:
    case ORR_MSG_TYPE_CREDIT:
    case ORR_MSG_TYPE_CONTROL:
    case ORR_MSG_TYPE_GET_TIME:
    case ORR_MSG_TYPE_RADIO_TIME:
    case ORR_MSG_TYPE_MOTION:
    case ORR_MSG_TYPE_GET_MOTION_STATS:
    case ORR_MSG_TYPE_OPEN_DATAGRAMS:
    case ORR_MSG_TYPE_OPEN_MOTION_RING:
    case ORR_MSG_TYPE_GET_MODES:
        return true;
    default: return false;
    }
}

uint16_t orr_msg_lane_request(size_t i, uint16_t *answer)
{
    static const uint16_t lanes[][2] = {
        {ORR_MSG_TYPE_SUBSCRIBE, ORR_MSG_TYPE_SUBSCRIBED},
        {ORR_MSG_TYPE_CONTROL, ORR_MSG_TYPE_TIME},
        {ORR_MSG_TYPE_GET_TIME, ORR_MSG_TYPE_TIME},
        {ORR_MSG_TYPE_RADIO_TIME, ORR_MSG_TYPE_PACE},
        {ORR_MSG_TYPE_GET_MOTION_STATS, ORR_MSG_TYPE_MOTION_STATS},
        {ORR_MSG_TYPE_OPEN_DATAGRAMS, ORR_MSG_TYPE_DATAGRAMS},
        {ORR_MSG_TYPE_OPEN_MOTION_RING, ORR_MSG_TYPE_MOTION_RING},
        {ORR_MSG_TYPE_GET_MODES, ORR_MSG_TYPE_MODES},
    };
    if (i >= sizeof lanes / sizeof lanes[0]) return 0;
    *answer = lanes[i][1];
    return lanes[i][0];
}

// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
// The handlers of a server, a pair for each request. Included by proto/server.h, which says what they do.
#ifndef ORR_PROTO_GEN_HANDLERS_H
#define ORR_PROTO_GEN_HANDLERS_H

typedef struct orr_msg_handlers {
    // POLL, answered by STATES. Asks for satellite states. The same POLL gets the same bytes, always.
    uint16_t (*begin_poll)(void *user, const orr_msg_poll *request, orr_server_refusal *why);
    uint16_t (*poll)(void *user, const orr_msg_poll *request, orr_server_part *part, orr_wire_writer *w,
                           orr_server_refusal *why);
    // POLL_ELEMENTS, answered by ELEMENTS. Asks for Kepler elements. The same POLL_ELEMENTS gets the same bytes, always.
    uint16_t (*begin_poll_elements)(void *user, const orr_msg_poll_elements *request, orr_server_refusal *why);
    uint16_t (*poll_elements)(void *user, const orr_msg_poll_elements *request, orr_server_part *part, orr_wire_writer *w,
                                    orr_server_refusal *why);
    // POLL_NAVDATA, answered by NAVDATA. Asks for the broadcast data. Frames of LNAV, FDMA, D1 and D2 last 30 s; who asks again at frame_to has all that is sent. The same POLL_NAVDATA gets the same bytes, always.
    uint16_t (*begin_poll_navdata)(void *user, const orr_msg_poll_navdata *request, orr_server_refusal *why);
    uint16_t (*poll_navdata)(void *user, const orr_msg_poll_navdata *request, orr_server_part *part, orr_wire_writer *w,
                                   orr_server_refusal *why);
    // POLL_DELAYS, answered by DELAYS. Asks for ionospheric delays. The same POLL_DELAYS gets the same bytes, always.
    uint16_t (*begin_poll_delays)(void *user, const orr_msg_poll_delays *request, orr_server_refusal *why);
    uint16_t (*poll_delays)(void *user, const orr_msg_poll_delays *request, orr_server_part *part, orr_wire_writer *w,
                                  orr_server_refusal *why);
    // POLL_CHANNELS, answered by CHANNELS. Asks for the blocks of an antenna's channels that hold the epochs. The same POLL_CHANNELS gets the same bytes, always.
    uint16_t (*begin_poll_channels)(void *user, const orr_msg_poll_channels *request, orr_server_refusal *why);
    uint16_t (*poll_channels)(void *user, const orr_msg_poll_channels *request, orr_server_part *part, orr_wire_writer *w,
                                    orr_server_refusal *why);
    // POLL_IMU, answered by IMU. Asks for inertial increments over intervals, ideal ones or, where the scenario has imu.errors, what sensors with errors measure. The same POLL_IMU gets the same bytes, always.
    uint16_t (*begin_poll_imu)(void *user, const orr_msg_poll_imu *request, orr_server_refusal *why);
    uint16_t (*poll_imu)(void *user, const orr_msg_poll_imu *request, orr_server_part *part, orr_wire_writer *w,
                               orr_server_refusal *why);
    // POLL_TRUTH, answered by TRUTH. Asks for the true motion of an inertial unit. The same POLL_TRUTH gets the same bytes, always.
    uint16_t (*begin_poll_truth)(void *user, const orr_msg_poll_truth *request, orr_server_refusal *why);
    uint16_t (*poll_truth)(void *user, const orr_msg_poll_truth *request, orr_server_part *part, orr_wire_writer *w,
                                 orr_server_refusal *why);
    // POLL_EVENTS, answered by EVENTS. Asks what happens in intervals. The same POLL_EVENTS gets the same bytes, always.
    uint16_t (*begin_poll_events)(void *user, const orr_msg_poll_events *request, orr_server_refusal *why);
    uint16_t (*poll_events)(void *user, const orr_msg_poll_events *request, orr_server_part *part, orr_wire_writer *w,
                                  orr_server_refusal *why);
} orr_msg_handlers;

// Number i of the requests of the table; 0 behind the last.
uint16_t orr_msg_request_type(size_t i);
// The message that answers a request of the table; 0 where it has no handler.
uint16_t orr_msg_handled(const orr_msg_handlers *h, uint16_t type);
// These three want a request that has a handler. Frames of its answer: one for each epoch, or one.
orr_wire_status orr_msg_request_decode(uint16_t type, const uint8_t *payload, size_t size, orr_msg_any *request);
uint32_t orr_msg_request_frames(uint16_t type, const orr_msg_any *request);
uint16_t orr_msg_begin(const orr_msg_handlers *h, void *user, uint16_t type, const orr_msg_any *request, orr_server_refusal *why);
uint16_t orr_msg_answer(const orr_msg_handlers *h, void *user, uint16_t type, const orr_msg_any *request, orr_server_part *part,
                        orr_wire_writer *w, orr_server_refusal *why);
// Whether a message belongs to the connection (SUBSCRIBE, ...): who owns connections answers it, not the table.
bool orr_msg_is_lane(uint16_t type);
// Number i of those that are answered, and its answer in *answer; 0 behind the last.
uint16_t orr_msg_lane_request(size_t i, uint16_t *answer);

#endif

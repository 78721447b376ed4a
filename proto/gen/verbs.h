// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
// What a client asks and hears. Included by proto/client.h.
#ifndef ORR_PROTO_GEN_VERBS_H
#define ORR_PROTO_GEN_VERBS_H

#ifdef __cplusplus
extern "C" {
#endif

// Opens a conversation. Optional, but a client that sends it learns what is served.
orr_wire_status orr_client_hello(orr_client *c, const orr_msg_hello *request, orr_msg_caps *answer);
// Asks whether the server is alive; also keeps an idle connection open.
orr_wire_status orr_client_ping(orr_client *c, const orr_msg_ping *request, orr_msg_pong *answer);
// Asks for satellite states. The same POLL gets the same bytes, always.
// Then call orr_client_states request->epochs.count times.
orr_wire_status orr_client_poll(orr_client *c, const orr_msg_poll *request);
// Asks for Kepler elements. The same POLL_ELEMENTS gets the same bytes, always.
// Then call orr_client_elements request->epochs.count times.
orr_wire_status orr_client_poll_elements(orr_client *c, const orr_msg_poll_elements *request);
// Asks for the broadcast data. Frames of LNAV, FDMA, D1 and D2 last 30 s; who asks again at frame_to has all that is sent. The same POLL_NAVDATA gets the same bytes, always.
// Then call orr_client_navdata request->epochs.count times.
orr_wire_status orr_client_poll_navdata(orr_client *c, const orr_msg_poll_navdata *request);
// Asks for ionospheric delays. The same POLL_DELAYS gets the same bytes, always.
// Then call orr_client_delays request->epochs.count times.
orr_wire_status orr_client_poll_delays(orr_client *c, const orr_msg_poll_delays *request);
// Asks for the blocks of an antenna's channels that hold the epochs. The same POLL_CHANNELS gets the same bytes, always.
// Then call orr_client_channels request->epochs.count times.
orr_wire_status orr_client_poll_channels(orr_client *c, const orr_msg_poll_channels *request);
// Asks for inertial increments over intervals, ideal ones or, where the scenario has imu.errors, what sensors with errors measure. The same POLL_IMU gets the same bytes, always.
// Then call orr_client_imu request->epochs.count times.
orr_wire_status orr_client_poll_imu(orr_client *c, const orr_msg_poll_imu *request);
// Asks for the true motion of an inertial unit. The same POLL_TRUTH gets the same bytes, always.
// Then call orr_client_truth request->epochs.count times.
orr_wire_status orr_client_poll_truth(orr_client *c, const orr_msg_poll_truth *request);
// Asks for a stream. Its blocks are frames of the kind that answers the named request, and each is, byte for byte, the answer to that request for its instant alone. All frames of the stream bear the sequence number of the SUBSCRIBE, which is the stream's number.
orr_wire_status orr_client_subscribe(orr_client *c, const orr_msg_subscribe *request, orr_msg_subscribed *answer);
// Ends a stream; its last frame is a STREAM_END. Of a stream that has ended already it is passed over.
orr_wire_status orr_client_unsubscribe(orr_client *c, const orr_msg_unsubscribe *request);
// Lets a stream send so many blocks more. Of a stream that has ended already it is passed over.
orr_wire_status orr_client_credit(orr_client *c, const orr_msg_credit *request);
// Controls the scenario's clock; answered by what it is then.
orr_wire_status orr_client_control(orr_client *c, const orr_msg_control *request, orr_msg_time *answer);
// Asks what the scenario's clock shows.
orr_wire_status orr_client_get_time(orr_client *c, const orr_msg_get_time *request, orr_msg_time *answer);
// A generator tells its elapsed time, 1 to 1000 times a second; the scenario's clock follows it.
orr_wire_status orr_client_radio_time(orr_client *c, const orr_msg_radio_time *request, orr_msg_pace *answer);
// A sample of the live motion of the body that antennas ride on. Wants a clock that is armed or runs, and a server that takes motion (serve --motion); answered by an ERROR where it cannot be used.
orr_wire_status orr_client_motion(orr_client *c, const orr_msg_motion *request);
// Asks what became of the samples of motion, and lays down the worst state.
orr_wire_status orr_client_get_motion_stats(orr_client *c, const orr_msg_get_motion_stats *request, orr_msg_motion_stats *answer);
// Asks what happens in intervals. The same POLL_EVENTS gets the same bytes, always.
// Then call orr_client_events request->epochs.count times.
orr_wire_status orr_client_poll_events(orr_client *c, const orr_msg_poll_events *request);
// Asks for the connection's channel of datagrams, by which it may send MOTION, and for the keys of its datagrams in both directions. Asked again it tells the same channel and what has become of it.
orr_wire_status orr_client_open_datagrams(orr_client *c, const orr_msg_open_datagrams *request, orr_msg_datagrams *answer);
// Asks for a ring of shared memory into which a client on the server's host writes MOTION, over a Unix socket (docs/protocol.md, The ring). Asked again it tells what has become of it.
orr_wire_status orr_client_open_motion_ring(orr_client *c, const orr_msg_open_motion_ring *request, orr_msg_motion_ring *answer);
// Asks which modes the service has changed over to. May be subscribed to as well.
orr_wire_status orr_client_get_modes(orr_client *c, const orr_msg_get_modes *request, orr_msg_modes *answer);

// Satellite states at one epoch. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_states(orr_client *c, orr_msg_states *answer);
// Kepler elements at one epoch. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_elements(orr_client *c, orr_msg_elements *answer);
// Broadcast data at one epoch. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_navdata(orr_client *c, orr_msg_navdata *answer);
// Ionospheric delays at one epoch. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_delays(orr_client *c, orr_msg_delays *answer);
// The block of an antenna's channels that holds one epoch. Neighbouring blocks join in value and rate. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_channels(orr_client *c, orr_msg_channels *answer);
// Integrals of absolute angular rate and specific force over one interval, in the unit's axes (right, forward, up). ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_imu(orr_client *c, orr_msg_imu *answer);
// True motion and gravity at one epoch. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_truth(orr_client *c, orr_msg_truth *answer);
// What happens in one interval, its end not in it. ORR_WIRE_UNEXPECTED where an epoch is missing.
orr_wire_status orr_client_events(orr_client *c, orr_msg_events *answer);

#ifdef __cplusplus
}
#endif

#endif

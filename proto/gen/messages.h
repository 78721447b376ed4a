// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
// Messages of Orrery, protocol 1.0.
#ifndef ORR_MSG_GENERATED_H
#define ORR_MSG_GENERATED_H

#include <stdbool.h>

#include "proto/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define ORR_MSG_MAGIC_0 0x4fu
#define ORR_MSG_MAGIC_1 0x52u
#define ORR_MSG_MAGIC_2 0x52u
#define ORR_MSG_MAGIC_3 0x59u
#define ORR_MSG_MAJOR 1u
#define ORR_MSG_MINOR 0u
#define ORR_MSG_PORT 15754u
#define ORR_MSG_MAX_PAYLOAD 4194304u
#define ORR_MSG_MAX_CARRIERS 4u // carriers one POLL_DELAYS may name
#define ORR_MSG_MAX_SATELLITES 800u // satellites in one list (eight systems of 99 and a little)
#define ORR_MSG_MAX_STREAMS 800u // messages of satellites in one list
#define ORR_MSG_MAX_EPOCHS 86400u // epochs one POLL may ask for (a day at 1 Hz)
#define ORR_MSG_MAX_PAGES 15u // subframes, strings or pages in one frame of a navigation message
#define ORR_MSG_MAX_UNITS 64u // inertial units in one list
#define ORR_MSG_MAX_CHANNELS 4096u // channels of one antenna in one list
#define ORR_MSG_MAX_JAMMERS 16u // jammers of a scenario
#define ORR_MSG_MAX_ANTENNAS 16u // antennas in one list
#define ORR_MSG_MAX_SIGNALS 64u // signals in one list
#define ORR_MSG_MAX_EVENTS 8192u // events in one list
#define ORR_MSG_MAX_CHANGES 100u // mode changes in one list
#define ORR_MSG_MAX_REQUEST 65536u // bytes of payload that a server reads of one request

enum { // message types
    ORR_MSG_TYPE_HELLO = 1,
    ORR_MSG_TYPE_CAPS = 2,
    ORR_MSG_TYPE_PING = 3,
    ORR_MSG_TYPE_PONG = 4,
    ORR_MSG_TYPE_ERROR = 5,
    ORR_MSG_TYPE_POLL = 6,
    ORR_MSG_TYPE_STATES = 7,
    ORR_MSG_TYPE_POLL_ELEMENTS = 8,
    ORR_MSG_TYPE_ELEMENTS = 9,
    ORR_MSG_TYPE_POLL_NAVDATA = 10,
    ORR_MSG_TYPE_NAVDATA = 11,
    ORR_MSG_TYPE_POLL_DELAYS = 12,
    ORR_MSG_TYPE_DELAYS = 13,
    ORR_MSG_TYPE_POLL_CHANNELS = 14,
    ORR_MSG_TYPE_CHANNELS = 15,
    ORR_MSG_TYPE_POLL_IMU = 16,
    ORR_MSG_TYPE_IMU = 17,
    ORR_MSG_TYPE_POLL_TRUTH = 18,
    ORR_MSG_TYPE_TRUTH = 19,
    ORR_MSG_TYPE_SUBSCRIBE = 20,
    ORR_MSG_TYPE_SUBSCRIBED = 21,
    ORR_MSG_TYPE_UNSUBSCRIBE = 22,
    ORR_MSG_TYPE_CREDIT = 23,
    ORR_MSG_TYPE_GAP = 24,
    ORR_MSG_TYPE_STREAM_END = 25,
    ORR_MSG_TYPE_CONTROL = 26,
    ORR_MSG_TYPE_GET_TIME = 27,
    ORR_MSG_TYPE_TIME = 28,
    ORR_MSG_TYPE_RADIO_TIME = 29,
    ORR_MSG_TYPE_PACE = 30,
    ORR_MSG_TYPE_MOTION = 31,
    ORR_MSG_TYPE_GET_MOTION_STATS = 32,
    ORR_MSG_TYPE_MOTION_STATS = 33,
    ORR_MSG_TYPE_POLL_EVENTS = 34,
    ORR_MSG_TYPE_EVENTS = 35,
    ORR_MSG_TYPE_OPEN_DATAGRAMS = 36,
    ORR_MSG_TYPE_DATAGRAMS = 37,
    ORR_MSG_TYPE_OPEN_MOTION_RING = 38,
    ORR_MSG_TYPE_MOTION_RING = 39,
    ORR_MSG_TYPE_GET_MODES = 40,
    ORR_MSG_TYPE_MODES = 41,
};

enum { // error_code (u16): Why a request was refused or a connection is being closed.
    ORR_MSG_ERROR_CODE_BAD_MAGIC = 1, // the bytes are no frame of this protocol
    ORR_MSG_ERROR_CODE_BAD_LENGTH = 2, // the payload length is above the limit
    ORR_MSG_ERROR_CODE_BAD_CRC = 3, // the checksum does not match: bytes were lost or damaged
    ORR_MSG_ERROR_CODE_BAD_VERSION = 4, // no common major version
    ORR_MSG_ERROR_CODE_UNKNOWN_TYPE = 5, // no such message type in the server's version
    ORR_MSG_ERROR_CODE_BAD_PAYLOAD = 6, // the payload is shorter than its fields, or a count in it is above its limit
    ORR_MSG_ERROR_CODE_BAD_REQUEST = 7, // a value outside its domain, e.g. a step of zero with several epochs
    ORR_MSG_ERROR_CODE_LIMIT = 8, // more epochs or satellites than one request may ask for
    ORR_MSG_ERROR_CODE_NOT_SERVED = 9, // understood, but this scenario has nothing to answer it with
    ORR_MSG_ERROR_CODE_BUSY = 10, // as many clients are connected as the server allows
    ORR_MSG_ERROR_CODE_TIMEOUT = 11, // half a frame, or nothing, for longer than the server waits
    ORR_MSG_ERROR_CODE_CLOSING = 12, // the server is shutting down
    ORR_MSG_ERROR_CODE_INTERNAL = 13, // the server failed; its log says how
    ORR_MSG_ERROR_CODE_NOT_PERMITTED = 14, // the client may not do that (CAPS access): serve --read-only, or the access file gives it no such permission
};

enum { // answer (u8): Whether there are numbers, and if not, why not.
    ORR_MSG_ANSWER_OK = 0, // the numbers are there
    ORR_MSG_ANSWER_OUTSIDE_SPAN = 1, // the instant is outside the served span
    ORR_MSG_ANSWER_NO_ARC = 2, // the satellite has no valid arc at the instant
    ORR_MSG_ANSWER_NOT_SERVED = 3, // the satellite is not among those served
    ORR_MSG_ANSWER_BELOW_HORIZON = 4, // the satellite is below the receiver's horizon
    ORR_MSG_ANSWER_NO_VALUE = 5, // the ionosphere has a hole where the ray pierces it, or the arc is too short for the method
};

enum { // nav_message (u8): A navigation message, by the names of RINEX 4.
    ORR_MSG_NAV_MESSAGE_NONE = 0, // none
    ORR_MSG_NAV_MESSAGE_LNAV = 1, // GPS, QZSS: IS-GPS-200, subframes of 300 bits in 6 s; NavIC: IRNSS SIS ICD, subframes of 292 bits
    ORR_MSG_NAV_MESSAGE_CNAV = 2, // GPS, QZSS on L2C and L5: messages of 300 bits
    ORR_MSG_NAV_MESSAGE_CNV1 = 3, // BeiDou B-CNAV1 on B1C: frames of 878 bits in 18 s
    ORR_MSG_NAV_MESSAGE_CNV2 = 4, // GPS, QZSS: CNAV-2 on L1C, frames of 883 bits in 18 s; BeiDou: B-CNAV2 on B2a, messages of 312 bits in 3 s
    ORR_MSG_NAV_MESSAGE_CNV3 = 5, // BeiDou B-CNAV3 on B2b: messages of 514 bits in 1 s
    ORR_MSG_NAV_MESSAGE_INAV = 6, // Galileo I/NAV on E1 and E5b: OS SIS ICD, pages of 240 bits in 2 s
    ORR_MSG_NAV_MESSAGE_FNAV = 7, // Galileo F/NAV on E5a: pages of 244 bits in 10 s
    ORR_MSG_NAV_MESSAGE_D1 = 8, // BeiDou D1: BDS-SIS-ICD-B1I, subframes of 300 bits in 6 s
    ORR_MSG_NAV_MESSAGE_D2 = 9, // BeiDou D2 of geostationary satellites: frames of 1500 bits in 3 s, five subframes of 300
    ORR_MSG_NAV_MESSAGE_FDMA = 10, // GLONASS L1 and L2: ICD edition 5.1, strings of 85 bits in 2 s
    ORR_MSG_NAV_MESSAGE_SBAS = 11, // SBAS: RTCA DO-229, messages of 250 bits in 1 s
};

enum { // nav_form (u8): In which form pages of navigation messages are given.
    ORR_MSG_NAV_FORM_BITS = 0, // the message's bits with the checks that belong to it (parity, CRC) and tails
    ORR_MSG_NAV_FORM_SYMBOLS = 1, // what a modulator takes: error correction, interleaving and synchronisation are done; of GLONASS relative code, meander and time mark. Secondary codes are the generator's
};

enum { // elements_frame (u8): Axes that Kepler elements refer to.
    ORR_MSG_ELEMENTS_FRAME_DATE = 0, // true equator and equinox of date
    ORR_MSG_ELEMENTS_FRAME_J2000 = 1, // GCRS
    ORR_MSG_ELEMENTS_FRAME_ECEF = 2, // axes of ecef, frozen at the epoch, for MEAN through its whole revolution
};

enum { // elements_method (u8): How Kepler elements are made.
    ORR_MSG_ELEMENTS_METHOD_STATE = 0, // osculating, from position and velocity
    ORR_MSG_ELEMENTS_METHOD_THREE_POSITIONS = 1, // the plane through three positions 300 s apart; a is off by about 2 km
    ORR_MSG_ELEMENTS_METHOD_MEAN = 2, // osculating averaged over one revolution centred on the epoch
};

enum { // orbit_point (u8): The point of a satellite whose orbit is described.
    ORR_MSG_ORBIT_POINT_NONE = 0, // no orbit is described
    ORR_MSG_ORBIT_POINT_CENTRE_OF_MASS = 1, // the centre of mass
    ORR_MSG_ORBIT_POINT_PHASE_CENTRE = 2, // the antenna's phase centre; the centre of mass of a satellite marked NO_ANTENNA
};

enum { // receiver_source (u8): Where the receiver comes from that is used when a request names none.
    ORR_MSG_RECEIVER_SOURCE_NONE = 0, // there is none: a request has to name one
    ORR_MSG_RECEIVER_SOURCE_POSITION = 1, // the scenario's receiver.position
    ORR_MSG_RECEIVER_SOURCE_TRAJECTORY = 2, // a unit of the scenario's trajectory, where it is at each epoch
    ORR_MSG_RECEIVER_SOURCE_STATION = 3, // the station of the ionosphere's session
};

enum { // tec_origin (u8): What a delay came from.
    ORR_MSG_TEC_ORIGIN_FIELD = 0, // the field alone: maps, coefficients or the broadcast model
    ORR_MSG_TEC_ORIGIN_FUSED = 1, // the session's own carrier phases of the satellite, levelled
    ORR_MSG_TEC_ORIGIN_TRANSFERRED = 2, // the field, corrected, and the session's residual of the satellite carried to another ray
    ORR_MSG_TEC_ORIGIN_NOISE = 3, // the field, corrected, what neighbouring rays tell, and seeded noise: the station did not see the satellite
};

enum { // pacing (u8): When the blocks of a stream are made.
    ORR_MSG_PACING_FREE = 0, // as fast as there is credit and they are taken
    ORR_MSG_PACING_CLOCK = 1, // each so long before the scenario clock shows its instant as `lead` says
    ORR_MSG_PACING_MOTION = 2, // as soon as a sample of live motion reaches its begin, and at the latest as with CLOCK
};

enum { // delivery (u8): How the blocks of a stream come.
    ORR_MSG_DELIVERY_FRAMES = 0, // as frames of the connection
    ORR_MSG_DELIVERY_RING = 1, // in a ring of shared memory, whose descriptor comes with SUBSCRIBED over a Unix socket (docs/protocol.md, The ring)
    ORR_MSG_DELIVERY_DATAGRAMS = 2, // as UDP datagrams to `port` of the client's address, numbered, and sealed where the connection has TLS (docs/protocol.md, Datagrams)
};

enum { // seal (u8): What proves where a datagram comes from.
    ORR_MSG_SEAL_NONE = 0, // nothing: both ends are on one machine
    ORR_MSG_SEAL_HMAC_SHA256 = 1, // 32 bytes behind the frame, by keys of the TLS session
};

enum { // gap_reason (u8): Why blocks of a stream were left out.
    ORR_MSG_GAP_REASON_CREDIT = 1, // there was no credit before the clock had passed them
    ORR_MSG_GAP_REASON_LATE = 2, // they could not be made before the clock had passed them: the machine was busy, or the clock was set forward
};

enum { // end_reason (u8): Why a stream has ended.
    ORR_MSG_END_REASON_FINISHED = 1, // all epochs that were asked for have been sent
    ORR_MSG_END_REASON_UNSUBSCRIBED = 2, // as the client wished
    ORR_MSG_END_REASON_SLOW = 3, // its blocks were not taken although there was credit; other streams and clients do not wait for it
    ORR_MSG_END_REASON_OUTSIDE_SPAN = 4, // what is served ends there
    ORR_MSG_END_REASON_FAILED = 5, // the next block could not be made; the sentence says why
};

enum { // control_action (u8): What is to become of the scenario's clock.
    ORR_MSG_CONTROL_ACTION_LOAD = 1, // it stands at `t`, where STOP leads back to; of another scenario, which is served instead: all connections are closed, and taken again when it is ready
    ORR_MSG_CONTROL_ACTION_ARM = 2, // ready to start at `t`, or where it stands, with the reference that is named
    ORR_MSG_CONTROL_ACTION_WAIT_PPS = 3, // of an armed one: PPS0 is the next whole second of the reference, and `t` is the scenario's instant there
    ORR_MSG_CONTROL_ACTION_START = 4, // goes: after WAIT_PPS at PPS0 + delay; else at the wall's instant `at` + delay, or delay from now
    ORR_MSG_CONTROL_ACTION_PAUSE = 5, // stands where it is
    ORR_MSG_CONTROL_ACTION_STOP = 6, // stands at its begin
};

enum { // clock_reference (u8): What paces the scenario's clock.
    ORR_MSG_CLOCK_REFERENCE_WALL = 0, // the host's clock
    ORR_MSG_CLOCK_REFERENCE_RADIO = 1, // the generator's elapsed time (RADIO_TIME)
};

enum { // clock_state (u8): The scenario's clock.
    ORR_MSG_CLOCK_STATE_STOPPED = 0, // it stands at its begin
    ORR_MSG_CLOCK_STATE_ARMED = 1, // a start is awaited
    ORR_MSG_CLOCK_STATE_WAITING = 2, // the start is fixed, or PPS0 is, and to come
    ORR_MSG_CLOCK_STATE_RUNNING = 3, // it runs
    ORR_MSG_CLOCK_STATE_PAUSED = 4, // it stands where it was stopped
};

enum { // readings (u8): What inertial readings are.
    ORR_MSG_READINGS_IDEAL = 0, // those of perfect sensors
    ORR_MSG_READINGS_MEASURED = 1, // those of sensors with the scenario's errors (imu.errors)
};

enum { // stamp_clock (u8): Which clock of the server's host a stamp was read from.
    ORR_MSG_STAMP_CLOCK_ARRIVAL = 0, // none: the message's arrival counts
    ORR_MSG_STAMP_CLOCK_MONOTONIC = 1, // CLOCK_MONOTONIC
    ORR_MSG_STAMP_CLOCK_TAI = 2, // CLOCK_TAI, which PTP may keep on several hosts
    ORR_MSG_STAMP_CLOCK_REALTIME = 3, // CLOCK_REALTIME, Unix time
};

enum { // motion_state (u8): Where an antenna's motion of a block comes from.
    ORR_MSG_MOTION_STATE_SCENARIO = 0, // the scenario's own trajectory or place
    ORR_MSG_MOTION_STATE_SYNCHRONOUS = 1, // live: the sample of the block's begin was there
    ORR_MSG_MOTION_STATE_INTERPOLATED = 2, // live: between two samples
    ORR_MSG_MOTION_STATE_EXTRAPOLATED = 3, // live: beyond the last sample
    ORR_MSG_MOTION_STATE_JOINING = 4, // live: on the way from what was predicted to what is known now
    ORR_MSG_MOTION_STATE_SNAPPED = 5, // live: jumps here, as the sample asked
};

enum { // motion_point (u8): The point whose motion is told.
    ORR_MSG_MOTION_POINT_BODY = 0, // the body's own point; antennas ride on it by their lever arms
    ORR_MSG_MOTION_POINT_ANTENNA = 1, // the antennas' reference point itself: lever arms are left out
};

enum { // event_kind (u8): What an event is.
    ORR_MSG_EVENT_KIND_RISE = 1, // the antenna sees the satellite from then on
    ORR_MSG_EVENT_KIND_SET = 2, // and from then on it does not
    ORR_MSG_EVENT_KIND_ARC_BEGIN = 3, // first instant of an arc of the satellite's orbit
    ORR_MSG_EVENT_KIND_ARC_END = 4, // and the last one
    ORR_MSG_EVENT_KIND_EPHEMERIS = 5, // another set of a navigation message goes on the air; value: its issue
    ORR_MSG_EVENT_KIND_HEALTH = 6, // with another health; value: the health that is sent
    ORR_MSG_EVENT_KIND_LEAP_SECOND = 7, // value: GPS time minus UTC from then on, s
    ORR_MSG_EVENT_KIND_ECLIPSE_BEGIN = 8, // the satellite goes over to the Earth's shadow (penumbra)
    ORR_MSG_EVENT_KIND_ECLIPSE_END = 9, // and back to sunlight
    ORR_MSG_EVENT_KIND_MANOEUVRE_BEGIN = 10, // the satellite's orbit is being changed
    ORR_MSG_EVENT_KIND_MANOEUVRE_END = 11, // and is not any more
    ORR_MSG_EVENT_KIND_MOTION_BEGIN = 12, // the scenario's body is there from then on
    ORR_MSG_EVENT_KIND_MOTION_END = 13, // and is not there afterwards
    ORR_MSG_EVENT_KIND_FAULT_BEGIN = 14, // a fault of the scenario begins; value: which of them, from 0 in their order there
    ORR_MSG_EVENT_KIND_FAULT_END = 15, // and is over
};

enum { // mode_kind (u8): What of the service can be in one mode or another.
    ORR_MSG_MODE_KIND_CLOCK = 0, // the scenario's clock
    ORR_MSG_MODE_KIND_REFERENCE = 1, // what paces it
    ORR_MSG_MODE_KIND_GENERATOR = 2, // the lock to the generator's time (RADIO_TIME)
    ORR_MSG_MODE_KIND_MOTION = 3, // where the motion of the last block comes from (motion_state)
};

enum { // mode (u8): A mode of the service.
    ORR_MSG_MODE_STOPPED = 0, // CLOCK: it stands at its begin
    ORR_MSG_MODE_ARMED = 1, // CLOCK: a start is awaited
    ORR_MSG_MODE_WAITING = 2, // CLOCK: the start is fixed, or PPS0 is, and to come
    ORR_MSG_MODE_RUNNING = 3, // CLOCK: it runs
    ORR_MSG_MODE_PAUSED = 4, // CLOCK: it stands where it was stopped
    ORR_MSG_MODE_WALL = 16, // REFERENCE: the wall's clock
    ORR_MSG_MODE_RADIO = 17, // REFERENCE: the generator
    ORR_MSG_MODE_SILENT = 32, // GENERATOR: no RADIO_TIME has come, or none for 2 s: its last rate holds
    ORR_MSG_MODE_LOCKED = 33, // GENERATOR: the loop follows it
    ORR_MSG_MODE_STEPPING = 34, // GENERATOR: its last RADIO_TIME was far off; when the next is so too the lock is taken up anew
    ORR_MSG_MODE_SCENARIO = 48, // MOTION: the scenario's own trajectory
    ORR_MSG_MODE_SYNCHRONOUS = 49, // MOTION: the sample of the block's begin was there
    ORR_MSG_MODE_INTERPOLATED = 50, // MOTION: between two samples
    ORR_MSG_MODE_EXTRAPOLATED = 51, // MOTION: beyond the last sample
    ORR_MSG_MODE_JOINING = 52, // MOTION: on the way from what was predicted to what is known now
    ORR_MSG_MODE_SNAPPED = 53, // MOTION: jumps here, as the sample asked
};

// access (u16): What this client may not do, and how it came.
#define ORR_MSG_ACCESS_NO_READING ((uint16_t)(UINT64_C(1) << 0)) // no polls and no streams
#define ORR_MSG_ACCESS_NO_MOTION ((uint16_t)(UINT64_C(1) << 1)) // no MOTION
#define ORR_MSG_ACCESS_NO_CONTROL ((uint16_t)(UINT64_C(1) << 2)) // no CONTROL and no RADIO_TIME
#define ORR_MSG_ACCESS_INSECURE ((uint16_t)(UINT64_C(1) << 3)) // the address can be reached from other machines without authentication: anybody may be here

// channel_flags (u32): What should be known of a channel.
#define ORR_MSG_CHANNEL_FLAGS_UNHEALTHY ((uint32_t)(UINT64_C(1) << 0)) // the scenario marks the satellite as not to be used
#define ORR_MSG_CHANNEL_FLAGS_ECLIPSE ((uint32_t)(UINT64_C(1) << 1)) // the satellite is in the umbra or penumbra of the Earth
#define ORR_MSG_CHANNEL_FLAGS_FAST_TURN ((uint32_t)(UINT64_C(1) << 2)) // near noon or midnight, where true satellites turn slower than the nominal attitude that is used
#define ORR_MSG_CHANNEL_FLAGS_NO_ANTENNA ((uint32_t)(UINT64_C(1) << 3)) // the scenario's ANTEX file does not know the satellite: its centre of mass sends
#define ORR_MSG_CHANNEL_FLAGS_NO_DELAY ((uint32_t)(UINT64_C(1) << 4)) // the scenario's biases do not tell this signal's group delay: zero is taken
#define ORR_MSG_CHANNEL_FLAGS_ZERO_CLOCK ((uint32_t)(UINT64_C(1) << 5)) // the orbits have no clock of the satellite: zero is taken (channel.clock_holes)
#define ORR_MSG_CHANNEL_FLAGS_NOMINAL_CHANNEL ((uint32_t)(UINT64_C(1) << 6)) // GLONASS: the frequency channel is the nominal one of the slot
#define ORR_MSG_CHANNEL_FLAGS_FAULT ((uint32_t)(UINT64_C(1) << 7)) // faults of the scenario befall it

// delay_flags (u8): What holds for a delay.
#define ORR_MSG_DELAY_FLAGS_CLIPPED ((uint8_t)(UINT64_C(1) << 0)) // the content came out negative and is given as 0

// state_flags (u32): What holds for a satellite's state.
#define ORR_MSG_STATE_FLAGS_CLOCK_VALID ((uint32_t)(UINT64_C(1) << 0)) // clock_s and clock_rate_sps are there (NAN otherwise)
#define ORR_MSG_STATE_FLAGS_PREDICTED ((uint32_t)(UINT64_C(1) << 1)) // the input was predicted, or bridged without input
#define ORR_MSG_STATE_FLAGS_MANOEUVRE ((uint32_t)(UINT64_C(1) << 2)) // within a manoeuvre's interval
#define ORR_MSG_STATE_FLAGS_CLOCK_EVENT ((uint32_t)(UINT64_C(1) << 3)) // the input flagged a clock event at a neighbouring node
#define ORR_MSG_STATE_FLAGS_ECLIPSE ((uint32_t)(UINT64_C(1) << 4)) // in the umbra or penumbra of the Earth
#define ORR_MSG_STATE_FLAGS_GAP ((uint32_t)(UINT64_C(1) << 5)) // between input nodes further apart than twice the usual
#define ORR_MSG_STATE_FLAGS_JOINT ((uint32_t)(UINT64_C(1) << 6)) // between the orbits of two input files that do not meet
#define ORR_MSG_STATE_FLAGS_SHADOW_NOISE ((uint32_t)(UINT64_C(1) << 7)) // the input's orbits are noisier near the Earth's shadow; sigma is less sure

// nav_messages (u32): Several navigation messages.
#define ORR_MSG_NAV_MESSAGES_LNAV ((uint32_t)(UINT64_C(1) << 1)) // nav_message LNAV
#define ORR_MSG_NAV_MESSAGES_CNAV ((uint32_t)(UINT64_C(1) << 2)) // nav_message CNAV
#define ORR_MSG_NAV_MESSAGES_CNV1 ((uint32_t)(UINT64_C(1) << 3)) // nav_message CNV1
#define ORR_MSG_NAV_MESSAGES_CNV2 ((uint32_t)(UINT64_C(1) << 4)) // nav_message CNV2
#define ORR_MSG_NAV_MESSAGES_CNV3 ((uint32_t)(UINT64_C(1) << 5)) // nav_message CNV3
#define ORR_MSG_NAV_MESSAGES_INAV ((uint32_t)(UINT64_C(1) << 6)) // nav_message INAV
#define ORR_MSG_NAV_MESSAGES_FNAV ((uint32_t)(UINT64_C(1) << 7)) // nav_message FNAV
#define ORR_MSG_NAV_MESSAGES_D1 ((uint32_t)(UINT64_C(1) << 8)) // nav_message D1
#define ORR_MSG_NAV_MESSAGES_D2 ((uint32_t)(UINT64_C(1) << 9)) // nav_message D2
#define ORR_MSG_NAV_MESSAGES_FDMA ((uint32_t)(UINT64_C(1) << 10)) // nav_message FDMA
#define ORR_MSG_NAV_MESSAGES_SBAS ((uint32_t)(UINT64_C(1) << 11)) // nav_message SBAS

// nav_notes (u32): What should be known of a broadcast set.
#define ORR_MSG_NAV_NOTES_MANOEUVRE ((uint32_t)(UINT64_C(1) << 0)) // a manoeuvre within the window, or files that do not meet: marked unhealthy
#define ORR_MSG_NAV_NOTES_SHIFTED ((uint32_t)(UINT64_C(1) << 1)) // the orbit begins or ends within the window: fitted to the nearest full one
#define ORR_MSG_NAV_NOTES_NO_CLOCK ((uint32_t)(UINT64_C(1) << 2)) // the product has no clock: zero is sent
#define ORR_MSG_NAV_NOTES_NO_ANTENNA ((uint32_t)(UINT64_C(1) << 3)) // the scenario's ANTEX file does not know the antenna: the centre of mass is described
#define ORR_MSG_NAV_NOTES_NO_DELAY ((uint32_t)(UINT64_C(1) << 4)) // the scenario's biases do not have the satellite: a group delay of zero is sent
#define ORR_MSG_NAV_NOTES_NOMINAL_CHANNEL ((uint32_t)(UINT64_C(1) << 5)) // GLONASS: the frequency channel is the nominal one of the slot
#define ORR_MSG_NAV_NOTES_CLOCK_JUMP ((uint32_t)(UINT64_C(1) << 6)) // the clock jumps, or is off a straight line by more than 10 ns RMS: marked unhealthy
#define ORR_MSG_NAV_NOTES_FAULTY ((uint32_t)(UINT64_C(1) << 7)) // a fault of the scenario changes it, or how long it is sent

// (I8) Names as in the specification; NULL for a value that it does not know.
const char *orr_msg_type_name(uint16_t type);
const char *orr_msg_error_code_name(uint16_t value);
const char *orr_msg_answer_name(uint8_t value);
const char *orr_msg_nav_message_name(uint8_t value);
const char *orr_msg_nav_form_name(uint8_t value);
const char *orr_msg_elements_frame_name(uint8_t value);
const char *orr_msg_elements_method_name(uint8_t value);
const char *orr_msg_orbit_point_name(uint8_t value);
const char *orr_msg_receiver_source_name(uint8_t value);
const char *orr_msg_tec_origin_name(uint8_t value);
const char *orr_msg_pacing_name(uint8_t value);
const char *orr_msg_delivery_name(uint8_t value);
const char *orr_msg_seal_name(uint8_t value);
const char *orr_msg_gap_reason_name(uint8_t value);
const char *orr_msg_end_reason_name(uint8_t value);
const char *orr_msg_control_action_name(uint8_t value);
const char *orr_msg_clock_reference_name(uint8_t value);
const char *orr_msg_clock_state_name(uint8_t value);
const char *orr_msg_readings_name(uint8_t value);
const char *orr_msg_stamp_clock_name(uint8_t value);
const char *orr_msg_motion_state_name(uint8_t value);
const char *orr_msg_motion_point_name(uint8_t value);
const char *orr_msg_event_kind_name(uint8_t value);
const char *orr_msg_mode_kind_name(uint8_t value);
const char *orr_msg_mode_name(uint8_t value);
const char *orr_msg_access_name(unsigned bit);
const char *orr_msg_channel_flags_name(unsigned bit);
const char *orr_msg_delay_flags_name(unsigned bit);
const char *orr_msg_state_flags_name(unsigned bit);
const char *orr_msg_nav_messages_name(unsigned bit);
const char *orr_msg_nav_notes_name(unsigned bit);
// Whether the connection closes after it.
bool orr_msg_error_code_closes(uint16_t value);

// Bytes of the largest payload of all messages.
#define ORR_MSG_LARGEST 3304819u

// Least, greatest, last, median and 99th percentile of a time, over the samples that were counted; 0 without any.
typedef struct orr_msg_motion_spread {
    int64_t min; // [ns] least
    int64_t max; // [ns] greatest
    int64_t last; // [ns] last
    int64_t p50; // [ns] median, to 9 %
    int64_t p99; // [ns] 99th percentile, to 9 %
} orr_msg_motion_spread;
#define ORR_MSG_MOTION_SPREAD_SIZE 40u
#define ORR_MSG_MOTION_SPREAD_LARGEST 40u

// A satellite as IGS files name it.
typedef struct orr_msg_sat_id {
    uint8_t system; // letter: G R E C J I S L; any other is NOT_SERVED
    uint8_t number; // 1 to 99; any other is NOT_SERVED
} orr_msg_sat_id;
#define ORR_MSG_SAT_ID_SIZE 2u
#define ORR_MSG_SAT_ID_LARGEST 2u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_sat_id_next or orr_msg_sat_id_at.
typedef struct orr_msg_sat_id_list {
    uint16_t count;
    const orr_msg_sat_id *item;
    orr_wire_records wire;
} orr_msg_sat_id_list;
bool orr_msg_sat_id_next(const orr_msg_sat_id_list *list, orr_wire_iter *it, orr_msg_sat_id *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_SAT_ID_SIZE), then these.
orr_wire_status orr_msg_sat_id_records_encode(const orr_msg_sat_id_list *piece, orr_wire_writer *w);
bool orr_msg_sat_id_at(const orr_msg_sat_id_list *list, uint16_t index, orr_msg_sat_id *out);   // false beyond the end

// The instants of a request - t, t + step, ..., t + (count - 1) step. A request that has them is answered by count frames.
typedef struct orr_msg_epochs {
    int64_t t; // [ns] first epoch
    int64_t step; // [ns] from one epoch to the next; any sign, not 0 unless count is 1
    uint32_t count; // how many, 1 to MAX_EPOCHS
} orr_msg_epochs;
#define ORR_MSG_EPOCHS_SIZE 20u
#define ORR_MSG_EPOCHS_LARGEST 20u

// Which of the instants of a request a frame answers.
typedef struct orr_msg_epoch {
    int64_t t; // [ns] the instant
    uint32_t index; // which epoch of the request, from 0; the frame of count - 1 ends the answer
    uint32_t count; // how many epochs the request asked for
    uint8_t answer; // whether there are numbers at this instant
} orr_msg_epoch;
#define ORR_MSG_EPOCH_SIZE 17u
#define ORR_MSG_EPOCH_LARGEST 17u

// A length of time with both of its ends.
typedef struct orr_msg_span {
    int64_t first; // [ns] first instant; -2^63 where there is none
    int64_t last; // [ns] last instant; likewise
} orr_msg_span;
#define ORR_MSG_SPAN_SIZE 16u
#define ORR_MSG_SPAN_LARGEST 16u

// A request that is answered.
typedef struct orr_msg_served_request {
    uint16_t request; // its message type
    uint16_t answer; // message type of its answer
    orr_msg_span span; // instants at which there can be numbers; none of a request without epochs
} orr_msg_served_request;
#define ORR_MSG_SERVED_REQUEST_SIZE 20u
#define ORR_MSG_SERVED_REQUEST_LARGEST 20u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_served_request_next or orr_msg_served_request_at.
typedef struct orr_msg_served_request_list {
    uint16_t count;
    const orr_msg_served_request *item;
    orr_wire_records wire;
} orr_msg_served_request_list;
bool orr_msg_served_request_next(const orr_msg_served_request_list *list, orr_wire_iter *it, orr_msg_served_request *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_SERVED_REQUEST_SIZE), then these.
orr_wire_status orr_msg_served_request_records_encode(const orr_msg_served_request_list *piece, orr_wire_writer *w);
bool orr_msg_served_request_at(const orr_msg_served_request_list *list, uint16_t index, orr_msg_served_request *out);   // false beyond the end

// An inertial measurement unit of the scenario's vehicle.
typedef struct orr_msg_inertial_unit {
    uint16_t unit; // its number in POLL_IMU and POLL_TRUTH; 0 is the trajectory's own point
    orr_wire_bytes name; // its name in the scenario
    double lever_m[3]; // where it is from unit 0: to the right, forward, up in the vehicle's axes
    double heading_rad; // how it is mounted: heading against the vehicle's axes
    double pitch_rad; // likewise pitch
    double roll_rad; // likewise roll
} orr_msg_inertial_unit;
#define ORR_MSG_INERTIAL_UNIT_LARGEST 116u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_inertial_unit_next.
typedef struct orr_msg_inertial_unit_list {
    uint16_t count;
    const orr_msg_inertial_unit *item;
    orr_wire_records wire;
} orr_msg_inertial_unit_list;
bool orr_msg_inertial_unit_next(const orr_msg_inertial_unit_list *list, orr_wire_iter *it, orr_msg_inertial_unit *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_inertial_unit_records_encode(const orr_msg_inertial_unit_list *piece, orr_wire_writer *w);

// Leap seconds of UTC as the server knows them.
typedef struct orr_msg_leap_seconds {
    int16_t gps_utc_s; // GPS time minus UTC, in force at the first instant served
    int16_t next_gps_utc_s; // from `next` on; the same where no later change is known
    int64_t next; // [ns] first instant of the next value; -2^63 where no later change is known
} orr_msg_leap_seconds;
#define ORR_MSG_LEAP_SECONDS_SIZE 12u
#define ORR_MSG_LEAP_SECONDS_LARGEST 12u

// State of one satellite in the terrestrial frame of the input orbits (ecef). Numbers are NAN unless answer is OK.
typedef struct orr_msg_sat_state {
    orr_msg_sat_id sat; // which satellite
    uint8_t answer; // OK, NO_ARC or NOT_SERVED
    uint8_t reserved; // 0
    uint32_t flags; // 0 unless answer is OK
    double pos_m[3]; // position of the centre of mass
    double vel_mps[3]; // [m/s] its first derivative (ecef)
    double acc_mps2[3]; // [m/s2] its second derivative (ecef)
    double clock_s; // clock offset, periodic relativity not included
    double clock_rate_sps; // [s/s] its derivative
    int64_t valid_from; // [ns] start of the arc that was evaluated
    int64_t valid_to; // [ns] its end
    float sigma_m; // 1-sigma of the position, 3-D
    float clock_sigma_s; // 1-sigma of clock_s; NAN where there is no clock or it is not known
} orr_msg_sat_state;
#define ORR_MSG_SAT_STATE_SIZE 120u
#define ORR_MSG_SAT_STATE_LARGEST 120u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_sat_state_next or orr_msg_sat_state_at.
typedef struct orr_msg_sat_state_list {
    uint16_t count;
    const orr_msg_sat_state *item;
    orr_wire_records wire;
} orr_msg_sat_state_list;
bool orr_msg_sat_state_next(const orr_msg_sat_state_list *list, orr_wire_iter *it, orr_msg_sat_state *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_SAT_STATE_SIZE), then these.
orr_wire_status orr_msg_sat_state_records_encode(const orr_msg_sat_state_list *piece, orr_wire_writer *w);
bool orr_msg_sat_state_at(const orr_msg_sat_state_list *list, uint16_t index, orr_msg_sat_state *out);   // false beyond the end

// Kepler elements of one satellite. Numbers are NAN unless answer is OK.
typedef struct orr_msg_sat_elements {
    orr_msg_sat_id sat; // which satellite
    uint8_t answer; // OK, NO_ARC, NOT_SERVED, or NO_VALUE where the arc is too short for the method
    uint8_t reserved; // 0
    uint32_t flags; // of the state at the epoch; 0 unless answer is OK
    double a_m; // semi-major axis
    double e; // eccentricity
    double i_rad; // inclination
    double raan_rad; // right ascension of the ascending node, 0 to 2 pi
    double argp_rad; // argument of perigee; ill-determined in near-circular orbits
    double m_rad; // mean anomaly; likewise
    double u_rad; // argument of latitude
} orr_msg_sat_elements;
#define ORR_MSG_SAT_ELEMENTS_SIZE 64u
#define ORR_MSG_SAT_ELEMENTS_LARGEST 64u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_sat_elements_next or orr_msg_sat_elements_at.
typedef struct orr_msg_sat_elements_list {
    uint16_t count;
    const orr_msg_sat_elements *item;
    orr_wire_records wire;
} orr_msg_sat_elements_list;
bool orr_msg_sat_elements_next(const orr_msg_sat_elements_list *list, orr_wire_iter *it, orr_msg_sat_elements *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_SAT_ELEMENTS_SIZE), then these.
orr_wire_status orr_msg_sat_elements_records_encode(const orr_msg_sat_elements_list *piece, orr_wire_writer *w);
bool orr_msg_sat_elements_at(const orr_msg_sat_elements_list *list, uint16_t index, orr_msg_sat_elements *out);   // false beyond the end

// A subframe, string, page or message as it is sent. Its k-th bit or symbol begins at t + k length / bits.
typedef struct orr_msg_nav_page {
    int64_t t; // [ns] begin of its first bit
    int64_t length; // [ns] from there to the end of its last; 1.7 s for GLONASS' bits, whose time mark is not among them
    uint8_t number; // LNAV, D1: subframe 1-5; D2: page 1-10 of subframe 1; GLONASS: string 1-15; INAV: word type; FNAV: page type; NavIC: subframe 1-4; CNV1, and CNV2 of GPS and QZSS: page of subframe 3; others: message type
    uint8_t page; // LNAV, D1: page of subframes 4 and 5, 0 otherwise; D2: page 1-120 of subframe 5; GLONASS: frame 1-5 of the superframe; INAV, FNAV: sub-frame 1-24, 1-12 of the frame; NavIC: message of subframes 3 and 4
    uint16_t bits; // how many bits or symbols
    orr_wire_bytes data; // the first in time is the highest bit of the first byte; what is left of the last is 0
} orr_msg_nav_page;
#define ORR_MSG_NAV_PAGE_LARGEST 248u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_nav_page_next.
typedef struct orr_msg_nav_page_list {
    uint16_t count;
    const orr_msg_nav_page *item;
    orr_wire_records wire;
} orr_msg_nav_page_list;
bool orr_msg_nav_page_next(const orr_msg_nav_page_list *list, orr_wire_iter *it, orr_msg_nav_page *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_nav_page_records_encode(const orr_msg_nav_page_list *piece, orr_wire_writer *w);

// Kepler elements of a message, on its lattice (the names are those of IS-GPS-200N tables 20-III and 30-I).
typedef struct orr_msg_kepler_set {
    double sqrt_a_sqrtm; // [sqrt(m)] root of the semi-major axis
    double e; // eccentricity
    double m0_rad; // mean anomaly at toe
    double i0_rad; // inclination at toe
    double omega0_rad; // longitude of the node at the week's begin
    double omega_rad; // argument of perigee
    double delta_n_radps; // [rad/s] mean motion difference
    double idot_radps; // [rad/s] rate of the inclination
    double omega_dot_radps; // [rad/s] rate of the node
    double cuc_rad; // cosine term of the argument of latitude
    double cus_rad; // its sine term
    double crc_m; // cosine term of the radius
    double crs_m; // its sine term
    double cic_rad; // cosine term of the inclination
    double cis_rad; // its sine term
    double a_dot_mps; // [m/s] rate of the semi-major axis; 0 in messages without it
    double delta_n_dot_radps2; // [rad/s2] rate of the mean motion difference; 0 likewise
    double tgd_s; // group delay of the first signal of the message's system behind its clock: TGD of LNAV and CNAV, BGD(E1,E5b) of INAV, BGD(E1,E5a) of FNAV, TGD1 of D1 and D2, TGD of the B1C pilot of CNV1 and CNV2, TGD of B2b of CNV3
} orr_msg_kepler_set;
#define ORR_MSG_KEPLER_SET_SIZE 144u
#define ORR_MSG_KEPLER_SET_LARGEST 144u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_kepler_set_next or orr_msg_kepler_set_at.
typedef struct orr_msg_kepler_set_list {
    uint16_t count;
    const orr_msg_kepler_set *item;
    orr_wire_records wire;
} orr_msg_kepler_set_list;
bool orr_msg_kepler_set_next(const orr_msg_kepler_set_list *list, orr_wire_iter *it, orr_msg_kepler_set *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_KEPLER_SET_SIZE), then these.
orr_wire_status orr_msg_kepler_set_records_encode(const orr_msg_kepler_set_list *piece, orr_wire_writer *w);
bool orr_msg_kepler_set_at(const orr_msg_kepler_set_list *list, uint16_t index, orr_msg_kepler_set *out);   // false beyond the end

// What strings 1 to 4 hold beside the clock, on the message's lattice (GLONASS ICD 5.1, table 4.5); of SBAS what message 9 holds.
typedef struct orr_msg_glonass_set {
    double pos_m[3]; // position at toe (t_b), PZ-90; of SBAS at t0, WGS 84
    double vel_mps[3]; // [m/s] velocity at toe
    double acc_mps2[3]; // [m/s2] acceleration by Sun and Moon; of SBAS all of it
    double delta_tau_s; // L2 behind L1; of SBAS 0
    int8_t channel; // frequency channel -7 to 6; of SBAS 0
    uint8_t reserved; // 0
} orr_msg_glonass_set;
#define ORR_MSG_GLONASS_SET_SIZE 82u
#define ORR_MSG_GLONASS_SET_LARGEST 82u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_glonass_set_next or orr_msg_glonass_set_at.
typedef struct orr_msg_glonass_set_list {
    uint16_t count;
    const orr_msg_glonass_set *item;
    orr_wire_records wire;
} orr_msg_glonass_set_list;
bool orr_msg_glonass_set_next(const orr_msg_glonass_set_list *list, orr_wire_iter *it, orr_msg_glonass_set *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_GLONASS_SET_SIZE), then these.
orr_wire_status orr_msg_glonass_set_records_encode(const orr_msg_glonass_set_list *piece, orr_wire_writer *w);
bool orr_msg_glonass_set_at(const orr_msg_glonass_set_list *list, uint16_t index, orr_msg_glonass_set *out);   // false beyond the end

// One message that a satellite sends, on signals that carry the same bits. Numbers are NAN, times no instant, issues -1 and lists empty unless answer is OK.
typedef struct orr_msg_sat_navdata {
    orr_msg_sat_id sat; // which satellite
    uint8_t answer; // OK, NO_ARC (it sends nothing then), NOT_SERVED (no such data could be made of it), or NO_VALUE (a value does not fit its field)
    uint8_t message; // NONE where the satellite has none of those asked for
    uint8_t form; // of the pages, as asked
    orr_wire_bytes signals; // names of the signals that carry it, as in CAPS, divided by blanks: L1OF L2OF
    uint32_t notes; // 0 unless answer is OK
    int64_t set_from; // [ns] the set is sent from then on
    int64_t set_to; // [ns] and before then
    int64_t toe; // [ns] reference of the orbit
    int64_t toc; // [ns] reference of the clock
    int32_t week; // week of toe: GPS', of BeiDou its own; -1 for GLONASS
    int16_t iode; // issue of the orbit: IODE, IODnav, AODE; -1 for GLONASS
    int16_t iodc; // issue of the clock: IODC, AODC; -1 where the message has none of its own
    uint32_t health; // 0 is good; LNAV: six bits; INAV, FNAV: the bits of RINEX 3.05; others: 1 for unfit
    double accuracy_m; // user range or signal in space accuracy that is sent; NAN for GLONASS
    double fit_rms_m; // 3-D RMS of the rounded set against the orbit, over its window
    double fit_max_m; // largest of these distances
    double clock_rms_s; // the same of the clock; NAN with NO_CLOCK
    double af0_s; // clock at toc; GLONASS: -tau_n
    double af1_sps; // [s/s] its rate; GLONASS: gamma_n
    double af2_sps2; // [s/s2] its second coefficient; 0 for GLONASS
    int64_t frame_from; // [ns] begin of the frame of the message that holds the epoch
    int64_t frame_to; // [ns] its end: the next frame's begin
    orr_msg_kepler_set_list kepler; // of messages with Kepler elements: one
    orr_msg_glonass_set_list glonass; // of FDMA and SBAS: one
    orr_msg_nav_page_list pages; // all of the frame
} orr_msg_sat_navdata;
#define ORR_MSG_SAT_NAVDATA_LARGEST 4129u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_sat_navdata_next.
typedef struct orr_msg_sat_navdata_list {
    uint16_t count;
    const orr_msg_sat_navdata *item;
    orr_wire_records wire;
} orr_msg_sat_navdata_list;
bool orr_msg_sat_navdata_next(const orr_msg_sat_navdata_list *list, orr_wire_iter *it, orr_msg_sat_navdata *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_sat_navdata_records_encode(const orr_msg_sat_navdata_list *piece, orr_wire_writer *w);

// The ionosphere between a receiver and one satellite. Numbers are NAN unless answer is OK.
typedef struct orr_msg_sat_delay {
    orr_msg_sat_id sat; // which satellite
    uint8_t answer; // OK, NO_ARC, NOT_SERVED, BELOW_HORIZON or NO_VALUE
    uint8_t origin; // what it came from
    uint8_t flags; // 0 unless answer is OK
    uint8_t reserved; // 0
    double az_rad; // azimuth, clockwise from North
    double el_rad; // elevation above the ellipsoidal horizon
    double pierce_lat_rad; // geocentric latitude of the pierce point
    double pierce_lon_rad; // its longitude, East
    double mapping; // slant over vertical
    double stec_tecu; // [TECU] slant total electron content
    double model_stec_tecu; // [TECU] the part of the field as it is
    double delay_m[4]; // delay of a code on each carrier asked for, NAN beyond them; a carrier phase is early by it
    float sigma_tecu; // [TECU] 1-sigma of stec_tecu, NAN where unknown
} orr_msg_sat_delay;
#define ORR_MSG_SAT_DELAY_SIZE 98u
#define ORR_MSG_SAT_DELAY_LARGEST 98u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_sat_delay_next or orr_msg_sat_delay_at.
typedef struct orr_msg_sat_delay_list {
    uint16_t count;
    const orr_msg_sat_delay *item;
    orr_wire_records wire;
} orr_msg_sat_delay_list;
bool orr_msg_sat_delay_next(const orr_msg_sat_delay_list *list, orr_wire_iter *it, orr_msg_sat_delay *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_SAT_DELAY_SIZE), then these.
orr_wire_status orr_msg_sat_delay_records_encode(const orr_msg_sat_delay_list *piece, orr_wire_writer *w);
bool orr_msg_sat_delay_at(const orr_msg_sat_delay_list *list, uint16_t index, orr_msg_sat_delay *out);   // false beyond the end

// An antenna that receives the scenario's signals.
typedef struct orr_msg_antenna {
    uint16_t antenna; // its number in POLL_CHANNELS
    orr_wire_bytes name; // its name in the scenario
    orr_wire_bytes kind; // antenna and radome as ANTEX files write them; empty where the phase centre is the reference point
    double pos_m[3]; // reference point of a fixed antenna (ecef); NAN where it moves
} orr_msg_antenna;
#define ORR_MSG_ANTENNA_LARGEST 114u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_antenna_next.
typedef struct orr_msg_antenna_list {
    uint16_t count;
    const orr_msg_antenna *item;
    orr_wire_records wire;
} orr_msg_antenna_list;
bool orr_msg_antenna_next(const orr_msg_antenna_list *list, orr_wire_iter *it, orr_msg_antenna *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_antenna_records_encode(const orr_msg_antenna_list *piece, orr_wire_writer *w);

// A signal that the scenario's satellites send - one carrier with all its components.
typedef struct orr_msg_signal {
    uint16_t signal; // its number in POLL_CHANNELS and CHANNELS
    uint8_t system; // letter of the system
    orr_wire_bytes name; // its name, e.g. L1CA
    orr_wire_bytes observation; // RINEX 3 band and attribute, e.g. 1C
    orr_wire_bytes modulation; // e.g. BPSK(1)
    orr_wire_bytes components; // divided by blanks, e.g. I Q
    double carrier_hz; // [Hz] carrier; of GLONASS' FDMA signals that of channel 0
    double channel_hz; // [Hz] step of a GLONASS frequency channel; 0 for others
    double chips_per_s; // [chip/s] rate of the ranging code
    uint64_t chips; // length of one period of the primary code
} orr_msg_signal;
#define ORR_MSG_SIGNAL_LARGEST 115u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_signal_next.
typedef struct orr_msg_signal_list {
    uint16_t count;
    const orr_msg_signal *item;
    orr_wire_records wire;
} orr_msg_signal_list;
bool orr_msg_signal_next(const orr_msg_signal_list *list, orr_wire_iter *it, orr_msg_signal *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_signal_records_encode(const orr_msg_signal_list *piece, orr_wire_writer *w);

// A satellite that sends.
typedef struct orr_msg_transmitter {
    orr_msg_sat_id sat; // which satellite
    int8_t frequency_channel; // GLONASS: -7 to 6; 0 for others
    uint8_t unhealthy; // 1 where the scenario marks it as not to be used, else 0
    orr_wire_bytes svn; // space vehicle as ANTEX names it, e.g. G063; empty without ANTEX
    orr_wire_bytes block; // type of the satellite as ANTEX names it, e.g. BLOCK IIF; empty without ANTEX
} orr_msg_transmitter;
#define ORR_MSG_TRANSMITTER_LARGEST 38u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_transmitter_next.
typedef struct orr_msg_transmitter_list {
    uint16_t count;
    const orr_msg_transmitter *item;
    orr_wire_records wire;
} orr_msg_transmitter_list;
bool orr_msg_transmitter_next(const orr_msg_transmitter_list *list, orr_wire_iter *it, orr_msg_transmitter *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_transmitter_records_encode(const orr_msg_transmitter_list *piece, orr_wire_writer *w);

// One channel over the block of its message; with s the seconds since the block's begin, code and carrier are the cubics c[0] + c[1] s + c[2] s^2 + c[3] s^3. The receiver's clock is perfect.
typedef struct orr_msg_sat_channel {
    orr_msg_sat_id sat; // which satellite
    uint16_t signal; // which signal, its number in CAPS
    uint32_t flags; // what should be known of it
    double az_rad; // azimuth of the satellite at the block's begin, clockwise from North
    double el_rad; // its elevation above the ellipsoidal horizon
    double carrier_hz; // [Hz] carrier
    double code[4]; // [m/s^k] cubic of the pseudorange
    int64_t carrier_cycles; // whole cycles of the carrier's phase range at the block's begin; an integer that stays while the satellite is in view is part of it
    double carrier[4]; // [cycle/s^k] cubic of the phase range, less carrier_cycles; the Doppler frequency is -carrier[1] at the begin, positive while approaching
    int64_t transmit; // reading of the satellite's clock when the code at the block's begin was sent: whole nanoseconds, the scale's whole seconds against GPS not taken off
    double transmit_fraction_ns; // and the rest, 0 to 1
    float power_dbw; // [dBW] received by an antenna of 0 dBi; of an echo what makes it as much weaker than its signal as the antenna receives it
    uint16_t echo; // 0: the signal itself; from 1 on an echo of it, which sends the same: the ground, then the reflectors of the scenario; 256 times 1 and so on: a false signal of the first spoofer and so on
} orr_msg_sat_channel;
#define ORR_MSG_SAT_CHANNEL_SIZE 126u
#define ORR_MSG_SAT_CHANNEL_LARGEST 126u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_sat_channel_next or orr_msg_sat_channel_at.
typedef struct orr_msg_sat_channel_list {
    uint16_t count;
    const orr_msg_sat_channel *item;
    orr_wire_records wire;
} orr_msg_sat_channel_list;
bool orr_msg_sat_channel_next(const orr_msg_sat_channel_list *list, orr_wire_iter *it, orr_msg_sat_channel *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_SAT_CHANNEL_SIZE), then these.
orr_wire_status orr_msg_sat_channel_records_encode(const orr_msg_sat_channel_list *piece, orr_wire_writer *w);
bool orr_msg_sat_channel_at(const orr_msg_sat_channel_list *list, uint16_t index, orr_msg_sat_channel *out);   // false beyond the end

// A transmitter that disturbs, as an antenna receives it at the block's begin; what it sends is the generator's to make.
typedef struct orr_msg_jammer {
    uint16_t number; // its place in the scenario's list
    orr_wire_bytes waveform; // the scenario's name of what it sends
    double az_rad; // azimuth, clockwise from North
    double el_rad; // elevation above the ellipsoidal horizon
    double range_m; // distance
    double range_rate_mps; // [m/s] its rate
    double carrier_hz; // [Hz] carrier as it is sent
    double doppler_hz; // [Hz] by which it arrives higher
    float power_dbw; // [dBW] received by an antenna of 0 dBi, free space between
} orr_msg_jammer;
#define ORR_MSG_JAMMER_LARGEST 88u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_jammer_next.
typedef struct orr_msg_jammer_list {
    uint16_t count;
    const orr_msg_jammer *item;
    orr_wire_records wire;
} orr_msg_jammer_list;
bool orr_msg_jammer_next(const orr_msg_jammer_list *list, orr_wire_iter *it, orr_msg_jammer *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL), then these.
orr_wire_status orr_msg_jammer_records_encode(const orr_msg_jammer_list *piece, orr_wire_writer *w);

// What a code at the block's begin is the sum of, in metres; of the carrier the ionosphere (and its emission part, and disturbance) has the other sign, its second order the other sign and half the size, wind_up and phase_bias join, scintillation, land_mobile and echo_phase join, residual_carrier too; group_delay, receiver_delay, residual_code and fault_divergence do not.
typedef struct orr_msg_channel_terms {
    double distance_m; // antenna to centre of mass, in the Earth's axes of emission and of reception, not turned
    double sagnac_m; // rotation of the Earth during the flight
    double shapiro_m; // relativistic delay in the Earth's field
    double satellite_clock_m; // minus c times the satellite's clock offset
    double clock_noise_m; // minus c times the noise of that clock between the nodes of its product
    double relativity_m; // minus c times the periodic relativity of that clock
    double group_delay_m; // c times the signal's group delay against the clock's pair
    double satellite_antenna_m; // phase centre of the satellite's antenna: offset and variation
    double receiver_antenna_m; // likewise of the receiver's
    double solid_tide_m; // tide of the solid Earth below a fixed antenna
    double pole_tide_m; // tide of the pole's wandering, likewise
    double ocean_loading_m; // weight of the ocean's tides, likewise
    double troposphere_hydrostatic_m; // hydrostatic delay
    double troposphere_wet_m; // wet delay
    double turbulence_m; // turbulence of water vapour: wet delay beside that
    double ionosphere_m; // first order, of the code
    double emission_m; // the satellite's motion while the signal is delayed, without the ionosphere's part
    double emission_ionosphere_m; // the ionosphere's part
    double wind_up_m; // turns of satellite and antenna, times the wavelength: of the carrier alone
    double phase_bias_m; // the carrier's bias against the clock's pair of signals: of the carrier alone
    double ionosphere_second_m; // second order of the ionosphere, of the code; 0 unless the scenario asks for it
    double receiver_delay_m; // replay: delay of the recorded receiver's code, the same all day
    double residual_code_m; // replay: what noise, multipath and the models' errors left of the recorded code
    double residual_carrier_m; // replay: likewise of the carrier; it is in the carrier alone
    double disturbance_m; // travelling disturbances and fronts of the ionosphere, of the code
    double scintillation_m; // what irregularities of the ionosphere do to the phase: of the carrier alone
    double land_mobile_m; // what scattered rays of a road do to the phase: of the carrier alone
    double echo_m; // of an echo: how much longer its way is
    double echo_phase_m; // of an echo: what the reflection retards the carrier by, times the wavelength: of the carrier alone
    double spoofer_m; // of a false signal: the way from its transmitter, and the delay with which it sends
    double fault_range_m; // faults.range: steps and ramps
    double fault_noise_m; // faults.noise and faults.sine
    double fault_clock_m; // faults.clock: minus c times the clock's error
    double fault_divergence_m; // faults.divergence: of the code alone
    double fault_orbit_m; // faults.orbit: what the displaced satellite adds to the range
} orr_msg_channel_terms;
#define ORR_MSG_CHANNEL_TERMS_SIZE 280u
#define ORR_MSG_CHANNEL_TERMS_LARGEST 280u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_channel_terms_next or orr_msg_channel_terms_at.
typedef struct orr_msg_channel_terms_list {
    uint16_t count;
    const orr_msg_channel_terms *item;
    orr_wire_records wire;
} orr_msg_channel_terms_list;
bool orr_msg_channel_terms_next(const orr_msg_channel_terms_list *list, orr_wire_iter *it, orr_msg_channel_terms *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_CHANNEL_TERMS_SIZE), then these.
orr_wire_status orr_msg_channel_terms_records_encode(const orr_msg_channel_terms_list *piece, orr_wire_writer *w);
bool orr_msg_channel_terms_at(const orr_msg_channel_terms_list *list, uint16_t index, orr_msg_channel_terms *out);   // false beyond the end

// Something that happens at an instant.
typedef struct orr_msg_event {
    int64_t at; // [ns] when
    uint8_t kind; // what
    orr_msg_sat_id sat; // of which satellite; both numbers 0: of none
    uint8_t message; // of EPHEMERIS and HEALTH: of which message
    uint16_t antenna; // of RISE and SET: for which antenna of CAPS; 65535 otherwise
    int64_t value; // see kind; 0 where it has none
} orr_msg_event;
#define ORR_MSG_EVENT_SIZE 22u
#define ORR_MSG_EVENT_LARGEST 22u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_event_next or orr_msg_event_at.
typedef struct orr_msg_event_list {
    uint16_t count;
    const orr_msg_event *item;
    orr_wire_records wire;
} orr_msg_event_list;
bool orr_msg_event_next(const orr_msg_event_list *list, orr_wire_iter *it, orr_msg_event *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_EVENT_SIZE), then these.
orr_wire_status orr_msg_event_records_encode(const orr_msg_event_list *piece, orr_wire_writer *w);
bool orr_msg_event_at(const orr_msg_event_list *list, uint16_t index, orr_msg_event *out);   // false beyond the end

// The service went over from one mode to another.
typedef struct orr_msg_mode_change {
    uint64_t number; // 1, 2, ... since the scenario was loaded
    int64_t at; // [ns] the scenario's instant then; of MOTION the begin of the block
    uint8_t kind; // of what
    uint8_t before; // which it was
    uint8_t mode; // which it is from then on
    uint8_t reserved; // 0
    int64_t wall; // [ns] the wall's instant at which that was noted
} orr_msg_mode_change;
#define ORR_MSG_MODE_CHANGE_SIZE 28u
#define ORR_MSG_MODE_CHANGE_LARGEST 28u

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_mode_change_next or orr_msg_mode_change_at.
typedef struct orr_msg_mode_change_list {
    uint16_t count;
    const orr_msg_mode_change *item;
    orr_wire_records wire;
} orr_msg_mode_change_list;
bool orr_msg_mode_change_next(const orr_msg_mode_change_list *list, orr_wire_iter *it, orr_msg_mode_change *out); // false at the end
// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`
// of all, no item and no bytes (wire.size 0, wire.data not NULL, wire.stride ORR_MSG_MODE_CHANGE_SIZE), then these.
orr_wire_status orr_msg_mode_change_records_encode(const orr_msg_mode_change_list *piece, orr_wire_writer *w);
bool orr_msg_mode_change_at(const orr_msg_mode_change_list *list, uint16_t index, orr_msg_mode_change *out);   // false beyond the end

// Encoding appends the payload to the writer and returns its status. Decoding reads a payload; strings, blobs
// and lists borrow its bytes; bytes after the last known field are of a later minor version and are ignored.

// Opens a conversation. Optional, but a client that sends it learns what is served.
typedef struct orr_msg_hello {
    uint8_t major_min; // lowest major version the client speaks
    uint8_t major_max; // highest
    orr_wire_bytes name; // name of the client, for the server's log
    orr_wire_bytes version; // its version
} orr_msg_hello;
#define ORR_MSG_HELLO_LARGEST 102u

orr_wire_status orr_msg_hello_encode(const orr_msg_hello *m, orr_wire_writer *w);
orr_wire_status orr_msg_hello_decode(const uint8_t *payload, size_t size, orr_msg_hello *m);

// What the server is and what it serves.
typedef struct orr_msg_caps {
    uint8_t major; // version chosen for the conversation
    uint8_t minor; // minor version of the server
    uint32_t max_request; // bytes of payload it reads of one request
    uint32_t max_epochs; // epochs one POLL may ask for
    orr_msg_span span; // first and last instant at which anything is served
    orr_wire_bytes name; // name of the server
    orr_wire_bytes version; // its version
    orr_wire_bytes title; // title of the scenario
    orr_wire_bytes frame; // terrestrial frame of positions, e.g. IGS20
    orr_msg_leap_seconds leap; // leap second in force, and the next
    uint8_t navdata_point; // the point of a satellite whose orbit NAVDATA describes; STATES gives the centre of mass
    uint8_t receiver_source; // receiver that is used when a POLL_DELAYS names none
    uint16_t receiver_unit; // with TRAJECTORY: the unit whose point it is
    double receiver_m[3]; // where it is (ecef); NAN with NONE and TRAJECTORY
    double imu_rate_hz; // [Hz] readings a second where POLL_IMU has step 0; NAN where POLL_IMU is not answered
    orr_msg_inertial_unit_list units; // inertial units; none without a trajectory
    orr_msg_antenna_list antennas; // antennas that receive; none where no signals are sent
    orr_msg_signal_list signals; // signals that are sent
    orr_msg_transmitter_list transmitters; // satellites that send them
    orr_msg_served_request_list requests; // what is answered; anything else is refused with NOT_SERVED or UNKNOWN_TYPE
    orr_msg_sat_id_list satellites; // served satellites, in the order in which STATES lists them
    uint16_t access; // what this client may not do, and how it came
} orr_msg_caps;
#define ORR_MSG_CAPS_LARGEST 52164u

orr_wire_status orr_msg_caps_encode(const orr_msg_caps *m, orr_wire_writer *w);
orr_wire_status orr_msg_caps_decode(const uint8_t *payload, size_t size, orr_msg_caps *m);

// Asks whether the server is alive; also keeps an idle connection open.
typedef struct orr_msg_ping {
    uint64_t token; // anything
} orr_msg_ping;
#define ORR_MSG_PING_SIZE 8u
#define ORR_MSG_PING_LARGEST 8u

orr_wire_status orr_msg_ping_encode(const orr_msg_ping *m, orr_wire_writer *w);
orr_wire_status orr_msg_ping_decode(const uint8_t *payload, size_t size, orr_msg_ping *m);

// The answer to a PING.
typedef struct orr_msg_pong {
    uint64_t token; // that of the PING
} orr_msg_pong;
#define ORR_MSG_PONG_SIZE 8u
#define ORR_MSG_PONG_LARGEST 8u

orr_wire_status orr_msg_pong_encode(const orr_msg_pong *m, orr_wire_writer *w);
orr_wire_status orr_msg_pong_decode(const uint8_t *payload, size_t size, orr_msg_pong *m);

// A refusal. Answers the request whose sequence number it bears; 0 where no request could be read.
typedef struct orr_msg_error {
    uint16_t code; // class of failure, for programs
    uint16_t request; // message type of the refused request, 0 if none
    orr_wire_bytes sentence; // what was wrong, for people
} orr_msg_error;
#define ORR_MSG_ERROR_LARGEST 518u

orr_wire_status orr_msg_error_encode(const orr_msg_error *m, orr_wire_writer *w);
orr_wire_status orr_msg_error_decode(const uint8_t *payload, size_t size, orr_msg_error *m);

// Asks for satellite states. The same POLL gets the same bytes, always.
typedef struct orr_msg_poll {
    orr_msg_epochs epochs; // when
    orr_msg_sat_id_list satellites; // which, in the order of the answer; empty for all
} orr_msg_poll;
#define ORR_MSG_POLL_LARGEST 1624u

orr_wire_status orr_msg_poll_encode(const orr_msg_poll *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_decode(const uint8_t *payload, size_t size, orr_msg_poll *m);

// Satellite states at one epoch.
typedef struct orr_msg_states {
    orr_msg_epoch epoch; // OK, or OUTSIDE_SPAN with no satellites
    orr_msg_sat_state_list satellites; // those asked for, in that order; for all, those of CAPS
} orr_msg_states;
#define ORR_MSG_STATES_LARGEST 96021u

orr_wire_status orr_msg_states_encode(const orr_msg_states *m, orr_wire_writer *w);
orr_wire_status orr_msg_states_decode(const uint8_t *payload, size_t size, orr_msg_states *m);

// Asks for Kepler elements. The same POLL_ELEMENTS gets the same bytes, always.
typedef struct orr_msg_poll_elements {
    orr_msg_epochs epochs; // when
    uint8_t frame; // axes that the elements refer to
    uint8_t method; // how they are made
    orr_msg_sat_id_list satellites; // which, in the order of the answer; empty for all
} orr_msg_poll_elements;
#define ORR_MSG_POLL_ELEMENTS_LARGEST 1626u

orr_wire_status orr_msg_poll_elements_encode(const orr_msg_poll_elements *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_elements_decode(const uint8_t *payload, size_t size, orr_msg_poll_elements *m);

// Kepler elements at one epoch.
typedef struct orr_msg_elements {
    orr_msg_epoch epoch; // OK, or OUTSIDE_SPAN with no satellites
    uint8_t frame; // as asked
    uint8_t method; // as asked
    orr_msg_sat_elements_list satellites; // those asked for, in that order; for all, those of CAPS
} orr_msg_elements;
#define ORR_MSG_ELEMENTS_LARGEST 51223u

orr_wire_status orr_msg_elements_encode(const orr_msg_elements *m, orr_wire_writer *w);
orr_wire_status orr_msg_elements_decode(const uint8_t *payload, size_t size, orr_msg_elements *m);

// Asks for the broadcast data. Frames of LNAV, FDMA, D1 and D2 last 30 s; who asks again at frame_to has all that is sent. The same POLL_NAVDATA gets the same bytes, always.
typedef struct orr_msg_poll_navdata {
    orr_msg_epochs epochs; // when
    orr_msg_sat_id_list satellites; // which, in the order of the answer; empty for all
    uint32_t kinds; // which messages; 0: of each satellite its first, LNAV, FDMA, INAV on E1, D1 or D2
    uint8_t form; // pages as bits or as symbols
} orr_msg_poll_navdata;
#define ORR_MSG_POLL_NAVDATA_LARGEST 1629u

orr_wire_status orr_msg_poll_navdata_encode(const orr_msg_poll_navdata *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_navdata_decode(const uint8_t *payload, size_t size, orr_msg_poll_navdata *m);

// Broadcast data at one epoch.
typedef struct orr_msg_navdata {
    orr_msg_epoch epoch; // OK, or OUTSIDE_SPAN with no satellites
    orr_msg_sat_navdata_list satellites; // those asked for, in that order, each with its messages; for all, those of CAPS
} orr_msg_navdata;
#define ORR_MSG_NAVDATA_LARGEST 3304819u

orr_wire_status orr_msg_navdata_encode(const orr_msg_navdata *m, orr_wire_writer *w);
orr_wire_status orr_msg_navdata_decode(const uint8_t *payload, size_t size, orr_msg_navdata *m);

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_f64_next or orr_msg_f64_at.
typedef struct orr_msg_f64_list {
    uint16_t count;
    const double *item;
    orr_wire_records wire;
} orr_msg_f64_list;
bool orr_msg_f64_next(const orr_msg_f64_list *list, orr_wire_iter *it, double *out); // false at the end
bool orr_msg_f64_at(const orr_msg_f64_list *list, uint16_t index, double *out);   // false beyond the end

// Asks for ionospheric delays. The same POLL_DELAYS gets the same bytes, always.
typedef struct orr_msg_poll_delays {
    orr_msg_epochs epochs; // when
    double receiver_m[3]; // receiver (ecef); three times NAN for the scenario's own, which may move from epoch to epoch
    orr_msg_f64_list carriers_hz; // [Hz] carriers to give delays for; empty for 1575.42 MHz
    orr_msg_sat_id_list satellites; // which, in the order of the answer; empty for all
} orr_msg_poll_delays;
#define ORR_MSG_POLL_DELAYS_LARGEST 1684u

orr_wire_status orr_msg_poll_delays_encode(const orr_msg_poll_delays *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_delays_decode(const uint8_t *payload, size_t size, orr_msg_poll_delays *m);

// Ionospheric delays at one epoch.
typedef struct orr_msg_delays {
    orr_msg_epoch epoch; // OK, or OUTSIDE_SPAN of orbits, ionosphere or trajectory, with no satellites
    double receiver_m[3]; // the receiver that was taken (ecef); NAN outside the span of the scenario's trajectory
    orr_msg_f64_list carriers_hz; // [Hz] the carriers of delay_m
    orr_msg_sat_delay_list satellites; // those asked for, in that order; for all, those of CAPS
} orr_msg_delays;
#define ORR_MSG_DELAYS_LARGEST 78481u

orr_wire_status orr_msg_delays_encode(const orr_msg_delays *m, orr_wire_writer *w);
orr_wire_status orr_msg_delays_decode(const uint8_t *payload, size_t size, orr_msg_delays *m);

// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read
// either kind with orr_msg_u16_next or orr_msg_u16_at.
typedef struct orr_msg_u16_list {
    uint16_t count;
    const uint16_t *item;
    orr_wire_records wire;
} orr_msg_u16_list;
bool orr_msg_u16_next(const orr_msg_u16_list *list, orr_wire_iter *it, uint16_t *out); // false at the end
bool orr_msg_u16_at(const orr_msg_u16_list *list, uint16_t index, uint16_t *out);   // false beyond the end

// Asks for the blocks of an antenna's channels that hold the epochs. The same POLL_CHANNELS gets the same bytes, always.
typedef struct orr_msg_poll_channels {
    orr_msg_epochs epochs; // when
    uint16_t antenna; // which antenna of CAPS
    uint16_t terms; // 1: with what each code is the sum of; 0: without
    orr_msg_u16_list signals; // which signals of CAPS; empty for all
} orr_msg_poll_channels;
#define ORR_MSG_POLL_CHANNELS_LARGEST 156u

orr_wire_status orr_msg_poll_channels_encode(const orr_msg_poll_channels *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_channels_decode(const uint8_t *payload, size_t size, orr_msg_poll_channels *m);

// The block of an antenna's channels that holds one epoch. Neighbouring blocks join in value and rate.
typedef struct orr_msg_channels {
    orr_msg_epoch epoch; // OK, or OUTSIDE_SPAN with no channels
    uint16_t antenna; // the antenna asked for
    int64_t block; // [ns] begin of the block, a multiple of its length; -2^63 unless OK
    int64_t length; // [ns] its length, at least 1 ms and at most 1 s
    double error_m; // greatest error of cubics against the antenna's motion that was found in these 10 s; above channel.error_m where even 1 ms does not hold it
    double pos_m[3]; // antenna reference point at the block's begin (ecef)
    double vel_mps[3]; // [m/s] its velocity (ecef)
    uint8_t motion; // where this motion comes from
    int64_t motion_age; // [ns] live: the block's begin less the tag of the sample that it rests on; 0 otherwise
    orr_msg_sat_channel_list channels; // those that the antenna sees at the block's begin, by satellite, signal and echo; behind them the false ones
    orr_msg_channel_terms_list terms; // of each channel, in the same order; empty unless asked for
    orr_msg_jammer_list jammers; // those that send then
} orr_msg_channels;
#define ORR_MSG_CHANNELS_LARGEST 1664526u

orr_wire_status orr_msg_channels_encode(const orr_msg_channels *m, orr_wire_writer *w);
orr_wire_status orr_msg_channels_decode(const uint8_t *payload, size_t size, orr_msg_channels *m);

// Asks for inertial increments over intervals, ideal ones or, where the scenario has imu.errors, what sensors with errors measure. The same POLL_IMU gets the same bytes, always.
typedef struct orr_msg_poll_imu {
    orr_msg_epochs epochs; // begins of the intervals, which are step long (0 to 1 h; 0: that of CAPS imu_rate_hz)
    uint16_t unit; // which inertial unit of the scenario; 0 is the trajectory's own point
} orr_msg_poll_imu;
#define ORR_MSG_POLL_IMU_SIZE 22u
#define ORR_MSG_POLL_IMU_LARGEST 22u

orr_wire_status orr_msg_poll_imu_encode(const orr_msg_poll_imu *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_imu_decode(const uint8_t *payload, size_t size, orr_msg_poll_imu *m);

// Integrals of absolute angular rate and specific force over one interval, in the unit's axes (right, forward, up).
typedef struct orr_msg_imu {
    orr_msg_epoch epoch; // begin of the interval; OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN
    int64_t t1; // [ns] end of the interval
    uint16_t unit; // the unit asked for
    uint8_t readings; // of perfect sensors, or of those with the scenario's errors
    double dtheta_rad[3]; // integral of the absolute angular rate
    double dv_mps[3]; // [m/s] integral of the specific force; at rest +g upward
} orr_msg_imu;
#define ORR_MSG_IMU_SIZE 76u
#define ORR_MSG_IMU_LARGEST 76u

orr_wire_status orr_msg_imu_encode(const orr_msg_imu *m, orr_wire_writer *w);
orr_wire_status orr_msg_imu_decode(const uint8_t *payload, size_t size, orr_msg_imu *m);

// Asks for the true motion of an inertial unit. The same POLL_TRUTH gets the same bytes, always.
typedef struct orr_msg_poll_truth {
    orr_msg_epochs epochs; // when
    uint16_t unit; // which inertial unit of the scenario; 0 is the trajectory's own point
} orr_msg_poll_truth;
#define ORR_MSG_POLL_TRUTH_SIZE 22u
#define ORR_MSG_POLL_TRUTH_LARGEST 22u

orr_wire_status orr_msg_poll_truth_encode(const orr_msg_poll_truth *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_truth_decode(const uint8_t *payload, size_t size, orr_msg_poll_truth *m);

// True motion and gravity at one epoch.
typedef struct orr_msg_truth {
    orr_msg_epoch epoch; // OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN
    uint16_t unit; // the unit asked for
    double pos_m[3]; // position (ecef)
    double vel_mps[3]; // [m/s] velocity relative to the Earth (ecef)
    double acc_mps2[3]; // [m/s2] second derivative of the position (ecef)
    double attitude[4]; // quaternion w x y z of body from ecef: v_body = conj(q) v_ecef q
    double heading_rad; // clockwise from true North, 0 to 2 pi
    double pitch_rad; // nose up
    double roll_rad; // right wing down
    double rate_radps[3]; // [rad/s] absolute angular rate, body axes
    double force_mps2[3]; // [m/s2] specific force, body axes
    double disturbance_mgal; // [mGal] gravity disturbance, stronger gravity positive
    double eotvos_mgal; // [mGal] Eotvoes term: what the motion takes off the weight
    double vertical_mps2; // [m/s2] rate of the vertical velocity over the ellipsoid
} orr_msg_truth;
#define ORR_MSG_TRUTH_SIZE 219u
#define ORR_MSG_TRUTH_LARGEST 219u

orr_wire_status orr_msg_truth_encode(const orr_msg_truth *m, orr_wire_writer *w);
orr_wire_status orr_msg_truth_decode(const uint8_t *payload, size_t size, orr_msg_truth *m);

// Asks for a stream. Its blocks are frames of the kind that answers the named request, and each is, byte for byte, the answer to that request for its instant alone. All frames of the stream bear the sequence number of the SUBSCRIBE, which is the stream's number.
typedef struct orr_msg_subscribe {
    uint16_t request; // POLL, POLL_NAVDATA, POLL_CHANNELS, POLL_IMU, POLL_TRUTH, POLL_EVENTS or GET_MODES
    uint8_t pacing; // when blocks are made
    uint8_t delivery; // how they come
    uint32_t credit; // how many blocks may be sent before there is more credit (CREDIT)
    int64_t lead; // [ns] with CLOCK and MOTION: how long before its instant a block is made, 0 to 60 s
    orr_wire_bytes poll; // payload of that request. t: the first instant, -2^63 for the next one; step: from block to block, 1 ms to 60 s (POLL_IMU: 1 s), of POLL_CHANNELS also 0: every block once, of POLL_NAVDATA 0: every frame once; count: how many, 0 for no end. GET_MODES has none of these: its blocks come when modes change
    uint16_t port; // with DATAGRAMS: the UDP port, of the address that the connection comes from
} orr_msg_subscribe;
#define ORR_MSG_SUBSCRIBE_LARGEST 16404u

orr_wire_status orr_msg_subscribe_encode(const orr_msg_subscribe *m, orr_wire_writer *w);
orr_wire_status orr_msg_subscribe_decode(const uint8_t *payload, size_t size, orr_msg_subscribe *m);

// The stream is there; its blocks follow.
typedef struct orr_msg_subscribed {
    int64_t first; // [ns] instant of its first block
    int64_t step; // [ns] from block to block; 0: as long as they or their frames are
    uint32_t channel; // with DATAGRAMS: the channel that its datagrams name; 0 otherwise
} orr_msg_subscribed;
#define ORR_MSG_SUBSCRIBED_SIZE 20u
#define ORR_MSG_SUBSCRIBED_LARGEST 20u

orr_wire_status orr_msg_subscribed_encode(const orr_msg_subscribed *m, orr_wire_writer *w);
orr_wire_status orr_msg_subscribed_decode(const uint8_t *payload, size_t size, orr_msg_subscribed *m);

// Ends a stream; its last frame is a STREAM_END. Of a stream that has ended already it is passed over.
typedef struct orr_msg_unsubscribe {
    uint32_t stream; // sequence number of its SUBSCRIBE
} orr_msg_unsubscribe;
#define ORR_MSG_UNSUBSCRIBE_SIZE 4u
#define ORR_MSG_UNSUBSCRIBE_LARGEST 4u

orr_wire_status orr_msg_unsubscribe_encode(const orr_msg_unsubscribe *m, orr_wire_writer *w);
orr_wire_status orr_msg_unsubscribe_decode(const uint8_t *payload, size_t size, orr_msg_unsubscribe *m);

// Lets a stream send so many blocks more. Of a stream that has ended already it is passed over.
typedef struct orr_msg_credit {
    uint32_t stream; // sequence number of its SUBSCRIBE
    uint32_t blocks; // how many more
} orr_msg_credit;
#define ORR_MSG_CREDIT_SIZE 8u
#define ORR_MSG_CREDIT_LARGEST 8u

orr_wire_status orr_msg_credit_encode(const orr_msg_credit *m, orr_wire_writer *w);
orr_wire_status orr_msg_credit_decode(const uint8_t *payload, size_t size, orr_msg_credit *m);

// Blocks of a stream that will not come. The next block is the first after them.
typedef struct orr_msg_gap {
    int64_t first; // [ns] instant of the first that was left out
    int64_t last; // [ns] instant of the last
    uint32_t blocks; // how many; of channels by their blocks 0, for their lengths were not looked at
    uint8_t reason; // why
} orr_msg_gap;
#define ORR_MSG_GAP_SIZE 21u
#define ORR_MSG_GAP_LARGEST 21u

orr_wire_status orr_msg_gap_encode(const orr_msg_gap *m, orr_wire_writer *w);
orr_wire_status orr_msg_gap_decode(const uint8_t *payload, size_t size, orr_msg_gap *m);

// The last frame of a stream.
typedef struct orr_msg_stream_end {
    int64_t next; // [ns] instant of the block that would have come next: where another SUBSCRIBE goes on
    uint8_t reason; // why
    orr_wire_bytes sentence; // the same, for people
} orr_msg_stream_end;
#define ORR_MSG_STREAM_END_LARGEST 211u

orr_wire_status orr_msg_stream_end_encode(const orr_msg_stream_end *m, orr_wire_writer *w);
orr_wire_status orr_msg_stream_end_decode(const uint8_t *payload, size_t size, orr_msg_stream_end *m);

// Controls the scenario's clock; answered by what it is then.
typedef struct orr_msg_control {
    uint8_t action; // what to do
    uint8_t reference; // with ARM, and with START of one that was not armed: what paces it
    uint16_t reserved; // 0
    int64_t t; // [ns] instant of the scenario; -2^63: where it stands
    int64_t at; // [ns] with START: the wall's instant (GPS scale) at which it goes; -2^63: at once
    int64_t delay; // [ns] with START: so much later, 0 to an hour
    orr_wire_bytes scenario; // with LOAD: name of another scenario of the server's folder (serve --scenarios), without its ending; empty: this one
} orr_msg_control;
#define ORR_MSG_CONTROL_LARGEST 94u

orr_wire_status orr_msg_control_encode(const orr_msg_control *m, orr_wire_writer *w);
orr_wire_status orr_msg_control_decode(const uint8_t *payload, size_t size, orr_msg_control *m);

// Asks what the scenario's clock shows.
typedef struct orr_msg_get_time {
    uint32_t reserved; // 0
} orr_msg_get_time;
#define ORR_MSG_GET_TIME_SIZE 4u
#define ORR_MSG_GET_TIME_LARGEST 4u

orr_wire_status orr_msg_get_time_encode(const orr_msg_get_time *m, orr_wire_writer *w);
orr_wire_status orr_msg_get_time_decode(const uint8_t *payload, size_t size, orr_msg_get_time *m);

// The scenario's clock at the moment of the answer.
typedef struct orr_msg_time {
    int64_t t; // [ns] the scenario's instant; before a start that is fixed it counts down
    uint8_t state; // whether it runs
    uint8_t reference; // what paces it
    int32_t week; // GPS week, unwrapped
    int64_t tow; // [ns] time of that week
    orr_msg_leap_seconds leap; // leap seconds in force, and the next change
    int32_t utc_mjd; // modified Julian day of UTC
    uint16_t n4; // GLONASS: four-year interval of the day in Moscow; 0 where it has no number
    uint16_t nt; // and the day in it
    int64_t utc_su; // [ns] time of the day in Moscow, UTC(SU) + 3 h
    int64_t pps0; // [ns] the scenario's instant at PPS0; -2^63: none was fixed
    int64_t host; // [ns] the server's CLOCK_MONOTONIC at this moment
    int64_t wall; // [ns] the wall's instant at this moment
    double error_ns; // last RADIO_TIME against what the loop expected
    double rate; // generator seconds a second of the host, less 1
    double wander_ns; // root mean square of those errors, of late
    uint64_t samples; // RADIO_TIMEs since the loop took up its lock
    uint32_t steps; // how often the generator's time stepped, so that the lock was taken up anew
    uint32_t suspends; // how often the host was suspended
    uint32_t sets; // how often the host's wall clock was set
} orr_msg_time;
#define ORR_MSG_TIME_SIZE 118u
#define ORR_MSG_TIME_LARGEST 118u

orr_wire_status orr_msg_time_encode(const orr_msg_time *m, orr_wire_writer *w);
orr_wire_status orr_msg_time_decode(const uint8_t *payload, size_t size, orr_msg_time *m);

// A generator tells its elapsed time, 1 to 1000 times a second; the scenario's clock follows it.
typedef struct orr_msg_radio_time {
    int64_t elapsed; // [ns] its time since its own begin, whose whole seconds are its 1PPS
    int64_t stamp; // [ns] what a clock of the server's host showed then
    uint8_t clock; // which clock
} orr_msg_radio_time;
#define ORR_MSG_RADIO_TIME_SIZE 17u
#define ORR_MSG_RADIO_TIME_LARGEST 17u

orr_wire_status orr_msg_radio_time_encode(const orr_msg_radio_time *m, orr_wire_writer *w);
orr_wire_status orr_msg_radio_time_decode(const uint8_t *payload, size_t size, orr_msg_radio_time *m);

// Where the scenario and its blocks are.
typedef struct orr_msg_pace {
    int64_t t; // [ns] the scenario's instant now
    double error_ns; // this RADIO_TIME against what the loop expected
    double rate; // generator seconds a second of the host, less 1
    double wander_ns; // root mean square of the errors, of late
    int64_t made; // [ns] instant of the block that was made last for this connection; -2^63: none
    int64_t until_air; // [ns] how long from now until it is on air; -2^63: the clock does not run, or there is none
} orr_msg_pace;
#define ORR_MSG_PACE_SIZE 48u
#define ORR_MSG_PACE_LARGEST 48u

orr_wire_status orr_msg_pace_encode(const orr_msg_pace *m, orr_wire_writer *w);
orr_wire_status orr_msg_pace_decode(const uint8_t *payload, size_t size, orr_msg_pace *m);

// A sample of the live motion of the body that antennas ride on. Wants a clock that is armed or runs, and a server that takes motion (serve --motion); answered by an ERROR where it cannot be used.
typedef struct orr_msg_motion {
    int64_t t; // [ns] tag: instant of the scenario at which it holds; later than that of the sample before
    uint8_t order; // highest derivative of the position that is given: 0 position, 1 velocity, 2 acceleration, 3 jerk
    uint8_t angular_order; // likewise: 0 no attitude (the body stands level, its front to North), 1 attitude, 2 rate, 3 acceleration, 4 jerk
    uint8_t point; // of which point
    uint8_t snap; // 1: jump there at the next block instead of joining
    double pos_m[3]; // position (ecef)
    double vel_mps[3]; // [m/s] velocity relative to the Earth (ecef)
    double acc_mps2[3]; // [m/s2] second derivative of the position (ecef)
    double jerk_mps3[3]; // [m/s3] third
    double attitude[4]; // quaternion w x y z of body from ecef: v_body = conj(q) v_ecef q; body is right, forward, up
    double rate_radps[3]; // [rad/s] rate of the body relative to ecef, body axes
    double rate2_radps2[3]; // [rad/s2] its derivative
    double rate3_radps3[3]; // [rad/s3] and that one's
} orr_msg_motion;
#define ORR_MSG_MOTION_SIZE 212u
#define ORR_MSG_MOTION_LARGEST 212u

orr_wire_status orr_msg_motion_encode(const orr_msg_motion *m, orr_wire_writer *w);
orr_wire_status orr_msg_motion_decode(const uint8_t *payload, size_t size, orr_msg_motion *m);

// Asks what became of the samples of motion, and lays down the worst state.
typedef struct orr_msg_get_motion_stats {
    uint8_t reset; // 1: counts begin anew afterwards
} orr_msg_get_motion_stats;
#define ORR_MSG_GET_MOTION_STATS_SIZE 1u
#define ORR_MSG_GET_MOTION_STATS_LARGEST 1u

orr_wire_status orr_msg_get_motion_stats_encode(const orr_msg_get_motion_stats *m, orr_wire_writer *w);
orr_wire_status orr_msg_get_motion_stats_decode(const uint8_t *payload, size_t size, orr_msg_get_motion_stats *m);

// What became of the samples of motion since the counts began.
typedef struct orr_msg_motion_stats {
    uint64_t received; // samples that came
    uint64_t used; // of them on which a block rests
    uint64_t late; // that came after a block for their instant was made
    uint64_t early; // that came before any block needed them
    uint64_t dropped; // that could not be used: tags that go back or lie far ahead, numbers that are none, jumps that were not asked for
    uint64_t overtaken; // on which no block came to rest before the next
    uint64_t blocks; // blocks made along live motion
    uint64_t extrapolated; // of them beyond the last sample
    uint64_t joined; // on the way back
    uint64_t snapped; // with a jump
    orr_msg_motion_spread lateness; // scenario's instant at arrival less the tag
    orr_msg_motion_spread margin; // tag less the end of what had been made at arrival
    uint16_t buffered; // samples that wait for their instant
    uint8_t worst; // worst state of a block since this was asked last
} orr_msg_motion_stats;
#define ORR_MSG_MOTION_STATS_SIZE 163u
#define ORR_MSG_MOTION_STATS_LARGEST 163u

orr_wire_status orr_msg_motion_stats_encode(const orr_msg_motion_stats *m, orr_wire_writer *w);
orr_wire_status orr_msg_motion_stats_decode(const uint8_t *payload, size_t size, orr_msg_motion_stats *m);

// Asks what happens in intervals. The same POLL_EVENTS gets the same bytes, always.
typedef struct orr_msg_poll_events {
    orr_msg_epochs epochs; // begins of the intervals, which are step long (0 to 1 h; 0: an hour)
} orr_msg_poll_events;
#define ORR_MSG_POLL_EVENTS_SIZE 20u
#define ORR_MSG_POLL_EVENTS_LARGEST 20u

orr_wire_status orr_msg_poll_events_encode(const orr_msg_poll_events *m, orr_wire_writer *w);
orr_wire_status orr_msg_poll_events_decode(const uint8_t *payload, size_t size, orr_msg_poll_events *m);

// What happens in one interval, its end not in it.
typedef struct orr_msg_events {
    orr_msg_epoch epoch; // begin of the interval; OK, or OUTSIDE_SPAN with no events
    int64_t t1; // [ns] end of the interval
    orr_msg_event_list events; // ascending in time; of one instant by kind, satellite and antenna
} orr_msg_events;
#define ORR_MSG_EVENTS_LARGEST 180253u

orr_wire_status orr_msg_events_encode(const orr_msg_events *m, orr_wire_writer *w);
orr_wire_status orr_msg_events_decode(const uint8_t *payload, size_t size, orr_msg_events *m);

// Asks for the connection's channel of datagrams, by which it may send MOTION, and for the keys of its datagrams in both directions. Asked again it tells the same channel and what has become of it.
typedef struct orr_msg_open_datagrams {
    uint32_t reserved; // 0
} orr_msg_open_datagrams;
#define ORR_MSG_OPEN_DATAGRAMS_SIZE 4u
#define ORR_MSG_OPEN_DATAGRAMS_LARGEST 4u

orr_wire_status orr_msg_open_datagrams_encode(const orr_msg_open_datagrams *m, orr_wire_writer *w);
orr_wire_status orr_msg_open_datagrams_decode(const uint8_t *payload, size_t size, orr_msg_open_datagrams *m);

// The channel of a connection, which ends with it.
typedef struct orr_msg_datagrams {
    uint32_t channel; // its number, which datagrams to the server name
    uint16_t port; // UDP port where the server takes motion; 0: none (serve --motion-udp)
    uint8_t seal; // what stands behind each frame, in both directions
    uint8_t reserved; // 0
    uint64_t taken; // datagrams of the channel that were new and whole
    uint64_t replayed; // that had come before, or lie more than 1024 numbers back
    uint64_t refused; // that named it and had another seal, came from elsewhere, or held no MOTION
    orr_wire_bytes keys; // with HMAC_SHA256: the key of what the client sends, then that of what the server sends, 32 bytes each; what the exporter of the TLS session gives (RFC 8446, 7.5) for the label EXPORTER-orrery-datagrams and an empty context
} orr_msg_datagrams;
#define ORR_MSG_DATAGRAMS_LARGEST 98u

orr_wire_status orr_msg_datagrams_encode(const orr_msg_datagrams *m, orr_wire_writer *w);
orr_wire_status orr_msg_datagrams_decode(const uint8_t *payload, size_t size, orr_msg_datagrams *m);

// Asks for a ring of shared memory into which a client on the server's host writes MOTION, over a Unix socket (docs/protocol.md, The ring). Asked again it tells what has become of it.
typedef struct orr_msg_open_motion_ring {
    uint32_t reserved; // 0
} orr_msg_open_motion_ring;
#define ORR_MSG_OPEN_MOTION_RING_SIZE 4u
#define ORR_MSG_OPEN_MOTION_RING_LARGEST 4u

orr_wire_status orr_msg_open_motion_ring_encode(const orr_msg_open_motion_ring *m, orr_wire_writer *w);
orr_wire_status orr_msg_open_motion_ring_decode(const uint8_t *payload, size_t size, orr_msg_open_motion_ring *m);

// The ring. With the first answer come two descriptors, of the memory and of an eventfd that wakes the server; the ring ends with the connection.
typedef struct orr_msg_motion_ring {
    uint32_t slots; // messages that the ring holds
    uint32_t stride; // bytes of a slot
    uint64_t taken; // messages that the server has read
    uint64_t lost; // that had been written over before it came to them
} orr_msg_motion_ring;
#define ORR_MSG_MOTION_RING_SIZE 24u
#define ORR_MSG_MOTION_RING_LARGEST 24u

orr_wire_status orr_msg_motion_ring_encode(const orr_msg_motion_ring *m, orr_wire_writer *w);
orr_wire_status orr_msg_motion_ring_decode(const uint8_t *payload, size_t size, orr_msg_motion_ring *m);

// Asks which modes the service has changed over to. May be subscribed to as well.
typedef struct orr_msg_get_modes {
    uint64_t after; // number of the last change that is known; 0: all that are kept; 2^64 - 1: those from now on
} orr_msg_get_modes;
#define ORR_MSG_GET_MODES_SIZE 8u
#define ORR_MSG_GET_MODES_LARGEST 8u

orr_wire_status orr_msg_get_modes_encode(const orr_msg_get_modes *m, orr_wire_writer *w);
orr_wire_status orr_msg_get_modes_decode(const uint8_t *payload, size_t size, orr_msg_get_modes *m);

// Mode changes of the service, the oldest first.
typedef struct orr_msg_modes {
    int64_t t; // [ns] what the scenario's clock shows
    uint64_t last; // number of the last change listed, to ask on from; without any that of the last there was
    uint64_t lost; // changes after `after` that are not kept any more (1024 are)
    uint8_t more; // 1: there are more behind the last one listed
    orr_msg_mode_change_list changes; // what changed
} orr_msg_modes;
#define ORR_MSG_MODES_LARGEST 2829u

orr_wire_status orr_msg_modes_encode(const orr_msg_modes *m, orr_wire_writer *w);
orr_wire_status orr_msg_modes_decode(const uint8_t *payload, size_t size, orr_msg_modes *m);

// All messages, for code that does the same with each.
#define ORR_MSG_EACH(X) X(hello) X(caps) X(ping) X(pong) X(error) X(poll) X(states) X(poll_elements) X(elements) X(poll_navdata) X(navdata) X(poll_delays) X(delays) X(poll_channels) X(channels) X(poll_imu) X(imu) X(poll_truth) X(truth) X(subscribe) X(subscribed) X(unsubscribe) X(credit) X(gap) X(stream_end) X(control) X(get_time) X(time) X(radio_time) X(pace) X(motion) X(get_motion_stats) X(motion_stats) X(poll_events) X(events) X(open_datagrams) X(datagrams) X(open_motion_ring) X(motion_ring) X(get_modes) X(modes)

// Room for any of them.
typedef union orr_msg_any {
    orr_msg_hello hello;
    orr_msg_caps caps;
    orr_msg_ping ping;
    orr_msg_pong pong;
    orr_msg_error error;
    orr_msg_poll poll;
    orr_msg_states states;
    orr_msg_poll_elements poll_elements;
    orr_msg_elements elements;
    orr_msg_poll_navdata poll_navdata;
    orr_msg_navdata navdata;
    orr_msg_poll_delays poll_delays;
    orr_msg_delays delays;
    orr_msg_poll_channels poll_channels;
    orr_msg_channels channels;
    orr_msg_poll_imu poll_imu;
    orr_msg_imu imu;
    orr_msg_poll_truth poll_truth;
    orr_msg_truth truth;
    orr_msg_subscribe subscribe;
    orr_msg_subscribed subscribed;
    orr_msg_unsubscribe unsubscribe;
    orr_msg_credit credit;
    orr_msg_gap gap;
    orr_msg_stream_end stream_end;
    orr_msg_control control;
    orr_msg_get_time get_time;
    orr_msg_time time;
    orr_msg_radio_time radio_time;
    orr_msg_pace pace;
    orr_msg_motion motion;
    orr_msg_get_motion_stats get_motion_stats;
    orr_msg_motion_stats motion_stats;
    orr_msg_poll_events poll_events;
    orr_msg_events events;
    orr_msg_open_datagrams open_datagrams;
    orr_msg_datagrams datagrams;
    orr_msg_open_motion_ring open_motion_ring;
    orr_msg_motion_ring motion_ring;
    orr_msg_get_modes get_modes;
    orr_msg_modes modes;
} orr_msg_any;

#ifdef __cplusplus
}
#endif

#endif

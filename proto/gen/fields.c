// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
#include "proto/fields.h"

static const orr_field_word words_error_code[] = {
    {1, "BAD_MAGIC", "bad magic", false},
    {2, "BAD_LENGTH", "bad length", false},
    {3, "BAD_CRC", "bad crc", false},
    {4, "BAD_VERSION", "bad version", false},
    {5, "UNKNOWN_TYPE", "unknown type", false},
    {6, "BAD_PAYLOAD", "bad payload", false},
    {7, "BAD_REQUEST", "bad request", false},
    {8, "LIMIT", "limit", false},
    {9, "NOT_SERVED", "not served", false},
    {10, "BUSY", "busy", false},
    {11, "TIMEOUT", "timeout", false},
    {12, "CLOSING", "closing", false},
    {13, "INTERNAL", "internal", false},
    {14, "NOT_PERMITTED", "not permitted", false},
};

static const orr_field_word words_answer[] = {
    {0, "OK", "ok", false},
    {1, "OUTSIDE_SPAN", "outside the served span", false},
    {2, "NO_ARC", "no valid arc", false},
    {3, "NOT_SERVED", "not served", false},
    {4, "BELOW_HORIZON", "below the horizon", true},
    {5, "NO_VALUE", "no value there", false},
};

static const orr_field_word words_nav_message[] = {
    {0, "NONE", "none", false},
    {1, "LNAV", "lnav", false},
    {2, "CNAV", "cnav", false},
    {3, "CNV1", "cnv1", false},
    {4, "CNV2", "cnv2", false},
    {5, "CNV3", "cnv3", false},
    {6, "INAV", "inav", false},
    {7, "FNAV", "fnav", false},
    {8, "D1", "d1", false},
    {9, "D2", "d2", false},
    {10, "FDMA", "fdma", false},
    {11, "SBAS", "sbas", false},
};

static const orr_field_word words_nav_form[] = {
    {0, "BITS", "bits", false},
    {1, "SYMBOLS", "symbols", false},
};

static const orr_field_word words_elements_frame[] = {
    {0, "DATE", "date", false},
    {1, "J2000", "j2000", false},
    {2, "ECEF", "ecef", false},
};

static const orr_field_word words_elements_method[] = {
    {0, "STATE", "state", false},
    {1, "THREE_POSITIONS", "three positions", false},
    {2, "MEAN", "mean", false},
};

static const orr_field_word words_orbit_point[] = {
    {0, "NONE", "none", false},
    {1, "CENTRE_OF_MASS", "centre of mass", false},
    {2, "PHASE_CENTRE", "phase centre", false},
};

static const orr_field_word words_receiver_source[] = {
    {0, "NONE", "none", false},
    {1, "POSITION", "position", false},
    {2, "TRAJECTORY", "trajectory", false},
    {3, "STATION", "station", false},
};

static const orr_field_word words_tec_origin[] = {
    {0, "FIELD", "field", false},
    {1, "FUSED", "fused", false},
    {2, "TRANSFERRED", "transferred", false},
    {3, "NOISE", "noise", false},
};

static const orr_field_word words_pacing[] = {
    {0, "FREE", "as fast as they are taken", false},
    {1, "CLOCK", "by the scenario clock", false},
    {2, "MOTION", "by motion", false},
};

static const orr_field_word words_delivery[] = {
    {0, "FRAMES", "frames", false},
    {1, "RING", "ring", false},
    {2, "DATAGRAMS", "datagrams", false},
};

static const orr_field_word words_seal[] = {
    {0, "NONE", "none", false},
    {1, "HMAC_SHA256", "HMAC-SHA-256", false},
};

static const orr_field_word words_gap_reason[] = {
    {1, "CREDIT", "no credit", false},
    {2, "LATE", "late", false},
};

static const orr_field_word words_end_reason[] = {
    {1, "FINISHED", "finished", false},
    {2, "UNSUBSCRIBED", "unsubscribed", false},
    {3, "SLOW", "too slow", false},
    {4, "OUTSIDE_SPAN", "end of the span", false},
    {5, "FAILED", "failed", false},
};

static const orr_field_word words_control_action[] = {
    {1, "LOAD", "load", false},
    {2, "ARM", "arm", false},
    {3, "WAIT_PPS", "wait pps", false},
    {4, "START", "start", false},
    {5, "PAUSE", "pause", false},
    {6, "STOP", "stop", false},
};

static const orr_field_word words_clock_reference[] = {
    {0, "WALL", "the wall's clock", false},
    {1, "RADIO", "the generator", false},
};

static const orr_field_word words_clock_state[] = {
    {0, "STOPPED", "stopped", false},
    {1, "ARMED", "armed", false},
    {2, "WAITING", "waiting", false},
    {3, "RUNNING", "running", false},
    {4, "PAUSED", "paused", false},
};

static const orr_field_word words_readings[] = {
    {0, "IDEAL", "ideal", false},
    {1, "MEASURED", "measured", false},
};

static const orr_field_word words_stamp_clock[] = {
    {0, "ARRIVAL", "arrival", false},
    {1, "MONOTONIC", "monotonic", false},
    {2, "TAI", "tai", false},
    {3, "REALTIME", "realtime", false},
};

static const orr_field_word words_motion_state[] = {
    {0, "SCENARIO", "scenario", false},
    {1, "SYNCHRONOUS", "synchronous", false},
    {2, "INTERPOLATED", "interpolated", false},
    {3, "EXTRAPOLATED", "extrapolated", false},
    {4, "JOINING", "joining", false},
    {5, "SNAPPED", "snapped", false},
};

static const orr_field_word words_motion_point[] = {
    {0, "BODY", "body", false},
    {1, "ANTENNA", "antenna", false},
};

static const orr_field_word words_event_kind[] = {
    {1, "RISE", "rises", false},
    {2, "SET", "sets", false},
    {3, "ARC_BEGIN", "arc begins", false},
    {4, "ARC_END", "arc ends", false},
    {5, "EPHEMERIS", "new ephemeris", false},
    {6, "HEALTH", "health changes", false},
    {7, "LEAP_SECOND", "leap second", false},
    {8, "ECLIPSE_BEGIN", "enters the shadow", false},
    {9, "ECLIPSE_END", "leaves the shadow", false},
    {10, "MANOEUVRE_BEGIN", "manoeuvre begins", false},
    {11, "MANOEUVRE_END", "manoeuvre ends", false},
    {12, "MOTION_BEGIN", "motion begins", false},
    {13, "MOTION_END", "motion ends", false},
    {14, "FAULT_BEGIN", "fault begins", false},
    {15, "FAULT_END", "fault ends", false},
};

static const orr_field_word words_mode_kind[] = {
    {0, "CLOCK", "clock", false},
    {1, "REFERENCE", "reference", false},
    {2, "GENERATOR", "generator", false},
    {3, "MOTION", "motion", false},
};

static const orr_field_word words_mode[] = {
    {0, "STOPPED", "stopped", false},
    {1, "ARMED", "armed", false},
    {2, "WAITING", "waiting", false},
    {3, "RUNNING", "running", false},
    {4, "PAUSED", "paused", false},
    {16, "WALL", "the wall's clock", false},
    {17, "RADIO", "the generator", false},
    {32, "SILENT", "silent", false},
    {33, "LOCKED", "locked", false},
    {34, "STEPPING", "stepping", false},
    {48, "SCENARIO", "scenario", false},
    {49, "SYNCHRONOUS", "synchronous", false},
    {50, "INTERPOLATED", "interpolated", false},
    {51, "EXTRAPOLATED", "extrapolated", false},
    {52, "JOINING", "joining", false},
    {53, "SNAPPED", "snapped", false},
};

static const orr_field_word words_access[] = {
    {UINT64_C(1), "NO_READING", "no reading", false},
    {UINT64_C(2), "NO_MOTION", "no motion", false},
    {UINT64_C(4), "NO_CONTROL", "no control", false},
    {UINT64_C(8), "INSECURE", "insecure", false},
};

static const orr_field_word words_channel_flags[] = {
    {UINT64_C(1), "UNHEALTHY", "unhealthy", false},
    {UINT64_C(2), "ECLIPSE", "eclipse", false},
    {UINT64_C(4), "FAST_TURN", "fast turn", false},
    {UINT64_C(8), "NO_ANTENNA", "no antenna", false},
    {UINT64_C(16), "NO_DELAY", "no delay", false},
    {UINT64_C(32), "ZERO_CLOCK", "zero clock", false},
    {UINT64_C(64), "NOMINAL_CHANNEL", "nominal channel", false},
    {UINT64_C(128), "FAULT", "fault", false},
};

static const orr_field_word words_delay_flags[] = {
    {UINT64_C(1), "CLIPPED", "clipped at 0", false},
};

static const orr_field_word words_state_flags[] = {
    {UINT64_C(1), "CLOCK_VALID", "", false},
    {UINT64_C(2), "PREDICTED", "predicted", false},
    {UINT64_C(4), "MANOEUVRE", "manoeuvre", false},
    {UINT64_C(8), "CLOCK_EVENT", "clock event", false},
    {UINT64_C(16), "ECLIPSE", "eclipse", false},
    {UINT64_C(32), "GAP", "gap", false},
    {UINT64_C(64), "JOINT", "joint", false},
    {UINT64_C(128), "SHADOW_NOISE", "shadow noise", false},
};

static const orr_field_word words_nav_messages[] = {
    {UINT64_C(2), "LNAV", "lnav", false},
    {UINT64_C(4), "CNAV", "cnav", false},
    {UINT64_C(8), "CNV1", "cnv1", false},
    {UINT64_C(16), "CNV2", "cnv2", false},
    {UINT64_C(32), "CNV3", "cnv3", false},
    {UINT64_C(64), "INAV", "inav", false},
    {UINT64_C(128), "FNAV", "fnav", false},
    {UINT64_C(256), "D1", "d1", false},
    {UINT64_C(512), "D2", "d2", false},
    {UINT64_C(1024), "FDMA", "fdma", false},
    {UINT64_C(2048), "SBAS", "sbas", false},
};

static const orr_field_word words_nav_notes[] = {
    {UINT64_C(1), "MANOEUVRE", "manoeuvre", false},
    {UINT64_C(2), "SHIFTED", "shifted", false},
    {UINT64_C(4), "NO_CLOCK", "no clock", false},
    {UINT64_C(8), "NO_ANTENNA", "no antenna", false},
    {UINT64_C(16), "NO_DELAY", "no delay", false},
    {UINT64_C(32), "NOMINAL_CHANNEL", "nominal channel", false},
    {UINT64_C(64), "CLOCK_JUMP", "clock jump", false},
    {UINT64_C(128), "FAULTY", "faulty", false},
};

static const orr_field fields_motion_spread[] = {
    {.name = "min", .unit = "ns", .doc = "least", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_spread, min), .in_text = true, .text_name = "min", .text_factor = 1.0, .in_table = true, .head = "min", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "max", .unit = "ns", .doc = "greatest", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_spread, max), .in_text = true, .text_name = "max", .text_factor = 1.0, .in_table = true, .head = "max", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "last", .unit = "ns", .doc = "last", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_spread, last), .in_text = true, .text_name = "last", .text_factor = 1.0, .in_table = true, .head = "last", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "p50", .unit = "ns", .doc = "median, to 9 %", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_spread, p50), .in_text = true, .text_name = "p50", .text_factor = 1.0, .in_table = true, .head = "p50", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "p99", .unit = "ns", .doc = "99th percentile, to 9 %", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_spread, p99), .in_text = true, .text_name = "p99", .text_factor = 1.0, .in_table = true, .head = "p99", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_motion_spread = {"motion_spread", fields_motion_spread, 5, sizeof(orr_msg_motion_spread), false, false};

static const orr_field fields_sat_id[] = {
    {.name = "system", .unit = "", .doc = "letter: G R E C J I S L; any other is NOT_SERVED", .kind = ORR_FIELD_U8, .show = ORR_SHOW_CHAR, .offset = offsetof(orr_msg_sat_id, system), .in_text = true, .text_name = "system", .text_factor = 1.0, .in_table = true, .head = "system", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "number", .unit = "", .doc = "1 to 99; any other is NOT_SERVED", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_id, number), .in_text = true, .text_name = "number", .text_factor = 1.0, .in_table = true, .head = "number", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_sat_id = {"sat_id", fields_sat_id, 2, sizeof(orr_msg_sat_id), false, true};

static const orr_field fields_epochs[] = {
    {.name = "t", .unit = "ns", .doc = "first epoch", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_epochs, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "step", .unit = "ns", .doc = "from one epoch to the next; any sign, not 0 unless count is 1", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_epochs, step), .in_text = true, .text_name = "step", .text_factor = 1.0, .in_table = true, .head = "step", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "count", .unit = "", .doc = "how many, 1 to MAX_EPOCHS", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_epochs, count), .in_text = true, .text_name = "count", .text_factor = 1.0, .in_table = true, .head = "count", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_epochs = {"epochs", fields_epochs, 3, sizeof(orr_msg_epochs), true, false};

static const orr_field fields_epoch[] = {
    {.name = "t", .unit = "ns", .doc = "the instant", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_epoch, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "index", .unit = "", .doc = "which epoch of the request, from 0; the frame of count - 1 ends the answer", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_epoch, index), .in_text = false, .text_name = "index", .text_factor = 1.0, .in_table = false, .head = "index", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "count", .unit = "", .doc = "how many epochs the request asked for", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_epoch, count), .in_text = false, .text_name = "count", .text_factor = 1.0, .in_table = false, .head = "count", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "answer", .unit = "", .doc = "whether there are numbers at this instant", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ANSWER, .offset = offsetof(orr_msg_epoch, answer), .word = words_answer, .n_words = sizeof words_answer / sizeof words_answer[0], .in_text = true, .text_name = "answer", .text_factor = 1.0, .in_table = true, .head = "answer", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_epoch = {"epoch", fields_epoch, 4, sizeof(orr_msg_epoch), true, false};

static const orr_field fields_span[] = {
    {.name = "first", .unit = "ns", .doc = "first instant; -2^63 where there is none", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_span, first), .in_text = true, .text_name = "first", .text_factor = 1.0, .in_table = true, .head = "first", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "last", .unit = "ns", .doc = "last instant; likewise", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_span, last), .in_text = true, .text_name = "last", .text_factor = 1.0, .in_table = true, .head = "last", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_span = {"span", fields_span, 2, sizeof(orr_msg_span), false, false};

static const orr_field fields_served_request[] = {
    {.name = "request", .unit = "", .doc = "its message type", .kind = ORR_FIELD_U16, .show = ORR_SHOW_MESSAGE, .offset = offsetof(orr_msg_served_request, request), .in_text = true, .text_name = "request", .text_factor = 1.0, .in_table = true, .head = "request", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "answer", .unit = "", .doc = "message type of its answer", .kind = ORR_FIELD_U16, .show = ORR_SHOW_MESSAGE, .offset = offsetof(orr_msg_served_request, answer), .in_text = true, .text_name = "answer", .text_factor = 1.0, .in_table = true, .head = "answer", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "span", .unit = "", .doc = "instants at which there can be numbers; none of a request without epochs", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_served_request, span), .record = &record_span, .in_text = true, .text_name = "span", .text_factor = 1.0, .in_table = true, .head = "span", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_served_request = {"served_request", fields_served_request, 3, sizeof(orr_msg_served_request), false, false};

static const orr_field fields_inertial_unit[] = {
    {.name = "unit", .unit = "", .doc = "its number in POLL_IMU and POLL_TRUTH; 0 is the trajectory's own point", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_inertial_unit, unit), .in_text = true, .text_name = "unit", .text_factor = 1.0, .in_table = true, .head = "unit", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "name", .unit = "", .doc = "its name in the scenario", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_inertial_unit, name), .limit = 64, .in_text = true, .text_name = "name", .text_factor = 1.0, .in_table = true, .head = "name", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "lever_m", .unit = "m", .doc = "where it is from unit 0: to the right, forward, up in the vehicle's axes", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "lever_", .suffix = "_m", .offset = offsetof(orr_msg_inertial_unit, lever_m), .in_text = true, .text_name = "lever_m", .text_factor = 1.0, .in_table = true, .head = "lever", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "heading_rad", .unit = "rad", .doc = "how it is mounted: heading against the vehicle's axes", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_inertial_unit, heading_rad), .in_text = true, .text_name = "heading_rad", .text_factor = 1.0, .in_table = true, .head = "heading", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "pitch_rad", .unit = "rad", .doc = "likewise pitch", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_inertial_unit, pitch_rad), .in_text = true, .text_name = "pitch_rad", .text_factor = 1.0, .in_table = true, .head = "pitch", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "roll_rad", .unit = "rad", .doc = "likewise roll", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_inertial_unit, roll_rad), .in_text = true, .text_name = "roll_rad", .text_factor = 1.0, .in_table = true, .head = "roll", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_inertial_unit = {"inertial_unit", fields_inertial_unit, 6, sizeof(orr_msg_inertial_unit), false, false};

static const orr_field fields_leap_seconds[] = {
    {.name = "gps_utc_s", .unit = "s", .doc = "GPS time minus UTC, in force at the first instant served", .kind = ORR_FIELD_I16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_leap_seconds, gps_utc_s), .in_text = true, .text_name = "gps_utc_s", .text_factor = 1.0, .in_table = true, .head = "gps utc", .table_unit = "s", .table_factor = 1.0, .digits = -1},
    {.name = "next_gps_utc_s", .unit = "s", .doc = "from `next` on; the same where no later change is known", .kind = ORR_FIELD_I16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_leap_seconds, next_gps_utc_s), .in_text = true, .text_name = "next_gps_utc_s", .text_factor = 1.0, .in_table = true, .head = "next gps utc", .table_unit = "s", .table_factor = 1.0, .digits = -1},
    {.name = "next", .unit = "ns", .doc = "first instant of the next value; -2^63 where no later change is known", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_leap_seconds, next), .in_text = true, .text_name = "next", .text_factor = 1.0, .in_table = true, .head = "next", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_leap_seconds = {"leap_seconds", fields_leap_seconds, 3, sizeof(orr_msg_leap_seconds), false, false};

static const orr_field fields_sat_state[] = {
    {.name = "sat", .unit = "", .doc = "which satellite", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_state, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "answer", .unit = "", .doc = "OK, NO_ARC or NOT_SERVED", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ANSWER, .offset = offsetof(orr_msg_sat_state, answer), .word = words_answer, .n_words = sizeof words_answer / sizeof words_answer[0], .in_text = true, .text_name = "answer", .text_factor = 1.0, .in_table = true, .head = "answer", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_state, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "flags", .unit = "", .doc = "0 unless answer is OK", .kind = ORR_FIELD_U32, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_sat_state, flags), .word = words_state_flags, .n_words = sizeof words_state_flags / sizeof words_state_flags[0], .in_text = true, .text_name = "flags", .text_factor = 1.0, .in_table = true, .head = "flags", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "pos_m", .unit = "m", .doc = "position of the centre of mass", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "", .suffix = "_m", .offset = offsetof(orr_msg_sat_state, pos_m), .in_text = true, .text_name = "pos_m", .text_factor = 1.0, .in_table = true, .head = "", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "vel_mps", .unit = "m/s", .doc = "its first derivative (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "v", .suffix = "_mps", .offset = offsetof(orr_msg_sat_state, vel_mps), .in_text = true, .text_name = "vel_mps", .text_factor = 1.0, .in_table = true, .head = "v", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "acc_mps2", .unit = "m/s2", .doc = "its second derivative (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "a", .suffix = "_mps2", .offset = offsetof(orr_msg_sat_state, acc_mps2), .in_text = true, .text_name = "acc_mps2", .text_factor = 1.0, .in_table = false, .head = "a", .table_unit = "m/s2", .table_factor = 1.0, .digits = 6},
    {.name = "clock_s", .unit = "s", .doc = "clock offset, periodic relativity not included", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_state, clock_s), .in_text = true, .text_name = "clock_s", .text_factor = 1.0, .in_table = true, .head = "clock", .table_unit = "us", .table_factor = 1000000.0, .digits = 6},
    {.name = "clock_rate_sps", .unit = "s/s", .doc = "its derivative", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_state, clock_rate_sps), .in_text = true, .text_name = "clock_rate_sps", .text_factor = 1.0, .in_table = false, .head = "clock rate", .table_unit = "s/s", .table_factor = 1.0, .digits = -1},
    {.name = "valid_from", .unit = "ns", .doc = "start of the arc that was evaluated", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_state, valid_from), .in_text = true, .text_name = "valid_from", .text_factor = 1.0, .in_table = false, .head = "valid from", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "valid_to", .unit = "ns", .doc = "its end", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_state, valid_to), .in_text = true, .text_name = "valid_to", .text_factor = 1.0, .in_table = false, .head = "valid to", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "sigma_m", .unit = "m", .doc = "1-sigma of the position, 3-D", .kind = ORR_FIELD_F32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_state, sigma_m), .in_text = true, .text_name = "sigma_m", .text_factor = 1.0, .in_table = true, .head = "sigma", .table_unit = "mm", .table_factor = 1000.0, .digits = 1},
    {.name = "clock_sigma_s", .unit = "s", .doc = "1-sigma of clock_s; NAN where there is no clock or it is not known", .kind = ORR_FIELD_F32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_state, clock_sigma_s), .in_text = true, .text_name = "clock_sigma_s", .text_factor = 1.0, .in_table = true, .head = "clock sigma", .table_unit = "ns", .table_factor = 1000000000.0, .digits = 3},
};
static const orr_record record_sat_state = {"sat_state", fields_sat_state, 13, sizeof(orr_msg_sat_state), false, false};

static const orr_field fields_sat_elements[] = {
    {.name = "sat", .unit = "", .doc = "which satellite", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "answer", .unit = "", .doc = "OK, NO_ARC, NOT_SERVED, or NO_VALUE where the arc is too short for the method", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ANSWER, .offset = offsetof(orr_msg_sat_elements, answer), .word = words_answer, .n_words = sizeof words_answer / sizeof words_answer[0], .in_text = true, .text_name = "answer", .text_factor = 1.0, .in_table = true, .head = "answer", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "flags", .unit = "", .doc = "of the state at the epoch; 0 unless answer is OK", .kind = ORR_FIELD_U32, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_sat_elements, flags), .word = words_state_flags, .n_words = sizeof words_state_flags / sizeof words_state_flags[0], .in_text = true, .text_name = "flags", .text_factor = 1.0, .in_table = true, .head = "flags", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "a_m", .unit = "m", .doc = "semi-major axis", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, a_m), .in_text = true, .text_name = "a_m", .text_factor = 1.0, .in_table = true, .head = "a", .table_unit = "m", .table_factor = 1.0, .digits = 3},
    {.name = "e", .unit = "", .doc = "eccentricity", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, e), .in_text = true, .text_name = "e", .text_factor = 1.0, .in_table = true, .head = "e", .table_unit = "", .table_factor = 1.0, .digits = 9},
    {.name = "i_rad", .unit = "rad", .doc = "inclination", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, i_rad), .in_text = true, .text_name = "i_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "i", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 6},
    {.name = "raan_rad", .unit = "rad", .doc = "right ascension of the ascending node, 0 to 2 pi", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, raan_rad), .in_text = true, .text_name = "raan_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "raan", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 6},
    {.name = "argp_rad", .unit = "rad", .doc = "argument of perigee; ill-determined in near-circular orbits", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, argp_rad), .in_text = true, .text_name = "argp_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "argp", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 6},
    {.name = "m_rad", .unit = "rad", .doc = "mean anomaly; likewise", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, m_rad), .in_text = true, .text_name = "m_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "m", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 6},
    {.name = "u_rad", .unit = "rad", .doc = "argument of latitude", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_elements, u_rad), .in_text = true, .text_name = "u_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "u", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 6},
};
static const orr_record record_sat_elements = {"sat_elements", fields_sat_elements, 11, sizeof(orr_msg_sat_elements), false, false};

static const orr_field fields_nav_page[] = {
    {.name = "t", .unit = "ns", .doc = "begin of its first bit", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_nav_page, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "length", .unit = "ns", .doc = "from there to the end of its last; 1.7 s for GLONASS' bits, whose time mark is not among them", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_nav_page, length), .in_text = true, .text_name = "length", .text_factor = 1.0, .in_table = false, .head = "length", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "number", .unit = "", .doc = "LNAV, D1: subframe 1-5; D2: page 1-10 of subframe 1; GLONASS: string 1-15; INAV: word type; FNAV: page type; NavIC: subframe 1-4; CNV1, and CNV2 of GPS and QZSS: page of subframe 3; others: message type", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_nav_page, number), .in_text = true, .text_name = "number", .text_factor = 1.0, .in_table = true, .head = "number", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "page", .unit = "", .doc = "LNAV, D1: page of subframes 4 and 5, 0 otherwise; D2: page 1-120 of subframe 5; GLONASS: frame 1-5 of the superframe; INAV, FNAV: sub-frame 1-24, 1-12 of the frame; NavIC: message of subframes 3 and 4", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_nav_page, page), .in_text = true, .text_name = "page", .text_factor = 1.0, .in_table = true, .head = "page", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "bits", .unit = "", .doc = "how many bits or symbols", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_nav_page, bits), .in_text = true, .text_name = "bits", .text_factor = 1.0, .in_table = true, .head = "bits", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "data", .unit = "", .doc = "the first in time is the highest bit of the first byte; what is left of the last is 0", .kind = ORR_FIELD_BYTES, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_nav_page, data), .limit = 226, .in_text = true, .text_name = "hex", .text_factor = 1.0, .in_table = true, .head = "data", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_nav_page = {"nav_page", fields_nav_page, 6, sizeof(orr_msg_nav_page), false, false};

static const orr_field fields_kepler_set[] = {
    {.name = "sqrt_a_sqrtm", .unit = "sqrt(m)", .doc = "root of the semi-major axis", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, sqrt_a_sqrtm), .in_text = true, .text_name = "sqrt_a_sqrtm", .text_factor = 1.0, .in_table = true, .head = "sqrt a sqrtm", .table_unit = "sqrt(m)", .table_factor = 1.0, .digits = -1},
    {.name = "e", .unit = "", .doc = "eccentricity", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, e), .in_text = true, .text_name = "e", .text_factor = 1.0, .in_table = true, .head = "e", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "m0_rad", .unit = "rad", .doc = "mean anomaly at toe", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, m0_rad), .in_text = true, .text_name = "m0_rad", .text_factor = 1.0, .in_table = true, .head = "m0", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "i0_rad", .unit = "rad", .doc = "inclination at toe", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, i0_rad), .in_text = true, .text_name = "i0_rad", .text_factor = 1.0, .in_table = true, .head = "i0", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "omega0_rad", .unit = "rad", .doc = "longitude of the node at the week's begin", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, omega0_rad), .in_text = true, .text_name = "omega0_rad", .text_factor = 1.0, .in_table = true, .head = "omega0", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "omega_rad", .unit = "rad", .doc = "argument of perigee", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, omega_rad), .in_text = true, .text_name = "omega_rad", .text_factor = 1.0, .in_table = true, .head = "omega", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "delta_n_radps", .unit = "rad/s", .doc = "mean motion difference", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, delta_n_radps), .in_text = true, .text_name = "delta_n_radps", .text_factor = 1.0, .in_table = true, .head = "delta n", .table_unit = "rad/s", .table_factor = 1.0, .digits = -1},
    {.name = "idot_radps", .unit = "rad/s", .doc = "rate of the inclination", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, idot_radps), .in_text = true, .text_name = "idot_radps", .text_factor = 1.0, .in_table = true, .head = "idot", .table_unit = "rad/s", .table_factor = 1.0, .digits = -1},
    {.name = "omega_dot_radps", .unit = "rad/s", .doc = "rate of the node", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, omega_dot_radps), .in_text = true, .text_name = "omega_dot_radps", .text_factor = 1.0, .in_table = true, .head = "omega dot", .table_unit = "rad/s", .table_factor = 1.0, .digits = -1},
    {.name = "cuc_rad", .unit = "rad", .doc = "cosine term of the argument of latitude", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, cuc_rad), .in_text = true, .text_name = "cuc_rad", .text_factor = 1.0, .in_table = true, .head = "cuc", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "cus_rad", .unit = "rad", .doc = "its sine term", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, cus_rad), .in_text = true, .text_name = "cus_rad", .text_factor = 1.0, .in_table = true, .head = "cus", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "crc_m", .unit = "m", .doc = "cosine term of the radius", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, crc_m), .in_text = true, .text_name = "crc_m", .text_factor = 1.0, .in_table = true, .head = "crc", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "crs_m", .unit = "m", .doc = "its sine term", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, crs_m), .in_text = true, .text_name = "crs_m", .text_factor = 1.0, .in_table = true, .head = "crs", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "cic_rad", .unit = "rad", .doc = "cosine term of the inclination", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, cic_rad), .in_text = true, .text_name = "cic_rad", .text_factor = 1.0, .in_table = true, .head = "cic", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "cis_rad", .unit = "rad", .doc = "its sine term", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, cis_rad), .in_text = true, .text_name = "cis_rad", .text_factor = 1.0, .in_table = true, .head = "cis", .table_unit = "rad", .table_factor = 1.0, .digits = -1},
    {.name = "a_dot_mps", .unit = "m/s", .doc = "rate of the semi-major axis; 0 in messages without it", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, a_dot_mps), .in_text = true, .text_name = "a_dot_mps", .text_factor = 1.0, .in_table = true, .head = "a dot", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "delta_n_dot_radps2", .unit = "rad/s2", .doc = "rate of the mean motion difference; 0 likewise", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, delta_n_dot_radps2), .in_text = true, .text_name = "delta_n_dot_radps2", .text_factor = 1.0, .in_table = true, .head = "delta n dot radps2", .table_unit = "rad/s2", .table_factor = 1.0, .digits = -1},
    {.name = "tgd_s", .unit = "s", .doc = "group delay of the first signal of the message's system behind its clock: TGD of LNAV and CNAV, BGD(E1,E5b) of INAV, BGD(E1,E5a) of FNAV, TGD1 of D1 and D2, TGD of the B1C pilot of CNV1 and CNV2, TGD of B2b of CNV3", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_kepler_set, tgd_s), .in_text = true, .text_name = "tgd_s", .text_factor = 1.0, .in_table = true, .head = "tgd", .table_unit = "s", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_kepler_set = {"kepler_set", fields_kepler_set, 18, sizeof(orr_msg_kepler_set), false, false};

static const orr_field fields_glonass_set[] = {
    {.name = "pos_m", .unit = "m", .doc = "position at toe (t_b), PZ-90; of SBAS at t0, WGS 84", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "", .suffix = "_m", .offset = offsetof(orr_msg_glonass_set, pos_m), .in_text = true, .text_name = "pos_m", .text_factor = 1.0, .in_table = true, .head = "", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "vel_mps", .unit = "m/s", .doc = "velocity at toe", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "v", .suffix = "_mps", .offset = offsetof(orr_msg_glonass_set, vel_mps), .in_text = true, .text_name = "vel_mps", .text_factor = 1.0, .in_table = true, .head = "v", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "acc_mps2", .unit = "m/s2", .doc = "acceleration by Sun and Moon; of SBAS all of it", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "a", .suffix = "_mps2", .offset = offsetof(orr_msg_glonass_set, acc_mps2), .in_text = true, .text_name = "acc_mps2", .text_factor = 1.0, .in_table = true, .head = "a", .table_unit = "m/s2", .table_factor = 1.0, .digits = 6},
    {.name = "delta_tau_s", .unit = "s", .doc = "L2 behind L1; of SBAS 0", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_glonass_set, delta_tau_s), .in_text = true, .text_name = "delta_tau_s", .text_factor = 1.0, .in_table = true, .head = "delta tau", .table_unit = "s", .table_factor = 1.0, .digits = -1},
    {.name = "channel", .unit = "", .doc = "frequency channel -7 to 6; of SBAS 0", .kind = ORR_FIELD_I8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_glonass_set, channel), .in_text = true, .text_name = "channel", .text_factor = 1.0, .in_table = true, .head = "channel", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_glonass_set, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_glonass_set = {"glonass_set", fields_glonass_set, 6, sizeof(orr_msg_glonass_set), false, false};

static bool next_kepler_set(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_kepler_set_next((const orr_msg_kepler_set_list *)list, it, (orr_msg_kepler_set *)out);
}

static bool next_glonass_set(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_glonass_set_next((const orr_msg_glonass_set_list *)list, it, (orr_msg_glonass_set *)out);
}

static bool next_nav_page(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_nav_page_next((const orr_msg_nav_page_list *)list, it, (orr_msg_nav_page *)out);
}

static const orr_field fields_sat_navdata[] = {
    {.name = "sat", .unit = "", .doc = "which satellite", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "answer", .unit = "", .doc = "OK, NO_ARC (it sends nothing then), NOT_SERVED (no such data could be made of it), or NO_VALUE (a value does not fit its field)", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ANSWER, .offset = offsetof(orr_msg_sat_navdata, answer), .word = words_answer, .n_words = sizeof words_answer / sizeof words_answer[0], .in_text = true, .text_name = "answer", .text_factor = 1.0, .in_table = true, .head = "answer", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "message", .unit = "", .doc = "NONE where the satellite has none of those asked for", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_sat_navdata, message), .word = words_nav_message, .n_words = sizeof words_nav_message / sizeof words_nav_message[0], .in_text = true, .text_name = "message", .text_factor = 1.0, .in_table = true, .head = "message", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "form", .unit = "", .doc = "of the pages, as asked", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_sat_navdata, form), .word = words_nav_form, .n_words = sizeof words_nav_form / sizeof words_nav_form[0], .in_text = true, .text_name = "form", .text_factor = 1.0, .in_table = false, .head = "form", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "signals", .unit = "", .doc = "names of the signals that carry it, as in CAPS, divided by blanks: L1OF L2OF", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, signals), .limit = 16, .in_text = true, .text_name = "signals", .text_factor = 1.0, .in_table = true, .head = "signals", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "notes", .unit = "", .doc = "0 unless answer is OK", .kind = ORR_FIELD_U32, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_sat_navdata, notes), .word = words_nav_notes, .n_words = sizeof words_nav_notes / sizeof words_nav_notes[0], .in_text = true, .text_name = "notes", .text_factor = 1.0, .in_table = true, .head = "notes", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "set_from", .unit = "ns", .doc = "the set is sent from then on", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_navdata, set_from), .in_text = true, .text_name = "set_from", .text_factor = 1.0, .in_table = false, .head = "set from", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "set_to", .unit = "ns", .doc = "and before then", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_navdata, set_to), .in_text = true, .text_name = "set_to", .text_factor = 1.0, .in_table = false, .head = "set to", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "toe", .unit = "ns", .doc = "reference of the orbit", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_navdata, toe), .in_text = true, .text_name = "toe", .text_factor = 1.0, .in_table = true, .head = "toe", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "toc", .unit = "ns", .doc = "reference of the clock", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_navdata, toc), .in_text = true, .text_name = "toc", .text_factor = 1.0, .in_table = false, .head = "toc", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "week", .unit = "", .doc = "week of toe: GPS', of BeiDou its own; -1 for GLONASS", .kind = ORR_FIELD_I32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, week), .in_text = true, .text_name = "week", .text_factor = 1.0, .in_table = false, .head = "week", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "iode", .unit = "", .doc = "issue of the orbit: IODE, IODnav, AODE; -1 for GLONASS", .kind = ORR_FIELD_I16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, iode), .in_text = true, .text_name = "iode", .text_factor = 1.0, .in_table = true, .head = "iode", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "iodc", .unit = "", .doc = "issue of the clock: IODC, AODC; -1 where the message has none of its own", .kind = ORR_FIELD_I16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, iodc), .in_text = true, .text_name = "iodc", .text_factor = 1.0, .in_table = false, .head = "iodc", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "health", .unit = "", .doc = "0 is good; LNAV: six bits; INAV, FNAV: the bits of RINEX 3.05; others: 1 for unfit", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, health), .in_text = true, .text_name = "health", .text_factor = 1.0, .in_table = true, .head = "health", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "accuracy_m", .unit = "m", .doc = "user range or signal in space accuracy that is sent; NAN for GLONASS", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, accuracy_m), .in_text = true, .text_name = "accuracy_m", .text_factor = 1.0, .in_table = false, .head = "accuracy", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "fit_rms_m", .unit = "m", .doc = "3-D RMS of the rounded set against the orbit, over its window", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, fit_rms_m), .in_text = true, .text_name = "fit_rms_m", .text_factor = 1.0, .in_table = true, .head = "fit rms", .table_unit = "m", .table_factor = 1.0, .digits = 3},
    {.name = "fit_max_m", .unit = "m", .doc = "largest of these distances", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, fit_max_m), .in_text = true, .text_name = "fit_max_m", .text_factor = 1.0, .in_table = true, .head = "fit max", .table_unit = "m", .table_factor = 1.0, .digits = 3},
    {.name = "clock_rms_s", .unit = "s", .doc = "the same of the clock; NAN with NO_CLOCK", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, clock_rms_s), .in_text = true, .text_name = "clock_rms_s", .text_factor = 1.0, .in_table = true, .head = "clock rms", .table_unit = "ns", .table_factor = 1000000000.0, .digits = 3},
    {.name = "af0_s", .unit = "s", .doc = "clock at toc; GLONASS: -tau_n", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, af0_s), .in_text = true, .text_name = "af0_s", .text_factor = 1.0, .in_table = true, .head = "af0", .table_unit = "us", .table_factor = 1000000.0, .digits = 6},
    {.name = "af1_sps", .unit = "s/s", .doc = "its rate; GLONASS: gamma_n", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, af1_sps), .in_text = true, .text_name = "af1_sps", .text_factor = 1.0, .in_table = false, .head = "af1", .table_unit = "s/s", .table_factor = 1.0, .digits = -1},
    {.name = "af2_sps2", .unit = "s/s2", .doc = "its second coefficient; 0 for GLONASS", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, af2_sps2), .in_text = true, .text_name = "af2_sps2", .text_factor = 1.0, .in_table = false, .head = "af2 sps2", .table_unit = "s/s2", .table_factor = 1.0, .digits = -1},
    {.name = "frame_from", .unit = "ns", .doc = "begin of the frame of the message that holds the epoch", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_navdata, frame_from), .in_text = true, .text_name = "frame_from", .text_factor = 1.0, .in_table = false, .head = "frame from", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "frame_to", .unit = "ns", .doc = "its end: the next frame's begin", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_navdata, frame_to), .in_text = true, .text_name = "frame_to", .text_factor = 1.0, .in_table = false, .head = "frame to", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "kepler", .unit = "", .doc = "of messages with Kepler elements: one", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, kepler), .limit = 1, .record = &record_kepler_set, .next = next_kepler_set, .in_text = true, .text_name = "kepler", .text_factor = 1.0, .in_table = false, .head = "kepler", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "glonass", .unit = "", .doc = "of FDMA and SBAS: one", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, glonass), .limit = 1, .record = &record_glonass_set, .next = next_glonass_set, .in_text = true, .text_name = "glonass", .text_factor = 1.0, .in_table = false, .head = "glonass", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "pages", .unit = "", .doc = "all of the frame", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_navdata, pages), .limit = 15, .record = &record_nav_page, .next = next_nav_page, .in_text = true, .text_name = "pages", .text_factor = 1.0, .in_table = false, .head = "pages", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_sat_navdata = {"sat_navdata", fields_sat_navdata, 26, sizeof(orr_msg_sat_navdata), false, false};

static const orr_field fields_sat_delay[] = {
    {.name = "sat", .unit = "", .doc = "which satellite", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "answer", .unit = "", .doc = "OK, NO_ARC, NOT_SERVED, BELOW_HORIZON or NO_VALUE", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ANSWER, .offset = offsetof(orr_msg_sat_delay, answer), .word = words_answer, .n_words = sizeof words_answer / sizeof words_answer[0], .in_text = true, .text_name = "answer", .text_factor = 1.0, .in_table = true, .head = "answer", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "origin", .unit = "", .doc = "what it came from", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_sat_delay, origin), .word = words_tec_origin, .n_words = sizeof words_tec_origin / sizeof words_tec_origin[0], .in_text = true, .text_name = "origin", .text_factor = 1.0, .in_table = true, .head = "origin", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "flags", .unit = "", .doc = "0 unless answer is OK", .kind = ORR_FIELD_U8, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_sat_delay, flags), .word = words_delay_flags, .n_words = sizeof words_delay_flags / sizeof words_delay_flags[0], .in_text = true, .text_name = "flags", .text_factor = 1.0, .in_table = true, .head = "flags", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "az_rad", .unit = "rad", .doc = "azimuth, clockwise from North", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, az_rad), .in_text = true, .text_name = "az_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "az", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 2},
    {.name = "el_rad", .unit = "rad", .doc = "elevation above the ellipsoidal horizon", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, el_rad), .in_text = true, .text_name = "el_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "el", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 2},
    {.name = "pierce_lat_rad", .unit = "rad", .doc = "geocentric latitude of the pierce point", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, pierce_lat_rad), .in_text = true, .text_name = "pierce_lat_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "lat", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 3},
    {.name = "pierce_lon_rad", .unit = "rad", .doc = "its longitude, East", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, pierce_lon_rad), .in_text = true, .text_name = "pierce_lon_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "lon", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 3},
    {.name = "mapping", .unit = "", .doc = "slant over vertical", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, mapping), .in_text = true, .text_name = "mapping", .text_factor = 1.0, .in_table = false, .head = "mapping", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "stec_tecu", .unit = "TECU", .doc = "slant total electron content", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, stec_tecu), .in_text = true, .text_name = "stec_tecu", .text_factor = 1.0, .in_table = true, .head = "stec", .table_unit = "TECU", .table_factor = 1.0, .digits = 3},
    {.name = "model_stec_tecu", .unit = "TECU", .doc = "the part of the field as it is", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, model_stec_tecu), .in_text = true, .text_name = "model_stec_tecu", .text_factor = 1.0, .in_table = false, .head = "model stec", .table_unit = "TECU", .table_factor = 1.0, .digits = 3},
    {.name = "delay_m", .unit = "m", .doc = "delay of a code on each carrier asked for, NAN beyond them; a carrier phase is early by it", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 4, .stem = "delay_", .suffix = "_m", .offset = offsetof(orr_msg_sat_delay, delay_m), .per = "carriers_hz", .in_text = true, .text_name = "delay_m", .text_factor = 1.0, .in_table = true, .head = "delay", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "sigma_tecu", .unit = "TECU", .doc = "1-sigma of stec_tecu, NAN where unknown", .kind = ORR_FIELD_F32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_delay, sigma_tecu), .in_text = true, .text_name = "sigma_tecu", .text_factor = 1.0, .in_table = true, .head = "sigma", .table_unit = "TECU", .table_factor = 1.0, .digits = 3},
};
static const orr_record record_sat_delay = {"sat_delay", fields_sat_delay, 14, sizeof(orr_msg_sat_delay), false, false};

static const orr_field fields_antenna[] = {
    {.name = "antenna", .unit = "", .doc = "its number in POLL_CHANNELS", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_antenna, antenna), .in_text = true, .text_name = "antenna", .text_factor = 1.0, .in_table = true, .head = "antenna", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "name", .unit = "", .doc = "its name in the scenario", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_antenna, name), .limit = 64, .in_text = true, .text_name = "name", .text_factor = 1.0, .in_table = true, .head = "name", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "kind", .unit = "", .doc = "antenna and radome as ANTEX files write them; empty where the phase centre is the reference point", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_antenna, kind), .limit = 20, .in_text = true, .text_name = "kind", .text_factor = 1.0, .in_table = true, .head = "kind", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "pos_m", .unit = "m", .doc = "reference point of a fixed antenna (ecef); NAN where it moves", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "pos_", .suffix = "_m", .offset = offsetof(orr_msg_antenna, pos_m), .in_text = true, .text_name = "pos_m", .text_factor = 1.0, .in_table = true, .head = "pos", .table_unit = "m", .table_factor = 1.0, .digits = 4},
};
static const orr_record record_antenna = {"antenna", fields_antenna, 4, sizeof(orr_msg_antenna), false, false};

static const orr_field fields_signal[] = {
    {.name = "signal", .unit = "", .doc = "its number in POLL_CHANNELS and CHANNELS", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, signal), .in_text = true, .text_name = "signal", .text_factor = 1.0, .in_table = true, .head = "signal", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "system", .unit = "", .doc = "letter of the system", .kind = ORR_FIELD_U8, .show = ORR_SHOW_CHAR, .offset = offsetof(orr_msg_signal, system), .in_text = true, .text_name = "system", .text_factor = 1.0, .in_table = true, .head = "system", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "name", .unit = "", .doc = "its name, e.g. L1CA", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, name), .limit = 16, .in_text = true, .text_name = "name", .text_factor = 1.0, .in_table = true, .head = "name", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "observation", .unit = "", .doc = "RINEX 3 band and attribute, e.g. 1C", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, observation), .limit = 8, .in_text = true, .text_name = "observation", .text_factor = 1.0, .in_table = true, .head = "observation", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "modulation", .unit = "", .doc = "e.g. BPSK(1)", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, modulation), .limit = 32, .in_text = true, .text_name = "modulation", .text_factor = 1.0, .in_table = true, .head = "modulation", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "components", .unit = "", .doc = "divided by blanks, e.g. I Q", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, components), .limit = 16, .in_text = true, .text_name = "components", .text_factor = 1.0, .in_table = true, .head = "components", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "carrier_hz", .unit = "Hz", .doc = "carrier; of GLONASS' FDMA signals that of channel 0", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, carrier_hz), .in_text = true, .text_name = "carrier_hz", .text_factor = 1.0, .in_table = true, .head = "carrier", .table_unit = "Hz", .table_factor = 1.0, .digits = -1},
    {.name = "channel_hz", .unit = "Hz", .doc = "step of a GLONASS frequency channel; 0 for others", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, channel_hz), .in_text = true, .text_name = "channel_hz", .text_factor = 1.0, .in_table = true, .head = "channel", .table_unit = "Hz", .table_factor = 1.0, .digits = -1},
    {.name = "chips_per_s", .unit = "chip/s", .doc = "rate of the ranging code", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, chips_per_s), .in_text = true, .text_name = "chips_per_s", .text_factor = 1.0, .in_table = true, .head = "chips per s", .table_unit = "chip/s", .table_factor = 1.0, .digits = -1},
    {.name = "chips", .unit = "", .doc = "length of one period of the primary code", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_signal, chips), .in_text = true, .text_name = "chips", .text_factor = 1.0, .in_table = true, .head = "chips", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_signal = {"signal", fields_signal, 10, sizeof(orr_msg_signal), false, false};

static const orr_field fields_transmitter[] = {
    {.name = "sat", .unit = "", .doc = "which satellite", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_transmitter, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "frequency_channel", .unit = "", .doc = "GLONASS: -7 to 6; 0 for others", .kind = ORR_FIELD_I8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_transmitter, frequency_channel), .in_text = true, .text_name = "frequency_channel", .text_factor = 1.0, .in_table = true, .head = "frequency channel", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "unhealthy", .unit = "", .doc = "1 where the scenario marks it as not to be used, else 0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_transmitter, unhealthy), .in_text = true, .text_name = "unhealthy", .text_factor = 1.0, .in_table = true, .head = "unhealthy", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "svn", .unit = "", .doc = "space vehicle as ANTEX names it, e.g. G063; empty without ANTEX", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_transmitter, svn), .limit = 10, .in_text = true, .text_name = "svn", .text_factor = 1.0, .in_table = true, .head = "svn", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "block", .unit = "", .doc = "type of the satellite as ANTEX names it, e.g. BLOCK IIF; empty without ANTEX", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_transmitter, block), .limit = 20, .in_text = true, .text_name = "block", .text_factor = 1.0, .in_table = true, .head = "block", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_transmitter = {"transmitter", fields_transmitter, 5, sizeof(orr_msg_transmitter), false, false};

static const orr_field fields_sat_channel[] = {
    {.name = "sat", .unit = "", .doc = "which satellite", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "signal", .unit = "", .doc = "which signal, its number in CAPS", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, signal), .in_text = true, .text_name = "signal", .text_factor = 1.0, .in_table = true, .head = "signal", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "flags", .unit = "", .doc = "what should be known of it", .kind = ORR_FIELD_U32, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_sat_channel, flags), .word = words_channel_flags, .n_words = sizeof words_channel_flags / sizeof words_channel_flags[0], .in_text = true, .text_name = "flags", .text_factor = 1.0, .in_table = true, .head = "flags", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "az_rad", .unit = "rad", .doc = "azimuth of the satellite at the block's begin, clockwise from North", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, az_rad), .in_text = true, .text_name = "az_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "az", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 2},
    {.name = "el_rad", .unit = "rad", .doc = "its elevation above the ellipsoidal horizon", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, el_rad), .in_text = true, .text_name = "el_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "el", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 2},
    {.name = "carrier_hz", .unit = "Hz", .doc = "carrier", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, carrier_hz), .in_text = true, .text_name = "carrier_hz", .text_factor = 1.0, .in_table = true, .head = "carrier", .table_unit = "MHz", .table_factor = 1e-06, .digits = 4},
    {.name = "code", .unit = "m/s^k", .doc = "cubic of the pseudorange", .kind = ORR_FIELD_F64, .show = ORR_SHOW_POLYNOMIAL, .length = 4, .stem = "code_", .suffix = "", .offset = offsetof(orr_msg_sat_channel, code), .in_text = true, .text_name = "code", .text_factor = 1.0, .in_table = false, .head = "code", .table_unit = "m/s^k", .table_factor = 1.0, .digits = -1},
    {.name = "carrier_cycles", .unit = "cycle", .doc = "whole cycles of the carrier's phase range at the block's begin; an integer that stays while the satellite is in view is part of it", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, carrier_cycles), .in_text = true, .text_name = "carrier_cycles", .text_factor = 1.0, .in_table = true, .head = "cycles", .table_unit = "cycle", .table_factor = 1.0, .digits = 0},
    {.name = "carrier", .unit = "cycle/s^k", .doc = "cubic of the phase range, less carrier_cycles; the Doppler frequency is -carrier[1] at the begin, positive while approaching", .kind = ORR_FIELD_F64, .show = ORR_SHOW_POLYNOMIAL, .length = 4, .stem = "carrier_", .suffix = "", .offset = offsetof(orr_msg_sat_channel, carrier), .in_text = true, .text_name = "carrier", .text_factor = 1.0, .in_table = false, .head = "carrier", .table_unit = "cycle/s^k", .table_factor = 1.0, .digits = -1},
    {.name = "transmit", .unit = "ns", .doc = "reading of the satellite's clock when the code at the block's begin was sent: whole nanoseconds, the scale's whole seconds against GPS not taken off", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_sat_channel, transmit), .in_text = true, .text_name = "transmit", .text_factor = 1.0, .in_table = false, .head = "transmit", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "transmit_fraction_ns", .unit = "ns", .doc = "and the rest, 0 to 1", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, transmit_fraction_ns), .in_text = true, .text_name = "transmit_fraction_ns", .text_factor = 1.0, .in_table = false, .head = "transmit fraction ns", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "power_dbw", .unit = "dBW", .doc = "received by an antenna of 0 dBi; of an echo what makes it as much weaker than its signal as the antenna receives it", .kind = ORR_FIELD_F32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, power_dbw), .in_text = true, .text_name = "power_dbw", .text_factor = 1.0, .in_table = true, .head = "power", .table_unit = "dBW", .table_factor = 1.0, .digits = 1},
    {.name = "echo", .unit = "", .doc = "0: the signal itself; from 1 on an echo of it, which sends the same: the ground, then the reflectors of the scenario; 256 times 1 and so on: a false signal of the first spoofer and so on", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_sat_channel, echo), .in_text = true, .text_name = "echo", .text_factor = 1.0, .in_table = true, .head = "echo", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_sat_channel = {"sat_channel", fields_sat_channel, 13, sizeof(orr_msg_sat_channel), false, false};

static const orr_field fields_jammer[] = {
    {.name = "number", .unit = "", .doc = "its place in the scenario's list", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, number), .in_text = true, .text_name = "number", .text_factor = 1.0, .in_table = true, .head = "number", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "waveform", .unit = "", .doc = "the scenario's name of what it sends", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, waveform), .limit = 32, .in_text = true, .text_name = "waveform", .text_factor = 1.0, .in_table = true, .head = "waveform", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "az_rad", .unit = "rad", .doc = "azimuth, clockwise from North", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, az_rad), .in_text = true, .text_name = "az_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "az", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 2},
    {.name = "el_rad", .unit = "rad", .doc = "elevation above the ellipsoidal horizon", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, el_rad), .in_text = true, .text_name = "el_deg", .text_factor = 57.29577951308232, .in_table = true, .head = "el", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 2},
    {.name = "range_m", .unit = "m", .doc = "distance", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, range_m), .in_text = true, .text_name = "range_m", .text_factor = 1.0, .in_table = true, .head = "range", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "range_rate_mps", .unit = "m/s", .doc = "its rate", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, range_rate_mps), .in_text = true, .text_name = "range_rate_mps", .text_factor = 1.0, .in_table = true, .head = "range rate", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "carrier_hz", .unit = "Hz", .doc = "carrier as it is sent", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, carrier_hz), .in_text = true, .text_name = "carrier_hz", .text_factor = 1.0, .in_table = true, .head = "carrier", .table_unit = "MHz", .table_factor = 1e-06, .digits = 4},
    {.name = "doppler_hz", .unit = "Hz", .doc = "by which it arrives higher", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, doppler_hz), .in_text = true, .text_name = "doppler_hz", .text_factor = 1.0, .in_table = true, .head = "doppler", .table_unit = "Hz", .table_factor = 1.0, .digits = -1},
    {.name = "power_dbw", .unit = "dBW", .doc = "received by an antenna of 0 dBi, free space between", .kind = ORR_FIELD_F32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_jammer, power_dbw), .in_text = true, .text_name = "power_dbw", .text_factor = 1.0, .in_table = true, .head = "power", .table_unit = "dBW", .table_factor = 1.0, .digits = 1},
};
static const orr_record record_jammer = {"jammer", fields_jammer, 9, sizeof(orr_msg_jammer), false, false};

static const orr_field fields_channel_terms[] = {
    {.name = "distance_m", .unit = "m", .doc = "antenna to centre of mass, in the Earth's axes of emission and of reception, not turned", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, distance_m), .in_text = true, .text_name = "distance_m", .text_factor = 1.0, .in_table = true, .head = "distance", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "sagnac_m", .unit = "m", .doc = "rotation of the Earth during the flight", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, sagnac_m), .in_text = true, .text_name = "sagnac_m", .text_factor = 1.0, .in_table = true, .head = "sagnac", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "shapiro_m", .unit = "m", .doc = "relativistic delay in the Earth's field", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, shapiro_m), .in_text = true, .text_name = "shapiro_m", .text_factor = 1.0, .in_table = true, .head = "shapiro", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "satellite_clock_m", .unit = "m", .doc = "minus c times the satellite's clock offset", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, satellite_clock_m), .in_text = true, .text_name = "satellite_clock_m", .text_factor = 1.0, .in_table = true, .head = "satellite clock", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "clock_noise_m", .unit = "m", .doc = "minus c times the noise of that clock between the nodes of its product", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, clock_noise_m), .in_text = true, .text_name = "clock_noise_m", .text_factor = 1.0, .in_table = true, .head = "clock noise", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "relativity_m", .unit = "m", .doc = "minus c times the periodic relativity of that clock", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, relativity_m), .in_text = true, .text_name = "relativity_m", .text_factor = 1.0, .in_table = true, .head = "relativity", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "group_delay_m", .unit = "m", .doc = "c times the signal's group delay against the clock's pair", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, group_delay_m), .in_text = true, .text_name = "group_delay_m", .text_factor = 1.0, .in_table = true, .head = "group delay", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "satellite_antenna_m", .unit = "m", .doc = "phase centre of the satellite's antenna: offset and variation", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, satellite_antenna_m), .in_text = true, .text_name = "satellite_antenna_m", .text_factor = 1.0, .in_table = true, .head = "satellite antenna", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "receiver_antenna_m", .unit = "m", .doc = "likewise of the receiver's", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, receiver_antenna_m), .in_text = true, .text_name = "receiver_antenna_m", .text_factor = 1.0, .in_table = true, .head = "receiver antenna", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "solid_tide_m", .unit = "m", .doc = "tide of the solid Earth below a fixed antenna", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, solid_tide_m), .in_text = true, .text_name = "solid_tide_m", .text_factor = 1.0, .in_table = true, .head = "solid tide", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "pole_tide_m", .unit = "m", .doc = "tide of the pole's wandering, likewise", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, pole_tide_m), .in_text = true, .text_name = "pole_tide_m", .text_factor = 1.0, .in_table = true, .head = "pole tide", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "ocean_loading_m", .unit = "m", .doc = "weight of the ocean's tides, likewise", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, ocean_loading_m), .in_text = true, .text_name = "ocean_loading_m", .text_factor = 1.0, .in_table = true, .head = "ocean loading", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "troposphere_hydrostatic_m", .unit = "m", .doc = "hydrostatic delay", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, troposphere_hydrostatic_m), .in_text = true, .text_name = "troposphere_hydrostatic_m", .text_factor = 1.0, .in_table = true, .head = "troposphere hydrostatic", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "troposphere_wet_m", .unit = "m", .doc = "wet delay", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, troposphere_wet_m), .in_text = true, .text_name = "troposphere_wet_m", .text_factor = 1.0, .in_table = true, .head = "troposphere wet", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "turbulence_m", .unit = "m", .doc = "turbulence of water vapour: wet delay beside that", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, turbulence_m), .in_text = true, .text_name = "turbulence_m", .text_factor = 1.0, .in_table = true, .head = "turbulence", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "ionosphere_m", .unit = "m", .doc = "first order, of the code", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, ionosphere_m), .in_text = true, .text_name = "ionosphere_m", .text_factor = 1.0, .in_table = true, .head = "ionosphere", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "emission_m", .unit = "m", .doc = "the satellite's motion while the signal is delayed, without the ionosphere's part", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, emission_m), .in_text = true, .text_name = "emission_m", .text_factor = 1.0, .in_table = true, .head = "emission", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "emission_ionosphere_m", .unit = "m", .doc = "the ionosphere's part", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, emission_ionosphere_m), .in_text = true, .text_name = "emission_ionosphere_m", .text_factor = 1.0, .in_table = true, .head = "emission ionosphere", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "wind_up_m", .unit = "m", .doc = "turns of satellite and antenna, times the wavelength: of the carrier alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, wind_up_m), .in_text = true, .text_name = "wind_up_m", .text_factor = 1.0, .in_table = true, .head = "wind up", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "phase_bias_m", .unit = "m", .doc = "the carrier's bias against the clock's pair of signals: of the carrier alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, phase_bias_m), .in_text = true, .text_name = "phase_bias_m", .text_factor = 1.0, .in_table = true, .head = "phase bias", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "ionosphere_second_m", .unit = "m", .doc = "second order of the ionosphere, of the code; 0 unless the scenario asks for it", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, ionosphere_second_m), .in_text = true, .text_name = "ionosphere_second_m", .text_factor = 1.0, .in_table = true, .head = "ionosphere second", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "receiver_delay_m", .unit = "m", .doc = "replay: delay of the recorded receiver's code, the same all day", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, receiver_delay_m), .in_text = true, .text_name = "receiver_delay_m", .text_factor = 1.0, .in_table = true, .head = "receiver delay", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "residual_code_m", .unit = "m", .doc = "replay: what noise, multipath and the models' errors left of the recorded code", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, residual_code_m), .in_text = true, .text_name = "residual_code_m", .text_factor = 1.0, .in_table = true, .head = "residual code", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "residual_carrier_m", .unit = "m", .doc = "replay: likewise of the carrier; it is in the carrier alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, residual_carrier_m), .in_text = true, .text_name = "residual_carrier_m", .text_factor = 1.0, .in_table = true, .head = "residual carrier", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "disturbance_m", .unit = "m", .doc = "travelling disturbances and fronts of the ionosphere, of the code", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, disturbance_m), .in_text = true, .text_name = "disturbance_m", .text_factor = 1.0, .in_table = true, .head = "disturbance", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "scintillation_m", .unit = "m", .doc = "what irregularities of the ionosphere do to the phase: of the carrier alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, scintillation_m), .in_text = true, .text_name = "scintillation_m", .text_factor = 1.0, .in_table = true, .head = "scintillation", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "land_mobile_m", .unit = "m", .doc = "what scattered rays of a road do to the phase: of the carrier alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, land_mobile_m), .in_text = true, .text_name = "land_mobile_m", .text_factor = 1.0, .in_table = true, .head = "land mobile", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "echo_m", .unit = "m", .doc = "of an echo: how much longer its way is", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, echo_m), .in_text = true, .text_name = "echo_m", .text_factor = 1.0, .in_table = true, .head = "echo", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "echo_phase_m", .unit = "m", .doc = "of an echo: what the reflection retards the carrier by, times the wavelength: of the carrier alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, echo_phase_m), .in_text = true, .text_name = "echo_phase_m", .text_factor = 1.0, .in_table = true, .head = "echo phase", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "spoofer_m", .unit = "m", .doc = "of a false signal: the way from its transmitter, and the delay with which it sends", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, spoofer_m), .in_text = true, .text_name = "spoofer_m", .text_factor = 1.0, .in_table = true, .head = "spoofer", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "fault_range_m", .unit = "m", .doc = "faults.range: steps and ramps", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, fault_range_m), .in_text = true, .text_name = "fault_range_m", .text_factor = 1.0, .in_table = true, .head = "fault range", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "fault_noise_m", .unit = "m", .doc = "faults.noise and faults.sine", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, fault_noise_m), .in_text = true, .text_name = "fault_noise_m", .text_factor = 1.0, .in_table = true, .head = "fault noise", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "fault_clock_m", .unit = "m", .doc = "faults.clock: minus c times the clock's error", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, fault_clock_m), .in_text = true, .text_name = "fault_clock_m", .text_factor = 1.0, .in_table = true, .head = "fault clock", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "fault_divergence_m", .unit = "m", .doc = "faults.divergence: of the code alone", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, fault_divergence_m), .in_text = true, .text_name = "fault_divergence_m", .text_factor = 1.0, .in_table = true, .head = "fault divergence", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "fault_orbit_m", .unit = "m", .doc = "faults.orbit: what the displaced satellite adds to the range", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channel_terms, fault_orbit_m), .in_text = true, .text_name = "fault_orbit_m", .text_factor = 1.0, .in_table = true, .head = "fault orbit", .table_unit = "m", .table_factor = 1.0, .digits = 4},
};
static const orr_record record_channel_terms = {"channel_terms", fields_channel_terms, 35, sizeof(orr_msg_channel_terms), false, false};

static const orr_field fields_event[] = {
    {.name = "at", .unit = "ns", .doc = "when", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_event, at), .in_text = true, .text_name = "at", .text_factor = 1.0, .in_table = true, .head = "at", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "kind", .unit = "", .doc = "what", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_event, kind), .word = words_event_kind, .n_words = sizeof words_event_kind / sizeof words_event_kind[0], .in_text = true, .text_name = "kind", .text_factor = 1.0, .in_table = true, .head = "kind", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "sat", .unit = "", .doc = "of which satellite; both numbers 0: of none", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_event, sat), .record = &record_sat_id, .in_text = true, .text_name = "sat", .text_factor = 1.0, .in_table = true, .head = "sat", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "message", .unit = "", .doc = "of EPHEMERIS and HEALTH: of which message", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_event, message), .word = words_nav_message, .n_words = sizeof words_nav_message / sizeof words_nav_message[0], .in_text = true, .text_name = "message", .text_factor = 1.0, .in_table = true, .head = "message", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "antenna", .unit = "", .doc = "of RISE and SET: for which antenna of CAPS; 65535 otherwise", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_event, antenna), .in_text = true, .text_name = "antenna", .text_factor = 1.0, .in_table = false, .head = "antenna", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "value", .unit = "", .doc = "see kind; 0 where it has none", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_event, value), .in_text = true, .text_name = "value", .text_factor = 1.0, .in_table = true, .head = "value", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_event = {"event", fields_event, 6, sizeof(orr_msg_event), false, false};

static const orr_field fields_mode_change[] = {
    {.name = "number", .unit = "", .doc = "1, 2, ... since the scenario was loaded", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_mode_change, number), .in_text = true, .text_name = "number", .text_factor = 1.0, .in_table = false, .head = "number", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "at", .unit = "ns", .doc = "the scenario's instant then; of MOTION the begin of the block", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_mode_change, at), .in_text = true, .text_name = "at", .text_factor = 1.0, .in_table = true, .head = "at", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "kind", .unit = "", .doc = "of what", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_mode_change, kind), .word = words_mode_kind, .n_words = sizeof words_mode_kind / sizeof words_mode_kind[0], .in_text = true, .text_name = "kind", .text_factor = 1.0, .in_table = true, .head = "kind", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "before", .unit = "", .doc = "which it was", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_mode_change, before), .word = words_mode, .n_words = sizeof words_mode / sizeof words_mode[0], .in_text = true, .text_name = "before", .text_factor = 1.0, .in_table = true, .head = "before", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "mode", .unit = "", .doc = "which it is from then on", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_mode_change, mode), .word = words_mode, .n_words = sizeof words_mode / sizeof words_mode[0], .in_text = true, .text_name = "mode", .text_factor = 1.0, .in_table = true, .head = "mode", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_mode_change, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "wall", .unit = "ns", .doc = "the wall's instant at which that was noted", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_mode_change, wall), .in_text = true, .text_name = "wall", .text_factor = 1.0, .in_table = true, .head = "wall", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_mode_change = {"mode_change", fields_mode_change, 7, sizeof(orr_msg_mode_change), false, false};

static const orr_field fields_hello[] = {
    {.name = "major_min", .unit = "", .doc = "lowest major version the client speaks", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_hello, major_min), .in_text = true, .text_name = "major_min", .text_factor = 1.0, .in_table = true, .head = "major min", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "major_max", .unit = "", .doc = "highest", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_hello, major_max), .in_text = true, .text_name = "major_max", .text_factor = 1.0, .in_table = true, .head = "major max", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "name", .unit = "", .doc = "name of the client, for the server's log", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_hello, name), .limit = 64, .in_text = true, .text_name = "name", .text_factor = 1.0, .in_table = true, .head = "name", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "version", .unit = "", .doc = "its version", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_hello, version), .limit = 32, .in_text = true, .text_name = "version", .text_factor = 1.0, .in_table = true, .head = "version", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_hello = {"hello", fields_hello, 4, sizeof(orr_msg_hello), false, false};

static orr_wire_status encode_hello(const void *m, orr_wire_writer *w)
{
    return orr_msg_hello_encode((const orr_msg_hello *)m, w);
}
static orr_wire_status decode_hello(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_hello_decode(payload, size, (orr_msg_hello *)m);
}

static bool next_inertial_unit(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_inertial_unit_next((const orr_msg_inertial_unit_list *)list, it, (orr_msg_inertial_unit *)out);
}

static bool next_antenna(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_antenna_next((const orr_msg_antenna_list *)list, it, (orr_msg_antenna *)out);
}

static bool next_signal(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_signal_next((const orr_msg_signal_list *)list, it, (orr_msg_signal *)out);
}

static bool next_transmitter(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_transmitter_next((const orr_msg_transmitter_list *)list, it, (orr_msg_transmitter *)out);
}

static bool next_served_request(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_served_request_next((const orr_msg_served_request_list *)list, it, (orr_msg_served_request *)out);
}

static bool next_sat_id(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_sat_id_next((const orr_msg_sat_id_list *)list, it, (orr_msg_sat_id *)out);
}

static const orr_field fields_caps[] = {
    {.name = "major", .unit = "", .doc = "version chosen for the conversation", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, major), .in_text = true, .text_name = "major", .text_factor = 1.0, .in_table = true, .head = "major", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "minor", .unit = "", .doc = "minor version of the server", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, minor), .in_text = true, .text_name = "minor", .text_factor = 1.0, .in_table = true, .head = "minor", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "max_request", .unit = "", .doc = "bytes of payload it reads of one request", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, max_request), .in_text = true, .text_name = "max_request", .text_factor = 1.0, .in_table = true, .head = "max request", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "max_epochs", .unit = "", .doc = "epochs one POLL may ask for", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, max_epochs), .in_text = true, .text_name = "max_epochs", .text_factor = 1.0, .in_table = true, .head = "max epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "span", .unit = "", .doc = "first and last instant at which anything is served", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, span), .record = &record_span, .in_text = true, .text_name = "span", .text_factor = 1.0, .in_table = true, .head = "span", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "name", .unit = "", .doc = "name of the server", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, name), .limit = 64, .in_text = true, .text_name = "name", .text_factor = 1.0, .in_table = true, .head = "name", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "version", .unit = "", .doc = "its version", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, version), .limit = 32, .in_text = true, .text_name = "version", .text_factor = 1.0, .in_table = true, .head = "version", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "title", .unit = "", .doc = "title of the scenario", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, title), .limit = 128, .in_text = true, .text_name = "title", .text_factor = 1.0, .in_table = true, .head = "title", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "frame", .unit = "", .doc = "terrestrial frame of positions, e.g. IGS20", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, frame), .limit = 64, .in_text = true, .text_name = "frame", .text_factor = 1.0, .in_table = true, .head = "frame", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "leap", .unit = "", .doc = "leap second in force, and the next", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, leap), .record = &record_leap_seconds, .in_text = true, .text_name = "leap", .text_factor = 1.0, .in_table = true, .head = "leap", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "navdata_point", .unit = "", .doc = "the point of a satellite whose orbit NAVDATA describes; STATES gives the centre of mass", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_caps, navdata_point), .word = words_orbit_point, .n_words = sizeof words_orbit_point / sizeof words_orbit_point[0], .in_text = true, .text_name = "navdata_point", .text_factor = 1.0, .in_table = true, .head = "navdata point", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "receiver_source", .unit = "", .doc = "receiver that is used when a POLL_DELAYS names none", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_caps, receiver_source), .word = words_receiver_source, .n_words = sizeof words_receiver_source / sizeof words_receiver_source[0], .in_text = true, .text_name = "receiver_source", .text_factor = 1.0, .in_table = true, .head = "receiver source", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "receiver_unit", .unit = "", .doc = "with TRAJECTORY: the unit whose point it is", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, receiver_unit), .in_text = true, .text_name = "receiver_unit", .text_factor = 1.0, .in_table = true, .head = "receiver unit", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "receiver_m", .unit = "m", .doc = "where it is (ecef); NAN with NONE and TRAJECTORY", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "receiver_", .suffix = "_m", .offset = offsetof(orr_msg_caps, receiver_m), .in_text = true, .text_name = "receiver_m", .text_factor = 1.0, .in_table = true, .head = "receiver", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "imu_rate_hz", .unit = "Hz", .doc = "readings a second where POLL_IMU has step 0; NAN where POLL_IMU is not answered", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, imu_rate_hz), .in_text = true, .text_name = "imu_rate_hz", .text_factor = 1.0, .in_table = true, .head = "imu rate", .table_unit = "Hz", .table_factor = 1.0, .digits = -1},
    {.name = "units", .unit = "", .doc = "inertial units; none without a trajectory", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, units), .limit = 64, .record = &record_inertial_unit, .next = next_inertial_unit, .in_text = true, .text_name = "units", .text_factor = 1.0, .in_table = true, .head = "units", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "antennas", .unit = "", .doc = "antennas that receive; none where no signals are sent", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, antennas), .limit = 16, .record = &record_antenna, .next = next_antenna, .in_text = true, .text_name = "antennas", .text_factor = 1.0, .in_table = true, .head = "antennas", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "signals", .unit = "", .doc = "signals that are sent", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, signals), .limit = 64, .record = &record_signal, .next = next_signal, .in_text = true, .text_name = "signals", .text_factor = 1.0, .in_table = true, .head = "signals", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "transmitters", .unit = "", .doc = "satellites that send them", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, transmitters), .limit = 800, .record = &record_transmitter, .next = next_transmitter, .in_text = true, .text_name = "transmitters", .text_factor = 1.0, .in_table = true, .head = "transmitters", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "requests", .unit = "", .doc = "what is answered; anything else is refused with NOT_SERVED or UNKNOWN_TYPE", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, requests), .limit = 64, .record = &record_served_request, .next = next_served_request, .in_text = true, .text_name = "requests", .text_factor = 1.0, .in_table = true, .head = "requests", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "served satellites, in the order in which STATES lists them", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_caps, satellites), .limit = 800, .record = &record_sat_id, .next = next_sat_id, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "access", .unit = "", .doc = "what this client may not do, and how it came", .kind = ORR_FIELD_U16, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_caps, access), .word = words_access, .n_words = sizeof words_access / sizeof words_access[0], .in_text = true, .text_name = "access", .text_factor = 1.0, .in_table = true, .head = "access", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_caps = {"caps", fields_caps, 22, sizeof(orr_msg_caps), false, false};

static orr_wire_status encode_caps(const void *m, orr_wire_writer *w)
{
    return orr_msg_caps_encode((const orr_msg_caps *)m, w);
}
static orr_wire_status decode_caps(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_caps_decode(payload, size, (orr_msg_caps *)m);
}

static const orr_field fields_ping[] = {
    {.name = "token", .unit = "", .doc = "anything", .kind = ORR_FIELD_U64, .show = ORR_SHOW_HEX, .offset = offsetof(orr_msg_ping, token), .in_text = true, .text_name = "token", .text_factor = 1.0, .in_table = true, .head = "token", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_ping = {"ping", fields_ping, 1, sizeof(orr_msg_ping), false, false};

static orr_wire_status encode_ping(const void *m, orr_wire_writer *w)
{
    return orr_msg_ping_encode((const orr_msg_ping *)m, w);
}
static orr_wire_status decode_ping(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_ping_decode(payload, size, (orr_msg_ping *)m);
}

static const orr_field fields_pong[] = {
    {.name = "token", .unit = "", .doc = "that of the PING", .kind = ORR_FIELD_U64, .show = ORR_SHOW_HEX, .offset = offsetof(orr_msg_pong, token), .in_text = true, .text_name = "token", .text_factor = 1.0, .in_table = true, .head = "token", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_pong = {"pong", fields_pong, 1, sizeof(orr_msg_pong), false, false};

static orr_wire_status encode_pong(const void *m, orr_wire_writer *w)
{
    return orr_msg_pong_encode((const orr_msg_pong *)m, w);
}
static orr_wire_status decode_pong(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_pong_decode(payload, size, (orr_msg_pong *)m);
}

static const orr_field fields_error[] = {
    {.name = "code", .unit = "", .doc = "class of failure, for programs", .kind = ORR_FIELD_U16, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_error, code), .word = words_error_code, .n_words = sizeof words_error_code / sizeof words_error_code[0], .in_text = true, .text_name = "code", .text_factor = 1.0, .in_table = true, .head = "code", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "request", .unit = "", .doc = "message type of the refused request, 0 if none", .kind = ORR_FIELD_U16, .show = ORR_SHOW_MESSAGE, .offset = offsetof(orr_msg_error, request), .in_text = true, .text_name = "request", .text_factor = 1.0, .in_table = true, .head = "request", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "sentence", .unit = "", .doc = "what was wrong, for people", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_error, sentence), .limit = 512, .in_text = true, .text_name = "sentence", .text_factor = 1.0, .in_table = true, .head = "sentence", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_error = {"error", fields_error, 3, sizeof(orr_msg_error), false, false};

static orr_wire_status encode_error(const void *m, orr_wire_writer *w)
{
    return orr_msg_error_encode((const orr_msg_error *)m, w);
}
static orr_wire_status decode_error(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_error_decode(payload, size, (orr_msg_error *)m);
}

static const orr_field fields_poll[] = {
    {.name = "epochs", .unit = "", .doc = "when", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "which, in the order of the answer; empty for all", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll, satellites), .limit = 800, .record = &record_sat_id, .next = next_sat_id, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll = {"poll", fields_poll, 2, sizeof(orr_msg_poll), false, false};

static orr_wire_status encode_poll(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_encode((const orr_msg_poll *)m, w);
}
static orr_wire_status decode_poll(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_decode(payload, size, (orr_msg_poll *)m);
}

static bool next_sat_state(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_sat_state_next((const orr_msg_sat_state_list *)list, it, (orr_msg_sat_state *)out);
}

static const orr_field fields_states[] = {
    {.name = "epoch", .unit = "", .doc = "OK, or OUTSIDE_SPAN with no satellites", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_states, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "those asked for, in that order; for all, those of CAPS", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_states, satellites), .limit = 800, .record = &record_sat_state, .next = next_sat_state, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_states = {"states", fields_states, 2, sizeof(orr_msg_states), false, false};

static orr_wire_status encode_states(const void *m, orr_wire_writer *w)
{
    return orr_msg_states_encode((const orr_msg_states *)m, w);
}
static orr_wire_status decode_states(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_states_decode(payload, size, (orr_msg_states *)m);
}

static const orr_field fields_poll_elements[] = {
    {.name = "epochs", .unit = "", .doc = "when", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_elements, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "frame", .unit = "", .doc = "axes that the elements refer to", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_poll_elements, frame), .word = words_elements_frame, .n_words = sizeof words_elements_frame / sizeof words_elements_frame[0], .in_text = true, .text_name = "frame", .text_factor = 1.0, .in_table = true, .head = "frame", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "method", .unit = "", .doc = "how they are made", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_poll_elements, method), .word = words_elements_method, .n_words = sizeof words_elements_method / sizeof words_elements_method[0], .in_text = true, .text_name = "method", .text_factor = 1.0, .in_table = true, .head = "method", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "which, in the order of the answer; empty for all", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_elements, satellites), .limit = 800, .record = &record_sat_id, .next = next_sat_id, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_elements = {"poll_elements", fields_poll_elements, 4, sizeof(orr_msg_poll_elements), false, false};

static orr_wire_status encode_poll_elements(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_elements_encode((const orr_msg_poll_elements *)m, w);
}
static orr_wire_status decode_poll_elements(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_elements_decode(payload, size, (orr_msg_poll_elements *)m);
}

static bool next_sat_elements(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_sat_elements_next((const orr_msg_sat_elements_list *)list, it, (orr_msg_sat_elements *)out);
}

static const orr_field fields_elements[] = {
    {.name = "epoch", .unit = "", .doc = "OK, or OUTSIDE_SPAN with no satellites", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_elements, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "frame", .unit = "", .doc = "as asked", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_elements, frame), .word = words_elements_frame, .n_words = sizeof words_elements_frame / sizeof words_elements_frame[0], .in_text = true, .text_name = "frame", .text_factor = 1.0, .in_table = true, .head = "frame", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "method", .unit = "", .doc = "as asked", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_elements, method), .word = words_elements_method, .n_words = sizeof words_elements_method / sizeof words_elements_method[0], .in_text = true, .text_name = "method", .text_factor = 1.0, .in_table = true, .head = "method", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "those asked for, in that order; for all, those of CAPS", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_elements, satellites), .limit = 800, .record = &record_sat_elements, .next = next_sat_elements, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_elements = {"elements", fields_elements, 4, sizeof(orr_msg_elements), false, false};

static orr_wire_status encode_elements(const void *m, orr_wire_writer *w)
{
    return orr_msg_elements_encode((const orr_msg_elements *)m, w);
}
static orr_wire_status decode_elements(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_elements_decode(payload, size, (orr_msg_elements *)m);
}

static const orr_field fields_poll_navdata[] = {
    {.name = "epochs", .unit = "", .doc = "when", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_navdata, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "which, in the order of the answer; empty for all", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_navdata, satellites), .limit = 800, .record = &record_sat_id, .next = next_sat_id, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "kinds", .unit = "", .doc = "which messages; 0: of each satellite its first, LNAV, FDMA, INAV on E1, D1 or D2", .kind = ORR_FIELD_U32, .show = ORR_SHOW_BITS, .offset = offsetof(orr_msg_poll_navdata, kinds), .word = words_nav_messages, .n_words = sizeof words_nav_messages / sizeof words_nav_messages[0], .in_text = true, .text_name = "kinds", .text_factor = 1.0, .in_table = true, .head = "kinds", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "form", .unit = "", .doc = "pages as bits or as symbols", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_poll_navdata, form), .word = words_nav_form, .n_words = sizeof words_nav_form / sizeof words_nav_form[0], .in_text = true, .text_name = "form", .text_factor = 1.0, .in_table = true, .head = "form", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_navdata = {"poll_navdata", fields_poll_navdata, 4, sizeof(orr_msg_poll_navdata), false, false};

static orr_wire_status encode_poll_navdata(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_navdata_encode((const orr_msg_poll_navdata *)m, w);
}
static orr_wire_status decode_poll_navdata(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_navdata_decode(payload, size, (orr_msg_poll_navdata *)m);
}

static bool next_sat_navdata(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_sat_navdata_next((const orr_msg_sat_navdata_list *)list, it, (orr_msg_sat_navdata *)out);
}

static const orr_field fields_navdata[] = {
    {.name = "epoch", .unit = "", .doc = "OK, or OUTSIDE_SPAN with no satellites", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_navdata, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "those asked for, in that order, each with its messages; for all, those of CAPS", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_navdata, satellites), .limit = 800, .record = &record_sat_navdata, .next = next_sat_navdata, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_navdata = {"navdata", fields_navdata, 2, sizeof(orr_msg_navdata), false, false};

static orr_wire_status encode_navdata(const void *m, orr_wire_writer *w)
{
    return orr_msg_navdata_encode((const orr_msg_navdata *)m, w);
}
static orr_wire_status decode_navdata(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_navdata_decode(payload, size, (orr_msg_navdata *)m);
}

static bool next_f64(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_f64_next((const orr_msg_f64_list *)list, it, (double *)out);
}

static const orr_field fields_poll_delays[] = {
    {.name = "epochs", .unit = "", .doc = "when", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_delays, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "receiver_m", .unit = "m", .doc = "receiver (ecef); three times NAN for the scenario's own, which may move from epoch to epoch", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "receiver_", .suffix = "_m", .offset = offsetof(orr_msg_poll_delays, receiver_m), .in_text = true, .text_name = "receiver_m", .text_factor = 1.0, .in_table = true, .head = "receiver", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "carriers_hz", .unit = "Hz", .doc = "carriers to give delays for; empty for 1575.42 MHz", .kind = ORR_FIELD_LIST, .element = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_delays, carriers_hz), .limit = 4, .next = next_f64, .in_text = true, .text_name = "carriers_hz", .text_factor = 1.0, .in_table = true, .head = "carriers", .table_unit = "Hz", .table_factor = 1.0, .digits = -1},
    {.name = "satellites", .unit = "", .doc = "which, in the order of the answer; empty for all", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_delays, satellites), .limit = 800, .record = &record_sat_id, .next = next_sat_id, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_delays = {"poll_delays", fields_poll_delays, 4, sizeof(orr_msg_poll_delays), false, false};

static orr_wire_status encode_poll_delays(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_delays_encode((const orr_msg_poll_delays *)m, w);
}
static orr_wire_status decode_poll_delays(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_delays_decode(payload, size, (orr_msg_poll_delays *)m);
}

static bool next_sat_delay(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_sat_delay_next((const orr_msg_sat_delay_list *)list, it, (orr_msg_sat_delay *)out);
}

static const orr_field fields_delays[] = {
    {.name = "epoch", .unit = "", .doc = "OK, or OUTSIDE_SPAN of orbits, ionosphere or trajectory, with no satellites", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_delays, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "receiver_m", .unit = "m", .doc = "the receiver that was taken (ecef); NAN outside the span of the scenario's trajectory", .kind = ORR_FIELD_F64, .show = ORR_SHOW_PLACE, .length = 3, .stem = "receiver_", .suffix = "_m", .offset = offsetof(orr_msg_delays, receiver_m), .in_text = true, .text_name = "receiver_m", .text_factor = 1.0, .in_table = true, .head = "receiver", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "carriers_hz", .unit = "Hz", .doc = "the carriers of delay_m", .kind = ORR_FIELD_LIST, .element = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_delays, carriers_hz), .limit = 4, .next = next_f64, .in_text = true, .text_name = "carriers_hz", .text_factor = 1.0, .in_table = true, .head = "carriers", .table_unit = "MHz", .table_factor = 1e-06, .digits = 2},
    {.name = "satellites", .unit = "", .doc = "those asked for, in that order; for all, those of CAPS", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_delays, satellites), .limit = 800, .record = &record_sat_delay, .next = next_sat_delay, .in_text = true, .text_name = "satellites", .text_factor = 1.0, .in_table = true, .head = "satellites", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_delays = {"delays", fields_delays, 4, sizeof(orr_msg_delays), false, false};

static orr_wire_status encode_delays(const void *m, orr_wire_writer *w)
{
    return orr_msg_delays_encode((const orr_msg_delays *)m, w);
}
static orr_wire_status decode_delays(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_delays_decode(payload, size, (orr_msg_delays *)m);
}

static bool next_u16(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_u16_next((const orr_msg_u16_list *)list, it, (uint16_t *)out);
}

static const orr_field fields_poll_channels[] = {
    {.name = "epochs", .unit = "", .doc = "when", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_channels, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "antenna", .unit = "", .doc = "which antenna of CAPS", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_channels, antenna), .in_text = true, .text_name = "antenna", .text_factor = 1.0, .in_table = true, .head = "antenna", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "terms", .unit = "", .doc = "1: with what each code is the sum of; 0: without", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_channels, terms), .in_text = true, .text_name = "terms", .text_factor = 1.0, .in_table = true, .head = "terms", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "signals", .unit = "", .doc = "which signals of CAPS; empty for all", .kind = ORR_FIELD_LIST, .element = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_channels, signals), .limit = 64, .next = next_u16, .in_text = true, .text_name = "signals", .text_factor = 1.0, .in_table = true, .head = "signals", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_channels = {"poll_channels", fields_poll_channels, 4, sizeof(orr_msg_poll_channels), false, false};

static orr_wire_status encode_poll_channels(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_channels_encode((const orr_msg_poll_channels *)m, w);
}
static orr_wire_status decode_poll_channels(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_channels_decode(payload, size, (orr_msg_poll_channels *)m);
}

static bool next_sat_channel(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_sat_channel_next((const orr_msg_sat_channel_list *)list, it, (orr_msg_sat_channel *)out);
}

static bool next_channel_terms(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_channel_terms_next((const orr_msg_channel_terms_list *)list, it, (orr_msg_channel_terms *)out);
}

static bool next_jammer(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_jammer_next((const orr_msg_jammer_list *)list, it, (orr_msg_jammer *)out);
}

static const orr_field fields_channels[] = {
    {.name = "epoch", .unit = "", .doc = "OK, or OUTSIDE_SPAN with no channels", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "antenna", .unit = "", .doc = "the antenna asked for", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, antenna), .in_text = true, .text_name = "antenna", .text_factor = 1.0, .in_table = true, .head = "antenna", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "block", .unit = "ns", .doc = "begin of the block, a multiple of its length; -2^63 unless OK", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_channels, block), .in_text = true, .text_name = "block", .text_factor = 1.0, .in_table = true, .head = "block", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "length", .unit = "ns", .doc = "its length, at least 1 ms and at most 1 s", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, length), .in_text = true, .text_name = "length", .text_factor = 1.0, .in_table = true, .head = "length", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "error_m", .unit = "m", .doc = "greatest error of cubics against the antenna's motion that was found in these 10 s; above channel.error_m where even 1 ms does not hold it", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, error_m), .in_text = true, .text_name = "error_m", .text_factor = 1.0, .in_table = false, .head = "error", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "pos_m", .unit = "m", .doc = "antenna reference point at the block's begin (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_PLACE, .length = 3, .stem = "pos_", .suffix = "_m", .offset = offsetof(orr_msg_channels, pos_m), .in_text = true, .text_name = "pos_m", .text_factor = 1.0, .in_table = true, .head = "pos", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "vel_mps", .unit = "m/s", .doc = "its velocity (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "vel_", .suffix = "_mps", .offset = offsetof(orr_msg_channels, vel_mps), .in_text = true, .text_name = "vel_mps", .text_factor = 1.0, .in_table = false, .head = "vel", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "motion", .unit = "", .doc = "where this motion comes from", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_channels, motion), .word = words_motion_state, .n_words = sizeof words_motion_state / sizeof words_motion_state[0], .in_text = true, .text_name = "motion", .text_factor = 1.0, .in_table = true, .head = "motion", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "motion_age", .unit = "ns", .doc = "live: the block's begin less the tag of the sample that it rests on; 0 otherwise", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, motion_age), .in_text = true, .text_name = "motion_age", .text_factor = 1.0, .in_table = false, .head = "motion age", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "channels", .unit = "", .doc = "those that the antenna sees at the block's begin, by satellite, signal and echo; behind them the false ones", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, channels), .limit = 4096, .record = &record_sat_channel, .next = next_sat_channel, .in_text = true, .text_name = "channels", .text_factor = 1.0, .in_table = true, .head = "channels", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "terms", .unit = "", .doc = "of each channel, in the same order; empty unless asked for", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, terms), .limit = 4096, .record = &record_channel_terms, .next = next_channel_terms, .in_text = true, .text_name = "terms", .text_factor = 1.0, .in_table = false, .head = "terms", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "jammers", .unit = "", .doc = "those that send then", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_channels, jammers), .limit = 16, .record = &record_jammer, .next = next_jammer, .in_text = true, .text_name = "jammers", .text_factor = 1.0, .in_table = false, .head = "jammers", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_channels = {"channels", fields_channels, 12, sizeof(orr_msg_channels), false, false};

static orr_wire_status encode_channels(const void *m, orr_wire_writer *w)
{
    return orr_msg_channels_encode((const orr_msg_channels *)m, w);
}
static orr_wire_status decode_channels(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_channels_decode(payload, size, (orr_msg_channels *)m);
}

static const orr_field fields_poll_imu[] = {
    {.name = "epochs", .unit = "", .doc = "begins of the intervals, which are step long (0 to 1 h; 0: that of CAPS imu_rate_hz)", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_imu, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "unit", .unit = "", .doc = "which inertial unit of the scenario; 0 is the trajectory's own point", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_imu, unit), .in_text = true, .text_name = "unit", .text_factor = 1.0, .in_table = true, .head = "unit", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_imu = {"poll_imu", fields_poll_imu, 2, sizeof(orr_msg_poll_imu), false, false};

static orr_wire_status encode_poll_imu(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_imu_encode((const orr_msg_poll_imu *)m, w);
}
static orr_wire_status decode_poll_imu(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_imu_decode(payload, size, (orr_msg_poll_imu *)m);
}

static const orr_field fields_imu[] = {
    {.name = "epoch", .unit = "", .doc = "begin of the interval; OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_imu, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "t1", .unit = "ns", .doc = "end of the interval", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_imu, t1), .in_text = true, .text_name = "t1", .text_factor = 1.0, .in_table = true, .head = "t1", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "unit", .unit = "", .doc = "the unit asked for", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_imu, unit), .in_text = true, .text_name = "unit", .text_factor = 1.0, .in_table = true, .head = "unit", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "readings", .unit = "", .doc = "of perfect sensors, or of those with the scenario's errors", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_imu, readings), .word = words_readings, .n_words = sizeof words_readings / sizeof words_readings[0], .in_text = true, .text_name = "readings", .text_factor = 1.0, .in_table = true, .head = "readings", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "dtheta_rad", .unit = "rad", .doc = "integral of the absolute angular rate", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "dtheta_", .suffix = "_rad", .offset = offsetof(orr_msg_imu, dtheta_rad), .in_text = true, .text_name = "dtheta_rad", .text_factor = 1.0, .in_table = true, .head = "dtheta", .table_unit = "rad", .table_factor = 1.0, .digits = 12},
    {.name = "dv_mps", .unit = "m/s", .doc = "integral of the specific force; at rest +g upward", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "dv_", .suffix = "_mps", .offset = offsetof(orr_msg_imu, dv_mps), .in_text = true, .text_name = "dv_mps", .text_factor = 1.0, .in_table = true, .head = "dv", .table_unit = "m/s", .table_factor = 1.0, .digits = 9},
};
static const orr_record record_imu = {"imu", fields_imu, 6, sizeof(orr_msg_imu), false, false};

static orr_wire_status encode_imu(const void *m, orr_wire_writer *w)
{
    return orr_msg_imu_encode((const orr_msg_imu *)m, w);
}
static orr_wire_status decode_imu(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_imu_decode(payload, size, (orr_msg_imu *)m);
}

static const orr_field fields_poll_truth[] = {
    {.name = "epochs", .unit = "", .doc = "when", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_truth, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "unit", .unit = "", .doc = "which inertial unit of the scenario; 0 is the trajectory's own point", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_truth, unit), .in_text = true, .text_name = "unit", .text_factor = 1.0, .in_table = true, .head = "unit", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_truth = {"poll_truth", fields_poll_truth, 2, sizeof(orr_msg_poll_truth), false, false};

static orr_wire_status encode_poll_truth(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_truth_encode((const orr_msg_poll_truth *)m, w);
}
static orr_wire_status decode_poll_truth(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_truth_decode(payload, size, (orr_msg_poll_truth *)m);
}

static const orr_field fields_truth[] = {
    {.name = "epoch", .unit = "", .doc = "OK, or OUTSIDE_SPAN of the trajectory; numbers are then NAN", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "unit", .unit = "", .doc = "the unit asked for", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, unit), .in_text = true, .text_name = "unit", .text_factor = 1.0, .in_table = true, .head = "unit", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "pos_m", .unit = "m", .doc = "position (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "pos_", .suffix = "_m", .offset = offsetof(orr_msg_truth, pos_m), .in_text = true, .text_name = "pos_m", .text_factor = 1.0, .in_table = true, .head = "pos", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "vel_mps", .unit = "m/s", .doc = "velocity relative to the Earth (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "vel_", .suffix = "_mps", .offset = offsetof(orr_msg_truth, vel_mps), .in_text = true, .text_name = "vel_mps", .text_factor = 1.0, .in_table = true, .head = "vel", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "acc_mps2", .unit = "m/s2", .doc = "second derivative of the position (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "acc_", .suffix = "_mps2", .offset = offsetof(orr_msg_truth, acc_mps2), .in_text = true, .text_name = "acc_mps2", .text_factor = 1.0, .in_table = true, .head = "acc", .table_unit = "m/s2", .table_factor = 1.0, .digits = 6},
    {.name = "attitude", .unit = "", .doc = "quaternion w x y z of body from ecef: v_body = conj(q) v_ecef q", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 4, .stem = "attitude_", .suffix = "", .offset = offsetof(orr_msg_truth, attitude), .in_text = true, .text_name = "attitude", .text_factor = 1.0, .in_table = true, .head = "attitude", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "heading_rad", .unit = "rad", .doc = "clockwise from true North, 0 to 2 pi", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, heading_rad), .in_text = true, .text_name = "heading_rad", .text_factor = 1.0, .in_table = true, .head = "heading", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 5},
    {.name = "pitch_rad", .unit = "rad", .doc = "nose up", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, pitch_rad), .in_text = true, .text_name = "pitch_rad", .text_factor = 1.0, .in_table = true, .head = "pitch", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 5},
    {.name = "roll_rad", .unit = "rad", .doc = "right wing down", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, roll_rad), .in_text = true, .text_name = "roll_rad", .text_factor = 1.0, .in_table = true, .head = "roll", .table_unit = "deg", .table_factor = 57.29577951308232, .digits = 5},
    {.name = "rate_radps", .unit = "rad/s", .doc = "absolute angular rate, body axes", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "rate_", .suffix = "_radps", .offset = offsetof(orr_msg_truth, rate_radps), .in_text = true, .text_name = "rate_radps", .text_factor = 1.0, .in_table = true, .head = "rate", .table_unit = "rad/s", .table_factor = 1.0, .digits = -1},
    {.name = "force_mps2", .unit = "m/s2", .doc = "specific force, body axes", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "force_", .suffix = "_mps2", .offset = offsetof(orr_msg_truth, force_mps2), .in_text = true, .text_name = "force_mps2", .text_factor = 1.0, .in_table = true, .head = "force", .table_unit = "m/s2", .table_factor = 1.0, .digits = 6},
    {.name = "disturbance_mgal", .unit = "mGal", .doc = "gravity disturbance, stronger gravity positive", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, disturbance_mgal), .in_text = true, .text_name = "disturbance_mgal", .text_factor = 1.0, .in_table = true, .head = "disturbance", .table_unit = "mGal", .table_factor = 1.0, .digits = 3},
    {.name = "eotvos_mgal", .unit = "mGal", .doc = "Eotvoes term: what the motion takes off the weight", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, eotvos_mgal), .in_text = true, .text_name = "eotvos_mgal", .text_factor = 1.0, .in_table = true, .head = "eotvos", .table_unit = "mGal", .table_factor = 1.0, .digits = 3},
    {.name = "vertical_mps2", .unit = "m/s2", .doc = "rate of the vertical velocity over the ellipsoid", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_truth, vertical_mps2), .in_text = true, .text_name = "vertical_mps2", .text_factor = 1.0, .in_table = true, .head = "vertical", .table_unit = "m/s2", .table_factor = 1.0, .digits = 6},
};
static const orr_record record_truth = {"truth", fields_truth, 14, sizeof(orr_msg_truth), false, false};

static orr_wire_status encode_truth(const void *m, orr_wire_writer *w)
{
    return orr_msg_truth_encode((const orr_msg_truth *)m, w);
}
static orr_wire_status decode_truth(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_truth_decode(payload, size, (orr_msg_truth *)m);
}

static const orr_field fields_subscribe[] = {
    {.name = "request", .unit = "", .doc = "POLL, POLL_NAVDATA, POLL_CHANNELS, POLL_IMU, POLL_TRUTH, POLL_EVENTS or GET_MODES", .kind = ORR_FIELD_U16, .show = ORR_SHOW_MESSAGE, .offset = offsetof(orr_msg_subscribe, request), .in_text = true, .text_name = "request", .text_factor = 1.0, .in_table = true, .head = "request", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "pacing", .unit = "", .doc = "when blocks are made", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_subscribe, pacing), .word = words_pacing, .n_words = sizeof words_pacing / sizeof words_pacing[0], .in_text = true, .text_name = "pacing", .text_factor = 1.0, .in_table = true, .head = "pacing", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "delivery", .unit = "", .doc = "how they come", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_subscribe, delivery), .word = words_delivery, .n_words = sizeof words_delivery / sizeof words_delivery[0], .in_text = true, .text_name = "delivery", .text_factor = 1.0, .in_table = true, .head = "delivery", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "credit", .unit = "", .doc = "how many blocks may be sent before there is more credit (CREDIT)", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_subscribe, credit), .in_text = true, .text_name = "credit", .text_factor = 1.0, .in_table = true, .head = "credit", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "lead", .unit = "ns", .doc = "with CLOCK and MOTION: how long before its instant a block is made, 0 to 60 s", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_subscribe, lead), .in_text = true, .text_name = "lead", .text_factor = 1.0, .in_table = true, .head = "lead", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "poll", .unit = "", .doc = "payload of that request. t: the first instant, -2^63 for the next one; step: from block to block, 1 ms to 60 s (POLL_IMU: 1 s), of POLL_CHANNELS also 0: every block once, of POLL_NAVDATA 0: every frame once; count: how many, 0 for no end. GET_MODES has none of these: its blocks come when modes change", .kind = ORR_FIELD_BYTES, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_subscribe, poll), .limit = 16384, .in_text = true, .text_name = "poll", .text_factor = 1.0, .in_table = true, .head = "poll", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "port", .unit = "", .doc = "with DATAGRAMS: the UDP port, of the address that the connection comes from", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_subscribe, port), .in_text = true, .text_name = "port", .text_factor = 1.0, .in_table = true, .head = "port", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_subscribe = {"subscribe", fields_subscribe, 7, sizeof(orr_msg_subscribe), false, false};

static orr_wire_status encode_subscribe(const void *m, orr_wire_writer *w)
{
    return orr_msg_subscribe_encode((const orr_msg_subscribe *)m, w);
}
static orr_wire_status decode_subscribe(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_subscribe_decode(payload, size, (orr_msg_subscribe *)m);
}

static const orr_field fields_subscribed[] = {
    {.name = "first", .unit = "ns", .doc = "instant of its first block", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_subscribed, first), .in_text = true, .text_name = "first", .text_factor = 1.0, .in_table = true, .head = "first", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "step", .unit = "ns", .doc = "from block to block; 0: as long as they or their frames are", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_subscribed, step), .in_text = true, .text_name = "step", .text_factor = 1.0, .in_table = true, .head = "step", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "channel", .unit = "", .doc = "with DATAGRAMS: the channel that its datagrams name; 0 otherwise", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_subscribed, channel), .in_text = true, .text_name = "channel", .text_factor = 1.0, .in_table = true, .head = "channel", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_subscribed = {"subscribed", fields_subscribed, 3, sizeof(orr_msg_subscribed), false, false};

static orr_wire_status encode_subscribed(const void *m, orr_wire_writer *w)
{
    return orr_msg_subscribed_encode((const orr_msg_subscribed *)m, w);
}
static orr_wire_status decode_subscribed(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_subscribed_decode(payload, size, (orr_msg_subscribed *)m);
}

static const orr_field fields_unsubscribe[] = {
    {.name = "stream", .unit = "", .doc = "sequence number of its SUBSCRIBE", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_unsubscribe, stream), .in_text = true, .text_name = "stream", .text_factor = 1.0, .in_table = true, .head = "stream", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_unsubscribe = {"unsubscribe", fields_unsubscribe, 1, sizeof(orr_msg_unsubscribe), false, false};

static orr_wire_status encode_unsubscribe(const void *m, orr_wire_writer *w)
{
    return orr_msg_unsubscribe_encode((const orr_msg_unsubscribe *)m, w);
}
static orr_wire_status decode_unsubscribe(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_unsubscribe_decode(payload, size, (orr_msg_unsubscribe *)m);
}

static const orr_field fields_credit[] = {
    {.name = "stream", .unit = "", .doc = "sequence number of its SUBSCRIBE", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_credit, stream), .in_text = true, .text_name = "stream", .text_factor = 1.0, .in_table = true, .head = "stream", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "blocks", .unit = "", .doc = "how many more", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_credit, blocks), .in_text = true, .text_name = "blocks", .text_factor = 1.0, .in_table = true, .head = "blocks", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_credit = {"credit", fields_credit, 2, sizeof(orr_msg_credit), false, false};

static orr_wire_status encode_credit(const void *m, orr_wire_writer *w)
{
    return orr_msg_credit_encode((const orr_msg_credit *)m, w);
}
static orr_wire_status decode_credit(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_credit_decode(payload, size, (orr_msg_credit *)m);
}

static const orr_field fields_gap[] = {
    {.name = "first", .unit = "ns", .doc = "instant of the first that was left out", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_gap, first), .in_text = true, .text_name = "first", .text_factor = 1.0, .in_table = true, .head = "first", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "last", .unit = "ns", .doc = "instant of the last", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_gap, last), .in_text = true, .text_name = "last", .text_factor = 1.0, .in_table = true, .head = "last", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "blocks", .unit = "", .doc = "how many; of channels by their blocks 0, for their lengths were not looked at", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_gap, blocks), .in_text = true, .text_name = "blocks", .text_factor = 1.0, .in_table = true, .head = "blocks", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reason", .unit = "", .doc = "why", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_gap, reason), .word = words_gap_reason, .n_words = sizeof words_gap_reason / sizeof words_gap_reason[0], .in_text = true, .text_name = "reason", .text_factor = 1.0, .in_table = true, .head = "reason", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_gap = {"gap", fields_gap, 4, sizeof(orr_msg_gap), false, false};

static orr_wire_status encode_gap(const void *m, orr_wire_writer *w)
{
    return orr_msg_gap_encode((const orr_msg_gap *)m, w);
}
static orr_wire_status decode_gap(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_gap_decode(payload, size, (orr_msg_gap *)m);
}

static const orr_field fields_stream_end[] = {
    {.name = "next", .unit = "ns", .doc = "instant of the block that would have come next: where another SUBSCRIBE goes on", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_stream_end, next), .in_text = true, .text_name = "next", .text_factor = 1.0, .in_table = true, .head = "next", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "reason", .unit = "", .doc = "why", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_stream_end, reason), .word = words_end_reason, .n_words = sizeof words_end_reason / sizeof words_end_reason[0], .in_text = true, .text_name = "reason", .text_factor = 1.0, .in_table = true, .head = "reason", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "sentence", .unit = "", .doc = "the same, for people", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_stream_end, sentence), .limit = 200, .in_text = true, .text_name = "sentence", .text_factor = 1.0, .in_table = true, .head = "sentence", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_stream_end = {"stream_end", fields_stream_end, 3, sizeof(orr_msg_stream_end), false, false};

static orr_wire_status encode_stream_end(const void *m, orr_wire_writer *w)
{
    return orr_msg_stream_end_encode((const orr_msg_stream_end *)m, w);
}
static orr_wire_status decode_stream_end(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_stream_end_decode(payload, size, (orr_msg_stream_end *)m);
}

static const orr_field fields_control[] = {
    {.name = "action", .unit = "", .doc = "what to do", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_control, action), .word = words_control_action, .n_words = sizeof words_control_action / sizeof words_control_action[0], .in_text = true, .text_name = "action", .text_factor = 1.0, .in_table = true, .head = "action", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reference", .unit = "", .doc = "with ARM, and with START of one that was not armed: what paces it", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_control, reference), .word = words_clock_reference, .n_words = sizeof words_clock_reference / sizeof words_clock_reference[0], .in_text = true, .text_name = "reference", .text_factor = 1.0, .in_table = true, .head = "reference", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_control, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "t", .unit = "ns", .doc = "instant of the scenario; -2^63: where it stands", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_control, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "at", .unit = "ns", .doc = "with START: the wall's instant (GPS scale) at which it goes; -2^63: at once", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_control, at), .in_text = true, .text_name = "at", .text_factor = 1.0, .in_table = true, .head = "at", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "delay", .unit = "ns", .doc = "with START: so much later, 0 to an hour", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_control, delay), .in_text = true, .text_name = "delay", .text_factor = 1.0, .in_table = true, .head = "delay", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "scenario", .unit = "", .doc = "with LOAD: name of another scenario of the server's folder (serve --scenarios), without its ending; empty: this one", .kind = ORR_FIELD_STRING, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_control, scenario), .limit = 64, .in_text = true, .text_name = "scenario", .text_factor = 1.0, .in_table = true, .head = "scenario", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_control = {"control", fields_control, 7, sizeof(orr_msg_control), false, false};

static orr_wire_status encode_control(const void *m, orr_wire_writer *w)
{
    return orr_msg_control_encode((const orr_msg_control *)m, w);
}
static orr_wire_status decode_control(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_control_decode(payload, size, (orr_msg_control *)m);
}

static const orr_field fields_get_time[] = {
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_get_time, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_get_time = {"get_time", fields_get_time, 1, sizeof(orr_msg_get_time), false, false};

static orr_wire_status encode_get_time(const void *m, orr_wire_writer *w)
{
    return orr_msg_get_time_encode((const orr_msg_get_time *)m, w);
}
static orr_wire_status decode_get_time(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_get_time_decode(payload, size, (orr_msg_get_time *)m);
}

static const orr_field fields_time[] = {
    {.name = "t", .unit = "ns", .doc = "the scenario's instant; before a start that is fixed it counts down", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_time, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "state", .unit = "", .doc = "whether it runs", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_time, state), .word = words_clock_state, .n_words = sizeof words_clock_state / sizeof words_clock_state[0], .in_text = true, .text_name = "state", .text_factor = 1.0, .in_table = true, .head = "state", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reference", .unit = "", .doc = "what paces it", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_time, reference), .word = words_clock_reference, .n_words = sizeof words_clock_reference / sizeof words_clock_reference[0], .in_text = true, .text_name = "reference", .text_factor = 1.0, .in_table = true, .head = "reference", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "week", .unit = "", .doc = "GPS week, unwrapped", .kind = ORR_FIELD_I32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, week), .in_text = true, .text_name = "week", .text_factor = 1.0, .in_table = true, .head = "week", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "tow", .unit = "ns", .doc = "time of that week", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, tow), .in_text = true, .text_name = "tow", .text_factor = 1.0, .in_table = true, .head = "tow", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "leap", .unit = "", .doc = "leap seconds in force, and the next change", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, leap), .record = &record_leap_seconds, .in_text = true, .text_name = "leap", .text_factor = 1.0, .in_table = true, .head = "leap", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "utc_mjd", .unit = "d", .doc = "modified Julian day of UTC", .kind = ORR_FIELD_I32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, utc_mjd), .in_text = true, .text_name = "utc_mjd", .text_factor = 1.0, .in_table = true, .head = "utc mjd", .table_unit = "d", .table_factor = 1.0, .digits = -1},
    {.name = "n4", .unit = "", .doc = "GLONASS: four-year interval of the day in Moscow; 0 where it has no number", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, n4), .in_text = true, .text_name = "n4", .text_factor = 1.0, .in_table = true, .head = "n4", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "nt", .unit = "", .doc = "and the day in it", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, nt), .in_text = true, .text_name = "nt", .text_factor = 1.0, .in_table = true, .head = "nt", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "utc_su", .unit = "ns", .doc = "time of the day in Moscow, UTC(SU) + 3 h", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, utc_su), .in_text = true, .text_name = "utc_su", .text_factor = 1.0, .in_table = true, .head = "utc su", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "pps0", .unit = "ns", .doc = "the scenario's instant at PPS0; -2^63: none was fixed", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_time, pps0), .in_text = true, .text_name = "pps0", .text_factor = 1.0, .in_table = true, .head = "pps0", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "host", .unit = "ns", .doc = "the server's CLOCK_MONOTONIC at this moment", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, host), .in_text = true, .text_name = "host", .text_factor = 1.0, .in_table = true, .head = "host", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "wall", .unit = "ns", .doc = "the wall's instant at this moment", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_time, wall), .in_text = true, .text_name = "wall", .text_factor = 1.0, .in_table = true, .head = "wall", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "error_ns", .unit = "ns", .doc = "last RADIO_TIME against what the loop expected", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, error_ns), .in_text = true, .text_name = "error_ns", .text_factor = 1.0, .in_table = true, .head = "error ns", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "rate", .unit = "", .doc = "generator seconds a second of the host, less 1", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, rate), .in_text = true, .text_name = "rate", .text_factor = 1.0, .in_table = true, .head = "rate", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "wander_ns", .unit = "ns", .doc = "root mean square of those errors, of late", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, wander_ns), .in_text = true, .text_name = "wander_ns", .text_factor = 1.0, .in_table = true, .head = "wander ns", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "samples", .unit = "", .doc = "RADIO_TIMEs since the loop took up its lock", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, samples), .in_text = true, .text_name = "samples", .text_factor = 1.0, .in_table = true, .head = "samples", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "steps", .unit = "", .doc = "how often the generator's time stepped, so that the lock was taken up anew", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, steps), .in_text = true, .text_name = "steps", .text_factor = 1.0, .in_table = true, .head = "steps", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "suspends", .unit = "", .doc = "how often the host was suspended", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, suspends), .in_text = true, .text_name = "suspends", .text_factor = 1.0, .in_table = true, .head = "suspends", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "sets", .unit = "", .doc = "how often the host's wall clock was set", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_time, sets), .in_text = true, .text_name = "sets", .text_factor = 1.0, .in_table = true, .head = "sets", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_time = {"time", fields_time, 20, sizeof(orr_msg_time), false, false};

static orr_wire_status encode_time(const void *m, orr_wire_writer *w)
{
    return orr_msg_time_encode((const orr_msg_time *)m, w);
}
static orr_wire_status decode_time(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_time_decode(payload, size, (orr_msg_time *)m);
}

static const orr_field fields_radio_time[] = {
    {.name = "elapsed", .unit = "ns", .doc = "its time since its own begin, whose whole seconds are its 1PPS", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_radio_time, elapsed), .in_text = true, .text_name = "elapsed", .text_factor = 1.0, .in_table = true, .head = "elapsed", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "stamp", .unit = "ns", .doc = "what a clock of the server's host showed then", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_radio_time, stamp), .in_text = true, .text_name = "stamp", .text_factor = 1.0, .in_table = true, .head = "stamp", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "clock", .unit = "", .doc = "which clock", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_radio_time, clock), .word = words_stamp_clock, .n_words = sizeof words_stamp_clock / sizeof words_stamp_clock[0], .in_text = true, .text_name = "clock", .text_factor = 1.0, .in_table = true, .head = "clock", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_radio_time = {"radio_time", fields_radio_time, 3, sizeof(orr_msg_radio_time), false, false};

static orr_wire_status encode_radio_time(const void *m, orr_wire_writer *w)
{
    return orr_msg_radio_time_encode((const orr_msg_radio_time *)m, w);
}
static orr_wire_status decode_radio_time(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_radio_time_decode(payload, size, (orr_msg_radio_time *)m);
}

static const orr_field fields_pace[] = {
    {.name = "t", .unit = "ns", .doc = "the scenario's instant now", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_pace, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "error_ns", .unit = "ns", .doc = "this RADIO_TIME against what the loop expected", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_pace, error_ns), .in_text = true, .text_name = "error_ns", .text_factor = 1.0, .in_table = true, .head = "error ns", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "rate", .unit = "", .doc = "generator seconds a second of the host, less 1", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_pace, rate), .in_text = true, .text_name = "rate", .text_factor = 1.0, .in_table = true, .head = "rate", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "wander_ns", .unit = "ns", .doc = "root mean square of the errors, of late", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_pace, wander_ns), .in_text = true, .text_name = "wander_ns", .text_factor = 1.0, .in_table = true, .head = "wander ns", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "made", .unit = "ns", .doc = "instant of the block that was made last for this connection; -2^63: none", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_pace, made), .in_text = true, .text_name = "made", .text_factor = 1.0, .in_table = true, .head = "made", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "until_air", .unit = "ns", .doc = "how long from now until it is on air; -2^63: the clock does not run, or there is none", .kind = ORR_FIELD_I64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_pace, until_air), .in_text = true, .text_name = "until_air", .text_factor = 1.0, .in_table = true, .head = "until air", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_pace = {"pace", fields_pace, 6, sizeof(orr_msg_pace), false, false};

static orr_wire_status encode_pace(const void *m, orr_wire_writer *w)
{
    return orr_msg_pace_encode((const orr_msg_pace *)m, w);
}
static orr_wire_status decode_pace(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_pace_decode(payload, size, (orr_msg_pace *)m);
}

static const orr_field fields_motion[] = {
    {.name = "t", .unit = "ns", .doc = "tag: instant of the scenario at which it holds; later than that of the sample before", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_motion, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "order", .unit = "", .doc = "highest derivative of the position that is given: 0 position, 1 velocity, 2 acceleration, 3 jerk", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion, order), .in_text = true, .text_name = "order", .text_factor = 1.0, .in_table = true, .head = "order", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "angular_order", .unit = "", .doc = "likewise: 0 no attitude (the body stands level, its front to North), 1 attitude, 2 rate, 3 acceleration, 4 jerk", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion, angular_order), .in_text = true, .text_name = "angular_order", .text_factor = 1.0, .in_table = true, .head = "angular order", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "point", .unit = "", .doc = "of which point", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_motion, point), .word = words_motion_point, .n_words = sizeof words_motion_point / sizeof words_motion_point[0], .in_text = true, .text_name = "point", .text_factor = 1.0, .in_table = true, .head = "point", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "snap", .unit = "", .doc = "1: jump there at the next block instead of joining", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion, snap), .in_text = true, .text_name = "snap", .text_factor = 1.0, .in_table = true, .head = "snap", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "pos_m", .unit = "m", .doc = "position (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "pos_", .suffix = "_m", .offset = offsetof(orr_msg_motion, pos_m), .in_text = true, .text_name = "pos_m", .text_factor = 1.0, .in_table = true, .head = "pos", .table_unit = "m", .table_factor = 1.0, .digits = 4},
    {.name = "vel_mps", .unit = "m/s", .doc = "velocity relative to the Earth (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "vel_", .suffix = "_mps", .offset = offsetof(orr_msg_motion, vel_mps), .in_text = true, .text_name = "vel_mps", .text_factor = 1.0, .in_table = true, .head = "vel", .table_unit = "m/s", .table_factor = 1.0, .digits = 5},
    {.name = "acc_mps2", .unit = "m/s2", .doc = "second derivative of the position (ecef)", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "acc_", .suffix = "_mps2", .offset = offsetof(orr_msg_motion, acc_mps2), .in_text = true, .text_name = "acc_mps2", .text_factor = 1.0, .in_table = true, .head = "acc", .table_unit = "m/s2", .table_factor = 1.0, .digits = 6},
    {.name = "jerk_mps3", .unit = "m/s3", .doc = "third", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "jerk_mps3_", .suffix = "", .offset = offsetof(orr_msg_motion, jerk_mps3), .in_text = true, .text_name = "jerk_mps3", .text_factor = 1.0, .in_table = true, .head = "jerk mps3", .table_unit = "m/s3", .table_factor = 1.0, .digits = -1},
    {.name = "attitude", .unit = "", .doc = "quaternion w x y z of body from ecef: v_body = conj(q) v_ecef q; body is right, forward, up", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 4, .stem = "attitude_", .suffix = "", .offset = offsetof(orr_msg_motion, attitude), .in_text = true, .text_name = "attitude", .text_factor = 1.0, .in_table = true, .head = "attitude", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "rate_radps", .unit = "rad/s", .doc = "rate of the body relative to ecef, body axes", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "rate_", .suffix = "_radps", .offset = offsetof(orr_msg_motion, rate_radps), .in_text = true, .text_name = "rate_radps", .text_factor = 1.0, .in_table = true, .head = "rate", .table_unit = "rad/s", .table_factor = 1.0, .digits = -1},
    {.name = "rate2_radps2", .unit = "rad/s2", .doc = "its derivative", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "rate2_radps2_", .suffix = "", .offset = offsetof(orr_msg_motion, rate2_radps2), .in_text = true, .text_name = "rate2_radps2", .text_factor = 1.0, .in_table = true, .head = "rate2 radps2", .table_unit = "rad/s2", .table_factor = 1.0, .digits = -1},
    {.name = "rate3_radps3", .unit = "rad/s3", .doc = "and that one's", .kind = ORR_FIELD_F64, .show = ORR_SHOW_NUMBER, .length = 3, .stem = "rate3_radps3_", .suffix = "", .offset = offsetof(orr_msg_motion, rate3_radps3), .in_text = true, .text_name = "rate3_radps3", .text_factor = 1.0, .in_table = true, .head = "rate3 radps3", .table_unit = "rad/s3", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_motion = {"motion", fields_motion, 13, sizeof(orr_msg_motion), false, false};

static orr_wire_status encode_motion(const void *m, orr_wire_writer *w)
{
    return orr_msg_motion_encode((const orr_msg_motion *)m, w);
}
static orr_wire_status decode_motion(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_motion_decode(payload, size, (orr_msg_motion *)m);
}

static const orr_field fields_get_motion_stats[] = {
    {.name = "reset", .unit = "", .doc = "1: counts begin anew afterwards", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_get_motion_stats, reset), .in_text = true, .text_name = "reset", .text_factor = 1.0, .in_table = true, .head = "reset", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_get_motion_stats = {"get_motion_stats", fields_get_motion_stats, 1, sizeof(orr_msg_get_motion_stats), false, false};

static orr_wire_status encode_get_motion_stats(const void *m, orr_wire_writer *w)
{
    return orr_msg_get_motion_stats_encode((const orr_msg_get_motion_stats *)m, w);
}
static orr_wire_status decode_get_motion_stats(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_get_motion_stats_decode(payload, size, (orr_msg_get_motion_stats *)m);
}

static const orr_field fields_motion_stats[] = {
    {.name = "received", .unit = "", .doc = "samples that came", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, received), .in_text = true, .text_name = "received", .text_factor = 1.0, .in_table = true, .head = "received", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "used", .unit = "", .doc = "of them on which a block rests", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, used), .in_text = true, .text_name = "used", .text_factor = 1.0, .in_table = true, .head = "used", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "late", .unit = "", .doc = "that came after a block for their instant was made", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, late), .in_text = true, .text_name = "late", .text_factor = 1.0, .in_table = true, .head = "late", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "early", .unit = "", .doc = "that came before any block needed them", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, early), .in_text = true, .text_name = "early", .text_factor = 1.0, .in_table = true, .head = "early", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "dropped", .unit = "", .doc = "that could not be used: tags that go back or lie far ahead, numbers that are none, jumps that were not asked for", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, dropped), .in_text = true, .text_name = "dropped", .text_factor = 1.0, .in_table = true, .head = "dropped", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "overtaken", .unit = "", .doc = "on which no block came to rest before the next", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, overtaken), .in_text = true, .text_name = "overtaken", .text_factor = 1.0, .in_table = true, .head = "overtaken", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "blocks", .unit = "", .doc = "blocks made along live motion", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, blocks), .in_text = true, .text_name = "blocks", .text_factor = 1.0, .in_table = true, .head = "blocks", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "extrapolated", .unit = "", .doc = "of them beyond the last sample", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, extrapolated), .in_text = true, .text_name = "extrapolated", .text_factor = 1.0, .in_table = true, .head = "extrapolated", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "joined", .unit = "", .doc = "on the way back", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, joined), .in_text = true, .text_name = "joined", .text_factor = 1.0, .in_table = true, .head = "joined", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "snapped", .unit = "", .doc = "with a jump", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, snapped), .in_text = true, .text_name = "snapped", .text_factor = 1.0, .in_table = true, .head = "snapped", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "lateness", .unit = "", .doc = "scenario's instant at arrival less the tag", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, lateness), .record = &record_motion_spread, .in_text = true, .text_name = "lateness", .text_factor = 1.0, .in_table = true, .head = "lateness", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "margin", .unit = "", .doc = "tag less the end of what had been made at arrival", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, margin), .record = &record_motion_spread, .in_text = true, .text_name = "margin", .text_factor = 1.0, .in_table = true, .head = "margin", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "buffered", .unit = "", .doc = "samples that wait for their instant", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_stats, buffered), .in_text = true, .text_name = "buffered", .text_factor = 1.0, .in_table = true, .head = "buffered", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "worst", .unit = "", .doc = "worst state of a block since this was asked last", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_motion_stats, worst), .word = words_motion_state, .n_words = sizeof words_motion_state / sizeof words_motion_state[0], .in_text = true, .text_name = "worst", .text_factor = 1.0, .in_table = true, .head = "worst", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_motion_stats = {"motion_stats", fields_motion_stats, 14, sizeof(orr_msg_motion_stats), false, false};

static orr_wire_status encode_motion_stats(const void *m, orr_wire_writer *w)
{
    return orr_msg_motion_stats_encode((const orr_msg_motion_stats *)m, w);
}
static orr_wire_status decode_motion_stats(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_motion_stats_decode(payload, size, (orr_msg_motion_stats *)m);
}

static const orr_field fields_poll_events[] = {
    {.name = "epochs", .unit = "", .doc = "begins of the intervals, which are step long (0 to 1 h; 0: an hour)", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_poll_events, epochs), .record = &record_epochs, .in_text = true, .text_name = "epochs", .text_factor = 1.0, .in_table = true, .head = "epochs", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_poll_events = {"poll_events", fields_poll_events, 1, sizeof(orr_msg_poll_events), false, false};

static orr_wire_status encode_poll_events(const void *m, orr_wire_writer *w)
{
    return orr_msg_poll_events_encode((const orr_msg_poll_events *)m, w);
}
static orr_wire_status decode_poll_events(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_poll_events_decode(payload, size, (orr_msg_poll_events *)m);
}

static bool next_event(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_event_next((const orr_msg_event_list *)list, it, (orr_msg_event *)out);
}

static const orr_field fields_events[] = {
    {.name = "epoch", .unit = "", .doc = "begin of the interval; OK, or OUTSIDE_SPAN with no events", .kind = ORR_FIELD_STRUCT, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_events, epoch), .record = &record_epoch, .in_text = true, .text_name = "epoch", .text_factor = 1.0, .in_table = true, .head = "epoch", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "t1", .unit = "ns", .doc = "end of the interval", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_events, t1), .in_text = true, .text_name = "t1", .text_factor = 1.0, .in_table = false, .head = "t1", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "events", .unit = "", .doc = "ascending in time; of one instant by kind, satellite and antenna", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_events, events), .limit = 8192, .record = &record_event, .next = next_event, .in_text = true, .text_name = "events", .text_factor = 1.0, .in_table = true, .head = "events", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_events = {"events", fields_events, 3, sizeof(orr_msg_events), false, false};

static orr_wire_status encode_events(const void *m, orr_wire_writer *w)
{
    return orr_msg_events_encode((const orr_msg_events *)m, w);
}
static orr_wire_status decode_events(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_events_decode(payload, size, (orr_msg_events *)m);
}

static const orr_field fields_open_datagrams[] = {
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_open_datagrams, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_open_datagrams = {"open_datagrams", fields_open_datagrams, 1, sizeof(orr_msg_open_datagrams), false, false};

static orr_wire_status encode_open_datagrams(const void *m, orr_wire_writer *w)
{
    return orr_msg_open_datagrams_encode((const orr_msg_open_datagrams *)m, w);
}
static orr_wire_status decode_open_datagrams(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_open_datagrams_decode(payload, size, (orr_msg_open_datagrams *)m);
}

static const orr_field fields_datagrams[] = {
    {.name = "channel", .unit = "", .doc = "its number, which datagrams to the server name", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, channel), .in_text = true, .text_name = "channel", .text_factor = 1.0, .in_table = true, .head = "channel", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "port", .unit = "", .doc = "UDP port where the server takes motion; 0: none (serve --motion-udp)", .kind = ORR_FIELD_U16, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, port), .in_text = true, .text_name = "port", .text_factor = 1.0, .in_table = true, .head = "port", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "seal", .unit = "", .doc = "what stands behind each frame, in both directions", .kind = ORR_FIELD_U8, .show = ORR_SHOW_ENUM, .offset = offsetof(orr_msg_datagrams, seal), .word = words_seal, .n_words = sizeof words_seal / sizeof words_seal[0], .in_text = true, .text_name = "seal", .text_factor = 1.0, .in_table = true, .head = "seal", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "taken", .unit = "", .doc = "datagrams of the channel that were new and whole", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, taken), .in_text = true, .text_name = "taken", .text_factor = 1.0, .in_table = true, .head = "taken", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "replayed", .unit = "", .doc = "that had come before, or lie more than 1024 numbers back", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, replayed), .in_text = true, .text_name = "replayed", .text_factor = 1.0, .in_table = true, .head = "replayed", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "refused", .unit = "", .doc = "that named it and had another seal, came from elsewhere, or held no MOTION", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, refused), .in_text = true, .text_name = "refused", .text_factor = 1.0, .in_table = true, .head = "refused", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "keys", .unit = "", .doc = "with HMAC_SHA256: the key of what the client sends, then that of what the server sends, 32 bytes each; what the exporter of the TLS session gives (RFC 8446, 7.5) for the label EXPORTER-orrery-datagrams and an empty context", .kind = ORR_FIELD_BYTES, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_datagrams, keys), .limit = 64, .in_text = true, .text_name = "keys", .text_factor = 1.0, .in_table = true, .head = "keys", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_datagrams = {"datagrams", fields_datagrams, 8, sizeof(orr_msg_datagrams), false, false};

static orr_wire_status encode_datagrams(const void *m, orr_wire_writer *w)
{
    return orr_msg_datagrams_encode((const orr_msg_datagrams *)m, w);
}
static orr_wire_status decode_datagrams(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_datagrams_decode(payload, size, (orr_msg_datagrams *)m);
}

static const orr_field fields_open_motion_ring[] = {
    {.name = "reserved", .unit = "", .doc = "0", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_open_motion_ring, reserved), .in_text = false, .text_name = "reserved", .text_factor = 1.0, .in_table = false, .head = "reserved", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_open_motion_ring = {"open_motion_ring", fields_open_motion_ring, 1, sizeof(orr_msg_open_motion_ring), false, false};

static orr_wire_status encode_open_motion_ring(const void *m, orr_wire_writer *w)
{
    return orr_msg_open_motion_ring_encode((const orr_msg_open_motion_ring *)m, w);
}
static orr_wire_status decode_open_motion_ring(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_open_motion_ring_decode(payload, size, (orr_msg_open_motion_ring *)m);
}

static const orr_field fields_motion_ring[] = {
    {.name = "slots", .unit = "", .doc = "messages that the ring holds", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_ring, slots), .in_text = true, .text_name = "slots", .text_factor = 1.0, .in_table = true, .head = "slots", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "stride", .unit = "", .doc = "bytes of a slot", .kind = ORR_FIELD_U32, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_ring, stride), .in_text = true, .text_name = "stride", .text_factor = 1.0, .in_table = true, .head = "stride", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "taken", .unit = "", .doc = "messages that the server has read", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_ring, taken), .in_text = true, .text_name = "taken", .text_factor = 1.0, .in_table = true, .head = "taken", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "lost", .unit = "", .doc = "that had been written over before it came to them", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_motion_ring, lost), .in_text = true, .text_name = "lost", .text_factor = 1.0, .in_table = true, .head = "lost", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_motion_ring = {"motion_ring", fields_motion_ring, 4, sizeof(orr_msg_motion_ring), false, false};

static orr_wire_status encode_motion_ring(const void *m, orr_wire_writer *w)
{
    return orr_msg_motion_ring_encode((const orr_msg_motion_ring *)m, w);
}
static orr_wire_status decode_motion_ring(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_motion_ring_decode(payload, size, (orr_msg_motion_ring *)m);
}

static const orr_field fields_get_modes[] = {
    {.name = "after", .unit = "", .doc = "number of the last change that is known; 0: all that are kept; 2^64 - 1: those from now on", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_get_modes, after), .in_text = true, .text_name = "after", .text_factor = 1.0, .in_table = true, .head = "after", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_get_modes = {"get_modes", fields_get_modes, 1, sizeof(orr_msg_get_modes), false, false};

static orr_wire_status encode_get_modes(const void *m, orr_wire_writer *w)
{
    return orr_msg_get_modes_encode((const orr_msg_get_modes *)m, w);
}
static orr_wire_status decode_get_modes(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_get_modes_decode(payload, size, (orr_msg_get_modes *)m);
}

static bool next_mode_change(const void *list, orr_wire_iter *it, void *out)
{
    return orr_msg_mode_change_next((const orr_msg_mode_change_list *)list, it, (orr_msg_mode_change *)out);
}

static const orr_field fields_modes[] = {
    {.name = "t", .unit = "ns", .doc = "what the scenario's clock shows", .kind = ORR_FIELD_I64, .show = ORR_SHOW_TIME, .offset = offsetof(orr_msg_modes, t), .in_text = true, .text_name = "t", .text_factor = 1.0, .in_table = true, .head = "t", .table_unit = "ns", .table_factor = 1.0, .digits = -1},
    {.name = "last", .unit = "", .doc = "number of the last change listed, to ask on from; without any that of the last there was", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_modes, last), .in_text = true, .text_name = "last", .text_factor = 1.0, .in_table = true, .head = "last", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "lost", .unit = "", .doc = "changes after `after` that are not kept any more (1024 are)", .kind = ORR_FIELD_U64, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_modes, lost), .in_text = true, .text_name = "lost", .text_factor = 1.0, .in_table = true, .head = "lost", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "more", .unit = "", .doc = "1: there are more behind the last one listed", .kind = ORR_FIELD_U8, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_modes, more), .in_text = true, .text_name = "more", .text_factor = 1.0, .in_table = true, .head = "more", .table_unit = "", .table_factor = 1.0, .digits = -1},
    {.name = "changes", .unit = "", .doc = "what changed", .kind = ORR_FIELD_LIST, .show = ORR_SHOW_NUMBER, .offset = offsetof(orr_msg_modes, changes), .limit = 100, .record = &record_mode_change, .next = next_mode_change, .in_text = true, .text_name = "changes", .text_factor = 1.0, .in_table = true, .head = "changes", .table_unit = "", .table_factor = 1.0, .digits = -1},
};
static const orr_record record_modes = {"modes", fields_modes, 5, sizeof(orr_msg_modes), false, false};

static orr_wire_status encode_modes(const void *m, orr_wire_writer *w)
{
    return orr_msg_modes_encode((const orr_msg_modes *)m, w);
}
static orr_wire_status decode_modes(const uint8_t *payload, size_t size, void *m)
{
    return orr_msg_modes_decode(payload, size, (orr_msg_modes *)m);
}

static const orr_message_info messages[] = {
    {"HELLO", ORR_MSG_TYPE_HELLO, ORR_MSG_TYPE_CAPS, true, &record_hello, encode_hello, decode_hello},
    {"CAPS", ORR_MSG_TYPE_CAPS, 0, false, &record_caps, encode_caps, decode_caps},
    {"PING", ORR_MSG_TYPE_PING, ORR_MSG_TYPE_PONG, true, &record_ping, encode_ping, decode_ping},
    {"PONG", ORR_MSG_TYPE_PONG, 0, false, &record_pong, encode_pong, decode_pong},
    {"ERROR", ORR_MSG_TYPE_ERROR, 0, false, &record_error, encode_error, decode_error},
    {"POLL", ORR_MSG_TYPE_POLL, ORR_MSG_TYPE_STATES, true, &record_poll, encode_poll, decode_poll},
    {"STATES", ORR_MSG_TYPE_STATES, 0, false, &record_states, encode_states, decode_states},
    {"POLL_ELEMENTS", ORR_MSG_TYPE_POLL_ELEMENTS, ORR_MSG_TYPE_ELEMENTS, true, &record_poll_elements, encode_poll_elements, decode_poll_elements},
    {"ELEMENTS", ORR_MSG_TYPE_ELEMENTS, 0, false, &record_elements, encode_elements, decode_elements},
    {"POLL_NAVDATA", ORR_MSG_TYPE_POLL_NAVDATA, ORR_MSG_TYPE_NAVDATA, true, &record_poll_navdata, encode_poll_navdata, decode_poll_navdata},
    {"NAVDATA", ORR_MSG_TYPE_NAVDATA, 0, false, &record_navdata, encode_navdata, decode_navdata},
    {"POLL_DELAYS", ORR_MSG_TYPE_POLL_DELAYS, ORR_MSG_TYPE_DELAYS, true, &record_poll_delays, encode_poll_delays, decode_poll_delays},
    {"DELAYS", ORR_MSG_TYPE_DELAYS, 0, false, &record_delays, encode_delays, decode_delays},
    {"POLL_CHANNELS", ORR_MSG_TYPE_POLL_CHANNELS, ORR_MSG_TYPE_CHANNELS, true, &record_poll_channels, encode_poll_channels, decode_poll_channels},
    {"CHANNELS", ORR_MSG_TYPE_CHANNELS, 0, false, &record_channels, encode_channels, decode_channels},
    {"POLL_IMU", ORR_MSG_TYPE_POLL_IMU, ORR_MSG_TYPE_IMU, true, &record_poll_imu, encode_poll_imu, decode_poll_imu},
    {"IMU", ORR_MSG_TYPE_IMU, 0, false, &record_imu, encode_imu, decode_imu},
    {"POLL_TRUTH", ORR_MSG_TYPE_POLL_TRUTH, ORR_MSG_TYPE_TRUTH, true, &record_poll_truth, encode_poll_truth, decode_poll_truth},
    {"TRUTH", ORR_MSG_TYPE_TRUTH, 0, false, &record_truth, encode_truth, decode_truth},
    {"SUBSCRIBE", ORR_MSG_TYPE_SUBSCRIBE, ORR_MSG_TYPE_SUBSCRIBED, true, &record_subscribe, encode_subscribe, decode_subscribe},
    {"SUBSCRIBED", ORR_MSG_TYPE_SUBSCRIBED, 0, false, &record_subscribed, encode_subscribed, decode_subscribed},
    {"UNSUBSCRIBE", ORR_MSG_TYPE_UNSUBSCRIBE, 0, true, &record_unsubscribe, encode_unsubscribe, decode_unsubscribe},
    {"CREDIT", ORR_MSG_TYPE_CREDIT, 0, true, &record_credit, encode_credit, decode_credit},
    {"GAP", ORR_MSG_TYPE_GAP, 0, false, &record_gap, encode_gap, decode_gap},
    {"STREAM_END", ORR_MSG_TYPE_STREAM_END, 0, false, &record_stream_end, encode_stream_end, decode_stream_end},
    {"CONTROL", ORR_MSG_TYPE_CONTROL, ORR_MSG_TYPE_TIME, true, &record_control, encode_control, decode_control},
    {"GET_TIME", ORR_MSG_TYPE_GET_TIME, ORR_MSG_TYPE_TIME, true, &record_get_time, encode_get_time, decode_get_time},
    {"TIME", ORR_MSG_TYPE_TIME, 0, false, &record_time, encode_time, decode_time},
    {"RADIO_TIME", ORR_MSG_TYPE_RADIO_TIME, ORR_MSG_TYPE_PACE, true, &record_radio_time, encode_radio_time, decode_radio_time},
    {"PACE", ORR_MSG_TYPE_PACE, 0, false, &record_pace, encode_pace, decode_pace},
    {"MOTION", ORR_MSG_TYPE_MOTION, 0, true, &record_motion, encode_motion, decode_motion},
    {"GET_MOTION_STATS", ORR_MSG_TYPE_GET_MOTION_STATS, ORR_MSG_TYPE_MOTION_STATS, true, &record_get_motion_stats, encode_get_motion_stats, decode_get_motion_stats},
    {"MOTION_STATS", ORR_MSG_TYPE_MOTION_STATS, 0, false, &record_motion_stats, encode_motion_stats, decode_motion_stats},
    {"POLL_EVENTS", ORR_MSG_TYPE_POLL_EVENTS, ORR_MSG_TYPE_EVENTS, true, &record_poll_events, encode_poll_events, decode_poll_events},
    {"EVENTS", ORR_MSG_TYPE_EVENTS, 0, false, &record_events, encode_events, decode_events},
    {"OPEN_DATAGRAMS", ORR_MSG_TYPE_OPEN_DATAGRAMS, ORR_MSG_TYPE_DATAGRAMS, true, &record_open_datagrams, encode_open_datagrams, decode_open_datagrams},
    {"DATAGRAMS", ORR_MSG_TYPE_DATAGRAMS, 0, false, &record_datagrams, encode_datagrams, decode_datagrams},
    {"OPEN_MOTION_RING", ORR_MSG_TYPE_OPEN_MOTION_RING, ORR_MSG_TYPE_MOTION_RING, true, &record_open_motion_ring, encode_open_motion_ring, decode_open_motion_ring},
    {"MOTION_RING", ORR_MSG_TYPE_MOTION_RING, 0, false, &record_motion_ring, encode_motion_ring, decode_motion_ring},
    {"GET_MODES", ORR_MSG_TYPE_GET_MODES, ORR_MSG_TYPE_MODES, true, &record_get_modes, encode_get_modes, decode_get_modes},
    {"MODES", ORR_MSG_TYPE_MODES, 0, false, &record_modes, encode_modes, decode_modes},
};

const orr_message_info *orr_message_of(uint16_t type)
{
    for (size_t i = 0; i < sizeof messages / sizeof messages[0]; i++)
        if (messages[i].type == type) return &messages[i];
    return NULL;
}

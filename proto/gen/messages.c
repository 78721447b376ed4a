// SPDX-License-Identifier: MIT
// Generated from proto/spec/messages.yaml by proto/spec/generate.py: change that, not this.
// clang-format off
#include "proto/gen/messages.h"

const char *orr_msg_type_name(uint16_t type)
{
    switch (type) {
    case 1: return "HELLO";
    case 2: return "CAPS";
    case 3: return "PING";
    case 4: return "PONG";
    case 5: return "ERROR";
    case 6: return "POLL";
    case 7: return "STATES";
    case 8: return "POLL_ELEMENTS";
    case 9: return "ELEMENTS";
    case 10: return "POLL_NAVDATA";
    case 11: return "NAVDATA";
    case 12: return "POLL_DELAYS";
    case 13: return "DELAYS";
    case 14: return "POLL_CHANNELS";
    case 15: return "CHANNELS";
    case 16: return "POLL_IMU";
    case 17: return "IMU";
    case 18: return "POLL_TRUTH";
    case 19: return "TRUTH";
    case 20: return "SUBSCRIBE";
    case 21: return "SUBSCRIBED";
    case 22: return "UNSUBSCRIBE";
    case 23: return "CREDIT";
    case 24: return "GAP";
    case 25: return "STREAM_END";
    case 26: return "CONTROL";
    case 27: return "GET_TIME";
    case 28: return "TIME";
    case 29: return "RADIO_TIME";
    case 30: return "PACE";
    case 31: return "MOTION";
    case 32: return "GET_MOTION_STATS";
    case 33: return "MOTION_STATS";
    case 34: return "POLL_EVENTS";
    case 35: return "EVENTS";
    case 36: return "OPEN_DATAGRAMS";
    case 37: return "DATAGRAMS";
    case 38: return "OPEN_MOTION_RING";
    case 39: return "MOTION_RING";
    case 40: return "GET_MODES";
    case 41: return "MODES";
    default: return NULL;
    }
}

const char *orr_msg_error_code_name(uint16_t value)
{
    switch (value) {
    case 1: return "BAD_MAGIC";
    case 2: return "BAD_LENGTH";
    case 3: return "BAD_CRC";
    case 4: return "BAD_VERSION";
    case 5: return "UNKNOWN_TYPE";
    case 6: return "BAD_PAYLOAD";
    case 7: return "BAD_REQUEST";
    case 8: return "LIMIT";
    case 9: return "NOT_SERVED";
    case 10: return "BUSY";
    case 11: return "TIMEOUT";
    case 12: return "CLOSING";
    case 13: return "INTERNAL";
    case 14: return "NOT_PERMITTED";
    default: return NULL;
    }
}

const char *orr_msg_answer_name(uint8_t value)
{
    switch (value) {
    case 0: return "OK";
    case 1: return "OUTSIDE_SPAN";
    case 2: return "NO_ARC";
    case 3: return "NOT_SERVED";
    case 4: return "BELOW_HORIZON";
    case 5: return "NO_VALUE";
    default: return NULL;
    }
}

const char *orr_msg_nav_message_name(uint8_t value)
{
    switch (value) {
    case 0: return "NONE";
    case 1: return "LNAV";
    case 2: return "CNAV";
    case 3: return "CNV1";
    case 4: return "CNV2";
    case 5: return "CNV3";
    case 6: return "INAV";
    case 7: return "FNAV";
    case 8: return "D1";
    case 9: return "D2";
    case 10: return "FDMA";
    case 11: return "SBAS";
    default: return NULL;
    }
}

const char *orr_msg_nav_form_name(uint8_t value)
{
    switch (value) {
    case 0: return "BITS";
    case 1: return "SYMBOLS";
    default: return NULL;
    }
}

const char *orr_msg_elements_frame_name(uint8_t value)
{
    switch (value) {
    case 0: return "DATE";
    case 1: return "J2000";
    case 2: return "ECEF";
    default: return NULL;
    }
}

const char *orr_msg_elements_method_name(uint8_t value)
{
    switch (value) {
    case 0: return "STATE";
    case 1: return "THREE_POSITIONS";
    case 2: return "MEAN";
    default: return NULL;
    }
}

const char *orr_msg_orbit_point_name(uint8_t value)
{
    switch (value) {
    case 0: return "NONE";
    case 1: return "CENTRE_OF_MASS";
    case 2: return "PHASE_CENTRE";
    default: return NULL;
    }
}

const char *orr_msg_receiver_source_name(uint8_t value)
{
    switch (value) {
    case 0: return "NONE";
    case 1: return "POSITION";
    case 2: return "TRAJECTORY";
    case 3: return "STATION";
    default: return NULL;
    }
}

const char *orr_msg_tec_origin_name(uint8_t value)
{
    switch (value) {
    case 0: return "FIELD";
    case 1: return "FUSED";
    case 2: return "TRANSFERRED";
    case 3: return "NOISE";
    default: return NULL;
    }
}

const char *orr_msg_pacing_name(uint8_t value)
{
    switch (value) {
    case 0: return "FREE";
    case 1: return "CLOCK";
    case 2: return "MOTION";
    default: return NULL;
    }
}

const char *orr_msg_delivery_name(uint8_t value)
{
    switch (value) {
    case 0: return "FRAMES";
    case 1: return "RING";
    case 2: return "DATAGRAMS";
    default: return NULL;
    }
}

const char *orr_msg_seal_name(uint8_t value)
{
    switch (value) {
    case 0: return "NONE";
    case 1: return "HMAC_SHA256";
    default: return NULL;
    }
}

const char *orr_msg_gap_reason_name(uint8_t value)
{
    switch (value) {
    case 1: return "CREDIT";
    case 2: return "LATE";
    default: return NULL;
    }
}

const char *orr_msg_end_reason_name(uint8_t value)
{
    switch (value) {
    case 1: return "FINISHED";
    case 2: return "UNSUBSCRIBED";
    case 3: return "SLOW";
    case 4: return "OUTSIDE_SPAN";
    case 5: return "FAILED";
    default: return NULL;
    }
}

const char *orr_msg_control_action_name(uint8_t value)
{
    switch (value) {
    case 1: return "LOAD";
    case 2: return "ARM";
    case 3: return "WAIT_PPS";
    case 4: return "START";
    case 5: return "PAUSE";
    case 6: return "STOP";
    default: return NULL;
    }
}

const char *orr_msg_clock_reference_name(uint8_t value)
{
    switch (value) {
    case 0: return "WALL";
    case 1: return "RADIO";
    default: return NULL;
    }
}

const char *orr_msg_clock_state_name(uint8_t value)
{
    switch (value) {
    case 0: return "STOPPED";
    case 1: return "ARMED";
    case 2: return "WAITING";
    case 3: return "RUNNING";
    case 4: return "PAUSED";
    default: return NULL;
    }
}

const char *orr_msg_readings_name(uint8_t value)
{
    switch (value) {
    case 0: return "IDEAL";
    case 1: return "MEASURED";
    default: return NULL;
    }
}

const char *orr_msg_stamp_clock_name(uint8_t value)
{
    switch (value) {
    case 0: return "ARRIVAL";
    case 1: return "MONOTONIC";
    case 2: return "TAI";
    case 3: return "REALTIME";
    default: return NULL;
    }
}

const char *orr_msg_motion_state_name(uint8_t value)
{
    switch (value) {
    case 0: return "SCENARIO";
    case 1: return "SYNCHRONOUS";
    case 2: return "INTERPOLATED";
    case 3: return "EXTRAPOLATED";
    case 4: return "JOINING";
    case 5: return "SNAPPED";
    default: return NULL;
    }
}

const char *orr_msg_motion_point_name(uint8_t value)
{
    switch (value) {
    case 0: return "BODY";
    case 1: return "ANTENNA";
    default: return NULL;
    }
}

const char *orr_msg_event_kind_name(uint8_t value)
{
    switch (value) {
    case 1: return "RISE";
    case 2: return "SET";
    case 3: return "ARC_BEGIN";
    case 4: return "ARC_END";
    case 5: return "EPHEMERIS";
    case 6: return "HEALTH";
    case 7: return "LEAP_SECOND";
    case 8: return "ECLIPSE_BEGIN";
    case 9: return "ECLIPSE_END";
    case 10: return "MANOEUVRE_BEGIN";
    case 11: return "MANOEUVRE_END";
    case 12: return "MOTION_BEGIN";
    case 13: return "MOTION_END";
    case 14: return "FAULT_BEGIN";
    case 15: return "FAULT_END";
    default: return NULL;
    }
}

const char *orr_msg_mode_kind_name(uint8_t value)
{
    switch (value) {
    case 0: return "CLOCK";
    case 1: return "REFERENCE";
    case 2: return "GENERATOR";
    case 3: return "MOTION";
    default: return NULL;
    }
}

const char *orr_msg_mode_name(uint8_t value)
{
    switch (value) {
    case 0: return "STOPPED";
    case 1: return "ARMED";
    case 2: return "WAITING";
    case 3: return "RUNNING";
    case 4: return "PAUSED";
    case 16: return "WALL";
    case 17: return "RADIO";
    case 32: return "SILENT";
    case 33: return "LOCKED";
    case 34: return "STEPPING";
    case 48: return "SCENARIO";
    case 49: return "SYNCHRONOUS";
    case 50: return "INTERPOLATED";
    case 51: return "EXTRAPOLATED";
    case 52: return "JOINING";
    case 53: return "SNAPPED";
    default: return NULL;
    }
}

bool orr_msg_error_code_closes(uint16_t value)
{
    return value == 1 || value == 2 || value == 3 || value == 4 || value == 10 || value == 11 || value == 12;
}

const char *orr_msg_access_name(unsigned bit)
{
    switch (bit) {
    case 0: return "NO_READING";
    case 1: return "NO_MOTION";
    case 2: return "NO_CONTROL";
    case 3: return "INSECURE";
    default: return NULL;
    }
}

const char *orr_msg_channel_flags_name(unsigned bit)
{
    switch (bit) {
    case 0: return "UNHEALTHY";
    case 1: return "ECLIPSE";
    case 2: return "FAST_TURN";
    case 3: return "NO_ANTENNA";
    case 4: return "NO_DELAY";
    case 5: return "ZERO_CLOCK";
    case 6: return "NOMINAL_CHANNEL";
    case 7: return "FAULT";
    default: return NULL;
    }
}

const char *orr_msg_delay_flags_name(unsigned bit)
{
    switch (bit) {
    case 0: return "CLIPPED";
    default: return NULL;
    }
}

const char *orr_msg_state_flags_name(unsigned bit)
{
    switch (bit) {
    case 0: return "CLOCK_VALID";
    case 1: return "PREDICTED";
    case 2: return "MANOEUVRE";
    case 3: return "CLOCK_EVENT";
    case 4: return "ECLIPSE";
    case 5: return "GAP";
    case 6: return "JOINT";
    case 7: return "SHADOW_NOISE";
    default: return NULL;
    }
}

const char *orr_msg_nav_messages_name(unsigned bit)
{
    switch (bit) {
    case 1: return "LNAV";
    case 2: return "CNAV";
    case 3: return "CNV1";
    case 4: return "CNV2";
    case 5: return "CNV3";
    case 6: return "INAV";
    case 7: return "FNAV";
    case 8: return "D1";
    case 9: return "D2";
    case 10: return "FDMA";
    case 11: return "SBAS";
    default: return NULL;
    }
}

const char *orr_msg_nav_notes_name(unsigned bit)
{
    switch (bit) {
    case 0: return "MANOEUVRE";
    case 1: return "SHIFTED";
    case 2: return "NO_CLOCK";
    case 3: return "NO_ANTENNA";
    case 4: return "NO_DELAY";
    case 5: return "NOMINAL_CHANNEL";
    case 6: return "CLOCK_JUMP";
    case 7: return "FAULTY";
    default: return NULL;
    }
}

static inline void store_motion_spread(uint8_t *p, const orr_msg_motion_spread *m)
{
    orr_wire_store_i64(p + 0, m->min);
    orr_wire_store_i64(p + 8, m->max);
    orr_wire_store_i64(p + 16, m->last);
    orr_wire_store_i64(p + 24, m->p50);
    orr_wire_store_i64(p + 32, m->p99);
}

static inline void load_motion_spread(const uint8_t *p, orr_msg_motion_spread *m)
{
    m->min = orr_wire_load_i64(p + 0);
    m->max = orr_wire_load_i64(p + 8);
    m->last = orr_wire_load_i64(p + 16);
    m->p50 = orr_wire_load_i64(p + 24);
    m->p99 = orr_wire_load_i64(p + 32);
}

static inline void store_sat_id(uint8_t *p, const orr_msg_sat_id *m)
{
    orr_wire_store_u8(p + 0, m->system);
    orr_wire_store_u8(p + 1, m->number);
}

static inline void load_sat_id(const uint8_t *p, orr_msg_sat_id *m)
{
    m->system = orr_wire_load_u8(p + 0);
    m->number = orr_wire_load_u8(p + 1);
}

static inline void store_epochs(uint8_t *p, const orr_msg_epochs *m)
{
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_i64(p + 8, m->step);
    orr_wire_store_u32(p + 16, m->count);
}

static inline void load_epochs(const uint8_t *p, orr_msg_epochs *m)
{
    m->t = orr_wire_load_i64(p + 0);
    m->step = orr_wire_load_i64(p + 8);
    m->count = orr_wire_load_u32(p + 16);
}

static inline void store_epoch(uint8_t *p, const orr_msg_epoch *m)
{
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_u32(p + 8, m->index);
    orr_wire_store_u32(p + 12, m->count);
    orr_wire_store_u8(p + 16, m->answer);
}

static inline void load_epoch(const uint8_t *p, orr_msg_epoch *m)
{
    m->t = orr_wire_load_i64(p + 0);
    m->index = orr_wire_load_u32(p + 8);
    m->count = orr_wire_load_u32(p + 12);
    m->answer = orr_wire_load_u8(p + 16);
}

static inline void store_span(uint8_t *p, const orr_msg_span *m)
{
    orr_wire_store_i64(p + 0, m->first);
    orr_wire_store_i64(p + 8, m->last);
}

static inline void load_span(const uint8_t *p, orr_msg_span *m)
{
    m->first = orr_wire_load_i64(p + 0);
    m->last = orr_wire_load_i64(p + 8);
}

static inline void store_served_request(uint8_t *p, const orr_msg_served_request *m)
{
    orr_wire_store_u16(p + 0, m->request);
    orr_wire_store_u16(p + 2, m->answer);
    store_span(p + 4, &m->span);
}

static inline void load_served_request(const uint8_t *p, orr_msg_served_request *m)
{
    m->request = orr_wire_load_u16(p + 0);
    m->answer = orr_wire_load_u16(p + 2);
    load_span(p + 4, &m->span);
}

static void put_inertial_unit(orr_wire_writer *w, const orr_msg_inertial_unit *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->unit);
    orr_wire_put_bytes(w, m->name, 64);
    p = orr_wire_room(w, 48);
    if (p == NULL) return;
    orr_wire_store_f64(p + 0, m->lever_m[0]);
    orr_wire_store_f64(p + 8, m->lever_m[1]);
    orr_wire_store_f64(p + 16, m->lever_m[2]);
    orr_wire_store_f64(p + 24, m->heading_rad);
    orr_wire_store_f64(p + 32, m->pitch_rad);
    orr_wire_store_f64(p + 40, m->roll_rad);
}

static void get_inertial_unit(orr_wire_reader *r, orr_msg_inertial_unit *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 2);
    if (p == NULL) return;
    m->unit = orr_wire_load_u16(p + 0);
    m->name = orr_wire_get_bytes(r, 64);
    p = orr_wire_take(r, 48);
    if (p == NULL) return;
    m->lever_m[0] = orr_wire_load_f64(p + 0);
    m->lever_m[1] = orr_wire_load_f64(p + 8);
    m->lever_m[2] = orr_wire_load_f64(p + 16);
    m->heading_rad = orr_wire_load_f64(p + 24);
    m->pitch_rad = orr_wire_load_f64(p + 32);
    m->roll_rad = orr_wire_load_f64(p + 40);
}

static inline void store_leap_seconds(uint8_t *p, const orr_msg_leap_seconds *m)
{
    orr_wire_store_i16(p + 0, m->gps_utc_s);
    orr_wire_store_i16(p + 2, m->next_gps_utc_s);
    orr_wire_store_i64(p + 4, m->next);
}

static inline void load_leap_seconds(const uint8_t *p, orr_msg_leap_seconds *m)
{
    m->gps_utc_s = orr_wire_load_i16(p + 0);
    m->next_gps_utc_s = orr_wire_load_i16(p + 2);
    m->next = orr_wire_load_i64(p + 4);
}

static inline void store_sat_state(uint8_t *p, const orr_msg_sat_state *m)
{
    store_sat_id(p + 0, &m->sat);
    orr_wire_store_u8(p + 2, m->answer);
    orr_wire_store_u8(p + 3, m->reserved);
    orr_wire_store_u32(p + 4, m->flags);
    orr_wire_store_f64(p + 8, m->pos_m[0]);
    orr_wire_store_f64(p + 16, m->pos_m[1]);
    orr_wire_store_f64(p + 24, m->pos_m[2]);
    orr_wire_store_f64(p + 32, m->vel_mps[0]);
    orr_wire_store_f64(p + 40, m->vel_mps[1]);
    orr_wire_store_f64(p + 48, m->vel_mps[2]);
    orr_wire_store_f64(p + 56, m->acc_mps2[0]);
    orr_wire_store_f64(p + 64, m->acc_mps2[1]);
    orr_wire_store_f64(p + 72, m->acc_mps2[2]);
    orr_wire_store_f64(p + 80, m->clock_s);
    orr_wire_store_f64(p + 88, m->clock_rate_sps);
    orr_wire_store_i64(p + 96, m->valid_from);
    orr_wire_store_i64(p + 104, m->valid_to);
    orr_wire_store_f32(p + 112, m->sigma_m);
    orr_wire_store_f32(p + 116, m->clock_sigma_s);
}

static inline void load_sat_state(const uint8_t *p, orr_msg_sat_state *m)
{
    load_sat_id(p + 0, &m->sat);
    m->answer = orr_wire_load_u8(p + 2);
    m->reserved = orr_wire_load_u8(p + 3);
    m->flags = orr_wire_load_u32(p + 4);
    m->pos_m[0] = orr_wire_load_f64(p + 8);
    m->pos_m[1] = orr_wire_load_f64(p + 16);
    m->pos_m[2] = orr_wire_load_f64(p + 24);
    m->vel_mps[0] = orr_wire_load_f64(p + 32);
    m->vel_mps[1] = orr_wire_load_f64(p + 40);
    m->vel_mps[2] = orr_wire_load_f64(p + 48);
    m->acc_mps2[0] = orr_wire_load_f64(p + 56);
    m->acc_mps2[1] = orr_wire_load_f64(p + 64);
    m->acc_mps2[2] = orr_wire_load_f64(p + 72);
    m->clock_s = orr_wire_load_f64(p + 80);
    m->clock_rate_sps = orr_wire_load_f64(p + 88);
    m->valid_from = orr_wire_load_i64(p + 96);
    m->valid_to = orr_wire_load_i64(p + 104);
    m->sigma_m = orr_wire_load_f32(p + 112);
    m->clock_sigma_s = orr_wire_load_f32(p + 116);
}

static inline void store_sat_elements(uint8_t *p, const orr_msg_sat_elements *m)
{
    store_sat_id(p + 0, &m->sat);
    orr_wire_store_u8(p + 2, m->answer);
    orr_wire_store_u8(p + 3, m->reserved);
    orr_wire_store_u32(p + 4, m->flags);
    orr_wire_store_f64(p + 8, m->a_m);
    orr_wire_store_f64(p + 16, m->e);
    orr_wire_store_f64(p + 24, m->i_rad);
    orr_wire_store_f64(p + 32, m->raan_rad);
    orr_wire_store_f64(p + 40, m->argp_rad);
    orr_wire_store_f64(p + 48, m->m_rad);
    orr_wire_store_f64(p + 56, m->u_rad);
}

static inline void load_sat_elements(const uint8_t *p, orr_msg_sat_elements *m)
{
    load_sat_id(p + 0, &m->sat);
    m->answer = orr_wire_load_u8(p + 2);
    m->reserved = orr_wire_load_u8(p + 3);
    m->flags = orr_wire_load_u32(p + 4);
    m->a_m = orr_wire_load_f64(p + 8);
    m->e = orr_wire_load_f64(p + 16);
    m->i_rad = orr_wire_load_f64(p + 24);
    m->raan_rad = orr_wire_load_f64(p + 32);
    m->argp_rad = orr_wire_load_f64(p + 40);
    m->m_rad = orr_wire_load_f64(p + 48);
    m->u_rad = orr_wire_load_f64(p + 56);
}

static void put_nav_page(orr_wire_writer *w, const orr_msg_nav_page *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 20);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_i64(p + 8, m->length);
    orr_wire_store_u8(p + 16, m->number);
    orr_wire_store_u8(p + 17, m->page);
    orr_wire_store_u16(p + 18, m->bits);
    orr_wire_put_bytes(w, m->data, 226);
}

static void get_nav_page(orr_wire_reader *r, orr_msg_nav_page *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 20);
    if (p == NULL) return;
    m->t = orr_wire_load_i64(p + 0);
    m->length = orr_wire_load_i64(p + 8);
    m->number = orr_wire_load_u8(p + 16);
    m->page = orr_wire_load_u8(p + 17);
    m->bits = orr_wire_load_u16(p + 18);
    m->data = orr_wire_get_bytes(r, 226);
}

static inline void store_kepler_set(uint8_t *p, const orr_msg_kepler_set *m)
{
    orr_wire_store_f64(p + 0, m->sqrt_a_sqrtm);
    orr_wire_store_f64(p + 8, m->e);
    orr_wire_store_f64(p + 16, m->m0_rad);
    orr_wire_store_f64(p + 24, m->i0_rad);
    orr_wire_store_f64(p + 32, m->omega0_rad);
    orr_wire_store_f64(p + 40, m->omega_rad);
    orr_wire_store_f64(p + 48, m->delta_n_radps);
    orr_wire_store_f64(p + 56, m->idot_radps);
    orr_wire_store_f64(p + 64, m->omega_dot_radps);
    orr_wire_store_f64(p + 72, m->cuc_rad);
    orr_wire_store_f64(p + 80, m->cus_rad);
    orr_wire_store_f64(p + 88, m->crc_m);
    orr_wire_store_f64(p + 96, m->crs_m);
    orr_wire_store_f64(p + 104, m->cic_rad);
    orr_wire_store_f64(p + 112, m->cis_rad);
    orr_wire_store_f64(p + 120, m->a_dot_mps);
    orr_wire_store_f64(p + 128, m->delta_n_dot_radps2);
    orr_wire_store_f64(p + 136, m->tgd_s);
}

static inline void load_kepler_set(const uint8_t *p, orr_msg_kepler_set *m)
{
    m->sqrt_a_sqrtm = orr_wire_load_f64(p + 0);
    m->e = orr_wire_load_f64(p + 8);
    m->m0_rad = orr_wire_load_f64(p + 16);
    m->i0_rad = orr_wire_load_f64(p + 24);
    m->omega0_rad = orr_wire_load_f64(p + 32);
    m->omega_rad = orr_wire_load_f64(p + 40);
    m->delta_n_radps = orr_wire_load_f64(p + 48);
    m->idot_radps = orr_wire_load_f64(p + 56);
    m->omega_dot_radps = orr_wire_load_f64(p + 64);
    m->cuc_rad = orr_wire_load_f64(p + 72);
    m->cus_rad = orr_wire_load_f64(p + 80);
    m->crc_m = orr_wire_load_f64(p + 88);
    m->crs_m = orr_wire_load_f64(p + 96);
    m->cic_rad = orr_wire_load_f64(p + 104);
    m->cis_rad = orr_wire_load_f64(p + 112);
    m->a_dot_mps = orr_wire_load_f64(p + 120);
    m->delta_n_dot_radps2 = orr_wire_load_f64(p + 128);
    m->tgd_s = orr_wire_load_f64(p + 136);
}

static inline void store_glonass_set(uint8_t *p, const orr_msg_glonass_set *m)
{
    orr_wire_store_f64(p + 0, m->pos_m[0]);
    orr_wire_store_f64(p + 8, m->pos_m[1]);
    orr_wire_store_f64(p + 16, m->pos_m[2]);
    orr_wire_store_f64(p + 24, m->vel_mps[0]);
    orr_wire_store_f64(p + 32, m->vel_mps[1]);
    orr_wire_store_f64(p + 40, m->vel_mps[2]);
    orr_wire_store_f64(p + 48, m->acc_mps2[0]);
    orr_wire_store_f64(p + 56, m->acc_mps2[1]);
    orr_wire_store_f64(p + 64, m->acc_mps2[2]);
    orr_wire_store_f64(p + 72, m->delta_tau_s);
    orr_wire_store_i8(p + 80, m->channel);
    orr_wire_store_u8(p + 81, m->reserved);
}

static inline void load_glonass_set(const uint8_t *p, orr_msg_glonass_set *m)
{
    m->pos_m[0] = orr_wire_load_f64(p + 0);
    m->pos_m[1] = orr_wire_load_f64(p + 8);
    m->pos_m[2] = orr_wire_load_f64(p + 16);
    m->vel_mps[0] = orr_wire_load_f64(p + 24);
    m->vel_mps[1] = orr_wire_load_f64(p + 32);
    m->vel_mps[2] = orr_wire_load_f64(p + 40);
    m->acc_mps2[0] = orr_wire_load_f64(p + 48);
    m->acc_mps2[1] = orr_wire_load_f64(p + 56);
    m->acc_mps2[2] = orr_wire_load_f64(p + 64);
    m->delta_tau_s = orr_wire_load_f64(p + 72);
    m->channel = orr_wire_load_i8(p + 80);
    m->reserved = orr_wire_load_u8(p + 81);
}

static void put_kepler_set_records(orr_wire_writer *w, const orr_msg_kepler_set_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 144 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_kepler_set(p + 144 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_kepler_set_records_encode(const orr_msg_kepler_set_list *piece, orr_wire_writer *w)
{
    put_kepler_set_records(w, piece);
    return w->status;
}

static void put_kepler_set_list(orr_wire_writer *w, const orr_msg_kepler_set_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 144 : list->wire.stride);
    put_kepler_set_records(w, list);
}

static void get_kepler_set_list(orr_wire_reader *r, orr_msg_kepler_set_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 144) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_kepler_set_next(const orr_msg_kepler_set_list *list, orr_wire_iter *it, orr_msg_kepler_set *out)
{
    return orr_msg_kepler_set_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_kepler_set_at(const orr_msg_kepler_set_list *list, uint16_t index, orr_msg_kepler_set *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_kepler_set(p, out);
    return true;
}

static void put_glonass_set_records(orr_wire_writer *w, const orr_msg_glonass_set_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 82 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_glonass_set(p + 82 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_glonass_set_records_encode(const orr_msg_glonass_set_list *piece, orr_wire_writer *w)
{
    put_glonass_set_records(w, piece);
    return w->status;
}

static void put_glonass_set_list(orr_wire_writer *w, const orr_msg_glonass_set_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 82 : list->wire.stride);
    put_glonass_set_records(w, list);
}

static void get_glonass_set_list(orr_wire_reader *r, orr_msg_glonass_set_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 82) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_glonass_set_next(const orr_msg_glonass_set_list *list, orr_wire_iter *it, orr_msg_glonass_set *out)
{
    return orr_msg_glonass_set_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_glonass_set_at(const orr_msg_glonass_set_list *list, uint16_t index, orr_msg_glonass_set *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_glonass_set(p, out);
    return true;
}

static void put_nav_page_records(orr_wire_writer *w, const orr_msg_nav_page_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_nav_page(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_nav_page_records_encode(const orr_msg_nav_page_list *piece, orr_wire_writer *w)
{
    put_nav_page_records(w, piece);
    return w->status;
}

static void put_nav_page_list(orr_wire_writer *w, const orr_msg_nav_page_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_nav_page_records(w, list);
}

static void get_nav_page_list(orr_wire_reader *r, orr_msg_nav_page_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_nav_page record;
        memset(&record, 0, sizeof record);
        get_nav_page(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_nav_page_next(const orr_msg_nav_page_list *list, orr_wire_iter *it, orr_msg_nav_page *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_nav_page(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_sat_navdata(orr_wire_writer *w, const orr_msg_sat_navdata *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 5);
    if (p == NULL) return;
    store_sat_id(p + 0, &m->sat);
    orr_wire_store_u8(p + 2, m->answer);
    orr_wire_store_u8(p + 3, m->message);
    orr_wire_store_u8(p + 4, m->form);
    orr_wire_put_bytes(w, m->signals, 16);
    p = orr_wire_room(w, 120);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->notes);
    orr_wire_store_i64(p + 4, m->set_from);
    orr_wire_store_i64(p + 12, m->set_to);
    orr_wire_store_i64(p + 20, m->toe);
    orr_wire_store_i64(p + 28, m->toc);
    orr_wire_store_i32(p + 36, m->week);
    orr_wire_store_i16(p + 40, m->iode);
    orr_wire_store_i16(p + 42, m->iodc);
    orr_wire_store_u32(p + 44, m->health);
    orr_wire_store_f64(p + 48, m->accuracy_m);
    orr_wire_store_f64(p + 56, m->fit_rms_m);
    orr_wire_store_f64(p + 64, m->fit_max_m);
    orr_wire_store_f64(p + 72, m->clock_rms_s);
    orr_wire_store_f64(p + 80, m->af0_s);
    orr_wire_store_f64(p + 88, m->af1_sps);
    orr_wire_store_f64(p + 96, m->af2_sps2);
    orr_wire_store_i64(p + 104, m->frame_from);
    orr_wire_store_i64(p + 112, m->frame_to);
    put_kepler_set_list(w, &m->kepler, 1);
    put_glonass_set_list(w, &m->glonass, 1);
    put_nav_page_list(w, &m->pages, 15);
}

static void get_sat_navdata(orr_wire_reader *r, orr_msg_sat_navdata *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 5);
    if (p == NULL) return;
    load_sat_id(p + 0, &m->sat);
    m->answer = orr_wire_load_u8(p + 2);
    m->message = orr_wire_load_u8(p + 3);
    m->form = orr_wire_load_u8(p + 4);
    m->signals = orr_wire_get_bytes(r, 16);
    p = orr_wire_take(r, 120);
    if (p == NULL) return;
    m->notes = orr_wire_load_u32(p + 0);
    m->set_from = orr_wire_load_i64(p + 4);
    m->set_to = orr_wire_load_i64(p + 12);
    m->toe = orr_wire_load_i64(p + 20);
    m->toc = orr_wire_load_i64(p + 28);
    m->week = orr_wire_load_i32(p + 36);
    m->iode = orr_wire_load_i16(p + 40);
    m->iodc = orr_wire_load_i16(p + 42);
    m->health = orr_wire_load_u32(p + 44);
    m->accuracy_m = orr_wire_load_f64(p + 48);
    m->fit_rms_m = orr_wire_load_f64(p + 56);
    m->fit_max_m = orr_wire_load_f64(p + 64);
    m->clock_rms_s = orr_wire_load_f64(p + 72);
    m->af0_s = orr_wire_load_f64(p + 80);
    m->af1_sps = orr_wire_load_f64(p + 88);
    m->af2_sps2 = orr_wire_load_f64(p + 96);
    m->frame_from = orr_wire_load_i64(p + 104);
    m->frame_to = orr_wire_load_i64(p + 112);
    get_kepler_set_list(r, &m->kepler, 1);
    get_glonass_set_list(r, &m->glonass, 1);
    get_nav_page_list(r, &m->pages, 15);
}

static inline void store_sat_delay(uint8_t *p, const orr_msg_sat_delay *m)
{
    store_sat_id(p + 0, &m->sat);
    orr_wire_store_u8(p + 2, m->answer);
    orr_wire_store_u8(p + 3, m->origin);
    orr_wire_store_u8(p + 4, m->flags);
    orr_wire_store_u8(p + 5, m->reserved);
    orr_wire_store_f64(p + 6, m->az_rad);
    orr_wire_store_f64(p + 14, m->el_rad);
    orr_wire_store_f64(p + 22, m->pierce_lat_rad);
    orr_wire_store_f64(p + 30, m->pierce_lon_rad);
    orr_wire_store_f64(p + 38, m->mapping);
    orr_wire_store_f64(p + 46, m->stec_tecu);
    orr_wire_store_f64(p + 54, m->model_stec_tecu);
    orr_wire_store_f64(p + 62, m->delay_m[0]);
    orr_wire_store_f64(p + 70, m->delay_m[1]);
    orr_wire_store_f64(p + 78, m->delay_m[2]);
    orr_wire_store_f64(p + 86, m->delay_m[3]);
    orr_wire_store_f32(p + 94, m->sigma_tecu);
}

static inline void load_sat_delay(const uint8_t *p, orr_msg_sat_delay *m)
{
    load_sat_id(p + 0, &m->sat);
    m->answer = orr_wire_load_u8(p + 2);
    m->origin = orr_wire_load_u8(p + 3);
    m->flags = orr_wire_load_u8(p + 4);
    m->reserved = orr_wire_load_u8(p + 5);
    m->az_rad = orr_wire_load_f64(p + 6);
    m->el_rad = orr_wire_load_f64(p + 14);
    m->pierce_lat_rad = orr_wire_load_f64(p + 22);
    m->pierce_lon_rad = orr_wire_load_f64(p + 30);
    m->mapping = orr_wire_load_f64(p + 38);
    m->stec_tecu = orr_wire_load_f64(p + 46);
    m->model_stec_tecu = orr_wire_load_f64(p + 54);
    m->delay_m[0] = orr_wire_load_f64(p + 62);
    m->delay_m[1] = orr_wire_load_f64(p + 70);
    m->delay_m[2] = orr_wire_load_f64(p + 78);
    m->delay_m[3] = orr_wire_load_f64(p + 86);
    m->sigma_tecu = orr_wire_load_f32(p + 94);
}

static void put_antenna(orr_wire_writer *w, const orr_msg_antenna *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->antenna);
    orr_wire_put_bytes(w, m->name, 64);
    orr_wire_put_bytes(w, m->kind, 20);
    p = orr_wire_room(w, 24);
    if (p == NULL) return;
    orr_wire_store_f64(p + 0, m->pos_m[0]);
    orr_wire_store_f64(p + 8, m->pos_m[1]);
    orr_wire_store_f64(p + 16, m->pos_m[2]);
}

static void get_antenna(orr_wire_reader *r, orr_msg_antenna *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 2);
    if (p == NULL) return;
    m->antenna = orr_wire_load_u16(p + 0);
    m->name = orr_wire_get_bytes(r, 64);
    m->kind = orr_wire_get_bytes(r, 20);
    p = orr_wire_take(r, 24);
    if (p == NULL) return;
    m->pos_m[0] = orr_wire_load_f64(p + 0);
    m->pos_m[1] = orr_wire_load_f64(p + 8);
    m->pos_m[2] = orr_wire_load_f64(p + 16);
}

static void put_signal(orr_wire_writer *w, const orr_msg_signal *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 3);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->signal);
    orr_wire_store_u8(p + 2, m->system);
    orr_wire_put_bytes(w, m->name, 16);
    orr_wire_put_bytes(w, m->observation, 8);
    orr_wire_put_bytes(w, m->modulation, 32);
    orr_wire_put_bytes(w, m->components, 16);
    p = orr_wire_room(w, 32);
    if (p == NULL) return;
    orr_wire_store_f64(p + 0, m->carrier_hz);
    orr_wire_store_f64(p + 8, m->channel_hz);
    orr_wire_store_f64(p + 16, m->chips_per_s);
    orr_wire_store_u64(p + 24, m->chips);
}

static void get_signal(orr_wire_reader *r, orr_msg_signal *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 3);
    if (p == NULL) return;
    m->signal = orr_wire_load_u16(p + 0);
    m->system = orr_wire_load_u8(p + 2);
    m->name = orr_wire_get_bytes(r, 16);
    m->observation = orr_wire_get_bytes(r, 8);
    m->modulation = orr_wire_get_bytes(r, 32);
    m->components = orr_wire_get_bytes(r, 16);
    p = orr_wire_take(r, 32);
    if (p == NULL) return;
    m->carrier_hz = orr_wire_load_f64(p + 0);
    m->channel_hz = orr_wire_load_f64(p + 8);
    m->chips_per_s = orr_wire_load_f64(p + 16);
    m->chips = orr_wire_load_u64(p + 24);
}

static void put_transmitter(orr_wire_writer *w, const orr_msg_transmitter *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 4);
    if (p == NULL) return;
    store_sat_id(p + 0, &m->sat);
    orr_wire_store_i8(p + 2, m->frequency_channel);
    orr_wire_store_u8(p + 3, m->unhealthy);
    orr_wire_put_bytes(w, m->svn, 10);
    orr_wire_put_bytes(w, m->block, 20);
}

static void get_transmitter(orr_wire_reader *r, orr_msg_transmitter *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 4);
    if (p == NULL) return;
    load_sat_id(p + 0, &m->sat);
    m->frequency_channel = orr_wire_load_i8(p + 2);
    m->unhealthy = orr_wire_load_u8(p + 3);
    m->svn = orr_wire_get_bytes(r, 10);
    m->block = orr_wire_get_bytes(r, 20);
}

static inline void store_sat_channel(uint8_t *p, const orr_msg_sat_channel *m)
{
    store_sat_id(p + 0, &m->sat);
    orr_wire_store_u16(p + 2, m->signal);
    orr_wire_store_u32(p + 4, m->flags);
    orr_wire_store_f64(p + 8, m->az_rad);
    orr_wire_store_f64(p + 16, m->el_rad);
    orr_wire_store_f64(p + 24, m->carrier_hz);
    orr_wire_store_f64(p + 32, m->code[0]);
    orr_wire_store_f64(p + 40, m->code[1]);
    orr_wire_store_f64(p + 48, m->code[2]);
    orr_wire_store_f64(p + 56, m->code[3]);
    orr_wire_store_i64(p + 64, m->carrier_cycles);
    orr_wire_store_f64(p + 72, m->carrier[0]);
    orr_wire_store_f64(p + 80, m->carrier[1]);
    orr_wire_store_f64(p + 88, m->carrier[2]);
    orr_wire_store_f64(p + 96, m->carrier[3]);
    orr_wire_store_i64(p + 104, m->transmit);
    orr_wire_store_f64(p + 112, m->transmit_fraction_ns);
    orr_wire_store_f32(p + 120, m->power_dbw);
    orr_wire_store_u16(p + 124, m->echo);
}

static inline void load_sat_channel(const uint8_t *p, orr_msg_sat_channel *m)
{
    load_sat_id(p + 0, &m->sat);
    m->signal = orr_wire_load_u16(p + 2);
    m->flags = orr_wire_load_u32(p + 4);
    m->az_rad = orr_wire_load_f64(p + 8);
    m->el_rad = orr_wire_load_f64(p + 16);
    m->carrier_hz = orr_wire_load_f64(p + 24);
    m->code[0] = orr_wire_load_f64(p + 32);
    m->code[1] = orr_wire_load_f64(p + 40);
    m->code[2] = orr_wire_load_f64(p + 48);
    m->code[3] = orr_wire_load_f64(p + 56);
    m->carrier_cycles = orr_wire_load_i64(p + 64);
    m->carrier[0] = orr_wire_load_f64(p + 72);
    m->carrier[1] = orr_wire_load_f64(p + 80);
    m->carrier[2] = orr_wire_load_f64(p + 88);
    m->carrier[3] = orr_wire_load_f64(p + 96);
    m->transmit = orr_wire_load_i64(p + 104);
    m->transmit_fraction_ns = orr_wire_load_f64(p + 112);
    m->power_dbw = orr_wire_load_f32(p + 120);
    m->echo = orr_wire_load_u16(p + 124);
}

static void put_jammer(orr_wire_writer *w, const orr_msg_jammer *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->number);
    orr_wire_put_bytes(w, m->waveform, 32);
    p = orr_wire_room(w, 52);
    if (p == NULL) return;
    orr_wire_store_f64(p + 0, m->az_rad);
    orr_wire_store_f64(p + 8, m->el_rad);
    orr_wire_store_f64(p + 16, m->range_m);
    orr_wire_store_f64(p + 24, m->range_rate_mps);
    orr_wire_store_f64(p + 32, m->carrier_hz);
    orr_wire_store_f64(p + 40, m->doppler_hz);
    orr_wire_store_f32(p + 48, m->power_dbw);
}

static void get_jammer(orr_wire_reader *r, orr_msg_jammer *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 2);
    if (p == NULL) return;
    m->number = orr_wire_load_u16(p + 0);
    m->waveform = orr_wire_get_bytes(r, 32);
    p = orr_wire_take(r, 52);
    if (p == NULL) return;
    m->az_rad = orr_wire_load_f64(p + 0);
    m->el_rad = orr_wire_load_f64(p + 8);
    m->range_m = orr_wire_load_f64(p + 16);
    m->range_rate_mps = orr_wire_load_f64(p + 24);
    m->carrier_hz = orr_wire_load_f64(p + 32);
    m->doppler_hz = orr_wire_load_f64(p + 40);
    m->power_dbw = orr_wire_load_f32(p + 48);
}

static inline void store_channel_terms(uint8_t *p, const orr_msg_channel_terms *m)
{
    orr_wire_store_f64(p + 0, m->distance_m);
    orr_wire_store_f64(p + 8, m->sagnac_m);
    orr_wire_store_f64(p + 16, m->shapiro_m);
    orr_wire_store_f64(p + 24, m->satellite_clock_m);
    orr_wire_store_f64(p + 32, m->clock_noise_m);
    orr_wire_store_f64(p + 40, m->relativity_m);
    orr_wire_store_f64(p + 48, m->group_delay_m);
    orr_wire_store_f64(p + 56, m->satellite_antenna_m);
    orr_wire_store_f64(p + 64, m->receiver_antenna_m);
    orr_wire_store_f64(p + 72, m->solid_tide_m);
    orr_wire_store_f64(p + 80, m->pole_tide_m);
    orr_wire_store_f64(p + 88, m->ocean_loading_m);
    orr_wire_store_f64(p + 96, m->troposphere_hydrostatic_m);
    orr_wire_store_f64(p + 104, m->troposphere_wet_m);
    orr_wire_store_f64(p + 112, m->turbulence_m);
    orr_wire_store_f64(p + 120, m->ionosphere_m);
    orr_wire_store_f64(p + 128, m->emission_m);
    orr_wire_store_f64(p + 136, m->emission_ionosphere_m);
    orr_wire_store_f64(p + 144, m->wind_up_m);
    orr_wire_store_f64(p + 152, m->phase_bias_m);
    orr_wire_store_f64(p + 160, m->ionosphere_second_m);
    orr_wire_store_f64(p + 168, m->receiver_delay_m);
    orr_wire_store_f64(p + 176, m->residual_code_m);
    orr_wire_store_f64(p + 184, m->residual_carrier_m);
    orr_wire_store_f64(p + 192, m->disturbance_m);
    orr_wire_store_f64(p + 200, m->scintillation_m);
    orr_wire_store_f64(p + 208, m->land_mobile_m);
    orr_wire_store_f64(p + 216, m->echo_m);
    orr_wire_store_f64(p + 224, m->echo_phase_m);
    orr_wire_store_f64(p + 232, m->spoofer_m);
    orr_wire_store_f64(p + 240, m->fault_range_m);
    orr_wire_store_f64(p + 248, m->fault_noise_m);
    orr_wire_store_f64(p + 256, m->fault_clock_m);
    orr_wire_store_f64(p + 264, m->fault_divergence_m);
    orr_wire_store_f64(p + 272, m->fault_orbit_m);
}

static inline void load_channel_terms(const uint8_t *p, orr_msg_channel_terms *m)
{
    m->distance_m = orr_wire_load_f64(p + 0);
    m->sagnac_m = orr_wire_load_f64(p + 8);
    m->shapiro_m = orr_wire_load_f64(p + 16);
    m->satellite_clock_m = orr_wire_load_f64(p + 24);
    m->clock_noise_m = orr_wire_load_f64(p + 32);
    m->relativity_m = orr_wire_load_f64(p + 40);
    m->group_delay_m = orr_wire_load_f64(p + 48);
    m->satellite_antenna_m = orr_wire_load_f64(p + 56);
    m->receiver_antenna_m = orr_wire_load_f64(p + 64);
    m->solid_tide_m = orr_wire_load_f64(p + 72);
    m->pole_tide_m = orr_wire_load_f64(p + 80);
    m->ocean_loading_m = orr_wire_load_f64(p + 88);
    m->troposphere_hydrostatic_m = orr_wire_load_f64(p + 96);
    m->troposphere_wet_m = orr_wire_load_f64(p + 104);
    m->turbulence_m = orr_wire_load_f64(p + 112);
    m->ionosphere_m = orr_wire_load_f64(p + 120);
    m->emission_m = orr_wire_load_f64(p + 128);
    m->emission_ionosphere_m = orr_wire_load_f64(p + 136);
    m->wind_up_m = orr_wire_load_f64(p + 144);
    m->phase_bias_m = orr_wire_load_f64(p + 152);
    m->ionosphere_second_m = orr_wire_load_f64(p + 160);
    m->receiver_delay_m = orr_wire_load_f64(p + 168);
    m->residual_code_m = orr_wire_load_f64(p + 176);
    m->residual_carrier_m = orr_wire_load_f64(p + 184);
    m->disturbance_m = orr_wire_load_f64(p + 192);
    m->scintillation_m = orr_wire_load_f64(p + 200);
    m->land_mobile_m = orr_wire_load_f64(p + 208);
    m->echo_m = orr_wire_load_f64(p + 216);
    m->echo_phase_m = orr_wire_load_f64(p + 224);
    m->spoofer_m = orr_wire_load_f64(p + 232);
    m->fault_range_m = orr_wire_load_f64(p + 240);
    m->fault_noise_m = orr_wire_load_f64(p + 248);
    m->fault_clock_m = orr_wire_load_f64(p + 256);
    m->fault_divergence_m = orr_wire_load_f64(p + 264);
    m->fault_orbit_m = orr_wire_load_f64(p + 272);
}

static inline void store_event(uint8_t *p, const orr_msg_event *m)
{
    orr_wire_store_i64(p + 0, m->at);
    orr_wire_store_u8(p + 8, m->kind);
    store_sat_id(p + 9, &m->sat);
    orr_wire_store_u8(p + 11, m->message);
    orr_wire_store_u16(p + 12, m->antenna);
    orr_wire_store_i64(p + 14, m->value);
}

static inline void load_event(const uint8_t *p, orr_msg_event *m)
{
    m->at = orr_wire_load_i64(p + 0);
    m->kind = orr_wire_load_u8(p + 8);
    load_sat_id(p + 9, &m->sat);
    m->message = orr_wire_load_u8(p + 11);
    m->antenna = orr_wire_load_u16(p + 12);
    m->value = orr_wire_load_i64(p + 14);
}

static inline void store_mode_change(uint8_t *p, const orr_msg_mode_change *m)
{
    orr_wire_store_u64(p + 0, m->number);
    orr_wire_store_i64(p + 8, m->at);
    orr_wire_store_u8(p + 16, m->kind);
    orr_wire_store_u8(p + 17, m->before);
    orr_wire_store_u8(p + 18, m->mode);
    orr_wire_store_u8(p + 19, m->reserved);
    orr_wire_store_i64(p + 20, m->wall);
}

static inline void load_mode_change(const uint8_t *p, orr_msg_mode_change *m)
{
    m->number = orr_wire_load_u64(p + 0);
    m->at = orr_wire_load_i64(p + 8);
    m->kind = orr_wire_load_u8(p + 16);
    m->before = orr_wire_load_u8(p + 17);
    m->mode = orr_wire_load_u8(p + 18);
    m->reserved = orr_wire_load_u8(p + 19);
    m->wall = orr_wire_load_i64(p + 20);
}

static void put_hello(orr_wire_writer *w, const orr_msg_hello *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u8(p + 0, m->major_min);
    orr_wire_store_u8(p + 1, m->major_max);
    orr_wire_put_bytes(w, m->name, 64);
    orr_wire_put_bytes(w, m->version, 32);
}

static void get_hello(orr_wire_reader *r, orr_msg_hello *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 2);
    if (p == NULL) return;
    m->major_min = orr_wire_load_u8(p + 0);
    m->major_max = orr_wire_load_u8(p + 1);
    m->name = orr_wire_get_bytes(r, 64);
    m->version = orr_wire_get_bytes(r, 32);
}

orr_wire_status orr_msg_hello_encode(const orr_msg_hello *m, orr_wire_writer *w)
{
    put_hello(w, m);
    return w->status;
}

orr_wire_status orr_msg_hello_decode(const uint8_t *payload, size_t size, orr_msg_hello *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_hello(&r, m);
    return r.status;
}

static void put_inertial_unit_records(orr_wire_writer *w, const orr_msg_inertial_unit_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_inertial_unit(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_inertial_unit_records_encode(const orr_msg_inertial_unit_list *piece, orr_wire_writer *w)
{
    put_inertial_unit_records(w, piece);
    return w->status;
}

static void put_inertial_unit_list(orr_wire_writer *w, const orr_msg_inertial_unit_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_inertial_unit_records(w, list);
}

static void get_inertial_unit_list(orr_wire_reader *r, orr_msg_inertial_unit_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_inertial_unit record;
        memset(&record, 0, sizeof record);
        get_inertial_unit(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_inertial_unit_next(const orr_msg_inertial_unit_list *list, orr_wire_iter *it, orr_msg_inertial_unit *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_inertial_unit(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_antenna_records(orr_wire_writer *w, const orr_msg_antenna_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_antenna(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_antenna_records_encode(const orr_msg_antenna_list *piece, orr_wire_writer *w)
{
    put_antenna_records(w, piece);
    return w->status;
}

static void put_antenna_list(orr_wire_writer *w, const orr_msg_antenna_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_antenna_records(w, list);
}

static void get_antenna_list(orr_wire_reader *r, orr_msg_antenna_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_antenna record;
        memset(&record, 0, sizeof record);
        get_antenna(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_antenna_next(const orr_msg_antenna_list *list, orr_wire_iter *it, orr_msg_antenna *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_antenna(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_signal_records(orr_wire_writer *w, const orr_msg_signal_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_signal(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_signal_records_encode(const orr_msg_signal_list *piece, orr_wire_writer *w)
{
    put_signal_records(w, piece);
    return w->status;
}

static void put_signal_list(orr_wire_writer *w, const orr_msg_signal_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_signal_records(w, list);
}

static void get_signal_list(orr_wire_reader *r, orr_msg_signal_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_signal record;
        memset(&record, 0, sizeof record);
        get_signal(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_signal_next(const orr_msg_signal_list *list, orr_wire_iter *it, orr_msg_signal *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_signal(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_transmitter_records(orr_wire_writer *w, const orr_msg_transmitter_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_transmitter(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_transmitter_records_encode(const orr_msg_transmitter_list *piece, orr_wire_writer *w)
{
    put_transmitter_records(w, piece);
    return w->status;
}

static void put_transmitter_list(orr_wire_writer *w, const orr_msg_transmitter_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_transmitter_records(w, list);
}

static void get_transmitter_list(orr_wire_reader *r, orr_msg_transmitter_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_transmitter record;
        memset(&record, 0, sizeof record);
        get_transmitter(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_transmitter_next(const orr_msg_transmitter_list *list, orr_wire_iter *it, orr_msg_transmitter *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_transmitter(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_served_request_records(orr_wire_writer *w, const orr_msg_served_request_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 20 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_served_request(p + 20 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_served_request_records_encode(const orr_msg_served_request_list *piece, orr_wire_writer *w)
{
    put_served_request_records(w, piece);
    return w->status;
}

static void put_served_request_list(orr_wire_writer *w, const orr_msg_served_request_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 20 : list->wire.stride);
    put_served_request_records(w, list);
}

static void get_served_request_list(orr_wire_reader *r, orr_msg_served_request_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 20) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_served_request_next(const orr_msg_served_request_list *list, orr_wire_iter *it, orr_msg_served_request *out)
{
    return orr_msg_served_request_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_served_request_at(const orr_msg_served_request_list *list, uint16_t index, orr_msg_served_request *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_served_request(p, out);
    return true;
}

static void put_sat_id_records(orr_wire_writer *w, const orr_msg_sat_id_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 2 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_sat_id(p + 2 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_sat_id_records_encode(const orr_msg_sat_id_list *piece, orr_wire_writer *w)
{
    put_sat_id_records(w, piece);
    return w->status;
}

static void put_sat_id_list(orr_wire_writer *w, const orr_msg_sat_id_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 2 : list->wire.stride);
    put_sat_id_records(w, list);
}

static void get_sat_id_list(orr_wire_reader *r, orr_msg_sat_id_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 2) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_sat_id_next(const orr_msg_sat_id_list *list, orr_wire_iter *it, orr_msg_sat_id *out)
{
    return orr_msg_sat_id_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_sat_id_at(const orr_msg_sat_id_list *list, uint16_t index, orr_msg_sat_id *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_sat_id(p, out);
    return true;
}

static void put_caps(orr_wire_writer *w, const orr_msg_caps *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 26);
    if (p == NULL) return;
    orr_wire_store_u8(p + 0, m->major);
    orr_wire_store_u8(p + 1, m->minor);
    orr_wire_store_u32(p + 2, m->max_request);
    orr_wire_store_u32(p + 6, m->max_epochs);
    store_span(p + 10, &m->span);
    orr_wire_put_bytes(w, m->name, 64);
    orr_wire_put_bytes(w, m->version, 32);
    orr_wire_put_bytes(w, m->title, 128);
    orr_wire_put_bytes(w, m->frame, 64);
    p = orr_wire_room(w, 48);
    if (p == NULL) return;
    store_leap_seconds(p + 0, &m->leap);
    orr_wire_store_u8(p + 12, m->navdata_point);
    orr_wire_store_u8(p + 13, m->receiver_source);
    orr_wire_store_u16(p + 14, m->receiver_unit);
    orr_wire_store_f64(p + 16, m->receiver_m[0]);
    orr_wire_store_f64(p + 24, m->receiver_m[1]);
    orr_wire_store_f64(p + 32, m->receiver_m[2]);
    orr_wire_store_f64(p + 40, m->imu_rate_hz);
    put_inertial_unit_list(w, &m->units, 64);
    put_antenna_list(w, &m->antennas, 16);
    put_signal_list(w, &m->signals, 64);
    put_transmitter_list(w, &m->transmitters, 800);
    put_served_request_list(w, &m->requests, 64);
    put_sat_id_list(w, &m->satellites, 800);
    p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->access);
}

static void get_caps(orr_wire_reader *r, orr_msg_caps *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 26);
    if (p == NULL) return;
    m->major = orr_wire_load_u8(p + 0);
    m->minor = orr_wire_load_u8(p + 1);
    m->max_request = orr_wire_load_u32(p + 2);
    m->max_epochs = orr_wire_load_u32(p + 6);
    load_span(p + 10, &m->span);
    m->name = orr_wire_get_bytes(r, 64);
    m->version = orr_wire_get_bytes(r, 32);
    m->title = orr_wire_get_bytes(r, 128);
    m->frame = orr_wire_get_bytes(r, 64);
    p = orr_wire_take(r, 48);
    if (p == NULL) return;
    load_leap_seconds(p + 0, &m->leap);
    m->navdata_point = orr_wire_load_u8(p + 12);
    m->receiver_source = orr_wire_load_u8(p + 13);
    m->receiver_unit = orr_wire_load_u16(p + 14);
    m->receiver_m[0] = orr_wire_load_f64(p + 16);
    m->receiver_m[1] = orr_wire_load_f64(p + 24);
    m->receiver_m[2] = orr_wire_load_f64(p + 32);
    m->imu_rate_hz = orr_wire_load_f64(p + 40);
    get_inertial_unit_list(r, &m->units, 64);
    get_antenna_list(r, &m->antennas, 16);
    get_signal_list(r, &m->signals, 64);
    get_transmitter_list(r, &m->transmitters, 800);
    get_served_request_list(r, &m->requests, 64);
    get_sat_id_list(r, &m->satellites, 800);
    p = orr_wire_take(r, 2);
    if (p == NULL) return;
    m->access = orr_wire_load_u16(p + 0);
}

orr_wire_status orr_msg_caps_encode(const orr_msg_caps *m, orr_wire_writer *w)
{
    put_caps(w, m);
    return w->status;
}

orr_wire_status orr_msg_caps_decode(const uint8_t *payload, size_t size, orr_msg_caps *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_caps(&r, m);
    return r.status;
}

static void put_ping(orr_wire_writer *w, const orr_msg_ping *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 8);
    if (p == NULL) return;
    orr_wire_store_u64(p + 0, m->token);
}

static void get_ping(orr_wire_reader *r, orr_msg_ping *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 8);
    if (p == NULL) return;
    m->token = orr_wire_load_u64(p + 0);
}

orr_wire_status orr_msg_ping_encode(const orr_msg_ping *m, orr_wire_writer *w)
{
    put_ping(w, m);
    return w->status;
}

orr_wire_status orr_msg_ping_decode(const uint8_t *payload, size_t size, orr_msg_ping *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_ping(&r, m);
    return r.status;
}

static void put_pong(orr_wire_writer *w, const orr_msg_pong *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 8);
    if (p == NULL) return;
    orr_wire_store_u64(p + 0, m->token);
}

static void get_pong(orr_wire_reader *r, orr_msg_pong *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 8);
    if (p == NULL) return;
    m->token = orr_wire_load_u64(p + 0);
}

orr_wire_status orr_msg_pong_encode(const orr_msg_pong *m, orr_wire_writer *w)
{
    put_pong(w, m);
    return w->status;
}

orr_wire_status orr_msg_pong_decode(const uint8_t *payload, size_t size, orr_msg_pong *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_pong(&r, m);
    return r.status;
}

static void put_error(orr_wire_writer *w, const orr_msg_error *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->code);
    orr_wire_store_u16(p + 2, m->request);
    orr_wire_put_bytes(w, m->sentence, 512);
}

static void get_error(orr_wire_reader *r, orr_msg_error *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 4);
    if (p == NULL) return;
    m->code = orr_wire_load_u16(p + 0);
    m->request = orr_wire_load_u16(p + 2);
    m->sentence = orr_wire_get_bytes(r, 512);
}

orr_wire_status orr_msg_error_encode(const orr_msg_error *m, orr_wire_writer *w)
{
    put_error(w, m);
    return w->status;
}

orr_wire_status orr_msg_error_decode(const uint8_t *payload, size_t size, orr_msg_error *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_error(&r, m);
    return r.status;
}

static void put_poll(orr_wire_writer *w, const orr_msg_poll *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 20);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    put_sat_id_list(w, &m->satellites, 800);
}

static void get_poll(orr_wire_reader *r, orr_msg_poll *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 20);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    get_sat_id_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_poll_encode(const orr_msg_poll *m, orr_wire_writer *w)
{
    put_poll(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_decode(const uint8_t *payload, size_t size, orr_msg_poll *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll(&r, m);
    return r.status;
}

static void put_sat_state_records(orr_wire_writer *w, const orr_msg_sat_state_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 120 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_sat_state(p + 120 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_sat_state_records_encode(const orr_msg_sat_state_list *piece, orr_wire_writer *w)
{
    put_sat_state_records(w, piece);
    return w->status;
}

static void put_sat_state_list(orr_wire_writer *w, const orr_msg_sat_state_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 120 : list->wire.stride);
    put_sat_state_records(w, list);
}

static void get_sat_state_list(orr_wire_reader *r, orr_msg_sat_state_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 120) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_sat_state_next(const orr_msg_sat_state_list *list, orr_wire_iter *it, orr_msg_sat_state *out)
{
    return orr_msg_sat_state_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_sat_state_at(const orr_msg_sat_state_list *list, uint16_t index, orr_msg_sat_state *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_sat_state(p, out);
    return true;
}

static void put_states(orr_wire_writer *w, const orr_msg_states *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 17);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    put_sat_state_list(w, &m->satellites, 800);
}

static void get_states(orr_wire_reader *r, orr_msg_states *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 17);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    get_sat_state_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_states_encode(const orr_msg_states *m, orr_wire_writer *w)
{
    put_states(w, m);
    return w->status;
}

orr_wire_status orr_msg_states_decode(const uint8_t *payload, size_t size, orr_msg_states *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_states(&r, m);
    return r.status;
}

static void put_poll_elements(orr_wire_writer *w, const orr_msg_poll_elements *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 22);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    orr_wire_store_u8(p + 20, m->frame);
    orr_wire_store_u8(p + 21, m->method);
    put_sat_id_list(w, &m->satellites, 800);
}

static void get_poll_elements(orr_wire_reader *r, orr_msg_poll_elements *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 22);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    m->frame = orr_wire_load_u8(p + 20);
    m->method = orr_wire_load_u8(p + 21);
    get_sat_id_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_poll_elements_encode(const orr_msg_poll_elements *m, orr_wire_writer *w)
{
    put_poll_elements(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_elements_decode(const uint8_t *payload, size_t size, orr_msg_poll_elements *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_elements(&r, m);
    return r.status;
}

static void put_sat_elements_records(orr_wire_writer *w, const orr_msg_sat_elements_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 64 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_sat_elements(p + 64 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_sat_elements_records_encode(const orr_msg_sat_elements_list *piece, orr_wire_writer *w)
{
    put_sat_elements_records(w, piece);
    return w->status;
}

static void put_sat_elements_list(orr_wire_writer *w, const orr_msg_sat_elements_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 64 : list->wire.stride);
    put_sat_elements_records(w, list);
}

static void get_sat_elements_list(orr_wire_reader *r, orr_msg_sat_elements_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 64) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_sat_elements_next(const orr_msg_sat_elements_list *list, orr_wire_iter *it, orr_msg_sat_elements *out)
{
    return orr_msg_sat_elements_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_sat_elements_at(const orr_msg_sat_elements_list *list, uint16_t index, orr_msg_sat_elements *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_sat_elements(p, out);
    return true;
}

static void put_elements(orr_wire_writer *w, const orr_msg_elements *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 19);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    orr_wire_store_u8(p + 17, m->frame);
    orr_wire_store_u8(p + 18, m->method);
    put_sat_elements_list(w, &m->satellites, 800);
}

static void get_elements(orr_wire_reader *r, orr_msg_elements *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 19);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    m->frame = orr_wire_load_u8(p + 17);
    m->method = orr_wire_load_u8(p + 18);
    get_sat_elements_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_elements_encode(const orr_msg_elements *m, orr_wire_writer *w)
{
    put_elements(w, m);
    return w->status;
}

orr_wire_status orr_msg_elements_decode(const uint8_t *payload, size_t size, orr_msg_elements *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_elements(&r, m);
    return r.status;
}

static void put_poll_navdata(orr_wire_writer *w, const orr_msg_poll_navdata *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 20);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    put_sat_id_list(w, &m->satellites, 800);
    p = orr_wire_room(w, 5);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->kinds);
    orr_wire_store_u8(p + 4, m->form);
}

static void get_poll_navdata(orr_wire_reader *r, orr_msg_poll_navdata *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 20);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    get_sat_id_list(r, &m->satellites, 800);
    p = orr_wire_take(r, 5);
    if (p == NULL) return;
    m->kinds = orr_wire_load_u32(p + 0);
    m->form = orr_wire_load_u8(p + 4);
}

orr_wire_status orr_msg_poll_navdata_encode(const orr_msg_poll_navdata *m, orr_wire_writer *w)
{
    put_poll_navdata(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_navdata_decode(const uint8_t *payload, size_t size, orr_msg_poll_navdata *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_navdata(&r, m);
    return r.status;
}

static void put_sat_navdata_records(orr_wire_writer *w, const orr_msg_sat_navdata_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_sat_navdata(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_sat_navdata_records_encode(const orr_msg_sat_navdata_list *piece, orr_wire_writer *w)
{
    put_sat_navdata_records(w, piece);
    return w->status;
}

static void put_sat_navdata_list(orr_wire_writer *w, const orr_msg_sat_navdata_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_sat_navdata_records(w, list);
}

static void get_sat_navdata_list(orr_wire_reader *r, orr_msg_sat_navdata_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_sat_navdata record;
        memset(&record, 0, sizeof record);
        get_sat_navdata(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_sat_navdata_next(const orr_msg_sat_navdata_list *list, orr_wire_iter *it, orr_msg_sat_navdata *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_sat_navdata(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_navdata(orr_wire_writer *w, const orr_msg_navdata *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 17);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    put_sat_navdata_list(w, &m->satellites, 800);
}

static void get_navdata(orr_wire_reader *r, orr_msg_navdata *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 17);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    get_sat_navdata_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_navdata_encode(const orr_msg_navdata *m, orr_wire_writer *w)
{
    put_navdata(w, m);
    return w->status;
}

orr_wire_status orr_msg_navdata_decode(const uint8_t *payload, size_t size, orr_msg_navdata *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_navdata(&r, m);
    return r.status;
}

static void put_f64_records(orr_wire_writer *w, const orr_msg_f64_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 8 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) orr_wire_store_f64(p + 8 * (size_t)i, list->item[i]);
}

static void put_f64_list(orr_wire_writer *w, const orr_msg_f64_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 8 : list->wire.stride);
    put_f64_records(w, list);
}

static void get_f64_list(orr_wire_reader *r, orr_msg_f64_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 8) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_f64_next(const orr_msg_f64_list *list, orr_wire_iter *it, double *out)
{
    return orr_msg_f64_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_f64_at(const orr_msg_f64_list *list, uint16_t index, double *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    *out = orr_wire_load_f64(p);
    return true;
}

static void put_poll_delays(orr_wire_writer *w, const orr_msg_poll_delays *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 44);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    orr_wire_store_f64(p + 20, m->receiver_m[0]);
    orr_wire_store_f64(p + 28, m->receiver_m[1]);
    orr_wire_store_f64(p + 36, m->receiver_m[2]);
    put_f64_list(w, &m->carriers_hz, 4);
    put_sat_id_list(w, &m->satellites, 800);
}

static void get_poll_delays(orr_wire_reader *r, orr_msg_poll_delays *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 44);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    m->receiver_m[0] = orr_wire_load_f64(p + 20);
    m->receiver_m[1] = orr_wire_load_f64(p + 28);
    m->receiver_m[2] = orr_wire_load_f64(p + 36);
    get_f64_list(r, &m->carriers_hz, 4);
    get_sat_id_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_poll_delays_encode(const orr_msg_poll_delays *m, orr_wire_writer *w)
{
    put_poll_delays(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_delays_decode(const uint8_t *payload, size_t size, orr_msg_poll_delays *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_delays(&r, m);
    return r.status;
}

static void put_sat_delay_records(orr_wire_writer *w, const orr_msg_sat_delay_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 98 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_sat_delay(p + 98 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_sat_delay_records_encode(const orr_msg_sat_delay_list *piece, orr_wire_writer *w)
{
    put_sat_delay_records(w, piece);
    return w->status;
}

static void put_sat_delay_list(orr_wire_writer *w, const orr_msg_sat_delay_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 98 : list->wire.stride);
    put_sat_delay_records(w, list);
}

static void get_sat_delay_list(orr_wire_reader *r, orr_msg_sat_delay_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 98) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_sat_delay_next(const orr_msg_sat_delay_list *list, orr_wire_iter *it, orr_msg_sat_delay *out)
{
    return orr_msg_sat_delay_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_sat_delay_at(const orr_msg_sat_delay_list *list, uint16_t index, orr_msg_sat_delay *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_sat_delay(p, out);
    return true;
}

static void put_delays(orr_wire_writer *w, const orr_msg_delays *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 41);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    orr_wire_store_f64(p + 17, m->receiver_m[0]);
    orr_wire_store_f64(p + 25, m->receiver_m[1]);
    orr_wire_store_f64(p + 33, m->receiver_m[2]);
    put_f64_list(w, &m->carriers_hz, 4);
    put_sat_delay_list(w, &m->satellites, 800);
}

static void get_delays(orr_wire_reader *r, orr_msg_delays *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 41);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    m->receiver_m[0] = orr_wire_load_f64(p + 17);
    m->receiver_m[1] = orr_wire_load_f64(p + 25);
    m->receiver_m[2] = orr_wire_load_f64(p + 33);
    get_f64_list(r, &m->carriers_hz, 4);
    get_sat_delay_list(r, &m->satellites, 800);
}

orr_wire_status orr_msg_delays_encode(const orr_msg_delays *m, orr_wire_writer *w)
{
    put_delays(w, m);
    return w->status;
}

orr_wire_status orr_msg_delays_decode(const uint8_t *payload, size_t size, orr_msg_delays *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_delays(&r, m);
    return r.status;
}

static void put_u16_records(orr_wire_writer *w, const orr_msg_u16_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 2 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) orr_wire_store_u16(p + 2 * (size_t)i, list->item[i]);
}

static void put_u16_list(orr_wire_writer *w, const orr_msg_u16_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 2 : list->wire.stride);
    put_u16_records(w, list);
}

static void get_u16_list(orr_wire_reader *r, orr_msg_u16_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 2) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_u16_next(const orr_msg_u16_list *list, orr_wire_iter *it, uint16_t *out)
{
    return orr_msg_u16_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_u16_at(const orr_msg_u16_list *list, uint16_t index, uint16_t *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    *out = orr_wire_load_u16(p);
    return true;
}

static void put_poll_channels(orr_wire_writer *w, const orr_msg_poll_channels *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 24);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    orr_wire_store_u16(p + 20, m->antenna);
    orr_wire_store_u16(p + 22, m->terms);
    put_u16_list(w, &m->signals, 64);
}

static void get_poll_channels(orr_wire_reader *r, orr_msg_poll_channels *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 24);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    m->antenna = orr_wire_load_u16(p + 20);
    m->terms = orr_wire_load_u16(p + 22);
    get_u16_list(r, &m->signals, 64);
}

orr_wire_status orr_msg_poll_channels_encode(const orr_msg_poll_channels *m, orr_wire_writer *w)
{
    put_poll_channels(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_channels_decode(const uint8_t *payload, size_t size, orr_msg_poll_channels *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_channels(&r, m);
    return r.status;
}

static void put_sat_channel_records(orr_wire_writer *w, const orr_msg_sat_channel_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 126 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_sat_channel(p + 126 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_sat_channel_records_encode(const orr_msg_sat_channel_list *piece, orr_wire_writer *w)
{
    put_sat_channel_records(w, piece);
    return w->status;
}

static void put_sat_channel_list(orr_wire_writer *w, const orr_msg_sat_channel_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 126 : list->wire.stride);
    put_sat_channel_records(w, list);
}

static void get_sat_channel_list(orr_wire_reader *r, orr_msg_sat_channel_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 126) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_sat_channel_next(const orr_msg_sat_channel_list *list, orr_wire_iter *it, orr_msg_sat_channel *out)
{
    return orr_msg_sat_channel_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_sat_channel_at(const orr_msg_sat_channel_list *list, uint16_t index, orr_msg_sat_channel *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_sat_channel(p, out);
    return true;
}

static void put_channel_terms_records(orr_wire_writer *w, const orr_msg_channel_terms_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 280 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_channel_terms(p + 280 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_channel_terms_records_encode(const orr_msg_channel_terms_list *piece, orr_wire_writer *w)
{
    put_channel_terms_records(w, piece);
    return w->status;
}

static void put_channel_terms_list(orr_wire_writer *w, const orr_msg_channel_terms_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 280 : list->wire.stride);
    put_channel_terms_records(w, list);
}

static void get_channel_terms_list(orr_wire_reader *r, orr_msg_channel_terms_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 280) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_channel_terms_next(const orr_msg_channel_terms_list *list, orr_wire_iter *it, orr_msg_channel_terms *out)
{
    return orr_msg_channel_terms_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_channel_terms_at(const orr_msg_channel_terms_list *list, uint16_t index, orr_msg_channel_terms *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_channel_terms(p, out);
    return true;
}

static void put_jammer_records(orr_wire_writer *w, const orr_msg_jammer_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    for (uint16_t i = 0; i < list->count; i++) {
        size_t start = w->size;
        if (orr_wire_room(w, 2) == NULL) return;
        put_jammer(w, &list->item[i]);
        if (w->status != ORR_WIRE_OK) return;
        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));
    }
}

orr_wire_status orr_msg_jammer_records_encode(const orr_msg_jammer_list *piece, orr_wire_writer *w)
{
    put_jammer_records(w, piece);
    return w->status;
}

static void put_jammer_list(orr_wire_writer *w, const orr_msg_jammer_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    put_jammer_records(w, list);
}

static void get_jammer_list(orr_wire_reader *r, orr_msg_jammer_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    size_t start = r->at;
    p = r->data + r->at;
    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail
        const uint8_t *q = orr_wire_take(r, 2);
        if (q == NULL) return;
        uint16_t size = orr_wire_load_u16(q);
        q = orr_wire_take(r, size);
        if (q == NULL) return;
        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};
        orr_msg_jammer record;
        memset(&record, 0, sizeof record);
        get_jammer(&one, &record);
        if (one.status != ORR_WIRE_OK) {
            r->status = one.status;
            return;
        }
    }
    list->wire.size = r->at - start;
    list->wire.stride = 0;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_jammer_next(const orr_msg_jammer_list *list, orr_wire_iter *it, orr_msg_jammer *out)
{
    if (it->index >= list->count) return false;
    memset(out, 0, sizeof *out);
    if (list->item != NULL) {
        *out = list->item[it->index++];
        return true;
    }
    const uint8_t *p = list->wire.data + it->at;
    uint16_t size = orr_wire_load_u16(p);
    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};
    get_jammer(&one, out);
    it->at += (size_t)2 + size;
    it->index++;
    return one.status == ORR_WIRE_OK;
}

static void put_channels(orr_wire_writer *w, const orr_msg_channels *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 100);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    orr_wire_store_u16(p + 17, m->antenna);
    orr_wire_store_i64(p + 19, m->block);
    orr_wire_store_i64(p + 27, m->length);
    orr_wire_store_f64(p + 35, m->error_m);
    orr_wire_store_f64(p + 43, m->pos_m[0]);
    orr_wire_store_f64(p + 51, m->pos_m[1]);
    orr_wire_store_f64(p + 59, m->pos_m[2]);
    orr_wire_store_f64(p + 67, m->vel_mps[0]);
    orr_wire_store_f64(p + 75, m->vel_mps[1]);
    orr_wire_store_f64(p + 83, m->vel_mps[2]);
    orr_wire_store_u8(p + 91, m->motion);
    orr_wire_store_i64(p + 92, m->motion_age);
    put_sat_channel_list(w, &m->channels, 4096);
    put_channel_terms_list(w, &m->terms, 4096);
    put_jammer_list(w, &m->jammers, 16);
}

static void get_channels(orr_wire_reader *r, orr_msg_channels *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 100);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    m->antenna = orr_wire_load_u16(p + 17);
    m->block = orr_wire_load_i64(p + 19);
    m->length = orr_wire_load_i64(p + 27);
    m->error_m = orr_wire_load_f64(p + 35);
    m->pos_m[0] = orr_wire_load_f64(p + 43);
    m->pos_m[1] = orr_wire_load_f64(p + 51);
    m->pos_m[2] = orr_wire_load_f64(p + 59);
    m->vel_mps[0] = orr_wire_load_f64(p + 67);
    m->vel_mps[1] = orr_wire_load_f64(p + 75);
    m->vel_mps[2] = orr_wire_load_f64(p + 83);
    m->motion = orr_wire_load_u8(p + 91);
    m->motion_age = orr_wire_load_i64(p + 92);
    get_sat_channel_list(r, &m->channels, 4096);
    get_channel_terms_list(r, &m->terms, 4096);
    get_jammer_list(r, &m->jammers, 16);
}

orr_wire_status orr_msg_channels_encode(const orr_msg_channels *m, orr_wire_writer *w)
{
    put_channels(w, m);
    return w->status;
}

orr_wire_status orr_msg_channels_decode(const uint8_t *payload, size_t size, orr_msg_channels *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_channels(&r, m);
    return r.status;
}

static void put_poll_imu(orr_wire_writer *w, const orr_msg_poll_imu *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 22);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    orr_wire_store_u16(p + 20, m->unit);
}

static void get_poll_imu(orr_wire_reader *r, orr_msg_poll_imu *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 22);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    m->unit = orr_wire_load_u16(p + 20);
}

orr_wire_status orr_msg_poll_imu_encode(const orr_msg_poll_imu *m, orr_wire_writer *w)
{
    put_poll_imu(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_imu_decode(const uint8_t *payload, size_t size, orr_msg_poll_imu *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_imu(&r, m);
    return r.status;
}

static void put_imu(orr_wire_writer *w, const orr_msg_imu *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 76);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    orr_wire_store_i64(p + 17, m->t1);
    orr_wire_store_u16(p + 25, m->unit);
    orr_wire_store_u8(p + 27, m->readings);
    orr_wire_store_f64(p + 28, m->dtheta_rad[0]);
    orr_wire_store_f64(p + 36, m->dtheta_rad[1]);
    orr_wire_store_f64(p + 44, m->dtheta_rad[2]);
    orr_wire_store_f64(p + 52, m->dv_mps[0]);
    orr_wire_store_f64(p + 60, m->dv_mps[1]);
    orr_wire_store_f64(p + 68, m->dv_mps[2]);
}

static void get_imu(orr_wire_reader *r, orr_msg_imu *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 76);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    m->t1 = orr_wire_load_i64(p + 17);
    m->unit = orr_wire_load_u16(p + 25);
    m->readings = orr_wire_load_u8(p + 27);
    m->dtheta_rad[0] = orr_wire_load_f64(p + 28);
    m->dtheta_rad[1] = orr_wire_load_f64(p + 36);
    m->dtheta_rad[2] = orr_wire_load_f64(p + 44);
    m->dv_mps[0] = orr_wire_load_f64(p + 52);
    m->dv_mps[1] = orr_wire_load_f64(p + 60);
    m->dv_mps[2] = orr_wire_load_f64(p + 68);
}

orr_wire_status orr_msg_imu_encode(const orr_msg_imu *m, orr_wire_writer *w)
{
    put_imu(w, m);
    return w->status;
}

orr_wire_status orr_msg_imu_decode(const uint8_t *payload, size_t size, orr_msg_imu *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_imu(&r, m);
    return r.status;
}

static void put_poll_truth(orr_wire_writer *w, const orr_msg_poll_truth *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 22);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
    orr_wire_store_u16(p + 20, m->unit);
}

static void get_poll_truth(orr_wire_reader *r, orr_msg_poll_truth *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 22);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
    m->unit = orr_wire_load_u16(p + 20);
}

orr_wire_status orr_msg_poll_truth_encode(const orr_msg_poll_truth *m, orr_wire_writer *w)
{
    put_poll_truth(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_truth_decode(const uint8_t *payload, size_t size, orr_msg_poll_truth *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_truth(&r, m);
    return r.status;
}

static void put_truth(orr_wire_writer *w, const orr_msg_truth *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 219);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    orr_wire_store_u16(p + 17, m->unit);
    orr_wire_store_f64(p + 19, m->pos_m[0]);
    orr_wire_store_f64(p + 27, m->pos_m[1]);
    orr_wire_store_f64(p + 35, m->pos_m[2]);
    orr_wire_store_f64(p + 43, m->vel_mps[0]);
    orr_wire_store_f64(p + 51, m->vel_mps[1]);
    orr_wire_store_f64(p + 59, m->vel_mps[2]);
    orr_wire_store_f64(p + 67, m->acc_mps2[0]);
    orr_wire_store_f64(p + 75, m->acc_mps2[1]);
    orr_wire_store_f64(p + 83, m->acc_mps2[2]);
    orr_wire_store_f64(p + 91, m->attitude[0]);
    orr_wire_store_f64(p + 99, m->attitude[1]);
    orr_wire_store_f64(p + 107, m->attitude[2]);
    orr_wire_store_f64(p + 115, m->attitude[3]);
    orr_wire_store_f64(p + 123, m->heading_rad);
    orr_wire_store_f64(p + 131, m->pitch_rad);
    orr_wire_store_f64(p + 139, m->roll_rad);
    orr_wire_store_f64(p + 147, m->rate_radps[0]);
    orr_wire_store_f64(p + 155, m->rate_radps[1]);
    orr_wire_store_f64(p + 163, m->rate_radps[2]);
    orr_wire_store_f64(p + 171, m->force_mps2[0]);
    orr_wire_store_f64(p + 179, m->force_mps2[1]);
    orr_wire_store_f64(p + 187, m->force_mps2[2]);
    orr_wire_store_f64(p + 195, m->disturbance_mgal);
    orr_wire_store_f64(p + 203, m->eotvos_mgal);
    orr_wire_store_f64(p + 211, m->vertical_mps2);
}

static void get_truth(orr_wire_reader *r, orr_msg_truth *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 219);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    m->unit = orr_wire_load_u16(p + 17);
    m->pos_m[0] = orr_wire_load_f64(p + 19);
    m->pos_m[1] = orr_wire_load_f64(p + 27);
    m->pos_m[2] = orr_wire_load_f64(p + 35);
    m->vel_mps[0] = orr_wire_load_f64(p + 43);
    m->vel_mps[1] = orr_wire_load_f64(p + 51);
    m->vel_mps[2] = orr_wire_load_f64(p + 59);
    m->acc_mps2[0] = orr_wire_load_f64(p + 67);
    m->acc_mps2[1] = orr_wire_load_f64(p + 75);
    m->acc_mps2[2] = orr_wire_load_f64(p + 83);
    m->attitude[0] = orr_wire_load_f64(p + 91);
    m->attitude[1] = orr_wire_load_f64(p + 99);
    m->attitude[2] = orr_wire_load_f64(p + 107);
    m->attitude[3] = orr_wire_load_f64(p + 115);
    m->heading_rad = orr_wire_load_f64(p + 123);
    m->pitch_rad = orr_wire_load_f64(p + 131);
    m->roll_rad = orr_wire_load_f64(p + 139);
    m->rate_radps[0] = orr_wire_load_f64(p + 147);
    m->rate_radps[1] = orr_wire_load_f64(p + 155);
    m->rate_radps[2] = orr_wire_load_f64(p + 163);
    m->force_mps2[0] = orr_wire_load_f64(p + 171);
    m->force_mps2[1] = orr_wire_load_f64(p + 179);
    m->force_mps2[2] = orr_wire_load_f64(p + 187);
    m->disturbance_mgal = orr_wire_load_f64(p + 195);
    m->eotvos_mgal = orr_wire_load_f64(p + 203);
    m->vertical_mps2 = orr_wire_load_f64(p + 211);
}

orr_wire_status orr_msg_truth_encode(const orr_msg_truth *m, orr_wire_writer *w)
{
    put_truth(w, m);
    return w->status;
}

orr_wire_status orr_msg_truth_decode(const uint8_t *payload, size_t size, orr_msg_truth *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_truth(&r, m);
    return r.status;
}

static void put_subscribe(orr_wire_writer *w, const orr_msg_subscribe *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 16);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->request);
    orr_wire_store_u8(p + 2, m->pacing);
    orr_wire_store_u8(p + 3, m->delivery);
    orr_wire_store_u32(p + 4, m->credit);
    orr_wire_store_i64(p + 8, m->lead);
    orr_wire_put_bytes(w, m->poll, 16384);
    p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p + 0, m->port);
}

static void get_subscribe(orr_wire_reader *r, orr_msg_subscribe *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 16);
    if (p == NULL) return;
    m->request = orr_wire_load_u16(p + 0);
    m->pacing = orr_wire_load_u8(p + 2);
    m->delivery = orr_wire_load_u8(p + 3);
    m->credit = orr_wire_load_u32(p + 4);
    m->lead = orr_wire_load_i64(p + 8);
    m->poll = orr_wire_get_bytes(r, 16384);
    p = orr_wire_take(r, 2);
    if (p == NULL) return;
    m->port = orr_wire_load_u16(p + 0);
}

orr_wire_status orr_msg_subscribe_encode(const orr_msg_subscribe *m, orr_wire_writer *w)
{
    put_subscribe(w, m);
    return w->status;
}

orr_wire_status orr_msg_subscribe_decode(const uint8_t *payload, size_t size, orr_msg_subscribe *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_subscribe(&r, m);
    return r.status;
}

static void put_subscribed(orr_wire_writer *w, const orr_msg_subscribed *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 20);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->first);
    orr_wire_store_i64(p + 8, m->step);
    orr_wire_store_u32(p + 16, m->channel);
}

static void get_subscribed(orr_wire_reader *r, orr_msg_subscribed *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 20);
    if (p == NULL) return;
    m->first = orr_wire_load_i64(p + 0);
    m->step = orr_wire_load_i64(p + 8);
    m->channel = orr_wire_load_u32(p + 16);
}

orr_wire_status orr_msg_subscribed_encode(const orr_msg_subscribed *m, orr_wire_writer *w)
{
    put_subscribed(w, m);
    return w->status;
}

orr_wire_status orr_msg_subscribed_decode(const uint8_t *payload, size_t size, orr_msg_subscribed *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_subscribed(&r, m);
    return r.status;
}

static void put_unsubscribe(orr_wire_writer *w, const orr_msg_unsubscribe *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->stream);
}

static void get_unsubscribe(orr_wire_reader *r, orr_msg_unsubscribe *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 4);
    if (p == NULL) return;
    m->stream = orr_wire_load_u32(p + 0);
}

orr_wire_status orr_msg_unsubscribe_encode(const orr_msg_unsubscribe *m, orr_wire_writer *w)
{
    put_unsubscribe(w, m);
    return w->status;
}

orr_wire_status orr_msg_unsubscribe_decode(const uint8_t *payload, size_t size, orr_msg_unsubscribe *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_unsubscribe(&r, m);
    return r.status;
}

static void put_credit(orr_wire_writer *w, const orr_msg_credit *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 8);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->stream);
    orr_wire_store_u32(p + 4, m->blocks);
}

static void get_credit(orr_wire_reader *r, orr_msg_credit *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 8);
    if (p == NULL) return;
    m->stream = orr_wire_load_u32(p + 0);
    m->blocks = orr_wire_load_u32(p + 4);
}

orr_wire_status orr_msg_credit_encode(const orr_msg_credit *m, orr_wire_writer *w)
{
    put_credit(w, m);
    return w->status;
}

orr_wire_status orr_msg_credit_decode(const uint8_t *payload, size_t size, orr_msg_credit *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_credit(&r, m);
    return r.status;
}

static void put_gap(orr_wire_writer *w, const orr_msg_gap *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 21);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->first);
    orr_wire_store_i64(p + 8, m->last);
    orr_wire_store_u32(p + 16, m->blocks);
    orr_wire_store_u8(p + 20, m->reason);
}

static void get_gap(orr_wire_reader *r, orr_msg_gap *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 21);
    if (p == NULL) return;
    m->first = orr_wire_load_i64(p + 0);
    m->last = orr_wire_load_i64(p + 8);
    m->blocks = orr_wire_load_u32(p + 16);
    m->reason = orr_wire_load_u8(p + 20);
}

orr_wire_status orr_msg_gap_encode(const orr_msg_gap *m, orr_wire_writer *w)
{
    put_gap(w, m);
    return w->status;
}

orr_wire_status orr_msg_gap_decode(const uint8_t *payload, size_t size, orr_msg_gap *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_gap(&r, m);
    return r.status;
}

static void put_stream_end(orr_wire_writer *w, const orr_msg_stream_end *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 9);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->next);
    orr_wire_store_u8(p + 8, m->reason);
    orr_wire_put_bytes(w, m->sentence, 200);
}

static void get_stream_end(orr_wire_reader *r, orr_msg_stream_end *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 9);
    if (p == NULL) return;
    m->next = orr_wire_load_i64(p + 0);
    m->reason = orr_wire_load_u8(p + 8);
    m->sentence = orr_wire_get_bytes(r, 200);
}

orr_wire_status orr_msg_stream_end_encode(const orr_msg_stream_end *m, orr_wire_writer *w)
{
    put_stream_end(w, m);
    return w->status;
}

orr_wire_status orr_msg_stream_end_decode(const uint8_t *payload, size_t size, orr_msg_stream_end *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_stream_end(&r, m);
    return r.status;
}

static void put_control(orr_wire_writer *w, const orr_msg_control *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 28);
    if (p == NULL) return;
    orr_wire_store_u8(p + 0, m->action);
    orr_wire_store_u8(p + 1, m->reference);
    orr_wire_store_u16(p + 2, m->reserved);
    orr_wire_store_i64(p + 4, m->t);
    orr_wire_store_i64(p + 12, m->at);
    orr_wire_store_i64(p + 20, m->delay);
    orr_wire_put_bytes(w, m->scenario, 64);
}

static void get_control(orr_wire_reader *r, orr_msg_control *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 28);
    if (p == NULL) return;
    m->action = orr_wire_load_u8(p + 0);
    m->reference = orr_wire_load_u8(p + 1);
    m->reserved = orr_wire_load_u16(p + 2);
    m->t = orr_wire_load_i64(p + 4);
    m->at = orr_wire_load_i64(p + 12);
    m->delay = orr_wire_load_i64(p + 20);
    m->scenario = orr_wire_get_bytes(r, 64);
}

orr_wire_status orr_msg_control_encode(const orr_msg_control *m, orr_wire_writer *w)
{
    put_control(w, m);
    return w->status;
}

orr_wire_status orr_msg_control_decode(const uint8_t *payload, size_t size, orr_msg_control *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_control(&r, m);
    return r.status;
}

static void put_get_time(orr_wire_writer *w, const orr_msg_get_time *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->reserved);
}

static void get_get_time(orr_wire_reader *r, orr_msg_get_time *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 4);
    if (p == NULL) return;
    m->reserved = orr_wire_load_u32(p + 0);
}

orr_wire_status orr_msg_get_time_encode(const orr_msg_get_time *m, orr_wire_writer *w)
{
    put_get_time(w, m);
    return w->status;
}

orr_wire_status orr_msg_get_time_decode(const uint8_t *payload, size_t size, orr_msg_get_time *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_get_time(&r, m);
    return r.status;
}

static void put_time(orr_wire_writer *w, const orr_msg_time *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 118);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_u8(p + 8, m->state);
    orr_wire_store_u8(p + 9, m->reference);
    orr_wire_store_i32(p + 10, m->week);
    orr_wire_store_i64(p + 14, m->tow);
    store_leap_seconds(p + 22, &m->leap);
    orr_wire_store_i32(p + 34, m->utc_mjd);
    orr_wire_store_u16(p + 38, m->n4);
    orr_wire_store_u16(p + 40, m->nt);
    orr_wire_store_i64(p + 42, m->utc_su);
    orr_wire_store_i64(p + 50, m->pps0);
    orr_wire_store_i64(p + 58, m->host);
    orr_wire_store_i64(p + 66, m->wall);
    orr_wire_store_f64(p + 74, m->error_ns);
    orr_wire_store_f64(p + 82, m->rate);
    orr_wire_store_f64(p + 90, m->wander_ns);
    orr_wire_store_u64(p + 98, m->samples);
    orr_wire_store_u32(p + 106, m->steps);
    orr_wire_store_u32(p + 110, m->suspends);
    orr_wire_store_u32(p + 114, m->sets);
}

static void get_time(orr_wire_reader *r, orr_msg_time *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 118);
    if (p == NULL) return;
    m->t = orr_wire_load_i64(p + 0);
    m->state = orr_wire_load_u8(p + 8);
    m->reference = orr_wire_load_u8(p + 9);
    m->week = orr_wire_load_i32(p + 10);
    m->tow = orr_wire_load_i64(p + 14);
    load_leap_seconds(p + 22, &m->leap);
    m->utc_mjd = orr_wire_load_i32(p + 34);
    m->n4 = orr_wire_load_u16(p + 38);
    m->nt = orr_wire_load_u16(p + 40);
    m->utc_su = orr_wire_load_i64(p + 42);
    m->pps0 = orr_wire_load_i64(p + 50);
    m->host = orr_wire_load_i64(p + 58);
    m->wall = orr_wire_load_i64(p + 66);
    m->error_ns = orr_wire_load_f64(p + 74);
    m->rate = orr_wire_load_f64(p + 82);
    m->wander_ns = orr_wire_load_f64(p + 90);
    m->samples = orr_wire_load_u64(p + 98);
    m->steps = orr_wire_load_u32(p + 106);
    m->suspends = orr_wire_load_u32(p + 110);
    m->sets = orr_wire_load_u32(p + 114);
}

orr_wire_status orr_msg_time_encode(const orr_msg_time *m, orr_wire_writer *w)
{
    put_time(w, m);
    return w->status;
}

orr_wire_status orr_msg_time_decode(const uint8_t *payload, size_t size, orr_msg_time *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_time(&r, m);
    return r.status;
}

static void put_radio_time(orr_wire_writer *w, const orr_msg_radio_time *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 17);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->elapsed);
    orr_wire_store_i64(p + 8, m->stamp);
    orr_wire_store_u8(p + 16, m->clock);
}

static void get_radio_time(orr_wire_reader *r, orr_msg_radio_time *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 17);
    if (p == NULL) return;
    m->elapsed = orr_wire_load_i64(p + 0);
    m->stamp = orr_wire_load_i64(p + 8);
    m->clock = orr_wire_load_u8(p + 16);
}

orr_wire_status orr_msg_radio_time_encode(const orr_msg_radio_time *m, orr_wire_writer *w)
{
    put_radio_time(w, m);
    return w->status;
}

orr_wire_status orr_msg_radio_time_decode(const uint8_t *payload, size_t size, orr_msg_radio_time *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_radio_time(&r, m);
    return r.status;
}

static void put_pace(orr_wire_writer *w, const orr_msg_pace *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 48);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_f64(p + 8, m->error_ns);
    orr_wire_store_f64(p + 16, m->rate);
    orr_wire_store_f64(p + 24, m->wander_ns);
    orr_wire_store_i64(p + 32, m->made);
    orr_wire_store_i64(p + 40, m->until_air);
}

static void get_pace(orr_wire_reader *r, orr_msg_pace *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 48);
    if (p == NULL) return;
    m->t = orr_wire_load_i64(p + 0);
    m->error_ns = orr_wire_load_f64(p + 8);
    m->rate = orr_wire_load_f64(p + 16);
    m->wander_ns = orr_wire_load_f64(p + 24);
    m->made = orr_wire_load_i64(p + 32);
    m->until_air = orr_wire_load_i64(p + 40);
}

orr_wire_status orr_msg_pace_encode(const orr_msg_pace *m, orr_wire_writer *w)
{
    put_pace(w, m);
    return w->status;
}

orr_wire_status orr_msg_pace_decode(const uint8_t *payload, size_t size, orr_msg_pace *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_pace(&r, m);
    return r.status;
}

static void put_motion(orr_wire_writer *w, const orr_msg_motion *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 212);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_u8(p + 8, m->order);
    orr_wire_store_u8(p + 9, m->angular_order);
    orr_wire_store_u8(p + 10, m->point);
    orr_wire_store_u8(p + 11, m->snap);
    orr_wire_store_f64(p + 12, m->pos_m[0]);
    orr_wire_store_f64(p + 20, m->pos_m[1]);
    orr_wire_store_f64(p + 28, m->pos_m[2]);
    orr_wire_store_f64(p + 36, m->vel_mps[0]);
    orr_wire_store_f64(p + 44, m->vel_mps[1]);
    orr_wire_store_f64(p + 52, m->vel_mps[2]);
    orr_wire_store_f64(p + 60, m->acc_mps2[0]);
    orr_wire_store_f64(p + 68, m->acc_mps2[1]);
    orr_wire_store_f64(p + 76, m->acc_mps2[2]);
    orr_wire_store_f64(p + 84, m->jerk_mps3[0]);
    orr_wire_store_f64(p + 92, m->jerk_mps3[1]);
    orr_wire_store_f64(p + 100, m->jerk_mps3[2]);
    orr_wire_store_f64(p + 108, m->attitude[0]);
    orr_wire_store_f64(p + 116, m->attitude[1]);
    orr_wire_store_f64(p + 124, m->attitude[2]);
    orr_wire_store_f64(p + 132, m->attitude[3]);
    orr_wire_store_f64(p + 140, m->rate_radps[0]);
    orr_wire_store_f64(p + 148, m->rate_radps[1]);
    orr_wire_store_f64(p + 156, m->rate_radps[2]);
    orr_wire_store_f64(p + 164, m->rate2_radps2[0]);
    orr_wire_store_f64(p + 172, m->rate2_radps2[1]);
    orr_wire_store_f64(p + 180, m->rate2_radps2[2]);
    orr_wire_store_f64(p + 188, m->rate3_radps3[0]);
    orr_wire_store_f64(p + 196, m->rate3_radps3[1]);
    orr_wire_store_f64(p + 204, m->rate3_radps3[2]);
}

static void get_motion(orr_wire_reader *r, orr_msg_motion *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 212);
    if (p == NULL) return;
    m->t = orr_wire_load_i64(p + 0);
    m->order = orr_wire_load_u8(p + 8);
    m->angular_order = orr_wire_load_u8(p + 9);
    m->point = orr_wire_load_u8(p + 10);
    m->snap = orr_wire_load_u8(p + 11);
    m->pos_m[0] = orr_wire_load_f64(p + 12);
    m->pos_m[1] = orr_wire_load_f64(p + 20);
    m->pos_m[2] = orr_wire_load_f64(p + 28);
    m->vel_mps[0] = orr_wire_load_f64(p + 36);
    m->vel_mps[1] = orr_wire_load_f64(p + 44);
    m->vel_mps[2] = orr_wire_load_f64(p + 52);
    m->acc_mps2[0] = orr_wire_load_f64(p + 60);
    m->acc_mps2[1] = orr_wire_load_f64(p + 68);
    m->acc_mps2[2] = orr_wire_load_f64(p + 76);
    m->jerk_mps3[0] = orr_wire_load_f64(p + 84);
    m->jerk_mps3[1] = orr_wire_load_f64(p + 92);
    m->jerk_mps3[2] = orr_wire_load_f64(p + 100);
    m->attitude[0] = orr_wire_load_f64(p + 108);
    m->attitude[1] = orr_wire_load_f64(p + 116);
    m->attitude[2] = orr_wire_load_f64(p + 124);
    m->attitude[3] = orr_wire_load_f64(p + 132);
    m->rate_radps[0] = orr_wire_load_f64(p + 140);
    m->rate_radps[1] = orr_wire_load_f64(p + 148);
    m->rate_radps[2] = orr_wire_load_f64(p + 156);
    m->rate2_radps2[0] = orr_wire_load_f64(p + 164);
    m->rate2_radps2[1] = orr_wire_load_f64(p + 172);
    m->rate2_radps2[2] = orr_wire_load_f64(p + 180);
    m->rate3_radps3[0] = orr_wire_load_f64(p + 188);
    m->rate3_radps3[1] = orr_wire_load_f64(p + 196);
    m->rate3_radps3[2] = orr_wire_load_f64(p + 204);
}

orr_wire_status orr_msg_motion_encode(const orr_msg_motion *m, orr_wire_writer *w)
{
    put_motion(w, m);
    return w->status;
}

orr_wire_status orr_msg_motion_decode(const uint8_t *payload, size_t size, orr_msg_motion *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_motion(&r, m);
    return r.status;
}

static void put_get_motion_stats(orr_wire_writer *w, const orr_msg_get_motion_stats *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 1);
    if (p == NULL) return;
    orr_wire_store_u8(p + 0, m->reset);
}

static void get_get_motion_stats(orr_wire_reader *r, orr_msg_get_motion_stats *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 1);
    if (p == NULL) return;
    m->reset = orr_wire_load_u8(p + 0);
}

orr_wire_status orr_msg_get_motion_stats_encode(const orr_msg_get_motion_stats *m, orr_wire_writer *w)
{
    put_get_motion_stats(w, m);
    return w->status;
}

orr_wire_status orr_msg_get_motion_stats_decode(const uint8_t *payload, size_t size, orr_msg_get_motion_stats *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_get_motion_stats(&r, m);
    return r.status;
}

static void put_motion_stats(orr_wire_writer *w, const orr_msg_motion_stats *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 163);
    if (p == NULL) return;
    orr_wire_store_u64(p + 0, m->received);
    orr_wire_store_u64(p + 8, m->used);
    orr_wire_store_u64(p + 16, m->late);
    orr_wire_store_u64(p + 24, m->early);
    orr_wire_store_u64(p + 32, m->dropped);
    orr_wire_store_u64(p + 40, m->overtaken);
    orr_wire_store_u64(p + 48, m->blocks);
    orr_wire_store_u64(p + 56, m->extrapolated);
    orr_wire_store_u64(p + 64, m->joined);
    orr_wire_store_u64(p + 72, m->snapped);
    store_motion_spread(p + 80, &m->lateness);
    store_motion_spread(p + 120, &m->margin);
    orr_wire_store_u16(p + 160, m->buffered);
    orr_wire_store_u8(p + 162, m->worst);
}

static void get_motion_stats(orr_wire_reader *r, orr_msg_motion_stats *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 163);
    if (p == NULL) return;
    m->received = orr_wire_load_u64(p + 0);
    m->used = orr_wire_load_u64(p + 8);
    m->late = orr_wire_load_u64(p + 16);
    m->early = orr_wire_load_u64(p + 24);
    m->dropped = orr_wire_load_u64(p + 32);
    m->overtaken = orr_wire_load_u64(p + 40);
    m->blocks = orr_wire_load_u64(p + 48);
    m->extrapolated = orr_wire_load_u64(p + 56);
    m->joined = orr_wire_load_u64(p + 64);
    m->snapped = orr_wire_load_u64(p + 72);
    load_motion_spread(p + 80, &m->lateness);
    load_motion_spread(p + 120, &m->margin);
    m->buffered = orr_wire_load_u16(p + 160);
    m->worst = orr_wire_load_u8(p + 162);
}

orr_wire_status orr_msg_motion_stats_encode(const orr_msg_motion_stats *m, orr_wire_writer *w)
{
    put_motion_stats(w, m);
    return w->status;
}

orr_wire_status orr_msg_motion_stats_decode(const uint8_t *payload, size_t size, orr_msg_motion_stats *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_motion_stats(&r, m);
    return r.status;
}

static void put_poll_events(orr_wire_writer *w, const orr_msg_poll_events *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 20);
    if (p == NULL) return;
    store_epochs(p + 0, &m->epochs);
}

static void get_poll_events(orr_wire_reader *r, orr_msg_poll_events *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 20);
    if (p == NULL) return;
    load_epochs(p + 0, &m->epochs);
}

orr_wire_status orr_msg_poll_events_encode(const orr_msg_poll_events *m, orr_wire_writer *w)
{
    put_poll_events(w, m);
    return w->status;
}

orr_wire_status orr_msg_poll_events_decode(const uint8_t *payload, size_t size, orr_msg_poll_events *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_poll_events(&r, m);
    return r.status;
}

static void put_event_records(orr_wire_writer *w, const orr_msg_event_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 22 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_event(p + 22 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_event_records_encode(const orr_msg_event_list *piece, orr_wire_writer *w)
{
    put_event_records(w, piece);
    return w->status;
}

static void put_event_list(orr_wire_writer *w, const orr_msg_event_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 22 : list->wire.stride);
    put_event_records(w, list);
}

static void get_event_list(orr_wire_reader *r, orr_msg_event_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 22) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_event_next(const orr_msg_event_list *list, orr_wire_iter *it, orr_msg_event *out)
{
    return orr_msg_event_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_event_at(const orr_msg_event_list *list, uint16_t index, orr_msg_event *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_event(p, out);
    return true;
}

static void put_events(orr_wire_writer *w, const orr_msg_events *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 25);
    if (p == NULL) return;
    store_epoch(p + 0, &m->epoch);
    orr_wire_store_i64(p + 17, m->t1);
    put_event_list(w, &m->events, 8192);
}

static void get_events(orr_wire_reader *r, orr_msg_events *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 25);
    if (p == NULL) return;
    load_epoch(p + 0, &m->epoch);
    m->t1 = orr_wire_load_i64(p + 17);
    get_event_list(r, &m->events, 8192);
}

orr_wire_status orr_msg_events_encode(const orr_msg_events *m, orr_wire_writer *w)
{
    put_events(w, m);
    return w->status;
}

orr_wire_status orr_msg_events_decode(const uint8_t *payload, size_t size, orr_msg_events *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_events(&r, m);
    return r.status;
}

static void put_open_datagrams(orr_wire_writer *w, const orr_msg_open_datagrams *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->reserved);
}

static void get_open_datagrams(orr_wire_reader *r, orr_msg_open_datagrams *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 4);
    if (p == NULL) return;
    m->reserved = orr_wire_load_u32(p + 0);
}

orr_wire_status orr_msg_open_datagrams_encode(const orr_msg_open_datagrams *m, orr_wire_writer *w)
{
    put_open_datagrams(w, m);
    return w->status;
}

orr_wire_status orr_msg_open_datagrams_decode(const uint8_t *payload, size_t size, orr_msg_open_datagrams *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_open_datagrams(&r, m);
    return r.status;
}

static void put_datagrams(orr_wire_writer *w, const orr_msg_datagrams *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 32);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->channel);
    orr_wire_store_u16(p + 4, m->port);
    orr_wire_store_u8(p + 6, m->seal);
    orr_wire_store_u8(p + 7, m->reserved);
    orr_wire_store_u64(p + 8, m->taken);
    orr_wire_store_u64(p + 16, m->replayed);
    orr_wire_store_u64(p + 24, m->refused);
    orr_wire_put_bytes(w, m->keys, 64);
}

static void get_datagrams(orr_wire_reader *r, orr_msg_datagrams *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 32);
    if (p == NULL) return;
    m->channel = orr_wire_load_u32(p + 0);
    m->port = orr_wire_load_u16(p + 4);
    m->seal = orr_wire_load_u8(p + 6);
    m->reserved = orr_wire_load_u8(p + 7);
    m->taken = orr_wire_load_u64(p + 8);
    m->replayed = orr_wire_load_u64(p + 16);
    m->refused = orr_wire_load_u64(p + 24);
    m->keys = orr_wire_get_bytes(r, 64);
}

orr_wire_status orr_msg_datagrams_encode(const orr_msg_datagrams *m, orr_wire_writer *w)
{
    put_datagrams(w, m);
    return w->status;
}

orr_wire_status orr_msg_datagrams_decode(const uint8_t *payload, size_t size, orr_msg_datagrams *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_datagrams(&r, m);
    return r.status;
}

static void put_open_motion_ring(orr_wire_writer *w, const orr_msg_open_motion_ring *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->reserved);
}

static void get_open_motion_ring(orr_wire_reader *r, orr_msg_open_motion_ring *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 4);
    if (p == NULL) return;
    m->reserved = orr_wire_load_u32(p + 0);
}

orr_wire_status orr_msg_open_motion_ring_encode(const orr_msg_open_motion_ring *m, orr_wire_writer *w)
{
    put_open_motion_ring(w, m);
    return w->status;
}

orr_wire_status orr_msg_open_motion_ring_decode(const uint8_t *payload, size_t size, orr_msg_open_motion_ring *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_open_motion_ring(&r, m);
    return r.status;
}

static void put_motion_ring(orr_wire_writer *w, const orr_msg_motion_ring *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 24);
    if (p == NULL) return;
    orr_wire_store_u32(p + 0, m->slots);
    orr_wire_store_u32(p + 4, m->stride);
    orr_wire_store_u64(p + 8, m->taken);
    orr_wire_store_u64(p + 16, m->lost);
}

static void get_motion_ring(orr_wire_reader *r, orr_msg_motion_ring *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 24);
    if (p == NULL) return;
    m->slots = orr_wire_load_u32(p + 0);
    m->stride = orr_wire_load_u32(p + 4);
    m->taken = orr_wire_load_u64(p + 8);
    m->lost = orr_wire_load_u64(p + 16);
}

orr_wire_status orr_msg_motion_ring_encode(const orr_msg_motion_ring *m, orr_wire_writer *w)
{
    put_motion_ring(w, m);
    return w->status;
}

orr_wire_status orr_msg_motion_ring_decode(const uint8_t *payload, size_t size, orr_msg_motion_ring *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_motion_ring(&r, m);
    return r.status;
}

static void put_get_modes(orr_wire_writer *w, const orr_msg_get_modes *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 8);
    if (p == NULL) return;
    orr_wire_store_u64(p + 0, m->after);
}

static void get_get_modes(orr_wire_reader *r, orr_msg_get_modes *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 8);
    if (p == NULL) return;
    m->after = orr_wire_load_u64(p + 0);
}

orr_wire_status orr_msg_get_modes_encode(const orr_msg_get_modes *m, orr_wire_writer *w)
{
    put_get_modes(w, m);
    return w->status;
}

orr_wire_status orr_msg_get_modes_decode(const uint8_t *payload, size_t size, orr_msg_get_modes *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_get_modes(&r, m);
    return r.status;
}

static void put_mode_change_records(orr_wire_writer *w, const orr_msg_mode_change_list *list)
{
    if (list->item == NULL) {
        orr_wire_put_raw(w, list->wire.data, list->wire.size);
        return;
    }
    uint8_t *p = orr_wire_room(w, 28 * (size_t)list->count);
    if (p == NULL) return;
    for (uint16_t i = 0; i < list->count; i++) store_mode_change(p + 28 * (size_t)i, &list->item[i]);
}

orr_wire_status orr_msg_mode_change_records_encode(const orr_msg_mode_change_list *piece, orr_wire_writer *w)
{
    put_mode_change_records(w, piece);
    return w->status;
}

static void put_mode_change_list(orr_wire_writer *w, const orr_msg_mode_change_list *list, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;
    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u16(p, list->count);
    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? 28 : list->wire.stride);
    put_mode_change_records(w, list);
}

static void get_mode_change_list(orr_wire_reader *r, orr_msg_mode_change_list *list, uint16_t max)
{
    const uint8_t *p = orr_wire_take(r, 4);
    if (p == NULL) return;
    uint16_t count = orr_wire_load_u16(p);
    if (count > max) {
        r->status = ORR_WIRE_LIMIT;
        return;
    }
    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)
    if (count > 0 && stride < 28) {
        r->status = ORR_WIRE_SHORT;
        return;
    }
    p = orr_wire_take(r, (size_t)count * stride);
    if (p == NULL) return;
    list->wire.size = (size_t)count * stride;
    list->wire.stride = stride;
    list->wire.data = p;
    list->count = count;
}

bool orr_msg_mode_change_next(const orr_msg_mode_change_list *list, orr_wire_iter *it, orr_msg_mode_change *out)
{
    return orr_msg_mode_change_at(list, it->index, out) ? (it->index++, true) : false;
}

bool orr_msg_mode_change_at(const orr_msg_mode_change_list *list, uint16_t index, orr_msg_mode_change *out)
{
    if (index >= list->count) return false;
    if (list->item != NULL) {
        *out = list->item[index];
        return true;
    }
    size_t stride = list->wire.stride;
    const uint8_t *p = list->wire.data + index * stride;
    load_mode_change(p, out);
    return true;
}

static void put_modes(orr_wire_writer *w, const orr_msg_modes *m)
{
    uint8_t *p;
    p = orr_wire_room(w, 25);
    if (p == NULL) return;
    orr_wire_store_i64(p + 0, m->t);
    orr_wire_store_u64(p + 8, m->last);
    orr_wire_store_u64(p + 16, m->lost);
    orr_wire_store_u8(p + 24, m->more);
    put_mode_change_list(w, &m->changes, 100);
}

static void get_modes(orr_wire_reader *r, orr_msg_modes *m)
{
    const uint8_t *p;
    p = orr_wire_take(r, 25);
    if (p == NULL) return;
    m->t = orr_wire_load_i64(p + 0);
    m->last = orr_wire_load_u64(p + 8);
    m->lost = orr_wire_load_u64(p + 16);
    m->more = orr_wire_load_u8(p + 24);
    get_mode_change_list(r, &m->changes, 100);
}

orr_wire_status orr_msg_modes_encode(const orr_msg_modes *m, orr_wire_writer *w)
{
    put_modes(w, m);
    return w->status;
}

orr_wire_status orr_msg_modes_decode(const uint8_t *payload, size_t size, orr_msg_modes *m)
{
    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};
    memset(m, 0, sizeof *m);
    get_modes(&r, m);
    return r.status;
}

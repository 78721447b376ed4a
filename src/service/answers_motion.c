// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers_motion.h"

#include <math.h>
#include <stdio.h>

#include "core/nan.h"
#include "src/service/answers.h"

static uint16_t refuse(orr_server_refusal *why, uint16_t code, const char *name, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "%s: %s", name, sentence);
    return code;
}

// What both ask alike. `last_step` is the number of steps from t to the last instant concerned.
static uint16_t check(const orr_engine *e, const char *name, int64_t t, int64_t step, uint32_t count,
                      int64_t last_step, uint16_t unit, orr_server_refusal *why)
{
    size_t units = orr_engine_units(e);
    int64_t last;
    if (units == 0)
        return refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED, name,
                      "this scenario has no trajectory (trajectory.kind)");
    if (unit >= units) {
        snprintf(why->sentence, sizeof why->sentence, "%s: there is no unit %u, the scenario has 0 to %zu",
                 name, (unsigned)unit, units - 1);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    if (count == 0)
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, name, "count is 0, nothing is asked for");
    if (count > ORR_MSG_MAX_EPOCHS) {
        snprintf(why->sentence, sizeof why->sentence, "%s: %lu epochs, at most %u may be asked for at once",
                 name, (unsigned long)count, ORR_MSG_MAX_EPOCHS);
        return ORR_MSG_ERROR_CODE_LIMIT;
    }
    if (__builtin_mul_overflow(step, last_step, &last) || __builtin_add_overflow(t, last, &last))
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, name,
                      "its last epoch is beyond what a time can be");
    return 0;
}

static uint16_t undecoded(orr_wire_status ws, const char *name, orr_server_refusal *why)
{
    return refuse(why, ORR_MSG_ERROR_CODE_BAD_PAYLOAD, name, orr_wire_status_text(ws));
}

static void put(double to[3], orr_vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

uint16_t orr_answers_begin_imu(void *user, const orr_frame *request, uint32_t *frames,
                               orr_server_refusal *why)
{
    const orr_engine *e = orr_answers_engine(user);
    orr_msg_poll_imu poll;
    orr_wire_status ws = orr_msg_poll_imu_decode(request->payload, request->size, &poll);
    if (ws != ORR_WIRE_OK) return undecoded(ws, "POLL_IMU", why);
    // An interval of the scenario's own is at least 10 us; without a trajectory the rate is 0 and check()
    // refuses.
    int64_t step = poll.step != 0 ? poll.step : 1;
    uint16_t code = check(e, "POLL_IMU", poll.t, step, poll.count, poll.count, poll.unit, why);
    if (code != 0) return code;
    if (poll.step < 0 || poll.step > INT64_C(3600000000000))
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "POLL_IMU",
                      "an interval has a length of 0 to an hour");
    if (!orr_engine_imu_physical(e))
        return refuse(
            why, ORR_MSG_ERROR_CODE_NOT_SERVED, "POLL_IMU",
            "readings of approach 1 depend on all before them; they are made by 'orrery imu', not by time");
    *frames = poll.count;
    return 0;
}

// Begin of interval k; intervals of the scenario's rate are rounded one by one, so that they never drift.
static orr_time begin_of(const orr_engine *e, const orr_msg_poll_imu *poll, uint32_t k)
{
    if (poll->step != 0) return poll->t + poll->step * (int64_t)k;
    return poll->t + (int64_t)llround((double)k * 1e9 / orr_engine_imu_rate(e));
}

uint16_t orr_answers_imu(void *user, const orr_frame *request, uint32_t index, orr_wire_writer *w,
                         orr_server_refusal *why)
{
    (void)why;
    const orr_engine *e = orr_answers_engine(user);
    orr_msg_poll_imu poll;
    orr_msg_poll_imu_decode(request->payload, request->size, &poll); // its begin has seen that it decodes
    orr_msg_imu m = {.t0 = begin_of(e, &poll, index),
                     .t1 = begin_of(e, &poll, index + 1),
                     .index = index,
                     .count = poll.count,
                     .unit = poll.unit};
    orr_vec3 dtheta = {ORR_NAN, ORR_NAN, ORR_NAN}, dv = dtheta;
    m.answer = (uint8_t)orr_engine_imu(e, poll.unit, m.t0, m.t1, &dtheta, &dv);
    put(m.dtheta_rad, dtheta);
    put(m.dv_mps, dv);
    orr_msg_imu_encode(&m, w);
    return 0;
}

uint16_t orr_answers_begin_truth(void *user, const orr_frame *request, uint32_t *frames,
                                 orr_server_refusal *why)
{
    orr_msg_poll_truth poll;
    orr_wire_status ws = orr_msg_poll_truth_decode(request->payload, request->size, &poll);
    if (ws != ORR_WIRE_OK) return undecoded(ws, "POLL_TRUTH", why);
    uint16_t code = check(orr_answers_engine(user), "POLL_TRUTH", poll.t, poll.step, poll.count,
                          (int64_t)poll.count - 1, poll.unit, why);
    if (code == 0 && poll.count > 1 && poll.step == 0)
        code =
            refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "POLL_TRUTH", "step is 0, but count is more than 1");
    *frames = poll.count;
    return code;
}

uint16_t orr_answers_truth(void *user, const orr_frame *request, uint32_t index, orr_wire_writer *w,
                           orr_server_refusal *why)
{
    (void)why;
    orr_msg_poll_truth poll;
    orr_msg_poll_truth_decode(request->payload, request->size, &poll); // its begin has seen that it decodes
    orr_msg_truth m = {
        .t = poll.t + poll.step * (int64_t)index, .index = index, .count = poll.count, .unit = poll.unit};
    orr_truth t;
    m.answer = (uint8_t)orr_engine_truth(orr_answers_engine(user), poll.unit, m.t, &t);
    if (m.answer != ORR_MSG_ANSWER_OK) {
        orr_vec3 none = {ORR_NAN, ORR_NAN, ORR_NAN};
        t = (orr_truth){.motion = {.r_m = none,
                                   .v_mps = none,
                                   .a_mps2 = none,
                                   .q_be = {ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN}},
                        .angles = {ORR_NAN, ORR_NAN, ORR_NAN},
                        .rate_radps = none,
                        .force_mps2 = none,
                        .disturbance_mgal = ORR_NAN,
                        .eotvos_mgal = ORR_NAN,
                        .vertical_mps2 = ORR_NAN};
    }
    put(m.pos_m, t.motion.r_m);
    put(m.vel_mps, t.motion.v_mps);
    put(m.acc_mps2, t.motion.a_mps2);
    m.attitude[0] = t.motion.q_be.w;
    m.attitude[1] = t.motion.q_be.x;
    m.attitude[2] = t.motion.q_be.y;
    m.attitude[3] = t.motion.q_be.z;
    m.heading_rad = t.angles.heading_rad;
    m.pitch_rad = t.angles.pitch_rad;
    m.roll_rad = t.angles.roll_rad;
    put(m.rate_radps, t.rate_radps);
    put(m.force_mps2, t.force_mps2);
    m.disturbance_mgal = t.disturbance_mgal;
    m.eotvos_mgal = t.eotvos_mgal;
    m.vertical_mps2 = t.vertical_mps2;
    orr_msg_truth_encode(&m, w);
    return 0;
}

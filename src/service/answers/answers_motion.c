// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/answers/answers_motion.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "src/service/answers/answers_private.h"

static uint16_t refuse(orr_server_refusal *why, uint16_t code, const char *name, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "%s: %s", name, sentence);
    return code;
}

// What both ask alike: a unit that there is.
static uint16_t check_unit(const orr_engine *e, const char *name, uint16_t unit, orr_server_refusal *why)
{
    size_t units = orr_engine_units(e);
    if (units == 0)
        return refuse(why, ORR_MSG_ERROR_CODE_NOT_SERVED, name,
                      "this scenario has no trajectory (trajectory.kind)");
    if (unit < units) return 0;
    snprintf(why->sentence, sizeof why->sentence, "%s: there is no unit %u, the scenario has 0 to %zu", name,
             (unsigned)unit, units - 1);
    return ORR_MSG_ERROR_CODE_BAD_REQUEST;
}

uint16_t orr_answers_begin_imu(void *user, const orr_msg_poll_imu *poll, orr_server_refusal *why)
{
    const orr_engine *e = orr_answers_engine(user);
    uint16_t code = check_unit(e, "POLL_IMU", poll->unit, why);
    if (code != 0) return code;
    if (!orr_engine_imu_physical(e))
        return refuse(
            why, ORR_MSG_ERROR_CODE_NOT_SERVED, "POLL_IMU",
            "readings of approach 1 depend on all before them; they are made by 'orrery imu', not by time");
    const orr_msg_epochs *q = &poll->epochs;
    if (q->step < 0 || q->step > INT64_C(3600000000000))
        return refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "POLL_IMU",
                      "an interval has a length of 0 to an hour");
    // The last interval ends within what a time can be, too.
    double step_ns = q->step != 0 ? (double)q->step : ceil(1e9 / orr_engine_imu_rate(e));
    orr_msg_epochs ends = {q->t, (int64_t)step_ns, q->count};
    code = orr_answers_check_epochs("POLL_IMU", &ends, why);
    if (code == 0 && q->t > INT64_MAX - ends.step * (int64_t)q->count)
        code = refuse(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "POLL_IMU",
                      "its last interval ends beyond what a time can be");
    return code;
}

// Begin of interval k; intervals of the scenario's rate are rounded one by one, so that they never drift.
static orr_time begin_of(const orr_engine *e, const orr_msg_poll_imu *poll, uint32_t k)
{
    if (poll->epochs.step != 0) return poll->epochs.t + poll->epochs.step * (int64_t)k;
    return poll->epochs.t + (int64_t)llround((double)k * 1e9 / orr_engine_imu_rate(e));
}

uint16_t orr_answers_imu(void *user, const orr_msg_poll_imu *poll, orr_server_part *part, orr_wire_writer *w,
                         orr_server_refusal *why)
{
    (void)why;
    const orr_engine *e = orr_answers_engine(user);
    orr_msg_imu m = {.epoch = {begin_of(e, poll, part->index), part->index, poll->epochs.count, 0},
                     .t1 = begin_of(e, poll, part->index + 1),
                     .unit = poll->unit,
                     .readings =
                         orr_engine_imu_measured(e) ? ORR_MSG_READINGS_MEASURED : ORR_MSG_READINGS_IDEAL};
    enum { PIECE = 8 }; // some microseconds
    orr_sensors_sum sum;
    _Static_assert(sizeof sum <= sizeof part->kept, "the sum is kept between two pieces of a frame");
    if (part->done == 0)
        m.epoch.answer = (uint8_t)orr_engine_imu_begin(e, poll->unit, m.epoch.t, m.t1, &sum);
    else
        memcpy(&sum, part->kept, sizeof sum);
    if (m.epoch.answer != ORR_MSG_ANSWER_OK)
        sum.dtheta_rad = sum.dv_mps = (orr_vec3){ORR_NAN, ORR_NAN, ORR_NAN};
    else
        while (!orr_engine_imu_add(e, poll->unit, &sum, PIECE))
            if (!orr_server_next_piece(part, UINT32_MAX)) {
                memcpy(part->kept, &sum, sizeof sum);
                return 0;
            }
    orr_answers_put(m.dtheta_rad, sum.dtheta_rad);
    orr_answers_put(m.dv_mps, sum.dv_mps);
    orr_msg_imu_encode(&m, w);
    return 0;
}

uint16_t orr_answers_begin_truth(void *user, const orr_msg_poll_truth *poll, orr_server_refusal *why)
{
    uint16_t code = check_unit(orr_answers_engine(user), "POLL_TRUTH", poll->unit, why);
    if (code == 0) code = orr_answers_check_epochs("POLL_TRUTH", &poll->epochs, why);
    return code;
}

uint16_t orr_answers_truth(void *user, const orr_msg_poll_truth *poll, orr_server_part *part,
                           orr_wire_writer *w, orr_server_refusal *why)
{
    (void)why;
    orr_msg_truth m = {.epoch = orr_answers_epoch(&poll->epochs, part->index), .unit = poll->unit};
    orr_truth t;
    m.epoch.answer = (uint8_t)orr_engine_truth(orr_answers_engine(user), poll->unit, m.epoch.t, &t);
    if (m.epoch.answer != ORR_MSG_ANSWER_OK) {
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
    orr_answers_put(m.pos_m, t.motion.r_m);
    orr_answers_put(m.vel_mps, t.motion.v_mps);
    orr_answers_put(m.acc_mps2, t.motion.a_mps2);
    m.attitude[0] = t.motion.q_be.w;
    m.attitude[1] = t.motion.q_be.x;
    m.attitude[2] = t.motion.q_be.y;
    m.attitude[3] = t.motion.q_be.z;
    m.heading_rad = t.angles.heading_rad;
    m.pitch_rad = t.angles.pitch_rad;
    m.roll_rad = t.angles.roll_rad;
    orr_answers_put(m.rate_radps, t.rate_radps);
    orr_answers_put(m.force_mps2, t.force_mps2);
    m.disturbance_mgal = t.disturbance_mgal;
    m.eotvos_mgal = t.eotvos_mgal;
    m.vertical_mps2 = t.vertical_mps2;
    orr_msg_truth_encode(&m, w);
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_motion.h"

#include <math.h>
#include <stdio.h>

#include "core/vec.h"
#include "src/cli/service/poll_json.h"

int orr_motion_poll_ask(const orr_cli *c, orr_motion_poll *out)
{
    *out = (orr_motion_poll){.imu = orr_cli_given(c, "imu"),
                             .truth = orr_cli_given(c, "truth"),
                             .unit = (uint16_t)orr_cli_int(c, "unit", 0),
                             .step_ns = orr_cli_given(c, "step") ? orr_cli_duration_ns(c, "step", 0) : 0,
                             .json = orr_cli_given(c, "json")};
    if (!out->imu && !out->truth && orr_cli_given(c, "unit"))
        return orr_cli_usage(c, "--unit goes with --imu or --truth");
    return ORR_EXIT_OK;
}

static void show_imu(const orr_motion_poll *p, const orr_msg_imu *m)
{
    bool ok = m->epoch.answer == ORR_MSG_ANSWER_OK;
    if (p->json) {
        json_t *j = json_object();
        json_object_set_new(j, "t", orr_json_time(m->epoch.t));
        json_object_set_new(j, "t1", orr_json_time(m->t1));
        json_object_set_new(j, "unit", json_integer(m->unit));
        json_object_set_new(j, "answer", json_string(orr_msg_answer_name(m->epoch.answer)));
        if (ok) {
            json_object_set_new(j, "dtheta_rad", orr_poll_json_vector(m->dtheta_rad, 3));
            json_object_set_new(j, "dv_mps", orr_poll_json_vector(m->dv_mps, 3));
        }
        orr_poll_json_print(j);
        return;
    }
    char text[ORR_TIME_TEXT];
    printf("%s GPS +%.9f s  unit %u", orr_time_text(m->epoch.t, text), (double)(m->t1 - m->epoch.t) * 1e-9,
           (unsigned)m->unit);
    if (ok)
        printf("  rad %.9e %.9e %.9e  m/s %.9e %.9e %.9e\n", m->dtheta_rad[0], m->dtheta_rad[1],
               m->dtheta_rad[2], m->dv_mps[0], m->dv_mps[1], m->dv_mps[2]);
    else
        printf("  outside the trajectory's span\n");
}

static void truth_json(const orr_msg_truth *m)
{
    json_t *j = json_object();
    json_object_set_new(j, "t", orr_json_time(m->epoch.t));
    json_object_set_new(j, "unit", json_integer(m->unit));
    json_object_set_new(j, "answer", json_string(orr_msg_answer_name(m->epoch.answer)));
    if (m->epoch.answer == ORR_MSG_ANSWER_OK) {
        json_object_set_new(j, "pos_m", orr_poll_json_vector(m->pos_m, 3));
        json_object_set_new(j, "vel_mps", orr_poll_json_vector(m->vel_mps, 3));
        json_object_set_new(j, "acc_mps2", orr_poll_json_vector(m->acc_mps2, 3));
        json_object_set_new(j, "attitude", orr_poll_json_vector(m->attitude, 4));
        json_object_set_new(j, "heading_rad", orr_json_number(m->heading_rad));
        json_object_set_new(j, "pitch_rad", orr_json_number(m->pitch_rad));
        json_object_set_new(j, "roll_rad", orr_json_number(m->roll_rad));
        json_object_set_new(j, "rate_radps", orr_poll_json_vector(m->rate_radps, 3));
        json_object_set_new(j, "force_mps2", orr_poll_json_vector(m->force_mps2, 3));
        json_object_set_new(j, "disturbance_mgal", orr_json_number(m->disturbance_mgal));
        json_object_set_new(j, "eotvos_mgal", orr_json_number(m->eotvos_mgal));
        json_object_set_new(j, "vertical_mps2", orr_json_number(m->vertical_mps2));
    }
    orr_poll_json_print(j);
}

static void show_truth(const orr_motion_poll *p, const orr_msg_truth *m)
{
    if (p->json) {
        truth_json(m);
        return;
    }
    char text[ORR_TIME_TEXT];
    printf("%s GPS  unit %u", orr_time_text(m->epoch.t, text), (unsigned)m->unit);
    if (m->epoch.answer != ORR_MSG_ANSWER_OK) {
        printf("  outside the trajectory's span\n");
        return;
    }
    printf("\n  position     %15.4f %15.4f %15.4f m\n", m->pos_m[0], m->pos_m[1], m->pos_m[2]);
    printf("  velocity     %15.6f %15.6f %15.6f m/s\n", m->vel_mps[0], m->vel_mps[1], m->vel_mps[2]);
    printf("  heading, pitch, roll %.5f %.5f %.5f deg\n", m->heading_rad * ORR_DEG_PER_RAD,
           m->pitch_rad * ORR_DEG_PER_RAD, m->roll_rad * ORR_DEG_PER_RAD);
    printf("  rate         %15.9f %15.9f %15.9f rad/s\n", m->rate_radps[0], m->rate_radps[1],
           m->rate_radps[2]);
    printf("  force        %15.9f %15.9f %15.9f m/s2\n", m->force_mps2[0], m->force_mps2[1],
           m->force_mps2[2]);
    printf("  gravity      disturbance %.3f mGal, Eotvoes %.3f mGal, vertical acceleration %.6f m/s2\n",
           m->disturbance_mgal, m->eotvos_mgal, m->vertical_mps2);
}

orr_status orr_motion_poll_run(orr_motion_poll *p, orr_dial *d, orr_time t, int64_t step_ns, uint32_t count,
                               orr_diag *diag)
{
    orr_msg_poll_imu imu = {.epochs = {t, p->step_ns, count}, .unit = p->unit};
    orr_msg_poll_truth truth = {.epochs = {t, step_ns, count}, .unit = p->unit};
    orr_wire_status ws =
        p->imu ? orr_client_poll_imu(&d->client, &imu) : orr_client_poll_truth(&d->client, &truth);
    for (uint32_t k = 0; k < count && ws == ORR_WIRE_OK; k++) {
        orr_msg_imu i;
        orr_msg_truth m;
        ws = p->imu ? orr_client_imu(&d->client, &i) : orr_client_truth(&d->client, &m);
        if (ws == ORR_WIRE_OK && (p->imu ? i.epoch.index != k || i.epoch.count != count
                                         : m.epoch.index != k || m.epoch.count != count))
            ws = ORR_WIRE_UNEXPECTED;
        if (ws != ORR_WIRE_OK) break;
        uint8_t answer = p->imu ? i.epoch.answer : m.epoch.answer;
        p->outside = p->outside || answer == ORR_MSG_ANSWER_OUTSIDE_SPAN;
        p->numbers += answer == ORR_MSG_ANSWER_OK;
        if (p->imu)
            show_imu(p, &i);
        else
            show_truth(p, &m);
    }
    return ws == ORR_WIRE_OK ? ORR_OK : orr_dial_status(d, ws, p->imu ? "POLL_IMU" : "POLL_TRUTH", diag);
}

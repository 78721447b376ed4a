// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of POLL_IMU and POLL_TRUTH, rows of the table in answers.c.
#ifndef ORR_SERVICE_ANSWERS_MOTION_H
#define ORR_SERVICE_ANSWERS_MOTION_H

#include "proto/server.h"

uint16_t orr_answers_begin_imu(void *user, const orr_msg_poll_imu *poll, orr_server_refusal *why);
uint16_t orr_answers_imu(void *user, const orr_msg_poll_imu *poll, orr_server_part *part, orr_wire_writer *w,
                         orr_server_refusal *why);
uint16_t orr_answers_begin_truth(void *user, const orr_msg_poll_truth *poll, orr_server_refusal *why);
uint16_t orr_answers_truth(void *user, const orr_msg_poll_truth *poll, orr_server_part *part,
                           orr_wire_writer *w, orr_server_refusal *why);

#endif

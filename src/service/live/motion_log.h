// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of live motion in a file, each with the instant from which blocks rest on it, so that the same blocks can be made again:
// "ORRYMOT1", then of each sample 8 bytes of that instant and its MOTION frame, as on the wire.
#ifndef ORR_SERVICE_LIVE_MOTION_LOG_H
#define ORR_SERVICE_LIVE_MOTION_LOG_H

#include "core/status.h"
#include "src/service/live/vehicle.h"

typedef struct orr_motion_log orr_motion_log;

// Begins a log. Errors: ORR_E_IO, ORR_E_MEMORY.
orr_status orr_motion_log_create(const char *path, orr_motion_log **out, orr_diag *diag);
// Opens one for reading. Errors: ORR_E_IO, ORR_E_KIND (no such log), ORR_E_MEMORY.
orr_status orr_motion_log_open(const char *path, orr_motion_log **out, orr_diag *diag);
// Closes it; ORR_E_IO where something could not be written. NULL may be closed.
orr_status orr_motion_log_close(orr_motion_log *log, orr_diag *diag);
// Appends a sample: orr_vehicle_options.record, with the log as user. What cannot be written is told on closing.
void orr_motion_log_write(void *user, const orr_msg_motion *m, orr_time from);
// The next sample: orr_vehicle_options.replay. False behind the last, and where the file is damaged (orr_motion_log_fault).
bool orr_motion_log_read(void *user, orr_msg_motion *m, orr_time *from);
// What is wrong with a log that has been read to where it ends; NULL: nothing.
const char *orr_motion_log_fault(const orr_motion_log *log);

#endif

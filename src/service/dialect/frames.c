// SPDX-License-Identifier: GPL-3.0-or-later
// Orrery's own: a datagram is a frame of MOTION.
#include "proto/frame.h"
#include "src/service/dialect/dialect.h"

static orr_dialect_result take(orr_dialect_state *s, const uint8_t *data, size_t n, orr_msg_motion *m,
                               uint8_t *reply, size_t *n_reply)
{
    orr_frame f;
    size_t used;
    (void)s, (void)reply;
    *n_reply = 0;
    if (orr_frame_parse(data, n, ORR_MSG_MAX_REQUEST, &f, &used) != ORR_WIRE_OK ||
        f.type != ORR_MSG_TYPE_MOTION || orr_msg_motion_decode(f.payload, f.size, m) != ORR_WIRE_OK)
        return ORR_DIALECT_WRONG;
    return ORR_DIALECT_SAMPLE;
}

const orr_dialect orr_dialect_frames = {.name = "orrery", .words = "frames of MOTION", .take = take};

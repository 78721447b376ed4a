// SPDX-License-Identifier: GPL-3.0-or-later
// A message of RTCM 3 while it is written, bit after bit, and as the frame that is sent: preamble, length, content, CRC-24Q
// (RTCM 10403.3, 4.2).
#ifndef ORR_ORBIT_NAVDATA_RTCM_FRAME_H
#define ORR_ORBIT_NAVDATA_RTCM_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ORR_RTCM_CONTENT 1023 // bytes, at most

typedef struct orr_rtcm_frame {
    size_t bits; // of the content so far
    size_t n;    // bytes of the frame, once it has ended
    bool full;   // more was put than a message holds
    uint8_t data[3 + ORR_RTCM_CONTENT + 3];
} orr_rtcm_frame;

// Begins an empty message.
void orr_rtcm_begin(orr_rtcm_frame *f);
// Appends the lowest n bits of a value, the highest of them first; n up to 64.
void orr_rtcm_put(orr_rtcm_frame *f, int n, uint64_t value);
// Ends the message: data[0 .. n) is the frame. False where it is full: n is 0 then.
bool orr_rtcm_end(orr_rtcm_frame *f);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: RTCM 10403.3, tables 3.5-6, 3.5-7, 3.5-32 and 3.5-113.
#include "src/scenario/receiver/rtcm_station.h"

#include <math.h>
#include <string.h>

#define LSB_M 1e-4
#define TEXT 31 // characters of a descriptor at most

static void put_metres(orr_rtcm_frame *f, double m) { orr_rtcm_put(f, 38, (uint64_t)llround(m / LSB_M)); }

void orr_rtcm_place(const orr_rtcm_station *s, bool height, orr_rtcm_frame *frame)
{
    orr_rtcm_begin(frame);
    orr_rtcm_put(frame, 12, height ? 1006 : 1005);
    orr_rtcm_put(frame, 12, s->number);
    orr_rtcm_put(frame, 6, 0); // year of the ITRF: not told
    for (const char *x = "GRE"; *x != '\0'; x++) orr_rtcm_put(frame, 1, strchr(s->systems, *x) != NULL);
    orr_rtcm_put(frame, 1, 0); // a real station, not a virtual one
    put_metres(frame, s->position_m.x);
    orr_rtcm_put(frame, 1, 1); // all signals by one oscillator
    orr_rtcm_put(frame, 1, 0);
    put_metres(frame, s->position_m.y);
    orr_rtcm_put(frame, 2, 1); // quarter cycles are corrected: signals of a carrier are in phase
    put_metres(frame, s->position_m.z);
    if (height) orr_rtcm_put(frame, 16, 0);
    (void)orr_rtcm_end(frame);
}

static void put_text(orr_rtcm_frame *f, const char *text)
{
    size_t n = strlen(text);
    n = n > TEXT ? TEXT : n;
    orr_rtcm_put(f, 8, n);
    for (size_t k = 0; k < n; k++) orr_rtcm_put(f, 8, (uint8_t)text[k]);
}

void orr_rtcm_equipment(const orr_rtcm_station *s, orr_rtcm_frame *frame)
{
    orr_rtcm_begin(frame);
    orr_rtcm_put(frame, 12, 1033);
    orr_rtcm_put(frame, 12, s->number);
    put_text(frame, s->antenna);
    orr_rtcm_put(frame, 8, 0); // set-up: the antenna type's own calibration
    put_text(frame, "");
    put_text(frame, s->receiver);
    put_text(frame, s->version);
    put_text(frame, "");
    (void)orr_rtcm_end(frame);
}

void orr_rtcm_glonass_biases(const orr_rtcm_station *s, orr_rtcm_frame *frame)
{
    const bool sent[4] = {s->l1of, false, s->l2of, false}; // L1 C/A, L1 P, L2 C/A, L2 P
    orr_rtcm_begin(frame);
    orr_rtcm_put(frame, 12, 1230);
    orr_rtcm_put(frame, 12, s->number);
    orr_rtcm_put(frame, 1, 1); // aligned
    orr_rtcm_put(frame, 3, 0);
    for (int k = 0; k < 4; k++) orr_rtcm_put(frame, 1, sent[k]);
    for (int k = 0; k < 4; k++)
        if (sent[k]) orr_rtcm_put(frame, 16, 0);
    (void)orr_rtcm_end(frame);
}

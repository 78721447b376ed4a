// SPDX-License-Identifier: GPL-3.0-or-later
// User motion as lines of text, one a datagram: seconds since the begin, x, y, z [m], and, where they are told, velocity, acceleration and
// jerk, three numbers each, divided by commas, semicolons or blanks.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/dialect/dialect.h"

static orr_dialect_result take(orr_dialect_state *s, const uint8_t *data, size_t n, orr_msg_motion *m,
                               uint8_t *reply, size_t *n_reply)
{
    char text[ORR_DIALECT_DATAGRAM + 1];
    double v[13];
    int count = 0;
    (void)reply;
    *n_reply = 0;
    *m = (orr_msg_motion){.order = 0};
    if (n > ORR_DIALECT_DATAGRAM) return ORR_DIALECT_WRONG;
    memcpy(text, data, n);
    text[n] = '\0';
    char *c = text + strspn(text, " \t");
    if (*c == '#' || *c == '\0' || *c == '\n') return ORR_DIALECT_NOTHING;
    while (count < 13 && *c != '\0') {
        char *end;
        v[count] = strtod(c, &end);
        if (end == c) return ORR_DIALECT_WRONG;
        count++;
        c = end + strspn(end, " \t,;\r\n");
    }
    if (*c != '\0' || count < 4 || (count - 1) % 3 != 0 || !(fabs(v[0]) < 1e9)) return ORR_DIALECT_WRONG;
    double *const place[] = {m->pos_m, m->vel_mps, m->acc_mps2, m->jerk_mps3};
    for (int k = 0; k < (count - 1) / 3; k++) memcpy(place[k], v + 1 + 3 * k, 3 * sizeof v[0]);
    m->order = (uint8_t)((count - 1) / 3 - 1);
    m->t = orr_time_add(s->begin, llround(v[0] * 1e9));
    return ORR_DIALECT_SAMPLE;
}

const orr_dialect orr_dialect_lines = {
    .name = "lines", .words = "lines of seconds, x, y, z and derivatives", .take = take};

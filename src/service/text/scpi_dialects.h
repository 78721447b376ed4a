// SPDX-License-Identifier: GPL-3.0-or-later
// Other instruments' SCPI for motion in the loop, each a table of its own file, beside the text twin's own commands.
#ifndef ORR_SERVICE_TEXT_SCPI_DIALECTS_H
#define ORR_SERVICE_TEXT_SCPI_DIALECTS_H

#include "src/service/text/ask.h"
#include "src/service/text/scpi.h"

// What a session keeps for its tables: the user of its orr_scpi.
typedef struct orr_text_common {
    const orr_asked *asked;
    orr_msg_motion gsg;     // the sample that GSG's commands build up
    double gsg_angle[4][3]; // its yaw, pitch, roll and their rates
} orr_text_common;

// What answers, behind a table's orr_scpi.
static inline const orr_asked *orr_text_asked(const orr_scpi *s)
{
    return ((const orr_text_common *)s->user)->asked;
}
// Numbers of a command into v; 0, or an error's number.
int orr_scpi_numbers(char *const *parameter, size_t n, double *v);
// A sample of motion: 0, or an error's number with its detail.
int orr_scpi_motion(orr_scpi *s, const orr_msg_motion *m);

extern const orr_scpi_command orr_scpi_gsg[], orr_scpi_rs[];
extern const size_t orr_scpi_n_gsg, orr_scpi_n_rs;

#endif

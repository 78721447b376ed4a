// SPDX-License-Identifier: GPL-3.0-or-later
// One client of the text twin: lines of SCPI, or of JSON where they begin with a brace. Bytes in, bytes out; no socket.
#ifndef ORR_SERVICE_TEXT_SESSION_H
#define ORR_SERVICE_TEXT_SESSION_H

#include "src/service/text/ask.h"
#include "src/service/text/scpi.h"
#include "src/service/text/scpi_dialects.h"

enum { ORR_TEXT_LINE = 64 << 10 }; // longest line; a longer one is -363 and passed over

typedef struct orr_text_session {
    const orr_asked *asked;
    orr_scpi scpi;
    orr_text_common common; // behind scpi's tables
    char *line;
    size_t n;
    bool overrun; // the present line is too long
} orr_text_session;

// Begins a session; false: out of memory. End with orr_text_session_close.
bool orr_text_session_open(orr_text_session *s, const orr_asked *asked);
// Frees what it holds.
void orr_text_session_close(orr_text_session *s);
// Takes bytes as they come, however they are cut; what is to be answered goes to out.
void orr_text_session_take(orr_text_session *s, const char *data, size_t n, FILE *out);

#endif

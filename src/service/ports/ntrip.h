// SPDX-License-Identifier: GPL-3.0-or-later
// NTRIP as a caster speaks it: requests of clients read, of revision 1 and 2, and the answers' heads. Bytes in, bytes out; connections are
// port_server's.
#ifndef ORR_SERVICE_PORTS_NTRIP_H
#define ORR_SERVICE_PORTS_NTRIP_H

#include <stdbool.h>
#include <stddef.h>

enum {
    ORR_NTRIP_REQUEST = 4096, // bytes of a request's head, at most
    ORR_NTRIP_NAME = 64,      // of a mountpoint, with its NUL
    ORR_NTRIP_LOGIN = 344,    // of a login in base64: 256 bytes
    ORR_NTRIP_HEAD = 1024,    // of an answer's head
};

typedef enum orr_ntrip_verdict {
    ORR_NTRIP_MORE,    // the head has not ended
    ORR_NTRIP_WHOLE,   // a request
    ORR_NTRIP_NO_HTTP, // none that is understood
    ORR_NTRIP_TOO_LONG,
    ORR_NTRIP_NOT_GET, // who wants to send a stream, or something else
} orr_ntrip_verdict;

typedef struct orr_ntrip_request {
    int revision;               // 1 or 2 (Ntrip-Version: Ntrip/2.0)
    bool http_1_1;              // chunks are understood
    char mount[ORR_NTRIP_NAME]; // "" for the source table; a name that is too long is cut, and names nothing
    bool too_long;
    char login[ORR_NTRIP_LOGIN + 1]; // of Authorization: Basic, base64 as it came; "" without
} orr_ntrip_request;

// Reads the head of a request.
// Given:
//   data, n  all bytes that have come
// Returned:
//   out      the request; set with ORR_NTRIP_WHOLE alone
// Reference: RTCM 10410.0 (revision 1), 10410.1 (revision 2); RFC 7230.
orr_ntrip_verdict orr_ntrip_read(const char *data, size_t n, orr_ntrip_request *out);

// Answers that are a head alone, after which the connection is closed.
typedef enum orr_ntrip_answer {
    ORR_NTRIP_STREAM,       // 200: data follow
    ORR_NTRIP_TABLE,        // 200: the source table follows, `size` bytes of it
    ORR_NTRIP_UNAUTHORISED, // 401
    ORR_NTRIP_NOT_FOUND,    // 404, of revision 2; revision 1 answers with the source table
    ORR_NTRIP_BAD,          // 400
    ORR_NTRIP_NO_SOURCES,   // 405: only GET
} orr_ntrip_answer;

// The head of an answer.
// Given:
//   r       the request; NULL: none was understood
//   answer  which
//   size    bytes that follow, of the source table
// Returned:
//   text    the head
// Returns its length.
size_t orr_ntrip_head(const orr_ntrip_request *r, orr_ntrip_answer answer, size_t size,
                      char text[ORR_NTRIP_HEAD]);

// Whether a login is that of "user:password", in a time that does not tell how much of it is right.
bool orr_ntrip_login(const char *base64, const char *user_password);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The live page: what it is made of (live_page.html, embedded), and what it asks. Paths: / is the page, /caps what is served, /ask?{...} a
// request of the protocol as one JSON object that is answered once, /events what changes by itself, as server-sent events.
#ifndef ORR_SERVICE_HTTP_LIVE_PAGE_H
#define ORR_SERVICE_HTTP_LIVE_PAGE_H

#include "src/service/http/http_server.h"
#include "src/service/http/journal.h"
#include "src/service/serve/service.h"
#include "src/service/text/ask.h"

typedef struct orr_live_page {
    orr_asked asked;      // what answers; of the pages' thread alone, read only
    orr_service *service; // whose clients are shown
    orr_journal *journal; // whose lines are shown
    orr_client_look client[ORR_CLIENTS_LOOKED];
} orr_live_page;

enum { ORR_LIVE_PAGE_ROUTES = 4, ORR_LIVE_PAGE_EPOCHS = 600 };

// Makes a page's routes. Everything is borrowed.
// Given:
//   server   what answers, with a room of its own
//   streams  the clock and the motion
//   leap     leap seconds; NULL: the table built in
//   service  whose clients are shown
//   journal  whose lines are shown
// Returned:
//   page     the page; free with orr_live_page_close when its server is closed
//   route    [ORR_LIVE_PAGE_ROUTES] its paths
// Errors: ORR_E_MEMORY.
orr_status orr_live_page_open(const orr_server *server, orr_streams *streams, const orr_leap_table *leap,
                              orr_service *service, orr_journal *journal, orr_live_page **page,
                              orr_http_route *route);
void orr_live_page_close(orr_live_page *page); // NULL is allowed

#endif

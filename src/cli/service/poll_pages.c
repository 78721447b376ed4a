// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/service/poll_pages.h"

#include <stdio.h>

#include "core/time.h"

static void print_page(const orr_msg_sat_navdata *s, const orr_msg_nav_page *page)
{
    char time[ORR_TIME_TEXT];
    const char *message = orr_msg_nav_message_name(s->message);
    printf("%s,%c%02u,%s,%.*s,%u,%u,%g,%u,", orr_time_text(page->t, time), s->sat.system, s->sat.number,
           message != NULL ? message : "", (int)s->signals.size, (const char *)s->signals.data, page->number,
           page->page, (double)page->length * 1e-9, page->bits);
    for (uint16_t i = 0; i < page->data.size; i++) printf("%02x", page->data.data[i]);
    putchar('\n');
}

void orr_poll_pages(const orr_msg_navdata *m, bool *headed)
{
    if (!*headed) puts("t_gps,sat,message,signals,number,page,length_s,bits,hex");
    *headed = true;
    orr_msg_sat_navdata s;
    for (orr_wire_iter it = {0}; orr_msg_sat_navdata_next(&m->satellites, &it, &s);) {
        orr_msg_nav_page page;
        for (orr_wire_iter at = {0}; orr_msg_nav_page_next(&s.pages, &at, &page);) print_page(&s, &page);
    }
}

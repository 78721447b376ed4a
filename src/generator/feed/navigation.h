// SPDX-License-Identifier: GPL-3.0-or-later
// What satellites send: pages of navigation data as NAVDATA has them, and the symbol of any instant of a satellite's time.
#ifndef ORR_GENERATOR_FEED_NAVIGATION_H
#define ORR_GENERATOR_FEED_NAVIGATION_H

#include "src/generator/feed/link.h"

typedef struct orr_gen_navigation orr_gen_navigation;

// Makes ready to ask for navigation data; `service` must stay.
bool orr_gen_navigation_open(orr_gen_link *link, const orr_gen_service *service,
                             orr_gen_navigation **navigation, orr_gen_fault *fault);
// Frees it; NULL may be closed.
void orr_gen_navigation_close(orr_gen_navigation *navigation);

// Asks for what is sent between two instants and not yet held; what ended more than a minute before `from` is forgotten.
bool orr_gen_navigation_cover(orr_gen_navigation *navigation, int64_t from_ns, int64_t to_ns,
                              orr_gen_fault *fault);

// The symbol that a satellite sends. May be called from several threads at once, but not while cover() runs.
//
// Given:
//    navigation  what is held
//    signal      place of the signal in service->signal
//    system      letter of the satellite's system
//    number      its number
//    sent_ns     instant of its own time
// The function returns +1 or -1, and 0 where no data are held.
int orr_gen_navigation_symbol(const orr_gen_navigation *navigation, size_t signal, char system,
                              unsigned number, int64_t sent_ns);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of the messages, each in its own file. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_NAVFRAME_PRIVATE_H
#define ORR_ORBIT_NAVDATA_NAVFRAME_PRIVATE_H

#include "orbit/navdata/navframe.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/navdata/page.h"

// The set of a frame: that of its begin, or, in the first frame of a product that begins within it, of t.
const orr_navset_item *navframe_item(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream,
                                     orr_time begin, orr_time t);
// Bits of a page into a piece.
void navframe_take(const orr_page *page, orr_navframe_piece *piece);
// Adds a page to a frame, as its next piece.
//   Given:    page       bits or symbols
//             t, length  as the piece has them
//             number     of the subframe, string or message
//             sub        its page, 0 where it has none
//   Returned: out        the frame with it; the page's status
orr_status navframe_add(const orr_page *page, orr_time t, int64_t length, int number, int sub,
                        orr_navframe *out);

// How many satellites' almanacs are known.
size_t navset_almanacs_known(const navset_almanacs *a);
// The almanacs that a message tells in its turn: one as midi almanac, n as reduced ones, each satellite in its turn.
// Given:
//   a             almanacs of a system on a day
//   midi_turn     counts the messages with a midi almanac
//   reduced_turn  counts those with reduced ones
//   n             reduced almanacs in a message
// Returned:
//   out           the almanacs; none where none is known
void navframe_almanacs(const navset_almanacs *a, int64_t midi_turn, int64_t reduced_turn, size_t n,
                       orr_modern_almanacs *out);

// Fills from, to and the pieces of the frame that holds t; as orr_navframe_at.
typedef orr_status navframe_make(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                                 bool coded, orr_navframe *out, orr_diag *diag);
navframe_make navframe_lnav, navframe_glonass, navframe_inav, navframe_fnav, navframe_d1, navframe_d2,
    navframe_cnav, navframe_cnav2, navframe_bcnav1, navframe_bcnav2, navframe_bcnav3, navframe_navic,
    navframe_sbas;

#endif

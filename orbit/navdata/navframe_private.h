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

// Fills from, to and the pieces of the frame that holds t; as orr_navframe_at.
typedef orr_status navframe_make(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, orr_time t,
                                 bool coded, orr_navframe *out, orr_diag *diag);
navframe_make navframe_lnav, navframe_glonass, navframe_inav, navframe_fnav, navframe_d1, navframe_d2,
    navframe_cnav;

#endif

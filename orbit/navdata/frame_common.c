// SPDX-License-Identifier: GPL-3.0-or-later
// What the frames of all messages share.
#include "orbit/navdata/navframe_private.h"

const orr_navset_item *navframe_item(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream,
                                     orr_time begin, orr_time t)
{
    const orr_navset_item *item = orr_navset_at(set, sat, stream->message, begin);
    return item != NULL ? item : orr_navset_at(set, sat, stream->message, t);
}

void navframe_take(const orr_page *page, orr_navframe_piece *piece)
{
    _Static_assert(ORR_NAVFRAME_BYTES * 8 >= 1800, "the longest page fits");
    piece->bits = (uint16_t)page->n;
    orr_page_pack(page, piece->data);
}

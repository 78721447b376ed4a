// SPDX-License-Identifier: GPL-3.0-or-later
// What the frames of all messages share.
#include "orbit/navdata/navframe_private.h"

const orr_navset_item *navframe_item(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream,
                                     orr_time begin, orr_time t)
{
    const orr_navset_item *item = orr_navset_at(set, sat, stream->message, begin);
    return item != NULL ? item : orr_navset_at(set, sat, stream->message, t);
}

// The k-th satellite, from 0, whose almanac is known; NULL beyond the last.
static const orr_almanac *known(const navset_almanacs *a, size_t k)
{
    for (size_t i = 0; i < sizeof a->has / sizeof *a->has; i++)
        if (a->has[i] && k-- == 0) return &a->sat[i];
    return NULL;
}

size_t navset_almanacs_known(const navset_almanacs *a)
{
    size_t n = 0;
    for (size_t i = 0; i < sizeof a->has / sizeof *a->has; i++) n += a->has[i];
    return n;
}

void navframe_almanacs(const navset_almanacs *a, int64_t midi_turn, int64_t reduced_turn, size_t n,
                       orr_modern_almanacs *out)
{
    const int64_t all = (int64_t)navset_almanacs_known(a), groups = (all + (int64_t)n - 1) / (int64_t)n;
    *out = (orr_modern_almanacs){.toa_s = a->toa_s, .week = a->week};
    if (all == 0) return;
    out->midi = known(a, (size_t)orr_floor_mod(midi_turn, all));
    const size_t first = (size_t)orr_floor_mod(reduced_turn, groups) * n;
    for (size_t k = 0; k < n; k++) out->reduced[k] = known(a, first + k);
}

void navframe_take(const orr_page *page, orr_navframe_piece *piece)
{
    _Static_assert(ORR_NAVFRAME_BYTES * 8 >= 1800, "the longest page fits");
    piece->bits = (uint16_t)page->n;
    orr_page_pack(page, piece->data);
}

orr_status navframe_add(const orr_page *page, orr_time t, int64_t length, int number, int sub,
                        orr_navframe *out)
{
    if (page->status != ORR_OK) return page->status;
    orr_navframe_piece *p = &out->piece[out->n++];
    *p = (orr_navframe_piece){.t = t, .length = length, .number = (uint8_t)number, .page = (uint8_t)sub};
    navframe_take(page, p);
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The gzip stage (RFC 1952): any number of members one after the other, zero padding behind the last one,
// nothing else.
#include <stdlib.h>
#include <zlib.h>

#include "ingest/input/stage.h"

typedef struct gzip_stage {
    orr_stage stage;
    z_stream z;
    bool in_member, at_end;
    uint64_t members;
    uint8_t in[65536];
} gzip_stage;

static orr_status refill(gzip_stage *g, orr_diag *diag)
{
    if (g->z.avail_in > 0) return ORR_OK;
    size_t got = 0;
    orr_status st = orr_stage_read(g->stage.below, g->in, sizeof g->in, &got, diag);
    if (st != ORR_OK) return st;
    g->z.next_in = g->in;
    g->z.avail_in = (uInt)got;
    return ORR_OK;
}

// Between members: the next one, padding, or the end.
static orr_status next_member(gzip_stage *g, orr_diag *diag)
{
    for (;;) {
        orr_status st = refill(g, diag);
        if (st != ORR_OK) return st;
        if (g->z.avail_in == 0) {
            g->at_end = true;
            return ORR_OK;
        }
        if (*g->z.next_in != 0 || g->members == 0) break;
        g->z.next_in++;
        g->z.avail_in--;
    }
    if (*g->z.next_in != 0x1f)
        return orr_diag_at(
            diag, ORR_E_FORMAT, g->stage.name, 0, 0,
            "bytes that are no gzip data follow the compressed text (two files glued together, or "
            "a damaged download)");
    if (g->members > 0 && inflateReset(&g->z) != Z_OK)
        return orr_diag_set(diag, ORR_E_MEMORY, "zlib could not start over");
    g->members++;
    g->in_member = true;
    return ORR_OK;
}

static orr_status gzip_read(orr_stage *self, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag)
{
    gzip_stage *g = (gzip_stage *)self;
    uInt room = capacity < ((uInt)1 << 30) ? (uInt)capacity : (uInt)1 << 30;
    g->z.next_out = buf;
    g->z.avail_out = room;
    while (g->z.avail_out == room && !g->at_end) {
        if (!g->in_member) {
            orr_status st = next_member(g, diag);
            if (st != ORR_OK) return st;
            continue;
        }
        orr_status st = refill(g, diag);
        if (st != ORR_OK) return st;
        if (g->z.avail_in == 0)
            return orr_diag_at(diag, ORR_E_FORMAT, self->name, 0, 0,
                               "the gzip data end early: the file is cut (a broken download?)");
        int r = inflate(&g->z, Z_NO_FLUSH);
        if (r == Z_STREAM_END)
            g->in_member = false;
        else if (r == Z_MEM_ERROR)
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        else if (r != Z_OK && r != Z_BUF_ERROR)
            return orr_diag_at(diag, ORR_E_FORMAT, self->name, 0, 0, "damaged gzip data: %s",
                               g->z.msg != NULL ? g->z.msg : "zlib gives no reason");
    }
    *got = room - g->z.avail_out;
    return ORR_OK;
}

static void gzip_close(orr_stage *self)
{
    inflateEnd(&((gzip_stage *)self)->z);
    free(self);
}

orr_status orr_stage_gzip(orr_stage *below, orr_stage **out, orr_diag *diag)
{
    gzip_stage *g = calloc(1, sizeof *g);
    if (g == NULL || inflateInit2(&g->z, 15 + 16) != Z_OK) {
        free(g);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    g->stage = (orr_stage){.read = gzip_read, .close = gzip_close, .name = below->name, .below = below};
    *out = &g->stage;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/source/navdata_faults.h"

#include <stdio.h>
#include <stdlib.h>
#include <strings.h>

static orr_navset_fault fault_of(const orr_fault_when *w, orr_interval span, orr_navset_fault_kind kind)
{
    return (orr_navset_fault){
        .kind = kind, .sats = w->sats, .from = w->from, .to = w->has_to ? w->to : span.to};
}

orr_status orr_navdata_faults_of(const orr_scenario *s, orr_interval span, orr_navset_fault **list, size_t *n,
                                 orr_diag *diag)
{
    const orr_scenario_faults *o = &s->faults;
    *n = 0;
    *list = calloc(o->unhealthy.n + o->orbit.n + o->stale.n + 1, sizeof **list);
    if (*list == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < o->unhealthy.n; k++)
        (*list)[(*n)++] = fault_of(&o->unhealthy.item[k], span, ORR_NAVSET_FAULT_UNHEALTHY);
    for (size_t k = 0; k < o->orbit.n; k++) {
        const orr_fault_orbit *x = &o->orbit.item[k];
        if (x->wrong != ORR_FAULT_ORBIT_MESSAGE) continue;
        orr_navset_fault *f = &(*list)[(*n)++];
        *f = fault_of(&x->when, span, ORR_NAVSET_FAULT_ORBIT);
        f->displaced_m = (orr_vec3){x->radial_m, x->along_m, x->cross_m};
    }
    for (size_t k = 0; k < o->stale.n; k++) // last: they keep what is sent by then
        (*list)[(*n)++] = fault_of(&o->stale.item[k], span, ORR_NAVSET_FAULT_STALE);
    return ORR_OK;
}

typedef struct inversion {
    orr_sat_set sats;
    orr_time from, to;
    int message; // orr_nav_message; ORR_NAV_NONE: all
    bool has_piece;
    int64_t piece;
    int first, last; // from 0
} inversion;

struct orr_navdata_bits {
    const orr_navset *set;
    size_t n;
    inversion item[];
};

static orr_status refuse(const orr_scenario *s, size_t k, const char *key, const char *why, orr_diag *diag)
{
    char path[60];
    snprintf(path, sizeof path, "faults.bits[%zu].%s", k, key);
    return orr_marks_blame(&s->marks, ORR_E_FORMAT, path, why, diag);
}

// A message by its name; ORR_NAV_NONE where there is none.
static int message_named(const char *name)
{
    size_t n;
    const orr_nav_stream *list = orr_nav_streams(&n);
    for (size_t k = 0; k < n; k++)
        if (strcasecmp(orr_nav_message_name((orr_nav_message)list[k].message), name) == 0)
            return list[k].message;
    return ORR_NAV_NONE;
}

static bool concerns(const inversion *x, const orr_navframe *frame, const orr_navframe_piece *p)
{
    return orr_sat_set_has(&x->sats, frame->sat) && x->from <= p->t && p->t < x->to &&
           (x->message == ORR_NAV_NONE || x->message == (int)frame->stream->message) &&
           (!x->has_piece || x->piece == p->number);
}

// Bits of the longest of a stream's pieces that a fault can be of, in the first minutes of the satellite's data.
static int most_of_stream(const orr_navset *set, const inversion *x, orr_sat sat,
                          const orr_nav_stream *stream)
{
    const orr_navset_item *item;
    int most = 0;
    if (orr_navset_items(set, sat, (orr_nav_message)stream->message, &item) == 0) return 0;
    for (int step = 0; step < 30; step++) { // each type of page comes within 12.5 minutes
        orr_navframe frame;
        const orr_time t = item->from + step * 25 * ORR_NS_PER_S;
        if (orr_navframe_at(set, sat, stream, t, false, &frame, NULL) != ORR_OK) continue;
        for (int i = 0; i < frame.n; i++)
            if (concerns(x, &frame, &frame.piece[i]) && frame.piece[i].bits > most)
                most = frame.piece[i].bits;
    }
    return most;
}

// The same of the first satellite that has any.
static int most_bits(const orr_navset *set, inversion x)
{
    const orr_sat *sat;
    const size_t n = orr_navset_satellites(set, &sat);
    int most = 0;
    x.from = INT64_MIN;
    x.to = INT64_MAX;
    for (size_t k = 0; most == 0 && k < n; k++) {
        const orr_nav_stream *stream[ORR_NAVSET_STREAMS];
        const size_t m = orr_sat_set_has(&x.sats, sat[k]) ? orr_navset_streams(set, sat[k], stream) : 0;
        for (size_t j = 0; j < m; j++) {
            const int bits = most_of_stream(set, &x, sat[k], stream[j]);
            if (bits > most) most = bits;
        }
    }
    return most;
}

static orr_status prepare(const orr_scenario *s, size_t k, orr_interval span, orr_navdata_bits *b,
                          orr_diag *diag)
{
    const orr_fault_bits *o = &s->faults.bits.item[k];
    char why[160];
    inversion *x = &b->item[b->n++];
    *x = (inversion){.sats = o->when.sats,
                     .from = o->when.from,
                     .to = o->when.has_to ? o->when.to : span.to,
                     .message = o->message != NULL ? message_named(o->message) : ORR_NAV_NONE,
                     .has_piece = o->has_piece,
                     .piece = o->piece,
                     .first = (int)o->bit.item[0] - 1,
                     .last = (int)o->bit.item[o->bit.n - 1] - 1};
    if (o->message != NULL && x->message == ORR_NAV_NONE) {
        snprintf(why, sizeof why, "there is no message '%.40s' (LNAV, CNAV, INAV, FNAV, D1, FDMA)",
                 o->message);
        return refuse(s, k, "message", why, diag);
    }
    const int most = most_bits(b->set, *x);
    if (most == 0)
        return refuse(s, k, o->has_piece ? "piece" : "sats", "no satellite named sends such a piece", diag);
    if (x->last < most) return ORR_OK;
    snprintf(why, sizeof why, "such a piece has %d bits", most);
    return refuse(s, k, "bit", why, diag);
}

orr_status orr_navdata_bits_open(const orr_scenario *s, const orr_navset *set, orr_interval span,
                                 orr_navdata_bits **out, orr_diag *diag)
{
    const size_t n = s->faults.bits.n;
    *out = NULL;
    if (n == 0) return ORR_OK;
    orr_navdata_bits *b = calloc(1, sizeof *b + n * sizeof b->item[0]);
    if (b == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    b->set = set;
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < n; k++) status = prepare(s, k, span, b, diag);
    if (status == ORR_OK)
        *out = b;
    else
        free(b);
    return status;
}

void orr_navdata_bits_free(orr_navdata_bits *b) { free(b); }

// Inverts what is sent in from <= t < to of a piece.
static void invert(orr_navframe_piece *p, orr_time from, orr_time to)
{
    const int64_t first = orr_floor_div((from - p->t) * p->bits + p->length - 1, p->length),
                  end = orr_floor_div((to - p->t) * p->bits + p->length - 1, p->length);
    for (int64_t k = first < 0 ? 0 : first; k < end && k < p->bits; k++)
        p->data[k / 8] ^= (uint8_t)(0x80 >> k % 8);
}

void orr_navdata_bits_invert(const orr_navdata_bits *b, orr_navframe *frame)
{
    orr_navframe bits; // of the frame, for the times of its bits
    bool has_bits = false;
    for (size_t k = 0; b != NULL && k < b->n; k++)
        for (int i = 0; i < frame->n; i++) {
            orr_navframe_piece *p = &frame->piece[i];
            if (!concerns(&b->item[k], frame, p)) continue;
            if (!has_bits)
                has_bits =
                    orr_navframe_at(b->set, frame->sat, frame->stream, p->t, false, &bits, NULL) == ORR_OK;
            if (!has_bits || i >= bits.n || bits.piece[i].bits == 0) continue;
            const orr_navframe_piece *q = &bits.piece[i];
            invert(p, q->t + q->length * b->item[k].first / q->bits,
                   q->t + q->length * (b->item[k].last + 1) / q->bits);
        }
}

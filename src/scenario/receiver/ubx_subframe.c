// SPDX-License-Identifier: GPL-3.0-or-later
// UBX-RXM-SFRBX: each subframe, string or page at the first epoch by which it has come in whole. Words of 32 bits: LNAV and BeiDou have 30 in each, the
// rest are left-aligned (ZED-F9P integration manual UBX-18010802, 3.13.1).
#include <string.h>

#include "core/array.h"
#include "core/constants.h"
#include "orbit/navdata/navframe.h"
#include "src/scenario/receiver/port_private.h"

#define WORDS 10
#define FRAMES 64 // of one satellite and stream between two epochs at most

typedef struct subframe {
    uint32_t word[WORDS];
    size_t n;
} subframe;

// Bits [from, from + n) of a piece, right-aligned; n up to 32.
static uint32_t bits_of(const orr_navframe_piece *p, size_t from, size_t n)
{
    uint32_t v = 0;
    for (size_t k = from; k < from + n; k++)
        v = v << 1 | (k < p->bits ? p->data[k / 8] >> (7 - k % 8) & 1u : 0);
    return v;
}

// LNAV: the polarity of a word's 24 data bits, which the bit ahead of it has turned, is taken back (IS-GPS-200N 20.3.5.2).
static void lnav(const orr_navframe_piece *p, subframe *s)
{
    s->n = 10;
    for (size_t k = 0; k < s->n; k++) {
        const uint32_t sent = bits_of(p, 30 * k, 30), before = k > 0 ? bits_of(p, 30 * k - 1, 1) : 0;
        s->word[k] = before != 0 ? sent ^ 0x3fffffc0u : sent;
    }
}

// Every other bit of 30, from the first or the second on: 15.
static uint32_t every_other(uint32_t word, int from)
{
    uint32_t v = 0;
    for (int k = from; k < 30; k += 2) v = v << 1 | (word >> (29 - k) & 1u);
    return v;
}

// D1 and D2: two codewords of BCH(15,11) are sent bit by bit in turns; what they inform of comes first, then their parity
// (BDS-SIS-ICD-B1I 3.0, 5.1.3). The first word has 15 bits without code and one codeword.
static void beidou(const orr_navframe_piece *p, size_t from, subframe *s)
{
    s->n = 10;
    for (size_t k = 0; k < s->n; k++) {
        const uint32_t sent = bits_of(p, from + 30 * k, 30), a = every_other(sent, 0),
                       b = every_other(sent, 1);
        s->word[k] = k == 0 ? sent : (a >> 4) << 19 | (b >> 4) << 8 | (a & 15u) << 4 | (b & 15u);
    }
}

// I/NAV: the even page and the odd one, each filled up to four words. For E1-B receivers have a ninth.
static void inav(const orr_navframe_piece *p, bool e1, subframe *s)
{
    for (size_t k = 0; k < 4; k++) {
        const size_t n = k < 3 ? 32 : 24;
        s->word[k] = bits_of(p, 32 * k, n) << (32 - n);
        s->word[4 + k] = bits_of(p, 120 + 32 * k, n) << (32 - n);
    }
    s->n = e1 ? 9 : 8;
}

static void aligned(const orr_navframe_piece *p, size_t words, subframe *s)
{
    for (size_t k = 0; k < words; k++) s->word[k] = bits_of(p, 32 * k, 32);
    s->n = words;
}

// GLONASS: 85 bits, then the numbers of superframe (which is not told) and frame.
static void glonass(const orr_navframe_piece *p, subframe *s)
{
    aligned(p, 3, s);
    s->word[3] = p->page;
    s->n = 4;
}

// sigId of the component of a signal that carries bits; -1 where UBX does not tell them.
static int component_of(const orr_signal *signal, const orr_nav_stream *x)
{
    static const struct {
        char system;
        const char *signal;
        int number;
    } rows[] = {{'G', "L1CA", 0}, {'G', "L2C", 4},  {'G', "L5", 6},   {'J', "L1CA", 0}, {'J', "L2C", 4},
                {'J', "L5", 8},   {'R', "L1OF", 0}, {'R', "L2OF", 2}, {'E', "E1", 1},   {'E', "E5a", 3},
                {'E', "E5b", 5},  {'C', "B1I", 0},  {'C', "B3I", 4},  {'S', "L1CA", 0}};
    if (x->message == ORR_NAV_D2) return strcmp(signal->name, "B1I") == 0 ? 1 : 10;
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        if (rows[k].system == signal->system && strcmp(rows[k].signal, signal->name) == 0)
            return rows[k].number;
    return -1;
}

// Whether a stream is sent on a signal: its name stands among the stream's.
static bool carries(const orr_nav_stream *x, const orr_signal *signal)
{
    const size_t n = strlen(signal->name);
    for (const char *at = strstr(x->signals, signal->name); at != NULL; at = strstr(at + 1, signal->name))
        if ((at == x->signals || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0')) return true;
    return false;
}

static void send(const orr_port *p, orr_sat sat, int component, const subframe *s, orr_port_bytes *out)
{
    static const uint8_t type[2] = {0x02, 0x13};
    uint8_t data[8 + 4 * WORDS] = {(uint8_t)port_ubx_system(orr_sat_system(sat)),
                                   (uint8_t)port_ubx_satellite(sat),
                                   (uint8_t)component,
                                   (uint8_t)port_ubx_channel(p, sat),
                                   (uint8_t)s->n,
                                   0,
                                   2}; // version
    for (size_t k = 0; k < 4 * s->n; k++) data[8 + k] = (uint8_t)(s->word[k / 4] >> 8 * (k % 4));
    port_ubx_message(type, data, 8 + 4 * s->n, out);
}

// A stream as one of the satellite's observed signals has it.
typedef struct source {
    orr_sat sat;
    const orr_nav_stream *stream;
    int component;
} source;

static void send_piece(const orr_port *p, const source *x, const orr_navframe_piece *piece, size_t part,
                       orr_port_bytes *out)
{
    subframe s = {.n = 0};
    switch (x->stream->message) {
    case ORR_NAV_LNAV:
        lnav(piece, &s);
        break;
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        beidou(piece, 300 * part, &s);
        break;
    case ORR_NAV_FDMA:
        glonass(piece, &s);
        break;
    case ORR_NAV_INAV:
        inav(piece, x->component == 1, &s);
        break;
    case ORR_NAV_CNAV:
        aligned(piece, 10, &s);
        break;
    default:
        aligned(piece, 8, &s); // F/NAV and SBAS
        break;
    }
    send(p, x->sat, x->component, &s, out);
}

// The frame that holds t, kept for the next epoch. *out NULL where the satellite sends nothing then.
static orr_status frame_at(orr_port *p, const source *x, orr_time t, const orr_navframe **out, orr_diag *diag)
{
    char name[ORR_SAT_TEXT], text[ORR_TIME_TEXT];
    size_t k = 0;
    while (k < p->n_frames && (p->frame[k].stream != x->stream || p->frame[k].frame.sat != x->sat)) k++;
    if (k == p->n_frames) {
        if (!ORR_ARRAY_GROW(p->frame, p->n_frames)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        p->frame[p->n_frames++] = (port_frame){.stream = x->stream, .frame = {.sat = x->sat}};
    }
    orr_navframe *f = &p->frame[k].frame;
    *out = f;
    if (f->from <= t && t < f->to) return ORR_OK;
    const orr_navset_item *set;
    const orr_answer answer =
        orr_source_navdata_evaluate(p->plan.navdata, t, x->sat, x->stream, false, &set, f);
    if (answer == ORR_ANSWER_OK) return ORR_OK;
    *f = (orr_navframe){.sat = x->sat}; // from and to alike: it holds no instant
    *out = NULL;
    if (answer != ORR_ANSWER_NO_VALUE) return ORR_OK;
    return orr_diag_set(diag, ORR_E_RANGE, "a value of %s's %s does not fit its field at %s",
                        orr_sat_text(x->sat, name), orr_nav_message_name((orr_nav_message)x->stream->message),
                        orr_time_text(t, text));
}

// What has come in whole within (from, to], instants of sending.
static orr_status send_stream(orr_port *p, const source *x, orr_time from, orr_time to, orr_port_bytes *out,
                              orr_diag *diag)
{
    orr_time t = from;
    for (int n = 0; n < FRAMES && t <= to; n++) {
        const orr_navframe *f = NULL;
        const orr_status s = frame_at(p, x, t, &f, diag);
        if (s != ORR_OK || f == NULL) return s;
        const size_t parts = x->stream->message == ORR_NAV_D2 ? 5 : 1;
        for (size_t j = 0; j < parts * f->n; j++) {
            const orr_navframe_piece *piece = &f->piece[j / parts];
            const orr_time end = piece->t + piece->length * (int64_t)(j % parts + 1) / (int64_t)parts;
            if (end > from && end <= to) send_piece(p, x, piece, j % parts, out);
        }
        t = f->to;
    }
    return ORR_OK;
}

// The streams of a satellite whose observations are item[0 .. n).
static orr_status send_satellite(orr_port *p, const orr_observation *item, size_t n, orr_time t,
                                 orr_port_bytes *out, orr_diag *diag)
{
    orr_status s = ORR_OK;
    const int64_t late = (int64_t)(item->code_m / ORR_LIGHT_MPS * 1e9); // on its way
    const orr_nav_stream *list[ORR_NAVSET_STREAMS];
    const size_t streams = orr_navset_streams(p->navset, item->sat, list);
    for (size_t j = 0; s == ORR_OK && j < streams; j++)
        for (size_t k = 0; k < n; k++) {
            const orr_signal *signal = &p->signal[item[k].signal];
            const source x = {item->sat, list[j], component_of(signal, list[j])};
            if (x.component < 0 || item[k].begins || !carries(list[j], signal)) continue;
            s = send_stream(p, &x, p->before - late, t - late, out, diag);
            break;
        }
    return s;
}

orr_status port_ubx_subframes(orr_port *p, const orr_observed *o, orr_port_bytes *out, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t k = 0, n = 0; p->before != ORR_TIME_NONE && s == ORR_OK && k < o->n; k += n) {
        for (n = 1; k + n < o->n && o->item[k + n].sat == o->item[k].sat;) n++;
        s = send_satellite(p, &o->item[k], n, o->t, out, diag);
    }
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/feed/blocks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "src/generator/feed/subscription.h"

#define CELL_NS 10000000000 // lengths are one in each 10 s of scenario time (docs/channels.md)
#define AHEAD_NS 1000000000 // asked for at once
#define MOST 512            // blocks of them
#define CREDIT 64           // blocks on the way

struct orr_gen_blocks {
    orr_gen_link *link;
    const orr_gen_service *service;
    uint16_t antenna, n_signals;
    uint16_t wanted[ORR_MSG_MAX_SIGNALS];
    uint8_t place[ORR_MSG_MAX_SIGNALS]; // of a signal's number in CAPS
    orr_gen_subscription stream;
    bool polls;       // the service knows no streams
    size_t n, handed; // blocks held, of which those were handed out last
    orr_gen_block block[MOST];
    int64_t length_ns; // of the last blocks
};

void orr_gen_blocks_close(orr_gen_blocks *blocks)
{
    if (blocks == NULL) return;
    for (size_t k = 0; k < MOST; k++) free(blocks->block[k].channel);
    free(blocks);
}

// Strength of the n-th channel of a block against the direct one of its satellite and signal, which stands before its echoes; 1
// where there is none.
static double against_direct(const orr_gen_block *block, size_t n)
{
    const orr_gen_channel *c = &block->channel[n];
    for (size_t k = n; k-- > 0;) {
        const orr_gen_channel *d = &block->channel[k];
        if (!d->echo && d->system == c->system && d->number == c->number && d->signal == c->signal)
            return d->strength > 0 ? c->strength / d->strength : 1.0;
    }
    return 1.0;
}

static bool keep(orr_gen_blocks *b, const orr_msg_channels *m, orr_gen_block *out, orr_gen_fault *fault)
{
    out->begin_ns = m->block;
    out->length_ns = m->length;
    out->error_m = m->error_m;
    out->n = 0;
    if (out->capacity < m->channels.count) {
        orr_gen_channel *larger = realloc(out->channel, m->channels.count * sizeof *larger);
        if (larger == NULL) return orr_gen_fail(fault, "out of memory");
        out->channel = larger;
        out->capacity = m->channels.count;
    }
    orr_msg_sat_channel c;
    orr_wire_iter it = {0};
    while (orr_msg_sat_channel_next(&m->channels, &it, &c)) {
        if (c.signal >= ORR_MSG_MAX_SIGNALS) continue;
        orr_gen_channel *k = &out->channel[out->n++];
        *k = (orr_gen_channel){
            .system = (char)c.sat.system, .number = c.sat.number, .signal = b->place[c.signal]};
        k->power_dbw = (double)c.power_dbw;
        k->strength = pow(10.0, k->power_dbw / 20.0);
        k->echo = c.echo > 0;
        k->share = k->echo ? against_direct(out, out->n - 1) : 1.0;
        k->cubics = (orr_gen_cubics){.block_ns = m->block,
                                     .transmit_ns = c.transmit,
                                     .transmit_rest_ns = c.transmit_fraction_ns,
                                     .carrier_hz = c.carrier_hz};
        memcpy(k->cubics.code_m, c.code, sizeof c.code);
        memcpy(k->cubics.carrier_cycles, c.carrier, sizeof c.carrier);
    }
    return true;
}

// --- A stream: the service makes blocks as fast as there is credit ---

static bool keep_frame(void *user, const orr_frame *f)
{
    orr_gen_blocks *b = user;
    orr_msg_channels m;
    orr_gen_fault fault = {{0}};
    if (orr_msg_channels_decode(f->payload, f->size, &m) != ORR_WIRE_OK || b->n == MOST ||
        m.epoch.answer != ORR_MSG_ANSWER_OK || !keep(b, &m, &b->block[b->n], &fault))
        return false;
    b->n++;
    return true;
}

static orr_wire_status subscribe(orr_gen_blocks *b, int64_t t)
{
    uint8_t payload[ORR_MSG_POLL_CHANNELS_LARGEST];
    orr_wire_writer w = {.data = payload, .capacity = sizeof payload};
    const orr_msg_poll_channels poll = {
        .epochs = {t, 0, 0}, .antenna = b->antenna, .signals = {.count = b->n_signals, .item = b->wanted}};
    const orr_wire_status ws = orr_msg_poll_channels_encode(&poll, &w);
    b->n = b->handed = 0;
    return ws == ORR_WIRE_OK ? orr_gen_subscribe(&b->stream, &w, CREDIT) : ws;
}

// Forgets what was handed out; the room of its channels is used again.
static size_t forget(orr_gen_blocks *b)
{
    const size_t used = b->handed;
    for (size_t k = used; k < b->n; k++) {
        const orr_gen_block kept = b->block[k];
        b->block[k] = b->block[k - used];
        b->block[k - used] = kept;
    }
    b->n -= used;
    b->handed = 0;
    return used;
}

static bool enough(const orr_gen_blocks *b)
{
    if (b->n == 0) return false;
    const orr_gen_block *last = &b->block[b->n - 1];
    return b->n >= CREDIT || last->begin_ns + last->length_ns - b->block[0].begin_ns >= AHEAD_NS;
}

static orr_wire_status listen_to_stream(orr_gen_blocks *b, int64_t t)
{
    const size_t used = forget(b);
    orr_wire_status ws = ORR_WIRE_OK;
    if (orr_gen_subscribed(&b->stream))
        ws = orr_gen_subscription_credit(&b->stream, used);
    else if (!b->stream.ended)
        ws = subscribe(b, t);
    while (ws == ORR_WIRE_OK && !enough(b) && orr_gen_subscribed(&b->stream))
        ws = orr_gen_subscription_wait(&b->stream);
    return ws;
}

bool orr_gen_blocks_open(orr_gen_link *link, const orr_gen_service *service, uint16_t antenna,
                         const uint8_t *signal, size_t n_signals, orr_gen_blocks **blocks,
                         orr_gen_fault *fault)
{
    orr_gen_blocks *b = calloc(1, sizeof *b);
    *blocks = b;
    if (b == NULL) return orr_gen_fail(fault, "out of memory");
    *b = (orr_gen_blocks){
        .link = link, .service = service, .antenna = antenna, .n_signals = (uint16_t)n_signals};
    b->stream = (orr_gen_subscription){.link = link,
                                       .request = ORR_MSG_TYPE_POLL_CHANNELS,
                                       .answer = ORR_MSG_TYPE_CHANNELS,
                                       .keep = keep_frame,
                                       .user = b};
    for (size_t k = 0; k < n_signals; k++) b->wanted[k] = service->signal[signal[k]].number;
    for (size_t k = 0; k < service->n_signals; k++)
        if (service->signal[k].number < ORR_MSG_MAX_SIGNALS) b->place[service->signal[k].number] = (uint8_t)k;
    return true;
}

// --- Questions, where the service knows no streams ---

// Asks for `count` blocks from the one that holds t on, a step apart; those that are the same again are left out.
static orr_wire_status ask(orr_gen_blocks *b, int64_t t, int64_t step, uint32_t count, orr_gen_fault *fault)
{
    orr_client *c = orr_gen_link_client(b->link);
    const orr_msg_poll_channels poll = {.epochs = {t, step, count},
                                        .antenna = b->antenna,
                                        .signals = {.count = b->n_signals, .item = b->wanted}};
    orr_wire_status ws = orr_client_poll_channels(c, &poll);
    for (uint32_t k = 0; k < count && ws == ORR_WIRE_OK; k++) {
        orr_msg_channels m;
        ws = orr_client_channels(c, &m);
        if (ws != ORR_WIRE_OK) break;
        if (m.epoch.answer == ORR_MSG_ANSWER_OK && b->n < MOST &&
            (b->n == 0 || m.block != b->block[b->n - 1].begin_ns)) {
            if (!keep(b, &m, &b->block[b->n++], fault)) return ORR_WIRE_SPACE;
        }
    }
    return ws;
}

// By the length of the last blocks up to the cell's end, so that mostly one question does.
static orr_wire_status ask_from(orr_gen_blocks *b, int64_t t, orr_gen_fault *fault)
{
    const int64_t cell = t - ((t % CELL_NS) + CELL_NS) % CELL_NS + CELL_NS;
    const int64_t until = t + AHEAD_NS < cell ? t + AHEAD_NS : cell;
    const int64_t step = b->length_ns > 0 ? b->length_ns : AHEAD_NS;
    int64_t count = (until - t + step - 1) / step;
    b->n = b->handed = 0;
    return ask(b, t, step, (uint32_t)(count > MOST ? MOST : count), fault);
}

// Blocks that are held from t on; false where there are none.
static bool refill(orr_gen_blocks *b, int64_t t, orr_gen_fault *fault)
{
    for (;;) {
        fault->text[0] = '\0';
        const orr_wire_status ws = b->polls ? ask_from(b, t, fault) : listen_to_stream(b, t);
        if (!b->polls && orr_gen_no_streams(&b->stream, ws)) {
            b->polls = true;
            continue;
        }
        if (fault->text[0] != '\0') return false;
        if (ws != ORR_WIRE_OK) {
            if (!orr_gen_link_again(b->link, ws, b->polls ? "POLL_CHANNELS" : "SUBSCRIBE", fault))
                return false;
            continue;
        }
        if (b->stream.bad) return orr_gen_fail(fault, "a block of the stream cannot be read");
        if (b->n == 0)
            return orr_gen_fail(fault, "the service has no channels at this instant%s%s",
                                b->stream.end[0] != '\0' ? ": " : "", b->stream.end);
        // Blocks that do not join, where questions were asked by another length: what is held up to the first gap is good.
        size_t good = 1;
        while (good < b->n &&
               b->block[good].begin_ns == b->block[good - 1].begin_ns + b->block[good - 1].length_ns)
            good++;
        b->handed = good;
        b->length_ns = b->block[0].length_ns;
        return true;
    }
}

bool orr_gen_blocks_from(orr_gen_blocks *blocks, int64_t t_ns, const orr_gen_block **block, size_t *n,
                         orr_gen_fault *fault)
{
    orr_gen_blocks *b = blocks;
    if (!refill(b, t_ns, fault)) return false;
    *block = b->block;
    *n = b->handed;
    if (t_ns >= b->block[0].begin_ns && t_ns < b->block[0].begin_ns + b->block[0].length_ns) return true;
    return orr_gen_fail(fault,
                        "the service answers with a block that does not hold the instant that was asked for");
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Threads: whatever their number, and whether they share pieces, streams or groups of channels, the bytes are the same.
#include "testing.h"

#include "src/generator/play/crew.h"

enum { CHANNELS = 60, RATE = 2600000, MS = 1000000 };

typedef struct world {
    orr_gen_service service;
    orr_gen_navigation *navigation;
    orr_gen_channel channel[CHANNELS];
    orr_gen_block block[3];
    orr_gen_stream *stream[3];
} world;

// Three blocks, of which the middle one is shorter than a piece.
static void make_blocks(world *w)
{
    static const int64_t length_ms[] = {30, 1, 30};
    int64_t begin = 1426593600000000000;
    for (size_t k = 0; k < 3; k++) {
        w->block[k] = (orr_gen_block){
            .begin_ns = begin, .length_ns = length_ms[k] * MS, .n = CHANNELS, .channel = w->channel};
        begin += length_ms[k] * MS;
    }
    for (size_t k = 0; k < CHANNELS; k++) {
        orr_gen_channel *c = &w->channel[k];
        *c = (orr_gen_channel){
            .system = 'G', .number = (uint8_t)(k % 30 + 1), .signal = k % 2, .strength = 1.3e-8};
        c->cubics = (orr_gen_cubics){.block_ns = w->block[0].begin_ns,
                                     .code_m = {2.1e7 + 1e5 * (double)k, 700.0 - 35.0 * (double)k},
                                     .carrier_cycles = {0.1, 3700.0 - 180.0 * (double)k},
                                     .transmit_ns = w->block[0].begin_ns - 70000000 - 333333 * (int64_t)k,
                                     .carrier_hz = 1575.42e6};
    }
}

static void open_world(world *w)
{
    orr_gen_fault fault = {{0}};
    *w = (world){0};
    w->service.n_signals = 2;
    for (uint16_t k = 0; k < 2; k++)
        w->service.signal[k] =
            (orr_gen_signal_info){.number = k, .system = 'G', .name = "L1CA", .carrier_hz = 1575.42e6};
    make_blocks(w);
    assert_true(orr_gen_navigation_open(NULL, &w->service, &w->navigation, &fault));
    for (size_t k = 0; k < 3; k++) {
        const orr_gen_stream_plan plan = {.rate_hz = RATE,
                                          .centre_hz = 1575420000,
                                          .format = k == 1 ? ORR_GEN_I8 : ORR_GEN_I16,
                                          .noise = k == 1,
                                          .seed = 3,
                                          .cn0_dbhz = ORR_GEN_NO_LEVEL,
                                          .amplitude =
                                              k == 2 ? 3000 : ORR_GEN_NO_LEVEL, // clipped now and then
                                          .signals = k == 2 ? 2 : 3};
        assert_true(orr_gen_stream_open(&w->service, w->navigation, &plan, &w->stream[k], &fault));
        for (size_t b = 0; b < 3; b++) assert_true(orr_gen_stream_ready(w->stream[k], &w->block[b], &fault));
    }
}

static void close_world(world *w)
{
    for (size_t k = 0; k < 3; k++) orr_gen_stream_close(w->stream[k]);
    orr_gen_navigation_close(w->navigation);
}

// Streams from .. to by so many threads, one behind the other in `bytes`; how many samples were clipped.
static uint64_t played(world *w, unsigned threads, size_t streams, int64_t from, int64_t to, uint8_t *bytes)
{
    orr_gen_fault fault = {{0}};
    orr_gen_crew *crew;
    orr_gen_task task[3];
    assert_true(orr_gen_crew_open(threads, &crew, &fault));
    for (size_t k = 0; k < streams; k++)
        task[k] = (orr_gen_task){
            .stream = w->stream[k], .from = from, .to = to, .bytes = bytes + k * 4 * (size_t)(to - from)};
    orr_gen_crew_play(crew, w->block, 3, task, streams);
    uint64_t clipped = 0;
    for (size_t k = 0; k < streams; k++) clipped += task[k].clipped;
    orr_gen_crew_close(crew);
    return clipped;
}

static void same_bytes(void **state)
{
    (void)state;
    world w;
    open_world(&w);
    const int64_t begin = orr_gen_first_sample(w.block[0].begin_ns, RATE);
    // All of it; the short block alone, one piece of several groups; a part that begins and ends within pieces.
    static const int64_t part[][2] = {{0, 158600}, {78000, 80600}, {12345, 81234}};
    size_t most = 0;
    for (size_t i = 0; i < 3; i++)
        for (size_t streams = 1; streams <= 3; streams += 2) {
            const int64_t from = begin + part[i][0], to = begin + part[i][1];
            const size_t size = streams * 4 * (size_t)(to - from);
            uint8_t *one = calloc(1, size), *many = calloc(1, size);
            assert_non_null(one);
            assert_non_null(many);
            const uint64_t clipped = played(&w, 1, streams, from, to, one);
            if (clipped > most) most = (size_t)clipped;
            for (unsigned threads = 2; threads <= 7; threads += 5) {
                memset(many, 0, size);
                assert_true(played(&w, threads, streams, from, to, many) == clipped);
                assert_memory_equal(one, many, size);
            }
            free(one);
            free(many);
        }
    assert_true(most > 0);
    close_world(&w);
}

// Groups of channels follow each other, hold all of them, and each holds as many as 16 bits allow.
static void groups(void **state)
{
    (void)state;
    world w;
    open_world(&w);
    size_t at = 0, n = 0;
    double most = 0, before = 0;
    while (at < CHANNELS) {
        const size_t to = orr_gen_stream_group(w.stream[0], &w.block[0], at, &most);
        assert_true(to > at && to <= CHANNELS);
        assert_true(most - before <= 32000);
        if (to < CHANNELS) assert_true((most - before) * (double)(to - at + 1) / (double)(to - at) > 32000);
        before = most;
        at = to;
        n++;
    }
    assert_true(n > 2);
    close_world(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_bytes), cmocka_unit_test(groups)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

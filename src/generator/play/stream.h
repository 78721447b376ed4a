// SPDX-License-Identifier: GPL-3.0-or-later
// One stream: a centre frequency, a rate, the signals that are played on it, and its samples from blocks. Samples of a stream
// are functions of what the service says and of its options alone: not of where it was begun nor of the number of threads.
#ifndef ORR_GENERATOR_PLAY_STREAM_H
#define ORR_GENERATOR_PLAY_STREAM_H

#include "src/generator/play/voice.h"

#define ORR_GEN_NO_LEVEL (-1.0)

typedef struct orr_gen_stream_plan {
    uint32_t rate_hz;
    int64_t centre_hz;
    orr_gen_format format;
    bool noise;
    uint64_t seed;
    double cn0_dbhz; // of every signal, in place of its own power; ORR_GEN_NO_LEVEL: as the service says it
    double
        amplitude; // in output units, of a signal of ORR_GEN_REFERENCE_DBW or of cn0; ORR_GEN_NO_LEVEL: as the format likes
    uint64_t signals; // places in service->signal, a bit each
} orr_gen_stream_plan;

// The power that an amplitude belongs to: that of GPS L1 C/A at 5 degrees of elevation.
#define ORR_GEN_REFERENCE_DBW (-158.5)
// Noise density to which powers are C/N0: 5.6e-21 W/Hz, as in the service's RINEX files.
#define ORR_GEN_NOISE_DBWHZ (-202.5)

// What a signal lacks to be played in a stream: it must be known, have its main lobe (or half of it) between the stream's edges,
// and at least 8/7 samples a sub-chip.
//
// Given:
//    service    what CAPS says
//    signal     place in service->signal
//    rate_hz    the stream's samples a second
//    centre_hz  its centre frequency
//    wide       whether the whole main lobe is wanted, or the half of it between its points of half the chip rate
// The function returns NULL for a signal that fits, else what is wrong with it, to be put behind its name.
const char *orr_gen_stream_lacks(const orr_gen_service *service, size_t signal, uint32_t rate_hz,
                                 int64_t centre_hz, bool wide);

typedef struct orr_gen_stream orr_gen_stream;

// Makes ready to play.
//
// Given:
//    service     what CAPS says; must stay
//    navigation  what satellites send; must stay
//    plan        what is wanted
// Returned:
//    stream      to be closed
//    fault       why it failed
bool orr_gen_stream_open(const orr_gen_service *service, const orr_gen_navigation *navigation,
                         const orr_gen_stream_plan *plan, orr_gen_stream **stream, orr_gen_fault *fault);
// Frees it; NULL may be closed.
void orr_gen_stream_close(orr_gen_stream *stream);

// Makes ready for the channels of a block; to be called before pieces of it, by one thread.
bool orr_gen_stream_ready(orr_gen_stream *stream, const orr_gen_block *block, orr_gen_fault *fault);

// A piece of a stream within a block.
typedef struct orr_gen_span {
    const orr_gen_block *block;
    int64_t first;
    uint32_t n; // at most ORR_GEN_PIECE
} orr_gen_span;

// The piece that holds sample `at` of a block, whole.
orr_gen_span orr_gen_stream_span(const orr_gen_stream *stream, const orr_gen_block *block, int64_t at);

// Channels of a block from place `from` on whose sum holds in 16 bits: the place behind the last of them. *most grows by what their sum is
// at most.
size_t orr_gen_stream_group(const orr_gen_stream *stream, const orr_gen_block *block, size_t from,
                            double *most);

// What playing needs for itself, one a thread.
typedef struct orr_gen_worker {
    _Alignas(64) int16_t
        re[ORR_GEN_PIECE]; // of a group of channels; in lines of the cache, which vectors then do not cross
    _Alignas(64) int16_t im[ORR_GEN_PIECE];
    orr_gen_scratch scratch;
} orr_gen_worker;

// Sums of a span over a group of its block's channels. Several threads may play at once.
//
// Given:
//    stream    made ready for the block
//    span      the piece
//    from, to  places of the first channel and of the one behind the last
// Returned:
//    worker    re and im: the sums
void orr_gen_stream_mix(const orr_gen_stream *stream, const orr_gen_span *span, size_t from, size_t to,
                        orr_gen_worker *worker);

// Adds a group's sums to those of the groups before.
//
// Given:
//    stream          of the span
//    span            the piece
//    first           whether there are none before it
//    worker          the group's sums
// Returned:
//    sum_re, sum_im  span->n of them
void orr_gen_stream_add(const orr_gen_stream *stream, const orr_gen_span *span, bool first,
                        const orr_gen_worker *worker, int32_t *sum_re, int32_t *sum_im);

// Samples of a span as bytes, orr_gen_output_size(format, span->n) of them, from the sums of all groups. Returns how many were beyond the
// format's range.
uint64_t orr_gen_stream_write(const orr_gen_stream *stream, const orr_gen_span *span,
                              const orr_gen_sums *sums, uint8_t *bytes);

// What was heard: a satellite's signal, and between which instants.
typedef struct orr_gen_heard {
    char system;
    uint8_t number, signal;
    int64_t from_ns, to_ns; // the blocks that had it
} orr_gen_heard;
// All of them in the order in which they came up, once more for each time that they did.
const orr_gen_heard *orr_gen_stream_heard(const orr_gen_stream *stream, size_t *n);
// Satellites that have no code of a signal and are not played.
size_t orr_gen_stream_mute(const orr_gen_stream *stream);

// What it was opened with.
const orr_gen_stream_plan *orr_gen_stream_plan_of(const orr_gen_stream *stream);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that play streams. Each begins with a stream of its own, takes its next piece that nobody has, then those of the other streams; and
// where no piece is left it takes groups of channels of the pieces that others are at. Sums are of integers and a piece is a
// function of its block, so that neither their number nor who did what changes a byte.
#ifndef ORR_GENERATOR_PLAY_CREW_H
#define ORR_GENERATOR_PLAY_CREW_H

#include "src/generator/play/stream.h"

// Samples of one call and stream at most.
#define ORR_GEN_CREW_SAMPLES ((int64_t)1 << 22)

typedef struct orr_gen_crew orr_gen_crew;

// Makes ready for that many threads, at most 64.
bool orr_gen_crew_open(unsigned threads, orr_gen_crew **crew, orr_gen_fault *fault);
// Frees it; NULL may be closed.
void orr_gen_crew_close(orr_gen_crew *crew);

// Samples from .. to - 1 of a stream, at most ORR_GEN_CREW_SAMPLES.
typedef struct orr_gen_task {
    const orr_gen_stream *stream; // made ready for the blocks
    int64_t from, to;             // numbers of the first sample and of the first that is not wanted
    uint8_t *bytes;               // orr_gen_output_size(format, to - from) of them are written there
    uint64_t clipped;             // told: samples that were clipped
    // Where the crew is: the block of the next piece, and its first sample.
    size_t at_block;
    int64_t at;
} orr_gen_task;

// Plays all tasks.
//
// Given:
//    crew         the threads
//    block, n     consecutive blocks that hold all samples of all tasks
//    n_tasks      how many tasks
// Returned:
//    task         their bytes, and what was clipped
void orr_gen_crew_play(orr_gen_crew *crew, const orr_gen_block *block, size_t n, orr_gen_task *task,
                       size_t n_tasks);

// Periods of data components that had no navigation data, up to now.
uint64_t orr_gen_crew_silent(const orr_gen_crew *crew);

#endif

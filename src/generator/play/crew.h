// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that play the pieces of a stream: each takes the next that nobody has. A piece is a function of its block, so that
// their number changes no byte.
#ifndef ORR_GENERATOR_PLAY_CREW_H
#define ORR_GENERATOR_PLAY_CREW_H

#include "src/generator/play/stream.h"

// Samples of one call at most.
#define ORR_GEN_CREW_SAMPLES ((int64_t)1 << 22)

typedef struct orr_gen_crew orr_gen_crew;

// Makes ready for that many threads, at most 64.
bool orr_gen_crew_open(unsigned threads, orr_gen_crew **crew, orr_gen_fault *fault);
// Frees it; NULL may be closed.
void orr_gen_crew_close(orr_gen_crew *crew);

// Samples from .. to - 1 of a stream.
//
// Given:
//    crew      the threads
//    stream    made ready for the blocks
//    block, n  consecutive blocks that hold all of the samples
//    from, to  numbers of the first sample and of the first that is not wanted, ORR_GEN_CREW_SAMPLES apart at most
// Returned:
//    bytes     orr_gen_output_size(format, to - from) of them
// The function returns how many samples were clipped.
uint64_t orr_gen_crew_play(orr_gen_crew *crew, const orr_gen_stream *stream, const orr_gen_block *block,
                           size_t n, int64_t from, int64_t to, uint8_t *bytes);

// Periods of data components that had no navigation data, up to now.
uint64_t orr_gen_crew_silent(const orr_gen_crew *crew);

#endif

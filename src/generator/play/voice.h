// SPDX-License-Identifier: GPL-3.0-or-later
// A satellite's signal as what the mixer plays: tables of sub-chips, and which of them with which sign in each period.
#ifndef ORR_GENERATOR_PLAY_VOICE_H
#define ORR_GENERATOR_PLAY_VOICE_H

#include "src/generator/feed/blocks.h"
#include "src/generator/feed/navigation.h"
#include "src/generator/kernel/kernel.h"
#include "src/generator/kernel/periods.h"

typedef struct orr_gen_voice orr_gen_voice;

// What of a signal of CAPS can be played.
typedef struct orr_gen_played {
    bool known;           // whether it is among those of signals.def
    uint32_t chips_per_s; // of the ranging code
    uint32_t sub_least;   // sub-chips a second without which it cannot be played
} orr_gen_played;

// Whether and how a signal can be played.
orr_gen_played orr_gen_played_of(const orr_gen_signal_info *signal);

// Makes the tables of a satellite's signal for streams of `rate_hz`: sub-carriers that are too fast for the rate are left out.
// False where the satellite has no code of the signal, or without memory; *voice is then NULL.
bool orr_gen_voice_open(const orr_gen_signal_info *signal, unsigned number, uint32_t rate_hz,
                        orr_gen_voice **voice);
// Frees it; NULL may be closed.
void orr_gen_voice_close(orr_gen_voice *voice);

// The largest sample of a signal of amplitude 1, in I or in Q, but for rounding of its parts.
double orr_gen_voice_peak(const orr_gen_voice *voice);

// Room for what is filled while playing, one a thread.
typedef struct orr_gen_scratch {
    int8_t chips[2][20460 + ORR_GEN_CHIPS_BEYOND]; // of two periods
    uint64_t silent;                               // periods for which no navigation data were held
} orr_gen_scratch;

// Where the sum of a piece goes, and by what.
typedef struct orr_gen_piece {
    int64_t first; // number of the first sample since 1980-01-06T00:00:00
    uint32_t n;
    uint32_t rate_hz;
    int64_t centre_hz;
    const orr_gen_kernel *kernel;
    const orr_gen_navigation *navigation;
    orr_gen_scratch *scratch;
    int16_t *re, *im; // whole groups that hold n samples, to which is added
} orr_gen_piece;

// Adds a channel to a piece, with `amplitude` for all of its components.
void orr_gen_voice_play(const orr_gen_voice *voice, const orr_gen_channel *channel, double amplitude,
                        const orr_gen_piece *piece);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// Noise of clocks: five power laws, each by its Allan deviation at 1 s. A pure function of scenario and time.
#ifndef ORR_SCENARIO_EFFECT_CLOCK_NOISE_H
#define ORR_SCENARIO_EFFECT_CLOCK_NOISE_H

#include "src/config/section_clocks.h"
#include "src/scenario/effect/series.h"

// The time error of a clock, s, at nodes 1 s apart.
// Given:
//   law     deviations and seed
//   stream  of random numbers: which clock
//   from    begin of the span
//   to      its end
//   spare   nodes that may still be made
// Returned:
//   spare   less those that were
//   out     the series; free with orr_series_free
// Errors: ORR_E_LIMIT, ORR_E_MEMORY.
// Notes: the variances at 1 s are 3 sx^2 of white phase, h1 (1.038 + 3 ln(pi))/(4 pi^2) of flicker phase at a bandwidth of 0.5 Hz,
// h0/2, 2 ln 2 h-1 and 2 pi^2/3 h-2 (IEEE Std 1139-2008, table B.2). Flicker is a sum of Gauss-Markov processes whose correlation
// times go by factors of two to 15 times the span; that of the frequency and the walk are integrated over each second exactly.
orr_status orr_clock_noise_make(const orr_scenario_clock *law, uint64_t stream, orr_time from, orr_time to,
                                size_t *spare, orr_series *out);

// Takes the line between neighbouring nodes of another clock off, so that it keeps what it has there; before the first and after the last
// the noise is held at zero there.
void orr_clock_noise_pin(orr_series *s, const orr_time *node, size_t n);

#endif

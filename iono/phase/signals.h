// SPDX-License-Identifier: GPL-3.0-or-later
// Carriers by RINEX 3 band, and which two of a satellite's signals make the best geometry-free pair.
#ifndef ORR_IONO_PHASE_SIGNALS_H
#define ORR_IONO_PHASE_SIGNALS_H

#include "core/sat.h"

// Frequency of an observation code ("L1C", "C2W"; band and attribute count) of a system, Hz; 0 if there is
// none. glonass_channel matters for bands 1 and 2 of 'R' alone. rinex_version tells BeiDou's band 1 of 3.02
// (B1I) from B1C.
double orr_signal_frequency_hz(char system, const char *code, int glonass_channel, double rinex_version);

// Preference among observation codes of a band: lower is better, -1 for attributes that the band has not.
int orr_signal_rank(char system, char band, char attribute);

// Band pairs of a system, best first: *pairs is a text of two characters a pair ("1215" = 1 and 2, then 1 and
// 5); "" for none.
const char *orr_signal_band_pairs(char system);

// TECU per metre of (phase 1 - phase 2), f1 > f2: K of Bogdanov 2015, eq. (38).
double orr_tecu_per_metre(double f1_hz, double f2_hz);

#endif

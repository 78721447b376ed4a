// SPDX-License-Identifier: GPL-3.0-or-later
// The signals that satellites send: a signal is one modulated carrier with all its components.
#ifndef ORR_CORE_SIGNAL_H
#define ORR_CORE_SIGNAL_H

#include "core/sat.h"

#define ORR_SIGNAL_CHANNEL_MIN (-7) // of GLONASS' frequency plan (ICD 5.1, table 3.1)
#define ORR_SIGNAL_CHANNEL_MAX 6
#define ORR_MAX_SIGNALS 64 // bits of a set of signals

typedef struct orr_signal {
    char system;
    const char *name;        // "L1CA", "E5a": the name of the interface document
    const char *observation; // RINEX 3 band and attribute, "1C"
    const char *antex;       // frequency code of ANTEX files, "G01"
    double carrier_hz;       // of GLONASS' FDMA signals that of channel 0
    double channel_hz;       // step of a GLONASS frequency channel; 0 for others
    double chips_per_s;      // of the ranging code
    int64_t chips;           // in one period of the primary code
    const char *modulation;  // "BPSK(1)"
    double power_dbw;        // least received power of all components, 5 deg of elevation, 0 dBi
    const char *components;  // "I Q"
} orr_signal;

// All signals, by system and frequency; *n is their number.
const orr_signal *orr_signals(size_t *n);
// All signals of a system, as bits: bit k stands for the k-th of orr_signals.
uint64_t orr_signals_of(char system);
// Signal of a system by its name, whatever the case; NULL where there is none.
const orr_signal *orr_signal_find(char system, const char *name);
// A signal by the scenario's text "G:L1CA", or all signals of that name or system: "L1CA" of every system that has one, "G"
// all of GPS. Sets bit k of *set for the k-th of orr_signals. ORR_E_ARG with a sentence that lists what there is.
orr_status orr_signal_parse(const char *text, uint64_t *set, orr_diag *diag);
// Whether the satellites of a block send a signal, and with which least received power (as orr_signal.power_dbw); block is named as in
// ANTEX or in the IGS satellite metadata file, and what the table of blocks does not know is as the signal itself, NULL and "" too.
bool orr_signal_of_block(const orr_signal *s, const char *block, double *power_dbw);
// Carrier, Hz; channel (GLONASS' frequency channel) matters for FDMA signals alone.
double orr_signal_carrier_hz(const orr_signal *s, int channel);

#endif

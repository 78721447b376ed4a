// SPDX-License-Identifier: GPL-3.0-or-later
// Satellite identity: a system letter and a number as IGS files write it ("G05", "R24", "E36", "C60", "J07",
// "I10", "S20" (PRN 120), "L51" for low orbiters in SP3). One 16-bit value whose order is the order of
// tables.
#ifndef ORR_CORE_SAT_H
#define ORR_CORE_SAT_H

#include "core/status.h"

typedef uint16_t orr_sat; // (system index + 1) << 8 | number; 0 is "none"
#define ORR_SAT_NONE ((orr_sat)0)
#define ORR_SAT_TEXT 8
#define ORR_SYSTEMS "GRECJISL" // in the order of tables
#define ORR_N_SYSTEMS 8

// system is a letter of ORR_SYSTEMS, number 1..99; ORR_SAT_NONE otherwise.
orr_sat orr_sat_make(char system, int number);
// Its number, 1 to 99; 0 for none.
static inline int orr_sat_number(orr_sat s) { return s & 0xff; }
// Place of its system in ORR_SYSTEMS; -1 for none.
static inline int orr_sat_system_index(orr_sat s) { return (s >> 8) - 1; }
#define ORR_SAT_SLOTS (ORR_N_SYSTEMS * 100) // of a table with a place for every satellite
// A satellite's place in such a table; not of ORR_SAT_NONE.
static inline size_t orr_sat_slot(orr_sat s)
{
    return (size_t)orr_sat_system_index(s) * 100 + (size_t)orr_sat_number(s) % 100;
}
// Letter of the satellite's system; '?' for none.
char orr_sat_system(orr_sat s);
// Name of a system by its letter: "GPS", "GLONASS", ...; "?" if unknown.
const char *orr_system_name(char system);
// Exactly three characters: letter (blank means `blank_system`, e.g. 'G' in SP3-a; 0 refuses), two digits (a
// leading blank counts as zero).
orr_sat orr_sat_parse3(const char s[3], char blank_system);
// "G05" or "G5", any case, NUL-terminated; ORR_SAT_NONE if it is none.
orr_sat orr_sat_parse(const char *text);
// Writes "G05" ("---" for none) into buf and returns it.
char *orr_sat_text(orr_sat s, char buf[ORR_SAT_TEXT]);

// A user's list: "G05,R,E01-E09,C" (a letter alone means the whole system; "all"). Zero-initialised holds
// nothing.
typedef struct orr_sat_set {
    uint64_t bit[ORR_N_SYSTEMS][2];
} orr_sat_set;
// Adds a satellite; ORR_SAT_NONE adds nothing.
void orr_sat_set_add(orr_sat_set *set, orr_sat s);
// Whether the set holds a satellite; ORR_SAT_NONE is in none.
bool orr_sat_set_has(const orr_sat_set *set, orr_sat s);
// Reads such a list. ORR_E_ARG with a sentence for what is no satellite, system or ascending range.
orr_status orr_sat_set_parse(const char *text, orr_sat_set *out, orr_diag *diag);

#endif

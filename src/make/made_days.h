// SPDX-License-Identifier: GPL-3.0-or-later
// Days of orbits from nothing: satellites on integrated orbits, as SP3 files of a day each, for archives, figures and benchmarks
// without real files.
#ifndef ORR_MAKE_MADE_DAYS_H
#define ORR_MAKE_MADE_DAYS_H

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"

#define ORR_MADE_SATS 80 // G01-G27, R01-R27, E01-E26
#define ORR_MADE_PATH 1200
#define ORR_MADE_MOST_DAYS 40000

// A change of a satellite's velocity at an instant, along its motion.
typedef struct orr_made_push {
    orr_sat sat;
    orr_time t;
    double along_mps;
} orr_made_push;

typedef struct orr_made_plan {
    const char *folder;      // that is there
    orr_time from;           // midnight (GPS time) that the first day begins with, and where the orbits begin
    size_t days;             // at most ORR_MADE_MOST_DAYS
    int64_t step_ns;         // of which a day has a whole number, of whole seconds
    const orr_sat_set *only; // NULL: all
    const orr_made_push *push; // [n_push], of satellites that are made, within the days, ascending in time
    size_t n_push;
    int jobs;                                // threads, 1 to 256; the files do not depend on it
    void (*done)(void *user, size_t n_done); // called when a day is written; may be NULL
    void *user;
} orr_made_plan;

// Whether a satellite is one of those that can be made.
bool orr_made_has(orr_sat sat);
// The path of day k of a plan, from 0: FOLDER/ORR0TSTFIN_yyyyddd0000_01D_15M_ORB.SP3. ORR_E_LIMIT where it is too long.
orr_status orr_made_path(const orr_made_plan *p, size_t k, char path[ORR_MADE_PATH], orr_diag *diag);
// Whether a plan can be made: ORR_E_ARG (a step or a push as said above it may not be, too many days), ORR_E_NODATA (none of the
// satellites is made).
orr_status orr_made_check(const orr_made_plan *p, orr_diag *diag);
// Makes all days of a plan, each file whole or not at all; of a plan that fails the days before stay.
// Errors: those of orr_made_check, ORR_E_IO, ORR_E_LIMIT, ORR_E_MEMORY, ORR_E_NUMERIC (a push that leaves no orbit).
// Notes: circular orbits of the heights and inclinations of GPS, GLONASS and Galileo at the begin, then integrated in the GCRS:
// gravitation of the Earth (EGM96 to degree 8), Sun and Moon, radiation pressure of 1e-7 m/s2 with the Earth's shadow; the
// Earth turns by UT1 of the leap seconds and the secular pole (IERS Conventions 2010). Clocks have an offset of up to 0.8 ms
// and a common drift of 1e-11. Positions are exact to SP3's last digit of a millimetre.
orr_status orr_made_days(const orr_made_plan *p, orr_diag *diag);

#endif

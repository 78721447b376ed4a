// SPDX-License-Identifier: GPL-3.0-or-later
// ANTEX antenna files, versions 1.3 and 1.4 (Rothacher and Schmid 2010, "ANTEX: The Antenna Exchange Format
// Version 1.4"): phase-centre offsets and variations of satellite and receiver antennas. Lengths in metres,
// angles in degrees as the grids are written.
#ifndef ORR_INGEST_TABLES_ANTEX_H
#define ORR_INGEST_TABLES_ANTEX_H

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"
#include "ingest/input/limits.h"

// One frequency of one antenna.
typedef struct orr_antex_frequency {
    char code[4]; // "G01" = GPS L1, "R02", "E05" ...: system and RINEX band number
    // Mean phase centre: satellite X, Y, Z in its body axes from the centre of mass; receiver North, East, Up
    // from the antenna reference point. Metres.
    double offset_m[3];
    double *pattern_m; // [1 + n_azimuths][n_zeniths]: row 0 is the azimuth mean (NOAZI), the rest 0, dazi, 2
                       // dazi ..
    double offset_rms_m[3]; // NAN where the file has none
} orr_antex_frequency;

typedef struct orr_antex_antenna {
    char type[21];   // satellite: "BLOCK IIR-M"; receiver: antenna and radome, "ASH701945C_M    SNOW"
    char serial[21]; // satellite: "G01"; receiver: number or blank
    char svn[11];    // satellite code "G063"; empty for receivers
    char cospar[11]; // "2011-036A"; empty for receivers
    orr_sat sat;     // ORR_SAT_NONE for receivers
    char sinex_code[11];
    double dazi_deg, zen1_deg, zen2_deg, dzen_deg; // dazi 0: no azimuths. Nadir angles for satellites
    size_t n_azimuths; // rows of azimuths, 0 where dazi is 0; 360 / dazi + 1 otherwise (0 and 360 both)
    size_t n_zeniths;
    orr_time valid_from, valid_until; // GPS scale; ORR_TIME_NONE where open
    size_t n_frequencies;
    orr_antex_frequency *frequency;
} orr_antex_antenna;

typedef struct orr_antex {
    double version;
    char system;                     // 'G', 'R', 'M' ...
    char pcv_type;                   // 'A' absolute, 'R' relative
    char reference[21];              // reference antenna of relative values
    size_t n_antennas, n_satellites; // all; those of satellites
    orr_antex_antenna *antenna;      // file order
} orr_antex;

// Reads a whole file. An antenna whose lines do not make sense is reported and left out, the others are read; a file none of
// whose antennas can be read is refused.
//   Given:    path        the file, plain, gzip or .Z by content
//             limits      what is refused; NULL: the defaults
//   Returned: out         the antennas, to be freed with orr_antex_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_IO, ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY
orr_status orr_antex_read(const char *path, const orr_read_limits *limits, orr_antex *out,
                          orr_warnings *warnings, orr_diag *diag);
// The same from memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out, warnings, diag   as of orr_antex_read, but for ORR_E_IO
orr_status orr_antex_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                           orr_antex *out, orr_warnings *warnings, orr_diag *diag);
// Frees all antennas and leaves *x empty.
void orr_antex_free(orr_antex *x);

// The antenna of a satellite at an instant (valid_from <= t <= valid_until); NULL if the file has none.
const orr_antex_antenna *orr_antex_find_sat(const orr_antex *x, orr_sat sat, orr_time t);
// A receiver antenna by its 20 characters (type and radome); if the radome is not there, the same type with
// NONE, as the IGS does (*radome_ignored tells; may be NULL). NULL if the file has none.
const orr_antex_antenna *orr_antex_find_receiver(const orr_antex *x, const char *type, bool *radome_ignored);
const orr_antex_frequency *orr_antex_find_frequency(const orr_antex_antenna *a,
                                                    const char *code); // "G01"; NULL if none
// Phase-centre variation, metres, bilinear in azimuth and zenith (nadir) angle; the ends of the zenith grid
// are held. az_deg is taken modulo 360 and ignored where the pattern has no azimuths.
double orr_antex_variation_m(const orr_antex_antenna *a, const orr_antex_frequency *f, double az_deg,
                             double zen_deg);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX observation files: 2.00-2.20, 3.00-3.05, 4.00-4.02, plain or Hatanaka-compressed (CRINEX 1.0
// and 3.0), read epoch by epoch in constant memory; and a writer of RINEX 3.05. Sources: RINEX 2.11 (Gurtner
// 2007), 3.05 and 4.02 (IGS/RTCM), Hatanaka 2008 (CRINEX 3.0).
#ifndef ORR_INGEST_RINEX_RINEX_OBS_H
#define ORR_INGEST_RINEX_RINEX_OBS_H

#include "core/sat.h"
#include "core/time.h"
#include "core/vec.h"

#define ORR_OBS_MAX_CODES 128 // observation types of one system; more is ORR_E_LIMIT
#define ORR_OBS_MAX_SATS 512  // satellites of one epoch
#define ORR_OBS_NO_CHANNEL INT8_MIN

// The observation types of one system. `code` is a RINEX 3 code ("C1C", "L2W", "S5Q"); for RINEX 2 it is what
// the type is taken for, and `original` keeps the file's own ("P2"):
//   GPS      C1 C1C, P1 C1W, C2 C2X, P2 C2W, C5 C5X; L1 D1 S1 *1C (L1 is L1W in the files of 2.20 that have
//   LA too,
//            LA being L1C); L2 D2 S2 *2W (*2X where the file has C2 and no P2); L5 *5X
//   GLONASS  C1 C1C, P1 C1P, C2 C2C, P2 C2P; L1 D1 S1 *1C; L2 D2 S2 *2P (*2C where the file has C2 and no P2)
//   Galileo  C1 C1X, C5 C5X, C6 C6X, C7 C7X, C8 C8X and L D S alike
//   SBAS     C1 C1C, C5 C5I and L D S alike; BeiDou (2.12) C2 C2I, C6 C6I, C7 C7I; QZSS as GPS with P2 and L2
//   as *2X
// Types that cannot be mapped have an empty code.
typedef struct orr_obs_codes {
    size_t n;
    char (*code)[4];
    char (*original)[4];
    double *scale;           // SYS / SCALE FACTOR, already divided out of the values; 1 where none
    double *phase_shift_cyc; // SYS / PHASE SHIFT as the header has it (already in the data: nothing to
                             // apply); NAN where the header says nothing of the code
} orr_obs_codes;

typedef struct orr_obs_wavelength { // RINEX 2: half-cycle ambiguities (codeless or squaring receivers)
    int l1, l2;                     // 1 full cycle, 2 half cycle, 0 (l2) single frequency
} orr_obs_wavelength;

typedef struct orr_rinex_obs_header {
    double version;
    char system;   // 'G', 'R', 'E', 'C', 'J', 'I', 'S', 'M'
    bool hatanaka; // came compressed; crinex_version 1.0 or 3.0 then
    double crinex_version;
    char program[24], run_by[24], date[24];
    char marker_name[64], marker_number[24], marker_type[24];
    char observer[24], agency[44];
    char receiver_number[24], receiver_type[24], receiver_version[24];
    char antenna_number[24], antenna_type[24];
    bool has_position;
    orr_vec3 position_m;                          // APPROX POSITION XYZ, ecef
    double antenna_h_m, antenna_e_m, antenna_n_m; // ANTENNA: DELTA H/E/N; NAN if missing
    orr_vec3 antenna_xyz_m;                       // ANTENNA: DELTA X/Y/Z (vehicles); NAN if missing
    orr_vec3 centre_of_mass_m;                    // NAN if missing
    orr_obs_codes codes[ORR_N_SYSTEMS]; // by orr_sat_system_index; n = 0 where the file declares none
    orr_obs_wavelength wavelength;      // default of the file
    orr_obs_wavelength sat_wavelength[ORR_N_SYSTEMS][100]; // of a satellite, 0/0 = default
    int8_t glonass_channel[100];                           // by slot; ORR_OBS_NO_CHANNEL where not given
    bool has_glonass_bias;
    struct {
        char code[4];
        double bias_m; // GLONASS COD/PHS/BIS; NAN if blank
    } glonass_bias[4]; // C1C, C1P, C2C, C2P as a rule
    bool has_leap;
    int leap_s;
    double interval_s; // NAN if missing
    // Of the file's epochs (TIME OF FIRST OBS, else the system's own); values of orr_time are GPS
    orr_scale scale;
    const orr_leap_table *leap; // of labels in UTC and GLONASS time; borrowed; NULL: built-in
    orr_time first, last;       // as the header says; ORR_TIME_NONE if missing
    bool clock_applied;         // RCV CLOCK OFFS APPL
    char signal_unit[24];       // SIGNAL STRENGTH UNIT, e.g. "DBHZ"
    int declared_sats;          // # OF SATELLITES; -1 if missing
} orr_rinex_obs_header;

enum {                          // bits of lli
    ORR_OBS_LLI_SLIP = 1,       // lost lock since the last epoch: cycle slip possible
    ORR_OBS_LLI_HALF_CYCLE = 2, // half-cycle ambiguity or slip possible (2.x: opposite wavelength factor)
    ORR_OBS_LLI_AS = 4,         // 2.x: under antispoofing; 3.x: Galileo BOC tracking of an MBOC signal
};

typedef enum orr_obs_flag { // of an epoch
    ORR_OBS_OK = 0,
    ORR_OBS_POWER_FAILURE = 1, // between this and the previous epoch
    ORR_OBS_START_MOVING = 2,
    ORR_OBS_NEW_SITE = 3, // end of kinematic data: header records (marker) follow
    ORR_OBS_HEADER =
        4, // header records follow (applied to the reader's header before the epoch is handed out)
    ORR_OBS_EXTERNAL = 5,   // external event; its time is significant
    ORR_OBS_CYCLE_SLIP = 6, // satellites and values are slips, not observations
} orr_obs_flag;

// One epoch, valid until the next call. Observation j of satellite i is value[i * stride + j], where j counts
// header->codes[orr_sat_system_index(sat[i])]; in metres, cycles, Hz, dB-Hz, true units (scale factors
// divided out).
typedef struct orr_rinex_obs_epoch {
    orr_time t;            // ORR_TIME_NONE for events without a time
    int flag;              // orr_obs_flag; 0, 1 and 6 carry satellites, 2-5 event lines
    double clock_offset_s; // receiver clock; NAN if missing
    size_t n_sats, stride;
    const orr_sat *sat;
    const double *value; // NAN where missing (blank or 0.0, which RINEX 2 means by it)
    const uint8_t *lli;  // 0 where blank
    const uint8_t *ssi;  // 1..9; 0 where blank (unknown)
    size_t n_event_lines;
    const char *const *event_line; // header or comment lines of an event, as in the file
    bool header_changed;
    int64_t line; // of the epoch in the (decompressed) file, from 1
} orr_rinex_obs_epoch;

typedef struct orr_rinex_obs orr_rinex_obs; // a reader

typedef struct orr_rinex_obs_limits {
    uint64_t max_bytes; // of decompressed text
    uint64_t max_epochs;
    size_t max_header_lines, max_event_lines;
    const orr_leap_table *leap; // that UTC and GLONASS labels are converted by; NULL: built-in
} orr_rinex_obs_limits;
orr_rinex_obs_limits orr_rinex_obs_default_limits(void); // 64 GiB, 100 000 000, 100 000, 999

// Opens a file and reads its header.
//   Given:    path        the file, plain, gzip, .Z or Hatanaka-compressed, by content
//             limits      NULL: the defaults
//   Returned: warnings    complaints that can be lived with, now and while reading; may be NULL, and must outlive
//                         the reader
//             out         the reader, to be closed with orr_rinex_obs_close
//             diag        ORR_E_IO, ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY, ORR_E_UNSUPPORTED
orr_status orr_rinex_obs_open(const char *path, const orr_rinex_obs_limits *limits, orr_warnings *warnings,
                              orr_rinex_obs **out, orr_diag *diag);
// The same from memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, which must outlive the reader; Hatanaka compression is seen
//             limits      NULL: the defaults
//   Returned: warnings, out, diag   as of orr_rinex_obs_open, but for ORR_E_IO
orr_status orr_rinex_obs_open_memory(const char *name, const char *text, size_t n,
                                     const orr_rinex_obs_limits *limits, orr_warnings *warnings,
                                     orr_rinex_obs **out, orr_diag *diag);
// As it stands after the last epoch handed out (events change it); valid until close.
const orr_rinex_obs_header *orr_rinex_obs_header_of(const orr_rinex_obs *r);
// The next epoch or event; *epoch NULL with ORR_OK at the end of the file. A value or a satellite that cannot
// be read is reported to the warnings and left out; so is an epoch whose lines are damaged, and reading goes
// on at the next one; a file cut in the middle of an epoch ends with a warning. After an error the reader can
// only be closed.
orr_status orr_rinex_obs_next(orr_rinex_obs *r, const orr_rinex_obs_epoch **epoch, orr_diag *diag);
uint64_t orr_rinex_obs_skipped(const orr_rinex_obs *r); // epochs left out so far
void orr_rinex_obs_close(orr_rinex_obs *r);             // NULL is allowed

// Index of a code ("L1C") in a system's list, -1 if it is not there.
int orr_obs_code_index(const orr_rinex_obs_header *h, char system, const char *code);

// Writer of RINEX 3.05 and 4.02. The header is written by create; version, hatanaka and scale factors of `h` are ignored
// (values are written unscaled), codes with an empty name are refused. first must be set; last and interval
// are optional. Of 4.02, which has given them up, SYS / PHASE SHIFT and GLONASS COD/PHS/BIS are left out.
typedef struct orr_rinex_obs_writer orr_rinex_obs_writer;
// A header with NAN, "none" and empty lists everywhere; free with orr_rinex_obs_header_free.
void orr_rinex_obs_header_init(orr_rinex_obs_header *h);
// Appends a RINEX 3 code ("C1C") to a system's list. ORR_E_ARG for an unknown system or what is no such code, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_rinex_obs_header_add_code(orr_rinex_obs_header *h, char system, const char *code,
                                         orr_diag *diag);
// Frees the lists of codes and leaves them empty; the rest of the header stays.
void orr_rinex_obs_header_free(orr_rinex_obs_header *h);
// Begins a file.
// Given:
//   path     "-" is stdout; the file is there after commit
//   version  3.05 or 4.02
//   h        header
// Returned:
//   out      the writer; end it with orr_rinex_obs_commit or orr_rinex_obs_abort
//   diag     ORR_E_ARG (another version, no first epoch), ORR_E_IO, ORR_E_MEMORY
orr_status orr_rinex_obs_create(const char *path, double version, const orr_rinex_obs_header *h,
                                orr_rinex_obs_writer **out, orr_diag *diag);
// Flags 0, 1, 6: satellites and values; 2-5: event lines. Values beyond F14.3 are refused (ORR_E_RANGE).
orr_status orr_rinex_obs_write(orr_rinex_obs_writer *w, const orr_rinex_obs_epoch *epoch, orr_diag *diag);
orr_status orr_rinex_obs_commit(orr_rinex_obs_writer *w, orr_diag *diag); // ends w
void orr_rinex_obs_abort(orr_rinex_obs_writer *w); // ends w, leaves no file; NULL is allowed

// Whether any version of RINEX 3 or 4 has an observation code ("C1C", without attribute "C1") for a system.
bool orr_obs_code_is_known(char system, const char *code);

#endif

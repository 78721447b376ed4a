// SPDX-License-Identifier: GPL-3.0-or-later
// SP3 orbit files, versions a, b, c and d (Hilla 2016, "The Extended Standard Product 3 Orbit Format
// (SP3-d)"). Everything a file says is kept in SI units and GPS time; missing values are NAN, never zeros or
// 999999.
#ifndef ORR_INGEST_SP3_SP3_H
#define ORR_INGEST_SP3_SP3_H

#include <stdio.h>

#include "core/sat.h"
#include "core/status.h"
#include "core/time.h"

enum {                                // orr_sp3_record.flags
    ORR_SP3_CLOCK_EVENT = 1 << 0,     // column 75 'E'
    ORR_SP3_CLOCK_PREDICTED = 1 << 1, // column 76 'P'
    ORR_SP3_MANOEUVRE = 1 << 2,       // column 79 'M'
    ORR_SP3_ORBIT_PREDICTED = 1 << 3, // column 80 'P'
};

// One satellite at one epoch. NAN where the file has none (0.000000 positions, 999999.999999 clocks, no
// record). Standard deviations: NAN unknown (blank), INFINITY "too large to be written" (99, 999, 9999).
typedef struct orr_sp3_record {
    double pos_m[3], clock_s;
    double vel_mps[3], clock_rate_sps; // V records; clock_rate is s/s
    float pos_sdev_m[3], clock_sdev_s; // from EP where there is one, else from the P record's exponents
    float vel_sdev_mps[3], clock_rate_sdev_sps;
    uint8_t flags;
} orr_sp3_record;

// The six correlations (xy, xz, xc, yz, yc, zc) of EP and EV records; NAN where there are none.
typedef struct orr_sp3_correlation {
    float p[6], v[6];
} orr_sp3_correlation;

typedef struct orr_sp3 {
    char version;      // 'a'..'d'
    bool has_velocity; // header says V, or V records were found
    char data_used[8], coordinates[8], orbit_type[8], agency[8], file_type[4];
    orr_scale scale;            // of the file's own labels; epoch[] is GPS scale whatever it is
    const orr_leap_table *leap; // of labels in UTC and GLONASS time; borrowed; NULL: built-in
    double interval_s;          // header's
    double pos_vel_base, clock_base;
    size_t n_sats, n_epochs;
    orr_sat *sat;           // header order, then those that only records name
    uint8_t *accuracy_exp;  // sigma = 2^n mm, 0 unknown; one a satellite
    uint32_t *n_records;    // P records the file has of each satellite, missing values included
    orr_time *epoch;        // strictly ascending after reading (unordered files are sorted with a warning)
    orr_sp3_record *record; // [epoch * n_sats + sat]
    orr_sp3_correlation *correlation; // same shape, or NULL when the file has no EP/EV
    size_t n_comments;
    char **comment; // text after "/* ", trailing blanks stripped
} orr_sp3;

// What a reader refuses to pass, whatever the file says.
typedef struct orr_sp3_limits {
    size_t max_bytes; // after decompression
    size_t max_sats, max_epochs, max_comments;
    const orr_leap_table *leap; // that UTC and GLONASS labels are converted by; NULL: built-in
} orr_sp3_limits;
orr_sp3_limits orr_sp3_default_limits(void); // 2 GiB, 999, 1 000 000, 10 000

// Reads a whole file. The rules (docs/formats.md tells them at length): records rule over the header's counts and lists; a record
// or epoch line that cannot be read is left out and reported, and a file in which more is damaged than sound
// is refused; a header line that cannot be understood is refused, because it speaks for all records; a last
// line without its end is not used, because it may be cut. Of two records of one satellite and epoch the
// first is kept.
//   Given:    path        the file, plain, gzip or .Z by content
//             limits      what is refused; NULL: the defaults
//   Returned: out         the orbits, to be freed with orr_sp3_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_IO, ORR_E_KIND (not an SP3), ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_UNSUPPORTED
//                         (a version after d), ORR_E_MEMORY
orr_status orr_sp3_read(const char *path, const orr_sp3_limits *limits, orr_sp3 *out, orr_warnings *warnings,
                        orr_diag *diag);
// The same from memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out, warnings, diag   as of orr_sp3_read, but for ORR_E_IO
orr_status orr_sp3_parse(const char *name, const char *text, size_t n, const orr_sp3_limits *limits,
                         orr_sp3 *out, orr_warnings *warnings, orr_diag *diag);
// Frees all and leaves *sp3 empty.
void orr_sp3_free(orr_sp3 *sp3);

// Allocates a zeroed file of n_sats x n_epochs whose records are all missing (NAN), for the writer's callers.
orr_status orr_sp3_alloc(size_t n_sats, size_t n_epochs, orr_sp3 *out, orr_diag *diag);
// Writes version sp3->version ('a'..'d'), in the time system sp3->scale. What the version cannot hold is
// refused with ORR_E_ARG, never dropped: satellites (85 before d, GPS alone in a), comments (four of 57
// characters before d, 77 in d), EP/EV records before c, epochs finer than 10 ns, numbers wider than their
// columns. Standard deviations are written as the nearest power of pos_vel_base and clock_base (both must be
// above 1 then), or in EP/EV records for records that have correlations or values that are no such power,
// where sp3->correlation is not NULL.
// "-" is stdout. Atomic.
orr_status orr_sp3_write(const orr_sp3 *sp3, const char *path, orr_diag *diag);
// The same to an open stream, which stays open; on refusal part of the text may have been written.
orr_status orr_sp3_print(const orr_sp3 *sp3, FILE *stream, orr_diag *diag);

#endif

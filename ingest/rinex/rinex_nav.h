// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX navigation files: 2.x (GPS, GLONASS, GEO), 3.00-3.05 and 4.00-4.02 (all systems). Everything is in SI
// units and radians and GPS time; the file's own week and seconds are kept beside. A record with a bad field
// is reported and left out; the rest of the file is read. Sources: RINEX 2.11 (Gurtner 2007), 3.05 and 4.02
// (IGS/RTCM), and the systems' ICDs.
#ifndef ORR_INGEST_RINEX_RINEX_NAV_H
#define ORR_INGEST_RINEX_RINEX_NAV_H

#include "core/sat.h"
#include "core/time.h"
#include "core/vec.h"

// Navigation messages, as RINEX 4 names them. In older files the type follows from the system: GPS and QZSS
// LNAV, GLONASS FDMA, BeiDou D2 for the geostationary C01-C05 and C59-C63 and D1 for the rest, Galileo F/NAV
// where the data source word has bit 1 (E5a) and not bits 0 or 2, I/NAV otherwise, NavIC LNAV, SBAS.
typedef enum orr_nav_message {
    ORR_NAV_NONE = 0, // from a header of RINEX 2 or 3
    ORR_NAV_LNAV,     // GPS, QZSS, NavIC
    ORR_NAV_CNAV,     // GPS, QZSS (L2C, L5)
    ORR_NAV_CNV1,     // BeiDou B1C
    ORR_NAV_CNV2,     // GPS, QZSS L1C; BeiDou B2a
    ORR_NAV_CNV3,     // BeiDou B2b
    ORR_NAV_INAV,     // Galileo
    ORR_NAV_FNAV,     // Galileo
    ORR_NAV_D1,       // BeiDou MEO/IGSO
    ORR_NAV_D2,       // BeiDou GEO
    ORR_NAV_FDMA,     // GLONASS
    ORR_NAV_SBAS,
    ORR_NAV_L1NV, // NavIC L1
    ORR_NAV_IFNV, // Galileo, I/NAV or F/NAV (ION, STO)
    ORR_NAV_D1D2, // BeiDou (ION, STO)
    ORR_NAV_CNVX, // CNAV, CNV1-3 (ION, STO, EOP)
    ORR_NAV_L1OC, // GLONASS CDMA: ION, STO and EOP records are read, EPH records are reported and left out
    ORR_NAV_L3OC,
    ORR_NAV_N_MESSAGES
} orr_nav_message;
const char *orr_nav_message_name(orr_nav_message m); // "LNAV", ...; "" for NONE
// Messages with ephemerides that satellites of a system send, bit 1 << orr_nav_message each; 0 for no system.
uint32_t orr_nav_messages_of(char system);
// Reads a user's list of messages with ephemerides, "CNAV,FNAV" (any case), into such bits; CNV1 to CNV3 may be called CNAV2, BCNAV1,
// BCNAV2 and BCNAV3 too. ORR_E_ARG with a sentence.
orr_status orr_nav_messages_parse(const char *text, uint32_t *out, orr_diag *diag);

// Which member of orr_nav_eph's union holds the orbit.
typedef enum orr_nav_kind { ORR_NAV_KEPLER = 1, ORR_NAV_GLONASS, ORR_NAV_GEO } orr_nav_kind;

#define ORR_NAV_NO_IOD (-1)

// Kepler elements and corrections at toe (IS-GPS-200N table 20-II and 30-I; Galileo OS SIS ICD; BDS-SIS-ICD;
// IS-QZSS; IRNSS SIS ICD). delta_n is the mean motion difference (CNAV: at toe), a_dot and delta_n_dot are
// zero in legacy messages. In CNAV and its kin the file gives sqrt(A) of the whole semi-major axis at toe.
typedef struct orr_nav_kepler {
    double sqrt_a_sqrtm, e, m0_rad, i0_rad, omega0_rad,
        omega_rad; // omega0: longitude of the node at the week's start
    double delta_n_radps, idot_radps, omega_dot_radps;
    double cuc_rad, cus_rad, crc_m, crs_m, cic_rad, cis_rad;
    double a_dot_mps, delta_n_dot_radps2;
    // Seconds of the system's own week, as in the file (CNAV and CNV2 of GPS and QZSS: of toc)
    double toe_sow_s;
    double top_sow_s; // time of prediction of CNAV-like messages; NAN otherwise
} orr_nav_kepler;

// GLONASS state at toe in PZ-90 (GLONASS ICD 5.1, 4.4): position, velocity, luni-solar acceleration.
// The clock is clock.af0_s = -tau_n, clock.af1_sps = +gamma_n.
typedef struct orr_nav_glonass {
    orr_vec3 pos_m, vel_mps, acc_mps2;
    int freq_channel;    // -7..13 (k of 1602 + 0.5625 k MHz)
    double age_days;     // E_n
    double frame_time_s; // t_k as in the file (2.x: of the UTC day, 3.x and 4.x: of the UTC week); NAN if
                         // missing
    double delta_tau_s;  // L2 - L1 group delay; NAN where the record has none (before 3.05) or 999999...
    double ura;          // F_T index; NAN as above
    uint32_t status_flags, health_flags; // 3.05 and later; 0 where missing
    bool has_flags;                      // the record had the fourth orbit line with status and health flags
} orr_nav_glonass;

// SBAS geostationary state at toe (RTCA DO-229 message 9).
typedef struct orr_nav_geo {
    orr_vec3 pos_m, vel_mps, acc_mps2;
    double ura_m; // as in the file; NAN if missing
    int iodn;     // ORR_NAV_NO_IOD if missing
} orr_nav_geo;

// Group delays in seconds, NAN where the message does not carry them. Names are the ICDs'.
typedef struct orr_nav_delays {
    double tgd_s;  // GPS, QZSS TGD; NavIC TGD (L5-S); BeiDou D1/D2 TGD1 (B1/B3), CNV3 TGD B2bI
    double tgd2_s; // BeiDou TGD2 (B2/B3); NavIC L1NV TGD (L5-S)
    double bgd_e5a_e1_s, bgd_e5b_e1_s;                           // Galileo
    double isc_l1ca_s, isc_l2c_s, isc_l5i5_s, isc_l5q5_s;        // GPS, QZSS CNAV, CNV2
    double isc_l1cd_s, isc_l1cp_s;                               // GPS, QZSS CNV2
    double isc_b1cd_s, isc_b2ad_s, tgd_b1cp_s, tgd_b2ap_s;       // BeiDou CNV1, CNV2
    double isc_s_l1p_s, isc_l1d_l1p_s, isc_l1p_s_s, isc_l1d_s_s; // NavIC L1NV
} orr_nav_delays;

// One ephemeris. `toc` is the record's epoch (clock reference), `toe` the orbit's: for Kepler records the
// instant with the file's seconds of week that is nearest to toc, so that neither a week boundary nor a week
// number written modulo 1024 or for the transmission instead of toe can move it (a differing `week` is kept
// and reported); for GLONASS and SBAS it is toc. All are GPS scale.
typedef struct orr_nav_eph {
    orr_sat sat;
    uint8_t kind;    // orr_nav_kind
    uint8_t message; // orr_nav_message
    orr_time toe, toc;
    orr_time transmission; // ORR_TIME_NONE if unknown (blank or 0.9999E9)
    int32_t week;   // the file's number (continuous GPS week; BDT week for BeiDou); -1 if it gives none
    int64_t line;   // of the record's first line in the file
    uint32_t order; // among the records of all files that were merged
    double af0_s, af1_sps, af2_sps2; // satellite clock polynomial at toc
    // URA or SISA in metres where the record gives metres; NAN otherwise (Galileo's -1 too)
    double accuracy_m;
    double fit_interval_h; // GPS 4 where blank or 0, QZSS's flag: 2 or 4 (0 = 2 h, 1 = more); NAN for others
    int32_t iode, iodc;    // IODE/IODC, IODnav, AODE/AODC, IODEC; ORR_NAV_NO_IOD where missing
    uint32_t health;       // the file's word, 0 = healthy; 0xffffffff where blank
    uint32_t data_sources; // Galileo data source bits; GPS codes on L2; 0 otherwise
    int32_t l2p_flag, sat_type; // GPS L2 P data flag; BeiDou CNV1-2: 1 GEO, 2 IGSO, 3 MEO; -1 otherwise
    int32_t ura_ed, ura_ned[3]; // CNAV indices; -128 where missing
    int32_t sisai_oe, sisai_ocb, sisai_oc1, sisai_oc2, sismai,
        integrity_flags; // BeiDou CNV1-3; -128 where missing
    orr_nav_delays delay;
    union {
        orr_nav_kepler kepler;
        orr_nav_glonass glonass;
        orr_nav_geo geo;
    };
} orr_nav_eph;

// True where the health word does not forbid the use of the message's own signals: GPS, BeiDou, NavIC,
// GLONASS, SBAS word 0 (SBAS: ranging bit and the two below); Galileo: no health status or data validity bit
// of the bands the message belongs to; QZSS LNAV: bit 0 (L1C/B) is not looked at. A blank word counts as not
// usable.
bool orr_nav_eph_usable(const orr_nav_eph *e);

typedef enum orr_nav_iono_kind {
    ORR_NAV_KLOBUCHAR = 1, // coefficient[0..3] alpha (s, s/semicircle, ...), [4..7] beta
    ORR_NAV_NEQUICK_G, // [0..2] a_i0..a_i2 in sfu, sfu/deg, sfu/deg^2; `flags` the disturbance flags (RINEX
                       // 4)
    ORR_NAV_BDGIM,     // [0..8] alpha_1..alpha_9, TECU
    ORR_NAV_NEQUICK_N, // NavIC: [8 r + 0..7] for region r = 0..2: a_i0..a_i2, IDF, lon min, lon max (deg),
                       // modip min, max
    ORR_NAV_GLONASS_CDMA, // [0..2] c_A, c_F10.7, c_Ap
} orr_nav_iono_kind;

typedef struct orr_nav_iono {
    uint8_t kind;    // orr_nav_iono_kind
    uint8_t message; // orr_nav_message; NONE from a header
    char system;     // whose broadcast it is: 'G', 'E', 'C', 'J', 'I', 'R'
    char time_mark;  // headers of 3.x: 'A'..'X' hour of day; ' ' otherwise
    orr_sat sat;     // who sent it; ORR_SAT_NONE from most headers
    orr_time t;      // transmission; ORR_TIME_NONE from headers
    uint32_t flags;  // Galileo: disturbance flags; QZSS, GPS Klobuchar: region code (0 wide area, 1 Japan)
    int32_t iod;     // NavIC L1NV; ORR_NAV_NO_IOD otherwise
    double coefficient[24]; // NAN beyond the kind's own
    double region_deg[4];   // NavIC L1NV Klobuchar: lon min, max, modip min, max; NAN otherwise
    int64_t line;
} orr_nav_iono;

// System time offset: scale1 - scale2 = a0 + a1 (t - t_ref) + a2 (t - t_ref)^2, code "GPUT" = GPS minus UTC
// and so on.
typedef struct orr_nav_sto {
    char code[8]; // "GPUT", "GAUT", "SBUT", "GLUT", "GPGA", "GAGP", "GLGP", "QZGP", "BDUT", "IRUT", ...
    char sbas_id[20], utc_id[20]; // "EGNOS", "UTC(USNO)", ...; empty if not given
    uint8_t message;
    orr_sat sat;
    orr_time t_ref;        // ORR_TIME_NONE where the file gives none
    orr_time transmission; // ORR_TIME_NONE from headers
    double a0_s, a1_sps, a2_sps2;
    int64_t line;
} orr_nav_sto;

// Earth orientation as broadcast: value(t) = value + rate (t - t_ref) + accel (t - t_ref)^2 as in the
// systems' ICDs.
typedef struct orr_nav_eop {
    orr_sat sat;
    uint8_t message;
    orr_time t_ref, transmission;
    double xp_rad, xp_rate_radps, xp_accel_radps2;
    double yp_rad, yp_rate_radps, yp_accel_radps2;
    double dut1_s, dut1_rate_sps,
        dut1_accel_sps2; // UT1 - UTC (UT1 - GPST for GPS CNAV of some encoders: as the file says)
    int64_t line;
} orr_nav_eop;

typedef struct orr_nav {
    double version; // 2.11, 3.05, 4.00, ...
    char system;    // of the first line: 'G', 'R', 'E', 'C', 'J', 'I', 'S', 'M' (mixed)
    char program[24], run_by[24], date[24];
    bool has_leap;
    int leap_s; // GPS - UTC of the header (BDT - UTC where the file says BDS: leap_scale)
    int leap_future_s, leap_week, leap_day; // announced; 0 where not given
    orr_scale leap_scale;                   // ORR_SCALE_GPS or ORR_SCALE_BDT
    size_t n_eph, n_iono, n_sto, n_eop, n_comments;
    orr_nav_eph *eph;   // ascending in (sat, toe, toc, transmission, message), ties in the file's order
    orr_nav_iono *iono; // header first, then the file's order
    orr_nav_sto *sto;
    orr_nav_eop *eop;
    char **comment;
    size_t n_skipped;           // records left out (each with a warning)
    const orr_leap_table *leap; // of labels in UTC and GLONASS time; borrowed; NULL: built-in
} orr_nav;

typedef struct orr_nav_limits {
    size_t max_bytes; // after decompression
    size_t max_records, max_header_lines;
    const orr_leap_table *leap; // that UTC and GLONASS labels are converted by; NULL: built-in
} orr_nav_limits;
orr_nav_limits orr_nav_default_limits(void); // 2 GiB, 1 000 000, 100 000

// Reads a whole file (plain, gzip, .Z by content). Bad records go one by one to `warnings` (may be NULL) and
// are left out; a file that is no RINEX navigation file, whose header cannot be used, or of which no record
// can be read, is refused. Records of one issue (satellite, message, toe, toc and issue of data) that contradict each other are told
// and all kept; who chooses takes the one transmitted last (orr_broadcast_select).
//   Given:    path        the file, plain, gzip or .Z by content
//             limits      what is refused; NULL: the defaults
//   Returned: out         the records, to be freed with orr_nav_free; empty on failure
//             warnings    complaints that did not stop the reading; may be NULL
//             diag        ORR_E_IO, ORR_E_KIND, ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY, ORR_E_UNSUPPORTED (version)
orr_status orr_nav_read(const char *path, const orr_nav_limits *limits, orr_nav *out, orr_warnings *warnings,
                        orr_diag *diag);
// The same from memory.
//   Given:    name        of the file, for messages
//             text, n     its n bytes, decompressed
//             limits      what is refused; NULL: the defaults
//   Returned: out, warnings, diag   as of orr_nav_read, but for ORR_E_IO
orr_status orr_nav_parse(const char *name, const char *text, size_t n, const orr_nav_limits *limits,
                         orr_nav *out, orr_warnings *warnings, orr_diag *diag);
// Frees all and leaves *nav empty.
void orr_nav_free(orr_nav *nav);

// Several files as one: the ephemerides in the order of orr_nav.eph, of records that agree in all they say one is kept;
// the ionospheres in the files' order. Time offsets, Earth orientation and comments are not carried over.
//   Given:    in, n       the n files
//   Returned: out         all of them, to be freed with orr_nav_free
//             warnings    of records of one issue that contradict each other (as of orr_nav_read); may be NULL
//             diag        ORR_E_MEMORY
orr_status orr_nav_merge(const orr_nav *in, size_t n, orr_nav *out, orr_warnings *warnings, orr_diag *diag);

// The ephemerides of one satellite: *count of them from nav->eph[*first] on, ascending in toe. count 0 if
// none.
void orr_nav_of_sat(const orr_nav *nav, orr_sat sat, size_t *first, size_t *count);

// Writes RINEX 3.05: header (ionosphere, time corrections, leap seconds) and the ephemerides whose message
// that version knows (LNAV, D1/D2, I/NAV, F/NAV, FDMA, SBAS), in the array's order; *n_left_out (may be NULL)
// counts the others. Where nav->version is 4 or more RINEX 4.02: time offsets, Earth orientation, ionosphere and all ephemerides as
// records; of the offsets and coefficients that name no satellite the first of their system with an ephemeris stands for it.
// "-" is stdout. Atomic. nav->program, run_by and date are written as they are.
orr_status orr_nav_write(const orr_nav *nav, const char *path, size_t *n_left_out, orr_diag *diag);

#endif

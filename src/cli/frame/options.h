// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that several commands have in their tables of options: one spelling, letter, kind and way of showing the value
// each. What stands in brackets is further members of the row (.help, .applies, .repeated).
#ifndef ORR_CLI_FRAME_OPTIONS_H
#define ORR_CLI_FRAME_OPTIONS_H

#include "src/cli/frame/cli.h"

// Which satellites; orr_cli_sats.
#define ORR_OPTION_SATS_AS(...)                                                                              \
    {                                                                                                        \
        .name = "sat", .kind = ORR_OPT_SATS, .value = "LIST", __VA_ARGS__                                    \
    }
#define ORR_OPTION_SATS ORR_OPTION_SATS_AS(.help = "Satellites, e.g. G05,R,E01-E09; all by default.")

// Where the output goes; orr_cli_text with "-" otherwise.
#define ORR_OPTION_OUTPUT_AS(...)                                                                            \
    {                                                                                                        \
        .name = "output", .letter = 'o', .kind = ORR_OPT_TEXT, .value = "FILE", .writes = true, __VA_ARGS__  \
    }
#define ORR_OPTION_OUTPUT                                                                                    \
    ORR_OPTION_OUTPUT_AS(                                                                                    \
            .help = "Write to FILE instead of standard output; the file appears whole or not at all.")

// The folder of a command that writes several files.
#define ORR_OPTION_FOLDER(...)                                                                               \
    {                                                                                                        \
        .name = "output", .letter = 'o', .kind = ORR_OPT_TEXT, .value = "DIR", .required = true, __VA_ARGS__ \
    }

// The form of what is printed, `words` divided by '|'; orr_cli_says(c, "format", word).
#define ORR_OPTION_FORMAT_AS(words, usual, ...)                                                              \
    {                                                                                                        \
        .name = "format", .kind = ORR_OPT_CHOICE, .value = words, .fallback = usual, __VA_ARGS__             \
    }
#define ORR_OPTION_FORMAT(words, usual)                                                                      \
    ORR_OPTION_FORMAT_AS(words, usual, .help = "The format of the output; " usual " by default.")
// Of a report: text on stderr or stdout for people, or JSON on stdout.
#define ORR_OPTION_REPORT                                                                                    \
    ORR_OPTION_FORMAT_AS("text|json", "text",                                                                \
                         .help = "The report as text (default), or as JSON on standard output.")
// A series beside the report.
#define ORR_OPTION_SERIES(...)                                                                               \
    {                                                                                                        \
        .name = "csv", .kind = ORR_OPT_TEXT, .value = "FILE", .writes = true, __VA_ARGS__                    \
    }

// Instants.
#define ORR_OPTION_AT(...)                                                                                   \
    {                                                                                                        \
        .name = "at", .letter = 't', .kind = ORR_OPT_TIME, .value = "T", __VA_ARGS__                         \
    }
#define ORR_OPTION_FROM(...)                                                                                 \
    {                                                                                                        \
        .name = "from", .kind = ORR_OPT_TIME, .value = "T", __VA_ARGS__                                      \
    }
#define ORR_OPTION_TO(...)                                                                                   \
    {                                                                                                        \
        .name = "to", .kind = ORR_OPT_TIME, .value = "T", __VA_ARGS__                                        \
    }
#define ORR_OPTION_STEP(...)                                                                                 \
    {                                                                                                        \
        .name = "step", .letter = 's', .kind = ORR_OPT_DURATION, .value = "S", __VA_ARGS__                   \
    }
// The four of a command that prints from orbit products.
#define ORR_OPTION_INSTANTS                                                                                  \
    ORR_OPTION_AT(.help = "One instant, instead of --from, --to and --step."),                               \
        ORR_OPTION_FROM(.applies = "!at", .help = "First instant; where the products begin by default."),    \
        ORR_OPTION_TO(.applies = "!at", .help = "Last instant; where the products end by default."),         \
        ORR_OPTION_STEP(.applies = "!at",                                                                    \
                        .help =                                                                              \
                            "Time from one instant to the next, e.g. 0.1, 30s, 15min; 900 s by default.")

// A place on the Earth; orr_cli_place.
#define ORR_OPTION_RECEIVER(...)                                                                             \
    {                                                                                                        \
        .name = "receiver", .kind = ORR_OPT_PLACE, .value = "LAT,LON,H|ecef:X,Y,Z", __VA_ARGS__              \
    }
// A carrier in MHz; orr_cli_real, orr_cli_real_at.
#define ORR_OPTION_CARRIER(...)                                                                              \
    {                                                                                                        \
        .name = "carrier", .kind = ORR_OPT_REAL, .value = "MHZ", .min = 100, .max = 30000, __VA_ARGS__       \
    }

// Files that a command reads beside its operands.
#define ORR_OPTION_NAV(...)                                                                                  \
    {                                                                                                        \
        .name = "nav", .kind = ORR_OPT_TEXT, .value = "FILE", __VA_ARGS__                                    \
    }
#define ORR_OPTION_MESSAGE(...)                                                                              \
    {                                                                                                        \
        .name = "message", .kind = ORR_OPT_TEXT, .value = "LIST",                                            \
        .help = "Messages of the navigation file to use in the systems that have them, e.g. CNAV,FNAV. By "  \
                "default LNAV, "                                                                             \
                "I/NAV, D1/D2 and FDMA, and of a satellite that has none of these records what there is.",   \
        __VA_ARGS__                                                                                          \
    }
#define ORR_OPTION_ANTEX(...)                                                                                \
    {                                                                                                        \
        .name = "antex", .kind = ORR_OPT_TEXT, .value = "FILE", __VA_ARGS__                                  \
    }
#define ORR_OPTION_BIAS(...)                                                                                 \
    {                                                                                                        \
        .name = "bias", .kind = ORR_OPT_TEXT, .value = "FILE", __VA_ARGS__                                   \
    }
#define ORR_OPTION_ERP(...)                                                                                  \
    {                                                                                                        \
        .name = "erp", .kind = ORR_OPT_TEXT, .value = "FILE", __VA_ARGS__                                    \
    }

// Threads; orr_cli_int with the machine's cores otherwise.
#define ORR_OPTION_JOBS                                                                                      \
    {                                                                                                        \
        .name = "jobs", .letter = 'j', .kind = ORR_OPT_INT, .value = "N", .min = 1, .max = 256,              \
        .help = "Number of threads; the machine's cores by default. The result does not depend on it."       \
    }

// The certificate of a client of tls://; orr_cli_text with NULL otherwise.
#define ORR_OPTION_IDENTITY(...)                                                                             \
    {                                                                                                        \
        .name = "identity", .kind = ORR_OPT_TEXT, .value = "FILE",                                           \
        __VA_ARGS__.help =                                                                                   \
            "For tls://: certificate and key as 'orrery tls' makes them, with ca.pem beside; that of "       \
            "the environment variable ORRERY_IDENTITY by default."                                           \
    }

#endif

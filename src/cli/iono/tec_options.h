// SPDX-License-Identifier: GPL-3.0-or-later
// Options that say how a TEC field is taken, common to the commands that read one.
#ifndef ORR_CLI_IONO_TEC_OPTIONS_H
#define ORR_CLI_IONO_TEC_OPTIONS_H

#include "iono/field/tec_field.h"
#include "src/cli/frame/cli.h"

// Rows of a command's table.
#define ORR_TEC_OPTIONS                                                                                      \
    {.name = "bilinear",                                                                                     \
     .kind = ORR_OPT_FLAG,                                                                                   \
     .help = "Take maps as they are, bilinear; no refit. Maps of a region always are."},                     \
        {.name = "degree",                                                                                   \
         .applies = "!bilinear",                                                                             \
         .kind = ORR_OPT_INT,                                                                                \
         .value = "N",                                                                                       \
         .min = 0,                                                                                           \
         .max = ORR_HARM_MAX_DEGREE,                                                                         \
         .help = "Degree of the refit of maps; 15 by default."},                                             \
        {.name = "between",                                                                                  \
         .fallback = "rotated",                                                                              \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .value = "nearest|linear|rotated",                                                                  \
         .help = "Between epochs: the nearest map; linear; or linear with the Earth turned under the maps "  \
                 "(default)."},                                                                              \
        {.name = "rotation",                                                                                 \
         .applies = "between=rotated",                                                                       \
         .kind = ORR_OPT_REAL,                                                                               \
         .value = "P",                                                                                       \
         .min = 0,                                                                                           \
         .max = 1,                                                                                           \
         .help = "Part of the Sun's motion that `rotated` follows; 1 by default."},                          \
        {.name = "model",                                                                                    \
         .fallback = "auto",                                                                                 \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .value = "auto|gps|qzss|navic|beidou|bdgim|nequick",                                                \
         .help = "Which broadcast model of a navigation file; by default (auto) the first that it has."},    \
        {.name = "nequick",                                                                                  \
         .kind = ORR_OPT_TEXT,                                                                               \
         .value = "FOLDER",                                                                                  \
         .help =                                                                                             \
             "Tables of NeQuick-G, for Galileo's coefficients: ccir11.asc to ccir22.asc and modip.asc."},    \
    {                                                                                                        \
        .name = "mapping", .kind = ORR_OPT_CHOICE, .value = "none|thin-shell|mslm",                          \
        .help = "Slant from vertical; mslm by default."                                                      \
    }

// Reads them; an exit status.
int orr_tec_options_ask(const orr_cli *c, orr_tec_options *out);
// One line on how well a refit meets its maps; nothing for other fields.
void orr_tec_fit_say(const orr_cli *c, const orr_tec_field *f);

#endif

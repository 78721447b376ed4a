// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the sections' tables in short. `T` is the struct of the table, `of` its conditions (NULL:
// none); a required number has no default.
#ifndef ORR_CONFIG_ROWS_PRIVATE_H
#define ORR_CONFIG_ROWS_PRIVATE_H

#include "src/config/schema.h"

#define TEXT_ROW(T, n, m, of, h)                                                                             \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_TEXT, .offset = offsetof(T, m), .only = of, .help = h                     \
    }
#define FILE_ROW(T, n, m, of, h)                                                                             \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_FILE, .offset = offsetof(T, m), .only = of, .help = h                     \
    }
#define FILES_ROW(T, n, m, of, h)                                                                            \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_FILE, .list = true, .offset = offsetof(T, m), .only = of, .help = h       \
    }
#define BOOL_ROW(T, n, m, dflt, of, h)                                                                       \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_BOOL, .offset = offsetof(T, m), .fallback = dflt, .only = of, .help = h   \
    }
#define INT_ROW(T, n, m, lo, hi, dflt, of, h)                                                                \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_INT, .offset = offsetof(T, m), .min = lo, .max = hi, .fallback = dflt,    \
        .only = of, .help = h                                                                                \
    }
#define REAL_ROW(T, n, m, lo, hi, u, dflt, of, h)                                                            \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .offset = offsetof(T, m), .min = lo, .max = hi, .unit = u,          \
        .fallback = dflt, .only = of, .help = h                                                              \
    }
#define NEEDED_REAL_ROW(T, n, m, lo, hi, u, of, h)                                                           \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .required = true, .offset = offsetof(T, m), .min = lo, .max = hi,   \
        .unit = u, .only = of, .help = h                                                                     \
    }
#define REALS_ROW(T, n, m, u, of, h)                                                                         \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .list = true, .offset = offsetof(T, m), .unit = u, .only = of,      \
        .help = h                                                                                            \
    }
#define CHOICE_ROW(T, n, m, words, dflt, of, h)                                                              \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_CHOICE, .offset = offsetof(T, m), .choice = words, .fallback = dflt,      \
        .only = of, .help = h                                                                                \
    }
#define NEEDED_CHOICE_ROW(T, n, m, words, of, h)                                                             \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_CHOICE, .required = true, .offset = offsetof(T, m), .choice = words,      \
        .only = of, .help = h                                                                                \
    }
#define MAP_ROW(T, n, m, table, of, h)                                                                       \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_MAP, .offset = offsetof(T, m), .map = table, .only = of, .help = h        \
    }
#define MAPS_ROW(T, n, m, table, most_, of, h)                                                               \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_MAP, .list = true, .offset = offsetof(T, m), .map = table, .most = most_, \
        .only = of, .help = h                                                                                \
    }

#define ORR_SCHEMA(rows, T)                                                                                  \
    {                                                                                                        \
        .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(T)                                    \
    }

#endif

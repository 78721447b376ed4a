// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_crossovers.h"

#include "src/config/rows_private.h"

static const orr_choice filters[] = {ORR_GRAVITY_FILTERS(ORR_CHOICE_WORD){0}};
static const orr_condition of_kalman[] = {{.key = "kind", .words = "kalman"}, {0}};

#define DURATION_ROW(T, n, m, dflt, h)                                                                       \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_DURATION, .offset = offsetof(T, m), .unit = "s", .fallback = dflt,        \
        .help = h                                                                                            \
    }

static const orr_key receiver_rows[] = {
    REAL_ROW(orr_study_receiver, "rate", rate_hz, 0.1, 100, "Hz", "2", NULL, "of the receiver's places"),
    REAL_ROW(orr_study_receiver, "white", white_m, 0, 100, "m", "0.003", NULL,
             "standard deviation of a place along each axis, by itself"),
    REAL_ROW(orr_study_receiver, "wander", wander_m, 0, 100, "m", "0.02", NULL, "and of what wanders"),
    REAL_ROW(orr_study_receiver, "wander_time", wander_s, 1e-3, 1e6, "s", "600", NULL,
             "correlation time of that"),
};
static const orr_key alignment_rows[] = {
    REAL_ROW(orr_study_start, "tilt", tilt_arcsec, 0, 1e5, "arcsec", "3", NULL,
             "standard deviation of each tilt at the begin"),
    REAL_ROW(orr_study_start, "heading", heading_arcsec, 0, 1e5, "arcsec", "60", NULL, "of the heading"),
};
static const orr_key filter_rows[] = {
    CHOICE_ROW(orr_study_filter, "kind", kind, filters, "fir", NULL, "which filter"),
    DURATION_ROW(orr_study_filter, "length", length_ns, "100",
                 "standard deviation, period, or correlation time of gravity"),
    REAL_ROW(orr_study_filter, "model", model_mgal, 1e-3, 1e4, "mGal", "20", of_kalman,
             "standard deviation of gravity along a line"),
    REAL_ROW(orr_study_filter, "height_sigma", height_m, 1e-6, 100, "m", "0.02", of_kalman,
             "standard deviation of heights a sample"),
};
static const orr_key line_rows[] = {
    REAL_ROW(orr_study_lines, "turn", turn_degps, 1e-3, 10, "deg/s", "1", NULL,
             "what turns faster, as a mean over 10 s, is no line"),
    DURATION_ROW(orr_study_lines, "least", least_ns, "60", "shorter lines are left out"),
    DURATION_ROW(orr_study_lines, "margin", margin_ns, "100",
                 "what is cut off either end of a line, where the filter reaches into the turn"),
};
static const orr_schema receiver_table = ORR_SCHEMA(receiver_rows, orr_study_receiver);
static const orr_schema alignment_table = ORR_SCHEMA(alignment_rows, orr_study_start);
static const orr_schema filter_table = ORR_SCHEMA(filter_rows, orr_study_filter);
static const orr_schema line_table = ORR_SCHEMA(line_rows, orr_study_lines);

#define T orr_study_crossovers
static const orr_key rows[] = {
    ORR_STUDY_HEAD(T),
    {.name = "scenario",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(T, scenario),
     .help = "whose flight and gravity it is"},
    {.name = "errors",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(T, errors),
     .help = "errors of the sensors"},
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(T, duration_ns),
     .unit = "s",
     .help = "of the flight. Default: all of it"},
    MAP_ROW(T, "receiver", receiver, &receiver_table, NULL,
            "the satellite receiver whose track takes the place of the motion"),
    MAP_ROW(T, "alignment", alignment, &alignment_table, NULL, "errors of the attitude at the begin"),
    MAP_ROW(T, "filter", filter, &filter_table, NULL, "of gravity"),
    MAP_ROW(T, "lines", lines, &line_table, NULL, "how lines are found"),
    INT_ROW(T, "seeds", seeds, 1, 1000, "3", NULL, "flights, each with its own errors"),
};
const orr_schema orr_study_crossovers_schema = {.key = rows,
                                                .n = sizeof rows / sizeof rows[0],
                                                .size = sizeof(T),
                                                .hint = "'orrery crossovers --help-study' lists all"};

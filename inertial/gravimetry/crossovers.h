// SPDX-License-Identifier: GPL-3.0-or-later
// Crossovers of a survey: where lines and tie lines cross, the differences of gravity there, and levelling by a constant a line.
// The statistics that campaigns report.
#ifndef ORR_INERTIAL_GRAVIMETRY_CROSSOVERS_H
#define ORR_INERTIAL_GRAVIMETRY_CROSSOVERS_H

#include "core/status.h"

#define ORR_SURVEY_MOST_LINES 200

// A series over a flight: places on a plane and gravity, at equal steps.
typedef struct orr_survey_series {
    size_t n;
    double step_s;
    const double *east_m, *north_m; // [n]
    const double *mgal;             // [n]
} orr_survey_series;

// Samples [from, to) of a straight line.
typedef struct orr_survey_line {
    size_t from, to;
    double course_rad;
    double level_mgal; // what levelling takes off it
} orr_survey_line;

// Stretches that are flown straight for longer than least_s: the course turns by less than turn_radps, as a mean over 10 s.
//   Given:    s             places
//             turn_radps    e.g. a tenth of the rate of a turn
//             least_s       shorter ones are left out
//             margin_s      is cut off either end
//   Returned: line          [ORR_SURVEY_MOST_LINES]
//             n             how many
//   Notes:    ORR_E_LIMIT, ORR_E_NODATA (none).
orr_status orr_survey_lines(const orr_survey_series *s, double turn_radps, double least_s, double margin_s,
                            orr_survey_line *line, size_t *n, orr_diag *diag);

typedef struct orr_crossover {
    size_t a, b;            // lines
    double at_a, at_b;      // samples, with a fraction
    double difference_mgal; // of gravity, a less b
    double levelled_mgal;   // the same after levelling
} orr_crossover;

typedef struct orr_crossover_report {
    size_t n;
    double rms_mgal, levelled_rms_mgal; // of the differences; over sqrt(2) they are the error of one line
    double mean_mgal;
} orr_crossover_report;

// Finds the crossings of lines whose courses differ by 30 degrees and more, and levels the lines: one constant each, of mean
// zero over all, that makes the squares of differences least.
//   Given:    s             places and gravity
//             line, n       lines
//   Returned: line          with their levels
//             out           crossovers, to be freed with free()
//             report        their statistics
//   Notes:    ORR_E_NODATA (no crossings), ORR_E_NUMERIC, ORR_E_MEMORY. Of m crossings and k lines that hang together, levelling
//             takes k - 1 degrees of freedom, for which the levelled r.m.s. is corrected.
orr_status orr_crossovers(const orr_survey_series *s, orr_survey_line *line, size_t n, orr_crossover **out,
                          orr_crossover_report *report, orr_diag *diag);

#endif

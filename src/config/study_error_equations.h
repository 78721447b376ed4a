// SPDX-License-Identifier: GPL-3.0-or-later
// File of the study `orrery error-equations`.
#ifndef ORR_CONFIG_STUDY_ERROR_EQUATIONS_H
#define ORR_CONFIG_STUDY_ERROR_EQUATIONS_H

#include "src/config/study.h"

#define ORR_ERROR_METHODS_WORDS(X)                                                                           \
    X(ORR_ERROR_WORD_EULER, "euler", "first order")                                                          \
    X(ORR_ERROR_WORD_MIDPOINT, "midpoint", "second order")                                                   \
    X(ORR_ERROR_WORD_RUNGE_KUTTA, "runge-kutta", "fourth order")
typedef enum orr_error_method_word { ORR_ERROR_METHODS_WORDS(ORR_CHOICE_VALUE) } orr_error_method_word;

#define ORR_ERROR_MODELS_WORDS(X)                                                                            \
    X(ORR_ERROR_WORD_PHI, "phi", "geographic axes, phi-angle")                                               \
    X(ORR_ERROR_WORD_PSI, "psi", "vectors over the Earth, psi-angle")                                        \
    X(ORR_ERROR_WORD_DYNAMIC, "dynamic", "dynamic and kinematic parts, absolute velocity")
typedef enum orr_error_model_word { ORR_ERROR_MODELS_WORDS(ORR_CHOICE_VALUE) } orr_error_model_word;

#define ORR_ERROR_VERTICALS(X)                                                                               \
    X(ORR_ERROR_VERTICAL_HELD, "held", "height and vertical velocity are the true ones")                     \
    X(ORR_ERROR_VERTICAL_FREE, "free", "as they come: they diverge")
typedef enum orr_error_vertical { ORR_ERROR_VERTICALS(ORR_CHOICE_VALUE) } orr_error_vertical;

#define ORR_ERROR_GRADIENTS(X)                                                                               \
    X(ORR_ERROR_GRADIENT_FIELD, "field", "that of the field that is navigated in")                           \
    X(ORR_ERROR_GRADIENT_ROUND, "round", "of a round Earth: -g/R along the horizon, 2 g/R upwards")
typedef enum orr_error_gradient { ORR_ERROR_GRADIENTS(ORR_CHOICE_VALUE) } orr_error_gradient;

#define ORR_ERROR_QUANTITIES(X)                                                                              \
    X(ORR_ERROR_QUANTITIES_OWN, "own", "those that each formulation propagates")                             \
    X(ORR_ERROR_QUANTITIES_MISTAKEN, "geographic",                                                           \
      "differences of geographic coordinates and angles for all: the usual mistake, right for phi alone")
typedef enum orr_error_quantities { ORR_ERROR_QUANTITIES(ORR_CHOICE_VALUE) } orr_error_quantities;

typedef struct orr_study_manoeuvre {
    char *name, *scenario;
    int64_t duration_ns;
} orr_study_manoeuvre;

typedef struct orr_study_initial {
    orr_real_list position_m, velocity_mps, attitude_arcsec;
} orr_study_initial;

typedef struct orr_int_list {
    size_t n;
    int *item;
} orr_int_list;

typedef struct orr_study_errors {
    orr_study_head head;
    struct {
        size_t n;
        orr_study_manoeuvre *item;
    } manoeuvres;
    char *errors;
    orr_study_initial initial;
    orr_real_list sizes, steps_s;
    orr_int_list methods, models; // words above
    int vertical, gradient, quantities;
    double rate_hz;
    int64_t compare_ns;
} orr_study_errors;

extern const orr_schema orr_study_errors_schema;

#endif

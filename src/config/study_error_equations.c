// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_error_equations.h"

#include "src/config/rows_private.h"

static const orr_choice methods[] = {ORR_ERROR_METHODS_WORDS(ORR_CHOICE_WORD){0}};
static const orr_choice models[] = {ORR_ERROR_MODELS_WORDS(ORR_CHOICE_WORD){0}};
static const orr_choice verticals[] = {ORR_ERROR_VERTICALS(ORR_CHOICE_WORD){0}};
static const orr_choice gradients[] = {ORR_ERROR_GRADIENTS(ORR_CHOICE_WORD){0}};
static const orr_choice quantities[] = {ORR_ERROR_QUANTITIES(ORR_CHOICE_WORD){0}};

static const orr_key manoeuvre_rows[] = {
    TEXT_ROW(orr_study_manoeuvre, "name", name, NULL, "in the results; by default the scenario's file"),
    {.name = "scenario",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_manoeuvre, scenario),
     .help = "whose trajectory it is"},
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_manoeuvre, duration_ns),
     .help = "instead of the scenario's"},
};
static const orr_schema manoeuvre_table = ORR_SCHEMA(manoeuvre_rows, orr_study_manoeuvre);

static const orr_key initial_rows[] = {
    REALS_ROW(orr_study_initial, "position", position_m, "m", NULL, "East, North, up"),
    REALS_ROW(orr_study_initial, "velocity", velocity_mps, "m/s", NULL,
              "East, North, up, each component in its own axes"),
    REALS_ROW(orr_study_initial, "attitude", attitude_arcsec, "arcsec", NULL,
              "turns about East, North, up: alignment errors"),
};

static const char *check_initial(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_initial *i = map;
    const orr_real_list *const list[] = {&i->position_m, &i->velocity_mps, &i->attitude_arcsec};
    static const char *const name[] = {"position", "velocity", "attitude"};
    for (size_t k = 0; k < 3; k++)
        if (list[k]->n != 0 && list[k]->n != 3) {
            snprintf(why, ORR_SCHEMA_WHY, "%zu values; three are wanted: East, North, up", list[k]->n);
            return name[k];
        }
    return NULL;
}
static const orr_schema initial_table = {.key = initial_rows,
                                         .n = sizeof initial_rows / sizeof initial_rows[0],
                                         .size = sizeof(orr_study_initial),
                                         .check = check_initial};

static const orr_key rows[] = {
    ORR_STUDY_HEAD(orr_study_errors),
    {.name = "manoeuvres",
     .kind = ORR_KEY_MAP,
     .list = true,
     .required = true,
     .offset = offsetof(orr_study_errors, manoeuvres),
     .map = &manoeuvre_table,
     .least = 1,
     .most = 16,
     .help = "trajectories"},
    {.name = "errors",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_errors, errors),
     .help = "errors of the sensors, at size 1"},
    MAP_ROW(orr_study_errors, "initial", initial, &initial_table, NULL, "errors at the start, at size 1"),
    {.name = "sizes",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_study_errors, sizes),
     .min = 1e-9,
     .max = 1e9,
     .least = 1,
     .most = 32,
     .fallback = "1",
     .help = "factors of all errors"},
    {.name = "steps",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_study_errors, steps_s),
     .min = 1e-4,
     .max = 1e4,
     .least = 1,
     .most = 16,
     .unit = "s",
     .fallback = "1",
     .help = "of the integration; whole numbers of readings, and divisors of `compare`"},
    {.name = "methods",
     .kind = ORR_KEY_CHOICE,
     .list = true,
     .offset = offsetof(orr_study_errors, methods),
     .choice = methods,
     .least = 1,
     .most = 3,
     .fallback = "runge-kutta",
     .help = "of the integration"},
    {.name = "models",
     .kind = ORR_KEY_CHOICE,
     .list = true,
     .offset = offsetof(orr_study_errors, models),
     .choice = models,
     .least = 1,
     .most = 3,
     .help = "formulations; without it all three"},
    CHOICE_ROW(orr_study_errors, "vertical", vertical, verticals, "held", NULL, "the vertical channel"),
    CHOICE_ROW(orr_study_errors, "gradient", gradient, gradients, "field", NULL,
               "change of gravity with place, in the equations"),
    CHOICE_ROW(orr_study_errors, "quantities", quantities, quantities, "own", NULL, "that are compared"),
    REAL_ROW(orr_study_errors, "rate", rate_hz, 0.1, 1000, "Hz", "10", NULL, "of the readings"),
    {.name = "compare",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_errors, compare_ns),
     .unit = "s",
     .fallback = "20",
     .help = "from one comparison to the next; a multiple of five readings"},
};
const orr_schema orr_study_errors_schema = {.key = rows,
                                            .n = sizeof rows / sizeof rows[0],
                                            .size = sizeof(orr_study_errors),
                                            .hint = "'orrery error-equations --help-study' lists all"};

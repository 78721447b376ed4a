// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_alignment.h"

#include "src/config/rows_private.h"

static const orr_choice methods[] = {ORR_SELF_METHODS(ORR_CHOICE_WORD){0}};

static const orr_choice kinds[] = {ORR_ALIGNMENT_KINDS(ORR_CHOICE_WORD){0}};
static const orr_condition of_self[] = {{.key = "kind", .words = "self"}, {0}};
static const orr_condition of_transfer[] = {{.key = "kind", .words = "transfer"}, {0}};

static const orr_key self_rows[] = {
    CHOICE_ROW(orr_study_self, "method", method, methods, "inertial", NULL, "how angles are found"),
    {.name = "window",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_self, window_ns),
     .unit = "s",
     .fallback = "10min",
     .help = "length of one alignment"},
};
static const orr_schema self_table = ORR_SCHEMA(self_rows, orr_study_self);

static const orr_key flexure_rows[] = {
    REAL_ROW(orr_study_flexure, "sigma", sigma_arcmin, 0, 600, "arcmin", "0", NULL,
             "standard deviation of the angle about each axis; 0: a stiff arm"),
    REAL_ROW(orr_study_flexure, "rate", rate_radps, 0.1, 200, "rad/s", "8", NULL,
             "b of its correlation (1 + b t) exp(-b t)"),
};
static const orr_schema flexure_table = ORR_SCHEMA(flexure_rows, orr_study_flexure);

static const orr_key transfer_rows[] = {
    {.name = "first_errors",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_transfer, first_errors),
     .help = "errors of the first unit's sensors"},
    INT_ROW(orr_study_transfer, "unit", unit, 1, 15, "1", NULL, "which unit of the scenario is aligned"),
    {.name = "interval",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_transfer, interval_ns),
     .unit = "s",
     .fallback = "1",
     .help = "from one measurement to the next; a multiple of five readings"},
    REAL_ROW(orr_study_transfer, "velocity_noise", velocity_noise_mps, 1e-6, 1000, "m/s", "0.02", NULL,
             "standard deviation of the velocity as it is handed over, each axis"),
    REAL_ROW(orr_study_transfer, "start_velocity", start_velocity_mps, 0, 1000, "m/s", "0.1", NULL,
             "standard deviation of the second unit's velocity at the start, each axis"),
    REALS_ROW(orr_study_transfer, "mounting", mounting_deg, "deg", NULL,
              "standard deviations of its attitude against the first's, about East, North, up; 0.3, 0.3 and "
              "1 without it"),
    REALS_ROW(orr_study_transfer, "first_attitude", first_attitude_arcsec, "arcsec", NULL,
              "standard deviations of the first unit's own attitude, about East, North, up; 0 without it"),
    MAP_ROW(orr_study_transfer, "flexure", flexure, &flexure_table, NULL,
            "bending of the body between the units"),
};

static const char *check_transfer(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_transfer *t = map;
    const orr_real_list *const list[] = {&t->mounting_deg, &t->first_attitude_arcsec};
    static const char *const name[] = {"mounting", "first_attitude"};
    for (size_t k = 0; k < 2; k++) {
        if (list[k]->n != 0 && list[k]->n != 3) {
            snprintf(why, ORR_SCHEMA_WHY, "%zu values; three are wanted: East, North, up", list[k]->n);
            return name[k];
        }
        for (size_t i = 0; i < list[k]->n; i++)
            if (list[k]->item[i] < 0.0) {
                snprintf(why, ORR_SCHEMA_WHY, "%g; a standard deviation cannot be negative",
                         list[k]->item[i]);
                return name[k];
            }
    }
    return NULL;
}
static const orr_schema transfer_table = {.key = transfer_rows,
                                          .n = sizeof transfer_rows / sizeof transfer_rows[0],
                                          .size = sizeof(orr_study_transfer),
                                          .check = check_transfer};

static const orr_key rows[] = {
    ORR_STUDY_HEAD(orr_study_alignment),
    CHOICE_ROW(orr_study_alignment, "kind", kind, kinds, "self", NULL, "of alignment"),
    {.name = "scenario",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_alignment, scenario),
     .help = "whose trajectory it is: of self-alignment at rest, or vibrating about a place"},
    {.name = "errors",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_alignment, errors),
     .help = "errors of the sensors of the unit that is aligned"},
    {.name = "duration",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_alignment, duration_ns),
     .only = of_transfer,
     .help = "instead of the scenario's"},
    INT_ROW(orr_study_alignment, "seeds", seeds, 1, 10000, "20", NULL,
            "alignments, each with its own errors"),
    MAP_ROW(orr_study_alignment, "self", self, &self_table, of_self, "self-alignment"),
    {.name = "transfer",
     .kind = ORR_KEY_MAP,
     .required = true,
     .offset = offsetof(orr_study_alignment, transfer),
     .map = &transfer_table,
     .only = of_transfer,
     .help = "transfer alignment"},
};
const orr_schema orr_study_alignment_schema = {.key = rows,
                                               .n = sizeof rows / sizeof rows[0],
                                               .size = sizeof(orr_study_alignment),
                                               .hint = "'orrery alignment --help-study' lists all"};

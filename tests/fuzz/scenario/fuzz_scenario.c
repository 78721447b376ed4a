// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario texts of anyone: the tree, the table, and what must hold of whatever is accepted.
#include <stdlib.h>
#include <string.h>

#include "src/config/scenario.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

// libfyaml 0.7.12 loses a block of 2 KiB for a quoted text with dozens of escaped quotes. Once a file at
// start, bounded by the file's size, and not ours to mend: our own leaks are still found.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) { return "leak:libfyaml.so"; }

static void want(bool yes)
{
    if (!yes) abort();
}

// What is accepted has an effect: every key goes with what it belongs to.
static void check_accepted(const orr_scenario *s)
{
    const orr_scenario_trajectory *t = &s->motion.trajectory;
    const orr_scenario_gravity *g = &s->motion.gravity;
    const bool orbits = s->orbit.product != NULL || s->orbit.sp3.n > 0, moves = t->kind != ORR_MOTION_NONE;
    want(orbits || moves);
    want(s->orbit.product == NULL ||
         (s->orbit.sp3.n + s->orbit.erp.n + s->orbit.exclude.n == 0 && s->orbit.nodes_s == 0));
    for (size_t i = 0; i < s->orbit.exclude.n; i++)
        want(s->orbit.exclude.item[i].to >= s->orbit.exclude.item[i].from);
    want(orbits || (s->navdata.antex == NULL && s->iono.field == NULL && s->receiver.position.n == 0));
    want(s->iono.field == NULL || s->iono.session == NULL);
    want(s->receiver.position.n == 0 || (s->receiver.position.n == 3 && s->receiver.unit == 0));
    want(s->receiver.unit <= (int64_t)s->motion.units.n);
    want(moves || (s->motion.units.n == 0 && g->model == NULL && g->file == NULL && g->masses.n == 0));
    want((t->kind == ORR_MOTION_WAYPOINTS) == (t->waypoints.n >= 2));
    want((t->kind == ORR_MOTION_PHASES) == (t->phases.n >= 1));
    want((t->kind == ORR_MOTION_TELEMETRY) == (t->logs.n >= 1));
    want(t->kind == ORR_MOTION_ANALYTIC || t->terms.n == 0);
    want((t->kind == ORR_MOTION_ORBIT) == (t->product != NULL || t->has_elements));
    want((t->product != NULL) == (t->sat != NULL));
    want(g->folder == NULL || g->model != NULL);
    want(g->profile.distance_m.n == g->profile.mgal.n);
    want(s->motion.imu.approach == ORR_IMU_MATCHED || s->motion.imu.frame == ORR_IMU_INERTIAL);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_scenario s;
    orr_diag diag = {0};
    orr_status status = orr_scenario_parse("fuzz.yaml", (const char *)data, n, "folder", NULL, &s, &diag);
    if (status == ORR_OK) {
        check_accepted(&s);
        orr_scenario_free(&s);
    } else if (diag.text[0] == '\0' || s.orbit.sp3.item != NULL || s.title != NULL) {
        abort(); // a refusal has its sentence, and holds nothing
    }
    return 0;
}

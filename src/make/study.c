// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/study.h"

#include <string.h>

orr_status orr_study_open(orr_inputs *inputs, const char *path, const orr_schema *schema, void *base,
                          orr_diag *diag)
{
    orr_bytes raw;
    memset(base, 0, schema->size);
    orr_status s = orr_inputs_read_raw(inputs, path, 0, &raw, diag);
    if (s == ORR_OK) s = orr_study_parse(schema, path, raw.text, raw.n, inputs->leap, base, diag);
    orr_bytes_free(&raw);
    return s;
}

orr_status orr_study_motion_open(orr_inputs *inputs, const char *path, int64_t duration_ns,
                                 orr_study_motion *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_status s = orr_inputs_scenario(inputs, path, inputs->leap, &out->scenario, diag);
    if (s != ORR_OK) return s;
    if (duration_ns > 0) out->scenario.motion.trajectory.duration_ns = duration_ns;
    s = orr_moving_open(&out->scenario.motion, orr_moving_fallback_start(), inputs->leap, NULL, &out->moving,
                        diag);
    if (s == ORR_OK) s = orr_inputs_join(inputs, &out->moving.inputs, diag);
    return s;
}

void orr_study_motion_free(orr_study_motion *m)
{
    orr_moving_free(&m->moving);
    orr_scenario_free(&m->scenario);
    memset(m, 0, sizeof *m);
}

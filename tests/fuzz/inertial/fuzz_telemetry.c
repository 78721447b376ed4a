// SPDX-License-Identifier: GPL-3.0-or-later
// Logs of flights by anyone. A first line "@..." declares the columns. What can be read is fitted, and the
// trajectory asked.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/telemetry_fit.h"
#include "ingest/telemetry/telemetry.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

static void fit(const orr_telemetry *t)
{
    orr_telemetry_log log = {.n_position = t->n_position,
                             .position_t_s = t->position_t_s,
                             .position = t->position,
                             .position_row = t->position_line,
                             .n_attitude = t->n_attitude,
                             .attitude_t_s = t->attitude_t_s,
                             .heading_rad = t->heading_rad,
                             .pitch_rad = t->pitch_rad,
                             .roll_rad = t->roll_rad,
                             .attitude_row = t->attitude_line};
    orr_trajectory tr;
    orr_fit_report r;
    orr_diag diag = {0};
    orr_fit_options o = orr_fit_options_default();
    if (t->rows % 2 == 1) o.degree = 5;
    if (orr_trajectory_from_telemetry(t->t0, &log, &o, &tr, &r, &diag) != ORR_OK) {
        if (diag.text[0] == '\0' || tr.self != NULL || r.excluded != NULL) abort();
        return;
    }
    if (r.positions_used + r.attitudes_used + r.n_excluded != t->n_position + t->n_attitude) abort();
    for (int k = 0; k <= 8; k++) {
        orr_motion m;
        tr.evaluate(tr.self, tr.begin_s + (tr.end_s - tr.begin_s) * k / 8, &m);
        if (!isfinite(orr_vec3_norm(m.r_m)) || !isfinite(orr_vec3_norm(m.v_mps)) ||
            !isfinite(orr_vec3_norm(m.w_radps)))
            abort();
    }
    orr_trajectory_free(&tr);
    orr_fit_report_free(&r);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    char columns[200];
    const char *declared = NULL;
    if (n > 0 && data[0] == '@') {
        const uint8_t *end = memchr(data, '\n', n);
        size_t len = end != NULL ? (size_t)(end - data) - 1 : n - 1;
        if (len >= sizeof columns) return 0;
        memcpy(columns, data + 1, len);
        columns[len] = '\0';
        declared = columns;
        size_t skip = end != NULL ? len + 2 : n;
        data += skip;
        n -= skip;
    }
    orr_telemetry t;
    orr_warnings w = {0};
    orr_diag diag = {0};
    orr_status s = orr_telemetry_read_bytes("fuzz", data, n, declared, NULL, &t, &w, &diag);
    if (s == ORR_OK) {
        if (t.n_position + t.n_attitude == 0) abort();
        for (size_t k = 0; k < t.n_position; k++)
            if (!isfinite(t.position_t_s[k]) || !(fabs(t.position[k].lat_rad) < 1.5708) ||
                !isfinite(t.position[k].height_m))
                abort();
        fit(&t);
        orr_telemetry_free(&t);
    } else if (diag.text[0] == '\0' || t.position != NULL) {
        abort(); // a refusal says why and holds nothing
    }
    orr_warnings_free(&w);
    return 0;
}

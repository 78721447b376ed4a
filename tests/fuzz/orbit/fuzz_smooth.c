// SPDX-License-Identifier: GPL-3.0-or-later
// SP3 bytes all the way that `orrery orbit --nodes` takes them: read, nodes collected, smoothed, made into a
// continuous orbit. The first byte chooses the options; the rest is a file of few satellites and epochs.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/smoother.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

static orr_smoother_options options_of(uint8_t choice)
{
    static const double steps_s[] = {0, 900, 1800, 0.1};
    orr_smoother_options o = orr_smoother_defaults();
    o.node_step_s = steps_s[choice % 4];
    o.gravity_degree = 2; // what the force is made of is not what is looked at
    o.passes = (choice & 4) != 0 ? 2 : 1;
    o.detect = (choice & 8) == 0;
    o.jobs = 1;
    if ((choice & 16) != 0) {
        o = orr_smoother_literal();
        o.node_step_s = steps_s[choice % 4];
        o.jobs = 1;
    }
    return o;
}

static void check(const orr_orbit_solution *s)
{
    for (size_t i = 0; i < s->n_sats; i++)
        for (size_t a = 0; a < s->sat[i].n_arcs; a++) {
            const orr_orbit_arc *arc = &s->sat[i].arc[a];
            if (arc->n == 0 || !(arc->step_s > 0)) abort();
            for (size_t k = 0; k < arc->n; k++)
                if (!isfinite(arc->sample[k].pos_m.x) || !isfinite(arc->sample[k].vel_mps.x)) abort();
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1) return 0;
    const orr_sp3_limits limits = {1 << 16, 3, 50, 100, NULL};
    const orr_smoother_options o = options_of(data[0]);
    orr_sp3 sp3;
    orr_diag diag = {0};
    if (orr_sp3_parse("fuzz", (const char *)data + 1, n - 1, &limits, &sp3, NULL, &diag) != ORR_OK) return 0;
    // Of years that a product may hold the Earth's rotation is tabled first, which takes too long for many
    // inputs; beyond them it is refused.
    double days = orr_time_diff_s(sp3.epoch[sp3.n_epochs - 1], sp3.epoch[0]) / ORR_S_PER_DAY;
    if (days > 2 && days < 3700) {
        orr_sp3_free(&sp3);
        return 0;
    }
    const orr_smoother_input input = {.sp3 = &sp3, .name = "fuzz"};
    orr_orbit_solution solution;
    orr_smoother_report report;
    orr_warnings warnings = {0};
    orr_status status = orr_smoother_run(&input, 1, &o, NULL, NULL, &solution, &report, &warnings, &diag);
    if (status == ORR_OK) {
        check(&solution);
        orr_ephemeris *e;
        if (orr_ephemeris_build(&solution, &e, &diag) == ORR_OK)
            orr_ephemeris_free(e);
        else if (diag.text[0] == '\0')
            abort();
        orr_orbit_solution_free(&solution);
    } else if (diag.text[0] == '\0')
        abort();
    orr_warnings_free(&warnings);
    orr_sp3_free(&sp3);
    return 0;
}

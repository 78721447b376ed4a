// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/orbit/smoother_made.h"

#include "testing.h"

made_sky sky;
made_truth gps, eccentric, glonass, pushed;
const made_truth *const all[3] = {&gps, &eccentric, &glonass};

int make_truth(void **state)
{
    (void)state;
    made_sky_init(&sky, "2024-03-10", 2); // eclipse season of some planes
    made_orbit(&sky, orr_sat_make('G', 7), 2.656e7, 0.01, 0.96, 0.3, 1.0, 2e-8, -1, 0, &gps);
    made_orbit(&sky, orr_sat_make('E', 18), 2.798e7, 0.16, 0.87, 2.0, 4.0, 2e-8, -1, 0, &eccentric);
    made_orbit(&sky, orr_sat_make('R', 3), 2.551e7, 0.001, 1.13, 4.0, 2.0, 3e-8, -1, 0, &glonass);
    made_orbit(&sky, orr_sat_make('G', 11), 2.656e7, 0.005, 0.95, 5.0, 3.0, 2e-8, PUSH_S, 0.10, &pushed);
    return 0;
}

int drop_truth(void **state)
{
    (void)state;
    made_sky_free(&sky);
    return 0;
}

orr_status run(const orr_sp3 *files, size_t n, const orr_smoother_options *o, orr_orbit_solution *s,
               orr_smoother_report *report, orr_warnings *w, orr_diag *d)
{
    orr_smoother_input in[4] = {{0}};
    for (size_t i = 0; i < n; i++) {
        in[i].sp3 = &files[i];
        snprintf(in[i].name, sizeof in[i].name, "made%zu.sp3", i);
    }
    return orr_smoother_run(in, n, o, NULL, NULL, s, report, w, d);
}

size_t count_events(const orr_orbit_solution *s, orr_sat sat, orr_event_kind kind,
                    const orr_orbit_event **last)
{
    const orr_orbit_sat *q = made_find(s, sat);
    size_t n = 0;
    for (size_t i = 0; q != NULL && i < q->n_events; i++)
        if (q->event[i].kind == kind) {
            n++;
            if (last != NULL) *last = &q->event[i];
        }
    return n;
}

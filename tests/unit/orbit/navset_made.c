// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/orbit/navset_made.h"

#include "core/nan.h"
#include "orbit/smooth/smoother.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/orbit/made_sp3.h"

const spoil nothing = {.push_s = -1};

orr_time when(const char *text)
{
    orr_time t;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &d), d);
    return t;
}
orr_ephemeris *product(const char *from, double hours, spoil x)
{
    static made_truth truth[N_SATS];
    const made_truth *all[N_SATS];
    made_sky sky;
    made_sky_init(&sky, from, hours / 24);
    for (int k = 0; k < N_SATS; k++) {
        const bool gps = k < N_GPS, glonass = !gps && k < N_GPS + N_GLONASS;
        const int number = gps ? k + 1 : glonass ? k - N_GPS + 1 : 14;
        const orr_sat sat = orr_sat_make(gps ? 'G' : glonass ? 'R' : 'E', number);
        made_orbit(&sky, sat,
                   gps       ? 2.656e7
                   : glonass ? 2.551e7
                             : 2.96e7,
                   gps ? 0.01 : 0.001, glonass ? 1.13 : 0.96, 0.9 * k, 0.4 + 1.7 * k, 2e-8,
                   k == 0 ? x.push_s : -1, 0.5, &truth[k]);
        all[k] = &truth[k];
    }
    const size_t end = (size_t)(hours * 12), joint = x.apart_m > 0 ? end / 6 * 3 : end + 3;
    orr_sp3 f, g = {0};
    made_sp3(&sky, all, N_SATS, 0, joint - 3, 3, &f);
    if (x.apart_m > 0) made_sp3(&sky, all, N_SATS, joint, end, 3, &g);
    for (size_t i = 0; i < g.n_epochs; i++) {
        made_record(&g, orr_sat_parse("G02"), g.epoch[i])->pos_m[0] += x.apart_m;
        made_record(&g, orr_sat_parse("R02"), g.epoch[i])->pos_m[0] += x.apart_m;
    }
    for (size_t i = 0; x.no_clock && i <= end; i += 3)
        made_record(&f, orr_sat_parse("G01"), orr_time_add_s(sky.t0, 300.0 * (double)i))->clock_s =
            (double)NAN;
    for (size_t i = 0; i < joint && i <= end; i += 3) {
        const orr_time t = orr_time_add_s(sky.t0, 300.0 * (double)i);
        if (300.0 * (double)i >= x.reset_s) {
            made_record(&f, orr_sat_parse("G01"), t)->clock_s += x.fast_s;
            made_record(&f, orr_sat_parse("R01"), t)->clock_s += x.fast_s;
        }
        for (int k = 0; x.after_s > 0 && k < 3; k++) {
            if (300.0 * (double)i < x.after_s) made_record(&f, orr_sat_parse("G02"), t)->pos_m[k] = ORR_NAN;
            if (300.0 * (double)i > x.after_s) made_record(&f, orr_sat_parse("G03"), t)->pos_m[k] = ORR_NAN;
        }
    }
    const orr_smoother_input in[2] = {{.sp3 = &f, .name = "made.sp3"}, {.sp3 = &g, .name = "later.sp3"}};
    const orr_smoother_options o = orr_smoother_defaults();
    orr_orbit_solution s;
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(in, x.apart_m > 0 ? 2 : 1, &o, NULL, NULL, &s, NULL, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    if (x.apart_m > 0) made_sp3_free(&g);
    made_sky_free(&sky);
    return e;
}

orr_navset *build(const orr_ephemeris *e, const orr_navset_options *o)
{
    orr_navset *set = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_navset_build(e, o, &set, NULL, &d), d);
    return set;
}

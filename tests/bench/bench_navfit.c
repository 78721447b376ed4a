// SPDX-License-Identifier: GPL-3.0-or-later
// Broadcast parameters fitted to a product: one window of an LNAV and of a GLONASS satellite, beside what any
// such fit needs at least: the positions of the product, and the model evaluated at them twice, once to
// improve the parameters and once to judge the rounded ones.
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "ingest/sp3/sp3.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/navdata/navfit.h"
#include "orbit/smooth/smoother.h"

enum { WINDOWS = 16 };

typedef struct job {
    orr_navfit_product product;
    char system;
    double window_s;
    orr_sat sat[WINDOWS];
    orr_time t[WINDOWS];
    orr_nav_eph eph[WINDOWS];
} job;

static void fits(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t i = 0; i < WINDOWS; i++) {
        orr_navfit_report r;
        orr_diag d = {0};
        orr_time from = orr_time_add_s(j->t[i], -j->window_s / 2), to = orr_time_add_s(from, j->window_s);
        j->product.sat = j->sat[i];
        orr_status s = j->system == 'G'
                           ? orr_navfit_kepler(j->sat[i], ORR_NAV_LNAV, j->t[i], from, to,
                                               orr_navfit_from_product, &j->product, &j->eph[i], &r, &d)
                           : orr_navfit_glonass(j->sat[i], j->t[i], from, to, orr_navfit_from_product,
                                                &j->product, &j->eph[i], &r, &d);
        if (s != ORR_OK) {
            fprintf(stderr, "bench: %s\n", d.text);
            abort();
        }
        sum += r.rms_m;
    }
    bench_use(sum);
}

static void evaluations(void *arg)
{
    job *j = arg;
    double sum = 0;
    const int intervals = j->window_s > 7200 ? (int)(j->window_s / 300) : 24;
    for (size_t i = 0; i < WINDOWS; i++) {
        j->product.sat = j->sat[i];
        for (int k = 0; k <= intervals; k++) {
            orr_vec3 pos;
            orr_broadcast_state s;
            orr_time t = orr_time_add_s(j->t[i], j->window_s * ((double)k / intervals - 0.5));
            if (orr_navfit_from_product(&j->product, t, &pos) == ORR_OK) sum += pos.x;
            for (int twice = 0; twice < 2; twice++)
                if (orr_broadcast_eval(&j->eph[i], t, &s) == ORR_OK) sum += s.pos_m.x;
        }
    }
    bench_use(sum);
}

void bench_navfit(bench *b)
{
    char path[512];
    orr_sp3 sp3 = {0};
    orr_diag d = {0};
    orr_orbit_solution solution;
    orr_ephemeris *e = NULL;
    orr_smoother_options options = orr_smoother_defaults();
    snprintf(path, sizeof path, "%s/samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz", ORR_SOURCE_DIR);
    orr_status s = orr_sp3_read(path, NULL, &sp3, NULL, &d);
    orr_smoother_input input = {.sp3 = &sp3, .name = "bench"};
    if (s == ORR_OK) s = orr_smoother_run(&input, 1, &options, NULL, NULL, &solution, NULL, NULL, &d);
    if (s == ORR_OK) s = orr_ephemeris_build(&solution, &e, &d);
    if (s != ORR_OK) {
        fprintf(stderr, "bench: %s\n", d.text);
        abort();
    }
    const struct {
        const char *name;
        char system;
        double window_s, offset_m;
    } row[] = {{"LNAV, 2 h", 'G', 7200, 0},
               {"LNAV, 4 h", 'G', 14400, 0},
               {"GLONASS, 30 min", 'R', 1800, 0},
               {"LNAV, 2 h, of the antenna", 'G', 7200, 1.0}};
    bench_group(b, "Broadcast parameters, one fit");
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        job j = {.product = {.ephemeris = e, .offset_m = {0, 0, row[k].offset_m}},
                 .system = row[k].system,
                 .window_s = row[k].window_s};
        size_t first = 0, of_system = 0;
        for (size_t i = 0; i < n; i++)
            if (orr_sat_system(list[i]) == row[k].system && of_system++ == 0) first = i;
        for (size_t i = 0; i < WINDOWS; i++) {
            j.sat[i] = list[first + i % of_system];
            j.t[i] = orr_time_add_s(from, 7200.0 + 3600.0 * (double)i);
        }
        double ours = 1e6 * bench_seconds(b, fits, &j) / WINDOWS,
               limit = 1e6 * bench_seconds(b, evaluations, &j) / WINDOWS;
        bench_row(b, row[k].name, ours, limit, "us", "the evaluations alone");
    }
    orr_ephemeris_free(e);
    orr_orbit_solution_free(&solution);
    orr_sp3_free(&sp3);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// SP3 to product by stages on one core, and the evaluation of the product beside bare polynomials of the same
// degree.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/bench.h"
#include "core/rng.h"
#include "ingest/sp3/sp3.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/smoother.h"

enum { QUESTIONS = 4096, MAX_SATS = 128 };

typedef struct job {
    const char *path;
    orr_sp3 sp3;
    orr_smoother_options options;
    orr_orbit_solution solution;
    orr_ephemeris *ephemeris;
    char product[64];
    // evaluation
    orr_sat sat[QUESTIONS];
    orr_time t[QUESTIONS];
    // bare polynomials: as many segments as the product has, and which one each question is of
    size_t n_segments;
    int degree;
    double *coef; // [segment][degree + 1][3]
    size_t segment[QUESTIONS];
    double x[QUESTIONS];
} job;

static void must(orr_status s, const orr_diag *diag)
{
    if (s == ORR_OK) return;
    fprintf(stderr, "bench: %s\n", diag->text);
    abort();
}

static void do_read(void *arg)
{
    job *j = arg;
    orr_diag diag = {0};
    orr_sp3_free(&j->sp3);
    must(orr_sp3_read(j->path, NULL, &j->sp3, NULL, &diag), &diag);
}

static void do_smooth(void *arg)
{
    job *j = arg;
    orr_diag diag = {0};
    orr_smoother_report report;
    orr_smoother_input input = {.sp3 = &j->sp3, .name = "bench"};
    orr_orbit_solution_free(&j->solution);
    must(orr_smoother_run(&input, 1, &j->options, NULL, NULL, &j->solution, &report, NULL, &diag), &diag);
}

static void do_fit(void *arg)
{
    job *j = arg;
    orr_diag diag = {0};
    orr_ephemeris_free(j->ephemeris);
    must(orr_ephemeris_build(&j->solution, &j->ephemeris, &diag), &diag);
}

static void do_save(void *arg)
{
    job *j = arg;
    orr_diag diag = {0};
    must(orr_ephemeris_save(j->ephemeris, j->product, "bench", &diag), &diag);
}

static void do_load(void *arg)
{
    job *j = arg;
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    must(orr_ephemeris_load(j->product, &e, &diag), &diag);
    orr_ephemeris_free(e);
}

static void eval_one(void *arg)
{
    const job *j = arg;
    double sum = 0;
    for (size_t i = 0; i < QUESTIONS; i++) {
        orr_sat_state s;
        if (orr_ephemeris_eval(j->ephemeris, j->sat[i], j->t[i], &s) != ORR_OK) continue;
        sum += s.pos_m.x + s.vel_mps.y + s.acc_mps2.z + s.clock_s;
    }
    bench_use(sum);
}

static void eval_all(void *arg)
{
    const job *j = arg;
    double sum = 0;
    orr_sat_state s[MAX_SATS];
    for (size_t i = 0; i < QUESTIONS / 64; i++) {
        size_t n = orr_ephemeris_eval_all(j->ephemeris, j->t[i], s, MAX_SATS);
        for (size_t k = 0; k < n; k++) sum += s[k].pos_m.x + s[k].vel_mps.y + s[k].acc_mps2.z;
    }
    bench_use(sum);
}

// Horner's scheme for a position, its velocity and its acceleration, nothing else.
static double bare(const double *c, int degree, double x)
{
    double p[3] = {0}, v[3] = {0}, a[3] = {0};
    for (int n = degree; n >= 0; n--) {
        for (int k = 0; k < 3; k++) {
            a[k] = a[k] * x + v[k];
            v[k] = v[k] * x + p[k];
            p[k] = p[k] * x + c[3 * n + k];
        }
    }
    return p[0] + p[1] + p[2] + v[0] + v[1] + v[2] + 2 * (a[0] + a[1] + a[2]);
}

static void bare_one(void *arg)
{
    const job *j = arg;
    double sum = 0;
    for (size_t i = 0; i < QUESTIONS; i++)
        sum += bare(&j->coef[j->segment[i] * (size_t)(3 * (j->degree + 1))], j->degree, j->x[i]);
    bench_use(sum);
}

static void bare_all(void *arg)
{
    const job *j = arg;
    double sum = 0;
    size_t n_sats = j->solution.n_sats, per_sat = j->n_segments / n_sats;
    for (size_t i = 0; i < QUESTIONS / 64; i++)
        for (size_t k = 0; k < n_sats; k++)
            sum += bare(&j->coef[(k * per_sat + j->segment[i] % per_sat) * (size_t)(3 * (j->degree + 1))],
                        j->degree, j->x[i]);
    bench_use(sum);
}

static void make_questions(job *j)
{
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(j->ephemeris, &list);
    orr_time from, to;
    orr_ephemeris_span(j->ephemeris, &from, &to);
    j->degree = 10;
    j->n_segments = n * 96;
    j->coef = malloc(j->n_segments * (size_t)(3 * (j->degree + 1)) * sizeof *j->coef);
    if (j->coef == NULL) abort();
    for (size_t i = 0; i < j->n_segments * (size_t)(3 * (j->degree + 1)); i++)
        j->coef[i] = 1.0 / (double)(1 + i % 97);
    for (size_t i = 0; i < QUESTIONS; i++) {
        j->sat[i] = list[(size_t)((double)n * orr_rng_uniform(1, 1, i))];
        j->t[i] = from + (orr_time)((double)(to - from) * orr_rng_uniform(1, 2, i));
        j->segment[i] = (size_t)((double)j->n_segments * orr_rng_uniform(1, 3, i));
        j->x[i] = 2 * orr_rng_uniform(1, 4, i) - 1;
    }
}

static void stages(bench *b, job *j)
{
    static const struct {
        const char *name;
        void (*work)(void *);
    } stage[] = {
        {"read SP3", do_read}, {"smooth", do_smooth}, {"fit segments", do_fit}, {"write product", do_save}};
    double sum = 0;
    for (size_t i = 0; i < sizeof stage / sizeof stage[0]; i++) {
        double s = bench_seconds(b, stage[i].work, j);
        bench_row(b, stage[i].name, 1e3 * s, 0, "ms", "");
        sum += s;
    }
    bench_row(b, "SP3 to product", 1e3 * sum, 0, "ms", "");
    bench_row(b, "load product", 1e3 * bench_seconds(b, do_load, j), 0, "ms", "");
}

void bench_orbit(bench *b)
{
    static job j; // too large for a stack
    char path[512];
    snprintf(path, sizeof path, "%s/samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz", ORR_SOURCE_DIR);
    j = (job){.path = path, .options = orr_smoother_defaults(), .product = "/tmp/orr-bench-XXXXXX"};
    int fd = mkstemp(j.product);
    if (fd < 0) abort();
    close(fd);
    bench_group(b, "A day of 80 satellites, nodes every 15 min, one core");
    stages(b, &j);

    make_questions(&j);
    size_t n = j.solution.n_sats;
    double one = 1e9 * bench_seconds(b, eval_one, &j) / QUESTIONS,
           bare1 = 1e9 * bench_seconds(b, bare_one, &j) / QUESTIONS;
    double all = 1e9 * bench_seconds(b, eval_all, &j) / (double)(QUESTIONS / 64 * n);
    double bare_n = 1e9 * bench_seconds(b, bare_all, &j) / (double)(QUESTIONS / 64 * n);
    bench_group(b, "Evaluation: position, velocity, acceleration, clock, flags, sigma");
    bench_row(b, "one satellite, random time", one, bare1, "ns", "bare polynomials, no lookup, no clock");
    bench_row(b, "whole constellation, a satellite", all, bare_n, "ns", "bare polynomials");
    bench_note(b, "the bare polynomials are of degree %d, three with two derivatives, by Horner", j.degree);
    unlink(j.product);
    free(j.coef);
    orr_sp3_free(&j.sp3);
    orr_orbit_solution_free(&j.solution);
    orr_ephemeris_free(j.ephemeris);
}

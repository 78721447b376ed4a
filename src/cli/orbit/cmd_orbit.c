// SPDX-License-Identifier: GPL-3.0-or-later
// orrery orbit: SP3 files in, an orbit product out.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/parallel.h"
#include "core/sha256.h"
#include "ingest/tables/erp.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/smooth/smoother.h"
#include "src/cli/frame/cli.h"
#include "src/cli/orbit/nav_files.h"
#include "src/cli/orbit/orbit_summary.h"

static const orr_option options[] = {
    {.name = "output",
     .letter = 'o',
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .required = true,
     .help = "the product, a NetCDF-4 file; it appears whole or not at all"},
    {.name = "nodes",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "use only epochs that are multiples of S from midnight of the first file, by the files' own "
             "clock; all by "
             "default"},
    {.name = "exclude",
     .kind = ORR_OPT_INTERVAL,
     .value = "FROM/TO",
     .repeated = true,
     .help = "do not use nodes from FROM on and before TO; where the two are the same, that instant's"},
    {.name = "sat",
     .kind = ORR_OPT_SATS,
     .value = "LIST",
     .help = "satellites, e.g. G05,R,E01-E09; all by default"},
    {.name = "erp",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .help = "Earth rotation parameters; without them IERS' secular pole, and UT1 by the leap seconds"},
    {.name = "nav",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .help = "RINEX navigation file: the a-priori orbit comes from broadcast ephemerides (variant A)"},
    {.name = "bridge",
     .kind = ORR_OPT_FLAG,
     .help = "with --nav: bridge hours without nodes at broadcast quality, flagged as predicted"},
    {.name = "extend-to",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "with --bridge: go on beyond the last node up to T, as long as there are broadcast ephemerides; "
             "--erp "
             "makes the first hours ten times better"},
    {.name = "max-gap",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "longest stretch without nodes that is bridged; 8 h by default"},
    {.name = "jobs",
     .letter = 'j',
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 256,
     .help = "threads; the machine's cores by default. The product does not depend on it"},
    {.name = "json", .kind = ORR_OPT_FLAG, .help = "print the summary as a JSON object on stdout"},
    {.name = "method",
     .kind = ORR_OPT_CHOICE,
     .value = "default|literal",
     .help = "literal: the smoother as the dissertation has it (two-body prior in uniformly turning axes, "
             "constant f0); the options below change one setting of the chosen method"},
    {.name = "frame",
     .kind = ORR_OPT_CHOICE,
     .value = "gcrs|uniform",
     .help = "axes that the orbit is integrated in"},
    {.name = "gravity",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 0,
     .max = 12,
     .help = "degree of the gravity field, 0 is the central term alone"},
    {.name = "sun-moon", .kind = ORR_OPT_CHOICE, .value = "yes|no", .help = "attraction of Sun and Moon"},
    {.name = "srp",
     .kind = ORR_OPT_REAL,
     .value = "A",
     .min = -1e-6,
     .max = 1e-6,
     .help = "radiation pressure at 1 au, m/s2"},
    {.name = "f0",
     .kind = ORR_OPT_CHOICE,
     .value = "rtn|inertial|ecef",
     .help = "axes of the empirical acceleration"},
    {.name = "qf",
     .kind = ORR_OPT_REAL,
     .value = "Q",
     .min = 0,
     .max = 1,
     .help = "its random walk, m2/s5; 0 keeps it constant"},
    {.name = "qv",
     .kind = ORR_OPT_REAL,
     .value = "Q",
     .min = 0,
     .max = 1,
     .help = "white noise of acceleration, m2/s3"},
    {.name = "sigma",
     .kind = ORR_OPT_REAL,
     .value = "M",
     .min = 1e-6,
     .max = 1e4,
     .help = "standard deviation of a node's coordinate, m"},
    {.name = "passes",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 0,
     .max = 8,
     .help = "linearisations, 0 until converged"},
    {.name = "detect",
     .kind = ORR_OPT_CHOICE,
     .value = "yes|no",
     .help = "find outliers and manoeuvres by innovation (flags of the input are always heeded)"},
};

// What a run holds, so that one place frees it.
typedef struct work {
    size_t n;
    orr_sp3 *sp3;
    orr_smoother_input *input;
    orr_erp *erp;
    size_t n_erp;
    orr_eop_series eop;
    orr_nav nav;            // of all files
    orr_orbit_source *also; // provenance of the two kinds above
    size_t n_also;
    orr_interval *exclude;
    orr_orbit_solution solution;
    orr_smoother_report report;
    orr_ephemeris *ephemeris;
    orbit_seconds seconds;
} work;

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void work_free(work *w)
{
    for (size_t i = 0; i < w->n && w->sp3 != NULL; i++) orr_sp3_free(&w->sp3[i]);
    for (size_t i = 0; i < w->n_erp && w->erp != NULL; i++) orr_erp_free(&w->erp[i]);
    free(w->sp3);
    free(w->input);
    free(w->erp);
    orr_nav_free(&w->nav);
    free(w->also);
    free(w->exclude);
    orr_erp_series_free(&w->eop);
    orr_orbit_solution_free(&w->solution);
    orr_ephemeris_free(w->ephemeris);
}

static orr_status read_inputs(const orr_cli *c, work *w, orr_warnings *warnings, orr_diag *diag)
{
    w->n = (size_t)c->n_operands;
    w->sp3 = calloc(w->n, sizeof *w->sp3);
    w->input = calloc(w->n, sizeof *w->input);
    if (w->sp3 == NULL || w->input == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", w->n);
    orr_status s = ORR_OK;
    for (size_t i = 0; i < w->n && s == ORR_OK; i++) {
        const char *path = c->operand[i], *slash = strrchr(path, '/');
        orr_cli_progress(c, "reading", i, w->n);
        snprintf(w->input[i].name, sizeof w->input[i].name, "%s", slash != NULL ? slash + 1 : path);
        s = orr_sp3_read(path, NULL, &w->sp3[i], warnings, diag);
        if (s == ORR_OK) s = orr_sha256_file(path, w->input[i].sha256, diag);
        w->input[i].sp3 = &w->sp3[i];
    }
    orr_cli_progress(c, "reading", w->n, w->n);
    return s;
}

static orr_status note_source(work *w, const char *path, orr_diag *diag)
{
    const char *slash = strrchr(path, '/');
    orr_orbit_source *s = &w->also[w->n_also++];
    snprintf(s->name, sizeof s->name, "%s", slash != NULL ? slash + 1 : path);
    return orr_sha256_file(path, s->sha256, diag);
}

// Earth rotation and navigation files: what the options are made of.
static orr_status read_others(const orr_cli *c, work *w, orr_warnings *warnings, orr_diag *diag)
{
    size_t n_erp = orr_cli_count(c, "erp"), n_nav = orr_cli_count(c, "nav");
    w->erp = calloc(n_erp + 1, sizeof *w->erp);
    w->also = calloc(n_erp + n_nav + 1, sizeof *w->also);
    if (w->erp == NULL || w->also == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", n_erp + n_nav);
    orr_status s = ORR_OK;
    for (; w->n_erp < n_erp && s == ORR_OK; w->n_erp++) {
        const char *path = orr_cli_text_at(c, "erp", w->n_erp);
        s = orr_erp_read(path, NULL, NULL, &w->erp[w->n_erp], warnings, diag);
        if (s == ORR_OK) s = note_source(w, path, diag);
    }
    if (s == ORR_OK && n_nav > 0) s = orr_cli_read_navs(c, "nav", &w->nav, warnings, diag);
    for (size_t i = 0; i < n_nav && s == ORR_OK; i++) s = note_source(w, orr_cli_text_at(c, "nav", i), diag);
    if (s == ORR_OK && n_erp > 0) s = orr_erp_merge(w->erp, n_erp, &w->eop, diag);
    return s;
}

static bool says(const orr_cli *c, const char *option, const char *word, bool otherwise)
{
    const char *text = orr_cli_text(c, option, NULL);
    return text != NULL ? strcmp(text, word) == 0 : otherwise;
}

static orr_status make_options(const orr_cli *c, work *w, orr_smoother_options *o, orr_diag *diag)
{
    *o = says(c, "method", "literal", false) ? orr_smoother_literal() : orr_smoother_defaults();
    if (orr_cli_given(c, "frame")) o->frame = says(c, "frame", "gcrs", true) ? ORR_SKY_GCRS : ORR_SKY_UNIFORM;
    o->gravity_degree = (int)orr_cli_int(c, "gravity", o->gravity_degree);
    o->sun_moon = says(c, "sun-moon", "yes", o->sun_moon);
    o->srp_mps2 = orr_cli_real(c, "srp", o->srp_mps2);
    if (orr_cli_given(c, "f0"))
        o->f0_axes = says(c, "f0", "rtn", true)    ? ORR_F0_RTN
                     : says(c, "f0", "ecef", true) ? ORR_F0_ECEF
                                                   : ORR_F0_INERTIAL;
    o->qf_m2ps5 = orr_cli_real(c, "qf", o->qf_m2ps5);
    o->qv_m2ps3 = orr_cli_real(c, "qv", o->qv_m2ps3);
    o->sigma_m = orr_cli_real(c, "sigma", o->sigma_m);
    o->passes = (int)orr_cli_int(c, "passes", o->passes);
    o->detect = says(c, "detect", "yes", o->detect);
    o->node_step_s = (double)orr_cli_duration_ns(c, "nodes", 0) * 1e-9;
    o->max_gap_s = (double)orr_cli_duration_ns(c, "max-gap", (int64_t)(o->max_gap_s * 1e9)) * 1e-9;
    o->sats = orr_cli_sats(c, "sat");
    o->eop = w->eop.n > 0 ? &w->eop : NULL;
    o->nav = orr_cli_given(c, "nav") ? &w->nav : NULL;
    o->bridge = orr_cli_given(c, "bridge");
    o->extend_to = orr_cli_time(c, "extend-to", ORR_TIME_NONE);
    if (orr_cli_given(c, "extend-to") && !o->bridge)
        return orr_diag_set(diag, ORR_E_ARG, "--extend-to goes with --bridge");
    o->also = w->also;
    o->n_also = w->n_also;
    o->jobs = (int)orr_cli_int(c, "jobs", orr_parallel_cores());
    o->n_exclude = orr_cli_count(c, "exclude");
    w->exclude = calloc(o->n_exclude + 1, sizeof *w->exclude);
    if (w->exclude == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for intervals");
    for (size_t i = 0; i < o->n_exclude; i++) {
        orr_interval *x = &w->exclude[i];
        orr_cli_interval_at(c, "exclude", i, &x->from, &x->to);
        if (x->to == x->from) x->to++; // an interval holds its begin and not its end
    }
    o->exclude = w->exclude;
    return ORR_OK;
}

static orr_status smooth_and_write(orr_cli *c, work *w, const orr_smoother_options *o, orr_warnings *warnings,
                                   orr_diag *diag)
{
    const char *path = orr_cli_text(c, "output", NULL);
    double t0 = now_s();
    orr_status s =
        orr_smoother_run(w->input, w->n, o, c->log, NULL, &w->solution, &w->report, warnings, diag);
    double t1 = now_s();
    if (s == ORR_OK) s = orr_ephemeris_build(&w->solution, &w->ephemeris, diag);
    double t2 = now_s();
    if (s == ORR_OK) {
        s = orr_ephemeris_save(w->ephemeris, path, c->call, diag);
    }
    w->seconds.smooth = t1 - t0;
    w->seconds.fit = t2 - t1;
    w->seconds.write = now_s() - t2;
    return s;
}

static int run(orr_cli *c)
{
    work w = {0};
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_smoother_options o;
    double t0 = now_s();
    orr_status s = read_inputs(c, &w, &warnings, &diag);
    if (s == ORR_OK) s = read_others(c, &w, &warnings, &diag);
    w.seconds.read = now_s() - t0;
    if (s == ORR_OK) s = make_options(c, &w, &o, &diag);
    if (s == ORR_OK) s = smooth_and_write(c, &w, &o, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    int status = s == ORR_OK ? orbit_summary_print(c, &w.solution, &w.report, w.ephemeris, &w.seconds)
                             : orr_cli_fail(c, &diag);
    orr_warnings_free(&warnings);
    work_free(&w);
    return status;
}

const orr_command orr_cmd_orbit = {
    .name = "orbit",
    .group = "Orbits",
    .summary = "smooth SP3 files into an orbit product",
    .operands = "SP3...",
    .min_operands = 1,
    .max_operands = -1,
    .about =
        "Files of consecutive days are smoothed jointly, in whatever order they are named. The product holds "
        "Chebyshev "
        "segments of position, clock nodes, standard deviations, flags, events and the names and SHA-256 of "
        "its inputs; "
        "'ncdump -h' shows how to evaluate it, 'orrery states' prints from it, 'orrery compare' judges "
        "it.\n\n"
        "What was done is told on stderr: manoeuvres, positions left out and gaps one by one, as many as a "
        "reader will read. "
        "JSON has all of them: events[].{sat,kind,from,to} with kind manoeuvre (change_mps), outlier, jump "
        "(size_m) or gap; "
        "systems.G.{satellites,nodes,left_out,residual_rms_mm,manoeuvres,gaps,eclipses}, day_jumps, seconds.",
    .example = "orrery orbit -o day.nc COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz\n"
               "orrery orbit -o three-days.nc --nodes 900 --exclude 2024-02-04T12:00/2024-02-04T13:00 "
               "day1.sp3 day2.sp3 day3.sp3",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

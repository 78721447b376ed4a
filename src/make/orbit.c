// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/orbit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/monotonic.h"
#include "core/parallel.h"
#include "ingest/rinex/clk.h"
#include "ingest/tables/erp.h"
#include "orbit/ephemeris/ephemeris_parts.h"
#include "src/make/frames.h"
#include "src/make/inputs.h"

orr_orbit_plan orr_orbit_plan_default(void)
{
    orr_orbit_plan p = {.predict_after = ORR_TIME_NONE, .smoother = orr_smoother_defaults()};
    p.smoother.jobs = orr_parallel_cores();
    return p;
}

orr_orbit_plan orr_orbit_plan_of(const orr_scenario *s)
{
    const orr_scenario_orbit *section = &s->orbit;
    orr_orbit_plan p = orr_orbit_plan_default();
    p.sp3 = (const char *const *)section->sp3.item;
    p.n_sp3 = section->sp3.n;
    p.leap = s->leap;
    p.erp = (const char *const *)section->erp.item;
    p.n_erp = section->erp.n;
    p.clk = (const char *const *)section->clk.item;
    p.n_clk = section->clk.n;
    p.smoother.node_step_s = section->nodes_s;
    p.smoother.exclude = section->exclude.item;
    p.smoother.n_exclude = section->exclude.n;
    return p;
}

// What was read, as long as it is needed.
typedef struct work {
    orr_sp3 *sp3;
    orr_smoother_input *input;
    size_t n_sp3;
    orr_nav nav;
    orr_clk *clk;
    orr_smoother_clk *clk_input;
    size_t n_clk;
    orr_gravity_model *gravity;
    orr_inputs inputs, also; // provenance: of the SP3 files, of the other kinds
} work;

static void free_inputs(work *w)
{
    for (size_t i = 0; i < w->n_sp3; i++) orr_sp3_free(&w->sp3[i]);
    for (size_t i = 0; i < w->n_clk; i++) orr_clk_free(&w->clk[i]);
    w->n_sp3 = w->n_clk = 0;
}

static void work_free(work *w)
{
    free_inputs(w);
    free(w->sp3);
    free(w->input);
    orr_nav_free(&w->nav);
    free(w->clk);
    free(w->clk_input);
    orr_inputs_free(&w->inputs);
    orr_gravity_model_free(w->gravity);
    orr_inputs_free(&w->also);
}

static orr_status read_sp3(const orr_orbit_plan *plan, const orr_log *log, work *w, orr_warnings *warnings,
                           orr_diag *diag)
{
    orr_status s = ORR_OK;
    orr_sp3_limits limits = orr_sp3_default_limits();
    limits.leap = plan->leap;
    w->also.leap = plan->leap;
    w->sp3 = calloc(plan->n_sp3 + 1, sizeof *w->sp3);
    w->input = calloc(plan->n_sp3 + 1, sizeof *w->input);
    if (w->sp3 == NULL || w->input == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", plan->n_sp3);
    for (size_t i = 0; i < plan->n_sp3 && s == ORR_OK; i++) {
        orr_bytes text;
        ORR_LOG(log, ORR_LOG_INFO, "reading %s", plan->sp3[i]);
        s = orr_inputs_read(&w->inputs, plan->sp3[i], ORR_KIND_BIT(ORR_KIND_SP3), &text, diag);
        if (s == ORR_OK)
            s = orr_sp3_parse(plan->sp3[i], text.text, text.n, &limits, &w->sp3[i], warnings, diag);
        orr_bytes_free(&text);
        w->n_sp3 = i + 1;
        if (s != ORR_OK) break;
        if (orr_frames_differ(w->sp3[0].coordinates, w->sp3[i].coordinates))
            orr_warnings_add(warnings, plan->sp3[i], 0, 0,
                             "is in %s, %s in %s: orbits of different frames are joined, centimetres apart",
                             w->sp3[i].coordinates, plan->sp3[0], w->sp3[0].coordinates);
        w->input[i].sp3 = &w->sp3[i];
        snprintf(w->input[i].name, sizeof w->input[i].name, "%s", w->inputs.item[i].name);
        snprintf(w->input[i].sha256, sizeof w->input[i].sha256, "%s", w->inputs.item[i].sha256);
    }
    return s;
}

// Nodes that a file does not have at their step: the epochs that both have are few.
static void check_nodes(const orr_orbit_plan *plan, const work *w, orr_warnings *warnings)
{
    for (size_t i = 0; i < w->n_sp3; i++) {
        const int64_t step = llround(plan->smoother.node_step_s * 1e3),
                      own = llround(w->sp3[i].interval_s * 1e3);
        if (step <= 0 || own <= 0 || step % own == 0) continue;
        int64_t a = step, b = own;
        while (b != 0) {
            const int64_t rest = a % b;
            a = b;
            b = rest;
        }
        orr_warnings_add(
            warnings, plan->sp3[i], 0, 0,
            "nodes every %g s are wanted, and its epochs are %g s apart: what both have is every %g s",
            plan->smoother.node_step_s, w->sp3[i].interval_s, (double)(step / a * own) * 1e-3);
    }
}

static orr_status read_erp(const orr_orbit_plan *plan, work *w, orr_eop_series *eop, orr_warnings *warnings,
                           orr_diag *diag)
{
    if (plan->n_erp == 0) return ORR_OK;
    orr_erp *erp = calloc(plan->n_erp, sizeof *erp);
    if (erp == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", plan->n_erp);
    orr_status s = ORR_OK;
    for (size_t i = 0; i < plan->n_erp && s == ORR_OK; i++) {
        orr_bytes text;
        s = orr_inputs_read(&w->also, plan->erp[i], ORR_KIND_BIT(ORR_KIND_ERP), &text, diag);
        if (s == ORR_OK)
            s = orr_erp_parse(plan->erp[i], text.text, text.n, plan->leap, NULL, &erp[i], warnings, diag);
        orr_bytes_free(&text);
    }
    if (s == ORR_OK) s = orr_erp_merge(erp, plan->n_erp, eop, diag);
    for (size_t i = 0; i < plan->n_erp; i++) orr_erp_free(&erp[i]);
    free(erp);
    return s;
}

static orr_status read_clk(const orr_orbit_plan *plan, work *w, orr_warnings *warnings, orr_diag *diag)
{
    orr_status s = ORR_OK;
    orr_read_limits clk_limits = orr_read_default_limits();
    clk_limits.leap = plan->leap;
    w->clk = calloc(plan->n_clk + 1, sizeof *w->clk);
    w->clk_input = calloc(plan->n_clk + 1, sizeof *w->clk_input);
    if (w->clk == NULL || w->clk_input == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu files", plan->n_clk);
    for (size_t i = 0; i < plan->n_clk && s == ORR_OK; i++) {
        orr_bytes text;
        s = orr_inputs_read(&w->also, plan->clk[i], ORR_KIND_BIT(ORR_KIND_RINEX_CLK), &text, diag);
        if (s == ORR_OK)
            s = orr_clk_parse(plan->clk[i], text.text, text.n, &clk_limits, &w->clk[i], warnings, diag);
        orr_bytes_free(&text);
        w->n_clk = i + 1;
        if (s != ORR_OK) break;
        if (w->clk[i].n_sats == 0)
            return orr_diag_set(diag, ORR_E_NODATA, "%s has clocks of receivers alone, none of a satellite",
                                plan->clk[i]);
        w->clk_input[i].clk = &w->clk[i];
        snprintf(w->clk_input[i].name, sizeof w->clk_input[i].name, "%s", w->also.item[w->also.n - 1].name);
    }
    return s;
}

static orr_status read_gravity(const orr_orbit_plan *plan, work *w, orr_diag *diag)
{
    char path[2][4096];
    if (plan->gravity_model == NULL) return ORR_OK;
    orr_status s = orr_gravity_model_open_to(plan->gravity_model, plan->gravity_dir, plan->gravity_degree,
                                             &w->gravity, diag);
    if (s != ORR_OK) return s;
    orr_gravity_model_file(w->gravity, path[0], sizeof path[0] - 4);
    snprintf(path[1], sizeof path[1], "%.*s.cof", (int)sizeof path[0] - 5, path[0]);
    for (int i = 0; i < 2 && s == ORR_OK; i++) s = orr_inputs_note(&w->also, path[i], diag);
    return s;
}

static orr_status read_all(const orr_orbit_plan *plan, const orr_log *log, work *w, orr_eop_series *eop,
                           orr_warnings *warnings, orr_diag *diag)
{
    orr_status s = read_sp3(plan, log, w, warnings, diag);
    if (s == ORR_OK) check_nodes(plan, w, warnings);
    if (s == ORR_OK) s = read_erp(plan, w, eop, warnings, diag);
    if (s == ORR_OK) s = read_clk(plan, w, warnings, diag);
    if (s == ORR_OK) s = read_gravity(plan, w, diag);
    if (s == ORR_OK && plan->n_nav > 0)
        s = orr_inputs_read_navs(&w->also, plan->nav, plan->n_nav, &w->nav, warnings, diag);
    return s;
}

static orr_status predict(const orr_orbit_plan *plan, const work *w, const orr_eop_series *eop,
                          const orr_log *log, const volatile int *cancel, orr_orbit_made *out,
                          orr_warnings *warnings, orr_diag *diag)
{
    const orr_time last = out->solution.to;
    const bool later = plan->predict_after != ORR_TIME_NONE && plan->predict_after > last;
    const orr_predict_options o = {
        .to = orr_time_add_s(later ? plan->predict_after : last, plan->predict_s),
        .eop = eop->n > 0 && out->report.eop_known ? eop : NULL,
        .leap = plan->leap,
        .sats = plan->smoother.sats,
        .jobs = plan->smoother.jobs,
    };
    return orr_predict(&out->solution, w->input, w->n_sp3, &o, log, cancel, &out->prediction, warnings, diag);
}

// What a long span is streamed to.
typedef struct stream {
    work *w;
    orr_ephemeris_parts *parts;
} stream;

static void inputs_are_read(void *user)
{
    stream *s = user;
    free_inputs(s->w);
}

static orr_status satellite_is_done(void *user, const orr_orbit_sat *sat)
{
    stream *s = user;
    return orr_ephemeris_parts_add(s->parts, sat);
}

// Positions from which on a product is made satellite by satellite: a fortnight of 80 satellites every quarter of an hour. What
// is shorter takes less than 250 MB as a whole, and no room beside the output.
#define MANY_POSITIONS 100000

static orr_status begin_parts(const orr_orbit_plan *plan, const work *w, orr_ephemeris_parts **parts,
                              orr_diag *diag)
{
    size_t n = 0;
    for (size_t i = 0; i < w->n_sp3; i++) n += w->sp3[i].n_sats * w->sp3[i].n_epochs;
    return n < MANY_POSITIONS ? ORR_OK : orr_ephemeris_parts_begin(plan->folder, parts, diag);
}

// parts: where satellites go to instead of the solution, if there are many; NULL: they stay in it.
static orr_status solve(const orr_orbit_plan *plan, orr_ephemeris_parts **parts, const orr_log *log,
                        const volatile int *cancel, orr_orbit_made *out, orr_warnings *warnings,
                        orr_diag *diag)
{
    *out = (orr_orbit_made){0};
    if (plan->n_sp3 > ORR_ORBIT_MAX_FILES || plan->n_erp > ORR_ORBIT_MAX_FILES ||
        plan->n_nav > ORR_ORBIT_MAX_FILES || plan->n_clk > ORR_ORBIT_MAX_FILES)
        return orr_diag_set(diag, ORR_E_LIMIT, "at most %d files of a kind are smoothed at once",
                            ORR_ORBIT_MAX_FILES);
    work w = {0};
    stream to = {.w = &w};
    orr_eop_series eop = {0};
    const double begin_s = orr_monotonic_s();
    orr_status s = read_all(plan, log, &w, &eop, warnings, diag);
    const double read_s = orr_monotonic_s();
    if (s == ORR_OK && parts != NULL) s = begin_parts(plan, &w, parts, diag);
    if (parts != NULL) to.parts = *parts;
    if (s == ORR_OK) {
        orr_smoother_options options = plan->smoother;
        options.observed_only = plan->predict;
        options.eop = eop.n > 0 ? &eop : NULL;
        options.leap = plan->leap;
        options.low_gravity = w.gravity;
        options.nav = plan->n_nav > 0 ? &w.nav : NULL;
        options.clk = w.clk_input;
        options.n_clk = w.n_clk;
        options.also = w.also.item;
        options.n_also = w.also.n;
        options.stream.user = &to;
        if (to.parts != NULL) {
            options.stream.read = inputs_are_read;
            options.stream.done = satellite_is_done;
        }
        s = orr_smoother_run(w.input, w.n_sp3, &options, log, cancel, &out->solution, &out->report, warnings,
                             diag);
    }
    if (s == ORR_OK && plan->predict) s = predict(plan, &w, &eop, log, cancel, out, warnings, diag);
    if (s == ORR_OK)
        ORR_LOG(log, ORR_LOG_INFO, "smoothed %zu nodes of %zu satellites, residual RMS %.2f mm",
                out->report.nodes_used, out->report.satellites, 1e3 * out->report.residual_rms_m);
    out->read_s = read_s - begin_s;
    out->smooth_s = orr_monotonic_s() - read_s;
    orr_erp_series_free(&eop);
    work_free(&w);
    return s;
}

orr_status orr_orbit_solve(const orr_orbit_plan *plan, const orr_log *log, const volatile int *cancel,
                           orr_orbit_made *out, orr_warnings *warnings, orr_diag *diag)
{
    return solve(plan, NULL, log, cancel, out, warnings, diag);
}

orr_status orr_orbit_make(const orr_orbit_plan *plan, const orr_log *log, const volatile int *cancel,
                          orr_orbit_made *out, orr_warnings *warnings, orr_diag *diag)
{
    orr_ephemeris_parts *parts = NULL;
    const bool may = plan->folder != NULL && !plan->predict;
    orr_status s = solve(plan, may ? &parts : NULL, log, cancel, out, warnings, diag);
    const double solved_s = orr_monotonic_s();
    if (s != ORR_OK && parts != NULL) orr_ephemeris_parts_error(parts, diag);
    if (s == ORR_OK)
        s = parts != NULL ? orr_ephemeris_parts_join(parts, &out->solution, &out->ephemeris, diag)
                          : orr_ephemeris_build(&out->solution, &out->ephemeris, diag);
    orr_ephemeris_parts_free(parts);
    out->fit_s = orr_monotonic_s() - solved_s;
    return s;
}

void orr_orbit_made_free(orr_orbit_made *m)
{
    orr_ephemeris_free(m->ephemeris);
    orr_orbit_solution_free(&m->solution);
    *m = (orr_orbit_made){0};
}

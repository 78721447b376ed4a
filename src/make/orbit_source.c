// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/orbit_source.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/parallel.h"
#include "core/sha256.h"
#include "ingest/tables/erp.h"
#include "orbit/smooth/smoother.h"

enum { MAX_FILES = 400 };

static orr_status read_all(const orr_scenario_orbit *o, const orr_log *log, orr_sp3 *sp3,
                           orr_smoother_input *input, size_t *n_read, orr_warnings *warnings, orr_diag *diag)
{
    for (*n_read = 0; *n_read < o->sp3.n; ++*n_read) {
        size_t i = *n_read;
        const char *path = o->sp3.item[i], *slash = strrchr(path, '/');
        ORR_LOG(log, ORR_LOG_INFO, "reading %s", path);
        orr_status s = orr_sp3_read(path, NULL, &sp3[i], warnings, diag);
        if (s != ORR_OK) return s;
        input[i].sp3 = &sp3[i];
        snprintf(input[i].name, sizeof input[i].name, "%s", slash != NULL ? slash + 1 : path);
        s = orr_sha256_file(path, input[i].sha256, diag);
        if (s != ORR_OK) {
            ++*n_read;
            return s;
        }
    }
    return ORR_OK;
}

static orr_status read_erps(const orr_scenario_orbit *o, orr_eop_series *eop, orr_warnings *warnings,
                            orr_diag *diag)
{
    size_t n = 0;
    orr_erp *erp = calloc(o->erp.n, sizeof *erp);
    orr_status s = erp == NULL ? orr_diag_set(diag, ORR_E_MEMORY, "out of memory") : ORR_OK;
    for (; s == ORR_OK && n < o->erp.n; n++) {
        s = orr_erp_read(o->erp.item[n], NULL, NULL, &erp[n], warnings, diag);
        if (s != ORR_OK) break;
    }
    if (s == ORR_OK) s = orr_erp_merge(erp, n, eop, diag);
    for (size_t i = 0; i < n; i++) orr_erp_free(&erp[i]);
    free(erp);
    return s;
}

static orr_status smooth(const orr_scenario_orbit *o, const orr_smoother_input *input,
                         const orr_eop_series *eop, const orr_log *log, const volatile int *cancel,
                         orr_warnings *warnings, orr_ephemeris **out, orr_diag *diag)
{
    orr_smoother_options options = orr_smoother_defaults();
    options.node_step_s = o->nodes_s;
    options.exclude = o->exclude.item;
    options.n_exclude = o->exclude.n;
    options.eop = eop->n > 0 ? eop : NULL;
    options.jobs = orr_parallel_cores();
    orr_orbit_solution solution = {0};
    orr_smoother_report report = {0};
    orr_status s =
        orr_smoother_run(input, o->sp3.n, &options, log, cancel, &solution, &report, warnings, diag);
    if (s != ORR_OK) return s;
    ORR_LOG(log, ORR_LOG_INFO, "smoothed %zu nodes of %zu satellites, residual RMS %.2f mm",
            report.nodes_used, solution.n_sats, 1e3 * report.residual_rms_m);
    s = orr_ephemeris_build(&solution, out, diag);
    orr_orbit_solution_free(&solution);
    return s;
}

orr_status orr_orbit_source_smooth(const orr_scenario_orbit *o, const orr_log *log,
                                   const volatile int *cancel, orr_warnings *warnings, orr_ephemeris **out,
                                   orr_eop_series *eop, orr_diag *diag)
{
    *eop = (orr_eop_series){0};
    if (o->sp3.n > MAX_FILES || o->erp.n > MAX_FILES)
        return orr_diag_set(diag, ORR_E_LIMIT, "orbit.sp3 names %zu files, at most %d are smoothed at once",
                            o->sp3.n, MAX_FILES);
    orr_sp3 *sp3 = calloc(o->sp3.n, sizeof *sp3);
    orr_smoother_input *input = calloc(o->sp3.n, sizeof *input);
    size_t n_read = 0;
    orr_status s = ORR_OK;
    if (sp3 == NULL || input == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK) s = read_all(o, log, sp3, input, &n_read, warnings, diag);
    if (s == ORR_OK && o->erp.n > 0) s = read_erps(o, eop, warnings, diag);
    if (s == ORR_OK) s = smooth(o, input, eop, log, cancel, warnings, out, diag);
    if (s != ORR_OK) orr_erp_series_free(eop);
    for (size_t i = 0; i < n_read; i++) orr_sp3_free(&sp3[i]);
    free(sp3);
    free(input);
    return s;
}

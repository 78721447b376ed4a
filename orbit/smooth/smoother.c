// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/smoother.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/parallel.h"
#include "orbit/smooth/frame_check.h"
#include "orbit/smooth/given_rotation.h"
#include "orbit/smooth/node_times.h"
#include "orbit/smooth/reference.h"
#include "orbit/smooth/smooth_satellite.h"

orr_smoother_options orr_smoother_defaults(void)
{
    return (orr_smoother_options){
        .frame = ORR_SKY_GCRS,
        .gravity_degree = 8,
        .low_gravity_degree = ORR_GRAVITY_MAX_DEGREE,
        .sun_moon = true,
        .srp_mps2 = 1e-7,
        .reference = true,
        .sigma_m = 1e-3,
        .sigma_predicted_m = 4e-3,
        .qf_m2ps5 = 3.16227766e-21,
        .f0_sigma_mps2 = 1e-9,
        .plain = {.sigma_m = 0.025,
                  .sigma_predicted_m = 0.10,
                  .qf_m2ps5 = 1e-16,
                  .f0_sigma_mps2 = 1e-3, // diffuse: the first nodes decide
                  .choose_qf = true},
        .f0_axes = ORR_F0_RTN,
        .max_gap_s = 8 * 3600.0,
        .extend_to = ORR_TIME_NONE,
        .clock_gap_s = 1350,
        .detect = true,
        .grid_s = 150,
        .jobs = 1,
    };
}

orr_smoother_options orr_smoother_literal(void)
{
    orr_smoother_options o = orr_smoother_defaults();
    o.frame = ORR_SKY_UNIFORM;
    o.gravity_degree = o.low_gravity_degree = 0;
    o.sun_moon = false;
    o.srp_mps2 = 0;
    o.reference = false;
    o.plain.qf_m2ps5 = 0;
    o.plain.choose_qf = false;
    o.plain.qv_m2ps3 = 1e-6; // q1..q3 stand for J2, Sun and Moon; larger values change nothing any more
    o.f0_axes = ORR_F0_ECEF;
    o.passes = 1;
    o.detect = false;
    return o;
}

static orr_status check_options(const orr_smoother_options *o, orr_diag *diag)
{
    if (!(o->sigma_m > 0) || !(o->sigma_predicted_m > 0) || !(o->plain.sigma_m > 0) ||
        !(o->plain.sigma_predicted_m > 0))
        return orr_diag_set(diag, ORR_E_ARG, "sigma of a node must be positive");
    if (!(o->qf_m2ps5 >= 0) || !(o->plain.qf_m2ps5 >= 0) || !(o->plain.qv_m2ps3 >= 0) ||
        !(o->f0_sigma_mps2 > 0) || !(o->plain.f0_sigma_mps2 > 0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "noise of f0 and velocity cannot be negative, and f0's sigma must be positive");
    if (!(o->grid_s >= 1 && o->grid_s <= 900))
        return orr_diag_set(diag, ORR_E_ARG, "grid of %g s is not in 1..900 s", o->grid_s);
    if (!(o->max_gap_s > 0 && o->max_gap_s <= 172800))
        return orr_diag_set(diag, ORR_E_ARG, "longest bridged gap of %g s is not in (0, 48 h]", o->max_gap_s);
    if (!(o->clock_gap_s >= 0 && o->clock_gap_s <= 172800))
        return orr_diag_set(diag, ORR_E_ARG, "longest bridged hole of clocks of %g s is not in [0, 48 h]",
                            o->clock_gap_s);
    if (!(o->node_step_s >= 0)) return orr_diag_set(diag, ORR_E_ARG, "node step cannot be negative");
    if (o->bridge && o->nav == NULL)
        return orr_diag_set(diag, ORR_E_ARG, "bridging needs broadcast ephemerides");
    if (o->passes < 0 || o->jobs < 1 || o->jobs > 256)
        return orr_diag_set(diag, ORR_E_ARG, "passes must be 0 or more, jobs 1 to 256");
    return ORR_OK;
}

static void describe(const orr_smoother_options *o, bool about_reference, char *buf, size_t n)
{
    static const char *axes[] = {"RTN", "inertial", "ecef"};
    char low[40] = ""; // the model's name is among the inputs
    if (o->low_gravity != NULL)
        snprintf(low, sizeof low, " (of low orbits: a model's %d)", orr_gravity_model_degree(o->low_gravity));
    const int used =
        snprintf(buf, n, "prior: %s; frame: %s; gravity: EGM96 %d%s%s; Sun and Moon: %s; ",
                 o->nav == NULL ? "sparse SP3"
                 : o->bridge    ? "broadcast, bridging"
                                : "broadcast",
                 o->frame != ORR_SKY_GCRS ? "uniform rotation"
                 : about_reference        ? "GCRS (IAU 2006/2000A)"
                                          : "GCRS (IAU 2006/2000B)",
                 o->gravity_degree, o->zonal_only ? " zonal" : "", low, o->sun_moon ? "yes" : "no");
    if (used < 0 || (size_t)used >= n) return;
    buf += used;
    n -= (size_t)used;
    if (about_reference)
        snprintf(buf, n,
                 "reference fit: ECOM, solid tide, relativity, albedo; sigma: %g m (predicted %g m); f0: %s, "
                 "qf %g "
                 "m2/s5, a-priori %g m/s2; node step: %g s; longest gap: %g s; detection: %s; passes: %d",
                 o->sigma_m, o->sigma_predicted_m, axes[o->f0_axes], o->qf_m2ps5, o->f0_sigma_mps2,
                 o->node_step_s, o->max_gap_s, o->detect ? "yes" : "no", o->passes);
    else
        snprintf(buf, n,
                 "SRP: %g m/s2; sigma: %g m (predicted %g m); f0: %s, qf %g m2/s5, a-priori %g m/s2; qv: %g "
                 "m2/s3; node "
                 "step: %g s; longest gap: %g s; detection: %s; passes: %d",
                 o->srp_mps2, o->plain.sigma_m, o->plain.sigma_predicted_m, axes[o->f0_axes],
                 o->plain.qf_m2ps5, o->plain.f0_sigma_mps2, o->plain.qv_m2ps3, o->node_step_s, o->max_gap_s,
                 o->detect ? "yes" : "no", o->passes);
}

// Appended to the settings in words.
static void describe_clocks(const orr_smoother_options *o, double max_gap_s, char *buf, size_t n)
{
    const size_t used = strlen(buf);
    snprintf(buf + used, n - used, "; clocks: %sreference %s, longest hole: %g s",
             o->n_clk > 0 ? "RINEX CLK before SP3, " : "", o->clock_remove_reference ? "removed" : "kept",
             max_gap_s);
}

// Work shared by the threads: satellites are independent, each goes to whichever thread is free, into its own
// place.
typedef struct pool {
    const orr_smoother_options *options;
    const orr_sky *sky;
    const orr_force *force;
    orr_node_table *table;
    bool eop_known;
    const orr_satellite_reference *reference; // per list of the table, or NULL
    const volatile int *cancel;
    orr_orbit_sat *sat; // per list of the table
    size_t *arcs;       // of those that were handed over
    orr_satellite_report *report;
    orr_status *status;
    size_t n_files;
    const orr_file_noise *file;  // NULL: not known yet
    orr_file_evidence *evidence; // per list and file
    const bool *again;           // NULL: all
    atomic_size_t next;
} pool;

// A satellite that is done with goes to whoever takes them one by one; how many arcs it had is counted.
static void hand_over(pool *p, size_t i)
{
    const orr_smoother_options *o = p->options;
    if (o->stream.done == NULL || p->status[i] != ORR_OK) return;
    const size_t n_arcs = p->sat[i].n_arcs;
    p->status[i] = o->stream.done(o->stream.user, &p->sat[i]);
    orr_satellite_free(&p->sat[i]);
    p->arcs[i] = n_arcs;
}

static void *worker(void *arg)
{
    pool *p = arg;
    orr_integrator *it = NULL;
    orr_force force = *p->force;
    orr_status ready = orr_integrator_init(&force, p->sky, &it, NULL);
    orr_track_context c = {
        .options = p->options, .sky = p->sky, .force = &force, .integrator = it, .eop_known = p->eop_known};
    for (;;) {
        size_t i = atomic_fetch_add(&p->next, 1);
        if (i >= p->table->n_sats) break;
        if (p->again != NULL && !p->again[i]) continue;
        if (ready != ORR_OK)
            p->status[i] = ready;
        else if (p->cancel != NULL && *p->cancel)
            p->status[i] = ORR_E_INTERRUPTED;
        else {
            c.reference = p->reference != NULL ? &p->reference[i] : NULL;
            c.file = p->file;
            p->status[i] = orr_satellite_smooth(&c, p->table, &p->table->list[i], p->n_files,
                                                p->file == NULL ? &p->evidence[i * p->n_files] : NULL,
                                                &p->sat[i], &p->report[i]);
            hand_over(p, i);
        }
    }
    orr_integrator_free(it);
    return NULL;
}

// Nodes of one satellite that are of a record which holds another orbit; whether there are any.
static bool mark_foreign(orr_node_list *l, const orr_file_noise *file)
{
    bool any = false;
    for (size_t i = 0; i < l->n_nodes; i++)
        for (int end = 0; end < ORR_FILE_ENDS; end++) {
            const orr_foreign_record *r = &file[l->node[i].source].end[end];
            if (!r->foreign || l->node[i].t != r->t || l->node[i].bridge) continue;
            l->node[i].foreign = any = true;
        }
    return any;
}

static bool any_late(const orr_node_list *l)
{
    for (size_t i = 0; i < l->n_nodes; i++)
        if (fabs(l->node[i].late_s) > 0) return true;
    return false;
}

// What all satellites tell of the files, and those again whose orbits it touches.
static orr_status know_files(pool *p, int jobs, orr_file_noise *file, orr_epoch_spread *times, bool *again)
{
    const size_t n = p->n_files;
    bool any = false;
    orr_status s = orr_file_noise_decide(p->evidence, p->table->n_sats, n, file);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i < p->table->n_sats; i++)
        again[i] = p->options->detect && p->status[i] == ORR_OK && mark_foreign(&p->table->list[i], file);
    if (p->options->detect) s = orr_node_times_take(p->table, n, times);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i < p->table->n_sats; i++) {
        again[i] = again[i] || (p->status[i] == ORR_OK && any_late(&p->table->list[i]));
        for (size_t f = 0; f < n && p->status[i] == ORR_OK; f++) {
            const orr_file_evidence *e = &p->evidence[i * n + f];
            again[i] = again[i] || (e->eclipsing && file[f].shadow_factor > 1) ||
                       ((e->eclipsing || e->noon) && file[f].noon_step);
        }
        if (again[i]) orr_satellite_free(&p->sat[i]);
        any = any || again[i];
    }
    if (!any) return ORR_OK;
    p->file = file;
    p->again = again;
    atomic_store(&p->next, 0);
    orr_parallel_run(jobs, worker, p);
    return ORR_OK;
}

// Files whose orbits have more than a random walk.
static void tell_files(const orr_smoother_input *input, size_t n, const orr_file_noise *file,
                       const orr_epoch_spread *times, orr_warnings *warnings)
{
    for (size_t f = 0; f < n; f++) {
        if (times[f].epochs > 0)
            orr_warnings_add(
                warnings, input[f].name, 0, 0,
                "positions are not quite those of their epochs: all satellites alike are %.2f us RMS ahead "
                "or behind along their orbits, %.2f us at most, as where a centre rounds its time; that is "
                "taken out",
                1e6 * times[f].rms_s, 1e6 * times[f].most_s);
        if (file[f].shadow_factor > 1)
            orr_warnings_add(warnings, input[f].name, 0, 0,
                             "orbits are not smooth near the Earth's shadow; the noise of %zu satellites is "
                             "%g times as large there, and their sigma is less sure",
                             file[f].eclipsing, file[f].shadow_factor);
        for (int end = 0; end < ORR_FILE_ENDS; end++) {
            const orr_foreign_record *r = &file[f].end[end];
            char when[ORR_TIME_TEXT];
            if (r->foreign)
                orr_warnings_add(warnings, input[f].name, 0, 0,
                                 "the record of %s, its %s, holds another orbit: %.0f mm off what the others "
                                 "tell, the median of %zu satellites; it is left out",
                                 orr_time_text(r->t, when), end == 0 ? "first" : "last", 1e3 * r->off_m,
                                 r->n);
        }
        if (file[f].noon_step)
            orr_warnings_add(warnings, input[f].name, 0, 0,
                             "orbits have a step of velocity at noon, as of two half days joined; it is "
                             "allowed for (%.1f in the logarithm of the likelihood a satellite)",
                             file[f].noon_gain / (double)file[f].telling);
    }
}

// Satellites of which one thing is to be said: how many, and the first of them.
typedef struct few {
    size_t n;
    char first[ORR_SAT_TEXT];
} few;
static void count_in(few *f, const char *name)
{
    if (f->n++ == 0) snprintf(f->first, sizeof f->first, "%s", name);
}

// Moves finished satellites into the solution and counts; what was left out is said.
static orr_status collect(pool *p, orr_orbit_solution *out, orr_smoother_report *report,
                          orr_warnings *warnings, orr_diag *diag)
{
    double residual_m2 = 0;
    size_t satellites = 0;
    few absent = {0}, without_broadcast = {0};
    for (size_t i = 0; i < p->table->n_sats; i++) {
        const orr_satellite_report *r = &p->report[i];
        char name[ORR_SAT_TEXT];
        orr_sat_text(p->table->list[i].sat, name);
        if (p->status[i] != ORR_OK)
            return orr_diag_set(diag, p->status[i], "%s: %s", name,
                                p->status[i] == ORR_E_INTERRUPTED ? "interrupted"
                                                                  : orr_status_name(p->status[i]));
        if (r->note[0] != '\0')
            orr_warnings_add(warnings, NULL, 0, 0, "%s: %s; that stretch is left out", name, r->note);
        const size_t n_arcs = p->sat[i].n_arcs + p->arcs[i];
        if (n_arcs == 0) {
            if (p->table->list[i].n_nodes == 0) {
                count_in(&absent, name);
            } else if (r->note[0] == '\0')
                orr_warnings_add(warnings, NULL, 0, 0, "%s: its positions agree with no orbit; left out",
                                 name);
            orr_satellite_free(&p->sat[i]);
            continue;
        }
        if (p->options->nav != NULL && r->from_broadcast == 0) count_in(&without_broadcast, name);
        report->nodes_used += r->nodes_used;
        report->nodes_rejected += r->nodes_rejected;
        report->manoeuvres += r->manoeuvres;
        report->arcs += n_arcs;
        satellites++;
        if (r->passes > report->passes_max) report->passes_max = r->passes;
        residual_m2 += r->residual_m2;
        if (p->options->stream.done != NULL) continue;
        out->sat[out->n_sats++] = p->sat[i];
        p->sat[i] = (orr_orbit_sat){0};
    }
    if (absent.n > 0)
        orr_warnings_add(warnings, NULL, 0, 0,
                         "satellites without any position to smooth: %zu (%s the first)", absent.n,
                         absent.first);
    if (without_broadcast.n > 0)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "satellites of which no broadcast ephemeris fits a position: %zu (%s the first); they are "
            "smoothed from their positions alone",
            without_broadcast.n, without_broadcast.first);
    report->residual_rms_m = report->nodes_used > 0 ? sqrt(residual_m2 / (double)report->nodes_used) : 0;
    report->satellites = satellites;
    return satellites > 0 ? ORR_OK : orr_diag_set(diag, ORR_E_NODATA, "no satellite could be smoothed");
}

static orr_status describe_sources(const orr_smoother_input *input, size_t n, const orr_smoother_options *o,
                                   orr_node_table *table, bool about_reference, orr_orbit_solution *out)
{
    out->source = calloc(n + o->n_also, sizeof *out->source);
    out->sat = calloc(table->n_sats + 1, sizeof *out->sat);
    if (out->source == NULL || out->sat == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < n; i++) {
        snprintf(out->source[i].name, sizeof out->source[i].name, "%s", input[i].name);
        snprintf(out->source[i].sha256, sizeof out->source[i].sha256, "%s", input[i].sha256);
    }
    for (size_t i = 0; i < o->n_also; i++) out->source[n + i] = o->also[i];
    out->n_sources = n + o->n_also;
    out->node_step_s = table->step_s;
    out->clock_max_gap_s = table->clock_max_gap_s;
    out->clock_events = table->clock_events;
    table->clock_events = (orr_clock_events){0};
    out->from = table->from;
    out->to = table->to;
    describe(o, about_reference, out->options, sizeof out->options);
    describe_clocks(o, table->clock_max_gap_s, out->options, sizeof out->options);
    return ORR_OK;
}

#define MAS (ORR_RAD_PER_DEG / 3.6e6)
// A centre's own pole is within 0.1 mas of what its orbits tell; another centre's, or a prediction, within these.
#define POLE_CONTRADICTS_MAS 5.0
#define LOD_CONTRADICTS_MS 0.5

// Orbits and the Earth's rotation. A given rotation that covers the span is kept, unless the orbits contradict it.
static orr_status fit_reference(const orr_smoother_options *o, const orr_node_table *table,
                                const volatile int *cancel, orr_run_reference *r, bool *usable,
                                orr_smoother_report *report, orr_warnings *warnings, orr_diag *diag)
{
    bool hold = o->eop != NULL && report->eop_known;
    orr_status s = orr_run_reference_make(o, table, hold, cancel, r, diag);
    if (s != ORR_OK) return s;
    report->xp_off_rad = r->fit.xp_rad;
    report->yp_off_rad = r->fit.yp_rad;
    report->lod_off_s = r->fit.lod_s;
    const double pole_mas = hypot(r->fit.xp_rad, r->fit.yp_rad) / MAS, lod_ms = 1e3 * r->fit.lod_s;
    if (hold && r->fit.estimated && (pole_mas > POLE_CONTRADICTS_MAS || fabs(lod_ms) > LOD_CONTRADICTS_MS)) {
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "the Earth rotation given contradicts the orbits: they tell a pole that is %.1f mas off, and a "
            "length of day that is %.2f ms off; what the orbits tell is used instead",
            pole_mas, lod_ms);
        report->eop_known = hold = false;
        orr_run_reference_free(r);
        s = orr_run_reference_make(o, table, hold, cancel, r, diag);
        if (s != ORR_OK) return s;
    }
    report->eop_told = r->fit.estimated;
    report->eop_estimated = r->fit.estimated && !hold;
    report->pole_sigma_rad = r->fit.pole_sigma_rad;
    *usable = r->fit.estimated || report->eop_known;
    const orr_eop e =
        orr_eop_at(&r->fit.rotation,
                   orr_time_add_s(table->from, 0.5 * orr_time_diff_s(table->to, table->from)), NULL, NULL);
    report->xp_rad = e.xp_rad;
    report->yp_rad = e.yp_rad;
    report->lod_s = e.lod_s;
    return ORR_OK;
}

// What the product's frame turns with: the reference's rotation where the satellites go by it.
static orr_status keep_rotation(const orr_smoother_options *o, const orr_node_table *table,
                                orr_reference_fit *fit, bool about_reference,
                                const orr_smoother_report *report, orr_earth_rotation *out)
{
    if (!about_reference) {
        if (o->eop == NULL) return orr_earth_rotation_secular(table->from, table->to, o->leap, out);
        out->source = ORR_ROTATION_GIVEN;
        return orr_eop_series_copy(o->eop, &out->series);
    }
    out->series = fit->rotation;
    fit->rotation = (orr_eop_series){0};
    out->source = ORR_ROTATION_GIVEN;
    if (!report->eop_estimated) return ORR_OK;
    out->source = ORR_ROTATION_ESTIMATED;
    out->pole_sigma_rad = fit->pole_sigma_rad;
    out->lod_sigma_s = fit->lod_sigma_s;
    return ORR_OK;
}

orr_status orr_smoother_run(const orr_smoother_input *input, size_t n_inputs,
                            const orr_smoother_options *wanted, const orr_log *log,
                            const volatile int *cancel, orr_orbit_solution *out, orr_smoother_report *report,
                            orr_warnings *warnings, orr_diag *diag)
{
    orr_smoother_options own = *wanted;
    const orr_smoother_options *options = &own;
    orr_given_rotation given = ORR_GIVEN_COVERS;
    char given_text[256] = "";
    orr_smoother_report unused;
    if (report == NULL) report = &unused;
    *report = (orr_smoother_report){0};
    *out = (orr_orbit_solution){0};
    orr_force force = {.sun_moon = options->sun_moon, .srp_mps2 = options->srp_mps2};
    orr_node_table table = {0};
    orr_sky *sky = NULL;
    orr_status s = check_options(options, diag);
    if (s == ORR_OK)
        s = orr_gravity_field_init(&force.earth, options->low_gravity_degree, options->zonal_only, diag);
    if (s == ORR_OK)
        s = orr_gravity_field_init(&force.earth, options->gravity_degree, options->zonal_only, diag);
    for (size_t i = 0; i < n_inputs && s == ORR_OK; i++)
        s = orr_frame_check(input[i].sp3, input[i].name, diag);
    if (s == ORR_OK) s = orr_nodes_collect(input, n_inputs, options, &table, warnings, diag);
    if (s != ORR_OK) return s;
    snprintf(out->frame, sizeof out->frame, "%s", input[0].sp3->coordinates);
    if (options->stream.read != NULL) options->stream.read(options->stream.user);
    ORR_LOG(log, ORR_LOG_INFO, "%zu satellites, nodes every %g s", table.n_sats, table.step_s);
    if (own.eop != NULL)
        given = orr_given_rotation_of(own.eop, table.from, table.to, given_text, sizeof given_text);
    if (given == ORR_GIVEN_SAYS_NOTHING) own.eop = NULL;
    s = orr_sky_init(table.from, table.to, options->frame, options->eop, options->leap, &sky,
                     &report->eop_known, diag);
    orr_run_reference reference = {0};
    bool about_reference = false;
    if (s == ORR_OK && options->reference && options->frame == ORR_SKY_GCRS && options->gravity_degree >= 2)
        s = fit_reference(options, &table, cancel, &reference, &about_reference, report, warnings, diag);
    report->eop_carried_on = given == ORR_GIVEN_CARRIED_ON;
    if (s == ORR_OK && given == ORR_GIVEN_SAYS_NOTHING && !about_reference)
        s = orr_diag_set(
            diag, ORR_E_NODATA,
            "%s, more than a month from any value; so few orbits do not tell the rotation by "
            "themselves: give a file that covers them, or none, and the IERS secular pole will serve",
            given_text);
    if (s == ORR_OK && given != ORR_GIVEN_COVERS)
        orr_warnings_add(warnings, NULL, 0, 0, "%s%s", given_text,
                         given == ORR_GIVEN_CARRIED_ON
                             ? "; it is carried on beyond its ends"
                             : ", more than a month from any value; what the orbits tell is used instead");

    pool p = {.options = options,
              .sky = about_reference ? reference.fit.sky : sky,
              .force = &force,
              .table = &table,
              .eop_known = report->eop_known || report->eop_estimated,
              .reference = about_reference ? reference.sat : NULL,
              .cancel = cancel};
    p.sat = calloc(table.n_sats + 1, sizeof *p.sat);
    p.report = calloc(table.n_sats + 1, sizeof *p.report);
    p.status = calloc(table.n_sats + 1, sizeof *p.status);
    p.arcs = calloc(table.n_sats + 1, sizeof *p.arcs);
    p.n_files = n_inputs;
    p.evidence = calloc(table.n_sats * n_inputs + 1, sizeof *p.evidence);
    orr_file_noise *file = calloc(n_inputs + 1, sizeof *file);
    orr_epoch_spread *times = calloc(n_inputs + 1, sizeof *times);
    bool *again = calloc(table.n_sats + 1, sizeof *again);
    if (s == ORR_OK && (p.sat == NULL || p.report == NULL || p.status == NULL || p.arcs == NULL ||
                        p.evidence == NULL || file == NULL || times == NULL || again == NULL))
        s = ORR_E_MEMORY;
    if (s == ORR_OK) s = describe_sources(input, n_inputs, options, &table, about_reference, out);
    if (s == ORR_OK)
        s = keep_rotation(options, &table, &reference.fit, about_reference, report, &out->rotation);
    if (s == ORR_E_MEMORY) orr_diag_set(diag, s, "out of memory for %zu satellites", table.n_sats);
    if (s == ORR_OK) {
        orr_parallel_run(options->jobs, worker, &p);
        s = know_files(&p, options->jobs, file, times, again);
        tell_files(input, n_inputs, file, times, warnings);
        if (s == ORR_OK) s = collect(&p, out, report, warnings, diag);
        for (size_t i = 0; i < table.n_sats; i++) orr_satellite_free(&p.sat[i]);
    }
    free(p.sat);
    free(p.report);
    free(p.status);
    free(p.arcs);
    free(p.evidence);
    free(file);
    free(times);
    free(again);
    orr_run_reference_free(&reference);
    orr_sky_free(sky);
    orr_nodes_free(&table);
    if (s != ORR_OK) orr_orbit_solution_free(out);
    return s;
}

void orr_orbit_solution_free(orr_orbit_solution *s)
{
    for (size_t i = 0; i < s->n_sats; i++) orr_satellite_free(&s->sat[i]);
    free(s->sat);
    free(s->source);
    free(s->clock_events.item);
    orr_earth_rotation_free(&s->rotation);
    *s = (orr_orbit_solution){0};
}

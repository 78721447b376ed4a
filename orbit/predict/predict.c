// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/predict/predict.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/parallel.h"
#include "core/robust.h"
#include "orbit/predict/predict_clock.h"
#include "orbit/predict/predict_path.h"
#include "orbit/predict/predict_sigma.h"
#include "orbit/smooth/events.h"

#define HISTORY_S (2 * 86400.0) // longer windows are worse: radiation pressure changes
#define FORGET_S 86400.0
#define NODE_STEP_S 900.0
#define GRAVITY_DEGREE 8    // more gains nothing, 4 loses metres
#define LATE_S (3 * 3600.0) // a satellite whose positions end so long before the others' has left
#define LEAST_NODES 6
#define FEW_RATIO 2.25     // fewer err by half as much again
#define LEAST_SATELLITES 4 // that tell the Earth's rotation well enough for others
#define LEAST_SPAN_S 7200.0
#define LOW_ORBIT_M 1.5e7 // below it drag is what matters
#define LEAST_JOINTS 3    // satellites that tell what a system steps from file to file

// One satellite's share.
typedef struct job {
    size_t sat;
    orr_reference_arc *arc;
    const uint16_t *source; // per node of the arc
    orr_status status;
    size_t before; // samples of its last arc that were there
    double joint_m;
} job;

typedef struct work {
    orr_orbit_solution *s;
    const orr_smoother_input *input;
    size_t n_inputs;
    const orr_predict_options *o;
    const volatile int *cancel;
    orr_predict_report *report;
    orr_time from, end; // of the nodes
    double border_s[3];
    size_t n_jobs;
    job *job;
    orr_reference_arc *arc;
    orr_reference_node *node;
    uint16_t *source;
    orr_gravity_field earth;
    orr_reference_fit fit;
    orr_event_list *events; // per job
    atomic_size_t next;
} work;

static double since(const work *w, orr_time t) { return orr_time_diff_s(t, w->from); }

static orr_time arc_end(const orr_orbit_arc *a)
{
    return a->t0 + (int64_t)(a->n - 1) * (int64_t)llround(a->step_s * 1e9);
}

static int by_time(const void *key, const void *element)
{
    const orr_time a = *(const orr_time *)key, b = *(const orr_time *)element;
    return (a > b) - (a < b);
}

// The record that a node came from; NULL if its file has none.
static const orr_sp3_record *record_of(const work *w, orr_sat sat, const orr_orbit_node *x)
{
    if (x->source >= w->n_inputs) return NULL;
    const orr_sp3 *f = w->input[x->source].sp3;
    const orr_time *epoch = bsearch(&x->t, f->epoch, f->n_epochs, sizeof *f->epoch, by_time);
    for (size_t k = 0; k < f->n_sats && epoch != NULL; k++)
        if (f->sat[k] == sat) return &f->record[(size_t)(epoch - f->epoch) * f->n_sats + k];
    return NULL;
}

// Whether a node is one to predict from: used, and observed. Its position.
static bool observed(const work *w, orr_sat sat, const orr_orbit_node *x, orr_vec3 *ecef_m)
{
    const orr_sp3_record *r = x->used ? record_of(w, sat, x) : NULL;
    if (r == NULL || (r->flags & ORR_SP3_ORBIT_PREDICTED) != 0) return false;
    *ecef_m = (orr_vec3){r->pos_m[0], r->pos_m[1], r->pos_m[2]};
    return true;
}

static orr_time last_observed(const work *w, const orr_orbit_sat *sat)
{
    orr_vec3 r;
    for (size_t i = sat->n_nodes; i-- > 0;)
        if (observed(w, sat->sat, &sat->node[i], &r)) return sat->node[i].t;
    return ORR_TIME_NONE;
}

// Nodes of a satellite's last arc, a quarter of an hour apart or more, counted back from the last. Returns how
// many there are.
static size_t take_nodes(const work *w, const orr_orbit_sat *sat, orr_reference_node *node, uint16_t *source)
{
    const orr_orbit_arc *a = &sat->arc[sat->n_arcs - 1];
    size_t n = 0;
    for (size_t i = sat->n_nodes; i-- > 0;) {
        const orr_orbit_node *x = &sat->node[i];
        const double t_s = since(w, x->t);
        if (x->t < a->t0 || t_s < 0) break;
        orr_vec3 ecef_m;
        if (x->t > arc_end(a) || !observed(w, sat->sat, x, &ecef_m)) continue;
        if (n > 0 && node[n - 1].t_s - t_s < NODE_STEP_S - 1) continue;
        node[n] = (orr_reference_node){t_s, ecef_m};
        source[n++] = x->source;
    }
    for (size_t i = 0, j = n; i + 1 < j--; i++) {
        const orr_reference_node swap = node[i];
        const uint16_t swap_source = source[i];
        node[i] = node[j];
        node[j] = swap;
        source[i] = source[j];
        source[j] = swap_source;
    }
    return n;
}

static bool wanted(const work *w, const orr_orbit_sat *sat)
{
    if (w->o->sats != NULL && !orr_sat_set_has(w->o->sats, sat->sat)) return false;
    const orr_time last = last_observed(w, sat);
    if (sat->n_arcs == 0 || last == ORR_TIME_NONE || orr_time_diff_s(w->end, last) > LATE_S) return false;
    const orr_orbit_arc *a = &sat->arc[sat->n_arcs - 1];
    return arc_end(a) == last && orr_vec3_norm(a->sample[a->n - 1].pos_m) > LOW_ORBIT_M;
}

static orr_status gather(work *w, orr_diag *diag)
{
    orr_orbit_solution *s = w->s;
    size_t n_nodes = 1;
    for (size_t i = 0; i < s->n_sats; i++) {
        const orr_time last = last_observed(w, &s->sat[i]);
        n_nodes += s->sat[i].n_nodes;
        if (last != ORR_TIME_NONE && (w->end == ORR_TIME_NONE || last > w->end)) w->end = last;
    }
    if (w->end == ORR_TIME_NONE)
        return orr_diag_set(diag, ORR_E_NODATA, "nothing to predict from: no position is observed");
    if (w->o->to <= w->end || orr_time_diff_s(w->o->to, w->end) > ORR_PREDICT_LONGEST_S) {
        char when[2][ORR_TIME_TEXT];
        return orr_diag_set(
            diag, ORR_E_ARG,
            "a prediction ends after the last position (%s), and at most %g days after it; not at %s",
            orr_time_text(w->end, when[0]), ORR_PREDICT_LONGEST_S / ORR_S_PER_DAY,
            orr_time_text(w->o->to, when[1]));
    }
    w->from = orr_time_add_s(w->end, -HISTORY_S);
    if (w->from < s->from) w->from = s->from;
    w->border_s[1] = since(w, w->end);
    w->border_s[2] = since(w, w->o->to);
    w->job = calloc(s->n_sats + 1, sizeof *w->job);
    w->arc = calloc(s->n_sats + 1, sizeof *w->arc);
    w->events = calloc(s->n_sats + 1, sizeof *w->events);
    w->node = malloc(n_nodes * sizeof *w->node);
    w->source = malloc(n_nodes * sizeof *w->source);
    if (w->job == NULL || w->arc == NULL || w->events == NULL || w->node == NULL || w->source == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for the prediction of %zu satellites",
                            s->n_sats);
    size_t at = 0;
    for (size_t i = 0; i < s->n_sats; i++) {
        if (!wanted(w, &s->sat[i])) continue;
        const size_t n = take_nodes(w, &s->sat[i], &w->node[at], &w->source[at]);
        if (n < LEAST_NODES || w->node[at + n - 1].t_s - w->node[at].t_s < LEAST_SPAN_S) continue;
        w->arc[w->n_jobs] = (orr_reference_arc){.sat = i, .window = 1, .n = n, .node = &w->node[at]};
        w->job[w->n_jobs] = (job){.sat = i, .arc = &w->arc[w->n_jobs], .source = &w->source[at]};
        w->n_jobs++;
        at += n;
    }
    return w->n_jobs > 0
               ? ORR_OK
               : orr_diag_set(diag, ORR_E_NODATA,
                              "nothing to predict from: no satellite has positions over two hours up to "
                              "the end of the files");
}

static orr_status fit(work *w, orr_diag *diag)
{
    bool known = false;
    if (w->o->eop != NULL) {
        bool begin, end;
        orr_eop_at(w->o->eop, w->from, NULL, &begin);
        orr_eop_at(w->o->eop, w->o->to, NULL, &end);
        known = begin && end;
    }
    const orr_reference_problem p = {.from = w->from,
                                     .to = w->o->to,
                                     .n_windows = 2,
                                     .border_s = w->border_s,
                                     .n_arcs = w->n_jobs,
                                     .arc = w->arc,
                                     .eop = known ? w->o->eop : NULL,
                                     .leap = w->o->leap,
                                     .hold = known,
                                     .forecast = true,
                                     .forget_s = FORGET_S,
                                     .gravity_degree = GRAVITY_DEGREE,
                                     .jobs = w->o->jobs,
                                     .cancel = w->cancel};
    orr_status s = orr_reference_fit_run(&p, &w->fit, diag);
    if (s == ORR_OK) s = orr_gravity_field_init(&w->earth, GRAVITY_DEGREE, false, diag);
    w->report->eop_known = known;
    w->report->eop_estimated = w->fit.estimated && !known && w->fit.fitted >= LEAST_SATELLITES;
    return s;
}

// --- satellite by satellite, by threads ---

static orr_status carry_on(work *w, orr_predict_room *room, job *j, orr_event_list *events)
{
    orr_orbit_sat *sat = &w->s->sat[j->sat];
    orr_orbit_arc *arc = &sat->arc[sat->n_arcs - 1];
    orr_predict_start start;
    const size_t before = arc->n;
    j->before = before;
    orr_status s = orr_predict_filter(room, j->arc, j->source, &start);
    j->joint_m = start.joint_m;
    if (s == ORR_OK) s = orr_predict_extend(room, j->arc, &start, w->border_s[2], arc);
    if (s != ORR_OK) return s;
    const orr_orbit_arc more = {.t0 = arc->t0 + (int64_t)(before - 1) * (int64_t)llround(arc->step_s * 1e9),
                                .step_s = arc->step_s,
                                .n = arc->n - before + 1,
                                .sample = &arc->sample[before - 1]};
    return orr_events_eclipses(w->fit.sky, &more, events);
}

static void *worker(void *arg)
{
    work *w = arg;
    orr_predict_room room;
    const orr_status ready = orr_predict_room_init(w->fit.sky, &w->earth, &room, NULL);
    for (size_t i; (i = atomic_fetch_add(&w->next, 1)) < w->n_jobs;) {
        job *j = &w->job[i];
        j->status = w->cancel != NULL && *w->cancel ? ORR_E_INTERRUPTED : ready;
        if (j->status == ORR_OK && j->arc->fitted) j->status = carry_on(w, &room, j, &w->events[i]);
    }
    if (ready == ORR_OK) orr_predict_room_free(&room);
    return NULL;
}

// --- sigma ---

static bool same_system(const work *w, const job *a, const job *b)
{
    return orr_sat_system(w->s->sat[a->sat].sat) == orr_sat_system(w->s->sat[b->sat].sat);
}

// Medians over the satellites of one system: of the fits' residuals, and of the steps between files (NAN: none).
static void usual_of(const work *w, const job *of, double *room, double *rms_m, double *joint_m)
{
    size_t n = 0;
    for (size_t i = 0; i < w->n_jobs; i++)
        if (w->job[i].arc->fitted && same_system(w, of, &w->job[i])) room[n++] = w->job[i].arc->rms_m;
    *rms_m = n > 0 ? orr_median(room, n) : (double)NAN;
    n = 0;
    for (size_t i = 0; i < w->n_jobs; i++)
        if (w->job[i].arc->fitted && same_system(w, of, &w->job[i]) && isfinite(w->job[i].joint_m))
            room[n++] = w->job[i].joint_m;
    *joint_m = n >= LEAST_JOINTS ? orr_median(room, n) : (double)NAN;
}

// In the shadow within the days that the orbit was fitted to or is predicted for.
static bool meets_shadow(const work *w, const orr_orbit_arc *arc)
{
    for (size_t i = arc->n; i-- > 0;) {
        if ((arc->sample[i].flags & ORR_EPH_ECLIPSE) != 0) return true;
        if (orr_time_add_s(arc->t0, (double)i * arc->step_s) < w->from) break;
    }
    return false;
}

static orr_status set_sigmas(work *w, orr_diag *diag)
{
    double *room = malloc((w->n_jobs + 1) * sizeof *room);
    if (room == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for sigmas");
    for (size_t i = 0; i < w->n_jobs; i++) {
        const job *j = &w->job[i];
        const orr_orbit_sat *sat = &w->s->sat[j->sat];
        const orr_orbit_arc *arc = &sat->arc[sat->n_arcs - 1];
        if (j->status != ORR_OK || !j->arc->fitted) continue;
        orr_predict_known k = {.sat = sat->sat,
                               .r_m = j->arc->r_m,
                               .v_mps = j->arc->v_mps,
                               .eclipses = meets_shadow(w, arc),
                               .history_s = j->arc->node[j->arc->n - 1].t_s - j->arc->node[0].t_s};
        double rms_m;
        usual_of(w, j, room, &rms_m, &k.joint_m);
        k.rms_ratio = j->arc->rms_m / rms_m;
        if (w->fit.fitted < LEAST_SATELLITES) k.rms_ratio = fmax(k.rms_ratio, FEW_RATIO);
        const orr_predict_growth g = orr_predict_growth_of(&k);
        for (size_t m = j->before; m < arc->n; m++) {
            orr_orbit_sample *x = &arc->sample[m];
            x->sigma_m = (float)hypot((double)x->sigma_m,
                                      orr_predict_sigma(&g, (double)(m + 1 - j->before) * arc->step_s));
        }
    }
    free(room);
    return ORR_OK;
}

// --- what is left ---

static orr_status add_events(orr_orbit_sat *sat, const orr_event_list *more)
{
    orr_event_list all = {.n = sat->n_events, .item = sat->event};
    orr_status s = ORR_OK;
    for (size_t i = 0; i < more->n && s == ORR_OK; i++) {
        const orr_orbit_event *e = &more->item[i];
        s = orr_event_add(&all, e->kind, e->t0, e->t1, e->value);
    }
    orr_events_sort(&all);
    sat->event = all.item;
    sat->n_events = all.n;
    return s;
}

// The rotation of the solution up to the last position, then that of the prediction, its UT1 (of which orbits
// tell the rate alone) moved to go on from there.
static orr_status join_rotation(work *w, orr_earth_rotation *r)
{
    const orr_eop_series *more = &w->fit.rotation;
    int32_t day;
    double fraction;
    orr_time_mjd(w->end, ORR_SCALE_UTC, NULL, &day, &fraction);
    const double end = day + fraction;
    size_t keep = 0;
    while (keep < r->series.n && r->series.mjd_utc[keep] < end) keep++;
    double *mjd = malloc((keep + more->n + 1) * sizeof *mjd);
    orr_eop *value = malloc((keep + more->n + 1) * sizeof *value);
    if (mjd == NULL || value == NULL) {
        free(mjd);
        free(value);
        return ORR_E_MEMORY;
    }
    double turn_s = 0;
    if (keep > 0) {
        memcpy(mjd, r->series.mjd_utc, keep * sizeof *mjd);
        memcpy(value, r->series.value, keep * sizeof *value);
        turn_s = orr_eop_at(&r->series, w->end, NULL, NULL).ut1_utc_s -
                 orr_eop_at(more, w->end, NULL, NULL).ut1_utc_s;
    }
    size_t n = keep;
    for (size_t i = 0; i < more->n; i++) {
        if (keep > 0 && more->mjd_utc[i] < end) continue;
        mjd[n] = more->mjd_utc[i];
        value[n] = more->value[i];
        value[n++].ut1_utc_s += turn_s;
    }
    orr_earth_rotation kept = *r;
    orr_earth_rotation_free(r);
    *r = (orr_earth_rotation){.source = w->report->eop_known ? kept.source : ORR_ROTATION_ESTIMATED,
                              .series = {n, mjd, value},
                              .pole_sigma_rad = w->fit.pole_sigma_rad,
                              .lod_sigma_s = w->fit.lod_sigma_s};
    return ORR_OK;
}

static void tell(work *w)
{
    char when[ORR_TIME_TEXT];
    const size_t used = strlen(w->s->options);
    snprintf(w->s->options + used, sizeof w->s->options - used,
             "; predicted from %s: ECOM fitted to at most %g days, weights falling by e in %g days",
             orr_time_text(w->end, when), HISTORY_S / ORR_S_PER_DAY, FORGET_S / ORR_S_PER_DAY);
    orr_predict_report *r = w->report;
    const orr_eop e = orr_eop_at(&w->fit.rotation, w->end, NULL, NULL);
    r->from = w->end;
    r->xp_rad = e.xp_rad;
    r->yp_rad = e.yp_rad;
    r->lod_s = e.lod_s;
    r->pole_sigma_rad = w->fit.pole_sigma_rad;
    r->lod_sigma_s = w->fit.lod_sigma_s;
}

// Satellites that were carried on, and a sentence about those that were not.
static orr_status collect(work *w, bool *predicted, orr_warnings *warnings, orr_diag *diag)
{
    char list[256] = "";
    for (size_t i = 0; i < w->n_jobs; i++) {
        job *j = &w->job[i];
        orr_status s = j->status;
        if (s == ORR_E_NUMERIC) continue;
        if (s == ORR_OK && j->arc->fitted) {
            s = add_events(&w->s->sat[j->sat], &w->events[i]);
            predicted[j->sat] = true;
            w->report->orbits++;
        }
        if (s != ORR_OK) return orr_diag_set(diag, s, "prediction: %s", orr_status_name(s));
    }
    for (size_t i = 0; i < w->s->n_sats; i++) {
        char name[ORR_SAT_TEXT];
        if (predicted[i] || (w->o->sats != NULL && !orr_sat_set_has(w->o->sats, w->s->sat[i].sat))) continue;
        w->report->left_out++;
        const size_t used = strlen(list);
        if (used + ORR_SAT_TEXT + 2 < sizeof list)
            snprintf(list + used, sizeof list - used, "%s%s", used > 0 ? " " : "",
                     orr_sat_text(w->s->sat[i].sat, name));
    }
    if (w->report->left_out > 0)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "not predicted, because their positions end before the others', agree with no orbit, or fly "
            "too low (%zu): %s",
            w->report->left_out, list);
    return w->report->orbits > 0
               ? ORR_OK
               : orr_diag_set(diag, ORR_E_NODATA, "no satellite has an orbit to be predicted from");
}

static void work_free(work *w)
{
    for (size_t i = 0; w->events != NULL && i < w->n_jobs; i++) free(w->events[i].item);
    free(w->events);
    free(w->job);
    free(w->arc);
    free(w->node);
    free(w->source);
    orr_reference_fit_free(&w->fit);
}

orr_status orr_predict(orr_orbit_solution *s, const orr_smoother_input *input, size_t n_inputs,
                       const orr_predict_options *o, const orr_log *log, const volatile int *cancel,
                       orr_predict_report *report, orr_warnings *warnings, orr_diag *diag)
{
    work w = {.s = s,
              .input = input,
              .n_inputs = n_inputs,
              .o = o,
              .cancel = cancel,
              .report = report,
              .end = ORR_TIME_NONE};
    *report = (orr_predict_report){0};
    bool *predicted = calloc(s->n_sats + 1, sizeof *predicted);
    orr_status status = predicted != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (status == ORR_OK) status = gather(&w, diag);
    if (status == ORR_OK) status = fit(&w, diag);
    if (status == ORR_OK) {
        ORR_LOG(log, ORR_LOG_INFO, "prediction: %zu orbits fitted, median residual %.1f mm", w.fit.fitted,
                1e3 * w.fit.rms_m);
        orr_parallel_run(o->jobs, worker, &w);
        status = set_sigmas(&w, diag);
    }
    if (status == ORR_OK) status = collect(&w, predicted, warnings, diag);
    if (status == ORR_OK) {
        tell(&w);
        status = orr_predict_clocks(s, predicted, w.end, o->to, &report->clocks, diag);
    }
    if (status == ORR_OK && (report->eop_known || report->eop_estimated)) {
        status = join_rotation(&w, &s->rotation);
        if (status != ORR_OK) orr_diag_set(diag, status, "out of memory for the Earth's rotation");
    }
    work_free(&w);
    free(predicted);
    return status;
}

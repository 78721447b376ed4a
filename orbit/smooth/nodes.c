// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/nodes.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/smooth/bridge.h"
#include "orbit/smooth/clock_check.h"
#include "orbit/smooth/solution.h"

#define CLOCK_GAP_STEPS 1.5 // clocks are interpolated between neighbours of the usual step only

void orr_nodes_free(orr_node_table *t)
{
    for (size_t i = 0; i < t->n_sats; i++) {
        free(t->list[i].node);
        free(t->list[i].clock);
    }
    free(t->list);
    *t = (orr_node_table){0};
}

static int by_sat(const void *a, const void *b)
{
    return (int)*(const orr_sat *)a - (int)*(const orr_sat *)b;
}

static int by_time_then_file(const void *a, const void *b)
{
    const orr_node *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    return (int)x->rank - (int)y->rank;
}

// Files in order of their first epochs, so that "later file" means what a reader expects whatever the order
// given.
static void order_of_files(const orr_smoother_input *input, size_t n, size_t *order)
{
    for (size_t i = 0; i < n; i++) {
        size_t k = i;
        while (k > 0 && input[order[k - 1]].sp3->epoch[0] > input[i].sp3->epoch[0]) {
            order[k] = order[k - 1];
            k--;
        }
        order[k] = i;
    }
}

// The same bytes given twice are no second opinion. Returns how many files are left.
static size_t pass_over_twins(const orr_smoother_input *input, size_t n, size_t *order,
                              orr_warnings *warnings)
{
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        const orr_smoother_input *x = &input[order[i]];
        size_t k = 0;
        while (k < kept && (x->sha256[0] == '\0' || strcmp(input[order[k]].sha256, x->sha256) != 0)) k++;
        if (k < kept)
            orr_warnings_add(warnings, x->name, 0, 0, "the same content as %s; used once",
                             input[order[k]].name);
        else
            order[kept++] = order[i];
    }
    return kept;
}

// The clock of a file's own time system, in ns since the GPS epoch's label: what decimation counts in.
static int64_t label_ns(orr_time t, orr_scale scale)
{
    orr_civil c;
    orr_time_to_civil(t, scale, NULL, &c);
    int64_t s = c.hour * INT64_C(3600) + c.minute * INT64_C(60) + c.second;
    orr_time day = orr_time_from_mjd(orr_mjd_from_date(c.year, c.month, c.day), 0.0, ORR_SCALE_GPS, NULL);
    return orr_time_add(day, s * ORR_NS_PER_S + c.ns);
}

static bool wanted_epoch(orr_time t, orr_scale scale, int64_t midnight, int64_t step_ns,
                         const orr_smoother_options *o)
{
    if (step_ns > 0 && orr_time_sub_ns(label_ns(t, scale), midnight) % step_ns != 0) return false;
    for (size_t i = 0; i < o->n_exclude; i++)
        if (orr_interval_holds(o->exclude[i], t)) return false;
    return true;
}

static orr_status gather_sat(const orr_smoother_input *input, const size_t *order, size_t n_inputs,
                             const orr_smoother_options *o, int64_t midnight, orr_node_list *list)
{
    const int64_t step_ns = (int64_t)llround(o->node_step_s * 1e9);
    size_t room = 0;
    for (size_t f = 0; f < n_inputs; f++) room += input[f].sp3->n_epochs;
    list->node = calloc(room, sizeof *list->node);
    list->clock = calloc(room, sizeof *list->clock);
    if (list->node == NULL || list->clock == NULL) return ORR_E_MEMORY;
    for (size_t k = 0; k < n_inputs; k++) {
        const orr_sp3 *sp3 = input[order[k]].sp3;
        size_t s = 0;
        while (s < sp3->n_sats && sp3->sat[s] != list->sat) s++;
        if (s == sp3->n_sats) continue;
        for (size_t e = 0; e < sp3->n_epochs; e++) {
            const orr_sp3_record *r = &sp3->record[e * sp3->n_sats + s];
            if (!wanted_epoch(sp3->epoch[e], sp3->scale, midnight, step_ns, o)) continue;
            if (isfinite(r->pos_m[0]) && isfinite(r->pos_m[1]) && isfinite(r->pos_m[2])) {
                bool predicted = (r->flags & ORR_SP3_ORBIT_PREDICTED) != 0;
                list->node[list->n_nodes++] = (orr_node){
                    .t = sp3->epoch[e],
                    .ecef_m = {r->pos_m[0], r->pos_m[1], r->pos_m[2]},
                    .sigma_m = predicted ? o->sigma_predicted_m : o->sigma_m,
                    .predicted = predicted,
                    .manoeuvre = (r->flags & ORR_SP3_MANOEUVRE) != 0,
                    .source = (uint16_t)order[k],
                    .rank = (uint16_t)k,
                };
            }
            if (isfinite(r->clock_s)) {
                uint32_t flags = 0;
                if (r->flags & ORR_SP3_CLOCK_EVENT) flags |= ORR_EPH_CLOCK_EVENT;
                if (r->flags & ORR_SP3_CLOCK_PREDICTED) flags |= ORR_EPH_PREDICTED;
                list->clock[list->n_clocks++] = (orr_clock_node){
                    .t = sp3->epoch[e], .clock_s = r->clock_s, .flags = flags, .source = (uint16_t)k};
            }
        }
    }
    qsort(list->node, list->n_nodes, sizeof *list->node, by_time_then_file);
    return ORR_OK;
}

// Clocks of files that overlap: an observed value beats a predicted one at the same instant, a later file an
// earlier one; only at the very joint (one file's last, the next one's first epoch) both stay, left and right
// of a jump.
static void order_clocks(orr_node_list *list)
{
    for (size_t i = 1; i < list->n_clocks; i++) // files come in order: nearly sorted, and stable
        for (size_t k = i; k > 0 && list->clock[k - 1].t > list->clock[k].t; k--) {
            orr_clock_node swap = list->clock[k];
            list->clock[k] = list->clock[k - 1];
            list->clock[k - 1] = swap;
        }
    size_t n = 0;
    for (size_t i = 0; i < list->n_clocks; i++) {
        orr_clock_node c = list->clock[i];
        bool again = n > 0 && list->clock[n - 1].t == c.t;
        if (!again) {
            list->clock[n++] = c;
            continue;
        }
        bool old_predicted = (list->clock[n - 1].flags & ORR_EPH_PREDICTED) != 0;
        bool new_predicted = (c.flags & ORR_EPH_PREDICTED) != 0;
        if (new_predicted && !old_predicted) continue;
        bool overlap = (n >= 2 && list->clock[n - 2].t == c.t) || (old_predicted && !new_predicted);
        if (overlap)
            list->clock[n - 1] = c;
        else
            list->clock[n++] = c;
    }
    list->n_clocks = n;
}

// Same instant from several files: what one observed, another's prediction must not pull at. Counts the
// positions of instants that overlap; where files merely join (one shared instant alone) there is nothing to
// tell here.
static size_t supersede_predictions(orr_node_list *list, double *largest_m)
{
    size_t overlapping = 0, run = 0;
    double largest_of_run = 0;
    for (size_t i = 0; i < list->n_nodes;) {
        size_t j = i + 1;
        bool observed = !list->node[i].predicted;
        for (; j < list->n_nodes && list->node[j].t == list->node[i].t; j++) {
            observed = observed || !list->node[j].predicted;
            double d = orr_vec3_norm(orr_vec3_sub(list->node[j].ecef_m, list->node[i].ecef_m));
            largest_of_run = fmax(largest_of_run, d);
        }
        for (size_t k = i; k < j; k++) list->node[k].superseded = observed && list->node[k].predicted;
        if (j - i > 1) {
            run++;
        } else {
            run = 0;
            largest_of_run = 0;
        }
        if (run >= 2) {
            overlapping += run == 2 ? 2 : 1;
            *largest_m = fmax(*largest_m, largest_of_run);
        }
        i = j;
    }
    return overlapping;
}

static double median_step(const orr_node_table *table, bool clocks)
{
    size_t room = 1, n = 0;
    for (size_t i = 0; i < table->n_sats; i++)
        room += clocks ? table->list[i].n_clocks : table->list[i].n_nodes;
    double *step = malloc(room * sizeof *step);
    if (step == NULL) return 0;
    for (size_t i = 0; i < table->n_sats; i++) {
        const orr_node_list *l = &table->list[i];
        size_t count = clocks ? l->n_clocks : l->n_nodes;
        for (size_t k = 1; k < count; k++) {
            double d = clocks ? orr_time_diff_s(l->clock[k].t, l->clock[k - 1].t)
                              : orr_time_diff_s(l->node[k].t, l->node[k - 1].t);
            if (d > 0) step[n++] = d;
        }
    }
    double median = n > 0 ? orr_upper_median(step, n) : 0;
    free(step);
    return median;
}

// The usual distance of a file's positions (or clocks): the median over its satellites; 0 where it has no
// two.
static double step_of_file(const orr_sp3 *sp3, const orr_smoother_options *o, int64_t midnight, bool clocks)
{
    const int64_t step_ns = (int64_t)llround(o->node_step_s * 1e9);
    double *step = malloc((sp3->n_sats * sp3->n_epochs + 1) * sizeof *step);
    size_t n = 0;
    if (step == NULL) return 0;
    for (size_t s = 0; s < sp3->n_sats; s++) {
        if (o->sats != NULL && !orr_sat_set_has(o->sats, sp3->sat[s])) continue;
        orr_time before = ORR_TIME_NONE;
        for (size_t e = 0; e < sp3->n_epochs; e++) {
            const orr_sp3_record *r = &sp3->record[e * sp3->n_sats + s];
            if (!isfinite(clocks ? r->clock_s : r->pos_m[0])) continue;
            if (!wanted_epoch(sp3->epoch[e], sp3->scale, midnight, step_ns, o)) continue;
            if (before != ORR_TIME_NONE) step[n++] = orr_time_diff_s(sp3->epoch[e], before);
            before = sp3->epoch[e];
        }
    }
    const double median = n > 0 ? orr_upper_median(step, n) : 0;
    free(step);
    return median;
}

// Of files with different steps the longest one: a quarter of an hour is no gap in a file of quarter hours
// because the file of the day before had five minutes.
static double usual_step(const orr_smoother_input *input, const size_t *order, size_t n,
                         const orr_smoother_options *o, int64_t midnight, const orr_node_table *table,
                         bool clocks)
{
    double longest = 0;
    for (size_t k = 0; k < n; k++)
        longest = fmax(longest, step_of_file(input[order[k]].sp3, o, midnight, clocks));
    return longest > 0 ? longest : median_step(table, clocks); // files of one epoch each
}

static orr_status union_of_sats(const orr_smoother_input *input, size_t n_inputs,
                                const orr_smoother_options *o, orr_sat **out, size_t *n_out)
{
    size_t room = 0, n = 0, kept = 0;
    for (size_t f = 0; f < n_inputs; f++) room += input[f].sp3->n_sats;
    orr_sat *sat = malloc((room + 1) * sizeof *sat);
    if (sat == NULL) return ORR_E_MEMORY;
    for (size_t f = 0; f < n_inputs; f++)
        for (size_t s = 0; s < input[f].sp3->n_sats; s++)
            if (o->sats == NULL || orr_sat_set_has(o->sats, input[f].sp3->sat[s]))
                sat[n++] = input[f].sp3->sat[s];
    qsort(sat, n, sizeof *sat, by_sat);
    for (size_t i = 0; i < n; i++)
        if (kept == 0 || sat[kept - 1] != sat[i]) sat[kept++] = sat[i];
    *out = sat;
    *n_out = kept;
    return ORR_OK;
}

static orr_status bridge_all(const orr_smoother_options *o, orr_node_table *t, orr_warnings *warnings,
                             orr_diag *diag)
{
    const orr_time asked = o->extend_to;
    char when[ORR_TIME_TEXT], name[ORR_SAT_TEXT] = "";
    size_t n_short = 0;
    if (asked != ORR_TIME_NONE && asked <= t->to)
        orr_warnings_add(warnings, NULL, 0, 0, "nothing to extend: the positions reach to %s",
                         orr_time_text(t->to, when));
    for (size_t i = 0; i < t->n_sats; i++) {
        orr_node_list *l = &t->list[i];
        if (orr_bridge_nodes(o->nav, t->from, t->step_s, asked, l) != ORR_OK) {
            orr_nodes_free(t);
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for the nodes of the bridge");
        }
        if (l->n_nodes == 0) continue;
        const orr_time end = l->node[l->n_nodes - 1].t;
        if (end > t->to) t->to = end;
        if (asked != ORR_TIME_NONE && orr_time_diff_s(asked, end) > t->step_s && n_short++ == 0)
            orr_sat_text(l->sat, name);
    }
    if (n_short > 0)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "satellites that end earlier than asked, for want of broadcast ephemerides: %zu (%s the first); "
            "the product reaches to %s",
            n_short, name, orr_time_text(t->to, when));
    return ORR_OK;
}

orr_status orr_nodes_collect(const orr_smoother_input *input, size_t n_inputs, const orr_smoother_options *o,
                             orr_node_table *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_node_table){0};
    if (n_inputs == 0 || n_inputs > UINT16_MAX)
        return orr_diag_set(diag, ORR_E_ARG, "%zu input files; 1 to %d can be smoothed jointly", n_inputs,
                            UINT16_MAX);
    for (size_t f = 0; f < n_inputs; f++)
        if (input[f].sp3->n_epochs == 0)
            return orr_diag_set(diag, ORR_E_NODATA, "%s has no epochs", input[f].name);
    size_t *order = malloc(n_inputs * sizeof *order), n_sats = 0;
    orr_sat *sat = NULL;
    if (order == NULL || union_of_sats(input, n_inputs, o, &sat, &n_sats) != ORR_OK) goto memory;
    order_of_files(input, n_inputs, order);
    n_inputs = pass_over_twins(input, n_inputs, order, warnings);
    const int64_t day = ORR_S_PER_DAY * ORR_NS_PER_S;
    int64_t midnight = label_ns(input[order[0]].sp3->epoch[0], input[order[0]].sp3->scale);
    midnight = orr_time_add(midnight, -orr_floor_mod(midnight, day));

    out->list = calloc(n_sats + 1, sizeof *out->list);
    if (out->list == NULL) goto memory;
    double largest_m = 0;
    size_t same = 0;
    out->from = INT64_MAX;
    out->to = INT64_MIN;
    for (size_t i = 0; i < n_sats; i++) {
        orr_node_list *l = &out->list[out->n_sats++];
        l->sat = sat[i];
        if (gather_sat(input, order, n_inputs, o, midnight, l) != ORR_OK) goto memory;
        order_clocks(l);
        same += supersede_predictions(l, &largest_m);
        if (l->n_nodes == 0) continue;
        if (l->node[0].t < out->from) out->from = l->node[0].t;
        if (l->node[l->n_nodes - 1].t > out->to) out->to = l->node[l->n_nodes - 1].t;
    }
    out->step_s = usual_step(input, order, n_inputs, o, midnight, out, false);
    out->clock_step_s = usual_step(input, order, n_inputs, o, midnight, out, true);
    free(order);
    free(sat);
    if (out->to < out->from) {
        orr_nodes_free(out);
        return orr_diag_set(diag, ORR_E_NODATA, "no satellite position is left to smooth%s",
                            n_sats == 0                              ? ": no file has any of the satellites"
                            : o->n_exclude > 0 || o->node_step_s > 0 ? " after decimation and exclusion"
                                                                     : "");
    }
    for (size_t i = 0; i < out->n_sats; i++)
        for (size_t k = 0; k < out->list[i].n_nodes; k++)
            out->list[i].node[k].t_s = orr_time_diff_s(out->list[i].node[k].t, out->from);
    if (same > 0)
        orr_warnings_add(warnings, NULL, 0, 0,
                         "files overlap: %zu positions are given twice, apart by up to %.3f m; both are used "
                         "with equal weight, but an "
                         "observed one supersedes a predicted one",
                         same, largest_m);
    out->clock_max_gap_s = CLOCK_GAP_STEPS * out->clock_step_s;
    for (size_t i = 0; i < out->n_sats && o->detect; i++)
        if (orr_clock_check(&out->list[i], out->clock_max_gap_s, warnings) != ORR_OK) {
            orr_nodes_free(out);
            return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for the clocks");
        }
    return o->bridge ? bridge_all(o, out, warnings, diag) : ORR_OK;
memory:
    free(order);
    free(sat);
    orr_nodes_free(out);
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for the nodes");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/nodes.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/smooth/bridge.h"
#include "orbit/smooth/clock_gather.h"
#include "orbit/smooth/epoch.h"
#include "orbit/smooth/solution.h"

void orr_nodes_free(orr_node_table *t)
{
    for (size_t i = 0; i < t->n_sats; i++) {
        free(t->list[i].node);
        free(t->list[i].clock);
    }
    free(t->list);
    free(t->clock_events.item);
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

static bool comes_after(const orr_smoother_input *a, const orr_smoother_input *b)
{
    const orr_time x[2] = {a->sp3->epoch[0], a->sp3->epoch[a->sp3->n_epochs - 1]},
                   y[2] = {b->sp3->epoch[0], b->sp3->epoch[b->sp3->n_epochs - 1]};
    for (int k = 0; k < 2; k++)
        if (x[k] != y[k]) return x[k] > y[k];
    const int by_name = strcmp(a->name, b->name);
    return by_name != 0 ? by_name > 0 : strcmp(a->sha256, b->sha256) > 0;
}

// Files in order of their first epochs, so that "later file" means what a reader expects whatever the order
// given.
static void order_of_files(const orr_smoother_input *input, size_t n, size_t *order)
{
    for (size_t i = 0; i < n; i++) {
        size_t k = i;
        while (k > 0 && comes_after(&input[order[k - 1]], &input[i])) {
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

static orr_status gather_sat(const orr_smoother_input *input, const size_t *order, size_t n_inputs,
                             const orr_smoother_options *o, int64_t midnight, orr_node_list *list)
{
    size_t room = 0;
    for (size_t f = 0; f < n_inputs; f++) room += input[f].sp3->n_epochs;
    list->node = calloc(room, sizeof *list->node);
    if (list->node == NULL) return ORR_E_MEMORY;
    for (size_t k = 0; k < n_inputs; k++) {
        const orr_sp3 *sp3 = input[order[k]].sp3;
        size_t s = 0;
        while (s < sp3->n_sats && sp3->sat[s] != list->sat) s++;
        if (s == sp3->n_sats) continue;
        for (size_t e = 0; e < sp3->n_epochs; e++) {
            const orr_sp3_record *r = &sp3->record[e * sp3->n_sats + s];
            if (!orr_epoch_wanted(sp3->epoch[e], sp3->scale, midnight, o)) continue;
            const bool predicted = (r->flags & ORR_SP3_ORBIT_PREDICTED) != 0;
            if (o->observed_only && predicted) continue;
            if (isfinite(r->pos_m[0]) && isfinite(r->pos_m[1]) && isfinite(r->pos_m[2])) {
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
        }
    }
    qsort(list->node, list->n_nodes, sizeof *list->node, by_time_then_file);
    return ORR_OK;
}

// Until when each file observed: what a prediction rests on. [n_inputs], by the file's index.
static void observed_until(const orr_smoother_input *input, size_t n, const size_t *order, orr_time *until)
{
    for (size_t k = 0; k < n; k++) {
        const orr_sp3 *sp3 = input[order[k]].sp3;
        orr_time *last = &until[order[k]];
        *last = sp3->epoch[0];
        for (size_t i = 0; i < sp3->n_epochs * sp3->n_sats; i++)
            if (isfinite(sp3->record[i].pos_m[0]) && (sp3->record[i].flags & ORR_SP3_ORBIT_PREDICTED) == 0)
                *last = sp3->epoch[i / sp3->n_sats];
    }
}

// Whether, going from node i in one direction, a file that says it better comes within reach: one that observed, or
// one whose prediction rests on later observations. Returns that file's index + 1; 0: none.
static size_t better_beside(const orr_node_list *l, size_t i, int direction, double reach_s,
                            const orr_time *until, size_t wanted)
{
    const orr_node *own = &l->node[i];
    size_t k = i;
    while (k > 0 && direction > 0 && l->node[k - 1].t == own->t) k--;
    while (k + 1 < l->n_nodes && direction < 0 && l->node[k + 1].t == own->t) k++;
    for (; k < l->n_nodes && fabs(orr_time_diff_s(l->node[k].t, own->t)) <= reach_s;
         k += direction > 0 ? 1 : SIZE_MAX) {
        const orr_node *x = &l->node[k];
        if (x->source == own->source || (wanted != 0 && (size_t)x->source + 1 != wanted)) continue;
        const bool fresher = until[x->source] != until[own->source] ? until[x->source] > until[own->source]
                                                                    : x->rank > own->rank;
        if (!x->predicted || fresher) return (size_t)x->source + 1;
    }
    return 0;
}

// What one file observed, another's prediction must not pull at, and of two predictions the one that rests on later
// observations holds.
static void supersede_predictions(orr_node_list *l, double step_s, const orr_time *until)
{
    for (size_t i = 0; i < l->n_nodes; i++) {
        if (!l->node[i].predicted) continue;
        const size_t before = better_beside(l, i, -1, step_s, until, 0);
        l->node[i].superseded = before != 0 && better_beside(l, i, +1, step_s, until, before) != 0;
    }
}

// Positions of instants that files share and that all count; where files merely join (one shared instant alone) there
// is nothing to tell.
static size_t count_overlaps(const orr_node_list *l, double *largest_m)
{
    size_t overlapping = 0, run = 0;
    double largest_of_run = 0;
    for (size_t i = 0; i < l->n_nodes;) {
        size_t j = i, used = 0, first = i;
        for (; j < l->n_nodes && l->node[j].t == l->node[i].t; j++) {
            if (l->node[j].superseded) continue;
            if (used++ == 0) first = j;
            largest_of_run =
                fmax(largest_of_run, orr_vec3_norm(orr_vec3_sub(l->node[j].ecef_m, l->node[first].ecef_m)));
        }
        if (used > 1) {
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

static orr_status settle_overlaps(const orr_smoother_input *input, size_t n, size_t n_all,
                                  const size_t *order, orr_node_table *t, orr_warnings *warnings)
{
    orr_time *until = calloc(n_all + 1, sizeof *until);
    if (until == NULL) return ORR_E_MEMORY;
    observed_until(input, n, order, until);
    double largest_m = 0;
    size_t same = 0;
    for (size_t i = 0; i < t->n_sats; i++) {
        supersede_predictions(&t->list[i], t->step_s, until);
        same += count_overlaps(&t->list[i], &largest_m);
    }
    free(until);
    if (same > 0)
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "files overlap: %zu observed positions are given twice, apart by up to %.3f m; both are used "
            "with equal weight",
            same, largest_m);
    return ORR_OK;
}

// Predictions taken as input, and frames that are not one.
static void tell_kinds(const orr_smoother_input *input, size_t n, const size_t *order, bool observed_only,
                       orr_warnings *warnings)
{
    const orr_smoother_input *first = &input[order[0]];
    for (size_t k = 0; k < n; k++) {
        const orr_smoother_input *x = &input[order[k]];
        size_t all = 0, predicted = 0;
        for (size_t i = 0; i < x->sp3->n_epochs * x->sp3->n_sats; i++) {
            if (!isfinite(x->sp3->record[i].pos_m[0])) continue;
            all++;
            predicted += (x->sp3->record[i].flags & ORR_SP3_ORBIT_PREDICTED) != 0;
        }
        if (predicted > 0)
            orr_warnings_add(warnings, x->name, 0, 0,
                             "%zu of %zu positions are the centre's predictions (flag P); %s", predicted, all,
                             observed_only
                                 ? "they are not used, the prediction is made from what was observed"
                                 : "they are followed less closely, and the product flags them as "
                                   "predicted");
        const char *frame = x->sp3->coordinates, *other = first->sp3->coordinates;
        if (frame[0] != '\0' && other[0] != '\0' && strncmp(frame, other, 5) != 0)
            orr_warnings_add(warnings, x->name, 0, 0,
                             "its positions are in %s, those of %s in %s; they are taken together as they "
                             "are, though such "
                             "frames differ by millimetres to centimetres",
                             frame, first->name, other);
    }
}

static double median_step(const orr_node_table *table)
{
    size_t room = 1, n = 0;
    for (size_t i = 0; i < table->n_sats; i++) room += table->list[i].n_nodes;
    double *step = malloc(room * sizeof *step);
    if (step == NULL) return 0;
    for (size_t i = 0; i < table->n_sats; i++) {
        const orr_node_list *l = &table->list[i];
        for (size_t k = 1; k < l->n_nodes; k++) {
            double d = orr_time_diff_s(l->node[k].t, l->node[k - 1].t);
            if (d > 0) step[n++] = d;
        }
    }
    double median = n > 0 ? orr_upper_median(step, n) : 0;
    free(step);
    return median;
}

// The usual distance of a file's positions: the median over its satellites; 0 where it has no two.
static double step_of_file(const orr_sp3 *sp3, const orr_smoother_options *o, int64_t midnight)
{
    double *step = malloc((sp3->n_sats * sp3->n_epochs + 1) * sizeof *step);
    size_t n = 0;
    if (step == NULL) return 0;
    for (size_t s = 0; s < sp3->n_sats; s++) {
        if (o->sats != NULL && !orr_sat_set_has(o->sats, sp3->sat[s])) continue;
        orr_time before = ORR_TIME_NONE;
        for (size_t e = 0; e < sp3->n_epochs; e++) {
            const orr_sp3_record *r = &sp3->record[e * sp3->n_sats + s];
            if (!isfinite(r->pos_m[0])) continue;
            if (!orr_epoch_wanted(sp3->epoch[e], sp3->scale, midnight, o)) continue;
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
                         const orr_smoother_options *o, int64_t midnight, const orr_node_table *table)
{
    double longest = 0;
    for (size_t k = 0; k < n; k++) longest = fmax(longest, step_of_file(input[order[k]].sp3, o, midnight));
    return longest > 0 ? longest : median_step(table); // files of one epoch each
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
    const size_t n_all = n_inputs;
    n_inputs = pass_over_twins(input, n_inputs, order, warnings);
    const int64_t day = ORR_S_PER_DAY * ORR_NS_PER_S;
    int64_t midnight = orr_epoch_label_ns(input[order[0]].sp3->epoch[0], input[order[0]].sp3->scale);
    midnight = orr_time_add(midnight, -orr_floor_mod(midnight, day));

    out->list = calloc(n_sats + 1, sizeof *out->list);
    if (out->list == NULL) goto memory;
    out->from = INT64_MAX;
    out->to = INT64_MIN;
    for (size_t i = 0; i < n_sats; i++) {
        orr_node_list *l = &out->list[out->n_sats++];
        l->sat = sat[i];
        if (gather_sat(input, order, n_inputs, o, midnight, l) != ORR_OK) goto memory;
        if (l->n_nodes == 0) continue;
        if (l->node[0].t < out->from) out->from = l->node[0].t;
        if (l->node[l->n_nodes - 1].t > out->to) out->to = l->node[l->n_nodes - 1].t;
    }
    out->step_s = usual_step(input, order, n_inputs, o, midnight, out);
    free(sat);
    sat = NULL;
    if (out->to < out->from) {
        free(order);
        orr_nodes_free(out);
        return orr_diag_set(diag, ORR_E_NODATA, "no satellite position is left to smooth%s",
                            n_sats == 0                              ? ": no file has any of the satellites"
                            : o->n_exclude > 0 || o->node_step_s > 0 ? " after decimation and exclusion"
                            : o->observed_only
                                ? ": the files flag all as predicted, and from predictions none "
                                  "is made (without --predict and --now they are smoothed as they "
                                  "are, flagged)"
                                : "");
    }
    for (size_t i = 0; i < out->n_sats; i++)
        for (size_t k = 0; k < out->list[i].n_nodes; k++)
            out->list[i].node[k].t_s = orr_time_diff_s(out->list[i].node[k].t, out->from);
    if (settle_overlaps(input, n_inputs, n_all, order, out, warnings) != ORR_OK) goto memory;
    tell_kinds(input, n_inputs, order, o->observed_only, warnings);
    if (orr_clocks_gather(input, n_inputs, order, o, midnight, out, warnings) != ORR_OK) goto memory;
    free(order);
    return o->bridge ? bridge_all(o, out, warnings, diag) : ORR_OK;
memory:
    free(order);
    free(sat);
    orr_nodes_free(out);
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for the nodes");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/clock_gather.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/clock/clock_between.h"
#include "orbit/clock/clock_judge.h"
#include "orbit/clock/clock_predict.h"
#include "orbit/smooth/epoch.h"
#include "orbit/smooth/solution.h"

#define GAP_STEPS 1.5 // clocks are interpolated between neighbours of the usual step
enum { TOLD = 12 };   // single events in words; the product has all

static orr_status add_list(orr_clock_table *t, orr_sat sat, size_t room)
{
    orr_clock_list *l = &t->list[t->n++];
    *l = (orr_clock_list){.sat = sat, .node = malloc((room + 1) * sizeof *l->node)};
    return l->node != NULL ? ORR_OK : ORR_E_MEMORY;
}

// The usual distance of clocks: the median over neighbours of all satellites.
static double usual_step(const orr_clock_table *t)
{
    size_t room = 1, n = 0;
    for (size_t i = 0; i < t->n; i++) room += t->list[i].n;
    double *step = malloc(room * sizeof *step);
    if (step == NULL) return 0;
    for (size_t i = 0; i < t->n; i++)
        for (size_t k = 1; k < t->list[i].n; k++)
            step[n++] = orr_time_diff_s(t->list[i].node[k].t, t->list[i].node[k - 1].t);
    const double median = n > 0 ? orr_upper_median(step, n) : 0;
    free(step);
    return median;
}

static void note_span(orr_clock_source *s)
{
    s->first = INT64_MAX;
    s->observed = INT64_MIN;
    for (size_t i = 0; i < s->table.n; i++)
        for (size_t k = 0; k < s->table.list[i].n; k++) {
            const orr_clock_node *c = &s->table.list[i].node[k];
            if (c->t < s->first) s->first = c->t;
            if ((c->flags & ORR_EPH_PREDICTED) == 0 && c->t > s->observed) s->observed = c->t;
        }
    if (s->observed < s->first) s->observed = s->first;
    s->step_s = usual_step(&s->table);
}

static orr_status of_sp3(const orr_smoother_input *in, const orr_smoother_options *o, int64_t midnight,
                         const orr_node_table *table, orr_clock_source *out)
{
    const orr_sp3 *sp3 = in->sp3;
    *out = (orr_clock_source){.name = in->name};
    out->table.list = calloc(table->n_sats + 1, sizeof *out->table.list);
    if (out->table.list == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < table->n_sats; i++) {
        size_t s = 0;
        while (s < sp3->n_sats && sp3->sat[s] != table->list[i].sat) s++;
        if (s == sp3->n_sats) continue;
        if (add_list(&out->table, sp3->sat[s], sp3->n_epochs) != ORR_OK) return ORR_E_MEMORY;
        orr_clock_list *l = &out->table.list[out->table.n - 1];
        for (size_t e = 0; e < sp3->n_epochs; e++) {
            const orr_sp3_record *r = &sp3->record[e * sp3->n_sats + s];
            if (!isfinite(r->clock_s) || !orr_epoch_wanted(sp3->epoch[e], sp3->scale, midnight, o)) continue;
            if (o->observed_only && (r->flags & ORR_SP3_CLOCK_PREDICTED) != 0) continue;
            uint32_t flags = 0;
            if (r->flags & ORR_SP3_CLOCK_EVENT) flags |= ORR_EPH_CLOCK_EVENT;
            if (r->flags & ORR_SP3_CLOCK_PREDICTED) flags |= ORR_EPH_PREDICTED;
            l->node[l->n++] = (orr_clock_node){.t = sp3->epoch[e], .clock_s = r->clock_s, .flags = flags};
        }
    }
    note_span(out);
    return ORR_OK;
}

static bool excluded(const orr_smoother_options *o, orr_time t)
{
    for (size_t i = 0; i < o->n_exclude; i++)
        if (orr_interval_holds(o->exclude[i], t)) return true;
    return false;
}

// Within the positions' span.
static orr_status of_clk(const orr_smoother_clk *in, const orr_smoother_options *o,
                         const orr_node_table *table, orr_clock_source *out)
{
    *out = (orr_clock_source){.name = in->name};
    out->table.list = calloc(table->n_sats + 1, sizeof *out->table.list);
    if (out->table.list == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < table->n_sats; i++) {
        const orr_clk_series *c = orr_clk_find(in->clk, table->list[i].sat);
        if (c == NULL) continue;
        if (add_list(&out->table, c->sat, c->n) != ORR_OK) return ORR_E_MEMORY;
        orr_clock_list *l = &out->table.list[out->table.n - 1];
        for (size_t k = 0; k < c->n; k++) {
            const orr_clk_record *r = &c->record[k];
            if (r->t < table->from || r->t > table->to || excluded(o, r->t) || !isfinite(r->bias_s)) continue;
            l->node[l->n++] = (orr_clock_node){.t = r->t, .clock_s = r->bias_s};
        }
    }
    note_span(out);
    return ORR_OK;
}

typedef struct sources {
    orr_clock_source *item;
    size_t n;
    double longest_step_s;
} sources;

static void sources_free(sources *s)
{
    for (size_t i = 0; i < s->n; i++) orr_clock_table_free(&s->item[i].table);
    free(s->item);
    *s = (sources){0};
}

static orr_status read_sp3s(const orr_smoother_input *input, size_t n, const size_t *order,
                            const orr_smoother_options *o, int64_t midnight, const orr_node_table *table,
                            sources *out)
{
    out->item = calloc(n + 1, sizeof *out->item);
    orr_status s = out->item != NULL ? ORR_OK : ORR_E_MEMORY;
    for (size_t k = 0; k < n && s == ORR_OK; k++) {
        s = of_sp3(&input[order[k]], o, midnight, table, &out->item[out->n++]);
        out->longest_step_s = fmax(out->longest_step_s, out->item[k].step_s);
    }
    return s;
}

static orr_status read_clks(const orr_smoother_options *o, const orr_node_table *table, sources *out,
                            orr_warnings *warnings)
{
    out->item = calloc(o->n_clk + 1, sizeof *out->item);
    orr_status s = out->item != NULL ? ORR_OK : ORR_E_MEMORY;
    for (size_t k = 0; k < o->n_clk && s == ORR_OK; k++) {
        orr_clock_source *x = &out->item[out->n++];
        s = of_clk(&o->clk[k], o, table, x);
        if (s == ORR_OK && x->observed < x->first)
            orr_warnings_add(warnings, x->name, 0, 0,
                             "has no clock of these satellites within the span of the positions; not used");
        out->longest_step_s = fmax(out->longest_step_s, x->step_s);
    }
    return s;
}

static void tell_event(const orr_clock_event *e, orr_warnings *warnings)
{
    char sat[ORR_SAT_TEXT], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    orr_time_text(e->t0, from);
    orr_time_text(e->t1, to);
    switch (e->kind) {
    case ORR_CLOCK_EVENT_WRONG:
        orr_warnings_add(warnings, NULL, 0, 0,
                         "%s: the clock of %s is off the line of its neighbours by %.3g us and is left out",
                         orr_sat_text(e->sat, sat), from, e->value_s * 1e6);
        break;
    case ORR_CLOCK_EVENT_JUMP:
        orr_warnings_add(warnings, NULL, 0, 0,
                         "%s: the clock jumps by about %.3g us between %s and %s; there is none between them",
                         orr_sat_text(e->sat, sat), e->value_s * 1e6, from, to);
        break;
    case ORR_CLOCK_EVENT_REFERENCE:
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "the clocks of all satellites (%s) change by %.4g ns together between %s and %s: the reference "
            "clock's doing",
            e->systems, e->value_s * 1e9, from, to);
        break;
    case ORR_CLOCK_EVENT_FLAG:
        break;
    }
}

// The reference's first, then as many of single satellites as a reader can take in.
static void tell_events(const orr_clock_events *events, orr_warnings *warnings)
{
    size_t told = 0;
    for (int single = 0; single < 2; single++)
        for (size_t i = 0; i < events->n; i++) {
            const orr_clock_event *e = &events->item[i];
            if (e->kind == ORR_CLOCK_EVENT_FLAG || (e->kind != ORR_CLOCK_EVENT_REFERENCE) != single) continue;
            if (told++ < TOLD) tell_event(e, warnings);
        }
    if (told > TOLD)
        orr_warnings_add(warnings, NULL, 0, 0, "and %zu more such events of clocks; the product lists all",
                         told - TOLD);
}

// What a clock that the centre predicted may be off: what a prediction of our own from the clocks observed before may
// be, and what the two are apart.
static orr_status sigma_of_predicted(orr_clock_list *l)
{
    size_t observed = 0;
    while (observed < l->n && (l->node[observed].flags & ORR_EPH_PREDICTED) == 0) observed++;
    if (observed == l->n || observed < 2) return ORR_OK;
    orr_clock_noise noise;
    orr_clock_predictor *p = NULL;
    orr_status s = orr_clock_noise_fit(l->node, observed, &noise);
    if (s == ORR_OK) {
        const orr_clock_model model = orr_clock_model_choose(l->sat, NULL, &noise);
        s = orr_clock_predictor_init(l->node, observed, &model, &noise, &p);
    }
    for (size_t i = observed; i < l->n && s == ORR_OK; i++)
        if ((l->node[i].flags & ORR_EPH_PREDICTED) != 0) {
            const orr_clock_prediction own = orr_clock_predictor_at(p, l->node[i].t);
            l->node[i].sigma_s = (float)hypot(own.sigma_s, l->node[i].clock_s - own.clock_s);
        }
    orr_clock_predictor_free(p);
    return s == ORR_E_MEMORY ? s : ORR_OK; // a clock that tells too little has no such sigma
}

// The joined clocks become the table's; satellites that no source has keep none.
static orr_status hand_over(orr_clock_table *clocks, orr_clock_noise *noise, orr_node_table *table)
{
    orr_status s = ORR_OK;
    for (size_t i = 0, k = 0; i < table->n_sats; i++) {
        orr_node_list *l = &table->list[i];
        l->clock_noise = (orr_clock_noise){(double)NAN, (double)NAN, (double)NAN};
        while (k < clocks->n && clocks->list[k].sat < l->sat) k++;
        if (k == clocks->n || clocks->list[k].sat != l->sat) continue;
        if (s == ORR_OK) s = sigma_of_predicted(&clocks->list[k]);
        l->clock = clocks->list[k].node;
        l->n_clocks = clocks->list[k].n;
        l->clock_noise = noise[k];
        clocks->list[k] = (orr_clock_list){.sat = l->sat};
    }
    return s;
}

orr_status orr_clocks_gather(const orr_smoother_input *input, size_t n_inputs, const size_t *order,
                             const orr_smoother_options *o, int64_t midnight, orr_node_table *table,
                             orr_warnings *warnings)
{
    sources sp3 = {0}, clk = {0};
    orr_clock_table clocks = {0}, better = {0};
    orr_status s = read_sp3s(input, n_inputs, order, o, midnight, table, &sp3);
    if (s == ORR_OK) s = read_clks(o, table, &clk, warnings);
    table->clock_step_s = fmax(sp3.longest_step_s, clk.longest_step_s);
    table->clock_max_gap_s = fmax(GAP_STEPS * table->clock_step_s, o->clock_gap_s);
    if (s == ORR_OK) s = orr_clock_sources_join(sp3.item, sp3.n, table->clock_max_gap_s, &clocks, warnings);
    if (s == ORR_OK) s = orr_clock_sources_join(clk.item, clk.n, table->clock_max_gap_s, &better, warnings);
    if (s == ORR_OK && clk.n > 0)
        s = orr_clock_table_replace(clk.item[0].name, table->clock_max_gap_s, &better, &clocks, warnings);
    sources_free(&sp3);
    sources_free(&clk);
    orr_clock_table_free(&better);
    if (s == ORR_OK)
        s = orr_clock_judge(table->clock_max_gap_s, o->detect, o->clock_remove_reference, &clocks,
                            &table->clock_events);
    orr_clock_noise *noise = malloc((clocks.n + 1) * sizeof *noise);
    if (s == ORR_OK && noise == NULL) s = ORR_E_MEMORY;
    if (s == ORR_OK) s = orr_clock_between_noise(&clocks, table->clock_max_gap_s, noise);
    if (s == ORR_OK) s = hand_over(&clocks, noise, table);
    if (s == ORR_OK) tell_events(&table->clock_events, warnings);
    free(noise);
    orr_clock_table_free(&clocks);
    return s;
}

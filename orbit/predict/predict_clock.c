// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/predict/predict_clock.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/clock/clock_common.h"
#include "orbit/clock/clock_predict.h"

#define LONGEST_STEP_S 900.0
#define HISTORY_NS (2 * ORR_S_PER_DAY * ORR_NS_PER_S)
#define LATE_NS (3 * 3600 * ORR_NS_PER_S)

// Observed nodes of the last two days, from the last event of the clock on.
static orr_status history_of(const orr_orbit_sat *sat, orr_time end, orr_clock_list *out)
{
    *out = (orr_clock_list){.sat = sat->sat, .node = malloc((sat->n_clocks + 1) * sizeof *out->node)};
    if (out->node == NULL) return ORR_E_MEMORY;
    for (size_t k = 0; k < sat->n_clocks; k++) {
        const orr_clock_node *c = &sat->clock[k];
        if (c->t < end - HISTORY_NS || (c->flags & ORR_EPH_PREDICTED) != 0) continue;
        if ((c->flags & ORR_EPH_CLOCK_EVENT) != 0) out->n = 0;
        out->node[out->n++] = *c;
    }
    return ORR_OK;
}

// Of two nodes of one instant the later file's.
static void keep_later(orr_clock_list *l)
{
    size_t n = 0;
    for (size_t k = 0; k < l->n; k++) {
        if (n > 0 && l->node[n - 1].t == l->node[k].t) n--;
        l->node[n++] = l->node[k];
    }
    l->n = n;
}

static orr_status append(const orr_clock_predictor *p, orr_time last, orr_time to, double step_s,
                         orr_orbit_sat *sat)
{
    const size_t more = (size_t)ceil(orr_time_diff_s(to, last) / step_s - 1e-9);
    orr_clock_node *node = realloc(sat->clock, (sat->n_clocks + more + 1) * sizeof *node);
    if (node == NULL) return ORR_E_MEMORY;
    sat->clock = node;
    for (size_t i = 1; i <= more; i++) {
        const orr_time t = orr_time_add_s(last, step_s * (double)i);
        const orr_clock_prediction c = orr_clock_predictor_at(p, t);
        node[sat->n_clocks++] = (orr_clock_node){
            .t = t, .clock_s = c.clock_s, .flags = ORR_EPH_PREDICTED, .sigma_s = (float)c.sigma_s};
    }
    return ORR_OK;
}

static orr_status predict_one(const orr_orbit_solution *s, orr_clock_list *l, orr_time end, orr_time to,
                              orr_orbit_sat *sat, size_t *n)
{
    orr_clock_noise noise = {0};
    orr_clock_predictor *p = NULL;
    keep_later(l);
    if (l->n < 2 || l->node[l->n - 1].t < end - LATE_NS) return ORR_OK;
    orr_status status = orr_clock_noise_fit(l->node, l->n, &noise);
    if (status == ORR_E_NODATA) status = ORR_OK; // too few to tell: their line, with the least sigma
    if (status != ORR_OK) return status;
    const orr_clock_model model = orr_clock_model_choose(l->sat, NULL, &noise);
    status = orr_clock_predictor_init(l->node, l->n, &model, &noise, &p);
    if (status == ORR_E_NODATA || status == ORR_E_NUMERIC) return ORR_OK;
    if (status != ORR_OK) return status;
    const orr_clock_node *last = &l->node[l->n - 1];
    const double step_s = fmin(LONGEST_STEP_S, s->clock_max_gap_s / 1.5);
    // Nodes behind the last observed one are another's prediction.
    while (sat->n_clocks > 0 && sat->clock[sat->n_clocks - 1].t > last->t) sat->n_clocks--;
    status = append(p, last->t, to, step_s, sat);
    orr_clock_predictor_free(p);
    *n += status == ORR_OK;
    return status;
}

orr_status orr_predict_clocks(orr_orbit_solution *s, const bool *wanted, orr_time end, orr_time to, size_t *n,
                              orr_diag *diag)
{
    orr_clock_list *list = calloc(s->n_sats + 1, sizeof *list);
    orr_status status = list != NULL ? ORR_OK : ORR_E_MEMORY;
    *n = 0;
    for (size_t i = 0; i < s->n_sats && status == ORR_OK; i++) status = history_of(&s->sat[i], end, &list[i]);
    for (const char *system = ORR_SYSTEMS; *system != '\0' && status == ORR_OK; system++) {
        orr_clock_common common;
        status = orr_clock_common_find(list, s->n_sats, *system, &common);
        if (status != ORR_OK) break;
        for (size_t i = 0; i < s->n_sats && status == ORR_OK; i++) {
            if (orr_sat_system(list[i].sat) != *system || !wanted[i]) continue;
            orr_clock_common_apply(&common, -1, &list[i]);
            status = predict_one(s, &list[i], end, to, &s->sat[i], n);
        }
        orr_clock_common_free(&common);
    }
    for (size_t i = 0; list != NULL && i < s->n_sats; i++) free(list[i].node);
    free(list);
    return status == ORR_OK ? ORR_OK : orr_diag_set(diag, status, "out of memory for predicted clocks");
}

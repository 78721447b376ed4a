// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/elements.h"

#include <math.h>
#include <stdlib.h>

#include "ingest/tables/erp.h"
#include "src/make/products.h"

// A product and what it covers.
typedef struct product {
    const char *path;
    orr_time from, to;
} product;

static int by_begin(const void *a, const void *b)
{
    const product *x = a, *y = b;
    if (x->from != y->from) return x->from < y->from ? -1 : 1;
    return (x->to > y->to) - (x->to < y->to);
}

// Spans first, so that rows come in order of time however the products are named.
static orr_status put_in_order(const orr_elements_plan *plan, product *list, orr_diag *diag)
{
    for (size_t k = 0; k < plan->n_products; k++) {
        orr_ephemeris *e = NULL;
        list[k].path = plan->product[k];
        orr_status s = orr_product_load(list[k].path, &e, diag);
        if (s != ORR_OK) return s;
        orr_ephemeris_span(e, &list[k].from, &list[k].to);
        orr_ephemeris_free(e);
    }
    qsort(list, plan->n_products, sizeof *list, by_begin);
    return ORR_OK;
}

typedef struct run {
    const orr_elements_plan *plan;
    orr_elements_options options;
    orr_elements_sink sink;
    void *user;
    size_t n_rows;
    orr_time last; // instant of the last row, ORR_TIME_NONE before the first
} run;

// Positions about the axes' instant, for a fit: an orr_navfit_source.
typedef struct about {
    const orr_ephemeris *e;
    orr_sat sat;
    const orr_elements_axes *axes;
} about;

static orr_status position_near(void *user, orr_time t, orr_vec3 *pos_m)
{
    const about *a = user;
    orr_sat_state state;
    const orr_status s = orr_elements_state_near(a->e, a->sat, a->axes, t, &state);
    if (s == ORR_OK) *pos_m = state.pos_m;
    return s;
}

// The fifteen mean elements, of the osculating revolution about the instant, which has to be known whole.
static orr_status fifteen_of(const orr_ephemeris *e, const orr_elements_axes *axes, orr_elements_row *row)
{
    about a = {e, row->sat, axes};
    orr_vec3 end;
    orr_status s = orr_elements_of(e, row->sat, axes, &row->k);
    if (s != ORR_OK) return s;
    const double half_s = ORR_PI * sqrt(pow(row->k.a_m, 3) / ORR_EGM96_GM);
    const orr_time from = orr_time_add_s(axes->t, -half_s), to = orr_time_add_s(axes->t, half_s);
    s = position_near(&a, from, &end);
    if (s == ORR_OK) s = position_near(&a, to, &end);
    if (s == ORR_OK) s = orr_navfit_mean(axes->t, from, to, position_near, &a, &row->mean, NULL);
    return s == ORR_OK ? orr_elements_from_frozen(axes, &row->mean.k, &row->k) : s;
}

static orr_status rows_at(run *r, const orr_ephemeris *e, orr_time at, orr_diag *diag)
{
    const orr_sat *list;
    const size_t n = orr_ephemeris_satellites(e, &list);
    orr_elements_axes axes;
    orr_status s = ORR_OK;
    orr_elements_axes_at(at, &r->options, &axes);
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        orr_elements_row row = {.t = at, .sat = list[i]};
        if (r->plan->sats != NULL && !orr_sat_set_has(r->plan->sats, list[i])) continue;
        const orr_status had =
            r->plan->fifteen ? fifteen_of(e, &axes, &row) : orr_elements_of(e, list[i], &axes, &row.k);
        if (had != ORR_OK) continue;
        s = r->sink(r->user, &row, diag);
        r->n_rows++;
        r->last = at;
    }
    return s;
}

// Rows of one product, from its begin, or from behind the last row of the product before.
static orr_status rows_of(run *r, const orr_ephemeris *e, orr_diag *diag)
{
    const int64_t step = r->plan->step_ns;
    const orr_time after = r->last;
    if (r->plan->erp == NULL) r->options.eop = orr_ephemeris_eop(e);
    orr_time begin, end;
    orr_ephemeris_span(e, &begin, &end);
    orr_time at = r->plan->from != ORR_TIME_NONE ? r->plan->from : begin;
    orr_time to = r->plan->to != ORR_TIME_NONE && r->plan->to < end ? r->plan->to : end;
    if (after != ORR_TIME_NONE && begin <= after) begin = after + 1;
    if (at < begin) { // the first of the rows within
        const int64_t steps = (begin - at - 1) / step + 1;
        if (to < begin || steps > (to - at) / step) return ORR_OK;
        at += steps * step;
    }
    orr_status s = ORR_OK;
    for (; at <= to && s == ORR_OK; at += step) {
        s = rows_at(r, e, at, diag);
        if (to - at < step) break; // the next row may lie beyond what an orr_time holds
    }
    return s;
}

static void warn_of_eop(const orr_eop_series *eop, const product *list, size_t n, orr_warnings *warnings)
{
    char when[ORR_TIME_TEXT];
    for (size_t k = 0; k < n; k++) {
        bool begin, end;
        orr_eop_at(eop, list[k].from, NULL, &begin);
        orr_eop_at(eop, list[k].to, NULL, &end);
        if (begin && end) continue;
        orr_warnings_add(warnings, list[k].path, 0, 0,
                         "the Earth rotation given does not cover %s; it is carried on beyond its ends",
                         orr_time_text(begin ? list[k].to : list[k].from, when));
    }
}

static orr_status load(const product *p, orr_inputs *inputs, orr_ephemeris **e, orr_diag *diag)
{
    const orr_status s = inputs != NULL ? orr_inputs_note(inputs, p->path, diag) : ORR_OK;
    return s == ORR_OK ? orr_ephemeris_load(p->path, e, diag) : s;
}

static orr_status rows_of_all(run *r, product *list, orr_inputs *inputs, orr_warnings *warnings,
                              orr_diag *diag)
{
    const size_t n = r->plan->n_products;
    orr_status s = put_in_order(r->plan, list, diag);
    if (s == ORR_OK && r->plan->erp != NULL) warn_of_eop(r->options.eop, list, n, warnings);
    // Beside the product that is at its turn the one before and the one after: methods reach over its ends.
    orr_ephemeris *e[3] = {NULL, NULL, NULL};
    if (s == ORR_OK) s = load(&list[0], inputs, &e[2], diag);
    for (size_t k = 0; k < n && s == ORR_OK; k++) {
        orr_ephemeris_free(e[0]);
        e[0] = e[1];
        e[1] = e[2];
        e[2] = NULL;
        if (k + 1 < n) s = load(&list[k + 1], inputs, &e[2], diag);
        r->options.before = e[0];
        r->options.after = e[2];
        if (s == ORR_OK) s = rows_of(r, e[1], diag);
    }
    for (int k = 0; k < 3; k++) orr_ephemeris_free(e[k]);
    if (s != ORR_OK || r->n_rows > 0) return s;
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    return orr_diag_set(
        diag, ORR_E_NODATA,
        "no elements: the first product covers %s to %s; no such satellite, or no instant where the "
        "method has what it needs around it",
        orr_time_text(list[0].from, from), orr_time_text(list[0].to, to));
}

static orr_status read_erp(const orr_elements_plan *plan, orr_inputs *inputs, orr_erp *out,
                           orr_warnings *warnings, orr_diag *diag)
{
    orr_bytes text;
    orr_status s = orr_inputs_read(inputs, plan->erp, ORR_KIND_BIT(ORR_KIND_ERP), &text, diag);
    if (s == ORR_OK) s = orr_erp_parse(plan->erp, text.text, text.n, plan->leap, NULL, out, warnings, diag);
    orr_bytes_free(&text);
    return s;
}

orr_status orr_elements_make(const orr_elements_plan *plan, orr_elements_sink sink, void *user,
                             size_t *n_rows, orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag)
{
    if (plan->n_products == 0 || plan->step_ns <= 0)
        return orr_diag_set(diag, ORR_E_ARG, "elements need an orbit product and a positive step");
    if (plan->spacing_s < ORR_MAKE_ELEMENTS_LEAST_SPACING_S)
        return orr_diag_set(diag, ORR_E_ARG,
                            "three positions %g s apart do not define a plane: at least %g s",
                            plan->spacing_s, ORR_MAKE_ELEMENTS_LEAST_SPACING_S);
    run r = {.plan = plan,
             .options = {.frame = plan->frame,
                         .method = plan->fifteen ? ORR_ELEMENTS_STATE : plan->method,
                         .spacing_s = plan->spacing_s},
             .sink = sink,
             .user = user,
             .last = ORR_TIME_NONE};
    orr_erp erp = {0};
    product *list = calloc(plan->n_products, sizeof *list);
    orr_status s = list != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK && plan->erp != NULL) {
        s = read_erp(plan, inputs, &erp, warnings, diag);
        r.options.eop = &erp.series;
    }
    if (s == ORR_OK) s = rows_of_all(&r, list, inputs, warnings, diag);
    if (n_rows != NULL) *n_rows = r.n_rows;
    orr_erp_free(&erp);
    free(list);
    return s;
}

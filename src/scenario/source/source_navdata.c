// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/source/source_navdata.h"

#include <stdio.h>
#include <stdlib.h>

#include "src/make/navset.h"
#include "src/scenario/source/navdata_faults.h"

struct orr_source_navdata {
    const orr_source_orbit *orbits;
    orr_navset *set; // NULL: none, and why
    orr_navdata_bits *bits;
    char none[512];
    bool phase_centres;
};

// What the fit has to say of satellites, marked as being of the broadcast data: their orbits are served.
static void pass_on(const orr_warnings *own, orr_warnings *warnings)
{
    for (size_t i = 0; i < own->kept; i++) {
        const orr_diag *d = &own->item[i];
        orr_warnings_add(warnings, d->file, d->line, d->column, "%s%s",
                         d->file[0] == '\0' ? "broadcast data: " : "", d->text);
    }
    if (warnings != NULL) warnings->count += own->count - own->kept;
}

static orr_status make(orr_source_navdata *v, const orr_scenario *s, const orr_source_tables *tables,
                       const orr_log *log, const volatile int *cancel, orr_warnings *warnings, orr_diag *diag)
{
    orr_navset_plan plan;
    if (!orr_navset_plan_of(s, &plan)) {
        snprintf(v->none, sizeof v->none, "the scenario wants no broadcast data (navdata.window: none)");
        return ORR_OK;
    }
    plan.options.cancel = cancel;
    if (plan.antex != NULL) plan.antex_read = &tables->antex;
    if (plan.bias != NULL) plan.bias_read = &tables->bias;
    if (plan.n_nav > 0) plan.nav_read = &tables->nav;
    orr_diag inner = {0};
    orr_warnings own = {0};
    orr_span span = {.from = 0};
    orr_navset_fault *fault;
    (void)orr_source_orbit_span(v->orbits, &span);
    const orr_interval all = {span.from, span.to + 1};
    orr_status status = orr_navdata_faults_of(s, all, &fault, &plan.options.n_faults, diag);
    if (status != ORR_OK) return status;
    plan.options.fault = fault;
    status = orr_navset_make(orr_source_orbit_ephemeris(v->orbits), &plan, &v->set, NULL, &own, &inner);
    free(fault);
    pass_on(&own, warnings);
    orr_warnings_free(&own);
    if (status == ORR_E_NODATA) { // no fault of the scenario: the rest of it is served
        snprintf(v->none, sizeof v->none, "%s", inner.text);
        ORR_LOG(log, ORR_LOG_INFO, "no broadcast data: %s", v->none);
        return ORR_OK;
    }
    if (status != ORR_OK && diag != NULL) *diag = inner;
    if (status == ORR_OK) status = orr_navdata_bits_open(s, v->set, all, &v->bits, diag);
    const orr_sat *list;
    if (status == ORR_OK)
        ORR_LOG(log, ORR_LOG_INFO, "fitted broadcast data of %zu satellites",
                orr_navset_satellites(v->set, &list));
    return status;
}

orr_status orr_source_navdata_open(const orr_scenario *s, const orr_source_orbit *orbits,
                                   const orr_source_tables *tables, const orr_log *log,
                                   const volatile int *cancel, orr_warnings *warnings,
                                   orr_source_navdata **out, orr_diag *diag)
{
    *out = NULL;
    if (orbits == NULL) return ORR_OK;
    orr_source_navdata *v = calloc(1, sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    v->orbits = orbits;
    v->phase_centres = s->navdata.antex != NULL;
    orr_status status = make(v, s, tables, log, cancel, warnings, diag);
    if (status != ORR_OK) {
        orr_source_navdata_close(v);
        return status;
    }
    *out = v;
    return ORR_OK;
}

void orr_source_navdata_close(orr_source_navdata *v)
{
    if (v == NULL) return;
    orr_navdata_bits_free(v->bits);
    orr_navset_free(v->set);
    free(v);
}

bool orr_source_navdata_span(const orr_source_navdata *v, orr_span *out)
{
    return v != NULL && v->set != NULL && orr_source_orbit_span(v->orbits, out);
}

const char *orr_source_navdata_none(const orr_source_navdata *v)
{
    if (v == NULL) return "the scenario has no satellites (orbit.product, orbit.sp3)";
    return v->set != NULL ? NULL : v->none;
}

const orr_navset *orr_source_navdata_set(const orr_source_navdata *v) { return v != NULL ? v->set : NULL; }

bool orr_source_navdata_phase_centres(const orr_source_navdata *v)
{
    return v != NULL && v->set != NULL && v->phase_centres;
}

size_t orr_source_navdata_streams(const orr_source_navdata *v, orr_sat sat, uint32_t messages,
                                  const orr_nav_stream *list[ORR_NAVSET_STREAMS])
{
    if (v == NULL || v->set == NULL) return 0;
    size_t n = orr_navset_streams(v->set, sat, list), kept = 0;
    if (messages == 0) return n < 1 ? n : 1;
    for (size_t k = 0; k < n; k++)
        if ((messages >> list[k]->message & 1u) != 0) list[kept++] = list[k];
    return kept;
}

orr_answer orr_source_navdata_evaluate(const orr_source_navdata *v, orr_time t, orr_sat sat,
                                       const orr_nav_stream *stream, bool coded, const orr_navset_item **set,
                                       orr_navframe *frame)
{
    orr_span span;
    *set = NULL;
    if (!orr_source_navdata_span(v, &span)) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    if (stream == NULL) return ORR_ANSWER_NOT_SERVED;
    const orr_navset_item *item = orr_navset_at(v->set, sat, stream->message, t);
    const orr_status s =
        item == NULL ? ORR_E_NODATA : orr_navframe_at(v->set, sat, stream, t, coded, frame, NULL);
    if (s == ORR_OK) {
        orr_navdata_bits_invert(v->bits, frame);
        *set = item;
    }
    return s == ORR_OK ? ORR_ANSWER_OK : s == ORR_E_NODATA ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NO_VALUE;
}

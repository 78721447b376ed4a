// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/fault.h"

#include <math.h>
#include <stdlib.h>

#include "core/array.h"
#include "core/constants.h"
#include "core/interval.h"
#include "src/scenario/effect/fault_private.h"

static orr_status list_events(orr_faults *f)
{
    f->event = calloc(3 * f->n_items + 1, sizeof *f->event);
    if (f->event == NULL) return ORR_E_MEMORY;
    for (size_t k = 0; k < f->n_items; k++) {
        f->event[f->n_events++] = f->item[k].from;
        f->event[f->n_events++] = f->item[k].hold;
        f->event[f->n_events++] = f->item[k].to;
    }
    qsort(f->event, f->n_events, sizeof *f->event, orr_time_order);
    return ORR_OK;
}

// Which faults befall which satellite; noise is made.
static orr_status share_out(const orr_scenario *s, const orr_fault_satellite *satellite, size_t n,
                            orr_faults *f, orr_diag *diag)
{
    size_t spare = ORR_SERIES_NODES;
    f->n_sats = n;
    f->first = calloc(n + 1, sizeof *f->first);
    orr_status status = f->first != NULL ? ORR_OK : ORR_E_MEMORY;
    for (size_t place = 0; status == ORR_OK && place < n; place++) {
        for (size_t k = 0; status == ORR_OK && k < f->n_items; k++) {
            const fault_item *item = &f->item[k];
            if (!orr_sat_set_has(&item->sats, satellite[place].sat)) continue;
            if (!ORR_ARRAY_GROW(f->use, f->n_uses)) {
                status = ORR_E_MEMORY;
                break;
            }
            fault_use *use = &f->use[f->n_uses++];
            *use = (fault_use){.place = place, .item = k};
            if (item->kind == FAULT_NOISE)
                status = fault_noise_make(item, s->faults.seed, satellite[place].sat, &spare, use);
        }
        f->first[place + 1] = f->n_uses;
    }
    if (status == ORR_E_LIMIT)
        return orr_marks_blame(&s->marks, status, "faults.noise",
                               "noise of so many satellites over so long a time is more than 20 million "
                               "nodes: give it a shorter time or longer correlation times",
                               diag);
    return status == ORR_OK ? ORR_OK : orr_diag_set(diag, status, "out of memory");
}

orr_status orr_faults_open(const orr_scenario *s, const orr_fault_satellite *satellite, size_t n,
                           orr_span span, orr_faults **out, orr_diag *diag)
{
    *out = NULL;
    orr_faults *f = calloc(1, sizeof *f);
    if (f == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_status status = faults_list(s, span, f, diag);
    if (status == ORR_OK) status = faults_contradict(s, satellite, n, f, diag);
    if (status == ORR_OK && f->n_items > 0) {
        status = list_events(f);
        if (status != ORR_OK) (void)orr_diag_set(diag, status, "out of memory");
        if (status == ORR_OK) status = share_out(s, satellite, n, f, diag);
        if (status == ORR_OK) {
            *out = f;
            return ORR_OK;
        }
    }
    orr_faults_close(f);
    return status;
}

void orr_faults_close(orr_faults *f)
{
    if (f == NULL) return;
    for (size_t k = 0; k < f->n_uses; k++)
        for (size_t j = 0; j < 2; j++) orr_series_free(&f->use[k].series[j]);
    free(f->use);
    free(f->first);
    free(f->event);
    free(f->item);
    free(f);
}

bool orr_faults_time(const orr_faults *f, size_t k, orr_fault_time *out)
{
    if (f == NULL || k >= f->n_uses) return false;
    const fault_use *use = &f->use[k];
    *out = (orr_fault_time){use->place, use->item, f->item[use->item].from, f->item[use->item].to};
    return true;
}

static bool there(const fault_item *x, orr_time as_of) { return x->from <= as_of && as_of < x->to; }

// A profile's value and rate at t, in the piece that holds as_of.
static double profile_at(const fault_item *x, orr_time t, orr_time as_of, double *rate)
{
    const bool held = as_of >= x->hold;
    *rate = held ? 0 : x->rate;
    return x->step + x->rate * orr_time_diff_s(held ? x->hold : t, x->from);
}

static void add_profile(const fault_item *x, orr_time t, orr_time as_of, double factor, double *value,
                        double *rate)
{
    double slope;
    *value += factor * profile_at(x, t, as_of, &slope);
    *rate += factor * slope;
}

static void add(const orr_faults *f, const fault_use *use, orr_time t, orr_time as_of, orr_fault_now *out)
{
    const fault_item *x = &f->item[use->item];
    double rate;
    switch (x->kind) {
    case FAULT_RANGE:
        add_profile(x, t, as_of, 1, &out->range_m, &out->range_mps);
        break;
    case FAULT_CLOCK:
        add_profile(x, t, as_of, -ORR_LIGHT_MPS, &out->clock_m, &out->clock_mps);
        break;
    case FAULT_DIVERGENCE:
        add_profile(x, t, as_of, 1, &out->divergence_m, &out->divergence_mps);
        break;
    case FAULT_POWER:
        out->power_db += profile_at(x, t, as_of, &rate);
        break;
    case FAULT_NOISE:
        for (size_t k = 0; k < use->n_series; k++) {
            out->noise_m += orr_series_at(&use->series[k], t, &rate);
            out->noise_mps += rate;
        }
        break;
    case FAULT_SINE: {
        const double phase = x->at_rad + x->w_radps * orr_time_diff_s(t, x->from);
        out->noise_m += x->amplitude_m * sin(phase);
        out->noise_mps += x->amplitude_m * x->w_radps * cos(phase);
        break;
    }
    case FAULT_ORBIT:
        if (x->wrong == ORR_FAULT_ORBIT_TRUE) out->orbit_m = orr_vec3_add(out->orbit_m, x->orbit_m);
        break;
    case FAULT_UNHEALTHY:
        out->unhealthy = true;
        break;
    case FAULT_OFF:
    case FAULT_STALE:
    case FAULT_BITS:
    case FAULT_KINDS:
        break;
    }
}

void orr_faults_at(const orr_faults *f, size_t place, size_t signal, orr_time t, orr_time as_of,
                   orr_fault_now *out)
{
    *out = (orr_fault_now){.any = false};
    if (f == NULL) return;
    for (size_t k = f->first[place]; k < f->first[place + 1]; k++) {
        const fault_item *x = &f->item[f->use[k].item];
        if (!there(x, as_of) || (x->signals >> signal & 1) == 0) continue;
        out->any = true;
        add(f, &f->use[k], t, as_of, out);
    }
}

bool orr_faults_off(const orr_faults *f, size_t place, orr_time as_of)
{
    if (f == NULL) return false;
    for (size_t k = f->first[place]; k < f->first[place + 1]; k++) {
        const fault_item *x = &f->item[f->use[k].item];
        if (x->kind == FAULT_OFF && there(x, as_of)) return true;
    }
    return false;
}

bool orr_faults_change(const orr_faults *f, orr_time after, orr_time until)
{
    if (f == NULL) return false;
    for (size_t k = 0; k < f->n_events && f->event[k] <= until; k++)
        if (f->event[k] > after) return true;
    return false;
}

bool orr_faults_allow(const orr_faults *f, orr_time from, orr_time to, int64_t length_ns, double error_m)
{
    if (f == NULL) return true;
    for (size_t k = 0; k < f->n_events; k++)
        if (!orr_instant_fits(f->event[k], (orr_interval){from, to}, length_ns)) return false;
    for (size_t k = 0; k < f->n_uses; k++) {
        const fault_use *use = &f->use[k];
        const fault_item *x = &f->item[use->item];
        if (x->to <= from || to <= x->from) continue;
        for (size_t j = 0; j < use->n_series; j++)
            if (use->series[j].step_ns % length_ns != 0) return false;
        const double turn = x->w_radps * (double)length_ns / 1e9;
        if (x->amplitude_m * turn * turn * turn * turn / 384 > error_m) return false;
    }
    return true;
}

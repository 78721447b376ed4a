// SPDX-License-Identifier: GPL-3.0-or-later
// Faults as the scenario has them, and whether they can be so: times in order and at blocks' edges, none that contradicts another.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/array.h"
#include "core/constants.h"
#include "core/signal.h"
#include "src/scenario/effect/fault_private.h"

static const char *const NAMES[FAULT_KINDS] = {
    [FAULT_RANGE] = "range", [FAULT_CLOCK] = "clock", [FAULT_DIVERGENCE] = "divergence",
    [FAULT_POWER] = "power", [FAULT_NOISE] = "noise", [FAULT_SINE] = "sine",
    [FAULT_ORBIT] = "orbit", [FAULT_OFF] = "off",     [FAULT_UNHEALTHY] = "unhealthy",
    [FAULT_STALE] = "stale", [FAULT_BITS] = "bits",
};
enum { PATH = 60 };

static void path_of(const fault_item *x, const char *key, char out[PATH])
{
    snprintf(out, PATH, "faults.%s[%zu]%s%s", NAMES[x->kind], x->index, key[0] != '\0' ? "." : "", key);
}

static orr_status refuse(const orr_scenario *s, const fault_item *x, const char *key, const char *why,
                         orr_diag *diag)
{
    char path[PATH];
    path_of(x, key, path);
    return orr_marks_blame(&s->marks, ORR_E_FORMAT, path, why, diag);
}

// Times in order, on milliseconds, and some of them within the scenario.
static orr_status check_times(const orr_scenario *s, orr_span span, const fault_item *x, bool has_to,
                              bool has_hold, orr_diag *diag)
{
    char why[200], from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    static const char *const MS = "a fault begins and ends on a whole millisecond, where blocks can begin";
    if (x->from % 1000000 != 0) return refuse(s, x, "from", MS, diag);
    if (has_to && x->to % 1000000 != 0) return refuse(s, x, "to", MS, diag);
    if (has_hold && x->hold % 1000000 != 0) return refuse(s, x, "hold", MS, diag);
    if (has_to && x->to <= x->from) return refuse(s, x, "to", "the fault ends before it begins", diag);
    if (has_hold && (x->hold <= x->from || x->hold > x->to))
        return refuse(s, x, "hold", "a ramp ends after the fault's begin and not after its end", diag);
    if (x->from > span.to || x->to <= span.from) {
        snprintf(why, sizeof why, "the fault is never seen: the channels reach from %s to %s",
                 orr_time_text(span.from, from), orr_time_text(span.to, to));
        return refuse(s, x, x->from > span.to ? "from" : "to", why, diag);
    }
    return ORR_OK;
}

static orr_status add(const orr_scenario *s, orr_span span, const orr_fault_when *when, fault_item x,
                      bool has_hold, orr_faults *f, orr_diag *diag)
{
    x.sats = when->sats;
    x.from = when->from;
    x.to = when->has_to ? when->to : span.to + 1;
    if (!has_hold) x.hold = x.to;
    const orr_status status = check_times(s, span, &x, when->has_to, has_hold, diag);
    if (status != ORR_OK) return status;
    if (!ORR_ARRAY_GROW(f->item, f->n_items)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    f->item[f->n_items++] = x;
    return ORR_OK;
}

static orr_status add_profiles(const orr_scenario *s, orr_span span, fault_kind kind,
                               const orr_fault_profile *p, size_t n, orr_faults *f, orr_diag *diag)
{
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < n; k++) {
        fault_item x = {.kind = kind,
                        .index = k,
                        .signals = p[k].signals.n == 0 ? UINT64_MAX : 0,
                        .hold = p[k].hold,
                        .step = p[k].step,
                        .rate = p[k].rate};
        for (size_t j = 0; status == ORR_OK && j < p[k].signals.n; j++)
            status = orr_signal_parse(p[k].signals.item[j], &x.signals, diag);
        if (status == ORR_OK) status = add(s, span, &p[k].when, x, p[k].has_hold, f, diag);
    }
    return status;
}

static orr_status add_bare(const orr_scenario *s, orr_span span, fault_kind kind, const orr_fault_when *w,
                           size_t n, orr_faults *f, orr_diag *diag)
{
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < n; k++)
        status = add(s, span, &w[k], (fault_item){.kind = kind, .index = k, .signals = UINT64_MAX}, false, f,
                     diag);
    return status;
}

static orr_status add_others(const orr_scenario *s, orr_span span, orr_faults *f, orr_diag *diag)
{
    const orr_scenario_faults *o = &s->faults;
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < o->noise.n; k++)
        status = add(
            s, span, &o->noise.item[k].when,
            (fault_item){.kind = FAULT_NOISE, .index = k, .signals = UINT64_MAX, .noise = &o->noise.item[k]},
            false, f, diag);
    for (size_t k = 0; status == ORR_OK && k < o->sine.n; k++) {
        const orr_fault_sine *x = &o->sine.item[k];
        status = add(s, span, &x->when,
                     (fault_item){.kind = FAULT_SINE,
                                  .index = k,
                                  .signals = UINT64_MAX,
                                  .amplitude_m = x->amplitude_m,
                                  .w_radps = 2 * ORR_PI / x->period_s,
                                  .at_rad = x->phase_deg * ORR_RAD_PER_DEG},
                     false, f, diag);
    }
    for (size_t k = 0; status == ORR_OK && k < o->orbit.n; k++) {
        const orr_fault_orbit *x = &o->orbit.item[k];
        status = add(s, span, &x->when,
                     (fault_item){.kind = FAULT_ORBIT,
                                  .index = k,
                                  .signals = UINT64_MAX,
                                  .wrong = x->wrong,
                                  .orbit_m = {x->radial_m, x->along_m, x->cross_m}},
                     false, f, diag);
    }
    return status;
}

orr_status faults_list(const orr_scenario *s, orr_span span, orr_faults *f, orr_diag *diag)
{
    const orr_scenario_faults *o = &s->faults;
    orr_status status = add_profiles(s, span, FAULT_RANGE, o->range.item, o->range.n, f, diag);
    if (status == ORR_OK) status = add_profiles(s, span, FAULT_CLOCK, o->clock.item, o->clock.n, f, diag);
    if (status == ORR_OK)
        status = add_profiles(s, span, FAULT_DIVERGENCE, o->divergence.item, o->divergence.n, f, diag);
    if (status == ORR_OK) status = add_profiles(s, span, FAULT_POWER, o->power.item, o->power.n, f, diag);
    if (status == ORR_OK) status = add_bare(s, span, FAULT_OFF, o->off.item, o->off.n, f, diag);
    if (status == ORR_OK)
        status = add_bare(s, span, FAULT_UNHEALTHY, o->unhealthy.item, o->unhealthy.n, f, diag);
    if (status == ORR_OK) status = add_bare(s, span, FAULT_STALE, o->stale.item, o->stale.n, f, diag);
    for (size_t k = 0; status == ORR_OK && k < o->bits.n; k++)
        status = add(s, span, &o->bits.item[k].when,
                     (fault_item){.kind = FAULT_BITS, .index = k, .signals = UINT64_MAX}, false, f, diag);
    return status == ORR_OK ? add_others(s, span, f, diag) : status;
}

// Whether two faults of one satellite cannot be at once, and why.
static bool contradicts(const fault_item *a, const fault_item *b, orr_sat sat, char *why, size_t n)
{
    char name[ORR_SAT_TEXT], other[PATH];
    path_of(b, "", other);
    if (b->kind == FAULT_OFF && a->kind != FAULT_OFF && b->from <= a->from && a->to <= b->to) {
        snprintf(why, n, "the fault is never seen: %s is off all the time by %s", orr_sat_text(sat, name),
                 other);
        return true;
    }
    if (a->kind != b->kind || a->index <= b->index || a->kind == FAULT_NOISE || a->kind == FAULT_SINE ||
        a->kind == FAULT_BITS || (a->signals & b->signals) == 0 || a->wrong != b->wrong)
        return false;
    if (a->to <= b->from || b->to <= a->from) return false;
    snprintf(why, n, "%s has the same fault by %s at the same time: end one before the other begins",
             orr_sat_text(sat, name), other);
    return true;
}

orr_status faults_contradict(const orr_scenario *s, const orr_fault_satellite *satellite, size_t n,
                             const orr_faults *f, orr_diag *diag)
{
    char why[200];
    for (size_t i = 0; i < f->n_items; i++) {
        const fault_item *a = &f->item[i];
        bool befalls = false;
        for (size_t k = 0; k < n; k++) {
            if (!satellite[k].sends || !orr_sat_set_has(&a->sats, satellite[k].sat)) continue;
            befalls = true;
            for (size_t j = 0; j < f->n_items; j++)
                if (orr_sat_set_has(&f->item[j].sats, satellite[k].sat) &&
                    contradicts(a, &f->item[j], satellite[k].sat, why, sizeof why))
                    return refuse(s, a, "", why, diag);
        }
        if (!befalls) return refuse(s, a, "sats", "the scenario sends nothing of these satellites", diag);
    }
    return ORR_OK;
}

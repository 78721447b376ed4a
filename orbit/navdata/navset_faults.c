// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of broadcast data, as changes of when which set is sent.
#include <stdlib.h>

#include "orbit/navdata/navset_private.h"

// Added to the number of a slot for a changed set: no issue of any message comes round to it within days (IODE counts to 240,
// IODnav to 1024; BeiDou's ages to 24 within 12 hours).
enum { OTHER_ISSUE = 132 };

// Makes room for one more slot behind k, a copy of it.
static orr_status repeat(navset_schedule *s, size_t k)
{
    navset_slot *more = realloc(s->slot, (s->n + 1) * sizeof *more);
    if (more == NULL) return ORR_E_MEMORY;
    s->slot = more;
    for (size_t j = s->n++; j > k; j--) s->slot[j] = s->slot[j - 1];
    return ORR_OK;
}

// Cuts the slot that t is inside.
static orr_status cut_at(navset_schedule *s, orr_time t)
{
    for (size_t k = 0; k < s->n; k++) {
        if (t <= s->slot[k].from || t >= s->slot[k].to) continue;
        const orr_status status = repeat(s, k);
        if (status != ORR_OK) return status;
        s->slot[k].to = s->slot[k + 1].from = t;
        return ORR_OK;
    }
    return ORR_OK;
}

// The slot that holds the fault's begin goes on to its end.
static void keep_old(const orr_navset_fault *f, navset_schedule *s)
{
    size_t kept = 0;
    bool keeps = false;
    for (size_t k = 0; k < s->n; k++) {
        navset_slot slot = s->slot[k];
        if (keeps && slot.to <= f->to) continue; // never sent
        if (keeps && slot.from < f->to) slot.from = f->to;
        if (!keeps && slot.from <= f->from && f->from < slot.to) {
            keeps = slot.faulty = true;
            if (slot.to < f->to) slot.to = f->to;
        }
        s->slot[kept++] = slot;
    }
    s->n = kept;
}

orr_status navset_fault_slots(orr_sat sat, const orr_navset_options *o, navset_schedule *s)
{
    for (size_t i = 0; i < o->n_faults; i++) {
        const orr_navset_fault *f = &o->fault[i];
        if (!orr_sat_set_has(&f->sats, sat)) continue;
        if (f->kind == ORR_NAVSET_FAULT_STALE) {
            keep_old(f, s);
            continue;
        }
        orr_status status = cut_at(s, f->from);
        if (status == ORR_OK) status = cut_at(s, f->to);
        if (status != ORR_OK) return status;
        for (size_t k = 0; k < s->n; k++) {
            navset_slot *slot = &s->slot[k];
            if (slot->from < f->from || slot->to > f->to) continue;
            if (!slot->faulty) slot->number += OTHER_ISSUE;
            slot->faulty = true;
            if (f->kind == ORR_NAVSET_FAULT_UNHEALTHY)
                slot->unhealthy = true;
            else
                slot->displaced_m = orr_vec3_add(slot->displaced_m, f->displaced_m);
        }
    }
    return ORR_OK;
}

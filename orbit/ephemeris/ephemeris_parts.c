// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/ephemeris/ephemeris_parts.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "orbit/ephemeris/ephemeris_private.h"

struct orr_ephemeris_parts {
    pthread_mutex_t lock;
    orr_backing *backing;
    char *folder;
    orr_ephemeris **part; // of a satellite each
    size_t n;
    orr_status status; // of the first that failed
    orr_diag diag;
};

orr_status orr_ephemeris_parts_begin(const char *folder, orr_ephemeris_parts **out, orr_diag *diag)
{
    orr_ephemeris_parts *p = calloc(1, sizeof *p);
    *out = NULL;
    orr_status s = p != NULL && (p->folder = strdup(folder)) != NULL ? ORR_OK : ORR_E_MEMORY;
    if (s != ORR_OK) orr_diag_set(diag, s, "no memory for an orbit product");
    if (s == ORR_OK) s = orr_backing_open(folder, &p->backing, diag);
    if (s == ORR_OK && pthread_mutex_init(&p->lock, NULL) != 0)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no lock for an orbit product");
    if (s != ORR_OK) {
        if (p != NULL) {
            orr_backing_free(p->backing);
            free(p->folder);
        }
        free(p);
        return s;
    }
    *out = p;
    return ORR_OK;
}

static void forget(orr_ephemeris_parts *p, orr_sat sat)
{
    for (size_t i = 0; i < p->n; i++)
        if (p->part[i]->sat_id[0] == sat) {
            orr_ephemeris_free(p->part[i]);
            p->part[i] = p->part[--p->n];
            return;
        }
}

static orr_status add(orr_ephemeris_parts *p, const orr_orbit_sat *sat)
{
    forget(p, sat->sat);
    if (sat->n_arcs == 0) return ORR_OK;
    orr_orbit_sat own = *sat;
    const orr_orbit_solution alone = {.n_sats = 1, .sat = &own};
    orr_ephemeris *e = NULL;
    orr_status s = eph_fit_satellites(&alone, p->backing, &e, &p->diag);
    if (s != ORR_OK) return s;
    eph_rest(e);
    if (!orr_array_grow(&p->part, p->n, sizeof(void *))) {
        orr_ephemeris_free(e);
        return orr_diag_set(&p->diag, ORR_E_MEMORY, "no memory for another satellite");
    }
    p->part[p->n++] = e;
    return ORR_OK;
}

orr_status orr_ephemeris_parts_add(orr_ephemeris_parts *p, const orr_orbit_sat *sat)
{
    (void)pthread_mutex_lock(&p->lock);
    if (p->status == ORR_OK) p->status = add(p, sat);
    const orr_status s = p->status;
    (void)pthread_mutex_unlock(&p->lock);
    return s;
}

void orr_ephemeris_parts_error(const orr_ephemeris_parts *p, orr_diag *diag)
{
    if (p->status != ORR_OK && diag != NULL) *diag = p->diag;
}

static int by_satellite(const void *a, const void *b)
{
    const orr_sat x = (*(orr_ephemeris *const *)a)->sat_id[0], y = (*(orr_ephemeris *const *)b)->sat_id[0];
    return (x > y) - (x < y);
}

static void count(const orr_ephemeris_parts *p, orr_ephemeris *counts)
{
    for (size_t i = 0; i < p->n; i++) {
        const orr_ephemeris *e = p->part[i];
        counts->n_sats += e->n_sats;
        counts->n_arcs += e->n_arcs;
        counts->n_segments += e->n_segments;
        counts->n_samples += e->n_samples;
        counts->n_coefs += e->n_coefs;
        counts->n_clocks += e->n_clocks;
        counts->n_nodes += e->n_nodes;
        counts->n_events += e->n_events;
    }
}

static void append_all(const orr_ephemeris_parts *p, orr_ephemeris *e)
{
    e->n_sats = e->n_arcs = e->n_segments = e->n_samples = e->n_coefs = 0;
    e->n_clocks = e->n_nodes = e->n_events = 0;
    for (size_t i = 0; i < p->n; i++) {
        const orr_ephemeris *part = p->part[i];
        eph_append(part, e, 0);
        e->max_pos_error_m = fmax(e->max_pos_error_m, part->max_pos_error_m);
        e->max_vel_error_mps = fmax(e->max_vel_error_mps, part->max_vel_error_mps);
        e->n_shortened += part->n_shortened;
        eph_rest(part);
        eph_rest(e);
    }
}

orr_status orr_ephemeris_parts_join(orr_ephemeris_parts *p, const orr_orbit_solution *s, orr_ephemeris **out,
                                    orr_diag *diag)
{
    orr_ephemeris counts = {.n_sources = s->n_sources}, *e = NULL;
    *out = NULL;
    orr_ephemeris_parts_error(p, diag);
    if (p->status != ORR_OK) return p->status;
    if (p->n > EPH_MAX_SATS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu satellites are more than a product's %d", p->n,
                            EPH_MAX_SATS);
    if (p->n > 1) qsort(p->part, p->n, sizeof(void *), by_satellite);
    count(p, &counts);
    orr_status st = orr_backing_open(p->folder, &counts.backing, diag);
    if (st != ORR_OK) return st;
    st = eph_alloc(&counts, &e, diag);
    if (st != ORR_OK) {
        orr_backing_free(counts.backing);
        return st;
    }
    e->owns_backing = true;
    append_all(p, e);
    st = eph_describe(s, e, diag);
    if (st == ORR_OK) st = eph_finish(e, diag);
    if (st != ORR_OK) {
        orr_ephemeris_free(e);
        return st;
    }
    *out = e;
    return ORR_OK;
}

void orr_ephemeris_parts_free(orr_ephemeris_parts *p)
{
    if (p == NULL) return;
    for (size_t i = 0; i < p->n; i++) orr_ephemeris_free(p->part[i]);
    free(p->part);
    orr_backing_free(p->backing);
    (void)pthread_mutex_destroy(&p->lock);
    free(p->folder);
    free(p);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The table that an SP3 file is read into: a row an epoch, a cell a satellite, both found as the file goes on.
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/sp3/sp3_private.h"

void sp3_fault_note(sp3_parser *p, sp3_fault f)
{
    if (p->fault_count[f]++ == 0) p->fault_line[f] = p->c.line;
}

void sp3_clear_records(orr_sp3_record *r, size_t n)
{
    static const orr_sp3_record missing = {
        .pos_m = {ORR_NAN, ORR_NAN, ORR_NAN},
        .clock_s = ORR_NAN,
        .vel_mps = {ORR_NAN, ORR_NAN, ORR_NAN},
        .clock_rate_sps = ORR_NAN,
        .pos_sdev_m = {ORR_NAN, ORR_NAN, ORR_NAN},
        .clock_sdev_s = ORR_NAN,
        .vel_sdev_mps = {ORR_NAN, ORR_NAN, ORR_NAN},
        .clock_rate_sdev_sps = ORR_NAN,
    };
    for (size_t i = 0; i < n; i++) r[i] = missing;
}

static void clear_correlations(orr_sp3_correlation *c, size_t n)
{
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 6; k++) c[i].p[k] = c[i].v[k] = ORR_NAN;
}

static orr_status no_memory(sp3_parser *p) { return orr_diag_set(p->diag, ORR_E_MEMORY, "out of memory"); }

orr_status sp3_set_stride(sp3_parser *p, size_t stride)
{
    orr_sp3 *o = p->out;
    orr_sp3_record *r;
    orr_sp3_correlation *c = NULL;
    size_t capacity = o->n_epochs + o->n_epochs / 2 + 1, cells = capacity * stride;
    orr_time *t = realloc(o->epoch, capacity * sizeof *t);
    if (t == NULL) return no_memory(p);
    o->epoch = t;
    r = malloc(cells * sizeof *r);
    if (o->correlation != NULL) c = malloc(cells * sizeof *c);
    if (r == NULL || (o->correlation != NULL && c == NULL)) {
        free(r);
        free(c);
        return no_memory(p);
    }
    size_t kept = stride < p->stride ? stride : p->stride;
    for (size_t e = 0; e < o->n_epochs; e++) {
        memcpy(r + e * stride, o->record + e * p->stride, kept * sizeof *r);
        sp3_clear_records(r + e * stride + kept, stride - kept);
        if (c == NULL) continue;
        memcpy(c + e * stride, o->correlation + e * p->stride, kept * sizeof *c);
        clear_correlations(c + e * stride + kept, stride - kept);
    }
    if (p->row != NULL) p->row = r + (o->n_epochs - 1) * stride;
    free(o->record);
    free(o->correlation);
    o->record = r;
    o->correlation = c;
    p->stride = stride;
    p->epoch_capacity = capacity;
    return ORR_OK;
}

int sp3_sat_index(sp3_parser *p, orr_sat sat, orr_status *st)
{
    int16_t *slot = &p->index[orr_sat_system_index(sat)][orr_sat_number(sat)];
    *st = ORR_OK;
    if (*slot >= 0) return *slot;
    orr_sp3 *o = p->out;
    if (o->n_sats >= p->limits.max_sats) {
        *st =
            orr_cursor_error(&p->c, p->diag, ORR_E_LIMIT, 0, "more than %zu satellites", p->limits.max_sats);
        return -1;
    }
    if (o->n_sats == p->sat_capacity) {
        size_t n = p->sat_capacity == 0 ? 64 : 2 * p->sat_capacity;
        orr_sat *sats = realloc(o->sat, n * sizeof *sats);
        if (sats != NULL) o->sat = sats;
        uint8_t *exps = realloc(o->accuracy_exp, n * sizeof *exps);
        if (exps != NULL) o->accuracy_exp = exps;
        uint32_t *counts = realloc(o->n_records, n * sizeof *counts);
        if (counts != NULL) o->n_records = counts;
        if (sats == NULL || exps == NULL || counts == NULL) {
            *st = no_memory(p);
            return -1;
        }
        p->sat_capacity = n;
    }
    if (o->n_epochs > 0 && o->n_sats == p->stride) {
        *st = sp3_set_stride(p, p->stride + 8 + p->stride / 4);
        if (*st != ORR_OK) return -1;
    }
    *slot = (int16_t)o->n_sats;
    o->sat[o->n_sats] = sat;
    o->accuracy_exp[o->n_sats] = 0;
    o->n_records[o->n_sats] = 0;
    return (int)o->n_sats++;
}

orr_status sp3_add_correlations(sp3_parser *p)
{
    size_t cells = p->epoch_capacity * p->stride;
    p->out->correlation = malloc(cells * sizeof *p->out->correlation);
    if (p->out->correlation == NULL) return no_memory(p);
    clear_correlations(p->out->correlation, p->out->n_epochs * p->stride);
    return ORR_OK;
}

orr_status sp3_add_epoch(sp3_parser *p, orr_time t)
{
    orr_sp3 *o = p->out;
    if (o->n_epochs >= p->limits.max_epochs)
        return orr_cursor_error(&p->c, p->diag, ORR_E_LIMIT, 0, "more than %zu epochs", p->limits.max_epochs);
    if (p->stride == 0) p->stride = o->n_sats > 0 ? o->n_sats : 8;
    // A header may list hundreds of satellites over epoch lines without records: room is given for lines that
    // are there, not for what they might mean.
    if ((o->n_epochs + 1) * p->stride > 500000 + 16 * (size_t)p->c.line)
        return orr_cursor_error(
            &p->c, p->diag, ORR_E_LIMIT, 0,
            "%zu epochs of %zu satellites by now, but hardly any records: this is no orbit file",
            o->n_epochs + 1, p->stride);
    if (o->n_epochs == p->epoch_capacity) {
        // At first as many as the rest of the text can hold if each satellite has one record of 60 columns.
        size_t n = 2 * p->epoch_capacity, rest = (size_t)(p->c.end - p->c.at);
        if (n == 0) n = rest / (60 * (o->n_sats > 0 ? o->n_sats : 1) + 30) + 2;
        orr_time *epochs = realloc(o->epoch, n * sizeof *epochs);
        if (epochs != NULL) o->epoch = epochs;
        orr_sp3_record *records = realloc(o->record, n * p->stride * sizeof *records);
        if (records != NULL) o->record = records;
        orr_sp3_correlation *correlations = o->correlation;
        if (correlations != NULL) {
            correlations = realloc(o->correlation, n * p->stride * sizeof *correlations);
            if (correlations == NULL) return no_memory(p);
            o->correlation = correlations;
        }
        if (epochs == NULL || records == NULL) return no_memory(p);
        p->epoch_capacity = n;
    }
    o->epoch[o->n_epochs] = t;
    p->row = o->record + o->n_epochs * p->stride;
    sp3_clear_records(p->row, p->stride);
    if (o->correlation != NULL) clear_correlations(o->correlation + o->n_epochs * p->stride, p->stride);
    o->n_epochs++;
    return ORR_OK;
}

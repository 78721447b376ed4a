// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/sp3/sp3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/input.h"
#include "ingest/input/sniff.h"
#include "ingest/sp3/sp3_private.h"

orr_sp3_limits orr_sp3_default_limits(void)
{
    return (orr_sp3_limits){
        .max_bytes = (size_t)1 << 31, .max_sats = 999, .max_epochs = 1000000, .max_comments = 10000};
}

static orr_status parse(sp3_parser *p)
{
    orr_view first_epoch_line = {NULL, 0};
    orr_status st = sp3_parse_header(p, &first_epoch_line);
    if (st == ORR_OK) st = sp3_parse_body(p, first_epoch_line);
    if (st == ORR_OK) st = orr_cursor_status(&p->c, p->diag);
    if (st == ORR_OK) st = sp3_finish(p);
    if (st == ORR_OK && (p->out->scale == ORR_SCALE_UTC || p->out->scale == ORR_SCALE_GLO))
        orr_leap_warn(p->out->epoch[p->out->n_epochs - 1], p->limits.leap, p->c.name, p->warnings);
    // Cells without a satellite are an affair of reading alone.
    if (st == ORR_OK && p->stride != p->out->n_sats) st = sp3_set_stride(p, p->out->n_sats);
    return st;
}

orr_status orr_sp3_parse(const char *name, const char *text, size_t n, const orr_sp3_limits *limits,
                         orr_sp3 *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_sp3){0};
    sp3_parser *p = calloc(1, sizeof *p);
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_diag own = {0};
    p->limits = limits != NULL ? *limits : orr_sp3_default_limits();
    out->leap = p->limits.leap;
    p->out = out;
    p->warnings = warnings;
    p->diag = diag != NULL ? diag : &own;
    p->header_epochs = p->header_sats = -1;
    p->header_start = ORR_TIME_NONE;
    p->header_week = p->header_sow = ORR_NAN;
    p->last_sat = -1;
    memset(p->index, 0xff, sizeof p->index);
    orr_status st = ORR_OK;
    if (n > p->limits.max_bytes) {
        st = orr_diag_at(diag, ORR_E_LIMIT, name, 0, 0,
                         "the text is longer than %zu bytes, the limit of this reader", p->limits.max_bytes);
    } else {
        orr_cursor_init(&p->c, name, text, n);
        st = parse(p);
    }
    free(p->listed);
    free(p);
    if (st != ORR_OK) orr_sp3_free(out);
    return st;
}

orr_status orr_sp3_read(const char *path, const orr_sp3_limits *limits, orr_sp3 *out, orr_warnings *warnings,
                        orr_diag *diag)
{
    *out = (orr_sp3){0};
    orr_input_limits il = orr_input_default_limits();
    il.max_bytes = limits != NULL ? limits->max_bytes : orr_sp3_default_limits().max_bytes;
    il.kinds = ORR_KIND_BIT(ORR_KIND_SP3);
    orr_bytes text;
    orr_status st = orr_input_read_all(path, &il, &text, diag);
    if (st != ORR_OK) return st;
    st = orr_sp3_parse(path, text.text, text.n, limits, out, warnings, diag);
    orr_bytes_free(&text);
    return st;
}

void orr_sp3_free(orr_sp3 *sp3)
{
    for (size_t i = 0; i < sp3->n_comments; i++) free(sp3->comment[i]);
    free(sp3->comment);
    free(sp3->sat);
    free(sp3->accuracy_exp);
    free(sp3->n_records);
    free(sp3->epoch);
    free(sp3->record);
    free(sp3->correlation);
    *sp3 = (orr_sp3){0};
}

orr_status orr_sp3_alloc(size_t n_sats, size_t n_epochs, orr_sp3 *out, orr_diag *diag)
{
    *out = (orr_sp3){0};
    const orr_sp3_limits most = orr_sp3_default_limits();
    if (n_sats == 0 || n_epochs == 0 || n_sats > most.max_sats || n_epochs > most.max_epochs)
        return orr_diag_set(diag, ORR_E_ARG,
                            "an SP3 file holds 1 to %zu satellites and 1 to %zu epochs, not %zu and %zu",
                            most.max_sats, most.max_epochs, n_sats, n_epochs);
    out->sat = calloc(n_sats, sizeof *out->sat);
    out->accuracy_exp = calloc(n_sats, sizeof *out->accuracy_exp);
    out->n_records = calloc(n_sats, sizeof *out->n_records);
    out->epoch = calloc(n_epochs, sizeof *out->epoch);
    out->record = malloc(n_sats * n_epochs * sizeof *out->record);
    if (out->sat == NULL || out->accuracy_exp == NULL || out->n_records == NULL || out->epoch == NULL ||
        out->record == NULL) {
        orr_sp3_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    out->version = 'd';
    out->scale = ORR_SCALE_GPS;
    out->n_sats = n_sats;
    out->n_epochs = n_epochs;
    sp3_clear_records(out->record, n_sats * n_epochs);
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/maps/ionex.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/maps/ionex_private.h"

void orr_ionex_free(orr_ionex *x)
{
    if (x == NULL) return;
    free(x->epoch);
    free(x->height_m);
    free(x->lat_deg);
    free(x->lon_deg);
    free(x->tec_tecu);
    free(x->rms_tecu);
    free(x->hgt_m);
    free(x->dcb);
    orr_records_free_texts(x->description, x->n_descriptions);
    orr_records_free_texts(x->comment, x->n_comments);
    *x = (orr_ionex){0};
}

// All instants of all maps, ascending, each once.
static orr_status make_epochs(ionex_reader *r)
{
    orr_ionex *x = r->out;
    size_t n = 0;
    for (int k = 0; k < IONEX_KINDS; k++) n += r->maps[k].n;
    if (n == 0) return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the file has no map");
    x->epoch = malloc(n * sizeof *x->epoch);
    if (x->epoch == NULL)
        return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for %zu epochs", n);
    n = 0;
    for (int k = 0; k < IONEX_KINDS; k++)
        for (size_t i = 0; i < r->maps[k].n; i++) x->epoch[n++] = r->maps[k].epoch[i];
    qsort(x->epoch, n, sizeof *x->epoch, orr_time_order);
    for (size_t i = 0; i < n; i++)
        if (x->n_epochs == 0 || x->epoch[i] != x->epoch[x->n_epochs - 1])
            x->epoch[x->n_epochs++] = x->epoch[i];
    return ORR_OK;
}

static size_t epoch_index(const orr_ionex *x, orr_time t)
{
    const orr_time *p = bsearch(&t, x->epoch, x->n_epochs, sizeof *x->epoch, orr_time_order);
    return (size_t)(p - x->epoch); // every map's epoch is in the list
}

// Maps of one kind in the order of epoch[]; missing ones NAN. Usually they lie so already and are taken over.
static orr_status assemble(ionex_reader *r, ionex_kind kind, double **out)
{
    orr_ionex *x = r->out;
    ionex_maps *m = &r->maps[kind];
    if (m->n == 0) return ORR_OK;
    bool in_order = m->n == x->n_epochs;
    for (size_t i = 0; in_order && i < m->n; i++) in_order = m->epoch[i] == x->epoch[i];
    if (in_order) {
        *out = m->value;
        m->value = NULL;
        return ORR_OK;
    }
    // Twice the limit's maps can be asked for here (TEC and RMS at different epochs): count again.
    if (x->n_epochs > r->limits.max_values / r->map_size)
        return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "more than %zu values of maps",
                                r->limits.max_values);
    double *v = malloc(x->n_epochs * r->map_size * sizeof *v);
    uint8_t *seen = calloc(x->n_epochs, 1);
    if (v == NULL || seen == NULL) {
        free(v);
        free(seen);
        return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for %zu maps", x->n_epochs);
    }
    for (size_t i = 0; i < x->n_epochs * r->map_size; i++) v[i] = ORR_NAN;
    bool ascending = true;
    for (size_t i = 0; i < m->n; i++) {
        size_t e = epoch_index(x, m->epoch[i]);
        if (i > 0 && m->epoch[i] < m->epoch[i - 1]) ascending = false;
        if (seen[e]) {
            char text[ORR_TIME_TEXT];
            orr_warnings_add(r->warnings, r->c.name, 0, 0, "a second %s map at %s UT is left out",
                             ionex_kind_name[kind],
                             orr_time_format(m->epoch[i], ORR_SCALE_UTC, 0, r->limits.leap, text));
            continue;
        }
        seen[e] = 1;
        memcpy(v + e * r->map_size, m->value + i * r->map_size, r->map_size * sizeof *v);
    }
    size_t without = 0;
    for (size_t e = 0; e < x->n_epochs; e++) without += !seen[e];
    free(seen);
    if (!ascending)
        orr_warnings_add(r->warnings, r->c.name, 0, 0,
                         "%s maps are not in the order of time; they were sorted", ionex_kind_name[kind]);
    if (without > 0)
        orr_warnings_add(r->warnings, r->c.name, 0, 0, "%zu of %zu epochs have no %s map", without,
                         x->n_epochs, ionex_kind_name[kind]);
    *out = v;
    return ORR_OK;
}

// The header's promises against what was there.
static orr_status check_promises(ionex_reader *r)
{
    const orr_ionex *x = r->out;
    size_t tec = r->maps[IONEX_TEC].n;
    bool fewer = r->n_maps_declared > 0 && tec < (uint64_t)r->n_maps_declared;
    if (!r->end_of_file_seen) {
        size_t rms = r->maps[IONEX_RMS].n;
        if (rms > 0 && rms < tec)
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                    "the file ends after %zu of %zu RMS maps: it is cut short", rms, tec);
        if (fewer)
            return orr_cursor_error(
                &r->c, r->diag, ORR_E_FORMAT, 0,
                "the file ends after %zu of the %lld maps its header names: it is cut short", tec,
                (long long)r->n_maps_declared);
        orr_cursor_warn(&r->c, r->warnings, 0, "the file ends without END OF FILE");
    }
    if (r->n_maps_declared >= 0 && tec != (uint64_t)r->n_maps_declared)
        orr_cursor_warn(&r->c, r->warnings, 0, "the header names %lld maps, the file has %zu",
                        (long long)r->n_maps_declared, tec);
    if (r->first_declared != ORR_TIME_NONE && r->first_declared != x->epoch[0])
        orr_cursor_warn(&r->c, r->warnings, 0, "the first map is not at the header's EPOCH OF FIRST MAP");
    if (r->last_declared != ORR_TIME_NONE && r->last_declared != x->epoch[x->n_epochs - 1])
        orr_cursor_warn(&r->c, r->warnings, 0, "the last map is not at the header's EPOCH OF LAST MAP");
    if (r->negatives > 0)
        orr_warnings_add(
            r->warnings, r->c.name, r->first_negative_line, 0,
            "%zu values of maps are negative, here the first; they are kept as written, and out of fits",
            r->negatives);
    return ORR_OK;
}

orr_status orr_ionex_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                           orr_ionex *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_ionex){0};
    ionex_reader r = {.out = out, .warnings = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    out->leap = r.limits.leap;
    orr_cursor_init(&r.c, name, text, n);
    orr_status s = ionex_read_header(&r);
    if (s == ORR_OK) s = ionex_read_maps(&r);
    if (s == ORR_OK) s = make_epochs(&r);
    if (s == ORR_OK) s = assemble(&r, IONEX_TEC, &out->tec_tecu);
    if (s == ORR_OK) s = assemble(&r, IONEX_RMS, &out->rms_tecu);
    if (s == ORR_OK) s = assemble(&r, IONEX_HGT, &out->hgt_m);
    if (s == ORR_OK) s = check_promises(&r);
    if (s == ORR_OK) orr_leap_warn(out->epoch[out->n_epochs - 1], r.limits.leap, name, warnings);
    if (s == ORR_OK && out->hgt_m != NULL) // heights are written in km
        for (size_t i = 0; i < out->n_epochs * r.map_size; i++) out->hgt_m[i] *= 1e3;
    for (int k = 0; k < IONEX_KINDS; k++) {
        free(r.maps[k].epoch);
        free(r.maps[k].number);
        free(r.maps[k].value);
    }
    if (s != ORR_OK) orr_ionex_free(out);
    return s;
}

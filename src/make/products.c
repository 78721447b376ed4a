// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/products.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/ncfile.h"
#include "ingest/input/input.h"
#include "src/make/frames.h"

orr_kind orr_product_kind(const char *path)
{
    orr_input *in;
    struct stat st; // a pipe is read once, by who wants what is in it
    if (stat(path, &st) != 0 || !S_ISREG(st.st_mode)) return ORR_KIND_UNKNOWN;
    if (orr_input_open(path, NULL, &in, NULL) != ORR_OK) return ORR_KIND_UNKNOWN;
    const orr_kind kind = orr_sniff(orr_input_head(in)).kind;
    orr_input_close(in);
    return kind;
}

orr_status orr_product_load(const char *path, orr_ephemeris **out, orr_diag *diag)
{
    const orr_status s = orr_ephemeris_load(path, out, diag);
    if (s != ORR_E_KIND || orr_nc_is_hdf5(path)) return s;
    const orr_kind kind = orr_product_kind(path);
    if (kind == ORR_KIND_SP3)
        return orr_diag_at(
            diag, s, path, 0, 0,
            "is an SP3 file, and an orbit product is wanted: `orrery orbit -o day.nc %s` makes one", path);
    if (kind != ORR_KIND_UNKNOWN)
        return orr_diag_at(diag, s, path, 0, 0,
                           "is no orbit product but %s; `orrery orbit` makes one of SP3 files",
                           orr_kind_name(kind));
    return s;
}

static orr_time begin_of(const orr_ephemeris *e)
{
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    return from;
}

static int by_begin(const void *a, const void *b)
{
    const orr_time x = begin_of(*(const orr_ephemeris *const *)a),
                   y = begin_of(*(const orr_ephemeris *const *)b);
    return (x > y) - (x < y);
}

static int by_satellite(const void *a, const void *b)
{
    const orr_sat x = *(const orr_sat *)a, y = *(const orr_sat *)b;
    return (x > y) - (x < y);
}

static orr_status gather_satellites(orr_products *p, orr_diag *diag)
{
    size_t most = 0;
    const orr_sat *list;
    for (size_t i = 0; i < p->n; i++) most += orr_ephemeris_satellites(p->item[i], &list);
    p->sat = calloc(most + 1, sizeof *p->sat);
    if (p->sat == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu satellites", most);
    size_t n = 0;
    for (size_t i = 0; i < p->n; i++) {
        const size_t more = orr_ephemeris_satellites(p->item[i], &list);
        memcpy(p->sat + n, list, more * sizeof *list);
        n += more;
    }
    qsort(p->sat, n, sizeof *p->sat, by_satellite);
    for (size_t i = 0; i < n; i++)
        if (p->n_sats == 0 || p->sat[p->n_sats - 1] != p->sat[i]) p->sat[p->n_sats++] = p->sat[i];
    return ORR_OK;
}

// What neighbours in time do not have in common.
static void look_at_joints(orr_products *p, orr_warnings *warnings)
{
    p->from = begin_of(p->item[0]);
    for (size_t i = 0; i < p->n; i++) {
        orr_time from, to;
        char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
        orr_ephemeris_span(p->item[i], &from, &to);
        if (i > 0 && from > p->to)
            orr_warnings_add(warnings, NULL, 0, 0, "no product covers %s to %s", orr_time_text(p->to, a),
                             orr_time_text(from, b));
        if (i == 0 || to > p->to) p->to = to;
        const char *frame = orr_ephemeris_frame(p->item[i]), *first = orr_ephemeris_frame(p->item[0]);
        if (i > 0 && orr_frames_differ(frame, first))
            orr_warnings_add(warnings, NULL, 0, 0,
                             "products in different frames are joined: from %s on %s, before it %s",
                             orr_time_text(from, a), frame, first);
    }
}

orr_status orr_products_open(const char *const *path, size_t n, orr_products *out, orr_warnings *warnings,
                             orr_diag *diag)
{
    *out = (orr_products){.item = calloc(n + 1, sizeof(void *)), .own = calloc(n + 1, sizeof(void *))};
    if (out->item == NULL || out->own == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu products", n);
    orr_status s = ORR_OK;
    for (; out->n < n && s == ORR_OK; out->n += s == ORR_OK) {
        s = orr_product_load(path[out->n], &out->own[out->n], diag);
        out->item[out->n] = out->own[out->n];
    }
    if (s != ORR_OK) return s;
    qsort(out->item, n, sizeof(void *), by_begin);
    look_at_joints(out, warnings);
    return gather_satellites(out, diag);
}

orr_status orr_products_of(const orr_ephemeris *e, orr_products *out, orr_diag *diag)
{
    *out = (orr_products){.n = 1, .item = calloc(1, sizeof(void *))};
    if (out->item == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a product");
    out->item[0] = e;
    look_at_joints(out, NULL);
    return gather_satellites(out, diag);
}

void orr_products_free(orr_products *p)
{
    for (size_t i = 0; p->own != NULL && i < p->n; i++) orr_ephemeris_free(p->own[i]);
    free(p->own);
    free(p->item);
    free(p->sat);
    *p = (orr_products){0};
}

const orr_ephemeris *orr_products_at(const orr_products *p, orr_time t)
{
    for (size_t i = 0; i < p->n; i++) {
        orr_time from, to;
        orr_ephemeris_span(p->item[i], &from, &to);
        if (from <= t && t <= to) return p->item[i];
    }
    return NULL;
}

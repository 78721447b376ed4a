// SPDX-License-Identifier: GPL-3.0-or-later
// What inspect tells of grids that are no maps of the ionosphere: of the troposphere and of terrain.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/inspect/inspect.h"
#include "ingest/maps/esri_grid.h"
#include "ingest/troposphere/gpt3.h"
#include "ingest/troposphere/vmf3.h"

static void tell_lattice(orr_inspection *r, const orr_lattice *l)
{
    const double south = l->lat_deg + (double)(l->n_lat - 1) * l->lat_step_deg,
                 east = l->lon_deg + (double)(l->n_lon - 1) * l->lon_step_deg;
    orr_inspect_fact_add(r, "grid", "%zu x %zu points, latitude %g to %g, longitude %g to %g deg%s", l->n_lat,
                         l->n_lon, l->lat_deg, south, l->lon_deg, east, l->around ? ", all around" : "");
    r->records = (int64_t)(l->n_lat * l->n_lon);
}

orr_status orr_inspect_gpt3(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_gpt3 x;
    orr_bytes text;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_gpt3_parse(path, text.text, text.n, NULL, &x, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    tell_lattice(r, &x.lattice);
    orr_gpt3_free(&x);
    return ORR_OK;
}

static orr_status inspect_grid(const char *path, const orr_bytes *text, const orr_read_limits *limits,
                               orr_inspection *r, orr_diag *diag)
{
    orr_vmf3_grid x;
    const orr_status s = orr_vmf3_grid_parse(path, text->text, text->n, limits, &x, diag);
    if (s != ORR_OK) return s;
    orr_inspect_epochs(r, &x.t, 1);
    tell_lattice(r, &x.lattice);
    orr_inspect_fact_add(r, "gradients", "%s", x.gradients ? "yes" : "no");
    orr_vmf3_grid_free(&x);
    return ORR_OK;
}

static orr_status inspect_sites(const char *path, const orr_bytes *text, const orr_read_limits *limits,
                                orr_inspection *r, orr_diag *diag)
{
    orr_vmf3_sites x = {.n = 0};
    const orr_status s = orr_vmf3_sites_parse(path, text->text, text->n, limits, &x, diag);
    size_t gradients = 0, first = 0;
    for (size_t k = 0; s == ORR_OK && k < x.n; k++) {
        const orr_vmf3_record *a = &x.record[k];
        if (r->from == ORR_TIME_NONE || a->t < r->from) r->from = a->t;
        if (r->to == ORR_TIME_NONE || a->t > r->to) r->to = a->t;
        gradients += isnan(a->v.north_wet_m) ? 0 : 1;
        first += a->t == x.record[0].t ? 1 : 0;
    }
    if (s == ORR_OK) {
        r->records = (int64_t)x.n;
        orr_inspect_fact_add(r, "stations", "%zu at the first instant, beginning with %s", first,
                             x.record[0].station);
        orr_inspect_fact_add(r, "gradients", "%s",
                             gradients == x.n ? "yes"
                             : gradients > 0  ? "of some"
                                              : "no");
    }
    orr_vmf3_sites_free(&x);
    return s;
}

orr_status orr_inspect_vmf3(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_bytes text;
    orr_read_limits limits = orr_read_default_limits();
    limits.leap = r->leap;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = r->kind == ORR_KIND_VMF3_GRID ? inspect_grid(path, &text, &limits, r, diag)
                                      : inspect_sites(path, &text, &limits, r, diag);
    orr_bytes_free(&text);
    return s;
}

orr_status orr_inspect_esri_grid(const char *path, orr_inspection *r, orr_diag *diag)
{
    orr_esri_grid x;
    orr_bytes text;
    float lowest = INFINITY, highest = -INFINITY;
    size_t none = 0;
    orr_status s = orr_inspect_text(r, path, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_esri_grid_parse(path, text.text, text.n, NULL, &x, diag);
    orr_bytes_free(&text);
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < x.rows * x.columns; k++) {
        lowest = fminf(lowest, x.height_m[k]); // NAN does not count
        highest = fmaxf(highest, x.height_m[k]);
        none += isnan(x.height_m[k]) ? 1 : 0;
    }
    r->records = (int64_t)(x.rows * x.columns);
    orr_inspect_fact_add(r, "grid", "%zu x %zu points, latitude %g to %g, longitude %g to %g deg", x.rows,
                         x.columns, x.north_deg, x.north_deg - (double)(x.rows - 1) * x.lat_step_deg,
                         x.west_deg, x.west_deg + (double)(x.columns - 1) * x.lon_step_deg);
    if (none < x.rows * x.columns)
        orr_inspect_fact_add(r, "heights", "%g to %g m", (double)lowest, (double)highest);
    if (none > 0) orr_inspect_fact_add(r, "no height", "%zu points", none);
    orr_esri_grid_free(&x);
    return ORR_OK;
}

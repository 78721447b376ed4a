// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the troposphere and of terrain: any bytes through each of their readers.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ingest/maps/esri_grid.h"
#include "ingest/troposphere/gpt3.h"
#include "ingest/troposphere/vmf3.h"

// A lattice holds every point that it was learnt from, and weights of a cell add up to one.
static void see(const orr_lattice *l)
{
    orr_lattice_cell c;
    if (l->n_lat < 2 || l->n_lon < 2 || !orr_lattice_find(l, l->lat_deg, l->lon_deg, &c)) {
        if (l->n_lat < 2 || l->n_lon < 2 || fabs(l->lat_deg) < 1e6) abort();
        return;
    }
    const size_t n = l->n_lat * l->n_lon;
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        sum += c.weight[k];
        if (c.at[k] >= n) abort();
    }
    if (!(fabs(sum - 1) < 1e-9)) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    const char *text = (const char *)data;
    const orr_read_limits limits = {1 << 20, 5000, 200000, NULL};
    orr_diag diag = {0};
    orr_gpt3 grid;
    orr_vmf3_grid instant;
    orr_vmf3_sites sites = {.n = 0};
    double height_m[16];
    if (orr_gpt3_parse("fuzz", text, n, &limits, &grid, &diag) == ORR_OK) {
        see(&grid.lattice);
        orr_gpt3_free(&grid);
    } else if (diag.text[0] == '\0') {
        abort(); // a refusal always says why
    }
    diag = (orr_diag){0};
    if (orr_vmf3_grid_parse("fuzz", text, n, &limits, &instant, &diag) == ORR_OK) {
        see(&instant.lattice);
        orr_vmf3_grid_free(&instant);
    } else if (diag.text[0] == '\0') {
        abort();
    }
    diag = (orr_diag){0};
    const orr_status s = orr_vmf3_sites_parse("fuzz", text, n, &limits, &sites, &diag);
    if ((s == ORR_OK) != (diag.text[0] == '\0') || (s == ORR_OK && sites.n == 0)) abort();
    orr_vmf3_sites_free(&sites);
    diag = (orr_diag){0};
    if ((orr_vmf3_heights_parse("fuzz", text, n, 16, height_m, &diag) == ORR_OK) != (diag.text[0] == '\0'))
        abort();
    diag = (orr_diag){0};
    orr_esri_grid terrain;
    if (orr_esri_grid_parse("fuzz", text, n, &limits, &terrain, &diag) == ORR_OK) {
        if (terrain.rows < 2 || terrain.columns < 2 || !(fabs(terrain.north_deg) <= 90)) abort();
        orr_esri_grid_free(&terrain);
    } else if (diag.text[0] == '\0') {
        abort();
    }
    return 0;
}

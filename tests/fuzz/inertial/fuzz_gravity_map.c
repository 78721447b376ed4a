// SPDX-License-Identifier: GPL-3.0-or-later
// NetCDF maps of gravity, as others make them, with anything in them: read, made a field, asked.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "fuzz/nc_mock.h"
#include "inertial/gravity/gravity.h"
#include "ingest/tables/gravity_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

#define KINDS 3
#define N_LAT 5
#define N_LON 6

// From South to North; from North to South, by other names; once round the Earth.
static void make(unsigned kind)
{
    const char *dims[2] = {kind == 1 ? "latitude" : "lat", kind == 1 ? "longitude" : "lon"};
    double lat[N_LAT], lon[N_LON], mgal[N_LAT * N_LON];
    for (int i = 0; i < N_LAT; i++) lat[i] = kind == 2 ? 40.0 * (i - 2) : kind == 1 ? 52 - i : 48 + i;
    for (int k = 0; k < N_LON; k++) lon[k] = kind == 2 ? 60.0 * k : 15 + k;
    for (int i = 0; i < N_LAT * N_LON; i++) mgal[i] = i % 11;
    orr_nc_writer w;
    orr_diag diag = {0};
    orr_nc_create("made map", &w, &diag);
    orr_nc_put_dim(&w, dims[0], N_LAT, &diag);
    orr_nc_put_dim(&w, dims[1], N_LON, &diag);
    orr_nc_put_var(&w, dims[0], ORR_NC_DOUBLE, 1, &dims[0], lat, "degrees_north", NULL, &diag);
    orr_nc_put_var(&w, dims[1], ORR_NC_DOUBLE, 1, &dims[1], lon, "degrees_east", NULL, &diag);
    orr_nc_put_var(&w, kind == 1 ? "gravity_disturbance" : "disturbance", ORR_NC_DOUBLE, 2, dims, mgal,
                   "mGal", NULL, &diag);
    orr_nc_put_att_text(&w, NULL, "title", "made", &diag); // an attribute for the edits that want one
    orr_nc_commit(&w, &diag);
    nc_mock_keep(kind);
}

// Reads the map and asks the field; false where it is refused.
static bool use(void)
{
    orr_gravity_file f;
    orr_diag diag = {0};
    char head[8] = {'\x89', 'H',    'D', 'F', '\r',
                    '\n',   '\x1a', '\n'}; // the reader looks at a file's first bytes before it opens it
    if (orr_gravity_file_parse("made map", head, sizeof head, &f, &diag) != ORR_OK) {
        if (diag.text[0] == '\0' || f.mgal != NULL) abort(); // a refusal says why and holds nothing
        return false;
    }
    orr_gravity_parts p = {.n_lat = f.n_lat,
                           .n_lon = f.n_lon,
                           .map_lat_rad = f.lat_rad,
                           .map_lon_rad = f.lon_rad,
                           .map_mgal = f.mgal};
    orr_gravity *g;
    const bool good = orr_gravity_make(&p, &g, &diag) == ORR_OK;
    for (int k = 0; good && k < 40; k++) {
        orr_vec3 r = orr_earth_to_ecef((orr_geodetic){0.075 * (k - 20), 0.3 * (k - 20), 1000});
        if (isnan(orr_gravity_disturbance_mgal(g, r))) abort();
    }
    if (good)
        orr_gravity_free(g);
    else if (diag.text[0] == '\0')
        abort();
    orr_gravity_file_free(&f);
    return good;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1) return 0;
    static bool made;
    for (unsigned kind = 0; !made && kind < KINDS; kind++) {
        make(kind);
        nc_mock_edit(kind, NULL, 0);
        if (!use()) abort(); // or nothing would be tried below
    }
    made = true;
    nc_mock_edit(data[0] % KINDS, data + 1, n - 1);
    (void)use();
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles and maps of gravity by anyone: read, made a field, asked.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/gravity/gravity.h"
#include "ingest/tables/gravity_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    orr_gravity_file f;
    orr_diag diag = {0};
    if (orr_gravity_file_parse("fuzz", data, n, &f, &diag) != ORR_OK) {
        if (diag.text[0] == '\0' || f.mgal != NULL) abort(); // a refusal says why and holds nothing
        return 0;
    }
    if ((f.n_profile == 0) == (f.n_lat * f.n_lon == 0)) abort();
    orr_gravity_parts p = {.n_profile = f.n_profile,
                           .profile_distance_m = f.distance_m,
                           .profile_mgal = f.mgal,
                           .n_lat = f.n_lat,
                           .n_lon = f.n_lon,
                           .map_lat_rad = f.lat_rad,
                           .map_lon_rad = f.lon_rad,
                           .map_mgal = f.mgal};
    orr_gravity *g;
    if (orr_gravity_make(&p, &g, &diag) == ORR_OK) {
        for (int k = 0; k < 20; k++) {
            orr_vec3 r = orr_earth_to_ecef((orr_geodetic){0.15 * (k - 10), 0.6 * (k - 10), 1000});
            // bounded values on ascending places; a spline between them may swing far where places nearly
            // meet
            if (isnan(orr_gravity_disturbance_mgal(g, r))) abort();
        }
        orr_gravity_free(g);
    } else if (diag.text[0] == '\0') {
        abort();
    }
    orr_gravity_file_free(&f);
    return 0;
}

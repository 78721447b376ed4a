// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario's gravity. What a made disturbance is under home, it is under a transferred flight.
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/polar.h"
#include "ingest/tables/gravity_file.h"
#include "src/make/moving_private.h"

static const double DEG = ORR_RAD_PER_DEG;

// A profile in the scenario, or the place of one in a file.
static void add_profile(const orr_scenario_profile *q, orr_gravity_parts *p)
{
    p->profile_lat_rad = q->lat_deg * DEG;
    p->profile_lon_rad = q->lon_deg * DEG;
    p->profile_azimuth_rad = q->azimuth_deg * DEG;
    p->n_profile = q->distance_m.n;
    p->profile_distance_m = q->distance_m.item;
    p->profile_mgal = q->mgal.item;
}

static orr_status add_file(const orr_scenario_gravity *g, const orr_gravity_file *file, orr_gravity_parts *p,
                           orr_diag *diag)
{
    if (file->n_profile > 0) {
        if (!g->has_profile)
            return orr_diag_at(diag, ORR_E_FORMAT, g->file, 0, 0,
                               "is a profile: gravity.profile has to tell its lat, lon and azimuth");
        if (p->n_profile > 0)
            return orr_diag_at(diag, ORR_E_FORMAT, g->file, 0, 0,
                               "is a profile, and gravity.profile has distances of its own: one of them is "
                               "possible");
        p->n_profile = file->n_profile;
        p->profile_distance_m = file->distance_m;
        p->profile_mgal = file->mgal;
        return ORR_OK;
    }
    if (g->has_profile && p->n_profile == 0)
        return orr_diag_at(diag, ORR_E_FORMAT, g->file, 0, 0,
                           "is a map: gravity.profile has no effect without distance and mgal");
    p->n_lat = file->n_lat;
    p->n_lon = file->n_lon;
    p->map_lat_rad = file->lat_rad;
    p->map_lon_rad = file->lon_rad;
    p->map_mgal = file->mgal;
    return ORR_OK;
}

static orr_status make_masses(const orr_scenario_gravity *g, const orr_mat3 *C, orr_point_mass **out,
                              orr_diag *diag)
{
    *out = NULL;
    if (g->masses.n == 0) return ORR_OK;
    orr_point_mass *mass = malloc(g->masses.n * sizeof *mass);
    if (mass == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t k = 0; k < g->masses.n; k++) {
        const orr_scenario_mass *q = &g->masses.item[k];
        orr_geodetic at = {q->lat_deg * DEG, q->lon_deg * DEG, q->height_m};
        orr_vec3 r_m = orr_earth_to_ecef(at);
        mass[k] = (orr_point_mass){C != NULL ? orr_polar_place(C, r_m) : r_m, q->gm_m3ps2};
    }
    *out = mass;
    return ORR_OK;
}

orr_status moving_make_gravity(const orr_scenario_gravity *g, const orr_mat3 *C, orr_moving *out,
                               orr_diag *diag)
{
    orr_gravity_parts p = {0};
    orr_gravity_file file;
    memset(&file, 0, sizeof file);
    orr_point_mass *mass = NULL;
    orr_status s = ORR_OK;
    if (g->model != NULL) {
        s = orr_gravity_model_open(g->model, g->folder, &out->model, diag);
        p.model = out->model;
    }
    if (g->has_profile) add_profile(&g->profile, &p);
    if (s == ORR_OK && g->file != NULL) {
        orr_bytes raw;
        s = orr_inputs_read_raw(&out->inputs, g->file, 0, &raw, diag);
        if (s == ORR_OK) s = orr_gravity_file_parse(g->file, raw.text, raw.n, &file, diag);
        orr_bytes_free(&raw);
        if (s == ORR_OK) s = add_file(g, &file, &p, diag);
    }
    if (s == ORR_OK) s = make_masses(g, C, &mass, diag);
    p.n_masses = g->masses.n;
    p.mass = mass;
    p.carried = C != NULL;
    if (C != NULL) p.carried_by = *C;
    if (s == ORR_OK && (p.model != NULL || p.n_profile + p.n_lat + p.n_masses > 0))
        s = orr_gravity_make(&p, &out->gravity, diag);
    if (s == ORR_OK) s = orr_gravity_covers(out->gravity, &out->trajectory, diag);
    orr_gravity_file_free(&file);
    free(mass);
    return s;
}

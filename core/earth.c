// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/earth.h"

#include <stdio.h>
#include <stdlib.h>

#include "core/earth_shim.h"

orr_vec3 orr_earth_to_ecef(orr_geodetic g)
{
    double r[3];
    orr_shim_forward(g.lat_rad * ORR_DEG_PER_RAD, g.lon_rad * ORR_DEG_PER_RAD, g.height_m, r);
    return (orr_vec3){r[0], r[1], r[2]};
}

orr_geodetic orr_earth_from_ecef(orr_vec3 r_m)
{
    double lat, lon, height;
    orr_shim_reverse((double[3]){r_m.x, r_m.y, r_m.z}, &lat, &lon, &height);
    if (lon <= -180.0) lon += 360.0; // GeographicLib keeps -180 for y = -0.0
    return (orr_geodetic){lat * ORR_RAD_PER_DEG, lon * ORR_RAD_PER_DEG, height};
}

orr_vec3 orr_earth_up(orr_vec3 r_m)
{
    const double b_m = ORR_WGS84_A_M * (1.0 - ORR_WGS84_F), e2_a = ORR_WGS84_E2 * ORR_WGS84_A_M,
                 ep2_b = ORR_WGS84_E2 / (1.0 - ORR_WGS84_E2) * b_m;
    double p = sqrt(r_m.x * r_m.x + r_m.y * r_m.y);
    if (!(p > 0.0)) return (orr_vec3){0.0, 0.0, r_m.z < 0.0 ? -1.0 : 1.0};
    // The tangent of the parametric latitude as a quotient s / c, then that of the geodetic one as z / x.
    double x = p * (1.0 - ORR_WGS84_E2), z = r_m.z;
    for (int k = 0; k < 2; k++) {
        double c = x, s = z * (1.0 - ORR_WGS84_F), n = 1.0 / sqrt(c * c + s * s);
        c *= n;
        s *= n;
        x = p - e2_a * c * c * c;
        z = r_m.z + ep2_b * s * s * s;
    }
    double n = 1.0 / sqrt(x * x + z * z), level = x * n / p;
    return (orr_vec3){r_m.x * level, r_m.y * level, z * n};
}

orr_mat3 orr_earth_enu_from_ecef(double lat_rad, double lon_rad)
{
    double sp = sin(lat_rad), cp = cos(lat_rad), sl = sin(lon_rad), cl = cos(lon_rad);
    return (orr_mat3){{{-sl, cl, 0}, {-sp * cl, -sp * sl, cp}, {cp * cl, cp * sl, sp}}};
}

void orr_earth_radii(double lat_rad, double *meridian_m, double *normal_m)
{
    double s = sin(lat_rad), w2 = 1.0 - ORR_WGS84_E2 * s * s, w = sqrt(w2);
    *normal_m = ORR_WGS84_A_M / w;
    *meridian_m = ORR_WGS84_A_M * (1.0 - ORR_WGS84_E2) / (w2 * w);
}

void orr_earth_look(orr_vec3 site_m, orr_vec3 target_m, double *az_rad, double *el_rad, double *range_m)
{
    orr_geodetic g = orr_earth_from_ecef(site_m);
    orr_mat3 a = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    orr_vec3 enu = orr_mat3_apply(&a, orr_vec3_sub(target_m, site_m));
    double az = atan2(enu.x, enu.y);
    if (az < 0) az += 2 * ORR_PI;
    *az_rad = az < 2 * ORR_PI ? az : 0.0; // a tiny negative angle rounds up to the full circle
    *el_rad = atan2(enu.z, hypot(enu.x, enu.y));
    *range_m = orr_vec3_norm(enu);
}

orr_vec3 orr_earth_normal_gravitation(orr_vec3 r_m)
{
    double g[3];
    orr_shim_normal_gravitation((double[3]){r_m.x, r_m.y, r_m.z}, g);
    return (orr_vec3){g[0], g[1], g[2]};
}

void orr_earth_geodesic_direct(double lat1_rad, double lon1_rad, double az1_rad, double dist_m,
                               double *lat2_rad, double *lon2_rad, double *az2_rad)
{
    double lat2, lon2, az2;
    orr_shim_geodesic_direct(lat1_rad * ORR_DEG_PER_RAD, lon1_rad * ORR_DEG_PER_RAD,
                             az1_rad * ORR_DEG_PER_RAD, dist_m, &lat2, &lon2, &az2);
    *lat2_rad = lat2 * ORR_RAD_PER_DEG;
    *lon2_rad = lon2 * ORR_RAD_PER_DEG;
    *az2_rad = az2 * ORR_RAD_PER_DEG;
}

struct orr_gravity_model {
    void *shim;
};

orr_status orr_gravity_model_open(const char *name, const char *dir, orr_gravity_model **out, orr_diag *diag)
{
    return orr_gravity_model_open_to(name, dir, -1, out, diag);
}

orr_status orr_gravity_model_open_to(const char *name, const char *dir, int degree, orr_gravity_model **out,
                                     orr_diag *diag)
{
    *out = NULL;
    orr_gravity_model *m = malloc(sizeof *m);
    if (m == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for gravity model %s", name);
    char why[300];
    int no_memory;
    m->shim = orr_shim_gravity_open(name, dir != NULL ? dir : "", degree, why, sizeof why, &no_memory);
    if (m->shim == NULL) {
        free(m);
        return orr_diag_set(diag, no_memory ? ORR_E_MEMORY : ORR_E_IO, "gravity model %s in %s%s: %s", name,
                            dir != NULL ? "folder " : "GeographicLib's own folder", dir != NULL ? dir : "",
                            why);
    }
    *out = m;
    return ORR_OK;
}

orr_vec3 orr_gravity_model_gravitation(const orr_gravity_model *m, orr_vec3 r_m)
{
    double g[3];
    orr_shim_gravity(m->shim, (double[3]){r_m.x, r_m.y, r_m.z}, g);
    return (orr_vec3){g[0], g[1], g[2]};
}

int orr_gravity_model_degree(const orr_gravity_model *m) { return orr_shim_gravity_degree(m->shim); }

void orr_gravity_model_file(const orr_gravity_model *m, char *path, size_t n)
{
    orr_shim_gravity_file(m->shim, path, n);
}

void orr_gravity_model_free(orr_gravity_model *m)
{
    if (m == NULL) return;
    orr_shim_gravity_free(m->shim);
    free(m);
}

struct orr_geoid {
    void *shim;
    char name[32];
};

orr_status orr_geoid_open(const char *name, const char *dir, orr_geoid **out, orr_diag *diag)
{
    // GeographicLib's default first, which is that of most receivers, then by rising error of interpolation.
    static const char *const usual[] = {"egm96-5",   "egm96-15", "egm2008-1", "egm2008-2_5",
                                        "egm2008-5", "egm84-15", "egm84-30"};
    *out = NULL;
    orr_geoid *g = calloc(1, sizeof *g);
    if (g == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a geoid");
    char why[300] = "";
    int no_memory = 0;
    for (size_t k = 0; g->shim == NULL && k < (name != NULL ? 1 : sizeof usual / sizeof usual[0]); k++) {
        snprintf(g->name, sizeof g->name, "%s", name != NULL ? name : usual[k]);
        g->shim = orr_shim_geoid_open(g->name, dir != NULL ? dir : "", why, sizeof why, &no_memory);
    }
    if (g->shim == NULL) {
        free(g);
        return orr_diag_set(diag, no_memory ? ORR_E_MEMORY : ORR_E_IO, "geoid %s in %s%s: %s",
                            name != NULL ? name : "of any name",
                            dir != NULL ? "folder " : "GeographicLib's own folder", dir != NULL ? dir : "",
                            why);
    }
    *out = g;
    return ORR_OK;
}

double orr_geoid_height_m(const orr_geoid *g, double lat_rad, double lon_rad)
{
    return orr_shim_geoid_height(g->shim, lat_rad * ORR_DEG_PER_RAD, lon_rad * ORR_DEG_PER_RAD);
}

const char *orr_geoid_name(const orr_geoid *g) { return g->name; }

void orr_geoid_free(orr_geoid *g)
{
    if (g == NULL) return;
    orr_shim_geoid_free(g->shim);
    free(g);
}

struct orr_magnetic {
    void *shim;
};

orr_status orr_magnetic_open(const char *name, const char *dir, orr_magnetic **out, orr_diag *diag)
{
    char why[300] = "";
    int no_memory = 0;
    *out = calloc(1, sizeof **out);
    if (*out == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a magnetic model");
    (*out)->shim = orr_shim_magnetic_open(name, dir != NULL ? dir : "", why, sizeof why, &no_memory);
    if ((*out)->shim != NULL) return ORR_OK;
    free(*out);
    *out = NULL;
    return orr_diag_set(diag, no_memory ? ORR_E_MEMORY : ORR_E_IO, "magnetic model %s in %s%s: %s", name,
                        dir != NULL ? "folder " : "GeographicLib's own folder", dir != NULL ? dir : "", why);
}

// -grad of a (a/r)^2 (m . r/|r|), a = 6371.2 km: (a/r)^3 (3 (m . u) u - m), ecef axes.
static orr_vec3 dipole_nt(double year, orr_vec3 r_m)
{
    const double t = year - 2020.0, a = 6371.2e3, r = orr_vec3_norm(r_m), k = a / r;
    const orr_vec3 m = orr_vec3_make(-1450.9 + 7.4 * t, 4652.5 - 25.9 * t, -29404.8 + 5.7 * t),
                   u = orr_vec3_scale(1.0 / r, r_m);
    return orr_vec3_scale(k * k * k, orr_vec3_sub(orr_vec3_scale(3.0 * orr_vec3_dot(m, u), u), m));
}

orr_vec3 orr_magnetic_field_nt(const orr_magnetic *m, double year, orr_geodetic place)
{
    if (m == NULL) {
        const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
        return orr_mat3_apply(&enu, dipole_nt(year, orr_earth_to_ecef(place)));
    }
    double b[3];
    orr_shim_magnetic_field(m->shim, year, place.lat_rad * ORR_DEG_PER_RAD, place.lon_rad * ORR_DEG_PER_RAD,
                            place.height_m, b);
    return orr_vec3_make(b[0], b[1], b[2]);
}

void orr_magnetic_free(orr_magnetic *m)
{
    if (m == NULL) return;
    orr_shim_magnetic_free(m->shim);
    free(m);
}

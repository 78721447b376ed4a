// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/field/pierce.h"
#include "core/nan.h"

#include <math.h>
#include <string.h>

orr_status orr_iono_site_at(orr_vec3 pos_m, orr_iono_site *out, orr_diag *diag)
{
    if (!(orr_vec3_norm(pos_m) > 6.2e6))
        return orr_diag_set(diag, ORR_E_ARG, "a receiver at (%.1f, %.1f, %.1f) m is not on the Earth",
                            pos_m.x, pos_m.y, pos_m.z);
    orr_geodetic g = orr_earth_from_ecef(pos_m);
    orr_mat3 a = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    *out = (orr_iono_site){pos_m,
                           {a.m[0][0], a.m[0][1], a.m[0][2]},
                           {a.m[1][0], a.m[1][1], a.m[1][2]},
                           {a.m[2][0], a.m[2][1], a.m[2][2]},
                           g};
    return ORR_OK;
}

static orr_status along(const orr_iono_site *site, orr_vec3 dir, double radius, orr_pierce *out,
                        orr_diag *diag)
{
    double e = orr_vec3_dot(dir, site->east), n = orr_vec3_dot(dir, site->north),
           u = orr_vec3_dot(dir, site->up);
    if (!(u >= -1e-12)) // a direction at the horizon, rounded
        return orr_diag_set(diag, ORR_E_RANGE, "the satellite is %.2f degrees below the horizon",
                            -asin(u < -1 ? -1 : u) * ORR_DEG_PER_RAD);
    double along = orr_vec3_dot(dir, site->pos_m), r2 = orr_vec3_dot(site->pos_m, site->pos_m);
    double below = radius * radius - r2;
    if (!(below > 0))
        return orr_diag_set(diag, ORR_E_RANGE,
                            "the receiver is %.0f km from the Earth's centre, above the shell of %.0f km",
                            sqrt(r2) / 1e3, radius / 1e3);
    double s = sqrt(along * along + below) - along; // the one root ahead of a receiver inside the sphere
    orr_vec3 p = orr_vec3_scale(1 / radius, orr_vec3_axpy(s, dir, site->pos_m));
    double az = atan2(e, n);
    out->az_rad = az < 0 ? az + 2 * ORR_PI : az;
    out->el_rad = atan2(u > 0 ? u : 0, sqrt(e * e + n * n));
    out->lat_rad = atan2(p.z, sqrt(p.x * p.x + p.y * p.y));
    out->lon_rad = atan2(p.y, p.x);
    out->unit = p;
    return ORR_OK;
}

orr_status orr_pierce_ray(const orr_iono_site *site, orr_vec3 sat_m, double shell_radius_m, orr_pierce *out,
                          orr_diag *diag)
{
    return along(site, orr_vec3_unit(orr_vec3_sub(sat_m, site->pos_m)), shell_radius_m, out, diag);
}

orr_status orr_pierce_direction(const orr_iono_site *site, double az_rad, double el_rad,
                                double shell_radius_m, orr_pierce *out, orr_diag *diag)
{
    double ce = cos(el_rad), se = sin(el_rad);
    orr_vec3 d = orr_vec3_scale(se, site->up);
    d = orr_vec3_axpy(ce * sin(az_rad), site->east, d);
    d = orr_vec3_axpy(ce * cos(az_rad), site->north, d);
    return along(site, d, shell_radius_m, out, diag);
}

orr_mapping orr_mapping_published(orr_mapping_kind kind)
{
    const double radius_km = ORR_EARTH_MEAN_RADIUS_M / 1e3;
    switch (kind) {
    case ORR_MAPPING_THIN_SHELL:
        return (orr_mapping){kind, radius_km / (radius_km + 450.0), 1};
    case ORR_MAPPING_MSLM:
        return (orr_mapping){kind, radius_km / (radius_km + 506.7), 0.9782};
    case ORR_MAPPING_NONE:
        break;
    }
    return (orr_mapping){ORR_MAPPING_NONE, 0, 1};
}

static const char *const MAPPING_NAMES[] = {"none", "thin-shell", "mslm"};

orr_status orr_mapping_parse(const char *name, orr_mapping_kind *out, orr_diag *diag)
{
    for (int i = 0; i < 3; i++)
        if (strcmp(name, MAPPING_NAMES[i]) == 0) {
            *out = (orr_mapping_kind)i;
            return ORR_OK;
        }
    return orr_diag_set(diag, ORR_E_ARG, "\"%s\" is no mapping function; there are none, thin-shell and mslm",
                        name);
}

double orr_mapping_factor(const orr_mapping *m, double el_rad)
{
    if (!(el_rad >= 0 && el_rad <= ORR_PI / 2)) return ORR_NAN;
    if (m->kind == ORR_MAPPING_NONE) return 1;
    double s = m->alpha == 1 ? m->ratio * cos(el_rad) : m->ratio * sin(m->alpha * (ORR_PI / 2 - el_rad));
    return 1 / sqrt(1 - s * s);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A ray from a receiver to a satellite. Those of receivers in space have what each kind of field can say of them. NeQuick-G has a density at every height and is integrated
// along the way. All others have their electrons on one shell: a ray has what it meets where it crosses it, none from above it
// upward, once from below it, twice where it goes down through it and up again.
#include <math.h>

#include "core/earth.h"
#include "core/limb.h"
#include "core/nan.h"
#include "iono/field/tec_field_private.h"

// Where a ray from a place meets a sphere: distances, ascending, ahead of the place and this side of the end.
static int crossings(orr_vec3 from_m, orr_vec3 along, double length_m, double radius_m, double at_m[2])
{
    const double b = orr_vec3_dot(from_m, along), c = orr_vec3_dot(from_m, from_m) - radius_m * radius_m;
    const double square = b * b - c;
    int n = 0;
    if (!(square > 0)) return 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double s = -b + sign * sqrt(square);
        if (s > 0 && s < length_m) at_m[n++] = s;
    }
    return n;
}

static orr_pierce pierce_at(orr_vec3 point_m, double az_rad, double el_rad)
{
    const orr_vec3 p = orr_vec3_unit(point_m);
    return (orr_pierce){az_rad, el_rad, atan2(p.z, sqrt(p.x * p.x + p.y * p.y)), atan2(p.y, p.x), p};
}

static orr_status along_shell(const orr_tec_instant *at, orr_vec3 from_m, orr_vec3 along, double length_m,
                              orr_tec_ray *out, orr_diag *diag)
{
    const double radius = at->field->shell_radius_m;
    double s_m[2], square = 0;
    const int n = crossings(from_m, along, length_m, radius, s_m);
    if (n == 0) return ORR_OK;
    for (int k = 0; k < n; k++) {
        const orr_pierce p =
            pierce_at(orr_vec3_axpy(s_m[k], along, from_m), out->pierce.az_rad, out->pierce.el_rad);
        const double factor =
            1 / fmax(fabs(orr_vec3_dot(p.unit, along)), 1e-3); // where it grazes the shell, a thousandfold
        orr_tec_value v;
        const orr_status s = orr_tec_vertical(at, p.unit, &v, diag);
        if (s != ORR_OK) return s;
        if (k == 0) {
            out->pierce = p;
            out->vtec_tecu = v.vtec_tecu;
        }
        out->mapping += factor;
        out->stec_tecu += factor * v.vtec_tecu;
        out->flags |= v.flags;
        square += factor * factor * v.sigma_tecu * v.sigma_tecu;
    }
    out->sigma_tecu = sqrt(square);
    return ORR_OK;
}

static orr_status from_space(const orr_tec_instant *at, const orr_iono_site *site, orr_vec3 sat_m,
                             orr_tec_ray *out, orr_diag *diag)
{
    const orr_tec_field *f = at->field;
    const orr_vec3 way = orr_vec3_sub(sat_m, site->pos_m), along = orr_vec3_unit(way);
    const double east = orr_vec3_dot(along, site->east), north = orr_vec3_dot(along, site->north),
                 up = orr_vec3_dot(along, site->up), az = atan2(east, north);
    if (orr_limb_hides(site->pos_m, sat_m, ORR_SPACE_HEIGHT_M))
        return orr_diag_set(diag, ORR_E_RANGE, "the ray passes lower than %.0f km above the Earth",
                            ORR_SPACE_HEIGHT_M / 1e3);
    *out = (orr_tec_ray){
        .pierce = pierce_at(site->pos_m, az < 0 ? az + 2 * ORR_PI : az, atan2(up, hypot(east, north)))};
    if (f->kind != TEC_BROADCAST || f->algorithm != ORR_TEC_NEQUICK)
        return along_shell(at, site->pos_m, along, orr_vec3_norm(way), out, diag);
    out->sigma_tecu = ORR_NAN;
    out->stec_tecu = orr_nequick_path_tecu(f->nequick, f->set[at->i0].value, at->t, f->options.leap,
                                           site->geodetic, orr_earth_from_ecef(sat_m));
    if (isnan(out->stec_tecu))
        return orr_diag_set(diag, ORR_E_NODATA, "%s: its model says nothing along this ray", f->source);
    orr_tec_value v;
    const orr_status s = orr_tec_vertical(at, out->pierce.unit, &v, diag);
    if (s != ORR_OK) return s;
    out->vtec_tecu = v.vtec_tecu;
    if (v.vtec_tecu > 0) out->mapping = out->stec_tecu / v.vtec_tecu;
    return ORR_OK;
}

orr_status orr_tec_look(const orr_tec_instant *at, const orr_iono_site *site, orr_vec3 sat_m,
                        orr_tec_ray *out, orr_diag *diag)
{
    orr_pierce p;
    if (orr_limb_in_space(site->pos_m)) return from_space(at, site, sat_m, out, diag);
    const orr_status s = orr_pierce_ray(site, sat_m, at->field->shell_radius_m, &p, diag);
    return s == ORR_OK ? orr_tec_look_through(at, site, &p, out, diag) : s;
}

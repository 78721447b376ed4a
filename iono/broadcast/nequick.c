// SPDX-License-Identifier: GPL-3.0-or-later
// NeQuick-G along a ray: the straight line's geometry on a sphere of 6371.2 km, and the integral by Gauss and Kronrod.
#include "iono/broadcast/nequick.h"

#include <math.h>

#include "core/nan.h"
#include "core/vec.h"
#include "iono/broadcast/nequick_private.h"

#define EARTH_KM 6371.2
#define MOST_HALVINGS 12

// The ray, by the distance from the point nearest to the Earth's centre.
typedef struct ray {
    const neq_epoch *epoch;
    orr_vec3 foot_km, along;
    bool vertical;
    neq_profile profile; // of a vertical ray: one over its place
} ray;

static double density_at(const ray *r, double s_km)
{
    if (r->vertical) return neq_density(&r->profile, s_km - EARTH_KM);
    const orr_vec3 x = orr_vec3_axpy(s_km, r->along, r->foot_km);
    const double size = orr_vec3_norm(x);
    neq_profile p;
    neq_profile_at(r->epoch, asin(x.z / size) * ORR_DEG_PER_RAD, atan2(x.y, x.x) * ORR_DEG_PER_RAD, &p);
    return neq_density(&p, size - EARTH_KM);
}

// The integral from a to b, 1e11 km / m^3: fifteen points of Kronrod against seven of Gauss, halved until they agree.
static double integral(const ray *r, double a, double b, double tolerance, int halvings)
{
    static const double x[8] = {0.991455371120812639206, 0.949107912342758524526,
                                0.864864423359769072789, 0.741531185599394439863,
                                0.586087235467691130294, 0.405845151377397166907,
                                0.207784955007898467600, 0},
                        wk[8] = {0.022935322010529224963, 0.063092092629978553290, 0.104790010322250183839,
                                 0.140653259715525918745, 0.169004726639267902826, 0.190350578064785409913,
                                 0.204432940075298892414, 0.209482141084727828012},
                        wg[4] = {0.129484966168869693270, 0.279705391489276667901, 0.381830050505118944950,
                                 0.417959183673469387755};
    const double half = (b - a) / 2, middle = (a + b) / 2;
    double kronrod = 0, gauss = 0;
    for (int i = 0; i < 8; i++) {
        const double f = i < 7 ? density_at(r, middle - half * x[i]) + density_at(r, middle + half * x[i])
                               : density_at(r, middle);
        kronrod += wk[i] * f;
        if (i % 2 == 1) gauss += wg[i / 2] * f;
    }
    if (fabs(kronrod - gauss) <= tolerance * fabs(kronrod) || fabs(kronrod - gauss) * half < 1e-5 ||
        halvings == 0)
        return kronrod * half;
    return integral(r, a, middle, tolerance, halvings - 1) + integral(r, middle, b, tolerance, halvings - 1);
}

static orr_vec3 on_sphere_km(orr_geodetic g)
{
    const double size = EARTH_KM + g.height_m / 1e3, c = cos(g.lat_rad) * size;
    return (orr_vec3){c * cos(g.lon_rad), c * sin(g.lon_rad), size * sin(g.lat_rad)};
}

orr_geodetic orr_nequick_upper_end(orr_geodetic site, double az_rad, double el_rad, double height_m)
{
    const double low = EARTH_KM + site.height_m / 1e3, high = EARTH_KM + height_m / 1e3;
    const double psi = ORR_PI / 2 - el_rad - asin(low / high * cos(el_rad));
    const double sin_lat = sin(site.lat_rad) * cos(psi) + cos(site.lat_rad) * sin(psi) * cos(az_rad);
    const double lon = site.lon_rad + atan2(sin(psi) * sin(az_rad) * cos(site.lat_rad),
                                            cos(psi) - sin(site.lat_rad) * sin_lat);
    return (orr_geodetic){asin(fmin(1, fmax(-1, sin_lat))), lon, height_m};
}

// The integral between two points on the ray, TECU: below 1000 km, below 2000 km and above, as the description divides it, on
// either side of the point nearest to the Earth.
static double content(const ray *r, double from, double to)
{
    static const double edge_km[2] = {EARTH_KM + 1000, EARTH_KM + 2000};
    const double foot2 = orr_vec3_dot(r->foot_km, r->foot_km);
    double half[2], sum = 0;
    for (int i = 0; i < 2; i++) half[i] = sqrt(fmax(edge_km[i] * edge_km[i] - foot2, 0));
    const double end[6] = {-half[1], -half[0], 0, half[0], half[1], to};
    for (int i = 0; i < 6 && from < to; i++) {
        const double here = fmin(end[i], to);
        if (!(here > from)) continue;
        sum += integral(r, from, here, i == 2 || i == 3 ? 1e-3 : 1e-2, MOST_HALVINGS);
        from = here;
    }
    return sum * 1e11 * 1e3 / 1e16;
}

double orr_nequick_path_tecu(const orr_nequick *n, const double ai[3], orr_time t, const orr_leap_table *leap,
                             orr_geodetic site, orr_geodetic sat)
{
    orr_civil utc;
    orr_time_to_civil(t, ORR_SCALE_UTC, leap, &utc);
    const double hour = utc.hour + utc.minute / 60.0 + (utc.second + utc.ns * 1e-9) / 3600;
    const double lat_deg = site.lat_rad * ORR_DEG_PER_RAD, lon_deg = site.lon_rad * ORR_DEG_PER_RAD;
    neq_epoch epoch;
    neq_epoch_init(n, utc.month, hour, neq_ionisation(ai, neq_modip_deg(n, lat_deg, lon_deg)), &epoch);

    const orr_vec3 low = on_sphere_km(site), high = on_sphere_km(sat);
    ray r = {.epoch = &epoch, .along = orr_vec3_unit(orr_vec3_sub(high, low))};
    const double from = orr_vec3_dot(low, r.along), to = orr_vec3_dot(high, r.along);
    r.foot_km = orr_vec3_axpy(-from, r.along, low);
    const double foot2 = orr_vec3_dot(r.foot_km, r.foot_km);
    if (from < 0 && to > 0 && foot2 < EARTH_KM * EARTH_KM) return ORR_NAN;
    if (from > 0 && foot2 < 0.01) { // straight up
        r.vertical = true;
        neq_profile_at(&epoch, lat_deg, lon_deg, &r.profile);
    }
    return content(&r, from, to);
}

double orr_nequick_slant_tecu(const orr_nequick *n, const double ai[3], orr_time t,
                              const orr_leap_table *leap, orr_geodetic site, orr_geodetic sat)
{
    const orr_vec3 low = on_sphere_km(site), high = on_sphere_km(sat);
    if (!(orr_vec3_norm(high) > orr_vec3_norm(low)) || !(orr_vec3_dot(low, orr_vec3_sub(high, low)) > 0))
        return ORR_NAN;
    return orr_nequick_path_tecu(n, ai, t, leap, site, sat);
}

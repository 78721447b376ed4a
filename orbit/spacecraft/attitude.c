// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/spacecraft/attitude.h"

#define SLOWEST_TURN_RADPS (0.10 * ORR_RAD_PER_DEG)

orr_vec3 orr_attitude_sun(orr_time t, const orr_eop_series *series)
{
    orr_mat3 R;
    orr_eop eop = orr_eop_at(series, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, NULL);
    return orr_mat3_apply(&R, orr_astro_sun(t));
}

static void set_body(orr_vec3 x, orr_vec3 y, orr_vec3 z, orr_attitude *out)
{
    out->body = (orr_mat3){{{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}}};
}

orr_status orr_attitude_nominal(orr_vec3 r, orr_vec3 v, orr_vec3 sun, orr_attitude *out)
{
    orr_vec3 z = orr_vec3_scale(-1, orr_vec3_unit(r)), to_sun = orr_vec3_unit(orr_vec3_sub(sun, r));
    orr_vec3 y = orr_vec3_cross(z, to_sun), normal = orr_vec3_unit(orr_vec3_cross(r, v));
    if (!(orr_vec3_norm(y) > 1e-9)) return ORR_E_NUMERIC;
    y = orr_vec3_unit(y);
    orr_vec3 x = orr_vec3_cross(y, z), along = orr_vec3_cross(normal, orr_vec3_unit(r));
    set_body(x, y, z, out);
    orr_vec3 s = orr_vec3_unit(sun);
    out->beta_rad = asin(orr_vec3_dot(s, normal));
    // About Z (down), along-track turned by yaw gives X; Z x along is the direction of positive yaw.
    out->yaw_rad = atan2(orr_vec3_dot(x, orr_vec3_cross(z, along)), orr_vec3_dot(x, along));
    // tan(yaw) = -tan(beta) / sin(mu), mu from midnight, grows by n.
    const double n = orr_vec3_norm(orr_vec3_cross(r, v)) / orr_vec3_dot(r, r);
    const double across = tan(out->beta_rad);
    const double sin_mu = -orr_vec3_dot(s, along) / cos(out->beta_rad);
    const double cos_mu = -orr_vec3_dot(s, orr_vec3_unit(r)) / cos(out->beta_rad);
    out->yaw_rate_radps = n * across * cos_mu / (sin_mu * sin_mu + across * across);
    const bool too_fast = n > SLOWEST_TURN_RADPS * fabs(across);
    out->fast_turn = too_fast && fabs(asin(fmin(1, fabs(sin_mu)))) < n * ORR_PI / SLOWEST_TURN_RADPS;
    out->sunlight = orr_force_sunlight(r, sun);
    return ORR_OK;
}

void orr_attitude_orbit_normal(orr_vec3 r, orr_vec3 v, orr_vec3 sun, orr_attitude *out)
{
    const orr_vec3 z = orr_vec3_scale(-1, orr_vec3_unit(r)), normal = orr_vec3_unit(orr_vec3_cross(r, v));
    *out = (orr_attitude){.beta_rad = asin(orr_vec3_dot(orr_vec3_unit(sun), normal)),
                          .sunlight = orr_force_sunlight(r, sun)};
    set_body(orr_vec3_cross(normal, orr_vec3_unit(r)), orr_vec3_scale(-1, normal), z, out);
}

const orr_antenna_pair *orr_antenna_pair_of(char system)
{
    static const orr_antenna_pair pairs[] = {
        {"G01", "G02", 1575.42e6, 1227.60e6}, {"R01", "R02", 1602.0e6, 1246.0e6},
        {"E01", "E05", 1575.42e6, 1176.45e6}, {"C02", "C06", 1561.098e6, 1268.52e6},
        {"J01", "J02", 1575.42e6, 1227.60e6}, {"I05", "I09", 1176.45e6, 2492.028e6},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        if (pairs[i].code1[0] == system) return &pairs[i];
    return NULL;
}

orr_status orr_antenna_offset_body(const orr_antex_antenna *antenna, const char *code1, double f1,
                                   const char *code2, double f2, double offset_m[3])
{
    const orr_antex_frequency *a = orr_antex_find_frequency(antenna, code1), *b = NULL;
    double w = 1;
    if (code2 != NULL) {
        b = orr_antex_find_frequency(antenna, code2);
        w = f1 * f1 / (f1 * f1 - f2 * f2);
    }
    if (a == NULL || (code2 != NULL && b == NULL)) return ORR_E_NODATA;
    for (int i = 0; i < 3; i++)
        offset_m[i] = b == NULL ? a->offset_m[i] : w * a->offset_m[i] + (1 - w) * b->offset_m[i];
    return ORR_OK;
}

orr_status orr_antenna_offset_of_sat(const orr_antex *antex, orr_sat sat, orr_time t, double offset_m[3])
{
    const orr_antex_antenna *antenna = orr_antex_find_sat(antex, sat, t);
    const orr_antenna_pair *p = orr_antenna_pair_of(orr_sat_system(sat));
    if (antenna == NULL || p == NULL) return ORR_E_NODATA;
    return orr_antenna_offset_body(antenna, p->code1, p->f1_hz, p->code2, p->f2_hz, offset_m);
}

orr_status orr_antenna_offset(const orr_antex_antenna *antenna, const orr_attitude *attitude,
                              const char *code1, double f1, const char *code2, double f2, orr_vec3 *offset)
{
    double body[3];
    orr_status s = orr_antenna_offset_body(antenna, code1, f1, code2, f2, body);
    if (s == ORR_OK) *offset = orr_mat3_apply_t(&attitude->body, (orr_vec3){body[0], body[1], body[2]});
    return s;
}

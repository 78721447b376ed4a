// SPDX-License-Identifier: GPL-3.0-or-later
// Yaw laws in closed form. Angles: beta, the Sun's elevation above the orbital plane; mu, the satellite's angle from midnight;
// nominal yaw atan2(-tan beta, sin mu), whose rate is n tan beta cos mu / (sin^2 mu + tan^2 beta).
#include "orbit/spacecraft/attitude_laws.h"

#include <string.h>

#define DEG ORR_RAD_PER_DEG

orr_attitude_law orr_attitude_law_of(const orr_antex_antenna *antenna)
{
    static const struct {
        const char *type;
        orr_attitude_law law;
    } laws[] = {
        {"BLOCK IIR", ORR_LAW_RATE},        {"BLOCK IIF", ORR_LAW_IIF},
        {"GLONASS-M", ORR_LAW_GLONASS_M},   {"GALILEO-1", ORR_LAW_GALILEO_IOV},
        {"GALILEO-2", ORR_LAW_GALILEO_FOC}, {"BEIDOU-3M", ORR_LAW_BEIDOU_3},
        {"BEIDOU-3I", ORR_LAW_BEIDOU_3},    {"BLOCK IIA", ORR_LAW_IIA},
        {"BLOCK III", ORR_LAW_III},         {"BEIDOU-2M", ORR_LAW_BEIDOU_2},
        {"BEIDOU-2I", ORR_LAW_BEIDOU_2},
    };
    if (antenna == NULL) return ORR_LAW_NOMINAL;
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
        if (strncmp(antenna->type, laws[k].type, strlen(laws[k].type)) == 0) return laws[k].law;
    // These are the whole name of a block, and the begin of others'.
    if (strcmp(antenna->type, "BLOCK II") == 0) return ORR_LAW_IIA;
    return strcmp(antenna->type, "QZSS") == 0 ? ORR_LAW_QZS_1 : ORR_LAW_NOMINAL;
}

// Where the satellite is on its orbit.
typedef struct place {
    double beta, mu, n; // rad, rad from midnight in (-pi, pi], rad/s
    double radius_m;
    double beta_90, beta_90_before; // beta at the last passage of mu = 90 deg, and a revolution before it
} place;

static double nominal(const place *p, double mu) { return atan2(-tan(p->beta), sin(mu)); }

// Angle from a centre (0: midnight, pi: noon), and the sign of the nominal turn there.
static double from_centre(const place *p, double centre) { return remainder(p->mu - centre, 2 * ORR_PI); }
static double turn_sign(const place *p, double centre) { return p->beta * cos(centre) >= 0 ? 1 : -1; }

// How far the nominal yaw has turned from mu0 to mu in the sense of the turn, [0, 2 pi).
static double turned(const place *p, double sign, double mu0, double mu)
{
    const double angle = fmod(sign * (nominal(p, mu) - nominal(p, mu0)), 2 * ORR_PI);
    return angle < 0 ? angle + 2 * ORR_PI : angle;
}

// At most `rate` about a centre: nominal until its rate is reached, then behind it until it is caught up with.
static double rate_limited(const place *p, double centre, double rate)
{
    const double t = fabs(tan(p->beta)), k = p->n / rate, delta = from_centre(p, centre);
    if (k <= t) return nominal(p, p->mu);
    // sin^2 eta + t^2 = k t cos eta, squared, for x = sin^2 eta.
    const double b = t * t * (2 + k * k), c = t * t * (t * t - k * k);
    const double eta = asin(fmin(sqrt((sqrt(b * b - 4 * c) - b) / 2), 1));
    if (delta < -eta || delta > ORR_PI / 2) return nominal(p, p->mu);
    const double sign = turn_sign(p, centre), begin = centre - eta;
    const double way = fmin(rate * (delta + eta) / p->n, turned(p, sign, begin, p->mu));
    return nominal(p, begin) + sign * way;
}

// Half the angle that the Earth's shadow covers on the orbit, 0 where there is none.
static double shadow_half(const place *p)
{
    const double edge = sqrt(1 - pow(ORR_SHADOW_RADIUS_M / p->radius_m, 2)) / cos(p->beta);
    return edge < 1 ? acos(edge) : 0;
}

static double even_in_shadow(const place *p)
{
    const double half = shadow_half(p), sign = turn_sign(p, 0);
    if (!(fabs(p->mu) < half)) return nominal(p, p->mu);
    return nominal(p, -half) + sign * turned(p, sign, -half, half) * (p->mu + half) / (2 * half);
}

static double glonass_m(const place *p)
{
    const double rate = 0.25 * DEG, half = shadow_half(p), noon = from_centre(p, ORR_PI),
                 t = fabs(tan(p->beta));
    if (fabs(p->mu) < half) {
        const double sign = turn_sign(p, 0);
        return nominal(p, -half) + sign * fmin(rate * (p->mu + half) / p->n, turned(p, sign, -half, half));
    }
    if (p->n / rate <= t) return nominal(p, p->mu);
    // The turn takes 2 eta / n: eta = (n / rate) atan(sin eta / t), which is the nominal yaw between its ends.
    double eta = p->n / rate * ORR_PI / 2;
    for (int k = 0; k < 30; k++) eta = p->n / rate * atan(sin(eta) / t);
    if (!(fabs(noon) < eta)) return nominal(p, p->mu);
    return nominal(p, ORR_PI - eta) + turn_sign(p, ORR_PI) * rate * (noon + eta) / p->n;
}

// Block IIA: behind the Sun's line in the shadow, and back to it afterwards.
static double block_iia(const place *p)
{
    const double rate = 0.12 * DEG, half = shadow_half(p), since_exit = (p->mu - half) / p->n;
    if (half == 0 || p->mu < -half || p->mu > ORR_PI / 2) return nominal(p, p->mu);
    const double at_exit = nominal(p, -half) + rate * 2 * half / p->n;
    if (p->mu < half) return nominal(p, -half) + rate * (p->mu + half) / p->n;
    const double behind = remainder(at_exit - nominal(p, half), 2 * ORR_PI);
    // The nominal yaw moves on, away or towards: what is left is taken back at the rate, from both sides.
    return nominal(p, p->mu) + copysign(fmax(fabs(behind) - rate * since_exit, 0), behind);
}

// Orbit-normal, yaw 0, while beta is small; changed where the yaw is least, mu = 90 deg, and not at once.
static double orbit_normal_below(const place *p, double least)
{
    const double rate = 0.1 * DEG, yaw = fabs(p->beta_90) < least ? 0 : nominal(p, p->mu);
    if ((fabs(p->beta_90) < least) == (fabs(p->beta_90_before) < least)) return yaw;
    const double since_s = fmod(p->mu - ORR_PI / 2 + 2 * ORR_PI, 2 * ORR_PI) / p->n;
    const double step =
        fabs(p->beta_90) < least ? -p->beta_90 : p->beta_90; // of the old yaw above the new one
    return yaw + copysign(fmax(fabs(step) - rate * since_s, 0), step);
}

// A direction that keeps away from the Sun's line, within `narrow` of it across and 15 deg along the track.
static double kept_away(const place *p, double narrow)
{
    const double sx = cos(p->beta) * sin(p->mu), sy = -sin(p->beta), wide = sin(15 * DEG);
    if (fabs(sx) >= wide || fabs(sy) >= narrow) return nominal(p, p->mu);
    const double side = sy < 0 ? -narrow : narrow;
    const double y = 0.5 * (side + sy) + 0.5 * (side - sy) * cos(ORR_PI * fabs(sx) / wide);
    return atan2(y, sx);
}

static double galileo_foc(const place *p)
{
    const double edge = cos(10 * DEG) / cos(p->beta);
    if (fabs(p->beta) >= 4.1 * DEG || edge >= 1) return nominal(p, p->mu);
    const double half = acos(edge);
    for (int side = 0; side < 2; side++) {
        const double centre = side * ORR_PI, delta = from_centre(p, centre),
                     begin = nominal(p, centre - half);
        const double middle = begin < 0 ? -ORR_PI / 2 : ORR_PI / 2;
        if (fabs(delta) < half) return middle + (begin - middle) * cos(ORR_PI * (delta + half) / (2 * half));
    }
    return nominal(p, p->mu);
}

static double beidou_3(const place *p)
{
    const double least = 2.8 * DEG, s = sin(p->mu);
    if (fabs(p->beta) >= least) return nominal(p, p->mu);
    const double held = p->beta + (copysign(least, p->beta) - p->beta) / (1 + 80000 * s * s * s * s);
    return atan2(-tan(held), s);
}

static double yaw_by_law(orr_attitude_law law, const place *p)
{
    const double noon = fabs(from_centre(p, ORR_PI));
    switch (law) {
    case ORR_LAW_RATE:
        return rate_limited(p, noon < ORR_PI / 2 ? ORR_PI : 0, 0.20 * DEG);
    case ORR_LAW_IIF:
        return noon < ORR_PI / 2 ? rate_limited(p, ORR_PI, 0.11 * DEG) : even_in_shadow(p);
    case ORR_LAW_GLONASS_M:
        return glonass_m(p);
    case ORR_LAW_GALILEO_IOV:
        return kept_away(p, sin(2 * DEG));
    case ORR_LAW_III:
        return kept_away(p, sin(5.8 * DEG));
    case ORR_LAW_IIA:
        return noon < ORR_PI / 2 ? rate_limited(p, ORR_PI, 0.12 * DEG) : block_iia(p);
    case ORR_LAW_BEIDOU_2:
        return orbit_normal_below(p, 4 * DEG);
    case ORR_LAW_QZS_1:
        return orbit_normal_below(p, 20 * DEG);
    case ORR_LAW_GALILEO_FOC:
        return galileo_foc(p);
    case ORR_LAW_BEIDOU_3:
        return beidou_3(p);
    case ORR_LAW_NOMINAL:
        break;
    }
    return nominal(p, p->mu);
}

// The Sun's right ascension and the ecliptic's obliquity to a minute of arc: the mean Sun with its equation of the centre.
static double sun_right_ascension(orr_time t, double obliquity)
{
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_GPS, NULL, &mjd, &fraction);
    const double days = mjd - 51544.5 + fraction; // of J2000
    const double anomaly = (357.528 + 0.9856003 * days) * DEG;
    const double lon = (280.460 + 0.9856474 * days + 1.915 * sin(anomaly) + 0.020 * sin(2 * anomaly)) * DEG;
    return atan2(cos(obliquity) * sin(lon), cos(lon));
}

// beta so many seconds before t: the Sun turned back along the ecliptic, whose pole stands 270 deg in right ascension beside it.
static double beta_before(orr_time t, orr_vec3 normal, orr_vec3 sun, double seconds)
{
    const double obliquity = 23.44 * DEG, back = -2 * ORR_PI / (365.25 * 86400) * seconds;
    const double lon = atan2(sun.y, sun.x) - sun_right_ascension(t, obliquity) - ORR_PI / 2;
    const orr_vec3 pole = {sin(obliquity) * cos(lon), sin(obliquity) * sin(lon), cos(obliquity)};
    const orr_vec3 was = orr_vec3_axpy(sin(back), orr_vec3_cross(pole, sun), orr_vec3_scale(cos(back), sun));
    return asin(fmin(fmax(orr_vec3_dot(normal, was), -1), 1));
}

orr_status orr_attitude_by_law(orr_attitude_law law, orr_time t, orr_vec3 r, orr_vec3 v, orr_vec3 sun,
                               orr_attitude *out)
{
    const orr_status status = orr_attitude_nominal(r, v, sun, out);
    if (status != ORR_OK || law == ORR_LAW_NOMINAL) return status;
    const orr_vec3 up = orr_vec3_unit(r), normal = orr_vec3_unit(orr_vec3_cross(r, v));
    const orr_vec3 along = orr_vec3_cross(normal, up), s = orr_vec3_unit(sun);
    place p = {.beta = out->beta_rad,
               .mu = atan2(orr_vec3_dot(s, along), -orr_vec3_dot(s, up)),
               .n = orr_vec3_norm(orr_vec3_cross(r, v)) / orr_vec3_dot(r, r),
               .radius_m = orr_vec3_norm(r)};
    if (law == ORR_LAW_BEIDOU_2 || law == ORR_LAW_QZS_1) {
        const double since = fmod(p.mu - ORR_PI / 2 + 2 * ORR_PI, 2 * ORR_PI) / p.n;
        p.beta_90 = beta_before(t, normal, s, since);
        p.beta_90_before = beta_before(t, normal, s, since + 2 * ORR_PI / p.n);
    }
    // The Sun's parallax (9 arcsec) is in the nominal attitude and not in the angles: what the law turns is added.
    const double more = remainder(yaw_by_law(law, &p) - nominal(&p, p.mu), 2 * ORR_PI), c = cos(more),
                 q = sin(more);
    const orr_mat3 was = out->body;
    const orr_vec3 x = {was.m[0][0], was.m[0][1], was.m[0][2]}, y = {was.m[1][0], was.m[1][1], was.m[1][2]};
    const orr_vec3 x1 = orr_vec3_axpy(q, y, orr_vec3_scale(c, x)),
                   y1 = orr_vec3_axpy(-q, x, orr_vec3_scale(c, y));
    out->body = (orr_mat3){{{x1.x, x1.y, x1.z}, {y1.x, y1.y, y1.z}, {was.m[2][0], was.m[2][1], was.m[2][2]}}};
    out->yaw_rad = remainder(out->yaw_rad + more, 2 * ORR_PI);
    out->fast_turn = false;
    return ORR_OK;
}

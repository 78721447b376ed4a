// SPDX-License-Identifier: GPL-3.0-or-later
// GSG's commands of motion while a scenario runs: a time (IMMediate, or seconds since the begin) and three numbers. Velocity, acceleration,
// attitude and its rate wait for the next position, which makes a sample of what is known.
#include <math.h>
#include <string.h>
#include <strings.h>

#include "core/constants.h"
#include "core/earth.h"
#include "src/service/dialect/dialect.h"
#include "src/service/text/scpi_dialects.h"

static orr_msg_motion *sample_of(orr_scpi *s) { return &((orr_text_common *)s->user)->gsg; }

static int take(orr_scpi *s, char *const *p, orr_time *t, double v[3])
{
    const orr_asked *a = orr_text_asked(s);
    double seconds;
    orr_msg_time now;
    if (a->streams == NULL) return ORR_SCPI_EXECUTION;
    if (strcasecmp(p[0], "IMM") == 0 || strcasecmp(p[0], "IMMEDIATE") == 0) {
        orr_streams_time(a->streams, &now);
        *t = now.t;
    } else if (orr_scpi_numbers(p, 1, &seconds) == 0 && fabs(seconds) < 1e9) {
        *t = orr_time_add(orr_streams_begin(a->streams), llround(seconds * 1e9));
    } else {
        return ORR_SCPI_ILLEGAL;
    }
    return orr_scpi_numbers(p + 1, 3, v);
}

// A vector of East, North, Up at the sample's position, ecef.
static void from_enu(const orr_msg_motion *m, const double v[3], double to[3])
{
    const orr_geodetic g = orr_earth_from_ecef((orr_vec3){m->pos_m[0], m->pos_m[1], m->pos_m[2]});
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    const orr_vec3 ecef = orr_mat3_apply_t(&enu, (orr_vec3){v[0], v[1], v[2]});
    to[0] = ecef.x, to[1] = ecef.y, to[2] = ecef.z;
}

static int ecef_position(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    orr_msg_motion *m = sample_of(s);
    const int wrong = take(s, p, &m->t, m->pos_m);
    return wrong != 0 ? wrong : orr_scpi_motion(s, m);
}

// Latitude and longitude in degrees, height over the ellipsoid.
static int position(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    orr_msg_motion *m = sample_of(s);
    double v[3];
    const int wrong = take(s, p, &m->t, v);
    if (wrong != 0) return wrong;
    if (fabs(v[0]) > 90) return ORR_SCPI_RANGE;
    const orr_vec3 r =
        orr_earth_to_ecef((orr_geodetic){v[0] * ORR_RAD_PER_DEG, v[1] * ORR_RAD_PER_DEG, v[2]});
    m->pos_m[0] = r.x, m->pos_m[1] = r.y, m->pos_m[2] = r.z;
    return orr_scpi_motion(s, m);
}

// Velocity (order 1) or acceleration (2), ecef or East, North, Up.
static int derivative(orr_scpi *s, char *const *p, uint8_t order, bool enu)
{
    orr_msg_motion *m = sample_of(s);
    double *to = order == 1 ? m->vel_mps : m->acc_mps2, v[3];
    const int wrong = take(s, p, &m->t, v);
    if (wrong != 0) return wrong;
    if (enu)
        from_enu(m, v, to);
    else
        memcpy(to, v, sizeof v);
    if (m->order < order) m->order = order;
    return 0;
}

static int ecef_velocity(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return derivative(s, p, 1, false);
}

static int enu_velocity(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return derivative(s, p, 1, true);
}

static int ecef_acceleration(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return derivative(s, p, 2, false);
}

static int enu_acceleration(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return derivative(s, p, 2, true);
}

// Pitch, roll, yaw (order 0) or their rates (1), in so many radians.
static int turn(orr_scpi *s, char *const *p, int order, double unit_rad)
{
    orr_text_common *c = s->user;
    double v[3], angle[4][3];
    const int wrong = take(s, p, &c->gsg.t, v);
    if (wrong != 0) return wrong;
    memcpy(angle, c->gsg_angle, sizeof angle);
    angle[order][0] = v[2] * unit_rad, angle[order][1] = v[0] * unit_rad, angle[order][2] = v[1] * unit_rad;
    memcpy(c->gsg_angle, angle, sizeof angle);
    orr_dialect_turn(angle, order > 0 || c->gsg.angular_order > 1 ? 1 : 0, &c->gsg);
    return 0;
}

static int attitude(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return turn(s, p, 0, 1);
}

static int attitude_deg(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return turn(s, p, 0, ORR_RAD_PER_DEG);
}

static int rate(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return turn(s, p, 1, 1);
}

static int rate_deg(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    return turn(s, p, 1, ORR_RAD_PER_DEG);
}

const orr_scpi_command orr_scpi_gsg[] = {
    {"SOURce:SCENario:ECEFPOSition", 4, 4, ecef_position, true},
    {"SOURce:SCENario:ECEFVELocity", 4, 4, ecef_velocity, true},
    {"SOURce:SCENario:ENUVELocity", 4, 4, enu_velocity, true},
    {"SOURce:SCENario:POSition", 4, 4, position, true},
    {"SOURce:SCENario:ECEFACCel", 4, 4, ecef_acceleration, true},
    {"SOURce:SCENario:ENUACCel", 4, 4, enu_acceleration, true},
    {"SOURce:SCENario:PRYattitude", 4, 4, attitude, true},
    {"SOURce:SCENario:DPRYattitude", 4, 4, attitude_deg, true},
    {"SOURce:SCENario:PRYRate", 4, 4, rate, true},
    {"SOURce:SCENario:DPRYRate", 4, 4, rate_deg, true},
};
const size_t orr_scpi_n_gsg = sizeof orr_scpi_gsg / sizeof orr_scpi_gsg[0];

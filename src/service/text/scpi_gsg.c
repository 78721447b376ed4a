// SPDX-License-Identifier: GPL-3.0-or-later
// GSG's commands of motion while a scenario runs: a time (IMMediate, or seconds since the begin) and three numbers. Velocity and attitude
// wait for the next position, which makes a sample of what is known.
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

static int ecef_position(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    orr_msg_motion *m = sample_of(s);
    const int wrong = take(s, p, &m->t, m->pos_m);
    return wrong != 0 ? wrong : orr_scpi_motion(s, m);
}

static int ecef_velocity(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    orr_msg_motion *m = sample_of(s);
    m->order = 1;
    return take(s, p, &m->t, m->vel_mps);
}

static int enu_velocity(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    orr_msg_motion *m = sample_of(s);
    double v[3];
    const int wrong = take(s, p, &m->t, v);
    if (wrong != 0) return wrong;
    const orr_geodetic g = orr_earth_from_ecef((orr_vec3){m->pos_m[0], m->pos_m[1], m->pos_m[2]});
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    const orr_vec3 ecef = orr_mat3_apply_t(&enu, (orr_vec3){v[0], v[1], v[2]});
    const double to[3] = {ecef.x, ecef.y, ecef.z};
    memcpy(m->vel_mps, to, sizeof to);
    m->order = 1;
    return 0;
}

// Pitch, roll, yaw in degrees, and their rates.
static int attitude(orr_scpi *s, char *const *p, size_t n, FILE *out)
{
    (void)n, (void)out;
    orr_msg_motion *m = sample_of(s);
    double v[3], angle[4][3] = {{0}};
    const int wrong = take(s, p, &m->t, v);
    if (wrong != 0) return wrong;
    angle[0][0] = v[2] * ORR_RAD_PER_DEG, angle[0][1] = v[0] * ORR_RAD_PER_DEG,
    angle[0][2] = v[1] * ORR_RAD_PER_DEG;
    orr_dialect_turn(angle, 0, m);
    return 0;
}

const orr_scpi_command orr_scpi_gsg[] = {
    {"SOURce:SCENario:ECEFPOSition", 4, 4, ecef_position, true},
    {"SOURce:SCENario:ECEFVELocity", 4, 4, ecef_velocity, true},
    {"SOURce:SCENario:ENUVELocity", 4, 4, enu_velocity, true},
    {"SOURce:SCENario:PRYattitude", 4, 4, attitude, true},
};
const size_t orr_scpi_n_gsg = sizeof orr_scpi_gsg / sizeof orr_scpi_gsg[0];

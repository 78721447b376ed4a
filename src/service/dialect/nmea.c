// SPDX-License-Identifier: GPL-3.0-or-later
// NMEA 0183, one sentence a datagram: GGA gives the place (height over the ellipsoid: that above the geoid and its separation), RMC
// before it speed and course over ground. A sample holds when it comes: the sentences' seconds of the day are another clock's.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/earth.h"
#include "src/service/dialect/dialect.h"

enum { FIELDS = 20 };
static const double KNOT_MPS = 1852.0 / 3600;

// The sentence cut at its commas; 0 where its checksum is wrong, or it is none.
static int cut(char *text, char *field[FIELDS])
{
    unsigned sum = 0, told;
    int n = 0;
    char *star = strchr(text, '*');
    if (text[0] != '$' || star == NULL || sscanf(star + 1, "%2x", &told) != 1) return 0;
    for (char *c = text + 1; c < star; c++) sum ^= (unsigned char)*c;
    if (sum != told) return 0;
    *star = '\0';
    for (char *c = text; n < FIELDS && c != NULL; n++) {
        field[n] = c;
        c = strchr(c, ',');
        if (c != NULL) *c++ = '\0';
    }
    return n;
}

// ddmm.mmm of a hemisphere as radians; NAN where it is none.
static double angle_of(const char *text, const char *side)
{
    char *end;
    const double v = strtod(text, &end);
    if (end == text || *end != '\0' || strlen(side) != 1) return (double)NAN;
    const double degrees = floor(v / 100), minutes = v - 100 * degrees;
    const double rad = (degrees + minutes / 60) * ORR_RAD_PER_DEG;
    return side[0] == 'S' || side[0] == 'W' ? -rad : rad;
}

static orr_dialect_result take(orr_dialect_state *s, const uint8_t *data, size_t n, orr_msg_motion *m,
                               uint8_t *reply, size_t *n_reply)
{
    char text[ORR_DIALECT_DATAGRAM + 1], *f[FIELDS];
    (void)reply;
    *n_reply = 0;
    if (n > ORR_DIALECT_DATAGRAM) return ORR_DIALECT_WRONG;
    memcpy(text, data, n);
    text[n] = '\0';
    const int count = cut(text, f);
    if (count == 0 || strlen(f[0]) != 6) return ORR_DIALECT_WRONG;
    if (strcmp(f[0] + 3, "RMC") == 0 && count >= 9) { // speed and course wait for the place
        const double speed = atof(f[7]) * KNOT_MPS, course = atof(f[8]) * ORR_RAD_PER_DEG;
        s->last.order = 1;
        s->last.vel_mps[0] = speed * sin(course);
        s->last.vel_mps[1] = speed * cos(course);
        return ORR_DIALECT_NOTHING;
    }
    if (strcmp(f[0] + 3, "GGA") != 0 || count < 12) return ORR_DIALECT_NOTHING;
    const orr_geodetic g = {angle_of(f[2], f[3]), angle_of(f[4], f[5]), atof(f[9]) + atof(f[11])};
    if (!isfinite(g.lat_rad) || !isfinite(g.lon_rad) || fabs(g.lat_rad) > ORR_PI / 2)
        return ORR_DIALECT_WRONG;
    const orr_mat3 enu = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    const orr_vec3 r = orr_earth_to_ecef(g),
                   v = orr_mat3_apply_t(&enu, (orr_vec3){s->last.vel_mps[0], s->last.vel_mps[1], 0});
    *m = (orr_msg_motion){
        .t = s->now, .order = s->last.order, .pos_m = {r.x, r.y, r.z}, .vel_mps = {v.x, v.y, v.z}};
    return ORR_DIALECT_SAMPLE;
}

const orr_dialect orr_dialect_nmea = {
    .name = "nmea", .words = "NMEA 0183 sentences GGA and RMC", .take = take};

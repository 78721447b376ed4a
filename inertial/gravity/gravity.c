// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/gravity/gravity.h"

#include <gsl/gsl_spline.h>
#include <gsl/gsl_spline2d.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/polar.h"

#define PROFILE_MARGIN_M 50e3 // tabled beyond a profile's ends
#define PROFILE_REACH_M 1.9e7 // a geodesic's angle ascends at least so far
#define PROFILE_NODES 512     // of the table at most,
#define PROFILE_STEP_M 10e3   // and so far apart at least: the spline through them errs by 1e-8 m
#define LAST_LATITUDE (0.5 * ORR_PI + 1e-9) // a pole, and the rounding of degrees
#define LAST_LONGITUDE (8 * ORR_PI)         // maps may run past a turn
#define LAST_DISTANCE_M 1e9
#define LEAST_STEP_M 1e-6 // points nearer than that are one, and a step of 5e-324 has no slope
#define LEAST_STEP_RAD 1e-13

struct orr_gravity {
    orr_gravity_parts parts; // its arrays are the following copies
    orr_point_mass *mass;
    double *copy[5];
    size_t n_copies;
    gsl_spline *profile;
    gsl_spline2d *map;
    orr_vec3 profile_from,
        profile_towards; // normals at the profile's begin and 90 deg on along its great circle
    gsl_spline *along;   // distance on the geodesic by the angle of its normals from the begin
    double along_from_rad, along_to_rad; // of the table
};

static const double *copy_numbers(orr_gravity *g, const double *from, size_t n)
{
    double *to = malloc(n * sizeof *to);
    if (to == NULL) return NULL;
    memcpy(to, from, n * sizeof *to);
    g->copy[g->n_copies++] = to;
    return to;
}

// Places within +-most, each by at least `least` on from the one before: a spline's slopes stay numbers.
static orr_status check_axis(const double *x, size_t n, double most, double least, const char *what,
                             orr_diag *diag)
{
    for (size_t i = 0; i < n; i++)
        if (!(fabs(x[i]) <= most) || (i > 0 && !(x[i] - x[i - 1] >= least)))
            return orr_diag_set(
                diag, ORR_E_ARG,
                "%s of the gravity disturbance must be of the Earth and ascending; number %zu is not", what,
                i + 1);
    return ORR_OK;
}

static orr_status check_values(const double *x, size_t n, orr_diag *diag)
{
    for (size_t i = 0; i < n; i++)
        if (!(fabs(x[i]) < 1e5))
            return orr_diag_set(diag, ORR_E_ARG,
                                "value %zu of the gravity disturbance, %g mGal, is no gravity disturbance",
                                i + 1, x[i]);
    return ORR_OK;
}

static double profile_angle(const orr_gravity *g, orr_vec3 up)
{
    return atan2(orr_vec3_dot(up, g->profile_towards), orr_vec3_dot(up, g->profile_from));
}

// Distance by angle, from points of the geodesic.
static orr_status table_distances(const orr_gravity_parts *p, orr_gravity *g, orr_diag *diag)
{
    double from = fmax(p->profile_distance_m[0] - PROFILE_MARGIN_M, -PROFILE_REACH_M),
           to = fmin(p->profile_distance_m[p->n_profile - 1] + PROFILE_MARGIN_M, PROFILE_REACH_M);
    if (!(to - from > PROFILE_MARGIN_M)) { // wholly on the other side of the Earth
        from = -PROFILE_MARGIN_M;
        to = PROFILE_MARGIN_M;
    }
    double angle[PROFILE_NODES], distance[PROFILE_NODES];
    size_t n = (size_t)fmin(fmax(ceil((to - from) / PROFILE_STEP_M) + 1.0, 8.0), (double)PROFILE_NODES);
    for (size_t k = 0; k < n; k++) {
        double lat, lon, azimuth;
        distance[k] = from + (to - from) * (double)k / (double)(n - 1);
        orr_earth_geodesic_direct(p->profile_lat_rad, p->profile_lon_rad, p->profile_azimuth_rad, distance[k],
                                  &lat, &lon, &azimuth);
        angle[k] = profile_angle(g, orr_vec3_make(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)));
        if (k > 0 && !(angle[k] > angle[k - 1]))
            return orr_diag_set(diag, ORR_E_ARG,
                                "the gravity profile has no place: lat %g, lon %g, azimuth %g deg",
                                p->profile_lat_rad * ORR_DEG_PER_RAD, p->profile_lon_rad * ORR_DEG_PER_RAD,
                                p->profile_azimuth_rad * ORR_DEG_PER_RAD);
    }
    g->along = gsl_spline_alloc(gsl_interp_cspline, n);
    if (g->along == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a gravity profile");
    g->along_from_rad = angle[0];
    g->along_to_rad = angle[n - 1];
    if (gsl_spline_init(g->along, angle, distance, n) != 0)
        return orr_diag_set(diag, ORR_E_NUMERIC, "the gravity profile has no geodesic");
    return ORR_OK;
}

static orr_status make_profile(const orr_gravity_parts *p, orr_gravity *g, orr_diag *diag)
{
    if (p->n_profile < 3)
        return orr_diag_set(diag, ORR_E_ARG, "a gravity profile needs three points or more");
    orr_status s =
        check_axis(p->profile_distance_m, p->n_profile, LAST_DISTANCE_M, LEAST_STEP_M, "distances", diag);
    if (s == ORR_OK) s = check_values(p->profile_mgal, p->n_profile, diag);
    if (s != ORR_OK) return s;
    double cl = cos(p->profile_lat_rad), sl = sin(p->profile_lat_rad), co = cos(p->profile_lon_rad),
           so = sin(p->profile_lon_rad), ca = cos(p->profile_azimuth_rad), sa = sin(p->profile_azimuth_rad);
    g->profile_from = orr_vec3_make(cl * co, cl * so, sl);
    g->profile_towards = orr_vec3_make(-sa * so - ca * sl * co, sa * co - ca * sl * so, ca * cl);
    g->parts.profile_distance_m = copy_numbers(g, p->profile_distance_m, p->n_profile);
    g->parts.profile_mgal = copy_numbers(g, p->profile_mgal, p->n_profile);
    g->profile = gsl_spline_alloc(gsl_interp_cspline, p->n_profile);
    if (g->parts.profile_distance_m == NULL || g->parts.profile_mgal == NULL || g->profile == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a gravity profile of %zu points",
                            p->n_profile);
    if (gsl_spline_init(g->profile, g->parts.profile_distance_m, g->parts.profile_mgal, p->n_profile) != 0)
        return orr_diag_set(diag, ORR_E_NUMERIC, "the gravity profile has no cubic spline");
    return table_distances(p, g, diag);
}

static orr_status make_map(const orr_gravity_parts *p, orr_gravity *g, orr_diag *diag)
{
    if (p->n_lat < 4 || p->n_lon < 4)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a gravity map needs four latitudes and four longitudes or more");
    if (p->n_lon > 100000000u / p->n_lat)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "a gravity map of %zu x %zu points passes the limit of 100 million", p->n_lat,
                            p->n_lon);
    orr_status s = check_axis(p->map_lat_rad, p->n_lat, LAST_LONGITUDE, LEAST_STEP_RAD, "latitudes", diag);
    if (s == ORR_OK)
        s = check_axis(p->map_lon_rad, p->n_lon, LAST_LONGITUDE, LEAST_STEP_RAD, "longitudes", diag);
    if (s == ORR_OK &&
        !(p->map_lat_rad[0] >= -LAST_LATITUDE && p->map_lat_rad[p->n_lat - 1] <= LAST_LATITUDE))
        s = orr_diag_set(diag, ORR_E_ARG, "a gravity map from latitude %.6g to %.6g deg reaches past a pole",
                         p->map_lat_rad[0] * ORR_DEG_PER_RAD, p->map_lat_rad[p->n_lat - 1] * ORR_DEG_PER_RAD);
    if (s == ORR_OK) s = check_values(p->map_mgal, p->n_lat * p->n_lon, diag);
    if (s != ORR_OK) return s;
    g->parts.map_lat_rad = copy_numbers(g, p->map_lat_rad, p->n_lat);
    g->parts.map_lon_rad = copy_numbers(g, p->map_lon_rad, p->n_lon);
    g->parts.map_mgal = copy_numbers(g, p->map_mgal, p->n_lat * p->n_lon);
    g->map = gsl_spline2d_alloc(gsl_interp2d_bicubic, p->n_lon, p->n_lat);
    if (g->parts.map_lat_rad == NULL || g->parts.map_lon_rad == NULL || g->parts.map_mgal == NULL ||
        g->map == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a gravity map of %zu x %zu points", p->n_lat,
                            p->n_lon);
    if (gsl_spline2d_init(g->map, g->parts.map_lon_rad, g->parts.map_lat_rad, g->parts.map_mgal, p->n_lon,
                          p->n_lat) != 0)
        return orr_diag_set(diag, ORR_E_NUMERIC, "the gravity map has no bicubic spline");
    return ORR_OK;
}

orr_status orr_gravity_make(const orr_gravity_parts *parts, orr_gravity **out, orr_diag *diag)
{
    *out = NULL;
    orr_gravity *g = calloc(1, sizeof *g);
    if (g == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a gravity field");
    orr_status s = ORR_OK;
    g->parts = *parts;
    g->parts.mass = NULL;
    g->parts.profile_distance_m = g->parts.profile_mgal = NULL;
    g->parts.map_lat_rad = g->parts.map_lon_rad = g->parts.map_mgal = NULL;
    if (parts->n_masses > 100000u) s = orr_diag_set(diag, ORR_E_LIMIT, "more than 100000 point masses");
    if (s == ORR_OK && parts->n_masses > 0) {
        orr_point_mass *mass = malloc(parts->n_masses * sizeof *mass);
        if (mass == NULL)
            s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu point masses", parts->n_masses);
        g->parts.mass = g->mass = mass;
        for (size_t i = 0; s == ORR_OK && i < parts->n_masses; i++) {
            mass[i] = parts->mass[i];
            if (!isfinite(mass[i].gm_m3ps2) || !isfinite(orr_vec3_norm(mass[i].r_m)))
                s = orr_diag_set(diag, ORR_E_ARG, "point mass %zu is not finite", i + 1);
        }
    }
    if (s == ORR_OK && parts->n_profile > 0) s = make_profile(parts, g, diag);
    if (s == ORR_OK && (parts->n_lat > 0 || parts->n_lon > 0)) s = make_map(parts, g, diag);
    if (s != ORR_OK) {
        orr_gravity_free(g);
        return s;
    }
    *out = g;
    return ORR_OK;
}

void orr_gravity_free(orr_gravity *g)
{
    if (g == NULL) return;
    if (g->profile != NULL) gsl_spline_free(g->profile);
    if (g->along != NULL) gsl_spline_free(g->along);
    if (g->map != NULL) gsl_spline2d_free(g->map);
    free(g->mass);
    for (size_t i = 0; i < g->n_copies; i++) free(g->copy[i]);
    free(g);
}

orr_gravity_parts orr_gravity_parts_view(const orr_gravity *g)
{
    return g != NULL ? g->parts : (orr_gravity_parts){0};
}

static double clamp(double x, double lo, double hi) { return x < lo ? lo : x > hi ? hi : x; }

// Distance of a place along the profile; beyond the table at the Earth's mean radius.
static double profile_distance(const orr_gravity *g, orr_vec3 up)
{
    double angle = profile_angle(g, up), inside = clamp(angle, g->along_from_rad, g->along_to_rad);
    return gsl_spline_eval(g->along, inside, NULL) + ORR_EARTH_MEAN_RADIUS_M * (angle - inside);
}

// Where the values of profile and map belong to that are felt at r_m.
static orr_vec3 home_of(const orr_gravity *g, orr_vec3 r_m)
{
    return g->parts.carried ? orr_polar_home(&g->parts.carried_by, r_m) : r_m;
}

// Longitude turned by whole turns to lie as near to the map as it can.
static double near_map(const orr_gravity_parts *p, double lon_rad)
{
    double mid = 0.5 * (p->map_lon_rad[0] + p->map_lon_rad[p->n_lon - 1]);
    return lon_rad - 2.0 * ORR_PI * nearbyint((lon_rad - mid) / (2.0 * ORR_PI));
}

static double made_mgal(const orr_gravity *g, orr_vec3 up)
{
    const orr_gravity_parts *p = &g->parts;
    double sum = 0.0;
    if (g->profile != NULL) // no accelerator: lookups must not share a memory
        sum += gsl_spline_eval(
            g->profile,
            clamp(profile_distance(g, up), p->profile_distance_m[0], p->profile_distance_m[p->n_profile - 1]),
            NULL);
    if (g->map != NULL) {
        double lat_rad = atan2(up.z, sqrt(up.x * up.x + up.y * up.y)), lon_rad = atan2(up.y, up.x);
        sum += gsl_spline2d_eval(g->map,
                                 clamp(near_map(p, lon_rad), p->map_lon_rad[0], p->map_lon_rad[p->n_lon - 1]),
                                 clamp(lat_rad, p->map_lat_rad[0], p->map_lat_rad[p->n_lat - 1]), NULL, NULL);
    }
    return sum;
}

orr_vec3 orr_gravity_gravitation(const orr_gravity *g, orr_vec3 r_m)
{
    if (g == NULL) return orr_earth_normal_gravitation(r_m);
    orr_vec3 sum = g->parts.model != NULL ? orr_gravity_model_gravitation(g->parts.model, r_m)
                                          : orr_earth_normal_gravitation(r_m);
    for (size_t i = 0; i < g->parts.n_masses; i++) {
        orr_vec3 d = orr_vec3_sub(g->parts.mass[i].r_m, r_m);
        double n2 = orr_vec3_dot(d, d);
        if (n2 > 0.0) sum = orr_vec3_axpy(g->parts.mass[i].gm_m3ps2 / (n2 * sqrt(n2)), d, sum);
    }
    if (g->profile != NULL || g->map != NULL) {
        orr_vec3 up = orr_earth_up(r_m);
        orr_vec3 up_home = g->parts.carried ? orr_earth_up(home_of(g, r_m)) : up;
        sum = orr_vec3_axpy(-ORR_MPS2_PER_MGAL * made_mgal(g, up_home), up, sum);
    }
    return sum;
}

double orr_gravity_disturbance_mgal(const orr_gravity *g, orr_vec3 r_m)
{
    if (g == NULL) return 0.0;
    orr_vec3 d = orr_vec3_sub(orr_gravity_gravitation(g, r_m), orr_earth_normal_gravitation(r_m));
    return -orr_vec3_dot(d, orr_earth_up(r_m)) / ORR_MPS2_PER_MGAL;
}

orr_status orr_gravity_covers(const orr_gravity *g, const orr_trajectory *tr, orr_diag *diag)
{
    if (g == NULL || (g->profile == NULL && g->map == NULL)) return ORR_OK;
    const orr_gravity_parts *p = &g->parts;
    double span = tr->end_s - tr->begin_s;
    size_t n = (size_t)(span < 1e7 ? span : 1e7) + 2; // a look a second
    for (size_t k = 0; k < n; k++) {
        orr_motion m;
        double t_s = tr->begin_s + span * (double)k / (double)(n - 1);
        tr->evaluate(tr->self, t_s, &m);
        orr_vec3 home = home_of(g, m.r_m);
        orr_geodetic at = orr_earth_from_ecef(home);
        if (g->profile != NULL) {
            double d = profile_distance(g, orr_earth_up(home));
            if (d < p->profile_distance_m[0] || d > p->profile_distance_m[p->n_profile - 1])
                return orr_diag_set(diag, ORR_E_RANGE,
                                    "the gravity profile covers %.3f km to %.3f km, but %.0f s after the "
                                    "start the track is at "
                                    "%.3f km of it; lengthen the profile with zeros where nothing is known",
                                    p->profile_distance_m[0] / 1e3,
                                    p->profile_distance_m[p->n_profile - 1] / 1e3, t_s, d / 1e3);
        }
        if (g->map != NULL) {
            double lon = near_map(p, at.lon_rad);
            if (at.lat_rad < p->map_lat_rad[0] || at.lat_rad > p->map_lat_rad[p->n_lat - 1] ||
                lon < p->map_lon_rad[0] || lon > p->map_lon_rad[p->n_lon - 1])
                return orr_diag_set(
                    diag, ORR_E_RANGE,
                    "the gravity map covers latitudes %.4f..%.4f and longitudes %.4f..%.4f deg, but %.0f s "
                    "after "
                    "the start the track is at %.4f, %.4f",
                    p->map_lat_rad[0] * ORR_DEG_PER_RAD, p->map_lat_rad[p->n_lat - 1] * ORR_DEG_PER_RAD,
                    p->map_lon_rad[0] * ORR_DEG_PER_RAD, p->map_lon_rad[p->n_lon - 1] * ORR_DEG_PER_RAD, t_s,
                    at.lat_rad * ORR_DEG_PER_RAD, lon * ORR_DEG_PER_RAD);
        }
    }
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The reading half of imu_file.h.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/readings/imu_file.h"

#define MAX_STEPS ((size_t)50000000)
#define MAX_GRAVITY_POINTS ((size_t)100000000)

static orr_status need_text(const orr_nc_reader *r, const char *name, char *buf, size_t n, orr_diag *diag)
{
    orr_status s = orr_nc_get_att_text(r, NULL, name, buf, n, diag);
    if (s == ORR_E_NODATA)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "it has no attribute \"%s\"", name);
    return s;
}
static orr_status need_double(const orr_nc_reader *r, const char *name, double *v, orr_diag *diag)
{
    orr_status s = orr_nc_get_att_double(r, NULL, name, v, diag);
    if (s == ORR_E_NODATA)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "it has no attribute \"%s\"", name);
    return s == ORR_OK && !isfinite(*v)
               ? orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" is not finite", name)
               : s;
}
static orr_status need_int(const orr_nc_reader *r, const char *name, int64_t lo, int64_t hi, int64_t *v,
                           orr_diag *diag)
{
    orr_status s = orr_nc_get_att_int64(r, NULL, name, v, diag);
    if (s == ORR_E_NODATA)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "it has no attribute \"%s\"", name);
    if (s == ORR_OK && (*v < lo || *v > hi))
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" is %lld", name,
                           (long long)*v);
    return s;
}

static orr_status read_mode(const orr_nc_reader *r, orr_imu *imu, orr_diag *diag)
{
    char word[64];
    int64_t approach = 0, order = 0, degree = 0;
    orr_imu_mode *m = &imu->mode;
    orr_status s = need_int(r, "approach", 1, 2, &approach, diag);
    if (s == ORR_OK) s = need_int(r, "t0_ns", -ORR_TIME_FAR, ORR_TIME_FAR, &imu->t0, diag);
    if (s == ORR_OK) s = need_double(r, "begin_s", &imu->begin_s, diag);
    if (s == ORR_OK) s = need_double(r, "rate_hz", &imu->rate_hz, diag);
    if (s == ORR_OK) s = need_double(r, "knot_origin_s", &imu->knot_origin_s, diag);
    if (s == ORR_OK) s = need_double(r, "knot_step_s", &imu->knot_step_s, diag);
    if (s == ORR_OK) s = need_int(r, "knot_degree", 0, 9, &degree, diag);
    if (s != ORR_OK) return s;
    if (!(imu->rate_hz >= 0.001 && imu->rate_hz <= 1e6) || !(imu->knot_step_s >= 0.0) ||
        !(fabs(imu->begin_s) < 1e10) || !(fabs(imu->knot_origin_s) < 1e10))
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0,
                           "rate, begin or knots of the readings make no sense");
    m->approach = (int)approach;
    imu->knot_degree = (int)degree;
    if (approach == 2) {
        s = need_int(r, "order", 1, 1000000, &order, diag);
        m->order = (int)order;
        if (s == ORR_OK) s = need_text(r, "quadrature", word, sizeof word, diag);
        if (s == ORR_OK)
            m->quadrature = strcmp(word, "riemann") == 0 ? ORR_QUADRATURE_RIEMANN : ORR_QUADRATURE_GAUSS;
        return s;
    }
    s = need_text(r, "frame", word, sizeof word, diag);
    if (s != ORR_OK) return s;
    if (strcmp(word, "inertial") != 0 && strcmp(word, "geographic") != 0 && strcmp(word, "body") != 0)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "readings in an unknown frame \"%s\"", word);
    m->frame = *word == 'i' ? ORR_FRAME_INERTIAL : *word == 'g' ? ORR_FRAME_GEOGRAPHIC : ORR_FRAME_BODY;
    s = need_text(r, "projection", word, sizeof word, diag);
    m->project_mid = s == ORR_OK && strcmp(word, "mid") == 0;
    if (s == ORR_OK) s = need_text(r, "loop", word, sizeof word, diag);
    m->closed_loop = s == ORR_OK && strcmp(word, "closed") == 0;
    return s;
}

static bool is_unit(orr_quat q) { return fabs(orr_quat_dot(q, q) - 1.0) < 1e-6; }

// A comparison with what is no number would find nothing wrong.
static orr_status check_truth(const orr_nc_reader *r, const orr_imu *imu, orr_diag *diag)
{
    for (size_t k = 0; k < imu->n / imu->truth_every + 1; k++)
        if (!isfinite(orr_vec3_norm(imu->r_m[k])) || !isfinite(orr_vec3_norm(imu->v_mps[k])) ||
            !is_unit(imu->q_be[k]))
            return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0,
                               "the truth of instant %zu is no place, velocity and attitude", k);
    if (!isfinite(orr_vec3_norm(imu->start_r_m)) || !isfinite(orr_vec3_norm(imu->start_v_mps)) ||
        !is_unit(imu->start_q_bi))
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "the start is no place, velocity and attitude");
    return ORR_OK;
}

static orr_status read_series(const orr_nc_reader *r, orr_imu *imu, orr_diag *diag)
{
    size_t n = imu->n, steps[2] = {n, 3}, edges[2] = {n + 1, 3}, truths[2] = {n / imu->truth_every + 1, 3},
           quats[2] = {n / imu->truth_every + 1, 4}, xyz = 3, quat = 4;
    orr_status s = orr_nc_get_var(r, "dtheta_rad", ORR_NC_DOUBLE, 2, steps, imu->dtheta_rad, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, "dv_mps", ORR_NC_DOUBLE, 2, steps, imu->dv_mps, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, "position_m", ORR_NC_DOUBLE, 2, truths, imu->r_m, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, "velocity_mps", ORR_NC_DOUBLE, 2, truths, imu->v_mps, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, "attitude", ORR_NC_DOUBLE, 2, quats, imu->q_be, diag);
    if (s == ORR_OK && orr_nc_has_var(r, "measured_dtheta_rad")) {
        imu->measured_dtheta_rad = malloc(n * sizeof *imu->measured_dtheta_rad);
        imu->measured_dv_mps = malloc(n * sizeof *imu->measured_dv_mps);
        if (imu->measured_dtheta_rad == NULL || imu->measured_dv_mps == NULL)
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", n);
        s = orr_nc_get_var(r, "measured_dtheta_rad", ORR_NC_DOUBLE, 2, steps, imu->measured_dtheta_rad, diag);
        if (s == ORR_OK)
            s = orr_nc_get_var(r, "measured_dv_mps", ORR_NC_DOUBLE, 2, steps, imu->measured_dv_mps, diag);
    }
    if (s == ORR_OK && imu->gyro_radps != NULL)
        s = orr_nc_get_var(r, "gyro_radps", ORR_NC_DOUBLE, 2, edges, imu->gyro_radps, diag);
    if (s == ORR_OK && imu->accel_mps2 != NULL)
        s = orr_nc_get_var(r, "accel_mps2", ORR_NC_DOUBLE, 2, edges, imu->accel_mps2, diag);
    if (s == ORR_OK && imu->carried_r_m != NULL)
        s = orr_nc_get_var(r, "carried_position_m", ORR_NC_DOUBLE, 2, edges, imu->carried_r_m, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, "start_position_m", ORR_NC_DOUBLE, 1, &xyz, &imu->start_r_m, diag);
    if (s == ORR_OK)
        s = orr_nc_get_var(r, "start_velocity_mps", ORR_NC_DOUBLE, 1, &xyz, &imu->start_v_mps, diag);
    if (s == ORR_OK) s = orr_nc_get_var(r, "start_attitude", ORR_NC_DOUBLE, 1, &quat, &imu->start_q_bi, diag);
    if (s != ORR_OK) return s;
    for (size_t j = 0; j < n; j++)
        if (!isfinite(orr_vec3_norm(imu->dtheta_rad[j])) || !isfinite(orr_vec3_norm(imu->dv_mps[j])))
            return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "reading %zu is not finite", j);
    for (size_t j = 0; j < n && imu->measured_dtheta_rad != NULL; j++)
        if (!isfinite(orr_vec3_norm(imu->measured_dtheta_rad[j])) ||
            !isfinite(orr_vec3_norm(imu->measured_dv_mps[j])))
            return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "measured reading %zu is not finite", j);
    return check_truth(r, imu, diag);
}

// The file's axes become the program's.
static orr_status read_axes(const orr_nc_reader *r, orr_imu *imu, orr_diag *diag)
{
    char word[64];
    orr_status s = orr_nc_get_att_text(r, NULL, "axes", word, sizeof word, diag);
    if (s == ORR_E_NODATA) return ORR_OK; // of a file from before there were others
    if (s != ORR_OK || strcmp(word, orr_imu_axes_name(ORR_AXES_RFU)) == 0) return s;
    if (strcmp(word, orr_imu_axes_name(ORR_AXES_FRD)) != 0)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "readings in unknown axes \"%s\"", word);
    orr_axes_swap(imu->dtheta_rad, imu->n);
    orr_axes_swap(imu->dv_mps, imu->n);
    orr_axes_swap(imu->measured_dtheta_rad, imu->n);
    orr_axes_swap(imu->measured_dv_mps, imu->n);
    orr_axes_swap(imu->gyro_radps, imu->n + 1);
    orr_axes_swap(imu->accel_mps2, imu->n + 1);
    for (size_t k = 0; k < imu->n / imu->truth_every + 1; k++)
        imu->q_be[k] = orr_axes_swapped_quat(imu->q_be[k]);
    imu->start_q_bi = orr_axes_swapped_quat(imu->start_q_bi);
    return ORR_OK;
}

static orr_status read_gravimetry(const orr_nc_reader *r, orr_imu_file *f, orr_diag *diag)
{
    if (!orr_nc_has_var(r, "gravity_disturbance")) return ORR_OK;
    orr_gravimetry *g = &f->gravimetry;
    int64_t every;
    size_t n;
    orr_status s = need_int(r, "gravimetry_every", 1, (int64_t)f->imu.n, &every, diag);
    if (s == ORR_OK) s = orr_nc_get_dim(r, "gravimetry", f->imu.n + 1, &n, diag);
    if (s != ORR_OK) return s;
    if (n != f->imu.n / (size_t)every + 1)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0,
                           "%zu values of gravity do not go with %zu readings", n, f->imu.n);
    g->every = (size_t)every;
    s = orr_nc_alloc_var(r, "gravity_disturbance", ORR_NC_DOUBLE, 1, &n, (void **)&g->disturbance_mgal, diag);
    if (s == ORR_OK)
        s = orr_nc_alloc_var(r, "eotvos_term", ORR_NC_DOUBLE, 1, &n, (void **)&g->eotvos_mgal, diag);
    if (s == ORR_OK)
        s = orr_nc_alloc_var(r, "vertical_acceleration", ORR_NC_DOUBLE, 1, &n, (void **)&g->vertical_mps2,
                             diag);
    if (s == ORR_OK) g->n = n;
    return s;
}

static orr_status read_gravity(const orr_nc_reader *r, const char *model_dir, orr_imu_file *f, orr_diag *diag)
{
    orr_gravity_parts p = {0};
    char name[128], dir[1024];
    void *mass = NULL, *distance = NULL, *profile = NULL, *lat = NULL, *lon = NULL, *map = NULL;
    orr_status s = orr_nc_get_att_text(r, NULL, "gravity_model", name, sizeof name, diag);
    if (s == ORR_OK) {
        s = orr_nc_get_att_text(r, NULL, "gravity_model_folder", dir, sizeof dir, diag);
        const char *from = model_dir != NULL ? model_dir : s == ORR_OK ? dir : NULL;
        if (s == ORR_OK || s == ORR_E_NODATA) s = orr_gravity_model_open(name, from, &f->model, diag);
        p.model = f->model;
    } else if (s == ORR_E_NODATA) {
        s = ORR_OK;
    }
    if (s == ORR_OK && orr_nc_has_var(r, "gravity_masses")) {
        size_t shape[2] = {0, 4};
        s = orr_nc_get_dim(r, "mass", 100000, &shape[0], diag);
        if (s == ORR_OK) s = orr_nc_alloc_var(r, "gravity_masses", ORR_NC_DOUBLE, 2, shape, &mass, diag);
        p.n_masses = shape[0];
        p.mass = mass;
    }
    if (s == ORR_OK && orr_nc_has_var(r, "gravity_profile")) {
        s = orr_nc_get_dim(r, "profile", MAX_GRAVITY_POINTS, &p.n_profile, diag);
        if (s == ORR_OK) s = need_double(r, "gravity_profile_lat_rad", &p.profile_lat_rad, diag);
        if (s == ORR_OK) s = need_double(r, "gravity_profile_lon_rad", &p.profile_lon_rad, diag);
        if (s == ORR_OK) s = need_double(r, "gravity_profile_azimuth_rad", &p.profile_azimuth_rad, diag);
        if (s == ORR_OK)
            s = orr_nc_alloc_var(r, "gravity_profile_distance", ORR_NC_DOUBLE, 1, &p.n_profile, &distance,
                                 diag);
        if (s == ORR_OK)
            s = orr_nc_alloc_var(r, "gravity_profile", ORR_NC_DOUBLE, 1, &p.n_profile, &profile, diag);
        p.profile_distance_m = distance;
        p.profile_mgal = profile;
    }
    if (s == ORR_OK && orr_nc_has_var(r, "gravity_carried_by")) {
        const size_t shape[2] = {3, 3};
        s = orr_nc_get_var(r, "gravity_carried_by", ORR_NC_DOUBLE, 2, shape, p.carried_by.m, diag);
        p.carried = true;
        orr_mat3 T = orr_mat3_transpose(&p.carried_by), E = orr_mat3_mul(&p.carried_by, &T);
        for (int i = 0; i < 3 && s == ORR_OK; i++)
            for (int k = 0; k < 3; k++)
                if (!(fabs(E.m[i][k] - (i == k ? 1.0 : 0.0)) < 1e-9))
                    s = orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "gravity_carried_by is no rotation");
    }
    if (s == ORR_OK && orr_nc_has_var(r, "gravity_map")) {
        s = orr_nc_get_dim(r, "map_lat", MAX_GRAVITY_POINTS, &p.n_lat, diag);
        if (s == ORR_OK) s = orr_nc_get_dim(r, "map_lon", MAX_GRAVITY_POINTS, &p.n_lon, diag);
        size_t shape[2] = {p.n_lat, p.n_lon};
        if (s == ORR_OK) s = orr_nc_alloc_var(r, "gravity_map_lat", ORR_NC_DOUBLE, 1, &p.n_lat, &lat, diag);
        if (s == ORR_OK) s = orr_nc_alloc_var(r, "gravity_map_lon", ORR_NC_DOUBLE, 1, &p.n_lon, &lon, diag);
        if (s == ORR_OK) s = orr_nc_alloc_var(r, "gravity_map", ORR_NC_DOUBLE, 2, shape, &map, diag);
        p.map_lat_rad = lat;
        p.map_lon_rad = lon;
        p.map_mgal = map;
    }
    if (s == ORR_OK && (p.model != NULL || p.n_masses + p.n_profile + p.n_lat > 0))
        s = orr_gravity_make(&p, &f->gravity, diag);
    free(mass);
    free(distance);
    free(profile);
    free(lat);
    free(lon);
    free(map);
    return s;
}

// What everything else in the file depends on: mode, times, number of readings, how often there is truth.
static orr_status read_head(const orr_nc_reader *r, orr_imu *head, orr_diag *diag)
{
    char word[64];
    orr_status s = orr_nc_get_att_text(r, NULL, "format", word, sizeof word, diag);
    if (s != ORR_OK || strcmp(word, ORR_IMU_FORMAT) != 0)
        return orr_diag_at(diag, ORR_E_KIND, r->path, 0, 0,
                           "a NetCDF file, but no inertial readings ('orrery imu' makes them)");
    size_t n = 0, edges = 0;
    int64_t every = 1;
    s = read_mode(r, head, diag);
    if (s == ORR_OK) s = orr_nc_get_dim(r, "step", MAX_STEPS, &n, diag);
    if (s == ORR_OK) s = orr_nc_get_dim(r, "edge", MAX_STEPS + 1, &edges, diag);
    if (s == ORR_OK && edges != n + 1)
        s = orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "%zu steps do not go with %zu edges", n, edges);
    if (s == ORR_OK) s = need_int(r, "truth_every", 1, (int64_t)n, &every, diag);
    head->n = n;
    head->truth_every = (size_t)every;
    return s;
}

static void read_title(const orr_nc_reader *r, char title[256])
{
    if (orr_nc_get_att_text(r, NULL, "title", title, 256, NULL) != ORR_OK)
        title[0] = '\0'; // a title is decoration
}

orr_status orr_imu_read(const char *path, const char *model_dir, orr_imu_file *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_nc_reader r;
    orr_status s = orr_nc_open(path, &r, diag);
    if (s != ORR_OK) return s;
    orr_imu head = {0};
    s = read_head(&r, &head, diag);
    if (s == ORR_OK) {
        out->imu = head;
        s = orr_imu_allocate(&out->imu, head.n, head.truth_every, orr_nc_has_var(&r, "gyro_radps"),
                             orr_nc_has_var(&r, "carried_position_m"), diag);
    }
    if (s == ORR_OK) s = read_series(&r, &out->imu, diag);
    if (s == ORR_OK) s = read_axes(&r, &out->imu, diag);
    if (s == ORR_OK) s = read_gravimetry(&r, out, diag);
    if (s == ORR_OK) s = read_gravity(&r, model_dir, out, diag);
    read_title(&r, out->title);
    orr_nc_close(&r);
    if (s != ORR_OK) orr_imu_file_free(out);
    return s;
}

// Length of a dimension, 0 where there is none.
static size_t length_of(const orr_nc_reader *r, const char *dim)
{
    size_t n = 0;
    return orr_nc_get_dim(r, dim, SIZE_MAX, &n, NULL) == ORR_OK ? n : 0;
}

static void gravity_words(const orr_nc_reader *r, char *buf, size_t n)
{
    char model[128];
    size_t at, profile = length_of(r, "profile"), lat = length_of(r, "map_lat"), mass = length_of(r, "mass");
    if (orr_nc_get_att_text(r, NULL, "gravity_model", model, sizeof model, NULL) == ORR_OK)
        at = (size_t)snprintf(buf, n, "model %s", model);
    else
        at = (size_t)snprintf(buf, n, "normal gravity");
    if (profile > 0) at += (size_t)snprintf(buf + at, n - at, ", profile of %zu points", profile);
    if (lat > 0)
        at += (size_t)snprintf(buf + at, n - at, ", map of %zu x %zu points", lat, length_of(r, "map_lon"));
    if (mass > 0) snprintf(buf + at, n - at, ", %zu point mass%s", mass, mass == 1 ? "" : "es");
}

orr_status orr_imu_summarise(const char *path, orr_imu_summary *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_nc_reader r;
    orr_status s = orr_nc_open(path, &r, diag);
    if (s != ORR_OK) return s;
    orr_imu head = {0};
    s = read_head(&r, &head, diag);
    if (s == ORR_OK) {
        *out = (orr_imu_summary){.t0 = head.t0,
                                 .begin_s = head.begin_s,
                                 .rate_hz = head.rate_hz,
                                 .n = head.n,
                                 .mode = head.mode,
                                 .truth_every = head.truth_every,
                                 .instantaneous = orr_nc_has_var(&r, "gyro_radps"),
                                 .n_gravimetry = length_of(&r, "gravimetry")};
        gravity_words(&r, out->gravity, sizeof out->gravity);
        read_title(&r, out->title);
    }
    orr_nc_close(&r);
    return s;
}

void orr_imu_file_free(orr_imu_file *f)
{
    orr_imu_free(&f->imu);
    orr_gravimetry_free(&f->gravimetry);
    orr_gravity_free(f->gravity);
    orr_gravity_model_free(f->model);
    memset(f, 0, sizeof *f);
}

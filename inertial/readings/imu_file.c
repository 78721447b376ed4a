// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/readings/imu_file.h"

#include <stdlib.h>
#include <string.h>

static const char *const step_xyz[2] = {"step", "xyz"};
static const char *const edge_xyz[2] = {"edge", "xyz"};
static const char *const truth_xyz[2] = {"truth", "xyz"};
static const char *const truth_quat[2] = {"truth", "quat"};

static void put_vec(orr_nc_writer *w, const char *name, const char *const dims[2], const orr_vec3 *v,
                    const char *units, const char *long_name, orr_diag *diag)
{
    if (v != NULL) (void)orr_nc_put_var(w, name, ORR_NC_DOUBLE, 2, dims, v, units, long_name, diag);
}

static void put_gravity(orr_nc_writer *w, const orr_gravity *gravity, const orr_imu_labels *labels,
                        orr_diag *diag)
{
    orr_gravity_parts p = orr_gravity_parts_view(gravity);
    if (labels->gravity_model_name != NULL) {
        (void)orr_nc_put_att_text(w, NULL, "gravity_model", labels->gravity_model_name, diag);
        if (labels->gravity_model_dir != NULL)
            (void)orr_nc_put_att_text(w, NULL, "gravity_model_folder", labels->gravity_model_dir, diag);
    }
    if (p.n_masses > 0) {
        (void)orr_nc_put_dim(w, "mass", p.n_masses, diag);
        (void)orr_nc_put_dim(w, "xyz_gm", 4, diag);
        const char *dims[2] = {"mass", "xyz_gm"};
        (void)orr_nc_put_var(w, "gravity_masses", ORR_NC_DOUBLE, 2, dims, p.mass, NULL,
                             "extra point masses: ecef position (m) and GM (m3 s-2)", diag);
    }
    if (p.n_profile > 0) {
        double line[3] = {p.profile_lat_rad, p.profile_lon_rad, p.profile_azimuth_rad};
        const char *dims[1] = {"profile"};
        (void)orr_nc_put_dim(w, "profile", p.n_profile, diag);
        (void)orr_nc_put_var(w, "gravity_profile_distance", ORR_NC_DOUBLE, 1, dims, p.profile_distance_m, "m",
                             "distance along the gravity profile", diag);
        (void)orr_nc_put_var(w, "gravity_profile", ORR_NC_DOUBLE, 1, dims, p.profile_mgal, "mGal",
                             "gravity disturbance along the profile", diag);
        (void)orr_nc_put_att_double(w, "gravity_profile", "line_lat_lon_azimuth_rad", line, 3, diag);
        (void)orr_nc_put_att_double(w, NULL, "gravity_profile_lat_rad", &line[0], 1, diag);
        (void)orr_nc_put_att_double(w, NULL, "gravity_profile_lon_rad", &line[1], 1, diag);
        (void)orr_nc_put_att_double(w, NULL, "gravity_profile_azimuth_rad", &line[2], 1, diag);
    }
    if (p.carried) {
        const char *dims[2] = {"xyz", "xyz"};
        (void)orr_nc_put_var(w, "gravity_carried_by", ORR_NC_DOUBLE, 2, dims, p.carried_by.m, "1",
                             "rotation that profile and map were carried by with the trajectory", diag);
    }
    if (p.n_lat > 0) {
        const char *lat[1] = {"map_lat"}, *lon[1] = {"map_lon"}, *both[2] = {"map_lat", "map_lon"};
        (void)orr_nc_put_dim(w, "map_lat", p.n_lat, diag);
        (void)orr_nc_put_dim(w, "map_lon", p.n_lon, diag);
        (void)orr_nc_put_var(w, "gravity_map_lat", ORR_NC_DOUBLE, 1, lat, p.map_lat_rad, "rad", "latitudes",
                             diag);
        (void)orr_nc_put_var(w, "gravity_map_lon", ORR_NC_DOUBLE, 1, lon, p.map_lon_rad, "rad", "longitudes",
                             diag);
        (void)orr_nc_put_var(w, "gravity_map", ORR_NC_DOUBLE, 2, both, p.map_mgal, "mGal",
                             "gravity disturbance", diag);
    }
}

static void put_gravimetry(orr_nc_writer *w, const orr_gravimetry *g, orr_diag *diag)
{
    if (g == NULL || g->n == 0) return;
    const char *dims[1] = {"gravimetry"};
    int64_t every = (int64_t)g->every;
    (void)orr_nc_put_dim(w, "gravimetry", g->n, diag);
    (void)orr_nc_put_att_int64(w, NULL, "gravimetry_every", &every, 1, diag);
    (void)orr_nc_put_var(w, "gravity_disturbance", ORR_NC_DOUBLE, 1, dims, g->disturbance_mgal, "mGal",
                         "true gravity disturbance at every so many edges", diag);
    (void)orr_nc_put_var(w, "eotvos_term", ORR_NC_DOUBLE, 1, dims, g->eotvos_mgal, "mGal", "Eotvoes term",
                         diag);
    (void)orr_nc_put_var(w, "vertical_acceleration", ORR_NC_DOUBLE, 1, dims, g->vertical_mps2, "m s-2",
                         "rate of the vertical velocity over the ellipsoid", diag);
}

static void put_mode(orr_nc_writer *w, const orr_imu *imu, orr_diag *diag)
{
    char text[160], t0[ORR_TIME_TEXT];
    const orr_imu_mode *m = &imu->mode;
    int64_t approach = m->approach, order = m->order, degree = imu->knot_degree, t0_ns = imu->t0;
    (void)orr_nc_put_att_text(w, NULL, "format", ORR_IMU_FORMAT, diag);
    (void)orr_nc_put_att_text(w, NULL, "mode", orr_imu_mode_text(m, text, sizeof text), diag);
    (void)orr_nc_put_att_text(w, NULL, "readings", m->approach == 2 ? "physical" : "navigator-matched", diag);
    (void)orr_nc_put_att_int64(w, NULL, "approach", &approach, 1, diag);
    if (m->approach == 1) {
        (void)orr_nc_put_att_text(w, NULL, "frame", orr_nav_frame_name(m->frame), diag);
        (void)orr_nc_put_att_text(w, NULL, "projection", m->project_mid ? "mid" : "start", diag);
        (void)orr_nc_put_att_text(w, NULL, "loop", m->closed_loop ? "closed" : "open", diag);
    } else {
        (void)orr_nc_put_att_text(w, NULL, "quadrature",
                                  m->quadrature == ORR_QUADRATURE_GAUSS ? "gauss" : "riemann", diag);
        (void)orr_nc_put_att_int64(w, NULL, "order", &order, 1, diag);
    }
    (void)orr_nc_put_att_text(w, NULL, "t0_gps", orr_time_text(imu->t0, t0), diag);
    (void)orr_nc_put_att_int64(w, NULL, "t0_ns", &t0_ns, 1, diag);
    (void)orr_nc_put_att_double(w, NULL, "begin_s", &imu->begin_s, 1, diag);
    (void)orr_nc_put_att_double(w, NULL, "rate_hz", &imu->rate_hz, 1, diag);
    (void)orr_nc_put_att_double(w, NULL, "knot_origin_s", &imu->knot_origin_s, 1, diag);
    (void)orr_nc_put_att_double(w, NULL, "knot_step_s", &imu->knot_step_s, 1, diag);
    (void)orr_nc_put_att_int64(w, NULL, "knot_degree", &degree, 1, diag);
}

// A series in the file's axes.
static void put_body(orr_nc_writer *w, const char *name, const char *const dims[2], const orr_vec3 *v,
                     size_t n, orr_imu_axes axes, const char *units, const char *long_name, orr_diag *diag)
{
    if (v == NULL || axes == ORR_AXES_RFU) {
        put_vec(w, name, dims, v, units, long_name, diag);
        return;
    }
    orr_vec3 *swapped = malloc(n * sizeof *swapped);
    if (swapped == NULL) {
        w->status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", n);
        return;
    }
    memcpy(swapped, v, n * sizeof *v);
    orr_axes_swap(swapped, n);
    put_vec(w, name, dims, swapped, units, long_name, diag);
    free(swapped);
}

// The truth at every so many edges, together with its times.
typedef struct truth {
    double *time_s;
    orr_vec3 *r_m, *v_mps;
    orr_quat *q_be;
} truth;

static void truth_free(truth *t)
{
    free(t->time_s);
    free(t->r_m);
    free(t->v_mps);
    free(t->q_be);
}

static orr_status truth_gather(const orr_imu *imu, size_t every, orr_imu_axes axes, truth *t, orr_diag *diag)
{
    if (every > imu->n)
        return orr_diag_set(diag, ORR_E_ARG,
                            "truth at every %zu-th of %zu samples would be one instant alone", every, imu->n);
    if (every % imu->truth_every != 0)
        return orr_diag_set(diag, ORR_E_ARG, "the truth is there at every %zu-th sample, not at every %zu-th",
                            imu->truth_every, every);
    size_t n = imu->n / every + 1, stride = every / imu->truth_every;
    t->time_s = malloc(n * sizeof *t->time_s);
    t->r_m = malloc(n * sizeof *t->r_m);
    t->v_mps = malloc(n * sizeof *t->v_mps);
    t->q_be = malloc(n * sizeof *t->q_be);
    if (t->time_s == NULL || t->r_m == NULL || t->v_mps == NULL || t->q_be == NULL) {
        truth_free(t);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the truth of %zu instants", n);
    }
    for (size_t k = 0; k < n; k++) {
        t->time_s[k] = orr_imu_edge_s(imu, k * every);
        t->r_m[k] = imu->r_m[k * stride];
        t->v_mps[k] = imu->v_mps[k * stride];
        t->q_be[k] =
            axes == ORR_AXES_FRD ? orr_axes_swapped_quat(imu->q_be[k * stride]) : imu->q_be[k * stride];
    }
    return ORR_OK;
}

orr_status orr_imu_write(const char *path, const orr_imu *imu, const orr_gravimetry *gravimetry,
                         const orr_gravity *gravity, const orr_imu_labels *labels, orr_diag *diag)
{
    orr_nc_writer w;
    orr_status s = orr_nc_create(path, &w, diag);
    if (s != ORR_OK) return s;
    w.uncompressed =
        true; // noise-like digits hardly compress, and writing would take ten times as long as making them
    size_t every = labels->truth_every > 1 ? labels->truth_every : 1;
    truth t = {0};
    s = truth_gather(imu, every, labels->axes, &t, diag);
    if (s != ORR_OK) {
        orr_nc_abort(&w);
        return s;
    }
    // A failure of any call stands in the writer; the commit returns it.
    (void)orr_nc_put_provenance(&w, labels->title != NULL ? labels->title : "Inertial readings",
                                labels->history, labels->input, labels->n_inputs, diag);
    put_mode(&w, imu, diag);
    (void)orr_nc_put_att_text(&w, NULL, "axes", orr_imu_axes_name(labels->axes), diag);
    (void)orr_nc_put_dim(&w, "step", imu->n, diag);
    (void)orr_nc_put_dim(&w, "edge", imu->n + 1, diag);
    (void)orr_nc_put_dim(&w, "truth", imu->n / every + 1, diag);
    (void)orr_nc_put_att_int64(&w, NULL, "truth_every", &(int64_t){(int64_t)every}, 1, diag);
    (void)orr_nc_put_dim(&w, "xyz", 3, diag);
    (void)orr_nc_put_dim(&w, "quat", 4, diag);
    (void)orr_nc_put_var(&w, "time_s", ORR_NC_DOUBLE, 1, truth_xyz, t.time_s, "s",
                         "time of the truth since t0_gps; readings start at the first and follow at rate_hz",
                         diag);
    put_body(&w, "dtheta_rad", step_xyz, imu->dtheta_rad, imu->n, labels->axes, "rad",
             "integral of the absolute angular rate over the step, body axes", diag);
    put_body(&w, "dv_mps", step_xyz, imu->dv_mps, imu->n, labels->axes, "m s-1",
             "integral of the specific force over the step, body axes", diag);
    put_body(&w, "measured_dtheta_rad", step_xyz, imu->measured_dtheta_rad, imu->n, labels->axes, "rad",
             "the same as the gyros measure it, with their errors", diag);
    put_body(&w, "measured_dv_mps", step_xyz, imu->measured_dv_mps, imu->n, labels->axes, "m s-1",
             "the same as the accelerometers measure it, with their errors", diag);
    if (labels->errors != NULL) (void)orr_nc_put_att_text(&w, NULL, "errors", labels->errors, diag);
    put_body(&w, "gyro_radps", edge_xyz, imu->gyro_radps, imu->n + 1, labels->axes, "rad s-1",
             "absolute angular rate, body axes", diag);
    put_body(&w, "accel_mps2", edge_xyz, imu->accel_mps2, imu->n + 1, labels->axes, "m s-2",
             "specific force, body axes", diag);
    put_vec(&w, "position_m", truth_xyz, t.r_m, "m", "true position, ecef", diag);
    put_vec(&w, "velocity_mps", truth_xyz, t.v_mps, "m s-1", "true velocity relative to the Earth, ecef axes",
            diag);
    (void)orr_nc_put_var(&w, "attitude", ORR_NC_DOUBLE, 2, truth_quat, t.q_be, "1",
                         "true attitude, quaternion w x y z of body from ecef", diag);
    put_vec(&w, "carried_position_m", edge_xyz, imu->carried_r_m, "m",
            "inertial position that the closed loop carried", diag);
    const char *xyz[1] = {"xyz"}, *quat[1] = {"quat"};
    const orr_quat start_q =
        labels->axes == ORR_AXES_FRD ? orr_axes_swapped_quat(imu->start_q_bi) : imu->start_q_bi;
    (void)orr_nc_put_var(&w, "start_position_m", ORR_NC_DOUBLE, 1, xyz, &imu->start_r_m, "m",
                         "inertial position a navigator starts from", diag);
    (void)orr_nc_put_var(&w, "start_velocity_mps", ORR_NC_DOUBLE, 1, xyz, &imu->start_v_mps, "m s-1",
                         "absolute velocity it starts from, inertial axes", diag);
    (void)orr_nc_put_var(&w, "start_attitude", ORR_NC_DOUBLE, 1, quat, &start_q, "1",
                         "attitude it starts from, quaternion of body from inertial", diag);
    put_gravity(&w, gravity, labels, diag);
    put_gravimetry(&w, gravimetry, diag);
    truth_free(&t);
    return orr_nc_commit(&w, diag);
}

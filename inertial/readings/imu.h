// SPDX-License-Identifier: GPL-3.0-or-later
// A run of inertial readings with the truth beside them: what the generator makes, the file keeps and the
// null test navigates on. The mode says how the readings came about, so that readings matched to one
// navigator are never taken for physical ones.
#ifndef ORR_INERTIAL_READINGS_IMU_H
#define ORR_INERTIAL_READINGS_IMU_H

#include "inertial/gravity/gravity.h"

// Axes that approach 1 makes readings in, or that a one-step navigator integrates in.
typedef enum orr_nav_frame { ORR_FRAME_INERTIAL, ORR_FRAME_GEOGRAPHIC, ORR_FRAME_BODY } orr_nav_frame;
const char *orr_nav_frame_name(orr_nav_frame f); // "inertial", "geographic", "body"

typedef enum orr_quadrature { ORR_QUADRATURE_GAUSS, ORR_QUADRATURE_RIEMANN } orr_quadrature;

typedef struct orr_imu_mode {
    int approach; // 1: readings that one step of a navigator would need; 2: integrals of the true rate and
                  // force
    // approach 1
    orr_nav_frame frame;
    bool project_mid; // projects with the matrices of the middle of the step (Bogdanov 2015, eq. (18)), else
                      // of its begin
    bool closed_loop; // the generator carries the state of the navigator that will use the readings
    // approach 2
    orr_quadrature quadrature;
    int order; // nodes of Gauss-Legendre, 1..5, or rectangles of the Riemann sum (Bogdanov 2015, eq. (4))
} orr_imu_mode;

typedef struct orr_imu {
    orr_time t0;    // of every second below; the inertial frame coincides with ecef then
    double begin_s; // sample edges t_j = begin_s + j / rate_hz, j = 0..n
    double rate_hz;
    size_t n;
    orr_imu_mode mode;
    double knot_origin_s, knot_step_s; // of the trajectory; 0: none
    int knot_degree; // 3: a navigator's groups must end at knots; 5: smooth enough to pass over them
    orr_vec3 *dtheta_rad, *dv_mps; // [n] increments over [t_j, t_j+1], body axes
    orr_vec3 *measured_dtheta_rad,
        *measured_dv_mps;              // [n] the same with errors of sensors; NULL unless asked for
    orr_vec3 *gyro_radps, *accel_mps2; // [n + 1] instantaneous readings; NULL unless asked for
    size_t truth_every; // truth stands at edges 0, truth_every, 2 truth_every, ...: 1 as generated, more in
                        // files
    orr_vec3 *r_m,
        *v_mps;     // [n / truth_every + 1] truth: ecef position, velocity relative to the Earth in ecef axes
    orr_quat *q_be; // [n / truth_every + 1] truth: body from ecef
    // The state a navigator starts from at t_0, inertial axes; for approach 1 the velocity is that of its own
    // step.
    orr_vec3 start_r_m, start_v_mps;
    orr_quat start_q_bi;   // body from inertial
    orr_vec3 *carried_r_m; // [n + 1] inertial position that a closed loop carried, NULL otherwise
} orr_imu;

// Frees the arrays of a run; an empty one is allowed.
void orr_imu_free(orr_imu *m);
// Arrays for a run, not filled in.
//   Given:    n              samples, 1 to 50 million
//             truth_every    samples from one instant of truth to the next, at least 1
//             instantaneous  arrays for instantaneous readings too
//             carried        an array for the position that a closed loop carries
//   Returned: m              n, truth_every and the arrays; other members stay as they are
//   Notes:    ORR_E_LIMIT, ORR_E_ARG, ORR_E_MEMORY.
orr_status orr_imu_allocate(orr_imu *m, size_t n, size_t truth_every, bool instantaneous, bool carried,
                            orr_diag *diag);
// Readings with errors in the place of the ideal ones, and the other way: its own inverse.
void orr_imu_swap_measured(orr_imu *m);
// Time of edge j after t0, s.
static inline double orr_imu_edge_s(const orr_imu *m, size_t j)
{
    return m->begin_s + (double)j / m->rate_hz;
}

// Axes of the body that files of readings are in. Inside the program they are right, forward, up.
typedef enum orr_imu_axes { ORR_AXES_RFU, ORR_AXES_FRD } orr_imu_axes;
const char *orr_imu_axes_name(orr_imu_axes a); // "right forward up", "forward right down"
// Components in forward, right, down of a vector in right, forward, up, and the other way: the swap is its own inverse.
static inline orr_vec3 orr_axes_swapped(orr_vec3 v) { return orr_vec3_make(v.y, v.x, -v.z); }
void orr_axes_swap(orr_vec3 *v, size_t n); // n of them in place; NULL is allowed
// The same of the quaternion of body from any frame; twice is a quaternion of the same attitude.
orr_quat orr_axes_swapped_quat(orr_quat q);

// Matrix from ecef to the inertial axes at t_s after t0: r_inertial = R r_ecef (R3(-u t)).
orr_mat3 orr_inertial_from_ecef(double t_s);
// True inertial state at an edge, from the truth beside the readings.
//   Given:    m                   the run
//             j                   edge, a multiple of truth_every
//   Returned: r_m                 inertial position, m
//             v_mps               absolute velocity in inertial axes, m/s
//             body_from_inertial  attitude
void orr_imu_true_state(const orr_imu *m, size_t j, orr_vec3 *r_m, orr_vec3 *v_mps,
                        orr_mat3 *body_from_inertial);

// A sentence on the mode: "approach 1, inertial frame, mid-step projection, closed loop (navigator-matched)".
char *orr_imu_mode_text(const orr_imu_mode *mode, char *buf, size_t n);

#endif

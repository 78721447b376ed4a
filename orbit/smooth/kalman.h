// SPDX-License-Identifier: GPL-3.0-or-later
// The nine-state Kalman filter and Rauch-Tung-Striebel smoother of the orbit: x = (d_eta, d_V, f0),
// deviations of position and velocity from the a-priori trajectory in integration axes, and the empirical
// acceleration in its own axes (Bogdanov 2015, eq. (33)). Pure algebra on one step; room-internal.
#ifndef ORR_ORBIT_SMOOTH_KALMAN_H
#define ORR_ORBIT_SMOOTH_KALMAN_H

#include "core/status.h"
#include "core/vec.h"

#define ORR_NX 9

typedef struct orr_gauss { // mean and covariance
    double x[ORR_NX];
    double P[ORR_NX][ORR_NX];
} orr_gauss;

// x(k+1) = F x(k) + w: the upper six rows; the lower three are (0 0 E), f0 being a random walk.
typedef struct orr_transition {
    double F[6][ORR_NX];
    double h_s;
    orr_mat3 axes; // f0 axes to integration axes at mid-step
} orr_transition;

// Diffuse start: sigmas of position (m), velocity (m/s) and f0 (m/s^2); mean zero.
void orr_kalman_start(orr_gauss *g, double r_m, double v_mps, double f_mps2);
// Over one step with noise of f0 (qf, m^2/s^5) and of velocity (qv, m^2/s^3); `shift` (x_new = x + shift,
// first six) moves the mean to a restarted a-priori.
void orr_kalman_predict(const orr_gauss *from, const orr_transition *t, double qf, double qv,
                        const double shift[6], orr_gauss *to);
// Squared innovation over its formal variance, z' S^-1 z / 3, for z = measured minus a-priori position.
double orr_kalman_innovation2(const orr_gauss *g, orr_vec3 z, double sigma_m, double *length_m);
void orr_kalman_update(orr_gauss *g, orr_vec3 z, double sigma_m);
// One step back: from the filtered state at k, the prediction at k+1 and the smoothed state at k+1.
// ORR_E_NUMERIC if the prediction's covariance is not positive definite.
orr_status orr_kalman_smooth(const orr_gauss *filtered, const orr_transition *t,
                             const orr_gauss *predicted_next, const orr_gauss *smoothed_next,
                             orr_gauss *smoothed);

#endif

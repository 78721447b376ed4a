// SPDX-License-Identifier: GPL-3.0-or-later
// The Kalman filter and Rauch-Tung-Striebel smoother of the orbit: x = (d_eta, d_V, f0, d_ECOM), deviations
// of position and velocity from the a-priori trajectory in integration axes (m, m/s), the empirical
// acceleration in its own axes (m/s^2), and deviations of ECOM's coefficients from those of the a-priori
// force (nm/s^2), which are constant (Bogdanov 2015, eq. (33), has the first nine). Pure algebra on one step;
// room-internal.
#ifndef ORR_ORBIT_SMOOTH_KALMAN_H
#define ORR_ORBIT_SMOOTH_KALMAN_H

#include "core/status.h"
#include "orbit/dynamics/variational.h"

enum {
    ORR_NX = ORR_PARTIALS, // as partial derivatives have their columns
    ORR_NX_PLAIN = 9,      // without ECOM
    ORR_NW = 9,            // noise enters position, velocity and f0
};

typedef struct orr_gauss { // mean and covariance; of the first nx where a call says so
    double x[ORR_NX];
    double P[ORR_NX][ORR_NX];
} orr_gauss;

// x(k+1) = F x(k) + w: the upper six rows; the lower ones are those of the unit matrix. w has covariance q (Q
// + shadow S) in the first nine, where q and shadow are the caller's.
typedef struct orr_transition {
    double F[6][ORR_NX];
    double Q[ORR_NW][ORR_NW];
    double S[ORR_NW][ORR_NW]; // what of Q was built up near the Earth's shadow
    bool near_shadow;         // there is some
} orr_transition;

// What the noise of a step is multiplied by.
typedef struct orr_noise_factor {
    double q, shadow; // 1 and 0: as Q is
} orr_noise_factor;

// No time passes.
void orr_transition_start(orr_transition *t);
// Goes on by a step of h_s with partial derivatives F: white noise in d(f0)/dt (qf, m^2/s^5) and in dV/dt
// (qv, m^2/s^3), f0 acting through its axes at mid-step.
void orr_transition_append(orr_transition *t, double F[6][ORR_NX], const orr_mat3 *axes, double h_s,
                           double qf, double qv, bool near_shadow);

// What the noise of such a step was, given b = u of the end of all steps carried back to its end (F' u): its
// covariance times b.
void orr_noise_expected(const orr_mat3 *axes, double h_s, double qf, double qv, const double b[ORR_NW],
                        double w[ORR_NW]);

// Diffuse start: sigmas of position (m), velocity (m/s), f0 (m/s^2), and those that a prior has of ECOM; mean
// zero.
void orr_kalman_start(orr_gauss *g, double r_m, double v_mps, double f_mps2);
// Over one step; `shift` (x_new = x + shift) moves the mean to a restarted a-priori.
void orr_kalman_predict(const orr_gauss *from, const orr_transition *t, int nx, orr_noise_factor factor,
                        const double shift[ORR_NX], orr_gauss *to);
// Squared innovation over its formal variance, z' S^-1 z / 3, for z = measured minus a-priori position.
// *log_det (may be NULL): half the logarithm of det S.
double orr_kalman_innovation2(const orr_gauss *g, orr_vec3 z, double sigma_m, double *length_m,
                              double *log_det);
void orr_kalman_update(orr_gauss *g, int nx, orr_vec3 z, double sigma_m);
// One step back: from the filtered state at k, the prediction at k+1 and the smoothed state at k+1. u = P^-1
// (smoothed minus predicted) at k+1: what the noise of the step was, in a manner of speaking. ORR_E_NUMERIC
// if the prediction's covariance is not positive definite.
orr_status orr_kalman_smooth(const orr_gauss *filtered, const orr_transition *t, int nx,
                             const orr_gauss *predicted_next, const orr_gauss *smoothed_next,
                             orr_gauss *smoothed, double u[ORR_NX]);

#endif

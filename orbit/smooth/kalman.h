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

// Both as they are kept by the thousand: of what is symmetric the lower half.
typedef struct orr_gauss_kept {
    double x[ORR_NX];
    double P[ORR_NX * (ORR_NX + 1) / 2];
} orr_gauss_kept;
typedef struct orr_transition_kept {
    double F[6][ORR_NX];
    double Q[ORR_NW * (ORR_NW + 1) / 2], S[ORR_NW * (ORR_NW + 1) / 2];
    bool near_shadow;
} orr_transition_kept;

// Keeps the first nx of a state.
void orr_gauss_keep(const orr_gauss *g, int nx, orr_gauss_kept *out);
// The state as it was kept.
void orr_gauss_recall(const orr_gauss_kept *g, int nx, orr_gauss *out);
// An element of the covariance that was kept.
static inline double orr_gauss_kept_P(const orr_gauss_kept *g, int i, int j)
{
    return i < j ? g->P[j * (j + 1) / 2 + i] : g->P[i * (i + 1) / 2 + j];
}
// Keeps a transition.
void orr_transition_keep(const orr_transition *t, orr_transition_kept *out);
// The transition as it was kept.
void orr_transition_recall(const orr_transition_kept *t, orr_transition *out);

// What the noise of a step is multiplied by.
typedef struct orr_noise_factor {
    double q, shadow; // 1 and 0: as Q is
} orr_noise_factor;

// No time passes.
void orr_transition_start(orr_transition *t);
// Goes on by a step, with white noise in d(f0)/dt and in dV/dt.
// Given:
//   t            transition up to the step's begin
//   F            partial derivatives of the step
//   axes         of f0 at mid-step, to integration axes
//   h_s          length of the step, s
//   qf, qv       spectral densities of the noise of f0 (m^2/s^5) and of velocity (m^2/s^3)
//   near_shadow  the step's noise is also counted in t->S
// Returned:
//   t            transition up to the step's end
void orr_transition_append(orr_transition *t, double F[6][ORR_NX], const orr_mat3 *axes, double h_s,
                           double qf, double qv, bool near_shadow);

// What the noise of such a step was: its covariance times b.
// Given:
//   axes, h_s, qf, qv  as of orr_transition_append
//   b                  the adjoint u of the end of all steps, carried back to this one's end (F' u)
// Returned:
//   w                  expectation of the noise of position, velocity and f0
void orr_noise_expected(const orr_mat3 *axes, double h_s, double qf, double qv, const double b[ORR_NW],
                        double w[ORR_NW]);

// Diffuse start, mean zero.
// Given:
//   r_m, v_mps, f_mps2  sigmas of position, velocity and f0
//   ecom_nmps2          those of ECOM's terms (orr_ecom_sigma_nmps2)
// Returned:
//   g                   the state
void orr_kalman_start(double r_m, double v_mps, double f_mps2, const double ecom_nmps2[ORR_ECOM_TERMS],
                      orr_gauss *g);
// Prediction over one step: x = F x + shift, P = F P F' + noise.
// Given:
//   from    state at the step's begin
//   t       transition
//   nx      states that are used, ORR_NX or ORR_NX_PLAIN
//   factor  of the noise
//   shift   arriving minus departing a-priori state, where the a-priori trajectory is restarted
// Returned:
//   to      state at the step's end
void orr_kalman_predict(const orr_gauss *from, const orr_transition *t, int nx, orr_noise_factor factor,
                        const double shift[ORR_NX], orr_gauss *to);
// Squared innovation over its formal variance.
// Given:
//   g         predicted state
//   z         measured minus a-priori position, m
//   sigma_m   of a coordinate of z
// Returned:
//   length_m  length of the innovation e = z - x; may be NULL
//   log_det   half the logarithm of det S, S the innovation's covariance; may be NULL
//   value     e' S^-1 e / 3
double orr_kalman_innovation2(const orr_gauss *g, orr_vec3 z, double sigma_m, double *length_m,
                              double *log_det);
// Takes in a measured minus a-priori position z (m; sigma_m of a coordinate) by Joseph's form.
void orr_kalman_update(orr_gauss *g, int nx, orr_vec3 z, double sigma_m);
// One step back of the Rauch-Tung-Striebel smoother.
// Given:
//   filtered        state at instant k
//   t               transition from k to k + 1
//   nx              states that are used
//   predicted_next  state at k + 1 before its nodes
//   smoothed_next   state at k + 1, smoothed
// Returned:
//   smoothed        state at k
//   u               the adjoint at k + 1: inverse of the predicted covariance times (smoothed minus predicted)
// Errors: ORR_E_NUMERIC if the predicted covariance is not positive definite.
orr_status orr_kalman_smooth(const orr_gauss *filtered, const orr_transition *t, int nx,
                             const orr_gauss *predicted_next, const orr_gauss *smoothed_next,
                             orr_gauss *smoothed, double u[ORR_NX]);

#endif

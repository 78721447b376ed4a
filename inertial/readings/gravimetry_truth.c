// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/readings/gravimetry_truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void orr_gravimetry_free(orr_gravimetry *g)
{
    free(g->disturbance_mgal);
    free(g->eotvos_mgal);
    free(g->vertical_mps2);
    memset(g, 0, sizeof *g);
}

void orr_gravity_terms(const orr_gravity *g, const orr_motion *m, double *disturbance_mgal,
                       double *eotvos_mgal, double *vertical_mps2)
{
    orr_geodetic at = orr_earth_from_ecef(m->r_m);
    orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
    double round_mps2;
    *eotvos_mgal = orr_motion_eotvos(m, &round_mps2) / ORR_MPS2_PER_MGAL;
    *vertical_mps2 = orr_mat3_apply(&E, m->a_mps2).z + round_mps2;
    *disturbance_mgal = orr_gravity_disturbance_mgal(g, m->r_m);
}

orr_status orr_gravimetry_truth(const orr_trajectory *tr, const orr_gravity *g, const orr_imu *imu,
                                size_t every, orr_gravimetry *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (every == 0) every = imu->rate_hz > 10.0 ? (size_t)nearbyint(imu->rate_hz / 10.0) : 1;
    if (every > imu->n) every = imu->n;
    every = (every + imu->truth_every - 1) / imu->truth_every * imu->truth_every;
    size_t n = imu->n / every + 1;
    out->n = n;
    out->every = every;
    out->disturbance_mgal = malloc(n * sizeof(double));
    out->eotvos_mgal = malloc(n * sizeof(double));
    out->vertical_mps2 = malloc(n * sizeof(double));
    if (out->disturbance_mgal == NULL || out->eotvos_mgal == NULL || out->vertical_mps2 == NULL) {
        orr_gravimetry_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the gravimetry of %zu instants", n);
    }
    for (size_t k = 0; k < n; k++) {
        orr_motion m;
        tr->evaluate(tr->self, orr_imu_edge_s(imu, k * every), &m);
        orr_gravity_terms(g, &m, &out->disturbance_mgal[k], &out->eotvos_mgal[k], &out->vertical_mps2[k]);
    }
    return ORR_OK;
}

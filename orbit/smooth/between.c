// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/between.h"

#include <string.h>

// E[x_j] = F_j x_(j-1) + Q_j b_j where b_j carries u back from the interval's end to the end of step j.
orr_status orr_track_between(const orr_track_context *c, orr_track *t, size_t k, double (*x)[ORR_NX],
                             double (*b)[ORR_NW])
{
    const orr_instant *at = &t->at[k];
    const size_t n = t->at[k + 1].grid - at->grid;
    const orr_filter_noise *noise = &c->noise;
    const orr_grid_step *step;
    const orr_status s = orr_track_step(c, t, at->grid, &step);
    if (s != ORR_OK) return s;
    memcpy(x[0], at->state.x, sizeof x[0]);
    memcpy(b[n - 1], t->at[k + 1].u, sizeof b[0]);
    for (size_t j = n - 1; j > 0; j--) {
        for (int i = 0; i < ORR_NW; i++) {
            b[j - 1][i] = i < 6 ? 0 : b[j][i];
            for (int m = 0; m < 6; m++) b[j - 1][i] += step[j].F[m][i] * b[j][m];
        }
    }
    for (size_t j = 0; j + 1 < n; j++) {
        const orr_grid_point *g = &t->grid[at->grid + j];
        const double h = g[1].t_s - g->t_s, times = noise->factor.q * (1 + (g->near_shadow ? at->shadow : 0));
        double w[ORR_NW];
        orr_noise_expected(&step[j].axes, h, times * at->noise * noise->qf_m2ps5, times * noise->qv_m2ps3,
                           b[j], w);
        for (int i = 0; i < ORR_NX; i++) {
            x[j + 1][i] = (i < 6 ? 0 : x[j][i]) + (i < ORR_NW ? w[i] : 0);
            for (int m = 0; m < noise->nx && i < 6; m++) x[j + 1][i] += step[j].F[i][m] * x[j][m];
        }
    }
    return ORR_OK;
}

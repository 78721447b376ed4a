// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/receiver/fix.h"

#include <math.h>

#include "core/constants.h"
#include "core/linalg.h"

#define NO_DOP 99.99
#define LEAST_PIVOT 1e-9 // of satellites in one plane with the antenna nothing is told

static void dilutions(double h[16], size_t n, orr_fix *f)
{
    double variance[3] = {0};
    f->valid =
        n >= 4 && orr_cholesky_factor(h, 4, LEAST_PIVOT) == ORR_OK && orr_cholesky_invert(h, 4) == ORR_OK;
    f->pdop = f->hdop = f->vdop = NO_DOP;
    if (!f->valid) return;
    for (size_t k = 0; k < 3; k++) {
        variance[k] = h[5 * k];
        f->sigma_m[k] = f->range_sigma_m * sqrt(variance[k]);
    }
    f->hdop = fmin(sqrt(variance[0] + variance[1]), NO_DOP);
    f->vdop = fmin(sqrt(variance[2]), NO_DOP);
    f->pdop = fmin(sqrt(variance[0] + variance[1] + variance[2]), NO_DOP);
}

orr_status orr_fix_of(const orr_antenna *a, const orr_observed *o, orr_fix *out, orr_diag *diag)
{
    char text[ORR_TIME_TEXT];
    orr_antenna_state at;
    if (orr_antenna_at(a, o->t, &at) != ORR_ANSWER_OK)
        return orr_diag_set(diag, ORR_E_RANGE, "antenna %s has no motion at %s", a->name,
                            orr_time_text(o->t, text));
    *out = (orr_fix){.g = orr_earth_from_ecef(at.r_m)};
    const orr_mat3 enu = orr_earth_enu_from_ecef(out->g.lat_rad, out->g.lon_rad);
    out->v_mps = orr_mat3_apply(&enu, at.v_mps);
    out->speed_mps = hypot(out->v_mps.x, out->v_mps.y);
    if (out->speed_mps > 0) out->course_rad = atan2(out->v_mps.x, out->v_mps.y);
    if (out->course_rad < 0) out->course_rad += 2 * ORR_PI;
    double h[16] = {0}, square = 0;
    for (size_t k = 0; k < o->n; k++) {
        const orr_observation *y = &o->item[k];
        square += y->code_sigma_m * y->code_sigma_m;
        if (k > 0 && y->sat == o->item[k - 1].sat) continue;
        const double u[4] = {sin(y->az_rad) * cos(y->el_rad), cos(y->az_rad) * cos(y->el_rad), sin(y->el_rad),
                             1};
        for (size_t i = 0; i < 4; i++)
            for (size_t j = 0; j < 4; j++) h[4 * i + j] += u[i] * u[j];
        out->n_sats++;
    }
    out->range_sigma_m = o->n > 0 ? sqrt(square / (double)o->n) : 0;
    dilutions(h, out->n_sats, out);
    return ORR_OK;
}

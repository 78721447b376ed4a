// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/frame_check.h"

#include <math.h>

#include "core/constants.h"
#include "core/robust.h"
#include "core/vec.h"

#define MOST_STEP_S 1800.0
enum { MOST_PAIRS = 400, LEAST_PAIRS = 8 };
// Of the angle between neighbouring positions over that of Kepler's third law: eccentric orbits of navigation depart by a few
// hundredths in the median, the Earth's turn by a third of what MEO do and by all of a geostationary one's.
#define NEAR 0.05
#define FAR 0.1

static orr_vec3 position(const orr_sp3 *f, size_t epoch, size_t sat)
{
    const double *p = f->record[epoch * f->n_sats + sat].pos_m;
    return (orr_vec3){p[0], p[1], p[2]};
}

// How far the angle between two positions is off that of the third law, as a part of it.
static double off_kepler(orr_vec3 a, orr_vec3 b, double dt_s)
{
    const double radius = 0.5 * (orr_vec3_norm(a) + orr_vec3_norm(b));
    const double rate = sqrt(ORR_EGM96_GM / (radius * radius * radius));
    const double angle = atan2(orr_vec3_norm(orr_vec3_cross(a, b)), orr_vec3_dot(a, b));
    return fabs(angle / (rate * dt_s) - 1);
}

orr_status orr_frame_check(const orr_sp3 *sp3, const char *name, orr_diag *diag)
{
    double as_they_are[MOST_PAIRS], turned[MOST_PAIRS];
    size_t n = 0;
    for (size_t e = 0; e + 1 < sp3->n_epochs && n < MOST_PAIRS; e++) {
        const double dt_s = orr_time_diff_s(sp3->epoch[e + 1], sp3->epoch[e]);
        if (dt_s > MOST_STEP_S) continue;
        const orr_mat3 back = orr_mat3_rot3(-ORR_EARTH_RATE_RADPS * dt_s);
        for (size_t k = 0; k < sp3->n_sats && n < MOST_PAIRS; k++) {
            const orr_vec3 a = position(sp3, e, k), b = position(sp3, e + 1, k);
            if (!isfinite(orr_vec3_dot(a, b)) || !(orr_vec3_norm(a) > ORR_EGM96_RADIUS_M)) continue;
            as_they_are[n] = off_kepler(a, b, dt_s);
            turned[n++] = off_kepler(a, orr_mat3_apply(&back, b), dt_s);
        }
    }
    if (n < LEAST_PAIRS || !(orr_median(as_they_are, n) < NEAR) || !(orr_median(turned, n) > FAR))
        return ORR_OK;
    return orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0,
                       "its positions do not turn with the Earth: they are in inertial axes (its header says "
                       "\"%s\"); SP3 has "
                       "Earth-fixed ones, turn them before",
                       sp3->coordinates);
}

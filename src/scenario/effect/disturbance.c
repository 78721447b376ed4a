// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/disturbance.h"

#include <math.h>
#include <stdlib.h>

#include "core/constants.h"

// A direction over the ground from a place.
typedef struct heading {
    double lat_rad, lon_rad, sin_az, cos_az, speed_mps;
    orr_time time;
} heading;

typedef struct wave {
    heading h;
    double amplitude_tecu, length_m, phase_rad;
} wave;

typedef struct front {
    heading h;
    double tecu_per_m, width_m;
} front;

struct orr_disturbance {
    size_t n_waves, n_fronts;
    wave *wave;
    front *front;
    orr_mapping mapping;
};

static const double ROUND_M = 1000;

static heading heading_of(const double *position, double azimuth_deg, double speed_mps, orr_time time)
{
    return (heading){.lat_rad = position[0] * ORR_RAD_PER_DEG,
                     .lon_rad = position[1] * ORR_RAD_PER_DEG,
                     .sin_az = sin(azimuth_deg * ORR_RAD_PER_DEG),
                     .cos_az = cos(azimuth_deg * ORR_RAD_PER_DEG),
                     .speed_mps = speed_mps,
                     .time = time};
}

orr_status orr_disturbance_open(const orr_scenario *s, orr_disturbance **out, orr_diag *diag)
{
    const orr_scenario_disturbance *o = &s->disturbance;
    *out = NULL;
    if (o->waves.n + o->fronts.n == 0) return ORR_OK;
    orr_disturbance *d = calloc(1, sizeof *d);
    if (d != NULL) {
        d->wave = calloc(o->waves.n + 1, sizeof *d->wave);
        d->front = calloc(o->fronts.n + 1, sizeof *d->front);
    }
    if (d == NULL || d->wave == NULL || d->front == NULL) {
        orr_disturbance_close(d);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    d->mapping = orr_mapping_published(ORR_MAPPING_THIN_SHELL);
    for (; d->n_waves < o->waves.n; d->n_waves++) {
        const orr_scenario_tec_wave *w = &o->waves.item[d->n_waves];
        d->wave[d->n_waves] = (wave){.h = heading_of(w->position.item, w->azimuth_deg, w->speed_mps, w->time),
                                     .amplitude_tecu = w->amplitude_tecu,
                                     .length_m = 1e3 * w->length_km,
                                     .phase_rad = w->phase_deg * ORR_RAD_PER_DEG};
    }
    for (; d->n_fronts < o->fronts.n; d->n_fronts++) {
        const orr_scenario_front *f = &o->fronts.item[d->n_fronts];
        d->front[d->n_fronts] =
            (front){.h = heading_of(f->position.item, f->azimuth_deg, f->speed_mps, f->time),
                    .tecu_per_m = f->gradient_mmpkm * 1e-6 * ORR_L1_HZ * ORR_L1_HZ / ORR_IONO_K_M3_PER_S2,
                    .width_m = 1e3 * f->width_km};
    }
    *out = d;
    return ORR_OK;
}

void orr_disturbance_close(orr_disturbance *d)
{
    if (d == NULL) return;
    free(d->wave);
    free(d->front);
    free(d);
}

// How far a pierce point is ahead of what moves, along its azimuth: on the shell, flat about the place.
static double ahead_m(const heading *h, orr_time t, const orr_pierce *p)
{
    const double north = p->lat_rad - h->lat_rad,
                 east = remainder(p->lon_rad - h->lon_rad, 2 * ORR_PI) * cos(h->lat_rad);
    return ORR_SHELL_RADIUS_M * (east * h->sin_az + north * h->cos_az) -
           h->speed_mps * orr_time_diff_s(t, h->time);
}

// The ramp max(x, 0), its corner rounded by a quartic with continuous second derivative over +-ROUND_M.
static double ramp(double x)
{
    if (x <= -ROUND_M) return 0;
    if (x >= ROUND_M) return x;
    const double s = (x / ROUND_M + 1) / 2;
    return 2 * ROUND_M * s * s * s * (1 - s / 2);
}

double orr_disturbance_tecu(const orr_disturbance *d, orr_time t, const orr_pierce *p)
{
    double vertical = 0, slant = 0;
    for (size_t k = 0; k < d->n_waves; k++) {
        const wave *w = &d->wave[k];
        vertical += w->amplitude_tecu * cos(2 * ORR_PI * ahead_m(&w->h, t, p) / w->length_m + w->phase_rad);
    }
    for (size_t k = 0; k < d->n_fronts; k++) {
        const front *f = &d->front[k];
        const double behind = -ahead_m(&f->h, t, p);
        slant += f->tecu_per_m * (ramp(behind) - ramp(behind - f->width_m));
    }
    return slant + (d->n_waves > 0 ? vertical * orr_mapping_factor(&d->mapping, p->el_rad) : 0);
}

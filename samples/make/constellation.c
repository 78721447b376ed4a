// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/make/constellation.h"

#include "core/rng.h"

#define SEED 20250320
#define DEG ORR_RAD_PER_DEG

enum { STREAM_ORBIT = 1, STREAM_CLOCK = 2 };

orr_time orr_sample_start(void)
{
    return (orr_time)(orr_mjd_from_date(2025, 3, 20) - orr_mjd_from_date(1980, 1, 6)) * ORR_S_PER_DAY *
           ORR_NS_PER_S;
}

typedef struct layout {
    char system;
    int planes, slots;                         // slots a plane
    double a_m, e, i_deg, raan_deg, phase_deg; // phase: of a plane against the one before
    double e_spread, i_spread_deg;
    orr_sample_body body;
    double clock_spread_s, drift_spread_sps, white_fm;
} layout;

static const layout LAYOUTS[] = {
    // 32 slots of 36: GPS numbers end at 32
    {'G',
     6,
     6,
     26559.8e3,
     0.008,
     55.0,
     12.0,
     33.0,
     0.006,
     0.8,
     {1450, 22.3, 5.4, 5.1, 0.20, 0.02, 0.14, 0.20, -6e-10},
     3e-4,
     8e-12,
     1.0e-12},
    {'R',
     3,
     8,
     25508.0e3,
     0.001,
     64.8,
     75.0,
     15.0,
     0.0008,
     0.4,
     {1415, 30.9, 4.2, 1.7, 0.18, 0.06, 0.15, 0.25, 4e-10},
     2e-4,
     5e-12,
     4.0e-12},
    {'E',
     3,
     8,
     29600.3e3,
     0.0003,
     56.0,
     40.0,
     15.0,
     0.0002,
     0.3,
     {707, 10.8, 1.3, 3.0, 0.08, 0.0, 0.10, 0.15, -8e-10},
     5e-4,
     2e-12,
     6.0e-13},
};

static double draw(orr_sat sat, int what)
{
    return 2 * orr_rng_uniform(SEED, STREAM_ORBIT, (uint64_t)sat * 16 + (uint64_t)what) - 1;
}

static orr_sample_sat make(const layout *l, int plane, int slot, int number)
{
    orr_sample_sat s = {.sat = orr_sat_make(l->system, number), .a_m = l->a_m, .body = l->body};
    s.e = l->e + l->e_spread * draw(s.sat, 0);
    s.i_rad = (l->i_deg + l->i_spread_deg * draw(s.sat, 1)) * DEG;
    s.raan_rad = (l->raan_deg + 360.0 / l->planes * plane + 1.5 * draw(s.sat, 2)) * DEG;
    s.argp_rad = 180 * draw(s.sat, 3) * DEG;
    double u = 360.0 / l->slots * slot + l->phase_deg * plane + 4 * draw(s.sat, 4); // argument of latitude
    s.m_rad = u * DEG - s.argp_rad;
    s.body.mass_kg *= 1 + 0.05 * draw(s.sat, 5);
    s.body.y_bias_mps2 *= 1 + 0.5 * draw(s.sat, 6);
    s.clock_s = l->clock_spread_s * draw(s.sat, 7);
    s.drift_sps = l->drift_spread_sps * draw(s.sat, 8);
    s.white_fm = l->white_fm * (1 + 0.3 * draw(s.sat, 9));
    return s;
}

size_t orr_sample_constellation(orr_sample_sat *sat)
{
    size_t n = 0;
    for (size_t k = 0; k < sizeof LAYOUTS / sizeof LAYOUTS[0]; k++) {
        const layout *l = &LAYOUTS[k];
        for (int i = 0; i < l->planes * l->slots && i < 32; i++)
            sat[n++] = make(l, i % l->planes, i / l->planes, i + 1);
    }
    // A pair left in eccentric orbits, opposite each other in one plane.
    for (size_t k = 0; k < n; k++) {
        orr_sample_sat *s = &sat[k];
        if (s->sat != orr_sat_make('E', 14) && s->sat != orr_sat_make('E', 18)) continue;
        s->a_m = 27977.6e3;
        s->e = 0.162;
        s->i_rad = 49.9 * DEG;
        s->raan_rad = 105 * DEG;
        s->argp_rad = 52 * DEG;
        s->m_rad = orr_sat_number(s->sat) == 14 ? 0.3 : 0.3 + ORR_PI;
    }
    return n;
}

static orr_time at(int day, int hour, int minute)
{
    return orr_sample_start() + ((orr_time)day * 86400 + hour * 3600 + minute * 60) * ORR_NS_PER_S;
}

size_t orr_sample_events(orr_sample_event *event)
{
    size_t n = 0;
    // Times of day count from 0 on the first day. The middle day has quiet orbits, for figures of the
    // smoother.
    event[n++] = (orr_sample_event){ORR_SAMPLE_GAP, orr_sat_make('R', 8), at(0, 9, 0), at(0, 12, 0), 0};
    event[n++] =
        (orr_sample_event){ORR_SAMPLE_NOCLOCK, orr_sat_make('E', 18), at(0, 17, 0), at(0, 19, 30), 0};
    event[n++] =
        (orr_sample_event){ORR_SAMPLE_RESET, orr_sat_make('G', 17), at(1, 10, 0), at(1, 10, 0), 4.2e-5};
    event[n++] = (orr_sample_event){ORR_SAMPLE_NOCLOCK, orr_sat_make('R', 21), at(1, 0, 0), at(1, 24, 0), 0};
    event[n++] = (orr_sample_event){ORR_SAMPLE_BURN, orr_sat_make('G', 10), at(2, 14, 5), at(2, 14, 5), 0.12};
    event[n++] = (orr_sample_event){ORR_SAMPLE_GAP, orr_sat_make('E', 24), at(2, 0, 15), at(2, 24, 0), 0};
    return n;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_fast_ionosphere.h"

#include <math.h>
#include <stdio.h>

#include "src/config/rows_private.h"

#define PAIR_ROW(n, m, lo, hi, u, h)                                                                         \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .list = true, .offset = offsetof(orr_scenario_scintillation, m),    \
        .min = lo, .max = hi, .least = 2, .most = 2, .unit = u, .help = h                                    \
    }
static const orr_key scintillation_rows[] = {
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .offset = offsetof(orr_scenario_scintillation, sats),
     .given = offsetof(orr_scenario_scintillation, has_sats),
     .help = "satellites whose rays it concerns; default: all. The first of the list that names a satellite "
             "is its"},
    {.name = "from",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_scintillation, from),
     .given = offsetof(orr_scenario_scintillation, has_from),
     .help = "its begin; it rises and falls within 10 s"},
    {.name = "to",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_scintillation, to),
     .given = offsetof(orr_scenario_scintillation, has_to),
     .help = "its end"},
    PAIR_ROW("latitude", latitude_deg, -90, 90, "deg",
             "of the pierce point at 450 km, from and to; it fades out within half a degree beyond"),
    PAIR_ROW("longitude", longitude_deg, -360, 360, "deg", "likewise, eastwards"),
    PAIR_ROW(
        "local_time", local_time_h, 0, 24, "h",
        "mean solar time there, from and to, over midnight where to is earlier; fading out within 6 minutes"),
    REAL_ROW(
        orr_scenario_scintillation, "s4", s4, 0, 1, NULL, "0", NULL,
        "standard deviation of power over its mean, at 1575.42 MHz; of other carriers by f^-1.5, at most 1"),
    REAL_ROW(orr_scenario_scintillation, "tau0", tau0_s, 0.1, 10, "s", "0.5", NULL,
             "time in which the scattered part's correlation falls to 1/e"),
    REAL_ROW(
        orr_scenario_scintillation, "sigma_phi", sigma_phi_rad, 0, 10, "rad", "0", NULL,
        "standard deviation of the refractive phase above 0.1 Hz, at 1575.42 MHz; of other carriers by 1/f"),
    REAL_ROW(orr_scenario_scintillation, "slope", slope, 1.5, 4, NULL, "2.6", NULL,
             "p of its spectrum f^-p, from 0.1 to 10 Hz"),
    INT_ROW(orr_scenario_scintillation, "seed", seed, 0, 9e15, "1", NULL, "seed"),
};
static const char *check_scintillation(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_scintillation *x = map;
    if (!(x->s4 > 0) && !(x->sigma_phi_rad > 0)) {
        snprintf(why, ORR_SCHEMA_WHY, "has no effect without s4 or sigma_phi");
        return "";
    }
    if (x->has_from && x->has_to && x->to <= x->from) {
        snprintf(why, ORR_SCHEMA_WHY, "it ends before it begins");
        return "to";
    }
    if (x->latitude_deg.n == 2 && x->latitude_deg.item[1] < x->latitude_deg.item[0]) {
        snprintf(why, ORR_SCHEMA_WHY, "from south to north");
        return "latitude";
    }
    return NULL;
}
const orr_schema orr_section_scintillation = {.key = scintillation_rows,
                                              .n = sizeof scintillation_rows / sizeof scintillation_rows[0],
                                              .size = sizeof(orr_scenario_scintillation),
                                              .check = check_scintillation};

#define PLACE_ROW(T, h)                                                                                      \
    {                                                                                                        \
        .name = "position", .kind = ORR_KEY_REAL, .list = true, .required = true,                            \
        .offset = offsetof(T, position), .min = -360, .max = 360, .least = 2, .most = 2, .unit = "deg",      \
        .help = h                                                                                            \
    }
#define WHEN_ROW(T, h)                                                                                       \
    {                                                                                                        \
        .name = "time", .kind = ORR_KEY_TIME, .required = true, .offset = offsetof(T, time), .help = h       \
    }
static const orr_key wave_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_tec_wave, "amplitude", amplitude_tecu, 1e-3, 50, "TECU", NULL,
                    "of the vertical content"),
    NEEDED_REAL_ROW(orr_scenario_tec_wave, "length", length_km, 10, 5000, "km", NULL, "wavelength at 450 km"),
    NEEDED_REAL_ROW(orr_scenario_tec_wave, "speed", speed_mps, 0, 3000, "m/s", NULL, "of its phase"),
    NEEDED_REAL_ROW(orr_scenario_tec_wave, "azimuth", azimuth_deg, -360, 360, "deg", NULL,
                    "towards which it goes, clockwise from North"),
    REAL_ROW(orr_scenario_tec_wave, "phase", phase_deg, -360, 360, "deg", "0", NULL,
             "of the cosine at that place and time"),
    PLACE_ROW(orr_scenario_tec_wave, "latitude and longitude of a pierce point"),
    WHEN_ROW(orr_scenario_tec_wave, "when its phase is so there"),
};
static const orr_key front_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_front, "gradient", gradient_mmpkm, -1000, 1000, "mm/km", NULL,
                    "of the slant delay at 1575.42 MHz behind its foremost edge"),
    NEEDED_REAL_ROW(orr_scenario_front, "width", width_km, 5, 1000, "km", NULL,
                    "over which the delay grows; behind it stays"),
    NEEDED_REAL_ROW(orr_scenario_front, "speed", speed_mps, 0, 3000, "m/s", NULL, "of the front"),
    NEEDED_REAL_ROW(orr_scenario_front, "azimuth", azimuth_deg, -360, 360, "deg", NULL,
                    "towards which it goes, clockwise from North"),
    PLACE_ROW(orr_scenario_front, "latitude and longitude of a pierce point on the foremost edge"),
    WHEN_ROW(orr_scenario_front, "when it is there"),
};
#define ON_EARTH(position) (fabs((position).item[0]) <= 90)
static const char *check_wave(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_tec_wave *w = map;
    if (ON_EARTH(w->position)) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "latitude %g is no place", w->position.item[0]);
    return "position";
}
static const char *check_front(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_front *f = map;
    if (ON_EARTH(f->position)) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "latitude %g is no place", f->position.item[0]);
    return "position";
}
static const orr_schema wave_table = {.key = wave_rows,
                                      .n = sizeof wave_rows / sizeof wave_rows[0],
                                      .size = sizeof(orr_scenario_tec_wave),
                                      .check = check_wave};
static const orr_schema front_table = {.key = front_rows,
                                       .n = sizeof front_rows / sizeof front_rows[0],
                                       .size = sizeof(orr_scenario_front),
                                       .check = check_front};
static const orr_key disturbance_rows[] = {
    MAPS_ROW(orr_scenario_disturbance, "waves", waves, &wave_table, 20, NULL, "travelling disturbances"),
    MAPS_ROW(orr_scenario_disturbance, "fronts", fronts, &front_table, 10, NULL,
             "storm fronts, as ground-based augmentation is tried with"),
};
const orr_schema orr_section_disturbance = ORR_SCHEMA(disturbance_rows, orr_scenario_disturbance);

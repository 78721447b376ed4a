// SPDX-License-Identifier: GPL-3.0-or-later
// A station's day for the tests of the fusion: phases, published maps, biases, and positions straight from a
// 5-minute SP3 file (Lagrange through ten points: millimetres, where a hundred metres would do).
#ifndef ORR_TESTS_IONO_STATION_DAY_H
#define ORR_TESTS_IONO_STATION_DAY_H

#include "ingest/sp3/sp3.h"
#include "ingest/tables/bias.h"
#include "iono/field/tec_files.h"
#include "iono/fusion/fusion.h"
#include "read_file.h"
#include "testing.h"

typedef struct station_day {
    orr_sp3 sp3;
    orr_tec_field *field;
    orr_bias_set biases;
    orr_phase_tec phase;
} station_day;

static bool sp3_position(void *user, orr_sat sat, orr_time t, orr_vec3 *pos)
{
    enum { POINTS = 10 };
    const orr_sp3 *x = user;
    size_t s = 0, k;
    while (s < x->n_sats && x->sat[s] != sat) s++;
    if (s == x->n_sats || x->n_epochs < POINTS || t < x->epoch[0] || t > x->epoch[x->n_epochs - 1])
        return false;
    size_t lo = 0, hi = x->n_epochs;
    while (hi - lo > 1) {
        size_t mid = (lo + hi) / 2;
        if (x->epoch[mid] <= t)
            lo = mid;
        else
            hi = mid;
    }
    k = lo < POINTS / 2 - 1 ? 0 : lo - (POINTS / 2 - 1);
    if (k + POINTS > x->n_epochs) k = x->n_epochs - POINTS;
    double sum[3] = {0};
    for (size_t i = 0; i < POINTS; i++) {
        double w = 1;
        for (size_t j = 0; j < POINTS; j++)
            if (j != i) w *= (double)(t - x->epoch[k + j]) / (double)(x->epoch[k + i] - x->epoch[k + j]);
        for (int c = 0; c < 3; c++) sum[c] += w * x->record[(k + i) * x->n_sats + s].pos_m[c];
    }
    *pos = (orr_vec3){sum[0], sum[1], sum[2]};
    return !isnan(sum[0] + sum[1] + sum[2]);
}

#define DAY_OBS "2024-035/BOR100POL_R_20240350000_01D_30S_MO.crx.gz"
#define DAY_SP3 "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"
#define DAY_MAPS "2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz"
#define DAY_BIAS "2024-035/COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz"

static inline void station_day_phases(station_day *day, bool windup)
{
    char path[512];
    orr_diag d = {0};
    orr_phase_options o = orr_phase_default_options();
    assert_true(orr_test_data(DAY_OBS, path, sizeof path));
    o.position = sp3_position;
    o.user = &day->sp3;
    o.windup = windup;
    ASSERT_OK(read_phases(path, &o, &day->phase, &d), d);
}

static inline bool station_day_read(station_day *day)
{
    char path[512];
    orr_diag d = {0};
    memset(day, 0, sizeof *day);
    if (!orr_test_data(DAY_OBS, path, sizeof path) || !orr_test_data(DAY_SP3, path, sizeof path))
        return false;
    ASSERT_OK(orr_sp3_read(path, NULL, &day->sp3, NULL, &d), d);
    if (!orr_test_data(DAY_MAPS, path, sizeof path)) return false;
    ASSERT_OK(orr_tec_field_open(path, NULL, &day->field, NULL, &d), d);
    if (!orr_test_data(DAY_BIAS, path, sizeof path)) return false;
    ASSERT_OK(orr_bias_read(path, NULL, &day->biases, NULL, &d), d);
    station_day_phases(day, true);
    return true;
}

static inline void station_day_free(station_day *day)
{
    orr_phase_tec_free(&day->phase);
    orr_bias_free(&day->biases);
    orr_tec_field_free(day->field);
    orr_sp3_free(&day->sp3);
}

#endif

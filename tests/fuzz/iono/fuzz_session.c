// SPDX-License-Identifier: GPL-3.0-or-later
// Ionospheric sessions with anything in their variables and attributes: loaded, and asked for delays at the
// station and elsewhere, at and around their times.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/nc_mock.h"
#include "iono/fusion/session.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

#define SATS 3
#define SAMPLES 12
#define DEGREE 2

static const orr_time start = INT64_C(1391040000) * 1000000000; // 2024-02-04

static orr_tec_field *made_field(unsigned kind)
{
    orr_tec_field *f = NULL;
    orr_diag diag = {0};
    orr_status s;
    if (kind == 0) {
        const orr_tec_broadcast k = {ORR_TIME_NONE, {1e-8, 1e-8, -5e-8, -5e-8, 9e4, 8e4, -2e5, -3e5}};
        s = orr_tec_field_from_broadcast(ORR_TEC_GPS, &k, 1, start, start + INT64_C(7200000000000), "made",
                                         NULL, &f, &diag);
    } else if (kind == 1) {
        double value[(DEGREE + 1) * (DEGREE + 1)] = {20, 3, 1, -2, 0.5, 0.2, 0.1, -0.3, 0.4},
                                              rms[9] = {0.1, 0.1};
        orr_tec_coefficients set[3];
        for (int k = 0; k < 3; k++)
            set[k] = (orr_tec_coefficients){
                start + k * INT64_C(3600000000000), ORR_TIME_NONE, DEGREE, DEGREE, value, rms};
        orr_tec_model m = {3, set, 79, -71, 6.821e6, "made"};
        s = orr_tec_field_from_model(&m, NULL, &f, &diag);
    } else {
        static double tec[2 * 7 * 9], rms[2 * 7 * 9];
        orr_time t[2] = {start, start + INT64_C(7200000000000)};
        for (int k = 0; k < 2 * 7 * 9; k++) {
            tec[k] = k % 23 == 5 ? (double)NAN : 10 + k % 9;
            rms[k] = 1;
        }
        orr_tec_maps m = {2, 7, 9, 90, -30, -180, 45, 6.821e6, 0.1, t, tec, rms, "made"};
        orr_tec_options o = orr_tec_default_options();
        o.spatial = ORR_TEC_BILINEAR;
        s = orr_tec_field_from_maps(&m, &o, &f, &diag);
    }
    if (s != ORR_OK) abort();
    return f;
}

// A session of three satellites with four samples each, with a correction of two knots.
static void make(unsigned kind)
{
    static orr_session_arc arc[SATS];
    static orr_session_sample sample[SAMPLES];
    static double term[2][ORR_CORRECTION_TERMS] = {{1, 0.1, 0.1, 0, 0, 0}, {2, 0.1, 0, 0, 0, 0.1}};
    orr_session s = {
        .station = "MADE",
        .method = "joint",
        .interval_s = 30,
        .max_gap_s = 300,
        .from = start,
        .to = start + INT64_C(3600000000000),
        .field = made_field(kind),
        .correction = {.t0 = start, .knot_s = 3600, .n = 2, .term = term, .scale = 6.821, .reach = 1.5},
        .n_arcs = SATS,
        .n_samples = SAMPLES,
        .arc = arc,
        .sample = sample,
        .small = {.sigma_tecu = 0.5, .length_m = 150e3, .time_s = 1200, .own_tecu = 0}};
    orr_diag diag = {0};
    if (orr_iono_site_at((orr_vec3){3738358, 1148174, 5021815}, &s.site, &diag) != ORR_OK) abort();
    for (int a = 0; a < SATS; a++) {
        arc[a] = (orr_session_arc){orr_sat_make("GRE"[a], 5 + a), (size_t)(4 * a), 4, 3.0, 0.5, 1575.42e6};
        for (int i = 0; i < 4; i++)
            sample[4 * a + i] = (orr_session_sample){start + INT64_C(30000000000) * i,
                                                     20 + i,
                                                     19,
                                                     0.3 * a,
                                                     1.5,
                                                     orr_vec3_unit((orr_vec3){0.6, 0.1 * a, 0.7}),
                                                     1.0,
                                                     0.8};
    }
    if (orr_session_save(&s, "made", "made", NULL, 0, &diag) != ORR_OK) abort();
    nc_mock_keep(kind);
    orr_tec_field_free(s.field);
}

static void ask(const orr_session *s, orr_time t, orr_vec3 site_m)
{
    static const orr_vec3 sat_m[4] = {{2e7, 1e7, 1.5e7}, {1.5e7, -1e7, 2e7}, {1e7, 1.5e7, 2e7}, {-2e7, 0, 0}};
    orr_sat sat[4] = {orr_sat_make('G', 5), orr_sat_make('R', 6), orr_sat_make('E', 7), orr_sat_make('G', 9)};
    orr_transfer_options o = {.seed = 1, .noise = true};
    orr_realisation out[4];
    orr_diag diag = {0};
    size_t n = 99;
    orr_status status = orr_session_realise(s, t, site_m, sat, sat_m, 4, &o, out, &n, &diag);
    if (status == ORR_OK ? n > 4 : diag.text[0] == '\0') abort();
    for (size_t k = 0; status == ORR_OK && k < n; k++)
        if (out[k].origin > ORR_ORIGIN_NOISE) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1) return 0;
    static bool made;
    for (unsigned kind = 0; !made && kind < 3; kind++) make(kind);
    made = true;
    nc_mock_edit(data[0] % 3, data + 1, n - 1);
    orr_session s;
    orr_diag diag = {0};
    orr_status status = orr_session_load("fuzz", NULL, &s, &diag);
    if (status != ORR_OK) {
        if (diag.text[0] == '\0' || s.arc != NULL || s.field != NULL)
            abort(); // a refusal says why and holds nothing
        return 0;
    }
    size_t total = 0;
    for (size_t a = 0; a < s.n_arcs; a++) {
        if (s.arc[a].first != total || s.arc[a].n > s.n_samples - total) abort();
        total += s.arc[a].n;
    }
    const orr_vec3 near = orr_vec3_add(s.site.pos_m, (orr_vec3){3000, 2000, -3000});
    const orr_time at[] = {s.from, start,   start + INT64_C(45000000000), start + INT64_C(1800000000000),
                           s.to,   s.to + 1};
    for (size_t k = 0; k < sizeof at / sizeof at[0]; k++) {
        ask(&s, at[k], s.site.pos_m);
        ask(&s, at[k], near);
    }
    orr_session_free(&s);
    return 0;
}

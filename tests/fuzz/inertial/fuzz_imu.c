// SPDX-License-Identifier: GPL-3.0-or-later
// Files of inertial readings with anything in their variables and attributes: loaded, navigated on, searched
// for gravity.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/nc_mock.h"
#include "inertial/gravimetry/gravimetry.h"
#include "inertial/motion/analytic.h"
#include "inertial/nav/null_test.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/sensors.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

static orr_gravity *made_gravity(void)
{
    double lat[4], lon[4], mgal[16], d[3] = {-1e6, 0, 1e6}, v[3] = {1, 2, 3};
    for (int k = 0; k < 16; k++) {
        lat[k / 4] = 0.8 + 0.05 * (k / 4);
        lon[k % 4] = 0.3 + 0.05 * (k % 4);
        mgal[k] = k;
    }
    orr_point_mass mass = {{3.7e6, 1.1e6, 4.9e6}, 1e3};
    orr_gravity_parts p = {.n_masses = 1,
                           .mass = &mass,
                           .n_profile = 3,
                           .profile_lat_rad = 0.87,
                           .profile_lon_rad = 0.35,
                           .profile_distance_m = d,
                           .profile_mgal = v,
                           .n_lat = 4,
                           .n_lon = 4,
                           .map_lat_rad = lat,
                           .map_lon_rad = lon,
                           .map_mgal = mgal};
    orr_gravity *g;
    orr_diag diag = {0};
    if (orr_gravity_make(&p, &g, &diag) != ORR_OK) abort();
    return g;
}

static void make(unsigned kind)
{
    orr_analytic_plan plan = {
        .origin = {0.87, 0.35, 500}, .n_terms = 1, .term = {{.kind = ORR_ANALYTIC_STRAIGHT}}};
    plan.term[0].velocity_mps = (orr_vec3){30, 40, 0};
    orr_trajectory tr;
    orr_imu imu;
    orr_gravimetry truth;
    orr_diag diag = {0};
    orr_gravity *g = made_gravity();
    if (orr_trajectory_analytic(0, 0, 4, &plan, &tr, &diag) != ORR_OK) abort();
    orr_imu_request q = {.duration_s = 4, .rate_hz = 5, .instantaneous = true, .gravity = g};
    q.mode = kind == 0
                 ? (orr_imu_mode){.approach = 2, .order = 2}
                 : (orr_imu_mode){.approach = 1, .frame = (orr_nav_frame)(kind - 1), .closed_loop = true};
    if (orr_imu_generate(&tr, &q, &imu, &diag) != ORR_OK) abort();
    if (orr_gravimetry_truth(&tr, g, &imu, 1, &truth, &diag) != ORR_OK) abort();
    orr_imu_labels labels = {.history = "made", .truth_every = 1};
    if (orr_imu_write("made", &imu, &truth, g, &labels, &diag) != ORR_OK) abort();
    nc_mock_keep(kind);
    orr_gravimetry_free(&truth);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
    orr_gravity_free(g);
}

static void navigate(const orr_imu_file *f, orr_navigator nav)
{
    orr_null_report r;
    orr_diag diag = {0};
    nav.gravity = f->gravity;
    if (orr_null_test(&f->imu, &nav, NULL, NULL, &r, &diag) != ORR_OK && diag.text[0] == '\0') abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
    if (n < 1) return 0;
    static bool made;
    for (unsigned kind = 0; !made && kind < 4; kind++) make(kind);
    made = true;
    nc_mock_edit(data[0] % 4, data + 1, n - 1);
    orr_imu_file f;
    orr_imu_summary head;
    orr_diag diag = {0};
    orr_status looked = orr_imu_summarise("fuzz", &head, &diag),
               status = orr_imu_read("fuzz", NULL, &f, &diag);
    if (status != ORR_OK) {
        if (diag.text[0] == '\0' || f.imu.r_m != NULL) abort(); // a refusal says why and holds nothing
        return 0;
    }
    if (looked != ORR_OK || head.n != f.imu.n) abort();
    // The reference navigator may take a thousand steps a sample of wild readings: of a few samples only.
    navigate(&f, (orr_navigator){.kind = ORR_NAVIGATOR_REFERENCE,
                                 .samples = 1 + data[0] / 4 % 5,
                                 .substeps = f.imu.n <= 24 ? 0 : 1});
    navigate(&f, (orr_navigator){.kind = ORR_NAVIGATOR_MULTI_SAMPLE, .samples = 4});
    navigate(&f,
             (orr_navigator){.kind = ORR_NAVIGATOR_ONE_STEP, .frame = f.imu.mode.frame, .project_mid = true});
    orr_gravimetry_result r;
    if (f.gravimetry.n > 0) {
        const orr_gravity_filter filter = {.kind = (orr_gravity_filter_kind)(data[0] / 20 % 3),
                                           .length_s = 0.4,
                                           .model_mgal = 20,
                                           .place_m = 0.02};
        if (orr_gravimetry_recover(&f.imu, &f.gravimetry, NULL, &filter, &r, &diag) == ORR_OK)
            orr_gravimetry_result_free(&r);
        else if (diag.text[0] == '\0')
            abort();
    }
    orr_imu_file_free(&f);
    return 0;
}

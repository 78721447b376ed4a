// SPDX-License-Identifier: GPL-3.0-or-later
// An hour of a survey flight at 100 Hz: its readings, the navigators on them, and the file, apart.
#include <stdlib.h>
#include <unistd.h>

#include "bench/bench.h"
#include "inertial/motion/flight_plan.h"
#include "inertial/nav/null_test.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/sensors.h"

typedef struct job {
    orr_trajectory flight;
    orr_imu_request request;
    orr_imu imu;
    orr_navigator navigator;
    char path[64];
} job;

static void generate(void *arg)
{
    job *j = arg;
    orr_imu imu;
    if (orr_imu_generate(&j->flight, &j->request, &imu, NULL) != ORR_OK) abort();
    bench_use(imu.dv_mps[imu.n - 1].z);
    orr_imu_free(&imu);
}

static void navigate(void *arg)
{
    job *j = arg;
    orr_null_report r;
    if (orr_null_test(&j->imu, &j->navigator, NULL, NULL, &r, NULL) != ORR_OK) abort();
    bench_use(r.max_3d_m);
}

static void write_file(void *arg)
{
    job *j = arg;
    orr_imu_labels labels = {.history = "bench", .truth_every = 5};
    if (orr_imu_write(j->path, &j->imu, NULL, NULL, &labels, NULL) != ORR_OK) abort();
}

void bench_inertial(bench *b)
{
    orr_flight_plan p = orr_flight_plan_default();
    p.survey = (orr_survey){
        .start = {0.98, 0.7, 1500}, .length_m = 30e3, .spacing_m = 2e3, .lines = 7, .azimuth_rad = 0.3};
    p.duration_s = 3600;
    p.knot_step_s = 0.5;
    p.wind_mps = (orr_spectrum){0.5, 0.02, 0.25, -1.667};
    p.roll_rad = p.pitch_osc_rad = p.heading_rad = (orr_spectrum){0.01, 0.03, 0.25, -1};
    job j = {.request = {.duration_s = 3600, .rate_hz = 100, .mode = {.approach = 2, .order = 2}},
             .path = "/tmp/orrery-bench-XXXXXX"};
    int fd = mkstemp(j.path);
    if (fd < 0 || orr_trajectory_flight_plan(0, &p, &j.flight, NULL, NULL) != ORR_OK ||
        orr_imu_generate(&j.flight, &j.request, &j.imu, NULL) != ORR_OK)
        abort();
    close(fd);
    bench_group(b, "inertial: an hour at 100 Hz");
    bench_row(b, "generator, approach 2", 1e3 * bench_seconds(b, generate, &j), 0, "ms", "");
    bench_row(b, "file of readings and truth, to disk", 1e3 * bench_seconds(b, write_file, &j), 0, "ms", "");
    j.navigator = (orr_navigator){.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
    bench_row(b, "reference navigator and comparison", 1e3 * bench_seconds(b, navigate, &j), 0, "ms", "");
    j.navigator =
        (orr_navigator){.kind = ORR_NAVIGATOR_ONE_STEP, .frame = ORR_FRAME_BODY, .project_mid = true};
    bench_row(b, "one-step navigator, body frame", 1e3 * bench_seconds(b, navigate, &j), 0, "ms", "");
    unlink(j.path);
    orr_imu_free(&j.imu);
    orr_trajectory_free(&j.flight);
}

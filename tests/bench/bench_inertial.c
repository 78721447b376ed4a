// SPDX-License-Identifier: GPL-3.0-or-later
// An hour of a survey flight at 100 Hz: its readings, the navigators on them, and the file, apart.
#include <stdlib.h>
#include <unistd.h>

#include "bench/bench.h"
#include "inertial/motion/flight_plan.h"
#include "inertial/nav/null_test.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/measured.h"
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

// What a navigation-grade unit and one with every term have to compute.
static const double warm_s[] = {0, 3600}, warm_c[] = {20, 40};
static const orr_imu_errors few = {.gyro = {.bias_sigma = 1e-8,
                                            .white = {1e-6, 1e-6, 1e-6},
                                            .n_processes = 1,
                                            .process = {{1e-8, 1000}},
                                            .scale_sigma = 1e-5},
                                   .accel = {.bias_sigma = 1e-4,
                                             .white = {1e-4, 1e-4, 1e-4},
                                             .n_processes = 1,
                                             .process = {{1e-5, 1000}},
                                             .scale_sigma = 1e-5}};
static const orr_imu_errors all = {.gyro = {.white = {1e-6, 1e-6, 1e-6},
                                            .walk = {1e-8, 1e-8, 1e-8},
                                            .n_processes = 2,
                                            .process = {{1e-8, 1000}, {1e-8, 100}},
                                            .by_temperature = {1e-8, 1e-8, 1e-8},
                                            .bandwidth_hz = 40,
                                            .quantum = 1e-9},
                                   .accel = {.white = {1e-4, 1e-4, 1e-4},
                                             .walk = {1e-7, 1e-7, 1e-7},
                                             .n_processes = 2,
                                             .process = {{1e-5, 1000}, {1e-5, 100}},
                                             .rectification = {1e-5, 1e-5, 1e-5},
                                             .arm_m = {{0.05, 0, 0}, {0, 0.05, 0}, {0, 0, 0.05}},
                                             .bandwidth_hz = 40,
                                             .quantum = 1e-7},
                                   .temperature = {.n = 2, .t_s = warm_s, .celsius = warm_c, .lag_s = 300},
                                   .delay_s = 0.003,
                                   .jitter_s = 1e-6};

static void add(job *j, const orr_imu_errors *e)
{
    if (orr_imu_add_errors(e, &j->imu, NULL, NULL) != ORR_OK) abort();
    bench_use(j->imu.measured_dv_mps[j->imu.n - 1].z);
}
static void add_few(void *arg) { add(arg, &few); }
static void add_all(void *arg) { add(arg, &all); }

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
    orr_flight_plan p = {.speed_mps = 60,
                         .bank_rad = 20 * ORR_RAD_PER_DEG,
                         .climb_limit_mps = 5,
                         .acceleration_mps2 = 2,
                         .lead_m = 1000,
                         .smoothing_s = 2.5,
                         .seed = 1};
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
    const double made = 1e3 * bench_seconds(b, generate, &j),
                 written = 1e3 * bench_seconds(b, write_file, &j);
    bench_row(b, "generator, approach 2", made, 0, "ms", "");
    bench_row(b, "file of readings and truth, to disk", written, 0, "ms", "");
    bench_row(b, "errors of sensors, navigation grade", 1e3 * bench_seconds(b, add_few, &j), made + written,
              "ms", "the ideal hour with its file");
    bench_row(b, "errors of sensors, every term", 1e3 * bench_seconds(b, add_all, &j), made + written, "ms",
              "the ideal hour with its file");
    j.navigator = (orr_navigator){.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
    bench_row(b, "reference navigator and comparison", 1e3 * bench_seconds(b, navigate, &j), 0, "ms", "");
    j.navigator =
        (orr_navigator){.kind = ORR_NAVIGATOR_ONE_STEP, .frame = ORR_FRAME_BODY, .project_mid = true};
    bench_row(b, "one-step navigator, body frame", 1e3 * bench_seconds(b, navigate, &j), 0, "ms", "");
    unlink(j.path);
    orr_imu_free(&j.imu);
    orr_trajectory_free(&j.flight);
}

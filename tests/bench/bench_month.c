// SPDX-License-Identifier: GPL-3.0-or-later
// What a month of 80 satellites takes: `orrery orbit` on thirty made days of 15-minute positions, its peak memory (the most that
#define _DEFAULT_SOURCE // wait4
// was resident, wait4) and its time.
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/bench.h"
#include "core/monotonic.h"
#include "ingest/sp3/sp3.h"
#include "orbit/force/integrate.h"

enum { DAYS = 30, SATS = 80, STEP_S = 900, EPOCHS = 86400 / STEP_S, PATH = 96 };
#define MB_LIMIT 100.0

static void must(bool good, const char *what)
{
    if (good) return;
    fprintf(stderr, "bench: %s\n", what);
    abort();
}

// Satellite k: planes and heights of GPS, GLONASS and Galileo by turns.
static void begin(size_t k, orr_vec3 *r, orr_vec3 *v)
{
    static const double a_m[3] = {26.56e6, 25.51e6, 29.60e6}, incl[3] = {0.96, 1.13, 0.98};
    const double a = a_m[k % 3], node = 0.7 * (double)(k / 3), u = 1.9 * (double)k, i = incl[k % 3];
    const orr_vec3 n = {cos(node), sin(node), 0}, m = {-sin(node) * cos(i), cos(node) * cos(i), sin(i)};
    *r = orr_vec3_scale(a, orr_vec3_add(orr_vec3_scale(cos(u), n), orr_vec3_scale(sin(u), m)));
    *v = orr_vec3_scale(sqrt(ORR_EGM96_GM / a),
                        orr_vec3_add(orr_vec3_scale(-sin(u), n), orr_vec3_scale(cos(u), m)));
}

static void make_days(const char *folder, char (*path)[PATH])
{
    orr_diag d = {0};
    orr_time t0;
    orr_sky *sky;
    orr_force force = {.sun_moon = true, .srp_mps2 = 1e-7};
    orr_integrator *it;
    orr_vec3 r[SATS], v[SATS];
    must(orr_time_parse("2024-02-04", NULL, &t0, &d) == ORR_OK, d.text);
    must(orr_gravity_field_init(&force.earth, 8, false, &d) == ORR_OK, d.text);
    must(orr_sky_init(t0, orr_time_add_s(t0, 86400.0 * DAYS), ORR_SKY_GCRS, NULL, &sky, NULL, &d) == ORR_OK,
         d.text);
    must(orr_integrator_init(&force, sky, &it, &d) == ORR_OK, d.text);
    for (size_t k = 0; k < SATS; k++) begin(k, &r[k], &v[k]);
    for (size_t day = 0; day < DAYS; day++) {
        orr_sp3 s;
        must(orr_sp3_alloc(SATS, EPOCHS, &s, &d) == ORR_OK, d.text);
        s.version = 'd';
        s.interval_s = STEP_S;
        strcpy(s.coordinates, "IGS20");
        for (size_t e = 0; e < EPOCHS; e++) {
            const double t_s = STEP_S * (double)(day * EPOCHS + e);
            orr_sky_point p;
            orr_sky_at(sky, t_s, &p);
            s.epoch[e] = orr_time_add_s(t0, t_s);
            for (size_t k = 0; k < SATS; k++) {
                const orr_vec3 x = orr_mat3_apply(&p.R, r[k]);
                orr_sp3_record *q = &s.record[e * SATS + k];
                s.sat[k] = orr_sat_make("GRE"[k % 3], (int)(k / 3) + 1);
                q->pos_m[0] = x.x, q->pos_m[1] = x.y, q->pos_m[2] = x.z;
                q->clock_s = 1e-5 * (double)k + 1e-11 * t_s;
                must(orr_integrate(it, t_s, STEP_S, &r[k], &v[k]) == ORR_OK, "integration");
            }
        }
        snprintf(path[day], PATH, "%s/%02zu.sp3", folder, day);
        must(orr_sp3_write(&s, path[day], &d) == ORR_OK, d.text);
        orr_sp3_free(&s);
    }
    orr_integrator_free(it);
    orr_sky_free(sky);
}

static void smooth(bench *b, const char *name, const char *jobs, const char *product, char (*path)[PATH])
{
    const char *argv[DAYS + 8] = {ORR_PROGRAM, "orbit", "-q", "--jobs", jobs, "-o", product};
    for (size_t i = 0; i < DAYS; i++) argv[7 + i] = path[i];
    const double begin_s = orr_monotonic_s();
    const pid_t child = fork();
    must(child >= 0, "fork");
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        (void)dup2(nowhere, STDERR_FILENO);
        execv(ORR_PROGRAM, (char *const *)argv);
        _exit(127);
    }
    int status;
    struct rusage used;
    must(wait4(child, &status, 0, &used) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0,
         "orrery orbit failed");
    char text[64];
    snprintf(text, sizeof text, "peak memory, %s", name);
    bench_row(b, text, (double)used.ru_maxrss / 1e3, MB_LIMIT, "MB", "the bar");
    snprintf(text, sizeof text, "SP3 to product, %s", name);
    bench_row(b, text, orr_monotonic_s() - begin_s, 0, "s", "");
    unlink(product);
}

void bench_month(bench *b)
{
    char folder[] = "/tmp/orr-bench-XXXXXX", path[DAYS][PATH], product[PATH];
    must(mkdtemp(folder) != NULL, "no temporary folder");
    snprintf(product, sizeof product, "%s/month.nc", folder);
    make_days(folder, path);
    bench_group(b, "A month of 80 satellites, nodes every 15 min, orrery orbit");
    smooth(b, "one thread", "1", product, path);
    smooth(b, "two threads", "2", product, path);
    for (size_t i = 0; i < DAYS; i++) unlink(path[i]);
    rmdir(folder);
}

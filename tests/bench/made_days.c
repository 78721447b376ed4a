// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/made_days.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "ingest/sp3/sp3.h"
#include "orbit/force/integrate.h"

enum { STEP_S = 900, EPOCHS = 86400 / STEP_S };

void made_must(bool good, const char *what)
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

static orr_sat satellite(size_t k) { return orr_sat_make("GRE"[k % 3], (int)(k / 3) + 1); }

void made_days(const char *folder, size_t days, const orr_sat_set *only, char (*path)[MADE_PATH])
{
    orr_diag d = {0};
    orr_time t0;
    orr_sky *sky;
    orr_force force = {.sun_moon = true, .srp_mps2 = 1e-7};
    orr_integrator *it;
    orr_vec3 r[MADE_SATS], v[MADE_SATS];
    made_must(orr_time_parse(MADE_FIRST, NULL, &t0, &d) == ORR_OK, d.text);
    made_must(orr_gravity_field_init(&force.earth, 8, false, &d) == ORR_OK, d.text);
    made_must(orr_sky_init(t0, orr_time_add_s(t0, 86400.0 * (double)days), ORR_SKY_GCRS, NULL, NULL, &sky,
                           NULL, &d) == ORR_OK,
              d.text);
    made_must(orr_integrator_init(&force, sky, &it, &d) == ORR_OK, d.text);
    size_t which[MADE_SATS], n = 0;
    for (size_t k = 0; k < MADE_SATS; k++)
        if (only == NULL || orr_sat_set_has(only, satellite(k))) which[n++] = k;
    made_must(n > 0, "no such satellite is made");
    for (size_t i = 0; i < n; i++) begin(which[i], &r[i], &v[i]);
    for (size_t day = 0; day < days; day++) {
        orr_sp3 s;
        made_must(orr_sp3_alloc(n, EPOCHS, &s, &d) == ORR_OK, d.text);
        s.version = 'd';
        s.interval_s = STEP_S;
        strcpy(s.coordinates, "IGS20");
        for (size_t e = 0; e < EPOCHS; e++) {
            const double t_s = STEP_S * (double)(day * EPOCHS + e);
            orr_sky_point p;
            orr_sky_at(sky, t_s, &p);
            s.epoch[e] = orr_time_add_s(t0, t_s);
            for (size_t k = 0; k < n; k++) {
                const orr_vec3 x = orr_mat3_apply(&p.R, r[k]);
                orr_sp3_record *q = &s.record[e * n + k];
                s.sat[k] = satellite(which[k]);
                q->pos_m[0] = x.x, q->pos_m[1] = x.y, q->pos_m[2] = x.z;
                q->clock_s = 1e-5 * (double)which[k] + 1e-11 * t_s;
                made_must(orr_integrate(it, t_s, STEP_S, &r[k], &v[k]) == ORR_OK, "integration");
            }
        }
        snprintf(path[day], MADE_PATH, "%s/%03zu.sp3", folder, day);
        made_must(orr_sp3_write(&s, path[day], &d) == ORR_OK, d.text);
        orr_sp3_free(&s);
    }
    orr_integrator_free(it);
    orr_sky_free(sky);
}

pid_t made_start(const char *const *argv)
{
    const pid_t child = fork();
    made_must(child >= 0, "fork");
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        (void)dup2(nowhere, STDERR_FILENO);
        execv(ORR_PROGRAM, (char *const *)argv);
        _exit(127);
    }
    return child;
}

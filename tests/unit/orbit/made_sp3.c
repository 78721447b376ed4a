// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "made_sp3.h"

void made_sky_init(made_sky *m, const char *t0, double days)
{
    orr_diag d = {0};
    *m = (made_sky){.force = {.sun_moon = true, .srp_mps2 = 1e-7}};
    ASSERT_OK(orr_time_parse(t0, NULL, &m->t0, &d), d);
    m->n = (size_t)(days * 86400 / MADE_STEP_S) + 1;
    assert_true(m->n <= MADE_MAX_EPOCHS);
    ASSERT_OK(
        orr_sky_init(m->t0, orr_time_add_s(m->t0, days * 86400), ORR_SKY_GCRS, NULL, NULL, &m->sky, NULL, &d),
        d);
    ASSERT_OK(orr_gravity_field_init(&m->force.earth, 12, false, &d), d); // richer than the smoother's 8x8
}

void made_sky_free(made_sky *m) { orr_sky_free(m->sky); }

void made_orbit(const made_sky *m, orr_sat sat, double a, double e, double incl, double raan, double u,
                double unknown, double push_s, double push, made_truth *out)
{
    orr_integrator *it = NULL;
    ASSERT_OK(orr_integrator_init(&m->force, m->sky, &it, NULL), (orr_diag){0});
    // Perigee at the node's angle u: r = a (1 - e) there, speed from the vis-viva equation.
    orr_vec3 node = {cos(raan), sin(raan), 0},
             across = {-sin(raan) * cos(incl), cos(raan) * cos(incl), sin(incl)};
    orr_vec3 rhat = orr_vec3_add(orr_vec3_scale(cos(u), node), orr_vec3_scale(sin(u), across));
    orr_vec3 that = orr_vec3_add(orr_vec3_scale(-sin(u), node), orr_vec3_scale(cos(u), across));
    orr_vec3 r = orr_vec3_scale(a * (1 - e), rhat),
             v = orr_vec3_scale(sqrt(ORR_EGM96_GM / a * (1 + e) / (1 - e)), that);
    out->sat = sat;
    out->n = m->n;
    for (size_t i = 0; i < m->n; i++) {
        orr_sky_point p;
        double t = MADE_STEP_S * (double)i;
        orr_sky_at(m->sky, t, &p);
        orr_sky_to_ecef(&p, r, v, &out->r[i], &out->v[i]);
        if (i + 1 == m->n) break;
        for (int k = 0; k < 6; k++) { // the unknown acceleration as small kicks of velocity every 50 s
            double s = t + 50.0 * k, phase = 2 * ORR_PI * s / 43000;
            if (push_s >= s && push_s < s + 50) v = orr_vec3_axpy(push, orr_vec3_unit(v), v);
            orr_vec3 kick = {unknown * cos(phase), unknown * sin(phase), 0.5 * unknown};
            v = orr_vec3_axpy(25, kick, v);
            ASSERT_OK(orr_integrate(it, s, 50, &r, &v), (orr_diag){0});
            v = orr_vec3_axpy(25, kick, v);
        }
    }
    orr_integrator_free(it);
}

void made_sp3(const made_sky *m, const made_truth *const *truth, size_t n_sats, size_t from, size_t to,
              size_t step, orr_sp3 *out)
{
    size_t n = (to - from) / step + 1;
    *out =
        (orr_sp3){.version = 'd', .n_sats = n_sats, .n_epochs = n, .interval_s = MADE_STEP_S * (double)step};
    snprintf(out->coordinates, sizeof out->coordinates, "MADE");
    out->sat = calloc(n_sats, sizeof *out->sat);
    out->epoch = calloc(n, sizeof *out->epoch);
    out->record = calloc(n * n_sats, sizeof *out->record);
    assert_true(out->sat && out->epoch && out->record);
    for (size_t e = 0; e < n; e++) {
        size_t i = from + e * step;
        out->epoch[e] = orr_time_add_s(m->t0, MADE_STEP_S * (double)i);
        for (size_t s = 0; s < n_sats; s++) {
            orr_sp3_record *r = &out->record[e * n_sats + s];
            out->sat[s] = truth[s]->sat;
            r->pos_m[0] = round(truth[s]->r[i].x * 1e3) / 1e3;
            r->pos_m[1] = round(truth[s]->r[i].y * 1e3) / 1e3;
            r->pos_m[2] = round(truth[s]->r[i].z * 1e3) / 1e3;
            r->clock_s = 1e-5 + 1e-11 * MADE_STEP_S * (double)i;
        }
    }
}

void made_sp3_free(orr_sp3 *sp3)
{
    free(sp3->sat);
    free(sp3->epoch);
    free(sp3->record);
}

orr_sp3_record *made_record(orr_sp3 *sp3, orr_sat sat, orr_time t)
{
    for (size_t e = 0; e < sp3->n_epochs; e++)
        for (size_t s = 0; s < sp3->n_sats; s++)
            if (sp3->epoch[e] == t && sp3->sat[s] == sat) return &sp3->record[e * sp3->n_sats + s];
    fail_msg("no such record");
    return NULL;
}

const orr_orbit_sat *made_find(const orr_orbit_solution *s, orr_sat sat)
{
    for (size_t i = 0; i < s->n_sats; i++)
        if (s->sat[i].sat == sat) return &s->sat[i];
    return NULL;
}

size_t made_compare(const made_sky *m, const made_truth *truth, const orr_orbit_solution *s, double from_s,
                    double to_s, double *rms_m, double *max_m)
{
    const orr_orbit_sat *sat = made_find(s, truth->sat);
    assert_non_null(sat);
    double sum = 0;
    size_t n = 0;
    *max_m = 0;
    for (size_t i = 0; i < truth->n; i++) {
        double t_s = MADE_STEP_S * (double)i;
        if (t_s < from_s || t_s > to_s) continue;
        orr_time t = orr_time_add_s(m->t0, t_s);
        for (size_t a = 0; a < sat->n_arcs; a++) {
            const orr_orbit_arc *arc = &sat->arc[a];
            double x = orr_time_diff_s(t, arc->t0) / arc->step_s;
            if (x < -1e-9 || x > (double)(arc->n - 1) + 1e-9 || fabs(x - round(x)) > 1e-6) continue;
            double d = orr_vec3_norm(orr_vec3_sub(arc->sample[(size_t)round(x)].pos_m, truth->r[i]));
            sum += d * d;
            n++;
            if (d > *max_m) *max_m = d;
            break;
        }
    }
    *rms_m = n > 0 ? sqrt(sum / (double)n) : (double)NAN;
    return n;
}

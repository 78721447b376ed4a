// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/predict/predict_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/dynamics/variational.h"

#define STEP_S 450.0 // of the filter's transitions
#define NODE_SIGMA_M 5e-3
#define NEIGHBOURS_S 3600.0 // nodes further apart tell no step between their files
#define QF_M2PS5 1e-22      // 1e-4 nm2/s5: an empirical acceleration that hours change, not minutes
#define START_R_M 10.0
#define START_V_MPS 1e-3
#define F0_SIGMA_MPS2 1e-9
#define FILE_STEP_M 0.03 // what a centre's orbit steps at midnight
#define FILE_STEP_MPS 4e-6
#define BLEND_S (3 * 3600.0) // the filter's state is worth more than the fitted orbit for so long
#define JOIN_S 1800.0        // the smoothed orbit's end goes over into the path within so long

orr_status orr_predict_room_init(const orr_sky *sky, const orr_gravity_field *earth, orr_predict_room *room,
                                 orr_diag *diag)
{
    *room = (orr_predict_room){.sky = sky, .force = {.earth = *earth, .sun_moon = true, .precise = true}};
    return orr_integrator_init(&room->force, sky, &room->integrator, diag);
}

void orr_predict_room_free(orr_predict_room *room)
{
    orr_integrator_free(room->integrator);
    *room = (orr_predict_room){0};
}

static void use_arc(orr_predict_room *room, const orr_reference_arc *fit)
{
    memcpy(room->force.ecom_nmps2, fit->ecom_nmps2, sizeof room->force.ecom_nmps2);
    orr_integrator_set(room->integrator, &room->force, STEP_S);
}

// A stretch of the fitted orbit in which the sunlight has no kink; F, how deviations go over the step so far, goes on.
static orr_status stretch(orr_predict_room *room, double t_s, double h_s, orr_vec3 *r, orr_vec3 *v,
                          double F[6][ORR_NX])
{
    orr_orbit_step s = {.t_s = t_s, .h_s = h_s, .r0_m = *r, .v0_mps = *v};
    const orr_status status = orr_integrate(room->integrator, t_s, h_s, r, v);
    if (status != ORR_OK) return status;
    s.r1_m = *r;
    s.v1_mps = *v;
    orr_vec3 middle, v_middle;
    orr_orbit_step_middle(&s, &middle, &v_middle);
    const orr_mat3 axes[3] = {orr_orbit_axes(s.r0_m, s.v0_mps), orr_orbit_axes(middle, v_middle),
                              orr_orbit_axes(s.r1_m, s.v1_mps)};
    double part[6][ORR_NX], before[6][ORR_NX];
    orr_variational_step(&room->force, room->sky, &s, axes, part);
    memcpy(before, F, sizeof before);
    for (int k = 0; k < 6; k++)
        for (int c = 0; c < ORR_NX; c++) {
            F[k][c] = c < 6 ? 0 : part[k][c];
            for (int j = 0; j < 6; j++) F[k][c] += part[k][j] * before[j][c];
        }
    return ORR_OK;
}

// One step of the fitted orbit, parted where the shadow's borders are, and how deviations go over it; the axes of the
// empirical acceleration in its middle.
static orr_status step_over(orr_predict_room *room, orr_orbit_step *s, orr_mat3 *mid, double F[6][ORR_NX])
{
    double border[ORR_INTEGRATE_BORDERS + 1], from = 0;
    size_t n = orr_integrate_borders(room->integrator, s->t_s, s->h_s, s->r0_m, s->v0_mps, border);
    border[n++] = s->h_s;
    memset(F, 0, 6 * sizeof F[0]);
    for (int i = 0; i < 6; i++) F[i][i] = 1;
    s->r1_m = s->r0_m;
    s->v1_mps = s->v0_mps;
    for (size_t k = 0; k < n; from = border[k++]) {
        const orr_status status = stretch(room, s->t_s + from, border[k] - from, &s->r1_m, &s->v1_mps, F);
        if (status != ORR_OK) return status;
    }
    orr_vec3 r, v;
    orr_orbit_step_middle(s, &r, &v);
    *mid = orr_orbit_axes(r, v);
    return ORR_OK;
}

// Returns how far the node is from where it was expected.
static double take_node(const orr_predict_room *room, const orr_reference_node *node, orr_vec3 r,
                        orr_gauss *g)
{
    orr_sky_point p;
    orr_sky_force_point(room->sky, node->t_s, &p);
    const orr_vec3 z = orr_vec3_sub(orr_mat3_apply_t(&p.R, node->ecef_m), r), x = {g->x[0], g->x[1], g->x[2]};
    orr_kalman_update(g, ORR_NX, z, NODE_SIGMA_M);
    return orr_vec3_norm(orr_vec3_sub(z, x));
}

static void admit_step(orr_gauss *g)
{
    for (int i = 0; i < 3; i++) {
        g->P[i][i] += FILE_STEP_M * FILE_STEP_M;
        g->P[3 + i][3 + i] += FILE_STEP_MPS * FILE_STEP_MPS;
    }
}

orr_status orr_predict_filter(orr_predict_room *room, const orr_reference_arc *fit, const uint16_t *source,
                              orr_predict_start *out)
{
    static const double no_shift[ORR_NX] = {0};
    orr_gauss g;
    *out = (orr_predict_start){.t_s = fit->t_s, .r_m = fit->r_m, .v_mps = fit->v_mps, .joint_m = (double)NAN};
    use_arc(room, fit);
    orr_kalman_start(START_R_M, START_V_MPS, F0_SIGMA_MPS2, orr_ecom_sigma_nmps2(out->r_m, out->v_mps), &g);
    take_node(room, &fit->node[0], out->r_m, &g);
    for (size_t i = 1; i < fit->n; i++) {
        const double dt = fit->node[i].t_s - out->t_s;
        const int steps = (int)fmax(1, ceil(dt / STEP_S - 1e-9));
        orr_transition t;
        orr_transition_start(&t);
        for (int k = 0; k < steps; k++) {
            orr_orbit_step s = {
                .t_s = out->t_s + dt * k / steps, .h_s = dt / steps, .r0_m = out->r_m, .v0_mps = out->v_mps};
            double F[6][ORR_NX];
            orr_mat3 axes;
            const orr_status status = step_over(room, &s, &axes, F);
            if (status != ORR_OK) return status;
            orr_transition_append(&t, F, &axes, s.h_s, QF_M2PS5, 0, false);
            out->r_m = s.r1_m;
            out->v_mps = s.v1_mps;
        }
        out->t_s = fit->node[i].t_s;
        const orr_gauss before = g;
        orr_kalman_predict(&before, &t, ORR_NX, (orr_noise_factor){.q = 1}, no_shift, &g);
        if (source[i] != source[i - 1]) admit_step(&g);
        const double off_m = take_node(room, &fit->node[i], out->r_m, &g);
        if (source[i] != source[i - 1] && dt < NEIGHBOURS_S) out->joint_m = off_m;
    }
    memcpy(out->x, g.x, sizeof out->x);
    return ORR_OK;
}

// What is added to the fitted orbit at an instant: position and two derivatives.
typedef struct addition {
    orr_vec3 r_m, v_mps, a_mps2;
} addition;

// w times something, w = exp(-(t/T)^2), by the rule of products.
static void add_fading(double t_s, double T_s, const addition *what, addition *to)
{
    const double u = t_s / T_s, w = exp(-u * u), dw = -2 * u / T_s * w,
                 ddw = (4 * u * u - 2) / (T_s * T_s) * w;
    to->r_m = orr_vec3_axpy(w, what->r_m, to->r_m);
    to->v_mps = orr_vec3_axpy(w, what->v_mps, orr_vec3_axpy(dw, what->r_m, to->v_mps));
    to->a_mps2 = orr_vec3_axpy(w, what->a_mps2, to->a_mps2);
    to->a_mps2 = orr_vec3_axpy(2 * dw, what->v_mps, orr_vec3_axpy(ddw, what->r_m, to->a_mps2));
}

// The filter's deviation at a point of the fitted orbit.
static addition deviation(const orr_predict_room *room, const orr_sky_point *p, orr_vec3 r, orr_vec3 v,
                          const double x[ORR_NX])
{
    const orr_vec3 pole = {p->R.m[2][0], p->R.m[2][1], p->R.m[2][2]}, dr = {x[0], x[1], x[2]};
    const orr_mat3 G = orr_force_gradient(&room->force, pole, r), axes = orr_orbit_axes(r, v);
    orr_vec3 basis[ORR_ECOM_TERMS];
    orr_ecom_basis(r, v, p->sun_m, basis);
    addition d = {.r_m = dr, .v_mps = {x[3], x[4], x[5]}, .a_mps2 = orr_mat3_apply(&G, dr)};
    d.a_mps2 = orr_vec3_add(d.a_mps2, orr_mat3_apply(&axes, (orr_vec3){x[6], x[7], x[8]}));
    for (int j = 0; j < ORR_ECOM_TERMS; j++)
        d.a_mps2 = orr_vec3_axpy(x[ORR_PARTIAL_ECOM + j], basis[j], d.a_mps2);
    return d;
}

static void set_sample(const orr_predict_room *room, const orr_sky_point *p, orr_vec3 r, orr_vec3 v,
                       const addition *d, orr_orbit_sample *s)
{
    orr_vec3 a = orr_vec3_add(orr_force_of_state(&room->force, p, r, v), d->a_mps2);
    r = orr_vec3_add(r, d->r_m);
    v = orr_vec3_add(v, d->v_mps);
    orr_sky_to_ecef(p, r, v, &s->pos_m, &s->vel_mps);
    s->acc_mps2 = orr_vec3_add(orr_mat3_apply(&p->R, a), orr_mat3_apply(&p->ddR, r));
    s->acc_mps2 = orr_vec3_axpy(2.0, orr_mat3_apply(&p->dR, v), s->acc_mps2);
    s->flags = ORR_EPH_PREDICTED;
    if (orr_force_sunlight_fast(r, p->sun_m) < 1) s->flags |= ORR_EPH_ECLIPSE;
}

// Where the smoothed orbit ends, less where the path begins.
static addition at_the_join(const orr_sky_point *p, const orr_orbit_sample *end,
                            const orr_predict_start *start)
{
    orr_vec3 r, v;
    orr_sky_from_ecef(p, end->pos_m, end->vel_mps, &r, &v);
    const orr_vec3 dr = {start->x[0], start->x[1], start->x[2]}, dv = {start->x[3], start->x[4], start->x[5]};
    return (addition){.r_m = orr_vec3_sub(r, orr_vec3_add(start->r_m, dr)),
                      .v_mps = orr_vec3_sub(v, orr_vec3_add(start->v_mps, dv))};
}

orr_status orr_predict_extend(orr_predict_room *room, const orr_reference_arc *fit,
                              const orr_predict_start *start, double to_s, orr_orbit_arc *arc)
{
    const size_t before = arc->n, per = arc->samples_per_segment;
    const double steps = ceil((to_s - start->t_s) / arc->step_s - 1e-9);
    const size_t more = ((size_t)fmax(steps, 1) + per - 1) / per * per;
    orr_orbit_sample *sample = realloc(arc->sample, (before + more) * sizeof *sample);
    if (sample == NULL) return ORR_E_MEMORY;
    arc->sample = sample;
    memset(sample + before, 0, more * sizeof *sample);
    use_arc(room, fit);
    orr_sky_point p;
    double x[ORR_NX];
    orr_vec3 r = start->r_m, v = start->v_mps;
    memcpy(x, start->x, sizeof x);
    orr_sky_at(room->sky, start->t_s, &p);
    const addition join = at_the_join(&p, &sample[before - 1], start);
    const float sigma_end = sample[before - 1].sigma_m;
    sample[before - 1].flags |= ORR_EPH_PREDICTED; // from here to the next
    for (size_t i = 1; i <= more; i++) {
        orr_orbit_step s = {
            .t_s = start->t_s + arc->step_s * (double)(i - 1), .h_s = arc->step_s, .r0_m = r, .v0_mps = v};
        double F[6][ORR_NX], moved[6];
        orr_mat3 axes;
        const orr_status status = step_over(room, &s, &axes, F);
        if (status != ORR_OK) return status;
        for (int k = 0; k < 6; k++) {
            moved[k] = 0;
            for (int j = 0; j < ORR_NX; j++) moved[k] += F[k][j] * x[j];
        }
        memcpy(x, moved, sizeof moved);
        r = s.r1_m;
        v = s.v1_mps;
        const double age_s = arc->step_s * (double)i;
        orr_sky_at(room->sky, start->t_s + age_s, &p);
        const addition filter = deviation(room, &p, r, v, x);
        const addition line = {.r_m = orr_vec3_axpy(age_s, join.v_mps, join.r_m), .v_mps = join.v_mps};
        addition d = {0};
        add_fading(age_s, BLEND_S, &filter, &d);
        add_fading(age_s, JOIN_S, &line, &d);
        set_sample(room, &p, r, v, &d, &sample[before - 1 + i]);
        sample[before - 1 + i].sigma_m = sigma_end;
    }
    arc->n = before + more;
    return ORR_OK;
}

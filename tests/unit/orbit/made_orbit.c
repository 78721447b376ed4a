// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/orbit/made_orbit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GM 3.986004418e14
#define RATE 7.292115e-5 // of the turning axes, rad/s

const orr_time made_midnight = INT64_C(1391040000) * ORR_NS_PER_S; // 2024-02-04T00:00:00 GPS

made_satellite made_satellite_at(size_t k)
{
    static const struct {
        char system;
        double a_m, e, i_deg;
        int planes;
    } kind[3] = {
        {'G', 26559.7e3, 0.012, 55.0, 6}, {'R', 25508.0e3, 0.001, 64.8, 3}, {'E', 27977.6e3, 0.16, 50.0, 3}};
    size_t c = k % 3, n = k / 3;
    double plane = (double)(n % (size_t)kind[c].planes);
    return (made_satellite){.sat = orr_sat_make(kind[c].system, (int)n + 1),
                            .a_m = kind[c].a_m,
                            .e = kind[c].e,
                            .i_rad = kind[c].i_deg * ORR_RAD_PER_DEG,
                            .raan_rad = 2 * ORR_PI * plane / kind[c].planes,
                            .argp_rad = 0.7 * (double)n,
                            .m0_rad = 1.1 * (double)n + 0.3 * (double)c};
}

void made_state(const made_satellite *m, double t_s, orr_vec3 *pos, orr_vec3 *vel, orr_vec3 *acc)
{
    double n = sqrt(GM / (m->a_m * m->a_m * m->a_m)), mean = m->m0_rad + n * t_s, E = mean;
    for (int i = 0; i < 30; i++) E -= (E - m->e * sin(E) - mean) / (1 - m->e * cos(E));
    double root = sqrt(1 - m->e * m->e), Edot = n / (1 - m->e * cos(E));
    double px = m->a_m * (cos(E) - m->e), py = m->a_m * root * sin(E);
    double vx = -m->a_m * sin(E) * Edot, vy = m->a_m * root * cos(E) * Edot;
    double r = sqrt(px * px + py * py), ax = -GM * px / (r * r * r), ay = -GM * py / (r * r * r);

    double cw = cos(m->argp_rad), sw = sin(m->argp_rad), ci = cos(m->i_rad), si = sin(m->i_rad);
    double node = m->raan_rad, cO = cos(node), sO = sin(node);
    orr_vec3 p = {cO * cw - sO * sw * ci, sO * cw + cO * sw * ci, sw * si};
    orr_vec3 q = {-cO * sw - sO * cw * ci, -sO * sw + cO * cw * ci, cw * si};
    orr_vec3 ri = orr_vec3_axpy(py, q, orr_vec3_scale(px, p)),
             vi = orr_vec3_axpy(vy, q, orr_vec3_scale(vx, p));
    orr_vec3 ai = orr_vec3_axpy(ay, q, orr_vec3_scale(ax, p));

    // r' = R3(wt) r; w = (0, 0, RATE): v' = R v - w x r', a' = R a - 2 w x v' - w x (w x r').
    double c = cos(RATE * t_s), s = sin(RATE * t_s);
#define TURN(u) ((orr_vec3){c * (u).x + s * (u).y, -s * (u).x + c * (u).y, (u).z})
    orr_vec3 w = {0, 0, RATE}, re = TURN(ri), ve = TURN(vi), ae = TURN(ai);
#undef TURN
    *pos = re;
    *vel = orr_vec3_sub(ve, orr_vec3_cross(w, re));
    *acc = orr_vec3_sub(orr_vec3_axpy(-2.0, orr_vec3_cross(w, *vel), ae),
                        orr_vec3_cross(w, orr_vec3_cross(w, re)));
}

double made_clock(const made_satellite *m, double t_s) { return 1e-4 * sin(m->m0_rad) + 2e-11 * t_s; }

static void fill(const made_satellite *m, double hours, double segment_s, size_t per_segment,
                 orr_orbit_sat *s)
{
    size_t segments = (size_t)(hours * 3600 / segment_s + 0.5);
    double span_s = (double)segments * segment_s;
    *s = (orr_orbit_sat){.sat = m->sat, .n_arcs = 1, .n_clocks = (size_t)(span_s / 300) + 1, .n_events = 4};
    s->arc = calloc(1, sizeof *s->arc);
    s->clock = calloc(s->n_clocks, sizeof *s->clock);
    s->event = calloc(s->n_events, sizeof *s->event);
    orr_orbit_arc *a = s->arc;
    *a = (orr_orbit_arc){.t0 = made_midnight,
                         .step_s = segment_s / (double)per_segment,
                         .n = segments * per_segment + 1,
                         .samples_per_segment = per_segment};
    a->sample = calloc(a->n, sizeof *a->sample);
    for (size_t i = 0; i < a->n; i++) {
        orr_orbit_sample *p = &a->sample[i];
        made_state(m, (double)i * a->step_s, &p->pos_m, &p->vel_mps, &p->acc_mps2);
        p->sigma_m = 0.01f + 0.0001f * (float)i;
        for (int k = 0; k < 3; k++) p->sigma_rtn_m[k] = (float)(k + 1) * 0.1f * p->sigma_m;
        p->sigma_mps = 1e-4f * p->sigma_m;
    }
    for (size_t i = 0; i < s->n_clocks; i++)
        s->clock[i] = (orr_clock_node){.t = made_midnight + (int64_t)i * 300 * ORR_NS_PER_S,
                                       .clock_s = made_clock(m, 300.0 * (double)i)};
    s->n_nodes = segments + 1;
    s->node = calloc(s->n_nodes, sizeof *s->node);
    for (size_t i = 0; i < s->n_nodes; i++)
        s->node[i] = (orr_orbit_node){.t = orr_time_add_s(made_midnight, (double)i * segment_s),
                                      .residual_m = {1e-4 * (double)(i % 7), -2e-4, 3e-4},
                                      .used = i % 5 != 4};
#define AT(sec) (made_midnight + (int64_t)(sec)*ORR_NS_PER_S)
    s->event[0] = (orr_orbit_event){ORR_EVENT_PENUMBRA, AT(1000), AT(1060), 0};
    s->event[1] = (orr_orbit_event){ORR_EVENT_UMBRA, AT(1060), AT(4000), 0};
    s->event[2] = (orr_orbit_event){ORR_EVENT_OUTLIER, AT(1800), AT(1800), 1.5};
    s->event[3] = (orr_orbit_event){ORR_EVENT_MANOEUVRE, AT(5000), AT(5900), 0};
#undef AT
}

static int by_sat(const void *a, const void *b)
{
    return (int)((const orr_orbit_sat *)a)->sat - (int)((const orr_orbit_sat *)b)->sat;
}

orr_orbit_solution made_solution(size_t n_sats, double hours, double segment_s, size_t per_segment)
{
    orr_orbit_solution s = {
        .n_sats = n_sats, .n_sources = 1, .node_step_s = segment_s, .clock_max_gap_s = 900};
    s.sat = calloc(n_sats, sizeof *s.sat);
    s.source = calloc(1, sizeof *s.source);
    strcpy(s.source[0].name, "made.sp3");
    memset(s.source[0].sha256, 'a', 64);
    strcpy(s.options, "made for a test");
    strcpy(s.frame, "IGS20");
    for (size_t k = 0; k < n_sats; k++) {
        made_satellite m = made_satellite_at(k);
        fill(&m, hours, segment_s, per_segment, &s.sat[k]);
    }
    qsort(s.sat, n_sats, sizeof *s.sat, by_sat);
    s.from = made_midnight;
    s.to = orr_time_add_s(made_midnight, hours * 3600);
    return s;
}

void made_solution_free(orr_orbit_solution *s)
{
    for (size_t i = 0; i < s->n_sats; i++) {
        for (size_t k = 0; k < s->sat[i].n_arcs; k++) free(s->sat[i].arc[k].sample);
        free(s->sat[i].arc);
        free(s->sat[i].clock);
        free(s->sat[i].node);
        free(s->sat[i].event);
    }
    free(s->sat);
    free(s->source);
    *s = (orr_orbit_solution){0};
}

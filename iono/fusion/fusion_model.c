// SPDX-License-Identifier: GPL-3.0-or-later
// How strong and how lasting the errors of a field are over this station on this day: chosen by restricted maximum
// likelihood (REML: biases and correction integrated out), held near usual values by a weak prior, so that an hour of
// data, which tells little of such things, does not invent them.
//
// Reference: Patterson and Thompson 1971, Recovery of inter-block information when block sizes are unequal.
#include <math.h>

#include "core/minimise.h"
#include "iono/fusion/fusion_private.h"

enum { UNKNOWNS = FUSION_MODEL_UNKNOWNS }; // as logarithms

// What a mapping function does not know. Sizes are physics, and held closely, because a session can hardly tell the two
// apart; times are not chosen at all.
#define HEIGHT_KM 60.0
#define HEIGHT_S (6 * 3600.0)
#define PLASMASPHERE_TECU 3.0
#define PLASMASPHERE_S (12 * 3600.0)

static void to_logs(const orr_fusion_model *m, double x[UNKNOWNS])
{
    const double v[UNKNOWNS] = {m->residual_tecu, m->residual_s,      m->level_tecu, m->per_degree,
                                m->level_s,       m->time_per_degree, m->height_km,  m->plasmasphere_tecu};
    for (int i = 0; i < UNKNOWNS; i++) x[i] = log(v[i]);
}

static orr_fusion_model of_logs(const double x[UNKNOWNS], const orr_fusion_model *usual)
{
    return (orr_fusion_model){.residual_tecu = exp(x[0]),
                              .residual_s = exp(x[1]),
                              .level_tecu = exp(x[2]),
                              .per_degree = exp(x[3]),
                              .level_s = exp(x[4]),
                              .time_per_degree = exp(x[5]),
                              .rms_tecu = usual->rms_tecu,
                              .height_km = exp(x[6]),
                              .height_s = HEIGHT_S,
                              .plasmasphere_tecu = exp(x[7]),
                              .plasmasphere_s = PLASMASPHERE_S};
}

orr_fusion_model fusion_usual_model(double rms_tecu)
{
    return (orr_fusion_model){.residual_tecu = 0.7 * rms_tecu,
                              .residual_s = 5400,
                              .level_tecu = rms_tecu,
                              .per_degree = 0.75,
                              .level_s = 20 * 3600.0,
                              .time_per_degree = 0.6,
                              .rms_tecu = rms_tecu,
                              .height_km = HEIGHT_KM,
                              .height_s = HEIGHT_S,
                              .plasmasphere_tecu = PLASMASPHERE_TECU,
                              .plasmasphere_s = PLASMASPHERE_S};
}

// Sigma of the logarithm of each about the usual value.
static const double SPREAD[UNKNOWNS] = {0.7, 0.5, 0.7, 0.3, 0.7, 0.3, 0.1, 0.1};

typedef struct choice {
    const orr_phase_tec *phase;
    const orr_fusion_options *o;
    orr_fusion *f;
    fusion_normal *s;
    orr_fusion_model start;
    double usual[UNKNOWNS];
} choice;

static double unlikely(const double *x, void *user)
{
    const choice *c = user;
    double sum = 0, likelihood;
    for (int i = 0; i < UNKNOWNS; i++) {
        double d = (x[i] - c->usual[i]) / SPREAD[i];
        sum += d * d;
    }
    if (sum > 1000) return (double)INFINITY; // no such ionosphere
    c->f->model = of_logs(x, &c->start);
    fusion_normal_build(c->s, c->phase, c->o, c->f);
    if (fusion_normal_factor(c->s, &likelihood) != ORR_OK) return (double)INFINITY;
    return sum + likelihood;
}

orr_status fusion_choose_model(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                               orr_diag *diag)
{
    // A day's system takes a hundred times as long as that of a few hours, and its likelihood is steeper.
    enum { ROUNDS = 150, ROUNDS_OF_FEW = 250, FEW = 120 };
    fusion_normal s;
    orr_status status = fusion_normal_init(out, &s, diag);
    if (status != ORR_OK) return status;
    choice c = {phase, o, out, &s, out->model, {0}};
    double x[UNKNOWNS], step[UNKNOWNS];
    to_logs(&out->model, c.usual);
    for (int i = 0; i < UNKNOWNS; i++) {
        x[i] = c.usual[i];
        step[i] = 0.4;
    }
    status = orr_minimise(unlikely, &c, UNKNOWNS, x, step, 0.03, s.n > FEW ? ROUNDS : ROUNDS_OF_FEW, NULL);
    out->model = of_logs(x, &c.start);
    fusion_normal_free(&s);
    return status == ORR_OK ? ORR_OK
                            : orr_diag_set(diag, status, "no memory to choose the model's statistics");
}

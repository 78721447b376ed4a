// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/noise_choice.h"

#define DENSE_S 1900.0  // the ratio is known for nodes up to this distance
#define SPARSE_S 5400.0 // innovations say little of nodes further apart
#define YOUNG 3         // nodes of an arc that a start decides
#define SCALE_MM 0.30   // rounding of SP3 to a millimetre, a coordinate
#define SCALE_SPREAD 0.35
#define LOG_Q (-3.7) // nm^2/s^5
#define LOG_Q_SPREAD 1.2
#define LOWEST (-2.0) // log10 of the factors of qf that are tried
#define HIGHEST 2.6
#define STEP 0.5
#define LEAST_S 0.05 // scales that are tried
#define MOST_S 20.0
#define SCALES 80
#define LEAST_TELLING 6 // nodes after the young ones, to choose without a prior

typedef struct evidence { // of the innovations after the young ones
    double chi2, log_det;
    size_t n; // coordinates
} evidence;

static evidence add_up(const orr_track *t)
{
    evidence e = {0};
    size_t seen = 0;
    for (size_t k = 0; k < t->n; k++) {
        if (t->at[k].count == 0 || seen++ < YOUNG) continue;
        e.chi2 += t->at[k].d2;
        e.log_det += t->at[k].log_det;
        e.n += 3 * t->at[k].count;
    }
    return e;
}

static evidence look(orr_track_context *c, const orr_node *list, const orr_verdict *verdict, orr_track *t)
{
    orr_filter_sums(c, list, verdict, t, 0, t->n - 1);
    return add_up(t);
}

// Logarithm of the posterior of scale s; q in nm^2/s^5 for a scale of one.
static double posterior(const evidence *e, double s, double sigma_mm, double q)
{
    const double a = (log(s * sigma_mm) - log(SCALE_MM)) / SCALE_SPREAD,
                 b = (log10(q * s * s) - LOG_Q) / LOG_Q_SPREAD;
    return -e->log_det - (double)e->n * log(s) - 0.5 * e->chi2 / (s * s) - 0.5 * a * a - 0.5 * b * b;
}

orr_claim orr_noise_claim(const orr_track_context *c, double node_step_s, bool eclipsing)
{
    if (c->noise.nx != ORR_NX || node_step_s < SPARSE_S) return (orr_claim){1, 0};
    return eclipsing ? (orr_claim){3, 0.01} : (orr_claim){1.4, 0};
}

bool orr_noise_ratio_is_sought(double node_step_s) { return node_step_s > DENSE_S; }

double orr_noise_evidence(const orr_track_context *c, double chi2, double log_det, size_t n,
                          double node_step_s)
{
    const evidence e = {chi2, log_det, n};
    const double sigma_mm = 1e3 * c->options->sigma_m, q = c->noise.factor.q * c->noise.qf_m2ps5 * 1e18;
    double most = -HUGE_VAL;
    if (n == 0) return 0;
    for (int k = 0; k < SCALES; k++) {
        const double s = LEAST_S * pow(MOST_S / LEAST_S, k / (SCALES - 1.0));
        const double b = node_step_s <= DENSE_S ? (log10(q * s * s) - LOG_Q) / LOG_Q_SPREAD : 0;
        most = fmax(most,
                    posterior(&e, s, sigma_mm, q) + 0.5 * b * b); // a ratio that was not sought has no prior
    }
    return most;
}

orr_noise_choice orr_noise_choose(orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                                  orr_track *t, bool filtered, double node_step_s)
{
    const orr_noise_factor factor = c->noise.factor;
    const double sigma_mm = 1e3 * c->options->sigma_m;
    orr_noise_choice best = {.scale = SCALE_MM / sigma_mm, .factor = factor};
    if (node_step_s <= DENSE_S) {
        const evidence e = filtered ? add_up(t) : look(c, list, verdict, t);
        best.nodes = e.n / 3;
        // few nodes: the rounding has the word of some of them
        const double prior = 3, s0 = SCALE_MM / sigma_mm;
        best.scale = sqrt((e.chi2 + 3 * prior * s0 * s0) / ((double)e.n + 3 * prior));
        return best;
    }
    double most = -HUGE_VAL;
    for (double lq = LOWEST; lq <= HIGHEST; lq += STEP) {
        c->noise.factor.q = factor.q * pow(10, lq);
        const evidence e = look(c, list, verdict, t);
        const double q = c->noise.factor.q * c->noise.qf_m2ps5 * 1e18;
        for (int k = 0; k < SCALES; k++) {
            const double s = LEAST_S * pow(MOST_S / LEAST_S, k / (SCALES - 1.0)),
                         p = posterior(&e, s, sigma_mm, q);
            if (!(p > most)) continue;
            most = p;
            best = (orr_noise_choice){s, c->noise.factor, e.n / 3};
        }
    }
    c->noise.factor = best.factor;
    look(c, list, verdict, t);
    return best;
}

#define WIDEST 9.0 // log10 of the factors of qf that are tried for a low orbit
#define FINE 0.25
#define FREE_SPREAD 1.5 // of the logarithm of the scale

orr_noise_choice orr_noise_choose_freely(orr_track_context *c, const orr_node *list,
                                         const orr_verdict *verdict, orr_track *t)
{
    const orr_noise_factor factor = c->noise.factor;
    orr_noise_choice best = {.scale = 1, .factor = factor};
    double most = -HUGE_VAL;
    for (double lq = LOWEST; lq <= WIDEST; lq += FINE) {
        c->noise.factor.q = factor.q * pow(10, lq);
        const evidence e = look(c, list, verdict, t);
        if (e.n < 3 * LEAST_TELLING || !(e.chi2 > 0)) break;
        // The scale is the one that suits the factor best: its square is the mean of the squares.
        // Where the model is what errs, the likelihood is flat over decades: what files are rounded to decides.
        const double n = (double)e.n, a = log(sqrt(e.chi2 / n) * 1e3 * c->options->plain.sigma_m / SCALE_MM),
                     p = -e.log_det - 0.5 * n * log(e.chi2 / n) - 0.5 * a * a / (FREE_SPREAD * FREE_SPREAD);
        if (!(p > most)) continue;
        most = p;
        best = (orr_noise_choice){sqrt(e.chi2 / n), c->noise.factor, e.n / 3};
    }
    c->noise.factor = best.factor;
    return best;
}

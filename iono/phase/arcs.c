// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/phase/arcs.h"
#include "core/array.h"
#include "core/linalg.h"
#include "core/nan.h"
#include "core/robust.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GF_SIDE 5      // samples either side of a boundary for the phase's parabola and step
#define MW_SIDE 20     // and for the means of the wide lane
#define END_SIDE 2     // samples at an end of a pass that are dropped where they do not go on smoothly,
#define END_SIGMAS 5.5 // by so many sigma
#define END_TECU                                                                                             \
    0.8         // and by so much: noise at the horizon grows faster than it can be judged from samples nearby
#define NEAR 12 // samples either side from which the noise of one is judged
#define UNIQUE 12.0     // chi-square by which one pair of cycles must beat every other to be believed
#define FITS 16.0       // chi-square (two values) with which a pair of cycles still explains a step
#define ALIKE_TECU 0.06 // pairs of cycles whose steps differ by less are one as far as TEC goes

orr_arc_options orr_arc_default_options(void)
{
    return (orr_arc_options){
        .max_gap_s = 300, .min_span_s = 900, .min_samples = 20, .evidence = 30, .step_tecu = 1.0};
}

const char *orr_slip_verdict_name(orr_slip_verdict v)
{
    static const char *const names[] = {"break", "repaired", "none", "outlier"};
    return names[v];
}

char *orr_slip_cause_text(unsigned causes, char buf[40])
{
    static const char *const names[] = {"gap", "lli", "gf", "mw", "step"};
    buf[0] = '\0';
    for (int i = 0; i < 5; i++)
        if (causes & (1u << i)) {
            if (buf[0] != '\0') strcat(buf, "+");
            strcat(buf, names[i]);
        }
    return buf;
}

// The usable samples of a series, packed.
typedef struct packed {
    size_t n, *from; // index in the series
    double *t, *gf, *mw, dt;
    double *gf_sigma, *mw_sigma, *bend; // noise of a sample; second difference of the phase over one interval
    unsigned char *lost, *cut, *gone;   // cut: a boundary before the sample; gone: outlier
    double *score;                      // of the boundary before the sample
    double gf1, gf2;
} packed;

static void packed_free(packed *p)
{
    free(p->from);
    free(p->t);
    free(p->lost);
}

static orr_status pack(const orr_arc_series *s, packed *p, orr_diag *diag)
{
    size_t n = s->n;
    *p = (packed){.gf1 = s->gf1_tecu, .gf2 = s->gf2_tecu};
    p->from = malloc((n + 1) * sizeof *p->from);
    p->t = malloc(7 * (n + 1) * sizeof *p->t);
    p->lost = calloc(3 * (n + 1), 1);
    if (p->from == NULL || p->t == NULL || p->lost == NULL) {
        packed_free(p);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory to look for cycle slips");
    }
    p->gf = p->t + (n + 1);
    p->mw = p->gf + (n + 1);
    p->gf_sigma = p->mw + (n + 1);
    p->mw_sigma = p->gf_sigma + (n + 1);
    p->bend = p->mw_sigma + (n + 1);
    p->score = p->bend + (n + 1);
    p->cut = p->lost + (n + 1);
    p->gone = p->cut + (n + 1);
    bool lost = false;
    for (size_t i = 0; i < n; i++) {
        if (i > 0 && !(s->t_s[i] > s->t_s[i - 1])) {
            packed_free(p);
            return orr_diag_set(diag, ORR_E_ARG, "samples for arcs are not in time order");
        }
        lost |= s->lost != NULL && s->lost[i];
        if (isnan(s->gf_tecu[i])) continue; // its flag goes to the next sample
        size_t k = p->n++;
        p->from[k] = i;
        p->t[k] = s->t_s[i];
        p->gf[k] = s->gf_tecu[i];
        p->mw[k] = s->mw_cyc != NULL ? s->mw_cyc[i] : ORR_NAN;
        p->lost[k] = lost;
        lost = false;
    }
    if (p->n >= 2) {
        for (size_t k = 1; k < p->n; k++) p->score[k] = p->t[k] - p->t[k - 1];
        p->dt = orr_median(p->score + 1, p->n - 1);
    }
    return ORR_OK;
}

static bool close_by(const packed *p, size_t first, size_t last)
{
    return p->t[last] - p->t[first] < 1.5 * p->dt * (double)(last - first);
}

// Noise by medians of differences nearby: what slips and outliers do to a few of them does not show.
static void judge_noise(packed *p)
{
    double third[2 * NEAR + 1], second[2 * NEAR + 1], wide[2 * NEAR + 1];
    for (size_t i = 0; i < p->n; i++) {
        size_t n3 = 0, n2 = 0, nw = 0;
        for (size_t k = i > NEAR ? i - NEAR : 0; k < p->n && k <= i + NEAR; k++) {
            if (k >= 3 && close_by(p, k - 3, k))
                third[n3++] = fabs(p->gf[k] - 3 * p->gf[k - 1] + 3 * p->gf[k - 2] - p->gf[k - 3]);
            if (k >= 2 && close_by(p, k - 2, k))
                second[n2++] = fabs(p->gf[k] - 2 * p->gf[k - 1] + p->gf[k - 2]);
            if (k >= 1 && !isnan(p->mw[k] + p->mw[k - 1])) wide[nw++] = fabs(p->mw[k] - p->mw[k - 1]);
        }
        // Third differences of white noise grow by sqrt(20), first ones by sqrt(2).
        double gf = n3 >= 6 ? ORR_SIGMA_PER_MAD * orr_median(third, n3) / sqrt(20) : 0.05;
        double mw = nw >= 6 ? ORR_SIGMA_PER_MAD * orr_median(wide, nw) / sqrt(2) : 0.5;
        p->gf_sigma[i] = gf > 0.01 ? gf : 0.01;
        p->bend[i] = n2 >= 6 ? ORR_SIGMA_PER_MAD * orr_median(second, n2) : 0.05;
        p->mw_sigma[i] = mw > 0.05 ? mw : 0.05;
    }
}

typedef struct step {
    double gf, gf_sigma, mw, mw_sigma; // NAN where not measurable
    size_t side;                       // samples of the phase on the poorer side
} step;

// Value and variance of the last of m unknowns of the normal equations a x = y, both overwritten. False where they
// do not determine it.
static bool last_unknown(size_t m, double *a, double *y, double *value, double *variance)
{
    if (orr_cholesky_factor(a, m, 1e-13) != ORR_OK || orr_cholesky_solve_lower(a, m, y) != ORR_OK)
        return false;
    const double pivot = a[m * m - 1];
    *value = y[m - 1] / pivot;
    *variance = 1 / (pivot * pivot);
    return true;
}

// The step between samples b - 1 and b, from samples of [lo, hi); sample `without` is left out (SIZE_MAX:
// none).
static step measure(const packed *p, size_t lo, size_t b, size_t hi, size_t without)
{
    step s = {ORR_NAN, ORR_NAN, ORR_NAN, ORR_NAN, 0};
    size_t left[GF_SIDE], right[GF_SIDE], nl = 0, nr = 0;
    for (size_t k = b; k-- > lo && nl < GF_SIDE;)
        if (!p->gone[k] && k != without) left[nl++] = k;
    for (size_t k = b; k < hi && nr < GF_SIDE; k++)
        if (!p->gone[k] && k != without) right[nr++] = k;
    if (nl == 0 || nr == 0) return s;
    s.side = nl < nr ? nl : nr;
    double t0 = (p->t[left[0]] + p->t[right[0]]) / 2, gap = p->t[right[0]] - p->t[left[0]];
    size_t total = nl + nr;
    if (total >= 4 && nl * nr >= 3) {
        bool bent = total >= 6;
        const size_t m = bent ? 4 : 3;
        double a[4 * 4] = {0}, y[4] = {0}, scale = GF_SIDE * p->dt, sigma = 0;
        for (size_t i = 0; i < total; i++) {
            size_t k = i < nl ? left[i] : right[i - nl];
            double x = (p->t[k] - t0) / scale, h = i < nl ? 0 : 1, f[4] = {1, x, bent ? x * x : h, h};
            for (size_t r = 0; r < m; r++) {
                for (size_t c = 0; c <= r; c++) a[r * m + c] += f[r] * f[c];
                y[r] += f[r] * p->gf[k];
            }
            sigma = fmax(sigma, p->gf_sigma[k]);
        }
        double v, var;
        if (last_unknown(m, a, y, &v, &var)) {
            double bend = fmax(p->bend[left[0]], p->bend[right[0]]), over = gap / p->dt;
            // A line misses a bend altogether; a parabola what it changes by over a gap.
            double model = bent ? 0.3 * bend * (pow(over, 1.5) - 1) : bend * over;
            s.gf = v;
            s.gf_sigma = sqrt(sigma * sigma * var + model * model + 0.01 * 0.01);
        }
    }
    double sl = 0, sr = 0, sigma = 0;
    size_t cl = 0, cr = 0;
    for (size_t k = b; k-- > lo && cl < MW_SIDE;)
        if (!p->gone[k] && k != without && !isnan(p->mw[k])) {
            sl += p->mw[k];
            sigma = fmax(sigma, p->mw_sigma[k]);
            cl++;
        }
    for (size_t k = b; k < hi && cr < MW_SIDE; k++)
        if (!p->gone[k] && k != without && !isnan(p->mw[k])) {
            sr += p->mw[k];
            sigma = fmax(sigma, p->mw_sigma[k]);
            cr++;
        }
    if (cl > 0 && cr > 0) {
        s.mw = sr / (double)cr - sl / (double)cl;
        // Codes' multipath makes neighbours alike: four count as one; and means are never better than 0.07
        // cycles.
        double ml = fmax(1, (double)cl / 4), mr = fmax(1, (double)cr / 4);
        s.mw_sigma = sqrt(sigma * sigma * (1 / ml + 1 / mr) + 0.005);
    }
    return s;
}

typedef struct judgement {
    double none; // chi-square of no slip
    double best,
        other;         // of the best pair of cycles (not 0, 0), and of the best one unlike it (0, 0 included)
    double none_other; // of the best pair unlike 0, 0
    int n1, n2;
} judgement;

static double chi2(const packed *p, const step *s, int n1, int n2)
{
    double x = 0;
    if (!isnan(s->gf)) {
        double d = (s->gf - p->gf1 * n1 + p->gf2 * n2) / s->gf_sigma;
        x += d * d;
    }
    if (!isnan(s->mw)) {
        double d = (s->mw - (n1 - n2)) / s->mw_sigma;
        x += d * d;
    }
    return x;
}

// Tries every wide lane near the measured one (all small ones where it is not) with the two nearest n1 of
// each.
static judgement judge(const packed *p, const step *s)
{
    judgement j = {chi2(p, s, 0, 0), 1e30, 1e30, 1e30, 0, 0};
    double mid = isnan(s->mw) ? 0 : fmin(fmax(s->mw, -1e8), 1e8), gf = isnan(s->gf) ? 0 : s->gf;
    double slope = p->gf1 - p->gf2;
    int centre = (int)lround(mid), pair[2 * 9 + 1][2], n = 0;
    double x[2 * 9 + 1];
    for (int w = centre - 4; w <= centre + 4; w++) {
        double n1 = (gf - p->gf2 * w) / slope;
        if (!(fabs(n1) < 1e9)) continue;
        for (int i = 0; i < 2; i++) {
            int a = (int)floor(n1) + i;
            pair[n][0] = a;
            pair[n][1] = a - w;
            x[n] = chi2(p, s, a, a - w);
            n++;
        }
    }
    for (int i = 0; i < n; i++) {
        if (pair[i][0] == 0 && pair[i][1] == 0) continue;
        if (x[i] < j.best) {
            j.best = x[i];
            j.n1 = pair[i][0];
            j.n2 = pair[i][1];
        }
        if (fabs(p->gf1 * pair[i][0] - p->gf2 * pair[i][1]) > ALIKE_TECU)
            j.none_other = fmin(j.none_other, x[i]);
    }
    double best_gf = p->gf1 * j.n1 - p->gf2 * j.n2;
    if (fabs(best_gf) > ALIKE_TECU) j.other = j.none;
    for (int i = 0; i < n; i++)
        if (fabs(p->gf1 * pair[i][0] - p->gf2 * pair[i][1] - best_gf) > ALIKE_TECU)
            j.other = fmin(j.other, x[i]);
    return j;
}

// How strongly the measurements speak for a slip at a boundary that nothing else makes suspicious; 0: not
// enough.
static double evidence_of(const packed *p, const step *s, double needed)
{
    if (isnan(s->gf)) return 0;
    // At the ends of a pass the noise grows fast and few samples support a slip.
    needed *= 1 + 2 * (1 - (double)s->side / GF_SIDE);
    judgement j = judge(p, s);
    if (j.best < FITS && j.none - j.best > needed) return j.none - j.best;
    double d = s->gf / s->gf_sigma;
    // One or two samples at an end cannot prove a slip, but nor are they worth much: what does not go on smoothly goes.
    if (s->side <= END_SIDE && fabs(d) > END_SIGMAS && fabs(s->gf) > END_TECU) return d * d;
    // No pair of whole cycles explains it, but the phase has jumped all the same.
    return j.best >= FITS && d * d > 2 * needed ? d * d - needed : 0;
}

static void bounds(const packed *p, size_t b, size_t *lo, size_t *hi)
{
    *lo = b;
    while (*lo > 0 && b - *lo < MW_SIDE + 5 && !(*lo < b && p->cut[*lo])) --*lo;
    *hi = b;
    while (*hi < p->n && *hi - b < MW_SIDE + 5 && !(*hi > b && p->cut[*hi])) ++*hi;
}

static void score(packed *p, size_t b, double needed)
{
    p->score[b] = 0;
    if (p->cut[b] || p->gone[b]) return;
    size_t lo, hi;
    bounds(p, b, &lo, &hi);
    step s = measure(p, lo, b, hi, SIZE_MAX);
    p->score[b] = evidence_of(p, &s, needed);
}

// A sample that is off while its neighbours agree across it.
static void find_outliers(packed *p)
{
    for (size_t k = 1; k + 1 < p->n; k++) {
        if (p->cut[k] || p->cut[k + 1]) continue;
        double d = fabs(p->gf[k] - (p->gf[k - 1] + p->gf[k + 1]) / 2);
        if (d < 0.2 || d < 6 * p->gf_sigma[k] || d < 4 * p->bend[k] || p->gone[k - 1]) continue;
        size_t lo, hi;
        bounds(p, k, &lo, &hi);
        step across = measure(p, lo, k, hi, k), onto = measure(p, lo, k, k + 1, SIZE_MAX);
        if (isnan(across.gf) || isnan(onto.gf)) continue;
        bool agree = fabs(across.gf) < 4 * across.gf_sigma && fabs(across.gf) < 0.3 * fabs(onto.gf);
        if (agree && fabs(onto.gf) > 6 * onto.gf_sigma) p->gone[k] = 1;
    }
}

// Takes the strongest boundary again and again, because a slip spoils the windows of its neighbours.
static void find_cuts(packed *p, const orr_arc_options *o)
{
    for (size_t k = 1; k < p->n; k++) score(p, k, o->evidence);
    for (;;) {
        size_t best = 0;
        for (size_t k = 1; k < p->n; k++)
            if (p->score[k] > 0 && (best == 0 || p->score[k] > p->score[best])) best = k;
        if (best == 0) return;
        p->cut[best] = 1;
        size_t from = best > MW_SIDE + 5 ? best - MW_SIDE - 5 : 1;
        for (size_t k = from; k < p->n && k <= best + MW_SIDE + 5; k++) score(p, k, o->evidence);
    }
}

static bool keep_slip(orr_arcs *a, orr_slip s)
{
    if (!ORR_ARRAY_GROW(a->slip, a->n_slips)) return false;
    a->slip[a->n_slips++] = s;
    return true;
}

static orr_slip decide(const packed *p, size_t start, size_t b, size_t next, const orr_arc_options *o)
{
    size_t before = b;
    while (before > start && p->gone[before - 1]) before--;
    orr_slip s = {.at = p->from[b], .gap_s = before > start ? p->t[b] - p->t[before - 1] : 0};
    step m = measure(p, start, b, next, SIZE_MAX);
    judgement j = judge(p, &m);
    s.gf_tecu = m.gf;
    s.gf_sigma_tecu = m.gf_sigma;
    s.mw_cyc = m.mw;
    s.mw_sigma_cyc = m.mw_sigma;
    bool gap = s.gap_s > 1.5 * p->dt;
    if (gap) s.causes |= ORR_SLIP_GAP;
    if (p->lost[b]) s.causes |= ORR_SLIP_LLI;
    if (fabs(m.gf) > 4 * m.gf_sigma) s.causes |= ORR_SLIP_GF;
    if (fabs(m.mw) > 4 * m.mw_sigma) s.causes |= ORR_SLIP_MW;
    s.verdict = ORR_SLIP_BREAK;
    if (s.gap_s > o->max_gap_s || isnan(m.gf)) return s;
    if (j.none < FITS && j.none_other - j.none > UNIQUE && j.none - j.best < o->evidence)
        s.verdict = ORR_SLIP_NONE;
    else if (j.best < FITS && j.other - j.best > UNIQUE) {
        s.verdict = ORR_SLIP_REPAIRED;
        s.n1 = j.n1;
        s.n2 = j.n2;
    }
    return s;
}

static orr_status collect(const orr_arc_series *series, packed *p, const orr_arc_options *o, orr_arcs *out)
{
    size_t start = 0;
    double fix = 0, wide = 0;
    out->n_samples = series->n;
    out->arc_of = malloc((series->n + 1) * sizeof *out->arc_of);
    out->fix_tecu = calloc(series->n + 1, sizeof *out->fix_tecu);
    out->arc = malloc((p->n + 1) * sizeof *out->arc);
    if (out->arc_of == NULL || out->fix_tecu == NULL || out->arc == NULL) return ORR_E_MEMORY;
    for (size_t i = 0; i < series->n; i++) out->arc_of[i] = -1;
    for (size_t k = 0; k <= p->n; k++) {
        bool ends = k == p->n;
        if (!ends && p->cut[k] && k > start) {
            size_t next = k + 1;
            while (next < p->n && !p->cut[next]) next++;
            for (size_t i = k; i < next; i++) { // what earlier repairs say of these samples
                p->gf[i] -= fix;
                p->mw[i] -= wide;
            }
            orr_slip s = decide(p, start, k, next, o);
            double gf_jump = p->gf1 * s.n1 - p->gf2 * s.n2, mw_jump = s.n1 - s.n2;
            for (size_t i = k; i < next; i++) {
                p->gf[i] -= gf_jump;
                p->mw[i] -= mw_jump;
            }
            fix += gf_jump;
            wide += mw_jump;
            // A neighbour of a slip that looked like one until that slip was known is no event.
            bool idle = s.verdict == ORR_SLIP_NONE && !(s.causes & (ORR_SLIP_GAP | ORR_SLIP_LLI));
            if (!idle && !keep_slip(out, s)) return ORR_E_MEMORY;
            ends = s.verdict == ORR_SLIP_BREAK;
        }
        if (ends && k > start) {
            orr_arc a = {0};
            for (size_t i = start; i < k; i++)
                if (!p->gone[i]) {
                    if (a.n++ == 0) a.first = p->from[i];
                    a.last = p->from[i];
                }
            bool kept = a.n >= o->min_samples && a.n > 0 &&
                        series->t_s[a.last] - series->t_s[a.first] >= o->min_span_s;
            for (size_t i = start; i < k; i++)
                if (!p->gone[i] && kept) out->arc_of[p->from[i]] = (int)out->n_arcs;
            if (kept)
                out->arc[out->n_arcs++] = a;
            else
                out->n_dropped += a.n;
            start = k;
        }
        if (k < p->n) {
            out->fix_tecu[p->from[k]] = fix;
            if (p->gone[k] && !keep_slip(out, (orr_slip){.at = p->from[k],
                                                         .causes = ORR_SLIP_GF,
                                                         .verdict = ORR_SLIP_OUTLIER,
                                                         .gf_tecu = ORR_NAN,
                                                         .gf_sigma_tecu = ORR_NAN,
                                                         .mw_cyc = ORR_NAN,
                                                         .mw_sigma_cyc = ORR_NAN}))
                return ORR_E_MEMORY;
        }
    }
    return ORR_OK;
}

orr_status orr_arcs_find(const orr_arc_series *series, const orr_arc_options *options, orr_arcs *out,
                         orr_diag *diag)
{
    *out = (orr_arcs){0};
    orr_arc_options o = options != NULL ? *options : orr_arc_default_options();
    packed p;
    orr_status s = pack(series, &p, diag);
    if (s != ORR_OK) return s;
    judge_noise(&p);
    for (size_t k = 1; k < p.n; k++) p.cut[k] = p.lost[k] || p.t[k] - p.t[k - 1] > 1.5 * p.dt;
    find_outliers(&p);
    find_cuts(&p, &o);
    s = collect(series, &p, &o, out);
    if (s != ORR_OK) {
        orr_arcs_free(out);
        s = orr_diag_set(diag, s, "no memory for arcs");
    }
    packed_free(&p);
    return s;
}

void orr_arcs_free(orr_arcs *a)
{
    free(a->arc_of);
    free(a->fix_tecu);
    free(a->arc);
    free(a->slip);
    *a = (orr_arcs){0};
}

bool orr_arc_step(const double *t_s, const double *residual_tecu, size_t n, const orr_arc_options *options,
                  size_t *at, double *step_tecu)
{
    enum { SIDE = 20 };
    orr_arc_options o = options != NULL ? *options : orr_arc_default_options();
    double best = 0;
    for (size_t b = SIDE; b + SIDE <= n; b++) {
        double a[3 * 3] = {0}, y[3] = {0}, t0 = t_s[b], scale = t_s[b + SIDE - 1] - t_s[b - SIDE], v, var,
                     sum = 0;
        for (size_t k = b - SIDE; k < b + SIDE; k++) {
            double f[3] = {1, (t_s[k] - t0) / scale, k >= b ? 1 : 0};
            for (size_t r = 0; r < 3; r++) {
                for (size_t c = 0; c <= r; c++) a[r * 3 + c] += f[r] * f[c];
                y[r] += f[r] * residual_tecu[k];
            }
        }
        if (!last_unknown(3, a, y, &v, &var) || fabs(v) < o.step_tecu || fabs(v) < fabs(best)) continue;
        // Noise from first differences, the one across the boundary left out.
        for (size_t k = b - SIDE + 1; k < b + SIDE; k++)
            if (k != b)
                sum += (residual_tecu[k] - residual_tecu[k - 1]) * (residual_tecu[k] - residual_tecu[k - 1]);
        double sigma = sqrt(sum / (2 * SIDE - 2)), jump = residual_tecu[b] - residual_tecu[b - 1];
        // A bend of the ionosphere takes minutes; a slip takes one interval.
        if (fabs(v) < 8 * sigma * sqrt(var) || fabs(jump) < 0.6 * fabs(v)) continue;
        best = v;
        *at = b;
    }
    *step_tecu = best;
    return best != 0;
}

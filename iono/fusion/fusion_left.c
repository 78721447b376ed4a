// SPDX-License-Identifier: GPL-3.0-or-later
// The correction judged by arcs that it was not fitted to: each arc in turn is taken out of the normal equations, and
// the correction of the others is compared with it.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "iono/fusion/fusion_private.h"

// Sums of one kind of difference over the samples.
typedef struct sums {
    double centred[ORR_FUSION_BANDS], dstec;
} sums;

static int band_of(double el_rad)
{
    int b = (int)(el_rad * ORR_DEG_PER_RAD / 10);
    return b > ORR_FUSION_BANDS - 1 ? ORR_FUSION_BANDS - 1 : b;
}

// The phase minus the corrected (0) or plain (1) field along an arc, about its mean and about its highest sample.
static void judge(const orr_phase_tec *p, orr_fusion *f, const orr_fused_arc *arc, sums sum[2])
{
    const orr_phase_sat *sat = &p->sat[arc->sat_index];
    const double *vtec = f->model_vtec[arc->sat_index], *map = f->mapping[arc->sat_index];
    double mean[2] = {0}, top[2] = {0}, highest = -1;
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = SIZE_MAX; fusion_next_sample(sat, (int)arc->arc, 0, vtec, &i);) {
            double r[2] = {fusion_residual(p, f, arc, i),
                           sat->gf_tecu[i] - arc->bias_tecu - map[i] * vtec[i]};
            int b = band_of(sat->pierce[i].el_rad);
            for (int k = 0; k < 2; k++)
                if (pass == 0) {
                    mean[k] += r[k] / (double)arc->n;
                    if (sat->pierce[i].el_rad > highest) top[k] = r[k];
                } else {
                    sum[k].centred[b] += (r[k] - mean[k]) * (r[k] - mean[k]);
                    sum[k].dstec += (r[k] - top[k]) * (r[k] - top[k]);
                }
            if (pass == 0)
                highest = fmax(highest, sat->pierce[i].el_rad);
            else {
                f->left.band[b].n++;
                f->left.n_samples++;
            }
        }
    f->left.n_arcs++;
}

static void conclude(const sums sum[2], orr_leave_out *out)
{
    double all[2] = {0}, n = (double)out->n_samples;
    for (int b = 0; b < ORR_FUSION_BANDS; b++) {
        double count = (double)out->band[b].n;
        all[0] += sum[0].centred[b];
        all[1] += sum[1].centred[b];
        out->band[b].corrected_tecu = count > 0 ? sqrt(sum[0].centred[b] / count) : ORR_NAN;
        out->band[b].plain_tecu = count > 0 ? sqrt(sum[1].centred[b] / count) : ORR_NAN;
    }
    out->corrected_tecu = n > 0 ? sqrt(all[0] / n) : ORR_NAN;
    out->plain_tecu = n > 0 ? sqrt(all[1] / n) : ORR_NAN;
    out->corrected_dstec_tecu = n > 0 ? sqrt(sum[0].dstec / n) : ORR_NAN;
    out->plain_dstec_tecu = n > 0 ? sqrt(sum[1].dstec / n) : ORR_NAN;
}

orr_status fusion_leave_out(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                            orr_diag *diag)
{
    out->left = (orr_leave_out){0};
    // Arcs of an hour; in a session of two hours and less those of half its length.
    double least = fmin(3600, orr_time_diff_s(phase->to, phase->from) / 2), likelihood;
    for (int b = 0; b < ORR_FUSION_BANDS; b++) {
        out->left.band[b].from_deg = 10 * b;
        out->left.band[b].to_deg = 10 * (b + 1);
    }
    fusion_normal all, less = {0};
    orr_status s = fusion_normal_init(out, &all, diag);
    if (s == ORR_OK) s = fusion_normal_init(out, &less, diag);
    size_t n_terms = out->correction.n * sizeof *out->correction.term;
    double(*kept)[ORR_CORRECTION_TERMS] = malloc(n_terms + 1);
    if (s == ORR_OK && kept == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory to leave arcs out");
    if (s == ORR_OK) {
        sums sum[2] = {{{0}, 0}, {{0}, 0}};
        memcpy(kept, out->correction.term, n_terms);
        fusion_normal_build(&all, phase, o, out);
        for (size_t a = 0; s == ORR_OK && a < out->n_arcs; a++) {
            const orr_fused_arc *arc = &out->arc[a];
            if (orr_time_diff_s(arc->to, arc->from) < least) continue;
            memcpy(less.matrix, all.matrix, all.n * all.n * sizeof *all.matrix);
            memcpy(less.rhs, all.rhs, all.n * sizeof *all.rhs);
            fusion_normal_add_arc(&less, phase, o, out, arc, -1);
            s = fusion_normal_factor(&less, &likelihood);
            if (s != ORR_OK) {
                orr_diag_set(diag, s, "the fit without one of the arcs has no unique answer");
                break;
            }
            fusion_normal_take_correction(&less, out);
            judge(phase, out, arc, sum);
        }
        conclude(sum, &out->left);
        memcpy(out->correction.term, kept, n_terms);
    }
    free(kept);
    fusion_normal_free(&all);
    fusion_normal_free(&less);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/file_noise.h"

#include <stdlib.h>
#include <string.h>

#include "core/robust.h"
#include "orbit/smooth/leave_out.h"
#include "orbit/smooth/noise_choice.h"

const double orr_shadow_factor[ORR_SHADOW_FACTORS] = {1, 30, 1e3, 3e4};

#define YOUNG 3         // nodes of an arc that a start decides
#define MOST_SAY 25.0   // what one satellite may add to the evidence of all
#define LEAST_GAIN 10.0 // evidence below it is none: odds of 20000 to one
#define LEAST_MEAN 0.2  // and of a step at noon a satellite: all of a file have it, or none
#define TELLING_NODES 8 // of a file, after its first
// An end's record is another orbit's if three fifths of the satellites are so far off: of good files the median is 0.5 to 1.2.
#define FOREIGN 2.0
#define FOREIGN_PART 0.4 // of the satellites may be nearer
#define FOREIGN_SATELLITES 8

typedef struct sums { // of the innovations in nodes of one file
    double chi2, log_det;
    size_t n; // coordinates
} sums;

static void add_up(const orr_node *list, const orr_track *t, size_t n_files, sums *of)
{
    size_t seen = 0;
    memset(of, 0, n_files * sizeof *of);
    for (size_t k = 0; k < t->n; k++) {
        const orr_instant *at = &t->at[k];
        if (at->count == 0 || seen++ < YOUNG) continue;
        const uint16_t file = list[at->first].source;
        of[file].chi2 += at->d2;
        of[file].log_det += at->log_det;
        of[file].n += 3 * at->count;
    }
}

// Likelihoods of the sums at the scale that suits each file best; only larger ones are kept.
static void take_best(const orr_track_context *c, const sums *of, double node_step_s, size_t n_files,
                      double *best)
{
    for (size_t f = 0; f < n_files; f++)
        best[f] = fmax(best[f], orr_noise_evidence(c, of[f].chi2, of[f].log_det, of[f].n, node_step_s));
}

// Filters with the hypothesis that stands in t; best[file]: its likelihood. Where more noise is allowed in one place and the
// ratio is sought from the data, a smaller one may suit the rest.
static void weigh(orr_track_context *c, const orr_node *list, const orr_verdict *verdict, orr_track *t,
                  double node_step_s, bool seek, size_t n_files, sums *of, double *best)
{
    const orr_noise_factor factor = c->noise.factor;
    for (size_t f = 0; f < n_files; f++) best[f] = -HUGE_VAL;
    for (int i = 0; i < (seek ? 3 : 1); i++) {
        orr_filter_sums(c, list, verdict, t, 0, t->n - 1);
        add_up(list, t, n_files, of);
        take_best(c, of, node_step_s, n_files, best);
        c->noise.factor.q *= 0.1;
    }
    c->noise.factor = factor;
}

static bool passes_shadow(const orr_track *t)
{
    for (size_t k = 0; k < t->n; k++)
        if (t->at[k].next.near_shadow) return true;
    return false;
}

static bool passes_noon(const orr_track *t)
{
    for (size_t k = 1; k + 1 < t->n; k++)
        if (t->at[k].noon) return true;
    return false;
}

// Where the noise is not what the filter takes it for, a step fits better anywhere: what one three hours before and after noon
// gains says nothing of noon.
enum { CONTROLS = 3 };
static const double control_s[CONTROLS] = {0, -10800, 10800};

static void allow_step(orr_track *t, double from_noon_s)
{
    for (size_t i = 0; i < t->n; i++) t->at[i].pulse = false;
    for (size_t k = 0; k < t->n; k++)
        for (size_t i = 0; i < t->n && t->at[k].noon; i++)
            if (i > 0 && fabs(t->at[i].t_s - t->at[k].t_s - from_noon_s) < 1) t->at[i].pulse = true;
}

void orr_file_evidence_add(orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                           orr_track *t, double node_step_s, size_t n_files, orr_file_evidence *evidence)
{
    const bool shadow = passes_shadow(t), noon = passes_noon(t);
    sums *of = calloc(n_files, sizeof *of);
    double *best = calloc(3 * n_files, sizeof *best);
    if (of == NULL || best == NULL || (!shadow && !noon)) {
        free(of);
        free(best);
        return; // without evidence nothing is assumed
    }
    double *other = best + n_files;
    add_up(list, t, n_files, of);
    for (size_t f = 0; f < n_files; f++) best[f] = -HUGE_VAL;
    take_best(c, of, node_step_s, n_files, best);
    const bool sought = orr_noise_ratio_is_sought(node_step_s);
    size_t *n = calloc(n_files, sizeof *n);
    for (size_t f = 0; f < n_files && n != NULL; f++) n[f] = of[f].n / 3;
    for (int k = 0; k < ORR_SHADOW_FACTORS && shadow && n != NULL; k++) {
        for (size_t i = 0; i < t->n; i++) t->at[i].shadow = orr_shadow_factor[k] - 1;
        if (k > 0) weigh(c, list, verdict, t, node_step_s, sought, n_files, of, other);
        for (size_t f = 0; f < n_files; f++) {
            if (n[f] < TELLING_NODES) continue;
            evidence[f].eclipsing = true;
            evidence[f].shadow[k] += k > 0 ? other[f] - best[f] : 0;
        }
    }
    for (size_t i = 0; i < t->n; i++) t->at[i].shadow = 0;
    if (noon && !shadow && n != NULL) { // shadows are told apart from noon better where there are none
        double *gain = calloc(n_files, sizeof *gain);
        for (int control = 0; control < CONTROLS && gain != NULL; control++) {
            bool asked = control == 0;
            for (size_t f = 0; f < n_files; f++) asked = asked || gain[f] > 0;
            if (!asked) break;
            allow_step(t, control_s[control]);
            weigh(c, list, verdict, t, node_step_s, false, n_files, of, other);
            for (size_t f = 0; f < n_files; f++) {
                const double now = other[f] - best[f];
                gain[f] = control == 0 ? now : fmin(gain[f], gain[f] - now);
            }
        }
        for (size_t i = 0; i < t->n; i++) t->at[i].pulse = false;
        for (size_t f = 0; f < n_files && gain != NULL; f++) {
            if (n[f] < TELLING_NODES) continue;
            evidence[f].noon = true;
            evidence[f].noon_gain += gain[f];
        }
        free(gain);
    }
    free(n);
    free(of);
    free(best);
}

static double capped(double x) { return fmin(fmax(x, -MOST_SAY), MOST_SAY); }

void orr_file_ends_add(const orr_track_context *c, const orr_node *list, size_t n, const orr_verdict *verdict,
                       const orr_track *t, double scale, size_t n_files, orr_file_evidence *evidence)
{
    if (c->noise.nx != ORR_NX) return;
    for (size_t f = 0; f < n_files; f++) {
        orr_time first = ORR_TIME_NONE, last = ORR_TIME_NONE;
        size_t many = 0;
        for (size_t i = 0; i < n; i++) {
            if (list[i].source != f || !orr_node_counts(&list[i])) continue;
            if (many++ == 0) first = list[i].t;
            last = list[i].t;
        }
        for (size_t k = 0; k < t->n && many >= TELLING_NODES; k++)
            for (size_t i = t->at[k].first; i < t->at[k].first + t->at[k].n; i++) {
                if (list[i].source != f || !orr_node_counts(&list[i]) || list[i].predicted) continue;
                if (list[i].t != first && list[i].t != last) continue;
                const orr_left_out d = orr_leave_node_out(c, &t->at[k], &list[i], !verdict[i].rejected);
                evidence[f].end[list[i].t == last] =
                    (orr_end_evidence){d.d2 > 0, list[i].t, d.length_m, sqrt(d.d2) / scale};
            }
    }
}

// The record at an end of file f, by the satellites that have it.
static void decide_end(const orr_file_evidence *evidence, size_t n_sats, size_t n_files, size_t f, int end,
                       double *room, orr_foreign_record *out)
{
    *out = (orr_foreign_record){.t = ORR_TIME_NONE};
    for (size_t i = 0; i < n_sats; i++) {
        const orr_end_evidence *e = &evidence[i * n_files + f].end[end];
        if (e->told && (out->t == ORR_TIME_NONE || (end == 0 ? e->t < out->t : e->t > out->t))) out->t = e->t;
    }
    for (int what = 0; what < 2; what++) {
        out->n = 0;
        for (size_t i = 0; i < n_sats; i++) {
            const orr_end_evidence *e = &evidence[i * n_files + f].end[end];
            if (e->told && e->t == out->t) room[out->n++] = what == 0 ? e->ratio : e->off_m;
        }
        if (out->n < FOREIGN_SATELLITES) return;
        if (what == 0)
            out->foreign =
                orr_order_statistic(room, out->n, (size_t)(FOREIGN_PART * (double)out->n)) > FOREIGN;
        else
            out->off_m = orr_median(room, out->n);
    }
}

orr_status orr_file_noise_decide(const orr_file_evidence *evidence, size_t n_sats, size_t n_files,
                                 orr_file_noise *file)
{
    double *room = malloc((n_sats + 1) * sizeof *room);
    if (room == NULL) return ORR_E_MEMORY;
    for (size_t f = 0; f < n_files; f++) {
        double shadow[ORR_SHADOW_FACTORS] = {0};
        file[f] = (orr_file_noise){.shadow_factor = 1};
        for (size_t i = 0; i < n_sats; i++) {
            const orr_file_evidence *e = &evidence[i * n_files + f];
            for (int k = 1; k < ORR_SHADOW_FACTORS && e->eclipsing; k++) shadow[k] += capped(e->shadow[k]);
            file[f].eclipsing += e->eclipsing;
            file[f].telling += e->noon;
            if (e->noon) file[f].noon_gain += capped(e->noon_gain);
        }
        for (int k = 1; k < ORR_SHADOW_FACTORS; k++)
            if (shadow[k] > fmax(file[f].shadow_gain, LEAST_GAIN)) {
                file[f].shadow_gain = shadow[k];
                file[f].shadow_factor = orr_shadow_factor[k];
            }
        file[f].noon_step =
            file[f].noon_gain > LEAST_GAIN && file[f].noon_gain > LEAST_MEAN * (double)file[f].telling;
        for (int end = 0; end < ORR_FILE_ENDS; end++)
            decide_end(evidence, n_sats, n_files, f, end, room, &file[f].end[end]);
    }
    free(room);
    return ORR_OK;
}

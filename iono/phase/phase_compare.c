// SPDX-License-Identifier: GPL-3.0-or-later
// Two close receivers see the same curve (Bogdanov 2015, Fig. 10).
#include <stdlib.h>

#include "iono/phase/phase_tec.h"

typedef struct match {
    size_t i, j;
} match;

// Samples of both that belong to arcs and lie within match_s, in time order.
static size_t matches(const orr_phase_sat *a, const orr_phase_sat *b, double match_s, match *out)
{
    size_t n = 0, j = 0;
    for (size_t i = 0; i < a->n; i++) {
        if (a->arcs.arc_of[i] < 0) continue;
        while (j < b->n && orr_time_diff_s(b->t[j], a->t[i]) < -match_s) j++;
        size_t best = b->n;
        double least = match_s;
        for (size_t k = j; k < b->n && orr_time_diff_s(b->t[k], a->t[i]) <= match_s; k++) {
            double apart = fabs(orr_time_diff_s(b->t[k], a->t[i]));
            if (b->arcs.arc_of[k] < 0 || apart > least) continue;
            least = apart;
            best = k;
        }
        if (best < b->n) out[n++] = (match){i, best};
    }
    return n;
}

orr_status orr_phase_compare(const orr_phase_tec *a, const orr_phase_tec *b, double match_s,
                             size_t min_samples, orr_curves *out, orr_diag *diag)
{
    *out = (orr_curves){.baseline_m = orr_vec3_norm(orr_vec3_sub(a->site.pos_m, b->site.pos_m))};
    size_t room = 0, arcs = 0, longest = 0;
    for (size_t s = 0; s < a->n_sats; s++) {
        room += a->sat[s].n;
        arcs += a->sat[s].arcs.n_arcs;
        if (a->sat[s].n > longest) longest = a->sat[s].n;
    }
    for (size_t s = 0; s < b->n_sats; s++) arcs += b->sat[s].arcs.n_arcs;
    out->point = malloc((room + 1) * sizeof *out->point);
    out->curve = malloc((arcs + 1) * sizeof *out->curve); // each curve starts an arc of one or the other
    match *m = malloc((longest + 1) * sizeof *m);
    if (out->point == NULL || out->curve == NULL || m == NULL) {
        free(m);
        orr_curves_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory to compare stations");
    }
    double pooled = 0;
    for (size_t s = 0, u = 0; s < a->n_sats && u < b->n_sats;) {
        const orr_phase_sat *x = &a->sat[s], *y = &b->sat[u];
        if (x->sat != y->sat) {
            if (x->sat < y->sat)
                s++;
            else
                u++;
            continue;
        }
        s++;
        u++;
        size_t n = matches(x, y, match_s, m);
        for (size_t first = 0, last; first < n; first = last) {
            double ma = 0, mb = 0, sum = 0;
            for (last = first; last < n && x->arcs.arc_of[m[last].i] == x->arcs.arc_of[m[first].i] &&
                               y->arcs.arc_of[m[last].j] == y->arcs.arc_of[m[first].j];
                 last++) {
                ma += x->gf_tecu[m[last].i];
                mb += y->gf_tecu[m[last].j];
            }
            size_t count = last - first;
            if (count < min_samples || count < 2) continue;
            ma /= (double)count;
            mb /= (double)count;
            orr_curve *c = &out->curve[out->n_curves++];
            *c = (orr_curve){.sat = x->sat, .first = out->n_points, .n = count};
            for (size_t k = first; k < last; k++) {
                orr_curve_point p = {x->t[m[k].i], x->gf_tecu[m[k].i] - ma, y->gf_tecu[m[k].j] - mb};
                sum += (p.a_tecu - p.b_tecu) * (p.a_tecu - p.b_tecu);
                out->point[out->n_points++] = p;
            }
            c->rms_tecu = sqrt(sum / (double)count);
            pooled += sum;
        }
    }
    free(m);
    if (out->n_points == 0) {
        orr_curves_free(out);
        return orr_diag_set(diag, ORR_E_NODATA,
                            "%s and %s have no common arc of %zu epochs (same satellite, epochs within %g s)",
                            a->marker, b->marker, min_samples, match_s);
    }
    out->rms_tecu = sqrt(pooled / (double)out->n_points);
    return ORR_OK;
}

void orr_curves_free(orr_curves *c)
{
    free(c->curve);
    free(c->point);
    *c = (orr_curves){0};
}

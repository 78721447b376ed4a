// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "real_orbit.h"

bool real_open(const char *const *names, size_t n, real_files *f)
{
    *f = (real_files){0};
    for (size_t i = 0; i < n; i++) {
        char path[512];
        orr_diag d = {0};
        if (!orr_test_data(names[i], path, sizeof path)) {
            real_close(f);
            return false;
        }
        ASSERT_OK(orr_sp3_read(path, NULL, &f->sp3[i], NULL, &d), d);
        f->input[i].sp3 = &f->sp3[i];
        snprintf(f->input[i].name, sizeof f->input[i].name, "%s", names[i]);
        f->n++;
    }
    return true;
}

void real_close(real_files *f)
{
    for (size_t i = 0; i < f->n; i++) orr_sp3_free(&f->sp3[i]);
    f->n = 0;
}

void real_drop_midnight(real_files *f, size_t i)
{
    orr_sp3 *s = &f->sp3[i];
    if (s->n_epochs > 1 && s->epoch[s->n_epochs - 1] - s->epoch[0] == (orr_time)ORR_S_PER_DAY * ORR_NS_PER_S)
        s->n_epochs--;
}

const orr_orbit_sample *real_sample_at(const orr_orbit_sat *sat, orr_time t)
{
    for (size_t a = 0; a < sat->n_arcs; a++) {
        const orr_orbit_arc *arc = &sat->arc[a];
        double x = orr_time_diff_s(t, arc->t0) / arc->step_s, k = round(x);
        if (k >= 0 && k < (double)arc->n && fabs(x - k) < 1e-9) return &arc->sample[(size_t)k];
    }
    return NULL;
}

// Neighbouring used nodes of an instant; false if the instant is a node itself, or outside.
static bool between(const orr_orbit_sat *sat, orr_time t, orr_time *before, orr_time *after)
{
    *before = INT64_MIN, *after = INT64_MAX;
    for (size_t i = 0; i < sat->n_nodes; i++) {
        if (sat->node[i].t == t) return false;
        if (!sat->node[i].used) continue;
        if (sat->node[i].t < t) *before = sat->node[i].t;
        if (sat->node[i].t > t && *after == INT64_MAX) *after = sat->node[i].t;
    }
    return *before != INT64_MIN && *after != INT64_MAX;
}

real_stats real_judge(const orr_orbit_solution *s, const real_files *truth, char system, real_part part)
{
    real_stats st = {0};
    double sum = 0;
    for (size_t i = 0; i < s->n_sats; i++) {
        if (orr_sat_system(s->sat[i].sat) != system) continue;
        for (size_t f = 0; f < truth->n; f++) {
            const orr_sp3 *sp3 = &truth->sp3[f];
            size_t k = 0;
            while (k < sp3->n_sats && sp3->sat[k] != s->sat[i].sat) k++;
            if (k == sp3->n_sats) continue;
            for (size_t e = 0; e < sp3->n_epochs; e++) {
                const double *p = sp3->record[e * sp3->n_sats + k].pos_m;
                orr_time t = sp3->epoch[e], before, after;
                const orr_orbit_sample *q = real_sample_at(&s->sat[i], t);
                if (!isfinite(p[0]) || q == NULL || !between(&s->sat[i], t, &before, &after)) continue;
                double from = orr_time_diff_s(t, s->from), to = orr_time_diff_s(s->to, t);
                bool gap = orr_time_diff_s(after, before) > 2 * s->node_step_s + 1e-3;
                bool inner = !gap && from >= 7200 && to >= 7200, edge = !gap && (from <= 2700 || to <= 2700);
                if (part == REAL_GAP ? !gap : part == REAL_INNER ? !inner : !edge) continue;
                double d = orr_vec3_norm(orr_vec3_sub(q->pos_m, (orr_vec3){p[0], p[1], p[2]}));
                sum += d * d;
                st.n++;
                if (d > st.max_m) st.max_m = d;
            }
        }
    }
    st.rms_m = st.n > 0 ? sqrt(sum / (double)st.n) : (double)NAN;
    return st;
}

double real_distance(const orr_orbit_solution *a, const orr_orbit_solution *b, double margin_s, size_t *n)
{
    double largest = 0;
    *n = 0;
    for (size_t i = 0; i < a->n_sats; i++)
        for (size_t j = 0; j < b->n_sats; j++) {
            if (a->sat[i].sat != b->sat[j].sat) continue;
            for (size_t k = 0; k < a->sat[i].n_arcs; k++) {
                const orr_orbit_arc *arc = &a->sat[i].arc[k];
                for (size_t m = 0; m < arc->n; m++) {
                    orr_time t = orr_time_add_s(arc->t0, arc->step_s * (double)m);
                    if (orr_time_diff_s(t, a->from) < margin_s || orr_time_diff_s(a->to, t) < margin_s)
                        continue;
                    const orr_orbit_sample *q = real_sample_at(&b->sat[j], t);
                    if (q == NULL) continue;
                    double d = orr_vec3_norm(orr_vec3_sub(q->pos_m, arc->sample[m].pos_m));
                    if (d > largest) largest = d;
                    ++*n;
                }
            }
        }
    return largest;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/fusion/fusion.h"

#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "iono/fusion/fusion_private.h"

#define MAX_ROUNDS 4 // of fit and step test

const char *orr_fusion_method_name(orr_fusion_method m)
{
    return m == ORR_FUSION_THESIS ? "thesis" : "joint";
}

orr_fusion_options orr_fusion_default_options(void)
{
    return (orr_fusion_options){.method = ORR_FUSION_JOINT,
                                .knot_s = 3600,
                                .thin_s = 300,
                                .code_systems = "G",
                                .code_tecu = 1.5,
                                .step_test = true,
                                .arcs = orr_arc_default_options()};
}

void orr_fusion_free(orr_fusion *f, const orr_phase_tec *phase)
{
    if (f->model_vtec != NULL)
        for (size_t s = 0; s < phase->n_sats; s++) free(f->model_vtec[s]);
    free(f->model_vtec);
    free(f->mapping); // shares the blocks of model_vtec
    free(f->arc);
    free(f->group);
    free(f->correction.term);
    *f = (orr_fusion){0};
}

#define USUAL_PART                                                                                           \
    0.1 // of the content, where a field does not tell its RMS: what maps are wrong by in general

// Model value and mapping of every sample, and the field's own sigma over the station.
static orr_status model_samples(const orr_phase_tec *p, const orr_tec_field *field, orr_fusion *out,
                                orr_diag *diag)
{
    out->model_vtec = calloc(p->n_sats + 1, sizeof *out->model_vtec);
    out->mapping = calloc(p->n_sats + 1, sizeof *out->mapping);
    orr_tec_instant *at = malloc(sizeof *at);
    orr_status s = out->model_vtec != NULL && out->mapping != NULL && at != NULL
                       ? ORR_OK
                       : orr_diag_set(diag, ORR_E_MEMORY, "no memory for the model along the arcs");
    double rms = 0, with_rms = 0, content = 0, weights = 0;
    for (size_t k = 0; s == ORR_OK && k < p->n_sats; k++) {
        const orr_phase_sat *sat = &p->sat[k];
        double *v = malloc(2 * (sat->n + 1) * sizeof *v);
        if (v == NULL) {
            s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the model along the arcs");
            break;
        }
        out->model_vtec[k] = v;
        out->mapping[k] = v + sat->n;
        for (size_t i = 0; s == ORR_OK && i < sat->n; i++) {
            v[i] = v[sat->n + i] = ORR_NAN;
            if (sat->arcs.arc_of[i] < 0) continue;
            orr_tec_ray ray;
            s = orr_tec_field_at(field, sat->t[i], at, diag);
            if (s != ORR_OK) break;
            if (orr_tec_look_through(at, &p->site, &sat->pierce[i], &ray, NULL) != ORR_OK) {
                out->n_no_model++;
                continue;
            }
            v[i] = ray.vtec_tecu;
            v[sat->n + i] = ray.mapping;
            double w = 1 / (ray.mapping * ray.mapping);
            content += w * ray.vtec_tecu;
            weights += w;
            if (!(ray.sigma_tecu > 0)) continue;
            rms += w * ray.sigma_tecu / ray.mapping;
            with_rms += w;
        }
    }
    out->field_rms_assumed = !(with_rms > 0);
    out->field_rms_tecu = with_rms > 0 ? rms / with_rms : weights > 0 ? USUAL_PART * content / weights : 1;
    out->field_rms_tecu = fmax(out->field_rms_tecu, 0.5);
    free(at);
    return s;
}

static orr_status list_arcs(const orr_phase_tec *p, const orr_fusion_options *o, orr_fusion *out,
                            orr_diag *diag)
{
    size_t n = 0;
    for (size_t s = 0; s < p->n_sats; s++) n += p->sat[s].arcs.n_arcs;
    free(out->arc);
    out->arc = calloc(n + 1, sizeof *out->arc);
    if (out->arc == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for arcs");
    out->n_arcs = 0;
    for (size_t s = 0; s < p->n_sats; s++) {
        const orr_phase_sat *sat = &p->sat[s];
        for (size_t k = 0; k < sat->arcs.n_arcs; k++) {
            orr_fused_arc a = {.sat_index = s, .arc = k, .sat = sat->sat};
            double sum = 0;
            for (size_t i = SIZE_MAX; fusion_next_sample(sat, (int)k, 0, out->model_vtec[s], &i);) {
                if (a.n++ == 0) a.from = sat->t[i];
                a.to = sat->t[i];
                a.max_el_rad = fmax(a.max_el_rad, sat->pierce[i].el_rad);
                sum += sat->gf_tecu[i] - out->mapping[s][i] * out->model_vtec[s][i];
            }
            if (a.n < 2) continue;
            a.bias_tecu = sum / (double)a.n; // the source's method; a start for the joint one
            a.sigma_tecu = ORR_NAN;
            out->arc[out->n_arcs++] = a;
        }
    }
    if (out->n_arcs == 0)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "%s: no unbroken arc of %g minutes and more in the field's reach",
                            p->marker[0] ? p->marker : "station", o->arcs.min_span_s / 60);
    return ORR_OK;
}

static orr_status init_correction(const orr_phase_tec *p, const orr_tec_field *field,
                                  const orr_fusion_options *o, orr_correction *c, orr_diag *diag)
{
    orr_vec3 up = orr_vec3_unit(p->site.pos_m); // the pierce points' sphere is geocentric
    *c = (orr_correction){.t0 = p->from,
                          .knot_s = o->knot_s,
                          .up = up,
                          .scale = orr_tec_field_shell_radius_m(field) / 1e6,
                          .reach = 1.5};
    c->east = p->site.east;
    c->north = orr_vec3_cross(up, c->east);
    double n = ceil(orr_time_diff_s(p->to, p->from) / o->knot_s - 1e-9) + 1;
    if (!(n <= 10000)) return orr_diag_set(diag, ORR_E_LIMIT, "%g knots of the correction; take fewer", n);
    c->n = (size_t)n;
    c->term = calloc(c->n, sizeof *c->term);
    return c->term != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for the correction");
}

// Splits arc k of a satellite before sample `at`; parts too short are dropped.
static orr_status split(orr_phase_sat *sat, size_t k, size_t at, double step, const orr_arc_options *o,
                        orr_diag *diag)
{
    orr_arcs *a = &sat->arcs;
    orr_arc *arcs = realloc(a->arc, (a->n_arcs + 1) * sizeof *arcs);
    if (arcs != NULL) a->arc = arcs;
    if (arcs == NULL || !ORR_ARRAY_GROW(a->slip, a->n_slips))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory to split an arc");
    a->slip[a->n_slips++] = (orr_slip){.at = at,
                                       .causes = ORR_SLIP_STEP,
                                       .verdict = ORR_SLIP_BREAK,
                                       .gf_tecu = step,
                                       .gf_sigma_tecu = ORR_NAN,
                                       .mw_cyc = ORR_NAN,
                                       .mw_sigma_cyc = ORR_NAN};
    size_t fresh = a->n_arcs++, last = arcs[k].last;
    arcs[fresh] = (orr_arc){0};
    for (size_t i = at; i <= last; i++)
        if (a->arc_of[i] == (int)k) a->arc_of[i] = (int)fresh;
    for (int part = 0; part < 2; part++) {
        size_t id = part ? fresh : k, n = 0, from = part ? at : arcs[k].first, to = part ? last : at - 1;
        orr_arc out = {0};
        for (size_t i = from; i <= to; i++)
            if (a->arc_of[i] == (int)id) {
                if (n++ == 0) out.first = i;
                out.last = i;
            }
        out.n = n;
        arcs[id] = out;
        if (n >= o->min_samples && orr_time_diff_s(sat->t[out.last], sat->t[out.first]) >= o->min_span_s)
            continue;
        for (size_t i = from; i <= to; i++)
            if (a->arc_of[i] == (int)id) a->arc_of[i] = -1;
        a->n_dropped += n;
        arcs[id].n = 0;
        arcs[id].last =
            arcs[id].first; // an arc without samples stays in the list, so that the others keep their places
    }
    return ORR_OK;
}

static orr_status step_tests(orr_phase_tec *p, const orr_fusion_options *o, orr_fusion *f, size_t *found,
                             orr_diag *diag)
{
    size_t longest = 0;
    for (size_t a = 0; a < f->n_arcs; a++)
        if (f->arc[a].n > longest) longest = f->arc[a].n;
    double *t = malloc(2 * (longest + 1) * sizeof *t), *r = t != NULL ? t + longest + 1 : NULL;
    size_t *index = malloc((longest + 1) * sizeof *index);
    orr_status s = ORR_OK;
    if (t == NULL || index == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the step test");
    *found = 0;
    for (size_t a = 0; s == ORR_OK && a < f->n_arcs; a++) {
        const orr_fused_arc *arc = &f->arc[a];
        orr_phase_sat *sat = &p->sat[arc->sat_index];
        size_t n = 0, at;
        double step;
        for (size_t i = SIZE_MAX;
             fusion_next_sample(sat, (int)arc->arc, 0, f->model_vtec[arc->sat_index], &i);) {
            t[n] = orr_time_diff_s(sat->t[i], arc->from);
            r[n] = fusion_residual(p, f, arc, i);
            index[n++] = i;
        }
        if (!orr_arc_step(t, r, n, &o->arcs, &at, &step)) continue;
        s = split(sat, arc->arc, index[at], step, &o->arcs, diag);
        ++*found;
    }
    free(t);
    free(index);
    return s;
}

static double mean_mapping(const orr_phase_sat *sat, const orr_fusion *f, const orr_fused_arc *arc)
{
    double sum = 0;
    for (size_t i = SIZE_MAX; fusion_next_sample(sat, (int)arc->arc, 0, f->model_vtec[arc->sat_index], &i);)
        sum += f->mapping[arc->sat_index][i];
    return sum / (double)arc->n;
}

static void summarise(const orr_phase_tec *p, const orr_fusion_options *o, orr_fusion *f)
{
    double all = 0, plain = 0, sums[ORR_FUSION_BANDS] = {0};
    f->n_band = ORR_FUSION_BANDS;
    for (int b = 0; b < ORR_FUSION_BANDS; b++)
        f->band[b] = (orr_fusion_band){10 * b, 10 * (b + 1), 0, ORR_NAN};
    f->n_samples = 0;
    for (size_t a = 0; a < f->n_arcs; a++) {
        orr_fused_arc *arc = &f->arc[a];
        const orr_phase_sat *sat = &p->sat[arc->sat_index];
        double own = 0;
        for (size_t i = SIZE_MAX;
             fusion_next_sample(sat, (int)arc->arc, 0, f->model_vtec[arc->sat_index], &i);) {
            double r = fusion_residual(p, f, arc, i);
            double m = sat->gf_tecu[i] - arc->bias_tecu -
                       f->mapping[arc->sat_index][i] * f->model_vtec[arc->sat_index][i];
            int b = (int)(sat->pierce[i].el_rad * ORR_DEG_PER_RAD / 10);
            if (b > ORR_FUSION_BANDS - 1) b = ORR_FUSION_BANDS - 1;
            own += r * r;
            plain += m * m;
            sums[b] += r * r;
            f->band[b].n++;
            f->n_samples++;
        }
        all += own;
        arc->residual_tecu = sqrt(own / (double)arc->n);
        // Errors of a field that nothing corrects do not average out.
        if (f->method == ORR_FUSION_THESIS)
            arc->sigma_tecu = hypot(arc->residual_tecu, mean_mapping(sat, f, arc) * f->field_rms_tecu);
    }
    f->residual_tecu = sqrt(all / (double)f->n_samples);
    f->model_residual_tecu = sqrt(plain / (double)f->n_samples);
    for (int b = 0; b < ORR_FUSION_BANDS; b++)
        if (f->band[b].n > 0) f->band[b].rms_tecu = sqrt(sums[b] / (double)f->band[b].n);
    // Galileo's codes as an independent check: each group has its own receiver bias, which a mean takes out.
    double mean[64] = {0}, count[64] = {0}, square = 0;
    f->galileo_withheld = strchr(o->code_systems, 'E') == NULL || f->method == ORR_FUSION_THESIS;
    f->galileo_n = 0;
    for (int pass = 0; pass < 2; pass++)
        for (size_t a = 0; a < f->n_arcs; a++) {
            const orr_fused_arc *arc = &f->arc[a];
            if (orr_sat_system(arc->sat) != 'E' || isnan(arc->code_bias_tecu) || arc->group >= 64 ||
                orr_time_diff_s(arc->to, arc->from) < 7200)
                continue;
            double d = arc->bias_tecu - arc->code_bias_tecu;
            if (pass == 0) {
                mean[arc->group] += d;
                count[arc->group]++;
            } else {
                d -= mean[arc->group] / count[arc->group];
                square += d * d;
                f->galileo_n++;
            }
        }
    size_t groups = 0;
    for (int g = 0; g < 64; g++) groups += count[g] > 0;
    f->galileo_std_tecu = f->galileo_n > groups ? sqrt(square / (double)(f->galileo_n - groups)) : ORR_NAN;
}

static void use_codes(const orr_fusion_options *o, orr_fusion *f)
{
    for (size_t a = 0; a < f->n_arcs; a++)
        f->arc[a].code_used = !isnan(f->arc[a].code_bias_tecu) &&
                              strchr(o->code_systems, orr_sat_system(f->arc[a].sat)) != NULL;
}

// Arcs and their biases, until no residual shows a step.
static orr_status level(orr_phase_tec *phase, const orr_bias_set *biases, size_t n_biases,
                        const orr_fusion_options *o, orr_fusion *out, orr_diag *diag)
{
    for (int round = 0;; round++) {
        orr_status s = list_arcs(phase, o, out, diag);
        if (s == ORR_OK) s = fusion_level_codes(phase, biases, n_biases, o, out, diag);
        if (s == ORR_OK && o->method == ORR_FUSION_JOINT) {
            use_codes(o, out);
            s = fusion_solve(phase, o, out, diag);
        }
        size_t found = 0;
        if (s == ORR_OK && o->step_test && round + 1 < MAX_ROUNDS)
            s = step_tests(phase, o, out, &found, diag);
        if (s != ORR_OK || found == 0) return s;
    }
}

// A correction that does not help is none: biases are what codes and the field say, and no surer than the field.
static orr_status drop_correction(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *f,
                                  orr_diag *diag)
{
    const double level = f->model.level_tecu, none = 1e-6;
    f->fallback = ORR_FUSION_NO_GAIN;
    f->model.level_tecu = f->model.rms_tecu = none;
    orr_status s = fusion_solve(phase, o, f, diag);
    f->model.level_tecu = f->level_sigma_tecu = level;
    memset(f->correction.term, 0, f->correction.n * sizeof *f->correction.term);
    for (size_t a = 0; s == ORR_OK && a < f->n_arcs; a++) {
        orr_fused_arc *arc = &f->arc[a];
        arc->sigma_tecu = hypot(arc->sigma_tecu, level * mean_mapping(&phase->sat[arc->sat_index], f, arc));
    }
    for (size_t g = 0; g < f->n_groups; g++) f->group[g].sigma_tecu = hypot(f->group[g].sigma_tecu, level);
    f->left.corrected_tecu = f->left.plain_tecu;
    f->left.corrected_dstec_tecu = f->left.plain_dstec_tecu;
    for (int b = 0; b < ORR_FUSION_BANDS; b++) f->left.band[b].corrected_tecu = f->left.band[b].plain_tecu;
    return s;
}

// The statistics were chosen from the same arcs, as degrees of freedom that a plain covariance does not count.
static void widen(orr_fusion *f)
{
    double n = (double)f->n_arcs, factor = sqrt(n / fmax(n - FUSION_MODEL_UNKNOWNS, n / 2));
    for (size_t a = 0; a < f->n_arcs; a++) f->arc[a].sigma_tecu *= factor;
    for (size_t g = 0; g < f->n_groups; g++) f->group[g].sigma_tecu *= factor;
    f->level_sigma_tecu *= factor;
}

// The joint fit with statistics of the session's own, and what arcs left out say of it. Where they are worse with the
// correction than without, it is made weaker, and dropped in the end.
static orr_status joint(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *f,
                        orr_diag *diag)
{
    orr_status s = fusion_choose_model(phase, o, f, diag);
    for (int attempt = 0; s == ORR_OK && attempt < 3; attempt++) {
        s = fusion_solve(phase, o, f, diag);
        if (s == ORR_OK) s = fusion_leave_out(phase, o, f, diag);
        if (s != ORR_OK) return s;
        widen(f);
        if (!(f->left.corrected_tecu > f->left.plain_tecu)) return ORR_OK;
        f->model.level_tecu /= 2;
    }
    f->model.level_tecu *= 8; // as it was chosen
    return s == ORR_OK ? drop_correction(phase, o, f, diag) : s;
}

orr_status orr_fuse(orr_phase_tec *phase, const orr_tec_field *field, const orr_bias_set *biases,
                    size_t n_biases, const orr_fusion_options *options, orr_fusion *out, orr_diag *diag)
{
    *out = (orr_fusion){0};
    orr_fusion_options o = options != NULL ? *options : orr_fusion_default_options();
    if (!phase->has_geometry)
        return orr_diag_set(diag, ORR_E_ARG, "a fusion needs the satellites' positions: give an orbit");
    orr_status s = model_samples(phase, field, out, diag);
    out->model = fusion_usual_model(out->field_rms_tecu);
    if (s == ORR_OK && o.method == ORR_FUSION_JOINT)
        s = init_correction(phase, field, &o, &out->correction, diag);
    if (s == ORR_OK) s = level(phase, biases, n_biases, &o, out, diag);
    if (s == ORR_OK && o.method == ORR_FUSION_JOINT && out->n_arcs < 2) { // nothing to tell map from arc
        o.method = ORR_FUSION_THESIS;
        out->fallback = ORR_FUSION_TOO_FEW_ARCS;
        out->correction.n = 0;
        s = list_arcs(phase, &o, out, diag);
        if (s == ORR_OK) s = fusion_level_codes(phase, biases, n_biases, &o, out, diag);
    }
    out->method = o.method;
    if (s == ORR_OK && o.method == ORR_FUSION_JOINT) s = joint(phase, &o, out, diag);
    if (s != ORR_OK) {
        orr_fusion_free(out, phase);
        return s;
    }
    summarise(phase, &o, out);
    return ORR_OK;
}

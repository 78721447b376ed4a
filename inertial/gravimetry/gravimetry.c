// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/gravimetry/gravimetry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/astro.h"
#include "inertial/motion/uniform_spline.h"

void orr_gravimetry_result_free(orr_gravimetry_result *r)
{
    free(r->t_s);
    free(r->recovered_mgal);
    free(r->true_mgal);
    free(r->recovered_filtered_mgal);
    free(r->true_filtered_mgal);
    memset(r, 0, sizeof *r);
}

// Where the unit is and how it moves and stands, at edges of the readings: the truth, or a receiver's track.
typedef struct reference {
    const orr_imu *imu;
    const orr_gravimetry_track *track; // NULL: the truth
    orr_uspline place;                 // of the unit, ecef
    orr_nav_state attitude;            // of the readings alone, carried from edge to edge
    size_t first, last;                // spans of the truth that it covers
} reference;

static const orr_navigator REFERENCE = {.kind = ORR_NAVIGATOR_REFERENCE,
                                        .samples = ORR_NAVIGATOR_MAX_SAMPLES};

// Attitude at an edge at or after that of before. The free position runs away and is not used: in inertial axes attitude
// does not depend on it.
static orr_mat3 attitude_at(reference *ref, size_t edge)
{
    if (edge > ref->attitude.edge) orr_navigate_from(ref->imu, &REFERENCE, &ref->attitude, edge);
    return ref->attitude.A_bi;
}

// Inertial position and velocity of a point that the rotating Earth carries along.
static void to_inertial(double t_s, orr_vec3 r, orr_vec3 v, orr_vec3 *r_i, orr_vec3 *v_i)
{
    const orr_mat3 R = orr_inertial_from_ecef(t_s);
    *r_i = orr_mat3_apply(&R, r);
    *v_i = orr_mat3_apply(&R, orr_velocity_inertial(r, v));
}

static void state_at(reference *ref, size_t edge, orr_nav_state *s)
{
    s->edge = edge;
    s->t_s = orr_imu_edge_s(ref->imu, edge);
    if (ref->track == NULL) {
        orr_imu_true_state(ref->imu, edge, &s->r_m, &s->v_mps, &s->A_bi);
        return;
    }
    double r[3], v[3];
    orr_uspline_eval(&ref->place, s->t_s, r, v, NULL);
    to_inertial(s->t_s, (orr_vec3){r[0], r[1], r[2]}, (orr_vec3){v[0], v[1], v[2]}, &s->r_m, &s->v_mps);
    s->A_bi = attitude_at(ref, edge);
}

static void start_attitude(const orr_imu *imu, reference *ref)
{
    ref->attitude = (orr_nav_state){.edge = 0,
                                    .t_s = orr_imu_edge_s(imu, 0),
                                    .r_m = imu->start_r_m,
                                    .v_mps = imu->start_v_mps,
                                    .A_bi = orr_mat3_from_quat(imu->start_q_bi)};
}

// Samples of the track within the run, brought to the unit by its arm, under a quintic spline of the samples' own step.
static orr_status lay_track(const orr_imu *imu, const orr_gravimetry *truth, reference *ref, orr_diag *diag)
{
    const orr_gravimetry_track *t = ref->track;
    const double begin_s = orr_imu_edge_s(imu, 0), end_s = orr_imu_edge_s(imu, imu->n);
    size_t from = 0, to = t->n;
    while (from < to && t->t_s[from] < begin_s - 1e-6) from++;
    while (to > from && t->t_s[to - 1] > end_s + 1e-6) to--;
    if (to - from < 8)
        return orr_diag_set(diag, ORR_E_ARG, "the track has %zu places within the readings", to - from);
    const double step_s = (t->t_s[to - 1] - t->t_s[from]) / (double)(to - from - 1);
    orr_vec3 *place = malloc((to - from) * sizeof *place);
    if (place == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a track");
    start_attitude(imu, ref);
    for (size_t k = from; k < to; k++) {
        size_t edge = (size_t)fmax(floor((t->t_s[k] - begin_s) * imu->rate_hz + 0.5), 0);
        if (edge > imu->n) edge = imu->n;
        const orr_mat3 A = attitude_at(ref, edge), R = orr_inertial_from_ecef(t->t_s[k]);
        const orr_vec3 arm = orr_mat3_apply_t(&R, orr_mat3_apply_t(&A, t->arm_m));
        place[k - from] = orr_vec3_sub(t->r_m[k], arm);
    }
    _Static_assert(sizeof *place == 3 * sizeof(double), "places are three doubles each");
    const orr_status s = orr_uspline_fit(5, 3, t->t_s[from], step_s, to - from - 1, to - from, t->t_s + from,
                                         &place[0].x, NULL, 1e-9, &ref->place, diag);
    free(place);
    start_attitude(imu, ref); // again from the begin
    ref->first = (size_t)ceil((t->t_s[from] - begin_s) * imu->rate_hz / (double)truth->every - 1e-9);
    const double last = floor((t->t_s[to - 1] - begin_s) * imu->rate_hz / (double)truth->every + 1e-9);
    ref->last = (size_t)fmax(last, 0) < truth->n - 1 ? (size_t)fmax(last, 0) : truth->n - 1;
    return s;
}

// The disturbance of span k, between two edges of the truth.
static double recovered_mgal(reference *ref, size_t from, size_t to, double step_s)
{
    orr_nav_state s, end;
    state_at(ref, from, &s);
    orr_navigate_from(ref->imu, &REFERENCE, &s, to);
    state_at(ref, to, &end);
    const orr_mat3 R = orr_inertial_from_ecef(end.t_s);
    const orr_vec3 r = orr_mat3_apply_t(&R, end.r_m);
    const orr_geodetic at = orr_earth_from_ecef(r);
    const orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
    const orr_vec3 missing = orr_mat3_apply(&E, orr_mat3_apply_t(&R, orr_vec3_sub(end.v_mps, s.v_mps)));
    return -missing.z / step_s / ORR_MPS2_PER_MGAL;
}

// What is left of the filtered difference, inside and at the ends.
static void judge(orr_gravimetry_result *out, size_t margin)
{
    double sum = 0, edge = 0;
    for (size_t k = 0; k < out->n; k++) {
        const double e = out->recovered_filtered_mgal[k] - out->true_filtered_mgal[k];
        const bool inside = k >= margin && k + margin < out->n;
        *(inside ? &sum : &edge) += e * e;
        if (inside) out->filtered_max_mgal = fmax(out->filtered_max_mgal, fabs(e));
    }
    out->filtered_rms_mgal = sqrt(sum / (double)(out->n - 2 * margin));
    out->edge_rms_mgal = margin > 0 ? sqrt(edge / (double)(2 * margin)) : 0.0;
}

static orr_status recover(reference *ref, const orr_gravimetry *truth, const orr_gravity_filter *filter,
                          orr_gravimetry_result *out, orr_diag *diag)
{
    const orr_imu *imu = ref->imu;
    const double step_s = (double)truth->every / imu->rate_hz;
    const size_t n = ref->last > ref->first ? ref->last - ref->first : 0;
    out->edge_s = orr_gravity_filter_edge_s(filter);
    const double least_s = 2.0 * out->edge_s + 2.0 * step_s;
    if (!(filter->length_s > 0.0) || (double)n * step_s < least_s)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a filter of %g s needs a run of at least %g s; this one has %g s",
                            filter->length_s, least_s, (double)n * step_s);
    double **column[5] = {&out->t_s, &out->recovered_mgal, &out->true_mgal, &out->recovered_filtered_mgal,
                          &out->true_filtered_mgal};
    for (int k = 0; k < 5; k++)
        if ((*column[k] = malloc(n * sizeof(double))) == NULL) {
            orr_gravimetry_result_free(out);
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu values of gravity", n);
        }
    out->n = n;
    out->first = ref->first;
    double sum = 0.0;
    for (size_t k = 0; k < n; k++) {
        const size_t span = ref->first + k, from = span * truth->every, to = from + truth->every;
        out->recovered_mgal[k] = recovered_mgal(ref, from, to, step_s);
        out->t_s[k] = 0.5 * (orr_imu_edge_s(imu, from) + orr_imu_edge_s(imu, to));
        out->true_mgal[k] = 0.5 * (truth->disturbance_mgal[span] + truth->disturbance_mgal[span + 1]);
        double e = out->recovered_mgal[k] - out->true_mgal[k];
        sum += e * e;
    }
    out->raw_rms_mgal = sqrt(sum / (double)n);
    orr_status s =
        orr_gravity_filter_apply(filter, out->recovered_mgal, n, step_s, out->recovered_filtered_mgal, diag);
    if (s == ORR_OK)
        s = orr_gravity_filter_apply(filter, out->true_mgal, n, step_s, out->true_filtered_mgal, diag);
    if (s == ORR_OK) judge(out, (size_t)(out->edge_s / step_s));
    if (s != ORR_OK) orr_gravimetry_result_free(out);
    return s;
}

orr_status orr_gravimetry_recover(const orr_imu *imu, const orr_gravimetry *truth,
                                  const orr_gravimetry_track *track, const orr_gravity_filter *filter,
                                  orr_gravimetry_result *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (imu->mode.approach != 2)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "these readings are matched to a navigator (approach 1) and are no physical "
                            "force; make them with "
                            "approach 2");
    if (truth->every % imu->truth_every != 0)
        return orr_diag_set(diag, ORR_E_ARG,
                            "gravity at every %zu-th sample needs motion there, which is at every %zu-th",
                            truth->every, imu->truth_every);
    reference ref = {.imu = imu, .track = track, .first = 0, .last = truth->n - 1};
    orr_status s = track != NULL ? lay_track(imu, truth, &ref, diag) : ORR_OK;
    if (s == ORR_OK) s = recover(&ref, truth, filter, out, diag);
    orr_uspline_free(&ref.place);
    return s;
}

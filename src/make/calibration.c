// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/calibration.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEG ORR_RAD_PER_DEG

static orr_vec3 three(const orr_real_list *list, double unit)
{
    if (list->n != 3) return (orr_vec3){0, 0, 0};
    return (orr_vec3){list->item[0] * unit, list->item[1] * unit, list->item[2] * unit};
}

static orr_mat3 order_of(const orr_study_cycle *c)
{
    static const orr_mat3 along[3] = {{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
                                      {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                      {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}};
    const orr_vec3 t = three(&c->turned, DEG);
    const orr_mat3 R1 = orr_mat3_rot1(t.x), R2 = orr_mat3_rot2(t.y), R3 = orr_mat3_rot3(t.z);
    const orr_mat3 first = orr_mat3_mul(&R1, &along[c->along]), second = orr_mat3_mul(&R2, &first);
    return orr_mat3_mul(&R3, &second);
}

static const orr_study_profile *profile_of(const orr_study_calibration *s, size_t cycle)
{
    return s->cycles.item[cycle].has_profile ? &s->cycles.item[cycle].profile : &s->profile;
}

static orr_status take_cycles(const orr_study_calibration *s, orr_calibration_job *out, orr_diag *diag)
{
    const size_t n = s->cycles.n;
    out->cycle = calloc(n, sizeof *out->cycle);
    out->own_cycle = calloc(n, sizeof *out->own_cycle);
    size_t segments = 0, at = 0;
    for (size_t k = 0; k < n; k++) segments += profile_of(s, k)->segments.n;
    out->segment = calloc(segments + 1, sizeof *out->segment);
    if (out->cycle == NULL || out->own_cycle == NULL || out->segment == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu cycles", n);
    out->n_cycles = n;
    for (size_t k = 0; k < n; k++) {
        const orr_study_cycle *c = &s->cycles.item[k];
        const orr_study_profile *p = profile_of(s, k);
        orr_stand_segment *segment = out->segment + at;
        for (size_t i = 0; i < p->segments.n; i++, at++)
            segment[i] = (orr_stand_segment){(double)p->segments.item[i].for_ns * 1e-9,
                                             p->segments.item[i].rate_degps * DEG};
        out->cycle[k] = (orr_stand_cycle){.order = order_of(c),
                                          .mounting_rad = three(&c->mounting, DEG),
                                          .start_rad = c->start_deg * DEG,
                                          .outer_m = three(&c->offset, 1.0),
                                          .profile = {.n = p->segments.n,
                                                      .segment = segment,
                                                      .ripple = p->ripple,
                                                      .ripple_per_turn = p->ripple_per_turn}};
        const orr_status status = orr_stand_cycle_check(&out->cycle[k], diag);
        if (status != ORR_OK) return status;
    }
    return ORR_OK;
}

static void constants(const orr_triad_errors *e, double bias[3], orr_mat3 *M)
{
    for (int i = 0; i < 3; i++) {
        bias[i] = e->bias[i];
        for (int k = 0; k < 3; k++) M->m[i][k] = (1 + e->scale[i]) * (i == k ? 1.0 : e->cross[i][k]);
    }
}

static bool beyond(const orr_triad_errors *e)
{
    double sum = e->bias_sigma + e->scale_sigma + e->cross_sigma + (double)e->n_processes + e->bandwidth_hz +
                 e->quantum;
    for (int i = 0; i < 3; i++)
        sum += fabs(e->walk[i]) + fabs(e->ramp[i]) + fabs(e->asymmetry[i]) + fabs(e->quadratic[i]) +
               fabs(e->cubic[i]) + fabs(e->by_force[i][0]) + fabs(e->by_force[i][1]) +
               fabs(e->by_force[i][2]) + fabs(e->by_force_squared[i]) + fabs(e->rectification[i]) +
               fabs(e->by_temperature[i]) + fabs(e->by_temperature_squared[i]) +
               fabs(e->by_temperature_rate[i]) + fabs(e->scale_by_temperature[i]);
    return sum > 0;
}

static double mean_of(const double v[3]) { return (v[0] + v[1] + v[2]) / 3; }

static orr_status take_sensors(const orr_study_calibration *s, orr_inputs *inputs, orr_calibration_job *out,
                               orr_diag *diag)
{
    orr_calibration_truth *t = &out->truth;
    for (size_t k = 0; k + 2 < s->arms.n; k += 3)
        out->inner_m[k / 3] = orr_vec3_make(s->arms.item[k], s->arms.item[k + 1], s->arms.item[k + 2]);
    t->accel = t->gyro = orr_mat3_identity();
    if (s->errors != NULL) {
        const orr_status status = orr_errors_open(inputs, s->errors, &out->file, &out->errors, diag);
        if (status != ORR_OK) return status;
        out->has_errors = true;
        orr_triad_errors *a = &out->errors.accel;
        for (int i = 0; i < 3; i++) {
            const orr_vec3 arm = {a->arm_m[i][0], a->arm_m[i][1], a->arm_m[i][2]};
            out->inner_m[i] = orr_vec3_add(out->inner_m[i], arm);
        }
        memset(a->arm_m, 0, sizeof a->arm_m); // they have gravity of their own here
        constants(a, t->accel_bias_mps2, &t->accel);
        constants(&out->errors.gyro, t->gyro_bias_radps, &t->gyro);
        out->more =
            beyond(a) || beyond(&out->errors.gyro) || out->errors.delay_s > 0 || out->errors.jitter_s > 0;
    }
    memcpy(t->inner_m, out->inner_m, sizeof t->inner_m);
    orr_mat3 R;
    const orr_status status = orr_calibration_own_axes(t, &R, diag);
    if (status != ORR_OK) return status;
    for (size_t k = 0; k < out->n_cycles; k++) {
        orr_stand_cycle *c = &out->own_cycle[k];
        *c = out->cycle[k];
        const orr_mat3 alpha = orr_mat3_from_rotvec(c->mounting_rad), turned = orr_mat3_mul(&R, &alpha);
        c->mounting_rad = orr_rotvec_from_mat3(&turned);
        c->outer_m = orr_mat3_apply(&R, c->outer_m);
    }
    return ORR_OK;
}

orr_status orr_calibration_open(const orr_study_calibration *study, orr_inputs *inputs,
                                orr_calibration_job *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    const orr_study_stand *q = &study->stand;
    const orr_stand_setup setup = {.place = {q->lat_deg * DEG, q->lon_deg * DEG, q->height_m},
                                   .azimuth_rad = q->azimuth_deg * DEG,
                                   .elevation_rad = q->elevation_deg * DEG,
                                   .literal_mounting = q->literal_mounting,
                                   .literal_forces = q->literal_forces};
    orr_status s = orr_stand_prepare(&setup, &out->stand, diag);
    if (s == ORR_OK) s = take_cycles(study, out, diag);
    if (s == ORR_OK) s = take_sensors(study, inputs, out, diag);
    if (s != ORR_OK) return s;
    const double gyro = mean_of(out->errors.gyro.white), accel = mean_of(out->errors.accel.white);
    out->plan = (orr_calibration_plan){
        .stand = &out->stand,
        .n_cycles = out->n_cycles,
        .cycle = out->own_cycle,
        .block_s = (double)study->block_ns * 1e-9,
        .arms = study->solve_arms,
        .offsets_known = study->offsets_known,
        .gyro_white_radps_s = gyro > 0 ? gyro : 1e-6, // 0.0034 deg/sqrt(h), where readings have none
        .accel_white_mps2_s = accel > 0 ? accel : 1e-4,
    };
    for (size_t k = 0; k < out->n_cycles; k++)
        out->plan.along_m[k] = orr_calibration_along(&out->own_cycle[k], &out->truth) + study->along_error_m;
    return ORR_OK;
}

void orr_calibration_job_free(orr_calibration_job *job)
{
    free(job->segment);
    free(job->cycle);
    free(job->own_cycle);
    if (job->has_errors) orr_sensor_errors_free(&job->file);
    memset(job, 0, sizeof *job);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// orrery crossovers: a gravimetry survey with errors, judged by its crossovers as crews do.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/rng.h"
#include "inertial/gravimetry/crossovers.h"
#include "inertial/gravimetry/gravimetry.h"
#include "inertial/motion/local_map.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/study.h"
#include "src/config/study_crossovers.h"

#define ARCSEC (ORR_RAD_PER_DEG / 3600.0)
// Streams of random numbers, beyond those of the sensors.
enum { STREAM_WHITE = 2000, STREAM_WANDER = 2010, STREAM_START = 2020 };

enum { SEED, CROSSOVERS, RMS, LINE, LEVELLED, LEVELLED_LINE, TRUTH, TRUTH_LEVELLED, EDGE, COLUMNS };
static const orr_study_column column[COLUMNS] = {
    {"seed", NULL, "of the errors", NULL},
    {"crossovers", NULL, "how many", NULL},
    {"rms_mgal", "mGal", "r.m.s. of the differences at crossovers", NULL},
    {"line_mgal", "mGal", "that over sqrt 2: the error of a line", NULL},
    {"levelled_rms_mgal", "mGal", "of the differences after levelling, for the freedom that it takes", NULL},
    {"levelled_line_mgal", "mGal", "that over sqrt 2", NULL},
    {"error_mgal", "mGal", "r.m.s. of found less true gravity along lines about its mean", NULL},
    {"levelled_error_mgal", "mGal", "the same after levelling", NULL},
    {"edge_mgal", "mGal", "r.m.s. of found less true gravity within the filter's reach of the flight's ends",
     NULL},
};

typedef struct work {
    const orr_study_crossovers *study;
    orr_study_motion motion;
    orr_readings readings;
    orr_sensor_errors file;
    orr_imu_errors errors;
    orr_gravity_filter filter;
    double *track_s, *east_m, *north_m;
    orr_vec3 *track_m;
    size_t n_track, every; // of the readings, from one place to the next
    double ideal_rms_mgal, ideal_max_mgal, least_g, greatest_g;
    double *table; // [seeds][COLUMNS]
    orr_gravimetry_result last;
    orr_survey_line line[ORR_SURVEY_MOST_LINES];
    size_t n_lines, n_crossovers;
    orr_crossover *crossover; // of the last seed
} work;

static orr_gravity_filter filter_of(const orr_study_filter *f)
{
    static const orr_gravity_filter_kind kind[] = {[ORR_FILTER_GAUSSIAN] = ORR_GRAVITY_GAUSSIAN,
                                                   [ORR_FILTER_FIR] = ORR_GRAVITY_FIR,
                                                   [ORR_FILTER_KALMAN] = ORR_GRAVITY_KALMAN};
    return (orr_gravity_filter){kind[f->kind], (double)f->length_ns * 1e-9, f->model_mgal, f->height_m};
}

// The flight's ideal readings and truth, its places on a plane, and what ideal readings on the true motion leave.
static orr_status fly(work *w, orr_diag *diag)
{
    const orr_readings_plan plan = orr_readings_plan_of(&w->motion.moving);
    orr_status s = orr_readings_make(&plan, &w->readings, diag);
    if (s != ORR_OK) return s;
    const orr_imu *imu = &w->readings.imu;
    const orr_gravimetry *g = &w->readings.truth;
    s = orr_gravimetry_recover(imu, g, NULL, &w->filter, &w->last, diag);
    if (s != ORR_OK) return s;
    w->ideal_rms_mgal = w->last.filtered_rms_mgal;
    w->ideal_max_mgal = w->last.filtered_max_mgal;
    orr_gravimetry_result_free(&w->last);
    w->every = (size_t)fmax(1.0, nearbyint(imu->rate_hz / w->study->receiver.rate_hz));
    w->n_track = imu->n / w->every + 1;
    w->track_s = malloc(w->n_track * sizeof *w->track_s);
    w->track_m = malloc(w->n_track * sizeof *w->track_m);
    w->east_m = malloc(g->n * sizeof *w->east_m);
    w->north_m = malloc(g->n * sizeof *w->north_m);
    if (w->track_s == NULL || w->track_m == NULL || w->east_m == NULL || w->north_m == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a track of %zu places", w->n_track);
    const orr_local_map map = orr_local_map_make(orr_earth_from_ecef(imu->r_m[0]));
    w->least_g = w->greatest_g = 1;
    for (size_t k = 0; k < g->n; k++) {
        const orr_vec3 at = orr_local_map_from_ecef(&map, imu->r_m[k * g->every / imu->truth_every]);
        w->east_m[k] = at.x;
        w->north_m[k] = at.y;
        w->least_g = fmin(w->least_g, 1 + g->vertical_mps2[k] / 9.80665);
        w->greatest_g = fmax(w->greatest_g, 1 + g->vertical_mps2[k] / 9.80665);
    }
    return ORR_OK;
}

// Errors of the receiver's places: white, and Gauss-Markov.
static void make_track(work *w, uint64_t seed)
{
    const orr_imu *imu = &w->readings.imu;
    const orr_study_receiver *q = &w->study->receiver;
    const double keep = exp(-(double)w->every / imu->rate_hz / q->wander_s), renew = sqrt(1 - keep * keep);
    double wander[3];
    for (uint64_t i = 0; i < 3; i++) wander[i] = q->wander_m * orr_rng_normal(seed, STREAM_WANDER + i, 0);
    for (size_t k = 0; k < w->n_track; k++) {
        double e[3];
        for (uint64_t i = 0; i < 3; i++) {
            if (k > 0)
                wander[i] =
                    keep * wander[i] + renew * q->wander_m * orr_rng_normal(seed, STREAM_WANDER + i, k);
            e[i] = wander[i] + q->white_m * orr_rng_normal(seed, STREAM_WHITE + i, k);
        }
        const orr_vec3 r = imu->r_m[k * w->every / imu->truth_every];
        const orr_geodetic at = orr_earth_from_ecef(r);
        const orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
        w->track_s[k] = orr_imu_edge_s(imu, k * w->every);
        w->track_m[k] = orr_vec3_add(r, orr_mat3_apply_t(&E, (orr_vec3){e[0], e[1], e[2]}));
    }
}

// The start attitude turned by errors of alignment about East, North and Up.
static orr_quat misaligned(const work *w, uint64_t seed)
{
    const orr_imu *imu = &w->readings.imu;
    const orr_study_start *q = &w->study->alignment;
    const orr_geodetic at = orr_earth_from_ecef(imu->r_m[0]);
    const orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad),
                   R = orr_inertial_from_ecef(imu->begin_s);
    const orr_vec3 enu = {q->tilt_arcsec * ARCSEC * orr_rng_normal(seed, STREAM_START, 0),
                          q->tilt_arcsec * ARCSEC * orr_rng_normal(seed, STREAM_START, 1),
                          q->heading_arcsec * ARCSEC * orr_rng_normal(seed, STREAM_START, 2)};
    const orr_vec3 turn = orr_mat3_apply(&R, orr_mat3_apply_t(&E, enu));
    return orr_quat_mul(orr_quat_from_rotvec(turn), imu->start_q_bi);
}

// Errors along lines against the truth, about their mean over all; with what levelling takes off.
static double line_error(const work *w, bool levelled)
{
    double sum = 0, mean = 0;
    size_t n = 0;
    for (int pass = 0; pass < 2; pass++)
        for (size_t l = 0; l < w->n_lines; l++)
            for (size_t k = w->line[l].from; k < w->line[l].to; k++) {
                const double e = w->last.recovered_filtered_mgal[k] - w->last.true_filtered_mgal[k] -
                                 (levelled ? w->line[l].level_mgal : 0);
                if (pass == 0)
                    mean += e, n++;
                else
                    sum += (e - mean / (double)n) * (e - mean / (double)n);
            }
    return sqrt(sum / (double)n);
}

static orr_status survey(work *w, uint64_t seed, double *row, orr_diag *diag)
{
    orr_imu *imu = &w->readings.imu;
    const orr_quat start = imu->start_q_bi;
    w->errors.seed = seed;
    orr_status s = orr_imu_add_errors(&w->errors, imu, NULL, diag);
    if (s != ORR_OK) return s;
    make_track(w, seed);
    const orr_gravimetry_track track = {.n = w->n_track, .t_s = w->track_s, .r_m = w->track_m};
    imu->start_q_bi = misaligned(w, seed);
    orr_imu_swap_measured(imu);
    orr_gravimetry_result_free(&w->last);
    s = orr_gravimetry_recover(imu, &w->readings.truth, &track, &w->filter, &w->last, diag);
    orr_imu_swap_measured(imu);
    imu->start_q_bi = start;
    if (s != ORR_OK) return s;
    const orr_study_lines *q = &w->study->lines;
    const orr_survey_series series = {.n = w->last.n,
                                      .step_s = (double)w->readings.truth.every / imu->rate_hz,
                                      .east_m = w->east_m + w->last.first,
                                      .north_m = w->north_m + w->last.first,
                                      .mgal = w->last.recovered_filtered_mgal};
    s = orr_survey_lines(&series, q->turn_degps * ORR_RAD_PER_DEG, (double)q->least_ns * 1e-9,
                         (double)q->margin_ns * 1e-9, w->line, &w->n_lines, diag);
    if (s != ORR_OK) return s;
    free(w->crossover);
    orr_crossover_report r;
    s = orr_crossovers(&series, w->line, w->n_lines, &w->crossover, &r, diag);
    if (s != ORR_OK) return s;
    w->n_crossovers = r.n;
    const double v[COLUMNS] = {(double)seed,           (double)r.n,         r.rms_mgal,
                               r.rms_mgal / sqrt(2.0), r.levelled_rms_mgal, r.levelled_rms_mgal / sqrt(2.0),
                               line_error(w, false),   line_error(w, true), w->last.edge_rms_mgal};
    memcpy(row, v, sizeof v);
    return ORR_OK;
}

static double mean_of(const work *w, int c)
{
    double sum = 0;
    for (int64_t k = 0; k < w->study->seeds; k++) sum += w->table[(size_t)k * COLUMNS + (size_t)c];
    return sum / (double)w->study->seeds;
}

static int report(const orr_cli *c, const work *w)
{
    if (orr_cli_says(c, "format", "json")) {
        json_t *j = json_pack("{s:o, s:o, s:o, s:o}", "ideal_rms_mgal", orr_json_number(w->ideal_rms_mgal),
                              "ideal_max_mgal", orr_json_number(w->ideal_max_mgal), "greatest_g",
                              orr_json_number(w->greatest_g), "lines", orr_json_count(w->n_lines));
        for (int k = CROSSOVERS; k < COLUMNS; k++)
            json_object_set_new(j, column[k].name, orr_json_number(mean_of(w, k)));
        return orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    }
    if (orr_study_to_stdout(c)) return ORR_EXIT_OK;
    printf("flight                  %.0f s, %.2f to %.2f g, %zu lines, %zu crossovers\n",
           (double)w->readings.imu.n / w->readings.imu.rate_hz, w->least_g, w->greatest_g, w->n_lines,
           w->n_crossovers);
    printf("ideal readings          %.2g mGal r.m.s., %.2g mGal at most\n", w->ideal_rms_mgal,
           w->ideal_max_mgal);
    printf("mean of %lld flights with errors, mGal     as flown   levelled\n", (long long)w->study->seeds);
    printf("r.m.s. of differences at crossovers    %9.3f  %9.3f\n", mean_of(w, RMS), mean_of(w, LEVELLED));
    printf("over sqrt 2, the error of a line       %9.3f  %9.3f\n", mean_of(w, LINE),
           mean_of(w, LEVELLED_LINE));
    printf("against the truth along lines          %9.3f  %9.3f\n", mean_of(w, TRUTH),
           mean_of(w, TRUTH_LEVELLED));
    printf("at the flight's ends, %g s each       %9.3f\n", w->last.edge_s, mean_of(w, EDGE));
    return ORR_EXIT_OK;
}

static orr_status draw(const orr_cli *c, const char *title, const work *w, orr_diag *diag)
{
    const orr_plot_line line[] = {
        {.label = "true", .x = w->last.t_s, .y = w->last.true_filtered_mgal, .n = w->last.n, .dash = 1},
        {.label = "found",
         .x = w->last.t_s,
         .y = w->last.recovered_filtered_mgal,
         .n = w->last.n,
         .colour = 1}};
    const orr_plot plot = {.title = title,
                           .x_label = "time, s",
                           .y_label = "gravity disturbance after the filter, mGal",
                           .line = line,
                           .n = 2};
    return orr_study_plot(c, &plot, diag);
}

static orr_status write_tables(const orr_cli *c, const char *title, const work *w, const orr_inputs *inputs,
                               orr_diag *diag)
{
    enum { WIDTH = 6 };
    static const orr_study_column of_crossover[WIDTH] = {{"line_a", NULL, "from 1", NULL},
                                                         {"line_b", NULL, "from 1", NULL},
                                                         {"time_a_s", "s", "of the crossing", NULL},
                                                         {"time_b_s", "s", "of the crossing", NULL},
                                                         {"difference_mgal", "mGal", "a less b", NULL},
                                                         {"levelled_mgal", "mGal", "after levelling", NULL}};
    double *v = malloc((w->n_crossovers + 1) * WIDTH * sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for crossovers");
    const double step = (double)w->readings.truth.every / w->readings.imu.rate_hz;
    for (size_t k = 0; k < w->n_crossovers; k++) {
        const orr_crossover *x = &w->crossover[k];
        const double row[WIDTH] = {(double)x->a + 1,
                                   (double)x->b + 1,
                                   w->last.t_s[0] + x->at_a * step,
                                   w->last.t_s[0] + x->at_b * step,
                                   x->difference_mgal,
                                   x->levelled_mgal};
        memcpy(&v[k * WIDTH], row, sizeof row);
    }
    const orr_study_table table[] = {{"flight", column, COLUMNS, (size_t)w->study->seeds, w->table},
                                     {"crossover", of_crossover, WIDTH, w->n_crossovers, v}};
    const orr_status s = orr_study_write(c, title, inputs, table, 2, diag);
    free(v);
    return s;
}

static void clear(work *w)
{
    free(w->table);
    free(w->track_s);
    free(w->track_m);
    free(w->east_m);
    free(w->north_m);
    free(w->crossover);
    orr_gravimetry_result_free(&w->last);
    orr_readings_free(&w->readings);
    orr_sensor_errors_free(&w->file);
    orr_study_motion_free(&w->motion);
    free(w);
}

static int make(orr_cli *c, const orr_study_crossovers *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    work *w = calloc(1, sizeof *w);
    if (w == NULL) return orr_cli_failf(c, "no memory");
    w->study = study;
    w->filter = filter_of(&study->filter);
    const char *title = study->head.title != NULL ? study->head.title : "Crossovers of a gravimetry survey";
    w->table = calloc((size_t)study->seeds, COLUMNS * sizeof *w->table);
    orr_status s = w->table != NULL ? ORR_OK : orr_diag_set(&diag, ORR_E_MEMORY, "no memory for seeds");
    if (s == ORR_OK)
        s = orr_study_motion_open(inputs, study->scenario, study->duration_ns, &w->motion, &diag);
    if (s == ORR_OK) s = orr_errors_open(inputs, study->errors, &w->file, &w->errors, &diag);
    if (s == ORR_OK) s = fly(w, &diag);
    for (int64_t k = 0; k < study->seeds && s == ORR_OK; k++) {
        orr_cli_progress(c, "flights", (size_t)k, (size_t)study->seeds);
        s = survey(w, (uint64_t)(study->head.seed + k), &w->table[(size_t)k * COLUMNS], &diag);
    }
    orr_cli_progress(c, "flights", 1, 1);
    if (s == ORR_OK) s = write_tables(c, title, w, inputs, &diag);
    if (s == ORR_OK) s = draw(c, title, w, &diag);
    const int status = s == ORR_OK ? report(c, w) : orr_cli_fail(c, &diag);
    clear(w);
    return status;
}

static int run(orr_cli *c)
{
    orr_study_crossovers study;
    orr_inputs inputs = {0};
    bool go;
    int status = orr_cli_study_open(c, &orr_study_crossovers_schema, &study, &inputs, &go);
    if (!go) return status;
    status = make(c, &study, &inputs);
    orr_schema_free(&orr_study_crossovers_schema, &study);
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {ORR_STUDY_OPTIONS};

const orr_command orr_cmd_crossovers = {
    .name = "crossovers",
    .group = "Inertial studies",
    .summary = "a gravimetry survey judged by the crossovers of its lines",
    .operands = "STUDY.yaml",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Flies a scenario's survey with errors of sensors, of the attitude at the begin and of a "
             "satellite receiver's "
             "track, recovers gravity through a filter, and finds the differences where lines cross, before "
             "and after "
             "levelling by a constant a line: the statistics that campaigns report. The filter's ends and "
             "what ideal readings "
             "leave are told.",
    .example = "orrery crossovers samples/studies/crossovers.yaml -o crossovers.csv --plot gravity.svg",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

// SPDX-License-Identifier: GPL-3.0-or-later
// orrery vibration: attitude algorithms under vibration during alignment.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/sensors.h"
#include "inertial/study/vibration.h"
#include "inertial/study/vibration_broadband.h"
#include "inertial/study/vibration_motion.h"
#include "src/cli/frame/json.h"
#include "src/cli/study/study.h"
#include "src/config/study_vibration.h"
#include "src/make/spectrum.h"

enum { MOST_METHODS = 32, MOST_CROSSINGS = 1000, SHOWN_POINTS = 24 };

enum {
    METHOD,
    PRODUCT,
    RATIO,
    FREQUENCY,
    AMPLITUDE,
    NORMALISED,
    SECOND_ORDER,
    HEADING,
    TILT,
    SCULLING,
    COLUMNS
};

typedef struct job {
    const orr_study_vibration *study;
    orr_attitude_method method[MOST_METHODS];
    const char *name[MOST_METHODS + 1];
    size_t n_methods, n_ratios, n; // n rows
    double *ratio;                 // [n_ratios] ascending
    double *table;                 // [n][COLUMNS]: by product, method, ratio
    orr_vibration_crossing crossing[MOST_CROSSINGS];
    size_t n_crossings;
    orr_spectrum_table spectrum; // density in (rad/s)^2/Hz
    double drift_radps, by_response[MOST_METHODS], by_runs[MOST_METHODS];
} job;

static double *row_of(const job *j, size_t product, size_t method, size_t ratio)
{
    return &j->table[((product * j->n_methods + method) * j->n_ratios + ratio) * COLUMNS];
}

// The built-in methods that the study asks for by name; "all" alone is all of them.
static size_t names_of_builtin(const orr_study_vibration *s, const char *name[MOST_METHODS])
{
    static const char *const usual[] = {"1-step", "2-step", "4-step"};
    const bool all = s->methods.n == 1 && strcmp(s->methods.item[0], "all") == 0;
    size_t n = 0;
    if (s->methods.n + s->own.n == 0)
        for (; n < 3; n++) name[n] = usual[n];
    else if (all)
        for (; n < MOST_METHODS && orr_attitude_method_name(n) != NULL; n++)
            name[n] = orr_attitude_method_name(n);
    else
        for (; n < s->methods.n && n < MOST_METHODS; n++) name[n] = s->methods.item[n];
    return n;
}

static orr_status gather_methods(job *j, orr_diag *diag)
{
    const orr_study_vibration *s = j->study;
    const char *name[MOST_METHODS];
    const size_t n = names_of_builtin(s, name), wanted = s->methods.n > n ? s->methods.n : n;
    if (wanted + s->own.n > MOST_METHODS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu methods; at most %d can be", wanted + s->own.n,
                            (int)MOST_METHODS);
    for (size_t k = 0; k < n; k++) {
        const orr_status status = orr_attitude_method_builtin(name[k], &j->method[j->n_methods++], diag);
        if (status != ORR_OK) return status;
    }
    for (size_t k = 0; k < s->own.n; k++) {
        const orr_study_method *m = &s->own.item[k];
        const orr_status status =
            orr_attitude_method_make(m->name, (int)m->samples, m->coefficients.item, m->coefficients.n,
                                     &j->method[j->n_methods++], diag);
        if (status != ORR_OK) return status;
    }
    for (size_t k = 0; k < j->n_methods; k++) {
        j->name[k] = j->method[k].name;
        for (size_t i = 0; i < k; i++)
            if (strcmp(j->name[i], j->name[k]) == 0)
                return orr_diag_set(diag, ORR_E_ARG, "there are two methods \"%s\"", j->name[k]);
    }
    return ORR_OK;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static orr_status gather_ratios(job *j, orr_diag *diag)
{
    const orr_study_ratios *r = &j->study->ratios;
    const size_t points = (size_t)r->points;
    j->ratio = malloc((points + r->also.n) * sizeof *j->ratio);
    if (j->ratio == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu ratios", points);
    for (size_t k = 0; k < points; k++)
        j->ratio[k] = r->low * pow(r->high / r->low, (double)k / (double)(points - 1));
    for (size_t k = 0; k < r->also.n; k++) j->ratio[points + k] = r->also.item[k];
    j->n_ratios = points + r->also.n;
    qsort(j->ratio, j->n_ratios, sizeof *j->ratio, by_value);
    return ORR_OK;
}

static orr_vibration_study study_of(const orr_study_vibration *s, double product)
{
    const orr_study_place *p = &s->rest;
    return (orr_vibration_study){.readings_hz = s->readings_hz,
                                 .product_hz = product,
                                 .duration_s = (double)s->duration_ns * 1e-9,
                                 .earth = s->has_rest,
                                 .lat_rad = p->lat_deg * ORR_RAD_PER_DEG,
                                 .attitude = {p->heading_deg * ORR_RAD_PER_DEG,
                                              p->pitch_deg * ORR_RAD_PER_DEG, p->roll_deg * ORR_RAD_PER_DEG}};
}

static orr_status sweep(const orr_cli *c, job *j, orr_diag *diag)
{
    const orr_study_vibration *s = j->study;
    j->n = s->products.n * j->n_methods * j->n_ratios;
    j->table = calloc(j->n, COLUMNS * sizeof *j->table);
    if (j->table == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu errors", j->n);
    for (size_t p = 0; p < s->products.n; p++)
        for (size_t m = 0; m < j->n_methods; m++) {
            const orr_vibration_study study = study_of(s, s->products.item[p]);
            orr_cli_progress(c, "sweeps", p * j->n_methods + m, s->products.n * j->n_methods);
            for (size_t k = 0; k < j->n_ratios; k++) {
                orr_vibration_error e;
                double sculling;
                orr_status status = orr_vibration_error_of(&study, &j->method[m], j->ratio[k], &e, diag);
                if (status == ORR_OK)
                    status = orr_sculling_error_of(&study, &j->method[m], j->ratio[k], &sculling, diag);
                if (status != ORR_OK) return status;
                const double row[COLUMNS] = {(double)m,
                                             study.product_hz,
                                             j->ratio[k],
                                             j->ratio[k] * s->readings_hz,
                                             e.amplitude_rad * ORR_DEG_PER_RAD * 3600.0,
                                             e.normalised,
                                             orr_attitude_method_response(&j->method[m], j->ratio[k]),
                                             e.heading_rad / e.duration_s * ORR_DEG_PER_RAD * 3600.0,
                                             e.tilt_rad * ORR_DEG_PER_RAD * 3600.0,
                                             sculling};
                memcpy(row_of(j, p, m, k), row, sizeof row);
            }
        }
    orr_cli_progress(c, "sweeps", 1, 1);
    j->n_crossings = orr_vibration_crossings(j->method, j->n_methods, s->ratios.low, s->ratios.high,
                                             j->crossing, MOST_CROSSINGS);
    return ORR_OK;
}

static orr_status broadband(job *j, orr_inputs *inputs, orr_diag *diag)
{
    const orr_study_spectrum *s = &j->study->spectrum;
    if (!j->study->has_spectrum) return ORR_OK;
    orr_status status = orr_spectrum_read(inputs, s->file, &j->spectrum, diag);
    if (status != ORR_OK) return status;
    for (size_t k = 0; k < j->spectrum.n; k++) j->spectrum.density[k] *= ORR_RAD_PER_DEG * ORR_RAD_PER_DEG;
    const orr_vibration_psd p = {j->spectrum.n, j->spectrum.frequency_hz, j->spectrum.density, s->coherence};
    status = orr_vibration_psd_check(&p, diag);
    if (status != ORR_OK) return status;
    j->drift_radps = orr_vibration_psd_drift(&p);
    for (size_t m = 0; m < j->n_methods; m++)
        j->by_response[m] = orr_vibration_psd_error(&p, &j->method[m], j->study->readings_hz);
    for (int64_t k = 0; k < s->runs && status == ORR_OK; k++) {
        double one[MOST_METHODS];
        status =
            orr_vibration_psd_run(&p, j->method, j->n_methods, j->study->readings_hz,
                                  (double)s->run_ns * 1e-9, (uint64_t)(j->study->head.seed + k), one, diag);
        for (size_t m = 0; status == ORR_OK && m < j->n_methods; m++)
            j->by_runs[m] += one[m] / (double)s->runs;
    }
    return status;
}

// --- What comes out ---

static void print_header(const job *j)
{
    printf("%10s", "f_v/f_m");
    for (size_t m = 0; m < j->n_methods; m++) printf(" %13s", j->name[m]);
    printf("\n");
}

// The ratios that the file names besides, and some of the others.
static bool shown(const job *j, size_t k, size_t every)
{
    if (k % every == 0 || k + 1 == j->n_ratios) return true;
    for (size_t i = 0; i < j->study->ratios.also.n; i++)
        if (!(fabs(j->study->ratios.also.item[i] - j->ratio[k]) > 0)) return true;
    return false;
}

static void print_sweep(const job *j, bool all)
{
    const orr_study_vibration *s = j->study;
    size_t every = all ? 1 : j->n_ratios / SHOWN_POINTS;
    if (every == 0) every = 1;
    for (size_t p = 0; p < s->products.n; p++) {
        printf("heading error over pi f_v beta^2, f_v beta^2 = %g 1/s, f_m = %g Hz\n", s->products.item[p],
               s->readings_hz);
        print_header(j);
        for (size_t k = 0; k < j->n_ratios; k++) {
            if (!shown(j, k, every)) continue;
            printf("%10.5g", j->ratio[k]);
            for (size_t m = 0; m < j->n_methods; m++) printf(" %13.4e", row_of(j, p, m, k)[NORMALISED]);
            printf("\n");
        }
    }
}

// Pairs that meet at one ratio stand in one line, as at every half of f_m, where all methods meet.
static void print_crossings(const job *j, bool all)
{
    const double high = all ? j->study->ratios.high : 1.0;
    printf("methods of equal error%s: f_v/f_m, f_v in Hz, error of both\n", all ? "" : " up to f_v = f_m");
    size_t k = 0;
    while (k < j->n_crossings && j->crossing[k].ratio <= high) {
        const orr_vibration_crossing *x = &j->crossing[k];
        printf("%10.5g %10.5g %13.4e ", x->ratio, x->ratio * j->study->readings_hz, x->normalised);
        bool met[MOST_METHODS] = {false};
        for (; k < j->n_crossings && j->crossing[k].ratio < x->ratio * (1 + 1e-6); k++)
            met[j->crossing[k].first] = met[j->crossing[k].second] = true;
        for (size_t m = 0; m < j->n_methods; m++)
            if (met[m]) printf(" %s", j->name[m]);
        printf("\n");
    }
    if (k == 0) printf("  none\n");
    if (k == MOST_CROSSINGS) printf("  these are the first %d\n", (int)MOST_CROSSINGS);
}

static void print_broadband(const job *j)
{
    const double degph = ORR_DEG_PER_RAD * 3600.0;
    printf("broadband vibration drifts by %.4g deg/h where mean rates alone are seen\n",
           j->drift_radps * degph);
    printf("%-14s %16s %16s\n", "deg/h", "by response", j->study->spectrum.runs > 0 ? "by runs" : "");
    for (size_t m = 0; m < j->n_methods; m++) {
        printf("%-14s %16.4e", j->name[m], j->by_response[m] * degph);
        if (j->study->spectrum.runs > 0) printf(" %16.4e", j->by_runs[m] * degph);
        printf("\n");
    }
}

static int report_json(const orr_cli *c, const job *j)
{
    json_t *all = json_array(), *crossings = json_array(), *wide = json_object();
    for (size_t p = 0; p < j->study->products.n; p++)
        for (size_t m = 0; m < j->n_methods; m++) {
            json_t *points = json_array();
            for (size_t k = 0; k < j->n_ratios; k++) {
                const double *row = row_of(j, p, m, k);
                json_array_append_new(points,
                                      json_pack("{s:o, s:o, s:o}", "ratio", orr_json_number(row[RATIO]),
                                                "normalised", orr_json_number(row[NORMALISED]), "sculling",
                                                orr_json_number(row[SCULLING])));
            }
            json_array_append_new(all,
                                  json_pack("{s:s, s:o, s:o}", "method", j->name[m], "product",
                                            orr_json_number(j->study->products.item[p]), "errors", points));
        }
    for (size_t k = 0; k < j->n_crossings; k++) {
        const orr_vibration_crossing *x = &j->crossing[k];
        json_array_append_new(crossings, json_pack("{s:[s,s], s:o, s:o}", "methods", j->name[x->first],
                                                   j->name[x->second], "ratio", orr_json_number(x->ratio),
                                                   "normalised", orr_json_number(x->normalised)));
    }
    for (size_t m = 0; j->study->has_spectrum && m < j->n_methods; m++)
        json_object_set_new(
            wide, j->name[m],
            json_pack("{s:o, s:o}", "response_radps", orr_json_number(j->by_response[m]), "runs_radps",
                      orr_json_number(j->study->spectrum.runs > 0 ? j->by_runs[m] : ORR_NAN)));
    json_t *out = json_pack("{s:o, s:o, s:o}", "sweeps", all, "crossings", crossings, "broadband", wide);
    return orr_json_print(c, out, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
}

static int report(const orr_cli *c, const job *j)
{
    if (orr_cli_says(c, "format", "json")) return report_json(c, j);
    if (orr_study_to_stdout(c)) return ORR_EXIT_OK;
    const bool all = orr_cli_given(c, "sweep");
    for (size_t m = 0; m < j->n_methods; m++) {
        const double sum = orr_attitude_method_consistency(&j->method[m]);
        if (j->method[m].samples > 1 && fabs(sum - 1) > 1e-9)
            printf("%s: its coefficients sum to %.6g of N^3/12, so that of slow vibrations it leaves %.3g of "
                   "what one "
                   "step over its group does\n",
                   j->name[m], sum, fabs(1 - sum));
    }
    print_sweep(j, all);
    print_crossings(j, all);
    if (j->study->has_spectrum) print_broadband(j);
    return ORR_EXIT_OK;
}

static orr_status draw(const orr_cli *c, const char *title, const job *j, orr_diag *diag)
{
    const size_t curves = j->study->products.n * j->n_methods;
    double *xy = malloc(2 * curves * j->n_ratios * sizeof *xy);
    orr_plot_line *line = calloc(curves, sizeof *line);
    char(*label)[64] = calloc(curves, sizeof *label);
    orr_status s = xy != NULL && line != NULL && label != NULL
                       ? ORR_OK
                       : orr_diag_set(diag, ORR_E_MEMORY, "no memory for a figure");
    for (size_t q = 0; q < curves && s == ORR_OK; q++) {
        double *x = &xy[2 * q * j->n_ratios], *y = x + j->n_ratios;
        const size_t p = q / j->n_methods, m = q % j->n_methods;
        for (size_t k = 0; k < j->n_ratios; k++) {
            x[k] = j->ratio[k];
            y[k] = fabs(row_of(j, p, m, k)[NORMALISED]);
        }
        if (j->study->products.n > 1)
            snprintf(label[q], sizeof label[q], "%s, %g 1/s", j->name[m], j->study->products.item[p]);
        else
            snprintf(label[q], sizeof label[q], "%s", j->name[m]);
        line[q] = (orr_plot_line){
            .label = label[q], .x = x, .y = y, .n = j->n_ratios, .colour = (int)m, .dash = p > 0};
    }
    const bool linear = orr_cli_says(c, "axes", "linear");
    const orr_plot plot = {.title = title,
                           .x_label = "f_v / f_m",
                           .y_label = "heading error / (pi f_v beta^2)",
                           .log_x = !linear,
                           .log_y = !linear,
                           .line = line,
                           .n = curves};
    if (s == ORR_OK) s = orr_study_plot(c, &plot, diag);
    free(label);
    free(line);
    free(xy);
    return s;
}

// Readings of the body at rest that vibrates at --ratio, with the Earth's rate and gravity (section 5.1), as a file.
static orr_status write_readings(const orr_cli *c, const char *title, const job *j, const orr_inputs *inputs,
                                 orr_diag *diag)
{
    const orr_study_vibration *s = j->study;
    const orr_study_place *p = &s->rest;
    const char *path = orr_cli_text(c, "readings", NULL);
    if (path == NULL) return ORR_OK;
    if (!s->has_rest)
        return orr_diag_set(diag, ORR_E_ARG, "--readings wants a place: the study has no 'rest'");
    const orr_vibration_study study = study_of(s, s->products.item[0]);
    const double f = orr_cli_real(c, "ratio", 0.1) * s->readings_hz;
    const orr_vibration v = {.frequency_hz = f, .amplitude_rad = sqrt(study.product_hz / f)};
    const orr_geodetic place = {study.lat_rad, p->lon_deg * ORR_RAD_PER_DEG, p->height_m};
    orr_trajectory tr;
    orr_imu imu = {0};
    orr_status status = orr_trajectory_vibrating(orr_moving_fallback_start(), 0, study.duration_s, place,
                                                 study.attitude, &v, &tr, diag);
    if (status != ORR_OK) return status;
    const orr_imu_request want = {
        .duration_s = study.duration_s,
        .rate_hz = s->readings_hz,
        .mode = {.approach = 2, .quadrature = ORR_QUADRATURE_GAUSS, .order = ORR_IMU_MAX_ORDER}};
    orr_nc_input *from = orr_inputs_provenance(inputs);
    const orr_imu_labels labels = {
        .title = title, .history = c->call, .input = from, .n_inputs = from != NULL ? inputs->n : 0};
    status = orr_imu_generate(&tr, &want, &imu, diag);
    if (status == ORR_OK) status = orr_imu_write(path, &imu, NULL, NULL, &labels, diag);
    free(from);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
    return status;
}

static int make(orr_cli *c, const orr_study_vibration *study, orr_inputs *inputs)
{
    orr_diag diag = {0};
    job *j = calloc(1, sizeof *j);
    if (j == NULL) return orr_cli_failf(c, "no memory");
    j->study = study;
    const char *title = study->head.title != NULL ? study->head.title : "Vibration at alignment";
    orr_status s = gather_methods(j, &diag);
    if (s == ORR_OK) s = gather_ratios(j, &diag);
    if (s == ORR_OK) s = broadband(j, inputs, &diag);
    if (s == ORR_OK) s = sweep(c, j, &diag);
    const orr_study_column column[COLUMNS] = {
        {"method", NULL, "algorithm", j->name},
        {"product_rad2ps", "rad2/s", "f_v beta^2", NULL},
        {"ratio", NULL, "f_v / f_m", NULL},
        {"frequency_hz", "Hz", "f_v", NULL},
        {"amplitude_arcsec", "arcsec", "beta", NULL},
        {"normalised", NULL, "heading error over pi f_v beta^2 and time", NULL},
        {"second_order", NULL, "the same in closed form, to second order in beta", NULL},
        {"heading_drift_degph", "deg/h", "clockwise", NULL},
        {"tilt_arcsec", "arcsec", "error of the attitude besides heading, at the end", NULL},
        {"sculling", NULL, "error of the mean acceleration under sculling over its own", NULL},
    };
    const orr_study_table out = {"vibration", column, COLUMNS, j->n, j->table};
    if (s == ORR_OK) s = orr_study_write(c, title, inputs, &out, 1, &diag);
    if (s == ORR_OK) s = draw(c, title, j, &diag);
    if (s == ORR_OK) s = write_readings(c, title, j, inputs, &diag);
    const int status = s == ORR_OK ? report(c, j) : orr_cli_fail(c, &diag);
    free(j->ratio);
    free(j->table);
    orr_spectrum_free(&j->spectrum);
    free(j);
    return status;
}

static int run(orr_cli *c)
{
    orr_study_vibration study;
    orr_inputs inputs = {0};
    bool go;
    int status = orr_cli_study_open(c, &orr_study_vibration_schema, &study, &inputs, &go);
    if (!go) return status;
    status = make(c, &study, &inputs);
    orr_schema_free(&orr_study_vibration_schema, &study);
    orr_inputs_free(&inputs);
    return status;
}

static const orr_option options[] = {
    {.name = "sweep",
     .kind = ORR_OPT_FLAG,
     .help = "Print every ratio of the sweep; without, some two dozen of them."},
    {.writes = true,
     .name = "readings",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Write the readings of the body at rest under the first f_v beta^2, with truth, as `orrery imu` "
             "does."},
    {.name = "ratio",
     .kind = ORR_OPT_REAL,
     .value = "R",
     .applies = "readings",
     .min = 1e-4,
     .max = 2,
     .help = "Their f_v / f_m. Default 0.1."},
    {.name = "axes",
     .kind = ORR_OPT_CHOICE,
     .value = "log|linear",
     .fallback = "log",
     .applies = "plot",
     .help = "Axes of the figure; logarithmic by default."},
    ORR_STUDY_OPTIONS,
};

const orr_command orr_cmd_vibration = {
    .name = "vibration",
    .group = "Inertial studies",
    .summary = "attitude algorithms under vibration during alignment",
    .operands = "STUDY.yaml",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Heading errors of multi-step attitude algorithms under conical vibration, over the ratio of "
             "its frequency to "
             "that of the readings at constant f_v beta^2 (Bogdanov 2015, section 5): normalised curves, the "
             "ratios where "
             "two algorithms are of equal error, the counterpart of velocity under sculling, and broadband "
             "vibration by a "
             "table of its density. Algorithms may be given by their coefficients.",
    .example =
        "orrery vibration samples/studies/vibration.yaml --sweep --plot vibration.svg -o vibration.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

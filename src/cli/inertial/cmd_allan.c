// SPDX-License-Identifier: GPL-3.0-or-later
// orrery allan: Allan deviations of readings, and the noises that they show.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/outfile.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/allan.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"
#include "src/cli/frame/plot.h"

enum { CHANNELS = 6 };

static const char *const channel_name[CHANNELS] = {"gyro_x",  "gyro_y",  "gyro_z",
                                                   "accel_x", "accel_y", "accel_z"};

typedef struct result {
    orr_allan curve[CHANNELS];
    orr_allan_fit fit[CHANNELS];
    bool fitted;
} result;

// Units that people know, by the rate's in rad/s and m/s^2.
typedef struct unit {
    const char *name;
    double scale;
} unit;
static const unit units[2][ORR_ALLAN_NOISES] = {
    {{"arcsec", ORR_DEG_PER_RAD * 3600.0},
     {"deg/sqrt(h)", ORR_DEG_PER_RAD * 60.0},
     {"deg/h", ORR_DEG_PER_RAD * 3600.0},
     {"deg/h/sqrt(h)", ORR_DEG_PER_RAD * 3600.0 * 60.0},
     {"deg/h/h", ORR_DEG_PER_RAD * 3600.0 * 3600.0}},
    {{"m/s", 1.0}, {"m/s/sqrt(h)", 60.0}, {"mGal", 1e5}, {"mGal/sqrt(h)", 6e6}, {"mGal/h", 3.6e8}},
};

static double of_axis(orr_vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// The series without what the ideal readings say, where the file has both: the motion is no noise.
static void take(const orr_imu *imu, int channel, bool errors, double *x)
{
    const orr_vec3 *ideal = channel < 3 ? imu->dtheta_rad : imu->dv_mps,
                   *measured = channel < 3 ? imu->measured_dtheta_rad : imu->measured_dv_mps;
    for (size_t k = 0; k < imu->n; k++)
        x[k] = (measured != NULL ? of_axis(measured[k], channel % 3) : 0.0) -
               (errors ? of_axis(ideal[k], channel % 3) : 0.0);
    if (measured == NULL)
        for (size_t k = 0; k < imu->n; k++) x[k] = of_axis(ideal[k], channel % 3);
}

static orr_status analyse(const orr_imu *imu, bool errors, result *out, orr_diag *diag)
{
    double *x = malloc(imu->n * sizeof *x);
    if (x == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu samples", imu->n);
    orr_status s = ORR_OK;
    out->fitted = true;
    for (int c = 0; c < CHANNELS && s == ORR_OK; c++) {
        take(imu, c, errors, x);
        s = orr_allan_deviation(x, imu->n, 1.0 / imu->rate_hz, &out->curve[c], diag);
        if (s == ORR_OK && out->fitted) {
            s = orr_allan_coefficients(x, imu->n, 1.0 / imu->rate_hz, &out->fit[c], diag);
            if (s == ORR_E_NODATA) { // the curves are there all the same
                out->fitted = false;
                s = ORR_OK;
            }
        }
    }
    free(x);
    return s;
}

static orr_status write_csv(const char *path, const result *r, orr_diag *diag)
{
    orr_outfile f;
    orr_status s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    fputs("channel,tau_s,deviation,low,high,hadamard\n", f.stream);
    for (int c = 0; c < CHANNELS; c++)
        for (size_t k = 0; k < r->curve[c].n; k++) {
            const orr_allan_point *p = &r->curve[c].point[k];
            fprintf(f.stream, "%s,%.9g,%.9g,%.9g,%.9g,", channel_name[c], p->tau_s, p->deviation, p->low,
                    p->high);
            fprintf(f.stream, isnan(p->hadamard) ? "\n" : "%.9g\n", p->hadamard);
        }
    return orr_outfile_commit(&f, diag);
}

// Gyros in deg/h, accelerometers in ug, with the 95 % intervals.
static orr_status draw(const char *path, const result *r, orr_diag *diag)
{
    enum { ROWS = 4 };
    static const double scale[2] = {ORR_DEG_PER_RAD * 3600.0, 1e6 / 9.80665};
    static const char *const label[CHANNELS] = {"gyro x, deg/h",       "gyro y, deg/h",
                                                "gyro z, deg/h",       "accelerometer x, ug",
                                                "accelerometer y, ug", "accelerometer z, ug"};
    double(*v)[ROWS][ORR_ALLAN_MAX_POINTS] = calloc(CHANNELS, sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_plot_line line[CHANNELS];
    for (int c = 0; c < CHANNELS; c++) {
        for (size_t k = 0; k < r->curve[c].n; k++) {
            const orr_allan_point *p = &r->curve[c].point[k];
            v[c][0][k] = p->tau_s;
            v[c][1][k] = p->deviation * scale[c / 3];
            v[c][2][k] = p->low * scale[c / 3];
            v[c][3][k] = p->high * scale[c / 3];
        }
        line[c] = (orr_plot_line){.label = label[c],
                                  .x = v[c][0],
                                  .y = v[c][1],
                                  .low = v[c][2],
                                  .high = v[c][3],
                                  .n = r->curve[c].n,
                                  .colour = c,
                                  .dash = c >= 3};
    }
    const orr_plot plot = {.title = "Overlapping Allan deviation, with 95 % intervals",
                           .x_label = "averaging time, s",
                           .y_label = "gyros: deg/h, accelerometers: ug",
                           .log_x = true,
                           .log_y = true,
                           .line = line,
                           .n = CHANNELS};
    const orr_status s = orr_plot_write(path, &plot, diag);
    free(v);
    return s;
}

static void print_table(const result *r)
{
    if (!r->fitted) {
        printf("too few samples to tell noises apart; --csv has the curves\n");
        return;
    }
    printf("times up to %.4g s fitted, of %.6g s\n", r->fit[0].longest_tau_s, r->curve[0].duration_s);
    for (int c = 0; c < CHANNELS; c++) {
        const orr_allan_fit *f = &r->fit[c];
        const unit *u = units[c / 3];
        bool any = false;
        for (int k = 0; k < ORR_ALLAN_NOISES; k++) {
            const orr_allan_coefficient *q = &f->noise[k];
            if (!q->seen) continue;
            any = true;
            printf("%-8s %-17s %.4g %s (%.4g to %.4g)\n", channel_name[c],
                   orr_allan_noise_name((orr_allan_noise)k), q->value * u[k].scale, u[k].name,
                   q->low * u[k].scale, q->high * u[k].scale);
        }
        if (f->gauss_markov) {
            const orr_allan_coefficient *q = &f->noise[ORR_ALLAN_INSTABILITY];
            const unit *v = &u[ORR_ALLAN_INSTABILITY];
            printf("%-8s %-17s %.4g %s (%.4g to %.4g), correlation time %.4g s (%.4g to %.4g)\n",
                   channel_name[c], "Gauss-Markov", f->sigma * v->scale, v->name, q->low * v->scale,
                   q->high * v->scale, f->correlation_s, f->correlation_low_s, f->correlation_high_s);
        } else if (!any) {
            printf("%-8s no noise\n", channel_name[c]);
        }
    }
}

static json_t *coefficient(double value, double low, double high)
{
    return json_pack("{s:o, s:o, s:o}", "value", orr_json_number(value), "low", orr_json_number(low), "high",
                     orr_json_number(high));
}

// In SI units.
static int print_json(const orr_cli *c, const result *r)
{
    json_t *all = json_object();
    for (int k = 0; k < CHANNELS && r->fitted; k++) {
        json_t *one = json_object();
        const orr_allan_fit *f = &r->fit[k];
        for (int i = 0; i < ORR_ALLAN_NOISES; i++)
            if (f->noise[i].seen)
                json_object_set_new(one, orr_allan_noise_name((orr_allan_noise)i),
                                    coefficient(f->noise[i].value, f->noise[i].low, f->noise[i].high));
        if (f->gauss_markov) {
            const orr_allan_coefficient *q = &f->noise[ORR_ALLAN_INSTABILITY];
            json_t *g = coefficient(f->sigma, q->low, q->high);
            json_object_set_new(g, "correlation_s", orr_json_number(f->correlation_s));
            json_object_set_new(one, "Gauss-Markov", g);
        }
        json_object_set_new(all, channel_name[k], one);
    }
    json_t *j = json_pack("{s:o, s:o, s:o}", "duration_s", orr_json_number(r->curve[0].duration_s),
                          "longest_tau_s", orr_json_number(r->fit[0].longest_tau_s), "noises", all);
    return orr_json_print(c, j, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_imu_file f;
    const char *path = orr_cli_text(c, "csv", NULL);
    const bool csv_only = path != NULL && strcmp(path, "-") == 0, json = orr_cli_says(c, "format", "json");
    if (csv_only && json)
        return orr_cli_usage(c, "only one of --csv - and --format json can go to standard output");
    orr_status s = orr_imu_read(c->operand[0], orr_cli_text(c, "gravity-folder", NULL), &f, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    const bool errors = f.imu.measured_dtheta_rad != NULL && !orr_cli_says(c, "of", "readings");
    if (orr_cli_says(c, "of", "errors") && !errors) {
        orr_imu_file_free(&f);
        return orr_cli_failf(c, "%s has no readings with errors ('orrery imu --errors' makes them)",
                             c->operand[0]);
    }
    result *r = calloc(1, sizeof *r);
    s = r != NULL ? analyse(&f.imu, errors, r, &diag) : orr_diag_set(&diag, ORR_E_MEMORY, "no memory");
    int status = ORR_EXIT_OK;
    if (s == ORR_OK && path != NULL) s = write_csv(path, r, &diag);
    const char *figure = orr_cli_text(c, "plot", NULL);
    if (s == ORR_OK && figure != NULL) s = draw(figure, r, &diag);
    if (s == ORR_OK && json)
        status = print_json(c, r);
    else if (s == ORR_OK && !csv_only)
        print_table(r);
    free(r);
    orr_imu_file_free(&f);
    return s == ORR_OK ? status : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "of",
     .kind = ORR_OPT_CHOICE,
     .value = "errors|readings",
     .help = "What is analysed: the errors (measured less ideal), or the readings as they are, of a body at "
             "rest. Default: "
             "the errors where the file has both."},
    {.writes = true,
     .name = "csv",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "The curves: deviation, its 95 % interval and the Hadamard deviation by averaging time, in "
             "rad/s and m/s2; - "
             "for standard output, instead of the table."},
    {.writes = true,
     .name = "plot",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Draw the deviations with their intervals (SVG)."},
    {.name = "gravity-folder",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Where a gravity model's files are now."},
    ORR_OPTION_REPORT,
};

const orr_command orr_cmd_allan = {
    .name = "allan",
    .group = "Inertial",
    .summary = "Allan deviations of readings, and the noises that they show",
    .operands = "IMU",
    .min_operands = 1,
    .max_operands = 1,
    .about = "Overlapping Allan and Hadamard deviations of the six channels, and by least squares the "
             "coefficients of "
             "quantisation, white noise, bias instability, rate random walk and ramp with their 95 % "
             "intervals. A hump of "
             "a Gauss-Markov process is told apart from a floor. Averaging times up to a 200th of the run "
             "are fitted.",
    .example = "orrery imu samples/still.yaml --errors samples/sensors/tactical.yaml -o imu.nc\n"
               "orrery allan imu.nc --csv allan.csv --plot allan.svg",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

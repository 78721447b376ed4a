// SPDX-License-Identifier: GPL-3.0-or-later
// orrery compare: how far a product is from precise orbits that it was not made from.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "core/outfile.h"
#include "orbit/judge/compare.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/compare_clocks_print.h"
#include "src/cli/orbit/compare_prediction.h"
#include "src/make/inputs.h"
#include "src/make/products.h"

static const char *const place_name[ORR_COMPARE_PLACES] = {"inner", "edge", "gap"};
static const char *const light_name[ORR_COMPARE_LIGHTS] = {"sunlit", "eclipsing"};

static json_t *json_stats(const orr_compare_stats *s)
{
    json_t *o = json_object(), *mean = json_array();
    json_object_set_new(o, "n", orr_json_count(s->n));
    json_object_set_new(o, "satellites", orr_json_count(s->satellites));
    json_object_set_new(o, "rms_mm", orr_json_number(1e3 * s->rms_m));
    json_object_set_new(o, "p95_mm", orr_json_number(1e3 * s->p95_m));
    json_object_set_new(o, "max_mm", orr_json_number(1e3 * s->max_m));
    json_object_set_new(o, "vel_n", orr_json_count(s->n_vel));
    json_object_set_new(o, "vel_rms_mps", orr_json_number(s->vel_rms_mps));
    json_object_set_new(o, "sigma_rms_mm", orr_json_number(1e3 * s->sigma_rms_m));
    json_object_set_new(o, "truth_rms_mm", orr_json_number(1e3 * s->truth_rms_m));
    json_object_set_new(o, "error_over_sigma", orr_json_number(s->error_over_sigma));
    json_object_set_new(o, "vel_sigma_rms_mps", orr_json_number(s->vel_sigma_rms_mps));
    json_object_set_new(o, "vel_truth_rms_mps", orr_json_number(s->vel_truth_rms_mps));
    json_object_set_new(o, "vel_error_over_sigma", orr_json_number(s->vel_error_over_sigma));
    const double m[3] = {s->mean_m.x, s->mean_m.y, s->mean_m.z},
                 rms[3] = {s->rac_rms_m.x, s->rac_rms_m.y, s->rac_rms_m.z},
                 bias[3] = {s->rac_mean_m.x, s->rac_mean_m.y, s->rac_mean_m.z};
    for (int i = 0; i < 3; i++) json_array_append_new(mean, s->n > 0 ? json_real(1e3 * m[i]) : json_null());
    json_object_set_new(o, "mean_mm", mean);
    static const char *const part[3] = {"radial", "along", "cross"};
    for (int i = 0; i < 3; i++)
        json_object_set_new(o, part[i],
                            json_pack("{s:o, s:o}", "rms_mm",
                                      s->n > 0 ? orr_json_number(1e3 * rms[i]) : json_null(), "mean_mm",
                                      s->n > 0 ? orr_json_number(1e3 * bias[i]) : json_null()));
    return o;
}

static int print_json(const orr_cli *c, const orr_comparison *x, const orr_clock_comparison *clocks,
                      const orr_prediction_judgement *prediction)
{
    json_t *j = json_object(), *systems = json_object(), *sats = json_array(), *left = json_object();
    for (size_t i = 0; i < x->n_systems; i++) {
        const char key[2] = {x->system[i].system, '\0'};
        json_t *places = json_object();
        for (int p = 0; p < ORR_COMPARE_PLACES; p++)
            json_object_set_new(places, place_name[p], json_stats(&x->system[i].place[p]));
        for (int light = 0; light < ORR_COMPARE_LIGHTS; light++) {
            json_t *apart = json_object();
            for (int p = 0; p < ORR_COMPARE_PLACES; p++)
                json_object_set_new(apart, place_name[p], json_stats(&x->system[i].light[light][p]));
            json_object_set_new(places, light_name[light], apart);
        }
        json_object_set_new(systems, key, places);
    }
    for (size_t i = 0; i < x->n_sats; i++) {
        json_t *o = json_object();
        json_object_set_new(o, "sat", orr_json_sat(x->sat[i].sat));
        json_object_set_new(o, "n", orr_json_count(x->sat[i].n));
        json_object_set_new(o, "rms_mm", orr_json_number(1e3 * x->sat[i].rms_m));
        json_object_set_new(o, "max_mm", orr_json_number(1e3 * x->sat[i].max_m));
        json_object_set_new(o, "worst", orr_json_time(x->sat[i].worst));
        json_array_append_new(sats, o);
    }
    json_object_set_new(left, "inputs", json_integer(orr_cli_given(c, "inputs") ? 0 : (json_int_t)x->inputs));
    json_object_set_new(left, "no_orbit", orr_json_count(x->no_orbit));
    json_object_set_new(left, "between", orr_json_count(x->between));
    json_object_set_new(j, "systems", systems);
    json_object_set_new(j, "satellites", sats);
    json_object_set_new(j, "left_out", left);
    json_object_set_new(j, "clocks", compare_clocks_json(clocks));
    json_object_set_new(j, "prediction", compare_prediction_json(prediction));
    json_t *times = json_object();
    json_object_set_new(times, "n", orr_json_count(x->late_epochs));
    json_object_set_new(times, "rms_us", orr_json_number(1e6 * x->late_rms_s));
    json_object_set_new(times, "max_us", orr_json_number(1e6 * x->late_most_s));
    json_object_set_new(times, "removed", json_boolean(orr_cli_says(c, "epoch-times", "remove")));
    json_object_set_new(j, "epoch_times", times);
    json_object_set_new(j, "truth_velocity", json_string(x->vel_derived ? "positions" : "records"));
    return orr_json_print(c, j, JSON_INDENT(2));
}

static void print_part(double rms_m, double mean_m)
{
    if (isnan(rms_m))
        printf(" %9s %9s", "-", "-");
    else
        printf(" %9.3f %9.3f", 1e3 * rms_m, 1e3 * mean_m);
}

// Radial, along-track, cross-track: where they are known.
static void print_parts(const orr_comparison *x)
{
    printf("\n%-8s %-6s %19s %19s %19s\n%-15s", "system", "place", "radial, mm", "along-track", "cross-track",
           "");
    for (int i = 0; i < 3; i++) printf(" %9s %9s", "RMS", "mean");
    putchar('\n');
    for (size_t i = 0; i < x->n_systems; i++)
        for (int p = 0; p < ORR_COMPARE_PLACES; p++) {
            const orr_compare_stats *s = &x->system[i].place[p];
            if (s->n == 0) continue;
            printf("%-8s %-6s", orr_system_name(x->system[i].system), place_name[p]);
            print_part(s->rac_rms_m.x, s->rac_mean_m.x);
            print_part(s->rac_rms_m.y, s->rac_mean_m.y);
            print_part(s->rac_rms_m.z, s->rac_mean_m.z);
            putchar('\n');
        }
}

// Errors against what the product claims: satellites that pass the Earth's shadow are told apart.
static void print_sigma(const orr_comparison *x)
{
    printf(
        "\nerrors against sigma and the noise of the truth together\n%-8s %-6s %-9s %5s %8s %8s %8s %6s %9s "
        "%9s %9s %6s\n",
        "system", "place", "", "sats", "RMS mm", "sigma", "truth", "ratio", "RMS m/s", "sigma", "truth",
        "ratio");
    for (size_t i = 0; i < x->n_systems; i++)
        for (int light = 0; light < ORR_COMPARE_LIGHTS; light++)
            for (int p = 0; p < ORR_COMPARE_PLACES; p++) {
                const orr_compare_stats *s = &x->system[i].light[light][p];
                if (s->n == 0 || isnan(s->error_over_sigma)) continue;
                printf("%-8s %-6s %-9s %5zu %8.3f %8.3f %8.3f %6.2f", orr_system_name(x->system[i].system),
                       place_name[p], light_name[light], s->satellites, 1e3 * s->rms_m, 1e3 * s->sigma_rms_m,
                       1e3 * s->truth_rms_m, s->error_over_sigma);
                if (s->n_vel > 0 && !isnan(s->vel_error_over_sigma))
                    printf(" %9.2e %9.2e %9.2e %6.2f\n", s->vel_rms_mps, s->vel_sigma_rms_mps,
                           s->vel_truth_rms_mps, s->vel_error_over_sigma);
                else
                    printf(" %9s %9s %9s %6s\n", "-", "-", "-", "-");
            }
}

// The series of --csv: a row for each difference.
static void write_row(void *user, const orr_compare_difference *d)
{
    FILE *f = user;
    char t[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    const double v[9] = {d->rac_m.x, d->rac_m.y,   d->rac_m.z,   d->pos_m.x,  d->pos_m.y,
                         d->pos_m.z, d->vel_mps.x, d->vel_mps.y, d->vel_mps.z};
    fprintf(f, "%s,%s,%s", orr_time_text(d->t, t), orr_sat_text(d->sat, sat),
            d->place < ORR_COMPARE_PLACES ? place_name[d->place] : "");
    for (int i = 0; i < 9; i++)
        if (isnan(v[i]))
            fputc(',', f);
        else
            fprintf(f, i < 6 ? ",%.6f" : ",%.9f", v[i]);
    fputc('\n', f);
}

// Whether every system in every place is within --limit; says which is not.
static int judge(const orr_cli *c, const orr_comparison *x)
{
    const double limit_m = orr_cli_real(c, "limit", 0) * 1e-3;
    int status = ORR_EXIT_OK;
    for (size_t i = 0; i < x->n_systems && orr_cli_given(c, "limit"); i++)
        for (int p = 0; p < ORR_COMPARE_PLACES; p++) {
            const orr_compare_stats *s = &x->system[i].place[p];
            if (s->n > 0 && s->rms_m > limit_m)
                status = orr_cli_failf(c, "%s, %s: %.3f mm RMS, more than the limit of %g mm",
                                       orr_system_name(x->system[i].system), place_name[p], 1e3 * s->rms_m,
                                       1e3 * limit_m);
        }
    return status;
}

static void print_human(const orr_cli *c, const orr_comparison *x, bool product,
                        const orr_prediction_judgement *prediction)
{
    const bool with_inputs = orr_cli_given(c, "inputs");
    printf("Difference of %s from the truth, %s, 3-D\n\n", c->operand[0],
           !product      ? "at epochs of both"
           : with_inputs ? "input epochs as well"
                         : "input epochs left out");
    printf("%-8s %-6s %5s %8s %9s %9s %9s %13s %26s\n", "system", "place", "sats", "samples", "RMS mm",
           "95 % mm", "max mm", "velocity m/s", "mean x, y, z mm");
    for (size_t i = 0; i < x->n_systems; i++) {
        for (int p = 0; p < ORR_COMPARE_PLACES; p++) {
            const orr_compare_stats *s = &x->system[i].place[p];
            if (s->n == 0) continue;
            printf("%-8s %-6s %5zu %8zu %9.3f %9.3f %9.3f ", orr_system_name(x->system[i].system),
                   place_name[p], s->satellites, s->n, 1e3 * s->rms_m, 1e3 * s->p95_m, 1e3 * s->max_m);
            if (s->n_vel > 0)
                printf("%13.2e", s->vel_rms_mps);
            else
                printf("%13s", "-");
            printf(" %8.3f %8.3f %8.3f\n", 1e3 * s->mean_m.x, 1e3 * s->mean_m.y, 1e3 * s->mean_m.z);
        }
    }
    print_parts(x);
    if (product) print_sigma(x);
    printf("\nfurthest satellites (RMS mm, max mm at)\n");
    for (size_t i = 0; i < x->n_sats && i < 5; i++) {
        char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
        printf("  %s %9.3f %9.3f %s\n", orr_sat_text(x->sat[i].sat, name), 1e3 * x->sat[i].rms_m,
               1e3 * x->sat[i].max_m, orr_time_text(x->sat[i].worst, when));
    }
    if (!product)
        printf("\nleft out: %zu positions of the truth without one of the other\n", x->no_orbit);
    else if (with_inputs)
        printf("\nat epochs that were input: %zu; left out: %zu without an orbit in the product\n", x->inputs,
               x->no_orbit);
    else
        printf("\nleft out: %zu positions at epochs that were input, %zu without an orbit in the product\n",
               x->inputs, x->no_orbit);
    if (x->between > 0)
        printf("in no place: %zu samples between 45 min and 2 h from an end, or beyond the last input node\n",
               x->between);
    if (x->late_epochs > 0)
        printf("the truth's positions are not quite those of their epochs: all satellites alike are %.2f us "
               "RMS ahead or "
               "behind, %.2f us at most; %s\n",
               1e6 * x->late_rms_s, 1e6 * x->late_most_s,
               orr_cli_says(c, "epoch-times", "remove") ? "that is taken out"
                                                        : "--epoch-times remove takes it out");
    compare_prediction_print(prediction);
}

// What is judged: an orbit product, or precise orbits; one of the two is there.
typedef struct subject {
    orr_ephemeris *e;
    orr_sp3 sp3;
} subject;

static const char *frame_of(const subject *u)
{
    return u->e != NULL ? orr_ephemeris_frame(u->e) : u->sp3.coordinates;
}

// A datum difference looks like an orbit error; names that differ are worth a word.
static void check_frame(const orr_cli *c, const subject *u, const orr_sp3 *truth, const char *path)
{
    const char *frame = frame_of(u);
    if (frame[0] == '\0' || truth->coordinates[0] == '\0' || strncmp(frame, truth->coordinates, 5) == 0)
        return;
    orr_cli_failf(c, "warning: %s is in %s, %s in %s", path, truth->coordinates, c->operand[0], frame);
}

// Compares, and writes the series of --csv meanwhile.
static orr_status make(const orr_cli *c, const subject *u, const orr_sp3 *truth, size_t n, orr_comparison *x,
                       orr_diag *diag)
{
    const char *csv = orr_cli_text(c, "csv", NULL);
    orr_compare_options o = {.derive_velocity = orr_cli_says(c, "velocity", "positions"),
                             .remove_times = orr_cli_says(c, "epoch-times", "remove"),
                             .with_inputs = orr_cli_given(c, "inputs"),
                             .sats = orr_cli_sats(c, "sat")};
    orr_outfile out = {0};
    orr_status s = csv != NULL ? orr_outfile_open(csv, &out, diag) : ORR_OK;
    if (s == ORR_OK && csv != NULL) {
        o.sink = write_row;
        o.user = out.stream;
        fputs("t_gps,sat,place,radial_m,along_m,cross_m,dx_m,dy_m,dz_m,dvx_mps,dvy_mps,dvz_mps\n",
              out.stream);
    }
    if (s == ORR_OK)
        s = u->e != NULL ? orr_compare(u->e, truth, n, &o, x, diag)
                         : orr_compare_sp3(&u->sp3, 1, truth, n, &o, x, diag);
    if (csv == NULL) return s;
    return orr_outfile_end(&out, s, diag);
}

static int compare(orr_cli *c, const subject *u, orr_sp3 *truth, size_t n)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    for (size_t i = 0; i < n; i++) {
        const char *path = c->operand[i + 1];
        orr_cli_progress(c, "reading", i, n);
        orr_sp3_limits limits = orr_sp3_default_limits();
        limits.leap = c->leap;
        orr_status s = orr_sp3_read(path, &limits, &truth[i], &warnings, &diag);
        orr_cli_progress(c, "reading", n, n);
        if (s != ORR_OK) {
            orr_warnings_free(&warnings);
            return orr_cli_fail(c, &diag);
        }
        check_frame(c, u, &truth[i], path);
    }
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    orr_comparison x;
    orr_prediction_judgement prediction = {0};
    orr_status s = make(c, u, truth, n, &x, &diag);
    if (s == ORR_OK && u->e != NULL) {
        s = orr_prediction_judge(u->e, truth, n, &prediction, &diag);
        if (s != ORR_OK) orr_comparison_free(&x);
    }
    if (s != ORR_OK) {
        const int failed = orr_cli_fail(c, &diag);
        if (s == ORR_E_NODATA && u->e != NULL && !orr_cli_given(c, "inputs"))
            orr_cli_say(c, "(with --inputs, epochs that the product was made from are compared as well)");
        return failed;
    }
    orr_clock_comparison clocks = {0};
    if (u->e != NULL && orr_compare_clocks(u->e, truth, n, orr_cli_sats(c, "sat"), orr_cli_given(c, "inputs"),
                                           &clocks, &diag) != ORR_OK) {
        orr_prediction_judgement_free(&prediction);
        orr_comparison_free(&x);
        return orr_cli_fail(c, &diag);
    }
    int status = ORR_EXIT_OK;
    if (orr_cli_says(c, "format", "json"))
        status = print_json(c, &x, &clocks, &prediction);
    else if (strcmp(orr_cli_text(c, "csv", ""), "-") != 0) { // standard output is the series then
        print_human(c, &x, u->e != NULL, &prediction);
        compare_clocks_print(&clocks);
    }
    const int within = judge(c, &x);
    if (status == ORR_EXIT_OK) status = within;
    orr_prediction_judgement_free(&prediction);
    orr_comparison_free(&x);
    orr_clock_comparison_free(&clocks);
    return status;
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    subject u = {0};
    size_t n = (size_t)c->n_operands - 1;
    const char *path = c->operand[0], *csv = orr_cli_text(c, "csv", "");
    if (strcmp(csv, "-") == 0 && orr_cli_says(c, "format", "json"))
        return orr_cli_usage(c, "only one of --csv - and --format json can go to standard output");
    const bool product = orr_nc_is_hdf5(path);
    orr_sp3_limits limits = orr_sp3_default_limits();
    limits.leap = c->leap;
    const orr_status s =
        product ? orr_product_load(path, &u.e, &diag) : orr_sp3_read(path, &limits, &u.sp3, NULL, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    orr_sp3 *truth = calloc(n, sizeof *truth);
    int status = truth != NULL ? compare(c, &u, truth, n) : orr_cli_failf(c, "out of memory");
    for (size_t i = 0; i < n && truth != NULL; i++) orr_sp3_free(&truth[i]);
    free(truth);
    orr_ephemeris_free(u.e);
    orr_sp3_free(&u.sp3);
    return status;
}

static const orr_option options[] = {
    ORR_OPTION_SATS,
    {.name = "velocity",
     .fallback = "records",
     .kind = ORR_OPT_CHOICE,
     .value = "records|positions",
     .help = "Velocity of the truth. records (default): its V records where it has them. positions: always "
             "the derivative of its positions."},
    {.name = "epoch-times",
     .fallback = "keep",
     .kind = ORR_OPT_CHOICE,
     .value = "keep|remove",
     .help = "Where positions of the truth are not quite those of their epochs (all satellites alike ahead "
             "or behind along "
             "their orbits, up to 2 mm where a centre rounds its time). keep (default): that is told and is "
             "the truth's "
             "noise. remove: the truth's positions are moved to their epochs."},
    {.name = "inputs",
     .kind = ORR_OPT_FLAG,
     .help = "Compare also at epochs that the product was made from, for orbits of another centre."},
    ORR_OPTION_SERIES(.help = "Write every difference: t_gps, sat, place, radial_m, along_m, cross_m, dx_m, "
                              "dy_m, dz_m (ecef) and dvx_mps, dvy_mps, dvz_mps."),
    {.name = "limit",
     .kind = ORR_OPT_REAL,
     .value = "MM",
     .min = 1e-3,
     .max = 1e9,
     .help = "Exit with status 1 where the 3-D RMS of a system in a place is larger, and say so."},
    ORR_OPTION_REPORT,
};

const orr_command orr_cmd_compare = {
    .name = "compare",
    .group = "Orbits",
    .summary = "tell how far an orbit product is from precise orbits",
    .operands = "PRODUCT|SP3 TRUTH.sp3...",
    .min_operands = 2,
    .max_operands = -1,
    .about =
        "The first file is an orbit product or an SP3 file; of two SP3 files the epochs that both have "
        "are compared. "
        "Epochs that the product was made from are left out, unless --inputs asks for them. Places: "
        "inner is at least 2 h from the "
        "satellite's first and "
        "last input node, edge within 45 min of one of them, gap between nodes further apart than twice "
        "the usual step.\n\n"
        "The truth's velocity is its V record; without one it is the derivative of a least-squares "
        "polynomial through the "
        "truth's own positions within about an hour, in axes that do not rotate (good to 5e-7 m/s; near "
        "a file's ends, where "
        "the positions lie on one side, the rounding of SP3 makes it 1e-5 m/s).\n\n"
        "V records are not always the derivatives of the positions beside them (some centres leave out "
        "the turning of the "
        "equator, 6e-5 to 1.4e-4 m/s): --velocity positions tells.\n\n"
        "Clocks are compared between the nodes of the product's clocks (with --inputs also at them), at each "
        "epoch less the median over the satellites of a system, of four at least: what all share is the "
        "reference clock's. error/sigma is the RMS of the difference over the product's own sigma there, 1 "
        "where that is honest.\n\n"
        "JSON keys: of systems.G.inner n, satellites, rms_mm, p95_mm, max_mm, vel_n, vel_rms_mps, mean_mm, "
        "and radial, along, cross with rms_mm and mean_mm each; the same for edge and gap, and for each "
        "system; satellites; left_out; of clocks.systems.G satellites, n, rms_ns, p95_ns, max_ns, "
        "sigma_rms_ns and ratio; clocks.satellites, clocks.left_out; "
        "prediction (null where the product predicts nothing) with rows of "
        "system, eclipses, age_h, orbit (satellites, median_mm, p95_mm, error_over_sigma) and clock "
        "(the same in ns), manoeuvres and predicted_truth; epoch_times with n, rms_us, max_us and "
        "removed.\n\n"
        "The predicted part of a product is judged by age since a satellite's last position, sunlit "
        "satellites and those that meet the Earth's shadow apart.",
    .example = "orrery orbit -o day.nc --nodes 900 COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz\n"
               "orrery compare day.nc COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

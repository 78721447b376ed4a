// SPDX-License-Identifier: GPL-3.0-or-later
// orrery compare: how far a product is from precise orbits that it was not made from.
#include <stdlib.h>
#include <string.h>

#include "orbit/judge/compare.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

static const char *const place_name[ORR_COMPARE_PLACES] = {"inner", "edge", "gap"};

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
    const double m[3] = {s->mean_m.x, s->mean_m.y, s->mean_m.z};
    for (int i = 0; i < 3; i++) json_array_append_new(mean, s->n > 0 ? json_real(1e3 * m[i]) : json_null());
    json_object_set_new(o, "mean_mm", mean);
    return o;
}

static int print_json(const orr_cli *c, const orr_comparison *x)
{
    json_t *j = json_object(), *systems = json_object(), *sats = json_array(), *left = json_object();
    for (size_t i = 0; i < x->n_systems; i++) {
        const char key[2] = {x->system[i].system, '\0'};
        json_t *places = json_object();
        for (int p = 0; p < ORR_COMPARE_PLACES; p++)
            json_object_set_new(places, place_name[p], json_stats(&x->system[i].place[p]));
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
    json_object_set_new(j, "truth_velocity", json_string(x->vel_derived ? "positions" : "records"));
    return orr_json_print(c, j, JSON_INDENT(2));
}

static void print_human(const orr_cli *c, const orr_comparison *x)
{
    const bool with_inputs = orr_cli_given(c, "inputs");
    printf("Difference of %s from the truth, %s, 3-D\n\n", c->operand[0],
           with_inputs ? "input epochs as well" : "input epochs left out");
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
    printf("\nfurthest satellites (RMS mm, max mm at)\n");
    for (size_t i = 0; i < x->n_sats && i < 5; i++) {
        char name[ORR_SAT_TEXT], when[ORR_TIME_TEXT];
        printf("  %s %9.3f %9.3f %s\n", orr_sat_text(x->sat[i].sat, name), 1e3 * x->sat[i].rms_m,
               1e3 * x->sat[i].max_m, orr_time_text(x->sat[i].worst, when));
    }
    if (with_inputs)
        printf("\nat epochs that were input: %zu; left out: %zu without an orbit in the product\n", x->inputs,
               x->no_orbit);
    else
        printf("\nleft out: %zu positions at epochs that were input, %zu without an orbit in the product\n",
               x->inputs, x->no_orbit);
    if (x->between > 0) printf("in no place: %zu samples between 45 min and 2 h from an end\n", x->between);
}

// A datum difference looks like an orbit error; names that differ are worth a word.
static void check_frame(const orr_cli *c, const orr_ephemeris *e, const orr_sp3 *truth, const char *path)
{
    const char *frame = orr_ephemeris_frame(e);
    if (frame[0] == '\0' || truth->coordinates[0] == '\0' || strncmp(frame, truth->coordinates, 5) == 0)
        return;
    orr_cli_failf(c, "warning: %s is in %s, the product in %s", path, truth->coordinates, frame);
}

static int compare(orr_cli *c, const orr_ephemeris *e, orr_sp3 *truth, size_t n)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    for (size_t i = 0; i < n; i++) {
        const char *path = c->operand[i + 1];
        orr_cli_progress(c, "reading", i, n);
        orr_status s = orr_sp3_read(path, NULL, &truth[i], &warnings, &diag);
        orr_cli_progress(c, "reading", n, n);
        if (s != ORR_OK) {
            orr_warnings_free(&warnings);
            return orr_cli_fail(c, &diag);
        }
        check_frame(c, e, &truth[i], path);
    }
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    orr_comparison x;
    const orr_compare_options o = {.derive_velocity =
                                       strcmp(orr_cli_text(c, "velocity", "records"), "positions") == 0,
                                   .with_inputs = orr_cli_given(c, "inputs")};
    const orr_status s = orr_compare(e, truth, n, &o, &x, &diag);
    if (s != ORR_OK) {
        const int failed = orr_cli_fail(c, &diag);
        if (s == ORR_E_NODATA && !o.with_inputs)
            orr_cli_say(c, "(with --inputs, epochs that the product was made from are compared as well)");
        return failed;
    }
    int status = ORR_EXIT_OK;
    if (orr_cli_says(c, "format", "json"))
        status = print_json(c, &x);
    else
        print_human(c, &x);
    orr_comparison_free(&x);
    return status;
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    size_t n = (size_t)c->n_operands - 1;
    if (orr_ephemeris_load(c->operand[0], &e, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    orr_sp3 *truth = calloc(n, sizeof *truth);
    int status = truth != NULL ? compare(c, e, truth, n) : orr_cli_failf(c, "out of memory");
    for (size_t i = 0; i < n && truth != NULL; i++) orr_sp3_free(&truth[i]);
    free(truth);
    orr_ephemeris_free(e);
    return status;
}

static const orr_option options[] = {
    {.name = "velocity",
     .kind = ORR_OPT_CHOICE,
     .value = "records|positions",
     .help = "Velocity of the truth. records (default): its V records where it has them. positions: always "
             "the derivative of its positions."},
    {.name = "inputs",
     .kind = ORR_OPT_FLAG,
     .help = "Compare also at epochs that the product was made from, for orbits of another centre."},
    ORR_OPTION_REPORT,
};

const orr_command orr_cmd_compare = {
    .name = "compare",
    .group = "Orbits",
    .summary = "tell how far an orbit product is from precise orbits",
    .operands = "PRODUCT TRUTH.sp3...",
    .min_operands = 2,
    .max_operands = -1,
    .about = "Epochs that the product was made from are left out, unless --inputs asks for them. Places: "
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
             "equator, 6e-5 m/s): --velocity positions tells.\n\n"
             "JSON keys: systems.G.inner.{n,satellites,rms_mm,p95_mm,max_mm,vel_n,vel_rms_mps,mean_mm}, the "
             "same for edge and gap "
             "and for each system; satellites; left_out.",
    .example = "orrery orbit -o day.nc --nodes 900 COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz\n"
               "orrery compare day.nc COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

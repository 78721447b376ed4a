// SPDX-License-Identifier: GPL-3.0-or-later
// orrery elements: Kepler elements of the product's satellites as functions of time.
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "core/outfile.h"
#include "src/archive/store.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/elements_periods.h"
#include "src/cli/orbit/elements_rows.h"
#include "src/make/elements.h"

// A NetCDF file is written from memory.
#define MOST_ROWS_IN_MEMORY ((size_t)2000 * 1000 * 1000 / sizeof(orr_elements_row))

// What --fifteen has beside the six elements, in all formats; rates by the day.
#define PER_DAY (ORR_DEG_PER_RAD * ORR_S_PER_DAY)
static const struct {
    const char *name, *units, *long_name;
    size_t offset;
    double scale;
} EXTRA[] = {
    {"delta_n_degpd", "degree day-1", "mean motion beyond that of the semi-major axis",
     offsetof(orr_mean_elements, delta_n_radps), PER_DAY},
    {"idot_degpd", "degree day-1", "rate of the inclination", offsetof(orr_mean_elements, idot_radps),
     PER_DAY},
    {"raan_dot_degpd", "degree day-1", "rate of the right ascension of the ascending node",
     offsetof(orr_mean_elements, raan_dot_radps), PER_DAY},
    {"crc_m", "m", "cosine amplitude of the radius at twice the argument of latitude",
     offsetof(orr_mean_elements, crc_m), 1},
    {"crs_m", "m", "sine amplitude of the radius", offsetof(orr_mean_elements, crs_m), 1},
    {"cuc_rad", "rad", "cosine amplitude of the argument of latitude", offsetof(orr_mean_elements, cuc_rad),
     1},
    {"cus_rad", "rad", "sine amplitude of the argument of latitude", offsetof(orr_mean_elements, cus_rad), 1},
    {"cic_rad", "rad", "cosine amplitude of the inclination", offsetof(orr_mean_elements, cic_rad), 1},
    {"cis_rad", "rad", "sine amplitude of the inclination", offsetof(orr_mean_elements, cis_rad), 1},
    {"rms_m", "m", "what the elements leave of the revolution", offsetof(orr_mean_elements, rms_m), 1},
};
enum { EXTRAS = sizeof EXTRA / sizeof EXTRA[0] };

static double extra_of(const orr_elements_row *row, size_t k)
{
    double x;
    memcpy(&x, (const char *)&row->mean + EXTRA[k].offset, sizeof x);
    return x * EXTRA[k].scale;
}

typedef struct table {
    orr_elements_row *item;
    size_t n, room;
} table;

// Sinks of orr_elements_make.
static orr_status keep_row(void *user, const orr_elements_row *row, orr_diag *diag)
{
    table *t = user;
    if (t->n == MOST_ROWS_IN_MEMORY)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "more than %zu rows are too many for a NetCDF file; CSV and JSON have no limit",
                            t->n);
    if (t->n == t->room) {
        size_t room = t->room > 0 ? 2 * t->room : 1024;
        orr_elements_row *item = realloc(t->item, room * sizeof *item);
        if (item == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu rows", room);
        t->item = item;
        t->room = room;
    }
    t->item[t->n++] = *row;
    return ORR_OK;
}

typedef struct text_sink {
    FILE *stream;
    const char *path;
    bool fifteen;
    size_t n;
} text_sink;

static orr_status check_stream(const text_sink *k, orr_diag *diag)
{
    return ferror(k->stream) == 0 ? ORR_OK
                                  : orr_diag_at(diag, ORR_E_IO, k->path, 0, 0, "cannot be written: %s",
                                                strerror(errno != 0 ? errno : EIO));
}

static orr_status print_csv_row(void *user, const orr_elements_row *row, orr_diag *diag)
{
    text_sink *k = user;
    char sat[ORR_SAT_TEXT];
    if (k->n++ == 0) {
        orr_elements_csv_head(k->stream);
        for (size_t i = 0; k->fifteen && i < EXTRAS; i++) fprintf(k->stream, ",%s", EXTRA[i].name);
        fputc('\n', k->stream);
    }
    orr_elements_csv_row(k->stream, row->t, orr_sat_text(row->sat, sat), &row->k);
    for (size_t i = 0; k->fifteen && i < EXTRAS; i++) fprintf(k->stream, ",%.9g", extra_of(row, i));
    fputc('\n', k->stream);
    return check_stream(k, diag);
}

static orr_status print_json_row(void *user, const orr_elements_row *row, orr_diag *diag)
{
    text_sink *s = user;
    const orr_kepler *k = &row->k;
    char time[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    fprintf(s->stream,
            "%s\n {\"t_gps\": \"%s\", \"sat\": \"%s\", \"a_m\": %.4f, \"e\": %.12f, \"i_deg\": %.10f, "
            "\"raan_deg\": %.10f, "
            "\"argp_deg\": %.10f, \"m_deg\": %.10f, \"u_deg\": %.10f",
            s->n++ > 0 ? "," : "[", orr_time_text(row->t, time), orr_sat_text(row->sat, sat), k->a_m, k->e,
            k->i_rad * ORR_DEG_PER_RAD, orr_elements_degrees(k->raan_rad), orr_elements_degrees(k->argp_rad),
            orr_elements_degrees(k->m_rad), orr_elements_degrees(k->u_rad));
    for (size_t i = 0; s->fifteen && i < EXTRAS; i++)
        fprintf(s->stream, ", \"%s\": %.9g", EXTRA[i].name, extra_of(row, i));
    fputc('}', s->stream);
    return check_stream(s, diag);
}

// What a NetCDF file tells of itself besides its rows.
static orr_status put_about(orr_nc_writer *w, const orr_cli *c, const orr_elements_plan *plan,
                            const orr_inputs *inputs, orr_diag *diag)
{
    orr_nc_input *input = orr_inputs_provenance(inputs);
    if (input == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_status s =
        orr_nc_put_provenance(w, "Kepler elements of navigation satellites", c->call, input, inputs->n, diag);
    if (s == ORR_OK) s = orr_nc_put_att_text(w, NULL, "product", "elements", diag);
    if (s == ORR_OK) s = orr_nc_put_att_text(w, NULL, "axes", orr_cli_text(c, "frame", "date"), diag);
    if (s == ORR_OK)
        s = orr_nc_put_att_text(w, NULL, "method",
                                plan->fifteen ? "fifteen" : orr_cli_text(c, "method", "state"), diag);
    if (s == ORR_OK && plan->method == ORR_ELEMENTS_THREE_POSITIONS)
        s = orr_nc_put_att_double(w, NULL, "spacing_s", &plan->spacing_s, 1, diag);
    free(input);
    return s;
}

static orr_status write_nc(const orr_cli *c, const orr_elements_plan *plan, const char *path, const table *t,
                           const orr_inputs *inputs, orr_diag *diag)
{
    orr_nc_writer w;
    orr_status s = orr_nc_create(path, &w, diag);
    if (s != ORR_OK) return s;
    static const char *const by_row[] = {"obs", "sat_text"};
    double *value = malloc((t->n + 1) * sizeof *value);
    char *name = calloc(t->n + 1, 3);
    int64_t *time = malloc((t->n + 1) * sizeof *time);
    if (value == NULL || name == NULL || time == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK) s = orr_nc_put_dim(&w, "obs", t->n, diag);
    if (s == ORR_OK) s = orr_nc_put_dim(&w, "sat_text", 3, diag);
    for (size_t i = 0; i < t->n && s == ORR_OK; i++) {
        char text[ORR_SAT_TEXT];
        memcpy(name + 3 * i, orr_sat_text(t->item[i].sat, text), 3);
        time[i] = t->item[i].t;
    }
    if (s == ORR_OK)
        s = orr_nc_put_var(&w, "time", ORR_NC_INT64, 1, by_row, time, "nanoseconds since 1980-01-06 00:00:00",
                           "instant, GPS time", diag);
    if (s == ORR_OK) s = orr_nc_put_att_text(&w, "time", "calendar", "standard", diag);
    if (s == ORR_OK) s = orr_nc_put_var(&w, "sat", ORR_NC_CHAR, 2, by_row, name, NULL, "satellite", diag);
    static const struct {
        const char *name, *units, *long_name;
        size_t offset;
        double scale;
        bool angle;
    } column[] = {
        {"a", "m", "semi-major axis", offsetof(orr_kepler, a_m), 1, false},
        {"e", "1", "eccentricity", offsetof(orr_kepler, e), 1, false},
        {"i", "degree", "inclination", offsetof(orr_kepler, i_rad), ORR_DEG_PER_RAD, false},
        {"raan", "degree", "right ascension of the ascending node", offsetof(orr_kepler, raan_rad), 1, true},
        {"argp", "degree", "argument of perigee", offsetof(orr_kepler, argp_rad), 1, true},
        {"m", "degree", "mean anomaly", offsetof(orr_kepler, m_rad), 1, true},
        {"u", "degree", "argument of latitude", offsetof(orr_kepler, u_rad), 1, true},
    };
    for (size_t k = 0; k < sizeof column / sizeof column[0] && s == ORR_OK; k++) {
        for (size_t i = 0; i < t->n; i++) {
            double x;
            memcpy(&x, (const char *)&t->item[i].k + column[k].offset, sizeof x);
            value[i] = column[k].angle ? orr_elements_degrees(x) : x * column[k].scale;
        }
        s = orr_nc_put_var(&w, column[k].name, ORR_NC_DOUBLE, 1, by_row, value, column[k].units,
                           column[k].long_name, diag);
    }
    for (size_t k = 0; plan->fifteen && k < EXTRAS && s == ORR_OK; k++) {
        for (size_t i = 0; i < t->n; i++) value[i] = extra_of(&t->item[i], k);
        s = orr_nc_put_var(&w, EXTRA[k].name, ORR_NC_DOUBLE, 1, by_row, value, EXTRA[k].units,
                           EXTRA[k].long_name, diag);
    }
    if (s == ORR_OK) s = put_about(&w, c, plan, inputs, diag);
    free(value);
    free(name);
    free(time);
    if (s == ORR_OK) return orr_nc_commit(&w, diag);
    orr_nc_abort(&w);
    return s;
}

static orr_status to_text(const orr_elements_plan *plan, const char *path, bool json,
                          elements_periods *periods, size_t *n, orr_warnings *warnings, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    text_sink k = {.stream = out.stream, .path = path, .fifteen = plan->fifteen};
    periods->next = json ? print_json_row : print_csv_row;
    periods->user = &k;
    s = orr_elements_make(plan, elements_periods_take, periods, n, NULL, warnings, diag);
    if (s == ORR_OK && json) fputs("\n]\n", out.stream);
    return orr_outfile_end(&out, s, diag);
}

static orr_status to_nc(const orr_cli *c, const orr_elements_plan *plan, const char *path, size_t *n,
                        orr_warnings *warnings, orr_diag *diag)
{
    table t = {0};
    orr_inputs inputs = {0};
    orr_status s = orr_elements_make(plan, keep_row, &t, n, &inputs, warnings, diag);
    if (s == ORR_OK) s = write_nc(c, plan, path, &t, &inputs, diag);
    free(t.item);
    orr_inputs_free(&inputs);
    return s;
}

// Products of an archive's days from --from to --to, ascending; to be freed one by one.
static orr_status days_of_archive(const orr_cli *c, char ***path, size_t *n, orr_diag *diag)
{
    const char *archive = orr_cli_text(c, "archive", NULL);
    const int32_t first =
                      orr_cli_given(c, "from") ? orr_archive_day_of(orr_cli_time(c, "from", 0)) : INT32_MIN,
                  last = orr_cli_given(c, "to") ? orr_archive_day_of(orr_cli_time(c, "to", 0)) : INT32_MAX;
    int32_t *day = NULL;
    size_t n_days = 0;
    orr_status s = orr_archive_days(archive, &day, &n_days, diag);
    *path = calloc(n_days + 1, sizeof **path);
    if (s == ORR_OK && *path == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t i = 0; s == ORR_OK && i < n_days; i++) {
        char text[ORR_ARCHIVE_PATH];
        if (day[i] < first || day[i] > last) continue;
        (*path)[*n] = strdup(orr_archive_path(archive, day[i], "orbit.nc", text));
        if ((*path)[*n] == NULL)
            s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        else
            ++*n;
    }
    if (s == ORR_OK && *n == 0) s = orr_diag_at(diag, ORR_E_NODATA, archive, 0, 0, "has no day of the span");
    free(day);
    return s;
}

static int run_of(orr_cli *c, const char *const *product, size_t n_products)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    const char *format = orr_cli_text(c, "format", "csv"), *path = orr_cli_text(c, "output", "-");
    const bool nc = strcmp(format, "nc") == 0;
    const char *spectrum = orr_cli_text(c, "periods", NULL);
    if (nc && strcmp(path, "-") == 0) return orr_cli_usage(c, "--format nc needs a file: -o FILE");
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
    const orr_elements_plan plan = {
        .product = product,
        .n_products = n_products,
        .leap = c->leap,
        .erp = orr_cli_text(c, "erp", NULL),
        .frame = orr_elements_frame_of(orr_cli_text(c, "frame", "date")),
        .method = orr_elements_method_of(orr_cli_text(c, "method", "state")),
        .fifteen = orr_cli_given(c, "fifteen"),
        .spacing_s = (double)orr_cli_duration_ns(c, "spacing", 300 * ORR_NS_PER_S) * 1e-9,
        .from = orr_cli_time(c, "from", ORR_TIME_NONE),
        .to = orr_cli_time(c, "to", ORR_TIME_NONE),
        .step_ns = orr_cli_duration_ns(c, "step", 60 * ORR_NS_PER_S),
        .sats = orr_cli_sats(c, "sat"),
    };
    if (plan.spacing_s < ORR_MAKE_ELEMENTS_LEAST_SPACING_S)
        return orr_cli_usage(c, "--spacing: at least %g s; closer positions do not define a plane",
                             ORR_MAKE_ELEMENTS_LEAST_SPACING_S);
    size_t n = 0;
    elements_periods periods = {.keeps = spectrum != NULL};
    orr_status s = nc ? to_nc(c, &plan, path, &n, &warnings, &diag)
                      : to_text(&plan, path, strcmp(format, "json") == 0, &periods, &n, &warnings, &diag);
    if (s == ORR_OK && spectrum != NULL)
        s = elements_periods_write(c, &periods, (double)plan.step_ns * 1e-9 / ORR_S_PER_DAY, spectrum, &diag);
    elements_periods_free(&periods);
    if (s == ORR_OK && strcmp(path, "-") != 0) orr_cli_say(c, "%s: %zu rows", path, n);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static int run(orr_cli *c)
{
    if (orr_cli_given(c, "archive") == (c->n_operands > 0))
        return orr_cli_usage(c, "products, or --archive: one of them is needed");
    if (c->n_operands > 0) return run_of(c, (const char *const *)c->operand, (size_t)c->n_operands);
    char **path = NULL;
    size_t n = 0;
    orr_diag diag = {0};
    const orr_status s = days_of_archive(c, &path, &n, &diag);
    const int status = s == ORR_OK ? run_of(c, (const char *const *)path, n) : orr_cli_fail(c, &diag);
    for (size_t i = 0; i < n; i++) free(path[i]);
    free(path);
    return status;
}

static const orr_option options[] = {
    {.name = "archive",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Instead of products: all days of an archive (orrery batch) from --from to --to, one at a time "
             "in memory."},
    ORR_OPTION_SATS,
    {.name = "method",
     .fallback = "state",
     .kind = ORR_OPT_CHOICE,
     .value = ORR_ELEMENTS_METHODS,
     .help = "How elements are made. state (default): osculating elements of position and velocity. "
             "three-positions: the plane through three positions --spacing apart and the standard formulas; "
             "the plane is good to 4e-6 deg, but a is off by about 2 km (J2), and e and argp with it. mean: "
             "osculating elements averaged over one revolution, half of it to each side."},
    {.name = "fifteen",
     .kind = ORR_OPT_FLAG,
     .applies = "!method",
     .help = "The fifteen mean elements of the revolution about each instant, fitted to the orbit by the "
             "model that "
             "GPS' messages have (IS-GPS-200, table 20-IV): besides six elements the rates of mean motion, "
             "inclination and node, amplitudes of radius, argument of latitude and inclination at twice the "
             "argument of latitude, and what they leave of the orbit."},
    {.name = "frame",
     .kind = ORR_OPT_CHOICE,
     .value = ORR_ELEMENTS_FRAMES,
     .help = "The axes. date (default): true equator and equinox of date. j2000: GCRS. ecef: Earth-fixed "
             "axes of the instant, held fixed (for mean: of the middle of its revolution)."},
    ORR_OPTION_STEP(.help = "Time from one row to the next; 60 s by default."),
    {.name = "spacing",
     .applies = "method=three-positions",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Distance of the three positions, from 10 s to a quarter of a revolution; 300 s by default."},
    ORR_OPTION_FROM(.help = "First instant; where the products begin by default."),
    ORR_OPTION_TO(.help = "Last instant; where the products end by default."),
    ORR_OPTION_ERP(
            .help = "Earth rotation parameters; by default what the product was made with, which it holds."),
    {.name = "periods",
     .applies = "format=csv|json",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .writes = true,
     .help = "Also write the periods in a, e and i of each satellite as CSV: amplitudes by least squares, "
             "plain and with Hann's window, "
             "beside a cubic trend, from three steps to "
             "two thirds of the span."},
    ORR_OPTION_FORMAT("csv|json|nc", "csv"),
    ORR_OPTION_OUTPUT,
};

const orr_command orr_cmd_elements = {
    .name = "elements",
    .group = "Orbits",
    .summary = "print Kepler elements as functions of time",
    .operands = "PRODUCT...",
    .min_operands = 0, // of --archive
    .max_operands = -1,
    .about = "Reads products of `orrery orbit`, one after the other in time, and tells a, e, i, the node, "
             "perigee, "
             "mean anomaly and "
             "argument of latitude u. In near-circular orbits argp and m are ill-determined one by one; read "
             "u.\n\n"
             "Instants at which the method lacks data (an end of the arc, a manoeuvre) have no row; days "
             "smoothed jointly have no ends between them.",
    .example = "orrery elements day.nc --sat G05 --step 300\norrery elements week*.nc --sat R07 --method "
               "mean --step 3600 -o r07.csv\n"
               "orrery elements --archive archive --sat R07 --from 2020-01-01 --to 2020-12-31 --step 3600 -o "
               "r07.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

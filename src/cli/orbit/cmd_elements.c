// SPDX-License-Identifier: GPL-3.0-or-later
// orrery elements: Kepler elements of the product's satellites as functions of time.
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "core/outfile.h"
#include "ingest/tables/erp.h"
#include "src/cli/frame/cli.h"
#include "src/cli/orbit/elements_rows.h"

#define LEAST_SPACING_S 10

typedef struct row {
    orr_time t;
    orr_sat sat;
    orr_kepler k;
} row;

typedef struct table {
    row *item;
    size_t n, room;
} table;

static orr_status add_row(table *t, row r, orr_diag *diag)
{
    if (t->n == t->room) {
        size_t room = t->room > 0 ? 2 * t->room : 1024;
        row *item = realloc(t->item, room * sizeof *item);
        if (item == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu rows", room);
        t->item = item;
        t->room = room;
    }
    t->item[t->n++] = r;
    return ORR_OK;
}

// A product on the command line and what it covers.
typedef struct product {
    const char *path;
    orr_time from, to;
} product;

static int by_begin(const void *a, const void *b)
{
    const product *x = a, *y = b;
    if (x->from != y->from) return x->from < y->from ? -1 : 1;
    return (x->to > y->to) - (x->to < y->to);
}

// Spans first, so that rows come in order of time however the products are named.
static orr_status put_in_order(const orr_cli *c, product *list, orr_diag *diag)
{
    for (int k = 0; k < c->n_operands; k++) {
        orr_ephemeris *e = NULL;
        list[k].path = c->operand[k];
        orr_status s = orr_ephemeris_load(list[k].path, &e, diag);
        if (s != ORR_OK) return s;
        orr_ephemeris_span(e, &list[k].from, &list[k].to);
        orr_ephemeris_free(e);
    }
    qsort(list, (size_t)c->n_operands, sizeof *list, by_begin);
    return ORR_OK;
}

// Rows of one product, from its begin (or `after`, the last instant of the product before) on, where the
// method has values.
static orr_status collect(const orr_cli *c, const orr_ephemeris *e, const orr_elements_options *o,
                          int64_t step, orr_time after, table *t, orr_diag *diag)
{
    const orr_sat *list;
    size_t n = orr_ephemeris_satellites(e, &list);
    const orr_sat_set *wanted = orr_cli_sats(c, "sat");
    orr_time begin, end;
    orr_ephemeris_span(e, &begin, &end);
    orr_time at = orr_cli_time(c, "from", begin), to = orr_cli_time(c, "to", end);
    if (after != ORR_TIME_NONE && begin <= after) begin = after + 1;
    if (to > end) to = end;
    if (at < begin) { // the first of the rows within
        const int64_t steps = (begin - at - 1) / step + 1;
        if (to < begin || steps > (to - at) / step) return ORR_OK;
        at += steps * step;
    }
    orr_status s = ORR_OK;
    for (; at <= to; at += step) {
        orr_elements_axes axes;
        orr_elements_axes_at(at, o, &axes);
        for (size_t i = 0; i < n && s == ORR_OK; i++) {
            row r = {.t = at, .sat = list[i]};
            if (wanted != NULL && !orr_sat_set_has(wanted, list[i])) continue;
            if (orr_elements_of(e, list[i], &axes, &r.k) == ORR_OK) s = add_row(t, r, diag);
        }
        if (s != ORR_OK || to - at < step) break; // the next row may lie beyond what an orr_time holds
    }
    return s;
}

static void print_csv(FILE *f, const table *t)
{
    char sat[ORR_SAT_TEXT];
    orr_elements_csv_head(f);
    for (size_t i = 0; i < t->n; i++)
        orr_elements_csv_row(f, t->item[i].t, orr_sat_text(t->item[i].sat, sat), &t->item[i].k);
}

static void print_json(FILE *f, const table *t)
{
    char time[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    fputs("[", f);
    for (size_t i = 0; i < t->n; i++) {
        const orr_kepler *k = &t->item[i].k;
        fprintf(f,
                "%s\n {\"t_gps\": \"%s\", \"sat\": \"%s\", \"a_m\": %.4f, \"e\": %.12f, \"i_deg\": %.10f, "
                "\"raan_deg\": %.10f, "
                "\"argp_deg\": %.10f, \"m_deg\": %.10f, \"u_deg\": %.10f}",
                i > 0 ? "," : "", orr_time_text(t->item[i].t, time), orr_sat_text(t->item[i].sat, sat),
                k->a_m, k->e, k->i_rad * ORR_DEG_PER_RAD, orr_elements_degrees(k->raan_rad),
                orr_elements_degrees(k->argp_rad), orr_elements_degrees(k->m_rad),
                orr_elements_degrees(k->u_rad));
    }
    fputs("\n]\n", f);
}

static orr_status write_nc(const char *path, const table *t, const char *about, orr_diag *diag)
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
        s = orr_nc_put_var(&w, "time", ORR_NC_INT64, 1, by_row, time, "ns",
                           "nanoseconds of GPS time since 1980-01-06", diag);
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
    if (s == ORR_OK)
        s = orr_nc_put_provenance(&w, "Kepler elements of navigation satellites", about, NULL, 0, diag);
    free(value);
    free(name);
    free(time);
    if (s == ORR_OK) return orr_nc_commit(&w, diag);
    orr_nc_abort(&w);
    return s;
}

static orr_status read_eop(const orr_cli *c, orr_erp *erp, orr_elements_options *o, orr_warnings *w,
                           orr_diag *diag)
{
    const char *path = orr_cli_text(c, "erp", NULL);
    if (path == NULL) return ORR_OK;
    orr_status s = orr_erp_read(path, NULL, NULL, erp, w, diag);
    if (s == ORR_OK) o->eop = &erp->series;
    return s;
}

static orr_status write_text(const char *path, const table *t, const char *format, orr_diag *diag)
{
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    if (strcmp(format, "json") == 0)
        print_json(out.stream, t);
    else
        print_csv(out.stream, t);
    return orr_outfile_commit(&out, diag);
}

static void warn_of_eop(const orr_eop_series *eop, const product *list, int n, orr_warnings *warnings)
{
    char when[ORR_TIME_TEXT];
    for (int k = 0; k < n; k++) {
        bool begin, end;
        orr_eop_at(eop, list[k].from, NULL, &begin);
        orr_eop_at(eop, list[k].to, NULL, &end);
        if (begin && end) continue;
        orr_warnings_add(warnings, list[k].path, 0, 0,
                         "the Earth rotation given does not cover %s; it is carried on beyond its ends",
                         orr_time_text(begin ? list[k].to : list[k].from, when));
    }
}

static orr_status collect_all(const orr_cli *c, const orr_elements_options *o, product *list, table *t,
                              orr_warnings *warnings, orr_diag *diag)
{
    const int64_t step = orr_cli_duration_ns(c, "step", 60 * ORR_NS_PER_S);
    orr_time after = ORR_TIME_NONE;
    orr_status s = put_in_order(c, list, diag);
    if (s == ORR_OK && o->eop != NULL) warn_of_eop(o->eop, list, c->n_operands, warnings);
    for (int k = 0; k < c->n_operands && s == ORR_OK; k++) {
        orr_ephemeris *e = NULL;
        s = orr_ephemeris_load(list[k].path, &e, diag);
        if (s == ORR_OK && orr_cli_interrupted(c)) s = orr_diag_set(diag, ORR_E_INTERRUPTED, "stopped");
        if (s == ORR_OK) s = collect(c, e, o, step, after, t, diag);
        if (s == ORR_OK && t->n > 0) after = t->item[t->n - 1].t;
        orr_ephemeris_free(e);
    }
    if (s != ORR_OK || t->n > 0) return s;
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    return orr_diag_set(
        diag, ORR_E_NODATA,
        "no elements: the first product covers %s to %s; no such satellite, or no instant where the "
        "method has what it needs around it",
        orr_time_text(list[0].from, from), orr_time_text(list[0].to, to));
}

static int run(orr_cli *c)
{
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_erp erp = {0};
    table t = {0};
    const char *format = orr_cli_text(c, "format", "csv"), *path = orr_cli_text(c, "output", "-");
    if (strcmp(format, "nc") == 0 && strcmp(path, "-") == 0)
        return orr_cli_usage(c, "--format nc needs a file: -o FILE");
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
    if (orr_cli_duration_ns(c, "spacing", 300 * ORR_NS_PER_S) < LEAST_SPACING_S * ORR_NS_PER_S)
        return orr_cli_usage(c, "--spacing: at least %d s, or three positions are one", LEAST_SPACING_S);
    orr_elements_options o = {.frame = orr_elements_frame_of(orr_cli_text(c, "frame", "date")),
                              .method = orr_elements_method_of(orr_cli_text(c, "method", "state")),
                              .spacing_s =
                                  (double)orr_cli_duration_ns(c, "spacing", 300 * ORR_NS_PER_S) * 1e-9};
    product *list = calloc((size_t)c->n_operands, sizeof *list);
    orr_cli_hold(c);
    orr_status s = list != NULL ? read_eop(c, &erp, &o, &warnings, &diag)
                                : orr_diag_set(&diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK) s = collect_all(c, &o, list, &t, &warnings, &diag);
    if (s == ORR_OK)
        s = strcmp(format, "nc") == 0 ? write_nc(path, &t, "orrery elements", &diag)
                                      : write_text(path, &t, format, &diag);
    if (s == ORR_OK && strcmp(path, "-") != 0) orr_cli_say(c, "%s: %zu rows", path, t.n);
    orr_cli_release(c);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    orr_erp_free(&erp);
    free(list);
    free(t.item);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "sat",
     .kind = ORR_OPT_SATS,
     .value = "LIST",
     .help = "Satellites, e.g. G05,R or all; all by default."},
    {.name = "method",
     .kind = ORR_OPT_CHOICE,
     .value = ORR_ELEMENTS_METHODS,
     .help = "state (default): osculating, from position and velocity. three-positions: the plane through "
             "three positions "
             "--spacing apart and the standard formulas; the plane is good to 4e-6 deg, but a is off by "
             "about 2 km (J2) and e and "
             "argp with it. mean: osculating averaged over one revolution, half of it to each side."},
    {.name = "frame",
     .kind = ORR_OPT_CHOICE,
     .value = ORR_ELEMENTS_FRAMES,
     .help = "date (default): true equator and equinox of date. j2000: GCRS. ecef: Earth-fixed axes of the "
             "instant, frozen there (for mean: at the middle of its revolution)."},
    {.name = "step", .kind = ORR_OPT_DURATION, .value = "S", .help = "Distance of rows; 60 s by default."},
    {.name = "spacing",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "Distance of the three positions, from 10 s to a quarter of a revolution; 300 s by default."},
    {.name = "from",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "First instant; the product's begin by default."},
    {.name = "to", .kind = ORR_OPT_TIME, .value = "T", .help = "Last instant; the product's end by default."},
    {.name = "erp",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Earth orientation; the IERS secular pole by default."},
    {.name = "format", .kind = ORR_OPT_CHOICE, .value = "csv|json|nc", .help = "csv by default."},
    {.name = "output",
     .letter = 'o',
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Where it goes; standard output by default."},
};

const orr_command orr_cmd_elements = {
    .name = "elements",
    .group = "Orbits",
    .summary = "print Kepler elements as functions of time",
    .operands = "PRODUCT...",
    .min_operands = 1,
    .max_operands = -1,
    .about = "Reads products of `orrery orbit`, one after the other in time, and tells a, e, i, the node, "
             "perigee, "
             "mean anomaly and "
             "argument of latitude u. In near-circular orbits argp and m are ill-determined one by one; read "
             "u.\n\n"
             "Instants at which the method lacks data (an end of the arc, a manoeuvre) have no row; days "
             "smoothed jointly have no ends between them.",
    .example = "orrery elements day.nc --sat G05 --step 300\norrery elements week*.nc --sat R07 --method "
               "mean --step 3600 -o r07.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

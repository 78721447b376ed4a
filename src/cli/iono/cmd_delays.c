// SPDX-License-Identifier: GPL-3.0-or-later
// orrery delays: what the service answers to POLL_DELAYS over a span, as a table, without a service: a station's sky or a
// flight's.
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/nan.h"
#include "core/ncfile.h"
#include "core/outfile.h"
#include "core/sha256.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/scenario/engine/engine.h"

#define MOST_EPOCHS 10000000
#define MOST_ROWS 20000000 // of a NetCDF file, which is gathered first

typedef struct row {
    orr_time t;
    double range_m;
    orr_realisation delay;
} row;

// A call: what was asked, and the rows until they are written.
typedef struct job {
    orr_cli *c;
    orr_scenario scenario;
    orr_engine *engine;
    orr_time from, to;
    int64_t step_ns;
    double mask_rad, carrier_hz;
    bool has_place;
    orr_vec3 place_m;
    FILE *csv; // NULL: gathered for NetCDF
    row *row;
    size_t n;
} job;

static const char *const ORIGIN[] = {"field", "fused", "transferred", "noise"};

// A YAML text in double quotes; false where it does not fit.
static bool quoted(char *out, size_t room, const char *key, const char *text)
{
    size_t n = (size_t)snprintf(out, room, "%s: \"", key);
    for (; *text != '\0' && n + 4 < room; text++) {
        if (*text == '"' || *text == '\\') out[n++] = '\\';
        out[n++] = *text;
    }
    if (*text != '\0' || n + 2 >= room) return false;
    out[n++] = '"';
    out[n] = '\0';
    return true;
}

// A scenario of the files that the options name.
static orr_status scenario_of_options(job *j, orr_diag *diag)
{
    enum { ROOM = 8192 };
    char product[ROOM], source[ROOM], text[2 * ROOM + 64];
    const char *field = orr_cli_text(j->c, "field", NULL), *session = orr_cli_text(j->c, "session", NULL);
    if (!quoted(product, sizeof product, "product", j->c->operand[0]) ||
        !quoted(source, sizeof source, field != NULL ? "field" : "session", field != NULL ? field : session))
        return orr_diag_set(diag, ORR_E_LIMIT, "the names of the files are too long");
    int n = snprintf(text, sizeof text, "orbit: {%s}\nnavdata: {window: none}\nionosphere: {%s}\n", product,
                     source);
    return orr_scenario_parse("options", text, (size_t)n, ".", j->c->leap, &j->scenario, diag);
}

static orr_status open_engine(job *j, orr_diag *diag)
{
    bool direct = orr_cli_given(j->c, "field") || orr_cli_given(j->c, "session");
    orr_status s = direct ? scenario_of_options(j, diag)
                          : orr_scenario_read(j->c->operand[0], j->c->leap, &j->scenario, diag);
    if (s == ORR_OK) s = orr_cli_tree_check(j->c, orr_scenario_schema(), &j->scenario, diag);
    if (s != ORR_OK) return s;
    orr_warnings warnings = {0};
    s = orr_engine_open(&j->scenario, j->c->log, NULL, &warnings, &j->engine, diag);
    orr_cli_warnings(j->c, &warnings);
    orr_warnings_free(&warnings);
    if (s == ORR_OK && !orr_engine_has_ionosphere(j->engine))
        s = orr_diag_set(diag, ORR_E_ARG, "%s has no ionosphere; name a field or a session in it",
                         j->c->operand[0]);
    if (s == ORR_OK && !j->has_place && orr_engine_receiver_kind(j->engine, NULL) == ORR_RECEIVER_NONE)
        s = orr_diag_set(diag, ORR_E_ARG,
                         "where is the receiver? --receiver LAT,LON,H, or a receiver, a trajectory or a "
                         "session in the scenario");
    return s;
}

// From and to, by default what orbits, ionosphere and a flying receiver have in common.
static orr_status settle_span(job *j, orr_diag *diag)
{
    static const orr_engine_part parts[] = {ORR_PART_ORBITS, ORR_PART_IONOSPHERE, ORR_PART_MOTION};
    orr_time from = INT64_MIN, to = INT64_MAX;
    orr_span span;
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (orr_engine_part_span(j->engine, parts[k], &span)) {
            if (span.from > from) from = span.from;
            if (span.to < to) to = span.to;
        }
    // The first whole step.
    int64_t over = from % j->step_ns;
    if (over != 0) from += over > 0 ? j->step_ns - over : -over;
    j->from = orr_cli_time(j->c, "from", from);
    j->to = orr_cli_time(j->c, "to", to);
    if (j->to < j->from)
        return orr_diag_set(diag, ORR_E_RANGE, "orbits, ionosphere and receiver have no instant in common");
    uint64_t epochs = ((uint64_t)j->to - (uint64_t)j->from) / (uint64_t)j->step_ns + 1;
    if (epochs > MOST_EPOCHS)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "%" PRIu64 " epochs are more than the %d of one call; take a longer --step",
                            epochs, MOST_EPOCHS);
    return ORR_OK;
}

static void csv_head(const job *j)
{
    fprintf(j->csv,
            "t_gps,sat,az_deg,el_deg,range_m,stec_tecu,vtec_tecu,mapping,sigma_tecu,delay_m,origin\n");
}

static void csv_row(const job *j, const row *r)
{
    char time[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    const orr_realisation *d = &r->delay;
    fprintf(j->csv, "%s,%s,%.6f,%.6f,%.4f,%.5f,%.5f,%.6f,", orr_time_text(r->t, time),
            orr_sat_text(d->sat, sat), d->pierce.az_rad * ORR_DEG_PER_RAD, d->pierce.el_rad * ORR_DEG_PER_RAD,
            r->range_m, d->stec_tecu, d->vtec_tecu, d->mapping);
    if (!isnan(d->sigma_tecu)) fprintf(j->csv, "%.4f", d->sigma_tecu);
    fprintf(j->csv, ",%.5f,%s\n", orr_iono_delay_m(d->stec_tecu, j->carrier_hz, ORR_MEASURES_CODE),
            ORIGIN[d->origin]);
}

static orr_status keep(job *j, const row *r, orr_diag *diag)
{
    if (j->csv != NULL) {
        csv_row(j, r);
        j->n++;
        return ORR_OK;
    }
    if (j->n >= MOST_ROWS)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "more than %d rows of a NetCDF file; take a longer --step, or CSV", MOST_ROWS);
    if (!ORR_ARRAY_GROW(j->row, j->n)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    j->row[j->n++] = *r;
    return ORR_OK;
}

static orr_status epoch(job *j, orr_time t, orr_diag *diag)
{
    const orr_sat *list;
    size_t n = orr_engine_satellites(j->engine, &list);
    static orr_realisation delay[ORR_SESSION_MAX_SATS];
    static orr_answer answer[ORR_SESSION_MAX_SATS];
    orr_vec3 place = j->place_m;
    char text[ORR_TIME_TEXT];
    if (n > ORR_SESSION_MAX_SATS) n = ORR_SESSION_MAX_SATS;
    if ((!j->has_place && orr_engine_receiver(j->engine, t, &place) != ORR_ANSWER_OK) ||
        orr_engine_delays(j->engine, t, place, list, n, delay, answer) != ORR_ANSWER_OK)
        return orr_diag_set(diag, ORR_E_RANGE, "orbits, ionosphere or receiver do not cover %s",
                            orr_time_text(t, text));
    const orr_sat_set *wanted = orr_cli_sats(j->c, "sat");
    for (size_t i = 0; i < n; i++) {
        orr_sat_state state;
        orr_answer known;
        if (answer[i] != ORR_ANSWER_OK || delay[i].pierce.el_rad < j->mask_rad ||
            (wanted != NULL && !orr_sat_set_has(wanted, list[i])))
            continue;
        orr_engine_states(j->engine, NULL, t, &list[i], 1, &state, &known);
        row r = {t, orr_vec3_norm(orr_vec3_sub(state.pos_m, place)), delay[i]};
        orr_status s = keep(j, &r, diag);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

static orr_status epochs(job *j, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (orr_time t = j->from; s == ORR_OK && t <= j->to; t += j->step_ns) s = epoch(j, t, diag);
    return s;
}

static double column_of(const row *r, int k, double carrier_hz)
{
    const orr_realisation *d = &r->delay;
    switch (k) {
    case 0:
        return d->pierce.az_rad * ORR_DEG_PER_RAD;
    case 1:
        return d->pierce.el_rad * ORR_DEG_PER_RAD;
    case 2:
        return r->range_m;
    case 3:
        return d->stec_tecu;
    case 4:
        return d->vtec_tecu;
    case 5:
        return d->mapping;
    case 6:
        return d->sigma_tecu;
    default:
        return orr_iono_delay_m(d->stec_tecu, carrier_hz, ORR_MEASURES_CODE);
    }
}

static orr_status write_nc(const job *j, const char *path, orr_diag *diag)
{
    static const struct {
        const char *name, *units, *long_name;
    } column[] = {{"azimuth", "degree", "of the satellite, clockwise from North"},
                  {"elevation", "degree", "above the ellipsoidal horizon"},
                  {"range", "m", "from the receiver to the satellite, both at the instant"},
                  {"stec_tecu", ORR_NC_TECU, "slant content"},
                  {"vtec_tecu", ORR_NC_TECU, "vertical content at the pierce point"},
                  {"mapping", "1", "slant over vertical"},
                  {"sigma_tecu", ORR_NC_TECU, "1-sigma of the slant content"},
                  {"delay", "m", "of a code on carrier_hz; a phase is early by it"}};
    orr_nc_writer w;
    char hash[ORR_SHA256_HEX];
    const orr_nc_input input = {.path = j->c->operand[0], .sha256 = hash};
    orr_status s = orr_sha256_file(j->c->operand[0], hash, diag);
    if (s == ORR_OK) s = orr_nc_create(path, &w, diag);
    if (s != ORR_OK) return s;
    static const char *const by_row[] = {"obs", "sat_text"};
    double *value = malloc((j->n + 1) * sizeof *value);
    int64_t *time = malloc((j->n + 1) * sizeof *time);
    char *name = calloc(j->n + 1, 3);
    uint8_t *origin = calloc(j->n + 1, 1);
    if (value == NULL || time == NULL || name == NULL || origin == NULL) {
        s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
        orr_nc_abort(&w);
    } else {
        for (size_t i = 0; i < j->n; i++) {
            char text[ORR_SAT_TEXT];
            time[i] = j->row[i].t;
            memcpy(name + 3 * i, orr_sat_text(j->row[i].delay.sat, text), 3);
            origin[i] = (uint8_t)j->row[i].delay.origin;
        }
        // A failure of any call stands in the writer; the commit returns it.
        (void)orr_nc_put_provenance(&w, "Ionospheric delays to navigation satellites", j->c->call, &input, 1,
                                    diag);
        (void)orr_nc_put_att_text(&w, NULL, "product", "delays", diag);
        (void)orr_nc_put_att_double(&w, NULL, "carrier_hz", &j->carrier_hz, 1, diag);
        (void)orr_nc_put_dim(&w, "obs", j->n, diag);
        (void)orr_nc_put_dim(&w, "sat_text", 3, diag);
        (void)orr_nc_put_var(&w, "time", ORR_NC_INT64, 1, by_row, time,
                             "nanoseconds since 1980-01-06 00:00:00", "instant, GPS time", diag);
        (void)orr_nc_put_att_text(&w, "time", "calendar", "standard", diag);
        (void)orr_nc_put_var(&w, "sat", ORR_NC_CHAR, 2, by_row, name, NULL, "satellite", diag);
        for (int k = 0; k < (int)(sizeof column / sizeof *column); k++) {
            for (size_t i = 0; i < j->n; i++) value[i] = column_of(&j->row[i], k, j->carrier_hz);
            (void)orr_nc_put_var(&w, column[k].name, ORR_NC_DOUBLE, 1, by_row, value, column[k].units,
                                 column[k].long_name, diag);
        }
        (void)orr_nc_put_var(&w, "origin", ORR_NC_UINT8, 1, by_row, origin, NULL,
                             "what the delay was made of", diag);
        (void)orr_nc_put_att_int64(&w, "origin", "flag_values", (const int64_t[]){0, 1, 2, 3}, 4, diag);
        (void)orr_nc_put_att_text(&w, "origin", "flag_meanings",
                                  "field_alone station_phase carried_over_from_station noise", diag);
        s = orr_nc_commit(&w, diag);
    }
    free(value);
    free(time);
    free(name);
    free(origin);
    return s;
}

static bool ends_in_nc(const char *path)
{
    size_t n = strlen(path);
    return n > 3 && strcmp(path + n - 3, ".nc") == 0;
}

static orr_status make(job *j, orr_diag *diag)
{
    const char *path = orr_cli_text(j->c, "output", "-");
    orr_status s = open_engine(j, diag);
    if (s == ORR_OK) s = settle_span(j, diag);
    if (s != ORR_OK) return s;
    if (ends_in_nc(path)) {
        s = epochs(j, diag);
        return s == ORR_OK ? write_nc(j, path, diag) : s;
    }
    orr_outfile out;
    s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    j->csv = out.stream;
    csv_head(j);
    s = epochs(j, diag);
    return orr_outfile_end(&out, s, diag);
}

static int run(orr_cli *c)
{
    job j = {.c = c,
             .step_ns = orr_cli_duration_ns(c, "step", 30 * ORR_NS_PER_S),
             .mask_rad = orr_cli_real(c, "mask", 0) * ORR_RAD_PER_DEG,
             .carrier_hz = orr_cli_real(c, "carrier", 1575.42) * 1e6};
    orr_geodetic place;
    j.has_place = orr_cli_place(c, "receiver", &place);
    if (j.has_place) j.place_m = orr_earth_to_ecef(place);
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to lies before --from");
    orr_diag diag = {0};
    orr_status s = make(&j, &diag);
    if (s == ORR_OK && orr_cli_given(c, "output"))
        orr_cli_say(c, "%s: %zu rows", orr_cli_text(c, "output", "-"), j.n);
    free(j.row);
    orr_engine_close(j.engine);
    orr_scenario_free(&j.scenario);
    return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "field",
     .applies = "!session",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "A TEC field; SCENARIO is then a product of `orrery orbit`."},
    {.name = "session",
     .applies = "!field",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "A session of `orrery iono`; SCENARIO is then a product of `orrery orbit`."},
    {.name = "receiver",
     .kind = ORR_OPT_PLACE,
     .value = "LAT,LON,H|ecef:X,Y,Z",
     .help = "The receiver, in degrees (geodetic) and metres; by default the scenario's, which may fly, or "
             "the session's "
             "station."},
    {.name = "from",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "First epoch; the first whole step by default."},
    {.name = "to",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "Last epoch; the end of what there is by default."},
    {.name = "step",
     .letter = 's',
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "From one epoch to the next; 30 s by default."},
    {.name = "sat",
     .kind = ORR_OPT_SATS,
     .value = "LIST",
     .help = "Satellites, e.g. G05,R,E01-E09; all by default."},
    {.name = "mask",
     .kind = ORR_OPT_REAL,
     .value = "DEG",
     .min = -90,
     .max = 90,
     .help = "Elevation mask; 0 by default. Receivers in space see satellites below their level too."},
    {.name = "carrier",
     .kind = ORR_OPT_REAL,
     .value = "MHZ",
     .min = 1,
     .max = 100000,
     .help = "The carrier to give delays for; 1575.42 by default."},
    {.name = "output",
     .letter = 'o',
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .writes = true,
     .help = "NetCDF-4 where the name ends in .nc, else CSV; standard output by default."},
};

const orr_command orr_cmd_delays = {
    .name = "delays",
    .group = "Ionosphere",
    .summary = "tabulate satellites' directions, ranges and ionospheric delays over a span",
    .operands = "SCENARIO",
    .min_operands = 1,
    .max_operands = 1,
    .about =
        "What the service answers to POLL_DELAYS, epoch by epoch, without a service: azimuth, elevation, "
        "range, slant "
        "and vertical content and delay of every satellite above the horizon, for a station or along a "
        "flight.\n\n"
        "SCENARIO names orbits, an ionosphere and a receiver or a trajectory; with --field or --session it "
        "is an orbit "
        "product. The range is geometric, between the places of both at the instant; delays are of a code "
        "(late), a "
        "carrier phase is early by as much. origin tells where a delay comes from: fused, transferred, noise "
        "(docs/ionosphere.md), or the field alone.",
    .example =
        "orrery delays day.nc --field maps.INX --receiver 52.28,17.07,124 --step 60 -o sky.csv\n"
        "orrery delays day.nc --session session.nc --from 2024-02-04T12:00 --to 2024-02-04T13:00 -o sky.nc\n"
        "orrery delays samples/gravimetry-flight.yaml --step 1 -o flight.csv",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

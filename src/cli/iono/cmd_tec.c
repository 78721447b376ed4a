// SPDX-License-Identifier: GPL-3.0-or-later
// orrery tec: what a TEC field says at a place, along a ray, or on the grid of the IGS.
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "iono/field/tec_files.h"
#include "iono/fusion/session_maps.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/options.h"
#include "src/cli/iono/tec_options.h"
#include "src/make/inputs.h"
#include "src/make/products.h"

typedef struct span {
    orr_time from;
    int64_t step;
    size_t n;
} span;

static int ask_times(const orr_cli *c, const orr_tec_field *f, span *out)
{
    orr_time first, last;
    orr_tec_field_span(f, &first, &last);
    const orr_time *epochs;
    size_t n = orr_tec_field_epochs(f, &epochs);
    if (orr_cli_given(c, "at")) {
        *out = (span){orr_cli_time(c, "at", 0), ORR_NS_PER_S, 1};
        return ORR_EXIT_OK;
    }
    if (!orr_cli_given(c, "from") && !orr_cli_given(c, "grid") && !orr_cli_given(c, "step"))
        return orr_cli_usage(c, "which instant? --at T, or --from T --to T --step S");
    int64_t usual = n > 1 ? epochs[1] - epochs[0] : 3600 * ORR_NS_PER_S;
    out->from = orr_cli_time(c, "from", n > 0 ? epochs[0] : first);
    orr_time to = orr_cli_time(c, "to", orr_cli_given(c, "from") ? out->from : n > 0 ? epochs[n - 1] : last);
    out->step = orr_cli_duration_ns(c, "step", usual);
    if (to < out->from) return orr_cli_usage(c, "--to lies before --from");
    uint64_t count = (uint64_t)(to - out->from) / (uint64_t)out->step + 1;
    if (count > 100000)
        return orr_cli_failf(c, "%" PRIu64 " instants are more than the 100000 that one call gives", count);
    out->n = (size_t)count;
    return ORR_EXIT_OK;
}

static void number(FILE *f, bool json, double v, int decimals)
{
    if (isnan(v))
        fputs(json ? "null" : "", f);
    else
        fprintf(f, "%.*f", decimals, v);
}

static void print_value(FILE *f, bool json, bool first, orr_time t, double lat, double lon,
                        const orr_tec_value *v)
{
    char time[ORR_TIME_TEXT];
    orr_time_text(t, time);
    if (json)
        fprintf(f, "%s\n {\"t_gps\": \"%s\", \"lat_deg\": %.6f, \"lon_deg\": %.6f, \"vtec_tecu\": ",
                first ? "" : ",", time, lat, lon);
    else
        fprintf(f, "%s,%.6f,%.6f,", time, lat, lon);
    number(f, json, v->vtec_tecu, 4);
    fputs(json ? ", \"sigma_tecu\": " : ",", f);
    number(f, json, v->sigma_tecu, 4);
    fputs(json ? "}" : "\n", f);
}

static orr_vec3 on_sphere(double lat_deg, double lon_deg)
{
    double b = lat_deg * ORR_RAD_PER_DEG, l = lon_deg * ORR_RAD_PER_DEG;
    return (orr_vec3){cos(b) * cos(l), cos(b) * sin(l), sin(b)};
}

static orr_status print_points(const orr_cli *c, FILE *f, const orr_tec_field *field, span when, bool json,
                               orr_diag *diag)
{
    orr_geodetic point = {0};
    orr_cli_place(c, "point", &point);
    const double lat = point.lat_rad * ORR_DEG_PER_RAD, lon = point.lon_rad * ORR_DEG_PER_RAD;
    orr_tec_instant *at = malloc(sizeof *at);
    if (at == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (!json) fputs("t_gps,lat_deg,lon_deg,vtec_tecu,sigma_tecu\n", f);
    orr_status s = ORR_OK;
    for (size_t i = 0; i < when.n && s == ORR_OK; i++) {
        orr_tec_value v;
        s = orr_tec_field_at(field, when.from + (int64_t)i * when.step, at, diag);
        if (s == ORR_OK) s = orr_tec_vertical(at, on_sphere(lat, lon), &v, diag);
        if (s == ORR_OK) print_value(f, json, i == 0, at->t, lat, lon, &v);
    }
    free(at);
    return s;
}

static orr_status print_rays(const orr_cli *c, FILE *f, const orr_tec_field *field, span when, bool json,
                             orr_diag *diag)
{
    double az = orr_cli_real(c, "az", 0), el = orr_cli_real(c, "el", 90),
           hz = orr_cli_real(c, "carrier", 1575.42) * 1e6;
    orr_geodetic place = {0};
    orr_cli_place(c, "receiver", &place);
    orr_iono_site site;
    orr_pierce p;
    orr_status s = orr_iono_site_at(orr_earth_to_ecef(place), &site, diag);
    if (s == ORR_OK)
        s = orr_pierce_direction(&site, az * ORR_RAD_PER_DEG, el * ORR_RAD_PER_DEG,
                                 orr_tec_field_shell_radius_m(field), &p, diag);
    orr_tec_instant *at = malloc(sizeof *at);
    if (at == NULL) s = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (s == ORR_OK && !json)
        fputs("t_gps,lat_deg,lon_deg,az_deg,el_deg,pierce_lat_deg,pierce_lon_deg,mapping,vtec_tecu,stec_tecu,"
              "sigma_tecu,"
              "freq_mhz,delay_m\n",
              f);
    for (size_t i = 0; i < when.n && s == ORR_OK; i++) {
        orr_tec_ray r;
        char time[ORR_TIME_TEXT];
        s = orr_tec_field_at(field, when.from + (int64_t)i * when.step, at, diag);
        if (s == ORR_OK) s = orr_tec_look_through(at, &site, &p, &r, diag);
        if (s != ORR_OK) break;
        fprintf(f,
                json ? "%s\n {\"t_gps\": \"%s\", \"lat_deg\": %.6f, \"lon_deg\": %.6f, \"az_deg\": %.4f, "
                       "\"el_deg\": %.4f, "
                       "\"pierce_lat_deg\": %.6f, \"pierce_lon_deg\": %.6f, \"mapping\": %.6f, "
                       "\"vtec_tecu\": %.4f, "
                       "\"stec_tecu\": %.4f, \"sigma_tecu\": "
                     : "%s%s,%.6f,%.6f,%.4f,%.4f,%.6f,%.6f,%.6f,%.4f,%.4f,",
                json && i > 0 ? "," : "", orr_time_text(at->t, time), place.lat_rad * ORR_DEG_PER_RAD,
                place.lon_rad * ORR_DEG_PER_RAD, az, el, p.lat_rad * ORR_DEG_PER_RAD,
                p.lon_rad * ORR_DEG_PER_RAD, r.mapping, r.vtec_tecu, r.stec_tecu);
        number(f, json, r.sigma_tecu, 4);
        fprintf(f, json ? ", \"freq_mhz\": %.4f, \"delay_m\": %.6f}" : ",%.4f,%.6f\n", hz / 1e6,
                orr_iono_delay_m(r.stec_tecu, hz, ORR_MEASURES_CODE));
    }
    free(at);
    return s;
}

static void print_grid(FILE *f, const orr_ionex *x, bool json)
{
    if (!json) fputs("t_gps,lat_deg,lon_deg,vtec_tecu,sigma_tecu\n", f);
    bool first = true;
    for (size_t k = 0; k < x->n_epochs; k++)
        for (size_t i = 0; i < x->n_lats; i++)
            for (size_t j = 0; j < x->n_lons; j++) {
                size_t at = orr_ionex_index(x, k, 0, i, j);
                orr_tec_value v = {x->tec_tecu[at], x->rms_tecu != NULL ? x->rms_tecu[at] : ORR_NAN, 0};
                print_value(f, json, first, x->epoch[k], x->lat_deg[i], x->lon_deg[j], &v);
                first = false;
            }
}

static orr_status to_files(const orr_cli *c, const orr_tec_field *field, span when, const char *format,
                           const char *path, orr_diag *diag)
{
    if (strcmp(format, "ion") == 0) {
        orr_ion models;
        orr_status s = orr_tec_field_to_ion(field, &models, diag);
        if (s != ORR_OK) return s;
        s = orr_ion_write(&models, path, diag);
        orr_ion_free(&models);
        return s;
    }
    bool ionex = strcmp(format, "ionex") == 0, json = strcmp(format, "json") == 0;
    orr_ionex maps = {0};
    orr_status s = ORR_OK;
    if (orr_cli_given(c, "grid")) {
        s = orr_tec_field_to_ionex(field, when.from, (double)when.step * 1e-9, when.n, &maps, diag);
        if (s != ORR_OK) return s;
        if (ionex) {
            maps.exponent = -1;
            maps.leap = c->leap;
            snprintf(maps.program, sizeof maps.program, "ORRERY TEC");
            s = orr_ionex_write(&maps, path, diag);
            orr_ionex_free(&maps);
            return s;
        }
    }
    orr_outfile out;
    s = orr_outfile_open(path, &out, diag);
    if (s == ORR_OK) {
        if (json) fputs("[", out.stream);
        if (orr_cli_given(c, "grid"))
            print_grid(out.stream, &maps, json);
        else if (orr_cli_given(c, "receiver"))
            s = print_rays(c, out.stream, field, when, json, diag);
        else
            s = print_points(c, out.stream, field, when, json, diag);
        if (json) fputs("\n]\n", out.stream);
        s = orr_outfile_end(&out, s, diag);
    }
    orr_ionex_free(&maps);
    return s;
}

// The field that is named; of a session, its maps: as they are, but for coefficients, which are fitted to them.
static orr_status open_field(const orr_cli *c, const orr_tec_options *o, bool coefficients,
                             orr_tec_field **out, orr_warnings *warnings, orr_diag *diag)
{
    const char *path = c->operand[0];
    if (orr_product_kind(path) != ORR_KIND_NETCDF) return orr_tec_field_open(path, o, out, warnings, diag);
    orr_session session;
    orr_ionex maps;
    orr_tec_options mine = *o;
    orr_status s = orr_session_load(path, c->leap, &session, diag);
    if (s != ORR_OK) return s;
    if (!coefficients) mine.spatial = ORR_TEC_BILINEAR;
    s = orr_session_maps(&session, (double)orr_cli_duration_ns(c, "step", 3600 * ORR_NS_PER_S) * 1e-9, &maps,
                         diag);
    if (s == ORR_OK) s = orr_tec_field_from_ionex(&maps, path, &mine, out, diag);
    orr_ionex_free(&maps);
    orr_session_free(&session);
    return s;
}

static int run(orr_cli *c)
{
    const char *format = orr_cli_text(c, "format", "csv");
    bool grid = orr_cli_given(c, "grid"), ion = strcmp(format, "ion") == 0;
    if (!grid && !ion && !orr_cli_given(c, "point") && !orr_cli_given(c, "receiver"))
        return orr_cli_usage(
            c, "where? --point LAT,LON on the shell, --receiver LAT,LON,H for a ray, or --grid");
    if (!grid && strcmp(format, "ionex") == 0)
        return orr_cli_usage(c, "IONEX holds maps: it goes with --grid");
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_tec_options o;
    int e = orr_tec_options_ask(c, &o);
    if (e != ORR_EXIT_OK) return e;
    orr_tec_field *field;
    orr_status s = open_field(c, &o, ion, &field, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    orr_tec_fit_say(c, field);
    span when = {0, 1, 1};
    if (!ion) e = ask_times(c, field, &when);
    if (e == ORR_EXIT_OK) {
        s = to_files(c, field, when, format, orr_cli_text(c, "output", "-"), &diag);
        if (s != ORR_OK) e = orr_cli_fail(c, &diag);
    }
    orr_tec_field_free(field);
    return e;
}

static const orr_option options[] = {
    ORR_OPTION_AT(.help = "The instant."),
    ORR_OPTION_FROM(.applies = "!at",
                    .help = "First of several instants; with --grid the first map by default."),
    ORR_OPTION_TO(.applies = "!at", .help = "Last of them."),
    ORR_OPTION_STEP(.applies = "!at", .help = "From one to the next; the maps' own interval by default."),
    {.name = "point",
     .kind = ORR_OPT_PLACE,
     .value = "LAT,LON",
     .applies = "!grid,!receiver",
     .help = "A point of the ionosphere's shell in degrees; the latitude is geocentric, as in maps."},
    ORR_OPTION_RECEIVER(.applies = "!grid",
                        .help = "Along a ray: the receiver, in degrees (geodetic) and metres."),
    {.name = "el",
     .kind = ORR_OPT_REAL,
     .value = "DEG",
     .min = -90,
     .max = 90,
     .applies = "receiver",
     .help = "Elevation of the ray at the receiver; 90 by default."},
    {.name = "az",
     .kind = ORR_OPT_REAL,
     .value = "DEG",
     .min = -360,
     .max = 360,
     .applies = "receiver",
     .help = "Azimuth of the ray, clockwise from North; 0 by default."},
    ORR_OPTION_CARRIER(.applies = "receiver",
                       .help = "The carrier to give the delay for; 1575.42 by default."),
    {.name = "grid", .kind = ORR_OPT_FLAG, .help = "Maps of the whole Earth, 2.5 by 5 degrees."},
    ORR_OPTION_FORMAT_AS(
        "csv|json|ionex|ion", "csv",
        .help =
            "The format of the output; csv by default. ion: the coefficients of the field (all epochs), as "
            "Bernese writes them."),
    ORR_OPTION_OUTPUT,
    ORR_TEC_OPTIONS,
};

const orr_command orr_cmd_tec = {
    .name = "tec",
    .group = "Ionosphere",
    .summary = "print total electron content of maps, coefficients or the broadcast model",
    .operands = "FIELD",
    .min_operands = 1,
    .max_operands = 1,
    .about = "FIELD is an IONEX file, Bernese coefficients (.ION), a RINEX navigation file (a broadcast "
             "model), or a session of orrery iono: its field with the correction that the station's phases "
             "found, as maps --step apart (an hour by default). "
             "Maps are refitted to "
             "spherical harmonics of degree 15 in the solar-geomagnetic frame, which is what they are "
             "printed from; --bilinear "
             "takes them as they are.\n\n"
             "TEC is in TECU (1e16 electrons per square metre). With --receiver the slant content along a "
             "ray and the delay "
             "of a code on one carrier are given too; a carrier phase is early by as much.",
    .example = "orrery tec maps.INX --at 2024-02-04T12:30 --point 52.1,17\n"
               "orrery tec maps.INX --at 2024-02-04T12:30 --receiver 52.3,17.1,0 --el 30 --az 180\n"
               "orrery tec maps.INX --grid --step 15min --format ionex -o quarter-hours.INX\n"
               "orrery tec maps.INX --format ion -o maps.ION\n"
               "orrery tec session.nc --grid --format ionex -o fused.INX",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

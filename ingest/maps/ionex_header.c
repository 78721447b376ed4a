// SPDX-License-Identifier: GPL-3.0-or-later
// Header of an IONEX file: what the maps are, their grid, and the auxiliary code biases.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/nan.h"
#include "ingest/input/text_records.h"
#include "ingest/maps/ionex_private.h"

static orr_status fail(ionex_reader *r, int column, const char *what)
{
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, column, "%s", what);
}

static orr_status first_line(ionex_reader *r)
{
    orr_view line;
    do {
        if (!orr_cursor_next(&r->c, &line)) {
            orr_status s = orr_cursor_status(&r->c, r->diag);
            return s != ORR_OK ? s : orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 0, "the file is empty");
        }
    } while (orr_view_is_blank(line));
    if (!orr_records_label_is(orr_records_label(line), "IONEX VERSION / TYPE"))
        return orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 61,
                                "not an IONEX file: the first line has no label IONEX VERSION / TYPE");
    orr_ionex *x = r->out;
    if (orr_field_real(line, 1, 20, &x->version) != ORR_FIELD_OK)
        return fail(r, 1, "the IONEX version is no number");
    if (!(x->version >= 1.0 && x->version < 2.0))
        return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 1,
                                "IONEX version %.2f is not known (1.0 and 1.1 are)", x->version);
    x->type = orr_view_char(line, 21);
    if (x->type != 'I' && x->type != 'i')
        return orr_cursor_error(&r->c, r->diag, ORR_E_KIND, 21, "file type '%c', not I (ionosphere maps)",
                                x->type);
    x->type = 'I';
    orr_view_copy(orr_view_trim(orr_view_cols(line, 41, 20)), x->technique, sizeof x->technique);
    return ORR_OK;
}

// HGT1 / HGT2 / DHGT and its sisters: 2X,3F6.1.
static orr_status read_axis(ionex_reader *r, orr_view line, int axis)
{
    static const char *const name[] = {"HGT1 / HGT2 / DHGT", "LAT1 / LAT2 / DLAT", "LON1 / LON2 / DLON"};
    for (int i = 0; i < 3; i++)
        if (orr_field_real(line, 3 + 6 * i, 6, &r->axis[axis][i]) != ORR_FIELD_OK)
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 3 + 6 * i,
                                    "%s: a number of %s is missing or malformed", name[axis], name[axis]);
    r->have_axis[axis] = true;
    return ORR_OK;
}

static orr_status read_dcb(ionex_reader *r, orr_view line, bool station)
{
    orr_ionex *x = r->out;
    orr_ionex_dcb d = {.rms_s = ORR_NAN, .system = 'G'};
    int value_col = 7;
    if (station) {
        value_col = 27;
        char system = orr_view_char(line, 4);
        if (system != ' ') d.system = system;
        orr_view_copy(orr_view_trim(orr_view_cols(line, 7, 20)), d.station, sizeof d.station);
    } else {
        orr_view id = orr_view_cols(line, 4, 3);
        d.sat = id.n == 3 ? orr_sat_parse3(id.p, 'G') : ORR_SAT_NONE;
        if (d.sat == ORR_SAT_NONE) {
            orr_cursor_warn(&r->c, r->warnings, 4, "a code bias of no known satellite is left out");
            return ORR_OK;
        }
        d.system = orr_sat_system(d.sat);
    }
    double bias_ns, rms_ns;
    if (orr_field_real(line, value_col, 10, &bias_ns) != ORR_FIELD_OK) {
        orr_cursor_warn(&r->c, r->warnings, value_col, "a code bias that is no number is left out");
        return ORR_OK;
    }
    d.bias_s = bias_ns * 1e-9;
    if (orr_field_real(line, value_col + 10, 10, &rms_ns) == ORR_FIELD_OK) d.rms_s = rms_ns * 1e-9;
    orr_status s = orr_records_grow(&x->dcb, x->n_dcbs, sizeof *x->dcb, r->limits.max_records, "code biases",
                                    &r->c, r->diag);
    if (s != ORR_OK) return s;
    x->dcb[x->n_dcbs++] = d;
    return ORR_OK;
}

static void read_mapping(ionex_reader *r, orr_view line)
{
    orr_ionex *x = r->out;
    orr_view word = orr_view_trim(orr_view_cols(line, 1, 60));
    orr_view_copy(word, x->mapping_text, sizeof x->mapping_text);
    if (orr_view_equals(word, "NONE"))
        x->mapping = ORR_IONEX_MAP_NONE;
    else if (orr_view_equals(word, "COSZ"))
        x->mapping = ORR_IONEX_MAP_COSZ;
    else if (orr_view_equals(word, "QFAC"))
        x->mapping = ORR_IONEX_MAP_QFAC;
    else
        orr_cursor_warn(&r->c, r->warnings, 3, "mapping function \"%s\" is not one of NONE, COSZ, QFAC",
                        x->mapping_text);
}

static void read_count(ionex_reader *r, orr_view line, int *out)
{
    if (orr_field_int_in(line, 1, 6, 0, 999999, out) != ORR_FIELD_OK)
        orr_cursor_warn(&r->c, r->warnings, 1, "a count of the header is no number");
}

static void read_real(ionex_reader *r, orr_view line, double factor, double *out)
{
    double v;
    if (orr_field_real(line, 1, 20, &v) == ORR_FIELD_OK)
        *out = v * factor;
    else
        orr_cursor_warn(&r->c, r->warnings, 1, "a number of the header is missing or malformed");
}

static orr_status read_declared(ionex_reader *r, orr_view line, orr_time *out)
{
    if (!orr_records_civil_columns(line, 1, 6, ORR_SCALE_UTC, r->limits.leap, out))
        orr_cursor_warn(&r->c, r->warnings, 1, "an epoch of the header is no date");
    return ORR_OK;
}

static orr_status header_line(ionex_reader *r, orr_view line, orr_view label)
{
    orr_ionex *x = r->out;
    orr_view text = orr_view_cols(line, 1, 60);
    int64_t k;
    if (orr_records_label_is(label, "COMMENT"))
        return orr_records_add_text(&x->comment, &x->n_comments, text, r->limits.max_records, &r->c, r->diag);
    if (orr_records_label_is(label, "PRN / BIAS / RMS")) return read_dcb(r, line, false);
    if (orr_records_label_is(label, "STATION / BIAS / RMS")) return read_dcb(r, line, true);
    if (orr_records_label_is(label, "DESCRIPTION"))
        return orr_records_add_text(&x->description, &x->n_descriptions, text, r->limits.max_records, &r->c,
                                    r->diag);
    if (orr_records_label_is(label, "PGM / RUN BY / DATE"))
        orr_records_program_line(line, x->program, x->run_by, x->date);
    else if (orr_records_label_is(label, "EPOCH OF FIRST MAP"))
        return read_declared(r, line, &r->first_declared);
    else if (orr_records_label_is(label, "EPOCH OF LAST MAP"))
        return read_declared(r, line, &r->last_declared);
    else if (orr_records_label_is(label, "INTERVAL"))
        read_real(r, line, 1.0, &x->interval_s);
    else if (orr_records_label_is(label, "# OF MAPS IN FILE")) {
        if (orr_field_int(line, 1, 6, &k) == ORR_FIELD_OK && k >= 0)
            r->n_maps_declared = k;
        else
            orr_cursor_warn(&r->c, r->warnings, 1, "the number of maps is no number");
    } else if (orr_records_label_is(label, "MAPPING FUNCTION"))
        read_mapping(r, line);
    else if (orr_records_label_is(label, "ELEVATION CUTOFF"))
        read_real(r, line, 1.0, &x->elevation_cutoff_deg);
    else if (orr_records_label_is(label, "OBSERVABLES USED"))
        orr_view_copy(orr_view_trim(text), x->observables, sizeof x->observables);
    else if (orr_records_label_is(label, "# OF STATIONS"))
        read_count(r, line, &x->n_stations);
    else if (orr_records_label_is(label, "# OF SATELLITES"))
        read_count(r, line, &x->n_satellites);
    else if (orr_records_label_is(label, "SYS / #STA / #SAT")) {
        // Counts by system (version 1.1); the totals above are what is kept.
    } else if (orr_records_label_is(label, "BASE RADIUS"))
        read_real(r, line, 1e3, &x->base_radius_m);
    else if (orr_records_label_is(label, "MAP DIMENSION")) {
        if (orr_field_int_in(line, 1, 6, 2, 3, &x->dimension) != ORR_FIELD_OK)
            return fail(r, 1, "MAP DIMENSION is neither 2 nor 3");
    } else if (orr_records_label_is(label, "HGT1 / HGT2 / DHGT"))
        return read_axis(r, line, IONEX_AXIS_HEIGHT);
    else if (orr_records_label_is(label, "LAT1 / LAT2 / DLAT"))
        return read_axis(r, line, IONEX_AXIS_LAT);
    else if (orr_records_label_is(label, "LON1 / LON2 / DLON"))
        return read_axis(r, line, IONEX_AXIS_LON);
    else if (orr_records_label_is(label, "EXPONENT")) {
        if (orr_field_int_in(line, 1, 6, -9, 9, &x->exponent) != ORR_FIELD_OK)
            return fail(r, 1, "EXPONENT is no number from -9 to 9");
        r->have_exponent = true;
    } else if (orr_records_label_is(label, "START OF AUX DATA")) {
        if (!orr_view_starts(orr_view_trim(text), "DIFFERENTIAL CODE BIASES"))
            orr_cursor_warn(&r->c, r->warnings, 1,
                            "auxiliary data of a kind that is not known are passed over");
    } else if (!orr_records_label_is(label, "END OF AUX DATA")) {
        char shown[24];
        orr_cursor_warn(&r->c, r->warnings, 61, "header label \"%s\" is not known; the line is passed over",
                        orr_view_copy(label, shown, sizeof shown));
    }
    return ORR_OK;
}

// Turns {first, last, step} into an explicit axis.
static orr_status make_axis(ionex_reader *r, int axis, double factor, double **out, size_t *n)
{
    static const char *const name[] = {"HGT1 / HGT2 / DHGT", "LAT1 / LAT2 / DLAT", "LON1 / LON2 / DLON"};
    const double *a = r->axis[axis];
    if (!r->have_axis[axis])
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "the header has no %s line, so the grid is not known", name[axis]);
    double count = 1;
    if (a[0] != a[1]) {
        double steps = a[2] != 0 ? (a[1] - a[0]) / a[2] : -1;
        // The fields carry one decimal; a grid whose ends are a tenth off a whole number of steps is a wrong
        // grid.
        if (!(steps > 0.5) || fabs(steps - round(steps)) > 0.02)
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                    "%s: from %.1f to %.1f by %.1f is no grid", name[axis], a[0], a[1], a[2]);
        count = round(steps) + 1;
    }
    if (count > IONEX_MAX_AXIS)
        return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "%s: %.0f points, more than %d", name[axis],
                                count, IONEX_MAX_AXIS);
    *n = (size_t)count;
    *out = malloc(*n * sizeof **out);
    if (*out == NULL) return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for the grid");
    for (size_t i = 0; i < *n; i++) (*out)[i] = (a[0] + (double)i * a[2]) * factor;
    return ORR_OK;
}

static orr_status make_grid(ionex_reader *r)
{
    orr_ionex *x = r->out;
    orr_status s = make_axis(r, IONEX_AXIS_LAT, 1.0, &x->lat_deg, &x->n_lats);
    if (s == ORR_OK) s = make_axis(r, IONEX_AXIS_LON, 1.0, &x->lon_deg, &x->n_lons);
    if (s == ORR_OK) s = make_axis(r, IONEX_AXIS_HEIGHT, 1e3, &x->height_m, &x->n_heights);
    if (s != ORR_OK) return s;
    const double *lat = r->axis[IONEX_AXIS_LAT], *lon = r->axis[IONEX_AXIS_LON];
    if (fabs(lat[0]) > 90 || fabs(lat[1]) > 90)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "LAT1 / LAT2 / DLAT: latitudes beyond 90 degrees");
    if (fabs(lon[0]) > 360 || fabs(lon[1]) > 360 || fabs(lon[1] - lon[0]) > 360)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "LON1 / LON2 / DLON: more than a turn of longitude");
    if (x->dimension == 2 && x->n_heights > 1)
        orr_cursor_warn(&r->c, r->warnings, 0, "MAP DIMENSION 2 with %zu heights: read as three-dimensional",
                        x->n_heights);
    size_t cells = x->n_lats * x->n_lons; // each below 10^4
    if (cells > r->limits.max_values / x->n_heights)
        return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0,
                                "a map of %zu x %zu x %zu values, more than the limit of %zu", x->n_heights,
                                x->n_lats, x->n_lons, r->limits.max_values);
    r->map_size = cells * x->n_heights;
    return ORR_OK;
}

orr_status ionex_read_header(ionex_reader *r)
{
    orr_ionex *x = r->out;
    x->elevation_cutoff_deg = ORR_NAN;
    x->base_radius_m = ORR_NAN;
    x->n_stations = x->n_satellites = -1;
    x->dimension = 2;
    x->exponent = -1;
    r->n_maps_declared = -1;
    r->first_declared = r->last_declared = ORR_TIME_NONE;
    orr_status s = first_line(r);
    while (s == ORR_OK) {
        orr_view line;
        if (!orr_cursor_next(&r->c, &line)) {
            s = orr_cursor_status(&r->c, r->diag);
            return s != ORR_OK ? s : fail(r, 0, "the file ends inside the header (no END OF HEADER)");
        }
        orr_view label = orr_records_label(line);
        if (orr_records_label_is(label, "END OF HEADER")) break;
        if (orr_records_label_is(label, "START OF TEC MAP"))
            return fail(r, 61, "a map starts before END OF HEADER");
        if (!orr_view_is_blank(line)) s = header_line(r, line, label);
    }
    if (s == ORR_OK && isnan(x->base_radius_m)) {
        x->base_radius_m = ORR_EARTH_MEAN_RADIUS_M; // what every centre uses; heights count from it
        orr_cursor_warn(&r->c, r->warnings, 0, "the header has no BASE RADIUS; 6371 km is taken");
    }
    return s == ORR_OK ? make_grid(r) : s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// IONEX 1.0 as the format's own description lays it out: 80 columns, labels from 61, sixteen I5 a line.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"
#include "core/nan.h"
#include "core/outfile.h"
#include "ingest/maps/ionex.h"
#include "ingest/maps/ionex_private.h"

static orr_status make_axis(const double a[3], const char *name, double **out, size_t *n, orr_diag *diag)
{
    double count = 1;
    if (a[0] != a[1]) {
        double steps = a[2] != 0 ? (a[1] - a[0]) / a[2] : ORR_NAN;
        if (!(steps > 0.5 && fabs(steps - round(steps)) < 1e-6))
            return orr_diag_set(diag, ORR_E_ARG, "%s from %g to %g by %g is no grid", name, a[0], a[1], a[2]);
        count = round(steps) + 1;
    }
    if (!(count <= IONEX_MAX_AXIS))
        return orr_diag_set(diag, ORR_E_LIMIT, "%s: %.0f points, more than %d", name, count, IONEX_MAX_AXIS);
    *n = (size_t)count;
    *out = malloc(*n * sizeof **out);
    if (*out == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a grid");
    for (size_t i = 0; i < *n; i++) (*out)[i] = a[0] + (double)i * a[2];
    return ORR_OK;
}

static double *missing(size_t n)
{
    double *v = malloc(n * sizeof *v);
    for (size_t i = 0; v != NULL && i < n; i++) v[i] = ORR_NAN;
    return v;
}

orr_status orr_ionex_alloc(size_t n_epochs, orr_time t0, double step_s, const double lat_deg[3],
                           const double lon_deg[3], const double height_m[3], bool with_rms, orr_ionex *out,
                           orr_diag *diag)
{
    *out = (orr_ionex){.version = 1.0,
                       .type = 'I',
                       .mapping = ORR_IONEX_MAP_NONE,
                       .mapping_text = "NONE",
                       .elevation_cutoff_deg = ORR_NAN,
                       .n_stations = -1,
                       .n_satellites = -1,
                       .base_radius_m = ORR_EARTH_MEAN_RADIUS_M,
                       .exponent = -1,
                       .interval_s = step_s,
                       .n_epochs = n_epochs};
    if (n_epochs == 0 || !(step_s > 0 || n_epochs == 1))
        return orr_diag_set(diag, ORR_E_ARG, "a map file needs at least one epoch and a positive step");
    orr_status s = make_axis(lat_deg, "latitude", &out->lat_deg, &out->n_lats, diag);
    if (s == ORR_OK) s = make_axis(lon_deg, "longitude", &out->lon_deg, &out->n_lons, diag);
    if (s == ORR_OK) s = make_axis(height_m, "height", &out->height_m, &out->n_heights, diag);
    size_t limit = orr_read_default_limits().max_values;
    if (s == ORR_OK && (out->n_lats * out->n_lons > limit / out->n_heights ||
                        n_epochs > limit / (out->n_lats * out->n_lons * out->n_heights)))
        s = orr_diag_set(diag, ORR_E_LIMIT, "more than %zu values of maps", limit);
    if (s == ORR_OK) {
        out->dimension = out->n_heights > 1 ? 3 : 2;
        size_t n = n_epochs * out->n_heights * out->n_lats * out->n_lons;
        out->epoch = malloc(n_epochs * sizeof *out->epoch);
        out->tec_tecu = missing(n);
        if (with_rms) out->rms_tecu = missing(n);
        if (out->epoch == NULL || out->tec_tecu == NULL || (with_rms && out->rms_tecu == NULL))
            s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu values of maps", n);
        for (size_t i = 0; s == ORR_OK && i < n_epochs; i++)
            out->epoch[i] = orr_time_add_s(t0, (double)i * step_s);
    }
    if (s != ORR_OK) orr_ionex_free(out);
    return s;
}

// {first, last, step} of an explicit axis; ORR_E_ARG if it is not regular to a tenth of the written digit.
static orr_status axis_of(const double *v, size_t n, double factor, const char *name, double a[3],
                          orr_diag *diag)
{
    if (n == 0) return orr_diag_set(diag, ORR_E_ARG, "the grid has no %s", name);
    a[0] = v[0] * factor;
    a[1] = v[n - 1] * factor;
    a[2] = n > 1 ? (a[1] - a[0]) / (double)(n - 1) : 0;
    for (size_t i = 0; i < n; i++)
        if (!(fabs(v[i] * factor - (a[0] + (double)i * a[2])) < 0.01))
            return orr_diag_set(diag, ORR_E_ARG, "IONEX cannot hold a grid of %s that is not regular", name);
    for (int i = 0; i < 3; i++)
        if (!(fabs(a[i] * 10 - round(a[i] * 10)) < 1e-3) || !(fabs(a[i]) < 1000))
            return orr_diag_set(diag, ORR_E_ARG,
                                "IONEX writes %s with one decimal in six columns; %g does not fit", name,
                                a[i]);
    return ORR_OK;
}

static void label_line(FILE *f, const char *text, const char *label)
{
    fprintf(f, "%-60.60s%-20s\n", text, label);
}

static void epoch_line(FILE *f, orr_time t, const orr_leap_table *leap, const char *label)
{
    orr_civil c;
    orr_time_to_civil(t, ORR_SCALE_UTC, leap, &c);
    char text[64];
    snprintf(text, sizeof text, "%6d%6d%6d%6d%6d%6d", c.year, c.month, c.day, c.hour, c.minute, c.second);
    label_line(f, text, label);
}

static void axis_line(FILE *f, const double a[3], const char *label)
{
    char text[64];
    snprintf(text, sizeof text, "  %6.1f%6.1f%6.1f", a[0], a[1], a[2]);
    label_line(f, text, label);
}

static void number_line(FILE *f, const char *format, double v, const char *label)
{
    char text[64];
    snprintf(text, sizeof text, format, v);
    label_line(f, text, label);
}

static void write_dcbs(FILE *f, const orr_ionex *x)
{
    if (x->n_dcbs == 0) return;
    char text[64];
    label_line(f, "DIFFERENTIAL CODE BIASES", "START OF AUX DATA");
    for (size_t i = 0; i < x->n_dcbs; i++) {
        const orr_ionex_dcb *d = &x->dcb[i];
        char id[ORR_SAT_TEXT];
        double rms = isnan(d->rms_s) ? 0.0 : d->rms_s * 1e9;
        if (d->sat != ORR_SAT_NONE) {
            snprintf(text, sizeof text, "   %s%10.3f%10.3f", orr_sat_text(d->sat, id), d->bias_s * 1e9, rms);
            label_line(f, text, "PRN / BIAS / RMS");
        } else {
            snprintf(text, sizeof text, "   %c  %-20.20s%10.3f%10.3f", d->system, d->station, d->bias_s * 1e9,
                     rms);
            label_line(f, text, "STATION / BIAS / RMS");
        }
    }
    label_line(f, "DIFFERENTIAL CODE BIASES", "END OF AUX DATA");
}

static void write_header(FILE *f, const orr_ionex *x, const double hgt[3], const double lat[3],
                         const double lon[3])
{
    char text[96];
    snprintf(text, sizeof text, "%8.1f%12sIONOSPHERE MAPS     %-20s", 1.0, "", x->technique);
    label_line(f, text, "IONEX VERSION / TYPE");
    snprintf(text, sizeof text, "%-20s%-20s%-20s", x->program, x->run_by, x->date);
    label_line(f, text, "PGM / RUN BY / DATE");
    for (size_t i = 0; i < x->n_descriptions; i++) label_line(f, x->description[i], "DESCRIPTION");
    epoch_line(f, x->epoch[0], x->leap, "EPOCH OF FIRST MAP");
    epoch_line(f, x->epoch[x->n_epochs - 1], x->leap, "EPOCH OF LAST MAP");
    number_line(f, "%6.0f", x->interval_s, "INTERVAL");
    number_line(f, "%6.0f", (double)x->n_epochs, "# OF MAPS IN FILE");
    snprintf(text, sizeof text, "  %-4s", x->mapping_text[0] != '\0' ? x->mapping_text : "NONE");
    label_line(f, text, "MAPPING FUNCTION");
    number_line(f, "%8.1f", isnan(x->elevation_cutoff_deg) ? 0.0 : x->elevation_cutoff_deg,
                "ELEVATION CUTOFF");
    label_line(f, x->observables, "OBSERVABLES USED");
    if (x->n_stations >= 0) number_line(f, "%6.0f", x->n_stations, "# OF STATIONS");
    if (x->n_satellites >= 0) number_line(f, "%6.0f", x->n_satellites, "# OF SATELLITES");
    number_line(f, "%8.1f", x->base_radius_m * 1e-3, "BASE RADIUS");
    number_line(f, "%6.0f", x->n_heights > 1 ? 3 : 2, "MAP DIMENSION");
    axis_line(f, hgt, "HGT1 / HGT2 / DHGT");
    axis_line(f, lat, "LAT1 / LAT2 / DLAT");
    axis_line(f, lon, "LON1 / LON2 / DLON");
    number_line(f, "%6.0f", x->exponent, "EXPONENT");
    for (size_t i = 0; i < x->n_comments; i++) label_line(f, x->comment[i], "COMMENT");
    write_dcbs(f, x);
    label_line(f, "", "END OF HEADER");
}

// All values of a kind must fit I5 beside 9999 meaning "none"; says which exponent would do.
static orr_status check_values(const double *v, size_t n, int exponent, ionex_kind kind, orr_diag *diag)
{
    double largest = 0, unit = pow(10, exponent);
    for (size_t i = 0; i < n; i++) {
        if (isnan(v[i])) continue;
        double k = round(v[i] / unit);
        if (!(k > -10000 && k < 100000) || k == IONEX_MISSING) largest = fmax(largest, fabs(v[i]));
    }
    if (largest == 0) return ORR_OK;
    return orr_diag_set(diag, ORR_E_RANGE,
                        "a %s value of %g does not fit five columns with exponent %d; exponent %d would do",
                        ionex_kind_name[kind], largest, exponent, (int)ceil(log10(largest / 9998)));
}

static void write_map(FILE *f, const orr_ionex *x, const double *all, double factor, size_t e,
                      ionex_kind kind, const double lon[3])
{
    char text[64], label[24];
    snprintf(label, sizeof label, "START OF %s MAP", ionex_kind_name[kind]);
    number_line(f, "%6.0f", (double)e + 1, label);
    epoch_line(f, x->epoch[e], x->leap, "EPOCH OF CURRENT MAP");
    double unit = pow(10, abs(x->exponent));
    for (size_t h = 0; h < x->n_heights; h++) {
        for (size_t i = 0; i < x->n_lats; i++) {
            snprintf(text, sizeof text, "  %6.1f%6.1f%6.1f%6.1f%6.1f", x->lat_deg[i], lon[0], lon[1], lon[2],
                     x->height_m[h] * 1e-3);
            label_line(f, text, "LAT/LON1/LON2/DLON/H");
            const double *row = all + orr_ionex_index(x, e, h, i, 0);
            for (size_t k = 0; k < x->n_lons; k++) {
                double v = row[k] * factor;
                double scaled = x->exponent < 0 ? v * unit : v / unit;
                fprintf(f, "%5d", isnan(v) ? IONEX_MISSING : (int)round(scaled));
                if (k % IONEX_PER_LINE == IONEX_PER_LINE - 1 || k + 1 == x->n_lons) fputc('\n', f);
            }
        }
    }
    snprintf(label, sizeof label, "END OF %s MAP", ionex_kind_name[kind]);
    number_line(f, "%6.0f", (double)e + 1, label);
}

orr_status orr_ionex_write(const orr_ionex *x, const char *path, orr_diag *diag)
{
    double hgt[3], lat[3], lon[3];
    if (x->n_epochs == 0 || x->tec_tecu == NULL)
        return orr_diag_set(diag, ORR_E_ARG, "there is no TEC map to write");
    if (x->exponent < -9 || x->exponent > 9) return orr_diag_set(diag, ORR_E_ARG, "exponent %d", x->exponent);
    orr_status s = axis_of(x->height_m, x->n_heights, 1e-3, "height", hgt, diag);
    if (s == ORR_OK) s = axis_of(x->lat_deg, x->n_lats, 1, "latitude", lat, diag);
    if (s == ORR_OK) s = axis_of(x->lon_deg, x->n_lons, 1, "longitude", lon, diag);
    if (s != ORR_OK) return s;
    for (size_t e = 0; e < x->n_epochs; e++) {
        orr_civil c;
        orr_time_to_civil(x->epoch[e], ORR_SCALE_UTC, x->leap, &c);
        if (c.ns != 0) return orr_diag_set(diag, ORR_E_ARG, "IONEX epochs are whole seconds of UT");
    }
    const double *values[IONEX_KINDS] = {x->tec_tecu, x->rms_tecu, x->hgt_m};
    size_t n = x->n_epochs * x->n_heights * x->n_lats * x->n_lons;
    double unit_of[IONEX_KINDS] = {1, 1, 1e-3};
    for (int k = 0; k < IONEX_KINDS; k++) {
        // Heights are checked in metres against km fields: scale by way of the exponent.
        if (values[k] == NULL) continue;
        s = check_values(values[k], n, x->exponent + (k == IONEX_HGT ? 3 : 0), (ionex_kind)k, diag);
        if (s != ORR_OK) return s;
    }
    orr_outfile f;
    s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    write_header(f.stream, x, hgt, lat, lon);
    for (int k = 0; k < IONEX_KINDS; k++)
        for (size_t e = 0; values[k] != NULL && e < x->n_epochs; e++)
            write_map(f.stream, x, values[k], unit_of[k], e, (ionex_kind)k, lon);
    label_line(f.stream, "", "END OF FILE");
    return orr_outfile_commit(&f, diag); // reports a full disk too: it flushes and asks the stream for errors
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Writer of Bernese .ION files, line by line as Bernese lays them out (48 columns of label, then the value).
#include <math.h>

#include "core/outfile.h"
#include "ingest/maps/ion.h"

static void text_line(FILE *f, const char *label, const char *value)
{
    fprintf(f, "%-48s %s\n", label, value);
}
static void heading(FILE *f, const char *label) { fprintf(f, "%-48s\n", label); }
static void int_line(FILE *f, const char *label, int v) { fprintf(f, "%-47s:%5d\n", label, v); }
static void real_line(FILE *f, const char *label, double v) { fprintf(f, "%-47s:%8.2f\n", label, v); }

static void epoch_line(FILE *f, const char *label, orr_time t)
{
    char text[32] = "";
    if (t != ORR_TIME_NONE) {
        orr_civil c;
        orr_time_to_civil(t, ORR_SCALE_GPS, NULL, &c);
        snprintf(text, sizeof text, " %04d %02d %02d %02d %02d %02d", c.year, c.month, c.day, c.hour,
                 c.minute, c.second);
    }
    fprintf(f, "%-47s:%s\n", label, text);
}

static void write_model(FILE *f, const orr_ion_model *m)
{
    fprintf(f, "%-80.80s\n", m->title);
    for (int i = 0; i < 80; i++) fputc('-', f);
    fputc('\n', f);
    text_line(f, "MODEL NUMBER / STATION NAME                    :", m->number);
    int_line(f, "MODEL TYPE (1=LOCAL,2=GLOBAL,3=STATION)", (int)m->type);
    int_line(f, "MAXIMUM DEGREE OF SPHERICAL HARMONICS", m->max_degree);
    int_line(f, "MAXIMUM ORDER", m->max_order);
    heading(f, "DEVELOPMENT WITH RESPECT TO");
    int_line(f, "  GEOGRAPHICAL (=1) OR GEOMAGNETIC (=2) FRAME", (int)m->frame);
    int_line(f, "  MEAN (=1) OR TRUE (=2) POSITION OF THE SUN", (int)m->sun);
    int_line(f, "MAPPING FUNCTION (0=NONE,1=COSZ,2=MSLM,3=ESM)", (int)m->mapping);
    if (!isnan(m->layer_height_m))
        fprintf(f, "%-47s:%8.2f %8.2f\n", "HEIGHT OF SINGLE LAYER AND ITS RMS ERROR (KM)",
                m->layer_height_m * 1e-3, isnan(m->layer_height_rms_m) ? 0.0 : m->layer_height_rms_m * 1e-3);
    if (!isnan(m->pole_lat_deg) && !isnan(m->pole_lon_deg)) {
        heading(f, "COORDINATES OF EARTH-CENTERED DIPOLE AXIS");
        real_line(f, "  LATITUDE OF NORTH GEOMAGNETIC POLE (DEGREES)", m->pole_lat_deg);
        real_line(f, "  EAST LONGITUDE (DEGREES)", m->pole_lon_deg);
    }
    heading(f, "PERIOD OF VALIDITY");
    epoch_line(f, "  FROM EPOCH / REFERENCE EPOCH (Y,M,D,H,M,S)", m->from);
    epoch_line(f, "  TO EPOCH", m->to);
    if (!isnan(m->lat_south_deg) && !isnan(m->lat_north_deg)) {
        heading(f, "LATITUDE BAND COVERED");
        real_line(f, "  MINIMUM LATITUDE (DEGREES)", m->lat_south_deg);
        real_line(f, "  MAXIMUM LATITUDE (DEGREES)", m->lat_north_deg);
    }
    heading(f, "ADDITIONAL INFORMATION");
    if (m->n_stations >= 0) int_line(f, "  NUMBER OF CONTRIBUTING STATIONS", m->n_stations);
    if (m->n_satellites >= 0) int_line(f, "  NUMBER OF CONTRIBUTING SATELLITES", m->n_satellites);
    if (!isnan(m->elevation_cutoff_deg))
        int_line(f, "  ELEVATION CUT-OFF ANGLE (DEGREES)", (int)lround(m->elevation_cutoff_deg));
    if (!isnan(m->max_tec_tecu))
        fprintf(f, "%-47s:%8.2f%9.2f\n", "  MAXIMUM TEC AND ITS RMS ERROR (TECU)", m->max_tec_tecu, 0.0);
    text_line(f, "COMMENT / WARNING                              :", m->comment);
    heading(f, "COEFFICIENTS");
    heading(f, "DEGREE  ORDER    VALUE (TECU)   RMS (TECU)");
    for (size_t i = 0; i < m->n_coefficients; i++) {
        const orr_ion_coefficient *k = &m->coefficient[i];
        fprintf(f, "%4d%8d%18.8f", k->degree, k->order, k->tecu);
        if (!isnan(k->rms_tecu)) fprintf(f, "%11.4f", k->rms_tecu);
        fputc('\n', f);
    }
    fputc('\n', f);
}

static orr_status check(const orr_ion_model *m, size_t i, orr_diag *diag)
{
    if (m->n_coefficients == 0 || m->from == ORR_TIME_NONE || m->max_degree < 0 || m->max_order < 0)
        return orr_diag_set(diag, ORR_E_ARG, "model %zu lacks its coefficients, its epoch or its degree",
                            i + 1);
    orr_civil c;
    orr_time_to_civil(m->from, ORR_SCALE_GPS, NULL, &c);
    if (c.ns != 0) return orr_diag_set(diag, ORR_E_ARG, ".ION epochs are whole seconds");
    for (size_t k = 0; k < m->n_coefficients; k++)
        if (!(fabs(m->coefficient[k].tecu) < 1e8) || fabs(m->coefficient[k].rms_tecu) >= 1e5)
            return orr_diag_set(diag, ORR_E_RANGE, "coefficient %zu of model %zu does not fit its columns",
                                k + 1, i + 1);
    return ORR_OK;
}

orr_status orr_ion_write(const orr_ion *x, const char *path, orr_diag *diag)
{
    if (x->n_models == 0) return orr_diag_set(diag, ORR_E_ARG, "there is no model to write");
    orr_status s = ORR_OK;
    for (size_t i = 0; i < x->n_models && s == ORR_OK; i++) s = check(&x->model[i], i, diag);
    if (s != ORR_OK) return s;
    orr_outfile f;
    s = orr_outfile_open(path, &f, diag);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i < x->n_models; i++) write_model(f.stream, &x->model[i]);
    return orr_outfile_commit(&f, diag);
}

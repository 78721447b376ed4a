// SPDX-License-Identifier: GPL-3.0-or-later
#include "ingest/telemetry/telemetry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/telemetry/telemetry_private.h"

#define KEPT_ROWS 24u // sentences on rows that are handed on, so that two logs leave room for others

void orr_telemetry_free(orr_telemetry *t)
{
    free(t->position_t_s);
    free(t->position);
    free(t->position_line);
    free(t->attitude_t_s);
    free(t->heading_rad);
    free(t->pitch_rad);
    free(t->roll_rad);
    free(t->attitude_line);
    memset(t, 0, sizeof *t);
}

// Heights above sea level to heights above the ellipsoid.
static void raise_to_ellipsoid(telemetry_reader *r)
{
    if (r->n_above_sea == 0) return;
    orr_geoid *geoid;
    orr_telemetry *t = r->out;
    if (orr_geoid_open(NULL, NULL, &geoid, NULL) != ORR_OK) {
        orr_warnings_add(
            r->notes, orr_input_name(r->in), 0, 0,
            "%zu heights are above sea level, and nothing tells the geoid's height there: they are taken "
            "as ellipsoidal, which is off by up to 100 m (install a geoid for GeographicLib: "
            "geographiclib-get-geoids egm96-5)",
            r->n_above_sea);
        return;
    }
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t k = 0; k < r->n_above_sea; k++) {
        orr_geodetic *at = &t->position[r->above_sea[k]];
        double n = orr_geoid_height_m(geoid, at->lat_rad, at->lon_rad);
        at->height_m += n;
        low = fmin(low, n);
        high = fmax(high, n);
    }
    orr_warnings_add(r->notes, orr_input_name(r->in), 0, 0,
                     "%zu heights are above sea level; the geoid %s adds %.1f to %.1f m", r->n_above_sea,
                     orr_geoid_name(geoid), low, high);
    orr_geoid_free(geoid);
}

// Sentences on rows behind those on the whole log.
static void hand_on(telemetry_reader *r)
{
    for (size_t k = 0; k < r->rows.kept && k < KEPT_ROWS; k++) {
        const orr_diag *d = &r->rows.item[k];
        orr_warnings_add(r->notes, d->file, d->line, d->column, "%s", d->text);
    }
    if (r->notes != NULL && r->rows.count > KEPT_ROWS) r->notes->count += r->rows.count - KEPT_ROWS;
}

static orr_status read_input(orr_input *in, const char *columns, const orr_leap_table *leap,
                             orr_telemetry *out, orr_warnings *w, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    telemetry_reader r = {.in = in, .out = out, .notes = w, .leap = leap};
    const size_t before = w != NULL ? w->kept : 0;
    bool nmea = columns == NULL && telemetry_is_nmea(orr_input_head(in));
    if (nmea) out->kind = ORR_TELEMETRY_NMEA;
    orr_status s = nmea ? telemetry_read_nmea(&r, diag) : telemetry_read_table(&r, columns, diag);
    if (s == ORR_OK && out->n_position == 0 && out->n_attitude == 0)
        s = orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(in), r.rows.kept > 0 ? r.rows.item[0].line : 0, 0,
                        "no row of telemetry could be used (%zu rows, %zu left out)%s%s", out->rows,
                        out->unreadable, r.rows.kept > 0 ? "; the first: " : "",
                        r.rows.kept > 0 ? r.rows.item[0].text : "");
    if (s == ORR_OK) raise_to_ellipsoid(&r);
    out->notes = w != NULL ? w->kept - before : 0;
    hand_on(&r);
    if (s != ORR_OK) orr_telemetry_free(out);
    orr_warnings_free(&r.rows);
    free(r.above_sea);
    return s;
}

orr_status orr_telemetry_read(const char *path, const char *columns, const orr_leap_table *leap,
                              orr_telemetry *out, orr_warnings *warnings, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_input *in;
    orr_status s = orr_input_open(path, NULL, &in, diag);
    if (s != ORR_OK) return s;
    s = read_input(in, columns, leap, out, warnings, diag);
    orr_input_close(in);
    return s;
}

orr_status orr_telemetry_read_bytes(const char *name, const void *data, size_t n, const char *columns,
                                    const orr_leap_table *leap, orr_telemetry *out, orr_warnings *warnings,
                                    orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_input *in;
    orr_status s = orr_input_open_bytes(name, data, n, NULL, &in, diag);
    if (s != ORR_OK) return s;
    s = read_input(in, columns, leap, out, warnings, diag);
    orr_input_close(in);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a log, whatever its format: kept, or left out with a reason.
#include "core/array.h"
#include "ingest/telemetry/telemetry_private.h"

void telemetry_drop(telemetry_reader *r, const char *why)
{
    r->out->unreadable++;
    orr_warnings_add(&r->rows, orr_input_name(r->in), orr_input_line_number(r->in), 0, "row left out: %s",
                     why);
}

orr_status telemetry_mark_above_sea(telemetry_reader *r, orr_diag *diag)
{
    if (!ORR_ARRAY_GROW(r->above_sea, r->n_above_sea))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows of telemetry", r->n_above_sea);
    r->above_sea[r->n_above_sea++] = r->out->n_position - 1;
    return ORR_OK;
}

orr_status telemetry_add_position(orr_telemetry *t, double t_s, orr_geodetic at, int64_t line, orr_diag *diag)
{
    size_t n = t->n_position;
    if (n >= ORR_TELEMETRY_MAX_ROWS)
        return orr_diag_set(diag, ORR_E_LIMIT, "more than %zu rows of telemetry", n);
    if (!ORR_ARRAY_GROW(t->position_t_s, n) || !ORR_ARRAY_GROW(t->position, n) ||
        !ORR_ARRAY_GROW(t->position_line, n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows of telemetry", n);
    t->position_t_s[n] = t_s;
    t->position[n] = at;
    t->position_line[n] = line;
    t->n_position = n + 1;
    return ORR_OK;
}

orr_status telemetry_add_attitude(orr_telemetry *t, double t_s, double heading_rad, double pitch_rad,
                                  double roll_rad, int64_t line, orr_diag *diag)
{
    size_t n = t->n_attitude;
    if (n >= ORR_TELEMETRY_MAX_ROWS)
        return orr_diag_set(diag, ORR_E_LIMIT, "more than %zu rows of telemetry", n);
    if (!ORR_ARRAY_GROW(t->attitude_t_s, n) || !ORR_ARRAY_GROW(t->heading_rad, n) ||
        !ORR_ARRAY_GROW(t->pitch_rad, n) || !ORR_ARRAY_GROW(t->roll_rad, n) ||
        !ORR_ARRAY_GROW(t->attitude_line, n))
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows of telemetry", n);
    t->attitude_t_s[n] = t_s;
    t->heading_rad[n] = heading_rad;
    t->pitch_rad[n] = pitch_rad;
    t->roll_rad[n] = roll_rad;
    t->attitude_line[n] = line;
    t->n_attitude = n + 1;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A trajectory through logs: one log with everything, or places in one and angles in another, on the same clock.
#include <stdlib.h>
#include <string.h>

#include "src/make/moving_private.h"

typedef struct joined {
    orr_telemetry log[2];
    size_t n;
    orr_telemetry *places, *angles; // of log[]; angles may be NULL, or the places' own log
    orr_telemetry_log view;
    orr_time zero;
    double *place_s, *angle_s; // times after zero
    const orr_leap_table *leap;
} joined;

static void joined_free(joined *j)
{
    for (size_t k = 0; k < j->n; k++) orr_telemetry_free(&j->log[k]);
    free(j->place_s);
    free(j->angle_s);
}

// Instant of the clock's zero where no date goes with it: midnight UTC of the date, or begin of the week, that `day`
// has in GPS time.
static orr_time assumed_zero(double period_s, orr_time day, const orr_leap_table *leap)
{
    int32_t number;
    if (period_s == 604800.0) {
        int64_t ns;
        orr_time_week(day, &number, &ns);
        return orr_time_from_week(number, 0);
    }
    double fraction;
    orr_time_mjd(day, ORR_SCALE_GPS, NULL, &number, &fraction);
    return orr_time_from_mjd(number, 0.0, ORR_SCALE_UTC, leap);
}

// Times of one log on the clock of the other: n times t_s to out_s.
static void bring(const orr_telemetry *log, const orr_telemetry *other, const joined *j, const double *t_s,
                  size_t n, double *out_s)
{
    bool tied =
        !log->absolute && other != NULL && other->tie.n > 0; // the other tells GPS time beside this clock
    double shift = log->absolute ? orr_time_diff_s(log->t0, j->zero)
                   : log->period_s > 0.0
                       ? orr_time_diff_s(assumed_zero(log->period_s, j->zero, j->leap), j->zero)
                       : 0.0;
    for (size_t k = 0; k < n; k++) out_s[k] = tied ? orr_clock_tied_s(&other->tie, t_s[k]) : t_s[k] + shift;
}

static orr_status join(joined *j, orr_time fallback, orr_diag *diag)
{
    for (size_t k = 0; k < j->n; k++) {
        if (j->log[k].n_position > 0 && j->places == NULL) j->places = &j->log[k];
        if (j->log[k].n_attitude > 0 && (j->angles == NULL || j->log[k].n_position == 0))
            j->angles = &j->log[k];
    }
    orr_telemetry *p = j->places, *a = j->angles;
    if (p == NULL)
        return orr_diag_set(diag, ORR_E_NODATA, "the telemetry has angles, but no place in any file");
    const orr_telemetry *dated = p->absolute || a == NULL || !a->absolute ? p : a;
    j->zero = dated->absolute         ? dated->t0
              : dated->period_s > 0.0 ? assumed_zero(dated->period_s, fallback, j->leap)
                                      : 0;
    j->place_s = malloc(p->n_position * sizeof *j->place_s);
    j->angle_s = malloc((a != NULL ? a->n_attitude + 1 : 1) * sizeof *j->angle_s);
    if (j->place_s == NULL || j->angle_s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    bring(p, a != p ? a : NULL, j, p->position_t_s, p->n_position, j->place_s);
    j->view = (orr_telemetry_log){.n_position = p->n_position,
                                  .position_t_s = j->place_s,
                                  .position = p->position,
                                  .position_row = p->position_line};
    if (a == NULL) return ORR_OK;
    bring(a, a != p ? p : NULL, j, a->attitude_t_s, a->n_attitude, j->angle_s);
    j->view.n_attitude = a->n_attitude;
    j->view.attitude_t_s = j->angle_s;
    j->view.heading_rad = a->heading_rad;
    j->view.pitch_rad = a->pitch_rad;
    j->view.roll_rad = a->roll_rad;
    j->view.attitude_row = a->attitude_line;
    return ORR_OK;
}

// The begin of a motion through a log: what the scenario wishes, what the log tells, or an assumption that is told.
static void date_log(const orr_scenario_trajectory *m, const joined *j, orr_time fallback,
                     orr_warnings *warnings, orr_moving *out)
{
    bool absolute = j->places->absolute || (j->angles != NULL && j->angles->absolute);
    char text[ORR_TIME_TEXT];
    if (m->has_start) {
        out->trajectory.t0 = m->start; // moves the whole flight there
    } else if (!absolute && j->places->period_s > 0.0) {
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "the log tells no date: its times of %s are assumed to be those of %.10s%s (--start or "
            "trajectory.start tells another)",
            j->places->period_s == 604800.0 ? "week" : "day",
            j->places->period_s == 604800.0 ? orr_time_format(j->zero, ORR_SCALE_GPS, 0, NULL, text)
                                            : orr_time_format(j->zero, ORR_SCALE_UTC, 0, j->leap, text),
            j->places->period_s == 604800.0 ? " and after" : " UTC");
    } else if (!absolute) {
        out->trajectory.t0 = fallback;
        orr_warnings_add(
            warnings, NULL, 0, 0,
            "the log tells no date: its begin is assumed to be %s GPS (--start or trajectory.start tells "
            "another)",
            orr_time_text(fallback, text));
    }
    double wish_s = (double)m->duration_ns * 1e-9;
    if (wish_s > out->trajectory.end_s + 1e-6)
        orr_warnings_add(warnings, NULL, 0, 0, "a duration of %.3f s is wanted, and the log holds %.3f s",
                         wish_s, out->trajectory.end_s);
    if (wish_s > 0.0 && wish_s < out->trajectory.end_s) out->trajectory.end_s = wish_s;
}

// Warnings from..to of a log handed on, and what was counted without being kept.
static void hand_on(const orr_warnings *from, size_t begin, size_t end, orr_warnings *to)
{
    for (size_t k = begin; k < end && k < from->kept; k++)
        orr_warnings_add(to, from->item[k].file, from->item[k].line, from->item[k].column, "%s",
                         from->item[k].text);
}

orr_status moving_make_telemetry(const orr_scenario_trajectory *m, orr_time fallback, orr_warnings *warnings,
                                 orr_moving *out, orr_diag *diag)
{
    joined j;
    orr_warnings of_log[ORR_TRAJECTORY_MAX_LOGS] = {{0}}; // sentences on whole logs go before those on rows
    memset(&j, 0, sizeof j);
    j.leap = out->inputs.leap;
    orr_status s = ORR_OK;
    for (size_t k = 0; k < m->logs.n && s == ORR_OK; k++) {
        const char *path = m->logs.item[k].file;
        orr_bytes raw;
        s = orr_inputs_read_raw(&out->inputs, path, 0, &raw, diag);
        if (s == ORR_OK)
            s = orr_telemetry_read_bytes(path, raw.text, raw.n, m->logs.item[k].columns, out->inputs.leap,
                                         &j.log[k], &of_log[k], diag);
        orr_bytes_free(&raw);
        hand_on(&of_log[k], 0, j.log[k].notes, warnings);
        j.n = k + 1;
    }
    if (s == ORR_OK) s = join(&j, fallback, diag);
    if (s == ORR_OK) {
        orr_fit_options o = orr_fit_options_default();
        o.degree = m->fit.degree == ORR_FIT_QUINTIC ? 5 : 3;
        o.position_per_knot = m->fit.position_per_knot;
        o.attitude_per_knot = m->fit.attitude_per_knot;
        o.max_gap_s = (double)m->fit.max_gap_ns * 1e-9;
        s = orr_trajectory_from_telemetry(j.zero, &j.view, &o, &out->trajectory, &out->report, diag);
        out->from_telemetry = s == ORR_OK;
    }
    if (s == ORR_OK) {
        date_log(m, &j, fallback, warnings, out);
        for (size_t k = 0; k < j.n && out->tie.n == 0; k++) {
            out->tie = j.log[k].tie;
            out->tie_zero = j.log[k].t0;
        }
    }
    for (size_t k = 0; k < j.n; k++) {
        hand_on(&of_log[k], j.log[k].notes, SIZE_MAX, warnings);
        if (warnings != NULL) warnings->count += of_log[k].count - of_log[k].kept;
        orr_warnings_free(&of_log[k]);
    }
    joined_free(&j);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/telemetry_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/telemetry_faults.h"

#define G_MPS2 9.80665

orr_fit_options orr_fit_options_default(void)
{
    return (orr_fit_options){
        .degree = 3, .max_gap_s = 10.0, .grid_s = 0.01, .jump_m = 3.0, .jump_rad = 8.0 * ORR_RAD_PER_DEG};
}

const char *orr_fault_name(orr_fault f)
{
    static const char *const name[] = {"repeated", "clock",      "frozen", "jump",
                                       "outside",  "not finite", "none"};
    return name[f];
}

void orr_fit_report_free(orr_fit_report *r)
{
    free(r->excluded);
    free(r->gap);
    memset(r, 0, sizeof *r);
}

static orr_status series_allocate(telemetry_series *s, bool attitude, size_t n, const double *t_s,
                                  orr_diag *diag)
{
    memset(s, 0, sizeof *s);
    s->attitude = attitude;
    s->n = n;
    s->dim = attitude ? 4 : 3;
    s->t_s = t_s;
    s->value = malloc((n + 1) * (size_t)s->dim * sizeof *s->value);
    s->fault = malloc((n + 1) * sizeof *s->fault);
    s->order = malloc((n + 1) * sizeof *s->order);
    if (s->value == NULL || s->fault == NULL || s->order == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu rows of telemetry", n);
    for (size_t i = 0; i < n; i++) s->fault[i] = isfinite(t_s[i]) ? ORR_FAULTS : ORR_FAULT_NOT_FINITE;
    return ORR_OK;
}

static void series_free(telemetry_series *s)
{
    free(s->value);
    free(s->fault);
    free(s->order);
}

// Places as ecef about the first good one.
static void fill_positions(const orr_telemetry_log *log, telemetry_series *s, orr_vec3 *origin)
{
    bool have = false;
    for (size_t i = 0; i < s->n; i++) {
        orr_geodetic g = log->position[i];
        if (!isfinite(g.lat_rad) || !isfinite(g.lon_rad) || !isfinite(g.height_m) ||
            fabs(g.lat_rad) > 0.5 * ORR_PI + 1e-12) {
            s->fault[i] = ORR_FAULT_NOT_FINITE;
            continue;
        }
        orr_vec3 r = orr_earth_to_ecef(g);
        if (!have) *origin = orr_vec3_make(nearbyint(r.x), nearbyint(r.y), nearbyint(r.z));
        have = true;
        s->value[3 * i] = r.x - origin->x;
        s->value[3 * i + 1] = r.y - origin->y;
        s->value[3 * i + 2] = r.z - origin->z;
    }
}

static double or_zero(double x) { return isnan(x) ? 0.0 : x; }

static const char *fault_words(orr_fault f)
{
    static const char *const words[] = {"the row before again",
                                        "times that do not ascend",
                                        "values that stand still while the body moves",
                                        "far off the motion around them",
                                        "beyond a gap that splits the log",
                                        "not finite",
                                        ""};
    return words[f];
}

static orr_status find_faults(telemetry_series *s, const orr_fit_options *o, orr_fit_report *report,
                              orr_diag *diag)
{
    orr_status status = telemetry_mark_clock(s, diag);
    if (status != ORR_OK) return status;
    telemetry_mark_frozen(s);
    status = telemetry_part(s, o->max_gap_s, report, diag);
    // A quaternion's distance is half the angle.
    if (status == ORR_OK) status = telemetry_mark_jumps(s, s->attitude ? 0.5 * o->jump_rad : o->jump_m, diag);
    if (status != ORR_OK) return status;
    size_t need = 8;
    if (s->n_good >= need) return ORR_OK;
    size_t count[ORR_FAULTS + 1] = {0}, worst = 0;
    for (size_t i = 0; i < s->n; i++) count[s->fault[i]]++;
    for (size_t f = 1; f < ORR_FAULTS; f++)
        if (count[f] > count[worst]) worst = f;
    return orr_diag_set(
        diag, ORR_E_NODATA,
        "%zu of %zu rows of %s can be used, and a trajectory needs %zu (%zu rows: %s); is this "
        "the right file, and are its columns and units declared rightly?",
        s->n_good, s->n, s->attitude ? "attitude" : "position", need, count[worst],
        fault_words((orr_fault)worst));
}

// Knot step: p usual intervals, on the grid.
static double knot_step(double per_knot, double wanted_s, double interval_s, double grid_s)
{
    double p = per_knot > 0.0 ? per_knot : fmax(1.0, nearbyint(wanted_s / interval_s));
    return fmax(1.0, nearbyint(p * interval_s / grid_s)) * grid_s;
}

// Attitude where none was recorded: heading along the course (held where the body hardly moves), pitch by the
// climb, roll of a coordinated turn.
static orr_angles angles_of_motion(const orr_trajectory *path, double t_s, double *held_heading)
{
    orr_motion m;
    path->evaluate(path->self, t_s, &m);
    orr_geodetic g = orr_earth_from_ecef(m.r_m);
    orr_mat3 E = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    orr_vec3 v = orr_mat3_apply(&E, m.v_mps), a = orr_mat3_apply(&E, m.a_mps2);
    double level = hypot(v.x, v.y);
    orr_angles out = {*held_heading, 0.0, 0.0};
    if (level > 1.0) {
        *held_heading = out.heading_rad = atan2(v.x, v.y);
        out.pitch_rad = atan2(v.z, level);
        out.roll_rad = atan((a.x * v.y - a.y * v.x) / (level * G_MPS2));
    }
    return out;
}

// Body from ecef: angles against enu at the smoothed place.
static orr_quat attitude_at(const orr_trajectory *path, double t_s, orr_angles a)
{
    orr_motion m;
    path->evaluate(path->self, t_s, &m);
    orr_geodetic g = orr_earth_from_ecef(m.r_m);
    orr_mat3 E = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad), L = orr_body_from_enu(a),
             B = orr_mat3_mul(&L, &E);
    return orr_quat_from_mat3(&B);
}

// Angles as sign-continuous quaternions of body from ecef, which know neither wraps nor poles. path begins at
// path_s.
static void fill_attitudes(const orr_telemetry_log *log, const orr_trajectory *path, double path_s,
                           telemetry_series *s, orr_fit_report *report)
{
    orr_quat last = {1, 0, 0, 0};
    double roll = 0.0, heading = 0.0, held = 0.0;
    bool have = false;
    for (size_t i = 0; i < s->n; i++) {
        orr_angles a = {log->heading_rad[i], or_zero(log->pitch_rad[i]), or_zero(log->roll_rad[i])};
        double inside = fmin(fmax(s->t_s[i] - path_s, 0.0), path->end_s);
        if (isnan(a.heading_rad) && s->fault[i] == ORR_FAULTS)
            a.heading_rad = angles_of_motion(path, inside, &held).heading_rad;
        if (!(fabs(a.heading_rad) < 1e3) || !(fabs(a.pitch_rad) < 1e3) || !(fabs(a.roll_rad) < 1e3))
            s->fault[i] = ORR_FAULT_NOT_FINITE;
        if (s->fault[i] != ORR_FAULTS) continue;
        if (have && (fabs(a.heading_rad - heading) > ORR_PI || fabs(a.roll_rad - roll) > ORR_PI))
            report->wraps++;
        heading = a.heading_rad;
        roll = a.roll_rad;
        orr_quat q = attitude_at(path, inside, a);
        if (have && orr_quat_dot(q, last) < 0.0) q = orr_quat_neg(q);
        last = q;
        have = true;
        s->value[4 * i] = q.w;
        s->value[4 * i + 1] = q.x;
        s->value[4 * i + 2] = q.y;
        s->value[4 * i + 3] = q.z;
    }
}

static orr_status report_rows(const telemetry_series *s, const int64_t *row, orr_fit_report *r,
                              orr_diag *diag)
{
    size_t n = 0;
    for (size_t i = 0; i < s->n; i++) n += s->fault[i] != ORR_FAULTS;
    if (n == 0) return ORR_OK;
    orr_excluded_row *more = realloc(r->excluded, (r->n_excluded + n) * sizeof *more);
    if (more == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the report of %zu rows", n);
    r->excluded = more;
    for (size_t i = 0; i < s->n; i++) {
        if (s->fault[i] == ORR_FAULTS) continue;
        r->count[s->attitude ? 1 : 0][s->fault[i]]++;
        r->excluded[r->n_excluded++] =
            (orr_excluded_row){s->attitude, s->fault[i], row != NULL ? row[i] : (int64_t)i + 1, s->t_s[i]};
    }
    return ORR_OK;
}

typedef struct fit {
    telemetry_series p, a;
    orr_vec3 origin;
    double *t_r, *t_q;
    orr_vec3 *r;
    orr_quat *q;
    size_t n_q;
} fit;

static void fit_free(fit *f)
{
    series_free(&f->p);
    series_free(&f->a);
    free(f->t_r);
    free(f->t_q);
    free(f->r);
    free(f->q);
}

static orr_status gather_positions(fit *f, double from_s, orr_diag *diag)
{
    size_t n = f->p.n_good;
    f->t_r = malloc(n * sizeof *f->t_r);
    f->r = malloc(n * sizeof *f->r);
    if (f->t_r == NULL || f->r == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu places", n);
    for (size_t k = 0; k < n; k++) {
        const double *v = f->p.value + 3 * f->p.order[k];
        f->t_r[k] = f->p.t_s[f->p.order[k]] - from_s;
        f->r[k] = orr_vec3_make(f->origin.x + v[0], f->origin.y + v[1], f->origin.z + v[2]);
    }
    return ORR_OK;
}

// Attitudes of the log's good rows, or of the motion every step_s, from from_s on.
static orr_status gather_attitudes(fit *f, const orr_trajectory *path, double path_s, double from_s,
                                   double to_s, double step_s, orr_diag *diag)
{
    bool recorded = f->a.n > 0;
    size_t n = recorded ? f->a.n_good : (size_t)ceil((to_s - from_s) / step_s) + 1;
    f->t_q = malloc(n * sizeof *f->t_q);
    f->q = malloc(n * sizeof *f->q);
    if (f->t_q == NULL || f->q == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu attitudes", n);
    double held = 0.0;
    for (size_t k = 0; k < n; k++) {
        if (recorded) {
            const double *v = f->a.value + 4 * f->a.order[k];
            f->t_q[k] = f->a.t_s[f->a.order[k]] - from_s;
            f->q[k] = (orr_quat){v[0], v[1], v[2], v[3]};
        } else {
            f->t_q[k] = fmin(step_s * (double)k, to_s - from_s);
            double t = f->t_q[k] + from_s - path_s;
            f->q[k] = attitude_at(path, t, angles_of_motion(path, t, &held));
        }
    }
    f->n_q = n;
    return ORR_OK;
}

// First and last multiple of grid_s inside [from_s, to_s].
static void snap(double grid_s, double *from_s, double *to_s)
{
    *from_s = ceil(*from_s / grid_s - 1e-6) * grid_s + 0.0; // no negative zero
    *to_s = floor(*to_s / grid_s + 1e-6) * grid_s;
}

// The places' spline alone, from *path_s on: attitudes are turned from enu there into ecef. Its own attitude
// is idle.
static orr_status lay_path(const orr_fit_options *o, fit *f, double knot_s, double *path_s,
                           orr_trajectory *path, orr_diag *diag)
{
    double to = f->p.t_s[f->p.order[f->p.n_good - 1]];
    *path_s = f->p.t_s[f->p.order[0]];
    snap(o->grid_s, path_s, &to);
    double span = to - *path_s;
    if (!(span >= 1.0))
        return orr_diag_set(diag, ORR_E_NODATA,
                            "the usable places span %.3f s; a trajectory needs a second at least", span);
    orr_status s = gather_positions(f, *path_s, diag);
    if (s != ORR_OK) return s;
    double idle_t[4] = {0.0, 0.3 * span, 0.7 * span, span};
    orr_quat level[4] = {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
    orr_spline_samples samples = {
        .n_r = f->p.n_good, .r_t_s = f->t_r, .r_m = f->r, .n_q = 4, .q_t_s = idle_t, .q_be = level};
    orr_spline_plan place = {.degree = o->degree, .knot_step_s = knot_s, .roughness = 1e-7};
    orr_spline_plan idle = {.degree = 3, .knot_step_s = knot_s * ceil(span / knot_s), .roughness = 1e-9};
    return orr_trajectory_from_samples(0, 0.0, span, &samples, place, idle, path, NULL, diag);
}

// Both splines over the time that places and angles have in common.
static orr_status lay_splines(orr_time log_t0, const orr_fit_options *o, const orr_trajectory *path,
                              double path_s, fit *f, orr_trajectory *out, orr_fit_report *rep, orr_diag *diag)
{
    double from = f->p.t_s[f->p.order[0]], to = f->p.t_s[f->p.order[f->p.n_good - 1]];
    if (f->a.n > 0) {
        from = fmax(from, f->a.t_s[f->a.order[0]]);
        to = fmin(to, f->a.t_s[f->a.order[f->a.n_good - 1]]);
    }
    snap(o->grid_s, &from, &to);
    if (!(to - from >= 1.0))
        return orr_diag_set(diag, ORR_E_NODATA,
                            "places and angles have no second in common (%.3f s to %.3f s); are both times "
                            "on one clock and in the "
                            "right unit?",
                            from, to);
    rep->from_s = from;
    rep->to_s = to;
    for (size_t k = 0; k < f->p.n_good; k++) f->t_r[k] = f->p.t_s[f->p.order[k]] - from;
    orr_status s = gather_attitudes(f, path, path_s, from, to, rep->attitude_knot_s, diag);
    if (s != ORR_OK) return s;
    orr_spline_samples samples = {
        .n_r = f->p.n_good, .r_t_s = f->t_r, .r_m = f->r, .n_q = f->n_q, .q_t_s = f->t_q, .q_be = f->q};
    orr_spline_plan place = {.degree = o->degree, .knot_step_s = rep->position_knot_s, .roughness = 1e-7};
    orr_spline_plan angle = {.degree = o->degree, .knot_step_s = rep->attitude_knot_s, .roughness = 1e-7};
    return orr_trajectory_from_samples(orr_time_add_s(log_t0, from), 0.0, to - from, &samples, place, angle,
                                       out, &rep->residuals, diag);
}

static void choose_knots(const orr_fit_options *o, const fit *f, orr_fit_report *rep)
{
    double usual_a = f->a.n > 1 ? f->a.interval_s : 0.0;
    double pk = knot_step(o->position_per_knot, 1.0, f->p.interval_s, o->grid_s);
    double ak = usual_a > 0.0 ? knot_step(o->attitude_per_knot, 0.2, usual_a, o->grid_s) : pk;
    // One knot step has to be a multiple of the other.
    if (pk >= ak)
        pk = nearbyint(pk / ak) * ak;
    else
        ak = nearbyint(ak / pk) * pk;
    rep->position_interval_s = f->p.interval_s;
    rep->attitude_interval_s = usual_a;
    rep->position_knot_s = pk;
    rep->attitude_knot_s = ak;
}

orr_status orr_trajectory_from_telemetry(orr_time log_t0, const orr_telemetry_log *log,
                                         const orr_fit_options *options, orr_trajectory *out,
                                         orr_fit_report *report, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    memset(report, 0, sizeof *report);
    if (!(options->grid_s > 0.0) || !(options->max_gap_s > 0.0) ||
        (options->degree != 3 && options->degree != 5) || !(options->jump_m > 0.0) ||
        !(options->jump_rad > 0.0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "a fit has degree 3 or 5, and grid, gap and jump limits above 0");
    fit f;
    memset(&f, 0, sizeof f);
    report->positions = log->n_position;
    report->attitudes = log->n_attitude;
    if (log->n_position < 8)
        return orr_diag_set(diag, ORR_E_NODATA,
                            "%zu rows with a place are no flight; a trajectory needs at least 8",
                            log->n_position);
    orr_status s = series_allocate(&f.p, false, log->n_position, log->position_t_s, diag);
    if (s == ORR_OK && log->n_attitude > 0)
        s = series_allocate(&f.a, true, log->n_attitude, log->attitude_t_s, diag);
    if (s == ORR_OK) {
        fill_positions(log, &f.p, &f.origin);
        s = find_faults(&f.p, options, report, diag);
    }
    orr_trajectory path = {0};
    double path_s = 0.0;
    if (s == ORR_OK)
        s = lay_path(options, &f, knot_step(options->position_per_knot, 1.0, f.p.interval_s, options->grid_s),
                     &path_s, &path, diag);
    if (s == ORR_OK && f.a.n > 0) {
        // Only what lies beside the places that are used can be of use.
        for (size_t i = 0; i < f.a.n; i++)
            if (f.a.fault[i] == ORR_FAULTS &&
                (f.a.t_s[i] < path_s - 1.0 || f.a.t_s[i] > path_s + path.end_s + 1.0))
                f.a.fault[i] = ORR_FAULT_OUTSIDE;
        fill_attitudes(log, &path, path_s, &f.a, report);
        s = find_faults(&f.a, options, report, diag);
    }
    report->attitude_from_motion = f.a.n == 0;
    if (s == ORR_OK) {
        choose_knots(options, &f, report);
        s = lay_splines(log_t0, options, &path, path_s, &f, out, report, diag);
    }
    if (path.evaluate != NULL) orr_trajectory_free(&path);
    if (s == ORR_OK) s = report_rows(&f.p, log->position_row, report, diag);
    if (s == ORR_OK && f.a.n > 0) s = report_rows(&f.a, log->attitude_row, report, diag);
    report->positions_used = f.p.n_good;
    report->attitudes_used = f.a.n_good;
    fit_free(&f);
    if (s != ORR_OK) {
        if (out->evaluate != NULL) orr_trajectory_free(out);
        orr_fit_report_free(report);
    }
    return s;
}

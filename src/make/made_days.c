// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/made_days.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/parallel.h"
#include "ingest/sp3/sp3.h"
#include "orbit/force/integrate.h"
#include "src/make/long_name.h"

#define DAY_S 86400.0
#define GRAVITY_DEGREE 8
#define SRP_MPS2 1e-7

// The systems take turns, each in its own height and inclination; planes 0.7 rad and satellites 1.9 rad from each other.
enum { SYSTEMS = 3 };
static const struct {
    char system;
    double a_m, i_rad;
} LAYOUT[SYSTEMS] = {{'G', 26.56e6, 0.96}, {'R', 25.51e6, 1.13}, {'E', 29.60e6, 0.98}};

static orr_sat name_of(size_t k) { return orr_sat_make(LAYOUT[k % SYSTEMS].system, (int)(k / SYSTEMS) + 1); }

static void begin(size_t k, orr_vec3 *r, orr_vec3 *v)
{
    const double a = LAYOUT[k % SYSTEMS].a_m, i = LAYOUT[k % SYSTEMS].i_rad;
    const double node = 0.7 * (double)(k / SYSTEMS), u = 1.9 * (double)k;
    const orr_vec3 n = {cos(node), sin(node), 0}, m = {-sin(node) * cos(i), cos(node) * cos(i), sin(i)};
    *r = orr_vec3_scale(a, orr_vec3_add(orr_vec3_scale(cos(u), n), orr_vec3_scale(sin(u), m)));
    *v = orr_vec3_scale(sqrt(ORR_EGM96_GM / a),
                        orr_vec3_add(orr_vec3_scale(-sin(u), n), orr_vec3_scale(cos(u), m)));
}

bool orr_made_has(orr_sat sat)
{
    for (size_t k = 0; k < ORR_MADE_SATS; k++)
        if (name_of(k) == sat) return true;
    return false;
}

// A satellite on its way; its state is that of the day's begin.
typedef struct made_sat {
    orr_sat sat;
    size_t k; // its place in the layout
    orr_vec3 r, v;
    orr_status status;
} made_sat;

typedef struct made_day {
    const orr_made_plan *plan;
    orr_time begin;
    const orr_force *force;
    const orr_sky *sky;
    made_sat *sat;
    orr_sp3 *file;
} made_day;

static int by_name(const void *a, const void *b)
{
    return (int)((const made_sat *)a)->sat - (int)((const made_sat *)b)->sat;
}

// From t to `to` (s of the day), with the pushes between: those at t have been, those at `to` not yet.
static orr_status go(const made_day *d, made_sat *x, orr_integrator *it, double t, double to)
{
    orr_status s = ORR_OK;
    for (size_t k = 0; k < d->plan->n_push && s == ORR_OK; k++) {
        const orr_made_push *p = &d->plan->push[k];
        const double at = orr_time_diff_s(p->t, d->begin);
        if (p->sat != x->sat || at < t || at >= to) continue;
        s = orr_integrate(it, t, at - t, &x->r, &x->v);
        t = at;
        x->v = orr_vec3_add(x->v, orr_vec3_scale(p->along_mps / orr_vec3_norm(x->v), x->v));
    }
    return s == ORR_OK ? orr_integrate(it, t, to - t, &x->r, &x->v) : s;
}

static void carry_on(void *user, size_t i)
{
    const made_day *d = user;
    made_sat *x = &d->sat[i];
    orr_integrator *it = NULL;
    const double step_s = d->file->interval_s;
    x->status = orr_integrator_init(d->force, d->sky, &it, NULL);
    for (size_t e = 0; e < d->file->n_epochs && x->status == ORR_OK; e++) {
        const double t_s = step_s * (double)e;
        orr_sky_point p;
        orr_sky_at(d->sky, t_s, &p);
        const orr_vec3 at = orr_mat3_apply(&p.R, x->r);
        orr_sp3_record *q = &d->file->record[e * d->file->n_sats + i];
        q->pos_m[0] = at.x, q->pos_m[1] = at.y, q->pos_m[2] = at.z;
        q->clock_s = 1e-5 * (double)x->k + 1e-11 * orr_time_diff_s(d->file->epoch[e], d->plan->from);
        x->status = go(d, x, it, t_s, t_s + step_s);
    }
    orr_integrator_free(it);
}

static orr_status comments(orr_sp3 *f, orr_diag *diag)
{
    static const char *const text[] = {
        "MADE DATA, NO REAL ORBITS: MADE BY ORRERY " ORR_VERSION " MAKE-DAYS",
        "INTEGRATED: EGM96 TO DEGREE 8, SUN, MOON, LIGHT 1E-7 M/S2",
        "CLOCKS WITHOUT PERIODIC RELATIVITY",
    };
    enum { LINES = sizeof text / sizeof text[0] };
    f->comment = calloc(LINES, sizeof *f->comment);
    for (size_t k = 0; k < LINES && f->comment != NULL; k++)
        if ((f->comment[f->n_comments] = strdup(text[k])) != NULL) f->n_comments++;
    return f->n_comments == LINES ? ORR_OK
                                  : orr_diag_set(diag, ORR_E_MEMORY, "no memory for a file's comments");
}

static orr_status day_alloc(const made_day *d, size_t n, orr_sp3 *f, orr_diag *diag)
{
    const int64_t day_ns = ORR_S_PER_DAY * ORR_NS_PER_S;
    const orr_status s = orr_sp3_alloc(n, (size_t)(day_ns / d->plan->step_ns), f, diag);
    if (s != ORR_OK) return s;
    f->version = 'd';
    f->interval_s = (double)d->plan->step_ns * 1e-9;
    strcpy(f->data_used, "MADE");
    strcpy(f->coordinates, "IGS20");
    strcpy(f->orbit_type, "EXT");
    strcpy(f->agency, "ORRY");
    for (size_t k = 0; k < n; k++) f->sat[k] = d->sat[k].sat;
    for (size_t e = 0; e < f->n_epochs; e++)
        f->epoch[e] = orr_time_add(d->begin, (int64_t)e * d->plan->step_ns);
    return comments(f, diag);
}

static orr_status make_day(made_day *d, size_t k, size_t n, orr_diag *diag)
{
    char path[ORR_MADE_PATH], name[ORR_SAT_TEXT];
    orr_sp3 file = {0};
    orr_sky *sky = NULL;
    d->begin = orr_time_add(d->plan->from, (int64_t)k * ORR_S_PER_DAY * ORR_NS_PER_S);
    orr_status s = orr_made_path(d->plan, k, path, diag);
    if (s == ORR_OK) s = day_alloc(d, n, &file, diag);
    if (s == ORR_OK)
        s = orr_sky_init(d->begin, orr_time_add_s(d->begin, DAY_S), ORR_SKY_GCRS, NULL, NULL, &sky, NULL,
                         diag);
    if (s == ORR_OK) {
        d->sky = sky;
        d->file = &file;
        orr_parallel_each(n, d->plan->jobs, carry_on, d);
    }
    for (size_t i = 0; i < n && s == ORR_OK; i++)
        if (d->sat[i].status != ORR_OK)
            s = orr_diag_set(diag, d->sat[i].status, "%s: %s", orr_sat_text(d->sat[i].sat, name),
                             d->sat[i].status == ORR_E_MEMORY ? "no memory for its orbit"
                                                              : "its orbit becomes impossible");
    if (s == ORR_OK) s = orr_sp3_write(&file, path, diag);
    orr_sky_free(sky);
    orr_sp3_free(&file);
    return s;
}

orr_status orr_made_path(const orr_made_plan *p, size_t k, char path[ORR_MADE_PATH], orr_diag *diag)
{
    const int64_t day_ns = ORR_S_PER_DAY * ORR_NS_PER_S;
    return orr_long_name(p->folder, "TST", orr_time_add(p->from, (int64_t)k * day_ns), day_ns, p->step_ns,
                         "ORB.SP3", ORR_MADE_PATH, path, diag);
}

orr_status orr_made_check(const orr_made_plan *p, orr_diag *diag)
{
    const int64_t day_ns = ORR_S_PER_DAY * ORR_NS_PER_S;
    char name[ORR_SAT_TEXT], text[ORR_TIME_TEXT];
    if (p->step_ns < ORR_NS_PER_S || p->step_ns % ORR_NS_PER_S != 0 || day_ns % p->step_ns != 0)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a step of %g s: whole seconds are wanted, that a day is a multiple of",
                            (double)p->step_ns * 1e-9);
    if (p->days < 1 || p->days > ORR_MADE_MOST_DAYS)
        return orr_diag_set(diag, ORR_E_ARG, "%zu days: 1 to %d can be made", p->days, ORR_MADE_MOST_DAYS);
    for (size_t k = 0; k < p->n_push; k++) {
        const orr_made_push *q = &p->push[k];
        if (!orr_made_has(q->sat) || (p->only != NULL && !orr_sat_set_has(p->only, q->sat)))
            return orr_diag_set(diag, ORR_E_ARG, "a push of %s, which is not made",
                                orr_sat_text(q->sat, name));
        if (q->t < p->from || orr_time_sub_ns(q->t, p->from) >= (int64_t)p->days * day_ns)
            return orr_diag_set(diag, ORR_E_ARG, "a push at %s, which is on none of the days",
                                orr_time_text(q->t, text));
    }
    for (size_t k = 0; k < ORR_MADE_SATS; k++)
        if (p->only == NULL || orr_sat_set_has(p->only, name_of(k))) return ORR_OK;
    return orr_diag_set(diag, ORR_E_NODATA,
                        "none of the satellites is made: there are G01-G27, R01-R27 and E01-E26");
}

orr_status orr_made_days(const orr_made_plan *p, orr_diag *diag)
{
    made_sat sat[ORR_MADE_SATS] = {0};
    orr_force force = {.sun_moon = true, .srp_mps2 = SRP_MPS2};
    made_day day = {.plan = p, .force = &force, .sat = sat};
    size_t n = 0;
    orr_status s = orr_made_check(p, diag);
    if (s == ORR_OK) s = orr_gravity_field_init(&force.earth, GRAVITY_DEGREE, false, diag);
    if (s != ORR_OK) return s;
    for (size_t k = 0; k < ORR_MADE_SATS; k++) {
        if (p->only != NULL && !orr_sat_set_has(p->only, name_of(k))) continue;
        sat[n] = (made_sat){.sat = name_of(k), .k = k};
        begin(k, &sat[n].r, &sat[n].v);
        n++;
    }
    qsort(sat, n, sizeof sat[0], by_name);
    for (size_t k = 0; k < p->days && s == ORR_OK; k++) {
        s = make_day(&day, k, n, diag);
        if (s == ORR_OK && p->done != NULL) p->done(p->user, k + 1);
    }
    return s;
}

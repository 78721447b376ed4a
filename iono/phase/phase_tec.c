// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/phase/phase_tec.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/astro.h"
#include "core/nan.h"
#include "ingest/rinex/rinex_obs.h"
#include "iono/phase/clock_steps.h"
#include "iono/phase/phase_read.h"
#include "iono/phase/signals.h"
#include "iono/phase/windup.h"

orr_phase_options orr_phase_default_options(void)
{
    return (orr_phase_options){.from = ORR_TIME_NONE,
                               .to = ORR_TIME_NONE,
                               .mask_rad = 10 * ORR_RAD_PER_DEG,
                               .shell_radius_m = ORR_SHELL_RADIUS_M,
                               .windup = true,
                               .arcs = orr_arc_default_options(),
                               .max_samples = 50000000};
}

// The Sun's ecef position every ten minutes; straight lines between are good to 0.02 degrees.
typedef struct sun_table {
    orr_time t0;
    size_t n;
    orr_vec3 *at;
} sun_table;
#define SUN_STEP_NS (600 * ORR_NS_PER_S)

static orr_status sun_init(sun_table *s, orr_time from, orr_time to, const orr_leap_table *leap,
                           orr_diag *diag)
{
    s->t0 = from;
    s->n = (size_t)((to - from) / SUN_STEP_NS) + 2;
    s->at = malloc(s->n * sizeof *s->at);
    if (s->at == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the Sun");
    for (size_t i = 0; i < s->n; i++) {
        orr_time t = from + (int64_t)i * SUN_STEP_NS;
        orr_eop eop = orr_eop_at(NULL, t, leap, NULL);
        orr_mat3 rotation;
        orr_astro_gcrs_to_itrs(t, &eop, leap, &rotation, NULL);
        s->at[i] = orr_mat3_apply(&rotation, orr_astro_sun(t));
    }
    return ORR_OK;
}

static orr_vec3 sun_at(const sun_table *s, orr_time t)
{
    size_t i = (size_t)((t - s->t0) / SUN_STEP_NS);
    double w = (double)(t - s->t0 - (int64_t)i * SUN_STEP_NS) / (double)SUN_STEP_NS;
    return orr_vec3_axpy(w, orr_vec3_sub(s->at[i + 1], s->at[i]), s->at[i]);
}

static void phase_sat_free(orr_phase_sat *s)
{
    free(s->t);
    free(s->gf_tecu);
    free(s->code_tecu);
    free(s->windup);
    free(s->pierce);
    orr_arcs_free(&s->arcs);
}

// What the phase centre of each carrier adds to the range from the centre of mass, taken out: metres to add to what was
// measured on carriers 1 and 2. The satellite keeps nominal yaw. False where the file has not both carriers.
static bool antenna_shift(const orr_antex *antex, const phase_choice *c, orr_sat sat, orr_time t,
                          orr_vec3 pos_m, orr_vec3 sun_m, orr_vec3 site_m, double shift_m[2])
{
    const orr_antex_antenna *a = orr_antex_find_sat(antex, sat, t);
    if (a == NULL) return false;
    orr_vec3 z = orr_vec3_scale(-1, orr_vec3_unit(pos_m));
    orr_vec3 y = orr_vec3_unit(orr_vec3_cross(z, orr_vec3_unit(orr_vec3_sub(sun_m, pos_m))));
    orr_vec3 x = orr_vec3_cross(y, z), down = orr_vec3_unit(orr_vec3_sub(site_m, pos_m));
    for (int i = 0; i < 2; i++) {
        const char code[4] = {orr_sat_system(sat), '0', c->phase[i][1], '\0'};
        const orr_antex_frequency *f = orr_antex_find_frequency(a, code);
        if (f == NULL) return false;
        shift_m[i] = f->offset_m[0] * orr_vec3_dot(down, x) + f->offset_m[1] * orr_vec3_dot(down, y) +
                     f->offset_m[2] * orr_vec3_dot(down, z);
    }
    return true;
}

static orr_status make_sat(const phase_reading *r, size_t slot, const sun_table *sun, orr_phase_tec *out,
                           bool *known, orr_diag *diag)
{
    const orr_phase_options *o = r->o;
    const phase_raw *w = &r->raw[slot];
    const phase_choice *c = r->choice[slot];
    orr_phase_sat s = {.sat = orr_sat_make(ORR_SYSTEMS[slot / 100], (int)(slot % 100))};
    memcpy(s.phase, c->phase, sizeof s.phase);
    memcpy(s.range, c->range, sizeof s.range);
    memcpy(s.freq_hz, c->freq_hz, sizeof s.freq_hz);
    s.t = malloc((w->n + 1) * sizeof *s.t);
    s.gf_tecu = malloc((w->n + 1) * sizeof *s.gf_tecu);
    s.code_tecu = malloc((w->n + 1) * sizeof *s.code_tecu);
    s.windup = malloc((w->n + 1) * sizeof *s.windup);
    s.pierce = calloc(w->n + 1, sizeof *s.pierce);
    double *mw = malloc((w->n + 1) * sizeof *mw), *seconds = malloc((w->n + 1) * sizeof *seconds);
    uint8_t *lost = malloc(w->n + 1);
    orr_status status = ORR_OK;
    if (!s.t || !s.gf_tecu || !s.code_tecu || !s.windup || !s.pierce || !mw || !seconds || !lost)
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the phases of a satellite");
    double f1 = s.freq_hz[0], f2 = s.freq_hz[1], l1 = ORR_LIGHT_MPS / f1, l2 = ORR_LIGHT_MPS / f2;
    double k = orr_tecu_per_metre(f1, f2), turns = 0;
    bool pending = false, antenna = o->antex == NULL;
    *known = o->position == NULL;
    for (size_t i = 0; status == ORR_OK && i < w->n; i++) {
        pending |= w->lost[i];
        double wind = 0, shift[2] = {0};
        if (o->position != NULL) {
            orr_vec3 pos;
            if (!o->position(o->user, s.sat, w->t[i], &pos)) continue;
            *known = true;
            if (orr_pierce_ray(&out->site, pos, o->shell_radius_m, &s.pierce[s.n], NULL) != ORR_OK ||
                s.pierce[s.n].el_rad < o->mask_rad)
                continue;
            if (o->windup) wind = turns = orr_windup_turns(&out->site, pos, sun_at(sun, w->t[i]), turns);
            if (o->antex != NULL &&
                antenna_shift(o->antex, c, s.sat, w->t[i], pos, sun_at(sun, w->t[i]), out->site.pos_m, shift))
                antenna = true;
            else
                shift[0] = shift[1] = 0;
        }
        const double *v = w->value[i];
        double z1 = v[0] - wind, z2 = v[1] - wind;
        s.t[s.n] = w->t[i];
        seconds[s.n] = orr_time_diff_s(w->t[i], w->t[0]);
        s.windup[s.n] = wind;
        s.gf_tecu[s.n] = k * (l1 * z1 + shift[0] - l2 * z2 - shift[1]);
        s.code_tecu[s.n] = k * (v[3] + shift[1] - v[2] - shift[0]);
        mw[s.n] = z1 - z2 - (f1 * v[2] + f2 * v[3]) * (f1 - f2) / ((f1 + f2) * ORR_LIGHT_MPS);
        lost[s.n] = pending;
        pending = false;
        s.n++;
    }
    if (status == ORR_OK && s.n > 0) {
        orr_arc_series series = {s.n, seconds, s.gf_tecu, mw, lost, k * l1, k * l2};
        status = orr_arcs_find(&series, &o->arcs, &s.arcs, diag);
    }
    if (!antenna) out->n_without_antenna++;
    free(mw);
    free(seconds);
    free(lost);
    if (status != ORR_OK || s.n == 0) {
        phase_sat_free(&s);
        return status;
    }
    for (size_t i = 0; i < s.n; i++) s.gf_tecu[i] -= s.arcs.fix_tecu[i];
    out->sat[out->n_sats++] = s;
    return ORR_OK;
}

static orr_status undo_clock_steps(phase_reading *r, orr_phase_tec *out, orr_diag *diag)
{
    orr_clock_series *series = calloc(ORR_SAT_SLOTS, sizeof *series);
    if (series == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for observations");
    size_t n = 0;
    for (size_t slot = 0; slot < ORR_SAT_SLOTS; slot++)
        if (r->choice[slot] != NULL && r->raw[slot].n > 0)
            series[n++] = (orr_clock_series){r->raw[slot].n, r->raw[slot].t, r->raw[slot].value,
                                             ORR_LIGHT_MPS / r->choice[slot]->freq_hz[0]};
    orr_status s = orr_clock_steps_undo(series, n, r->epoch, r->n_epochs, &out->n_clock_steps, diag);
    free(series);
    return s;
}

static orr_status finish(phase_reading *r, const char *path, orr_phase_tec *out, orr_diag *diag)
{
    if (r->n_epochs == 0)
        return orr_diag_at(diag, ORR_E_NODATA, path, 0, 0, "no epoch of observations in the time asked for");
    out->n_epochs = r->n_epochs;
    out->from = r->epoch[0];
    out->to = r->epoch[r->n_epochs - 1];
    if (out->to < out->from) return orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "epochs go backward in time");
    orr_status s = undo_clock_steps(r, out, diag);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i + 1 < r->n_epochs; i++) r->epoch[i] = r->epoch[i + 1] - r->epoch[i];
    if (r->n_epochs > 1) {
        qsort(r->epoch, r->n_epochs - 1, sizeof *r->epoch, orr_time_order);
        out->interval_s = (double)r->epoch[(r->n_epochs - 1) / 2] * 1e-9;
    }
    out->has_geometry = r->o->position != NULL;
    out->sat = calloc(ORR_SAT_SLOTS, sizeof *out->sat);
    if (out->sat == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for satellites");
    sun_table sun = {0};
    if (r->o->position != NULL && (r->o->windup || r->o->antex != NULL))
        s = sun_init(&sun, out->from, out->to, r->o->leap, diag);
    size_t dual = 0;
    for (size_t slot = 0; s == ORR_OK && slot < ORR_SAT_SLOTS; slot++) {
        if (r->tally[slot] == NULL) continue;
        if (r->choice[slot] == NULL || r->raw[slot].n == 0) {
            out->n_single++;
            continue;
        }
        bool known;
        dual++;
        s = make_sat(r, slot, &sun, out, &known, diag);
        if (!known) out->n_unknown++;
    }
    free(sun.at);
    if (s != ORR_OK) return s;
    if (dual == 0)
        return orr_diag_at(diag, ORR_E_NODATA, path, 0, 0,
                           "no satellite has carrier phases on two frequencies (%zu have one or none)",
                           out->n_single);
    if (out->n_sats == 0)
        return orr_diag_at(
            diag, ORR_E_NODATA, path, 0, 0,
            "none of its %zu satellites is above the mask with a known position (%zu are not in the orbit)",
            dual, out->n_unknown);
    return ORR_OK;
}

orr_status orr_phase_tec_make(const char *name, const void *data, size_t n, const orr_phase_options *options,
                              orr_phase_tec *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_phase_tec){0};
    const orr_phase_options o = options != NULL ? *options : orr_phase_default_options();
    phase_reading *r;
    orr_status s = phase_read(name, data, n, &o, &r, warnings, diag);
    if (s != ORR_OK) return s;
    memcpy(out->marker, r->marker, sizeof out->marker);
    out->site = r->site;
    s = finish(r, name, out, diag);
    phase_reading_free(r);
    if (s != ORR_OK) orr_phase_tec_free(out);
    return s;
}

void orr_phase_tec_free(orr_phase_tec *p)
{
    for (size_t i = 0; i < p->n_sats; i++) phase_sat_free(&p->sat[i]);
    free(p->sat);
    *p = (orr_phase_tec){0};
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/antenna/antenna.h"

#include <math.h>
#include <stdio.h>

#include "core/angle.h"

// East, North and Up of the place; at a pole East is y, as of longitude 0.
static void set_enu(orr_antenna_state *x)
{
    const orr_vec3 up = orr_earth_up(x->r_m);
    const double level = sqrt(up.x * up.x + up.y * up.y);
    const orr_vec3 east = level > 0 ? (orr_vec3){-up.y / level, up.x / level, 0} : (orr_vec3){0, 1, 0};
    const orr_vec3 north = orr_vec3_cross(up, east);
    x->enu = (orr_mat3){{{east.x, east.y, east.z}, {north.x, north.y, north.z}, {up.x, up.y, up.z}}};
}

static void stand_at(orr_vec3 r_m, orr_antenna_state *out)
{
    *out = (orr_antenna_state){.r_m = r_m};
    set_enu(out);
    out->axes = out->enu;
}

static orr_vec3 ecef_of(const double *position)
{
    return orr_earth_to_ecef(
        (orr_geodetic){position[0] * ORR_RAD_PER_DEG, position[1] * ORR_RAD_PER_DEG, position[2]});
}

static orr_status find_type(const orr_marks *marks, const orr_antex *antex, size_t k, orr_antenna *a,
                            orr_warnings *warnings, orr_diag *diag)
{
    char path[40], why[160];
    snprintf(path, sizeof path, "antennas[%zu].type", k);
    if (antex == NULL) {
        snprintf(why, sizeof why, "'%.60s' needs an ANTEX file (channel.antex or navdata.antex)", a->type);
        return orr_marks_blame(marks, ORR_E_NODATA, path, why, diag);
    }
    bool radome_ignored = false;
    a->antex = orr_antex_find_receiver(antex, a->type, &radome_ignored);
    if (a->antex == NULL) {
        snprintf(why, sizeof why, "the ANTEX file has no antenna '%.60s'", a->type);
        return orr_marks_blame(marks, ORR_E_NODATA, path, why, diag);
    }
    if (radome_ignored)
        orr_warnings_add(warnings, "", 0, 0, "antennas[%zu].type: ANTEX has '%s' without this radome only", k,
                         a->type);
    return ORR_OK;
}

// The scenario without antennas: its receiver.
static orr_status of_receiver(const orr_scenario *s, const orr_source_motion *motion, const orr_vec3 *station,
                              orr_antenna *out, orr_diag *diag)
{
    snprintf(out->name, sizeof out->name, "receiver");
    if (s->receiver.position.n == 3) {
        stand_at(ecef_of(s->receiver.position.item), &out->fixed);
    } else if (motion != NULL) {
        out->motion = motion;
        out->unit = (size_t)s->receiver.unit;
    } else if (station != NULL) {
        stand_at(*station, &out->fixed);
    } else {
        return orr_marks_blame(&s->marks, ORR_E_NODATA, "signals",
                               "they are sent, but nothing receives them: the scenario has no antennas, "
                               "receiver.position or trajectory",
                               diag);
    }
    return ORR_OK;
}

orr_status orr_antenna_open(const orr_scenario *s, size_t k, const orr_source_motion *motion,
                            const orr_vec3 *station, const orr_antex *antex, orr_antenna *out,
                            orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_antenna){.unit = 0};
    if (s->antennas.n == 0) return of_receiver(s, motion, station, out, diag);
    const orr_scenario_antenna *a = &s->antennas.item[k];
    if (a->name != NULL)
        snprintf(out->name, sizeof out->name, "%s", a->name);
    else
        snprintf(out->name, sizeof out->name, "antenna%zu", k);
    if (a->position.n == 3) {
        stand_at(ecef_of(a->position.item), &out->fixed);
        const orr_vec3 offset =
            orr_mat3_apply_t(&out->fixed.enu, (orr_vec3){a->east_m, a->north_m, a->height_m});
        stand_at(orr_vec3_add(out->fixed.r_m, offset), &out->fixed);
    } else {
        out->motion = motion;
        out->unit = (size_t)a->unit;
        out->arm_m = (orr_vec3){a->right_m, a->forward_m, a->up_m};
    }
    if (a->type == NULL) return ORR_OK;
    snprintf(out->type, sizeof out->type, "%s", a->type);
    return find_type(&s->marks, antex, k, out, warnings, diag);
}

orr_antenna_state orr_antenna_carried(const orr_antenna_state *state, double s)
{
    orr_antenna_state x = *state;
    x.r_m = orr_vec3_axpy(s, state->v_mps, state->r_m);
    set_enu(&x);
    return x;
}

void orr_antenna_ride(const orr_antenna *a, const orr_motion *m, bool arm, orr_antenna_state *out)
{
    const orr_mat3 body = orr_mat3_from_quat(m->q_be);
    const orr_vec3 arm_m = arm ? a->arm_m : (orr_vec3){0, 0, 0};
    *out = (orr_antenna_state){
        .r_m = orr_vec3_add(m->r_m, orr_mat3_apply_t(&body, arm_m)),
        .v_mps = orr_vec3_add(m->v_mps, orr_mat3_apply_t(&body, orr_vec3_cross(m->w_radps, arm_m))),
        .axes = body,
        .w_radps = orr_mat3_apply_t(&body, m->w_radps)};
    set_enu(out);
    const orr_vec3 v = orr_mat3_apply(&out->enu, out->v_mps);
    const double r = orr_vec3_norm(out->r_m);
    const double tan_lat = out->enu.m[2][2] / out->enu.m[1][2]; // Up and North along the Earth's axis
    out->enu_radps = orr_mat3_apply_t(&out->enu, (orr_vec3){-v.y / r, v.x / r, v.x / r * tan_lat});
}

orr_answer orr_antenna_at(const orr_antenna *a, orr_time t, orr_antenna_state *out)
{
    if (a->motion == NULL) {
        *out = a->fixed;
        return ORR_ANSWER_OK;
    }
    if (a->line != NULL) {
        *out = orr_antenna_carried(&a->line->at, orr_time_diff_s(t, a->line->t));
        return ORR_ANSWER_OK;
    }
    orr_motion m;
    const orr_answer answer = orr_source_motion_at(a->motion, a->unit, t, &m);
    if (answer == ORR_ANSWER_OK) orr_antenna_ride(a, &m, true, out);
    return answer;
}

// Carrier of an ANTEX frequency code, Hz; 0 where nothing sends there.
static double hz_of(const char *code)
{
    size_t n;
    const orr_signal *list = orr_signals(&n);
    for (size_t k = 0; k < n; k++)
        if (list[k].antex[0] == code[0] && list[k].antex[1] == code[1] && list[k].antex[2] == code[2])
            return list[k].carrier_hz;
    return 0;
}

const orr_antex_frequency *orr_antenna_frequency(const orr_antex_antenna *a, const orr_signal *s,
                                                 double carrier_hz)
{
    const orr_antex_frequency *nearest = orr_antex_find_frequency(a, s->antex);
    if (nearest != NULL) return nearest;
    double least = (double)INFINITY;
    for (size_t k = 0; k < a->n_frequencies; k++) {
        const double hz = hz_of(a->frequency[k].code), off = fabs(hz - carrier_hz);
        if (hz == 0 || off >= least) continue;
        least = off;
        nearest = &a->frequency[k];
    }
    return nearest;
}

orr_antenna_direction orr_antenna_toward(const orr_antenna_state *state, orr_vec3 u, orr_vec3 u_rate_ps)
{
    orr_antenna_direction d = {.own = orr_mat3_apply(&state->axes, u),
                               .own_rate_ps = orr_mat3_apply(
                                   &state->axes, orr_vec3_sub(u_rate_ps, orr_vec3_cross(state->w_radps, u)))};
    const orr_vec3 o = d.own, r = d.own_rate_ps;
    const double level = fmax(o.x * o.x + o.y * o.y, 1e-12); // at the zenith there is no azimuth
    d.az_deg = orr_atan2(o.x, o.y) * ORR_DEG_PER_RAD;
    d.zenith_deg = orr_atan2(sqrt(level), o.z) * ORR_DEG_PER_RAD;
    d.az_rate_dps = (r.x * o.y - o.x * r.y) / level * ORR_DEG_PER_RAD;
    d.zenith_rate_dps = -r.z / sqrt(level) * ORR_DEG_PER_RAD;
    return d;
}

double orr_antenna_range_m(const orr_antenna *a, const orr_antenna_direction *d, size_t signal,
                           double *rate_mps)
{
    const orr_antex_frequency *f = a->centre[signal];
    *rate_mps = 0;
    if (f == NULL) return 0;
    const double *o = f->offset_m, later_s = 1e-3; // between the table's nodes the variation is linear
    const double now = orr_antex_variation_m(a->antex, f, d->az_deg, d->zenith_deg),
                 later = orr_antex_variation_m(a->antex, f, d->az_deg + later_s * d->az_rate_dps,
                                               d->zenith_deg + later_s * d->zenith_rate_dps);
    *rate_mps = -(o[0] * d->own_rate_ps.y + o[1] * d->own_rate_ps.x + o[2] * d->own_rate_ps.z) +
                (later - now) / later_s;
    return -(o[0] * d->own.y + o[1] * d->own.x + o[2] * d->own.z) + now;
}

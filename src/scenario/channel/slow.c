// SPDX-License-Identifier: GPL-3.0-or-later
// The slow terms at an instant, each by its own routine.
#include "src/scenario/channel/slow.h"

#include <math.h>

#include "core/angle.h"
#include "core/nan.h"
#include "iono/field/pierce.h"
#include "src/scenario/channel/light.h"
#include "src/scenario/channel/power.h"
#include "src/scenario/troposphere/troposphere.h"

// An antenna at an instant, and what all satellites share then.
typedef struct moment {
    const orr_channels *c;
    size_t antenna;
    orr_time t;
    const orr_antenna_state *at;
    bool slopes; // of delays by metres are wanted
    orr_vec3 sun_m;
    orr_site_moved moved;                  // of a fixed antenna
    orr_troposphere_site site, site_above; // at the antenna, and a metre above it
} moment;

// One satellite at a moment.
typedef struct ray {
    const channel_satellite *sat;
    size_t place;
    satellite_state reception;
    double az_rad, el_rad;
    orr_light light;
    orr_attitude attitude;
    bool has_attitude;
    const orr_antex_antenna *antex; // NULL: none
} ray;

static bool look(const moment *m, orr_channel_work *work, size_t place, ray *r)
{
    const orr_channels *c = m->c;
    const orr_ephemeris *e = channels_ephemeris(c);
    satellite_cell *cell = work->satellite[place];
    *r = (ray){.sat = &c->satellite[place], .place = place};
    if (!satellite_at(e, r->sat->sat, cell, m->t, 0, &r->reception)) return false;
    const orr_vec3 d = orr_vec3_sub(r->reception.pos_m, m->at->r_m), own = orr_mat3_apply(&m->at->enu, d);
    r->az_rad = orr_atan2(own.x, own.y);
    r->el_rad = orr_atan2(own.z, sqrt(own.x * own.x + own.y * own.y));
    const double tau_s = orr_vec3_norm(d) / ORR_LIGHT_MPS;
    satellite_state emission;
    if (!satellite_at(e, r->sat->sat, cell, m->t, tau_s, &emission)) return false;
    orr_light_close(tau_s, emission.pos_m, emission.vel_mps, m->at->r_m, m->at->v_mps, &r->light);
    return true;
}

// What the ionosphere's fast effects need of the ray's pierce point; none below the horizon.
static void set_fast_ionosphere(const moment *m, const ray *r, slow_values *out)
{
    const orr_channels *c = m->c;
    orr_iono_site site;
    orr_pierce p;
    if (c->disturbance == NULL && c->scintillation == NULL) return;
    if (orr_iono_site_at(m->at->r_m, &site, NULL) != ORR_OK ||
        orr_pierce_ray(&site, r->reception.pos_m, ORR_SHELL_RADIUS_M, &p, NULL) != ORR_OK)
        return;
    if (c->scintillation != NULL) {
        const orr_scintillation_now now = orr_scintillation_at(c->scintillation, r->sat->sat, m->t, &p);
        out->v[SLOW_S4] = now.s4;
        out->v[SLOW_SIGMA_PHI] = now.sigma_phi_rad;
    }
    if (c->disturbance == NULL) return;
    const double here = orr_disturbance_tecu(c->disturbance, m->t, &p);
    out->v[SLOW_DISTURBANCE] = here;
    if (!m->slopes) return;
    const double aside_m = 100;
    for (int axis = 0; axis < 3; axis++) {
        const orr_vec3 e = {m->at->enu.m[axis][0], m->at->enu.m[axis][1], m->at->enu.m[axis][2]};
        orr_vec3 *slope = &out->per_m[SLOW_DISTURBANCE - SLOW_HYDROSTATIC];
        if (orr_iono_site_at(orr_vec3_axpy(aside_m, e, m->at->r_m), &site, NULL) == ORR_OK &&
            orr_pierce_ray(&site, r->reception.pos_m, ORR_SHELL_RADIUS_M, &p, NULL) == ORR_OK)
            *slope =
                orr_vec3_axpy((orr_disturbance_tecu(c->disturbance, m->t, &p) - here) / aside_m, e, *slope);
    }
}

static void set_attitude(const moment *m, ray *r, slow_values *out)
{
    const orr_vec3 x = r->reception.pos_m, v = orr_velocity_inertial(x, r->reception.vel_mps);
    if (r->sat->orbit_normal) orr_attitude_orbit_normal(x, v, m->sun_m, &r->attitude);
    r->has_attitude = r->sat->orbit_normal ||
                      orr_attitude_by_law(r->sat->law, m->t, x, v, m->sun_m, &r->attitude) == ORR_OK;
    if (r->has_attitude && r->attitude.fast_turn) out->flags |= ORR_CHANNEL_FAST_TURN;
}

// Delays, and what they change by when the antenna moves: by its height; and by its elevation, which changes as the direction to
// the satellite and as the vertical turns.
static void set_troposphere(const moment *m, const ray *r, slow_values *out)
{
    if (m->c->troposphere == NULL) return;
    const orr_zenith_delay d = orr_troposphere_slant(&m->site, r->az_rad, r->el_rad);
    out->v[SLOW_HYDROSTATIC] = d.hydrostatic_m;
    out->v[SLOW_WET] = d.wet_m;
    if (!m->slopes) return;
    const double step_rad = 1e-6;
    const orr_zenith_delay above = orr_troposphere_slant(&m->site_above, r->az_rad, r->el_rad);
    const orr_zenith_delay higher = orr_troposphere_slant(&m->site, r->az_rad, r->el_rad + step_rad);
    const orr_vec3 up = {m->at->enu.m[2][0], m->at->enu.m[2][1], m->at->enu.m[2][2]}, u = r->light.u;
    const double s = sin(r->el_rad);
    const orr_vec3 across = orr_vec3_axpy(-s, u, up), level = orr_vec3_axpy(-s, up, u);
    const orr_vec3 el_per_m = orr_vec3_scale(
        1 / fmax(cos(r->el_rad), 1e-6),
        orr_vec3_axpy(1 / orr_vec3_norm(m->at->r_m), level, orr_vec3_scale(-1 / r->light.range_m, across)));
    out->per_m[0] = orr_vec3_axpy((higher.hydrostatic_m - d.hydrostatic_m) / step_rad, el_per_m,
                                  orr_vec3_scale(above.hydrostatic_m - d.hydrostatic_m, up));
    out->per_m[SLOW_WET - SLOW_HYDROSTATIC] = orr_vec3_axpy((higher.wet_m - d.wet_m) / step_rad, el_per_m,
                                                            orr_vec3_scale(above.wet_m - d.wet_m, up));
}

// What a phase centre at `body` of the satellite's axes adds to the range, exactly.
static double offset_m(const ray *r, orr_vec3 body)
{
    const double range = r->light.range_m;
    const orr_vec3 a = orr_mat3_apply_t(&r->attitude.body, body), d = orr_vec3_scale(range, r->light.u);
    const double longer = orr_vec3_norm(orr_vec3_add(d, a));
    return (2 * orr_vec3_dot(d, a) + orr_vec3_dot(a, a)) / (longer + range);
}

// What the satellite's phase centre adds to the range: that of the offset, and the variation by nadir angle and azimuth; of an
// antenna that nobody knows what a recorded day tells of it.
static double satellite_antenna_m(const ray *r, const orr_signal *s, double carrier_hz, double nadir_deg,
                                  double az_deg)
{
    const orr_replay_sat *record = r->sat->record;
    if (!r->has_attitude) return 0;
    if (r->antex == NULL) return record != NULL && record->estimated ? offset_m(r, record->offset_m) : 0;
    const orr_antex_frequency *f = orr_antenna_frequency(r->antex, s, carrier_hz);
    if (f == NULL) return 0;
    const orr_vec3 body = {f->offset_m[0], f->offset_m[1], f->offset_m[2]};
    return offset_m(r, body) + orr_antex_variation_m(r->antex, f, az_deg, nadir_deg);
}

static void set_signals(const moment *m, const ray *r, slow_values *out)
{
    const orr_antenna *a = &m->c->antenna[m->antenna];
    const orr_signal *all = orr_signals(&(size_t){0});
    double nadir_deg = 0, az_deg = 0;
    if (r->antex != NULL && r->has_attitude) {
        const orr_vec3 to = orr_mat3_apply(&r->attitude.body, orr_vec3_scale(-1, r->light.u));
        nadir_deg = orr_atan2(sqrt(to.x * to.x + to.y * to.y), to.z) * ORR_DEG_PER_RAD;
        az_deg = orr_atan2(to.y, to.x) * ORR_DEG_PER_RAD;
    }
    const double gain_db =
        orr_power_gain_db(r->light.sat_m, m->at->r_m, r->el_rad, &m->c->options.side_lobes) +
        r->sat->power_db;
    orr_antenna_direction toward = {.az_deg = 0};
    if (a->antex != NULL && a->motion == NULL)
        toward = orr_antenna_toward(m->at, r->light.u, r->light.u_rate_ps);
    for (size_t j = 0; j < r->sat->n_sent; j++) {
        double rate;
        const channel_sent *sent = &r->sat->sent[j];
        const orr_signal *s = &all[sent->signal];
        out->v[slow_of(j, SLOW_SATELLITE_ANTENNA)] =
            satellite_antenna_m(r, s, sent->carrier_hz, nadir_deg, az_deg);
        if (a->motion == NULL)
            out->v[slow_of(j, SLOW_RECEIVER_ANTENNA)] = orr_antenna_range_m(a, &toward, sent->signal, &rate);
        out->v[slow_of(j, SLOW_POWER)] = sent->power_dbw + gain_db;
    }
}

static void trace(const moment *m, ray *r, slow_values *out)
{
    const orr_channels *c = m->c;
    const orr_light *l = &r->light;
    out->v[SLOW_FLIGHT] = l->tau_s;
    if (c->options.shapiro) out->v[SLOW_SHAPIRO] = orr_light_shapiro_m(m->at->r_m, l->sat_m, l->range_m);
    out->v[SLOW_APPROACH] = -orr_vec3_dot(l->u, l->sat_v_mps) / ORR_LIGHT_MPS;
    set_troposphere(m, r, out);
    set_fast_ionosphere(m, r, out);
    out->v[SLOW_SOLID_TIDE] = -orr_vec3_dot(l->u, m->moved.solid_m);
    out->v[SLOW_POLE_TIDE] = -orr_vec3_dot(l->u, m->moved.pole_m);
    out->v[SLOW_OCEAN_LOADING] = -orr_vec3_dot(l->u, m->moved.ocean_m);
    set_attitude(m, r, out);
    if (c->options.windup && r->has_attitude)
        out->v[SLOW_TURNS] =
            orr_windup_still(&c->windup[m->antenna], r->place, m->t, m->at, l->sat_m, &r->attitude.body);
    if (c->antex != NULL) {
        r->antex = orr_antex_find_sat(c->antex, r->sat->sat, m->t);
        if (r->antex == NULL) out->flags |= ORR_CHANNEL_NO_ANTENNA;
    }
    set_signals(m, r, out);
}

// The Earth's magnetic field where a ray pierces the ionosphere's shell, along the way of its signal, T.
static double field_along_t(const moment *m, const orr_iono_site *site, orr_vec3 sat_m)
{
    orr_pierce p;
    if (orr_pierce_ray(site, sat_m, ORR_SHELL_RADIUS_M, &p, NULL) != ORR_OK) return 0;
    const orr_geodetic place = orr_earth_from_ecef(orr_vec3_scale(ORR_SHELL_RADIUS_M, p.unit));
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    const orr_vec3 way = orr_mat3_apply(&enu, orr_vec3_unit(orr_vec3_sub(site->pos_m, sat_m)));
    const double year = 2000 + (orr_time_diff_s(m->t, m->c->span.from) / 86400 + m->c->begin_days) / 365.25;
    return 1e-9 * orr_vec3_dot(way, orr_magnetic_field_nt(m->c->magnetic, year, place));
}

static void set_second_order(const moment *m, const orr_vec3 *sat_m, size_t n, slow_values *out)
{
    orr_iono_site site;
    if (!m->c->options.second_order || orr_iono_site_at(m->at->r_m, &site, NULL) != ORR_OK) return;
    for (size_t k = 0; k < n; k++)
        if (out[k].ok)
            out[k].v[SLOW_CONTENT_FIELD] = out[k].v[SLOW_CONTENT] * field_along_t(m, &site, sat_m[k]);
}

// Slant contents; a satellite without a value has no channel.
static void set_contents(const moment *m, const orr_sat *sat, const orr_vec3 *sat_m, size_t n,
                         slow_values *out)
{
    double tecu[SLOW_BATCH];
    if (m->c->iono == NULL) return;
    const bool covered =
        orr_source_iono_contents(m->c->iono, m->t, m->at->r_m, sat, sat_m, n, tecu) == ORR_ANSWER_OK;
    for (size_t k = 0; k < n; k++) {
        out[k].v[SLOW_CONTENT] = covered ? tecu[k] : ORR_NAN;
        out[k].ok = out[k].ok && !isnan(out[k].v[SLOW_CONTENT]);
    }
    set_second_order(m, sat_m, n, out);
    if (!covered || !m->slopes) return;
    const double aside_m = 100; // East, North and Up; contents bend by 1e-9 TECU/m^2
    for (int axis = 0; axis < 3; axis++) {
        double aside_tecu[SLOW_BATCH];
        const orr_vec3 e = {m->at->enu.m[axis][0], m->at->enu.m[axis][1], m->at->enu.m[axis][2]};
        if (orr_source_iono_contents(m->c->iono, m->t, orr_vec3_axpy(aside_m, e, m->at->r_m), sat, sat_m, n,
                                     aside_tecu) != ORR_ANSWER_OK)
            continue;
        for (size_t k = 0; k < n; k++) {
            orr_vec3 *slope = &out[k].per_m[SLOW_CONTENT - SLOW_HYDROSTATIC];
            if (!isnan(aside_tecu[k])) *slope = orr_vec3_axpy((aside_tecu[k] - tecu[k]) / aside_m, e, *slope);
        }
    }
}

void slow_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
             const orr_antenna_state *at, bool slopes, const uint16_t *place, size_t n, slow_values *out)
{
    moment m = {.c = c,
                .antenna = antenna,
                .t = t,
                .at = at,
                .slopes = slopes,
                .sun_m = orr_sun_track_at(&c->sun, t)};
    orr_sat sat[SLOW_BATCH];
    orr_vec3 sat_m[SLOW_BATCH];
    if (c->antenna[antenna].motion == NULL) m.moved = orr_site_track_at(&c->ground[antenna], t);
    if (c->troposphere != NULL) {
        const orr_geodetic place_of = orr_earth_from_ecef(at->r_m);
        orr_geodetic above = place_of;
        above.height_m += 1;
        m.site = orr_channels_troposphere(c, antenna, place_of, t);
        if (slopes) m.site_above = orr_channels_troposphere(c, antenna, above, t);
    }
    for (size_t k = 0; k < n; k++) {
        ray r;
        out[k] = (slow_values){.ok = orr_span_holds(c->span, t) && look(&m, work, place[k], &r)};
        if (out[k].ok) trace(&m, &r, &out[k]);
        sat[k] = c->satellite[place[k]].sat;
        sat_m[k] = out[k].ok ? r.reception.pos_m : (orr_vec3){0, 0, 0};
    }
    set_contents(&m, sat, sat_m, n, out);
}

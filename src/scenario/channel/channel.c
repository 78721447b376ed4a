// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation: the terms of every channel of an antenna at an instant, their rates, their sums.
#include "src/scenario/channel/channel.h"

#include <math.h>
#include <string.h>

#include "core/rng.h"
#include "iono/field/pierce.h"
#include "orbit/spacecraft/attitude_laws.h"
#include "src/scenario/channel/channels_private.h"
#include "src/scenario/channel/light.h"
#include "src/scenario/channel/power.h"
#include "src/scenario/troposphere/troposphere.h"

const orr_term_row orr_term_rows[ORR_N_TERMS] = {
#define ORR_TERM(NAME, name, code, carrier, meaning) {name, meaning, code, carrier},
#include "src/scenario/channel/terms.def"
#undef ORR_TERM
};

// Rates of all terms but those of geometry and clock are differences over this time on both sides. The fastest of
// them follow the antenna's attitude (its phase centre, wind-up): at 10 rad/s the difference errs by (0.1)^2 / 6 = 0.2 %
// of a rate of centimetres a second. Rounding of 300 m of terms leaves 3e-12 m/s.
static const int64_t SIDE_NS = ORR_NS_PER_S / 100;

// An antenna at an instant, and the Sun.
typedef struct moment {
    const orr_channels *c;
    size_t antenna;
    orr_time t;
    orr_antenna_state at;
    orr_vec3 sun_m;
} moment;

// One satellite at a moment: what all its signals share.
typedef struct ray {
    const channel_satellite *sat;
    size_t place;            // in c->satellite
    orr_sat_state reception; // as the product has it at reception: what STATES and DELAYS speak of
    orr_light light;
    double az_rad, el_rad;
    orr_attitude attitude;
    bool has_attitude;
    double shared_m[ORR_N_TERMS];
    double windup_cycles;
    double stec_tecu;
    const orr_antex_antenna *antex; // NULL: none
    uint32_t flags;
} ray;

static bool moment_at(const orr_channels *c, size_t antenna, orr_time t, moment *m)
{
    *m = (moment){.c = c, .antenna = antenna, .t = t};
    if (orr_antenna_at(&c->antenna[antenna], t, &m->at) != ORR_ANSWER_OK) return false;
    m->sun_m = orr_sun_track_at(&c->sun, t);
    return true;
}

// Elevation below which nothing is seen at an azimuth.
static double horizon_rad(const orr_scenario_mask *mask, double az_rad)
{
    const size_t n = mask->horizon.n;
    double el = mask->elevation_deg;
    if (n > 0) {
        const orr_scenario_obstacle *o = mask->horizon.item;
        const double az = az_rad * ORR_DEG_PER_RAD;
        size_t k = 0;
        while (k < n && o[k].azimuth_deg <= az) k++;
        const orr_scenario_obstacle *a = &o[(k + n - 1) % n], *b = &o[k % n];
        double span = b->azimuth_deg - a->azimuth_deg, in = az - a->azimuth_deg;
        if (k == 0 || k == n) {
            span += 360;
            if (in < 0) in += 360;
        }
        const double part = span > 0 ? in / span : 0;
        el = fmax(el, a->elevation_deg + part * (b->elevation_deg - a->elevation_deg));
    }
    return el * ORR_RAD_PER_DEG;
}

// Where the satellite stands, by its place at reception; false where it has no arc.
static bool look(const moment *m, size_t place, ray *r)
{
    const orr_channels *c = m->c;
    *r = (ray){.sat = &c->satellite[place], .place = place};
    if (orr_ephemeris_eval(orr_source_orbit_ephemeris(c->orbits), r->sat->sat, m->t, &r->reception) != ORR_OK)
        return false;
    const orr_vec3 d = orr_mat3_apply(&m->at.enu, orr_vec3_sub(r->reception.pos_m, m->at.r_m));
    const double az = atan2(d.x, d.y);
    r->az_rad = az < 0 ? az + 2 * ORR_PI : az;
    r->el_rad = atan2(d.z, hypot(d.x, d.y));
    return true;
}

static bool seen(const moment *m, const ray *r)
{
    const orr_scenario_mask *mask = &m->c->mask;
    if (!(r->el_rad >= horizon_rad(mask, r->az_rad))) return false;
    if (!mask->has_body || m->c->antenna[m->antenna].motion == NULL) return true;
    const orr_vec3 u = orr_vec3_unit(orr_vec3_sub(r->reception.pos_m, m->at.r_m)),
                   own = orr_mat3_apply(&m->at.axes, u);
    return asin(fmin(fmax(own.z, -1), 1)) >= mask->body_deg * ORR_RAD_PER_DEG;
}

// Satellite clock, with the scenario's policy for holes; false where there is no channel.
static bool set_clock(const orr_channels *c, ray *r)
{
    const orr_sat_state *x = &r->light.emission;
    r->flags |= r->sat->flags | (x->flags & ORR_EPH_ECLIPSE ? ORR_CHANNEL_ECLIPSE : 0u);
    if ((x->flags & ORR_EPH_CLOCK_VALID) != 0) {
        r->shared_m[ORR_TERM_SATELLITE_CLOCK] = -ORR_LIGHT_MPS * x->clock_s;
        if (c->options.relativity)
            r->shared_m[ORR_TERM_RELATIVITY] = 2 / ORR_LIGHT_MPS * orr_vec3_dot(x->pos_m, x->vel_mps);
        return true;
    }
    if (c->options.clock_holes != ORR_CLOCK_HOLE_ZERO) return false;
    r->flags |= ORR_CHANNEL_ZERO_CLOCK;
    return true;
}

static void set_attitude(const moment *m, ray *r)
{
    const orr_sat_state *x = &r->reception;
    const orr_vec3 v = orr_velocity_inertial(x->pos_m, x->vel_mps);
    if (r->sat->orbit_normal) orr_attitude_orbit_normal(x->pos_m, v, m->sun_m, &r->attitude);
    r->has_attitude = r->sat->orbit_normal ||
                      orr_attitude_by_law(r->sat->law, x->pos_m, v, m->sun_m, &r->attitude) == ORR_OK;
    if (r->has_attitude && r->attitude.fast_turn) r->flags |= ORR_CHANNEL_FAST_TURN;
}

// The light and the terms that all signals of a satellite share; false where there is no channel.
static bool trace(const moment *m, ray *r)
{
    const orr_channels *c = m->c;
    const orr_light *l = &r->light;
    double *x = r->shared_m;
    if (orr_light_from(orr_source_orbit_ephemeris(c->orbits), m->t, &r->reception, m->at.r_m, m->at.v_mps,
                       &r->light) != ORR_OK ||
        !set_clock(c, r))
        return false;
    x[ORR_TERM_DISTANCE] = l->distance_m;
    x[ORR_TERM_SAGNAC] = l->range_m - l->distance_m;
    if (c->options.shapiro) x[ORR_TERM_SHAPIRO] = orr_light_shapiro_m(m->at.r_m, l->sat_m, l->range_m);
    if (c->has_troposphere) {
        const orr_zenith_delay d = orr_troposphere_delay(&c->troposphere, m->at.place, r->el_rad, m->t);
        x[ORR_TERM_TROPOSPHERE_HYDROSTATIC] = d.hydrostatic_m;
        x[ORR_TERM_TROPOSPHERE_WET] = d.wet_m;
    }
    set_attitude(m, r);
    if (c->options.windup && r->has_attitude)
        r->windup_cycles =
            orr_windup_at(&c->windup[m->antenna], r->place, m->t, &m->at, l->sat_m, &r->attitude.body);
    if (c->has_antex) {
        r->antex = orr_antex_find_sat(&c->antex, r->sat->sat, m->t);
        if (r->antex == NULL) r->flags |= ORR_CHANNEL_NO_ANTENNA;
    }
    return true;
}

// What the satellite's phase centre adds to the range: exactly that of the offset, and the variation by nadir angle.
static double satellite_antenna_m(const ray *r, const orr_signal *s, double carrier_hz)
{
    if (r->antex == NULL || !r->has_attitude) return 0;
    const orr_antex_frequency *f = orr_antenna_frequency(r->antex, s, carrier_hz);
    if (f == NULL) return 0;
    const orr_vec3 body = {f->offset_m[0], f->offset_m[1], f->offset_m[2]};
    const orr_vec3 a = orr_mat3_apply_t(&r->attitude.body, body);
    const orr_vec3 d = orr_vec3_scale(r->light.range_m, r->light.u);
    const double range = r->light.range_m;
    const double longer = orr_vec3_norm(orr_vec3_add(d, a));
    const double offset = (2 * orr_vec3_dot(d, a) + orr_vec3_dot(a, a)) / (longer + range);
    const orr_vec3 to = orr_mat3_apply(&r->attitude.body, orr_vec3_scale(-1, r->light.u));
    const double nadir_deg = acos(fmin(fmax(to.z, -1), 1)) * ORR_DEG_PER_RAD;
    const double az_deg = atan2(to.y, to.x) * ORR_DEG_PER_RAD;
    return offset + orr_antex_variation_m(r->antex, f, az_deg, nadir_deg);
}

// All terms of one signal.
static void sum_signal(const moment *m, const ray *r, const orr_signal *s, double carrier_hz, double delay_m,
                       double x[ORR_N_TERMS])
{
    memcpy(x, r->shared_m, sizeof r->shared_m);
    x[ORR_TERM_GROUP_DELAY] = delay_m;
    x[ORR_TERM_SATELLITE_ANTENNA] = satellite_antenna_m(r, s, carrier_hz);
    x[ORR_TERM_RECEIVER_ANTENNA] =
        orr_antenna_range_m(&m->c->antenna[m->antenna], &m->at, r->light.u, s, carrier_hz);
    x[ORR_TERM_IONOSPHERE] = orr_iono_delay_m(r->stec_tecu, carrier_hz, ORR_MEASURES_CODE);
    x[ORR_TERM_WIND_UP] = r->windup_cycles * ORR_LIGHT_MPS / carrier_hz;
    const double approach = -orr_vec3_dot(r->light.u, r->light.sat_v_mps) / ORR_LIGHT_MPS;
    x[ORR_TERM_EMISSION] =
        approach * (x[ORR_TERM_SHAPIRO] + x[ORR_TERM_TROPOSPHERE_HYDROSTATIC] + x[ORR_TERM_TROPOSPHERE_WET] +
                    x[ORR_TERM_SATELLITE_ANTENNA] + x[ORR_TERM_RECEIVER_ANTENNA]);
    x[ORR_TERM_EMISSION_IONOSPHERE] = approach * x[ORR_TERM_IONOSPHERE];
}

// A stretch of rays, before, at and after the instant.
enum { BEFORE, AT, AFTER, SIDES, BATCH = 64 };
typedef struct batch {
    size_t n;
    ray ray[SIDES][BATCH];
    bool has[SIDES][BATCH];
} batch;

// Slant contents; a ray of AT without a value is dropped, one of the sides is then not used.
static void set_contents(const moment *m, batch *b, int side)
{
    orr_sat sat[BATCH] = {0};
    orr_realisation delay[BATCH];
    orr_answer answer[BATCH] = {ORR_ANSWER_OK};
    if (m->c->iono == NULL) return;
    for (size_t k = 0; k < b->n; k++) sat[k] = b->ray[AT][k].sat->sat;
    const bool covered =
        orr_source_iono_evaluate(m->c->iono, m->t, m->at.r_m, sat, b->n, delay, answer) == ORR_ANSWER_OK;
    for (size_t k = 0; k < b->n; k++) {
        if (!covered || answer[k] != ORR_ANSWER_OK)
            b->has[side][k] = false;
        else
            b->ray[side][k].stec_tecu = delay[k].stec_tecu;
    }
}

// The signals' group delay, m; flagged where biases do not tell it.
static double delay_m(const orr_channels *c, orr_sat sat, const orr_signal *s, orr_time t, uint32_t *flags)
{
    double d;
    char code[3] = {s->observation[0], s->observation[1], '\0'};
    if (!c->has_bias) return 0;
    // Files name either the components together (X) or one of them.
    for (const char *attribute = s->observation[1] == 'X' ? "XQLPCISD" : &s->observation[1];
         *attribute != '\0'; attribute++) {
        code[1] = *attribute;
        if (orr_signal_delay_osb(&c->bias, sat, code, t, &d) == ORR_OK) return ORR_LIGHT_MPS * d;
    }
    *flags |= ORR_CHANNEL_NO_DELAY;
    return 0;
}

// Whole cycles and the rest of a phase range: the whole metres by integers (below 2^27 m times 2^32 Hz), so that nothing is lost
// at 1e8 cycles.
static void set_carrier(double phase_m, int64_t whole_start, orr_channel *out)
{
    const double metres = floor(phase_m);
    const int64_t c = (int64_t)ORR_LIGHT_MPS, product = (int64_t)metres * (int64_t)out->carrier_hz;
    const double rest = (double)orr_floor_mod(product, c) / ORR_LIGHT_MPS;
    const double fraction = rest + (phase_m - metres) * out->carrier_hz / ORR_LIGHT_MPS,
                 more = floor(fraction);
    out->carrier_cycles = orr_floor_div(product, c) + (int64_t)more + whole_start;
    out->carrier_fraction = fraction - more;
}

// The integer of a satellite's signal: up to 8191 cycles, the same for all antennas and for ever.
static int64_t whole_start(orr_sat sat, size_t signal)
{
    return (int64_t)(orr_rng_u64(0, sat, signal) & 8191);
}

static void fill(const moment side[SIDES], const batch *b, size_t k, size_t signal, const orr_signal *s,
                 orr_channel *out)
{
    const moment *m = &side[AT];
    const ray *r = &b->ray[AT][k];
    const double hz = orr_signal_carrier_hz(s, r->sat->frequency_channel);
    *out = (orr_channel){.sat = r->sat->sat,
                         .signal = (uint16_t)signal,
                         .flags = r->flags,
                         .az_rad = r->az_rad,
                         .el_rad = r->el_rad,
                         .carrier_hz = hz};
    const double delay = delay_m(m->c, r->sat->sat, s, m->t, &out->flags);
    double early[ORR_N_TERMS], late[ORR_N_TERMS];
    sum_signal(m, r, s, hz, delay, out->term_m);
    const int from = b->has[BEFORE][k] ? BEFORE : AT, to = b->has[AFTER][k] ? AFTER : AT;
    sum_signal(&side[from], &b->ray[from][k], s, hz, delay, early);
    sum_signal(&side[to], &b->ray[to][k], s, hz, delay, late);
    const double seconds = orr_time_diff_s(side[to].t, side[from].t);
    for (int i = 0; i < ORR_N_TERMS; i++) out->rate_mps[i] = seconds > 0 ? (late[i] - early[i]) / seconds : 0;
    const orr_light *l = &r->light;
    out->rate_mps[ORR_TERM_DISTANCE] = l->distance_rate_mps;
    out->rate_mps[ORR_TERM_SAGNAC] = l->range_rate_mps - l->distance_rate_mps;
    if ((out->flags & ORR_CHANNEL_ZERO_CLOCK) == 0)
        out->rate_mps[ORR_TERM_SATELLITE_CLOCK] =
            -ORR_LIGHT_MPS * l->emission.clock_rate_sps * (1 - l->range_rate_mps / ORR_LIGHT_MPS);
    double phase_m = 0, phase_rate = 0;
    for (int i = 0; i < ORR_N_TERMS; i++) {
        out->code_m += orr_term_rows[i].code * out->term_m[i];
        out->code_rate_mps += orr_term_rows[i].code * out->rate_mps[i];
        phase_m += orr_term_rows[i].carrier * out->term_m[i];
        phase_rate += orr_term_rows[i].carrier * out->rate_mps[i];
    }
    set_carrier(phase_m, whole_start(r->sat->sat, signal), out);
    out->carrier_rate_hz = phase_rate * hz / ORR_LIGHT_MPS;
    const double flight_ns = out->code_m / ORR_LIGHT_MPS * 1e9, whole = ceil(flight_ns);
    out->transmit_ns = orr_time_add(m->t, -(int64_t)whole);
    out->transmit_fraction_ns = whole - flight_ns;
    out->power_dbw = orr_power_received_dbw(s, l->sat_m, m->at.r_m, r->el_rad) + r->sat->power_db;
}

// The rays of satellites from *place on: of those that are seen, or where `want` is given those that it marks, seen or not; at
// most BATCH of them.
static void gather(const moment side[SIDES], const bool has[SIDES], const bool *want, size_t *place, batch *b)
{
    const orr_channels *c = side[AT].c;
    b->n = 0;
    for (; *place < c->n_sats && b->n < BATCH; (*place)++) {
        ray *r = &b->ray[AT][b->n];
        if (want != NULL ? !want[*place] : !c->satellite[*place].sends) continue;
        if (!look(&side[AT], *place, r) || (want == NULL && !seen(&side[AT], r)) || !trace(&side[AT], r))
            continue;
        b->has[AT][b->n] = true;
        for (int s = BEFORE; s <= AFTER; s += AFTER - BEFORE) {
            ray *q = &b->ray[s][b->n];
            b->has[s][b->n] = has[s] && look(&side[s], *place, q) && trace(&side[s], q);
        }
        b->n++;
    }
}

orr_answer channels_evaluate(const orr_channels *c, size_t antenna, orr_time t, uint64_t signals,
                             const bool *want, orr_channel *out, size_t *n)
{
    *n = 0;
    if (antenna >= orr_channels_antennas(c)) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(c->span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    moment side[SIDES];
    bool has[SIDES];
    for (int s = 0; s < SIDES; s++)
        has[s] = moment_at(c, antenna, orr_time_add(t, (s - AT) * SIDE_NS), &side[s]);
    if (!has[AT]) return ORR_ANSWER_OUTSIDE_SPAN;
    size_t n_signals;
    const orr_signal *all = orr_signals(&n_signals);
    batch b;
    for (size_t place = 0; place < c->n_sats;) {
        gather(side, has, want, &place, &b);
        for (int s = 0; s < SIDES; s++)
            if (has[s]) set_contents(&side[s], &b, s);
        for (size_t k = 0; k < b.n; k++)
            for (size_t j = 0; j < n_signals && b.has[AT][k]; j++)
                if ((c->signals & signals) >> j & 1 && all[j].system == orr_sat_system(b.ray[AT][k].sat->sat))
                    fill(side, &b, k, j, &all[j], &out[(*n)++]);
    }
    return ORR_ANSWER_OK;
}

orr_answer orr_channels_at(const orr_channels *c, size_t antenna, orr_time t, uint64_t signals,
                           orr_channel *out, size_t *n)
{
    return channels_evaluate(c, antenna, t, signals, NULL, out, n);
}

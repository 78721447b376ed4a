// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation: the terms of every channel of an antenna at an instant, their rates, their sums. Slow terms come from their cells
// (slow.h); what follows the antenna's motion is computed here: the light's way, the antenna's phase centre and turn.
#include "src/scenario/channel/channel.h"

#include <math.h>
#include <string.h>

#include "iono/field/pierce.h"
#include "src/scenario/channel/effects.h"
#include "src/scenario/channel/light.h"
#include "src/scenario/channel/seen.h"
#include "src/scenario/channel/slow.h"

const orr_term_row orr_term_rows[ORR_N_TERMS] = {
#define ORR_TERM(NAME, name, code, carrier, meaning) {name, meaning, code, carrier},
#include "src/scenario/channel/terms.def"
#undef ORR_TERM
};

// One satellite at an instant: what all its signals share.
typedef struct ray {
    const channel_satellite *sat;
    seen_direction direction;
    satellite_state emission;
    orr_light light;
    slow_now slow;
    orr_antenna_direction toward; // of an antenna that moves and has a type
    double turns, turns_rate_hz;
    orr_replay_ray told; // by a recorded day
    uint32_t flags;
    double term_m[ORR_N_TERMS], rate_mps[ORR_N_TERMS];
} ray;

// Satellite clock, with the scenario's policy for holes; false where there is no channel.
static bool set_clock(const orr_channels *c, ray *r)
{
    const satellite_state *x = &r->emission;
    const double on_way =
        1 - r->light.range_rate_mps / ORR_LIGHT_MPS; // seconds of emission by second of reception
    r->flags = r->slow.flags | r->sat->flags | (x->flags & ORR_EPH_ECLIPSE ? ORR_CHANNEL_ECLIPSE : 0u);
    r->term_m[ORR_TERM_SATELLITE_CLOCK] = r->rate_mps[ORR_TERM_SATELLITE_CLOCK] = 0;
    r->term_m[ORR_TERM_RELATIVITY] = r->rate_mps[ORR_TERM_RELATIVITY] = 0;
    if ((x->flags & ORR_EPH_CLOCK_VALID) == 0) {
        r->flags |= ORR_CHANNEL_ZERO_CLOCK;
        return c->options.clock_holes == ORR_CLOCK_HOLE_ZERO;
    }
    r->term_m[ORR_TERM_SATELLITE_CLOCK] = -x->clock_m;
    r->rate_mps[ORR_TERM_SATELLITE_CLOCK] = -x->clock_rate_mps * on_way;
    if (c->options.relativity) {
        r->term_m[ORR_TERM_RELATIVITY] = x->relativity_m;
        r->rate_mps[ORR_TERM_RELATIVITY] = x->relativity_rate_mps * on_way;
    }
    return true;
}

// Noise of the satellite's clock at emission.
static void set_clock_noise(orr_time t, ray *r)
{
    double rate, *x = &r->term_m[ORR_TERM_CLOCK_NOISE], *slope = &r->rate_mps[ORR_TERM_CLOCK_NOISE];
    *x = r->told.clock_m;
    *slope = r->told.clock_mps;
    if (r->sat->clock_noise.n == 0) return;
    const orr_time sent = orr_time_add_s(t, -r->light.tau_s);
    *x -= ORR_LIGHT_MPS * orr_series_at(&r->sat->clock_noise, sent, &rate);
    *slope -= ORR_LIGHT_MPS * rate * (1 - r->light.range_rate_mps / ORR_LIGHT_MPS);
}

// The light and the terms that all signals of a satellite share; false where there is no channel.
static bool trace(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                  const orr_antenna_state *at, uint16_t place, ray *r)
{
    slow_of_satellite(c, antenna, work, t, at, place, &r->slow);
    if (!r->slow.ok || !satellite_at(channels_ephemeris(c), r->sat->sat, work->satellite[place], t,
                                     r->slow.v[SLOW_FLIGHT], &r->emission))
        return false;
    const orr_light *l = &r->light;
    orr_light_close(r->slow.v[SLOW_FLIGHT], r->emission.pos_m, r->emission.vel_mps, at->r_m, at->v_mps,
                    &r->light);
    if (!set_clock(c, r)) return false;
    set_clock_noise(t, r);
    double *x = r->term_m, *rate = r->rate_mps;
    const double *v = r->slow.v, *slope = r->slow.r;
    x[ORR_TERM_DISTANCE] = l->distance_m;
    rate[ORR_TERM_DISTANCE] = l->distance_rate_mps;
    x[ORR_TERM_SAGNAC] = l->range_m - l->distance_m;
    rate[ORR_TERM_SAGNAC] = l->range_rate_mps - l->distance_rate_mps;
    x[ORR_TERM_SHAPIRO] = v[SLOW_SHAPIRO];
    rate[ORR_TERM_SHAPIRO] = slope[SLOW_SHAPIRO];
    x[ORR_TERM_SOLID_TIDE] = v[SLOW_SOLID_TIDE];
    rate[ORR_TERM_SOLID_TIDE] = slope[SLOW_SOLID_TIDE];
    x[ORR_TERM_POLE_TIDE] = v[SLOW_POLE_TIDE];
    rate[ORR_TERM_POLE_TIDE] = slope[SLOW_POLE_TIDE];
    x[ORR_TERM_OCEAN_LOADING] = v[SLOW_OCEAN_LOADING];
    rate[ORR_TERM_OCEAN_LOADING] = slope[SLOW_OCEAN_LOADING];
    x[ORR_TERM_TROPOSPHERE_HYDROSTATIC] = v[SLOW_HYDROSTATIC];
    rate[ORR_TERM_TROPOSPHERE_HYDROSTATIC] = slope[SLOW_HYDROSTATIC];
    x[ORR_TERM_TROPOSPHERE_WET] = v[SLOW_WET];
    rate[ORR_TERM_TROPOSPHERE_WET] = slope[SLOW_WET];
    if (c->turbulence != NULL)
        effects_turbulence(c, t, at, l, &x[ORR_TERM_TURBULENCE], &rate[ORR_TERM_TURBULENCE]);
    r->turns = v[SLOW_TURNS];
    r->turns_rate_hz = slope[SLOW_TURNS];
    const orr_antenna *a = &c->antenna[antenna];
    if (a->motion == NULL) return true;
    if (a->antex != NULL) r->toward = orr_antenna_toward(at, l->u, l->u_rate_ps);
    if (c->options.windup) {
        double turning_hz;
        r->turns += orr_windup_turned(&c->windup[antenna], t, at, l->u, l->u_rate_ps, &turning_hz);
        r->turns_rate_hz += turning_hz;
    }
    return true;
}

// Terms of one signal, the j-th of its satellite.
static void set_signal(const orr_antenna *a, const ray *r, size_t j, double delay_m, orr_channel *out)
{
    const channel_sent *sent = &r->sat->sent[j];
    double *x = out->term_m, *rate = out->rate_mps;
    const double *v = r->slow.v, *slope = r->slow.r;
    memcpy(x, r->term_m, sizeof r->term_m); // terms of effects that are not there are zero
    memcpy(rate, r->rate_mps, sizeof r->rate_mps);
    x[ORR_TERM_DISTURBANCE] = orr_iono_delay_m(v[SLOW_DISTURBANCE], sent->carrier_hz, ORR_MEASURES_CODE);
    rate[ORR_TERM_DISTURBANCE] =
        orr_iono_delay_m(slope[SLOW_DISTURBANCE], sent->carrier_hz, ORR_MEASURES_CODE);
    x[ORR_TERM_GROUP_DELAY] = delay_m;
    rate[ORR_TERM_GROUP_DELAY] = 0;
    x[ORR_TERM_PHASE_BIAS] = sent->phase_bias_m;
    rate[ORR_TERM_PHASE_BIAS] = 0;
    x[ORR_TERM_SATELLITE_ANTENNA] = v[slow_of(j, SLOW_SATELLITE_ANTENNA)];
    rate[ORR_TERM_SATELLITE_ANTENNA] = slope[slow_of(j, SLOW_SATELLITE_ANTENNA)];
    if (a->motion == NULL) {
        x[ORR_TERM_RECEIVER_ANTENNA] = v[slow_of(j, SLOW_RECEIVER_ANTENNA)];
        rate[ORR_TERM_RECEIVER_ANTENNA] = slope[slow_of(j, SLOW_RECEIVER_ANTENNA)];
    } else {
        x[ORR_TERM_RECEIVER_ANTENNA] =
            orr_antenna_range_m(a, &r->toward, sent->signal, &rate[ORR_TERM_RECEIVER_ANTENNA]);
    }
    x[ORR_TERM_IONOSPHERE] =
        orr_iono_delay_m(v[SLOW_CONTENT] + r->told.tecu, sent->carrier_hz, ORR_MEASURES_CODE);
    rate[ORR_TERM_IONOSPHERE] =
        orr_iono_delay_m(slope[SLOW_CONTENT] + r->told.tecu_ps, sent->carrier_hz, ORR_MEASURES_CODE);
    const double second_m =
        ORR_IONO_SECOND_M4_PER_S3_T / (sent->carrier_hz * sent->carrier_hz * sent->carrier_hz);
    x[ORR_TERM_IONOSPHERE_SECOND] = second_m * v[SLOW_CONTENT_FIELD];
    rate[ORR_TERM_IONOSPHERE_SECOND] = second_m * slope[SLOW_CONTENT_FIELD];
    const double cycle_m = ORR_LIGHT_MPS / sent->carrier_hz;
    x[ORR_TERM_WIND_UP] = r->turns * cycle_m;
    rate[ORR_TERM_WIND_UP] = r->turns_rate_hz * cycle_m;
    double delayed_m = 0, delayed_mps = 0; // what the satellite moves on meanwhile
    static const int DELAYS[] = {ORR_TERM_SHAPIRO, ORR_TERM_TROPOSPHERE_HYDROSTATIC, ORR_TERM_TROPOSPHERE_WET,
                                 ORR_TERM_SATELLITE_ANTENNA, ORR_TERM_RECEIVER_ANTENNA};
    for (size_t k = 0; k < sizeof DELAYS / sizeof *DELAYS; k++) {
        delayed_m += x[DELAYS[k]];
        delayed_mps += rate[DELAYS[k]];
    }
    const double approach = v[SLOW_APPROACH], approach_rate = slope[SLOW_APPROACH];
    x[ORR_TERM_EMISSION] = approach * delayed_m;
    rate[ORR_TERM_EMISSION] = approach * delayed_mps + approach_rate * delayed_m;
    x[ORR_TERM_EMISSION_IONOSPHERE] = approach * x[ORR_TERM_IONOSPHERE];
    rate[ORR_TERM_EMISSION_IONOSPHERE] =
        approach * rate[ORR_TERM_IONOSPHERE] + approach_rate * x[ORR_TERM_IONOSPHERE];
}

// The signals' group delays in the lattice's cell of t.
static void set_delays(const orr_channels *c, const channel_satellite *sat, orr_time t, channel_delays *out)
{
    const orr_signal *all = orr_signals(&(size_t){0});
    const orr_time cell = lattice_cell(t);
    if (out->cell == cell) return;
    out->cell = cell;
    for (size_t j = 0; c->bias != NULL && j < sat->n_sent; j++) {
        double delay_s;
        out->unknown[j] =
            orr_signal_delay_of(c->bias, sat->sat, &all[sat->sent[j].signal], cell, &delay_s) != ORR_OK;
        out->delay_m[j] = out->unknown[j] ? 0 : ORR_LIGHT_MPS * delay_s;
    }
}

// Whole cycles and the rest of a phase range: the whole metres by integers (below 2^27 m times 2^32 Hz), so that nothing is lost
// at 1e8 cycles.
static void set_carrier(double phase_m, int64_t start, orr_channel *out)
{
    const double metres = floor(phase_m);
    const int64_t c = (int64_t)ORR_LIGHT_MPS, product = (int64_t)metres * (int64_t)out->carrier_hz;
    const int64_t whole = orr_floor_div(product, c);
    const double fraction =
                     ((double)(product - whole * c) + (phase_m - metres) * out->carrier_hz) / ORR_LIGHT_MPS,
                 more = floor(fraction);
    out->carrier_cycles = whole + (int64_t)more + start;
    out->carrier_fraction = fraction - more;
}

// A value and its rate in the code and in the carrier.
typedef double sums __attribute__((vector_size(4 * sizeof(double))));

void channels_sum(orr_time t, int64_t start, orr_channel *out)
{
#define ORR_TERM(NAME, name, code, carrier, meaning) {code, code, carrier, carrier},
    static const sums FACTOR[ORR_N_TERMS] = {
#include "src/scenario/channel/terms.def"
    };
#undef ORR_TERM
    const double *x = out->term_m, *rate = out->rate_mps;
    sums even = {0, 0, 0, 0}, odd = {0, 0, 0, 0}; // one chain of additions would wait for itself
    int i = 0;
    for (; i + 1 < ORR_N_TERMS; i += 2) {
        even += FACTOR[i] * (sums){x[i], rate[i], x[i], rate[i]};
        odd += FACTOR[i + 1] * (sums){x[i + 1], rate[i + 1], x[i + 1], rate[i + 1]};
    }
    if (i < ORR_N_TERMS) even += FACTOR[i] * (sums){x[i], rate[i], x[i], rate[i]};
    const sums all = even + odd;
    const double code = all[0];
    out->code_m = code;
    out->code_rate_mps = all[1];
    set_carrier(all[2], start, out);
    out->carrier_rate_hz = all[3] * out->carrier_hz / ORR_LIGHT_MPS;
    const double flight_ns = code / ORR_LIGHT_MPS * 1e9, whole = ceil(flight_ns);
    out->transmit_ns = orr_time_add(t, -(int64_t)whole);
    out->transmit_fraction_ns = whole - flight_ns;
}

// Echoes of the last channel of the list, behind it.
static void add_echoes(const orr_channels *c, const orr_antenna_state *at, orr_time t, const ray *r,
                       int64_t start, channel_list *list)
{
    orr_echo echo[ORR_MAX_ECHOES];
    const size_t direct = list->n - 1;
    const orr_channel *x = &list->channel[direct];
    const orr_echo_ray from = {.t = t,
                               .as_of = list->as_of,
                               .sat = x->sat,
                               .carrier_hz = x->carrier_hz,
                               .at = at,
                               .u = r->light.u,
                               .u_rate_ps = r->light.u_rate_ps};
    const size_t n = orr_echoes_at(c->echoes, &from, echo);
    for (size_t k = 0; k < n; k++) {
        list->place[list->n] = list->place[direct];
        list->seen[list->n] = list->seen[direct];
        list->start[list->n] = start;
        orr_channel *out = &list->channel[list->n++];
        *out = *x;
        effects_echo(&echo[k], out);
        channels_sum(t, start, out);
    }
}

static void fill(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                 const orr_antenna_state *at, const ray *r, uint64_t signals, channel_list *list)
{
    channel_delays *delays = &work->delays[r->sat - c->satellite];
    set_delays(c, r->sat, t, delays);
    for (size_t j = 0; j < r->sat->n_sent; j++) {
        const channel_sent *sent = &r->sat->sent[j];
        if ((signals >> sent->signal & 1) == 0) continue;
        list->place[list->n] = (uint16_t)(r->sat - c->satellite);
        list->seen[list->n] = r->direction.seen;
        int64_t *start = &list->start[list->n];
        orr_channel *out = &list->channel[list->n];
        out->sat = r->sat->sat;
        out->signal = sent->signal;
        out->echo = 0;
        out->flags = r->flags | (delays->unknown[j] ? ORR_CHANNEL_NO_DELAY : 0u);
        out->az_rad = r->direction.az_rad;
        out->el_rad = r->direction.el_rad;
        out->carrier_hz = sent->carrier_hz;
        out->power_dbw = r->slow.v[slow_of(j, SLOW_POWER)];
        set_signal(&c->antenna[antenna], r, j, delays->delay_m[j], out);
        if (!effects_replay(c, sent, t, list->as_of, start, out)) continue; // it was not observed
        list->n++;
        if (c->scintillation != NULL)
            effects_scintillation(c, antenna, t, r->slow.v[SLOW_S4], r->slow.v[SLOW_SIGMA_PHI],
                                  &work->antenna[antenna].fading[list->place[list->n - 1]], out);
        if (c->land_mobile != NULL) effects_land_mobile(c, list->place[list->n - 1], t, list->as_of, out);
        if (c->faults != NULL) effects_fault(c, list->place[list->n - 1], &r->light, t, list->as_of, out);
        channels_sum(t, *start, out);
        if (c->echoes != NULL) add_echoes(c, at, t, r, *start, list);
    }
}

void channels_evaluate(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                       orr_time as_of, const orr_antenna_state *at, uint64_t signals, const bool *also,
                       channel_list *list)
{
    channel_antenna_work *w = &work->antenna[antenna];
    const bool dark = orr_obstacles_tunnel(c->obstacles, at, as_of); // a block's end is seen from its begin
    size_t n = 0;
    list->t = t;
    list->as_of = as_of;
    list->signals = signals;
    list->n = 0;
    seen_candidates(c, antenna, work, t, at);
    for (size_t k = 0; k < w->n_candidates; k++) {
        const uint16_t place = w->candidate[k];
        satellite_state x;
        if (orr_faults_off(c->faults, place, as_of)) continue;
        if (!satellite_at(channels_ephemeris(c), c->satellite[place].sat, work->satellite[place], t, 0, &x))
            continue;
        work->direction[n] = seen_at(c, antenna, at, x.pos_m);
        if (dark) work->direction[n].seen = false;
        if (work->direction[n].seen || (also != NULL && also[place])) work->chosen[n++] = place;
    }
    slow_prepare(c, antenna, work, t, at, work->chosen, n);
    for (size_t k = 0; k < n; k++) {
        ray r; // zeroes where trace leaves some: the slow terms' arrays are large
        r.sat = &c->satellite[work->chosen[k]];
        r.direction = work->direction[k];
        r.toward = (orr_antenna_direction){.az_deg = 0};
        memset(r.term_m, 0, sizeof r.term_m);
        memset(r.rate_mps, 0, sizeof r.rate_mps);
        r.told = (orr_replay_ray){.tecu = 0};
        if (r.sat->record != NULL) orr_replay_ray_at(c->replay, r.sat->record, t, as_of, &r.told);
        if (trace(c, antenna, work, t, at, work->chosen[k], &r))
            fill(c, antenna, work, t, at, &r, signals, list);
    }
}

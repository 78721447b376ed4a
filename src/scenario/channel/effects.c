// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/effects.h"

#include <math.h>

#include "core/constants.h"
#include "orbit/force/kepler.h"
#include "src/scenario/channel/spoofed.h"

// What the range grows by when the satellite is displaced along radius, track and normal of its orbit; the displacement turns with
// the orbit, the Earth's axes below it.
static double displaced_m(const orr_light *l, orr_vec3 by_m, double *rate_mps)
{
    const orr_mat3 axes = orr_orbit_axes(l->sat_m, l->sat_v_mps);
    const orr_vec3 a = orr_mat3_apply(&axes, by_m), normal = orr_vec3_cross(l->sat_m, l->sat_v_mps);
    const orr_vec3 turn = orr_vec3_sub(orr_vec3_scale(1 / orr_vec3_dot(l->sat_m, l->sat_m), normal),
                                       (orr_vec3){0, 0, ORR_EARTH_RATE_RADPS});
    const orr_vec3 d = orr_vec3_scale(l->range_m, l->u), to = orr_vec3_add(d, a);
    const orr_vec3 d_rate = orr_vec3_axpy(l->range_rate_mps, l->u, orr_vec3_scale(l->range_m, l->u_rate_ps));
    const double longer = orr_vec3_norm(to);
    *rate_mps = orr_vec3_dot(to, orr_vec3_add(d_rate, orr_vec3_cross(turn, a))) / longer - l->range_rate_mps;
    return (2 * orr_vec3_dot(d, a) + orr_vec3_dot(a, a)) / (longer + l->range_m);
}

void effects_fault(const orr_channels *c, size_t place, const orr_light *l, orr_time t, orr_time as_of,
                   orr_channel *out)
{
    orr_fault_now x;
    double *v = out->term_m, *rate = out->rate_mps;
    orr_faults_at(c->faults, place, out->signal, t, as_of, &x);
    v[ORR_TERM_FAULT_RANGE] = x.range_m;
    rate[ORR_TERM_FAULT_RANGE] = x.range_mps;
    v[ORR_TERM_FAULT_NOISE] = x.noise_m;
    rate[ORR_TERM_FAULT_NOISE] = x.noise_mps;
    v[ORR_TERM_FAULT_CLOCK] = x.clock_m;
    rate[ORR_TERM_FAULT_CLOCK] = x.clock_mps;
    v[ORR_TERM_FAULT_DIVERGENCE] = x.divergence_m;
    rate[ORR_TERM_FAULT_DIVERGENCE] = x.divergence_mps;
    v[ORR_TERM_FAULT_ORBIT] = rate[ORR_TERM_FAULT_ORBIT] = 0;
    if (!x.any) return;
    if (orr_vec3_dot(x.orbit_m, x.orbit_m) > 0)
        v[ORR_TERM_FAULT_ORBIT] = displaced_m(l, x.orbit_m, &rate[ORR_TERM_FAULT_ORBIT]);
    out->power_dbw += x.power_db;
    out->flags |= ORR_CHANNEL_FAULT | (x.unhealthy ? ORR_CHANNEL_UNHEALTHY : 0u);
}

void effects_echo(const orr_echo *echo, orr_channel *out)
{
    const double cycle_m = ORR_LIGHT_MPS / out->carrier_hz;
    out->echo = echo->number;
    out->term_m[ORR_TERM_ECHO] = echo->delay_m;
    out->rate_mps[ORR_TERM_ECHO] = echo->delay_mps;
    out->term_m[ORR_TERM_ECHO_PHASE] = echo->phase_cycles * cycle_m;
    out->rate_mps[ORR_TERM_ECHO_PHASE] = echo->phase_rate_hz * cycle_m;
    out->power_dbw += echo->power_db;
}

void effects_scintillation(const orr_channels *c, size_t antenna, orr_time t, double s4, double sigma_rad,
                           orr_scintillation_cell *fading, orr_channel *out)
{
    orr_scintillation_effect x;
    orr_scintillation_of(c->scintillation, out->sat, antenna, t, (orr_scintillation_now){s4, sigma_rad},
                         out->carrier_hz, fading, &x);
    const double cycle_m = ORR_LIGHT_MPS / out->carrier_hz;
    out->term_m[ORR_TERM_SCINTILLATION] = -x.phase_cycles * cycle_m;
    out->rate_mps[ORR_TERM_SCINTILLATION] = -x.phase_rate_hz * cycle_m;
    out->power_dbw += x.power_db;
}

bool effects_replay(const orr_channels *c, const channel_sent *sent, orr_time t, orr_time as_of,
                    int64_t *start, orr_channel *out)
{
    orr_replay_now x;
    *start = sent->start;
    if (sent->track == NULL) return true;
    if (!orr_replay_at(c->replay, sent->track, t, as_of, &x)) return false;
    *start += x.start;
    out->term_m[ORR_TERM_RECEIVER_DELAY] = sent->track->delay_m;
    out->term_m[ORR_TERM_PHASE_BIAS] += x.bias_m;
    out->term_m[ORR_TERM_RESIDUAL_CODE] = x.code_m;
    out->rate_mps[ORR_TERM_RESIDUAL_CODE] = x.code_mps;
    out->term_m[ORR_TERM_RESIDUAL_CARRIER] = x.carrier_m;
    out->rate_mps[ORR_TERM_RESIDUAL_CARRIER] = x.carrier_mps;
    if (!isnan(x.cn0_dbhz)) out->power_dbw = x.cn0_dbhz + ORR_N0_DBWHZ;
    return true;
}

void effects_land_mobile(const orr_channels *c, size_t place, orr_time t, orr_time as_of, orr_channel *out)
{
    const orr_land_mobile_now x = orr_land_mobile_at(c->land_mobile, place, t, as_of, out->carrier_hz);
    const double cycle_m = ORR_LIGHT_MPS / out->carrier_hz;
    out->term_m[ORR_TERM_LAND_MOBILE] = -x.phase_cycles * cycle_m;
    out->rate_mps[ORR_TERM_LAND_MOBILE] = -x.phase_rate_hz * cycle_m;
    out->power_dbw += x.power_db;
}

void effects_turbulence(const orr_channels *c, orr_time t, const orr_antenna_state *at, const orr_light *l,
                        double *delay_m, double *delay_mps)
{
    const orr_turbulence_ray ray = {.r_m = at->r_m,
                                    .v_mps = at->v_mps,
                                    .u = orr_mat3_apply(&at->enu, l->u),
                                    .u_rate_ps = orr_mat3_apply(&at->enu, l->u_rate_ps)};
    *delay_m = orr_turbulence_slant_m(c->turbulence, &ray, t, delay_mps);
}

bool effects_change(const orr_channels *c, orr_time after, orr_time until)
{
    return spoofed_change(c, after, until) ||
           (c->replay != NULL && orr_replay_change(c->replay, after, until)) ||
           orr_land_mobile_change(c->land_mobile, after, until) ||
           orr_obstacles_change(c->obstacles, after, until) || orr_faults_change(c->faults, after, until) ||
           orr_echoes_change(c->echoes, after, until);
}

bool effects_allow(const orr_channels *c, size_t antenna, orr_time cell, int64_t length_ns)
{
    const orr_time end = cell + ORR_BLOCK_CELL_NS;
    const double error_m = c->options.error_m / 10;
    return spoofed_allow(c, cell, end, length_ns) &&
           (c->replay == NULL || orr_replay_allow(c->replay, length_ns, c->options.error_m)) &&
           length_ns <= orr_land_mobile_block_ns(c->land_mobile) &&
           orr_obstacles_allow(c->obstacles, cell, end, length_ns) &&
           orr_faults_allow(c->faults, cell, end, length_ns, error_m) &&
           length_ns <= orr_turbulence_block_ns(c->turbulence, error_m) &&
           length_ns <= orr_scintillation_block_ns(c->scintillation, cell, end) &&
           orr_echoes_allow(c->echoes, &c->antenna[antenna], cell, end, length_ns, error_m);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/spacecraft/spacecraft.h"

#include "orbit/force/orbit_class.h"
#include "orbit/spacecraft/attitude_laws.h"

// The record that stands for t, usable or not.
static const orr_nav_eph *select_any(const orr_nav *nav, orr_sat sat, orr_time t, uint32_t messages)
{
    orr_broadcast_choice any = orr_broadcast_choice_default();
    any.healthy = false;
    any.messages = messages;
    return orr_broadcast_select(nav, sat, t, &any);
}

static orr_health health_at(const orr_nav *nav, orr_sat sat, orr_time t, uint32_t messages)
{
    if (nav == NULL) return ORR_HEALTH_UNKNOWN;
    const orr_nav_eph *eph = select_any(nav, sat, t, messages);
    if (eph == NULL) return ORR_HEALTH_UNKNOWN;
    return orr_nav_eph_usable(eph) ? ORR_HEALTH_OK : ORR_HEALTH_BAD;
}

static void place_antenna(const orr_antex *antex, orr_sat sat, orr_time t, orr_spacecraft *x)
{
    const double nan = (double)NAN;
    x->antenna_ecef_m = (orr_vec3){nan, nan, nan};
    for (int i = 0; i < 3; i++) x->antenna_body_m[i] = nan;
    if (antex == NULL || orr_antenna_offset_of_sat(antex, sat, t, x->antenna_body_m) != ORR_OK) return;
    const double *b = x->antenna_body_m;
    if (x->has_attitude)
        x->antenna_ecef_m = orr_mat3_apply_t(&x->attitude.body, (orr_vec3){b[0], b[1], b[2]});
}

orr_status orr_spacecraft_at(const orr_spacecraft_sources *src, orr_sat sat, orr_time t, orr_vec3 sun,
                             orr_spacecraft *out)
{
    orr_spacecraft x = {0};
    const orr_status s = orr_ephemeris_eval(src->orbit, sat, t, &x.state);
    if (s != ORR_OK) return s;
    const orr_vec3 r = x.state.pos_m, v = orr_velocity_inertial(r, x.state.vel_mps);
    const char system = orr_sat_system(sat);
    x.orbit_normal = (system == 'C' || system == 'J') && orr_orbit_class_of(r, v) == ORR_ORBIT_GEO;
    if (x.orbit_normal) orr_attitude_orbit_normal(r, v, sun, &x.attitude);
    const orr_attitude_law law =
        orr_attitude_law_of(src->antex != NULL ? orr_antex_find_sat(src->antex, sat, t) : NULL);
    x.has_attitude = x.orbit_normal || orr_attitude_by_law(law, t, r, v, sun, &x.attitude) == ORR_OK;
    place_antenna(src->antex, sat, t, &x);
    x.relativity_s = orr_periodic_relativity_s(r, v);
    x.health = health_at(src->nav, sat, t, src->messages);
    *out = x;
    return ORR_OK;
}

orr_status orr_spacecraft_delay(const orr_spacecraft_sources *src, orr_sat sat, const char *signal,
                                orr_time t, double *delay_s)
{
    if (src->bias != NULL) return orr_signal_delay_osb(src->bias, sat, signal, t, delay_s);
    if (src->nav == NULL) return ORR_E_NODATA;
    const orr_nav_eph *eph = select_any(src->nav, sat, t, src->messages);
    if (eph != NULL && orr_signal_delay_broadcast(eph, signal, delay_s) == ORR_OK) return ORR_OK;
    // Another message of the satellite may: LNAV knows nothing of L2C and L5, CNAV does.
    const uint32_t others = orr_nav_messages_of(orr_sat_system(sat));
    for (uint32_t bit = 2; src->messages == 0 && bit <= others; bit <<= 1) {
        if ((others & bit) == 0) continue;
        eph = select_any(src->nav, sat, t, bit);
        if (eph != NULL && orr_signal_delay_broadcast(eph, signal, delay_s) == ORR_OK) return ORR_OK;
    }
    return ORR_E_NODATA;
}

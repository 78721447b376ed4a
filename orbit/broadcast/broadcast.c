// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/broadcast/broadcast.h"

#include <stdlib.h>

#include "orbit/broadcast/jet.h"
#include "orbit/force/kepler.h"

#define DAY_S 86400.0

void orr_broadcast_constants(char system, double *gm, double *earth_rate)
{
    *gm = system == 'E' ? ORR_GALILEO_GM : system == 'C' ? ORR_BEIDOU_GM : ORR_GPS_GM;
    *earth_rate = system == 'E'   ? ORR_GALILEO_EARTH_RATE_RADPS
                  : system == 'C' ? ORR_BEIDOU_EARTH_RATE_RADPS
                                  : ORR_GPS_EARTH_RATE_RADPS;
}

// BeiDou's geostationary satellites (D2) have their elements in a plane tilted by -5 deg, so that i is not
// near zero.
static bool is_beidou_geo(const orr_nav_eph *e)
{
    return orr_sat_system(e->sat) == 'C' && e->message == ORR_NAV_D2;
}

// E(t) of M(t): E' = M'/(1 - e cos E), E'' = (M'' - e sin E E'^2)/(1 - e cos E).
static orr_jet eccentric_anomaly(orr_jet m, double e)
{
    double E = orr_kepler_solve(m.v, e), den = 1 - e * cos(E), d = m.d / den;
    return orr_jet_make(E, d, (m.dd - e * sin(E) * d * d) / den);
}

// True anomaly: nu' = sqrt(1 - e^2)/(1 - e cos E) E'.
static orr_jet true_anomaly(orr_jet E, double e)
{
    double root = sqrt(1 - e * e), den = 1 - e * cos(E.v);
    double nu = atan2(root * sin(E.v), cos(E.v) - e);
    return orr_jet_chain(E, nu, root / den, -root * e * sin(E.v) / (den * den));
}

// c cos 2u + s sin 2u
static orr_jet harmonic(double c, double s, orr_jet twice)
{
    return orr_jet_add(orr_jet_scale(c, orr_jet_cos(twice)), orr_jet_scale(s, orr_jet_sin(twice)));
}

static void turn3(orr_jet angle, orr_jet *x, orr_jet *y) // passive rotation about axis 3, as core's rot3
{
    orr_jet c = orr_jet_cos(angle), s = orr_jet_sin(angle);
    orr_jet a = orr_jet_add(orr_jet_mul(c, *x), orr_jet_mul(s, *y));
    *y = orr_jet_sub(orr_jet_mul(c, *y), orr_jet_mul(s, *x));
    *x = a;
}

static orr_status eval_kepler(const orr_nav_eph *eph, double tk, orr_broadcast_state *out)
{
    const orr_nav_kepler *k = &eph->kepler;
    double gm, earth_rate;
    orr_broadcast_constants(orr_sat_system(eph->sat), &gm, &earth_rate);
    const double a0 = k->sqrt_a_sqrtm * k->sqrt_a_sqrtm;
    if (!(a0 > 6.4e6 && a0 < 1e9) || !(k->e >= 0 && k->e < 0.9)) return ORR_E_NUMERIC;
    const orr_jet a = orr_jet_make(a0 + k->a_dot_mps * tk, k->a_dot_mps, 0);
    const double n0 = sqrt(gm / (a0 * a0 * a0));
    const double n = n0 + k->delta_n_radps + 0.5 * k->delta_n_dot_radps2 * tk;
    const double n_slope = 0.5 * k->delta_n_dot_radps2;
    const orr_jet m = orr_jet_make(k->m0_rad + n * tk, n + n_slope * tk, 2 * n_slope);

    const orr_jet E = eccentric_anomaly(m, k->e);
    const orr_jet phi = orr_jet_add(true_anomaly(E, k->e), orr_jet_make(k->omega_rad, 0, 0));
    const orr_jet twice = orr_jet_scale(2, phi);
    const orr_jet u = orr_jet_add(phi, harmonic(k->cuc_rad, k->cus_rad, twice));
    const orr_jet shape = orr_jet_sub(orr_jet_make(1, 0, 0), orr_jet_scale(k->e, orr_jet_cos(E)));
    const orr_jet r = orr_jet_add(orr_jet_mul(a, shape), harmonic(k->crc_m, k->crs_m, twice));
    const orr_jet i = orr_jet_add(orr_jet_make(k->i0_rad + k->idot_radps * tk, k->idot_radps, 0),
                                  harmonic(k->cic_rad, k->cis_rad, twice));
    const orr_jet xp = orr_jet_mul(r, orr_jet_cos(u)), yp = orr_jet_mul(r, orr_jet_sin(u));
    const bool geo = is_beidou_geo(eph);
    const double node_rate = k->omega_dot_radps - (geo ? 0 : earth_rate);
    const orr_jet node =
        orr_jet_make(k->omega0_rad + node_rate * tk - earth_rate * k->toe_sow_s, node_rate, 0);

    const orr_jet ypc = orr_jet_mul(yp, orr_jet_cos(i));
    orr_jet x = orr_jet_sub(orr_jet_mul(xp, orr_jet_cos(node)), orr_jet_mul(ypc, orr_jet_sin(node)));
    orr_jet y = orr_jet_add(orr_jet_mul(xp, orr_jet_sin(node)), orr_jet_mul(ypc, orr_jet_cos(node)));
    orr_jet z = orr_jet_mul(yp, orr_jet_sin(i));
    if (geo) { // R3(u tk) R1(-5 deg)
        const double cs = cos(-5 * ORR_RAD_PER_DEG), sn = sin(-5 * ORR_RAD_PER_DEG);
        const orr_jet y1 = orr_jet_add(orr_jet_scale(cs, y), orr_jet_scale(sn, z));
        z = orr_jet_sub(orr_jet_scale(cs, z), orr_jet_scale(sn, y));
        y = y1;
        turn3(orr_jet_make(earth_rate * tk, earth_rate, 0), &x, &y);
    }
    out->pos_m = orr_vec3_make(x.v, y.v, z.v);
    out->vel_mps = orr_vec3_make(x.d, y.d, z.d);
    out->acc_mps2 = orr_vec3_make(x.dd, y.dd, z.dd);
    // F e sqrt(A) sin E, F = -2 sqrt(mu)/c^2
    out->relativity_s = -2 * sqrt(gm) / (ORR_LIGHT_MPS * ORR_LIGHT_MPS) * k->e * k->sqrt_a_sqrtm * sin(E.v);
    return ORR_OK;
}

// GLONASS ICD 5.1, A.3.1.2: motion in turning PZ-90 with J2 and the broadcast lunisolar acceleration held
// constant.
static void glonass_motion(const double y[6], const orr_vec3 *lunisolar, double dy[6])
{
    const double gm = ORR_GLONASS_GM, ae = ORR_GLONASS_RADIUS_M, j2 = ORR_GLONASS_J2,
                 w = ORR_GLONASS_EARTH_RATE_RADPS;
    double r2 = y[0] * y[0] + y[1] * y[1] + y[2] * y[2], r = sqrt(r2), k = gm / (r2 * r);
    double j = 1.5 * j2 * k * ae * ae / r2, q = 5 * y[2] * y[2] / r2;
    dy[0] = y[3], dy[1] = y[4], dy[2] = y[5];
    dy[3] = -k * y[0] - j * y[0] * (1 - q) + w * w * y[0] + 2 * w * y[4] + lunisolar->x;
    dy[4] = -k * y[1] - j * y[1] * (1 - q) + w * w * y[1] - 2 * w * y[3] + lunisolar->y;
    dy[5] = -k * y[2] - j * y[2] * (3 - q) + lunisolar->z;
}

// Runge-Kutta 4 over tk in equal steps of a minute or less (the ICD's own step).
static orr_status advance(double y[6], const orr_vec3 *lunisolar, double tk)
{
    int steps = (int)ceil(fabs(tk) / 60.0);
    double h = steps > 0 ? tk / steps : 0;
    for (int n = 0; n < steps; n++) {
        double k[4][6], t[6];
        glonass_motion(y, lunisolar, k[0]);
        for (int i = 0; i < 6; i++) t[i] = y[i] + 0.5 * h * k[0][i];
        glonass_motion(t, lunisolar, k[1]);
        for (int i = 0; i < 6; i++) t[i] = y[i] + 0.5 * h * k[1][i];
        glonass_motion(t, lunisolar, k[2]);
        for (int i = 0; i < 6; i++) t[i] = y[i] + h * k[2][i];
        glonass_motion(t, lunisolar, k[3]);
        for (int i = 0; i < 6; i++) y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
        if (!(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] > 4e13)) return ORR_E_NUMERIC;
    }
    return ORR_OK;
}

static orr_status glonass_start(const orr_nav_glonass *g, double y[6])
{
    y[0] = g->pos_m.x, y[1] = g->pos_m.y, y[2] = g->pos_m.z;
    y[3] = g->vel_mps.x, y[4] = g->vel_mps.y, y[5] = g->vel_mps.z;
    const double radius = orr_vec3_norm(g->pos_m);
    return radius > 6.4e6 && radius < 1e9 ? ORR_OK : ORR_E_NUMERIC;
}

static orr_status eval_glonass(const orr_nav_glonass *g, double tk, orr_broadcast_state *out)
{
    double y[6], dy[6];
    orr_status s = glonass_start(g, y);
    if (s == ORR_OK) s = advance(y, &g->acc_mps2, tk);
    if (s != ORR_OK) return s;
    glonass_motion(y, &g->acc_mps2, dy);
    out->pos_m = orr_vec3_make(y[0], y[1], y[2]);
    out->vel_mps = orr_vec3_make(y[3], y[4], y[5]);
    out->acc_mps2 = orr_vec3_make(dy[3], dy[4], dy[5]);
    out->relativity_s = 0;
    return ORR_OK;
}

orr_status orr_broadcast_glonass_track(const orr_nav_glonass *g, const double *tk, size_t n, orr_vec3 *pos)
{
    double y[6], at;
    size_t later = 0;
    while (later < n && tk[later] < 0) later++;
    for (int side = 0; side < 2; side++) { // forward from tb, then backward
        orr_status s = glonass_start(g, y);
        at = 0;
        for (size_t k = 0; k < (side == 0 ? n - later : later) && s == ORR_OK; k++) {
            size_t i = side == 0 ? later + k : later - 1 - k;
            s = advance(y, &g->acc_mps2, tk[i] - at);
            at = tk[i];
            pos[i] = orr_vec3_make(y[0], y[1], y[2]);
        }
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}

static void eval_geo(const orr_nav_geo *g, double tk, orr_broadcast_state *out)
{
    out->pos_m = orr_vec3_axpy(0.5 * tk * tk, g->acc_mps2, orr_vec3_axpy(tk, g->vel_mps, g->pos_m));
    out->vel_mps = orr_vec3_axpy(tk, g->acc_mps2, g->vel_mps);
    out->acc_mps2 = g->acc_mps2;
    out->relativity_s = 0;
}

orr_status orr_broadcast_eval(const orr_nav_eph *eph, orr_time t, orr_broadcast_state *out)
{
    double tk = orr_time_diff_s(t, eph->toe), tc = orr_time_diff_s(t, eph->toc);
    if (!(fabs(tk) <= DAY_S)) return ORR_E_RANGE;
    orr_broadcast_state s = {.clock_s = eph->af0_s + tc * (eph->af1_sps + tc * eph->af2_sps2),
                             .clock_rate_sps = eph->af1_sps + 2 * tc * eph->af2_sps2};
    orr_status status = ORR_OK;
    switch (eph->kind) {
    case ORR_NAV_KEPLER:
        status = eval_kepler(eph, tk, &s);
        break;
    case ORR_NAV_GLONASS:
        status = eval_glonass(&eph->glonass, tk, &s);
        break;
    case ORR_NAV_GEO:
        eval_geo(&eph->geo, tk, &s);
        break;
    default:
        return ORR_E_ARG;
    }
    if (status != ORR_OK) return status;
    if (!isfinite(s.pos_m.x + s.pos_m.y + s.pos_m.z + s.vel_mps.x + s.vel_mps.y + s.vel_mps.z))
        return ORR_E_NUMERIC;
    *out = s;
    return ORR_OK;
}

orr_broadcast_choice orr_broadcast_choice_default(void)
{
    return (orr_broadcast_choice){.healthy = true, .iode = ORR_NAV_NO_IOD};
}

// Galileo's elements are fitted to what follows toe: on 2020-06-24 they held to 0.9 m RMS from half an hour
// before toe to three hours after, and erred by 2 m an hour before, 5 m at an hour and a half, 11 m at two.
// GPS and BeiDou are as good before toe as after.
static double usual_age_s(const orr_nav_eph *e, bool ahead)
{
    switch (orr_sat_system(e->sat)) {
    case 'R':
        return 15 * 60 + 3 * 60; // half an hour of validity about tb, and the changing of the frame
    case 'S':
        return 6 * 60;
    case 'E':
        return ahead ? 1800 : 4 * 3600;
    case 'C':
        return 3600 + 3 * 60;
    case 'G':
    case 'J':
        return e->fit_interval_h > 4 ? e->fit_interval_h * 1800 : 7200;
    default:
        return 7200;
    }
}

static bool allowed(const orr_nav_eph *e, orr_time t, const orr_broadcast_choice *c)
{
    if (c->healthy && !orr_nav_eph_usable(e)) return false;
    if (c->iode != ORR_NAV_NO_IOD && e->iode != c->iode) return false;
    const double age = orr_time_diff_s(t, e->toe);
    if (!(fabs(age) <= (c->max_age_s > 0 ? c->max_age_s : usual_age_s(e, age < 0)))) return false;
    if (c->causal) {
        orr_time known = e->transmission;
        if (known == ORR_TIME_NONE)
            known = e->kind == ORR_NAV_KEPLER ? orr_time_add_s(e->toe, -7200) : e->toe;
        if (known > t) return false;
    }
    return true;
}

#define BIT(message) (UINT32_C(1) << (message))

// Which messages of a satellite are looked at; its records are nav->eph[first .. first + count).
static uint32_t wanted_messages(const orr_nav *nav, orr_sat sat, size_t first, size_t count, uint32_t asked)
{
    static const uint32_t legacy = BIT(ORR_NAV_LNAV) | BIT(ORR_NAV_INAV) | BIT(ORR_NAV_D1) | BIT(ORR_NAV_D2) |
                                   BIT(ORR_NAV_FDMA) | BIT(ORR_NAV_SBAS);
    static const uint8_t others[] = {ORR_NAV_FNAV, ORR_NAV_CNAV, ORR_NAV_CNV1,
                                     ORR_NAV_CNV2, ORR_NAV_CNV3, ORR_NAV_L1NV};
    asked &= orr_nav_messages_of(orr_sat_system(sat));
    if (asked != 0) return asked;
    uint32_t has = 0;
    for (size_t i = first; i < first + count; i++) has |= BIT(nav->eph[i].message);
    if ((has & legacy) != 0) return legacy;
    for (size_t k = 0; k < sizeof others; k++)
        if ((has & BIT(others[k])) != 0) return BIT(others[k]);
    return 0;
}

const orr_nav_eph *orr_broadcast_select(const orr_nav *nav, orr_sat sat, orr_time t,
                                        const orr_broadcast_choice *choice)
{
    size_t first = 0, count = 0;
    const orr_nav_eph *best = NULL;
    orr_nav_of_sat(nav, sat, &first, &count);
    const uint32_t messages = wanted_messages(nav, sat, first, count, choice->messages);
    for (size_t i = first; i < first + count; i++) {
        const orr_nav_eph *e = &nav->eph[i];
        if ((messages & BIT(e->message)) == 0 || !allowed(e, t, choice)) continue;
        if (best == NULL) {
            best = e;
            continue;
        }
        int64_t age = llabs(t - e->toe), best_age = llabs(t - best->toe);
        if (age < best_age || (age == best_age && e->transmission >= best->transmission)) best = e;
    }
    return best;
}

orr_vec3 orr_broadcast_pz90_to_itrf(orr_vec3 r, orr_time t)
{
    static const orr_civil pz9011 = {2014, 1, 15, 0, 0, 0, 0}, pz9002 = {2007, 9, 20, 0, 0, 0, 0};
    orr_time from11 = 0, from02 = 0;
    (void)orr_time_from_civil(&pz9011, ORR_SCALE_UTC, NULL, &from11);
    (void)orr_time_from_civil(&pz9002, ORR_SCALE_UTC, NULL, &from02);
    if (t >= from11) return r;
    if (t < from02) {
        const double turn = -0.13 / 3600 * ORR_RAD_PER_DEG, scale = 1 - 0.22e-6;
        r = orr_vec3_make(scale * (r.x + turn * r.y) - 1.07, scale * (r.y - turn * r.x) - 0.03,
                          scale * r.z + 0.02);
    }
    return orr_vec3_add(r, orr_vec3_make(-0.36, 0.08, 0.18));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// GLONASS ICD L1/L2 edition 5.1, A.3.2.2; names are its own.
#include "orbit/navdata/almanac_glonass.h"

#include "orbit/force/kepler.h"
#include "orbit/navdata/glonass_time.h"

// Names of the ICD: a receiver must use its values and no better ones.
#define AE_M ORR_GLONASS_RADIUS_M
#define C20 ORR_GLONASS_ALMANAC_C20
#define OMEGA3 ORR_GLONASS_EARTH_RATE_RADPS
#define MEAN_I_RAD (63.0 * ORR_RAD_PER_DEG)
#define MEAN_T_S 43200.0

// Orbit at the node, before short-period terms.
typedef struct node_orbit {
    double a, e, i, omega;
    double n;     // by the draconic period
    double h, l;  // e sin omega, e cos omega
    double mean;  // mean longitude lambda_1 = M + omega at the node
    double scale; // J (a_e / a)^2
} node_orbit;

// Semi-major axis of an orbit with this draconic period: the osculating period follows from it by C20, a from
// that; a few rounds settle it to micrometres.
static double semi_major_axis(double draconic_s, double i, double e, double omega)
{
    double s2 = sin(i) * sin(i), q = 1 - e * e, near = 1 + e * cos(omega);
    double factor = (2 - 2.5 * s2) * q * sqrt(q) / (near * near) + near * near * near / q;
    double period = draconic_s, a = 0;
    for (int round_no = 0; round_no < 8; round_no++) {
        a = cbrt(ORR_GLONASS_GM * period * period / (4 * ORR_PI * ORR_PI));
        double p = a * q;
        period = draconic_s / (1 + 1.5 * C20 * (AE_M / p) * (AE_M / p) * factor);
    }
    return a;
}

// Terms of C20 in a (relative), h, l, longitude of the node, i and mean longitude, at mean longitude `mean`
// and n tau after the node.
typedef struct terms {
    double a, h, l, node, i, mean;
} terms;

static terms perturbations(const node_orbit *o, double mean, double n_tau)
{
    const double h = o->h, l = o->l, s2 = sin(o->i) * sin(o->i), c2 = 1 - s2;
    const double s_1 = sin(mean), s_2 = sin(2 * mean), s_3 = sin(3 * mean), s_4 = sin(4 * mean);
    const double c_1 = cos(mean), c_2 = cos(2 * mean), c_3 = cos(3 * mean), c_4 = cos(4 * mean);
    const double k0 = o->scale * (1 - 1.5 * s2), ks = o->scale * s2, kc = o->scale * c2;
    const double node =
        n_tau + 7.0 / 2 * l * s_1 - 5.0 / 2 * h * c_1 - 1.0 / 2 * s_2 - 7.0 / 6 * l * s_3 + 7.0 / 6 * h * c_3;
    return (terms){
        .a = 2 * k0 * (l * c_1 + h * s_1) +
             ks * (0.5 * h * s_1 - 0.5 * l * c_1 + c_2 + 3.5 * l * c_3 + 3.5 * h * s_3),
        .h = k0 * (l * n_tau + s_1 + 1.5 * l * s_2 - 1.5 * h * c_2) -
             0.25 * ks * (s_1 - 7.0 / 3 * s_3 + 5 * l * s_2 - 8.5 * l * s_4 + 8.5 * h * c_4 + h * c_2) +
             kc * (l * n_tau - 0.5 * l * s_2),
        .l = k0 * (-h * n_tau + c_1 + 1.5 * l * c_2 + 1.5 * h * s_2) -
             0.25 * ks * (-c_1 - 7.0 / 3 * c_3 - 5 * h * s_2 - 8.5 * l * c_4 - 8.5 * h * s_4 + l * c_2) +
             kc * (-h * n_tau + 0.5 * h * s_2),
        .node = -o->scale * cos(o->i) * node,
        .i = 0.5 * o->scale * sin(o->i) * cos(o->i) *
             (-l * c_1 + h * s_1 + c_2 + 7.0 / 3 * l * c_3 + 7.0 / 3 * h * s_3),
        .mean = 2 * k0 * (n_tau + 1.75 * l * s_1 - 1.75 * h * c_1) +
                3 * ks *
                    (-7.0 / 24 * h * c_1 - 7.0 / 24 * l * s_1 - 49.0 / 72 * h * c_3 + 49.0 / 72 * l * s_3 +
                     0.25 * s_2) +
                kc * node,
    };
}

static bool orbit_at_node(const orr_glonass_almanac *a, node_orbit *o)
{
    double draconic_s = MEAN_T_S + a->delta_t_s;
    *o = (node_orbit){.e = a->e, .i = MEAN_I_RAD + a->delta_i_rad, .omega = a->omega_rad};
    if (!(draconic_s > 5400 && draconic_s < 1e6) || !(a->e >= 0 && a->e < 0.5) || !isfinite(o->i + o->omega))
        return false;
    o->a = semi_major_axis(draconic_s, o->i, o->e, o->omega);
    o->n = 2 * ORR_PI / draconic_s;
    o->h = o->e * sin(o->omega), o->l = o->e * cos(o->omega);
    o->scale = -1.5 * C20 * (AE_M / o->a) * (AE_M / o->a);
    double E = atan2(sqrt(1 - o->e * o->e) * -sin(o->omega), o->e + cos(o->omega)); // true anomaly is -omega
    o->mean = E - o->e * sin(E) + o->omega;
    return isfinite(o->a) && o->a > AE_M;
}

// t* of the ICD. Seconds of the day are counted back from its end: on a day with a leap second (at 03:00) the
// clock's label is the count from there on.
static double since_t_lambda(const orr_glonass_almanac *a, orr_time t)
{
    orr_time next = orr_glonass_day(orr_time_add_s(a->day, 1.5 * ORR_S_PER_DAY), a->leap);
    return orr_time_diff_s(t, next) + ORR_S_PER_DAY - a->t_lambda_s;
}

orr_status orr_glonass_almanac_eval(const orr_glonass_almanac *a, orr_time t, orr_vec3 *pos_m,
                                    orr_vec3 *vel_mps)
{
    node_orbit o;
    if (!orbit_at_node(a, &o)) return ORR_E_NUMERIC;
    // The last node before t: whole revolutions, their time with the period's change, the node's longitude
    // there.
    double since_s = since_t_lambda(a, t), w = floor(since_s / (MEAN_T_S + a->delta_t_s));
    double whole_s = (MEAN_T_S + a->delta_t_s) * w + a->delta_t_rate * w * w, tau = since_s - whole_s;
    double ratio = AE_M / o.a;
    double node_rate = 1.5 * C20 * o.n * ratio * ratio * cos(o.i) * sqrt(1 - o.e * o.e);
    double lambda_k = a->lambda_rad + (node_rate - OMEGA3) * whole_s;

    terms first = perturbations(&o, o.mean, 0), second = perturbations(&o, o.mean + o.n * tau, o.n * tau);
    double a_i = o.a * (1 + second.a - first.a);
    double h = o.h + second.h - first.h, l = o.l + second.l - first.l;
    double i = o.i + second.i - first.i, node = lambda_k - OMEGA3 * tau + second.node - first.node;
    double e = hypot(h, l), omega = atan2(h, l);
    double M = o.mean + o.n * tau + second.mean - first.mean - omega;
    if (!(e < 0.9) || !isfinite(M + node)) return ORR_E_NUMERIC;

    orr_kepler k = {.a_m = a_i, .e = e, .i_rad = i, .raan_rad = node, .argp_rad = omega, .m_rad = M};
    orr_vec3 turning;
    orr_kepler_to_state(&k, ORR_GLONASS_GM, pos_m, &turning);
    *vel_mps = orr_vec3_sub(turning, orr_vec3_cross(orr_vec3_make(0, 0, OMEGA3), *pos_m));
    return ORR_OK;
}

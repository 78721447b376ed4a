// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/scintillation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/angle.h"
#include "core/constants.h"
#include "core/hermite.h"
#include "core/rng.h"

// Sinusoids: of each part of xi, and of the phase. Their fourth moments are within 1/64 of a Gaussian's.
enum {
    WAVES = 64,
    PHASE_WAVES = 48,
    XI_WAVES = 2 * WAVES,
    ALL_WAVES = XI_WAVES + PHASE_WAVES,
    WIDE = 4 // doubles of a vector; a divisor of both
};
_Static_assert((int)ALL_WAVES == (int)ORR_SCINTILLATION_WAVES, "the cell has room for all sinusoids");
static const double BETA = 1.239646464;
static const double LOW_HZ = 0.1, HIGH_HZ = 10;
static const double RISE_S = 10, FADE_RAD = 0.5 * ORR_RAD_PER_DEG, FADE_H = 0.1;
// Nodes of the processes; of 10 Hz cubics between them keep 0.98.
#define NODE_NS (20 * ORR_NS_PER_S / 1000)
enum { NODES_A_TENTH = 5 }; // of a second

typedef struct row {
    orr_scenario_scintillation o; // its lists are not kept
    bool has_lat, has_lon, has_local;
    double lat_rad[2], lon_rad[2], local_h[2];
    double w_radps
        [WAVES]; // of unit tau0's spectrum, middle of each part's bounds by random numbers of the satellite
    double phase_amplitude[PHASE_WAVES], edge_hz[PHASE_WAVES + 1];
} row;

struct orr_scintillation {
    size_t n;
    row *row;
};

// Share of the power of a Butterworth spectrum 1/(1 + x^4) below x, 0 <= x.
static double below(double x)
{
    const double r = sqrt(2);
    const double part = (log((x * x + r * x + 1) / (x * x - r * x + 1)) / (4 * r)) +
                        (atan(r * x + 1) + atan(r * x - 1)) / (2 * r);
    return part / (ORR_PI / (2 * r));
}

static double quantile(double share)
{
    double low = 0, high = 1;
    while (below(high) < share) high *= 2;
    for (int k = 0; k < 60; k++) {
        const double middle = (low + high) / 2;
        *(below(middle) < share ? &low : &high) = middle;
    }
    return (low + high) / 2;
}

static void make_spectra(row *r)
{
    // Corner of the spectrum: sqrt(2) beta / tau0.
    for (int k = 0; k < WAVES; k++)
        r->w_radps[k] = quantile((k + 0.5) / WAVES) * sqrt(2) * BETA / r->o.tau0_s;
    const double p = r->o.slope, whole = pow(LOW_HZ, 1 - p) - pow(HIGH_HZ, 1 - p);
    for (int k = 0; k <= PHASE_WAVES; k++)
        r->edge_hz[k] = LOW_HZ * pow(HIGH_HZ / LOW_HZ, (double)k / PHASE_WAVES);
    for (int k = 0; k < PHASE_WAVES; k++)
        r->phase_amplitude[k] = sqrt(2 * (pow(r->edge_hz[k], 1 - p) - pow(r->edge_hz[k + 1], 1 - p)) / whole);
}

static bool take_pair(const orr_real_list *list, double scale, double out[2])
{
    for (size_t k = 0; k < 2 && list->n == 2; k++) out[k] = list->item[k] * scale;
    return list->n == 2;
}

orr_status orr_scintillation_open(const orr_scenario *s, orr_scintillation **out, orr_diag *diag)
{
    *out = NULL;
    if (s->scintillation.n == 0) return ORR_OK;
    orr_scintillation *x = calloc(1, sizeof *x);
    if (x != NULL) x->row = calloc(s->scintillation.n, sizeof *x->row);
    if (x == NULL || x->row == NULL) {
        free(x);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    for (; x->n < s->scintillation.n; x->n++) {
        row *r = &x->row[x->n];
        r->o = s->scintillation.item[x->n];
        r->has_lat = take_pair(&r->o.latitude_deg, ORR_RAD_PER_DEG, r->lat_rad);
        r->has_lon = take_pair(&r->o.longitude_deg, ORR_RAD_PER_DEG, r->lon_rad);
        r->has_local = take_pair(&r->o.local_time_h, 1, r->local_h);
        make_spectra(r);
    }
    *out = x;
    return ORR_OK;
}

void orr_scintillation_close(orr_scintillation *x)
{
    if (x == NULL) return;
    free(x->row);
    free(x);
}

static const row *row_of(const orr_scintillation *x, orr_sat sat)
{
    for (size_t k = 0; k < x->n; k++)
        if (!x->row[k].o.has_sats || orr_sat_set_has(&x->row[k].o.sats, sat)) return &x->row[k];
    return NULL;
}

// 1 from `inside` 0 on, 0 from -width on, smooth between.
static double fade(double inside, double width)
{
    const double s = fmin(fmax(inside / width + 1, 0), 1);
    return s * s * s * (10 + s * (6 * s - 15));
}

// How far x is inside a range on a circle of this length; negative outside.
static double inside_circle(double x, const double range[2], double circle)
{
    const double length = range[1] - range[0] - circle * floor((range[1] - range[0]) / circle);
    const double half = length > 0 ? length / 2 : circle / 2;
    return half - fabs(remainder(x - range[0] - half, circle));
}

static double weight(const row *r, orr_time t, const orr_pierce *p)
{
    double w = 1;
    if (r->o.has_from) w *= fade(orr_time_diff_s(t, r->o.from), RISE_S);
    if (r->o.has_to) w *= fade(orr_time_diff_s(r->o.to, t), RISE_S);
    if (r->has_lat) w *= fade(fmin(p->lat_rad - r->lat_rad[0], r->lat_rad[1] - p->lat_rad), FADE_RAD);
    if (r->has_lon) w *= fade(inside_circle(p->lon_rad, r->lon_rad, 2 * ORR_PI), FADE_RAD);
    if (r->has_local) {
        const double day_h = (double)orr_floor_mod(t, 86400 * ORR_NS_PER_S) / 3.6e12;
        w *= fade(inside_circle(day_h + p->lon_rad * 12 / ORR_PI, r->local_h, 24), FADE_H);
    }
    return w;
}

orr_scintillation_now orr_scintillation_at(const orr_scintillation *x, orr_sat sat, orr_time t,
                                           const orr_pierce *p)
{
    const row *r = row_of(x, sat);
    if (r == NULL) return (orr_scintillation_now){0, 0};
    const double w = weight(r, t, p);
    return (orr_scintillation_now){w * r->o.s4, w * r->o.sigma_phi_rad};
}

// Draws the sinusoids of a satellite at an antenna.
static void make_waves(const row *r, uint64_t stream, orr_scintillation_waves *x)
{
    const uint64_t seed = (uint64_t)r->o.seed;
    for (int k = 0; k < ALL_WAVES; k++) {
        uint32_t u[4];
        const int j = k - XI_WAVES; // of the phase
        orr_rng_u32(seed, stream, (uint64_t)(j < 0 ? k : 1000 + j), u);
        const double share = u[0] * 0x1p-32;
        // Both parts of xi: frequencies of either sign make them independent.
        x->w_radps[k] = j < 0 ? r->w_radps[k / 2] * (1 + 0.02 * (share - 0.5)) * (k % 2 == 0 ? 1 : -1)
                              : 2 * ORR_PI * r->edge_hz[j] * pow(r->edge_hz[j + 1] / r->edge_hz[j], share);
        x->amplitude[k] = j < 0 ? 1 / sqrt(2 * WAVES) : r->phase_amplitude[j];
        x->per_s[k] = 4 * (uint64_t)(int64_t)(remainder(x->w_radps[k] / (2 * ORR_PI), 1) * 0x1p62);
        x->at_zero[k] = (uint64_t)u[1] << 32;
        const double second = remainder(x->w_radps[k], 2 * ORR_PI);
        const double node = x->w_radps[k] * (double)NODE_NS / 1e9, tenth = NODES_A_TENTH * node;
        x->second_turn_re[k] = cos(second);
        x->second_turn_im[k] = sin(second);
        x->node_turn_re[k] = cos(node);
        x->node_turn_im[k] = sin(node);
        x->tenth_turn_re[k] = cos(tenth);
        x->tenth_turn_im[k] = sin(tenth);
    }
    x->second = INT64_MIN;
    x->made = true;
}

static void multiply(double *restrict re, double *restrict im, const double *restrict by_re,
                     const double *restrict by_im)
{
    for (int k = 0; k < ALL_WAVES; k++) {
        const double x = re[k] * by_re[k] - im[k] * by_im[k];
        im[k] = re[k] * by_im[k] + im[k] * by_re[k];
        re[k] = x;
    }
}

// Back to the second.
static void begin_again(orr_scintillation_waves *x)
{
    memcpy(x->tenth_re, x->second_re, sizeof x->tenth_re);
    memcpy(x->tenth_im, x->second_im, sizeof x->tenth_im);
    x->tenth = 0;
}

// Phasors at a whole second: of every eighth modulo 2^64 of a cycle, and so without rounding however far the time is, from there by
// one multiplication a second, whatever they were before.
static void begin_second(orr_scintillation_waves *x, int64_t second)
{
    enum { EXACT_S = 8 };
    const int64_t exact = second - orr_floor_mod(second, EXACT_S);
    if (!(x->second >= exact && x->second < second)) {
        for (int k = 0; k < ALL_WAVES; k++) {
            double s, c;
            orr_turn_sincos(x->at_zero[k] + x->per_s[k] * (uint64_t)exact, &s, &c);
            x->second_re[k] = x->amplitude[k] * c;
            x->second_im[k] = x->amplitude[k] * s;
        }
        x->second = exact;
    }
    for (; x->second < second; x->second++)
        multiply(x->second_re, x->second_im, x->second_turn_re, x->second_turn_im);
    begin_again(x);
}

// Phasors at a node: from its second by one multiplication a tenth, and from there by one a node, whatever they were before.
static void turn_to(orr_scintillation_waves *x, orr_time t)
{
    const int64_t second = orr_floor_div(t, ORR_NS_PER_S);
    const int nodes = (int)((t - second * ORR_NS_PER_S) / NODE_NS), tenth = nodes / NODES_A_TENTH,
              node = nodes % NODES_A_TENTH;
    const bool same = x->second == second && x->tenth == tenth;
    if (x->second != second)
        begin_second(x, second);
    else if (x->tenth > tenth)
        begin_again(x);
    for (; x->tenth < tenth; x->tenth++)
        multiply(x->tenth_re, x->tenth_im, x->tenth_turn_re, x->tenth_turn_im);
    if (!same || x->node > node) {
        memcpy(x->re, x->tenth_re, sizeof x->re);
        memcpy(x->im, x->tenth_im, sizeof x->im);
        x->node = 0;
    }
    for (; x->node < node; x->node++) multiply(x->re, x->im, x->node_turn_re, x->node_turn_im);
}

typedef double wide __attribute__((vector_size(WIDE * sizeof(double))));

static void load(const double *x, wide *out) { memcpy(out, x, sizeof *out); }

static double total(const wide *v) { return ((*v)[0] + (*v)[1]) + ((*v)[2] + (*v)[3]); }

// The processes at a node: value and rate of both parts of xi, each of variance 1/2, and of the phase.
static void node_at(orr_scintillation_waves *x, orr_time t, double value[3], double rate[3])
{
    turn_to(x, t);
    wide re = {0}, im = {0}, phase = {0}, re_rate = {0}, im_rate = {0}, phase_rate = {0};
    for (int k = 0; k < ALL_WAVES; k += WIDE) {
        wide c, z, w;
        load(&x->re[k], &c);
        load(&x->im[k], &z);
        load(&x->w_radps[k], &w);
        if (k < XI_WAVES) {
            re += c;
            im += z;
            re_rate -= w * z;
            im_rate += w * c;
        } else {
            phase += c;
            phase_rate -= w * z;
        }
    }
    value[0] = total(&re);
    value[1] = total(&im);
    value[2] = total(&phase);
    rate[0] = total(&re_rate);
    rate[1] = total(&im_rate);
    rate[2] = total(&phase_rate);
}

static void make_cell(const row *r, uint64_t stream, orr_time t, orr_scintillation_cell *cell)
{
    double v[2][3], rate[2][3];
    if (!cell->waves.made) make_waves(r, stream, &cell->waves);
    const orr_time from = t - orr_floor_mod(t, NODE_NS);
    const bool goes_on = cell->made && cell->to == from;
    double *const part[3] = {cell->re, cell->im, cell->phase};
    if (goes_on) {
        memcpy(v[0], cell->end, sizeof v[0]);
        memcpy(rate[0], cell->end_rate, sizeof rate[0]);
    } else {
        node_at(&cell->waves, from, v[0], rate[0]);
    }
    cell->from = from;
    cell->made = true;
    // Who asks at nodes, and not for what is between them, needs the one.
    cell->to = t == from && !goes_on ? from + 1 : from + NODE_NS;
    if (cell->to == from + 1) {
        for (int k = 0; k < 3; k++)
            orr_hermite_cubic(v[0][k], rate[0][k] * (double)NODE_NS / 1e9, rate[0][k], rate[0][k],
                              (double)NODE_NS / 1e9, part[k]);
        return;
    }
    node_at(&cell->waves, from + NODE_NS, v[1], rate[1]);
    for (int k = 0; k < 3; k++)
        orr_hermite_cubic(v[0][k], v[1][k] - v[0][k], rate[0][k], rate[1][k], (double)NODE_NS / 1e9, part[k]);
    memcpy(cell->end, v[1], sizeof v[1]);
    memcpy(cell->end_rate, rate[1], sizeof rate[1]);
}

void orr_scintillation_of(const orr_scintillation *x, orr_sat sat, size_t antenna, orr_time t,
                          orr_scintillation_now indices, double carrier_hz, orr_scintillation_cell *cell,
                          orr_scintillation_effect *out)
{
    const row *r = row_of(x, sat);
    *out = (orr_scintillation_effect){.power_db = 0};
    if (r == NULL || !(indices.s4 > 0 || indices.sigma_phi_rad > 0)) return;
    if (!cell->made || t < cell->from || t >= cell->to)
        make_cell(r, ((uint64_t)antenna << 16) | sat, t, cell);
    const double s = orr_time_diff_s(t, cell->from), ratio = ORR_L1_HZ / carrier_hz;
    const double sigma = indices.sigma_phi_rad * ratio / (2 * ORR_PI);
    out->phase_cycles = sigma * orr_cubic_at(cell->phase, s);
    out->phase_rate_hz = sigma * orr_cubic_rate(cell->phase, s);
    if (!(indices.s4 > 1e-6)) return;
    // sqrt(m^2 - m)/m, m = 1/S4^2: K/(K + 1), and 1/(K + 1).
    const double s4 = fmin(indices.s4 * ratio * sqrt(ratio), 1), direct = sqrt(1 - s4 * s4),
                 scattered = s4 * s4 / (1 + direct);
    const double a = sqrt(scattered), re = sqrt(direct) + a * orr_cubic_at(cell->re, s),
                 im = a * orr_cubic_at(cell->im, s), re_rate = orr_cubic_rate(cell->re, s),
                 im_rate = orr_cubic_rate(cell->im, s), power = fmax(re * re + im * im, 1e-12);
    out->power_db = 10 / log(10) * log(power);
    out->phase_cycles += orr_atan2(im, re) / (2 * ORR_PI);
    out->phase_rate_hz += a * (re * im_rate - im * re_rate) / power / (2 * ORR_PI);
}

int64_t orr_scintillation_block_ns(const orr_scintillation *x, orr_time from, orr_time to)
{
    double least_s = (double)INFINITY;
    for (size_t k = 0; x != NULL && k < x->n; k++) {
        const orr_scenario_scintillation *o = &x->row[k].o;
        const int64_t rise = (int64_t)(RISE_S * 1e9);
        if ((o->has_from && to <= o->from - rise) || (o->has_to && from >= o->to + rise)) continue;
        least_s = fmin(least_s, o->s4 > 0 ? o->tau0_s / 50 : 0.01); // the phase has 10 Hz
    }
    return isinf(least_s) ? INT64_MAX : (int64_t)(fmax(least_s, 0.001) * 1e9);
}

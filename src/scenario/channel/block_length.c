// SPDX-License-Identifier: GPL-3.0-or-later
// How long blocks may be: cubics through value and velocity of the antenna at both ends, against the motion itself.
#include <math.h>

#include "src/scenario/channel/block.h"
#include "src/scenario/channel/effects.h"

// Of an antenna on a body, which may shake at any rate: beyond 100 ms nothing is gained. Each divides a cell.
static const int64_t LENGTHS_NS[] = {1000000, 2000000, 5000000, 10000000, 20000000, 50000000, 100000000};
enum { N_LENGTHS = sizeof LENGTHS_NS / sizeof *LENGTHS_NS };
static const int64_t FIXED_NS = ORR_NS_PER_S; // of a fixed antenna
// Blocks of one length that are tried in a cell: all where there are fewer, otherwise spread over it.
enum { TRIED = 500 };

// Greatest deviation of the cubic over [t, t + length] from the motion: at the middle, and what the middle's rate tells of a
// deviation that is zero there. Negative where the antenna is not there.
static double deviation_m(const orr_antenna *a, orr_time t, int64_t length_ns)
{
    orr_antenna_state x0, x1, m;
    if (orr_antenna_at(a, t, &x0) != ORR_ANSWER_OK ||
        orr_antenna_at(a, t + length_ns, &x1) != ORR_ANSWER_OK ||
        orr_antenna_at(a, t + length_ns / 2, &m) != ORR_ANSWER_OK)
        return -1;
    const double T = (double)length_ns / 1e9;
    const orr_vec3 rise = orr_vec3_sub(x1.r_m, x0.r_m), sum_v = orr_vec3_add(x0.v_mps, x1.v_mps);
    // H(T/2) = (x0 + x1)/2 + T (v0 - v1)/8,  H'(T/2) = 3 (x1 - x0)/(2 T) - (v0 + v1)/4, all against x0.
    const orr_vec3 middle = orr_vec3_axpy(T / 8, orr_vec3_sub(x0.v_mps, x1.v_mps), orr_vec3_scale(0.5, rise));
    const orr_vec3 rate = orr_vec3_sub(orr_vec3_scale(1.5 / T, rise), orr_vec3_scale(0.25, sum_v));
    const double value = orr_vec3_norm(orr_vec3_sub(orr_vec3_sub(m.r_m, x0.r_m), middle));
    const double slope = orr_vec3_norm(orr_vec3_sub(m.v_mps, rate));
    return fmax(value, slope * T / 6);
}

// The greatest of the blocks that are tried.
static double worst_m(const orr_antenna *a, orr_time cell, int64_t length_ns)
{
    const int64_t n = ORR_BLOCK_CELL_NS / length_ns, every = n > TRIED ? n / TRIED : 1;
    double worst = 0;
    for (int64_t k = 0; k < n; k += every) {
        // Spread by the golden ratio within each stretch, so that no period is met at the same phase again and again.
        const int64_t shift =
            every > 1 ? (int64_t)(fmod((double)(k / every) * 0.6180339887498949, 1) * (double)every) : 0;
        worst = fmax(worst, deviation_m(a, cell + (k + shift) * length_ns, length_ns));
    }
    return worst;
}

// The longest of those allowed that is not above most_ns.
static int64_t allowed_ns(const orr_channels *c, size_t antenna, orr_time cell, int64_t most_ns)
{
    if (effects_allow(c, antenna, cell, most_ns)) return most_ns;
    size_t k = N_LENGTHS - 1;
    while (k > 0 && !effects_allow(c, antenna, cell, LENGTHS_NS[k])) k--;
    return LENGTHS_NS[k];
}

void orr_block_length_of(const orr_channels *c, size_t antenna, orr_time cell, int64_t *length_ns,
                         double *error_m)
{
    const orr_antenna *a = &c->antenna[antenna];
    if (a->motion == NULL) { // the satellites' motion and the ionosphere's change decide (docs/channels.md)
        *length_ns = allowed_ns(c, antenna, cell, FIXED_NS);
        *error_m = 1.3e-10; // T^4/384 of 5e-8 m/s^4, a navigation satellite's at the horizon
        return;
    }
    *length_ns = LENGTHS_NS[0];
    *error_m = worst_m(a, cell, LENGTHS_NS[0]);
    for (size_t k = 1; k < N_LENGTHS && effects_allow(c, antenna, cell, LENGTHS_NS[k]); k++) {
        const double worst = worst_m(a, cell, LENGTHS_NS[k]);
        if (worst > c->options.error_m / 1.25) return;
        *length_ns = LENGTHS_NS[k];
        *error_m = worst;
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The turn between satellite and antenna is the sum of two: satellite against a dipole that lies still at the antenna's place,
// which changes slowly and is counted a minute at a time; and that dipole against the antenna's own, which for an antenna that
// is not upside down is close to its heading, whose turns are counted along the trajectory.
#include "src/scenario/channel/windup.h"

#include <math.h>
#include <stdlib.h>

#include "core/angle.h"
#include "iono/phase/windup.h"
#include "orbit/spacecraft/spacecraft.h"

static const int64_t NODE_NS = 60 * ORR_NS_PER_S, HEADING_NS = ORR_NS_PER_S / 10;

// Turns between the satellite's dipole and one at the place along `axes`, the one nearest to `before`.
static double turns(const orr_antenna_state *state, const orr_mat3 *axes, orr_vec3 sat_m,
                    const orr_mat3 *attitude, double before)
{
    const double(*a)[3] = axes->m, (*b)[3] = attitude->m;
    const orr_iono_site site = {.pos_m = state->r_m,
                                .east = {a[0][0], a[0][1], a[0][2]},
                                .north = {a[1][0], a[1][1], a[1][2]},
                                .up = {a[2][0], a[2][1], a[2][2]}};
    return orr_windup_axes(&site, sat_m, (orr_vec3){b[0][0], b[0][1], b[0][2]},
                           (orr_vec3){b[1][0], b[1][1], b[1][2]}, before);
}

static orr_status count_headings(const orr_antenna *a, orr_windup *w, orr_diag *diag)
{
    orr_span moved;
    if (a->motion == NULL || !orr_source_motion_span(a->motion, &moved)) return ORR_OK;
    w->heading_from = moved.from;
    w->n_headings = (size_t)((moved.to - moved.from) / HEADING_NS) + 2;
    w->heading = calloc(w->n_headings, sizeof *w->heading);
    if (w->heading == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    double last = 0;
    for (size_t k = 0; k < w->n_headings; k++) {
        orr_motion m;
        const orr_time t = orr_time_add(moved.from, (int64_t)k * HEADING_NS);
        if (orr_source_motion_at(a->motion, a->unit, t < moved.to ? t : moved.to, &m) == ORR_ANSWER_OK) {
            const double h = orr_motion_angles(&m).heading_rad / (2 * ORR_PI);
            last = h + floor(last - h + 0.5);
        }
        w->heading[k] = last;
    }
    return ORR_OK;
}

static orr_status count_nodes(const orr_source_orbit *orbits, const orr_antenna *a, const orr_antex *antex,
                              const orr_sun_track *sun, const volatile int *cancel, orr_windup *w,
                              orr_diag *diag)
{
    const orr_sat *list;
    w->n_sats = orr_source_orbit_satellites(orbits, &list);
    w->turns = calloc(w->n_sats * w->n_nodes, sizeof *w->turns);
    double *last = calloc(w->n_sats, sizeof *last);
    orr_status status = ORR_OK;
    if (w->turns == NULL || last == NULL) status = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    const orr_spacecraft_sources src = {.orbit = orr_source_orbit_ephemeris(orbits), .antex = antex};
    orr_antenna_state state = {.r_m = {0, 0, 0}};
    bool placed = false;
    for (size_t i = 0; status == ORR_OK && i < w->n_nodes; i++) {
        if (cancel != NULL && *cancel) status = orr_diag_set(diag, ORR_E_INTERRUPTED, "interrupted");
        const orr_time t = orr_time_add(w->from, (int64_t)i * NODE_NS);
        placed = orr_antenna_at(a, t, &state) == ORR_ANSWER_OK || placed;
        const orr_vec3 sun_m = orr_sun_track_at(sun, t);
        for (size_t k = 0; k < w->n_sats; k++) {
            orr_spacecraft x;
            if (placed && orr_spacecraft_at(&src, list[k], t, sun_m, &x) == ORR_OK && x.has_attitude)
                last[k] = turns(&state, &state.enu, x.state.pos_m, &x.attitude.body, last[k]);
            w->turns[k * w->n_nodes + i] = (float)last[k];
        }
    }
    free(last);
    return status;
}

orr_status orr_windup_open(const orr_source_orbit *orbits, const orr_antenna *a, const orr_antex *antex,
                           orr_span span, const orr_sun_track *sun, const volatile int *cancel,
                           orr_windup *out, orr_diag *diag)
{
    *out = (orr_windup){.from = span.from, .n_nodes = (size_t)((span.to - span.from) / NODE_NS) + 2};
    orr_status s = count_headings(a, out, diag);
    if (s == ORR_OK) s = count_nodes(orbits, a, antex, sun, cancel, out, diag);
    if (s != ORR_OK) orr_windup_free(out);
    return s;
}

void orr_windup_free(orr_windup *w)
{
    free(w->turns);
    free(w->heading);
    *w = (orr_windup){.from = 0};
}

// Place of t on a lattice of n nodes, linear between two of them.
static size_t node_of(orr_time t, orr_time from, int64_t step_ns, size_t n, double *part)
{
    const int64_t dt = t > from ? t - from : 0;
    size_t k = (size_t)(dt / step_ns);
    if (k > n - 2) k = n - 2;
    *part = fmin((double)(dt - (int64_t)k * step_ns) / (double)step_ns, 1);
    return k;
}

double orr_windup_still(const orr_windup *w, size_t k, orr_time t, const orr_antenna_state *state,
                        orr_vec3 sat_m, const orr_mat3 *attitude)
{
    double part;
    const size_t i = node_of(t, w->from, NODE_NS, w->n_nodes, &part);
    const float *row = &w->turns[k * w->n_nodes];
    const double near = (double)row[i] + part * ((double)row[i + 1] - (double)row[i]);
    return turns(state, &state->enu, sat_m, attitude, near);
}

// Effective dipole of a receiving antenna (Wu et al. 1993, eq. (24)) with its rate.
typedef struct dipole {
    orr_vec3 d, rate;
} dipole;

// Along x and y, which turn at w; k points from the satellite to the antenna.
static dipole effective(orr_vec3 x, orr_vec3 y, orr_vec3 w, orr_vec3 k, orr_vec3 k_rate)
{
    const orr_vec3 x_rate = orr_vec3_cross(w, x), y_rate = orr_vec3_cross(w, y);
    const double along = orr_vec3_dot(k, x), along_rate = orr_vec3_dot(k_rate, x) + orr_vec3_dot(k, x_rate);
    dipole e;
    e.d = orr_vec3_add(orr_vec3_axpy(-along, k, x), orr_vec3_cross(k, y));
    e.rate = orr_vec3_axpy(-along, k_rate, orr_vec3_axpy(-along_rate, k, x_rate));
    e.rate = orr_vec3_add(e.rate, orr_vec3_add(orr_vec3_cross(k_rate, y), orr_vec3_cross(k, y_rate)));
    return e;
}

// Rate of turn of a vector about k, to which it is perpendicular.
static double turn_rate(const dipole *e, orr_vec3 k)
{
    return orr_vec3_dot(k, orr_vec3_cross(e->d, e->rate)) / orr_vec3_dot(e->d, e->d);
}

static orr_vec3 row_of(const orr_mat3 *axes, int row)
{
    return (orr_vec3){axes->m[row][0], axes->m[row][1], axes->m[row][2]};
}

double orr_windup_turned(const orr_windup *w, orr_time t, const orr_antenna_state *state, orr_vec3 u,
                         orr_vec3 u_rate_ps, double *rate_hz)
{
    *rate_hz = 0;
    if (w->n_headings == 0) return 0;
    double part;
    const size_t i = node_of(t, w->heading_from, HEADING_NS, w->n_headings, &part);
    const double heading = w->heading[i] + part * (w->heading[i + 1] - w->heading[i]);
    // As in iono/phase/windup.c, x points North and y West. Seen from the satellite above, a heading turns clockwise, and the
    // angle from the still dipole to the antenna's grows.
    const orr_vec3 k = orr_vec3_scale(-1, u), k_rate = orr_vec3_scale(-1, u_rate_ps);
    const dipole still = effective(row_of(&state->enu, 1), orr_vec3_scale(-1, row_of(&state->enu, 0)),
                                   state->enu_radps, k, k_rate);
    const dipole own = effective(row_of(&state->axes, 1), orr_vec3_scale(-1, row_of(&state->axes, 0)),
                                 state->w_radps, k, k_rate);
    const double angle =
                     orr_atan2(orr_vec3_dot(k, orr_vec3_cross(still.d, own.d)), orr_vec3_dot(still.d, own.d)),
                 turned = angle / (2 * ORR_PI);
    *rate_hz = (turn_rate(&own, k) - turn_rate(&still, k)) / (2 * ORR_PI);
    return turned + floor(heading - turned + 0.5);
}

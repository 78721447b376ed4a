// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/live.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "src/scenario/channel/channels_private.h"
#include "src/scenario/channel/slow.h"

// Beside the line slow terms are right to first order: what curves is 2.3 m / (8 km)^2 of the troposphere at the zenith, 16 um at
// 30 m; ten times that near the horizon.
static const double STRAYED_M = 30;

typedef struct live_antenna {
    orr_antenna_line line;
    bool has_line;
    double heading[2]; // turns, counted on from block to block; twice the same for orr_windup
} live_antenna;

struct orr_live_channels {
    orr_channels c; // as the scenario's, but for its antennas' motion and the count of their turns
    orr_channel_work *work;
    live_antenna antenna[ORR_MAX_ANTENNAS];
};

orr_status orr_live_channels_open(const orr_channels *c, orr_live_channels **out, orr_diag *diag)
{
    orr_live_channels *l = calloc(1, sizeof *l);
    if (l == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    l->c = *c;
    const orr_status s = orr_channel_work_open(&l->c, &l->work, diag);
    if (s != ORR_OK) {
        free(l);
        return s;
    }
    for (size_t k = 0; k < c->n_antennas; k++) {
        if (c->antenna[k].motion == NULL) continue;
        l->c.antenna[k].line = &l->antenna[k].line;
        l->c.windup[k].heading = l->antenna[k].heading;
        l->c.windup[k].n_headings = 2;
        l->c.windup[k].heading_from = INT64_MIN / 2;
    }
    *out = l;
    return ORR_OK;
}

void orr_live_channels_close(orr_live_channels *l)
{
    if (l != NULL) orr_channel_work_close(l->work);
    free(l);
}

bool orr_live_channels_rides(const orr_live_channels *l, size_t antenna)
{
    return antenna < l->c.n_antennas && l->c.antenna[antenna].motion != NULL;
}

// A line through the antenna as it is, unless the present one is near.
static void take_line(orr_live_channels *l, size_t antenna, orr_time t, const orr_antenna_state *at)
{
    live_antenna *a = &l->antenna[antenna];
    channel_antenna_work *w = &l->work->antenna[antenna];
    if (a->has_line) {
        const orr_antenna_state on = orr_antenna_carried(&a->line.at, orr_time_diff_s(t, a->line.t));
        if (orr_vec3_norm(orr_vec3_sub(at->r_m, on.r_m)) <= STRAYED_M) return;
    }
    a->line = (orr_antenna_line){t, *at};
    a->has_line = true;
    slow_cells_forget(w->slow, l->c.n_sats);
    memset(w->leaf, 0, sizeof w->leaf);
    w->candidates_of = ORR_TIME_NONE;
}

// Counts the turns of the body's heading on to where it is now.
static void count_turns(live_antenna *a, const orr_motion *m)
{
    const double turned = orr_motion_angles(m).heading_rad / (2 * ORR_PI), before = a->heading[0];
    a->heading[0] = a->heading[1] = turned + floor(before - turned + 0.5);
}

orr_answer orr_live_blocks(orr_live_channels *l, size_t antenna, const orr_live_motion *m, uint64_t signals,
                           orr_antenna_state *at, orr_block *block, size_t *n)
{
    const orr_antenna *a = &l->c.antenna[antenna];
    blocks_ends e = {.t0 = m->t0, .t1 = m->t1};
    *n = 0;
    if (!orr_span_holds(l->c.span, m->t0) || !orr_span_holds(l->c.span, m->t1))
        return ORR_ANSWER_OUTSIDE_SPAN;
    orr_antenna_ride(a, &m->begin, m->arm, &e.at0);
    orr_antenna_ride(a, &m->end, m->arm, &e.at1);
    if (m->breaks) l->work->antenna[antenna].end.t = ORR_TIME_NONE;
    take_line(l, antenna, m->t0, &e.at0);
    count_turns(&l->antenna[antenna], &m->end);
    blocks_between(&l->c, antenna, l->work, &e, signals, block, n);
    *at = e.at0;
    return ORR_ANSWER_OK;
}

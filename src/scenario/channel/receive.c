// SPDX-License-Identifier: GPL-3.0-or-later
// All that an antenna receives: the channels of the sky, and those of spoofers.
#include <math.h>

#include "core/angle.h"
#include "src/scenario/channel/spoofed.h"

// A channel of the place told, as it arrives from the transmitter.
static void send(const spoofer *x, const orr_antenna_state *at, orr_time t, channel_list *list, size_t k)
{
    const orr_vec3 d = orr_vec3_sub(orr_mover_at(&x->transmitter, t), at->r_m),
                   own = orr_mat3_apply(&at->enu, d);
    const double range = orr_vec3_norm(d), az = orr_atan2(own.x, own.y),
                 rate =
                     range > 0 ? orr_vec3_dot(d, orr_vec3_sub(x->transmitter.v_mps, at->v_mps)) / range : 0;
    orr_channel *out = &list->channel[k];
    out->term_m[ORR_TERM_SPOOFER] = range + x->delay_m;
    out->rate_mps[ORR_TERM_SPOOFER] = rate;
    out->az_rad = az < 0 ? az + 2 * ORR_PI : az;
    out->el_rad = orr_atan2(own.z, sqrt(own.x * own.x + own.y * own.y));
    out->power_dbw += x->power_db;
    channels_sum(t, list->start[k], out);
}

static void add_false(const orr_channels *c, orr_channel_work *work, const orr_antenna_state *at,
                      uint64_t signals, const bool *also, channel_list *list)
{
    const struct spoofed *x = c->spoofed;
    for (size_t k = 0; x != NULL && k < x->sky.n_antennas; k++) {
        if (!orr_interval_holds(x->item[k].sends, list->as_of)) continue;
        channel_list *told = &work->spoofed->antenna[k].begin;
        channels_evaluate(&x->sky, k, work->spoofed, list->t, list->as_of, &x->sky.antenna[k].fixed, signals,
                          also, told);
        for (size_t j = 0; j < told->n; j++) {
            if (x->item[k].has_sats && !orr_sat_set_has(&x->item[k].sats, told->channel[j].sat)) continue;
            list->channel[list->n] = told->channel[j];
            list->channel[list->n].echo = (uint16_t)(ORR_CHANNEL_SPOOFED * (k + 1));
            list->place[list->n] = told->place[j];
            list->seen[list->n] = told->seen[j];
            list->start[list->n] = told->start[j];
            send(&x->item[k], at, list->t, list, list->n++);
        }
    }
}

void channels_receive(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                      orr_time as_of, const orr_antenna_state *at, uint64_t signals, const bool *also,
                      channel_list *list)
{
    channels_evaluate(c, antenna, work, t, as_of, at, signals, also, list);
    if (c->spoofed != NULL) add_false(c, work, at, signals, also, list);
}

orr_answer orr_channels_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                           uint64_t signals, orr_channel *out, size_t *n)
{
    orr_antenna_state at;
    *n = 0;
    if (antenna >= orr_channels_antennas(c)) return ORR_ANSWER_NOT_SERVED;
    if (!orr_span_holds(c->span, t)) return ORR_ANSWER_OUTSIDE_SPAN;
    const orr_answer answer = orr_antenna_at(&c->antenna[antenna], t, &at);
    if (answer != ORR_ANSWER_OK) return answer;
    channel_list list = work->antenna[antenna].begin; // its places; the channels go where they are wanted
    list.channel = out;
    channels_receive(c, antenna, work, t, t, &at, signals, NULL, &list);
    *n = list.n;
    return ORR_ANSWER_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// One satellite's sets: window by window the orbit and the clock fitted, and what else a record holds.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/astro.h"
#include "orbit/navdata/navfit_private.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/spacecraft/attitude.h"
#include "orbit/spacecraft/signal_delay.h"

#define LEAST_WINDOW 3 // a third of the window has to have an orbit
// Caesium clocks stay within 2 ns of a line for four hours; a reset is microseconds.
#define CLOCK_LIMIT_S 1e-8

// "Bad data, satellite temporarily out" (IS-GPS-200N 20.3.3.3.1.4 and table 20-VIII).
#define LNAV_OUT 0x3cu
// The user range accuracy that every set is given, m: LNAV's index 0, GLONASS' F_T = 1.
#define LNAV_ACCURACY_M 2.0
#define GLONASS_F_T 1
// What the fit interval flag 0 stands for.
#define LNAV_FIT_INTERVAL_H 4

// The arc that serves a slot: that of the instant nearest to the slot's middle where there is an orbit.
static bool find_arc(const orr_ephemeris *e, orr_sat sat, const navset_slot *slot, orr_time *from,
                     orr_time *to)
{
    static const int eighths[] = {4, 3, 5, 2, 6, 1, 7, 0, 8};
    const int64_t length = slot->to - slot->from - 1; // slot->to is the next slot's
    for (size_t k = 0; k < sizeof eighths / sizeof eighths[0]; k++) {
        orr_sat_state s;
        orr_time t = slot->from + length * eighths[k] / 8;
        if (orr_ephemeris_eval(e, sat, t, &s) != ORR_OK) continue;
        *from = s.valid_from;
        *to = s.valid_to;
        return true;
    }
    return false;
}

static bool has_orbit(const orr_ephemeris *e, orr_sat sat, orr_time t)
{
    orr_sat_state s;
    return orr_ephemeris_eval(e, sat, t, &s) == ORR_OK;
}

// The window moved into the arc where it sticks out; cut where the arc is shorter.
static bool fit_window(const navset_slot *slot, orr_time arc_from, orr_time arc_to, orr_time *from,
                       orr_time *to)
{
    const int64_t length = slot->window_to - slot->window_from;
    *from = slot->window_from;
    *to = slot->window_to;
    if (*to > arc_to) *to = arc_to, *from = arc_to - length;
    if (*from < arc_from) *from = arc_from, *to = arc_from + length;
    if (*to > arc_to) *to = arc_to;
    return *to - *from >= length / LEAST_WINDOW;
}

static bool has_manoeuvre(const orr_ephemeris *e, orr_sat sat, orr_time from, orr_time to)
{
    const orr_orbit_event *list;
    size_t n = orr_ephemeris_events(e, sat, &list);
    for (size_t i = 0; i < n; i++)
        if (list[i].kind == ORR_EVENT_MANOEUVRE && list[i].t1 >= from && list[i].t0 < to) return true;
    return false;
}

// The first clock node after t; ORR_TIME_NONE if there is none.
static orr_time next_clock(const orr_ephemeris *e, orr_sat sat, orr_time t)
{
    const orr_clock_node *list;
    size_t low = 0, n = orr_ephemeris_clocks(e, sat, &list), high = n;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (list[mid].t <= t)
            low = mid + 1;
        else
            high = mid;
    }
    return low < n ? list[low].t : ORR_TIME_NONE;
}

// Whether the clock jumps between two nodes that have a part of from..to between them. There the product has
// none, and it has it again at the node that tells of the event. Behind `to` the search goes from node to
// node: a satellite without a clock would have every set look through the rest of the product.
static bool clock_jumps(const orr_ephemeris *e, orr_sat sat, orr_time from, orr_time to)
{
    const int64_t step = 60 * ORR_NS_PER_S;
    bool lost = false;
    orr_sat_state s;
    orr_time t = from;
    while ((t < to || lost) && orr_ephemeris_eval(e, sat, t, &s) == ORR_OK) {
        const bool valid = (s.flags & ORR_EPH_CLOCK_VALID) != 0;
        if (lost && valid && (s.flags & ORR_EPH_CLOCK_EVENT) != 0) return true;
        lost = !valid;
        t = lost && t + step >= to ? next_clock(e, sat, t) : t + step;
    }
    return false;
}

// The product's satellite in one of its arcs: at a joint of files the next one is metres away.
typedef struct arc_source {
    orr_navfit_product product;
    orr_time from;
} arc_source;

static orr_status from_arc(void *user, orr_time t, orr_vec3 *pos_m)
{
    arc_source *a = user;
    orr_sat_state s;
    const orr_status status = orr_ephemeris_eval(a->product.ephemeris, a->product.sat, t, &s);
    if (status != ORR_OK) return status;
    return s.valid_from == a->from ? orr_navfit_from_product(&a->product, t, pos_m) : ORR_E_NODATA;
}

static orr_status fit_orbit(const orr_ephemeris *e, const orr_navset_options *o, orr_sat sat,
                            const navset_slot *slot, orr_time arc_from, orr_time from, orr_time to,
                            orr_navset_item *item, orr_diag *diag)
{
    arc_source source = {.product = {.ephemeris = e, .sat = sat}, .from = arc_from};
    if (o->antex != NULL &&
        orr_antenna_offset_of_sat(o->antex, sat, slot->reference, source.product.offset_m) != ORR_OK)
        item->notes |= ORR_NAVSET_NO_ANTENNA;
    if (orr_sat_system(sat) == 'R')
        return orr_navfit_glonass(sat, slot->reference, from, to, from_arc, &source, &item->eph,
                                  &item->report, diag);
    return orr_navfit_lnav(sat, slot->reference, from, to, LNAV_FIT_INTERVAL_H, from_arc, &source, &item->eph,
                           &item->report, diag);
}

static void fill_lnav(orr_nav_eph *eph, const navset_slot *slot, bool out)
{
    eph->iodc = slot->iodc;
    eph->iode = slot->iodc & 0xff;
    eph->health = out ? LNAV_OUT : 0;
    eph->accuracy_m = LNAV_ACCURACY_M;
    eph->data_sources = 1; // P code on L2
    eph->l2p_flag = 0;
    eph->delay = (orr_nav_delays){.tgd_s = 0};
}

// RINEX 3.05, table A10: M (bits 7-8) GLONASS-M, P2 (bit 4) odd t_b, P1 (bits 2-3) 30 minutes; health flags:
// the almanac tells health (bit 1) and finds it good (bit 2), l of string 3 (bit 0).
enum { STATUS_M = 1u << 7, STATUS_P3 = 1u << 5, STATUS_P2 = 1u << 4, STATUS_30_MIN = 1u << 2 };
enum { HEALTH_L = 1u << 0, HEALTH_TOLD = 1u << 1, HEALTH_ALMANAC = 1u << 2 };

static void fill_glonass(orr_nav_eph *eph, const navset_slot *slot, const orr_leap_table *leap, int channel,
                         bool out)
{
    int32_t mjd;
    double fraction;
    orr_time_mjd(slot->from, ORR_SCALE_UTC, leap, &mjd, &fraction);
    eph->health = out;
    eph->accuracy_m = (double)NAN;
    orr_nav_glonass *g = &eph->glonass;
    g->freq_channel = channel;
    g->age_days = 0;
    g->frame_time_s = round(((mjd + 3) % 7 + fraction) * 86400); // MJD 4 was a Sunday
    g->delta_tau_s = 0;
    g->ura = GLONASS_F_T;
    g->has_flags = true;
    g->status_flags = STATUS_M | STATUS_P3 | STATUS_P2 | STATUS_30_MIN;
    g->health_flags = HEALTH_TOLD | (out ? HEALTH_L : HEALTH_ALMANAC);
}

static bool round_to(const orr_navfit_field *f, double value, double *out)
{
    return orr_navfit_to_field(f, round(value / f->lsb), out, NULL) == ORR_OK;
}

// Group delays, and for GLONASS the clock of L1, which its message is of.
static void add_delays(const orr_bias_set *bias, orr_navset_item *item)
{
    // TGD's field could hold one value more, at its negative end.
    static const orr_navfit_field field_tgd = {"TGD", P2(31), 8, ORR_FIELD_MAGNITUDE},
                                  field_tau = {"-tau_n", P2(30), 22, ORR_FIELD_MAGNITUDE},
                                  field_delta_tau = {"delta tau_n", P2(30), 5, ORR_FIELD_MAGNITUDE};
    orr_nav_eph *eph = &item->eph;
    double tgd, shift, delta_tau, af0;
    bool fits;
    if (bias == NULL) return;
    if (orr_sat_system(eph->sat) == 'R') {
        fits = orr_signal_glonass(bias, eph->sat, eph->toe, &shift, &delta_tau) == ORR_OK &&
               round_to(&field_delta_tau, delta_tau, &delta_tau) &&
               round_to(&field_tau, eph->af0_s + shift, &af0);
        if (fits) {
            eph->af0_s = af0;
            eph->glonass.delta_tau_s = delta_tau;
        }
    } else {
        fits = orr_signal_tgd(bias, eph->sat, eph->toe, &tgd) == ORR_OK && round_to(&field_tgd, tgd, &tgd);
        if (fits) eph->delay.tgd_s = tgd;
    }
    if (!fits) item->notes |= ORR_NAVSET_NO_DELAY;
}

// The set of one slot; ORR_E_NODATA where there is nothing to send.
static orr_status fit_slot(const orr_ephemeris *e, const orr_navset_options *o, const navset_slot *slot,
                           int channel, navset_satellite *sat, orr_diag *diag)
{
    orr_navset_item item = {.from = slot->from, .to = slot->to, .clock_rms_s = (double)NAN};
    orr_time arc_from, arc_to, from, to, begin, end;
    orr_ephemeris_span(e, &begin, &end);
    if (!find_arc(e, sat->sat, slot, &arc_from, &arc_to)) return ORR_E_NODATA;
    if (item.from < begin) item.from = begin;
    if (item.to > end) item.to = end + 1; // the product's last instant belongs to it
    if (!has_orbit(e, sat->sat, item.from)) item.from = arc_from;
    if (!has_orbit(e, sat->sat, item.to - 1)) item.to = arc_to + 1;
    if (!fit_window(slot, arc_from, arc_to, &from, &to)) {
        sat->not_fitted++;
        orr_diag_set(diag, ORR_E_NODATA, "the orbit is shorter than a third of the window");
        return ORR_E_NODATA;
    }
    if (from != slot->window_from || to != slot->window_to) item.notes |= ORR_NAVSET_SHIFTED;
    orr_status s = fit_orbit(e, o, sat->sat, slot, arc_from, from, to, &item, diag);
    if (s != ORR_OK) {
        sat->not_fitted++;
        return s;
    }
    s = orr_navfit_clock(e, sat->sat, slot->reference, from, to, &item.eph, &item.clock_rms_s, diag);
    if (s == ORR_E_RANGE) {
        sat->not_fitted++;
        return s;
    }
    if (s != ORR_OK) {
        *diag = (orr_diag){0};
        if (!o->zero_clocks) {
            sat->no_clock++;
            return ORR_E_NODATA;
        }
        item.eph.af0_s = item.eph.af1_sps = item.eph.af2_sps2 = 0;
        item.clock_rms_s = (double)NAN;
        item.notes |= ORR_NAVSET_NO_CLOCK;
    }
    const bool parted = item.from < arc_from || item.to > arc_to + 1; // another arc is on the air too
    if (from > item.from) from = item.from; // what the set stands for: its window, and while it is sent
    if (to < item.to) to = item.to;
    const bool has_clock = (item.notes & ORR_NAVSET_NO_CLOCK) == 0;
    if (has_clock && (item.clock_rms_s > CLOCK_LIMIT_S || clock_jumps(e, sat->sat, from, to)))
        item.notes |= ORR_NAVSET_CLOCK_JUMP;
    if (parted || has_manoeuvre(e, sat->sat, from, to)) item.notes |= ORR_NAVSET_MANOEUVRE;
    const bool out = (item.notes & (ORR_NAVSET_MANOEUVRE | ORR_NAVSET_CLOCK_JUMP)) != 0;
    item.eph.transmission = item.from;
    if (orr_sat_system(sat->sat) == 'R')
        fill_glonass(&item.eph, slot, o->leap, channel, out);
    else
        fill_lnav(&item.eph, slot, out);
    add_delays(o->bias, &item);
    sat->item[sat->n++] = item;
    return ORR_OK;
}

void navset_fit_satellite(const orr_ephemeris *e, const orr_navset_options *o,
                          const navset_schedule *schedule, navset_satellite *out)
{
    out->item = calloc(schedule->n + 1, sizeof *out->item);
    if (out->item == NULL) {
        out->status = ORR_E_MEMORY;
        return;
    }
    for (size_t k = 0; k < schedule->n; k++) {
        orr_diag diag = {0};
        int channel = 0;
        bool nominal = false;
        if (o->cancel != NULL && *o->cancel) {
            out->status = ORR_E_INTERRUPTED;
            return;
        }
        if (orr_sat_system(out->sat) == 'R' &&
            !orr_glonass_channel(o->nav, out->sat, schedule->slot[k].reference, &channel, &nominal)) {
            out->not_fitted++;
            snprintf(out->why, sizeof out->why,
                     "its frequency channel is not known (a navigation file tells it)");
            continue;
        }
        orr_status s = fit_slot(e, o, &schedule->slot[k], channel, out, &diag);
        if (s == ORR_OK) {
            if (nominal) out->item[out->n - 1].notes |= ORR_NAVSET_NOMINAL_CHANNEL;
        } else if (diag.text[0] != '\0')
            snprintf(out->why, sizeof out->why, "%.159s", diag.text);
    }
}

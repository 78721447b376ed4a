// SPDX-License-Identifier: GPL-3.0-or-later
// One satellite's sets: window by window the orbit and the clock fitted, and what else a record holds.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/astro.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/kepler_lattice.h"
#include "orbit/navdata/navfit_private.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/navdata/system_week.h"
#include "orbit/spacecraft/attitude.h"

#define LEAST_WINDOW 3 // a third of the window has to have an orbit
// Caesium clocks stay within 2 ns of a line for four hours; a reset is microseconds.
#define CLOCK_LIMIT_S 1e-8

// "Bad data, satellite temporarily out" (IS-GPS-200N 20.3.3.3.1.4 and table 20-VIII).
#define LNAV_OUT 0x3cu
// The user range accuracy that every set is given, m: LNAV's index 0, GLONASS' F_T = 1.
#define ACCURACY_M 2.0
#define GLONASS_F_T 1
// What the fit interval flag 0 stands for.
#define LNAV_FIT_INTERVAL_H 4
#define QZSS_FIT_INTERVAL_H 2
// All of QZSS' six bits of health.
#define QZSS_OUT 0x3fu
#define SBAS_OUT 7u // ranging, precise and basic corrections are off (RTCA DO-229E A.4.4.12)
// NavIC's flags of L5 and S.
#define NAVIC_OUT 3u

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
    orr_vec3 displaced_m; // by a fault: radial, along-track, cross-track
} arc_source;

static orr_status from_arc(void *user, orr_time t, orr_vec3 *pos_m)
{
    arc_source *a = user;
    orr_sat_state s;
    const orr_status status = orr_ephemeris_eval(a->product.ephemeris, a->product.sat, t, &s);
    if (status != ORR_OK) return status;
    if (s.valid_from != a->from) return ORR_E_NODATA;
    const orr_status there = orr_navfit_from_product(&a->product, t, pos_m);
    const orr_mat3 axes = orr_orbit_axes(s.pos_m, orr_velocity_inertial(s.pos_m, s.vel_mps));
    if (there == ORR_OK) *pos_m = orr_vec3_add(*pos_m, orr_mat3_apply(&axes, a->displaced_m));
    return there;
}

static orr_status fit_orbit(const orr_ephemeris *e, const orr_navset_options *o, orr_sat sat, uint8_t message,
                            const navset_slot *slot, orr_time arc_from, orr_time from, orr_time to,
                            orr_navset_item *item, orr_diag *diag)
{
    arc_source source = {
        .product = {.ephemeris = e, .sat = sat}, .from = arc_from, .displaced_m = slot->displaced_m};
    if (o->antex != NULL &&
        orr_antenna_offset_of_sat(o->antex, sat, slot->reference, source.product.offset_m) != ORR_OK)
        item->notes |= ORR_NAVSET_NO_ANTENNA;
    if (message == ORR_NAV_FDMA) {
        source.displaced_m = (orr_vec3){0, 0, 0};
        const orr_status s = orr_navfit_glonass(sat, slot->reference, from, to, from_arc, &source, &item->eph,
                                                &item->report, diag);
        if (s == ORR_OK) orr_navfit_glonass_displace(&item->eph, slot->displaced_m);
        return s;
    }
    if (message == ORR_NAV_SBAS)
        return orr_navfit_geo(sat, slot->reference, from, to, from_arc, &source, &item->eph, &item->report,
                              diag);
    return orr_navfit_kepler(sat, message, slot->reference, from, to, from_arc, &source, &item->eph,
                             &item->report, diag);
}

// The set of another message of the same lattice and rhythm has the same orbit (F/NAV that of I/NAV).
static const orr_navset_item *twin_of(const navset_satellite *sat, const navset_series *series,
                                      const navset_slot *slot, orr_time from)
{
    const orr_kepler_lattice *l = orr_kepler_lattice_of(sat->sat, series->message);
    for (const navset_series *s = sat->series; l != NULL && s < series; s++) {
        if (orr_kepler_lattice_of(sat->sat, s->message) != l) continue;
        for (size_t k = 0; k < s->n; k++)
            if (s->item[k].eph.toe == slot->reference && s->item[k].from == from) return &s->item[k];
    }
    return NULL;
}

static void take_orbit(const orr_navset_item *twin, uint8_t message, orr_navset_item *item)
{
    item->eph = twin->eph;
    item->eph.message = message;
    item->eph.af2_sps2 = 0;
    item->report = twin->report;
    item->notes |= twin->notes & ORR_NAVSET_NO_ANTENNA;
}

// BeiDou's age of data, 0 to 24 of a set's first hours: it changes with every set, as receivers expect.
static int32_t age_of(int64_t n) { return (int32_t)orr_floor_mod(n, 24) + 1; }

// Galileo's data sources as RINEX 3.05 writes them: I/NAV of E1-B and E5b-I with the clock of E5b/E1; F/NAV of E5a-I with that
// of E5a/E1.
enum { SOURCE_INAV = 1u << 0 | 1u << 2 | 1u << 9, SOURCE_FNAV = 1u << 1 | 1u << 8 };
enum { GALILEO_OUT = 1u << 1 | 1u << 4 | 1u << 7 }; // status 1, out of service, of E1-B, E5a and E5b

// What prediction and accuracy fields of CNAV and its kin tell: 0 is the index of URA_ED below 2.4 m, and of BeiDou's likewise.
static void fill_modern(orr_nav_eph *eph, const navset_slot *slot)
{
    eph->kepler.top_sow_s = (double)(orr_nav_seconds_of_week(eph->sat, slot->from, NULL) / ORR_NS_PER_S);
    if (orr_sat_system(eph->sat) != 'C') {
        eph->ura_ed = eph->ura_ned[0] = eph->ura_ned[1] = eph->ura_ned[2] = 0;
        return;
    }
    eph->sisai_oe = eph->sisai_ocb = eph->sisai_oc1 = eph->sisai_oc2 = eph->sismai = eph->integrity_flags = 0;
    eph->sat_type = orr_modern_orbit_type(eph->sat);
}

// Of B-CNAV: IODE is IODC's lower eight bits and 0 to 59, as data no older than 12 hours have it (BDS-SIS-ICD-B1C 1.0, 7.4).
static int32_t young_issue(int64_t n) { return (int32_t)orr_floor_mod(n, 60); }

// GPS, QZSS and NavIC.
static void fill_lnav(orr_nav_eph *eph, int64_t n, bool out)
{
    // IODC = IODE, 0 to 239, as a fit interval of four hours demands (IS-GPS-200N table 20-XII). IODC's upper two bits stay 0,
    // though the message may count with them: receivers that compare all ten bits with IODE keep no set in which they differ
    // (gnss-sdr 0.0.17). No value returns within 10 days; 20.3.3.3.1.5 and 20.3.4.4 ask for 7 days of IODC and 6 hours of IODE.
    eph->iode = eph->iodc = (int32_t)orr_floor_mod(n, 240);
    switch (orr_sat_system(eph->sat)) {
    case 'I':
        eph->iodc = ORR_NAV_NO_IOD;
        eph->health = out ? NAVIC_OUT : 0;
        return;
    case 'J':
        eph->health = out ? QZSS_OUT : 0;
        eph->fit_interval_h = QZSS_FIT_INTERVAL_H;
        eph->data_sources = 2; // L2C, and no P code (IS-QZSS-PNT-005, 4.1.2.3)
        eph->l2p_flag = 1;
        return;
    default:
        eph->health = out ? LNAV_OUT : 0;
        eph->fit_interval_h = LNAV_FIT_INTERVAL_H;
        eph->data_sources = 1; // P code on L2
        eph->l2p_flag = 0;
        return;
    }
}

static void fill_kepler(orr_nav_eph *eph, const navset_slot *slot, bool out)
{
    const int64_t n = slot->number;
    eph->accuracy_m = ACCURACY_M;
    eph->health = out;
    switch (eph->message) {
    case ORR_NAV_INAV:
    case ORR_NAV_FNAV:
        eph->iode = (int32_t)orr_floor_mod(n, 1024);
        eph->data_sources = eph->message == ORR_NAV_INAV ? SOURCE_INAV : SOURCE_FNAV;
        eph->health = out ? GALILEO_OUT : 0;
        return;
    case ORR_NAV_D1:
    case ORR_NAV_D2:
        eph->iode = eph->iodc = age_of(n);
        return;
    case ORR_NAV_CNAV: // toe and top tell sets apart
        fill_modern(eph, slot);
        eph->health = out ? 7 : 0;
        return;
    case ORR_NAV_CNV1:
    case ORR_NAV_CNV2:
    case ORR_NAV_CNV3:
        fill_modern(eph, slot);
        if (orr_sat_system(eph->sat) == 'C' && eph->message != ORR_NAV_CNV3)
            eph->iode = eph->iodc = young_issue(n);
        return;
    case ORR_NAV_SBAS:
        eph->geo.ura_m = ACCURACY_M;
        eph->health = out ? SBAS_OUT : 0;
        return;
    case ORR_NAV_LNAV:
        fill_lnav(eph, n, out);
        return;
    default:
        return;
    }
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
    g->ura = GLONASS_F_T;
    g->has_flags = true;
    g->status_flags = STATUS_M | STATUS_P3 | STATUS_P2 | STATUS_30_MIN;
    g->health_flags = HEALTH_TOLD | (out ? HEALTH_L : HEALTH_ALMANAC);
}

// What the set stands for is its window, and while it is sent; whether that is sent as unhealthy.
static bool judge_healthy(const orr_ephemeris *e, orr_sat sat, orr_time arc_from, orr_time arc_to,
                          orr_time from, orr_time to, orr_navset_item *item)
{
    const bool parted = item->from < arc_from || item->to > arc_to + 1; // another arc is on the air too
    if (from > item->from) from = item->from;
    if (to < item->to) to = item->to;
    const bool has_clock = (item->notes & ORR_NAVSET_NO_CLOCK) == 0;
    if (has_clock && (item->clock_rms_s > CLOCK_LIMIT_S || clock_jumps(e, sat, from, to)))
        item->notes |= ORR_NAVSET_CLOCK_JUMP;
    if (parted || has_manoeuvre(e, sat, from, to)) item->notes |= ORR_NAVSET_MANOEUVRE;
    return (item->notes & (ORR_NAVSET_MANOEUVRE | ORR_NAVSET_CLOCK_JUMP)) == 0;
}

// The set of one slot; ORR_E_NODATA where there is nothing to send.
static orr_status fit_slot(const orr_ephemeris *e, const orr_navset_options *o, const navset_slot *slot,
                           int channel, navset_satellite *sat, navset_series *series, orr_diag *diag)
{
    orr_navset_item item = {.from = slot->from,
                            .to = slot->to,
                            .clock_rms_s = (double)NAN,
                            .notes = slot->faulty ? ORR_NAVSET_FAULTY : 0u};
    orr_time arc_from, arc_to, from, to, begin, end;
    orr_ephemeris_span(e, &begin, &end);
    if (!find_arc(e, sat->sat, slot, &arc_from, &arc_to)) return ORR_E_NODATA;
    if (item.from < begin) item.from = begin;
    if (item.to > end) item.to = end + 1; // the product's last instant belongs to it
    if (!has_orbit(e, sat->sat, item.from)) item.from = arc_from;
    if (!has_orbit(e, sat->sat, item.to - 1)) item.to = arc_to + 1;
    if (!fit_window(slot, arc_from, arc_to, &from, &to)) {
        series->not_fitted++;
        orr_diag_set(diag, ORR_E_NODATA, "the orbit is shorter than a third of the window");
        return ORR_E_NODATA;
    }
    if (from != slot->window_from || to != slot->window_to) item.notes |= ORR_NAVSET_SHIFTED;
    const orr_navset_item *twin = twin_of(sat, series, slot, item.from);
    orr_status s = ORR_OK;
    if (twin != NULL)
        take_orbit(twin, series->message, &item);
    else
        s = fit_orbit(e, o, sat->sat, series->message, slot, arc_from, from, to, &item, diag);
    if (s != ORR_OK) {
        series->not_fitted++;
        return s;
    }
    const double shift = navset_delays(o->bias, &item);
    s = orr_navfit_clock(e, sat->sat, slot->reference, from, to, shift, &item.eph, &item.clock_rms_s, diag);
    if (s == ORR_E_RANGE) {
        series->not_fitted++;
        return s;
    }
    if (s != ORR_OK) {
        *diag = (orr_diag){0};
        if (!o->zero_clocks) {
            series->no_clock++;
            return ORR_E_NODATA;
        }
        item.eph.af0_s = item.eph.af1_sps = item.eph.af2_sps2 = 0;
        item.clock_rms_s = (double)NAN;
        item.notes |= ORR_NAVSET_NO_CLOCK;
    }
    const bool marked = slot->unhealthy || (o->unhealthy != NULL && orr_sat_set_has(o->unhealthy, sat->sat));
    const bool out = !judge_healthy(e, sat->sat, arc_from, arc_to, from, to, &item) || marked;
    item.eph.transmission = item.from;
    if (series->message == ORR_NAV_FDMA)
        fill_glonass(&item.eph, slot, o->leap, channel, out);
    else
        fill_kepler(&item.eph, slot, out);
    series->item[series->n++] = item;
    return ORR_OK;
}

static void fit_series(const orr_ephemeris *e, const orr_navset_options *o, const navset_schedule *schedule,
                       navset_satellite *sat, navset_series *series)
{
    series->item = calloc(schedule->n + 1, sizeof *series->item);
    if (series->item == NULL) {
        sat->status = ORR_E_MEMORY;
        return;
    }
    for (size_t k = 0; k < schedule->n; k++) {
        orr_diag diag = {0};
        int channel = 0;
        bool nominal = false;
        if (o->cancel != NULL && *o->cancel) {
            sat->status = ORR_E_INTERRUPTED;
            return;
        }
        if (series->message == ORR_NAV_FDMA &&
            !orr_glonass_channel(o->nav, sat->sat, schedule->slot[k].reference, &channel, &nominal)) {
            series->not_fitted++;
            snprintf(series->why, sizeof series->why,
                     "its frequency channel is not known (a navigation file tells it)");
            continue;
        }
        orr_status s = fit_slot(e, o, &schedule->slot[k], channel, sat, series, &diag);
        if (s == ORR_OK) {
            if (nominal) series->item[series->n - 1].notes |= ORR_NAVSET_NOMINAL_CHANNEL;
        } else if (diag.text[0] != '\0')
            snprintf(series->why, sizeof series->why, "%.159s", diag.text);
    }
}

// E14 and E18, in orbits that missed their height: a window of two hours leaves 0.17 m there, one of one hour 0.009.
#define ECCENTRIC 0.1
static bool is_eccentric(const orr_ephemeris *e, orr_sat sat, orr_time from, orr_time to)
{
    for (int k = 1; k < 8; k++) {
        orr_sat_state s;
        orr_kepler el;
        if (orr_ephemeris_eval(e, sat, from + (to - from) / 8 * k, &s) != ORR_OK) continue;
        return orr_kepler_from_state(s.pos_m, orr_velocity_inertial(s.pos_m, s.vel_mps), ORR_GPS_GM, &el) ==
                   ORR_OK &&
               el.e > ECCENTRIC;
    }
    return false;
}

void navset_fit_satellite(const orr_ephemeris *e, const orr_navset_options *o, navset_satellite *out)
{
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    const bool brief = is_eccentric(e, out->sat, from, to);
    for (size_t k = 0; k < out->n && out->status == ORR_OK; k++) {
        navset_schedule schedule;
        out->status = navset_schedule_of(out->sat, out->series[k].message, from, to, o, brief, &schedule);
        if (out->status == ORR_OK) out->status = navset_fault_slots(out->sat, o, &schedule);
        if (out->status == ORR_OK) fit_series(e, o, &schedule, out, &out->series[k]);
        free(schedule.slot);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/gravimetry/gravimetry.h"
#include "inertial/sense/sensors.h"
#include "ingest/tables/erp.h"
#include "src/make/nav_source.h"
#include "src/make/orbit_source.h"
#include "src/scenario/iono_source.h"

struct orr_engine {
    orr_ephemeris *eph;
    orr_eop_series eop; // what the orbits were smoothed with; n 0: IERS' secular pole
    orr_navset *navset; // NULL: none, and why
    char no_navdata[ORR_NAV_SOURCE_WHY];
    orr_iono_source *iono; // NULL: none
    orr_moving moving;     // n_units 0: none
    bool has_place;        // receiver.position
    orr_vec3 place_m;
    size_t receiver_unit; // without it: whose point the receiver is
    char title[128];
    orr_time from, to;
    const orr_sat *sat; // borrowed from eph
    size_t n_sats;
};

orr_status orr_engine_from_ephemeris(orr_ephemeris *eph, const char *title, orr_engine **out, orr_diag *diag)
{
    orr_engine *e = calloc(1, sizeof *e);
    if (e == NULL) {
        orr_ephemeris_free(eph);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    e->eph = eph;
    snprintf(e->title, sizeof e->title, "%s", title);
    snprintf(e->no_navdata, sizeof e->no_navdata, "no broadcast data were made");
    orr_ephemeris_span(eph, &e->from, &e->to);
    e->n_sats = orr_ephemeris_satellites(eph, &e->sat);
    *out = e;
    return ORR_OK;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

orr_status orr_engine_open(const orr_scenario *s, const orr_log *log, const volatile int *cancel,
                           orr_warnings *warnings, orr_engine **out, orr_diag *diag)
{
    orr_ephemeris *eph;
    orr_eop_series eop = {0};
    const char *title = s->title;
    orr_status status;
    if (s->orbit.product == NULL && s->orbit.sp3.n == 0)
        return orr_diag_set(
            diag, ORR_E_NODATA,
            "the scenario has a trajectory but no satellites to serve: name an orbit.product or "
            "orbit.sp3 ('orrery imu' does without)");
    if (s->orbit.product != NULL) {
        status = orr_ephemeris_load(s->orbit.product, &eph, diag);
        if (title == NULL) title = base_name(s->orbit.product);
    } else {
        status = orr_orbit_source_smooth(&s->orbit, log, cancel, warnings, &eph, &eop, diag);
        if (title == NULL) title = base_name(s->orbit.sp3.item[0]);
    }
    if (status == ORR_OK) status = orr_engine_from_ephemeris(eph, title, out, diag);
    if (status != ORR_OK) {
        orr_erp_series_free(&eop);
        return status;
    }
    (*out)->eop = eop;
    status = orr_nav_source_build(s, (*out)->eph, log, cancel, warnings, &(*out)->navset, (*out)->no_navdata,
                                  diag);
    if (status == ORR_OK) status = orr_iono_source_open(s, &(*out)->iono, warnings, diag);
    if (status == ORR_OK && s->motion.kind != ORR_MOTION_NONE)
        status = orr_moving_open(&s->motion, (*out)->from, warnings, &(*out)->moving, diag);
    (*out)->receiver_unit = (size_t)s->receiver_unit;
    (*out)->has_place = s->receiver.n == 3;
    if ((*out)->has_place) {
        const double *p = s->receiver.item;
        (*out)->place_m =
            orr_earth_to_ecef((orr_geodetic){p[0] * ORR_RAD_PER_DEG, p[1] * ORR_RAD_PER_DEG, p[2]});
    }
    if (status != ORR_OK) {
        orr_engine_close(*out);
        *out = NULL;
    }
    return status;
}

void orr_engine_close(orr_engine *e)
{
    if (e == NULL) return;
    orr_ephemeris_free(e->eph);
    orr_navset_free(e->navset);
    orr_erp_series_free(&e->eop);
    orr_iono_source_close(e->iono);
    if (e->moving.n_units > 0) orr_moving_free(&e->moving);
    free(e);
}

const char *orr_engine_title(const orr_engine *e) { return e->title; }
const char *orr_engine_frame(const orr_engine *e) { return orr_ephemeris_frame(e->eph); }
void orr_engine_span(const orr_engine *e, orr_time *from, orr_time *to)
{
    *from = e->from;
    *to = e->to;
}
size_t orr_engine_satellites(const orr_engine *e, const orr_sat **list)
{
    *list = e->sat;
    return e->n_sats;
}

// Those that have an arc come without gaps from the front; each moves back to its satellite's place.
static void spread(const orr_engine *e, size_t found, orr_sat_state *state, orr_answer *answer)
{
    for (size_t i = e->n_sats; i-- > 0;) {
        if (found > 0 && state[found - 1].sat == e->sat[i]) {
            found--;
            if (found != i) state[i] = state[found];
            answer[i] = ORR_ANSWER_OK;
        } else {
            state[i].sat = e->sat[i];
            answer[i] = ORR_ANSWER_NO_ARC;
        }
    }
}

static bool is_served(const orr_engine *e, orr_sat sat)
{
    size_t low = 0, high = e->n_sats;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (e->sat[mid] < sat)
            low = mid + 1;
        else
            high = mid;
    }
    return low < e->n_sats && e->sat[low] == sat;
}

orr_answer orr_engine_states(const orr_engine *e, orr_time t, const orr_sat *sats, size_t n,
                             orr_sat_state *state, orr_answer *answer)
{
    if (t < e->from || t > e->to) return ORR_ANSWER_OUTSIDE_SPAN;
    if (sats == NULL) {
        spread(e, orr_ephemeris_eval_all(e->eph, t, state, n), state, answer);
        return ORR_ANSWER_OK;
    }
    for (size_t i = 0; i < n; i++) {
        state[i].sat = sats[i];
        if (orr_ephemeris_eval(e->eph, sats[i], t, &state[i]) == ORR_OK)
            answer[i] = ORR_ANSWER_OK;
        else
            answer[i] = is_served(e, sats[i]) ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NOT_SERVED;
    }
    return ORR_ANSWER_OK;
}

orr_answer orr_engine_elements(const orr_engine *e, orr_time t, orr_elements_frame frame,
                               orr_elements_method method, const orr_sat *sats, size_t n, orr_kepler *out,
                               uint32_t *flags, orr_answer *answer)
{
    if (t < e->from || t > e->to) return ORR_ANSWER_OUTSIDE_SPAN;
    const orr_elements_options options = {
        .frame = frame, .method = method, .eop = e->eop.n > 0 ? &e->eop : NULL};
    orr_elements_axes axes;
    orr_elements_axes_at(t, &options, &axes);
    if (sats == NULL) sats = e->sat;
    for (size_t i = 0; i < n; i++) {
        orr_sat_state state;
        if (orr_ephemeris_eval(e->eph, sats[i], t, &state) != ORR_OK)
            answer[i] = is_served(e, sats[i]) ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NOT_SERVED;
        else if (orr_elements_of(e->eph, sats[i], &axes, &out[i]) != ORR_OK)
            answer[i] = ORR_ANSWER_NO_VALUE;
        else {
            answer[i] = ORR_ANSWER_OK;
            flags[i] = state.flags;
        }
    }
    return ORR_ANSWER_OK;
}

const char *orr_engine_no_navdata(const orr_engine *e) { return e->navset != NULL ? NULL : e->no_navdata; }

orr_answer orr_engine_navdata(const orr_engine *e, orr_time t, const orr_sat *sats, size_t n,
                              const orr_navset_item **set, orr_navframe *frame, orr_answer *answer)
{
    if (e->navset == NULL || t < e->from || t > e->to) return ORR_ANSWER_OUTSIDE_SPAN;
    if (sats == NULL) sats = e->sat;
    for (size_t i = 0; i < n; i++) {
        const orr_navset_item *list;
        set[i] = NULL;
        answer[i] = ORR_ANSWER_NOT_SERVED;
        if (orr_navset_items(e->navset, sats[i], &list) == 0) continue;
        const orr_navset_item *item = orr_navset_at(e->navset, sats[i], t);
        orr_status s = item == NULL ? ORR_E_NODATA : orr_navframe_at(e->navset, sats[i], t, &frame[i], NULL);
        if (s == ORR_OK) set[i] = item;
        answer[i] = s == ORR_OK ? ORR_ANSWER_OK : s == ORR_E_NODATA ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NO_VALUE;
    }
    return ORR_ANSWER_OK;
}

bool orr_engine_has_ionosphere(const orr_engine *e) { return e->iono != NULL; }

// Motion of a trajectory at t; false outside its span.
static bool motion_at(const orr_trajectory *tr, orr_time t, orr_motion *out)
{
    double t_s = orr_time_diff_s(t, tr->t0);
    if (!(t_s >= tr->begin_s - 1e-9 && t_s <= tr->end_s + 1e-9)) return false;
    tr->evaluate(tr->self, t_s, out);
    return true;
}

orr_answer orr_engine_receiver(const orr_engine *e, orr_time t, orr_vec3 *receiver_m)
{
    orr_motion motion;
    if (e->has_place) {
        *receiver_m = e->place_m;
        return ORR_ANSWER_OK;
    }
    if (e->moving.n_units > 0) {
        if (!motion_at(orr_moving_unit(&e->moving, e->receiver_unit), t, &motion))
            return ORR_ANSWER_OUTSIDE_SPAN;
        *receiver_m = motion.r_m;
        return ORR_ANSWER_OK;
    }
    return e->iono != NULL && orr_iono_source_station(e->iono, receiver_m) ? ORR_ANSWER_OK
                                                                           : ORR_ANSWER_NOT_SERVED;
}

orr_answer orr_engine_delays(const orr_engine *e, orr_time t, orr_vec3 receiver_m, const orr_sat *sats,
                             size_t n, orr_realisation *delay, orr_answer *answer)
{
    orr_sat sat[ORR_SESSION_MAX_SATS];
    orr_vec3 pos[ORR_SESSION_MAX_SATS];
    size_t place[ORR_SESSION_MAX_SATS], known = 0, got = 0;
    if (e->iono == NULL || t < e->from || t > e->to || n > ORR_SESSION_MAX_SATS)
        return ORR_ANSWER_OUTSIDE_SPAN;
    if (sats == NULL) sats = e->sat;
    for (size_t i = 0; i < n; i++) {
        orr_sat_state state;
        delay[i] = (orr_realisation){.sat = sats[i]};
        if (orr_ephemeris_eval(e->eph, sats[i], t, &state) != ORR_OK) {
            answer[i] = is_served(e, sats[i]) ? ORR_ANSWER_NO_ARC : ORR_ANSWER_NOT_SERVED;
            continue;
        }
        double az, el, range;
        orr_earth_look(receiver_m, state.pos_m, &az, &el, &range);
        if (!(el >= 0)) {
            answer[i] = ORR_ANSWER_BELOW_HORIZON;
            continue;
        }
        answer[i] = ORR_ANSWER_NO_VALUE; // until there is one
        delay[i].pierce.az_rad = az;
        delay[i].pierce.el_rad = el;
        sat[known] = sats[i];
        pos[known] = state.pos_m;
        place[known++] = i;
    }
    // Results come in the order asked, those without a value left out.
    orr_realisation found[ORR_SESSION_MAX_SATS];
    if (known > 0 &&
        orr_iono_source_realise(e->iono, t, receiver_m, sat, pos, known, found, &got, NULL) != ORR_OK)
        return ORR_ANSWER_OUTSIDE_SPAN;
    for (size_t k = 0, g = 0; k < known && g < got; k++)
        if (sat[k] == found[g].sat) {
            delay[place[k]] = found[g++];
            answer[place[k]] = ORR_ANSWER_OK;
        }
    return ORR_ANSWER_OK;
}

size_t orr_engine_units(const orr_engine *e) { return e->moving.n_units; }
double orr_engine_imu_rate(const orr_engine *e) { return e->moving.rate_hz; }
bool orr_engine_imu_physical(const orr_engine *e) { return e->moving.mode.approach == 2; }

orr_answer orr_engine_imu(const orr_engine *e, size_t unit, orr_time t0, orr_time t1, orr_vec3 *dtheta_rad,
                          orr_vec3 *dv_mps)
{
    const orr_trajectory *tr = orr_moving_unit(&e->moving, unit);
    double from_s = orr_time_diff_s(t0, tr->t0), to_s = orr_time_diff_s(t1, tr->t0);
    if (!(from_s >= tr->begin_s - 1e-9 && to_s <= tr->end_s + 1e-9)) return ORR_ANSWER_OUTSIDE_SPAN;
    orr_sensors_increment(tr, e->moving.gravity, e->moving.mode.quadrature, e->moving.mode.order, from_s,
                          to_s, dtheta_rad, dv_mps);
    return ORR_ANSWER_OK;
}

orr_answer orr_engine_truth(const orr_engine *e, size_t unit, orr_time t, orr_truth *out)
{
    const orr_trajectory *tr = orr_moving_unit(&e->moving, unit);
    if (!motion_at(tr, t, &out->motion)) return ORR_ANSWER_OUTSIDE_SPAN;
    double t_s = orr_time_diff_s(t, tr->t0);
    out->angles = orr_motion_angles(&out->motion);
    orr_sensors_instant(tr, e->moving.gravity, t_s, &out->rate_radps, &out->force_mps2);
    orr_gravity_terms(e->moving.gravity, &out->motion, &out->disturbance_mgal, &out->eotvos_mgal,
                      &out->vertical_mps2);
    return ORR_ANSWER_OK;
}

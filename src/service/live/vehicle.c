// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/vehicle.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "src/service/live/spread.h"

_Static_assert((int)ORR_COURSE_SYNCHRONOUS == ORR_MSG_MOTION_STATE_SYNCHRONOUS &&
                   (int)ORR_COURSE_INTERPOLATED == ORR_MSG_MOTION_STATE_INTERPOLATED &&
                   (int)ORR_COURSE_EXTRAPOLATED == ORR_MSG_MOTION_STATE_EXTRAPOLATED &&
                   (int)ORR_COURSE_JOINING == ORR_MSG_MOTION_STATE_JOINING &&
                   (int)ORR_COURSE_SNAPPED == ORR_MSG_MOTION_STATE_SNAPPED,
               "the course's states are the wire's");

static const int64_t FAR_AHEAD_NS = 60 * ORR_NS_PER_S;
static const double LEAST_RADIUS_M = 6.3e6, MOST_RADIUS_M = 5e7;
// What a body may be beside what was expected of it without a word: so far at once, and by so much acceleration since.
static const double JUMP_M = 100, JUMP_MPS2 = 50;

struct orr_vehicle {
    orr_vehicle_options options;
    pthread_mutex_t lock;
    orr_msg_motion_stats stats;
    orr_spread lateness, margin;
    bool has_next; // of a recording
    orr_msg_motion next;
    orr_time next_from;
    uint8_t state;   // of the latest block,
    orr_time latest; // and its begin
    orr_course course;
};

orr_status orr_vehicle_open(const orr_vehicle_options *options, orr_vehicle **out, orr_diag *diag)
{
    if (options->length_ns < ORR_NS_PER_S / 1000 || options->length_ns > ORR_NS_PER_S / 10 ||
        ORR_NS_PER_S % options->length_ns != 0)
        return orr_diag_set(diag, ORR_E_ARG,
                            "blocks of live motion are 1 to 100 ms long, whole parts of a second");
    if (!(options->join_s >= 0 && options->join_s <= 10))
        return orr_diag_set(diag, ORR_E_ARG, "live motion is rejoined within 0 to 10 s");
    orr_vehicle *v = calloc(1, sizeof *v);
    if (v == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    v->options = *options;
    pthread_mutex_init(&v->lock, NULL);
    v->latest = ORR_TIME_NONE;
    orr_course_init(&v->course, options->join_s);
    *out = v;
    return ORR_OK;
}

void orr_vehicle_close(orr_vehicle *v)
{
    if (v == NULL) return;
    pthread_mutex_destroy(&v->lock);
    free(v);
}

int64_t orr_vehicle_length_ns(const orr_vehicle *v) { return v->options.length_ns; }

static bool all_finite(const double *x, size_t n)
{
    bool finite = true;
    for (size_t k = 0; k < n; k++) finite = finite && isfinite(x[k]);
    return finite;
}

static orr_vec3 vec(const double x[3], bool given)
{
    return given ? (orr_vec3){x[0], x[1], x[2]} : (orr_vec3){0, 0, 0};
}

// What is wrong with a sample by itself; NULL: nothing.
static const char *fault_of(const orr_msg_motion *m)
{
    const double norm = m->attitude[0] * m->attitude[0] + m->attitude[1] * m->attitude[1] +
                        m->attitude[2] * m->attitude[2] + m->attitude[3] * m->attitude[3];
    if (m->order > 3 || m->angular_order > 4 || m->point > ORR_MSG_MOTION_POINT_ANTENNA || m->snap > 1)
        return "MOTION: an order, point or snap that there is not";
    if (!all_finite(m->pos_m, 3) || (m->order >= 1 && !all_finite(m->vel_mps, 3)) ||
        (m->order >= 2 && !all_finite(m->acc_mps2, 3)) || (m->order >= 3 && !all_finite(m->jerk_mps3, 3)) ||
        (m->angular_order >= 1 && !all_finite(m->attitude, 4)) ||
        (m->angular_order >= 2 && !all_finite(m->rate_radps, 3)) ||
        (m->angular_order >= 3 && !all_finite(m->rate2_radps2, 3)) ||
        (m->angular_order >= 4 && !all_finite(m->rate3_radps3, 3)))
        return "MOTION: a number that is none";
    if (m->angular_order >= 1 && !(norm > 0.99 && norm < 1.01))
        return "MOTION: the attitude is no unit quaternion";
    const double r = sqrt(m->pos_m[0] * m->pos_m[0] + m->pos_m[1] * m->pos_m[1] + m->pos_m[2] * m->pos_m[2]);
    if (!(r >= LEAST_RADIUS_M && r <= MOST_RADIUS_M))
        return "MOTION: the position is inside the Earth, or beyond 50000 km";
    return NULL;
}

static orr_course_sample sample_of(const orr_msg_motion *m)
{
    orr_course_sample s = {.t = m->t,
                           .order = m->order,
                           .angular_order = m->angular_order,
                           .antenna = m->point == ORR_MSG_MOTION_POINT_ANTENNA,
                           .snap = m->snap != 0,
                           .x = {vec(m->pos_m, true), vec(m->vel_mps, m->order >= 1),
                                 vec(m->acc_mps2, m->order >= 2), vec(m->jerk_mps3, m->order >= 3)},
                           .w = {vec(m->rate_radps, m->angular_order >= 2),
                                 vec(m->rate2_radps2, m->angular_order >= 3),
                                 vec(m->rate3_radps3, m->angular_order >= 4)}};
    if (m->angular_order >= 1)
        s.q = orr_quat_unit((orr_quat){m->attitude[0], m->attitude[1], m->attitude[2], m->attitude[3]});
    return s;
}

// What is wrong with it among the others.
static const char *misfit_of(const orr_vehicle *v, const orr_msg_motion *m, orr_time now)
{
    const orr_course *k = &v->course;
    if (now == ORR_TIME_NONE) return "MOTION: nothing is armed (CONTROL)";
    if (orr_time_sub_ns(m->t, now) > FAR_AHEAD_NS)
        return "MOTION: its tag lies more than a minute ahead of the scenario's clock";
    if (k->n == 0) return NULL;
    const orr_course_sample *last = &k->sample[(k->first + k->n - 1) % ORR_COURSE_SAMPLES];
    if (m->t <= last->t) return "MOTION: its tag is not later than that of the sample before";
    const double s = orr_time_diff_s(m->t, last->t);
    const orr_vec3 carried = orr_vec3_axpy(s, orr_vec3_axpy(s / 2, last->x[2], last->x[1]), last->x[0]);
    const double off = orr_vec3_norm(orr_vec3_sub(vec(m->pos_m, true), carried));
    if (m->snap == 0 && off > JUMP_M + JUMP_MPS2 * s * s + 2 * s * orr_vec3_norm(last->x[1]))
        return "MOTION: a jump that no body makes; send snap where it is meant";
    return NULL;
}

static uint16_t take(orr_vehicle *v, const orr_msg_motion *m, orr_time now, orr_server_refusal *why)
{
    orr_msg_motion_stats *c = &v->stats;
    c->received++;
    const char *bad = v->options.replay != NULL ? "MOTION: a recording is replayed" : fault_of(m);
    if (bad == NULL) bad = misfit_of(v, m, now);
    if (bad != NULL) {
        c->dropped++;
        snprintf(why->sentence, sizeof why->sentence, "%s", bad);
        return ORR_MSG_ERROR_CODE_BAD_REQUEST;
    }
    const orr_course_sample s = sample_of(m);
    const orr_time made = v->course.made;
    orr_course_add(&v->course, &s);
    const orr_course_sample *kept =
        &v->course.sample[(v->course.first + v->course.n - 1) % ORR_COURSE_SAMPLES];
    orr_spread_add(&v->lateness, orr_time_sub_ns(now, m->t));
    if (made != ORR_TIME_NONE) orr_spread_add(&v->margin, orr_time_sub_ns(m->t, made));
    if (made != ORR_TIME_NONE && m->t < made)
        c->late++;
    else
        c->early++;
    if (v->options.record != NULL) v->options.record(v->options.record_user, m, kept->from);
    return 0;
}

uint16_t orr_vehicle_take(orr_vehicle *v, const orr_msg_motion *m, orr_time now, orr_server_refusal *why)
{
    pthread_mutex_lock(&v->lock);
    const uint16_t code = take(v, m, now, why);
    pthread_mutex_unlock(&v->lock);
    return code;
}

orr_time orr_vehicle_reach(orr_vehicle *v)
{
    const orr_course *k = &v->course;
    pthread_mutex_lock(&v->lock);
    const orr_time t = k->n > 0 ? k->sample[(k->first + k->n - 1) % ORR_COURSE_SAMPLES].t : ORR_TIME_NONE;
    pthread_mutex_unlock(&v->lock);
    return t;
}

// Samples of the recording that blocks at t rest on.
static void replay_to(orr_vehicle *v, orr_time t)
{
    while (v->options.replay != NULL) {
        if (!v->has_next && !v->options.replay(v->options.replay_user, &v->next, &v->next_from)) {
            v->options.replay = NULL;
            return;
        }
        v->has_next = true;
        if (v->next_from > t) return;
        v->has_next = false;
        const orr_course_sample s = sample_of(&v->next);
        v->stats.received++;
        orr_course_add(&v->course, &s);
        v->course.sample[(v->course.first + v->course.n - 1) % ORR_COURSE_SAMPLES].from = v->next_from;
    }
}

bool orr_vehicle_block_at(orr_vehicle *v, orr_time t0, orr_time t1, orr_vehicle_block *out)
{
    bool same;
    orr_msg_motion_stats *c = &v->stats;
    pthread_mutex_lock(&v->lock);
    replay_to(v, t0);
    out->state = (uint8_t)orr_course_block(&v->course, t0, t1, &out->age_ns);
    const bool there = out->state != ORR_COURSE_NONE &&
                       orr_course_at(&v->course, t0, false, &out->begin, &out->antenna) &&
                       orr_course_at(&v->course, t1, true, &out->end, &same);
    if (there) {
        c->blocks++;
        if (t0 > v->latest) { // once for all antennas and streams
            v->latest = t0;
            v->state = out->state;
        }
        if (out->state == ORR_MSG_MOTION_STATE_EXTRAPOLATED) c->extrapolated++;
        if (out->state == ORR_MSG_MOTION_STATE_JOINING) c->joined++;
        if (out->state == ORR_MSG_MOTION_STATE_SNAPPED) c->snapped++;
        if (out->state > c->worst) c->worst = out->state;
    }
    pthread_mutex_unlock(&v->lock);
    return there;
}

uint8_t orr_vehicle_state(orr_vehicle *v, orr_time *begin)
{
    pthread_mutex_lock(&v->lock);
    const uint8_t state = v->state;
    if (v->latest != ORR_TIME_NONE) *begin = v->latest;
    pthread_mutex_unlock(&v->lock);
    return state;
}

void orr_vehicle_stats(orr_vehicle *v, bool reset, orr_msg_motion_stats *out)
{
    pthread_mutex_lock(&v->lock);
    *out = v->stats;
    out->used = v->course.used;
    out->overtaken = v->course.overtaken;
    out->lateness = orr_spread_told(&v->lateness);
    out->margin = orr_spread_told(&v->margin);
    const size_t waiting = orr_course_waiting(&v->course);
    out->buffered = (uint16_t)waiting;
    v->stats.worst = ORR_MSG_MOTION_STATE_SCENARIO;
    if (reset) {
        v->stats = (orr_msg_motion_stats){0};
        v->course.used = v->course.overtaken = 0;
        v->lateness = v->margin = (orr_spread){0};
    }
    pthread_mutex_unlock(&v->lock);
}

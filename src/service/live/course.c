// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/course.h"

#include <math.h>

#include "core/earth.h"

static const double NOTHING_M = 1e-6, NOTHING_RAD = 1e-9; // a difference below these is not worth a word

void orr_course_init(orr_course *k, double join_s)
{
    *k = (orr_course){.join_s = join_s, .made = ORR_TIME_NONE};
}

static const orr_course_sample *sample_at(const orr_course *k, size_t i)
{
    return &k->sample[(k->first + i) % ORR_COURSE_SAMPLES];
}

// The jerk of a sample that comes without one: its acceleration against that of the nearest sample 20 to 200 ms before. It makes an
// eighth of the error of a smooth motion; bounded, because an acceleration that steps is no jerk that lasts.
static orr_vec3 change_of_acceleration(const orr_course *k, const orr_course_sample *s)
{
    static const double LEAST_S = 0.02, MOST_S = 0.2, MOST_MPS3 = 200;
    for (size_t i = k->n - 1; i-- > 0;) {
        const orr_course_sample *x = sample_at(k, i);
        const double dt = orr_time_diff_s(s->t, x->t);
        if (dt > MOST_S || x->order < 2 || x->antenna != s->antenna) break;
        if (dt < LEAST_S) continue;
        const orr_vec3 jerk = orr_vec3_scale(1 / dt, orr_vec3_sub(s->x[2], x->x[2]));
        const double size = orr_vec3_norm(jerk);
        return size > MOST_MPS3 ? orr_vec3_scale(MOST_MPS3 / size, jerk) : jerk;
    }
    return (orr_vec3){0, 0, 0};
}

// A block rests on one sample, perhaps with the one before; of those before it is known now whether any ever did.
static void settle(orr_course *k, size_t place, const orr_course_sample *before)
{
    if (before != NULL) k->sample[(k->first + place - 1) % ORR_COURSE_SAMPLES].used = true;
    k->sample[(k->first + place) % ORR_COURSE_SAMPLES].used = true;
    for (; k->settled <= place; k->settled++)
        if (k->sample[(k->first + k->settled) % ORR_COURSE_SAMPLES].used)
            k->used++;
        else
            k->overtaken++;
}

void orr_course_add(orr_course *k, const orr_course_sample *s)
{
    if (k->n == ORR_COURSE_SAMPLES) {
        if (k->settled > 0)
            k->settled--;
        else
            k->overtaken++;
        k->first = (k->first + 1) % ORR_COURSE_SAMPLES;
        k->n--;
    }
    orr_course_sample *to = &k->sample[(k->first + k->n++) % ORR_COURSE_SAMPLES];
    *to = *s;
    to->used = false;
    to->from = k->made;
    if (s->order == 2) to->x[3] = change_of_acceleration(k, to);
    if (s->angular_order > 0) return;
    const orr_geodetic g = orr_earth_from_ecef(s->x[0]);
    const orr_mat3 level = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    to->q = orr_quat_from_mat3(&level);
}

// --- Polynomials ---

// Value, rate, acceleration at s seconds of a quintic that begins with d and has faded away after T.
static void fade(const orr_vec3 d[3], double T, double s, orr_vec3 out[3])
{
    const double u = s / T;
    for (int k = 0; k < 3; k++) out[k] = (orr_vec3){0, 0, 0};
    if (!(T > 0) || u >= 1) return;
    const double h[3][3] = {{1 + u * u * u * (-10 + u * (15 - 6 * u)), u * u * (-30 + u * (60 - 30 * u)),
                             u * (-60 + u * (180 - 120 * u))},
                            {u + u * u * u * (-6 + u * (8 - 3 * u)), 1 + u * u * (-18 + u * (32 - 15 * u)),
                             u * (-36 + u * (96 - 60 * u))},
                            {u * u * (0.5 + u * (-1.5 + u * (1.5 - 0.5 * u))),
                             u * (1 + u * (-4.5 + u * (6 - 2.5 * u))), 1 + u * (-9 + u * (18 - 10 * u))}};
    const double scale[3] = {1, T, T * T};
    for (int j = 0; j < 3; j++)     // what it begins with
        for (int k = 0; k < 3; k++) // derivative
            out[k] = orr_vec3_axpy(h[j][k] * scale[j] / scale[k], d[j], out[k]);
}

static void add(orr_vec3 to[3], const orr_vec3 more[3])
{
    for (int k = 0; k < 3; k++) to[k] = orr_vec3_add(to[k], more[k]);
}

// c[0] + c[1] s + c[2] s^2/2 + c[3] s^3/6 with its first two derivatives.
static void taylor(const orr_vec3 c[4], double s, orr_vec3 out[3])
{
    out[0] = orr_vec3_axpy(s, orr_vec3_axpy(s / 2, orr_vec3_axpy(s / 3, c[3], c[2]), c[1]), c[0]);
    out[1] = orr_vec3_axpy(s, orr_vec3_axpy(s / 2, c[3], c[2]), c[1]);
    out[2] = orr_vec3_axpy(s, c[3], c[2]);
}

// What a piece serves at t: place with derivatives, attitude, rate and its derivative.
typedef struct served {
    orr_vec3 x[3];
    orr_quat q;
    orr_vec3 w[2];
} served;

// Turned by a rotation vector g (body axes) that changes; rates add, which holds for small turns and about one axis.
static void turn_by(served *s, const orr_vec3 g[3])
{
    s->q = orr_quat_mul(s->q, orr_quat_from_rotvec(g[0]));
    s->w[0] = orr_vec3_add(s->w[0], g[1]);
    s->w[1] = orr_vec3_add(s->w[1], g[2]);
}

static served of_sample(const orr_course_sample *b, orr_time t)
{
    const double s = orr_time_diff_s(t, b->t);
    const orr_vec3 angle[4] = {{0, 0, 0}, b->w[0], b->w[1], b->w[2]};
    orr_vec3 g[3];
    served out = {.q = b->q};
    taylor(b->x, s, out.x);
    taylor(angle, s, g);
    turn_by(&out, g);
    return out;
}

static served of_piece(const orr_course_piece *p, orr_time t)
{
    served out = of_sample(&p->b, t);
    for (int k = 0; k < 2; k++) {
        orr_vec3 d[3];
        if (!(p->fade_s[k] > 0)) continue;
        const double s = fmax(orr_time_diff_s(t, p->since[k]), 0);
        fade(p->x[k], p->fade_s[k], s, d);
        add(out.x, d);
        fade(p->turn[k], p->fade_s[k], s, d);
        turn_by(&out, d);
    }
    return out;
}

// What leads from one to another, as a difference that fades.
static void difference(const served *from, const served *to, orr_vec3 x[3], orr_vec3 turn[3])
{
    const orr_quat back = {to->q.w, -to->q.x, -to->q.y, -to->q.z};
    const orr_quat between = orr_quat_unit(orr_quat_mul(back, from->q));
    const double sign = between.w < 0 ? -2 : 2; // the short way round
    const orr_vec3 v = {sign * between.x, sign * between.y, sign * between.z};
    const double half = orr_vec3_norm(v) / 2;
    turn[0] = orr_vec3_scale(half > 1e-9 ? asin(fmin(half, 1)) / half : 1, v);
    if (fabs(between.w) < half) turn[0] = orr_vec3_scale(2 * acos(fmin(fabs(between.w), 1)) / (2 * half), v);
    for (int k = 0; k < 3; k++) x[k] = orr_vec3_sub(from->x[k], to->x[k]);
    for (int k = 0; k < 2; k++) turn[k + 1] = orr_vec3_sub(from->w[k], to->w[k]);
}

// --- Pieces ---

static const orr_course_piece *piece_of(const orr_course *k, orr_time t)
{
    const size_t kept = k->n_pieces < ORR_COURSE_PIECES ? k->n_pieces : ORR_COURSE_PIECES;
    for (size_t i = 1; i <= kept; i++) {
        const orr_course_piece *p = &k->piece[(k->n_pieces - i) % ORR_COURSE_PIECES];
        if (p->from <= t) return p;
    }
    return NULL;
}

// The samples that a block at t0 rests on: the first whose tag is behind it, with the one before that; or the last.
static const orr_course_sample *choose(orr_course *k, orr_time t0, const orr_course_sample **before,
                                       size_t *place)
{
    size_t low = 0, high = k->n;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (sample_at(k, middle)->t <= t0)
            low = middle + 1;
        else
            high = middle;
    }
    size_t i = low < k->n ? low : k->n - 1;
    while (i > 0 && sample_at(k, i)->from > t0) i--; // of a recording: it had not come yet
    *before = i > 0 && sample_at(k, i)->t > t0 ? sample_at(k, i - 1) : NULL;
    *place = i;
    return sample_at(k, i);
}

static void begin_piece(orr_course *k, orr_time t0, const orr_course_sample *b, const orr_course_sample *a)
{
    const orr_course_piece *last = piece_of(k, t0);
    orr_course_piece p = {.from = t0, .b = *b, .since = {t0, t0}};
    if (a != NULL &&
        a->antenna == b->antenna) { // between two samples: through the first, with its derivatives
        const served there = of_sample(a, a->t), here = of_sample(b, a->t);
        p.since[0] = a->t;
        p.fade_s[0] = orr_time_diff_s(b->t, a->t);
        difference(&there, &here, p.x[0], p.turn[0]);
    }
    p.snapped = b->snap && !b->used && last != NULL;
    if (last != NULL && !p.snapped && last->b.antenna == b->antenna && k->join_s > 0) {
        const served was = of_piece(last, t0), is = of_piece(&p, t0);
        p.fade_s[1] = k->join_s;
        difference(&was, &is, p.x[1], p.turn[1]);
    }
    k->piece[k->n_pieces++ % ORR_COURSE_PIECES] = p;
}

static bool is_joining(const orr_course_piece *p, orr_time t)
{
    orr_vec3 d[3], g[3];
    const double s = orr_time_diff_s(t, p->since[1]);
    fade(p->x[1], p->fade_s[1], s, d);
    fade(p->turn[1], p->fade_s[1], s, g);
    return orr_vec3_norm(d[0]) > NOTHING_M || orr_vec3_norm(g[0]) > NOTHING_RAD;
}

orr_course_state orr_course_block(orr_course *k, orr_time t0, orr_time t1, int64_t *age_ns)
{
    const orr_course_sample *a;
    size_t place;
    *age_ns = 0;
    const orr_time before = k->made;
    if (before == ORR_TIME_NONE || t1 > before)
        k->made = t1; // without samples too: none that comes now changes it
    if (k->n == 0) return ORR_COURSE_NONE;
    if (before == ORR_TIME_NONE || t0 >= before) {
        const orr_course_sample *b = choose(k, t0, &a, &place);
        if (b->from > t0) return ORR_COURSE_NONE;
        const orr_course_piece *last = piece_of(k, t0);
        if (last == NULL || last->b.t != b->t) {
            begin_piece(k, t0, b, a);
            settle(k, place, a);
        }
    }
    const orr_course_piece *p = piece_of(k, t0);
    if (p == NULL) return ORR_COURSE_NONE;
    *age_ns = orr_time_sub_ns(t0, p->b.t);
    if (p->snapped && p->from == t0) return ORR_COURSE_SNAPPED;
    if (is_joining(p, t0)) return ORR_COURSE_JOINING;
    if (p->b.t == t0 || (p->fade_s[0] > 0 && p->since[0] == t0)) return ORR_COURSE_SYNCHRONOUS;
    return t0 < p->b.t ? ORR_COURSE_INTERPOLATED : ORR_COURSE_EXTRAPOLATED;
}

bool orr_course_at(const orr_course *k, orr_time t, bool end, orr_motion *out, bool *antenna)
{
    const orr_course_piece *p = piece_of(k, end ? t - 1 : t);
    if (p == NULL) return false;
    const served s = of_piece(p, t);
    *antenna = p->b.antenna;
    *out = (orr_motion){.r_m = s.x[0],
                        .v_mps = s.x[1],
                        .a_mps2 = s.x[2],
                        .q_be = orr_quat_unit(s.q),
                        .w_radps = s.w[0],
                        .wdot_radps2 = s.w[1]};
    return true;
}

size_t orr_course_waiting(const orr_course *k)
{
    size_t n = 0;
    while (n < k->n && (k->made == ORR_TIME_NONE || sample_at(k, k->n - 1 - n)->t >= k->made)) n++;
    return n;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate of ideal readings: increments at 100 Hz against integrals in quadruple precision of a trajectory, a gravity and
// kinematics that are written here a second time, from their definitions.
#include "testing.h"

#include "flights.h"
#include "inertial/motion/analytic.h"
#include "inertial/sense/sensors.h"

// libquadmath, declared here because its header is the compiler's own.
__extension__ typedef __float128 quad;
extern quad sinq(quad);
extern quad cosq(quad);
extern quad sqrtq(quad);
extern quad atanq(quad);

// --- A number with two derivatives by time ---

typedef struct jet {
    quad v, d, dd;
} jet;
static jet constant(quad v) { return (jet){v, 0, 0}; }
static jet add(jet a, jet b) { return (jet){a.v + b.v, a.d + b.d, a.dd + b.dd}; }
static jet scale(quad k, jet a) { return (jet){k * a.v, k * a.d, k * a.dd}; }
static jet mul(jet a, jet b)
{
    return (jet){a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}
static jet chain(quad f, quad f1, quad f2, jet a) { return (jet){f, f1 * a.d, f2 * a.d * a.d + f1 * a.dd}; }
static jet sine(jet a) { return chain(sinq(a.v), cosq(a.v), -sinq(a.v), a); }
static jet cosine(jet a) { return chain(cosq(a.v), -sinq(a.v), -cosq(a.v), a); }
static jet root(jet a)
{
    const quad s = sqrtq(a.v);
    return chain(s, 1 / (2 * s), -1 / (4 * s * a.v), a);
}
static jet inverse(jet a) { return chain(1 / a.v, -1 / (a.v * a.v), 2 / (a.v * a.v * a.v), a); }
static jet divide(jet a, jet b) { return mul(a, inverse(b)); }

typedef struct jvec {
    jet c[3];
} jvec;
typedef struct jmat {
    jet m[3][3];
} jmat;

static jmat mat_mul(const jmat *a, const jmat *b)
{
    jmat out;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out.m[i][j] = add(add(mul(a->m[i][0], b->m[0][j]), mul(a->m[i][1], b->m[1][j])),
                              mul(a->m[i][2], b->m[2][j]));
    return out;
}
// Passive rotation about axis 1, 2 or 3 by an angle of this sine and cosine.
static jmat turn(int axis, jet c, jet s)
{
    jmat out;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) out.m[i][j] = constant(i == j ? 1 : 0);
    const int a = axis % 3, b = (axis + 1) % 3; // of axis 3: 0, 1
    out.m[a][a] = out.m[b][b] = c;
    out.m[a][b] = s;
    out.m[b][a] = scale(-1, s);
    return out;
}
static jmat turn_by(int axis, jet angle) { return turn(axis, cosine(angle), sine(angle)); }

// --- Normal gravitation of WGS 84 (Hofmann-Wellenhof and Moritz 2006, 2-126), by differences of its potential ---

static const double A = 6378137.0, INVERSE_F = 298.257223563, GM = 3986004.418e8, OMEGA = 7.292115e-5;

static quad second_kind(quad u, quad E) { return ((1 + 3 * u * u / (E * E)) * atanq(E / u) - 3 * u / E) / 2; }
static quad potential(const quad r[3])
{
    const quad f = 1 / (quad)INVERSE_F, a = (quad)A, b = a * (1 - f), E2 = a * a - b * b, E = sqrtq(E2),
               w = (quad)OMEGA;
    const quad d = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] - E2;
    const quad u2 = d / 2 * (1 + sqrtq(1 + 4 * E2 * r[2] * r[2] / (d * d))), u = sqrtq(u2), s = r[2] / u;
    return (quad)GM / E * atanq(E / u) +
           w * w * a * a / 2 * second_kind(u, E) / second_kind(b, E) * (s * s - (quad)1 / 3);
}
static void gravitation(const quad r[3], quad g[3])
{
    for (int k = 0; k < 3; k++) {
        quad up[3] = {r[0], r[1], r[2]}, down[3] = {r[0], r[1], r[2]};
        const quad step = (quad)1 / 1024;
        up[k] += step;
        down[k] -= step;
        g[k] = (potential(up) - potential(down)) / (2 * step);
    }
}

// --- The motion: a circle whose course the nose follows, and sines on top ---

static const orr_analytic_plan plan = {
    .origin = {0.975, 0.66, 300.0},
    .attitude = {0.2, 0.03, 0.0},
    .follow_course = true,
    .n_terms = 3,
    .term = {{.kind = ORR_ANALYTIC_CIRCLE, .radius_m = 400, .period_s = 60, .azimuth_rad = 0.4},
             {.kind = ORR_ANALYTIC_SINE,
              .amplitude_m = {0.2, 0.1, 0.6},
              .amplitude = {0.02, 0.03, 0.08},
              .period_s = 2.0,
              .phase_rad = 0.3},
             {.kind = ORR_ANALYTIC_SINE,
              .amplitude_m = {0.0, 0.01, 0.02},
              .amplitude = {0.002, 0.004, 0.01},
              .period_s = 0.4,
              .phase_rad = 1.1}}};

// amplitude sin(w t + phase) with its derivatives, from derivative `order` on.
static jet wave(double amplitude, double w, double phase, quad t, int order)
{
    const quad W = (quad)w, x = W * t + (quad)phase,
               value[4] = {sinq(x), W * cosq(x), -W * W * sinq(x), -W * W * W * cosq(x)};
    return (jet){(quad)amplitude * value[order], (quad)amplitude * value[order + 1],
                 order == 0 ? (quad)amplitude * value[2] : (quad)amplitude * value[3]};
}

static void feel(quad t, quad rate[3], quad force[3])
{
    const double w = 2 * ORR_PI / plan.term[0].period_s;
    jet e = wave(400, w, 0.4, t, 0), n = wave(400, w, 0.4 + 0.5 * ORR_PI, t, 0), u = constant(0),
        ve = wave(400, w, 0.4, t, 1), vn = wave(400, w, 0.4 + 0.5 * ORR_PI, t, 1),
        heading = constant((quad)0.2), pitch = constant((quad)0.03), roll = constant(0);
    for (int k = 1; k < 3; k++) {
        const orr_analytic_term *q = &plan.term[k];
        const double v = 2 * ORR_PI / q->period_s, p = q->phase_rad;
        e = add(e, wave(q->amplitude_m.x, v, p, t, 0));
        n = add(n, wave(q->amplitude_m.y, v, p, t, 0));
        u = add(u, wave(q->amplitude_m.z, v, p, t, 0));
        ve = add(ve, wave(q->amplitude_m.x, v, p, t, 1));
        vn = add(vn, wave(q->amplitude_m.y, v, p, t, 1));
        heading = add(heading, wave(q->amplitude.heading_rad, v, p, t, 0));
        pitch = add(pitch, wave(q->amplitude.pitch_rad, v, p, t, 0));
        roll = add(roll, wave(q->amplitude.roll_rad, v, p, t, 0));
    }
    // The local map: the ellipsoid's normal at angles e / (N + h), n / (M + h) from the origin's.
    const quad f = 1 / (quad)INVERSE_F, e2 = f * (2 - f), lat0 = (quad)plan.origin.lat_rad,
               lon0 = (quad)plan.origin.lon_rad, s0 = sinq(lat0), c0 = cosq(lat0), sl = sinq(lon0),
               cl = cosq(lon0), w2 = 1 - e2 * s0 * s0, N0 = (quad)A / sqrtq(w2), M0 = N0 * (1 - e2) / w2;
    const jet x = scale(1 / (N0 + 300), e), y = scale(1 / (M0 + 300), n), q2 = add(mul(x, x), mul(y, y)),
              q = root(q2);
    const jet S = divide(sine(q), q), along[3] = {mul(S, x), mul(S, y), cosine(q)};
    const quad E0[3][3] = {{-sl, cl, 0}, {-s0 * cl, -s0 * sl, c0}, {c0 * cl, c0 * sl, s0}};
    jet normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] = add(add(scale(E0[0][i], along[0]), scale(E0[1][i], along[1])), scale(E0[2][i], along[2]));
    const jet N = scale((quad)A, inverse(root(add(constant(1), scale(-e2, mul(normal[2], normal[2])))))),
              h = add(u, constant(300));
    const jet r[3] = {mul(add(N, h), normal[0]), mul(add(N, h), normal[1]),
                      mul(add(scale(1 - e2, N), h), normal[2])};
    // Body from ecef: latitude and longitude are those of the normal; course and attitude on top.
    const jet level = root(add(mul(normal[0], normal[0]), mul(normal[1], normal[1]))),
              sin_lon = divide(normal[1], level), cos_lon = divide(normal[0], level),
              speed = root(add(mul(ve, ve), mul(vn, vn)));
    // R3(pi/2 + lon), then R1(pi/2 - lat), R3(-course), R3(-heading), R1(pitch), R2(roll).
    const jmat C3 = turn(3, scale(-1, sin_lon), cos_lon), C1 = turn(1, normal[2], level),
               course = turn(3, divide(vn, speed), scale(-1, divide(ve, speed))),
               C5 = turn_by(3, scale(-1, heading)), C6 = turn_by(1, pitch), C7 = turn_by(2, roll);
    jmat B = mat_mul(&C1, &C3);
    B = mat_mul(&course, &B);
    B = mat_mul(&C5, &B);
    B = mat_mul(&C6, &B);
    B = mat_mul(&C7, &B);
    // B' = -[w x] B, so that [w x] = -B' B^T; the Earth's rate besides.
    quad W[3][3], G[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            W[i][k] = -(B.m[i][0].d * B.m[k][0].v + B.m[i][1].d * B.m[k][1].v + B.m[i][2].d * B.m[k][2].v);
    const quad own[3] = {W[2][1], W[0][2], W[1][0]}, o = (quad)OMEGA, place[3] = {r[0].v, r[1].v, r[2].v};
    gravitation(place, G);
    const quad a[3] = {r[0].dd - 2 * o * r[1].d - o * o * r[0].v - G[0],
                       r[1].dd + 2 * o * r[0].d - o * o * r[1].v - G[1], r[2].dd - G[2]};
    for (int i = 0; i < 3; i++) {
        rate[i] = own[i] + o * B.m[i][2].v;
        force[i] = B.m[i][0].v * a[0] + B.m[i][1].v * a[1] + B.m[i][2].v * a[2];
    }
}

// --- Integrals ---

enum { NODES = 12 };
// Gauss and Legendre's nodes and weights on (0, 1), by Newton's iteration.
static void gauss(quad node[NODES], quad weight[NODES])
{
    const quad pi = 4 * atanq(1);
    for (int k = 0; k < NODES; k++) {
        quad x = cosq(pi * ((quad)k + (quad)3 / 4) / ((quad)NODES + (quad)1 / 2)), d = 0;
        for (int round = 0; round < 12; round++) {
            quad p = 1, before = 0;
            for (int n = 1; n <= NODES; n++) {
                const quad next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
                before = p;
                p = next;
            }
            d = NODES * (x * p - before) / (x * x - 1);
            x -= p / d;
        }
        node[k] = (1 + x) / 2;
        weight[k] = 1 / ((1 - x * x) * d * d);
    }
}

// 1e-15 rad and 1e-13 m/s a step: which order of quadrature reaches that. Each step of a stretch, and one in 29 of a minute.
static void certificate(void **state)
{
    (void)state;
    enum { STEPS = 40 };
    quad node[NODES], weight[NODES];
    gauss(node, weight);
    orr_trajectory tr;
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(0, 0, 60, &plan, &tr, &diag), diag);
    double angle[6] = {0}, speed[6] = {0};
    for (int k = 0; k < STEPS; k++) {
        const double from = (double)(k * 149) / 100, to = (double)(k * 149 + 1) / 100;
        quad sum[6] = {0, 0, 0, 0, 0, 0};
        for (int i = 0; i < NODES; i++) {
            quad rate[3], force[3];
            const quad h = (quad)to - (quad)from;
            feel((quad)from + node[i] * h, rate, force);
            for (int c = 0; c < 3; c++) {
                sum[c] += weight[i] * h * rate[c];
                sum[3 + c] += weight[i] * h * force[c];
            }
        }
        for (int order = 1; order <= ORR_IMU_MAX_ORDER; order++) {
            orr_vec3 g, v;
            test_increment(&tr, NULL, ORR_QUADRATURE_GAUSS, order, from, to, &g, &v);
            const quad off[6] = {(quad)g.x - sum[0], (quad)g.y - sum[1], (quad)g.z - sum[2],
                                 (quad)v.x - sum[3], (quad)v.y - sum[4], (quad)v.z - sum[5]};
            for (int c = 0; c < 3; c++) {
                angle[order] = fmax(angle[order], fabs((double)off[c]));
                speed[order] = fmax(speed[order], fabs((double)off[3 + c]));
            }
        }
    }
    int reached = 0;
    for (int order = ORR_IMU_MAX_ORDER; order >= 1; order--) {
        print_message("order %d: %.2e rad, %.2e m/s\n", order, angle[order], speed[order]);
        if (angle[order] < 1e-15 && speed[order] < 1e-13) reached = order;
    }
    print_message("1e-15 rad and 1e-13 m/s are reached by order %d\n", reached);
    assert_true(reached >= 2 && reached <= 4);
    for (int order = reached; order <= ORR_IMU_MAX_ORDER; order++)
        assert_true(angle[order] < 1e-15 && speed[order] < 1e-13);
    assert_true(angle[1] > 1e-10); // and the middle alone is far from it
    orr_trajectory_free(&tr);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(certificate)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Fusion, sessions and transfer on a made station: the content of the sky, the arcs' biases and the
// receiver's are known.
#include <unistd.h>

#include "core/nan.h"
#include "core/rng.h"
#include "iono/field/sun_frame.h"
#include "iono/fusion/fusion_private.h"
#include "iono/fusion/session.h"
#include "testing.h"

enum { SATS = 24, EPOCHS = 6 * 60 }; // six hours, one a minute
#define RADIUS ORR_SHELL_RADIUS_M

typedef struct sky {
    orr_phase_tec phase;
    orr_tec_field *field;
    double bias[SATS], truth[SATS][EPOCHS];
    orr_vec3 pos[SATS][EPOCHS];
} sky;

// What the field knows, and what it does not: an offset that grows over the hours, slopes and a bend over the
// station.
static double unknown(const orr_iono_site *site, orr_vec3 unit, double hours)
{
    orr_vec3 up = orr_vec3_unit(site->pos_m), north = orr_vec3_cross(up, site->east);
    double x = RADIUS / 1e6 * orr_vec3_dot(unit, site->east), y = RADIUS / 1e6 * orr_vec3_dot(unit, north);
    return 2 + 0.8 * hours - 1.5 * x + 2 * y + 0.7 * x * y - 0.4 * y * y;
}

static orr_tec_field *made_field(orr_time t0)
{
    double value[9] = {25, 2, 8}, rms[9] = {5}; // wrong by 2 to 7 TECU, and says so
    orr_tec_coefficients set[2] = {{t0, ORR_TIME_NONE, 2, 2, value, rms},
                                   {orr_time_add_s(t0, 6 * 3600.0), ORR_TIME_NONE, 2, 2, value, rms}};
    orr_tec_model model = {2, set, 79, -71, RADIUS, "made"};
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_model(&model, NULL, &f, &d), d);
    return f;
}

// Satellites above an elevation.
static void make_above(sky *s, double noise, double least_el_deg)
{
    orr_diag d = {0};
    orr_time t0;
    memset(s, 0, sizeof *s);
    assert_int_equal(orr_time_parse("2024-02-04T06:00:00", NULL, &t0, NULL), ORR_OK);
    s->field = made_field(t0);
    orr_phase_tec *p = &s->phase;
    snprintf(p->marker, sizeof p->marker, "MADE");
    ASSERT_OK(orr_iono_site_at(orr_earth_to_ecef((orr_geodetic){0.9, 0.3, 100}), &p->site, &d), d);
    p->has_geometry = true;
    p->interval_s = 60;
    p->from = t0;
    p->to = orr_time_add_s(t0, 60 * (EPOCHS - 1));
    p->n_sats = SATS;
    p->sat = calloc(SATS, sizeof *p->sat);
    orr_tec_instant *at = malloc(sizeof *at);
    for (int k = 0; k < SATS; k++) {
        orr_phase_sat *sat = &p->sat[k];
        *sat = (orr_phase_sat){.sat = orr_sat_make(k % 3 == 2 ? 'E' : 'G', k + 1),
                               .phase = {"L1C", "L2W"},
                               .range = {"C1C", "C2W"},
                               .freq_hz = {1575.42e6, 1227.6e6}};
        sat->t = malloc(EPOCHS * sizeof *sat->t);
        sat->gf_tecu = malloc(EPOCHS * sizeof *sat->gf_tecu);
        sat->code_tecu = malloc(EPOCHS * sizeof *sat->code_tecu);
        sat->windup = calloc(EPOCHS, sizeof *sat->windup);
        sat->pierce = calloc(EPOCHS, sizeof *sat->pierce);
        sat->arcs.arc_of = malloc(EPOCHS * sizeof *sat->arcs.arc_of);
        sat->arcs.arc = calloc(1, sizeof *sat->arcs.arc);
        s->bias[k] = 100 * orr_rng_normal(3, 0, (uint64_t)k);
        // A pass: up from the horizon and down again over some hours, its azimuth turning.
        double rise = -60 + 300 * orr_rng_uniform(3, 1, (uint64_t)k),
               az0 = 6.28 * orr_rng_uniform(3, 2, (uint64_t)k);
        double top = 0.5 + 1.0 * orr_rng_uniform(3, 3, (uint64_t)k);
        for (int i = 0; i < EPOCHS; i++) {
            double phase = (i - rise) / 260.0, el = top * sin(ORR_PI * phase), az = az0 + 2.5 * phase;
            if (phase < 0 || phase > 1 || el < least_el_deg * ORR_RAD_PER_DEG) continue;
            orr_time t = orr_time_add_s(t0, 60 * i);
            size_t n = sat->n;
            orr_tec_ray ray;
            ASSERT_OK(orr_pierce_direction(&p->site, az, el, RADIUS, &sat->pierce[n], &d), d);
            ASSERT_OK(orr_tec_field_at(s->field, t, at, &d), d);
            ASSERT_OK(orr_tec_look_through(at, &p->site, &sat->pierce[n], &ray, &d), d);
            orr_vec3 dir =
                orr_vec3_unit(orr_vec3_sub(orr_vec3_scale(RADIUS, sat->pierce[n].unit), p->site.pos_m));
            s->pos[k][n] = orr_vec3_axpy(22e6, dir, p->site.pos_m);
            s->truth[k][n] = ray.mapping * (ray.vtec_tecu + unknown(&p->site, sat->pierce[n].unit, i / 60.0) +
                                            noise * orr_coloured_noise(17, sat->sat, t, 1200));
            sat->t[n] = t;
            sat->gf_tecu[n] = s->truth[k][n] + s->bias[k];
            sat->code_tecu[n] =
                s->truth[k][n] + 12 + 0.5 * orr_rng_normal(4, (uint64_t)k, (uint64_t)i); // the receiver's 12
            sat->arcs.arc_of[n] = 0;
            sat->n++;
        }
        sat->arcs.n_samples = sat->n;
        if (sat->n >= 30) {
            sat->arcs.n_arcs = 1;
            sat->arcs.arc[0] = (orr_arc){0, sat->n - 1, sat->n};
        } else
            for (size_t i = 0; i < sat->n; i++) sat->arcs.arc_of[i] = -1;
    }
    free(at);
}

static void make(sky *s, double noise) { make_above(s, noise, 10); }

static void drop(sky *s)
{
    orr_phase_tec_free(&s->phase);
    orr_tec_field_free(s->field);
}

// How far what the field does not know lies from the prior's zero, in units of the prior's sigma: the square root of d' P^-1 d over
// the coefficients of `unknown` at all knots.
static double distance_from_prior(const orr_fusion *f)
{
    double square = 0;
    for (int j = 0; j < ORR_CORRECTION_TERMS; j++) {
        double sigma, time_s, last = 0;
        correction_prior(&f->model, j, &sigma, &time_s);
        const double rho = exp(-f->correction.knot_s / time_s), q = sigma * sigma * (1 - rho * rho);
        for (size_t k = 0; k < f->correction.n; k++) {
            const double level = 2 + 0.8 * (double)k * f->correction.knot_s / 3600;
            const double d[ORR_CORRECTION_TERMS] = {level, -1.5, 2, 0, 0.7, -0.4};
            const double step = k > 0 ? d[j] - rho * last : d[j];
            square += step * step / (k > 0 ? q : sigma * sigma);
            last = d[j];
        }
    }
    return sqrt(square);
}

// Without noise the truth meets every observation, so the least of the fit's sum of squares is at most the prior's of the truth, M^2.
// Hence (Cauchy and Schwarz) whatever is estimated is off by at most M of its sigma, and a residual is at most M of its own:
// that is how far priors can pull. Above 12 deg all pierce points lie within 1440 km, where the correction is the unknown's polynomial;
// lower ones lie beyond its reach of 1500 km, where it is held, and the difference (0.6 TECU from 10 deg on) is no longer the priors'.
static void test_known_truth(void **state)
{
    (void)state;
    static sky s;
    make_above(&s, 0, 12);
    orr_fusion_options o = orr_fusion_default_options();
    orr_fusion f;
    orr_diag d = {0};
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, &o, &f, &d), d);
    assert_true(f.n_arcs >= 12 && f.fallback == ORR_FUSION_AS_ASKED);
    const double M = distance_from_prior(&f), left_tecu = M * f.model.residual_tecu;
    double worst = 0, pull = 0, steepest = 1;
    for (size_t a = 0; a < f.n_arcs; a++) {
        const orr_fused_arc *arc = &f.arc[a];
        const orr_phase_sat *sat = &s.phase.sat[arc->sat_index];
        const double e = fabs(arc->bias_tecu - s.bias[arc->sat_index]);
        worst = fmax(worst, e);
        pull = fmax(pull, e / arc->sigma_tecu);
        assert_true(e <= M * arc->sigma_tecu);
        // The correction is the unknown part, where rays are: what is left of it is residual and bias, vertical.
        for (size_t i = 0; i < sat->n; i += 20) {
            const double mapping = f.mapping[arc->sat_index][i];
            steepest = fmax(steepest, mapping);
            ASSERT_NEAR(
                orr_correction_at(&f.correction, sat->t[i], sat->pierce[i].unit,
                                  f.model_vtec[arc->sat_index][i], mapping),
                unknown(&s.phase.site, sat->pierce[i].unit, orr_time_diff_s(sat->t[i], s.phase.from) / 3600),
                M * arc->sigma_tecu / mapping + left_tecu);
        }
    }
    print_message(
        "%zu arcs, worst bias %.1e TECU off, %.2f of its sigma (bound %.2f); RMS against the corrected field "
        "%.1e (bound %.1e), against the field %.3f\n",
        f.n_arcs, worst, pull, M, f.residual_tecu, steepest * left_tecu, f.model_residual_tecu);
    assert_true(f.residual_tecu <= steepest * left_tecu);
    // And the sigma is not so wide that it says nothing: it is a tenth of the error of a field that nothing corrects.
    for (size_t a = 0; a < f.n_arcs; a++) assert_true(f.arc[a].sigma_tecu < 0.1 * f.model_residual_tecu);
    // The source's method puts the field's error into the biases instead.
    orr_fusion thesis;
    o.method = ORR_FUSION_THESIS;
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, &o, &thesis, &d), d);
    double off = 0;
    for (size_t a = 0; a < thesis.n_arcs; a++)
        off = fmax(off, fabs(thesis.arc[a].bias_tecu - s.bias[thesis.arc[a].sat_index]));
    assert_true(off > 3 && worst < off / 4);
    ASSERT_NEAR(thesis.residual_tecu, thesis.model_residual_tecu, 1e-12); // there is no correction
    orr_fusion_free(&thesis, &s.phase);
    orr_fusion_free(&f, &s.phase);
    drop(&s);
}

// With structure that no correction follows: the sigma that is reported is honest within a factor, and
// published biases of satellites (here: none but zero) with one unknown of the receiver help.
static void test_sigma_and_codes(void **state)
{
    (void)state;
    static sky s;
    make(&s, 0.6);
    orr_fusion_options o = orr_fusion_default_options();
    orr_fusion f;
    orr_diag d = {0};
    double plain = 0, coded = 0, pull = 0, n = 0;
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, &o, &f, &d), d);
    for (size_t a = 0; a < f.n_arcs; a++) {
        double e = f.arc[a].bias_tecu - s.bias[f.arc[a].sat_index];
        plain += e * e;
        pull += e * e / (f.arc[a].sigma_tecu * f.arc[a].sigma_tecu);
        n++;
        assert_true(isnan(f.arc[a].code_bias_tecu));
    }
    print_message("bias error %.3f TECU RMS, %.2f of its sigma\n", sqrt(plain / n), sqrt(pull / n));
    assert_true(sqrt(pull / n) > 0.2 && sqrt(pull / n) < 3);
    orr_fusion_free(&f, &s.phase);
    // A bias file that says 0 of every satellite.
    orr_bias *line = calloc(2 * SATS, sizeof *line);
    for (size_t k = 0; k < 2 * SATS; k++)
        line[k] = (orr_bias){.kind = ORR_BIAS_OSB,
                             .sat = s.phase.sat[k / 2].sat,
                             .system = orr_sat_system(s.phase.sat[k / 2].sat),
                             .obs1 = {'C', (char)(k % 2 ? '2' : '1'), (char)(k % 2 ? 'W' : 'C')},
                             .from = ORR_TIME_NONE,
                             .until = ORR_TIME_NONE};
    orr_bias_set set = {
        .absolute = true, .n = 2 * SATS, .bias = line, .from = ORR_TIME_NONE, .until = ORR_TIME_NONE};
    memcpy(o.code_systems, "G", 2);
    ASSERT_OK(orr_fuse(&s.phase, s.field, &set, 1, &o, &f, &d), d);
    for (size_t a = 0; a < f.n_arcs; a++) {
        double e = f.arc[a].bias_tecu - s.bias[f.arc[a].sat_index];
        coded += e * e;
        if (isnan(f.arc[a].code_bias_tecu)) fail_msg("no code bias");
        bool gps = orr_sat_system(f.arc[a].sat) == 'G';
        assert_true(f.arc[a].code_used ? gps : !gps);
    }
    print_message("with GPS codes: bias error %.3f TECU RMS; receiver %.2f +- %.2f; Galileo std %.3f\n",
                  sqrt(coded / n), f.group[0].receiver_tecu, f.group[0].sigma_tecu, f.galileo_std_tecu);
    assert_true(coded < plain);
    // Sign: code = content + 12. A mapping function that may be wrong leaves the level known to a TECU and a half.
    assert_true(fabs(f.group[0].receiver_tecu - 12) < 2 * f.group[0].sigma_tecu && f.group[0].sigma_tecu < 2);
    assert_true(f.galileo_withheld && f.galileo_std_tecu < 1);
    orr_fusion_free(&f, &s.phase);
    free(line);
    drop(&s);
}

// A slip that got through is found in the residuals, and splits the arc there.
static void test_step_splits(void **state)
{
    (void)state;
    static sky s;
    make(&s, 0.2);
    orr_fusion f;
    orr_diag d = {0};
    size_t k = 0;
    while (s.phase.sat[k].n < 200) k++;
    for (size_t i = 90; i < s.phase.sat[k].n; i++) s.phase.sat[k].gf_tecu[i] += 4;
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, NULL, &f, &d), d);
    const orr_arcs *a = &s.phase.sat[k].arcs;
    assert_int_equal(a->n_arcs, 2);
    assert_int_equal(a->n_slips, 1);
    assert_int_equal(a->slip[0].at, 90);
    assert_int_equal(a->slip[0].causes, ORR_SLIP_STEP);
    assert_true(a->arc_of[89] != a->arc_of[90]);
    double first = 0, second = 0;
    for (size_t i = 0; i < f.n_arcs; i++)
        if (f.arc[i].sat_index == k) *(f.arc[i].arc == 0 ? &first : &second) = f.arc[i].bias_tecu;
    ASSERT_NEAR(second - first, 4, 0.5);
    orr_fusion_free(&f, &s.phase);
    drop(&s);
}

static void test_refusals(void **state)
{
    (void)state;
    static sky s;
    orr_fusion f;
    orr_diag d = {0};
    make(&s, 0);
    s.phase.has_geometry = false;
    assert_int_equal(orr_fuse(&s.phase, s.field, NULL, 0, NULL, &f, &d), ORR_E_ARG);
    assert_non_null(strstr(d.text, "orbit"));
    s.phase.has_geometry = true;
    orr_tec_field *other = made_field(orr_time_add_s(s.phase.from, 86400));
    assert_int_equal(orr_fuse(&s.phase, other, NULL, 0, NULL, &f, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "covers"));
    orr_tec_field_free(other);
    for (size_t k = 0; k < SATS; k++) {
        s.phase.sat[k].arcs.n_arcs = 0;
        for (size_t i = 0; i < s.phase.sat[k].n; i++) s.phase.sat[k].arcs.arc_of[i] = -1;
    }
    assert_int_equal(orr_fuse(&s.phase, s.field, NULL, 0, NULL, &f, &d), ORR_E_NODATA);
    assert_non_null(strstr(d.text, "no unbroken arc"));
    drop(&s);
}

// Unit variance, no mean, correlation that falls to 1/e at the time named, the same whenever asked, another
// satellite another noise.
static void test_coloured_noise(void **state)
{
    (void)state;
    double sum = 0, square = 0, lag = 0, cross = 0;
    enum { N = 40000 };
    orr_sat g = orr_sat_make('G', 1), e = orr_sat_make('E', 1);
    for (int64_t i = 0; i < N; i++) {
        orr_time t = (i - N / 2) * 300 * ORR_NS_PER_S; // before 1980 too
        double v = orr_coloured_noise(9, g, t, 600);
        sum += v;
        square += v * v;
        lag += v * orr_coloured_noise(9, g, t + 600 * ORR_NS_PER_S, 600);
        cross += v * orr_coloured_noise(9, e, t, 600);
        if (i % 1000 == 0) { // smooth: over a second it moves by far less than itself
            ASSERT_NEAR(orr_coloured_noise(9, g, t + ORR_NS_PER_S, 600), v, 0.02);
        }
    }
    ASSERT_NEAR(sum / N, 0, 0.05);
    ASSERT_NEAR(square / N, 1, 0.05);
    ASSERT_NEAR(lag / square, exp(-1), 0.08);
    ASSERT_NEAR(cross / N, 0, 0.05);
}

// Noise over places and time: unit variance, correlation of about 1/e at a unit of distance, next to none at three, and
// close places alike.
static void test_shell_noise(void **state)
{
    (void)state;
    double square = 0, one = 0, three = 0, lag = 0, worst = 0;
    enum { M = 20000 };
    for (int i = 0; i < M; i++) {
        orr_time t = (orr_time)i * 1700 * ORR_NS_PER_S;
        double x = 7.3 * (i % 100) - 300, y = 5.1 * (i / 100) - 400, v = orr_shell_noise(3, x, y, t, 600);
        square += v * v;
        one += v * orr_shell_noise(3, x + 1, y, t, 600);
        three += v * orr_shell_noise(3, x, y + 4, t, 600);
        lag += v * orr_shell_noise(3, x, y, t + 600 * ORR_NS_PER_S, 600);
        worst = fmax(worst, fabs(orr_shell_noise(3, x + 0.01, y, t, 600) - v));
    }
    ASSERT_NEAR(square / M, 1, 0.05);
    ASSERT_NEAR(one / square, exp(-1), 0.08);
    ASSERT_NEAR(three / square, 0, 0.05);
    ASSERT_NEAR(lag / square, exp(-1), 0.08);
    assert_true(worst < 0.1);
}

// Two satellites that the station does not see, a tenth of a degree apart, have almost the same noise; on the other side
// of the sky another one. Beyond the session's ends all of it fades to the field.
static void test_unseen_neighbours(void **state)
{
    (void)state;
    static sky s;
    make(&s, 0.6);
    orr_fusion f;
    orr_diag d = {0};
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, NULL, &f, &d), d);
    orr_session x;
    ASSERT_OK(orr_session_make(&s.phase, &f, made_field(s.phase.from), 300, &x, &d), d);
    orr_vec3 site = x.site.pos_m, pos[3];
    const double dir[3][2] = {{0.3, 0.6}, {0.302, 0.6}, {3.4, 0.5}}; // azimuth, elevation
    for (int i = 0; i < 3; i++)
        pos[i] = orr_vec3_axpy(22e6,
                               orr_vec3_axpy(cos(dir[i][1]) * sin(dir[i][0]), x.site.east,
                                             orr_vec3_axpy(cos(dir[i][1]) * cos(dir[i][0]), x.site.north,
                                                           orr_vec3_scale(sin(dir[i][1]), x.site.up))),
                               site);
    const orr_sat unseen[3] = {orr_sat_make('R', 1), orr_sat_make('R', 2), orr_sat_make('R', 3)};
    double near = 0, far = 0, own = 2 * x.small.own_tecu * x.small.own_tecu, n = 0;
    for (uint64_t seed = 1; seed <= 300; seed++) {
        orr_realisation r[3], quiet[3];
        size_t m;
        orr_transfer_options o = {.seed = seed, .noise = true};
        orr_time t = orr_time_add_s(x.from, 3600 * 3);
        ASSERT_OK(orr_session_realise(&x, t, site, unseen, pos, 3, &o, r, &m, &d), d);
        o.noise = false;
        ASSERT_OK(orr_session_realise(&x, t, site, unseen, pos, 3, &o, quiet, &m, &d), d);
        assert_int_equal(m, 3);
        double v[3];
        for (int i = 0; i < 3; i++) v[i] = r[i].vtec_tecu - quiet[i].vtec_tecu;
        near += (v[0] - v[1]) * (v[0] - v[1]);
        far += (v[0] - v[2]) * (v[0] - v[2]);
        n++;
    }
    print_message("noise of two unseen satellites apart by 0.1 deg: %.3f TECU, on other sides: %.3f\n",
                  sqrt(near / n), sqrt(far / n));
    assert_true(near / n < 1.3 * own + 0.02 * far / n && near < far / 2);
    orr_session_free(&x);
    orr_fusion_free(&f, &s.phase);
    drop(&s);
}

// The station's curve has no corners at its samples: the rates before and after one are the same (but for the hours, at which the
// correction of the field has its knots), while the chords' rates differ by what the content bends in a minute.
static void the_curve_has_no_corners(void **state)
{
    (void)state;
    static sky s;
    make(&s, 0.6);
    orr_fusion f;
    orr_diag d = {0};
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, NULL, &f, &d), d);
    orr_session x;
    ASSERT_OK(orr_session_make(&s.phase, &f, made_field(s.phase.from), 300, &x, &d), d);
    const double h = 0.01;
    double worst = 0, chords = 0, n = 0;
    for (size_t k = 0; k < SATS; k++) {
        const orr_phase_sat *sat = &s.phase.sat[k];
        for (size_t i = 2; i + 2 < sat->n; i += 7) {
            if (sat->arcs.arc_of[i] < 0 || (sat->t[i] - x.from) % (3600 * ORR_NS_PER_S) == 0) continue;
            double v[3];
            const orr_vec3 rate = orr_vec3_scale(1 / 120.0, orr_vec3_sub(s.pos[k][i + 1], s.pos[k][i - 1]));
            for (int j = -1; j <= 1; j++) {
                orr_realisation r;
                size_t m;
                const orr_vec3 pos = orr_vec3_axpy(j * h, rate, s.pos[k][i]);
                ASSERT_OK(orr_session_realise(&x, orr_time_add_s(sat->t[i], j * h), x.site.pos_m, &sat->sat,
                                              &pos, 1, NULL, &r, &m, &d),
                          d);
                assert_int_equal(m, 1);
                v[j + 1] = r.stec_tecu;
            }
            worst = fmax(worst, fabs(v[2] - 2 * v[1] + v[0]) / h);
            const double bend = sat->gf_tecu[i + 1] - 2 * sat->gf_tecu[i] + sat->gf_tecu[i - 1];
            chords += bend * bend / 3600;
            n++;
        }
    }
    print_message("rates at %g samples differ by %.1e TECU/s at most; those of chords by %.1e RMS\n", n,
                  worst, sqrt(chords / n));
    assert_true(n > 100 && worst < 1e-4);
    orr_session_free(&x);
    orr_fusion_free(&f, &s.phase);
    drop(&s);
}

// A session in a file and back; at home the truth; near by, close to it; damaged files are refused.
static void test_session(void **state)
{
    (void)state;
    static sky s;
    make(&s, 0.6);
    orr_fusion f;
    orr_diag d = {0};
    ASSERT_OK(orr_fuse(&s.phase, s.field, NULL, 0, NULL, &f, &d), d);
    orr_session made, x;
    ASSERT_OK(orr_session_make(&s.phase, &f, made_field(s.phase.from), 300, &made, &d), d);
    assert_true(made.small.sigma_tecu > 0.2 && made.small.sigma_tecu < 1);
    char path[] = "/tmp/orrery-session-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    ASSERT_OK(orr_session_save(&made, path, "made", NULL, 0, &d), d);
    ASSERT_OK(orr_session_load(path, NULL, &x, &d), d);
    assert_int_equal(x.n_samples, made.n_samples);
    size_t k = f.arc[0].sat_index, middle = s.phase.sat[k].n / 2;
    orr_time t = s.phase.sat[k].t[middle];
    double constant = ORR_NAN;
    for (size_t i = 0; i < s.phase.sat[k].n; i++) {
        orr_realisation r;
        size_t n;
        ASSERT_OK(orr_session_realise(&x, s.phase.sat[k].t[i], x.site.pos_m, &s.phase.sat[k].sat,
                                      &s.pos[k][i], 1, NULL, &r, &n, &d),
                  d);
        assert_int_equal(r.origin, ORR_ORIGIN_FUSED);
        double c = r.stec_tecu - s.phase.sat[k].gf_tecu[i];
        if (i == 0) constant = c;
        ASSERT_NEAR(c, constant, 1e-6); // the shape is the phase's
    }
    orr_realisation near, far, expected;
    size_t n;
    orr_transfer_options quiet = {.seed = 1, .noise = false};
    orr_vec3 site = orr_vec3_axpy(5e3, x.site.east, x.site.pos_m),
             distant = orr_vec3_axpy(900e3, x.site.east, x.site.pos_m);
    ASSERT_OK(
        orr_session_realise(&x, t, site, &s.phase.sat[k].sat, &s.pos[k][middle], 1, &quiet, &near, &n, &d),
        d);
    ASSERT_OK(
        orr_session_realise(&x, t, distant, &s.phase.sat[k].sat, &s.pos[k][middle], 1, &quiet, &far, &n, &d),
        d);
    ASSERT_OK(orr_session_realise(&x, t, x.site.pos_m, &s.phase.sat[k].sat, &s.pos[k][middle], 1, &quiet,
                                  &expected, &n, &d),
              d);
    assert_int_equal(near.origin, ORR_ORIGIN_TRANSFERRED);
    ASSERT_NEAR(near.stec_tecu, expected.stec_tecu, 1.0);
    assert_true(near.sigma_tecu < far.sigma_tecu); // what is carried far is known less
    // Outside of its hours the field alone speaks, or nobody.
    assert_int_equal(orr_session_realise(&x, x.to + 7200 * ORR_NS_PER_S, site, &s.phase.sat[k].sat,
                                         &s.pos[k][middle], 1, NULL, &near, &n, &d),
                     ORR_E_RANGE);
    assert_int_equal(orr_session_realise(&x, t, (orr_vec3){0, 0, 0}, &s.phase.sat[k].sat, &s.pos[k][middle],
                                         1, NULL, &near, &n, &d),
                     ORR_E_ARG);
    orr_session_free(&x);
    // A file cut short is no session.
    FILE *cut = fopen(path, "r+b");
    assert_non_null(cut);
    assert_int_equal(ftruncate(fileno(cut), 3000), 0);
    fclose(cut);
    assert_true(orr_session_load(path, NULL, &x, &d) != ORR_OK);
    unlink(path);
    assert_int_equal(orr_session_load(path, NULL, &x, &d), ORR_E_IO);
    orr_session_free(&made);
    orr_fusion_free(&f, &s.phase);
    drop(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_known_truth),
                                       cmocka_unit_test(test_sigma_and_codes),
                                       cmocka_unit_test(test_step_splits),
                                       cmocka_unit_test(test_refusals),
                                       cmocka_unit_test(test_coloured_noise),
                                       cmocka_unit_test(test_shell_noise),
                                       cmocka_unit_test(test_unseen_neighbours),
                                       cmocka_unit_test(the_curve_has_no_corners),
                                       cmocka_unit_test(test_session)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The reference fit on orbits made with a known rotation of the Earth and known coefficients of ECOM: it
// finds both, whatever node is wrong; and the partial derivatives that it rests on, against differences of
// integrated orbits.
#include "testing.h"

#include "core/eop_tides.h"
#include "orbit/dynamics/reference_fit.h"
#include "orbit/dynamics/variational.h"

#define MAS (ORR_RAD_PER_DEG / 3.6e6)
#define SATS 6
#define STEP_S 900.0
#define NODES 97

typedef struct made { // six satellites in as many planes over one or two days
    orr_time from;
    size_t days;
    double border_s[3];
    orr_eop_series eop;
    orr_sky *sky;
    orr_force force[SATS];
    orr_vec3 r[SATS], v[SATS]; // at the begin
    orr_reference_node node[SATS][2][NODES];
    orr_reference_arc arc[2 * SATS];
} made;

// Pole, rates and length of day that differ from what is known without measurements by as much as they do.
static void make_rotation(made *m)
{
    m->eop.n = 40;
    m->eop.mjd_utc = calloc(m->eop.n, sizeof *m->eop.mjd_utc);
    m->eop.value = calloc(m->eop.n, sizeof *m->eop.value);
    assert_true(m->eop.mjd_utc && m->eop.value);
    for (size_t i = 0; i < m->eop.n; i++) {
        const double days = ((double)i - 2) / 8;
        const orr_time t = orr_time_add_s(m->from, 86400 * days);
        int32_t day;
        double fraction;
        orr_time_mjd(t, ORR_SCALE_UTC, NULL, &day, &fraction);
        const orr_eop e = orr_eop_at(NULL, t, NULL, NULL);
        m->eop.mjd_utc[i] = day + fraction;
        m->eop.value[i] = (orr_eop){.xp_rad = e.xp_rad + (120 - 1.9 * days) * MAS,
                                    .yp_rad = e.yp_rad + (-140 + 1.2 * days) * MAS,
                                    .ut1_utc_s = e.ut1_utc_s + orr_eop_tides_zonal_ut1(t) - 0.9e-3 * days};
    }
}

static void make(made *m, size_t days)
{
    orr_diag d = {0};
    *m = (made){.days = days, .border_s = {0, 86400, 172800}};
    ASSERT_OK(orr_time_parse("2024-02-04", NULL, &m->from, &d), d);
    make_rotation(m);
    ASSERT_OK(orr_sky_init_precise(m->from, orr_time_add_s(m->from, 86400.0 * (double)days), &m->sky, &d), d);
    orr_sky_turn(m->sky, &m->eop);
    for (int s = 0; s < SATS; s++) {
        orr_integrator *it = NULL;
        m->force[s] = (orr_force){.sun_moon = true, .precise = true};
        ASSERT_OK(orr_gravity_field_init(&m->force[s].earth, 8, false, &d), d);
        const double ecom[ORR_ECOM_TERMS] = {-95 - 3 * s, 0.4, -0.6, 0.3, -1.1, 0.8, 0.2, -0.3, 0.1};
        memcpy(m->force[s].ecom_nmps2, ecom, sizeof ecom);
        const double node = s, u = 2.0 * s, incl = 0.96, a = 2.66e7;
        const orr_vec3 across = {-sin(node) * cos(incl), cos(node) * cos(incl), sin(incl)},
                       to = {cos(node), sin(node), 0};
        orr_vec3 r = orr_vec3_scale(a, orr_vec3_axpy(sin(u), across, orr_vec3_scale(cos(u), to)));
        orr_vec3 v = orr_vec3_scale(sqrt(ORR_EGM96_GM / a),
                                    orr_vec3_axpy(cos(u), across, orr_vec3_scale(-sin(u), to)));
        m->r[s] = r;
        m->v[s] = v;
        ASSERT_OK(orr_integrator_init(&m->force[s], m->sky, &it, &d), d);
        for (size_t k = 0; k < days * (NODES - 1) + 1; k++) {
            const double t_s = STEP_S * (double)k;
            orr_sky_point p;
            orr_sky_force_point(m->sky, t_s, &p);
            const orr_reference_node n = {t_s, orr_mat3_apply(&p.R, r)};
            const size_t w = k / (NODES - 1), i = k % (NODES - 1);
            if (w < days) m->node[s][w][i] = n;
            if (w > 0 && i == 0) m->node[s][w - 1][NODES - 1] = n;
            if (k < days * (NODES - 1)) ASSERT_OK(orr_integrate(it, t_s, STEP_S, &r, &v), d);
        }
        orr_integrator_free(it);
        for (size_t w = 0; w < days; w++)
            m->arc[days * (size_t)s + w] =
                (orr_reference_arc){.sat = (size_t)s, .window = w, .n = NODES, .node = m->node[s][w]};
    }
}

static void unmake(made *m)
{
    orr_sky_free(m->sky);
    free(m->eop.mjd_utc);
    free(m->eop.value);
}

static orr_reference_fit fit(made *m, size_t n_sats, const orr_eop_series *eop, bool hold, int jobs)
{
    const orr_reference_problem p = {.from = m->from,
                                     .to = orr_time_add_s(m->from, m->border_s[m->days]),
                                     .n_windows = m->days,
                                     .border_s = m->border_s,
                                     .n_arcs = n_sats * m->days,
                                     .arc = m->arc,
                                     .eop = eop,
                                     .hold = hold,
                                     .gravity_degree = 8,
                                     .jobs = jobs};
    orr_reference_fit f;
    orr_diag d = {0};
    ASSERT_OK(orr_reference_fit_run(&p, &f, &d), d);
    return f;
}

static double off_mas(const made *m, const orr_reference_fit *f, double t_s)
{
    const orr_time t = orr_time_add_s(m->from, t_s);
    const orr_eop a = orr_eop_at(&f->rotation, t, NULL, NULL), b = orr_eop_at(&m->eop, t, NULL, NULL);
    // 1 ms a day of LOD turns the Earth by 15 mas in a day
    return fmax(hypot(a.xp_rad - b.xp_rad, a.yp_rad - b.yp_rad) / MAS, 15e3 * fabs(a.lod_s - b.lod_s));
}

// The truth differs from the fit's curves by the zonal tides alone (their bend within a day is up to 0.03 ms
// in LOD, 0.01 mas a day), and priors pull by their share.
static void finds_the_rotation_and_the_pressure(void **state)
{
    (void)state;
    for (size_t days = 1; days <= 2; days++) {
        made m;
        make(&m, days);
        orr_reference_fit f = fit(&m, SATS, NULL, false, 1);
        assert_true(f.estimated);
        assert_int_equal(f.fitted, SATS * days);
        print_message("%zu d: %d passes, off %.4f mas, rms %.4f mm\n", days, f.passes, off_mas(&m, &f, 43200),
                      1e3 * f.rms_m);
        ASSERT_NEAR(off_mas(&m, &f, 43200), 0, 2e-3);
        ASSERT_NEAR(1e3 * f.rms_m, 0, 0.1);
        for (size_t i = 0; i < SATS * days; i++)
            for (int j = 0; j < 5; j++)
                ASSERT_NEAR(m.arc[i].ecom_nmps2[j], m.force[m.arc[i].sat].ecom_nmps2[j], 0.01);
        orr_reference_fit_free(&f);
        unmake(&m);
    }
}

// A day fitted to be carried on: pole and UT1 are straight lines in the truth, and what was integrated for a second day
// is met there. The length of day is told to 1e-4 ms, which is 0.2 mm a day later, times the two days of leverage.
static void goes_on_beyond_its_nodes(void **state)
{
    (void)state;
    made m;
    make(&m, 2);
    orr_reference_arc arc[SATS];
    for (size_t s = 0; s < SATS; s++) {
        arc[s] = m.arc[2 * s];
        arc[s].window = 1;
    }
    const double border_s[3] = {0, 86400, 172800};
    const orr_reference_problem p = {.from = m.from,
                                     .to = orr_time_add_s(m.from, 172800),
                                     .n_windows = 2,
                                     .border_s = border_s,
                                     .n_arcs = SATS,
                                     .arc = arc,
                                     .forecast = true,
                                     .forget_s = 86400,
                                     .gravity_degree = 8,
                                     .jobs = 1};
    orr_reference_fit f;
    orr_diag d = {0};
    ASSERT_OK(orr_reference_fit_run(&p, &f, &d), d);
    assert_true(f.estimated && f.fitted == SATS);
    for (int s = 0; s < SATS; s++) {
        orr_force force = m.force[s];
        memcpy(force.ecom_nmps2, arc[s].ecom_nmps2, sizeof force.ecom_nmps2);
        orr_integrator *it = NULL;
        ASSERT_OK(orr_integrator_init(&force, f.sky, &it, &d), d);
        double worst_mm = 0;
        for (int k = 1; k < 2 * (NODES - 1); k++) {
            const orr_reference_node *truth = &m.node[s][k / (NODES - 1)][k % (NODES - 1)];
            orr_sky_point at;
            ASSERT_OK(orr_integrate(it, truth->t_s - STEP_S, STEP_S, &arc[s].r_m, &arc[s].v_mps), d);
            orr_sky_force_point(f.sky, truth->t_s, &at);
            const orr_vec3 off = orr_vec3_sub(orr_mat3_apply(&at.R, arc[s].r_m), truth->ecef_m);
            worst_mm = fmax(worst_mm, 1e3 * orr_vec3_norm(off));
        }
        print_message("satellite %d: %.3f mm off at most\n", s, worst_mm);
        ASSERT_NEAR(worst_mm, 0, 3);
        orr_integrator_free(it);
    }
    orr_reference_fit_free(&f);
    arc[0].window = 0; // which a forecast does not have
    assert_int_equal(orr_reference_fit_run(&p, &f, &d), ORR_E_ARG);
    unmake(&m);
}

static void the_same_for_any_number_of_threads(void **state)
{
    (void)state;
    made m;
    make(&m, 1);
    orr_reference_arc kept[2 * SATS];
    orr_reference_fit one = fit(&m, SATS, NULL, false, 1);
    memcpy(kept, m.arc, sizeof kept);
    orr_reference_fit three = fit(&m, SATS, NULL, false, 3);
    assert_memory_equal(one.rotation.value, three.rotation.value,
                        one.rotation.n * sizeof *one.rotation.value);
    for (int i = 0; i < SATS; i++) assert_memory_equal(&kept[i].r_m, &m.arc[i].r_m, sizeof kept[i].r_m);
    orr_reference_fit_free(&one);
    orr_reference_fit_free(&three);
    unmake(&m);
}

// A given rotation that is right stays, and the correction told is nought; a wrong one stays as well when it
// is to be held, and the correction tells what it is off by.
static void a_given_rotation_is_judged(void **state)
{
    (void)state;
    made m;
    make(&m, 1);
    orr_reference_fit f = fit(&m, SATS, &m.eop, true, 1);
    ASSERT_NEAR(f.xp_rad / MAS, 0, 1e-3);
    ASSERT_NEAR(f.lod_s * 1e3, 0, 1e-4);
    ASSERT_NEAR(1e3 * f.rms_m, 0, 0.1);
    ASSERT_NEAR(off_mas(&m, &f, 43200), 0, 1e-6);
    orr_reference_fit_free(&f);
    for (size_t i = 0; i < m.eop.n; i++) m.eop.value[i].xp_rad += 5 * MAS;
    f = fit(&m, SATS, &m.eop, true, 1);
    ASSERT_NEAR(f.xp_rad / MAS, -5, 0.01);
    ASSERT_NEAR(f.yp_rad / MAS, 0, 0.01);
    ASSERT_NEAR(off_mas(&m, &f, 43200), 0, 1e-6); // it is held
    orr_reference_fit_free(&f);
    unmake(&m);
}

// Three wrong nodes, the first among them, in one satellite, and a push of another's in the middle of the
// day: the first ones are set aside, the second is no orbit, and neither moves the pole.
static void wrong_nodes_do_not_lead(void **state)
{
    (void)state;
    made m;
    make(&m, 1);
    m.node[0][0][0].ecef_m.x += 40;
    m.node[0][0][17].ecef_m.y -= 1.0;
    m.node[0][0][60].ecef_m.z += 3e5;
    for (int k = 50; k < NODES; k++) m.node[1][0][k].ecef_m.x += 500.0 * (k - 50);
    orr_reference_fit f = fit(&m, SATS, NULL, false, 1);
    print_message("off %.4f mas; %zu rejected, %.4f mm\n", off_mas(&m, &f, 43200), m.arc[0].rejected,
                  1e3 * m.arc[0].rms_m);
    assert_int_equal(m.arc[0].rejected, 3);
    assert_true(m.arc[0].fitted);
    assert_false(m.arc[1].fitted);
    ASSERT_NEAR(off_mas(&m, &f, 43200), 0, 5e-3);
    orr_reference_fit_free(&f);
    unmake(&m);
}

static void few_satellites_tell_no_rotation(void **state)
{
    (void)state;
    made m;
    make(&m, 1);
    orr_reference_fit f = fit(&m, 3, NULL, false, 1);
    assert_false(f.estimated);
    ASSERT_NEAR(f.xp_rad, 0, 0);
    orr_reference_fit_free(&f);
    unmake(&m);
}

static void refuses_windows_that_do_not_ascend(void **state)
{
    (void)state;
    const double border_s[] = {0, 0};
    const orr_reference_problem p = {
        .to = 1, .n_windows = 1, .border_s = border_s, .gravity_degree = 8, .jobs = 1};
    orr_reference_fit f;
    orr_diag d = {0};
    assert_int_equal(orr_reference_fit_run(&p, &f, &d), ORR_E_ARG);
}

// Columns of the variational step against differences of orbits integrated with changed state and
// coefficients.
static void partials_are_those_of_integrated_orbits(void **state)
{
    (void)state;
    made m;
    make(&m, 1);
    orr_integrator *it = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_integrator_init(&m.force[2], m.sky, &it, &d), d);
    const double h = 150, change[3] = {100, 0.1, 10}; // m, m/s, nm/s^2
    orr_orbit_step s = {
        .t_s = 30000, .h_s = h, .r0_m = m.r[2], .v0_mps = m.v[2], .r1_m = m.r[2], .v1_mps = m.v[2]};
    ASSERT_OK(orr_integrate(it, s.t_s, h, &s.r1_m, &s.v1_mps), d);
    double F[6][ORR_PARTIALS];
    orr_variational_step(&m.force[2], m.sky, &s, NULL, F);
    for (int c = 0; c < 6 + ORR_ECOM_TERMS; c++) {
        const double dx = change[c < 3 ? 0 : c < 6 ? 1 : 2];
        double end[2][6];
        for (int side = 0; side < 2; side++) {
            double y[6] = {s.r0_m.x, s.r0_m.y, s.r0_m.z, s.v0_mps.x, s.v0_mps.y, s.v0_mps.z};
            orr_force f = m.force[2];
            if (c < 6) y[c] += side ? dx : -dx;
            if (c >= 6) f.ecom_nmps2[c - 6] += side ? dx : -dx;
            orr_vec3 r = {y[0], y[1], y[2]}, v = {y[3], y[4], y[5]};
            orr_integrator_set(it, &f, ORR_INTEGRATE_MAX_STEP_S);
            ASSERT_OK(orr_integrate(it, s.t_s, h, &r, &v), d);
            const double out[6] = {r.x, r.y, r.z, v.x, v.y, v.z};
            memcpy(end[side], out, sizeof out);
        }
        for (int i = 0; i < 6; i++) {
            const double numeric = (end[1][i] - end[0][i]) / (2 * dx), mine = F[i][c < 6 ? c : c + 3];
            // of what a column is worth: rounding of 4e-9 m and 1e-12 m/s, harmonics beyond the flattening
            // 1e-8 of it
            const double of_state = (i < 3) == (c < 3) ? 1 : i < 3 ? h : 1 / h;
            const double of_ecom = i < 3 ? 1e-9 * h * h : 1e-9 * h;
            ASSERT_NEAR(mine, numeric, c < 6 ? 2e-8 * of_state : 2e-4 * of_ecom);
        }
    }
    orr_integrator_free(it);
    unmake(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(partials_are_those_of_integrated_orbits),
        cmocka_unit_test(finds_the_rotation_and_the_pressure),
        cmocka_unit_test(goes_on_beyond_its_nodes),
        cmocka_unit_test(the_same_for_any_number_of_threads),
        cmocka_unit_test(a_given_rotation_is_judged),
        cmocka_unit_test(wrong_nodes_do_not_lead),
        cmocka_unit_test(few_satellites_tell_no_rotation),
        cmocka_unit_test(refuses_windows_that_do_not_ascend),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

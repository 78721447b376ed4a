// SPDX-License-Identifier: GPL-3.0-or-later
// GPS almanacs: made orbits whose residual is a closed form, a receiver of the test's own behind the bits,
// and what is refused.
#include "testing.h"

#include "almanac_receiver.h"
#include "lnav_parity.h"
#include "made_orbit.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/lnav_bits.h"

#define HOUR (3600 * ORR_NS_PER_S)
#define J2 1.0826e-3
#define RE 6378137.0
#define GM 3.986005e14

static orr_time the_toa(void) { return orr_time_from_week(2300, INT64_C(84) * 4096 * ORR_NS_PER_S); }

// A near-circular orbit with what the Earth's flattening does to it at first order, and nothing else.
static orr_nav_eph flattened(double e, double u0)
{
    orr_nav_eph n = {.sat = orr_sat_make('G', 9), .kind = ORR_NAV_KEPLER, .message = ORR_NAV_LNAV};
    n.toe = n.toc = the_toa();
    const double a = 26.56e6, i = 55 * ORR_RAD_PER_DEG, c2 = cos(i) * cos(i), s2 = 1 - c2;
    const double k = J2 * RE * RE / (a * a), mean = sqrt(GM / (a * a * a));
    n.kepler = (orr_nav_kepler){.sqrt_a_sqrtm = sqrt(a),
                                .e = e,
                                .i0_rad = i,
                                .omega_rad = 0.8,
                                .m0_rad = u0 - 0.8,
                                .omega0_rad = 2.2,
                                .omega_dot_radps = -1.5 * k * mean * cos(i),
                                .delta_n_radps = 0.75 * k * mean * (3 * c2 - 1 + 5 * c2 - 1),
                                .crc_m = a * k * s2 / 4,
                                .cus_rad = k * s2 / 8,
                                .toe_sow_s = 84.0 * 4096};
    return n;
}

typedef struct span {
    orr_nav_eph eph;
    orr_time from, to; // nothing outside
} span;

static orr_status span_source(void *user, orr_time t, orr_vec3 *pos)
{
    const span *s = user;
    if (t < s->from || t > s->to) return ORR_E_NODATA;
    orr_broadcast_state st;
    orr_status status = orr_broadcast_eval(&s->eph, t, &st);
    if (status == ORR_OK) *pos = st.pos_m;
    return status;
}

// What the almanac cannot say is a radius smaller by 2/3 a delta_n/n than the mean motion's (524 m) and two
// terms in 2u (278 and 138 m): 0.57 km RMS. Apart from it the orbit is found, from a day as from two hours.
static void what_is_left_is_what_the_model_lacks(void **state)
{
    (void)state;
    for (int k = 0; k < 24; k++) {
        span s = {.eph = flattened(0.002, 0.5 * k)};
        const orr_nav_kepler *q = &s.eph.kepler;
        const double a = q->sqrt_a_sqrtm * q->sqrt_a_sqrtm, n = sqrt(GM / (a * a * a));
        const double radius = 2.0 / 3 * a * q->delta_n_radps / n,
                     want = sqrt(radius * radius +
                                 0.5 * (q->crc_m * q->crc_m + a * a * q->cus_rad * q->cus_rad));
        orr_time toa = the_toa(), half = k % 2 == 0 ? 12 * HOUR : HOUR;
        s.from = toa - half, s.to = toa + half;
        orr_almanac al;
        orr_navfit_report r;
        orr_diag d = {0};
        ASSERT_OK(orr_almanac_fit(s.eph.sat, toa, s.from, s.to, span_source, &s, &al, &r, &d), d);
        double sum = 0;
        for (int h = -12; h <= 12; h++) { // over the day, whatever the window was
            orr_vec3 pos;
            orr_broadcast_state st;
            assert_int_equal(almanac_receive(&al, toa, toa + h * HOUR, &pos, NULL), ORR_OK);
            assert_int_equal(orr_broadcast_eval(&s.eph, toa + h * HOUR, &st), ORR_OK);
            orr_vec3 diff = orr_vec3_sub(pos, st.pos_m);
            sum += orr_vec3_dot(diff, diff);
        }
        ASSERT_NEAR(sqrt(sum / 25), want, 0.05 * want); // e takes a tenth of what stands in 2u away from it
        ASSERT_NEAR(al.e, 0.002, 2e-6);
        ASSERT_NEAR(al.omega_dot_radps, q->omega_dot_radps, 3e-11); // LSB 1.1e-11: 30 m in half a day
        if (half == 12 * HOUR) ASSERT_NEAR(r.rms_m, want, 0.05 * want);
    }
}

// Circles have no perigee: whatever the search makes of it, e is none below zero and the orbit is met.
static void round_orbits_have_almanacs(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        span s = {.eph = flattened(2e-7 * (k % 8) + 1e-9 * k, 0.3 * k)};
        orr_time toa = the_toa();
        s.from = toa - 12 * HOUR, s.to = toa + 12 * HOUR;
        orr_almanac al;
        orr_navfit_report r;
        orr_diag d = {0};
        ASSERT_OK(orr_almanac_fit(s.eph.sat, toa, s.from, s.to, span_source, &s, &al, &r, &d), d);
        assert_true(al.e >= 0);
        ASSERT_NEAR(r.rms_m, 570, 30); // as above
    }
}

static uint32_t get(const orr_lnav_subframe *s, int first, int n)
{
    uint32_t v = 0;
    for (int k = first; k < first + n; k++) {
        int w = (k - 1) / 30, b = (k - 1) % 30;
        uint32_t star = w > 0 ? s->word[w - 1] & 1u : 0; // D30 of the word before turns the data over
        v = v << 1 | ((s->word[w] >> (29 - b) & 1u) ^ star);
    }
    return v;
}

static double get_signed(const orr_lnav_subframe *s, int first, int n)
{
    uint32_t v = get(s, first, n);
    return v >> (n - 1) ? (double)v - ldexp(1, n) : (double)v;
}

// A receiver: bits to position by the equations of 20.3.3.4.3 as table 20-VI reduces them.
static void receive(const orr_lnav_subframe *s, double t_sow, double pos[3], double *clock_s)
{
    const double pi = 3.1415926535898, e = ldexp(get(s, 69, 16), -21), toa = 4096.0 * get(s, 91, 8);
    const double i = pi * (0.30 + ldexp(get_signed(s, 99, 16), -19));
    const double node_rate = pi * ldexp(get_signed(s, 121, 16), -38), root_a = ldexp(get(s, 151, 24), -11);
    const double node = pi * ldexp(get_signed(s, 181, 24), -23),
                 omega = pi * ldexp(get_signed(s, 211, 24), -23);
    const double m0 = pi * ldexp(get_signed(s, 241, 24), -23), rate = 7.2921151467e-5, a = root_a * root_a;
    double tk = t_sow - toa;
    if (tk > 302400) tk -= 604800;
    if (tk < -302400) tk += 604800;
    const double m = m0 + sqrt(GM / (a * a * a)) * tk;
    double E = m;
    for (int k = 0; k < 20; k++) E = m + e * sin(E);
    const double u = atan2(sqrt(1 - e * e) * sin(E), cos(E) - e) + omega, r = a * (1 - e * cos(E));
    const double L = node + (node_rate - rate) * tk - rate * toa, x = r * cos(u), y = r * sin(u);
    pos[0] = x * cos(L) - y * cos(i) * sin(L);
    pos[1] = x * sin(L) + y * cos(i) * cos(L);
    pos[2] = y * sin(i);
    double af0 = get(s, 271, 8) * 8 + get(s, 290, 3);
    if (af0 >= 1024) af0 -= 2048;
    *clock_s = ldexp(af0, -20) + ldexp(get_signed(s, 279, 11), -38) * tk;
}

static void bits_say_what_was_fitted(void **state)
{
    (void)state;
    for (int k = 0; k < 40; k++) {
        span s = {.eph = flattened(0.001 * k * 0.7, 0.37 * k), .from = INT64_MIN, .to = INT64_MAX};
        orr_almanac al;
        orr_navfit_report r;
        orr_diag d = {0};
        orr_time toa = the_toa();
        ASSERT_OK(
            orr_almanac_fit(s.eph.sat, toa, toa - 12 * HOUR, toa + 12 * HOUR, span_source, &s, &al, &r, &d),
            d);
        al.af0_s = ldexp(100 - 17 * k, -20), al.af1_sps = ldexp(5 * k - 90, -38);
        orr_lnav_how how = {.tow_count = 100};
        orr_lnav_subframe bits;
        int subframe, page;
        ASSERT_OK(orr_lnav_encode_almanac(&al, &how, &subframe, &page, &bits, &d), d);
        assert_true(lnav_parity_holds(&bits));
        for (int h = -60; h <= 60; h += 5) { // the week begins and ends on the way
            orr_time t = toa + h * HOUR;
            int32_t week;
            int64_t ns;
            orr_time_week(t, &week, &ns);
            double want[3], clock = 0, want_clock;
            orr_vec3 pos;
            assert_int_equal(almanac_receive(&al, toa, t, &pos, &clock), ORR_OK);
            receive(&bits, (double)ns * 1e-9, want, &want_clock);
            // pi of 13 digits times thousands of LSBs, and rounding: micrometres.
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(pos, (orr_vec3){want[0], want[1], want[2]})), 0, 1e-4);
            ASSERT_NEAR(clock, want_clock, 1e-15);
        }
    }
}

static void little_data_and_odd_orbits_are_told(void **state)
{
    (void)state;
    orr_time toa = the_toa();
    span s = {.eph = flattened(0.01, 1), .from = toa, .to = toa + 7080 * ORR_NS_PER_S};
    orr_almanac al;
    orr_navfit_report r;
    orr_diag d = {0};
    const orr_time from = toa - 12 * HOUR, to = toa + 12 * HOUR;
#define FIT(sat, toa, from, to) orr_almanac_fit(sat, toa, from, to, span_source, &s, &al, &r, &d)
    s.to = toa + 90 * 60 * ORR_NS_PER_S;
    assert_int_equal(FIT(s.eph.sat, toa, from, to), ORR_E_NODATA);
    s.to = toa + 2 * HOUR; // two hours of the day, anywhere in it
    ASSERT_OK(FIT(s.eph.sat, toa, from, to), d);
    s.from += 5 * HOUR + 777 * ORR_NS_PER_S, s.to += 5 * HOUR + 777 * ORR_NS_PER_S;
    ASSERT_OK(FIT(s.eph.sat, toa, from, to), d);
    ASSERT_OK(FIT(s.eph.sat, toa, s.from, s.to), d);
    s.from = INT64_MIN, s.to = INT64_MAX;
    assert_int_equal(FIT(s.eph.sat, toa + 16 * ORR_NS_PER_S, from, to), ORR_E_ARG);
    assert_int_equal(FIT(orr_sat_make('G', 33), toa, from, to), ORR_E_ARG);
    assert_int_equal(FIT(orr_sat_make('R', 3), toa, from, to), ORR_E_ARG);
    assert_int_equal(FIT(s.eph.sat, toa, from, from + HOUR), ORR_E_ARG);
    assert_int_equal(FIT(s.eph.sat, toa, from, from + 27 * HOUR), ORR_E_ARG);
    s.eph = flattened(0.04, 1); // e has 16 bits of 2^-21
    assert_int_equal(FIT(s.eph.sat, toa, from, to), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "e = 0.0"));
#undef FIT
    al.sqrt_a_sqrtm = 0;
    orr_vec3 pos;
    assert_int_equal(almanac_receive(&al, toa, toa, &pos, NULL), ORR_E_NUMERIC);
}

static void clocks_are_lines(void **state)
{
    (void)state;
    orr_orbit_solution sol = made_solution(4, 24, 3600, 12);
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_ephemeris_build(&sol, &e, &d), d);
    const made_satellite m = made_satellite_at(0);
    int32_t week;
    int64_t ns;
    orr_time_week(made_midnight + 12 * HOUR, &week, &ns);
    orr_time toa = orr_time_from_week(week, ns / (4096 * ORR_NS_PER_S) * 4096 * ORR_NS_PER_S);
    static const int hours[] = {2, 24};
    for (int k = 0; k < 2; k++) {
        orr_almanac al = {.number = 1};
        double rms = -1;
        ASSERT_OK(
            orr_almanac_clock(e, m.sat, toa, made_midnight, made_midnight + hours[k] * HOUR, &al, &rms, &d),
            d);
        ASSERT_NEAR(al.af1_sps, 2e-11, ldexp(0.51, -38));
        ASSERT_NEAR(rms, 0, 0.52 * ldexp(1, -20) + 1e-7); // half an LSB, and af1's over half a day
        double lsb = ldexp(1, -20);
        ASSERT_NEAR(al.af0_s / lsb, round(al.af0_s / lsb), 0);
        double at_window = al.af0_s + al.af1_sps * orr_time_diff_s(made_midnight + hours[k] * HOUR / 2, toa);
        ASSERT_NEAR(at_window, made_clock(&m, 1800.0 * hours[k]), 0.51 * lsb);
    }
    orr_almanac al = {.number = 1};
    assert_int_equal(
        orr_almanac_clock(e, orr_sat_make('G', 31), toa, made_midnight, made_midnight + HOUR, &al, NULL, &d),
        ORR_E_NODATA);
    orr_ephemeris_free(e);
    made_solution_free(&sol);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_orbits_have_almanacs), cmocka_unit_test(what_is_left_is_what_the_model_lacks),
        cmocka_unit_test(bits_say_what_was_fitted), cmocka_unit_test(little_data_and_odd_orbits_are_told),
        cmocka_unit_test(clocks_are_lines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks of published files: what lies between nodes and its sigma against nodes that were withheld, clocks of 30 s
// beside orbits of another centre, ultra-rapid files that overlap.
#include "testing.h"

#include "core/robust.h"
#include "orbit/clock/clock_between.h"
#include "orbit/ephemeris/ephemeris.h"
#include "orbit/judge/compare_clocks.h"
#include "read_file.h"
#include "real_orbit.h"

READ_FILE_BY_PARSER(clk)

#define COD "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"
#define GRG "2024-035/GRG0MGXFIN_20240350000_01D_05M_ORB.SP3.gz"

// Clocks do not depend on how orbits are smoothed: the quickest way will do.
static orr_smoother_options quick(void)
{
    orr_smoother_options o = orr_smoother_defaults();
    o.reference = false;
    o.passes = 1;
    return o;
}

static orr_ephemeris *product(const real_files *f, const orr_smoother_options *o)
{
    orr_orbit_solution s;
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(f->input, f->n, o, NULL, NULL, &s, NULL, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_orbit_solution_free(&s);
    return e;
}

// Of each system the RMS of the error over sigma of withheld nodes, less the epoch's median: from both sides. Accuracy is
// what linear interpolation of a quarter or half an hour has (README).
static void sigma_of_clocks_is_honest(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double nodes_s, most_ns[4]; // of G, R, E, C; 0: no bar
    } set[] = {{COD, 900, {0.14, 0.20, 0.035, 0}},
               {COD, 1800, {0.17, 0.27, 0.05, 0}},
               {GRG, 900, {0.14, 0.20, 0.035, 0.045}},
               {"2020-177/GRG0MGXFIN_20201770000_01D_15M_ORB.SP3.gz", 1800, {0.19, 0.25, 0.02, 0}},
               {"2010-182/igs15904.sp3.gz", 1800, {0.32, 0, 0, 0}},
               {"2009-265/igs15503.sp3.gz", 1800, {0.32, 0, 0, 0}}};
    for (size_t k = 0; k < sizeof set / sizeof *set; k++) {
        real_files f;
        if (!real_open(&set[k].name, 1, &f)) SKIP_NO_DATA(set[k].name);
        orr_smoother_options o = quick();
        o.node_step_s = set[k].nodes_s;
        orr_ephemeris *e = product(&f, &o);
        orr_clock_comparison x;
        orr_diag d = {0};
        ASSERT_OK(orr_compare_clocks(e, f.sp3, 1, NULL, false, &x, &d), d);
        for (size_t i = 0; i < x.n_systems; i++) {
            const orr_clock_stats *s = &x.system[i];
            const char *at = strchr("GREC", s->system);
            if (at == NULL) continue;
            const double most_ns = set[k].most_ns[at - "GREC"];
            print_message("%.30s %4.0f s %c: %.4f ns RMS, error/sigma %.2f\n", set[k].name, set[k].nodes_s,
                          s->system, 1e9 * s->rms_s, s->ratio);
            assert_true(s->n > 500);
            assert_true(s->ratio > 0.5 && s->ratio < 1.5);
            if (most_ns > 0) assert_true(1e9 * s->rms_s < most_ns);
        }
        assert_true(x.n_systems >= 1);
        orr_clock_comparison_free(&x);
        orr_ephemeris_free(e);
        real_close(&f);
    }
}

// Kinds of clocks of 2024-02-04: GPS' blocks as the operational advisories list them.
enum { IIF, III, IIR, GLONASS, GALILEO, KINDS };
static const char *const kind_name[KINDS] = {"GPS IIF", "GPS III", "GPS IIR, IIR-M", "GLONASS", "Galileo"};
static int kind_of(orr_sat sat)
{
    static const int iif[] = {1, 3, 6, 8, 9, 10, 24, 25, 26, 27, 30, 32}, iii[] = {4, 11, 14, 18, 23, 28};
    if (orr_sat_system(sat) != 'G') return orr_sat_system(sat) == 'R' ? GLONASS : GALILEO;
    for (size_t i = 0; i < sizeof iif / sizeof *iif; i++)
        if (orr_sat_number(sat) == iif[i]) return IIF;
    for (size_t i = 0; i < sizeof iii / sizeof *iii; i++)
        if (orr_sat_number(sat) == iii[i]) return III;
    return IIR;
}

enum { LINE, ROUNDED, CUBIC, SMOOTHED, METHODS };

// What each way says a part p of the way from node y[1] to y[2], all a step apart.
static void between(const double y[4], double p, double out[METHODS])
{
    const double s[3] = {y[1] - y[0], y[2] - y[1], y[3] - y[2]};
    const orr_clock_interval way = {.length_s = 1,
                                    .clock_s = y[1],
                                    .rate_sps = s[1],
                                    .bend_first_sps = 0.5 * (s[0] - s[1]),
                                    .bend_last_sps = 0.5 * (s[2] - s[1])};
    double rate;
    out[LINE] = y[1] + p * s[1];
    orr_clock_interval_at(&way, &p, &out[ROUNDED], &rate);
    // Monotone cubic (Fritsch and Carlson 1980 with harmonic means).
    const double d0 = s[0] * s[1] > 0 ? 2 * s[0] * s[1] / (s[0] + s[1]) : 0,
                 d1 = s[1] * s[2] > 0 ? 2 * s[1] * s[2] / (s[1] + s[2]) : 0, q = 1 - p;
    out[CUBIC] = (1 + 2 * p) * q * q * y[1] + p * q * q * d0 + p * p * (3 - 2 * p) * y[2] - p * p * q * d1;
    // The line through nodes of which a tenth went to each neighbour: what white noise would ask for.
    out[SMOOTHED] = q * (0.8 * y[1] + 0.1 * (y[0] + y[2])) + p * (0.8 * y[2] + 0.1 * (y[1] + y[3]));
}

// Nodes of half an hour, 5-minute clocks between them. The rounded line costs the noisiest clocks less than a per cent
// and no other anything; curves that leave the line further cost more, and smoothing gains with white noise alone.
static void the_line_is_the_best_between_nodes(void **state)
{
    (void)state;
    static const char *const name = COD;
    real_files f;
    if (!real_open(&name, 1, &f)) SKIP_NO_DATA(name);
    const orr_sp3 *sp3 = &f.sp3[0];
    enum { EVERY = 6 };
    double sum2[KINDS][METHODS] = {{0}};
    size_t n[KINDS] = {0};
    for (size_t k = 0; k < sp3->n_sats; k++)
        for (size_t i = EVERY; i + 2 * EVERY < sp3->n_epochs; i += EVERY) {
            double y[4], at[METHODS];
            for (size_t j = 0; j < 4; j++)
                y[j] = sp3->record[(i + j * EVERY - EVERY) * sp3->n_sats + k].clock_s;
            for (size_t j = 1; j < EVERY; j++) {
                const double c = sp3->record[(i + j) * sp3->n_sats + k].clock_s;
                between(y, (double)j / EVERY, at);
                if (!isfinite(c + y[0] + y[1] + y[2] + y[3])) continue;
                const int kind = kind_of(sp3->sat[k]);
                n[kind]++;
                for (int m = 0; m < METHODS; m++) sum2[kind][m] += (at[m] - c) * (at[m] - c);
            }
        }
    for (int kind = 0; kind < KINDS; kind++) {
        double rms[METHODS];
        assert_true(n[kind] > 1000);
        for (int m = 0; m < METHODS; m++) rms[m] = 1e9 * sqrt(sum2[kind][m] / (double)n[kind]);
        print_message(
            "%-14s line %.4f, rounded line %.4f, monotone cubic %.4f, line through smoothed nodes %.4f ns\n",
            kind_name[kind], rms[LINE], rms[ROUNDED], rms[CUBIC], rms[SMOOTHED]);
        assert_true(rms[ROUNDED] < 1.01 * rms[LINE] && rms[ROUNDED] < rms[CUBIC]);
        if (kind == GLONASS || kind == GALILEO) assert_true(rms[SMOOTHED] > rms[LINE]);
    }
    real_close(&f);
}

// RMS over satellites and epochs of the product's clocks less those of a CLK file, the epoch's median taken away; and of
// that over sigma, between nodes.
static double off_clk(const orr_ephemeris *e, const orr_clk *clk, int64_t step_s, double *ratio)
{
    double sum2 = 0, ratio2 = 0;
    size_t n = 0, n_ratio = 0;
    for (size_t k = 0; k < clk->n_epochs; k++) {
        const orr_time t = clk->epoch[k];
        double off[128], room[128], sigma[128];
        size_t m = 0;
        if (t % (step_s * ORR_NS_PER_S) != 0) continue;
        for (size_t i = 0; i < clk->n_sats && m < 128; i++) {
            const orr_clk_series *c = &clk->sat[i];
            orr_sat_state s;
            size_t low = 0, high = c->n;
            while (low < high) {
                const size_t mid = low + (high - low) / 2;
                if (c->record[mid].t < t)
                    low = mid + 1;
                else
                    high = mid;
            }
            if (low == c->n || c->record[low].t != t || orr_ephemeris_eval(e, c->sat, t, &s) != ORR_OK)
                continue;
            if ((s.flags & ORR_EPH_CLOCK_VALID) == 0) continue;
            sigma[m] = (double)s.clock_sigma_s;
            off[m++] = s.clock_s - c->record[low].bias_s;
        }
        if (m < 5) continue;
        memcpy(room, off, sizeof off);
        const double median = orr_median(room, m);
        for (size_t i = 0; i < m; i++) {
            const double x = off[i] - median;
            sum2 += x * x;
            if (!(sigma[i] > 1e-12)) continue;
            ratio2 += x * x / (sigma[i] * sigma[i]);
            n_ratio++;
        }
        n += m;
    }
    assert_true(n > 5000);
    *ratio = n_ratio > 0 ? sqrt(ratio2 / (double)n_ratio) : (double)NAN;
    return sqrt(sum2 / (double)n);
}

// Takes all records away that are no multiples of a step.
static void thin(orr_clk *clk, int64_t step_s)
{
    for (size_t i = 0; i < clk->n_sats; i++) {
        orr_clk_series *c = &clk->sat[i];
        size_t n = 0;
        for (size_t k = 0; k < c->n; k++)
            if (c->record[k].t % (step_s * ORR_NS_PER_S) == 0) c->record[n++] = c->record[k];
        c->n = n;
    }
}

// CODE's orbits with Wuhan's clocks of 30 s: they are aligned, told, and followed; with SP3's clocks alone, a quarter of
// an hour apart, what lies between is off by what a quarter of an hour costs and what the centres differ by.
static void clocks_of_another_centre_are_followed(void **state)
{
    (void)state;
    static const char *const sp3 = "2008-279/COD15000.EPH.Z";
    char path[512];
    real_files f;
    if (!real_open(&sp3, 1, &f) || !orr_test_data("2008-279/whp15000.clk.Z", path, sizeof path))
        SKIP_NO_DATA(sp3);
    orr_clk clk;
    orr_diag d = {0};
    ASSERT_OK(read_clk(path, NULL, &clk, NULL, &d), d);
    orr_smoother_options o = quick();
    orr_ephemeris *alone = product(&f, &o);
    const orr_smoother_clk in = {.clk = &clk, .name = "whp15000.clk.Z"};
    o.clk = &in;
    o.n_clk = 1;
    orr_orbit_solution s;
    orr_ephemeris *e = NULL;
    orr_warnings w = {0};
    ASSERT_OK(orr_smoother_run(f.input, f.n, &o, NULL, NULL, &s, NULL, &w, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    bool told = false;
    for (size_t i = 0; i < w.kept; i++) told = told || strstr(w.item[i].text, "referred otherwise") != NULL;
    assert_true(told);
    // Wuhan's reference clock makes saw teeth of 29 ns between 01:28 and 01:36: events of the reference, of no satellite.
    const orr_clock_event *event;
    const size_t n = orr_ephemeris_clock_events(e, &event);
    assert_true(n > 5);
    for (size_t i = 0; i < n; i++) assert_int_equal(event[i].kind, ORR_CLOCK_EVENT_REFERENCE);
    double ratio;
    const double with = off_clk(e, &clk, 30, &ratio), without = off_clk(alone, &clk, 450, &ratio);
    print_message("with 30-s clocks %.4f ns, with 15-min clocks %.3f ns\n", 1e9 * with, 1e9 * without);
    assert_true(with < 1e-12 && without > 0.2e-9 && without < 0.5e-9);
    // Of the same clocks every fifth minute, and the rest as truth: no centres differ here.
    orr_clk five;
    ASSERT_OK(read_clk(path, NULL, &five, NULL, &d), d);
    thin(&five, 300);
    const orr_smoother_clk in_five = {.clk = &five, .name = "five"};
    o.clk = &in_five;
    orr_ephemeris *thinned = product(&f, &o);
    const double between_s = off_clk(thinned, &clk, 30, &ratio);
    print_message("with 5-min clocks of 30-s ones %.3f ns, error/sigma %.2f\n", 1e9 * between_s, ratio);
    assert_true(between_s < 0.2e-9 && ratio > 0.5 && ratio < 1.5);
    orr_ephemeris_free(thinned);
    orr_clk_free(&five);
    // Mean of the product's clocks stays CODE's.
    double shift = 0;
    size_t m = 0;
    for (size_t i = 0; i < s.n_sats; i++)
        for (int k = 1; k < 24; k++) {
            orr_sat_state a, b;
            const orr_time t = orr_time_add_s(f.sp3[0].epoch[0], 3600.0 * k);
            if (orr_ephemeris_eval(e, s.sat[i].sat, t, &a) != ORR_OK || !isfinite(a.clock_s)) continue;
            if (orr_ephemeris_eval(alone, s.sat[i].sat, t, &b) != ORR_OK || !isfinite(b.clock_s)) continue;
            shift += a.clock_s - b.clock_s;
            m++;
        }
    assert_true(m > 600);
    ASSERT_NEAR(shift / (double)m, 0, 0.2e-9); // 20 ns without
    orr_warnings_free(&w);
    orr_orbit_solution_free(&s);
    orr_ephemeris_free(alone);
    orr_ephemeris_free(e);
    orr_clk_free(&clk);
    real_close(&f);
}

// Two ultra-rapids twelve hours apart, in either order: what they predict is the newer one's, and clocks come from one
// file at a time.
static void of_two_ultra_rapids_the_newer_predicts(void **state)
{
    (void)state;
    static const char *const name[3] = {"ultra/igu16295_00.sp3.gz", "ultra/igu16295_12.sp3.gz",
                                        "ultra/igu16295_00.sp3.gz"};
    real_files f[3];
    const orr_smoother_options o = quick();
    orr_ephemeris *e[3];
    for (int k = 0; k < 3; k++) { // 00 and 12, 12 and 00, 12 alone
        if (!real_open(&name[k < 2 ? k : 1], k < 2 ? 2 : 1, &f[k])) SKIP_NO_DATA(name[k]);
        e[k] = product(&f[k], &o);
    }
    const orr_sat *sat;
    const size_t n = orr_ephemeris_satellites(e[2], &sat);
    const orr_time noon =
        f[2].sp3[0].epoch[0] + INT64_C(86400) * ORR_NS_PER_S; // the 12 h file observed until then
    double largest_m = 0;
    for (size_t i = 0; i < n; i++)
        for (orr_time t = noon + 3600 * ORR_NS_PER_S; t < noon + INT64_C(84000) * ORR_NS_PER_S;
             t += 450 * ORR_NS_PER_S) {
            orr_sat_state s[3];
            for (int k = 0; k < 3; k++) assert_int_equal(orr_ephemeris_eval(e[k], sat[i], t, &s[k]), ORR_OK);
            assert_memory_equal(&s[0].pos_m, &s[1].pos_m, sizeof s[0].pos_m);
            assert_memory_equal(&s[0].clock_s, &s[1].clock_s, sizeof s[0].clock_s);
            largest_m = fmax(largest_m, orr_vec3_norm(orr_vec3_sub(s[0].pos_m, s[2].pos_m)));
            assert_true(isnan(s[2].clock_s) ? isnan(s[0].clock_s) : s[0].clock_s == s[2].clock_s);
            if (isfinite(s[0].clock_s)) assert_true((s[0].flags & ORR_EPH_PREDICTED) != 0);
        }
    print_message("predicted hours of both files against the newer alone: %.4f m at most\n", largest_m);
    assert_true(largest_m < 0.01);
    for (int k = 0; k < 3; k++) {
        orr_ephemeris_free(e[k]);
        real_close(&f[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(sigma_of_clocks_is_honest),
                                       cmocka_unit_test(the_line_is_the_best_between_nodes),
                                       cmocka_unit_test(clocks_of_another_centre_are_followed),
                                       cmocka_unit_test(of_two_ultra_rapids_the_newer_predicts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

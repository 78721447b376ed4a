// SPDX-License-Identifier: GPL-3.0-or-later
// Group delays of CODE's and GRG's biases of 2024-02-04 against what GPS and each other say.
#include "testing.h"

#include "orbit/spacecraft/signal_delay.h"

#define COD "2024-035/COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz"
#define GRG "2024-035/GRG0MGXFIN_20240350000_01D_01D_OSB.BIA.gz"
#define NAV "2024-035/BRDC00CNE_R_20240350000_01D_GN.rnx.gz"

static bool open_bias(const char *name, orr_bias_set *x)
{
    char path[512];
    orr_diag d = {0};
    if (!orr_test_data(name, path, sizeof path)) return false;
    ASSERT_OK(orr_bias_read(path, NULL, x, NULL, &d), d);
    return true;
}

typedef struct spread {
    int n;
    double mean, rms, max; // about the mean
} spread;

static spread spread_of(const double *x, int n)
{
    spread s = {.n = n};
    for (int i = 0; i < n; i++) s.mean += x[i] / n;
    for (int i = 0; i < n; i++) {
        s.rms += (x[i] - s.mean) * (x[i] - s.mean) / n;
        s.max = fmax(s.max, fabs(x[i] - s.mean));
    }
    s.rms = sqrt(s.rms);
    return s;
}

// Block III differs from the other blocks by a constant: 2 to 3 ns in TGD, 5 between the centres; within a
// block all agree. That is what the data show, and why blocks are judged each about its own mean. The cause
// is inferred: both centres' files say that they applied the antennas' offsets by frequency (CODE:
// SATELLITE_ANTENNA_PCC_APPLIED_TO_MW_LC, GRG: "WITH applying antenna PCOs"), which matters where L1 and L2
// have different ones, and the two constants have opposite signs. No ANTEX file with Block III is here to
// try it.
static bool is_block_iii(const orr_bias_set *x, orr_sat sat)
{
    for (size_t i = 0; i < x->n; i++)
        if (x->bias[i].sat == sat && x->bias[i].svn[0] == 'G') return atoi(x->bias[i].svn + 1) >= 74;
    return false;
}

// The control segment's TGD and the IGS' biases agree up to one constant: either side may add the same to all
// satellites' L1 - L2 delays, because receivers' own delays absorb it. Per satellite TGD is sent in steps of
// 2^-31 s = 0.47 ns (0.13 ns RMS) and renewed once a quarter, biases are good to 0.1 or 0.2 ns: 0.5 ns RMS is
// fair. TGD itself spreads by 7 ns, so that a wrong sign or factor would show as nanoseconds.
static void tgd_agrees_with_the_control_segment(void **state)
{
    (void)state;
    static const char *const files[] = {COD, GRG};
    orr_nav nav;
    orr_diag d = {0};
    char path[512];
    if (!orr_test_data(NAV, path, sizeof path)) {
        SKIP_NO_DATA(NAV);
        return;
    }
    ASSERT_OK(orr_nav_read(path, NULL, &nav, NULL, &d), d);
    orr_time noon;
    ASSERT_OK(orr_time_parse("2024-02-04T12:00", NULL, &noon, &d), d);
    const orr_broadcast_choice choice = orr_broadcast_choice_default();
    for (int f = 0; f < 2; f++) {
        orr_bias_set x;
        if (!open_bias(files[f], &x)) continue;
        double difference_ns[2][32], sent_ns[32];
        int n[2] = {0, 0}, all = 0;
        for (int k = 1; k <= 32; k++) {
            const orr_sat sat = orr_sat_make('G', k);
            const orr_nav_eph *eph = orr_broadcast_select(&nav, sat, noon, &choice);
            const int block = is_block_iii(&x, sat);
            double tgd, sent;
            if (eph == NULL || orr_signal_tgd(&x, sat, noon, &tgd) != ORR_OK) continue;
            assert_int_equal(orr_signal_delay_broadcast(eph, "1W", &sent), ORR_OK);
            sent_ns[all++] = sent * 1e9;
            difference_ns[block][n[block]++] = (tgd - sent) * 1e9;
        }
        const spread tgd = spread_of(sent_ns, all);
        for (int block = 0; block < 2; block++) {
            const spread s = spread_of(difference_ns[block], n[block]);
            print_message(
                "%.3s, TGD of biases less that sent, %s: %d satellites, constant %.2f ns, scatter %.2f "
                "ns RMS, %.2f ns at most (TGD itself: %.2f ns RMS)\n",
                x.agency, block ? "Block III" : "Blocks IIR and IIF", s.n, s.mean, s.rms, s.max, tgd.rms);
            assert_true(n[block] >= (block ? 5 : 24));
            ASSERT_NEAR(s.rms, 0, 0.5);
        }
        assert_true(tgd.rms > 4);
        orr_bias_free(&x);
    }
    orr_nav_free(&nav);
}

// Who takes the file's biases off what is simulated with these delays is left with one number for a satellite, whatever signal and
// whether code or carrier: it is the pair's own combination, which the clock has.
static void codes_and_carriers_have_one_clock(void **state)
{
    (void)state;
    static const char *const files[] = {COD, GRG};
    static const char *const names[] = {"L1P", "L2P"};
    orr_bias_set x;
    int tried = 0;
    for (int f = 0; f < 2; f++) {
        if (!open_bias(files[f], &x)) {
            SKIP_NO_DATA(files[f]);
            return;
        }
        const orr_time t = x.from + 43200 * ORR_NS_PER_S;
        for (int k = 1; k <= 32; k++) {
            const orr_sat sat = orr_sat_make('G', k);
            double left[4], bias;
            int n = 0;
            for (int j = 0; j < 2; j++) {
                const orr_signal *s = orr_signal_find('G', names[j]);
                char code[4] = {'C', s->observation[0], s->observation[1], '\0'},
                     phase[4] = {'L', s->observation[0], s->observation[1], '\0'};
                double delay;
                if (orr_signal_delay_of(&x, sat, s, t, &delay) == ORR_OK &&
                    orr_bias_osb(&x, sat, code, t, &bias) == ORR_OK)
                    left[n++] = delay - bias;
                if (orr_signal_phase_of(&x, sat, s, t, &delay) == ORR_OK &&
                    orr_bias_osb(&x, sat, phase, t, &bias) == ORR_OK)
                    left[n++] = delay - bias;
            }
            for (int j = 1; j < n; j++) ASSERT_NEAR(left[j], left[0], 1e-15);
            tried += n == 4;
        }
        orr_bias_free(&x);
    }
    assert_true(tried > 50);
}

// Two centres: one constant (their receivers' datum) and noise. TGD is 1.55 times, L2's delay 2.55 times the
// difference of two biases of 0.1 to 0.2 ns each. Galileo's scatter more, by 0.6 ns in 1C and 1.79 times that
// in 5Q (the ratio of a difference in E1 - E5a), satellite by satellite: supposedly antennas again, whose E1
// and E5a centres differ from one satellite to the next; not tried either. The delays themselves spread by
// 4 ns and more.
static void centres_agree(void **state)
{
    (void)state;
    static const struct {
        char system;
        const char *signal;
        double tolerance_ns;
    } k[] = {{'G', "1W", 0.5}, {'G', "2W", 0.8}, {'G', "1C", 0.5}, {'E', "1C", 0.9}, {'E', "5Q", 1.6}};
    orr_bias_set a, b;
    orr_time noon;
    if (!open_bias(COD, &a)) {
        SKIP_NO_DATA(COD);
        return;
    }
    if (!open_bias(GRG, &b)) {
        orr_bias_free(&a);
        SKIP_NO_DATA(GRG);
        return;
    }
    assert_int_equal(orr_time_parse("2024-02-04T12:00", NULL, &noon, NULL), ORR_OK);
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        double difference_ns[64];
        int n = 0;
        for (int p = 1; p <= 40; p++) {
            const orr_sat sat = orr_sat_make(k[i].system, p);
            double first, second;
            if (!is_block_iii(&a, sat) &&
                orr_signal_delay_osb(&a, sat, k[i].signal, noon, &first) == ORR_OK &&
                orr_signal_delay_osb(&b, sat, k[i].signal, noon, &second) == ORR_OK)
                difference_ns[n++] = (first - second) * 1e9;
        }
        const spread s = spread_of(difference_ns, n);
        print_message(
            "%c %s, CODE less GRG: %d satellites, constant %.2f ns, scatter %.2f ns RMS, %.2f ns at "
            "most\n",
            k[i].system, k[i].signal, s.n, s.mean, s.rms, s.max);
        assert_true(n >= 24);
        ASSERT_NEAR(s.rms, 0, k[i].tolerance_ns);
    }
    orr_bias_free(&a);
    orr_bias_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tgd_agrees_with_the_control_segment),
        cmocka_unit_test(codes_and_carriers_have_one_clock),
        cmocka_unit_test(centres_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Observations of a real station: code, phase and Doppler must tell one story, and what the writer makes of
// them must read back the same.
#include "testing.h"

#include <unistd.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/rinex/rinex_obs.h"

#define L1_HZ 1575.42e6
#define L2_HZ 1227.60e6

typedef struct track {
    orr_time t;
    double code_m, phase_m, gf_m;
} track;

// Station BOR1, 2024-035: GPS C1C and L1C, C2W and L2W.
static void code_and_phase_agree(void **state)
{
    (void)state;
    const char *name = "2024-035/BOR100POL_R_20240350000_01D_30S_MO.crx.gz";
    char path[1024];
    if (!orr_test_data(name, path, sizeof path)) SKIP_NO_DATA(name);
    orr_rinex_obs *r = NULL;
    orr_diag diag = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_rinex_obs_open(path, NULL, &w, &r, &diag), diag);
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(r);
    int c1 = orr_obs_code_index(h, 'G', "C1C"), l1 = orr_obs_code_index(h, 'G', "L1C");
    int c2 = orr_obs_code_index(h, 'G', "C2W"), l2 = orr_obs_code_index(h, 'G', "L2W"),
        s1 = orr_obs_code_index(h, 'G', "S1C");
    assert_true(c1 >= 0 && l1 >= 0 && c2 >= 0 && l2 >= 0 && s1 >= 0);
    track last[100];
    for (size_t i = 0; i < 100; i++) last[i].t = ORR_TIME_NONE;
    size_t n = 0, n_steps = 0, n_rough = 0, n_slips = 0;
    double sum2 = 0;
    const orr_rinex_obs_epoch *e = NULL;
    for (;;) {
        ASSERT_OK(orr_rinex_obs_next(r, &e, &diag), diag);
        if (e == NULL) break;
        for (size_t i = 0; i < e->n_sats; i++) {
            if (orr_sat_system(e->sat[i]) != 'G') continue;
            const double *v = e->value + i * e->stride;
            if (isnan(v[c1]) || isnan(v[l1])) continue;
            assert_true(v[c1] > 19.5e6 &&
                        v[c1] < 26.5e6); // from zenith to horizon, whatever the receiver's clock
            assert_true(isnan(v[s1]) || (v[s1] > 10 && v[s1] < 65));
            if (!isnan(v[c2])) assert_true(fabs(v[c2] - v[c1]) < 60); // ionosphere and code biases
            track now = {e->t, v[c1], v[l1] * ORR_LIGHT_MPS / L1_HZ,
                         isnan(v[l2]) ? ORR_NAN
                                      : v[l1] * ORR_LIGHT_MPS / L1_HZ - v[l2] * ORR_LIGHT_MPS / L2_HZ};
            track *b = &last[orr_sat_number(e->sat[i])];
            if (b->t != ORR_TIME_NONE && now.t - b->t == 30 * ORR_NS_PER_S) {
                if (e->lli[i * e->stride + (size_t)l1] & ORR_OBS_LLI_SLIP) {
                    n_slips++;
                } else {
                    double d = (now.code_m - b->code_m) - (now.phase_m - b->phase_m);
                    n_steps++;
                    n_rough += fabs(d) > 5 ? 1 : 0;
                    if (fabs(d) < 5) sum2 += d * d;
                }
            }
            *b = now;
            n++;
        }
    }
    assert_int_equal(w.count, 0);
    assert_true(n > 25000 && n_steps > 20000);
    // Unsmoothed C/A code is noisy by some decimetres at low elevation, and two of them are in a difference.
    double rms = sqrt(sum2 / (double)n_steps);
    print_message("BOR1: %zu GPS L1 pairs, code minus phase from epoch to epoch %.3f m RMS, %zu of %zu "
                  "beyond 5 m, %zu slips told\n",
                  n, rms, n_rough, n_steps, n_slips);
    assert_true(rms < 0.8);
    assert_true(n_rough * 100 < n_steps);
    orr_rinex_obs_close(r);
}

static bool same(double a, double b, double tol) { return isnan(a) ? isnan(b) : fabs(a - b) <= tol; }

static void compare_obs(const char *a_path, const char *b_path)
{
    orr_rinex_obs *a = NULL, *b = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_rinex_obs_open(a_path, NULL, NULL, &a, &diag), diag);
    ASSERT_OK(orr_rinex_obs_open(b_path, NULL, NULL, &b, &diag), diag);
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(a), *g = orr_rinex_obs_header_of(b);
    assert_string_equal(h->marker_name, g->marker_name);
    assert_string_equal(h->receiver_type, g->receiver_type);
    for (size_t i = 0; i < 100; i++) assert_int_equal(h->glonass_channel[i], g->glonass_channel[i]);
    size_t n = 0;
    for (;;) {
        const orr_rinex_obs_epoch *x = NULL, *y = NULL;
        ASSERT_OK(orr_rinex_obs_next(a, &x, &diag), diag);
        ASSERT_OK(orr_rinex_obs_next(b, &y, &diag), diag);
        assert_int_equal(x == NULL, y == NULL);
        if (x == NULL) break;
        assert_true(x->t == y->t && x->flag == y->flag && x->n_sats == y->n_sats);
        assert_true(same(x->clock_offset_s, y->clock_offset_s, 0));
        for (size_t i = 0; i < x->n_sats; i++) {
            assert_int_equal(x->sat[i], y->sat[i]);
            for (size_t j = 0; j < h->codes[orr_sat_system_index(x->sat[i])].n; j++) {
                size_t p = i * x->stride + j, q = i * y->stride + j;
                assert_true(same(x->value[p], y->value[q], 0));
                assert_int_equal(x->lli[p], y->lli[q]);
                assert_int_equal(x->ssi[p], y->ssi[q]);
                n++;
            }
        }
    }
    assert_true(n > 50000);
    orr_rinex_obs_close(a);
    orr_rinex_obs_close(b);
}

static void observations_written_and_read_back(void **state)
{
    (void)state;
    const char *name = "hatanaka/YEBE00ESP_R_20230891800_01H_30S_MO.crx.gz";
    char path[1024], copy[64];
    if (!orr_test_data(name, path, sizeof path)) SKIP_NO_DATA(name);
    snprintf(copy, sizeof copy, "test_rinex.%ld.rnx", (long)getpid());
    orr_rinex_obs *r = NULL;
    orr_rinex_obs_writer *w = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_rinex_obs_open(path, NULL, NULL, &r, &diag), diag);
    ASSERT_OK(orr_rinex_obs_create(copy, 3.05, orr_rinex_obs_header_of(r), &w, &diag), diag);
    const orr_rinex_obs_epoch *e = NULL;
    for (;;) {
        ASSERT_OK(orr_rinex_obs_next(r, &e, &diag), diag);
        if (e == NULL) break;
        ASSERT_OK(orr_rinex_obs_write(w, e, &diag), diag);
    }
    ASSERT_OK(orr_rinex_obs_commit(w, &diag), diag);
    orr_rinex_obs_close(r);
    compare_obs(path, copy);
    unlink(copy);
}

// Global broadcast files of versions 3 and 4 through the writer: ephemerides that 3.05 knows must come back.
static void ephemerides_written_and_read_back(void **state)
{
    (void)state;
    static const char *const names[] = {
        "2020-177/ESBC00DNK_R_20201770000_01D_MN.rnx.gz", "2024-035/BRDC00CNE_R_20240350000_01D_GN.rnx.gz",
        "rinex4-nav/KMS300DNK_R_20221591000_01H_MN.rnx.gz", "2009-091-glonass/brdc0910.09g.gz"};
    char copy[64];
    snprintf(copy, sizeof copy, "test_rinex_nav_real.%ld.rnx", (long)getpid());
    for (size_t f = 0; f < sizeof names / sizeof names[0]; f++) {
        char path[1024];
        if (!orr_test_data(names[f], path, sizeof path)) SKIP_NO_DATA(names[f]);
        orr_nav a, b;
        orr_diag diag = {0};
        orr_warnings w = {0};
        size_t left = 0;
        ASSERT_OK(orr_nav_read(path, NULL, &a, NULL, &diag), diag);
        ASSERT_OK(orr_nav_write(&a, copy, &left, &diag), diag);
        ASSERT_OK(orr_nav_read(copy, NULL, &b, &w, &diag), diag);
        assert_int_equal(left, 0);
        assert_int_equal(w.count, 0);
        assert_int_equal(a.n_eph, b.n_eph);
        for (size_t i = 0; i < a.n_eph; i++) {
            const orr_nav_eph *x = &a.eph[i], *y = &b.eph[i];
            assert_true(x->sat == y->sat && x->message == y->message && x->toe == y->toe &&
                        x->toc == y->toc && x->transmission == y->transmission && x->health == y->health &&
                        x->iode == y->iode);
            assert_true(x->af0_s == y->af0_s && x->af1_sps == y->af1_sps);
            if (x->kind == ORR_NAV_KEPLER)
                assert_true(x->kepler.m0_rad == y->kepler.m0_rad && x->kepler.crc_m == y->kepler.crc_m &&
                            x->kepler.idot_radps == y->kepler.idot_radps &&
                            same(x->delay.tgd_s, y->delay.tgd_s, 0));
            else if (x->kind == ORR_NAV_GLONASS) // km to m and back: a rounding of the last bit, below the
                                                 // printed digits
                assert_true(fabs(x->glonass.pos_m.x - y->glonass.pos_m.x) < 1e-6 &&
                            x->glonass.freq_channel == y->glonass.freq_channel);
        }
        orr_nav_free(&a);
        orr_nav_free(&b);
        unlink(copy);
    }
}

static void same_numbers(const void *a, const void *b, size_t size)
{
    const double *x = a, *y = b;
    for (size_t k = 0; k < size / sizeof *x; k++) assert_true(same(x[k], y[k], 1e-12 * fabs(x[k])));
}

static void same_ephemeris(const orr_nav_eph *x, const orr_nav_eph *y)
{
    assert_true(x->sat == y->sat && x->kind == y->kind && x->message == y->message && x->toe == y->toe &&
                x->toc == y->toc && x->transmission == y->transmission && x->health == y->health);
    assert_true(x->iode == y->iode && x->iodc == y->iodc && x->sat_type == y->sat_type &&
                x->l2p_flag == y->l2p_flag && x->data_sources == y->data_sources);
    assert_true(x->ura_ed == y->ura_ed && x->ura_ned[0] == y->ura_ned[0] && x->ura_ned[1] == y->ura_ned[1] &&
                x->ura_ned[2] == y->ura_ned[2]);
    assert_true(x->sisai_oe == y->sisai_oe && x->sisai_ocb == y->sisai_ocb && x->sisai_oc1 == y->sisai_oc1 &&
                x->sisai_oc2 == y->sisai_oc2 && x->sismai == y->sismai &&
                x->integrity_flags == y->integrity_flags);
    same_numbers(&x->af0_s, &y->af0_s, 3 * sizeof x->af0_s);
    same_numbers(&x->accuracy_m, &y->accuracy_m, sizeof x->accuracy_m);
    same_numbers(&x->delay, &y->delay, sizeof x->delay);
    if (x->kind == ORR_NAV_KEPLER) same_numbers(&x->kepler, &y->kepler, sizeof x->kepler);
    if (x->kind == ORR_NAV_GLONASS) same_numbers(&x->glonass.pos_m, &y->glonass.pos_m, 3 * sizeof(orr_vec3));
    if (x->kind == ORR_NAV_GEO) same_numbers(&x->geo.pos_m, &y->geo.pos_m, 3 * sizeof(orr_vec3));
}

// All records of files of version 4 through the writer of that version: ephemerides of every message, time offsets, Earth
// orientation, ionosphere. NavIC's L1 ionosphere alone has no form there.
static void records_of_version_4_written_and_read_back(void **state)
{
    (void)state;
    static const char *const names[] = {"rinex4-nav/BRD400DLR_S_20230710000_01D_MN.rnx.gz",
                                        "rinex4-nav/KMS300DNK_R_20221591000_01H_MN.rnx.gz"};
    char copy[64];
    snprintf(copy, sizeof copy, "test_rinex_nav4_real.%ld.rnx", (long)getpid());
    for (size_t f = 0; f < sizeof names / sizeof names[0]; f++) {
        char path[1024];
        if (!orr_test_data(names[f], path, sizeof path)) SKIP_NO_DATA(names[f]);
        orr_nav a, b;
        orr_diag diag = {0};
        size_t left = 99, messages = 0;
        ASSERT_OK(orr_nav_read(path, NULL, &a, NULL, &diag), diag);
        assert_true(a.version >= 4);
        ASSERT_OK(orr_nav_write(&a, copy, &left, &diag), diag);
        ASSERT_OK(orr_nav_read(copy, NULL, &b, NULL, &diag), diag);
        unlink(copy);
        assert_int_equal(left, 0);
        assert_true(b.version > 4.015 && b.version < 4.025);
        assert_true(a.n_eph == b.n_eph && a.n_sto == b.n_sto && a.n_eop == b.n_eop && a.n_iono == b.n_iono);
        for (size_t i = 0; i < a.n_eph; i++) {
            same_ephemeris(&a.eph[i], &b.eph[i]);
            messages |= (size_t)1 << a.eph[i].message;
        }
        print_message("%s: %zu ephemerides of %d messages, %zu offsets, %zu orientations, %zu ionospheres\n",
                      names[f], a.n_eph, __builtin_popcountll(messages), a.n_sto, a.n_eop, a.n_iono);
        for (size_t i = 0; i < a.n_sto; i++) {
            const orr_nav_sto *x = &a.sto[i], *y = &b.sto[i];
            assert_true(x->t_ref == y->t_ref && x->transmission == y->transmission && x->sat == y->sat &&
                        x->message == y->message);
            assert_string_equal(x->code, y->code);
            assert_string_equal(x->utc_id, y->utc_id);
            same_numbers(&x->a0_s, &y->a0_s, 3 * sizeof x->a0_s);
        }
        for (size_t i = 0; i < a.n_eop; i++) {
            assert_true(a.eop[i].t_ref == b.eop[i].t_ref && a.eop[i].transmission == b.eop[i].transmission);
            same_numbers(&a.eop[i].xp_rad, &b.eop[i].xp_rad, 9 * sizeof(double));
        }
        for (size_t i = 0; i < a.n_iono; i++) {
            assert_true(a.iono[i].kind == b.iono[i].kind && a.iono[i].t == b.iono[i].t &&
                        a.iono[i].flags == b.iono[i].flags && a.iono[i].sat == b.iono[i].sat);
            same_numbers(a.iono[i].coefficient, b.iono[i].coefficient, sizeof a.iono[i].coefficient);
        }
        orr_nav_free(&a);
        orr_nav_free(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(code_and_phase_agree),
        cmocka_unit_test(observations_written_and_read_back),
        cmocka_unit_test(ephemerides_written_and_read_back),
        cmocka_unit_test(records_of_version_4_written_and_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

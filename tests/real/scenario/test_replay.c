// SPDX-License-Identifier: GPL-3.0-or-later
// A real station replayed: two hours of BOR1. What the models leave stays below 2 cm of the carriers and 1 m of the codes; with
// residuals the observations are the recorded ones, with their gaps and slips, and nothing else.
#include <unistd.h>

#include "ingest/rinex/rinex_obs.h"
#include "src/scenario/engine/engine.h"
#include "src/scenario/observables/observe.h"
#include "testing.h"

#define DAY "2024-035/"
#define STATION DAY "BOR100POL_R_20240350000_01D_30S_MO.crx.gz"

static orr_engine *replayed(const char *station, const char *more)
{
    char orbit[512], field[512], bias[512], sinex[512], antex[512], text[4096];
    (void)orr_test_data(DAY "COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz", orbit, sizeof orbit);
    (void)orr_test_data(DAY "COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz", field, sizeof field);
    (void)orr_test_data(DAY "COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz", bias, sizeof bias);
    (void)orr_test_data(DAY "IGS0OPSSNX_20240350000_01D_01D_CRD.SNX.gz", sinex, sizeof sinex);
    (void)orr_test_data("antex/igs05.atx.gz", antex, sizeof antex);
    snprintf(
        text, sizeof text,
        "orbit: {sp3: ['%s'], nodes: 900}\nnavdata: {window: none}\nionosphere: {field: '%s'}\nchannel: "
        "{bias: '%s', antex: '%s'}\n"
        "replay: {observations: '%s', sinex: '%s', from: 2024-02-04T06:00:00, to: 2024-02-04T07:59:30%s}\n",
        orbit, field, bias, antex, station, sinex, more);
    orr_scenario s;
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    orr_engine *e;
    ASSERT_OK(orr_scenario_parse("replay.yaml", text, strlen(text), ".", NULL, &s, &diag), diag);
    ASSERT_OK(orr_engine_open(&s, NULL, NULL, &warnings, &e, &diag), diag);
    orr_warnings_free(&warnings);
    orr_scenario_free(&s);
    return e;
}

// The next epoch of observations in the stretch; NULL at its end.
static const orr_rinex_obs_epoch *next(orr_rinex_obs *file, orr_time from, orr_time to)
{
    const orr_rinex_obs_epoch *e;
    orr_diag diag = {0};
    do {
        ASSERT_OK(orr_rinex_obs_next(file, &e, &diag), diag);
    } while (e != NULL && (e->flag > 1 || e->t < from));
    return e != NULL && e->t <= to ? e : NULL;
}

// What an epoch has of a satellite's code; NAN where it has none. *lli of it.
static double value_of(const orr_rinex_obs_header *h, const orr_rinex_obs_epoch *e, orr_sat sat,
                       const char *code, uint8_t *lli)
{
    const int j = orr_obs_code_index(h, orr_sat_system(sat), code);
    *lli = 0;
    for (size_t i = 0; j >= 0 && i < e->n_sats; i++)
        if (e->sat[i] == sat) {
            *lli = e->lli[i * e->stride + (size_t)j];
            return e->value[i * e->stride + (size_t)j];
        }
    return (double)NAN;
}

// Every value of the replay is the recorded one, and every recorded one of its satellites and codes is there.
static size_t compare(const orr_replay *r, const char *recorded, const char *written)
{
    orr_rinex_obs *a, *b;
    orr_diag diag = {0};
    size_t n = 0;
    const orr_time from = r->tag[0], to = r->tag[r->n_epochs - 1];
    ASSERT_OK(orr_rinex_obs_open(recorded, NULL, NULL, &a, &diag), diag);
    ASSERT_OK(orr_rinex_obs_open(written, NULL, NULL, &b, &diag), diag);
    const orr_rinex_obs_header *ha = orr_rinex_obs_header_of(a), *hb = orr_rinex_obs_header_of(b);
    for (;;) {
        const orr_rinex_obs_epoch *x = next(a, from, to), *y = next(b, from, to);
        assert_int_equal(x == NULL, y == NULL);
        if (x == NULL) break;
        assert_int_equal(x->t, y->t);
        assert_int_equal(x->flag, y->flag);
        for (size_t k = 0; k < r->n_tracks; k++) {
            const orr_sat sat = r->sat[r->track[k].sat].sat;
            for (int kind = 0; kind < 2; kind++) {
                uint8_t lli[2];
                const char code[4] = {"CL"[kind], r -> code[r->track[k].signal][0],
                                      r -> code[r->track[k].signal][1], 0};
                const double was = value_of(ha, x, sat, code, &lli[0]),
                             is = value_of(hb, y, sat, code, &lli[1]);
                assert_int_equal(isnan(was), isnan(is));
                if (isnan(was)) continue;
                ASSERT_NEAR(is, was, 1e-9);
                assert_int_equal(lli[1], lli[0]);
                n++;
            }
        }
    }
    orr_rinex_obs_close(a);
    orr_rinex_obs_close(b);
    return n;
}

static void a_station_observes_what_it_observed(void **state)
{
    (void)state;
    char station[512], path[] = "/tmp/orrery-replay-XXXXXX";
    if (!orr_test_data(STATION, station, sizeof station)) SKIP_NO_DATA(STATION);
    orr_engine *e = replayed(station, "");
    const orr_replay_report *report;
    const orr_replay *r = orr_engine_replay(e, &report);
    orr_observe_count count;
    orr_diag diag = {0};
    const orr_observe_plan plan = {.from = r->tag[0],
                                   .to = r->tag[r->n_epochs - 1],
                                   .step_ns = 30 * ORR_NS_PER_S,
                                   .replay = r,
                                   .recorded = true,
                                   .rinex = 3.05};
    assert_int_equal(r->n_epochs, 240);
    const orr_replay_rms all = orr_replay_rms_all(r);
    print_message("carriers %.4f m, codes %.3f m, site %.4f m off\n", all.carrier_m, all.code_m,
                  orr_vec3_norm(report->shift_enu_m));
    assert_true(all.carrier_m < 0.02);
    assert_true(all.code_m < 1);
    assert_true(all.carrier_m > 0.002 && all.code_m > 0.1); // it is a real receiver
    assert_true(orr_vec3_norm(report->shift_enu_m) < 0.05);
    const int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    ASSERT_OK(orr_observe_rinex(orr_engine_channels(e), 0, &plan, path, &count, &diag), diag);
    assert_true(compare(r, station, path) > 25000);
    unlink(path);
    orr_engine_close(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_station_observes_what_it_observed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/scenario/made_channels.h"

#include "testing.h"
#include "unit/orbit/made_orbit.h"

orr_engine *engine;
orr_channel_work *work;

static orr_status try_with(const char *rest, orr_diag *diag)
{
    char text[4000];
    orr_scenario s;
    snprintf(text, sizeof text, "orbit: {product: " MADE_PRODUCT "}\n%s%s",
             strstr(rest, "navdata:") == NULL ? "navdata: {window: none}\n" : "", rest);
    orr_status status = orr_scenario_parse("test", text, strlen(text), NULL, NULL, &s, diag);
    if (status != ORR_OK) return status;
    status = orr_engine_open(&s, NULL, NULL, NULL, &engine, diag);
    orr_scenario_free(&s);
    return status;
}

void open_with(const char *rest)
{
    orr_diag diag = {0};
    ASSERT_OK(try_with(rest, &diag), diag);
    ASSERT_OK(orr_channel_work_open(orr_engine_channels(engine), &work, &diag), diag);
}

void refused_with(const char *rest, const char *words)
{
    orr_diag diag = {0};
    const orr_status status = try_with(rest, &diag);
    if (status == ORR_OK) fail_msg("not refused: %s", rest);
    if (strstr(diag.text, words) == NULL) fail_msg("'%s' has not '%s'", diag.text, words);
    assert_string_equal(diag.file, "test");
    assert_true(diag.line > 0);
}

// The sample's ionosphere, a year earlier: the days of the made orbits.
static void make_ionosphere(void)
{
    static const char *const days[][2] = {{"2025 03 20", "2024 02 03"}, {"2025 03 23", "2024 02 06"}};
    FILE *in = fopen(ORR_SOURCE_DIR "/samples/ionosphere.ION", "r"), *out = fopen(MADE_IONOSPHERE, "w");
    assert_true(in != NULL && out != NULL);
    char line[200];
    while (fgets(line, sizeof line, in) != NULL) {
        for (size_t k = 0; k < sizeof days / sizeof *days; k++) {
            char *day = strstr(line, days[k][0]);
            if (day != NULL) memcpy(day, days[k][1], strlen(days[k][1]));
        }
        fputs(line, out);
    }
    fclose(in);
    assert_int_equal(fclose(out), 0);
}

int set_up(void **state)
{
    (void)state;
    make_ionosphere();
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(9, 6, 900, 6);
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(&s, &e, &diag), diag);
    ASSERT_OK(orr_ephemeris_save(e, MADE_PRODUCT, "made for a test", &diag), diag);
    orr_ephemeris_free(e);
    made_solution_free(&s);
    return 0;
}

int tear_down(void **state)
{
    (void)state;
    orr_channel_work_close(work);
    work = NULL;
    orr_engine_close(engine);
    engine = NULL;
    return 0;
}

orr_time at(double t_s) { return orr_time_add_s(made_midnight, t_s); }

size_t all_at(orr_time t, size_t antenna, orr_channel out[ROOM])
{
    size_t n;
    const orr_channels *c = orr_engine_channels(engine);
    assert_true(orr_channels_max(c) <= ROOM);
    assert_int_equal(orr_channels_at(c, antenna, work, t, UINT64_MAX, out, &n), ORR_ANSWER_OK);
    return n;
}

orr_channel one_at(orr_time t, const char *sat, const char *signal)
{
    orr_channel x[ROOM];
    const orr_sat wanted = orr_sat_parse(sat);
    const orr_signal *all = orr_signals(&(size_t){0});
    const size_t n = all_at(t, 0, x);
    for (size_t k = 0; k < n; k++)
        if (x[k].sat == wanted && strcmp(all[x[k].signal].name, signal) == 0) return x[k];
    fail_msg("no channel of %s %s", sat, signal);
    return x[0];
}

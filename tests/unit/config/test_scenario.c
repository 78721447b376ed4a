// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/scenario.h"

#include "testing.h"

static orr_status parse(const char *text, orr_scenario *s, orr_diag *diag)
{
    return orr_scenario_parse("s.yaml", text, strlen(text), "/some/where", NULL, s, diag);
}

static void everything(void **state)
{
    (void)state;
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(parse("title: Three days\n"
                    "orbit:\n"
                    "  sp3: [a.sp3, sub/b.sp3, /abs/c.sp3]\n"
                    "  nodes: 900\n"
                    "  exclude:\n"
                    "    - 2024-02-04T10:00:00/2024-02-04T11:00:00\n"
                    "serve:\n"
                    "  listen: ['tcp://127.0.0.1:0', 'unix:x.sock']\n",
                    &s, &diag),
              diag);
    assert_string_equal(s.title, "Three days");
    assert_int_equal(s.orbit.sp3.n, 3);
    assert_string_equal(s.orbit.sp3.item[0], "/some/where/a.sp3");
    assert_string_equal(s.orbit.sp3.item[1], "/some/where/sub/b.sp3");
    assert_string_equal(s.orbit.sp3.item[2], "/abs/c.sp3");
    assert_true(s.orbit.nodes_s == 900 && s.orbit.product == NULL);
    assert_int_equal(s.orbit.exclude.n, 1);
    assert_true(s.orbit.exclude.item[0].to - s.orbit.exclude.item[0].from == 3600 * ORR_NS_PER_S);
    assert_int_equal(s.serve.listen.n, 2);
    assert_string_equal(s.serve.listen.item[1], "unix:x.sock"); // a URL is no file
    orr_scenario_free(&s);
}

static void defaults_and_short_forms(void **state)
{
    (void)state;
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(parse("orbit: {sp3: one.sp3}\nserve:\n", &s, &diag), diag); // one value is a list of one
    assert_int_equal(s.orbit.sp3.n, 1);
    assert_true(s.title == NULL && s.orbit.nodes_s == 0 && s.serve.listen.n == 0 && s.orbit.exclude.n == 0);
    orr_scenario_free(&s);
    ASSERT_OK(parse("orbit: {product: day.nc}\n", &s, &diag), diag);
    assert_string_equal(s.orbit.product, "/some/where/day.nc");
    orr_scenario_free(&s);
}

#define BLOCK "trajectory:\n  kind: analytic\n  lat: 50\n  lon: 20\n"
#define SKY "orbit: {product: y}\nionosphere: {field: f}\n"
#define REST "trajectory: {kind: analytic, lat: 50, lon: 20, duration: 60}\n"
#define WAYPOINTS "trajectory:\n  kind: waypoints\n  waypoints: [{lat: 1, lon: 2}, {lat: 1, lon: 3}]\n"

static void refusals(void **state)
{
    (void)state;
    const struct {
        const char *text;
        int line, column;
        const char *words;
    } cases[] = {
        {"orbit:\n  sp4: x\n", 2, 3, "unknown key 'orbit.sp4'; did you mean 'orbit.sp3'?"},
        {"orbit:\n  sp3: x\n  nodse: 900\n", 3, 3, "unknown key 'orbit.nodse'; did you mean 'orbit.nodes'?"},
        {"orbits:\n  sp3: x\n", 1, 1, "unknown key 'orbits'; did you mean 'orbit'?"},
        {"weather: rain\n", 1, 1, "unknown key 'weather'"},
        {"schema: 2\norbit: {sp3: x}\n", 1, 1, "written for schema 2 and this program reads up to 1"},
        {"schema: 0\norbit: {sp3: x}\n", 1, 9, "outside 1 to 1000"},
        {"orbit: {sp3: x, nodes: often}\n", 1, 24, "orbit.nodes: 'often' is no number"},
        {"orbit: {sp3: x, nodes: -1}\n", 1, 24, "outside 0 to 86400 s"},
        {"orbit: {sp3: x, nodes: 1e999}\n", 1, 24, "is no number"},
        {"orbit: {sp3: x, nodes: nan}\n", 1, 24, "is no number"},
        {"orbit: {sp3: x, nodes: [1]}\n", 1, 24, "not a list"},
        {"orbit: {sp3: x, nodes: }\n", 1, 0, "has no value"},
        {"orbit: {sp3: [x, [y]]}\n", 1, 18, "orbit.sp3[1]: a list of files is wanted here, not a list"},
        {"orbit: {sp3: x, exclude: yesterday}\n", 1, 26, "no interval"},
        {"orbit: {sp3: x, exclude: [2024-01-02/2024-01-01]}\n", 1, 27, "ends before it begins"},
        {"orbit: {sp3: x, exclude: [2024-13-02/2024-01-01]}\n", 1, 27, "orbit.exclude[0]"},
        {"orbit: x\n", 1, 8, "a map with keys"},
        {"title: none\n", 1, 1, "no orbits and no trajectory"},
        {"", 1, 1, "no orbits and no trajectory"},
        // Files that exclude each other, and keys of the one that the other does not need.
        {"orbit: {sp3: x, product: y}\n", 1, 9, "orbit.sp3: cannot stand beside orbit.product"},
        {"orbit: {product: y, nodes: 900}\n", 1, 21,
         "orbit.nodes: has no effect without orbit.sp3: a product is smoothed already"},
        {"orbit: {nodes: 900}\n", 1, 9, "orbit.nodes: has no effect without orbit.sp3"},
        {"orbit: {product: y}\nnavdata:\n  window: none\n  antex: a\n", 4, 3,
         "navdata.antex: has no effect with navdata.window none; it belongs to navdata.window 2h or 4h"},
        {"orbit: {product: y}\nionosphere: {seed: 7}\n", 2, 14,
         "ionosphere.seed: has no effect without ionosphere.session"},
        {"orbit: {product: y}\nionosphere: {field: f, session: s}\n", 2, 14,
         "ionosphere.field: cannot stand beside ionosphere.session: a session holds its field"},
        {"orbit: {product: y}\nionosphere: {field: f, noise: yes}\n", 2, 24,
         "ionosphere.noise: has no effect without ionosphere.session"},
        {"orbit: {product: y}\nionosphere: {session: s, noise: no, seed: 3}\n", 2, 37,
         "has no effect with ionosphere.noise no; it belongs to ionosphere.noise yes"},
        // Sections without what they belong to.
        {"ionosphere: {field: f}\n" REST, 1, 1,
         "ionosphere: has no effect without orbit: there are no satellites"},
        {"receiver: {unit: 0}\n" REST, 1, 1, "receiver: has no effect without orbit"},
        {"navdata: {window: 4h}\n" REST, 1, 1, "navdata: has no effect without orbit"},
        {"orbit: {product: y}\nimu: {rate: 50}\n", 2, 1,
         "imu: has no effect without trajectory: nothing moves"},
        {"orbit: {product: y}\nunits: [{up: 1}]\n", 2, 1, "units: has no effect without trajectory"},
        {"orbit: {product: y}\ngravity: {model: egm96}\n", 2, 1, "gravity: has no effect without trajectory"},
        {"orbit: {product: y}\nreceiver: {position: [1, 2, 3]}\n", 2, 1,
         "receiver: has no effect without ionosphere or signals: nothing else asks where it is"},
        {SKY "receiver: {unit: 1}\n", 3, 12, "receiver.unit: has no effect without trajectory"},
        {REST SKY "units: [{up: 1}]\nreceiver: {unit: 2}\n", 5, 1,
         "there is no unit 2, the scenario has 0 to 1"},
        {REST SKY "receiver: {unit: 0, position: [1, 2, 3]}\n", 4, 21,
         "receiver.position: cannot stand beside receiver.unit"},
        {SKY "receiver: {position: [1, 2]}\n", 3, 22, "2 members, where 3 are wanted"},
        {SKY "receiver: {position: [91, 2, 3]}\n", 3, 12, "latitude 91, longitude 2 is no place"},
        // Keys of a trajectory belong to its kind.
        {"trajectory: {lat: 1, lon: 2}\n", 1, 13, "'trajectory.kind' is missing"},
        {"trajectory: {}\n", 1, 13, "'trajectory.kind' is missing"},
        {"trajectory: {kind: none}\n", 1, 20,
         "'none' is none of survey, waypoints, phases, telemetry, analytic"},
        {"trajectory: {survey: {lines: 3}, kind: surveyy}\n", 1, 40, "'surveyy' is none of"},
        {"trajectory:\n  kind: survey\n  lat: 56\n", 2, 3, "'trajectory.lon' is missing"},
        {"trajectory: {kind: waypoints}\n", 1, 13, "'trajectory.waypoints' is missing"},
        {"trajectory: {kind: telemetry}\n", 1, 13, "'trajectory.telemetry' is missing"},
        {"trajectory:\n  kind: waypoints\n  waypoints:\n", 3, 3, "trajectory.waypoints: has no value"},
        {REST "units:\n", 2, 1, "units: has no value"},
        {WAYPOINTS "  survey: {lines: 3}\n", 4, 3,
         "trajectory.survey: has no effect with trajectory.kind waypoints; it belongs to trajectory.kind "
         "survey"},
        {WAYPOINTS "  lead: 500\n", 4, 3, "trajectory.lead: has no effect with trajectory.kind waypoints"},
        {WAYPOINTS "  lat: 56\n", 4, 3, "it belongs to trajectory.kind survey, phases or analytic"},
        {WAYPOINTS "  seed: 5\n", 4, 3,
         "trajectory.seed: has no effect without trajectory.turbulence or trajectory.oscillation"},
        {WAYPOINTS "  turbulence: {low: 0.1}\n", 4, 15, "'trajectory.turbulence.rms' is missing"},
        {WAYPOINTS "  turbulence: {rms: 1, low: 0.5}\n", 4, 15,
         "the lowest frequency, 0.5 Hz, is not below the highest, 0.3 Hz"},
        {"trajectory:\n  kind: waypoints\n  waypoints:\n    - {lat: 1, lon: 2}\n    - {lat: 3}\n", 5, 7,
         "'trajectory.waypoints[1].lon' is missing"},
        {"trajectory: {kind: waypoints, waypoints: [{lat: 1, lon: 2}]}\n", 1, 42,
         "1 members, where 2 to 1000 are possible"},
        {"trajectory: {kind: survey, lat: 1, lon: 2, survey: {tie_spacing: 5}}\n", 1, 53,
         "trajectory.survey.tie_spacing: has no effect with trajectory.survey.tie_lines 0; it needs 1 or "
         "more"},
        {"trajectory: {kind: survey, lat: 1, lon: 2, survey: {lines: 1, spacing: 5}}\n", 1, 63,
         "trajectory.survey.spacing: has no effect with trajectory.survey.lines 1; it needs 2 or more"},
        {"trajectory: {kind: survey, lat: 1, lon: 2, survey: {side: left, lines: 1}}\n", 1, 53,
         "trajectory.survey.side: has no effect with trajectory.survey.lines 1; it needs 2 or more"},
        {"trajectory: {kind: survey, lat: 1, lon: 2, climb: 3}\n", 1, 44,
         "trajectory.climb: has no effect with trajectory.kind survey"},
        {BLOCK "  body: {pitch: 2}\n  fit: {degree: 5}\n", 6, 3, "it belongs to trajectory.kind telemetry"},
        {BLOCK "  motions: [{kind: circle, across: 5}]\n", 5, 28,
         "trajectory.motions[0].across: has no effect with trajectory.motions[0].kind circle; it belongs to "
         "trajectory.motions[0].kind eight"},
        {BLOCK "  transfer: {lat: 90}\n", 5, 13, "'trajectory.transfer.lon' is missing"},
        {BLOCK "  duration: 0\n", 5, 13, "no positive length of time"},
        // Readings.
        {REST "imu: {frame: body}\n", 2, 7,
         "imu.frame: has no effect with imu.approach 2; it belongs to imu.approach 1"},
        {REST "imu: {approach: 1, quadrature: gauss}\n", 2, 20,
         "imu.quadrature: has no effect with imu.approach 1"},
        {REST "imu: {order: 6}\n", 2, 7, "quadrature gauss has 1 to 5"},
        // Gravity.
        {REST "gravity: {folder: f}\n", 2, 11, "gravity.folder: has no effect without gravity.model"},
        {REST "gravity: {masses: [{lat: 1, gm: 5}]}\n", 2, 20, "'gravity.masses[0].lon' is missing"},
        {REST "gravity: {masses: [{lat: 1, lon: 5}]}\n", 2, 20, "'gravity.masses[0].gm' is missing"},
        {REST "gravity: {profile: {lat: 1, distance: [1, 2, 3], mgal: [1, 2, 3]}}\n", 2, 20,
         "'gravity.profile.lon' is missing"},
        {REST "gravity: {profile: {lat: 1, lon: 2}}\n", 2, 11, "has no effect without distance and mgal"},
        {REST "gravity: {profile: {lat: 1, lon: 2, mgal: [1, 2]}}\n", 2, 37,
         "gravity.profile.mgal: has no effect without gravity.profile.distance"},
        {REST "gravity: {profile: {lat: 1, lon: 2, distance: [1, 2], mgal: [1]}}\n", 2, 55,
         "1 values for 2 distances"},
        {"- a\n- b\n", 1, 1, "this is a list"},
        {"just words\n", 1, 1, "this is a text"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_scenario s;
        orr_diag diag = {0};
        orr_status got = parse(cases[i].text, &s, &diag);
        if (got == ORR_OK || strstr(diag.text, cases[i].words) == NULL || diag.line != cases[i].line ||
            (cases[i].column != 0 && diag.column != cases[i].column))
            fail_msg("'%s': status %d, %lld:%d \"%s\"", cases[i].text, got, (long long)diag.line, diag.column,
                     diag.text);
        assert_string_equal(diag.file, "s.yaml");
    }
}

// A key of the table that belongs to words of a choice beside it is refused under every other word, whatever
// its value: the table alone decides. The path of the map goes before, its begin is all that the file says.
static size_t keys_refused(const orr_schema *table, const char *before, const char *after)
{
    size_t cases = 0;
    for (size_t i = 0; i < table->n; i++) {
        const orr_key *k = &table->key[i];
        for (const orr_condition *c = k->only; c != NULL && c->key != NULL; c++) {
            const orr_key *choice = NULL;
            for (size_t j = 0; j < table->n; j++)
                if (c->words != NULL && strcmp(table->key[j].name, c->key) == 0) choice = &table->key[j];
            if (choice == NULL || choice->choice == NULL) continue;
            for (const orr_choice *w = choice->choice; w->word != NULL; w++) {
                char text[400], expected[100], words[100];
                snprintf(words, sizeof words, "|%s|", c->words);
                snprintf(expected, sizeof expected, "|%s|", w->word);
                bool belongs = strstr(words, expected) != NULL;
                snprintf(text, sizeof text, "%s{%s: %s, %s: x}%s", before, choice->name, w->word, k->name,
                         after);
                orr_scenario s;
                orr_diag diag = {0};
                const orr_status got = parse(text, &s, &diag);
                if (got == ORR_OK && belongs && k->kind == ORR_KEY_FILE) { // x is a name as good as any
                    orr_scenario_free(&s);
                    cases++;
                    continue;
                }
                assert_int_equal(got, ORR_E_FORMAT); // x is no value of any of the others
                snprintf(expected, sizeof expected, "%s: has no effect with ", k->name);
                if ((strstr(diag.text, expected) == NULL) != belongs || diag.line < 1)
                    fail_msg("%s: \"%s\"", text, diag.text);
                cases++;
            }
        }
    }
    return cases;
}

static void keys_belong_to_kinds(void **state)
{
    (void)state;
    const orr_key *terms = NULL;
    for (size_t i = 0; i < orr_section_trajectory.n; i++)
        if (strcmp(orr_section_trajectory.key[i].name, "motions") == 0)
            terms = &orr_section_trajectory.key[i];
    assert_non_null(terms);
    assert_true(keys_refused(&orr_section_trajectory, "trajectory: ", "\n") > 60);
    assert_true(keys_refused(terms->map, "trajectory: {kind: analytic, lat: 1, lon: 2, motions: [", "]}\n") >
                30);
    assert_int_equal(keys_refused(&orr_section_imu, REST "imu: ", "\n"), 12);
    // The files that navdata names may have any name, so that x is one: only its window is judged.
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(parse("orbit: {product: p}\nnavdata: {window: 4h, antex: x}\n", &s, &diag), diag);
    assert_true(s.navdata.window == ORR_NAVDATA_4H && strcmp(s.navdata.antex, "/some/where/x") == 0);
    orr_scenario_free(&s);
}

// Every word stands for its own value of the enum, and reads as it.
static void words_are_their_values(void **state)
{
    (void)state;
#define CASE(value, word, help) {value, word},
    const struct {
        int value;
        const char *word;
    } kinds[] = {ORR_MOTION_KINDS(CASE)}, frames[] = {ORR_IMU_FRAMES(CASE)},
      windows[] = {ORR_NAVDATA_WINDOWS(CASE)};
    orr_scenario s;
    orr_diag diag = {0};
    char text[300];
    const char *const rest[] = {"lat: 1, lon: 2",
                                "waypoints: [{lat: 1, lon: 2}, {lat: 1, lon: 3}]",
                                "lat: 1, lon: 2, phases: {kind: takeoff}",
                                "telemetry: {file: f}",
                                "lat: 1, lon: 2",
                                "product: f, sat: L51"};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        snprintf(text, sizeof text, "trajectory: {kind: %s, %s}\n", kinds[i].word, rest[i]);
        ASSERT_OK(parse(text, &s, &diag), diag);
        assert_int_equal(s.motion.trajectory.kind, kinds[i].value);
        assert_int_not_equal(kinds[i].value, ORR_MOTION_NONE);
        orr_scenario_free(&s);
    }
    for (size_t i = 0; i < sizeof frames / sizeof frames[0]; i++) {
        snprintf(text, sizeof text, REST "imu: {approach: 1, frame: %s}\n", frames[i].word);
        ASSERT_OK(parse(text, &s, &diag), diag);
        assert_int_equal(s.motion.imu.frame, frames[i].value);
        assert_int_equal(s.motion.imu.approach, ORR_IMU_MATCHED);
        orr_scenario_free(&s);
    }
    for (size_t i = 0; i < sizeof windows / sizeof windows[0]; i++) {
        snprintf(text, sizeof text, "orbit: {product: p}\nnavdata: {window: %s}\n", windows[i].word);
        ASSERT_OK(parse(text, &s, &diag), diag);
        assert_int_equal(s.navdata.window, windows[i].value);
        orr_scenario_free(&s);
    }
}

static void defaults_of_what_is_not_there(void **state)
{
    (void)state;
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(parse(REST, &s, &diag), diag);
    const orr_scenario_trajectory *t = &s.motion.trajectory;
    assert_true(t->speed_mps == 60 && t->survey.lines == 6 && t->fit.max_gap_ns == 10 * ORR_NS_PER_S);
    assert_true(t->turbulence.rms == 0 && !t->has_start && !t->has_transfer && t->terms.n == 0);
    assert_true(s.motion.imu.rate_hz == 100 && s.motion.imu.approach == ORR_IMU_PHYSICAL && s.iono.noise);
    orr_scenario_free(&s);
    // An instant of 0 ns is the begin of GPS time, not "none"; a transfer is one whose section is there.
    ASSERT_OK(parse(BLOCK "  start: 1980-01-06\n  transfer: {lat: 90, lon: 0}\n", &s, &diag), diag);
    assert_true(s.motion.trajectory.has_start && s.motion.trajectory.start == 0);
    assert_true(s.motion.trajectory.has_transfer && s.motion.trajectory.transfer.lat_deg == 90);
    orr_scenario_free(&s);
}

static void made_without_a_file(void **state)
{
    (void)state;
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(orr_scenario_of_product("a.nc", NULL, &s, &diag), diag);
    assert_string_equal(s.orbit.product, "a.nc");
    assert_int_equal(s.navdata.window, ORR_NAVDATA_2H);
    orr_scenario_free(&s);
    const char *const file[3] = {"p.csv", "a.csv", "b.csv"}, *const columns[3] = {NULL, "t,roll", NULL};
    ASSERT_OK(orr_scenario_of_telemetry(file, columns, 2, NULL, &s, &diag), diag);
    assert_int_equal(s.motion.trajectory.kind, ORR_MOTION_TELEMETRY);
    assert_int_equal(s.motion.trajectory.logs.n, 2);
    assert_string_equal(s.motion.trajectory.logs.item[1].columns, "t,roll");
    assert_null(s.motion.trajectory.logs.item[0].columns);
    assert_true(s.motion.imu.rate_hz == 100);
    orr_scenario_free(&s);
    assert_int_equal(orr_scenario_of_telemetry(file, columns, 3, NULL, &s, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "not in 3"));
}

// Times in a scenario are read by the run's table of leap seconds, which goes on with it.
static void leap_seconds_of_the_run(void **state)
{
    (void)state;
    const orr_leap_table *known = orr_leap_builtin();
    orr_leap_entry entry[64];
    memcpy(entry, known->entry, known->n * sizeof *entry);
    entry[known->n] = (orr_leap_entry){61406, 38}; // 2027-01-01
    const orr_leap_table table = {.n = known->n + 1, .entry = entry, .expires_mjd = 61583};
    const char text[] =
        "orbit: {sp3: a.sp3, exclude: [2026-12-31T23:59:60Z/2027-01-02T00:00:00Z]}\n"
        "trajectory: {kind: analytic, start: '2027-01-01T00:00:00Z', duration: 60, lat: 50, lon: 20}\n";
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(orr_scenario_parse("s.yaml", text, strlen(text), NULL, &table, &s, &diag), diag);
    const orr_time begin = orr_time_from_mjd(61406, 0, ORR_SCALE_UTC, &table);
    assert_true(s.motion.trajectory.start == begin && s.leap == &table);
    assert_true(s.orbit.exclude.item[0].from == begin - ORR_NS_PER_S);
    assert_true(s.orbit.exclude.item[0].to == begin + 86400 * ORR_NS_PER_S);
    orr_scenario_free(&s);
    assert_int_equal(orr_scenario_parse("s.yaml", text, strlen(text), NULL, NULL, &s, &diag), ORR_E_FORMAT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything),
        cmocka_unit_test(defaults_and_short_forms),
        cmocka_unit_test(refusals),
        cmocka_unit_test(keys_belong_to_kinds),
        cmocka_unit_test(words_are_their_values),
        cmocka_unit_test(defaults_of_what_is_not_there),
        cmocka_unit_test(made_without_a_file),
        cmocka_unit_test(leap_seconds_of_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

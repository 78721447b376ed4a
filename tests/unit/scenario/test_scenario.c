// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/scenario.h"

#include "testing.h"

static orr_status parse(const char *text, orr_scenario *s, orr_diag *diag)
{
    return orr_scenario_parse("s.yaml", text, strlen(text), "/some/where", s, diag);
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
    assert_int_equal(s.listen.n, 2);
    assert_string_equal(s.listen.item[1], "unix:x.sock"); // a URL is no file
    orr_scenario_free(&s);
}

static void defaults_and_short_forms(void **state)
{
    (void)state;
    orr_scenario s;
    orr_diag diag = {0};
    ASSERT_OK(parse("orbit: {sp3: one.sp3}\nserve:\n", &s, &diag), diag); // one value is a list of one
    assert_int_equal(s.orbit.sp3.n, 1);
    assert_true(s.title == NULL && s.orbit.nodes_s == 0 && s.listen.n == 0 && s.orbit.exclude.n == 0);
    orr_scenario_free(&s);
    ASSERT_OK(parse("orbit: {product: day.nc}\n", &s, &diag), diag);
    assert_string_equal(s.orbit.product, "/some/where/day.nc");
    orr_scenario_free(&s);
}

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
        {"orbit: {sp3: x, product: y}\n", 0, 0, "exclude each other"},
        {"orbit: {product: y, nodes: 900}\n", 0, 0, "belong to orbit.sp3"},
        {"title: none\n", 0, 0, "no orbits"},
        {"orbit: {product: y}\nreceiver: {unit: 1}\n", 0, 0, "there is none"},
        {"trajectory: {kind: analytic}\nunits: [{up: 1}]\nreceiver: {unit: 2}\n", 0, 0, "no unit 2"},
        {"trajectory: {kind: analytic}\nunits: [{up: 1}]\nreceiver: {unit: 1, position: [1, 2, 3]}\n", 0, 0,
         "exclude each other"},
        {"", 0, 0, "no orbits"},
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

// A table of its own with every kind of value, as later sections will have.
typedef struct leg {
    double length_m;
    char *name;
} leg;
typedef struct toy {
    bool flag;
    int64_t count, wait_ns;
    int colour;
    orr_time start;
    orr_sat_set sats;
    orr_real_list heights;
    struct {
        size_t n;
        leg *item;
    } legs;
} toy;
#define LEG(m) offsetof(leg, m)
#define TOY(m) offsetof(toy, m)
static const orr_key leg_keys[] = {
    {.path = "length",
     .kind = ORR_KEY_REAL,
     .offset = LEG(length_m),
     .required = true,
     .unit = "m",
     .help = "h"},
    {.path = "name", .kind = ORR_KEY_TEXT, .offset = LEG(name), .fallback = "nameless", .help = "h"},
};
static const orr_schema leg_schema = {leg_keys, 2, sizeof(leg)};
static const orr_key toy_keys[] = {
    {.path = "flag", .kind = ORR_KEY_BOOL, .offset = TOY(flag), .fallback = "yes", .help = "h"},
    {.path = "count",
     .kind = ORR_KEY_INT,
     .offset = TOY(count),
     .min = 1,
     .max = 9,
     .fallback = "3",
     .help = "h"},
    {.path = "wait", .kind = ORR_KEY_DURATION, .offset = TOY(wait_ns), .fallback = "2min", .help = "h"},
    {.path = "colour",
     .kind = ORR_KEY_CHOICE,
     .offset = TOY(colour),
     .choices = "red|green|blue",
     .help = "h"},
    {.path = "deep.er.start", .kind = ORR_KEY_TIME, .offset = TOY(start), .help = "h"},
    {.path = "deep.sats", .kind = ORR_KEY_SATS, .offset = TOY(sats), .help = "h"},
    {.path = "heights",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = TOY(heights),
     .fallback = "7.5",
     .help = "h"},
    {.path = "legs",
     .kind = ORR_KEY_RECORDS,
     .list = true,
     .offset = TOY(legs),
     .record = &leg_schema,
     .help = "h"},
};
static const orr_schema toy_schema = {toy_keys, sizeof toy_keys / sizeof toy_keys[0], sizeof(toy)};

static orr_status read_toy(const char *text, toy *t, orr_diag *diag)
{
    orr_yaml y;
    orr_status s = orr_yaml_parse("toy.yaml", text, strlen(text), &y, diag);
    if (s != ORR_OK) return s;
    s = orr_schema_read(&toy_schema, &y, NULL, t, diag);
    orr_yaml_free(&y);
    return s;
}

static void every_kind(void **state)
{
    (void)state;
    toy t;
    orr_diag diag = {0};
    ASSERT_OK(read_toy("", &t, &diag), diag);
    assert_true(t.flag && t.count == 3 && t.wait_ns == 120 * ORR_NS_PER_S && t.colour == 0 && t.legs.n == 0);
    assert_true(t.heights.n == 1 && t.heights.item[0] == 7.5);
    orr_schema_free(&toy_schema, &t);
    ASSERT_OK(
        read_toy(
            "flag: no\ncount: 9\nwait: 0.5\ncolour: blue\ndeep:\n  sats: G05\n  er: {start: 1980-01-06}\n"
            "heights: [1, 2.5]\nlegs:\n  - {length: 3}\n  - {length: 4, name: back}\n",
            &t, &diag),
        diag);
    assert_true(!t.flag && t.count == 9 && t.wait_ns == 500000000 && t.colour == 2 && t.start == 0);
    assert_true(orr_sat_set_has(&t.sats, orr_sat_make('G', 5)) &&
                !orr_sat_set_has(&t.sats, orr_sat_make('G', 6)));
    assert_true(t.heights.n == 2 && t.heights.item[1] == 2.5 && t.legs.n == 2 &&
                t.legs.item[1].length_m == 4);
    assert_string_equal(t.legs.item[0].name, "nameless");
    assert_string_equal(t.legs.item[1].name, "back");
    orr_schema_free(&toy_schema, &t);
    assert_int_equal(t.legs.n, 0);
}

static void every_kind_refuses(void **state)
{
    (void)state;
    const char *const cases[][2] = {
        {"flag: maybe\n", "neither yes nor no"},
        {"count: 3.5\n", "no whole number"},
        {"count: 10\n", "outside 1 to 9"},
        {"count: 99999999999999999999\n", "no whole number"},
        {"wait: soon\n", "wait:"},
        {"colour: pink\n", "none of red|green|blue"},
        {"colour: re\n", "none of red|green|blue"},
        {"deep: {er: {start: never}}\n", "deep.er.start:"},
        {"deep: {sats: Q5}\n", "deep.sats:"},
        {"deep: {er: {strat: 0}}\n", "did you mean 'deep.er.start'?"},
        {"legs: [{name: x}]\n", "'length' is missing"},
        {"legs: [{length: 1, nmae: x}]\n", "unknown key 'legs[0].nmae'; did you mean 'legs[0].name'?"},
        {"legs: [5]\n", "a map is wanted"},
        {"legs: [{length: 1, name: x}, {length: 2, name: y}, {length: z}]\n",
         "legs[2].length: 'z' is no number"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        toy t;
        orr_diag diag = {0};
        if (read_toy(cases[i][0], &t, &diag) == ORR_OK || strstr(diag.text, cases[i][1]) == NULL)
            fail_msg("%s: \"%s\"", cases[i][0], diag.text);
        assert_int_equal(t.legs.n, 0); // what had been read has been freed
    }
}

// Every row of the real table can be reached, described, and its default read.
static void the_table_is_sound(void **state)
{
    (void)state;
    const orr_schema *schema = orr_scenario_schema();
    assert_int_equal(schema->size, sizeof(orr_scenario));
    for (size_t i = 0; i < schema->n; i++) {
        assert_true(strlen(schema->key[i].help) > 10);
        assert_true(schema->key[i].offset < schema->size);
        for (size_t j = 0; j < i; j++) assert_string_not_equal(schema->key[i].path, schema->key[j].path);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything),         cmocka_unit_test(defaults_and_short_forms),
        cmocka_unit_test(refusals),           cmocka_unit_test(every_kind),
        cmocka_unit_test(every_kind_refuses), cmocka_unit_test(the_table_is_sound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

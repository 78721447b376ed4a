// SPDX-License-Identifier: GPL-3.0-or-later
// The tables' machinery on a table of the test's own, and the real tables for soundness.
#include "src/config/schema.h"

#include "src/config/scenario.h"
#include "testing.h"

// A table of its own with every kind of value, as later sections will have.
typedef struct leg {
    double length_m;
    char *name;
} leg;
// Values in an order of their own: the list ties words to them, not their places.
enum { BLUE, RED, GREEN };
#define COLOURS(X) X(RED, "red", "h") X(GREEN, "green", "h") X(BLUE, "blue", "h")
static const orr_choice colours[] = {COLOURS(ORR_CHOICE_WORD){0}};
typedef struct toy {
    bool flag;
    int64_t count, wait_ns;
    int colour;
    struct deep {
        struct er {
            orr_time start;
            bool given;
            char *name;
        } er;
        bool has_er;
        orr_sat_set sats;
    } deep;
    orr_real_list heights;
    struct {
        size_t n;
        leg *item;
    } legs;
} toy;
#define LEG(m) offsetof(leg, m)
#define TOY(m) offsetof(toy, m)
static const orr_key leg_keys[] = {
    {.name = "length",
     .kind = ORR_KEY_REAL,
     .offset = LEG(length_m),
     .required = true,
     .unit = "m",
     .help = "h"},
    {.name = "name", .kind = ORR_KEY_TEXT, .offset = LEG(name), .fallback = "nameless", .help = "h"},
};
static const orr_schema leg_schema = {.key = leg_keys, .n = 2, .size = sizeof(leg)};
static const orr_key er_keys[] = {
    {.name = "start",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(struct er, start),
     .given = offsetof(struct er, given),
     .help = "h"},
    {.name = "name",
     .kind = ORR_KEY_TEXT,
     .offset = offsetof(struct er, name),
     .fallback = "er",
     .help = "h"},
};
static const orr_schema er_schema = {.key = er_keys, .n = 2, .size = sizeof(struct er)};
static const orr_condition of_warm[] = {{.key = "../colour", .words = "red"}, {0}};
static const orr_key deep_keys[] = {
    {.name = "er",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(struct deep, er),
     .given = offsetof(struct deep, has_er),
     .map = &er_schema,
     .help = "h"},
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .offset = offsetof(struct deep, sats),
     .only = of_warm,
     .help = "h"},
};
static const orr_schema deep_schema = {.key = deep_keys, .n = 2, .size = sizeof(struct deep)};
static const orr_condition of_deep[] = {{.key = "deep.er.start|legs", .why = "or it is lost"}, {0}};
static const orr_condition no_flag[] = {{.key = "flag", .words = "no"}, {0}};
static const char *check_toy(const void *map, char why[ORR_SCHEMA_WHY])
{
    if (((const toy *)map)->count != 7) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "seven is too many");
    return "count";
}
static const orr_key toy_keys[] = {
    {.name = "flag", .kind = ORR_KEY_BOOL, .offset = TOY(flag), .fallback = "yes", .help = "h"},
    {.name = "count",
     .kind = ORR_KEY_INT,
     .offset = TOY(count),
     .min = 1,
     .max = 9,
     .fallback = "3",
     .help = "h"},
    {.name = "wait",
     .kind = ORR_KEY_DURATION,
     .offset = TOY(wait_ns),
     .fallback = "2min",
     .only = no_flag,
     .help = "h"},
    {.name = "colour", .kind = ORR_KEY_CHOICE, .offset = TOY(colour), .choice = colours, .help = "h"},
    {.name = "deep", .kind = ORR_KEY_MAP, .offset = TOY(deep), .map = &deep_schema, .help = "h"},
    {.name = "heights",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = TOY(heights),
     .fallback = "7.5",
     .least = 1,
     .most = 3,
     .only = of_deep,
     .help = "h"},
    {.name = "legs", .kind = ORR_KEY_MAP, .list = true, .offset = TOY(legs), .map = &leg_schema, .help = "h"},
};
static const orr_schema toy_schema = {
    .key = toy_keys, .n = sizeof toy_keys / sizeof toy_keys[0], .size = sizeof(toy), .check = check_toy};

static orr_status read_toy(const char *text, toy *t, orr_diag *diag)
{
    orr_yaml y;
    orr_status s = orr_yaml_parse("toy.yaml", text, strlen(text), &y, diag);
    if (s != ORR_OK) return s;
    s = orr_schema_read(&toy_schema, &y, NULL, NULL, t, diag);
    orr_yaml_free(&y);
    return s;
}

static void every_kind(void **state)
{
    (void)state;
    toy t;
    orr_diag diag = {0};
    ASSERT_OK(read_toy("", &t, &diag), diag);
    assert_true(t.flag && t.count == 3 && t.wait_ns == 120 * ORR_NS_PER_S && t.colour == 0 &&
                !t.deep.has_er && t.legs.n == 0);
    assert_true(t.heights.n == 1 && t.heights.item[0] == 7.5);
    assert_string_equal(t.deep.er.name, "er"); // defaults go down into maps that are not there
    orr_schema_free(&toy_schema, &t);
    ASSERT_OK(
        read_toy("flag: no\ncount: 9\nwait: 0.5\ncolour: red\ndeep:\n  sats: G05\n  er: {start: 1980-01-06}\n"
                 "heights: [1, 2.5]\nlegs:\n  - {length: 3}\n  - {length: 4, name: back}\n",
                 &t, &diag),
        diag);
    assert_true(!t.flag && t.count == 9 && t.wait_ns == 500000000 && t.colour == RED &&
                t.deep.er.start == 0 && t.deep.has_er && t.deep.er.given);
    assert_true(orr_sat_set_has(&t.deep.sats, orr_sat_make('G', 5)) &&
                !orr_sat_set_has(&t.deep.sats, orr_sat_make('G', 6)));
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
        {"flag: no\nwait: soon\n", "wait:"},
        {"flag: no\nwait: 0\n", "no positive length of time"},
        {"colour: pink\n", "none of red, green, blue"},
        {"colour: re\n", "none of red, green, blue"},
        {"deep: {er: {start: never}}\n", "deep.er.start:"},
        {"colour: red\ndeep: {sats: Q5}\n", "deep.sats:"},
        {"deep: {er: {strat: 0}}\n", "did you mean 'deep.er.start'?"},
        {"legs: [{name: x}]\n", "'legs[0].length' is missing"},
        {"legs: [{length: 1, nmae: x}]\n", "unknown key 'legs[0].nmae'; did you mean 'legs[0].name'?"},
        {"legs: [5]\n", "legs[0]: a map with keys is wanted"},
        {"deep: 5\n", "deep: a map with keys is wanted"},
        {"deep: {er: [1]}\n", "deep.er: a map with keys is wanted"},
        // Without effect, and why.
        {"wait: 5\n", "wait: has no effect with flag yes; it belongs to flag no"},
        {"wait: 5\nflag: on\n", "wait: has no effect with flag yes; it belongs to flag no"},
        {"deep: {sats: G}\n", "deep.sats: has no effect without colour red"},
        {"colour: blue\ndeep: {sats: G}\n",
         "deep.sats: has no effect with colour blue; it belongs to colour red"},
        {"heights: [1, 2]\n", "heights: has no effect without deep.er.start or legs: or it is lost"},
        {"heights: [1, 2]\ndeep: {er: {}}\n", "heights: has no effect without"},
        {"legs: {length: 1}\nheights: [1, 2, 3, 4]\n", "heights: 4 members, where 1 to 3 are possible"},
        {"deep: {er: {start: 2020-01-01}}\nheights: []\n", "heights: 0 members, where 1 to 3 are possible"},
        {"count: 7\n", "count: seven is too many"},
        {"other: 1\n", "unknown key 'other'"},
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

// Another root: a file of its own that takes sections of the scenario, where and how it wants them.
typedef struct study {
    int64_t seeds;
    struct {
        size_t n;
        orr_scenario_imu *item;
    } grades;
    orr_scenario_trajectory flight;
} study;
static const orr_condition of_flight[] = {{.key = "flight.kind", .words = "survey|waypoints"}, {0}};
static const orr_key study_keys[] = {
    {.name = "seeds",
     .kind = ORR_KEY_INT,
     .offset = offsetof(study, seeds),
     .min = 1,
     .max = 1000,
     .fallback = "20",
     .only = of_flight,
     .help = "h"},
    {.name = "grades",
     .kind = ORR_KEY_MAP,
     .list = true,
     .required = true,
     .offset = offsetof(study, grades),
     .least = 1,
     .map = &orr_section_imu,
     .help = "h"},
    {.name = "flight",
     .kind = ORR_KEY_MAP,
     .required = true,
     .offset = offsetof(study, flight),
     .map = &orr_section_trajectory,
     .help = "h"},
};
static const orr_schema study_schema = {.key = study_keys,
                                        .n = sizeof study_keys / sizeof study_keys[0],
                                        .size = sizeof(study),
                                        .hint = "see the study's page"};

static orr_status read_study(const char *text, study *s, orr_diag *diag)
{
    orr_yaml y;
    ASSERT_OK(orr_yaml_parse("study.yaml", text, strlen(text), &y, diag), *diag);
    orr_status status = orr_schema_read(&study_schema, &y, NULL, NULL, s, diag);
    orr_yaml_free(&y);
    return status;
}

static void sections_serve_other_roots(void **state)
{
    (void)state;
    study s;
    orr_diag diag = {0};
    const char *const flight = "flight: {kind: survey, lat: 1, lon: 2}\n";
    char text[300];
    snprintf(text, sizeof text, "%sseeds: 5\ngrades: [{rate: 50}, {approach: 1, frame: body}]\n", flight);
    ASSERT_OK(read_study(text, &s, &diag), diag);
    assert_true(s.seeds == 5 && s.grades.n == 2 && s.grades.item[0].rate_hz == 50 &&
                s.grades.item[1].rate_hz == 100);
    assert_true(s.grades.item[1].frame == ORR_IMU_BODY && s.flight.lon_deg == 2 &&
                s.flight.survey.lines == 6);
    orr_schema_free(&study_schema, &s);
    const char *const cases[][2] = {
        {"grades: [{rate: 50}, {frame: body}]\n", "grades[1].frame: has no effect with grades[1].approach 2"},
        {"grades: []\n", "'grades' is missing"},
        {"seeds: 5\n", "'grades' is missing"},
        {"seeds: 5\ngrades:\n", "'grades' is missing"},
        {"orbit: {product: p}\ngrades: {rate: 5}\n", "unknown key 'orbit' (see the study's page)"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        snprintf(text, sizeof text, "%s%s", flight, cases[i][0]);
        if (read_study(text, &s, &diag) == ORR_OK || strstr(diag.text, cases[i][1]) == NULL)
            fail_msg("%s: \"%s\"", text, diag.text);
    }
    if (read_study("grades: {rate: 5}\nflight:\n", &s, &diag) == ORR_OK ||
        strstr(diag.text, "'flight' is missing") == NULL)
        fail_msg("\"%s\"", diag.text);
    if (read_study("seeds: 5\ngrades: {rate: 5}\nflight: {kind: analytic, lat: 1, lon: 2}\n", &s, &diag) ==
            ORR_OK ||
        strstr(diag.text, "seeds: has no effect with flight.kind analytic") == NULL)
        fail_msg("\"%s\"", diag.text);
}

// The key that a condition's path means, from the table `at` within `up`.
static const orr_key *find(const orr_schema *at, const orr_schema *up, const char *path, size_t n)
{
    if (strncmp(path, "../", 3) == 0) return up != NULL ? find(up, NULL, path + 3, n - 3) : NULL;
    size_t m = strcspn(path, ".|");
    for (size_t i = 0; i < at->n; i++)
        if (strlen(at->key[i].name) == m && memcmp(at->key[i].name, path, m) == 0)
            return m == n                   ? &at->key[i]
                   : at->key[i].map != NULL ? find(at->key[i].map, at, path + m + 1, n - m - 1)
                                            : NULL;
    return NULL;
}

// What a condition asks for exists, and its words are words of that key.
static void check_condition(const orr_schema *table, const orr_schema *up, const orr_key *k,
                            const orr_condition *c)
{
    for (const char *p = c->key; *p != '\0'; p += strcspn(p, "|") + (p[strcspn(p, "|")] == '|')) {
        const orr_key *asked = find(table, up, p, strcspn(p, "|"));
        if (asked == NULL) fail_msg("%s: no key '%s'", k->name, p);
        assert_ptr_not_equal(asked, k);
        for (const char *w = c->words; w != NULL && *w != '\0';) {
            size_t n = strcspn(w, "|");
            bool known =
                asked->kind == ORR_KEY_BOOL && (strncmp(w, "yes", n) == 0 || strncmp(w, "no", n) == 0);
            for (const orr_choice *o = asked->choice; o != NULL && o->word != NULL; o++)
                known = known || (strlen(o->word) == n && memcmp(o->word, w, n) == 0);
            if (!known) fail_msg("%s: '%s' is no word of %s", k->name, w, asked->name);
            w += n + (w[n] == '|');
        }
    }
}

static size_t check_table(const orr_schema *table, const orr_schema *up)
{
    size_t n = table->n;
    assert_true(table->size > 0);
    for (size_t i = 0; i < table->n; i++) {
        const orr_key *k = &table->key[i];
        assert_true(strlen(k->help) > 0 && strlen(k->name) > 0 && strpbrk(k->name, ".|/") == NULL);
        assert_true(k->offset < table->size && k->given < table->size);
        assert_true((k->kind == ORR_KEY_MAP) == (k->map != NULL) &&
                    (k->kind == ORR_KEY_CHOICE) == (k->choice != NULL));
        assert_false(k->required && k->fallback != NULL);
        for (size_t j = 0; j < i; j++) assert_string_not_equal(k->name, table->key[j].name);
        for (const orr_condition *c = k->only; c != NULL && c->key != NULL; c++)
            check_condition(table, up, k, c);
        if (k->map != NULL) n += check_table(k->map, table);
    }
    return n;
}

static void the_tables_are_sound(void **state)
{
    (void)state;
    assert_true(check_table(&toy_schema, NULL) > 10);
    assert_int_equal(orr_scenario_schema()->size, sizeof(orr_scenario));
    assert_true(check_table(orr_scenario_schema(), NULL) > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind),
        cmocka_unit_test(every_kind_refuses),
        cmocka_unit_test(sections_serve_other_roots),
        cmocka_unit_test(the_tables_are_sound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The command line: every kind of option, in every way of writing it, and what is said of wrong ones.
#include "testing.h"

#include <unistd.h>

#include "src/cli/frame/frame.h"

static const orr_option options[] = {
    {.name = "output", .letter = 'o', .kind = ORR_OPT_TEXT, .value = "FILE", .help = "h"},
    {.name = "count", .letter = 'n', .kind = ORR_OPT_INT, .value = "N", .min = 1, .max = 10, .help = "h"},
    {.name = "lat", .kind = ORR_OPT_REAL, .value = "DEG", .min = -90, .max = 90, .help = "h"},
    {.name = "at", .kind = ORR_OPT_TIME, .value = "T", .help = "h"},
    {.name = "exclude", .kind = ORR_OPT_INTERVAL, .value = "FROM/TO", .repeated = true, .help = "h"},
    {.name = "step", .kind = ORR_OPT_DURATION, .value = "S", .help = "h"},
    {.name = "sat", .kind = ORR_OPT_SATS, .value = "LIST", .help = "h"},
    {.name = "format", .kind = ORR_OPT_CHOICE, .value = "csv|sp3", .help = "h"},
    {.name = "json", .kind = ORR_OPT_FLAG, .help = "h"},
    {.name = "place", .kind = ORR_OPT_PLACE, .value = "LAT,LON,H", .help = "h"},
    {.name = "grid", .kind = ORR_OPT_FLAG, .applies = "!place", .help = "h"},
    {.name = "height", .kind = ORR_OPT_REAL, .value = "M", .applies = "place|lat", .help = "h"},
    {.name = "method", .kind = ORR_OPT_CHOICE, .value = "mean|three|state", .fallback = "state", .help = "h"},
    {.name = "spacing", .kind = ORR_OPT_REAL, .value = "S", .applies = "method=three|mean", .help = "h"},
    {.name = "approach", .kind = ORR_OPT_INT, .value = "1|2", .min = 1, .max = 2, .help = "h"},
    {.name = "order", .kind = ORR_OPT_INT, .value = "N", .applies = "approach=2", .help = "h"},
};
static const orr_option needed[] = {
    {.name = "output", .letter = 'o', .kind = ORR_OPT_TEXT, .value = "FILE", .required = true, .help = "h"}};
static const orr_command command = {.name = "try",
                                    .group = "g",
                                    .summary = "s",
                                    .operands = "FILE...",
                                    .min_operands = 1,
                                    .max_operands = 3,
                                    .option = options,
                                    .n_options = sizeof options / sizeof options[0]};
static const orr_command strict = {
    .name = "strict", .group = "g", .summary = "s", .max_operands = 0, .option = needed, .n_options = 1};

// Splits at blanks and parses; the words stay alive until the next call.
static orr_cli_parse_result parse(orr_cli *c, const orr_command *cmd, const char *line)
{
    static char text[512], *words[32];
    int n = 0;
    snprintf(text, sizeof text, "%s", line);
    for (char *w = strtok(text, " "); w != NULL; w = strtok(NULL, " ")) words[n++] = w;
    *c = (orr_cli){.command = cmd};
    orr_cli_parse_result r = orr_cli_args_parse(c, n, words);
    if (r == ORR_CLI_RUN && orr_cli_applies_check(c) != ORR_EXIT_OK) r = ORR_CLI_WRONG;
    return r;
}

// What parse says on stderr, kept in a file for the time.
static char said[2048];
static orr_cli_parse_result parse_wrong(const orr_command *cmd, const char *line)
{
    orr_cli c;
    FILE *f = tmpfile();
    assert_non_null(f);
    fflush(stderr);
    int keep = dup(2);
    dup2(fileno(f), 2);
    orr_cli_parse_result r = parse(&c, cmd, line);
    fflush(stderr);
    dup2(keep, 2);
    close(keep);
    rewind(f);
    said[fread(said, 1, sizeof said - 1, f)] = '\0';
    fclose(f);
    orr_cli_args_free(&c);
    return r;
}

static void test_values(void **state)
{
    (void)state;
    orr_cli c;
    assert_int_equal(parse(&c, &command,
                           "a.nc -o out.csv --count=7 --lat -12.5 b.nc --at 2024-02-04T00:15:00 --step 15min "
                           "--sat G05,R --format sp3 --json --exclude 2024-02-04/2024-02-05 --exclude "
                           "2024-02-06T01:00/2024-02-06T02:00 -"),
                     ORR_CLI_RUN);
    assert_int_equal(c.n_operands, 3);
    assert_string_equal(c.operand[0], "a.nc");
    assert_string_equal(c.operand[1], "b.nc");
    assert_string_equal(c.operand[2], "-");
    assert_string_equal(orr_cli_text(&c, "output", NULL), "out.csv");
    assert_int_equal(orr_cli_int(&c, "count", 3), 7);
    ASSERT_NEAR(orr_cli_real(&c, "lat", 0), -12.5, 0);
    assert_int_equal(orr_cli_duration_ns(&c, "step", 0), 900 * ORR_NS_PER_S);
    const orr_sat_set *sats = orr_cli_sats(&c, "sat");
    assert_true(orr_sat_set_has(sats, orr_sat_make('G', 5)) && orr_sat_set_has(sats, orr_sat_make('R', 24)));
    assert_false(orr_sat_set_has(sats, orr_sat_make('G', 6)));
    assert_string_equal(orr_cli_text(&c, "format", "csv"), "sp3");
    assert_true(orr_cli_given(&c, "json") && !orr_cli_given(&c, "quiet"));
    assert_int_equal(orr_cli_count(&c, "exclude"), 2);
    orr_time from, to, at = orr_cli_time(&c, "at", 0);
    orr_cli_interval_at(&c, "exclude", 0, &from, &to);
    assert_true(at - from == 900 * ORR_NS_PER_S && to - from == ORR_S_PER_DAY * ORR_NS_PER_S);
    orr_cli_interval_at(&c, "exclude", 1, &from, &to);
    assert_true(to - from == 3600 * ORR_NS_PER_S);
    orr_cli_args_free(&c);
}

static void test_absent_and_short(void **state)
{
    (void)state;
    orr_cli c;
    assert_int_equal(parse(&c, &command, "-oout -n 2 -q -- --json"), ORR_CLI_RUN);
    assert_string_equal(orr_cli_text(&c, "output", NULL), "out");
    assert_int_equal(orr_cli_int(&c, "count", 3), 2);
    assert_int_equal(c.n_operands, 1);
    assert_string_equal(c.operand[0], "--json"); // behind "--" all words are operands
    assert_false(orr_cli_given(&c, "json"));
    assert_true(orr_cli_given(&c, "quiet"));
    assert_null(orr_cli_sats(&c, "sat"));
    assert_int_equal(orr_cli_time(&c, "at", 42), 42);
    assert_int_equal(orr_cli_count(&c, "exclude"), 0);
    assert_null(orr_cli_text(&c, "format", NULL));
    orr_cli_args_free(&c);
    assert_int_equal(parse(&c, &command, "--nonsense-comes-later -h"), ORR_CLI_WRONG);
    orr_cli_args_free(&c);
    assert_int_equal(parse(&c, &command, "-h --nonsense"),
                     ORR_CLI_HELP); // help wins over what is missing or wrong behind it
    orr_cli_args_free(&c);
}

static void test_wrong(void **state)
{
    (void)state;
    static const struct {
        const char *line, *word; // a word that the sentence must have
    } wrong[] = {
        {"a --otput x", "--output"},
        {"a --count 11", "between 1 and 10"},
        {"a --count 3.5", "whole number"},
        {"a --count", "needs a value"},
        {"a --count 1 --count 2", "twice"},
        {"a --at --json", "needs a value"},
        {"a --lat 91", "between -90 and 90"},
        {"a --lat nan", "number"},
        {"a --lat 5x", "number"},
        {"a --at yesterday", "--at"},
        {"a --exclude 2024-02-05", "FROM/TO"},
        {"a --exclude 2024-02-05/2024-02-04", "before it begins"},
        {"a --step 0", "positive"},
        {"a --step -5", "--step"},
        {"a --sat Q5", "--sat"},
        {"a --format json", "csv|sp3"},
        {"a --format cs", "csv|sp3"},
        {"a --json=1", "takes no value"},
        {"a -x", "-x"},
        {"a --place 1", "neither LAT,LON"},
        {"a --place 1,2,3,4", "neither LAT,LON"},
        {"a --place 1,2,x", "neither LAT,LON"},
        {"a --place 1,,2", "neither LAT,LON"},
        {"a --place 91,0", "between -90 and 90"},
        {"a --place 0,0,inf", "neither LAT,LON"},
        {"a --place ecef:1,2", "not ecef:X,Y,Z"},
        {"a --place ecef:1,2,3", "not on the Earth"},
        {"a --grid --place 1,2", "--grid does not apply with --place"},
        {"a --height 5", "--height applies only with --place or --lat"},
        {"a --spacing 5", "--spacing applies only with --method three or mean"},
        {"a --spacing 5 --method state", "--spacing applies only with --method three or mean"},
        {"a --order 5 --approach 1", "--order applies only with --approach 2"},
        {"--json", "FILE... is needed"},
        {"a b c d", "'d'"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_int_equal(parse_wrong(&command, wrong[i].line), ORR_CLI_WRONG);
        if (strstr(said, wrong[i].word) == NULL || strstr(said, "orrery try --help") == NULL)
            fail_msg("of '%s' it says '%s', without '%s'", wrong[i].line, said, wrong[i].word);
    }
    assert_int_equal(parse_wrong(&strict, ""), ORR_CLI_WRONG);
    assert_non_null(strstr(said, "--output FILE is needed"));
    assert_int_equal(parse_wrong(&strict, "-o x y"), ORR_CLI_WRONG);
    assert_non_null(strstr(said, "one word too many"));
}

static void test_places(void **state)
{
    (void)state;
    orr_cli c;
    orr_geodetic g = {7, 7, 7};
    assert_int_equal(parse(&c, &command, "a"), ORR_CLI_RUN);
    assert_false(orr_cli_place(&c, "place", &g));
    ASSERT_NEAR(g.lat_rad, 7, 0);
    orr_cli_args_free(&c);
    assert_int_equal(parse(&c, &command, "a --place -52.5,17.25,124"), ORR_CLI_RUN);
    assert_true(orr_cli_place(&c, "place", &g));
    ASSERT_NEAR(g.lat_rad * ORR_DEG_PER_RAD, -52.5, 1e-13);
    ASSERT_NEAR(g.lon_rad * ORR_DEG_PER_RAD, 17.25, 1e-13);
    ASSERT_NEAR(g.height_m, 124, 0);
    const orr_vec3 r = orr_earth_to_ecef(g);
    orr_cli_args_free(&c);
    char line[128];
    snprintf(line, sizeof line, "a --place ecef:%.6f,%.6f,%.6f", r.x, r.y, r.z);
    orr_geodetic same;
    assert_int_equal(parse(&c, &command, line), ORR_CLI_RUN);
    assert_true(orr_cli_place(&c, "place", &same));
    ASSERT_NEAR(same.height_m, g.height_m, 2e-6); // a micrometre was written
    ASSERT_NEAR(same.lat_rad, g.lat_rad, 1e-12);
    orr_cli_args_free(&c);
}

// An option applies where the table says so; a value that only the inputs tell is settled later.
static void test_applies(void **state)
{
    (void)state;
    static const char *const right[] = {
        "a --grid",
        "a --place 1,2 --height 5",
        "a --lat 1 --height 5",
        "a --spacing 5 --method mean",
        "a --order 5",
        "a --order 5 --approach 2",
        "a --method three --spacing 1",
    };
    orr_cli c;
    for (size_t i = 0; i < sizeof right / sizeof right[0]; i++) {
        assert_int_equal(parse(&c, &command, right[i]), ORR_CLI_RUN);
        orr_cli_args_free(&c);
    }
    assert_int_equal(parse(&c, &command, "a --order 5"), ORR_CLI_RUN);
    assert_int_equal(orr_cli_settle(&c, "approach", "2"), ORR_EXIT_OK);
    assert_int_equal(orr_cli_settle(&c, "approach", "1"), ORR_EXIT_USAGE);
    orr_cli_args_free(&c);
}

// Help names every option of the table.
static void test_help(void **state)
{
    (void)state;
    char text[8192];
    FILE *f = tmpfile();
    assert_non_null(f);
    orr_cli_help_command(f, &command);
    rewind(f);
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    for (size_t i = 0; i < command.n_options; i++) assert_non_null(strstr(text, options[i].name));
    assert_int_equal(orr_cli_n_common(&command), ORR_CLI_COMMON_OPTIONS - 1); // it writes no file: no --force
    for (size_t i = 0; i < ORR_CLI_COMMON_OPTIONS; i++)
        assert_int_equal(strstr(text, orr_cli_common_options[i].name) != NULL,
                         i < ORR_CLI_COMMON_OPTIONS - 1);
    assert_non_null(strstr(text, "may be repeated"));
    for (const char *p = text; *p != '\0';) {
        size_t len = strcspn(p, "\n");
        assert_true(len <= 110);
        p += len + (p[len] == '\n');
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values), cmocka_unit_test(test_absent_and_short), cmocka_unit_test(test_wrong),
        cmocka_unit_test(test_places), cmocka_unit_test(test_applies),          cmocka_unit_test(test_help),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

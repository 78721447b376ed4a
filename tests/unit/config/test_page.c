// SPDX-License-Identifier: GPL-3.0-or-later
// docs/scenario.md tells the tables: its list of keys is what the program prints, its examples are scenarios,
// and there is one of every kind.
#include "src/config/scenario.h"
#include "testing.h"

static char *read_page(void)
{
    FILE *f = fopen(ORR_SOURCE_DIR "/docs/scenario.md", "rb");
    assert_non_null(f);
    char *text = calloc(1, 1 << 20);
    assert_non_null(text);
    size_t n = fread(text, 1, (1 << 20) - 1, f);
    assert_true(n > 1000 && n < (1 << 20) - 1);
    fclose(f);
    return text;
}

static void the_list_of_keys_is_the_program_s(void **state)
{
    (void)state;
    char *page = read_page(), *made = NULL;
    size_t n = 0;
    FILE *f = open_memstream(&made, &n);
    assert_non_null(f);
    orr_schema_describe(orr_scenario_schema(), f);
    fclose(f);
    const char *begin = strstr(page, "```\ntitle: ");
    assert_non_null(begin);
    begin += strlen("```\n");
    if (strncmp(begin, made, n) != 0 || strncmp(begin + n, "```\n", 4) != 0) {
        size_t same = 0;
        while (same < n && begin[same] == made[same]) same++;
        fail_msg(
            "docs/scenario.md, section Keys, is not what 'orrery serve --help-scenario' prints; they differ "
            "from here: %.80s",
            made + same);
    }
    free(made);
    free(page);
}

static bool has(const bool *seen, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!seen[i]) return false;
    return true;
}

static void its_examples_are_scenarios(void **state)
{
    (void)state;
    char *page = read_page();
    bool motion[ORR_MOTION_ORBIT + 1] = {0}, term[ORR_TERM_SINE + 1] = {0};
    bool product = false, sp3 = false, field = false, session = false, units = false, gravity = false;
    size_t n = 0;
    for (char *p = page; (p = strstr(p, "```yaml\n")) != NULL; n++) {
        p += strlen("```yaml\n");
        char *end = strstr(p, "```");
        assert_non_null(end);
        orr_scenario s;
        orr_diag diag = {0};
        if (orr_scenario_parse("example", p, (size_t)(end - p), "docs", NULL, &s, &diag) != ORR_OK)
            fail_msg("line %lld of this example: %s\n%.*s", (long long)diag.line, diag.text, (int)(end - p),
                     p);
        motion[s.motion.trajectory.kind] = true;
        for (size_t k = 0; k < s.motion.trajectory.terms.n; k++)
            term[s.motion.trajectory.terms.item[k].kind] = true;
        product = product || s.orbit.product != NULL;
        sp3 = sp3 || s.orbit.sp3.n > 0;
        field = field || s.iono.field != NULL;
        session = session || s.iono.session != NULL;
        units = units || s.motion.units.n > 0;
        gravity = gravity || s.motion.gravity.has_profile;
        orr_scenario_free(&s);
        p = end + 3;
    }
    assert_true(n >= 8);
    assert_true(has(motion, sizeof motion) && has(term, sizeof term));
    assert_true(product && sp3 && field && session && units && gravity);
    free(page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_list_of_keys_is_the_program_s),
        cmocka_unit_test(its_examples_are_scenarios),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

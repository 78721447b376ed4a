// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/yaml.h"

#include "testing.h"

static orr_status parse(const char *text, orr_yaml *y, orr_diag *diag)
{
    return orr_yaml_parse("s.yaml", text, strlen(text), y, diag);
}

static void tree_with_places(void **state)
{
    (void)state;
    orr_yaml y;
    orr_diag diag = {0};
    ASSERT_OK(parse("# a comment\n"
                    "title: A day\n"
                    "orbit:\n"
                    "  sp3: [a.sp3, 'b c.sp3']\n"
                    "  nodes: 900   # seconds\n"
                    "empty:\n",
                    &y, &diag),
              diag);
    const orr_yaml_node *title = y.root->first, *orbit = title->next, *sp3 = orbit->first, *nodes = sp3->next;
    assert_int_equal(y.root->kind, ORR_YAML_MAP);
    assert_int_equal(y.root->n, 3);
    assert_string_equal(title->key, "title");
    assert_string_equal(title->text, "A day");
    assert_true(title->key_line == 2 && title->key_column == 1 && title->line == 2 && title->column == 8);
    assert_true(sp3->kind == ORR_YAML_LIST && sp3->n == 2 && sp3->first->next->quoted && !sp3->first->quoted);
    assert_string_equal(sp3->first->next->text, "b c.sp3");
    assert_int_equal(sp3->first->next->line, 4);
    assert_int_equal(sp3->first->next->column, 16);
    assert_true(nodes->line == 5 && nodes->column == 10 && nodes->key_column == 3);
    assert_string_equal(nodes->text, "900");
    const orr_yaml_node *empty = orbit->next;
    assert_true(empty->kind == ORR_YAML_TEXT && empty->text[0] == '\0' && !empty->quoted &&
                empty->next == NULL);
    orr_yaml_free(&y);
}

static void an_empty_text_is_an_empty_tree(void **state)
{
    (void)state;
    orr_yaml y;
    orr_diag diag = {0};
    ASSERT_OK(parse("", &y, &diag), diag);
    assert_null(y.root);
    orr_yaml_free(&y);
    ASSERT_OK(parse("# nothing\n", &y, &diag), diag);
    assert_null(y.root);
    orr_yaml_free(&y);
}

static void refusals_say_where(void **state)
{
    (void)state;
    const struct {
        const char *text;
        orr_status status;
        int line;
        const char *word;
    } cases[] = {
        {"a: 1\nb: [1, 2\nc: 3\n", ORR_E_FORMAT, 0, "not YAML"},
        {"a: 1\n  b: 2\n", ORR_E_FORMAT, 1, "not YAML"},
        {"a: \"x\n", ORR_E_FORMAT, 0, "not YAML"},
        {"a: 1\nb: 2\na: 3\n", ORR_E_FORMAT, 3, "second time"},
        {"a: &x 1\nb: *x\n", ORR_E_FORMAT, 2, "aliases"},
        {"a: !!int 1\n", ORR_E_FORMAT, 1, "tags"},
        {"a: 1\n---\nb: 2\n", ORR_E_FORMAT, 2, "second document"},
        {"[1, 2]: 3\n", ORR_E_FORMAT, 1, "plain word"},
        {"a: \x01\n", ORR_E_FORMAT, 1, "control character"},
        {"a: b\n%YAML 1.2\n", ORR_E_FORMAT, 2, "directives"},
        {"a: \xc3(\n", ORR_E_FORMAT, 1, "no UTF-8"},            // a broken pair
        {"a: \xc0\x80\n", ORR_E_FORMAT, 1, "no UTF-8"},         // overlong
        {"a: \xed\xa0\x80\n", ORR_E_FORMAT, 1, "no UTF-8"},     // a surrogate
        {"a: \xf4\x90\x80\x80\n", ORR_E_FORMAT, 1, "no UTF-8"}, // beyond U+10FFFF
        {"a: \xe2\x82", ORR_E_FORMAT, 1, "no UTF-8"},           // cut
        {"a: \"x\\0y\"\n", ORR_E_FORMAT, 1, "NUL"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_yaml y;
        orr_diag diag = {0};
        orr_status s = parse(cases[i].text, &y, &diag);
        if (s != cases[i].status || strstr(diag.text, cases[i].word) == NULL ||
            (cases[i].line != 0 && diag.line != cases[i].line))
            fail_msg("'%s': status %d, line %lld, \"%s\"", cases[i].text, s, (long long)diag.line, diag.text);
        assert_string_equal(diag.file, "s.yaml");
        assert_null(y.root);
        assert_null(y.made); // nothing is left to free
    }
}

static void limits(void **state)
{
    (void)state;
    orr_yaml y;
    orr_diag diag = {0};
    char deep[400];
    memset(deep, '[', 200);
    memset(deep + 200, ']', 199);
    deep[399] = '\0';
    assert_int_not_equal(parse(deep, &y, &diag), ORR_OK);
    char *many = malloc(2 * ORR_YAML_MAX_NODES + 10);
    many[0] = '[';
    for (int i = 0; i < ORR_YAML_MAX_NODES; i++) memcpy(many + 1 + 2 * i, "1,", 2);
    strcpy(many + 1 + 2 * ORR_YAML_MAX_NODES, "]");
    assert_int_equal(parse(many, &y, &diag), ORR_E_LIMIT);
    free(many);
    char *keys = malloc(20 * (ORR_YAML_MAX_KEYS + 1) + 1), *p = keys;
    for (int i = 0; i <= ORR_YAML_MAX_KEYS; i++) p += sprintf(p, "k%d: 1\n", i);
    assert_int_equal(parse(keys, &y, &diag), ORR_E_LIMIT);
    free(keys);
    char *big = malloc(ORR_YAML_MAX_BYTES + 2);
    memset(big, ' ', ORR_YAML_MAX_BYTES + 1);
    big[ORR_YAML_MAX_BYTES + 1] = '\0';
    assert_int_equal(parse(big, &y, &diag), ORR_E_LIMIT);
    free(big);
}

static void files_that_cannot_be_read(void **state)
{
    (void)state;
    orr_yaml y;
    orr_diag diag = {0};
    assert_int_equal(orr_yaml_read("/nonexistent/s.yaml", &y, &diag), ORR_E_IO);
    assert_string_equal(diag.file, "/nonexistent/s.yaml");
    assert_int_equal(orr_yaml_read("/", &y, &diag), ORR_E_IO);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tree_with_places),          cmocka_unit_test(an_empty_text_is_an_empty_tree),
        cmocka_unit_test(refusals_say_where),        cmocka_unit_test(limits),
        cmocka_unit_test(files_that_cannot_be_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

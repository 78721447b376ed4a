// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of NTRIP clients, read as they come, and the answers' heads.
#include "src/service/ports/ntrip.h"

#include <string.h>

#include "testing.h"

static orr_ntrip_request read_whole(const char *text)
{
    orr_ntrip_request r;
    const size_t n = strlen(text);
    for (size_t k = 0; k < n; k++) assert_int_equal(orr_ntrip_read(text, k, &r), ORR_NTRIP_MORE);
    assert_int_equal(orr_ntrip_read(text, n, &r), ORR_NTRIP_WHOLE);
    return r;
}

static void both_revisions_are_read(void **state)
{
    (void)state;
    orr_ntrip_request r = read_whole(
        "GET /BASE HTTP/1.0\r\nUser-Agent: NTRIP x\r\nAuthorization: Basic dXNlcjpzZWNyZXQ=\r\n\r\n");
    assert_string_equal(r.mount, "BASE");
    assert_string_equal(r.login, "dXNlcjpzZWNyZXQ=");
    assert_int_equal(r.revision, 1);
    assert_false(r.http_1_1);
    assert_true(orr_ntrip_login(r.login, "user:secret"));
    assert_false(orr_ntrip_login(r.login, "user:secre"));
    assert_false(orr_ntrip_login("", "user:secret"));
    r = read_whole("get /B-1 http/1.1\nNTRIP-VERSION:   ntrip/2.0  \nauthorization: basic QQ==\n\n");
    assert_string_equal(r.mount, "B-1");
    assert_int_equal(r.revision, 2);
    assert_true(r.http_1_1);
    assert_string_equal(r.login, "QQ==");
    assert_string_equal(read_whole("GET / HTTP/1.1\r\n\r\n").mount, "");
    assert_int_equal(read_whole("GET / HTTP/1.1\r\nNtrip-Version: Ntrip/1.0\r\n\r\n").revision, 1);
}

static void what_is_none_is_told(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        orr_ntrip_verdict verdict;
    } cases[] = {
        {"SOURCE secret /BASE\r\n", ORR_NTRIP_NOT_GET}, {"POST /BASE HTTP/1.1\r\n", ORR_NTRIP_NOT_GET},
        {"GET BASE HTTP/1.0\r\n", ORR_NTRIP_NO_HTTP},   {"GET /BASE\r\n", ORR_NTRIP_NO_HTTP},
        {"GET /BASE HTTP/2\r\n", ORR_NTRIP_NO_HTTP},    {"\r\n", ORR_NTRIP_NO_HTTP},
        {"GET /B\x07 HTTP/1.0\r\n", ORR_NTRIP_NO_HTTP}, {"\x16\x03\x01\n", ORR_NTRIP_NO_HTTP}};
    orr_ntrip_request r;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        assert_int_equal(orr_ntrip_read(cases[k].text, strlen(cases[k].text), &r), cases[k].verdict);
    char text[ORR_NTRIP_REQUEST];
    memset(text, 'x', sizeof text);
    memcpy(text, "GET /", 5);
    assert_int_equal(orr_ntrip_read(text, sizeof text - 1, &r), ORR_NTRIP_MORE);
    assert_int_equal(orr_ntrip_read(text, sizeof text, &r), ORR_NTRIP_TOO_LONG);
    memcpy(text, "GET / HTTP/1.0\n", 15);
    assert_int_equal(orr_ntrip_read(text, sizeof text, &r), ORR_NTRIP_TOO_LONG);
    char mount[200] = "GET /";
    memset(mount + 5, 'm', ORR_NTRIP_NAME);
    strcpy(mount + 5 + ORR_NTRIP_NAME, " HTTP/1.0\r\n\r\n");
    assert_int_equal(orr_ntrip_read(mount, strlen(mount), &r), ORR_NTRIP_WHOLE);
    assert_true(r.too_long);
    assert_string_equal(r.mount, "");
}

static void answers_by_revision(void **state)
{
    (void)state;
    char head[ORR_NTRIP_HEAD];
    orr_ntrip_request r = {.revision = 1, .mount = "BASE"};
    assert_int_equal(orr_ntrip_head(&r, ORR_NTRIP_STREAM, 0, head), 14);
    assert_string_equal(head, "ICY 200 OK\r\n\r\n");
    orr_ntrip_head(&r, ORR_NTRIP_TABLE, 17, head);
    assert_non_null(strstr(head, "SOURCETABLE 200 OK\r\n"));
    assert_non_null(strstr(head, "Content-Length: 17\r\n"));
    orr_ntrip_head(&r, ORR_NTRIP_UNAUTHORISED, 0, head);
    assert_non_null(strstr(head, "HTTP/1.0 401 Unauthorized\r\n"));
    assert_non_null(strstr(head, "WWW-Authenticate: Basic realm=\"/BASE\"\r\n"));
    r.revision = 2;
    orr_ntrip_head(&r, ORR_NTRIP_STREAM, 0, head);
    assert_null(strstr(head, "chunked")); // HTTP/1.0 knows none
    r.http_1_1 = true;
    orr_ntrip_head(&r, ORR_NTRIP_STREAM, 0, head);
    assert_non_null(strstr(head, "HTTP/1.1 200 OK\r\nNtrip-Version: Ntrip/2.0\r\n"));
    assert_non_null(strstr(head, "Transfer-Encoding: chunked\r\n"));
    orr_ntrip_head(NULL, ORR_NTRIP_NO_SOURCES, 0, head);
    assert_non_null(strstr(head, "405 Method Not Allowed\r\n"));
    assert_non_null(strstr(head, "Allow: GET\r\n"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_revisions_are_read),
        cmocka_unit_test(what_is_none_is_told),
        cmocka_unit_test(answers_by_revision),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

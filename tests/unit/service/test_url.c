// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/url.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "testing.h"

static void what_is_read_is_written(void **state)
{
    (void)state;
    const char *const cases[][2] = {
        {"tcp://127.0.0.1:4000", "tcp://127.0.0.1:4000"},
        {"tcp://[::1]:65535", "tcp://[::1]:65535"},
        {"tcp://localhost", "tcp://localhost:15754"},
        {"tcp://", "tcp://127.0.0.1:15754"},
        {"tcp://:0", "tcp://127.0.0.1:0"},
        {"tcp://*:0", "tcp://*:0"},
        {"unix:/run/x.sock", "unix:/run/x.sock"},
        {"unix:///run/x.sock", "unix:/run/x.sock"},
        {"unix:x.sock", "unix:x.sock"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_url u;
        orr_diag diag = {0};
        char text[ORR_URL_TEXT];
        ASSERT_OK(orr_url_parse(cases[i][0], &u, &diag), diag);
        assert_string_equal(orr_url_text(&u, text), cases[i][1]);
    }
}

static void what_is_no_url(void **state)
{
    (void)state;
    char longest[300] = "unix:";
    memset(longest + 5, 'x', 200);
    const char *const cases[] = {"",
                                 "tcp",
                                 "tcp:/x",
                                 "http://x:1",
                                 "tcp://x:",
                                 "tcp://x:1x",
                                 "tcp://x:-1",
                                 "tcp://x:65536",
                                 "tcp://x:999999",
                                 "tcp://[::1:80",
                                 "tcp://x:1/y",
                                 "unix:",
                                 "tcp://x: 80",
                                 "tcp://x/y",
                                 longest};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_url u;
        orr_diag diag = {0};
        assert_int_equal(orr_url_parse(cases[i], &u, &diag), ORR_E_ARG);
        assert_true(strlen(diag.text) > 20);
    }
}

static void local_or_not(void **state)
{
    (void)state;
    const struct {
        const char *url;
        bool local;
    } cases[] = {{"tcp://127.0.0.1:1", true}, {"tcp://127.3.0.1:1", true},
                 {"tcp://[::1]:1", true},     {"unix:x", true},
                 {"tcp://0.0.0.0:1", false},  {"tcp://[::]:1", false},
                 {"tcp://10.0.0.1:1", false}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_url u;
        assert_int_equal(orr_url_parse(cases[i].url, &u, NULL), ORR_OK);
        assert_int_equal(orr_url_is_local(&u), cases[i].local);
    }
}

static void a_port_in_use(void **state)
{
    (void)state;
    orr_url u, bound, again;
    orr_diag diag = {0};
    int fd, other;
    assert_int_equal(orr_url_parse("tcp://127.0.0.1:0", &u, &diag), ORR_OK);
    ASSERT_OK(orr_url_listen(&u, 5, &fd, &bound, &diag), diag);
    assert_true(bound.port > 0);
    assert_int_equal(orr_url_listen(&bound, 5, &other, &again, &diag), ORR_E_IO);
    assert_non_null(strstr(diag.text, "another program is listening there"));
    ASSERT_OK(orr_url_connect(&bound, 5, &other, &diag), diag);
    close(other);
    close(fd);
    assert_int_equal(orr_url_connect(&bound, 5, &other, &diag), ORR_E_IO); // nobody there any more
}

// Every address: IPv4 reaches it, and IPv6 where the machine has it; a client needs one.
static void any_address(void **state)
{
    (void)state;
    orr_url u, bound;
    orr_diag diag = {0};
    int fd, other;
    assert_int_equal(orr_url_parse("tcp://*:0", &u, &diag), ORR_OK);
    ASSERT_OK(orr_url_listen(&u, 5, &fd, &bound, &diag), diag);
    assert_true(strcmp(bound.host, "*") == 0 && bound.port > 0 && !orr_url_is_local(&bound));
    assert_int_equal(orr_url_connect(&bound, 5, &other, &diag), ORR_E_ARG);
    memcpy(bound.host, "127.0.0.1", sizeof "127.0.0.1");
    ASSERT_OK(orr_url_connect(&bound, 5, &other, &diag), diag);
    close(other);
    struct sockaddr_storage own;
    socklen_t n = sizeof own;
    assert_int_equal(getsockname(fd, (struct sockaddr *)&own, &n), 0);
    memcpy(bound.host, "::1", sizeof "::1");
    if (own.ss_family == AF_INET6 && orr_url_connect(&bound, 5, &other, &diag) == ORR_OK) close(other);
    close(fd);
}

static void unix_sockets(void **state)
{
    (void)state;
    char dir[] = "/tmp/orrery-url-XXXXXX", text[200];
    assert_non_null(mkdtemp(dir));
    orr_url u, bound;
    orr_diag diag = {0};
    int fd, other;
    snprintf(text, sizeof text, "unix:%s/s", dir);
    assert_int_equal(orr_url_parse(text, &u, &diag), ORR_OK);
    assert_int_equal(orr_url_connect(&u, 5, &fd, &diag), ORR_E_IO);
    ASSERT_OK(orr_url_listen(&u, 5, &fd, &bound, &diag), diag);
    assert_int_equal(orr_url_listen(&u, 5, &other, &bound, &diag), ORR_E_IO); // a live one is left alone
    ASSERT_OK(orr_url_connect(&u, 5, &other, &diag), diag);
    close(other);
    close(fd); // the file stays, as after a kill
    ASSERT_OK(orr_url_listen(&u, 5, &fd, &bound, &diag), diag);
    close(fd);
    unlink(u.path);
    FILE *f = fopen(u.path, "w"); // a file that is no socket is not ours to remove
    assert_non_null(f);
    fclose(f);
    assert_int_equal(orr_url_listen(&u, 5, &fd, &bound, &diag), ORR_E_IO);
    assert_non_null(strstr(diag.text, "no socket"));
    unlink(u.path);
    rmdir(dir);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_read_is_written),
        cmocka_unit_test(what_is_no_url),
        cmocka_unit_test(local_or_not),
        cmocka_unit_test(a_port_in_use),
        cmocka_unit_test(any_address),
        cmocka_unit_test(unix_sockets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

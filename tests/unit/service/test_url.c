// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/url.h"

#include <arpa/inet.h>
#include <netinet/in.h>
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
        {"unix://///run/x.sock", "unix:/run/x.sock"},
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
                                 "tcp://[host]:80",
                                 "tls://a b:80",
                                 "tcp://\x01:80",
                                 "tcp://[]:80",
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

// By these and nothing else a peer without a certificate is taken for one on this machine (S9, S13).
static void addresses_of_loopback(void **state)
{
    (void)state;
    const struct {
        const char *text;
        bool local;
    } cases[] = {{"127.0.0.1", true},
                 {"127.255.255.254", true},
                 {"128.0.0.1", false},
                 {"126.255.255.255", false},
                 {"10.0.0.1", false},
                 {"0.0.0.0", false},
                 {"::1", true},
                 {"::2", false},
                 {"::", false},
                 {"::ffff:127.0.0.1", true},
                 {"::ffff:127.9.9.9", true},
                 {"::ffff:10.0.0.1", false},
                 {"::ffff:128.0.0.1", false},
                 {"64:ff9b::7f00:1", false},
                 {"::127.0.0.1", false},
                 {"fe80::1", false}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct sockaddr_in v4 = {.sin_family = AF_INET};
        struct sockaddr_in6 v6 = {.sin6_family = AF_INET6};
        const bool four = inet_pton(AF_INET, cases[i].text, &v4.sin_addr) == 1;
        if (!four) assert_int_equal(inet_pton(AF_INET6, cases[i].text, &v6.sin6_addr), 1);
        const struct sockaddr *a = four ? (struct sockaddr *)&v4 : (struct sockaddr *)&v6;
        if (orr_address_is_local(a) != cases[i].local) fail_msg("%s", cases[i].text);
    }
    const struct sockaddr none = {.sa_family = AF_UNSPEC};
    assert_false(orr_address_is_local(&none));
}

// Sockets that somebody hands over, and sockets of datagrams, say where they are.
static void sockets_have_addresses(void **state)
{
    (void)state;
    const char *const where[] = {"tcp://127.0.0.1:0", "tcp://[::1]:0"};
    for (size_t i = 0; i < 2; i++) {
        orr_url u, bound, told;
        orr_diag diag = {0};
        int fd, other;
        assert_int_equal(orr_url_parse(where[i], &u, &diag), ORR_OK);
        if (orr_url_listen(&u, 5, &fd, &bound, &diag) != ORR_OK && i == 1) {
            print_message("no IPv6 here\n");
            continue;
        }
        ASSERT_OK(orr_url_of_socket(fd, &told, &diag), diag);
        assert_string_equal(told.host, u.host);
        assert_int_equal(told.port, bound.port);
        assert_true(orr_url_is_local(&told));
        ASSERT_OK(orr_url_connect(&bound, 5, &other, &diag), diag);
        assert_int_equal(orr_url_of_socket(other, &told, &diag), ORR_E_ARG); // connected, not listening
        close(other);
        close(fd);
        ASSERT_OK(orr_url_bind_datagrams(&u, &fd, &bound, &diag), diag);
        assert_true(bound.port > 0);
        assert_string_equal(bound.host, u.host);
        assert_int_equal(orr_url_of_socket(fd, &told, &diag), ORR_E_ARG); // datagrams
        assert_int_equal(orr_url_bind_datagrams(&bound, &other, &told, &diag), ORR_E_IO);
        close(fd);
    }
    orr_url u, bound;
    orr_diag diag = {0};
    int fd;
    assert_int_equal(orr_url_parse("unix:somewhere", &u, &diag), ORR_OK);
    assert_int_equal(orr_url_bind_datagrams(&u, &fd, &bound, &diag), ORR_E_ARG);
    assert_int_equal(orr_url_parse("tcp://no.such.name.invalid:1", &u, &diag), ORR_OK);
    assert_int_equal(orr_url_bind_datagrams(&u, &fd, &bound, &diag), ORR_E_ARG);
    assert_int_equal(orr_url_of_socket(-1, &bound, &diag), ORR_E_ARG);
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
        cmocka_unit_test(addresses_of_loopback),
        cmocka_unit_test(sockets_have_addresses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

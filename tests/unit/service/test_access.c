// SPDX-License-Identifier: GPL-3.0-or-later
// Who comes in from other machines, and what he may do: the invariants of docs/security.md, over real sockets and TLS.
#include "src/service/net/access.h"

#include <netinet/in.h>
#include <openssl/err.h>
#include <signal.h>
#include <sys/stat.h>

#include "served.h"
#include "src/service/net/certificates.h"
#include "src/service/net/peers.h"

// A laboratory in a folder of its own: an authority, a server, clients.
typedef struct lab {
    char dir[64], file[100];
} lab;

static const char *path_in(const char *dir, const char *name)
{
    static char path[2][200];
    static int turn;
    turn = 1 - turn;
    snprintf(path[turn], sizeof path[turn], "%s/%s", dir, name);
    return path[turn];
}

static void write_rules(const lab *l, const char *more)
{
    FILE *f = fopen(l->file, "w");
    assert_non_null(f);
    fprintf(f,
            "certificate: server.pem\nkey: server.key\nauthority: ca.pem\nclients:\n"
            "  - {name: all, may: [read, motion, control]}\n  - {name: reader, may: read}\n"
            "  - {name: cockpit, may: motion}\n%s",
            more);
    fclose(f);
}

static void make_authority(const char *dir)
{
    static const char *const names[] = {"127.0.0.1", "localhost"};
    orr_diag diag = {0};
    ASSERT_OK(orr_certificates_authority(dir, 30, &diag), diag);
    ASSERT_OK(orr_certificates_server(dir, names, 2, 30, &diag), diag);
}

static void make_client(const char *dir, const char *name, int days)
{
    orr_diag diag = {0};
    ASSERT_OK(orr_certificates_client(dir, name, days, &diag), diag);
}

static lab make_lab(void)
{
    lab l = {.dir = "/tmp/orrery-access-XXXXXX"};
    assert_non_null(mkdtemp(l.dir));
    snprintf(l.file, sizeof l.file, "%s/access.yaml", l.dir);
    make_authority(l.dir);
    make_client(l.dir, "all", 30);
    make_client(l.dir, "reader", 30);
    make_client(l.dir, "cockpit", 30);
    make_client(l.dir, "stranger", 30);
    write_rules(&l, "");
    return l;
}

static void remove_lab(const lab *l)
{
    char command[100];
    snprintf(command, sizeof command, "rm -r '%s'", l->dir);
    assert_int_equal(system(command), 0);
}

static orr_access *rules_of(const char *file)
{
    orr_access *a;
    orr_diag diag = {0};
    ASSERT_OK(orr_access_open(file, false, ORR_MAY_ALL, &a, &diag), diag);
    return a;
}

static bench *start_tls(orr_access *a)
{
    static const char *const url[] = {"tls://127.0.0.1:0"};
    orr_service_options o = quick_options();
    o.url = url;
    o.access = a;
    return start(o, 3);
}

static orr_dial *dial_as(const bench *b, const char *dir, const char *name, orr_status *s)
{
    char file[20];
    orr_dial *d = NULL;
    orr_diag diag = {0};
    snprintf(file, sizeof file, "%s.pem", name);
    *s = orr_dial_open(orr_service_url(b->service, 0), path_in(dir, file), 10, &d, &diag);
    return d;
}

// What a client gets: 0 when POLL was answered, an error code, or -1 for no connection.
static int poll_as(const bench *b, const char *dir, const char *name)
{
    orr_status s;
    orr_dial *d = dial_as(b, dir, name, &s);
    if (d == NULL) return -1;
    const orr_msg_poll poll = {.epochs = {5, 0, 1}};
    orr_msg_states m;
    orr_wire_status w = orr_client_poll(&d->client, &poll);
    if (w == ORR_WIRE_OK) w = orr_client_states(&d->client, &m);
    const int got = w == ORR_WIRE_OK ? 0 : w == ORR_WIRE_REFUSED ? d->client.error_code : -1;
    orr_dial_close(d);
    return got;
}

// (S2, S3) A certificate of the authority whose name the file has, and nobody else.
static void certificates_decide(void **state)
{
    (void)state;
    lab l = make_lab(), other = make_lab();
    make_client(l.dir, "all-expired", -1);
    orr_access *a = rules_of(l.file);
    bench *b = start_tls(a);
    assert_int_equal(poll_as(b, l.dir, "all"), 0);
    assert_int_equal(poll_as(b, l.dir, "reader"), 0);
    assert_int_equal(poll_as(b, l.dir, "stranger"), ORR_MSG_ERROR_CODE_NOT_PERMITTED);
    // Of another authority: with ours beside it, so that only the server can find it wrong.
    FILE *f = fopen(path_in(other.dir, "ca.pem"), "w"), *from = fopen(path_in(l.dir, "ca.pem"), "r");
    for (int c; (c = fgetc(from)) != EOF;) fputc(c, f);
    fclose(f);
    fclose(from);
    assert_int_equal(poll_as(b, other.dir, "all"), -1);
    assert_true(said_soon(b, "local issuer certificate"));
    // The client looks too: a server of another authority is none of its.
    orr_access *wrong = rules_of(other.file);
    bench *c = start_tls(wrong);
    assert_int_equal(poll_as(c, l.dir, "all"), -1);
    finish(c);
    orr_access_close(wrong);
    // A server's certificate is not a client's.
    orr_diag diag = {0};
    orr_dial *d = NULL;
    assert_int_equal(
        orr_dial_open(orr_service_url(b->service, 0), path_in(l.dir, "all-expired.pem"), 10, &d, &diag),
        ORR_E_FORMAT);
    assert_non_null(strstr(diag.text, "expired"));
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
    remove_lab(&other);
}

// A client of our own making, without what orr_dial looks after: the server has to.
static SSL *shake(const bench *b, const char *certificate, const char *key, int *fd)
{
    orr_url u;
    orr_diag diag = {0};
    assert_int_equal(orr_url_parse(orr_service_url(b->service, 0), &u, &diag), ORR_OK);
    ASSERT_OK(orr_url_connect(&u, 10, fd, &diag), diag);
    SSL_CTX *context = SSL_CTX_new(TLS_client_method());
    if (certificate != NULL) {
        assert_int_equal(SSL_CTX_use_certificate_chain_file(context, certificate), 1);
        assert_int_equal(SSL_CTX_use_PrivateKey_file(context, key, SSL_FILETYPE_PEM), 1);
    }
    SSL *ssl = SSL_new(context);
    SSL_CTX_free(context);
    SSL_set_fd(ssl, *fd);
    return ssl;
}

// Whether the server answers a PING behind the handshake.
static bool answers(SSL *ssl)
{
    uint8_t frame[100], back[100];
    orr_wire_writer w = {frame, 0, sizeof frame, ORR_WIRE_OK};
    size_t start_;
    const orr_msg_ping ping = {7};
    orr_frame_begin(&w, ORR_MSG_TYPE_PING, 1, &start_);
    orr_msg_ping_encode(&ping, &w);
    orr_frame_end(&w, start_);
    size_t n = 0;
    const bool got = SSL_connect(ssl) == 1 && SSL_write_ex(ssl, frame, w.size, &n) == 1 &&
                     SSL_read_ex(ssl, back, sizeof back, &n) == 1;
    ERR_clear_error();
    return got && n > 8 && back[6] == ORR_MSG_TYPE_PONG;
}

static bool answers_to(const bench *b, const char *certificate, const char *key, int most_version)
{
    int fd;
    SSL *ssl = shake(b, certificate, key, &fd);
    if (most_version != 0) SSL_set_max_proto_version(ssl, most_version);
    const bool good = answers(ssl);
    SSL_free(ssl);
    close(fd);
    return good;
}

// (S1, S2) No older TLS, no certificate, one that has expired, one that is a server's.
static void the_server_looks_itself(void **state)
{
    (void)state;
    lab l = make_lab();
    make_client(l.dir, "old", -1);
    orr_access *a = rules_of(l.file);
    bench *b = start_tls(a);
    char all[100], old[100];
    snprintf(all, sizeof all, "%s", path_in(l.dir, "all.pem"));
    snprintf(old, sizeof old, "%s", path_in(l.dir, "old.pem"));
    assert_true(answers_to(b, all, all, 0));
    assert_false(answers_to(b, all, all, TLS1_2_VERSION));
    assert_false(answers_to(b, NULL, NULL, 0));
    assert_true(said_soon(b, "peer did not return a certificate"));
    assert_false(answers_to(b, old, old, 0));
    assert_true(said_soon(b, "certificate has expired"));
    assert_false(answers_to(b, path_in(l.dir, "server.pem"), path_in(l.dir, "server.key"), 0));
    assert_true(said_soon(b, "certificate purpose"));
    // Without TLS there is no answer at all.
    int fd = raw(b);
    uint8_t frame[100];
    const size_t n = poll_frame(frame, sizeof frame, 1, 1);
    assert_int_equal(send(fd, frame, n, MSG_NOSIGNAL), (ssize_t)n);
    uint8_t back[200];
    const ssize_t got = recv(fd, back, sizeof back, 0);
    assert_true(got < 4 || memcmp(back, "ORRY", 4) != 0);
    close(fd);
    assert_true(answers_to(b, all, all, 0)); // and it lives on
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
}

static uint16_t access_told(const bench *b, const char *dir, const char *name)
{
    orr_status s;
    orr_msg_caps caps;
    orr_dial *d = dial_as(b, dir, name, &s);
    assert_int_equal(s, ORR_OK);
    assert_int_equal(orr_client_open(&d->client, "test", "1", &caps), ORR_WIRE_OK);
    orr_dial_close(d);
    return caps.access;
}

// (S4) CAPS tells what a name may do; polls need the permission to read.
static void permissions_hold(void **state)
{
    (void)state;
    lab l = make_lab();
    orr_access *a = rules_of(l.file);
    bench *b = start_tls(a);
    assert_int_equal(access_told(b, l.dir, "all"), 0);
    assert_int_equal(access_told(b, l.dir, "reader"), ORR_MSG_ACCESS_NO_MOTION | ORR_MSG_ACCESS_NO_CONTROL);
    assert_int_equal(access_told(b, l.dir, "cockpit"), ORR_MSG_ACCESS_NO_READING | ORR_MSG_ACCESS_NO_CONTROL);
    assert_int_equal(poll_as(b, l.dir, "cockpit"), ORR_MSG_ERROR_CODE_NOT_PERMITTED);
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
}

// (S5) Rules that are read again hold for who is connected; nobody else is dropped. Rules with a fault change nothing.
static void rules_are_read_again(void **state)
{
    (void)state;
    lab l = make_lab();
    orr_access *a = rules_of(l.file);
    orr_diag diag = {0};
    bench *b = start_tls(a);
    orr_status s;
    orr_dial *d = dial_as(b, l.dir, "all", &s);
    assert_int_equal(s, ORR_OK);
    assert_int_equal(orr_client_check(&d->client, 1), ORR_WIRE_OK);
    write_rules(&l, "  - {name: stranger, may: read}\n");
    make_authority(path_in(l.dir, "new")); // other certificates of the service
    assert_int_equal(rename(path_in(l.dir, "new/server.pem"), path_in(l.dir, "server.pem")), 0);
    assert_int_equal(orr_access_reload(a, &diag), ORR_E_FORMAT); // a certificate without its key
    assert_int_equal(poll_as(b, l.dir, "reader"), 0);
    assert_int_equal(poll_as(b, l.dir, "stranger"), ORR_MSG_ERROR_CODE_NOT_PERMITTED);
    assert_int_equal(rename(path_in(l.dir, "new/server.key"), path_in(l.dir, "server.key")), 0);
    ASSERT_OK(orr_access_reload(a, &diag), diag);
    assert_int_equal(orr_client_check(&d->client, 2), ORR_WIRE_OK); // the old connection lives on
    assert_int_equal(poll_as(b, l.dir, "reader"), -1);              // who knows the old authority alone
    assert_int_equal(rename(path_in(l.dir, "new/ca.pem"), path_in(l.dir, "trusted.pem")), 0);
    char certificate[100];
    snprintf(certificate, sizeof certificate, "%s", path_in(l.dir, "stranger.pem"));
    assert_true(answers_to(b, certificate, certificate, 0));
    FILE *f = fopen(l.file, "w");
    fputs("limits: {clients: none}\n", f);
    fclose(f);
    assert_int_equal(orr_access_reload(a, &diag), ORR_E_FORMAT);
    assert_int_equal(orr_client_check(&d->client, 3), ORR_WIRE_OK);
    orr_dial_close(d);
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
}

// (S6) A handshake that is not finished in time is ended, and those under way are counted: the rest are refused, who is served is served on.
static void slow_handshakes(void **state)
{
    (void)state;
    lab l = make_lab();
    write_rules(&l, "limits: {handshake_s: 1, handshakes: 4}\n");
    orr_access *a = rules_of(l.file);
    bench *b = start_tls(a);
    orr_status s;
    orr_dial *d = dial_as(b, l.dir, "all", &s);
    assert_int_equal(s, ORR_OK);
    assert_int_equal(orr_client_check(&d->client, 1), ORR_WIRE_OK);
    int slow[20];
    uint8_t waste[10];
    for (int k = 0; k < 20; k++) {
        slow[k] = raw(b);
        assert_int_equal(send(slow[k], "\x16\x03", 2, MSG_NOSIGNAL) >= 0, 1); // the begin of a handshake
    }
    for (int k = 0; k < 20; k++) {
        assert_true(recv(slow[k], waste, sizeof waste, 0) <= 0); // closed, not timed out on our side (10 s)
        close(slow[k]);
    }
    assert_true(said_soon(b, "as many TLS handshakes are under way as may be"));
    assert_true(said_soon(b, "its TLS handshake takes too long"));
    assert_int_equal(orr_client_check(&d->client, 2), ORR_WIRE_OK);
    assert_int_equal(poll_as(b, l.dir, "reader"), 0);
    orr_dial_close(d);
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
}

// (S7) Who sends KeyUpdate without end is cut off; a few are what any client may do.
static void key_updates(void **state)
{
    (void)state;
    lab l = make_lab();
    orr_access *a = rules_of(l.file);
    bench *b = start_tls(a);
    char all[100];
    snprintf(all, sizeof all, "%s", path_in(l.dir, "all.pem"));
    int fd, sent = 0;
    SSL *ssl = shake(b, all, all, &fd);
    assert_true(answers(ssl));
    for (bool alive = true; alive && sent < 500; sent++) {
        alive = SSL_key_update(ssl, SSL_KEY_UPDATE_REQUESTED) == 1 && answers(ssl);
        if (sent == 8) assert_true(alive);
    }
    assert_true(sent > 9 && sent < 100);
    ERR_clear_error();
    SSL_free(ssl);
    close(fd);
    assert_int_equal(poll_as(b, l.dir, "reader"), 0);
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
}

// (S8) Requests beyond the rate wait; none is lost, and another client is not held up.
static void rates(void **state)
{
    (void)state;
    lab l = make_lab();
    write_rules(&l, "limits: {local: true, requests_per_s: 400}\n");
    orr_access *a = rules_of(l.file);
    bench *b = start_tls(a);
    orr_status s;
    orr_dial *d = dial_as(b, l.dir, "all", &s), *other = dial_as(b, l.dir, "reader", &s);
    struct timespec t0, t1;
    clock_gettime(CLOCK_MONOTONIC, &t0);
    for (unsigned k = 0; k < 600; k++) assert_int_equal(orr_client_check(&d->client, k), ORR_WIRE_OK);
    clock_gettime(CLOCK_MONOTONIC, &t1);
    // Four hundred at once, then 200 at 400 a second: it cannot have been faster, whatever the machine does.
    assert_true((double)(t1.tv_sec - t0.tv_sec) + 1e-9 * (double)(t1.tv_nsec - t0.tv_nsec) > 0.45);
    assert_int_equal(orr_client_check(&other->client, 1), ORR_WIRE_OK);
    orr_dial_close(d);
    orr_dial_close(other);
    finish(b);
    orr_access_close(a);
    remove_lab(&l);
}

// (S8) Connections of one address: how many, and how fast.
static void addresses(void **state)
{
    (void)state;
    orr_peers *p = orr_peers_open();
    const char *why;
    struct sockaddr_in from = {.sin_family = AF_INET, .sin_addr = {0x0100000a}}, next = from;
    next.sin_addr.s_addr = 0x0200000a;
    const struct sockaddr *one = (struct sockaddr *)&from, *two = (struct sockaddr *)&next;
    orr_peer *e = NULL;
    int64_t now = 1000;
    for (int k = 0; k < 3; k++) assert_non_null(e = orr_peers_enter(p, one, 3, 0, now, &why));
    assert_null(orr_peers_enter(p, one, 3, 0, now, &why));
    assert_non_null(strstr(why, "as many connections"));
    assert_non_null(orr_peers_enter(p, two, 3, 0, now, &why));
    orr_peers_leave(e);
    assert_non_null(orr_peers_enter(p, one, 3, 0, now, &why));
    // Twice the rate at once, then the rate, and refusals cost nothing.
    int in = 0;
    for (int k = 0; k < 100; k++) in += orr_peers_enter(p, two, 1000, 5, now, &why) != NULL;
    assert_int_equal(in, 10);
    for (int k = 0; k < 100; k++) {
        now += 100000000; // 10 s in steps of 0.1
        in += orr_peers_enter(p, two, 1000, 5, now, &why) != NULL;
    }
    assert_in_range(in, 10 + 49, 10 + 50);
    // IPv6: a network of 64 bits is one address.
    struct sockaddr_in6 six = {.sin6_family = AF_INET6};
    six.sin6_addr.s6_addr[0] = 0x20;
    int open_ = 0;
    for (int k = 0; k < 10; k++) {
        six.sin6_addr.s6_addr[15] = (uint8_t)k;
        open_ += orr_peers_enter(p, (struct sockaddr *)&six, 4, 0, now, &why) != NULL;
    }
    assert_int_equal(open_, 4);
    // More addresses than there is room for push nobody out who is connected.
    for (uint32_t k = 0; k < 20000; k++) {
        from.sin_addr.s_addr = 0x00000b00 + k * 65536;
        orr_peers_leave(orr_peers_enter(p, one, 1, 1, now, &why));
    }
    six.sin6_addr.s6_addr[15] = 99;
    assert_null(orr_peers_enter(p, (struct sockaddr *)&six, 4, 0, now, &why));
    orr_peers_close(p);
}

// (S9) Other machines are listened to by TLS, or explicitly without; a Unix socket is its group's.
static void where_one_may_listen(void **state)
{
    (void)state;
    static const struct {
        const char *url;
        bool with_lab, insecure, good;
    } cases[] = {
        {"tcp://127.0.0.1:0", false, false, true}, {"tcp://localhost:0", false, false, true},
        {"tcp://*:0", false, false, false},        {"tcp://*:0", true, false, false},
        {"tcp://0.0.0.0:0", false, false, false},  {"tcp://*:0", false, true, true},
        {"tls://*:0", true, false, true},          {"tls://*:0", false, false, false},
        {"tls://127.0.0.1:0", false, true, false},
    };
    lab l = make_lab();
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        orr_access *a;
        orr_service *service = NULL;
        orr_diag diag = {0};
        ASSERT_OK(
            orr_access_open(cases[k].with_lab ? l.file : NULL, cases[k].insecure, ORR_MAY_ALL, &a, &diag),
            diag);
        orr_service_options o = quick_options();
        o.url = &cases[k].url;
        o.access = a;
        const orr_status s = orr_service_open(&o, NULL, NULL, &service, &diag);
        if ((s == ORR_OK) != cases[k].good) fail_msg("%s: %s", cases[k].url, diag.text);
        if (!cases[k].good) assert_int_equal(s, ORR_E_ARG);
        orr_service_close(service);
        orr_access_close(a);
    }
    char url[120];
    struct stat st;
    orr_diag diag = {0};
    orr_service *service = NULL;
    snprintf(url, sizeof url, "unix:%s/socket", l.dir);
    const char *const unix_url[] = {url};
    orr_service_options o = quick_options();
    o.url = unix_url;
    ASSERT_OK(orr_service_open(&o, NULL, NULL, &service, &diag), diag);
    assert_int_equal(stat(url + 5, &st), 0);
    assert_int_equal(st.st_mode & 07777, 0660);
    orr_service_close(service);
    remove_lab(&l);
}

// Private keys are their owner's; an authority that is there is not made anew.
static void certificates_are_kept(void **state)
{
    (void)state;
    static const char *const keys[] = {"ca.key", "server.key", "all.pem"};
    static const char *const wrong[] = {"a,DNS:b"};
    lab l = make_lab();
    struct stat st;
    orr_diag diag = {0};
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(stat(path_in(l.dir, keys[k]), &st), 0);
        assert_int_equal(st.st_mode & 07777, 0600);
    }
    assert_int_equal(orr_certificates_authority(l.dir, 30, &diag), ORR_E_ARG);
    assert_int_equal(orr_certificates_server(l.dir, wrong, 1, 30, &diag), ORR_E_ARG);
    assert_int_equal(orr_certificates_client(l.dir, "../x", 30, &diag), ORR_E_ARG);
    assert_int_equal(orr_certificates_client(l.dir, "ca", 30, &diag), ORR_E_ARG);
    assert_int_equal(orr_certificates_client(path_in(l.dir, "none"), "x", 30, &diag), ORR_E_IO);
    remove_lab(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(certificates_decide),
        cmocka_unit_test(the_server_looks_itself),
        cmocka_unit_test(permissions_hold),
        cmocka_unit_test(rules_are_read_again),
        cmocka_unit_test(slow_handshakes),
        cmocka_unit_test(key_updates),
        cmocka_unit_test(rates),
        cmocka_unit_test(addresses),
        cmocka_unit_test(where_one_may_listen),
        cmocka_unit_test(certificates_are_kept),
    };
    signal(SIGPIPE, SIG_IGN); // as the program does
    return cmocka_run_group_tests(tests, NULL, NULL);
}

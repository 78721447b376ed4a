// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/tls.h"

#include <errno.h>
#include <openssl/err.h>
#include <openssl/x509v3.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "core/monotonic.h"

enum {
    CERTIFICATE_BYTES = 16 << 10, // a peer's chain, at most
    KEY_UPDATES = 16,             // at once, then one a second
};

char *orr_tls_reason_of(const SSL *ssl, unsigned long error, char *buf, size_t n)
{
    const char *reason = error != 0 ? ERR_reason_error_string(error) : NULL;
    const long verified = ssl != NULL ? SSL_get_verify_result(ssl) : X509_V_OK;
    if (verified != X509_V_OK)
        snprintf(buf, n, "certificate verify failed: %s", X509_verify_cert_error_string(verified));
    else
        snprintf(buf, n, "%s", reason != NULL ? reason : "the peer broke off");
    return buf;
}

char *orr_tls_reason(const SSL *ssl, char *buf, size_t n)
{
    orr_tls_reason_of(ssl, ERR_peek_last_error(), buf, n);
    ERR_clear_error();
    return buf;
}

static orr_status blame(const char *path, const char *what, orr_diag *diag)
{
    const unsigned long e = ERR_peek_error();
    const bool system = ERR_SYSTEM_ERROR(e);
    char reason[200];
    orr_tls_reason(NULL, reason, sizeof reason);
    if (access(path, R_OK) != 0)
        return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read: %s", strerror(errno));
    return orr_diag_at(diag, system ? ORR_E_IO : ORR_E_FORMAT, path, 0, 0, "%s: %s", what, reason);
}

// A certificate out of date is told when it is loaded, not by every client.
static orr_status check_dates(SSL_CTX *context, const char *path, orr_diag *diag)
{
    const X509 *own = SSL_CTX_get0_certificate(context);
    if (X509_cmp_current_time(X509_get0_notAfter(own)) < 0)
        return orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "the certificate has expired: make another");
    if (X509_cmp_current_time(X509_get0_notBefore(own)) > 0)
        return orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "the certificate is not valid yet");
    return ORR_OK;
}

static orr_status load(SSL_CTX *context, const orr_tls_files *f, bool server, orr_diag *diag)
{
    if (SSL_CTX_use_certificate_chain_file(context, f->certificate) != 1)
        return blame(f->certificate, "holds no certificate", diag);
    if (SSL_CTX_use_PrivateKey_file(context, f->key, SSL_FILETYPE_PEM) != 1)
        return blame(f->key, "holds no private key of that certificate", diag);
    if (SSL_CTX_load_verify_file(context, f->authority) != 1)
        return blame(f->authority, "holds no certificate", diag);
    if (server) { // the names that a client is told, so that it can choose among its certificates
        STACK_OF(X509_NAME) *names = SSL_load_client_CA_file(f->authority);
        if (names == NULL) return blame(f->authority, "holds no certificate", diag);
        SSL_CTX_set_client_CA_list(context, names);
    }
    return check_dates(context, f->certificate, diag);
}

// OpenSSL has no limit of its own.
static void see_message(int sent, int version, int type, const void *data, size_t n, SSL *ssl, void *user)
{
    (void)version;
    (void)user;
    uint64_t held;
    orr_log_rate *rate = SSL_get_app_data(ssl);
    if (sent || type != SSL3_RT_HANDSHAKE || n < 1 || *(const unsigned char *)data != SSL3_MT_KEY_UPDATE)
        return;
    if (rate != NULL && !orr_log_rate_allows(rate, orr_monotonic_ns(), &held))
        shutdown(SSL_get_fd(ssl), SHUT_RDWR);
}

void orr_tls_limit_updates(SSL *ssl, orr_log_rate *rate)
{
    *rate = (orr_log_rate){.burst = KEY_UPDATES, .every_ns = 1000000000};
    SSL_set_app_data(ssl, rate);
}

orr_status orr_tls_context(const orr_tls_files *files, bool server, SSL_CTX **out, orr_diag *diag)
{
    ERR_clear_error();
    SSL_CTX *c = SSL_CTX_new(server ? TLS_server_method() : TLS_client_method());
    if (c == NULL || SSL_CTX_set_min_proto_version(c, TLS1_3_VERSION) != 1) {
        SSL_CTX_free(c);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    SSL_CTX_set_verify(c, SSL_VERIFY_PEER | (server ? SSL_VERIFY_FAIL_IF_NO_PEER_CERT : 0), NULL);
    SSL_CTX_set_max_cert_list(c, CERTIFICATE_BYTES);
    SSL_CTX_set_session_cache_mode(c, SSL_SESS_CACHE_OFF);
    SSL_CTX_set_options(c, SSL_OP_NO_TICKET | SSL_OP_IGNORE_UNEXPECTED_EOF);
    SSL_CTX_set_mode(c, SSL_MODE_RELEASE_BUFFERS);
    if (server) {
        SSL_CTX_set_num_tickets(c, 0);
        SSL_CTX_set_msg_callback(c, see_message);
    }
    const orr_status s = load(c, files, server, diag);
    if (s != ORR_OK) {
        SSL_CTX_free(c);
        return s;
    }
    *out = c;
    return ORR_OK;
}

bool orr_tls_peer_name(const SSL *ssl, char name[ORR_TLS_NAME])
{
    X509 *peer = SSL_get1_peer_certificate(ssl);
    if (peer == NULL) return false;
    X509_NAME *subject = X509_get_subject_name(peer);
    const int at = X509_NAME_get_index_by_NID(subject, NID_commonName, -1);
    bool good = at >= 0 && X509_NAME_get_index_by_NID(subject, NID_commonName, at) < 0;
    if (good) {
        const ASN1_STRING *text = X509_NAME_ENTRY_get_data(X509_NAME_get_entry(subject, at));
        const int n = ASN1_STRING_length(text);
        const unsigned char *data = ASN1_STRING_get0_data(text);
        good = n > 0 && n < ORR_TLS_NAME;
        for (int k = 0; good && k < n; k++) {
            good = data[k] >= ' ' && data[k] <= '~';
            name[k] = (char)data[k];
        }
        if (good) name[n] = '\0';
    }
    X509_free(peer);
    return good;
}

// OpenSSL writes to sockets as to files: a peer that has gone would end the program. The signal is held while it writes, and one that
// came meanwhile is taken.
typedef struct held_signal {
    sigset_t before;
    bool waits; // one that is not ours
} held_signal;

static void pipe_set(sigset_t *set)
{
    sigemptyset(set);
    sigaddset(set, SIGPIPE);
}

static held_signal hold_pipe(void)
{
    held_signal h;
    sigset_t one, now;
    pipe_set(&one);
    h.waits = sigpending(&now) == 0 && sigismember(&now, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &one, &h.before);
    return h;
}

static void release_pipe(const held_signal *h)
{
    static const struct timespec at_once = {0, 0};
    const int error = errno;
    sigset_t one;
    pipe_set(&one);
    if (!h->waits)
        while (sigtimedwait(&one, NULL, &at_once) < 0 && errno == EINTR) {
        }
    pthread_sigmask(SIG_SETMASK, &h->before, NULL);
    errno = error;
}

bool orr_tls_write(SSL *ssl, const void *data, size_t n, size_t *put)
{
    const held_signal h = hold_pipe();
    const bool good = SSL_write_ex(ssl, data, n, put) == 1;
    release_pipe(&h);
    return good;
}

void orr_tls_free(SSL *ssl)
{
    if (ssl == NULL) return;
    const held_signal h = hold_pipe();
    SSL_shutdown(ssl);
    SSL_free(ssl);
    release_pipe(&h);
    ERR_clear_error();
}

static bool shake_hands(SSL *ssl)
{
    const held_signal h = hold_pipe();
    const bool good = SSL_connect(ssl) == 1;
    release_pipe(&h);
    return good;
}

orr_status orr_tls_connect(SSL_CTX *context, int fd, const char *host, SSL **ssl, orr_diag *diag)
{
    ERR_clear_error();
    SSL *x = SSL_new(context);
    if (x == NULL || SSL_set_fd(x, fd) != 1) {
        SSL_free(x);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    }
    X509_VERIFY_PARAM *wanted = SSL_get0_param(x);
    // An address stands in a certificate as an address; a name may be told to the server too.
    bool named = X509_VERIFY_PARAM_set1_ip_asc(wanted, host) == 1;
    if (!named) named = SSL_set1_host(x, host) == 1 && SSL_set_tlsext_host_name(x, host) == 1;
    ERR_clear_error();
    if (!named || !shake_hands(x)) {
        char reason[200];
        orr_tls_reason(x, reason, sizeof reason);
        SSL_free(x);
        return orr_diag_set(diag, ORR_E_IO, "no TLS with %s: %s", host, reason);
    }
    *ssl = x;
    return ORR_OK;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/certificates.h"

#include <arpa/inet.h>
#include <ctype.h>
#include <errno.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/outfile.h"

#define AUTHORITY_NAME "Orrery laboratory authority"
enum { PATH = 4096, HOUR_S = 3600, DAY_S = 86400 };

// A key and its certificate.
typedef struct pair {
    EVP_PKEY *key;
    X509 *certificate;
} pair;

static void drop(pair *p)
{
    EVP_PKEY_free(p->key);
    X509_free(p->certificate);
    *p = (pair){NULL, NULL};
}

static orr_status no_memory(orr_diag *diag)
{
    ERR_clear_error();
    return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static orr_status place(char path[PATH], const char *dir, const char *name, const char *ending,
                        orr_diag *diag)
{
    if (snprintf(path, PATH, "%s/%s%s", dir, name, ending) < PATH) return ORR_OK;
    return orr_diag_set(diag, ORR_E_ARG, "%.100s...: the name is too long", dir);
}

// --- Files ---

// Writes certificate and key, where they are not NULL; a key makes the file its owner's alone.
static orr_status save(const char *dir, const char *name, const char *ending, X509 *certificate,
                       EVP_PKEY *key, orr_diag *diag)
{
    char path[PATH];
    orr_outfile out;
    orr_status s = place(path, dir, name, ending, diag);
    if (s == ORR_OK) s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) return s;
    bool good = fchmod(fileno(out.stream), key != NULL ? 0600 : 0644) == 0;
    good = good && (certificate == NULL || PEM_write_X509(out.stream, certificate) == 1);
    good =
        good && (key == NULL || PEM_write_PKCS8PrivateKey(out.stream, key, NULL, NULL, 0, NULL, NULL) == 1);
    if (!good) {
        s = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be written: %s", strerror(errno));
        ERR_clear_error();
    }
    return orr_outfile_end(&out, s, diag);
}

static FILE *open_part(const char *dir, const char *ending, char path[PATH], orr_status *s, orr_diag *diag)
{
    *s = place(path, dir, "ca", ending, diag);
    FILE *f = *s == ORR_OK ? fopen(path, "rb") : NULL;
    if (f == NULL && *s == ORR_OK)
        *s = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s ('orrery tls init' makes it)",
                         strerror(errno));
    return f;
}

static orr_status load_authority(const char *dir, pair *out, orr_diag *diag)
{
    char path[PATH];
    orr_status s;
    *out = (pair){NULL, NULL};
    FILE *f = open_part(dir, ".pem", path, &s, diag);
    if (f == NULL) return s;
    out->certificate = PEM_read_X509(f, NULL, NULL, NULL);
    fclose(f);
    if (out->certificate != NULL) {
        f = open_part(dir, ".key", path, &s, diag);
        if (f != NULL) {
            out->key = PEM_read_PrivateKey(f, NULL, NULL, NULL);
            fclose(f);
        }
    }
    if (s == ORR_OK && (out->key == NULL || X509_check_private_key(out->certificate, out->key) != 1))
        s = orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0,
                        "is no part of an authority that 'orrery tls init' made");
    ERR_clear_error();
    if (s != ORR_OK) drop(out);
    return s;
}

// --- Certificates ---

static bool extend(X509 *x, X509 *issuer, int what, const char *value)
{
    X509V3_CTX context;
    X509V3_set_ctx(&context, issuer, x, NULL, NULL, 0);
    X509_EXTENSION *e = X509V3_EXT_conf_nid(NULL, &context, what, value);
    const bool good = e != NULL && X509_add_ext(x, e, -1) == 1;
    X509_EXTENSION_free(e);
    return good;
}

// Who it is, from when to when, and with which number.
static bool describe(X509 *x, const char *name, int days)
{
    unsigned char number[16];
    if (RAND_bytes(number, sizeof number) != 1) return false;
    number[0] &= 0x7f; // positive
    BIGNUM *serial = BN_bin2bn(number, sizeof number, NULL);
    const bool numbered = serial != NULL && BN_to_ASN1_INTEGER(serial, X509_get_serialNumber(x)) != NULL;
    BN_free(serial);
    // An hour before now, for clocks that are behind; what has expired, began a day before that.
    const long from_s = days < 0 ? (days - 1) * (long)DAY_S : -HOUR_S;
    return numbered && X509_set_version(x, X509_VERSION_3) == 1 &&
           X509_gmtime_adj(X509_getm_notBefore(x), from_s) != NULL &&
           X509_time_adj_ex(X509_getm_notAfter(x), days, 0, NULL) != NULL &&
           X509_NAME_add_entry_by_NID(X509_get_subject_name(x), NID_commonName, MBSTRING_UTF8,
                                      (const unsigned char *)name, -1, -1, 0) == 1;
}

typedef struct extension {
    int what;
    const char *value;
} extension;

// A pair signed by an authority, or by itself (NULL); the extensions end with {0}.
static orr_status make(const pair *authority, const char *name, int days, const extension *with, pair *out,
                       orr_diag *diag)
{
    *out = (pair){EVP_EC_gen("P-256"), X509_new()};
    if (authority == NULL) authority = out;
    X509 *x = out->certificate;
    bool good = out->key != NULL && x != NULL && describe(x, name, days) &&
                X509_set_issuer_name(x, X509_get_subject_name(authority->certificate)) == 1 &&
                X509_set_pubkey(x, out->key) == 1 &&
                extend(x, authority->certificate, NID_subject_key_identifier, "hash") &&
                extend(x, authority->certificate, NID_authority_key_identifier, "keyid");
    for (; good && with->value != NULL; with++)
        good = extend(x, authority->certificate, with->what, with->value);
    good = good && X509_sign(x, authority->key, EVP_sha256()) > 0;
    if (good) return ORR_OK;
    drop(out);
    return no_memory(diag);
}

// A pair of an authority's folder.
static orr_status issue(const char *dir, const char *name, int days, const extension *with, pair *out,
                        orr_diag *diag)
{
    pair authority;
    orr_status s = load_authority(dir, &authority, diag);
    if (s == ORR_OK) s = make(&authority, name, days, with, out, diag);
    drop(&authority);
    return s;
}

orr_status orr_certificates_authority(const char *dir, int days, orr_diag *diag)
{
    static const extension with[] = {{NID_basic_constraints, "critical,CA:TRUE,pathlen:0"},
                                     {NID_key_usage, "critical,keyCertSign,cRLSign"},
                                     {0}};
    char path[PATH];
    pair p;
    if (mkdir(dir, 0700) != 0 && errno != EEXIST)
        return orr_diag_at(diag, ORR_E_IO, dir, 0, 0, "cannot be made: %s", strerror(errno));
    orr_status s = place(path, dir, "ca", ".pem", diag);
    if (s == ORR_OK && access(path, F_OK) == 0)
        s = orr_diag_at(
            diag, ORR_E_ARG, path, 0, 0,
            "there is an authority already: 'orrery tls client' and 'orrery tls server' make more "
            "certificates of it");
    if (s == ORR_OK) s = make(NULL, AUTHORITY_NAME, days, with, &p, diag);
    if (s != ORR_OK) return s;
    s = save(dir, "ca", ".key", NULL, p.key, diag);
    if (s == ORR_OK)
        s = save(dir, "ca", ".pem", p.certificate, NULL, diag); // last: without its key it is of no use
    drop(&p);
    return s;
}

// Letters, digits and a few signs: nothing that a file's name or an extension's syntax gives a meaning to.
static bool is_plain(const char *name, const char *signs, size_t most)
{
    const size_t n = strlen(name);
    for (size_t k = 0; k < n; k++)
        if (!isalnum((unsigned char)name[k]) && strchr(signs, name[k]) == NULL) return false;
    return n > 0 && n <= most && name[0] != '.';
}

orr_status orr_certificates_server(const char *dir, const char *const *names, size_t n, int days,
                                   orr_diag *diag)
{
    char list[PATH] = "";
    for (size_t k = 0; k < n; k++) {
        unsigned char waste[16];
        const bool address =
            inet_pton(AF_INET, names[k], waste) == 1 || inet_pton(AF_INET6, names[k], waste) == 1;
        const size_t at = strlen(list);
        if (!is_plain(names[k], address ? ".:" : ".-_", 253))
            return orr_diag_set(diag, ORR_E_ARG, "'%.100s' is no name or address of a machine", names[k]);
        if (snprintf(list + at, sizeof list - at, "%s%s:%s", k > 0 ? "," : "", address ? "IP" : "DNS",
                     names[k]) >= (int)(sizeof list - at))
            return orr_diag_set(diag, ORR_E_LIMIT, "too many names of the service");
    }
    const extension with[] = {{NID_basic_constraints, "critical,CA:FALSE"},
                              {NID_key_usage, "critical,digitalSignature"},
                              {NID_ext_key_usage, "serverAuth"},
                              {NID_subject_alt_name, list},
                              {0}};
    pair p;
    orr_status s = issue(dir, names[0], days, with, &p, diag);
    if (s != ORR_OK) return s;
    s = save(dir, "server", ".key", NULL, p.key, diag);
    if (s == ORR_OK) s = save(dir, "server", ".pem", p.certificate, NULL, diag);
    drop(&p);
    return s;
}

orr_status orr_certificates_client(const char *dir, const char *name, int days, orr_diag *diag)
{
    static const extension with[] = {{NID_basic_constraints, "critical,CA:FALSE"},
                                     {NID_key_usage, "critical,digitalSignature"},
                                     {NID_ext_key_usage, "clientAuth"},
                                     {0}};
    if (!is_plain(name, ".-_", 48) || strcmp(name, "ca") == 0 || strcmp(name, "server") == 0)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "'%.100s' is no name for a client: letters, digits, '-', '_' and '.', and neither ca nor "
            "server",
            name);
    pair p;
    orr_status s = issue(dir, name, days, with, &p, diag);
    if (s != ORR_OK) return s;
    s = save(dir, name, ".pem", p.certificate, p.key, diag);
    drop(&p);
    return s;
}

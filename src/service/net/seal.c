// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/seal.h"

#include <openssl/core_names.h>
#include <openssl/crypto.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/params.h>
#include <stdlib.h>
#include <string.h>

#include "proto/datagram.h"

struct orr_seal {
    EVP_MAC_CTX *mac;
};

bool orr_seal_keys_of(SSL *ssl, orr_seal_keys *out)
{
    static const char label[] = "EXPORTER-orrery-datagrams";
    uint8_t both[ORR_SEAL_KEYS];
    ERR_clear_error();
    if (SSL_export_keying_material(ssl, both, sizeof both, label, sizeof label - 1, NULL, 0, 1) != 1) {
        ERR_clear_error();
        return false;
    }
    memcpy(out->client, both, ORR_SEAL_KEY);
    memcpy(out->server, both + ORR_SEAL_KEY, ORR_SEAL_KEY);
    OPENSSL_cleanse(both, sizeof both);
    return true;
}

orr_seal *orr_seal_open(const uint8_t key[ORR_SEAL_KEY])
{
    char digest[] = "SHA256";
    const OSSL_PARAM p[] = {OSSL_PARAM_construct_utf8_string(OSSL_MAC_PARAM_DIGEST, digest, 0),
                            OSSL_PARAM_construct_end()};
    orr_seal *s = calloc(1, sizeof *s);
    EVP_MAC *kind = EVP_MAC_fetch(NULL, "HMAC", NULL);
    if (s != NULL && kind != NULL) s->mac = EVP_MAC_CTX_new(kind);
    EVP_MAC_free(kind);
    if (s != NULL && s->mac != NULL && EVP_MAC_init(s->mac, key, ORR_SEAL_KEY, p) == 1) return s;
    ERR_clear_error();
    orr_seal_close(s);
    return NULL;
}

void orr_seal_close(orr_seal *s)
{
    if (s == NULL) return;
    EVP_MAC_CTX_free(s->mac);
    free(s);
}

static bool compute(const orr_seal *s, const uint8_t *data, size_t n, uint8_t out[ORR_DATAGRAM_SEAL])
{
    size_t size;
    return EVP_MAC_init(s->mac, NULL, 0, NULL) == 1 && EVP_MAC_update(s->mac, data, n) == 1 &&
           EVP_MAC_final(s->mac, out, &size, ORR_DATAGRAM_SEAL) == 1 && size == ORR_DATAGRAM_SEAL;
}

bool orr_seal_put(orr_seal *s, uint8_t *data, size_t n) { return compute(s, data, n, data + n); }

bool orr_seal_holds(void *user, const uint8_t *data, size_t n)
{
    uint8_t wanted[ORR_DATAGRAM_SEAL];
    return compute(user, data, n, wanted) && CRYPTO_memcmp(wanted, data + n, sizeof wanted) == 0;
}

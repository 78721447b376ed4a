// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sha256.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include <openssl/evp.h>

static void to_hex(const unsigned char *md, char hex[ORR_SHA256_HEX])
{
    for (int i = 0; i < 32; i++) snprintf(hex + 2 * i, 3, "%02x", md[i]);
}

static orr_status crypto_failed(orr_diag *diag)
{
    return orr_diag_set(diag, ORR_E_UNSUPPORTED, "this system's libcrypto does not offer SHA-256");
}

orr_status orr_sha256_bytes(const void *data, size_t n, char hex[ORR_SHA256_HEX], orr_diag *diag)
{
    unsigned char md[EVP_MAX_MD_SIZE];
    if (EVP_Digest(data, n, md, NULL, EVP_sha256(), NULL) != 1) return crypto_failed(diag);
    to_hex(md, hex);
    return ORR_OK;
}

orr_status orr_sha256_stream(FILE *f, const char *name, char hex[ORR_SHA256_HEX], orr_diag *diag)
{
    orr_status status = ORR_OK;
    EVP_MD_CTX *ctx = EVP_MD_CTX_new();
    rewind(f);
    if (ctx == NULL || EVP_DigestInit_ex(ctx, EVP_sha256(), NULL) != 1) {
        status = crypto_failed(diag);
    } else {
        unsigned char chunk[1 << 15], md[EVP_MAX_MD_SIZE];
        size_t n;
        while (status == ORR_OK && (n = fread(chunk, 1, sizeof chunk, f)) > 0)
            if (EVP_DigestUpdate(ctx, chunk, n) != 1) status = crypto_failed(diag);
        if (ferror(f))
            status = orr_diag_at(diag, ORR_E_IO, name, 0, 0, "cannot be read: %s", strerror(errno));
        else if (status == ORR_OK && EVP_DigestFinal_ex(ctx, md, NULL) != 1)
            status = crypto_failed(diag);
        if (status == ORR_OK) to_hex(md, hex);
    }
    EVP_MD_CTX_free(ctx);
    return status;
}

orr_status orr_sha256_file(const char *path, char hex[ORR_SHA256_HEX], orr_diag *diag)
{
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    const orr_status status = orr_sha256_stream(f, path, hex, diag);
    fclose(f);
    return status;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ncseal.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include <openssl/evp.h>

#include "core/sha256.h"

#define LABEL "\norrery-sha256 "
#define LABEL_LEN (sizeof LABEL - 1)
#define SEAL_LEN (LABEL_LEN + ORR_SHA256_HEX) // label, 64 digits, newline

static orr_status io_error(const char *path, const char *verb, orr_diag *diag)
{
    return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be %s: %s", verb, strerror(errno));
}

orr_status orr_nc_seal(const char *path, orr_diag *diag)
{
    char hex[ORR_SHA256_HEX];
    orr_status s = orr_sha256_file(path, hex, diag);
    if (s != ORR_OK) return s;
    FILE *f = fopen(path, "ab");
    if (f == NULL) return io_error(path, "sealed", diag);
    bool bad = fprintf(f, LABEL "%s\n", hex) != (int)SEAL_LEN;
    bad = fclose(f) != 0 || bad;
    return bad ? io_error(path, "sealed", diag) : ORR_OK;
}

// SHA-256 of the first n bytes.
static orr_status sum_of_first(FILE *f, const char *path, long n, unsigned char md[EVP_MAX_MD_SIZE],
                               orr_diag *diag)
{
    EVP_MD_CTX *ctx = EVP_MD_CTX_new();
    bool good = ctx != NULL && EVP_DigestInit_ex(ctx, EVP_sha256(), NULL) == 1;
    orr_status s = ORR_OK;
    unsigned char chunk[1 << 15];
    rewind(f);
    while (good && s == ORR_OK && n > 0) {
        size_t want = n < (long)sizeof chunk ? (size_t)n : sizeof chunk;
        if (fread(chunk, 1, want, f) != want) s = io_error(path, "read", diag);
        good = EVP_DigestUpdate(ctx, chunk, want) == 1;
        n -= (long)want;
    }
    good = good && EVP_DigestFinal_ex(ctx, md, NULL) == 1;
    EVP_MD_CTX_free(ctx);
    if (s == ORR_OK && !good)
        s = orr_diag_set(diag, ORR_E_UNSUPPORTED, "this system's libcrypto does not offer SHA-256");
    return s;
}

orr_status orr_nc_check_seal(const char *path, orr_diag *diag)
{
    FILE *f = fopen(path, "rb");
    if (f == NULL) return io_error(path, "opened", diag);
    char seal[SEAL_LEN + 1] = "";
    orr_status s = ORR_OK;
    bool sealed = fseek(f, -(long)SEAL_LEN, SEEK_END) == 0; // a shorter file has no seal
    long body = sealed ? ftell(f) : 0;
    sealed = sealed && fread(seal, 1, SEAL_LEN, f) == SEAL_LEN && memcmp(seal, LABEL, LABEL_LEN) == 0;
    if (sealed) {
        unsigned char md[EVP_MAX_MD_SIZE];
        char hex[ORR_SHA256_HEX];
        s = sum_of_first(f, path, body, md, diag);
        for (int i = 0; s == ORR_OK && i < 32; i++) snprintf(hex + 2 * i, 3, "%02x", md[i]);
        if (s == ORR_OK && memcmp(hex, seal + LABEL_LEN, ORR_SHA256_HEX - 1) != 0)
            s = orr_diag_at(
                diag, ORR_E_FORMAT, path, 0, 0,
                "is damaged: its bytes are not those it was sealed with (SHA-256 at its end); make it again");
    }
    fclose(f);
    return s;
}

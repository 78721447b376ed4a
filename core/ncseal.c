// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ncseal.h"

#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <openssl/evp.h>

#include "core/ncfile.h"
#include "core/sha256.h"

#define SIGNATURE "\x89HDF\r\n\x1a\n"
#define LABEL "\norrery-sha256 "
#define LABEL_LEN (sizeof LABEL - 1)
enum { HEAD = 48 };                           // bytes of a superblock that are looked at
#define SEAL_LEN (LABEL_LEN + ORR_SHA256_HEX) // label, 64 digits, newline

static orr_status io_error(const char *path, const char *verb, orr_diag *diag)
{
    return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be %s: %s", verb, strerror(errno));
}

// Where HDF5's own bytes end, by its superblock (HDF5 File Format Specification 3.0, II.A); -1 where that is not told.
static long hdf5_end(const unsigned char head[HEAD])
{
    uint64_t end = 0;
    if (memcmp(head, SIGNATURE, 8) != 0) return -1;
    const bool old = head[8] < 2;                          // the version
    if (head[old ? 13 : 9] != 8 || head[8] > 3) return -1; // bytes of an address
    for (int i = 7; i >= 0; i--) end = end << 8 | head[(old ? 40 : 28) + i];
    return end <= LONG_MAX ? (long)end : -1;
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

static bool is_regular(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && S_ISREG(st.st_mode);
}

bool orr_nc_is_hdf5(const char *path)
{
    char head[8] = "";
    FILE *f = is_regular(path) ? fopen(path, "rb") : NULL;
    if (f == NULL) return false;
    const bool yes =
        fread(head, 1, sizeof head, f) == sizeof head && memcmp(head, SIGNATURE, sizeof head) == 0;
    fclose(f);
    return yes;
}

// The seal at the end of a file; false where there is none. *body: where it begins.
static bool read_seal(FILE *f, char seal[SEAL_LEN + 1], long *body)
{
    if (fseek(f, -(long)SEAL_LEN, SEEK_END) != 0) return false; // a shorter file has no seal
    *body = ftell(f);
    return fread(seal, 1, SEAL_LEN, f) == SEAL_LEN && memcmp(seal, LABEL, LABEL_LEN) == 0;
}

// Whether what stands behind HDF5's bytes is the begin of a seal and no more.
static bool is_cut(FILE *f)
{
    char rest[SEAL_LEN + 1];
    unsigned char head[HEAD];
    rewind(f);
    const long end = fread(head, 1, HEAD, f) == HEAD ? hdf5_end(head) : -1;
    if (end < 0 || fseek(f, end, SEEK_SET) != 0) return false;
    const size_t n = fread(rest, 1, sizeof rest, f);
    return n > 0 && n < SEAL_LEN && memcmp(rest, LABEL, n < LABEL_LEN ? n : LABEL_LEN) == 0;
}

// Whether a file has a seal, or a part of one; *read: that could be seen.
static bool has_seal(const char *path, bool *read)
{
    char seal[SEAL_LEN + 1] = "";
    long body;
    FILE *f = is_regular(path) ? fopen(path, "rb") : NULL;
    *read = f != NULL;
    if (f == NULL) return false;
    const bool yes = read_seal(f, seal, &body) || is_cut(f);
    *read = ferror(f) == 0;
    fclose(f);
    return yes;
}

bool orr_nc_is_sealed(const char *path)
{
    bool read;
    return has_seal(path, &read);
}

bool orr_nc_lacks_seal(const char *path)
{
    bool read;
    return orr_nc_is_hdf5(path) && !has_seal(path, &read) && read;
}

orr_status orr_nc_check_seal(const char *path, orr_diag *diag)
{
    FILE *f = fopen(path, "rb");
    if (f == NULL) return io_error(path, "opened", diag);
    char seal[SEAL_LEN + 1] = "";
    orr_status s = ORR_OK;
    long body = 0;
    if (read_seal(f, seal, &body)) {
        unsigned char md[EVP_MAX_MD_SIZE];
        char hex[ORR_SHA256_HEX];
        s = sum_of_first(f, path, body, md, diag);
        for (int i = 0; s == ORR_OK && i < 32; i++) snprintf(hex + 2 * i, 3, "%02x", md[i]);
        if (s == ORR_OK && memcmp(hex, seal + LABEL_LEN, ORR_SHA256_HEX - 1) != 0)
            s = orr_diag_at(
                diag, ORR_E_FORMAT, path, 0, 0,
                "is damaged: its bytes are not those it was sealed with (SHA-256 at its end); make it again");
    } else if (ferror(f) != 0) {
        s = io_error(path, "read", diag);
    } else if (is_cut(f)) {
        s = orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0,
                        "is cut: the seal at its end (SHA-256) is not whole; copy it or make it again");
    }
    if (s == ORR_OK && ferror(f) != 0) s = io_error(path, "read", diag);
    fclose(f);
    return s;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/page.h"

#include <assert.h>
#include <string.h>

#include "core/crc.h"

enum { CRC = 24, TAIL = 6 };

void orr_page_begin(orr_page *p, orr_diag *diag)
{
    p->n = 0;
    p->status = ORR_OK;
    p->diag = diag;
}

void orr_page_put(orr_page *p, int n, uint64_t value)
{
    assert(p->n + (size_t)n <= ORR_PAGE_BITS);
    for (int k = n - 1; k >= 0; k--) p->bit[p->n++] = (uint8_t)(value >> k & 1u);
}

void orr_page_zeros(orr_page *p, int n)
{
    for (; n > 0; n--) orr_page_put(p, 1, 0);
}

uint64_t orr_page_code(orr_page *p, const orr_navfit_field *f, double value)
{
    const uint64_t mask = (UINT64_C(1) << f->bits) - 1;
    double whole = orr_navfit_whole(f, value), sent;
    const orr_status s = orr_navfit_to_field(f, whole, &sent, p->status == ORR_OK ? p->diag : NULL);
    if (s != ORR_OK) {
        if (p->status == ORR_OK) p->status = s;
        return 0;
    }
    whole = orr_navfit_whole(f, sent);
    if (f->kind == ORR_FIELD_UNSIGNED) return (uint64_t)whole;
    return (uint64_t)(int64_t)whole &
           mask; // fields of sign and magnitude are two's complement but for one value
}

void orr_page_value(orr_page *p, const orr_navfit_field *f, double value)
{
    orr_page_put(p, f->bits, orr_page_code(p, f, value));
}

void orr_page_klobuchar(orr_page *p, const double alpha[4], const double beta[4])
{
    for (int k = 0; k < 4; k++) orr_page_value(p, &orr_nav_klobuchar_fields[k], alpha[k]);
    for (int k = 0; k < 4; k++) orr_page_value(p, &orr_nav_klobuchar_fields[4 + k], beta[k]);
}

void orr_page_copy(orr_page *p, const orr_page *other, size_t from, size_t n)
{
    assert(p->n + n <= ORR_PAGE_BITS && from + n <= other->n);
    memcpy(p->bit + p->n, other->bit + from, n);
    p->n += n;
}

void orr_page_crc24q(orr_page *p, size_t from)
{
    uint8_t bytes[ORR_PAGE_BITS / 8] = {0};
    const size_t n = p->n - from, lead = (8 - n % 8) % 8; // zeros ahead change nothing
    for (size_t k = 0; k < n; k++)
        if (p->bit[from + k] != 0) bytes[(lead + k) / 8] |= (uint8_t)(0x80u >> (lead + k) % 8);
    orr_page_put(p, 24, orr_crc24q(0, bytes, (lead + n) / 8));
}

void orr_page_seal(orr_page *p, size_t from, size_t bits)
{
    orr_page_zeros(p, (int)(from + bits - CRC - p->n));
    orr_page_crc24q(p, from);
}

unsigned orr_page_tail(const orr_page *p)
{
    unsigned state = 0;
    for (size_t k = p->n - TAIL; k < p->n; k++) state = state << 1 | p->bit[k];
    return state;
}

void orr_page_convolve(orr_page *p, const orr_page *in, size_t from, bool invert_second, unsigned *state)
{
    unsigned s = *state;
    for (size_t k = from; k < in->n; k++) {
        // Delays 0 to 6 are bits 0 to 6: G1 = 1 + D + D^2 + D^3 + D^6, G2 = 1 + D^2 + D^3 + D^5 + D^6.
        s = (s << 1 | in->bit[k]) & 0x7f;
        const unsigned first = s ^ s >> 1 ^ s >> 2 ^ s >> 3 ^ s >> 6,
                       second = s ^ s >> 2 ^ s >> 3 ^ s >> 5 ^ s >> 6;
        orr_page_put(p, 1, first & 1u);
        orr_page_put(p, 1, (second & 1u) ^ (invert_second ? 1u : 0u));
    }
    *state = s & 0x3f;
}

void orr_page_interleave(orr_page *p, size_t rows, size_t columns)
{
    uint8_t in[ORR_PAGE_BITS];
    const size_t n = rows * columns;
    assert(n <= p->n);
    uint8_t *out = p->bit + p->n - n;
    memcpy(in, out, n);
    for (size_t r = 0; r < rows; r++)
        for (size_t c = 0; c < columns; c++) out[r * columns + c] = in[c * rows + r];
}

unsigned orr_page_bch15(unsigned eleven)
{
    unsigned rest = 0;
    for (int k = 10; k >= 0; k--) {
        const unsigned in = (eleven >> k & 1u) ^ (rest >> 3 & 1u);
        rest = (rest << 1 & 0xfu) ^ (in != 0 ? 0x3u : 0);
    }
    return rest;
}

void orr_page_register(orr_page *p, int k, unsigned value, unsigned polynomial, int n)
{
    orr_page_put(p, k, value);
    for (int done = k; done < n; done++) {
        const uint8_t *last = &p->bit[p->n - (size_t)k];
        unsigned next = 0;
        for (int i = 0; i < k; i++) next ^= (polynomial >> i & 1u) & last[i];
        orr_page_put(p, 1, next);
    }
}

void orr_page_pack(const orr_page *p, uint8_t *bytes)
{
    memset(bytes, 0, (p->n + 7) / 8);
    for (size_t k = 0; k < p->n; k++)
        if (p->bit[k] != 0) bytes[k / 8] |= (uint8_t)(0x80u >> (k % 8));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/ldpc.h"

#define PRIMITIVE 0x43u

static const uint16_t cnav2_subframe2[] = {
#include "orbit/navdata/ldpc_cnav2_subframe2.def"
};
static const uint16_t cnav2_subframe3[] = {
#include "orbit/navdata/ldpc_cnav2_subframe3.def"
};

#define ROW(a, b, c, d, ...) 4, a, b, c, d,
static const uint16_t bcnav1_subframe2[] = {
#include "orbit/navdata/ldpc_bcnav1_subframe2.def"
};
static const uint16_t bcnav1_subframe3[] = {
#include "orbit/navdata/ldpc_bcnav1_subframe3.def"
};
static const uint16_t bcnav2[] = {
#include "orbit/navdata/ldpc_bcnav2.def"
};
static const uint16_t bcnav3[] = {
#include "orbit/navdata/ldpc_bcnav3.def"
};
#undef ROW

#define ROW(a, b, c, d, ...) __VA_ARGS__,
static const uint8_t bcnav1_elements2[] = {
#include "orbit/navdata/ldpc_bcnav1_subframe2.def"
};
static const uint8_t bcnav1_elements3[] = {
#include "orbit/navdata/ldpc_bcnav1_subframe3.def"
};
static const uint8_t bcnav2_elements[] = {
#include "orbit/navdata/ldpc_bcnav2.def"
};
static const uint8_t bcnav3_elements[] = {
#include "orbit/navdata/ldpc_bcnav3.def"
};
#undef ROW

static const orr_ldpc_matrix matrices[ORR_LDPC_N] = {
    [ORR_LDPC_CNAV2_SUBFRAME2] = {600, 1, cnav2_subframe2, NULL},
    [ORR_LDPC_CNAV2_SUBFRAME3] = {274, 1, cnav2_subframe3, NULL},
    [ORR_LDPC_BCNAV1_SUBFRAME2] = {100, 6, bcnav1_subframe2, bcnav1_elements2},
    [ORR_LDPC_BCNAV1_SUBFRAME3] = {44, 6, bcnav1_subframe3, bcnav1_elements3},
    [ORR_LDPC_BCNAV2] = {48, 6, bcnav2, bcnav2_elements},
    [ORR_LDPC_BCNAV3] = {81, 6, bcnav3, bcnav3_elements},
};

const orr_ldpc_matrix *orr_ldpc_matrix_of(orr_ldpc code) { return &matrices[code]; }

unsigned orr_ldpc_product(unsigned a, unsigned b)
{
    unsigned sum = 0;
    for (; b != 0; b >>= 1) {
        if ((b & 1u) != 0) sum ^= a;
        a <<= 1;
        if ((a & 0x40u) != 0) a ^= PRIMITIVE;
    }
    return sum;
}

// Of an element that is not zero: its power 62 = 2 + 4 + 8 + 16 + 32, since its power 63 is 1.
static unsigned inverse_of(unsigned a)
{
    unsigned out = 1;
    for (int k = 0; k < 5; k++) {
        a = orr_ldpc_product(a, a);
        out = orr_ldpc_product(out, a);
    }
    return out;
}

// A symbol as a + b x, where x is the unknown of the moment.
typedef struct value {
    bool known;
    uint8_t a, b;
} value;

typedef struct solving {
    const orr_ldpc_matrix *m;
    size_t left;                   // symbols that are not known
    bool used[ORR_LDPC_MOST_ROWS]; // rows that have given what they can
    value symbol[2 * ORR_LDPC_MOST_ROWS];
} solving;

// The unknown is found: x = a.
static void put_unknown(solving *s, unsigned a)
{
    for (size_t k = s->m->rows; k < 2 * s->m->rows; k++) {
        value *v = &s->symbol[k];
        v->a = (uint8_t)(v->a ^ orr_ldpc_product(v->b, a));
        v->b = 0;
    }
}

// What a row of n elements gives, if anything: the symbol that alone is not known, or, when all are, the unknown.
static bool use_row(solving *s, const uint16_t *column, const uint8_t *element, size_t n)
{
    unsigned a = 0, b = 0;
    size_t missing = n;
    for (size_t k = 0; k < n; k++) {
        const value *v = &s->symbol[column[k]];
        const unsigned e = element != NULL ? element[k] : 1;
        if (v->known) {
            a ^= orr_ldpc_product(v->a, e);
            b ^= orr_ldpc_product(v->b, e);
        } else if (missing == n)
            missing = k;
        else
            return false;
    }
    if (missing < n) {
        const unsigned back = inverse_of(element != NULL ? element[missing] : 1);
        s->symbol[column[missing]] = (value){
            .known = true, .a = (uint8_t)orr_ldpc_product(a, back), .b = (uint8_t)orr_ldpc_product(b, back)};
        s->left--;
    } else if (b != 0)
        put_unknown(s, orr_ldpc_product(a, inverse_of(b)));
    return true;
}

static bool pass(solving *s)
{
    const uint16_t *column = s->m->columns;
    const uint8_t *element = s->m->elements;
    bool any = false;
    for (size_t r = 0; r < s->m->rows; r++) {
        const size_t n = *column++;
        if (!s->used[r]) s->used[r] = use_row(s, column, element, n), any = any || s->used[r];
        column += n;
        if (element != NULL) element += n;
    }
    return any;
}

static void solve(solving *s)
{
    const size_t n = s->m->rows;
    s->left = n;
    size_t next = n;
    for (;;) {
        if (pass(s)) continue;
        if (s->left == 0) return;
        while (s->symbol[next].known) next++;
        s->symbol[next] = (value){.known = true, .b = 1};
        s->left--;
    }
}

void orr_ldpc_encode(orr_ldpc code, const orr_page *in, size_t from, orr_page *p)
{
    const orr_ldpc_matrix *m = orr_ldpc_matrix_of(code);
    const size_t bits = (size_t)m->bits, n = m->rows * bits;
    solving s = {.m = m};
    orr_page_copy(p, in, from, n);
    for (size_t k = 0; k < m->rows; k++) {
        unsigned a = 0;
        for (size_t i = 0; i < bits; i++) a = a << 1 | in->bit[from + k * bits + i];
        s.symbol[k] = (value){.known = true, .a = (uint8_t)a};
    }
    solve(&s);
    for (size_t k = m->rows; k < 2 * m->rows; k++) orr_page_put(p, m->bits, s.symbol[k].a);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The LDPC codes: the matrices have the shape that their documents give them and full rank, made codewords fulfil every check, and
// codewords that were received on the air come out again from their information.
#include "testing.h"

#include "core/rng.h"
#include "orbit/navdata/ldpc.h"
#include "unit/orbit/received_frames.h"

static const struct received {
    orr_ldpc code;
    const char *hex;
} received[] = {
    {ORR_LDPC_CNAV2_SUBFRAME2, RECEIVED_CNAV2_SUBFRAME2},
    {ORR_LDPC_CNAV2_SUBFRAME3, RECEIVED_CNAV2_SUBFRAME3},
    {ORR_LDPC_BCNAV1_SUBFRAME2, RECEIVED_BCNAV1_SUBFRAME2},
    {ORR_LDPC_BCNAV1_SUBFRAME3, RECEIVED_BCNAV1_SUBFRAME3},
    {ORR_LDPC_BCNAV2, RECEIVED_BCNAV2},
    {ORR_LDPC_BCNAV2, RECEIVED_BCNAV2_11},
    {ORR_LDPC_BCNAV2, RECEIVED_BCNAV2_30},
    {ORR_LDPC_BCNAV2, RECEIVED_BCNAV2_31},
    {ORR_LDPC_BCNAV3, RECEIVED_BCNAV3},
};

static size_t length_of(orr_ldpc code) // of a codeword, in bits
{
    const orr_ldpc_matrix *m = orr_ldpc_matrix_of(code);
    return 2 * m->rows * (size_t)m->bits;
}

static unsigned symbol_at(const orr_page *p, int bits, size_t k)
{
    unsigned a = 0;
    for (int i = 0; i < bits; i++) a = a << 1 | p->bit[k * (size_t)bits + (size_t)i];
    return a;
}

// How many checks of a codeword do not hold.
static size_t syndrome(orr_ldpc code, const orr_page *p)
{
    const orr_ldpc_matrix *m = orr_ldpc_matrix_of(code);
    const uint16_t *column = m->columns;
    const uint8_t *element = m->elements;
    size_t wrong = 0;
    for (size_t r = 0; r < m->rows; r++) {
        unsigned sum = 0;
        for (size_t n = *column++; n > 0; n--) {
            const unsigned e = element != NULL ? *element++ : 1;
            sum ^= orr_ldpc_product(symbol_at(p, m->bits, *column++), e);
        }
        wrong += sum != 0;
    }
    return wrong;
}

static void field(void **state)
{
    (void)state;
    unsigned power = 1;
    bool seen[64] = {false};
    for (int k = 0; k < 63; k++) { // 2 generates the group
        assert_in_range(power, 1, 63);
        assert_false(seen[power]);
        seen[power] = true;
        power = orr_ldpc_product(power, 2);
    }
    assert_int_equal(power, 1);
    for (unsigned a = 0; a < 64; a++)
        for (unsigned b = 0; b < 64; b++) {
            assert_int_equal(orr_ldpc_product(a, b), orr_ldpc_product(b, a));
            assert_int_equal(orr_ldpc_product(a, b) ^ orr_ldpc_product(a, 9), orr_ldpc_product(a, b ^ 9));
        }
}

// Rows of four and columns of two elements over GF(64); 4818 and 2071 ones of the binary matrices (the sums of the ICD's tables).
static void shape(void **state)
{
    (void)state;
    static const size_t ones[ORR_LDPC_N] = {4818, 2071, 400, 176, 192, 324};
    for (int code = 0; code < ORR_LDPC_N; code++) {
        const orr_ldpc_matrix *m = orr_ldpc_matrix_of((orr_ldpc)code);
        const uint16_t *column = m->columns;
        size_t sum = 0, weight[2 * ORR_LDPC_MOST_ROWS] = {0};
        for (size_t r = 0; r < m->rows; r++) {
            const size_t n = *column++;
            if (m->bits == 6)
                assert_int_equal(n, 4);
            else
                assert_in_range(n, 7, 9);
            for (size_t k = 0; k < n; k++, sum++) {
                assert_in_range(*column, k > 0 ? column[-1] + 1 : 0, 2 * m->rows - 1); // ascending
                if (m->elements != NULL) assert_in_range(m->elements[sum], 1, 63);
                weight[*column++]++;
            }
        }
        assert_int_equal(sum, ones[code]);
        for (size_t k = 0; k < 2 * m->rows; k++)
            if (m->bits == 6)
                assert_int_equal(weight[k], 2);
            else
                assert_in_range(weight[k], 1, 20);
    }
}

// The part of the matrix that belongs to the parity, by elimination: what the encoder needs and never computes.
static void rank(void **state)
{
    (void)state;
    for (int code = 0; code < ORR_LDPC_N; code++) {
        const orr_ldpc_matrix *m = orr_ldpc_matrix_of((orr_ldpc)code);
        const size_t n = m->rows;
        uint8_t *a = calloc(n * n, 1);
        assert_non_null(a);
        const uint16_t *column = m->columns;
        const uint8_t *element = m->elements;
        for (size_t r = 0; r < n; r++)
            for (size_t k = *column++; k > 0; k--, column++) {
                const uint8_t e = element != NULL ? *element++ : 1;
                if (*column >= n) a[r * n + *column - n] = e;
            }
        size_t done = 0;
        for (size_t c = 0; c < n; c++) {
            size_t r = done;
            while (r < n && a[r * n + c] == 0) r++;
            if (r == n) continue;
            for (size_t k = 0; k < n; k++) {
                const uint8_t keep = a[done * n + k];
                a[done * n + k] = a[r * n + k], a[r * n + k] = keep;
            }
            for (r = done + 1; r < n; r++) {
                if (a[r * n + c] == 0) continue;
                unsigned factor = 1;
                while (orr_ldpc_product(factor, a[done * n + c]) != a[r * n + c]) factor++;
                for (size_t k = c; k < n; k++)
                    if (a[done * n + k] != 0)
                        a[r * n + k] = (uint8_t)(a[r * n + k] ^ orr_ldpc_product(factor, a[done * n + k]));
            }
            done++;
        }
        free(a);
        assert_int_equal(done, n);
    }
}

static void made_codewords(void **state)
{
    (void)state;
    for (int code = 0; code < ORR_LDPC_N; code++) {
        const size_t n = length_of((orr_ldpc)code);
        for (uint64_t seed = 0; seed < 5; seed++) {
            orr_page in, out;
            orr_page_begin(&in, NULL);
            orr_page_begin(&out, NULL);
            orr_page_zeros(&in, 3); // the information need not stand at the begin
            for (size_t k = 0; k < n / 2; k++) orr_page_put(&in, 1, orr_rng_uniform(17, seed, k) < 0.5);
            orr_ldpc_encode((orr_ldpc)code, &in, 3, &out);
            assert_int_equal(out.n, n);
            assert_memory_equal(out.bit, in.bit + 3, n / 2);
            assert_int_equal(syndrome((orr_ldpc)code, &out), 0);
            out.bit[n - 1] ^= 1;
            assert_in_range(syndrome((orr_ldpc)code, &out), 1, 20);
        }
    }
}

static void received_codewords(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof received / sizeof *received; i++) {
        const size_t n = length_of(received[i].code);
        orr_page p, out;
        orr_page_begin(&out, NULL);
        assert_int_equal(strlen(received[i].hex), (n + 3) / 4);
        received_bits(received[i].hex, &p);
        assert_int_equal(syndrome(received[i].code, &p), 0);
        orr_ldpc_encode(received[i].code, &p, 0, &out);
        assert_int_equal(out.n, n);
        assert_memory_equal(out.bit, p.bit, n);
        orr_page body;
        orr_page_begin(&body, NULL);
        orr_page_copy(&body, &p, 0, n / 2 - 24);
        orr_page_crc24q(&body, 0);
        assert_memory_equal(body.bit, p.bit, n / 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(field),
        cmocka_unit_test(shape),
        cmocka_unit_test(rank),
        cmocka_unit_test(made_codewords),
        cmocka_unit_test(received_codewords),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

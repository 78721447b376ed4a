// SPDX-License-Identifier: GPL-3.0-or-later
#include "proto/crc32.h"

#include "testing.h"

// Bit by bit from the definition: an oracle that shares no table with the code.
static uint32_t by_definition(const uint8_t *data, size_t n)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < n; i++) {
        crc ^= data[i];
        for (int k = 0; k < 8; k++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
    }
    return ~crc;
}

static void published_value(void **state)
{
    (void)state;
    assert_int_equal(orr_crc32(0, (const uint8_t *)"123456789", 9),
                     0xcbf43926u); // the check value of CRC-32/ISO-HDLC
    assert_int_equal(orr_crc32(0, NULL, 0), 0);
}

static void all_lengths_and_cuts(void **state)
{
    (void)state;
    uint8_t data[333]; // across the lengths where other ways of computing begin
    for (size_t i = 0; i < sizeof data; i++) data[i] = (uint8_t)(i * 37 + 11);
    for (size_t n = 0; n <= sizeof data; n++) {
        assert_int_equal(orr_crc32(0, data, n), by_definition(data, n));
        for (size_t cut = n % 7; cut <= n; cut += 7) // in two pieces it is the same
            assert_int_equal(orr_crc32(orr_crc32(0, data, cut), data + cut, n - cut), by_definition(data, n));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(published_value),
                                       cmocka_unit_test(all_lengths_and_cuts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and seals of datagrams: the window beside one that remembers everything, HMAC-SHA-256 by RFC 4231's cases, and channels that end.
#include "src/service/net/datagrams.h"

#include "testing.h"

enum { MANY = 20000, FAR = 6000 };

static void each_number_once(void **state)
{
    (void)state;
    static bool had[MANY + FAR];
    orr_datagram_window w = {0};
    uint64_t seed = 7, greatest = 0, taken = 0, refused = 0;
    for (uint64_t k = 0; k < MANY; k++) {
        seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
        // Near the front, mostly; now and then far behind it, a leap ahead, or one of the last again.
        const uint64_t draw = seed >> 40, kind = draw % 100;
        const uint64_t back = draw / 100 % (kind < 90 ? 40 : 3 * ORR_DATAGRAM_WINDOW);
        uint64_t number = kind < 60 ? greatest + 1 : kind == 99 ? greatest + back / 60 + 1 : greatest - back;
        if (number > greatest + FAR) number = 0; // below the first
        if (number >= MANY + FAR) break;
        const bool is_new =
            number > 0 && (number > greatest || greatest - number < ORR_DATAGRAM_WINDOW) && !had[number];
        assert_int_equal(orr_datagram_is_new(&w, number), is_new);
        had[number] = had[number] || is_new;
        if (is_new && number > greatest) greatest = number;
        taken += is_new;
        refused += !is_new;
        assert_true(w.greatest == greatest && w.taken == taken && w.replayed == refused);
    }
    assert_true(taken > 5000 && refused > 1000);
    assert_true(orr_datagram_is_new(&w, UINT64_MAX) && !orr_datagram_is_new(&w, UINT64_MAX));
    assert_true(orr_datagram_is_new(&w, UINT64_MAX - ORR_DATAGRAM_WINDOW + 1));
    assert_false(orr_datagram_is_new(&w, UINT64_MAX - ORR_DATAGRAM_WINDOW));
}

static void check_seal(const char *key, const char *text, const char *hex)
{
    uint8_t k[ORR_SEAL_KEY] = {0}, data[200], wanted[ORR_DATAGRAM_SEAL];
    const size_t n = strlen(text);
    memcpy(k, key, strlen(key)); // HMAC pads keys with zeros
    for (size_t i = 0; i < sizeof wanted; i++) {
        unsigned byte;
        assert_int_equal(sscanf(hex + 2 * i, "%2x", &byte), 1);
        wanted[i] = (uint8_t)byte;
    }
    orr_seal *s = orr_seal_open(k);
    assert_non_null(s);
    for (int twice = 0; twice < 2; twice++) { // nothing is left of the one before
        memcpy(data, text, n);
        assert_true(orr_seal_put(s, data, n));
        assert_memory_equal(data + n, wanted, sizeof wanted);
        assert_true(orr_seal_holds(s, data, n));
        data[n + 31] ^= 1;
        assert_false(orr_seal_holds(s, data, n));
        data[n + 31] ^= 1;
        data[0] ^= 128;
        assert_false(orr_seal_holds(s, data, n));
    }
    orr_seal_close(s);
}

static void seals(void **state)
{
    (void)state;
    check_seal("\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b\x0b", "Hi There",
               "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    check_seal("Jefe", "what do ya want for nothing?",
               "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

// A datagram of MOTION; returns its bytes.
static size_t make(uint8_t *data, uint32_t channel, uint64_t number, orr_seal *seal)
{
    const orr_msg_motion m = {.t = (int64_t)number};
    orr_wire_writer w = {data, ORR_DATAGRAM_HEAD, 600, ORR_WIRE_OK};
    size_t start;
    orr_datagram_head(data, channel, number);
    orr_frame_begin(&w, ORR_MSG_TYPE_MOTION, 1, &start);
    orr_msg_motion_encode(&m, &w);
    orr_frame_end(&w, start);
    if (seal == NULL) return w.size;
    assert_true(orr_seal_put(seal, data, w.size));
    return w.size + ORR_DATAGRAM_SEAL;
}

static void channels_are_their_clients(void **state)
{
    (void)state;
    static const uint8_t keys[2][ORR_SEAL_KEY] = {{1}, {2}};
    uint8_t data[700];
    orr_frame f;
    orr_datagrams *d = orr_datagrams_open();
    orr_seal *s[2] = {orr_seal_open(keys[0]), orr_seal_open(keys[1])};
    const uint32_t a = orr_datagrams_admit(d, keys[0], true), b = orr_datagrams_admit(d, keys[1], false),
                   c = orr_datagrams_admit(d, NULL, true);
    assert_true(a != b && b != c && orr_datagrams_number(d) > c);
    assert_int_equal(orr_datagrams_take(d, data, make(data, a, 1, s[0]), false, &f), ORR_DATAGRAM_TAKEN);
    assert_int_equal(f.type, ORR_MSG_TYPE_MOTION);
    assert_int_equal(orr_datagrams_take(d, data, make(data, a, 1, s[0]), false, &f), ORR_DATAGRAM_REPLAYED);
    assert_int_equal(orr_datagrams_take(d, data, make(data, a, 2, s[1]), true, &f), ORR_DATAGRAM_REFUSED);
    assert_int_equal(orr_datagrams_take(d, data, make(data, a, 2, NULL), true, &f), ORR_DATAGRAM_REFUSED);
    assert_int_equal(orr_datagrams_take(d, data, make(data, b, 1, s[1]), false, &f),
                     ORR_DATAGRAM_NOT_ALLOWED);
    orr_datagrams_permit(d, b, true);
    assert_int_equal(orr_datagrams_take(d, data, make(data, b, 2, s[1]), false, &f), ORR_DATAGRAM_TAKEN);
    assert_int_equal(orr_datagrams_take(d, data, make(data, c, 1, NULL), false, &f), ORR_DATAGRAM_REFUSED);
    assert_int_equal(orr_datagrams_take(d, data, make(data, c, 1, NULL), true, &f), ORR_DATAGRAM_TAKEN);
    const orr_datagram_counts n = orr_datagrams_count(d, a);
    assert_true(n.taken == 1 && n.replayed == 1 && n.refused == 2);
    orr_datagrams_leave(d, a);
    assert_int_equal(orr_datagrams_take(d, data, make(data, a, 3, s[0]), false, &f), ORR_DATAGRAM_REFUSED);
    assert_int_equal(orr_datagrams_take(d, data, 3, true, &f), ORR_DATAGRAM_REFUSED);
    orr_seal_close(s[0]);
    orr_seal_close(s[1]);
    orr_datagrams_close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_once),
        cmocka_unit_test(seals),
        cmocka_unit_test(channels_are_their_clients),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

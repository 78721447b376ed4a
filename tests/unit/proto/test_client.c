// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware client against the server's state machine, both in memory: the client's callbacks move the
// bytes.
#include "proto/client.h"

#include "fake.h"
#include "testing.h"

// A wire: what the client writes is answered at once; what it reads comes `chunk` bytes at a time.
typedef struct wire {
    orr_server server;
    orr_server_conn conn;
    uint8_t up[4096], down[400000];
    size_t n_up, n_down, at_down, chunk;
    bool dead;     // writing fails
    size_t damage; // flip a bit of this byte of the answers (0: none)
} wire;

static ptrdiff_t wire_write(void *user, const uint8_t *data, size_t n)
{
    wire *w = user;
    if (w->dead) return -1;
    size_t m = n < w->chunk ? n : w->chunk;
    memcpy(w->up + w->n_up, data, m);
    w->n_up += m;
    orr_wire_writer out = {w->down + w->n_down, 0, sizeof w->down - w->n_down, ORR_WIRE_OK};
    orr_server_step step;
    orr_server_run(&w->server, &w->conn, w->up, w->n_up, &out, &step);
    assert_false(step.busy);
    memmove(w->up, w->up + step.consumed, w->n_up - step.consumed);
    w->n_up -= step.consumed;
    w->n_down += out.size;
    if (w->damage > 0 && w->damage < w->n_down) w->down[w->damage] ^= 4;
    return (ptrdiff_t)m;
}

static ptrdiff_t wire_read(void *user, uint8_t *data, size_t n)
{
    wire *w = user;
    size_t left = w->n_down - w->at_down, m = n < w->chunk ? n : w->chunk;
    if (m > left) m = left;
    memcpy(data, w->down + w->at_down, m);
    w->at_down += m;
    return (ptrdiff_t)m;
}

static wire the_wire;
static uint8_t buffer[16384];

static orr_client connect_fake(fake *f, size_t chunk, size_t capacity)
{
    memset(&the_wire, 0, sizeof the_wire);
    the_wire.server = fake_server(f);
    the_wire.chunk = chunk;
    orr_client c;
    orr_client_init(&c, (orr_client_io){&the_wire, wire_read, wire_write}, buffer, capacity);
    return c;
}

static void conversation(void **state)
{
    (void)state;
    for (size_t chunk = 1; chunk < 3000; chunk = chunk * 3 + 1) {
        fake f = {.n_sats = 4};
        orr_client c = connect_fake(&f, chunk, sizeof buffer);
        orr_msg_caps caps;
        assert_int_equal(orr_client_open(&c, "test", "1", &caps), ORR_WIRE_OK);
        char title[16];
        assert_string_equal(orr_wire_text_copy(caps.title, title, sizeof title), "made up");
        assert_int_equal(orr_client_check(&c, 0xfeedu), ORR_WIRE_OK);
        orr_msg_poll poll = {.epochs = {50, 5, 3}};
        assert_int_equal(orr_client_poll(&c, &poll), ORR_WIRE_OK);
        for (uint32_t k = 0; k < 3; k++) {
            orr_msg_states m;
            orr_msg_sat_state s, want;
            assert_int_equal(orr_client_states(&c, &m), ORR_WIRE_OK);
            assert_true(m.epoch.index == k && m.epoch.count == 3 && m.satellites.count == 4);
            assert_true(orr_msg_sat_state_at(&m.satellites, 3, &s));
            want = fake_state(4, 50 + 5 * k);
            assert_true(s.pos_m[0] == want.pos_m[0] && s.vel_mps[1] == 1.0 && s.sat.number == 4);
        }
        assert_int_equal(orr_client_check(&c, 1), ORR_WIRE_OK);
    }
}

static void refusals_are_told(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_client c = connect_fake(&f, 100, sizeof buffer);
    orr_msg_poll poll = {.epochs = {.t = 1}};
    orr_msg_states m;
    assert_int_equal(orr_client_poll(&c, &poll), ORR_WIRE_OK);
    assert_int_equal(orr_client_states(&c, &m), ORR_WIRE_REFUSED);
    assert_int_equal(c.error_code, ORR_MSG_ERROR_CODE_BAD_REQUEST);
    assert_string_equal(c.sentence, "no epochs asked for");
    assert_int_equal(orr_client_check(&c, 3), ORR_WIRE_OK); // and one can go on
}

static void broken_wires(void **state)
{
    (void)state;
    fake f = {.n_sats = 1};
    orr_client c = connect_fake(&f, 1000, sizeof buffer);
    orr_msg_states m;
    assert_int_equal(orr_client_states(&c, &m), ORR_WIRE_CLOSED); // nothing asked, nothing comes
    the_wire.dead = true;
    assert_int_equal(orr_client_check(&c, 3), ORR_WIRE_IO);
    c = connect_fake(&f, 1000, sizeof buffer);
    the_wire.damage = 20;
    assert_int_equal(orr_client_check(&c, 3), ORR_WIRE_CRC);
    c = connect_fake(&f, 1000, sizeof buffer);
    the_wire.damage = 2;
    assert_int_equal(orr_client_check(&c, 3), ORR_WIRE_MAGIC);
}

static void small_buffers(void **state)
{
    (void)state;
    fake f = {.n_sats = 30};
    for (size_t capacity = 0; capacity < 3700; capacity += 41) {
        orr_client c = connect_fake(&f, 1000, capacity);
        orr_msg_poll poll = {.epochs = {.t = 1, .count = 1}};
        orr_msg_states m;
        orr_wire_status s = orr_client_poll(&c, &poll);
        assert_int_equal(s, capacity < 44 ? ORR_WIRE_SPACE : ORR_WIRE_OK); // 20 of frame, 24 of POLL
        if (s == ORR_WIRE_OK) // 20 of frame, 21 of STATES, 30 satellites
            assert_int_equal(orr_client_states(&c, &m),
                             capacity < 20 + 21 + 30 * 120 ? ORR_WIRE_SPACE : ORR_WIRE_OK);
    }
}

// A frame that does not answer the request is told: another type, another's sequence, an ERROR of another's.
static void strange_frames_are_told(void **state)
{
    (void)state;
    const struct {
        uint16_t type;
        uint32_t sequence;
        orr_wire_status want;
    } cases[] = {{ORR_MSG_TYPE_PONG, 1, ORR_WIRE_OK},          {ORR_MSG_TYPE_PONG, 2, ORR_WIRE_UNEXPECTED},
                 {ORR_MSG_TYPE_PONG, 0, ORR_WIRE_UNEXPECTED},  {ORR_MSG_TYPE_CAPS, 1, ORR_WIRE_UNEXPECTED},
                 {ORR_MSG_TYPE_ERROR, 2, ORR_WIRE_UNEXPECTED}, {999, 1, ORR_WIRE_UNEXPECTED},
                 {ORR_MSG_TYPE_ERROR, 1, ORR_WIRE_SHORT}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        fake f = {.n_sats = 1};
        orr_client c = connect_fake(&f, 1000, sizeof buffer);
        orr_wire_writer w = {the_wire.down, 0, sizeof the_wire.down, ORR_WIRE_OK};
        size_t start;
        orr_frame_begin(&w, cases[k].type, cases[k].sequence, &start);
        orr_wire_put_raw(&w, (const uint8_t *)"\3\0\0\0\0\0\0\0",
                         cases[k].type == ORR_MSG_TYPE_ERROR ? 3 : 8);
        orr_frame_end(&w, start);
        the_wire.n_down = w.size; // it stands in front of the true answer
        assert_int_equal(orr_client_check(&c, 3), cases[k].want);
    }
}

// An answer is complete: an epoch that is left out, repeated or of another request is told.
static void epochs_are_counted(void **state)
{
    (void)state;
    orr_client c;
    orr_client_init(&c, (orr_client_io){0}, buffer, sizeof buffer);
    orr_client_expect(&c, 2);
    assert_int_equal(orr_client_epoch(&c, 1, 2), ORR_WIRE_UNEXPECTED);
    assert_int_equal(orr_client_epoch(&c, 0, 3), ORR_WIRE_UNEXPECTED);
    assert_int_equal(orr_client_epoch(&c, 0, 2), ORR_WIRE_OK);
    assert_int_equal(orr_client_epoch(&c, 0, 2), ORR_WIRE_UNEXPECTED);
    assert_int_equal(orr_client_epoch(&c, 1, 2), ORR_WIRE_OK);
    assert_int_equal(orr_client_epoch(&c, 2, 2), ORR_WIRE_UNEXPECTED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(epochs_are_counted), cmocka_unit_test(strange_frames_are_told),
        cmocka_unit_test(conversation),       cmocka_unit_test(refusals_are_told),
        cmocka_unit_test(broken_wires),       cmocka_unit_test(small_buffers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The ring between two processes: its layout, readers by sequence, what a slow one loses, that none can write, and two threads at once.
#include "src/service/live/ring_made.h"

#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <sys/mman.h>
#include <unistd.h>

#include "testing.h"

enum { BYTES = 1000, MANY = 20000 };

static uint32_t word_at(const orr_ring *r, size_t at)
{
    uint32_t v;
    memcpy(&v, r->memory + at, sizeof v);
    return v;
}

static void layout(void **state)
{
    (void)state;
    static _Alignas(64) uint8_t memory[128 + 4 * 128];
    static const uint8_t payload[] = {7, 8, 9};
    orr_ring w;
    orr_ring_make(&w, memory, 4, 128);
    assert_int_equal(orr_ring_size(4, 128), sizeof memory);
    assert_memory_equal(memory, "ORRYRNG1", 8);
    assert_int_equal(word_at(&w, 8), 4);
    assert_int_equal(word_at(&w, 12), 128);
    assert_true(orr_ring_write(&w, 15, payload, 3) && orr_ring_write(&w, 24, NULL, 0));
    assert_int_equal(word_at(&w, 64), 2);
    assert_int_equal(word_at(&w, 128), 2); // 2n + 2 of message 0
    assert_int_equal(word_at(&w, 128 + 8), 3);
    assert_int_equal(word_at(&w, 128 + 12), 15);
    assert_memory_equal(memory + 128 + 16, payload, 3);
    assert_int_equal(word_at(&w, 256), 4);
    assert_false(orr_ring_write(&w, 15, memory, 128 - 15)); // one byte more than a slot has
    assert_int_equal(word_at(&w, 64), 2);
}

static void readers_by_sequence(void **state)
{
    (void)state;
    orr_ring_made made;
    orr_diag diag = {0};
    ASSERT_OK(orr_ring_made_open(&made, &diag), diag);
    const size_t size = orr_ring_size(ORR_RING_SLOTS, ORR_RING_STRIDE);
    const void *memory = mmap(NULL, size, PROT_READ, MAP_SHARED, made.fd, 0);
    assert_true(memory != MAP_FAILED);
    // No reader can write, nor cut it short.
    assert_true(mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED, made.fd, 0) == MAP_FAILED &&
                errno == EPERM);
    assert_int_equal(ftruncate(made.fd, 100), -1);
    orr_ring a, b;
    uint16_t type = 0;
    uint8_t got[8] = {0};
    size_t n = 0;
    assert_true(orr_ring_open(&a, memory, size));
    assert_false(orr_ring_open(&b, memory, size - 1)); // shorter than it says
    assert_false(orr_ring_read(&a, &type, got, sizeof got, &n));
    for (uint8_t k = 0; k < 100; k++) assert_true(orr_ring_made_write(&made, k, &k, 1));
    assert_true(orr_ring_open(&b, memory, size));
    b.next = 100;
    for (uint8_t k = 0; k < 100; k++) {
        assert_true(orr_ring_read(&a, &type, got, sizeof got, &n));
        assert_true(type == k && n == 1 && got[0] == k);
    }
    assert_false(orr_ring_read(&b, &type, got, sizeof got, &n));
    for (int k = 0; k < 1000; k++)
        assert_true(orr_ring_made_write(&made, (uint16_t)(100 + k), (uint8_t *)&k, sizeof k));
    uint64_t read = 0;
    for (uint16_t last = 0; orr_ring_read(&b, &type, got, sizeof got, &n); last = type, read++) {
        int k;
        memcpy(&k, got, sizeof k);
        assert_true(n == sizeof k && type == 100 + k && type > last);
    }
    assert_int_equal(type, 1099);
    assert_true(b.lost > 0 && read + b.lost == 1000);
    assert_true(orr_ring_read(&a, &type, got, 2, &n) && n == 4); // cut, and told
    munmap((void *)(uintptr_t)memory, size);
    orr_ring_made_close(&made);
}

// What stands in memory that a peer writes is not believed: sizes beyond a slot are cut, counts from nowhere end in a bounded time.
static void hostile_writers(void **state)
{
    (void)state;
    enum { SLOTS = 16, STRIDE = 256 };
    orr_ring_made made;
    orr_diag diag = {0};
    uint8_t got[STRIDE];
    uint16_t type;
    size_t n;
    ASSERT_OK(orr_ring_made_theirs(&made, SLOTS, STRIDE, &diag), diag);
    const size_t size = orr_ring_size(SLOTS, STRIDE);
    uint8_t *memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED, made.fd, 0);
    assert_true(memory != MAP_FAILED);
    assert_int_equal(ftruncate(made.fd, 100), -1); // no page can be taken away
    uint64_t seed = 5, *words = (uint64_t *)(void *)memory;
    for (int round = 0; round < 2000; round++) {
        for (size_t k = 0; k < size / 8; k++) {
            seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
            const uint64_t next = made.ring.next;
            // Random words, and stamps that are nearly right.
            words[k] = seed % 4 == 0 ? seed : 2 * next + seed / 4 % 5;
        }
        for (int k = 0; k < SLOTS; k++)
            if (orr_ring_read(&made.ring, &type, got, sizeof got, &n)) assert_true(n <= STRIDE - 16);
    }
    assert_int_equal(made.ring.slots, SLOTS);
    munmap(memory, size);
    orr_ring_made_close(&made);
}

static orr_ring_made shared;
static atomic_bool done;

static void *write_many(void *user)
{
    (void)user;
    static uint8_t data[BYTES];
    for (int k = 0; k < MANY; k++) {
        memset(data, k & 0xff, sizeof data);
        (void)orr_ring_made_write(&shared, (uint16_t)(k & 0xffff), data, (size_t)(BYTES - (k & 0xff)));
    }
    atomic_store(&done, true);
    return NULL;
}

static void none_is_torn(void **state)
{
    (void)state;
    orr_diag diag = {0};
    pthread_t thread;
    static uint8_t got[BYTES];
    ASSERT_OK(orr_ring_made_open(&shared, &diag), diag);
    orr_ring r;
    assert_true(orr_ring_open(&r, shared.ring.memory, orr_ring_size(ORR_RING_SLOTS, ORR_RING_STRIDE)));
    pthread_create(&thread, NULL, write_many, NULL);
    uint64_t read = 0;
    uint16_t type = 0;
    size_t n = 0;
    for (bool last = false; !last;) {
        last = atomic_load(&done);
        while (orr_ring_read(&r, &type, got, sizeof got, &n)) {
            const uint8_t k = (uint8_t)(type & 0xff);
            assert_int_equal(n, BYTES - k);
            for (size_t i = 0; i < n; i++) assert_int_equal(got[i], k);
            assert_int_equal((r.next - 1) & 0xffff, type);
            read++;
        }
    }
    pthread_join(thread, NULL);
    assert_int_equal(read + r.lost, MANY);
    assert_true(read > 100);
    orr_ring_made_close(&shared);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layout),
        cmocka_unit_test(readers_by_sequence),
        cmocka_unit_test(hostile_writers),
        cmocka_unit_test(none_is_torn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

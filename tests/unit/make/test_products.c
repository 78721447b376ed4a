// SPDX-License-Identifier: GPL-3.0-or-later
// A product does not depend on who asks for it: a plan of files and a scenario's section give the same bytes. Inputs are
// read once, pipes too, and what was read is what is hashed.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/sha256.h"
#include "src/make/navset.h"
#include "src/make/orbit.h"
#include "tests/testing.h"

#define SP3 ORR_SOURCE_DIR "/samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"
#define SP3_NAME "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"

static const char scenario_text[] = "orbit: {sp3: [" SP3 "], nodes: 1800}\n";

static void read_bytes(const char *path, orr_bytes *out)
{
    orr_diag d = {0};
    ASSERT_OK(orr_input_read_raw(path, NULL, out, &d), d);
}

static void orbit_of(const orr_orbit_plan *plan, orr_orbit_made *made)
{
    orr_diag d = {0};
    ASSERT_OK(orr_orbit_make(plan, NULL, NULL, made, NULL, &d), d);
}

static orr_orbit_plan plan_of_file(const char *const *path)
{
    orr_orbit_plan p = orr_orbit_plan_default();
    p.sp3 = path;
    p.n_sp3 = 1;
    p.smoother.node_step_s = 1800;
    return p;
}

static void test_orbit_of_files_and_of_a_scenario(void **state)
{
    (void)state;
    static const char *const path[] = {SP3};
    orr_diag d = {0};
    orr_scenario s = {0};
    ASSERT_OK(orr_scenario_parse("test", scenario_text, sizeof scenario_text - 1, ".", NULL, &s, &d), d);
    const orr_orbit_plan asked[2] = {plan_of_file(path), orr_orbit_plan_of(&s)};
    static const char *const file[2] = {ORR_BINARY_DIR "/files.nc", ORR_BINARY_DIR "/scenario.nc"};
    orr_bytes bytes[2];
    for (int k = 0; k < 2; k++) {
        orr_orbit_made made;
        orbit_of(&asked[k], &made);
        ASSERT_OK(orr_ephemeris_save(made.ephemeris, file[k], "history", &d), d);
        orr_orbit_made_free(&made);
        read_bytes(file[k], &bytes[k]);
        unlink(file[k]);
    }
    assert_int_equal(bytes[0].n, bytes[1].n);
    assert_memory_equal(bytes[0].text, bytes[1].text, bytes[0].n);
    orr_bytes_free(&bytes[0]);
    orr_bytes_free(&bytes[1]);
    orr_scenario_free(&s);
}

static void test_navset_of_files_and_of_a_scenario(void **state)
{
    (void)state;
    static const char *const path[] = {SP3};
    orr_diag d = {0};
    orr_scenario s = {0};
    ASSERT_OK(orr_scenario_parse("test", scenario_text, sizeof scenario_text - 1, ".", NULL, &s, &d), d);
    orr_orbit_plan orbit = plan_of_file(path);
    orr_orbit_made made;
    orbit_of(&orbit, &made);
    orr_navset_plan plan[2] = {orr_navset_plan_default()};
    assert_true(orr_navset_plan_of(&s, &plan[1]));
    orr_navset *set[2];
    for (int k = 0; k < 2; k++)
        ASSERT_OK(orr_navset_make(made.ephemeris, &plan[k], &set[k], NULL, NULL, &d), d);
    const orr_sat *sats, *others;
    const size_t n = orr_navset_satellites(set[0], &sats);
    assert_true(n > 20);
    assert_int_equal(orr_navset_satellites(set[1], &others), n);
    assert_memory_equal(sats, others, n * sizeof *sats);
    for (size_t i = 0; i < n; i++) {
        const orr_navset_item *a, *b;
        const size_t n_items = orr_navset_items(set[0], sats[i], ORR_NAV_NONE, &a);
        assert_int_equal(orr_navset_items(set[1], sats[i], ORR_NAV_NONE, &b), n_items);
        for (size_t j = 0; j < n_items; j++) {
            assert_int_equal(a[j].from, b[j].from);
            assert_memory_equal(&a[j].eph.kepler, &b[j].eph.kepler, sizeof a[j].eph.kepler);
        }
    }
    orr_navset_free(set[0]);
    orr_navset_free(set[1]);
    orr_orbit_made_free(&made);
    orr_scenario_free(&s);
}

// A pipe can be read once only: the product still tells the SHA-256 of what came out of it.
static void test_inputs_from_a_pipe(void **state)
{
    (void)state;
    static const char *const fifo[] = {ORR_BINARY_DIR "/" SP3_NAME};
    char wanted[ORR_SHA256_HEX];
    orr_diag d = {0};
    orr_bytes sp3;
    ASSERT_OK(orr_sha256_file(SP3, wanted, &d), d);
    read_bytes(SP3, &sp3);
    unlink(fifo[0]);
    assert_int_equal(mkfifo(fifo[0], 0600), 0);
    const pid_t writer = fork();
    if (writer == 0) {
        FILE *f = fopen(fifo[0], "wb");
        const bool written = f != NULL && fwrite(sp3.text, 1, sp3.n, f) == sp3.n && fclose(f) == 0;
        _exit(written ? 0 : 1);
    }
    assert_true(writer > 0);
    const orr_orbit_plan plan = plan_of_file(fifo);
    orr_orbit_made made;
    orbit_of(&plan, &made);
    int status = 1;
    assert_int_equal(waitpid(writer, &status, 0), writer);
    assert_int_equal(status, 0);
    const orr_orbit_source *source;
    assert_int_equal(orr_ephemeris_sources(made.ephemeris, &source), 1);
    assert_string_equal(source[0].name, SP3_NAME);
    assert_string_equal(source[0].sha256, wanted);
    orr_orbit_made_free(&made);
    orr_bytes_free(&sp3);
    unlink(fifo[0]);
}

static void test_absent_and_folder(void **state)
{
    (void)state;
    orr_inputs list = {0};
    orr_bytes text;
    orr_diag d = {0};
    assert_int_equal(orr_inputs_read(&list, "absent", ORR_KIND_BIT(ORR_KIND_SP3), &text, &d), ORR_E_IO);
    assert_int_equal(orr_inputs_read(&list, ".", ORR_KIND_BIT(ORR_KIND_SP3), &text, &d), ORR_E_KIND);
    assert_int_equal(orr_inputs_read(&list, "/dev/null", ORR_KIND_BIT(ORR_KIND_SP3), &text, &d),
                     ORR_E_KIND); // an empty file
    orr_input_limits limits = orr_input_default_limits();
    limits.max_bytes = 1000;
    assert_int_equal(orr_input_read_raw(SP3, &limits, &text, &d), ORR_E_LIMIT);
    // What never ends is refused by its first lines.
    assert_int_equal(orr_inputs_read(&list, "/dev/zero", ORR_KIND_BIT(ORR_KIND_SP3), &text, &d), ORR_E_KIND);
    orr_inputs_free(&list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orbit_of_files_and_of_a_scenario),
        cmocka_unit_test(test_navset_of_files_and_of_a_scenario),
        cmocka_unit_test(test_inputs_from_a_pipe),
        cmocka_unit_test(test_absent_and_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// RTKLIB reads what we write: its single-point positions from our observation and navigation files are, digit
// by digit, those from the text that the published files expand to.
#include "testing.h"

#include <unistd.h>

#include "ingest/rinex/crinex.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/rinex/rinex_obs.h"

static const char *const obs_name = "2020-177/ESBC00DNK_R_20201770000_01D_30S_MO.crx.gz";
static const char *const nav_name = "2020-177/ESBC00DNK_R_20201770000_01D_MN.rnx.gz";

static bool has_rnx2rtkp(void)
{
    FILE *p = popen("command -v rnx2rtkp", "r");
    char line[256];
    bool found = p != NULL && fgets(line, sizeof line, p) != NULL;
    if (p != NULL) pclose(p);
    if (!found) print_message("skipped: rnx2rtkp (package rtklib) is not installed\n");
    return found;
}

static bool put(void *user, const char *line, size_t n) { return fprintf(user, "%.*s\n", (int)n, line) > 0; }

// The published files as plain text, without our readers of epochs and our writers.
static void expand(const char *obs, const char *nav, const char *obs_out, const char *nav_out)
{
    orr_input *in = NULL;
    orr_diag diag = {0};
    FILE *f = fopen(obs_out, "w");
    assert_non_null(f);
    ASSERT_OK(orr_input_open(obs, NULL, &in, &diag), diag);
    ASSERT_OK(orr_crinex_expand(in, put, f, NULL, &diag), diag);
    orr_input_close(in);
    fclose(f);
    orr_bytes b;
    ASSERT_OK(orr_input_read_all(nav, NULL, &b, &diag), diag);
    f = fopen(nav_out, "w");
    assert_non_null(f);
    assert_int_equal(fwrite(b.text, 1, b.n, f), b.n);
    fclose(f);
    orr_bytes_free(&b);
}

static void rewrite(const char *obs, const char *nav, const char *obs_out, const char *nav_out, int n_epochs)
{
    orr_rinex_obs *r = NULL;
    orr_rinex_obs_writer *w = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_rinex_obs_open(obs, NULL, NULL, &r, &diag), diag);
    ASSERT_OK(orr_rinex_obs_create(obs_out, 3.05, orr_rinex_obs_header_of(r), &w, &diag), diag);
    for (int i = 0; i < n_epochs; i++) {
        const orr_rinex_obs_epoch *e = NULL;
        ASSERT_OK(orr_rinex_obs_next(r, &e, &diag), diag);
        assert_non_null(e);
        ASSERT_OK(orr_rinex_obs_write(w, e, &diag), diag);
    }
    ASSERT_OK(orr_rinex_obs_commit(w, &diag), diag);
    orr_rinex_obs_close(r);
    orr_nav n;
    ASSERT_OK(orr_nav_read(nav, NULL, &n, NULL, &diag), diag);
    ASSERT_OK(orr_nav_write(&n, nav_out, NULL, &diag), diag);
    orr_nav_free(&n);
}

#define MAX_LINES 64
typedef struct solution {
    char line[MAX_LINES][256];
    int n;
} solution;

static solution solve(char system, const char *obs, const char *nav)
{
    char command[512];
    snprintf(
        command, sizeof command,
        "rnx2rtkp -p 0 -m 10 -e -sys %c -ts 2020/06/25 00:00:00 -te 2020/06/25 00:09:30 %s %s 2>/dev/null",
        system, obs, nav);
    FILE *p = popen(command, "r");
    assert_non_null(p);
    solution s = {.n = 0};
    char line[256];
    while (fgets(line, sizeof line, p) != NULL)
        if (line[0] != '%' && s.n < MAX_LINES) snprintf(s.line[s.n++], sizeof s.line[0], "%s", line);
    assert_int_equal(pclose(p), 0);
    return s;
}

static void positions_from_our_files(void **state)
{
    (void)state;
    char obs[1024], nav[1024];
    if (!has_rnx2rtkp()) skip();
    if (!orr_test_data(obs_name, obs, sizeof obs)) SKIP_NO_DATA(obs_name);
    if (!orr_test_data(nav_name, nav, sizeof nav)) SKIP_NO_DATA(nav_name);
    char dir[] = "/tmp/orr_peer.XXXXXX", path[4][64];
    assert_non_null(mkdtemp(dir));
    static const char *const names[] = {"theirs.obs", "theirs.nav", "ours.obs", "ours.nav"};
    for (int i = 0; i < 4; i++) snprintf(path[i], sizeof path[i], "%s/%s", dir, names[i]);
    expand(obs, nav, path[0], path[1]);
    rewrite(obs, nav, path[2], path[3], 20);
    for (const char *system = "GREC"; *system != '\0'; system++) {
        solution theirs = solve(*system, path[0], path[1]), ours = solve(*system, path[2], path[3]);
        assert_int_equal(theirs.n, 20);
        assert_int_equal(ours.n, 20);
        for (int i = 0; i < 20; i++) {
            assert_string_equal(ours.line[i], theirs.line[i]);
            double x = 0, y = 0, z = 0;
            assert_int_equal(sscanf(ours.line[i], "%*s %*s %lf %lf %lf", &x, &y, &z), 3);
            // Single frequency without iono and tropo models: some ten metres, mostly up.
            ASSERT_NEAR(x, 3582105.291, 30);
            ASSERT_NEAR(y, 532589.731, 30);
            ASSERT_NEAR(z, 5232754.805, 30);
        }
    }
    for (int i = 0; i < 4; i++) unlink(path[i]);
    rmdir(dir);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(positions_from_our_files)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Hatanaka: what the tests' own encoder made of RINEX text must come back byte for byte; damage must be told,
// and decoding must go on at the next initialised epoch.
#include "testing.h"

#include "core/rng.h"
#include "ingest/rinex/crinex.h"
#include "ingest/rinex/rinex_obs.h"
#include "unit/ingest/crinex_encoder.h"

typedef struct buffer {
    char *p;
    size_t n, capacity;
} buffer;

static void add(buffer *b, const char *text, size_t n)
{
    if (b->n + n + 1 > b->capacity) b->p = realloc(b->p, b->capacity = 2 * (b->n + n) + 1024);
    memcpy(b->p + b->n, text, n);
    b->n += n;
    b->p[b->n] = '\0';
}

static void add_line(buffer *b, const char *text) // as the decoder writes: no trailing blanks
{
    size_t n = strlen(text);
    while (n > 0 && text[n - 1] == ' ') n--;
    add(b, text, n);
    add(b, "\n", 1);
}

static void header(buffer *b, const char *text, const char *label)
{
    char line[96];
    snprintf(line, sizeof line, "%-60s%s", text, label);
    add_line(b, line);
}

static bool collect(void *user, const char *line, size_t n)
{
    add(user, line, n);
    add(user, "\n", 1);
    return true;
}

static buffer expand(const char *text, size_t n, orr_warnings *w, orr_status *status)
{
    buffer out = {0};
    orr_input *in = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_input_open_bytes("made.crx", text, n, NULL, &in, &diag), diag);
    *status = orr_crinex_expand(in, collect, &out, w, &diag);
    orr_input_close(in);
    return out;
}

static void assert_round_trip(const buffer *rinex, int v3, int order, int reinit)
{
    char *packed = crinex_encode(rinex->p, v3, order, reinit);
    orr_status s;
    orr_warnings w = {0};
    buffer back = expand(packed, strlen(packed), &w, &s);
    assert_int_equal(s, ORR_OK);
    assert_int_equal(w.count, 0);
    if (back.n != rinex->n || memcmp(back.p, rinex->p, back.n) != 0) {
        size_t i = 0, line = 1;
        while (i < back.n && i < rinex->n && back.p[i] == rinex->p[i]) line += rinex->p[i++] == '\n';
        fail_msg("order %d, reinit %d: line %zu differs: \"%.60s\" came back as \"%.60s\"", order, reinit,
                 line, rinex->p + i, back.p + i);
    }
    free(packed);
    free(back.p);
    orr_warnings_free(&w);
}

// Version 1.0: an observation that is missing has no flags, and when it is back its flags are differences to blanks; in
// 3.0 flags go on by themselves, so that a flag can stand beside a blank.
static void test_flags_of_missing(void **state)
{
    (void)state;
    static const char packed[] =
        "1.0                 COMPACT RINEX FORMAT                    CRINEX VERS   / TYPE\n"
        "made                                    01-Jan-24 00:00     CRINEX PROG / DATE\n"
        "     2.11           OBSERVATION DATA    G                   RINEX VERSION / TYPE\n"
        "     2    L1    L2                                          # / TYPES OF OBSERV\n"
        "                                                            END OF HEADER\n"
        "&24  1  1  0  0  0.0000000  0  1G05\n\n"
        "3&1000 3&2000 1427\n"
        "               3\n\n"
        "10\n"
        "                6\n\n"
        "10 3&5000   1\n";
    orr_status s;
    orr_warnings w = {0};
    buffer back = expand(packed, strlen(packed), &w, &s);
    assert_int_equal(s, ORR_OK);
    const char *p = strstr(back.p, "END OF HEADER\n");
    assert_non_null(p);
    p = strchr(strchr(p, '\n') + 1, '\n') + 1; // behind the first epoch line
    assert_non_null(strstr(p, "1.00014         2.00027\n"));
    assert_non_null(strstr(p, "1.01014\n"));                // L2 and its flags are blank
    assert_non_null(strstr(p, "1.03014         5.0001\n")); // of L2's old flags nothing is left
    free(back.p);
    orr_warnings_free(&w);
}

// --- made files: smooth numbers with slips, gaps, missing values, satellites that come and go ---

static uint64_t roll(uint64_t *k, uint64_t n) { return orr_rng_u64(2024, 7, (*k)++) % n; }

static void cell(char *out, uint64_t *k, int sat, int code, int epoch)
{
    memset(out, ' ', 16);
    out[16] = '\0';
    if (roll(k, 12) == 0) return; // missing
    double t = epoch * 30.0;
    double v = 2.1e7 + 1e6 * sat - 650.0 * t * (sat % 3 - 1) + 0.08 * t * t + 3e5 * code;
    if (code == 2) v = -3000.5 + 20 * sat - 0.7 * t; // Doppler: negative
    if (roll(k, 40) == 0) v += 12345.678;            // slip
    if (roll(k, 60) == 0) v = 0.001 * (double)roll(k, 1000);
    char text[32];
    snprintf(text, sizeof text, "%14.3f", v);
    memcpy(out, text, 14);
    if (roll(k, 3) == 0) out[14] = (char)('0' + roll(k, 8));
    if (roll(k, 2) == 0) out[15] = (char)('1' + roll(k, 9));
}

static void make_v3(buffer *b, uint64_t seed, int n_epochs)
{
    uint64_t k = seed * 1000003;
    header(b, "     3.05           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
    header(b, "MADE", "MARKER NAME");
    header(b, "G    5 C1C L1C D1C S1C C2W", "SYS / # / OBS TYPES");
    header(b, "R    2 C1C L1C", "SYS / # / OBS TYPES");
    header(b, "E    1 C1X", "SYS / # / OBS TYPES");
    header(b, "  2024    02    04    00    00    0.0000000     GPS", "TIME OF FIRST OBS");
    header(b, "", "END OF HEADER");
    int codes[3] = {5, 2, 1};
    for (int i = 0; i < n_epochs; i++) {
        char line[1024], list[64][4];
        int n = 0;
        for (int s = 1; s <= 12; s++)
            if (roll(&k, 5) != 0) snprintf(list[n++], 4, "%c%02d", "GRE"[s % 3], s);
        int at = snprintf(line, sizeof line, "> 2024 02 04 %02d %02d %2d.0000000  %d%3d", i / 120, i / 2 % 60,
                          i % 2 * 30, roll(&k, 9) == 0, n);
        if (roll(&k, 3) != 0)
            snprintf(line + at, sizeof line - (size_t)at, "      %15.12f",
                     -1.5e-4 + 1e-9 * i + (roll(&k, 5) == 0 ? 1e-3 : 0));
        add_line(b, line);
        for (int s = 0; s < n; s++) {
            int system = list[s][0] == 'G' ? 0 : list[s][0] == 'R' ? 1 : 2;
            at = snprintf(line, sizeof line, "%s", list[s]);
            for (int j = 0; j < codes[system]; j++, at += 16) cell(line + at, &k, atoi(list[s] + 1), j, i);
            add_line(b, line);
        }
        if (roll(&k, 10) == 0) {
            add_line(b, ">                              4  2");
            header(b, "a comment within the data", "COMMENT");
            codes[2] = codes[2] == 1 ? 2 : 1; // the list of a system changes in mid-file
            header(b, codes[2] == 1 ? "E    1 C1X" : "E    2 C1X L1X", "SYS / # / OBS TYPES");
        }
    }
}

static void make_v2(buffer *b, uint64_t seed, int n_epochs)
{
    uint64_t k = seed * 7000003;
    header(b, "     2.11           OBSERVATION DATA    M (MIXED)", "RINEX VERSION / TYPE");
    header(b, "MADE", "MARKER NAME");
    header(b, "     7    C1    P1    D1    P2    L1    L2    S1", "# / TYPES OF OBSERV");
    header(b, "  2008    10     5     0     0    0.0000000     GPS", "TIME OF FIRST OBS");
    header(b, "", "END OF HEADER");
    for (int i = 0; i < n_epochs; i++) {
        char line[256];
        int sats[32], n = 0;
        for (int s = 1; s <= 26; s++)
            if (roll(&k, 4) != 0) sats[n++] = s;
        int at = snprintf(line, sizeof line, " 08 10  5 %2d %2d %2d.0000000  0%3d", i / 120, i / 2 % 60,
                          i % 2 * 30, n);
        for (int j = 0; j < n && j < 12; j++)
            at += snprintf(line + at, sizeof line - (size_t)at, "%c%2d", "GR"[sats[j] % 2], sats[j]);
        if (roll(&k, 2) == 0)
            snprintf(line + at, sizeof line - (size_t)at, "%*s%12.9f", 68 - at, "", 1e-4 - 1e-8 * i);
        add_line(b, line);
        for (int j = 12; j < n; j += 12) {
            at = snprintf(line, sizeof line, "%32s", "");
            for (int m = j; m < n && m < j + 12; m++)
                at += snprintf(line + at, sizeof line - (size_t)at, "%c%2d", "GR"[sats[m] % 2], sats[m]);
            add_line(b, line);
        }
        for (int j = 0; j < n; j++) {
            for (int c = 0; c < 5; c++) cell(line + 16 * c, &k, sats[j], c, i);
            add_line(b, line);
            for (int c = 0; c < 2; c++) cell(line + 16 * c, &k, sats[j], 5 + c, i);
            add_line(b, line);
        }
        if (roll(&k, 12) == 0) {
            add_line(b, " 08 10  5 20  0  0.0000000  3  2");
            header(b, "NEXT", "MARKER NAME");
            header(b, "a new site", "COMMENT");
        }
    }
}

static void round_trip_version_3(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 6; seed++) {
        buffer b = {0};
        make_v3(&b, seed, 60);
        for (int order = 0; order <= 5; order++) assert_round_trip(&b, 1, order, order == 2 ? 7 : 0);
        free(b.p);
    }
}

static void round_trip_version_1(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 6; seed++) {
        buffer b = {0};
        make_v2(&b, seed, 60);
        for (int order = 0; order <= 5; order++) assert_round_trip(&b, 0, order, order == 3 ? 9 : 0);
        free(b.p);
    }
}

// The reader must give the same from the compressed file as from the plain one.
static void assert_same_reading(const char *plain, const char *packed)
{
    orr_rinex_obs *a = NULL, *b = NULL;
    orr_diag diag = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_rinex_obs_open_memory("plain", plain, strlen(plain), NULL, &w, &a, &diag), diag);
    ASSERT_OK(orr_rinex_obs_open_memory("packed", packed, strlen(packed), NULL, &w, &b, &diag), diag);
    assert_false(orr_rinex_obs_header_of(a)->hatanaka);
    assert_true(orr_rinex_obs_header_of(b)->hatanaka);
    const orr_rinex_obs_epoch *x = NULL, *y = NULL;
    size_t n = 0;
    do {
        ASSERT_OK(orr_rinex_obs_next(a, &x, &diag), diag);
        ASSERT_OK(orr_rinex_obs_next(b, &y, &diag), diag);
        assert_int_equal(x == NULL, y == NULL);
        if (x == NULL) break;
        n++;
        assert_int_equal(x->t, y->t);
        assert_int_equal(x->flag, y->flag);
        assert_int_equal(x->n_sats, y->n_sats);
        assert_int_equal(x->n_event_lines, y->n_event_lines);
        assert_true(isnan(x->clock_offset_s)
                        ? isnan(y->clock_offset_s)
                        : fabs(x->clock_offset_s - y->clock_offset_s) < 1e-15); // last digit is 1e-12
        for (size_t i = 0; i < x->n_sats; i++) {
            assert_int_equal(x->sat[i], y->sat[i]);
            size_t n_codes = orr_rinex_obs_header_of(a)->codes[orr_sat_system_index(x->sat[i])].n;
            for (size_t j = 0; j < n_codes; j++) {
                size_t p = i * x->stride + j, q = i * y->stride + j;
                assert_true(isnan(x->value[p]) ? isnan(y->value[q]) : x->value[p] == y->value[q]);
                assert_int_equal(x->lli[p], y->lli[q]);
                assert_int_equal(x->ssi[p], y->ssi[q]);
            }
        }
    } while (true);
    assert_true(n >= 60);
    assert_int_equal(w.count, 0);
    orr_rinex_obs_close(a);
    orr_rinex_obs_close(b);
}

static void reader_sees_no_difference(void **state)
{
    (void)state;
    for (int v3 = 0; v3 < 2; v3++) {
        buffer b = {0};
        if (v3)
            make_v3(&b, 11, 80);
        else
            make_v2(&b, 11, 80);
        char *packed = crinex_encode(b.p, v3, 3, 20);
        assert_same_reading(b.p, packed);
        free(packed);
        free(b.p);
    }
}

static size_t count(const char *text, const char *what)
{
    size_t n = 0;
    for (const char *p = text; (p = strstr(p, what)) != NULL; p++) n++;
    return n;
}

static void damage_is_told_and_left_behind(void **state)
{
    (void)state;
    buffer b = {0};
    make_v3(&b, 3, 40);
    char *packed = crinex_encode(b.p, 1, 3, 10); // initialised at epochs 1, 11, 21, 31
    char *line = strstr(packed, "END OF HEADER");
    for (int i = 0; i < 3; i++) line = strchr(line, '\n') + 1; // past the epoch line and the clock's
    char *spot = strstr(line, "3&");
    memcpy(spot, "9?", 2); // a sequence that cannot be decoded in the first epoch
    orr_status s;
    orr_warnings w = {0};
    buffer back = expand(packed, strlen(packed), &w, &s);
    assert_int_equal(s, ORR_OK);
    assert_true(w.count >= 1);
    size_t lost = count(b.p, "\n> 2024") - count(back.p, "\n> 2024");
    assert_in_range(lost, 1, 10); // never beyond the next initialisation
    free(back.p);
    orr_warnings_free(&w);

    // Cut anywhere: no complaint but warnings, and never an epoch that the file does not have.
    for (size_t cut = strlen(packed) / 2; cut < strlen(packed); cut += 977) {
        w = (orr_warnings){0};
        back = expand(packed, cut, &w, &s);
        assert_int_equal(s, ORR_OK);
        assert_true(count(back.p, "\n> 2024") <= count(b.p, "\n> 2024"));
        free(back.p);
        orr_warnings_free(&w);
    }
    free(packed);
    free(b.p);
}

static void refusals(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        orr_status status;
    } bad[] = {
        {"     3.05           OBSERVATION DATA    M                   RINEX VERSION / TYPE\n", ORR_E_KIND},
        {"3.0                 COMPACT RINEX FORMAT                    CRINEX VERS   / TYPE\n", ORR_E_FORMAT},
        {"3.0                 COMPACT RINEX FORMAT                    CRINEX VERS   / TYPE\nx\nno end\n",
         ORR_E_FORMAT},
        {"2.0                 COMPACT RINEX FORMAT                    CRINEX VERS   / TYPE\nx\n"
         "                                                            END OF HEADER\n",
         ORR_E_UNSUPPORTED},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        orr_status s;
        buffer out = expand(bad[i].text, strlen(bad[i].text), NULL, &s);
        assert_int_equal(s, bad[i].status);
        free(out.p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flags_of_missing),          cmocka_unit_test(round_trip_version_3),
        cmocka_unit_test(round_trip_version_1),           cmocka_unit_test(reader_sees_no_difference),
        cmocka_unit_test(damage_is_told_and_left_behind), cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

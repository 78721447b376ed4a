// SPDX-License-Identifier: GPL-3.0-or-later
// Every odd SP3 file has its verdict: accepted, accepted with warnings, or refused; and why, by the format
// (Hilla 2016) and by the rules of docs/formats.md.
#include "testing.h"

#include <dirent.h>

#include "ingest/inspect/inspect.h"

typedef struct verdict {
    const char *name;
    orr_status status;
    int sats, epochs;    // that have records
    const char *says[5]; // parts of the warnings, all of them, in order; or of the refusal
    const char *why;
} verdict;

static const verdict table[] = {
    {"esa18835.sp3.gz", ORR_OK, 55, 96, {"control characters"}, "NUL bytes in a comment; all else is sound"},
    {"esaBHN.sp3.Z",
     ORR_OK,
     3,
     2,
     {"50 satellites"},
     "records of three of the 53 satellites that the header lists"},
    {"example-a-1.sp3.gz",
     ORR_OK,
     8,
     3,
     {"does not list", "18 satellites", "records are not there"},
     "version a: P 3 is not in the list (and missing), most of the list has no record; epochs 00:00, 00:15, "
     "23:45"},
    {"example-c-1.sp3.gz",
     ORR_OK,
     26,
     2,
     {"interval of 900 s, the smallest step is 171900"},
     "two epochs two days apart"},
    {"example-d-1.sp3.gz",
     ORR_OK,
     12,
     3,
     {"128 satellites", "records are not there"},
     "140 satellites listed, records of twelve"},
    {"example-d-3.sp3.gz", ORR_OK, 1, 1, {"25 satellites"}, "UTC labels, NavIC, UTF-8 in comments"},
    {"example-d-5.sp3.gz", ORR_OK, 1, 1, {"25 satellites"}, "Galileo time, SBAS"},
    {"gbm18432.sp3.Z", ORR_OK, 71, 288, {NULL}, "sound: the name's .Z is LZW"},
    {"gbm19500_after_no_drop.sp3.gz",
     ORR_OK,
     87,
     2,
     {"line ##"},
     "week and seconds of line 2 say 00:00, line 1 says 00:10"},
    {"gbm19500_truncated.sp3.gz", ORR_OK, 87, 2, {NULL}, "two whole epochs and EOF, as the header says"},
    {"gbm19500_wrong_agency.sp3.gz", ORR_OK, 87, 2, {"line ##"}, "the agency is free text"},
    {"gbm19500_wrong_data_used.sp3.gz", ORR_OK, 87, 2, {"line ##"}, "what was used is free text"},
    {"gbm19500_wrong_gap.sp3.gz", ORR_OK, 87, 2, {"line ##"}, "one file cannot know the other's end"},
    {"gbm19500_wrong_satellite_count.sp3.gz",
     ORR_OK,
     86,
     2,
     {"satellite 87 of the list", "line ##"},
     "86 satellites in count, list and records, but 87 accuracies"},
    {"gbm19500_wrong_time_system.sp3.gz", ORR_OK, 87, 2, {"line ##"}, "TAI is a time system of the format"},
    {"inconsistent-sampling-dates.sp3.gz",
     ORR_OK,
     8,
     3,
     {"does not list", "18 satellites", "not whole intervals of 900 s", "records are not there"},
     "the last epoch is 23:46; the records' own times are what counts"},
    {"issue1327-136-sats.sp3.gz",
     ORR_OK,
     136,
     4,
     {"line ##", "clocks of 21 satellites"},
     "136 satellites; line 2 is zero; clocks of 0.000000 where the format wants 999999.999999"},
    {"issue895-header-comment.sp3.gz",
     ORR_OK,
     1,
     1,
     {NULL},
     "comments that begin with %/*, read as comments"},
    {"issue895-minutes-increment.sp3.gz",
     ORR_OK,
     1,
     91,
     {"minute 60", "the start is"},
     "16:60 is 17:00; the header's start is three days before the first epoch"},
    {"issue895-second-digits.sp3.gz",
     ORR_OK,
     1,
     1,
     {"line ##"},
     "seconds with four decimals; line 2 has none of them"},
    {"missing-eof.sp3.gz",
     ORR_OK,
     1,
     1,
     {"without EOF", "192 epochs, found 1", "25 satellites"},
     "cut between two lines: what is there is whole"},
    {"nsgf.orb.stella.v00.sp3.gz",
     ORR_OK,
     1,
     1831,
     {NULL},
     "positions and velocities without clocks, 60 columns"},
    {"sp3_a_example1.txt.gz",
     ORR_OK,
     7,
     3,
     {"dotted lines", "96 epochs, found 3", "18 satellites", "records are not there"},
     "the printed example of version a with its dots"},
    {"sp3_c_example1.txt.gz",
     ORR_OK,
     8,
     2,
     {"dotted lines", "192 epochs, found 2", "18 satellites", "smallest step is 171900",
      "records are not there"},
     "the printed example of version c with its dots"},
    {"three-hours.sp3.gz", ORR_OK, 2, 36, {NULL}, "places of the list filled with 00 instead of 0"},
    {"too-long-comment-d.sp3.gz",
     ORR_OK,
     1,
     1,
     {"column 80", "column 80", "25 satellites"},
     "two comments go on beyond column 80; nothing depends on it, so they are kept whole"},
    {"truncated-line.sp3.gz",
     ORR_OK,
     3,
     1,
     {"inside this line", "without EOF", "2 epochs, found 1", "23 satellites"},
     "cut inside a record: that one is left out, the whole ones before it are kept"},
    {"unknownType.sp3.Z", ORR_OK, 3, 2, {"50 satellites"}, "the orbit type is free text"},
    {"wrong-clock-base-a.sp3.gz",
     ORR_OK,
     8,
     3,
     {"does not list", "18 satellites", "records are not there"},
     "a base without exponents says nothing"},
    {"wrong-line-identifier.sp3.gz",
     ORR_E_FORMAT,
     0,
     0,
     {"'@@ ' begins no line"},
     "the line was %c: without it the time system would be a guess, 18 s or 70 km off"},
    {"wrong-pos-vel-base-a.sp3.gz",
     ORR_OK,
     8,
     3,
     {"does not list", "18 satellites", "records are not there"},
     "a base without exponents says nothing"},
};
enum { N = sizeof table / sizeof table[0] };

static void check(const char *path, const verdict *v)
{
    orr_inspection r;
    orr_diag d = {0};
    orr_status st = orr_inspect(path, NULL, &r, &d);
    if (st != v->status)
        fail_msg("%s: %s (%s), not %s: %s", v->name, orr_status_name(st), d.text, orr_status_name(v->status),
                 v->why);
    if (st != ORR_OK) {
        assert_non_null(strstr(d.text, v->says[0]));
        assert_true(d.line > 0 && d.column > 0);
    } else {
        if (r.satellites != v->sats || r.epochs != v->epochs)
            fail_msg("%s: %d satellites, %d epochs: %s", v->name, (int)r.satellites, (int)r.epochs, v->why);
        size_t n = 0;
        while (n < 5 && v->says[n] != NULL) n++;
        if (r.warnings.count != n)
            fail_msg("%s: %zu warnings, not %zu: %s", v->name, r.warnings.count, n, v->why);
        for (size_t i = 0; i < n; i++)
            if (strstr(r.warnings.item[i].text, v->says[i]) == NULL)
                fail_msg("%s: '%s' says nothing of '%s'", v->name, r.warnings.item[i].text, v->says[i]);
    }
    orr_inspection_free(&r);
}

static void test_verdicts(void **state)
{
    (void)state;
    char path[1024];
    if (!orr_test_data("odd/sp3/missing-eof.sp3.gz", path, sizeof path)) SKIP_NO_DATA("odd/sp3");
    *strrchr(path, '/') = '\0';
    DIR *d = opendir(path);
    assert_non_null(d);
    size_t seen = 0;
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        if (e->d_name[0] == '.') continue;
        const verdict *v = NULL;
        for (size_t i = 0; i < N; i++)
            if (strcmp(table[i].name, e->d_name) == 0) v = &table[i];
        if (v == NULL) fail_msg("%s has no verdict", e->d_name);
        char file[2048];
        snprintf(file, sizeof file, "%s/%s", path, e->d_name);
        check(file, v);
        seen++;
    }
    closedir(d);
    assert_int_equal(seen, N);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_verdicts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

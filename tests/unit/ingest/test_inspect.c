// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of files, against what stands in the small ones of tests/fuzz/corpus; and every field of each of them made wrong in turn: it is
// read all the same, or refused with a sentence that names the file and a line of it.
#include "testing.h"

#include <dirent.h>
#include <unistd.h>

#include "ingest/inspect/inspect.h"
#include "ingest/telemetry/telemetry.h"

#define CORPUS ORR_SOURCE_DIR "/tests/fuzz/corpus/"
enum { MOST = 1 << 16 };

static const char *fact(const orr_inspection *r, const char *label)
{
    for (size_t k = 0; k < r->n_facts; k++)
        if (strcmp(r->fact[k].label, label) == 0) return r->fact[k].text;
    return "";
}

// A file and what is told of it; ORR_INSPECT_NONE and NULL: not looked at.
typedef struct told {
    const char *file, *version, *systems;
    int64_t records, satellites, epochs;
    const char *label, *text;
} told;

static void facts(void **state)
{
    (void)state;
    static const told all[] = {
        {"antex/plain", "1.4", "G", 2, 1, -1, "receiver antennas", "1"},
        {"bias/sinex", "1.00", "G", 5, 1, -1, "biases", "3 OSB, 2 DSB, 0 ISB"},
        {"bias/sinex", NULL, NULL, 5, 1, -1, "of them", "1 of phases, 1 of stations"},
        {"bias/dcb", NULL, "GR", 3, 2, -1, "of them", "0 of phases, 1 of stations"},
        {"clk/v304", "3.04", "GR", -1, 2, -1, "time labels", "GPS"},
        {"erp/igs", "2", NULL, 2, -1, 2, "first values",
         "pole 301.078 310.229 mas, UT1-UTC -9.8409 ms, LOD -0.1857 ms"},
        {"ion/two_models", NULL, NULL, 2, -1, 2, "expansion", "degree 2, order 2, 18 coefficients in all"},
        {"ion/two_models", NULL, NULL, 2, -1, 2, "frame", "geomagnetic, mean Sun"},
        {"ionex/tec", "1.0", NULL, 2, -1, 2, "grid",
         "2 latitudes 10.0 to -10.0, 18 longitudes -180.0 to 160.0"},
        {"ionex/three_dimensional", NULL, NULL, -1, -1, -1, "time labels", "universal time"},
        {"sinex/station", "2.02", NULL, 1, -1, -1, "sites", "1"},
        {"sinex/station", NULL, NULL, 1, -1, -1, "eccentricities", "1"},
        {"troposphere/gpt3.grd", NULL, NULL, -1, -1, -1, "grid", NULL},
        {"troposphere/terrain.asc", NULL, NULL, 6, -1, -1, "heights", "70 to 120.5 m"},
        {"troposphere/terrain.asc", NULL, NULL, 6, -1, -1, "no height", "1 points"},
        {"troposphere/v3gr.H00", NULL, NULL, 4, -1, 1, "gradients", "yes"},
        {"troposphere/2024035.v3gr_g", NULL, NULL, -1, -1, -1, "gradients", "yes"},
    };
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
        const told *t = &all[k];
        char path[256];
        orr_inspection r;
        orr_diag diag = {0};
        snprintf(path, sizeof path, CORPUS "%s", t->file);
        ASSERT_OK(orr_inspect(path, NULL, &r, &diag), diag);
        if (t->version != NULL) assert_string_equal(r.version, t->version);
        if (t->systems != NULL) assert_string_equal(r.systems, t->systems);
        if (t->records >= 0) assert_int_equal(r.records, t->records);
        if (t->satellites >= 0) assert_int_equal(r.satellites, t->satellites);
        if (t->epochs >= 0) assert_int_equal(r.epochs, t->epochs);
        if (t->text != NULL)
            assert_string_equal(fact(&r, t->label), t->text);
        else
            assert_true(fact(&r, t->label)[0] != '\0');
        orr_inspection_free(&r);
    }
}

// --- Every field made wrong ---

typedef struct sweep {
    char text[MOST], path[64];
    size_t n, reads, refusals; // refusals: of a file, or of a part of it with a warning
    bool whole;                // every wrong value for every field of every line: with ORRERY_LONG
    bool telemetry;            // read as a log, which inspect does not
} sweep;

static void put_file(const char *path, const char *text, size_t n)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(text, 1, n, f), n);
    assert_int_equal(fclose(f), 0);
}

static void sentence_of(const sweep *s, const orr_diag *d, size_t lines)
{
    if (d->text[0] == '\0') fail_msg("%s: no sentence", s->path);
    if (d->file[0] != '\0') assert_string_equal(d->file, s->path);
    if (d->line < 0 || d->line > (int64_t)lines + 1)
        fail_msg("'%s': line %d of %zu", d->text, (int)d->line, lines);
}

static void look(sweep *s, const char *text, size_t n)
{
    orr_inspection r;
    orr_diag diag = {0};
    size_t lines = 1;
    for (size_t k = 0; k < n; k++) lines += text[k] == '\n';
    put_file(s->path, text, n);
    orr_status status = orr_inspect(s->path, NULL, &r, &diag);
    if (s->telemetry) {
        orr_telemetry t;
        diag = (orr_diag){0};
        status = orr_telemetry_read(s->path, NULL, NULL, &t, &r.warnings, &diag);
        if (status == ORR_OK) orr_telemetry_free(&t);
    }
    s->reads++;
    s->refusals += status != ORR_OK || r.warnings.count > 0;
    if (status != ORR_OK) sentence_of(s, &diag, lines);
    for (size_t k = 0; k < r.warnings.kept; k++) sentence_of(s, &r.warnings.item[k], lines);
    orr_inspection_free(&r);
}

// The text with n bytes at a place taken out and others put in.
static void with(sweep *s, size_t at, size_t n, const char *other)
{
    static char made[2 * MOST];
    const size_t m = strlen(other);
    memcpy(made, s->text, at);
    memcpy(made + at, other, m);
    memcpy(made + at + m, s->text + at + n, s->n - at - n);
    look(s, made, s->n - n + m);
}

static void one_file(sweep *s, const char *path)
{
    static const char *const wrong[] = {"", "x", "-1", "99999999", "1e300", "0"};
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    s->n = fread(s->text, 1, sizeof s->text, f);
    fclose(f);
    if (s->text[0] == '@') return; // columns that are declared beside the file
    look(s, s->text, s->n);
    size_t lines = 0;
    const size_t most = s->whole ? 400 : 30, step = s->whole ? 1 : 3;
    for (size_t at = 0, end; at < s->n && lines < most; at = end + 1, lines++) {
        for (end = at; end < s->n && s->text[end] != '\n'; end++) continue;
        with(s, at, end - at, "");                // an empty line
        with(s, at, end + (end < s->n) - at, ""); // none
        with(s, at + (end - at) / 2, end - at - (end - at) / 2, "");
        for (size_t from = at, to; from < end; from = to) {
            while (from < end && (s->text[from] == ' ' || s->text[from] == ',')) from++;
            for (to = from; to < end && s->text[to] != ' ' && s->text[to] != ','; to++) continue;
            if (to == from) break;
            for (size_t k = (lines + from) % step; k < sizeof wrong / sizeof wrong[0];
                 k += step) { // as wide as it was, so that what follows stays in its columns
                char cell[400];
                const size_t width = to - from < sizeof cell - 1 ? to - from : sizeof cell - 1;
                snprintf(cell, sizeof cell, "%*.*s", (int)width, (int)width, wrong[k]);
                with(s, from, to - from, cell);
            }
        }
    }
}

static void fields_made_wrong(void **state)
{
    (void)state;
    static const char *const kinds[] = {"antex",     "bias",  "clk",        "crinex",    "erp",
                                        "ion",       "ionex", "sinex",      "rinex_nav", "rinex_obs",
                                        "telemetry", "sp3",   "troposphere"};
    static sweep s;
    s.whole = getenv("ORRERY_LONG") != NULL;
    snprintf(s.path, sizeof s.path, "/tmp/orrery-inspect-%ld", (long)getpid());
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        char folder[256], path[600];
        snprintf(folder, sizeof folder, CORPUS "%s", kinds[k]);
        DIR *d = opendir(folder);
        assert_non_null(d);
        for (struct dirent *e; (e = readdir(d)) != NULL;) {
            if (e->d_name[0] == '.') continue;
            snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
            s.telemetry = strcmp(kinds[k], "telemetry") == 0;
            const size_t before = s.refusals;
            one_file(&s, path);
            if (s.refusals == before && s.text[0] != '@')
                fail_msg("%s: nothing that is wrong with it is refused", path);
        }
        closedir(d);
    }
    unlink(s.path);
    print_message("%zu files read, %zu refused\n", s.reads, s.refusals);
}

static void what_is_no_file(void **state)
{
    (void)state;
    orr_inspection r;
    orr_diag diag = {0};
    assert_int_equal(orr_inspect(CORPUS "none", NULL, &r, &diag), ORR_E_IO);
    assert_string_equal(diag.file, CORPUS "none");
    assert_true(diag.text[0] != '\0');
    orr_inspection_free(&r);
    assert_int_not_equal(orr_inspect(CORPUS, NULL, &r, &diag), ORR_OK);
    orr_inspection_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(facts),
        cmocka_unit_test(fields_made_wrong),
        cmocka_unit_test(what_is_no_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

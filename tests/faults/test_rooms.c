// SPDX-License-Identifier: GPL-3.0-or-later
// Readers, writers and parts of the service in one process, with one call after the other failing, every one until all succeed: what fails says
// so and leaves nothing behind, and what succeeds all the same has done its work. Leaks are found at the end, by the leak checker.
#include "testing.h"

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/leap.h"
#include "core/ncfile.h"
#include "ingest/fetch/archives.h"
#include "ingest/inspect/inspect.h"
#include "ingest/maps/ion.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/clk.h"
#include "ingest/rinex/rinex_nav.h"
#include "ingest/rinex/rinex_obs.h"
#include "ingest/sp3/sp3.h"
#include "ingest/tables/blq.h"
#include "ingest/tables/erp.h"
#include "ingest/tables/gravity_file.h"
#include "ingest/tables/satellite_metadata.h"
#include "ingest/telemetry/telemetry.h"
#include "src/service/net/access.h"
#include "src/service/net/certificates.h"
#include "src/service/net/url.h"
#include "src/service/text/session.h"
#include "unit/proto/fake.h"
#include "wrap.h"

#define CORPUS ORR_SOURCE_DIR "/tests/fuzz/corpus/"

static faults *wrapped;
static char root[64], out_path[96], in_path[600];
static size_t tried;

// How many entries a folder has.
static size_t entries(const char *folder)
{
    size_t n = 0;
    DIR *d = opendir(folder);
    assert_non_null(d);
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        if (strstr(e->d_name, ".part-") != NULL) fail_msg("%s is left behind", e->d_name);
        n += e->d_name[0] != '.' || strlen(e->d_name) > 2;
    }
    closedir(d);
    return n;
}

static void clear(const char *folder)
{
    char path[400];
    DIR *d = opendir(folder);
    assert_non_null(d);
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        if (e->d_name[0] != '.' || strlen(e->d_name) > 2) unlink(path);
    }
    closedir(d);
}

typedef orr_status (*action)(orr_diag *diag);

// The action with its N-th call failing, N = 1, 2, ... until it has fewer. `files` of it that succeeded stand in the folder, and none of it that
// failed; where `keeps`, those that were whole before the failure may.
static void each(const char *what, action act, size_t files, bool keeps)
{
    for (long long n = 1;; n++) {
        orr_diag diag = {0};
        clear(root);
        atomic_store(&wrapped->calls, 0);
        atomic_store(&wrapped->hits, 0);
        atomic_store(&wrapped->fail, n);
        const orr_status s = act(&diag);
        atomic_store(&wrapped->fail, 0);
        const bool hit = atomic_load(&wrapped->hits) > 0;
        tried += hit;
        if (!hit && s != ORR_OK) fail_msg("%s: %s (%s)", what, orr_status_name(s), diag.text);
        if (s != ORR_OK && diag.text[0] == '\0')
            fail_msg("%s, call %lld (%s): %s without a sentence", what, n, wrapped->name, orr_status_name(s));
        const size_t left = entries(root);
        if (s == ORR_OK ? left != files : left > (keeps ? files : 0))
            fail_msg("%s, call %lld (%s): %s and %zu files", what, n, wrapped->name, orr_status_name(s),
                     left);
        if (!hit) return;
    }
}

// --- Readers ---

static orr_status inspect(orr_diag *diag)
{
    orr_inspection r;
    const orr_status s = orr_inspect(in_path, NULL, &r, diag);
    orr_inspection_free(&r);
    return s;
}

static orr_status read_log(orr_diag *diag)
{
    orr_telemetry t;
    orr_warnings w = {0};
    const orr_status s = orr_telemetry_read(in_path, NULL, NULL, &t, &w, diag);
    if (s == ORR_OK) orr_telemetry_free(&t);
    orr_warnings_free(&w);
    return s;
}

static void all_of(const char *kind, action act)
{
    char folder[256];
    snprintf(folder, sizeof folder, CORPUS "%s", kind);
    DIR *d = opendir(folder);
    assert_non_null(d);
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        orr_diag diag = {0};
        if (e->d_name[0] == '.') continue;
        snprintf(in_path, sizeof in_path, "%s/%s", folder, e->d_name);
        if (act(&diag) == ORR_OK) each(in_path, act, 0, false);
    }
    closedir(d);
}

static void readers(void **state)
{
    (void)state;
    static const char *const kinds[] = {"antex", "bias", "clk",        "crinex",    "erp",
                                        "input", "ion",  "ionex",      "rinex_nav", "rinex_obs",
                                        "sinex", "sp3",  "troposphere"};
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) all_of(kinds[k], inspect);
    all_of("telemetry", read_log);
}

#define BLQ_ROW " .00352 .00123 .00080 .00032 .00187 .00112 .00063 .00003 .00082 .00044 .00037\n"

static orr_status archives(orr_diag *diag)
{
    orr_archives *a = NULL;
    orr_candidate *c = NULL;
    size_t n = 0;
    const orr_wanted w = {.product = ORR_PRODUCT_SP3, .mjd = 60755};
    orr_status s = orr_archives_read(NULL, &a, diag);
    if (s == ORR_OK) s = orr_archives_candidates(a, &w, &c, &n, diag);
    free(c);
    orr_archives_free(a);
    return s;
}

static orr_status metadata(orr_diag *diag)
{
    orr_satellite_metadata m;
    const orr_status s = orr_satellite_metadata_read(CORPUS "satellite_metadata/igs", NULL, &m, NULL, diag);
    if (s == ORR_OK) orr_satellite_metadata_free(&m);
    return s;
}

static orr_status gravity(orr_diag *diag)
{
    orr_bytes text;
    orr_gravity_file f;
    orr_status s = orr_input_read_all(CORPUS "gravity/map.csv", NULL, &text, diag);
    if (s != ORR_OK) return s;
    s = orr_gravity_file_parse("map", text.text, text.n, &f, diag);
    orr_bytes_free(&text);
    if (s == ORR_OK) orr_gravity_file_free(&f);
    return s;
}

static orr_status loading(orr_diag *diag)
{
    orr_blq b;
    return orr_blq_read(in_path, "ONSALA", &b, diag);
}

static orr_status leap_seconds(orr_diag *diag)
{
    orr_leap_table t;
    const orr_status s = orr_leap_read(in_path, &t, diag);
    if (s == ORR_OK) orr_leap_free(&t);
    return s;
}

static void put(const char *name, const char *text)
{
    snprintf(in_path, sizeof in_path, "%s-%s", root, name);
    FILE *f = fopen(in_path, "w");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
}

static void tables(void **state)
{
    (void)state;
    each("archives", archives, 0, false);
    each("satellite metadata", metadata, 0, false);
    each("gravity", gravity, 0, false);
    put("blq", "$$ made\n  ONSALA\n" BLQ_ROW BLQ_ROW BLQ_ROW BLQ_ROW BLQ_ROW BLQ_ROW);
    each("ocean loading", loading, 0, false);
    unlink(in_path);
    put("leap", "#@\t4000000000\n2272060800\t10\n2287785600\t11\n2303683200\t12\n");
    each("leap seconds", leap_seconds, 0, false);
    unlink(in_path);
}

// --- Writers: what a file of the corpus holds, written ---

#define READ_AND_WRITE(name, type, parse, write, release)                                                    \
    static orr_status name(orr_diag *diag)                                                                   \
    {                                                                                                        \
        type x;                                                                                              \
        orr_bytes text;                                                                                      \
        orr_status s = orr_input_read_all(in_path, NULL, &text, diag);                                       \
        if (s != ORR_OK) return s;                                                                           \
        s = parse;                                                                                           \
        orr_bytes_free(&text);                                                                               \
        if (s != ORR_OK) return s;                                                                           \
        s = write;                                                                                           \
        release(&x);                                                                                         \
        return s;                                                                                            \
    }
READ_AND_WRITE(sp3_again, orr_sp3, orr_sp3_parse(in_path, text.text, text.n, NULL, &x, NULL, diag),
               orr_sp3_write(&x, out_path, diag), orr_sp3_free)
READ_AND_WRITE(ionex_again, orr_ionex, orr_ionex_parse(in_path, text.text, text.n, NULL, &x, NULL, diag),
               orr_ionex_write(&x, out_path, diag), orr_ionex_free)
READ_AND_WRITE(ion_again, orr_ion, orr_ion_parse(in_path, text.text, text.n, NULL, &x, NULL, diag),
               orr_ion_write(&x, out_path, diag), orr_ion_free)
READ_AND_WRITE(erp_again, orr_erp, orr_erp_parse(in_path, text.text, text.n, NULL, NULL, &x, NULL, diag),
               orr_erp_write(&x, NULL, 0, out_path, diag), orr_erp_free)
READ_AND_WRITE(clk_again, orr_clk, orr_clk_parse(in_path, text.text, text.n, NULL, &x, NULL, diag),
               orr_clk_write(&x, out_path, diag), orr_clk_free)
READ_AND_WRITE(nav_again, orr_nav, orr_nav_parse(in_path, text.text, text.n, NULL, &x, NULL, diag),
               orr_nav_write(&x, out_path, NULL, diag), orr_nav_free)

static orr_status obs_again(orr_diag *diag)
{
    orr_rinex_obs *r = NULL;
    orr_rinex_obs_writer *w = NULL;
    const orr_rinex_obs_epoch *e = NULL;
    orr_status s = orr_rinex_obs_open(in_path, NULL, NULL, &r, diag);
    if (s == ORR_OK) s = orr_rinex_obs_create(out_path, 3.05, orr_rinex_obs_header_of(r), &w, diag);
    while (s == ORR_OK && (s = orr_rinex_obs_next(r, &e, diag)) == ORR_OK && e != NULL)
        s = orr_rinex_obs_write(w, e, diag);
    if (s == ORR_OK)
        s = orr_rinex_obs_commit(w, diag);
    else
        orr_rinex_obs_abort(w);
    orr_rinex_obs_close(r);
    return s;
}

static orr_status product(orr_diag *diag)
{
    static const double v[6] = {1, 2, 3, 4, 5, 6};
    static const int64_t flags[2] = {1, 2};
    const char *const dims[] = {"row", "column"};
    const size_t shape[] = {2, 3};
    const orr_nc_input input = {"a file", "00"};
    double back[6] = {0}, number = 0;
    char title[40];
    orr_nc_writer w;
    orr_nc_reader r = {0};
    size_t len = 0;
    void *again = NULL;
    orr_status s = orr_nc_create(out_path, &w, diag);
    if (s != ORR_OK) return s;
    if (s == ORR_OK) s = orr_nc_put_dim(&w, "row", 2, diag);
    if (s == ORR_OK) s = orr_nc_put_dim(&w, "column", 3, diag);
    if (s == ORR_OK) s = orr_nc_put_var(&w, "v", ORR_NC_DOUBLE, 2, dims, v, "m", "values", diag);
    if (s == ORR_OK) s = orr_nc_put_att_double(&w, "v", "scale", v, 1, diag);
    if (s == ORR_OK) s = orr_nc_put_att_int64(&w, NULL, "flags", flags, 2, diag);
    if (s == ORR_OK) s = orr_nc_put_provenance(&w, "made", "by hand", &input, 1, diag);
    if (s == ORR_OK)
        s = orr_nc_commit(&w, diag);
    else
        orr_nc_abort(&w);
    if (s != ORR_OK) return s;
    s = orr_nc_open(out_path, &r, diag);
    if (s == ORR_OK) s = orr_nc_get_dim(&r, "row", 10, &len, diag);
    if (s == ORR_OK) s = orr_nc_get_var(&r, "v", ORR_NC_DOUBLE, 2, shape, back, diag);
    if (s == ORR_OK) s = orr_nc_alloc_var(&r, "v", ORR_NC_DOUBLE, 2, shape, &again, diag);
    if (s == ORR_OK) s = orr_nc_get_att_double(&r, "v", "scale", &number, diag);
    if (s == ORR_OK) s = orr_nc_get_att_text(&r, NULL, "title", title, sizeof title, diag);
    if (s == ORR_OK && (memcmp(back, v, sizeof v) != 0 || memcmp(again, v, sizeof v) != 0 || len != 2))
        s = orr_diag_set(diag, ORR_E_FORMAT, "another product came back");
    free(again);
    orr_nc_close(&r);
    return s;
}

static void writers(void **state)
{
    (void)state;
    static const struct {
        const char *file;
        action act;
    } all[] = {{"sp3/d", sp3_again},
               {"sp3/c", sp3_again},
               {"ionex/all_kinds", ionex_again},
               {"ion/two_models", ion_again},
               {"erp/igs", erp_again},
               {"clk/v304", clk_again},
               {"clk/v300", clk_again},
               {"rinex_nav/v4_all", nav_again},
               {"rinex_nav/v3_mixed", nav_again}};
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
        snprintf(in_path, sizeof in_path, CORPUS "%s", all[k].file);
        each(all[k].file, all[k].act, 1, false);
    }
    snprintf(in_path, sizeof in_path, CORPUS "rinex_obs/v3_mixed");
    each("observations", obs_again, 1, false);
    each("a product", product, 1, true);
}

// --- The service's parts ---

static orr_status laboratory(orr_diag *diag)
{
    const char *const names[] = {"localhost", "127.0.0.1"};
    orr_status s = orr_certificates_authority(root, 10, diag);
    if (s == ORR_OK) s = orr_certificates_server(root, names, 2, 10, diag);
    if (s == ORR_OK) s = orr_certificates_client(root, "one", 10, diag);
    return s;
}

static orr_status rules(orr_diag *diag)
{
    orr_access *a = NULL;
    orr_status s = orr_access_open(in_path, false, ORR_MAY_ALL, &a, diag);
    if (s == ORR_OK) s = orr_access_reload(a, diag);
    orr_access_close(a);
    return s;
}

static void host(void *user, orr_host *h)
{
    (void)user;
    *h = (orr_host){1000, 1000, INT64_C(1700000000000000000), INT64_C(1700000037000000000)};
}

// Lines of the text twin: an answer may be missing or an error, and what is there are whole lines.
static orr_status conversation(orr_diag *diag)
{
    static const char asked[] = "*IDN?\nSAT:LIST?\n{\"request\": \"POLL\", \"t\": 1000, \"step\": 10, "
                                "\"count\": 2, \"satellites\": [\"G01\"]}\n"
                                "{\"request\": \"GET_TIME\"}\n{\"request\": \"PING\", \"token\": "
                                "\"5\"}\n{\"request\": 5}\n{]\nSYST:ERR?\n";
    static uint8_t room[ORR_MSG_LARGEST];
    fake f = {.n_sats = 3};
    const orr_server server = fake_server(&f);
    const orr_streams_options o = {.maker = &server, .host = host, .processor = -1};
    orr_streams *streams = NULL;
    orr_status s = orr_streams_open(&o, &streams, diag);
    if (s != ORR_OK) return s;
    const orr_asked who = {.server = &server, .streams = streams, .may = ORR_MAY_ALL, .room = room};
    orr_text_session t;
    char *answer = NULL;
    size_t n = 0;
    FILE *out = open_memstream(&answer, &n);
    if (out == NULL || !orr_text_session_open(&t, &who)) {
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a session");
    } else {
        orr_text_session_take(&t, asked, sizeof asked - 1, out);
        orr_text_session_close(&t);
    }
    if (out != NULL) fclose(out);
    if (n > 0 && answer[n - 1] != '\n') fail_msg("half a line: '%s'", answer);
    free(answer);
    orr_streams_close(streams);
    return s;
}

// Places to listen on, of every kind, and clients who come.
static orr_status sockets(orr_diag *diag)
{
    char path[120];
    snprintf(path, sizeof path, "unix:%s/socket", root);
    const char *const places[] = {"tcp://127.0.0.1:0", "tcp://[::1]:0", path};
    orr_status s = ORR_OK;
    for (size_t k = 0; k < 3 && s == ORR_OK; k++) {
        orr_url u, bound, again;
        int listens = -1, comes = -1, datagrams = -1;
        s = orr_url_parse(places[k], &u, diag);
        if (s == ORR_OK) s = orr_url_listen(&u, 4, &listens, &bound, diag);
        if (s == ORR_OK) s = orr_url_of_socket(listens, &again, diag);
        if (s == ORR_OK) s = orr_url_connect(&bound, 10, &comes, diag);
        if (s == ORR_OK && !u.is_unix) s = orr_url_bind_datagrams(&u, &datagrams, &again, diag);
        if (listens >= 0) close(listens);
        if (comes >= 0) close(comes);
        if (datagrams >= 0) close(datagrams);
        unlink(path + 5);
    }
    return s;
}

static void service(void **state)
{
    (void)state;
    char lab[96];
    orr_diag diag = {0};
    each("certificates", laboratory, 5, true);
    snprintf(lab, sizeof lab, "%s-lab", root);
    const char *const names[] = {"localhost"};
    ASSERT_OK(orr_certificates_authority(lab, 10, &diag), diag);
    ASSERT_OK(orr_certificates_server(lab, names, 1, 10, &diag), diag);
    snprintf(in_path, sizeof in_path, "%s/access.yaml", lab);
    FILE *f = fopen(in_path, "w");
    assert_non_null(f);
    fputs("certificate: server.pem\nkey: server.key\nauthority: ca.pem\nclients: [{name: one, may: [read, "
          "motion]}]\n",
          f);
    assert_int_equal(fclose(f), 0);
    each("access", rules, 0, false);
    each("text", conversation, 0, false);
    each("sockets", sockets, 0, false);
    clear(lab);
    assert_int_equal(rmdir(lab), 0);
}

static int begin(void **state)
{
    (void)state;
    wrapped = faults_share(NULL);
    snprintf(root, sizeof root, "/tmp/orrery-rooms-%ld", (long)getpid());
    snprintf(out_path, sizeof out_path, "%s/out", root);
    return mkdir(root, 0700);
}

static int end(void **state)
{
    (void)state;
    print_message("%zu calls failed\n", tried);
    clear(root);
    return rmdir(root);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(readers),
        cmocka_unit_test(tables),
        cmocka_unit_test(writers),
        cmocka_unit_test(service),
    };
    return cmocka_run_group_tests(tests, begin, end);
}

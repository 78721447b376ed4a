// SPDX-License-Identifier: GPL-3.0-or-later
// orrery fetch: products of the IGS for some days into the cache.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "ingest/fetch/fetch.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

#define MAX_FILES 20000

typedef struct wish {
    orr_product product;
    char station[10];
} wish;

// "sp3,nav,obs:BOR1": the products of a list. Returns how many, or -1 after saying what is wrong.
static int read_wishes(const orr_cli *c, const char *text, wish *out, int most)
{
    int n = 0;
    while (*text != '\0') {
        size_t len = strcspn(text, ","), name = strcspn(text, ",:");
        wish w = {0};
        if (!orr_product_parse(text, name, &w.product)) {
            orr_cli_usage(c,
                          "--products: \"%.*s\" is not known (sp3, nav, ionex, ion, erp, clk, bias, sinex, "
                          "obs:STATION)",
                          (int)len, text);
            return -1;
        }
        size_t station = len > name ? len - name - 1 : 0;
        if ((w.product == ORR_PRODUCT_OBS) != (station > 0) ||
            (station != 0 && station != 4 && station != 9)) {
            orr_cli_usage(c, "--products: obs takes a station of four or nine characters (obs:BOR1), the "
                             "others take none");
            return -1;
        }
        snprintf(w.station, sizeof w.station, "%.*s", (int)station, text + name + 1);
        if (strspn(w.station, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") != station) {
            orr_cli_usage(c, "--products: \"%s\" is no station's name", w.station);
            return -1;
        }
        if (n == most) {
            orr_cli_usage(c, "--products: more than %d", most);
            return -1;
        }
        out[n++] = w;
        text += len;
        if (*text == ',') text++;
    }
    if (n == 0) orr_cli_usage(c, "--products names none");
    return n > 0 ? n : -1;
}

static void progress(void *user, const orr_fetch_progress *p)
{
    char what[160];
    snprintf(what, sizeof what, "%zu under way, %.1f MB %.60s", p->active, (double)p->bytes * 1e-6, p->name);
    orr_cli_progress(user, what, p->done, p->total);
}

static bool cancelled(void *user) { return orr_cli_interrupted(user); }

static void wanted_text(const orr_wanted *w, char buf[64])
{
    int year, month, day;
    orr_date_from_mjd(w->mjd, &year, &month, &day);
    snprintf(buf, 64, "%s%s%s of %04d-%02d-%02d", orr_product_name(w->product),
             w->station[0] != '\0' ? ":" : "", w->station, year, month, day);
}

static int print_json(const orr_cli *c, const orr_fetch_item *item, size_t n)
{
    json_t *list = json_array();
    for (size_t i = 0; i < n; i++) {
        const orr_fetch_item *f = &item[i];
        json_t *j = json_object();
        char date[16];
        int year, month, day;
        orr_date_from_mjd(f->wanted.mjd, &year, &month, &day);
        snprintf(date, sizeof date, "%04d-%02d-%02d", year, month, day);
        json_object_set_new(j, "product", orr_json_text(orr_product_name(f->wanted.product)));
        json_object_set_new(j, "date", orr_json_text(date));
        if (f->wanted.station[0] != '\0') json_object_set_new(j, "station", orr_json_text(f->wanted.station));
        json_object_set_new(j, "status", orr_json_text(orr_status_name(f->status)));
        if (f->status == ORR_OK) {
            json_object_set_new(j, "path", orr_json_text(f->path));
            json_object_set_new(j, "name", orr_json_text(f->found.name));
            json_object_set_new(j, "centre", orr_json_text(f->found.centre));
            json_object_set_new(j, "tier", orr_json_text(orr_tier_name(f->found.tier)));
            json_object_set_new(j, "mirror", orr_json_text(f->found.mirror));
            json_object_set_new(j, "bytes", json_integer((json_int_t)f->bytes));
            json_object_set_new(j, "sha256", orr_json_text(f->sha256));
            json_object_set_new(j, "cached", json_boolean(f->from_cache));
        } else {
            json_object_set_new(j, "reason", orr_json_text(f->reason));
        }
        json_array_append_new(list, j);
    }
    return orr_json_print(c, list, JSON_INDENT(2));
}

static int print_archives(const orr_cli *c)
{
    size_t n;
    const char *text = orr_archives_builtin(&n);
    fwrite(text, 1, n, stdout);
    return orr_cli_flush(c);
}

static int32_t day_of(orr_time t)
{
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_GPS, NULL, &mjd, &fraction);
    return mjd;
}

// The file of certificates that the curl program would take.
static const char *ca_of_environment(void)
{
    static const char *const names[] = {"CURL_CA_BUNDLE", "SSL_CERT_FILE"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        const char *file = getenv(names[k]);
        if (file != NULL && *file != '\0') return file;
    }
    return NULL;
}

static int fetch_all(orr_cli *c, const orr_archives *a, orr_fetch_item *item, size_t n, const char *cache)
{
    orr_diag diag = {0};
    orr_fetch_options o = orr_fetch_default_options(cache);
    o.offline = orr_cli_given(c, "offline");
    o.parallel = (int)orr_cli_int(c, "parallel", o.parallel);
    o.attempts = (int)orr_cli_int(c, "attempts", o.attempts);
    o.backoff_s = (double)orr_cli_duration_ns(c, "backoff", (int64_t)(o.backoff_s * 1e9)) * 1e-9;
    o.stall_s = (double)orr_cli_duration_ns(c, "stall", (int64_t)(o.stall_s * 1e9)) * 1e-9;
    o.netrc = orr_cli_text(c, "netrc", NULL);
    o.ca_file = orr_cli_text(c, "ca-file", ca_of_environment());
    o.log = c->log;
    o.cancelled = cancelled;
    o.progress = progress;
    o.user = c;
    orr_cli_hold(c);
    orr_status s = orr_fetch(a, &o, item, n, &diag);
    orr_cli_progress(c, "", 1, 1);
    size_t good = 0, cached = 0;
    for (size_t i = 0; i < n; i++) {
        char what[64];
        if (item[i].status == ORR_OK) {
            good++;
            cached += item[i].from_cache;
        } else if (item[i].status != ORR_E_INTERRUPTED) {
            wanted_text(&item[i].wanted, what);
            orr_cli_failf(c, "%s: %s", what, item[i].reason);
        }
    }
    if (orr_cli_says(c, "format", "json")) {
        if (print_json(c, item, n) != ORR_EXIT_OK) return ORR_EXIT_FAILED;
    } else {
        for (size_t i = 0; i < n; i++)
            if (item[i].status == ORR_OK) puts(item[i].path);
    }
    orr_cli_say(c, "%zu of %zu files, %zu of them from the cache", good, n, cached);
    if (s != ORR_OK && s != ORR_E_NODATA && s != ORR_E_INTERRUPTED) orr_cli_fail(c, &diag);
    orr_cli_release(c);
    return s == ORR_OK ? ORR_EXIT_OK : ORR_EXIT_FAILED;
}

static int run(orr_cli *c)
{
    if (orr_cli_given(c, "print-archives")) return print_archives(c);
    if (c->n_operands != 1) return orr_cli_usage(c, "name the first day, for instance 2024-02-04");
    orr_diag diag = {0};
    orr_time from, to;
    if (orr_time_parse(c->operand[0], NULL, &from, &diag) != ORR_OK) return orr_cli_usage(c, "%s", diag.text);
    to = orr_cli_time(c, "to", from);
    int32_t first = day_of(from), last = day_of(to);
    if (last < first) return orr_cli_usage(c, "--to is before the first day");
    enum { MOST = 64 };
    wish w[MOST];
    int n_wishes = read_wishes(c, orr_cli_text(c, "products", "sp3,nav,ionex,erp"), w, MOST);
    if (n_wishes < 0) return ORR_EXIT_USAGE;
    size_t n = (size_t)(last - first + 1) * (size_t)n_wishes;
    if (n > MAX_FILES) return orr_cli_usage(c, "%zu files at once; %d are the most", n, MAX_FILES);
    const char *centre = orr_cli_text(c, "centre", "");
    if (strlen(centre) > 7) return orr_cli_usage(c, "--centre is a code of three letters");
    char cache[900];
    const char *named = orr_cli_text(c, "cache", NULL);
    if (named != NULL && strlen(named) >= sizeof cache) return orr_cli_usage(c, "--cache is too long");
    if (named != NULL)
        snprintf(cache, sizeof cache, "%s", named);
    else if (!orr_fetch_default_cache(cache, sizeof cache))
        return orr_cli_usage(c, "there is no home folder to keep the cache in: name one with --cache");
    orr_tier tier = ORR_TIER_FINAL;
    const char *tier_text = orr_cli_text(c, "tier", "final");
    orr_tier_parse(tier_text, strlen(tier_text), &tier);

    orr_archives *a;
    const char *table = orr_cli_text(c, "archives", getenv("ORRERY_ARCHIVES"));
    if (orr_archives_read(table != NULL && *table != '\0' ? table : NULL, &a, &diag) != ORR_OK)
        return orr_cli_fail(c, &diag);
    orr_fetch_item *item = calloc(n, sizeof *item);
    if (item == NULL) {
        orr_archives_free(a);
        return orr_cli_failf(c, "out of memory");
    }
    size_t k = 0;
    for (int32_t day = first; day <= last; day++)
        for (int i = 0; i < n_wishes; i++, k++) {
            item[k].wanted = (orr_wanted){.product = w[i].product, .mjd = day, .tier = tier};
            memcpy(item[k].wanted.station, w[i].station, sizeof w[i].station);
            snprintf(item[k].wanted.centre, sizeof item[k].wanted.centre, "%s", centre);
            for (char *p = item[k].wanted.centre; *p != '\0'; p++)
                if (*p >= 'a' && *p <= 'z') *p = (char)(*p - 32);
        }
    int status = fetch_all(c, a, item, n, cache);
    free(item);
    orr_archives_free(a);
    return status;
}

static const orr_option options[] = {
    {.name = "to", .kind = ORR_OPT_TIME, .value = "DATE", .help = "Last day; the first alone if not given."},
    {.name = "products",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .help = "Of sp3, nav, ionex, ion, erp, clk, bias, antex, sinex, obs:STATION, with commas (default "
             "sp3,nav,ionex,erp)."},
    {.name = "centre",
     .kind = ORR_OPT_TEXT,
     .value = "COD|IGS|GFZ|...",
     .help = "Analysis centre; any that has the file if not given. COM and WUM: CODE's and Wuhan's orbits of "
             "more "
             "systems."},
    {.name = "tier",
     .kind = ORR_OPT_CHOICE,
     .value = "final|rapid|ultra|predicted",
     .help = "Best tier to ask for; the ones below it are fallen back to (default final)."},
    {.name = "cache",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Where files are kept (default ORRERY_CACHE, else ~/.cache/orrery)."},
    {.name = "offline", .kind = ORR_OPT_FLAG, .help = "Use the cache alone."},
    {.name = "archives",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Your table of names and mirrors (default ORRERY_ARCHIVES, else the built-in one)."},
    {.name = "print-archives", .kind = ORR_OPT_FLAG, .help = "Print the built-in table, to be edited."},
    {.name = "parallel",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 32,
     .help = "Transfers at once (default 4)."},
    {.name = "attempts",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 100,
     .help = "Attempts at one mirror before the next is tried (default 3)."},
    {.name = "backoff",
     .kind = ORR_OPT_DURATION,
     .value = "T",
     .help = "Wait before a second attempt; doubled each time (default 2s)."},
    {.name = "stall",
     .kind = ORR_OPT_DURATION,
     .value = "T",
     .help = "Give a transfer up when nothing comes for so long (default 30s)."},
    {.name = "netrc",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Names and passwords for mirrors that ask for a login (default ~/.netrc)."},
    {.name = "ca-file",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Certificates (PEM) that vouch for https mirrors, as of a laboratory's own authority (default "
             "CURL_CA_BUNDLE or SSL_CERT_FILE, else the system's)."},
    ORR_OPTION_FORMAT_AS("text|json", "text",
                         .help = "Paths of the files, one a line (default), or what became of each as JSON."),
};

const orr_command orr_cmd_fetch = {
    .name = "fetch",
    .group = "Files",
    .summary = "fetch IGS products of some days into the cache",
    .operands = "DATE",
    .min_operands = 0,
    .max_operands = 1,
    .about = "Finds the products of each day by their names of either era, tries mirror after mirror and "
             "tier after tier, and says "
             "so when it falls back. A file counts as fetched when it could be read; broken transfers are "
             "resumed, also by the "
             "next call. The paths of the files are printed, one a line.\n\n"
             "CDDIS asks for a NASA Earthdata login: put a line \"machine urs.earthdata.nasa.gov login NAME "
             "password WORD\" into "
             "~/.netrc. Names and mirrors are a table that can be printed, edited and named with --archives.",
    .example = "orrery fetch 2024-02-04\n"
               "orrery fetch 2024-02-03 --to 2024-02-05 --products sp3,erp,clk --centre COD\n"
               "orrery fetch 2024-02-04 --products nav,obs:BOR1 --offline",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

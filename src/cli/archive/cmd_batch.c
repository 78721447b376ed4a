// SPDX-License-Identifier: GPL-3.0-or-later
// orrery batch: an archive of days from a folder of files.
#include <ctype.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/monotonic.h"
#include "core/parallel.h"
#include "src/archive/batch.h"
#include "src/archive/catalogue.h"
#include "src/archive/store.h"
#include "src/cli/archive/batch_fetch.h"
#include "src/cli/archive/batch_now.h"
#include "src/cli/archive/batch_plan.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

#define MOST_DAYS 40000 // more than a century

static const orr_option options[] = {
    {.name = "archive",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .required = true,
     .help = "The archive's folder; made if there is none. A day stands in DIR/yyyy/ddd."},
    {.name = "inputs",
     .applies = "!report",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Folder with the SP3 files, looked through with all folders below it: a file's day is told by "
             "its first lines."},
    {.name = "fetch",
     .applies = "!inputs,!report",
     .kind = ORR_OPT_FLAG,
     .help = "Fetch the days' files instead, with one day more at either end, into the cache of `orrery "
             "fetch`; --from and --to "
             "say which days."},
    {.name = "now",
     .applies = "!report,!plan,!chunk,!from,!to,!tec,!erp",
     .kind = ORR_OPT_FLAG,
     .help =
         "Make the day of the present, observed as far as the newest ultra-rapid orbits are and predicted "
         "from there to its end, "
         "and the next day too where it begins within 6 h. The files are those of the cache of `orrery "
         "fetch`, after --fetch has looked for newer ones, "
         "or of --inputs, a folder laid out like it. Run every hour, it makes days anew as newer files "
         "come."},
    {.name = "present",
     .applies = "now",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "The instant that --now takes for the present; the system's clock by default."},
    {.name = "centre",
     .applies = "fetch",
     .kind = ORR_OPT_TEXT,
     .value = "COD|IGS|GFZ|...",
     .help = "Analysis centre of what is fetched; any that has the file if not given."},
    {.name = "offline", .applies = "fetch", .kind = ORR_OPT_FLAG, .help = "Use the cache alone."},
    {.name = "name",
     .applies = "inputs",
     .kind = ORR_OPT_TEXT,
     .value = "PATTERN",
     .help = "Use only files whose names match, e.g. 'COD*': needed where a day has several."},
    ORR_OPTION_FROM(.help = "First day; that of the first file by default."),
    ORR_OPTION_TO(.help = "Last day; that of the last file by default."),
    ORR_OPTION_ERP(.repeated = true, .applies = "inputs",
                   .help = "File of Earth rotation parameters for all days; without one the orbits "
                           "themselves tell them."),
    {.name = "navdata",
     .applies = "inputs|fetch|now",
     .kind = ORR_OPT_FLAG,
     .help = "Also fit broadcast data to each day: broadcast.rnx."},
    {.name = "tec",
     .applies = "inputs|fetch",
     .kind = ORR_OPT_TEXT,
     .value = "PATTERN",
     .help = "Also make each day's TEC field, field.ION, of the maps (IONEX, .ION) whose names match, e.g. "
             "'COD*GIM*'."},
    {.name = "stations",
     .applies = "tec",
     .kind = ORR_OPT_TEXT,
     .value = "LIST",
     .help = "Also fuse the phases of these stations with it, by their observations among the inputs, e.g. "
             "BOR1,WTZR: "
             "session-BOR1.nc."},
    {.name = "jobs",
     .applies = "inputs|fetch|now",
     .letter = 'j',
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 256,
     .help = "Number of days that are made at once; the machine's cores by default. The archive does not "
             "depend on it."},
    {.name = "again",
     .applies = "inputs|fetch|now",
     .kind = ORR_OPT_FLAG,
     .help = "Make days anew that are there, made from the same."},
    {.name = "plan",
     .applies = "inputs|fetch",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .writes = true,
     .help = "Make nothing: write the days as independent chunks, one a line, for a cluster (--chunk)."},
    {.name = "chunks",
     .applies = "plan",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 100000,
     .help = "How many; 16 by default."},
    {.name = "chunk",
     .applies = "inputs|fetch,!plan,!from,!to",
     .kind = ORR_OPT_TEXT,
     .value = "FILE:N",
     .help = "Make chunk N, from 1, of a plan. Several chunks of one archive may be made at once, on any "
             "machines."},
    {.name = "report",
     .applies = "!inputs",
     .kind = ORR_OPT_FLAG,
     .help = "Make nothing: print how days join, and name those that look unusual beside the others."},
    ORR_OPTION_REPORT,
};

typedef struct talk {
    orr_cli *c;
    bool terminal;
    double begin_s;
} talk;

static bool stop(void *user) { return orr_cli_interrupted(((talk *)user)->c); }

// On a terminal one line that is redrawn, failures above it; elsewhere a line a day.
static void done(void *user, const orr_batch_day *d, size_t n_done, size_t n_days)
{
    const talk *t = user;
    char day[ORR_ARCHIVE_DAY_TEXT], why[900];
    orr_archive_day_text(d->mjd, day);
    if (d->outcome == ORR_BATCH_FAILED)
        fprintf(stderr, "%s%s: not made: %s\n", t->terminal ? "\r\033[K" : "", day,
                orr_diag_format(&d->failure, why, sizeof why));
    if (t->c->quiet) return;
    const double taken_s = orr_monotonic_s() - t->begin_s, rate = taken_s > 0 ? (double)n_done / taken_s : 0;
    if (t->terminal)
        fprintf(stderr, "\r\033[K%zu of %zu days, %.1f a second, %.0f s left", n_done, n_days, rate,
                rate > 0 ? (double)(n_days - n_done) / rate : 0);
    else if (d->outcome != ORR_BATCH_FAILED)
        fprintf(stderr, "%s: %s (%zu of %zu)\n", day, d->outcome == ORR_BATCH_MADE ? "made" : "is there",
                n_done, n_days);
    if (t->terminal && n_done == n_days) fputs("\r\033[K", stderr);
}

static int print_json(const orr_cli *c, const orr_batch_report *r, double seconds)
{
    static const char *const WORDS[] = {"made", "fresh", "failed"};
    json_t *days = json_array();
    for (size_t i = 0; i < r->n; i++) {
        const orr_batch_day *d = &r->day[i];
        char day[ORR_ARCHIVE_DAY_TEXT], why[900];
        json_array_append_new(
            days,
            json_pack("{s:s, s:s, s:o, s:o}", "day", orr_archive_day_text(d->mjd, day), "outcome",
                      WORDS[d->outcome], "seconds",
                      d->outcome == ORR_BATCH_FRESH ? json_null() : orr_json_number(d->seconds), "failure",
                      d->outcome == ORR_BATCH_FAILED
                          ? orr_json_text(orr_diag_format(&d->failure, why, sizeof why))
                          : json_null()));
    }
    json_t *j = json_pack("{s:o, s:o, s:o, s:o, s:o}", "made", orr_json_count(r->made), "fresh",
                          orr_json_count(r->fresh), "failed", orr_json_count(r->failed), "seconds",
                          orr_json_number(seconds), "days", days);
    return orr_json_print(c, j, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
}

static int say_end(const orr_cli *c, const orr_batch_report *r, double seconds)
{
    if (orr_cli_says(c, "format", "json")) {
        const int status = print_json(c, r, seconds);
        if (status != ORR_EXIT_OK) return status;
    }
    orr_cli_say(c, "%zu days made, %zu were there, %zu not made, in %.1f s", r->made, r->fresh, r->failed,
                seconds);
    return r->failed > 0 ? ORR_EXIT_FAILED : ORR_EXIT_OK;
}

// First and last day that are wanted: as asked for, or of the files.
static int days_of(const orr_cli *c, const orr_archive_index *x, orr_batch *b)
{
    if (x->n == 0 && orr_cli_given(c, "fetch"))
        return orr_cli_failf(c, "no orbits of these days could be fetched");
    if (x->n == 0)
        return orr_cli_failf(c, "%s has no SP3 file of a single day%s", orr_cli_text(c, "inputs", ""),
                             orr_cli_given(c, "name") ? " whose name matches" : "");
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
    b->first = orr_cli_given(c, "from") ? orr_archive_day_of(orr_cli_time(c, "from", 0)) : x->item[0].mjd;
    b->last = orr_cli_given(c, "to") ? orr_archive_day_of(orr_cli_time(c, "to", 0)) : x->item[x->n - 1].mjd;
    if (b->last < b->first) return orr_cli_usage(c, "there is no file from the first day on");
    if (b->last - b->first >= MOST_DAYS) return orr_cli_usage(c, "a batch has at most %d days", MOST_DAYS);
    return ORR_EXIT_OK;
}

static int run_batch(orr_cli *c, const orr_batch *b, orr_archive_index *x, bool alone)
{
    orr_diag diag = {0};
    orr_batch_report report = {0};
    int lock = -1;
    orr_status s = orr_archive_open(b->settings.archive, &diag);
    if (s == ORR_OK && alone) s = orr_archive_lock(b->settings.archive, &lock, &diag);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    s = orr_archive_strays(b->settings.archive, true, NULL, NULL, &diag);
    talk t = {.c = c, .terminal = isatty(STDERR_FILENO) != 0, .begin_s = orr_monotonic_s()};
    orr_batch mine = *b;
    mine.done = done;
    mine.stop = stop;
    mine.user = &t;
    orr_cli_hold(c);
    if (s == ORR_OK) s = orr_batch_run(&mine, x, &report, &diag);
    int status = ORR_EXIT_FAILED;
    if (s == ORR_E_INTERRUPTED && t.terminal) fputc('\n', stderr);
    if (s == ORR_OK)
        status = say_end(c, &report, orr_monotonic_s() - t.begin_s);
    else
        status = orr_cli_fail(c, &diag);
    orr_batch_report_free(&report);
    if (lock >= 0) close(lock);
    orr_cli_release(c);
    return status;
}

// Names that commas divide, in upper case, into text and list; how many, 0 where one is no name or there are too many.
static size_t read_stations(const char *names, char *text, size_t size, const char **list)
{
    size_t n = 0;
    if (strlen(names) >= size) return 0;
    for (char *at = text; *names != '\0'; names++) {
        if (at == text || at[-1] == '\0') {
            if (n == ORR_ARCHIVE_MAX_STATIONS) return 0;
            list[n++] = at;
        }
        if (*names == ',' && (at == text || at[-1] == '\0')) return 0;
        if (*names != ',' && !isalnum((unsigned char)*names)) return 0;
        *at++ = *names == ',' ? '\0' : (char)toupper((unsigned char)*names);
        *at = '\0';
    }
    return n;
}

static int run_inputs(orr_cli *c)
{
    char text[ORR_ARCHIVE_MAX_STATIONS * 10] = "";
    const char *station[ORR_ARCHIVE_MAX_STATIONS];
    const char *names = orr_cli_text(c, "stations", NULL);
    const size_t n_stations = names != NULL ? read_stations(names, text, sizeof text, station) : 0;
    if (names != NULL && n_stations == 0)
        return orr_cli_usage(c, "--stations \"%s\" is no list of at most %d names that commas divide", names,
                             ORR_ARCHIVE_MAX_STATIONS);
    orr_archive_index x = {0};
    orr_warnings warnings = {0};
    orr_diag diag = {0};
    orr_batch b = {.settings = {.archive = orr_cli_text(c, "archive", NULL),
                                .leap = c->leap,
                                .extras = {.navdata = orr_cli_given(c, "navdata"),
                                           .wants = {.maps = orr_cli_text(c, "tec", NULL),
                                                     .station = station,
                                                     .n_stations = n_stations}}},
                   .jobs = (int)orr_cli_int(c, "jobs", orr_parallel_cores()),
                   .again = orr_cli_given(c, "again")};
    const bool fetches = orr_cli_given(c, "fetch");
    orr_status s = ORR_OK;
    if (fetches) {
        const int32_t first = orr_archive_day_of(orr_cli_time(c, "from", 0)),
                      last = orr_archive_day_of(orr_cli_time(c, "to", 0));
        if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
        if (last - first >= MOST_DAYS) return orr_cli_usage(c, "a batch has at most %d days", MOST_DAYS);
        const int fetched = batch_fetch(c, &b.settings.extras.wants, first, last, &x);
        if (fetched != ORR_EXIT_OK) {
            orr_archive_index_free(&x);
            return fetched;
        }
    } else {
        s = orr_archive_index_make(orr_cli_text(c, "inputs", NULL), orr_cli_text(c, "name", NULL),
                                   &b.settings.extras.wants, c->leap, &x, &warnings, &diag);
    }
    for (size_t i = 0; s == ORR_OK && i < orr_cli_count(c, "erp"); i++)
        s = orr_archive_index_add_erp(&x, orr_cli_text_at(c, "erp", i), &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    const bool chunk = orr_cli_given(c, "chunk");
    int status = s != ORR_OK ? orr_cli_fail(c, &diag) : days_of(c, &x, &b);
    if (status == ORR_EXIT_OK && chunk)
        status = batch_plan_read(c, orr_cli_text(c, "chunk", ""), &b.first, &b.last);
    if (status == ORR_EXIT_OK && orr_cli_given(c, "plan"))
        status = batch_plan_write(c, b.first, b.last, (size_t)orr_cli_int(c, "chunks", 16));
    else if (status == ORR_EXIT_OK)
        status = run_batch(c, &b, &x, !chunk);
    orr_archive_index_free(&x);
    return status;
}

static int print_report(orr_cli *c)
{
    orr_catalogue k = {0};
    orr_warnings warnings = {0};
    orr_diag diag = {0};
    const orr_time from = orr_cli_time(c, "from", INT64_MIN), to = orr_cli_time(c, "to", INT64_MAX);
    const orr_status s = orr_catalogue_make(orr_cli_text(c, "archive", NULL), true, &k, &warnings, &diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    if (s != ORR_OK) return orr_cli_fail(c, &diag);
    size_t days = 0, joints = 0, unusual = 0, above = 0;
    double worst = 0;
    json_t *list = json_array();
    for (size_t i = 0; i < k.n; i++) {
        const orr_catalogue_day *d = &k.day[i];
        char day[ORR_ARCHIVE_DAY_TEXT], sat[ORR_SAT_TEXT];
        const orr_time begin = orr_archive_day_begin(d->mjd);
        if (begin + INT64_C(86400) * ORR_NS_PER_S <= from || begin > to) continue;
        days++;
        joints += d->joint.satellites > 0;
        above += d->joint.max_mm > 0.1;
        if (d->joint.max_mm > worst) worst = d->joint.max_mm;
        const bool bad = d->state != ORR_OK;
        if (bad || d->suspicion[0] != '\0') unusual++;
        if (!orr_cli_says(c, "format", "json")) {
            if (bad)
                printf("%s: its record cannot be read (%s)\n", orr_archive_day_text(d->mjd, day),
                       orr_status_name(d->state));
            if (d->suspicion[0] != '\0') printf("%s: %s\n", orr_archive_day_text(d->mjd, day), d->suspicion);
            continue;
        }
        json_array_append_new(
            list,
            json_pack("{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o}", "day", orr_archive_day_text(d->mjd, day),
                      "state", orr_catalogue_state(d), "joint_median_mm", orr_json_number(d->joint.median_mm),
                      "joint_max_mm", orr_json_number(d->joint.max_mm), "joint_max_mps",
                      orr_json_number(d->joint.max_mps), "joint_max_sat",
                      d->joint.satellites > 0 ? orr_json_text(orr_sat_text(d->joint.max_sat, sat))
                                              : json_null(),
                      "residual_mm", orr_json_number(d->all.residual_mm), "suspicion",
                      d->suspicion[0] != '\0' ? orr_json_text(d->suspicion) : json_null()));
    }
    orr_catalogue_free(&k);
    if (orr_cli_says(c, "format", "json"))
        return orr_json_print(c, json_pack("{s:o, s:o}", "unusual", orr_json_count(unusual), "days", list),
                              JSON_INDENT(1) | JSON_REAL_PRECISION(6));
    json_decref(list);
    printf("%zu days, %zu joints: %zu above 0.1 mm, the largest %.3f mm; %zu days look unusual\n", days,
           joints, above, worst, unusual);
    return ORR_EXIT_OK;
}

static int run(orr_cli *c)
{
    if (orr_cli_given(c, "report")) return print_report(c);
    if (orr_cli_given(c, "now")) return batch_now(c);
    const bool fetches = orr_cli_given(c, "fetch");
    if (!orr_cli_given(c, "inputs") && !fetches)
        return orr_cli_usage(c, "--inputs DIR is needed, or --fetch, --now or --report");
    if (fetches && (!orr_cli_given(c, "from") || !orr_cli_given(c, "to")))
        return orr_cli_usage(c, "--fetch needs --from and --to");
    return run_inputs(c);
}

const orr_command orr_cmd_batch = {
    .name = "batch",
    .group = "Archive",
    .summary = "make an archive of days from a folder of SP3 files",
    .about =
        "Each day is smoothed together with some hours of the days before and after, and cut to itself, so "
        "that days join "
        "although each is made on its own. A day that is there, made by the same program from the same files "
        "with the same "
        "options, is left as it is; so a batch that was stopped, by a signal or by a failing machine, goes "
        "on where it was when "
        "it is run again, and finished days are never half there. The archive does not depend on --jobs, nor "
        "on where it was "
        "stopped.\n\n"
        "A day that fails is told with its reason, and the others are made all the same; the exit status is "
        "1 then. A day "
        "whose neighbour is missing ends as its file does; it is made again when the neighbour has come.\n\n"
        "--plan divides the days among the tasks of a cluster: 'orrery batch ... --chunk plan.txt:7' makes "
        "the seventh part. "
        "Tasks need no lock: each works on its own days, and a task that is repeated makes the same bytes.",
    .example = "orrery batch --archive archive --inputs cache --name 'COD0OPSFIN*' --from 2020-01-01 --to "
               "2020-12-31\n"
               "orrery batch --archive archive --report\n"
               "orrery batch --archive archive --now --fetch",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

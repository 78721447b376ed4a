// SPDX-License-Identifier: GPL-3.0-or-later
// orrery archive: what an archive holds, and whether it is whole.
#include <jansson.h>
#include <stdio.h>
#include <string.h>

#include "src/archive/catalogue.h"
#include "src/archive/store.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

static const orr_option options[] = {
    ORR_OPTION_FROM(.help = "First day; the archive's first by default."),
    ORR_OPTION_TO(.help = "Last day; the archive's last by default."),
    ORR_OPTION_FORMAT("text|csv|json", "text"),
};

static bool within(const orr_cli *c, int32_t mjd)
{
    return mjd >= orr_archive_day_of(orr_cli_time(c, "from", 0)) * orr_cli_given(c, "from") &&
           (!orr_cli_given(c, "to") || mjd <= orr_archive_day_of(orr_cli_time(c, "to", 0)));
}

static json_t *day_json(const orr_catalogue_day *d)
{
    char day[ORR_ARCHIVE_DAY_TEXT];
    return json_pack("{s:s, s:s, s:s, s:b, s:b, s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "day",
                     orr_archive_day_text(d->mjd, day), "state", orr_catalogue_state(d), "program",
                     d->program, "day_before", d->before, "day_after", d->after, "bytes",
                     (json_int_t)d->bytes, "satellites", orr_json_count(d->all.satellites), "nodes",
                     orr_json_count(d->all.nodes), "left_out", orr_json_count(d->all.left_out), "manoeuvres",
                     orr_json_count(d->all.manoeuvres), "gaps", orr_json_count(d->all.gaps), "residual_mm",
                     orr_json_number(d->all.residual_mm), "sigma_mm", orr_json_number(d->all.sigma_mm),
                     "notes", orr_json_count(d->n_notes));
}

static int list(const orr_cli *c, const orr_catalogue *k)
{
    const bool json = orr_cli_says(c, "format", "json"), csv = orr_cli_says(c, "format", "csv");
    json_t *all = json_array();
    if (csv)
        puts("day,state,satellites,nodes,left_out,manoeuvres,gaps,residual_mm,sigma_mm,day_before,day_after,"
             "bytes,notes,program");
    else if (!json)
        puts("day       state         sats   nodes  out  man  gaps  residual   sigma  neighbours  notes");
    for (size_t i = 0; i < k->n; i++) {
        const orr_catalogue_day *d = &k->day[i];
        char day[ORR_ARCHIVE_DAY_TEXT];
        if (!within(c, d->mjd)) continue;
        orr_archive_day_text(d->mjd, day);
        const char *state = orr_catalogue_state(d);
        if (json)
            json_array_append_new(all, day_json(d));
        else if (csv)
            printf("%s,%s,%zu,%zu,%zu,%zu,%zu,%.4f,%.4f,%d,%d,%lld,%zu,%s\n", day, state, d->all.satellites,
                   d->all.nodes, d->all.left_out, d->all.manoeuvres, d->all.gaps, d->all.residual_mm,
                   d->all.sigma_mm, d->before, d->after, (long long)d->bytes, d->n_notes, d->program);
        else if (d->state != ORR_OK)
            printf("%s  %s\n", day, state);
        else
            printf("%s  %-12s  %4zu  %6zu  %3zu  %3zu  %4zu  %5.2f mm  %5.2f mm  %-10s  %5zu\n", day, state,
                   d->all.satellites, d->all.nodes, d->all.left_out, d->all.manoeuvres, d->all.gaps,
                   d->all.residual_mm, d->all.sigma_mm,
                   d->before && d->after ? "both"
                   : d->before           ? "before"
                   : d->after            ? "after"
                                         : "none",
                   d->n_notes);
    }
    if (json) return orr_json_print(c, all, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
    json_decref(all);
    return ORR_EXIT_OK;
}

static int verify(const orr_cli *c, const char *archive, const orr_catalogue *k)
{
    size_t good = 0, bad = 0;
    json_t *all = json_array();
    const bool json = orr_cli_says(c, "format", "json"), csv = orr_cli_says(c, "format", "csv");
    if (csv) puts("day,state,reason");
    for (size_t i = 0; i < k->n; i++) {
        char day[ORR_ARCHIVE_DAY_TEXT], why[900];
        orr_diag diag = {0};
        if (!within(c, k->day[i].mjd)) continue;
        const orr_status s = orr_catalogue_verify(archive, k->day[i].mjd, &diag);
        orr_archive_day_text(k->day[i].mjd, day);
        good += s == ORR_OK;
        bad += s != ORR_OK;
        orr_diag_format(&diag, why, sizeof why);
        if (json)
            json_array_append_new(all, json_pack("{s:s, s:b, s:o}", "day", day, "good", s == ORR_OK, "reason",
                                                 s == ORR_OK ? json_null() : orr_json_text(why)));
        else if (csv)
            printf("%s,%s,\"%s\"\n", day, s == ORR_OK ? "ok" : "damaged", s == ORR_OK ? "" : why);
        else if (s != ORR_OK)
            printf("%s: %s\n", day, why);
    }
    if (json) {
        const int status = orr_json_print(c, all, JSON_INDENT(1));
        if (status != ORR_EXIT_OK) return status;
    } else
        json_decref(all);
    orr_cli_say(c, "%zu days are as they were made, %zu are not", good, bad);
    return bad > 0 ? ORR_EXIT_FAILED : ORR_EXIT_OK;
}

static void tell_stray(void *user, const char *path, bool leftover)
{
    (void)user;
    printf("%s: %s\n", path,
           leftover ? "left by a batch that ended; removed" : "is nothing that an archive has; left alone");
}

static int stats(const orr_cli *c, const orr_catalogue *k)
{
    size_t days = 0, damaged = 0, missing = 0, alone = 0, nodes = 0;
    int64_t bytes = 0;
    int32_t first = 0, last = 0;
    for (size_t i = 0; i < k->n; i++) {
        const orr_catalogue_day *d = &k->day[i];
        if (!within(c, d->mjd)) continue;
        if (days == 0) first = d->mjd;
        if (days > 0) missing += (size_t)(d->mjd - last - 1);
        last = d->mjd;
        days++;
        damaged += d->state != ORR_OK;
        alone += d->state == ORR_OK && (!d->before || !d->after);
        nodes += d->all.nodes;
        bytes += d->bytes;
    }
    char from[ORR_ARCHIVE_DAY_TEXT] = "", to[ORR_ARCHIVE_DAY_TEXT] = "";
    if (days > 0) orr_archive_day_text(first, from), orr_archive_day_text(last, to);
    if (orr_cli_says(c, "format", "json"))
        return orr_json_print(
            c,
            json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:I}", "days", orr_json_count(days), "first",
                      days > 0 ? json_string(from) : json_null(), "last",
                      days > 0 ? json_string(to) : json_null(), "missing", orr_json_count(missing),
                      "unreadable", orr_json_count(damaged), "without_a_neighbour", orr_json_count(alone),
                      "nodes", orr_json_count(nodes), "bytes", (json_int_t)bytes),
            JSON_INDENT(1));
    if (orr_cli_says(c, "format", "csv")) {
        puts("days,first,last,missing,unreadable,without_a_neighbour,nodes,bytes");
        printf("%zu,%s,%s,%zu,%zu,%zu,%zu,%lld\n", days, from, to, missing, damaged, alone, nodes,
               (long long)bytes);
        return ORR_EXIT_OK;
    }
    if (days == 0) {
        puts("no days");
        return ORR_EXIT_OK;
    }
    printf("days          %zu, %s to %s; %zu missing between, %zu unreadable, %zu without a neighbour\n",
           days, from, to, missing, damaged, alone);
    printf("nodes         %zu\nsize          %.1f MB, %.2f MB a day\n", nodes, 1e-6 * (double)bytes,
           1e-6 * (double)bytes / (double)days);
    return ORR_EXIT_OK;
}

// What was told stands, but where records could not be read at this moment it is not all.
static int all_read(orr_cli *c, const orr_catalogue *k, int status)
{
    orr_diag diag;
    size_t lost = 0;
    for (size_t i = 0; i < k->n; i++) lost += k->day[i].state == ORR_E_IO || k->day[i].state == ORR_E_MEMORY;
    if (lost == 0 || status != ORR_EXIT_OK) return status;
    orr_diag_set(&diag, ORR_E_IO, "the records of %zu of %zu days cannot be read", lost, k->n);
    return orr_cli_fail(c, &diag);
}

static int run(orr_cli *c)
{
    static const char *const TASKS[] = {"ls", "verify", "gc", "stats"};
    const char *task = c->operand[0], *archive = c->operand[1];
    size_t which = 0;
    while (which < 4 && strcmp(task, TASKS[which]) != 0) which++;
    if (which == 4) return orr_cli_usage(c, "'%s' is none of ls, verify, gc and stats", task);
    orr_diag diag = {0};
    if (which == 2) {
        int lock;
        orr_status s = orr_archive_lock(archive, &lock, &diag);
        if (s == ORR_OK) s = orr_archive_strays(archive, true, tell_stray, NULL, &diag);
        return s == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
    }
    orr_catalogue k = {0};
    int status = ORR_EXIT_FAILED;
    if (orr_catalogue_make(archive, false, &k, NULL, &diag) != ORR_OK)
        status = orr_cli_fail(c, &diag);
    else
        status = all_read(c, &k,
                          which == 0   ? list(c, &k)
                          : which == 1 ? verify(c, archive, &k)
                                       : stats(c, &k));
    orr_catalogue_free(&k);
    return status;
}

const orr_command orr_cmd_archive = {
    .name = "archive",
    .group = "Archive",
    .summary = "list, verify and tidy an archive of days",
    .operands = "ls|verify|gc|stats DIR",
    .min_operands = 2,
    .max_operands = 2,
    .about = "ls lists the days with what their records say. verify reads every byte of every product and "
             "compares it with what was "
             "written; the exit status is 1 where a day is not as it was made. gc removes what batches that "
             "were killed have "
             "left, and names files that no archive has. stats sums up.\n\n"
             "An archive is its days, DIR/yyyy/ddd with day.json and the products. DIR/catalogue.sqlite "
             "holds the same as tables "
             "for queries (after 'orrery batch --report'); it can be deleted at any time.",
    .example = "orrery archive ls archive --from 2020-01-01\n"
               "orrery archive verify archive",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

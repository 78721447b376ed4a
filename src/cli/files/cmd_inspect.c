// SPDX-License-Identifier: GPL-3.0-or-later
// orrery inspect: what a file is and what is in it.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ingest/inspect/inspect.h"
#include "src/cli/files/inspect_own.h"
#include "src/cli/frame/cli.h"
#include "src/cli/frame/json.h"
#include "src/cli/frame/options.h"

static json_t *json_count(int64_t n) { return n == ORR_INSPECT_NONE ? json_null() : json_integer(n); }

static int print_json(const orr_cli *c, const char *path, const orr_inspection *r)
{
    char text[1024];
    json_t *systems = json_array(), *warnings = json_array(), *facts = json_object(), *j = json_object();
    for (const char *s = r->systems; *s != '\0'; s++) json_array_append_new(systems, json_stringn(s, 1));
    for (size_t i = 0; i < r->warnings.kept; i++)
        json_array_append_new(warnings,
                              orr_json_text(orr_diag_format(&r->warnings.item[i], text, sizeof text)));
    for (size_t i = 0; i < r->n_facts; i++) {
        // A fact without a label goes on with the one before.
        snprintf(text, sizeof text, "%s", r->fact[i].text);
        size_t first = i;
        while (i + 1 < r->n_facts && r->fact[i + 1].label[0] == '\0') {
            size_t n = strlen(text);
            snprintf(text + n, sizeof text - n, "\n%s", r->fact[++i].text);
        }
        json_object_set_new(facts, r->fact[first].label, orr_json_text(text));
    }
    json_object_set_new(j, "file", orr_json_text(path));
    json_object_set_new(j, "kind", json_string(orr_kind_token(r->kind)));
    json_object_set_new(j, "version", r->version[0] != '\0' ? orr_json_text(r->version) : json_null());
    json_object_set_new(j, "from", orr_json_time(r->from));
    json_object_set_new(j, "to", orr_json_time(r->to));
    json_object_set_new(j, "interval_s", orr_json_number(r->interval_s));
    json_object_set_new(j, "systems", systems);
    json_object_set_new(j, "satellites", json_count(r->satellites));
    json_object_set_new(j, "epochs", json_count(r->epochs));
    json_object_set_new(j, "records", json_count(r->records));
    json_object_set_new(j, "gaps", json_count(r->gaps));
    json_object_set_new(j, "warnings", warnings);
    json_object_set_new(j, "warning_count", orr_json_count(r->warnings.count));
    json_object_set_new(j, "facts", facts);
    return orr_json_print(c, j, JSON_INDENT(2));
}

static void print_row(const char *label, const char *text) { printf("  %-12s %s\n", label, text); }

static void print_satellites(const orr_inspection *r)
{
    char text[512];
    int n = snprintf(text, sizeof text, "%lld:", (long long)r->satellites);
    for (const char *s = r->systems; *s != '\0'; s++) {
        int count = 0;
        for (int number = 1; number <= 99; number++)
            if (orr_sat_set_has(&r->seen, orr_sat_make(*s, number))) count++;
        if (count > 0)
            n += snprintf(text + n, sizeof text - (size_t)n, "%s %d %s", text[n - 1] == ':' ? "" : ",", count,
                          orr_system_name(*s));
    }
    print_row("satellites", text);
}

static void print_systems(const orr_inspection *r)
{
    char text[128];
    int n = 0;
    for (const char *s = r->systems; *s != '\0'; s++)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%s", n > 0 ? ", " : "", orr_system_name(*s));
    print_row("systems", text);
}

static void print_human(const char *path, const orr_inspection *r)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT], text[256];
    printf("%s\n", path);
    print_row("kind", orr_kind_name(r->kind));
    if (r->version[0] != '\0') print_row("version", r->version);
    if (r->from != ORR_TIME_NONE) {
        snprintf(text, sizeof text, "%s to %s (GPS time)", orr_time_text(r->from, from),
                 r->to != ORR_TIME_NONE ? orr_time_text(r->to, to) : "?");
        print_row("span", text);
    }
    if (r->epochs != ORR_INSPECT_NONE) {
        int n = snprintf(text, sizeof text, "%lld", (long long)r->epochs);
        if (isfinite(r->interval_s))
            n += snprintf(text + n, sizeof text - (size_t)n, ", every %g s", r->interval_s);
        if (r->gaps == 0) snprintf(text + n, sizeof text - (size_t)n, ", no gaps");
        if (r->gaps > 0)
            snprintf(text + n, sizeof text - (size_t)n, ", %lld gap%s", (long long)r->gaps,
                     r->gaps == 1 ? "" : "s");
        print_row("epochs", text);
    }
    if (r->records != ORR_INSPECT_NONE) {
        snprintf(text, sizeof text, "%lld", (long long)r->records);
        print_row("records", text);
    }
    if (r->satellites != ORR_INSPECT_NONE)
        print_satellites(r);
    else if (r->systems[0] != '\0')
        print_systems(r);
    for (size_t i = 0; i < r->n_facts; i++) print_row(r->fact[i].label, r->fact[i].text);
    if (r->warnings.count > 0) {
        snprintf(text, sizeof text, "%zu (on stderr)", r->warnings.count);
        print_row("warnings", text);
    }
}

static int inspect_one(const orr_cli *c, const char *path)
{
    orr_inspection r;
    orr_diag diag = {0};
    int status = ORR_EXIT_OK;
    orr_status st = orr_inspect(path, c->leap, &r, &diag);
    if (st == ORR_E_UNSUPPORTED && r.kind == ORR_KIND_NETCDF) {
        diag = (orr_diag){0};
        st = orr_inspect_own(path, &r, &diag);
    }
    if (st != ORR_OK) {
        orr_cli_warnings(c, &r.warnings);
        status = orr_cli_fail(c, &diag);
    } else if (orr_cli_says(c, "format", "json")) {
        status = print_json(c, path, &r);
    } else {
        print_human(path, &r);
        orr_cli_warnings(c, &r.warnings);
    }
    orr_inspection_free(&r);
    return status;
}

static int run(orr_cli *c)
{
    int status = ORR_EXIT_OK;
    for (int i = 0; i < c->n_operands; i++) {
        if (i > 0 && !orr_cli_says(c, "format", "json")) putchar('\n');
        int s = inspect_one(c, c->operand[i]);
        if (s != ORR_EXIT_OK) status = s;
    }
    return status;
}

static const orr_option options[] = {
    ORR_OPTION_FORMAT_AS("text|json", "text", .help = "Text (default), or a JSON object for each file."),
};

const orr_command orr_cmd_inspect = {
    .name = "inspect",
    .group = "Files",
    .summary = "tell what a file is and what is in it",
    .operands = "FILE...",
    .min_operands = 1,
    .max_operands = -1,
    .about =
        "The kind is found from the content, not from the name; compressed files (gzip, .Z, Hatanaka) are "
        "opened as they are. Instants are GPS time. What a reader had to put up with is listed as warnings; "
        "a "
        "file that cannot be used at all is refused with the place and the reason, and the exit status is "
        "1.\n\n"
        "JSON keys: kind, version, from, to, interval_s, systems, satellites, epochs, records, gaps, "
        "warnings "
        "(the first of them), warning_count, facts. null stands for what the kind of file does not have.",
    .example = "orrery inspect COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz\n"
               "orrery inspect --format json brdc1820.10n.gz",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

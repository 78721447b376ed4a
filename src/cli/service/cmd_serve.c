// SPDX-License-Identifier: GPL-3.0-or-later
// orrery serve: a scenario, or an orbit product alone, answered by time over sockets.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "src/cli/frame/cli.h"
#include "src/service/answers.h"
#include "src/service/service.h"

// NetCDF by its first bytes: HDF5 (NetCDF-4) or classic. A scenario is text.
static orr_status is_product(const char *path, bool *yes, orr_diag *diag)
{
    char head[8] = {0};
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    size_t n = fread(head, 1, sizeof head, f);
    bool bad = ferror(f) != 0;
    fclose(f);
    if (bad) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read: %s", strerror(errno));
    *yes = n == sizeof head && (memcmp(head, "\x89HDF\r\n\x1a\n", 8) == 0 || memcmp(head, "CDF", 3) == 0);
    return ORR_OK;
}

// What is told once the service can be reached; scripts wait for this line, so --quiet does not silence it.
static void say_ready(const orr_engine *e, const orr_service *s)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    const orr_sat *sats;
    orr_time t0, t1;
    orr_engine_span(e, &t0, &t1);
    fputs("orrery serve: ready on", stderr);
    for (size_t i = 0; orr_service_url(s, i) != NULL; i++) fprintf(stderr, " %s", orr_service_url(s, i));
    size_t n = orr_engine_satellites(e, &sats), units = orr_engine_units(e);
    if (n > 0)
        fprintf(stderr, " (%zu satellites, ", n);
    else
        fprintf(stderr, " (%zu inertial unit%s, ", units, units == 1 ? "" : "s");
    fprintf(stderr, "%s to %s)\n", orr_time_text(t0, from), orr_time_text(t1, to));
}

static int serve(orr_cli *c, const orr_engine *e, const orr_text_list *listen)
{
    orr_diag diag = {0};
    orr_answers *answers;
    if (orr_answers_open(e, &answers, &diag) != ORR_OK) return orr_cli_fail(c, &diag);
    orr_service_options options = orr_service_defaults();
    size_t n = orr_cli_count(c, "listen");
    const char **url = calloc(n > 0 ? n : 1, sizeof *url);
    if (url == NULL) {
        orr_answers_close(answers);
        return orr_cli_failf(c, "out of memory");
    }
    for (size_t i = 0; i < n; i++) url[i] = orr_cli_text_at(c, "listen", i);
    options.url = n > 0 ? url : (const char *const *)listen->item;
    options.n_urls = n > 0 ? n : listen->n;
    options.max_clients = (int)orr_cli_int(c, "max-clients", options.max_clients);
    orr_service *service = NULL;
    orr_status s = orr_service_open(&options, orr_answers_server(answers), c->log, &service, &diag);
    if (s == ORR_OK) {
        say_ready(e, service);
        s = orr_service_run(service, &diag);
        if (s == ORR_OK) orr_cli_say(c, "stopped");
    }
    orr_service_close(service);
    orr_answers_close(answers);
    free(url);
    return s == ORR_OK      ? ORR_EXIT_OK
           : s == ORR_E_ARG ? orr_cli_usage(c, "%s", diag.text)
                            : orr_cli_fail(c, &diag);
}

static orr_status prepare(orr_cli *c, const char *path, orr_scenario *scenario, orr_engine **e,
                          orr_diag *diag)
{
    bool product = false;
    orr_status s = is_product(path, &product, diag);
    if (s != ORR_OK) return s;
    s = product ? orr_scenario_of_product(path, scenario, diag) : orr_scenario_read(path, scenario, diag);
    if (s != ORR_OK) return s;
    if (scenario->orbit.sp3.n > 0)
        orr_cli_say(c, "smoothing %zu file%s", scenario->orbit.sp3.n, scenario->orbit.sp3.n == 1 ? "" : "s");
    orr_warnings warnings = {0};
    s = orr_engine_open(scenario, c->log, NULL, &warnings, e, diag);
    orr_cli_warnings(c, &warnings);
    orr_warnings_free(&warnings);
    return s;
}

static int run(orr_cli *c)
{
    if (orr_cli_given(c, "help-scenario")) {
        orr_schema_describe(orr_scenario_schema(), stdout);
        return ORR_EXIT_OK;
    }
    if (c->n_operands != 1) return orr_cli_usage(c, "a scenario or an orbit product is wanted");
    orr_scenario scenario = {0};
    orr_engine *e = NULL;
    orr_diag diag = {0};
    int status;
    if (prepare(c, c->operand[0], &scenario, &e, &diag) != ORR_OK)
        status = orr_cli_fail(c, &diag);
    else
        status = serve(c, e, &scenario.serve.listen);
    orr_engine_close(e);
    orr_scenario_free(&scenario);
    return status;
}

static const orr_option options[] = {
    {.name = "listen",
     .letter = 'l',
     .kind = ORR_OPT_TEXT,
     .value = "URL",
     .repeated = true,
     .help = "Listen at tcp://HOST:PORT (port 0: any free one) or unix:PATH. By default where the scenario "
             "says, else tcp://127.0.0.1:15754."},
    {.name = "max-clients",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 10000,
     .help = "Largest number of clients at once; one more is answered BUSY. 256 by default."},
    {.name = "help-scenario", .kind = ORR_OPT_FLAG, .help = "Print all keys of a scenario file, and end."},
};

const orr_command orr_cmd_serve = {
    .name = "serve",
    .group = "Service",
    .summary = "answer polls for satellite states and more over TCP or a Unix socket",
    .operands = "SCENARIO.yaml|PRODUCT.nc",
    .min_operands = 0,
    .max_operands = 1,
    .about =
        "Prepares the scenario (smoothing SP3 files and fitting broadcast data to them take about a second a "
        "day), then says 'ready on URL' on stderr "
        "and answers "
        "until SIGTERM or SIGINT (status 0; a signal before that line ends it at once, as any program). "
        "Polls are answered by their time tag: the same poll gets the same "
        "bytes, from any "
        "client, any number of times.\n\n"
        "Listens on this machine alone unless told otherwise; there is no authentication. "
        "docs/protocol.md describes "
        "the messages, docs/scenario.md the file.",
    .example = "orrery serve samples/constellation.yaml --listen tcp://127.0.0.1:15754\n"
               "orrery serve day.nc --listen unix:/tmp/orrery.sock",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

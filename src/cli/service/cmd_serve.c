// SPDX-License-Identifier: GPL-3.0-or-later
// orrery serve: a scenario, or an orbit product alone, answered by time over sockets.
#include <signal.h>
#include <stdio.h>

#include "src/cli/service/serving.h"

static orr_serve_log_form form_of(const orr_cli *c)
{
    return orr_cli_says(c, "log", "json")      ? ORR_SERVE_LOG_JSON
           : orr_cli_says(c, "log", "journal") ? ORR_SERVE_LOG_JOURNAL
                                               : ORR_SERVE_LOG_TEXT;
}

static int run(orr_cli *c)
{
    if (orr_cli_given(c, "help-scenario")) {
        orr_schema_describe(orr_scenario_schema(), stdout);
        return ORR_EXIT_OK;
    }
    if (orr_cli_given(c, "help-access")) {
        orr_schema_describe(orr_access_schema(), stdout);
        return ORR_EXIT_OK;
    }
    if (c->n_operands != 1) return orr_cli_usage(c, "a scenario or an orbit product is wanted");
    serving v = {.c = c, .talk = orr_serve_log_open(form_of(c))};
    orr_supervisor_find(&v.supervisor);
    v.log = (orr_log){.level = c->log->level, .write = serving_write_log, .user = &v};
    signal(SIGPIPE, SIG_IGN); // whoever reads what it says may leave
    signal(SIGHUP, SIG_IGN);  // as later when it serves: a terminal may be closed while it prepares
    if (orr_cli_given(c, "http")) v.journal = orr_journal_open();
    orr_diag diag = {0};
    bool asked_wrongly = false;
    snprintf(v.path, sizeof v.path, "%.4100s", c->operand[0]);
    orr_status s = serving_run(&v, &asked_wrongly, &diag);
    while (s == ORR_OK && atomic_exchange(&v.loading, false)) s = serving_next(&v, &diag);
    serving_world_close(&v.past);
    serving_world_close(&v.remake.world);
    serving_world_close(&v.world);
    if (s == ORR_OK && !c->quiet) orr_serve_log_say(&v.talk, ORR_ID("R03") "stopped");
    orr_journal_close(v.journal);
    orr_serve_log_close(&v.talk);
    if (s == ORR_OK) return ORR_EXIT_OK;
    return asked_wrongly ? orr_cli_usage(c, "%s", diag.text) : orr_cli_fail(c, &diag);
}

static const orr_option options[] = {
    {.name = "listen",
     .letter = 'l',
     .kind = ORR_OPT_TEXT,
     .value = "URL",
     .repeated = true,
     .help = "Listen at tcp://HOST:PORT or tls://HOST:PORT (host *: every address; port 0: any free one) or "
             "unix:PATH. By default where the scenario says, else tcp://127.0.0.1:15754."},
    {.name = "scenarios",
     .kind = ORR_OPT_TEXT,
     .value = "DIR",
     .help = "Let clients that may control load other scenarios (CONTROL LOAD, SCENario:OPEN): NAME.yaml of "
             "this folder, by "
             "their names alone."},
    {.name = "access",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "Who may come in from other machines, by which certificates, and what each may do "
             "(docs/security.md; 'orrery tls init' writes one). By default where the scenario says, else "
             "nobody."},
    {.name = "insecure-listen",
     .kind = ORR_OPT_FLAG,
     .help = "Listen at addresses that other machines reach without TLS: whoever reaches them may do "
             "everything."},
    {.name = "text",
     .kind = ORR_OPT_TEXT,
     .value = "URL",
     .help = "Serve the same as text too: SCPI and JSON lines, at tcp://127.0.0.1:PORT, tls://HOST:PORT or "
             "unix:PATH, by the same rules (docs/live.md)."},
    {.name = "http",
     .kind = ORR_OPT_TEXT,
     .value = "ADDRESS",
     .help = "Serve the live page at 127.0.0.1:PORT (0: any free one): sky, channels, clients, motion, log. "
             "Read only, "
             "on this machine alone (docs/live.md)."},
    {.name = "ntrip",
     .kind = ORR_OPT_TEXT,
     .value = "[ANTENNA@]URL/MOUNT",
     .repeated = true,
     .help = "An NTRIP caster of one mountpoint: RTCM 3 of an antenna as a base station, at "
             "tcp://HOST:PORT/MOUNT or tls://, paced by "
             "the scenario's clock, by the same rules of access (docs/corrections.md)."},
    {.name = "ntrip-login",
     .kind = ORR_OPT_TEXT,
     .applies = "ntrip",
     .value = "FILE",
     .help = "The caster wants a login: USER:PASSWORD, the first line of this file."},
    {.name = "rtcm",
     .kind = ORR_OPT_TEXT,
     .value = "[ANTENNA@]URL",
     .repeated = true,
     .help = "RTCM 3 of an antenna for whoever connects to tcp://HOST:PORT, tls://HOST:PORT or unix:PATH. "
             "The antenna may be left out "
             "where there is one."},
    {.name = "ubx",
     .kind = ORR_OPT_TEXT,
     .value = "[ANTENNA@]URL",
     .repeated = true,
     .help = "UBX of an antenna, as a u-blox receiver, likewise."},
    {.name = "nmea",
     .kind = ORR_OPT_TEXT,
     .value = "[ANTENNA@]URL",
     .repeated = true,
     .help = "NMEA 0183 of an antenna's true position, likewise."},
    {.name = "port-rate",
     .kind = ORR_OPT_REAL,
     .applies = "ntrip|rtcm|ubx|nmea",
     .value = "HZ",
     .min = 0.01,
     .max = 100,
     .help = "Epochs a second of these; 1 by default."},
    {.name = "msm",
     .kind = ORR_OPT_CHOICE,
     .applies = "ntrip|rtcm",
     .value = "4|7",
     .fallback = "7",
     .help = "Which multiple signal messages RTCM has: MSM4, or MSM7 with Doppler and finer steps; 7 by "
             "default."},
    {.name = "noise",
     .kind = ORR_OPT_FLAG,
     .applies = "ntrip|rtcm|ubx|nmea",
     .help = "Thermal noise of their receivers, by C/N0; none by default."},
    {.name = "seed",
     .kind = ORR_OPT_INT,
     .applies = "noise",
     .value = "N",
     .min = 0,
     .max = 9e15,
     .help = "Seed of the noise; 1 by default."},
    {.name = "log",
     .kind = ORR_OPT_CHOICE,
     .value = "text|json|journal",
     .fallback = "text",
     .help = "How the service speaks: lines on standard error (default), JSON there, or messages to the "
             "journal, all with "
             "ids that stay (docs/operations.md)."},
    {.name = "max-clients",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 1,
     .max = 10000,
     .help =
         "Largest number of clients at once. One more takes the place of the one that has been idle longest, "
         "or is answered BUSY. By default as the access file says, else 256."},
    {.name = "from",
     .kind = ORR_OPT_TIME,
     .value = "T",
     .help = "Where the scenario's clock begins; the first instant served by default."},
    {.name = "start",
     .kind = ORR_OPT_TEXT,
     .value = "WHEN",
     .help = "When the scenario's clock goes, by which streams are paced: now (when the service is ready; "
             "the default), command "
             "(when a client says so), or an instant of the wall's clock (2026-03-01T12:00:00Z)."},
    {.name = "read-only",
     .kind = ORR_OPT_FLAG,
     .help = "Clients may read; what controls the clock or sends motion is refused."},
    {.name = "motion",
     .kind = ORR_OPT_FLAG,
     .help = "Take live motion (MOTION): the antennas that ride on the scenario's body follow it, in "
             "streams, from its first "
             "sample on."},
    {.name = "motion-log",
     .kind = ORR_OPT_TEXT,
     .applies = "motion",
     .value = "FILE",
     .writes = true,
     .help = "Write the samples to a file, each with the instant from which blocks rest on it."},
    {.name = "motion-replay",
     .kind = ORR_OPT_TEXT,
     .applies = "!motion",
     .value = "FILE",
     .help = "Take the samples from such a file: streams give the same blocks again, bit for bit."},
    {.name = "motion-udp",
     .kind = ORR_OPT_TEXT,
     .applies = "motion",
     .value = "PLACE",
     .help =
         "Take motion by datagrams too: PORT of 127.0.0.1 (0: any free one), or ADDRESS:PORT, where other "
         "machines send it sealed by keys of their TLS session (docs/protocol.md, Datagrams)."},
    {.name = "dialect",
     .kind = ORR_OPT_CHOICE,
     .applies = "motion-udp",
     .value = ORR_DIALECTS,
     .help = "How datagrams tell it: Orrery's frames (default), Skydel's hardware in the loop, lines of "
             "seconds, x, y, z and "
             "derivatives, or NMEA 0183 (docs/live.md)."},
    {.name = "join",
     .kind = ORR_OPT_REAL,
     .applies = "motion|motion-replay",
     .value = "MS",
     .min = 0,
     .max = 10000,
     .help = "How long it takes to go over from what was predicted to what is known, in ms; 65 by default, "
             "0: jump."},
    {.name = "motion-block",
     .kind = ORR_OPT_INT,
     .applies = "motion|motion-replay",
     .value = "MS",
     .min = 1,
     .max = 100,
     .help = "Length of blocks along live motion in ms, a whole part of a second; 5 by default."},
    {.name = "priority",
     .kind = ORR_OPT_INT,
     .value = "P",
     .min = 1,
     .max = 99,
     .help = "Real-time priority (SCHED_FIFO) of the thread that makes the blocks of streams; the machine "
             "must permit it."},
    {.name = "processor",
     .kind = ORR_OPT_INT,
     .value = "K",
     .min = 0,
     .max = 1023,
     .help = "The processor that this thread runs on, from 0; any by default."},
    {.name = "lock-memory",
     .kind = ORR_OPT_FLAG,
     .help = "Keep the whole process in memory, so that no block waits for a page."},
    {.name = "help-scenario", .kind = ORR_OPT_FLAG, .help = "Print all keys of a scenario file, and end."},
    {.name = "help-access", .kind = ORR_OPT_FLAG, .help = "Print all keys of an access file, and end."},
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
        "until SIGTERM or SIGINT (status 0; before that line they end it at once, as any program; SIGHUP "
        "reads the access file and the scenario again). "
        "Polls are answered by their time tag: the same poll gets the same "
        "bytes, from any "
        "client, any number of times.\n\n"
        "Listens on this machine alone unless told otherwise. Other machines come by tls://, with "
        "certificates "
        "of both sides (docs/security.md). docs/protocol.md describes "
        "the messages, docs/scenario.md the file.",
    .example =
        "orrery serve samples/constellation.yaml --listen tcp://127.0.0.1:15754\n"
        "orrery serve day.nc --listen unix:/tmp/orrery.sock\n"
        "orrery serve day.nc --listen 'tls://*:15754' --access lab/access.yaml\n"
        "orrery serve scenario.yaml --ntrip BASE@tcp://127.0.0.1:2101/BASE --rtcm ROVER@tcp://127.0.0.1:2102",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

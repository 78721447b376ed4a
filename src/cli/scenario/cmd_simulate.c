// SPDX-License-Identifier: GPL-3.0-or-later
// orrery simulate: a scenario as the files that a receiver and an inertial unit would have written, and the truth.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "src/cli/frame/options.h"
#include "src/cli/scenario/replay_report.h"
#include "src/cli/scenario/simulate_files.h"
#include "src/make/readings.h"
#include "src/scenario/observables/observe.h"

static void progress(void *user, size_t done, size_t total)
{
    orr_cli_progress(user, "observations", done, total);
}

static orr_status observe_antenna(simulation *s, size_t k, const orr_observe_plan *plan,
                                  int64_t truth_step_ns, orr_diag *diag)
{
    const orr_channels *channels = orr_engine_channels(s->engine);
    const orr_antenna *a = orr_channels_antenna(channels, k);
    char name[128], note[160], path[SIMULATE_PATH];
    orr_observe_count count;
    orr_observe_plan truth = *plan;
    truth.step_ns = truth_step_ns;
    truth.progress = NULL;
    snprintf(name, sizeof name, "%s.rnx", a->name);
    orr_status status = simulate_path(s, name, path, diag);
    if (status == ORR_OK) status = orr_observe_rinex(channels, k, plan, path, &count, diag);
    if (status == ORR_OK) {
        snprintf(note, sizeof note, "%zu epochs, %zu observed signals, RINEX %.2f", count.epochs,
                 count.observations, plan->rinex);
        status = simulate_note(s, name, note, diag);
    }
    if (status == ORR_OK) status = simulate_ports(s, k, plan, diag);
    snprintf(name, sizeof name, "%s-channels.csv", a->name);
    if (status == ORR_OK) status = simulate_path(s, name, path, diag);
    if (status == ORR_OK) status = orr_observe_truth(channels, k, &truth, path, &count, diag);
    if (status == ORR_OK) status = simulate_note(s, name, "true channels with all their terms", diag);
    if (status == ORR_OK && plan->replay != NULL) status = simulate_residuals(s, a->name, diag);
    snprintf(name, sizeof name, "%s-track.csv", a->name);
    if (status == ORR_OK) status = simulate_path(s, name, path, diag);
    if (status == ORR_OK) status = orr_observe_track(channels, k, plan, path, diag);
    if (status == ORR_OK) status = simulate_note(s, name, "true motion of the antenna", diag);
    return status;
}

// Span and step of the observations.
static int plan_of(orr_cli *c, const orr_engine *engine, orr_observe_plan *p)
{
    const orr_channels *channels = orr_engine_channels(engine);
    const orr_replay *replay = orr_engine_replay(engine, NULL);
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    orr_span span = orr_channels_span(channels);
    for (size_t k = 0; k < orr_channels_antennas(channels); k++) { // while all antennas are there
        const orr_span own = orr_channels_antenna_span(channels, k);
        if (own.from > span.from) span.from = own.from;
        if (own.to < span.to) span.to = own.to;
    }
    const double hz = orr_cli_real(c, "rate", 1);
    p->step_ns = orr_cli_given(c, "step") ? orr_cli_duration_ns(c, "step", 0) : (int64_t)(1e9 / hz + 0.5);
    // By default on whole steps of the day, within the span.
    p->from = orr_time_add(span.from, orr_floor_mod(-span.from, p->step_ns));
    p->from = orr_cli_time(c, "from", p->from);
    p->to = orr_cli_time(c, "to", span.to);
    p->replay = replay;
    p->recorded = replay != NULL && !orr_cli_given(c, "step") && !orr_cli_given(c, "rate");
    if (replay != NULL) { // what was recorded
        if (!orr_cli_given(c, "from")) p->from = replay->tag[0];
        if (!orr_cli_given(c, "to")) p->to = replay->tag[replay->n_epochs - 1];
        if (p->recorded) p->step_ns = (int64_t)(replay->interval_s * 1e9 + 0.5);
    }
    if (orr_cli_backward(c)) return orr_cli_usage(c, "--to is before --from");
    if (p->from < span.from || p->to > span.to || p->from > p->to)
        return orr_cli_failf(c, "the scenario's channels reach from %s to %s", orr_time_text(span.from, from),
                             orr_time_text(span.to, to));
    p->rinex = orr_cli_says(c, "rinex", "4.02") ? 4.02 : 3.05;
    p->noise = orr_cli_given(c, "noise");
    p->seed = (uint64_t)orr_cli_int(c, "seed", 1);
    return ORR_EXIT_OK;
}

static orr_status write_all(orr_cli *c, simulation *s, const orr_observe_plan *plan, orr_diag *diag)
{
    char from[ORR_TIME_TEXT], to[ORR_TIME_TEXT];
    const int64_t truth_ns = orr_cli_duration_ns(c, "truth-step", 30 * ORR_NS_PER_S);
    if (mkdir(s->folder, 0777) != 0 && errno != EEXIST)
        return orr_diag_set(diag, ORR_E_IO, "%s: the folder cannot be made: %s", s->folder, strerror(errno));
    orr_status status = ORR_OK;
    for (size_t k = 0; status == ORR_OK && k < orr_channels_antennas(orr_engine_channels(s->engine)); k++)
        status = observe_antenna(s, k, plan, truth_ns, diag);
    if (status == ORR_OK) status = simulate_broadcast(s, diag);
    if (status == ORR_OK) status = simulate_orbits(s, diag);
    if (status == ORR_OK && !orr_cli_given(c, "no-imu")) status = simulate_readings(s, diag);
    json_t *options = json_pack("{s:s, s:s, s:f, s:b, s:I}", "from", orr_time_text(plan->from, from), "to",
                                orr_time_text(plan->to, to), "step_s", (double)plan->step_ns / 1e9, "noise",
                                plan->noise, "seed", (json_int_t)plan->seed);
    if (status == ORR_OK) return simulate_manifest(s, options, diag);
    json_decref(options);
    return status;
}

static int simulate(orr_cli *c, simulation *s)
{
    orr_diag diag = {0};
    orr_observe_plan plan = {.progress = progress, .user = c};
    const orr_channels *channels = orr_engine_channels(s->engine);
    if (channels == NULL)
        return orr_cli_failf(
            c, "%s: it names no signals, so that there is nothing to observe (signals: [G, E, ...])",
            c->operand[0]);
    const int wrong = plan_of(c, s->engine, &plan);
    if (wrong != ORR_EXIT_OK) return wrong;
    const orr_replay_report *report;
    const orr_replay *replay = orr_engine_replay(s->engine, &report);
    if (replay != NULL) orr_replay_report_text(stdout, replay, report);
    return write_all(c, s, &plan, &diag) == ORR_OK ? ORR_EXIT_OK : orr_cli_fail(c, &diag);
}

// Orbits of --orbit are a product, or SP3 files.
static orr_status orbits_of(const char *const *path, size_t n, orr_scenario_replay_files *f, orr_diag *diag)
{
    orr_bytes head;
    const orr_status status = orr_inputs_read_raw(
        NULL, path[0], ORR_KIND_BIT(ORR_KIND_NETCDF) | ORR_KIND_BIT(ORR_KIND_SP3), &head, diag);
    if (status != ORR_OK) return status;
    const bool product =
        orr_sniff((orr_view){head.text, head.n < 65536 ? head.n : 65536}).kind == ORR_KIND_NETCDF;
    orr_bytes_free(&head);
    if (product && n > 1)
        return orr_diag_set(diag, ORR_E_ARG,
                            "%s is an orbit product: --orbit names one of these, or SP3 files", path[0]);
    f->product = product ? path[0] : NULL;
    f->sp3 = product ? NULL : path;
    f->n_sp3 = product ? 0 : n;
    return ORR_OK;
}

// The scenario of --from-rinex.
static orr_status replay_of(simulation *s, orr_scenario *out, orr_diag *diag)
{
    orr_cli *c = (orr_cli *)s->c;
    size_t n_orbits;
    const char **orbits = orr_cli_texts(c, "orbit", &n_orbits);
    orr_scenario_replay_files f = {.observations = orr_cli_text(c, "from-rinex", NULL),
                                   .sinex = orr_cli_text(c, "sinex", NULL),
                                   .station = orr_cli_text(c, "station", NULL),
                                   .field = orr_cli_text(c, "field", NULL),
                                   .antex = orr_cli_text(c, "antex", NULL),
                                   .bias = orr_cli_text(c, "bias", NULL),
                                   .from = orr_cli_time(c, "from", ORR_TIME_NONE),
                                   .to = orr_cli_time(c, "to", ORR_TIME_NONE),
                                   .no_residuals = orr_cli_given(c, "no-residuals")};
    const char **clk = orr_cli_texts(c, "clk", &f.n_clk), **erp = orr_cli_texts(c, "erp", &f.n_erp),
               **nav = orr_cli_texts(c, "nav", &f.n_nav);
    f.clk = clk;
    f.erp = erp;
    f.nav = nav;
    orr_status status = orbits != NULL && clk != NULL && erp != NULL && nav != NULL
                            ? ORR_OK
                            : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (status == ORR_OK && (n_orbits == 0 || f.field == NULL))
        status = orr_diag_set(diag, ORR_E_ARG,
                              "--from-rinex needs the orbits of its day (--orbit) and a field of the "
                              "ionosphere (--field: IONEX, or a "
                              "navigation file)");
    if (status == ORR_OK) status = orbits_of(orbits, n_orbits, &f, diag);
    if (status == ORR_OK) status = orr_scenario_of_replay(&f, c->leap, out, diag);
    free(orbits);
    free(clk);
    free(erp);
    free(nav);
    return status;
}

static int run(orr_cli *c)
{
    orr_scenario scenario = {0};
    const bool from_rinex = orr_cli_given(c, "from-rinex");
    if (from_rinex == (c->n_operands > 0))
        return orr_cli_usage(c, "it takes a SCENARIO or --from-rinex, one of them");
    orr_engine *e = NULL;
    orr_diag diag = {0};
    orr_warnings warnings = {0};
    simulation s = {
        .c = c, .folder = orr_cli_text(c, "output", "."), .scenario = &scenario, .files = json_array()};
    orr_status status = from_rinex ? replay_of(&s, &scenario, &diag)
                                   : orr_inputs_scenario(&s.inputs, c->operand[0], c->leap, &scenario, &diag);
    if (status == ORR_OK) {
        status = orr_engine_open(&scenario, c->log, NULL, &warnings, &e, &diag);
        orr_cli_warnings(c, &warnings);
        orr_warnings_free(&warnings);
    }
    int code = ORR_EXIT_FAILED;
    if (status == ORR_OK) {
        s.engine = e;
        status = orr_inputs_scenario_files(&s.inputs, &scenario, &diag);
        if (status == ORR_OK) code = simulate(c, &s);
        orr_engine_close(e);
    }
    if (status != ORR_OK) orr_cli_fail(c, &diag);
    orr_scenario_free(&scenario);
    orr_inputs_free(&s.inputs);
    json_decref(s.files);
    return code;
}

static const orr_option options[] = {
    ORR_OPTION_FOLDER(.fills = true, .help = "Folder of the files; made if it is not there."),
    ORR_OPTION_FROM(.help = "First epoch; the first whole step that the scenario has by default."),
    ORR_OPTION_TO(.help = "Last epoch; the end of the scenario by default."),
    ORR_OPTION_STEP(.applies = "!rate", .help = "From one epoch to the next; 1 s by default."),
    {.name = "rate",
     .kind = ORR_OPT_REAL,
     .value = "HZ",
     .min = 0.0001,
     .max = 1000,
     .applies = "!step",
     .help = "Epochs a second, in place of --step."},
    {.name = "truth-step",
     .kind = ORR_OPT_DURATION,
     .value = "S",
     .help = "From one row to the next in the tables of true channels; 30 s by default."},
    {.name = "rinex",
     .kind = ORR_OPT_CHOICE,
     .value = "3.05|4.02",
     .fallback = "3.05",
     .help = "Version of the observation files; 3.05 by default."},
    {.name = "noise", .kind = ORR_OPT_FLAG, .help = "Thermal noise of a receiver, by C/N0; none by default."},
    {.name = "seed",
     .kind = ORR_OPT_INT,
     .value = "N",
     .min = 0,
     .max = 9e15,
     .applies = "noise",
     .help = "Seed of the noise; 1 by default."},
    {.name = "rtcm",
     .kind = ORR_OPT_FLAG,
     .help = "NAME.rtcm3 of every antenna too: the same observations as RTCM 3, with station messages and "
             "ephemerides "
             "(docs/corrections.md)."},
    {.name = "msm",
     .kind = ORR_OPT_CHOICE,
     .value = "4|7",
     .fallback = "7",
     .applies = "rtcm",
     .help =
         "Which multiple signal messages it has: MSM4, or MSM7 with Doppler and finer steps; 7 by default."},
    {.name = "ubx",
     .kind = ORR_OPT_FLAG,
     .help = "NAME.ubx of every antenna too: NAV-PVT, RXM-RAWX and RXM-SFRBX as a u-blox receiver has them."},
    {.name = "nmea",
     .kind = ORR_OPT_FLAG,
     .help = "NAME.nmea of every antenna too: NMEA 0183 of the true position."},
    {.name = "from-rinex",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .help = "In place of a SCENARIO: the replay of a station's recorded observations (docs/replay.md). "
             "Epochs, gaps and slips are "
             "the record's, unless --step or --rate ask for others."},
    {.name = "orbit",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .applies = "from-rinex",
     .help = "Orbits and clocks of the recorded day: a product of `orrery orbit`, or SP3 files."},
    {.name = "clk",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .repeated = true,
     .applies = "from-rinex",
     .help = "RINEX CLK files, whose clocks come before those of SP3."},
    ORR_OPTION_ERP(.repeated = true, .applies = "from-rinex",
                   .help = "Earth rotation parameters for SP3 files."),
    ORR_OPTION_NAV(.repeated = true, .applies = "from-rinex",
                   .help = "Navigation files: satellites that the orbits lack, GLONASS channels that the "
                           "observations do not tell."),
    {.name = "field",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .applies = "from-rinex",
     .help = "The TEC field that levels the station's content: IONEX, Bernese .ION, or a navigation file."},
    ORR_OPTION_ANTEX(.applies = "from-rinex",
                     .help = "Antennas; of satellites that it lacks phase centres are estimated."),
    ORR_OPTION_BIAS(.applies = "from-rinex", .help = "Code biases of the satellites: Bias-SINEX or DCB."),
    {.name = "sinex",
     .kind = ORR_OPT_TEXT,
     .value = "FILE",
     .applies = "from-rinex",
     .help = "SINEX file with the station's coordinates; the header's by default."},
    {.name = "station",
     .kind = ORR_OPT_TEXT,
     .value = "CODE",
     .applies = "sinex",
     .help = "The station's name there; the first four characters of FILE's name by default."},
    {.name = "no-residuals",
     .kind = ORR_OPT_FLAG,
     .applies = "from-rinex",
     .help = "Leave out what the models do not tell of code and carrier."},
    {.name = "no-imu", .kind = ORR_OPT_FLAG, .help = "Leave the inertial readings out."},
};

const orr_command orr_cmd_simulate = {
    .name = "simulate",
    .group = "Scenarios",
    .summary = "observations, broadcast data, readings and truth of a scenario as files",
    .operands = "[SCENARIO]",
    .min_operands = 0,
    .max_operands = 1,
    .about =
        "For every antenna NAME.rnx (RINEX observations: code, phase, Doppler, C/N0 of every "
        "signal; the receiver's clock "
        "is perfect), NAME-channels.csv (the same channels with all their terms) and NAME-track.csv; of "
        "the scenario "
        "broadcast.rnx, truth.sp3, truth.clk, imu-N.nc of every unit, and manifest.json with what was "
        "read and written; of a replay NAME-residuals.csv and .json (what each signal is left with). The "
        "same scenario and seed give the same bytes.",
    .example = "orrery simulate samples/gravimetry-flight.yaml -o flight\n"
               "orrery simulate scenario.yaml -o run --step 30s --noise --seed 7\n"
               "orrery simulate scenario.yaml -o run --rtcm --ubx --nmea",
    .n_options = sizeof options / sizeof options[0],
    .option = options,
    .run = run,
};

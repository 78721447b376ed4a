// SPDX-License-Identifier: GPL-3.0-or-later
// Channels of one antenna: epochs and blocks of all terms, beside the bare evaluation of the same satellites' orbits.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/bench.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/channel/light.h"
#include "src/scenario/channel/seen.h"
#include "src/scenario/channel/slow.h"
#include "src/scenario/engine/engine.h"
#include "src/scenario/observables/observe.h"

enum { MOST_SATS = 64 };

typedef struct job {
    const orr_channels *c;
    const orr_ephemeris *e;
    orr_time t, from, to;
    int64_t step_ns;
    size_t channels, blocks, n_seen;
    uint16_t seen[MOST_SATS]; // places in c->satellite
    satellite_state state[MOST_SATS];
    orr_antenna_state at;
    orr_channel_work *work;
    orr_channel *channel;
    orr_block *block;
} job;

static void epoch(void *arg)
{
    job *j = arg;
    if (orr_channels_at(j->c, 0, j->work, j->t, UINT64_MAX, j->channel, &j->channels) != ORR_ANSWER_OK)
        abort();
    j->t += j->step_ns;
    if (j->t > j->to) j->t = j->from;
    bench_use(j->channel[0].code_m);
}

static void block(void *arg)
{
    job *j = arg;
    orr_blocks b;
    if (orr_blocks_at(j->c, 0, j->work, j->t, UINT64_MAX, &b, j->block, &j->blocks) != ORR_ANSWER_OK) abort();
    j->t = b.t0 + b.length_ns;
    if (j->t + ORR_NS_PER_S > j->to) j->t = j->from;
    bench_use(j->block[0].code[1]);
}

// What any channel needs at least of a satellite: where it is at reception and at emission.
static void orbits(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t k = 0; k < j->n_seen; k++) {
        orr_sat_state x;
        for (int twice = 0; twice < 2; twice++)
            if (orr_ephemeris_eval(j->e, j->c->satellite[j->seen[k]].sat, j->t - twice * 70000000, &x) ==
                ORR_OK)
                sum += x.pos_m.x;
    }
    bench_use(sum);
}

// The parts of an epoch, each over all satellites that are seen: satellites on their curves, twice; slow terms on theirs; the
// light's way.
static void satellites(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t k = 0; k < j->n_seen; k++)
        for (int twice = 0; twice < 2; twice++) {
            satellite_state x;
            if (satellite_at(j->e, j->c->satellite[j->seen[k]].sat, j->work->satellite[j->seen[k]], j->t,
                             twice * 0.07, &x))
                sum += x.pos_m.x;
        }
    bench_use(sum);
}

static void curves(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t k = 0; k < j->n_seen; k++) {
        slow_now x;
        slow_of_satellite(j->c, 0, j->work, j->t, &j->at, j->seen[k], &x);
        sum += x.v[0];
    }
    bench_use(sum);
}

static void directions(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t k = 0; k < j->n_seen; k++) sum += seen_at(j->c, 0, &j->at, j->state[k].pos_m).el_rad;
    bench_use(sum);
}

static void light(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t k = 0; k < j->n_seen; k++) {
        orr_light l;
        orr_light_close(0.07, j->state[k].pos_m, j->state[k].vel_mps, j->at.r_m, j->at.v_mps, &l);
        sum += l.range_m;
    }
    bench_use(sum);
}

static void place(void *arg)
{
    job *j = arg;
    orr_antenna_state at;
    (void)orr_antenna_at(orr_channels_antenna(j->c, 0), j->t, &at);
    bench_use(at.r_m.x);
}

// All slow terms themselves, at one instant.
static void terms(void *arg)
{
    job *j = arg;
    static slow_values v[SLOW_BATCH];
    slow_at(j->c, 0, j->work, j->t, &j->at, false, j->seen, j->n_seen, v);
    bench_use(v[0].v[0]);
}

static void find_seen(job *j)
{
    j->n_seen = 0;
    for (size_t k = 0; k < j->channels; k++) {
        if (k > 0 && j->channel[k].sat == j->channel[k - 1].sat) continue;
        uint16_t p = 0;
        while (j->c->satellite[p].sat != j->channel[k].sat) p++;
        (void)satellite_at(j->e, j->channel[k].sat, j->work->satellite[p], j->t, 0, &j->state[j->n_seen]);
        j->seen[j->n_seen++] = p;
    }
}

static void measure(bench *b, const char *name, orr_engine *e, orr_time from, orr_time to)
{
    static const struct {
        const char *words;
        int64_t step_ns;
    } rates[] = {
        {"1 kHz", 1000000}, {"10 Hz", 100000000}, {"1 Hz", 1000000000}, {"once in 10 min", 600000000000}};
    char row[120];
    job j = {.c = orr_engine_channels(e), .e = orr_engine_ephemeris(e), .from = from, .to = to};
    orr_diag d = {0};
    j.channel = calloc(orr_channels_max(j.c), sizeof *j.channel);
    j.block = calloc(orr_channels_max(j.c), sizeof *j.block);
    if (j.channel == NULL || j.block == NULL || orr_channel_work_open(j.c, &j.work, &d) != ORR_OK) abort();
    j.t = from;
    j.step_ns = 0;
    epoch(&j);
    (void)orr_antenna_at(orr_channels_antenna(j.c, 0), j.t, &j.at);
    find_seen(&j);
    const double part_s[] = {bench_seconds(b, place, &j),      bench_seconds(b, directions, &j),
                             bench_seconds(b, satellites, &j), bench_seconds(b, curves, &j),
                             bench_seconds(b, light, &j),      bench_seconds(b, epoch, &j),
                             bench_seconds(b, orbits, &j),     bench_seconds(b, terms, &j)};
    const double rest_s = part_s[5] - part_s[0] - part_s[1] - part_s[2] - part_s[3] - part_s[4];
    for (size_t k = 0; k < sizeof rates / sizeof *rates; k++) {
        j.t = from;
        j.step_ns = rates[k].step_ns;
        const double epoch_s = bench_seconds(b, epoch, &j);
        snprintf(row, sizeof row, "%s, an epoch of %zu channels, %s", name, j.channels, rates[k].words);
        bench_row(b, row, epoch_s * 1e6, part_s[2] * 1e6, "us", "satellites' polynomials, twice each, alone");
        if (k == 0)
            bench_note(b, "%.0f epochs a second of 40 satellites x 3 signals, %.0f ns a channel",
                       (double)j.channels / epoch_s / 120, epoch_s * 1e9 / (double)j.channels);
    }
    j.t = from;
    const double block_s = bench_seconds(b, block, &j);
    snprintf(row, sizeof row, "%s, a block of %zu channels, one after the other", name, j.blocks);
    bench_row(b, row, block_s * 1e6, part_s[2] * 1e6, "us", "satellites' polynomials, twice each, alone");
    bench_note(b,
               "an epoch: the antenna %.1f us, directions %.1f, satellites %.1f, slow terms' curves %.1f, "
               "light %.1f, "
               "signals and sums %.1f",
               part_s[0] * 1e6, part_s[1] * 1e6, part_s[2] * 1e6, part_s[3] * 1e6, part_s[4] * 1e6,
               rest_s * 1e6);
    bench_note(b, "the product's own orbits at these two instants %.1f us, the slow terms themselves %.1f us",
               part_s[6] * 1e6, part_s[7] * 1e6);
    orr_channel_work_close(j.work);
    free(j.channel);
    free(j.block);
}

// An hour of observations as a file.
static void simulate(bench *b, const char *name, orr_engine *e, orr_time from)
{
    static const char *const path = "bench_channels.rnx";
    for (int hz = 1; hz <= 10; hz += 9) {
        char row[120];
        orr_observe_count count;
        orr_diag d = {0};
        const orr_observe_plan plan = {
            .from = from, .to = from + 3599 * ORR_NS_PER_S, .step_ns = ORR_NS_PER_S / hz, .rinex = 3.05};
        struct timespec t0, t1;
        clock_gettime(CLOCK_MONOTONIC, &t0);
        if (orr_observe_rinex(orr_engine_channels(e), 0, &plan, path, &count, &d) != ORR_OK) {
            fprintf(stderr, "bench: %s\n", d.text);
            abort();
        }
        clock_gettime(CLOCK_MONOTONIC, &t1);
        remove(path);
        snprintf(row, sizeof row, "%s, an hour of RINEX at %d Hz", name, hz);
        bench_row(b, row, (double)(t1.tv_sec - t0.tv_sec) + 1e-9 * (double)(t1.tv_nsec - t0.tv_nsec), 0, "s",
                  "");
    }
}

static void run(bench *b, const char *name, const char *troposphere, const char *antenna)
{
    char text[3000];
    orr_scenario s;
    orr_engine *e = NULL;
    orr_diag d = {0};
    snprintf(text, sizeof text,
             "orbit: {sp3: [%s/samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz]}\nnavdata: {window: none}\n"
             "ionosphere: {field: %s/samples/ionosphere.ION}\ntroposphere: {model: saastamoinen%s}\n"
             "signals: [\"G:L1CA\", \"G:L2C\", \"G:L5\", \"R:L1OF\", \"R:L2OF\", \"R:L3OC\", \"E:E1\", "
             "\"E:E5a\", \"E:E5b\"]\n"
             "mask: {elevation: 0}\n%s",
             ORR_SOURCE_DIR, ORR_SOURCE_DIR, troposphere, antenna);
    orr_status status = orr_scenario_parse("bench", text, strlen(text), NULL, NULL, &s, &d);
    if (status == ORR_OK) {
        status = orr_engine_open(&s, NULL, NULL, NULL, &e, &d);
        orr_scenario_free(&s);
    }
    if (status != ORR_OK) {
        fprintf(stderr, "bench: %s\n", d.text);
        abort();
    }
    const orr_span span = orr_channels_antenna_span(orr_engine_channels(e), 0);
    const orr_time from = span.from + 60 * ORR_NS_PER_S - span.from % ORR_NS_PER_S;
    measure(b, name, e, from, span.to);
    simulate(b, name, e, from);
    orr_engine_close(e);
}

void bench_channels(bench *b)
{
    static const char *const effects =
        "antennas: [{name: A, position: [56, 40, 150]}]\nsite: {solid_tide: yes, pole_tide: yes}\n"
        "scintillation: [{s4: 0.5, tau0: 0.5, sigma_phi: 0.3}]\n"
        "disturbance: {waves: [{amplitude: 1, length: 200, speed: 150, azimuth: 90, position: [56, 40], "
        "time: "
        "2025-03-21T00:00:00}]}\n"
        "clocks: {satellites: [{sats: \"G,R,E\", white_frequency: 1e-11}]}\n"
        "multipath: {ground: {height: 2}}\n"
        "faults: {noise: [{sats: \"G,R,E\", from: 2025-03-21T00:10:00, sigma: 1, time: 60}], range: [{sats: "
        "G05, from: "
        "2025-03-21T01:00:00, rate: 0.01}]}\n";
    bench_group(b, "Channels: three signals a satellite, all terms, one core");
    run(b, "fixed antenna", "", "antennas: [{name: A, position: [56, 40, 150]}]\n");
    run(b, "fixed antenna, effects and the ground's echoes",
        ", mapping: gmf, turbulence: {seed: 1}, gradients: given, gradient_wet: [0.5, 0.5]", effects);
    run(b, "survey flight", "",
        "antennas: [{name: A, up: 1}]\ntrajectory: {kind: survey, start: 2025-03-21T10:00:00, duration: "
        "4000, lat: 56, lon: 40, "
        "height: 1500, turbulence: {rms: 0.5}, oscillation: {roll: {rms: 0.8}}}\n");
}

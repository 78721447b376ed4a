// SPDX-License-Identifier: GPL-3.0-or-later
// Channels of one antenna: epochs and blocks of all terms, beside the bare evaluation of the same satellites' orbits.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/bench.h"
#include "src/scenario/channel/block.h"
#include "src/scenario/engine/engine.h"

typedef struct job {
    const orr_channels *c;
    const orr_ephemeris *e;
    orr_time t;
    size_t channels, satellites, blocks;
    orr_channel_work *work;
    orr_channel *channel;
    orr_block *block;
} job;

static void epoch(void *arg)
{
    job *j = arg;
    if (orr_channels_at(j->c, 0, j->work, j->t, UINT64_MAX, j->channel, &j->channels) != ORR_ANSWER_OK)
        abort();
    j->t += 100 * 1000000; // 10 Hz
    bench_use(j->channel[0].code_m);
}

static void block(void *arg)
{
    job *j = arg;
    orr_blocks b;
    if (orr_blocks_at(j->c, 0, j->work, j->t, UINT64_MAX, &b, j->block, &j->blocks) != ORR_ANSWER_OK) abort();
    j->t = b.t0 + b.length_ns;
    bench_use(j->block[0].code[1]);
}

// What any channel needs at least of a satellite: where it is at reception and at emission.
static void orbits(void *arg)
{
    job *j = arg;
    double sum = 0;
    for (size_t k = 0; k < j->channels; k++) {
        orr_sat_state x;
        if (k > 0 && j->channel[k].sat == j->channel[k - 1].sat) continue;
        for (int twice = 0; twice < 2; twice++)
            if (orr_ephemeris_eval(j->e, j->channel[k].sat, j->t - twice * 70000000, &x) == ORR_OK)
                sum += x.pos_m.x;
    }
    bench_use(sum);
}

static void measure(bench *b, const char *name, orr_engine *e, orr_time from)
{
    char row[120];
    job j = {.c = orr_engine_channels(e), .e = orr_engine_ephemeris(e), .t = from};
    j.channel = calloc(orr_channels_max(j.c), sizeof *j.channel);
    j.block = calloc(orr_channels_max(j.c), sizeof *j.block);
    orr_diag d = {0};
    if (j.channel == NULL || j.block == NULL || orr_channel_work_open(j.c, &j.work, &d) != ORR_OK) abort();
    const double epoch_s = bench_seconds(b, epoch, &j);
    j.t = from;
    const double block_s = bench_seconds(b, block, &j);
    j.t = from;
    const double orbit_s = bench_seconds(b, orbits, &j);
    snprintf(row, sizeof row, "%s, an epoch of %zu channels", name, j.channels);
    bench_row(b, row, epoch_s * 1e6, orbit_s * 1e6, "us", "orbits at reception and emission alone");
    bench_note(b, "%.0f epochs a second, %.0f ns a channel; %.0f blocks of all channels a second",
               1 / epoch_s, epoch_s * 1e9 / (double)j.channels, 1 / block_s);
    orr_channel_work_close(j.work);
    free(j.channel);
    free(j.block);
}

static void run(bench *b, const char *name, const char *antenna)
{
    char text[3000];
    orr_scenario s;
    orr_engine *e = NULL;
    orr_diag d = {0};
    snprintf(text, sizeof text,
             "orbit: {sp3: [%s/samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz]}\nnavdata: {window: none}\n"
             "ionosphere: {field: %s/samples/ionosphere.ION}\ntroposphere: {model: saastamoinen}\n"
             "signals: [\"G:L1CA\", \"G:L2C\", \"G:L5\", \"R:L1OF\", \"R:L2OF\", \"R:L3OC\", \"E:E1\", "
             "\"E:E5a\", \"E:E5b\"]\n"
             "mask: {elevation: 0}\n%s",
             ORR_SOURCE_DIR, ORR_SOURCE_DIR, antenna);
    orr_status status = orr_scenario_parse("bench", text, strlen(text), NULL, NULL, &s, &d);
    if (status == ORR_OK) {
        status = orr_engine_open(&s, NULL, NULL, NULL, &e, &d);
        orr_scenario_free(&s);
    }
    if (status != ORR_OK) {
        fprintf(stderr, "bench: %s\n", d.text);
        abort();
    }
    measure(b, name, e, orr_channels_antenna_span(orr_engine_channels(e), 0).from + 60 * ORR_NS_PER_S);
    orr_engine_close(e);
}

void bench_channels(bench *b)
{
    bench_group(b, "Channels: three signals a satellite, all terms, one core");
    run(b, "fixed antenna", "antennas: [{name: A, position: [56, 40, 150]}]\n");
    run(b, "survey flight",
        "antennas: [{name: A, up: 1}]\ntrajectory: {kind: survey, start: 2025-03-21T10:00:00, duration: "
        "3600, lat: 56, lon: 40, "
        "height: 1500, turbulence: {rms: 0.5}, oscillation: {roll: {rms: 0.8}}}\n");
}

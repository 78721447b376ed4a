// SPDX-License-Identifier: GPL-3.0-or-later
// The generator: nanoseconds a sample and channel of the kernel, of whole pieces, of noise and output; and, where it is installed,
// gps-sdr-sim over the same number of channels.
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/bench.h"
#include "src/generator/codes/codes.h"
#include "src/generator/play/crew.h"

enum { SATELLITES = 40, RUNS = 15 };

// Seconds of this thread's processor that a call takes: the least of several runs, so that what else the machine does counts
// little. gps-sdr-sim, which is measured beside, tells its own in the same way.
static double processor_seconds(void (*work)(void *arg), void *arg)
{
    double best = HUGE_VAL;
    long calls = 1;
    for (int run = 0; run < RUNS;) {
        struct timespec a, b;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a);
        for (long k = 0; k < calls; k++) work(arg);
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
        const double took = (double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec);
        if (took < 0.005) {
            calls *= 2;
            continue;
        }
        best = fmin(best, took / (double)calls);
        run++;
    }
    return best;
}

// --- The kernel alone: pieces of C/A code on their carriers ---

typedef struct mixing {
    const orr_gen_kernel *kernel;
    uint32_t rate;
    int8_t chips[1023 + ORR_GEN_CHIPS_BEYOND];
    int16_t re[ORR_GEN_PIECE], im[ORR_GEN_PIECE];
    uint64_t turn;
} mixing;

static orr_gen_period period_of(void *user, int64_t number, size_t from, size_t to)
{
    (void)from, (void)to;
    const mixing *m = user;
    return (orr_gen_period){m->chips, number % 20 < 10 ? 1 : -1};
}

static void mix(void *arg)
{
    mixing *m = arg;
    orr_gen_carrier c;
    m->turn += 0x123456789abcdu;
    m->kernel->carrier(m->turn, m->turn << 8, 2000, ORR_GEN_GROUPS, &c);
    const orr_gen_code_at code = {.number = (int64_t)(m->turn >> 60),
                                  .chips = 1023,
                                  .code = m->turn >> 20,
                                  .code_step = (uint64_t)(1.023e6 / m->rate * 0x1p39),
                                  .period = period_of,
                                  .user = m};
    orr_gen_periods_mix(m->kernel->mix, &c, &code, ORR_GEN_GROUPS, m->re, m->im);
    bench_use(m->re[7]);
}

static void mixers(bench *b)
{
    static const uint32_t rate[] = {2600000, 5000000, 10000000, 25000000};
    static mixing m;
    orr_gen_code_fill(ORR_GEN_L1CA, 7, m.chips);
    for (size_t k = 0; k < 4; k++) {
        double ns[2];
        m.rate = rate[k];
        for (int vector = 0; vector < 2; vector++) {
            m.kernel = vector ? orr_gen_kernel_best() : orr_gen_kernel_at(0);
            ns[vector] = processor_seconds(mix, &m) / ORR_GEN_PIECE * 1e9;
        }
        char name[64];
        snprintf(name, sizeof name, "kernel, L1 C/A at %g Msps, a sample and channel", rate[k] / 1e6);
        bench_row(b, name, ns[1], ns[0], "ns", "the same in plain C");
    }
}

// --- Whole pieces, from cubics to bytes ---

typedef struct playing {
    orr_gen_service service;
    orr_gen_navigation *navigation;
    orr_gen_stream *stream;
    orr_gen_block block;
    orr_gen_channel channel[SATELLITES];
    orr_gen_crew *crew;
    uint8_t bytes[8 * ORR_GEN_PIECE];
    int64_t at, begin, end;
} playing;

static void play(void *arg)
{
    playing *p = arg;
    const orr_gen_span span = orr_gen_stream_span(p->stream, &p->block, p->at);
    const int64_t end = span.first + span.n;
    orr_gen_task task = {.stream = p->stream, .from = span.first, .to = end, .bytes = p->bytes};
    orr_gen_crew_play(p->crew, &p->block, 1, &task, 1);
    p->at = end < p->end ? end : p->begin;
    bench_use(p->bytes[3]);
}

static void fill_channels(playing *p, char system, size_t n)
{
    p->block = (orr_gen_block){
        .begin_ns = 1426593600000000000, .length_ns = 1000000000, .n = n, .channel = p->channel};
    for (size_t k = 0; k < n; k++) {
        orr_gen_channel *c = &p->channel[k];
        *c = (orr_gen_channel){.system = system, .number = (uint8_t)(k % 30 + 1), .power_dbw = -157};
        c->strength = pow(10, c->power_dbw / 20);
        c->cubics = (orr_gen_cubics){.block_ns = p->block.begin_ns,
                                     .code_m = {2.1e7 + 1e5 * (double)k, 700.0 - 35.0 * (double)k, 0.1, 1e-5},
                                     .transmit_ns = p->block.begin_ns - 70000000 - 333333 * (int64_t)k,
                                     .carrier_hz = p->service.signal[0].carrier_hz};
        for (int j = 1; j < 4; j++)
            c->cubics.carrier_cycles[j] = c->cubics.code_m[j] * c->cubics.carrier_hz / 299792458.0;
    }
}

// Nanoseconds a sample of n channels of a signal.
static double pieces(const orr_gen_signal_info *signal, size_t n, uint32_t rate, bool noise)
{
    playing *p = calloc(1, sizeof *p);
    orr_gen_fault fault = {{0}};
    if (p == NULL) abort();
    p->service.n_signals = 1;
    p->service.signal[0] = *signal;
    const orr_gen_stream_plan plan = {.rate_hz = rate,
                                      .centre_hz = (int64_t)signal->carrier_hz,
                                      .format = noise ? ORR_GEN_I8 : ORR_GEN_I16,
                                      .noise = noise,
                                      .cn0_dbhz = ORR_GEN_NO_LEVEL,
                                      .amplitude = ORR_GEN_NO_LEVEL,
                                      .signals = 1};
    fill_channels(p, signal->system, n);
    if (!orr_gen_navigation_open(NULL, &p->service, &p->navigation, &fault) ||
        !orr_gen_stream_open(&p->service, p->navigation, &plan, &p->stream, &fault) ||
        !orr_gen_stream_ready(p->stream, &p->block, &fault) || !orr_gen_crew_open(1, &p->crew, &fault))
        abort();
    p->begin = p->at = orr_gen_first_sample(p->block.begin_ns, rate);
    p->end = orr_gen_first_sample(p->block.begin_ns + p->block.length_ns, rate);
    // A mean piece: blocks begin and end within the lattice.
    const double mean = (double)ORR_GEN_PIECE;
    const double ns = processor_seconds(play, p) / mean * 1e9;
    orr_gen_crew_close(p->crew);
    orr_gen_stream_close(p->stream);
    orr_gen_navigation_close(p->navigation);
    free(p);
    return ns;
}

static void streams(bench *b, double peer_ns)
{
    static const orr_gen_signal_info l1 = {.system = 'G', .name = "L1CA", .carrier_hz = 1575.42e6};
    static const struct {
        orr_gen_signal_info signal;
        uint32_t rate;
    } row[] = {{{.system = 'G', .name = "L1CA", .carrier_hz = 1575.42e6}, 2600000},
               {{.system = 'G', .name = "L1CA", .carrier_hz = 1575.42e6}, 5000000},
               {{.system = 'G', .name = "L1CA", .carrier_hz = 1575.42e6}, 10000000},
               {{.system = 'R', .name = "L1OF", .carrier_hz = 1602e6}, 10000000},
               {{.system = 'C', .name = "B1I", .carrier_hz = 1561.098e6}, 10000000},
               {{.system = 'E', .name = "E1", .carrier_hz = 1575.42e6}, 5000000},
               {{.system = 'E', .name = "E1", .carrier_hz = 1575.42e6}, 25000000},
               {{.system = 'G', .name = "L5", .carrier_hz = 1176.45e6}, 25000000}};
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        char name[80];
        const double none = pieces(&row[k].signal, 0, row[k].rate, false);
        const double twelve = pieces(&row[k].signal, 12, row[k].rate, false);
        snprintf(name, sizeof name, "%s at %g Msps, cubics to sums, a sample and channel", row[k].signal.name,
                 row[k].rate / 1e6);
        bench_row(b, name, (twelve - none) / 12, peer_ns, "ns",
                  peer_ns > 0 ? "gps-sdr-sim, whole program" : "");
    }
    bench_row(b, "12 of L1CA at 5 Msps, cubics to bytes, a sample and channel",
              pieces(&l1, 12, 5000000, false) / 12, peer_ns, "ns",
              peer_ns > 0 ? "gps-sdr-sim, whole program" : "");
    const double bare = pieces(&l1, 0, 5000000, false), noisy = pieces(&l1, 0, 5000000, true);
    bench_row(b, "output of int16, a sample", bare, 0, "ns", "");
    bench_row(b, "output of int8 with noise, a sample", noisy, 0, "ns", "");
    const double forty = pieces(&l1, 40, 25000000, false);
    bench_row(b, "40 channels at 25 Msps, share of one core", forty * 25e6 / 1e9, 0, "", "");
}

// One run of gps-sdr-sim by a command: its own seconds, and how many channels it has.
static bool peer_run(const char *command, double *seconds, double *channels)
{
    char line[400];
    FILE *f = popen(command, "r");
    if (f == NULL) return false;
    *seconds = *channels = 0;
    int prn;
    double az, el, range, delay;
    bool counting = true; // satellites are listed once at the begin, and again each 30 s
    while (fgets(line, sizeof line, f) != NULL) {
        if (counting && sscanf(line, "%d %lf %lf %lf %lf", &prn, &az, &el, &range, &delay) == 5 &&
            range > 1e7)
            ++*channels;
        if (strstr(line, "Time into run") != NULL) counting = false;
        sscanf(line, "Process time = %lf", seconds);
    }
    pclose(f);
    return *channels > 0 && *seconds > 0;
}

// gps-sdr-sim on its own data, the quickest of three runs: nanoseconds a sample and channel; 0 where it is not installed, with a
// note of what is wanted.
static double peer(bench *b)
{
    char path[1024], command[1400];
    size_t size;
    void *nav = bench_data("2010-182/brdc1820.10n.gz", path, sizeof path, &size);
    free(nav);
    if (nav == NULL || system("command -v gps-sdr-sim >/dev/null 2>&1") != 0) {
        bench_note(b, "gps-sdr-sim (in PATH, and ORRERY_DATA) would be measured beside");
        return 0;
    }
    snprintf(command, sizeof command,
             "t=$(mktemp) && gzip -dc '%s' > $t && gps-sdr-sim -v -e $t -l 52.2,17.07,100 -d 20 -s 5000000 "
             "-b 8 -o /dev/null 2>&1 | "
             "tr '\\r' '\\n'; rm -f $t",
             path);
    double least = HUGE_VAL, seconds, channels = 0;
    for (int run = 0; run < 3; run++) {
        if (!peer_run(command, &seconds, &channels)) return 0;
        least = fmin(least, seconds);
    }
    bench_note(b, "gps-sdr-sim: %.0f channels, 20 s of 5 Msps in %.1f s", channels, least);
    return least / (20 * 5e6 * channels) * 1e9;
}

void bench_generator(bench *b)
{
    bench_group(b, "Generator (one thread)");
    mixers(b);
    streams(b, peer(b));
}

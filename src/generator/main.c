// SPDX-License-Identifier: GPL-3.0-or-later
// orrery-generator: from a service's channels and navigation data to baseband samples. It is what a hardware generator is to the
// service: all that it knows came over the socket. docs/generator.md tells the steps with lines of this program.
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "src/generator/feed/blocks.h"
#include "src/generator/feed/navigation.h"
#include "src/generator/options.h"
#include "src/generator/play/crew.h"
#include "src/generator/play/stream.h"
#include "src/generator/record/sigmf.h"
#include "src/generator/record/writer.h"

#define NS_PER_S 1000000000
#define META_EVERY_S 5
#define META_ROOM 65536 // bytes that metadata takes at most, whole samples of any format

static volatile sig_atomic_t interrupted;

static void on_signal(int number)
{
    (void)number;
    interrupted = 1;
}

// A stream of the run, and where it goes.
typedef struct track {
    orr_gen_stream *stream;
    orr_gen_writer *writer;
    char data[1024], meta[1024]; // meta empty for standard output
    int64_t first, end, next;    // samples: the first, one beyond the last, the next to be made
    uint64_t clipped;
    bool half;    // of ORR_GEN_I2: a sample waits for the other of its byte
    uint8_t left; // that sample
} track;

typedef struct generator {
    orr_gen_options options;
    orr_gen_link *link;
    orr_gen_service service;
    orr_gen_blocks *blocks;
    orr_gen_navigation *navigation;
    orr_gen_crew *crew;
    uint16_t antenna;
    int64_t from_ns, to_ns;
    size_t n_tracks;
    track track[ORR_GEN_STREAMS];
} generator;

static void say(void *user, const char *text)
{
    const generator *g = user;
    if (!g->options.quiet) fprintf(stderr, "orrery-generator: %s\n", text);
}

// --- What is to be played ---

static bool find_antenna(generator *g, orr_gen_fault *fault)
{
    const char *name = g->options.antenna;
    if (!g->service.has_channels || g->service.n_antennas == 0)
        return orr_gen_fail(
            fault,
            "%s serves no channels: the scenario names no signals or no antenna (signals: [G, E, ...])",
            g->options.url);
    if (name == NULL) return true;
    for (size_t k = 0; k < g->service.n_antennas; k++)
        if (strcmp(g->service.antenna[k], name) == 0) {
            g->antenna = (uint16_t)k;
            return true;
        }
    char *end;
    const unsigned long k = strtoul(name, &end, 10);
    if (*name == '\0' || *end != '\0' || k >= g->service.n_antennas)
        return orr_gen_fail(fault, "there is no antenna %s: the first of %zu is %s", name,
                            g->service.n_antennas, g->service.antenna[0]);
    g->antenna = (uint16_t)k;
    return true;
}

static void signal_name(const orr_gen_signal_info *s, char text[24])
{
    snprintf(text, 24, "%c:%s", s->system, s->name);
}

static bool named(const char *list, const char *name)
{
    const size_t n = strlen(name);
    for (const char *at = list; at != NULL && *at != '\0';
         at = strchr(at, ','), at = at != NULL ? at + 1 : NULL)
        if (strncmp(at, name, n) == 0 && (at[n] == ',' || at[n] == '\0')) return true;
    return false;
}

// Every name of a list is a signal that is served.
static bool all_served(const generator *g, const char *list, orr_gen_fault *fault)
{
    for (const char *at = list; *at != '\0';) {
        const size_t n = strcspn(at, ",");
        bool served = false;
        for (size_t k = 0; k < g->service.n_signals && !served; k++) {
            char name[24];
            signal_name(&g->service.signal[k], name);
            served = strlen(name) == n && strncmp(name, at, n) == 0;
        }
        if (!served)
            return orr_gen_fail(
                fault, "the service sends no signal %.*s: it is named as in the scenario, e.g. G:L1CA",
                (int)n, at);
        at += n + (at[n] == ',');
    }
    return true;
}

// Where no centre is given: the carrier of the first signal that is asked for, or else served.
static double centre_of(const generator *g, const orr_gen_stream_options *o)
{
    if (o->centre_hz > 0) return o->centre_hz;
    for (size_t k = 0; k < g->service.n_signals; k++) {
        char name[24];
        signal_name(&g->service.signal[k], name);
        if (o->signals == NULL ? orr_gen_played_of(&g->service.signal[k]).known : named(o->signals, name))
            return g->service.signal[k].carrier_hz;
    }
    return 1575.42e6;
}

static bool choose_signals(generator *g, const orr_gen_stream_options *o, orr_gen_stream_plan *plan,
                           orr_gen_fault *fault)
{
    if (o->signals != NULL && !all_served(g, o->signals, fault)) return false;
    for (size_t k = 0; k < g->service.n_signals; k++) {
        char name[24], text[200];
        signal_name(&g->service.signal[k], name);
        if (o->signals != NULL && !named(o->signals, name)) continue;
        const char *lacks = orr_gen_stream_lacks(&g->service, k, plan->rate_hz, plan->centre_hz, false);
        if (lacks != NULL) {
            if (o->signals != NULL)
                return orr_gen_fail(fault, "%s %s (%.6g Msps about %.6f MHz)", name, lacks,
                                    plan->rate_hz / 1e6, (double)plan->centre_hz / 1e6);
            continue;
        }
        plan->signals |= (uint64_t)1 << k;
        lacks = orr_gen_stream_lacks(&g->service, k, plan->rate_hz, plan->centre_hz, true);
        if (lacks == NULL) continue;
        snprintf(text, sizeof text, "%s %s: what is beyond them folds back", name, lacks);
        say(g, text);
    }
    if (plan->signals == 0)
        return orr_gen_fail(fault, "no signal that is served fits into %.6g Msps about %.6f MHz",
                            plan->rate_hz / 1e6, (double)plan->centre_hz / 1e6);
    return true;
}

static bool choose_time(generator *g, orr_gen_fault *fault)
{
    const orr_msg_span span = g->service.channels;
    g->from_ns = g->options.from_ns;
    if (g->from_ns == INT64_MIN) g->from_ns = (span.first + NS_PER_S - 1) / NS_PER_S * NS_PER_S;
    g->to_ns = g->options.seconds > 0 ? g->from_ns + (int64_t)(g->options.seconds * 1e9 + 0.5) : span.last;
    if (g->from_ns >= span.first && g->from_ns < g->to_ns && g->to_ns <= span.last) return true;
    return orr_gen_fail(fault,
                        "channels are served for %.3f s from %.3f s on (GPS time since 1980-01-06); %.3f s "
                        "from %.3f s on do not lie in it",
                        (double)(span.last - span.first) / 1e9, (double)span.first / 1e9,
                        (double)(g->to_ns - g->from_ns) / 1e9, (double)g->from_ns / 1e9);
}

// FILE, FILE.sigmf-data or FILE.sigmf-meta: the two names.
static void name_files(const char *output, track *t)
{
    if (strcmp(output, "-") == 0) {
        snprintf(t->data, sizeof t->data, "-");
        return;
    }
    size_t n = strlen(output);
    if (n > 11 &&
        (strcmp(output + n - 11, ".sigmf-data") == 0 || strcmp(output + n - 11, ".sigmf-meta") == 0))
        n -= 11;
    snprintf(t->data, sizeof t->data, "%.*s.sigmf-data", (int)n, output);
    snprintf(t->meta, sizeof t->meta, "%.*s.sigmf-meta", (int)n, output);
}

// --- Files ---

static uint64_t samples_of(const track *t, uint64_t bytes)
{
    const orr_gen_stream_plan *p = orr_gen_stream_plan_of(t->stream);
    if (p->format == ORR_GEN_I2) {
        const uint64_t all = (uint64_t)(t->end - t->first), n = 2 * bytes;
        return n < all ? n : all;
    }
    return bytes / orr_gen_output_size(p->format, 1);
}

static bool write_meta(const generator *g, const track *t, orr_gen_written written, bool complete,
                       orr_gen_fault *fault)
{
    if (t->meta[0] == '\0') return true;
    const char *slash = strrchr(t->data, '/');
    const orr_gen_recording r = {.service = &g->service,
                                 .stream = t->stream,
                                 .antenna = g->service.antenna[g->antenna],
                                 .data_name = slash != NULL ? slash + 1 : t->data,
                                 .first = t->first,
                                 .samples = samples_of(t, written.bytes),
                                 .complete = complete,
                                 .clipped = t->clipped,
                                 .underruns = written.underruns};
    return orr_gen_sigmf_write(t->meta, &r, fault);
}

static bool open_track(generator *g, const orr_gen_stream_options *o, orr_gen_fault *fault)
{
    track *t = &g->track[g->n_tracks];
    orr_gen_stream_plan plan = {.rate_hz = (uint32_t)o->rate_hz,
                                .centre_hz = (int64_t)(centre_of(g, o) + 0.5),
                                .format = o->format,
                                .noise = g->options.noise,
                                .seed = g->options.seed + 1000003 * (uint64_t)g->n_tracks,
                                .cn0_dbhz = g->options.cn0_dbhz,
                                .amplitude = g->options.amplitude};
    if (!choose_signals(g, o, &plan, fault) ||
        !orr_gen_stream_open(&g->service, g->navigation, &plan, &t->stream, fault))
        return false;
    g->n_tracks++;
    t->first = t->next = orr_gen_first_sample(g->from_ns, plan.rate_hz);
    t->end = orr_gen_first_sample(g->to_ns, plan.rate_hz);
    name_files(o->output, t);
    const double bytes_s = plan.format == ORR_GEN_I2 ? plan.rate_hz / 2.0
                                                     : (double)orr_gen_output_size(plan.format, plan.rate_hz);
    if (!orr_gen_writer_open(t->data, g->options.pace ? bytes_s : 0, &t->writer, fault)) return false;
    return write_meta(g, t, (orr_gen_written){0}, false, fault); // valid from the first byte on
}

// --- Playing ---

// The next buffer of a track, up to `end` at most; none where there is nothing left to be made of it.
static bool begin_buffer(track *t, int64_t end, orr_gen_task *task, orr_gen_fault *fault)
{
    const orr_gen_format format = orr_gen_stream_plan_of(t->stream)->format;
    const int64_t until = end - t->next > ORR_GEN_CREW_SAMPLES ? t->next + ORR_GEN_CREW_SAMPLES : end;
    uint8_t *bytes =
        orr_gen_writer_buffer(t->writer, orr_gen_output_size(format, (size_t)(until - t->next)) + 1);
    if (bytes == NULL) return orr_gen_fail(fault, "the samples cannot be written");
    if (t->half) bytes[0] = t->left;
    *task =
        (orr_gen_task){.stream = t->stream, .from = t->next, .to = until, .bytes = bytes + (t->half ? 1 : 0)};
    return true;
}

// Hands it to the writer.
static void end_buffer(track *t, const orr_gen_task *task)
{
    const orr_gen_format format = orr_gen_stream_plan_of(t->stream)->format;
    const size_t carried = t->half ? 1 : 0;
    uint8_t *bytes = task->bytes - carried;
    size_t size = orr_gen_output_size(format, (size_t)(task->to - task->from));
    if (format == ORR_GEN_I2) {
        size += carried;
        t->half = size % 2 == 1 && task->to < t->end;
        if (t->half) t->left = bytes[--size];
        size = orr_gen_output_pack(bytes, size);
    }
    orr_gen_writer_submit(t->writer, size);
    t->clipped += task->clipped;
    t->next = task->to;
}

// Blocks of all streams, side by side, a buffer of each at a time.
static bool play(generator *g, const orr_gen_block *block, size_t n, orr_gen_fault *fault)
{
    const int64_t end_ns = block[n - 1].begin_ns + block[n - 1].length_ns;
    for (size_t k = 0; k < g->n_tracks; k++)
        for (size_t j = 0; j < n; j++)
            if (!orr_gen_stream_ready(g->track[k].stream, &block[j], fault)) return false;
    for (;;) {
        orr_gen_task task[ORR_GEN_STREAMS];
        track *of[ORR_GEN_STREAMS];
        size_t tasks = 0;
        for (size_t k = 0; k < g->n_tracks; k++) {
            track *t = &g->track[k];
            int64_t end = orr_gen_first_sample(end_ns, orr_gen_stream_plan_of(t->stream)->rate_hz);
            if (end > t->end) end = t->end;
            if (t->next >= end) continue;
            if (!begin_buffer(t, end, &task[tasks], fault)) return false;
            of[tasks++] = t;
        }
        if (tasks == 0) return true;
        orr_gen_crew_play(g->crew, block, n, task, tasks);
        for (size_t k = 0; k < tasks; k++) end_buffer(of[k], &task[k]);
    }
}

static bool run(generator *g, orr_gen_fault *fault)
{
    int64_t told = g->from_ns;
    for (int64_t t = g->from_ns; t < g->to_ns && !interrupted;) {
        const orr_gen_block *block;
        size_t n;
        if (!orr_gen_blocks_from(g->blocks, t, &block, &n, fault)) return false;
        const int64_t end = block[n - 1].begin_ns + block[n - 1].length_ns;
        // Signals are on their way for up to 0.3 s, from beyond geostationary orbits.
        if (!orr_gen_navigation_cover(g->navigation, t - NS_PER_S, end, fault)) return false;
        if (!play(g, block, n, fault)) return false;
        t = end;
        if (t - told < META_EVERY_S * (int64_t)NS_PER_S) continue;
        for (size_t k = 0; k < g->n_tracks; k++)
            if (!write_meta(g, &g->track[k], orr_gen_writer_done(g->track[k].writer), false, fault))
                return false;
        told = t;
    }
    return true;
}

static void summary(generator *g, const track *t, orr_gen_written w)
{
    char text[300];
    size_t heard;
    (void)orr_gen_stream_heard(t->stream, &heard);
    const uint64_t samples = samples_of(t, w.bytes);
    int n = snprintf(text, sizeof text, "%s: %llu samples (%.3f s), %zu channels", t->data,
                     (unsigned long long)samples,
                     (double)samples / orr_gen_stream_plan_of(t->stream)->rate_hz, heard);
    if (orr_gen_stream_mute(t->stream) > 0)
        n += snprintf(text + n, sizeof text - (size_t)n, ", %zu without a code",
                      orr_gen_stream_mute(t->stream));
    if (t->clipped > 0)
        n += snprintf(text + n, sizeof text - (size_t)n, ", %llu values clipped",
                      (unsigned long long)t->clipped);
    if (g->options.pace)
        snprintf(text + n, sizeof text - (size_t)n, ", %llu underruns, at most %.3f s late",
                 (unsigned long long)w.underruns, w.latest_s);
    say(g, text);
}

// The metadata at the end. Where samples have filled the disk the last of them make room for it.
static bool end_meta(const generator *g, const track *t, orr_gen_written *w, bool complete,
                     orr_gen_fault *fault)
{
    if (write_meta(g, t, *w, complete, fault)) return true;
    if ((errno != ENOSPC && errno != EDQUOT) || w->bytes < META_ROOM) return false;
    w->bytes -= META_ROOM;
    if (truncate(t->data, (off_t)w->bytes) != 0)
        return orr_gen_fail(fault, "%s: %s", t->data, strerror(errno));
    return write_meta(g, t, *w, false, fault);
}

// Ends all streams; what is wrong with the first that is wrong replaces a sentence that says less.
static bool finish(generator *g, bool good, orr_gen_fault *fault)
{
    const bool played = good;
    for (size_t k = 0; k < g->n_tracks; k++) {
        track *t = &g->track[k];
        if (t->writer == NULL) continue;
        orr_gen_written w;
        orr_gen_fault own = {{0}};
        const bool closed = orr_gen_writer_close(t->writer, !played && !interrupted, &w, &own);
        t->writer = NULL;
        const bool complete = closed && samples_of(t, w.bytes) == (uint64_t)(t->end - t->first);
        if (!closed && (good || strcmp(fault->text, "the samples cannot be written") == 0)) *fault = own;
        good = good && closed;
        if (!end_meta(g, t, &w, complete, &own) && good) *fault = own, good = false;
        summary(g, t, w);
    }
    return good;
}

static bool generate(generator *g, orr_gen_fault *fault)
{
    const orr_gen_options *o = &g->options;
    if (!orr_gen_link_open(o->url, o->patience_s, say, g, &g->link, &g->service, fault) ||
        !find_antenna(g, fault) || !choose_time(g, fault) ||
        !orr_gen_navigation_open(g->link, &g->service, &g->navigation, fault))
        return false;
    bool good = true;
    for (size_t k = 0; good && k < o->n_streams; k++) good = open_track(g, &o->stream[k], fault);
    uint8_t wanted[ORR_MSG_MAX_SIGNALS];
    size_t n = 0;
    for (size_t k = 0; k < g->service.n_signals; k++)
        for (size_t j = 0; j < g->n_tracks; j++)
            if (orr_gen_stream_plan_of(g->track[j].stream)->signals >> k & 1) {
                wanted[n++] = (uint8_t)k;
                break;
            }
    good = good && orr_gen_blocks_open(g->link, &g->service, g->antenna, wanted, n, &g->blocks, fault) &&
           orr_gen_crew_open(o->threads, &g->crew, fault) && run(g, fault);
    if (good && g->crew != NULL && orr_gen_crew_silent(g->crew) > 0)
        say(g, "some data components had no navigation data and were sent without: the service has none for "
               "them");
    return finish(g, good, fault);
}

int main(int argc, char **argv)
{
    static generator g;
    const int status = orr_gen_options_read(argc, argv, &g.options);
    if (status >= 0) return status;
    const struct sigaction act = {.sa_handler = on_signal};
    sigaction(SIGINT, &act, NULL);
    sigaction(SIGTERM, &act, NULL);
    signal(SIGPIPE, SIG_IGN); // writes fail instead, and say why
    signal(SIGXFSZ, SIG_IGN);
    orr_gen_fault fault = {{0}};
    const bool good = generate(&g, &fault);
    if (!good) fprintf(stderr, "orrery-generator: %s\n", fault.text);
    orr_gen_crew_close(g.crew);
    for (size_t k = 0; k < g.n_tracks; k++) orr_gen_stream_close(g.track[k].stream);
    orr_gen_blocks_close(g.blocks);
    orr_gen_navigation_close(g.navigation);
    orr_gen_link_close(g.link);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/play/stream.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// The sum's own units: a signal of ORR_GEN_REFERENCE_DBW, or of the C/N0 that was asked for, has this amplitude; one 14 dB
// stronger is the strongest that the mixer plays.
#define SUM_AMPLITUDE 1600.0
#define SUM_LARGEST 32000.0 // of a group of channels whose sum is held in 16 bits

typedef struct source {
    bool tried;
    orr_gen_voice *voice;
    size_t heard; // 1 + place of what is being heard; 0: not
} source;

struct orr_gen_stream {
    orr_gen_stream_plan plan;
    const orr_gen_service *service;
    const orr_gen_navigation *navigation;
    const orr_gen_kernel *kernel;
    orr_gen_noise *noise;
    orr_gen_output output;
    double sum_for_strength; // amplitude in the sum of a signal of 0 dBW
    source source[ORR_MSG_MAX_SIGNALS][100];
    size_t n_heard, heard_capacity, mute;
    orr_gen_heard *heard;
};

const char *orr_gen_stream_lacks(const orr_gen_service *service, size_t signal, uint32_t rate_hz,
                                 int64_t centre_hz, bool wide)
{
    const orr_gen_signal_info *s = &service->signal[signal];
    const orr_gen_played p = orr_gen_played_of(s);
    if (!p.known) return "cannot be played: the generator has no codes for it";
    if (p.sub_least > ORR_GEN_CHIPS_IN_SAMPLE * (double)rate_hz)
        return "needs more samples a second: 8/7 of its chips at least";
    const double fdma = s->channel_hz * 7; // GLONASS' channels -7 to 6
    const double lobe = (wide ? 1.0 : 0.5) * p.sub_least;
    const double low = s->carrier_hz - fdma - lobe, high = s->carrier_hz + s->channel_hz * 6 + lobe;
    const double half = rate_hz / 2.0;
    if (low < (double)centre_hz - half || high > (double)centre_hz + half)
        return wide ? "has its main lobe partly beyond the stream's edges" : "lies beyond the stream's edges";
    return NULL;
}

// What a format holds: the standard deviation of noise, and without noise the amplitude of a signal at the reference.
static void level(orr_gen_stream *s)
{
    static const double sigma[] = {
        [ORR_GEN_I8] = 24, [ORR_GEN_I16] = 2000, [ORR_GEN_I2] = 1, [ORR_GEN_F32] = 0.25};
    static const double alone[] = {
        [ORR_GEN_I8] = 8, [ORR_GEN_I16] = 1000, [ORR_GEN_I2] = 1, [ORR_GEN_F32] = 0.03};
    const orr_gen_stream_plan *p = &s->plan;
    const double cn0 =
        p->cn0_dbhz != ORR_GEN_NO_LEVEL ? p->cn0_dbhz : ORR_GEN_REFERENCE_DBW - ORR_GEN_NOISE_DBWHZ;
    // Power A^2 in a noise of 2 sigma^2 over the rate: A = sigma sqrt(2 C/N0 / rate).
    const double in_sigma = sqrt(2 * pow(10, cn0 / 10) / p->rate_hz);
    double amplitude = p->amplitude != ORR_GEN_NO_LEVEL ? p->amplitude
                       : p->noise                       ? sigma[p->format] * in_sigma
                                                        : alone[p->format];
    s->output = (orr_gen_output){
        .format = p->format, .gain = amplitude / SUM_AMPLITUDE, .noise = s->noise, .seed = p->seed};
    if (p->noise) s->output.sigma = amplitude / in_sigma;
}

bool orr_gen_stream_open(const orr_gen_service *service, const orr_gen_navigation *navigation,
                         const orr_gen_stream_plan *plan, orr_gen_stream **stream, orr_gen_fault *fault)
{
    orr_gen_stream *s = calloc(1, sizeof *s);
    *stream = s;
    if (s == NULL) return orr_gen_fail(fault, "out of memory");
    s->plan = *plan;
    s->service = service;
    s->navigation = navigation;
    s->kernel = orr_gen_kernel_best();
    s->sum_for_strength = SUM_AMPLITUDE * pow(10, -ORR_GEN_REFERENCE_DBW / 20);
    if (plan->noise) {
        s->noise = malloc(sizeof *s->noise);
        if (s->noise == NULL) return orr_gen_fail(fault, "out of memory");
        orr_gen_noise_init(s->noise);
    }
    level(s);
    return true;
}

void orr_gen_stream_close(orr_gen_stream *stream)
{
    if (stream == NULL) return;
    for (size_t k = 0; k < ORR_MSG_MAX_SIGNALS; k++)
        for (size_t n = 0; n < 100; n++) orr_gen_voice_close(stream->source[k][n].voice);
    free(stream->noise);
    free(stream->heard);
    free(stream);
}

static bool hears(const orr_gen_stream *s, const orr_gen_channel *c)
{
    return (s->plan.signals >> c->signal & 1) && c->number < 100;
}

static bool note_heard(orr_gen_stream *s, source *from, const orr_gen_channel *c, const orr_gen_block *b,
                       orr_gen_fault *fault)
{
    const int64_t end = b->begin_ns + b->length_ns;
    if (from->heard > 0 && s->heard[from->heard - 1].to_ns == b->begin_ns) {
        s->heard[from->heard - 1].to_ns = end;
        return true;
    }
    if (from->heard > 0 && s->heard[from->heard - 1].to_ns == end) return true; // made ready before
    if (s->n_heard == s->heard_capacity) {
        const size_t capacity = 2 * s->heard_capacity + 64;
        orr_gen_heard *larger = realloc(s->heard, capacity * sizeof *larger);
        if (larger == NULL) return orr_gen_fail(fault, "out of memory");
        s->heard = larger;
        s->heard_capacity = capacity;
    }
    s->heard[s->n_heard++] = (orr_gen_heard){c->system, c->number, c->signal, b->begin_ns, end};
    from->heard = s->n_heard;
    return true;
}

bool orr_gen_stream_ready(orr_gen_stream *stream, const orr_gen_block *block, orr_gen_fault *fault)
{
    for (size_t k = 0; k < block->n; k++) {
        const orr_gen_channel *c = &block->channel[k];
        if (!hears(stream, c)) continue;
        source *from = &stream->source[c->signal][c->number];
        if (!from->tried && !orr_gen_voice_open(&stream->service->signal[c->signal], c->number,
                                                stream->plan.rate_hz, &from->voice))
            stream->mute++;
        from->tried = true;
        if (from->voice != NULL && !note_heard(stream, from, c, block, fault)) return false;
    }
    return true;
}

orr_gen_span orr_gen_stream_span(const orr_gen_stream *stream, const orr_gen_block *block, int64_t at)
{
    const uint32_t rate = stream->plan.rate_hz;
    const int64_t begin = orr_gen_first_sample(block->begin_ns, rate);
    const int64_t end = orr_gen_first_sample(block->begin_ns + block->length_ns, rate);
    int64_t first = at - at % ORR_GEN_PIECE, to = first + ORR_GEN_PIECE;
    if (first < begin) first = begin;
    if (to > end) to = end;
    return (orr_gen_span){block, first, (uint32_t)(to - first)};
}

// Of a channel in the sum's units.
static double amplitude_of(const orr_gen_stream *s, const orr_gen_channel *c)
{
    const double a =
        s->plan.cn0_dbhz != ORR_GEN_NO_LEVEL ? SUM_AMPLITUDE * c->share : c->strength * s->sum_for_strength;
    return a < ORR_GEN_AMPLITUDE / 1.5 ? a : ORR_GEN_AMPLITUDE / 1.5; // a part may have 1.35 of it
}

// What plays a channel; NULL: it is not to be heard.
static const orr_gen_voice *voice_of(const orr_gen_stream *s, const orr_gen_channel *c)
{
    return hears(s, c) ? s->source[c->signal][c->number].voice : NULL;
}

size_t orr_gen_stream_group(const orr_gen_stream *stream, const orr_gen_block *block, size_t from,
                            double *most)
{
    double group = 0;
    size_t k = from;
    for (; k < block->n; k++) {
        const orr_gen_voice *voice = voice_of(stream, &block->channel[k]);
        if (voice == NULL) continue;
        const double more = orr_gen_voice_peak(voice) * amplitude_of(stream, &block->channel[k]) + 4;
        if (group + more > SUM_LARGEST) break;
        group += more;
    }
    *most += group;
    return k;
}

void orr_gen_stream_mix(const orr_gen_stream *stream, const orr_gen_span *span, size_t from, size_t to,
                        orr_gen_worker *worker)
{
    const orr_gen_piece piece = {.first = span->first,
                                 .n = span->n,
                                 .rate_hz = stream->plan.rate_hz,
                                 .centre_hz = stream->plan.centre_hz,
                                 .kernel = stream->kernel,
                                 .navigation = stream->navigation,
                                 .scratch = &worker->scratch,
                                 .re = worker->re,
                                 .im = worker->im};
    const size_t whole = (span->n + ORR_GEN_GROUP - 1) / ORR_GEN_GROUP * ORR_GEN_GROUP;
    memset(worker->re, 0, whole * sizeof worker->re[0]);
    memset(worker->im, 0, whole * sizeof worker->im[0]);
    for (size_t k = from; k < to; k++) {
        const orr_gen_channel *c = &span->block->channel[k];
        const orr_gen_voice *voice = voice_of(stream, c);
        if (voice != NULL) orr_gen_voice_play(voice, c, amplitude_of(stream, c), &piece);
    }
}

void orr_gen_stream_add(const orr_gen_stream *stream, const orr_gen_span *span, bool first,
                        const orr_gen_worker *worker, int32_t *sum_re, int32_t *sum_im)
{
    stream->kernel->add(first, worker->re, span->n, sum_re);
    stream->kernel->add(first, worker->im, span->n, sum_im);
}

uint64_t orr_gen_stream_write(const orr_gen_stream *stream, const orr_gen_span *span,
                              const orr_gen_sums *sums, uint8_t *bytes)
{
    return stream->kernel->write(&stream->output, sums, span->first, span->n, bytes);
}

const orr_gen_heard *orr_gen_stream_heard(const orr_gen_stream *stream, size_t *n)
{
    *n = stream->n_heard;
    return stream->heard;
}

size_t orr_gen_stream_mute(const orr_gen_stream *stream) { return stream->mute; }

const orr_gen_stream_plan *orr_gen_stream_plan_of(const orr_gen_stream *stream) { return &stream->plan; }

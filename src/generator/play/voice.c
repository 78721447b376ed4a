// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/play/voice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "src/generator/codes/codes.h"

#define NS_PER_MS 1000000
#define COMPONENTS 3
#define BDT_BEHIND_MS 14000 // BeiDou's time is behind GPS time

typedef enum shape { PLAIN, CBOC, L2C } shape;
typedef enum kind { PILOT, DATA } kind;

typedef struct component {
    orr_gen_code code;
    unsigned sub;
    double power;
    unsigned quarter;
    kind kind;
} component;

typedef struct signal {
    char system;
    const char *name;
    uint32_t chips_per_s;
    unsigned period_ms;
    shape shape;
    component component[COMPONENTS + 1]; // one of no power ends the list
} signal;

static const signal signals[] = {
#define ORR_COMPONENT(code, sub, power, quarter, kind) {ORR_GEN_##code, sub, power, quarter, kind},
#define ORR_PLAYED(system, name, chips_per_s, period_ms, shape, components)                                  \
    {system, name, chips_per_s, period_ms, shape, {components}},
#include "src/generator/play/signals.def"
};

// One pass of the mixer.
typedef struct part {
    unsigned sub;
    bool data;
    orr_gen_chips kind; // of the tables
    double gain;        // times the signal's amplitude
    uint64_t quarter;   // of phase, 2^64 a cycle
    size_t chips;       // sub-chips of a period
    // The period's sub-chips, for a product of symbol and secondary chip of 1 and of -1; the second only where it is not the
    // first with the other sign.
    int8_t *table[2];
    size_t n_secondary;
    int8_t *secondary;
    size_t secondary_from; // periods by which its begin is behind that of GPS time
} part;

struct orr_gen_voice {
    const signal *signal;
    size_t place, n;
    part part[COMPONENTS];
    int8_t *cm, *cl; // of L2C
};

static const signal *find(const orr_gen_signal_info *info)
{
    for (size_t k = 0; k < sizeof signals / sizeof signals[0]; k++)
        if (signals[k].system == info->system && strcmp(signals[k].name, info->name) == 0) return &signals[k];
    return NULL;
}

orr_gen_played orr_gen_played_of(const orr_gen_signal_info *info)
{
    orr_gen_played p = {0};
    const signal *s = find(info);
    if (s == NULL) return p;
    p = (orr_gen_played){true, s->chips_per_s, UINT32_MAX};
    for (size_t k = 0; s->component[k].power > 0; k++) {
        const uint32_t sub = s->component[k].sub * s->chips_per_s;
        if (sub < p.sub_least) p.sub_least = sub;
    }
    return p;
}

// RINEX numbers J01 to J10 and S20 to S58 after codes 193 and 120.
static unsigned code_number(char system, unsigned number)
{
    return system == 'J' ? 192 + number : system == 'S' ? 100 + number : number;
}

static int8_t *padded(size_t n) { return malloc(n + ORR_GEN_CHIPS_BEYOND); }

static void pad(int8_t *table, size_t n)
{
    for (size_t k = 0; k < ORR_GEN_CHIPS_BEYOND; k++) table[n + k] = table[k];
}

// Sub-chip j of a chip: a square wave that begins with +1.
static int carrier_of(unsigned sub, size_t j) { return sub > 1 && j % 2 == 1 ? -1 : 1; }

static bool fill_plain(part *p, const int8_t *chips, size_t n)
{
    p->chips = n * p->sub;
    p->table[0] = padded(p->chips);
    if (p->table[0] == NULL) return false;
    for (size_t k = 0; k < n; k++)
        for (size_t j = 0; j < p->sub; j++)
            p->table[0][k * p->sub + j] = (int8_t)(chips[k] * carrier_of(p->sub, j));
    pad(p->table[0], p->chips);
    return true;
}

// E1: data times b (a sc1 + b sc6) less pilot times c (a sc1 - b sc6), a^2 = 10/11, b^2 = 1/11 (OS SIS ICD eq. 5, 10, 11).
// Where both chips agree the sum is 2 b sc6, where they differ 2 a sc1: four levels. Without sc6, three.
static bool fill_cboc(part *p, const int8_t *data, const int8_t *pilot, size_t n)
{
    const double a = sqrt(10.0 / 11), b = sqrt(1.0 / 11), share = sqrt(0.5);
    p->chips = n * p->sub;
    const bool levels = p->sub > 2;
    p->kind = levels ? ORR_GEN_LEVELS : ORR_GEN_TERNARY;
    p->gain = 2 * share * a * (levels ? 128.0 / 127 : 1.0);
    const int high = levels ? 127 : 1, low = levels ? (int)(127 * b / a + 0.5) : 0;
    for (int c = 0; c < 2; c++) {
        p->table[c] = padded(p->chips);
        if (p->table[c] == NULL) return false;
        for (size_t k = 0; k < n; k++)
            for (size_t j = 0; j < p->sub; j++) {
                const bool differ = data[k] != (c ? -pilot[k] : pilot[k]);
                const int wave = differ ? high * (j < p->sub / 2 ? 1 : -1) : low * carrier_of(p->sub, j);
                p->table[c][k * p->sub + j] = (int8_t)(data[k] * wave);
            }
        pad(p->table[c], p->chips);
    }
    return true;
}

static bool fill_secondary(part *p, const orr_gen_voice *v, orr_gen_code code, unsigned prn)
{
    int8_t chips[ORR_GEN_SECONDARY_LARGEST];
    const bool none = code == ORR_GEN_B1I && orr_gen_b1i_is_d2(prn);
    chips[0] = 1;
    p->n_secondary = none ? 1 : orr_gen_secondary_fill(code, prn, chips);
    if (p->n_secondary == 0) return false;
    p->secondary = malloc(p->n_secondary);
    if (p->secondary == NULL) return false;
    memcpy(p->secondary, chips, p->n_secondary);
    if (v->signal->system == 'C') p->secondary_from = BDT_BEHIND_MS / v->signal->period_ms % p->n_secondary;
    return true;
}

static bool make_parts(orr_gen_voice *v, unsigned prn, double most_sub)
{
    const signal *s = v->signal;
    const size_t n = orr_gen_code_chips(s->component[0].code);
    int8_t chips[2][10230];
    if (s->shape == L2C) {
        v->cm = malloc(n);
        v->cl = malloc(ORR_GEN_CHIPS_LARGEST);
        v->n = 1;
        v->part[0] = (part){.sub = 1, .data = true, .gain = 1, .chips = 2 * n};
        return v->cm != NULL && v->cl != NULL && orr_gen_code_fill(ORR_GEN_L2CM, prn, v->cm) &&
               orr_gen_code_fill(ORR_GEN_L2CL, prn, v->cl) &&
               fill_secondary(&v->part[0], v, ORR_GEN_L2CM, prn);
    }
    if (s->shape == CBOC) {
        part *p = &v->part[v->n++];
        *p = (part){.sub = 12.0 * s->chips_per_s <= most_sub ? 12 : 2, .data = true};
        return orr_gen_code_fill(s->component[0].code, prn, chips[0]) &&
               orr_gen_code_fill(s->component[1].code, prn, chips[1]) &&
               fill_cboc(p, chips[0], chips[1], n) && fill_secondary(p, v, s->component[1].code, prn);
    }
    for (size_t k = 0; s->component[k].power > 0; k++) {
        const component *c = &s->component[k];
        if (c->sub * (double)s->chips_per_s > most_sub) continue;
        part *p = &v->part[v->n++];
        *p = (part){.sub = c->sub,
                    .data = c->kind == DATA,
                    .gain = sqrt(c->power),
                    .quarter = (uint64_t)c->quarter << 62};
        if (!orr_gen_code_fill(c->code, prn, chips[0]) || !fill_plain(p, chips[0], n) ||
            !fill_secondary(p, v, c->code, prn))
            return false;
    }
    return v->n > 0;
}

bool orr_gen_voice_open(const orr_gen_signal_info *info, unsigned number, uint32_t rate_hz,
                        orr_gen_voice **voice)
{
    orr_gen_voice *v = calloc(1, sizeof *v);
    *voice = v;
    if (v == NULL) return false;
    v->signal = find(info);
    v->place = info->number;
    if (v->signal != NULL &&
        make_parts(v, code_number(info->system, number), ORR_GEN_CHIPS_IN_SAMPLE * (double)rate_hz))
        return true;
    orr_gen_voice_close(v);
    *voice = NULL;
    return false;
}

void orr_gen_voice_close(orr_gen_voice *voice)
{
    if (voice == NULL) return;
    for (size_t k = 0; k < COMPONENTS; k++) {
        free(voice->part[k].table[0]);
        free(voice->part[k].table[1]);
        free(voice->part[k].secondary);
    }
    free(voice->cm);
    free(voice->cl);
    free(voice);
}

double orr_gen_voice_peak(const orr_gen_voice *voice)
{
    double axis[2] = {0, 0}; // in phase with the carrier, and a quarter turn from it
    for (size_t k = 0; k < voice->n; k++) axis[voice->part[k].quarter >> 62 & 1] += voice->part[k].gain;
    return sqrt(axis[0] * axis[0] + axis[1] * axis[1]);
}

// What is being played: a part of a channel in a piece.
typedef struct playing {
    const orr_gen_voice *voice;
    const part *part;
    const orr_gen_channel *channel;
    const orr_gen_piece *piece;
} playing;

// Chips from..to of a period of L2C: CM, turned by the symbol, and CL by turns. Two periods have room at once.
static const int8_t *fill_l2c(const playing *p, int64_t period, int symbol, size_t from, size_t to)
{
    const orr_gen_voice *v = p->voice;
    const int8_t *cl = v->cl + (size_t)(period % 75) * (v->part[0].chips / 2);
    int8_t *chips = p->piece->scratch->chips[period % 2];
    for (size_t k = from / 2; k < (to + 1) / 2; k++) {
        chips[2 * k] = (int8_t)(symbol * v->cm[k]);
        chips[2 * k + 1] = cl[k];
    }
    return chips;
}

// The chips of one period and the sign they are played with.
static orr_gen_period period_of(void *user, int64_t number, size_t from, size_t to)
{
    const playing *at = user;
    const part *p = at->part;
    const orr_gen_voice *v = at->voice;
    const orr_gen_channel *c = at->channel;
    int symbol = 1;
    if (p->data) {
        symbol = orr_gen_navigation_symbol(at->piece->navigation, c->signal, c->system, c->number,
                                           number * v->signal->period_ms * NS_PER_MS);
        if (symbol == 0) at->piece->scratch->silent++, symbol = 1;
    }
    const int64_t n = (int64_t)p->n_secondary;
    const int secondary = p->secondary[((number - (int64_t)p->secondary_from) % n + n) % n];
    switch (v->signal->shape) {
    case CBOC:
        return (orr_gen_period){p->table[symbol * secondary < 0], symbol};
    case L2C:
        return (orr_gen_period){fill_l2c(at, number, symbol, from, to), 1};
    default:
        return (orr_gen_period){p->table[0], symbol * secondary};
    }
}

static void play_part(const orr_gen_voice *v, const part *p, const orr_gen_channel *channel, double amplitude,
                      const orr_gen_piece *piece)
{
    const orr_gen_tuning tuning = {piece->rate_hz,
                                   (int64_t)(channel->cubics.carrier_hz + 0.5) - piece->centre_hz,
                                   p->sub * v->signal->chips_per_s};
    const size_t groups = (piece->n + ORR_GEN_GROUP - 1) / ORR_GEN_GROUP;
    orr_gen_oscillator o;
    orr_gen_carrier carrier;
    orr_gen_oscillators(&channel->cubics, &tuning, piece->first, piece->n, &o);
    piece->kernel->carrier(o.carrier + p->quarter, o.carrier_step, amplitude * p->gain, groups, &carrier);
    playing at = {v, p, channel, piece};
    const uint64_t length = (uint64_t)p->chips << ORR_GEN_CODE_BITS;
    const orr_gen_code_at code = {.number =
                                      o.code_s * (1000 / v->signal->period_ms) + (int64_t)(o.code / length),
                                  .chips = p->chips,
                                  .code = o.code % length,
                                  .code_step = o.code_step,
                                  .kind = p->kind,
                                  .period = period_of,
                                  .user = &at};
    orr_gen_periods_mix(piece->kernel->mix, &carrier, &code, groups, piece->re, piece->im);
}

void orr_gen_voice_play(const orr_gen_voice *voice, const orr_gen_channel *channel, double amplitude,
                        const orr_gen_piece *piece)
{
    for (size_t k = 0; k < voice->n; k++) play_part(voice, &voice->part[k], channel, amplitude, piece);
}

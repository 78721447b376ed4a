// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/options.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "src/generator/play/stream.h"

#define USAGE_STATUS 2
#define GPS_EPOCH_UNIX 315964800

static const char help[] =
    "orrery-generator: baseband samples of GNSS signals from a service's channels\n"
    "\n"
    "usage: orrery-generator URL -o FILE [options]\n"
    "\n"
    "Connects to an Orrery service (orrery serve), asks for the blocks of an antenna's channels and for the "
    "navigation data, and\n"
    "writes complex samples: FILE.sigmf-data, and FILE.sigmf-meta that describes them. For files, pipes and "
    "conducted tests\n"
    "only: to radiate such signals is forbidden nearly everywhere.\n"
    "\n"
    "  URL                    tcp://HOST:PORT or unix:PATH\n"
    "  -o, --output FILE      where samples go; - is standard output, without metadata\n"
    "  -r, --rate HZ          samples a second, e.g. 5M; 5M by default\n"
    "  -c, --centre HZ        centre frequency, e.g. 1575.42M; by default the carrier of the first signal\n"
    "  -s, --signals LIST     signals, e.g. G:L1CA,E:E1; by default all that fit between the stream's edges\n"
    "  -f, --format FORMAT    i8 (default), i16, i2 (two samples a byte) or f32\n"
    "      --stream K=V;...   a stream of its own, in place of the five above: "
    "output=FILE;rate=HZ;centre=HZ;signals=LIST;format=F.\n"
    "                         Several share one time base\n"
    "  -a, --antenna NAME     name or number of the antenna; the first by default\n"
    "      --from TIME        begin, GPS time, e.g. 2024-02-04T12:00:00; by default the first whole second "
    "that is served\n"
    "  -n, --seconds S        how long; by default to the end of what is served\n"
    "      --noise            thermal noise, by which each signal has the C/N0 that its power says (density "
    "-202.5 dBW/Hz)\n"
    "      --seed N           seed of the noise; 1 by default\n"
    "      --cn0 DBHZ         every signal at this C/N0, whatever its power; echoes as much weaker as they "
    "are\n"
    "      --amplitude A      amplitude of a signal of -158.5 dBW (or of --cn0) in units of the output\n"
    "      --pace             at the pace of the clock; late slices are counted\n"
    "      --patience S       how long to wait for a service that is not there or has gone; 30 by default\n"
    "  -t, --threads N        by default one a processor\n"
    "  -q, --quiet            says nothing but errors\n"
    "      --version, --help\n";

static int wrong(const char *format, const char *value)
{
    fprintf(stderr, "orrery-generator: ");
    fprintf(stderr, format, value);
    fprintf(stderr, "; orrery-generator --help lists the options\n");
    return USAGE_STATUS;
}

// A number with k, M or G behind it.
static bool number(const char *text, double *out)
{
    char *end;
    *out = strtod(text, &end);
    if (end == text) return false;
    if (*end == 'k' || *end == 'K')
        *out *= 1e3, end++;
    else if (*end == 'M')
        *out *= 1e6, end++;
    else if (*end == 'G')
        *out *= 1e9, end++;
    return *end == '\0' && isfinite(*out);
}

// yyyy-mm-ddThh:mm:ss[.fraction] of the GPS scale.
static bool instant(const char *text, int64_t *out)
{
    int y, mo, d, h, mi, used = 0;
    double s;
    if (sscanf(text, "%4d-%2d-%2dT%2d:%2d:%lf%n", &y, &mo, &d, &h, &mi, &s, &used) != 6 || text[used] != '\0')
        return false;
    if (y < 1980 || y > 2200 || mo < 1 || mo > 12 || d < 1 || d > 31 || h < 0 || h > 23 || mi < 0 ||
        mi > 59 || s < 0 || s >= 60)
        return false;
    // Days since 1970-01-01 of the Gregorian calendar.
    const int64_t yy = mo <= 2 ? y - 1 : y, era = yy / 400, of_era = yy - era * 400;
    const int64_t of_year = (153 * (mo + (mo > 2 ? -3 : 9)) + 2) / 5 + d - 1;
    const int64_t days = era * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
    const int64_t whole = days * 86400 + h * 3600 + mi * 60 - GPS_EPOCH_UNIX;
    *out = whole * 1000000000 + (int64_t)(s * 1e9 + 0.5);
    return true;
}

static bool format_of(const char *text, orr_gen_format *out)
{
    static const char *const name[] = {
        [ORR_GEN_I8] = "i8", [ORR_GEN_I16] = "i16", [ORR_GEN_I2] = "i2", [ORR_GEN_F32] = "f32"};
    for (size_t k = 0; k < sizeof name / sizeof name[0]; k++)
        if (strcmp(text, name[k]) == 0) {
            *out = (orr_gen_format)k;
            return true;
        }
    return false;
}

// One key of a stream; NULL where it is good, else what is wrong.
static const char *stream_key(orr_gen_stream_options *s, const char *key, const char *value)
{
    if (strcmp(key, "output") == 0)
        s->output = value;
    else if (strcmp(key, "signals") == 0)
        s->signals = value;
    else if (strcmp(key, "rate") == 0) {
        if (!number(value, &s->rate_hz) || s->rate_hz < 100e3 || s->rate_hz > 200e6 ||
            s->rate_hz != floor(s->rate_hz))
            return "%s is no rate: a whole number of samples a second, 100k to 200M";
    } else if (strcmp(key, "centre") == 0) {
        if (!number(value, &s->centre_hz) || s->centre_hz < 100e6 || s->centre_hz > 3e9 ||
            s->centre_hz != floor(s->centre_hz))
            return "%s is no centre frequency: whole hertz, 100M to 3G";
    } else if (strcmp(key, "format") == 0) {
        if (!format_of(value, &s->format)) return "%s is no format: i8, i16, i2 or f32";
    } else
        return "a stream has no such key as %s: output, rate, centre, signals, format";
    return NULL;
}

static int stream_option(orr_gen_options *o, char *text)
{
    if (o->n_streams == ORR_GEN_STREAMS) return wrong("%s: eight streams are the most", text);
    orr_gen_stream_options *s = &o->stream[o->n_streams++];
    *s = (orr_gen_stream_options){.rate_hz = 5e6};
    for (char *rest = text, *item; (item = strtok_r(rest, ";", &rest)) != NULL;) {
        char *equals = strchr(item, '=');
        if (equals == NULL) return wrong("--stream: %s has no value: output=FILE;rate=HZ;...", item);
        *equals = '\0';
        const char *bad = stream_key(s, item, equals + 1);
        if (bad != NULL) return wrong(bad, *bad == '%' ? equals + 1 : item);
    }
    if (s->output == NULL) return wrong("%s: --stream needs output=FILE", "a stream without an output");
    return -1;
}

enum { FROM = 256, NOISE, SEED, CN0, AMPLITUDE, PACE, PATIENCE, STREAM, VERSION, HELP };

static const struct option longs[] = {{"output", required_argument, NULL, 'o'},
                                      {"rate", required_argument, NULL, 'r'},
                                      {"centre", required_argument, NULL, 'c'},
                                      {"signals", required_argument, NULL, 's'},
                                      {"format", required_argument, NULL, 'f'},
                                      {"stream", required_argument, NULL, STREAM},
                                      {"antenna", required_argument, NULL, 'a'},
                                      {"from", required_argument, NULL, FROM},
                                      {"seconds", required_argument, NULL, 'n'},
                                      {"noise", no_argument, NULL, NOISE},
                                      {"seed", required_argument, NULL, SEED},
                                      {"cn0", required_argument, NULL, CN0},
                                      {"amplitude", required_argument, NULL, AMPLITUDE},
                                      {"pace", no_argument, NULL, PACE},
                                      {"patience", required_argument, NULL, PATIENCE},
                                      {"threads", required_argument, NULL, 't'},
                                      {"quiet", no_argument, NULL, 'q'},
                                      {"version", no_argument, NULL, VERSION},
                                      {"help", no_argument, NULL, HELP},
                                      {NULL, 0, NULL, 0}};

static int ranged(const char *text, double least, double most, double *out, const char *what)
{
    if (number(text, out) && *out >= least && *out <= most) return -1;
    return wrong(what, text);
}

static int one_option(orr_gen_options *o, orr_gen_stream_options *single, int c, char *value)
{
    double x;
    int status = -1;
    const char *bad = NULL;
    switch (c) {
    case 'o':
        bad = stream_key(single, "output", value);
        break;
    case 'r':
        bad = stream_key(single, "rate", value);
        break;
    case 'c':
        bad = stream_key(single, "centre", value);
        break;
    case 's':
        bad = stream_key(single, "signals", value);
        break;
    case 'f':
        bad = stream_key(single, "format", value);
        break;
    case STREAM:
        return stream_option(o, value);
    case 'a':
        o->antenna = value;
        break;
    case FROM:
        return instant(value, &o->from_ns) ? -1
                                           : wrong("--from: %s is no instant: 2024-02-04T12:00:00", value);
    case 'n':
        return ranged(value, 1e-3, 1e7, &o->seconds, "--seconds: %s is no length: 0.001 to 10M");
    case NOISE:
        o->noise = true;
        break;
    case SEED:
        status = ranged(value, 0, 9e15, &x, "--seed: %s is no seed: a whole number");
        o->seed = status == -1 ? (uint64_t)x : 0;
        break;
    case CN0:
        return ranged(value, 0, 80, &o->cn0_dbhz, "--cn0: %s is no C/N0: 0 to 80 dB-Hz");
    case AMPLITUDE:
        return ranged(value, 1e-6, 32767, &o->amplitude, "--amplitude: %s is no amplitude: up to 32767");
    case PACE:
        o->pace = true;
        break;
    case PATIENCE:
        return ranged(value, 0, 86400, &o->patience_s, "--patience: %s is no length: 0 to 86400 s");
    case 't':
        status = ranged(value, 1, 64, &x, "--threads: %s is no number of threads: 1 to 64");
        o->threads = status == -1 ? (unsigned)x : 1;
        break;
    case 'q':
        o->quiet = true;
        break;
    case VERSION:
        printf("orrery-generator %s\n", ORR_VERSION);
        return 0;
    case HELP:
        fputs(help, stdout);
        return 0;
    default:
        fprintf(stderr, "orrery-generator --help lists the options\n");
        return USAGE_STATUS;
    }
    return bad != NULL ? wrong(bad, value) : status;
}

int orr_gen_options_read(int argc, char **argv, orr_gen_options *options)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    *options = (orr_gen_options){.from_ns = INT64_MIN,
                                 .seed = 1,
                                 .cn0_dbhz = ORR_GEN_NO_LEVEL,
                                 .amplitude = ORR_GEN_NO_LEVEL,
                                 .patience_s = 30,
                                 .threads = processors > 0 && processors < 64 ? (unsigned)processors : 1};
    orr_gen_stream_options single = {.rate_hz = 5e6};
    for (int c; (c = getopt_long(argc, argv, "o:r:c:s:f:a:n:t:q", longs, NULL)) != -1;) {
        const int status = one_option(options, &single, c, optarg);
        if (status >= 0) return status;
    }
    if (optind >= argc) return wrong("%s", "the URL of a service is wanted: tcp://HOST:PORT or unix:PATH");
    if (optind + 1 < argc) return wrong("%s is one operand too many", argv[optind + 1]);
    options->url = argv[optind];
    if (single.output != NULL && options->n_streams > 0)
        return wrong("%s: --output or --stream, not both", single.output);
    if (single.output != NULL) options->stream[options->n_streams++] = single;
    if (options->n_streams == 0)
        return wrong("%s", "where the samples go is wanted: -o FILE, or -o - for standard output");
    return -1;
}

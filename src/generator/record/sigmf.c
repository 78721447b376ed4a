// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/generator/record/sigmf.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define NS_PER_S 1000000000
#define GPS_EPOCH_UNIX 315964800 // 1980-01-06T00:00:00 UTC

static void put_text(FILE *f, const char *text)
{
    fputc('"', f);
    for (const unsigned char *c = (const unsigned char *)text; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(f, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(f, "\\u%04x", *c);
        else
            fputc(*c, f);
    }
    fputc('"', f);
}

// UTC of a sample, to the nanosecond.
static void put_instant(FILE *f, const orr_gen_service *s, int64_t sample, uint32_t rate)
{
    const int64_t second = sample / rate, rest = sample % rate;
    const int64_t ns = (int64_t)((double)rest * 1e9 / rate + 0.5);
    const bool next = s->leap.next != INT64_MIN && second * NS_PER_S >= s->leap.next;
    const time_t t = (time_t)(second + GPS_EPOCH_UNIX - (next ? s->leap.next_gps_utc_s : s->leap.gps_utc_s));
    struct tm utc;
    char day[40];
    gmtime_r(&t, &utc);
    strftime(day, sizeof day, "%Y-%m-%dT%H:%M:%S", &utc);
    fprintf(f, "\"%s.%09lldZ\"", day, (long long)(ns > 999999999 ? 999999999 : ns));
}

static void put_global(FILE *f, const orr_gen_recording *r)
{
    static const char *const type[] = {
        [ORR_GEN_I8] = "ci8", [ORR_GEN_I16] = "ci16_le", [ORR_GEN_I2] = "ru8", [ORR_GEN_F32] = "cf32_le"};
    const orr_gen_stream_plan *p = orr_gen_stream_plan_of(r->stream);
    fprintf(f, "  \"global\": {\n    \"core:version\": \"1.2.0\",\n    \"core:datatype\": \"%s\",\n",
            type[p->format]);
    // Of packed samples, which SigMF has no name for, a byte is what is counted: two samples.
    fprintf(f, "    \"core:sample_rate\": %.17g,\n",
            p->format == ORR_GEN_I2 ? p->rate_hz / 2.0 : (double)p->rate_hz);
    fprintf(f, "    \"core:recorder\": \"orrery-generator %s\",\n    \"core:description\": ", ORR_VERSION);
    put_text(f, r->service->title[0] != '\0' ? r->service->title : "GNSS signals, made");
    fprintf(f, ",\n    \"core:dataset\": ");
    put_text(f, r->data_name);
    fprintf(f, ",\n    \"core:extensions\": [{\"name\": \"orrery\", \"version\": \"1.0.0\", \"optional\": "
               "true}],\n");
    fprintf(f, "    \"orrery:antenna\": ");
    put_text(f, r->antenna);
    fprintf(f, ",\n    \"orrery:samples\": %llu,\n    \"orrery:complete\": %s,\n",
            (unsigned long long)r->samples, r->complete ? "true" : "false");
    if (p->format == ORR_GEN_I2)
        fprintf(f, "    \"orrery:packing\": \"two samples a byte, the first in the low half; from the lowest "
                   "bit I sign, I magnitude, "
                   "Q sign, Q magnitude\",\n");
    if (p->noise) fprintf(f, "    \"orrery:noise_seed\": %llu,\n", (unsigned long long)p->seed);
    fprintf(f, "    \"orrery:clipped\": %llu,\n    \"orrery:underruns\": %llu\n  },\n",
            (unsigned long long)r->clipped, (unsigned long long)r->underruns);
}

// Which part of the file an interval is; false where none of it.
static bool part(const orr_gen_recording *r, const orr_gen_heard *h, uint64_t *from, uint64_t *n)
{
    const uint32_t rate = orr_gen_stream_plan_of(r->stream)->rate_hz;
    int64_t a = orr_gen_first_sample(h->from_ns, rate) - r->first,
            b = orr_gen_first_sample(h->to_ns, rate) - r->first;
    if (a < 0) a = 0;
    if (b > (int64_t)r->samples) b = (int64_t)r->samples;
    if (b <= a) return false;
    *from = (uint64_t)a;
    *n = (uint64_t)(b - a);
    return true;
}

static void put_annotations(FILE *f, const orr_gen_recording *r)
{
    size_t n;
    const orr_gen_heard *h =
        orr_gen_stream_heard(r->stream, &n); // in the order of their begins, as SigMF wants them
    const uint64_t divisor = orr_gen_stream_plan_of(r->stream)->format == ORR_GEN_I2 ? 2 : 1;
    bool first = true;
    fprintf(f, "  \"annotations\": [");
    for (size_t k = 0; k < n; k++) {
        uint64_t from, length;
        if (!part(r, &h[k], &from, &length)) continue;
        const orr_gen_signal_info *s = &r->service->signal[h[k].signal];
        fprintf(f, "%s\n    {\"core:sample_start\": %llu, \"core:sample_count\": %llu, ", first ? "" : ",",
                (unsigned long long)(from / divisor), (unsigned long long)(length / divisor));
        fprintf(f, "\"core:freq_lower_edge\": %.17g, \"core:freq_upper_edge\": %.17g, ",
                s->carrier_hz - s->chips_per_s, s->carrier_hz + s->chips_per_s);
        fprintf(f, "\"core:label\": \"%c%02u %s\"}", h[k].system, h[k].number, s->name);
        first = false;
    }
    fprintf(f, "%s]\n", first ? "" : "\n  ");
}

bool orr_gen_sigmf_write(const char *path, const orr_gen_recording *recording, orr_gen_fault *fault)
{
    const orr_gen_recording *r = recording;
    const orr_gen_stream_plan *p = orr_gen_stream_plan_of(r->stream);
    char beside[1100];
    snprintf(beside, sizeof beside, "%s.part", path);
    FILE *f = fopen(beside, "w");
    if (f == NULL) return orr_gen_fail(fault, "%s cannot be written: %s", path, strerror(errno));
    fprintf(f, "{\n");
    put_global(f, r);
    fprintf(f,
            "  \"captures\": [\n    {\"core:sample_start\": 0, \"core:frequency\": %lld, \"core:datetime\": ",
            (long long)p->centre_hz);
    put_instant(f, r->service, r->first, p->rate_hz);
    fprintf(f, "}\n  ],\n");
    put_annotations(f, r);
    fprintf(f, "}\n");
    const bool bad = ferror(f) != 0;
    if (fclose(f) == 0 && !bad && rename(beside, path) == 0) return true;
    const int why = errno;
    unlink(beside);
    orr_gen_fail(fault, "%s cannot be written: %s", path, strerror(why));
    errno = why;
    return false;
}

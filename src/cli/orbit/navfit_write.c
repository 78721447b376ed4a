// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/navfit_write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/outfile.h"
#include "orbit/navdata/navframe.h"
#include "orbit/navdata/rtcm_ephemeris.h"

// Comments of at most 60 characters: a file's name, and its SHA-256 in two halves.
static orr_status put_comments(const orr_inputs *inputs, orr_nav *nav, orr_diag *diag)
{
    nav->comment = calloc(3 * inputs->n + 1, sizeof *nav->comment);
    for (size_t i = 0; nav->comment != NULL && i < 3 * inputs->n; i++) {
        const orr_orbit_source *in = &inputs->item[i / 3];
        char line[61];
        if (i % 3 == 0)
            snprintf(line, sizeof line, "INPUT %.54s", in->name);
        else
            snprintf(line, sizeof line, "SHA-256 %s %.32s", i % 3 == 1 ? "begins" : "ends",
                     in->sha256 + (i % 3 - 1) * 32);
        nav->comment[i] = strdup(line);
        if (nav->comment[i] == NULL) break;
        nav->n_comments++;
    }
    return nav->n_comments == 3 * inputs->n ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

// The date in the header: now, or what SOURCE_DATE_EPOCH says for files that are to be the same whenever they are made
// (reproducible-builds.org).
static time_t date_of_file(void)
{
    const char *fixed = getenv("SOURCE_DATE_EPOCH");
    char *end;
    const long long s = fixed != NULL && *fixed >= '0' && *fixed <= '9' ? strtoll(fixed, &end, 10) : -1;
    return s >= 0 && *end == '\0' ? (time_t)s : time(NULL);
}

orr_status navfit_write_rinex(const orr_navset *set, const orr_inputs *inputs, double version,
                              const char *path, size_t *n_left, orr_diag *diag)
{
    orr_nav nav;
    orr_status s = orr_navset_records(set, &nav, diag);
    if (s != ORR_OK) return s;
    nav.version = version;
    const time_t now = date_of_file();
    struct tm utc;
    snprintf(nav.program, sizeof nav.program, "orrery %s", ORR_VERSION);
    if (gmtime_r(&now, &utc) != NULL) strftime(nav.date, sizeof nav.date, "%Y%m%d %H%M%S UTC", &utc);
    s = put_comments(inputs, &nav, diag);
    if (s == ORR_OK) s = orr_nav_write(&nav, path, n_left, diag);
    orr_nav_free(&nav);
    return s;
}

static int by_transmission(const void *a, const void *b)
{
    const orr_nav_eph *x = a, *y = b;
    if (x->transmission != y->transmission) return x->transmission < y->transmission ? -1 : 1;
    if (x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    return (int)x->message - (int)y->message;
}

// Keeps the records that RTCM has messages for, in the order of their transmission.
static void keep_for_rtcm(orr_nav *nav)
{
    size_t n = 0;
    for (size_t i = 0; i < nav->n_eph; i++)
        if (orr_rtcm_number(nav->eph[i].sat, (orr_nav_message)nav->eph[i].message) != 0)
            nav->eph[n++] = nav->eph[i];
    nav->n_eph = n;
    qsort(nav->eph, n, sizeof *nav->eph, by_transmission);
}

static orr_status put_frames(FILE *f, const orr_nav *nav, const orr_leap_table *leap, orr_diag *diag)
{
    orr_status s = ORR_OK;
    for (size_t i = 0; i < nav->n_eph && s == ORR_OK; i++) {
        orr_rtcm_frame frame;
        s = orr_rtcm_ephemeris(&nav->eph[i], leap, &frame, diag);
        if (s == ORR_OK && fwrite(frame.data, 1, frame.n, f) != frame.n)
            s = orr_diag_set(diag, ORR_E_IO, "the output could not be written");
    }
    return s;
}

orr_status navfit_write_rtcm(const orr_navset *set, const orr_leap_table *leap, const char *path, size_t *n,
                             orr_diag *diag)
{
    orr_nav nav;
    orr_outfile out;
    orr_status s = orr_navset_records(set, &nav, diag);
    if (s != ORR_OK) return s;
    keep_for_rtcm(&nav);
    *n = nav.n_eph;
    if (nav.n_eph == 0) s = orr_diag_set(diag, ORR_E_NODATA, "RTCM 3 has messages for none of the sets");
    if (s == ORR_OK) s = orr_outfile_open(path, &out, diag);
    if (s == ORR_OK) {
        s = put_frames(out.stream, &nav, leap, diag);
        s = orr_outfile_end(&out, s, diag);
    }
    orr_nav_free(&nav);
    return s;
}

static void print_piece(FILE *f, const orr_navframe *frame, const orr_navframe_piece *p)
{
    char time[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    fprintf(f, "%s,%s,%s,%s,%u,%u,%g,%u,", orr_time_text(p->t, time), orr_sat_text(frame->sat, sat),
            orr_nav_message_name((orr_nav_message)frame->stream->message), frame->stream->signals, p->number,
            p->page, (double)p->length * 1e-9, p->bits);
    for (int k = 0; k < (p->bits + 7) / 8; k++) fprintf(f, "%02x", p->data[k]);
    fputc('\n', f);
}

// A stream, and where its next frame begins.
typedef struct sender {
    orr_sat sat;
    const orr_nav_stream *stream;
    orr_time next;
} sender;

static sender *senders_of(const orr_navset *set, orr_time from, size_t *n)
{
    const orr_sat *sat;
    const orr_nav_stream *list[ORR_NAVSET_STREAMS];
    const size_t n_sats = orr_navset_satellites(set, &sat);
    sender *all = malloc((n_sats * ORR_NAVSET_STREAMS + 1) * sizeof *all);
    *n = 0;
    for (size_t i = 0; all != NULL && i < n_sats; i++) {
        const size_t m = orr_navset_streams(set, sat[i], list);
        for (size_t k = 0; k < m; k++) all[(*n)++] = (sender){sat[i], list[k], from};
    }
    return all;
}

// The frame of one stream that holds s->next, as far as it lies within [from, to).
static orr_status print_frame(FILE *f, const orr_navset *set, sender *s, bool coded, orr_time from,
                              orr_time to, size_t *n_pieces, orr_diag *diag)
{
    orr_navframe frame;
    const orr_status status = orr_navframe_at(set, s->sat, s->stream, s->next, coded, &frame, diag);
    if (status == ORR_E_NODATA) {
        s->next += ORR_NS_PER_S; // a set may begin at any second
        return ORR_OK;
    }
    if (status != ORR_OK) return status;
    for (int k = 0; k < frame.n; k++) {
        if (frame.piece[k].t < from || frame.piece[k].t >= to) continue;
        print_piece(f, &frame, &frame.piece[k]);
        ++*n_pieces;
    }
    s->next = frame.to;
    return ORR_OK;
}

orr_status navfit_write_bits(const orr_navset *set, bool coded, orr_time from, orr_time to, const char *path,
                             size_t *n_pieces, orr_diag *diag)
{
    const int64_t block = 30 * ORR_NS_PER_S;
    size_t n;
    sender *all = senders_of(set, from, &n);
    if (all == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s != ORR_OK) {
        free(all);
        return s;
    }
    fputs("t_gps,sat,message,signals,number,page,length_s,bits,hex\n", out.stream);
    *n_pieces = 0;
    for (orr_time t = from; t < to && s == ORR_OK; t += block) {
        for (size_t i = 0; i < n && s == ORR_OK; i++)
            while (all[i].next < t + block && all[i].next < to && s == ORR_OK)
                s = print_frame(out.stream, set, &all[i], coded, from, to, n_pieces, diag);
    }
    free(all);
    if (s == ORR_OK && *n_pieces == 0)
        s = orr_diag_set(diag, ORR_E_NODATA, "no satellite sends anything between --from and --to");
    return orr_outfile_end(&out, s, diag);
}

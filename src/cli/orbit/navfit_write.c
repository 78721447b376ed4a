// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/orbit/navfit_write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/outfile.h"
#include "orbit/navdata/navframe.h"

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

orr_status navfit_write_rinex(const orr_navset *set, const orr_inputs *inputs, const char *path,
                              orr_diag *diag)
{
    orr_nav nav;
    orr_status s = orr_navset_records(set, &nav, diag);
    if (s != ORR_OK) return s;
    time_t now = time(NULL);
    struct tm utc;
    snprintf(nav.program, sizeof nav.program, "orrery %s", ORR_VERSION);
    if (gmtime_r(&now, &utc) != NULL) strftime(nav.date, sizeof nav.date, "%Y%m%d %H%M%S UTC", &utc);
    s = put_comments(inputs, &nav, diag);
    if (s == ORR_OK) s = orr_nav_write(&nav, path, NULL, diag);
    orr_nav_free(&nav);
    return s;
}

static void print_piece(FILE *f, const orr_navframe *frame, const orr_navframe_piece *p)
{
    char time[ORR_TIME_TEXT], sat[ORR_SAT_TEXT];
    fprintf(f, "%s,%s,%s,%u,%u,%u,", orr_time_text(p->t, time), orr_sat_text(frame->sat, sat),
            orr_nav_message_name((orr_nav_message)frame->message), p->number, p->page, p->bits);
    for (int k = 0; k < (p->bits + 7) / 8; k++) fprintf(f, "%02x", p->data[k]);
    fputc('\n', f);
}

// The frame of one satellite that holds t, as far as it lies within [from, to). Returns where the next one
// begins.
static orr_status print_frame(FILE *f, const orr_navset *set, orr_sat sat, orr_time *t, orr_time from,
                              orr_time to, size_t *n_pieces, orr_diag *diag)
{
    orr_navframe frame;
    orr_status s = orr_navframe_at(set, sat, *t, &frame, diag);
    if (s == ORR_E_NODATA) {
        *t += 30 * ORR_NS_PER_S;
        return ORR_OK;
    }
    if (s != ORR_OK) return s;
    for (int k = 0; k < frame.n; k++) {
        if (frame.piece[k].t < from || frame.piece[k].t >= to) continue;
        print_piece(f, &frame, &frame.piece[k]);
        ++*n_pieces;
    }
    *t = frame.to;
    return ORR_OK;
}

orr_status navfit_write_bits(const orr_navset *set, orr_time from, orr_time to, const char *path,
                             size_t *n_pieces, orr_diag *diag)
{
    const orr_sat *sat;
    const int64_t block = 30 * ORR_NS_PER_S;
    size_t n = orr_navset_satellites(set, &sat);
    orr_time *next = malloc((n + 1) * sizeof *next);
    if (next == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    for (size_t i = 0; i < n; i++) next[i] = from;
    orr_outfile out;
    orr_status s = orr_outfile_open(path, &out, diag);
    if (s == ORR_OK) fputs("t_gps,sat,message,number,page,bits,hex\n", out.stream);
    *n_pieces = 0;
    for (orr_time t = from; t < to && s == ORR_OK; t += block) {
        for (size_t i = 0; i < n && s == ORR_OK; i++)
            while (next[i] < t + block && next[i] < to && s == ORR_OK)
                s = print_frame(out.stream, set, sat[i], &next[i], from, to, n_pieces, diag);
        if (s != ORR_OK) orr_outfile_abort(&out);
    }
    free(next);
    if (s != ORR_OK) return s;
    if (*n_pieces > 0) return orr_outfile_commit(&out, diag);
    orr_outfile_abort(&out);
    return orr_diag_set(diag, ORR_E_NODATA, "no satellite sends anything between --from and --to");
}

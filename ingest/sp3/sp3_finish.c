// SPDX-License-Identifier: GPL-3.0-or-later
// After the last line of an SP3 file: order the epochs, compare what was found with what the header said, and
// tell.
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ingest/sp3/sp3_private.h"

static bool is_seen(const orr_sp3_record *r) { return (r->flags & (SP3_SEEN_P | SP3_SEEN_V)) != 0; }

// NAN equals NAN here: a value that is missing in both agrees.
static bool same(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

static bool records_agree(const orr_sp3_record *a, const orr_sp3_record *b)
{
    bool ok = same(a->clock_s, b->clock_s) && same(a->clock_rate_sps, b->clock_rate_sps);
    for (int i = 0; i < 3; i++)
        ok = ok && same(a->pos_m[i], b->pos_m[i]) && same(a->vel_mps[i], b->vel_mps[i]);
    return ok;
}

// Row `from` is of the same epoch as row `to` and comes later in the file: fills what is missing there.
static void merge_row(orr_sp3 *o, size_t stride, size_t to, size_t from, size_t *conflicts)
{
    for (size_t s = 0; s < o->n_sats; s++) {
        orr_sp3_record *a = &o->record[to * stride + s];
        const orr_sp3_record *b = &o->record[from * stride + s];
        if (!is_seen(b)) continue;
        if (is_seen(a)) {
            if (!records_agree(a, b)) ++*conflicts;
            continue;
        }
        *a = *b;
        if (o->correlation != NULL) o->correlation[to * stride + s] = o->correlation[from * stride + s];
    }
}

static void move_row(orr_sp3 *o, size_t stride, size_t to, size_t from)
{
    if (to == from) return;
    o->epoch[to] = o->epoch[from];
    memcpy(o->record + to * stride, o->record + from * stride, stride * sizeof *o->record);
    if (o->correlation != NULL)
        memcpy(o->correlation + to * stride, o->correlation + from * stride, stride * sizeof *o->correlation);
}

typedef struct place {
    orr_time t;
    size_t row;
} place;

static int by_time_then_place(const void *a, const void *b)
{
    const place *x = a, *y = b;
    if (x->t != y->t) return x->t < y->t ? -1 : 1;
    return x->row < y->row ? -1 : 1;
}

static orr_status sort_rows(sp3_parser *p)
{
    orr_sp3 *o = p->out;
    size_t n = o->n_epochs, cells = n * p->stride;
    place *order = malloc(n * sizeof *order);
    orr_sp3_record *r = malloc(cells * sizeof *r);
    orr_sp3_correlation *c = o->correlation != NULL ? malloc(cells * sizeof *c) : NULL;
    if (order == NULL || r == NULL || (o->correlation != NULL && c == NULL)) {
        free(order);
        free(r);
        free(c);
        return orr_diag_set(p->diag, ORR_E_MEMORY, "out of memory");
    }
    for (size_t i = 0; i < n; i++) order[i] = (place){o->epoch[i], i};
    qsort(order, n, sizeof *order, by_time_then_place);
    for (size_t i = 0; i < n; i++) {
        o->epoch[i] = order[i].t;
        memcpy(r + i * p->stride, o->record + order[i].row * p->stride, p->stride * sizeof *r);
        if (c != NULL)
            memcpy(c + i * p->stride, o->correlation + order[i].row * p->stride, p->stride * sizeof *c);
    }
    free(order);
    free(o->record);
    free(o->correlation);
    o->record = r;
    o->correlation = c;
    p->epoch_capacity = n;
    return ORR_OK;
}

static orr_status order_epochs(sp3_parser *p)
{
    orr_sp3 *o = p->out;
    size_t unordered = 0, repeated = 0, conflicts = 0;
    for (size_t i = 1; i < o->n_epochs; i++) unordered += o->epoch[i] < o->epoch[i - 1];
    if (unordered > 0) {
        orr_status st = sort_rows(p);
        if (st != ORR_OK) return st;
        orr_warnings_add(p->warnings, p->c.name, 0, 0,
                         "epochs are not in order of time (%zu step back); sorted", unordered);
    }
    size_t kept = 0;
    for (size_t i = 1; i < o->n_epochs; i++) {
        if (o->epoch[i] != o->epoch[kept]) {
            move_row(o, p->stride, ++kept, i);
        } else {
            merge_row(o, p->stride, kept, i, &conflicts);
            repeated++;
        }
    }
    o->n_epochs = kept + 1;
    if (repeated > 0)
        orr_warnings_add(
            p->warnings, p->c.name, 0, 0,
            "%zu epochs are there more than once; the first record of each satellite is kept, %zu that "
            "differ are left out",
            repeated, conflicts);
    return ORR_OK;
}

static void tell_faults(sp3_parser *p)
{
    static const char *const text[SP3_N_FAULTS] = {
        [SP3_UNLISTED] = "satellites that the header does not list have records; they are read",
        [SP3_BLANK_SYSTEM] = "satellites without a letter, taken as GPS",
        [SP3_DUPLICATE] = "second records of a satellite in one epoch, left out",
        [SP3_STRAY_EP] = "EP or EV records that follow no record of theirs, left out",
        [SP3_ODD_FLAG] = "letters in columns 75-80 that are no flag there",
        [SP3_ODD_SDEV] = "standard deviations or correlations that cannot be read, taken as unknown",
        [SP3_NO_BASE] = "exponents of standard deviations without a base in the header, taken as unknown",
        [SP3_IMPLAUSIBLE] = "positions inside the Earth or more than a million km away, kept as written",
        [SP3_TAIL] = "records with text beyond column 80, which is not read",
        [SP3_JUNK] = "blank or dotted lines, which are none of the format, passed over",
        [SP3_UNKNOWN_SAT] = "records of satellites of a system that is not known, left out",
        [SP3_BETWEEN] = "records with something between the fields (a character lost or gained?)",
        [SP3_FREE] = "records whose numbers are not in the columns of F14.6, read all the same",
        [SP3_MINUTE_60] = "epochs with minute 60, taken as the next hour",
        [SP3_DAY_0] = "epochs with day 0 of a month, taken as the last of the month before",
        [SP3_SHIFTED] = "epoch lines whose fields are a column off, read all the same",
        [SP3_STRAY_RECORD] = "records whose epoch is not known, left out",
    };
    for (int f = 0; f < SP3_N_FAULTS; f++)
        if (p->fault_count[f] > 0)
            orr_warnings_add(p->warnings, p->c.name, p->fault_line[f], 0, "%s (%zu in all, here the first)",
                             text[f], p->fault_count[f]);
}

static void compare_with_header(sp3_parser *p)
{
    const orr_sp3 *o = p->out;
    const char *name = p->c.name;
    orr_warnings *w = p->warnings;
    char a[ORR_TIME_TEXT], b[ORR_TIME_TEXT];
    if (p->header_epochs >= 0 && (size_t)p->header_epochs != o->n_epochs)
        orr_warnings_add(w, name, 1, 33, "the header says %" PRId64 " epochs, found %zu", p->header_epochs,
                         o->n_epochs);
    if (p->header_sats >= 0 && (size_t)p->header_sats != p->n_listed)
        orr_warnings_add(w, name, p->header_sats_line, 4,
                         "the header says %" PRId64 " satellites and lists %zu", p->header_sats, p->n_listed);
    size_t absent = 0, first_absent = 0;
    for (size_t s = o->n_sats; s-- > 0;)
        if (o->n_records[s] == 0) {
            absent++;
            first_absent = s;
        }
    char sat[ORR_SAT_TEXT];
    if (absent > 0)
        orr_warnings_add(w, name, p->header_sats_line, 0,
                         "%zu satellites of the header's list have no position record at all (%s the first)",
                         absent, orr_sat_text(o->sat[first_absent], sat));
    if (p->header_start != ORR_TIME_NONE && p->header_start != o->epoch[0])
        orr_warnings_add(w, name, p->header_start_line, 4,
                         "the header says the start is %s (GPS time), the first epoch is %s",
                         orr_time_text(p->header_start, a), orr_time_text(o->epoch[0], b));
    // Week and seconds are labels in the file's own time system, as line 1 is.
    orr_time label;
    if (p->header_start != ORR_TIME_NONE && !isnan(p->header_week) &&
        orr_time_from_civil(&p->start, ORR_SCALE_GPS, NULL, &label) == ORR_OK &&
        fabs(p->header_week * ORR_S_PER_WEEK + p->header_sow - orr_time_diff_s(label, 0)) > 1e-3)
        orr_warnings_add(w, name, p->header_week_line, 4,
                         "week and seconds of line ## are not the start of line 1");
    int64_t step = 0, off = 0;
    int64_t interval = (int64_t)llround(o->interval_s * 1e9);
    for (size_t i = 1; i < o->n_epochs; i++) {
        int64_t d = o->epoch[i] - o->epoch[i - 1];
        if (step == 0 || d < step) step = d;
        if (interval > 0 && (o->epoch[i] - o->epoch[0]) % interval != 0) off++;
    }
    if (off > 0)
        orr_warnings_add(w, name, p->header_week_line, 25,
                         "epochs that are not whole intervals of %g s after the first: %" PRId64
                         " (smallest step %g s)",
                         o->interval_s, off, (double)step / 1e9);
    if (off == 0 && step > 0 && interval > 0 && step != interval)
        orr_warnings_add(w, name, p->header_week_line, 25,
                         "the header says an interval of %g s, the smallest step is %g s", o->interval_s,
                         (double)step / 1e9);
}

// Each epoch should have a line for each satellite of the list, with noughts where there is nothing to say.
static void tell_holes(sp3_parser *p)
{
    const orr_sp3 *o = p->out;
    size_t holes = 0, first_e = 0, first_s = 0, no_velocity = 0;
    for (size_t e = 0; e < o->n_epochs; e++)
        for (size_t s = 0; s < o->n_sats; s++) {
            uint8_t flags = o->record[e * p->stride + s].flags;
            if (o->has_velocity && (flags & (SP3_SEEN_P | SP3_SEEN_V)) == SP3_SEEN_P) no_velocity++;
            if (o->n_records[s] == 0 || (flags & SP3_SEEN_P) != 0) continue;
            if (holes++ == 0) {
                first_e = e;
                first_s = s;
            }
        }
    char sat[ORR_SAT_TEXT], t[ORR_TIME_TEXT];
    if (holes > 0)
        orr_warnings_add(
            p->warnings, p->c.name, 0, 0,
            "%zu records are not there, of satellites that have others (%s at %s GPS time the first)", holes,
            orr_sat_text(o->sat[first_s], sat), orr_time_text(o->epoch[first_e], t));
    if (no_velocity > 0 && p->seen_velocity)
        orr_warnings_add(p->warnings, p->c.name, 0, 0,
                         "%zu positions have no velocity record, though others have", no_velocity);
}

// A clock of exactly nothing in all epochs is more often a missing one than a perfect one.
static void tell_zero_clocks(sp3_parser *p)
{
    const orr_sp3 *o = p->out;
    size_t zero = 0, first = 0;
    if (o->n_epochs < 2) return;
    for (size_t s = o->n_sats; s-- > 0;) {
        bool all = o->n_records[s] > 0;
        for (size_t e = 0; e < o->n_epochs && all; e++) {
            const orr_sp3_record *r = &o->record[e * p->stride + s];
            all = !is_seen(r) || r->clock_s == 0;
        }
        if (all) {
            zero++;
            first = s;
        }
    }
    char sat[ORR_SAT_TEXT];
    if (zero > 0)
        orr_warnings_add(
            p->warnings, p->c.name, 0, 0,
            "the clocks of %zu satellites (%s the first) are 0.000000 throughout; kept as written, though "
            "the format's word for a missing clock is 999999.999999",
            zero, orr_sat_text(o->sat[first], sat));
}

orr_status sp3_finish(sp3_parser *p)
{
    orr_sp3 *o = p->out;
    if (p->n_bad > p->n_good) {
        orr_diag *d = p->diag;
        return orr_diag_at(d, ORR_E_FORMAT, p->first_bad.file, p->first_bad.line, p->first_bad.column,
                           "%s; of %zu records and epochs %zu cannot be read", p->first_bad.text,
                           p->n_good + p->n_bad, p->n_bad);
    }
    if (o->n_epochs == 0 || p->n_good == 0)
        return orr_diag_at(p->diag, ORR_E_FORMAT, p->c.name, p->c.line, 0,
                           "the file ends without a single whole record: there is nothing in it");
    if (!p->ended)
        orr_warnings_add(p->warnings, p->c.name, p->c.line, 0,
                         "the file ends without EOF; it may be cut here");
    orr_status st = order_epochs(p);
    if (st != ORR_OK) return st;
    for (size_t e = 0; e < o->n_epochs; e++)
        for (size_t s = 0; s < o->n_sats; s++)
            o->n_records[s] += (o->record[e * p->stride + s].flags & SP3_SEEN_P) != 0;
    tell_faults(p);
    compare_with_header(p);
    tell_holes(p);
    tell_zero_clocks(p);
    bool velocity = p->seen_velocity;
    for (size_t i = 0; i < o->n_epochs * p->stride; i++) {
        velocity = velocity || (o->record[i].flags & SP3_SEEN_V) != 0;
        o->record[i].flags &= (uint8_t) ~(SP3_SEEN_P | SP3_SEEN_V);
    }
    if (p->header_says_velocity != velocity)
        orr_warnings_add(p->warnings, p->c.name, 1, 3,
                         velocity ? "there are V records, though line 1 says P"
                                  : "line 1 says V, but there are no V records");
    return ORR_OK;
}

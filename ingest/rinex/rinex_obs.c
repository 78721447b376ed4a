// SPDX-License-Identifier: GPL-3.0-or-later
// Epochs of observation files, plain and decoded from Hatanaka; rinex_obs_open.c opens and closes.
#include "ingest/rinex/rinex_obs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/array.h"
#include "core/digits.h"
#include "core/nan.h"
#include "ingest/rinex/rinex_obs_private.h"

static orr_status no_memory(orr_diag *diag) { return orr_diag_set(diag, ORR_E_MEMORY, "out of memory"); }

// ---- values ----

// F14.3 as nearly all files have it: the point in column 11, three digits behind it. -1 if it needs the
// general reader.
static int fast_value(const char *p, double *out)
{
    if (p[10] != '.') return -1;
    uint64_t part = orr_digits_load(p + 6) >> 40 << 40; // bytes 11 to 13
    unsigned first = 0;
    while (first < 10 && p[first] == ' ') first++;
    bool minus = p[first] == '-';
    first += minus;
    uint64_t v = 0;
    for (; first < 2; first++) { // the two highest digits, seldom there
        unsigned d = (unsigned)(unsigned char)p[first] - '0';
        if (d > 9) return -1;
        v = v * 10 + d;
    }
    uint64_t whole = orr_digits_load(p + 2);
    if (first > 2) whole = first < 10 ? whole >> 8 * (first - 2) << 8 * (first - 2) : 0;
    if (!orr_digits_all(whole) || !orr_digits_all(part)) return -1;
    v = (v * 100000000 + orr_digits_value(whole)) * 1000 + orr_digits_value(part);
    double x = (double)v / 1000.0; // both exact, so the quotient is correctly rounded
    *out = minus ? -x : x;
    return 0;
}

static uint8_t flag_digit(orr_rinex_obs *r, char c, int column)
{
    if (c >= '0' && c <= '9') return (uint8_t)(c - '0');
    if (c != ' ' && c != '\t')
        orr_obs_warn(r, column, "a loss-of-lock or strength flag that is no digit: left out");
    return 0;
}

// The observation that starts in column col (from 1) of the line into cell k. scale divides.
static void take_value(orr_rinex_obs *r, orr_view line, size_t col, size_t k, double scale)
{
    r->value[k] = ORR_NAN;
    r->lli[k] = r->ssi[k] = 0;
    if (line.n < col) return;
    const char *p = line.p + col - 1;
    size_t left = line.n - (col - 1);
    double v = 0;
    if (left < 14 || fast_value(p, &v) != 0) {
        // The point has its place: elsewhere the columns have slipped, and a digit may belong to the
        // neighbour. Only cycle slip records (flag 6) come with fewer decimals, cut at the end of the line.
        orr_view field = {p, left < 14 ? left : 14};
        orr_field f = orr_view_real(field, &v);
        size_t want = r->e.flag == ORR_OBS_CYCLE_SLIP ? 12 : 14;
        if (f == ORR_FIELD_OK && (field.n < want || field.p[10] != '.')) f = ORR_FIELD_BAD;
        if (f == ORR_FIELD_BAD) {
            orr_obs_warn(r, (int)col,
                         "an observation that is not a number in its columns, or cut off: left out");
            return;
        }
        if (f == ORR_FIELD_BLANK) v = 0;
    }
    if (v != 0) r->value[k] = v / scale; // 0.0 means missing, as blank does
    if (left > 14) r->lli[k] = flag_digit(r, p[14], (int)col + 14);
    if (left > 15) r->ssi[k] = flag_digit(r, p[15], (int)col + 15);
}

static orr_status make_room(orr_rinex_obs *r, size_t n_sats, orr_diag *diag)
{
    size_t stride = 1;
    for (size_t s = 0; s < ORR_N_SYSTEMS; s++)
        if (r->h.codes[s].n > stride) stride = r->h.codes[s].n;
    size_t want = n_sats * stride;
    if (want > r->cells) {
        want += 8 * stride;
        double *v = realloc(r->value, want * sizeof *v);
        if (v != NULL) r->value = v;
        uint8_t *l = realloc(r->lli, want);
        if (l != NULL) r->lli = l;
        uint8_t *s = realloc(r->ssi, want);
        if (s != NULL) r->ssi = s;
        if (v == NULL || l == NULL || s == NULL) return no_memory(diag);
        r->cells = want;
    }
    r->e.stride = stride;
    r->e.sat = r->sat;
    r->e.value = r->value;
    r->e.lli = r->lli;
    r->e.ssi = r->ssi;
    return ORR_OK;
}

// The satellite's list of types, or NULL (with one warning a system) where it cannot be read.
static const orr_obs_codes *codes_of(orr_rinex_obs *r, orr_sat sat)
{
    if (sat == ORR_SAT_NONE) {
        if (!(r->warned & WARNED_SYSTEM)) orr_obs_warn(r, 1, "a satellite that is not readable: left out");
        return NULL;
    }
    int s = orr_sat_system_index(sat);
    uint32_t bit = 1u << s;
    if (r->h.codes[s].n == 0) {
        if (!(r->warned & bit))
            orr_obs_warn(r, 1, "a satellite of a system whose observation types the header lacks: left out");
        r->warned |= bit;
        return NULL;
    }
    if (r->h.system != 'M' && r->h.system != orr_sat_system(sat) && !(r->warned & WARNED_SYSTEM)) {
        orr_obs_warn(r, 1, "satellites of another system than the first line says");
        r->warned |= WARNED_SYSTEM;
    }
    return &r->h.codes[s];
}

static char blank_system(const orr_rinex_obs *r) { return r->h.system == 'M' ? 'G' : r->h.system; }

// ---- epoch lines ----

typedef struct epoch_head {
    int flag, n;
    orr_time t;
    double clock;
} epoch_head;

static bool take_date(const orr_rinex_obs *r, orr_view line, epoch_head *head)
{
    bool v3 = r->h.version >= 3;
    static const int col2[5] = {2, 5, 8, 11, 14}, col3[5] = {3, 8, 11, 14, 17};
    const int *col = v3 ? col3 : col2;
    orr_rinex_date d = {0};
    int *field[5] = {&d.year, &d.month, &d.day, &d.hour, &d.minute};
    for (int i = 0; i < 5; i++)
        if (orr_field_int_in(line, col[i], i == 0 && v3 ? 4 : 2, 0, 9999, field[i]) != ORR_FIELD_OK)
            return false;
    if (!orr_rinex_seconds(line, v3 ? 19 : 16, 11, &d.second_ps)) return false;
    int more = 0; // 4.02: five further digits of the seconds
    if (r->h.version >= 4.015 && orr_field_int_in(line, 58, 5, 0, 99999, &more) == ORR_FIELD_OK)
        d.second_ps += more;
    return orr_rinex_time(&d, r->h.scale, r->limits.leap, &head->t) == ORR_OK;
}

static bool take_epoch_line(orr_rinex_obs *r, orr_view line, epoch_head *head)
{
    bool v3 = r->h.version >= 3;
    *head = (epoch_head){.t = ORR_TIME_NONE, .clock = ORR_NAN};
    if (v3 ? orr_view_char(line, 1) != '>' : orr_view_char(line, 1) != ' ') return false;
    static const int blank2[] = {4, 7, 10, 13, 27, 28}, blank3[] = {2, 7, 10, 13, 16, 31};
    for (int i = 0; i < 6; i++) // anything there, and the columns have slipped
        if (orr_view_char(line, v3 ? blank3[i] : blank2[i]) != ' ') return false;
    orr_field f = orr_field_int_in(line, v3 ? 32 : 29, 1, 0, 6, &head->flag);
    if (f == ORR_FIELD_BAD || (f == ORR_FIELD_BLANK && v3)) return false;
    if (orr_field_int_in(line, v3 ? 33 : 30, 3, 0, 999, &head->n) != ORR_FIELD_OK) return false;
    if (head->flag >= 2 && head->flag <= 5 && orr_view_is_blank(orr_view_cols(line, 2, v3 ? 28 : 25)))
        return true;
    if (!take_date(r, line, head)) return false;
    if (head->flag >= 2 && head->flag <= 5) return true;
    double clock = 0;
    f = orr_field_real(line, v3 ? 42 : 69, v3 ? 15 : 12, &clock);
    if (f == ORR_FIELD_BAD)
        orr_obs_warn(r, v3 ? 42 : 69, "the receiver clock offset is not a number: left out");
    if (f == ORR_FIELD_OK) head->clock = clock;
    return true;
}

// ---- events ----

static orr_status keep_event_line(orr_rinex_obs *r, orr_view line, orr_diag *diag)
{
    if (r->n_event_lines >= r->limits.max_event_lines)
        return orr_diag_at(diag, ORR_E_LIMIT, orr_input_name(r->in), orr_input_line_number(r->in), 0,
                           "an event of more than %zu lines", r->limits.max_event_lines);
    if (!ORR_ARRAY_GROW(r->event_line, r->n_event_lines)) return no_memory(diag);
    r->event_line[r->n_event_lines] = orr_view_dup(line);
    if (r->event_line[r->n_event_lines] == NULL) return no_memory(diag);
    r->n_event_lines++;
    return ORR_OK;
}

void orr_obs_drop_event_lines(orr_rinex_obs *r)
{
    for (size_t i = 0; i < r->n_event_lines; i++) free(r->event_line[i]);
    r->n_event_lines = 0;
}

// A line of an event: kept for the caller, and applied where it is a header line.
static orr_status take_event_line(orr_rinex_obs *r, orr_view line, orr_diag *diag)
{
    orr_status s = keep_event_line(r, line, diag);
    if (s != ORR_OK) return s;
    orr_view label = orr_rinex_label(line);
    if (label.n == 0 || orr_view_equals(label, "COMMENT")) return ORR_OK;
    obs_context c = orr_obs_context(r, diag);
    if (!orr_crinex_note_types(&r->counts, line))
        return orr_diag_at(diag, ORR_E_FORMAT, c.name, c.line, 1,
                           "the number of observation types is not usable");
    r->e.header_changed = true;
    return orr_obs_header_line(&r->h, &r->state, line, &c);
}

static orr_status finish_event(orr_rinex_obs *r, orr_diag *diag)
{
    r->e.n_event_lines = r->n_event_lines;
    r->e.event_line = (const char *const *)r->event_line;
    if (!r->e.header_changed) return ORR_OK;
    obs_context c = orr_obs_context(r, diag);
    return orr_obs_header_check(&r->h, &r->state, &c);
}

// ---- satellites ----

enum outcome { GOOD, DAMAGED, AT_END, FAILED };

static void put_sat(orr_rinex_obs *r, orr_sat sat) { r->sat[r->e.n_sats++] = sat; }

static enum outcome read_sats_v3(orr_rinex_obs *r, size_t n)
{
    orr_view line;
    for (size_t i = 0; i < n; i++) {
        if (!orr_input_line(r->in, &line)) return AT_END;
        if (line.n > 0 && line.p[0] == '>') {
            orr_input_unline(r->in);
            orr_obs_warn(r, 1, "an epoch with fewer satellites than it announces: left out");
            return DAMAGED;
        }
        if (orr_view_is_blank(line)) {
            orr_obs_warn(r, 1, "a blank line among an epoch's satellites: passed over");
            i--;
            continue;
        }
        orr_sat sat = line.n >= 3 ? orr_sat_parse3(line.p, blank_system(r)) : ORR_SAT_NONE;
        const orr_obs_codes *codes = codes_of(r, sat);
        if (codes == NULL) continue;
        size_t base = r->e.n_sats * r->e.stride;
        for (size_t j = 0; j < codes->n; j++) take_value(r, line, 4 + 16 * j, base + j, codes->scale[j]);
        size_t used = 3 + 16 * codes->n;
        if (line.n > used && !(r->warned & WARNED_EXTRA) &&
            !orr_view_is_blank((orr_view){line.p + used, line.n - used})) {
            orr_obs_warn(r, (int)used + 1, "more values than observation types: the rest is left out");
            r->warned |= WARNED_EXTRA;
        }
        put_sat(r, sat);
    }
    return GOOD;
}

// The list of an epoch of RINEX 2, twelve a line; false where it is damaged.
static enum outcome read_list_v2(orr_rinex_obs *r, orr_view line, size_t n, orr_sat *list)
{
    for (size_t i = 0; i < n; i++) {
        if (i > 0 && i % 12 == 0) {
            if (!orr_input_line(r->in, &line)) return AT_END;
            if (!orr_view_is_blank(orr_view_cols(line, 1, 32))) {
                orr_input_unline(r->in);
                return DAMAGED;
            }
        }
        orr_view id = orr_view_cols(line, 33 + 3 * (int)(i % 12), 3);
        if (id.n < 3 || orr_view_is_blank(id)) return DAMAGED;
        list[i] = orr_sat_parse3(id.p, blank_system(r));
        if (list[i] == ORR_SAT_NONE && (id.p[2] < '0' || id.p[2] > '9')) return DAMAGED;
    }
    return GOOD;
}

static enum outcome read_sats_v2(orr_rinex_obs *r, orr_view line, size_t n)
{
    orr_sat list[ORR_OBS_MAX_SATS];
    enum outcome o = read_list_v2(r, line, n, list);
    if (o == DAMAGED) orr_obs_warn(r, 33, "the satellite list of an epoch is damaged: the epoch is left out");
    if (o != GOOD) return o;
    size_t n_codes = r->state.v2_n;
    for (size_t i = 0; i < n; i++) {
        const orr_obs_codes *codes = codes_of(r, list[i]);
        size_t base = r->e.n_sats * r->e.stride;
        for (size_t j = 0; j < n_codes; j += 5) {
            if (!orr_input_line(r->in, &line)) return AT_END;
            if (codes == NULL) continue;
            for (size_t k = j; k < n_codes && k < j + 5; k++)
                take_value(r, line, 1 + 16 * (k - j), base + k, codes->scale[k]);
        }
        if (codes != NULL) put_sat(r, list[i]);
    }
    return GOOD;
}

// After damage: on to the next line that starts an epoch.
static void resync(orr_rinex_obs *r)
{
    orr_view line;
    orr_warnings *kept = r->warnings;
    r->warnings = NULL; // what is tried on the way is no complaint
    while (orr_input_line(r->in, &line)) {
        epoch_head head;
        bool starts = r->h.version >= 3
                          ? line.n > 0 && line.p[0] == '>' // whatever it is, it is told of
                          : take_epoch_line(r, line, &head) && head.t != ORR_TIME_NONE && head.n > 0;
        if (!starts) continue;
        orr_input_unline(r->in);
        break;
    }
    r->warnings = kept;
}

// ---- the two sources of epochs ----

static void begin_epoch(orr_rinex_obs *r)
{
    orr_obs_drop_event_lines(r);
    r->e = (orr_rinex_obs_epoch){.t = ORR_TIME_NONE, .clock_offset_s = ORR_NAN};
}

static orr_status end_epoch(orr_rinex_obs *r, const orr_rinex_obs_epoch **epoch, orr_diag *diag)
{
    if (++r->n_epochs > r->limits.max_epochs)
        return orr_diag_at(diag, ORR_E_LIMIT, orr_input_name(r->in), r->e.line, 0, "more than %llu epochs",
                           (unsigned long long)r->limits.max_epochs);
    if (r->e.flag <= 1) {
        if (r->last != ORR_TIME_NONE && r->e.t <= r->last && !(r->warned & WARNED_ORDER)) {
            orr_obs_warn(r, 1, "an epoch that is not later than the one before (told once)");
            r->warned |= WARNED_ORDER;
        }
        r->last = r->e.t;
    }
    *epoch = &r->e;
    return ORR_OK;
}

static orr_status next_plain(orr_rinex_obs *r, const orr_rinex_obs_epoch **epoch, orr_diag *diag)
{
    orr_view line;
    while (orr_input_line(r->in, &line)) {
        if (orr_view_is_blank(line)) continue;
        begin_epoch(r);
        r->e.line = orr_input_line_number(r->in);
        epoch_head head;
        if (!take_epoch_line(r, line, &head)) {
            orr_obs_warn(r, 1, "not an epoch line: skipping to the next");
            r->skipped++;
            resync(r);
            continue;
        }
        r->e.flag = head.flag;
        r->e.t = head.t;
        r->e.clock_offset_s = head.clock;
        size_t n = (size_t)head.n;
        enum outcome o = GOOD;
        if (head.flag >= 2 && head.flag <= 5) {
            for (size_t i = 0; i < n && o == GOOD; i++) {
                if (!orr_input_line(r->in, &line)) {
                    o = AT_END;
                    break;
                }
                orr_status s = take_event_line(r, line, diag);
                if (s != ORR_OK) return s;
            }
            orr_status s = finish_event(r, diag);
            if (s != ORR_OK) return s;
            if (o == AT_END && orr_input_status(r->in, NULL) == ORR_OK)
                orr_obs_warn(r, 0, "the file ends within an event");
            o = GOOD;
        } else if (n > ORR_OBS_MAX_SATS) {
            return orr_diag_at(diag, ORR_E_LIMIT, orr_input_name(r->in), r->e.line, 0,
                               "an epoch of %zu satellites, the limit is %d", n, ORR_OBS_MAX_SATS);
        } else {
            orr_status s = make_room(r, n, diag);
            if (s != ORR_OK) return s;
            o = r->h.version >= 3 ? read_sats_v3(r, n) : read_sats_v2(r, line, n);
        }
        orr_status s = orr_input_status(r->in, diag);
        if (s != ORR_OK) return s;
        if (o == GOOD) return end_epoch(r, epoch, diag);
        r->skipped++;
        if (o == AT_END) {
            orr_obs_warn(r, 0, "the file ends within an epoch: it is left out");
            break;
        }
        resync(r);
    }
    *epoch = NULL;
    return orr_input_status(r->in, diag);
}

static void take_decoded(orr_rinex_obs *r, const orr_crinex_epoch *d)
{
    for (size_t i = 0; i < d->n_sats; i++) {
        orr_sat sat = orr_sat_parse3(d->sat[i], blank_system(r));
        const orr_obs_codes *codes = codes_of(r, sat);
        if (codes == NULL) continue;
        size_t base = r->e.n_sats * r->e.stride, from = i * d->stride;
        for (size_t j = 0; j < codes->n; j++) {
            size_t k = base + j;
            r->value[k] = ORR_NAN;
            r->lli[k] = r->ssi[k] = 0;
            if (j >= d->n_codes[i]) continue;
            int64_t v = d->value[from + j];
            if (v != ORR_CRINEX_MISSING && v != 0) r->value[k] = (double)v / 1000.0 / codes->scale[j];
            r->lli[k] = flag_digit(r, d->flags[2 * (from + j)], 0);
            r->ssi[k] = flag_digit(r, d->flags[2 * (from + j) + 1], 0);
        }
        put_sat(r, sat);
    }
}

static orr_status next_hatanaka(orr_rinex_obs *r, const orr_rinex_obs_epoch **epoch, orr_diag *diag)
{
    for (;;) {
        const orr_crinex_epoch *d = NULL;
        orr_status s = orr_crinex_next(r->crinex, &d, diag);
        r->skipped = orr_crinex_skipped(r->crinex);
        if (s != ORR_OK || d == NULL) {
            *epoch = NULL;
            return s;
        }
        begin_epoch(r);
        r->e.line = d->line;
        r->e.flag = d->flag;
        epoch_head head;
        orr_view text = orr_view_cols(d->text, 1, r->h.version >= 3 ? 41 : 32);
        if (!take_epoch_line(r, text, &head) && !(d->is_event && d->n_event_lines == 0)) {
            orr_obs_warn(r, 0, "a decoded epoch line that is not readable: the epoch is left out");
            r->skipped++;
            continue;
        }
        r->e.t = head.t;
        if (d->is_event) {
            for (size_t i = 0; i < d->n_event_lines; i++) {
                s = d->flag == ORR_OBS_CYCLE_SLIP ? keep_event_line(r, d->event_line[i], diag)
                                                  : take_event_line(r, d->event_line[i], diag);
                if (s != ORR_OK) return s;
            }
            s = finish_event(r, diag);
            if (s != ORR_OK) return s;
            return end_epoch(r, epoch, diag);
        }
        s = make_room(r, d->n_sats, diag);
        if (s != ORR_OK) return s;
        if (d->has_clock) r->e.clock_offset_s = (double)d->clock * (r->h.version >= 3 ? 1e-12 : 1e-9);
        take_decoded(r, d);
        return end_epoch(r, epoch, diag);
    }
}

orr_status orr_rinex_obs_next(orr_rinex_obs *r, const orr_rinex_obs_epoch **epoch, orr_diag *diag)
{
    *epoch = NULL;
    orr_status s = r->crinex != NULL ? next_hatanaka(r, epoch, diag) : next_plain(r, epoch, diag);
    if (s != ORR_OK || *epoch != NULL || r->n_epochs > 0) return s;
    if (r->skipped > 0) // of damage alone nobody should make an empty day
        return orr_diag_at(diag, ORR_E_FORMAT, orr_input_name(r->in), orr_input_line_number(r->in), 0,
                           "no epoch of the file can be read");
    if (!(r->warned & WARNED_EMPTY)) orr_obs_warn(r, 0, "the file has no epochs");
    r->warned |= WARNED_EMPTY;
    return ORR_OK;
}

const orr_rinex_obs_header *orr_rinex_obs_header_of(const orr_rinex_obs *r) { return &r->h; }
uint64_t orr_rinex_obs_skipped(const orr_rinex_obs *r) { return r->skipped; }

// SPDX-License-Identifier: GPL-3.0-or-later
// Reader of Bernese .ION files. Labels stand in columns 1-48, values from 49; a model is a title, a line of
// dashes, header lines, COEFFICIENTS, a column title, rows of I4,I8,F18.8,F11.4 and a blank line.
#include "ingest/maps/ion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/nan.h"
#include "ingest/input/text_records.h"

#define ION_LABEL_COLUMNS 48
#define ION_MAX_DEGREE 512

typedef struct ion_reader {
    orr_cursor c;
    orr_ion *out;
    orr_warnings *warnings;
    orr_diag *diag;
    orr_read_limits limits;
    size_t coefficients, row_length;
    char title[81];
    orr_records_tally tally;
} ion_reader;

void orr_ion_free(orr_ion *x)
{
    if (x == NULL) return;
    for (size_t i = 0; i < x->n_models; i++) free(x->model[i].coefficient);
    free(x->model);
    *x = (orr_ion){0};
}

static orr_ion_model untold(void)
{
    return (orr_ion_model){.type = ORR_ION_GLOBAL,
                           .max_degree = -1,
                           .max_order = -1,
                           .frame = ORR_ION_GEOMAGNETIC,
                           .sun = ORR_ION_SUN_MEAN,
                           .mapping = ORR_ION_MAP_NONE,
                           .layer_height_m = ORR_NAN,
                           .layer_height_rms_m = ORR_NAN,
                           .pole_lat_deg = ORR_NAN,
                           .pole_lon_deg = ORR_NAN,
                           .from = ORR_TIME_NONE,
                           .to = ORR_TIME_NONE,
                           .lat_south_deg = ORR_NAN,
                           .lat_north_deg = ORR_NAN,
                           .n_stations = -1,
                           .n_satellites = -1,
                           .elevation_cutoff_deg = ORR_NAN,
                           .max_tec_tecu = ORR_NAN};
}

orr_status orr_ion_model_alloc(int max_degree, int max_order, orr_ion_model *out, orr_diag *diag)
{
    *out = untold();
    if (max_degree < 0 || max_degree > ION_MAX_DEGREE || max_order < 0)
        return orr_diag_set(diag, ORR_E_ARG, "degree %d, order %d: degrees 0 to %d are offered", max_degree,
                            max_order, ION_MAX_DEGREE);
    if (max_order > max_degree) max_order = max_degree;
    out->max_degree = max_degree;
    out->max_order = max_order;
    size_t n = (size_t)(max_degree + 1) * (size_t)(2 * max_order + 1);
    out->coefficient = calloc(n, sizeof *out->coefficient);
    if (out->coefficient == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu coefficients", n);
    for (int d = 0; d <= max_degree; d++) {
        for (int m = 0; m <= d && m <= max_order; m++) {
            out->coefficient[out->n_coefficients++] = (orr_ion_coefficient){.degree = d, .order = m};
            if (m > 0)
                out->coefficient[out->n_coefficients++] = (orr_ion_coefficient){.degree = d, .order = -m};
        }
    }
    return ORR_OK;
}

// Header lines, by the words their labels start with. The format is free to leave any of them out.
typedef enum ion_field {
    F_NUMBER,
    F_TYPE,
    F_DEGREE,
    F_ORDER,
    F_FRAME,
    F_SUN,
    F_MAPPING,
    F_HEIGHT,
    F_POLE_LAT,
    F_POLE_LON,
    F_FROM,
    F_TO,
    F_SOUTH,
    F_NORTH,
    F_STATIONS,
    F_SATELLITES,
    F_CUTOFF,
    F_MAX_TEC,
    F_COMMENT,
    F_HEADING,
    F_UNKNOWN
} ion_field;

static ion_field field_of(orr_view label)
{
    static const struct {
        const char *start;
        ion_field field;
    } table[] = {
        {"MODEL NUMBER", F_NUMBER},
        {"MODEL TYPE", F_TYPE},
        {"MAXIMUM DEGREE", F_DEGREE},
        {"MAXIMUM ORDER", F_ORDER},
        {"DEVELOPMENT WITH RESPECT TO", F_HEADING},
        {"GEOGRAPHICAL", F_FRAME},
        {"MEAN (=1) OR TRUE", F_SUN},
        {"MAPPING FUNCTION", F_MAPPING},
        {"HEIGHT OF SINGLE LAYER", F_HEIGHT},
        {"COORDINATES OF EARTH-CENTERED DIPOLE", F_HEADING},
        {"LATITUDE OF NORTH GEOMAGNETIC POLE", F_POLE_LAT},
        {"EAST LONGITUDE", F_POLE_LON},
        {"PERIOD OF VALIDITY", F_HEADING},
        {"FROM EPOCH", F_FROM},
        {"TO EPOCH", F_TO},
        {"LATITUDE BAND COVERED", F_HEADING},
        {"MINIMUM LATITUDE", F_SOUTH},
        {"MAXIMUM LATITUDE", F_NORTH},
        {"ADDITIONAL INFORMATION", F_HEADING},
        {"NUMBER OF CONTRIBUTING STATIONS", F_STATIONS},
        {"NUMBER OF CONTRIBUTING SATELLITES", F_SATELLITES},
        {"ELEVATION CUT-OFF", F_CUTOFF},
        {"TIME INTERVAL", F_HEADING},
        {"MAXIMUM TEC", F_MAX_TEC},
        {"COMMENT", F_COMMENT},
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (orr_view_starts(label, table[i].start)) return table[i].field;
    return F_UNKNOWN;
}

static orr_status bad_value(ion_reader *r, orr_view label)
{
    char shown[64];
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, ION_LABEL_COLUMNS + 1,
                            "the value of \"%s\" is malformed", orr_view_copy(label, shown, sizeof shown));
}

static bool whole(orr_view v, int lo, int hi, int *out)
{
    int64_t k;
    if (orr_view_int(v, &k) != ORR_FIELD_OK || k < lo || k > hi) return false;
    *out = (int)k;
    return true;
}

static bool real(orr_view v, double factor, double *out)
{
    double k;
    if (orr_view_real(v, &k) != ORR_FIELD_OK) return false;
    *out = k * factor;
    return true;
}

// "2024 02 04 00 00 00", "2024-02-04 00:00:00" and the like: six numbers whatever stands between them.
static bool epoch(orr_view v, orr_time *out)
{
    char text[40];
    if (v.n >= sizeof text) return false;
    memcpy(text, v.p, v.n);
    for (size_t i = 0; i < v.n; i++)
        if (text[i] == '-' || text[i] == '/' || text[i] == ':' || text[i] == ',') text[i] = ' ';
    return orr_records_civil((orr_view){text, v.n}, ORR_SCALE_GPS, NULL, out);
}

static bool set_field(orr_ion_model *m, ion_field field, orr_view v)
{
    orr_view rest = v, first;
    int k;
    bool word = orr_view_word(&rest, &first);
    // An empty value is one not told, except where the model cannot be read without it.
    if (!word) return field != F_DEGREE && field != F_ORDER && field != F_TYPE && field != F_FROM;
    switch (field) {
    case F_NUMBER:
        orr_view_copy(v, m->number, sizeof m->number);
        return true;
    case F_TYPE:
        return whole(first, 1, 3, &k) && (m->type = (orr_ion_type)k, true);
    case F_DEGREE:
        return whole(first, 0, ION_MAX_DEGREE, &m->max_degree);
    case F_ORDER:
        return whole(first, 0, ION_MAX_DEGREE, &m->max_order);
    case F_FRAME:
        return whole(first, 1, 2, &k) && (m->frame = (orr_ion_frame)k, true);
    case F_SUN:
        return whole(first, 1, 2, &k) && (m->sun = (orr_ion_sun)k, true);
    case F_MAPPING:
        return whole(first, 0, 3, &k) && (m->mapping = (orr_ion_mapping)k, true);
    case F_HEIGHT:
        if (!real(first, 1e3, &m->layer_height_m)) return false;
        return !orr_view_word(&rest, &first) || real(first, 1e3, &m->layer_height_rms_m);
    case F_POLE_LAT:
        return real(first, 1, &m->pole_lat_deg) && fabs(m->pole_lat_deg) <= 90;
    case F_POLE_LON:
        return real(first, 1, &m->pole_lon_deg) && fabs(m->pole_lon_deg) <= 360;
    case F_FROM:
        return epoch(v, &m->from);
    case F_TO:
        return epoch(v, &m->to);
    case F_SOUTH:
        return real(first, 1, &m->lat_south_deg);
    case F_NORTH:
        return real(first, 1, &m->lat_north_deg);
    case F_STATIONS:
        return whole(first, 0, 999999, &m->n_stations);
    case F_SATELLITES:
        return whole(first, 0, 999999, &m->n_satellites);
    case F_CUTOFF:
        return real(first, 1, &m->elevation_cutoff_deg);
    case F_MAX_TEC:
        return real(first, 1, &m->max_tec_tecu);
    case F_COMMENT:
        orr_view_copy(v, m->comment, sizeof m->comment);
        return true;
    case F_HEADING:
    case F_UNKNOWN:
        return true;
    }
    return true;
}

static bool is_dashes(orr_view v)
{
    v = orr_view_trim(v);
    if (v.n < 10) return false;
    for (size_t i = 0; i < v.n; i++)
        if (v.p[i] != '-') return false;
    return true;
}

static orr_status ended(ion_reader *r, const char *where)
{
    orr_status s = orr_cursor_status(&r->c, r->diag);
    if (s != ORR_OK) return s;
    return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the file ends inside %s: it is cut short",
                            where);
}

// From the line after the dashes to COEFFICIENTS and its column title.
static orr_status read_header(ion_reader *r, orr_ion_model *m)
{
    orr_view line;
    while (orr_cursor_next(&r->c, &line)) {
        orr_view label = orr_view_trim(orr_view_cols(line, 1, ION_LABEL_COLUMNS));
        if (label.n > 0 && label.p[label.n - 1] == ':')
            label = orr_view_rtrim((orr_view){label.p, label.n - 1});
        if (orr_view_is_blank(line)) continue;
        if (orr_view_starts(label, "COEFFICIENTS")) {
            if (!orr_cursor_next(&r->c, &line)) return ended(r, "a model's header");
            if (orr_view_contains(line, "TECU**2"))
                return orr_cursor_error(&r->c, r->diag, ORR_E_UNSUPPORTED, 1,
                                        "a stochastic component (TECU**2) is no map of electron content");
            if (!orr_view_starts(orr_view_trim(line), "DEGREE"))
                return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                        "expected the column title DEGREE  ORDER  VALUE  RMS");
            return ORR_OK;
        }
        ion_field field = field_of(label);
        orr_view value = orr_view_trim(orr_view_cols(line, ION_LABEL_COLUMNS + 1, 4096));
        if (field == F_UNKNOWN) {
            char shown[64];
            orr_cursor_warn(&r->c, r->warnings, 1, "header line \"%s\" is not known and passed over",
                            orr_view_copy(label, shown, sizeof shown));
        } else if (!set_field(m, field, value)) {
            return bad_value(r, label);
        }
    }
    return ended(r, "a model's header");
}

static orr_status read_row(ion_reader *r, orr_ion_model *m, orr_view line)
{
    orr_ion_coefficient k = {.rms_tecu = ORR_NAN};
    // Rows are of one length: a shorter one at the very end of a file may hold half a number.
    size_t length = orr_view_rtrim(line).n;
    if (r->c.unterminated && length < r->row_length)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "the file ends inside a row: it is cut short");
    r->row_length = length;
    int64_t n, o;
    orr_view rest = line, word;
    static const char *const what[] = {"degree", "order", "value"};
    // Blanks separate the fields: 18 and 11 columns leave room for any value Bernese writes.
    for (int i = 0; i < 3; i++) {
        orr_field got = ORR_FIELD_BLANK;
        if (orr_view_word(&rest, &word))
            got = i == 0   ? orr_view_int(word, &n)
                  : i == 1 ? orr_view_int(word, &o)
                           : orr_view_real(word, &k.tecu);
        if (got != ORR_FIELD_OK)
            return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                    "the %s of a coefficient is missing or malformed", what[i]);
    }
    if (orr_view_word(&rest, &word) && orr_view_real(word, &k.rms_tecu) != ORR_FIELD_OK)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 31, "the RMS of a coefficient is malformed");
    if (n < 0 || n > ION_MAX_DEGREE || o > ION_MAX_DEGREE || o < -ION_MAX_DEGREE ||
        (m->type != ORR_ION_LOCAL && (o > n || o < -n)))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1, "degree %lld with order %lld is no harmonic",
                                (long long)n, (long long)o);
    if ((m->max_degree >= 0 && n > m->max_degree) || (m->max_order >= 0 && llabs(o) > m->max_order))
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 1,
                                "degree %lld, order %lld is beyond the model's own maximum of %d, %d",
                                (long long)n, (long long)o, m->max_degree, m->max_order);
    k.degree = (int)n;
    k.order = (int)o;
    if (++r->coefficients > r->limits.max_values)
        return orr_cursor_error(&r->c, r->diag, ORR_E_LIMIT, 0, "more than %zu coefficients",
                                r->limits.max_values);
    orr_status s = orr_records_grow(&m->coefficient, m->n_coefficients, sizeof *m->coefficient,
                                    r->limits.max_values, "coefficients", &r->c, r->diag);
    if (s == ORR_OK) m->coefficient[m->n_coefficients++] = k;
    return s;
}

// How many coefficients a full expansion has.
static size_t full_count(const orr_ion_model *m)
{
    size_t n = 0;
    for (int d = 0; d <= m->max_degree; d++) n += (size_t)(2 * (d < m->max_order ? d : m->max_order) + 1);
    return n;
}

static int by_harmonic(const void *a, const void *b)
{
    const orr_ion_coefficient *x = a, *y = b;
    if (x->degree != y->degree) return x->degree < y->degree ? -1 : 1;
    return (x->order > y->order) - (x->order < y->order);
}

static orr_status check_model(ion_reader *r, const orr_ion_model *m)
{
    if (m->n_coefficients == 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "a model without coefficients");
    if (m->max_degree < 0 || m->max_order < 0)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "the model's header has no maximum degree and order");
    if (m->from == ORR_TIME_NONE)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0, "the model's header has no epoch");
    if (m->to != ORR_TIME_NONE && m->to < m->from)
        return orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                "the model's validity ends before it starts");
    orr_ion_coefficient *sorted = malloc(m->n_coefficients * sizeof *sorted);
    if (sorted == NULL)
        return orr_cursor_error(&r->c, r->diag, ORR_E_MEMORY, 0, "no memory for coefficients");
    memcpy(sorted, m->coefficient, m->n_coefficients * sizeof *sorted);
    qsort(sorted, m->n_coefficients, sizeof *sorted, by_harmonic);
    orr_status s = ORR_OK;
    for (size_t i = 1; s == ORR_OK && i < m->n_coefficients; i++)
        if (by_harmonic(&sorted[i - 1], &sorted[i]) == 0)
            s = orr_cursor_error(&r->c, r->diag, ORR_E_FORMAT, 0,
                                 "degree %d, order %d stands twice in a model", sorted[i].degree,
                                 sorted[i].order);
    free(sorted);
    if (s == ORR_OK && m->type != ORR_ION_LOCAL && m->n_coefficients != full_count(m))
        orr_cursor_warn(&r->c, r->warnings, 0, "a model of degree %d, order %d has %zu coefficients, not %zu",
                        m->max_degree, m->max_order, m->n_coefficients, full_count(m));
    return s;
}

static orr_status read_model(ion_reader *r, orr_ion_model *m)
{
    memcpy(m->title, r->title, sizeof m->title);
    orr_status s = read_header(r, m);
    orr_view line;
    bool more = true;
    while (s == ORR_OK && (more = orr_cursor_next(&r->c, &line)) && !orr_view_is_blank(line)) {
        // A row begins with its degree; text among the rows is told and passed over, but a damaged row is not: every
        // place on the Earth would lack its harmonic.
        orr_view rest = line, word;
        int64_t degree;
        if (!r->c.unterminated && orr_view_word(&rest, &word) && orr_view_int(word, &degree) != ORR_FIELD_OK)
            orr_records_leave_out(&r->tally, &r->c, 1, "a line that is no row of coefficients", r->warnings);
        else if ((s = read_row(r, m, line)) == ORR_OK)
            r->tally.good++;
    }
    if (s == ORR_OK) s = orr_records_verdict(&r->tally, r->diag);
    if (s == ORR_OK) s = orr_cursor_status(&r->c, r->diag);
    if (s == ORR_OK) s = check_model(r, m);
    // The format has no end mark but the blank line after a model's rows.
    if (s == ORR_OK && !more && m->type != ORR_ION_LOCAL && m->n_coefficients < full_count(m))
        s = ended(r, "a model's coefficients");
    return s;
}

static int by_start(const void *a, const void *b)
{
    const orr_ion_model *x = a, *y = b;
    return (x->from > y->from) - (x->from < y->from);
}

static void sort_models(ion_reader *r)
{
    orr_ion *x = r->out;
    for (size_t i = 1; i < x->n_models; i++) {
        if (x->model[i].type == ORR_ION_STATION || x->model[i].from >= x->model[i - 1].from) continue;
        orr_warnings_add(r->warnings, r->c.name, 0, 0,
                         "models are not in the order of time; they were sorted");
        qsort(x->model, x->n_models, sizeof *x->model, by_start);
        return;
    }
}

orr_status orr_ion_parse(const char *name, const char *text, size_t n, const orr_read_limits *limits,
                         orr_ion *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_ion){0};
    ion_reader r = {.out = out, .warnings = warnings, .diag = diag};
    r.limits = limits != NULL ? *limits : orr_read_default_limits();
    orr_cursor_init(&r.c, name, text, n);
    orr_view line;
    orr_status s = ORR_OK;
    bool titled = false;
    while (s == ORR_OK && orr_cursor_next(&r.c, &line)) {
        if (orr_view_is_blank(line)) continue;
        if (!titled && is_dashes(line)) { // a blank title
            r.title[0] = '\0';
        } else if (!titled) {
            orr_view_copy(orr_view_rtrim(line), r.title, sizeof r.title);
            titled = true;
            continue;
        } else if (!is_dashes(line)) {
            s = orr_cursor_error(&r.c, diag, out->n_models == 0 ? ORR_E_KIND : ORR_E_FORMAT, 1,
                                 "expected the line of dashes below a model's title%s",
                                 out->n_models == 0 ? ": not a Bernese .ION file" : "");
            break;
        }
        titled = false;
        s = orr_records_grow(&out->model, out->n_models, sizeof *out->model, r.limits.max_records, "models",
                             &r.c, diag);
        if (s != ORR_OK) break;
        out->model[out->n_models] = untold();
        s = read_model(&r, &out->model[out->n_models++]);
    }
    if (s == ORR_OK) s = orr_cursor_status(&r.c, diag);
    if (s == ORR_OK && out->n_models == 0)
        s = orr_cursor_error(&r.c, diag, ORR_E_KIND, 0, "not a Bernese .ION file: there is no model");
    if (s == ORR_OK && titled)
        orr_cursor_warn(&r.c, warnings, 1, "the file ends after a title without its model");
    if (s == ORR_OK) sort_models(&r);
    if (s != ORR_OK) orr_ion_free(out);
    return s;
}

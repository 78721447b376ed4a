// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/archive/record.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/nan.h"
#include "core/outfile.h"
#include "core/path.h"
#include "core/robust.h"
#include "src/archive/store.h"

void orr_archive_key(const char *program, const char *options, const orr_archive_file *input, size_t n,
                     char key[ORR_SHA256_HEX])
{
    char text[8192];
    size_t at = (size_t)snprintf(text, sizeof text, "%.63s\n%.1023s\n", program, options);
    for (size_t i = 0; i < n && at < sizeof text - 400; i++)
        at += (size_t)snprintf(text + at, sizeof text - at, "%.255s %.64s\n", input[i].name, input[i].sha256);
    if (orr_sha256_bytes(text, at, key, NULL) != ORR_OK) key[0] = '\0';
}

void orr_archive_take_file(orr_archive_file *f, const char *path, const char *sha256)
{
    *f = (orr_archive_file){.bytes = -1};
    snprintf(f->name, sizeof f->name, "%s", orr_base_name(path));
    snprintf(f->sha256, sizeof f->sha256, "%s", sha256);
}

orr_status orr_archive_note_product(orr_archive_record *r, const char *folder, const char *name,
                                    orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH];
    struct stat st;
    orr_archive_file *f = &r->product[r->n_products++];
    snprintf(path, sizeof path, "%.900s/%s", folder, name);
    snprintf(f->name, sizeof f->name, "%s", name);
    f->bytes = stat(path, &st) == 0 ? (int64_t)st.st_size : -1;
    return orr_sha256_file(path, f->sha256, diag);
}

// --- Quality ---

// Adds what one satellite has; sums of squares stand in residual_mm until the end.
static void add_satellite(const orr_orbit_sat *sat, orr_archive_quality *q)
{
    q->satellites++;
    for (size_t i = 0; i < sat->n_nodes; i++) {
        const orr_orbit_node *node = &sat->node[i];
        if (!node->used) {
            q->left_out++;
            continue;
        }
        q->nodes++;
        q->residual_mm += 1e6 * orr_vec3_dot(node->residual_m, node->residual_m);
    }
    for (size_t i = 0; i < sat->n_events; i++) {
        q->manoeuvres += sat->event[i].kind == ORR_EVENT_MANOEUVRE;
        q->gaps += sat->event[i].kind == ORR_EVENT_GAP;
    }
}

// Median of the sigma of all samples of a system ('*': of all).
static double median_sigma_mm(const orr_orbit_solution *s, char system)
{
    size_t n = 0;
    for (size_t i = 0; i < s->n_sats; i++)
        for (size_t k = 0; k < s->sat[i].n_arcs; k++) n += s->sat[i].arc[k].n;
    double *v = malloc((n + 1) * sizeof *v);
    if (v == NULL) return ORR_NAN;
    n = 0;
    for (size_t i = 0; i < s->n_sats; i++) {
        if (system != '*' && orr_sat_system(s->sat[i].sat) != system) continue;
        for (size_t k = 0; k < s->sat[i].n_arcs; k++)
            for (size_t j = 0; j < s->sat[i].arc[k].n; j++) {
                const double sigma = (double)s->sat[i].arc[k].sample[j].sigma_m;
                if (isfinite(sigma)) v[n++] = 1e3 * sigma;
            }
    }
    const double median = n > 0 ? orr_median(v, n) : ORR_NAN;
    free(v);
    return median;
}

void orr_archive_judge(const orr_orbit_solution *s, orr_archive_record *r)
{
    r->n_quality = 1;
    r->quality[0] = (orr_archive_quality){.system = '*'};
    for (size_t i = 0; i < s->n_sats; i++) {
        const char system = orr_sat_system(s->sat[i].sat);
        size_t k = 1;
        while (k < r->n_quality && r->quality[k].system != system) k++;
        if (k == r->n_quality) r->quality[r->n_quality++] = (orr_archive_quality){.system = system};
        add_satellite(&s->sat[i], &r->quality[0]);
        add_satellite(&s->sat[i], &r->quality[k]);
    }
    for (size_t k = 0; k < r->n_quality; k++) {
        orr_archive_quality *q = &r->quality[k];
        q->residual_mm = q->nodes > 0 ? sqrt(q->residual_mm / (double)q->nodes) : ORR_NAN;
        q->sigma_mm = median_sigma_mm(s, q->system);
    }
}

// --- Writing ---

static json_t *text(const char *s)
{
    json_t *j = json_string(s);
    return j != NULL ? j : json_string("?"); // no UTF-8: a name of anyone's
}

// Rounded to what is worth keeping, so that the text does not depend on the last bit.
static json_t *number(double v, double unit)
{
    return isfinite(v) ? json_real(nearbyint(v / unit) * unit) : json_null();
}

static json_t *files(const orr_archive_file *f, size_t n)
{
    json_t *list = json_array();
    for (size_t i = 0; i < n; i++) {
        json_t *j = json_pack("{s:o, s:s}", "name", text(f[i].name), "sha256", f[i].sha256);
        if (f[i].bytes >= 0) json_object_set_new(j, "bytes", json_integer(f[i].bytes));
        json_array_append_new(list, j);
    }
    return list;
}

static json_t *quality(const orr_archive_record *r)
{
    json_t *list = json_array();
    for (size_t i = 0; i < r->n_quality; i++) {
        const orr_archive_quality *q = &r->quality[i];
        const char system[2] = {q->system, '\0'};
        json_array_append_new(
            list, json_pack("{s:s, s:I, s:I, s:I, s:I, s:I, s:o, s:o}", "system",
                            q->system == '*' ? "all" : system, "satellites", (json_int_t)q->satellites,
                            "nodes", (json_int_t)q->nodes, "left_out", (json_int_t)q->left_out, "manoeuvres",
                            (json_int_t)q->manoeuvres, "gaps", (json_int_t)q->gaps, "residual_mm",
                            number(q->residual_mm, 1e-4), "sigma_mm", number(q->sigma_mm, 1e-4)));
    }
    return list;
}

static json_t *stations(const orr_archive_record *r)
{
    json_t *list = json_array();
    for (size_t i = 0; i < r->n_stations; i++)
        json_array_append_new(list, json_pack("{s:s, s:I, s:I, s:o}", "station", r->station[i].name, "arcs",
                                              (json_int_t)r->station[i].arcs, "samples",
                                              (json_int_t)r->station[i].samples, "dstec_tecu",
                                              number(r->station[i].dstec_tecu, 1e-4)));
    return list;
}

orr_status orr_archive_record_write(const orr_archive_record *r, const char *folder, orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH], day[ORR_ARCHIVE_DAY_TEXT], until[ORR_TIME_TEXT];
    snprintf(path, sizeof path, "%.900s/" ORR_ARCHIVE_RECORD, folder);
    json_t *notes = json_array();
    for (size_t i = 0; i < r->n_notes; i++) json_array_append_new(notes, text(r->note[i]));
    json_t *j = json_pack("{s:i, s:s, s:s, s:o, s:s, s:b, s:b, s:o, s:o, s:o, s:o}", "schema",
                          ORR_ARCHIVE_SCHEMA, "day", orr_archive_day_text(r->mjd, day), "program", r->program,
                          "options", text(r->options), "key", r->key, "day_before", r->before, "day_after",
                          r->after, "inputs", files(r->input, r->n_inputs), "products",
                          files(r->product, r->n_products), "quality", quality(r), "notes", notes);
    orr_outfile f;
    if (j != NULL && r->n_stations > 0) json_object_set_new(j, "stations", stations(r));
    if (j == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the record of %s", folder);
    if (orr_archive_is_predicted(r))
        json_object_set_new(j, "observed_until", text(orr_time_text(r->observed_until, until)));
    orr_status s = orr_outfile_open(path, &f, diag);
    if (s == ORR_OK) {
        if (json_dumpf(j, f.stream, JSON_INDENT(1) | JSON_REAL_PRECISION(9)) != 0)
            s = orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be written: %s", strerror(errno));
        fputc('\n', f.stream);
        s = orr_outfile_end(&f, s, diag);
    }
    json_decref(j);
    return s;
}

// --- Reading ---

static void take_text(const json_t *j, const char *key, char *out, size_t n)
{
    const char *value = json_string_value(json_object_get(j, key));
    snprintf(out, n, "%s", value != NULL ? value : "");
}

static double take_number(const json_t *j, const char *key)
{
    const json_t *v = json_object_get(j, key);
    return json_is_number(v) ? json_number_value(v) : ORR_NAN;
}

static size_t take_count(const json_t *j, const char *key)
{
    const json_int_t n = json_integer_value(json_object_get(j, key));
    return n > 0 ? (size_t)n : 0;
}

static size_t take_files(const json_t *j, const char *key, orr_archive_file *f, size_t most)
{
    const json_t *list = json_object_get(j, key);
    size_t n = json_array_size(list);
    if (n > most) n = most;
    for (size_t i = 0; i < n; i++) {
        const json_t *one = json_array_get(list, i);
        take_text(one, "name", f[i].name, sizeof f[i].name);
        take_text(one, "sha256", f[i].sha256, sizeof f[i].sha256);
        const json_t *bytes = json_object_get(one, "bytes");
        f[i].bytes = json_is_integer(bytes) ? json_integer_value(bytes) : -1;
    }
    return n;
}

static void take_quality(const json_t *j, orr_archive_record *r)
{
    const json_t *list = json_object_get(j, "quality");
    r->n_quality = json_array_size(list);
    if (r->n_quality > ORR_N_SYSTEMS + 1) r->n_quality = ORR_N_SYSTEMS + 1;
    for (size_t i = 0; i < r->n_quality; i++) {
        const json_t *one = json_array_get(list, i);
        char system[8];
        take_text(one, "system", system, sizeof system);
        r->quality[i] = (orr_archive_quality){.system = strcmp(system, "all") == 0 ? '*' : system[0],
                                              .satellites = take_count(one, "satellites"),
                                              .nodes = take_count(one, "nodes"),
                                              .left_out = take_count(one, "left_out"),
                                              .manoeuvres = take_count(one, "manoeuvres"),
                                              .gaps = take_count(one, "gaps"),
                                              .residual_mm = take_number(one, "residual_mm"),
                                              .sigma_mm = take_number(one, "sigma_mm")};
    }
}

static void take_stations(const json_t *j, orr_archive_record *r)
{
    const json_t *list = json_object_get(j, "stations");
    r->n_stations = json_array_size(list);
    if (r->n_stations > ORR_ARCHIVE_MAX_STATIONS) r->n_stations = ORR_ARCHIVE_MAX_STATIONS;
    for (size_t i = 0; i < r->n_stations; i++) {
        const json_t *one = json_array_get(list, i);
        orr_archive_station *st = &r->station[i];
        take_text(one, "station", st->name, sizeof st->name);
        st->arcs = take_count(one, "arcs");
        st->samples = take_count(one, "samples");
        st->dstec_tecu = take_number(one, "dstec_tecu");
    }
}

orr_status orr_archive_record_read(const char *folder, orr_archive_record *r, orr_diag *diag)
{
    char path[ORR_ARCHIVE_PATH];
    json_error_t error;
    *r = (orr_archive_record){.observed_until = ORR_TIME_NONE};
    snprintf(path, sizeof path, "%.900s/" ORR_ARCHIVE_RECORD, folder);
    FILE *f = fopen(path, "rb");
    if (f == NULL)
        return orr_diag_at(diag, errno == ENOENT ? ORR_E_NODATA : ORR_E_IO, path, 0, 0,
                           "cannot be opened: %s", strerror(errno));
    json_t *j = json_loadf(f, 0, &error);
    const bool lost = j == NULL && ferror(f) != 0;
    fclose(f);
    if (lost) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read");
    if (j == NULL)
        return orr_diag_at(diag, ORR_E_FORMAT, path, error.line, error.column, "is damaged: %s", error.text);
    const json_int_t schema = json_integer_value(json_object_get(j, "schema"));
    char day[ORR_ARCHIVE_DAY_TEXT], until[ORR_TIME_TEXT];
    orr_time t;
    take_text(j, "day", day, sizeof day);
    orr_status s = ORR_OK;
    if (schema > ORR_ARCHIVE_SCHEMA)
        s = orr_diag_at(diag, ORR_E_UNSUPPORTED, path, 0, 0,
                        "is of schema %lld, of a later program; this one reads up to %d", (long long)schema,
                        ORR_ARCHIVE_SCHEMA);
    else if (schema < 1 || orr_time_parse(day, NULL, &t, NULL) != ORR_OK)
        s = orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "is no record of a day: it has no schema, or no day");
    else {
        r->mjd = orr_archive_day_of(t);
        take_text(j, "program", r->program, sizeof r->program);
        take_text(j, "options", r->options, sizeof r->options);
        take_text(j, "key", r->key, sizeof r->key);
        take_text(j, "observed_until", until, sizeof until);
        if (orr_time_parse(until, NULL, &t, NULL) == ORR_OK) r->observed_until = t;
        r->before = json_is_true(json_object_get(j, "day_before"));
        r->after = json_is_true(json_object_get(j, "day_after"));
        r->n_inputs = take_files(j, "inputs", r->input, ORR_ARCHIVE_MAX_INPUTS);
        r->n_products = take_files(j, "products", r->product, ORR_ARCHIVE_MAX_PRODUCTS);
        take_quality(j, r);
        take_stations(j, r);
        const json_t *notes = json_object_get(j, "notes");
        for (size_t i = 0; i < json_array_size(notes) && i < ORR_ARCHIVE_MAX_NOTES; i++) {
            const char *note = json_string_value(json_array_get(notes, i));
            snprintf(r->note[r->n_notes++], sizeof r->note[0], "%s", note != NULL ? note : "");
        }
    }
    json_decref(j);
    return s;
}

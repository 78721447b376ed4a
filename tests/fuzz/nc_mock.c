// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/nc_mock.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"

#define MAX_DIMS 40
#define MAX_VARS 80
#define MAX_ATTS 120
#define MAX_BYTES ((size_t)1 << 17) // of a variable as it is asked for

typedef struct mock_dim {
    char name[48];
    size_t len;
} mock_dim;
typedef struct mock_var {
    char name[48];
    orr_nc_type type;
    int rank;
    int dim[ORR_NC_MAX_RANK];
    size_t n; // values kept; a variable that an edited dimension makes longer begins anew
    unsigned char *bytes;
} mock_var;
typedef struct mock_att {
    char var[48], name[48], text[128];
    char kind; // t, d, i
    double d;
    int64_t i;
} mock_att;
typedef struct file {
    size_t n_dims, n_vars, n_atts;
    mock_dim dim[MAX_DIMS];
    mock_var var[MAX_VARS];
    mock_att att[MAX_ATTS];
} file;

static file written, base[NC_MOCK_FILES], work;

static size_t size_of(orr_nc_type t)
{
    return t == ORR_NC_DOUBLE || t == ORR_NC_INT64  ? 8
           : t == ORR_NC_FLOAT || t == ORR_NC_INT32 ? 4
           : t == ORR_NC_UINT16                     ? 2
                                                    : 1;
}

static void empty(file *f)
{
    for (size_t k = 0; k < f->n_vars; k++) free(f->var[k].bytes);
    f->n_dims = f->n_vars = f->n_atts = 0;
}

static void name_it(char to[48], const char *from) { snprintf(to, 48, "%s", from != NULL ? from : ""); }

// --- Writing ---

orr_status orr_nc_create(const char *path, orr_nc_writer *w, orr_diag *diag)
{
    (void)path;
    (void)diag;
    *w = (orr_nc_writer){.open = true};
    empty(&written);
    return ORR_OK;
}

orr_status orr_nc_put_dim(orr_nc_writer *w, const char *name, size_t len, orr_diag *diag)
{
    (void)w;
    (void)diag;
    if (written.n_dims == MAX_DIMS) abort();
    mock_dim *d = &written.dim[written.n_dims++];
    name_it(d->name, name);
    d->len = len;
    return ORR_OK;
}

orr_status orr_nc_define_var(orr_nc_writer *w, const char *name, orr_nc_type type, int rank,
                             const char *const dims[], const char *units, const char *long_name,
                             orr_diag *diag)
{
    (void)units;
    (void)long_name;
    (void)diag;
    if (written.n_vars == MAX_VARS) abort();
    mock_var *v = &written.var[written.n_vars++];
    *v = (mock_var){.type = type, .rank = rank, .n = 1};
    name_it(v->name, name);
    for (int i = 0; i < rank; i++) {
        size_t k = 0;
        while (k < written.n_dims && strcmp(written.dim[k].name, dims[i]) != 0) k++;
        if (k == written.n_dims) abort();
        v->dim[i] = (int)k;
        v->n *= written.dim[k].len;
    }
    v->bytes = calloc(v->n + 1, size_of(type));
    if (v->bytes == NULL) abort();
    w->var.next = 0;
    return ORR_OK;
}

orr_status orr_nc_put_rows(orr_nc_writer *w, size_t n, const void *values, orr_diag *diag)
{
    (void)diag;
    const mock_var *v = &written.var[written.n_vars - 1];
    const size_t rows = v->rank > 0 ? written.dim[v->dim[0]].len : 1;
    const size_t row = rows > 0 ? v->n / rows * size_of(v->type) : 0;
    if (w->var.next + n > rows) abort();
    memcpy(v->bytes + w->var.next * row, values, n * row);
    w->var.next += n;
    return ORR_OK;
}

orr_status orr_nc_put_var(orr_nc_writer *w, const char *name, orr_nc_type type, int rank,
                          const char *const dims[], const void *values, const char *units,
                          const char *long_name, orr_diag *diag)
{
    (void)orr_nc_define_var(w, name, type, rank, dims, units, long_name, diag);
    const mock_var *v = &written.var[written.n_vars - 1];
    return orr_nc_put_rows(w, v->rank > 0 ? written.dim[v->dim[0]].len : 1, values, diag);
}

static mock_att *new_att(const char *var, const char *name, char kind)
{
    if (written.n_atts == MAX_ATTS) abort();
    mock_att *a = &written.att[written.n_atts++];
    *a = (mock_att){.kind = kind};
    name_it(a->var, var);
    name_it(a->name, name);
    return a;
}

orr_status orr_nc_put_att_text(orr_nc_writer *w, const char *var, const char *name, const char *text,
                               orr_diag *diag)
{
    (void)w;
    (void)diag;
    mock_att *a = new_att(var, name, 't');
    snprintf(a->text, sizeof a->text, "%s", text);
    return ORR_OK;
}

orr_status orr_nc_put_att_double(orr_nc_writer *w, const char *var, const char *name, const double *v,
                                 size_t n, orr_diag *diag)
{
    (void)w;
    (void)diag;
    if (n == 1) new_att(var, name, 'd')->d = *v; // the others are for people
    return ORR_OK;
}

orr_status orr_nc_put_att_int64(orr_nc_writer *w, const char *var, const char *name, const int64_t *v,
                                size_t n, orr_diag *diag)
{
    (void)w;
    (void)diag;
    if (n == 1) new_att(var, name, 'i')->i = *v;
    return ORR_OK;
}

orr_status orr_nc_put_provenance(orr_nc_writer *w, const char *title, const char *history,
                                 const orr_nc_input *input, size_t n_inputs, orr_diag *diag)
{
    (void)input;
    (void)n_inputs;
    orr_nc_put_att_text(w, NULL, "title", title, diag);
    return orr_nc_put_att_text(w, NULL, "history", history != NULL ? history : "", diag);
}

orr_status orr_nc_commit(orr_nc_writer *w, orr_diag *diag)
{
    (void)diag;
    w->open = false;
    return ORR_OK;
}

void orr_nc_abort(orr_nc_writer *w) { w->open = false; }

static void copy(const file *from, file *to)
{
    empty(to);
    to->n_dims = from->n_dims;
    to->n_vars = from->n_vars;
    to->n_atts = from->n_atts;
    memcpy(to->dim, from->dim, from->n_dims * sizeof to->dim[0]);
    memcpy(to->var, from->var, from->n_vars * sizeof to->var[0]);
    memcpy(to->att, from->att, from->n_atts * sizeof to->att[0]);
    for (size_t k = 0; k < to->n_vars; k++) {
        size_t bytes = from->var[k].n * size_of(from->var[k].type) + 1;
        to->var[k].bytes = malloc(bytes);
        if (to->var[k].bytes == NULL) abort();
        memcpy(to->var[k].bytes, from->var[k].bytes, bytes);
    }
}

void nc_mock_keep(unsigned k) { copy(&written, &base[k]); }

// --- Editing ---

static double special(unsigned k)
{
    static const double v[] = {
        0.0,    -0.0, 1.0, -1.0, (double)NAN, HUGE_VAL,          -HUGE_VAL, 1e308, -1e308, 1e-308,
        5e-324, 2.0,  0.5, 1e18, -1e18,       3.141592653589793, 1e10,      1e-10, 6.4e6,  86400.0};
    return v[k % (sizeof v / sizeof v[0])];
}

static void set_value(mock_var *v, size_t at, double d, uint64_t raw)
{
    unsigned char *p = v->bytes + at * size_of(v->type);
    float single = (float)d;
    if (v->type == ORR_NC_DOUBLE)
        memcpy(p, &d, sizeof d);
    else if (v->type == ORR_NC_FLOAT)
        memcpy(p, &single, sizeof single);
    else
        memcpy(p, &raw, size_of(v->type));
}

static void edit_var(mock_var *v, unsigned what, size_t at, uint64_t raw)
{
    double d, near = 0.0;
    memcpy(&d, &raw, sizeof d);
    if (v->n == 0) return;
    at %= v->n;
    if (v->type == ORR_NC_DOUBLE) memcpy(&near, v->bytes + at * sizeof near, sizeof near);
    switch (what % 6) {
    case 0:
        set_value(v, at, d, raw);
        break;
    case 1:
        set_value(v, at, special((unsigned)raw), (uint64_t)(int64_t)(int8_t)raw);
        break;
    case 2: // all of them
        for (size_t k = 0; k < v->n; k++)
            set_value(v, k, special((unsigned)raw), (uint64_t)(int64_t)(int8_t)raw);
        break;
    case 3: // a little more, or many times as much
        set_value(v, at, near * special((unsigned)raw), raw & 0xffff);
        break;
    case 4: // the same as its neighbour
        memcpy(v->bytes + at * size_of(v->type), v->bytes + (at + 1) % v->n * size_of(v->type),
               size_of(v->type));
        break;
    default:
        if (raw % 4 == 0)
            v->name[0] = '\0'; // gone
        else if (raw % 4 == 1)
            v->rank = (int)(raw / 4 % (ORR_NC_MAX_RANK + 1));
        else
            v->dim[raw / 4 % ORR_NC_MAX_RANK] = (int)(raw / 16 % work.n_dims);
    }
}

static void edit_att(mock_att *a, unsigned what, uint64_t raw)
{
    double d;
    memcpy(&d, &raw, sizeof d);
    switch (what % 5) {
    case 0:
        a->d = d;
        a->i = (int64_t)raw;
        break;
    case 1:
        a->d = special((unsigned)raw);
        a->i = (int8_t)raw;
        break;
    case 2:
        a->d *= special((unsigned)raw);
        a->i = raw % 2 == 0 ? INT64_MAX - (int64_t)(raw >> 40) : INT64_MIN + (int64_t)(raw >> 40);
        break;
    case 3:
        a->text[raw % sizeof a->text] = (char)(raw >> 16);
        break;
    default:
        if (raw % 2 == 0)
            a->name[0] = '\0';
        else
            a->kind = "tdi"[raw / 2 % 3];
    }
}

void nc_mock_edit(unsigned k, const uint8_t *data, size_t n)
{
    copy(&base[k], &work);
    for (; n >= 12; data += 12, n -= 12) {
        unsigned what = data[0] / 4, entry = data[1];
        size_t at = data[2] + 256u * data[3];
        uint64_t raw;
        memcpy(&raw, data + 4, sizeof raw);
        switch (data[0] % 4) {
        case 0:
        case 1:
            edit_var(&work.var[entry % work.n_vars], what, at, raw);
            break;
        case 2:
            edit_att(&work.att[entry % work.n_atts], what, raw);
            break;
        default:
            work.dim[entry % work.n_dims].len = what % 2 == 0 ? at % 300 : (size_t)(raw % 100000000u);
        }
    }
}

// --- Reading ---

orr_status orr_nc_open(const char *path, orr_nc_reader *r, orr_diag *diag)
{
    (void)diag;
    *r = (orr_nc_reader){.open = true};
    snprintf(r->path, sizeof r->path, "%s", path);
    return ORR_OK;
}

orr_status orr_nc_open_memory(const char *name, const void *data, size_t n, orr_nc_reader *r, orr_diag *diag)
{
    (void)data;
    (void)n;
    return orr_nc_open(name, r, diag);
}

bool orr_nc_is_netcdf(const void *data, size_t n) { return n >= 4 && memcmp(data, "\x89HDF", 4) == 0; }

void orr_nc_close(orr_nc_reader *r) { r->open = false; }

orr_status orr_nc_get_dim(const orr_nc_reader *r, const char *name, size_t max, size_t *len, orr_diag *diag)
{
    for (size_t k = 0; k < work.n_dims; k++) {
        if (strcmp(work.dim[k].name, name) != 0) continue;
        if (work.dim[k].len > max)
            return orr_diag_at(diag, ORR_E_LIMIT, r->path, 0, 0, "dimension \"%s\" is too long", name);
        *len = work.dim[k].len;
        return ORR_OK;
    }
    return orr_diag_at(diag, ORR_E_KIND, r->path, 0, 0, "has no dimension \"%s\"", name);
}

static const mock_var *find_var(const char *name)
{
    for (size_t k = 0; k < work.n_vars; k++)
        if (strcmp(work.var[k].name, name) == 0) return &work.var[k];
    return NULL;
}

bool orr_nc_has_var(const orr_nc_reader *r, const char *name)
{
    (void)r;
    return find_var(name) != NULL;
}

static orr_status check(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                        const size_t shape[], const mock_var **out, size_t *n, orr_diag *diag)
{
    const mock_var *v = *out = find_var(name);
    if (v == NULL) return orr_diag_at(diag, ORR_E_KIND, r->path, 0, 0, "has no variable \"%s\"", name);
    bool good = v->rank == rank && v->type == type;
    *n = 1;
    for (int i = 0; good && i < rank; i++) {
        good = work.dim[v->dim[i]].len == shape[i] && (shape[i] == 0 || *n <= MAX_BYTES / 8 / shape[i]);
        if (good) *n *= shape[i];
    }
    return good ? ORR_OK
                : orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "variable \"%s\" is of another shape", name);
}

static void fill(const mock_var *v, size_t n, void *out)
{
    size_t size = size_of(v->type);
    for (size_t k = 0; k < n; k++)
        if (v->n > 0)
            memcpy((unsigned char *)out + k * size, v->bytes + k % v->n * size, size);
        else
            memset((unsigned char *)out + k * size, 0, size);
}

orr_status orr_nc_get_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                          const size_t shape[], void *out, orr_diag *diag)
{
    const mock_var *v;
    size_t n;
    orr_status s = check(r, name, type, rank, shape, &v, &n, diag);
    if (s == ORR_OK) fill(v, n, out);
    return s;
}

orr_status orr_nc_alloc_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                            const size_t shape[], void **out, orr_diag *diag)
{
    const mock_var *v;
    size_t n;
    *out = NULL;
    orr_status s = check(r, name, type, rank, shape, &v, &n, diag);
    if (s != ORR_OK) return s;
    *out = malloc(n > 0 ? n * size_of(type) : 1); // exact, so that a step past the end is seen
    if (*out == NULL) abort();
    fill(v, n, *out);
    return ORR_OK;
}

static const mock_att *find_att(const char *var, const char *name)
{
    for (size_t k = 0; k < work.n_atts; k++)
        if (strcmp(work.att[k].name, name) == 0 && strcmp(work.att[k].var, var != NULL ? var : "") == 0)
            return &work.att[k];
    return NULL;
}

orr_status orr_nc_get_att_text(const orr_nc_reader *r, const char *var, const char *name, char *buf, size_t n,
                               orr_diag *diag)
{
    const mock_att *a = find_att(var, name);
    if (a == NULL) return ORR_E_NODATA;
    if (a->kind != 't')
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" should be a text", name);
    size_t len = strnlen(a->text, sizeof a->text);
    if (len >= n) return orr_diag_at(diag, ORR_E_LIMIT, r->path, 0, 0, "attribute \"%s\" is too long", name);
    memcpy(buf, a->text, len);
    buf[len] = '\0';
    return ORR_OK;
}

orr_status orr_nc_get_att_double(const orr_nc_reader *r, const char *var, const char *name, double *v,
                                 orr_diag *diag)
{
    const mock_att *a = find_att(var, name);
    if (a == NULL) return ORR_E_NODATA;
    if (a->kind == 't')
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" should be one number", name);
    *v = a->kind == 'd' ? a->d : (double)a->i;
    return ORR_OK;
}

orr_status orr_nc_get_att_int64(const orr_nc_reader *r, const char *var, const char *name, int64_t *v,
                                orr_diag *diag)
{
    const mock_att *a = find_att(var, name);
    if (a == NULL) return ORR_E_NODATA;
    if (a->kind == 't' || (a->kind == 'd' && !(fabs(a->d) < 9e18)))
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" should be one number", name);
    *v = a->kind == 'i' ? a->i : (int64_t)a->d;
    return ORR_OK;
}

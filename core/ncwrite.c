// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include <netcdf.h>

#include "core/ncfile.h"
#include "core/ncseal.h"
#include "core/path.h"

static const nc_type NC_TYPE[] = {
    [ORR_NC_DOUBLE] = NC_DOUBLE, [ORR_NC_INT64] = NC_INT64, [ORR_NC_INT32] = NC_INT,
    [ORR_NC_UINT16] = NC_USHORT, [ORR_NC_UINT8] = NC_UBYTE, [ORR_NC_CHAR] = NC_CHAR,
    [ORR_NC_FLOAT] = NC_FLOAT,
};

// A file that HDF5 could not write stays open: closing it means writing it, which HDF5 does not survive. The library is
// the process's, and so is this.
static atomic_bool left_open;

bool orr_nc_left_open(void) { return atomic_load(&left_open); }

static orr_status failed(orr_nc_writer *w, int rc, const char *what, const char *name, orr_diag *diag)
{
    // HDF5 does not tell the system's reason; another write does, for it is the disk that is full.
    if (rc == NC_EHDFERR && w->open && !orr_outfile_takes_more(&w->file)) {
        w->unwritable = true;
        w->status = orr_diag_at(diag, ORR_E_IO, w->file.path, 0, 0, "cannot be written: %s", strerror(errno));
        return w->status;
    }
    w->status = orr_diag_at(diag, ORR_E_IO, w->file.path, 0, 0, "cannot be written: %s \"%s\": %s", what,
                            name, nc_strerror(rc));
    return w->status;
}

orr_status orr_nc_create(const char *path, orr_nc_writer *w, orr_diag *diag)
{
    *w = (orr_nc_writer){0};
    w->status = orr_outfile_reserve(path, &w->file, diag);
    if (w->status != ORR_OK) return w->status;
    int rc = nc_create(w->file.temp, NC_CLOBBER | NC_NETCDF4, &w->id);
    if (rc != NC_NOERR) {
        orr_status s = failed(w, rc, "file", path, diag);
        orr_outfile_abort(&w->file);
        return s;
    }
    w->open = true;
    return ORR_OK;
}

static bool refused(orr_nc_writer *w, orr_diag *diag)
{
    if (w->status == ORR_OK && w->open) return false;
    if (w->status == ORR_OK) w->status = orr_diag_set(diag, ORR_E_ARG, "no NetCDF file is being written");
    return true; // the diagnostic of the first failure stands
}

orr_status orr_nc_put_dim(orr_nc_writer *w, const char *name, size_t len, orr_diag *diag)
{
    if (refused(w, diag)) return w->status;
    if (len == 0) { // NetCDF reads a length of 0 as "unlimited", which is another thing
        w->status = orr_diag_set(diag, ORR_E_ARG, "dimension \"%s\" would be empty", name);
        return w->status;
    }
    int dim, rc = nc_def_dim(w->id, name, len, &dim);
    return rc == NC_NOERR ? ORR_OK : failed(w, rc, "dimension", name, diag);
}

// Small variables are not worth a chunk index and a deflate stream.
#define COMPRESS_FROM_VALUES 1024
// Large ones are cut into chunks that are written as rows come, and are not kept in memory once they are written.
#define LARGE_BYTES ((size_t)8 << 20)
#define CHUNK_BYTES ((size_t)1 << 20)

static int cut_rows(const orr_nc_writer *w, int var, int rank, size_t value_bytes)
{
    int storage;
    size_t chunk[ORR_NC_MAX_RANK], bytes = value_bytes;
    int rc = nc_inq_var_chunking(w->id, var, &storage, chunk);
    if (rc != NC_NOERR) return rc;
    for (int i = 0; i < rank; i++) bytes *= chunk[i];
    if (storage != NC_CHUNKED || bytes <= CHUNK_BYTES) return NC_NOERR;
    chunk[0] = chunk[0] * CHUNK_BYTES / bytes;
    if (chunk[0] < 1) chunk[0] = 1;
    return nc_def_var_chunking(w->id, var, NC_CHUNKED, chunk);
}

orr_status orr_nc_define_var(orr_nc_writer *w, const char *name, orr_nc_type type, int rank,
                             const char *const dims[], const char *units, const char *long_name,
                             orr_diag *diag)
{
    if (refused(w, diag)) return w->status;
    if (rank < 0 || rank > ORR_NC_MAX_RANK) {
        w->status = orr_diag_set(diag, ORR_E_ARG, "variable \"%s\" cannot have %d dimensions", name, rank);
        return w->status;
    }
    int dim[ORR_NC_MAX_RANK] = {0}, var;
    size_t count = 1, value_bytes;
    w->var.rank = rank;
    w->var.next = 0;
    for (int i = 0; i < rank; i++) {
        int rc = nc_inq_dimid(w->id, dims[i], &dim[i]);
        if (rc == NC_NOERR) rc = nc_inq_dimlen(w->id, dim[i], &w->var.shape[i]);
        if (rc != NC_NOERR) return failed(w, rc, "dimension", dims[i], diag);
        count *= w->var.shape[i];
    }
    int rc = nc_inq_type(w->id, NC_TYPE[type], NULL, &value_bytes);
    if (rc == NC_NOERR) rc = nc_def_var(w->id, name, NC_TYPE[type], rank, dim, &var);
    w->var.large = rc == NC_NOERR && rank > 0 && count * value_bytes > LARGE_BYTES;
    // shuffle groups the bytes of equal weight, which makes doubles of one kind compress; level 4 is zlib's
    // knee
    if (rc == NC_NOERR && count >= COMPRESS_FROM_VALUES && !w->uncompressed)
        rc = nc_def_var_deflate(w->id, var, 1, 1, 4);
    if (rc == NC_NOERR && w->var.large) rc = cut_rows(w, var, rank, value_bytes);
    if (rc == NC_NOERR && units != NULL) rc = nc_put_att_text(w->id, var, "units", strlen(units), units);
    if (rc == NC_NOERR && long_name != NULL)
        rc = nc_put_att_text(w->id, var, "long_name", strlen(long_name), long_name);
    if (rc != NC_NOERR) return failed(w, rc, "variable", name, diag);
    w->var.id = var;
    return ORR_OK;
}

orr_status orr_nc_put_rows(orr_nc_writer *w, size_t n, const void *values, orr_diag *diag)
{
    if (refused(w, diag)) return w->status;
    const size_t rows = w->var.rank > 0 ? w->var.shape[0] : 1;
    size_t start[ORR_NC_MAX_RANK] = {w->var.next}, count[ORR_NC_MAX_RANK] = {n};
    if (n > rows - w->var.next) {
        w->status = orr_diag_set(diag, ORR_E_ARG, "a variable of %zu rows is given more", rows);
        return w->status;
    }
    for (int i = 1; i < w->var.rank; i++) count[i] = w->var.shape[i];
    int rc = nc_put_vara(w->id, w->var.id, start, count, values);
    w->var.next += n;
    // A changed cache is a fresh one: what it held is written.
    if (rc == NC_NOERR && w->var.large && w->var.next == rows)
        rc = nc_set_var_chunk_cache(w->id, w->var.id, CHUNK_BYTES, 1, 0.75F);
    if (rc == NC_NOERR) return ORR_OK;
    char name[NC_MAX_NAME + 1] = "";
    (void)nc_inq_varname(w->id, w->var.id, name);
    return failed(w, rc, "variable", name, diag);
}

orr_status orr_nc_put_var(orr_nc_writer *w, const char *name, orr_nc_type type, int rank,
                          const char *const dims[], const void *values, const char *units,
                          const char *long_name, orr_diag *diag)
{
    const orr_status s = orr_nc_define_var(w, name, type, rank, dims, units, long_name, diag);
    return s == ORR_OK ? orr_nc_put_rows(w, rank > 0 ? w->var.shape[0] : 1, values, diag) : s;
}

static int var_id(const orr_nc_writer *w, const char *var, int *id)
{
    if (var != NULL) return nc_inq_varid(w->id, var, id);
    *id = NC_GLOBAL;
    return NC_NOERR;
}

orr_status orr_nc_put_att_text(orr_nc_writer *w, const char *var, const char *name, const char *text,
                               orr_diag *diag)
{
    if (refused(w, diag)) return w->status;
    int id, rc = var_id(w, var, &id);
    if (rc == NC_NOERR) rc = nc_put_att_text(w->id, id, name, strlen(text), text);
    return rc == NC_NOERR ? ORR_OK : failed(w, rc, "attribute", name, diag);
}

orr_status orr_nc_put_att_double(orr_nc_writer *w, const char *var, const char *name, const double *v,
                                 size_t n, orr_diag *diag)
{
    if (refused(w, diag)) return w->status;
    int id, rc = var_id(w, var, &id);
    if (rc == NC_NOERR) rc = nc_put_att_double(w->id, id, name, NC_DOUBLE, n, v);
    return rc == NC_NOERR ? ORR_OK : failed(w, rc, "attribute", name, diag);
}

orr_status orr_nc_put_att_int64(orr_nc_writer *w, const char *var, const char *name, const int64_t *v,
                                size_t n, orr_diag *diag)
{
    if (refused(w, diag)) return w->status;
    int id, rc = var_id(w, var, &id);
    nc_type type = NC_INT64;
    if (rc == NC_NOERR && var != NULL) rc = nc_inq_vartype(w->id, id, &type);
    if (rc == NC_NOERR) rc = nc_put_att_longlong(w->id, id, name, type, n, (const long long *)v);
    return rc == NC_NOERR ? ORR_OK : failed(w, rc, "attribute", name, diag);
}

// Texts joined by newlines. Allocated.
static char *join(const orr_nc_input *input, size_t n, bool names)
{
    size_t size = 1;
    for (size_t i = 0; i < n; i++) size += strlen(names ? input[i].path : input[i].sha256) + 1;
    char *text = malloc(size), *p = text;
    if (text == NULL) return NULL;
    for (size_t i = 0; i < n; i++) {
        const char *s = names ? orr_base_name(input[i].path) : input[i].sha256;
        if (i > 0) *p++ = '\n';
        size_t len = strlen(s);
        memcpy(p, s, len);
        p += len;
    }
    *p = '\0';
    return text;
}

orr_status orr_nc_put_provenance(orr_nc_writer *w, const char *title, const char *history,
                                 const orr_nc_input *input, size_t n_inputs, orr_diag *diag)
{
    char source[64];
    snprintf(source, sizeof source, "orrery %s", ORR_VERSION);
    (void)orr_nc_put_att_text(w, NULL, "Conventions", "CF-1.9", diag); // w remembers the first failure
    (void)orr_nc_put_att_text(w, NULL, "title", title, diag);
    (void)orr_nc_put_att_text(w, NULL, "source", source, diag);
    if (history != NULL) (void)orr_nc_put_att_text(w, NULL, "history", history, diag);
    if (n_inputs == 0 || w->status != ORR_OK) return w->status;
    char *names = join(input, n_inputs, true), *sums = join(input, n_inputs, false);
    if (names == NULL || sums == NULL) {
        w->status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the names of %zu inputs", n_inputs);
    } else {
        (void)orr_nc_put_att_text(w, NULL, "input_files", names, diag);
        (void)orr_nc_put_att_text(w, NULL, "input_sha256", sums, diag);
    }
    free(names);
    free(sums);
    return w->status;
}

orr_status orr_nc_commit(orr_nc_writer *w, orr_diag *diag)
{
    if (refused(w, diag)) {
        orr_status s = w->status;
        orr_nc_abort(w);
        return s;
    }
    int rc = nc_close(w->id);
    if (rc != NC_NOERR) {
        const orr_status s = failed(w, rc, "file", w->file.path, diag);
        orr_nc_abort(w);
        return s;
    }
    w->open = false;
    orr_status s = orr_nc_seal(w->file.temp, diag);
    if (s == ORR_OK) s = orr_outfile_commit(&w->file, diag);
    orr_outfile_abort(&w->file);
    *w = (orr_nc_writer){0};
    return s;
}

void orr_nc_abort(orr_nc_writer *w)
{
    if (w->open && w->unwritable)
        atomic_store(&left_open, true);
    else if (w->open)
        (void)nc_close(w->id); // what it holds is thrown away
    orr_outfile_abort(&w->file);
    *w = (orr_nc_writer){0};
}

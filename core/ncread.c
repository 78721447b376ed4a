// SPDX-License-Identifier: GPL-3.0-or-later
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "core/ncfile.h"
#include "core/ncseal.h"

bool orr_nc_is_netcdf(const void *data, size_t n)
{
    static const unsigned char hdf5[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    const unsigned char *b = data;
    if (n >= 8 && memcmp(b, hdf5, 8) == 0) return true;
    return n >= 4 && memcmp(b, "CDF", 3) == 0 && (b[3] == 1 || b[3] == 2 || b[3] == 5);
}

orr_status orr_nc_open(const char *path, orr_nc_reader *r, orr_diag *diag)
{
    *r = (orr_nc_reader){0};
    snprintf(r->path, sizeof r->path, "%s", path);
    FILE *f = fopen(path, "rb");
    if (f == NULL) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be opened: %s", strerror(errno));
    unsigned char head[8];
    size_t n = fread(head, 1, sizeof head, f);
    bool bad = ferror(f) != 0;
    int e = errno;
    fclose(f);
    if (bad) return orr_diag_at(diag, ORR_E_IO, path, 0, 0, "cannot be read: %s", strerror(e));
    if (n == 0) return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "is empty");
    if (!orr_nc_is_netcdf(head, n)) return orr_diag_at(diag, ORR_E_KIND, path, 0, 0, "is no NetCDF file");
    orr_status s = orr_nc_check_seal(path, diag);
    if (s != ORR_OK) return s;
    int rc = nc_open(path, NC_NOWRITE, &r->id);
    if (rc != NC_NOERR)
        return orr_diag_at(diag, ORR_E_FORMAT, path, 0, 0, "is damaged: NetCDF says \"%s\"", nc_strerror(rc));
    r->open = true;
    return ORR_OK;
}

orr_status orr_nc_open_memory(const char *name, const void *data, size_t n, orr_nc_reader *r, orr_diag *diag)
{
    *r = (orr_nc_reader){0};
    snprintf(r->path, sizeof r->path, "%s", name);
    if (!orr_nc_is_netcdf(data, n)) return orr_diag_at(diag, ORR_E_KIND, name, 0, 0, "is no NetCDF file");
    int rc = nc_open_mem(name, NC_NOWRITE, n, (void *)(uintptr_t)data, &r->id);
    if (rc != NC_NOERR)
        return orr_diag_at(diag, ORR_E_FORMAT, name, 0, 0, "is damaged: NetCDF says \"%s\"", nc_strerror(rc));
    r->open = true;
    return ORR_OK;
}

void orr_nc_close(orr_nc_reader *r)
{
    if (r->open) (void)nc_close(r->id); // read only: nothing can be lost
    *r = (orr_nc_reader){0};
}

static orr_status damaged(const orr_nc_reader *r, int rc, const char *what, const char *name, orr_diag *diag)
{
    return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "%s \"%s\" cannot be read: %s", what, name,
                       nc_strerror(rc));
}

orr_status orr_nc_get_dim(const orr_nc_reader *r, const char *name, size_t max, size_t *len, orr_diag *diag)
{
    int dim, rc = nc_inq_dimid(r->id, name, &dim);
    if (rc == NC_EBADDIM)
        return orr_diag_at(diag, ORR_E_KIND, r->path, 0, 0,
                           "has no dimension \"%s\": not the product expected", name);
    size_t n = 0;
    if (rc == NC_NOERR) rc = nc_inq_dimlen(r->id, dim, &n);
    if (rc != NC_NOERR) return damaged(r, rc, "dimension", name, diag);
    if (n > max)
        return orr_diag_at(diag, ORR_E_LIMIT, r->path, 0, 0,
                           "dimension \"%s\" is %zu, more than the %zu allowed", name, n, max);
    *len = n;
    return ORR_OK;
}

bool orr_nc_has_var(const orr_nc_reader *r, const char *name)
{
    int var;
    return nc_inq_varid(r->id, name, &var) == NC_NOERR;
}

// Finds the variable and checks that it is what the caller has room for.
static orr_status check_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                            const size_t shape[], int *var, orr_diag *diag)
{
    int rc = nc_inq_varid(r->id, name, var);
    if (rc == NC_ENOTVAR)
        return orr_diag_at(diag, ORR_E_KIND, r->path, 0, 0,
                           "has no variable \"%s\": not the product expected", name);
    nc_type have = NC_NAT;
    int n = 0, dim[NC_MAX_VAR_DIMS];
    if (rc == NC_NOERR) rc = nc_inq_var(r->id, *var, NULL, &have, &n, dim, NULL);
    if (rc != NC_NOERR) return damaged(r, rc, "variable", name, diag);
    if (have == NC_NAT || have > NC_UINT64 || (have == NC_CHAR) != (type == ORR_NC_CHAR))
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "variable \"%s\" should hold %s", name,
                           type == ORR_NC_CHAR ? "text" : "numbers");
    if (n != rank)
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0,
                           "variable \"%s\" has %d dimensions instead of %d", name, n, rank);
    for (int i = 0; i < rank; i++) {
        size_t len = 0;
        rc = nc_inq_dimlen(r->id, dim[i], &len);
        if (rc != NC_NOERR) return damaged(r, rc, "variable", name, diag);
        if (len != shape[i])
            return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0,
                               "dimension %d of variable \"%s\" is %zu instead of %zu", i + 1, name, len,
                               shape[i]);
    }
    return ORR_OK;
}

static int read_values(int id, int var, orr_nc_type type, void *out)
{
    switch (type) {
    case ORR_NC_DOUBLE:
        return nc_get_var_double(id, var, out);
    case ORR_NC_FLOAT:
        return nc_get_var_float(id, var, out);
    case ORR_NC_INT64: {
        long long *p = out; // int64_t has the same size and representation
        _Static_assert(sizeof(long long) == sizeof(int64_t), "NetCDF's 64-bit integers are long long");
        return nc_get_var_longlong(id, var, p);
    }
    case ORR_NC_INT32:
        return nc_get_var_int(id, var, out);
    case ORR_NC_UINT16:
        return nc_get_var_ushort(id, var, out);
    case ORR_NC_UINT8:
        return nc_get_var_uchar(id, var, out);
    case ORR_NC_CHAR:
        return nc_get_var_text(id, var, out);
    }
    return NC_EBADTYPE;
}

orr_status orr_nc_get_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                          const size_t shape[], void *out, orr_diag *diag)
{
    int var;
    orr_status s = check_var(r, name, type, rank, shape, &var, diag);
    if (s != ORR_OK) return s;
    int rc = read_values(r->id, var, type, out);
    return rc == NC_NOERR ? ORR_OK : damaged(r, rc, "variable", name, diag);
}

static size_t size_of(orr_nc_type type)
{
    switch (type) {
    case ORR_NC_DOUBLE:
    case ORR_NC_INT64:
        return 8;
    case ORR_NC_FLOAT:
    case ORR_NC_INT32:
        return 4;
    case ORR_NC_UINT16:
        return 2;
    case ORR_NC_UINT8:
    case ORR_NC_CHAR:
        return 1;
    }
    return 8;
}

orr_status orr_nc_alloc_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                            const size_t shape[], void **out, orr_diag *diag)
{
    *out = NULL;
    int var;
    orr_status s = check_var(r, name, type, rank, shape, &var, diag);
    if (s != ORR_OK) return s;
    uint64_t count = 1;
    for (int i = 0; i < rank; i++) {
        if (shape[i] != 0 && count > ORR_NC_MAX_VALUES / shape[i])
            return orr_diag_at(diag, ORR_E_LIMIT, r->path, 0, 0,
                               "variable \"%s\" holds more than %llu values", name,
                               (unsigned long long)ORR_NC_MAX_VALUES);
        count *= shape[i];
    }
    void *p = calloc(count > 0 ? count : 1, size_of(type));
    if (p == NULL)
        return orr_diag_at(diag, ORR_E_MEMORY, r->path, 0, 0, "no memory for variable \"%s\"", name);
    int rc = read_values(r->id, var, type, p);
    if (rc != NC_NOERR) {
        free(p);
        return damaged(r, rc, "variable", name, diag);
    }
    *out = p;
    return ORR_OK;
}

// Finds an attribute; ORR_E_NODATA, without a message, if there is none.
static orr_status find_att(const orr_nc_reader *r, const char *var, const char *name, int *id, nc_type *type,
                           size_t *len, orr_diag *diag)
{
    int rc = NC_NOERR;
    *id = NC_GLOBAL;
    if (var != NULL) rc = nc_inq_varid(r->id, var, id);
    if (rc == NC_NOERR) rc = nc_inq_att(r->id, *id, name, type, len);
    if (rc == NC_ENOTVAR || rc == NC_ENOTATT) return ORR_E_NODATA;
    return rc == NC_NOERR ? ORR_OK : damaged(r, rc, "attribute", name, diag);
}

orr_status orr_nc_get_att_text(const orr_nc_reader *r, const char *var, const char *name, char *buf, size_t n,
                               orr_diag *diag)
{
    int id;
    nc_type type;
    size_t len;
    orr_status s = find_att(r, var, name, &id, &type, &len, diag);
    if (s != ORR_OK) return s;
    if (type == NC_STRING && len == 1) { // other programs write texts so
        char *text = NULL;
        int rc = nc_get_att_string(r->id, id, name, &text);
        if (rc != NC_NOERR || text == NULL) return damaged(r, rc, "attribute", name, diag);
        len = strlen(text);
        if (len < n) memcpy(buf, text, len + 1);
        (void)nc_free_string(1, &text);
    } else if (type == NC_CHAR) {
        if (len < n) {
            int rc = nc_get_att_text(r->id, id, name, buf);
            if (rc != NC_NOERR) return damaged(r, rc, "attribute", name, diag);
            buf[len] = '\0';
        }
    } else {
        return orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" should be a text", name);
    }
    if (len >= n)
        return orr_diag_at(diag, ORR_E_LIMIT, r->path, 0, 0, "attribute \"%s\" is longer than %zu bytes",
                           name, n - 1);
    return ORR_OK;
}

// Finds an attribute that must be one number.
static orr_status find_number(const orr_nc_reader *r, const char *var, const char *name, int *id,
                              orr_diag *diag)
{
    nc_type type;
    size_t len;
    orr_status s = find_att(r, var, name, id, &type, &len, diag);
    if (s == ORR_OK && (len != 1 || type == NC_CHAR || type > NC_UINT64))
        s = orr_diag_at(diag, ORR_E_FORMAT, r->path, 0, 0, "attribute \"%s\" should be one number", name);
    return s;
}

orr_status orr_nc_get_att_double(const orr_nc_reader *r, const char *var, const char *name, double *v,
                                 orr_diag *diag)
{
    int id;
    orr_status s = find_number(r, var, name, &id, diag);
    if (s != ORR_OK) return s;
    int rc = nc_get_att_double(r->id, id, name, v);
    return rc == NC_NOERR ? ORR_OK : damaged(r, rc, "attribute", name, diag);
}

orr_status orr_nc_get_att_int64(const orr_nc_reader *r, const char *var, const char *name, int64_t *v,
                                orr_diag *diag)
{
    int id;
    orr_status s = find_number(r, var, name, &id, diag);
    if (s != ORR_OK) return s;
    long long value = 0;
    int rc = nc_get_att_longlong(r->id, id, name, &value);
    if (rc != NC_NOERR) return damaged(r, rc, "attribute", name, diag);
    *v = value;
    return ORR_OK;
}

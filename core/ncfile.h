// SPDX-License-Identifier: GPL-3.0-or-later
// What all products share: NetCDF-4 files with CF attributes, made whole or not at all, and validated on
// reading.
//
// Writing: orr_nc_create, then dimensions, variables (each defined and written by one call) and attributes in
// any order, then orr_nc_commit. After a failure every later call on the writer is refused with the first
// one's status, so that a caller may check the last one only; orr_nc_abort leaves nothing behind.
//
// Reading: a caller asks for each dimension with the most it will accept, then reads variables into memory of
// the size that follows; a variable of another rank, shape or kind is an error that names it.
//
// A file that we wrote ends with a seal (core/ncseal.h): damage is found and said before the NetCDF library
// sees it.
//
// Values are row-major; `shape` and `dims` run from the slowest index. The NetCDF library is not thread-safe:
// one file at a time in a process.
#ifndef ORR_CORE_NCFILE_H
#define ORR_CORE_NCFILE_H

#include "core/outfile.h"
#include "core/status.h"

#define ORR_NC_MAX_RANK 4
#define ORR_NC_MAX_VALUES (UINT64_C(1) << 28) // of one variable, on reading

typedef enum orr_nc_type {
    ORR_NC_DOUBLE, // double
    ORR_NC_INT64,  // int64_t
    ORR_NC_INT32,  // int32_t
    ORR_NC_UINT16, // uint16_t
    ORR_NC_UINT8,  // uint8_t
    ORR_NC_CHAR,   // char, fixed width text: the last dimension is its length
    ORR_NC_FLOAT,  // float
} orr_nc_type;

typedef struct orr_nc_writer {
    int id;
    bool open, unwritable;
    // Set it after creation for long series whose writing time matters more than their size.
    bool uncompressed;
    orr_outfile file;
    orr_status status; // first failure
    struct {           // the variable that rows are written to
        int id, rank;
        size_t shape[ORR_NC_MAX_RANK];
        size_t next; // row
        bool large;
    } var;
} orr_nc_writer;

// Whether a file is HDF5 (NetCDF-4), by its first bytes; false where it is no regular file or cannot be read.
bool orr_nc_is_hdf5(const char *path);
// Whether it ends with a seal, which need not fit, or with a part of one: orr_nc_open refuses such a file.
bool orr_nc_is_sealed(const char *path);
// Whether it is HDF5, could be read, and has none.
bool orr_nc_lacks_seal(const char *path);

// Begins a file; nothing stands at `path` before orr_nc_commit. ORR_E_IO where it cannot be made.
orr_status orr_nc_create(const char *path, orr_nc_writer *w, orr_diag *diag);
// Defines a dimension of fixed length.
orr_status orr_nc_put_dim(orr_nc_writer *w, const char *name, size_t len, orr_diag *diag);
// Defines a variable and writes all of it, compressed where that pays.
//   Given:    w           the writer
//             name, type  of the variable
//             rank        number of its dimensions, 0 to ORR_NC_MAX_RANK
//             dims        names of the dimensions, slowest first
//             values      as many of `type` as the dimensions have together, row-major
//             units, long_name   attributes; NULL leaves one out
//   Returned: diag        why it could not be written (ORR_E_IO, ORR_E_ARG for a dimension that was not
//             defined)
orr_status orr_nc_put_var(orr_nc_writer *w, const char *name, orr_nc_type type, int rank,
                          const char *const dims[], const void *values, const char *units,
                          const char *long_name, orr_diag *diag);
// The same without its values, which follow by orr_nc_put_rows.
//   Given:    w, name, type, rank, dims, units, long_name   as of orr_nc_put_var
//   Returned: diag        as of orr_nc_put_var
orr_status orr_nc_define_var(orr_nc_writer *w, const char *name, orr_nc_type type, int rank,
                             const char *const dims[], const char *units, const char *long_name,
                             orr_diag *diag);
// Writes the next rows (along the slowest dimension) of the variable that was defined last.
//   Given:    w           the writer
//             n           rows; all are wanted in the end
//             values      of them, row-major; a scalar is one row
//   Returned: diag        why they could not be written (ORR_E_IO, ORR_E_ARG for more rows than there are)
orr_status orr_nc_put_rows(orr_nc_writer *w, size_t n, const void *values, orr_diag *diag);
// Writes a text attribute.
//   Given:    w           the writer
//             var         the variable that it belongs to; NULL: the file
//             name, text  of the attribute
//   Returned: diag        why it could not be written (ORR_E_IO; also where there is no such variable)
orr_status orr_nc_put_att_text(orr_nc_writer *w, const char *var, const char *name, const char *text,
                               orr_diag *diag);
// Writes an attribute of doubles.
//   Given:    w           the writer
//             var         the variable that it belongs to; NULL: the file
//             name        of the attribute
//             v, n        its n numbers
//   Returned: diag        why it could not be written (ORR_E_IO)
orr_status orr_nc_put_att_double(orr_nc_writer *w, const char *var, const char *name, const double *v,
                                 size_t n, orr_diag *diag);
// Content of electrons in units of 1e16 per square metre, as UDUNITS reads it: it knows no TECU.
#define ORR_NC_TECU "1e16 m-2"
// Writes an attribute of integers: in the variable's own type, as CF has it of flags, and of 64 bits for the file.
//   Given:    w           the writer
//             var         the variable that it belongs to; NULL: the file
//             name        of the attribute
//             v, n        its n numbers
//   Returned: diag        why it could not be written (ORR_E_IO)
orr_status orr_nc_put_att_int64(orr_nc_writer *w, const char *var, const char *name, const int64_t *v,
                                size_t n, orr_diag *diag);

// An input of a product. Its file name is kept, not its folder.
typedef struct orr_nc_input {
    const char *path;
    const char *sha256; // orr_sha256_file
} orr_nc_input;
// Writes where a product came from: the attributes Conventions = "CF-1.8", title, source = "orrery <version>",
// history, and for the inputs input_files and input_sha256, one a line each.
//   Given:    w           the writer
//             title       what the product is
//             history     how it was made; NULL leaves it out
//             input       n_inputs files that it was made from
//   Returned: diag        why it could not be written (ORR_E_IO, ORR_E_MEMORY)
orr_status orr_nc_put_provenance(orr_nc_writer *w, const char *title, const char *history,
                                 const orr_nc_input *input, size_t n_inputs, orr_diag *diag);

// Whether HDF5 still holds a file that it could not write for want of room. It crashes when it ends then: who wants to
// end properly ends by _exit.
bool orr_nc_left_open(void);
// Closes, seals and renames the file to its place. Ends w.
orr_status orr_nc_commit(orr_nc_writer *w, orr_diag *diag);
// Removes what was written so far. Ends w; harmless after commit.
void orr_nc_abort(orr_nc_writer *w);

typedef struct orr_nc_reader {
    int id;
    bool open, unwritable;
    char path[256]; // for messages
} orr_nc_reader;

// ORR_E_IO if it cannot be opened, ORR_E_KIND if its first bytes are no NetCDF's, ORR_E_FORMAT if NetCDF
// refuses it.
orr_status orr_nc_open(const char *path, orr_nc_reader *r, orr_diag *diag);
// The same of a file in memory; a seal is not looked at.
//   Given:    name        of the file, for messages
//             data, n     its n bytes, which NetCDF does not change; they must outlive the reader
//   Returned: r           the reader, to be closed with orr_nc_close
//             diag        ORR_E_KIND, ORR_E_FORMAT
orr_status orr_nc_open_memory(const char *name, const void *data, size_t n, orr_nc_reader *r, orr_diag *diag);
// Whether the first bytes of a file are a NetCDF file's: HDF5's signature, or "CDF" of the classic formats.
bool orr_nc_is_netcdf(const void *data, size_t n);
// Harmless on a reader that is not open.
void orr_nc_close(orr_nc_reader *r);
// The length of a dimension.
//   Given:    r, name     the reader, and the dimension's name
//             max         the longest that the caller accepts
//   Returned: len         the length
//             diag        ORR_E_KIND if there is no such dimension, ORR_E_LIMIT if it is longer than max,
//                         ORR_E_FORMAT if NetCDF cannot read it
orr_status orr_nc_get_dim(const orr_nc_reader *r, const char *name, size_t max, size_t *len, orr_diag *diag);
// Whether the file has a variable of the name.
bool orr_nc_has_var(const orr_nc_reader *r, const char *name);
// Reads a whole variable.
//   Given:    r           the reader
//             name        of the variable
//             type        that numbers are converted to
//             rank, shape what the file must have, slowest first
//   Returned: out         the values, row-major; room for the product of shape[rank]
//   Notes:    ORR_E_KIND if there is no such variable; ORR_E_FORMAT if rank, shape or kind (text or number)
//             differ, or
//             if a number does not fit `type`.
orr_status orr_nc_get_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                          const size_t shape[], void *out, orr_diag *diag);
// Reads a whole variable into fresh memory.
//   Given:    r, name, type, rank, shape   as of orr_nc_get_var
//   Returned: out         the values, row-major, to be freed with free(); NULL on failure
//             diag        as of orr_nc_get_var; ORR_E_LIMIT beyond ORR_NC_MAX_VALUES, ORR_E_MEMORY
orr_status orr_nc_alloc_var(const orr_nc_reader *r, const char *name, orr_nc_type type, int rank,
                            const size_t shape[], void **out, orr_diag *diag);
// Reads a text attribute.
//   Given:    r           the reader
//             var         the variable that it belongs to; NULL: the file
//             name        of the attribute
//             n           bytes that `buf` has room for
//   Returned: buf         the text, NUL-terminated
//             diag        ORR_E_FORMAT if it is no text, ORR_E_LIMIT if it is longer than n - 1 bytes
//   Notes:    ORR_E_NODATA, without a message, if there is no such variable or attribute.
orr_status orr_nc_get_att_text(const orr_nc_reader *r, const char *var, const char *name, char *buf, size_t n,
                               orr_diag *diag);
// Reads an attribute that is one number.
//   Given:    r           the reader
//             var         the variable that it belongs to; NULL: the file
//             name        of the attribute
//   Returned: v           the number
//             diag        ORR_E_FORMAT if it is a text or several numbers
//   Notes:    ORR_E_NODATA, without a message, if there is no such variable or attribute.
orr_status orr_nc_get_att_double(const orr_nc_reader *r, const char *var, const char *name, double *v,
                                 orr_diag *diag);
// Reads an attribute that is one integer.
//   Given:    r           the reader
//             var         the variable that it belongs to; NULL: the file
//             name        of the attribute
//   Returned: v           the number
//             diag        ORR_E_FORMAT if it is a text or several numbers
//   Notes:    ORR_E_NODATA, without a message, if there is no such variable or attribute.
orr_status orr_nc_get_att_int64(const orr_nc_reader *r, const char *var, const char *name, int64_t *v,
                                orr_diag *diag);

#endif

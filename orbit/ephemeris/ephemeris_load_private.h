// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the product's reader share (ephemeris_load*.c alone).
#ifndef ORR_ORBIT_EPHEMERIS_EPHEMERIS_LOAD_PRIVATE_H
#define ORR_ORBIT_EPHEMERIS_EPHEMERIS_LOAD_PRIVATE_H

#include "core/ncfile.h"
#include "orbit/ephemeris/ephemeris_private.h"

typedef struct eph_file {
    orr_nc_reader r;
    orr_diag *diag;
    size_t max_bytes; // that the file can hold, inflated
    size_t n_coefficients;
} eph_file;

// What is wrong with the file, as ORR_E_FORMAT.
static inline orr_status eph_wrong(const eph_file *f, const char *what)
{
    return orr_diag_at(f->diag, ORR_E_FORMAT, f->r.path, 0, 0, "%s", what);
}

// A variable of one dimension with n values, to be freed with free(). Errors as orr_nc_alloc_var.
//   Given:    f     the file
//             name  of the variable
//             type  that is wanted
//             n     values that it has to have
//   Returned: out   the values
static inline orr_status eph_read_column(const eph_file *f, const char *name, orr_nc_type type, size_t n,
                                         void **out)
{
    return orr_nc_alloc_var(&f->r, name, type, 1, &n, out, f->diag);
}

// Clock nodes, the clocks' noise, and their events. Errors: those of reading, ORR_E_FORMAT for values that no clock has.
orr_status eph_load_clocks(const eph_file *f, orr_ephemeris *e);
// The Earth's rotation, which products of earlier programs do not have. Errors likewise.
orr_status eph_load_rotation(const eph_file *f, orr_earth_rotation *r);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// A TEC field as part of an open NetCDF product.
#ifndef ORR_IONO_FIELD_TEC_FIELD_NC_H
#define ORR_IONO_FIELD_TEC_FIELD_NC_H

#include "core/ncfile.h"
#include "iono/field/tec_field.h"

// Adds the field's dimensions, variables and attributes. Errors as of core/ncfile.h.
orr_status orr_tec_field_put(orr_nc_writer *w, const orr_tec_field *f, orr_diag *diag);
// Reads it back, to go by a table of leap seconds (NULL: built-in; it has to outlive the field); free with orr_tec_field_free.
// Errors: ORR_E_FORMAT, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_tec_field_get(const orr_nc_reader *r, const orr_leap_table *leap, orr_tec_field **out,
                             orr_diag *diag);

#endif

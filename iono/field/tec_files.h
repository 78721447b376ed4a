// SPDX-License-Identifier: GPL-3.0-or-later
// TEC fields from files and into files: IONEX, Bernese .ION, the broadcast model in a navigation file's
// header.
#ifndef ORR_IONO_FIELD_TEC_FILES_H
#define ORR_IONO_FIELD_TEC_FILES_H

#include "ingest/maps/ion.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/rinex_nav.h"
#include "iono/field/tec_field.h"

// Whichever of the three the file is, by content. Errors: ORR_E_KIND with a sentence if it is none; else the
// readers' and orr_tec_field_from_*'s. options may be NULL.
orr_status orr_tec_field_open(const char *path, const orr_tec_options *options, orr_tec_field **out,
                              orr_warnings *warnings, orr_diag *diag);
// The same of a file's text, decompressed.
orr_status orr_tec_field_parse(const char *path, const char *text, size_t n, const orr_tec_options *options,
                               orr_tec_field **out, orr_warnings *warnings, orr_diag *diag);
// `name` is for messages. ORR_E_UNSUPPORTED: three-dimensional maps, irregular grids, local models, models of
// the true Sun or in geographical axes.
orr_status orr_tec_field_from_ionex(const orr_ionex *x, const char *name, const orr_tec_options *options,
                                    orr_tec_field **out, orr_diag *diag);
orr_status orr_tec_field_from_ion(const orr_ion *x, const char *name, const orr_tec_options *options,
                                  orr_tec_field **out, orr_diag *diag);

// The coefficients of a harmonic field as Bernese models (snapshots, or with the ends they came with). Free
// with orr_ion_free. ORR_E_UNSUPPORTED for other fields.
orr_status orr_tec_field_to_ion(const orr_tec_field *f, orr_ion *out, orr_diag *diag);
// The field on the grid of the IGS (2.5 x 5 degrees) at n epochs from t0 every step_s. Where a field has a
// hole the value is missing. Free with orr_ionex_free.
orr_status orr_tec_field_to_ionex(const orr_tec_field *f, orr_time t0, double step_s, size_t n,
                                  orr_ionex *out, orr_diag *diag);

#endif

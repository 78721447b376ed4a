// SPDX-License-Identifier: GPL-3.0-or-later
// TEC fields from files and into files: IONEX, Bernese .ION, the broadcast model in a navigation file's
// header.
#ifndef ORR_IONO_FIELD_TEC_FILES_H
#define ORR_IONO_FIELD_TEC_FILES_H

#include "ingest/maps/ion.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/rinex_nav.h"
#include "iono/field/tec_field.h"

// A field from a file: IONEX, .ION or a navigation file, told apart by content.
// Given:
//   path      the file, compressed or not
//   options   may be NULL
// Returned:
//   out       the field; free with orr_tec_field_free
//   warnings  of the reader; may be NULL
//   diag      why it failed; may be NULL
// Errors: ORR_E_KIND if it is none of the three; else the readers' and those of orr_tec_field_from_*.
orr_status orr_tec_field_open(const char *path, const orr_tec_options *options, orr_tec_field **out,
                              orr_warnings *warnings, orr_diag *diag);
// The same of a text in memory.
// Given:
//   path      name for messages; its last part becomes the field's source
//   text, n   the file's bytes, decompressed
//   options   may be NULL
// Returned:
//   out       the field; free with orr_tec_field_free
//   warnings  of the reader; may be NULL
//   diag      why it failed; may be NULL
// Errors: as orr_tec_field_open.
orr_status orr_tec_field_parse(const char *path, const char *text, size_t n, const orr_tec_options *options,
                               orr_tec_field **out, orr_warnings *warnings, orr_diag *diag);
// A field from maps that were read.
// Given:
//   x        the maps; not needed afterwards
//   name     for messages
//   options  may be NULL
// Returned:
//   out      the field; free with orr_tec_field_free
//   diag     why it failed; may be NULL
// Errors: ORR_E_UNSUPPORTED (three-dimensional maps, irregular grids), and those of orr_tec_field_from_maps.
orr_status orr_tec_field_from_ionex(const orr_ionex *x, const char *name, const orr_tec_options *options,
                                    orr_tec_field **out, orr_diag *diag);
// A field from Bernese models that were read.
// Given:
//   x        the models; not needed afterwards
//   name     for messages
//   options  may be NULL
// Returned:
//   out      the field; free with orr_tec_field_free
//   diag     why it failed; may be NULL
// Errors: ORR_E_NODATA (no model), ORR_E_UNSUPPORTED (a local model, the true Sun, geographical axes, a pole or height
// that changes), ORR_E_FORMAT (pole, height or epoch missing), ORR_E_LIMIT (degree), and those of
// orr_tec_field_from_model.
orr_status orr_tec_field_from_ion(const orr_ion *x, const char *name, const orr_tec_options *options,
                                  orr_tec_field **out, orr_diag *diag);

// The coefficients of a harmonic field as Bernese models (snapshots, or with the ends they came with). Free
// with orr_ion_free. ORR_E_UNSUPPORTED for other fields.
orr_status orr_tec_field_to_ion(const orr_tec_field *f, orr_ion *out, orr_diag *diag);
// The field as maps on the grid of the IGS, 2.5 x 5 degrees.
// Given:
//   f       any field
//   t0      first epoch
//   step_s  between epochs
//   n       number of epochs
// Returned:
//   out     maps, and RMS maps where the field has an RMS anywhere; values are missing where the field has a hole.
//           Free with orr_ionex_free
//   diag    why it failed; may be NULL
// Errors: ORR_E_RANGE (an epoch that the field does not cover), those of orr_ionex_alloc, ORR_E_MEMORY.
orr_status orr_tec_field_to_ionex(const orr_tec_field *f, orr_time t0, double step_s, size_t n,
                                  orr_ionex *out, orr_diag *diag);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// A file on disk through a reader of texts in memory, as src/make reads its inputs. Include the readers' headers before.
#ifndef ORR_TESTS_READ_FILE_H
#define ORR_TESTS_READ_FILE_H

#include "ingest/input/input.h"
#include "ingest/input/text_records.h"

// Defines read_<kind>(path, limits, out, warnings, diag) by orr_<kind>_parse.
#define READ_FILE_BY_PARSER(kind)                                                                            \
    static inline orr_status read_##kind(const char *path, const orr_read_limits *limits, orr_##kind *out,   \
                                         orr_warnings *warnings, orr_diag *diag)                             \
    {                                                                                                        \
        *out = (orr_##kind){0};                                                                              \
        orr_bytes b;                                                                                         \
        orr_status s = orr_input_read_all(path, NULL, &b, diag);                                             \
        if (s != ORR_OK) return s;                                                                           \
        s = orr_##kind##_parse(path, b.text, b.n, limits, out, warnings, diag);                              \
        orr_bytes_free(&b);                                                                                  \
        return s;                                                                                            \
    }

#ifdef ORR_INGEST_TABLES_ERP_H
// The same of a table of Earth rotation, with the built-in table of leap seconds.
static inline orr_status read_erp(const char *path, orr_erp *out, orr_warnings *warnings, orr_diag *diag)
{
    *out = (orr_erp){0};
    orr_bytes b;
    orr_status s = orr_input_read_all(path, NULL, &b, diag);
    if (s != ORR_OK) return s;
    s = orr_erp_parse(path, b.text, b.n, NULL, NULL, out, warnings, diag);
    orr_bytes_free(&b);
    return s;
}
#endif

#ifdef ORR_IONO_PHASE_PHASE_TEC_H
// The same of the phases of an observation file.
static inline orr_status read_phases(const char *path, const orr_phase_options *options, orr_phase_tec *out,
                                     orr_diag *diag)
{
    orr_bytes b;
    orr_status s = orr_input_read_raw(path, NULL, &b, diag);
    if (s != ORR_OK) return s;
    s = orr_phase_tec_make(path, b.text, b.n, options, out, NULL, diag);
    orr_bytes_free(&b);
    return s;
}
#endif

#ifdef ORR_INGEST_TABLES_GRAVITY_FILE_H
// The same of a profile or map of gravity.
static inline orr_status read_gravity(const char *path, orr_gravity_file *out, orr_diag *diag)
{
    *out = (orr_gravity_file){0};
    orr_bytes b;
    orr_status s = orr_input_read_raw(path, NULL, &b, diag);
    if (s != ORR_OK) return s;
    s = orr_gravity_file_parse(path, b.text, b.n, out, diag);
    orr_bytes_free(&b);
    return s;
}
#endif

#endif

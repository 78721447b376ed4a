// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements as functions of time out of orbit products, row by row in order of time.
#ifndef ORR_MAKE_ELEMENTS_H
#define ORR_MAKE_ELEMENTS_H

#include "orbit/elements/elements.h"
#include "orbit/navdata/navfit.h"
#include "src/make/inputs.h"

#define ORR_MAKE_ELEMENTS_LEAST_SPACING_S 10.0 // closer positions do not define a plane

typedef struct orr_elements_plan {
    const char *const *product; // orbit products, in any order
    size_t n_products;
    const orr_leap_table *leap; // NULL: built-in
    const char *erp;            // Earth rotation parameters; NULL: what each product was made with
    orr_elements_frame frame;
    orr_elements_method method;
    bool fifteen;      // the fifteen mean elements of the revolution about each instant instead of `method`
    double spacing_s;  // of ORR_ELEMENTS_THREE_POSITIONS
    orr_time from, to; // ORR_TIME_NONE: where the products begin and end
    int64_t step_ns;   // positive
    const orr_sat_set *sats; // NULL: all
} orr_elements_plan;

typedef struct orr_elements_row {
    orr_time t;
    orr_sat sat;
    orr_kepler k;
    orr_mean_elements mean; // of `fifteen`: rates and amplitudes; its own k has the angles of ecef
} orr_elements_row;

// Takes a row; a status other than ORR_OK, with its diagnostic, ends the run.
typedef orr_status (*orr_elements_sink)(void *user, const orr_elements_row *row, orr_diag *diag);

// Gives elements row by row to a sink: at `from`, `from` + step and so on within the products' spans, where the
// method has what it needs. Nothing is kept, so that the number of rows is not limited.
// Given:
//   plan      products and options
//   sink      takes each row
//   user      handed to `sink`
// Returned:
//   n_rows    how many rows there were; may be NULL
//   inputs    names and SHA-256 of what was read are appended, products in order of time; may be NULL
//   warnings  Earth rotation that does not cover the products; may be NULL
//   diag      why it failed; may be NULL
// Errors: those of the readers and of the sink; ORR_E_ARG (no product, step or spacing); ORR_E_NODATA where there is no row.
orr_status orr_elements_make(const orr_elements_plan *plan, orr_elements_sink sink, void *user,
                             size_t *n_rows, orr_inputs *inputs, orr_warnings *warnings, orr_diag *diag);

#endif

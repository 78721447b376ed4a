// SPDX-License-Identifier: GPL-3.0-or-later
// A TEC field to what satellites broadcast of the ionosphere: the models' coefficients fitted to the field, so that a receiver of one
// frequency corrects what the simulation delays it by.
#ifndef ORR_MAKE_BROADCAST_IONO_H
#define ORR_MAKE_BROADCAST_IONO_H

#include "ingest/rinex/rinex_nav.h"
#include "iono/broadcast/nequick.h"
#include "iono/field/tec_field.h"

#define ORR_BROADCAST_IONO_MODELS 4
// Fits the coefficients of GPS' and of BeiDou's Klobuchar models, of BDGIM and of NeQuick-G to a field.
// Given:
//   field     TEC field
//   from, to  span; the 24 hours about its middle are fitted, as far as the field covers them
//   nequick   NeQuick-G's tables; NULL: its coefficients are left out
//   leap      table of leap seconds; NULL: built-in
// Returned:
//   out       records of the models, on the lattices of their messages, as of a navigation file's header
//   n         how many: 3 or 4
//   diag      why it failed; may be NULL
// Errors: ORR_E_NODATA where the field covers nothing of the span.
// Notes: least squares on vertical delays over a grid of places and hours, weighted by area; NeQuick-G's a_i stand for an effective
// level of solar activity that depends on the modified dip latitude.
// Reference: IS-GPS-200N 20.3.3.5.2.5; BDS-SIS-ICD-B1I 3.0, 5.2.4.7; B1C 1.0, 7.8; Galileo OS SIS ICD 2.1, 5.1.6.
orr_status orr_broadcast_iono_fit(const orr_tec_field *field, orr_time from, orr_time to,
                                  const orr_nequick *nequick, const orr_leap_table *leap,
                                  orr_nav_iono out[ORR_BROADCAST_IONO_MODELS], size_t *n, orr_diag *diag);

#endif

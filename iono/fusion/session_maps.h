// SPDX-License-Identifier: GPL-3.0-or-later
// A fused session's field as maps: the field that the station's phases were levelled to, with the correction that they found for it.
#ifndef ORR_IONO_FUSION_SESSION_MAPS_H
#define ORR_IONO_FUSION_SESSION_MAPS_H

#include "ingest/maps/ionex.h"
#include "iono/fusion/session.h"

// Vertical content on the grid of the IGS, 2.5 x 5 degrees, over the session's span as far as its field reaches. About the station it
// is field and correction; beyond three times the correction's reach the field alone.
// Given:
//   s       the session
//   step_s  between maps; the first is at a multiple of it in the day
// Returned:
//   out     the maps; free with orr_ionex_free
//   diag    why there are none; may be NULL
// Errors: those of orr_tec_field_to_ionex; ORR_E_ARG (no step), ORR_E_RANGE (no map within the span).
orr_status orr_session_maps(const orr_session *s, double step_s, orr_ionex *out, orr_diag *diag);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The differential code biases at the end of an IONEX file as biases like those of other files: the maps, the
// satellites' biases and the stations' come from one adjustment, so they tell one level.
#ifndef ORR_IONO_FUSION_IONEX_BIAS_H
#define ORR_IONO_FUSION_IONEX_BIAS_H

#include "ingest/maps/ionex.h"
#include "ingest/tables/bias.h"

// Biases of satellites and stations of an IONEX file, valid over its maps. Codes are those that a comment names
// ("Reference observables for BOR1 12205M002 (G): C1C-C2W"); without one C1W-C2W for GPS and C1P-C2P for GLONASS, the
// format's P1-P2; other systems without one are left out. *out has no lines where the file has none. ORR_E_MEMORY. Free
// with orr_bias_free.
orr_status orr_bias_of_ionex(const orr_ionex *x, orr_bias_set *out, orr_diag *diag);

// Appends the lines of `more` to `all` and empties it. Differential biases have a datum: where `all` knows satellites
// by codes that `more` has too, the stations' biases of `more` are moved by the mean difference, so that they belong to
// the satellites' biases of `all`. ORR_E_MEMORY.
orr_status orr_bias_join(orr_bias_set *all, orr_bias_set *more, orr_diag *diag);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// What the makers and the evaluator of a TEC field share.
#ifndef ORR_IONO_FIELD_TEC_FIELD_PRIVATE_H
#define ORR_IONO_FIELD_TEC_FIELD_PRIVATE_H

#include <stdatomic.h>

#include "iono/broadcast/nequick.h"
#include "iono/field/sun_frame.h"
#include "iono/field/tec_field.h"

typedef enum tec_kind { TEC_HARMONICS, TEC_GRID, TEC_BROADCAST } tec_kind;

// Regular grid, [map][lat][lon], as floats (values have four digits at most).
typedef struct tec_grid {
    size_t n_lat, n_lon;
    double lat0, dlat, lon0, dlon;           // rad
    double per_lat, per_lon, turn, per_turn; // 1 / steps; columns all round, and their inverse
    bool north_cap, south_cap;               // the first and last row stand for what is beyond them
    bool round;                              // goes all round in longitude
    bool sun_fixed;                          // axes are the sun-fixed geomagnetic ones (RMS of coefficients)
    bool holes;
    float *value;
} tec_grid;

struct orr_tec_field {
    atomic_int others; // owners beside the first
    tec_kind kind;
    orr_tec_options options;
    char source[256];
    size_t n;
    orr_time *t, *t1; // t1: ORR_TIME_NONE for snapshots
    double *sun;      // geomagnetic longitude of the mean Sun at each epoch
    double *sun_east; // its geographic longitude
    orr_mat3 geomagnetic;
    double shell_radius_m;
    orr_mapping mapping;
    orr_harm_basis basis;
    double *coef;                // n arrays of basis.size
    double *coef_rms;            // or NULL
    tec_grid tec, rms;           // value NULL where there is none
    orr_tec_algorithm algorithm; // of a broadcast model: whose
    orr_tec_broadcast *set;      // n of them, and no t
    orr_nequick *nequick;        // its tables, or NULL
    orr_time from, to;
    bool fitted;
    orr_tec_fit fit;
};

// Fills what follows from the steps.
void tec_grid_finish(tec_grid *g);

// Finds coefficients for every map, in the sun-fixed frame, into f->coef, and fills f->fit. f->t, sun, basis
// and geomagnetic are set.
orr_status tec_fit_maps(const orr_tec_maps *maps, orr_tec_field *f, orr_diag *diag);

#endif

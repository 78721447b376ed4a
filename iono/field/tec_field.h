// SPDX-License-Identifier: GPL-3.0-or-later
// Vertical and slant TEC anywhere at any time, one face over three sources: spherical-harmonic coefficients
// (Bernese .ION), maps (IONEX; refitted to harmonics at load, or bilinear as they are), and the models that
// satellites broadcast (Klobuchar's of GPS and of BeiDou, BDGIM, NeQuick-G). Made once, then evaluated as a pure function: no allocation, no lock, no I/O.
#ifndef ORR_IONO_FIELD_TEC_FIELD_H
#define ORR_IONO_FIELD_TEC_FIELD_H

#include "core/status.h"
#include "core/time.h"
#include "core/vec.h"
#include "iono/broadcast/klobuchar.h"
#include "iono/field/harmonics.h"
#include "iono/field/pierce.h"

// How maps are kept. By default global maps are refitted to harmonics, and maps of a region, which cannot be, stay as they
// are.
typedef enum orr_tec_spatial { ORR_TEC_HARMONIC, ORR_TEC_BILINEAR, ORR_TEC_SPATIAL_DEFAULT } orr_tec_spatial;
// Between epochs. The three classical ways (Schaer, Gurtner, Feltens 1998): the nearest map, linear between
// two maps at one place on the Earth, linear between two maps turned with the Sun. By default the last; for maps of a
// region the second, because turned maps of a region do not cover its place.
typedef enum orr_tec_temporal {
    ORR_TEC_NEAREST,
    ORR_TEC_LINEAR,
    ORR_TEC_ROTATED,
    ORR_TEC_TEMPORAL_DEFAULT,
} orr_tec_temporal;

// The models that satellites broadcast: GPS's eight numbers (QZSS's and NavIC's are of the same model), BeiDou's eight,
// BeiDou's nine, Galileo's three. AUTO: of a navigation file GPS's, else QZSS's, NavIC's, BeiDou's eight, its nine,
// Galileo's, the first that the file has.
typedef enum orr_tec_algorithm {
    ORR_TEC_AUTO,
    ORR_TEC_GPS,
    ORR_TEC_QZSS,
    ORR_TEC_NAVIC,
    ORR_TEC_BEIDOU,
    ORR_TEC_BDGIM,
    ORR_TEC_NEQUICK
} orr_tec_algorithm;

typedef struct orr_tec_options {
    orr_tec_spatial spatial; // of maps; coefficients are always harmonic
    orr_tec_temporal temporal;
    double rotation;                   // of ROTATED: the part of the Sun's motion that maps follow, 0..1
    int degree;                        // of the refit of maps
    double pole_lat_deg, pole_lon_deg; // geomagnetic pole of the refit
    orr_mapping_kind mapping;
    orr_tec_algorithm algorithm; // which of a navigation file's
    const char
        *nequick; // folder of NeQuick-G's tables (orr_nequick_load); NULL: none; used while a field is made
    const orr_leap_table *leap; // NULL: built-in; must outlive the field
} orr_tec_options;
orr_tec_options orr_tec_default_options(void); // the two defaults, 1, 15, 79 N 71 W, MSLM

// Maps on a regular grid of geocentric latitude and longitude, [map][lat][lon]; NAN is a hole. Cells below zero are
// left out of a fit; in maps as they are they count as 0, below -2 TECU as holes.
typedef struct orr_tec_maps {
    size_t n_maps, n_lat, n_lon;
    double lat0_deg, dlat_deg, lon0_deg, dlon_deg; // first row, step (of either sign), first column, step > 0
    double shell_radius_m;
    double unit_tecu;   // resolution of the values (0.1 in most files); a value of 0 stands for "0 or less"
    const orr_time *t;  // strictly ascending
    const double *tec;  // TECU
    const double *rms;  // TECU, NAN where unknown; NULL where the file has none
    const char *source; // for messages
} orr_tec_maps;

// How well a refit meets its maps. Cells of 0 are left out of the fit unless the fit would rise above half a
// unit there (then they are put in with that); residuals are those of the other cells.
typedef struct orr_tec_fit {
    int degree;
    size_t n_cells;   // whose residuals are counted, all maps together
    size_t n_clipped; // cells of 0
    size_t n_held;    // of those, put in
    size_t n_holes;
    size_t n_negative; // cells below zero, which no TEC is: out of the fit
    double rms_tecu, max_tecu;
} orr_tec_fit;

typedef struct orr_tec_field orr_tec_field;

// Errors: ORR_E_FORMAT (infinite TEC, epochs out of order), ORR_E_UNSUPPORTED (a regional grid cannot be
// refitted), ORR_E_NUMERIC (too few cells for the degree), ORR_E_LIMIT, ORR_E_ARG, ORR_E_MEMORY. options may
// be NULL.
orr_status orr_tec_field_from_maps(const orr_tec_maps *maps, const orr_tec_options *options,
                                   orr_tec_field **out, orr_diag *diag);

// A set of coefficients in the sun-fixed geomagnetic frame. t1 = ORR_TIME_NONE: a snapshot, linear in time to
// the next; else it holds from t to t1 unchanged.
typedef struct orr_tec_coefficients {
    orr_time t, t1;
    int degree, order;
    const double *value; // (degree+1)^2 in the order of orr_harm_row, TECU; terms beyond `order` are zero
    const double *rms;   // the same, or NULL
} orr_tec_coefficients;
typedef struct orr_tec_model {
    size_t n;
    const orr_tec_coefficients *set;   // ascending in t
    double pole_lat_deg, pole_lon_deg; // geomagnetic pole
    double shell_radius_m;
    const char *source;
} orr_tec_model;
// A field of spherical-harmonic coefficients; the degree is the highest of the sets, the pole the model's. Errors:
// ORR_E_NODATA (no set), ORR_E_FORMAT (epochs out of order, a coefficient that is no number), ORR_E_ARG, ORR_E_LIMIT,
// ORR_E_MEMORY. options may be NULL. Free with orr_tec_field_free.
orr_status orr_tec_field_from_model(const orr_tec_model *model, const orr_tec_options *options,
                                    orr_tec_field **out, orr_diag *diag);

// One set of broadcast coefficients.
typedef struct orr_tec_broadcast {
    orr_time t; // from when it holds: its transmission; ORR_TIME_NONE: from ever
    double value
        [9]; // alpha 0-3, beta 0-3 of the models of eight; alpha 1-9 in TECU; a_i0-a_i2 in sfu; zeroes beyond
} orr_tec_broadcast;
// A field of a broadcast model whose coefficients change: at an instant the set of the latest time holds, before the first
// that one.
// Given:
//   algorithm   not AUTO
//   set, n      the sets, ascending in t, at least one
//   from, to, source   as above
//   options     may be NULL; `nequick` says where NeQuick-G's tables are
// Errors: ORR_E_FORMAT (a coefficient that is no number, times out of order), ORR_E_NODATA (no set; NeQuick-G without a
// folder), those of orr_nequick_load, ORR_E_ARG (options, algorithm), ORR_E_MEMORY.
orr_status orr_tec_field_from_broadcast(orr_tec_algorithm algorithm, const orr_tec_broadcast *set, size_t n,
                                        orr_time from, orr_time to, const char *source,
                                        const orr_tec_options *options, orr_tec_field **out, orr_diag *diag);
// Another owner of the same field, which frees it likewise: the last one ends it. f may be NULL.
orr_tec_field *orr_tec_field_share(orr_tec_field *f);
// Frees a field; f may be NULL.
void orr_tec_field_free(orr_tec_field *f);

// First and last instant that the field covers.
void orr_tec_field_span(const orr_tec_field *f, orr_time *from, orr_time *to);
const char *orr_tec_field_source(const orr_tec_field *f); // name for messages, as it was made with
const char *
orr_tec_field_kind(const orr_tec_field *f); // "harmonics", "maps", "klobuchar", "bdgim", "nequick"
const orr_tec_options *orr_tec_field_options(const orr_tec_field *f); // as in force (degree, pole)
const orr_tec_fit *orr_tec_field_fit(const orr_tec_field *f);         // NULL unless maps were refitted
double orr_tec_field_shell_radius_m(const orr_tec_field *f);          // from the Earth's centre
// Number of sets of coefficients of a harmonic field, and their degree; 0 for other kinds (*degree is left alone).
size_t orr_tec_field_sets(const orr_tec_field *f, int *degree);
// One set of coefficients of a harmonic field, for writing it.
// Given:
//   f       harmonic field
//   k       which set, from 0
// Returned:
//   t, t1   its epoch, or the interval it holds for; t1 is ORR_TIME_NONE for a snapshot
//   value   [(degree + 1)^2] in the order of orr_harm_row, TECU
//   rms     the same, zeroes where the source has none; may be NULL
void orr_tec_field_set(const orr_tec_field *f, size_t k, orr_time *t, orr_time *t1, double *value,
                       double *rms);
// Epochs of a field of maps, whichever way they are kept; 0 for others. *t stays valid as long as f.
size_t orr_tec_field_epochs(const orr_tec_field *f, const orr_time **t);

enum {                         // orr_tec_value.flags
    ORR_TEC_CLIPPED = 1u << 0, // the expansion is negative here; 0 is given, as maps do
};
typedef struct orr_tec_value {
    double vtec_tecu;
    double sigma_tecu; // of the source's RMS; NAN where it has none
    unsigned flags;
} orr_tec_value;

// The field at one instant: everything that depends on time alone, so that the rays of an epoch share it.
// About 20 kB.
typedef struct orr_tec_instant {
    const orr_tec_field *field;
    orr_time t;
    size_t i0, i1; // epochs at either side
    double w;      // weight of i1
    bool one;      // one set of axes serves both sides
    orr_mat3 axes0, axes1;
    double turn0_rad, turn1_rad; // longitude to add when looking into a map of i0 or i1
    double coef[2 * (ORR_HARM_MAX_DEGREE + 1) * ORR_HARM_MAX_ROW];
} orr_tec_instant;
// ORR_E_RANGE when the field does not cover t.
orr_status orr_tec_field_at(const orr_tec_field *f, orr_time t, orr_tec_instant *out, orr_diag *diag);

// Vertical TEC over a point of the shell, a geocentric unit vector. ORR_E_NODATA in a hole of the maps,
// ORR_E_RANGE outside a regional map.
orr_status orr_tec_vertical(const orr_tec_instant *at, orr_vec3 unit, orr_tec_value *out, orr_diag *diag);

typedef struct orr_tec_ray {
    orr_pierce pierce;
    double mapping; // slant / vertical
    double vtec_tecu, stec_tecu;
    double sigma_tecu; // of the slant, NAN where unknown
    unsigned flags;
} orr_tec_ray;
// One ray from a receiver to a satellite.
// Given:
//   at     the field at an instant
//   site   receiver
//   sat_m  satellite, ecef
// Returned:
//   out    pierce point, vertical and slant content
//   diag   why there is none; may be NULL
// Errors: those of orr_pierce_ray and orr_tec_vertical.
// Notes: a broadcast model has its own way to the slant; the mapping is the quotient. NeQuick-G is integrated up to
// 20 200 km. From receivers in space (core/limb.h) rays go down too: NeQuick-G is integrated from the one end to the other, every
// other field gives what the ray meets where it crosses the shell: nothing from above it, with the receiver's own direction for a
// pierce point and a mapping of 0. ORR_E_RANGE where the Earth or its air hides the satellite.
orr_status orr_tec_look(const orr_tec_instant *at, const orr_iono_site *site, orr_vec3 sat_m,
                        orr_tec_ray *out, orr_diag *diag);
// One ray through a pierce point that is known already.
// Given:
//   at      the field at an instant
//   site    receiver; only a broadcast model uses it
//   pierce  made with the field's shell radius
// Returned:
//   out     the same pierce point, vertical and slant content
//   diag    why there is none; may be NULL
// Errors: those of orr_tec_vertical.
orr_status orr_tec_look_through(const orr_tec_instant *at, const orr_iono_site *site,
                                const orr_pierce *pierce, orr_tec_ray *out, orr_diag *diag);

#endif

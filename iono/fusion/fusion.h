// SPDX-License-Identifier: GPL-3.0-or-later
// The offset that phases lack, from a field that has it (Bogdanov 2015, 7.4). Two methods: the source's (the
// mean of phase minus model over each arc), and one joint least squares of all arcs' biases with an hourly
// quadratic correction of the field over the station. Either way the fused curve is the phase minus one
// constant an arc: the shape is the phase's.
#ifndef ORR_IONO_FUSION_FUSION_H
#define ORR_IONO_FUSION_FUSION_H

#include "ingest/tables/bias.h"
#include "iono/field/tec_field.h"
#include "iono/phase/phase_tec.h"

typedef enum orr_fusion_method { ORR_FUSION_THESIS, ORR_FUSION_JOINT } orr_fusion_method;
const char *orr_fusion_method_name(orr_fusion_method m); // "thesis", "joint"

typedef struct orr_fusion_options {
    orr_fusion_method method;
    double knot_s;      // between knots of the correction: 3600
    double thin_s;      // of the samples that enter the normal equations: 120
    double sample_tecu; // sigma of phase against the corrected field, vertical: 1; scaled by the mapping
    // Random walk of the correction's value, slopes (a 1000 km) and bends (a (1000 km)^2), TECU over an hour;
    // and their sigma at the first knot.
    double walk_tecu[3], start_tecu[3];
    char code_systems[ORR_N_SYSTEMS + 1]; // whose codes level the fit, where biases are known: "G"
    double code_tecu;                     // sigma of an arc's levelled code
    bool step_test;
    orr_arc_options arcs; // of the step test and the arcs it makes
    const orr_sat
        *withhold_sat; // leave one arc out: this arc of this satellite is not fitted (its bias is NAN)
    size_t withhold_arc;
} orr_fusion_options;
orr_fusion_options orr_fusion_default_options(void); // joint, with the values named above

// Correction of vertical TEC over a station: at each knot a + bx x + by y + cxx x^2 + cxy x y + cyy y^2, x
// East and y North in units of 1000 km on the shell from the station's zenith, linear in time. Beyond `reach`
// (units) the correction keeps the value at that distance and fades to nothing at three times it.
#define ORR_CORRECTION_TERMS 6
typedef struct orr_correction {
    orr_time t0;
    double knot_s;
    size_t n; // knots
    double (*term)[ORR_CORRECTION_TERMS];
    orr_vec3 up, east, north; // geocentric axes at the station
    double scale;             // shell radius in units of 1000 km
    double reach;
} orr_correction;
// Its vertical value at an instant and a pierce point (geocentric unit vector), TECU; held before the first and after
// the last knot, 0 where there is no knot.
double orr_correction_at(const orr_correction *c, orr_time t, orr_vec3 unit);

typedef struct orr_fused_arc {
    size_t sat_index, arc; // in the orr_phase_tec
    orr_sat sat;
    orr_time from, to;
    size_t n;
    double bias_tecu, sigma_tecu; // phase = slant TEC + bias
    double residual_tecu;         // RMS of levelled phase minus corrected field, slant
    double max_el_rad;
    // Code levelling: mean of phase - (code with the satellite's biases removed), elevation-weighted: the
    // bias less the receiver's own of the group. NAN where codes or biases are missing.
    double code_bias_tecu;
    size_t group;   // receiver bias: one for each system and pair of codes
    bool code_used; // in the fit
} orr_fused_arc;

typedef struct orr_code_group {
    char system, range[2][4];
    double receiver_tecu, sigma_tecu; // of the fit; NAN where its codes were not used
} orr_code_group;

#define ORR_FUSION_BANDS 9 // of elevation: 0-10, 10-20, .. 80-90
typedef struct orr_fusion_band {
    double from_deg, to_deg;
    size_t n;
    double rms_tecu;
} orr_fusion_band;

typedef struct orr_fusion {
    orr_fusion_method method;
    size_t n_arcs, n_groups;
    orr_fused_arc *arc;
    orr_code_group *group;
    orr_correction correction;    // zero knots for THESIS
    size_t n_samples, n_no_model; // used; without a model value (holes of the maps)
    double residual_tecu;         // RMS of levelled phase minus (corrected) field, slant, all samples
    double model_residual_tecu;   // the same against the field without correction
    orr_fusion_band band[ORR_FUSION_BANDS];
    size_t n_band;
    double unit_sigma; // a posteriori of unit weight
    double inflation;  // of variances for residuals that are alike over time
    // Code levelling that the fit did not use, Galileo: scatter of (fitted bias - code bias) over arcs longer
    // than 2 h.
    size_t galileo_n;
    double galileo_std_tecu; // NAN below two arcs
    bool galileo_withheld;
    // Along the samples of the phase file, [sat][sample]: the field's vertical TEC and the mapping; NAN where
    // not in use.
    double **model_vtec, **mapping;
} orr_fusion;

// Levels the arcs of a station against a field.
// Given:
//   phase             the station's phases, with geometry
//   field             has to cover every sample's instant
//   biases, n_biases  code biases of satellites; n_biases may be 0
//   options           may be NULL
// Returned:
//   phase             its arcs are split where the step test finds a jump (recorded in its slips)
//   out               the fusion; free with orr_fusion_free
//   diag              why it failed; may be NULL
// Errors: ORR_E_ARG (no geometry), ORR_E_RANGE (the field does not cover an instant), ORR_E_NODATA (no arc),
// ORR_E_NUMERIC, ORR_E_LIMIT, ORR_E_MEMORY.
// Reference: Bogdanov 2015, 7.4.
orr_status orr_fuse(orr_phase_tec *phase, const orr_tec_field *field, const orr_bias_set *biases,
                    size_t n_biases, const orr_fusion_options *options, orr_fusion *out, orr_diag *diag);
// Frees what a fusion holds; `phase` is the one it was made of.
void orr_fusion_free(orr_fusion *f, const orr_phase_tec *phase);

// Leave one arc out: every arc of at least min_span_s in turn is not fitted; corrected field and plain field
// along it against its centred phase.
typedef struct orr_leave_out {
    size_t n_arcs, n_samples;
    double corrected_tecu, plain_tecu; // RMS
    struct {
        double from_deg, to_deg;
        size_t n;
        double corrected_tecu, plain_tecu;
    } band[ORR_FUSION_BANDS];
} orr_leave_out;
// Judges the correction by arcs that it was not fitted to.
// Given:
//   phase             the station's phases, with geometry
//   field             has to cover every sample's instant
//   biases, n_biases  code biases of satellites; n_biases may be 0
//   options           may be NULL; the method is `joint` whatever they say
//   min_span_s        shorter arcs are not left out
// Returned:
//   phase             as orr_fuse leaves it
//   out               RMS over all samples of the arcs left out, and by elevation
//   diag              why it failed; may be NULL
// Errors: as orr_fuse.
orr_status orr_fusion_leave_one_out(orr_phase_tec *phase, const orr_tec_field *field,
                                    const orr_bias_set *biases, size_t n_biases,
                                    const orr_fusion_options *options, double min_span_s, orr_leave_out *out,
                                    orr_diag *diag);

#endif

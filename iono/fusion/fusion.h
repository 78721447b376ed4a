// SPDX-License-Identifier: GPL-3.0-or-later
// The offset that phases lack, from a field that has it (Bogdanov 2015, 7.4). Two methods: the source's (the
// mean of phase minus model over each arc), and one joint least squares of all arcs' biases with a correction of the
// field over the station. Either way the fused curve is the phase minus one constant an arc: the shape is the phase's.
// How strong the correction may be is chosen for each session by its likelihood, and judged by arcs left out.
#ifndef ORR_IONO_FUSION_FUSION_H
#define ORR_IONO_FUSION_FUSION_H

#include "ingest/tables/bias.h"
#include "iono/field/tec_field.h"
#include "iono/phase/phase_tec.h"

typedef enum orr_fusion_method { ORR_FUSION_THESIS, ORR_FUSION_JOINT } orr_fusion_method;
const char *orr_fusion_method_name(orr_fusion_method m); // "thesis", "joint"

typedef struct orr_fusion_options {
    orr_fusion_method method;
    double knot_s;                        // between knots of the correction: 3600
    double thin_s;                        // of the samples that enter the normal equations: 300
    char code_systems[ORR_N_SYSTEMS + 1]; // whose codes level the fit, where biases are known: "G"
    double code_tecu;                     // sigma of an arc's levelled code
    bool withhold_station_bias;           // the station's own code bias is not used, though a file has it
    bool step_test;
    orr_arc_options arcs; // of the step test and the arcs it makes
} orr_fusion_options;
orr_fusion_options orr_fusion_default_options(void); // joint, with the values named above

// Statistics of a field's errors over a station, vertical: what the correction may follow, and what it leaves. All
// correlations in time are exponential. A term of degree d in x and y (1000 km) has the sigma level per_degree^d and
// the correlation time level_s time_per_degree^d.
typedef struct orr_fusion_model {
    double residual_tecu, residual_s; // of the structure along an arc that the correction leaves
    double level_tecu, level_s;       // of the correction's constant term, besides the field's own RMS
    double rms_tecu;                  // that RMS
    double per_degree, time_per_degree;
    double height_km, height_s;               // of the shell's effective height
    double plasmasphere_tecu, plasmasphere_s; // of the content above it
} orr_fusion_model;

// Correction of vertical TEC over a station. At each knot there are ten terms, 1, x, y, x^2, x y, y^2, x^3, x^2 y, x y^2,
// y^3, x East and y North in units of 1000 km on the shell from the station's zenith, and two of
// what a mapping function does not know: the shell's effective height in units of 100 km, with which content times
// mapping m changes by -vtec (m^2 - 1) 100 km / shell radius; and the part of the content, TECU, that stands in the
// plasmasphere, where rays are less slant (mapping of a shell at 2000 km). Unmodelled, both would be taken for a level:
// by night the plasmasphere holds a third of the electrons. All are linear in time. Beyond `reach` (units) the correction keeps the value at that distance and fades
// to nothing at three times it.
#define ORR_CORRECTION_PLACE_TERMS 10
#define ORR_CORRECTION_TERMS 12
typedef struct orr_correction {
    orr_time t0;
    double knot_s;
    size_t n; // knots
    double (*term)[ORR_CORRECTION_TERMS];
    orr_vec3 up, east, north; // geocentric axes at the station
    double scale;             // shell radius in units of 1000 km
    double reach;
} orr_correction;
// The correction of a ray's vertical content.
// Given:
//   c          the correction
//   t          instant; held before the first and after the last knot
//   unit       pierce point, geocentric unit vector
//   vtec_tecu  the field's vertical content there
//   mapping    slant over vertical of the ray
// Returned: what to add to vtec_tecu, TECU; 0 where there is no knot.
double orr_correction_at(const orr_correction *c, orr_time t, orr_vec3 unit, double vtec_tecu,
                         double mapping);

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
    // The station's own bias as a file has it, the same sign; NAN where there is none or it was withheld.
    double published_tecu, published_sigma_tecu;
} orr_code_group;

#define ORR_FUSION_BANDS 9 // of elevation: 0-10, 10-20, .. 80-90
typedef struct orr_fusion_band {
    double from_deg, to_deg;
    size_t n;
    double rms_tecu;
} orr_fusion_band;

// Leave one arc out: each arc of an hour and more (of half the session where that is less) in turn is not fitted; phase
// minus field along it, with the correction of the others and without.
typedef struct orr_leave_out {
    size_t n_arcs, n_samples;
    double corrected_tecu, plain_tecu; // RMS about the arc's mean, slant; NAN without an arc
    // RMS about the arc's highest sample: dSTEC (Hernandez-Pajares et al. 2017).
    double corrected_dstec_tecu, plain_dstec_tecu;
    struct {
        double from_deg, to_deg;
        size_t n;
        double corrected_tecu, plain_tecu;
    } band[ORR_FUSION_BANDS];
} orr_leave_out;

// Why the correction is not what was asked for.
typedef enum orr_fusion_fallback {
    ORR_FUSION_AS_ASKED,
    ORR_FUSION_TOO_FEW_ARCS, // one arc alone: thesis method
    ORR_FUSION_NO_GAIN,      // arcs left out are no better with the correction: it is zero
} orr_fusion_fallback;

typedef struct orr_fusion {
    orr_fusion_method method;
    orr_fusion_fallback fallback;
    double
        field_rms_tecu; // the field's own sigma over the station, vertical; assumed where the field has none
    bool field_rms_assumed;
    orr_fusion_model model;  // JOINT
    double level_sigma_tecu; // JOINT: sigma of the correction over the station, mid-session
    orr_leave_out left;      // JOINT
    size_t n_arcs, n_groups;
    orr_fused_arc *arc;
    orr_code_group *group;
    orr_correction correction;    // zero knots for THESIS
    size_t n_samples, n_no_model; // used; without a model value (holes of the maps)
    double residual_tecu;         // RMS of levelled phase minus (corrected) field, slant, all samples
    double model_residual_tecu;   // the same against the field without correction
    orr_fusion_band band[ORR_FUSION_BANDS];
    size_t n_band;
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

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// The orbit product in memory, shared by ephemeris*.c alone. Everything of one kind lies in one array (as in
// the file); satellites and arcs hold their parts of it. What evaluation needs of a segment is contiguous.
#ifndef ORR_ORBIT_EPHEMERIS_EPHEMERIS_PRIVATE_H
#define ORR_ORBIT_EPHEMERIS_EPHEMERIS_PRIVATE_H

#include "core/backing.h"
#include "orbit/clock/clock_between.h"
#include "orbit/ephemeris/ephemeris.h"

enum {
    EPH_MIN_DEGREE = 5, // six conditions at a segment's two ends
    EPH_MAX_DEGREE = 24,
    EPH_LANES = 4, // x, y, z and a zero: rows of coefficients that a vector unit can load whole
    EPH_MAX_SATS = 1024,
    EPH_SIGMAS = 5, // of a sample: position 3-D, radial, along-track, cross-track; velocity 3-D
    EPH_MAX_SAMPLES_PER_SEGMENT = 256,
};
#define EPH_PRODUCT "orrery orbit" // global attribute "product" of the file
enum { EPH_FORMAT_VERSION = 1 };   // and "product_version"
// What may hold of a sample; the rest of the flags belongs to clocks.
#define EPH_STATE_FLAGS                                                                                      \
    (ORR_EPH_PREDICTED | ORR_EPH_MANOEUVRE | ORR_EPH_ECLIPSE | ORR_EPH_GAP | ORR_EPH_JOINT |                 \
     ORR_EPH_SHADOW_NOISE)
#define EPH_CLOCK_FLAGS (ORR_EPH_CLOCK_EVENT | ORR_EPH_PREDICTED)
#define EPH_TIME_LIMIT ((INT64_C(1) << 62) - 1) // 1834 to 2126: differences of two such times fit, and sums
#define EPH_CLOCK_ROUNDING_S2 9e-26             // (0.3 ps)^2: the last digit of SP3 and RINEX CLK
#define EPH_MAX_CLOCK_S 1e9                     // decades: rates between such clocks are still numbers
#define EPH_MAX_POS_ERROR_M 1e-4                // what build allows between segments and samples
#define EPH_MAX_VEL_ERROR_MPS 1e-6

typedef struct eph_arc {
    orr_time t0, t1; // t1 = t0 + n_segments * segment_ns, inclusive
    int64_t segment_ns;
    double per_segment_ns; // 1 / segment_ns
    double dx_dt;          // 2 / segment length in s: x runs over [-1, 1] in a segment
    size_t n_segments, samples_per_segment;
    int degree;
    size_t first_segment; // index into meta[]
    // Index into sigma[] and sample_flags[]; n_segments * samples_per_segment + 1 of them
    size_t first_sample;
    size_t first_coef; // index into coef[] of the arc's first segment
} eph_arc;

// A stretch of time that an event marks with a flag; ascending in t0.
typedef struct eph_span {
    orr_time t0, t1; // inclusive
    orr_time reach;  // the latest t1 so far: before it, earlier spans may still hold
    uint32_t flag;
} eph_span;

// Flags of one segment. Where all of it has the same, `flags` says them; else samples and spans are looked
// at.
typedef struct eph_meta {
    uint32_t flags;
    uint32_t mixed;
} eph_meta;

// A clock node and the way to the next one.
typedef struct eph_clock {
    orr_time t;
    orr_clock_interval way;
    double per_ns;            // 1 / its length
    float sigma2_s2, next_s2; // variance of predicted nodes, here and at the next one
    // Of the clock between the two nodes, ORR_EPH_CLOCK_VALID among them; 0: it has none there
    uint32_t flags;
} eph_clock;

typedef struct eph_sat {
    double node_noise_m; // 0: not known
    size_t n_arcs, n_clocks, n_nodes, n_events, n_spans;
    eph_arc *arc;
    orr_clock_node *clock;
    eph_clock *rate; // as many as clock
    orr_orbit_node *node;
    orr_orbit_event *event;
    eph_span *span;
    orr_clock_noise clock_noise;
    double clock_per_ns; // 1 / the usual step of clock nodes, for the first guess of a node
} eph_sat;

struct orr_ephemeris {
    size_t n_sats, n_arcs, n_segments, n_samples, n_coefs, n_clocks, n_nodes, n_events, n_spans, n_sources;
    orr_sat *sat_id;
    eph_sat *sat;
    eph_arc *arc;
    double *coef; // [segment][coefficient][EPH_LANES]
    eph_meta *meta;
    float (*sigma)[EPH_SIGMAS];
    uint32_t *sample_flags; // the last of an arc repeats the one before it
    orr_clock_node *clock;
    eph_clock *rate;
    orr_orbit_node *node;
    orr_orbit_event *event;
    eph_span *span;
    orr_orbit_source *source;
    orr_backing *backing; // of the long arrays; NULL: the heap
    bool owns_backing;
    orr_clock_events clock_events;
    orr_earth_rotation rotation;
    double node_step_s, clock_max_gap_s;
    bool wide;                                 // evaluate with four-lane vectors; same bits
    size_t n_shortened;                        // arcs
    double max_pos_error_m, max_vel_error_mps; // of the segments against the samples they were fitted to
    orr_time from, to;
    char options[1024], frame[64];
    int16_t slot[(ORR_N_SYSTEMS + 1) * 256]; // satellite to index in sat[], -1 for none
};

// Allocates e with the counts set in *counts (n_sats .. n_sources but n_spans); arrays are zeroed, and those that are long
// lie in counts->backing if there is one.
orr_status eph_alloc(const orr_ephemeris *counts, orr_ephemeris **out, orr_diag *diag);
// Lets go of the memory that a product's backing takes, if it has one.
static inline void eph_rest(const orr_ephemeris *e) { orr_backing_rest(e->backing); }
// A solution's satellites fitted, as a product that lacks all that eph_finish and eph_describe put in.
orr_status eph_fit_satellites(const orr_orbit_solution *s, orr_backing *backing, orr_ephemeris **out,
                              orr_diag *diag);
// What is a product's as a whole and not a satellite's, from the solution.
orr_status eph_describe(const orr_orbit_solution *s, orr_ephemeris *e, orr_diag *diag);
// Appends satellite i of a product to those that *to has already; counts in *to are how far it is filled.
void eph_append(const orr_ephemeris *from, orr_ephemeris *to, size_t i);
// Derives everything that is not in the file from what is: spans, flags of segments, slots, span of time.
// Satellites' and arcs' own fields, counts and indices must be set and consistent.
orr_status eph_finish(orr_ephemeris *e, orr_diag *diag);
// A copy of events of clocks. ORR_E_MEMORY.
orr_status eph_copy_clock_events(const orr_clock_events *from, orr_clock_events *to);
bool eph_machine_is_wide(void);
static inline size_t eph_block(int degree) { return (size_t)(degree + 1) * EPH_LANES; } // doubles a segment

// The fit of one segment's coordinate as a matrix: coefficients = matrix * data.
typedef struct eph_fit {
    int degree;
    size_t samples; // samples_per_segment + 1
    double *matrix; // (degree + 1) x 3 samples: of positions, velocities * h, accelerations * h^2, h half a
                    // segment
    double *basis;  // 3 samples x (degree + 1): the same data from coefficients
} eph_fit;
orr_status eph_fit_init(int degree, size_t samples_per_segment, eph_fit *f, orr_diag *diag);
void eph_fit_free(eph_fit *f);
// data: 3 samples long, as above. coef: degree + 1.
void eph_fit_apply(const eph_fit *f, const double *data, double *coef);
// The highest degree that so many samples can carry without swinging between them.
int eph_fit_max_degree(size_t samples_per_segment);

#endif

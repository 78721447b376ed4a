// SPDX-License-Identifier: GPL-3.0-or-later
// The product as a NetCDF-4 file that explains itself (`ncdump -h`); docs/product.md is the long form.
#include <stdlib.h>
#include <string.h>

#include "core/ncfile.h"
#include "orbit/ephemeris/ephemeris_private.h"

static const char HOW_TO[] =
    "Positions are Chebyshev series in a terrestrial (ecef) frame. Satellite s has "
    "arc_count[s] consecutive arcs; arc a "
    "has segment_count[a] consecutive segments of equal length L = "
    "segment_length[a], the first of which begins at "
    "arc_start[a]. At time t within segment k: x = 2 (t - arc_start[a] - k L) / L - "
    "1, position coordinate i = "
    "sum over j of position_coefficient[segment, j, i] T_j(x); velocity and "
    "acceleration are its derivatives by t "
    "(dx/dt = 2 / L). Between arcs there is no orbit. There is a clock between "
    "neighbouring clock nodes that are at "
    "most clock_max_gap_s apart and the later of which has no clock event, and nowhere "
    "else: their line, rounded within a quarter of the interval h beside a node so that the "
    "rate at a node is the mean of the lines' on its two sides: with d that rate less the "
    "line's, and u the time from the node over h/4, d h/4 u (1 - u)^2 is added after the node "
    "and taken off before it. Variance of the clock at the part p of the way, against the "
    "input's own clock: clock_sigma^2 (linear in p) + clock_white_noise (1 + p^2 + q^2 + "
    "2 p q c(h) - 2 q c(p h) - 2 p c(q h)) + clock_walk_noise h p q + clock_frequency_noise h^3 p^2 q^2 / 3, "
    "q = 1 - p, c(s) = (1 + s / 300)^-2. Ragged arrays "
    "are CF contiguous ragged arrays: the counts name their sample_dimension.";

static const char TIME_UNITS[] = "nanoseconds since 1980-01-06 00:00:00";

// One place for what every variable needs, so that the list below reads as a table.
typedef struct file {
    orr_nc_writer w;
    orr_diag *diag;
} file;

static void var(file *f, const char *name, orr_nc_type type, const char *dim, const char *units,
                const char *long_name)
{
    const char *dims[1] = {dim};
    (void)orr_nc_define_var(&f->w, name, type, 1, dims, units, long_name,
                            f->diag); // w remembers the first failure
}

static void put(file *f, const char *name, orr_nc_type type, const char *dim, const void *values,
                const char *units, const char *long_name)
{
    const char *dims[1] = {dim};
    (void)orr_nc_put_var(&f->w, name, type, 1, dims, values, units, long_name, f->diag);
}

static void put_table(file *f, const char *name, orr_nc_type type, const char *dim0, const char *dim1,
                      const void *values, const char *units, const char *long_name)
{
    const char *dims[2] = {dim0, dim1};
    (void)orr_nc_put_var(&f->w, name, type, 2, dims, values, units, long_name, f->diag);
}

static void var_table(file *f, const char *name, orr_nc_type type, const char *dim0, const char *dim1,
                      const char *units, const char *long_name)
{
    const char *dims[2] = {dim0, dim1};
    (void)orr_nc_define_var(&f->w, name, type, 2, dims, units, long_name, f->diag);
}

static void text(file *f, const char *var, const char *name, const char *value)
{
    (void)orr_nc_put_att_text(&f->w, var, name, value, f->diag);
}

static void number(file *f, const char *name, double value)
{
    (void)orr_nc_put_att_double(&f->w, NULL, name, &value, 1, f->diag);
}

static void time_attributes(file *f, const char *name)
{
    text(f, name, "calendar", "standard");
    text(f, name, "comment", "GPS time scale: no leap seconds are counted");
}

static void flags_of(file *f, const char *var)
{
    static const int64_t masks[] = {ORR_EPH_PREDICTED,   ORR_EPH_MANOEUVRE, ORR_EPH_CLOCK_EVENT,
                                    ORR_EPH_ECLIPSE,     ORR_EPH_GAP,       ORR_EPH_JOINT,
                                    ORR_EPH_SHADOW_NOISE};
    (void)orr_nc_put_att_int64(&f->w, var, "flag_masks", masks, sizeof masks / sizeof masks[0], f->diag);
    text(f, var, "flag_meanings", "predicted manoeuvre clock_event eclipse gap joint shadow_noise");
}

static void put_global(file *f, const orr_ephemeris *e, const char *history)
{
    orr_nc_input *inputs = calloc(e->n_sources + 1, sizeof *inputs);
    if (inputs == NULL) {
        f->w.status =
            orr_diag_set(f->diag, ORR_E_MEMORY, "no memory for the names of %zu inputs", e->n_sources);
        return;
    }
    for (size_t i = 0; i < e->n_sources; i++)
        inputs[i] = (orr_nc_input){e->source[i].name, e->source[i].sha256};
    (void)orr_nc_put_provenance(&f->w, "Orrery orbit product: satellite positions and clocks", history,
                                inputs, e->n_sources, f->diag);
    free(inputs);
    int64_t version = EPH_FORMAT_VERSION;
    text(f, NULL, "product", EPH_PRODUCT);
    (void)orr_nc_put_att_int64(&f->w, NULL, "product_version", &version, 1, f->diag);
    text(f, NULL, "comment", HOW_TO);
    text(f, NULL, "options", e->options);
    text(f, NULL, "reference_frame", e->frame);
    text(f, NULL, "time_scale", "GPS");
    char when[ORR_TIME_TEXT];
    text(f, NULL, "time_coverage_start", orr_time_text(e->from, when));
    text(f, NULL, "time_coverage_end", orr_time_text(e->to, when));
    number(f, "node_step_s", e->node_step_s);
    number(f, "clock_max_gap_s", e->clock_max_gap_s);
    number(f, "max_position_error_m", e->max_pos_error_m);
    number(f, "max_velocity_error_mps", e->max_vel_error_mps);
    text(f, NULL, "max_error_comment",
         "largest difference of the segments from the smoothed orbit's samples");
}

// Scratch of `bytes` a piece and n pieces; NULL with the writer's failure set.
static void *scratch(file *f, size_t n, size_t bytes)
{
    void *p = calloc(n + 1, bytes);
    if (p == NULL && f->w.status == ORR_OK)
        f->w.status = orr_diag_set(f->diag, ORR_E_MEMORY, "no memory to write %zu values", n);
    return p;
}

// Columns of a struct array one by one: `define` the variable, then member of list[i] into an array of `type`, so many
// rows of `width` at a time, written and forgotten.
enum { ROWS = 1 << 15, SEGMENTS = 1 << 12 };
#define COLUMN(type, n, width, expression, define)                                                           \
    do {                                                                                                     \
        define;                                                                                              \
        type *column = scratch(f, (n) < ROWS ? (n) : ROWS, (width) * sizeof *column);                        \
        if (column == NULL) return;                                                                          \
        for (size_t from = 0; from < (n); from += ROWS) {                                                    \
            const size_t rows = (n)-from < ROWS ? (n)-from : ROWS;                                           \
            for (size_t i = from * (width); i < (from + rows) * (width); i++)                                \
                column[i - from * (width)] = (type)(expression);                                             \
            (void)orr_nc_put_rows(&f->w, rows, column, f->diag);                                             \
            eph_rest(e);                                                                                     \
        }                                                                                                    \
        free(column);                                                                                        \
    } while (0)

#define TIMES(n, expression, name, dim, long_name)                                                           \
    do {                                                                                                     \
        COLUMN(int64_t, n, 1, expression, var(f, name, ORR_NC_INT64, dim, TIME_UNITS, long_name));           \
        time_attributes(f, name);                                                                            \
    } while (0)
#define COUNTS(n, expression, name, dim, of, long_name)                                                      \
    do {                                                                                                     \
        COLUMN(int32_t, n, 1, expression, var(f, name, ORR_NC_INT32, dim, "1", long_name));                  \
        text(f, name, "sample_dimension", of);                                                               \
    } while (0)

static void put_satellites(file *f, const orr_ephemeris *e)
{
    char *names = scratch(f, e->n_sats, 3);
    if (names == NULL) return;
    for (size_t i = 0; i < e->n_sats; i++) {
        char name[ORR_SAT_TEXT];
        memcpy(&names[3 * i], orr_sat_text(e->sat_id[i], name), 3);
    }
    put_table(f, "satellite_name", ORR_NC_CHAR, "satellite", "name_length", names, NULL,
              "system letter and number as in SP3 and RINEX");
    free(names);
    COUNTS(e->n_sats, e->sat[i].n_arcs, "arc_count", "satellite", "arc", "number of arcs of the satellite");
    COUNTS(e->n_sats, e->sat[i].n_clocks, "clock_count", "satellite", "clock",
           "number of clock nodes of the satellite");
    COUNTS(e->n_sats, e->sat[i].n_nodes, "node_count", "satellite", "node",
           "number of input nodes of the satellite");
    COUNTS(e->n_sats, e->sat[i].n_events, "event_count", "satellite", "event",
           "number of events of the satellite");
    COLUMN(double, e->n_sats, 1, e->sat[i].node_noise_m,
           var(f, "node_noise", ORR_NC_DOUBLE, "satellite", "m",
               "standard deviation of a coordinate of the input nodes about the smooth orbit; 0: not known"));
}

static void put_arcs(file *f, const orr_ephemeris *e)
{
    const eph_arc *a = e->arc;
    TIMES(e->n_arcs, a[i].t0, "arc_start", "arc", "start of the arc");
    COLUMN(int64_t, e->n_arcs, 1, a[i].segment_ns,
           var(f, "segment_length", ORR_NC_INT64, "arc", "nanoseconds", "length of each segment of the arc"));
    COUNTS(e->n_arcs, a[i].n_segments, "segment_count", "arc", "segment", "number of segments of the arc");
    COUNTS(e->n_arcs, a[i].n_segments * a[i].samples_per_segment + 1, "sample_count", "arc", "sample",
           "number of samples of the arc, equally spaced, its two ends included");
    COLUMN(uint8_t, e->n_arcs, 1, a[i].degree,
           var(f, "degree", ORR_NC_UINT8, "arc", "1",
               "degree of the arc's series; coefficients above it are 0"));
}

// Row by row of the file's [segment][coefficient][coordinate], arcs one after the other.
static void put_coefficients(file *f, const orr_ephemeris *e, size_t n_coefficients)
{
    const char *dims[3] = {"segment", "coefficient", "coordinate"};
    (void)orr_nc_define_var(&f->w, "position_coefficient", ORR_NC_DOUBLE, 3, dims, "m",
                            "Chebyshev coefficients of the ecef position", f->diag);
    const size_t row = n_coefficients * 3;
    double *c = scratch(f, SEGMENTS, row * sizeof *c);
    if (c == NULL) return;
    for (size_t k = 0; k < e->n_arcs; k++) {
        const eph_arc *a = &e->arc[k];
        for (size_t from = 0; from < a->n_segments; from += SEGMENTS) {
            const size_t n = a->n_segments - from < SEGMENTS ? a->n_segments - from : SEGMENTS;
            memset(c, 0, n * row * sizeof *c);
            for (size_t g = 0; g < n; g++)
                for (size_t j = 0; j <= (size_t)a->degree; j++)
                    memcpy(&c[g * row + j * 3],
                           &e->coef[a->first_coef + (from + g) * eph_block(a->degree) + j * EPH_LANES],
                           3 * sizeof *c);
            (void)orr_nc_put_rows(&f->w, n, c, f->diag);
            eph_rest(e);
        }
    }
    free(c);
    text(f, "position_coefficient", "comment",
         "the coefficient of T_0 is not halved; coordinates are x, y, z");
}

static void put_samples(file *f, const orr_ephemeris *e)
{
    COLUMN(float, e->n_samples, 1, e->sigma[i][0],
           var(f, "position_sigma", ORR_NC_FLOAT, "sample", "m",
               "standard deviation of the position, three-dimensional"));
    text(f, "position_sigma", "comment", "relative to the orbit that the input has; linear between samples");
    COLUMN(
        float, e->n_samples, 3, e->sigma[i / 3][1 + i % 3],
        var_table(f, "position_sigma_axes", ORR_NC_FLOAT, "sample", "coordinate", "m",
                  "standard deviation of the position along the radial, along-track and cross-track axes"));
    COLUMN(float, e->n_samples, 1, e->sigma[i][4],
           var(f, "velocity_sigma", ORR_NC_FLOAT, "sample", "m s-1",
               "standard deviation of the velocity, three-dimensional"));
    COLUMN(uint16_t, e->n_samples, 1, e->sample_flags[i],
           var(f, "sample_flags", ORR_NC_UINT16, "sample", NULL, "what holds from this sample to the next"));
    flags_of(f, "sample_flags");
}

static void put_clocks(file *f, const orr_ephemeris *e)
{
    if (e->n_clocks == 0) return;
    TIMES(e->n_clocks, e->clock[i].t, "clock_time", "clock", "time of the clock node");
    COLUMN(double, e->n_clocks, 1, e->clock[i].clock_s,
           var(f, "clock_bias", ORR_NC_DOUBLE, "clock", "s", "satellite clock minus the product's time"));
    text(f, "clock_bias", "comment",
         "periodic relativity is not included: subtract 2 r.v / c^2 to get the clock that is seen");
    COLUMN(uint16_t, e->n_clocks, 1, e->clock[i].flags,
           var(f, "clock_flags", ORR_NC_UINT16, "clock", NULL, "flags of the clock node"));
    flags_of(f, "clock_flags");
    COLUMN(float, e->n_clocks, 1, e->clock[i].sigma_s,
           var(f, "clock_sigma", ORR_NC_FLOAT, "clock", "s",
               "standard deviation of a predicted clock node; 0 of an observed one"));
    COLUMN(double, e->n_sats, 1, e->sat[i].clock_noise.white_s2,
           var(f, "clock_white_noise", ORR_NC_DOUBLE, "satellite", "s2",
               "white noise of the satellite's clock"));
    COLUMN(double, e->n_sats, 1, e->sat[i].clock_noise.wfm_s2ps,
           var(f, "clock_walk_noise", ORR_NC_DOUBLE, "satellite", "s",
               "random walk of the satellite's clock (white frequency noise), s2 a second"));
    COLUMN(double, e->n_sats, 1, e->sat[i].clock_noise.rwfm_s2ps3,
           var(f, "clock_frequency_noise", ORR_NC_DOUBLE, "satellite", "s-1",
               "random walk of the clock's frequency, s2 a cubed second"));
}

static void put_clock_events(file *f, const orr_ephemeris *e)
{
    static const int64_t kinds[] = {ORR_CLOCK_EVENT_WRONG, ORR_CLOCK_EVENT_JUMP, ORR_CLOCK_EVENT_FLAG,
                                    ORR_CLOCK_EVENT_REFERENCE};
    const orr_clock_event *v = e->clock_events.item;
    const size_t n = e->clock_events.n;
    if (n == 0) return;
    COLUMN(uint8_t, n, 1, v[i].kind,
           var(f, "clock_event_kind", ORR_NC_UINT8, "clock_event", NULL, "kind of event of a clock"));
    (void)orr_nc_put_att_int64(&f->w, "clock_event_kind", "flag_values", kinds,
                               sizeof kinds / sizeof kinds[0], f->diag);
    text(f, "clock_event_kind", "flag_meanings", "wrong_value jump flagged reference");
    char *names = scratch(f, n, ORR_N_SYSTEMS + 1);
    if (names == NULL) return;
    for (size_t i = 0; i < n; i++) {
        char sat[ORR_SAT_TEXT];
        const char *who = v[i].sat != ORR_SAT_NONE ? orr_sat_text(v[i].sat, sat) : v[i].systems;
        memcpy(&names[i * (ORR_N_SYSTEMS + 1)], who, strlen(who));
    }
    put_table(f, "clock_event_of", ORR_NC_CHAR, "clock_event", "clock_event_of_length", names, NULL,
              "the satellite, or the letters of the systems all of whose clocks did it (kind reference)");
    free(names);
    TIMES(n, v[i].t0, "clock_event_start", "clock_event", "start of the event");
    TIMES(n, v[i].t1, "clock_event_end", "clock_event", "end of the event");
    COLUMN(double, n, 1, v[i].value_s,
           var(f, "clock_event_value", ORR_NC_DOUBLE, "clock_event", "s",
               "how far a wrong value was off, size of a jump, step or ramp"));
}

static void put_nodes(file *f, const orr_ephemeris *e)
{
    if (e->n_nodes == 0) return;
    TIMES(e->n_nodes, e->node[i].t, "node_time", "node", "time of the input node");
    COLUMN(double, e->n_nodes, 3, (&e->node[i / 3].residual_m.x)[i % 3],
           var_table(f, "node_residual", ORR_NC_DOUBLE, "node", "coordinate", "m",
                     "smoothed orbit minus input, ecef"));
    COLUMN(uint16_t, e->n_nodes, 1, e->node[i].source,
           var(f, "node_source", ORR_NC_UINT16, "node", "1", "index of the input file, from 0"));
    COLUMN(uint8_t, e->n_nodes, 1, e->node[i].used != 0,
           var(f, "node_used", ORR_NC_UINT8, "node", "1", "0: rejected or superseded; 1: used"));
}

static void put_events(file *f, const orr_ephemeris *e)
{
    static const int64_t kinds[] = {ORR_EVENT_MANOEUVRE,    ORR_EVENT_UMBRA,    ORR_EVENT_PENUMBRA,
                                    ORR_EVENT_OUTLIER,      ORR_EVENT_GAP,      ORR_EVENT_DAY_JUMP,
                                    ORR_EVENT_SHADOW_NOISE, ORR_EVENT_NOON_STEP};
    if (e->n_events == 0) return;
    COLUMN(uint8_t, e->n_events, 1, e->event[i].kind,
           var(f, "event_kind", ORR_NC_UINT8, "event", NULL, "kind of event"));
    (void)orr_nc_put_att_int64(&f->w, "event_kind", "flag_values", kinds, sizeof kinds / sizeof kinds[0],
                               f->diag);
    text(f, "event_kind", "flag_meanings",
         "manoeuvre umbra penumbra outlier gap day_jump shadow_noise noon_step");
    TIMES(e->n_events, e->event[i].t0, "event_start", "event", "start of the event");
    TIMES(e->n_events, e->event[i].t1, "event_end", "event", "end of the event");
    COLUMN(double, e->n_events, 1, e->event[i].value,
           var(f, "event_value", ORR_NC_DOUBLE, "event", NULL,
               "size of a rejected node's miss or of a jump at a day's joint, m; change of velocity at a "
               "manoeuvre or at noon, m/s; factor of the noise near the Earth's shadow; 0 for other kinds"));
}

static void put_sources(file *f, const orr_ephemeris *e)
{
    if (e->n_sources == 0) return;
    enum { NAME = sizeof e->source[0].name, SUM = sizeof e->source[0].sha256 };
    char *names = scratch(f, e->n_sources, NAME), *sums = scratch(f, e->n_sources, SUM);
    for (size_t i = 0; i < e->n_sources && names != NULL && sums != NULL; i++) {
        memcpy(&names[i * NAME], e->source[i].name, strnlen(e->source[i].name, NAME - 1));
        memcpy(&sums[i * SUM], e->source[i].sha256, strnlen(e->source[i].sha256, SUM - 1));
    }
    if (names != NULL && sums != NULL) {
        put_table(f, "source_name", ORR_NC_CHAR, "source", "source_name_length", names, NULL, "input file");
        put_table(f, "source_sha256", ORR_NC_CHAR, "source", "sha256_length", sums, NULL,
                  "SHA-256 of the input file");
    }
    free(names);
    free(sums);
}

static void put_rotation(file *f, const orr_ephemeris *e)
{
    const orr_earth_rotation *r = &e->rotation;
    const orr_eop_series *eop = &r->series;
    text(f, NULL, "earth_rotation_source", orr_rotation_source_name(r->source));
    if (eop->n == 0) return;
    if (r->source == ORR_ROTATION_ESTIMATED) {
        number(f, "earth_rotation_pole_sigma_arcsec", r->pole_sigma_rad * ORR_DEG_PER_RAD * 3600);
        number(f, "earth_rotation_lod_sigma_s", r->lod_sigma_s);
        text(f, NULL, "earth_rotation_comment",
             "estimated together with the orbits, which tell the pole, its rates and the length of day; UT1 "
             "itself "
             "starts from the leap seconds. Sigmas are formal, of the middle of the span. Zonal tides are in "
             "UT1, the ocean's daily and half-daily tides are not in the pole and UT1");
    }
    put(f, "earth_rotation_mjd", ORR_NC_DOUBLE, "earth_rotation", eop->mjd_utc,
        "days since 1858-11-17 00:00:00", "time of the Earth's rotation, UTC");
    COLUMN(double, eop->n, 1, eop->value[i].xp_rad,
           var(f, "pole_x", ORR_NC_DOUBLE, "earth_rotation", "radian", "x coordinate of the pole"));
    COLUMN(double, eop->n, 1, eop->value[i].yp_rad,
           var(f, "pole_y", ORR_NC_DOUBLE, "earth_rotation", "radian", "y coordinate of the pole"));
    COLUMN(double, eop->n, 1, eop->value[i].ut1_utc_s,
           var(f, "ut1_minus_utc", ORR_NC_DOUBLE, "earth_rotation", "s", "UT1 minus UTC"));
}

static void put_dimensions(file *f, const orr_ephemeris *e, size_t n_coefficients)
{
    const struct {
        const char *name;
        size_t n;
    } dims[] = {{"satellite", e->n_sats},
                {"name_length", 3},
                {"arc", e->n_arcs},
                {"segment", e->n_segments},
                {"coefficient", n_coefficients},
                {"coordinate", 3},
                {"sample", e->n_samples},
                {"clock", e->n_clocks},
                {"node", e->n_nodes},
                {"event", e->n_events},
                {"earth_rotation", e->rotation.series.n},
                {"source", e->n_sources},
                {"clock_event", e->clock_events.n},
                {"clock_event_of_length", e->clock_events.n > 0 ? ORR_N_SYSTEMS + 1 : 0},
                {"source_name_length", e->n_sources > 0 ? sizeof e->source[0].name : 0},
                {"sha256_length", e->n_sources > 0 ? sizeof e->source[0].sha256 : 0}};
    // NetCDF has no empty dimensions: what a product has none of is left out.
    for (size_t i = 0; i < sizeof dims / sizeof dims[0]; i++)
        if (dims[i].n > 0) (void)orr_nc_put_dim(&f->w, dims[i].name, dims[i].n, f->diag);
}

orr_status orr_ephemeris_save(const orr_ephemeris *e, const char *path, const char *history, orr_diag *diag)
{
    file f = {.diag = diag};
    orr_status s = orr_nc_create(path, &f.w, diag);
    if (s != ORR_OK) return s;
    size_t n_coefficients = 0;
    for (size_t i = 0; i < e->n_arcs; i++)
        if ((size_t)e->arc[i].degree + 1 > n_coefficients) n_coefficients = (size_t)e->arc[i].degree + 1;
    put_global(&f, e, history);
    put_dimensions(&f, e, n_coefficients);
    put_satellites(&f, e);
    put_arcs(&f, e);
    put_coefficients(&f, e, n_coefficients);
    put_samples(&f, e);
    put_clocks(&f, e);
    put_clock_events(&f, e);
    put_nodes(&f, e);
    put_events(&f, e);
    put_rotation(&f, e);
    put_sources(&f, e);
    return orr_nc_commit(&f.w, diag);
}

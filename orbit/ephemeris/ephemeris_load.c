// SPDX-License-Identifier: GPL-3.0-or-later
// The product back from its file, every field validated: every count is checked against the dimensions, the
// dimensions against what the file's bytes could hold at all, every number against its range.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "orbit/ephemeris/ephemeris_load_private.h"

enum { DEFLATE_MOST = 1032 }; // the most that a byte of deflate can stand for (RFC 1951: 258 bytes in 2 bits)

// Lengths of the dimensions into the counts. What a product has none of has no dimension.
static orr_status read_dimensions(eph_file *f, orr_ephemeris *c)
{
    const struct {
        const char *name, *var; // the variable by which its presence is known
        size_t *n, max;
    } dims[] = {{"satellite", NULL, &c->n_sats, EPH_MAX_SATS},
                {"arc", NULL, &c->n_arcs, f->max_bytes / 8},
                {"segment", NULL, &c->n_segments, f->max_bytes / 8},
                {"coefficient", NULL, &f->n_coefficients, EPH_MAX_DEGREE + 1},
                {"sample", NULL, &c->n_samples, f->max_bytes / 4},
                {"clock", "clock_time", &c->n_clocks, f->max_bytes / 8},
                {"node", "node_time", &c->n_nodes, f->max_bytes / 8},
                {"event", "event_kind", &c->n_events, f->max_bytes / 8},
                {"source", "source_name", &c->n_sources, UINT16_MAX + 1}};
    for (size_t i = 0; i < sizeof dims / sizeof dims[0]; i++) {
        if (dims[i].var != NULL && !orr_nc_has_var(&f->r, dims[i].var)) continue;
        orr_status s = orr_nc_get_dim(&f->r, dims[i].name, dims[i].max, dims[i].n, f->diag);
        if (s != ORR_OK) return s;
    }
    if (f->n_coefficients < 2 || c->n_sats < 1 || c->n_arcs < 1) return eph_wrong(f, "holds no orbit");
    if (c->n_segments > f->max_bytes / (f->n_coefficients * 3 * sizeof(double)))
        return eph_wrong(f, "claims more segments than its bytes can hold");
    return ORR_OK;
}

static orr_status read_satellites(const eph_file *f, orr_ephemeris *e)
{
    char *names = NULL;
    size_t shape[2] = {e->n_sats, 3};
    orr_status s = orr_nc_alloc_var(&f->r, "satellite_name", ORR_NC_CHAR, 2, shape, (void **)&names, f->diag);
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++) {
        e->sat_id[i] = orr_sat_parse3(&names[3 * i], 0);
        if (e->sat_id[i] == ORR_SAT_NONE || (i > 0 && e->sat_id[i] <= e->sat_id[i - 1]))
            s = eph_wrong(f, "satellite names are not ascending names of satellites");
    }
    free(names);
    return s;
}

// Counts, one a satellite (or arc), that must add up to a dimension's length.
static orr_status read_counts(const eph_file *f, const char *name, size_t n, size_t total, int32_t **out)
{
    orr_status s = eph_read_column(f, name, ORR_NC_INT32, n, (void **)out);
    if (s != ORR_OK) return s;
    size_t left = total;
    for (size_t i = 0; i < n; i++) {
        if ((*out)[i] < 0 || (size_t)(*out)[i] > left) {
            left = SIZE_MAX;
            break;
        }
        left -= (size_t)(*out)[i];
    }
    if (left == 0) return ORR_OK;
    free(*out);
    *out = NULL;
    return orr_diag_at(f->diag, ORR_E_FORMAT, f->r.path, 0, 0, "%s does not add up to the %zu that there are",
                       name, total);
}

static orr_status read_satellite_counts(const eph_file *f, orr_ephemeris *e)
{
    static const char *const name[4] = {"arc_count", "clock_count", "node_count", "event_count"};
    const size_t total[4] = {e->n_arcs, e->n_clocks, e->n_nodes, e->n_events};
    int32_t *count[4] = {0};
    orr_status s = ORR_OK;
    for (int k = 0; k < 4 && s == ORR_OK; k++) s = read_counts(f, name[k], e->n_sats, total[k], &count[k]);
    size_t at[4] = {0};
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++) {
        e->sat[i] = (eph_sat){.n_arcs = (size_t)count[0][i],
                              .n_clocks = (size_t)count[1][i],
                              .n_nodes = (size_t)count[2][i],
                              .n_events = (size_t)count[3][i],
                              .arc = &e->arc[at[0]],
                              .clock = &e->clock[at[1]],
                              .node = &e->node[at[2]],
                              .event = &e->event[at[3]]};
        for (int k = 0; k < 4; k++) at[k] += (size_t)count[k][i];
    }
    for (int k = 0; k < 4; k++) free(count[k]);
    if (s != ORR_OK || !orr_nc_has_var(&f->r, "node_noise")) return s; // of an earlier program
    double *noise = NULL;
    s = eph_read_column(f, "node_noise", ORR_NC_DOUBLE, e->n_sats, (void **)&noise);
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++) {
        if (!(noise[i] >= 0 && noise[i] < 1e12))
            s = eph_wrong(f, "the noise of a satellite's nodes is no number");
        e->sat[i].node_noise_m = noise[i];
    }
    free(noise);
    return s;
}

static orr_status check_arc(const eph_file *f, eph_arc *a, int64_t samples)
{
    int64_t n = (int64_t)a->n_segments;
    if (a->t0 < -EPH_TIME_LIMIT || a->t0 > EPH_TIME_LIMIT || a->segment_ns < 1 || n < 1 ||
        n > EPH_TIME_LIMIT / a->segment_ns || a->t0 > EPH_TIME_LIMIT - n * a->segment_ns)
        return eph_wrong(f, "an arc's start, segment length or number of segments is impossible");
    if ((samples - 1) % n != 0 || (samples - 1) / n < 1 || (samples - 1) / n > EPH_MAX_SAMPLES_PER_SEGMENT ||
        a->segment_ns % ((samples - 1) / n) != 0)
        return eph_wrong(f, "an arc's samples do not fill its segments");
    if (a->degree < 1 || (size_t)a->degree >= f->n_coefficients)
        return eph_wrong(f, "an arc's degree is impossible");
    a->samples_per_segment = (size_t)((samples - 1) / n);
    a->t1 = a->t0 + n * a->segment_ns;
    return ORR_OK;
}

static orr_status read_arcs(const eph_file *f, orr_ephemeris *e)
{
    int64_t *start = NULL, *length = NULL;
    uint8_t *degree = NULL;
    int32_t *segments = NULL, *samples = NULL;
    orr_status s = eph_read_column(f, "arc_start", ORR_NC_INT64, e->n_arcs, (void **)&start);
    if (s == ORR_OK) s = eph_read_column(f, "segment_length", ORR_NC_INT64, e->n_arcs, (void **)&length);
    if (s == ORR_OK) s = eph_read_column(f, "degree", ORR_NC_UINT8, e->n_arcs, (void **)&degree);
    if (s == ORR_OK) s = read_counts(f, "segment_count", e->n_arcs, e->n_segments, &segments);
    if (s == ORR_OK) s = read_counts(f, "sample_count", e->n_arcs, e->n_samples, &samples);
    size_t segment = 0, sample = 0, coef = 0;
    for (size_t i = 0; i < e->n_arcs && s == ORR_OK; i++) {
        eph_arc *a = &e->arc[i];
        *a = (eph_arc){.t0 = start[i],
                       .segment_ns = length[i],
                       .degree = degree[i],
                       .n_segments = (size_t)segments[i],
                       .first_segment = segment,
                       .first_sample = sample,
                       .first_coef = coef};
        s = check_arc(f, a, samples[i]);
        segment += (size_t)segments[i];
        sample += (size_t)samples[i];
        coef += (size_t)segments[i] * eph_block(a->degree);
    }
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++)
        for (size_t k = 1; k < e->sat[i].n_arcs && s == ORR_OK; k++)
            if (e->sat[i].arc[k].t0 < e->sat[i].arc[k - 1].t1)
                s = eph_wrong(f, "arcs of a satellite overlap");
    free(start);
    free(length);
    free(degree);
    free(segments);
    free(samples);
    return s;
}

static orr_status read_coefficients(const eph_file *f, orr_ephemeris *e)
{
    double *c = NULL;
    size_t shape[3] = {e->n_segments, f->n_coefficients, 3};
    orr_status s =
        orr_nc_alloc_var(&f->r, "position_coefficient", ORR_NC_DOUBLE, 3, shape, (void **)&c, f->diag);
    for (size_t k = 0; k < e->n_arcs && s == ORR_OK; k++) {
        const eph_arc *a = &e->arc[k];
        for (size_t g = 0; g < a->n_segments; g++) {
            for (size_t j = 0; j <= (size_t)a->degree; j++) {
                const double *from = &c[((a->first_segment + g) * f->n_coefficients + j) * 3];
                if (!(fabs(from[0]) < 1e12 && fabs(from[1]) < 1e12 &&
                      fabs(from[2]) < 1e12)) // no place in the Earth's realm
                    s = eph_wrong(f, "a coefficient is no number or impossibly large");
                memcpy(&e->coef[a->first_coef + g * eph_block(a->degree) + j * EPH_LANES], from,
                       3 * sizeof *from);
            }
        }
    }
    free(c);
    return s;
}

// Columns of sigmas: `width` of each sample into sigma[][at ..]. Products of earlier programs have position_sigma alone; the
// others are not known then.
static orr_status read_sigma(const eph_file *f, const char *name, size_t width, size_t at, orr_ephemeris *e)
{
    const size_t shape[2] = {e->n_samples, width};
    float *column = NULL;
    if (at > 0 && !orr_nc_has_var(&f->r, name)) {
        for (size_t i = 0; i < e->n_samples; i++)
            for (size_t k = 0; k < width; k++) e->sigma[i][at + k] = NAN;
        return ORR_OK;
    }
    orr_status s =
        orr_nc_alloc_var(&f->r, name, ORR_NC_FLOAT, width > 1 ? 2 : 1, shape, (void **)&column, f->diag);
    for (size_t i = 0; i < e->n_samples * width && s == ORR_OK; i++) {
        if (!(column[i] >= 0) || isinf(column[i])) s = eph_wrong(f, "a sigma is negative or no number");
        e->sigma[i / width][at + i % width] = column[i];
    }
    free(column);
    return s;
}

static orr_status read_samples(const eph_file *f, orr_ephemeris *e)
{
    uint16_t *flags = NULL;
    orr_status s = read_sigma(f, "position_sigma", 1, 0, e);
    if (s == ORR_OK) s = read_sigma(f, "position_sigma_axes", 3, 1, e);
    if (s == ORR_OK) s = read_sigma(f, "velocity_sigma", 1, 4, e);
    if (s == ORR_OK) s = eph_read_column(f, "sample_flags", ORR_NC_UINT16, e->n_samples, (void **)&flags);
    for (size_t i = 0; i < e->n_samples && s == ORR_OK; i++) e->sample_flags[i] = flags[i] & EPH_STATE_FLAGS;
    free(flags);
    return s;
}

static orr_status read_nodes(const eph_file *f, orr_ephemeris *e)
{
    int64_t *t = NULL;
    double *residual = NULL;
    uint16_t *source = NULL;
    uint8_t *used = NULL;
    size_t n = e->n_nodes, shape[2] = {n, 3};
    if (n == 0) return ORR_OK;
    orr_status s = eph_read_column(f, "node_time", ORR_NC_INT64, n, (void **)&t);
    if (s == ORR_OK)
        s = orr_nc_alloc_var(&f->r, "node_residual", ORR_NC_DOUBLE, 2, shape, (void **)&residual, f->diag);
    if (s == ORR_OK) s = eph_read_column(f, "node_source", ORR_NC_UINT16, n, (void **)&source);
    if (s == ORR_OK) s = eph_read_column(f, "node_used", ORR_NC_UINT8, n, (void **)&used);
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        const double *d = &residual[3 * i];
        e->node[i] = (orr_orbit_node){t[i], {d[0], d[1], d[2]}, source[i], used[i] != 0};
        if (t[i] < -EPH_TIME_LIMIT || t[i] > EPH_TIME_LIMIT || source[i] >= e->n_sources)
            s = eph_wrong(f, "an input node has an impossible time or source");
    }
    for (size_t i = 0; i < e->n_sats && s == ORR_OK; i++)
        for (size_t k = 1; k < e->sat[i].n_nodes && s == ORR_OK; k++)
            if (e->sat[i].node[k].t < e->sat[i].node[k - 1].t)
                s = eph_wrong(f, "input nodes do not ascend in time");
    free(t);
    free(residual);
    free(source);
    free(used);
    return s;
}

static orr_status read_events(const eph_file *f, orr_ephemeris *e)
{
    uint8_t *kind = NULL;
    int64_t *t0 = NULL, *t1 = NULL;
    double *value = NULL;
    size_t n = e->n_events;
    if (n == 0) return ORR_OK;
    orr_status s = eph_read_column(f, "event_kind", ORR_NC_UINT8, n, (void **)&kind);
    if (s == ORR_OK) s = eph_read_column(f, "event_start", ORR_NC_INT64, n, (void **)&t0);
    if (s == ORR_OK) s = eph_read_column(f, "event_end", ORR_NC_INT64, n, (void **)&t1);
    if (s == ORR_OK) s = eph_read_column(f, "event_value", ORR_NC_DOUBLE, n, (void **)&value);
    for (size_t i = 0; i < n && s == ORR_OK; i++) {
        e->event[i] = (orr_orbit_event){(orr_event_kind)kind[i], t0[i], t1[i], value[i]};
        if (kind[i] < ORR_EVENT_MANOEUVRE || kind[i] > ORR_EVENT_NOON_STEP || t0[i] < -EPH_TIME_LIMIT ||
            t1[i] > EPH_TIME_LIMIT || t0[i] > t1[i])
            s = eph_wrong(f, "an event has an unknown kind or impossible times");
    }
    free(kind);
    free(t0);
    free(t1);
    free(value);
    return s;
}

static orr_status read_sources(const eph_file *f, orr_ephemeris *e)
{
    enum { NAME = sizeof e->source[0].name, SUM = sizeof e->source[0].sha256 };
    char *names = NULL, *sums = NULL;
    size_t shape[2] = {e->n_sources, NAME};
    if (e->n_sources == 0) return ORR_OK;
    orr_status s = orr_nc_alloc_var(&f->r, "source_name", ORR_NC_CHAR, 2, shape, (void **)&names, f->diag);
    shape[1] = SUM;
    if (s == ORR_OK)
        s = orr_nc_alloc_var(&f->r, "source_sha256", ORR_NC_CHAR, 2, shape, (void **)&sums, f->diag);
    for (size_t i = 0; i < e->n_sources && s == ORR_OK; i++) {
        memcpy(e->source[i].name, &names[i * NAME], NAME - 1);
        memcpy(e->source[i].sha256, &sums[i * SUM], SUM - 1);
    }
    free(names);
    free(sums);
    return s;
}

// Text that may be missing or longer than what is kept of it; neither matters to the orbit.
static orr_status read_text(const eph_file *f, const char *name, char *buf, size_t n)
{
    orr_status s = orr_nc_get_att_text(&f->r, NULL, name, buf, n, f->diag);
    if (s == ORR_E_NODATA) buf[0] = '\0';
    return s == ORR_E_NODATA ? ORR_OK : s;
}

static orr_status read_number(const eph_file *f, const char *name, double *v)
{
    orr_status s = orr_nc_get_att_double(&f->r, NULL, name, v, f->diag);
    if (s == ORR_OK && isfinite(*v) && *v >= 0) return ORR_OK;
    if (s != ORR_OK && s != ORR_E_NODATA) return s;
    return orr_diag_at(f->diag, ORR_E_FORMAT, f->r.path, 0, 0,
                       "attribute \"%s\" is missing or no sensible number", name);
}

static orr_status check_kind(const eph_file *f)
{
    char product[64];
    int64_t version = 0;
    orr_status s = orr_nc_get_att_text(&f->r, NULL, "product", product, sizeof product, NULL);
    if (s != ORR_OK || strcmp(product, EPH_PRODUCT) != 0)
        return orr_diag_at(f->diag, ORR_E_KIND, f->r.path, 0, 0,
                           "is a NetCDF file, but no orbit product (make one with 'orrery orbit')");
    s = orr_nc_get_att_int64(&f->r, NULL, "product_version", &version, NULL);
    if (s != ORR_OK || version < 1 || version > EPH_FORMAT_VERSION)
        return orr_diag_at(
            f->diag, ORR_E_UNSUPPORTED, f->r.path, 0, 0,
            "is an orbit product of version %lld%s; this program reads versions 1 to %d", (long long)version,
            version > EPH_FORMAT_VERSION ? ", which a newer program has made" : "", EPH_FORMAT_VERSION);
    return ORR_OK;
}

static orr_status read_header(const eph_file *f, orr_ephemeris *e)
{
    orr_status s = read_text(f, "options", e->options, sizeof e->options);
    if (s == ORR_OK) s = read_text(f, "reference_frame", e->frame, sizeof e->frame);
    if (s == ORR_OK) s = read_number(f, "node_step_s", &e->node_step_s);
    if (s == ORR_OK) s = read_number(f, "clock_max_gap_s", &e->clock_max_gap_s);
    if (s == ORR_OK) s = read_number(f, "max_position_error_m", &e->max_pos_error_m);
    if (s == ORR_OK) s = read_number(f, "max_velocity_error_mps", &e->max_vel_error_mps);
    return s;
}

static orr_status read_all(eph_file *f, orr_ephemeris **out)
{
    orr_ephemeris counts = {0}, *e = NULL;
    orr_status s = check_kind(f);
    if (s == ORR_OK) s = read_dimensions(f, &counts);
    // The rows in memory follow from arcs that are not read yet: room for the most they can be.
    counts.n_coefs = counts.n_segments * eph_block((int)f->n_coefficients - 1);
    if (s == ORR_OK) s = eph_alloc(&counts, &e, f->diag);
    if (s == ORR_OK) s = read_header(f, e);
    if (s == ORR_OK) s = read_satellites(f, e);
    if (s == ORR_OK) s = read_satellite_counts(f, e);
    if (s == ORR_OK) s = read_arcs(f, e);
    if (s == ORR_OK) s = read_coefficients(f, e);
    if (s == ORR_OK) s = read_samples(f, e);
    if (s == ORR_OK) s = read_sources(f, e);
    if (s == ORR_OK) s = eph_load_clocks(f, e);
    if (s == ORR_OK) s = read_nodes(f, e);
    if (s == ORR_OK) s = read_events(f, e);
    if (s == ORR_OK) s = eph_load_rotation(f, &e->rotation);
    if (s == ORR_OK) s = eph_finish(e, f->diag);
    if (s != ORR_OK) {
        orr_ephemeris_free(e);
        return s;
    }
    *out = e;
    return ORR_OK;
}

orr_status orr_ephemeris_load(const char *path, orr_ephemeris **out, orr_diag *diag)
{
    eph_file f = {.diag = diag};
    *out = NULL;
    orr_status s = orr_nc_open(path, &f.r, diag);
    if (s != ORR_OK) return s;
    struct stat st;
    f.max_bytes = stat(path, &st) == 0 && st.st_size > 0 ? (size_t)st.st_size * DEFLATE_MOST : 0;
    s = read_all(&f, out);
    orr_nc_close(&f.r);
    return s;
}
